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
                let _e306 = phi_897_;
                if (_e157.direction.x < 0f) {
                    phi_904_ = (-1f / _e306);
                } else {
                    phi_904_ = (1f / _e306);
                }
                let _e311 = phi_904_;
                if (abs(_e157.direction.y) < _e299) {
                    phi_912_ = _e299;
                } else {
                    phi_912_ = abs(_e157.direction.y);
                }
                let _e318 = phi_912_;
                if (_e157.direction.y < 0f) {
                    phi_919_ = (-1f / _e318);
                } else {
                    phi_919_ = (1f / _e318);
                }
                let _e323 = phi_919_;
                if (abs(_e157.direction.z) < _e299) {
                    phi_927_ = _e299;
                } else {
                    phi_927_ = abs(_e157.direction.z);
                }
                let _e330 = phi_927_;
                if (_e157.direction.z < 0f) {
                    phi_934_ = (-1f / _e330);
                } else {
                    phi_934_ = (1f / _e330);
                }
                let _e335 = phi_934_;
                let _e343 = abs((bitcast<f32>(_e235) - _e157.origin.x));
                let _e344 = abs((bitcast<f32>(_e239) - _e157.origin.y));
                let _e345 = abs((bitcast<f32>(_e243) - _e157.origin.z));
                let _e353 = abs(((bitcast<f32>(_e247) + (bitcast<f32>((((_e259 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e157.origin.x));
                let _e354 = abs(((bitcast<f32>(_e251) + (bitcast<f32>((((_e259 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e157.origin.y));
                let _e355 = abs(((bitcast<f32>(_e255) + (bitcast<f32>((((_e259 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e157.origin.z));
                if (_e343 > _e353) {
                    phi_959_ = _e343;
                } else {
                    phi_959_ = _e353;
                }
                let _e358 = phi_959_;
                if (_e344 > _e354) {
                    phi_964_ = _e344;
                } else {
                    phi_964_ = _e354;
                }
                let _e361 = phi_964_;
                if (_e345 > _e355) {
                    phi_969_ = _e345;
                } else {
                    phi_969_ = _e355;
                }
                let _e364 = phi_969_;
                let _e365 = core_intrinsics_maximum_number_nsz_f32_(_e358, _e361);
                let _e366 = core_intrinsics_maximum_number_nsz_f32_(_e365, _e364);
                let _e371 = (_e366 * 0.0000019073486f);
                let _e372 = (abs(_e311) * _e371);
                let _e373 = (abs(_e323) * _e371);
                let _e374 = (abs(_e335) * _e371);
                let _e378 = (_e366 * 0.0000009536743f);
                let _e379 = (abs(_e311) * _e378);
                let _e380 = (abs(_e323) * _e378);
                let _e381 = (abs(_e335) * _e378);
                if (_e311 < 0f) {
                    phi_991_ = 0u;
                } else {
                    phi_991_ = 1u;
                }
                let _e384 = phi_991_;
                if (_e323 < 0f) {
                    phi_996_ = 0u;
                } else {
                    phi_996_ = 2u;
                }
                let _e387 = phi_996_;
                if (_e335 < 0f) {
                    phi_1001_ = 0u;
                } else {
                    phi_1001_ = 4u;
                }
                let _e390 = phi_1001_;
                let _e392 = ((_e384 | _e387) | _e390);
                let _e393 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e106, 2147483648u);
                local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e393.first[0], _e393.first[1], _e393.first[2], _e393.first[3], _e393.first[4], _e393.first[5], _e393.first[6], _e393.first[7], _e393.first[8], _e393.first[9], _e393.first[10], _e393.first[11], _e393.first[12], _e393.first[13], _e393.first[14], _e393.first[15], _e393.first[16], _e393.first[17], _e393.first[18], _e393.first[19], _e393.first[20], _e393.first[21], _e393.first[22], _e393.first[23], _e393.first[24], _e393.first[25], _e393.first[26], _e393.first[27], _e393.first[28], _e393.first[29], _e393.first[30], _e393.first[31]), array<u32, 32>(_e393.mask[0], _e393.mask[1], _e393.mask[2], _e393.mask[3], _e393.mask[4], _e393.mask[5], _e393.mask[6], _e393.mask[7], _e393.mask[8], _e393.mask[9], _e393.mask[10], _e393.mask[11], _e393.mask[12], _e393.mask[13], _e393.mask[14], _e393.mask[15], _e393.mask[16], _e393.mask[17], _e393.mask[18], _e393.mask[19], _e393.mask[20], _e393.mask[21], _e393.mask[22], _e393.mask[23], _e393.mask[24], _e393.mask[25], _e393.mask[26], _e393.mask[27], _e393.mask[28], _e393.mask[29], _e393.mask[30], _e393.mask[31]), _e393.len, _e393.group, _e393.group_mask);
                let _e467 = local_2.group_mask;
                if ((_e467 & 4278190080u) == 0u) {
                    let _e471 = local_2.len;
                    if (_e471 == 0u) {
                        phi_1115_ = false;
                    } else {
                        let _e475 = local_2.len;
                        local_2.len = (_e475 - 1u);
                        let _e478 = local_2.len;
                        if (_e478 < 32u) {
                        } else {
                            return;
                        }
                        let _e483 = local_2.first[(0u + _e478)];
                        local_2.group = _e483;
                        let _e486 = local_2.len;
                        if (_e486 < 32u) {
                        } else {
                            return;
                        }
                        let _e491 = local_2.mask[(0u + _e486)];
                        local_2.group_mask = _e491;
                        phi_1115_ = true;
                    }
                    let _e494 = phi_1115_;
                    phi_1116_ = _e494;
                } else {
                    phi_1116_ = true;
                }
                let _e496 = phi_1116_;
                if _e496 {
                    let _e498 = local_2.group_mask;
                    let _e504 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e498)), 32u, (_e498 == 0u)));
                    let _e508 = local_2.group_mask;
                    let _e522 = local_2.group_mask;
                    local_2.group_mask = (_e522 & ~((1u << bitcast<u32>((_e504 & 31u)))));
                    let _e525 = local_2.group;
                    phi_1147_ = (_e525 + countOneBits(((_e508 & ~((4294967295u << bitcast<u32>((((_e504 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1147_ = 4294967295u;
                }
                let _e528 = phi_1147_;
                phi_1149_ = _e528;
                phi_1152_ = _e159;
                loop {
                    let _e530 = phi_1149_;
                    let _e532 = phi_1152_;
                    local_12 = _e532;
                    let _e533 = (_e530 != 4294967295u);
                    if _e533 {
                        if (_e530 < _e76) {
                        } else {
                            return;
                        }
                        let _e541 = nodes.member[(0u + _e530)].frame[3u];
                        let _e566 = (bitcast<f32>((((_e541 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e311);
                        let _e567 = (bitcast<f32>((((_e541 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e323);
                        let _e568 = (bitcast<f32>((((_e541 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e335);
                        let _e571 = nodes.member[(0u + _e530)].frame[0u];
                        let _e575 = nodes.member[(0u + _e530)].frame[1u];
                        let _e579 = nodes.member[(0u + _e530)].frame[2u];
                        let _e587 = ((bitcast<f32>(_e571) - _e157.origin.x) * _e311);
                        let _e588 = ((bitcast<f32>(_e575) - _e157.origin.y) * _e323);
                        let _e589 = ((bitcast<f32>(_e579) - _e157.origin.z) * _e335);
                        let _e597 = nodes.member[(0u + _e530)].x;
                        if (_e311 < 0f) {
                            let _e608 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e597.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e614 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e608.unnamed.word, _e597.w), _e608.unnamed_1);
                            let _e620 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e614.unnamed, lt_mask_LightPlace(_e597.x, _e614.unnamed_1.shift));
                            phi_1237_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e620.unnamed, lt_mask_LightPlace(_e620.unnamed_1.word, _e597.y));
                        } else {
                            let _e636 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e597.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e642 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e636.unnamed.word, _e597.y), _e636.unnamed_1);
                            let _e648 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e642.unnamed, lt_mask_LightPlace(_e597.z, _e642.unnamed_1.shift));
                            phi_1237_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e648.unnamed, lt_mask_LightPlace(_e648.unnamed_1.word, _e597.w));
                        }
                        let _e656 = phi_1237_;
                        let _e666 = nodes.member[(0u + _e530)].y;
                        if (_e323 < 0f) {
                            let _e677 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e666.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e683 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e677.unnamed.word, _e666.w), _e677.unnamed_1);
                            let _e689 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e683.unnamed, lt_mask_LightPlace(_e666.x, _e683.unnamed_1.shift));
                            phi_1264_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e689.unnamed, lt_mask_LightPlace(_e689.unnamed_1.word, _e666.y));
                        } else {
                            let _e705 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e666.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e711 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e705.unnamed.word, _e666.y), _e705.unnamed_1);
                            let _e717 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e711.unnamed, lt_mask_LightPlace(_e666.z, _e711.unnamed_1.shift));
                            phi_1264_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e717.unnamed, lt_mask_LightPlace(_e717.unnamed_1.word, _e666.w));
                        }
                        let _e725 = phi_1264_;
                        let _e735 = nodes.member[(0u + _e530)].z;
                        if (_e335 < 0f) {
                            let _e746 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e735.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e752 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e746.unnamed.word, _e735.w), _e746.unnamed_1);
                            let _e758 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e752.unnamed, lt_mask_LightPlace(_e735.x, _e752.unnamed_1.shift));
                            phi_1291_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e758.unnamed, lt_mask_LightPlace(_e758.unnamed_1.word, _e735.y));
                        } else {
                            let _e774 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e735.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e780 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e774.unnamed.word, _e735.y), _e774.unnamed_1);
                            let _e786 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e780.unnamed, lt_mask_LightPlace(_e735.z, _e780.unnamed_1.shift));
                            phi_1291_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e786.unnamed, lt_mask_LightPlace(_e786.unnamed_1.word, _e735.w));
                        }
                        let _e794 = phi_1291_;
                        phi_1297_ = 0u;
                        phi_1300_ = 0u;
                        loop {
                            let _e804 = phi_1297_;
                            let _e806 = phi_1300_;
                            local_3 = _e806;
                            local_4 = _e806;
                            local_5 = _e806;
                            let _e807 = (_e804 < 8u);
                            if _e807 {
                                let _e809 = (_e804 >> bitcast<u32>(2i));
                                let _e810 = (_e804 & 3u);
                                if (_e809 == 0u) {
                                    phi_1314_ = _e656.unnamed.word;
                                } else {
                                    phi_1314_ = _e656.unnamed.shift;
                                }
                                let _e813 = phi_1314_;
                                if (_e809 == 0u) {
                                    phi_1324_ = _e725.unnamed.word;
                                } else {
                                    phi_1324_ = _e725.unnamed.shift;
                                }
                                let _e822 = phi_1324_;
                                if (_e809 == 0u) {
                                    phi_1334_ = _e794.unnamed.word;
                                } else {
                                    phi_1334_ = _e794.unnamed.shift;
                                }
                                let _e831 = phi_1334_;
                                let _e844 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e813 >> bitcast<u32>(((_e810 * 8u) & 31u))) & 255u)) * _e566) + (_e587 - _e372)), ((f32(((_e822 >> bitcast<u32>(((_e810 * 8u) & 31u))) & 255u)) * _e567) + (_e588 - _e373)));
                                let _e845 = core_intrinsics_maximum_number_nsz_f32_(_e844, ((f32(((_e831 >> bitcast<u32>(((_e810 * 8u) & 31u))) & 255u)) * _e568) + (_e589 - _e374)));
                                if (_e809 == 0u) {
                                    phi_1352_ = _e656.unnamed_1.word;
                                } else {
                                    phi_1352_ = _e656.unnamed_1.shift;
                                }
                                let _e848 = phi_1352_;
                                if (_e809 == 0u) {
                                    phi_1362_ = _e725.unnamed_1.word;
                                } else {
                                    phi_1362_ = _e725.unnamed_1.shift;
                                }
                                let _e857 = phi_1362_;
                                if (_e809 == 0u) {
                                    phi_1372_ = _e794.unnamed_1.word;
                                } else {
                                    phi_1372_ = _e794.unnamed_1.shift;
                                }
                                let _e866 = phi_1372_;
                                let _e879 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e848 >> bitcast<u32>(((_e810 * 8u) & 31u))) & 255u)) * _e566) + (_e587 + _e372)), ((f32(((_e857 >> bitcast<u32>(((_e810 * 8u) & 31u))) & 255u)) * _e567) + (_e588 + _e373)));
                                let _e880 = core_intrinsics_minimum_number_nsz_f32_(_e879, ((f32(((_e866 >> bitcast<u32>(((_e810 * 8u) & 31u))) & 255u)) * _e568) + (_e589 + _e374)));
                                if (_e845 <= _e880) {
                                    if (_e845 <= _e532.t) {
                                        if (_e880 >= _e157.tmin) {
                                            if (_e809 == 0u) {
                                                let _e887 = nodes.member[(0u + _e530)].links[2u];
                                                phi_1408_ = _e887;
                                            } else {
                                                let _e890 = nodes.member[(0u + _e530)].links[3u];
                                                phi_1408_ = _e890;
                                            }
                                            let _e892 = phi_1408_;
                                            let _e897 = ((_e892 >> bitcast<u32>(((_e810 * 8u) & 31u))) & 255u);
                                            let _e898 = (_e897 & 31u);
                                            if (_e898 >= 24u) {
                                                phi_1421_ = (24u + ((_e898 - 24u) ^ _e392));
                                            } else {
                                                phi_1421_ = _e898;
                                            }
                                            let _e904 = phi_1421_;
                                            phi_1426_ = (_e806 | ((_e897 >> bitcast<u32>(5i)) << bitcast<u32>((_e904 & 31u))));
                                        } else {
                                            phi_1426_ = _e806;
                                        }
                                        let _e912 = phi_1426_;
                                        phi_1427_ = _e912;
                                    } else {
                                        phi_1427_ = _e806;
                                    }
                                    let _e914 = phi_1427_;
                                    phi_1428_ = _e914;
                                } else {
                                    phi_1428_ = _e806;
                                }
                                let _e916 = phi_1428_;
                                phi_1298_ = (_e804 + 1u);
                                phi_1301_ = _e916;
                            } else {
                                phi_1298_ = u32();
                                phi_1301_ = u32();
                            }
                            let _e919 = phi_1298_;
                            let _e921 = phi_1301_;
                            continue;
                            continuing {
                                phi_1297_ = _e919;
                                phi_1300_ = _e921;
                                break if !(_e807);
                            }
                        }
                        let _e925 = nodes.member[(0u + _e530)].links[0u];
                        let _e929 = nodes.member[(0u + _e530)].frame[3u];
                        let _e933 = local_3;
                        if ((_e933 & 4278190080u) == 0u) {
                        } else {
                            let _e937 = local_2.group_mask;
                            if ((_e937 & 4278190080u) == 0u) {
                            } else {
                                let _e941 = local_2.len;
                                if (_e941 < 32u) {
                                    let _e944 = local_2.group;
                                    let _e946 = local_2.len;
                                    if (_e946 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.first[(0u + _e946)] = _e944;
                                    let _e952 = local_2.group_mask;
                                    let _e954 = local_2.len;
                                    if (_e954 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.mask[(0u + _e954)] = _e952;
                                    let _e961 = local_2.len;
                                    local_2.len = (_e961 + 1u);
                                }
                            }
                            local_2.group = (_e106 + _e925);
                            let _e965 = local_4;
                            local_2.group_mask = ((_e965 & 4278190080u) | (_e929 >> bitcast<u32>(24i)));
                        }
                        let _e970 = local_5;
                        phi_1486_ = (_e970 & 16777215u);
                        phi_1489_ = _e532;
                        loop {
                            let _e973 = phi_1486_;
                            let _e975 = phi_1489_;
                            local_11 = _e975;
                            if (_e973 == 0u) {
                                phi_1487_ = u32();
                                phi_1490_ = lt_bvh_Hit();
                                phi_3172_ = false;
                            } else {
                                let _e979 = nodes.member[(0u + _e530)].links[1u];
                                let _e983 = (_e979 + select(firstTrailingBit(_e973), 32u, (_e973 == 0u)));
                                if (_e983 < _e91) {
                                } else {
                                    return;
                                }
                                let _e990 = instances.member[(0u + _e983)].low_world;
                                let _e992 = instances.member[(0u + _e983)].high_world;
                                let _e1002 = ((_e990.x - _e157.origin.x) * _e311);
                                let _e1003 = ((_e990.y - _e157.origin.y) * _e323);
                                let _e1004 = ((_e990.z - _e157.origin.z) * _e335);
                                let _e1014 = ((_e992.x - _e157.origin.x) * _e311);
                                let _e1015 = ((_e992.y - _e157.origin.y) * _e323);
                                let _e1016 = ((_e992.z - _e157.origin.z) * _e335);
                                if (_e1002 < _e1014) {
                                    phi_1544_ = _e1002;
                                } else {
                                    phi_1544_ = _e1014;
                                }
                                let _e1019 = phi_1544_;
                                if (_e1003 < _e1015) {
                                    phi_1549_ = _e1003;
                                } else {
                                    phi_1549_ = _e1015;
                                }
                                let _e1022 = phi_1549_;
                                if (_e1004 < _e1016) {
                                    phi_1554_ = _e1004;
                                } else {
                                    phi_1554_ = _e1016;
                                }
                                let _e1025 = phi_1554_;
                                if (_e1002 > _e1014) {
                                    phi_1562_ = _e1002;
                                } else {
                                    phi_1562_ = _e1014;
                                }
                                let _e1031 = phi_1562_;
                                if (_e1003 > _e1015) {
                                    phi_1567_ = _e1003;
                                } else {
                                    phi_1567_ = _e1015;
                                }
                                let _e1034 = phi_1567_;
                                if (_e1004 > _e1016) {
                                    phi_1572_ = _e1004;
                                } else {
                                    phi_1572_ = _e1016;
                                }
                                let _e1037 = phi_1572_;
                                let _e1041 = core_intrinsics_maximum_number_nsz_f32_((_e1019 - _e379), (_e1022 - _e380));
                                let _e1042 = core_intrinsics_maximum_number_nsz_f32_(_e1041, (_e1025 - _e381));
                                let _e1043 = core_intrinsics_minimum_number_nsz_f32_((_e1031 + _e379), (_e1034 + _e380));
                                let _e1044 = core_intrinsics_minimum_number_nsz_f32_(_e1043, (_e1037 + _e381));
                                if (_e1042 <= _e1044) {
                                    if (_e1042 <= _e975.t) {
                                        if (_e1044 >= _e157.tmin) {
                                            let _e1056 = instances.member[(0u + _e983)].world_to_object[0u];
                                            let _e1067 = ((((_e1056.x * _e157.origin.x) + (_e1056.y * _e157.origin.y)) + (_e1056.z * _e157.origin.z)) + (_e1056.w * 1f));
                                            let _e1069 = instances.member[(0u + _e983)].world_to_object[1u];
                                            let _e1080 = ((((_e1069.x * _e157.origin.x) + (_e1069.y * _e157.origin.y)) + (_e1069.z * _e157.origin.z)) + (_e1069.w * 1f));
                                            let _e1082 = instances.member[(0u + _e983)].world_to_object[2u];
                                            let _e1093 = ((((_e1082.x * _e157.origin.x) + (_e1082.y * _e157.origin.y)) + (_e1082.z * _e157.origin.z)) + (_e1082.w * 1f));
                                            let _e1100 = instances.member[(0u + _e983)].world_to_object[0u];
                                            let _e1111 = ((((_e1100.x * _e157.direction.x) + (_e1100.y * _e157.direction.y)) + (_e1100.z * _e157.direction.z)) + (_e1100.w * 0f));
                                            let _e1113 = instances.member[(0u + _e983)].world_to_object[1u];
                                            let _e1124 = ((((_e1113.x * _e157.direction.x) + (_e1113.y * _e157.direction.y)) + (_e1113.z * _e157.direction.z)) + (_e1113.w * 0f));
                                            let _e1126 = instances.member[(0u + _e983)].world_to_object[2u];
                                            let _e1137 = ((((_e1126.x * _e157.direction.x) + (_e1126.y * _e157.direction.y)) + (_e1126.z * _e157.direction.z)) + (_e1126.w * 0f));
                                            let _e1142 = instances.member[(0u + _e983)].root;
                                            let _e1144 = instances.member[(0u + _e983)].first_triangle;
                                            let _e1148 = abs(_e1111);
                                            let _e1149 = abs(_e1124);
                                            let _e1150 = abs(_e1137);
                                            if (abs(_e1067) < 1000000000000000f) {
                                                if (abs(_e1080) < 1000000000000000f) {
                                                    if (abs(_e1093) < 1000000000000000f) {
                                                        if (_e1148 < 1000000000000000f) {
                                                            if (_e1149 < 1000000000000000f) {
                                                                if (_e1150 < 1000000000000000f) {
                                                                    if (_e1148 > 0f) {
                                                                        phi_1729_ = bool();
                                                                        phi_1730_ = true;
                                                                    } else {
                                                                        let _e1158 = (_e1149 > 0f);
                                                                        if _e1158 {
                                                                            phi_1728_ = bool();
                                                                        } else {
                                                                            phi_1728_ = (_e1150 > 0f);
                                                                        }
                                                                        let _e1161 = phi_1728_;
                                                                        phi_1729_ = _e1161;
                                                                        phi_1730_ = _e1158;
                                                                    }
                                                                    let _e1163 = phi_1729_;
                                                                    let _e1165 = phi_1730_;
                                                                    if _e1165 {
                                                                        phi_1734_ = true;
                                                                    } else {
                                                                        phi_1734_ = _e1163;
                                                                    }
                                                                    let _e1167 = phi_1734_;
                                                                    phi_1735_ = _e1167;
                                                                    phi_1736_ = false;
                                                                } else {
                                                                    phi_1735_ = bool();
                                                                    phi_1736_ = true;
                                                                }
                                                                let _e1169 = phi_1735_;
                                                                let _e1171 = phi_1736_;
                                                                phi_1737_ = _e1169;
                                                                phi_1738_ = false;
                                                                phi_1739_ = _e1171;
                                                            } else {
                                                                phi_1737_ = bool();
                                                                phi_1738_ = true;
                                                                phi_1739_ = false;
                                                            }
                                                            let _e1173 = phi_1737_;
                                                            let _e1175 = phi_1738_;
                                                            let _e1177 = phi_1739_;
                                                            phi_1740_ = _e1173;
                                                            phi_1741_ = _e1175;
                                                            phi_1742_ = _e1177;
                                                        } else {
                                                            phi_1740_ = bool();
                                                            phi_1741_ = true;
                                                            phi_1742_ = false;
                                                        }
                                                        let _e1179 = phi_1740_;
                                                        let _e1181 = phi_1741_;
                                                        let _e1183 = phi_1742_;
                                                        phi_1743_ = _e1179;
                                                        phi_1744_ = _e1181;
                                                        phi_1745_ = _e1183;
                                                    } else {
                                                        phi_1743_ = bool();
                                                        phi_1744_ = true;
                                                        phi_1745_ = false;
                                                    }
                                                    let _e1185 = phi_1743_;
                                                    let _e1187 = phi_1744_;
                                                    let _e1189 = phi_1745_;
                                                    phi_1746_ = _e1185;
                                                    phi_1747_ = _e1187;
                                                    phi_1748_ = _e1189;
                                                } else {
                                                    phi_1746_ = bool();
                                                    phi_1747_ = true;
                                                    phi_1748_ = false;
                                                }
                                                let _e1191 = phi_1746_;
                                                let _e1193 = phi_1747_;
                                                let _e1195 = phi_1748_;
                                                phi_1749_ = _e1191;
                                                phi_1750_ = _e1193;
                                                phi_1751_ = _e1195;
                                            } else {
                                                phi_1749_ = bool();
                                                phi_1750_ = true;
                                                phi_1751_ = false;
                                            }
                                            let _e1197 = phi_1749_;
                                            let _e1199 = phi_1750_;
                                            let _e1201 = phi_1751_;
                                            if _e1199 {
                                                phi_1755_ = true;
                                            } else {
                                                phi_1755_ = _e1201;
                                            }
                                            let _e1203 = phi_1755_;
                                            if _e1203 {
                                                phi_1759_ = false;
                                            } else {
                                                phi_1759_ = _e1197;
                                            }
                                            let _e1205 = phi_1759_;
                                            if _e1205 {
                                                let _e1206 = (_e1142 >= _e76);
                                                if _e1206 {
                                                    phi_3162_ = lt_bvh_Hit();
                                                } else {
                                                    if (_e1142 < _e76) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1212 = nodes.member[(0u + _e1142)].frame[0u];
                                                    let _e1216 = nodes.member[(0u + _e1142)].frame[1u];
                                                    let _e1220 = nodes.member[(0u + _e1142)].frame[2u];
                                                    let _e1224 = nodes.member[(0u + _e1142)].frame[0u];
                                                    let _e1228 = nodes.member[(0u + _e1142)].frame[1u];
                                                    let _e1232 = nodes.member[(0u + _e1142)].frame[2u];
                                                    let _e1236 = nodes.member[(0u + _e1142)].frame[3u];
                                                    let _e1270 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1111), abs(_e1124));
                                                    let _e1271 = core_intrinsics_maximum_number_nsz_f32_(_e1270, abs(_e1137));
                                                    let _e1272 = (_e1271 * 0.0000000000009094947f);
                                                    if (abs(_e1111) < _e1272) {
                                                        phi_1829_ = _e1272;
                                                    } else {
                                                        phi_1829_ = abs(_e1111);
                                                    }
                                                    let _e1277 = phi_1829_;
                                                    if (_e1111 < 0f) {
                                                        phi_1836_ = (-1f / _e1277);
                                                    } else {
                                                        phi_1836_ = (1f / _e1277);
                                                    }
                                                    let _e1282 = phi_1836_;
                                                    if (abs(_e1124) < _e1272) {
                                                        phi_1843_ = _e1272;
                                                    } else {
                                                        phi_1843_ = abs(_e1124);
                                                    }
                                                    let _e1287 = phi_1843_;
                                                    if (_e1124 < 0f) {
                                                        phi_1850_ = (-1f / _e1287);
                                                    } else {
                                                        phi_1850_ = (1f / _e1287);
                                                    }
                                                    let _e1292 = phi_1850_;
                                                    if (abs(_e1137) < _e1272) {
                                                        phi_1857_ = _e1272;
                                                    } else {
                                                        phi_1857_ = abs(_e1137);
                                                    }
                                                    let _e1297 = phi_1857_;
                                                    if (_e1137 < 0f) {
                                                        phi_1864_ = (-1f / _e1297);
                                                    } else {
                                                        phi_1864_ = (1f / _e1297);
                                                    }
                                                    let _e1302 = phi_1864_;
                                                    let _e1306 = abs((bitcast<f32>(_e1212) - _e1067));
                                                    let _e1307 = abs((bitcast<f32>(_e1216) - _e1080));
                                                    let _e1308 = abs((bitcast<f32>(_e1220) - _e1093));
                                                    let _e1312 = abs(((bitcast<f32>(_e1224) + (bitcast<f32>((((_e1236 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1067));
                                                    let _e1313 = abs(((bitcast<f32>(_e1228) + (bitcast<f32>((((_e1236 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1080));
                                                    let _e1314 = abs(((bitcast<f32>(_e1232) + (bitcast<f32>((((_e1236 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1093));
                                                    if (_e1306 > _e1312) {
                                                        phi_1881_ = _e1306;
                                                    } else {
                                                        phi_1881_ = _e1312;
                                                    }
                                                    let _e1317 = phi_1881_;
                                                    if (_e1307 > _e1313) {
                                                        phi_1886_ = _e1307;
                                                    } else {
                                                        phi_1886_ = _e1313;
                                                    }
                                                    let _e1320 = phi_1886_;
                                                    if (_e1308 > _e1314) {
                                                        phi_1891_ = _e1308;
                                                    } else {
                                                        phi_1891_ = _e1314;
                                                    }
                                                    let _e1323 = phi_1891_;
                                                    let _e1324 = core_intrinsics_maximum_number_nsz_f32_(_e1317, _e1320);
                                                    let _e1325 = core_intrinsics_maximum_number_nsz_f32_(_e1324, _e1323);
                                                    let _e1329 = (_e1325 * 0.0000019073486f);
                                                    let _e1330 = (abs(_e1282) * _e1329);
                                                    let _e1331 = (abs(_e1292) * _e1329);
                                                    let _e1332 = (abs(_e1302) * _e1329);
                                                    let _e1336 = (_e1325 * 0.0000009536743f);
                                                    let _e1337 = (abs(_e1282) * _e1336);
                                                    let _e1338 = (abs(_e1292) * _e1336);
                                                    let _e1339 = (abs(_e1302) * _e1336);
                                                    let _e1340 = abs(_e1111);
                                                    let _e1341 = abs(_e1124);
                                                    let _e1342 = abs(_e1137);
                                                    if (_e1340 >= _e1341) {
                                                        if (_e1340 >= _e1342) {
                                                            phi_1919_ = false;
                                                        } else {
                                                            phi_1919_ = true;
                                                        }
                                                        let _e1346 = phi_1919_;
                                                        phi_1920_ = _e1346;
                                                    } else {
                                                        phi_1920_ = true;
                                                    }
                                                    let _e1348 = phi_1920_;
                                                    if _e1348 {
                                                        if (_e1341 >= _e1342) {
                                                            phi_1928_ = 1u;
                                                        } else {
                                                            phi_1928_ = 2u;
                                                        }
                                                        let _e1351 = phi_1928_;
                                                        phi_1929_ = _e1351;
                                                    } else {
                                                        phi_1929_ = 0u;
                                                    }
                                                    let _e1353 = phi_1929_;
                                                    if (_e1353 == 0u) {
                                                        phi_1941_ = vec3<f32>(_e1124, _e1137, _e1111);
                                                    } else {
                                                        if (_e1353 == 1u) {
                                                            phi_1940_ = vec3<f32>(_e1137, _e1111, _e1124);
                                                        } else {
                                                            phi_1940_ = vec3<f32>(_e1111, _e1124, _e1137);
                                                        }
                                                        let _e1359 = phi_1940_;
                                                        phi_1941_ = _e1359;
                                                    }
                                                    let _e1361 = phi_1941_;
                                                    let _e1364 = (_e1361.x / _e1361.z);
                                                    let _e1367 = (_e1361.y / _e1361.z);
                                                    if (_e1282 < 0f) {
                                                        phi_1954_ = 0u;
                                                    } else {
                                                        phi_1954_ = 1u;
                                                    }
                                                    let _e1372 = phi_1954_;
                                                    if (_e1292 < 0f) {
                                                        phi_1959_ = 0u;
                                                    } else {
                                                        phi_1959_ = 2u;
                                                    }
                                                    let _e1375 = phi_1959_;
                                                    if (_e1302 < 0f) {
                                                        phi_1964_ = 0u;
                                                    } else {
                                                        phi_1964_ = 4u;
                                                    }
                                                    let _e1378 = phi_1964_;
                                                    let _e1380 = ((_e1372 | _e1375) | _e1378);
                                                    let _e1381 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1142, 2147483648u);
                                                    local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e1381.first[0], _e1381.first[1], _e1381.first[2], _e1381.first[3], _e1381.first[4], _e1381.first[5], _e1381.first[6], _e1381.first[7], _e1381.first[8], _e1381.first[9], _e1381.first[10], _e1381.first[11], _e1381.first[12], _e1381.first[13], _e1381.first[14], _e1381.first[15], _e1381.first[16], _e1381.first[17], _e1381.first[18], _e1381.first[19], _e1381.first[20], _e1381.first[21], _e1381.first[22], _e1381.first[23], _e1381.first[24], _e1381.first[25], _e1381.first[26], _e1381.first[27], _e1381.first[28], _e1381.first[29], _e1381.first[30], _e1381.first[31]), array<u32, 32>(_e1381.mask[0], _e1381.mask[1], _e1381.mask[2], _e1381.mask[3], _e1381.mask[4], _e1381.mask[5], _e1381.mask[6], _e1381.mask[7], _e1381.mask[8], _e1381.mask[9], _e1381.mask[10], _e1381.mask[11], _e1381.mask[12], _e1381.mask[13], _e1381.mask[14], _e1381.mask[15], _e1381.mask[16], _e1381.mask[17], _e1381.mask[18], _e1381.mask[19], _e1381.mask[20], _e1381.mask[21], _e1381.mask[22], _e1381.mask[23], _e1381.mask[24], _e1381.mask[25], _e1381.mask[26], _e1381.mask[27], _e1381.mask[28], _e1381.mask[29], _e1381.mask[30], _e1381.mask[31]), _e1381.len, _e1381.group, _e1381.group_mask);
                                                    let _e1455 = local_1.group_mask;
                                                    if ((_e1455 & 4278190080u) == 0u) {
                                                        let _e1459 = local_1.len;
                                                        if (_e1459 == 0u) {
                                                            phi_2078_ = false;
                                                        } else {
                                                            let _e1463 = local_1.len;
                                                            local_1.len = (_e1463 - 1u);
                                                            let _e1466 = local_1.len;
                                                            if (_e1466 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1471 = local_1.first[(0u + _e1466)];
                                                            local_1.group = _e1471;
                                                            let _e1474 = local_1.len;
                                                            if (_e1474 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1479 = local_1.mask[(0u + _e1474)];
                                                            local_1.group_mask = _e1479;
                                                            phi_2078_ = true;
                                                        }
                                                        let _e1482 = phi_2078_;
                                                        phi_2079_ = _e1482;
                                                    } else {
                                                        phi_2079_ = true;
                                                    }
                                                    let _e1484 = phi_2079_;
                                                    if _e1484 {
                                                        let _e1486 = local_1.group_mask;
                                                        let _e1492 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1486)), 32u, (_e1486 == 0u)));
                                                        let _e1496 = local_1.group_mask;
                                                        let _e1510 = local_1.group_mask;
                                                        local_1.group_mask = (_e1510 & ~((1u << bitcast<u32>((_e1492 & 31u)))));
                                                        let _e1513 = local_1.group;
                                                        phi_2110_ = (_e1513 + countOneBits(((_e1496 & ~((4294967295u << bitcast<u32>((((_e1492 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_2110_ = 4294967295u;
                                                    }
                                                    let _e1516 = phi_2110_;
                                                    phi_2112_ = _e975;
                                                    phi_2115_ = _e1516;
                                                    loop {
                                                        let _e1518 = phi_2112_;
                                                        let _e1520 = phi_2115_;
                                                        local_10 = _e1518;
                                                        let _e1521 = (_e1520 != 4294967295u);
                                                        if _e1521 {
                                                            if (_e1520 < _e76) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1528 = nodes.member[(0u + _e1520)].frame[3u];
                                                            let _e1553 = (bitcast<f32>((((_e1528 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1282);
                                                            let _e1554 = (bitcast<f32>((((_e1528 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1292);
                                                            let _e1555 = (bitcast<f32>((((_e1528 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1302);
                                                            let _e1558 = nodes.member[(0u + _e1520)].frame[0u];
                                                            let _e1562 = nodes.member[(0u + _e1520)].frame[1u];
                                                            let _e1566 = nodes.member[(0u + _e1520)].frame[2u];
                                                            let _e1571 = ((bitcast<f32>(_e1558) - _e1067) * _e1282);
                                                            let _e1572 = ((bitcast<f32>(_e1562) - _e1080) * _e1292);
                                                            let _e1573 = ((bitcast<f32>(_e1566) - _e1093) * _e1302);
                                                            let _e1581 = nodes.member[(0u + _e1520)].x;
                                                            if (_e1282 < 0f) {
                                                                let _e1592 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1581.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1598 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1592.unnamed.word, _e1581.w), _e1592.unnamed_1);
                                                                let _e1604 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1598.unnamed, lt_mask_LightPlace(_e1581.x, _e1598.unnamed_1.shift));
                                                                phi_2196_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1604.unnamed, lt_mask_LightPlace(_e1604.unnamed_1.word, _e1581.y));
                                                            } else {
                                                                let _e1620 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1581.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1626 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1620.unnamed.word, _e1581.y), _e1620.unnamed_1);
                                                                let _e1632 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1626.unnamed, lt_mask_LightPlace(_e1581.z, _e1626.unnamed_1.shift));
                                                                phi_2196_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1632.unnamed, lt_mask_LightPlace(_e1632.unnamed_1.word, _e1581.w));
                                                            }
                                                            let _e1640 = phi_2196_;
                                                            let _e1650 = nodes.member[(0u + _e1520)].y;
                                                            if (_e1292 < 0f) {
                                                                let _e1661 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1650.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1667 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1661.unnamed.word, _e1650.w), _e1661.unnamed_1);
                                                                let _e1673 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1667.unnamed, lt_mask_LightPlace(_e1650.x, _e1667.unnamed_1.shift));
                                                                phi_2223_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1673.unnamed, lt_mask_LightPlace(_e1673.unnamed_1.word, _e1650.y));
                                                            } else {
                                                                let _e1689 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1650.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1695 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1689.unnamed.word, _e1650.y), _e1689.unnamed_1);
                                                                let _e1701 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1695.unnamed, lt_mask_LightPlace(_e1650.z, _e1695.unnamed_1.shift));
                                                                phi_2223_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1701.unnamed, lt_mask_LightPlace(_e1701.unnamed_1.word, _e1650.w));
                                                            }
                                                            let _e1709 = phi_2223_;
                                                            let _e1719 = nodes.member[(0u + _e1520)].z;
                                                            if (_e1302 < 0f) {
                                                                let _e1730 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1719.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1736 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1730.unnamed.word, _e1719.w), _e1730.unnamed_1);
                                                                let _e1742 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1736.unnamed, lt_mask_LightPlace(_e1719.x, _e1736.unnamed_1.shift));
                                                                phi_2250_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1742.unnamed, lt_mask_LightPlace(_e1742.unnamed_1.word, _e1719.y));
                                                            } else {
                                                                let _e1758 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1719.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1764 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1758.unnamed.word, _e1719.y), _e1758.unnamed_1);
                                                                let _e1770 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1764.unnamed, lt_mask_LightPlace(_e1719.z, _e1764.unnamed_1.shift));
                                                                phi_2250_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1770.unnamed, lt_mask_LightPlace(_e1770.unnamed_1.word, _e1719.w));
                                                            }
                                                            let _e1778 = phi_2250_;
                                                            phi_2256_ = 0u;
                                                            phi_2259_ = 0u;
                                                            loop {
                                                                let _e1788 = phi_2256_;
                                                                let _e1790 = phi_2259_;
                                                                local_6 = _e1790;
                                                                local_7 = _e1790;
                                                                local_8 = _e1790;
                                                                let _e1791 = (_e1788 < 8u);
                                                                if _e1791 {
                                                                    let _e1793 = (_e1788 >> bitcast<u32>(2i));
                                                                    let _e1794 = (_e1788 & 3u);
                                                                    if (_e1793 == 0u) {
                                                                        phi_2273_ = _e1640.unnamed.word;
                                                                    } else {
                                                                        phi_2273_ = _e1640.unnamed.shift;
                                                                    }
                                                                    let _e1797 = phi_2273_;
                                                                    if (_e1793 == 0u) {
                                                                        phi_2283_ = _e1709.unnamed.word;
                                                                    } else {
                                                                        phi_2283_ = _e1709.unnamed.shift;
                                                                    }
                                                                    let _e1806 = phi_2283_;
                                                                    if (_e1793 == 0u) {
                                                                        phi_2293_ = _e1778.unnamed.word;
                                                                    } else {
                                                                        phi_2293_ = _e1778.unnamed.shift;
                                                                    }
                                                                    let _e1815 = phi_2293_;
                                                                    let _e1828 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1797 >> bitcast<u32>(((_e1794 * 8u) & 31u))) & 255u)) * _e1553) + (_e1571 - _e1330)), ((f32(((_e1806 >> bitcast<u32>(((_e1794 * 8u) & 31u))) & 255u)) * _e1554) + (_e1572 - _e1331)));
                                                                    let _e1829 = core_intrinsics_maximum_number_nsz_f32_(_e1828, ((f32(((_e1815 >> bitcast<u32>(((_e1794 * 8u) & 31u))) & 255u)) * _e1555) + (_e1573 - _e1332)));
                                                                    if (_e1793 == 0u) {
                                                                        phi_2311_ = _e1640.unnamed_1.word;
                                                                    } else {
                                                                        phi_2311_ = _e1640.unnamed_1.shift;
                                                                    }
                                                                    let _e1832 = phi_2311_;
                                                                    if (_e1793 == 0u) {
                                                                        phi_2321_ = _e1709.unnamed_1.word;
                                                                    } else {
                                                                        phi_2321_ = _e1709.unnamed_1.shift;
                                                                    }
                                                                    let _e1841 = phi_2321_;
                                                                    if (_e1793 == 0u) {
                                                                        phi_2331_ = _e1778.unnamed_1.word;
                                                                    } else {
                                                                        phi_2331_ = _e1778.unnamed_1.shift;
                                                                    }
                                                                    let _e1850 = phi_2331_;
                                                                    let _e1863 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1832 >> bitcast<u32>(((_e1794 * 8u) & 31u))) & 255u)) * _e1553) + (_e1571 + _e1330)), ((f32(((_e1841 >> bitcast<u32>(((_e1794 * 8u) & 31u))) & 255u)) * _e1554) + (_e1572 + _e1331)));
                                                                    let _e1864 = core_intrinsics_minimum_number_nsz_f32_(_e1863, ((f32(((_e1850 >> bitcast<u32>(((_e1794 * 8u) & 31u))) & 255u)) * _e1555) + (_e1573 + _e1332)));
                                                                    if (_e1829 <= _e1864) {
                                                                        if (_e1829 <= _e1518.t) {
                                                                            if (_e1864 >= _e157.tmin) {
                                                                                if (_e1793 == 0u) {
                                                                                    let _e1871 = nodes.member[(0u + _e1520)].links[2u];
                                                                                    phi_2367_ = _e1871;
                                                                                } else {
                                                                                    let _e1874 = nodes.member[(0u + _e1520)].links[3u];
                                                                                    phi_2367_ = _e1874;
                                                                                }
                                                                                let _e1876 = phi_2367_;
                                                                                let _e1881 = ((_e1876 >> bitcast<u32>(((_e1794 * 8u) & 31u))) & 255u);
                                                                                let _e1882 = (_e1881 & 31u);
                                                                                if (_e1882 >= 24u) {
                                                                                    phi_2380_ = (24u + ((_e1882 - 24u) ^ _e1380));
                                                                                } else {
                                                                                    phi_2380_ = _e1882;
                                                                                }
                                                                                let _e1888 = phi_2380_;
                                                                                phi_2385_ = (_e1790 | ((_e1881 >> bitcast<u32>(5i)) << bitcast<u32>((_e1888 & 31u))));
                                                                            } else {
                                                                                phi_2385_ = _e1790;
                                                                            }
                                                                            let _e1896 = phi_2385_;
                                                                            phi_2386_ = _e1896;
                                                                        } else {
                                                                            phi_2386_ = _e1790;
                                                                        }
                                                                        let _e1898 = phi_2386_;
                                                                        phi_2387_ = _e1898;
                                                                    } else {
                                                                        phi_2387_ = _e1790;
                                                                    }
                                                                    let _e1900 = phi_2387_;
                                                                    phi_2257_ = (_e1788 + 1u);
                                                                    phi_2260_ = _e1900;
                                                                } else {
                                                                    phi_2257_ = u32();
                                                                    phi_2260_ = u32();
                                                                }
                                                                let _e1903 = phi_2257_;
                                                                let _e1905 = phi_2260_;
                                                                continue;
                                                                continuing {
                                                                    phi_2256_ = _e1903;
                                                                    phi_2259_ = _e1905;
                                                                    break if !(_e1791);
                                                                }
                                                            }
                                                            let _e1909 = nodes.member[(0u + _e1520)].links[0u];
                                                            let _e1913 = nodes.member[(0u + _e1520)].frame[3u];
                                                            let _e1917 = local_6;
                                                            if ((_e1917 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1921 = local_1.group_mask;
                                                                if ((_e1921 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1925 = local_1.len;
                                                                    if (_e1925 < 32u) {
                                                                        let _e1928 = local_1.group;
                                                                        let _e1930 = local_1.len;
                                                                        if (_e1930 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.first[(0u + _e1930)] = _e1928;
                                                                        let _e1936 = local_1.group_mask;
                                                                        let _e1938 = local_1.len;
                                                                        if (_e1938 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.mask[(0u + _e1938)] = _e1936;
                                                                        let _e1945 = local_1.len;
                                                                        local_1.len = (_e1945 + 1u);
                                                                    }
                                                                }
                                                                local_1.group = (_e1142 + _e1909);
                                                                let _e1949 = local_7;
                                                                local_1.group_mask = ((_e1949 & 4278190080u) | (_e1913 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1954 = local_8;
                                                            phi_2445_ = _e1518;
                                                            phi_2448_ = (_e1954 & 16777215u);
                                                            loop {
                                                                let _e1957 = phi_2445_;
                                                                let _e1959 = phi_2448_;
                                                                local_9 = _e1957;
                                                                if (_e1959 == 0u) {
                                                                    phi_2446_ = lt_bvh_Hit();
                                                                    phi_2449_ = u32();
                                                                    phi_3090_ = false;
                                                                } else {
                                                                    let _e1963 = nodes.member[(0u + _e1520)].links[1u];
                                                                    let _e1968 = ((_e1144 + _e1963) + select(firstTrailingBit(_e1959), 32u, (_e1959 == 0u)));
                                                                    if (_e1968 < _e79) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1975 = triangles.member[(0u + _e1968)].v0_;
                                                                    let _e1977 = (_e1975.x - _e1067);
                                                                    let _e1979 = (_e1975.y - _e1080);
                                                                    let _e1981 = (_e1975.z - _e1093);
                                                                    if (_e1353 == 0u) {
                                                                        phi_2493_ = vec3<f32>(_e1979, _e1981, _e1977);
                                                                    } else {
                                                                        if (_e1353 == 1u) {
                                                                            phi_2492_ = vec3<f32>(_e1981, _e1977, _e1979);
                                                                        } else {
                                                                            phi_2492_ = (_e1975 - vec3<f32>(_e1067, _e1080, _e1093));
                                                                        }
                                                                        let _e1989 = phi_2492_;
                                                                        phi_2493_ = _e1989;
                                                                    }
                                                                    let _e1991 = phi_2493_;
                                                                    let _e1995 = (_e1991.x - (_e1364 * _e1991.z));
                                                                    let _e1999 = (_e1991.y - (_e1367 * _e1991.z));
                                                                    let _e2001 = triangles.member[(0u + _e1968)].v1_;
                                                                    let _e2003 = (_e2001.x - _e1067);
                                                                    let _e2005 = (_e2001.y - _e1080);
                                                                    let _e2007 = (_e2001.z - _e1093);
                                                                    if (_e1353 == 0u) {
                                                                        phi_2523_ = vec3<f32>(_e2005, _e2007, _e2003);
                                                                    } else {
                                                                        if (_e1353 == 1u) {
                                                                            phi_2522_ = vec3<f32>(_e2007, _e2003, _e2005);
                                                                        } else {
                                                                            phi_2522_ = (_e2001 - vec3<f32>(_e1067, _e1080, _e1093));
                                                                        }
                                                                        let _e2015 = phi_2522_;
                                                                        phi_2523_ = _e2015;
                                                                    }
                                                                    let _e2017 = phi_2523_;
                                                                    let _e2021 = (_e2017.x - (_e1364 * _e2017.z));
                                                                    let _e2025 = (_e2017.y - (_e1367 * _e2017.z));
                                                                    let _e2027 = triangles.member[(0u + _e1968)].v2_;
                                                                    let _e2029 = (_e2027.x - _e1067);
                                                                    let _e2031 = (_e2027.y - _e1080);
                                                                    let _e2033 = (_e2027.z - _e1093);
                                                                    if (_e1353 == 0u) {
                                                                        phi_2553_ = vec3<f32>(_e2031, _e2033, _e2029);
                                                                    } else {
                                                                        if (_e1353 == 1u) {
                                                                            phi_2552_ = vec3<f32>(_e2033, _e2029, _e2031);
                                                                        } else {
                                                                            phi_2552_ = (_e2027 - vec3<f32>(_e1067, _e1080, _e1093));
                                                                        }
                                                                        let _e2041 = phi_2552_;
                                                                        phi_2553_ = _e2041;
                                                                    }
                                                                    let _e2043 = phi_2553_;
                                                                    let _e2047 = (_e2043.x - (_e1364 * _e2043.z));
                                                                    let _e2051 = (_e2043.y - (_e1367 * _e2043.z));
                                                                    if (_e2021 < _e2047) {
                                                                        phi_2572_ = true;
                                                                    } else {
                                                                        if (_e2021 == _e2047) {
                                                                            phi_2571_ = (_e2025 < _e2051);
                                                                        } else {
                                                                            phi_2571_ = false;
                                                                        }
                                                                        let _e2056 = phi_2571_;
                                                                        phi_2572_ = _e2056;
                                                                    }
                                                                    let _e2058 = phi_2572_;
                                                                    if _e2058 {
                                                                        phi_2576_ = _e2051;
                                                                        phi_2577_ = _e2047;
                                                                        phi_2578_ = _e2025;
                                                                        phi_2579_ = _e2021;
                                                                    } else {
                                                                        phi_2576_ = _e2025;
                                                                        phi_2577_ = _e2021;
                                                                        phi_2578_ = _e2051;
                                                                        phi_2579_ = _e2047;
                                                                    }
                                                                    let _e2060 = phi_2576_;
                                                                    let _e2062 = phi_2577_;
                                                                    let _e2064 = phi_2578_;
                                                                    let _e2066 = phi_2579_;
                                                                    let _e2069 = ((_e2066 * _e2060) - (_e2064 * _e2062));
                                                                    if _e2058 {
                                                                        phi_2587_ = -(_e2069);
                                                                    } else {
                                                                        phi_2587_ = _e2069;
                                                                    }
                                                                    let _e2072 = phi_2587_;
                                                                    if (_e2047 < _e1995) {
                                                                        phi_2598_ = true;
                                                                    } else {
                                                                        if (_e2047 == _e1995) {
                                                                            phi_2597_ = (_e2051 < _e1999);
                                                                        } else {
                                                                            phi_2597_ = false;
                                                                        }
                                                                        let _e2077 = phi_2597_;
                                                                        phi_2598_ = _e2077;
                                                                    }
                                                                    let _e2079 = phi_2598_;
                                                                    if _e2079 {
                                                                        phi_2602_ = _e1999;
                                                                        phi_2603_ = _e1995;
                                                                        phi_2604_ = _e2051;
                                                                        phi_2605_ = _e2047;
                                                                    } else {
                                                                        phi_2602_ = _e2051;
                                                                        phi_2603_ = _e2047;
                                                                        phi_2604_ = _e1999;
                                                                        phi_2605_ = _e1995;
                                                                    }
                                                                    let _e2081 = phi_2602_;
                                                                    let _e2083 = phi_2603_;
                                                                    let _e2085 = phi_2604_;
                                                                    let _e2087 = phi_2605_;
                                                                    let _e2090 = ((_e2087 * _e2081) - (_e2085 * _e2083));
                                                                    if _e2079 {
                                                                        phi_2613_ = -(_e2090);
                                                                    } else {
                                                                        phi_2613_ = _e2090;
                                                                    }
                                                                    let _e2093 = phi_2613_;
                                                                    if (_e1995 < _e2021) {
                                                                        phi_2624_ = true;
                                                                    } else {
                                                                        if (_e1995 == _e2021) {
                                                                            phi_2623_ = (_e1999 < _e2025);
                                                                        } else {
                                                                            phi_2623_ = false;
                                                                        }
                                                                        let _e2098 = phi_2623_;
                                                                        phi_2624_ = _e2098;
                                                                    }
                                                                    let _e2100 = phi_2624_;
                                                                    if _e2100 {
                                                                        phi_2628_ = _e2025;
                                                                        phi_2629_ = _e2021;
                                                                        phi_2630_ = _e1999;
                                                                        phi_2631_ = _e1995;
                                                                    } else {
                                                                        phi_2628_ = _e1999;
                                                                        phi_2629_ = _e1995;
                                                                        phi_2630_ = _e2025;
                                                                        phi_2631_ = _e2021;
                                                                    }
                                                                    let _e2102 = phi_2628_;
                                                                    let _e2104 = phi_2629_;
                                                                    let _e2106 = phi_2630_;
                                                                    let _e2108 = phi_2631_;
                                                                    let _e2111 = ((_e2108 * _e2102) - (_e2106 * _e2104));
                                                                    if _e2100 {
                                                                        phi_2639_ = -(_e2111);
                                                                    } else {
                                                                        phi_2639_ = _e2111;
                                                                    }
                                                                    let _e2114 = phi_2639_;
                                                                    if (_e2072 >= 0f) {
                                                                        if (_e2093 >= 0f) {
                                                                            if (_e2114 >= 0f) {
                                                                                phi_2654_ = ((_e2072 + _e2093) + _e2114);
                                                                                phi_2655_ = false;
                                                                            } else {
                                                                                phi_2654_ = f32();
                                                                                phi_2655_ = true;
                                                                            }
                                                                            let _e2121 = phi_2654_;
                                                                            let _e2123 = phi_2655_;
                                                                            phi_2656_ = _e2121;
                                                                            phi_2657_ = _e2123;
                                                                        } else {
                                                                            phi_2656_ = f32();
                                                                            phi_2657_ = true;
                                                                        }
                                                                        let _e2125 = phi_2656_;
                                                                        let _e2127 = phi_2657_;
                                                                        phi_2658_ = _e2125;
                                                                        phi_2659_ = _e2127;
                                                                    } else {
                                                                        phi_2658_ = f32();
                                                                        phi_2659_ = true;
                                                                    }
                                                                    let _e2129 = phi_2658_;
                                                                    let _e2131 = phi_2659_;
                                                                    if _e2131 {
                                                                        if (_e2072 <= 0f) {
                                                                            if (_e2093 <= 0f) {
                                                                                let _e2134 = (_e2114 <= 0f);
                                                                                if _e2134 {
                                                                                }
                                                                                phi_2677_ = ((_e2072 + _e2093) + _e2114);
                                                                                phi_2678_ = false;
                                                                                phi_2679_ = _e2134;
                                                                            } else {
                                                                                phi_2677_ = f32();
                                                                                phi_2678_ = true;
                                                                                phi_2679_ = false;
                                                                            }
                                                                            let _e2138 = phi_2677_;
                                                                            let _e2140 = phi_2678_;
                                                                            let _e2142 = phi_2679_;
                                                                            phi_2680_ = _e2138;
                                                                            phi_2681_ = _e2140;
                                                                            phi_2682_ = _e2142;
                                                                        } else {
                                                                            phi_2680_ = f32();
                                                                            phi_2681_ = true;
                                                                            phi_2682_ = false;
                                                                        }
                                                                        let _e2144 = phi_2680_;
                                                                        let _e2146 = phi_2681_;
                                                                        let _e2148 = phi_2682_;
                                                                        if _e2146 {
                                                                            phi_2686_ = false;
                                                                        } else {
                                                                            phi_2686_ = _e2148;
                                                                        }
                                                                        let _e2150 = phi_2686_;
                                                                        phi_2687_ = _e2144;
                                                                        phi_2688_ = _e2150;
                                                                    } else {
                                                                        phi_2687_ = _e2129;
                                                                        phi_2688_ = true;
                                                                    }
                                                                    let _e2152 = phi_2687_;
                                                                    let _e2154 = phi_2688_;
                                                                    if _e2154 {
                                                                        let _e2155 = (_e2152 == 0f);
                                                                        if _e2155 {
                                                                            phi_3004_ = lt_bvh_triangle_Intersection();
                                                                            phi_3005_ = false;
                                                                        } else {
                                                                            let _e2157 = triangles.member[(0u + _e1968)].v0_;
                                                                            let _e2159 = (_e2157.x - _e1067);
                                                                            let _e2161 = (_e2157.y - _e1080);
                                                                            let _e2163 = (_e2157.z - _e1093);
                                                                            if (_e1353 == 0u) {
                                                                                phi_2717_ = vec3<f32>(_e2161, _e2163, _e2159);
                                                                            } else {
                                                                                if (_e1353 == 1u) {
                                                                                    phi_2716_ = vec3<f32>(_e2163, _e2159, _e2161);
                                                                                } else {
                                                                                    phi_2716_ = (_e2157 - vec3<f32>(_e1067, _e1080, _e1093));
                                                                                }
                                                                                let _e2171 = phi_2716_;
                                                                                phi_2717_ = _e2171;
                                                                            }
                                                                            let _e2173 = phi_2717_;
                                                                            let _e2175 = triangles.member[(0u + _e1968)].v1_;
                                                                            let _e2177 = triangles.member[(0u + _e1968)].v0_;
                                                                            let _e2180 = (_e2175.x - _e2177.x);
                                                                            let _e2183 = (_e2175.y - _e2177.y);
                                                                            let _e2186 = (_e2175.z - _e2177.z);
                                                                            if (_e1353 == 0u) {
                                                                                phi_2743_ = vec3<f32>(_e2183, _e2186, _e2180);
                                                                            } else {
                                                                                if (_e1353 == 1u) {
                                                                                    phi_2742_ = vec3<f32>(_e2186, _e2180, _e2183);
                                                                                } else {
                                                                                    phi_2742_ = (_e2175 - _e2177);
                                                                                }
                                                                                let _e2193 = phi_2742_;
                                                                                phi_2743_ = _e2193;
                                                                            }
                                                                            let _e2195 = phi_2743_;
                                                                            let _e2197 = triangles.member[(0u + _e1968)].v2_;
                                                                            let _e2199 = triangles.member[(0u + _e1968)].v0_;
                                                                            let _e2202 = (_e2197.x - _e2199.x);
                                                                            let _e2205 = (_e2197.y - _e2199.y);
                                                                            let _e2208 = (_e2197.z - _e2199.z);
                                                                            if (_e1353 == 0u) {
                                                                                phi_2769_ = vec3<f32>(_e2205, _e2208, _e2202);
                                                                            } else {
                                                                                if (_e1353 == 1u) {
                                                                                    phi_2768_ = vec3<f32>(_e2208, _e2202, _e2205);
                                                                                } else {
                                                                                    phi_2768_ = (_e2197 - _e2199);
                                                                                }
                                                                                let _e2215 = phi_2768_;
                                                                                phi_2769_ = _e2215;
                                                                            }
                                                                            let _e2217 = phi_2769_;
                                                                            let _e2224 = ((_e2195.y * _e2217.z) - (_e2195.z * _e2217.y));
                                                                            let _e2231 = ((_e2195.z * _e2217.x) - (_e2195.x * _e2217.z));
                                                                            let _e2238 = ((_e2195.x * _e2217.y) - (_e2195.y * _e2217.x));
                                                                            let _e2252 = (((1f / _e1361.z) * (((_e2224 * _e2173.x) + (_e2231 * _e2173.y)) + (_e2238 * _e2173.z))) / (((_e2224 * _e1364) + (_e2231 * _e1367)) + _e2238));
                                                                            if (_e2252 > _e157.tmin) {
                                                                                if (_e2252 < _e157.tmax) {
                                                                                    let _e2256 = triangles.member[(0u + _e1968)].v0_;
                                                                                    let _e2258 = triangles.member[(0u + _e1968)].v1_;
                                                                                    if (_e2256.x < _e2258.x) {
                                                                                        phi_2825_ = _e2256.x;
                                                                                    } else {
                                                                                        phi_2825_ = _e2258.x;
                                                                                    }
                                                                                    let _e2265 = phi_2825_;
                                                                                    if (_e2256.y < _e2258.y) {
                                                                                        phi_2834_ = _e2256.y;
                                                                                    } else {
                                                                                        phi_2834_ = _e2258.y;
                                                                                    }
                                                                                    let _e2272 = phi_2834_;
                                                                                    if (_e2256.z < _e2258.z) {
                                                                                        phi_2843_ = _e2256.z;
                                                                                    } else {
                                                                                        phi_2843_ = _e2258.z;
                                                                                    }
                                                                                    let _e2279 = phi_2843_;
                                                                                    let _e2281 = triangles.member[(0u + _e1968)].v2_;
                                                                                    if (_e2265 < _e2281.x) {
                                                                                        phi_2852_ = _e2265;
                                                                                    } else {
                                                                                        phi_2852_ = _e2281.x;
                                                                                    }
                                                                                    let _e2286 = phi_2852_;
                                                                                    if (_e2272 < _e2281.y) {
                                                                                        phi_2859_ = _e2272;
                                                                                    } else {
                                                                                        phi_2859_ = _e2281.y;
                                                                                    }
                                                                                    let _e2291 = phi_2859_;
                                                                                    if (_e2279 < _e2281.z) {
                                                                                        phi_2866_ = _e2279;
                                                                                    } else {
                                                                                        phi_2866_ = _e2281.z;
                                                                                    }
                                                                                    let _e2296 = phi_2866_;
                                                                                    let _e2298 = triangles.member[(0u + _e1968)].v0_;
                                                                                    let _e2300 = triangles.member[(0u + _e1968)].v1_;
                                                                                    if (_e2298.x > _e2300.x) {
                                                                                        phi_2879_ = _e2298.x;
                                                                                    } else {
                                                                                        phi_2879_ = _e2300.x;
                                                                                    }
                                                                                    let _e2307 = phi_2879_;
                                                                                    if (_e2298.y > _e2300.y) {
                                                                                        phi_2888_ = _e2298.y;
                                                                                    } else {
                                                                                        phi_2888_ = _e2300.y;
                                                                                    }
                                                                                    let _e2314 = phi_2888_;
                                                                                    if (_e2298.z > _e2300.z) {
                                                                                        phi_2897_ = _e2298.z;
                                                                                    } else {
                                                                                        phi_2897_ = _e2300.z;
                                                                                    }
                                                                                    let _e2321 = phi_2897_;
                                                                                    let _e2323 = triangles.member[(0u + _e1968)].v2_;
                                                                                    if (_e2307 > _e2323.x) {
                                                                                        phi_2906_ = _e2307;
                                                                                    } else {
                                                                                        phi_2906_ = _e2323.x;
                                                                                    }
                                                                                    let _e2328 = phi_2906_;
                                                                                    if (_e2314 > _e2323.y) {
                                                                                        phi_2913_ = _e2314;
                                                                                    } else {
                                                                                        phi_2913_ = _e2323.y;
                                                                                    }
                                                                                    let _e2333 = phi_2913_;
                                                                                    if (_e2321 > _e2323.z) {
                                                                                        phi_2920_ = _e2321;
                                                                                    } else {
                                                                                        phi_2920_ = _e2323.z;
                                                                                    }
                                                                                    let _e2338 = phi_2920_;
                                                                                    let _e2342 = ((_e2286 - _e1067) * _e1282);
                                                                                    let _e2343 = ((_e2291 - _e1080) * _e1292);
                                                                                    let _e2344 = ((_e2296 - _e1093) * _e1302);
                                                                                    let _e2348 = ((_e2328 - _e1067) * _e1282);
                                                                                    let _e2349 = ((_e2333 - _e1080) * _e1292);
                                                                                    let _e2350 = ((_e2338 - _e1093) * _e1302);
                                                                                    if (_e2342 < _e2348) {
                                                                                        phi_2937_ = _e2342;
                                                                                    } else {
                                                                                        phi_2937_ = _e2348;
                                                                                    }
                                                                                    let _e2353 = phi_2937_;
                                                                                    if (_e2343 < _e2349) {
                                                                                        phi_2942_ = _e2343;
                                                                                    } else {
                                                                                        phi_2942_ = _e2349;
                                                                                    }
                                                                                    let _e2356 = phi_2942_;
                                                                                    if (_e2344 < _e2350) {
                                                                                        phi_2947_ = _e2344;
                                                                                    } else {
                                                                                        phi_2947_ = _e2350;
                                                                                    }
                                                                                    let _e2359 = phi_2947_;
                                                                                    if (_e2342 > _e2348) {
                                                                                        phi_2955_ = _e2342;
                                                                                    } else {
                                                                                        phi_2955_ = _e2348;
                                                                                    }
                                                                                    let _e2365 = phi_2955_;
                                                                                    if (_e2343 > _e2349) {
                                                                                        phi_2960_ = _e2343;
                                                                                    } else {
                                                                                        phi_2960_ = _e2349;
                                                                                    }
                                                                                    let _e2368 = phi_2960_;
                                                                                    if (_e2344 > _e2350) {
                                                                                        phi_2965_ = _e2344;
                                                                                    } else {
                                                                                        phi_2965_ = _e2350;
                                                                                    }
                                                                                    let _e2371 = phi_2965_;
                                                                                    let _e2375 = core_intrinsics_maximum_number_nsz_f32_((_e2353 - _e1337), (_e2356 - _e1338));
                                                                                    let _e2376 = core_intrinsics_maximum_number_nsz_f32_(_e2375, (_e2359 - _e1339));
                                                                                    let _e2377 = core_intrinsics_minimum_number_nsz_f32_((_e2365 + _e1337), (_e2368 + _e1338));
                                                                                    let _e2378 = core_intrinsics_minimum_number_nsz_f32_(_e2377, (_e2371 + _e1339));
                                                                                    if (_e2376 > _e1042) {
                                                                                        phi_2977_ = _e2376;
                                                                                    } else {
                                                                                        phi_2977_ = _e1042;
                                                                                    }
                                                                                    let _e2381 = phi_2977_;
                                                                                    if (_e2378 < _e1044) {
                                                                                        phi_2982_ = _e2378;
                                                                                    } else {
                                                                                        phi_2982_ = _e1044;
                                                                                    }
                                                                                    let _e2384 = phi_2982_;
                                                                                    if (_e2252 < _e2381) {
                                                                                        phi_2987_ = _e2381;
                                                                                    } else {
                                                                                        phi_2987_ = _e2252;
                                                                                    }
                                                                                    let _e2387 = phi_2987_;
                                                                                    if (_e2387 > _e2384) {
                                                                                        phi_2992_ = _e2384;
                                                                                    } else {
                                                                                        phi_2992_ = _e2387;
                                                                                    }
                                                                                    let _e2390 = phi_2992_;
                                                                                    phi_2997_ = lt_bvh_triangle_Intersection(_e2390, (_e2093 / _e2152), (_e2114 / _e2152), (_e2381 <= _e2384));
                                                                                    phi_2998_ = false;
                                                                                } else {
                                                                                    phi_2997_ = lt_bvh_triangle_Intersection();
                                                                                    phi_2998_ = true;
                                                                                }
                                                                                let _e2396 = phi_2997_;
                                                                                let _e2398 = phi_2998_;
                                                                                phi_2999_ = _e2396;
                                                                                phi_3000_ = _e2398;
                                                                            } else {
                                                                                phi_2999_ = lt_bvh_triangle_Intersection();
                                                                                phi_3000_ = true;
                                                                            }
                                                                            let _e2400 = phi_2999_;
                                                                            let _e2402 = phi_3000_;
                                                                            if _e2402 {
                                                                            }
                                                                            phi_3004_ = _e2400;
                                                                            phi_3005_ = _e2402;
                                                                        }
                                                                        let _e2404 = phi_3004_;
                                                                        let _e2406 = phi_3005_;
                                                                        phi_3006_ = _e2404;
                                                                        phi_3007_ = _e2155;
                                                                        phi_3008_ = _e2406;
                                                                    } else {
                                                                        phi_3006_ = lt_bvh_triangle_Intersection();
                                                                        phi_3007_ = true;
                                                                        phi_3008_ = false;
                                                                    }
                                                                    let _e2408 = phi_3006_;
                                                                    let _e2410 = phi_3007_;
                                                                    let _e2412 = phi_3008_;
                                                                    if _e2410 {
                                                                        phi_3012_ = true;
                                                                    } else {
                                                                        phi_3012_ = _e2412;
                                                                    }
                                                                    let _e2414 = phi_3012_;
                                                                    if _e2414 {
                                                                        phi_3016_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_3016_ = _e2408;
                                                                    }
                                                                    let _e2416 = phi_3016_;
                                                                    if _e2416.is_hit {
                                                                        if (_e2416.t > _e157.tmin) {
                                                                            if (_e2416.t < _e1957.t) {
                                                                                phi_3064_ = true;
                                                                            } else {
                                                                                if (_e2416.t == _e1957.t) {
                                                                                    if (_e1957.triangle != 4294967295u) {
                                                                                        if (_e1968 < _e1957.triangle) {
                                                                                            phi_3055_ = true;
                                                                                        } else {
                                                                                            if (_e1968 == _e1957.triangle) {
                                                                                                phi_3054_ = (_e983 < _e1957.instance);
                                                                                            } else {
                                                                                                phi_3054_ = false;
                                                                                            }
                                                                                            let _e2434 = phi_3054_;
                                                                                            phi_3055_ = _e2434;
                                                                                        }
                                                                                        let _e2436 = phi_3055_;
                                                                                        phi_3056_ = _e2436;
                                                                                        phi_3057_ = false;
                                                                                    } else {
                                                                                        phi_3056_ = bool();
                                                                                        phi_3057_ = true;
                                                                                    }
                                                                                    let _e2438 = phi_3056_;
                                                                                    let _e2440 = phi_3057_;
                                                                                    phi_3058_ = _e2438;
                                                                                    phi_3059_ = _e2440;
                                                                                } else {
                                                                                    phi_3058_ = bool();
                                                                                    phi_3059_ = true;
                                                                                }
                                                                                let _e2442 = phi_3058_;
                                                                                let _e2444 = phi_3059_;
                                                                                if _e2444 {
                                                                                    phi_3063_ = false;
                                                                                } else {
                                                                                    phi_3063_ = _e2442;
                                                                                }
                                                                                let _e2446 = phi_3063_;
                                                                                phi_3064_ = _e2446;
                                                                            }
                                                                            let _e2448 = phi_3064_;
                                                                            if _e2448 {
                                                                                let _e2450 = triangles.member[(0u + _e1968)].i0_;
                                                                                if ((_e2450 & 2147483648u) == 0u) {
                                                                                    phi_3078_ = true;
                                                                                } else {
                                                                                    if true {
                                                                                    }
                                                                                    phi_3078_ = true;
                                                                                }
                                                                                let _e2454 = phi_3078_;
                                                                                if _e2454 {
                                                                                    phi_3086_ = lt_bvh_Hit(_e2416.t, _e2416.u, _e2416.v, _e1968, _e983);
                                                                                } else {
                                                                                    phi_3086_ = _e1957;
                                                                                }
                                                                                let _e2460 = phi_3086_;
                                                                                phi_3087_ = _e2460;
                                                                            } else {
                                                                                phi_3087_ = _e1957;
                                                                            }
                                                                            let _e2462 = phi_3087_;
                                                                            phi_3088_ = _e2462;
                                                                        } else {
                                                                            phi_3088_ = _e1957;
                                                                        }
                                                                        let _e2464 = phi_3088_;
                                                                        phi_3089_ = _e2464;
                                                                    } else {
                                                                        phi_3089_ = _e1957;
                                                                    }
                                                                    let _e2466 = phi_3089_;
                                                                    phi_2446_ = _e2466;
                                                                    phi_2449_ = (_e1959 & (_e1959 - 1u));
                                                                    phi_3090_ = true;
                                                                }
                                                                let _e2468 = phi_2446_;
                                                                let _e2470 = phi_2449_;
                                                                let _e2472 = phi_3090_;
                                                                continue;
                                                                continuing {
                                                                    phi_2445_ = _e2468;
                                                                    phi_2448_ = _e2470;
                                                                    break if !(_e2472);
                                                                }
                                                            }
                                                            let _e2475 = local_1.group_mask;
                                                            if ((_e2475 & 4278190080u) == 0u) {
                                                                let _e2479 = local_1.len;
                                                                if (_e2479 == 0u) {
                                                                    phi_3129_ = false;
                                                                } else {
                                                                    let _e2483 = local_1.len;
                                                                    local_1.len = (_e2483 - 1u);
                                                                    let _e2486 = local_1.len;
                                                                    if (_e2486 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2491 = local_1.first[(0u + _e2486)];
                                                                    local_1.group = _e2491;
                                                                    let _e2494 = local_1.len;
                                                                    if (_e2494 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2499 = local_1.mask[(0u + _e2494)];
                                                                    local_1.group_mask = _e2499;
                                                                    phi_3129_ = true;
                                                                }
                                                                let _e2502 = phi_3129_;
                                                                phi_3130_ = _e2502;
                                                            } else {
                                                                phi_3130_ = true;
                                                            }
                                                            let _e2504 = phi_3130_;
                                                            if _e2504 {
                                                                let _e2506 = local_1.group_mask;
                                                                let _e2512 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2506)), 32u, (_e2506 == 0u)));
                                                                let _e2516 = local_1.group_mask;
                                                                let _e2530 = local_1.group_mask;
                                                                local_1.group_mask = (_e2530 & ~((1u << bitcast<u32>((_e2512 & 31u)))));
                                                                let _e2533 = local_1.group;
                                                                phi_3161_ = (_e2533 + countOneBits(((_e2516 & ~((4294967295u << bitcast<u32>((((_e2512 - 24u) ^ _e1380) & 31u))))) & 255u)));
                                                            } else {
                                                                phi_3161_ = 4294967295u;
                                                            }
                                                            let _e2536 = phi_3161_;
                                                            let _e3666 = local_9;
                                                            phi_2113_ = _e3666;
                                                            phi_2116_ = _e2536;
                                                        } else {
                                                            phi_2113_ = lt_bvh_Hit();
                                                            phi_2116_ = u32();
                                                        }
                                                        let _e2538 = phi_2113_;
                                                        let _e2540 = phi_2116_;
                                                        continue;
                                                        continuing {
                                                            phi_2112_ = _e2538;
                                                            phi_2115_ = _e2540;
                                                            break if !(_e1521);
                                                        }
                                                    }
                                                    let _e3670 = local_10;
                                                    phi_3162_ = _e3670;
                                                }
                                                let _e2543 = phi_3162_;
                                                phi_3163_ = _e2543;
                                                phi_3164_ = _e1206;
                                            } else {
                                                phi_3163_ = lt_bvh_Hit();
                                                phi_3164_ = true;
                                            }
                                            let _e2545 = phi_3163_;
                                            let _e2547 = phi_3164_;
                                            if _e2547 {
                                                phi_3168_ = _e975;
                                            } else {
                                                phi_3168_ = _e2545;
                                            }
                                            let _e2549 = phi_3168_;
                                            phi_3169_ = _e2549;
                                        } else {
                                            phi_3169_ = _e975;
                                        }
                                        let _e2551 = phi_3169_;
                                        phi_3170_ = _e2551;
                                    } else {
                                        phi_3170_ = _e975;
                                    }
                                    let _e2553 = phi_3170_;
                                    phi_3171_ = _e2553;
                                } else {
                                    phi_3171_ = _e975;
                                }
                                let _e2555 = phi_3171_;
                                phi_1487_ = (_e973 & (_e973 - 1u));
                                phi_1490_ = _e2555;
                                phi_3172_ = true;
                            }
                            let _e2557 = phi_1487_;
                            let _e2559 = phi_1490_;
                            let _e2561 = phi_3172_;
                            continue;
                            continuing {
                                phi_1486_ = _e2557;
                                phi_1489_ = _e2559;
                                break if !(_e2561);
                            }
                        }
                        let _e2564 = local_2.group_mask;
                        if ((_e2564 & 4278190080u) == 0u) {
                            let _e2568 = local_2.len;
                            if (_e2568 == 0u) {
                                phi_3211_ = false;
                            } else {
                                let _e2572 = local_2.len;
                                local_2.len = (_e2572 - 1u);
                                let _e2575 = local_2.len;
                                if (_e2575 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2580 = local_2.first[(0u + _e2575)];
                                local_2.group = _e2580;
                                let _e2583 = local_2.len;
                                if (_e2583 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2588 = local_2.mask[(0u + _e2583)];
                                local_2.group_mask = _e2588;
                                phi_3211_ = true;
                            }
                            let _e2591 = phi_3211_;
                            phi_3212_ = _e2591;
                        } else {
                            phi_3212_ = true;
                        }
                        let _e2593 = phi_3212_;
                        if _e2593 {
                            let _e2595 = local_2.group_mask;
                            let _e2601 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2595)), 32u, (_e2595 == 0u)));
                            let _e2605 = local_2.group_mask;
                            let _e2619 = local_2.group_mask;
                            local_2.group_mask = (_e2619 & ~((1u << bitcast<u32>((_e2601 & 31u)))));
                            let _e2622 = local_2.group;
                            phi_3243_ = (_e2622 + countOneBits(((_e2605 & ~((4294967295u << bitcast<u32>((((_e2601 - 24u) ^ _e392) & 31u))))) & 255u)));
                        } else {
                            phi_3243_ = 4294967295u;
                        }
                        let _e2625 = phi_3243_;
                        phi_1150_ = _e2625;
                        let _e3686 = local_11;
                        phi_1153_ = _e3686;
                    } else {
                        phi_1150_ = u32();
                        phi_1153_ = lt_bvh_Hit();
                    }
                    let _e2627 = phi_1150_;
                    let _e2629 = phi_1153_;
                    continue;
                    continuing {
                        phi_1149_ = _e2627;
                        phi_1152_ = _e2629;
                        break if !(_e533);
                    }
                }
                let _e3689 = local_12;
                phi_3244_ = _e3689;
            }
            let _e2632 = phi_3244_;
            phi_3245_ = _e2632;
            phi_3246_ = _e229;
        } else {
            phi_3245_ = lt_bvh_Hit();
            phi_3246_ = true;
        }
        let _e2634 = phi_3245_;
        let _e2636 = phi_3246_;
        if _e2636 {
            phi_3250_ = _e159;
        } else {
            phi_3250_ = _e2634;
        }
        let _e2638 = phi_3250_;
        if (_e2638.triangle != 4294967295u) {
            let _e2644 = ((1f - _e2638.u) - _e2638.v);
            if (_e2638.triangle < _e79) {
            } else {
                return;
            }
            let _e2649 = triangles.member[(0u + _e2638.triangle)];
            if (_e2638.instance < _e91) {
            } else {
                return;
            }
            let _e2660 = instances.member[(0u + _e2638.instance)].object_to_world[0u];
            let _e2671 = ((((_e2660.x * _e2649.v0_.x) + (_e2660.y * _e2649.v0_.y)) + (_e2660.z * _e2649.v0_.z)) + (_e2660.w * 1f));
            let _e2673 = instances.member[(0u + _e2638.instance)].object_to_world[1u];
            let _e2684 = ((((_e2673.x * _e2649.v0_.x) + (_e2673.y * _e2649.v0_.y)) + (_e2673.z * _e2649.v0_.z)) + (_e2673.w * 1f));
            let _e2686 = instances.member[(0u + _e2638.instance)].object_to_world[2u];
            let _e2697 = ((((_e2686.x * _e2649.v0_.x) + (_e2686.y * _e2649.v0_.y)) + (_e2686.z * _e2649.v0_.z)) + (_e2686.w * 1f));
            let _e2704 = instances.member[(0u + _e2638.instance)].object_to_world[0u];
            let _e2715 = ((((_e2704.x * _e2649.v1_.x) + (_e2704.y * _e2649.v1_.y)) + (_e2704.z * _e2649.v1_.z)) + (_e2704.w * 1f));
            let _e2717 = instances.member[(0u + _e2638.instance)].object_to_world[1u];
            let _e2728 = ((((_e2717.x * _e2649.v1_.x) + (_e2717.y * _e2649.v1_.y)) + (_e2717.z * _e2649.v1_.z)) + (_e2717.w * 1f));
            let _e2730 = instances.member[(0u + _e2638.instance)].object_to_world[2u];
            let _e2741 = ((((_e2730.x * _e2649.v1_.x) + (_e2730.y * _e2649.v1_.y)) + (_e2730.z * _e2649.v1_.z)) + (_e2730.w * 1f));
            let _e2748 = instances.member[(0u + _e2638.instance)].object_to_world[0u];
            let _e2759 = ((((_e2748.x * _e2649.v2_.x) + (_e2748.y * _e2649.v2_.y)) + (_e2748.z * _e2649.v2_.z)) + (_e2748.w * 1f));
            let _e2761 = instances.member[(0u + _e2638.instance)].object_to_world[1u];
            let _e2772 = ((((_e2761.x * _e2649.v2_.x) + (_e2761.y * _e2649.v2_.y)) + (_e2761.z * _e2649.v2_.z)) + (_e2761.w * 1f));
            let _e2774 = instances.member[(0u + _e2638.instance)].object_to_world[2u];
            let _e2785 = ((((_e2774.x * _e2649.v2_.x) + (_e2774.y * _e2649.v2_.y)) + (_e2774.z * _e2649.v2_.z)) + (_e2774.w * 1f));
            let _e2798 = (((_e2671 * _e2644) + (_e2715 * _e2638.u)) + (_e2759 * _e2638.v));
            let _e2799 = (((_e2684 * _e2644) + (_e2728 * _e2638.u)) + (_e2772 * _e2638.v));
            let _e2800 = (((_e2697 * _e2644) + (_e2741 * _e2638.u)) + (_e2785 * _e2638.v));
            let _e2802 = abs(_e2671);
            let _e2803 = abs(_e2684);
            let _e2804 = abs(_e2697);
            let _e2805 = abs(_e2715);
            let _e2806 = abs(_e2728);
            let _e2807 = abs(_e2741);
            if (_e2802 > _e2805) {
                phi_3437_ = _e2802;
            } else {
                phi_3437_ = _e2805;
            }
            let _e2810 = phi_3437_;
            if (_e2803 > _e2806) {
                phi_3442_ = _e2803;
            } else {
                phi_3442_ = _e2806;
            }
            let _e2813 = phi_3442_;
            if (_e2804 > _e2807) {
                phi_3447_ = _e2804;
            } else {
                phi_3447_ = _e2807;
            }
            let _e2816 = phi_3447_;
            let _e2817 = abs(_e2759);
            let _e2818 = abs(_e2772);
            let _e2819 = abs(_e2785);
            if (_e2810 > _e2817) {
                phi_3455_ = _e2810;
            } else {
                phi_3455_ = _e2817;
            }
            let _e2822 = phi_3455_;
            if (_e2813 > _e2818) {
                phi_3460_ = _e2813;
            } else {
                phi_3460_ = _e2818;
            }
            let _e2825 = phi_3460_;
            if (_e2816 > _e2819) {
                phi_3465_ = _e2816;
            } else {
                phi_3465_ = _e2819;
            }
            let _e2828 = phi_3465_;
            let _e2829 = (_e2715 - _e2671);
            let _e2830 = (_e2728 - _e2684);
            let _e2831 = (_e2741 - _e2697);
            let _e2832 = (_e2759 - _e2671);
            let _e2833 = (_e2772 - _e2684);
            let _e2834 = (_e2785 - _e2697);
            let _e2838 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2830), abs(_e2831));
            let _e2839 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2829), _e2838);
            let _e2840 = (_e2829 / _e2839);
            let _e2841 = (_e2830 / _e2839);
            let _e2842 = (_e2831 / _e2839);
            let _e2846 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2833), abs(_e2834));
            let _e2847 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2832), _e2846);
            let _e2848 = (_e2832 / _e2847);
            let _e2849 = (_e2833 / _e2847);
            let _e2850 = (_e2834 / _e2847);
            let _e2853 = ((_e2841 * _e2850) - (_e2849 * _e2842));
            let _e2856 = ((_e2842 * _e2848) - (_e2850 * _e2840));
            let _e2859 = ((_e2840 * _e2849) - (_e2848 * _e2841));
            let _e2861 = p.member.eye;
            let _e2874 = (1f / sqrt((((_e2853 * _e2853) + (_e2856 * _e2856)) + (_e2859 * _e2859))));
            let _e2875 = (_e2853 * _e2874);
            let _e2876 = (_e2856 * _e2874);
            let _e2877 = (_e2859 * _e2874);
            if ((((_e2875 * (_e2861.x - _e2798)) + (_e2876 * (_e2861.y - _e2799))) + (_e2877 * (_e2861.z - _e2800))) < 0f) {
                phi_3529_ = vec3<f32>(-(_e2875), -(_e2876), -(_e2877));
            } else {
                phi_3529_ = vec3<f32>(_e2875, _e2876, _e2877);
            }
            let _e2890 = phi_3529_;
            if (_e2638.triangle < _e79) {
            } else {
                return;
            }
            let _e2895 = triangles.member[(0u + _e2638.triangle)];
            let _e2897 = (_e2895.i0_ & 2147483647u);
            if (_e2897 < _e82) {
            } else {
                return;
            }
            let _e2903 = vertices.member[(0u + _e2897)];
            if (_e2895.i1_ < _e82) {
            } else {
                return;
            }
            let _e2907 = vertices.member[(0u + _e2895.i1_)];
            if (_e2895.i2_ < _e82) {
            } else {
                return;
            }
            let _e2911 = vertices.member[(0u + _e2895.i2_)];
            let _e2912 = array<abi_Vertex, 3>(_e2903, _e2907, _e2911);
            if (_e2912[0].material < arrayLength((&materials.member))) {
            } else {
                return;
            }
            let _e2918 = materials.member[(0u + _e2912[0].material)];
            let _e2935 = (1f / 255f);
            let _e2954 = (1f / 255f);
            let _e2976 = (1f / 255f);
            if (_e2918.color_size == 0u) {
                phi_3772_ = vec3<f32>(1f, 1f, 1f);
            } else {
                local.offset = _e2918.color_offset;
                local.size = _e2918.color_size;
                local.flags = _e2918.flags;
                let _e3019 = _lt_shaders_texture_TextureView_quad((&local), (((_e2912[0].u * _e2644) + (_e2912[1].u * _e2638.u)) + (_e2912[2].u * _e2638.v)), (((_e2912[0].v * _e2644) + (_e2912[1].v * _e2638.u)) + (_e2912[2].v * _e2638.v)));
                if (_e3019.indices[0] < _e94) {
                } else {
                    return;
                }
                let _e3025 = color_texels.member[(0u + _e3019.indices[0])];
                let _e3036 = (1f / 255f);
                if (_e3019.indices[1] < _e94) {
                } else {
                    return;
                }
                let _e3050 = color_texels.member[(0u + _e3019.indices[1])];
                let _e3061 = (1f / 255f);
                if (_e3019.indices[2] < _e94) {
                } else {
                    return;
                }
                let _e3078 = color_texels.member[(0u + _e3019.indices[2])];
                let _e3089 = (1f / 255f);
                if (_e3019.indices[3] < _e94) {
                } else {
                    return;
                }
                let _e3106 = color_texels.member[(0u + _e3019.indices[3])];
                let _e3117 = (1f / 255f);
                let _e3126 = (((((f32((_e3025 & 255u)) * _e3036) * _e3019.weights.x) + ((f32((_e3050 & 255u)) * _e3061) * _e3019.weights.y)) + ((f32((_e3078 & 255u)) * _e3089) * _e3019.weights.z)) + ((f32((_e3106 & 255u)) * _e3117) * _e3019.weights.w));
                let _e3127 = (((((f32(((_e3025 >> bitcast<u32>(8i)) & 255u)) * _e3036) * _e3019.weights.x) + ((f32(((_e3050 >> bitcast<u32>(8i)) & 255u)) * _e3061) * _e3019.weights.y)) + ((f32(((_e3078 >> bitcast<u32>(8i)) & 255u)) * _e3089) * _e3019.weights.z)) + ((f32(((_e3106 >> bitcast<u32>(8i)) & 255u)) * _e3117) * _e3019.weights.w));
                let _e3128 = (((((f32(((_e3025 >> bitcast<u32>(16i)) & 255u)) * _e3036) * _e3019.weights.x) + ((f32(((_e3050 >> bitcast<u32>(16i)) & 255u)) * _e3061) * _e3019.weights.y)) + ((f32(((_e3078 >> bitcast<u32>(16i)) & 255u)) * _e3089) * _e3019.weights.z)) + ((f32(((_e3106 >> bitcast<u32>(16i)) & 255u)) * _e3117) * _e3019.weights.w));
                phi_3772_ = vec3<f32>((_e3126 * _e3126), (_e3127 * _e3127), (_e3128 * _e3128));
            }
            let _e3134 = phi_3772_;
            let _e3136 = ((_e2918.base_color.x * ((((f32((_e2912[0].color & 255u)) * _e2935) * _e2644) + ((f32((_e2912[1].color & 255u)) * _e2954) * _e2638.u)) + ((f32((_e2912[2].color & 255u)) * _e2976) * _e2638.v))) * _e3134.x);
            let _e3138 = ((_e2918.base_color.y * ((((f32(((_e2912[0].color >> bitcast<u32>(8i)) & 255u)) * _e2935) * _e2644) + ((f32(((_e2912[1].color >> bitcast<u32>(8i)) & 255u)) * _e2954) * _e2638.u)) + ((f32(((_e2912[2].color >> bitcast<u32>(8i)) & 255u)) * _e2976) * _e2638.v))) * _e3134.y);
            let _e3140 = ((_e2918.base_color.z * ((((f32(((_e2912[0].color >> bitcast<u32>(16i)) & 255u)) * _e2935) * _e2644) + ((f32(((_e2912[1].color >> bitcast<u32>(16i)) & 255u)) * _e2954) * _e2638.u)) + ((f32(((_e2912[2].color >> bitcast<u32>(16i)) & 255u)) * _e2976) * _e2638.v))) * _e3134.z);
            let _e3141 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e2825, _e2828);
            let _e3142 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e2822, _e3141);
            if ((_e2918.flags & 2u) == 0u) {
                phi_3787_ = 0u;
            } else {
                phi_3787_ = 1u;
            }
            let _e3147 = phi_3787_;
            if (_e2912[0].normal == 2147516416u) {
                phi_4017_ = _e2890;
            } else {
                let _e3160 = (f32((bitcast<i32>((_e2912[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3166 = (f32((bitcast<i32>(_e2912[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3170 = ((1f - abs(_e3160)) - abs(_e3166));
                if (_e3170 < 0f) {
                    phi_3814_ = -(_e3170);
                } else {
                    phi_3814_ = 0f;
                }
                let _e3174 = phi_3814_;
                if (_e3160 < 0f) {
                    phi_3821_ = (_e3160 + _e3174);
                } else {
                    phi_3821_ = (_e3160 - _e3174);
                }
                let _e3179 = phi_3821_;
                if (_e3166 < 0f) {
                    phi_3828_ = (_e3166 + _e3174);
                } else {
                    phi_3828_ = (_e3166 - _e3174);
                }
                let _e3184 = phi_3828_;
                let _e3191 = (1f / sqrt((((_e3179 * _e3179) + (_e3184 * _e3184)) + (_e3170 * _e3170))));
                let _e3207 = (f32((bitcast<i32>((_e2912[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3213 = (f32((bitcast<i32>(_e2912[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3217 = ((1f - abs(_e3207)) - abs(_e3213));
                if (_e3217 < 0f) {
                    phi_3863_ = -(_e3217);
                } else {
                    phi_3863_ = 0f;
                }
                let _e3221 = phi_3863_;
                if (_e3207 < 0f) {
                    phi_3870_ = (_e3207 + _e3221);
                } else {
                    phi_3870_ = (_e3207 - _e3221);
                }
                let _e3226 = phi_3870_;
                if (_e3213 < 0f) {
                    phi_3877_ = (_e3213 + _e3221);
                } else {
                    phi_3877_ = (_e3213 - _e3221);
                }
                let _e3231 = phi_3877_;
                let _e3238 = (1f / sqrt((((_e3226 * _e3226) + (_e3231 * _e3231)) + (_e3217 * _e3217))));
                let _e3257 = (f32((bitcast<i32>((_e2912[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3263 = (f32((bitcast<i32>(_e2912[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3267 = ((1f - abs(_e3257)) - abs(_e3263));
                if (_e3267 < 0f) {
                    phi_3915_ = -(_e3267);
                } else {
                    phi_3915_ = 0f;
                }
                let _e3271 = phi_3915_;
                if (_e3257 < 0f) {
                    phi_3922_ = (_e3257 + _e3271);
                } else {
                    phi_3922_ = (_e3257 - _e3271);
                }
                let _e3276 = phi_3922_;
                if (_e3263 < 0f) {
                    phi_3929_ = (_e3263 + _e3271);
                } else {
                    phi_3929_ = (_e3263 - _e3271);
                }
                let _e3281 = phi_3929_;
                let _e3288 = (1f / sqrt((((_e3276 * _e3276) + (_e3281 * _e3281)) + (_e3267 * _e3267))));
                let _e3295 = ((((_e3179 * _e3191) * _e2644) + ((_e3226 * _e3238) * _e2638.u)) + ((_e3276 * _e3288) * _e2638.v));
                let _e3296 = ((((_e3184 * _e3191) * _e2644) + ((_e3231 * _e3238) * _e2638.u)) + ((_e3281 * _e3288) * _e2638.v));
                let _e3297 = ((((_e3170 * _e3191) * _e2644) + ((_e3217 * _e3238) * _e2638.u)) + ((_e3267 * _e3288) * _e2638.v));
                if (_e2638.instance < _e91) {
                } else {
                    return;
                }
                let _e3304 = instances.member[(0u + _e2638.instance)].world_to_object[0u];
                let _e3313 = instances.member[(0u + _e2638.instance)].world_to_object[1u];
                let _e3325 = instances.member[(0u + _e2638.instance)].world_to_object[2u];
                let _e3332 = (((_e3304.x * _e3295) + (_e3313.x * _e3296)) + (_e3325.x * _e3297));
                let _e3333 = (((_e3304.y * _e3295) + (_e3313.y * _e3296)) + (_e3325.y * _e3297));
                let _e3334 = (((_e3304.z * _e3295) + (_e3313.z * _e3296)) + (_e3325.z * _e3297));
                let _e3340 = sqrt((((_e3332 * _e3332) + (_e3333 * _e3333)) + (_e3334 * _e3334)));
                if (_e3340 > 0f) {
                    let _e3342 = (_e3332 / _e3340);
                    let _e3343 = (_e3333 / _e3340);
                    let _e3344 = (_e3334 / _e3340);
                    if ((((_e3342 * _e2890.x) + (_e3343 * _e2890.y)) + (_e3344 * _e2890.z)) < 0f) {
                        phi_4015_ = vec3<f32>(-(_e3342), -(_e3343), -(_e3344));
                    } else {
                        phi_4015_ = vec3<f32>(_e3342, _e3343, _e3344);
                    }
                    let _e3360 = phi_4015_;
                    phi_4016_ = _e3360;
                } else {
                    phi_4016_ = _e2890;
                }
                let _e3362 = phi_4016_;
                phi_4017_ = _e3362;
            }
            let _e3364 = phi_4017_;
            if (_e3136 > 0f) {
                if (_e3136 < 1f) {
                    phi_4026_ = _e3136;
                } else {
                    phi_4026_ = 1f;
                }
                let _e3368 = phi_4026_;
                phi_4027_ = _e3368;
            } else {
                phi_4027_ = 0f;
            }
            let _e3370 = phi_4027_;
            if (_e3138 > 0f) {
                if (_e3138 < 1f) {
                    phi_4037_ = _e3138;
                } else {
                    phi_4037_ = 1f;
                }
                let _e3375 = phi_4037_;
                phi_4038_ = _e3375;
            } else {
                phi_4038_ = 0f;
            }
            let _e3377 = phi_4038_;
            if (_e3140 > 0f) {
                if (_e3140 < 1f) {
                    phi_4048_ = _e3140;
                } else {
                    phi_4048_ = 1f;
                }
                let _e3382 = phi_4048_;
                phi_4049_ = _e3382;
            } else {
                phi_4049_ = 0f;
            }
            let _e3384 = phi_4049_;
            let _e3387 = ((sqrt(_e3370) * 255f) + 0.5f);
            let _e3396 = ((sqrt(_e3377) * 255f) + 0.5f);
            let _e3408 = ((sqrt(_e3384) * 255f) + 0.5f);
            phi_4084_ = abi_Sample(vec3<f32>(_e2798, _e2799, _e2800), _e3142, _e2890, _e3147, _e3364, ((select(select(u32(_e3387), 0u, (_e3387 < bitcast<f32>(0u))), 4294967295u, (_e3387 > bitcast<f32>(1333788671u))) | (select(select(u32(_e3396), 0u, (_e3396 < bitcast<f32>(0u))), 4294967295u, (_e3396 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e3408), 0u, (_e3408 < bitcast<f32>(0u))), 4294967295u, (_e3408 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_4084_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e3422 = phi_4084_;
        if (_e100.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e100.shift)] = _e3422;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_instanced_color_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
