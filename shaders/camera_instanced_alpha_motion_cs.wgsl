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
var<storage> alpha_texels: type_13;
@group(0) @binding(8) 
var<storage> before: type_26;
@group(0) @binding(9) 
var<storage, read_write> past: type_26;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_mask_LightPlace {
    var phi_229_: lt_mask_LightPlace;
    var phi_230_: bool;
    var phi_231_: lt_mask_LightPlace;
    var phi_232_: bool;
    var phi_237_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_229_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_230_ = false;
        } else {
            phi_229_ = lt_mask_LightPlace();
            phi_230_ = true;
        }
        let _e84 = phi_229_;
        let _e86 = phi_230_;
        phi_231_ = _e84;
        phi_232_ = _e86;
    } else {
        phi_231_ = lt_mask_LightPlace();
        phi_232_ = true;
    }
    let _e88 = phi_231_;
    let _e90 = phi_232_;
    if _e90 {
        phi_237_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_237_ = _e88;
    }
    let _e95 = phi_237_;
    return lt_mask_LightPlace(_e95.word, _e95.shift);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_252_: bool;
    var phi_256_: f32;

    if (param_3 != param_3) {
        phi_252_ = true;
    } else {
        let _e74 = (param_4 >= param_3);
        if _e74 {
        }
        phi_252_ = _e74;
    }
    let _e76 = phi_252_;
    if _e76 {
        phi_256_ = param_4;
    } else {
        phi_256_ = param_3;
    }
    let _e78 = phi_256_;
    return _e78;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_268_: bool;
    var phi_272_: f32;

    if (param_5 != param_5) {
        phi_268_ = true;
    } else {
        let _e74 = (param_6 <= param_5);
        if _e74 {
        }
        phi_268_ = _e74;
    }
    let _e76 = phi_268_;
    if _e76 {
        phi_272_ = param_6;
    } else {
        phi_272_ = param_5;
    }
    let _e78 = phi_272_;
    return _e78;
}

fn _lt_shaders_texture_TextureView_quad(param_7: ptr<function, texture_TextureView>, param_8: f32, param_9: f32) -> texture_TexelQuad {
    var phi_314_: f32;
    var phi_319_: f32;
    var phi_320_: bool;
    var phi_321_: f32;
    var phi_322_: bool;
    var phi_326_: f32;
    var phi_352_: f32;
    var phi_357_: f32;
    var phi_358_: bool;
    var phi_359_: f32;
    var phi_360_: bool;
    var phi_364_: f32;
    var phi_372_: f32;
    var phi_373_: f32;
    var phi_374_: f32;
    var phi_383_: f32;
    var phi_384_: f32;
    var phi_402_: u32;
    var phi_416_: u32;
    var phi_423_: u32;
    var phi_428_: u32;
    var phi_434_: u32;
    var phi_439_: u32;
    var phi_441_: texture_Axis;
    var phi_469_: f32;
    var phi_474_: f32;
    var phi_475_: bool;
    var phi_476_: f32;
    var phi_477_: bool;
    var phi_481_: f32;
    var phi_507_: f32;
    var phi_512_: f32;
    var phi_513_: bool;
    var phi_514_: f32;
    var phi_515_: bool;
    var phi_519_: f32;
    var phi_527_: f32;
    var phi_528_: f32;
    var phi_529_: f32;
    var phi_538_: f32;
    var phi_539_: f32;
    var phi_557_: u32;
    var phi_571_: u32;
    var phi_578_: u32;
    var phi_583_: u32;
    var phi_589_: u32;
    var phi_594_: u32;
    var phi_596_: texture_Axis;

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
                phi_314_ = 1f;
            } else {
                phi_314_ = 0f;
            }
            let _e105 = phi_314_;
            if (param_8 < 8388608f) {
                phi_319_ = (_e102 - _e105);
                phi_320_ = false;
            } else {
                phi_319_ = f32();
                phi_320_ = true;
            }
            let _e108 = phi_319_;
            let _e110 = phi_320_;
            phi_321_ = _e108;
            phi_322_ = _e110;
        } else {
            phi_321_ = f32();
            phi_322_ = true;
        }
        let _e112 = phi_321_;
        let _e114 = phi_322_;
        if _e114 {
            phi_326_ = param_8;
        } else {
            phi_326_ = _e112;
        }
        let _e116 = phi_326_;
        phi_374_ = (param_8 - _e116);
    } else {
        if (_e89 == 1u) {
            let _e119 = (param_8 * 0.5f);
            if (_e119 > -8388608f) {
                let _e131 = f32(select(0i, select(select(i32(_e119), i32(-2147483648), (_e119 < bitcast<f32>(3472883712u))), 2147483647i, (_e119 > bitcast<f32>(1325400063u))), (_e119 == _e119)));
                if (_e131 > _e119) {
                    phi_352_ = 1f;
                } else {
                    phi_352_ = 0f;
                }
                let _e134 = phi_352_;
                if (_e119 < 8388608f) {
                    phi_357_ = (_e131 - _e134);
                    phi_358_ = false;
                } else {
                    phi_357_ = f32();
                    phi_358_ = true;
                }
                let _e137 = phi_357_;
                let _e139 = phi_358_;
                phi_359_ = _e137;
                phi_360_ = _e139;
            } else {
                phi_359_ = f32();
                phi_360_ = true;
            }
            let _e141 = phi_359_;
            let _e143 = phi_360_;
            if _e143 {
                phi_364_ = _e119;
            } else {
                phi_364_ = _e141;
            }
            let _e145 = phi_364_;
            let _e147 = (param_8 - (2f * _e145));
            if (_e147 > 1f) {
                phi_372_ = (2f - _e147);
            } else {
                phi_372_ = _e147;
            }
            let _e151 = phi_372_;
            phi_373_ = _e151;
        } else {
            phi_373_ = param_8;
        }
        let _e153 = phi_373_;
        phi_374_ = _e153;
    }
    let _e155 = phi_374_;
    if (_e155 > 0f) {
        if (_e155 < 1f) {
            phi_383_ = _e155;
        } else {
            phi_383_ = 1f;
        }
        let _e159 = phi_383_;
        phi_384_ = _e159;
    } else {
        phi_384_ = 0f;
    }
    let _e161 = phi_384_;
    let _e162 = (_e76 - 1u);
    let _e164 = (_e161 * f32(_e76));
    if _e84 {
        let _e171 = select(select(u32(_e164), 0u, (_e164 < bitcast<f32>(0u))), 4294967295u, (_e164 > bitcast<f32>(1333788671u)));
        if (_e162 < _e171) {
            phi_402_ = _e162;
        } else {
            phi_402_ = _e171;
        }
        let _e174 = phi_402_;
        phi_441_ = texture_Axis(_e174, _e174, 0f);
    } else {
        let _e176 = (_e164 + 0.5f);
        let _e183 = select(select(u32(_e176), 0u, (_e176 < bitcast<f32>(0u))), 4294967295u, (_e176 > bitcast<f32>(1333788671u)));
        if (_e76 < _e183) {
            phi_416_ = _e76;
        } else {
            phi_416_ = _e183;
        }
        let _e186 = phi_416_;
        if (_e89 == 0u) {
            phi_423_ = _e162;
        } else {
            phi_423_ = 0u;
        }
        let _e191 = phi_423_;
        if (_e89 == 0u) {
            phi_428_ = 0u;
        } else {
            phi_428_ = _e162;
        }
        let _e194 = phi_428_;
        if (_e186 == 0u) {
            phi_434_ = _e191;
        } else {
            phi_434_ = (_e186 - 1u);
        }
        let _e198 = phi_434_;
        if (_e186 > _e162) {
            phi_439_ = _e194;
        } else {
            phi_439_ = _e186;
        }
        let _e201 = phi_439_;
        phi_441_ = texture_Axis(_e198, _e201, (_e176 - f32(_e186)));
    }
    let _e204 = phi_441_;
    let _e206 = (*param_7).flags;
    let _e209 = ((_e206 >> bitcast<u32>(6u)) & 3u);
    if (_e209 == 0u) {
        if (param_9 > -8388608f) {
            let _e222 = f32(select(0i, select(select(i32(param_9), i32(-2147483648), (param_9 < bitcast<f32>(3472883712u))), 2147483647i, (param_9 > bitcast<f32>(1325400063u))), (param_9 == param_9)));
            if (_e222 > param_9) {
                phi_469_ = 1f;
            } else {
                phi_469_ = 0f;
            }
            let _e225 = phi_469_;
            if (param_9 < 8388608f) {
                phi_474_ = (_e222 - _e225);
                phi_475_ = false;
            } else {
                phi_474_ = f32();
                phi_475_ = true;
            }
            let _e228 = phi_474_;
            let _e230 = phi_475_;
            phi_476_ = _e228;
            phi_477_ = _e230;
        } else {
            phi_476_ = f32();
            phi_477_ = true;
        }
        let _e232 = phi_476_;
        let _e234 = phi_477_;
        if _e234 {
            phi_481_ = param_9;
        } else {
            phi_481_ = _e232;
        }
        let _e236 = phi_481_;
        phi_529_ = (param_9 - _e236);
    } else {
        if (_e209 == 1u) {
            let _e239 = (param_9 * 0.5f);
            if (_e239 > -8388608f) {
                let _e251 = f32(select(0i, select(select(i32(_e239), i32(-2147483648), (_e239 < bitcast<f32>(3472883712u))), 2147483647i, (_e239 > bitcast<f32>(1325400063u))), (_e239 == _e239)));
                if (_e251 > _e239) {
                    phi_507_ = 1f;
                } else {
                    phi_507_ = 0f;
                }
                let _e254 = phi_507_;
                if (_e239 < 8388608f) {
                    phi_512_ = (_e251 - _e254);
                    phi_513_ = false;
                } else {
                    phi_512_ = f32();
                    phi_513_ = true;
                }
                let _e257 = phi_512_;
                let _e259 = phi_513_;
                phi_514_ = _e257;
                phi_515_ = _e259;
            } else {
                phi_514_ = f32();
                phi_515_ = true;
            }
            let _e261 = phi_514_;
            let _e263 = phi_515_;
            if _e263 {
                phi_519_ = _e239;
            } else {
                phi_519_ = _e261;
            }
            let _e265 = phi_519_;
            let _e267 = (param_9 - (2f * _e265));
            if (_e267 > 1f) {
                phi_527_ = (2f - _e267);
            } else {
                phi_527_ = _e267;
            }
            let _e271 = phi_527_;
            phi_528_ = _e271;
        } else {
            phi_528_ = param_9;
        }
        let _e273 = phi_528_;
        phi_529_ = _e273;
    }
    let _e275 = phi_529_;
    if (_e275 > 0f) {
        if (_e275 < 1f) {
            phi_538_ = _e275;
        } else {
            phi_538_ = 1f;
        }
        let _e279 = phi_538_;
        phi_539_ = _e279;
    } else {
        phi_539_ = 0f;
    }
    let _e281 = phi_539_;
    let _e282 = (_e80 - 1u);
    let _e284 = (_e281 * f32(_e80));
    if _e84 {
        let _e291 = select(select(u32(_e284), 0u, (_e284 < bitcast<f32>(0u))), 4294967295u, (_e284 > bitcast<f32>(1333788671u)));
        if (_e282 < _e291) {
            phi_557_ = _e282;
        } else {
            phi_557_ = _e291;
        }
        let _e294 = phi_557_;
        phi_596_ = texture_Axis(_e294, _e294, 0f);
    } else {
        let _e296 = (_e284 + 0.5f);
        let _e303 = select(select(u32(_e296), 0u, (_e296 < bitcast<f32>(0u))), 4294967295u, (_e296 > bitcast<f32>(1333788671u)));
        if (_e80 < _e303) {
            phi_571_ = _e80;
        } else {
            phi_571_ = _e303;
        }
        let _e306 = phi_571_;
        if (_e209 == 0u) {
            phi_578_ = _e282;
        } else {
            phi_578_ = 0u;
        }
        let _e311 = phi_578_;
        if (_e209 == 0u) {
            phi_583_ = 0u;
        } else {
            phi_583_ = _e282;
        }
        let _e314 = phi_583_;
        if (_e306 == 0u) {
            phi_589_ = _e311;
        } else {
            phi_589_ = (_e306 - 1u);
        }
        let _e318 = phi_589_;
        if (_e306 > _e282) {
            phi_594_ = _e314;
        } else {
            phi_594_ = _e306;
        }
        let _e321 = phi_594_;
        phi_596_ = texture_Axis(_e318, _e321, (_e296 - f32(_e306)));
    }
    let _e324 = phi_596_;
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
    var phi_655_: f32;

    if (param_12 > param_13) {
        phi_655_ = param_12;
    } else {
        phi_655_ = param_13;
    }
    let _e75 = phi_655_;
    return _e75;
}

fn _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(param_14: vec3<f32>) -> vec3<f32> {
    return vec3<f32>(1f, 1f, 1f);
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var local_2: lt_bvh_traverse_Stack;
    var phi_819_: bool;
    var phi_820_: bool;
    var phi_821_: bool;
    var phi_825_: bool;
    var phi_826_: bool;
    var phi_827_: bool;
    var phi_828_: bool;
    var phi_829_: bool;
    var phi_830_: bool;
    var phi_831_: bool;
    var phi_832_: bool;
    var phi_833_: bool;
    var phi_834_: bool;
    var phi_835_: bool;
    var phi_836_: bool;
    var phi_837_: bool;
    var phi_838_: bool;
    var phi_839_: bool;
    var phi_840_: bool;
    var phi_841_: bool;
    var phi_842_: bool;
    var phi_846_: bool;
    var phi_850_: bool;
    var phi_925_: f32;
    var phi_932_: f32;
    var phi_940_: f32;
    var phi_947_: f32;
    var phi_955_: f32;
    var phi_962_: f32;
    var phi_987_: f32;
    var phi_992_: f32;
    var phi_997_: f32;
    var phi_1019_: u32;
    var phi_1024_: u32;
    var phi_1029_: u32;
    var phi_1143_: bool;
    var phi_1144_: bool;
    var phi_1175_: u32;
    var phi_1177_: u32;
    var phi_1180_: lt_bvh_Hit;
    var phi_1265_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1292_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1319_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1325_: u32;
    var phi_1328_: u32;
    var phi_1342_: u32;
    var phi_1352_: u32;
    var phi_1362_: u32;
    var phi_1380_: u32;
    var phi_1390_: u32;
    var phi_1400_: u32;
    var phi_1436_: u32;
    var phi_1449_: u32;
    var phi_1454_: u32;
    var phi_1455_: u32;
    var phi_1456_: u32;
    var phi_1326_: u32;
    var phi_1329_: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_1514_: u32;
    var phi_1517_: lt_bvh_Hit;
    var phi_1572_: f32;
    var phi_1577_: f32;
    var phi_1582_: f32;
    var phi_1590_: f32;
    var phi_1595_: f32;
    var phi_1600_: f32;
    var phi_1756_: bool;
    var phi_1757_: bool;
    var phi_1758_: bool;
    var phi_1762_: bool;
    var phi_1763_: bool;
    var phi_1764_: bool;
    var phi_1765_: bool;
    var phi_1766_: bool;
    var phi_1767_: bool;
    var phi_1768_: bool;
    var phi_1769_: bool;
    var phi_1770_: bool;
    var phi_1771_: bool;
    var phi_1772_: bool;
    var phi_1773_: bool;
    var phi_1774_: bool;
    var phi_1775_: bool;
    var phi_1776_: bool;
    var phi_1777_: bool;
    var phi_1778_: bool;
    var phi_1779_: bool;
    var phi_1783_: bool;
    var phi_1787_: bool;
    var phi_1857_: f32;
    var phi_1864_: f32;
    var phi_1871_: f32;
    var phi_1878_: f32;
    var phi_1885_: f32;
    var phi_1892_: f32;
    var phi_1909_: f32;
    var phi_1914_: f32;
    var phi_1919_: f32;
    var phi_1947_: bool;
    var phi_1948_: bool;
    var phi_1956_: u32;
    var phi_1957_: u32;
    var phi_1968_: vec3<f32>;
    var phi_1969_: vec3<f32>;
    var phi_1982_: u32;
    var phi_1987_: u32;
    var phi_1992_: u32;
    var phi_2106_: bool;
    var phi_2107_: bool;
    var phi_2138_: u32;
    var phi_2140_: lt_bvh_Hit;
    var phi_2143_: u32;
    var phi_2224_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2251_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2278_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2284_: u32;
    var phi_2287_: u32;
    var phi_2301_: u32;
    var phi_2311_: u32;
    var phi_2321_: u32;
    var phi_2339_: u32;
    var phi_2349_: u32;
    var phi_2359_: u32;
    var phi_2395_: u32;
    var phi_2408_: u32;
    var phi_2413_: u32;
    var phi_2414_: u32;
    var phi_2415_: u32;
    var phi_2285_: u32;
    var phi_2288_: u32;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_2473_: lt_bvh_Hit;
    var phi_2476_: u32;
    var phi_2520_: vec3<f32>;
    var phi_2521_: vec3<f32>;
    var phi_2550_: vec3<f32>;
    var phi_2551_: vec3<f32>;
    var phi_2580_: vec3<f32>;
    var phi_2581_: vec3<f32>;
    var phi_2599_: bool;
    var phi_2600_: bool;
    var phi_2604_: f32;
    var phi_2605_: f32;
    var phi_2606_: f32;
    var phi_2607_: f32;
    var phi_2615_: f32;
    var phi_2625_: bool;
    var phi_2626_: bool;
    var phi_2630_: f32;
    var phi_2631_: f32;
    var phi_2632_: f32;
    var phi_2633_: f32;
    var phi_2641_: f32;
    var phi_2651_: bool;
    var phi_2652_: bool;
    var phi_2656_: f32;
    var phi_2657_: f32;
    var phi_2658_: f32;
    var phi_2659_: f32;
    var phi_2667_: f32;
    var phi_2682_: f32;
    var phi_2683_: bool;
    var phi_2684_: f32;
    var phi_2685_: bool;
    var phi_2686_: f32;
    var phi_2687_: bool;
    var phi_2705_: f32;
    var phi_2706_: bool;
    var phi_2707_: bool;
    var phi_2708_: f32;
    var phi_2709_: bool;
    var phi_2710_: bool;
    var phi_2714_: bool;
    var phi_2715_: f32;
    var phi_2716_: bool;
    var phi_2744_: vec3<f32>;
    var phi_2745_: vec3<f32>;
    var phi_2770_: vec3<f32>;
    var phi_2771_: vec3<f32>;
    var phi_2796_: vec3<f32>;
    var phi_2797_: vec3<f32>;
    var phi_2853_: f32;
    var phi_2862_: f32;
    var phi_2871_: f32;
    var phi_2880_: f32;
    var phi_2887_: f32;
    var phi_2894_: f32;
    var phi_2907_: f32;
    var phi_2916_: f32;
    var phi_2925_: f32;
    var phi_2934_: f32;
    var phi_2941_: f32;
    var phi_2948_: f32;
    var phi_2965_: f32;
    var phi_2970_: f32;
    var phi_2975_: f32;
    var phi_2983_: f32;
    var phi_2988_: f32;
    var phi_2993_: f32;
    var phi_3005_: f32;
    var phi_3010_: f32;
    var phi_3015_: f32;
    var phi_3020_: f32;
    var phi_3025_: lt_bvh_triangle_Intersection;
    var phi_3026_: bool;
    var phi_3027_: lt_bvh_triangle_Intersection;
    var phi_3028_: bool;
    var phi_3032_: lt_bvh_triangle_Intersection;
    var phi_3033_: bool;
    var phi_3034_: lt_bvh_triangle_Intersection;
    var phi_3035_: bool;
    var phi_3036_: bool;
    var phi_3040_: bool;
    var phi_3044_: lt_bvh_triangle_Intersection;
    var phi_3082_: bool;
    var phi_3083_: bool;
    var phi_3084_: bool;
    var phi_3085_: bool;
    var phi_3086_: bool;
    var phi_3087_: bool;
    var phi_3091_: bool;
    var phi_3092_: bool;
    var phi_3295_: f32;
    var phi_3298_: bool;
    var phi_3299_: bool;
    var phi_3303_: bool;
    var phi_3311_: lt_bvh_Hit;
    var phi_3312_: lt_bvh_Hit;
    var phi_3313_: lt_bvh_Hit;
    var phi_3314_: lt_bvh_Hit;
    var phi_2474_: lt_bvh_Hit;
    var phi_2477_: u32;
    var phi_3315_: bool;
    var phi_3354_: bool;
    var phi_3355_: bool;
    var phi_3386_: u32;
    var phi_2141_: lt_bvh_Hit;
    var phi_2144_: u32;
    var phi_3387_: lt_bvh_Hit;
    var phi_3388_: lt_bvh_Hit;
    var phi_3389_: bool;
    var phi_3393_: lt_bvh_Hit;
    var phi_3394_: lt_bvh_Hit;
    var phi_3395_: lt_bvh_Hit;
    var phi_3396_: lt_bvh_Hit;
    var phi_1515_: u32;
    var phi_1518_: lt_bvh_Hit;
    var phi_3397_: bool;
    var phi_3436_: bool;
    var phi_3437_: bool;
    var phi_3468_: u32;
    var phi_1178_: u32;
    var phi_1181_: lt_bvh_Hit;
    var phi_3469_: lt_bvh_Hit;
    var phi_3470_: lt_bvh_Hit;
    var phi_3471_: bool;
    var phi_3475_: lt_bvh_Hit;
    var phi_3663_: f32;
    var phi_3668_: f32;
    var phi_3673_: f32;
    var phi_3681_: f32;
    var phi_3686_: f32;
    var phi_3691_: f32;
    var phi_3755_: vec3<f32>;
    var phi_3876_: u32;
    var phi_3903_: f32;
    var phi_3910_: f32;
    var phi_3917_: f32;
    var phi_3952_: f32;
    var phi_3959_: f32;
    var phi_3966_: f32;
    var phi_4004_: f32;
    var phi_4011_: f32;
    var phi_4018_: f32;
    var phi_4104_: vec3<f32>;
    var phi_4105_: vec3<f32>;
    var phi_4106_: vec3<f32>;
    var phi_4115_: f32;
    var phi_4116_: f32;
    var phi_4126_: f32;
    var phi_4127_: f32;
    var phi_4137_: f32;
    var phi_4138_: f32;
    var phi_4173_: abi_Sample;
    var phi_4396_: vec3<f32>;
    var local_9: lt_bvh_Hit;
    var local_10: lt_bvh_Hit;
    var local_11: lt_bvh_Hit;
    var local_12: lt_bvh_Hit;

    let _e74 = id_1;
    let _e78 = arrayLength((&nodes.member));
    let _e81 = arrayLength((&triangles.member));
    let _e84 = arrayLength((&vertices.member));
    let _e87 = arrayLength((&materials.member));
    let _e93 = arrayLength((&instances.member));
    let _e96 = arrayLength((&alpha_texels.member));
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
                                    phi_820_ = bool();
                                    phi_821_ = true;
                                } else {
                                    let _e189 = (_e179 > 0f);
                                    if _e189 {
                                        phi_819_ = bool();
                                    } else {
                                        phi_819_ = (_e181 > 0f);
                                    }
                                    let _e192 = phi_819_;
                                    phi_820_ = _e192;
                                    phi_821_ = _e189;
                                }
                                let _e194 = phi_820_;
                                let _e196 = phi_821_;
                                if _e196 {
                                    phi_825_ = true;
                                } else {
                                    phi_825_ = _e194;
                                }
                                let _e198 = phi_825_;
                                phi_826_ = _e198;
                                phi_827_ = false;
                            } else {
                                phi_826_ = bool();
                                phi_827_ = true;
                            }
                            let _e200 = phi_826_;
                            let _e202 = phi_827_;
                            phi_828_ = _e200;
                            phi_829_ = false;
                            phi_830_ = _e202;
                        } else {
                            phi_828_ = bool();
                            phi_829_ = true;
                            phi_830_ = false;
                        }
                        let _e204 = phi_828_;
                        let _e206 = phi_829_;
                        let _e208 = phi_830_;
                        phi_831_ = _e204;
                        phi_832_ = _e206;
                        phi_833_ = _e208;
                    } else {
                        phi_831_ = bool();
                        phi_832_ = true;
                        phi_833_ = false;
                    }
                    let _e210 = phi_831_;
                    let _e212 = phi_832_;
                    let _e214 = phi_833_;
                    phi_834_ = _e210;
                    phi_835_ = _e212;
                    phi_836_ = _e214;
                } else {
                    phi_834_ = bool();
                    phi_835_ = true;
                    phi_836_ = false;
                }
                let _e216 = phi_834_;
                let _e218 = phi_835_;
                let _e220 = phi_836_;
                phi_837_ = _e216;
                phi_838_ = _e218;
                phi_839_ = _e220;
            } else {
                phi_837_ = bool();
                phi_838_ = true;
                phi_839_ = false;
            }
            let _e222 = phi_837_;
            let _e224 = phi_838_;
            let _e226 = phi_839_;
            phi_840_ = _e222;
            phi_841_ = _e224;
            phi_842_ = _e226;
        } else {
            phi_840_ = bool();
            phi_841_ = true;
            phi_842_ = false;
        }
        let _e228 = phi_840_;
        let _e230 = phi_841_;
        let _e232 = phi_842_;
        if _e230 {
            phi_846_ = true;
        } else {
            phi_846_ = _e232;
        }
        let _e234 = phi_846_;
        if _e234 {
            phi_850_ = false;
        } else {
            phi_850_ = _e228;
        }
        let _e236 = phi_850_;
        if _e236 {
            let _e237 = (_e114 >= _e78);
            if _e237 {
                phi_3469_ = lt_bvh_Hit();
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
                    phi_925_ = _e307;
                } else {
                    phi_925_ = abs(_e165.direction.x);
                }
                let _e314 = phi_925_;
                if (_e165.direction.x < 0f) {
                    phi_932_ = (-1f / _e314);
                } else {
                    phi_932_ = (1f / _e314);
                }
                let _e319 = phi_932_;
                if (abs(_e165.direction.y) < _e307) {
                    phi_940_ = _e307;
                } else {
                    phi_940_ = abs(_e165.direction.y);
                }
                let _e326 = phi_940_;
                if (_e165.direction.y < 0f) {
                    phi_947_ = (-1f / _e326);
                } else {
                    phi_947_ = (1f / _e326);
                }
                let _e331 = phi_947_;
                if (abs(_e165.direction.z) < _e307) {
                    phi_955_ = _e307;
                } else {
                    phi_955_ = abs(_e165.direction.z);
                }
                let _e338 = phi_955_;
                if (_e165.direction.z < 0f) {
                    phi_962_ = (-1f / _e338);
                } else {
                    phi_962_ = (1f / _e338);
                }
                let _e343 = phi_962_;
                let _e351 = abs((bitcast<f32>(_e243) - _e165.origin.x));
                let _e352 = abs((bitcast<f32>(_e247) - _e165.origin.y));
                let _e353 = abs((bitcast<f32>(_e251) - _e165.origin.z));
                let _e361 = abs(((bitcast<f32>(_e255) + (bitcast<f32>((((_e267 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e165.origin.x));
                let _e362 = abs(((bitcast<f32>(_e259) + (bitcast<f32>((((_e267 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e165.origin.y));
                let _e363 = abs(((bitcast<f32>(_e263) + (bitcast<f32>((((_e267 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e165.origin.z));
                if (_e351 > _e361) {
                    phi_987_ = _e351;
                } else {
                    phi_987_ = _e361;
                }
                let _e366 = phi_987_;
                if (_e352 > _e362) {
                    phi_992_ = _e352;
                } else {
                    phi_992_ = _e362;
                }
                let _e369 = phi_992_;
                if (_e353 > _e363) {
                    phi_997_ = _e353;
                } else {
                    phi_997_ = _e363;
                }
                let _e372 = phi_997_;
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
                    phi_1019_ = 0u;
                } else {
                    phi_1019_ = 1u;
                }
                let _e392 = phi_1019_;
                if (_e331 < 0f) {
                    phi_1024_ = 0u;
                } else {
                    phi_1024_ = 2u;
                }
                let _e395 = phi_1024_;
                if (_e343 < 0f) {
                    phi_1029_ = 0u;
                } else {
                    phi_1029_ = 4u;
                }
                let _e398 = phi_1029_;
                let _e400 = ((_e392 | _e395) | _e398);
                let _e401 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e114, 2147483648u);
                local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e401.first[0], _e401.first[1], _e401.first[2], _e401.first[3], _e401.first[4], _e401.first[5], _e401.first[6], _e401.first[7], _e401.first[8], _e401.first[9], _e401.first[10], _e401.first[11], _e401.first[12], _e401.first[13], _e401.first[14], _e401.first[15], _e401.first[16], _e401.first[17], _e401.first[18], _e401.first[19], _e401.first[20], _e401.first[21], _e401.first[22], _e401.first[23], _e401.first[24], _e401.first[25], _e401.first[26], _e401.first[27], _e401.first[28], _e401.first[29], _e401.first[30], _e401.first[31]), array<u32, 32>(_e401.mask[0], _e401.mask[1], _e401.mask[2], _e401.mask[3], _e401.mask[4], _e401.mask[5], _e401.mask[6], _e401.mask[7], _e401.mask[8], _e401.mask[9], _e401.mask[10], _e401.mask[11], _e401.mask[12], _e401.mask[13], _e401.mask[14], _e401.mask[15], _e401.mask[16], _e401.mask[17], _e401.mask[18], _e401.mask[19], _e401.mask[20], _e401.mask[21], _e401.mask[22], _e401.mask[23], _e401.mask[24], _e401.mask[25], _e401.mask[26], _e401.mask[27], _e401.mask[28], _e401.mask[29], _e401.mask[30], _e401.mask[31]), _e401.len, _e401.group, _e401.group_mask);
                let _e475 = local_2.group_mask;
                if ((_e475 & 4278190080u) == 0u) {
                    let _e479 = local_2.len;
                    if (_e479 == 0u) {
                        phi_1143_ = false;
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
                        phi_1143_ = true;
                    }
                    let _e502 = phi_1143_;
                    phi_1144_ = _e502;
                } else {
                    phi_1144_ = true;
                }
                let _e504 = phi_1144_;
                if _e504 {
                    let _e506 = local_2.group_mask;
                    let _e512 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e506)), 32u, (_e506 == 0u)));
                    let _e516 = local_2.group_mask;
                    let _e530 = local_2.group_mask;
                    local_2.group_mask = (_e530 & ~((1u << bitcast<u32>((_e512 & 31u)))));
                    let _e533 = local_2.group;
                    phi_1175_ = (_e533 + countOneBits(((_e516 & ~((4294967295u << bitcast<u32>((((_e512 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1175_ = 4294967295u;
                }
                let _e536 = phi_1175_;
                phi_1177_ = _e536;
                phi_1180_ = _e167;
                loop {
                    let _e538 = phi_1177_;
                    let _e540 = phi_1180_;
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
                            phi_1265_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e628.unnamed, lt_mask_LightPlace(_e628.unnamed_1.word, _e605.y));
                        } else {
                            let _e644 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e605.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e650 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e644.unnamed.word, _e605.y), _e644.unnamed_1);
                            let _e656 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e650.unnamed, lt_mask_LightPlace(_e605.z, _e650.unnamed_1.shift));
                            phi_1265_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e656.unnamed, lt_mask_LightPlace(_e656.unnamed_1.word, _e605.w));
                        }
                        let _e664 = phi_1265_;
                        let _e674 = nodes.member[(0u + _e538)].y;
                        if (_e331 < 0f) {
                            let _e685 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e674.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e691 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e685.unnamed.word, _e674.w), _e685.unnamed_1);
                            let _e697 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e691.unnamed, lt_mask_LightPlace(_e674.x, _e691.unnamed_1.shift));
                            phi_1292_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e697.unnamed, lt_mask_LightPlace(_e697.unnamed_1.word, _e674.y));
                        } else {
                            let _e713 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e674.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e719 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e713.unnamed.word, _e674.y), _e713.unnamed_1);
                            let _e725 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e719.unnamed, lt_mask_LightPlace(_e674.z, _e719.unnamed_1.shift));
                            phi_1292_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e725.unnamed, lt_mask_LightPlace(_e725.unnamed_1.word, _e674.w));
                        }
                        let _e733 = phi_1292_;
                        let _e743 = nodes.member[(0u + _e538)].z;
                        if (_e343 < 0f) {
                            let _e754 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e743.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e760 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e754.unnamed.word, _e743.w), _e754.unnamed_1);
                            let _e766 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e760.unnamed, lt_mask_LightPlace(_e743.x, _e760.unnamed_1.shift));
                            phi_1319_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e766.unnamed, lt_mask_LightPlace(_e766.unnamed_1.word, _e743.y));
                        } else {
                            let _e782 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e743.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e788 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e782.unnamed.word, _e743.y), _e782.unnamed_1);
                            let _e794 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e788.unnamed, lt_mask_LightPlace(_e743.z, _e788.unnamed_1.shift));
                            phi_1319_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e794.unnamed, lt_mask_LightPlace(_e794.unnamed_1.word, _e743.w));
                        }
                        let _e802 = phi_1319_;
                        phi_1325_ = 0u;
                        phi_1328_ = 0u;
                        loop {
                            let _e812 = phi_1325_;
                            let _e814 = phi_1328_;
                            local_3 = _e814;
                            local_4 = _e814;
                            local_5 = _e814;
                            let _e815 = (_e812 < 8u);
                            if _e815 {
                                let _e817 = (_e812 >> bitcast<u32>(2i));
                                let _e818 = (_e812 & 3u);
                                if (_e817 == 0u) {
                                    phi_1342_ = _e664.unnamed.word;
                                } else {
                                    phi_1342_ = _e664.unnamed.shift;
                                }
                                let _e821 = phi_1342_;
                                if (_e817 == 0u) {
                                    phi_1352_ = _e733.unnamed.word;
                                } else {
                                    phi_1352_ = _e733.unnamed.shift;
                                }
                                let _e830 = phi_1352_;
                                if (_e817 == 0u) {
                                    phi_1362_ = _e802.unnamed.word;
                                } else {
                                    phi_1362_ = _e802.unnamed.shift;
                                }
                                let _e839 = phi_1362_;
                                let _e852 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e821 >> bitcast<u32>(((_e818 * 8u) & 31u))) & 255u)) * _e574) + (_e595 - _e380)), ((f32(((_e830 >> bitcast<u32>(((_e818 * 8u) & 31u))) & 255u)) * _e575) + (_e596 - _e381)));
                                let _e853 = core_intrinsics_maximum_number_nsz_f32_(_e852, ((f32(((_e839 >> bitcast<u32>(((_e818 * 8u) & 31u))) & 255u)) * _e576) + (_e597 - _e382)));
                                if (_e817 == 0u) {
                                    phi_1380_ = _e664.unnamed_1.word;
                                } else {
                                    phi_1380_ = _e664.unnamed_1.shift;
                                }
                                let _e856 = phi_1380_;
                                if (_e817 == 0u) {
                                    phi_1390_ = _e733.unnamed_1.word;
                                } else {
                                    phi_1390_ = _e733.unnamed_1.shift;
                                }
                                let _e865 = phi_1390_;
                                if (_e817 == 0u) {
                                    phi_1400_ = _e802.unnamed_1.word;
                                } else {
                                    phi_1400_ = _e802.unnamed_1.shift;
                                }
                                let _e874 = phi_1400_;
                                let _e887 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e856 >> bitcast<u32>(((_e818 * 8u) & 31u))) & 255u)) * _e574) + (_e595 + _e380)), ((f32(((_e865 >> bitcast<u32>(((_e818 * 8u) & 31u))) & 255u)) * _e575) + (_e596 + _e381)));
                                let _e888 = core_intrinsics_minimum_number_nsz_f32_(_e887, ((f32(((_e874 >> bitcast<u32>(((_e818 * 8u) & 31u))) & 255u)) * _e576) + (_e597 + _e382)));
                                if (_e853 <= _e888) {
                                    if (_e853 <= _e540.t) {
                                        if (_e888 >= _e165.tmin) {
                                            if (_e817 == 0u) {
                                                let _e895 = nodes.member[(0u + _e538)].links[2u];
                                                phi_1436_ = _e895;
                                            } else {
                                                let _e898 = nodes.member[(0u + _e538)].links[3u];
                                                phi_1436_ = _e898;
                                            }
                                            let _e900 = phi_1436_;
                                            let _e905 = ((_e900 >> bitcast<u32>(((_e818 * 8u) & 31u))) & 255u);
                                            let _e906 = (_e905 & 31u);
                                            if (_e906 >= 24u) {
                                                phi_1449_ = (24u + ((_e906 - 24u) ^ _e400));
                                            } else {
                                                phi_1449_ = _e906;
                                            }
                                            let _e912 = phi_1449_;
                                            phi_1454_ = (_e814 | ((_e905 >> bitcast<u32>(5i)) << bitcast<u32>((_e912 & 31u))));
                                        } else {
                                            phi_1454_ = _e814;
                                        }
                                        let _e920 = phi_1454_;
                                        phi_1455_ = _e920;
                                    } else {
                                        phi_1455_ = _e814;
                                    }
                                    let _e922 = phi_1455_;
                                    phi_1456_ = _e922;
                                } else {
                                    phi_1456_ = _e814;
                                }
                                let _e924 = phi_1456_;
                                phi_1326_ = (_e812 + 1u);
                                phi_1329_ = _e924;
                            } else {
                                phi_1326_ = u32();
                                phi_1329_ = u32();
                            }
                            let _e927 = phi_1326_;
                            let _e929 = phi_1329_;
                            continue;
                            continuing {
                                phi_1325_ = _e927;
                                phi_1328_ = _e929;
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
                        phi_1514_ = (_e978 & 16777215u);
                        phi_1517_ = _e540;
                        loop {
                            let _e981 = phi_1514_;
                            let _e983 = phi_1517_;
                            local_11 = _e983;
                            if (_e981 == 0u) {
                                phi_1515_ = u32();
                                phi_1518_ = lt_bvh_Hit();
                                phi_3397_ = false;
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
                                    phi_1572_ = _e1010;
                                } else {
                                    phi_1572_ = _e1022;
                                }
                                let _e1027 = phi_1572_;
                                if (_e1011 < _e1023) {
                                    phi_1577_ = _e1011;
                                } else {
                                    phi_1577_ = _e1023;
                                }
                                let _e1030 = phi_1577_;
                                if (_e1012 < _e1024) {
                                    phi_1582_ = _e1012;
                                } else {
                                    phi_1582_ = _e1024;
                                }
                                let _e1033 = phi_1582_;
                                if (_e1010 > _e1022) {
                                    phi_1590_ = _e1010;
                                } else {
                                    phi_1590_ = _e1022;
                                }
                                let _e1039 = phi_1590_;
                                if (_e1011 > _e1023) {
                                    phi_1595_ = _e1011;
                                } else {
                                    phi_1595_ = _e1023;
                                }
                                let _e1042 = phi_1595_;
                                if (_e1012 > _e1024) {
                                    phi_1600_ = _e1012;
                                } else {
                                    phi_1600_ = _e1024;
                                }
                                let _e1045 = phi_1600_;
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
                                                                        phi_1757_ = bool();
                                                                        phi_1758_ = true;
                                                                    } else {
                                                                        let _e1166 = (_e1157 > 0f);
                                                                        if _e1166 {
                                                                            phi_1756_ = bool();
                                                                        } else {
                                                                            phi_1756_ = (_e1158 > 0f);
                                                                        }
                                                                        let _e1169 = phi_1756_;
                                                                        phi_1757_ = _e1169;
                                                                        phi_1758_ = _e1166;
                                                                    }
                                                                    let _e1171 = phi_1757_;
                                                                    let _e1173 = phi_1758_;
                                                                    if _e1173 {
                                                                        phi_1762_ = true;
                                                                    } else {
                                                                        phi_1762_ = _e1171;
                                                                    }
                                                                    let _e1175 = phi_1762_;
                                                                    phi_1763_ = _e1175;
                                                                    phi_1764_ = false;
                                                                } else {
                                                                    phi_1763_ = bool();
                                                                    phi_1764_ = true;
                                                                }
                                                                let _e1177 = phi_1763_;
                                                                let _e1179 = phi_1764_;
                                                                phi_1765_ = _e1177;
                                                                phi_1766_ = false;
                                                                phi_1767_ = _e1179;
                                                            } else {
                                                                phi_1765_ = bool();
                                                                phi_1766_ = true;
                                                                phi_1767_ = false;
                                                            }
                                                            let _e1181 = phi_1765_;
                                                            let _e1183 = phi_1766_;
                                                            let _e1185 = phi_1767_;
                                                            phi_1768_ = _e1181;
                                                            phi_1769_ = _e1183;
                                                            phi_1770_ = _e1185;
                                                        } else {
                                                            phi_1768_ = bool();
                                                            phi_1769_ = true;
                                                            phi_1770_ = false;
                                                        }
                                                        let _e1187 = phi_1768_;
                                                        let _e1189 = phi_1769_;
                                                        let _e1191 = phi_1770_;
                                                        phi_1771_ = _e1187;
                                                        phi_1772_ = _e1189;
                                                        phi_1773_ = _e1191;
                                                    } else {
                                                        phi_1771_ = bool();
                                                        phi_1772_ = true;
                                                        phi_1773_ = false;
                                                    }
                                                    let _e1193 = phi_1771_;
                                                    let _e1195 = phi_1772_;
                                                    let _e1197 = phi_1773_;
                                                    phi_1774_ = _e1193;
                                                    phi_1775_ = _e1195;
                                                    phi_1776_ = _e1197;
                                                } else {
                                                    phi_1774_ = bool();
                                                    phi_1775_ = true;
                                                    phi_1776_ = false;
                                                }
                                                let _e1199 = phi_1774_;
                                                let _e1201 = phi_1775_;
                                                let _e1203 = phi_1776_;
                                                phi_1777_ = _e1199;
                                                phi_1778_ = _e1201;
                                                phi_1779_ = _e1203;
                                            } else {
                                                phi_1777_ = bool();
                                                phi_1778_ = true;
                                                phi_1779_ = false;
                                            }
                                            let _e1205 = phi_1777_;
                                            let _e1207 = phi_1778_;
                                            let _e1209 = phi_1779_;
                                            if _e1207 {
                                                phi_1783_ = true;
                                            } else {
                                                phi_1783_ = _e1209;
                                            }
                                            let _e1211 = phi_1783_;
                                            if _e1211 {
                                                phi_1787_ = false;
                                            } else {
                                                phi_1787_ = _e1205;
                                            }
                                            let _e1213 = phi_1787_;
                                            if _e1213 {
                                                let _e1214 = (_e1150 >= _e78);
                                                if _e1214 {
                                                    phi_3387_ = lt_bvh_Hit();
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
                                                        phi_1857_ = _e1280;
                                                    } else {
                                                        phi_1857_ = abs(_e1119);
                                                    }
                                                    let _e1285 = phi_1857_;
                                                    if (_e1119 < 0f) {
                                                        phi_1864_ = (-1f / _e1285);
                                                    } else {
                                                        phi_1864_ = (1f / _e1285);
                                                    }
                                                    let _e1290 = phi_1864_;
                                                    if (abs(_e1132) < _e1280) {
                                                        phi_1871_ = _e1280;
                                                    } else {
                                                        phi_1871_ = abs(_e1132);
                                                    }
                                                    let _e1295 = phi_1871_;
                                                    if (_e1132 < 0f) {
                                                        phi_1878_ = (-1f / _e1295);
                                                    } else {
                                                        phi_1878_ = (1f / _e1295);
                                                    }
                                                    let _e1300 = phi_1878_;
                                                    if (abs(_e1145) < _e1280) {
                                                        phi_1885_ = _e1280;
                                                    } else {
                                                        phi_1885_ = abs(_e1145);
                                                    }
                                                    let _e1305 = phi_1885_;
                                                    if (_e1145 < 0f) {
                                                        phi_1892_ = (-1f / _e1305);
                                                    } else {
                                                        phi_1892_ = (1f / _e1305);
                                                    }
                                                    let _e1310 = phi_1892_;
                                                    let _e1314 = abs((bitcast<f32>(_e1220) - _e1075));
                                                    let _e1315 = abs((bitcast<f32>(_e1224) - _e1088));
                                                    let _e1316 = abs((bitcast<f32>(_e1228) - _e1101));
                                                    let _e1320 = abs(((bitcast<f32>(_e1232) + (bitcast<f32>((((_e1244 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1075));
                                                    let _e1321 = abs(((bitcast<f32>(_e1236) + (bitcast<f32>((((_e1244 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1088));
                                                    let _e1322 = abs(((bitcast<f32>(_e1240) + (bitcast<f32>((((_e1244 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1101));
                                                    if (_e1314 > _e1320) {
                                                        phi_1909_ = _e1314;
                                                    } else {
                                                        phi_1909_ = _e1320;
                                                    }
                                                    let _e1325 = phi_1909_;
                                                    if (_e1315 > _e1321) {
                                                        phi_1914_ = _e1315;
                                                    } else {
                                                        phi_1914_ = _e1321;
                                                    }
                                                    let _e1328 = phi_1914_;
                                                    if (_e1316 > _e1322) {
                                                        phi_1919_ = _e1316;
                                                    } else {
                                                        phi_1919_ = _e1322;
                                                    }
                                                    let _e1331 = phi_1919_;
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
                                                            phi_1947_ = false;
                                                        } else {
                                                            phi_1947_ = true;
                                                        }
                                                        let _e1354 = phi_1947_;
                                                        phi_1948_ = _e1354;
                                                    } else {
                                                        phi_1948_ = true;
                                                    }
                                                    let _e1356 = phi_1948_;
                                                    if _e1356 {
                                                        if (_e1349 >= _e1350) {
                                                            phi_1956_ = 1u;
                                                        } else {
                                                            phi_1956_ = 2u;
                                                        }
                                                        let _e1359 = phi_1956_;
                                                        phi_1957_ = _e1359;
                                                    } else {
                                                        phi_1957_ = 0u;
                                                    }
                                                    let _e1361 = phi_1957_;
                                                    if (_e1361 == 0u) {
                                                        phi_1969_ = vec3<f32>(_e1132, _e1145, _e1119);
                                                    } else {
                                                        if (_e1361 == 1u) {
                                                            phi_1968_ = vec3<f32>(_e1145, _e1119, _e1132);
                                                        } else {
                                                            phi_1968_ = vec3<f32>(_e1119, _e1132, _e1145);
                                                        }
                                                        let _e1367 = phi_1968_;
                                                        phi_1969_ = _e1367;
                                                    }
                                                    let _e1369 = phi_1969_;
                                                    let _e1372 = (_e1369.x / _e1369.z);
                                                    let _e1375 = (_e1369.y / _e1369.z);
                                                    if (_e1290 < 0f) {
                                                        phi_1982_ = 0u;
                                                    } else {
                                                        phi_1982_ = 1u;
                                                    }
                                                    let _e1380 = phi_1982_;
                                                    if (_e1300 < 0f) {
                                                        phi_1987_ = 0u;
                                                    } else {
                                                        phi_1987_ = 2u;
                                                    }
                                                    let _e1383 = phi_1987_;
                                                    if (_e1310 < 0f) {
                                                        phi_1992_ = 0u;
                                                    } else {
                                                        phi_1992_ = 4u;
                                                    }
                                                    let _e1386 = phi_1992_;
                                                    let _e1388 = ((_e1380 | _e1383) | _e1386);
                                                    let _e1389 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1150, 2147483648u);
                                                    local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e1389.first[0], _e1389.first[1], _e1389.first[2], _e1389.first[3], _e1389.first[4], _e1389.first[5], _e1389.first[6], _e1389.first[7], _e1389.first[8], _e1389.first[9], _e1389.first[10], _e1389.first[11], _e1389.first[12], _e1389.first[13], _e1389.first[14], _e1389.first[15], _e1389.first[16], _e1389.first[17], _e1389.first[18], _e1389.first[19], _e1389.first[20], _e1389.first[21], _e1389.first[22], _e1389.first[23], _e1389.first[24], _e1389.first[25], _e1389.first[26], _e1389.first[27], _e1389.first[28], _e1389.first[29], _e1389.first[30], _e1389.first[31]), array<u32, 32>(_e1389.mask[0], _e1389.mask[1], _e1389.mask[2], _e1389.mask[3], _e1389.mask[4], _e1389.mask[5], _e1389.mask[6], _e1389.mask[7], _e1389.mask[8], _e1389.mask[9], _e1389.mask[10], _e1389.mask[11], _e1389.mask[12], _e1389.mask[13], _e1389.mask[14], _e1389.mask[15], _e1389.mask[16], _e1389.mask[17], _e1389.mask[18], _e1389.mask[19], _e1389.mask[20], _e1389.mask[21], _e1389.mask[22], _e1389.mask[23], _e1389.mask[24], _e1389.mask[25], _e1389.mask[26], _e1389.mask[27], _e1389.mask[28], _e1389.mask[29], _e1389.mask[30], _e1389.mask[31]), _e1389.len, _e1389.group, _e1389.group_mask);
                                                    let _e1463 = local_1.group_mask;
                                                    if ((_e1463 & 4278190080u) == 0u) {
                                                        let _e1467 = local_1.len;
                                                        if (_e1467 == 0u) {
                                                            phi_2106_ = false;
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
                                                            phi_2106_ = true;
                                                        }
                                                        let _e1490 = phi_2106_;
                                                        phi_2107_ = _e1490;
                                                    } else {
                                                        phi_2107_ = true;
                                                    }
                                                    let _e1492 = phi_2107_;
                                                    if _e1492 {
                                                        let _e1494 = local_1.group_mask;
                                                        let _e1500 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1494)), 32u, (_e1494 == 0u)));
                                                        let _e1504 = local_1.group_mask;
                                                        let _e1518 = local_1.group_mask;
                                                        local_1.group_mask = (_e1518 & ~((1u << bitcast<u32>((_e1500 & 31u)))));
                                                        let _e1521 = local_1.group;
                                                        phi_2138_ = (_e1521 + countOneBits(((_e1504 & ~((4294967295u << bitcast<u32>((((_e1500 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_2138_ = 4294967295u;
                                                    }
                                                    let _e1524 = phi_2138_;
                                                    phi_2140_ = _e983;
                                                    phi_2143_ = _e1524;
                                                    loop {
                                                        let _e1526 = phi_2140_;
                                                        let _e1528 = phi_2143_;
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
                                                                phi_2224_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1612.unnamed, lt_mask_LightPlace(_e1612.unnamed_1.word, _e1589.y));
                                                            } else {
                                                                let _e1628 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1589.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1634 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1628.unnamed.word, _e1589.y), _e1628.unnamed_1);
                                                                let _e1640 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1634.unnamed, lt_mask_LightPlace(_e1589.z, _e1634.unnamed_1.shift));
                                                                phi_2224_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1640.unnamed, lt_mask_LightPlace(_e1640.unnamed_1.word, _e1589.w));
                                                            }
                                                            let _e1648 = phi_2224_;
                                                            let _e1658 = nodes.member[(0u + _e1528)].y;
                                                            if (_e1300 < 0f) {
                                                                let _e1669 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1658.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1675 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1669.unnamed.word, _e1658.w), _e1669.unnamed_1);
                                                                let _e1681 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1675.unnamed, lt_mask_LightPlace(_e1658.x, _e1675.unnamed_1.shift));
                                                                phi_2251_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1681.unnamed, lt_mask_LightPlace(_e1681.unnamed_1.word, _e1658.y));
                                                            } else {
                                                                let _e1697 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1658.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1703 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1697.unnamed.word, _e1658.y), _e1697.unnamed_1);
                                                                let _e1709 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1703.unnamed, lt_mask_LightPlace(_e1658.z, _e1703.unnamed_1.shift));
                                                                phi_2251_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1709.unnamed, lt_mask_LightPlace(_e1709.unnamed_1.word, _e1658.w));
                                                            }
                                                            let _e1717 = phi_2251_;
                                                            let _e1727 = nodes.member[(0u + _e1528)].z;
                                                            if (_e1310 < 0f) {
                                                                let _e1738 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1727.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1744 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1738.unnamed.word, _e1727.w), _e1738.unnamed_1);
                                                                let _e1750 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1744.unnamed, lt_mask_LightPlace(_e1727.x, _e1744.unnamed_1.shift));
                                                                phi_2278_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1750.unnamed, lt_mask_LightPlace(_e1750.unnamed_1.word, _e1727.y));
                                                            } else {
                                                                let _e1766 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1727.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1772 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1766.unnamed.word, _e1727.y), _e1766.unnamed_1);
                                                                let _e1778 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1772.unnamed, lt_mask_LightPlace(_e1727.z, _e1772.unnamed_1.shift));
                                                                phi_2278_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1778.unnamed, lt_mask_LightPlace(_e1778.unnamed_1.word, _e1727.w));
                                                            }
                                                            let _e1786 = phi_2278_;
                                                            phi_2284_ = 0u;
                                                            phi_2287_ = 0u;
                                                            loop {
                                                                let _e1796 = phi_2284_;
                                                                let _e1798 = phi_2287_;
                                                                local_6 = _e1798;
                                                                local_7 = _e1798;
                                                                local_8 = _e1798;
                                                                let _e1799 = (_e1796 < 8u);
                                                                if _e1799 {
                                                                    let _e1801 = (_e1796 >> bitcast<u32>(2i));
                                                                    let _e1802 = (_e1796 & 3u);
                                                                    if (_e1801 == 0u) {
                                                                        phi_2301_ = _e1648.unnamed.word;
                                                                    } else {
                                                                        phi_2301_ = _e1648.unnamed.shift;
                                                                    }
                                                                    let _e1805 = phi_2301_;
                                                                    if (_e1801 == 0u) {
                                                                        phi_2311_ = _e1717.unnamed.word;
                                                                    } else {
                                                                        phi_2311_ = _e1717.unnamed.shift;
                                                                    }
                                                                    let _e1814 = phi_2311_;
                                                                    if (_e1801 == 0u) {
                                                                        phi_2321_ = _e1786.unnamed.word;
                                                                    } else {
                                                                        phi_2321_ = _e1786.unnamed.shift;
                                                                    }
                                                                    let _e1823 = phi_2321_;
                                                                    let _e1836 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1805 >> bitcast<u32>(((_e1802 * 8u) & 31u))) & 255u)) * _e1561) + (_e1579 - _e1338)), ((f32(((_e1814 >> bitcast<u32>(((_e1802 * 8u) & 31u))) & 255u)) * _e1562) + (_e1580 - _e1339)));
                                                                    let _e1837 = core_intrinsics_maximum_number_nsz_f32_(_e1836, ((f32(((_e1823 >> bitcast<u32>(((_e1802 * 8u) & 31u))) & 255u)) * _e1563) + (_e1581 - _e1340)));
                                                                    if (_e1801 == 0u) {
                                                                        phi_2339_ = _e1648.unnamed_1.word;
                                                                    } else {
                                                                        phi_2339_ = _e1648.unnamed_1.shift;
                                                                    }
                                                                    let _e1840 = phi_2339_;
                                                                    if (_e1801 == 0u) {
                                                                        phi_2349_ = _e1717.unnamed_1.word;
                                                                    } else {
                                                                        phi_2349_ = _e1717.unnamed_1.shift;
                                                                    }
                                                                    let _e1849 = phi_2349_;
                                                                    if (_e1801 == 0u) {
                                                                        phi_2359_ = _e1786.unnamed_1.word;
                                                                    } else {
                                                                        phi_2359_ = _e1786.unnamed_1.shift;
                                                                    }
                                                                    let _e1858 = phi_2359_;
                                                                    let _e1871 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1840 >> bitcast<u32>(((_e1802 * 8u) & 31u))) & 255u)) * _e1561) + (_e1579 + _e1338)), ((f32(((_e1849 >> bitcast<u32>(((_e1802 * 8u) & 31u))) & 255u)) * _e1562) + (_e1580 + _e1339)));
                                                                    let _e1872 = core_intrinsics_minimum_number_nsz_f32_(_e1871, ((f32(((_e1858 >> bitcast<u32>(((_e1802 * 8u) & 31u))) & 255u)) * _e1563) + (_e1581 + _e1340)));
                                                                    if (_e1837 <= _e1872) {
                                                                        if (_e1837 <= _e1526.t) {
                                                                            if (_e1872 >= _e165.tmin) {
                                                                                if (_e1801 == 0u) {
                                                                                    let _e1879 = nodes.member[(0u + _e1528)].links[2u];
                                                                                    phi_2395_ = _e1879;
                                                                                } else {
                                                                                    let _e1882 = nodes.member[(0u + _e1528)].links[3u];
                                                                                    phi_2395_ = _e1882;
                                                                                }
                                                                                let _e1884 = phi_2395_;
                                                                                let _e1889 = ((_e1884 >> bitcast<u32>(((_e1802 * 8u) & 31u))) & 255u);
                                                                                let _e1890 = (_e1889 & 31u);
                                                                                if (_e1890 >= 24u) {
                                                                                    phi_2408_ = (24u + ((_e1890 - 24u) ^ _e1388));
                                                                                } else {
                                                                                    phi_2408_ = _e1890;
                                                                                }
                                                                                let _e1896 = phi_2408_;
                                                                                phi_2413_ = (_e1798 | ((_e1889 >> bitcast<u32>(5i)) << bitcast<u32>((_e1896 & 31u))));
                                                                            } else {
                                                                                phi_2413_ = _e1798;
                                                                            }
                                                                            let _e1904 = phi_2413_;
                                                                            phi_2414_ = _e1904;
                                                                        } else {
                                                                            phi_2414_ = _e1798;
                                                                        }
                                                                        let _e1906 = phi_2414_;
                                                                        phi_2415_ = _e1906;
                                                                    } else {
                                                                        phi_2415_ = _e1798;
                                                                    }
                                                                    let _e1908 = phi_2415_;
                                                                    phi_2285_ = (_e1796 + 1u);
                                                                    phi_2288_ = _e1908;
                                                                } else {
                                                                    phi_2285_ = u32();
                                                                    phi_2288_ = u32();
                                                                }
                                                                let _e1911 = phi_2285_;
                                                                let _e1913 = phi_2288_;
                                                                continue;
                                                                continuing {
                                                                    phi_2284_ = _e1911;
                                                                    phi_2287_ = _e1913;
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
                                                            phi_2473_ = _e1526;
                                                            phi_2476_ = (_e1962 & 16777215u);
                                                            loop {
                                                                let _e1965 = phi_2473_;
                                                                let _e1967 = phi_2476_;
                                                                local_9 = _e1965;
                                                                if (_e1967 == 0u) {
                                                                    phi_2474_ = lt_bvh_Hit();
                                                                    phi_2477_ = u32();
                                                                    phi_3315_ = false;
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
                                                                        phi_2521_ = vec3<f32>(_e1987, _e1989, _e1985);
                                                                    } else {
                                                                        if (_e1361 == 1u) {
                                                                            phi_2520_ = vec3<f32>(_e1989, _e1985, _e1987);
                                                                        } else {
                                                                            phi_2520_ = (_e1983 - vec3<f32>(_e1075, _e1088, _e1101));
                                                                        }
                                                                        let _e1997 = phi_2520_;
                                                                        phi_2521_ = _e1997;
                                                                    }
                                                                    let _e1999 = phi_2521_;
                                                                    let _e2003 = (_e1999.x - (_e1372 * _e1999.z));
                                                                    let _e2007 = (_e1999.y - (_e1375 * _e1999.z));
                                                                    let _e2009 = triangles.member[(0u + _e1976)].v1_;
                                                                    let _e2011 = (_e2009.x - _e1075);
                                                                    let _e2013 = (_e2009.y - _e1088);
                                                                    let _e2015 = (_e2009.z - _e1101);
                                                                    if (_e1361 == 0u) {
                                                                        phi_2551_ = vec3<f32>(_e2013, _e2015, _e2011);
                                                                    } else {
                                                                        if (_e1361 == 1u) {
                                                                            phi_2550_ = vec3<f32>(_e2015, _e2011, _e2013);
                                                                        } else {
                                                                            phi_2550_ = (_e2009 - vec3<f32>(_e1075, _e1088, _e1101));
                                                                        }
                                                                        let _e2023 = phi_2550_;
                                                                        phi_2551_ = _e2023;
                                                                    }
                                                                    let _e2025 = phi_2551_;
                                                                    let _e2029 = (_e2025.x - (_e1372 * _e2025.z));
                                                                    let _e2033 = (_e2025.y - (_e1375 * _e2025.z));
                                                                    let _e2035 = triangles.member[(0u + _e1976)].v2_;
                                                                    let _e2037 = (_e2035.x - _e1075);
                                                                    let _e2039 = (_e2035.y - _e1088);
                                                                    let _e2041 = (_e2035.z - _e1101);
                                                                    if (_e1361 == 0u) {
                                                                        phi_2581_ = vec3<f32>(_e2039, _e2041, _e2037);
                                                                    } else {
                                                                        if (_e1361 == 1u) {
                                                                            phi_2580_ = vec3<f32>(_e2041, _e2037, _e2039);
                                                                        } else {
                                                                            phi_2580_ = (_e2035 - vec3<f32>(_e1075, _e1088, _e1101));
                                                                        }
                                                                        let _e2049 = phi_2580_;
                                                                        phi_2581_ = _e2049;
                                                                    }
                                                                    let _e2051 = phi_2581_;
                                                                    let _e2055 = (_e2051.x - (_e1372 * _e2051.z));
                                                                    let _e2059 = (_e2051.y - (_e1375 * _e2051.z));
                                                                    if (_e2029 < _e2055) {
                                                                        phi_2600_ = true;
                                                                    } else {
                                                                        if (_e2029 == _e2055) {
                                                                            phi_2599_ = (_e2033 < _e2059);
                                                                        } else {
                                                                            phi_2599_ = false;
                                                                        }
                                                                        let _e2064 = phi_2599_;
                                                                        phi_2600_ = _e2064;
                                                                    }
                                                                    let _e2066 = phi_2600_;
                                                                    if _e2066 {
                                                                        phi_2604_ = _e2059;
                                                                        phi_2605_ = _e2055;
                                                                        phi_2606_ = _e2033;
                                                                        phi_2607_ = _e2029;
                                                                    } else {
                                                                        phi_2604_ = _e2033;
                                                                        phi_2605_ = _e2029;
                                                                        phi_2606_ = _e2059;
                                                                        phi_2607_ = _e2055;
                                                                    }
                                                                    let _e2068 = phi_2604_;
                                                                    let _e2070 = phi_2605_;
                                                                    let _e2072 = phi_2606_;
                                                                    let _e2074 = phi_2607_;
                                                                    let _e2077 = ((_e2074 * _e2068) - (_e2072 * _e2070));
                                                                    if _e2066 {
                                                                        phi_2615_ = -(_e2077);
                                                                    } else {
                                                                        phi_2615_ = _e2077;
                                                                    }
                                                                    let _e2080 = phi_2615_;
                                                                    if (_e2055 < _e2003) {
                                                                        phi_2626_ = true;
                                                                    } else {
                                                                        if (_e2055 == _e2003) {
                                                                            phi_2625_ = (_e2059 < _e2007);
                                                                        } else {
                                                                            phi_2625_ = false;
                                                                        }
                                                                        let _e2085 = phi_2625_;
                                                                        phi_2626_ = _e2085;
                                                                    }
                                                                    let _e2087 = phi_2626_;
                                                                    if _e2087 {
                                                                        phi_2630_ = _e2007;
                                                                        phi_2631_ = _e2003;
                                                                        phi_2632_ = _e2059;
                                                                        phi_2633_ = _e2055;
                                                                    } else {
                                                                        phi_2630_ = _e2059;
                                                                        phi_2631_ = _e2055;
                                                                        phi_2632_ = _e2007;
                                                                        phi_2633_ = _e2003;
                                                                    }
                                                                    let _e2089 = phi_2630_;
                                                                    let _e2091 = phi_2631_;
                                                                    let _e2093 = phi_2632_;
                                                                    let _e2095 = phi_2633_;
                                                                    let _e2098 = ((_e2095 * _e2089) - (_e2093 * _e2091));
                                                                    if _e2087 {
                                                                        phi_2641_ = -(_e2098);
                                                                    } else {
                                                                        phi_2641_ = _e2098;
                                                                    }
                                                                    let _e2101 = phi_2641_;
                                                                    if (_e2003 < _e2029) {
                                                                        phi_2652_ = true;
                                                                    } else {
                                                                        if (_e2003 == _e2029) {
                                                                            phi_2651_ = (_e2007 < _e2033);
                                                                        } else {
                                                                            phi_2651_ = false;
                                                                        }
                                                                        let _e2106 = phi_2651_;
                                                                        phi_2652_ = _e2106;
                                                                    }
                                                                    let _e2108 = phi_2652_;
                                                                    if _e2108 {
                                                                        phi_2656_ = _e2033;
                                                                        phi_2657_ = _e2029;
                                                                        phi_2658_ = _e2007;
                                                                        phi_2659_ = _e2003;
                                                                    } else {
                                                                        phi_2656_ = _e2007;
                                                                        phi_2657_ = _e2003;
                                                                        phi_2658_ = _e2033;
                                                                        phi_2659_ = _e2029;
                                                                    }
                                                                    let _e2110 = phi_2656_;
                                                                    let _e2112 = phi_2657_;
                                                                    let _e2114 = phi_2658_;
                                                                    let _e2116 = phi_2659_;
                                                                    let _e2119 = ((_e2116 * _e2110) - (_e2114 * _e2112));
                                                                    if _e2108 {
                                                                        phi_2667_ = -(_e2119);
                                                                    } else {
                                                                        phi_2667_ = _e2119;
                                                                    }
                                                                    let _e2122 = phi_2667_;
                                                                    if (_e2080 >= 0f) {
                                                                        if (_e2101 >= 0f) {
                                                                            if (_e2122 >= 0f) {
                                                                                phi_2682_ = ((_e2080 + _e2101) + _e2122);
                                                                                phi_2683_ = false;
                                                                            } else {
                                                                                phi_2682_ = f32();
                                                                                phi_2683_ = true;
                                                                            }
                                                                            let _e2129 = phi_2682_;
                                                                            let _e2131 = phi_2683_;
                                                                            phi_2684_ = _e2129;
                                                                            phi_2685_ = _e2131;
                                                                        } else {
                                                                            phi_2684_ = f32();
                                                                            phi_2685_ = true;
                                                                        }
                                                                        let _e2133 = phi_2684_;
                                                                        let _e2135 = phi_2685_;
                                                                        phi_2686_ = _e2133;
                                                                        phi_2687_ = _e2135;
                                                                    } else {
                                                                        phi_2686_ = f32();
                                                                        phi_2687_ = true;
                                                                    }
                                                                    let _e2137 = phi_2686_;
                                                                    let _e2139 = phi_2687_;
                                                                    if _e2139 {
                                                                        if (_e2080 <= 0f) {
                                                                            if (_e2101 <= 0f) {
                                                                                let _e2142 = (_e2122 <= 0f);
                                                                                if _e2142 {
                                                                                }
                                                                                phi_2705_ = ((_e2080 + _e2101) + _e2122);
                                                                                phi_2706_ = false;
                                                                                phi_2707_ = _e2142;
                                                                            } else {
                                                                                phi_2705_ = f32();
                                                                                phi_2706_ = true;
                                                                                phi_2707_ = false;
                                                                            }
                                                                            let _e2146 = phi_2705_;
                                                                            let _e2148 = phi_2706_;
                                                                            let _e2150 = phi_2707_;
                                                                            phi_2708_ = _e2146;
                                                                            phi_2709_ = _e2148;
                                                                            phi_2710_ = _e2150;
                                                                        } else {
                                                                            phi_2708_ = f32();
                                                                            phi_2709_ = true;
                                                                            phi_2710_ = false;
                                                                        }
                                                                        let _e2152 = phi_2708_;
                                                                        let _e2154 = phi_2709_;
                                                                        let _e2156 = phi_2710_;
                                                                        if _e2154 {
                                                                            phi_2714_ = false;
                                                                        } else {
                                                                            phi_2714_ = _e2156;
                                                                        }
                                                                        let _e2158 = phi_2714_;
                                                                        phi_2715_ = _e2152;
                                                                        phi_2716_ = _e2158;
                                                                    } else {
                                                                        phi_2715_ = _e2137;
                                                                        phi_2716_ = true;
                                                                    }
                                                                    let _e2160 = phi_2715_;
                                                                    let _e2162 = phi_2716_;
                                                                    if _e2162 {
                                                                        let _e2163 = (_e2160 == 0f);
                                                                        if _e2163 {
                                                                            phi_3032_ = lt_bvh_triangle_Intersection();
                                                                            phi_3033_ = false;
                                                                        } else {
                                                                            let _e2165 = triangles.member[(0u + _e1976)].v0_;
                                                                            let _e2167 = (_e2165.x - _e1075);
                                                                            let _e2169 = (_e2165.y - _e1088);
                                                                            let _e2171 = (_e2165.z - _e1101);
                                                                            if (_e1361 == 0u) {
                                                                                phi_2745_ = vec3<f32>(_e2169, _e2171, _e2167);
                                                                            } else {
                                                                                if (_e1361 == 1u) {
                                                                                    phi_2744_ = vec3<f32>(_e2171, _e2167, _e2169);
                                                                                } else {
                                                                                    phi_2744_ = (_e2165 - vec3<f32>(_e1075, _e1088, _e1101));
                                                                                }
                                                                                let _e2179 = phi_2744_;
                                                                                phi_2745_ = _e2179;
                                                                            }
                                                                            let _e2181 = phi_2745_;
                                                                            let _e2183 = triangles.member[(0u + _e1976)].v1_;
                                                                            let _e2185 = triangles.member[(0u + _e1976)].v0_;
                                                                            let _e2188 = (_e2183.x - _e2185.x);
                                                                            let _e2191 = (_e2183.y - _e2185.y);
                                                                            let _e2194 = (_e2183.z - _e2185.z);
                                                                            if (_e1361 == 0u) {
                                                                                phi_2771_ = vec3<f32>(_e2191, _e2194, _e2188);
                                                                            } else {
                                                                                if (_e1361 == 1u) {
                                                                                    phi_2770_ = vec3<f32>(_e2194, _e2188, _e2191);
                                                                                } else {
                                                                                    phi_2770_ = (_e2183 - _e2185);
                                                                                }
                                                                                let _e2201 = phi_2770_;
                                                                                phi_2771_ = _e2201;
                                                                            }
                                                                            let _e2203 = phi_2771_;
                                                                            let _e2205 = triangles.member[(0u + _e1976)].v2_;
                                                                            let _e2207 = triangles.member[(0u + _e1976)].v0_;
                                                                            let _e2210 = (_e2205.x - _e2207.x);
                                                                            let _e2213 = (_e2205.y - _e2207.y);
                                                                            let _e2216 = (_e2205.z - _e2207.z);
                                                                            if (_e1361 == 0u) {
                                                                                phi_2797_ = vec3<f32>(_e2213, _e2216, _e2210);
                                                                            } else {
                                                                                if (_e1361 == 1u) {
                                                                                    phi_2796_ = vec3<f32>(_e2216, _e2210, _e2213);
                                                                                } else {
                                                                                    phi_2796_ = (_e2205 - _e2207);
                                                                                }
                                                                                let _e2223 = phi_2796_;
                                                                                phi_2797_ = _e2223;
                                                                            }
                                                                            let _e2225 = phi_2797_;
                                                                            let _e2232 = ((_e2203.y * _e2225.z) - (_e2203.z * _e2225.y));
                                                                            let _e2239 = ((_e2203.z * _e2225.x) - (_e2203.x * _e2225.z));
                                                                            let _e2246 = ((_e2203.x * _e2225.y) - (_e2203.y * _e2225.x));
                                                                            let _e2260 = (((1f / _e1369.z) * (((_e2232 * _e2181.x) + (_e2239 * _e2181.y)) + (_e2246 * _e2181.z))) / (((_e2232 * _e1372) + (_e2239 * _e1375)) + _e2246));
                                                                            if (_e2260 > _e165.tmin) {
                                                                                if (_e2260 < _e165.tmax) {
                                                                                    let _e2264 = triangles.member[(0u + _e1976)].v0_;
                                                                                    let _e2266 = triangles.member[(0u + _e1976)].v1_;
                                                                                    if (_e2264.x < _e2266.x) {
                                                                                        phi_2853_ = _e2264.x;
                                                                                    } else {
                                                                                        phi_2853_ = _e2266.x;
                                                                                    }
                                                                                    let _e2273 = phi_2853_;
                                                                                    if (_e2264.y < _e2266.y) {
                                                                                        phi_2862_ = _e2264.y;
                                                                                    } else {
                                                                                        phi_2862_ = _e2266.y;
                                                                                    }
                                                                                    let _e2280 = phi_2862_;
                                                                                    if (_e2264.z < _e2266.z) {
                                                                                        phi_2871_ = _e2264.z;
                                                                                    } else {
                                                                                        phi_2871_ = _e2266.z;
                                                                                    }
                                                                                    let _e2287 = phi_2871_;
                                                                                    let _e2289 = triangles.member[(0u + _e1976)].v2_;
                                                                                    if (_e2273 < _e2289.x) {
                                                                                        phi_2880_ = _e2273;
                                                                                    } else {
                                                                                        phi_2880_ = _e2289.x;
                                                                                    }
                                                                                    let _e2294 = phi_2880_;
                                                                                    if (_e2280 < _e2289.y) {
                                                                                        phi_2887_ = _e2280;
                                                                                    } else {
                                                                                        phi_2887_ = _e2289.y;
                                                                                    }
                                                                                    let _e2299 = phi_2887_;
                                                                                    if (_e2287 < _e2289.z) {
                                                                                        phi_2894_ = _e2287;
                                                                                    } else {
                                                                                        phi_2894_ = _e2289.z;
                                                                                    }
                                                                                    let _e2304 = phi_2894_;
                                                                                    let _e2306 = triangles.member[(0u + _e1976)].v0_;
                                                                                    let _e2308 = triangles.member[(0u + _e1976)].v1_;
                                                                                    if (_e2306.x > _e2308.x) {
                                                                                        phi_2907_ = _e2306.x;
                                                                                    } else {
                                                                                        phi_2907_ = _e2308.x;
                                                                                    }
                                                                                    let _e2315 = phi_2907_;
                                                                                    if (_e2306.y > _e2308.y) {
                                                                                        phi_2916_ = _e2306.y;
                                                                                    } else {
                                                                                        phi_2916_ = _e2308.y;
                                                                                    }
                                                                                    let _e2322 = phi_2916_;
                                                                                    if (_e2306.z > _e2308.z) {
                                                                                        phi_2925_ = _e2306.z;
                                                                                    } else {
                                                                                        phi_2925_ = _e2308.z;
                                                                                    }
                                                                                    let _e2329 = phi_2925_;
                                                                                    let _e2331 = triangles.member[(0u + _e1976)].v2_;
                                                                                    if (_e2315 > _e2331.x) {
                                                                                        phi_2934_ = _e2315;
                                                                                    } else {
                                                                                        phi_2934_ = _e2331.x;
                                                                                    }
                                                                                    let _e2336 = phi_2934_;
                                                                                    if (_e2322 > _e2331.y) {
                                                                                        phi_2941_ = _e2322;
                                                                                    } else {
                                                                                        phi_2941_ = _e2331.y;
                                                                                    }
                                                                                    let _e2341 = phi_2941_;
                                                                                    if (_e2329 > _e2331.z) {
                                                                                        phi_2948_ = _e2329;
                                                                                    } else {
                                                                                        phi_2948_ = _e2331.z;
                                                                                    }
                                                                                    let _e2346 = phi_2948_;
                                                                                    let _e2350 = ((_e2294 - _e1075) * _e1290);
                                                                                    let _e2351 = ((_e2299 - _e1088) * _e1300);
                                                                                    let _e2352 = ((_e2304 - _e1101) * _e1310);
                                                                                    let _e2356 = ((_e2336 - _e1075) * _e1290);
                                                                                    let _e2357 = ((_e2341 - _e1088) * _e1300);
                                                                                    let _e2358 = ((_e2346 - _e1101) * _e1310);
                                                                                    if (_e2350 < _e2356) {
                                                                                        phi_2965_ = _e2350;
                                                                                    } else {
                                                                                        phi_2965_ = _e2356;
                                                                                    }
                                                                                    let _e2361 = phi_2965_;
                                                                                    if (_e2351 < _e2357) {
                                                                                        phi_2970_ = _e2351;
                                                                                    } else {
                                                                                        phi_2970_ = _e2357;
                                                                                    }
                                                                                    let _e2364 = phi_2970_;
                                                                                    if (_e2352 < _e2358) {
                                                                                        phi_2975_ = _e2352;
                                                                                    } else {
                                                                                        phi_2975_ = _e2358;
                                                                                    }
                                                                                    let _e2367 = phi_2975_;
                                                                                    if (_e2350 > _e2356) {
                                                                                        phi_2983_ = _e2350;
                                                                                    } else {
                                                                                        phi_2983_ = _e2356;
                                                                                    }
                                                                                    let _e2373 = phi_2983_;
                                                                                    if (_e2351 > _e2357) {
                                                                                        phi_2988_ = _e2351;
                                                                                    } else {
                                                                                        phi_2988_ = _e2357;
                                                                                    }
                                                                                    let _e2376 = phi_2988_;
                                                                                    if (_e2352 > _e2358) {
                                                                                        phi_2993_ = _e2352;
                                                                                    } else {
                                                                                        phi_2993_ = _e2358;
                                                                                    }
                                                                                    let _e2379 = phi_2993_;
                                                                                    let _e2383 = core_intrinsics_maximum_number_nsz_f32_((_e2361 - _e1345), (_e2364 - _e1346));
                                                                                    let _e2384 = core_intrinsics_maximum_number_nsz_f32_(_e2383, (_e2367 - _e1347));
                                                                                    let _e2385 = core_intrinsics_minimum_number_nsz_f32_((_e2373 + _e1345), (_e2376 + _e1346));
                                                                                    let _e2386 = core_intrinsics_minimum_number_nsz_f32_(_e2385, (_e2379 + _e1347));
                                                                                    if (_e2384 > _e1050) {
                                                                                        phi_3005_ = _e2384;
                                                                                    } else {
                                                                                        phi_3005_ = _e1050;
                                                                                    }
                                                                                    let _e2389 = phi_3005_;
                                                                                    if (_e2386 < _e1052) {
                                                                                        phi_3010_ = _e2386;
                                                                                    } else {
                                                                                        phi_3010_ = _e1052;
                                                                                    }
                                                                                    let _e2392 = phi_3010_;
                                                                                    if (_e2260 < _e2389) {
                                                                                        phi_3015_ = _e2389;
                                                                                    } else {
                                                                                        phi_3015_ = _e2260;
                                                                                    }
                                                                                    let _e2395 = phi_3015_;
                                                                                    if (_e2395 > _e2392) {
                                                                                        phi_3020_ = _e2392;
                                                                                    } else {
                                                                                        phi_3020_ = _e2395;
                                                                                    }
                                                                                    let _e2398 = phi_3020_;
                                                                                    phi_3025_ = lt_bvh_triangle_Intersection(_e2398, (_e2101 / _e2160), (_e2122 / _e2160), (_e2389 <= _e2392));
                                                                                    phi_3026_ = false;
                                                                                } else {
                                                                                    phi_3025_ = lt_bvh_triangle_Intersection();
                                                                                    phi_3026_ = true;
                                                                                }
                                                                                let _e2404 = phi_3025_;
                                                                                let _e2406 = phi_3026_;
                                                                                phi_3027_ = _e2404;
                                                                                phi_3028_ = _e2406;
                                                                            } else {
                                                                                phi_3027_ = lt_bvh_triangle_Intersection();
                                                                                phi_3028_ = true;
                                                                            }
                                                                            let _e2408 = phi_3027_;
                                                                            let _e2410 = phi_3028_;
                                                                            if _e2410 {
                                                                            }
                                                                            phi_3032_ = _e2408;
                                                                            phi_3033_ = _e2410;
                                                                        }
                                                                        let _e2412 = phi_3032_;
                                                                        let _e2414 = phi_3033_;
                                                                        phi_3034_ = _e2412;
                                                                        phi_3035_ = _e2163;
                                                                        phi_3036_ = _e2414;
                                                                    } else {
                                                                        phi_3034_ = lt_bvh_triangle_Intersection();
                                                                        phi_3035_ = true;
                                                                        phi_3036_ = false;
                                                                    }
                                                                    let _e2416 = phi_3034_;
                                                                    let _e2418 = phi_3035_;
                                                                    let _e2420 = phi_3036_;
                                                                    if _e2418 {
                                                                        phi_3040_ = true;
                                                                    } else {
                                                                        phi_3040_ = _e2420;
                                                                    }
                                                                    let _e2422 = phi_3040_;
                                                                    if _e2422 {
                                                                        phi_3044_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_3044_ = _e2416;
                                                                    }
                                                                    let _e2424 = phi_3044_;
                                                                    if _e2424.is_hit {
                                                                        if (_e2424.t > _e165.tmin) {
                                                                            if (_e2424.t < _e1965.t) {
                                                                                phi_3092_ = true;
                                                                            } else {
                                                                                if (_e2424.t == _e1965.t) {
                                                                                    if (_e1965.triangle != 4294967295u) {
                                                                                        if (_e1976 < _e1965.triangle) {
                                                                                            phi_3083_ = true;
                                                                                        } else {
                                                                                            if (_e1976 == _e1965.triangle) {
                                                                                                phi_3082_ = (_e991 < _e1965.instance);
                                                                                            } else {
                                                                                                phi_3082_ = false;
                                                                                            }
                                                                                            let _e2442 = phi_3082_;
                                                                                            phi_3083_ = _e2442;
                                                                                        }
                                                                                        let _e2444 = phi_3083_;
                                                                                        phi_3084_ = _e2444;
                                                                                        phi_3085_ = false;
                                                                                    } else {
                                                                                        phi_3084_ = bool();
                                                                                        phi_3085_ = true;
                                                                                    }
                                                                                    let _e2446 = phi_3084_;
                                                                                    let _e2448 = phi_3085_;
                                                                                    phi_3086_ = _e2446;
                                                                                    phi_3087_ = _e2448;
                                                                                } else {
                                                                                    phi_3086_ = bool();
                                                                                    phi_3087_ = true;
                                                                                }
                                                                                let _e2450 = phi_3086_;
                                                                                let _e2452 = phi_3087_;
                                                                                if _e2452 {
                                                                                    phi_3091_ = false;
                                                                                } else {
                                                                                    phi_3091_ = _e2450;
                                                                                }
                                                                                let _e2454 = phi_3091_;
                                                                                phi_3092_ = _e2454;
                                                                            }
                                                                            let _e2456 = phi_3092_;
                                                                            if _e2456 {
                                                                                let _e2458 = triangles.member[(0u + _e1976)].i0_;
                                                                                if ((_e2458 & 2147483648u) == 0u) {
                                                                                    phi_3303_ = true;
                                                                                } else {
                                                                                    if (_e1976 < _e81) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2467 = triangles.member[(0u + _e1976)].i0_;
                                                                                    let _e2468 = (_e2467 & 2147483647u);
                                                                                    let _e2470 = triangles.member[(0u + _e1976)].i1_;
                                                                                    let _e2472 = triangles.member[(0u + _e1976)].i2_;
                                                                                    if (_e2468 < _e84) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2476 = vertices.member[(0u + _e2468)];
                                                                                    if (_e2470 < _e84) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2480 = vertices.member[(0u + _e2470)];
                                                                                    if (_e2472 < _e84) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2484 = vertices.member[(0u + _e2472)];
                                                                                    let _e2485 = array<abi_Vertex, 3>(_e2476, _e2480, _e2484);
                                                                                    if (_e2485[0].material < _e87) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2491 = materials.member[(0u + _e2485[0].material)];
                                                                                    if ((_e2491.flags & 0u) == 0u) {
                                                                                        let _e2496 = ((1f - _e2424.u) - _e2424.v);
                                                                                        if (_e2491.cutoff <= 0f) {
                                                                                            phi_3298_ = true;
                                                                                        } else {
                                                                                            let _e2523 = (_e2491.base_color.w * ((((f32((_e2485[0].color >> bitcast<u32>(24i))) * _e2496) + (f32((_e2485[1].color >> bitcast<u32>(24i))) * _e2424.u)) + (f32((_e2485[2].color >> bitcast<u32>(24i))) * _e2424.v)) * (1f / 255f)));
                                                                                            if (_e2491.alpha_size == 0u) {
                                                                                                phi_3295_ = _e2523;
                                                                                            } else {
                                                                                                local.offset = _e2491.alpha_offset;
                                                                                                local.size = _e2491.alpha_size;
                                                                                                local.flags = _e2491.flags;
                                                                                                let _e2554 = _lt_shaders_texture_TextureView_quad((&local), (((_e2485[0].u * _e2496) + (_e2485[1].u * _e2424.u)) + (_e2485[2].u * _e2424.v)), (((_e2485[0].v * _e2496) + (_e2485[1].v * _e2424.u)) + (_e2485[2].v * _e2424.v)));
                                                                                                let _e2558 = (_e2554.indices[0] >> bitcast<u32>(2i));
                                                                                                if (_e2558 < _e96) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2562 = alpha_texels.member[(0u + _e2558)];
                                                                                                let _e2578 = (_e2554.indices[1] >> bitcast<u32>(2i));
                                                                                                if (_e2578 < _e96) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2582 = alpha_texels.member[(0u + _e2578)];
                                                                                                let _e2599 = (_e2554.indices[2] >> bitcast<u32>(2i));
                                                                                                if (_e2599 < _e96) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2603 = alpha_texels.member[(0u + _e2599)];
                                                                                                let _e2620 = (_e2554.indices[3] >> bitcast<u32>(2i));
                                                                                                if (_e2620 < _e96) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2624 = alpha_texels.member[(0u + _e2620)];
                                                                                                phi_3295_ = (_e2523 * (((((f32(((_e2562 >> bitcast<u32>((((_e2554.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2554.weights.x) + ((f32(((_e2582 >> bitcast<u32>((((_e2554.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2554.weights.y)) + ((f32(((_e2603 >> bitcast<u32>((((_e2554.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2554.weights.z)) + ((f32(((_e2624 >> bitcast<u32>((((_e2554.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2554.weights.w)));
                                                                                            }
                                                                                            let _e2640 = phi_3295_;
                                                                                            phi_3298_ = (_e2640 >= _e2491.cutoff);
                                                                                        }
                                                                                        let _e2644 = phi_3298_;
                                                                                        phi_3299_ = _e2644;
                                                                                    } else {
                                                                                        phi_3299_ = false;
                                                                                    }
                                                                                    let _e2646 = phi_3299_;
                                                                                    if _e2646 {
                                                                                    }
                                                                                    phi_3303_ = _e2646;
                                                                                }
                                                                                let _e2648 = phi_3303_;
                                                                                if _e2648 {
                                                                                    phi_3311_ = lt_bvh_Hit(_e2424.t, _e2424.u, _e2424.v, _e1976, _e991);
                                                                                } else {
                                                                                    phi_3311_ = _e1965;
                                                                                }
                                                                                let _e2654 = phi_3311_;
                                                                                phi_3312_ = _e2654;
                                                                            } else {
                                                                                phi_3312_ = _e1965;
                                                                            }
                                                                            let _e2656 = phi_3312_;
                                                                            phi_3313_ = _e2656;
                                                                        } else {
                                                                            phi_3313_ = _e1965;
                                                                        }
                                                                        let _e2658 = phi_3313_;
                                                                        phi_3314_ = _e2658;
                                                                    } else {
                                                                        phi_3314_ = _e1965;
                                                                    }
                                                                    let _e2660 = phi_3314_;
                                                                    phi_2474_ = _e2660;
                                                                    phi_2477_ = (_e1967 & (_e1967 - 1u));
                                                                    phi_3315_ = true;
                                                                }
                                                                let _e2662 = phi_2474_;
                                                                let _e2664 = phi_2477_;
                                                                let _e2666 = phi_3315_;
                                                                continue;
                                                                continuing {
                                                                    phi_2473_ = _e2662;
                                                                    phi_2476_ = _e2664;
                                                                    break if !(_e2666);
                                                                }
                                                            }
                                                            let _e2669 = local_1.group_mask;
                                                            if ((_e2669 & 4278190080u) == 0u) {
                                                                let _e2673 = local_1.len;
                                                                if (_e2673 == 0u) {
                                                                    phi_3354_ = false;
                                                                } else {
                                                                    let _e2677 = local_1.len;
                                                                    local_1.len = (_e2677 - 1u);
                                                                    let _e2680 = local_1.len;
                                                                    if (_e2680 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2685 = local_1.first[(0u + _e2680)];
                                                                    local_1.group = _e2685;
                                                                    let _e2688 = local_1.len;
                                                                    if (_e2688 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2693 = local_1.mask[(0u + _e2688)];
                                                                    local_1.group_mask = _e2693;
                                                                    phi_3354_ = true;
                                                                }
                                                                let _e2696 = phi_3354_;
                                                                phi_3355_ = _e2696;
                                                            } else {
                                                                phi_3355_ = true;
                                                            }
                                                            let _e2698 = phi_3355_;
                                                            if _e2698 {
                                                                let _e2700 = local_1.group_mask;
                                                                let _e2706 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2700)), 32u, (_e2700 == 0u)));
                                                                let _e2710 = local_1.group_mask;
                                                                let _e2724 = local_1.group_mask;
                                                                local_1.group_mask = (_e2724 & ~((1u << bitcast<u32>((_e2706 & 31u)))));
                                                                let _e2727 = local_1.group;
                                                                phi_3386_ = (_e2727 + countOneBits(((_e2710 & ~((4294967295u << bitcast<u32>((((_e2706 - 24u) ^ _e1388) & 31u))))) & 255u)));
                                                            } else {
                                                                phi_3386_ = 4294967295u;
                                                            }
                                                            let _e2730 = phi_3386_;
                                                            let _e3912 = local_9;
                                                            phi_2141_ = _e3912;
                                                            phi_2144_ = _e2730;
                                                        } else {
                                                            phi_2141_ = lt_bvh_Hit();
                                                            phi_2144_ = u32();
                                                        }
                                                        let _e2732 = phi_2141_;
                                                        let _e2734 = phi_2144_;
                                                        continue;
                                                        continuing {
                                                            phi_2140_ = _e2732;
                                                            phi_2143_ = _e2734;
                                                            break if !(_e1529);
                                                        }
                                                    }
                                                    let _e3916 = local_10;
                                                    phi_3387_ = _e3916;
                                                }
                                                let _e2737 = phi_3387_;
                                                phi_3388_ = _e2737;
                                                phi_3389_ = _e1214;
                                            } else {
                                                phi_3388_ = lt_bvh_Hit();
                                                phi_3389_ = true;
                                            }
                                            let _e2739 = phi_3388_;
                                            let _e2741 = phi_3389_;
                                            if _e2741 {
                                                phi_3393_ = _e983;
                                            } else {
                                                phi_3393_ = _e2739;
                                            }
                                            let _e2743 = phi_3393_;
                                            phi_3394_ = _e2743;
                                        } else {
                                            phi_3394_ = _e983;
                                        }
                                        let _e2745 = phi_3394_;
                                        phi_3395_ = _e2745;
                                    } else {
                                        phi_3395_ = _e983;
                                    }
                                    let _e2747 = phi_3395_;
                                    phi_3396_ = _e2747;
                                } else {
                                    phi_3396_ = _e983;
                                }
                                let _e2749 = phi_3396_;
                                phi_1515_ = (_e981 & (_e981 - 1u));
                                phi_1518_ = _e2749;
                                phi_3397_ = true;
                            }
                            let _e2751 = phi_1515_;
                            let _e2753 = phi_1518_;
                            let _e2755 = phi_3397_;
                            continue;
                            continuing {
                                phi_1514_ = _e2751;
                                phi_1517_ = _e2753;
                                break if !(_e2755);
                            }
                        }
                        let _e2758 = local_2.group_mask;
                        if ((_e2758 & 4278190080u) == 0u) {
                            let _e2762 = local_2.len;
                            if (_e2762 == 0u) {
                                phi_3436_ = false;
                            } else {
                                let _e2766 = local_2.len;
                                local_2.len = (_e2766 - 1u);
                                let _e2769 = local_2.len;
                                if (_e2769 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2774 = local_2.first[(0u + _e2769)];
                                local_2.group = _e2774;
                                let _e2777 = local_2.len;
                                if (_e2777 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2782 = local_2.mask[(0u + _e2777)];
                                local_2.group_mask = _e2782;
                                phi_3436_ = true;
                            }
                            let _e2785 = phi_3436_;
                            phi_3437_ = _e2785;
                        } else {
                            phi_3437_ = true;
                        }
                        let _e2787 = phi_3437_;
                        if _e2787 {
                            let _e2789 = local_2.group_mask;
                            let _e2795 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2789)), 32u, (_e2789 == 0u)));
                            let _e2799 = local_2.group_mask;
                            let _e2813 = local_2.group_mask;
                            local_2.group_mask = (_e2813 & ~((1u << bitcast<u32>((_e2795 & 31u)))));
                            let _e2816 = local_2.group;
                            phi_3468_ = (_e2816 + countOneBits(((_e2799 & ~((4294967295u << bitcast<u32>((((_e2795 - 24u) ^ _e400) & 31u))))) & 255u)));
                        } else {
                            phi_3468_ = 4294967295u;
                        }
                        let _e2819 = phi_3468_;
                        phi_1178_ = _e2819;
                        let _e3932 = local_11;
                        phi_1181_ = _e3932;
                    } else {
                        phi_1178_ = u32();
                        phi_1181_ = lt_bvh_Hit();
                    }
                    let _e2821 = phi_1178_;
                    let _e2823 = phi_1181_;
                    continue;
                    continuing {
                        phi_1177_ = _e2821;
                        phi_1180_ = _e2823;
                        break if !(_e541);
                    }
                }
                let _e3935 = local_12;
                phi_3469_ = _e3935;
            }
            let _e2826 = phi_3469_;
            phi_3470_ = _e2826;
            phi_3471_ = _e237;
        } else {
            phi_3470_ = lt_bvh_Hit();
            phi_3471_ = true;
        }
        let _e2828 = phi_3470_;
        let _e2830 = phi_3471_;
        if _e2830 {
            phi_3475_ = _e167;
        } else {
            phi_3475_ = _e2828;
        }
        let _e2832 = phi_3475_;
        if (_e2832.triangle != 4294967295u) {
            let _e2838 = ((1f - _e2832.u) - _e2832.v);
            if (_e2832.triangle < _e81) {
            } else {
                return;
            }
            let _e2844 = triangles.member[(0u + _e2832.triangle)];
            if (_e2832.instance < _e93) {
            } else {
                return;
            }
            let _e2855 = instances.member[(0u + _e2832.instance)].object_to_world[0u];
            let _e2866 = ((((_e2855.x * _e2844.v0_.x) + (_e2855.y * _e2844.v0_.y)) + (_e2855.z * _e2844.v0_.z)) + (_e2855.w * 1f));
            let _e2868 = instances.member[(0u + _e2832.instance)].object_to_world[1u];
            let _e2879 = ((((_e2868.x * _e2844.v0_.x) + (_e2868.y * _e2844.v0_.y)) + (_e2868.z * _e2844.v0_.z)) + (_e2868.w * 1f));
            let _e2881 = instances.member[(0u + _e2832.instance)].object_to_world[2u];
            let _e2892 = ((((_e2881.x * _e2844.v0_.x) + (_e2881.y * _e2844.v0_.y)) + (_e2881.z * _e2844.v0_.z)) + (_e2881.w * 1f));
            let _e2899 = instances.member[(0u + _e2832.instance)].object_to_world[0u];
            let _e2910 = ((((_e2899.x * _e2844.v1_.x) + (_e2899.y * _e2844.v1_.y)) + (_e2899.z * _e2844.v1_.z)) + (_e2899.w * 1f));
            let _e2912 = instances.member[(0u + _e2832.instance)].object_to_world[1u];
            let _e2923 = ((((_e2912.x * _e2844.v1_.x) + (_e2912.y * _e2844.v1_.y)) + (_e2912.z * _e2844.v1_.z)) + (_e2912.w * 1f));
            let _e2925 = instances.member[(0u + _e2832.instance)].object_to_world[2u];
            let _e2936 = ((((_e2925.x * _e2844.v1_.x) + (_e2925.y * _e2844.v1_.y)) + (_e2925.z * _e2844.v1_.z)) + (_e2925.w * 1f));
            let _e2943 = instances.member[(0u + _e2832.instance)].object_to_world[0u];
            let _e2954 = ((((_e2943.x * _e2844.v2_.x) + (_e2943.y * _e2844.v2_.y)) + (_e2943.z * _e2844.v2_.z)) + (_e2943.w * 1f));
            let _e2956 = instances.member[(0u + _e2832.instance)].object_to_world[1u];
            let _e2967 = ((((_e2956.x * _e2844.v2_.x) + (_e2956.y * _e2844.v2_.y)) + (_e2956.z * _e2844.v2_.z)) + (_e2956.w * 1f));
            let _e2969 = instances.member[(0u + _e2832.instance)].object_to_world[2u];
            let _e2980 = ((((_e2969.x * _e2844.v2_.x) + (_e2969.y * _e2844.v2_.y)) + (_e2969.z * _e2844.v2_.z)) + (_e2969.w * 1f));
            let _e2993 = (((_e2866 * _e2838) + (_e2910 * _e2832.u)) + (_e2954 * _e2832.v));
            let _e2994 = (((_e2879 * _e2838) + (_e2923 * _e2832.u)) + (_e2967 * _e2832.v));
            let _e2995 = (((_e2892 * _e2838) + (_e2936 * _e2832.u)) + (_e2980 * _e2832.v));
            let _e2997 = abs(_e2866);
            let _e2998 = abs(_e2879);
            let _e2999 = abs(_e2892);
            let _e3000 = abs(_e2910);
            let _e3001 = abs(_e2923);
            let _e3002 = abs(_e2936);
            if (_e2997 > _e3000) {
                phi_3663_ = _e2997;
            } else {
                phi_3663_ = _e3000;
            }
            let _e3005 = phi_3663_;
            if (_e2998 > _e3001) {
                phi_3668_ = _e2998;
            } else {
                phi_3668_ = _e3001;
            }
            let _e3008 = phi_3668_;
            if (_e2999 > _e3002) {
                phi_3673_ = _e2999;
            } else {
                phi_3673_ = _e3002;
            }
            let _e3011 = phi_3673_;
            let _e3012 = abs(_e2954);
            let _e3013 = abs(_e2967);
            let _e3014 = abs(_e2980);
            if (_e3005 > _e3012) {
                phi_3681_ = _e3005;
            } else {
                phi_3681_ = _e3012;
            }
            let _e3017 = phi_3681_;
            if (_e3008 > _e3013) {
                phi_3686_ = _e3008;
            } else {
                phi_3686_ = _e3013;
            }
            let _e3020 = phi_3686_;
            if (_e3011 > _e3014) {
                phi_3691_ = _e3011;
            } else {
                phi_3691_ = _e3014;
            }
            let _e3023 = phi_3691_;
            let _e3024 = (_e2910 - _e2866);
            let _e3025 = (_e2923 - _e2879);
            let _e3026 = (_e2936 - _e2892);
            let _e3027 = (_e2954 - _e2866);
            let _e3028 = (_e2967 - _e2879);
            let _e3029 = (_e2980 - _e2892);
            let _e3033 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3025), abs(_e3026));
            let _e3034 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3024), _e3033);
            let _e3035 = (_e3024 / _e3034);
            let _e3036 = (_e3025 / _e3034);
            let _e3037 = (_e3026 / _e3034);
            let _e3041 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3028), abs(_e3029));
            let _e3042 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3027), _e3041);
            let _e3043 = (_e3027 / _e3042);
            let _e3044 = (_e3028 / _e3042);
            let _e3045 = (_e3029 / _e3042);
            let _e3048 = ((_e3036 * _e3045) - (_e3044 * _e3037));
            let _e3051 = ((_e3037 * _e3043) - (_e3045 * _e3035));
            let _e3054 = ((_e3035 * _e3044) - (_e3043 * _e3036));
            let _e3056 = p.member.eye;
            let _e3069 = (1f / sqrt((((_e3048 * _e3048) + (_e3051 * _e3051)) + (_e3054 * _e3054))));
            let _e3070 = (_e3048 * _e3069);
            let _e3071 = (_e3051 * _e3069);
            let _e3072 = (_e3054 * _e3069);
            if ((((_e3070 * (_e3056.x - _e2993)) + (_e3071 * (_e3056.y - _e2994))) + (_e3072 * (_e3056.z - _e2995))) < 0f) {
                phi_3755_ = vec3<f32>(-(_e3070), -(_e3071), -(_e3072));
            } else {
                phi_3755_ = vec3<f32>(_e3070, _e3071, _e3072);
            }
            let _e3085 = phi_3755_;
            if (_e2832.triangle < _e81) {
            } else {
                return;
            }
            let _e3090 = triangles.member[(0u + _e2832.triangle)];
            let _e3092 = (_e3090.i0_ & 2147483647u);
            if (_e3092 < _e84) {
            } else {
                return;
            }
            let _e3098 = vertices.member[(0u + _e3092)];
            if (_e3090.i1_ < _e84) {
            } else {
                return;
            }
            let _e3102 = vertices.member[(0u + _e3090.i1_)];
            if (_e3090.i2_ < _e84) {
            } else {
                return;
            }
            let _e3106 = vertices.member[(0u + _e3090.i2_)];
            let _e3107 = array<abi_Vertex, 3>(_e3098, _e3102, _e3106);
            if (_e3107[0].material < _e87) {
            } else {
                return;
            }
            let _e3113 = materials.member[(0u + _e3107[0].material)];
            let _e3130 = (1f / 255f);
            let _e3149 = (1f / 255f);
            let _e3171 = (1f / 255f);
            let _e3184 = _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(vec3<f32>(_e2838, _e2832.u, _e2832.v));
            let _e3186 = ((_e3113.base_color.x * ((((f32((_e3107[0].color & 255u)) * _e3130) * _e2838) + ((f32((_e3107[1].color & 255u)) * _e3149) * _e2832.u)) + ((f32((_e3107[2].color & 255u)) * _e3171) * _e2832.v))) * _e3184.x);
            let _e3188 = ((_e3113.base_color.y * ((((f32(((_e3107[0].color >> bitcast<u32>(8i)) & 255u)) * _e3130) * _e2838) + ((f32(((_e3107[1].color >> bitcast<u32>(8i)) & 255u)) * _e3149) * _e2832.u)) + ((f32(((_e3107[2].color >> bitcast<u32>(8i)) & 255u)) * _e3171) * _e2832.v))) * _e3184.y);
            let _e3190 = ((_e3113.base_color.z * ((((f32(((_e3107[0].color >> bitcast<u32>(16i)) & 255u)) * _e3130) * _e2838) + ((f32(((_e3107[1].color >> bitcast<u32>(16i)) & 255u)) * _e3149) * _e2832.u)) + ((f32(((_e3107[2].color >> bitcast<u32>(16i)) & 255u)) * _e3171) * _e2832.v))) * _e3184.z);
            let _e3191 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e3020, _e3023);
            let _e3192 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e3017, _e3191);
            if ((_e3113.flags & 2u) == 0u) {
                phi_3876_ = 0u;
            } else {
                phi_3876_ = 1u;
            }
            let _e3197 = phi_3876_;
            if (_e3107[0].normal == 2147516416u) {
                phi_4106_ = _e3085;
            } else {
                let _e3210 = (f32((bitcast<i32>((_e3107[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3216 = (f32((bitcast<i32>(_e3107[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3220 = ((1f - abs(_e3210)) - abs(_e3216));
                if (_e3220 < 0f) {
                    phi_3903_ = -(_e3220);
                } else {
                    phi_3903_ = 0f;
                }
                let _e3224 = phi_3903_;
                if (_e3210 < 0f) {
                    phi_3910_ = (_e3210 + _e3224);
                } else {
                    phi_3910_ = (_e3210 - _e3224);
                }
                let _e3229 = phi_3910_;
                if (_e3216 < 0f) {
                    phi_3917_ = (_e3216 + _e3224);
                } else {
                    phi_3917_ = (_e3216 - _e3224);
                }
                let _e3234 = phi_3917_;
                let _e3241 = (1f / sqrt((((_e3229 * _e3229) + (_e3234 * _e3234)) + (_e3220 * _e3220))));
                let _e3257 = (f32((bitcast<i32>((_e3107[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3263 = (f32((bitcast<i32>(_e3107[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3267 = ((1f - abs(_e3257)) - abs(_e3263));
                if (_e3267 < 0f) {
                    phi_3952_ = -(_e3267);
                } else {
                    phi_3952_ = 0f;
                }
                let _e3271 = phi_3952_;
                if (_e3257 < 0f) {
                    phi_3959_ = (_e3257 + _e3271);
                } else {
                    phi_3959_ = (_e3257 - _e3271);
                }
                let _e3276 = phi_3959_;
                if (_e3263 < 0f) {
                    phi_3966_ = (_e3263 + _e3271);
                } else {
                    phi_3966_ = (_e3263 - _e3271);
                }
                let _e3281 = phi_3966_;
                let _e3288 = (1f / sqrt((((_e3276 * _e3276) + (_e3281 * _e3281)) + (_e3267 * _e3267))));
                let _e3307 = (f32((bitcast<i32>((_e3107[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3313 = (f32((bitcast<i32>(_e3107[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3317 = ((1f - abs(_e3307)) - abs(_e3313));
                if (_e3317 < 0f) {
                    phi_4004_ = -(_e3317);
                } else {
                    phi_4004_ = 0f;
                }
                let _e3321 = phi_4004_;
                if (_e3307 < 0f) {
                    phi_4011_ = (_e3307 + _e3321);
                } else {
                    phi_4011_ = (_e3307 - _e3321);
                }
                let _e3326 = phi_4011_;
                if (_e3313 < 0f) {
                    phi_4018_ = (_e3313 + _e3321);
                } else {
                    phi_4018_ = (_e3313 - _e3321);
                }
                let _e3331 = phi_4018_;
                let _e3338 = (1f / sqrt((((_e3326 * _e3326) + (_e3331 * _e3331)) + (_e3317 * _e3317))));
                let _e3345 = ((((_e3229 * _e3241) * _e2838) + ((_e3276 * _e3288) * _e2832.u)) + ((_e3326 * _e3338) * _e2832.v));
                let _e3346 = ((((_e3234 * _e3241) * _e2838) + ((_e3281 * _e3288) * _e2832.u)) + ((_e3331 * _e3338) * _e2832.v));
                let _e3347 = ((((_e3220 * _e3241) * _e2838) + ((_e3267 * _e3288) * _e2832.u)) + ((_e3317 * _e3338) * _e2832.v));
                if (_e2832.instance < _e93) {
                } else {
                    return;
                }
                let _e3354 = instances.member[(0u + _e2832.instance)].world_to_object[0u];
                let _e3363 = instances.member[(0u + _e2832.instance)].world_to_object[1u];
                let _e3375 = instances.member[(0u + _e2832.instance)].world_to_object[2u];
                let _e3382 = (((_e3354.x * _e3345) + (_e3363.x * _e3346)) + (_e3375.x * _e3347));
                let _e3383 = (((_e3354.y * _e3345) + (_e3363.y * _e3346)) + (_e3375.y * _e3347));
                let _e3384 = (((_e3354.z * _e3345) + (_e3363.z * _e3346)) + (_e3375.z * _e3347));
                let _e3390 = sqrt((((_e3382 * _e3382) + (_e3383 * _e3383)) + (_e3384 * _e3384)));
                if (_e3390 > 0f) {
                    let _e3392 = (_e3382 / _e3390);
                    let _e3393 = (_e3383 / _e3390);
                    let _e3394 = (_e3384 / _e3390);
                    if ((((_e3392 * _e3085.x) + (_e3393 * _e3085.y)) + (_e3394 * _e3085.z)) < 0f) {
                        phi_4104_ = vec3<f32>(-(_e3392), -(_e3393), -(_e3394));
                    } else {
                        phi_4104_ = vec3<f32>(_e3392, _e3393, _e3394);
                    }
                    let _e3410 = phi_4104_;
                    phi_4105_ = _e3410;
                } else {
                    phi_4105_ = _e3085;
                }
                let _e3412 = phi_4105_;
                phi_4106_ = _e3412;
            }
            let _e3414 = phi_4106_;
            if (_e3186 > 0f) {
                if (_e3186 < 1f) {
                    phi_4115_ = _e3186;
                } else {
                    phi_4115_ = 1f;
                }
                let _e3418 = phi_4115_;
                phi_4116_ = _e3418;
            } else {
                phi_4116_ = 0f;
            }
            let _e3420 = phi_4116_;
            if (_e3188 > 0f) {
                if (_e3188 < 1f) {
                    phi_4126_ = _e3188;
                } else {
                    phi_4126_ = 1f;
                }
                let _e3425 = phi_4126_;
                phi_4127_ = _e3425;
            } else {
                phi_4127_ = 0f;
            }
            let _e3427 = phi_4127_;
            if (_e3190 > 0f) {
                if (_e3190 < 1f) {
                    phi_4137_ = _e3190;
                } else {
                    phi_4137_ = 1f;
                }
                let _e3432 = phi_4137_;
                phi_4138_ = _e3432;
            } else {
                phi_4138_ = 0f;
            }
            let _e3434 = phi_4138_;
            let _e3437 = ((sqrt(_e3420) * 255f) + 0.5f);
            let _e3446 = ((sqrt(_e3427) * 255f) + 0.5f);
            let _e3458 = ((sqrt(_e3434) * 255f) + 0.5f);
            phi_4173_ = abi_Sample(vec3<f32>(_e2993, _e2994, _e2995), _e3192, _e3085, _e3197, _e3414, ((select(select(u32(_e3437), 0u, (_e3437 < bitcast<f32>(0u))), 4294967295u, (_e3437 > bitcast<f32>(1333788671u))) | (select(select(u32(_e3446), 0u, (_e3446 < bitcast<f32>(0u))), 4294967295u, (_e3446 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e3458), 0u, (_e3458 < bitcast<f32>(0u))), 4294967295u, (_e3458 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_4173_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e3472 = phi_4173_;
        if (_e108.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e108.shift)] = _e3472;
        if (_e2832.triangle != 4294967295u) {
            let _e3481 = ((1f - _e2832.u) - _e2832.v);
            if (_e2832.triangle < _e81) {
            } else {
                return;
            }
            let _e3486 = triangles.member[(0u + _e2832.triangle)];
            let _e3488 = (_e3486.i0_ & 2147483647u);
            if (_e3488 < _e99) {
            } else {
                return;
            }
            let _e3494 = before.member[(0u + _e3488)];
            if (_e3486.i1_ < _e99) {
            } else {
                return;
            }
            let _e3498 = before.member[(0u + _e3486.i1_)];
            if (_e3486.i2_ < _e99) {
            } else {
                return;
            }
            let _e3502 = before.member[(0u + _e3486.i2_)];
            if (_e2832.instance < _e93) {
            } else {
                return;
            }
            let _e3512 = instances.member[(0u + _e2832.instance)].object_to_world[0u];
            let _e3525 = instances.member[(0u + _e2832.instance)].object_to_world[1u];
            let _e3538 = instances.member[(0u + _e2832.instance)].object_to_world[2u];
            if (_e2832.instance < _e93) {
            } else {
                return;
            }
            let _e3562 = instances.member[(0u + _e2832.instance)].object_to_world[0u];
            let _e3575 = instances.member[(0u + _e2832.instance)].object_to_world[1u];
            let _e3588 = instances.member[(0u + _e2832.instance)].object_to_world[2u];
            if (_e2832.instance < _e93) {
            } else {
                return;
            }
            let _e3615 = instances.member[(0u + _e2832.instance)].object_to_world[0u];
            let _e3628 = instances.member[(0u + _e2832.instance)].object_to_world[1u];
            let _e3641 = instances.member[(0u + _e2832.instance)].object_to_world[2u];
            phi_4396_ = vec3<f32>((((((((_e3512.x * _e3494.x) + (_e3512.y * _e3494.y)) + (_e3512.z * _e3494.z)) + (_e3512.w * 1f)) * _e3481) + (((((_e3562.x * _e3498.x) + (_e3562.y * _e3498.y)) + (_e3562.z * _e3498.z)) + (_e3562.w * 1f)) * _e2832.u)) + (((((_e3615.x * _e3502.x) + (_e3615.y * _e3502.y)) + (_e3615.z * _e3502.z)) + (_e3615.w * 1f)) * _e2832.v)), (((((((_e3525.x * _e3494.x) + (_e3525.y * _e3494.y)) + (_e3525.z * _e3494.z)) + (_e3525.w * 1f)) * _e3481) + (((((_e3575.x * _e3498.x) + (_e3575.y * _e3498.y)) + (_e3575.z * _e3498.z)) + (_e3575.w * 1f)) * _e2832.u)) + (((((_e3628.x * _e3502.x) + (_e3628.y * _e3502.y)) + (_e3628.z * _e3502.z)) + (_e3628.w * 1f)) * _e2832.v)), (((((((_e3538.x * _e3494.x) + (_e3538.y * _e3494.y)) + (_e3538.z * _e3494.z)) + (_e3538.w * 1f)) * _e3481) + (((((_e3588.x * _e3498.x) + (_e3588.y * _e3498.y)) + (_e3588.z * _e3498.z)) + (_e3588.w * 1f)) * _e2832.u)) + (((((_e3641.x * _e3502.x) + (_e3641.y * _e3502.y)) + (_e3641.z * _e3502.z)) + (_e3641.w * 1f)) * _e2832.v)));
        } else {
            phi_4396_ = vec3<f32>(0f, 0f, 0f);
        }
        let _e3661 = phi_4396_;
        if (_e108.shift < arrayLength((&past.member))) {
        } else {
            return;
        }
        past.member[(0u + _e108.shift)] = vec4<f32>(_e3661.x, _e3661.y, _e3661.z, 1f);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_instanced_alpha_motion_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
