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

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_mask_LightPlace {
    var phi_225_: lt_mask_LightPlace;
    var phi_226_: bool;
    var phi_227_: lt_mask_LightPlace;
    var phi_228_: bool;
    var phi_233_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_225_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_226_ = false;
        } else {
            phi_225_ = lt_mask_LightPlace();
            phi_226_ = true;
        }
        let _e82 = phi_225_;
        let _e84 = phi_226_;
        phi_227_ = _e82;
        phi_228_ = _e84;
    } else {
        phi_227_ = lt_mask_LightPlace();
        phi_228_ = true;
    }
    let _e86 = phi_227_;
    let _e88 = phi_228_;
    if _e88 {
        phi_233_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_233_ = _e86;
    }
    let _e93 = phi_233_;
    return lt_mask_LightPlace(_e93.word, _e93.shift);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_248_: bool;
    var phi_252_: f32;

    if (param_3 != param_3) {
        phi_248_ = true;
    } else {
        let _e72 = (param_4 >= param_3);
        if _e72 {
        }
        phi_248_ = _e72;
    }
    let _e74 = phi_248_;
    if _e74 {
        phi_252_ = param_4;
    } else {
        phi_252_ = param_3;
    }
    let _e76 = phi_252_;
    return _e76;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_264_: bool;
    var phi_268_: f32;

    if (param_5 != param_5) {
        phi_264_ = true;
    } else {
        let _e72 = (param_6 <= param_5);
        if _e72 {
        }
        phi_264_ = _e72;
    }
    let _e74 = phi_264_;
    if _e74 {
        phi_268_ = param_6;
    } else {
        phi_268_ = param_5;
    }
    let _e76 = phi_268_;
    return _e76;
}

fn _lt_shaders_texture_TextureView_quad(param_7: ptr<function, texture_TextureView>, param_8: f32, param_9: f32) -> texture_TexelQuad {
    var phi_310_: f32;
    var phi_315_: f32;
    var phi_316_: bool;
    var phi_317_: f32;
    var phi_318_: bool;
    var phi_322_: f32;
    var phi_348_: f32;
    var phi_353_: f32;
    var phi_354_: bool;
    var phi_355_: f32;
    var phi_356_: bool;
    var phi_360_: f32;
    var phi_368_: f32;
    var phi_369_: f32;
    var phi_370_: f32;
    var phi_379_: f32;
    var phi_380_: f32;
    var phi_398_: u32;
    var phi_412_: u32;
    var phi_419_: u32;
    var phi_424_: u32;
    var phi_430_: u32;
    var phi_435_: u32;
    var phi_437_: texture_Axis;
    var phi_465_: f32;
    var phi_470_: f32;
    var phi_471_: bool;
    var phi_472_: f32;
    var phi_473_: bool;
    var phi_477_: f32;
    var phi_503_: f32;
    var phi_508_: f32;
    var phi_509_: bool;
    var phi_510_: f32;
    var phi_511_: bool;
    var phi_515_: f32;
    var phi_523_: f32;
    var phi_524_: f32;
    var phi_525_: f32;
    var phi_534_: f32;
    var phi_535_: f32;
    var phi_553_: u32;
    var phi_567_: u32;
    var phi_574_: u32;
    var phi_579_: u32;
    var phi_585_: u32;
    var phi_590_: u32;
    var phi_592_: texture_Axis;

    let _e73 = (*param_7).size;
    let _e74 = (_e73 & 65535u);
    let _e76 = (*param_7).size;
    let _e78 = (_e76 >> bitcast<u32>(16i));
    let _e80 = (*param_7).flags;
    let _e82 = ((_e80 & 4u) != 0u);
    let _e84 = (*param_7).flags;
    let _e87 = ((_e84 >> bitcast<u32>(4u)) & 3u);
    if (_e87 == 0u) {
        if (param_8 > -8388608f) {
            let _e100 = f32(select(0i, select(select(i32(param_8), i32(-2147483648), (param_8 < bitcast<f32>(3472883712u))), 2147483647i, (param_8 > bitcast<f32>(1325400063u))), (param_8 == param_8)));
            if (_e100 > param_8) {
                phi_310_ = 1f;
            } else {
                phi_310_ = 0f;
            }
            let _e103 = phi_310_;
            if (param_8 < 8388608f) {
                phi_315_ = (_e100 - _e103);
                phi_316_ = false;
            } else {
                phi_315_ = f32();
                phi_316_ = true;
            }
            let _e106 = phi_315_;
            let _e108 = phi_316_;
            phi_317_ = _e106;
            phi_318_ = _e108;
        } else {
            phi_317_ = f32();
            phi_318_ = true;
        }
        let _e110 = phi_317_;
        let _e112 = phi_318_;
        if _e112 {
            phi_322_ = param_8;
        } else {
            phi_322_ = _e110;
        }
        let _e114 = phi_322_;
        phi_370_ = (param_8 - _e114);
    } else {
        if (_e87 == 1u) {
            let _e117 = (param_8 * 0.5f);
            if (_e117 > -8388608f) {
                let _e129 = f32(select(0i, select(select(i32(_e117), i32(-2147483648), (_e117 < bitcast<f32>(3472883712u))), 2147483647i, (_e117 > bitcast<f32>(1325400063u))), (_e117 == _e117)));
                if (_e129 > _e117) {
                    phi_348_ = 1f;
                } else {
                    phi_348_ = 0f;
                }
                let _e132 = phi_348_;
                if (_e117 < 8388608f) {
                    phi_353_ = (_e129 - _e132);
                    phi_354_ = false;
                } else {
                    phi_353_ = f32();
                    phi_354_ = true;
                }
                let _e135 = phi_353_;
                let _e137 = phi_354_;
                phi_355_ = _e135;
                phi_356_ = _e137;
            } else {
                phi_355_ = f32();
                phi_356_ = true;
            }
            let _e139 = phi_355_;
            let _e141 = phi_356_;
            if _e141 {
                phi_360_ = _e117;
            } else {
                phi_360_ = _e139;
            }
            let _e143 = phi_360_;
            let _e145 = (param_8 - (2f * _e143));
            if (_e145 > 1f) {
                phi_368_ = (2f - _e145);
            } else {
                phi_368_ = _e145;
            }
            let _e149 = phi_368_;
            phi_369_ = _e149;
        } else {
            phi_369_ = param_8;
        }
        let _e151 = phi_369_;
        phi_370_ = _e151;
    }
    let _e153 = phi_370_;
    if (_e153 > 0f) {
        if (_e153 < 1f) {
            phi_379_ = _e153;
        } else {
            phi_379_ = 1f;
        }
        let _e157 = phi_379_;
        phi_380_ = _e157;
    } else {
        phi_380_ = 0f;
    }
    let _e159 = phi_380_;
    let _e160 = (_e74 - 1u);
    let _e162 = (_e159 * f32(_e74));
    if _e82 {
        let _e169 = select(select(u32(_e162), 0u, (_e162 < bitcast<f32>(0u))), 4294967295u, (_e162 > bitcast<f32>(1333788671u)));
        if (_e160 < _e169) {
            phi_398_ = _e160;
        } else {
            phi_398_ = _e169;
        }
        let _e172 = phi_398_;
        phi_437_ = texture_Axis(_e172, _e172, 0f);
    } else {
        let _e174 = (_e162 + 0.5f);
        let _e181 = select(select(u32(_e174), 0u, (_e174 < bitcast<f32>(0u))), 4294967295u, (_e174 > bitcast<f32>(1333788671u)));
        if (_e74 < _e181) {
            phi_412_ = _e74;
        } else {
            phi_412_ = _e181;
        }
        let _e184 = phi_412_;
        if (_e87 == 0u) {
            phi_419_ = _e160;
        } else {
            phi_419_ = 0u;
        }
        let _e189 = phi_419_;
        if (_e87 == 0u) {
            phi_424_ = 0u;
        } else {
            phi_424_ = _e160;
        }
        let _e192 = phi_424_;
        if (_e184 == 0u) {
            phi_430_ = _e189;
        } else {
            phi_430_ = (_e184 - 1u);
        }
        let _e196 = phi_430_;
        if (_e184 > _e160) {
            phi_435_ = _e192;
        } else {
            phi_435_ = _e184;
        }
        let _e199 = phi_435_;
        phi_437_ = texture_Axis(_e196, _e199, (_e174 - f32(_e184)));
    }
    let _e202 = phi_437_;
    let _e204 = (*param_7).flags;
    let _e207 = ((_e204 >> bitcast<u32>(6u)) & 3u);
    if (_e207 == 0u) {
        if (param_9 > -8388608f) {
            let _e220 = f32(select(0i, select(select(i32(param_9), i32(-2147483648), (param_9 < bitcast<f32>(3472883712u))), 2147483647i, (param_9 > bitcast<f32>(1325400063u))), (param_9 == param_9)));
            if (_e220 > param_9) {
                phi_465_ = 1f;
            } else {
                phi_465_ = 0f;
            }
            let _e223 = phi_465_;
            if (param_9 < 8388608f) {
                phi_470_ = (_e220 - _e223);
                phi_471_ = false;
            } else {
                phi_470_ = f32();
                phi_471_ = true;
            }
            let _e226 = phi_470_;
            let _e228 = phi_471_;
            phi_472_ = _e226;
            phi_473_ = _e228;
        } else {
            phi_472_ = f32();
            phi_473_ = true;
        }
        let _e230 = phi_472_;
        let _e232 = phi_473_;
        if _e232 {
            phi_477_ = param_9;
        } else {
            phi_477_ = _e230;
        }
        let _e234 = phi_477_;
        phi_525_ = (param_9 - _e234);
    } else {
        if (_e207 == 1u) {
            let _e237 = (param_9 * 0.5f);
            if (_e237 > -8388608f) {
                let _e249 = f32(select(0i, select(select(i32(_e237), i32(-2147483648), (_e237 < bitcast<f32>(3472883712u))), 2147483647i, (_e237 > bitcast<f32>(1325400063u))), (_e237 == _e237)));
                if (_e249 > _e237) {
                    phi_503_ = 1f;
                } else {
                    phi_503_ = 0f;
                }
                let _e252 = phi_503_;
                if (_e237 < 8388608f) {
                    phi_508_ = (_e249 - _e252);
                    phi_509_ = false;
                } else {
                    phi_508_ = f32();
                    phi_509_ = true;
                }
                let _e255 = phi_508_;
                let _e257 = phi_509_;
                phi_510_ = _e255;
                phi_511_ = _e257;
            } else {
                phi_510_ = f32();
                phi_511_ = true;
            }
            let _e259 = phi_510_;
            let _e261 = phi_511_;
            if _e261 {
                phi_515_ = _e237;
            } else {
                phi_515_ = _e259;
            }
            let _e263 = phi_515_;
            let _e265 = (param_9 - (2f * _e263));
            if (_e265 > 1f) {
                phi_523_ = (2f - _e265);
            } else {
                phi_523_ = _e265;
            }
            let _e269 = phi_523_;
            phi_524_ = _e269;
        } else {
            phi_524_ = param_9;
        }
        let _e271 = phi_524_;
        phi_525_ = _e271;
    }
    let _e273 = phi_525_;
    if (_e273 > 0f) {
        if (_e273 < 1f) {
            phi_534_ = _e273;
        } else {
            phi_534_ = 1f;
        }
        let _e277 = phi_534_;
        phi_535_ = _e277;
    } else {
        phi_535_ = 0f;
    }
    let _e279 = phi_535_;
    let _e280 = (_e78 - 1u);
    let _e282 = (_e279 * f32(_e78));
    if _e82 {
        let _e289 = select(select(u32(_e282), 0u, (_e282 < bitcast<f32>(0u))), 4294967295u, (_e282 > bitcast<f32>(1333788671u)));
        if (_e280 < _e289) {
            phi_553_ = _e280;
        } else {
            phi_553_ = _e289;
        }
        let _e292 = phi_553_;
        phi_592_ = texture_Axis(_e292, _e292, 0f);
    } else {
        let _e294 = (_e282 + 0.5f);
        let _e301 = select(select(u32(_e294), 0u, (_e294 < bitcast<f32>(0u))), 4294967295u, (_e294 > bitcast<f32>(1333788671u)));
        if (_e78 < _e301) {
            phi_567_ = _e78;
        } else {
            phi_567_ = _e301;
        }
        let _e304 = phi_567_;
        if (_e207 == 0u) {
            phi_574_ = _e280;
        } else {
            phi_574_ = 0u;
        }
        let _e309 = phi_574_;
        if (_e207 == 0u) {
            phi_579_ = 0u;
        } else {
            phi_579_ = _e280;
        }
        let _e312 = phi_579_;
        if (_e304 == 0u) {
            phi_585_ = _e309;
        } else {
            phi_585_ = (_e304 - 1u);
        }
        let _e316 = phi_585_;
        if (_e304 > _e280) {
            phi_590_ = _e312;
        } else {
            phi_590_ = _e304;
        }
        let _e319 = phi_590_;
        phi_592_ = texture_Axis(_e316, _e319, (_e294 - f32(_e304)));
    }
    let _e322 = phi_592_;
    let _e326 = (*param_7).offset;
    let _e333 = (*param_7).offset;
    let _e340 = (*param_7).offset;
    let _e347 = (*param_7).offset;
    return texture_TexelQuad(array<u32, 4>(((_e326 + (_e322.low * _e74)) + _e202.low), ((_e333 + (_e322.low * _e74)) + _e202.high), ((_e340 + (_e322.high * _e74)) + _e202.low), ((_e347 + (_e322.high * _e74)) + _e202.high)), vec4<f32>(((1f - _e202.fraction) * (1f - _e322.fraction)), (_e202.fraction * (1f - _e322.fraction)), ((1f - _e202.fraction) * _e322.fraction), (_e202.fraction * _e322.fraction)));
}

fn _lt_bvh_ray_Ray_new(param_10: vec3<f32>, param_11: vec3<f32>) -> lt_bvh_Ray {
    return lt_bvh_Ray(param_10, 0f, param_11, 300000000000000000000000000000000000000f);
}

fn _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(param_12: f32, param_13: f32) -> f32 {
    var phi_651_: f32;

    if (param_12 > param_13) {
        phi_651_ = param_12;
    } else {
        phi_651_ = param_13;
    }
    let _e73 = phi_651_;
    return _e73;
}

fn _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(param_14: vec3<f32>) -> vec3<f32> {
    return vec3<f32>(1f, 1f, 1f);
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var local_2: lt_bvh_traverse_Stack;
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
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
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
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
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
    var phi_3667_: f32;
    var phi_3672_: f32;
    var phi_3677_: f32;
    var phi_3685_: f32;
    var phi_3690_: f32;
    var phi_3695_: f32;
    var phi_3759_: vec3<f32>;
    var phi_3880_: u32;
    var phi_3907_: f32;
    var phi_3914_: f32;
    var phi_3921_: f32;
    var phi_3956_: f32;
    var phi_3963_: f32;
    var phi_3970_: f32;
    var phi_4008_: f32;
    var phi_4015_: f32;
    var phi_4022_: f32;
    var phi_4108_: vec3<f32>;
    var phi_4109_: vec3<f32>;
    var phi_4110_: vec3<f32>;
    var phi_4119_: f32;
    var phi_4120_: f32;
    var phi_4130_: f32;
    var phi_4131_: f32;
    var phi_4141_: f32;
    var phi_4142_: f32;
    var phi_4177_: abi_Sample;
    var local_9: lt_bvh_Hit;
    var local_10: lt_bvh_Hit;
    var local_11: lt_bvh_Hit;
    var local_12: lt_bvh_Hit;

    let _e72 = id_1;
    let _e76 = arrayLength((&nodes.member));
    let _e79 = arrayLength((&triangles.member));
    let _e82 = arrayLength((&vertices.member));
    let _e85 = arrayLength((&materials.member));
    let _e91 = arrayLength((&instances.member));
    let _e94 = arrayLength((&alpha_texels.member));
    let _e97 = p.member.size[0u];
    let _e99 = p.member.size[1u];
    let _e100 = lt_shaders_entry_pixel_index(_e72, _e97, _e99);
    if (bitcast<i32>(_e100.word) != 0i) {
        let _e106 = p.member.root;
        let _e110 = p.member.eye;
        let _e115 = p.member.size[0u];
        let _e119 = ((((f32(_e72.x) + 0.5f) / f32(_e115)) * 2f) - 1f);
        let _e124 = p.member.size[1u];
        let _e128 = (1f - (((f32(_e72.y) + 0.5f) / f32(_e124)) * 2f));
        let _e130 = p.member.forward;
        let _e132 = p.member.right;
        let _e146 = p.member.up;
        let _e157 = _lt_bvh_ray_Ray_new(_e110, vec3<f32>(((_e130.x + (_e132.x * _e119)) + (_e146.x * _e128)), ((_e130.y + (_e132.y * _e119)) + (_e146.y * _e128)), ((_e130.z + (_e132.z * _e119)) + (_e146.z * _e128))));
        let _e159 = lt_bvh_Hit(_e157.tmax, 0f, 0f, 4294967295u, 4294967295u);
        let _e162 = abs(_e157.direction.x);
        let _e164 = abs(_e157.direction.y);
        let _e166 = abs(_e157.direction.z);
        if (abs(_e157.origin.x) < 1000000000000000f) {
            if (abs(_e157.origin.y) < 1000000000000000f) {
                phi_787_ = (abs(_e157.origin.z) < 1000000000000000f);
                phi_788_ = false;
            } else {
                phi_787_ = bool();
                phi_788_ = true;
            }
            let _e178 = phi_787_;
            let _e180 = phi_788_;
            phi_789_ = _e178;
            phi_790_ = _e180;
        } else {
            phi_789_ = bool();
            phi_790_ = true;
        }
        let _e182 = phi_789_;
        let _e184 = phi_790_;
        if _e184 {
            phi_794_ = false;
        } else {
            phi_794_ = _e182;
        }
        let _e186 = phi_794_;
        if _e186 {
            if (_e162 < 1000000000000000f) {
                if (_e164 < 1000000000000000f) {
                    phi_807_ = (_e166 < 1000000000000000f);
                    phi_808_ = false;
                } else {
                    phi_807_ = bool();
                    phi_808_ = true;
                }
                let _e191 = phi_807_;
                let _e193 = phi_808_;
                phi_809_ = _e191;
                phi_810_ = _e193;
            } else {
                phi_809_ = bool();
                phi_810_ = true;
            }
            let _e195 = phi_809_;
            let _e197 = phi_810_;
            if _e197 {
                phi_814_ = false;
            } else {
                phi_814_ = _e195;
            }
            let _e199 = phi_814_;
            if _e199 {
                if (_e162 > 0f) {
                    phi_828_ = bool();
                    phi_829_ = true;
                } else {
                    let _e201 = (_e164 > 0f);
                    if _e201 {
                        phi_827_ = bool();
                    } else {
                        phi_827_ = (_e166 > 0f);
                    }
                    let _e204 = phi_827_;
                    phi_828_ = _e204;
                    phi_829_ = _e201;
                }
                let _e206 = phi_828_;
                let _e208 = phi_829_;
                if _e208 {
                    phi_833_ = true;
                } else {
                    phi_833_ = _e206;
                }
                let _e210 = phi_833_;
                phi_834_ = _e210;
                phi_835_ = false;
            } else {
                phi_834_ = bool();
                phi_835_ = true;
            }
            let _e212 = phi_834_;
            let _e214 = phi_835_;
            phi_836_ = _e212;
            phi_837_ = _e214;
        } else {
            phi_836_ = bool();
            phi_837_ = true;
        }
        let _e216 = phi_836_;
        let _e218 = phi_837_;
        if _e218 {
            phi_841_ = false;
        } else {
            phi_841_ = _e216;
        }
        let _e220 = phi_841_;
        if _e220 {
            let _e221 = (_e106 >= _e76);
            if _e221 {
                phi_3473_ = lt_bvh_Hit();
            } else {
                if (_e106 < _e76) {
                } else {
                    return;
                }
                let _e227 = nodes.member[(0u + _e106)].frame[0u];
                let _e231 = nodes.member[(0u + _e106)].frame[1u];
                let _e235 = nodes.member[(0u + _e106)].frame[2u];
                let _e239 = nodes.member[(0u + _e106)].frame[0u];
                let _e243 = nodes.member[(0u + _e106)].frame[1u];
                let _e247 = nodes.member[(0u + _e106)].frame[2u];
                let _e251 = nodes.member[(0u + _e106)].frame[3u];
                let _e290 = core_intrinsics_maximum_number_nsz_f32_(abs(_e157.direction.x), abs(_e157.direction.y));
                let _e291 = core_intrinsics_maximum_number_nsz_f32_(_e290, abs(_e157.direction.z));
                let _e292 = (_e291 * 0.0000000000009094947f);
                if (abs(_e157.direction.x) < _e292) {
                    phi_917_ = _e292;
                } else {
                    phi_917_ = abs(_e157.direction.x);
                }
                let _e298 = phi_917_;
                if (_e157.direction.x < 0f) {
                    phi_924_ = (-1f / _e298);
                } else {
                    phi_924_ = (1f / _e298);
                }
                let _e303 = phi_924_;
                if (abs(_e157.direction.y) < _e292) {
                    phi_932_ = _e292;
                } else {
                    phi_932_ = abs(_e157.direction.y);
                }
                let _e309 = phi_932_;
                if (_e157.direction.y < 0f) {
                    phi_939_ = (-1f / _e309);
                } else {
                    phi_939_ = (1f / _e309);
                }
                let _e314 = phi_939_;
                if (abs(_e157.direction.z) < _e292) {
                    phi_947_ = _e292;
                } else {
                    phi_947_ = abs(_e157.direction.z);
                }
                let _e320 = phi_947_;
                if (_e157.direction.z < 0f) {
                    phi_954_ = (-1f / _e320);
                } else {
                    phi_954_ = (1f / _e320);
                }
                let _e325 = phi_954_;
                let _e332 = abs((bitcast<f32>(_e227) - _e157.origin.x));
                let _e333 = abs((bitcast<f32>(_e231) - _e157.origin.y));
                let _e334 = abs((bitcast<f32>(_e235) - _e157.origin.z));
                let _e341 = abs(((bitcast<f32>(_e239) + (bitcast<f32>((((_e251 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e157.origin.x));
                let _e342 = abs(((bitcast<f32>(_e243) + (bitcast<f32>((((_e251 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e157.origin.y));
                let _e343 = abs(((bitcast<f32>(_e247) + (bitcast<f32>((((_e251 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e157.origin.z));
                if (_e332 > _e341) {
                    phi_977_ = _e332;
                } else {
                    phi_977_ = _e341;
                }
                let _e346 = phi_977_;
                if (_e333 > _e342) {
                    phi_982_ = _e333;
                } else {
                    phi_982_ = _e342;
                }
                let _e349 = phi_982_;
                if (_e334 > _e343) {
                    phi_987_ = _e334;
                } else {
                    phi_987_ = _e343;
                }
                let _e352 = phi_987_;
                if (_e346 > _e349) {
                    phi_992_ = _e346;
                } else {
                    phi_992_ = _e349;
                }
                let _e355 = phi_992_;
                if (_e355 > _e352) {
                    phi_997_ = _e355;
                } else {
                    phi_997_ = _e352;
                }
                let _e358 = phi_997_;
                let _e362 = (_e358 * 0.0000019073486f);
                let _e363 = (abs(_e303) * _e362);
                let _e364 = (abs(_e314) * _e362);
                let _e365 = (abs(_e325) * _e362);
                let _e369 = (_e358 * 0.0000009536743f);
                let _e370 = (abs(_e303) * _e369);
                let _e371 = (abs(_e314) * _e369);
                let _e372 = (abs(_e325) * _e369);
                if (_e303 < 0f) {
                    phi_1016_ = 0u;
                } else {
                    phi_1016_ = 1u;
                }
                let _e375 = phi_1016_;
                if (_e314 < 0f) {
                    phi_1021_ = 0u;
                } else {
                    phi_1021_ = 2u;
                }
                let _e378 = phi_1021_;
                if (_e325 < 0f) {
                    phi_1026_ = 0u;
                } else {
                    phi_1026_ = 4u;
                }
                let _e381 = phi_1026_;
                let _e383 = ((_e375 | _e378) | _e381);
                let _e384 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e106, 2147483648u);
                local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e384.first[0], _e384.first[1], _e384.first[2], _e384.first[3], _e384.first[4], _e384.first[5], _e384.first[6], _e384.first[7], _e384.first[8], _e384.first[9], _e384.first[10], _e384.first[11], _e384.first[12], _e384.first[13], _e384.first[14], _e384.first[15], _e384.first[16], _e384.first[17], _e384.first[18], _e384.first[19], _e384.first[20], _e384.first[21], _e384.first[22], _e384.first[23], _e384.first[24], _e384.first[25], _e384.first[26], _e384.first[27], _e384.first[28], _e384.first[29], _e384.first[30], _e384.first[31]), array<u32, 32>(_e384.mask[0], _e384.mask[1], _e384.mask[2], _e384.mask[3], _e384.mask[4], _e384.mask[5], _e384.mask[6], _e384.mask[7], _e384.mask[8], _e384.mask[9], _e384.mask[10], _e384.mask[11], _e384.mask[12], _e384.mask[13], _e384.mask[14], _e384.mask[15], _e384.mask[16], _e384.mask[17], _e384.mask[18], _e384.mask[19], _e384.mask[20], _e384.mask[21], _e384.mask[22], _e384.mask[23], _e384.mask[24], _e384.mask[25], _e384.mask[26], _e384.mask[27], _e384.mask[28], _e384.mask[29], _e384.mask[30], _e384.mask[31]), _e384.len, _e384.group, _e384.group_mask);
                let _e458 = local_2.group_mask;
                if ((_e458 & 4278190080u) == 0u) {
                    let _e462 = local_2.len;
                    if (_e462 == 0u) {
                        phi_1140_ = false;
                    } else {
                        let _e466 = local_2.len;
                        local_2.len = (_e466 - 1u);
                        let _e469 = local_2.len;
                        if (_e469 < 32u) {
                        } else {
                            return;
                        }
                        let _e474 = local_2.first[(0u + _e469)];
                        local_2.group = _e474;
                        let _e477 = local_2.len;
                        if (_e477 < 32u) {
                        } else {
                            return;
                        }
                        let _e482 = local_2.mask[(0u + _e477)];
                        local_2.group_mask = _e482;
                        phi_1140_ = true;
                    }
                    let _e485 = phi_1140_;
                    phi_1141_ = _e485;
                } else {
                    phi_1141_ = true;
                }
                let _e487 = phi_1141_;
                if _e487 {
                    let _e489 = local_2.group_mask;
                    let _e495 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e489)), 32u, (_e489 == 0u)));
                    let _e499 = local_2.group_mask;
                    let _e513 = local_2.group_mask;
                    local_2.group_mask = (_e513 & ~((1u << bitcast<u32>((_e495 & 31u)))));
                    let _e516 = local_2.group;
                    phi_1172_ = (_e516 + countOneBits(((_e499 & ~((4294967295u << bitcast<u32>((((_e495 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1172_ = 4294967295u;
                }
                let _e519 = phi_1172_;
                phi_1174_ = _e519;
                phi_1177_ = _e159;
                loop {
                    let _e521 = phi_1174_;
                    let _e523 = phi_1177_;
                    local_12 = _e523;
                    let _e524 = (_e521 != 4294967295u);
                    if _e524 {
                        if (_e521 < _e76) {
                        } else {
                            return;
                        }
                        let _e532 = nodes.member[(0u + _e521)].frame[3u];
                        let _e557 = (bitcast<f32>((((_e532 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e303);
                        let _e558 = (bitcast<f32>((((_e532 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e314);
                        let _e559 = (bitcast<f32>((((_e532 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e325);
                        let _e562 = nodes.member[(0u + _e521)].frame[0u];
                        let _e566 = nodes.member[(0u + _e521)].frame[1u];
                        let _e570 = nodes.member[(0u + _e521)].frame[2u];
                        let _e578 = ((bitcast<f32>(_e562) - _e157.origin.x) * _e303);
                        let _e579 = ((bitcast<f32>(_e566) - _e157.origin.y) * _e314);
                        let _e580 = ((bitcast<f32>(_e570) - _e157.origin.z) * _e325);
                        let _e588 = nodes.member[(0u + _e521)].x;
                        if (_e303 < 0f) {
                            let _e599 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e588.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e605 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e599.unnamed.word, _e588.w), _e599.unnamed_1);
                            let _e611 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e605.unnamed, lt_mask_LightPlace(_e588.x, _e605.unnamed_1.shift));
                            phi_1262_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e611.unnamed, lt_mask_LightPlace(_e611.unnamed_1.word, _e588.y));
                        } else {
                            let _e627 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e588.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e633 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e627.unnamed.word, _e588.y), _e627.unnamed_1);
                            let _e639 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e633.unnamed, lt_mask_LightPlace(_e588.z, _e633.unnamed_1.shift));
                            phi_1262_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e639.unnamed, lt_mask_LightPlace(_e639.unnamed_1.word, _e588.w));
                        }
                        let _e647 = phi_1262_;
                        let _e657 = nodes.member[(0u + _e521)].y;
                        if (_e314 < 0f) {
                            let _e668 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e657.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e674 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e668.unnamed.word, _e657.w), _e668.unnamed_1);
                            let _e680 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e674.unnamed, lt_mask_LightPlace(_e657.x, _e674.unnamed_1.shift));
                            phi_1289_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e680.unnamed, lt_mask_LightPlace(_e680.unnamed_1.word, _e657.y));
                        } else {
                            let _e696 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e657.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e702 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e696.unnamed.word, _e657.y), _e696.unnamed_1);
                            let _e708 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e702.unnamed, lt_mask_LightPlace(_e657.z, _e702.unnamed_1.shift));
                            phi_1289_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e708.unnamed, lt_mask_LightPlace(_e708.unnamed_1.word, _e657.w));
                        }
                        let _e716 = phi_1289_;
                        let _e726 = nodes.member[(0u + _e521)].z;
                        if (_e325 < 0f) {
                            let _e737 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e726.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e743 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e737.unnamed.word, _e726.w), _e737.unnamed_1);
                            let _e749 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e743.unnamed, lt_mask_LightPlace(_e726.x, _e743.unnamed_1.shift));
                            phi_1316_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e749.unnamed, lt_mask_LightPlace(_e749.unnamed_1.word, _e726.y));
                        } else {
                            let _e765 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e726.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e771 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e765.unnamed.word, _e726.y), _e765.unnamed_1);
                            let _e777 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e771.unnamed, lt_mask_LightPlace(_e726.z, _e771.unnamed_1.shift));
                            phi_1316_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e777.unnamed, lt_mask_LightPlace(_e777.unnamed_1.word, _e726.w));
                        }
                        let _e785 = phi_1316_;
                        phi_1322_ = 0u;
                        phi_1325_ = 0u;
                        loop {
                            let _e795 = phi_1322_;
                            let _e797 = phi_1325_;
                            local_3 = _e797;
                            local_4 = _e797;
                            local_5 = _e797;
                            let _e798 = (_e795 < 8u);
                            if _e798 {
                                let _e800 = (_e795 >> bitcast<u32>(2i));
                                let _e801 = (_e795 & 3u);
                                if (_e800 == 0u) {
                                    phi_1339_ = _e647.unnamed.word;
                                } else {
                                    phi_1339_ = _e647.unnamed.shift;
                                }
                                let _e804 = phi_1339_;
                                if (_e800 == 0u) {
                                    phi_1349_ = _e716.unnamed.word;
                                } else {
                                    phi_1349_ = _e716.unnamed.shift;
                                }
                                let _e813 = phi_1349_;
                                if (_e800 == 0u) {
                                    phi_1359_ = _e785.unnamed.word;
                                } else {
                                    phi_1359_ = _e785.unnamed.shift;
                                }
                                let _e822 = phi_1359_;
                                let _e835 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e804 >> bitcast<u32>(((_e801 * 8u) & 31u))) & 255u)) * _e557) + (_e578 - _e363)), ((f32(((_e813 >> bitcast<u32>(((_e801 * 8u) & 31u))) & 255u)) * _e558) + (_e579 - _e364)));
                                let _e836 = core_intrinsics_maximum_number_nsz_f32_(_e835, ((f32(((_e822 >> bitcast<u32>(((_e801 * 8u) & 31u))) & 255u)) * _e559) + (_e580 - _e365)));
                                if (_e800 == 0u) {
                                    phi_1377_ = _e647.unnamed_1.word;
                                } else {
                                    phi_1377_ = _e647.unnamed_1.shift;
                                }
                                let _e839 = phi_1377_;
                                if (_e800 == 0u) {
                                    phi_1387_ = _e716.unnamed_1.word;
                                } else {
                                    phi_1387_ = _e716.unnamed_1.shift;
                                }
                                let _e848 = phi_1387_;
                                if (_e800 == 0u) {
                                    phi_1397_ = _e785.unnamed_1.word;
                                } else {
                                    phi_1397_ = _e785.unnamed_1.shift;
                                }
                                let _e857 = phi_1397_;
                                let _e870 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e839 >> bitcast<u32>(((_e801 * 8u) & 31u))) & 255u)) * _e557) + (_e578 + _e363)), ((f32(((_e848 >> bitcast<u32>(((_e801 * 8u) & 31u))) & 255u)) * _e558) + (_e579 + _e364)));
                                let _e871 = core_intrinsics_minimum_number_nsz_f32_(_e870, ((f32(((_e857 >> bitcast<u32>(((_e801 * 8u) & 31u))) & 255u)) * _e559) + (_e580 + _e365)));
                                if (_e836 <= _e871) {
                                    if (_e836 <= _e523.t) {
                                        if (_e871 >= _e157.tmin) {
                                            if (_e800 == 0u) {
                                                let _e878 = nodes.member[(0u + _e521)].links[2u];
                                                phi_1433_ = _e878;
                                            } else {
                                                let _e881 = nodes.member[(0u + _e521)].links[3u];
                                                phi_1433_ = _e881;
                                            }
                                            let _e883 = phi_1433_;
                                            let _e888 = ((_e883 >> bitcast<u32>(((_e801 * 8u) & 31u))) & 255u);
                                            let _e889 = (_e888 & 31u);
                                            if (_e889 >= 24u) {
                                                phi_1446_ = (24u + ((_e889 - 24u) ^ _e383));
                                            } else {
                                                phi_1446_ = _e889;
                                            }
                                            let _e895 = phi_1446_;
                                            phi_1451_ = (_e797 | ((_e888 >> bitcast<u32>(5i)) << bitcast<u32>((_e895 & 31u))));
                                        } else {
                                            phi_1451_ = _e797;
                                        }
                                        let _e903 = phi_1451_;
                                        phi_1452_ = _e903;
                                    } else {
                                        phi_1452_ = _e797;
                                    }
                                    let _e905 = phi_1452_;
                                    phi_1453_ = _e905;
                                } else {
                                    phi_1453_ = _e797;
                                }
                                let _e907 = phi_1453_;
                                phi_1323_ = (_e795 + 1u);
                                phi_1326_ = _e907;
                            } else {
                                phi_1323_ = u32();
                                phi_1326_ = u32();
                            }
                            let _e910 = phi_1323_;
                            let _e912 = phi_1326_;
                            continue;
                            continuing {
                                phi_1322_ = _e910;
                                phi_1325_ = _e912;
                                break if !(_e798);
                            }
                        }
                        let _e916 = nodes.member[(0u + _e521)].links[0u];
                        let _e920 = nodes.member[(0u + _e521)].frame[3u];
                        let _e924 = local_3;
                        if ((_e924 & 4278190080u) == 0u) {
                        } else {
                            let _e928 = local_2.group_mask;
                            if ((_e928 & 4278190080u) == 0u) {
                            } else {
                                let _e932 = local_2.len;
                                if (_e932 < 32u) {
                                    let _e935 = local_2.group;
                                    let _e937 = local_2.len;
                                    if (_e937 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.first[(0u + _e937)] = _e935;
                                    let _e943 = local_2.group_mask;
                                    let _e945 = local_2.len;
                                    if (_e945 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.mask[(0u + _e945)] = _e943;
                                    let _e952 = local_2.len;
                                    local_2.len = (_e952 + 1u);
                                }
                            }
                            local_2.group = (_e106 + _e916);
                            let _e956 = local_4;
                            local_2.group_mask = ((_e956 & 4278190080u) | (_e920 >> bitcast<u32>(24i)));
                        }
                        let _e961 = local_5;
                        phi_1511_ = (_e961 & 16777215u);
                        phi_1514_ = _e523;
                        loop {
                            let _e964 = phi_1511_;
                            let _e966 = phi_1514_;
                            local_11 = _e966;
                            if (_e964 == 0u) {
                                phi_1512_ = u32();
                                phi_1515_ = lt_bvh_Hit();
                                phi_3401_ = false;
                            } else {
                                let _e970 = nodes.member[(0u + _e521)].links[1u];
                                let _e974 = (_e970 + select(firstTrailingBit(_e964), 32u, (_e964 == 0u)));
                                if (_e974 < _e91) {
                                } else {
                                    return;
                                }
                                let _e981 = instances.member[(0u + _e974)].low_world;
                                let _e983 = instances.member[(0u + _e974)].high_world;
                                let _e993 = ((_e981.x - _e157.origin.x) * _e303);
                                let _e994 = ((_e981.y - _e157.origin.y) * _e314);
                                let _e995 = ((_e981.z - _e157.origin.z) * _e325);
                                let _e1005 = ((_e983.x - _e157.origin.x) * _e303);
                                let _e1006 = ((_e983.y - _e157.origin.y) * _e314);
                                let _e1007 = ((_e983.z - _e157.origin.z) * _e325);
                                if (_e993 < _e1005) {
                                    phi_1569_ = _e993;
                                } else {
                                    phi_1569_ = _e1005;
                                }
                                let _e1010 = phi_1569_;
                                if (_e994 < _e1006) {
                                    phi_1574_ = _e994;
                                } else {
                                    phi_1574_ = _e1006;
                                }
                                let _e1013 = phi_1574_;
                                if (_e995 < _e1007) {
                                    phi_1579_ = _e995;
                                } else {
                                    phi_1579_ = _e1007;
                                }
                                let _e1016 = phi_1579_;
                                if (_e993 > _e1005) {
                                    phi_1587_ = _e993;
                                } else {
                                    phi_1587_ = _e1005;
                                }
                                let _e1022 = phi_1587_;
                                if (_e994 > _e1006) {
                                    phi_1592_ = _e994;
                                } else {
                                    phi_1592_ = _e1006;
                                }
                                let _e1025 = phi_1592_;
                                if (_e995 > _e1007) {
                                    phi_1597_ = _e995;
                                } else {
                                    phi_1597_ = _e1007;
                                }
                                let _e1028 = phi_1597_;
                                let _e1032 = core_intrinsics_maximum_number_nsz_f32_((_e1010 - _e370), (_e1013 - _e371));
                                let _e1033 = core_intrinsics_maximum_number_nsz_f32_(_e1032, (_e1016 - _e372));
                                let _e1034 = core_intrinsics_minimum_number_nsz_f32_((_e1022 + _e370), (_e1025 + _e371));
                                let _e1035 = core_intrinsics_minimum_number_nsz_f32_(_e1034, (_e1028 + _e372));
                                if (_e1033 <= _e1035) {
                                    if (_e1033 <= _e966.t) {
                                        if (_e1035 >= _e157.tmin) {
                                            let _e1047 = instances.member[(0u + _e974)].world_to_object[0u];
                                            let _e1058 = ((((_e1047.x * _e157.origin.x) + (_e1047.y * _e157.origin.y)) + (_e1047.z * _e157.origin.z)) + (_e1047.w * 1f));
                                            let _e1060 = instances.member[(0u + _e974)].world_to_object[1u];
                                            let _e1071 = ((((_e1060.x * _e157.origin.x) + (_e1060.y * _e157.origin.y)) + (_e1060.z * _e157.origin.z)) + (_e1060.w * 1f));
                                            let _e1073 = instances.member[(0u + _e974)].world_to_object[2u];
                                            let _e1084 = ((((_e1073.x * _e157.origin.x) + (_e1073.y * _e157.origin.y)) + (_e1073.z * _e157.origin.z)) + (_e1073.w * 1f));
                                            let _e1091 = instances.member[(0u + _e974)].world_to_object[0u];
                                            let _e1102 = ((((_e1091.x * _e157.direction.x) + (_e1091.y * _e157.direction.y)) + (_e1091.z * _e157.direction.z)) + (_e1091.w * 0f));
                                            let _e1104 = instances.member[(0u + _e974)].world_to_object[1u];
                                            let _e1115 = ((((_e1104.x * _e157.direction.x) + (_e1104.y * _e157.direction.y)) + (_e1104.z * _e157.direction.z)) + (_e1104.w * 0f));
                                            let _e1117 = instances.member[(0u + _e974)].world_to_object[2u];
                                            let _e1128 = ((((_e1117.x * _e157.direction.x) + (_e1117.y * _e157.direction.y)) + (_e1117.z * _e157.direction.z)) + (_e1117.w * 0f));
                                            let _e1133 = instances.member[(0u + _e974)].root;
                                            let _e1135 = instances.member[(0u + _e974)].first_triangle;
                                            let _e1136 = abs(_e1102);
                                            let _e1137 = abs(_e1115);
                                            let _e1138 = abs(_e1128);
                                            if (abs(_e1058) < 1000000000000000f) {
                                                if (abs(_e1071) < 1000000000000000f) {
                                                    phi_1729_ = (abs(_e1084) < 1000000000000000f);
                                                    phi_1730_ = false;
                                                } else {
                                                    phi_1729_ = bool();
                                                    phi_1730_ = true;
                                                }
                                                let _e1146 = phi_1729_;
                                                let _e1148 = phi_1730_;
                                                phi_1731_ = _e1146;
                                                phi_1732_ = _e1148;
                                            } else {
                                                phi_1731_ = bool();
                                                phi_1732_ = true;
                                            }
                                            let _e1150 = phi_1731_;
                                            let _e1152 = phi_1732_;
                                            if _e1152 {
                                                phi_1736_ = false;
                                            } else {
                                                phi_1736_ = _e1150;
                                            }
                                            let _e1154 = phi_1736_;
                                            if _e1154 {
                                                if (_e1136 < 1000000000000000f) {
                                                    if (_e1137 < 1000000000000000f) {
                                                        phi_1749_ = (_e1138 < 1000000000000000f);
                                                        phi_1750_ = false;
                                                    } else {
                                                        phi_1749_ = bool();
                                                        phi_1750_ = true;
                                                    }
                                                    let _e1159 = phi_1749_;
                                                    let _e1161 = phi_1750_;
                                                    phi_1751_ = _e1159;
                                                    phi_1752_ = _e1161;
                                                } else {
                                                    phi_1751_ = bool();
                                                    phi_1752_ = true;
                                                }
                                                let _e1163 = phi_1751_;
                                                let _e1165 = phi_1752_;
                                                if _e1165 {
                                                    phi_1756_ = false;
                                                } else {
                                                    phi_1756_ = _e1163;
                                                }
                                                let _e1167 = phi_1756_;
                                                if _e1167 {
                                                    if (_e1136 > 0f) {
                                                        phi_1770_ = bool();
                                                        phi_1771_ = true;
                                                    } else {
                                                        let _e1169 = (_e1137 > 0f);
                                                        if _e1169 {
                                                            phi_1769_ = bool();
                                                        } else {
                                                            phi_1769_ = (_e1138 > 0f);
                                                        }
                                                        let _e1172 = phi_1769_;
                                                        phi_1770_ = _e1172;
                                                        phi_1771_ = _e1169;
                                                    }
                                                    let _e1174 = phi_1770_;
                                                    let _e1176 = phi_1771_;
                                                    if _e1176 {
                                                        phi_1775_ = true;
                                                    } else {
                                                        phi_1775_ = _e1174;
                                                    }
                                                    let _e1178 = phi_1775_;
                                                    phi_1776_ = _e1178;
                                                    phi_1777_ = false;
                                                } else {
                                                    phi_1776_ = bool();
                                                    phi_1777_ = true;
                                                }
                                                let _e1180 = phi_1776_;
                                                let _e1182 = phi_1777_;
                                                phi_1778_ = _e1180;
                                                phi_1779_ = _e1182;
                                            } else {
                                                phi_1778_ = bool();
                                                phi_1779_ = true;
                                            }
                                            let _e1184 = phi_1778_;
                                            let _e1186 = phi_1779_;
                                            if _e1186 {
                                                phi_1783_ = false;
                                            } else {
                                                phi_1783_ = _e1184;
                                            }
                                            let _e1188 = phi_1783_;
                                            if _e1188 {
                                                let _e1189 = (_e1133 >= _e76);
                                                if _e1189 {
                                                    phi_3391_ = lt_bvh_Hit();
                                                } else {
                                                    if (_e1133 < _e76) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1195 = nodes.member[(0u + _e1133)].frame[0u];
                                                    let _e1199 = nodes.member[(0u + _e1133)].frame[1u];
                                                    let _e1203 = nodes.member[(0u + _e1133)].frame[2u];
                                                    let _e1207 = nodes.member[(0u + _e1133)].frame[0u];
                                                    let _e1211 = nodes.member[(0u + _e1133)].frame[1u];
                                                    let _e1215 = nodes.member[(0u + _e1133)].frame[2u];
                                                    let _e1219 = nodes.member[(0u + _e1133)].frame[3u];
                                                    let _e1253 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1102), abs(_e1115));
                                                    let _e1254 = core_intrinsics_maximum_number_nsz_f32_(_e1253, abs(_e1128));
                                                    let _e1255 = (_e1254 * 0.0000000000009094947f);
                                                    if (abs(_e1102) < _e1255) {
                                                        phi_1853_ = _e1255;
                                                    } else {
                                                        phi_1853_ = abs(_e1102);
                                                    }
                                                    let _e1260 = phi_1853_;
                                                    if (_e1102 < 0f) {
                                                        phi_1860_ = (-1f / _e1260);
                                                    } else {
                                                        phi_1860_ = (1f / _e1260);
                                                    }
                                                    let _e1265 = phi_1860_;
                                                    if (abs(_e1115) < _e1255) {
                                                        phi_1867_ = _e1255;
                                                    } else {
                                                        phi_1867_ = abs(_e1115);
                                                    }
                                                    let _e1270 = phi_1867_;
                                                    if (_e1115 < 0f) {
                                                        phi_1874_ = (-1f / _e1270);
                                                    } else {
                                                        phi_1874_ = (1f / _e1270);
                                                    }
                                                    let _e1275 = phi_1874_;
                                                    if (abs(_e1128) < _e1255) {
                                                        phi_1881_ = _e1255;
                                                    } else {
                                                        phi_1881_ = abs(_e1128);
                                                    }
                                                    let _e1280 = phi_1881_;
                                                    if (_e1128 < 0f) {
                                                        phi_1888_ = (-1f / _e1280);
                                                    } else {
                                                        phi_1888_ = (1f / _e1280);
                                                    }
                                                    let _e1285 = phi_1888_;
                                                    let _e1289 = abs((bitcast<f32>(_e1195) - _e1058));
                                                    let _e1290 = abs((bitcast<f32>(_e1199) - _e1071));
                                                    let _e1291 = abs((bitcast<f32>(_e1203) - _e1084));
                                                    let _e1295 = abs(((bitcast<f32>(_e1207) + (bitcast<f32>((((_e1219 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1058));
                                                    let _e1296 = abs(((bitcast<f32>(_e1211) + (bitcast<f32>((((_e1219 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1071));
                                                    let _e1297 = abs(((bitcast<f32>(_e1215) + (bitcast<f32>((((_e1219 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1084));
                                                    if (_e1289 > _e1295) {
                                                        phi_1905_ = _e1289;
                                                    } else {
                                                        phi_1905_ = _e1295;
                                                    }
                                                    let _e1300 = phi_1905_;
                                                    if (_e1290 > _e1296) {
                                                        phi_1910_ = _e1290;
                                                    } else {
                                                        phi_1910_ = _e1296;
                                                    }
                                                    let _e1303 = phi_1910_;
                                                    if (_e1291 > _e1297) {
                                                        phi_1915_ = _e1291;
                                                    } else {
                                                        phi_1915_ = _e1297;
                                                    }
                                                    let _e1306 = phi_1915_;
                                                    if (_e1300 > _e1303) {
                                                        phi_1920_ = _e1300;
                                                    } else {
                                                        phi_1920_ = _e1303;
                                                    }
                                                    let _e1309 = phi_1920_;
                                                    if (_e1309 > _e1306) {
                                                        phi_1925_ = _e1309;
                                                    } else {
                                                        phi_1925_ = _e1306;
                                                    }
                                                    let _e1312 = phi_1925_;
                                                    let _e1316 = (_e1312 * 0.0000019073486f);
                                                    let _e1317 = (abs(_e1265) * _e1316);
                                                    let _e1318 = (abs(_e1275) * _e1316);
                                                    let _e1319 = (abs(_e1285) * _e1316);
                                                    let _e1323 = (_e1312 * 0.0000009536743f);
                                                    let _e1324 = (abs(_e1265) * _e1323);
                                                    let _e1325 = (abs(_e1275) * _e1323);
                                                    let _e1326 = (abs(_e1285) * _e1323);
                                                    let _e1327 = abs(_e1102);
                                                    let _e1328 = abs(_e1115);
                                                    let _e1329 = abs(_e1128);
                                                    if (_e1327 >= _e1328) {
                                                        if (_e1327 >= _e1329) {
                                                            phi_1951_ = false;
                                                        } else {
                                                            phi_1951_ = true;
                                                        }
                                                        let _e1333 = phi_1951_;
                                                        phi_1952_ = _e1333;
                                                    } else {
                                                        phi_1952_ = true;
                                                    }
                                                    let _e1335 = phi_1952_;
                                                    if _e1335 {
                                                        if (_e1328 >= _e1329) {
                                                            phi_1960_ = 1u;
                                                        } else {
                                                            phi_1960_ = 2u;
                                                        }
                                                        let _e1338 = phi_1960_;
                                                        phi_1961_ = _e1338;
                                                    } else {
                                                        phi_1961_ = 0u;
                                                    }
                                                    let _e1340 = phi_1961_;
                                                    if (_e1340 == 0u) {
                                                        phi_1973_ = vec3<f32>(_e1115, _e1128, _e1102);
                                                    } else {
                                                        if (_e1340 == 1u) {
                                                            phi_1972_ = vec3<f32>(_e1128, _e1102, _e1115);
                                                        } else {
                                                            phi_1972_ = vec3<f32>(_e1102, _e1115, _e1128);
                                                        }
                                                        let _e1346 = phi_1972_;
                                                        phi_1973_ = _e1346;
                                                    }
                                                    let _e1348 = phi_1973_;
                                                    let _e1351 = (_e1348.x / _e1348.z);
                                                    let _e1354 = (_e1348.y / _e1348.z);
                                                    if (_e1265 < 0f) {
                                                        phi_1986_ = 0u;
                                                    } else {
                                                        phi_1986_ = 1u;
                                                    }
                                                    let _e1359 = phi_1986_;
                                                    if (_e1275 < 0f) {
                                                        phi_1991_ = 0u;
                                                    } else {
                                                        phi_1991_ = 2u;
                                                    }
                                                    let _e1362 = phi_1991_;
                                                    if (_e1285 < 0f) {
                                                        phi_1996_ = 0u;
                                                    } else {
                                                        phi_1996_ = 4u;
                                                    }
                                                    let _e1365 = phi_1996_;
                                                    let _e1367 = ((_e1359 | _e1362) | _e1365);
                                                    let _e1368 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1133, 2147483648u);
                                                    local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e1368.first[0], _e1368.first[1], _e1368.first[2], _e1368.first[3], _e1368.first[4], _e1368.first[5], _e1368.first[6], _e1368.first[7], _e1368.first[8], _e1368.first[9], _e1368.first[10], _e1368.first[11], _e1368.first[12], _e1368.first[13], _e1368.first[14], _e1368.first[15], _e1368.first[16], _e1368.first[17], _e1368.first[18], _e1368.first[19], _e1368.first[20], _e1368.first[21], _e1368.first[22], _e1368.first[23], _e1368.first[24], _e1368.first[25], _e1368.first[26], _e1368.first[27], _e1368.first[28], _e1368.first[29], _e1368.first[30], _e1368.first[31]), array<u32, 32>(_e1368.mask[0], _e1368.mask[1], _e1368.mask[2], _e1368.mask[3], _e1368.mask[4], _e1368.mask[5], _e1368.mask[6], _e1368.mask[7], _e1368.mask[8], _e1368.mask[9], _e1368.mask[10], _e1368.mask[11], _e1368.mask[12], _e1368.mask[13], _e1368.mask[14], _e1368.mask[15], _e1368.mask[16], _e1368.mask[17], _e1368.mask[18], _e1368.mask[19], _e1368.mask[20], _e1368.mask[21], _e1368.mask[22], _e1368.mask[23], _e1368.mask[24], _e1368.mask[25], _e1368.mask[26], _e1368.mask[27], _e1368.mask[28], _e1368.mask[29], _e1368.mask[30], _e1368.mask[31]), _e1368.len, _e1368.group, _e1368.group_mask);
                                                    let _e1442 = local_1.group_mask;
                                                    if ((_e1442 & 4278190080u) == 0u) {
                                                        let _e1446 = local_1.len;
                                                        if (_e1446 == 0u) {
                                                            phi_2110_ = false;
                                                        } else {
                                                            let _e1450 = local_1.len;
                                                            local_1.len = (_e1450 - 1u);
                                                            let _e1453 = local_1.len;
                                                            if (_e1453 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1458 = local_1.first[(0u + _e1453)];
                                                            local_1.group = _e1458;
                                                            let _e1461 = local_1.len;
                                                            if (_e1461 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1466 = local_1.mask[(0u + _e1461)];
                                                            local_1.group_mask = _e1466;
                                                            phi_2110_ = true;
                                                        }
                                                        let _e1469 = phi_2110_;
                                                        phi_2111_ = _e1469;
                                                    } else {
                                                        phi_2111_ = true;
                                                    }
                                                    let _e1471 = phi_2111_;
                                                    if _e1471 {
                                                        let _e1473 = local_1.group_mask;
                                                        let _e1479 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1473)), 32u, (_e1473 == 0u)));
                                                        let _e1483 = local_1.group_mask;
                                                        let _e1497 = local_1.group_mask;
                                                        local_1.group_mask = (_e1497 & ~((1u << bitcast<u32>((_e1479 & 31u)))));
                                                        let _e1500 = local_1.group;
                                                        phi_2142_ = (_e1500 + countOneBits(((_e1483 & ~((4294967295u << bitcast<u32>((((_e1479 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_2142_ = 4294967295u;
                                                    }
                                                    let _e1503 = phi_2142_;
                                                    phi_2144_ = _e966;
                                                    phi_2147_ = _e1503;
                                                    loop {
                                                        let _e1505 = phi_2144_;
                                                        let _e1507 = phi_2147_;
                                                        local_10 = _e1505;
                                                        let _e1508 = (_e1507 != 4294967295u);
                                                        if _e1508 {
                                                            if (_e1507 < _e76) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1515 = nodes.member[(0u + _e1507)].frame[3u];
                                                            let _e1540 = (bitcast<f32>((((_e1515 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1265);
                                                            let _e1541 = (bitcast<f32>((((_e1515 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1275);
                                                            let _e1542 = (bitcast<f32>((((_e1515 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1285);
                                                            let _e1545 = nodes.member[(0u + _e1507)].frame[0u];
                                                            let _e1549 = nodes.member[(0u + _e1507)].frame[1u];
                                                            let _e1553 = nodes.member[(0u + _e1507)].frame[2u];
                                                            let _e1558 = ((bitcast<f32>(_e1545) - _e1058) * _e1265);
                                                            let _e1559 = ((bitcast<f32>(_e1549) - _e1071) * _e1275);
                                                            let _e1560 = ((bitcast<f32>(_e1553) - _e1084) * _e1285);
                                                            let _e1568 = nodes.member[(0u + _e1507)].x;
                                                            if (_e1265 < 0f) {
                                                                let _e1579 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1568.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1585 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1579.unnamed.word, _e1568.w), _e1579.unnamed_1);
                                                                let _e1591 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1585.unnamed, lt_mask_LightPlace(_e1568.x, _e1585.unnamed_1.shift));
                                                                phi_2228_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1591.unnamed, lt_mask_LightPlace(_e1591.unnamed_1.word, _e1568.y));
                                                            } else {
                                                                let _e1607 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1568.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1613 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1607.unnamed.word, _e1568.y), _e1607.unnamed_1);
                                                                let _e1619 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1613.unnamed, lt_mask_LightPlace(_e1568.z, _e1613.unnamed_1.shift));
                                                                phi_2228_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1619.unnamed, lt_mask_LightPlace(_e1619.unnamed_1.word, _e1568.w));
                                                            }
                                                            let _e1627 = phi_2228_;
                                                            let _e1637 = nodes.member[(0u + _e1507)].y;
                                                            if (_e1275 < 0f) {
                                                                let _e1648 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1637.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1654 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1648.unnamed.word, _e1637.w), _e1648.unnamed_1);
                                                                let _e1660 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1654.unnamed, lt_mask_LightPlace(_e1637.x, _e1654.unnamed_1.shift));
                                                                phi_2255_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1660.unnamed, lt_mask_LightPlace(_e1660.unnamed_1.word, _e1637.y));
                                                            } else {
                                                                let _e1676 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1637.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1682 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1676.unnamed.word, _e1637.y), _e1676.unnamed_1);
                                                                let _e1688 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1682.unnamed, lt_mask_LightPlace(_e1637.z, _e1682.unnamed_1.shift));
                                                                phi_2255_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1688.unnamed, lt_mask_LightPlace(_e1688.unnamed_1.word, _e1637.w));
                                                            }
                                                            let _e1696 = phi_2255_;
                                                            let _e1706 = nodes.member[(0u + _e1507)].z;
                                                            if (_e1285 < 0f) {
                                                                let _e1717 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1706.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1723 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1717.unnamed.word, _e1706.w), _e1717.unnamed_1);
                                                                let _e1729 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1723.unnamed, lt_mask_LightPlace(_e1706.x, _e1723.unnamed_1.shift));
                                                                phi_2282_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1729.unnamed, lt_mask_LightPlace(_e1729.unnamed_1.word, _e1706.y));
                                                            } else {
                                                                let _e1745 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1706.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1751 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1745.unnamed.word, _e1706.y), _e1745.unnamed_1);
                                                                let _e1757 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1751.unnamed, lt_mask_LightPlace(_e1706.z, _e1751.unnamed_1.shift));
                                                                phi_2282_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1757.unnamed, lt_mask_LightPlace(_e1757.unnamed_1.word, _e1706.w));
                                                            }
                                                            let _e1765 = phi_2282_;
                                                            phi_2288_ = 0u;
                                                            phi_2291_ = 0u;
                                                            loop {
                                                                let _e1775 = phi_2288_;
                                                                let _e1777 = phi_2291_;
                                                                local_6 = _e1777;
                                                                local_7 = _e1777;
                                                                local_8 = _e1777;
                                                                let _e1778 = (_e1775 < 8u);
                                                                if _e1778 {
                                                                    let _e1780 = (_e1775 >> bitcast<u32>(2i));
                                                                    let _e1781 = (_e1775 & 3u);
                                                                    if (_e1780 == 0u) {
                                                                        phi_2305_ = _e1627.unnamed.word;
                                                                    } else {
                                                                        phi_2305_ = _e1627.unnamed.shift;
                                                                    }
                                                                    let _e1784 = phi_2305_;
                                                                    if (_e1780 == 0u) {
                                                                        phi_2315_ = _e1696.unnamed.word;
                                                                    } else {
                                                                        phi_2315_ = _e1696.unnamed.shift;
                                                                    }
                                                                    let _e1793 = phi_2315_;
                                                                    if (_e1780 == 0u) {
                                                                        phi_2325_ = _e1765.unnamed.word;
                                                                    } else {
                                                                        phi_2325_ = _e1765.unnamed.shift;
                                                                    }
                                                                    let _e1802 = phi_2325_;
                                                                    let _e1815 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1784 >> bitcast<u32>(((_e1781 * 8u) & 31u))) & 255u)) * _e1540) + (_e1558 - _e1317)), ((f32(((_e1793 >> bitcast<u32>(((_e1781 * 8u) & 31u))) & 255u)) * _e1541) + (_e1559 - _e1318)));
                                                                    let _e1816 = core_intrinsics_maximum_number_nsz_f32_(_e1815, ((f32(((_e1802 >> bitcast<u32>(((_e1781 * 8u) & 31u))) & 255u)) * _e1542) + (_e1560 - _e1319)));
                                                                    if (_e1780 == 0u) {
                                                                        phi_2343_ = _e1627.unnamed_1.word;
                                                                    } else {
                                                                        phi_2343_ = _e1627.unnamed_1.shift;
                                                                    }
                                                                    let _e1819 = phi_2343_;
                                                                    if (_e1780 == 0u) {
                                                                        phi_2353_ = _e1696.unnamed_1.word;
                                                                    } else {
                                                                        phi_2353_ = _e1696.unnamed_1.shift;
                                                                    }
                                                                    let _e1828 = phi_2353_;
                                                                    if (_e1780 == 0u) {
                                                                        phi_2363_ = _e1765.unnamed_1.word;
                                                                    } else {
                                                                        phi_2363_ = _e1765.unnamed_1.shift;
                                                                    }
                                                                    let _e1837 = phi_2363_;
                                                                    let _e1850 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1819 >> bitcast<u32>(((_e1781 * 8u) & 31u))) & 255u)) * _e1540) + (_e1558 + _e1317)), ((f32(((_e1828 >> bitcast<u32>(((_e1781 * 8u) & 31u))) & 255u)) * _e1541) + (_e1559 + _e1318)));
                                                                    let _e1851 = core_intrinsics_minimum_number_nsz_f32_(_e1850, ((f32(((_e1837 >> bitcast<u32>(((_e1781 * 8u) & 31u))) & 255u)) * _e1542) + (_e1560 + _e1319)));
                                                                    if (_e1816 <= _e1851) {
                                                                        if (_e1816 <= _e1505.t) {
                                                                            if (_e1851 >= _e157.tmin) {
                                                                                if (_e1780 == 0u) {
                                                                                    let _e1858 = nodes.member[(0u + _e1507)].links[2u];
                                                                                    phi_2399_ = _e1858;
                                                                                } else {
                                                                                    let _e1861 = nodes.member[(0u + _e1507)].links[3u];
                                                                                    phi_2399_ = _e1861;
                                                                                }
                                                                                let _e1863 = phi_2399_;
                                                                                let _e1868 = ((_e1863 >> bitcast<u32>(((_e1781 * 8u) & 31u))) & 255u);
                                                                                let _e1869 = (_e1868 & 31u);
                                                                                if (_e1869 >= 24u) {
                                                                                    phi_2412_ = (24u + ((_e1869 - 24u) ^ _e1367));
                                                                                } else {
                                                                                    phi_2412_ = _e1869;
                                                                                }
                                                                                let _e1875 = phi_2412_;
                                                                                phi_2417_ = (_e1777 | ((_e1868 >> bitcast<u32>(5i)) << bitcast<u32>((_e1875 & 31u))));
                                                                            } else {
                                                                                phi_2417_ = _e1777;
                                                                            }
                                                                            let _e1883 = phi_2417_;
                                                                            phi_2418_ = _e1883;
                                                                        } else {
                                                                            phi_2418_ = _e1777;
                                                                        }
                                                                        let _e1885 = phi_2418_;
                                                                        phi_2419_ = _e1885;
                                                                    } else {
                                                                        phi_2419_ = _e1777;
                                                                    }
                                                                    let _e1887 = phi_2419_;
                                                                    phi_2289_ = (_e1775 + 1u);
                                                                    phi_2292_ = _e1887;
                                                                } else {
                                                                    phi_2289_ = u32();
                                                                    phi_2292_ = u32();
                                                                }
                                                                let _e1890 = phi_2289_;
                                                                let _e1892 = phi_2292_;
                                                                continue;
                                                                continuing {
                                                                    phi_2288_ = _e1890;
                                                                    phi_2291_ = _e1892;
                                                                    break if !(_e1778);
                                                                }
                                                            }
                                                            let _e1896 = nodes.member[(0u + _e1507)].links[0u];
                                                            let _e1900 = nodes.member[(0u + _e1507)].frame[3u];
                                                            let _e1904 = local_6;
                                                            if ((_e1904 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1908 = local_1.group_mask;
                                                                if ((_e1908 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1912 = local_1.len;
                                                                    if (_e1912 < 32u) {
                                                                        let _e1915 = local_1.group;
                                                                        let _e1917 = local_1.len;
                                                                        if (_e1917 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.first[(0u + _e1917)] = _e1915;
                                                                        let _e1923 = local_1.group_mask;
                                                                        let _e1925 = local_1.len;
                                                                        if (_e1925 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.mask[(0u + _e1925)] = _e1923;
                                                                        let _e1932 = local_1.len;
                                                                        local_1.len = (_e1932 + 1u);
                                                                    }
                                                                }
                                                                local_1.group = (_e1133 + _e1896);
                                                                let _e1936 = local_7;
                                                                local_1.group_mask = ((_e1936 & 4278190080u) | (_e1900 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1941 = local_8;
                                                            phi_2477_ = _e1505;
                                                            phi_2480_ = (_e1941 & 16777215u);
                                                            loop {
                                                                let _e1944 = phi_2477_;
                                                                let _e1946 = phi_2480_;
                                                                local_9 = _e1944;
                                                                if (_e1946 == 0u) {
                                                                    phi_2478_ = lt_bvh_Hit();
                                                                    phi_2481_ = u32();
                                                                    phi_3319_ = false;
                                                                } else {
                                                                    let _e1950 = nodes.member[(0u + _e1507)].links[1u];
                                                                    let _e1955 = ((_e1135 + _e1950) + select(firstTrailingBit(_e1946), 32u, (_e1946 == 0u)));
                                                                    if (_e1955 < _e79) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1962 = triangles.member[(0u + _e1955)].v0_;
                                                                    let _e1964 = (_e1962.x - _e1058);
                                                                    let _e1966 = (_e1962.y - _e1071);
                                                                    let _e1968 = (_e1962.z - _e1084);
                                                                    if (_e1340 == 0u) {
                                                                        phi_2525_ = vec3<f32>(_e1966, _e1968, _e1964);
                                                                    } else {
                                                                        if (_e1340 == 1u) {
                                                                            phi_2524_ = vec3<f32>(_e1968, _e1964, _e1966);
                                                                        } else {
                                                                            phi_2524_ = (_e1962 - vec3<f32>(_e1058, _e1071, _e1084));
                                                                        }
                                                                        let _e1976 = phi_2524_;
                                                                        phi_2525_ = _e1976;
                                                                    }
                                                                    let _e1978 = phi_2525_;
                                                                    let _e1982 = (_e1978.x - (_e1351 * _e1978.z));
                                                                    let _e1986 = (_e1978.y - (_e1354 * _e1978.z));
                                                                    let _e1988 = triangles.member[(0u + _e1955)].v1_;
                                                                    let _e1990 = (_e1988.x - _e1058);
                                                                    let _e1992 = (_e1988.y - _e1071);
                                                                    let _e1994 = (_e1988.z - _e1084);
                                                                    if (_e1340 == 0u) {
                                                                        phi_2555_ = vec3<f32>(_e1992, _e1994, _e1990);
                                                                    } else {
                                                                        if (_e1340 == 1u) {
                                                                            phi_2554_ = vec3<f32>(_e1994, _e1990, _e1992);
                                                                        } else {
                                                                            phi_2554_ = (_e1988 - vec3<f32>(_e1058, _e1071, _e1084));
                                                                        }
                                                                        let _e2002 = phi_2554_;
                                                                        phi_2555_ = _e2002;
                                                                    }
                                                                    let _e2004 = phi_2555_;
                                                                    let _e2008 = (_e2004.x - (_e1351 * _e2004.z));
                                                                    let _e2012 = (_e2004.y - (_e1354 * _e2004.z));
                                                                    let _e2014 = triangles.member[(0u + _e1955)].v2_;
                                                                    let _e2016 = (_e2014.x - _e1058);
                                                                    let _e2018 = (_e2014.y - _e1071);
                                                                    let _e2020 = (_e2014.z - _e1084);
                                                                    if (_e1340 == 0u) {
                                                                        phi_2585_ = vec3<f32>(_e2018, _e2020, _e2016);
                                                                    } else {
                                                                        if (_e1340 == 1u) {
                                                                            phi_2584_ = vec3<f32>(_e2020, _e2016, _e2018);
                                                                        } else {
                                                                            phi_2584_ = (_e2014 - vec3<f32>(_e1058, _e1071, _e1084));
                                                                        }
                                                                        let _e2028 = phi_2584_;
                                                                        phi_2585_ = _e2028;
                                                                    }
                                                                    let _e2030 = phi_2585_;
                                                                    let _e2034 = (_e2030.x - (_e1351 * _e2030.z));
                                                                    let _e2038 = (_e2030.y - (_e1354 * _e2030.z));
                                                                    if (_e2008 < _e2034) {
                                                                        phi_2604_ = true;
                                                                    } else {
                                                                        if (_e2008 == _e2034) {
                                                                            phi_2603_ = (_e2012 < _e2038);
                                                                        } else {
                                                                            phi_2603_ = false;
                                                                        }
                                                                        let _e2043 = phi_2603_;
                                                                        phi_2604_ = _e2043;
                                                                    }
                                                                    let _e2045 = phi_2604_;
                                                                    if _e2045 {
                                                                        phi_2608_ = _e2038;
                                                                        phi_2609_ = _e2034;
                                                                        phi_2610_ = _e2012;
                                                                        phi_2611_ = _e2008;
                                                                    } else {
                                                                        phi_2608_ = _e2012;
                                                                        phi_2609_ = _e2008;
                                                                        phi_2610_ = _e2038;
                                                                        phi_2611_ = _e2034;
                                                                    }
                                                                    let _e2047 = phi_2608_;
                                                                    let _e2049 = phi_2609_;
                                                                    let _e2051 = phi_2610_;
                                                                    let _e2053 = phi_2611_;
                                                                    let _e2056 = ((_e2053 * _e2047) - (_e2051 * _e2049));
                                                                    if _e2045 {
                                                                        phi_2619_ = -(_e2056);
                                                                    } else {
                                                                        phi_2619_ = _e2056;
                                                                    }
                                                                    let _e2059 = phi_2619_;
                                                                    if (_e2034 < _e1982) {
                                                                        phi_2630_ = true;
                                                                    } else {
                                                                        if (_e2034 == _e1982) {
                                                                            phi_2629_ = (_e2038 < _e1986);
                                                                        } else {
                                                                            phi_2629_ = false;
                                                                        }
                                                                        let _e2064 = phi_2629_;
                                                                        phi_2630_ = _e2064;
                                                                    }
                                                                    let _e2066 = phi_2630_;
                                                                    if _e2066 {
                                                                        phi_2634_ = _e1986;
                                                                        phi_2635_ = _e1982;
                                                                        phi_2636_ = _e2038;
                                                                        phi_2637_ = _e2034;
                                                                    } else {
                                                                        phi_2634_ = _e2038;
                                                                        phi_2635_ = _e2034;
                                                                        phi_2636_ = _e1986;
                                                                        phi_2637_ = _e1982;
                                                                    }
                                                                    let _e2068 = phi_2634_;
                                                                    let _e2070 = phi_2635_;
                                                                    let _e2072 = phi_2636_;
                                                                    let _e2074 = phi_2637_;
                                                                    let _e2077 = ((_e2074 * _e2068) - (_e2072 * _e2070));
                                                                    if _e2066 {
                                                                        phi_2645_ = -(_e2077);
                                                                    } else {
                                                                        phi_2645_ = _e2077;
                                                                    }
                                                                    let _e2080 = phi_2645_;
                                                                    if (_e1982 < _e2008) {
                                                                        phi_2656_ = true;
                                                                    } else {
                                                                        if (_e1982 == _e2008) {
                                                                            phi_2655_ = (_e1986 < _e2012);
                                                                        } else {
                                                                            phi_2655_ = false;
                                                                        }
                                                                        let _e2085 = phi_2655_;
                                                                        phi_2656_ = _e2085;
                                                                    }
                                                                    let _e2087 = phi_2656_;
                                                                    if _e2087 {
                                                                        phi_2660_ = _e2012;
                                                                        phi_2661_ = _e2008;
                                                                        phi_2662_ = _e1986;
                                                                        phi_2663_ = _e1982;
                                                                    } else {
                                                                        phi_2660_ = _e1986;
                                                                        phi_2661_ = _e1982;
                                                                        phi_2662_ = _e2012;
                                                                        phi_2663_ = _e2008;
                                                                    }
                                                                    let _e2089 = phi_2660_;
                                                                    let _e2091 = phi_2661_;
                                                                    let _e2093 = phi_2662_;
                                                                    let _e2095 = phi_2663_;
                                                                    let _e2098 = ((_e2095 * _e2089) - (_e2093 * _e2091));
                                                                    if _e2087 {
                                                                        phi_2671_ = -(_e2098);
                                                                    } else {
                                                                        phi_2671_ = _e2098;
                                                                    }
                                                                    let _e2101 = phi_2671_;
                                                                    if (_e2059 >= 0f) {
                                                                        if (_e2080 >= 0f) {
                                                                            if (_e2101 >= 0f) {
                                                                                phi_2686_ = ((_e2059 + _e2080) + _e2101);
                                                                                phi_2687_ = false;
                                                                            } else {
                                                                                phi_2686_ = f32();
                                                                                phi_2687_ = true;
                                                                            }
                                                                            let _e2108 = phi_2686_;
                                                                            let _e2110 = phi_2687_;
                                                                            phi_2688_ = _e2108;
                                                                            phi_2689_ = _e2110;
                                                                        } else {
                                                                            phi_2688_ = f32();
                                                                            phi_2689_ = true;
                                                                        }
                                                                        let _e2112 = phi_2688_;
                                                                        let _e2114 = phi_2689_;
                                                                        phi_2690_ = _e2112;
                                                                        phi_2691_ = _e2114;
                                                                    } else {
                                                                        phi_2690_ = f32();
                                                                        phi_2691_ = true;
                                                                    }
                                                                    let _e2116 = phi_2690_;
                                                                    let _e2118 = phi_2691_;
                                                                    if _e2118 {
                                                                        if (_e2059 <= 0f) {
                                                                            if (_e2080 <= 0f) {
                                                                                let _e2121 = (_e2101 <= 0f);
                                                                                if _e2121 {
                                                                                }
                                                                                phi_2709_ = ((_e2059 + _e2080) + _e2101);
                                                                                phi_2710_ = false;
                                                                                phi_2711_ = _e2121;
                                                                            } else {
                                                                                phi_2709_ = f32();
                                                                                phi_2710_ = true;
                                                                                phi_2711_ = false;
                                                                            }
                                                                            let _e2125 = phi_2709_;
                                                                            let _e2127 = phi_2710_;
                                                                            let _e2129 = phi_2711_;
                                                                            phi_2712_ = _e2125;
                                                                            phi_2713_ = _e2127;
                                                                            phi_2714_ = _e2129;
                                                                        } else {
                                                                            phi_2712_ = f32();
                                                                            phi_2713_ = true;
                                                                            phi_2714_ = false;
                                                                        }
                                                                        let _e2131 = phi_2712_;
                                                                        let _e2133 = phi_2713_;
                                                                        let _e2135 = phi_2714_;
                                                                        if _e2133 {
                                                                            phi_2718_ = false;
                                                                        } else {
                                                                            phi_2718_ = _e2135;
                                                                        }
                                                                        let _e2137 = phi_2718_;
                                                                        phi_2719_ = _e2131;
                                                                        phi_2720_ = _e2137;
                                                                    } else {
                                                                        phi_2719_ = _e2116;
                                                                        phi_2720_ = true;
                                                                    }
                                                                    let _e2139 = phi_2719_;
                                                                    let _e2141 = phi_2720_;
                                                                    if _e2141 {
                                                                        let _e2142 = (_e2139 == 0f);
                                                                        if _e2142 {
                                                                            phi_3036_ = lt_bvh_triangle_Intersection();
                                                                            phi_3037_ = false;
                                                                        } else {
                                                                            let _e2144 = triangles.member[(0u + _e1955)].v0_;
                                                                            let _e2146 = (_e2144.x - _e1058);
                                                                            let _e2148 = (_e2144.y - _e1071);
                                                                            let _e2150 = (_e2144.z - _e1084);
                                                                            if (_e1340 == 0u) {
                                                                                phi_2749_ = vec3<f32>(_e2148, _e2150, _e2146);
                                                                            } else {
                                                                                if (_e1340 == 1u) {
                                                                                    phi_2748_ = vec3<f32>(_e2150, _e2146, _e2148);
                                                                                } else {
                                                                                    phi_2748_ = (_e2144 - vec3<f32>(_e1058, _e1071, _e1084));
                                                                                }
                                                                                let _e2158 = phi_2748_;
                                                                                phi_2749_ = _e2158;
                                                                            }
                                                                            let _e2160 = phi_2749_;
                                                                            let _e2162 = triangles.member[(0u + _e1955)].v1_;
                                                                            let _e2164 = triangles.member[(0u + _e1955)].v0_;
                                                                            let _e2167 = (_e2162.x - _e2164.x);
                                                                            let _e2170 = (_e2162.y - _e2164.y);
                                                                            let _e2173 = (_e2162.z - _e2164.z);
                                                                            if (_e1340 == 0u) {
                                                                                phi_2775_ = vec3<f32>(_e2170, _e2173, _e2167);
                                                                            } else {
                                                                                if (_e1340 == 1u) {
                                                                                    phi_2774_ = vec3<f32>(_e2173, _e2167, _e2170);
                                                                                } else {
                                                                                    phi_2774_ = (_e2162 - _e2164);
                                                                                }
                                                                                let _e2180 = phi_2774_;
                                                                                phi_2775_ = _e2180;
                                                                            }
                                                                            let _e2182 = phi_2775_;
                                                                            let _e2184 = triangles.member[(0u + _e1955)].v2_;
                                                                            let _e2186 = triangles.member[(0u + _e1955)].v0_;
                                                                            let _e2189 = (_e2184.x - _e2186.x);
                                                                            let _e2192 = (_e2184.y - _e2186.y);
                                                                            let _e2195 = (_e2184.z - _e2186.z);
                                                                            if (_e1340 == 0u) {
                                                                                phi_2801_ = vec3<f32>(_e2192, _e2195, _e2189);
                                                                            } else {
                                                                                if (_e1340 == 1u) {
                                                                                    phi_2800_ = vec3<f32>(_e2195, _e2189, _e2192);
                                                                                } else {
                                                                                    phi_2800_ = (_e2184 - _e2186);
                                                                                }
                                                                                let _e2202 = phi_2800_;
                                                                                phi_2801_ = _e2202;
                                                                            }
                                                                            let _e2204 = phi_2801_;
                                                                            let _e2211 = ((_e2182.y * _e2204.z) - (_e2182.z * _e2204.y));
                                                                            let _e2218 = ((_e2182.z * _e2204.x) - (_e2182.x * _e2204.z));
                                                                            let _e2225 = ((_e2182.x * _e2204.y) - (_e2182.y * _e2204.x));
                                                                            let _e2239 = (((1f / _e1348.z) * (((_e2211 * _e2160.x) + (_e2218 * _e2160.y)) + (_e2225 * _e2160.z))) / (((_e2211 * _e1351) + (_e2218 * _e1354)) + _e2225));
                                                                            if (_e2239 > _e157.tmin) {
                                                                                if (_e2239 < _e157.tmax) {
                                                                                    let _e2243 = triangles.member[(0u + _e1955)].v0_;
                                                                                    let _e2245 = triangles.member[(0u + _e1955)].v1_;
                                                                                    if (_e2243.x < _e2245.x) {
                                                                                        phi_2857_ = _e2243.x;
                                                                                    } else {
                                                                                        phi_2857_ = _e2245.x;
                                                                                    }
                                                                                    let _e2252 = phi_2857_;
                                                                                    if (_e2243.y < _e2245.y) {
                                                                                        phi_2866_ = _e2243.y;
                                                                                    } else {
                                                                                        phi_2866_ = _e2245.y;
                                                                                    }
                                                                                    let _e2259 = phi_2866_;
                                                                                    if (_e2243.z < _e2245.z) {
                                                                                        phi_2875_ = _e2243.z;
                                                                                    } else {
                                                                                        phi_2875_ = _e2245.z;
                                                                                    }
                                                                                    let _e2266 = phi_2875_;
                                                                                    let _e2268 = triangles.member[(0u + _e1955)].v2_;
                                                                                    if (_e2252 < _e2268.x) {
                                                                                        phi_2884_ = _e2252;
                                                                                    } else {
                                                                                        phi_2884_ = _e2268.x;
                                                                                    }
                                                                                    let _e2273 = phi_2884_;
                                                                                    if (_e2259 < _e2268.y) {
                                                                                        phi_2891_ = _e2259;
                                                                                    } else {
                                                                                        phi_2891_ = _e2268.y;
                                                                                    }
                                                                                    let _e2278 = phi_2891_;
                                                                                    if (_e2266 < _e2268.z) {
                                                                                        phi_2898_ = _e2266;
                                                                                    } else {
                                                                                        phi_2898_ = _e2268.z;
                                                                                    }
                                                                                    let _e2283 = phi_2898_;
                                                                                    let _e2285 = triangles.member[(0u + _e1955)].v0_;
                                                                                    let _e2287 = triangles.member[(0u + _e1955)].v1_;
                                                                                    if (_e2285.x > _e2287.x) {
                                                                                        phi_2911_ = _e2285.x;
                                                                                    } else {
                                                                                        phi_2911_ = _e2287.x;
                                                                                    }
                                                                                    let _e2294 = phi_2911_;
                                                                                    if (_e2285.y > _e2287.y) {
                                                                                        phi_2920_ = _e2285.y;
                                                                                    } else {
                                                                                        phi_2920_ = _e2287.y;
                                                                                    }
                                                                                    let _e2301 = phi_2920_;
                                                                                    if (_e2285.z > _e2287.z) {
                                                                                        phi_2929_ = _e2285.z;
                                                                                    } else {
                                                                                        phi_2929_ = _e2287.z;
                                                                                    }
                                                                                    let _e2308 = phi_2929_;
                                                                                    let _e2310 = triangles.member[(0u + _e1955)].v2_;
                                                                                    if (_e2294 > _e2310.x) {
                                                                                        phi_2938_ = _e2294;
                                                                                    } else {
                                                                                        phi_2938_ = _e2310.x;
                                                                                    }
                                                                                    let _e2315 = phi_2938_;
                                                                                    if (_e2301 > _e2310.y) {
                                                                                        phi_2945_ = _e2301;
                                                                                    } else {
                                                                                        phi_2945_ = _e2310.y;
                                                                                    }
                                                                                    let _e2320 = phi_2945_;
                                                                                    if (_e2308 > _e2310.z) {
                                                                                        phi_2952_ = _e2308;
                                                                                    } else {
                                                                                        phi_2952_ = _e2310.z;
                                                                                    }
                                                                                    let _e2325 = phi_2952_;
                                                                                    let _e2329 = ((_e2273 - _e1058) * _e1265);
                                                                                    let _e2330 = ((_e2278 - _e1071) * _e1275);
                                                                                    let _e2331 = ((_e2283 - _e1084) * _e1285);
                                                                                    let _e2335 = ((_e2315 - _e1058) * _e1265);
                                                                                    let _e2336 = ((_e2320 - _e1071) * _e1275);
                                                                                    let _e2337 = ((_e2325 - _e1084) * _e1285);
                                                                                    if (_e2329 < _e2335) {
                                                                                        phi_2969_ = _e2329;
                                                                                    } else {
                                                                                        phi_2969_ = _e2335;
                                                                                    }
                                                                                    let _e2340 = phi_2969_;
                                                                                    if (_e2330 < _e2336) {
                                                                                        phi_2974_ = _e2330;
                                                                                    } else {
                                                                                        phi_2974_ = _e2336;
                                                                                    }
                                                                                    let _e2343 = phi_2974_;
                                                                                    if (_e2331 < _e2337) {
                                                                                        phi_2979_ = _e2331;
                                                                                    } else {
                                                                                        phi_2979_ = _e2337;
                                                                                    }
                                                                                    let _e2346 = phi_2979_;
                                                                                    if (_e2329 > _e2335) {
                                                                                        phi_2987_ = _e2329;
                                                                                    } else {
                                                                                        phi_2987_ = _e2335;
                                                                                    }
                                                                                    let _e2352 = phi_2987_;
                                                                                    if (_e2330 > _e2336) {
                                                                                        phi_2992_ = _e2330;
                                                                                    } else {
                                                                                        phi_2992_ = _e2336;
                                                                                    }
                                                                                    let _e2355 = phi_2992_;
                                                                                    if (_e2331 > _e2337) {
                                                                                        phi_2997_ = _e2331;
                                                                                    } else {
                                                                                        phi_2997_ = _e2337;
                                                                                    }
                                                                                    let _e2358 = phi_2997_;
                                                                                    let _e2362 = core_intrinsics_maximum_number_nsz_f32_((_e2340 - _e1324), (_e2343 - _e1325));
                                                                                    let _e2363 = core_intrinsics_maximum_number_nsz_f32_(_e2362, (_e2346 - _e1326));
                                                                                    let _e2364 = core_intrinsics_minimum_number_nsz_f32_((_e2352 + _e1324), (_e2355 + _e1325));
                                                                                    let _e2365 = core_intrinsics_minimum_number_nsz_f32_(_e2364, (_e2358 + _e1326));
                                                                                    if (_e2363 > _e1033) {
                                                                                        phi_3009_ = _e2363;
                                                                                    } else {
                                                                                        phi_3009_ = _e1033;
                                                                                    }
                                                                                    let _e2368 = phi_3009_;
                                                                                    if (_e2365 < _e1035) {
                                                                                        phi_3014_ = _e2365;
                                                                                    } else {
                                                                                        phi_3014_ = _e1035;
                                                                                    }
                                                                                    let _e2371 = phi_3014_;
                                                                                    if (_e2239 < _e2368) {
                                                                                        phi_3019_ = _e2368;
                                                                                    } else {
                                                                                        phi_3019_ = _e2239;
                                                                                    }
                                                                                    let _e2374 = phi_3019_;
                                                                                    if (_e2374 > _e2371) {
                                                                                        phi_3024_ = _e2371;
                                                                                    } else {
                                                                                        phi_3024_ = _e2374;
                                                                                    }
                                                                                    let _e2377 = phi_3024_;
                                                                                    phi_3029_ = lt_bvh_triangle_Intersection(_e2377, (_e2080 / _e2139), (_e2101 / _e2139), (_e2368 <= _e2371));
                                                                                    phi_3030_ = false;
                                                                                } else {
                                                                                    phi_3029_ = lt_bvh_triangle_Intersection();
                                                                                    phi_3030_ = true;
                                                                                }
                                                                                let _e2383 = phi_3029_;
                                                                                let _e2385 = phi_3030_;
                                                                                phi_3031_ = _e2383;
                                                                                phi_3032_ = _e2385;
                                                                            } else {
                                                                                phi_3031_ = lt_bvh_triangle_Intersection();
                                                                                phi_3032_ = true;
                                                                            }
                                                                            let _e2387 = phi_3031_;
                                                                            let _e2389 = phi_3032_;
                                                                            if _e2389 {
                                                                            }
                                                                            phi_3036_ = _e2387;
                                                                            phi_3037_ = _e2389;
                                                                        }
                                                                        let _e2391 = phi_3036_;
                                                                        let _e2393 = phi_3037_;
                                                                        phi_3038_ = _e2391;
                                                                        phi_3039_ = _e2142;
                                                                        phi_3040_ = _e2393;
                                                                    } else {
                                                                        phi_3038_ = lt_bvh_triangle_Intersection();
                                                                        phi_3039_ = true;
                                                                        phi_3040_ = false;
                                                                    }
                                                                    let _e2395 = phi_3038_;
                                                                    let _e2397 = phi_3039_;
                                                                    let _e2399 = phi_3040_;
                                                                    if _e2397 {
                                                                        phi_3044_ = true;
                                                                    } else {
                                                                        phi_3044_ = _e2399;
                                                                    }
                                                                    let _e2401 = phi_3044_;
                                                                    if _e2401 {
                                                                        phi_3048_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_3048_ = _e2395;
                                                                    }
                                                                    let _e2403 = phi_3048_;
                                                                    if _e2403.is_hit {
                                                                        if (_e2403.t > _e157.tmin) {
                                                                            if (_e2403.t < _e1944.t) {
                                                                                phi_3096_ = true;
                                                                            } else {
                                                                                if (_e2403.t == _e1944.t) {
                                                                                    if (_e1944.triangle != 4294967295u) {
                                                                                        if (_e1955 < _e1944.triangle) {
                                                                                            phi_3087_ = true;
                                                                                        } else {
                                                                                            if (_e1955 == _e1944.triangle) {
                                                                                                phi_3086_ = (_e974 < _e1944.instance);
                                                                                            } else {
                                                                                                phi_3086_ = false;
                                                                                            }
                                                                                            let _e2421 = phi_3086_;
                                                                                            phi_3087_ = _e2421;
                                                                                        }
                                                                                        let _e2423 = phi_3087_;
                                                                                        phi_3088_ = _e2423;
                                                                                        phi_3089_ = false;
                                                                                    } else {
                                                                                        phi_3088_ = bool();
                                                                                        phi_3089_ = true;
                                                                                    }
                                                                                    let _e2425 = phi_3088_;
                                                                                    let _e2427 = phi_3089_;
                                                                                    phi_3090_ = _e2425;
                                                                                    phi_3091_ = _e2427;
                                                                                } else {
                                                                                    phi_3090_ = bool();
                                                                                    phi_3091_ = true;
                                                                                }
                                                                                let _e2429 = phi_3090_;
                                                                                let _e2431 = phi_3091_;
                                                                                if _e2431 {
                                                                                    phi_3095_ = false;
                                                                                } else {
                                                                                    phi_3095_ = _e2429;
                                                                                }
                                                                                let _e2433 = phi_3095_;
                                                                                phi_3096_ = _e2433;
                                                                            }
                                                                            let _e2435 = phi_3096_;
                                                                            if _e2435 {
                                                                                let _e2437 = triangles.member[(0u + _e1955)].i0_;
                                                                                if ((_e2437 & 2147483648u) == 0u) {
                                                                                    phi_3307_ = true;
                                                                                } else {
                                                                                    if (_e1955 < _e79) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2446 = triangles.member[(0u + _e1955)].i0_;
                                                                                    let _e2447 = (_e2446 & 2147483647u);
                                                                                    let _e2449 = triangles.member[(0u + _e1955)].i1_;
                                                                                    let _e2451 = triangles.member[(0u + _e1955)].i2_;
                                                                                    if (_e2447 < _e82) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2455 = vertices.member[(0u + _e2447)];
                                                                                    if (_e2449 < _e82) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2459 = vertices.member[(0u + _e2449)];
                                                                                    if (_e2451 < _e82) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2463 = vertices.member[(0u + _e2451)];
                                                                                    let _e2464 = array<abi_Vertex, 3>(_e2455, _e2459, _e2463);
                                                                                    if (_e2464[0].material < _e85) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2470 = materials.member[(0u + _e2464[0].material)];
                                                                                    if ((_e2470.flags & 0u) == 0u) {
                                                                                        let _e2475 = ((1f - _e2403.u) - _e2403.v);
                                                                                        if (_e2470.cutoff <= 0f) {
                                                                                            phi_3302_ = true;
                                                                                        } else {
                                                                                            let _e2502 = (_e2470.base_color.w * ((((f32((_e2464[0].color >> bitcast<u32>(24i))) * _e2475) + (f32((_e2464[1].color >> bitcast<u32>(24i))) * _e2403.u)) + (f32((_e2464[2].color >> bitcast<u32>(24i))) * _e2403.v)) * (1f / 255f)));
                                                                                            if (_e2470.alpha_size == 0u) {
                                                                                                phi_3299_ = _e2502;
                                                                                            } else {
                                                                                                local.offset = _e2470.alpha_offset;
                                                                                                local.size = _e2470.alpha_size;
                                                                                                local.flags = _e2470.flags;
                                                                                                let _e2533 = _lt_shaders_texture_TextureView_quad((&local), (((_e2464[0].u * _e2475) + (_e2464[1].u * _e2403.u)) + (_e2464[2].u * _e2403.v)), (((_e2464[0].v * _e2475) + (_e2464[1].v * _e2403.u)) + (_e2464[2].v * _e2403.v)));
                                                                                                let _e2537 = (_e2533.indices[0] >> bitcast<u32>(2i));
                                                                                                if (_e2537 < _e94) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2541 = alpha_texels.member[(0u + _e2537)];
                                                                                                let _e2557 = (_e2533.indices[1] >> bitcast<u32>(2i));
                                                                                                if (_e2557 < _e94) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2561 = alpha_texels.member[(0u + _e2557)];
                                                                                                let _e2578 = (_e2533.indices[2] >> bitcast<u32>(2i));
                                                                                                if (_e2578 < _e94) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2582 = alpha_texels.member[(0u + _e2578)];
                                                                                                let _e2599 = (_e2533.indices[3] >> bitcast<u32>(2i));
                                                                                                if (_e2599 < _e94) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2603 = alpha_texels.member[(0u + _e2599)];
                                                                                                phi_3299_ = (_e2502 * (((((f32(((_e2541 >> bitcast<u32>((((_e2533.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2533.weights.x) + ((f32(((_e2561 >> bitcast<u32>((((_e2533.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2533.weights.y)) + ((f32(((_e2582 >> bitcast<u32>((((_e2533.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2533.weights.z)) + ((f32(((_e2603 >> bitcast<u32>((((_e2533.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2533.weights.w)));
                                                                                            }
                                                                                            let _e2619 = phi_3299_;
                                                                                            phi_3302_ = (_e2619 >= _e2470.cutoff);
                                                                                        }
                                                                                        let _e2623 = phi_3302_;
                                                                                        phi_3303_ = _e2623;
                                                                                    } else {
                                                                                        phi_3303_ = false;
                                                                                    }
                                                                                    let _e2625 = phi_3303_;
                                                                                    if _e2625 {
                                                                                    }
                                                                                    phi_3307_ = _e2625;
                                                                                }
                                                                                let _e2627 = phi_3307_;
                                                                                if _e2627 {
                                                                                    phi_3315_ = lt_bvh_Hit(_e2403.t, _e2403.u, _e2403.v, _e1955, _e974);
                                                                                } else {
                                                                                    phi_3315_ = _e1944;
                                                                                }
                                                                                let _e2633 = phi_3315_;
                                                                                phi_3316_ = _e2633;
                                                                            } else {
                                                                                phi_3316_ = _e1944;
                                                                            }
                                                                            let _e2635 = phi_3316_;
                                                                            phi_3317_ = _e2635;
                                                                        } else {
                                                                            phi_3317_ = _e1944;
                                                                        }
                                                                        let _e2637 = phi_3317_;
                                                                        phi_3318_ = _e2637;
                                                                    } else {
                                                                        phi_3318_ = _e1944;
                                                                    }
                                                                    let _e2639 = phi_3318_;
                                                                    phi_2478_ = _e2639;
                                                                    phi_2481_ = (_e1946 & (_e1946 - 1u));
                                                                    phi_3319_ = true;
                                                                }
                                                                let _e2641 = phi_2478_;
                                                                let _e2643 = phi_2481_;
                                                                let _e2645 = phi_3319_;
                                                                continue;
                                                                continuing {
                                                                    phi_2477_ = _e2641;
                                                                    phi_2480_ = _e2643;
                                                                    break if !(_e2645);
                                                                }
                                                            }
                                                            let _e2648 = local_1.group_mask;
                                                            if ((_e2648 & 4278190080u) == 0u) {
                                                                let _e2652 = local_1.len;
                                                                if (_e2652 == 0u) {
                                                                    phi_3358_ = false;
                                                                } else {
                                                                    let _e2656 = local_1.len;
                                                                    local_1.len = (_e2656 - 1u);
                                                                    let _e2659 = local_1.len;
                                                                    if (_e2659 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2664 = local_1.first[(0u + _e2659)];
                                                                    local_1.group = _e2664;
                                                                    let _e2667 = local_1.len;
                                                                    if (_e2667 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2672 = local_1.mask[(0u + _e2667)];
                                                                    local_1.group_mask = _e2672;
                                                                    phi_3358_ = true;
                                                                }
                                                                let _e2675 = phi_3358_;
                                                                phi_3359_ = _e2675;
                                                            } else {
                                                                phi_3359_ = true;
                                                            }
                                                            let _e2677 = phi_3359_;
                                                            if _e2677 {
                                                                let _e2679 = local_1.group_mask;
                                                                let _e2685 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2679)), 32u, (_e2679 == 0u)));
                                                                let _e2689 = local_1.group_mask;
                                                                let _e2703 = local_1.group_mask;
                                                                local_1.group_mask = (_e2703 & ~((1u << bitcast<u32>((_e2685 & 31u)))));
                                                                let _e2706 = local_1.group;
                                                                phi_3390_ = (_e2706 + countOneBits(((_e2689 & ~((4294967295u << bitcast<u32>((((_e2685 - 24u) ^ _e1367) & 31u))))) & 255u)));
                                                            } else {
                                                                phi_3390_ = 4294967295u;
                                                            }
                                                            let _e2709 = phi_3390_;
                                                            let _e3694 = local_9;
                                                            phi_2145_ = _e3694;
                                                            phi_2148_ = _e2709;
                                                        } else {
                                                            phi_2145_ = lt_bvh_Hit();
                                                            phi_2148_ = u32();
                                                        }
                                                        let _e2711 = phi_2145_;
                                                        let _e2713 = phi_2148_;
                                                        continue;
                                                        continuing {
                                                            phi_2144_ = _e2711;
                                                            phi_2147_ = _e2713;
                                                            break if !(_e1508);
                                                        }
                                                    }
                                                    let _e3698 = local_10;
                                                    phi_3391_ = _e3698;
                                                }
                                                let _e2716 = phi_3391_;
                                                phi_3392_ = _e2716;
                                                phi_3393_ = _e1189;
                                            } else {
                                                phi_3392_ = lt_bvh_Hit();
                                                phi_3393_ = true;
                                            }
                                            let _e2718 = phi_3392_;
                                            let _e2720 = phi_3393_;
                                            if _e2720 {
                                                phi_3397_ = _e966;
                                            } else {
                                                phi_3397_ = _e2718;
                                            }
                                            let _e2722 = phi_3397_;
                                            phi_3398_ = _e2722;
                                        } else {
                                            phi_3398_ = _e966;
                                        }
                                        let _e2724 = phi_3398_;
                                        phi_3399_ = _e2724;
                                    } else {
                                        phi_3399_ = _e966;
                                    }
                                    let _e2726 = phi_3399_;
                                    phi_3400_ = _e2726;
                                } else {
                                    phi_3400_ = _e966;
                                }
                                let _e2728 = phi_3400_;
                                phi_1512_ = (_e964 & (_e964 - 1u));
                                phi_1515_ = _e2728;
                                phi_3401_ = true;
                            }
                            let _e2730 = phi_1512_;
                            let _e2732 = phi_1515_;
                            let _e2734 = phi_3401_;
                            continue;
                            continuing {
                                phi_1511_ = _e2730;
                                phi_1514_ = _e2732;
                                break if !(_e2734);
                            }
                        }
                        let _e2737 = local_2.group_mask;
                        if ((_e2737 & 4278190080u) == 0u) {
                            let _e2741 = local_2.len;
                            if (_e2741 == 0u) {
                                phi_3440_ = false;
                            } else {
                                let _e2745 = local_2.len;
                                local_2.len = (_e2745 - 1u);
                                let _e2748 = local_2.len;
                                if (_e2748 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2753 = local_2.first[(0u + _e2748)];
                                local_2.group = _e2753;
                                let _e2756 = local_2.len;
                                if (_e2756 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2761 = local_2.mask[(0u + _e2756)];
                                local_2.group_mask = _e2761;
                                phi_3440_ = true;
                            }
                            let _e2764 = phi_3440_;
                            phi_3441_ = _e2764;
                        } else {
                            phi_3441_ = true;
                        }
                        let _e2766 = phi_3441_;
                        if _e2766 {
                            let _e2768 = local_2.group_mask;
                            let _e2774 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2768)), 32u, (_e2768 == 0u)));
                            let _e2778 = local_2.group_mask;
                            let _e2792 = local_2.group_mask;
                            local_2.group_mask = (_e2792 & ~((1u << bitcast<u32>((_e2774 & 31u)))));
                            let _e2795 = local_2.group;
                            phi_3472_ = (_e2795 + countOneBits(((_e2778 & ~((4294967295u << bitcast<u32>((((_e2774 - 24u) ^ _e383) & 31u))))) & 255u)));
                        } else {
                            phi_3472_ = 4294967295u;
                        }
                        let _e2798 = phi_3472_;
                        phi_1175_ = _e2798;
                        let _e3714 = local_11;
                        phi_1178_ = _e3714;
                    } else {
                        phi_1175_ = u32();
                        phi_1178_ = lt_bvh_Hit();
                    }
                    let _e2800 = phi_1175_;
                    let _e2802 = phi_1178_;
                    continue;
                    continuing {
                        phi_1174_ = _e2800;
                        phi_1177_ = _e2802;
                        break if !(_e524);
                    }
                }
                let _e3717 = local_12;
                phi_3473_ = _e3717;
            }
            let _e2805 = phi_3473_;
            phi_3474_ = _e2805;
            phi_3475_ = _e221;
        } else {
            phi_3474_ = lt_bvh_Hit();
            phi_3475_ = true;
        }
        let _e2807 = phi_3474_;
        let _e2809 = phi_3475_;
        if _e2809 {
            phi_3479_ = _e159;
        } else {
            phi_3479_ = _e2807;
        }
        let _e2811 = phi_3479_;
        if (_e2811.triangle != 4294967295u) {
            let _e2817 = ((1f - _e2811.u) - _e2811.v);
            if (_e2811.triangle < _e79) {
            } else {
                return;
            }
            let _e2823 = triangles.member[(0u + _e2811.triangle)];
            if (_e2811.instance < _e91) {
            } else {
                return;
            }
            let _e2834 = instances.member[(0u + _e2811.instance)].object_to_world[0u];
            let _e2845 = ((((_e2834.x * _e2823.v0_.x) + (_e2834.y * _e2823.v0_.y)) + (_e2834.z * _e2823.v0_.z)) + (_e2834.w * 1f));
            let _e2847 = instances.member[(0u + _e2811.instance)].object_to_world[1u];
            let _e2858 = ((((_e2847.x * _e2823.v0_.x) + (_e2847.y * _e2823.v0_.y)) + (_e2847.z * _e2823.v0_.z)) + (_e2847.w * 1f));
            let _e2860 = instances.member[(0u + _e2811.instance)].object_to_world[2u];
            let _e2871 = ((((_e2860.x * _e2823.v0_.x) + (_e2860.y * _e2823.v0_.y)) + (_e2860.z * _e2823.v0_.z)) + (_e2860.w * 1f));
            let _e2878 = instances.member[(0u + _e2811.instance)].object_to_world[0u];
            let _e2889 = ((((_e2878.x * _e2823.v1_.x) + (_e2878.y * _e2823.v1_.y)) + (_e2878.z * _e2823.v1_.z)) + (_e2878.w * 1f));
            let _e2891 = instances.member[(0u + _e2811.instance)].object_to_world[1u];
            let _e2902 = ((((_e2891.x * _e2823.v1_.x) + (_e2891.y * _e2823.v1_.y)) + (_e2891.z * _e2823.v1_.z)) + (_e2891.w * 1f));
            let _e2904 = instances.member[(0u + _e2811.instance)].object_to_world[2u];
            let _e2915 = ((((_e2904.x * _e2823.v1_.x) + (_e2904.y * _e2823.v1_.y)) + (_e2904.z * _e2823.v1_.z)) + (_e2904.w * 1f));
            let _e2922 = instances.member[(0u + _e2811.instance)].object_to_world[0u];
            let _e2933 = ((((_e2922.x * _e2823.v2_.x) + (_e2922.y * _e2823.v2_.y)) + (_e2922.z * _e2823.v2_.z)) + (_e2922.w * 1f));
            let _e2935 = instances.member[(0u + _e2811.instance)].object_to_world[1u];
            let _e2946 = ((((_e2935.x * _e2823.v2_.x) + (_e2935.y * _e2823.v2_.y)) + (_e2935.z * _e2823.v2_.z)) + (_e2935.w * 1f));
            let _e2948 = instances.member[(0u + _e2811.instance)].object_to_world[2u];
            let _e2959 = ((((_e2948.x * _e2823.v2_.x) + (_e2948.y * _e2823.v2_.y)) + (_e2948.z * _e2823.v2_.z)) + (_e2948.w * 1f));
            let _e2972 = (((_e2845 * _e2817) + (_e2889 * _e2811.u)) + (_e2933 * _e2811.v));
            let _e2973 = (((_e2858 * _e2817) + (_e2902 * _e2811.u)) + (_e2946 * _e2811.v));
            let _e2974 = (((_e2871 * _e2817) + (_e2915 * _e2811.u)) + (_e2959 * _e2811.v));
            let _e2976 = abs(_e2845);
            let _e2977 = abs(_e2858);
            let _e2978 = abs(_e2871);
            let _e2979 = abs(_e2889);
            let _e2980 = abs(_e2902);
            let _e2981 = abs(_e2915);
            if (_e2976 > _e2979) {
                phi_3667_ = _e2976;
            } else {
                phi_3667_ = _e2979;
            }
            let _e2984 = phi_3667_;
            if (_e2977 > _e2980) {
                phi_3672_ = _e2977;
            } else {
                phi_3672_ = _e2980;
            }
            let _e2987 = phi_3672_;
            if (_e2978 > _e2981) {
                phi_3677_ = _e2978;
            } else {
                phi_3677_ = _e2981;
            }
            let _e2990 = phi_3677_;
            let _e2991 = abs(_e2933);
            let _e2992 = abs(_e2946);
            let _e2993 = abs(_e2959);
            if (_e2984 > _e2991) {
                phi_3685_ = _e2984;
            } else {
                phi_3685_ = _e2991;
            }
            let _e2996 = phi_3685_;
            if (_e2987 > _e2992) {
                phi_3690_ = _e2987;
            } else {
                phi_3690_ = _e2992;
            }
            let _e2999 = phi_3690_;
            if (_e2990 > _e2993) {
                phi_3695_ = _e2990;
            } else {
                phi_3695_ = _e2993;
            }
            let _e3002 = phi_3695_;
            let _e3003 = (_e2889 - _e2845);
            let _e3004 = (_e2902 - _e2858);
            let _e3005 = (_e2915 - _e2871);
            let _e3006 = (_e2933 - _e2845);
            let _e3007 = (_e2946 - _e2858);
            let _e3008 = (_e2959 - _e2871);
            let _e3012 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3004), abs(_e3005));
            let _e3013 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3003), _e3012);
            let _e3014 = (_e3003 / _e3013);
            let _e3015 = (_e3004 / _e3013);
            let _e3016 = (_e3005 / _e3013);
            let _e3020 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3007), abs(_e3008));
            let _e3021 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3006), _e3020);
            let _e3022 = (_e3006 / _e3021);
            let _e3023 = (_e3007 / _e3021);
            let _e3024 = (_e3008 / _e3021);
            let _e3027 = ((_e3015 * _e3024) - (_e3023 * _e3016));
            let _e3030 = ((_e3016 * _e3022) - (_e3024 * _e3014));
            let _e3033 = ((_e3014 * _e3023) - (_e3022 * _e3015));
            let _e3035 = p.member.eye;
            let _e3048 = (1f / sqrt((((_e3027 * _e3027) + (_e3030 * _e3030)) + (_e3033 * _e3033))));
            let _e3049 = (_e3027 * _e3048);
            let _e3050 = (_e3030 * _e3048);
            let _e3051 = (_e3033 * _e3048);
            if ((((_e3049 * (_e3035.x - _e2972)) + (_e3050 * (_e3035.y - _e2973))) + (_e3051 * (_e3035.z - _e2974))) < 0f) {
                phi_3759_ = vec3<f32>(-(_e3049), -(_e3050), -(_e3051));
            } else {
                phi_3759_ = vec3<f32>(_e3049, _e3050, _e3051);
            }
            let _e3064 = phi_3759_;
            if (_e2811.triangle < _e79) {
            } else {
                return;
            }
            let _e3069 = triangles.member[(0u + _e2811.triangle)];
            let _e3071 = (_e3069.i0_ & 2147483647u);
            if (_e3071 < _e82) {
            } else {
                return;
            }
            let _e3077 = vertices.member[(0u + _e3071)];
            if (_e3069.i1_ < _e82) {
            } else {
                return;
            }
            let _e3081 = vertices.member[(0u + _e3069.i1_)];
            if (_e3069.i2_ < _e82) {
            } else {
                return;
            }
            let _e3085 = vertices.member[(0u + _e3069.i2_)];
            let _e3086 = array<abi_Vertex, 3>(_e3077, _e3081, _e3085);
            if (_e3086[0].material < _e85) {
            } else {
                return;
            }
            let _e3092 = materials.member[(0u + _e3086[0].material)];
            let _e3109 = (1f / 255f);
            let _e3128 = (1f / 255f);
            let _e3150 = (1f / 255f);
            let _e3163 = _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(vec3<f32>(_e2817, _e2811.u, _e2811.v));
            let _e3165 = ((_e3092.base_color.x * ((((f32((_e3086[0].color & 255u)) * _e3109) * _e2817) + ((f32((_e3086[1].color & 255u)) * _e3128) * _e2811.u)) + ((f32((_e3086[2].color & 255u)) * _e3150) * _e2811.v))) * _e3163.x);
            let _e3167 = ((_e3092.base_color.y * ((((f32(((_e3086[0].color >> bitcast<u32>(8i)) & 255u)) * _e3109) * _e2817) + ((f32(((_e3086[1].color >> bitcast<u32>(8i)) & 255u)) * _e3128) * _e2811.u)) + ((f32(((_e3086[2].color >> bitcast<u32>(8i)) & 255u)) * _e3150) * _e2811.v))) * _e3163.y);
            let _e3169 = ((_e3092.base_color.z * ((((f32(((_e3086[0].color >> bitcast<u32>(16i)) & 255u)) * _e3109) * _e2817) + ((f32(((_e3086[1].color >> bitcast<u32>(16i)) & 255u)) * _e3128) * _e2811.u)) + ((f32(((_e3086[2].color >> bitcast<u32>(16i)) & 255u)) * _e3150) * _e2811.v))) * _e3163.z);
            let _e3170 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e2999, _e3002);
            let _e3171 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e2996, _e3170);
            if ((_e3092.flags & 2u) == 0u) {
                phi_3880_ = 0u;
            } else {
                phi_3880_ = 1u;
            }
            let _e3176 = phi_3880_;
            if (_e3086[0].normal == 2147516416u) {
                phi_4110_ = _e3064;
            } else {
                let _e3189 = (f32((bitcast<i32>((_e3086[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3195 = (f32((bitcast<i32>(_e3086[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3199 = ((1f - abs(_e3189)) - abs(_e3195));
                if (_e3199 < 0f) {
                    phi_3907_ = -(_e3199);
                } else {
                    phi_3907_ = 0f;
                }
                let _e3203 = phi_3907_;
                if (_e3189 < 0f) {
                    phi_3914_ = (_e3189 + _e3203);
                } else {
                    phi_3914_ = (_e3189 - _e3203);
                }
                let _e3208 = phi_3914_;
                if (_e3195 < 0f) {
                    phi_3921_ = (_e3195 + _e3203);
                } else {
                    phi_3921_ = (_e3195 - _e3203);
                }
                let _e3213 = phi_3921_;
                let _e3220 = (1f / sqrt((((_e3208 * _e3208) + (_e3213 * _e3213)) + (_e3199 * _e3199))));
                let _e3236 = (f32((bitcast<i32>((_e3086[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3242 = (f32((bitcast<i32>(_e3086[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3246 = ((1f - abs(_e3236)) - abs(_e3242));
                if (_e3246 < 0f) {
                    phi_3956_ = -(_e3246);
                } else {
                    phi_3956_ = 0f;
                }
                let _e3250 = phi_3956_;
                if (_e3236 < 0f) {
                    phi_3963_ = (_e3236 + _e3250);
                } else {
                    phi_3963_ = (_e3236 - _e3250);
                }
                let _e3255 = phi_3963_;
                if (_e3242 < 0f) {
                    phi_3970_ = (_e3242 + _e3250);
                } else {
                    phi_3970_ = (_e3242 - _e3250);
                }
                let _e3260 = phi_3970_;
                let _e3267 = (1f / sqrt((((_e3255 * _e3255) + (_e3260 * _e3260)) + (_e3246 * _e3246))));
                let _e3286 = (f32((bitcast<i32>((_e3086[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3292 = (f32((bitcast<i32>(_e3086[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3296 = ((1f - abs(_e3286)) - abs(_e3292));
                if (_e3296 < 0f) {
                    phi_4008_ = -(_e3296);
                } else {
                    phi_4008_ = 0f;
                }
                let _e3300 = phi_4008_;
                if (_e3286 < 0f) {
                    phi_4015_ = (_e3286 + _e3300);
                } else {
                    phi_4015_ = (_e3286 - _e3300);
                }
                let _e3305 = phi_4015_;
                if (_e3292 < 0f) {
                    phi_4022_ = (_e3292 + _e3300);
                } else {
                    phi_4022_ = (_e3292 - _e3300);
                }
                let _e3310 = phi_4022_;
                let _e3317 = (1f / sqrt((((_e3305 * _e3305) + (_e3310 * _e3310)) + (_e3296 * _e3296))));
                let _e3324 = ((((_e3208 * _e3220) * _e2817) + ((_e3255 * _e3267) * _e2811.u)) + ((_e3305 * _e3317) * _e2811.v));
                let _e3325 = ((((_e3213 * _e3220) * _e2817) + ((_e3260 * _e3267) * _e2811.u)) + ((_e3310 * _e3317) * _e2811.v));
                let _e3326 = ((((_e3199 * _e3220) * _e2817) + ((_e3246 * _e3267) * _e2811.u)) + ((_e3296 * _e3317) * _e2811.v));
                if (_e2811.instance < _e91) {
                } else {
                    return;
                }
                let _e3333 = instances.member[(0u + _e2811.instance)].world_to_object[0u];
                let _e3342 = instances.member[(0u + _e2811.instance)].world_to_object[1u];
                let _e3354 = instances.member[(0u + _e2811.instance)].world_to_object[2u];
                let _e3361 = (((_e3333.x * _e3324) + (_e3342.x * _e3325)) + (_e3354.x * _e3326));
                let _e3362 = (((_e3333.y * _e3324) + (_e3342.y * _e3325)) + (_e3354.y * _e3326));
                let _e3363 = (((_e3333.z * _e3324) + (_e3342.z * _e3325)) + (_e3354.z * _e3326));
                let _e3369 = sqrt((((_e3361 * _e3361) + (_e3362 * _e3362)) + (_e3363 * _e3363)));
                if (_e3369 > 0f) {
                    let _e3371 = (_e3361 / _e3369);
                    let _e3372 = (_e3362 / _e3369);
                    let _e3373 = (_e3363 / _e3369);
                    if ((((_e3371 * _e3064.x) + (_e3372 * _e3064.y)) + (_e3373 * _e3064.z)) < 0f) {
                        phi_4108_ = vec3<f32>(-(_e3371), -(_e3372), -(_e3373));
                    } else {
                        phi_4108_ = vec3<f32>(_e3371, _e3372, _e3373);
                    }
                    let _e3389 = phi_4108_;
                    phi_4109_ = _e3389;
                } else {
                    phi_4109_ = _e3064;
                }
                let _e3391 = phi_4109_;
                phi_4110_ = _e3391;
            }
            let _e3393 = phi_4110_;
            if (_e3165 > 0f) {
                if (_e3165 < 1f) {
                    phi_4119_ = _e3165;
                } else {
                    phi_4119_ = 1f;
                }
                let _e3397 = phi_4119_;
                phi_4120_ = _e3397;
            } else {
                phi_4120_ = 0f;
            }
            let _e3399 = phi_4120_;
            if (_e3167 > 0f) {
                if (_e3167 < 1f) {
                    phi_4130_ = _e3167;
                } else {
                    phi_4130_ = 1f;
                }
                let _e3404 = phi_4130_;
                phi_4131_ = _e3404;
            } else {
                phi_4131_ = 0f;
            }
            let _e3406 = phi_4131_;
            if (_e3169 > 0f) {
                if (_e3169 < 1f) {
                    phi_4141_ = _e3169;
                } else {
                    phi_4141_ = 1f;
                }
                let _e3411 = phi_4141_;
                phi_4142_ = _e3411;
            } else {
                phi_4142_ = 0f;
            }
            let _e3413 = phi_4142_;
            let _e3416 = ((sqrt(_e3399) * 255f) + 0.5f);
            let _e3425 = ((sqrt(_e3406) * 255f) + 0.5f);
            let _e3437 = ((sqrt(_e3413) * 255f) + 0.5f);
            phi_4177_ = abi_Sample(vec3<f32>(_e2972, _e2973, _e2974), _e3171, _e3064, _e3176, _e3393, ((select(select(u32(_e3416), 0u, (_e3416 < bitcast<f32>(0u))), 4294967295u, (_e3416 > bitcast<f32>(1333788671u))) | (select(select(u32(_e3425), 0u, (_e3425 < bitcast<f32>(0u))), 4294967295u, (_e3425 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e3437), 0u, (_e3437 < bitcast<f32>(0u))), 4294967295u, (_e3437 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_4177_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e3451 = phi_4177_;
        if (_e100.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e100.shift)] = _e3451;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_instanced_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
