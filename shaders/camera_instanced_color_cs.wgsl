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
    var phi_216_: lt_mask_LightPlace;
    var phi_217_: bool;
    var phi_218_: lt_mask_LightPlace;
    var phi_219_: bool;
    var phi_224_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_216_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_217_ = false;
        } else {
            phi_216_ = lt_mask_LightPlace();
            phi_217_ = true;
        }
        let _e82 = phi_216_;
        let _e84 = phi_217_;
        phi_218_ = _e82;
        phi_219_ = _e84;
    } else {
        phi_218_ = lt_mask_LightPlace();
        phi_219_ = true;
    }
    let _e86 = phi_218_;
    let _e88 = phi_219_;
    if _e88 {
        phi_224_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_224_ = _e86;
    }
    let _e93 = phi_224_;
    return lt_mask_LightPlace(_e93.word, _e93.shift);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_239_: bool;
    var phi_243_: f32;

    if (param_3 != param_3) {
        phi_239_ = true;
    } else {
        let _e72 = (param_4 >= param_3);
        if _e72 {
        }
        phi_239_ = _e72;
    }
    let _e74 = phi_239_;
    if _e74 {
        phi_243_ = param_4;
    } else {
        phi_243_ = param_3;
    }
    let _e76 = phi_243_;
    return _e76;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_255_: bool;
    var phi_259_: f32;

    if (param_5 != param_5) {
        phi_255_ = true;
    } else {
        let _e72 = (param_6 <= param_5);
        if _e72 {
        }
        phi_255_ = _e72;
    }
    let _e74 = phi_255_;
    if _e74 {
        phi_259_ = param_6;
    } else {
        phi_259_ = param_5;
    }
    let _e76 = phi_259_;
    return _e76;
}

fn _lt_shaders_texture_TextureView_quad(param_7: ptr<function, texture_TextureView>, param_8: f32, param_9: f32) -> texture_TexelQuad {
    var phi_301_: f32;
    var phi_306_: f32;
    var phi_307_: bool;
    var phi_308_: f32;
    var phi_309_: bool;
    var phi_313_: f32;
    var phi_339_: f32;
    var phi_344_: f32;
    var phi_345_: bool;
    var phi_346_: f32;
    var phi_347_: bool;
    var phi_351_: f32;
    var phi_359_: f32;
    var phi_360_: f32;
    var phi_361_: f32;
    var phi_370_: f32;
    var phi_371_: f32;
    var phi_389_: u32;
    var phi_403_: u32;
    var phi_410_: u32;
    var phi_415_: u32;
    var phi_421_: u32;
    var phi_426_: u32;
    var phi_428_: texture_Axis;
    var phi_456_: f32;
    var phi_461_: f32;
    var phi_462_: bool;
    var phi_463_: f32;
    var phi_464_: bool;
    var phi_468_: f32;
    var phi_494_: f32;
    var phi_499_: f32;
    var phi_500_: bool;
    var phi_501_: f32;
    var phi_502_: bool;
    var phi_506_: f32;
    var phi_514_: f32;
    var phi_515_: f32;
    var phi_516_: f32;
    var phi_525_: f32;
    var phi_526_: f32;
    var phi_544_: u32;
    var phi_558_: u32;
    var phi_565_: u32;
    var phi_570_: u32;
    var phi_576_: u32;
    var phi_581_: u32;
    var phi_583_: texture_Axis;

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
                phi_301_ = 1f;
            } else {
                phi_301_ = 0f;
            }
            let _e103 = phi_301_;
            if (param_8 < 8388608f) {
                phi_306_ = (_e100 - _e103);
                phi_307_ = false;
            } else {
                phi_306_ = f32();
                phi_307_ = true;
            }
            let _e106 = phi_306_;
            let _e108 = phi_307_;
            phi_308_ = _e106;
            phi_309_ = _e108;
        } else {
            phi_308_ = f32();
            phi_309_ = true;
        }
        let _e110 = phi_308_;
        let _e112 = phi_309_;
        if _e112 {
            phi_313_ = param_8;
        } else {
            phi_313_ = _e110;
        }
        let _e114 = phi_313_;
        phi_361_ = (param_8 - _e114);
    } else {
        if (_e87 == 1u) {
            let _e117 = (param_8 * 0.5f);
            if (_e117 > -8388608f) {
                let _e129 = f32(select(0i, select(select(i32(_e117), i32(-2147483648), (_e117 < bitcast<f32>(3472883712u))), 2147483647i, (_e117 > bitcast<f32>(1325400063u))), (_e117 == _e117)));
                if (_e129 > _e117) {
                    phi_339_ = 1f;
                } else {
                    phi_339_ = 0f;
                }
                let _e132 = phi_339_;
                if (_e117 < 8388608f) {
                    phi_344_ = (_e129 - _e132);
                    phi_345_ = false;
                } else {
                    phi_344_ = f32();
                    phi_345_ = true;
                }
                let _e135 = phi_344_;
                let _e137 = phi_345_;
                phi_346_ = _e135;
                phi_347_ = _e137;
            } else {
                phi_346_ = f32();
                phi_347_ = true;
            }
            let _e139 = phi_346_;
            let _e141 = phi_347_;
            if _e141 {
                phi_351_ = _e117;
            } else {
                phi_351_ = _e139;
            }
            let _e143 = phi_351_;
            let _e145 = (param_8 - (2f * _e143));
            if (_e145 > 1f) {
                phi_359_ = (2f - _e145);
            } else {
                phi_359_ = _e145;
            }
            let _e149 = phi_359_;
            phi_360_ = _e149;
        } else {
            phi_360_ = param_8;
        }
        let _e151 = phi_360_;
        phi_361_ = _e151;
    }
    let _e153 = phi_361_;
    if (_e153 > 0f) {
        if (_e153 < 1f) {
            phi_370_ = _e153;
        } else {
            phi_370_ = 1f;
        }
        let _e157 = phi_370_;
        phi_371_ = _e157;
    } else {
        phi_371_ = 0f;
    }
    let _e159 = phi_371_;
    let _e160 = (_e74 - 1u);
    let _e162 = (_e159 * f32(_e74));
    if _e82 {
        let _e169 = select(select(u32(_e162), 0u, (_e162 < bitcast<f32>(0u))), 4294967295u, (_e162 > bitcast<f32>(1333788671u)));
        if (_e160 < _e169) {
            phi_389_ = _e160;
        } else {
            phi_389_ = _e169;
        }
        let _e172 = phi_389_;
        phi_428_ = texture_Axis(_e172, _e172, 0f);
    } else {
        let _e174 = (_e162 + 0.5f);
        let _e181 = select(select(u32(_e174), 0u, (_e174 < bitcast<f32>(0u))), 4294967295u, (_e174 > bitcast<f32>(1333788671u)));
        if (_e74 < _e181) {
            phi_403_ = _e74;
        } else {
            phi_403_ = _e181;
        }
        let _e184 = phi_403_;
        if (_e87 == 0u) {
            phi_410_ = _e160;
        } else {
            phi_410_ = 0u;
        }
        let _e189 = phi_410_;
        if (_e87 == 0u) {
            phi_415_ = 0u;
        } else {
            phi_415_ = _e160;
        }
        let _e192 = phi_415_;
        if (_e184 == 0u) {
            phi_421_ = _e189;
        } else {
            phi_421_ = (_e184 - 1u);
        }
        let _e196 = phi_421_;
        if (_e184 > _e160) {
            phi_426_ = _e192;
        } else {
            phi_426_ = _e184;
        }
        let _e199 = phi_426_;
        phi_428_ = texture_Axis(_e196, _e199, (_e174 - f32(_e184)));
    }
    let _e202 = phi_428_;
    let _e204 = (*param_7).flags;
    let _e207 = ((_e204 >> bitcast<u32>(6u)) & 3u);
    if (_e207 == 0u) {
        if (param_9 > -8388608f) {
            let _e220 = f32(select(0i, select(select(i32(param_9), i32(-2147483648), (param_9 < bitcast<f32>(3472883712u))), 2147483647i, (param_9 > bitcast<f32>(1325400063u))), (param_9 == param_9)));
            if (_e220 > param_9) {
                phi_456_ = 1f;
            } else {
                phi_456_ = 0f;
            }
            let _e223 = phi_456_;
            if (param_9 < 8388608f) {
                phi_461_ = (_e220 - _e223);
                phi_462_ = false;
            } else {
                phi_461_ = f32();
                phi_462_ = true;
            }
            let _e226 = phi_461_;
            let _e228 = phi_462_;
            phi_463_ = _e226;
            phi_464_ = _e228;
        } else {
            phi_463_ = f32();
            phi_464_ = true;
        }
        let _e230 = phi_463_;
        let _e232 = phi_464_;
        if _e232 {
            phi_468_ = param_9;
        } else {
            phi_468_ = _e230;
        }
        let _e234 = phi_468_;
        phi_516_ = (param_9 - _e234);
    } else {
        if (_e207 == 1u) {
            let _e237 = (param_9 * 0.5f);
            if (_e237 > -8388608f) {
                let _e249 = f32(select(0i, select(select(i32(_e237), i32(-2147483648), (_e237 < bitcast<f32>(3472883712u))), 2147483647i, (_e237 > bitcast<f32>(1325400063u))), (_e237 == _e237)));
                if (_e249 > _e237) {
                    phi_494_ = 1f;
                } else {
                    phi_494_ = 0f;
                }
                let _e252 = phi_494_;
                if (_e237 < 8388608f) {
                    phi_499_ = (_e249 - _e252);
                    phi_500_ = false;
                } else {
                    phi_499_ = f32();
                    phi_500_ = true;
                }
                let _e255 = phi_499_;
                let _e257 = phi_500_;
                phi_501_ = _e255;
                phi_502_ = _e257;
            } else {
                phi_501_ = f32();
                phi_502_ = true;
            }
            let _e259 = phi_501_;
            let _e261 = phi_502_;
            if _e261 {
                phi_506_ = _e237;
            } else {
                phi_506_ = _e259;
            }
            let _e263 = phi_506_;
            let _e265 = (param_9 - (2f * _e263));
            if (_e265 > 1f) {
                phi_514_ = (2f - _e265);
            } else {
                phi_514_ = _e265;
            }
            let _e269 = phi_514_;
            phi_515_ = _e269;
        } else {
            phi_515_ = param_9;
        }
        let _e271 = phi_515_;
        phi_516_ = _e271;
    }
    let _e273 = phi_516_;
    if (_e273 > 0f) {
        if (_e273 < 1f) {
            phi_525_ = _e273;
        } else {
            phi_525_ = 1f;
        }
        let _e277 = phi_525_;
        phi_526_ = _e277;
    } else {
        phi_526_ = 0f;
    }
    let _e279 = phi_526_;
    let _e280 = (_e78 - 1u);
    let _e282 = (_e279 * f32(_e78));
    if _e82 {
        let _e289 = select(select(u32(_e282), 0u, (_e282 < bitcast<f32>(0u))), 4294967295u, (_e282 > bitcast<f32>(1333788671u)));
        if (_e280 < _e289) {
            phi_544_ = _e280;
        } else {
            phi_544_ = _e289;
        }
        let _e292 = phi_544_;
        phi_583_ = texture_Axis(_e292, _e292, 0f);
    } else {
        let _e294 = (_e282 + 0.5f);
        let _e301 = select(select(u32(_e294), 0u, (_e294 < bitcast<f32>(0u))), 4294967295u, (_e294 > bitcast<f32>(1333788671u)));
        if (_e78 < _e301) {
            phi_558_ = _e78;
        } else {
            phi_558_ = _e301;
        }
        let _e304 = phi_558_;
        if (_e207 == 0u) {
            phi_565_ = _e280;
        } else {
            phi_565_ = 0u;
        }
        let _e309 = phi_565_;
        if (_e207 == 0u) {
            phi_570_ = 0u;
        } else {
            phi_570_ = _e280;
        }
        let _e312 = phi_570_;
        if (_e304 == 0u) {
            phi_576_ = _e309;
        } else {
            phi_576_ = (_e304 - 1u);
        }
        let _e316 = phi_576_;
        if (_e304 > _e280) {
            phi_581_ = _e312;
        } else {
            phi_581_ = _e304;
        }
        let _e319 = phi_581_;
        phi_583_ = texture_Axis(_e316, _e319, (_e294 - f32(_e304)));
    }
    let _e322 = phi_583_;
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
    var phi_642_: f32;

    if (param_12 > param_13) {
        phi_642_ = param_12;
    } else {
        phi_642_ = param_13;
    }
    let _e73 = phi_642_;
    return _e73;
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var local_2: lt_bvh_traverse_Stack;
    var phi_791_: bool;
    var phi_792_: bool;
    var phi_793_: bool;
    var phi_797_: bool;
    var phi_798_: bool;
    var phi_799_: bool;
    var phi_800_: bool;
    var phi_801_: bool;
    var phi_802_: bool;
    var phi_803_: bool;
    var phi_804_: bool;
    var phi_805_: bool;
    var phi_806_: bool;
    var phi_807_: bool;
    var phi_808_: bool;
    var phi_809_: bool;
    var phi_810_: bool;
    var phi_811_: bool;
    var phi_812_: bool;
    var phi_813_: bool;
    var phi_814_: bool;
    var phi_818_: bool;
    var phi_822_: bool;
    var phi_897_: f32;
    var phi_904_: f32;
    var phi_912_: f32;
    var phi_919_: f32;
    var phi_927_: f32;
    var phi_934_: f32;
    var phi_959_: f32;
    var phi_964_: f32;
    var phi_969_: f32;
    var phi_991_: u32;
    var phi_996_: u32;
    var phi_1001_: u32;
    var phi_1115_: bool;
    var phi_1116_: bool;
    var phi_1147_: u32;
    var phi_1149_: u32;
    var phi_1152_: lt_bvh_Hit;
    var phi_1237_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1264_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1291_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1297_: u32;
    var phi_1300_: u32;
    var phi_1314_: u32;
    var phi_1324_: u32;
    var phi_1334_: u32;
    var phi_1352_: u32;
    var phi_1362_: u32;
    var phi_1372_: u32;
    var phi_1408_: u32;
    var phi_1421_: u32;
    var phi_1426_: u32;
    var phi_1427_: u32;
    var phi_1428_: u32;
    var phi_1298_: u32;
    var phi_1301_: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_1486_: u32;
    var phi_1489_: lt_bvh_Hit;
    var phi_1544_: f32;
    var phi_1549_: f32;
    var phi_1554_: f32;
    var phi_1562_: f32;
    var phi_1567_: f32;
    var phi_1572_: f32;
    var phi_1728_: bool;
    var phi_1729_: bool;
    var phi_1730_: bool;
    var phi_1734_: bool;
    var phi_1735_: bool;
    var phi_1736_: bool;
    var phi_1737_: bool;
    var phi_1738_: bool;
    var phi_1739_: bool;
    var phi_1740_: bool;
    var phi_1741_: bool;
    var phi_1742_: bool;
    var phi_1743_: bool;
    var phi_1744_: bool;
    var phi_1745_: bool;
    var phi_1746_: bool;
    var phi_1747_: bool;
    var phi_1748_: bool;
    var phi_1749_: bool;
    var phi_1750_: bool;
    var phi_1751_: bool;
    var phi_1755_: bool;
    var phi_1759_: bool;
    var phi_1829_: f32;
    var phi_1836_: f32;
    var phi_1843_: f32;
    var phi_1850_: f32;
    var phi_1857_: f32;
    var phi_1864_: f32;
    var phi_1881_: f32;
    var phi_1886_: f32;
    var phi_1891_: f32;
    var phi_1919_: bool;
    var phi_1920_: bool;
    var phi_1928_: u32;
    var phi_1929_: u32;
    var phi_1940_: vec3<f32>;
    var phi_1941_: vec3<f32>;
    var phi_1954_: u32;
    var phi_1959_: u32;
    var phi_1964_: u32;
    var phi_2078_: bool;
    var phi_2079_: bool;
    var phi_2110_: u32;
    var phi_2112_: lt_bvh_Hit;
    var phi_2115_: u32;
    var phi_2196_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2223_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2250_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2256_: u32;
    var phi_2259_: u32;
    var phi_2273_: u32;
    var phi_2283_: u32;
    var phi_2293_: u32;
    var phi_2311_: u32;
    var phi_2321_: u32;
    var phi_2331_: u32;
    var phi_2367_: u32;
    var phi_2380_: u32;
    var phi_2385_: u32;
    var phi_2386_: u32;
    var phi_2387_: u32;
    var phi_2257_: u32;
    var phi_2260_: u32;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_2445_: lt_bvh_Hit;
    var phi_2448_: u32;
    var phi_2492_: vec3<f32>;
    var phi_2493_: vec3<f32>;
    var phi_2522_: vec3<f32>;
    var phi_2523_: vec3<f32>;
    var phi_2552_: vec3<f32>;
    var phi_2553_: vec3<f32>;
    var phi_2571_: bool;
    var phi_2572_: bool;
    var phi_2576_: f32;
    var phi_2577_: f32;
    var phi_2578_: f32;
    var phi_2579_: f32;
    var phi_2587_: f32;
    var phi_2597_: bool;
    var phi_2598_: bool;
    var phi_2602_: f32;
    var phi_2603_: f32;
    var phi_2604_: f32;
    var phi_2605_: f32;
    var phi_2613_: f32;
    var phi_2623_: bool;
    var phi_2624_: bool;
    var phi_2628_: f32;
    var phi_2629_: f32;
    var phi_2630_: f32;
    var phi_2631_: f32;
    var phi_2639_: f32;
    var phi_2654_: f32;
    var phi_2655_: bool;
    var phi_2656_: f32;
    var phi_2657_: bool;
    var phi_2658_: f32;
    var phi_2659_: bool;
    var phi_2677_: f32;
    var phi_2678_: bool;
    var phi_2679_: bool;
    var phi_2680_: f32;
    var phi_2681_: bool;
    var phi_2682_: bool;
    var phi_2686_: bool;
    var phi_2687_: f32;
    var phi_2688_: bool;
    var phi_2716_: vec3<f32>;
    var phi_2717_: vec3<f32>;
    var phi_2742_: vec3<f32>;
    var phi_2743_: vec3<f32>;
    var phi_2768_: vec3<f32>;
    var phi_2769_: vec3<f32>;
    var phi_2825_: f32;
    var phi_2834_: f32;
    var phi_2843_: f32;
    var phi_2852_: f32;
    var phi_2859_: f32;
    var phi_2866_: f32;
    var phi_2879_: f32;
    var phi_2888_: f32;
    var phi_2897_: f32;
    var phi_2906_: f32;
    var phi_2913_: f32;
    var phi_2920_: f32;
    var phi_2937_: f32;
    var phi_2942_: f32;
    var phi_2947_: f32;
    var phi_2955_: f32;
    var phi_2960_: f32;
    var phi_2965_: f32;
    var phi_2977_: f32;
    var phi_2982_: f32;
    var phi_2987_: f32;
    var phi_2992_: f32;
    var phi_2997_: lt_bvh_triangle_Intersection;
    var phi_2998_: bool;
    var phi_2999_: lt_bvh_triangle_Intersection;
    var phi_3000_: bool;
    var phi_3004_: lt_bvh_triangle_Intersection;
    var phi_3005_: bool;
    var phi_3006_: lt_bvh_triangle_Intersection;
    var phi_3007_: bool;
    var phi_3008_: bool;
    var phi_3012_: bool;
    var phi_3016_: lt_bvh_triangle_Intersection;
    var phi_3054_: bool;
    var phi_3055_: bool;
    var phi_3056_: bool;
    var phi_3057_: bool;
    var phi_3058_: bool;
    var phi_3059_: bool;
    var phi_3063_: bool;
    var phi_3064_: bool;
    var phi_3078_: bool;
    var phi_3086_: lt_bvh_Hit;
    var phi_3087_: lt_bvh_Hit;
    var phi_3088_: lt_bvh_Hit;
    var phi_3089_: lt_bvh_Hit;
    var phi_2446_: lt_bvh_Hit;
    var phi_2449_: u32;
    var phi_3090_: bool;
    var phi_3129_: bool;
    var phi_3130_: bool;
    var phi_3161_: u32;
    var phi_2113_: lt_bvh_Hit;
    var phi_2116_: u32;
    var phi_3162_: lt_bvh_Hit;
    var phi_3163_: lt_bvh_Hit;
    var phi_3164_: bool;
    var phi_3168_: lt_bvh_Hit;
    var phi_3169_: lt_bvh_Hit;
    var phi_3170_: lt_bvh_Hit;
    var phi_3171_: lt_bvh_Hit;
    var phi_1487_: u32;
    var phi_1490_: lt_bvh_Hit;
    var phi_3172_: bool;
    var phi_3211_: bool;
    var phi_3212_: bool;
    var phi_3243_: u32;
    var phi_1150_: u32;
    var phi_1153_: lt_bvh_Hit;
    var phi_3244_: lt_bvh_Hit;
    var phi_3245_: lt_bvh_Hit;
    var phi_3246_: bool;
    var phi_3250_: lt_bvh_Hit;
    var phi_3437_: f32;
    var phi_3442_: f32;
    var phi_3447_: f32;
    var phi_3455_: f32;
    var phi_3460_: f32;
    var phi_3465_: f32;
    var phi_3529_: vec3<f32>;
    var phi_3772_: vec3<f32>;
    var phi_3787_: u32;
    var phi_3814_: f32;
    var phi_3821_: f32;
    var phi_3828_: f32;
    var phi_3863_: f32;
    var phi_3870_: f32;
    var phi_3877_: f32;
    var phi_3915_: f32;
    var phi_3922_: f32;
    var phi_3929_: f32;
    var phi_4015_: vec3<f32>;
    var phi_4016_: vec3<f32>;
    var phi_4017_: vec3<f32>;
    var phi_4026_: f32;
    var phi_4027_: f32;
    var phi_4037_: f32;
    var phi_4038_: f32;
    var phi_4048_: f32;
    var phi_4049_: f32;
    var phi_4084_: abi_Sample;
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
        let _e169 = abs(_e157.direction.x);
        let _e171 = abs(_e157.direction.y);
        let _e173 = abs(_e157.direction.z);
        if (abs(_e157.origin.x) < 1000000000000000f) {
            if (abs(_e157.origin.y) < 1000000000000000f) {
                if (abs(_e157.origin.z) < 1000000000000000f) {
                    if (_e169 < 1000000000000000f) {
                        if (_e171 < 1000000000000000f) {
                            if (_e173 < 1000000000000000f) {
                                if (_e169 > 0f) {
                                    phi_792_ = bool();
                                    phi_793_ = true;
                                } else {
                                    let _e181 = (_e171 > 0f);
                                    if _e181 {
                                        phi_791_ = bool();
                                    } else {
                                        phi_791_ = (_e173 > 0f);
                                    }
                                    let _e184 = phi_791_;
                                    phi_792_ = _e184;
                                    phi_793_ = _e181;
                                }
                                let _e186 = phi_792_;
                                let _e188 = phi_793_;
                                if _e188 {
                                    phi_797_ = true;
                                } else {
                                    phi_797_ = _e186;
                                }
                                let _e190 = phi_797_;
                                phi_798_ = _e190;
                                phi_799_ = false;
                            } else {
                                phi_798_ = bool();
                                phi_799_ = true;
                            }
                            let _e192 = phi_798_;
                            let _e194 = phi_799_;
                            phi_800_ = _e192;
                            phi_801_ = false;
                            phi_802_ = _e194;
                        } else {
                            phi_800_ = bool();
                            phi_801_ = true;
                            phi_802_ = false;
                        }
                        let _e196 = phi_800_;
                        let _e198 = phi_801_;
                        let _e200 = phi_802_;
                        phi_803_ = _e196;
                        phi_804_ = _e198;
                        phi_805_ = _e200;
                    } else {
                        phi_803_ = bool();
                        phi_804_ = true;
                        phi_805_ = false;
                    }
                    let _e202 = phi_803_;
                    let _e204 = phi_804_;
                    let _e206 = phi_805_;
                    phi_806_ = _e202;
                    phi_807_ = _e204;
                    phi_808_ = _e206;
                } else {
                    phi_806_ = bool();
                    phi_807_ = true;
                    phi_808_ = false;
                }
                let _e208 = phi_806_;
                let _e210 = phi_807_;
                let _e212 = phi_808_;
                phi_809_ = _e208;
                phi_810_ = _e210;
                phi_811_ = _e212;
            } else {
                phi_809_ = bool();
                phi_810_ = true;
                phi_811_ = false;
            }
            let _e214 = phi_809_;
            let _e216 = phi_810_;
            let _e218 = phi_811_;
            phi_812_ = _e214;
            phi_813_ = _e216;
            phi_814_ = _e218;
        } else {
            phi_812_ = bool();
            phi_813_ = true;
            phi_814_ = false;
        }
        let _e220 = phi_812_;
        let _e222 = phi_813_;
        let _e224 = phi_814_;
        if _e222 {
            phi_818_ = true;
        } else {
            phi_818_ = _e224;
        }
        let _e226 = phi_818_;
        if _e226 {
            phi_822_ = false;
        } else {
            phi_822_ = _e220;
        }
        let _e228 = phi_822_;
        if _e228 {
            let _e229 = (_e106 >= _e76);
            if _e229 {
                phi_3244_ = lt_bvh_Hit();
            } else {
                if (_e106 < _e76) {
                } else {
                    return;
                }
                let _e235 = nodes.member[(0u + _e106)].frame[0u];
                let _e239 = nodes.member[(0u + _e106)].frame[1u];
                let _e243 = nodes.member[(0u + _e106)].frame[2u];
                let _e247 = nodes.member[(0u + _e106)].frame[0u];
                let _e251 = nodes.member[(0u + _e106)].frame[1u];
                let _e255 = nodes.member[(0u + _e106)].frame[2u];
                let _e259 = nodes.member[(0u + _e106)].frame[3u];
                let _e297 = core_intrinsics_maximum_number_nsz_f32_(abs(_e157.direction.x), abs(_e157.direction.y));
                let _e298 = core_intrinsics_maximum_number_nsz_f32_(_e297, abs(_e157.direction.z));
                let _e299 = (_e298 * 0.0000000000009094947f);
                if (abs(_e157.direction.x) < _e299) {
                    phi_897_ = _e299;
                } else {
                    phi_897_ = abs(_e157.direction.x);
                }
                let _e305 = phi_897_;
                if (_e157.direction.x < 0f) {
                    phi_904_ = (-1f / _e305);
                } else {
                    phi_904_ = (1f / _e305);
                }
                let _e310 = phi_904_;
                if (abs(_e157.direction.y) < _e299) {
                    phi_912_ = _e299;
                } else {
                    phi_912_ = abs(_e157.direction.y);
                }
                let _e316 = phi_912_;
                if (_e157.direction.y < 0f) {
                    phi_919_ = (-1f / _e316);
                } else {
                    phi_919_ = (1f / _e316);
                }
                let _e321 = phi_919_;
                if (abs(_e157.direction.z) < _e299) {
                    phi_927_ = _e299;
                } else {
                    phi_927_ = abs(_e157.direction.z);
                }
                let _e327 = phi_927_;
                if (_e157.direction.z < 0f) {
                    phi_934_ = (-1f / _e327);
                } else {
                    phi_934_ = (1f / _e327);
                }
                let _e332 = phi_934_;
                let _e340 = abs((bitcast<f32>(_e235) - _e157.origin.x));
                let _e341 = abs((bitcast<f32>(_e239) - _e157.origin.y));
                let _e342 = abs((bitcast<f32>(_e243) - _e157.origin.z));
                let _e350 = abs(((bitcast<f32>(_e247) + (bitcast<f32>((((_e259 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e157.origin.x));
                let _e351 = abs(((bitcast<f32>(_e251) + (bitcast<f32>((((_e259 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e157.origin.y));
                let _e352 = abs(((bitcast<f32>(_e255) + (bitcast<f32>((((_e259 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e157.origin.z));
                if (_e340 > _e350) {
                    phi_959_ = _e340;
                } else {
                    phi_959_ = _e350;
                }
                let _e355 = phi_959_;
                if (_e341 > _e351) {
                    phi_964_ = _e341;
                } else {
                    phi_964_ = _e351;
                }
                let _e358 = phi_964_;
                if (_e342 > _e352) {
                    phi_969_ = _e342;
                } else {
                    phi_969_ = _e352;
                }
                let _e361 = phi_969_;
                let _e362 = core_intrinsics_maximum_number_nsz_f32_(_e355, _e358);
                let _e363 = core_intrinsics_maximum_number_nsz_f32_(_e362, _e361);
                let _e368 = (_e363 * 0.0000019073486f);
                let _e369 = (abs(_e310) * _e368);
                let _e370 = (abs(_e321) * _e368);
                let _e371 = (abs(_e332) * _e368);
                let _e375 = (_e363 * 0.0000009536743f);
                let _e376 = (abs(_e310) * _e375);
                let _e377 = (abs(_e321) * _e375);
                let _e378 = (abs(_e332) * _e375);
                if (_e310 < 0f) {
                    phi_991_ = 0u;
                } else {
                    phi_991_ = 1u;
                }
                let _e381 = phi_991_;
                if (_e321 < 0f) {
                    phi_996_ = 0u;
                } else {
                    phi_996_ = 2u;
                }
                let _e384 = phi_996_;
                if (_e332 < 0f) {
                    phi_1001_ = 0u;
                } else {
                    phi_1001_ = 4u;
                }
                let _e387 = phi_1001_;
                let _e389 = ((_e381 | _e384) | _e387);
                let _e390 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e106, 2147483648u);
                local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e390.first[0], _e390.first[1], _e390.first[2], _e390.first[3], _e390.first[4], _e390.first[5], _e390.first[6], _e390.first[7], _e390.first[8], _e390.first[9], _e390.first[10], _e390.first[11], _e390.first[12], _e390.first[13], _e390.first[14], _e390.first[15], _e390.first[16], _e390.first[17], _e390.first[18], _e390.first[19], _e390.first[20], _e390.first[21], _e390.first[22], _e390.first[23], _e390.first[24], _e390.first[25], _e390.first[26], _e390.first[27], _e390.first[28], _e390.first[29], _e390.first[30], _e390.first[31]), array<u32, 32>(_e390.mask[0], _e390.mask[1], _e390.mask[2], _e390.mask[3], _e390.mask[4], _e390.mask[5], _e390.mask[6], _e390.mask[7], _e390.mask[8], _e390.mask[9], _e390.mask[10], _e390.mask[11], _e390.mask[12], _e390.mask[13], _e390.mask[14], _e390.mask[15], _e390.mask[16], _e390.mask[17], _e390.mask[18], _e390.mask[19], _e390.mask[20], _e390.mask[21], _e390.mask[22], _e390.mask[23], _e390.mask[24], _e390.mask[25], _e390.mask[26], _e390.mask[27], _e390.mask[28], _e390.mask[29], _e390.mask[30], _e390.mask[31]), _e390.len, _e390.group, _e390.group_mask);
                let _e464 = local_2.group_mask;
                if ((_e464 & 4278190080u) == 0u) {
                    let _e468 = local_2.len;
                    if (_e468 == 0u) {
                        phi_1115_ = false;
                    } else {
                        let _e472 = local_2.len;
                        local_2.len = (_e472 - 1u);
                        let _e475 = local_2.len;
                        if (_e475 < 32u) {
                        } else {
                            return;
                        }
                        let _e480 = local_2.first[(0u + _e475)];
                        local_2.group = _e480;
                        let _e483 = local_2.len;
                        if (_e483 < 32u) {
                        } else {
                            return;
                        }
                        let _e488 = local_2.mask[(0u + _e483)];
                        local_2.group_mask = _e488;
                        phi_1115_ = true;
                    }
                    let _e491 = phi_1115_;
                    phi_1116_ = _e491;
                } else {
                    phi_1116_ = true;
                }
                let _e493 = phi_1116_;
                if _e493 {
                    let _e495 = local_2.group_mask;
                    let _e501 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e495)), 32u, (_e495 == 0u)));
                    let _e505 = local_2.group_mask;
                    let _e519 = local_2.group_mask;
                    local_2.group_mask = (_e519 & ~((1u << bitcast<u32>((_e501 & 31u)))));
                    let _e522 = local_2.group;
                    phi_1147_ = (_e522 + countOneBits(((_e505 & ~((4294967295u << bitcast<u32>((((_e501 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1147_ = 4294967295u;
                }
                let _e525 = phi_1147_;
                phi_1149_ = _e525;
                phi_1152_ = _e159;
                loop {
                    let _e527 = phi_1149_;
                    let _e529 = phi_1152_;
                    local_12 = _e529;
                    let _e530 = (_e527 != 4294967295u);
                    if _e530 {
                        if (_e527 < _e76) {
                        } else {
                            return;
                        }
                        let _e538 = nodes.member[(0u + _e527)].frame[3u];
                        let _e563 = (bitcast<f32>((((_e538 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e310);
                        let _e564 = (bitcast<f32>((((_e538 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e321);
                        let _e565 = (bitcast<f32>((((_e538 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e332);
                        let _e568 = nodes.member[(0u + _e527)].frame[0u];
                        let _e572 = nodes.member[(0u + _e527)].frame[1u];
                        let _e576 = nodes.member[(0u + _e527)].frame[2u];
                        let _e584 = ((bitcast<f32>(_e568) - _e157.origin.x) * _e310);
                        let _e585 = ((bitcast<f32>(_e572) - _e157.origin.y) * _e321);
                        let _e586 = ((bitcast<f32>(_e576) - _e157.origin.z) * _e332);
                        let _e594 = nodes.member[(0u + _e527)].x;
                        if (_e310 < 0f) {
                            let _e605 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e594.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e611 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e605.unnamed.word, _e594.w), _e605.unnamed_1);
                            let _e617 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e611.unnamed, lt_mask_LightPlace(_e594.x, _e611.unnamed_1.shift));
                            phi_1237_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e617.unnamed, lt_mask_LightPlace(_e617.unnamed_1.word, _e594.y));
                        } else {
                            let _e633 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e594.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e639 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e633.unnamed.word, _e594.y), _e633.unnamed_1);
                            let _e645 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e639.unnamed, lt_mask_LightPlace(_e594.z, _e639.unnamed_1.shift));
                            phi_1237_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e645.unnamed, lt_mask_LightPlace(_e645.unnamed_1.word, _e594.w));
                        }
                        let _e653 = phi_1237_;
                        let _e663 = nodes.member[(0u + _e527)].y;
                        if (_e321 < 0f) {
                            let _e674 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e663.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e680 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e674.unnamed.word, _e663.w), _e674.unnamed_1);
                            let _e686 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e680.unnamed, lt_mask_LightPlace(_e663.x, _e680.unnamed_1.shift));
                            phi_1264_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e686.unnamed, lt_mask_LightPlace(_e686.unnamed_1.word, _e663.y));
                        } else {
                            let _e702 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e663.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e708 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e702.unnamed.word, _e663.y), _e702.unnamed_1);
                            let _e714 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e708.unnamed, lt_mask_LightPlace(_e663.z, _e708.unnamed_1.shift));
                            phi_1264_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e714.unnamed, lt_mask_LightPlace(_e714.unnamed_1.word, _e663.w));
                        }
                        let _e722 = phi_1264_;
                        let _e732 = nodes.member[(0u + _e527)].z;
                        if (_e332 < 0f) {
                            let _e743 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e732.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e749 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e743.unnamed.word, _e732.w), _e743.unnamed_1);
                            let _e755 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e749.unnamed, lt_mask_LightPlace(_e732.x, _e749.unnamed_1.shift));
                            phi_1291_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e755.unnamed, lt_mask_LightPlace(_e755.unnamed_1.word, _e732.y));
                        } else {
                            let _e771 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e732.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e777 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e771.unnamed.word, _e732.y), _e771.unnamed_1);
                            let _e783 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e777.unnamed, lt_mask_LightPlace(_e732.z, _e777.unnamed_1.shift));
                            phi_1291_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e783.unnamed, lt_mask_LightPlace(_e783.unnamed_1.word, _e732.w));
                        }
                        let _e791 = phi_1291_;
                        phi_1297_ = 0u;
                        phi_1300_ = 0u;
                        loop {
                            let _e801 = phi_1297_;
                            let _e803 = phi_1300_;
                            local_3 = _e803;
                            local_4 = _e803;
                            local_5 = _e803;
                            let _e804 = (_e801 < 8u);
                            if _e804 {
                                let _e806 = (_e801 >> bitcast<u32>(2i));
                                let _e807 = (_e801 & 3u);
                                if (_e806 == 0u) {
                                    phi_1314_ = _e653.unnamed.word;
                                } else {
                                    phi_1314_ = _e653.unnamed.shift;
                                }
                                let _e810 = phi_1314_;
                                if (_e806 == 0u) {
                                    phi_1324_ = _e722.unnamed.word;
                                } else {
                                    phi_1324_ = _e722.unnamed.shift;
                                }
                                let _e819 = phi_1324_;
                                if (_e806 == 0u) {
                                    phi_1334_ = _e791.unnamed.word;
                                } else {
                                    phi_1334_ = _e791.unnamed.shift;
                                }
                                let _e828 = phi_1334_;
                                let _e841 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e810 >> bitcast<u32>(((_e807 * 8u) & 31u))) & 255u)) * _e563) + (_e584 - _e369)), ((f32(((_e819 >> bitcast<u32>(((_e807 * 8u) & 31u))) & 255u)) * _e564) + (_e585 - _e370)));
                                let _e842 = core_intrinsics_maximum_number_nsz_f32_(_e841, ((f32(((_e828 >> bitcast<u32>(((_e807 * 8u) & 31u))) & 255u)) * _e565) + (_e586 - _e371)));
                                if (_e806 == 0u) {
                                    phi_1352_ = _e653.unnamed_1.word;
                                } else {
                                    phi_1352_ = _e653.unnamed_1.shift;
                                }
                                let _e845 = phi_1352_;
                                if (_e806 == 0u) {
                                    phi_1362_ = _e722.unnamed_1.word;
                                } else {
                                    phi_1362_ = _e722.unnamed_1.shift;
                                }
                                let _e854 = phi_1362_;
                                if (_e806 == 0u) {
                                    phi_1372_ = _e791.unnamed_1.word;
                                } else {
                                    phi_1372_ = _e791.unnamed_1.shift;
                                }
                                let _e863 = phi_1372_;
                                let _e876 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e845 >> bitcast<u32>(((_e807 * 8u) & 31u))) & 255u)) * _e563) + (_e584 + _e369)), ((f32(((_e854 >> bitcast<u32>(((_e807 * 8u) & 31u))) & 255u)) * _e564) + (_e585 + _e370)));
                                let _e877 = core_intrinsics_minimum_number_nsz_f32_(_e876, ((f32(((_e863 >> bitcast<u32>(((_e807 * 8u) & 31u))) & 255u)) * _e565) + (_e586 + _e371)));
                                if (_e842 <= _e877) {
                                    if (_e842 <= _e529.t) {
                                        if (_e877 >= _e157.tmin) {
                                            if (_e806 == 0u) {
                                                let _e884 = nodes.member[(0u + _e527)].links[2u];
                                                phi_1408_ = _e884;
                                            } else {
                                                let _e887 = nodes.member[(0u + _e527)].links[3u];
                                                phi_1408_ = _e887;
                                            }
                                            let _e889 = phi_1408_;
                                            let _e894 = ((_e889 >> bitcast<u32>(((_e807 * 8u) & 31u))) & 255u);
                                            let _e895 = (_e894 & 31u);
                                            if (_e895 >= 24u) {
                                                phi_1421_ = (24u + ((_e895 - 24u) ^ _e389));
                                            } else {
                                                phi_1421_ = _e895;
                                            }
                                            let _e901 = phi_1421_;
                                            phi_1426_ = (_e803 | ((_e894 >> bitcast<u32>(5i)) << bitcast<u32>((_e901 & 31u))));
                                        } else {
                                            phi_1426_ = _e803;
                                        }
                                        let _e909 = phi_1426_;
                                        phi_1427_ = _e909;
                                    } else {
                                        phi_1427_ = _e803;
                                    }
                                    let _e911 = phi_1427_;
                                    phi_1428_ = _e911;
                                } else {
                                    phi_1428_ = _e803;
                                }
                                let _e913 = phi_1428_;
                                phi_1298_ = (_e801 + 1u);
                                phi_1301_ = _e913;
                            } else {
                                phi_1298_ = u32();
                                phi_1301_ = u32();
                            }
                            let _e916 = phi_1298_;
                            let _e918 = phi_1301_;
                            continue;
                            continuing {
                                phi_1297_ = _e916;
                                phi_1300_ = _e918;
                                break if !(_e804);
                            }
                        }
                        let _e922 = nodes.member[(0u + _e527)].links[0u];
                        let _e926 = nodes.member[(0u + _e527)].frame[3u];
                        let _e930 = local_3;
                        if ((_e930 & 4278190080u) == 0u) {
                        } else {
                            let _e934 = local_2.group_mask;
                            if ((_e934 & 4278190080u) == 0u) {
                            } else {
                                let _e938 = local_2.len;
                                if (_e938 < 32u) {
                                    let _e941 = local_2.group;
                                    let _e943 = local_2.len;
                                    if (_e943 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.first[(0u + _e943)] = _e941;
                                    let _e949 = local_2.group_mask;
                                    let _e951 = local_2.len;
                                    if (_e951 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.mask[(0u + _e951)] = _e949;
                                    let _e958 = local_2.len;
                                    local_2.len = (_e958 + 1u);
                                }
                            }
                            local_2.group = (_e106 + _e922);
                            let _e962 = local_4;
                            local_2.group_mask = ((_e962 & 4278190080u) | (_e926 >> bitcast<u32>(24i)));
                        }
                        let _e967 = local_5;
                        phi_1486_ = (_e967 & 16777215u);
                        phi_1489_ = _e529;
                        loop {
                            let _e970 = phi_1486_;
                            let _e972 = phi_1489_;
                            local_11 = _e972;
                            if (_e970 == 0u) {
                                phi_1487_ = u32();
                                phi_1490_ = lt_bvh_Hit();
                                phi_3172_ = false;
                            } else {
                                let _e976 = nodes.member[(0u + _e527)].links[1u];
                                let _e980 = (_e976 + select(firstTrailingBit(_e970), 32u, (_e970 == 0u)));
                                if (_e980 < _e91) {
                                } else {
                                    return;
                                }
                                let _e987 = instances.member[(0u + _e980)].low_world;
                                let _e989 = instances.member[(0u + _e980)].high_world;
                                let _e999 = ((_e987.x - _e157.origin.x) * _e310);
                                let _e1000 = ((_e987.y - _e157.origin.y) * _e321);
                                let _e1001 = ((_e987.z - _e157.origin.z) * _e332);
                                let _e1011 = ((_e989.x - _e157.origin.x) * _e310);
                                let _e1012 = ((_e989.y - _e157.origin.y) * _e321);
                                let _e1013 = ((_e989.z - _e157.origin.z) * _e332);
                                if (_e999 < _e1011) {
                                    phi_1544_ = _e999;
                                } else {
                                    phi_1544_ = _e1011;
                                }
                                let _e1016 = phi_1544_;
                                if (_e1000 < _e1012) {
                                    phi_1549_ = _e1000;
                                } else {
                                    phi_1549_ = _e1012;
                                }
                                let _e1019 = phi_1549_;
                                if (_e1001 < _e1013) {
                                    phi_1554_ = _e1001;
                                } else {
                                    phi_1554_ = _e1013;
                                }
                                let _e1022 = phi_1554_;
                                if (_e999 > _e1011) {
                                    phi_1562_ = _e999;
                                } else {
                                    phi_1562_ = _e1011;
                                }
                                let _e1028 = phi_1562_;
                                if (_e1000 > _e1012) {
                                    phi_1567_ = _e1000;
                                } else {
                                    phi_1567_ = _e1012;
                                }
                                let _e1031 = phi_1567_;
                                if (_e1001 > _e1013) {
                                    phi_1572_ = _e1001;
                                } else {
                                    phi_1572_ = _e1013;
                                }
                                let _e1034 = phi_1572_;
                                let _e1038 = core_intrinsics_maximum_number_nsz_f32_((_e1016 - _e376), (_e1019 - _e377));
                                let _e1039 = core_intrinsics_maximum_number_nsz_f32_(_e1038, (_e1022 - _e378));
                                let _e1040 = core_intrinsics_minimum_number_nsz_f32_((_e1028 + _e376), (_e1031 + _e377));
                                let _e1041 = core_intrinsics_minimum_number_nsz_f32_(_e1040, (_e1034 + _e378));
                                if (_e1039 <= _e1041) {
                                    if (_e1039 <= _e972.t) {
                                        if (_e1041 >= _e157.tmin) {
                                            let _e1053 = instances.member[(0u + _e980)].world_to_object[0u];
                                            let _e1064 = ((((_e1053.x * _e157.origin.x) + (_e1053.y * _e157.origin.y)) + (_e1053.z * _e157.origin.z)) + (_e1053.w * 1f));
                                            let _e1066 = instances.member[(0u + _e980)].world_to_object[1u];
                                            let _e1077 = ((((_e1066.x * _e157.origin.x) + (_e1066.y * _e157.origin.y)) + (_e1066.z * _e157.origin.z)) + (_e1066.w * 1f));
                                            let _e1079 = instances.member[(0u + _e980)].world_to_object[2u];
                                            let _e1090 = ((((_e1079.x * _e157.origin.x) + (_e1079.y * _e157.origin.y)) + (_e1079.z * _e157.origin.z)) + (_e1079.w * 1f));
                                            let _e1097 = instances.member[(0u + _e980)].world_to_object[0u];
                                            let _e1108 = ((((_e1097.x * _e157.direction.x) + (_e1097.y * _e157.direction.y)) + (_e1097.z * _e157.direction.z)) + (_e1097.w * 0f));
                                            let _e1110 = instances.member[(0u + _e980)].world_to_object[1u];
                                            let _e1121 = ((((_e1110.x * _e157.direction.x) + (_e1110.y * _e157.direction.y)) + (_e1110.z * _e157.direction.z)) + (_e1110.w * 0f));
                                            let _e1123 = instances.member[(0u + _e980)].world_to_object[2u];
                                            let _e1134 = ((((_e1123.x * _e157.direction.x) + (_e1123.y * _e157.direction.y)) + (_e1123.z * _e157.direction.z)) + (_e1123.w * 0f));
                                            let _e1139 = instances.member[(0u + _e980)].root;
                                            let _e1141 = instances.member[(0u + _e980)].first_triangle;
                                            let _e1145 = abs(_e1108);
                                            let _e1146 = abs(_e1121);
                                            let _e1147 = abs(_e1134);
                                            if (abs(_e1064) < 1000000000000000f) {
                                                if (abs(_e1077) < 1000000000000000f) {
                                                    if (abs(_e1090) < 1000000000000000f) {
                                                        if (_e1145 < 1000000000000000f) {
                                                            if (_e1146 < 1000000000000000f) {
                                                                if (_e1147 < 1000000000000000f) {
                                                                    if (_e1145 > 0f) {
                                                                        phi_1729_ = bool();
                                                                        phi_1730_ = true;
                                                                    } else {
                                                                        let _e1155 = (_e1146 > 0f);
                                                                        if _e1155 {
                                                                            phi_1728_ = bool();
                                                                        } else {
                                                                            phi_1728_ = (_e1147 > 0f);
                                                                        }
                                                                        let _e1158 = phi_1728_;
                                                                        phi_1729_ = _e1158;
                                                                        phi_1730_ = _e1155;
                                                                    }
                                                                    let _e1160 = phi_1729_;
                                                                    let _e1162 = phi_1730_;
                                                                    if _e1162 {
                                                                        phi_1734_ = true;
                                                                    } else {
                                                                        phi_1734_ = _e1160;
                                                                    }
                                                                    let _e1164 = phi_1734_;
                                                                    phi_1735_ = _e1164;
                                                                    phi_1736_ = false;
                                                                } else {
                                                                    phi_1735_ = bool();
                                                                    phi_1736_ = true;
                                                                }
                                                                let _e1166 = phi_1735_;
                                                                let _e1168 = phi_1736_;
                                                                phi_1737_ = _e1166;
                                                                phi_1738_ = false;
                                                                phi_1739_ = _e1168;
                                                            } else {
                                                                phi_1737_ = bool();
                                                                phi_1738_ = true;
                                                                phi_1739_ = false;
                                                            }
                                                            let _e1170 = phi_1737_;
                                                            let _e1172 = phi_1738_;
                                                            let _e1174 = phi_1739_;
                                                            phi_1740_ = _e1170;
                                                            phi_1741_ = _e1172;
                                                            phi_1742_ = _e1174;
                                                        } else {
                                                            phi_1740_ = bool();
                                                            phi_1741_ = true;
                                                            phi_1742_ = false;
                                                        }
                                                        let _e1176 = phi_1740_;
                                                        let _e1178 = phi_1741_;
                                                        let _e1180 = phi_1742_;
                                                        phi_1743_ = _e1176;
                                                        phi_1744_ = _e1178;
                                                        phi_1745_ = _e1180;
                                                    } else {
                                                        phi_1743_ = bool();
                                                        phi_1744_ = true;
                                                        phi_1745_ = false;
                                                    }
                                                    let _e1182 = phi_1743_;
                                                    let _e1184 = phi_1744_;
                                                    let _e1186 = phi_1745_;
                                                    phi_1746_ = _e1182;
                                                    phi_1747_ = _e1184;
                                                    phi_1748_ = _e1186;
                                                } else {
                                                    phi_1746_ = bool();
                                                    phi_1747_ = true;
                                                    phi_1748_ = false;
                                                }
                                                let _e1188 = phi_1746_;
                                                let _e1190 = phi_1747_;
                                                let _e1192 = phi_1748_;
                                                phi_1749_ = _e1188;
                                                phi_1750_ = _e1190;
                                                phi_1751_ = _e1192;
                                            } else {
                                                phi_1749_ = bool();
                                                phi_1750_ = true;
                                                phi_1751_ = false;
                                            }
                                            let _e1194 = phi_1749_;
                                            let _e1196 = phi_1750_;
                                            let _e1198 = phi_1751_;
                                            if _e1196 {
                                                phi_1755_ = true;
                                            } else {
                                                phi_1755_ = _e1198;
                                            }
                                            let _e1200 = phi_1755_;
                                            if _e1200 {
                                                phi_1759_ = false;
                                            } else {
                                                phi_1759_ = _e1194;
                                            }
                                            let _e1202 = phi_1759_;
                                            if _e1202 {
                                                let _e1203 = (_e1139 >= _e76);
                                                if _e1203 {
                                                    phi_3162_ = lt_bvh_Hit();
                                                } else {
                                                    if (_e1139 < _e76) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1209 = nodes.member[(0u + _e1139)].frame[0u];
                                                    let _e1213 = nodes.member[(0u + _e1139)].frame[1u];
                                                    let _e1217 = nodes.member[(0u + _e1139)].frame[2u];
                                                    let _e1221 = nodes.member[(0u + _e1139)].frame[0u];
                                                    let _e1225 = nodes.member[(0u + _e1139)].frame[1u];
                                                    let _e1229 = nodes.member[(0u + _e1139)].frame[2u];
                                                    let _e1233 = nodes.member[(0u + _e1139)].frame[3u];
                                                    let _e1267 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1108), abs(_e1121));
                                                    let _e1268 = core_intrinsics_maximum_number_nsz_f32_(_e1267, abs(_e1134));
                                                    let _e1269 = (_e1268 * 0.0000000000009094947f);
                                                    if (abs(_e1108) < _e1269) {
                                                        phi_1829_ = _e1269;
                                                    } else {
                                                        phi_1829_ = abs(_e1108);
                                                    }
                                                    let _e1274 = phi_1829_;
                                                    if (_e1108 < 0f) {
                                                        phi_1836_ = (-1f / _e1274);
                                                    } else {
                                                        phi_1836_ = (1f / _e1274);
                                                    }
                                                    let _e1279 = phi_1836_;
                                                    if (abs(_e1121) < _e1269) {
                                                        phi_1843_ = _e1269;
                                                    } else {
                                                        phi_1843_ = abs(_e1121);
                                                    }
                                                    let _e1284 = phi_1843_;
                                                    if (_e1121 < 0f) {
                                                        phi_1850_ = (-1f / _e1284);
                                                    } else {
                                                        phi_1850_ = (1f / _e1284);
                                                    }
                                                    let _e1289 = phi_1850_;
                                                    if (abs(_e1134) < _e1269) {
                                                        phi_1857_ = _e1269;
                                                    } else {
                                                        phi_1857_ = abs(_e1134);
                                                    }
                                                    let _e1294 = phi_1857_;
                                                    if (_e1134 < 0f) {
                                                        phi_1864_ = (-1f / _e1294);
                                                    } else {
                                                        phi_1864_ = (1f / _e1294);
                                                    }
                                                    let _e1299 = phi_1864_;
                                                    let _e1303 = abs((bitcast<f32>(_e1209) - _e1064));
                                                    let _e1304 = abs((bitcast<f32>(_e1213) - _e1077));
                                                    let _e1305 = abs((bitcast<f32>(_e1217) - _e1090));
                                                    let _e1309 = abs(((bitcast<f32>(_e1221) + (bitcast<f32>((((_e1233 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1064));
                                                    let _e1310 = abs(((bitcast<f32>(_e1225) + (bitcast<f32>((((_e1233 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1077));
                                                    let _e1311 = abs(((bitcast<f32>(_e1229) + (bitcast<f32>((((_e1233 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1090));
                                                    if (_e1303 > _e1309) {
                                                        phi_1881_ = _e1303;
                                                    } else {
                                                        phi_1881_ = _e1309;
                                                    }
                                                    let _e1314 = phi_1881_;
                                                    if (_e1304 > _e1310) {
                                                        phi_1886_ = _e1304;
                                                    } else {
                                                        phi_1886_ = _e1310;
                                                    }
                                                    let _e1317 = phi_1886_;
                                                    if (_e1305 > _e1311) {
                                                        phi_1891_ = _e1305;
                                                    } else {
                                                        phi_1891_ = _e1311;
                                                    }
                                                    let _e1320 = phi_1891_;
                                                    let _e1321 = core_intrinsics_maximum_number_nsz_f32_(_e1314, _e1317);
                                                    let _e1322 = core_intrinsics_maximum_number_nsz_f32_(_e1321, _e1320);
                                                    let _e1326 = (_e1322 * 0.0000019073486f);
                                                    let _e1327 = (abs(_e1279) * _e1326);
                                                    let _e1328 = (abs(_e1289) * _e1326);
                                                    let _e1329 = (abs(_e1299) * _e1326);
                                                    let _e1333 = (_e1322 * 0.0000009536743f);
                                                    let _e1334 = (abs(_e1279) * _e1333);
                                                    let _e1335 = (abs(_e1289) * _e1333);
                                                    let _e1336 = (abs(_e1299) * _e1333);
                                                    let _e1337 = abs(_e1108);
                                                    let _e1338 = abs(_e1121);
                                                    let _e1339 = abs(_e1134);
                                                    if (_e1337 >= _e1338) {
                                                        if (_e1337 >= _e1339) {
                                                            phi_1919_ = false;
                                                        } else {
                                                            phi_1919_ = true;
                                                        }
                                                        let _e1343 = phi_1919_;
                                                        phi_1920_ = _e1343;
                                                    } else {
                                                        phi_1920_ = true;
                                                    }
                                                    let _e1345 = phi_1920_;
                                                    if _e1345 {
                                                        if (_e1338 >= _e1339) {
                                                            phi_1928_ = 1u;
                                                        } else {
                                                            phi_1928_ = 2u;
                                                        }
                                                        let _e1348 = phi_1928_;
                                                        phi_1929_ = _e1348;
                                                    } else {
                                                        phi_1929_ = 0u;
                                                    }
                                                    let _e1350 = phi_1929_;
                                                    if (_e1350 == 0u) {
                                                        phi_1941_ = vec3<f32>(_e1121, _e1134, _e1108);
                                                    } else {
                                                        if (_e1350 == 1u) {
                                                            phi_1940_ = vec3<f32>(_e1134, _e1108, _e1121);
                                                        } else {
                                                            phi_1940_ = vec3<f32>(_e1108, _e1121, _e1134);
                                                        }
                                                        let _e1356 = phi_1940_;
                                                        phi_1941_ = _e1356;
                                                    }
                                                    let _e1358 = phi_1941_;
                                                    let _e1361 = (_e1358.x / _e1358.z);
                                                    let _e1364 = (_e1358.y / _e1358.z);
                                                    if (_e1279 < 0f) {
                                                        phi_1954_ = 0u;
                                                    } else {
                                                        phi_1954_ = 1u;
                                                    }
                                                    let _e1369 = phi_1954_;
                                                    if (_e1289 < 0f) {
                                                        phi_1959_ = 0u;
                                                    } else {
                                                        phi_1959_ = 2u;
                                                    }
                                                    let _e1372 = phi_1959_;
                                                    if (_e1299 < 0f) {
                                                        phi_1964_ = 0u;
                                                    } else {
                                                        phi_1964_ = 4u;
                                                    }
                                                    let _e1375 = phi_1964_;
                                                    let _e1377 = ((_e1369 | _e1372) | _e1375);
                                                    let _e1378 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1139, 2147483648u);
                                                    local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e1378.first[0], _e1378.first[1], _e1378.first[2], _e1378.first[3], _e1378.first[4], _e1378.first[5], _e1378.first[6], _e1378.first[7], _e1378.first[8], _e1378.first[9], _e1378.first[10], _e1378.first[11], _e1378.first[12], _e1378.first[13], _e1378.first[14], _e1378.first[15], _e1378.first[16], _e1378.first[17], _e1378.first[18], _e1378.first[19], _e1378.first[20], _e1378.first[21], _e1378.first[22], _e1378.first[23], _e1378.first[24], _e1378.first[25], _e1378.first[26], _e1378.first[27], _e1378.first[28], _e1378.first[29], _e1378.first[30], _e1378.first[31]), array<u32, 32>(_e1378.mask[0], _e1378.mask[1], _e1378.mask[2], _e1378.mask[3], _e1378.mask[4], _e1378.mask[5], _e1378.mask[6], _e1378.mask[7], _e1378.mask[8], _e1378.mask[9], _e1378.mask[10], _e1378.mask[11], _e1378.mask[12], _e1378.mask[13], _e1378.mask[14], _e1378.mask[15], _e1378.mask[16], _e1378.mask[17], _e1378.mask[18], _e1378.mask[19], _e1378.mask[20], _e1378.mask[21], _e1378.mask[22], _e1378.mask[23], _e1378.mask[24], _e1378.mask[25], _e1378.mask[26], _e1378.mask[27], _e1378.mask[28], _e1378.mask[29], _e1378.mask[30], _e1378.mask[31]), _e1378.len, _e1378.group, _e1378.group_mask);
                                                    let _e1452 = local_1.group_mask;
                                                    if ((_e1452 & 4278190080u) == 0u) {
                                                        let _e1456 = local_1.len;
                                                        if (_e1456 == 0u) {
                                                            phi_2078_ = false;
                                                        } else {
                                                            let _e1460 = local_1.len;
                                                            local_1.len = (_e1460 - 1u);
                                                            let _e1463 = local_1.len;
                                                            if (_e1463 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1468 = local_1.first[(0u + _e1463)];
                                                            local_1.group = _e1468;
                                                            let _e1471 = local_1.len;
                                                            if (_e1471 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1476 = local_1.mask[(0u + _e1471)];
                                                            local_1.group_mask = _e1476;
                                                            phi_2078_ = true;
                                                        }
                                                        let _e1479 = phi_2078_;
                                                        phi_2079_ = _e1479;
                                                    } else {
                                                        phi_2079_ = true;
                                                    }
                                                    let _e1481 = phi_2079_;
                                                    if _e1481 {
                                                        let _e1483 = local_1.group_mask;
                                                        let _e1489 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1483)), 32u, (_e1483 == 0u)));
                                                        let _e1493 = local_1.group_mask;
                                                        let _e1507 = local_1.group_mask;
                                                        local_1.group_mask = (_e1507 & ~((1u << bitcast<u32>((_e1489 & 31u)))));
                                                        let _e1510 = local_1.group;
                                                        phi_2110_ = (_e1510 + countOneBits(((_e1493 & ~((4294967295u << bitcast<u32>((((_e1489 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_2110_ = 4294967295u;
                                                    }
                                                    let _e1513 = phi_2110_;
                                                    phi_2112_ = _e972;
                                                    phi_2115_ = _e1513;
                                                    loop {
                                                        let _e1515 = phi_2112_;
                                                        let _e1517 = phi_2115_;
                                                        local_10 = _e1515;
                                                        let _e1518 = (_e1517 != 4294967295u);
                                                        if _e1518 {
                                                            if (_e1517 < _e76) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1525 = nodes.member[(0u + _e1517)].frame[3u];
                                                            let _e1550 = (bitcast<f32>((((_e1525 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1279);
                                                            let _e1551 = (bitcast<f32>((((_e1525 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1289);
                                                            let _e1552 = (bitcast<f32>((((_e1525 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1299);
                                                            let _e1555 = nodes.member[(0u + _e1517)].frame[0u];
                                                            let _e1559 = nodes.member[(0u + _e1517)].frame[1u];
                                                            let _e1563 = nodes.member[(0u + _e1517)].frame[2u];
                                                            let _e1568 = ((bitcast<f32>(_e1555) - _e1064) * _e1279);
                                                            let _e1569 = ((bitcast<f32>(_e1559) - _e1077) * _e1289);
                                                            let _e1570 = ((bitcast<f32>(_e1563) - _e1090) * _e1299);
                                                            let _e1578 = nodes.member[(0u + _e1517)].x;
                                                            if (_e1279 < 0f) {
                                                                let _e1589 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1578.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1595 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1589.unnamed.word, _e1578.w), _e1589.unnamed_1);
                                                                let _e1601 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1595.unnamed, lt_mask_LightPlace(_e1578.x, _e1595.unnamed_1.shift));
                                                                phi_2196_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1601.unnamed, lt_mask_LightPlace(_e1601.unnamed_1.word, _e1578.y));
                                                            } else {
                                                                let _e1617 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1578.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1623 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1617.unnamed.word, _e1578.y), _e1617.unnamed_1);
                                                                let _e1629 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1623.unnamed, lt_mask_LightPlace(_e1578.z, _e1623.unnamed_1.shift));
                                                                phi_2196_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1629.unnamed, lt_mask_LightPlace(_e1629.unnamed_1.word, _e1578.w));
                                                            }
                                                            let _e1637 = phi_2196_;
                                                            let _e1647 = nodes.member[(0u + _e1517)].y;
                                                            if (_e1289 < 0f) {
                                                                let _e1658 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1647.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1664 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1658.unnamed.word, _e1647.w), _e1658.unnamed_1);
                                                                let _e1670 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1664.unnamed, lt_mask_LightPlace(_e1647.x, _e1664.unnamed_1.shift));
                                                                phi_2223_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1670.unnamed, lt_mask_LightPlace(_e1670.unnamed_1.word, _e1647.y));
                                                            } else {
                                                                let _e1686 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1647.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1692 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1686.unnamed.word, _e1647.y), _e1686.unnamed_1);
                                                                let _e1698 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1692.unnamed, lt_mask_LightPlace(_e1647.z, _e1692.unnamed_1.shift));
                                                                phi_2223_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1698.unnamed, lt_mask_LightPlace(_e1698.unnamed_1.word, _e1647.w));
                                                            }
                                                            let _e1706 = phi_2223_;
                                                            let _e1716 = nodes.member[(0u + _e1517)].z;
                                                            if (_e1299 < 0f) {
                                                                let _e1727 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1716.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1733 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1727.unnamed.word, _e1716.w), _e1727.unnamed_1);
                                                                let _e1739 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1733.unnamed, lt_mask_LightPlace(_e1716.x, _e1733.unnamed_1.shift));
                                                                phi_2250_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1739.unnamed, lt_mask_LightPlace(_e1739.unnamed_1.word, _e1716.y));
                                                            } else {
                                                                let _e1755 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1716.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1761 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1755.unnamed.word, _e1716.y), _e1755.unnamed_1);
                                                                let _e1767 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1761.unnamed, lt_mask_LightPlace(_e1716.z, _e1761.unnamed_1.shift));
                                                                phi_2250_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1767.unnamed, lt_mask_LightPlace(_e1767.unnamed_1.word, _e1716.w));
                                                            }
                                                            let _e1775 = phi_2250_;
                                                            phi_2256_ = 0u;
                                                            phi_2259_ = 0u;
                                                            loop {
                                                                let _e1785 = phi_2256_;
                                                                let _e1787 = phi_2259_;
                                                                local_6 = _e1787;
                                                                local_7 = _e1787;
                                                                local_8 = _e1787;
                                                                let _e1788 = (_e1785 < 8u);
                                                                if _e1788 {
                                                                    let _e1790 = (_e1785 >> bitcast<u32>(2i));
                                                                    let _e1791 = (_e1785 & 3u);
                                                                    if (_e1790 == 0u) {
                                                                        phi_2273_ = _e1637.unnamed.word;
                                                                    } else {
                                                                        phi_2273_ = _e1637.unnamed.shift;
                                                                    }
                                                                    let _e1794 = phi_2273_;
                                                                    if (_e1790 == 0u) {
                                                                        phi_2283_ = _e1706.unnamed.word;
                                                                    } else {
                                                                        phi_2283_ = _e1706.unnamed.shift;
                                                                    }
                                                                    let _e1803 = phi_2283_;
                                                                    if (_e1790 == 0u) {
                                                                        phi_2293_ = _e1775.unnamed.word;
                                                                    } else {
                                                                        phi_2293_ = _e1775.unnamed.shift;
                                                                    }
                                                                    let _e1812 = phi_2293_;
                                                                    let _e1825 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1794 >> bitcast<u32>(((_e1791 * 8u) & 31u))) & 255u)) * _e1550) + (_e1568 - _e1327)), ((f32(((_e1803 >> bitcast<u32>(((_e1791 * 8u) & 31u))) & 255u)) * _e1551) + (_e1569 - _e1328)));
                                                                    let _e1826 = core_intrinsics_maximum_number_nsz_f32_(_e1825, ((f32(((_e1812 >> bitcast<u32>(((_e1791 * 8u) & 31u))) & 255u)) * _e1552) + (_e1570 - _e1329)));
                                                                    if (_e1790 == 0u) {
                                                                        phi_2311_ = _e1637.unnamed_1.word;
                                                                    } else {
                                                                        phi_2311_ = _e1637.unnamed_1.shift;
                                                                    }
                                                                    let _e1829 = phi_2311_;
                                                                    if (_e1790 == 0u) {
                                                                        phi_2321_ = _e1706.unnamed_1.word;
                                                                    } else {
                                                                        phi_2321_ = _e1706.unnamed_1.shift;
                                                                    }
                                                                    let _e1838 = phi_2321_;
                                                                    if (_e1790 == 0u) {
                                                                        phi_2331_ = _e1775.unnamed_1.word;
                                                                    } else {
                                                                        phi_2331_ = _e1775.unnamed_1.shift;
                                                                    }
                                                                    let _e1847 = phi_2331_;
                                                                    let _e1860 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1829 >> bitcast<u32>(((_e1791 * 8u) & 31u))) & 255u)) * _e1550) + (_e1568 + _e1327)), ((f32(((_e1838 >> bitcast<u32>(((_e1791 * 8u) & 31u))) & 255u)) * _e1551) + (_e1569 + _e1328)));
                                                                    let _e1861 = core_intrinsics_minimum_number_nsz_f32_(_e1860, ((f32(((_e1847 >> bitcast<u32>(((_e1791 * 8u) & 31u))) & 255u)) * _e1552) + (_e1570 + _e1329)));
                                                                    if (_e1826 <= _e1861) {
                                                                        if (_e1826 <= _e1515.t) {
                                                                            if (_e1861 >= _e157.tmin) {
                                                                                if (_e1790 == 0u) {
                                                                                    let _e1868 = nodes.member[(0u + _e1517)].links[2u];
                                                                                    phi_2367_ = _e1868;
                                                                                } else {
                                                                                    let _e1871 = nodes.member[(0u + _e1517)].links[3u];
                                                                                    phi_2367_ = _e1871;
                                                                                }
                                                                                let _e1873 = phi_2367_;
                                                                                let _e1878 = ((_e1873 >> bitcast<u32>(((_e1791 * 8u) & 31u))) & 255u);
                                                                                let _e1879 = (_e1878 & 31u);
                                                                                if (_e1879 >= 24u) {
                                                                                    phi_2380_ = (24u + ((_e1879 - 24u) ^ _e1377));
                                                                                } else {
                                                                                    phi_2380_ = _e1879;
                                                                                }
                                                                                let _e1885 = phi_2380_;
                                                                                phi_2385_ = (_e1787 | ((_e1878 >> bitcast<u32>(5i)) << bitcast<u32>((_e1885 & 31u))));
                                                                            } else {
                                                                                phi_2385_ = _e1787;
                                                                            }
                                                                            let _e1893 = phi_2385_;
                                                                            phi_2386_ = _e1893;
                                                                        } else {
                                                                            phi_2386_ = _e1787;
                                                                        }
                                                                        let _e1895 = phi_2386_;
                                                                        phi_2387_ = _e1895;
                                                                    } else {
                                                                        phi_2387_ = _e1787;
                                                                    }
                                                                    let _e1897 = phi_2387_;
                                                                    phi_2257_ = (_e1785 + 1u);
                                                                    phi_2260_ = _e1897;
                                                                } else {
                                                                    phi_2257_ = u32();
                                                                    phi_2260_ = u32();
                                                                }
                                                                let _e1900 = phi_2257_;
                                                                let _e1902 = phi_2260_;
                                                                continue;
                                                                continuing {
                                                                    phi_2256_ = _e1900;
                                                                    phi_2259_ = _e1902;
                                                                    break if !(_e1788);
                                                                }
                                                            }
                                                            let _e1906 = nodes.member[(0u + _e1517)].links[0u];
                                                            let _e1910 = nodes.member[(0u + _e1517)].frame[3u];
                                                            let _e1914 = local_6;
                                                            if ((_e1914 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1918 = local_1.group_mask;
                                                                if ((_e1918 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1922 = local_1.len;
                                                                    if (_e1922 < 32u) {
                                                                        let _e1925 = local_1.group;
                                                                        let _e1927 = local_1.len;
                                                                        if (_e1927 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.first[(0u + _e1927)] = _e1925;
                                                                        let _e1933 = local_1.group_mask;
                                                                        let _e1935 = local_1.len;
                                                                        if (_e1935 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.mask[(0u + _e1935)] = _e1933;
                                                                        let _e1942 = local_1.len;
                                                                        local_1.len = (_e1942 + 1u);
                                                                    }
                                                                }
                                                                local_1.group = (_e1139 + _e1906);
                                                                let _e1946 = local_7;
                                                                local_1.group_mask = ((_e1946 & 4278190080u) | (_e1910 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1951 = local_8;
                                                            phi_2445_ = _e1515;
                                                            phi_2448_ = (_e1951 & 16777215u);
                                                            loop {
                                                                let _e1954 = phi_2445_;
                                                                let _e1956 = phi_2448_;
                                                                local_9 = _e1954;
                                                                if (_e1956 == 0u) {
                                                                    phi_2446_ = lt_bvh_Hit();
                                                                    phi_2449_ = u32();
                                                                    phi_3090_ = false;
                                                                } else {
                                                                    let _e1960 = nodes.member[(0u + _e1517)].links[1u];
                                                                    let _e1965 = ((_e1141 + _e1960) + select(firstTrailingBit(_e1956), 32u, (_e1956 == 0u)));
                                                                    if (_e1965 < _e79) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1972 = triangles.member[(0u + _e1965)].v0_;
                                                                    let _e1974 = (_e1972.x - _e1064);
                                                                    let _e1976 = (_e1972.y - _e1077);
                                                                    let _e1978 = (_e1972.z - _e1090);
                                                                    if (_e1350 == 0u) {
                                                                        phi_2493_ = vec3<f32>(_e1976, _e1978, _e1974);
                                                                    } else {
                                                                        if (_e1350 == 1u) {
                                                                            phi_2492_ = vec3<f32>(_e1978, _e1974, _e1976);
                                                                        } else {
                                                                            phi_2492_ = (_e1972 - vec3<f32>(_e1064, _e1077, _e1090));
                                                                        }
                                                                        let _e1986 = phi_2492_;
                                                                        phi_2493_ = _e1986;
                                                                    }
                                                                    let _e1988 = phi_2493_;
                                                                    let _e1992 = (_e1988.x - (_e1361 * _e1988.z));
                                                                    let _e1996 = (_e1988.y - (_e1364 * _e1988.z));
                                                                    let _e1998 = triangles.member[(0u + _e1965)].v1_;
                                                                    let _e2000 = (_e1998.x - _e1064);
                                                                    let _e2002 = (_e1998.y - _e1077);
                                                                    let _e2004 = (_e1998.z - _e1090);
                                                                    if (_e1350 == 0u) {
                                                                        phi_2523_ = vec3<f32>(_e2002, _e2004, _e2000);
                                                                    } else {
                                                                        if (_e1350 == 1u) {
                                                                            phi_2522_ = vec3<f32>(_e2004, _e2000, _e2002);
                                                                        } else {
                                                                            phi_2522_ = (_e1998 - vec3<f32>(_e1064, _e1077, _e1090));
                                                                        }
                                                                        let _e2012 = phi_2522_;
                                                                        phi_2523_ = _e2012;
                                                                    }
                                                                    let _e2014 = phi_2523_;
                                                                    let _e2018 = (_e2014.x - (_e1361 * _e2014.z));
                                                                    let _e2022 = (_e2014.y - (_e1364 * _e2014.z));
                                                                    let _e2024 = triangles.member[(0u + _e1965)].v2_;
                                                                    let _e2026 = (_e2024.x - _e1064);
                                                                    let _e2028 = (_e2024.y - _e1077);
                                                                    let _e2030 = (_e2024.z - _e1090);
                                                                    if (_e1350 == 0u) {
                                                                        phi_2553_ = vec3<f32>(_e2028, _e2030, _e2026);
                                                                    } else {
                                                                        if (_e1350 == 1u) {
                                                                            phi_2552_ = vec3<f32>(_e2030, _e2026, _e2028);
                                                                        } else {
                                                                            phi_2552_ = (_e2024 - vec3<f32>(_e1064, _e1077, _e1090));
                                                                        }
                                                                        let _e2038 = phi_2552_;
                                                                        phi_2553_ = _e2038;
                                                                    }
                                                                    let _e2040 = phi_2553_;
                                                                    let _e2044 = (_e2040.x - (_e1361 * _e2040.z));
                                                                    let _e2048 = (_e2040.y - (_e1364 * _e2040.z));
                                                                    if (_e2018 < _e2044) {
                                                                        phi_2572_ = true;
                                                                    } else {
                                                                        if (_e2018 == _e2044) {
                                                                            phi_2571_ = (_e2022 < _e2048);
                                                                        } else {
                                                                            phi_2571_ = false;
                                                                        }
                                                                        let _e2053 = phi_2571_;
                                                                        phi_2572_ = _e2053;
                                                                    }
                                                                    let _e2055 = phi_2572_;
                                                                    if _e2055 {
                                                                        phi_2576_ = _e2048;
                                                                        phi_2577_ = _e2044;
                                                                        phi_2578_ = _e2022;
                                                                        phi_2579_ = _e2018;
                                                                    } else {
                                                                        phi_2576_ = _e2022;
                                                                        phi_2577_ = _e2018;
                                                                        phi_2578_ = _e2048;
                                                                        phi_2579_ = _e2044;
                                                                    }
                                                                    let _e2057 = phi_2576_;
                                                                    let _e2059 = phi_2577_;
                                                                    let _e2061 = phi_2578_;
                                                                    let _e2063 = phi_2579_;
                                                                    let _e2066 = ((_e2063 * _e2057) - (_e2061 * _e2059));
                                                                    if _e2055 {
                                                                        phi_2587_ = -(_e2066);
                                                                    } else {
                                                                        phi_2587_ = _e2066;
                                                                    }
                                                                    let _e2069 = phi_2587_;
                                                                    if (_e2044 < _e1992) {
                                                                        phi_2598_ = true;
                                                                    } else {
                                                                        if (_e2044 == _e1992) {
                                                                            phi_2597_ = (_e2048 < _e1996);
                                                                        } else {
                                                                            phi_2597_ = false;
                                                                        }
                                                                        let _e2074 = phi_2597_;
                                                                        phi_2598_ = _e2074;
                                                                    }
                                                                    let _e2076 = phi_2598_;
                                                                    if _e2076 {
                                                                        phi_2602_ = _e1996;
                                                                        phi_2603_ = _e1992;
                                                                        phi_2604_ = _e2048;
                                                                        phi_2605_ = _e2044;
                                                                    } else {
                                                                        phi_2602_ = _e2048;
                                                                        phi_2603_ = _e2044;
                                                                        phi_2604_ = _e1996;
                                                                        phi_2605_ = _e1992;
                                                                    }
                                                                    let _e2078 = phi_2602_;
                                                                    let _e2080 = phi_2603_;
                                                                    let _e2082 = phi_2604_;
                                                                    let _e2084 = phi_2605_;
                                                                    let _e2087 = ((_e2084 * _e2078) - (_e2082 * _e2080));
                                                                    if _e2076 {
                                                                        phi_2613_ = -(_e2087);
                                                                    } else {
                                                                        phi_2613_ = _e2087;
                                                                    }
                                                                    let _e2090 = phi_2613_;
                                                                    if (_e1992 < _e2018) {
                                                                        phi_2624_ = true;
                                                                    } else {
                                                                        if (_e1992 == _e2018) {
                                                                            phi_2623_ = (_e1996 < _e2022);
                                                                        } else {
                                                                            phi_2623_ = false;
                                                                        }
                                                                        let _e2095 = phi_2623_;
                                                                        phi_2624_ = _e2095;
                                                                    }
                                                                    let _e2097 = phi_2624_;
                                                                    if _e2097 {
                                                                        phi_2628_ = _e2022;
                                                                        phi_2629_ = _e2018;
                                                                        phi_2630_ = _e1996;
                                                                        phi_2631_ = _e1992;
                                                                    } else {
                                                                        phi_2628_ = _e1996;
                                                                        phi_2629_ = _e1992;
                                                                        phi_2630_ = _e2022;
                                                                        phi_2631_ = _e2018;
                                                                    }
                                                                    let _e2099 = phi_2628_;
                                                                    let _e2101 = phi_2629_;
                                                                    let _e2103 = phi_2630_;
                                                                    let _e2105 = phi_2631_;
                                                                    let _e2108 = ((_e2105 * _e2099) - (_e2103 * _e2101));
                                                                    if _e2097 {
                                                                        phi_2639_ = -(_e2108);
                                                                    } else {
                                                                        phi_2639_ = _e2108;
                                                                    }
                                                                    let _e2111 = phi_2639_;
                                                                    if (_e2069 >= 0f) {
                                                                        if (_e2090 >= 0f) {
                                                                            if (_e2111 >= 0f) {
                                                                                phi_2654_ = ((_e2069 + _e2090) + _e2111);
                                                                                phi_2655_ = false;
                                                                            } else {
                                                                                phi_2654_ = f32();
                                                                                phi_2655_ = true;
                                                                            }
                                                                            let _e2118 = phi_2654_;
                                                                            let _e2120 = phi_2655_;
                                                                            phi_2656_ = _e2118;
                                                                            phi_2657_ = _e2120;
                                                                        } else {
                                                                            phi_2656_ = f32();
                                                                            phi_2657_ = true;
                                                                        }
                                                                        let _e2122 = phi_2656_;
                                                                        let _e2124 = phi_2657_;
                                                                        phi_2658_ = _e2122;
                                                                        phi_2659_ = _e2124;
                                                                    } else {
                                                                        phi_2658_ = f32();
                                                                        phi_2659_ = true;
                                                                    }
                                                                    let _e2126 = phi_2658_;
                                                                    let _e2128 = phi_2659_;
                                                                    if _e2128 {
                                                                        if (_e2069 <= 0f) {
                                                                            if (_e2090 <= 0f) {
                                                                                let _e2131 = (_e2111 <= 0f);
                                                                                if _e2131 {
                                                                                }
                                                                                phi_2677_ = ((_e2069 + _e2090) + _e2111);
                                                                                phi_2678_ = false;
                                                                                phi_2679_ = _e2131;
                                                                            } else {
                                                                                phi_2677_ = f32();
                                                                                phi_2678_ = true;
                                                                                phi_2679_ = false;
                                                                            }
                                                                            let _e2135 = phi_2677_;
                                                                            let _e2137 = phi_2678_;
                                                                            let _e2139 = phi_2679_;
                                                                            phi_2680_ = _e2135;
                                                                            phi_2681_ = _e2137;
                                                                            phi_2682_ = _e2139;
                                                                        } else {
                                                                            phi_2680_ = f32();
                                                                            phi_2681_ = true;
                                                                            phi_2682_ = false;
                                                                        }
                                                                        let _e2141 = phi_2680_;
                                                                        let _e2143 = phi_2681_;
                                                                        let _e2145 = phi_2682_;
                                                                        if _e2143 {
                                                                            phi_2686_ = false;
                                                                        } else {
                                                                            phi_2686_ = _e2145;
                                                                        }
                                                                        let _e2147 = phi_2686_;
                                                                        phi_2687_ = _e2141;
                                                                        phi_2688_ = _e2147;
                                                                    } else {
                                                                        phi_2687_ = _e2126;
                                                                        phi_2688_ = true;
                                                                    }
                                                                    let _e2149 = phi_2687_;
                                                                    let _e2151 = phi_2688_;
                                                                    if _e2151 {
                                                                        let _e2152 = (_e2149 == 0f);
                                                                        if _e2152 {
                                                                            phi_3004_ = lt_bvh_triangle_Intersection();
                                                                            phi_3005_ = false;
                                                                        } else {
                                                                            let _e2154 = triangles.member[(0u + _e1965)].v0_;
                                                                            let _e2156 = (_e2154.x - _e1064);
                                                                            let _e2158 = (_e2154.y - _e1077);
                                                                            let _e2160 = (_e2154.z - _e1090);
                                                                            if (_e1350 == 0u) {
                                                                                phi_2717_ = vec3<f32>(_e2158, _e2160, _e2156);
                                                                            } else {
                                                                                if (_e1350 == 1u) {
                                                                                    phi_2716_ = vec3<f32>(_e2160, _e2156, _e2158);
                                                                                } else {
                                                                                    phi_2716_ = (_e2154 - vec3<f32>(_e1064, _e1077, _e1090));
                                                                                }
                                                                                let _e2168 = phi_2716_;
                                                                                phi_2717_ = _e2168;
                                                                            }
                                                                            let _e2170 = phi_2717_;
                                                                            let _e2172 = triangles.member[(0u + _e1965)].v1_;
                                                                            let _e2174 = triangles.member[(0u + _e1965)].v0_;
                                                                            let _e2177 = (_e2172.x - _e2174.x);
                                                                            let _e2180 = (_e2172.y - _e2174.y);
                                                                            let _e2183 = (_e2172.z - _e2174.z);
                                                                            if (_e1350 == 0u) {
                                                                                phi_2743_ = vec3<f32>(_e2180, _e2183, _e2177);
                                                                            } else {
                                                                                if (_e1350 == 1u) {
                                                                                    phi_2742_ = vec3<f32>(_e2183, _e2177, _e2180);
                                                                                } else {
                                                                                    phi_2742_ = (_e2172 - _e2174);
                                                                                }
                                                                                let _e2190 = phi_2742_;
                                                                                phi_2743_ = _e2190;
                                                                            }
                                                                            let _e2192 = phi_2743_;
                                                                            let _e2194 = triangles.member[(0u + _e1965)].v2_;
                                                                            let _e2196 = triangles.member[(0u + _e1965)].v0_;
                                                                            let _e2199 = (_e2194.x - _e2196.x);
                                                                            let _e2202 = (_e2194.y - _e2196.y);
                                                                            let _e2205 = (_e2194.z - _e2196.z);
                                                                            if (_e1350 == 0u) {
                                                                                phi_2769_ = vec3<f32>(_e2202, _e2205, _e2199);
                                                                            } else {
                                                                                if (_e1350 == 1u) {
                                                                                    phi_2768_ = vec3<f32>(_e2205, _e2199, _e2202);
                                                                                } else {
                                                                                    phi_2768_ = (_e2194 - _e2196);
                                                                                }
                                                                                let _e2212 = phi_2768_;
                                                                                phi_2769_ = _e2212;
                                                                            }
                                                                            let _e2214 = phi_2769_;
                                                                            let _e2221 = ((_e2192.y * _e2214.z) - (_e2192.z * _e2214.y));
                                                                            let _e2228 = ((_e2192.z * _e2214.x) - (_e2192.x * _e2214.z));
                                                                            let _e2235 = ((_e2192.x * _e2214.y) - (_e2192.y * _e2214.x));
                                                                            let _e2249 = (((1f / _e1358.z) * (((_e2221 * _e2170.x) + (_e2228 * _e2170.y)) + (_e2235 * _e2170.z))) / (((_e2221 * _e1361) + (_e2228 * _e1364)) + _e2235));
                                                                            if (_e2249 > _e157.tmin) {
                                                                                if (_e2249 < _e157.tmax) {
                                                                                    let _e2253 = triangles.member[(0u + _e1965)].v0_;
                                                                                    let _e2255 = triangles.member[(0u + _e1965)].v1_;
                                                                                    if (_e2253.x < _e2255.x) {
                                                                                        phi_2825_ = _e2253.x;
                                                                                    } else {
                                                                                        phi_2825_ = _e2255.x;
                                                                                    }
                                                                                    let _e2262 = phi_2825_;
                                                                                    if (_e2253.y < _e2255.y) {
                                                                                        phi_2834_ = _e2253.y;
                                                                                    } else {
                                                                                        phi_2834_ = _e2255.y;
                                                                                    }
                                                                                    let _e2269 = phi_2834_;
                                                                                    if (_e2253.z < _e2255.z) {
                                                                                        phi_2843_ = _e2253.z;
                                                                                    } else {
                                                                                        phi_2843_ = _e2255.z;
                                                                                    }
                                                                                    let _e2276 = phi_2843_;
                                                                                    let _e2278 = triangles.member[(0u + _e1965)].v2_;
                                                                                    if (_e2262 < _e2278.x) {
                                                                                        phi_2852_ = _e2262;
                                                                                    } else {
                                                                                        phi_2852_ = _e2278.x;
                                                                                    }
                                                                                    let _e2283 = phi_2852_;
                                                                                    if (_e2269 < _e2278.y) {
                                                                                        phi_2859_ = _e2269;
                                                                                    } else {
                                                                                        phi_2859_ = _e2278.y;
                                                                                    }
                                                                                    let _e2288 = phi_2859_;
                                                                                    if (_e2276 < _e2278.z) {
                                                                                        phi_2866_ = _e2276;
                                                                                    } else {
                                                                                        phi_2866_ = _e2278.z;
                                                                                    }
                                                                                    let _e2293 = phi_2866_;
                                                                                    let _e2295 = triangles.member[(0u + _e1965)].v0_;
                                                                                    let _e2297 = triangles.member[(0u + _e1965)].v1_;
                                                                                    if (_e2295.x > _e2297.x) {
                                                                                        phi_2879_ = _e2295.x;
                                                                                    } else {
                                                                                        phi_2879_ = _e2297.x;
                                                                                    }
                                                                                    let _e2304 = phi_2879_;
                                                                                    if (_e2295.y > _e2297.y) {
                                                                                        phi_2888_ = _e2295.y;
                                                                                    } else {
                                                                                        phi_2888_ = _e2297.y;
                                                                                    }
                                                                                    let _e2311 = phi_2888_;
                                                                                    if (_e2295.z > _e2297.z) {
                                                                                        phi_2897_ = _e2295.z;
                                                                                    } else {
                                                                                        phi_2897_ = _e2297.z;
                                                                                    }
                                                                                    let _e2318 = phi_2897_;
                                                                                    let _e2320 = triangles.member[(0u + _e1965)].v2_;
                                                                                    if (_e2304 > _e2320.x) {
                                                                                        phi_2906_ = _e2304;
                                                                                    } else {
                                                                                        phi_2906_ = _e2320.x;
                                                                                    }
                                                                                    let _e2325 = phi_2906_;
                                                                                    if (_e2311 > _e2320.y) {
                                                                                        phi_2913_ = _e2311;
                                                                                    } else {
                                                                                        phi_2913_ = _e2320.y;
                                                                                    }
                                                                                    let _e2330 = phi_2913_;
                                                                                    if (_e2318 > _e2320.z) {
                                                                                        phi_2920_ = _e2318;
                                                                                    } else {
                                                                                        phi_2920_ = _e2320.z;
                                                                                    }
                                                                                    let _e2335 = phi_2920_;
                                                                                    let _e2339 = ((_e2283 - _e1064) * _e1279);
                                                                                    let _e2340 = ((_e2288 - _e1077) * _e1289);
                                                                                    let _e2341 = ((_e2293 - _e1090) * _e1299);
                                                                                    let _e2345 = ((_e2325 - _e1064) * _e1279);
                                                                                    let _e2346 = ((_e2330 - _e1077) * _e1289);
                                                                                    let _e2347 = ((_e2335 - _e1090) * _e1299);
                                                                                    if (_e2339 < _e2345) {
                                                                                        phi_2937_ = _e2339;
                                                                                    } else {
                                                                                        phi_2937_ = _e2345;
                                                                                    }
                                                                                    let _e2350 = phi_2937_;
                                                                                    if (_e2340 < _e2346) {
                                                                                        phi_2942_ = _e2340;
                                                                                    } else {
                                                                                        phi_2942_ = _e2346;
                                                                                    }
                                                                                    let _e2353 = phi_2942_;
                                                                                    if (_e2341 < _e2347) {
                                                                                        phi_2947_ = _e2341;
                                                                                    } else {
                                                                                        phi_2947_ = _e2347;
                                                                                    }
                                                                                    let _e2356 = phi_2947_;
                                                                                    if (_e2339 > _e2345) {
                                                                                        phi_2955_ = _e2339;
                                                                                    } else {
                                                                                        phi_2955_ = _e2345;
                                                                                    }
                                                                                    let _e2362 = phi_2955_;
                                                                                    if (_e2340 > _e2346) {
                                                                                        phi_2960_ = _e2340;
                                                                                    } else {
                                                                                        phi_2960_ = _e2346;
                                                                                    }
                                                                                    let _e2365 = phi_2960_;
                                                                                    if (_e2341 > _e2347) {
                                                                                        phi_2965_ = _e2341;
                                                                                    } else {
                                                                                        phi_2965_ = _e2347;
                                                                                    }
                                                                                    let _e2368 = phi_2965_;
                                                                                    let _e2372 = core_intrinsics_maximum_number_nsz_f32_((_e2350 - _e1334), (_e2353 - _e1335));
                                                                                    let _e2373 = core_intrinsics_maximum_number_nsz_f32_(_e2372, (_e2356 - _e1336));
                                                                                    let _e2374 = core_intrinsics_minimum_number_nsz_f32_((_e2362 + _e1334), (_e2365 + _e1335));
                                                                                    let _e2375 = core_intrinsics_minimum_number_nsz_f32_(_e2374, (_e2368 + _e1336));
                                                                                    if (_e2373 > _e1039) {
                                                                                        phi_2977_ = _e2373;
                                                                                    } else {
                                                                                        phi_2977_ = _e1039;
                                                                                    }
                                                                                    let _e2378 = phi_2977_;
                                                                                    if (_e2375 < _e1041) {
                                                                                        phi_2982_ = _e2375;
                                                                                    } else {
                                                                                        phi_2982_ = _e1041;
                                                                                    }
                                                                                    let _e2381 = phi_2982_;
                                                                                    if (_e2249 < _e2378) {
                                                                                        phi_2987_ = _e2378;
                                                                                    } else {
                                                                                        phi_2987_ = _e2249;
                                                                                    }
                                                                                    let _e2384 = phi_2987_;
                                                                                    if (_e2384 > _e2381) {
                                                                                        phi_2992_ = _e2381;
                                                                                    } else {
                                                                                        phi_2992_ = _e2384;
                                                                                    }
                                                                                    let _e2387 = phi_2992_;
                                                                                    phi_2997_ = lt_bvh_triangle_Intersection(_e2387, (_e2090 / _e2149), (_e2111 / _e2149), (_e2378 <= _e2381));
                                                                                    phi_2998_ = false;
                                                                                } else {
                                                                                    phi_2997_ = lt_bvh_triangle_Intersection();
                                                                                    phi_2998_ = true;
                                                                                }
                                                                                let _e2393 = phi_2997_;
                                                                                let _e2395 = phi_2998_;
                                                                                phi_2999_ = _e2393;
                                                                                phi_3000_ = _e2395;
                                                                            } else {
                                                                                phi_2999_ = lt_bvh_triangle_Intersection();
                                                                                phi_3000_ = true;
                                                                            }
                                                                            let _e2397 = phi_2999_;
                                                                            let _e2399 = phi_3000_;
                                                                            if _e2399 {
                                                                            }
                                                                            phi_3004_ = _e2397;
                                                                            phi_3005_ = _e2399;
                                                                        }
                                                                        let _e2401 = phi_3004_;
                                                                        let _e2403 = phi_3005_;
                                                                        phi_3006_ = _e2401;
                                                                        phi_3007_ = _e2152;
                                                                        phi_3008_ = _e2403;
                                                                    } else {
                                                                        phi_3006_ = lt_bvh_triangle_Intersection();
                                                                        phi_3007_ = true;
                                                                        phi_3008_ = false;
                                                                    }
                                                                    let _e2405 = phi_3006_;
                                                                    let _e2407 = phi_3007_;
                                                                    let _e2409 = phi_3008_;
                                                                    if _e2407 {
                                                                        phi_3012_ = true;
                                                                    } else {
                                                                        phi_3012_ = _e2409;
                                                                    }
                                                                    let _e2411 = phi_3012_;
                                                                    if _e2411 {
                                                                        phi_3016_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_3016_ = _e2405;
                                                                    }
                                                                    let _e2413 = phi_3016_;
                                                                    if _e2413.is_hit {
                                                                        if (_e2413.t > _e157.tmin) {
                                                                            if (_e2413.t < _e1954.t) {
                                                                                phi_3064_ = true;
                                                                            } else {
                                                                                if (_e2413.t == _e1954.t) {
                                                                                    if (_e1954.triangle != 4294967295u) {
                                                                                        if (_e1965 < _e1954.triangle) {
                                                                                            phi_3055_ = true;
                                                                                        } else {
                                                                                            if (_e1965 == _e1954.triangle) {
                                                                                                phi_3054_ = (_e980 < _e1954.instance);
                                                                                            } else {
                                                                                                phi_3054_ = false;
                                                                                            }
                                                                                            let _e2431 = phi_3054_;
                                                                                            phi_3055_ = _e2431;
                                                                                        }
                                                                                        let _e2433 = phi_3055_;
                                                                                        phi_3056_ = _e2433;
                                                                                        phi_3057_ = false;
                                                                                    } else {
                                                                                        phi_3056_ = bool();
                                                                                        phi_3057_ = true;
                                                                                    }
                                                                                    let _e2435 = phi_3056_;
                                                                                    let _e2437 = phi_3057_;
                                                                                    phi_3058_ = _e2435;
                                                                                    phi_3059_ = _e2437;
                                                                                } else {
                                                                                    phi_3058_ = bool();
                                                                                    phi_3059_ = true;
                                                                                }
                                                                                let _e2439 = phi_3058_;
                                                                                let _e2441 = phi_3059_;
                                                                                if _e2441 {
                                                                                    phi_3063_ = false;
                                                                                } else {
                                                                                    phi_3063_ = _e2439;
                                                                                }
                                                                                let _e2443 = phi_3063_;
                                                                                phi_3064_ = _e2443;
                                                                            }
                                                                            let _e2445 = phi_3064_;
                                                                            if _e2445 {
                                                                                let _e2447 = triangles.member[(0u + _e1965)].i0_;
                                                                                if ((_e2447 & 2147483648u) == 0u) {
                                                                                    phi_3078_ = true;
                                                                                } else {
                                                                                    if true {
                                                                                    }
                                                                                    phi_3078_ = true;
                                                                                }
                                                                                let _e2451 = phi_3078_;
                                                                                if _e2451 {
                                                                                    phi_3086_ = lt_bvh_Hit(_e2413.t, _e2413.u, _e2413.v, _e1965, _e980);
                                                                                } else {
                                                                                    phi_3086_ = _e1954;
                                                                                }
                                                                                let _e2457 = phi_3086_;
                                                                                phi_3087_ = _e2457;
                                                                            } else {
                                                                                phi_3087_ = _e1954;
                                                                            }
                                                                            let _e2459 = phi_3087_;
                                                                            phi_3088_ = _e2459;
                                                                        } else {
                                                                            phi_3088_ = _e1954;
                                                                        }
                                                                        let _e2461 = phi_3088_;
                                                                        phi_3089_ = _e2461;
                                                                    } else {
                                                                        phi_3089_ = _e1954;
                                                                    }
                                                                    let _e2463 = phi_3089_;
                                                                    phi_2446_ = _e2463;
                                                                    phi_2449_ = (_e1956 & (_e1956 - 1u));
                                                                    phi_3090_ = true;
                                                                }
                                                                let _e2465 = phi_2446_;
                                                                let _e2467 = phi_2449_;
                                                                let _e2469 = phi_3090_;
                                                                continue;
                                                                continuing {
                                                                    phi_2445_ = _e2465;
                                                                    phi_2448_ = _e2467;
                                                                    break if !(_e2469);
                                                                }
                                                            }
                                                            let _e2472 = local_1.group_mask;
                                                            if ((_e2472 & 4278190080u) == 0u) {
                                                                let _e2476 = local_1.len;
                                                                if (_e2476 == 0u) {
                                                                    phi_3129_ = false;
                                                                } else {
                                                                    let _e2480 = local_1.len;
                                                                    local_1.len = (_e2480 - 1u);
                                                                    let _e2483 = local_1.len;
                                                                    if (_e2483 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2488 = local_1.first[(0u + _e2483)];
                                                                    local_1.group = _e2488;
                                                                    let _e2491 = local_1.len;
                                                                    if (_e2491 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2496 = local_1.mask[(0u + _e2491)];
                                                                    local_1.group_mask = _e2496;
                                                                    phi_3129_ = true;
                                                                }
                                                                let _e2499 = phi_3129_;
                                                                phi_3130_ = _e2499;
                                                            } else {
                                                                phi_3130_ = true;
                                                            }
                                                            let _e2501 = phi_3130_;
                                                            if _e2501 {
                                                                let _e2503 = local_1.group_mask;
                                                                let _e2509 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2503)), 32u, (_e2503 == 0u)));
                                                                let _e2513 = local_1.group_mask;
                                                                let _e2527 = local_1.group_mask;
                                                                local_1.group_mask = (_e2527 & ~((1u << bitcast<u32>((_e2509 & 31u)))));
                                                                let _e2530 = local_1.group;
                                                                phi_3161_ = (_e2530 + countOneBits(((_e2513 & ~((4294967295u << bitcast<u32>((((_e2509 - 24u) ^ _e1377) & 31u))))) & 255u)));
                                                            } else {
                                                                phi_3161_ = 4294967295u;
                                                            }
                                                            let _e2533 = phi_3161_;
                                                            let _e3663 = local_9;
                                                            phi_2113_ = _e3663;
                                                            phi_2116_ = _e2533;
                                                        } else {
                                                            phi_2113_ = lt_bvh_Hit();
                                                            phi_2116_ = u32();
                                                        }
                                                        let _e2535 = phi_2113_;
                                                        let _e2537 = phi_2116_;
                                                        continue;
                                                        continuing {
                                                            phi_2112_ = _e2535;
                                                            phi_2115_ = _e2537;
                                                            break if !(_e1518);
                                                        }
                                                    }
                                                    let _e3667 = local_10;
                                                    phi_3162_ = _e3667;
                                                }
                                                let _e2540 = phi_3162_;
                                                phi_3163_ = _e2540;
                                                phi_3164_ = _e1203;
                                            } else {
                                                phi_3163_ = lt_bvh_Hit();
                                                phi_3164_ = true;
                                            }
                                            let _e2542 = phi_3163_;
                                            let _e2544 = phi_3164_;
                                            if _e2544 {
                                                phi_3168_ = _e972;
                                            } else {
                                                phi_3168_ = _e2542;
                                            }
                                            let _e2546 = phi_3168_;
                                            phi_3169_ = _e2546;
                                        } else {
                                            phi_3169_ = _e972;
                                        }
                                        let _e2548 = phi_3169_;
                                        phi_3170_ = _e2548;
                                    } else {
                                        phi_3170_ = _e972;
                                    }
                                    let _e2550 = phi_3170_;
                                    phi_3171_ = _e2550;
                                } else {
                                    phi_3171_ = _e972;
                                }
                                let _e2552 = phi_3171_;
                                phi_1487_ = (_e970 & (_e970 - 1u));
                                phi_1490_ = _e2552;
                                phi_3172_ = true;
                            }
                            let _e2554 = phi_1487_;
                            let _e2556 = phi_1490_;
                            let _e2558 = phi_3172_;
                            continue;
                            continuing {
                                phi_1486_ = _e2554;
                                phi_1489_ = _e2556;
                                break if !(_e2558);
                            }
                        }
                        let _e2561 = local_2.group_mask;
                        if ((_e2561 & 4278190080u) == 0u) {
                            let _e2565 = local_2.len;
                            if (_e2565 == 0u) {
                                phi_3211_ = false;
                            } else {
                                let _e2569 = local_2.len;
                                local_2.len = (_e2569 - 1u);
                                let _e2572 = local_2.len;
                                if (_e2572 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2577 = local_2.first[(0u + _e2572)];
                                local_2.group = _e2577;
                                let _e2580 = local_2.len;
                                if (_e2580 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2585 = local_2.mask[(0u + _e2580)];
                                local_2.group_mask = _e2585;
                                phi_3211_ = true;
                            }
                            let _e2588 = phi_3211_;
                            phi_3212_ = _e2588;
                        } else {
                            phi_3212_ = true;
                        }
                        let _e2590 = phi_3212_;
                        if _e2590 {
                            let _e2592 = local_2.group_mask;
                            let _e2598 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2592)), 32u, (_e2592 == 0u)));
                            let _e2602 = local_2.group_mask;
                            let _e2616 = local_2.group_mask;
                            local_2.group_mask = (_e2616 & ~((1u << bitcast<u32>((_e2598 & 31u)))));
                            let _e2619 = local_2.group;
                            phi_3243_ = (_e2619 + countOneBits(((_e2602 & ~((4294967295u << bitcast<u32>((((_e2598 - 24u) ^ _e389) & 31u))))) & 255u)));
                        } else {
                            phi_3243_ = 4294967295u;
                        }
                        let _e2622 = phi_3243_;
                        phi_1150_ = _e2622;
                        let _e3683 = local_11;
                        phi_1153_ = _e3683;
                    } else {
                        phi_1150_ = u32();
                        phi_1153_ = lt_bvh_Hit();
                    }
                    let _e2624 = phi_1150_;
                    let _e2626 = phi_1153_;
                    continue;
                    continuing {
                        phi_1149_ = _e2624;
                        phi_1152_ = _e2626;
                        break if !(_e530);
                    }
                }
                let _e3686 = local_12;
                phi_3244_ = _e3686;
            }
            let _e2629 = phi_3244_;
            phi_3245_ = _e2629;
            phi_3246_ = _e229;
        } else {
            phi_3245_ = lt_bvh_Hit();
            phi_3246_ = true;
        }
        let _e2631 = phi_3245_;
        let _e2633 = phi_3246_;
        if _e2633 {
            phi_3250_ = _e159;
        } else {
            phi_3250_ = _e2631;
        }
        let _e2635 = phi_3250_;
        if (_e2635.triangle != 4294967295u) {
            let _e2641 = ((1f - _e2635.u) - _e2635.v);
            if (_e2635.triangle < _e79) {
            } else {
                return;
            }
            let _e2646 = triangles.member[(0u + _e2635.triangle)];
            if (_e2635.instance < _e91) {
            } else {
                return;
            }
            let _e2657 = instances.member[(0u + _e2635.instance)].object_to_world[0u];
            let _e2668 = ((((_e2657.x * _e2646.v0_.x) + (_e2657.y * _e2646.v0_.y)) + (_e2657.z * _e2646.v0_.z)) + (_e2657.w * 1f));
            let _e2670 = instances.member[(0u + _e2635.instance)].object_to_world[1u];
            let _e2681 = ((((_e2670.x * _e2646.v0_.x) + (_e2670.y * _e2646.v0_.y)) + (_e2670.z * _e2646.v0_.z)) + (_e2670.w * 1f));
            let _e2683 = instances.member[(0u + _e2635.instance)].object_to_world[2u];
            let _e2694 = ((((_e2683.x * _e2646.v0_.x) + (_e2683.y * _e2646.v0_.y)) + (_e2683.z * _e2646.v0_.z)) + (_e2683.w * 1f));
            let _e2701 = instances.member[(0u + _e2635.instance)].object_to_world[0u];
            let _e2712 = ((((_e2701.x * _e2646.v1_.x) + (_e2701.y * _e2646.v1_.y)) + (_e2701.z * _e2646.v1_.z)) + (_e2701.w * 1f));
            let _e2714 = instances.member[(0u + _e2635.instance)].object_to_world[1u];
            let _e2725 = ((((_e2714.x * _e2646.v1_.x) + (_e2714.y * _e2646.v1_.y)) + (_e2714.z * _e2646.v1_.z)) + (_e2714.w * 1f));
            let _e2727 = instances.member[(0u + _e2635.instance)].object_to_world[2u];
            let _e2738 = ((((_e2727.x * _e2646.v1_.x) + (_e2727.y * _e2646.v1_.y)) + (_e2727.z * _e2646.v1_.z)) + (_e2727.w * 1f));
            let _e2745 = instances.member[(0u + _e2635.instance)].object_to_world[0u];
            let _e2756 = ((((_e2745.x * _e2646.v2_.x) + (_e2745.y * _e2646.v2_.y)) + (_e2745.z * _e2646.v2_.z)) + (_e2745.w * 1f));
            let _e2758 = instances.member[(0u + _e2635.instance)].object_to_world[1u];
            let _e2769 = ((((_e2758.x * _e2646.v2_.x) + (_e2758.y * _e2646.v2_.y)) + (_e2758.z * _e2646.v2_.z)) + (_e2758.w * 1f));
            let _e2771 = instances.member[(0u + _e2635.instance)].object_to_world[2u];
            let _e2782 = ((((_e2771.x * _e2646.v2_.x) + (_e2771.y * _e2646.v2_.y)) + (_e2771.z * _e2646.v2_.z)) + (_e2771.w * 1f));
            let _e2795 = (((_e2668 * _e2641) + (_e2712 * _e2635.u)) + (_e2756 * _e2635.v));
            let _e2796 = (((_e2681 * _e2641) + (_e2725 * _e2635.u)) + (_e2769 * _e2635.v));
            let _e2797 = (((_e2694 * _e2641) + (_e2738 * _e2635.u)) + (_e2782 * _e2635.v));
            let _e2799 = abs(_e2668);
            let _e2800 = abs(_e2681);
            let _e2801 = abs(_e2694);
            let _e2802 = abs(_e2712);
            let _e2803 = abs(_e2725);
            let _e2804 = abs(_e2738);
            if (_e2799 > _e2802) {
                phi_3437_ = _e2799;
            } else {
                phi_3437_ = _e2802;
            }
            let _e2807 = phi_3437_;
            if (_e2800 > _e2803) {
                phi_3442_ = _e2800;
            } else {
                phi_3442_ = _e2803;
            }
            let _e2810 = phi_3442_;
            if (_e2801 > _e2804) {
                phi_3447_ = _e2801;
            } else {
                phi_3447_ = _e2804;
            }
            let _e2813 = phi_3447_;
            let _e2814 = abs(_e2756);
            let _e2815 = abs(_e2769);
            let _e2816 = abs(_e2782);
            if (_e2807 > _e2814) {
                phi_3455_ = _e2807;
            } else {
                phi_3455_ = _e2814;
            }
            let _e2819 = phi_3455_;
            if (_e2810 > _e2815) {
                phi_3460_ = _e2810;
            } else {
                phi_3460_ = _e2815;
            }
            let _e2822 = phi_3460_;
            if (_e2813 > _e2816) {
                phi_3465_ = _e2813;
            } else {
                phi_3465_ = _e2816;
            }
            let _e2825 = phi_3465_;
            let _e2826 = (_e2712 - _e2668);
            let _e2827 = (_e2725 - _e2681);
            let _e2828 = (_e2738 - _e2694);
            let _e2829 = (_e2756 - _e2668);
            let _e2830 = (_e2769 - _e2681);
            let _e2831 = (_e2782 - _e2694);
            let _e2835 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2827), abs(_e2828));
            let _e2836 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2826), _e2835);
            let _e2837 = (_e2826 / _e2836);
            let _e2838 = (_e2827 / _e2836);
            let _e2839 = (_e2828 / _e2836);
            let _e2843 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2830), abs(_e2831));
            let _e2844 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2829), _e2843);
            let _e2845 = (_e2829 / _e2844);
            let _e2846 = (_e2830 / _e2844);
            let _e2847 = (_e2831 / _e2844);
            let _e2850 = ((_e2838 * _e2847) - (_e2846 * _e2839));
            let _e2853 = ((_e2839 * _e2845) - (_e2847 * _e2837));
            let _e2856 = ((_e2837 * _e2846) - (_e2845 * _e2838));
            let _e2858 = p.member.eye;
            let _e2871 = (1f / sqrt((((_e2850 * _e2850) + (_e2853 * _e2853)) + (_e2856 * _e2856))));
            let _e2872 = (_e2850 * _e2871);
            let _e2873 = (_e2853 * _e2871);
            let _e2874 = (_e2856 * _e2871);
            if ((((_e2872 * (_e2858.x - _e2795)) + (_e2873 * (_e2858.y - _e2796))) + (_e2874 * (_e2858.z - _e2797))) < 0f) {
                phi_3529_ = vec3<f32>(-(_e2872), -(_e2873), -(_e2874));
            } else {
                phi_3529_ = vec3<f32>(_e2872, _e2873, _e2874);
            }
            let _e2887 = phi_3529_;
            if (_e2635.triangle < _e79) {
            } else {
                return;
            }
            let _e2892 = triangles.member[(0u + _e2635.triangle)];
            let _e2894 = (_e2892.i0_ & 2147483647u);
            if (_e2894 < _e82) {
            } else {
                return;
            }
            let _e2900 = vertices.member[(0u + _e2894)];
            if (_e2892.i1_ < _e82) {
            } else {
                return;
            }
            let _e2904 = vertices.member[(0u + _e2892.i1_)];
            if (_e2892.i2_ < _e82) {
            } else {
                return;
            }
            let _e2908 = vertices.member[(0u + _e2892.i2_)];
            let _e2909 = array<abi_Vertex, 3>(_e2900, _e2904, _e2908);
            if (_e2909[0].material < arrayLength((&materials.member))) {
            } else {
                return;
            }
            let _e2915 = materials.member[(0u + _e2909[0].material)];
            let _e2932 = (1f / 255f);
            let _e2951 = (1f / 255f);
            let _e2973 = (1f / 255f);
            if (_e2915.color_size == 0u) {
                phi_3772_ = vec3<f32>(1f, 1f, 1f);
            } else {
                local.offset = _e2915.color_offset;
                local.size = _e2915.color_size;
                local.flags = _e2915.flags;
                let _e3016 = _lt_shaders_texture_TextureView_quad((&local), (((_e2909[0].u * _e2641) + (_e2909[1].u * _e2635.u)) + (_e2909[2].u * _e2635.v)), (((_e2909[0].v * _e2641) + (_e2909[1].v * _e2635.u)) + (_e2909[2].v * _e2635.v)));
                if (_e3016.indices[0] < _e94) {
                } else {
                    return;
                }
                let _e3022 = color_texels.member[(0u + _e3016.indices[0])];
                let _e3033 = (1f / 255f);
                if (_e3016.indices[1] < _e94) {
                } else {
                    return;
                }
                let _e3047 = color_texels.member[(0u + _e3016.indices[1])];
                let _e3058 = (1f / 255f);
                if (_e3016.indices[2] < _e94) {
                } else {
                    return;
                }
                let _e3075 = color_texels.member[(0u + _e3016.indices[2])];
                let _e3086 = (1f / 255f);
                if (_e3016.indices[3] < _e94) {
                } else {
                    return;
                }
                let _e3103 = color_texels.member[(0u + _e3016.indices[3])];
                let _e3114 = (1f / 255f);
                let _e3123 = (((((f32((_e3022 & 255u)) * _e3033) * _e3016.weights.x) + ((f32((_e3047 & 255u)) * _e3058) * _e3016.weights.y)) + ((f32((_e3075 & 255u)) * _e3086) * _e3016.weights.z)) + ((f32((_e3103 & 255u)) * _e3114) * _e3016.weights.w));
                let _e3124 = (((((f32(((_e3022 >> bitcast<u32>(8i)) & 255u)) * _e3033) * _e3016.weights.x) + ((f32(((_e3047 >> bitcast<u32>(8i)) & 255u)) * _e3058) * _e3016.weights.y)) + ((f32(((_e3075 >> bitcast<u32>(8i)) & 255u)) * _e3086) * _e3016.weights.z)) + ((f32(((_e3103 >> bitcast<u32>(8i)) & 255u)) * _e3114) * _e3016.weights.w));
                let _e3125 = (((((f32(((_e3022 >> bitcast<u32>(16i)) & 255u)) * _e3033) * _e3016.weights.x) + ((f32(((_e3047 >> bitcast<u32>(16i)) & 255u)) * _e3058) * _e3016.weights.y)) + ((f32(((_e3075 >> bitcast<u32>(16i)) & 255u)) * _e3086) * _e3016.weights.z)) + ((f32(((_e3103 >> bitcast<u32>(16i)) & 255u)) * _e3114) * _e3016.weights.w));
                phi_3772_ = vec3<f32>((_e3123 * _e3123), (_e3124 * _e3124), (_e3125 * _e3125));
            }
            let _e3131 = phi_3772_;
            let _e3133 = ((_e2915.base_color.x * ((((f32((_e2909[0].color & 255u)) * _e2932) * _e2641) + ((f32((_e2909[1].color & 255u)) * _e2951) * _e2635.u)) + ((f32((_e2909[2].color & 255u)) * _e2973) * _e2635.v))) * _e3131.x);
            let _e3135 = ((_e2915.base_color.y * ((((f32(((_e2909[0].color >> bitcast<u32>(8i)) & 255u)) * _e2932) * _e2641) + ((f32(((_e2909[1].color >> bitcast<u32>(8i)) & 255u)) * _e2951) * _e2635.u)) + ((f32(((_e2909[2].color >> bitcast<u32>(8i)) & 255u)) * _e2973) * _e2635.v))) * _e3131.y);
            let _e3137 = ((_e2915.base_color.z * ((((f32(((_e2909[0].color >> bitcast<u32>(16i)) & 255u)) * _e2932) * _e2641) + ((f32(((_e2909[1].color >> bitcast<u32>(16i)) & 255u)) * _e2951) * _e2635.u)) + ((f32(((_e2909[2].color >> bitcast<u32>(16i)) & 255u)) * _e2973) * _e2635.v))) * _e3131.z);
            let _e3138 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e2822, _e2825);
            let _e3139 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e2819, _e3138);
            if ((_e2915.flags & 2u) == 0u) {
                phi_3787_ = 0u;
            } else {
                phi_3787_ = 1u;
            }
            let _e3144 = phi_3787_;
            if (_e2909[0].normal == 2147516416u) {
                phi_4017_ = _e2887;
            } else {
                let _e3157 = (f32((bitcast<i32>((_e2909[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3163 = (f32((bitcast<i32>(_e2909[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3167 = ((1f - abs(_e3157)) - abs(_e3163));
                if (_e3167 < 0f) {
                    phi_3814_ = -(_e3167);
                } else {
                    phi_3814_ = 0f;
                }
                let _e3171 = phi_3814_;
                if (_e3157 < 0f) {
                    phi_3821_ = (_e3157 + _e3171);
                } else {
                    phi_3821_ = (_e3157 - _e3171);
                }
                let _e3176 = phi_3821_;
                if (_e3163 < 0f) {
                    phi_3828_ = (_e3163 + _e3171);
                } else {
                    phi_3828_ = (_e3163 - _e3171);
                }
                let _e3181 = phi_3828_;
                let _e3188 = (1f / sqrt((((_e3176 * _e3176) + (_e3181 * _e3181)) + (_e3167 * _e3167))));
                let _e3204 = (f32((bitcast<i32>((_e2909[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3210 = (f32((bitcast<i32>(_e2909[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3214 = ((1f - abs(_e3204)) - abs(_e3210));
                if (_e3214 < 0f) {
                    phi_3863_ = -(_e3214);
                } else {
                    phi_3863_ = 0f;
                }
                let _e3218 = phi_3863_;
                if (_e3204 < 0f) {
                    phi_3870_ = (_e3204 + _e3218);
                } else {
                    phi_3870_ = (_e3204 - _e3218);
                }
                let _e3223 = phi_3870_;
                if (_e3210 < 0f) {
                    phi_3877_ = (_e3210 + _e3218);
                } else {
                    phi_3877_ = (_e3210 - _e3218);
                }
                let _e3228 = phi_3877_;
                let _e3235 = (1f / sqrt((((_e3223 * _e3223) + (_e3228 * _e3228)) + (_e3214 * _e3214))));
                let _e3254 = (f32((bitcast<i32>((_e2909[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3260 = (f32((bitcast<i32>(_e2909[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3264 = ((1f - abs(_e3254)) - abs(_e3260));
                if (_e3264 < 0f) {
                    phi_3915_ = -(_e3264);
                } else {
                    phi_3915_ = 0f;
                }
                let _e3268 = phi_3915_;
                if (_e3254 < 0f) {
                    phi_3922_ = (_e3254 + _e3268);
                } else {
                    phi_3922_ = (_e3254 - _e3268);
                }
                let _e3273 = phi_3922_;
                if (_e3260 < 0f) {
                    phi_3929_ = (_e3260 + _e3268);
                } else {
                    phi_3929_ = (_e3260 - _e3268);
                }
                let _e3278 = phi_3929_;
                let _e3285 = (1f / sqrt((((_e3273 * _e3273) + (_e3278 * _e3278)) + (_e3264 * _e3264))));
                let _e3292 = ((((_e3176 * _e3188) * _e2641) + ((_e3223 * _e3235) * _e2635.u)) + ((_e3273 * _e3285) * _e2635.v));
                let _e3293 = ((((_e3181 * _e3188) * _e2641) + ((_e3228 * _e3235) * _e2635.u)) + ((_e3278 * _e3285) * _e2635.v));
                let _e3294 = ((((_e3167 * _e3188) * _e2641) + ((_e3214 * _e3235) * _e2635.u)) + ((_e3264 * _e3285) * _e2635.v));
                if (_e2635.instance < _e91) {
                } else {
                    return;
                }
                let _e3301 = instances.member[(0u + _e2635.instance)].world_to_object[0u];
                let _e3310 = instances.member[(0u + _e2635.instance)].world_to_object[1u];
                let _e3322 = instances.member[(0u + _e2635.instance)].world_to_object[2u];
                let _e3329 = (((_e3301.x * _e3292) + (_e3310.x * _e3293)) + (_e3322.x * _e3294));
                let _e3330 = (((_e3301.y * _e3292) + (_e3310.y * _e3293)) + (_e3322.y * _e3294));
                let _e3331 = (((_e3301.z * _e3292) + (_e3310.z * _e3293)) + (_e3322.z * _e3294));
                let _e3337 = sqrt((((_e3329 * _e3329) + (_e3330 * _e3330)) + (_e3331 * _e3331)));
                if (_e3337 > 0f) {
                    let _e3339 = (_e3329 / _e3337);
                    let _e3340 = (_e3330 / _e3337);
                    let _e3341 = (_e3331 / _e3337);
                    if ((((_e3339 * _e2887.x) + (_e3340 * _e2887.y)) + (_e3341 * _e2887.z)) < 0f) {
                        phi_4015_ = vec3<f32>(-(_e3339), -(_e3340), -(_e3341));
                    } else {
                        phi_4015_ = vec3<f32>(_e3339, _e3340, _e3341);
                    }
                    let _e3357 = phi_4015_;
                    phi_4016_ = _e3357;
                } else {
                    phi_4016_ = _e2887;
                }
                let _e3359 = phi_4016_;
                phi_4017_ = _e3359;
            }
            let _e3361 = phi_4017_;
            if (_e3133 > 0f) {
                if (_e3133 < 1f) {
                    phi_4026_ = _e3133;
                } else {
                    phi_4026_ = 1f;
                }
                let _e3365 = phi_4026_;
                phi_4027_ = _e3365;
            } else {
                phi_4027_ = 0f;
            }
            let _e3367 = phi_4027_;
            if (_e3135 > 0f) {
                if (_e3135 < 1f) {
                    phi_4037_ = _e3135;
                } else {
                    phi_4037_ = 1f;
                }
                let _e3372 = phi_4037_;
                phi_4038_ = _e3372;
            } else {
                phi_4038_ = 0f;
            }
            let _e3374 = phi_4038_;
            if (_e3137 > 0f) {
                if (_e3137 < 1f) {
                    phi_4048_ = _e3137;
                } else {
                    phi_4048_ = 1f;
                }
                let _e3379 = phi_4048_;
                phi_4049_ = _e3379;
            } else {
                phi_4049_ = 0f;
            }
            let _e3381 = phi_4049_;
            let _e3384 = ((sqrt(_e3367) * 255f) + 0.5f);
            let _e3393 = ((sqrt(_e3374) * 255f) + 0.5f);
            let _e3405 = ((sqrt(_e3381) * 255f) + 0.5f);
            phi_4084_ = abi_Sample(vec3<f32>(_e2795, _e2796, _e2797), _e3139, _e2887, _e3144, _e3361, ((select(select(u32(_e3384), 0u, (_e3384 < bitcast<f32>(0u))), 4294967295u, (_e3384 > bitcast<f32>(1333788671u))) | (select(select(u32(_e3393), 0u, (_e3393 < bitcast<f32>(0u))), 4294967295u, (_e3393 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e3405), 0u, (_e3405 < bitcast<f32>(0u))), 4294967295u, (_e3405 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_4084_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e3419 = phi_4084_;
        if (_e100.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e100.shift)] = _e3419;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_instanced_color_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
