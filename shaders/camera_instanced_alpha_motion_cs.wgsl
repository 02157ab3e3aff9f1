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
                let _e313 = phi_925_;
                if (_e165.direction.x < 0f) {
                    phi_932_ = (-1f / _e313);
                } else {
                    phi_932_ = (1f / _e313);
                }
                let _e318 = phi_932_;
                if (abs(_e165.direction.y) < _e307) {
                    phi_940_ = _e307;
                } else {
                    phi_940_ = abs(_e165.direction.y);
                }
                let _e324 = phi_940_;
                if (_e165.direction.y < 0f) {
                    phi_947_ = (-1f / _e324);
                } else {
                    phi_947_ = (1f / _e324);
                }
                let _e329 = phi_947_;
                if (abs(_e165.direction.z) < _e307) {
                    phi_955_ = _e307;
                } else {
                    phi_955_ = abs(_e165.direction.z);
                }
                let _e335 = phi_955_;
                if (_e165.direction.z < 0f) {
                    phi_962_ = (-1f / _e335);
                } else {
                    phi_962_ = (1f / _e335);
                }
                let _e340 = phi_962_;
                let _e348 = abs((bitcast<f32>(_e243) - _e165.origin.x));
                let _e349 = abs((bitcast<f32>(_e247) - _e165.origin.y));
                let _e350 = abs((bitcast<f32>(_e251) - _e165.origin.z));
                let _e358 = abs(((bitcast<f32>(_e255) + (bitcast<f32>((((_e267 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e165.origin.x));
                let _e359 = abs(((bitcast<f32>(_e259) + (bitcast<f32>((((_e267 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e165.origin.y));
                let _e360 = abs(((bitcast<f32>(_e263) + (bitcast<f32>((((_e267 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e165.origin.z));
                if (_e348 > _e358) {
                    phi_987_ = _e348;
                } else {
                    phi_987_ = _e358;
                }
                let _e363 = phi_987_;
                if (_e349 > _e359) {
                    phi_992_ = _e349;
                } else {
                    phi_992_ = _e359;
                }
                let _e366 = phi_992_;
                if (_e350 > _e360) {
                    phi_997_ = _e350;
                } else {
                    phi_997_ = _e360;
                }
                let _e369 = phi_997_;
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
                    phi_1019_ = 0u;
                } else {
                    phi_1019_ = 1u;
                }
                let _e389 = phi_1019_;
                if (_e329 < 0f) {
                    phi_1024_ = 0u;
                } else {
                    phi_1024_ = 2u;
                }
                let _e392 = phi_1024_;
                if (_e340 < 0f) {
                    phi_1029_ = 0u;
                } else {
                    phi_1029_ = 4u;
                }
                let _e395 = phi_1029_;
                let _e397 = ((_e389 | _e392) | _e395);
                let _e398 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e114, 2147483648u);
                local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e398.first[0], _e398.first[1], _e398.first[2], _e398.first[3], _e398.first[4], _e398.first[5], _e398.first[6], _e398.first[7], _e398.first[8], _e398.first[9], _e398.first[10], _e398.first[11], _e398.first[12], _e398.first[13], _e398.first[14], _e398.first[15], _e398.first[16], _e398.first[17], _e398.first[18], _e398.first[19], _e398.first[20], _e398.first[21], _e398.first[22], _e398.first[23], _e398.first[24], _e398.first[25], _e398.first[26], _e398.first[27], _e398.first[28], _e398.first[29], _e398.first[30], _e398.first[31]), array<u32, 32>(_e398.mask[0], _e398.mask[1], _e398.mask[2], _e398.mask[3], _e398.mask[4], _e398.mask[5], _e398.mask[6], _e398.mask[7], _e398.mask[8], _e398.mask[9], _e398.mask[10], _e398.mask[11], _e398.mask[12], _e398.mask[13], _e398.mask[14], _e398.mask[15], _e398.mask[16], _e398.mask[17], _e398.mask[18], _e398.mask[19], _e398.mask[20], _e398.mask[21], _e398.mask[22], _e398.mask[23], _e398.mask[24], _e398.mask[25], _e398.mask[26], _e398.mask[27], _e398.mask[28], _e398.mask[29], _e398.mask[30], _e398.mask[31]), _e398.len, _e398.group, _e398.group_mask);
                let _e472 = local_2.group_mask;
                if ((_e472 & 4278190080u) == 0u) {
                    let _e476 = local_2.len;
                    if (_e476 == 0u) {
                        phi_1143_ = false;
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
                        phi_1143_ = true;
                    }
                    let _e499 = phi_1143_;
                    phi_1144_ = _e499;
                } else {
                    phi_1144_ = true;
                }
                let _e501 = phi_1144_;
                if _e501 {
                    let _e503 = local_2.group_mask;
                    let _e509 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e503)), 32u, (_e503 == 0u)));
                    let _e513 = local_2.group_mask;
                    let _e527 = local_2.group_mask;
                    local_2.group_mask = (_e527 & ~((1u << bitcast<u32>((_e509 & 31u)))));
                    let _e530 = local_2.group;
                    phi_1175_ = (_e530 + countOneBits(((_e513 & ~((4294967295u << bitcast<u32>((((_e509 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1175_ = 4294967295u;
                }
                let _e533 = phi_1175_;
                phi_1177_ = _e533;
                phi_1180_ = _e167;
                loop {
                    let _e535 = phi_1177_;
                    let _e537 = phi_1180_;
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
                            phi_1265_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e625.unnamed, lt_mask_LightPlace(_e625.unnamed_1.word, _e602.y));
                        } else {
                            let _e641 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e602.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e647 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e641.unnamed.word, _e602.y), _e641.unnamed_1);
                            let _e653 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e647.unnamed, lt_mask_LightPlace(_e602.z, _e647.unnamed_1.shift));
                            phi_1265_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e653.unnamed, lt_mask_LightPlace(_e653.unnamed_1.word, _e602.w));
                        }
                        let _e661 = phi_1265_;
                        let _e671 = nodes.member[(0u + _e535)].y;
                        if (_e329 < 0f) {
                            let _e682 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e671.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e688 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e682.unnamed.word, _e671.w), _e682.unnamed_1);
                            let _e694 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e688.unnamed, lt_mask_LightPlace(_e671.x, _e688.unnamed_1.shift));
                            phi_1292_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e694.unnamed, lt_mask_LightPlace(_e694.unnamed_1.word, _e671.y));
                        } else {
                            let _e710 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e671.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e716 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e710.unnamed.word, _e671.y), _e710.unnamed_1);
                            let _e722 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e716.unnamed, lt_mask_LightPlace(_e671.z, _e716.unnamed_1.shift));
                            phi_1292_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e722.unnamed, lt_mask_LightPlace(_e722.unnamed_1.word, _e671.w));
                        }
                        let _e730 = phi_1292_;
                        let _e740 = nodes.member[(0u + _e535)].z;
                        if (_e340 < 0f) {
                            let _e751 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e740.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e757 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e751.unnamed.word, _e740.w), _e751.unnamed_1);
                            let _e763 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e757.unnamed, lt_mask_LightPlace(_e740.x, _e757.unnamed_1.shift));
                            phi_1319_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e763.unnamed, lt_mask_LightPlace(_e763.unnamed_1.word, _e740.y));
                        } else {
                            let _e779 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e740.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e785 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e779.unnamed.word, _e740.y), _e779.unnamed_1);
                            let _e791 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e785.unnamed, lt_mask_LightPlace(_e740.z, _e785.unnamed_1.shift));
                            phi_1319_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e791.unnamed, lt_mask_LightPlace(_e791.unnamed_1.word, _e740.w));
                        }
                        let _e799 = phi_1319_;
                        phi_1325_ = 0u;
                        phi_1328_ = 0u;
                        loop {
                            let _e809 = phi_1325_;
                            let _e811 = phi_1328_;
                            local_3 = _e811;
                            local_4 = _e811;
                            local_5 = _e811;
                            let _e812 = (_e809 < 8u);
                            if _e812 {
                                let _e814 = (_e809 >> bitcast<u32>(2i));
                                let _e815 = (_e809 & 3u);
                                if (_e814 == 0u) {
                                    phi_1342_ = _e661.unnamed.word;
                                } else {
                                    phi_1342_ = _e661.unnamed.shift;
                                }
                                let _e818 = phi_1342_;
                                if (_e814 == 0u) {
                                    phi_1352_ = _e730.unnamed.word;
                                } else {
                                    phi_1352_ = _e730.unnamed.shift;
                                }
                                let _e827 = phi_1352_;
                                if (_e814 == 0u) {
                                    phi_1362_ = _e799.unnamed.word;
                                } else {
                                    phi_1362_ = _e799.unnamed.shift;
                                }
                                let _e836 = phi_1362_;
                                let _e849 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e818 >> bitcast<u32>(((_e815 * 8u) & 31u))) & 255u)) * _e571) + (_e592 - _e377)), ((f32(((_e827 >> bitcast<u32>(((_e815 * 8u) & 31u))) & 255u)) * _e572) + (_e593 - _e378)));
                                let _e850 = core_intrinsics_maximum_number_nsz_f32_(_e849, ((f32(((_e836 >> bitcast<u32>(((_e815 * 8u) & 31u))) & 255u)) * _e573) + (_e594 - _e379)));
                                if (_e814 == 0u) {
                                    phi_1380_ = _e661.unnamed_1.word;
                                } else {
                                    phi_1380_ = _e661.unnamed_1.shift;
                                }
                                let _e853 = phi_1380_;
                                if (_e814 == 0u) {
                                    phi_1390_ = _e730.unnamed_1.word;
                                } else {
                                    phi_1390_ = _e730.unnamed_1.shift;
                                }
                                let _e862 = phi_1390_;
                                if (_e814 == 0u) {
                                    phi_1400_ = _e799.unnamed_1.word;
                                } else {
                                    phi_1400_ = _e799.unnamed_1.shift;
                                }
                                let _e871 = phi_1400_;
                                let _e884 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e853 >> bitcast<u32>(((_e815 * 8u) & 31u))) & 255u)) * _e571) + (_e592 + _e377)), ((f32(((_e862 >> bitcast<u32>(((_e815 * 8u) & 31u))) & 255u)) * _e572) + (_e593 + _e378)));
                                let _e885 = core_intrinsics_minimum_number_nsz_f32_(_e884, ((f32(((_e871 >> bitcast<u32>(((_e815 * 8u) & 31u))) & 255u)) * _e573) + (_e594 + _e379)));
                                if (_e850 <= _e885) {
                                    if (_e850 <= _e537.t) {
                                        if (_e885 >= _e165.tmin) {
                                            if (_e814 == 0u) {
                                                let _e892 = nodes.member[(0u + _e535)].links[2u];
                                                phi_1436_ = _e892;
                                            } else {
                                                let _e895 = nodes.member[(0u + _e535)].links[3u];
                                                phi_1436_ = _e895;
                                            }
                                            let _e897 = phi_1436_;
                                            let _e902 = ((_e897 >> bitcast<u32>(((_e815 * 8u) & 31u))) & 255u);
                                            let _e903 = (_e902 & 31u);
                                            if (_e903 >= 24u) {
                                                phi_1449_ = (24u + ((_e903 - 24u) ^ _e397));
                                            } else {
                                                phi_1449_ = _e903;
                                            }
                                            let _e909 = phi_1449_;
                                            phi_1454_ = (_e811 | ((_e902 >> bitcast<u32>(5i)) << bitcast<u32>((_e909 & 31u))));
                                        } else {
                                            phi_1454_ = _e811;
                                        }
                                        let _e917 = phi_1454_;
                                        phi_1455_ = _e917;
                                    } else {
                                        phi_1455_ = _e811;
                                    }
                                    let _e919 = phi_1455_;
                                    phi_1456_ = _e919;
                                } else {
                                    phi_1456_ = _e811;
                                }
                                let _e921 = phi_1456_;
                                phi_1326_ = (_e809 + 1u);
                                phi_1329_ = _e921;
                            } else {
                                phi_1326_ = u32();
                                phi_1329_ = u32();
                            }
                            let _e924 = phi_1326_;
                            let _e926 = phi_1329_;
                            continue;
                            continuing {
                                phi_1325_ = _e924;
                                phi_1328_ = _e926;
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
                        phi_1514_ = (_e975 & 16777215u);
                        phi_1517_ = _e537;
                        loop {
                            let _e978 = phi_1514_;
                            let _e980 = phi_1517_;
                            local_11 = _e980;
                            if (_e978 == 0u) {
                                phi_1515_ = u32();
                                phi_1518_ = lt_bvh_Hit();
                                phi_3397_ = false;
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
                                    phi_1572_ = _e1007;
                                } else {
                                    phi_1572_ = _e1019;
                                }
                                let _e1024 = phi_1572_;
                                if (_e1008 < _e1020) {
                                    phi_1577_ = _e1008;
                                } else {
                                    phi_1577_ = _e1020;
                                }
                                let _e1027 = phi_1577_;
                                if (_e1009 < _e1021) {
                                    phi_1582_ = _e1009;
                                } else {
                                    phi_1582_ = _e1021;
                                }
                                let _e1030 = phi_1582_;
                                if (_e1007 > _e1019) {
                                    phi_1590_ = _e1007;
                                } else {
                                    phi_1590_ = _e1019;
                                }
                                let _e1036 = phi_1590_;
                                if (_e1008 > _e1020) {
                                    phi_1595_ = _e1008;
                                } else {
                                    phi_1595_ = _e1020;
                                }
                                let _e1039 = phi_1595_;
                                if (_e1009 > _e1021) {
                                    phi_1600_ = _e1009;
                                } else {
                                    phi_1600_ = _e1021;
                                }
                                let _e1042 = phi_1600_;
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
                                                                        phi_1757_ = bool();
                                                                        phi_1758_ = true;
                                                                    } else {
                                                                        let _e1163 = (_e1154 > 0f);
                                                                        if _e1163 {
                                                                            phi_1756_ = bool();
                                                                        } else {
                                                                            phi_1756_ = (_e1155 > 0f);
                                                                        }
                                                                        let _e1166 = phi_1756_;
                                                                        phi_1757_ = _e1166;
                                                                        phi_1758_ = _e1163;
                                                                    }
                                                                    let _e1168 = phi_1757_;
                                                                    let _e1170 = phi_1758_;
                                                                    if _e1170 {
                                                                        phi_1762_ = true;
                                                                    } else {
                                                                        phi_1762_ = _e1168;
                                                                    }
                                                                    let _e1172 = phi_1762_;
                                                                    phi_1763_ = _e1172;
                                                                    phi_1764_ = false;
                                                                } else {
                                                                    phi_1763_ = bool();
                                                                    phi_1764_ = true;
                                                                }
                                                                let _e1174 = phi_1763_;
                                                                let _e1176 = phi_1764_;
                                                                phi_1765_ = _e1174;
                                                                phi_1766_ = false;
                                                                phi_1767_ = _e1176;
                                                            } else {
                                                                phi_1765_ = bool();
                                                                phi_1766_ = true;
                                                                phi_1767_ = false;
                                                            }
                                                            let _e1178 = phi_1765_;
                                                            let _e1180 = phi_1766_;
                                                            let _e1182 = phi_1767_;
                                                            phi_1768_ = _e1178;
                                                            phi_1769_ = _e1180;
                                                            phi_1770_ = _e1182;
                                                        } else {
                                                            phi_1768_ = bool();
                                                            phi_1769_ = true;
                                                            phi_1770_ = false;
                                                        }
                                                        let _e1184 = phi_1768_;
                                                        let _e1186 = phi_1769_;
                                                        let _e1188 = phi_1770_;
                                                        phi_1771_ = _e1184;
                                                        phi_1772_ = _e1186;
                                                        phi_1773_ = _e1188;
                                                    } else {
                                                        phi_1771_ = bool();
                                                        phi_1772_ = true;
                                                        phi_1773_ = false;
                                                    }
                                                    let _e1190 = phi_1771_;
                                                    let _e1192 = phi_1772_;
                                                    let _e1194 = phi_1773_;
                                                    phi_1774_ = _e1190;
                                                    phi_1775_ = _e1192;
                                                    phi_1776_ = _e1194;
                                                } else {
                                                    phi_1774_ = bool();
                                                    phi_1775_ = true;
                                                    phi_1776_ = false;
                                                }
                                                let _e1196 = phi_1774_;
                                                let _e1198 = phi_1775_;
                                                let _e1200 = phi_1776_;
                                                phi_1777_ = _e1196;
                                                phi_1778_ = _e1198;
                                                phi_1779_ = _e1200;
                                            } else {
                                                phi_1777_ = bool();
                                                phi_1778_ = true;
                                                phi_1779_ = false;
                                            }
                                            let _e1202 = phi_1777_;
                                            let _e1204 = phi_1778_;
                                            let _e1206 = phi_1779_;
                                            if _e1204 {
                                                phi_1783_ = true;
                                            } else {
                                                phi_1783_ = _e1206;
                                            }
                                            let _e1208 = phi_1783_;
                                            if _e1208 {
                                                phi_1787_ = false;
                                            } else {
                                                phi_1787_ = _e1202;
                                            }
                                            let _e1210 = phi_1787_;
                                            if _e1210 {
                                                let _e1211 = (_e1147 >= _e78);
                                                if _e1211 {
                                                    phi_3387_ = lt_bvh_Hit();
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
                                                        phi_1857_ = _e1277;
                                                    } else {
                                                        phi_1857_ = abs(_e1116);
                                                    }
                                                    let _e1282 = phi_1857_;
                                                    if (_e1116 < 0f) {
                                                        phi_1864_ = (-1f / _e1282);
                                                    } else {
                                                        phi_1864_ = (1f / _e1282);
                                                    }
                                                    let _e1287 = phi_1864_;
                                                    if (abs(_e1129) < _e1277) {
                                                        phi_1871_ = _e1277;
                                                    } else {
                                                        phi_1871_ = abs(_e1129);
                                                    }
                                                    let _e1292 = phi_1871_;
                                                    if (_e1129 < 0f) {
                                                        phi_1878_ = (-1f / _e1292);
                                                    } else {
                                                        phi_1878_ = (1f / _e1292);
                                                    }
                                                    let _e1297 = phi_1878_;
                                                    if (abs(_e1142) < _e1277) {
                                                        phi_1885_ = _e1277;
                                                    } else {
                                                        phi_1885_ = abs(_e1142);
                                                    }
                                                    let _e1302 = phi_1885_;
                                                    if (_e1142 < 0f) {
                                                        phi_1892_ = (-1f / _e1302);
                                                    } else {
                                                        phi_1892_ = (1f / _e1302);
                                                    }
                                                    let _e1307 = phi_1892_;
                                                    let _e1311 = abs((bitcast<f32>(_e1217) - _e1072));
                                                    let _e1312 = abs((bitcast<f32>(_e1221) - _e1085));
                                                    let _e1313 = abs((bitcast<f32>(_e1225) - _e1098));
                                                    let _e1317 = abs(((bitcast<f32>(_e1229) + (bitcast<f32>((((_e1241 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1072));
                                                    let _e1318 = abs(((bitcast<f32>(_e1233) + (bitcast<f32>((((_e1241 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1085));
                                                    let _e1319 = abs(((bitcast<f32>(_e1237) + (bitcast<f32>((((_e1241 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1098));
                                                    if (_e1311 > _e1317) {
                                                        phi_1909_ = _e1311;
                                                    } else {
                                                        phi_1909_ = _e1317;
                                                    }
                                                    let _e1322 = phi_1909_;
                                                    if (_e1312 > _e1318) {
                                                        phi_1914_ = _e1312;
                                                    } else {
                                                        phi_1914_ = _e1318;
                                                    }
                                                    let _e1325 = phi_1914_;
                                                    if (_e1313 > _e1319) {
                                                        phi_1919_ = _e1313;
                                                    } else {
                                                        phi_1919_ = _e1319;
                                                    }
                                                    let _e1328 = phi_1919_;
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
                                                            phi_1947_ = false;
                                                        } else {
                                                            phi_1947_ = true;
                                                        }
                                                        let _e1351 = phi_1947_;
                                                        phi_1948_ = _e1351;
                                                    } else {
                                                        phi_1948_ = true;
                                                    }
                                                    let _e1353 = phi_1948_;
                                                    if _e1353 {
                                                        if (_e1346 >= _e1347) {
                                                            phi_1956_ = 1u;
                                                        } else {
                                                            phi_1956_ = 2u;
                                                        }
                                                        let _e1356 = phi_1956_;
                                                        phi_1957_ = _e1356;
                                                    } else {
                                                        phi_1957_ = 0u;
                                                    }
                                                    let _e1358 = phi_1957_;
                                                    if (_e1358 == 0u) {
                                                        phi_1969_ = vec3<f32>(_e1129, _e1142, _e1116);
                                                    } else {
                                                        if (_e1358 == 1u) {
                                                            phi_1968_ = vec3<f32>(_e1142, _e1116, _e1129);
                                                        } else {
                                                            phi_1968_ = vec3<f32>(_e1116, _e1129, _e1142);
                                                        }
                                                        let _e1364 = phi_1968_;
                                                        phi_1969_ = _e1364;
                                                    }
                                                    let _e1366 = phi_1969_;
                                                    let _e1369 = (_e1366.x / _e1366.z);
                                                    let _e1372 = (_e1366.y / _e1366.z);
                                                    if (_e1287 < 0f) {
                                                        phi_1982_ = 0u;
                                                    } else {
                                                        phi_1982_ = 1u;
                                                    }
                                                    let _e1377 = phi_1982_;
                                                    if (_e1297 < 0f) {
                                                        phi_1987_ = 0u;
                                                    } else {
                                                        phi_1987_ = 2u;
                                                    }
                                                    let _e1380 = phi_1987_;
                                                    if (_e1307 < 0f) {
                                                        phi_1992_ = 0u;
                                                    } else {
                                                        phi_1992_ = 4u;
                                                    }
                                                    let _e1383 = phi_1992_;
                                                    let _e1385 = ((_e1377 | _e1380) | _e1383);
                                                    let _e1386 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1147, 2147483648u);
                                                    local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e1386.first[0], _e1386.first[1], _e1386.first[2], _e1386.first[3], _e1386.first[4], _e1386.first[5], _e1386.first[6], _e1386.first[7], _e1386.first[8], _e1386.first[9], _e1386.first[10], _e1386.first[11], _e1386.first[12], _e1386.first[13], _e1386.first[14], _e1386.first[15], _e1386.first[16], _e1386.first[17], _e1386.first[18], _e1386.first[19], _e1386.first[20], _e1386.first[21], _e1386.first[22], _e1386.first[23], _e1386.first[24], _e1386.first[25], _e1386.first[26], _e1386.first[27], _e1386.first[28], _e1386.first[29], _e1386.first[30], _e1386.first[31]), array<u32, 32>(_e1386.mask[0], _e1386.mask[1], _e1386.mask[2], _e1386.mask[3], _e1386.mask[4], _e1386.mask[5], _e1386.mask[6], _e1386.mask[7], _e1386.mask[8], _e1386.mask[9], _e1386.mask[10], _e1386.mask[11], _e1386.mask[12], _e1386.mask[13], _e1386.mask[14], _e1386.mask[15], _e1386.mask[16], _e1386.mask[17], _e1386.mask[18], _e1386.mask[19], _e1386.mask[20], _e1386.mask[21], _e1386.mask[22], _e1386.mask[23], _e1386.mask[24], _e1386.mask[25], _e1386.mask[26], _e1386.mask[27], _e1386.mask[28], _e1386.mask[29], _e1386.mask[30], _e1386.mask[31]), _e1386.len, _e1386.group, _e1386.group_mask);
                                                    let _e1460 = local_1.group_mask;
                                                    if ((_e1460 & 4278190080u) == 0u) {
                                                        let _e1464 = local_1.len;
                                                        if (_e1464 == 0u) {
                                                            phi_2106_ = false;
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
                                                            phi_2106_ = true;
                                                        }
                                                        let _e1487 = phi_2106_;
                                                        phi_2107_ = _e1487;
                                                    } else {
                                                        phi_2107_ = true;
                                                    }
                                                    let _e1489 = phi_2107_;
                                                    if _e1489 {
                                                        let _e1491 = local_1.group_mask;
                                                        let _e1497 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1491)), 32u, (_e1491 == 0u)));
                                                        let _e1501 = local_1.group_mask;
                                                        let _e1515 = local_1.group_mask;
                                                        local_1.group_mask = (_e1515 & ~((1u << bitcast<u32>((_e1497 & 31u)))));
                                                        let _e1518 = local_1.group;
                                                        phi_2138_ = (_e1518 + countOneBits(((_e1501 & ~((4294967295u << bitcast<u32>((((_e1497 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_2138_ = 4294967295u;
                                                    }
                                                    let _e1521 = phi_2138_;
                                                    phi_2140_ = _e980;
                                                    phi_2143_ = _e1521;
                                                    loop {
                                                        let _e1523 = phi_2140_;
                                                        let _e1525 = phi_2143_;
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
                                                                phi_2224_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1609.unnamed, lt_mask_LightPlace(_e1609.unnamed_1.word, _e1586.y));
                                                            } else {
                                                                let _e1625 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1586.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1631 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1625.unnamed.word, _e1586.y), _e1625.unnamed_1);
                                                                let _e1637 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1631.unnamed, lt_mask_LightPlace(_e1586.z, _e1631.unnamed_1.shift));
                                                                phi_2224_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1637.unnamed, lt_mask_LightPlace(_e1637.unnamed_1.word, _e1586.w));
                                                            }
                                                            let _e1645 = phi_2224_;
                                                            let _e1655 = nodes.member[(0u + _e1525)].y;
                                                            if (_e1297 < 0f) {
                                                                let _e1666 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1655.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1672 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1666.unnamed.word, _e1655.w), _e1666.unnamed_1);
                                                                let _e1678 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1672.unnamed, lt_mask_LightPlace(_e1655.x, _e1672.unnamed_1.shift));
                                                                phi_2251_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1678.unnamed, lt_mask_LightPlace(_e1678.unnamed_1.word, _e1655.y));
                                                            } else {
                                                                let _e1694 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1655.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1700 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1694.unnamed.word, _e1655.y), _e1694.unnamed_1);
                                                                let _e1706 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1700.unnamed, lt_mask_LightPlace(_e1655.z, _e1700.unnamed_1.shift));
                                                                phi_2251_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1706.unnamed, lt_mask_LightPlace(_e1706.unnamed_1.word, _e1655.w));
                                                            }
                                                            let _e1714 = phi_2251_;
                                                            let _e1724 = nodes.member[(0u + _e1525)].z;
                                                            if (_e1307 < 0f) {
                                                                let _e1735 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1724.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1741 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1735.unnamed.word, _e1724.w), _e1735.unnamed_1);
                                                                let _e1747 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1741.unnamed, lt_mask_LightPlace(_e1724.x, _e1741.unnamed_1.shift));
                                                                phi_2278_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1747.unnamed, lt_mask_LightPlace(_e1747.unnamed_1.word, _e1724.y));
                                                            } else {
                                                                let _e1763 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1724.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1769 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1763.unnamed.word, _e1724.y), _e1763.unnamed_1);
                                                                let _e1775 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1769.unnamed, lt_mask_LightPlace(_e1724.z, _e1769.unnamed_1.shift));
                                                                phi_2278_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1775.unnamed, lt_mask_LightPlace(_e1775.unnamed_1.word, _e1724.w));
                                                            }
                                                            let _e1783 = phi_2278_;
                                                            phi_2284_ = 0u;
                                                            phi_2287_ = 0u;
                                                            loop {
                                                                let _e1793 = phi_2284_;
                                                                let _e1795 = phi_2287_;
                                                                local_6 = _e1795;
                                                                local_7 = _e1795;
                                                                local_8 = _e1795;
                                                                let _e1796 = (_e1793 < 8u);
                                                                if _e1796 {
                                                                    let _e1798 = (_e1793 >> bitcast<u32>(2i));
                                                                    let _e1799 = (_e1793 & 3u);
                                                                    if (_e1798 == 0u) {
                                                                        phi_2301_ = _e1645.unnamed.word;
                                                                    } else {
                                                                        phi_2301_ = _e1645.unnamed.shift;
                                                                    }
                                                                    let _e1802 = phi_2301_;
                                                                    if (_e1798 == 0u) {
                                                                        phi_2311_ = _e1714.unnamed.word;
                                                                    } else {
                                                                        phi_2311_ = _e1714.unnamed.shift;
                                                                    }
                                                                    let _e1811 = phi_2311_;
                                                                    if (_e1798 == 0u) {
                                                                        phi_2321_ = _e1783.unnamed.word;
                                                                    } else {
                                                                        phi_2321_ = _e1783.unnamed.shift;
                                                                    }
                                                                    let _e1820 = phi_2321_;
                                                                    let _e1833 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1802 >> bitcast<u32>(((_e1799 * 8u) & 31u))) & 255u)) * _e1558) + (_e1576 - _e1335)), ((f32(((_e1811 >> bitcast<u32>(((_e1799 * 8u) & 31u))) & 255u)) * _e1559) + (_e1577 - _e1336)));
                                                                    let _e1834 = core_intrinsics_maximum_number_nsz_f32_(_e1833, ((f32(((_e1820 >> bitcast<u32>(((_e1799 * 8u) & 31u))) & 255u)) * _e1560) + (_e1578 - _e1337)));
                                                                    if (_e1798 == 0u) {
                                                                        phi_2339_ = _e1645.unnamed_1.word;
                                                                    } else {
                                                                        phi_2339_ = _e1645.unnamed_1.shift;
                                                                    }
                                                                    let _e1837 = phi_2339_;
                                                                    if (_e1798 == 0u) {
                                                                        phi_2349_ = _e1714.unnamed_1.word;
                                                                    } else {
                                                                        phi_2349_ = _e1714.unnamed_1.shift;
                                                                    }
                                                                    let _e1846 = phi_2349_;
                                                                    if (_e1798 == 0u) {
                                                                        phi_2359_ = _e1783.unnamed_1.word;
                                                                    } else {
                                                                        phi_2359_ = _e1783.unnamed_1.shift;
                                                                    }
                                                                    let _e1855 = phi_2359_;
                                                                    let _e1868 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1837 >> bitcast<u32>(((_e1799 * 8u) & 31u))) & 255u)) * _e1558) + (_e1576 + _e1335)), ((f32(((_e1846 >> bitcast<u32>(((_e1799 * 8u) & 31u))) & 255u)) * _e1559) + (_e1577 + _e1336)));
                                                                    let _e1869 = core_intrinsics_minimum_number_nsz_f32_(_e1868, ((f32(((_e1855 >> bitcast<u32>(((_e1799 * 8u) & 31u))) & 255u)) * _e1560) + (_e1578 + _e1337)));
                                                                    if (_e1834 <= _e1869) {
                                                                        if (_e1834 <= _e1523.t) {
                                                                            if (_e1869 >= _e165.tmin) {
                                                                                if (_e1798 == 0u) {
                                                                                    let _e1876 = nodes.member[(0u + _e1525)].links[2u];
                                                                                    phi_2395_ = _e1876;
                                                                                } else {
                                                                                    let _e1879 = nodes.member[(0u + _e1525)].links[3u];
                                                                                    phi_2395_ = _e1879;
                                                                                }
                                                                                let _e1881 = phi_2395_;
                                                                                let _e1886 = ((_e1881 >> bitcast<u32>(((_e1799 * 8u) & 31u))) & 255u);
                                                                                let _e1887 = (_e1886 & 31u);
                                                                                if (_e1887 >= 24u) {
                                                                                    phi_2408_ = (24u + ((_e1887 - 24u) ^ _e1385));
                                                                                } else {
                                                                                    phi_2408_ = _e1887;
                                                                                }
                                                                                let _e1893 = phi_2408_;
                                                                                phi_2413_ = (_e1795 | ((_e1886 >> bitcast<u32>(5i)) << bitcast<u32>((_e1893 & 31u))));
                                                                            } else {
                                                                                phi_2413_ = _e1795;
                                                                            }
                                                                            let _e1901 = phi_2413_;
                                                                            phi_2414_ = _e1901;
                                                                        } else {
                                                                            phi_2414_ = _e1795;
                                                                        }
                                                                        let _e1903 = phi_2414_;
                                                                        phi_2415_ = _e1903;
                                                                    } else {
                                                                        phi_2415_ = _e1795;
                                                                    }
                                                                    let _e1905 = phi_2415_;
                                                                    phi_2285_ = (_e1793 + 1u);
                                                                    phi_2288_ = _e1905;
                                                                } else {
                                                                    phi_2285_ = u32();
                                                                    phi_2288_ = u32();
                                                                }
                                                                let _e1908 = phi_2285_;
                                                                let _e1910 = phi_2288_;
                                                                continue;
                                                                continuing {
                                                                    phi_2284_ = _e1908;
                                                                    phi_2287_ = _e1910;
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
                                                            phi_2473_ = _e1523;
                                                            phi_2476_ = (_e1959 & 16777215u);
                                                            loop {
                                                                let _e1962 = phi_2473_;
                                                                let _e1964 = phi_2476_;
                                                                local_9 = _e1962;
                                                                if (_e1964 == 0u) {
                                                                    phi_2474_ = lt_bvh_Hit();
                                                                    phi_2477_ = u32();
                                                                    phi_3315_ = false;
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
                                                                        phi_2521_ = vec3<f32>(_e1984, _e1986, _e1982);
                                                                    } else {
                                                                        if (_e1358 == 1u) {
                                                                            phi_2520_ = vec3<f32>(_e1986, _e1982, _e1984);
                                                                        } else {
                                                                            phi_2520_ = (_e1980 - vec3<f32>(_e1072, _e1085, _e1098));
                                                                        }
                                                                        let _e1994 = phi_2520_;
                                                                        phi_2521_ = _e1994;
                                                                    }
                                                                    let _e1996 = phi_2521_;
                                                                    let _e2000 = (_e1996.x - (_e1369 * _e1996.z));
                                                                    let _e2004 = (_e1996.y - (_e1372 * _e1996.z));
                                                                    let _e2006 = triangles.member[(0u + _e1973)].v1_;
                                                                    let _e2008 = (_e2006.x - _e1072);
                                                                    let _e2010 = (_e2006.y - _e1085);
                                                                    let _e2012 = (_e2006.z - _e1098);
                                                                    if (_e1358 == 0u) {
                                                                        phi_2551_ = vec3<f32>(_e2010, _e2012, _e2008);
                                                                    } else {
                                                                        if (_e1358 == 1u) {
                                                                            phi_2550_ = vec3<f32>(_e2012, _e2008, _e2010);
                                                                        } else {
                                                                            phi_2550_ = (_e2006 - vec3<f32>(_e1072, _e1085, _e1098));
                                                                        }
                                                                        let _e2020 = phi_2550_;
                                                                        phi_2551_ = _e2020;
                                                                    }
                                                                    let _e2022 = phi_2551_;
                                                                    let _e2026 = (_e2022.x - (_e1369 * _e2022.z));
                                                                    let _e2030 = (_e2022.y - (_e1372 * _e2022.z));
                                                                    let _e2032 = triangles.member[(0u + _e1973)].v2_;
                                                                    let _e2034 = (_e2032.x - _e1072);
                                                                    let _e2036 = (_e2032.y - _e1085);
                                                                    let _e2038 = (_e2032.z - _e1098);
                                                                    if (_e1358 == 0u) {
                                                                        phi_2581_ = vec3<f32>(_e2036, _e2038, _e2034);
                                                                    } else {
                                                                        if (_e1358 == 1u) {
                                                                            phi_2580_ = vec3<f32>(_e2038, _e2034, _e2036);
                                                                        } else {
                                                                            phi_2580_ = (_e2032 - vec3<f32>(_e1072, _e1085, _e1098));
                                                                        }
                                                                        let _e2046 = phi_2580_;
                                                                        phi_2581_ = _e2046;
                                                                    }
                                                                    let _e2048 = phi_2581_;
                                                                    let _e2052 = (_e2048.x - (_e1369 * _e2048.z));
                                                                    let _e2056 = (_e2048.y - (_e1372 * _e2048.z));
                                                                    if (_e2026 < _e2052) {
                                                                        phi_2600_ = true;
                                                                    } else {
                                                                        if (_e2026 == _e2052) {
                                                                            phi_2599_ = (_e2030 < _e2056);
                                                                        } else {
                                                                            phi_2599_ = false;
                                                                        }
                                                                        let _e2061 = phi_2599_;
                                                                        phi_2600_ = _e2061;
                                                                    }
                                                                    let _e2063 = phi_2600_;
                                                                    if _e2063 {
                                                                        phi_2604_ = _e2056;
                                                                        phi_2605_ = _e2052;
                                                                        phi_2606_ = _e2030;
                                                                        phi_2607_ = _e2026;
                                                                    } else {
                                                                        phi_2604_ = _e2030;
                                                                        phi_2605_ = _e2026;
                                                                        phi_2606_ = _e2056;
                                                                        phi_2607_ = _e2052;
                                                                    }
                                                                    let _e2065 = phi_2604_;
                                                                    let _e2067 = phi_2605_;
                                                                    let _e2069 = phi_2606_;
                                                                    let _e2071 = phi_2607_;
                                                                    let _e2074 = ((_e2071 * _e2065) - (_e2069 * _e2067));
                                                                    if _e2063 {
                                                                        phi_2615_ = -(_e2074);
                                                                    } else {
                                                                        phi_2615_ = _e2074;
                                                                    }
                                                                    let _e2077 = phi_2615_;
                                                                    if (_e2052 < _e2000) {
                                                                        phi_2626_ = true;
                                                                    } else {
                                                                        if (_e2052 == _e2000) {
                                                                            phi_2625_ = (_e2056 < _e2004);
                                                                        } else {
                                                                            phi_2625_ = false;
                                                                        }
                                                                        let _e2082 = phi_2625_;
                                                                        phi_2626_ = _e2082;
                                                                    }
                                                                    let _e2084 = phi_2626_;
                                                                    if _e2084 {
                                                                        phi_2630_ = _e2004;
                                                                        phi_2631_ = _e2000;
                                                                        phi_2632_ = _e2056;
                                                                        phi_2633_ = _e2052;
                                                                    } else {
                                                                        phi_2630_ = _e2056;
                                                                        phi_2631_ = _e2052;
                                                                        phi_2632_ = _e2004;
                                                                        phi_2633_ = _e2000;
                                                                    }
                                                                    let _e2086 = phi_2630_;
                                                                    let _e2088 = phi_2631_;
                                                                    let _e2090 = phi_2632_;
                                                                    let _e2092 = phi_2633_;
                                                                    let _e2095 = ((_e2092 * _e2086) - (_e2090 * _e2088));
                                                                    if _e2084 {
                                                                        phi_2641_ = -(_e2095);
                                                                    } else {
                                                                        phi_2641_ = _e2095;
                                                                    }
                                                                    let _e2098 = phi_2641_;
                                                                    if (_e2000 < _e2026) {
                                                                        phi_2652_ = true;
                                                                    } else {
                                                                        if (_e2000 == _e2026) {
                                                                            phi_2651_ = (_e2004 < _e2030);
                                                                        } else {
                                                                            phi_2651_ = false;
                                                                        }
                                                                        let _e2103 = phi_2651_;
                                                                        phi_2652_ = _e2103;
                                                                    }
                                                                    let _e2105 = phi_2652_;
                                                                    if _e2105 {
                                                                        phi_2656_ = _e2030;
                                                                        phi_2657_ = _e2026;
                                                                        phi_2658_ = _e2004;
                                                                        phi_2659_ = _e2000;
                                                                    } else {
                                                                        phi_2656_ = _e2004;
                                                                        phi_2657_ = _e2000;
                                                                        phi_2658_ = _e2030;
                                                                        phi_2659_ = _e2026;
                                                                    }
                                                                    let _e2107 = phi_2656_;
                                                                    let _e2109 = phi_2657_;
                                                                    let _e2111 = phi_2658_;
                                                                    let _e2113 = phi_2659_;
                                                                    let _e2116 = ((_e2113 * _e2107) - (_e2111 * _e2109));
                                                                    if _e2105 {
                                                                        phi_2667_ = -(_e2116);
                                                                    } else {
                                                                        phi_2667_ = _e2116;
                                                                    }
                                                                    let _e2119 = phi_2667_;
                                                                    if (_e2077 >= 0f) {
                                                                        if (_e2098 >= 0f) {
                                                                            if (_e2119 >= 0f) {
                                                                                phi_2682_ = ((_e2077 + _e2098) + _e2119);
                                                                                phi_2683_ = false;
                                                                            } else {
                                                                                phi_2682_ = f32();
                                                                                phi_2683_ = true;
                                                                            }
                                                                            let _e2126 = phi_2682_;
                                                                            let _e2128 = phi_2683_;
                                                                            phi_2684_ = _e2126;
                                                                            phi_2685_ = _e2128;
                                                                        } else {
                                                                            phi_2684_ = f32();
                                                                            phi_2685_ = true;
                                                                        }
                                                                        let _e2130 = phi_2684_;
                                                                        let _e2132 = phi_2685_;
                                                                        phi_2686_ = _e2130;
                                                                        phi_2687_ = _e2132;
                                                                    } else {
                                                                        phi_2686_ = f32();
                                                                        phi_2687_ = true;
                                                                    }
                                                                    let _e2134 = phi_2686_;
                                                                    let _e2136 = phi_2687_;
                                                                    if _e2136 {
                                                                        if (_e2077 <= 0f) {
                                                                            if (_e2098 <= 0f) {
                                                                                let _e2139 = (_e2119 <= 0f);
                                                                                if _e2139 {
                                                                                }
                                                                                phi_2705_ = ((_e2077 + _e2098) + _e2119);
                                                                                phi_2706_ = false;
                                                                                phi_2707_ = _e2139;
                                                                            } else {
                                                                                phi_2705_ = f32();
                                                                                phi_2706_ = true;
                                                                                phi_2707_ = false;
                                                                            }
                                                                            let _e2143 = phi_2705_;
                                                                            let _e2145 = phi_2706_;
                                                                            let _e2147 = phi_2707_;
                                                                            phi_2708_ = _e2143;
                                                                            phi_2709_ = _e2145;
                                                                            phi_2710_ = _e2147;
                                                                        } else {
                                                                            phi_2708_ = f32();
                                                                            phi_2709_ = true;
                                                                            phi_2710_ = false;
                                                                        }
                                                                        let _e2149 = phi_2708_;
                                                                        let _e2151 = phi_2709_;
                                                                        let _e2153 = phi_2710_;
                                                                        if _e2151 {
                                                                            phi_2714_ = false;
                                                                        } else {
                                                                            phi_2714_ = _e2153;
                                                                        }
                                                                        let _e2155 = phi_2714_;
                                                                        phi_2715_ = _e2149;
                                                                        phi_2716_ = _e2155;
                                                                    } else {
                                                                        phi_2715_ = _e2134;
                                                                        phi_2716_ = true;
                                                                    }
                                                                    let _e2157 = phi_2715_;
                                                                    let _e2159 = phi_2716_;
                                                                    if _e2159 {
                                                                        let _e2160 = (_e2157 == 0f);
                                                                        if _e2160 {
                                                                            phi_3032_ = lt_bvh_triangle_Intersection();
                                                                            phi_3033_ = false;
                                                                        } else {
                                                                            let _e2162 = triangles.member[(0u + _e1973)].v0_;
                                                                            let _e2164 = (_e2162.x - _e1072);
                                                                            let _e2166 = (_e2162.y - _e1085);
                                                                            let _e2168 = (_e2162.z - _e1098);
                                                                            if (_e1358 == 0u) {
                                                                                phi_2745_ = vec3<f32>(_e2166, _e2168, _e2164);
                                                                            } else {
                                                                                if (_e1358 == 1u) {
                                                                                    phi_2744_ = vec3<f32>(_e2168, _e2164, _e2166);
                                                                                } else {
                                                                                    phi_2744_ = (_e2162 - vec3<f32>(_e1072, _e1085, _e1098));
                                                                                }
                                                                                let _e2176 = phi_2744_;
                                                                                phi_2745_ = _e2176;
                                                                            }
                                                                            let _e2178 = phi_2745_;
                                                                            let _e2180 = triangles.member[(0u + _e1973)].v1_;
                                                                            let _e2182 = triangles.member[(0u + _e1973)].v0_;
                                                                            let _e2185 = (_e2180.x - _e2182.x);
                                                                            let _e2188 = (_e2180.y - _e2182.y);
                                                                            let _e2191 = (_e2180.z - _e2182.z);
                                                                            if (_e1358 == 0u) {
                                                                                phi_2771_ = vec3<f32>(_e2188, _e2191, _e2185);
                                                                            } else {
                                                                                if (_e1358 == 1u) {
                                                                                    phi_2770_ = vec3<f32>(_e2191, _e2185, _e2188);
                                                                                } else {
                                                                                    phi_2770_ = (_e2180 - _e2182);
                                                                                }
                                                                                let _e2198 = phi_2770_;
                                                                                phi_2771_ = _e2198;
                                                                            }
                                                                            let _e2200 = phi_2771_;
                                                                            let _e2202 = triangles.member[(0u + _e1973)].v2_;
                                                                            let _e2204 = triangles.member[(0u + _e1973)].v0_;
                                                                            let _e2207 = (_e2202.x - _e2204.x);
                                                                            let _e2210 = (_e2202.y - _e2204.y);
                                                                            let _e2213 = (_e2202.z - _e2204.z);
                                                                            if (_e1358 == 0u) {
                                                                                phi_2797_ = vec3<f32>(_e2210, _e2213, _e2207);
                                                                            } else {
                                                                                if (_e1358 == 1u) {
                                                                                    phi_2796_ = vec3<f32>(_e2213, _e2207, _e2210);
                                                                                } else {
                                                                                    phi_2796_ = (_e2202 - _e2204);
                                                                                }
                                                                                let _e2220 = phi_2796_;
                                                                                phi_2797_ = _e2220;
                                                                            }
                                                                            let _e2222 = phi_2797_;
                                                                            let _e2229 = ((_e2200.y * _e2222.z) - (_e2200.z * _e2222.y));
                                                                            let _e2236 = ((_e2200.z * _e2222.x) - (_e2200.x * _e2222.z));
                                                                            let _e2243 = ((_e2200.x * _e2222.y) - (_e2200.y * _e2222.x));
                                                                            let _e2257 = (((1f / _e1366.z) * (((_e2229 * _e2178.x) + (_e2236 * _e2178.y)) + (_e2243 * _e2178.z))) / (((_e2229 * _e1369) + (_e2236 * _e1372)) + _e2243));
                                                                            if (_e2257 > _e165.tmin) {
                                                                                if (_e2257 < _e165.tmax) {
                                                                                    let _e2261 = triangles.member[(0u + _e1973)].v0_;
                                                                                    let _e2263 = triangles.member[(0u + _e1973)].v1_;
                                                                                    if (_e2261.x < _e2263.x) {
                                                                                        phi_2853_ = _e2261.x;
                                                                                    } else {
                                                                                        phi_2853_ = _e2263.x;
                                                                                    }
                                                                                    let _e2270 = phi_2853_;
                                                                                    if (_e2261.y < _e2263.y) {
                                                                                        phi_2862_ = _e2261.y;
                                                                                    } else {
                                                                                        phi_2862_ = _e2263.y;
                                                                                    }
                                                                                    let _e2277 = phi_2862_;
                                                                                    if (_e2261.z < _e2263.z) {
                                                                                        phi_2871_ = _e2261.z;
                                                                                    } else {
                                                                                        phi_2871_ = _e2263.z;
                                                                                    }
                                                                                    let _e2284 = phi_2871_;
                                                                                    let _e2286 = triangles.member[(0u + _e1973)].v2_;
                                                                                    if (_e2270 < _e2286.x) {
                                                                                        phi_2880_ = _e2270;
                                                                                    } else {
                                                                                        phi_2880_ = _e2286.x;
                                                                                    }
                                                                                    let _e2291 = phi_2880_;
                                                                                    if (_e2277 < _e2286.y) {
                                                                                        phi_2887_ = _e2277;
                                                                                    } else {
                                                                                        phi_2887_ = _e2286.y;
                                                                                    }
                                                                                    let _e2296 = phi_2887_;
                                                                                    if (_e2284 < _e2286.z) {
                                                                                        phi_2894_ = _e2284;
                                                                                    } else {
                                                                                        phi_2894_ = _e2286.z;
                                                                                    }
                                                                                    let _e2301 = phi_2894_;
                                                                                    let _e2303 = triangles.member[(0u + _e1973)].v0_;
                                                                                    let _e2305 = triangles.member[(0u + _e1973)].v1_;
                                                                                    if (_e2303.x > _e2305.x) {
                                                                                        phi_2907_ = _e2303.x;
                                                                                    } else {
                                                                                        phi_2907_ = _e2305.x;
                                                                                    }
                                                                                    let _e2312 = phi_2907_;
                                                                                    if (_e2303.y > _e2305.y) {
                                                                                        phi_2916_ = _e2303.y;
                                                                                    } else {
                                                                                        phi_2916_ = _e2305.y;
                                                                                    }
                                                                                    let _e2319 = phi_2916_;
                                                                                    if (_e2303.z > _e2305.z) {
                                                                                        phi_2925_ = _e2303.z;
                                                                                    } else {
                                                                                        phi_2925_ = _e2305.z;
                                                                                    }
                                                                                    let _e2326 = phi_2925_;
                                                                                    let _e2328 = triangles.member[(0u + _e1973)].v2_;
                                                                                    if (_e2312 > _e2328.x) {
                                                                                        phi_2934_ = _e2312;
                                                                                    } else {
                                                                                        phi_2934_ = _e2328.x;
                                                                                    }
                                                                                    let _e2333 = phi_2934_;
                                                                                    if (_e2319 > _e2328.y) {
                                                                                        phi_2941_ = _e2319;
                                                                                    } else {
                                                                                        phi_2941_ = _e2328.y;
                                                                                    }
                                                                                    let _e2338 = phi_2941_;
                                                                                    if (_e2326 > _e2328.z) {
                                                                                        phi_2948_ = _e2326;
                                                                                    } else {
                                                                                        phi_2948_ = _e2328.z;
                                                                                    }
                                                                                    let _e2343 = phi_2948_;
                                                                                    let _e2347 = ((_e2291 - _e1072) * _e1287);
                                                                                    let _e2348 = ((_e2296 - _e1085) * _e1297);
                                                                                    let _e2349 = ((_e2301 - _e1098) * _e1307);
                                                                                    let _e2353 = ((_e2333 - _e1072) * _e1287);
                                                                                    let _e2354 = ((_e2338 - _e1085) * _e1297);
                                                                                    let _e2355 = ((_e2343 - _e1098) * _e1307);
                                                                                    if (_e2347 < _e2353) {
                                                                                        phi_2965_ = _e2347;
                                                                                    } else {
                                                                                        phi_2965_ = _e2353;
                                                                                    }
                                                                                    let _e2358 = phi_2965_;
                                                                                    if (_e2348 < _e2354) {
                                                                                        phi_2970_ = _e2348;
                                                                                    } else {
                                                                                        phi_2970_ = _e2354;
                                                                                    }
                                                                                    let _e2361 = phi_2970_;
                                                                                    if (_e2349 < _e2355) {
                                                                                        phi_2975_ = _e2349;
                                                                                    } else {
                                                                                        phi_2975_ = _e2355;
                                                                                    }
                                                                                    let _e2364 = phi_2975_;
                                                                                    if (_e2347 > _e2353) {
                                                                                        phi_2983_ = _e2347;
                                                                                    } else {
                                                                                        phi_2983_ = _e2353;
                                                                                    }
                                                                                    let _e2370 = phi_2983_;
                                                                                    if (_e2348 > _e2354) {
                                                                                        phi_2988_ = _e2348;
                                                                                    } else {
                                                                                        phi_2988_ = _e2354;
                                                                                    }
                                                                                    let _e2373 = phi_2988_;
                                                                                    if (_e2349 > _e2355) {
                                                                                        phi_2993_ = _e2349;
                                                                                    } else {
                                                                                        phi_2993_ = _e2355;
                                                                                    }
                                                                                    let _e2376 = phi_2993_;
                                                                                    let _e2380 = core_intrinsics_maximum_number_nsz_f32_((_e2358 - _e1342), (_e2361 - _e1343));
                                                                                    let _e2381 = core_intrinsics_maximum_number_nsz_f32_(_e2380, (_e2364 - _e1344));
                                                                                    let _e2382 = core_intrinsics_minimum_number_nsz_f32_((_e2370 + _e1342), (_e2373 + _e1343));
                                                                                    let _e2383 = core_intrinsics_minimum_number_nsz_f32_(_e2382, (_e2376 + _e1344));
                                                                                    if (_e2381 > _e1047) {
                                                                                        phi_3005_ = _e2381;
                                                                                    } else {
                                                                                        phi_3005_ = _e1047;
                                                                                    }
                                                                                    let _e2386 = phi_3005_;
                                                                                    if (_e2383 < _e1049) {
                                                                                        phi_3010_ = _e2383;
                                                                                    } else {
                                                                                        phi_3010_ = _e1049;
                                                                                    }
                                                                                    let _e2389 = phi_3010_;
                                                                                    if (_e2257 < _e2386) {
                                                                                        phi_3015_ = _e2386;
                                                                                    } else {
                                                                                        phi_3015_ = _e2257;
                                                                                    }
                                                                                    let _e2392 = phi_3015_;
                                                                                    if (_e2392 > _e2389) {
                                                                                        phi_3020_ = _e2389;
                                                                                    } else {
                                                                                        phi_3020_ = _e2392;
                                                                                    }
                                                                                    let _e2395 = phi_3020_;
                                                                                    phi_3025_ = lt_bvh_triangle_Intersection(_e2395, (_e2098 / _e2157), (_e2119 / _e2157), (_e2386 <= _e2389));
                                                                                    phi_3026_ = false;
                                                                                } else {
                                                                                    phi_3025_ = lt_bvh_triangle_Intersection();
                                                                                    phi_3026_ = true;
                                                                                }
                                                                                let _e2401 = phi_3025_;
                                                                                let _e2403 = phi_3026_;
                                                                                phi_3027_ = _e2401;
                                                                                phi_3028_ = _e2403;
                                                                            } else {
                                                                                phi_3027_ = lt_bvh_triangle_Intersection();
                                                                                phi_3028_ = true;
                                                                            }
                                                                            let _e2405 = phi_3027_;
                                                                            let _e2407 = phi_3028_;
                                                                            if _e2407 {
                                                                            }
                                                                            phi_3032_ = _e2405;
                                                                            phi_3033_ = _e2407;
                                                                        }
                                                                        let _e2409 = phi_3032_;
                                                                        let _e2411 = phi_3033_;
                                                                        phi_3034_ = _e2409;
                                                                        phi_3035_ = _e2160;
                                                                        phi_3036_ = _e2411;
                                                                    } else {
                                                                        phi_3034_ = lt_bvh_triangle_Intersection();
                                                                        phi_3035_ = true;
                                                                        phi_3036_ = false;
                                                                    }
                                                                    let _e2413 = phi_3034_;
                                                                    let _e2415 = phi_3035_;
                                                                    let _e2417 = phi_3036_;
                                                                    if _e2415 {
                                                                        phi_3040_ = true;
                                                                    } else {
                                                                        phi_3040_ = _e2417;
                                                                    }
                                                                    let _e2419 = phi_3040_;
                                                                    if _e2419 {
                                                                        phi_3044_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_3044_ = _e2413;
                                                                    }
                                                                    let _e2421 = phi_3044_;
                                                                    if _e2421.is_hit {
                                                                        if (_e2421.t > _e165.tmin) {
                                                                            if (_e2421.t < _e1962.t) {
                                                                                phi_3092_ = true;
                                                                            } else {
                                                                                if (_e2421.t == _e1962.t) {
                                                                                    if (_e1962.triangle != 4294967295u) {
                                                                                        if (_e1973 < _e1962.triangle) {
                                                                                            phi_3083_ = true;
                                                                                        } else {
                                                                                            if (_e1973 == _e1962.triangle) {
                                                                                                phi_3082_ = (_e988 < _e1962.instance);
                                                                                            } else {
                                                                                                phi_3082_ = false;
                                                                                            }
                                                                                            let _e2439 = phi_3082_;
                                                                                            phi_3083_ = _e2439;
                                                                                        }
                                                                                        let _e2441 = phi_3083_;
                                                                                        phi_3084_ = _e2441;
                                                                                        phi_3085_ = false;
                                                                                    } else {
                                                                                        phi_3084_ = bool();
                                                                                        phi_3085_ = true;
                                                                                    }
                                                                                    let _e2443 = phi_3084_;
                                                                                    let _e2445 = phi_3085_;
                                                                                    phi_3086_ = _e2443;
                                                                                    phi_3087_ = _e2445;
                                                                                } else {
                                                                                    phi_3086_ = bool();
                                                                                    phi_3087_ = true;
                                                                                }
                                                                                let _e2447 = phi_3086_;
                                                                                let _e2449 = phi_3087_;
                                                                                if _e2449 {
                                                                                    phi_3091_ = false;
                                                                                } else {
                                                                                    phi_3091_ = _e2447;
                                                                                }
                                                                                let _e2451 = phi_3091_;
                                                                                phi_3092_ = _e2451;
                                                                            }
                                                                            let _e2453 = phi_3092_;
                                                                            if _e2453 {
                                                                                let _e2455 = triangles.member[(0u + _e1973)].i0_;
                                                                                if ((_e2455 & 2147483648u) == 0u) {
                                                                                    phi_3303_ = true;
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
                                                                                            phi_3298_ = true;
                                                                                        } else {
                                                                                            let _e2520 = (_e2488.base_color.w * ((((f32((_e2482[0].color >> bitcast<u32>(24i))) * _e2493) + (f32((_e2482[1].color >> bitcast<u32>(24i))) * _e2421.u)) + (f32((_e2482[2].color >> bitcast<u32>(24i))) * _e2421.v)) * (1f / 255f)));
                                                                                            if (_e2488.alpha_size == 0u) {
                                                                                                phi_3295_ = _e2520;
                                                                                            } else {
                                                                                                local.offset = _e2488.alpha_offset;
                                                                                                local.size = _e2488.alpha_size;
                                                                                                local.flags = _e2488.flags;
                                                                                                let _e2551 = _lt_shaders_texture_TextureView_quad((&local), (((_e2482[0].u * _e2493) + (_e2482[1].u * _e2421.u)) + (_e2482[2].u * _e2421.v)), (((_e2482[0].v * _e2493) + (_e2482[1].v * _e2421.u)) + (_e2482[2].v * _e2421.v)));
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
                                                                                                phi_3295_ = (_e2520 * (((((f32(((_e2559 >> bitcast<u32>((((_e2551.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2551.weights.x) + ((f32(((_e2579 >> bitcast<u32>((((_e2551.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2551.weights.y)) + ((f32(((_e2600 >> bitcast<u32>((((_e2551.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2551.weights.z)) + ((f32(((_e2621 >> bitcast<u32>((((_e2551.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2551.weights.w)));
                                                                                            }
                                                                                            let _e2637 = phi_3295_;
                                                                                            phi_3298_ = (_e2637 >= _e2488.cutoff);
                                                                                        }
                                                                                        let _e2641 = phi_3298_;
                                                                                        phi_3299_ = _e2641;
                                                                                    } else {
                                                                                        phi_3299_ = false;
                                                                                    }
                                                                                    let _e2643 = phi_3299_;
                                                                                    if _e2643 {
                                                                                    }
                                                                                    phi_3303_ = _e2643;
                                                                                }
                                                                                let _e2645 = phi_3303_;
                                                                                if _e2645 {
                                                                                    phi_3311_ = lt_bvh_Hit(_e2421.t, _e2421.u, _e2421.v, _e1973, _e988);
                                                                                } else {
                                                                                    phi_3311_ = _e1962;
                                                                                }
                                                                                let _e2651 = phi_3311_;
                                                                                phi_3312_ = _e2651;
                                                                            } else {
                                                                                phi_3312_ = _e1962;
                                                                            }
                                                                            let _e2653 = phi_3312_;
                                                                            phi_3313_ = _e2653;
                                                                        } else {
                                                                            phi_3313_ = _e1962;
                                                                        }
                                                                        let _e2655 = phi_3313_;
                                                                        phi_3314_ = _e2655;
                                                                    } else {
                                                                        phi_3314_ = _e1962;
                                                                    }
                                                                    let _e2657 = phi_3314_;
                                                                    phi_2474_ = _e2657;
                                                                    phi_2477_ = (_e1964 & (_e1964 - 1u));
                                                                    phi_3315_ = true;
                                                                }
                                                                let _e2659 = phi_2474_;
                                                                let _e2661 = phi_2477_;
                                                                let _e2663 = phi_3315_;
                                                                continue;
                                                                continuing {
                                                                    phi_2473_ = _e2659;
                                                                    phi_2476_ = _e2661;
                                                                    break if !(_e2663);
                                                                }
                                                            }
                                                            let _e2666 = local_1.group_mask;
                                                            if ((_e2666 & 4278190080u) == 0u) {
                                                                let _e2670 = local_1.len;
                                                                if (_e2670 == 0u) {
                                                                    phi_3354_ = false;
                                                                } else {
                                                                    let _e2674 = local_1.len;
                                                                    local_1.len = (_e2674 - 1u);
                                                                    let _e2677 = local_1.len;
                                                                    if (_e2677 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2682 = local_1.first[(0u + _e2677)];
                                                                    local_1.group = _e2682;
                                                                    let _e2685 = local_1.len;
                                                                    if (_e2685 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2690 = local_1.mask[(0u + _e2685)];
                                                                    local_1.group_mask = _e2690;
                                                                    phi_3354_ = true;
                                                                }
                                                                let _e2693 = phi_3354_;
                                                                phi_3355_ = _e2693;
                                                            } else {
                                                                phi_3355_ = true;
                                                            }
                                                            let _e2695 = phi_3355_;
                                                            if _e2695 {
                                                                let _e2697 = local_1.group_mask;
                                                                let _e2703 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2697)), 32u, (_e2697 == 0u)));
                                                                let _e2707 = local_1.group_mask;
                                                                let _e2721 = local_1.group_mask;
                                                                local_1.group_mask = (_e2721 & ~((1u << bitcast<u32>((_e2703 & 31u)))));
                                                                let _e2724 = local_1.group;
                                                                phi_3386_ = (_e2724 + countOneBits(((_e2707 & ~((4294967295u << bitcast<u32>((((_e2703 - 24u) ^ _e1385) & 31u))))) & 255u)));
                                                            } else {
                                                                phi_3386_ = 4294967295u;
                                                            }
                                                            let _e2727 = phi_3386_;
                                                            let _e3909 = local_9;
                                                            phi_2141_ = _e3909;
                                                            phi_2144_ = _e2727;
                                                        } else {
                                                            phi_2141_ = lt_bvh_Hit();
                                                            phi_2144_ = u32();
                                                        }
                                                        let _e2729 = phi_2141_;
                                                        let _e2731 = phi_2144_;
                                                        continue;
                                                        continuing {
                                                            phi_2140_ = _e2729;
                                                            phi_2143_ = _e2731;
                                                            break if !(_e1526);
                                                        }
                                                    }
                                                    let _e3913 = local_10;
                                                    phi_3387_ = _e3913;
                                                }
                                                let _e2734 = phi_3387_;
                                                phi_3388_ = _e2734;
                                                phi_3389_ = _e1211;
                                            } else {
                                                phi_3388_ = lt_bvh_Hit();
                                                phi_3389_ = true;
                                            }
                                            let _e2736 = phi_3388_;
                                            let _e2738 = phi_3389_;
                                            if _e2738 {
                                                phi_3393_ = _e980;
                                            } else {
                                                phi_3393_ = _e2736;
                                            }
                                            let _e2740 = phi_3393_;
                                            phi_3394_ = _e2740;
                                        } else {
                                            phi_3394_ = _e980;
                                        }
                                        let _e2742 = phi_3394_;
                                        phi_3395_ = _e2742;
                                    } else {
                                        phi_3395_ = _e980;
                                    }
                                    let _e2744 = phi_3395_;
                                    phi_3396_ = _e2744;
                                } else {
                                    phi_3396_ = _e980;
                                }
                                let _e2746 = phi_3396_;
                                phi_1515_ = (_e978 & (_e978 - 1u));
                                phi_1518_ = _e2746;
                                phi_3397_ = true;
                            }
                            let _e2748 = phi_1515_;
                            let _e2750 = phi_1518_;
                            let _e2752 = phi_3397_;
                            continue;
                            continuing {
                                phi_1514_ = _e2748;
                                phi_1517_ = _e2750;
                                break if !(_e2752);
                            }
                        }
                        let _e2755 = local_2.group_mask;
                        if ((_e2755 & 4278190080u) == 0u) {
                            let _e2759 = local_2.len;
                            if (_e2759 == 0u) {
                                phi_3436_ = false;
                            } else {
                                let _e2763 = local_2.len;
                                local_2.len = (_e2763 - 1u);
                                let _e2766 = local_2.len;
                                if (_e2766 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2771 = local_2.first[(0u + _e2766)];
                                local_2.group = _e2771;
                                let _e2774 = local_2.len;
                                if (_e2774 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2779 = local_2.mask[(0u + _e2774)];
                                local_2.group_mask = _e2779;
                                phi_3436_ = true;
                            }
                            let _e2782 = phi_3436_;
                            phi_3437_ = _e2782;
                        } else {
                            phi_3437_ = true;
                        }
                        let _e2784 = phi_3437_;
                        if _e2784 {
                            let _e2786 = local_2.group_mask;
                            let _e2792 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2786)), 32u, (_e2786 == 0u)));
                            let _e2796 = local_2.group_mask;
                            let _e2810 = local_2.group_mask;
                            local_2.group_mask = (_e2810 & ~((1u << bitcast<u32>((_e2792 & 31u)))));
                            let _e2813 = local_2.group;
                            phi_3468_ = (_e2813 + countOneBits(((_e2796 & ~((4294967295u << bitcast<u32>((((_e2792 - 24u) ^ _e397) & 31u))))) & 255u)));
                        } else {
                            phi_3468_ = 4294967295u;
                        }
                        let _e2816 = phi_3468_;
                        phi_1178_ = _e2816;
                        let _e3929 = local_11;
                        phi_1181_ = _e3929;
                    } else {
                        phi_1178_ = u32();
                        phi_1181_ = lt_bvh_Hit();
                    }
                    let _e2818 = phi_1178_;
                    let _e2820 = phi_1181_;
                    continue;
                    continuing {
                        phi_1177_ = _e2818;
                        phi_1180_ = _e2820;
                        break if !(_e538);
                    }
                }
                let _e3932 = local_12;
                phi_3469_ = _e3932;
            }
            let _e2823 = phi_3469_;
            phi_3470_ = _e2823;
            phi_3471_ = _e237;
        } else {
            phi_3470_ = lt_bvh_Hit();
            phi_3471_ = true;
        }
        let _e2825 = phi_3470_;
        let _e2827 = phi_3471_;
        if _e2827 {
            phi_3475_ = _e167;
        } else {
            phi_3475_ = _e2825;
        }
        let _e2829 = phi_3475_;
        if (_e2829.triangle != 4294967295u) {
            let _e2835 = ((1f - _e2829.u) - _e2829.v);
            if (_e2829.triangle < _e81) {
            } else {
                return;
            }
            let _e2841 = triangles.member[(0u + _e2829.triangle)];
            if (_e2829.instance < _e93) {
            } else {
                return;
            }
            let _e2852 = instances.member[(0u + _e2829.instance)].object_to_world[0u];
            let _e2863 = ((((_e2852.x * _e2841.v0_.x) + (_e2852.y * _e2841.v0_.y)) + (_e2852.z * _e2841.v0_.z)) + (_e2852.w * 1f));
            let _e2865 = instances.member[(0u + _e2829.instance)].object_to_world[1u];
            let _e2876 = ((((_e2865.x * _e2841.v0_.x) + (_e2865.y * _e2841.v0_.y)) + (_e2865.z * _e2841.v0_.z)) + (_e2865.w * 1f));
            let _e2878 = instances.member[(0u + _e2829.instance)].object_to_world[2u];
            let _e2889 = ((((_e2878.x * _e2841.v0_.x) + (_e2878.y * _e2841.v0_.y)) + (_e2878.z * _e2841.v0_.z)) + (_e2878.w * 1f));
            let _e2896 = instances.member[(0u + _e2829.instance)].object_to_world[0u];
            let _e2907 = ((((_e2896.x * _e2841.v1_.x) + (_e2896.y * _e2841.v1_.y)) + (_e2896.z * _e2841.v1_.z)) + (_e2896.w * 1f));
            let _e2909 = instances.member[(0u + _e2829.instance)].object_to_world[1u];
            let _e2920 = ((((_e2909.x * _e2841.v1_.x) + (_e2909.y * _e2841.v1_.y)) + (_e2909.z * _e2841.v1_.z)) + (_e2909.w * 1f));
            let _e2922 = instances.member[(0u + _e2829.instance)].object_to_world[2u];
            let _e2933 = ((((_e2922.x * _e2841.v1_.x) + (_e2922.y * _e2841.v1_.y)) + (_e2922.z * _e2841.v1_.z)) + (_e2922.w * 1f));
            let _e2940 = instances.member[(0u + _e2829.instance)].object_to_world[0u];
            let _e2951 = ((((_e2940.x * _e2841.v2_.x) + (_e2940.y * _e2841.v2_.y)) + (_e2940.z * _e2841.v2_.z)) + (_e2940.w * 1f));
            let _e2953 = instances.member[(0u + _e2829.instance)].object_to_world[1u];
            let _e2964 = ((((_e2953.x * _e2841.v2_.x) + (_e2953.y * _e2841.v2_.y)) + (_e2953.z * _e2841.v2_.z)) + (_e2953.w * 1f));
            let _e2966 = instances.member[(0u + _e2829.instance)].object_to_world[2u];
            let _e2977 = ((((_e2966.x * _e2841.v2_.x) + (_e2966.y * _e2841.v2_.y)) + (_e2966.z * _e2841.v2_.z)) + (_e2966.w * 1f));
            let _e2990 = (((_e2863 * _e2835) + (_e2907 * _e2829.u)) + (_e2951 * _e2829.v));
            let _e2991 = (((_e2876 * _e2835) + (_e2920 * _e2829.u)) + (_e2964 * _e2829.v));
            let _e2992 = (((_e2889 * _e2835) + (_e2933 * _e2829.u)) + (_e2977 * _e2829.v));
            let _e2994 = abs(_e2863);
            let _e2995 = abs(_e2876);
            let _e2996 = abs(_e2889);
            let _e2997 = abs(_e2907);
            let _e2998 = abs(_e2920);
            let _e2999 = abs(_e2933);
            if (_e2994 > _e2997) {
                phi_3663_ = _e2994;
            } else {
                phi_3663_ = _e2997;
            }
            let _e3002 = phi_3663_;
            if (_e2995 > _e2998) {
                phi_3668_ = _e2995;
            } else {
                phi_3668_ = _e2998;
            }
            let _e3005 = phi_3668_;
            if (_e2996 > _e2999) {
                phi_3673_ = _e2996;
            } else {
                phi_3673_ = _e2999;
            }
            let _e3008 = phi_3673_;
            let _e3009 = abs(_e2951);
            let _e3010 = abs(_e2964);
            let _e3011 = abs(_e2977);
            if (_e3002 > _e3009) {
                phi_3681_ = _e3002;
            } else {
                phi_3681_ = _e3009;
            }
            let _e3014 = phi_3681_;
            if (_e3005 > _e3010) {
                phi_3686_ = _e3005;
            } else {
                phi_3686_ = _e3010;
            }
            let _e3017 = phi_3686_;
            if (_e3008 > _e3011) {
                phi_3691_ = _e3008;
            } else {
                phi_3691_ = _e3011;
            }
            let _e3020 = phi_3691_;
            let _e3021 = (_e2907 - _e2863);
            let _e3022 = (_e2920 - _e2876);
            let _e3023 = (_e2933 - _e2889);
            let _e3024 = (_e2951 - _e2863);
            let _e3025 = (_e2964 - _e2876);
            let _e3026 = (_e2977 - _e2889);
            let _e3030 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3022), abs(_e3023));
            let _e3031 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3021), _e3030);
            let _e3032 = (_e3021 / _e3031);
            let _e3033 = (_e3022 / _e3031);
            let _e3034 = (_e3023 / _e3031);
            let _e3038 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3025), abs(_e3026));
            let _e3039 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3024), _e3038);
            let _e3040 = (_e3024 / _e3039);
            let _e3041 = (_e3025 / _e3039);
            let _e3042 = (_e3026 / _e3039);
            let _e3045 = ((_e3033 * _e3042) - (_e3041 * _e3034));
            let _e3048 = ((_e3034 * _e3040) - (_e3042 * _e3032));
            let _e3051 = ((_e3032 * _e3041) - (_e3040 * _e3033));
            let _e3053 = p.member.eye;
            let _e3066 = (1f / sqrt((((_e3045 * _e3045) + (_e3048 * _e3048)) + (_e3051 * _e3051))));
            let _e3067 = (_e3045 * _e3066);
            let _e3068 = (_e3048 * _e3066);
            let _e3069 = (_e3051 * _e3066);
            if ((((_e3067 * (_e3053.x - _e2990)) + (_e3068 * (_e3053.y - _e2991))) + (_e3069 * (_e3053.z - _e2992))) < 0f) {
                phi_3755_ = vec3<f32>(-(_e3067), -(_e3068), -(_e3069));
            } else {
                phi_3755_ = vec3<f32>(_e3067, _e3068, _e3069);
            }
            let _e3082 = phi_3755_;
            if (_e2829.triangle < _e81) {
            } else {
                return;
            }
            let _e3087 = triangles.member[(0u + _e2829.triangle)];
            let _e3089 = (_e3087.i0_ & 2147483647u);
            if (_e3089 < _e84) {
            } else {
                return;
            }
            let _e3095 = vertices.member[(0u + _e3089)];
            if (_e3087.i1_ < _e84) {
            } else {
                return;
            }
            let _e3099 = vertices.member[(0u + _e3087.i1_)];
            if (_e3087.i2_ < _e84) {
            } else {
                return;
            }
            let _e3103 = vertices.member[(0u + _e3087.i2_)];
            let _e3104 = array<abi_Vertex, 3>(_e3095, _e3099, _e3103);
            if (_e3104[0].material < _e87) {
            } else {
                return;
            }
            let _e3110 = materials.member[(0u + _e3104[0].material)];
            let _e3127 = (1f / 255f);
            let _e3146 = (1f / 255f);
            let _e3168 = (1f / 255f);
            let _e3181 = _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(vec3<f32>(_e2835, _e2829.u, _e2829.v));
            let _e3183 = ((_e3110.base_color.x * ((((f32((_e3104[0].color & 255u)) * _e3127) * _e2835) + ((f32((_e3104[1].color & 255u)) * _e3146) * _e2829.u)) + ((f32((_e3104[2].color & 255u)) * _e3168) * _e2829.v))) * _e3181.x);
            let _e3185 = ((_e3110.base_color.y * ((((f32(((_e3104[0].color >> bitcast<u32>(8i)) & 255u)) * _e3127) * _e2835) + ((f32(((_e3104[1].color >> bitcast<u32>(8i)) & 255u)) * _e3146) * _e2829.u)) + ((f32(((_e3104[2].color >> bitcast<u32>(8i)) & 255u)) * _e3168) * _e2829.v))) * _e3181.y);
            let _e3187 = ((_e3110.base_color.z * ((((f32(((_e3104[0].color >> bitcast<u32>(16i)) & 255u)) * _e3127) * _e2835) + ((f32(((_e3104[1].color >> bitcast<u32>(16i)) & 255u)) * _e3146) * _e2829.u)) + ((f32(((_e3104[2].color >> bitcast<u32>(16i)) & 255u)) * _e3168) * _e2829.v))) * _e3181.z);
            let _e3188 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e3017, _e3020);
            let _e3189 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e3014, _e3188);
            if ((_e3110.flags & 2u) == 0u) {
                phi_3876_ = 0u;
            } else {
                phi_3876_ = 1u;
            }
            let _e3194 = phi_3876_;
            if (_e3104[0].normal == 2147516416u) {
                phi_4106_ = _e3082;
            } else {
                let _e3207 = (f32((bitcast<i32>((_e3104[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3213 = (f32((bitcast<i32>(_e3104[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3217 = ((1f - abs(_e3207)) - abs(_e3213));
                if (_e3217 < 0f) {
                    phi_3903_ = -(_e3217);
                } else {
                    phi_3903_ = 0f;
                }
                let _e3221 = phi_3903_;
                if (_e3207 < 0f) {
                    phi_3910_ = (_e3207 + _e3221);
                } else {
                    phi_3910_ = (_e3207 - _e3221);
                }
                let _e3226 = phi_3910_;
                if (_e3213 < 0f) {
                    phi_3917_ = (_e3213 + _e3221);
                } else {
                    phi_3917_ = (_e3213 - _e3221);
                }
                let _e3231 = phi_3917_;
                let _e3238 = (1f / sqrt((((_e3226 * _e3226) + (_e3231 * _e3231)) + (_e3217 * _e3217))));
                let _e3254 = (f32((bitcast<i32>((_e3104[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3260 = (f32((bitcast<i32>(_e3104[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3264 = ((1f - abs(_e3254)) - abs(_e3260));
                if (_e3264 < 0f) {
                    phi_3952_ = -(_e3264);
                } else {
                    phi_3952_ = 0f;
                }
                let _e3268 = phi_3952_;
                if (_e3254 < 0f) {
                    phi_3959_ = (_e3254 + _e3268);
                } else {
                    phi_3959_ = (_e3254 - _e3268);
                }
                let _e3273 = phi_3959_;
                if (_e3260 < 0f) {
                    phi_3966_ = (_e3260 + _e3268);
                } else {
                    phi_3966_ = (_e3260 - _e3268);
                }
                let _e3278 = phi_3966_;
                let _e3285 = (1f / sqrt((((_e3273 * _e3273) + (_e3278 * _e3278)) + (_e3264 * _e3264))));
                let _e3304 = (f32((bitcast<i32>((_e3104[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3310 = (f32((bitcast<i32>(_e3104[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3314 = ((1f - abs(_e3304)) - abs(_e3310));
                if (_e3314 < 0f) {
                    phi_4004_ = -(_e3314);
                } else {
                    phi_4004_ = 0f;
                }
                let _e3318 = phi_4004_;
                if (_e3304 < 0f) {
                    phi_4011_ = (_e3304 + _e3318);
                } else {
                    phi_4011_ = (_e3304 - _e3318);
                }
                let _e3323 = phi_4011_;
                if (_e3310 < 0f) {
                    phi_4018_ = (_e3310 + _e3318);
                } else {
                    phi_4018_ = (_e3310 - _e3318);
                }
                let _e3328 = phi_4018_;
                let _e3335 = (1f / sqrt((((_e3323 * _e3323) + (_e3328 * _e3328)) + (_e3314 * _e3314))));
                let _e3342 = ((((_e3226 * _e3238) * _e2835) + ((_e3273 * _e3285) * _e2829.u)) + ((_e3323 * _e3335) * _e2829.v));
                let _e3343 = ((((_e3231 * _e3238) * _e2835) + ((_e3278 * _e3285) * _e2829.u)) + ((_e3328 * _e3335) * _e2829.v));
                let _e3344 = ((((_e3217 * _e3238) * _e2835) + ((_e3264 * _e3285) * _e2829.u)) + ((_e3314 * _e3335) * _e2829.v));
                if (_e2829.instance < _e93) {
                } else {
                    return;
                }
                let _e3351 = instances.member[(0u + _e2829.instance)].world_to_object[0u];
                let _e3360 = instances.member[(0u + _e2829.instance)].world_to_object[1u];
                let _e3372 = instances.member[(0u + _e2829.instance)].world_to_object[2u];
                let _e3379 = (((_e3351.x * _e3342) + (_e3360.x * _e3343)) + (_e3372.x * _e3344));
                let _e3380 = (((_e3351.y * _e3342) + (_e3360.y * _e3343)) + (_e3372.y * _e3344));
                let _e3381 = (((_e3351.z * _e3342) + (_e3360.z * _e3343)) + (_e3372.z * _e3344));
                let _e3387 = sqrt((((_e3379 * _e3379) + (_e3380 * _e3380)) + (_e3381 * _e3381)));
                if (_e3387 > 0f) {
                    let _e3389 = (_e3379 / _e3387);
                    let _e3390 = (_e3380 / _e3387);
                    let _e3391 = (_e3381 / _e3387);
                    if ((((_e3389 * _e3082.x) + (_e3390 * _e3082.y)) + (_e3391 * _e3082.z)) < 0f) {
                        phi_4104_ = vec3<f32>(-(_e3389), -(_e3390), -(_e3391));
                    } else {
                        phi_4104_ = vec3<f32>(_e3389, _e3390, _e3391);
                    }
                    let _e3407 = phi_4104_;
                    phi_4105_ = _e3407;
                } else {
                    phi_4105_ = _e3082;
                }
                let _e3409 = phi_4105_;
                phi_4106_ = _e3409;
            }
            let _e3411 = phi_4106_;
            if (_e3183 > 0f) {
                if (_e3183 < 1f) {
                    phi_4115_ = _e3183;
                } else {
                    phi_4115_ = 1f;
                }
                let _e3415 = phi_4115_;
                phi_4116_ = _e3415;
            } else {
                phi_4116_ = 0f;
            }
            let _e3417 = phi_4116_;
            if (_e3185 > 0f) {
                if (_e3185 < 1f) {
                    phi_4126_ = _e3185;
                } else {
                    phi_4126_ = 1f;
                }
                let _e3422 = phi_4126_;
                phi_4127_ = _e3422;
            } else {
                phi_4127_ = 0f;
            }
            let _e3424 = phi_4127_;
            if (_e3187 > 0f) {
                if (_e3187 < 1f) {
                    phi_4137_ = _e3187;
                } else {
                    phi_4137_ = 1f;
                }
                let _e3429 = phi_4137_;
                phi_4138_ = _e3429;
            } else {
                phi_4138_ = 0f;
            }
            let _e3431 = phi_4138_;
            let _e3434 = ((sqrt(_e3417) * 255f) + 0.5f);
            let _e3443 = ((sqrt(_e3424) * 255f) + 0.5f);
            let _e3455 = ((sqrt(_e3431) * 255f) + 0.5f);
            phi_4173_ = abi_Sample(vec3<f32>(_e2990, _e2991, _e2992), _e3189, _e3082, _e3194, _e3411, ((select(select(u32(_e3434), 0u, (_e3434 < bitcast<f32>(0u))), 4294967295u, (_e3434 > bitcast<f32>(1333788671u))) | (select(select(u32(_e3443), 0u, (_e3443 < bitcast<f32>(0u))), 4294967295u, (_e3443 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e3455), 0u, (_e3455 < bitcast<f32>(0u))), 4294967295u, (_e3455 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_4173_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e3469 = phi_4173_;
        if (_e108.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e108.shift)] = _e3469;
        if (_e2829.triangle != 4294967295u) {
            let _e3478 = ((1f - _e2829.u) - _e2829.v);
            if (_e2829.triangle < _e81) {
            } else {
                return;
            }
            let _e3483 = triangles.member[(0u + _e2829.triangle)];
            let _e3485 = (_e3483.i0_ & 2147483647u);
            if (_e3485 < _e99) {
            } else {
                return;
            }
            let _e3491 = before.member[(0u + _e3485)];
            if (_e3483.i1_ < _e99) {
            } else {
                return;
            }
            let _e3495 = before.member[(0u + _e3483.i1_)];
            if (_e3483.i2_ < _e99) {
            } else {
                return;
            }
            let _e3499 = before.member[(0u + _e3483.i2_)];
            if (_e2829.instance < _e93) {
            } else {
                return;
            }
            let _e3509 = instances.member[(0u + _e2829.instance)].object_to_world[0u];
            let _e3522 = instances.member[(0u + _e2829.instance)].object_to_world[1u];
            let _e3535 = instances.member[(0u + _e2829.instance)].object_to_world[2u];
            if (_e2829.instance < _e93) {
            } else {
                return;
            }
            let _e3559 = instances.member[(0u + _e2829.instance)].object_to_world[0u];
            let _e3572 = instances.member[(0u + _e2829.instance)].object_to_world[1u];
            let _e3585 = instances.member[(0u + _e2829.instance)].object_to_world[2u];
            if (_e2829.instance < _e93) {
            } else {
                return;
            }
            let _e3612 = instances.member[(0u + _e2829.instance)].object_to_world[0u];
            let _e3625 = instances.member[(0u + _e2829.instance)].object_to_world[1u];
            let _e3638 = instances.member[(0u + _e2829.instance)].object_to_world[2u];
            phi_4396_ = vec3<f32>((((((((_e3509.x * _e3491.x) + (_e3509.y * _e3491.y)) + (_e3509.z * _e3491.z)) + (_e3509.w * 1f)) * _e3478) + (((((_e3559.x * _e3495.x) + (_e3559.y * _e3495.y)) + (_e3559.z * _e3495.z)) + (_e3559.w * 1f)) * _e2829.u)) + (((((_e3612.x * _e3499.x) + (_e3612.y * _e3499.y)) + (_e3612.z * _e3499.z)) + (_e3612.w * 1f)) * _e2829.v)), (((((((_e3522.x * _e3491.x) + (_e3522.y * _e3491.y)) + (_e3522.z * _e3491.z)) + (_e3522.w * 1f)) * _e3478) + (((((_e3572.x * _e3495.x) + (_e3572.y * _e3495.y)) + (_e3572.z * _e3495.z)) + (_e3572.w * 1f)) * _e2829.u)) + (((((_e3625.x * _e3499.x) + (_e3625.y * _e3499.y)) + (_e3625.z * _e3499.z)) + (_e3625.w * 1f)) * _e2829.v)), (((((((_e3535.x * _e3491.x) + (_e3535.y * _e3491.y)) + (_e3535.z * _e3491.z)) + (_e3535.w * 1f)) * _e3478) + (((((_e3585.x * _e3495.x) + (_e3585.y * _e3495.y)) + (_e3585.z * _e3495.z)) + (_e3585.w * 1f)) * _e2829.u)) + (((((_e3638.x * _e3499.x) + (_e3638.y * _e3499.y)) + (_e3638.z * _e3499.z)) + (_e3638.w * 1f)) * _e2829.v)));
        } else {
            phi_4396_ = vec3<f32>(0f, 0f, 0f);
        }
        let _e3658 = phi_4396_;
        if (_e108.shift < arrayLength((&past.member))) {
        } else {
            return;
        }
        past.member[(0u + _e108.shift)] = vec4<f32>(_e3658.x, _e3658.y, _e3658.z, 1f);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_instanced_alpha_motion_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
