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

struct type_61 {
    member: array<lt_bvh_Instance>,
}

struct type_65 {
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
var<uniform> p: type_65;
@group(0) @binding(1) 
var<storage> nodes: type_35;
@group(0) @binding(2) 
var<storage> triangles: type_39;
@group(0) @binding(5) 
var<storage, read_write> samples: type_9;
@group(0) @binding(6) 
var<storage> instances: type_61;
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

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var local_2: lt_bvh_traverse_Stack;
    var phi_801_: bool;
    var phi_802_: bool;
    var phi_803_: bool;
    var phi_807_: bool;
    var phi_808_: bool;
    var phi_809_: bool;
    var phi_810_: bool;
    var phi_811_: bool;
    var phi_812_: bool;
    var phi_813_: bool;
    var phi_814_: bool;
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
    var phi_828_: bool;
    var phi_832_: bool;
    var phi_907_: f32;
    var phi_914_: f32;
    var phi_922_: f32;
    var phi_929_: f32;
    var phi_937_: f32;
    var phi_944_: f32;
    var phi_969_: f32;
    var phi_974_: f32;
    var phi_979_: f32;
    var phi_1001_: u32;
    var phi_1006_: u32;
    var phi_1011_: u32;
    var phi_1125_: bool;
    var phi_1126_: bool;
    var phi_1157_: u32;
    var phi_1159_: u32;
    var phi_1162_: lt_bvh_Hit;
    var phi_1247_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1274_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1301_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1307_: u32;
    var phi_1310_: u32;
    var phi_1324_: u32;
    var phi_1334_: u32;
    var phi_1344_: u32;
    var phi_1362_: u32;
    var phi_1372_: u32;
    var phi_1382_: u32;
    var phi_1418_: u32;
    var phi_1431_: u32;
    var phi_1436_: u32;
    var phi_1437_: u32;
    var phi_1438_: u32;
    var phi_1308_: u32;
    var phi_1311_: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_1496_: u32;
    var phi_1499_: lt_bvh_Hit;
    var phi_1554_: f32;
    var phi_1559_: f32;
    var phi_1564_: f32;
    var phi_1572_: f32;
    var phi_1577_: f32;
    var phi_1582_: f32;
    var phi_1738_: bool;
    var phi_1739_: bool;
    var phi_1740_: bool;
    var phi_1744_: bool;
    var phi_1745_: bool;
    var phi_1746_: bool;
    var phi_1747_: bool;
    var phi_1748_: bool;
    var phi_1749_: bool;
    var phi_1750_: bool;
    var phi_1751_: bool;
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
    var phi_1765_: bool;
    var phi_1769_: bool;
    var phi_1839_: f32;
    var phi_1846_: f32;
    var phi_1853_: f32;
    var phi_1860_: f32;
    var phi_1867_: f32;
    var phi_1874_: f32;
    var phi_1891_: f32;
    var phi_1896_: f32;
    var phi_1901_: f32;
    var phi_1929_: bool;
    var phi_1930_: bool;
    var phi_1938_: u32;
    var phi_1939_: u32;
    var phi_1950_: vec3<f32>;
    var phi_1951_: vec3<f32>;
    var phi_1964_: u32;
    var phi_1969_: u32;
    var phi_1974_: u32;
    var phi_2088_: bool;
    var phi_2089_: bool;
    var phi_2120_: u32;
    var phi_2122_: lt_bvh_Hit;
    var phi_2125_: u32;
    var phi_2206_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2233_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2260_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2266_: u32;
    var phi_2269_: u32;
    var phi_2283_: u32;
    var phi_2293_: u32;
    var phi_2303_: u32;
    var phi_2321_: u32;
    var phi_2331_: u32;
    var phi_2341_: u32;
    var phi_2377_: u32;
    var phi_2390_: u32;
    var phi_2395_: u32;
    var phi_2396_: u32;
    var phi_2397_: u32;
    var phi_2267_: u32;
    var phi_2270_: u32;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_2455_: lt_bvh_Hit;
    var phi_2458_: u32;
    var phi_2502_: vec3<f32>;
    var phi_2503_: vec3<f32>;
    var phi_2532_: vec3<f32>;
    var phi_2533_: vec3<f32>;
    var phi_2562_: vec3<f32>;
    var phi_2563_: vec3<f32>;
    var phi_2581_: bool;
    var phi_2582_: bool;
    var phi_2586_: f32;
    var phi_2587_: f32;
    var phi_2588_: f32;
    var phi_2589_: f32;
    var phi_2597_: f32;
    var phi_2607_: bool;
    var phi_2608_: bool;
    var phi_2612_: f32;
    var phi_2613_: f32;
    var phi_2614_: f32;
    var phi_2615_: f32;
    var phi_2623_: f32;
    var phi_2633_: bool;
    var phi_2634_: bool;
    var phi_2638_: f32;
    var phi_2639_: f32;
    var phi_2640_: f32;
    var phi_2641_: f32;
    var phi_2649_: f32;
    var phi_2664_: f32;
    var phi_2665_: bool;
    var phi_2666_: f32;
    var phi_2667_: bool;
    var phi_2668_: f32;
    var phi_2669_: bool;
    var phi_2687_: f32;
    var phi_2688_: bool;
    var phi_2689_: bool;
    var phi_2690_: f32;
    var phi_2691_: bool;
    var phi_2692_: bool;
    var phi_2696_: bool;
    var phi_2697_: f32;
    var phi_2698_: bool;
    var phi_2726_: vec3<f32>;
    var phi_2727_: vec3<f32>;
    var phi_2752_: vec3<f32>;
    var phi_2753_: vec3<f32>;
    var phi_2778_: vec3<f32>;
    var phi_2779_: vec3<f32>;
    var phi_2835_: f32;
    var phi_2844_: f32;
    var phi_2853_: f32;
    var phi_2862_: f32;
    var phi_2869_: f32;
    var phi_2876_: f32;
    var phi_2889_: f32;
    var phi_2898_: f32;
    var phi_2907_: f32;
    var phi_2916_: f32;
    var phi_2923_: f32;
    var phi_2930_: f32;
    var phi_2947_: f32;
    var phi_2952_: f32;
    var phi_2957_: f32;
    var phi_2965_: f32;
    var phi_2970_: f32;
    var phi_2975_: f32;
    var phi_2987_: f32;
    var phi_2992_: f32;
    var phi_2997_: f32;
    var phi_3002_: f32;
    var phi_3007_: lt_bvh_triangle_Intersection;
    var phi_3008_: bool;
    var phi_3009_: lt_bvh_triangle_Intersection;
    var phi_3010_: bool;
    var phi_3014_: lt_bvh_triangle_Intersection;
    var phi_3015_: bool;
    var phi_3016_: lt_bvh_triangle_Intersection;
    var phi_3017_: bool;
    var phi_3018_: bool;
    var phi_3022_: bool;
    var phi_3026_: lt_bvh_triangle_Intersection;
    var phi_3064_: bool;
    var phi_3065_: bool;
    var phi_3066_: bool;
    var phi_3067_: bool;
    var phi_3068_: bool;
    var phi_3069_: bool;
    var phi_3073_: bool;
    var phi_3074_: bool;
    var phi_3088_: bool;
    var phi_3096_: lt_bvh_Hit;
    var phi_3097_: lt_bvh_Hit;
    var phi_3098_: lt_bvh_Hit;
    var phi_3099_: lt_bvh_Hit;
    var phi_2456_: lt_bvh_Hit;
    var phi_2459_: u32;
    var phi_3100_: bool;
    var phi_3139_: bool;
    var phi_3140_: bool;
    var phi_3171_: u32;
    var phi_2123_: lt_bvh_Hit;
    var phi_2126_: u32;
    var phi_3172_: lt_bvh_Hit;
    var phi_3173_: lt_bvh_Hit;
    var phi_3174_: bool;
    var phi_3178_: lt_bvh_Hit;
    var phi_3179_: lt_bvh_Hit;
    var phi_3180_: lt_bvh_Hit;
    var phi_3181_: lt_bvh_Hit;
    var phi_1497_: u32;
    var phi_1500_: lt_bvh_Hit;
    var phi_3182_: bool;
    var phi_3221_: bool;
    var phi_3222_: bool;
    var phi_3253_: u32;
    var phi_1160_: u32;
    var phi_1163_: lt_bvh_Hit;
    var phi_3254_: lt_bvh_Hit;
    var phi_3255_: lt_bvh_Hit;
    var phi_3256_: bool;
    var phi_3260_: lt_bvh_Hit;
    var phi_3447_: f32;
    var phi_3452_: f32;
    var phi_3457_: f32;
    var phi_3465_: f32;
    var phi_3470_: f32;
    var phi_3475_: f32;
    var phi_3539_: vec3<f32>;
    var phi_3782_: vec3<f32>;
    var phi_3797_: u32;
    var phi_3824_: f32;
    var phi_3831_: f32;
    var phi_3838_: f32;
    var phi_3873_: f32;
    var phi_3880_: f32;
    var phi_3887_: f32;
    var phi_3925_: f32;
    var phi_3932_: f32;
    var phi_3939_: f32;
    var phi_4025_: vec3<f32>;
    var phi_4026_: vec3<f32>;
    var phi_4027_: vec3<f32>;
    var phi_4036_: f32;
    var phi_4037_: f32;
    var phi_4047_: f32;
    var phi_4048_: f32;
    var phi_4058_: f32;
    var phi_4059_: f32;
    var phi_4094_: abi_Sample;
    var phi_4317_: vec3<f32>;
    var local_9: lt_bvh_Hit;
    var local_10: lt_bvh_Hit;
    var local_11: lt_bvh_Hit;
    var local_12: lt_bvh_Hit;

    let _e74 = id_1;
    let _e78 = arrayLength((&nodes.member));
    let _e81 = arrayLength((&triangles.member));
    let _e84 = arrayLength((&vertices.member));
    let _e93 = arrayLength((&instances.member));
    let _e96 = arrayLength((&color_texels.member));
    let _e99 = arrayLength((&before.member));
    let _e105 = p.member.size[0u];
    let _e107 = p.member.size[1u];
    let _e108 = lt_shaders_entry_pixel_index(_e74, _e105, _e107);
    if (bitcast<i32>(_e108.word) != 0i) {
        let _e114 = p.member.root;
        let _e118 = p.member.eye;
        let _e123 = p.member.size[0u];
        let _e127 = ((((f32(_e74.x) + 0.5f) / f32(_e123)) * 2f) - 1f);
        let _e132 = p.member.size[1u];
        let _e136 = (1f - (((f32(_e74.y) + 0.5f) / f32(_e132)) * 2f));
        let _e138 = p.member.forward;
        let _e140 = p.member.right;
        let _e154 = p.member.up;
        let _e165 = _lt_bvh_ray_Ray_new(_e118, vec3<f32>(((_e138.x + (_e140.x * _e127)) + (_e154.x * _e136)), ((_e138.y + (_e140.y * _e127)) + (_e154.y * _e136)), ((_e138.z + (_e140.z * _e127)) + (_e154.z * _e136))));
        let _e167 = lt_bvh_Hit(_e165.tmax, 0f, 0f, 4294967295u, 4294967295u);
        let _e177 = abs(_e165.direction.x);
        let _e179 = abs(_e165.direction.y);
        let _e181 = abs(_e165.direction.z);
        if (abs(_e165.origin.x) < 1000000000000000f) {
            if (abs(_e165.origin.y) < 1000000000000000f) {
                if (abs(_e165.origin.z) < 1000000000000000f) {
                    if (_e177 < 1000000000000000f) {
                        if (_e179 < 1000000000000000f) {
                            if (_e181 < 1000000000000000f) {
                                if (_e177 > 0f) {
                                    phi_802_ = bool();
                                    phi_803_ = true;
                                } else {
                                    let _e189 = (_e179 > 0f);
                                    if _e189 {
                                        phi_801_ = bool();
                                    } else {
                                        phi_801_ = (_e181 > 0f);
                                    }
                                    let _e192 = phi_801_;
                                    phi_802_ = _e192;
                                    phi_803_ = _e189;
                                }
                                let _e194 = phi_802_;
                                let _e196 = phi_803_;
                                if _e196 {
                                    phi_807_ = true;
                                } else {
                                    phi_807_ = _e194;
                                }
                                let _e198 = phi_807_;
                                phi_808_ = _e198;
                                phi_809_ = false;
                            } else {
                                phi_808_ = bool();
                                phi_809_ = true;
                            }
                            let _e200 = phi_808_;
                            let _e202 = phi_809_;
                            phi_810_ = _e200;
                            phi_811_ = false;
                            phi_812_ = _e202;
                        } else {
                            phi_810_ = bool();
                            phi_811_ = true;
                            phi_812_ = false;
                        }
                        let _e204 = phi_810_;
                        let _e206 = phi_811_;
                        let _e208 = phi_812_;
                        phi_813_ = _e204;
                        phi_814_ = _e206;
                        phi_815_ = _e208;
                    } else {
                        phi_813_ = bool();
                        phi_814_ = true;
                        phi_815_ = false;
                    }
                    let _e210 = phi_813_;
                    let _e212 = phi_814_;
                    let _e214 = phi_815_;
                    phi_816_ = _e210;
                    phi_817_ = _e212;
                    phi_818_ = _e214;
                } else {
                    phi_816_ = bool();
                    phi_817_ = true;
                    phi_818_ = false;
                }
                let _e216 = phi_816_;
                let _e218 = phi_817_;
                let _e220 = phi_818_;
                phi_819_ = _e216;
                phi_820_ = _e218;
                phi_821_ = _e220;
            } else {
                phi_819_ = bool();
                phi_820_ = true;
                phi_821_ = false;
            }
            let _e222 = phi_819_;
            let _e224 = phi_820_;
            let _e226 = phi_821_;
            phi_822_ = _e222;
            phi_823_ = _e224;
            phi_824_ = _e226;
        } else {
            phi_822_ = bool();
            phi_823_ = true;
            phi_824_ = false;
        }
        let _e228 = phi_822_;
        let _e230 = phi_823_;
        let _e232 = phi_824_;
        if _e230 {
            phi_828_ = true;
        } else {
            phi_828_ = _e232;
        }
        let _e234 = phi_828_;
        if _e234 {
            phi_832_ = false;
        } else {
            phi_832_ = _e228;
        }
        let _e236 = phi_832_;
        if _e236 {
            let _e237 = (_e114 >= _e78);
            if _e237 {
                phi_3254_ = lt_bvh_Hit();
            } else {
                if (_e114 < _e78) {
                } else {
                    return;
                }
                let _e243 = nodes.member[(0u + _e114)].frame[0u];
                let _e247 = nodes.member[(0u + _e114)].frame[1u];
                let _e251 = nodes.member[(0u + _e114)].frame[2u];
                let _e255 = nodes.member[(0u + _e114)].frame[0u];
                let _e259 = nodes.member[(0u + _e114)].frame[1u];
                let _e263 = nodes.member[(0u + _e114)].frame[2u];
                let _e267 = nodes.member[(0u + _e114)].frame[3u];
                let _e305 = core_intrinsics_maximum_number_nsz_f32_(abs(_e165.direction.x), abs(_e165.direction.y));
                let _e306 = core_intrinsics_maximum_number_nsz_f32_(_e305, abs(_e165.direction.z));
                let _e307 = (_e306 * 0.0000000000009094947f);
                if (abs(_e165.direction.x) < _e307) {
                    phi_907_ = _e307;
                } else {
                    phi_907_ = abs(_e165.direction.x);
                }
                let _e313 = phi_907_;
                if (_e165.direction.x < 0f) {
                    phi_914_ = (-1f / _e313);
                } else {
                    phi_914_ = (1f / _e313);
                }
                let _e318 = phi_914_;
                if (abs(_e165.direction.y) < _e307) {
                    phi_922_ = _e307;
                } else {
                    phi_922_ = abs(_e165.direction.y);
                }
                let _e324 = phi_922_;
                if (_e165.direction.y < 0f) {
                    phi_929_ = (-1f / _e324);
                } else {
                    phi_929_ = (1f / _e324);
                }
                let _e329 = phi_929_;
                if (abs(_e165.direction.z) < _e307) {
                    phi_937_ = _e307;
                } else {
                    phi_937_ = abs(_e165.direction.z);
                }
                let _e335 = phi_937_;
                if (_e165.direction.z < 0f) {
                    phi_944_ = (-1f / _e335);
                } else {
                    phi_944_ = (1f / _e335);
                }
                let _e340 = phi_944_;
                let _e348 = abs((bitcast<f32>(_e243) - _e165.origin.x));
                let _e349 = abs((bitcast<f32>(_e247) - _e165.origin.y));
                let _e350 = abs((bitcast<f32>(_e251) - _e165.origin.z));
                let _e358 = abs(((bitcast<f32>(_e255) + (bitcast<f32>((((_e267 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e165.origin.x));
                let _e359 = abs(((bitcast<f32>(_e259) + (bitcast<f32>((((_e267 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e165.origin.y));
                let _e360 = abs(((bitcast<f32>(_e263) + (bitcast<f32>((((_e267 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e165.origin.z));
                if (_e348 > _e358) {
                    phi_969_ = _e348;
                } else {
                    phi_969_ = _e358;
                }
                let _e363 = phi_969_;
                if (_e349 > _e359) {
                    phi_974_ = _e349;
                } else {
                    phi_974_ = _e359;
                }
                let _e366 = phi_974_;
                if (_e350 > _e360) {
                    phi_979_ = _e350;
                } else {
                    phi_979_ = _e360;
                }
                let _e369 = phi_979_;
                let _e370 = core_intrinsics_maximum_number_nsz_f32_(_e363, _e366);
                let _e371 = core_intrinsics_maximum_number_nsz_f32_(_e370, _e369);
                let _e376 = (_e371 * 0.0000019073486f);
                let _e377 = (abs(_e318) * _e376);
                let _e378 = (abs(_e329) * _e376);
                let _e379 = (abs(_e340) * _e376);
                let _e383 = (_e371 * 0.0000009536743f);
                let _e384 = (abs(_e318) * _e383);
                let _e385 = (abs(_e329) * _e383);
                let _e386 = (abs(_e340) * _e383);
                if (_e318 < 0f) {
                    phi_1001_ = 0u;
                } else {
                    phi_1001_ = 1u;
                }
                let _e389 = phi_1001_;
                if (_e329 < 0f) {
                    phi_1006_ = 0u;
                } else {
                    phi_1006_ = 2u;
                }
                let _e392 = phi_1006_;
                if (_e340 < 0f) {
                    phi_1011_ = 0u;
                } else {
                    phi_1011_ = 4u;
                }
                let _e395 = phi_1011_;
                let _e397 = ((_e389 | _e392) | _e395);
                let _e398 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e114, 2147483648u);
                local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e398.first[0], _e398.first[1], _e398.first[2], _e398.first[3], _e398.first[4], _e398.first[5], _e398.first[6], _e398.first[7], _e398.first[8], _e398.first[9], _e398.first[10], _e398.first[11], _e398.first[12], _e398.first[13], _e398.first[14], _e398.first[15], _e398.first[16], _e398.first[17], _e398.first[18], _e398.first[19], _e398.first[20], _e398.first[21], _e398.first[22], _e398.first[23], _e398.first[24], _e398.first[25], _e398.first[26], _e398.first[27], _e398.first[28], _e398.first[29], _e398.first[30], _e398.first[31]), array<u32, 32>(_e398.mask[0], _e398.mask[1], _e398.mask[2], _e398.mask[3], _e398.mask[4], _e398.mask[5], _e398.mask[6], _e398.mask[7], _e398.mask[8], _e398.mask[9], _e398.mask[10], _e398.mask[11], _e398.mask[12], _e398.mask[13], _e398.mask[14], _e398.mask[15], _e398.mask[16], _e398.mask[17], _e398.mask[18], _e398.mask[19], _e398.mask[20], _e398.mask[21], _e398.mask[22], _e398.mask[23], _e398.mask[24], _e398.mask[25], _e398.mask[26], _e398.mask[27], _e398.mask[28], _e398.mask[29], _e398.mask[30], _e398.mask[31]), _e398.len, _e398.group, _e398.group_mask);
                let _e472 = local_2.group_mask;
                if ((_e472 & 4278190080u) == 0u) {
                    let _e476 = local_2.len;
                    if (_e476 == 0u) {
                        phi_1125_ = false;
                    } else {
                        let _e480 = local_2.len;
                        local_2.len = (_e480 - 1u);
                        let _e483 = local_2.len;
                        if (_e483 < 32u) {
                        } else {
                            return;
                        }
                        let _e488 = local_2.first[(0u + _e483)];
                        local_2.group = _e488;
                        let _e491 = local_2.len;
                        if (_e491 < 32u) {
                        } else {
                            return;
                        }
                        let _e496 = local_2.mask[(0u + _e491)];
                        local_2.group_mask = _e496;
                        phi_1125_ = true;
                    }
                    let _e499 = phi_1125_;
                    phi_1126_ = _e499;
                } else {
                    phi_1126_ = true;
                }
                let _e501 = phi_1126_;
                if _e501 {
                    let _e503 = local_2.group_mask;
                    let _e509 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e503)), 32u, (_e503 == 0u)));
                    let _e513 = local_2.group_mask;
                    let _e527 = local_2.group_mask;
                    local_2.group_mask = (_e527 & ~((1u << bitcast<u32>((_e509 & 31u)))));
                    let _e530 = local_2.group;
                    phi_1157_ = (_e530 + countOneBits(((_e513 & ~((4294967295u << bitcast<u32>((((_e509 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1157_ = 4294967295u;
                }
                let _e533 = phi_1157_;
                phi_1159_ = _e533;
                phi_1162_ = _e167;
                loop {
                    let _e535 = phi_1159_;
                    let _e537 = phi_1162_;
                    local_12 = _e537;
                    let _e538 = (_e535 != 4294967295u);
                    if _e538 {
                        if (_e535 < _e78) {
                        } else {
                            return;
                        }
                        let _e546 = nodes.member[(0u + _e535)].frame[3u];
                        let _e571 = (bitcast<f32>((((_e546 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e318);
                        let _e572 = (bitcast<f32>((((_e546 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e329);
                        let _e573 = (bitcast<f32>((((_e546 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e340);
                        let _e576 = nodes.member[(0u + _e535)].frame[0u];
                        let _e580 = nodes.member[(0u + _e535)].frame[1u];
                        let _e584 = nodes.member[(0u + _e535)].frame[2u];
                        let _e592 = ((bitcast<f32>(_e576) - _e165.origin.x) * _e318);
                        let _e593 = ((bitcast<f32>(_e580) - _e165.origin.y) * _e329);
                        let _e594 = ((bitcast<f32>(_e584) - _e165.origin.z) * _e340);
                        let _e602 = nodes.member[(0u + _e535)].x;
                        if (_e318 < 0f) {
                            let _e613 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e602.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e619 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e613.unnamed.word, _e602.w), _e613.unnamed_1);
                            let _e625 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e619.unnamed, lt_mask_LightPlace(_e602.x, _e619.unnamed_1.shift));
                            phi_1247_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e625.unnamed, lt_mask_LightPlace(_e625.unnamed_1.word, _e602.y));
                        } else {
                            let _e641 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e602.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e647 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e641.unnamed.word, _e602.y), _e641.unnamed_1);
                            let _e653 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e647.unnamed, lt_mask_LightPlace(_e602.z, _e647.unnamed_1.shift));
                            phi_1247_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e653.unnamed, lt_mask_LightPlace(_e653.unnamed_1.word, _e602.w));
                        }
                        let _e661 = phi_1247_;
                        let _e671 = nodes.member[(0u + _e535)].y;
                        if (_e329 < 0f) {
                            let _e682 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e671.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e688 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e682.unnamed.word, _e671.w), _e682.unnamed_1);
                            let _e694 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e688.unnamed, lt_mask_LightPlace(_e671.x, _e688.unnamed_1.shift));
                            phi_1274_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e694.unnamed, lt_mask_LightPlace(_e694.unnamed_1.word, _e671.y));
                        } else {
                            let _e710 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e671.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e716 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e710.unnamed.word, _e671.y), _e710.unnamed_1);
                            let _e722 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e716.unnamed, lt_mask_LightPlace(_e671.z, _e716.unnamed_1.shift));
                            phi_1274_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e722.unnamed, lt_mask_LightPlace(_e722.unnamed_1.word, _e671.w));
                        }
                        let _e730 = phi_1274_;
                        let _e740 = nodes.member[(0u + _e535)].z;
                        if (_e340 < 0f) {
                            let _e751 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e740.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e757 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e751.unnamed.word, _e740.w), _e751.unnamed_1);
                            let _e763 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e757.unnamed, lt_mask_LightPlace(_e740.x, _e757.unnamed_1.shift));
                            phi_1301_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e763.unnamed, lt_mask_LightPlace(_e763.unnamed_1.word, _e740.y));
                        } else {
                            let _e779 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e740.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e785 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e779.unnamed.word, _e740.y), _e779.unnamed_1);
                            let _e791 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e785.unnamed, lt_mask_LightPlace(_e740.z, _e785.unnamed_1.shift));
                            phi_1301_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e791.unnamed, lt_mask_LightPlace(_e791.unnamed_1.word, _e740.w));
                        }
                        let _e799 = phi_1301_;
                        phi_1307_ = 0u;
                        phi_1310_ = 0u;
                        loop {
                            let _e809 = phi_1307_;
                            let _e811 = phi_1310_;
                            local_3 = _e811;
                            local_4 = _e811;
                            local_5 = _e811;
                            let _e812 = (_e809 < 8u);
                            if _e812 {
                                let _e814 = (_e809 >> bitcast<u32>(2i));
                                let _e815 = (_e809 & 3u);
                                if (_e814 == 0u) {
                                    phi_1324_ = _e661.unnamed.word;
                                } else {
                                    phi_1324_ = _e661.unnamed.shift;
                                }
                                let _e818 = phi_1324_;
                                if (_e814 == 0u) {
                                    phi_1334_ = _e730.unnamed.word;
                                } else {
                                    phi_1334_ = _e730.unnamed.shift;
                                }
                                let _e827 = phi_1334_;
                                if (_e814 == 0u) {
                                    phi_1344_ = _e799.unnamed.word;
                                } else {
                                    phi_1344_ = _e799.unnamed.shift;
                                }
                                let _e836 = phi_1344_;
                                let _e849 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e818 >> bitcast<u32>(((_e815 * 8u) & 31u))) & 255u)) * _e571) + (_e592 - _e377)), ((f32(((_e827 >> bitcast<u32>(((_e815 * 8u) & 31u))) & 255u)) * _e572) + (_e593 - _e378)));
                                let _e850 = core_intrinsics_maximum_number_nsz_f32_(_e849, ((f32(((_e836 >> bitcast<u32>(((_e815 * 8u) & 31u))) & 255u)) * _e573) + (_e594 - _e379)));
                                if (_e814 == 0u) {
                                    phi_1362_ = _e661.unnamed_1.word;
                                } else {
                                    phi_1362_ = _e661.unnamed_1.shift;
                                }
                                let _e853 = phi_1362_;
                                if (_e814 == 0u) {
                                    phi_1372_ = _e730.unnamed_1.word;
                                } else {
                                    phi_1372_ = _e730.unnamed_1.shift;
                                }
                                let _e862 = phi_1372_;
                                if (_e814 == 0u) {
                                    phi_1382_ = _e799.unnamed_1.word;
                                } else {
                                    phi_1382_ = _e799.unnamed_1.shift;
                                }
                                let _e871 = phi_1382_;
                                let _e884 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e853 >> bitcast<u32>(((_e815 * 8u) & 31u))) & 255u)) * _e571) + (_e592 + _e377)), ((f32(((_e862 >> bitcast<u32>(((_e815 * 8u) & 31u))) & 255u)) * _e572) + (_e593 + _e378)));
                                let _e885 = core_intrinsics_minimum_number_nsz_f32_(_e884, ((f32(((_e871 >> bitcast<u32>(((_e815 * 8u) & 31u))) & 255u)) * _e573) + (_e594 + _e379)));
                                if (_e850 <= _e885) {
                                    if (_e850 <= _e537.t) {
                                        if (_e885 >= _e165.tmin) {
                                            if (_e814 == 0u) {
                                                let _e892 = nodes.member[(0u + _e535)].links[2u];
                                                phi_1418_ = _e892;
                                            } else {
                                                let _e895 = nodes.member[(0u + _e535)].links[3u];
                                                phi_1418_ = _e895;
                                            }
                                            let _e897 = phi_1418_;
                                            let _e902 = ((_e897 >> bitcast<u32>(((_e815 * 8u) & 31u))) & 255u);
                                            let _e903 = (_e902 & 31u);
                                            if (_e903 >= 24u) {
                                                phi_1431_ = (24u + ((_e903 - 24u) ^ _e397));
                                            } else {
                                                phi_1431_ = _e903;
                                            }
                                            let _e909 = phi_1431_;
                                            phi_1436_ = (_e811 | ((_e902 >> bitcast<u32>(5i)) << bitcast<u32>((_e909 & 31u))));
                                        } else {
                                            phi_1436_ = _e811;
                                        }
                                        let _e917 = phi_1436_;
                                        phi_1437_ = _e917;
                                    } else {
                                        phi_1437_ = _e811;
                                    }
                                    let _e919 = phi_1437_;
                                    phi_1438_ = _e919;
                                } else {
                                    phi_1438_ = _e811;
                                }
                                let _e921 = phi_1438_;
                                phi_1308_ = (_e809 + 1u);
                                phi_1311_ = _e921;
                            } else {
                                phi_1308_ = u32();
                                phi_1311_ = u32();
                            }
                            let _e924 = phi_1308_;
                            let _e926 = phi_1311_;
                            continue;
                            continuing {
                                phi_1307_ = _e924;
                                phi_1310_ = _e926;
                                break if !(_e812);
                            }
                        }
                        let _e930 = nodes.member[(0u + _e535)].links[0u];
                        let _e934 = nodes.member[(0u + _e535)].frame[3u];
                        let _e938 = local_3;
                        if ((_e938 & 4278190080u) == 0u) {
                        } else {
                            let _e942 = local_2.group_mask;
                            if ((_e942 & 4278190080u) == 0u) {
                            } else {
                                let _e946 = local_2.len;
                                if (_e946 < 32u) {
                                    let _e949 = local_2.group;
                                    let _e951 = local_2.len;
                                    if (_e951 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.first[(0u + _e951)] = _e949;
                                    let _e957 = local_2.group_mask;
                                    let _e959 = local_2.len;
                                    if (_e959 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.mask[(0u + _e959)] = _e957;
                                    let _e966 = local_2.len;
                                    local_2.len = (_e966 + 1u);
                                }
                            }
                            local_2.group = (_e114 + _e930);
                            let _e970 = local_4;
                            local_2.group_mask = ((_e970 & 4278190080u) | (_e934 >> bitcast<u32>(24i)));
                        }
                        let _e975 = local_5;
                        phi_1496_ = (_e975 & 16777215u);
                        phi_1499_ = _e537;
                        loop {
                            let _e978 = phi_1496_;
                            let _e980 = phi_1499_;
                            local_11 = _e980;
                            if (_e978 == 0u) {
                                phi_1497_ = u32();
                                phi_1500_ = lt_bvh_Hit();
                                phi_3182_ = false;
                            } else {
                                let _e984 = nodes.member[(0u + _e535)].links[1u];
                                let _e988 = (_e984 + select(firstTrailingBit(_e978), 32u, (_e978 == 0u)));
                                if (_e988 < _e93) {
                                } else {
                                    return;
                                }
                                let _e995 = instances.member[(0u + _e988)].low_world;
                                let _e997 = instances.member[(0u + _e988)].high_world;
                                let _e1007 = ((_e995.x - _e165.origin.x) * _e318);
                                let _e1008 = ((_e995.y - _e165.origin.y) * _e329);
                                let _e1009 = ((_e995.z - _e165.origin.z) * _e340);
                                let _e1019 = ((_e997.x - _e165.origin.x) * _e318);
                                let _e1020 = ((_e997.y - _e165.origin.y) * _e329);
                                let _e1021 = ((_e997.z - _e165.origin.z) * _e340);
                                if (_e1007 < _e1019) {
                                    phi_1554_ = _e1007;
                                } else {
                                    phi_1554_ = _e1019;
                                }
                                let _e1024 = phi_1554_;
                                if (_e1008 < _e1020) {
                                    phi_1559_ = _e1008;
                                } else {
                                    phi_1559_ = _e1020;
                                }
                                let _e1027 = phi_1559_;
                                if (_e1009 < _e1021) {
                                    phi_1564_ = _e1009;
                                } else {
                                    phi_1564_ = _e1021;
                                }
                                let _e1030 = phi_1564_;
                                if (_e1007 > _e1019) {
                                    phi_1572_ = _e1007;
                                } else {
                                    phi_1572_ = _e1019;
                                }
                                let _e1036 = phi_1572_;
                                if (_e1008 > _e1020) {
                                    phi_1577_ = _e1008;
                                } else {
                                    phi_1577_ = _e1020;
                                }
                                let _e1039 = phi_1577_;
                                if (_e1009 > _e1021) {
                                    phi_1582_ = _e1009;
                                } else {
                                    phi_1582_ = _e1021;
                                }
                                let _e1042 = phi_1582_;
                                let _e1046 = core_intrinsics_maximum_number_nsz_f32_((_e1024 - _e384), (_e1027 - _e385));
                                let _e1047 = core_intrinsics_maximum_number_nsz_f32_(_e1046, (_e1030 - _e386));
                                let _e1048 = core_intrinsics_minimum_number_nsz_f32_((_e1036 + _e384), (_e1039 + _e385));
                                let _e1049 = core_intrinsics_minimum_number_nsz_f32_(_e1048, (_e1042 + _e386));
                                if (_e1047 <= _e1049) {
                                    if (_e1047 <= _e980.t) {
                                        if (_e1049 >= _e165.tmin) {
                                            let _e1061 = instances.member[(0u + _e988)].world_to_object[0u];
                                            let _e1072 = ((((_e1061.x * _e165.origin.x) + (_e1061.y * _e165.origin.y)) + (_e1061.z * _e165.origin.z)) + (_e1061.w * 1f));
                                            let _e1074 = instances.member[(0u + _e988)].world_to_object[1u];
                                            let _e1085 = ((((_e1074.x * _e165.origin.x) + (_e1074.y * _e165.origin.y)) + (_e1074.z * _e165.origin.z)) + (_e1074.w * 1f));
                                            let _e1087 = instances.member[(0u + _e988)].world_to_object[2u];
                                            let _e1098 = ((((_e1087.x * _e165.origin.x) + (_e1087.y * _e165.origin.y)) + (_e1087.z * _e165.origin.z)) + (_e1087.w * 1f));
                                            let _e1105 = instances.member[(0u + _e988)].world_to_object[0u];
                                            let _e1116 = ((((_e1105.x * _e165.direction.x) + (_e1105.y * _e165.direction.y)) + (_e1105.z * _e165.direction.z)) + (_e1105.w * 0f));
                                            let _e1118 = instances.member[(0u + _e988)].world_to_object[1u];
                                            let _e1129 = ((((_e1118.x * _e165.direction.x) + (_e1118.y * _e165.direction.y)) + (_e1118.z * _e165.direction.z)) + (_e1118.w * 0f));
                                            let _e1131 = instances.member[(0u + _e988)].world_to_object[2u];
                                            let _e1142 = ((((_e1131.x * _e165.direction.x) + (_e1131.y * _e165.direction.y)) + (_e1131.z * _e165.direction.z)) + (_e1131.w * 0f));
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
                                                                        phi_1739_ = bool();
                                                                        phi_1740_ = true;
                                                                    } else {
                                                                        let _e1163 = (_e1154 > 0f);
                                                                        if _e1163 {
                                                                            phi_1738_ = bool();
                                                                        } else {
                                                                            phi_1738_ = (_e1155 > 0f);
                                                                        }
                                                                        let _e1166 = phi_1738_;
                                                                        phi_1739_ = _e1166;
                                                                        phi_1740_ = _e1163;
                                                                    }
                                                                    let _e1168 = phi_1739_;
                                                                    let _e1170 = phi_1740_;
                                                                    if _e1170 {
                                                                        phi_1744_ = true;
                                                                    } else {
                                                                        phi_1744_ = _e1168;
                                                                    }
                                                                    let _e1172 = phi_1744_;
                                                                    phi_1745_ = _e1172;
                                                                    phi_1746_ = false;
                                                                } else {
                                                                    phi_1745_ = bool();
                                                                    phi_1746_ = true;
                                                                }
                                                                let _e1174 = phi_1745_;
                                                                let _e1176 = phi_1746_;
                                                                phi_1747_ = _e1174;
                                                                phi_1748_ = false;
                                                                phi_1749_ = _e1176;
                                                            } else {
                                                                phi_1747_ = bool();
                                                                phi_1748_ = true;
                                                                phi_1749_ = false;
                                                            }
                                                            let _e1178 = phi_1747_;
                                                            let _e1180 = phi_1748_;
                                                            let _e1182 = phi_1749_;
                                                            phi_1750_ = _e1178;
                                                            phi_1751_ = _e1180;
                                                            phi_1752_ = _e1182;
                                                        } else {
                                                            phi_1750_ = bool();
                                                            phi_1751_ = true;
                                                            phi_1752_ = false;
                                                        }
                                                        let _e1184 = phi_1750_;
                                                        let _e1186 = phi_1751_;
                                                        let _e1188 = phi_1752_;
                                                        phi_1753_ = _e1184;
                                                        phi_1754_ = _e1186;
                                                        phi_1755_ = _e1188;
                                                    } else {
                                                        phi_1753_ = bool();
                                                        phi_1754_ = true;
                                                        phi_1755_ = false;
                                                    }
                                                    let _e1190 = phi_1753_;
                                                    let _e1192 = phi_1754_;
                                                    let _e1194 = phi_1755_;
                                                    phi_1756_ = _e1190;
                                                    phi_1757_ = _e1192;
                                                    phi_1758_ = _e1194;
                                                } else {
                                                    phi_1756_ = bool();
                                                    phi_1757_ = true;
                                                    phi_1758_ = false;
                                                }
                                                let _e1196 = phi_1756_;
                                                let _e1198 = phi_1757_;
                                                let _e1200 = phi_1758_;
                                                phi_1759_ = _e1196;
                                                phi_1760_ = _e1198;
                                                phi_1761_ = _e1200;
                                            } else {
                                                phi_1759_ = bool();
                                                phi_1760_ = true;
                                                phi_1761_ = false;
                                            }
                                            let _e1202 = phi_1759_;
                                            let _e1204 = phi_1760_;
                                            let _e1206 = phi_1761_;
                                            if _e1204 {
                                                phi_1765_ = true;
                                            } else {
                                                phi_1765_ = _e1206;
                                            }
                                            let _e1208 = phi_1765_;
                                            if _e1208 {
                                                phi_1769_ = false;
                                            } else {
                                                phi_1769_ = _e1202;
                                            }
                                            let _e1210 = phi_1769_;
                                            if _e1210 {
                                                let _e1211 = (_e1147 >= _e78);
                                                if _e1211 {
                                                    phi_3172_ = lt_bvh_Hit();
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
                                                        phi_1839_ = _e1277;
                                                    } else {
                                                        phi_1839_ = abs(_e1116);
                                                    }
                                                    let _e1282 = phi_1839_;
                                                    if (_e1116 < 0f) {
                                                        phi_1846_ = (-1f / _e1282);
                                                    } else {
                                                        phi_1846_ = (1f / _e1282);
                                                    }
                                                    let _e1287 = phi_1846_;
                                                    if (abs(_e1129) < _e1277) {
                                                        phi_1853_ = _e1277;
                                                    } else {
                                                        phi_1853_ = abs(_e1129);
                                                    }
                                                    let _e1292 = phi_1853_;
                                                    if (_e1129 < 0f) {
                                                        phi_1860_ = (-1f / _e1292);
                                                    } else {
                                                        phi_1860_ = (1f / _e1292);
                                                    }
                                                    let _e1297 = phi_1860_;
                                                    if (abs(_e1142) < _e1277) {
                                                        phi_1867_ = _e1277;
                                                    } else {
                                                        phi_1867_ = abs(_e1142);
                                                    }
                                                    let _e1302 = phi_1867_;
                                                    if (_e1142 < 0f) {
                                                        phi_1874_ = (-1f / _e1302);
                                                    } else {
                                                        phi_1874_ = (1f / _e1302);
                                                    }
                                                    let _e1307 = phi_1874_;
                                                    let _e1311 = abs((bitcast<f32>(_e1217) - _e1072));
                                                    let _e1312 = abs((bitcast<f32>(_e1221) - _e1085));
                                                    let _e1313 = abs((bitcast<f32>(_e1225) - _e1098));
                                                    let _e1317 = abs(((bitcast<f32>(_e1229) + (bitcast<f32>((((_e1241 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1072));
                                                    let _e1318 = abs(((bitcast<f32>(_e1233) + (bitcast<f32>((((_e1241 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1085));
                                                    let _e1319 = abs(((bitcast<f32>(_e1237) + (bitcast<f32>((((_e1241 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1098));
                                                    if (_e1311 > _e1317) {
                                                        phi_1891_ = _e1311;
                                                    } else {
                                                        phi_1891_ = _e1317;
                                                    }
                                                    let _e1322 = phi_1891_;
                                                    if (_e1312 > _e1318) {
                                                        phi_1896_ = _e1312;
                                                    } else {
                                                        phi_1896_ = _e1318;
                                                    }
                                                    let _e1325 = phi_1896_;
                                                    if (_e1313 > _e1319) {
                                                        phi_1901_ = _e1313;
                                                    } else {
                                                        phi_1901_ = _e1319;
                                                    }
                                                    let _e1328 = phi_1901_;
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
                                                            phi_1929_ = false;
                                                        } else {
                                                            phi_1929_ = true;
                                                        }
                                                        let _e1351 = phi_1929_;
                                                        phi_1930_ = _e1351;
                                                    } else {
                                                        phi_1930_ = true;
                                                    }
                                                    let _e1353 = phi_1930_;
                                                    if _e1353 {
                                                        if (_e1346 >= _e1347) {
                                                            phi_1938_ = 1u;
                                                        } else {
                                                            phi_1938_ = 2u;
                                                        }
                                                        let _e1356 = phi_1938_;
                                                        phi_1939_ = _e1356;
                                                    } else {
                                                        phi_1939_ = 0u;
                                                    }
                                                    let _e1358 = phi_1939_;
                                                    if (_e1358 == 0u) {
                                                        phi_1951_ = vec3<f32>(_e1129, _e1142, _e1116);
                                                    } else {
                                                        if (_e1358 == 1u) {
                                                            phi_1950_ = vec3<f32>(_e1142, _e1116, _e1129);
                                                        } else {
                                                            phi_1950_ = vec3<f32>(_e1116, _e1129, _e1142);
                                                        }
                                                        let _e1364 = phi_1950_;
                                                        phi_1951_ = _e1364;
                                                    }
                                                    let _e1366 = phi_1951_;
                                                    let _e1369 = (_e1366.x / _e1366.z);
                                                    let _e1372 = (_e1366.y / _e1366.z);
                                                    if (_e1287 < 0f) {
                                                        phi_1964_ = 0u;
                                                    } else {
                                                        phi_1964_ = 1u;
                                                    }
                                                    let _e1377 = phi_1964_;
                                                    if (_e1297 < 0f) {
                                                        phi_1969_ = 0u;
                                                    } else {
                                                        phi_1969_ = 2u;
                                                    }
                                                    let _e1380 = phi_1969_;
                                                    if (_e1307 < 0f) {
                                                        phi_1974_ = 0u;
                                                    } else {
                                                        phi_1974_ = 4u;
                                                    }
                                                    let _e1383 = phi_1974_;
                                                    let _e1385 = ((_e1377 | _e1380) | _e1383);
                                                    let _e1386 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1147, 2147483648u);
                                                    local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e1386.first[0], _e1386.first[1], _e1386.first[2], _e1386.first[3], _e1386.first[4], _e1386.first[5], _e1386.first[6], _e1386.first[7], _e1386.first[8], _e1386.first[9], _e1386.first[10], _e1386.first[11], _e1386.first[12], _e1386.first[13], _e1386.first[14], _e1386.first[15], _e1386.first[16], _e1386.first[17], _e1386.first[18], _e1386.first[19], _e1386.first[20], _e1386.first[21], _e1386.first[22], _e1386.first[23], _e1386.first[24], _e1386.first[25], _e1386.first[26], _e1386.first[27], _e1386.first[28], _e1386.first[29], _e1386.first[30], _e1386.first[31]), array<u32, 32>(_e1386.mask[0], _e1386.mask[1], _e1386.mask[2], _e1386.mask[3], _e1386.mask[4], _e1386.mask[5], _e1386.mask[6], _e1386.mask[7], _e1386.mask[8], _e1386.mask[9], _e1386.mask[10], _e1386.mask[11], _e1386.mask[12], _e1386.mask[13], _e1386.mask[14], _e1386.mask[15], _e1386.mask[16], _e1386.mask[17], _e1386.mask[18], _e1386.mask[19], _e1386.mask[20], _e1386.mask[21], _e1386.mask[22], _e1386.mask[23], _e1386.mask[24], _e1386.mask[25], _e1386.mask[26], _e1386.mask[27], _e1386.mask[28], _e1386.mask[29], _e1386.mask[30], _e1386.mask[31]), _e1386.len, _e1386.group, _e1386.group_mask);
                                                    let _e1460 = local_1.group_mask;
                                                    if ((_e1460 & 4278190080u) == 0u) {
                                                        let _e1464 = local_1.len;
                                                        if (_e1464 == 0u) {
                                                            phi_2088_ = false;
                                                        } else {
                                                            let _e1468 = local_1.len;
                                                            local_1.len = (_e1468 - 1u);
                                                            let _e1471 = local_1.len;
                                                            if (_e1471 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1476 = local_1.first[(0u + _e1471)];
                                                            local_1.group = _e1476;
                                                            let _e1479 = local_1.len;
                                                            if (_e1479 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1484 = local_1.mask[(0u + _e1479)];
                                                            local_1.group_mask = _e1484;
                                                            phi_2088_ = true;
                                                        }
                                                        let _e1487 = phi_2088_;
                                                        phi_2089_ = _e1487;
                                                    } else {
                                                        phi_2089_ = true;
                                                    }
                                                    let _e1489 = phi_2089_;
                                                    if _e1489 {
                                                        let _e1491 = local_1.group_mask;
                                                        let _e1497 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1491)), 32u, (_e1491 == 0u)));
                                                        let _e1501 = local_1.group_mask;
                                                        let _e1515 = local_1.group_mask;
                                                        local_1.group_mask = (_e1515 & ~((1u << bitcast<u32>((_e1497 & 31u)))));
                                                        let _e1518 = local_1.group;
                                                        phi_2120_ = (_e1518 + countOneBits(((_e1501 & ~((4294967295u << bitcast<u32>((((_e1497 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_2120_ = 4294967295u;
                                                    }
                                                    let _e1521 = phi_2120_;
                                                    phi_2122_ = _e980;
                                                    phi_2125_ = _e1521;
                                                    loop {
                                                        let _e1523 = phi_2122_;
                                                        let _e1525 = phi_2125_;
                                                        local_10 = _e1523;
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
                                                                phi_2206_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1609.unnamed, lt_mask_LightPlace(_e1609.unnamed_1.word, _e1586.y));
                                                            } else {
                                                                let _e1625 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1586.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1631 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1625.unnamed.word, _e1586.y), _e1625.unnamed_1);
                                                                let _e1637 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1631.unnamed, lt_mask_LightPlace(_e1586.z, _e1631.unnamed_1.shift));
                                                                phi_2206_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1637.unnamed, lt_mask_LightPlace(_e1637.unnamed_1.word, _e1586.w));
                                                            }
                                                            let _e1645 = phi_2206_;
                                                            let _e1655 = nodes.member[(0u + _e1525)].y;
                                                            if (_e1297 < 0f) {
                                                                let _e1666 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1655.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1672 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1666.unnamed.word, _e1655.w), _e1666.unnamed_1);
                                                                let _e1678 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1672.unnamed, lt_mask_LightPlace(_e1655.x, _e1672.unnamed_1.shift));
                                                                phi_2233_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1678.unnamed, lt_mask_LightPlace(_e1678.unnamed_1.word, _e1655.y));
                                                            } else {
                                                                let _e1694 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1655.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1700 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1694.unnamed.word, _e1655.y), _e1694.unnamed_1);
                                                                let _e1706 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1700.unnamed, lt_mask_LightPlace(_e1655.z, _e1700.unnamed_1.shift));
                                                                phi_2233_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1706.unnamed, lt_mask_LightPlace(_e1706.unnamed_1.word, _e1655.w));
                                                            }
                                                            let _e1714 = phi_2233_;
                                                            let _e1724 = nodes.member[(0u + _e1525)].z;
                                                            if (_e1307 < 0f) {
                                                                let _e1735 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1724.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1741 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1735.unnamed.word, _e1724.w), _e1735.unnamed_1);
                                                                let _e1747 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1741.unnamed, lt_mask_LightPlace(_e1724.x, _e1741.unnamed_1.shift));
                                                                phi_2260_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1747.unnamed, lt_mask_LightPlace(_e1747.unnamed_1.word, _e1724.y));
                                                            } else {
                                                                let _e1763 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1724.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1769 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1763.unnamed.word, _e1724.y), _e1763.unnamed_1);
                                                                let _e1775 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1769.unnamed, lt_mask_LightPlace(_e1724.z, _e1769.unnamed_1.shift));
                                                                phi_2260_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1775.unnamed, lt_mask_LightPlace(_e1775.unnamed_1.word, _e1724.w));
                                                            }
                                                            let _e1783 = phi_2260_;
                                                            phi_2266_ = 0u;
                                                            phi_2269_ = 0u;
                                                            loop {
                                                                let _e1793 = phi_2266_;
                                                                let _e1795 = phi_2269_;
                                                                local_6 = _e1795;
                                                                local_7 = _e1795;
                                                                local_8 = _e1795;
                                                                let _e1796 = (_e1793 < 8u);
                                                                if _e1796 {
                                                                    let _e1798 = (_e1793 >> bitcast<u32>(2i));
                                                                    let _e1799 = (_e1793 & 3u);
                                                                    if (_e1798 == 0u) {
                                                                        phi_2283_ = _e1645.unnamed.word;
                                                                    } else {
                                                                        phi_2283_ = _e1645.unnamed.shift;
                                                                    }
                                                                    let _e1802 = phi_2283_;
                                                                    if (_e1798 == 0u) {
                                                                        phi_2293_ = _e1714.unnamed.word;
                                                                    } else {
                                                                        phi_2293_ = _e1714.unnamed.shift;
                                                                    }
                                                                    let _e1811 = phi_2293_;
                                                                    if (_e1798 == 0u) {
                                                                        phi_2303_ = _e1783.unnamed.word;
                                                                    } else {
                                                                        phi_2303_ = _e1783.unnamed.shift;
                                                                    }
                                                                    let _e1820 = phi_2303_;
                                                                    let _e1833 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1802 >> bitcast<u32>(((_e1799 * 8u) & 31u))) & 255u)) * _e1558) + (_e1576 - _e1335)), ((f32(((_e1811 >> bitcast<u32>(((_e1799 * 8u) & 31u))) & 255u)) * _e1559) + (_e1577 - _e1336)));
                                                                    let _e1834 = core_intrinsics_maximum_number_nsz_f32_(_e1833, ((f32(((_e1820 >> bitcast<u32>(((_e1799 * 8u) & 31u))) & 255u)) * _e1560) + (_e1578 - _e1337)));
                                                                    if (_e1798 == 0u) {
                                                                        phi_2321_ = _e1645.unnamed_1.word;
                                                                    } else {
                                                                        phi_2321_ = _e1645.unnamed_1.shift;
                                                                    }
                                                                    let _e1837 = phi_2321_;
                                                                    if (_e1798 == 0u) {
                                                                        phi_2331_ = _e1714.unnamed_1.word;
                                                                    } else {
                                                                        phi_2331_ = _e1714.unnamed_1.shift;
                                                                    }
                                                                    let _e1846 = phi_2331_;
                                                                    if (_e1798 == 0u) {
                                                                        phi_2341_ = _e1783.unnamed_1.word;
                                                                    } else {
                                                                        phi_2341_ = _e1783.unnamed_1.shift;
                                                                    }
                                                                    let _e1855 = phi_2341_;
                                                                    let _e1868 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1837 >> bitcast<u32>(((_e1799 * 8u) & 31u))) & 255u)) * _e1558) + (_e1576 + _e1335)), ((f32(((_e1846 >> bitcast<u32>(((_e1799 * 8u) & 31u))) & 255u)) * _e1559) + (_e1577 + _e1336)));
                                                                    let _e1869 = core_intrinsics_minimum_number_nsz_f32_(_e1868, ((f32(((_e1855 >> bitcast<u32>(((_e1799 * 8u) & 31u))) & 255u)) * _e1560) + (_e1578 + _e1337)));
                                                                    if (_e1834 <= _e1869) {
                                                                        if (_e1834 <= _e1523.t) {
                                                                            if (_e1869 >= _e165.tmin) {
                                                                                if (_e1798 == 0u) {
                                                                                    let _e1876 = nodes.member[(0u + _e1525)].links[2u];
                                                                                    phi_2377_ = _e1876;
                                                                                } else {
                                                                                    let _e1879 = nodes.member[(0u + _e1525)].links[3u];
                                                                                    phi_2377_ = _e1879;
                                                                                }
                                                                                let _e1881 = phi_2377_;
                                                                                let _e1886 = ((_e1881 >> bitcast<u32>(((_e1799 * 8u) & 31u))) & 255u);
                                                                                let _e1887 = (_e1886 & 31u);
                                                                                if (_e1887 >= 24u) {
                                                                                    phi_2390_ = (24u + ((_e1887 - 24u) ^ _e1385));
                                                                                } else {
                                                                                    phi_2390_ = _e1887;
                                                                                }
                                                                                let _e1893 = phi_2390_;
                                                                                phi_2395_ = (_e1795 | ((_e1886 >> bitcast<u32>(5i)) << bitcast<u32>((_e1893 & 31u))));
                                                                            } else {
                                                                                phi_2395_ = _e1795;
                                                                            }
                                                                            let _e1901 = phi_2395_;
                                                                            phi_2396_ = _e1901;
                                                                        } else {
                                                                            phi_2396_ = _e1795;
                                                                        }
                                                                        let _e1903 = phi_2396_;
                                                                        phi_2397_ = _e1903;
                                                                    } else {
                                                                        phi_2397_ = _e1795;
                                                                    }
                                                                    let _e1905 = phi_2397_;
                                                                    phi_2267_ = (_e1793 + 1u);
                                                                    phi_2270_ = _e1905;
                                                                } else {
                                                                    phi_2267_ = u32();
                                                                    phi_2270_ = u32();
                                                                }
                                                                let _e1908 = phi_2267_;
                                                                let _e1910 = phi_2270_;
                                                                continue;
                                                                continuing {
                                                                    phi_2266_ = _e1908;
                                                                    phi_2269_ = _e1910;
                                                                    break if !(_e1796);
                                                                }
                                                            }
                                                            let _e1914 = nodes.member[(0u + _e1525)].links[0u];
                                                            let _e1918 = nodes.member[(0u + _e1525)].frame[3u];
                                                            let _e1922 = local_6;
                                                            if ((_e1922 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1926 = local_1.group_mask;
                                                                if ((_e1926 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1930 = local_1.len;
                                                                    if (_e1930 < 32u) {
                                                                        let _e1933 = local_1.group;
                                                                        let _e1935 = local_1.len;
                                                                        if (_e1935 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.first[(0u + _e1935)] = _e1933;
                                                                        let _e1941 = local_1.group_mask;
                                                                        let _e1943 = local_1.len;
                                                                        if (_e1943 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.mask[(0u + _e1943)] = _e1941;
                                                                        let _e1950 = local_1.len;
                                                                        local_1.len = (_e1950 + 1u);
                                                                    }
                                                                }
                                                                local_1.group = (_e1147 + _e1914);
                                                                let _e1954 = local_7;
                                                                local_1.group_mask = ((_e1954 & 4278190080u) | (_e1918 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1959 = local_8;
                                                            phi_2455_ = _e1523;
                                                            phi_2458_ = (_e1959 & 16777215u);
                                                            loop {
                                                                let _e1962 = phi_2455_;
                                                                let _e1964 = phi_2458_;
                                                                local_9 = _e1962;
                                                                if (_e1964 == 0u) {
                                                                    phi_2456_ = lt_bvh_Hit();
                                                                    phi_2459_ = u32();
                                                                    phi_3100_ = false;
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
                                                                        phi_2503_ = vec3<f32>(_e1984, _e1986, _e1982);
                                                                    } else {
                                                                        if (_e1358 == 1u) {
                                                                            phi_2502_ = vec3<f32>(_e1986, _e1982, _e1984);
                                                                        } else {
                                                                            phi_2502_ = (_e1980 - vec3<f32>(_e1072, _e1085, _e1098));
                                                                        }
                                                                        let _e1994 = phi_2502_;
                                                                        phi_2503_ = _e1994;
                                                                    }
                                                                    let _e1996 = phi_2503_;
                                                                    let _e2000 = (_e1996.x - (_e1369 * _e1996.z));
                                                                    let _e2004 = (_e1996.y - (_e1372 * _e1996.z));
                                                                    let _e2006 = triangles.member[(0u + _e1973)].v1_;
                                                                    let _e2008 = (_e2006.x - _e1072);
                                                                    let _e2010 = (_e2006.y - _e1085);
                                                                    let _e2012 = (_e2006.z - _e1098);
                                                                    if (_e1358 == 0u) {
                                                                        phi_2533_ = vec3<f32>(_e2010, _e2012, _e2008);
                                                                    } else {
                                                                        if (_e1358 == 1u) {
                                                                            phi_2532_ = vec3<f32>(_e2012, _e2008, _e2010);
                                                                        } else {
                                                                            phi_2532_ = (_e2006 - vec3<f32>(_e1072, _e1085, _e1098));
                                                                        }
                                                                        let _e2020 = phi_2532_;
                                                                        phi_2533_ = _e2020;
                                                                    }
                                                                    let _e2022 = phi_2533_;
                                                                    let _e2026 = (_e2022.x - (_e1369 * _e2022.z));
                                                                    let _e2030 = (_e2022.y - (_e1372 * _e2022.z));
                                                                    let _e2032 = triangles.member[(0u + _e1973)].v2_;
                                                                    let _e2034 = (_e2032.x - _e1072);
                                                                    let _e2036 = (_e2032.y - _e1085);
                                                                    let _e2038 = (_e2032.z - _e1098);
                                                                    if (_e1358 == 0u) {
                                                                        phi_2563_ = vec3<f32>(_e2036, _e2038, _e2034);
                                                                    } else {
                                                                        if (_e1358 == 1u) {
                                                                            phi_2562_ = vec3<f32>(_e2038, _e2034, _e2036);
                                                                        } else {
                                                                            phi_2562_ = (_e2032 - vec3<f32>(_e1072, _e1085, _e1098));
                                                                        }
                                                                        let _e2046 = phi_2562_;
                                                                        phi_2563_ = _e2046;
                                                                    }
                                                                    let _e2048 = phi_2563_;
                                                                    let _e2052 = (_e2048.x - (_e1369 * _e2048.z));
                                                                    let _e2056 = (_e2048.y - (_e1372 * _e2048.z));
                                                                    if (_e2026 < _e2052) {
                                                                        phi_2582_ = true;
                                                                    } else {
                                                                        if (_e2026 == _e2052) {
                                                                            phi_2581_ = (_e2030 < _e2056);
                                                                        } else {
                                                                            phi_2581_ = false;
                                                                        }
                                                                        let _e2061 = phi_2581_;
                                                                        phi_2582_ = _e2061;
                                                                    }
                                                                    let _e2063 = phi_2582_;
                                                                    if _e2063 {
                                                                        phi_2586_ = _e2056;
                                                                        phi_2587_ = _e2052;
                                                                        phi_2588_ = _e2030;
                                                                        phi_2589_ = _e2026;
                                                                    } else {
                                                                        phi_2586_ = _e2030;
                                                                        phi_2587_ = _e2026;
                                                                        phi_2588_ = _e2056;
                                                                        phi_2589_ = _e2052;
                                                                    }
                                                                    let _e2065 = phi_2586_;
                                                                    let _e2067 = phi_2587_;
                                                                    let _e2069 = phi_2588_;
                                                                    let _e2071 = phi_2589_;
                                                                    let _e2074 = ((_e2071 * _e2065) - (_e2069 * _e2067));
                                                                    if _e2063 {
                                                                        phi_2597_ = -(_e2074);
                                                                    } else {
                                                                        phi_2597_ = _e2074;
                                                                    }
                                                                    let _e2077 = phi_2597_;
                                                                    if (_e2052 < _e2000) {
                                                                        phi_2608_ = true;
                                                                    } else {
                                                                        if (_e2052 == _e2000) {
                                                                            phi_2607_ = (_e2056 < _e2004);
                                                                        } else {
                                                                            phi_2607_ = false;
                                                                        }
                                                                        let _e2082 = phi_2607_;
                                                                        phi_2608_ = _e2082;
                                                                    }
                                                                    let _e2084 = phi_2608_;
                                                                    if _e2084 {
                                                                        phi_2612_ = _e2004;
                                                                        phi_2613_ = _e2000;
                                                                        phi_2614_ = _e2056;
                                                                        phi_2615_ = _e2052;
                                                                    } else {
                                                                        phi_2612_ = _e2056;
                                                                        phi_2613_ = _e2052;
                                                                        phi_2614_ = _e2004;
                                                                        phi_2615_ = _e2000;
                                                                    }
                                                                    let _e2086 = phi_2612_;
                                                                    let _e2088 = phi_2613_;
                                                                    let _e2090 = phi_2614_;
                                                                    let _e2092 = phi_2615_;
                                                                    let _e2095 = ((_e2092 * _e2086) - (_e2090 * _e2088));
                                                                    if _e2084 {
                                                                        phi_2623_ = -(_e2095);
                                                                    } else {
                                                                        phi_2623_ = _e2095;
                                                                    }
                                                                    let _e2098 = phi_2623_;
                                                                    if (_e2000 < _e2026) {
                                                                        phi_2634_ = true;
                                                                    } else {
                                                                        if (_e2000 == _e2026) {
                                                                            phi_2633_ = (_e2004 < _e2030);
                                                                        } else {
                                                                            phi_2633_ = false;
                                                                        }
                                                                        let _e2103 = phi_2633_;
                                                                        phi_2634_ = _e2103;
                                                                    }
                                                                    let _e2105 = phi_2634_;
                                                                    if _e2105 {
                                                                        phi_2638_ = _e2030;
                                                                        phi_2639_ = _e2026;
                                                                        phi_2640_ = _e2004;
                                                                        phi_2641_ = _e2000;
                                                                    } else {
                                                                        phi_2638_ = _e2004;
                                                                        phi_2639_ = _e2000;
                                                                        phi_2640_ = _e2030;
                                                                        phi_2641_ = _e2026;
                                                                    }
                                                                    let _e2107 = phi_2638_;
                                                                    let _e2109 = phi_2639_;
                                                                    let _e2111 = phi_2640_;
                                                                    let _e2113 = phi_2641_;
                                                                    let _e2116 = ((_e2113 * _e2107) - (_e2111 * _e2109));
                                                                    if _e2105 {
                                                                        phi_2649_ = -(_e2116);
                                                                    } else {
                                                                        phi_2649_ = _e2116;
                                                                    }
                                                                    let _e2119 = phi_2649_;
                                                                    if (_e2077 >= 0f) {
                                                                        if (_e2098 >= 0f) {
                                                                            if (_e2119 >= 0f) {
                                                                                phi_2664_ = ((_e2077 + _e2098) + _e2119);
                                                                                phi_2665_ = false;
                                                                            } else {
                                                                                phi_2664_ = f32();
                                                                                phi_2665_ = true;
                                                                            }
                                                                            let _e2126 = phi_2664_;
                                                                            let _e2128 = phi_2665_;
                                                                            phi_2666_ = _e2126;
                                                                            phi_2667_ = _e2128;
                                                                        } else {
                                                                            phi_2666_ = f32();
                                                                            phi_2667_ = true;
                                                                        }
                                                                        let _e2130 = phi_2666_;
                                                                        let _e2132 = phi_2667_;
                                                                        phi_2668_ = _e2130;
                                                                        phi_2669_ = _e2132;
                                                                    } else {
                                                                        phi_2668_ = f32();
                                                                        phi_2669_ = true;
                                                                    }
                                                                    let _e2134 = phi_2668_;
                                                                    let _e2136 = phi_2669_;
                                                                    if _e2136 {
                                                                        if (_e2077 <= 0f) {
                                                                            if (_e2098 <= 0f) {
                                                                                let _e2139 = (_e2119 <= 0f);
                                                                                if _e2139 {
                                                                                }
                                                                                phi_2687_ = ((_e2077 + _e2098) + _e2119);
                                                                                phi_2688_ = false;
                                                                                phi_2689_ = _e2139;
                                                                            } else {
                                                                                phi_2687_ = f32();
                                                                                phi_2688_ = true;
                                                                                phi_2689_ = false;
                                                                            }
                                                                            let _e2143 = phi_2687_;
                                                                            let _e2145 = phi_2688_;
                                                                            let _e2147 = phi_2689_;
                                                                            phi_2690_ = _e2143;
                                                                            phi_2691_ = _e2145;
                                                                            phi_2692_ = _e2147;
                                                                        } else {
                                                                            phi_2690_ = f32();
                                                                            phi_2691_ = true;
                                                                            phi_2692_ = false;
                                                                        }
                                                                        let _e2149 = phi_2690_;
                                                                        let _e2151 = phi_2691_;
                                                                        let _e2153 = phi_2692_;
                                                                        if _e2151 {
                                                                            phi_2696_ = false;
                                                                        } else {
                                                                            phi_2696_ = _e2153;
                                                                        }
                                                                        let _e2155 = phi_2696_;
                                                                        phi_2697_ = _e2149;
                                                                        phi_2698_ = _e2155;
                                                                    } else {
                                                                        phi_2697_ = _e2134;
                                                                        phi_2698_ = true;
                                                                    }
                                                                    let _e2157 = phi_2697_;
                                                                    let _e2159 = phi_2698_;
                                                                    if _e2159 {
                                                                        let _e2160 = (_e2157 == 0f);
                                                                        if _e2160 {
                                                                            phi_3014_ = lt_bvh_triangle_Intersection();
                                                                            phi_3015_ = false;
                                                                        } else {
                                                                            let _e2162 = triangles.member[(0u + _e1973)].v0_;
                                                                            let _e2164 = (_e2162.x - _e1072);
                                                                            let _e2166 = (_e2162.y - _e1085);
                                                                            let _e2168 = (_e2162.z - _e1098);
                                                                            if (_e1358 == 0u) {
                                                                                phi_2727_ = vec3<f32>(_e2166, _e2168, _e2164);
                                                                            } else {
                                                                                if (_e1358 == 1u) {
                                                                                    phi_2726_ = vec3<f32>(_e2168, _e2164, _e2166);
                                                                                } else {
                                                                                    phi_2726_ = (_e2162 - vec3<f32>(_e1072, _e1085, _e1098));
                                                                                }
                                                                                let _e2176 = phi_2726_;
                                                                                phi_2727_ = _e2176;
                                                                            }
                                                                            let _e2178 = phi_2727_;
                                                                            let _e2180 = triangles.member[(0u + _e1973)].v1_;
                                                                            let _e2182 = triangles.member[(0u + _e1973)].v0_;
                                                                            let _e2185 = (_e2180.x - _e2182.x);
                                                                            let _e2188 = (_e2180.y - _e2182.y);
                                                                            let _e2191 = (_e2180.z - _e2182.z);
                                                                            if (_e1358 == 0u) {
                                                                                phi_2753_ = vec3<f32>(_e2188, _e2191, _e2185);
                                                                            } else {
                                                                                if (_e1358 == 1u) {
                                                                                    phi_2752_ = vec3<f32>(_e2191, _e2185, _e2188);
                                                                                } else {
                                                                                    phi_2752_ = (_e2180 - _e2182);
                                                                                }
                                                                                let _e2198 = phi_2752_;
                                                                                phi_2753_ = _e2198;
                                                                            }
                                                                            let _e2200 = phi_2753_;
                                                                            let _e2202 = triangles.member[(0u + _e1973)].v2_;
                                                                            let _e2204 = triangles.member[(0u + _e1973)].v0_;
                                                                            let _e2207 = (_e2202.x - _e2204.x);
                                                                            let _e2210 = (_e2202.y - _e2204.y);
                                                                            let _e2213 = (_e2202.z - _e2204.z);
                                                                            if (_e1358 == 0u) {
                                                                                phi_2779_ = vec3<f32>(_e2210, _e2213, _e2207);
                                                                            } else {
                                                                                if (_e1358 == 1u) {
                                                                                    phi_2778_ = vec3<f32>(_e2213, _e2207, _e2210);
                                                                                } else {
                                                                                    phi_2778_ = (_e2202 - _e2204);
                                                                                }
                                                                                let _e2220 = phi_2778_;
                                                                                phi_2779_ = _e2220;
                                                                            }
                                                                            let _e2222 = phi_2779_;
                                                                            let _e2229 = ((_e2200.y * _e2222.z) - (_e2200.z * _e2222.y));
                                                                            let _e2236 = ((_e2200.z * _e2222.x) - (_e2200.x * _e2222.z));
                                                                            let _e2243 = ((_e2200.x * _e2222.y) - (_e2200.y * _e2222.x));
                                                                            let _e2257 = (((1f / _e1366.z) * (((_e2229 * _e2178.x) + (_e2236 * _e2178.y)) + (_e2243 * _e2178.z))) / (((_e2229 * _e1369) + (_e2236 * _e1372)) + _e2243));
                                                                            if (_e2257 > _e165.tmin) {
                                                                                if (_e2257 < _e165.tmax) {
                                                                                    let _e2261 = triangles.member[(0u + _e1973)].v0_;
                                                                                    let _e2263 = triangles.member[(0u + _e1973)].v1_;
                                                                                    if (_e2261.x < _e2263.x) {
                                                                                        phi_2835_ = _e2261.x;
                                                                                    } else {
                                                                                        phi_2835_ = _e2263.x;
                                                                                    }
                                                                                    let _e2270 = phi_2835_;
                                                                                    if (_e2261.y < _e2263.y) {
                                                                                        phi_2844_ = _e2261.y;
                                                                                    } else {
                                                                                        phi_2844_ = _e2263.y;
                                                                                    }
                                                                                    let _e2277 = phi_2844_;
                                                                                    if (_e2261.z < _e2263.z) {
                                                                                        phi_2853_ = _e2261.z;
                                                                                    } else {
                                                                                        phi_2853_ = _e2263.z;
                                                                                    }
                                                                                    let _e2284 = phi_2853_;
                                                                                    let _e2286 = triangles.member[(0u + _e1973)].v2_;
                                                                                    if (_e2270 < _e2286.x) {
                                                                                        phi_2862_ = _e2270;
                                                                                    } else {
                                                                                        phi_2862_ = _e2286.x;
                                                                                    }
                                                                                    let _e2291 = phi_2862_;
                                                                                    if (_e2277 < _e2286.y) {
                                                                                        phi_2869_ = _e2277;
                                                                                    } else {
                                                                                        phi_2869_ = _e2286.y;
                                                                                    }
                                                                                    let _e2296 = phi_2869_;
                                                                                    if (_e2284 < _e2286.z) {
                                                                                        phi_2876_ = _e2284;
                                                                                    } else {
                                                                                        phi_2876_ = _e2286.z;
                                                                                    }
                                                                                    let _e2301 = phi_2876_;
                                                                                    let _e2303 = triangles.member[(0u + _e1973)].v0_;
                                                                                    let _e2305 = triangles.member[(0u + _e1973)].v1_;
                                                                                    if (_e2303.x > _e2305.x) {
                                                                                        phi_2889_ = _e2303.x;
                                                                                    } else {
                                                                                        phi_2889_ = _e2305.x;
                                                                                    }
                                                                                    let _e2312 = phi_2889_;
                                                                                    if (_e2303.y > _e2305.y) {
                                                                                        phi_2898_ = _e2303.y;
                                                                                    } else {
                                                                                        phi_2898_ = _e2305.y;
                                                                                    }
                                                                                    let _e2319 = phi_2898_;
                                                                                    if (_e2303.z > _e2305.z) {
                                                                                        phi_2907_ = _e2303.z;
                                                                                    } else {
                                                                                        phi_2907_ = _e2305.z;
                                                                                    }
                                                                                    let _e2326 = phi_2907_;
                                                                                    let _e2328 = triangles.member[(0u + _e1973)].v2_;
                                                                                    if (_e2312 > _e2328.x) {
                                                                                        phi_2916_ = _e2312;
                                                                                    } else {
                                                                                        phi_2916_ = _e2328.x;
                                                                                    }
                                                                                    let _e2333 = phi_2916_;
                                                                                    if (_e2319 > _e2328.y) {
                                                                                        phi_2923_ = _e2319;
                                                                                    } else {
                                                                                        phi_2923_ = _e2328.y;
                                                                                    }
                                                                                    let _e2338 = phi_2923_;
                                                                                    if (_e2326 > _e2328.z) {
                                                                                        phi_2930_ = _e2326;
                                                                                    } else {
                                                                                        phi_2930_ = _e2328.z;
                                                                                    }
                                                                                    let _e2343 = phi_2930_;
                                                                                    let _e2347 = ((_e2291 - _e1072) * _e1287);
                                                                                    let _e2348 = ((_e2296 - _e1085) * _e1297);
                                                                                    let _e2349 = ((_e2301 - _e1098) * _e1307);
                                                                                    let _e2353 = ((_e2333 - _e1072) * _e1287);
                                                                                    let _e2354 = ((_e2338 - _e1085) * _e1297);
                                                                                    let _e2355 = ((_e2343 - _e1098) * _e1307);
                                                                                    if (_e2347 < _e2353) {
                                                                                        phi_2947_ = _e2347;
                                                                                    } else {
                                                                                        phi_2947_ = _e2353;
                                                                                    }
                                                                                    let _e2358 = phi_2947_;
                                                                                    if (_e2348 < _e2354) {
                                                                                        phi_2952_ = _e2348;
                                                                                    } else {
                                                                                        phi_2952_ = _e2354;
                                                                                    }
                                                                                    let _e2361 = phi_2952_;
                                                                                    if (_e2349 < _e2355) {
                                                                                        phi_2957_ = _e2349;
                                                                                    } else {
                                                                                        phi_2957_ = _e2355;
                                                                                    }
                                                                                    let _e2364 = phi_2957_;
                                                                                    if (_e2347 > _e2353) {
                                                                                        phi_2965_ = _e2347;
                                                                                    } else {
                                                                                        phi_2965_ = _e2353;
                                                                                    }
                                                                                    let _e2370 = phi_2965_;
                                                                                    if (_e2348 > _e2354) {
                                                                                        phi_2970_ = _e2348;
                                                                                    } else {
                                                                                        phi_2970_ = _e2354;
                                                                                    }
                                                                                    let _e2373 = phi_2970_;
                                                                                    if (_e2349 > _e2355) {
                                                                                        phi_2975_ = _e2349;
                                                                                    } else {
                                                                                        phi_2975_ = _e2355;
                                                                                    }
                                                                                    let _e2376 = phi_2975_;
                                                                                    let _e2380 = core_intrinsics_maximum_number_nsz_f32_((_e2358 - _e1342), (_e2361 - _e1343));
                                                                                    let _e2381 = core_intrinsics_maximum_number_nsz_f32_(_e2380, (_e2364 - _e1344));
                                                                                    let _e2382 = core_intrinsics_minimum_number_nsz_f32_((_e2370 + _e1342), (_e2373 + _e1343));
                                                                                    let _e2383 = core_intrinsics_minimum_number_nsz_f32_(_e2382, (_e2376 + _e1344));
                                                                                    if (_e2381 > _e1047) {
                                                                                        phi_2987_ = _e2381;
                                                                                    } else {
                                                                                        phi_2987_ = _e1047;
                                                                                    }
                                                                                    let _e2386 = phi_2987_;
                                                                                    if (_e2383 < _e1049) {
                                                                                        phi_2992_ = _e2383;
                                                                                    } else {
                                                                                        phi_2992_ = _e1049;
                                                                                    }
                                                                                    let _e2389 = phi_2992_;
                                                                                    if (_e2257 < _e2386) {
                                                                                        phi_2997_ = _e2386;
                                                                                    } else {
                                                                                        phi_2997_ = _e2257;
                                                                                    }
                                                                                    let _e2392 = phi_2997_;
                                                                                    if (_e2392 > _e2389) {
                                                                                        phi_3002_ = _e2389;
                                                                                    } else {
                                                                                        phi_3002_ = _e2392;
                                                                                    }
                                                                                    let _e2395 = phi_3002_;
                                                                                    phi_3007_ = lt_bvh_triangle_Intersection(_e2395, (_e2098 / _e2157), (_e2119 / _e2157), (_e2386 <= _e2389));
                                                                                    phi_3008_ = false;
                                                                                } else {
                                                                                    phi_3007_ = lt_bvh_triangle_Intersection();
                                                                                    phi_3008_ = true;
                                                                                }
                                                                                let _e2401 = phi_3007_;
                                                                                let _e2403 = phi_3008_;
                                                                                phi_3009_ = _e2401;
                                                                                phi_3010_ = _e2403;
                                                                            } else {
                                                                                phi_3009_ = lt_bvh_triangle_Intersection();
                                                                                phi_3010_ = true;
                                                                            }
                                                                            let _e2405 = phi_3009_;
                                                                            let _e2407 = phi_3010_;
                                                                            if _e2407 {
                                                                            }
                                                                            phi_3014_ = _e2405;
                                                                            phi_3015_ = _e2407;
                                                                        }
                                                                        let _e2409 = phi_3014_;
                                                                        let _e2411 = phi_3015_;
                                                                        phi_3016_ = _e2409;
                                                                        phi_3017_ = _e2160;
                                                                        phi_3018_ = _e2411;
                                                                    } else {
                                                                        phi_3016_ = lt_bvh_triangle_Intersection();
                                                                        phi_3017_ = true;
                                                                        phi_3018_ = false;
                                                                    }
                                                                    let _e2413 = phi_3016_;
                                                                    let _e2415 = phi_3017_;
                                                                    let _e2417 = phi_3018_;
                                                                    if _e2415 {
                                                                        phi_3022_ = true;
                                                                    } else {
                                                                        phi_3022_ = _e2417;
                                                                    }
                                                                    let _e2419 = phi_3022_;
                                                                    if _e2419 {
                                                                        phi_3026_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_3026_ = _e2413;
                                                                    }
                                                                    let _e2421 = phi_3026_;
                                                                    if _e2421.is_hit {
                                                                        if (_e2421.t > _e165.tmin) {
                                                                            if (_e2421.t < _e1962.t) {
                                                                                phi_3074_ = true;
                                                                            } else {
                                                                                if (_e2421.t == _e1962.t) {
                                                                                    if (_e1962.triangle != 4294967295u) {
                                                                                        if (_e1973 < _e1962.triangle) {
                                                                                            phi_3065_ = true;
                                                                                        } else {
                                                                                            if (_e1973 == _e1962.triangle) {
                                                                                                phi_3064_ = (_e988 < _e1962.instance);
                                                                                            } else {
                                                                                                phi_3064_ = false;
                                                                                            }
                                                                                            let _e2439 = phi_3064_;
                                                                                            phi_3065_ = _e2439;
                                                                                        }
                                                                                        let _e2441 = phi_3065_;
                                                                                        phi_3066_ = _e2441;
                                                                                        phi_3067_ = false;
                                                                                    } else {
                                                                                        phi_3066_ = bool();
                                                                                        phi_3067_ = true;
                                                                                    }
                                                                                    let _e2443 = phi_3066_;
                                                                                    let _e2445 = phi_3067_;
                                                                                    phi_3068_ = _e2443;
                                                                                    phi_3069_ = _e2445;
                                                                                } else {
                                                                                    phi_3068_ = bool();
                                                                                    phi_3069_ = true;
                                                                                }
                                                                                let _e2447 = phi_3068_;
                                                                                let _e2449 = phi_3069_;
                                                                                if _e2449 {
                                                                                    phi_3073_ = false;
                                                                                } else {
                                                                                    phi_3073_ = _e2447;
                                                                                }
                                                                                let _e2451 = phi_3073_;
                                                                                phi_3074_ = _e2451;
                                                                            }
                                                                            let _e2453 = phi_3074_;
                                                                            if _e2453 {
                                                                                let _e2455 = triangles.member[(0u + _e1973)].i0_;
                                                                                if ((_e2455 & 2147483648u) == 0u) {
                                                                                    phi_3088_ = true;
                                                                                } else {
                                                                                    if true {
                                                                                    }
                                                                                    phi_3088_ = true;
                                                                                }
                                                                                let _e2459 = phi_3088_;
                                                                                if _e2459 {
                                                                                    phi_3096_ = lt_bvh_Hit(_e2421.t, _e2421.u, _e2421.v, _e1973, _e988);
                                                                                } else {
                                                                                    phi_3096_ = _e1962;
                                                                                }
                                                                                let _e2465 = phi_3096_;
                                                                                phi_3097_ = _e2465;
                                                                            } else {
                                                                                phi_3097_ = _e1962;
                                                                            }
                                                                            let _e2467 = phi_3097_;
                                                                            phi_3098_ = _e2467;
                                                                        } else {
                                                                            phi_3098_ = _e1962;
                                                                        }
                                                                        let _e2469 = phi_3098_;
                                                                        phi_3099_ = _e2469;
                                                                    } else {
                                                                        phi_3099_ = _e1962;
                                                                    }
                                                                    let _e2471 = phi_3099_;
                                                                    phi_2456_ = _e2471;
                                                                    phi_2459_ = (_e1964 & (_e1964 - 1u));
                                                                    phi_3100_ = true;
                                                                }
                                                                let _e2473 = phi_2456_;
                                                                let _e2475 = phi_2459_;
                                                                let _e2477 = phi_3100_;
                                                                continue;
                                                                continuing {
                                                                    phi_2455_ = _e2473;
                                                                    phi_2458_ = _e2475;
                                                                    break if !(_e2477);
                                                                }
                                                            }
                                                            let _e2480 = local_1.group_mask;
                                                            if ((_e2480 & 4278190080u) == 0u) {
                                                                let _e2484 = local_1.len;
                                                                if (_e2484 == 0u) {
                                                                    phi_3139_ = false;
                                                                } else {
                                                                    let _e2488 = local_1.len;
                                                                    local_1.len = (_e2488 - 1u);
                                                                    let _e2491 = local_1.len;
                                                                    if (_e2491 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2496 = local_1.first[(0u + _e2491)];
                                                                    local_1.group = _e2496;
                                                                    let _e2499 = local_1.len;
                                                                    if (_e2499 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2504 = local_1.mask[(0u + _e2499)];
                                                                    local_1.group_mask = _e2504;
                                                                    phi_3139_ = true;
                                                                }
                                                                let _e2507 = phi_3139_;
                                                                phi_3140_ = _e2507;
                                                            } else {
                                                                phi_3140_ = true;
                                                            }
                                                            let _e2509 = phi_3140_;
                                                            if _e2509 {
                                                                let _e2511 = local_1.group_mask;
                                                                let _e2517 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2511)), 32u, (_e2511 == 0u)));
                                                                let _e2521 = local_1.group_mask;
                                                                let _e2535 = local_1.group_mask;
                                                                local_1.group_mask = (_e2535 & ~((1u << bitcast<u32>((_e2517 & 31u)))));
                                                                let _e2538 = local_1.group;
                                                                phi_3171_ = (_e2538 + countOneBits(((_e2521 & ~((4294967295u << bitcast<u32>((((_e2517 - 24u) ^ _e1385) & 31u))))) & 255u)));
                                                            } else {
                                                                phi_3171_ = 4294967295u;
                                                            }
                                                            let _e2541 = phi_3171_;
                                                            let _e3864 = local_9;
                                                            phi_2123_ = _e3864;
                                                            phi_2126_ = _e2541;
                                                        } else {
                                                            phi_2123_ = lt_bvh_Hit();
                                                            phi_2126_ = u32();
                                                        }
                                                        let _e2543 = phi_2123_;
                                                        let _e2545 = phi_2126_;
                                                        continue;
                                                        continuing {
                                                            phi_2122_ = _e2543;
                                                            phi_2125_ = _e2545;
                                                            break if !(_e1526);
                                                        }
                                                    }
                                                    let _e3868 = local_10;
                                                    phi_3172_ = _e3868;
                                                }
                                                let _e2548 = phi_3172_;
                                                phi_3173_ = _e2548;
                                                phi_3174_ = _e1211;
                                            } else {
                                                phi_3173_ = lt_bvh_Hit();
                                                phi_3174_ = true;
                                            }
                                            let _e2550 = phi_3173_;
                                            let _e2552 = phi_3174_;
                                            if _e2552 {
                                                phi_3178_ = _e980;
                                            } else {
                                                phi_3178_ = _e2550;
                                            }
                                            let _e2554 = phi_3178_;
                                            phi_3179_ = _e2554;
                                        } else {
                                            phi_3179_ = _e980;
                                        }
                                        let _e2556 = phi_3179_;
                                        phi_3180_ = _e2556;
                                    } else {
                                        phi_3180_ = _e980;
                                    }
                                    let _e2558 = phi_3180_;
                                    phi_3181_ = _e2558;
                                } else {
                                    phi_3181_ = _e980;
                                }
                                let _e2560 = phi_3181_;
                                phi_1497_ = (_e978 & (_e978 - 1u));
                                phi_1500_ = _e2560;
                                phi_3182_ = true;
                            }
                            let _e2562 = phi_1497_;
                            let _e2564 = phi_1500_;
                            let _e2566 = phi_3182_;
                            continue;
                            continuing {
                                phi_1496_ = _e2562;
                                phi_1499_ = _e2564;
                                break if !(_e2566);
                            }
                        }
                        let _e2569 = local_2.group_mask;
                        if ((_e2569 & 4278190080u) == 0u) {
                            let _e2573 = local_2.len;
                            if (_e2573 == 0u) {
                                phi_3221_ = false;
                            } else {
                                let _e2577 = local_2.len;
                                local_2.len = (_e2577 - 1u);
                                let _e2580 = local_2.len;
                                if (_e2580 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2585 = local_2.first[(0u + _e2580)];
                                local_2.group = _e2585;
                                let _e2588 = local_2.len;
                                if (_e2588 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2593 = local_2.mask[(0u + _e2588)];
                                local_2.group_mask = _e2593;
                                phi_3221_ = true;
                            }
                            let _e2596 = phi_3221_;
                            phi_3222_ = _e2596;
                        } else {
                            phi_3222_ = true;
                        }
                        let _e2598 = phi_3222_;
                        if _e2598 {
                            let _e2600 = local_2.group_mask;
                            let _e2606 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2600)), 32u, (_e2600 == 0u)));
                            let _e2610 = local_2.group_mask;
                            let _e2624 = local_2.group_mask;
                            local_2.group_mask = (_e2624 & ~((1u << bitcast<u32>((_e2606 & 31u)))));
                            let _e2627 = local_2.group;
                            phi_3253_ = (_e2627 + countOneBits(((_e2610 & ~((4294967295u << bitcast<u32>((((_e2606 - 24u) ^ _e397) & 31u))))) & 255u)));
                        } else {
                            phi_3253_ = 4294967295u;
                        }
                        let _e2630 = phi_3253_;
                        phi_1160_ = _e2630;
                        let _e3884 = local_11;
                        phi_1163_ = _e3884;
                    } else {
                        phi_1160_ = u32();
                        phi_1163_ = lt_bvh_Hit();
                    }
                    let _e2632 = phi_1160_;
                    let _e2634 = phi_1163_;
                    continue;
                    continuing {
                        phi_1159_ = _e2632;
                        phi_1162_ = _e2634;
                        break if !(_e538);
                    }
                }
                let _e3887 = local_12;
                phi_3254_ = _e3887;
            }
            let _e2637 = phi_3254_;
            phi_3255_ = _e2637;
            phi_3256_ = _e237;
        } else {
            phi_3255_ = lt_bvh_Hit();
            phi_3256_ = true;
        }
        let _e2639 = phi_3255_;
        let _e2641 = phi_3256_;
        if _e2641 {
            phi_3260_ = _e167;
        } else {
            phi_3260_ = _e2639;
        }
        let _e2643 = phi_3260_;
        if (_e2643.triangle != 4294967295u) {
            let _e2649 = ((1f - _e2643.u) - _e2643.v);
            if (_e2643.triangle < _e81) {
            } else {
                return;
            }
            let _e2654 = triangles.member[(0u + _e2643.triangle)];
            if (_e2643.instance < _e93) {
            } else {
                return;
            }
            let _e2665 = instances.member[(0u + _e2643.instance)].object_to_world[0u];
            let _e2676 = ((((_e2665.x * _e2654.v0_.x) + (_e2665.y * _e2654.v0_.y)) + (_e2665.z * _e2654.v0_.z)) + (_e2665.w * 1f));
            let _e2678 = instances.member[(0u + _e2643.instance)].object_to_world[1u];
            let _e2689 = ((((_e2678.x * _e2654.v0_.x) + (_e2678.y * _e2654.v0_.y)) + (_e2678.z * _e2654.v0_.z)) + (_e2678.w * 1f));
            let _e2691 = instances.member[(0u + _e2643.instance)].object_to_world[2u];
            let _e2702 = ((((_e2691.x * _e2654.v0_.x) + (_e2691.y * _e2654.v0_.y)) + (_e2691.z * _e2654.v0_.z)) + (_e2691.w * 1f));
            let _e2709 = instances.member[(0u + _e2643.instance)].object_to_world[0u];
            let _e2720 = ((((_e2709.x * _e2654.v1_.x) + (_e2709.y * _e2654.v1_.y)) + (_e2709.z * _e2654.v1_.z)) + (_e2709.w * 1f));
            let _e2722 = instances.member[(0u + _e2643.instance)].object_to_world[1u];
            let _e2733 = ((((_e2722.x * _e2654.v1_.x) + (_e2722.y * _e2654.v1_.y)) + (_e2722.z * _e2654.v1_.z)) + (_e2722.w * 1f));
            let _e2735 = instances.member[(0u + _e2643.instance)].object_to_world[2u];
            let _e2746 = ((((_e2735.x * _e2654.v1_.x) + (_e2735.y * _e2654.v1_.y)) + (_e2735.z * _e2654.v1_.z)) + (_e2735.w * 1f));
            let _e2753 = instances.member[(0u + _e2643.instance)].object_to_world[0u];
            let _e2764 = ((((_e2753.x * _e2654.v2_.x) + (_e2753.y * _e2654.v2_.y)) + (_e2753.z * _e2654.v2_.z)) + (_e2753.w * 1f));
            let _e2766 = instances.member[(0u + _e2643.instance)].object_to_world[1u];
            let _e2777 = ((((_e2766.x * _e2654.v2_.x) + (_e2766.y * _e2654.v2_.y)) + (_e2766.z * _e2654.v2_.z)) + (_e2766.w * 1f));
            let _e2779 = instances.member[(0u + _e2643.instance)].object_to_world[2u];
            let _e2790 = ((((_e2779.x * _e2654.v2_.x) + (_e2779.y * _e2654.v2_.y)) + (_e2779.z * _e2654.v2_.z)) + (_e2779.w * 1f));
            let _e2803 = (((_e2676 * _e2649) + (_e2720 * _e2643.u)) + (_e2764 * _e2643.v));
            let _e2804 = (((_e2689 * _e2649) + (_e2733 * _e2643.u)) + (_e2777 * _e2643.v));
            let _e2805 = (((_e2702 * _e2649) + (_e2746 * _e2643.u)) + (_e2790 * _e2643.v));
            let _e2807 = abs(_e2676);
            let _e2808 = abs(_e2689);
            let _e2809 = abs(_e2702);
            let _e2810 = abs(_e2720);
            let _e2811 = abs(_e2733);
            let _e2812 = abs(_e2746);
            if (_e2807 > _e2810) {
                phi_3447_ = _e2807;
            } else {
                phi_3447_ = _e2810;
            }
            let _e2815 = phi_3447_;
            if (_e2808 > _e2811) {
                phi_3452_ = _e2808;
            } else {
                phi_3452_ = _e2811;
            }
            let _e2818 = phi_3452_;
            if (_e2809 > _e2812) {
                phi_3457_ = _e2809;
            } else {
                phi_3457_ = _e2812;
            }
            let _e2821 = phi_3457_;
            let _e2822 = abs(_e2764);
            let _e2823 = abs(_e2777);
            let _e2824 = abs(_e2790);
            if (_e2815 > _e2822) {
                phi_3465_ = _e2815;
            } else {
                phi_3465_ = _e2822;
            }
            let _e2827 = phi_3465_;
            if (_e2818 > _e2823) {
                phi_3470_ = _e2818;
            } else {
                phi_3470_ = _e2823;
            }
            let _e2830 = phi_3470_;
            if (_e2821 > _e2824) {
                phi_3475_ = _e2821;
            } else {
                phi_3475_ = _e2824;
            }
            let _e2833 = phi_3475_;
            let _e2834 = (_e2720 - _e2676);
            let _e2835 = (_e2733 - _e2689);
            let _e2836 = (_e2746 - _e2702);
            let _e2837 = (_e2764 - _e2676);
            let _e2838 = (_e2777 - _e2689);
            let _e2839 = (_e2790 - _e2702);
            let _e2843 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2835), abs(_e2836));
            let _e2844 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2834), _e2843);
            let _e2845 = (_e2834 / _e2844);
            let _e2846 = (_e2835 / _e2844);
            let _e2847 = (_e2836 / _e2844);
            let _e2851 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2838), abs(_e2839));
            let _e2852 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2837), _e2851);
            let _e2853 = (_e2837 / _e2852);
            let _e2854 = (_e2838 / _e2852);
            let _e2855 = (_e2839 / _e2852);
            let _e2858 = ((_e2846 * _e2855) - (_e2854 * _e2847));
            let _e2861 = ((_e2847 * _e2853) - (_e2855 * _e2845));
            let _e2864 = ((_e2845 * _e2854) - (_e2853 * _e2846));
            let _e2866 = p.member.eye;
            let _e2879 = (1f / sqrt((((_e2858 * _e2858) + (_e2861 * _e2861)) + (_e2864 * _e2864))));
            let _e2880 = (_e2858 * _e2879);
            let _e2881 = (_e2861 * _e2879);
            let _e2882 = (_e2864 * _e2879);
            if ((((_e2880 * (_e2866.x - _e2803)) + (_e2881 * (_e2866.y - _e2804))) + (_e2882 * (_e2866.z - _e2805))) < 0f) {
                phi_3539_ = vec3<f32>(-(_e2880), -(_e2881), -(_e2882));
            } else {
                phi_3539_ = vec3<f32>(_e2880, _e2881, _e2882);
            }
            let _e2895 = phi_3539_;
            if (_e2643.triangle < _e81) {
            } else {
                return;
            }
            let _e2900 = triangles.member[(0u + _e2643.triangle)];
            let _e2902 = (_e2900.i0_ & 2147483647u);
            if (_e2902 < _e84) {
            } else {
                return;
            }
            let _e2908 = vertices.member[(0u + _e2902)];
            if (_e2900.i1_ < _e84) {
            } else {
                return;
            }
            let _e2912 = vertices.member[(0u + _e2900.i1_)];
            if (_e2900.i2_ < _e84) {
            } else {
                return;
            }
            let _e2916 = vertices.member[(0u + _e2900.i2_)];
            let _e2917 = array<abi_Vertex, 3>(_e2908, _e2912, _e2916);
            if (_e2917[0].material < arrayLength((&materials.member))) {
            } else {
                return;
            }
            let _e2923 = materials.member[(0u + _e2917[0].material)];
            let _e2940 = (1f / 255f);
            let _e2959 = (1f / 255f);
            let _e2981 = (1f / 255f);
            if (_e2923.color_size == 0u) {
                phi_3782_ = vec3<f32>(1f, 1f, 1f);
            } else {
                local.offset = _e2923.color_offset;
                local.size = _e2923.color_size;
                local.flags = _e2923.flags;
                let _e3024 = _lt_shaders_texture_TextureView_quad((&local), (((_e2917[0].u * _e2649) + (_e2917[1].u * _e2643.u)) + (_e2917[2].u * _e2643.v)), (((_e2917[0].v * _e2649) + (_e2917[1].v * _e2643.u)) + (_e2917[2].v * _e2643.v)));
                if (_e3024.indices[0] < _e96) {
                } else {
                    return;
                }
                let _e3030 = color_texels.member[(0u + _e3024.indices[0])];
                let _e3041 = (1f / 255f);
                if (_e3024.indices[1] < _e96) {
                } else {
                    return;
                }
                let _e3055 = color_texels.member[(0u + _e3024.indices[1])];
                let _e3066 = (1f / 255f);
                if (_e3024.indices[2] < _e96) {
                } else {
                    return;
                }
                let _e3083 = color_texels.member[(0u + _e3024.indices[2])];
                let _e3094 = (1f / 255f);
                if (_e3024.indices[3] < _e96) {
                } else {
                    return;
                }
                let _e3111 = color_texels.member[(0u + _e3024.indices[3])];
                let _e3122 = (1f / 255f);
                let _e3131 = (((((f32((_e3030 & 255u)) * _e3041) * _e3024.weights.x) + ((f32((_e3055 & 255u)) * _e3066) * _e3024.weights.y)) + ((f32((_e3083 & 255u)) * _e3094) * _e3024.weights.z)) + ((f32((_e3111 & 255u)) * _e3122) * _e3024.weights.w));
                let _e3132 = (((((f32(((_e3030 >> bitcast<u32>(8i)) & 255u)) * _e3041) * _e3024.weights.x) + ((f32(((_e3055 >> bitcast<u32>(8i)) & 255u)) * _e3066) * _e3024.weights.y)) + ((f32(((_e3083 >> bitcast<u32>(8i)) & 255u)) * _e3094) * _e3024.weights.z)) + ((f32(((_e3111 >> bitcast<u32>(8i)) & 255u)) * _e3122) * _e3024.weights.w));
                let _e3133 = (((((f32(((_e3030 >> bitcast<u32>(16i)) & 255u)) * _e3041) * _e3024.weights.x) + ((f32(((_e3055 >> bitcast<u32>(16i)) & 255u)) * _e3066) * _e3024.weights.y)) + ((f32(((_e3083 >> bitcast<u32>(16i)) & 255u)) * _e3094) * _e3024.weights.z)) + ((f32(((_e3111 >> bitcast<u32>(16i)) & 255u)) * _e3122) * _e3024.weights.w));
                phi_3782_ = vec3<f32>((_e3131 * _e3131), (_e3132 * _e3132), (_e3133 * _e3133));
            }
            let _e3139 = phi_3782_;
            let _e3141 = ((_e2923.base_color.x * ((((f32((_e2917[0].color & 255u)) * _e2940) * _e2649) + ((f32((_e2917[1].color & 255u)) * _e2959) * _e2643.u)) + ((f32((_e2917[2].color & 255u)) * _e2981) * _e2643.v))) * _e3139.x);
            let _e3143 = ((_e2923.base_color.y * ((((f32(((_e2917[0].color >> bitcast<u32>(8i)) & 255u)) * _e2940) * _e2649) + ((f32(((_e2917[1].color >> bitcast<u32>(8i)) & 255u)) * _e2959) * _e2643.u)) + ((f32(((_e2917[2].color >> bitcast<u32>(8i)) & 255u)) * _e2981) * _e2643.v))) * _e3139.y);
            let _e3145 = ((_e2923.base_color.z * ((((f32(((_e2917[0].color >> bitcast<u32>(16i)) & 255u)) * _e2940) * _e2649) + ((f32(((_e2917[1].color >> bitcast<u32>(16i)) & 255u)) * _e2959) * _e2643.u)) + ((f32(((_e2917[2].color >> bitcast<u32>(16i)) & 255u)) * _e2981) * _e2643.v))) * _e3139.z);
            let _e3146 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e2830, _e2833);
            let _e3147 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e2827, _e3146);
            if ((_e2923.flags & 2u) == 0u) {
                phi_3797_ = 0u;
            } else {
                phi_3797_ = 1u;
            }
            let _e3152 = phi_3797_;
            if (_e2917[0].normal == 2147516416u) {
                phi_4027_ = _e2895;
            } else {
                let _e3165 = (f32((bitcast<i32>((_e2917[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3171 = (f32((bitcast<i32>(_e2917[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3175 = ((1f - abs(_e3165)) - abs(_e3171));
                if (_e3175 < 0f) {
                    phi_3824_ = -(_e3175);
                } else {
                    phi_3824_ = 0f;
                }
                let _e3179 = phi_3824_;
                if (_e3165 < 0f) {
                    phi_3831_ = (_e3165 + _e3179);
                } else {
                    phi_3831_ = (_e3165 - _e3179);
                }
                let _e3184 = phi_3831_;
                if (_e3171 < 0f) {
                    phi_3838_ = (_e3171 + _e3179);
                } else {
                    phi_3838_ = (_e3171 - _e3179);
                }
                let _e3189 = phi_3838_;
                let _e3196 = (1f / sqrt((((_e3184 * _e3184) + (_e3189 * _e3189)) + (_e3175 * _e3175))));
                let _e3212 = (f32((bitcast<i32>((_e2917[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3218 = (f32((bitcast<i32>(_e2917[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3222 = ((1f - abs(_e3212)) - abs(_e3218));
                if (_e3222 < 0f) {
                    phi_3873_ = -(_e3222);
                } else {
                    phi_3873_ = 0f;
                }
                let _e3226 = phi_3873_;
                if (_e3212 < 0f) {
                    phi_3880_ = (_e3212 + _e3226);
                } else {
                    phi_3880_ = (_e3212 - _e3226);
                }
                let _e3231 = phi_3880_;
                if (_e3218 < 0f) {
                    phi_3887_ = (_e3218 + _e3226);
                } else {
                    phi_3887_ = (_e3218 - _e3226);
                }
                let _e3236 = phi_3887_;
                let _e3243 = (1f / sqrt((((_e3231 * _e3231) + (_e3236 * _e3236)) + (_e3222 * _e3222))));
                let _e3262 = (f32((bitcast<i32>((_e2917[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3268 = (f32((bitcast<i32>(_e2917[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3272 = ((1f - abs(_e3262)) - abs(_e3268));
                if (_e3272 < 0f) {
                    phi_3925_ = -(_e3272);
                } else {
                    phi_3925_ = 0f;
                }
                let _e3276 = phi_3925_;
                if (_e3262 < 0f) {
                    phi_3932_ = (_e3262 + _e3276);
                } else {
                    phi_3932_ = (_e3262 - _e3276);
                }
                let _e3281 = phi_3932_;
                if (_e3268 < 0f) {
                    phi_3939_ = (_e3268 + _e3276);
                } else {
                    phi_3939_ = (_e3268 - _e3276);
                }
                let _e3286 = phi_3939_;
                let _e3293 = (1f / sqrt((((_e3281 * _e3281) + (_e3286 * _e3286)) + (_e3272 * _e3272))));
                let _e3300 = ((((_e3184 * _e3196) * _e2649) + ((_e3231 * _e3243) * _e2643.u)) + ((_e3281 * _e3293) * _e2643.v));
                let _e3301 = ((((_e3189 * _e3196) * _e2649) + ((_e3236 * _e3243) * _e2643.u)) + ((_e3286 * _e3293) * _e2643.v));
                let _e3302 = ((((_e3175 * _e3196) * _e2649) + ((_e3222 * _e3243) * _e2643.u)) + ((_e3272 * _e3293) * _e2643.v));
                if (_e2643.instance < _e93) {
                } else {
                    return;
                }
                let _e3309 = instances.member[(0u + _e2643.instance)].world_to_object[0u];
                let _e3318 = instances.member[(0u + _e2643.instance)].world_to_object[1u];
                let _e3330 = instances.member[(0u + _e2643.instance)].world_to_object[2u];
                let _e3337 = (((_e3309.x * _e3300) + (_e3318.x * _e3301)) + (_e3330.x * _e3302));
                let _e3338 = (((_e3309.y * _e3300) + (_e3318.y * _e3301)) + (_e3330.y * _e3302));
                let _e3339 = (((_e3309.z * _e3300) + (_e3318.z * _e3301)) + (_e3330.z * _e3302));
                let _e3345 = sqrt((((_e3337 * _e3337) + (_e3338 * _e3338)) + (_e3339 * _e3339)));
                if (_e3345 > 0f) {
                    let _e3347 = (_e3337 / _e3345);
                    let _e3348 = (_e3338 / _e3345);
                    let _e3349 = (_e3339 / _e3345);
                    if ((((_e3347 * _e2895.x) + (_e3348 * _e2895.y)) + (_e3349 * _e2895.z)) < 0f) {
                        phi_4025_ = vec3<f32>(-(_e3347), -(_e3348), -(_e3349));
                    } else {
                        phi_4025_ = vec3<f32>(_e3347, _e3348, _e3349);
                    }
                    let _e3365 = phi_4025_;
                    phi_4026_ = _e3365;
                } else {
                    phi_4026_ = _e2895;
                }
                let _e3367 = phi_4026_;
                phi_4027_ = _e3367;
            }
            let _e3369 = phi_4027_;
            if (_e3141 > 0f) {
                if (_e3141 < 1f) {
                    phi_4036_ = _e3141;
                } else {
                    phi_4036_ = 1f;
                }
                let _e3373 = phi_4036_;
                phi_4037_ = _e3373;
            } else {
                phi_4037_ = 0f;
            }
            let _e3375 = phi_4037_;
            if (_e3143 > 0f) {
                if (_e3143 < 1f) {
                    phi_4047_ = _e3143;
                } else {
                    phi_4047_ = 1f;
                }
                let _e3380 = phi_4047_;
                phi_4048_ = _e3380;
            } else {
                phi_4048_ = 0f;
            }
            let _e3382 = phi_4048_;
            if (_e3145 > 0f) {
                if (_e3145 < 1f) {
                    phi_4058_ = _e3145;
                } else {
                    phi_4058_ = 1f;
                }
                let _e3387 = phi_4058_;
                phi_4059_ = _e3387;
            } else {
                phi_4059_ = 0f;
            }
            let _e3389 = phi_4059_;
            let _e3392 = ((sqrt(_e3375) * 255f) + 0.5f);
            let _e3401 = ((sqrt(_e3382) * 255f) + 0.5f);
            let _e3413 = ((sqrt(_e3389) * 255f) + 0.5f);
            phi_4094_ = abi_Sample(vec3<f32>(_e2803, _e2804, _e2805), _e3147, _e2895, _e3152, _e3369, ((select(select(u32(_e3392), 0u, (_e3392 < bitcast<f32>(0u))), 4294967295u, (_e3392 > bitcast<f32>(1333788671u))) | (select(select(u32(_e3401), 0u, (_e3401 < bitcast<f32>(0u))), 4294967295u, (_e3401 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e3413), 0u, (_e3413 < bitcast<f32>(0u))), 4294967295u, (_e3413 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_4094_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e3427 = phi_4094_;
        if (_e108.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e108.shift)] = _e3427;
        if (_e2643.triangle != 4294967295u) {
            let _e3436 = ((1f - _e2643.u) - _e2643.v);
            if (_e2643.triangle < _e81) {
            } else {
                return;
            }
            let _e3441 = triangles.member[(0u + _e2643.triangle)];
            let _e3443 = (_e3441.i0_ & 2147483647u);
            if (_e3443 < _e99) {
            } else {
                return;
            }
            let _e3449 = before.member[(0u + _e3443)];
            if (_e3441.i1_ < _e99) {
            } else {
                return;
            }
            let _e3453 = before.member[(0u + _e3441.i1_)];
            if (_e3441.i2_ < _e99) {
            } else {
                return;
            }
            let _e3457 = before.member[(0u + _e3441.i2_)];
            if (_e2643.instance < _e93) {
            } else {
                return;
            }
            let _e3467 = instances.member[(0u + _e2643.instance)].object_to_world[0u];
            let _e3480 = instances.member[(0u + _e2643.instance)].object_to_world[1u];
            let _e3493 = instances.member[(0u + _e2643.instance)].object_to_world[2u];
            if (_e2643.instance < _e93) {
            } else {
                return;
            }
            let _e3517 = instances.member[(0u + _e2643.instance)].object_to_world[0u];
            let _e3530 = instances.member[(0u + _e2643.instance)].object_to_world[1u];
            let _e3543 = instances.member[(0u + _e2643.instance)].object_to_world[2u];
            if (_e2643.instance < _e93) {
            } else {
                return;
            }
            let _e3570 = instances.member[(0u + _e2643.instance)].object_to_world[0u];
            let _e3583 = instances.member[(0u + _e2643.instance)].object_to_world[1u];
            let _e3596 = instances.member[(0u + _e2643.instance)].object_to_world[2u];
            phi_4317_ = vec3<f32>((((((((_e3467.x * _e3449.x) + (_e3467.y * _e3449.y)) + (_e3467.z * _e3449.z)) + (_e3467.w * 1f)) * _e3436) + (((((_e3517.x * _e3453.x) + (_e3517.y * _e3453.y)) + (_e3517.z * _e3453.z)) + (_e3517.w * 1f)) * _e2643.u)) + (((((_e3570.x * _e3457.x) + (_e3570.y * _e3457.y)) + (_e3570.z * _e3457.z)) + (_e3570.w * 1f)) * _e2643.v)), (((((((_e3480.x * _e3449.x) + (_e3480.y * _e3449.y)) + (_e3480.z * _e3449.z)) + (_e3480.w * 1f)) * _e3436) + (((((_e3530.x * _e3453.x) + (_e3530.y * _e3453.y)) + (_e3530.z * _e3453.z)) + (_e3530.w * 1f)) * _e2643.u)) + (((((_e3583.x * _e3457.x) + (_e3583.y * _e3457.y)) + (_e3583.z * _e3457.z)) + (_e3583.w * 1f)) * _e2643.v)), (((((((_e3493.x * _e3449.x) + (_e3493.y * _e3449.y)) + (_e3493.z * _e3449.z)) + (_e3493.w * 1f)) * _e3436) + (((((_e3543.x * _e3453.x) + (_e3543.y * _e3453.y)) + (_e3543.z * _e3453.z)) + (_e3543.w * 1f)) * _e2643.u)) + (((((_e3596.x * _e3457.x) + (_e3596.y * _e3457.y)) + (_e3596.z * _e3457.z)) + (_e3596.w * 1f)) * _e2643.v)));
        } else {
            phi_4317_ = vec3<f32>(0f, 0f, 0f);
        }
        let _e3616 = phi_4317_;
        if (_e108.shift < arrayLength((&past.member))) {
        } else {
            return;
        }
        past.member[(0u + _e108.shift)] = vec4<f32>(_e3616.x, _e3616.y, _e3616.z, 1f);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_instanced_color_motion_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
