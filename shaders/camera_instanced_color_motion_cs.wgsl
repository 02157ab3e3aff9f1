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
                let _e314 = phi_907_;
                if (_e165.direction.x < 0f) {
                    phi_914_ = (-1f / _e314);
                } else {
                    phi_914_ = (1f / _e314);
                }
                let _e319 = phi_914_;
                if (abs(_e165.direction.y) < _e307) {
                    phi_922_ = _e307;
                } else {
                    phi_922_ = abs(_e165.direction.y);
                }
                let _e326 = phi_922_;
                if (_e165.direction.y < 0f) {
                    phi_929_ = (-1f / _e326);
                } else {
                    phi_929_ = (1f / _e326);
                }
                let _e331 = phi_929_;
                if (abs(_e165.direction.z) < _e307) {
                    phi_937_ = _e307;
                } else {
                    phi_937_ = abs(_e165.direction.z);
                }
                let _e338 = phi_937_;
                if (_e165.direction.z < 0f) {
                    phi_944_ = (-1f / _e338);
                } else {
                    phi_944_ = (1f / _e338);
                }
                let _e343 = phi_944_;
                let _e351 = abs((bitcast<f32>(_e243) - _e165.origin.x));
                let _e352 = abs((bitcast<f32>(_e247) - _e165.origin.y));
                let _e353 = abs((bitcast<f32>(_e251) - _e165.origin.z));
                let _e361 = abs(((bitcast<f32>(_e255) + (bitcast<f32>((((_e267 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e165.origin.x));
                let _e362 = abs(((bitcast<f32>(_e259) + (bitcast<f32>((((_e267 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e165.origin.y));
                let _e363 = abs(((bitcast<f32>(_e263) + (bitcast<f32>((((_e267 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e165.origin.z));
                if (_e351 > _e361) {
                    phi_969_ = _e351;
                } else {
                    phi_969_ = _e361;
                }
                let _e366 = phi_969_;
                if (_e352 > _e362) {
                    phi_974_ = _e352;
                } else {
                    phi_974_ = _e362;
                }
                let _e369 = phi_974_;
                if (_e353 > _e363) {
                    phi_979_ = _e353;
                } else {
                    phi_979_ = _e363;
                }
                let _e372 = phi_979_;
                let _e373 = core_intrinsics_maximum_number_nsz_f32_(_e366, _e369);
                let _e374 = core_intrinsics_maximum_number_nsz_f32_(_e373, _e372);
                let _e379 = (_e374 * 0.0000019073486f);
                let _e380 = (abs(_e319) * _e379);
                let _e381 = (abs(_e331) * _e379);
                let _e382 = (abs(_e343) * _e379);
                let _e386 = (_e374 * 0.0000009536743f);
                let _e387 = (abs(_e319) * _e386);
                let _e388 = (abs(_e331) * _e386);
                let _e389 = (abs(_e343) * _e386);
                if (_e319 < 0f) {
                    phi_1001_ = 0u;
                } else {
                    phi_1001_ = 1u;
                }
                let _e392 = phi_1001_;
                if (_e331 < 0f) {
                    phi_1006_ = 0u;
                } else {
                    phi_1006_ = 2u;
                }
                let _e395 = phi_1006_;
                if (_e343 < 0f) {
                    phi_1011_ = 0u;
                } else {
                    phi_1011_ = 4u;
                }
                let _e398 = phi_1011_;
                let _e400 = ((_e392 | _e395) | _e398);
                let _e401 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e114, 2147483648u);
                local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e401.first[0], _e401.first[1], _e401.first[2], _e401.first[3], _e401.first[4], _e401.first[5], _e401.first[6], _e401.first[7], _e401.first[8], _e401.first[9], _e401.first[10], _e401.first[11], _e401.first[12], _e401.first[13], _e401.first[14], _e401.first[15], _e401.first[16], _e401.first[17], _e401.first[18], _e401.first[19], _e401.first[20], _e401.first[21], _e401.first[22], _e401.first[23], _e401.first[24], _e401.first[25], _e401.first[26], _e401.first[27], _e401.first[28], _e401.first[29], _e401.first[30], _e401.first[31]), array<u32, 32>(_e401.mask[0], _e401.mask[1], _e401.mask[2], _e401.mask[3], _e401.mask[4], _e401.mask[5], _e401.mask[6], _e401.mask[7], _e401.mask[8], _e401.mask[9], _e401.mask[10], _e401.mask[11], _e401.mask[12], _e401.mask[13], _e401.mask[14], _e401.mask[15], _e401.mask[16], _e401.mask[17], _e401.mask[18], _e401.mask[19], _e401.mask[20], _e401.mask[21], _e401.mask[22], _e401.mask[23], _e401.mask[24], _e401.mask[25], _e401.mask[26], _e401.mask[27], _e401.mask[28], _e401.mask[29], _e401.mask[30], _e401.mask[31]), _e401.len, _e401.group, _e401.group_mask);
                let _e475 = local_2.group_mask;
                if ((_e475 & 4278190080u) == 0u) {
                    let _e479 = local_2.len;
                    if (_e479 == 0u) {
                        phi_1125_ = false;
                    } else {
                        let _e483 = local_2.len;
                        local_2.len = (_e483 - 1u);
                        let _e486 = local_2.len;
                        if (_e486 < 32u) {
                        } else {
                            return;
                        }
                        let _e491 = local_2.first[(0u + _e486)];
                        local_2.group = _e491;
                        let _e494 = local_2.len;
                        if (_e494 < 32u) {
                        } else {
                            return;
                        }
                        let _e499 = local_2.mask[(0u + _e494)];
                        local_2.group_mask = _e499;
                        phi_1125_ = true;
                    }
                    let _e502 = phi_1125_;
                    phi_1126_ = _e502;
                } else {
                    phi_1126_ = true;
                }
                let _e504 = phi_1126_;
                if _e504 {
                    let _e506 = local_2.group_mask;
                    let _e512 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e506)), 32u, (_e506 == 0u)));
                    let _e516 = local_2.group_mask;
                    let _e530 = local_2.group_mask;
                    local_2.group_mask = (_e530 & ~((1u << bitcast<u32>((_e512 & 31u)))));
                    let _e533 = local_2.group;
                    phi_1157_ = (_e533 + countOneBits(((_e516 & ~((4294967295u << bitcast<u32>((((_e512 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1157_ = 4294967295u;
                }
                let _e536 = phi_1157_;
                phi_1159_ = _e536;
                phi_1162_ = _e167;
                loop {
                    let _e538 = phi_1159_;
                    let _e540 = phi_1162_;
                    local_12 = _e540;
                    let _e541 = (_e538 != 4294967295u);
                    if _e541 {
                        if (_e538 < _e78) {
                        } else {
                            return;
                        }
                        let _e549 = nodes.member[(0u + _e538)].frame[3u];
                        let _e574 = (bitcast<f32>((((_e549 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e319);
                        let _e575 = (bitcast<f32>((((_e549 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e331);
                        let _e576 = (bitcast<f32>((((_e549 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e343);
                        let _e579 = nodes.member[(0u + _e538)].frame[0u];
                        let _e583 = nodes.member[(0u + _e538)].frame[1u];
                        let _e587 = nodes.member[(0u + _e538)].frame[2u];
                        let _e595 = ((bitcast<f32>(_e579) - _e165.origin.x) * _e319);
                        let _e596 = ((bitcast<f32>(_e583) - _e165.origin.y) * _e331);
                        let _e597 = ((bitcast<f32>(_e587) - _e165.origin.z) * _e343);
                        let _e605 = nodes.member[(0u + _e538)].x;
                        if (_e319 < 0f) {
                            let _e616 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e605.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e622 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e616.unnamed.word, _e605.w), _e616.unnamed_1);
                            let _e628 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e622.unnamed, lt_mask_LightPlace(_e605.x, _e622.unnamed_1.shift));
                            phi_1247_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e628.unnamed, lt_mask_LightPlace(_e628.unnamed_1.word, _e605.y));
                        } else {
                            let _e644 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e605.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e650 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e644.unnamed.word, _e605.y), _e644.unnamed_1);
                            let _e656 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e650.unnamed, lt_mask_LightPlace(_e605.z, _e650.unnamed_1.shift));
                            phi_1247_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e656.unnamed, lt_mask_LightPlace(_e656.unnamed_1.word, _e605.w));
                        }
                        let _e664 = phi_1247_;
                        let _e674 = nodes.member[(0u + _e538)].y;
                        if (_e331 < 0f) {
                            let _e685 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e674.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e691 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e685.unnamed.word, _e674.w), _e685.unnamed_1);
                            let _e697 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e691.unnamed, lt_mask_LightPlace(_e674.x, _e691.unnamed_1.shift));
                            phi_1274_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e697.unnamed, lt_mask_LightPlace(_e697.unnamed_1.word, _e674.y));
                        } else {
                            let _e713 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e674.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e719 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e713.unnamed.word, _e674.y), _e713.unnamed_1);
                            let _e725 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e719.unnamed, lt_mask_LightPlace(_e674.z, _e719.unnamed_1.shift));
                            phi_1274_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e725.unnamed, lt_mask_LightPlace(_e725.unnamed_1.word, _e674.w));
                        }
                        let _e733 = phi_1274_;
                        let _e743 = nodes.member[(0u + _e538)].z;
                        if (_e343 < 0f) {
                            let _e754 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e743.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e760 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e754.unnamed.word, _e743.w), _e754.unnamed_1);
                            let _e766 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e760.unnamed, lt_mask_LightPlace(_e743.x, _e760.unnamed_1.shift));
                            phi_1301_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e766.unnamed, lt_mask_LightPlace(_e766.unnamed_1.word, _e743.y));
                        } else {
                            let _e782 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e743.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e788 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e782.unnamed.word, _e743.y), _e782.unnamed_1);
                            let _e794 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e788.unnamed, lt_mask_LightPlace(_e743.z, _e788.unnamed_1.shift));
                            phi_1301_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e794.unnamed, lt_mask_LightPlace(_e794.unnamed_1.word, _e743.w));
                        }
                        let _e802 = phi_1301_;
                        phi_1307_ = 0u;
                        phi_1310_ = 0u;
                        loop {
                            let _e812 = phi_1307_;
                            let _e814 = phi_1310_;
                            local_3 = _e814;
                            local_4 = _e814;
                            local_5 = _e814;
                            let _e815 = (_e812 < 8u);
                            if _e815 {
                                let _e817 = (_e812 >> bitcast<u32>(2i));
                                let _e818 = (_e812 & 3u);
                                if (_e817 == 0u) {
                                    phi_1324_ = _e664.unnamed.word;
                                } else {
                                    phi_1324_ = _e664.unnamed.shift;
                                }
                                let _e821 = phi_1324_;
                                if (_e817 == 0u) {
                                    phi_1334_ = _e733.unnamed.word;
                                } else {
                                    phi_1334_ = _e733.unnamed.shift;
                                }
                                let _e830 = phi_1334_;
                                if (_e817 == 0u) {
                                    phi_1344_ = _e802.unnamed.word;
                                } else {
                                    phi_1344_ = _e802.unnamed.shift;
                                }
                                let _e839 = phi_1344_;
                                let _e852 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e821 >> bitcast<u32>(((_e818 * 8u) & 31u))) & 255u)) * _e574) + (_e595 - _e380)), ((f32(((_e830 >> bitcast<u32>(((_e818 * 8u) & 31u))) & 255u)) * _e575) + (_e596 - _e381)));
                                let _e853 = core_intrinsics_maximum_number_nsz_f32_(_e852, ((f32(((_e839 >> bitcast<u32>(((_e818 * 8u) & 31u))) & 255u)) * _e576) + (_e597 - _e382)));
                                if (_e817 == 0u) {
                                    phi_1362_ = _e664.unnamed_1.word;
                                } else {
                                    phi_1362_ = _e664.unnamed_1.shift;
                                }
                                let _e856 = phi_1362_;
                                if (_e817 == 0u) {
                                    phi_1372_ = _e733.unnamed_1.word;
                                } else {
                                    phi_1372_ = _e733.unnamed_1.shift;
                                }
                                let _e865 = phi_1372_;
                                if (_e817 == 0u) {
                                    phi_1382_ = _e802.unnamed_1.word;
                                } else {
                                    phi_1382_ = _e802.unnamed_1.shift;
                                }
                                let _e874 = phi_1382_;
                                let _e887 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e856 >> bitcast<u32>(((_e818 * 8u) & 31u))) & 255u)) * _e574) + (_e595 + _e380)), ((f32(((_e865 >> bitcast<u32>(((_e818 * 8u) & 31u))) & 255u)) * _e575) + (_e596 + _e381)));
                                let _e888 = core_intrinsics_minimum_number_nsz_f32_(_e887, ((f32(((_e874 >> bitcast<u32>(((_e818 * 8u) & 31u))) & 255u)) * _e576) + (_e597 + _e382)));
                                if (_e853 <= _e888) {
                                    if (_e853 <= _e540.t) {
                                        if (_e888 >= _e165.tmin) {
                                            if (_e817 == 0u) {
                                                let _e895 = nodes.member[(0u + _e538)].links[2u];
                                                phi_1418_ = _e895;
                                            } else {
                                                let _e898 = nodes.member[(0u + _e538)].links[3u];
                                                phi_1418_ = _e898;
                                            }
                                            let _e900 = phi_1418_;
                                            let _e905 = ((_e900 >> bitcast<u32>(((_e818 * 8u) & 31u))) & 255u);
                                            let _e906 = (_e905 & 31u);
                                            if (_e906 >= 24u) {
                                                phi_1431_ = (24u + ((_e906 - 24u) ^ _e400));
                                            } else {
                                                phi_1431_ = _e906;
                                            }
                                            let _e912 = phi_1431_;
                                            phi_1436_ = (_e814 | ((_e905 >> bitcast<u32>(5i)) << bitcast<u32>((_e912 & 31u))));
                                        } else {
                                            phi_1436_ = _e814;
                                        }
                                        let _e920 = phi_1436_;
                                        phi_1437_ = _e920;
                                    } else {
                                        phi_1437_ = _e814;
                                    }
                                    let _e922 = phi_1437_;
                                    phi_1438_ = _e922;
                                } else {
                                    phi_1438_ = _e814;
                                }
                                let _e924 = phi_1438_;
                                phi_1308_ = (_e812 + 1u);
                                phi_1311_ = _e924;
                            } else {
                                phi_1308_ = u32();
                                phi_1311_ = u32();
                            }
                            let _e927 = phi_1308_;
                            let _e929 = phi_1311_;
                            continue;
                            continuing {
                                phi_1307_ = _e927;
                                phi_1310_ = _e929;
                                break if !(_e815);
                            }
                        }
                        let _e933 = nodes.member[(0u + _e538)].links[0u];
                        let _e937 = nodes.member[(0u + _e538)].frame[3u];
                        let _e941 = local_3;
                        if ((_e941 & 4278190080u) == 0u) {
                        } else {
                            let _e945 = local_2.group_mask;
                            if ((_e945 & 4278190080u) == 0u) {
                            } else {
                                let _e949 = local_2.len;
                                if (_e949 < 32u) {
                                    let _e952 = local_2.group;
                                    let _e954 = local_2.len;
                                    if (_e954 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.first[(0u + _e954)] = _e952;
                                    let _e960 = local_2.group_mask;
                                    let _e962 = local_2.len;
                                    if (_e962 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.mask[(0u + _e962)] = _e960;
                                    let _e969 = local_2.len;
                                    local_2.len = (_e969 + 1u);
                                }
                            }
                            local_2.group = (_e114 + _e933);
                            let _e973 = local_4;
                            local_2.group_mask = ((_e973 & 4278190080u) | (_e937 >> bitcast<u32>(24i)));
                        }
                        let _e978 = local_5;
                        phi_1496_ = (_e978 & 16777215u);
                        phi_1499_ = _e540;
                        loop {
                            let _e981 = phi_1496_;
                            let _e983 = phi_1499_;
                            local_11 = _e983;
                            if (_e981 == 0u) {
                                phi_1497_ = u32();
                                phi_1500_ = lt_bvh_Hit();
                                phi_3182_ = false;
                            } else {
                                let _e987 = nodes.member[(0u + _e538)].links[1u];
                                let _e991 = (_e987 + select(firstTrailingBit(_e981), 32u, (_e981 == 0u)));
                                if (_e991 < _e93) {
                                } else {
                                    return;
                                }
                                let _e998 = instances.member[(0u + _e991)].low_world;
                                let _e1000 = instances.member[(0u + _e991)].high_world;
                                let _e1010 = ((_e998.x - _e165.origin.x) * _e319);
                                let _e1011 = ((_e998.y - _e165.origin.y) * _e331);
                                let _e1012 = ((_e998.z - _e165.origin.z) * _e343);
                                let _e1022 = ((_e1000.x - _e165.origin.x) * _e319);
                                let _e1023 = ((_e1000.y - _e165.origin.y) * _e331);
                                let _e1024 = ((_e1000.z - _e165.origin.z) * _e343);
                                if (_e1010 < _e1022) {
                                    phi_1554_ = _e1010;
                                } else {
                                    phi_1554_ = _e1022;
                                }
                                let _e1027 = phi_1554_;
                                if (_e1011 < _e1023) {
                                    phi_1559_ = _e1011;
                                } else {
                                    phi_1559_ = _e1023;
                                }
                                let _e1030 = phi_1559_;
                                if (_e1012 < _e1024) {
                                    phi_1564_ = _e1012;
                                } else {
                                    phi_1564_ = _e1024;
                                }
                                let _e1033 = phi_1564_;
                                if (_e1010 > _e1022) {
                                    phi_1572_ = _e1010;
                                } else {
                                    phi_1572_ = _e1022;
                                }
                                let _e1039 = phi_1572_;
                                if (_e1011 > _e1023) {
                                    phi_1577_ = _e1011;
                                } else {
                                    phi_1577_ = _e1023;
                                }
                                let _e1042 = phi_1577_;
                                if (_e1012 > _e1024) {
                                    phi_1582_ = _e1012;
                                } else {
                                    phi_1582_ = _e1024;
                                }
                                let _e1045 = phi_1582_;
                                let _e1049 = core_intrinsics_maximum_number_nsz_f32_((_e1027 - _e387), (_e1030 - _e388));
                                let _e1050 = core_intrinsics_maximum_number_nsz_f32_(_e1049, (_e1033 - _e389));
                                let _e1051 = core_intrinsics_minimum_number_nsz_f32_((_e1039 + _e387), (_e1042 + _e388));
                                let _e1052 = core_intrinsics_minimum_number_nsz_f32_(_e1051, (_e1045 + _e389));
                                if (_e1050 <= _e1052) {
                                    if (_e1050 <= _e983.t) {
                                        if (_e1052 >= _e165.tmin) {
                                            let _e1064 = instances.member[(0u + _e991)].world_to_object[0u];
                                            let _e1075 = ((((_e1064.x * _e165.origin.x) + (_e1064.y * _e165.origin.y)) + (_e1064.z * _e165.origin.z)) + (_e1064.w * 1f));
                                            let _e1077 = instances.member[(0u + _e991)].world_to_object[1u];
                                            let _e1088 = ((((_e1077.x * _e165.origin.x) + (_e1077.y * _e165.origin.y)) + (_e1077.z * _e165.origin.z)) + (_e1077.w * 1f));
                                            let _e1090 = instances.member[(0u + _e991)].world_to_object[2u];
                                            let _e1101 = ((((_e1090.x * _e165.origin.x) + (_e1090.y * _e165.origin.y)) + (_e1090.z * _e165.origin.z)) + (_e1090.w * 1f));
                                            let _e1108 = instances.member[(0u + _e991)].world_to_object[0u];
                                            let _e1119 = ((((_e1108.x * _e165.direction.x) + (_e1108.y * _e165.direction.y)) + (_e1108.z * _e165.direction.z)) + (_e1108.w * 0f));
                                            let _e1121 = instances.member[(0u + _e991)].world_to_object[1u];
                                            let _e1132 = ((((_e1121.x * _e165.direction.x) + (_e1121.y * _e165.direction.y)) + (_e1121.z * _e165.direction.z)) + (_e1121.w * 0f));
                                            let _e1134 = instances.member[(0u + _e991)].world_to_object[2u];
                                            let _e1145 = ((((_e1134.x * _e165.direction.x) + (_e1134.y * _e165.direction.y)) + (_e1134.z * _e165.direction.z)) + (_e1134.w * 0f));
                                            let _e1150 = instances.member[(0u + _e991)].root;
                                            let _e1152 = instances.member[(0u + _e991)].first_triangle;
                                            let _e1156 = abs(_e1119);
                                            let _e1157 = abs(_e1132);
                                            let _e1158 = abs(_e1145);
                                            if (abs(_e1075) < 1000000000000000f) {
                                                if (abs(_e1088) < 1000000000000000f) {
                                                    if (abs(_e1101) < 1000000000000000f) {
                                                        if (_e1156 < 1000000000000000f) {
                                                            if (_e1157 < 1000000000000000f) {
                                                                if (_e1158 < 1000000000000000f) {
                                                                    if (_e1156 > 0f) {
                                                                        phi_1739_ = bool();
                                                                        phi_1740_ = true;
                                                                    } else {
                                                                        let _e1166 = (_e1157 > 0f);
                                                                        if _e1166 {
                                                                            phi_1738_ = bool();
                                                                        } else {
                                                                            phi_1738_ = (_e1158 > 0f);
                                                                        }
                                                                        let _e1169 = phi_1738_;
                                                                        phi_1739_ = _e1169;
                                                                        phi_1740_ = _e1166;
                                                                    }
                                                                    let _e1171 = phi_1739_;
                                                                    let _e1173 = phi_1740_;
                                                                    if _e1173 {
                                                                        phi_1744_ = true;
                                                                    } else {
                                                                        phi_1744_ = _e1171;
                                                                    }
                                                                    let _e1175 = phi_1744_;
                                                                    phi_1745_ = _e1175;
                                                                    phi_1746_ = false;
                                                                } else {
                                                                    phi_1745_ = bool();
                                                                    phi_1746_ = true;
                                                                }
                                                                let _e1177 = phi_1745_;
                                                                let _e1179 = phi_1746_;
                                                                phi_1747_ = _e1177;
                                                                phi_1748_ = false;
                                                                phi_1749_ = _e1179;
                                                            } else {
                                                                phi_1747_ = bool();
                                                                phi_1748_ = true;
                                                                phi_1749_ = false;
                                                            }
                                                            let _e1181 = phi_1747_;
                                                            let _e1183 = phi_1748_;
                                                            let _e1185 = phi_1749_;
                                                            phi_1750_ = _e1181;
                                                            phi_1751_ = _e1183;
                                                            phi_1752_ = _e1185;
                                                        } else {
                                                            phi_1750_ = bool();
                                                            phi_1751_ = true;
                                                            phi_1752_ = false;
                                                        }
                                                        let _e1187 = phi_1750_;
                                                        let _e1189 = phi_1751_;
                                                        let _e1191 = phi_1752_;
                                                        phi_1753_ = _e1187;
                                                        phi_1754_ = _e1189;
                                                        phi_1755_ = _e1191;
                                                    } else {
                                                        phi_1753_ = bool();
                                                        phi_1754_ = true;
                                                        phi_1755_ = false;
                                                    }
                                                    let _e1193 = phi_1753_;
                                                    let _e1195 = phi_1754_;
                                                    let _e1197 = phi_1755_;
                                                    phi_1756_ = _e1193;
                                                    phi_1757_ = _e1195;
                                                    phi_1758_ = _e1197;
                                                } else {
                                                    phi_1756_ = bool();
                                                    phi_1757_ = true;
                                                    phi_1758_ = false;
                                                }
                                                let _e1199 = phi_1756_;
                                                let _e1201 = phi_1757_;
                                                let _e1203 = phi_1758_;
                                                phi_1759_ = _e1199;
                                                phi_1760_ = _e1201;
                                                phi_1761_ = _e1203;
                                            } else {
                                                phi_1759_ = bool();
                                                phi_1760_ = true;
                                                phi_1761_ = false;
                                            }
                                            let _e1205 = phi_1759_;
                                            let _e1207 = phi_1760_;
                                            let _e1209 = phi_1761_;
                                            if _e1207 {
                                                phi_1765_ = true;
                                            } else {
                                                phi_1765_ = _e1209;
                                            }
                                            let _e1211 = phi_1765_;
                                            if _e1211 {
                                                phi_1769_ = false;
                                            } else {
                                                phi_1769_ = _e1205;
                                            }
                                            let _e1213 = phi_1769_;
                                            if _e1213 {
                                                let _e1214 = (_e1150 >= _e78);
                                                if _e1214 {
                                                    phi_3172_ = lt_bvh_Hit();
                                                } else {
                                                    if (_e1150 < _e78) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1220 = nodes.member[(0u + _e1150)].frame[0u];
                                                    let _e1224 = nodes.member[(0u + _e1150)].frame[1u];
                                                    let _e1228 = nodes.member[(0u + _e1150)].frame[2u];
                                                    let _e1232 = nodes.member[(0u + _e1150)].frame[0u];
                                                    let _e1236 = nodes.member[(0u + _e1150)].frame[1u];
                                                    let _e1240 = nodes.member[(0u + _e1150)].frame[2u];
                                                    let _e1244 = nodes.member[(0u + _e1150)].frame[3u];
                                                    let _e1278 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1119), abs(_e1132));
                                                    let _e1279 = core_intrinsics_maximum_number_nsz_f32_(_e1278, abs(_e1145));
                                                    let _e1280 = (_e1279 * 0.0000000000009094947f);
                                                    if (abs(_e1119) < _e1280) {
                                                        phi_1839_ = _e1280;
                                                    } else {
                                                        phi_1839_ = abs(_e1119);
                                                    }
                                                    let _e1285 = phi_1839_;
                                                    if (_e1119 < 0f) {
                                                        phi_1846_ = (-1f / _e1285);
                                                    } else {
                                                        phi_1846_ = (1f / _e1285);
                                                    }
                                                    let _e1290 = phi_1846_;
                                                    if (abs(_e1132) < _e1280) {
                                                        phi_1853_ = _e1280;
                                                    } else {
                                                        phi_1853_ = abs(_e1132);
                                                    }
                                                    let _e1295 = phi_1853_;
                                                    if (_e1132 < 0f) {
                                                        phi_1860_ = (-1f / _e1295);
                                                    } else {
                                                        phi_1860_ = (1f / _e1295);
                                                    }
                                                    let _e1300 = phi_1860_;
                                                    if (abs(_e1145) < _e1280) {
                                                        phi_1867_ = _e1280;
                                                    } else {
                                                        phi_1867_ = abs(_e1145);
                                                    }
                                                    let _e1305 = phi_1867_;
                                                    if (_e1145 < 0f) {
                                                        phi_1874_ = (-1f / _e1305);
                                                    } else {
                                                        phi_1874_ = (1f / _e1305);
                                                    }
                                                    let _e1310 = phi_1874_;
                                                    let _e1314 = abs((bitcast<f32>(_e1220) - _e1075));
                                                    let _e1315 = abs((bitcast<f32>(_e1224) - _e1088));
                                                    let _e1316 = abs((bitcast<f32>(_e1228) - _e1101));
                                                    let _e1320 = abs(((bitcast<f32>(_e1232) + (bitcast<f32>((((_e1244 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1075));
                                                    let _e1321 = abs(((bitcast<f32>(_e1236) + (bitcast<f32>((((_e1244 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1088));
                                                    let _e1322 = abs(((bitcast<f32>(_e1240) + (bitcast<f32>((((_e1244 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1101));
                                                    if (_e1314 > _e1320) {
                                                        phi_1891_ = _e1314;
                                                    } else {
                                                        phi_1891_ = _e1320;
                                                    }
                                                    let _e1325 = phi_1891_;
                                                    if (_e1315 > _e1321) {
                                                        phi_1896_ = _e1315;
                                                    } else {
                                                        phi_1896_ = _e1321;
                                                    }
                                                    let _e1328 = phi_1896_;
                                                    if (_e1316 > _e1322) {
                                                        phi_1901_ = _e1316;
                                                    } else {
                                                        phi_1901_ = _e1322;
                                                    }
                                                    let _e1331 = phi_1901_;
                                                    let _e1332 = core_intrinsics_maximum_number_nsz_f32_(_e1325, _e1328);
                                                    let _e1333 = core_intrinsics_maximum_number_nsz_f32_(_e1332, _e1331);
                                                    let _e1337 = (_e1333 * 0.0000019073486f);
                                                    let _e1338 = (abs(_e1290) * _e1337);
                                                    let _e1339 = (abs(_e1300) * _e1337);
                                                    let _e1340 = (abs(_e1310) * _e1337);
                                                    let _e1344 = (_e1333 * 0.0000009536743f);
                                                    let _e1345 = (abs(_e1290) * _e1344);
                                                    let _e1346 = (abs(_e1300) * _e1344);
                                                    let _e1347 = (abs(_e1310) * _e1344);
                                                    let _e1348 = abs(_e1119);
                                                    let _e1349 = abs(_e1132);
                                                    let _e1350 = abs(_e1145);
                                                    if (_e1348 >= _e1349) {
                                                        if (_e1348 >= _e1350) {
                                                            phi_1929_ = false;
                                                        } else {
                                                            phi_1929_ = true;
                                                        }
                                                        let _e1354 = phi_1929_;
                                                        phi_1930_ = _e1354;
                                                    } else {
                                                        phi_1930_ = true;
                                                    }
                                                    let _e1356 = phi_1930_;
                                                    if _e1356 {
                                                        if (_e1349 >= _e1350) {
                                                            phi_1938_ = 1u;
                                                        } else {
                                                            phi_1938_ = 2u;
                                                        }
                                                        let _e1359 = phi_1938_;
                                                        phi_1939_ = _e1359;
                                                    } else {
                                                        phi_1939_ = 0u;
                                                    }
                                                    let _e1361 = phi_1939_;
                                                    if (_e1361 == 0u) {
                                                        phi_1951_ = vec3<f32>(_e1132, _e1145, _e1119);
                                                    } else {
                                                        if (_e1361 == 1u) {
                                                            phi_1950_ = vec3<f32>(_e1145, _e1119, _e1132);
                                                        } else {
                                                            phi_1950_ = vec3<f32>(_e1119, _e1132, _e1145);
                                                        }
                                                        let _e1367 = phi_1950_;
                                                        phi_1951_ = _e1367;
                                                    }
                                                    let _e1369 = phi_1951_;
                                                    let _e1372 = (_e1369.x / _e1369.z);
                                                    let _e1375 = (_e1369.y / _e1369.z);
                                                    if (_e1290 < 0f) {
                                                        phi_1964_ = 0u;
                                                    } else {
                                                        phi_1964_ = 1u;
                                                    }
                                                    let _e1380 = phi_1964_;
                                                    if (_e1300 < 0f) {
                                                        phi_1969_ = 0u;
                                                    } else {
                                                        phi_1969_ = 2u;
                                                    }
                                                    let _e1383 = phi_1969_;
                                                    if (_e1310 < 0f) {
                                                        phi_1974_ = 0u;
                                                    } else {
                                                        phi_1974_ = 4u;
                                                    }
                                                    let _e1386 = phi_1974_;
                                                    let _e1388 = ((_e1380 | _e1383) | _e1386);
                                                    let _e1389 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1150, 2147483648u);
                                                    local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e1389.first[0], _e1389.first[1], _e1389.first[2], _e1389.first[3], _e1389.first[4], _e1389.first[5], _e1389.first[6], _e1389.first[7], _e1389.first[8], _e1389.first[9], _e1389.first[10], _e1389.first[11], _e1389.first[12], _e1389.first[13], _e1389.first[14], _e1389.first[15], _e1389.first[16], _e1389.first[17], _e1389.first[18], _e1389.first[19], _e1389.first[20], _e1389.first[21], _e1389.first[22], _e1389.first[23], _e1389.first[24], _e1389.first[25], _e1389.first[26], _e1389.first[27], _e1389.first[28], _e1389.first[29], _e1389.first[30], _e1389.first[31]), array<u32, 32>(_e1389.mask[0], _e1389.mask[1], _e1389.mask[2], _e1389.mask[3], _e1389.mask[4], _e1389.mask[5], _e1389.mask[6], _e1389.mask[7], _e1389.mask[8], _e1389.mask[9], _e1389.mask[10], _e1389.mask[11], _e1389.mask[12], _e1389.mask[13], _e1389.mask[14], _e1389.mask[15], _e1389.mask[16], _e1389.mask[17], _e1389.mask[18], _e1389.mask[19], _e1389.mask[20], _e1389.mask[21], _e1389.mask[22], _e1389.mask[23], _e1389.mask[24], _e1389.mask[25], _e1389.mask[26], _e1389.mask[27], _e1389.mask[28], _e1389.mask[29], _e1389.mask[30], _e1389.mask[31]), _e1389.len, _e1389.group, _e1389.group_mask);
                                                    let _e1463 = local_1.group_mask;
                                                    if ((_e1463 & 4278190080u) == 0u) {
                                                        let _e1467 = local_1.len;
                                                        if (_e1467 == 0u) {
                                                            phi_2088_ = false;
                                                        } else {
                                                            let _e1471 = local_1.len;
                                                            local_1.len = (_e1471 - 1u);
                                                            let _e1474 = local_1.len;
                                                            if (_e1474 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1479 = local_1.first[(0u + _e1474)];
                                                            local_1.group = _e1479;
                                                            let _e1482 = local_1.len;
                                                            if (_e1482 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1487 = local_1.mask[(0u + _e1482)];
                                                            local_1.group_mask = _e1487;
                                                            phi_2088_ = true;
                                                        }
                                                        let _e1490 = phi_2088_;
                                                        phi_2089_ = _e1490;
                                                    } else {
                                                        phi_2089_ = true;
                                                    }
                                                    let _e1492 = phi_2089_;
                                                    if _e1492 {
                                                        let _e1494 = local_1.group_mask;
                                                        let _e1500 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1494)), 32u, (_e1494 == 0u)));
                                                        let _e1504 = local_1.group_mask;
                                                        let _e1518 = local_1.group_mask;
                                                        local_1.group_mask = (_e1518 & ~((1u << bitcast<u32>((_e1500 & 31u)))));
                                                        let _e1521 = local_1.group;
                                                        phi_2120_ = (_e1521 + countOneBits(((_e1504 & ~((4294967295u << bitcast<u32>((((_e1500 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_2120_ = 4294967295u;
                                                    }
                                                    let _e1524 = phi_2120_;
                                                    phi_2122_ = _e983;
                                                    phi_2125_ = _e1524;
                                                    loop {
                                                        let _e1526 = phi_2122_;
                                                        let _e1528 = phi_2125_;
                                                        local_10 = _e1526;
                                                        let _e1529 = (_e1528 != 4294967295u);
                                                        if _e1529 {
                                                            if (_e1528 < _e78) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1536 = nodes.member[(0u + _e1528)].frame[3u];
                                                            let _e1561 = (bitcast<f32>((((_e1536 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1290);
                                                            let _e1562 = (bitcast<f32>((((_e1536 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1300);
                                                            let _e1563 = (bitcast<f32>((((_e1536 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1310);
                                                            let _e1566 = nodes.member[(0u + _e1528)].frame[0u];
                                                            let _e1570 = nodes.member[(0u + _e1528)].frame[1u];
                                                            let _e1574 = nodes.member[(0u + _e1528)].frame[2u];
                                                            let _e1579 = ((bitcast<f32>(_e1566) - _e1075) * _e1290);
                                                            let _e1580 = ((bitcast<f32>(_e1570) - _e1088) * _e1300);
                                                            let _e1581 = ((bitcast<f32>(_e1574) - _e1101) * _e1310);
                                                            let _e1589 = nodes.member[(0u + _e1528)].x;
                                                            if (_e1290 < 0f) {
                                                                let _e1600 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1589.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1606 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1600.unnamed.word, _e1589.w), _e1600.unnamed_1);
                                                                let _e1612 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1606.unnamed, lt_mask_LightPlace(_e1589.x, _e1606.unnamed_1.shift));
                                                                phi_2206_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1612.unnamed, lt_mask_LightPlace(_e1612.unnamed_1.word, _e1589.y));
                                                            } else {
                                                                let _e1628 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1589.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1634 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1628.unnamed.word, _e1589.y), _e1628.unnamed_1);
                                                                let _e1640 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1634.unnamed, lt_mask_LightPlace(_e1589.z, _e1634.unnamed_1.shift));
                                                                phi_2206_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1640.unnamed, lt_mask_LightPlace(_e1640.unnamed_1.word, _e1589.w));
                                                            }
                                                            let _e1648 = phi_2206_;
                                                            let _e1658 = nodes.member[(0u + _e1528)].y;
                                                            if (_e1300 < 0f) {
                                                                let _e1669 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1658.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1675 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1669.unnamed.word, _e1658.w), _e1669.unnamed_1);
                                                                let _e1681 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1675.unnamed, lt_mask_LightPlace(_e1658.x, _e1675.unnamed_1.shift));
                                                                phi_2233_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1681.unnamed, lt_mask_LightPlace(_e1681.unnamed_1.word, _e1658.y));
                                                            } else {
                                                                let _e1697 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1658.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1703 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1697.unnamed.word, _e1658.y), _e1697.unnamed_1);
                                                                let _e1709 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1703.unnamed, lt_mask_LightPlace(_e1658.z, _e1703.unnamed_1.shift));
                                                                phi_2233_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1709.unnamed, lt_mask_LightPlace(_e1709.unnamed_1.word, _e1658.w));
                                                            }
                                                            let _e1717 = phi_2233_;
                                                            let _e1727 = nodes.member[(0u + _e1528)].z;
                                                            if (_e1310 < 0f) {
                                                                let _e1738 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1727.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1744 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1738.unnamed.word, _e1727.w), _e1738.unnamed_1);
                                                                let _e1750 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1744.unnamed, lt_mask_LightPlace(_e1727.x, _e1744.unnamed_1.shift));
                                                                phi_2260_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1750.unnamed, lt_mask_LightPlace(_e1750.unnamed_1.word, _e1727.y));
                                                            } else {
                                                                let _e1766 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1727.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1772 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1766.unnamed.word, _e1727.y), _e1766.unnamed_1);
                                                                let _e1778 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1772.unnamed, lt_mask_LightPlace(_e1727.z, _e1772.unnamed_1.shift));
                                                                phi_2260_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1778.unnamed, lt_mask_LightPlace(_e1778.unnamed_1.word, _e1727.w));
                                                            }
                                                            let _e1786 = phi_2260_;
                                                            phi_2266_ = 0u;
                                                            phi_2269_ = 0u;
                                                            loop {
                                                                let _e1796 = phi_2266_;
                                                                let _e1798 = phi_2269_;
                                                                local_6 = _e1798;
                                                                local_7 = _e1798;
                                                                local_8 = _e1798;
                                                                let _e1799 = (_e1796 < 8u);
                                                                if _e1799 {
                                                                    let _e1801 = (_e1796 >> bitcast<u32>(2i));
                                                                    let _e1802 = (_e1796 & 3u);
                                                                    if (_e1801 == 0u) {
                                                                        phi_2283_ = _e1648.unnamed.word;
                                                                    } else {
                                                                        phi_2283_ = _e1648.unnamed.shift;
                                                                    }
                                                                    let _e1805 = phi_2283_;
                                                                    if (_e1801 == 0u) {
                                                                        phi_2293_ = _e1717.unnamed.word;
                                                                    } else {
                                                                        phi_2293_ = _e1717.unnamed.shift;
                                                                    }
                                                                    let _e1814 = phi_2293_;
                                                                    if (_e1801 == 0u) {
                                                                        phi_2303_ = _e1786.unnamed.word;
                                                                    } else {
                                                                        phi_2303_ = _e1786.unnamed.shift;
                                                                    }
                                                                    let _e1823 = phi_2303_;
                                                                    let _e1836 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1805 >> bitcast<u32>(((_e1802 * 8u) & 31u))) & 255u)) * _e1561) + (_e1579 - _e1338)), ((f32(((_e1814 >> bitcast<u32>(((_e1802 * 8u) & 31u))) & 255u)) * _e1562) + (_e1580 - _e1339)));
                                                                    let _e1837 = core_intrinsics_maximum_number_nsz_f32_(_e1836, ((f32(((_e1823 >> bitcast<u32>(((_e1802 * 8u) & 31u))) & 255u)) * _e1563) + (_e1581 - _e1340)));
                                                                    if (_e1801 == 0u) {
                                                                        phi_2321_ = _e1648.unnamed_1.word;
                                                                    } else {
                                                                        phi_2321_ = _e1648.unnamed_1.shift;
                                                                    }
                                                                    let _e1840 = phi_2321_;
                                                                    if (_e1801 == 0u) {
                                                                        phi_2331_ = _e1717.unnamed_1.word;
                                                                    } else {
                                                                        phi_2331_ = _e1717.unnamed_1.shift;
                                                                    }
                                                                    let _e1849 = phi_2331_;
                                                                    if (_e1801 == 0u) {
                                                                        phi_2341_ = _e1786.unnamed_1.word;
                                                                    } else {
                                                                        phi_2341_ = _e1786.unnamed_1.shift;
                                                                    }
                                                                    let _e1858 = phi_2341_;
                                                                    let _e1871 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1840 >> bitcast<u32>(((_e1802 * 8u) & 31u))) & 255u)) * _e1561) + (_e1579 + _e1338)), ((f32(((_e1849 >> bitcast<u32>(((_e1802 * 8u) & 31u))) & 255u)) * _e1562) + (_e1580 + _e1339)));
                                                                    let _e1872 = core_intrinsics_minimum_number_nsz_f32_(_e1871, ((f32(((_e1858 >> bitcast<u32>(((_e1802 * 8u) & 31u))) & 255u)) * _e1563) + (_e1581 + _e1340)));
                                                                    if (_e1837 <= _e1872) {
                                                                        if (_e1837 <= _e1526.t) {
                                                                            if (_e1872 >= _e165.tmin) {
                                                                                if (_e1801 == 0u) {
                                                                                    let _e1879 = nodes.member[(0u + _e1528)].links[2u];
                                                                                    phi_2377_ = _e1879;
                                                                                } else {
                                                                                    let _e1882 = nodes.member[(0u + _e1528)].links[3u];
                                                                                    phi_2377_ = _e1882;
                                                                                }
                                                                                let _e1884 = phi_2377_;
                                                                                let _e1889 = ((_e1884 >> bitcast<u32>(((_e1802 * 8u) & 31u))) & 255u);
                                                                                let _e1890 = (_e1889 & 31u);
                                                                                if (_e1890 >= 24u) {
                                                                                    phi_2390_ = (24u + ((_e1890 - 24u) ^ _e1388));
                                                                                } else {
                                                                                    phi_2390_ = _e1890;
                                                                                }
                                                                                let _e1896 = phi_2390_;
                                                                                phi_2395_ = (_e1798 | ((_e1889 >> bitcast<u32>(5i)) << bitcast<u32>((_e1896 & 31u))));
                                                                            } else {
                                                                                phi_2395_ = _e1798;
                                                                            }
                                                                            let _e1904 = phi_2395_;
                                                                            phi_2396_ = _e1904;
                                                                        } else {
                                                                            phi_2396_ = _e1798;
                                                                        }
                                                                        let _e1906 = phi_2396_;
                                                                        phi_2397_ = _e1906;
                                                                    } else {
                                                                        phi_2397_ = _e1798;
                                                                    }
                                                                    let _e1908 = phi_2397_;
                                                                    phi_2267_ = (_e1796 + 1u);
                                                                    phi_2270_ = _e1908;
                                                                } else {
                                                                    phi_2267_ = u32();
                                                                    phi_2270_ = u32();
                                                                }
                                                                let _e1911 = phi_2267_;
                                                                let _e1913 = phi_2270_;
                                                                continue;
                                                                continuing {
                                                                    phi_2266_ = _e1911;
                                                                    phi_2269_ = _e1913;
                                                                    break if !(_e1799);
                                                                }
                                                            }
                                                            let _e1917 = nodes.member[(0u + _e1528)].links[0u];
                                                            let _e1921 = nodes.member[(0u + _e1528)].frame[3u];
                                                            let _e1925 = local_6;
                                                            if ((_e1925 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1929 = local_1.group_mask;
                                                                if ((_e1929 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1933 = local_1.len;
                                                                    if (_e1933 < 32u) {
                                                                        let _e1936 = local_1.group;
                                                                        let _e1938 = local_1.len;
                                                                        if (_e1938 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.first[(0u + _e1938)] = _e1936;
                                                                        let _e1944 = local_1.group_mask;
                                                                        let _e1946 = local_1.len;
                                                                        if (_e1946 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.mask[(0u + _e1946)] = _e1944;
                                                                        let _e1953 = local_1.len;
                                                                        local_1.len = (_e1953 + 1u);
                                                                    }
                                                                }
                                                                local_1.group = (_e1150 + _e1917);
                                                                let _e1957 = local_7;
                                                                local_1.group_mask = ((_e1957 & 4278190080u) | (_e1921 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1962 = local_8;
                                                            phi_2455_ = _e1526;
                                                            phi_2458_ = (_e1962 & 16777215u);
                                                            loop {
                                                                let _e1965 = phi_2455_;
                                                                let _e1967 = phi_2458_;
                                                                local_9 = _e1965;
                                                                if (_e1967 == 0u) {
                                                                    phi_2456_ = lt_bvh_Hit();
                                                                    phi_2459_ = u32();
                                                                    phi_3100_ = false;
                                                                } else {
                                                                    let _e1971 = nodes.member[(0u + _e1528)].links[1u];
                                                                    let _e1976 = ((_e1152 + _e1971) + select(firstTrailingBit(_e1967), 32u, (_e1967 == 0u)));
                                                                    if (_e1976 < _e81) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1983 = triangles.member[(0u + _e1976)].v0_;
                                                                    let _e1985 = (_e1983.x - _e1075);
                                                                    let _e1987 = (_e1983.y - _e1088);
                                                                    let _e1989 = (_e1983.z - _e1101);
                                                                    if (_e1361 == 0u) {
                                                                        phi_2503_ = vec3<f32>(_e1987, _e1989, _e1985);
                                                                    } else {
                                                                        if (_e1361 == 1u) {
                                                                            phi_2502_ = vec3<f32>(_e1989, _e1985, _e1987);
                                                                        } else {
                                                                            phi_2502_ = (_e1983 - vec3<f32>(_e1075, _e1088, _e1101));
                                                                        }
                                                                        let _e1997 = phi_2502_;
                                                                        phi_2503_ = _e1997;
                                                                    }
                                                                    let _e1999 = phi_2503_;
                                                                    let _e2003 = (_e1999.x - (_e1372 * _e1999.z));
                                                                    let _e2007 = (_e1999.y - (_e1375 * _e1999.z));
                                                                    let _e2009 = triangles.member[(0u + _e1976)].v1_;
                                                                    let _e2011 = (_e2009.x - _e1075);
                                                                    let _e2013 = (_e2009.y - _e1088);
                                                                    let _e2015 = (_e2009.z - _e1101);
                                                                    if (_e1361 == 0u) {
                                                                        phi_2533_ = vec3<f32>(_e2013, _e2015, _e2011);
                                                                    } else {
                                                                        if (_e1361 == 1u) {
                                                                            phi_2532_ = vec3<f32>(_e2015, _e2011, _e2013);
                                                                        } else {
                                                                            phi_2532_ = (_e2009 - vec3<f32>(_e1075, _e1088, _e1101));
                                                                        }
                                                                        let _e2023 = phi_2532_;
                                                                        phi_2533_ = _e2023;
                                                                    }
                                                                    let _e2025 = phi_2533_;
                                                                    let _e2029 = (_e2025.x - (_e1372 * _e2025.z));
                                                                    let _e2033 = (_e2025.y - (_e1375 * _e2025.z));
                                                                    let _e2035 = triangles.member[(0u + _e1976)].v2_;
                                                                    let _e2037 = (_e2035.x - _e1075);
                                                                    let _e2039 = (_e2035.y - _e1088);
                                                                    let _e2041 = (_e2035.z - _e1101);
                                                                    if (_e1361 == 0u) {
                                                                        phi_2563_ = vec3<f32>(_e2039, _e2041, _e2037);
                                                                    } else {
                                                                        if (_e1361 == 1u) {
                                                                            phi_2562_ = vec3<f32>(_e2041, _e2037, _e2039);
                                                                        } else {
                                                                            phi_2562_ = (_e2035 - vec3<f32>(_e1075, _e1088, _e1101));
                                                                        }
                                                                        let _e2049 = phi_2562_;
                                                                        phi_2563_ = _e2049;
                                                                    }
                                                                    let _e2051 = phi_2563_;
                                                                    let _e2055 = (_e2051.x - (_e1372 * _e2051.z));
                                                                    let _e2059 = (_e2051.y - (_e1375 * _e2051.z));
                                                                    if (_e2029 < _e2055) {
                                                                        phi_2582_ = true;
                                                                    } else {
                                                                        if (_e2029 == _e2055) {
                                                                            phi_2581_ = (_e2033 < _e2059);
                                                                        } else {
                                                                            phi_2581_ = false;
                                                                        }
                                                                        let _e2064 = phi_2581_;
                                                                        phi_2582_ = _e2064;
                                                                    }
                                                                    let _e2066 = phi_2582_;
                                                                    if _e2066 {
                                                                        phi_2586_ = _e2059;
                                                                        phi_2587_ = _e2055;
                                                                        phi_2588_ = _e2033;
                                                                        phi_2589_ = _e2029;
                                                                    } else {
                                                                        phi_2586_ = _e2033;
                                                                        phi_2587_ = _e2029;
                                                                        phi_2588_ = _e2059;
                                                                        phi_2589_ = _e2055;
                                                                    }
                                                                    let _e2068 = phi_2586_;
                                                                    let _e2070 = phi_2587_;
                                                                    let _e2072 = phi_2588_;
                                                                    let _e2074 = phi_2589_;
                                                                    let _e2077 = ((_e2074 * _e2068) - (_e2072 * _e2070));
                                                                    if _e2066 {
                                                                        phi_2597_ = -(_e2077);
                                                                    } else {
                                                                        phi_2597_ = _e2077;
                                                                    }
                                                                    let _e2080 = phi_2597_;
                                                                    if (_e2055 < _e2003) {
                                                                        phi_2608_ = true;
                                                                    } else {
                                                                        if (_e2055 == _e2003) {
                                                                            phi_2607_ = (_e2059 < _e2007);
                                                                        } else {
                                                                            phi_2607_ = false;
                                                                        }
                                                                        let _e2085 = phi_2607_;
                                                                        phi_2608_ = _e2085;
                                                                    }
                                                                    let _e2087 = phi_2608_;
                                                                    if _e2087 {
                                                                        phi_2612_ = _e2007;
                                                                        phi_2613_ = _e2003;
                                                                        phi_2614_ = _e2059;
                                                                        phi_2615_ = _e2055;
                                                                    } else {
                                                                        phi_2612_ = _e2059;
                                                                        phi_2613_ = _e2055;
                                                                        phi_2614_ = _e2007;
                                                                        phi_2615_ = _e2003;
                                                                    }
                                                                    let _e2089 = phi_2612_;
                                                                    let _e2091 = phi_2613_;
                                                                    let _e2093 = phi_2614_;
                                                                    let _e2095 = phi_2615_;
                                                                    let _e2098 = ((_e2095 * _e2089) - (_e2093 * _e2091));
                                                                    if _e2087 {
                                                                        phi_2623_ = -(_e2098);
                                                                    } else {
                                                                        phi_2623_ = _e2098;
                                                                    }
                                                                    let _e2101 = phi_2623_;
                                                                    if (_e2003 < _e2029) {
                                                                        phi_2634_ = true;
                                                                    } else {
                                                                        if (_e2003 == _e2029) {
                                                                            phi_2633_ = (_e2007 < _e2033);
                                                                        } else {
                                                                            phi_2633_ = false;
                                                                        }
                                                                        let _e2106 = phi_2633_;
                                                                        phi_2634_ = _e2106;
                                                                    }
                                                                    let _e2108 = phi_2634_;
                                                                    if _e2108 {
                                                                        phi_2638_ = _e2033;
                                                                        phi_2639_ = _e2029;
                                                                        phi_2640_ = _e2007;
                                                                        phi_2641_ = _e2003;
                                                                    } else {
                                                                        phi_2638_ = _e2007;
                                                                        phi_2639_ = _e2003;
                                                                        phi_2640_ = _e2033;
                                                                        phi_2641_ = _e2029;
                                                                    }
                                                                    let _e2110 = phi_2638_;
                                                                    let _e2112 = phi_2639_;
                                                                    let _e2114 = phi_2640_;
                                                                    let _e2116 = phi_2641_;
                                                                    let _e2119 = ((_e2116 * _e2110) - (_e2114 * _e2112));
                                                                    if _e2108 {
                                                                        phi_2649_ = -(_e2119);
                                                                    } else {
                                                                        phi_2649_ = _e2119;
                                                                    }
                                                                    let _e2122 = phi_2649_;
                                                                    if (_e2080 >= 0f) {
                                                                        if (_e2101 >= 0f) {
                                                                            if (_e2122 >= 0f) {
                                                                                phi_2664_ = ((_e2080 + _e2101) + _e2122);
                                                                                phi_2665_ = false;
                                                                            } else {
                                                                                phi_2664_ = f32();
                                                                                phi_2665_ = true;
                                                                            }
                                                                            let _e2129 = phi_2664_;
                                                                            let _e2131 = phi_2665_;
                                                                            phi_2666_ = _e2129;
                                                                            phi_2667_ = _e2131;
                                                                        } else {
                                                                            phi_2666_ = f32();
                                                                            phi_2667_ = true;
                                                                        }
                                                                        let _e2133 = phi_2666_;
                                                                        let _e2135 = phi_2667_;
                                                                        phi_2668_ = _e2133;
                                                                        phi_2669_ = _e2135;
                                                                    } else {
                                                                        phi_2668_ = f32();
                                                                        phi_2669_ = true;
                                                                    }
                                                                    let _e2137 = phi_2668_;
                                                                    let _e2139 = phi_2669_;
                                                                    if _e2139 {
                                                                        if (_e2080 <= 0f) {
                                                                            if (_e2101 <= 0f) {
                                                                                let _e2142 = (_e2122 <= 0f);
                                                                                if _e2142 {
                                                                                }
                                                                                phi_2687_ = ((_e2080 + _e2101) + _e2122);
                                                                                phi_2688_ = false;
                                                                                phi_2689_ = _e2142;
                                                                            } else {
                                                                                phi_2687_ = f32();
                                                                                phi_2688_ = true;
                                                                                phi_2689_ = false;
                                                                            }
                                                                            let _e2146 = phi_2687_;
                                                                            let _e2148 = phi_2688_;
                                                                            let _e2150 = phi_2689_;
                                                                            phi_2690_ = _e2146;
                                                                            phi_2691_ = _e2148;
                                                                            phi_2692_ = _e2150;
                                                                        } else {
                                                                            phi_2690_ = f32();
                                                                            phi_2691_ = true;
                                                                            phi_2692_ = false;
                                                                        }
                                                                        let _e2152 = phi_2690_;
                                                                        let _e2154 = phi_2691_;
                                                                        let _e2156 = phi_2692_;
                                                                        if _e2154 {
                                                                            phi_2696_ = false;
                                                                        } else {
                                                                            phi_2696_ = _e2156;
                                                                        }
                                                                        let _e2158 = phi_2696_;
                                                                        phi_2697_ = _e2152;
                                                                        phi_2698_ = _e2158;
                                                                    } else {
                                                                        phi_2697_ = _e2137;
                                                                        phi_2698_ = true;
                                                                    }
                                                                    let _e2160 = phi_2697_;
                                                                    let _e2162 = phi_2698_;
                                                                    if _e2162 {
                                                                        let _e2163 = (_e2160 == 0f);
                                                                        if _e2163 {
                                                                            phi_3014_ = lt_bvh_triangle_Intersection();
                                                                            phi_3015_ = false;
                                                                        } else {
                                                                            let _e2165 = triangles.member[(0u + _e1976)].v0_;
                                                                            let _e2167 = (_e2165.x - _e1075);
                                                                            let _e2169 = (_e2165.y - _e1088);
                                                                            let _e2171 = (_e2165.z - _e1101);
                                                                            if (_e1361 == 0u) {
                                                                                phi_2727_ = vec3<f32>(_e2169, _e2171, _e2167);
                                                                            } else {
                                                                                if (_e1361 == 1u) {
                                                                                    phi_2726_ = vec3<f32>(_e2171, _e2167, _e2169);
                                                                                } else {
                                                                                    phi_2726_ = (_e2165 - vec3<f32>(_e1075, _e1088, _e1101));
                                                                                }
                                                                                let _e2179 = phi_2726_;
                                                                                phi_2727_ = _e2179;
                                                                            }
                                                                            let _e2181 = phi_2727_;
                                                                            let _e2183 = triangles.member[(0u + _e1976)].v1_;
                                                                            let _e2185 = triangles.member[(0u + _e1976)].v0_;
                                                                            let _e2188 = (_e2183.x - _e2185.x);
                                                                            let _e2191 = (_e2183.y - _e2185.y);
                                                                            let _e2194 = (_e2183.z - _e2185.z);
                                                                            if (_e1361 == 0u) {
                                                                                phi_2753_ = vec3<f32>(_e2191, _e2194, _e2188);
                                                                            } else {
                                                                                if (_e1361 == 1u) {
                                                                                    phi_2752_ = vec3<f32>(_e2194, _e2188, _e2191);
                                                                                } else {
                                                                                    phi_2752_ = (_e2183 - _e2185);
                                                                                }
                                                                                let _e2201 = phi_2752_;
                                                                                phi_2753_ = _e2201;
                                                                            }
                                                                            let _e2203 = phi_2753_;
                                                                            let _e2205 = triangles.member[(0u + _e1976)].v2_;
                                                                            let _e2207 = triangles.member[(0u + _e1976)].v0_;
                                                                            let _e2210 = (_e2205.x - _e2207.x);
                                                                            let _e2213 = (_e2205.y - _e2207.y);
                                                                            let _e2216 = (_e2205.z - _e2207.z);
                                                                            if (_e1361 == 0u) {
                                                                                phi_2779_ = vec3<f32>(_e2213, _e2216, _e2210);
                                                                            } else {
                                                                                if (_e1361 == 1u) {
                                                                                    phi_2778_ = vec3<f32>(_e2216, _e2210, _e2213);
                                                                                } else {
                                                                                    phi_2778_ = (_e2205 - _e2207);
                                                                                }
                                                                                let _e2223 = phi_2778_;
                                                                                phi_2779_ = _e2223;
                                                                            }
                                                                            let _e2225 = phi_2779_;
                                                                            let _e2232 = ((_e2203.y * _e2225.z) - (_e2203.z * _e2225.y));
                                                                            let _e2239 = ((_e2203.z * _e2225.x) - (_e2203.x * _e2225.z));
                                                                            let _e2246 = ((_e2203.x * _e2225.y) - (_e2203.y * _e2225.x));
                                                                            let _e2260 = (((1f / _e1369.z) * (((_e2232 * _e2181.x) + (_e2239 * _e2181.y)) + (_e2246 * _e2181.z))) / (((_e2232 * _e1372) + (_e2239 * _e1375)) + _e2246));
                                                                            if (_e2260 > _e165.tmin) {
                                                                                if (_e2260 < _e165.tmax) {
                                                                                    let _e2264 = triangles.member[(0u + _e1976)].v0_;
                                                                                    let _e2266 = triangles.member[(0u + _e1976)].v1_;
                                                                                    if (_e2264.x < _e2266.x) {
                                                                                        phi_2835_ = _e2264.x;
                                                                                    } else {
                                                                                        phi_2835_ = _e2266.x;
                                                                                    }
                                                                                    let _e2273 = phi_2835_;
                                                                                    if (_e2264.y < _e2266.y) {
                                                                                        phi_2844_ = _e2264.y;
                                                                                    } else {
                                                                                        phi_2844_ = _e2266.y;
                                                                                    }
                                                                                    let _e2280 = phi_2844_;
                                                                                    if (_e2264.z < _e2266.z) {
                                                                                        phi_2853_ = _e2264.z;
                                                                                    } else {
                                                                                        phi_2853_ = _e2266.z;
                                                                                    }
                                                                                    let _e2287 = phi_2853_;
                                                                                    let _e2289 = triangles.member[(0u + _e1976)].v2_;
                                                                                    if (_e2273 < _e2289.x) {
                                                                                        phi_2862_ = _e2273;
                                                                                    } else {
                                                                                        phi_2862_ = _e2289.x;
                                                                                    }
                                                                                    let _e2294 = phi_2862_;
                                                                                    if (_e2280 < _e2289.y) {
                                                                                        phi_2869_ = _e2280;
                                                                                    } else {
                                                                                        phi_2869_ = _e2289.y;
                                                                                    }
                                                                                    let _e2299 = phi_2869_;
                                                                                    if (_e2287 < _e2289.z) {
                                                                                        phi_2876_ = _e2287;
                                                                                    } else {
                                                                                        phi_2876_ = _e2289.z;
                                                                                    }
                                                                                    let _e2304 = phi_2876_;
                                                                                    let _e2306 = triangles.member[(0u + _e1976)].v0_;
                                                                                    let _e2308 = triangles.member[(0u + _e1976)].v1_;
                                                                                    if (_e2306.x > _e2308.x) {
                                                                                        phi_2889_ = _e2306.x;
                                                                                    } else {
                                                                                        phi_2889_ = _e2308.x;
                                                                                    }
                                                                                    let _e2315 = phi_2889_;
                                                                                    if (_e2306.y > _e2308.y) {
                                                                                        phi_2898_ = _e2306.y;
                                                                                    } else {
                                                                                        phi_2898_ = _e2308.y;
                                                                                    }
                                                                                    let _e2322 = phi_2898_;
                                                                                    if (_e2306.z > _e2308.z) {
                                                                                        phi_2907_ = _e2306.z;
                                                                                    } else {
                                                                                        phi_2907_ = _e2308.z;
                                                                                    }
                                                                                    let _e2329 = phi_2907_;
                                                                                    let _e2331 = triangles.member[(0u + _e1976)].v2_;
                                                                                    if (_e2315 > _e2331.x) {
                                                                                        phi_2916_ = _e2315;
                                                                                    } else {
                                                                                        phi_2916_ = _e2331.x;
                                                                                    }
                                                                                    let _e2336 = phi_2916_;
                                                                                    if (_e2322 > _e2331.y) {
                                                                                        phi_2923_ = _e2322;
                                                                                    } else {
                                                                                        phi_2923_ = _e2331.y;
                                                                                    }
                                                                                    let _e2341 = phi_2923_;
                                                                                    if (_e2329 > _e2331.z) {
                                                                                        phi_2930_ = _e2329;
                                                                                    } else {
                                                                                        phi_2930_ = _e2331.z;
                                                                                    }
                                                                                    let _e2346 = phi_2930_;
                                                                                    let _e2350 = ((_e2294 - _e1075) * _e1290);
                                                                                    let _e2351 = ((_e2299 - _e1088) * _e1300);
                                                                                    let _e2352 = ((_e2304 - _e1101) * _e1310);
                                                                                    let _e2356 = ((_e2336 - _e1075) * _e1290);
                                                                                    let _e2357 = ((_e2341 - _e1088) * _e1300);
                                                                                    let _e2358 = ((_e2346 - _e1101) * _e1310);
                                                                                    if (_e2350 < _e2356) {
                                                                                        phi_2947_ = _e2350;
                                                                                    } else {
                                                                                        phi_2947_ = _e2356;
                                                                                    }
                                                                                    let _e2361 = phi_2947_;
                                                                                    if (_e2351 < _e2357) {
                                                                                        phi_2952_ = _e2351;
                                                                                    } else {
                                                                                        phi_2952_ = _e2357;
                                                                                    }
                                                                                    let _e2364 = phi_2952_;
                                                                                    if (_e2352 < _e2358) {
                                                                                        phi_2957_ = _e2352;
                                                                                    } else {
                                                                                        phi_2957_ = _e2358;
                                                                                    }
                                                                                    let _e2367 = phi_2957_;
                                                                                    if (_e2350 > _e2356) {
                                                                                        phi_2965_ = _e2350;
                                                                                    } else {
                                                                                        phi_2965_ = _e2356;
                                                                                    }
                                                                                    let _e2373 = phi_2965_;
                                                                                    if (_e2351 > _e2357) {
                                                                                        phi_2970_ = _e2351;
                                                                                    } else {
                                                                                        phi_2970_ = _e2357;
                                                                                    }
                                                                                    let _e2376 = phi_2970_;
                                                                                    if (_e2352 > _e2358) {
                                                                                        phi_2975_ = _e2352;
                                                                                    } else {
                                                                                        phi_2975_ = _e2358;
                                                                                    }
                                                                                    let _e2379 = phi_2975_;
                                                                                    let _e2383 = core_intrinsics_maximum_number_nsz_f32_((_e2361 - _e1345), (_e2364 - _e1346));
                                                                                    let _e2384 = core_intrinsics_maximum_number_nsz_f32_(_e2383, (_e2367 - _e1347));
                                                                                    let _e2385 = core_intrinsics_minimum_number_nsz_f32_((_e2373 + _e1345), (_e2376 + _e1346));
                                                                                    let _e2386 = core_intrinsics_minimum_number_nsz_f32_(_e2385, (_e2379 + _e1347));
                                                                                    if (_e2384 > _e1050) {
                                                                                        phi_2987_ = _e2384;
                                                                                    } else {
                                                                                        phi_2987_ = _e1050;
                                                                                    }
                                                                                    let _e2389 = phi_2987_;
                                                                                    if (_e2386 < _e1052) {
                                                                                        phi_2992_ = _e2386;
                                                                                    } else {
                                                                                        phi_2992_ = _e1052;
                                                                                    }
                                                                                    let _e2392 = phi_2992_;
                                                                                    if (_e2260 < _e2389) {
                                                                                        phi_2997_ = _e2389;
                                                                                    } else {
                                                                                        phi_2997_ = _e2260;
                                                                                    }
                                                                                    let _e2395 = phi_2997_;
                                                                                    if (_e2395 > _e2392) {
                                                                                        phi_3002_ = _e2392;
                                                                                    } else {
                                                                                        phi_3002_ = _e2395;
                                                                                    }
                                                                                    let _e2398 = phi_3002_;
                                                                                    phi_3007_ = lt_bvh_triangle_Intersection(_e2398, (_e2101 / _e2160), (_e2122 / _e2160), (_e2389 <= _e2392));
                                                                                    phi_3008_ = false;
                                                                                } else {
                                                                                    phi_3007_ = lt_bvh_triangle_Intersection();
                                                                                    phi_3008_ = true;
                                                                                }
                                                                                let _e2404 = phi_3007_;
                                                                                let _e2406 = phi_3008_;
                                                                                phi_3009_ = _e2404;
                                                                                phi_3010_ = _e2406;
                                                                            } else {
                                                                                phi_3009_ = lt_bvh_triangle_Intersection();
                                                                                phi_3010_ = true;
                                                                            }
                                                                            let _e2408 = phi_3009_;
                                                                            let _e2410 = phi_3010_;
                                                                            if _e2410 {
                                                                            }
                                                                            phi_3014_ = _e2408;
                                                                            phi_3015_ = _e2410;
                                                                        }
                                                                        let _e2412 = phi_3014_;
                                                                        let _e2414 = phi_3015_;
                                                                        phi_3016_ = _e2412;
                                                                        phi_3017_ = _e2163;
                                                                        phi_3018_ = _e2414;
                                                                    } else {
                                                                        phi_3016_ = lt_bvh_triangle_Intersection();
                                                                        phi_3017_ = true;
                                                                        phi_3018_ = false;
                                                                    }
                                                                    let _e2416 = phi_3016_;
                                                                    let _e2418 = phi_3017_;
                                                                    let _e2420 = phi_3018_;
                                                                    if _e2418 {
                                                                        phi_3022_ = true;
                                                                    } else {
                                                                        phi_3022_ = _e2420;
                                                                    }
                                                                    let _e2422 = phi_3022_;
                                                                    if _e2422 {
                                                                        phi_3026_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_3026_ = _e2416;
                                                                    }
                                                                    let _e2424 = phi_3026_;
                                                                    if _e2424.is_hit {
                                                                        if (_e2424.t > _e165.tmin) {
                                                                            if (_e2424.t < _e1965.t) {
                                                                                phi_3074_ = true;
                                                                            } else {
                                                                                if (_e2424.t == _e1965.t) {
                                                                                    if (_e1965.triangle != 4294967295u) {
                                                                                        if (_e1976 < _e1965.triangle) {
                                                                                            phi_3065_ = true;
                                                                                        } else {
                                                                                            if (_e1976 == _e1965.triangle) {
                                                                                                phi_3064_ = (_e991 < _e1965.instance);
                                                                                            } else {
                                                                                                phi_3064_ = false;
                                                                                            }
                                                                                            let _e2442 = phi_3064_;
                                                                                            phi_3065_ = _e2442;
                                                                                        }
                                                                                        let _e2444 = phi_3065_;
                                                                                        phi_3066_ = _e2444;
                                                                                        phi_3067_ = false;
                                                                                    } else {
                                                                                        phi_3066_ = bool();
                                                                                        phi_3067_ = true;
                                                                                    }
                                                                                    let _e2446 = phi_3066_;
                                                                                    let _e2448 = phi_3067_;
                                                                                    phi_3068_ = _e2446;
                                                                                    phi_3069_ = _e2448;
                                                                                } else {
                                                                                    phi_3068_ = bool();
                                                                                    phi_3069_ = true;
                                                                                }
                                                                                let _e2450 = phi_3068_;
                                                                                let _e2452 = phi_3069_;
                                                                                if _e2452 {
                                                                                    phi_3073_ = false;
                                                                                } else {
                                                                                    phi_3073_ = _e2450;
                                                                                }
                                                                                let _e2454 = phi_3073_;
                                                                                phi_3074_ = _e2454;
                                                                            }
                                                                            let _e2456 = phi_3074_;
                                                                            if _e2456 {
                                                                                let _e2458 = triangles.member[(0u + _e1976)].i0_;
                                                                                if ((_e2458 & 2147483648u) == 0u) {
                                                                                    phi_3088_ = true;
                                                                                } else {
                                                                                    if true {
                                                                                    }
                                                                                    phi_3088_ = true;
                                                                                }
                                                                                let _e2462 = phi_3088_;
                                                                                if _e2462 {
                                                                                    phi_3096_ = lt_bvh_Hit(_e2424.t, _e2424.u, _e2424.v, _e1976, _e991);
                                                                                } else {
                                                                                    phi_3096_ = _e1965;
                                                                                }
                                                                                let _e2468 = phi_3096_;
                                                                                phi_3097_ = _e2468;
                                                                            } else {
                                                                                phi_3097_ = _e1965;
                                                                            }
                                                                            let _e2470 = phi_3097_;
                                                                            phi_3098_ = _e2470;
                                                                        } else {
                                                                            phi_3098_ = _e1965;
                                                                        }
                                                                        let _e2472 = phi_3098_;
                                                                        phi_3099_ = _e2472;
                                                                    } else {
                                                                        phi_3099_ = _e1965;
                                                                    }
                                                                    let _e2474 = phi_3099_;
                                                                    phi_2456_ = _e2474;
                                                                    phi_2459_ = (_e1967 & (_e1967 - 1u));
                                                                    phi_3100_ = true;
                                                                }
                                                                let _e2476 = phi_2456_;
                                                                let _e2478 = phi_2459_;
                                                                let _e2480 = phi_3100_;
                                                                continue;
                                                                continuing {
                                                                    phi_2455_ = _e2476;
                                                                    phi_2458_ = _e2478;
                                                                    break if !(_e2480);
                                                                }
                                                            }
                                                            let _e2483 = local_1.group_mask;
                                                            if ((_e2483 & 4278190080u) == 0u) {
                                                                let _e2487 = local_1.len;
                                                                if (_e2487 == 0u) {
                                                                    phi_3139_ = false;
                                                                } else {
                                                                    let _e2491 = local_1.len;
                                                                    local_1.len = (_e2491 - 1u);
                                                                    let _e2494 = local_1.len;
                                                                    if (_e2494 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2499 = local_1.first[(0u + _e2494)];
                                                                    local_1.group = _e2499;
                                                                    let _e2502 = local_1.len;
                                                                    if (_e2502 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2507 = local_1.mask[(0u + _e2502)];
                                                                    local_1.group_mask = _e2507;
                                                                    phi_3139_ = true;
                                                                }
                                                                let _e2510 = phi_3139_;
                                                                phi_3140_ = _e2510;
                                                            } else {
                                                                phi_3140_ = true;
                                                            }
                                                            let _e2512 = phi_3140_;
                                                            if _e2512 {
                                                                let _e2514 = local_1.group_mask;
                                                                let _e2520 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2514)), 32u, (_e2514 == 0u)));
                                                                let _e2524 = local_1.group_mask;
                                                                let _e2538 = local_1.group_mask;
                                                                local_1.group_mask = (_e2538 & ~((1u << bitcast<u32>((_e2520 & 31u)))));
                                                                let _e2541 = local_1.group;
                                                                phi_3171_ = (_e2541 + countOneBits(((_e2524 & ~((4294967295u << bitcast<u32>((((_e2520 - 24u) ^ _e1388) & 31u))))) & 255u)));
                                                            } else {
                                                                phi_3171_ = 4294967295u;
                                                            }
                                                            let _e2544 = phi_3171_;
                                                            let _e3867 = local_9;
                                                            phi_2123_ = _e3867;
                                                            phi_2126_ = _e2544;
                                                        } else {
                                                            phi_2123_ = lt_bvh_Hit();
                                                            phi_2126_ = u32();
                                                        }
                                                        let _e2546 = phi_2123_;
                                                        let _e2548 = phi_2126_;
                                                        continue;
                                                        continuing {
                                                            phi_2122_ = _e2546;
                                                            phi_2125_ = _e2548;
                                                            break if !(_e1529);
                                                        }
                                                    }
                                                    let _e3871 = local_10;
                                                    phi_3172_ = _e3871;
                                                }
                                                let _e2551 = phi_3172_;
                                                phi_3173_ = _e2551;
                                                phi_3174_ = _e1214;
                                            } else {
                                                phi_3173_ = lt_bvh_Hit();
                                                phi_3174_ = true;
                                            }
                                            let _e2553 = phi_3173_;
                                            let _e2555 = phi_3174_;
                                            if _e2555 {
                                                phi_3178_ = _e983;
                                            } else {
                                                phi_3178_ = _e2553;
                                            }
                                            let _e2557 = phi_3178_;
                                            phi_3179_ = _e2557;
                                        } else {
                                            phi_3179_ = _e983;
                                        }
                                        let _e2559 = phi_3179_;
                                        phi_3180_ = _e2559;
                                    } else {
                                        phi_3180_ = _e983;
                                    }
                                    let _e2561 = phi_3180_;
                                    phi_3181_ = _e2561;
                                } else {
                                    phi_3181_ = _e983;
                                }
                                let _e2563 = phi_3181_;
                                phi_1497_ = (_e981 & (_e981 - 1u));
                                phi_1500_ = _e2563;
                                phi_3182_ = true;
                            }
                            let _e2565 = phi_1497_;
                            let _e2567 = phi_1500_;
                            let _e2569 = phi_3182_;
                            continue;
                            continuing {
                                phi_1496_ = _e2565;
                                phi_1499_ = _e2567;
                                break if !(_e2569);
                            }
                        }
                        let _e2572 = local_2.group_mask;
                        if ((_e2572 & 4278190080u) == 0u) {
                            let _e2576 = local_2.len;
                            if (_e2576 == 0u) {
                                phi_3221_ = false;
                            } else {
                                let _e2580 = local_2.len;
                                local_2.len = (_e2580 - 1u);
                                let _e2583 = local_2.len;
                                if (_e2583 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2588 = local_2.first[(0u + _e2583)];
                                local_2.group = _e2588;
                                let _e2591 = local_2.len;
                                if (_e2591 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2596 = local_2.mask[(0u + _e2591)];
                                local_2.group_mask = _e2596;
                                phi_3221_ = true;
                            }
                            let _e2599 = phi_3221_;
                            phi_3222_ = _e2599;
                        } else {
                            phi_3222_ = true;
                        }
                        let _e2601 = phi_3222_;
                        if _e2601 {
                            let _e2603 = local_2.group_mask;
                            let _e2609 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2603)), 32u, (_e2603 == 0u)));
                            let _e2613 = local_2.group_mask;
                            let _e2627 = local_2.group_mask;
                            local_2.group_mask = (_e2627 & ~((1u << bitcast<u32>((_e2609 & 31u)))));
                            let _e2630 = local_2.group;
                            phi_3253_ = (_e2630 + countOneBits(((_e2613 & ~((4294967295u << bitcast<u32>((((_e2609 - 24u) ^ _e400) & 31u))))) & 255u)));
                        } else {
                            phi_3253_ = 4294967295u;
                        }
                        let _e2633 = phi_3253_;
                        phi_1160_ = _e2633;
                        let _e3887 = local_11;
                        phi_1163_ = _e3887;
                    } else {
                        phi_1160_ = u32();
                        phi_1163_ = lt_bvh_Hit();
                    }
                    let _e2635 = phi_1160_;
                    let _e2637 = phi_1163_;
                    continue;
                    continuing {
                        phi_1159_ = _e2635;
                        phi_1162_ = _e2637;
                        break if !(_e541);
                    }
                }
                let _e3890 = local_12;
                phi_3254_ = _e3890;
            }
            let _e2640 = phi_3254_;
            phi_3255_ = _e2640;
            phi_3256_ = _e237;
        } else {
            phi_3255_ = lt_bvh_Hit();
            phi_3256_ = true;
        }
        let _e2642 = phi_3255_;
        let _e2644 = phi_3256_;
        if _e2644 {
            phi_3260_ = _e167;
        } else {
            phi_3260_ = _e2642;
        }
        let _e2646 = phi_3260_;
        if (_e2646.triangle != 4294967295u) {
            let _e2652 = ((1f - _e2646.u) - _e2646.v);
            if (_e2646.triangle < _e81) {
            } else {
                return;
            }
            let _e2657 = triangles.member[(0u + _e2646.triangle)];
            if (_e2646.instance < _e93) {
            } else {
                return;
            }
            let _e2668 = instances.member[(0u + _e2646.instance)].object_to_world[0u];
            let _e2679 = ((((_e2668.x * _e2657.v0_.x) + (_e2668.y * _e2657.v0_.y)) + (_e2668.z * _e2657.v0_.z)) + (_e2668.w * 1f));
            let _e2681 = instances.member[(0u + _e2646.instance)].object_to_world[1u];
            let _e2692 = ((((_e2681.x * _e2657.v0_.x) + (_e2681.y * _e2657.v0_.y)) + (_e2681.z * _e2657.v0_.z)) + (_e2681.w * 1f));
            let _e2694 = instances.member[(0u + _e2646.instance)].object_to_world[2u];
            let _e2705 = ((((_e2694.x * _e2657.v0_.x) + (_e2694.y * _e2657.v0_.y)) + (_e2694.z * _e2657.v0_.z)) + (_e2694.w * 1f));
            let _e2712 = instances.member[(0u + _e2646.instance)].object_to_world[0u];
            let _e2723 = ((((_e2712.x * _e2657.v1_.x) + (_e2712.y * _e2657.v1_.y)) + (_e2712.z * _e2657.v1_.z)) + (_e2712.w * 1f));
            let _e2725 = instances.member[(0u + _e2646.instance)].object_to_world[1u];
            let _e2736 = ((((_e2725.x * _e2657.v1_.x) + (_e2725.y * _e2657.v1_.y)) + (_e2725.z * _e2657.v1_.z)) + (_e2725.w * 1f));
            let _e2738 = instances.member[(0u + _e2646.instance)].object_to_world[2u];
            let _e2749 = ((((_e2738.x * _e2657.v1_.x) + (_e2738.y * _e2657.v1_.y)) + (_e2738.z * _e2657.v1_.z)) + (_e2738.w * 1f));
            let _e2756 = instances.member[(0u + _e2646.instance)].object_to_world[0u];
            let _e2767 = ((((_e2756.x * _e2657.v2_.x) + (_e2756.y * _e2657.v2_.y)) + (_e2756.z * _e2657.v2_.z)) + (_e2756.w * 1f));
            let _e2769 = instances.member[(0u + _e2646.instance)].object_to_world[1u];
            let _e2780 = ((((_e2769.x * _e2657.v2_.x) + (_e2769.y * _e2657.v2_.y)) + (_e2769.z * _e2657.v2_.z)) + (_e2769.w * 1f));
            let _e2782 = instances.member[(0u + _e2646.instance)].object_to_world[2u];
            let _e2793 = ((((_e2782.x * _e2657.v2_.x) + (_e2782.y * _e2657.v2_.y)) + (_e2782.z * _e2657.v2_.z)) + (_e2782.w * 1f));
            let _e2806 = (((_e2679 * _e2652) + (_e2723 * _e2646.u)) + (_e2767 * _e2646.v));
            let _e2807 = (((_e2692 * _e2652) + (_e2736 * _e2646.u)) + (_e2780 * _e2646.v));
            let _e2808 = (((_e2705 * _e2652) + (_e2749 * _e2646.u)) + (_e2793 * _e2646.v));
            let _e2810 = abs(_e2679);
            let _e2811 = abs(_e2692);
            let _e2812 = abs(_e2705);
            let _e2813 = abs(_e2723);
            let _e2814 = abs(_e2736);
            let _e2815 = abs(_e2749);
            if (_e2810 > _e2813) {
                phi_3447_ = _e2810;
            } else {
                phi_3447_ = _e2813;
            }
            let _e2818 = phi_3447_;
            if (_e2811 > _e2814) {
                phi_3452_ = _e2811;
            } else {
                phi_3452_ = _e2814;
            }
            let _e2821 = phi_3452_;
            if (_e2812 > _e2815) {
                phi_3457_ = _e2812;
            } else {
                phi_3457_ = _e2815;
            }
            let _e2824 = phi_3457_;
            let _e2825 = abs(_e2767);
            let _e2826 = abs(_e2780);
            let _e2827 = abs(_e2793);
            if (_e2818 > _e2825) {
                phi_3465_ = _e2818;
            } else {
                phi_3465_ = _e2825;
            }
            let _e2830 = phi_3465_;
            if (_e2821 > _e2826) {
                phi_3470_ = _e2821;
            } else {
                phi_3470_ = _e2826;
            }
            let _e2833 = phi_3470_;
            if (_e2824 > _e2827) {
                phi_3475_ = _e2824;
            } else {
                phi_3475_ = _e2827;
            }
            let _e2836 = phi_3475_;
            let _e2837 = (_e2723 - _e2679);
            let _e2838 = (_e2736 - _e2692);
            let _e2839 = (_e2749 - _e2705);
            let _e2840 = (_e2767 - _e2679);
            let _e2841 = (_e2780 - _e2692);
            let _e2842 = (_e2793 - _e2705);
            let _e2846 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2838), abs(_e2839));
            let _e2847 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2837), _e2846);
            let _e2848 = (_e2837 / _e2847);
            let _e2849 = (_e2838 / _e2847);
            let _e2850 = (_e2839 / _e2847);
            let _e2854 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2841), abs(_e2842));
            let _e2855 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2840), _e2854);
            let _e2856 = (_e2840 / _e2855);
            let _e2857 = (_e2841 / _e2855);
            let _e2858 = (_e2842 / _e2855);
            let _e2861 = ((_e2849 * _e2858) - (_e2857 * _e2850));
            let _e2864 = ((_e2850 * _e2856) - (_e2858 * _e2848));
            let _e2867 = ((_e2848 * _e2857) - (_e2856 * _e2849));
            let _e2869 = p.member.eye;
            let _e2882 = (1f / sqrt((((_e2861 * _e2861) + (_e2864 * _e2864)) + (_e2867 * _e2867))));
            let _e2883 = (_e2861 * _e2882);
            let _e2884 = (_e2864 * _e2882);
            let _e2885 = (_e2867 * _e2882);
            if ((((_e2883 * (_e2869.x - _e2806)) + (_e2884 * (_e2869.y - _e2807))) + (_e2885 * (_e2869.z - _e2808))) < 0f) {
                phi_3539_ = vec3<f32>(-(_e2883), -(_e2884), -(_e2885));
            } else {
                phi_3539_ = vec3<f32>(_e2883, _e2884, _e2885);
            }
            let _e2898 = phi_3539_;
            if (_e2646.triangle < _e81) {
            } else {
                return;
            }
            let _e2903 = triangles.member[(0u + _e2646.triangle)];
            let _e2905 = (_e2903.i0_ & 2147483647u);
            if (_e2905 < _e84) {
            } else {
                return;
            }
            let _e2911 = vertices.member[(0u + _e2905)];
            if (_e2903.i1_ < _e84) {
            } else {
                return;
            }
            let _e2915 = vertices.member[(0u + _e2903.i1_)];
            if (_e2903.i2_ < _e84) {
            } else {
                return;
            }
            let _e2919 = vertices.member[(0u + _e2903.i2_)];
            let _e2920 = array<abi_Vertex, 3>(_e2911, _e2915, _e2919);
            if (_e2920[0].material < arrayLength((&materials.member))) {
            } else {
                return;
            }
            let _e2926 = materials.member[(0u + _e2920[0].material)];
            let _e2943 = (1f / 255f);
            let _e2962 = (1f / 255f);
            let _e2984 = (1f / 255f);
            if (_e2926.color_size == 0u) {
                phi_3782_ = vec3<f32>(1f, 1f, 1f);
            } else {
                local.offset = _e2926.color_offset;
                local.size = _e2926.color_size;
                local.flags = _e2926.flags;
                let _e3027 = _lt_shaders_texture_TextureView_quad((&local), (((_e2920[0].u * _e2652) + (_e2920[1].u * _e2646.u)) + (_e2920[2].u * _e2646.v)), (((_e2920[0].v * _e2652) + (_e2920[1].v * _e2646.u)) + (_e2920[2].v * _e2646.v)));
                if (_e3027.indices[0] < _e96) {
                } else {
                    return;
                }
                let _e3033 = color_texels.member[(0u + _e3027.indices[0])];
                let _e3044 = (1f / 255f);
                if (_e3027.indices[1] < _e96) {
                } else {
                    return;
                }
                let _e3058 = color_texels.member[(0u + _e3027.indices[1])];
                let _e3069 = (1f / 255f);
                if (_e3027.indices[2] < _e96) {
                } else {
                    return;
                }
                let _e3086 = color_texels.member[(0u + _e3027.indices[2])];
                let _e3097 = (1f / 255f);
                if (_e3027.indices[3] < _e96) {
                } else {
                    return;
                }
                let _e3114 = color_texels.member[(0u + _e3027.indices[3])];
                let _e3125 = (1f / 255f);
                let _e3134 = (((((f32((_e3033 & 255u)) * _e3044) * _e3027.weights.x) + ((f32((_e3058 & 255u)) * _e3069) * _e3027.weights.y)) + ((f32((_e3086 & 255u)) * _e3097) * _e3027.weights.z)) + ((f32((_e3114 & 255u)) * _e3125) * _e3027.weights.w));
                let _e3135 = (((((f32(((_e3033 >> bitcast<u32>(8i)) & 255u)) * _e3044) * _e3027.weights.x) + ((f32(((_e3058 >> bitcast<u32>(8i)) & 255u)) * _e3069) * _e3027.weights.y)) + ((f32(((_e3086 >> bitcast<u32>(8i)) & 255u)) * _e3097) * _e3027.weights.z)) + ((f32(((_e3114 >> bitcast<u32>(8i)) & 255u)) * _e3125) * _e3027.weights.w));
                let _e3136 = (((((f32(((_e3033 >> bitcast<u32>(16i)) & 255u)) * _e3044) * _e3027.weights.x) + ((f32(((_e3058 >> bitcast<u32>(16i)) & 255u)) * _e3069) * _e3027.weights.y)) + ((f32(((_e3086 >> bitcast<u32>(16i)) & 255u)) * _e3097) * _e3027.weights.z)) + ((f32(((_e3114 >> bitcast<u32>(16i)) & 255u)) * _e3125) * _e3027.weights.w));
                phi_3782_ = vec3<f32>((_e3134 * _e3134), (_e3135 * _e3135), (_e3136 * _e3136));
            }
            let _e3142 = phi_3782_;
            let _e3144 = ((_e2926.base_color.x * ((((f32((_e2920[0].color & 255u)) * _e2943) * _e2652) + ((f32((_e2920[1].color & 255u)) * _e2962) * _e2646.u)) + ((f32((_e2920[2].color & 255u)) * _e2984) * _e2646.v))) * _e3142.x);
            let _e3146 = ((_e2926.base_color.y * ((((f32(((_e2920[0].color >> bitcast<u32>(8i)) & 255u)) * _e2943) * _e2652) + ((f32(((_e2920[1].color >> bitcast<u32>(8i)) & 255u)) * _e2962) * _e2646.u)) + ((f32(((_e2920[2].color >> bitcast<u32>(8i)) & 255u)) * _e2984) * _e2646.v))) * _e3142.y);
            let _e3148 = ((_e2926.base_color.z * ((((f32(((_e2920[0].color >> bitcast<u32>(16i)) & 255u)) * _e2943) * _e2652) + ((f32(((_e2920[1].color >> bitcast<u32>(16i)) & 255u)) * _e2962) * _e2646.u)) + ((f32(((_e2920[2].color >> bitcast<u32>(16i)) & 255u)) * _e2984) * _e2646.v))) * _e3142.z);
            let _e3149 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e2833, _e2836);
            let _e3150 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e2830, _e3149);
            if ((_e2926.flags & 2u) == 0u) {
                phi_3797_ = 0u;
            } else {
                phi_3797_ = 1u;
            }
            let _e3155 = phi_3797_;
            if (_e2920[0].normal == 2147516416u) {
                phi_4027_ = _e2898;
            } else {
                let _e3168 = (f32((bitcast<i32>((_e2920[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3174 = (f32((bitcast<i32>(_e2920[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3178 = ((1f - abs(_e3168)) - abs(_e3174));
                if (_e3178 < 0f) {
                    phi_3824_ = -(_e3178);
                } else {
                    phi_3824_ = 0f;
                }
                let _e3182 = phi_3824_;
                if (_e3168 < 0f) {
                    phi_3831_ = (_e3168 + _e3182);
                } else {
                    phi_3831_ = (_e3168 - _e3182);
                }
                let _e3187 = phi_3831_;
                if (_e3174 < 0f) {
                    phi_3838_ = (_e3174 + _e3182);
                } else {
                    phi_3838_ = (_e3174 - _e3182);
                }
                let _e3192 = phi_3838_;
                let _e3199 = (1f / sqrt((((_e3187 * _e3187) + (_e3192 * _e3192)) + (_e3178 * _e3178))));
                let _e3215 = (f32((bitcast<i32>((_e2920[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3221 = (f32((bitcast<i32>(_e2920[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3225 = ((1f - abs(_e3215)) - abs(_e3221));
                if (_e3225 < 0f) {
                    phi_3873_ = -(_e3225);
                } else {
                    phi_3873_ = 0f;
                }
                let _e3229 = phi_3873_;
                if (_e3215 < 0f) {
                    phi_3880_ = (_e3215 + _e3229);
                } else {
                    phi_3880_ = (_e3215 - _e3229);
                }
                let _e3234 = phi_3880_;
                if (_e3221 < 0f) {
                    phi_3887_ = (_e3221 + _e3229);
                } else {
                    phi_3887_ = (_e3221 - _e3229);
                }
                let _e3239 = phi_3887_;
                let _e3246 = (1f / sqrt((((_e3234 * _e3234) + (_e3239 * _e3239)) + (_e3225 * _e3225))));
                let _e3265 = (f32((bitcast<i32>((_e2920[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3271 = (f32((bitcast<i32>(_e2920[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3275 = ((1f - abs(_e3265)) - abs(_e3271));
                if (_e3275 < 0f) {
                    phi_3925_ = -(_e3275);
                } else {
                    phi_3925_ = 0f;
                }
                let _e3279 = phi_3925_;
                if (_e3265 < 0f) {
                    phi_3932_ = (_e3265 + _e3279);
                } else {
                    phi_3932_ = (_e3265 - _e3279);
                }
                let _e3284 = phi_3932_;
                if (_e3271 < 0f) {
                    phi_3939_ = (_e3271 + _e3279);
                } else {
                    phi_3939_ = (_e3271 - _e3279);
                }
                let _e3289 = phi_3939_;
                let _e3296 = (1f / sqrt((((_e3284 * _e3284) + (_e3289 * _e3289)) + (_e3275 * _e3275))));
                let _e3303 = ((((_e3187 * _e3199) * _e2652) + ((_e3234 * _e3246) * _e2646.u)) + ((_e3284 * _e3296) * _e2646.v));
                let _e3304 = ((((_e3192 * _e3199) * _e2652) + ((_e3239 * _e3246) * _e2646.u)) + ((_e3289 * _e3296) * _e2646.v));
                let _e3305 = ((((_e3178 * _e3199) * _e2652) + ((_e3225 * _e3246) * _e2646.u)) + ((_e3275 * _e3296) * _e2646.v));
                if (_e2646.instance < _e93) {
                } else {
                    return;
                }
                let _e3312 = instances.member[(0u + _e2646.instance)].world_to_object[0u];
                let _e3321 = instances.member[(0u + _e2646.instance)].world_to_object[1u];
                let _e3333 = instances.member[(0u + _e2646.instance)].world_to_object[2u];
                let _e3340 = (((_e3312.x * _e3303) + (_e3321.x * _e3304)) + (_e3333.x * _e3305));
                let _e3341 = (((_e3312.y * _e3303) + (_e3321.y * _e3304)) + (_e3333.y * _e3305));
                let _e3342 = (((_e3312.z * _e3303) + (_e3321.z * _e3304)) + (_e3333.z * _e3305));
                let _e3348 = sqrt((((_e3340 * _e3340) + (_e3341 * _e3341)) + (_e3342 * _e3342)));
                if (_e3348 > 0f) {
                    let _e3350 = (_e3340 / _e3348);
                    let _e3351 = (_e3341 / _e3348);
                    let _e3352 = (_e3342 / _e3348);
                    if ((((_e3350 * _e2898.x) + (_e3351 * _e2898.y)) + (_e3352 * _e2898.z)) < 0f) {
                        phi_4025_ = vec3<f32>(-(_e3350), -(_e3351), -(_e3352));
                    } else {
                        phi_4025_ = vec3<f32>(_e3350, _e3351, _e3352);
                    }
                    let _e3368 = phi_4025_;
                    phi_4026_ = _e3368;
                } else {
                    phi_4026_ = _e2898;
                }
                let _e3370 = phi_4026_;
                phi_4027_ = _e3370;
            }
            let _e3372 = phi_4027_;
            if (_e3144 > 0f) {
                if (_e3144 < 1f) {
                    phi_4036_ = _e3144;
                } else {
                    phi_4036_ = 1f;
                }
                let _e3376 = phi_4036_;
                phi_4037_ = _e3376;
            } else {
                phi_4037_ = 0f;
            }
            let _e3378 = phi_4037_;
            if (_e3146 > 0f) {
                if (_e3146 < 1f) {
                    phi_4047_ = _e3146;
                } else {
                    phi_4047_ = 1f;
                }
                let _e3383 = phi_4047_;
                phi_4048_ = _e3383;
            } else {
                phi_4048_ = 0f;
            }
            let _e3385 = phi_4048_;
            if (_e3148 > 0f) {
                if (_e3148 < 1f) {
                    phi_4058_ = _e3148;
                } else {
                    phi_4058_ = 1f;
                }
                let _e3390 = phi_4058_;
                phi_4059_ = _e3390;
            } else {
                phi_4059_ = 0f;
            }
            let _e3392 = phi_4059_;
            let _e3395 = ((sqrt(_e3378) * 255f) + 0.5f);
            let _e3404 = ((sqrt(_e3385) * 255f) + 0.5f);
            let _e3416 = ((sqrt(_e3392) * 255f) + 0.5f);
            phi_4094_ = abi_Sample(vec3<f32>(_e2806, _e2807, _e2808), _e3150, _e2898, _e3155, _e3372, ((select(select(u32(_e3395), 0u, (_e3395 < bitcast<f32>(0u))), 4294967295u, (_e3395 > bitcast<f32>(1333788671u))) | (select(select(u32(_e3404), 0u, (_e3404 < bitcast<f32>(0u))), 4294967295u, (_e3404 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e3416), 0u, (_e3416 < bitcast<f32>(0u))), 4294967295u, (_e3416 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_4094_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e3430 = phi_4094_;
        if (_e108.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e108.shift)] = _e3430;
        if (_e2646.triangle != 4294967295u) {
            let _e3439 = ((1f - _e2646.u) - _e2646.v);
            if (_e2646.triangle < _e81) {
            } else {
                return;
            }
            let _e3444 = triangles.member[(0u + _e2646.triangle)];
            let _e3446 = (_e3444.i0_ & 2147483647u);
            if (_e3446 < _e99) {
            } else {
                return;
            }
            let _e3452 = before.member[(0u + _e3446)];
            if (_e3444.i1_ < _e99) {
            } else {
                return;
            }
            let _e3456 = before.member[(0u + _e3444.i1_)];
            if (_e3444.i2_ < _e99) {
            } else {
                return;
            }
            let _e3460 = before.member[(0u + _e3444.i2_)];
            if (_e2646.instance < _e93) {
            } else {
                return;
            }
            let _e3470 = instances.member[(0u + _e2646.instance)].object_to_world[0u];
            let _e3483 = instances.member[(0u + _e2646.instance)].object_to_world[1u];
            let _e3496 = instances.member[(0u + _e2646.instance)].object_to_world[2u];
            if (_e2646.instance < _e93) {
            } else {
                return;
            }
            let _e3520 = instances.member[(0u + _e2646.instance)].object_to_world[0u];
            let _e3533 = instances.member[(0u + _e2646.instance)].object_to_world[1u];
            let _e3546 = instances.member[(0u + _e2646.instance)].object_to_world[2u];
            if (_e2646.instance < _e93) {
            } else {
                return;
            }
            let _e3573 = instances.member[(0u + _e2646.instance)].object_to_world[0u];
            let _e3586 = instances.member[(0u + _e2646.instance)].object_to_world[1u];
            let _e3599 = instances.member[(0u + _e2646.instance)].object_to_world[2u];
            phi_4317_ = vec3<f32>((((((((_e3470.x * _e3452.x) + (_e3470.y * _e3452.y)) + (_e3470.z * _e3452.z)) + (_e3470.w * 1f)) * _e3439) + (((((_e3520.x * _e3456.x) + (_e3520.y * _e3456.y)) + (_e3520.z * _e3456.z)) + (_e3520.w * 1f)) * _e2646.u)) + (((((_e3573.x * _e3460.x) + (_e3573.y * _e3460.y)) + (_e3573.z * _e3460.z)) + (_e3573.w * 1f)) * _e2646.v)), (((((((_e3483.x * _e3452.x) + (_e3483.y * _e3452.y)) + (_e3483.z * _e3452.z)) + (_e3483.w * 1f)) * _e3439) + (((((_e3533.x * _e3456.x) + (_e3533.y * _e3456.y)) + (_e3533.z * _e3456.z)) + (_e3533.w * 1f)) * _e2646.u)) + (((((_e3586.x * _e3460.x) + (_e3586.y * _e3460.y)) + (_e3586.z * _e3460.z)) + (_e3586.w * 1f)) * _e2646.v)), (((((((_e3496.x * _e3452.x) + (_e3496.y * _e3452.y)) + (_e3496.z * _e3452.z)) + (_e3496.w * 1f)) * _e3439) + (((((_e3546.x * _e3456.x) + (_e3546.y * _e3456.y)) + (_e3546.z * _e3456.z)) + (_e3546.w * 1f)) * _e2646.u)) + (((((_e3599.x * _e3460.x) + (_e3599.y * _e3460.y)) + (_e3599.z * _e3460.z)) + (_e3599.w * 1f)) * _e2646.v)));
        } else {
            phi_4317_ = vec3<f32>(0f, 0f, 0f);
        }
        let _e3619 = phi_4317_;
        if (_e108.shift < arrayLength((&past.member))) {
        } else {
            return;
        }
        past.member[(0u + _e108.shift)] = vec4<f32>(_e3619.x, _e3619.y, _e3619.z, 1f);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_instanced_color_motion_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
