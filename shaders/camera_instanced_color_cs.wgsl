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
var<storage> color_texels: type_13;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_mask_LightPlace {
    var phi_218_: lt_mask_LightPlace;
    var phi_219_: bool;
    var phi_220_: lt_mask_LightPlace;
    var phi_221_: bool;
    var phi_226_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_218_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_219_ = false;
        } else {
            phi_218_ = lt_mask_LightPlace();
            phi_219_ = true;
        }
        let _e82 = phi_218_;
        let _e84 = phi_219_;
        phi_220_ = _e82;
        phi_221_ = _e84;
    } else {
        phi_220_ = lt_mask_LightPlace();
        phi_221_ = true;
    }
    let _e86 = phi_220_;
    let _e88 = phi_221_;
    if _e88 {
        phi_226_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_226_ = _e86;
    }
    let _e93 = phi_226_;
    return lt_mask_LightPlace(_e93.word, _e93.shift);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_241_: bool;
    var phi_245_: f32;

    if (param_3 != param_3) {
        phi_241_ = true;
    } else {
        let _e72 = (param_4 >= param_3);
        if _e72 {
        }
        phi_241_ = _e72;
    }
    let _e74 = phi_241_;
    if _e74 {
        phi_245_ = param_4;
    } else {
        phi_245_ = param_3;
    }
    let _e76 = phi_245_;
    return _e76;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_257_: bool;
    var phi_261_: f32;

    if (param_5 != param_5) {
        phi_257_ = true;
    } else {
        let _e72 = (param_6 <= param_5);
        if _e72 {
        }
        phi_257_ = _e72;
    }
    let _e74 = phi_257_;
    if _e74 {
        phi_261_ = param_6;
    } else {
        phi_261_ = param_5;
    }
    let _e76 = phi_261_;
    return _e76;
}

fn _lt_shaders_texture_TextureView_quad(param_7: ptr<function, texture_TextureView>, param_8: f32, param_9: f32) -> texture_TexelQuad {
    var phi_303_: f32;
    var phi_308_: f32;
    var phi_309_: bool;
    var phi_310_: f32;
    var phi_311_: bool;
    var phi_315_: f32;
    var phi_341_: f32;
    var phi_346_: f32;
    var phi_347_: bool;
    var phi_348_: f32;
    var phi_349_: bool;
    var phi_353_: f32;
    var phi_361_: f32;
    var phi_362_: f32;
    var phi_363_: f32;
    var phi_372_: f32;
    var phi_373_: f32;
    var phi_391_: u32;
    var phi_405_: u32;
    var phi_412_: u32;
    var phi_417_: u32;
    var phi_423_: u32;
    var phi_428_: u32;
    var phi_430_: texture_Axis;
    var phi_458_: f32;
    var phi_463_: f32;
    var phi_464_: bool;
    var phi_465_: f32;
    var phi_466_: bool;
    var phi_470_: f32;
    var phi_496_: f32;
    var phi_501_: f32;
    var phi_502_: bool;
    var phi_503_: f32;
    var phi_504_: bool;
    var phi_508_: f32;
    var phi_516_: f32;
    var phi_517_: f32;
    var phi_518_: f32;
    var phi_527_: f32;
    var phi_528_: f32;
    var phi_546_: u32;
    var phi_560_: u32;
    var phi_567_: u32;
    var phi_572_: u32;
    var phi_578_: u32;
    var phi_583_: u32;
    var phi_585_: texture_Axis;

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
                phi_303_ = 1f;
            } else {
                phi_303_ = 0f;
            }
            let _e103 = phi_303_;
            if (param_8 < 8388608f) {
                phi_308_ = (_e100 - _e103);
                phi_309_ = false;
            } else {
                phi_308_ = f32();
                phi_309_ = true;
            }
            let _e106 = phi_308_;
            let _e108 = phi_309_;
            phi_310_ = _e106;
            phi_311_ = _e108;
        } else {
            phi_310_ = f32();
            phi_311_ = true;
        }
        let _e110 = phi_310_;
        let _e112 = phi_311_;
        if _e112 {
            phi_315_ = param_8;
        } else {
            phi_315_ = _e110;
        }
        let _e114 = phi_315_;
        phi_363_ = (param_8 - _e114);
    } else {
        if (_e87 == 1u) {
            let _e117 = (param_8 * 0.5f);
            if (_e117 > -8388608f) {
                let _e129 = f32(select(0i, select(select(i32(_e117), i32(-2147483648), (_e117 < bitcast<f32>(3472883712u))), 2147483647i, (_e117 > bitcast<f32>(1325400063u))), (_e117 == _e117)));
                if (_e129 > _e117) {
                    phi_341_ = 1f;
                } else {
                    phi_341_ = 0f;
                }
                let _e132 = phi_341_;
                if (_e117 < 8388608f) {
                    phi_346_ = (_e129 - _e132);
                    phi_347_ = false;
                } else {
                    phi_346_ = f32();
                    phi_347_ = true;
                }
                let _e135 = phi_346_;
                let _e137 = phi_347_;
                phi_348_ = _e135;
                phi_349_ = _e137;
            } else {
                phi_348_ = f32();
                phi_349_ = true;
            }
            let _e139 = phi_348_;
            let _e141 = phi_349_;
            if _e141 {
                phi_353_ = _e117;
            } else {
                phi_353_ = _e139;
            }
            let _e143 = phi_353_;
            let _e145 = (param_8 - (2f * _e143));
            if (_e145 > 1f) {
                phi_361_ = (2f - _e145);
            } else {
                phi_361_ = _e145;
            }
            let _e149 = phi_361_;
            phi_362_ = _e149;
        } else {
            phi_362_ = param_8;
        }
        let _e151 = phi_362_;
        phi_363_ = _e151;
    }
    let _e153 = phi_363_;
    if (_e153 > 0f) {
        if (_e153 < 1f) {
            phi_372_ = _e153;
        } else {
            phi_372_ = 1f;
        }
        let _e157 = phi_372_;
        phi_373_ = _e157;
    } else {
        phi_373_ = 0f;
    }
    let _e159 = phi_373_;
    let _e160 = (_e74 - 1u);
    let _e162 = (_e159 * f32(_e74));
    if _e82 {
        let _e169 = select(select(u32(_e162), 0u, (_e162 < bitcast<f32>(0u))), 4294967295u, (_e162 > bitcast<f32>(1333788671u)));
        if (_e160 < _e169) {
            phi_391_ = _e160;
        } else {
            phi_391_ = _e169;
        }
        let _e172 = phi_391_;
        phi_430_ = texture_Axis(_e172, _e172, 0f);
    } else {
        let _e174 = (_e162 + 0.5f);
        let _e181 = select(select(u32(_e174), 0u, (_e174 < bitcast<f32>(0u))), 4294967295u, (_e174 > bitcast<f32>(1333788671u)));
        if (_e74 < _e181) {
            phi_405_ = _e74;
        } else {
            phi_405_ = _e181;
        }
        let _e184 = phi_405_;
        if (_e87 == 0u) {
            phi_412_ = _e160;
        } else {
            phi_412_ = 0u;
        }
        let _e189 = phi_412_;
        if (_e87 == 0u) {
            phi_417_ = 0u;
        } else {
            phi_417_ = _e160;
        }
        let _e192 = phi_417_;
        if (_e184 == 0u) {
            phi_423_ = _e189;
        } else {
            phi_423_ = (_e184 - 1u);
        }
        let _e196 = phi_423_;
        if (_e184 > _e160) {
            phi_428_ = _e192;
        } else {
            phi_428_ = _e184;
        }
        let _e199 = phi_428_;
        phi_430_ = texture_Axis(_e196, _e199, (_e174 - f32(_e184)));
    }
    let _e202 = phi_430_;
    let _e204 = (*param_7).flags;
    let _e207 = ((_e204 >> bitcast<u32>(6u)) & 3u);
    if (_e207 == 0u) {
        if (param_9 > -8388608f) {
            let _e220 = f32(select(0i, select(select(i32(param_9), i32(-2147483648), (param_9 < bitcast<f32>(3472883712u))), 2147483647i, (param_9 > bitcast<f32>(1325400063u))), (param_9 == param_9)));
            if (_e220 > param_9) {
                phi_458_ = 1f;
            } else {
                phi_458_ = 0f;
            }
            let _e223 = phi_458_;
            if (param_9 < 8388608f) {
                phi_463_ = (_e220 - _e223);
                phi_464_ = false;
            } else {
                phi_463_ = f32();
                phi_464_ = true;
            }
            let _e226 = phi_463_;
            let _e228 = phi_464_;
            phi_465_ = _e226;
            phi_466_ = _e228;
        } else {
            phi_465_ = f32();
            phi_466_ = true;
        }
        let _e230 = phi_465_;
        let _e232 = phi_466_;
        if _e232 {
            phi_470_ = param_9;
        } else {
            phi_470_ = _e230;
        }
        let _e234 = phi_470_;
        phi_518_ = (param_9 - _e234);
    } else {
        if (_e207 == 1u) {
            let _e237 = (param_9 * 0.5f);
            if (_e237 > -8388608f) {
                let _e249 = f32(select(0i, select(select(i32(_e237), i32(-2147483648), (_e237 < bitcast<f32>(3472883712u))), 2147483647i, (_e237 > bitcast<f32>(1325400063u))), (_e237 == _e237)));
                if (_e249 > _e237) {
                    phi_496_ = 1f;
                } else {
                    phi_496_ = 0f;
                }
                let _e252 = phi_496_;
                if (_e237 < 8388608f) {
                    phi_501_ = (_e249 - _e252);
                    phi_502_ = false;
                } else {
                    phi_501_ = f32();
                    phi_502_ = true;
                }
                let _e255 = phi_501_;
                let _e257 = phi_502_;
                phi_503_ = _e255;
                phi_504_ = _e257;
            } else {
                phi_503_ = f32();
                phi_504_ = true;
            }
            let _e259 = phi_503_;
            let _e261 = phi_504_;
            if _e261 {
                phi_508_ = _e237;
            } else {
                phi_508_ = _e259;
            }
            let _e263 = phi_508_;
            let _e265 = (param_9 - (2f * _e263));
            if (_e265 > 1f) {
                phi_516_ = (2f - _e265);
            } else {
                phi_516_ = _e265;
            }
            let _e269 = phi_516_;
            phi_517_ = _e269;
        } else {
            phi_517_ = param_9;
        }
        let _e271 = phi_517_;
        phi_518_ = _e271;
    }
    let _e273 = phi_518_;
    if (_e273 > 0f) {
        if (_e273 < 1f) {
            phi_527_ = _e273;
        } else {
            phi_527_ = 1f;
        }
        let _e277 = phi_527_;
        phi_528_ = _e277;
    } else {
        phi_528_ = 0f;
    }
    let _e279 = phi_528_;
    let _e280 = (_e78 - 1u);
    let _e282 = (_e279 * f32(_e78));
    if _e82 {
        let _e289 = select(select(u32(_e282), 0u, (_e282 < bitcast<f32>(0u))), 4294967295u, (_e282 > bitcast<f32>(1333788671u)));
        if (_e280 < _e289) {
            phi_546_ = _e280;
        } else {
            phi_546_ = _e289;
        }
        let _e292 = phi_546_;
        phi_585_ = texture_Axis(_e292, _e292, 0f);
    } else {
        let _e294 = (_e282 + 0.5f);
        let _e301 = select(select(u32(_e294), 0u, (_e294 < bitcast<f32>(0u))), 4294967295u, (_e294 > bitcast<f32>(1333788671u)));
        if (_e78 < _e301) {
            phi_560_ = _e78;
        } else {
            phi_560_ = _e301;
        }
        let _e304 = phi_560_;
        if (_e207 == 0u) {
            phi_567_ = _e280;
        } else {
            phi_567_ = 0u;
        }
        let _e309 = phi_567_;
        if (_e207 == 0u) {
            phi_572_ = 0u;
        } else {
            phi_572_ = _e280;
        }
        let _e312 = phi_572_;
        if (_e304 == 0u) {
            phi_578_ = _e309;
        } else {
            phi_578_ = (_e304 - 1u);
        }
        let _e316 = phi_578_;
        if (_e304 > _e280) {
            phi_583_ = _e312;
        } else {
            phi_583_ = _e304;
        }
        let _e319 = phi_583_;
        phi_585_ = texture_Axis(_e316, _e319, (_e294 - f32(_e304)));
    }
    let _e322 = phi_585_;
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
    var phi_644_: f32;

    if (param_12 > param_13) {
        phi_644_ = param_12;
    } else {
        phi_644_ = param_13;
    }
    let _e73 = phi_644_;
    return _e73;
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var local_2: lt_bvh_traverse_Stack;
    var phi_769_: bool;
    var phi_770_: bool;
    var phi_771_: bool;
    var phi_772_: bool;
    var phi_776_: bool;
    var phi_789_: bool;
    var phi_790_: bool;
    var phi_791_: bool;
    var phi_792_: bool;
    var phi_796_: bool;
    var phi_809_: bool;
    var phi_810_: bool;
    var phi_811_: bool;
    var phi_815_: bool;
    var phi_816_: bool;
    var phi_817_: bool;
    var phi_818_: bool;
    var phi_819_: bool;
    var phi_823_: bool;
    var phi_899_: f32;
    var phi_906_: f32;
    var phi_914_: f32;
    var phi_921_: f32;
    var phi_929_: f32;
    var phi_936_: f32;
    var phi_959_: f32;
    var phi_964_: f32;
    var phi_969_: f32;
    var phi_974_: f32;
    var phi_979_: f32;
    var phi_998_: u32;
    var phi_1003_: u32;
    var phi_1008_: u32;
    var phi_1122_: bool;
    var phi_1123_: bool;
    var phi_1154_: u32;
    var phi_1156_: u32;
    var phi_1159_: lt_bvh_Hit;
    var phi_1244_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1271_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1298_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1304_: u32;
    var phi_1307_: u32;
    var phi_1321_: u32;
    var phi_1331_: u32;
    var phi_1341_: u32;
    var phi_1359_: u32;
    var phi_1369_: u32;
    var phi_1379_: u32;
    var phi_1415_: u32;
    var phi_1428_: u32;
    var phi_1433_: u32;
    var phi_1434_: u32;
    var phi_1435_: u32;
    var phi_1305_: u32;
    var phi_1308_: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_1493_: u32;
    var phi_1496_: lt_bvh_Hit;
    var phi_1551_: f32;
    var phi_1556_: f32;
    var phi_1561_: f32;
    var phi_1569_: f32;
    var phi_1574_: f32;
    var phi_1579_: f32;
    var phi_1711_: bool;
    var phi_1712_: bool;
    var phi_1713_: bool;
    var phi_1714_: bool;
    var phi_1718_: bool;
    var phi_1731_: bool;
    var phi_1732_: bool;
    var phi_1733_: bool;
    var phi_1734_: bool;
    var phi_1738_: bool;
    var phi_1751_: bool;
    var phi_1752_: bool;
    var phi_1753_: bool;
    var phi_1757_: bool;
    var phi_1758_: bool;
    var phi_1759_: bool;
    var phi_1760_: bool;
    var phi_1761_: bool;
    var phi_1765_: bool;
    var phi_1835_: f32;
    var phi_1842_: f32;
    var phi_1849_: f32;
    var phi_1856_: f32;
    var phi_1863_: f32;
    var phi_1870_: f32;
    var phi_1887_: f32;
    var phi_1892_: f32;
    var phi_1897_: f32;
    var phi_1902_: f32;
    var phi_1907_: f32;
    var phi_1933_: bool;
    var phi_1934_: bool;
    var phi_1942_: u32;
    var phi_1943_: u32;
    var phi_1954_: vec3<f32>;
    var phi_1955_: vec3<f32>;
    var phi_1968_: u32;
    var phi_1973_: u32;
    var phi_1978_: u32;
    var phi_2092_: bool;
    var phi_2093_: bool;
    var phi_2124_: u32;
    var phi_2126_: lt_bvh_Hit;
    var phi_2129_: u32;
    var phi_2210_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2237_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2264_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2270_: u32;
    var phi_2273_: u32;
    var phi_2287_: u32;
    var phi_2297_: u32;
    var phi_2307_: u32;
    var phi_2325_: u32;
    var phi_2335_: u32;
    var phi_2345_: u32;
    var phi_2381_: u32;
    var phi_2394_: u32;
    var phi_2399_: u32;
    var phi_2400_: u32;
    var phi_2401_: u32;
    var phi_2271_: u32;
    var phi_2274_: u32;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_2459_: lt_bvh_Hit;
    var phi_2462_: u32;
    var phi_2506_: vec3<f32>;
    var phi_2507_: vec3<f32>;
    var phi_2536_: vec3<f32>;
    var phi_2537_: vec3<f32>;
    var phi_2566_: vec3<f32>;
    var phi_2567_: vec3<f32>;
    var phi_2585_: bool;
    var phi_2586_: bool;
    var phi_2590_: f32;
    var phi_2591_: f32;
    var phi_2592_: f32;
    var phi_2593_: f32;
    var phi_2601_: f32;
    var phi_2611_: bool;
    var phi_2612_: bool;
    var phi_2616_: f32;
    var phi_2617_: f32;
    var phi_2618_: f32;
    var phi_2619_: f32;
    var phi_2627_: f32;
    var phi_2637_: bool;
    var phi_2638_: bool;
    var phi_2642_: f32;
    var phi_2643_: f32;
    var phi_2644_: f32;
    var phi_2645_: f32;
    var phi_2653_: f32;
    var phi_2668_: f32;
    var phi_2669_: bool;
    var phi_2670_: f32;
    var phi_2671_: bool;
    var phi_2672_: f32;
    var phi_2673_: bool;
    var phi_2691_: f32;
    var phi_2692_: bool;
    var phi_2693_: bool;
    var phi_2694_: f32;
    var phi_2695_: bool;
    var phi_2696_: bool;
    var phi_2700_: bool;
    var phi_2701_: f32;
    var phi_2702_: bool;
    var phi_2730_: vec3<f32>;
    var phi_2731_: vec3<f32>;
    var phi_2756_: vec3<f32>;
    var phi_2757_: vec3<f32>;
    var phi_2782_: vec3<f32>;
    var phi_2783_: vec3<f32>;
    var phi_2839_: f32;
    var phi_2848_: f32;
    var phi_2857_: f32;
    var phi_2866_: f32;
    var phi_2873_: f32;
    var phi_2880_: f32;
    var phi_2893_: f32;
    var phi_2902_: f32;
    var phi_2911_: f32;
    var phi_2920_: f32;
    var phi_2927_: f32;
    var phi_2934_: f32;
    var phi_2951_: f32;
    var phi_2956_: f32;
    var phi_2961_: f32;
    var phi_2969_: f32;
    var phi_2974_: f32;
    var phi_2979_: f32;
    var phi_2991_: f32;
    var phi_2996_: f32;
    var phi_3001_: f32;
    var phi_3006_: f32;
    var phi_3011_: lt_bvh_triangle_Intersection;
    var phi_3012_: bool;
    var phi_3013_: lt_bvh_triangle_Intersection;
    var phi_3014_: bool;
    var phi_3018_: lt_bvh_triangle_Intersection;
    var phi_3019_: bool;
    var phi_3020_: lt_bvh_triangle_Intersection;
    var phi_3021_: bool;
    var phi_3022_: bool;
    var phi_3026_: bool;
    var phi_3030_: lt_bvh_triangle_Intersection;
    var phi_3068_: bool;
    var phi_3069_: bool;
    var phi_3070_: bool;
    var phi_3071_: bool;
    var phi_3072_: bool;
    var phi_3073_: bool;
    var phi_3077_: bool;
    var phi_3078_: bool;
    var phi_3092_: bool;
    var phi_3100_: lt_bvh_Hit;
    var phi_3101_: lt_bvh_Hit;
    var phi_3102_: lt_bvh_Hit;
    var phi_3103_: lt_bvh_Hit;
    var phi_2460_: lt_bvh_Hit;
    var phi_2463_: u32;
    var phi_3104_: bool;
    var phi_3143_: bool;
    var phi_3144_: bool;
    var phi_3175_: u32;
    var phi_2127_: lt_bvh_Hit;
    var phi_2130_: u32;
    var phi_3176_: lt_bvh_Hit;
    var phi_3177_: lt_bvh_Hit;
    var phi_3178_: bool;
    var phi_3182_: lt_bvh_Hit;
    var phi_3183_: lt_bvh_Hit;
    var phi_3184_: lt_bvh_Hit;
    var phi_3185_: lt_bvh_Hit;
    var phi_1494_: u32;
    var phi_1497_: lt_bvh_Hit;
    var phi_3186_: bool;
    var phi_3225_: bool;
    var phi_3226_: bool;
    var phi_3257_: u32;
    var phi_1157_: u32;
    var phi_1160_: lt_bvh_Hit;
    var phi_3258_: lt_bvh_Hit;
    var phi_3259_: lt_bvh_Hit;
    var phi_3260_: bool;
    var phi_3264_: lt_bvh_Hit;
    var phi_3451_: f32;
    var phi_3456_: f32;
    var phi_3461_: f32;
    var phi_3469_: f32;
    var phi_3474_: f32;
    var phi_3479_: f32;
    var phi_3543_: vec3<f32>;
    var phi_3786_: vec3<f32>;
    var phi_3801_: u32;
    var phi_3828_: f32;
    var phi_3835_: f32;
    var phi_3842_: f32;
    var phi_3877_: f32;
    var phi_3884_: f32;
    var phi_3891_: f32;
    var phi_3929_: f32;
    var phi_3936_: f32;
    var phi_3943_: f32;
    var phi_4029_: vec3<f32>;
    var phi_4030_: vec3<f32>;
    var phi_4031_: vec3<f32>;
    var phi_4040_: f32;
    var phi_4041_: f32;
    var phi_4051_: f32;
    var phi_4052_: f32;
    var phi_4062_: f32;
    var phi_4063_: f32;
    var phi_4098_: abi_Sample;
    var local_9: lt_bvh_Hit;
    var local_10: lt_bvh_Hit;
    var local_11: lt_bvh_Hit;
    var local_12: lt_bvh_Hit;

    let _e72 = id_1;
    let _e76 = arrayLength((&nodes.member));
    let _e79 = arrayLength((&triangles.member));
    let _e82 = arrayLength((&vertices.member));
    let _e91 = arrayLength((&instances.member));
    let _e94 = arrayLength((&color_texels.member));
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
                phi_769_ = (abs(_e157.origin.z) < 1000000000000000f);
                phi_770_ = false;
            } else {
                phi_769_ = bool();
                phi_770_ = true;
            }
            let _e178 = phi_769_;
            let _e180 = phi_770_;
            phi_771_ = _e178;
            phi_772_ = _e180;
        } else {
            phi_771_ = bool();
            phi_772_ = true;
        }
        let _e182 = phi_771_;
        let _e184 = phi_772_;
        if _e184 {
            phi_776_ = false;
        } else {
            phi_776_ = _e182;
        }
        let _e186 = phi_776_;
        if _e186 {
            if (_e162 < 1000000000000000f) {
                if (_e164 < 1000000000000000f) {
                    phi_789_ = (_e166 < 1000000000000000f);
                    phi_790_ = false;
                } else {
                    phi_789_ = bool();
                    phi_790_ = true;
                }
                let _e191 = phi_789_;
                let _e193 = phi_790_;
                phi_791_ = _e191;
                phi_792_ = _e193;
            } else {
                phi_791_ = bool();
                phi_792_ = true;
            }
            let _e195 = phi_791_;
            let _e197 = phi_792_;
            if _e197 {
                phi_796_ = false;
            } else {
                phi_796_ = _e195;
            }
            let _e199 = phi_796_;
            if _e199 {
                if (_e162 > 0f) {
                    phi_810_ = bool();
                    phi_811_ = true;
                } else {
                    let _e201 = (_e164 > 0f);
                    if _e201 {
                        phi_809_ = bool();
                    } else {
                        phi_809_ = (_e166 > 0f);
                    }
                    let _e204 = phi_809_;
                    phi_810_ = _e204;
                    phi_811_ = _e201;
                }
                let _e206 = phi_810_;
                let _e208 = phi_811_;
                if _e208 {
                    phi_815_ = true;
                } else {
                    phi_815_ = _e206;
                }
                let _e210 = phi_815_;
                phi_816_ = _e210;
                phi_817_ = false;
            } else {
                phi_816_ = bool();
                phi_817_ = true;
            }
            let _e212 = phi_816_;
            let _e214 = phi_817_;
            phi_818_ = _e212;
            phi_819_ = _e214;
        } else {
            phi_818_ = bool();
            phi_819_ = true;
        }
        let _e216 = phi_818_;
        let _e218 = phi_819_;
        if _e218 {
            phi_823_ = false;
        } else {
            phi_823_ = _e216;
        }
        let _e220 = phi_823_;
        if _e220 {
            let _e221 = (_e106 >= _e76);
            if _e221 {
                phi_3258_ = lt_bvh_Hit();
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
                    phi_899_ = _e292;
                } else {
                    phi_899_ = abs(_e157.direction.x);
                }
                let _e298 = phi_899_;
                if (_e157.direction.x < 0f) {
                    phi_906_ = (-1f / _e298);
                } else {
                    phi_906_ = (1f / _e298);
                }
                let _e303 = phi_906_;
                if (abs(_e157.direction.y) < _e292) {
                    phi_914_ = _e292;
                } else {
                    phi_914_ = abs(_e157.direction.y);
                }
                let _e309 = phi_914_;
                if (_e157.direction.y < 0f) {
                    phi_921_ = (-1f / _e309);
                } else {
                    phi_921_ = (1f / _e309);
                }
                let _e314 = phi_921_;
                if (abs(_e157.direction.z) < _e292) {
                    phi_929_ = _e292;
                } else {
                    phi_929_ = abs(_e157.direction.z);
                }
                let _e320 = phi_929_;
                if (_e157.direction.z < 0f) {
                    phi_936_ = (-1f / _e320);
                } else {
                    phi_936_ = (1f / _e320);
                }
                let _e325 = phi_936_;
                let _e332 = abs((bitcast<f32>(_e227) - _e157.origin.x));
                let _e333 = abs((bitcast<f32>(_e231) - _e157.origin.y));
                let _e334 = abs((bitcast<f32>(_e235) - _e157.origin.z));
                let _e341 = abs(((bitcast<f32>(_e239) + (bitcast<f32>((((_e251 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e157.origin.x));
                let _e342 = abs(((bitcast<f32>(_e243) + (bitcast<f32>((((_e251 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e157.origin.y));
                let _e343 = abs(((bitcast<f32>(_e247) + (bitcast<f32>((((_e251 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e157.origin.z));
                if (_e332 > _e341) {
                    phi_959_ = _e332;
                } else {
                    phi_959_ = _e341;
                }
                let _e346 = phi_959_;
                if (_e333 > _e342) {
                    phi_964_ = _e333;
                } else {
                    phi_964_ = _e342;
                }
                let _e349 = phi_964_;
                if (_e334 > _e343) {
                    phi_969_ = _e334;
                } else {
                    phi_969_ = _e343;
                }
                let _e352 = phi_969_;
                if (_e346 > _e349) {
                    phi_974_ = _e346;
                } else {
                    phi_974_ = _e349;
                }
                let _e355 = phi_974_;
                if (_e355 > _e352) {
                    phi_979_ = _e355;
                } else {
                    phi_979_ = _e352;
                }
                let _e358 = phi_979_;
                let _e362 = (_e358 * 0.0000019073486f);
                let _e363 = (abs(_e303) * _e362);
                let _e364 = (abs(_e314) * _e362);
                let _e365 = (abs(_e325) * _e362);
                let _e369 = (_e358 * 0.0000009536743f);
                let _e370 = (abs(_e303) * _e369);
                let _e371 = (abs(_e314) * _e369);
                let _e372 = (abs(_e325) * _e369);
                if (_e303 < 0f) {
                    phi_998_ = 0u;
                } else {
                    phi_998_ = 1u;
                }
                let _e375 = phi_998_;
                if (_e314 < 0f) {
                    phi_1003_ = 0u;
                } else {
                    phi_1003_ = 2u;
                }
                let _e378 = phi_1003_;
                if (_e325 < 0f) {
                    phi_1008_ = 0u;
                } else {
                    phi_1008_ = 4u;
                }
                let _e381 = phi_1008_;
                let _e383 = ((_e375 | _e378) | _e381);
                let _e384 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e106, 2147483648u);
                local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e384.first[0], _e384.first[1], _e384.first[2], _e384.first[3], _e384.first[4], _e384.first[5], _e384.first[6], _e384.first[7], _e384.first[8], _e384.first[9], _e384.first[10], _e384.first[11], _e384.first[12], _e384.first[13], _e384.first[14], _e384.first[15], _e384.first[16], _e384.first[17], _e384.first[18], _e384.first[19], _e384.first[20], _e384.first[21], _e384.first[22], _e384.first[23], _e384.first[24], _e384.first[25], _e384.first[26], _e384.first[27], _e384.first[28], _e384.first[29], _e384.first[30], _e384.first[31]), array<u32, 32>(_e384.mask[0], _e384.mask[1], _e384.mask[2], _e384.mask[3], _e384.mask[4], _e384.mask[5], _e384.mask[6], _e384.mask[7], _e384.mask[8], _e384.mask[9], _e384.mask[10], _e384.mask[11], _e384.mask[12], _e384.mask[13], _e384.mask[14], _e384.mask[15], _e384.mask[16], _e384.mask[17], _e384.mask[18], _e384.mask[19], _e384.mask[20], _e384.mask[21], _e384.mask[22], _e384.mask[23], _e384.mask[24], _e384.mask[25], _e384.mask[26], _e384.mask[27], _e384.mask[28], _e384.mask[29], _e384.mask[30], _e384.mask[31]), _e384.len, _e384.group, _e384.group_mask);
                let _e458 = local_2.group_mask;
                if ((_e458 & 4278190080u) == 0u) {
                    let _e462 = local_2.len;
                    if (_e462 == 0u) {
                        phi_1122_ = false;
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
                        phi_1122_ = true;
                    }
                    let _e485 = phi_1122_;
                    phi_1123_ = _e485;
                } else {
                    phi_1123_ = true;
                }
                let _e487 = phi_1123_;
                if _e487 {
                    let _e489 = local_2.group_mask;
                    let _e495 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e489)), 32u, (_e489 == 0u)));
                    let _e499 = local_2.group_mask;
                    let _e513 = local_2.group_mask;
                    local_2.group_mask = (_e513 & ~((1u << bitcast<u32>((_e495 & 31u)))));
                    let _e516 = local_2.group;
                    phi_1154_ = (_e516 + countOneBits(((_e499 & ~((4294967295u << bitcast<u32>((((_e495 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1154_ = 4294967295u;
                }
                let _e519 = phi_1154_;
                phi_1156_ = _e519;
                phi_1159_ = _e159;
                loop {
                    let _e521 = phi_1156_;
                    let _e523 = phi_1159_;
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
                            phi_1244_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e611.unnamed, lt_mask_LightPlace(_e611.unnamed_1.word, _e588.y));
                        } else {
                            let _e627 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e588.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e633 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e627.unnamed.word, _e588.y), _e627.unnamed_1);
                            let _e639 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e633.unnamed, lt_mask_LightPlace(_e588.z, _e633.unnamed_1.shift));
                            phi_1244_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e639.unnamed, lt_mask_LightPlace(_e639.unnamed_1.word, _e588.w));
                        }
                        let _e647 = phi_1244_;
                        let _e657 = nodes.member[(0u + _e521)].y;
                        if (_e314 < 0f) {
                            let _e668 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e657.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e674 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e668.unnamed.word, _e657.w), _e668.unnamed_1);
                            let _e680 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e674.unnamed, lt_mask_LightPlace(_e657.x, _e674.unnamed_1.shift));
                            phi_1271_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e680.unnamed, lt_mask_LightPlace(_e680.unnamed_1.word, _e657.y));
                        } else {
                            let _e696 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e657.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e702 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e696.unnamed.word, _e657.y), _e696.unnamed_1);
                            let _e708 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e702.unnamed, lt_mask_LightPlace(_e657.z, _e702.unnamed_1.shift));
                            phi_1271_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e708.unnamed, lt_mask_LightPlace(_e708.unnamed_1.word, _e657.w));
                        }
                        let _e716 = phi_1271_;
                        let _e726 = nodes.member[(0u + _e521)].z;
                        if (_e325 < 0f) {
                            let _e737 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e726.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e743 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e737.unnamed.word, _e726.w), _e737.unnamed_1);
                            let _e749 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e743.unnamed, lt_mask_LightPlace(_e726.x, _e743.unnamed_1.shift));
                            phi_1298_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e749.unnamed, lt_mask_LightPlace(_e749.unnamed_1.word, _e726.y));
                        } else {
                            let _e765 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e726.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e771 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e765.unnamed.word, _e726.y), _e765.unnamed_1);
                            let _e777 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e771.unnamed, lt_mask_LightPlace(_e726.z, _e771.unnamed_1.shift));
                            phi_1298_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e777.unnamed, lt_mask_LightPlace(_e777.unnamed_1.word, _e726.w));
                        }
                        let _e785 = phi_1298_;
                        phi_1304_ = 0u;
                        phi_1307_ = 0u;
                        loop {
                            let _e795 = phi_1304_;
                            let _e797 = phi_1307_;
                            local_3 = _e797;
                            local_4 = _e797;
                            local_5 = _e797;
                            let _e798 = (_e795 < 8u);
                            if _e798 {
                                let _e800 = (_e795 >> bitcast<u32>(2i));
                                let _e801 = (_e795 & 3u);
                                if (_e800 == 0u) {
                                    phi_1321_ = _e647.unnamed.word;
                                } else {
                                    phi_1321_ = _e647.unnamed.shift;
                                }
                                let _e804 = phi_1321_;
                                if (_e800 == 0u) {
                                    phi_1331_ = _e716.unnamed.word;
                                } else {
                                    phi_1331_ = _e716.unnamed.shift;
                                }
                                let _e813 = phi_1331_;
                                if (_e800 == 0u) {
                                    phi_1341_ = _e785.unnamed.word;
                                } else {
                                    phi_1341_ = _e785.unnamed.shift;
                                }
                                let _e822 = phi_1341_;
                                let _e835 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e804 >> bitcast<u32>(((_e801 * 8u) & 31u))) & 255u)) * _e557) + (_e578 - _e363)), ((f32(((_e813 >> bitcast<u32>(((_e801 * 8u) & 31u))) & 255u)) * _e558) + (_e579 - _e364)));
                                let _e836 = core_intrinsics_maximum_number_nsz_f32_(_e835, ((f32(((_e822 >> bitcast<u32>(((_e801 * 8u) & 31u))) & 255u)) * _e559) + (_e580 - _e365)));
                                if (_e800 == 0u) {
                                    phi_1359_ = _e647.unnamed_1.word;
                                } else {
                                    phi_1359_ = _e647.unnamed_1.shift;
                                }
                                let _e839 = phi_1359_;
                                if (_e800 == 0u) {
                                    phi_1369_ = _e716.unnamed_1.word;
                                } else {
                                    phi_1369_ = _e716.unnamed_1.shift;
                                }
                                let _e848 = phi_1369_;
                                if (_e800 == 0u) {
                                    phi_1379_ = _e785.unnamed_1.word;
                                } else {
                                    phi_1379_ = _e785.unnamed_1.shift;
                                }
                                let _e857 = phi_1379_;
                                let _e870 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e839 >> bitcast<u32>(((_e801 * 8u) & 31u))) & 255u)) * _e557) + (_e578 + _e363)), ((f32(((_e848 >> bitcast<u32>(((_e801 * 8u) & 31u))) & 255u)) * _e558) + (_e579 + _e364)));
                                let _e871 = core_intrinsics_minimum_number_nsz_f32_(_e870, ((f32(((_e857 >> bitcast<u32>(((_e801 * 8u) & 31u))) & 255u)) * _e559) + (_e580 + _e365)));
                                if (_e836 <= _e871) {
                                    if (_e836 <= _e523.t) {
                                        if (_e871 >= _e157.tmin) {
                                            if (_e800 == 0u) {
                                                let _e878 = nodes.member[(0u + _e521)].links[2u];
                                                phi_1415_ = _e878;
                                            } else {
                                                let _e881 = nodes.member[(0u + _e521)].links[3u];
                                                phi_1415_ = _e881;
                                            }
                                            let _e883 = phi_1415_;
                                            let _e888 = ((_e883 >> bitcast<u32>(((_e801 * 8u) & 31u))) & 255u);
                                            let _e889 = (_e888 & 31u);
                                            if (_e889 >= 24u) {
                                                phi_1428_ = (24u + ((_e889 - 24u) ^ _e383));
                                            } else {
                                                phi_1428_ = _e889;
                                            }
                                            let _e895 = phi_1428_;
                                            phi_1433_ = (_e797 | ((_e888 >> bitcast<u32>(5i)) << bitcast<u32>((_e895 & 31u))));
                                        } else {
                                            phi_1433_ = _e797;
                                        }
                                        let _e903 = phi_1433_;
                                        phi_1434_ = _e903;
                                    } else {
                                        phi_1434_ = _e797;
                                    }
                                    let _e905 = phi_1434_;
                                    phi_1435_ = _e905;
                                } else {
                                    phi_1435_ = _e797;
                                }
                                let _e907 = phi_1435_;
                                phi_1305_ = (_e795 + 1u);
                                phi_1308_ = _e907;
                            } else {
                                phi_1305_ = u32();
                                phi_1308_ = u32();
                            }
                            let _e910 = phi_1305_;
                            let _e912 = phi_1308_;
                            continue;
                            continuing {
                                phi_1304_ = _e910;
                                phi_1307_ = _e912;
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
                        phi_1493_ = (_e961 & 16777215u);
                        phi_1496_ = _e523;
                        loop {
                            let _e964 = phi_1493_;
                            let _e966 = phi_1496_;
                            local_11 = _e966;
                            if (_e964 == 0u) {
                                phi_1494_ = u32();
                                phi_1497_ = lt_bvh_Hit();
                                phi_3186_ = false;
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
                                    phi_1551_ = _e993;
                                } else {
                                    phi_1551_ = _e1005;
                                }
                                let _e1010 = phi_1551_;
                                if (_e994 < _e1006) {
                                    phi_1556_ = _e994;
                                } else {
                                    phi_1556_ = _e1006;
                                }
                                let _e1013 = phi_1556_;
                                if (_e995 < _e1007) {
                                    phi_1561_ = _e995;
                                } else {
                                    phi_1561_ = _e1007;
                                }
                                let _e1016 = phi_1561_;
                                if (_e993 > _e1005) {
                                    phi_1569_ = _e993;
                                } else {
                                    phi_1569_ = _e1005;
                                }
                                let _e1022 = phi_1569_;
                                if (_e994 > _e1006) {
                                    phi_1574_ = _e994;
                                } else {
                                    phi_1574_ = _e1006;
                                }
                                let _e1025 = phi_1574_;
                                if (_e995 > _e1007) {
                                    phi_1579_ = _e995;
                                } else {
                                    phi_1579_ = _e1007;
                                }
                                let _e1028 = phi_1579_;
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
                                                    phi_1711_ = (abs(_e1084) < 1000000000000000f);
                                                    phi_1712_ = false;
                                                } else {
                                                    phi_1711_ = bool();
                                                    phi_1712_ = true;
                                                }
                                                let _e1146 = phi_1711_;
                                                let _e1148 = phi_1712_;
                                                phi_1713_ = _e1146;
                                                phi_1714_ = _e1148;
                                            } else {
                                                phi_1713_ = bool();
                                                phi_1714_ = true;
                                            }
                                            let _e1150 = phi_1713_;
                                            let _e1152 = phi_1714_;
                                            if _e1152 {
                                                phi_1718_ = false;
                                            } else {
                                                phi_1718_ = _e1150;
                                            }
                                            let _e1154 = phi_1718_;
                                            if _e1154 {
                                                if (_e1136 < 1000000000000000f) {
                                                    if (_e1137 < 1000000000000000f) {
                                                        phi_1731_ = (_e1138 < 1000000000000000f);
                                                        phi_1732_ = false;
                                                    } else {
                                                        phi_1731_ = bool();
                                                        phi_1732_ = true;
                                                    }
                                                    let _e1159 = phi_1731_;
                                                    let _e1161 = phi_1732_;
                                                    phi_1733_ = _e1159;
                                                    phi_1734_ = _e1161;
                                                } else {
                                                    phi_1733_ = bool();
                                                    phi_1734_ = true;
                                                }
                                                let _e1163 = phi_1733_;
                                                let _e1165 = phi_1734_;
                                                if _e1165 {
                                                    phi_1738_ = false;
                                                } else {
                                                    phi_1738_ = _e1163;
                                                }
                                                let _e1167 = phi_1738_;
                                                if _e1167 {
                                                    if (_e1136 > 0f) {
                                                        phi_1752_ = bool();
                                                        phi_1753_ = true;
                                                    } else {
                                                        let _e1169 = (_e1137 > 0f);
                                                        if _e1169 {
                                                            phi_1751_ = bool();
                                                        } else {
                                                            phi_1751_ = (_e1138 > 0f);
                                                        }
                                                        let _e1172 = phi_1751_;
                                                        phi_1752_ = _e1172;
                                                        phi_1753_ = _e1169;
                                                    }
                                                    let _e1174 = phi_1752_;
                                                    let _e1176 = phi_1753_;
                                                    if _e1176 {
                                                        phi_1757_ = true;
                                                    } else {
                                                        phi_1757_ = _e1174;
                                                    }
                                                    let _e1178 = phi_1757_;
                                                    phi_1758_ = _e1178;
                                                    phi_1759_ = false;
                                                } else {
                                                    phi_1758_ = bool();
                                                    phi_1759_ = true;
                                                }
                                                let _e1180 = phi_1758_;
                                                let _e1182 = phi_1759_;
                                                phi_1760_ = _e1180;
                                                phi_1761_ = _e1182;
                                            } else {
                                                phi_1760_ = bool();
                                                phi_1761_ = true;
                                            }
                                            let _e1184 = phi_1760_;
                                            let _e1186 = phi_1761_;
                                            if _e1186 {
                                                phi_1765_ = false;
                                            } else {
                                                phi_1765_ = _e1184;
                                            }
                                            let _e1188 = phi_1765_;
                                            if _e1188 {
                                                let _e1189 = (_e1133 >= _e76);
                                                if _e1189 {
                                                    phi_3176_ = lt_bvh_Hit();
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
                                                        phi_1835_ = _e1255;
                                                    } else {
                                                        phi_1835_ = abs(_e1102);
                                                    }
                                                    let _e1260 = phi_1835_;
                                                    if (_e1102 < 0f) {
                                                        phi_1842_ = (-1f / _e1260);
                                                    } else {
                                                        phi_1842_ = (1f / _e1260);
                                                    }
                                                    let _e1265 = phi_1842_;
                                                    if (abs(_e1115) < _e1255) {
                                                        phi_1849_ = _e1255;
                                                    } else {
                                                        phi_1849_ = abs(_e1115);
                                                    }
                                                    let _e1270 = phi_1849_;
                                                    if (_e1115 < 0f) {
                                                        phi_1856_ = (-1f / _e1270);
                                                    } else {
                                                        phi_1856_ = (1f / _e1270);
                                                    }
                                                    let _e1275 = phi_1856_;
                                                    if (abs(_e1128) < _e1255) {
                                                        phi_1863_ = _e1255;
                                                    } else {
                                                        phi_1863_ = abs(_e1128);
                                                    }
                                                    let _e1280 = phi_1863_;
                                                    if (_e1128 < 0f) {
                                                        phi_1870_ = (-1f / _e1280);
                                                    } else {
                                                        phi_1870_ = (1f / _e1280);
                                                    }
                                                    let _e1285 = phi_1870_;
                                                    let _e1289 = abs((bitcast<f32>(_e1195) - _e1058));
                                                    let _e1290 = abs((bitcast<f32>(_e1199) - _e1071));
                                                    let _e1291 = abs((bitcast<f32>(_e1203) - _e1084));
                                                    let _e1295 = abs(((bitcast<f32>(_e1207) + (bitcast<f32>((((_e1219 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1058));
                                                    let _e1296 = abs(((bitcast<f32>(_e1211) + (bitcast<f32>((((_e1219 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1071));
                                                    let _e1297 = abs(((bitcast<f32>(_e1215) + (bitcast<f32>((((_e1219 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1084));
                                                    if (_e1289 > _e1295) {
                                                        phi_1887_ = _e1289;
                                                    } else {
                                                        phi_1887_ = _e1295;
                                                    }
                                                    let _e1300 = phi_1887_;
                                                    if (_e1290 > _e1296) {
                                                        phi_1892_ = _e1290;
                                                    } else {
                                                        phi_1892_ = _e1296;
                                                    }
                                                    let _e1303 = phi_1892_;
                                                    if (_e1291 > _e1297) {
                                                        phi_1897_ = _e1291;
                                                    } else {
                                                        phi_1897_ = _e1297;
                                                    }
                                                    let _e1306 = phi_1897_;
                                                    if (_e1300 > _e1303) {
                                                        phi_1902_ = _e1300;
                                                    } else {
                                                        phi_1902_ = _e1303;
                                                    }
                                                    let _e1309 = phi_1902_;
                                                    if (_e1309 > _e1306) {
                                                        phi_1907_ = _e1309;
                                                    } else {
                                                        phi_1907_ = _e1306;
                                                    }
                                                    let _e1312 = phi_1907_;
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
                                                            phi_1933_ = false;
                                                        } else {
                                                            phi_1933_ = true;
                                                        }
                                                        let _e1333 = phi_1933_;
                                                        phi_1934_ = _e1333;
                                                    } else {
                                                        phi_1934_ = true;
                                                    }
                                                    let _e1335 = phi_1934_;
                                                    if _e1335 {
                                                        if (_e1328 >= _e1329) {
                                                            phi_1942_ = 1u;
                                                        } else {
                                                            phi_1942_ = 2u;
                                                        }
                                                        let _e1338 = phi_1942_;
                                                        phi_1943_ = _e1338;
                                                    } else {
                                                        phi_1943_ = 0u;
                                                    }
                                                    let _e1340 = phi_1943_;
                                                    if (_e1340 == 0u) {
                                                        phi_1955_ = vec3<f32>(_e1115, _e1128, _e1102);
                                                    } else {
                                                        if (_e1340 == 1u) {
                                                            phi_1954_ = vec3<f32>(_e1128, _e1102, _e1115);
                                                        } else {
                                                            phi_1954_ = vec3<f32>(_e1102, _e1115, _e1128);
                                                        }
                                                        let _e1346 = phi_1954_;
                                                        phi_1955_ = _e1346;
                                                    }
                                                    let _e1348 = phi_1955_;
                                                    let _e1351 = (_e1348.x / _e1348.z);
                                                    let _e1354 = (_e1348.y / _e1348.z);
                                                    if (_e1265 < 0f) {
                                                        phi_1968_ = 0u;
                                                    } else {
                                                        phi_1968_ = 1u;
                                                    }
                                                    let _e1359 = phi_1968_;
                                                    if (_e1275 < 0f) {
                                                        phi_1973_ = 0u;
                                                    } else {
                                                        phi_1973_ = 2u;
                                                    }
                                                    let _e1362 = phi_1973_;
                                                    if (_e1285 < 0f) {
                                                        phi_1978_ = 0u;
                                                    } else {
                                                        phi_1978_ = 4u;
                                                    }
                                                    let _e1365 = phi_1978_;
                                                    let _e1367 = ((_e1359 | _e1362) | _e1365);
                                                    let _e1368 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1133, 2147483648u);
                                                    local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e1368.first[0], _e1368.first[1], _e1368.first[2], _e1368.first[3], _e1368.first[4], _e1368.first[5], _e1368.first[6], _e1368.first[7], _e1368.first[8], _e1368.first[9], _e1368.first[10], _e1368.first[11], _e1368.first[12], _e1368.first[13], _e1368.first[14], _e1368.first[15], _e1368.first[16], _e1368.first[17], _e1368.first[18], _e1368.first[19], _e1368.first[20], _e1368.first[21], _e1368.first[22], _e1368.first[23], _e1368.first[24], _e1368.first[25], _e1368.first[26], _e1368.first[27], _e1368.first[28], _e1368.first[29], _e1368.first[30], _e1368.first[31]), array<u32, 32>(_e1368.mask[0], _e1368.mask[1], _e1368.mask[2], _e1368.mask[3], _e1368.mask[4], _e1368.mask[5], _e1368.mask[6], _e1368.mask[7], _e1368.mask[8], _e1368.mask[9], _e1368.mask[10], _e1368.mask[11], _e1368.mask[12], _e1368.mask[13], _e1368.mask[14], _e1368.mask[15], _e1368.mask[16], _e1368.mask[17], _e1368.mask[18], _e1368.mask[19], _e1368.mask[20], _e1368.mask[21], _e1368.mask[22], _e1368.mask[23], _e1368.mask[24], _e1368.mask[25], _e1368.mask[26], _e1368.mask[27], _e1368.mask[28], _e1368.mask[29], _e1368.mask[30], _e1368.mask[31]), _e1368.len, _e1368.group, _e1368.group_mask);
                                                    let _e1442 = local_1.group_mask;
                                                    if ((_e1442 & 4278190080u) == 0u) {
                                                        let _e1446 = local_1.len;
                                                        if (_e1446 == 0u) {
                                                            phi_2092_ = false;
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
                                                            phi_2092_ = true;
                                                        }
                                                        let _e1469 = phi_2092_;
                                                        phi_2093_ = _e1469;
                                                    } else {
                                                        phi_2093_ = true;
                                                    }
                                                    let _e1471 = phi_2093_;
                                                    if _e1471 {
                                                        let _e1473 = local_1.group_mask;
                                                        let _e1479 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1473)), 32u, (_e1473 == 0u)));
                                                        let _e1483 = local_1.group_mask;
                                                        let _e1497 = local_1.group_mask;
                                                        local_1.group_mask = (_e1497 & ~((1u << bitcast<u32>((_e1479 & 31u)))));
                                                        let _e1500 = local_1.group;
                                                        phi_2124_ = (_e1500 + countOneBits(((_e1483 & ~((4294967295u << bitcast<u32>((((_e1479 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_2124_ = 4294967295u;
                                                    }
                                                    let _e1503 = phi_2124_;
                                                    phi_2126_ = _e966;
                                                    phi_2129_ = _e1503;
                                                    loop {
                                                        let _e1505 = phi_2126_;
                                                        let _e1507 = phi_2129_;
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
                                                                phi_2210_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1591.unnamed, lt_mask_LightPlace(_e1591.unnamed_1.word, _e1568.y));
                                                            } else {
                                                                let _e1607 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1568.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1613 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1607.unnamed.word, _e1568.y), _e1607.unnamed_1);
                                                                let _e1619 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1613.unnamed, lt_mask_LightPlace(_e1568.z, _e1613.unnamed_1.shift));
                                                                phi_2210_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1619.unnamed, lt_mask_LightPlace(_e1619.unnamed_1.word, _e1568.w));
                                                            }
                                                            let _e1627 = phi_2210_;
                                                            let _e1637 = nodes.member[(0u + _e1507)].y;
                                                            if (_e1275 < 0f) {
                                                                let _e1648 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1637.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1654 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1648.unnamed.word, _e1637.w), _e1648.unnamed_1);
                                                                let _e1660 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1654.unnamed, lt_mask_LightPlace(_e1637.x, _e1654.unnamed_1.shift));
                                                                phi_2237_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1660.unnamed, lt_mask_LightPlace(_e1660.unnamed_1.word, _e1637.y));
                                                            } else {
                                                                let _e1676 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1637.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1682 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1676.unnamed.word, _e1637.y), _e1676.unnamed_1);
                                                                let _e1688 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1682.unnamed, lt_mask_LightPlace(_e1637.z, _e1682.unnamed_1.shift));
                                                                phi_2237_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1688.unnamed, lt_mask_LightPlace(_e1688.unnamed_1.word, _e1637.w));
                                                            }
                                                            let _e1696 = phi_2237_;
                                                            let _e1706 = nodes.member[(0u + _e1507)].z;
                                                            if (_e1285 < 0f) {
                                                                let _e1717 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1706.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1723 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1717.unnamed.word, _e1706.w), _e1717.unnamed_1);
                                                                let _e1729 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1723.unnamed, lt_mask_LightPlace(_e1706.x, _e1723.unnamed_1.shift));
                                                                phi_2264_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1729.unnamed, lt_mask_LightPlace(_e1729.unnamed_1.word, _e1706.y));
                                                            } else {
                                                                let _e1745 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1706.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1751 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1745.unnamed.word, _e1706.y), _e1745.unnamed_1);
                                                                let _e1757 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1751.unnamed, lt_mask_LightPlace(_e1706.z, _e1751.unnamed_1.shift));
                                                                phi_2264_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1757.unnamed, lt_mask_LightPlace(_e1757.unnamed_1.word, _e1706.w));
                                                            }
                                                            let _e1765 = phi_2264_;
                                                            phi_2270_ = 0u;
                                                            phi_2273_ = 0u;
                                                            loop {
                                                                let _e1775 = phi_2270_;
                                                                let _e1777 = phi_2273_;
                                                                local_6 = _e1777;
                                                                local_7 = _e1777;
                                                                local_8 = _e1777;
                                                                let _e1778 = (_e1775 < 8u);
                                                                if _e1778 {
                                                                    let _e1780 = (_e1775 >> bitcast<u32>(2i));
                                                                    let _e1781 = (_e1775 & 3u);
                                                                    if (_e1780 == 0u) {
                                                                        phi_2287_ = _e1627.unnamed.word;
                                                                    } else {
                                                                        phi_2287_ = _e1627.unnamed.shift;
                                                                    }
                                                                    let _e1784 = phi_2287_;
                                                                    if (_e1780 == 0u) {
                                                                        phi_2297_ = _e1696.unnamed.word;
                                                                    } else {
                                                                        phi_2297_ = _e1696.unnamed.shift;
                                                                    }
                                                                    let _e1793 = phi_2297_;
                                                                    if (_e1780 == 0u) {
                                                                        phi_2307_ = _e1765.unnamed.word;
                                                                    } else {
                                                                        phi_2307_ = _e1765.unnamed.shift;
                                                                    }
                                                                    let _e1802 = phi_2307_;
                                                                    let _e1815 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1784 >> bitcast<u32>(((_e1781 * 8u) & 31u))) & 255u)) * _e1540) + (_e1558 - _e1317)), ((f32(((_e1793 >> bitcast<u32>(((_e1781 * 8u) & 31u))) & 255u)) * _e1541) + (_e1559 - _e1318)));
                                                                    let _e1816 = core_intrinsics_maximum_number_nsz_f32_(_e1815, ((f32(((_e1802 >> bitcast<u32>(((_e1781 * 8u) & 31u))) & 255u)) * _e1542) + (_e1560 - _e1319)));
                                                                    if (_e1780 == 0u) {
                                                                        phi_2325_ = _e1627.unnamed_1.word;
                                                                    } else {
                                                                        phi_2325_ = _e1627.unnamed_1.shift;
                                                                    }
                                                                    let _e1819 = phi_2325_;
                                                                    if (_e1780 == 0u) {
                                                                        phi_2335_ = _e1696.unnamed_1.word;
                                                                    } else {
                                                                        phi_2335_ = _e1696.unnamed_1.shift;
                                                                    }
                                                                    let _e1828 = phi_2335_;
                                                                    if (_e1780 == 0u) {
                                                                        phi_2345_ = _e1765.unnamed_1.word;
                                                                    } else {
                                                                        phi_2345_ = _e1765.unnamed_1.shift;
                                                                    }
                                                                    let _e1837 = phi_2345_;
                                                                    let _e1850 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1819 >> bitcast<u32>(((_e1781 * 8u) & 31u))) & 255u)) * _e1540) + (_e1558 + _e1317)), ((f32(((_e1828 >> bitcast<u32>(((_e1781 * 8u) & 31u))) & 255u)) * _e1541) + (_e1559 + _e1318)));
                                                                    let _e1851 = core_intrinsics_minimum_number_nsz_f32_(_e1850, ((f32(((_e1837 >> bitcast<u32>(((_e1781 * 8u) & 31u))) & 255u)) * _e1542) + (_e1560 + _e1319)));
                                                                    if (_e1816 <= _e1851) {
                                                                        if (_e1816 <= _e1505.t) {
                                                                            if (_e1851 >= _e157.tmin) {
                                                                                if (_e1780 == 0u) {
                                                                                    let _e1858 = nodes.member[(0u + _e1507)].links[2u];
                                                                                    phi_2381_ = _e1858;
                                                                                } else {
                                                                                    let _e1861 = nodes.member[(0u + _e1507)].links[3u];
                                                                                    phi_2381_ = _e1861;
                                                                                }
                                                                                let _e1863 = phi_2381_;
                                                                                let _e1868 = ((_e1863 >> bitcast<u32>(((_e1781 * 8u) & 31u))) & 255u);
                                                                                let _e1869 = (_e1868 & 31u);
                                                                                if (_e1869 >= 24u) {
                                                                                    phi_2394_ = (24u + ((_e1869 - 24u) ^ _e1367));
                                                                                } else {
                                                                                    phi_2394_ = _e1869;
                                                                                }
                                                                                let _e1875 = phi_2394_;
                                                                                phi_2399_ = (_e1777 | ((_e1868 >> bitcast<u32>(5i)) << bitcast<u32>((_e1875 & 31u))));
                                                                            } else {
                                                                                phi_2399_ = _e1777;
                                                                            }
                                                                            let _e1883 = phi_2399_;
                                                                            phi_2400_ = _e1883;
                                                                        } else {
                                                                            phi_2400_ = _e1777;
                                                                        }
                                                                        let _e1885 = phi_2400_;
                                                                        phi_2401_ = _e1885;
                                                                    } else {
                                                                        phi_2401_ = _e1777;
                                                                    }
                                                                    let _e1887 = phi_2401_;
                                                                    phi_2271_ = (_e1775 + 1u);
                                                                    phi_2274_ = _e1887;
                                                                } else {
                                                                    phi_2271_ = u32();
                                                                    phi_2274_ = u32();
                                                                }
                                                                let _e1890 = phi_2271_;
                                                                let _e1892 = phi_2274_;
                                                                continue;
                                                                continuing {
                                                                    phi_2270_ = _e1890;
                                                                    phi_2273_ = _e1892;
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
                                                            phi_2459_ = _e1505;
                                                            phi_2462_ = (_e1941 & 16777215u);
                                                            loop {
                                                                let _e1944 = phi_2459_;
                                                                let _e1946 = phi_2462_;
                                                                local_9 = _e1944;
                                                                if (_e1946 == 0u) {
                                                                    phi_2460_ = lt_bvh_Hit();
                                                                    phi_2463_ = u32();
                                                                    phi_3104_ = false;
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
                                                                        phi_2507_ = vec3<f32>(_e1966, _e1968, _e1964);
                                                                    } else {
                                                                        if (_e1340 == 1u) {
                                                                            phi_2506_ = vec3<f32>(_e1968, _e1964, _e1966);
                                                                        } else {
                                                                            phi_2506_ = (_e1962 - vec3<f32>(_e1058, _e1071, _e1084));
                                                                        }
                                                                        let _e1976 = phi_2506_;
                                                                        phi_2507_ = _e1976;
                                                                    }
                                                                    let _e1978 = phi_2507_;
                                                                    let _e1982 = (_e1978.x - (_e1351 * _e1978.z));
                                                                    let _e1986 = (_e1978.y - (_e1354 * _e1978.z));
                                                                    let _e1988 = triangles.member[(0u + _e1955)].v1_;
                                                                    let _e1990 = (_e1988.x - _e1058);
                                                                    let _e1992 = (_e1988.y - _e1071);
                                                                    let _e1994 = (_e1988.z - _e1084);
                                                                    if (_e1340 == 0u) {
                                                                        phi_2537_ = vec3<f32>(_e1992, _e1994, _e1990);
                                                                    } else {
                                                                        if (_e1340 == 1u) {
                                                                            phi_2536_ = vec3<f32>(_e1994, _e1990, _e1992);
                                                                        } else {
                                                                            phi_2536_ = (_e1988 - vec3<f32>(_e1058, _e1071, _e1084));
                                                                        }
                                                                        let _e2002 = phi_2536_;
                                                                        phi_2537_ = _e2002;
                                                                    }
                                                                    let _e2004 = phi_2537_;
                                                                    let _e2008 = (_e2004.x - (_e1351 * _e2004.z));
                                                                    let _e2012 = (_e2004.y - (_e1354 * _e2004.z));
                                                                    let _e2014 = triangles.member[(0u + _e1955)].v2_;
                                                                    let _e2016 = (_e2014.x - _e1058);
                                                                    let _e2018 = (_e2014.y - _e1071);
                                                                    let _e2020 = (_e2014.z - _e1084);
                                                                    if (_e1340 == 0u) {
                                                                        phi_2567_ = vec3<f32>(_e2018, _e2020, _e2016);
                                                                    } else {
                                                                        if (_e1340 == 1u) {
                                                                            phi_2566_ = vec3<f32>(_e2020, _e2016, _e2018);
                                                                        } else {
                                                                            phi_2566_ = (_e2014 - vec3<f32>(_e1058, _e1071, _e1084));
                                                                        }
                                                                        let _e2028 = phi_2566_;
                                                                        phi_2567_ = _e2028;
                                                                    }
                                                                    let _e2030 = phi_2567_;
                                                                    let _e2034 = (_e2030.x - (_e1351 * _e2030.z));
                                                                    let _e2038 = (_e2030.y - (_e1354 * _e2030.z));
                                                                    if (_e2008 < _e2034) {
                                                                        phi_2586_ = true;
                                                                    } else {
                                                                        if (_e2008 == _e2034) {
                                                                            phi_2585_ = (_e2012 < _e2038);
                                                                        } else {
                                                                            phi_2585_ = false;
                                                                        }
                                                                        let _e2043 = phi_2585_;
                                                                        phi_2586_ = _e2043;
                                                                    }
                                                                    let _e2045 = phi_2586_;
                                                                    if _e2045 {
                                                                        phi_2590_ = _e2038;
                                                                        phi_2591_ = _e2034;
                                                                        phi_2592_ = _e2012;
                                                                        phi_2593_ = _e2008;
                                                                    } else {
                                                                        phi_2590_ = _e2012;
                                                                        phi_2591_ = _e2008;
                                                                        phi_2592_ = _e2038;
                                                                        phi_2593_ = _e2034;
                                                                    }
                                                                    let _e2047 = phi_2590_;
                                                                    let _e2049 = phi_2591_;
                                                                    let _e2051 = phi_2592_;
                                                                    let _e2053 = phi_2593_;
                                                                    let _e2056 = ((_e2053 * _e2047) - (_e2051 * _e2049));
                                                                    if _e2045 {
                                                                        phi_2601_ = -(_e2056);
                                                                    } else {
                                                                        phi_2601_ = _e2056;
                                                                    }
                                                                    let _e2059 = phi_2601_;
                                                                    if (_e2034 < _e1982) {
                                                                        phi_2612_ = true;
                                                                    } else {
                                                                        if (_e2034 == _e1982) {
                                                                            phi_2611_ = (_e2038 < _e1986);
                                                                        } else {
                                                                            phi_2611_ = false;
                                                                        }
                                                                        let _e2064 = phi_2611_;
                                                                        phi_2612_ = _e2064;
                                                                    }
                                                                    let _e2066 = phi_2612_;
                                                                    if _e2066 {
                                                                        phi_2616_ = _e1986;
                                                                        phi_2617_ = _e1982;
                                                                        phi_2618_ = _e2038;
                                                                        phi_2619_ = _e2034;
                                                                    } else {
                                                                        phi_2616_ = _e2038;
                                                                        phi_2617_ = _e2034;
                                                                        phi_2618_ = _e1986;
                                                                        phi_2619_ = _e1982;
                                                                    }
                                                                    let _e2068 = phi_2616_;
                                                                    let _e2070 = phi_2617_;
                                                                    let _e2072 = phi_2618_;
                                                                    let _e2074 = phi_2619_;
                                                                    let _e2077 = ((_e2074 * _e2068) - (_e2072 * _e2070));
                                                                    if _e2066 {
                                                                        phi_2627_ = -(_e2077);
                                                                    } else {
                                                                        phi_2627_ = _e2077;
                                                                    }
                                                                    let _e2080 = phi_2627_;
                                                                    if (_e1982 < _e2008) {
                                                                        phi_2638_ = true;
                                                                    } else {
                                                                        if (_e1982 == _e2008) {
                                                                            phi_2637_ = (_e1986 < _e2012);
                                                                        } else {
                                                                            phi_2637_ = false;
                                                                        }
                                                                        let _e2085 = phi_2637_;
                                                                        phi_2638_ = _e2085;
                                                                    }
                                                                    let _e2087 = phi_2638_;
                                                                    if _e2087 {
                                                                        phi_2642_ = _e2012;
                                                                        phi_2643_ = _e2008;
                                                                        phi_2644_ = _e1986;
                                                                        phi_2645_ = _e1982;
                                                                    } else {
                                                                        phi_2642_ = _e1986;
                                                                        phi_2643_ = _e1982;
                                                                        phi_2644_ = _e2012;
                                                                        phi_2645_ = _e2008;
                                                                    }
                                                                    let _e2089 = phi_2642_;
                                                                    let _e2091 = phi_2643_;
                                                                    let _e2093 = phi_2644_;
                                                                    let _e2095 = phi_2645_;
                                                                    let _e2098 = ((_e2095 * _e2089) - (_e2093 * _e2091));
                                                                    if _e2087 {
                                                                        phi_2653_ = -(_e2098);
                                                                    } else {
                                                                        phi_2653_ = _e2098;
                                                                    }
                                                                    let _e2101 = phi_2653_;
                                                                    if (_e2059 >= 0f) {
                                                                        if (_e2080 >= 0f) {
                                                                            if (_e2101 >= 0f) {
                                                                                phi_2668_ = ((_e2059 + _e2080) + _e2101);
                                                                                phi_2669_ = false;
                                                                            } else {
                                                                                phi_2668_ = f32();
                                                                                phi_2669_ = true;
                                                                            }
                                                                            let _e2108 = phi_2668_;
                                                                            let _e2110 = phi_2669_;
                                                                            phi_2670_ = _e2108;
                                                                            phi_2671_ = _e2110;
                                                                        } else {
                                                                            phi_2670_ = f32();
                                                                            phi_2671_ = true;
                                                                        }
                                                                        let _e2112 = phi_2670_;
                                                                        let _e2114 = phi_2671_;
                                                                        phi_2672_ = _e2112;
                                                                        phi_2673_ = _e2114;
                                                                    } else {
                                                                        phi_2672_ = f32();
                                                                        phi_2673_ = true;
                                                                    }
                                                                    let _e2116 = phi_2672_;
                                                                    let _e2118 = phi_2673_;
                                                                    if _e2118 {
                                                                        if (_e2059 <= 0f) {
                                                                            if (_e2080 <= 0f) {
                                                                                let _e2121 = (_e2101 <= 0f);
                                                                                if _e2121 {
                                                                                }
                                                                                phi_2691_ = ((_e2059 + _e2080) + _e2101);
                                                                                phi_2692_ = false;
                                                                                phi_2693_ = _e2121;
                                                                            } else {
                                                                                phi_2691_ = f32();
                                                                                phi_2692_ = true;
                                                                                phi_2693_ = false;
                                                                            }
                                                                            let _e2125 = phi_2691_;
                                                                            let _e2127 = phi_2692_;
                                                                            let _e2129 = phi_2693_;
                                                                            phi_2694_ = _e2125;
                                                                            phi_2695_ = _e2127;
                                                                            phi_2696_ = _e2129;
                                                                        } else {
                                                                            phi_2694_ = f32();
                                                                            phi_2695_ = true;
                                                                            phi_2696_ = false;
                                                                        }
                                                                        let _e2131 = phi_2694_;
                                                                        let _e2133 = phi_2695_;
                                                                        let _e2135 = phi_2696_;
                                                                        if _e2133 {
                                                                            phi_2700_ = false;
                                                                        } else {
                                                                            phi_2700_ = _e2135;
                                                                        }
                                                                        let _e2137 = phi_2700_;
                                                                        phi_2701_ = _e2131;
                                                                        phi_2702_ = _e2137;
                                                                    } else {
                                                                        phi_2701_ = _e2116;
                                                                        phi_2702_ = true;
                                                                    }
                                                                    let _e2139 = phi_2701_;
                                                                    let _e2141 = phi_2702_;
                                                                    if _e2141 {
                                                                        let _e2142 = (_e2139 == 0f);
                                                                        if _e2142 {
                                                                            phi_3018_ = lt_bvh_triangle_Intersection();
                                                                            phi_3019_ = false;
                                                                        } else {
                                                                            let _e2144 = triangles.member[(0u + _e1955)].v0_;
                                                                            let _e2146 = (_e2144.x - _e1058);
                                                                            let _e2148 = (_e2144.y - _e1071);
                                                                            let _e2150 = (_e2144.z - _e1084);
                                                                            if (_e1340 == 0u) {
                                                                                phi_2731_ = vec3<f32>(_e2148, _e2150, _e2146);
                                                                            } else {
                                                                                if (_e1340 == 1u) {
                                                                                    phi_2730_ = vec3<f32>(_e2150, _e2146, _e2148);
                                                                                } else {
                                                                                    phi_2730_ = (_e2144 - vec3<f32>(_e1058, _e1071, _e1084));
                                                                                }
                                                                                let _e2158 = phi_2730_;
                                                                                phi_2731_ = _e2158;
                                                                            }
                                                                            let _e2160 = phi_2731_;
                                                                            let _e2162 = triangles.member[(0u + _e1955)].v1_;
                                                                            let _e2164 = triangles.member[(0u + _e1955)].v0_;
                                                                            let _e2167 = (_e2162.x - _e2164.x);
                                                                            let _e2170 = (_e2162.y - _e2164.y);
                                                                            let _e2173 = (_e2162.z - _e2164.z);
                                                                            if (_e1340 == 0u) {
                                                                                phi_2757_ = vec3<f32>(_e2170, _e2173, _e2167);
                                                                            } else {
                                                                                if (_e1340 == 1u) {
                                                                                    phi_2756_ = vec3<f32>(_e2173, _e2167, _e2170);
                                                                                } else {
                                                                                    phi_2756_ = (_e2162 - _e2164);
                                                                                }
                                                                                let _e2180 = phi_2756_;
                                                                                phi_2757_ = _e2180;
                                                                            }
                                                                            let _e2182 = phi_2757_;
                                                                            let _e2184 = triangles.member[(0u + _e1955)].v2_;
                                                                            let _e2186 = triangles.member[(0u + _e1955)].v0_;
                                                                            let _e2189 = (_e2184.x - _e2186.x);
                                                                            let _e2192 = (_e2184.y - _e2186.y);
                                                                            let _e2195 = (_e2184.z - _e2186.z);
                                                                            if (_e1340 == 0u) {
                                                                                phi_2783_ = vec3<f32>(_e2192, _e2195, _e2189);
                                                                            } else {
                                                                                if (_e1340 == 1u) {
                                                                                    phi_2782_ = vec3<f32>(_e2195, _e2189, _e2192);
                                                                                } else {
                                                                                    phi_2782_ = (_e2184 - _e2186);
                                                                                }
                                                                                let _e2202 = phi_2782_;
                                                                                phi_2783_ = _e2202;
                                                                            }
                                                                            let _e2204 = phi_2783_;
                                                                            let _e2211 = ((_e2182.y * _e2204.z) - (_e2182.z * _e2204.y));
                                                                            let _e2218 = ((_e2182.z * _e2204.x) - (_e2182.x * _e2204.z));
                                                                            let _e2225 = ((_e2182.x * _e2204.y) - (_e2182.y * _e2204.x));
                                                                            let _e2239 = (((1f / _e1348.z) * (((_e2211 * _e2160.x) + (_e2218 * _e2160.y)) + (_e2225 * _e2160.z))) / (((_e2211 * _e1351) + (_e2218 * _e1354)) + _e2225));
                                                                            if (_e2239 > _e157.tmin) {
                                                                                if (_e2239 < _e157.tmax) {
                                                                                    let _e2243 = triangles.member[(0u + _e1955)].v0_;
                                                                                    let _e2245 = triangles.member[(0u + _e1955)].v1_;
                                                                                    if (_e2243.x < _e2245.x) {
                                                                                        phi_2839_ = _e2243.x;
                                                                                    } else {
                                                                                        phi_2839_ = _e2245.x;
                                                                                    }
                                                                                    let _e2252 = phi_2839_;
                                                                                    if (_e2243.y < _e2245.y) {
                                                                                        phi_2848_ = _e2243.y;
                                                                                    } else {
                                                                                        phi_2848_ = _e2245.y;
                                                                                    }
                                                                                    let _e2259 = phi_2848_;
                                                                                    if (_e2243.z < _e2245.z) {
                                                                                        phi_2857_ = _e2243.z;
                                                                                    } else {
                                                                                        phi_2857_ = _e2245.z;
                                                                                    }
                                                                                    let _e2266 = phi_2857_;
                                                                                    let _e2268 = triangles.member[(0u + _e1955)].v2_;
                                                                                    if (_e2252 < _e2268.x) {
                                                                                        phi_2866_ = _e2252;
                                                                                    } else {
                                                                                        phi_2866_ = _e2268.x;
                                                                                    }
                                                                                    let _e2273 = phi_2866_;
                                                                                    if (_e2259 < _e2268.y) {
                                                                                        phi_2873_ = _e2259;
                                                                                    } else {
                                                                                        phi_2873_ = _e2268.y;
                                                                                    }
                                                                                    let _e2278 = phi_2873_;
                                                                                    if (_e2266 < _e2268.z) {
                                                                                        phi_2880_ = _e2266;
                                                                                    } else {
                                                                                        phi_2880_ = _e2268.z;
                                                                                    }
                                                                                    let _e2283 = phi_2880_;
                                                                                    let _e2285 = triangles.member[(0u + _e1955)].v0_;
                                                                                    let _e2287 = triangles.member[(0u + _e1955)].v1_;
                                                                                    if (_e2285.x > _e2287.x) {
                                                                                        phi_2893_ = _e2285.x;
                                                                                    } else {
                                                                                        phi_2893_ = _e2287.x;
                                                                                    }
                                                                                    let _e2294 = phi_2893_;
                                                                                    if (_e2285.y > _e2287.y) {
                                                                                        phi_2902_ = _e2285.y;
                                                                                    } else {
                                                                                        phi_2902_ = _e2287.y;
                                                                                    }
                                                                                    let _e2301 = phi_2902_;
                                                                                    if (_e2285.z > _e2287.z) {
                                                                                        phi_2911_ = _e2285.z;
                                                                                    } else {
                                                                                        phi_2911_ = _e2287.z;
                                                                                    }
                                                                                    let _e2308 = phi_2911_;
                                                                                    let _e2310 = triangles.member[(0u + _e1955)].v2_;
                                                                                    if (_e2294 > _e2310.x) {
                                                                                        phi_2920_ = _e2294;
                                                                                    } else {
                                                                                        phi_2920_ = _e2310.x;
                                                                                    }
                                                                                    let _e2315 = phi_2920_;
                                                                                    if (_e2301 > _e2310.y) {
                                                                                        phi_2927_ = _e2301;
                                                                                    } else {
                                                                                        phi_2927_ = _e2310.y;
                                                                                    }
                                                                                    let _e2320 = phi_2927_;
                                                                                    if (_e2308 > _e2310.z) {
                                                                                        phi_2934_ = _e2308;
                                                                                    } else {
                                                                                        phi_2934_ = _e2310.z;
                                                                                    }
                                                                                    let _e2325 = phi_2934_;
                                                                                    let _e2329 = ((_e2273 - _e1058) * _e1265);
                                                                                    let _e2330 = ((_e2278 - _e1071) * _e1275);
                                                                                    let _e2331 = ((_e2283 - _e1084) * _e1285);
                                                                                    let _e2335 = ((_e2315 - _e1058) * _e1265);
                                                                                    let _e2336 = ((_e2320 - _e1071) * _e1275);
                                                                                    let _e2337 = ((_e2325 - _e1084) * _e1285);
                                                                                    if (_e2329 < _e2335) {
                                                                                        phi_2951_ = _e2329;
                                                                                    } else {
                                                                                        phi_2951_ = _e2335;
                                                                                    }
                                                                                    let _e2340 = phi_2951_;
                                                                                    if (_e2330 < _e2336) {
                                                                                        phi_2956_ = _e2330;
                                                                                    } else {
                                                                                        phi_2956_ = _e2336;
                                                                                    }
                                                                                    let _e2343 = phi_2956_;
                                                                                    if (_e2331 < _e2337) {
                                                                                        phi_2961_ = _e2331;
                                                                                    } else {
                                                                                        phi_2961_ = _e2337;
                                                                                    }
                                                                                    let _e2346 = phi_2961_;
                                                                                    if (_e2329 > _e2335) {
                                                                                        phi_2969_ = _e2329;
                                                                                    } else {
                                                                                        phi_2969_ = _e2335;
                                                                                    }
                                                                                    let _e2352 = phi_2969_;
                                                                                    if (_e2330 > _e2336) {
                                                                                        phi_2974_ = _e2330;
                                                                                    } else {
                                                                                        phi_2974_ = _e2336;
                                                                                    }
                                                                                    let _e2355 = phi_2974_;
                                                                                    if (_e2331 > _e2337) {
                                                                                        phi_2979_ = _e2331;
                                                                                    } else {
                                                                                        phi_2979_ = _e2337;
                                                                                    }
                                                                                    let _e2358 = phi_2979_;
                                                                                    let _e2362 = core_intrinsics_maximum_number_nsz_f32_((_e2340 - _e1324), (_e2343 - _e1325));
                                                                                    let _e2363 = core_intrinsics_maximum_number_nsz_f32_(_e2362, (_e2346 - _e1326));
                                                                                    let _e2364 = core_intrinsics_minimum_number_nsz_f32_((_e2352 + _e1324), (_e2355 + _e1325));
                                                                                    let _e2365 = core_intrinsics_minimum_number_nsz_f32_(_e2364, (_e2358 + _e1326));
                                                                                    if (_e2363 > _e1033) {
                                                                                        phi_2991_ = _e2363;
                                                                                    } else {
                                                                                        phi_2991_ = _e1033;
                                                                                    }
                                                                                    let _e2368 = phi_2991_;
                                                                                    if (_e2365 < _e1035) {
                                                                                        phi_2996_ = _e2365;
                                                                                    } else {
                                                                                        phi_2996_ = _e1035;
                                                                                    }
                                                                                    let _e2371 = phi_2996_;
                                                                                    if (_e2239 < _e2368) {
                                                                                        phi_3001_ = _e2368;
                                                                                    } else {
                                                                                        phi_3001_ = _e2239;
                                                                                    }
                                                                                    let _e2374 = phi_3001_;
                                                                                    if (_e2374 > _e2371) {
                                                                                        phi_3006_ = _e2371;
                                                                                    } else {
                                                                                        phi_3006_ = _e2374;
                                                                                    }
                                                                                    let _e2377 = phi_3006_;
                                                                                    phi_3011_ = lt_bvh_triangle_Intersection(_e2377, (_e2080 / _e2139), (_e2101 / _e2139), (_e2368 <= _e2371));
                                                                                    phi_3012_ = false;
                                                                                } else {
                                                                                    phi_3011_ = lt_bvh_triangle_Intersection();
                                                                                    phi_3012_ = true;
                                                                                }
                                                                                let _e2383 = phi_3011_;
                                                                                let _e2385 = phi_3012_;
                                                                                phi_3013_ = _e2383;
                                                                                phi_3014_ = _e2385;
                                                                            } else {
                                                                                phi_3013_ = lt_bvh_triangle_Intersection();
                                                                                phi_3014_ = true;
                                                                            }
                                                                            let _e2387 = phi_3013_;
                                                                            let _e2389 = phi_3014_;
                                                                            if _e2389 {
                                                                            }
                                                                            phi_3018_ = _e2387;
                                                                            phi_3019_ = _e2389;
                                                                        }
                                                                        let _e2391 = phi_3018_;
                                                                        let _e2393 = phi_3019_;
                                                                        phi_3020_ = _e2391;
                                                                        phi_3021_ = _e2142;
                                                                        phi_3022_ = _e2393;
                                                                    } else {
                                                                        phi_3020_ = lt_bvh_triangle_Intersection();
                                                                        phi_3021_ = true;
                                                                        phi_3022_ = false;
                                                                    }
                                                                    let _e2395 = phi_3020_;
                                                                    let _e2397 = phi_3021_;
                                                                    let _e2399 = phi_3022_;
                                                                    if _e2397 {
                                                                        phi_3026_ = true;
                                                                    } else {
                                                                        phi_3026_ = _e2399;
                                                                    }
                                                                    let _e2401 = phi_3026_;
                                                                    if _e2401 {
                                                                        phi_3030_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_3030_ = _e2395;
                                                                    }
                                                                    let _e2403 = phi_3030_;
                                                                    if _e2403.is_hit {
                                                                        if (_e2403.t > _e157.tmin) {
                                                                            if (_e2403.t < _e1944.t) {
                                                                                phi_3078_ = true;
                                                                            } else {
                                                                                if (_e2403.t == _e1944.t) {
                                                                                    if (_e1944.triangle != 4294967295u) {
                                                                                        if (_e1955 < _e1944.triangle) {
                                                                                            phi_3069_ = true;
                                                                                        } else {
                                                                                            if (_e1955 == _e1944.triangle) {
                                                                                                phi_3068_ = (_e974 < _e1944.instance);
                                                                                            } else {
                                                                                                phi_3068_ = false;
                                                                                            }
                                                                                            let _e2421 = phi_3068_;
                                                                                            phi_3069_ = _e2421;
                                                                                        }
                                                                                        let _e2423 = phi_3069_;
                                                                                        phi_3070_ = _e2423;
                                                                                        phi_3071_ = false;
                                                                                    } else {
                                                                                        phi_3070_ = bool();
                                                                                        phi_3071_ = true;
                                                                                    }
                                                                                    let _e2425 = phi_3070_;
                                                                                    let _e2427 = phi_3071_;
                                                                                    phi_3072_ = _e2425;
                                                                                    phi_3073_ = _e2427;
                                                                                } else {
                                                                                    phi_3072_ = bool();
                                                                                    phi_3073_ = true;
                                                                                }
                                                                                let _e2429 = phi_3072_;
                                                                                let _e2431 = phi_3073_;
                                                                                if _e2431 {
                                                                                    phi_3077_ = false;
                                                                                } else {
                                                                                    phi_3077_ = _e2429;
                                                                                }
                                                                                let _e2433 = phi_3077_;
                                                                                phi_3078_ = _e2433;
                                                                            }
                                                                            let _e2435 = phi_3078_;
                                                                            if _e2435 {
                                                                                let _e2437 = triangles.member[(0u + _e1955)].i0_;
                                                                                if ((_e2437 & 2147483648u) == 0u) {
                                                                                    phi_3092_ = true;
                                                                                } else {
                                                                                    if true {
                                                                                    }
                                                                                    phi_3092_ = true;
                                                                                }
                                                                                let _e2441 = phi_3092_;
                                                                                if _e2441 {
                                                                                    phi_3100_ = lt_bvh_Hit(_e2403.t, _e2403.u, _e2403.v, _e1955, _e974);
                                                                                } else {
                                                                                    phi_3100_ = _e1944;
                                                                                }
                                                                                let _e2447 = phi_3100_;
                                                                                phi_3101_ = _e2447;
                                                                            } else {
                                                                                phi_3101_ = _e1944;
                                                                            }
                                                                            let _e2449 = phi_3101_;
                                                                            phi_3102_ = _e2449;
                                                                        } else {
                                                                            phi_3102_ = _e1944;
                                                                        }
                                                                        let _e2451 = phi_3102_;
                                                                        phi_3103_ = _e2451;
                                                                    } else {
                                                                        phi_3103_ = _e1944;
                                                                    }
                                                                    let _e2453 = phi_3103_;
                                                                    phi_2460_ = _e2453;
                                                                    phi_2463_ = (_e1946 & (_e1946 - 1u));
                                                                    phi_3104_ = true;
                                                                }
                                                                let _e2455 = phi_2460_;
                                                                let _e2457 = phi_2463_;
                                                                let _e2459 = phi_3104_;
                                                                continue;
                                                                continuing {
                                                                    phi_2459_ = _e2455;
                                                                    phi_2462_ = _e2457;
                                                                    break if !(_e2459);
                                                                }
                                                            }
                                                            let _e2462 = local_1.group_mask;
                                                            if ((_e2462 & 4278190080u) == 0u) {
                                                                let _e2466 = local_1.len;
                                                                if (_e2466 == 0u) {
                                                                    phi_3143_ = false;
                                                                } else {
                                                                    let _e2470 = local_1.len;
                                                                    local_1.len = (_e2470 - 1u);
                                                                    let _e2473 = local_1.len;
                                                                    if (_e2473 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2478 = local_1.first[(0u + _e2473)];
                                                                    local_1.group = _e2478;
                                                                    let _e2481 = local_1.len;
                                                                    if (_e2481 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2486 = local_1.mask[(0u + _e2481)];
                                                                    local_1.group_mask = _e2486;
                                                                    phi_3143_ = true;
                                                                }
                                                                let _e2489 = phi_3143_;
                                                                phi_3144_ = _e2489;
                                                            } else {
                                                                phi_3144_ = true;
                                                            }
                                                            let _e2491 = phi_3144_;
                                                            if _e2491 {
                                                                let _e2493 = local_1.group_mask;
                                                                let _e2499 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2493)), 32u, (_e2493 == 0u)));
                                                                let _e2503 = local_1.group_mask;
                                                                let _e2517 = local_1.group_mask;
                                                                local_1.group_mask = (_e2517 & ~((1u << bitcast<u32>((_e2499 & 31u)))));
                                                                let _e2520 = local_1.group;
                                                                phi_3175_ = (_e2520 + countOneBits(((_e2503 & ~((4294967295u << bitcast<u32>((((_e2499 - 24u) ^ _e1367) & 31u))))) & 255u)));
                                                            } else {
                                                                phi_3175_ = 4294967295u;
                                                            }
                                                            let _e2523 = phi_3175_;
                                                            let _e3649 = local_9;
                                                            phi_2127_ = _e3649;
                                                            phi_2130_ = _e2523;
                                                        } else {
                                                            phi_2127_ = lt_bvh_Hit();
                                                            phi_2130_ = u32();
                                                        }
                                                        let _e2525 = phi_2127_;
                                                        let _e2527 = phi_2130_;
                                                        continue;
                                                        continuing {
                                                            phi_2126_ = _e2525;
                                                            phi_2129_ = _e2527;
                                                            break if !(_e1508);
                                                        }
                                                    }
                                                    let _e3653 = local_10;
                                                    phi_3176_ = _e3653;
                                                }
                                                let _e2530 = phi_3176_;
                                                phi_3177_ = _e2530;
                                                phi_3178_ = _e1189;
                                            } else {
                                                phi_3177_ = lt_bvh_Hit();
                                                phi_3178_ = true;
                                            }
                                            let _e2532 = phi_3177_;
                                            let _e2534 = phi_3178_;
                                            if _e2534 {
                                                phi_3182_ = _e966;
                                            } else {
                                                phi_3182_ = _e2532;
                                            }
                                            let _e2536 = phi_3182_;
                                            phi_3183_ = _e2536;
                                        } else {
                                            phi_3183_ = _e966;
                                        }
                                        let _e2538 = phi_3183_;
                                        phi_3184_ = _e2538;
                                    } else {
                                        phi_3184_ = _e966;
                                    }
                                    let _e2540 = phi_3184_;
                                    phi_3185_ = _e2540;
                                } else {
                                    phi_3185_ = _e966;
                                }
                                let _e2542 = phi_3185_;
                                phi_1494_ = (_e964 & (_e964 - 1u));
                                phi_1497_ = _e2542;
                                phi_3186_ = true;
                            }
                            let _e2544 = phi_1494_;
                            let _e2546 = phi_1497_;
                            let _e2548 = phi_3186_;
                            continue;
                            continuing {
                                phi_1493_ = _e2544;
                                phi_1496_ = _e2546;
                                break if !(_e2548);
                            }
                        }
                        let _e2551 = local_2.group_mask;
                        if ((_e2551 & 4278190080u) == 0u) {
                            let _e2555 = local_2.len;
                            if (_e2555 == 0u) {
                                phi_3225_ = false;
                            } else {
                                let _e2559 = local_2.len;
                                local_2.len = (_e2559 - 1u);
                                let _e2562 = local_2.len;
                                if (_e2562 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2567 = local_2.first[(0u + _e2562)];
                                local_2.group = _e2567;
                                let _e2570 = local_2.len;
                                if (_e2570 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2575 = local_2.mask[(0u + _e2570)];
                                local_2.group_mask = _e2575;
                                phi_3225_ = true;
                            }
                            let _e2578 = phi_3225_;
                            phi_3226_ = _e2578;
                        } else {
                            phi_3226_ = true;
                        }
                        let _e2580 = phi_3226_;
                        if _e2580 {
                            let _e2582 = local_2.group_mask;
                            let _e2588 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2582)), 32u, (_e2582 == 0u)));
                            let _e2592 = local_2.group_mask;
                            let _e2606 = local_2.group_mask;
                            local_2.group_mask = (_e2606 & ~((1u << bitcast<u32>((_e2588 & 31u)))));
                            let _e2609 = local_2.group;
                            phi_3257_ = (_e2609 + countOneBits(((_e2592 & ~((4294967295u << bitcast<u32>((((_e2588 - 24u) ^ _e383) & 31u))))) & 255u)));
                        } else {
                            phi_3257_ = 4294967295u;
                        }
                        let _e2612 = phi_3257_;
                        phi_1157_ = _e2612;
                        let _e3669 = local_11;
                        phi_1160_ = _e3669;
                    } else {
                        phi_1157_ = u32();
                        phi_1160_ = lt_bvh_Hit();
                    }
                    let _e2614 = phi_1157_;
                    let _e2616 = phi_1160_;
                    continue;
                    continuing {
                        phi_1156_ = _e2614;
                        phi_1159_ = _e2616;
                        break if !(_e524);
                    }
                }
                let _e3672 = local_12;
                phi_3258_ = _e3672;
            }
            let _e2619 = phi_3258_;
            phi_3259_ = _e2619;
            phi_3260_ = _e221;
        } else {
            phi_3259_ = lt_bvh_Hit();
            phi_3260_ = true;
        }
        let _e2621 = phi_3259_;
        let _e2623 = phi_3260_;
        if _e2623 {
            phi_3264_ = _e159;
        } else {
            phi_3264_ = _e2621;
        }
        let _e2625 = phi_3264_;
        if (_e2625.triangle != 4294967295u) {
            let _e2631 = ((1f - _e2625.u) - _e2625.v);
            if (_e2625.triangle < _e79) {
            } else {
                return;
            }
            let _e2636 = triangles.member[(0u + _e2625.triangle)];
            if (_e2625.instance < _e91) {
            } else {
                return;
            }
            let _e2647 = instances.member[(0u + _e2625.instance)].object_to_world[0u];
            let _e2658 = ((((_e2647.x * _e2636.v0_.x) + (_e2647.y * _e2636.v0_.y)) + (_e2647.z * _e2636.v0_.z)) + (_e2647.w * 1f));
            let _e2660 = instances.member[(0u + _e2625.instance)].object_to_world[1u];
            let _e2671 = ((((_e2660.x * _e2636.v0_.x) + (_e2660.y * _e2636.v0_.y)) + (_e2660.z * _e2636.v0_.z)) + (_e2660.w * 1f));
            let _e2673 = instances.member[(0u + _e2625.instance)].object_to_world[2u];
            let _e2684 = ((((_e2673.x * _e2636.v0_.x) + (_e2673.y * _e2636.v0_.y)) + (_e2673.z * _e2636.v0_.z)) + (_e2673.w * 1f));
            let _e2691 = instances.member[(0u + _e2625.instance)].object_to_world[0u];
            let _e2702 = ((((_e2691.x * _e2636.v1_.x) + (_e2691.y * _e2636.v1_.y)) + (_e2691.z * _e2636.v1_.z)) + (_e2691.w * 1f));
            let _e2704 = instances.member[(0u + _e2625.instance)].object_to_world[1u];
            let _e2715 = ((((_e2704.x * _e2636.v1_.x) + (_e2704.y * _e2636.v1_.y)) + (_e2704.z * _e2636.v1_.z)) + (_e2704.w * 1f));
            let _e2717 = instances.member[(0u + _e2625.instance)].object_to_world[2u];
            let _e2728 = ((((_e2717.x * _e2636.v1_.x) + (_e2717.y * _e2636.v1_.y)) + (_e2717.z * _e2636.v1_.z)) + (_e2717.w * 1f));
            let _e2735 = instances.member[(0u + _e2625.instance)].object_to_world[0u];
            let _e2746 = ((((_e2735.x * _e2636.v2_.x) + (_e2735.y * _e2636.v2_.y)) + (_e2735.z * _e2636.v2_.z)) + (_e2735.w * 1f));
            let _e2748 = instances.member[(0u + _e2625.instance)].object_to_world[1u];
            let _e2759 = ((((_e2748.x * _e2636.v2_.x) + (_e2748.y * _e2636.v2_.y)) + (_e2748.z * _e2636.v2_.z)) + (_e2748.w * 1f));
            let _e2761 = instances.member[(0u + _e2625.instance)].object_to_world[2u];
            let _e2772 = ((((_e2761.x * _e2636.v2_.x) + (_e2761.y * _e2636.v2_.y)) + (_e2761.z * _e2636.v2_.z)) + (_e2761.w * 1f));
            let _e2785 = (((_e2658 * _e2631) + (_e2702 * _e2625.u)) + (_e2746 * _e2625.v));
            let _e2786 = (((_e2671 * _e2631) + (_e2715 * _e2625.u)) + (_e2759 * _e2625.v));
            let _e2787 = (((_e2684 * _e2631) + (_e2728 * _e2625.u)) + (_e2772 * _e2625.v));
            let _e2789 = abs(_e2658);
            let _e2790 = abs(_e2671);
            let _e2791 = abs(_e2684);
            let _e2792 = abs(_e2702);
            let _e2793 = abs(_e2715);
            let _e2794 = abs(_e2728);
            if (_e2789 > _e2792) {
                phi_3451_ = _e2789;
            } else {
                phi_3451_ = _e2792;
            }
            let _e2797 = phi_3451_;
            if (_e2790 > _e2793) {
                phi_3456_ = _e2790;
            } else {
                phi_3456_ = _e2793;
            }
            let _e2800 = phi_3456_;
            if (_e2791 > _e2794) {
                phi_3461_ = _e2791;
            } else {
                phi_3461_ = _e2794;
            }
            let _e2803 = phi_3461_;
            let _e2804 = abs(_e2746);
            let _e2805 = abs(_e2759);
            let _e2806 = abs(_e2772);
            if (_e2797 > _e2804) {
                phi_3469_ = _e2797;
            } else {
                phi_3469_ = _e2804;
            }
            let _e2809 = phi_3469_;
            if (_e2800 > _e2805) {
                phi_3474_ = _e2800;
            } else {
                phi_3474_ = _e2805;
            }
            let _e2812 = phi_3474_;
            if (_e2803 > _e2806) {
                phi_3479_ = _e2803;
            } else {
                phi_3479_ = _e2806;
            }
            let _e2815 = phi_3479_;
            let _e2816 = (_e2702 - _e2658);
            let _e2817 = (_e2715 - _e2671);
            let _e2818 = (_e2728 - _e2684);
            let _e2819 = (_e2746 - _e2658);
            let _e2820 = (_e2759 - _e2671);
            let _e2821 = (_e2772 - _e2684);
            let _e2825 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2817), abs(_e2818));
            let _e2826 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2816), _e2825);
            let _e2827 = (_e2816 / _e2826);
            let _e2828 = (_e2817 / _e2826);
            let _e2829 = (_e2818 / _e2826);
            let _e2833 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2820), abs(_e2821));
            let _e2834 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2819), _e2833);
            let _e2835 = (_e2819 / _e2834);
            let _e2836 = (_e2820 / _e2834);
            let _e2837 = (_e2821 / _e2834);
            let _e2840 = ((_e2828 * _e2837) - (_e2836 * _e2829));
            let _e2843 = ((_e2829 * _e2835) - (_e2837 * _e2827));
            let _e2846 = ((_e2827 * _e2836) - (_e2835 * _e2828));
            let _e2848 = p.member.eye;
            let _e2861 = (1f / sqrt((((_e2840 * _e2840) + (_e2843 * _e2843)) + (_e2846 * _e2846))));
            let _e2862 = (_e2840 * _e2861);
            let _e2863 = (_e2843 * _e2861);
            let _e2864 = (_e2846 * _e2861);
            if ((((_e2862 * (_e2848.x - _e2785)) + (_e2863 * (_e2848.y - _e2786))) + (_e2864 * (_e2848.z - _e2787))) < 0f) {
                phi_3543_ = vec3<f32>(-(_e2862), -(_e2863), -(_e2864));
            } else {
                phi_3543_ = vec3<f32>(_e2862, _e2863, _e2864);
            }
            let _e2877 = phi_3543_;
            if (_e2625.triangle < _e79) {
            } else {
                return;
            }
            let _e2882 = triangles.member[(0u + _e2625.triangle)];
            let _e2884 = (_e2882.i0_ & 2147483647u);
            if (_e2884 < _e82) {
            } else {
                return;
            }
            let _e2890 = vertices.member[(0u + _e2884)];
            if (_e2882.i1_ < _e82) {
            } else {
                return;
            }
            let _e2894 = vertices.member[(0u + _e2882.i1_)];
            if (_e2882.i2_ < _e82) {
            } else {
                return;
            }
            let _e2898 = vertices.member[(0u + _e2882.i2_)];
            let _e2899 = array<abi_Vertex, 3>(_e2890, _e2894, _e2898);
            if (_e2899[0].material < arrayLength((&materials.member))) {
            } else {
                return;
            }
            let _e2905 = materials.member[(0u + _e2899[0].material)];
            let _e2922 = (1f / 255f);
            let _e2941 = (1f / 255f);
            let _e2963 = (1f / 255f);
            if (_e2905.color_size == 0u) {
                phi_3786_ = vec3<f32>(1f, 1f, 1f);
            } else {
                local.offset = _e2905.color_offset;
                local.size = _e2905.color_size;
                local.flags = _e2905.flags;
                let _e3006 = _lt_shaders_texture_TextureView_quad((&local), (((_e2899[0].u * _e2631) + (_e2899[1].u * _e2625.u)) + (_e2899[2].u * _e2625.v)), (((_e2899[0].v * _e2631) + (_e2899[1].v * _e2625.u)) + (_e2899[2].v * _e2625.v)));
                if (_e3006.indices[0] < _e94) {
                } else {
                    return;
                }
                let _e3012 = color_texels.member[(0u + _e3006.indices[0])];
                let _e3023 = (1f / 255f);
                if (_e3006.indices[1] < _e94) {
                } else {
                    return;
                }
                let _e3037 = color_texels.member[(0u + _e3006.indices[1])];
                let _e3048 = (1f / 255f);
                if (_e3006.indices[2] < _e94) {
                } else {
                    return;
                }
                let _e3065 = color_texels.member[(0u + _e3006.indices[2])];
                let _e3076 = (1f / 255f);
                if (_e3006.indices[3] < _e94) {
                } else {
                    return;
                }
                let _e3093 = color_texels.member[(0u + _e3006.indices[3])];
                let _e3104 = (1f / 255f);
                let _e3113 = (((((f32((_e3012 & 255u)) * _e3023) * _e3006.weights.x) + ((f32((_e3037 & 255u)) * _e3048) * _e3006.weights.y)) + ((f32((_e3065 & 255u)) * _e3076) * _e3006.weights.z)) + ((f32((_e3093 & 255u)) * _e3104) * _e3006.weights.w));
                let _e3114 = (((((f32(((_e3012 >> bitcast<u32>(8i)) & 255u)) * _e3023) * _e3006.weights.x) + ((f32(((_e3037 >> bitcast<u32>(8i)) & 255u)) * _e3048) * _e3006.weights.y)) + ((f32(((_e3065 >> bitcast<u32>(8i)) & 255u)) * _e3076) * _e3006.weights.z)) + ((f32(((_e3093 >> bitcast<u32>(8i)) & 255u)) * _e3104) * _e3006.weights.w));
                let _e3115 = (((((f32(((_e3012 >> bitcast<u32>(16i)) & 255u)) * _e3023) * _e3006.weights.x) + ((f32(((_e3037 >> bitcast<u32>(16i)) & 255u)) * _e3048) * _e3006.weights.y)) + ((f32(((_e3065 >> bitcast<u32>(16i)) & 255u)) * _e3076) * _e3006.weights.z)) + ((f32(((_e3093 >> bitcast<u32>(16i)) & 255u)) * _e3104) * _e3006.weights.w));
                phi_3786_ = vec3<f32>((_e3113 * _e3113), (_e3114 * _e3114), (_e3115 * _e3115));
            }
            let _e3121 = phi_3786_;
            let _e3123 = ((_e2905.base_color.x * ((((f32((_e2899[0].color & 255u)) * _e2922) * _e2631) + ((f32((_e2899[1].color & 255u)) * _e2941) * _e2625.u)) + ((f32((_e2899[2].color & 255u)) * _e2963) * _e2625.v))) * _e3121.x);
            let _e3125 = ((_e2905.base_color.y * ((((f32(((_e2899[0].color >> bitcast<u32>(8i)) & 255u)) * _e2922) * _e2631) + ((f32(((_e2899[1].color >> bitcast<u32>(8i)) & 255u)) * _e2941) * _e2625.u)) + ((f32(((_e2899[2].color >> bitcast<u32>(8i)) & 255u)) * _e2963) * _e2625.v))) * _e3121.y);
            let _e3127 = ((_e2905.base_color.z * ((((f32(((_e2899[0].color >> bitcast<u32>(16i)) & 255u)) * _e2922) * _e2631) + ((f32(((_e2899[1].color >> bitcast<u32>(16i)) & 255u)) * _e2941) * _e2625.u)) + ((f32(((_e2899[2].color >> bitcast<u32>(16i)) & 255u)) * _e2963) * _e2625.v))) * _e3121.z);
            let _e3128 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e2812, _e2815);
            let _e3129 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e2809, _e3128);
            if ((_e2905.flags & 2u) == 0u) {
                phi_3801_ = 0u;
            } else {
                phi_3801_ = 1u;
            }
            let _e3134 = phi_3801_;
            if (_e2899[0].normal == 2147516416u) {
                phi_4031_ = _e2877;
            } else {
                let _e3147 = (f32((bitcast<i32>((_e2899[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3153 = (f32((bitcast<i32>(_e2899[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3157 = ((1f - abs(_e3147)) - abs(_e3153));
                if (_e3157 < 0f) {
                    phi_3828_ = -(_e3157);
                } else {
                    phi_3828_ = 0f;
                }
                let _e3161 = phi_3828_;
                if (_e3147 < 0f) {
                    phi_3835_ = (_e3147 + _e3161);
                } else {
                    phi_3835_ = (_e3147 - _e3161);
                }
                let _e3166 = phi_3835_;
                if (_e3153 < 0f) {
                    phi_3842_ = (_e3153 + _e3161);
                } else {
                    phi_3842_ = (_e3153 - _e3161);
                }
                let _e3171 = phi_3842_;
                let _e3178 = (1f / sqrt((((_e3166 * _e3166) + (_e3171 * _e3171)) + (_e3157 * _e3157))));
                let _e3194 = (f32((bitcast<i32>((_e2899[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3200 = (f32((bitcast<i32>(_e2899[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3204 = ((1f - abs(_e3194)) - abs(_e3200));
                if (_e3204 < 0f) {
                    phi_3877_ = -(_e3204);
                } else {
                    phi_3877_ = 0f;
                }
                let _e3208 = phi_3877_;
                if (_e3194 < 0f) {
                    phi_3884_ = (_e3194 + _e3208);
                } else {
                    phi_3884_ = (_e3194 - _e3208);
                }
                let _e3213 = phi_3884_;
                if (_e3200 < 0f) {
                    phi_3891_ = (_e3200 + _e3208);
                } else {
                    phi_3891_ = (_e3200 - _e3208);
                }
                let _e3218 = phi_3891_;
                let _e3225 = (1f / sqrt((((_e3213 * _e3213) + (_e3218 * _e3218)) + (_e3204 * _e3204))));
                let _e3244 = (f32((bitcast<i32>((_e2899[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3250 = (f32((bitcast<i32>(_e2899[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3254 = ((1f - abs(_e3244)) - abs(_e3250));
                if (_e3254 < 0f) {
                    phi_3929_ = -(_e3254);
                } else {
                    phi_3929_ = 0f;
                }
                let _e3258 = phi_3929_;
                if (_e3244 < 0f) {
                    phi_3936_ = (_e3244 + _e3258);
                } else {
                    phi_3936_ = (_e3244 - _e3258);
                }
                let _e3263 = phi_3936_;
                if (_e3250 < 0f) {
                    phi_3943_ = (_e3250 + _e3258);
                } else {
                    phi_3943_ = (_e3250 - _e3258);
                }
                let _e3268 = phi_3943_;
                let _e3275 = (1f / sqrt((((_e3263 * _e3263) + (_e3268 * _e3268)) + (_e3254 * _e3254))));
                let _e3282 = ((((_e3166 * _e3178) * _e2631) + ((_e3213 * _e3225) * _e2625.u)) + ((_e3263 * _e3275) * _e2625.v));
                let _e3283 = ((((_e3171 * _e3178) * _e2631) + ((_e3218 * _e3225) * _e2625.u)) + ((_e3268 * _e3275) * _e2625.v));
                let _e3284 = ((((_e3157 * _e3178) * _e2631) + ((_e3204 * _e3225) * _e2625.u)) + ((_e3254 * _e3275) * _e2625.v));
                if (_e2625.instance < _e91) {
                } else {
                    return;
                }
                let _e3291 = instances.member[(0u + _e2625.instance)].world_to_object[0u];
                let _e3300 = instances.member[(0u + _e2625.instance)].world_to_object[1u];
                let _e3312 = instances.member[(0u + _e2625.instance)].world_to_object[2u];
                let _e3319 = (((_e3291.x * _e3282) + (_e3300.x * _e3283)) + (_e3312.x * _e3284));
                let _e3320 = (((_e3291.y * _e3282) + (_e3300.y * _e3283)) + (_e3312.y * _e3284));
                let _e3321 = (((_e3291.z * _e3282) + (_e3300.z * _e3283)) + (_e3312.z * _e3284));
                let _e3327 = sqrt((((_e3319 * _e3319) + (_e3320 * _e3320)) + (_e3321 * _e3321)));
                if (_e3327 > 0f) {
                    let _e3329 = (_e3319 / _e3327);
                    let _e3330 = (_e3320 / _e3327);
                    let _e3331 = (_e3321 / _e3327);
                    if ((((_e3329 * _e2877.x) + (_e3330 * _e2877.y)) + (_e3331 * _e2877.z)) < 0f) {
                        phi_4029_ = vec3<f32>(-(_e3329), -(_e3330), -(_e3331));
                    } else {
                        phi_4029_ = vec3<f32>(_e3329, _e3330, _e3331);
                    }
                    let _e3347 = phi_4029_;
                    phi_4030_ = _e3347;
                } else {
                    phi_4030_ = _e2877;
                }
                let _e3349 = phi_4030_;
                phi_4031_ = _e3349;
            }
            let _e3351 = phi_4031_;
            if (_e3123 > 0f) {
                if (_e3123 < 1f) {
                    phi_4040_ = _e3123;
                } else {
                    phi_4040_ = 1f;
                }
                let _e3355 = phi_4040_;
                phi_4041_ = _e3355;
            } else {
                phi_4041_ = 0f;
            }
            let _e3357 = phi_4041_;
            if (_e3125 > 0f) {
                if (_e3125 < 1f) {
                    phi_4051_ = _e3125;
                } else {
                    phi_4051_ = 1f;
                }
                let _e3362 = phi_4051_;
                phi_4052_ = _e3362;
            } else {
                phi_4052_ = 0f;
            }
            let _e3364 = phi_4052_;
            if (_e3127 > 0f) {
                if (_e3127 < 1f) {
                    phi_4062_ = _e3127;
                } else {
                    phi_4062_ = 1f;
                }
                let _e3369 = phi_4062_;
                phi_4063_ = _e3369;
            } else {
                phi_4063_ = 0f;
            }
            let _e3371 = phi_4063_;
            let _e3374 = ((sqrt(_e3357) * 255f) + 0.5f);
            let _e3383 = ((sqrt(_e3364) * 255f) + 0.5f);
            let _e3395 = ((sqrt(_e3371) * 255f) + 0.5f);
            phi_4098_ = abi_Sample(vec3<f32>(_e2785, _e2786, _e2787), _e3129, _e2877, _e3134, _e3351, ((select(select(u32(_e3374), 0u, (_e3374 < bitcast<f32>(0u))), 4294967295u, (_e3374 > bitcast<f32>(1333788671u))) | (select(select(u32(_e3383), 0u, (_e3383 < bitcast<f32>(0u))), 4294967295u, (_e3383 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e3395), 0u, (_e3395 < bitcast<f32>(0u))), 4294967295u, (_e3395 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_4098_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e3409 = phi_4098_;
        if (_e100.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e100.shift)] = _e3409;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_instanced_color_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
