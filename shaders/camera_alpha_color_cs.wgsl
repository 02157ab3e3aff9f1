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

struct type_9 {
    member: array<u32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_20 {
    member: array<abi_Sample>,
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
    unnamed: lt_bvh_traverse_Tree,
    unnamed_1: lt_bvh_traverse_Tree,
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

struct type_51 {
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
var<uniform> p: type_51;
@group(0) @binding(1) 
var<storage> nodes: type_31;
@group(0) @binding(2) 
var<storage> triangles: type_35;
@group(0) @binding(5) 
var<storage, read_write> samples: type_20;
@group(0) @binding(6) 
var<storage> alpha_texels: type_9;
@group(0) @binding(7) 
var<storage> color_texels: type_9;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_216_: lt_bvh_traverse_Tree;
    var phi_217_: bool;
    var phi_218_: lt_bvh_traverse_Tree;
    var phi_219_: bool;
    var phi_224_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_216_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_217_ = false;
        } else {
            phi_216_ = lt_bvh_traverse_Tree();
            phi_217_ = true;
        }
        let _e84 = phi_216_;
        let _e86 = phi_217_;
        phi_218_ = _e84;
        phi_219_ = _e86;
    } else {
        phi_218_ = lt_bvh_traverse_Tree();
        phi_219_ = true;
    }
    let _e88 = phi_218_;
    let _e90 = phi_219_;
    if _e90 {
        phi_224_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_224_ = _e88;
    }
    let _e95 = phi_224_;
    return lt_bvh_traverse_Tree(_e95.root, _e95.first_primitive);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_239_: bool;
    var phi_243_: f32;

    if (param_3 != param_3) {
        phi_239_ = true;
    } else {
        let _e74 = (param_4 >= param_3);
        if _e74 {
        }
        phi_239_ = _e74;
    }
    let _e76 = phi_239_;
    if _e76 {
        phi_243_ = param_4;
    } else {
        phi_243_ = param_3;
    }
    let _e78 = phi_243_;
    return _e78;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_255_: bool;
    var phi_259_: f32;

    if (param_5 != param_5) {
        phi_255_ = true;
    } else {
        let _e74 = (param_6 <= param_5);
        if _e74 {
        }
        phi_255_ = _e74;
    }
    let _e76 = phi_255_;
    if _e76 {
        phi_259_ = param_6;
    } else {
        phi_259_ = param_5;
    }
    let _e78 = phi_259_;
    return _e78;
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
                phi_301_ = 1f;
            } else {
                phi_301_ = 0f;
            }
            let _e105 = phi_301_;
            if (param_8 < 8388608f) {
                phi_306_ = (_e102 - _e105);
                phi_307_ = false;
            } else {
                phi_306_ = f32();
                phi_307_ = true;
            }
            let _e108 = phi_306_;
            let _e110 = phi_307_;
            phi_308_ = _e108;
            phi_309_ = _e110;
        } else {
            phi_308_ = f32();
            phi_309_ = true;
        }
        let _e112 = phi_308_;
        let _e114 = phi_309_;
        if _e114 {
            phi_313_ = param_8;
        } else {
            phi_313_ = _e112;
        }
        let _e116 = phi_313_;
        phi_361_ = (param_8 - _e116);
    } else {
        if (_e89 == 1u) {
            let _e119 = (param_8 * 0.5f);
            if (_e119 > -8388608f) {
                let _e131 = f32(select(0i, select(select(i32(_e119), i32(-2147483648), (_e119 < bitcast<f32>(3472883712u))), 2147483647i, (_e119 > bitcast<f32>(1325400063u))), (_e119 == _e119)));
                if (_e131 > _e119) {
                    phi_339_ = 1f;
                } else {
                    phi_339_ = 0f;
                }
                let _e134 = phi_339_;
                if (_e119 < 8388608f) {
                    phi_344_ = (_e131 - _e134);
                    phi_345_ = false;
                } else {
                    phi_344_ = f32();
                    phi_345_ = true;
                }
                let _e137 = phi_344_;
                let _e139 = phi_345_;
                phi_346_ = _e137;
                phi_347_ = _e139;
            } else {
                phi_346_ = f32();
                phi_347_ = true;
            }
            let _e141 = phi_346_;
            let _e143 = phi_347_;
            if _e143 {
                phi_351_ = _e119;
            } else {
                phi_351_ = _e141;
            }
            let _e145 = phi_351_;
            let _e147 = (param_8 - (2f * _e145));
            if (_e147 > 1f) {
                phi_359_ = (2f - _e147);
            } else {
                phi_359_ = _e147;
            }
            let _e151 = phi_359_;
            phi_360_ = _e151;
        } else {
            phi_360_ = param_8;
        }
        let _e153 = phi_360_;
        phi_361_ = _e153;
    }
    let _e155 = phi_361_;
    if (_e155 > 0f) {
        if (_e155 < 1f) {
            phi_370_ = _e155;
        } else {
            phi_370_ = 1f;
        }
        let _e159 = phi_370_;
        phi_371_ = _e159;
    } else {
        phi_371_ = 0f;
    }
    let _e161 = phi_371_;
    let _e162 = (_e76 - 1u);
    let _e164 = (_e161 * f32(_e76));
    if _e84 {
        let _e171 = select(select(u32(_e164), 0u, (_e164 < bitcast<f32>(0u))), 4294967295u, (_e164 > bitcast<f32>(1333788671u)));
        if (_e162 < _e171) {
            phi_389_ = _e162;
        } else {
            phi_389_ = _e171;
        }
        let _e174 = phi_389_;
        phi_428_ = texture_Axis(_e174, _e174, 0f);
    } else {
        let _e176 = (_e164 + 0.5f);
        let _e183 = select(select(u32(_e176), 0u, (_e176 < bitcast<f32>(0u))), 4294967295u, (_e176 > bitcast<f32>(1333788671u)));
        if (_e76 < _e183) {
            phi_403_ = _e76;
        } else {
            phi_403_ = _e183;
        }
        let _e186 = phi_403_;
        if (_e89 == 0u) {
            phi_410_ = _e162;
        } else {
            phi_410_ = 0u;
        }
        let _e191 = phi_410_;
        if (_e89 == 0u) {
            phi_415_ = 0u;
        } else {
            phi_415_ = _e162;
        }
        let _e194 = phi_415_;
        if (_e186 == 0u) {
            phi_421_ = _e191;
        } else {
            phi_421_ = (_e186 - 1u);
        }
        let _e198 = phi_421_;
        if (_e186 > _e162) {
            phi_426_ = _e194;
        } else {
            phi_426_ = _e186;
        }
        let _e201 = phi_426_;
        phi_428_ = texture_Axis(_e198, _e201, (_e176 - f32(_e186)));
    }
    let _e204 = phi_428_;
    let _e206 = (*param_7).flags;
    let _e209 = ((_e206 >> bitcast<u32>(6u)) & 3u);
    if (_e209 == 0u) {
        if (param_9 > -8388608f) {
            let _e222 = f32(select(0i, select(select(i32(param_9), i32(-2147483648), (param_9 < bitcast<f32>(3472883712u))), 2147483647i, (param_9 > bitcast<f32>(1325400063u))), (param_9 == param_9)));
            if (_e222 > param_9) {
                phi_456_ = 1f;
            } else {
                phi_456_ = 0f;
            }
            let _e225 = phi_456_;
            if (param_9 < 8388608f) {
                phi_461_ = (_e222 - _e225);
                phi_462_ = false;
            } else {
                phi_461_ = f32();
                phi_462_ = true;
            }
            let _e228 = phi_461_;
            let _e230 = phi_462_;
            phi_463_ = _e228;
            phi_464_ = _e230;
        } else {
            phi_463_ = f32();
            phi_464_ = true;
        }
        let _e232 = phi_463_;
        let _e234 = phi_464_;
        if _e234 {
            phi_468_ = param_9;
        } else {
            phi_468_ = _e232;
        }
        let _e236 = phi_468_;
        phi_516_ = (param_9 - _e236);
    } else {
        if (_e209 == 1u) {
            let _e239 = (param_9 * 0.5f);
            if (_e239 > -8388608f) {
                let _e251 = f32(select(0i, select(select(i32(_e239), i32(-2147483648), (_e239 < bitcast<f32>(3472883712u))), 2147483647i, (_e239 > bitcast<f32>(1325400063u))), (_e239 == _e239)));
                if (_e251 > _e239) {
                    phi_494_ = 1f;
                } else {
                    phi_494_ = 0f;
                }
                let _e254 = phi_494_;
                if (_e239 < 8388608f) {
                    phi_499_ = (_e251 - _e254);
                    phi_500_ = false;
                } else {
                    phi_499_ = f32();
                    phi_500_ = true;
                }
                let _e257 = phi_499_;
                let _e259 = phi_500_;
                phi_501_ = _e257;
                phi_502_ = _e259;
            } else {
                phi_501_ = f32();
                phi_502_ = true;
            }
            let _e261 = phi_501_;
            let _e263 = phi_502_;
            if _e263 {
                phi_506_ = _e239;
            } else {
                phi_506_ = _e261;
            }
            let _e265 = phi_506_;
            let _e267 = (param_9 - (2f * _e265));
            if (_e267 > 1f) {
                phi_514_ = (2f - _e267);
            } else {
                phi_514_ = _e267;
            }
            let _e271 = phi_514_;
            phi_515_ = _e271;
        } else {
            phi_515_ = param_9;
        }
        let _e273 = phi_515_;
        phi_516_ = _e273;
    }
    let _e275 = phi_516_;
    if (_e275 > 0f) {
        if (_e275 < 1f) {
            phi_525_ = _e275;
        } else {
            phi_525_ = 1f;
        }
        let _e279 = phi_525_;
        phi_526_ = _e279;
    } else {
        phi_526_ = 0f;
    }
    let _e281 = phi_526_;
    let _e282 = (_e80 - 1u);
    let _e284 = (_e281 * f32(_e80));
    if _e84 {
        let _e291 = select(select(u32(_e284), 0u, (_e284 < bitcast<f32>(0u))), 4294967295u, (_e284 > bitcast<f32>(1333788671u)));
        if (_e282 < _e291) {
            phi_544_ = _e282;
        } else {
            phi_544_ = _e291;
        }
        let _e294 = phi_544_;
        phi_583_ = texture_Axis(_e294, _e294, 0f);
    } else {
        let _e296 = (_e284 + 0.5f);
        let _e303 = select(select(u32(_e296), 0u, (_e296 < bitcast<f32>(0u))), 4294967295u, (_e296 > bitcast<f32>(1333788671u)));
        if (_e80 < _e303) {
            phi_558_ = _e80;
        } else {
            phi_558_ = _e303;
        }
        let _e306 = phi_558_;
        if (_e209 == 0u) {
            phi_565_ = _e282;
        } else {
            phi_565_ = 0u;
        }
        let _e311 = phi_565_;
        if (_e209 == 0u) {
            phi_570_ = 0u;
        } else {
            phi_570_ = _e282;
        }
        let _e314 = phi_570_;
        if (_e306 == 0u) {
            phi_576_ = _e311;
        } else {
            phi_576_ = (_e306 - 1u);
        }
        let _e318 = phi_576_;
        if (_e306 > _e282) {
            phi_581_ = _e314;
        } else {
            phi_581_ = _e306;
        }
        let _e321 = phi_581_;
        phi_583_ = texture_Axis(_e318, _e321, (_e296 - f32(_e306)));
    }
    let _e324 = phi_583_;
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
    var phi_642_: f32;

    if (param_12 > param_13) {
        phi_642_ = param_12;
    } else {
        phi_642_ = param_13;
    }
    let _e75 = phi_642_;
    return _e75;
}

fn _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(param_14: vec3<f32>) -> vec3<f32> {
    return param_14;
}

fn function_() {
    var local: texture_TextureView;
    var local_1: texture_TextureView;
    var local_2: lt_bvh_traverse_Stack;
    var phi_788_: bool;
    var phi_789_: bool;
    var phi_790_: bool;
    var phi_791_: bool;
    var phi_795_: bool;
    var phi_808_: bool;
    var phi_809_: bool;
    var phi_810_: bool;
    var phi_811_: bool;
    var phi_815_: bool;
    var phi_828_: bool;
    var phi_829_: bool;
    var phi_830_: bool;
    var phi_834_: bool;
    var phi_835_: bool;
    var phi_836_: bool;
    var phi_837_: bool;
    var phi_838_: bool;
    var phi_842_: bool;
    var phi_918_: f32;
    var phi_925_: f32;
    var phi_933_: f32;
    var phi_940_: f32;
    var phi_948_: f32;
    var phi_955_: f32;
    var phi_978_: f32;
    var phi_983_: f32;
    var phi_988_: f32;
    var phi_993_: f32;
    var phi_998_: f32;
    var phi_1029_: bool;
    var phi_1030_: bool;
    var phi_1038_: u32;
    var phi_1039_: u32;
    var phi_1056_: vec3<f32>;
    var phi_1057_: vec3<f32>;
    var phi_1070_: u32;
    var phi_1075_: u32;
    var phi_1080_: u32;
    var phi_1194_: bool;
    var phi_1195_: bool;
    var phi_1226_: u32;
    var phi_1228_: lt_bvh_Hit;
    var phi_1231_: u32;
    var phi_1316_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1343_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1370_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1376_: u32;
    var phi_1379_: u32;
    var phi_1393_: u32;
    var phi_1403_: u32;
    var phi_1413_: u32;
    var phi_1431_: u32;
    var phi_1441_: u32;
    var phi_1451_: u32;
    var phi_1487_: u32;
    var phi_1500_: u32;
    var phi_1505_: u32;
    var phi_1506_: u32;
    var phi_1507_: u32;
    var phi_1377_: u32;
    var phi_1380_: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_1565_: lt_bvh_Hit;
    var phi_1568_: u32;
    var phi_1614_: vec3<f32>;
    var phi_1615_: vec3<f32>;
    var phi_1646_: vec3<f32>;
    var phi_1647_: vec3<f32>;
    var phi_1678_: vec3<f32>;
    var phi_1679_: vec3<f32>;
    var phi_1697_: bool;
    var phi_1698_: bool;
    var phi_1702_: f32;
    var phi_1703_: f32;
    var phi_1704_: f32;
    var phi_1705_: f32;
    var phi_1713_: f32;
    var phi_1723_: bool;
    var phi_1724_: bool;
    var phi_1728_: f32;
    var phi_1729_: f32;
    var phi_1730_: f32;
    var phi_1731_: f32;
    var phi_1739_: f32;
    var phi_1749_: bool;
    var phi_1750_: bool;
    var phi_1754_: f32;
    var phi_1755_: f32;
    var phi_1756_: f32;
    var phi_1757_: f32;
    var phi_1765_: f32;
    var phi_1780_: f32;
    var phi_1781_: bool;
    var phi_1782_: f32;
    var phi_1783_: bool;
    var phi_1784_: f32;
    var phi_1785_: bool;
    var phi_1803_: f32;
    var phi_1804_: bool;
    var phi_1805_: bool;
    var phi_1806_: f32;
    var phi_1807_: bool;
    var phi_1808_: bool;
    var phi_1812_: bool;
    var phi_1813_: f32;
    var phi_1814_: bool;
    var phi_1844_: vec3<f32>;
    var phi_1845_: vec3<f32>;
    var phi_1870_: vec3<f32>;
    var phi_1871_: vec3<f32>;
    var phi_1896_: vec3<f32>;
    var phi_1897_: vec3<f32>;
    var phi_1955_: f32;
    var phi_1964_: f32;
    var phi_1973_: f32;
    var phi_1982_: f32;
    var phi_1989_: f32;
    var phi_1996_: f32;
    var phi_2009_: f32;
    var phi_2018_: f32;
    var phi_2027_: f32;
    var phi_2036_: f32;
    var phi_2043_: f32;
    var phi_2050_: f32;
    var phi_2073_: f32;
    var phi_2078_: f32;
    var phi_2083_: f32;
    var phi_2091_: f32;
    var phi_2096_: f32;
    var phi_2101_: f32;
    var phi_2113_: f32;
    var phi_2118_: f32;
    var phi_2123_: f32;
    var phi_2128_: f32;
    var phi_2133_: lt_bvh_triangle_Intersection;
    var phi_2134_: bool;
    var phi_2135_: lt_bvh_triangle_Intersection;
    var phi_2136_: bool;
    var phi_2140_: lt_bvh_triangle_Intersection;
    var phi_2141_: bool;
    var phi_2142_: lt_bvh_triangle_Intersection;
    var phi_2143_: bool;
    var phi_2144_: bool;
    var phi_2148_: bool;
    var phi_2152_: lt_bvh_triangle_Intersection;
    var phi_2191_: bool;
    var phi_2192_: bool;
    var phi_2193_: bool;
    var phi_2194_: bool;
    var phi_2195_: bool;
    var phi_2196_: bool;
    var phi_2200_: bool;
    var phi_2201_: bool;
    var phi_2404_: f32;
    var phi_2407_: bool;
    var phi_2408_: bool;
    var phi_2412_: bool;
    var phi_2420_: lt_bvh_Hit;
    var phi_2421_: lt_bvh_Hit;
    var phi_2422_: lt_bvh_Hit;
    var phi_2423_: lt_bvh_Hit;
    var phi_1566_: lt_bvh_Hit;
    var phi_1569_: u32;
    var phi_2424_: bool;
    var phi_2463_: bool;
    var phi_2464_: bool;
    var phi_2495_: u32;
    var phi_1229_: lt_bvh_Hit;
    var phi_1232_: u32;
    var phi_2496_: lt_bvh_Hit;
    var phi_2497_: lt_bvh_Hit;
    var phi_2498_: bool;
    var phi_2502_: lt_bvh_Hit;
    var phi_2566_: f32;
    var phi_2571_: f32;
    var phi_2576_: f32;
    var phi_2587_: f32;
    var phi_2592_: f32;
    var phi_2597_: f32;
    var phi_2673_: vec3<f32>;
    var phi_2916_: vec3<f32>;
    var phi_2931_: u32;
    var phi_2958_: f32;
    var phi_2965_: f32;
    var phi_2972_: f32;
    var phi_3007_: f32;
    var phi_3014_: f32;
    var phi_3021_: f32;
    var phi_3059_: f32;
    var phi_3066_: f32;
    var phi_3073_: f32;
    var phi_3132_: vec3<f32>;
    var phi_3133_: vec3<f32>;
    var phi_3134_: vec3<f32>;
    var phi_3143_: f32;
    var phi_3144_: f32;
    var phi_3154_: f32;
    var phi_3155_: f32;
    var phi_3165_: f32;
    var phi_3166_: f32;
    var phi_3201_: abi_Sample;
    var local_6: lt_bvh_Hit;
    var local_7: lt_bvh_Hit;

    let _e74 = id_1;
    let _e78 = arrayLength((&nodes.member));
    let _e81 = arrayLength((&triangles.member));
    let _e84 = arrayLength((&vertices.member));
    let _e87 = arrayLength((&materials.member));
    let _e93 = arrayLength((&alpha_texels.member));
    let _e96 = arrayLength((&color_texels.member));
    let _e99 = p.member.size[0u];
    let _e101 = p.member.size[1u];
    let _e102 = lt_shaders_entry_pixel_index(_e74, _e99, _e101);
    if (bitcast<i32>(_e102.root) != 0i) {
        let _e110 = p.member.eye;
        let _e113 = p.member.grid[0u];
        let _e115 = p.member.grid[1u];
        let _e134 = p.member.size[0u];
        let _e138 = ((((f32(_e74.x) + ((f32((_e74.y & (_e115 - 1u))) + 0.5f) / f32(_e115))) / f32(_e134)) * 2f) - 1f);
        let _e141 = p.member.size[1u];
        let _e145 = (1f - (((f32(_e74.y) + ((f32((_e74.x & (_e113 - 1u))) + 0.5f) / f32(_e113))) / f32(_e141)) * 2f));
        let _e147 = p.member.forward;
        let _e149 = p.member.right;
        let _e163 = p.member.up;
        let _e174 = _lt_bvh_ray_Ray_new(_e110, vec3<f32>(((_e147.x + (_e149.x * _e138)) + (_e163.x * _e145)), ((_e147.y + (_e149.y * _e138)) + (_e163.y * _e145)), ((_e147.z + (_e149.z * _e138)) + (_e163.z * _e145))));
        let _e176 = lt_bvh_Hit(_e174.tmax, 0f, 0f, 4294967295u, 4294967295u);
        let _e179 = abs(_e174.direction.x);
        let _e181 = abs(_e174.direction.y);
        let _e183 = abs(_e174.direction.z);
        if (abs(_e174.origin.x) < 1000000000000000f) {
            if (abs(_e174.origin.y) < 1000000000000000f) {
                phi_788_ = (abs(_e174.origin.z) < 1000000000000000f);
                phi_789_ = false;
            } else {
                phi_788_ = bool();
                phi_789_ = true;
            }
            let _e195 = phi_788_;
            let _e197 = phi_789_;
            phi_790_ = _e195;
            phi_791_ = _e197;
        } else {
            phi_790_ = bool();
            phi_791_ = true;
        }
        let _e199 = phi_790_;
        let _e201 = phi_791_;
        if _e201 {
            phi_795_ = false;
        } else {
            phi_795_ = _e199;
        }
        let _e203 = phi_795_;
        if _e203 {
            if (_e179 < 1000000000000000f) {
                if (_e181 < 1000000000000000f) {
                    phi_808_ = (_e183 < 1000000000000000f);
                    phi_809_ = false;
                } else {
                    phi_808_ = bool();
                    phi_809_ = true;
                }
                let _e208 = phi_808_;
                let _e210 = phi_809_;
                phi_810_ = _e208;
                phi_811_ = _e210;
            } else {
                phi_810_ = bool();
                phi_811_ = true;
            }
            let _e212 = phi_810_;
            let _e214 = phi_811_;
            if _e214 {
                phi_815_ = false;
            } else {
                phi_815_ = _e212;
            }
            let _e216 = phi_815_;
            if _e216 {
                if (_e179 > 0f) {
                    phi_829_ = bool();
                    phi_830_ = true;
                } else {
                    let _e218 = (_e181 > 0f);
                    if _e218 {
                        phi_828_ = bool();
                    } else {
                        phi_828_ = (_e183 > 0f);
                    }
                    let _e221 = phi_828_;
                    phi_829_ = _e221;
                    phi_830_ = _e218;
                }
                let _e223 = phi_829_;
                let _e225 = phi_830_;
                if _e225 {
                    phi_834_ = true;
                } else {
                    phi_834_ = _e223;
                }
                let _e227 = phi_834_;
                phi_835_ = _e227;
                phi_836_ = false;
            } else {
                phi_835_ = bool();
                phi_836_ = true;
            }
            let _e229 = phi_835_;
            let _e231 = phi_836_;
            phi_837_ = _e229;
            phi_838_ = _e231;
        } else {
            phi_837_ = bool();
            phi_838_ = true;
        }
        let _e233 = phi_837_;
        let _e235 = phi_838_;
        if _e235 {
            phi_842_ = false;
        } else {
            phi_842_ = _e233;
        }
        let _e237 = phi_842_;
        if _e237 {
            let _e238 = (0u >= _e78);
            if _e238 {
                phi_2496_ = lt_bvh_Hit();
            } else {
                if (0u < _e78) {
                } else {
                    return;
                }
                let _e244 = nodes.member[(0u + 0u)].frame[0u];
                let _e248 = nodes.member[(0u + 0u)].frame[1u];
                let _e252 = nodes.member[(0u + 0u)].frame[2u];
                let _e256 = nodes.member[(0u + 0u)].frame[0u];
                let _e260 = nodes.member[(0u + 0u)].frame[1u];
                let _e264 = nodes.member[(0u + 0u)].frame[2u];
                let _e268 = nodes.member[(0u + 0u)].frame[3u];
                let _e307 = core_intrinsics_maximum_number_nsz_f32_(abs(_e174.direction.x), abs(_e174.direction.y));
                let _e308 = core_intrinsics_maximum_number_nsz_f32_(_e307, abs(_e174.direction.z));
                let _e309 = (_e308 * 0.0000000000009094947f);
                if (abs(_e174.direction.x) < _e309) {
                    phi_918_ = _e309;
                } else {
                    phi_918_ = abs(_e174.direction.x);
                }
                let _e315 = phi_918_;
                if (_e174.direction.x < 0f) {
                    phi_925_ = (-1f / _e315);
                } else {
                    phi_925_ = (1f / _e315);
                }
                let _e320 = phi_925_;
                if (abs(_e174.direction.y) < _e309) {
                    phi_933_ = _e309;
                } else {
                    phi_933_ = abs(_e174.direction.y);
                }
                let _e326 = phi_933_;
                if (_e174.direction.y < 0f) {
                    phi_940_ = (-1f / _e326);
                } else {
                    phi_940_ = (1f / _e326);
                }
                let _e331 = phi_940_;
                if (abs(_e174.direction.z) < _e309) {
                    phi_948_ = _e309;
                } else {
                    phi_948_ = abs(_e174.direction.z);
                }
                let _e337 = phi_948_;
                if (_e174.direction.z < 0f) {
                    phi_955_ = (-1f / _e337);
                } else {
                    phi_955_ = (1f / _e337);
                }
                let _e342 = phi_955_;
                let _e349 = abs((bitcast<f32>(_e244) - _e174.origin.x));
                let _e350 = abs((bitcast<f32>(_e248) - _e174.origin.y));
                let _e351 = abs((bitcast<f32>(_e252) - _e174.origin.z));
                let _e358 = abs(((bitcast<f32>(_e256) + (bitcast<f32>((((_e268 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e174.origin.x));
                let _e359 = abs(((bitcast<f32>(_e260) + (bitcast<f32>((((_e268 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e174.origin.y));
                let _e360 = abs(((bitcast<f32>(_e264) + (bitcast<f32>((((_e268 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e174.origin.z));
                if (_e349 > _e358) {
                    phi_978_ = _e349;
                } else {
                    phi_978_ = _e358;
                }
                let _e363 = phi_978_;
                if (_e350 > _e359) {
                    phi_983_ = _e350;
                } else {
                    phi_983_ = _e359;
                }
                let _e366 = phi_983_;
                if (_e351 > _e360) {
                    phi_988_ = _e351;
                } else {
                    phi_988_ = _e360;
                }
                let _e369 = phi_988_;
                if (_e363 > _e366) {
                    phi_993_ = _e363;
                } else {
                    phi_993_ = _e366;
                }
                let _e372 = phi_993_;
                if (_e372 > _e369) {
                    phi_998_ = _e372;
                } else {
                    phi_998_ = _e369;
                }
                let _e375 = phi_998_;
                let _e379 = (_e375 * 0.0000019073486f);
                let _e380 = (abs(_e320) * _e379);
                let _e381 = (abs(_e331) * _e379);
                let _e382 = (abs(_e342) * _e379);
                let _e386 = (_e375 * 0.0000009536743f);
                let _e387 = (abs(_e320) * _e386);
                let _e388 = (abs(_e331) * _e386);
                let _e389 = (abs(_e342) * _e386);
                let _e393 = abs(_e174.direction.x);
                let _e395 = abs(_e174.direction.y);
                let _e397 = abs(_e174.direction.z);
                if (_e393 >= _e395) {
                    if (_e393 >= _e397) {
                        phi_1029_ = false;
                    } else {
                        phi_1029_ = true;
                    }
                    let _e401 = phi_1029_;
                    phi_1030_ = _e401;
                } else {
                    phi_1030_ = true;
                }
                let _e403 = phi_1030_;
                if _e403 {
                    if (_e395 >= _e397) {
                        phi_1038_ = 1u;
                    } else {
                        phi_1038_ = 2u;
                    }
                    let _e406 = phi_1038_;
                    phi_1039_ = _e406;
                } else {
                    phi_1039_ = 0u;
                }
                let _e408 = phi_1039_;
                if (_e408 == 0u) {
                    phi_1057_ = vec3<f32>(_e174.direction.y, _e174.direction.z, _e174.direction.x);
                } else {
                    if (_e408 == 1u) {
                        phi_1056_ = vec3<f32>(_e174.direction.z, _e174.direction.x, _e174.direction.y);
                    } else {
                        phi_1056_ = _e174.direction;
                    }
                    let _e420 = phi_1056_;
                    phi_1057_ = _e420;
                }
                let _e422 = phi_1057_;
                let _e425 = (_e422.x / _e422.z);
                let _e428 = (_e422.y / _e422.z);
                if (_e320 < 0f) {
                    phi_1070_ = 0u;
                } else {
                    phi_1070_ = 1u;
                }
                let _e433 = phi_1070_;
                if (_e331 < 0f) {
                    phi_1075_ = 0u;
                } else {
                    phi_1075_ = 2u;
                }
                let _e436 = phi_1075_;
                if (_e342 < 0f) {
                    phi_1080_ = 0u;
                } else {
                    phi_1080_ = 4u;
                }
                let _e439 = phi_1080_;
                let _e441 = ((_e433 | _e436) | _e439);
                let _e442 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e442.first[0], _e442.first[1], _e442.first[2], _e442.first[3], _e442.first[4], _e442.first[5], _e442.first[6], _e442.first[7], _e442.first[8], _e442.first[9], _e442.first[10], _e442.first[11], _e442.first[12], _e442.first[13], _e442.first[14], _e442.first[15], _e442.first[16], _e442.first[17], _e442.first[18], _e442.first[19], _e442.first[20], _e442.first[21], _e442.first[22], _e442.first[23], _e442.first[24], _e442.first[25], _e442.first[26], _e442.first[27], _e442.first[28], _e442.first[29], _e442.first[30], _e442.first[31]), array<u32, 32>(_e442.mask[0], _e442.mask[1], _e442.mask[2], _e442.mask[3], _e442.mask[4], _e442.mask[5], _e442.mask[6], _e442.mask[7], _e442.mask[8], _e442.mask[9], _e442.mask[10], _e442.mask[11], _e442.mask[12], _e442.mask[13], _e442.mask[14], _e442.mask[15], _e442.mask[16], _e442.mask[17], _e442.mask[18], _e442.mask[19], _e442.mask[20], _e442.mask[21], _e442.mask[22], _e442.mask[23], _e442.mask[24], _e442.mask[25], _e442.mask[26], _e442.mask[27], _e442.mask[28], _e442.mask[29], _e442.mask[30], _e442.mask[31]), _e442.len, _e442.group, _e442.group_mask);
                let _e516 = local_2.group_mask;
                if ((_e516 & 4278190080u) == 0u) {
                    let _e520 = local_2.len;
                    if (_e520 == 0u) {
                        phi_1194_ = false;
                    } else {
                        let _e524 = local_2.len;
                        local_2.len = (_e524 - 1u);
                        let _e527 = local_2.len;
                        if (_e527 < 32u) {
                        } else {
                            return;
                        }
                        let _e532 = local_2.first[(0u + _e527)];
                        local_2.group = _e532;
                        let _e535 = local_2.len;
                        if (_e535 < 32u) {
                        } else {
                            return;
                        }
                        let _e540 = local_2.mask[(0u + _e535)];
                        local_2.group_mask = _e540;
                        phi_1194_ = true;
                    }
                    let _e543 = phi_1194_;
                    phi_1195_ = _e543;
                } else {
                    phi_1195_ = true;
                }
                let _e545 = phi_1195_;
                if _e545 {
                    let _e547 = local_2.group_mask;
                    let _e553 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e547)), 32u, (_e547 == 0u)));
                    let _e557 = local_2.group_mask;
                    let _e571 = local_2.group_mask;
                    local_2.group_mask = (_e571 & ~((1u << bitcast<u32>((_e553 & 31u)))));
                    let _e574 = local_2.group;
                    phi_1226_ = (_e574 + countOneBits(((_e557 & ~((4294967295u << bitcast<u32>((((_e553 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1226_ = 4294967295u;
                }
                let _e577 = phi_1226_;
                phi_1228_ = _e176;
                phi_1231_ = _e577;
                loop {
                    let _e579 = phi_1228_;
                    let _e581 = phi_1231_;
                    local_7 = _e579;
                    let _e582 = (_e581 != 4294967295u);
                    if _e582 {
                        if (_e581 < _e78) {
                        } else {
                            return;
                        }
                        let _e590 = nodes.member[(0u + _e581)].frame[3u];
                        let _e615 = (bitcast<f32>((((_e590 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e320);
                        let _e616 = (bitcast<f32>((((_e590 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e331);
                        let _e617 = (bitcast<f32>((((_e590 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e342);
                        let _e620 = nodes.member[(0u + _e581)].frame[0u];
                        let _e624 = nodes.member[(0u + _e581)].frame[1u];
                        let _e628 = nodes.member[(0u + _e581)].frame[2u];
                        let _e636 = ((bitcast<f32>(_e620) - _e174.origin.x) * _e320);
                        let _e637 = ((bitcast<f32>(_e624) - _e174.origin.y) * _e331);
                        let _e638 = ((bitcast<f32>(_e628) - _e174.origin.z) * _e342);
                        let _e646 = nodes.member[(0u + _e581)].x;
                        if (_e320 < 0f) {
                            let _e657 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e646.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e663 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e657.unnamed.root, _e646.w), _e657.unnamed_1);
                            let _e669 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e663.unnamed, lt_bvh_traverse_Tree(_e646.x, _e663.unnamed_1.first_primitive));
                            phi_1316_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e669.unnamed, lt_bvh_traverse_Tree(_e669.unnamed_1.root, _e646.y));
                        } else {
                            let _e685 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e646.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e691 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e685.unnamed.root, _e646.y), _e685.unnamed_1);
                            let _e697 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e691.unnamed, lt_bvh_traverse_Tree(_e646.z, _e691.unnamed_1.first_primitive));
                            phi_1316_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e697.unnamed, lt_bvh_traverse_Tree(_e697.unnamed_1.root, _e646.w));
                        }
                        let _e705 = phi_1316_;
                        let _e715 = nodes.member[(0u + _e581)].y;
                        if (_e331 < 0f) {
                            let _e726 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e715.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e732 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e726.unnamed.root, _e715.w), _e726.unnamed_1);
                            let _e738 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e732.unnamed, lt_bvh_traverse_Tree(_e715.x, _e732.unnamed_1.first_primitive));
                            phi_1343_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e738.unnamed, lt_bvh_traverse_Tree(_e738.unnamed_1.root, _e715.y));
                        } else {
                            let _e754 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e715.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e760 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e754.unnamed.root, _e715.y), _e754.unnamed_1);
                            let _e766 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e760.unnamed, lt_bvh_traverse_Tree(_e715.z, _e760.unnamed_1.first_primitive));
                            phi_1343_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e766.unnamed, lt_bvh_traverse_Tree(_e766.unnamed_1.root, _e715.w));
                        }
                        let _e774 = phi_1343_;
                        let _e784 = nodes.member[(0u + _e581)].z;
                        if (_e342 < 0f) {
                            let _e795 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e784.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e801 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e795.unnamed.root, _e784.w), _e795.unnamed_1);
                            let _e807 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e801.unnamed, lt_bvh_traverse_Tree(_e784.x, _e801.unnamed_1.first_primitive));
                            phi_1370_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e807.unnamed, lt_bvh_traverse_Tree(_e807.unnamed_1.root, _e784.y));
                        } else {
                            let _e823 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e784.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e829 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e823.unnamed.root, _e784.y), _e823.unnamed_1);
                            let _e835 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e829.unnamed, lt_bvh_traverse_Tree(_e784.z, _e829.unnamed_1.first_primitive));
                            phi_1370_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e835.unnamed, lt_bvh_traverse_Tree(_e835.unnamed_1.root, _e784.w));
                        }
                        let _e843 = phi_1370_;
                        phi_1376_ = 0u;
                        phi_1379_ = 0u;
                        loop {
                            let _e853 = phi_1376_;
                            let _e855 = phi_1379_;
                            local_3 = _e855;
                            local_4 = _e855;
                            local_5 = _e855;
                            let _e856 = (_e853 < 8u);
                            if _e856 {
                                let _e858 = (_e853 >> bitcast<u32>(2i));
                                let _e859 = (_e853 & 3u);
                                if (_e858 == 0u) {
                                    phi_1393_ = _e705.unnamed.root;
                                } else {
                                    phi_1393_ = _e705.unnamed.first_primitive;
                                }
                                let _e862 = phi_1393_;
                                if (_e858 == 0u) {
                                    phi_1403_ = _e774.unnamed.root;
                                } else {
                                    phi_1403_ = _e774.unnamed.first_primitive;
                                }
                                let _e871 = phi_1403_;
                                if (_e858 == 0u) {
                                    phi_1413_ = _e843.unnamed.root;
                                } else {
                                    phi_1413_ = _e843.unnamed.first_primitive;
                                }
                                let _e880 = phi_1413_;
                                let _e893 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e862 >> bitcast<u32>(((_e859 * 8u) & 31u))) & 255u)) * _e615) + (_e636 - _e380)), ((f32(((_e871 >> bitcast<u32>(((_e859 * 8u) & 31u))) & 255u)) * _e616) + (_e637 - _e381)));
                                let _e894 = core_intrinsics_maximum_number_nsz_f32_(_e893, ((f32(((_e880 >> bitcast<u32>(((_e859 * 8u) & 31u))) & 255u)) * _e617) + (_e638 - _e382)));
                                if (_e858 == 0u) {
                                    phi_1431_ = _e705.unnamed_1.root;
                                } else {
                                    phi_1431_ = _e705.unnamed_1.first_primitive;
                                }
                                let _e897 = phi_1431_;
                                if (_e858 == 0u) {
                                    phi_1441_ = _e774.unnamed_1.root;
                                } else {
                                    phi_1441_ = _e774.unnamed_1.first_primitive;
                                }
                                let _e906 = phi_1441_;
                                if (_e858 == 0u) {
                                    phi_1451_ = _e843.unnamed_1.root;
                                } else {
                                    phi_1451_ = _e843.unnamed_1.first_primitive;
                                }
                                let _e915 = phi_1451_;
                                let _e928 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e897 >> bitcast<u32>(((_e859 * 8u) & 31u))) & 255u)) * _e615) + (_e636 + _e380)), ((f32(((_e906 >> bitcast<u32>(((_e859 * 8u) & 31u))) & 255u)) * _e616) + (_e637 + _e381)));
                                let _e929 = core_intrinsics_minimum_number_nsz_f32_(_e928, ((f32(((_e915 >> bitcast<u32>(((_e859 * 8u) & 31u))) & 255u)) * _e617) + (_e638 + _e382)));
                                if (_e894 <= _e929) {
                                    if (_e894 <= _e579.t) {
                                        if (_e929 >= _e174.tmin) {
                                            if (_e858 == 0u) {
                                                let _e936 = nodes.member[(0u + _e581)].links[2u];
                                                phi_1487_ = _e936;
                                            } else {
                                                let _e939 = nodes.member[(0u + _e581)].links[3u];
                                                phi_1487_ = _e939;
                                            }
                                            let _e941 = phi_1487_;
                                            let _e946 = ((_e941 >> bitcast<u32>(((_e859 * 8u) & 31u))) & 255u);
                                            let _e947 = (_e946 & 31u);
                                            if (_e947 >= 24u) {
                                                phi_1500_ = (24u + ((_e947 - 24u) ^ _e441));
                                            } else {
                                                phi_1500_ = _e947;
                                            }
                                            let _e953 = phi_1500_;
                                            phi_1505_ = (_e855 | ((_e946 >> bitcast<u32>(5i)) << bitcast<u32>((_e953 & 31u))));
                                        } else {
                                            phi_1505_ = _e855;
                                        }
                                        let _e961 = phi_1505_;
                                        phi_1506_ = _e961;
                                    } else {
                                        phi_1506_ = _e855;
                                    }
                                    let _e963 = phi_1506_;
                                    phi_1507_ = _e963;
                                } else {
                                    phi_1507_ = _e855;
                                }
                                let _e965 = phi_1507_;
                                phi_1377_ = (_e853 + 1u);
                                phi_1380_ = _e965;
                            } else {
                                phi_1377_ = u32();
                                phi_1380_ = u32();
                            }
                            let _e968 = phi_1377_;
                            let _e970 = phi_1380_;
                            continue;
                            continuing {
                                phi_1376_ = _e968;
                                phi_1379_ = _e970;
                                break if !(_e856);
                            }
                        }
                        let _e974 = nodes.member[(0u + _e581)].links[0u];
                        let _e978 = nodes.member[(0u + _e581)].frame[3u];
                        let _e982 = local_3;
                        if ((_e982 & 4278190080u) == 0u) {
                        } else {
                            let _e986 = local_2.group_mask;
                            if ((_e986 & 4278190080u) == 0u) {
                            } else {
                                let _e990 = local_2.len;
                                if (_e990 < 32u) {
                                    let _e993 = local_2.group;
                                    let _e995 = local_2.len;
                                    if (_e995 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.first[(0u + _e995)] = _e993;
                                    let _e1001 = local_2.group_mask;
                                    let _e1003 = local_2.len;
                                    if (_e1003 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.mask[(0u + _e1003)] = _e1001;
                                    let _e1010 = local_2.len;
                                    local_2.len = (_e1010 + 1u);
                                }
                            }
                            local_2.group = (0u + _e974);
                            let _e1014 = local_4;
                            local_2.group_mask = ((_e1014 & 4278190080u) | (_e978 >> bitcast<u32>(24i)));
                        }
                        let _e1019 = local_5;
                        phi_1565_ = _e579;
                        phi_1568_ = (_e1019 & 16777215u);
                        loop {
                            let _e1022 = phi_1565_;
                            let _e1024 = phi_1568_;
                            local_6 = _e1022;
                            if (_e1024 == 0u) {
                                phi_1566_ = lt_bvh_Hit();
                                phi_1569_ = u32();
                                phi_2424_ = false;
                            } else {
                                let _e1028 = nodes.member[(0u + _e581)].links[1u];
                                let _e1033 = ((0u + _e1028) + select(firstTrailingBit(_e1024), 32u, (_e1024 == 0u)));
                                if (_e1033 < _e81) {
                                } else {
                                    return;
                                }
                                let _e1040 = triangles.member[(0u + _e1033)].v0_;
                                let _e1043 = (_e1040.x - _e174.origin.x);
                                let _e1046 = (_e1040.y - _e174.origin.y);
                                let _e1049 = (_e1040.z - _e174.origin.z);
                                if (_e408 == 0u) {
                                    phi_1615_ = vec3<f32>(_e1046, _e1049, _e1043);
                                } else {
                                    if (_e408 == 1u) {
                                        phi_1614_ = vec3<f32>(_e1049, _e1043, _e1046);
                                    } else {
                                        phi_1614_ = (_e1040 - _e174.origin);
                                    }
                                    let _e1056 = phi_1614_;
                                    phi_1615_ = _e1056;
                                }
                                let _e1058 = phi_1615_;
                                let _e1062 = (_e1058.x - (_e425 * _e1058.z));
                                let _e1066 = (_e1058.y - (_e428 * _e1058.z));
                                let _e1068 = triangles.member[(0u + _e1033)].v1_;
                                let _e1071 = (_e1068.x - _e174.origin.x);
                                let _e1074 = (_e1068.y - _e174.origin.y);
                                let _e1077 = (_e1068.z - _e174.origin.z);
                                if (_e408 == 0u) {
                                    phi_1647_ = vec3<f32>(_e1074, _e1077, _e1071);
                                } else {
                                    if (_e408 == 1u) {
                                        phi_1646_ = vec3<f32>(_e1077, _e1071, _e1074);
                                    } else {
                                        phi_1646_ = (_e1068 - _e174.origin);
                                    }
                                    let _e1084 = phi_1646_;
                                    phi_1647_ = _e1084;
                                }
                                let _e1086 = phi_1647_;
                                let _e1090 = (_e1086.x - (_e425 * _e1086.z));
                                let _e1094 = (_e1086.y - (_e428 * _e1086.z));
                                let _e1096 = triangles.member[(0u + _e1033)].v2_;
                                let _e1099 = (_e1096.x - _e174.origin.x);
                                let _e1102 = (_e1096.y - _e174.origin.y);
                                let _e1105 = (_e1096.z - _e174.origin.z);
                                if (_e408 == 0u) {
                                    phi_1679_ = vec3<f32>(_e1102, _e1105, _e1099);
                                } else {
                                    if (_e408 == 1u) {
                                        phi_1678_ = vec3<f32>(_e1105, _e1099, _e1102);
                                    } else {
                                        phi_1678_ = (_e1096 - _e174.origin);
                                    }
                                    let _e1112 = phi_1678_;
                                    phi_1679_ = _e1112;
                                }
                                let _e1114 = phi_1679_;
                                let _e1118 = (_e1114.x - (_e425 * _e1114.z));
                                let _e1122 = (_e1114.y - (_e428 * _e1114.z));
                                if (_e1090 < _e1118) {
                                    phi_1698_ = true;
                                } else {
                                    if (_e1090 == _e1118) {
                                        phi_1697_ = (_e1094 < _e1122);
                                    } else {
                                        phi_1697_ = false;
                                    }
                                    let _e1127 = phi_1697_;
                                    phi_1698_ = _e1127;
                                }
                                let _e1129 = phi_1698_;
                                if _e1129 {
                                    phi_1702_ = _e1122;
                                    phi_1703_ = _e1118;
                                    phi_1704_ = _e1094;
                                    phi_1705_ = _e1090;
                                } else {
                                    phi_1702_ = _e1094;
                                    phi_1703_ = _e1090;
                                    phi_1704_ = _e1122;
                                    phi_1705_ = _e1118;
                                }
                                let _e1131 = phi_1702_;
                                let _e1133 = phi_1703_;
                                let _e1135 = phi_1704_;
                                let _e1137 = phi_1705_;
                                let _e1140 = ((_e1137 * _e1131) - (_e1135 * _e1133));
                                if _e1129 {
                                    phi_1713_ = -(_e1140);
                                } else {
                                    phi_1713_ = _e1140;
                                }
                                let _e1143 = phi_1713_;
                                if (_e1118 < _e1062) {
                                    phi_1724_ = true;
                                } else {
                                    if (_e1118 == _e1062) {
                                        phi_1723_ = (_e1122 < _e1066);
                                    } else {
                                        phi_1723_ = false;
                                    }
                                    let _e1148 = phi_1723_;
                                    phi_1724_ = _e1148;
                                }
                                let _e1150 = phi_1724_;
                                if _e1150 {
                                    phi_1728_ = _e1066;
                                    phi_1729_ = _e1062;
                                    phi_1730_ = _e1122;
                                    phi_1731_ = _e1118;
                                } else {
                                    phi_1728_ = _e1122;
                                    phi_1729_ = _e1118;
                                    phi_1730_ = _e1066;
                                    phi_1731_ = _e1062;
                                }
                                let _e1152 = phi_1728_;
                                let _e1154 = phi_1729_;
                                let _e1156 = phi_1730_;
                                let _e1158 = phi_1731_;
                                let _e1161 = ((_e1158 * _e1152) - (_e1156 * _e1154));
                                if _e1150 {
                                    phi_1739_ = -(_e1161);
                                } else {
                                    phi_1739_ = _e1161;
                                }
                                let _e1164 = phi_1739_;
                                if (_e1062 < _e1090) {
                                    phi_1750_ = true;
                                } else {
                                    if (_e1062 == _e1090) {
                                        phi_1749_ = (_e1066 < _e1094);
                                    } else {
                                        phi_1749_ = false;
                                    }
                                    let _e1169 = phi_1749_;
                                    phi_1750_ = _e1169;
                                }
                                let _e1171 = phi_1750_;
                                if _e1171 {
                                    phi_1754_ = _e1094;
                                    phi_1755_ = _e1090;
                                    phi_1756_ = _e1066;
                                    phi_1757_ = _e1062;
                                } else {
                                    phi_1754_ = _e1066;
                                    phi_1755_ = _e1062;
                                    phi_1756_ = _e1094;
                                    phi_1757_ = _e1090;
                                }
                                let _e1173 = phi_1754_;
                                let _e1175 = phi_1755_;
                                let _e1177 = phi_1756_;
                                let _e1179 = phi_1757_;
                                let _e1182 = ((_e1179 * _e1173) - (_e1177 * _e1175));
                                if _e1171 {
                                    phi_1765_ = -(_e1182);
                                } else {
                                    phi_1765_ = _e1182;
                                }
                                let _e1185 = phi_1765_;
                                if (_e1143 >= 0f) {
                                    if (_e1164 >= 0f) {
                                        if (_e1185 >= 0f) {
                                            phi_1780_ = ((_e1143 + _e1164) + _e1185);
                                            phi_1781_ = false;
                                        } else {
                                            phi_1780_ = f32();
                                            phi_1781_ = true;
                                        }
                                        let _e1192 = phi_1780_;
                                        let _e1194 = phi_1781_;
                                        phi_1782_ = _e1192;
                                        phi_1783_ = _e1194;
                                    } else {
                                        phi_1782_ = f32();
                                        phi_1783_ = true;
                                    }
                                    let _e1196 = phi_1782_;
                                    let _e1198 = phi_1783_;
                                    phi_1784_ = _e1196;
                                    phi_1785_ = _e1198;
                                } else {
                                    phi_1784_ = f32();
                                    phi_1785_ = true;
                                }
                                let _e1200 = phi_1784_;
                                let _e1202 = phi_1785_;
                                if _e1202 {
                                    if (_e1143 <= 0f) {
                                        if (_e1164 <= 0f) {
                                            let _e1205 = (_e1185 <= 0f);
                                            if _e1205 {
                                            }
                                            phi_1803_ = ((_e1143 + _e1164) + _e1185);
                                            phi_1804_ = false;
                                            phi_1805_ = _e1205;
                                        } else {
                                            phi_1803_ = f32();
                                            phi_1804_ = true;
                                            phi_1805_ = false;
                                        }
                                        let _e1209 = phi_1803_;
                                        let _e1211 = phi_1804_;
                                        let _e1213 = phi_1805_;
                                        phi_1806_ = _e1209;
                                        phi_1807_ = _e1211;
                                        phi_1808_ = _e1213;
                                    } else {
                                        phi_1806_ = f32();
                                        phi_1807_ = true;
                                        phi_1808_ = false;
                                    }
                                    let _e1215 = phi_1806_;
                                    let _e1217 = phi_1807_;
                                    let _e1219 = phi_1808_;
                                    if _e1217 {
                                        phi_1812_ = false;
                                    } else {
                                        phi_1812_ = _e1219;
                                    }
                                    let _e1221 = phi_1812_;
                                    phi_1813_ = _e1215;
                                    phi_1814_ = _e1221;
                                } else {
                                    phi_1813_ = _e1200;
                                    phi_1814_ = true;
                                }
                                let _e1223 = phi_1813_;
                                let _e1225 = phi_1814_;
                                if _e1225 {
                                    let _e1226 = (_e1223 == 0f);
                                    if _e1226 {
                                        phi_2140_ = lt_bvh_triangle_Intersection();
                                        phi_2141_ = false;
                                    } else {
                                        let _e1228 = triangles.member[(0u + _e1033)].v0_;
                                        let _e1231 = (_e1228.x - _e174.origin.x);
                                        let _e1234 = (_e1228.y - _e174.origin.y);
                                        let _e1237 = (_e1228.z - _e174.origin.z);
                                        if (_e408 == 0u) {
                                            phi_1845_ = vec3<f32>(_e1234, _e1237, _e1231);
                                        } else {
                                            if (_e408 == 1u) {
                                                phi_1844_ = vec3<f32>(_e1237, _e1231, _e1234);
                                            } else {
                                                phi_1844_ = (_e1228 - _e174.origin);
                                            }
                                            let _e1244 = phi_1844_;
                                            phi_1845_ = _e1244;
                                        }
                                        let _e1246 = phi_1845_;
                                        let _e1248 = triangles.member[(0u + _e1033)].v1_;
                                        let _e1250 = triangles.member[(0u + _e1033)].v0_;
                                        let _e1253 = (_e1248.x - _e1250.x);
                                        let _e1256 = (_e1248.y - _e1250.y);
                                        let _e1259 = (_e1248.z - _e1250.z);
                                        if (_e408 == 0u) {
                                            phi_1871_ = vec3<f32>(_e1256, _e1259, _e1253);
                                        } else {
                                            if (_e408 == 1u) {
                                                phi_1870_ = vec3<f32>(_e1259, _e1253, _e1256);
                                            } else {
                                                phi_1870_ = (_e1248 - _e1250);
                                            }
                                            let _e1266 = phi_1870_;
                                            phi_1871_ = _e1266;
                                        }
                                        let _e1268 = phi_1871_;
                                        let _e1270 = triangles.member[(0u + _e1033)].v2_;
                                        let _e1272 = triangles.member[(0u + _e1033)].v0_;
                                        let _e1275 = (_e1270.x - _e1272.x);
                                        let _e1278 = (_e1270.y - _e1272.y);
                                        let _e1281 = (_e1270.z - _e1272.z);
                                        if (_e408 == 0u) {
                                            phi_1897_ = vec3<f32>(_e1278, _e1281, _e1275);
                                        } else {
                                            if (_e408 == 1u) {
                                                phi_1896_ = vec3<f32>(_e1281, _e1275, _e1278);
                                            } else {
                                                phi_1896_ = (_e1270 - _e1272);
                                            }
                                            let _e1288 = phi_1896_;
                                            phi_1897_ = _e1288;
                                        }
                                        let _e1290 = phi_1897_;
                                        let _e1297 = ((_e1268.y * _e1290.z) - (_e1268.z * _e1290.y));
                                        let _e1304 = ((_e1268.z * _e1290.x) - (_e1268.x * _e1290.z));
                                        let _e1311 = ((_e1268.x * _e1290.y) - (_e1268.y * _e1290.x));
                                        let _e1325 = (((1f / _e422.z) * (((_e1297 * _e1246.x) + (_e1304 * _e1246.y)) + (_e1311 * _e1246.z))) / (((_e1297 * _e425) + (_e1304 * _e428)) + _e1311));
                                        if (_e1325 > _e174.tmin) {
                                            if (_e1325 < _e174.tmax) {
                                                let _e1331 = triangles.member[(0u + _e1033)].v0_;
                                                let _e1333 = triangles.member[(0u + _e1033)].v1_;
                                                if (_e1331.x < _e1333.x) {
                                                    phi_1955_ = _e1331.x;
                                                } else {
                                                    phi_1955_ = _e1333.x;
                                                }
                                                let _e1340 = phi_1955_;
                                                if (_e1331.y < _e1333.y) {
                                                    phi_1964_ = _e1331.y;
                                                } else {
                                                    phi_1964_ = _e1333.y;
                                                }
                                                let _e1347 = phi_1964_;
                                                if (_e1331.z < _e1333.z) {
                                                    phi_1973_ = _e1331.z;
                                                } else {
                                                    phi_1973_ = _e1333.z;
                                                }
                                                let _e1354 = phi_1973_;
                                                let _e1356 = triangles.member[(0u + _e1033)].v2_;
                                                if (_e1340 < _e1356.x) {
                                                    phi_1982_ = _e1340;
                                                } else {
                                                    phi_1982_ = _e1356.x;
                                                }
                                                let _e1361 = phi_1982_;
                                                if (_e1347 < _e1356.y) {
                                                    phi_1989_ = _e1347;
                                                } else {
                                                    phi_1989_ = _e1356.y;
                                                }
                                                let _e1366 = phi_1989_;
                                                if (_e1354 < _e1356.z) {
                                                    phi_1996_ = _e1354;
                                                } else {
                                                    phi_1996_ = _e1356.z;
                                                }
                                                let _e1371 = phi_1996_;
                                                let _e1373 = triangles.member[(0u + _e1033)].v0_;
                                                let _e1375 = triangles.member[(0u + _e1033)].v1_;
                                                if (_e1373.x > _e1375.x) {
                                                    phi_2009_ = _e1373.x;
                                                } else {
                                                    phi_2009_ = _e1375.x;
                                                }
                                                let _e1382 = phi_2009_;
                                                if (_e1373.y > _e1375.y) {
                                                    phi_2018_ = _e1373.y;
                                                } else {
                                                    phi_2018_ = _e1375.y;
                                                }
                                                let _e1389 = phi_2018_;
                                                if (_e1373.z > _e1375.z) {
                                                    phi_2027_ = _e1373.z;
                                                } else {
                                                    phi_2027_ = _e1375.z;
                                                }
                                                let _e1396 = phi_2027_;
                                                let _e1398 = triangles.member[(0u + _e1033)].v2_;
                                                if (_e1382 > _e1398.x) {
                                                    phi_2036_ = _e1382;
                                                } else {
                                                    phi_2036_ = _e1398.x;
                                                }
                                                let _e1403 = phi_2036_;
                                                if (_e1389 > _e1398.y) {
                                                    phi_2043_ = _e1389;
                                                } else {
                                                    phi_2043_ = _e1398.y;
                                                }
                                                let _e1408 = phi_2043_;
                                                if (_e1396 > _e1398.z) {
                                                    phi_2050_ = _e1396;
                                                } else {
                                                    phi_2050_ = _e1398.z;
                                                }
                                                let _e1413 = phi_2050_;
                                                let _e1420 = ((_e1361 - _e174.origin.x) * _e320);
                                                let _e1421 = ((_e1366 - _e174.origin.y) * _e331);
                                                let _e1422 = ((_e1371 - _e174.origin.z) * _e342);
                                                let _e1429 = ((_e1403 - _e174.origin.x) * _e320);
                                                let _e1430 = ((_e1408 - _e174.origin.y) * _e331);
                                                let _e1431 = ((_e1413 - _e174.origin.z) * _e342);
                                                if (_e1420 < _e1429) {
                                                    phi_2073_ = _e1420;
                                                } else {
                                                    phi_2073_ = _e1429;
                                                }
                                                let _e1434 = phi_2073_;
                                                if (_e1421 < _e1430) {
                                                    phi_2078_ = _e1421;
                                                } else {
                                                    phi_2078_ = _e1430;
                                                }
                                                let _e1437 = phi_2078_;
                                                if (_e1422 < _e1431) {
                                                    phi_2083_ = _e1422;
                                                } else {
                                                    phi_2083_ = _e1431;
                                                }
                                                let _e1440 = phi_2083_;
                                                if (_e1420 > _e1429) {
                                                    phi_2091_ = _e1420;
                                                } else {
                                                    phi_2091_ = _e1429;
                                                }
                                                let _e1446 = phi_2091_;
                                                if (_e1421 > _e1430) {
                                                    phi_2096_ = _e1421;
                                                } else {
                                                    phi_2096_ = _e1430;
                                                }
                                                let _e1449 = phi_2096_;
                                                if (_e1422 > _e1431) {
                                                    phi_2101_ = _e1422;
                                                } else {
                                                    phi_2101_ = _e1431;
                                                }
                                                let _e1452 = phi_2101_;
                                                let _e1456 = core_intrinsics_maximum_number_nsz_f32_((_e1434 - _e387), (_e1437 - _e388));
                                                let _e1457 = core_intrinsics_maximum_number_nsz_f32_(_e1456, (_e1440 - _e389));
                                                let _e1458 = core_intrinsics_minimum_number_nsz_f32_((_e1446 + _e387), (_e1449 + _e388));
                                                let _e1459 = core_intrinsics_minimum_number_nsz_f32_(_e1458, (_e1452 + _e389));
                                                if (_e1457 > -300000000000000000000000000000000000000f) {
                                                    phi_2113_ = _e1457;
                                                } else {
                                                    phi_2113_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1462 = phi_2113_;
                                                if (_e1459 < 300000000000000000000000000000000000000f) {
                                                    phi_2118_ = _e1459;
                                                } else {
                                                    phi_2118_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1465 = phi_2118_;
                                                if (_e1325 < _e1462) {
                                                    phi_2123_ = _e1462;
                                                } else {
                                                    phi_2123_ = _e1325;
                                                }
                                                let _e1468 = phi_2123_;
                                                if (_e1468 > _e1465) {
                                                    phi_2128_ = _e1465;
                                                } else {
                                                    phi_2128_ = _e1468;
                                                }
                                                let _e1471 = phi_2128_;
                                                phi_2133_ = lt_bvh_triangle_Intersection(_e1471, (_e1164 / _e1223), (_e1185 / _e1223), (_e1462 <= _e1465));
                                                phi_2134_ = false;
                                            } else {
                                                phi_2133_ = lt_bvh_triangle_Intersection();
                                                phi_2134_ = true;
                                            }
                                            let _e1477 = phi_2133_;
                                            let _e1479 = phi_2134_;
                                            phi_2135_ = _e1477;
                                            phi_2136_ = _e1479;
                                        } else {
                                            phi_2135_ = lt_bvh_triangle_Intersection();
                                            phi_2136_ = true;
                                        }
                                        let _e1481 = phi_2135_;
                                        let _e1483 = phi_2136_;
                                        if _e1483 {
                                        }
                                        phi_2140_ = _e1481;
                                        phi_2141_ = _e1483;
                                    }
                                    let _e1485 = phi_2140_;
                                    let _e1487 = phi_2141_;
                                    phi_2142_ = _e1485;
                                    phi_2143_ = _e1226;
                                    phi_2144_ = _e1487;
                                } else {
                                    phi_2142_ = lt_bvh_triangle_Intersection();
                                    phi_2143_ = true;
                                    phi_2144_ = false;
                                }
                                let _e1489 = phi_2142_;
                                let _e1491 = phi_2143_;
                                let _e1493 = phi_2144_;
                                if _e1491 {
                                    phi_2148_ = true;
                                } else {
                                    phi_2148_ = _e1493;
                                }
                                let _e1495 = phi_2148_;
                                if _e1495 {
                                    phi_2152_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_2152_ = _e1489;
                                }
                                let _e1497 = phi_2152_;
                                if _e1497.is_hit {
                                    if (_e1497.t > _e174.tmin) {
                                        if (_e1497.t < _e1022.t) {
                                            phi_2201_ = true;
                                        } else {
                                            if (_e1497.t == _e1022.t) {
                                                if (_e1022.triangle != 4294967295u) {
                                                    if (_e1033 < _e1022.triangle) {
                                                        phi_2192_ = true;
                                                    } else {
                                                        if (_e1033 == _e1022.triangle) {
                                                            phi_2191_ = (4294967295u < _e1022.instance);
                                                        } else {
                                                            phi_2191_ = false;
                                                        }
                                                        let _e1516 = phi_2191_;
                                                        phi_2192_ = _e1516;
                                                    }
                                                    let _e1518 = phi_2192_;
                                                    phi_2193_ = _e1518;
                                                    phi_2194_ = false;
                                                } else {
                                                    phi_2193_ = bool();
                                                    phi_2194_ = true;
                                                }
                                                let _e1520 = phi_2193_;
                                                let _e1522 = phi_2194_;
                                                phi_2195_ = _e1520;
                                                phi_2196_ = _e1522;
                                            } else {
                                                phi_2195_ = bool();
                                                phi_2196_ = true;
                                            }
                                            let _e1524 = phi_2195_;
                                            let _e1526 = phi_2196_;
                                            if _e1526 {
                                                phi_2200_ = false;
                                            } else {
                                                phi_2200_ = _e1524;
                                            }
                                            let _e1528 = phi_2200_;
                                            phi_2201_ = _e1528;
                                        }
                                        let _e1530 = phi_2201_;
                                        if _e1530 {
                                            let _e1532 = triangles.member[(0u + _e1033)].i0_;
                                            if ((_e1532 & 2147483648u) == 0u) {
                                                phi_2412_ = true;
                                            } else {
                                                if (_e1033 < _e81) {
                                                } else {
                                                    return;
                                                }
                                                let _e1541 = triangles.member[(0u + _e1033)].i0_;
                                                let _e1542 = (_e1541 & 2147483647u);
                                                let _e1544 = triangles.member[(0u + _e1033)].i1_;
                                                let _e1546 = triangles.member[(0u + _e1033)].i2_;
                                                if (_e1542 < _e84) {
                                                } else {
                                                    return;
                                                }
                                                let _e1550 = vertices.member[(0u + _e1542)];
                                                if (_e1544 < _e84) {
                                                } else {
                                                    return;
                                                }
                                                let _e1554 = vertices.member[(0u + _e1544)];
                                                if (_e1546 < _e84) {
                                                } else {
                                                    return;
                                                }
                                                let _e1558 = vertices.member[(0u + _e1546)];
                                                let _e1559 = array<abi_Vertex, 3>(_e1550, _e1554, _e1558);
                                                if (_e1559[0].material < _e87) {
                                                } else {
                                                    return;
                                                }
                                                let _e1565 = materials.member[(0u + _e1559[0].material)];
                                                if ((_e1565.flags & 0u) == 0u) {
                                                    let _e1570 = ((1f - _e1497.u) - _e1497.v);
                                                    if (_e1565.cutoff <= 0f) {
                                                        phi_2407_ = true;
                                                    } else {
                                                        let _e1597 = (_e1565.base_color.w * ((((f32((_e1559[0].color >> bitcast<u32>(24i))) * _e1570) + (f32((_e1559[1].color >> bitcast<u32>(24i))) * _e1497.u)) + (f32((_e1559[2].color >> bitcast<u32>(24i))) * _e1497.v)) * (1f / 255f)));
                                                        if (_e1565.alpha_size == 0u) {
                                                            phi_2404_ = _e1597;
                                                        } else {
                                                            local_1.offset = _e1565.alpha_offset;
                                                            local_1.size = _e1565.alpha_size;
                                                            local_1.flags = _e1565.flags;
                                                            let _e1628 = _lt_shaders_texture_TextureView_quad((&local_1), (((_e1559[0].u * _e1570) + (_e1559[1].u * _e1497.u)) + (_e1559[2].u * _e1497.v)), (((_e1559[0].v * _e1570) + (_e1559[1].v * _e1497.u)) + (_e1559[2].v * _e1497.v)));
                                                            let _e1632 = (_e1628.indices[0] >> bitcast<u32>(2i));
                                                            if (_e1632 < _e93) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1636 = alpha_texels.member[(0u + _e1632)];
                                                            let _e1652 = (_e1628.indices[1] >> bitcast<u32>(2i));
                                                            if (_e1652 < _e93) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1656 = alpha_texels.member[(0u + _e1652)];
                                                            let _e1673 = (_e1628.indices[2] >> bitcast<u32>(2i));
                                                            if (_e1673 < _e93) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1677 = alpha_texels.member[(0u + _e1673)];
                                                            let _e1694 = (_e1628.indices[3] >> bitcast<u32>(2i));
                                                            if (_e1694 < _e93) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1698 = alpha_texels.member[(0u + _e1694)];
                                                            phi_2404_ = (_e1597 * (((((f32(((_e1636 >> bitcast<u32>((((_e1628.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1628.weights.x) + ((f32(((_e1656 >> bitcast<u32>((((_e1628.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1628.weights.y)) + ((f32(((_e1677 >> bitcast<u32>((((_e1628.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1628.weights.z)) + ((f32(((_e1698 >> bitcast<u32>((((_e1628.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1628.weights.w)));
                                                        }
                                                        let _e1714 = phi_2404_;
                                                        phi_2407_ = (_e1714 >= _e1565.cutoff);
                                                    }
                                                    let _e1718 = phi_2407_;
                                                    phi_2408_ = _e1718;
                                                } else {
                                                    phi_2408_ = false;
                                                }
                                                let _e1720 = phi_2408_;
                                                if _e1720 {
                                                }
                                                phi_2412_ = _e1720;
                                            }
                                            let _e1722 = phi_2412_;
                                            if _e1722 {
                                                phi_2420_ = lt_bvh_Hit(_e1497.t, _e1497.u, _e1497.v, _e1033, 4294967295u);
                                            } else {
                                                phi_2420_ = _e1022;
                                            }
                                            let _e1728 = phi_2420_;
                                            phi_2421_ = _e1728;
                                        } else {
                                            phi_2421_ = _e1022;
                                        }
                                        let _e1730 = phi_2421_;
                                        phi_2422_ = _e1730;
                                    } else {
                                        phi_2422_ = _e1022;
                                    }
                                    let _e1732 = phi_2422_;
                                    phi_2423_ = _e1732;
                                } else {
                                    phi_2423_ = _e1022;
                                }
                                let _e1734 = phi_2423_;
                                phi_1566_ = _e1734;
                                phi_1569_ = (_e1024 & (_e1024 - 1u));
                                phi_2424_ = true;
                            }
                            let _e1736 = phi_1566_;
                            let _e1738 = phi_1569_;
                            let _e1740 = phi_2424_;
                            continue;
                            continuing {
                                phi_1565_ = _e1736;
                                phi_1568_ = _e1738;
                                break if !(_e1740);
                            }
                        }
                        let _e1743 = local_2.group_mask;
                        if ((_e1743 & 4278190080u) == 0u) {
                            let _e1747 = local_2.len;
                            if (_e1747 == 0u) {
                                phi_2463_ = false;
                            } else {
                                let _e1751 = local_2.len;
                                local_2.len = (_e1751 - 1u);
                                let _e1754 = local_2.len;
                                if (_e1754 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1759 = local_2.first[(0u + _e1754)];
                                local_2.group = _e1759;
                                let _e1762 = local_2.len;
                                if (_e1762 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1767 = local_2.mask[(0u + _e1762)];
                                local_2.group_mask = _e1767;
                                phi_2463_ = true;
                            }
                            let _e1770 = phi_2463_;
                            phi_2464_ = _e1770;
                        } else {
                            phi_2464_ = true;
                        }
                        let _e1772 = phi_2464_;
                        if _e1772 {
                            let _e1774 = local_2.group_mask;
                            let _e1780 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1774)), 32u, (_e1774 == 0u)));
                            let _e1784 = local_2.group_mask;
                            let _e1798 = local_2.group_mask;
                            local_2.group_mask = (_e1798 & ~((1u << bitcast<u32>((_e1780 & 31u)))));
                            let _e1801 = local_2.group;
                            phi_2495_ = (_e1801 + countOneBits(((_e1784 & ~((4294967295u << bitcast<u32>((((_e1780 - 24u) ^ _e441) & 31u))))) & 255u)));
                        } else {
                            phi_2495_ = 4294967295u;
                        }
                        let _e1804 = phi_2495_;
                        let _e2649 = local_6;
                        phi_1229_ = _e2649;
                        phi_1232_ = _e1804;
                    } else {
                        phi_1229_ = lt_bvh_Hit();
                        phi_1232_ = u32();
                    }
                    let _e1806 = phi_1229_;
                    let _e1808 = phi_1232_;
                    continue;
                    continuing {
                        phi_1228_ = _e1806;
                        phi_1231_ = _e1808;
                        break if !(_e582);
                    }
                }
                let _e2653 = local_7;
                phi_2496_ = _e2653;
            }
            let _e1811 = phi_2496_;
            phi_2497_ = _e1811;
            phi_2498_ = _e238;
        } else {
            phi_2497_ = lt_bvh_Hit();
            phi_2498_ = true;
        }
        let _e1813 = phi_2497_;
        let _e1815 = phi_2498_;
        if _e1815 {
            phi_2502_ = _e176;
        } else {
            phi_2502_ = _e1813;
        }
        let _e1817 = phi_2502_;
        if (_e1817.triangle != 4294967295u) {
            let _e1823 = ((1f - _e1817.u) - _e1817.v);
            if (_e1817.triangle < _e81) {
            } else {
                return;
            }
            let _e1828 = triangles.member[(0u + _e1817.triangle)];
            let _e1853 = (((_e1828.v0_.x * _e1823) + (_e1828.v1_.x * _e1817.u)) + (_e1828.v2_.x * _e1817.v));
            let _e1854 = (((_e1828.v0_.y * _e1823) + (_e1828.v1_.y * _e1817.u)) + (_e1828.v2_.y * _e1817.v));
            let _e1855 = (((_e1828.v0_.z * _e1823) + (_e1828.v1_.z * _e1817.u)) + (_e1828.v2_.z * _e1817.v));
            let _e1858 = abs(_e1828.v0_.x);
            let _e1860 = abs(_e1828.v0_.y);
            let _e1862 = abs(_e1828.v0_.z);
            let _e1864 = abs(_e1828.v1_.x);
            let _e1866 = abs(_e1828.v1_.y);
            let _e1868 = abs(_e1828.v1_.z);
            if (_e1858 > _e1864) {
                phi_2566_ = _e1858;
            } else {
                phi_2566_ = _e1864;
            }
            let _e1871 = phi_2566_;
            if (_e1860 > _e1866) {
                phi_2571_ = _e1860;
            } else {
                phi_2571_ = _e1866;
            }
            let _e1874 = phi_2571_;
            if (_e1862 > _e1868) {
                phi_2576_ = _e1862;
            } else {
                phi_2576_ = _e1868;
            }
            let _e1877 = phi_2576_;
            let _e1879 = abs(_e1828.v2_.x);
            let _e1881 = abs(_e1828.v2_.y);
            let _e1883 = abs(_e1828.v2_.z);
            if (_e1871 > _e1879) {
                phi_2587_ = _e1871;
            } else {
                phi_2587_ = _e1879;
            }
            let _e1886 = phi_2587_;
            if (_e1874 > _e1881) {
                phi_2592_ = _e1874;
            } else {
                phi_2592_ = _e1881;
            }
            let _e1889 = phi_2592_;
            if (_e1877 > _e1883) {
                phi_2597_ = _e1877;
            } else {
                phi_2597_ = _e1883;
            }
            let _e1892 = phi_2597_;
            let _e1895 = (_e1828.v1_.x - _e1828.v0_.x);
            let _e1898 = (_e1828.v1_.y - _e1828.v0_.y);
            let _e1901 = (_e1828.v1_.z - _e1828.v0_.z);
            let _e1904 = (_e1828.v2_.x - _e1828.v0_.x);
            let _e1907 = (_e1828.v2_.y - _e1828.v0_.y);
            let _e1910 = (_e1828.v2_.z - _e1828.v0_.z);
            let _e1914 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1898), abs(_e1901));
            let _e1915 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1895), _e1914);
            let _e1916 = (_e1895 / _e1915);
            let _e1917 = (_e1898 / _e1915);
            let _e1918 = (_e1901 / _e1915);
            let _e1922 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1907), abs(_e1910));
            let _e1923 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1904), _e1922);
            let _e1924 = (_e1904 / _e1923);
            let _e1925 = (_e1907 / _e1923);
            let _e1926 = (_e1910 / _e1923);
            let _e1929 = ((_e1917 * _e1926) - (_e1925 * _e1918));
            let _e1932 = ((_e1918 * _e1924) - (_e1926 * _e1916));
            let _e1935 = ((_e1916 * _e1925) - (_e1924 * _e1917));
            let _e1937 = p.member.eye;
            let _e1950 = (1f / sqrt((((_e1929 * _e1929) + (_e1932 * _e1932)) + (_e1935 * _e1935))));
            let _e1951 = (_e1929 * _e1950);
            let _e1952 = (_e1932 * _e1950);
            let _e1953 = (_e1935 * _e1950);
            if ((((_e1951 * (_e1937.x - _e1853)) + (_e1952 * (_e1937.y - _e1854))) + (_e1953 * (_e1937.z - _e1855))) < 0f) {
                phi_2673_ = vec3<f32>(-(_e1951), -(_e1952), -(_e1953));
            } else {
                phi_2673_ = vec3<f32>(_e1951, _e1952, _e1953);
            }
            let _e1966 = phi_2673_;
            if (_e1817.triangle < _e81) {
            } else {
                return;
            }
            let _e1971 = triangles.member[(0u + _e1817.triangle)];
            let _e1973 = (_e1971.i0_ & 2147483647u);
            if (_e1973 < _e84) {
            } else {
                return;
            }
            let _e1979 = vertices.member[(0u + _e1973)];
            if (_e1971.i1_ < _e84) {
            } else {
                return;
            }
            let _e1983 = vertices.member[(0u + _e1971.i1_)];
            if (_e1971.i2_ < _e84) {
            } else {
                return;
            }
            let _e1987 = vertices.member[(0u + _e1971.i2_)];
            let _e1988 = array<abi_Vertex, 3>(_e1979, _e1983, _e1987);
            if (_e1988[0].material < _e87) {
            } else {
                return;
            }
            let _e1994 = materials.member[(0u + _e1988[0].material)];
            let _e2011 = (1f / 255f);
            let _e2030 = (1f / 255f);
            let _e2052 = (1f / 255f);
            if (_e1994.color_size == 0u) {
                phi_2916_ = vec3<f32>(1f, 1f, 1f);
            } else {
                local.offset = _e1994.color_offset;
                local.size = _e1994.color_size;
                local.flags = _e1994.flags;
                let _e2095 = _lt_shaders_texture_TextureView_quad((&local), (((_e1988[0].u * _e1823) + (_e1988[1].u * _e1817.u)) + (_e1988[2].u * _e1817.v)), (((_e1988[0].v * _e1823) + (_e1988[1].v * _e1817.u)) + (_e1988[2].v * _e1817.v)));
                if (_e2095.indices[0] < _e96) {
                } else {
                    return;
                }
                let _e2101 = color_texels.member[(0u + _e2095.indices[0])];
                let _e2112 = (1f / 255f);
                if (_e2095.indices[1] < _e96) {
                } else {
                    return;
                }
                let _e2126 = color_texels.member[(0u + _e2095.indices[1])];
                let _e2137 = (1f / 255f);
                if (_e2095.indices[2] < _e96) {
                } else {
                    return;
                }
                let _e2154 = color_texels.member[(0u + _e2095.indices[2])];
                let _e2165 = (1f / 255f);
                if (_e2095.indices[3] < _e96) {
                } else {
                    return;
                }
                let _e2182 = color_texels.member[(0u + _e2095.indices[3])];
                let _e2193 = (1f / 255f);
                let _e2202 = (((((f32((_e2101 & 255u)) * _e2112) * _e2095.weights.x) + ((f32((_e2126 & 255u)) * _e2137) * _e2095.weights.y)) + ((f32((_e2154 & 255u)) * _e2165) * _e2095.weights.z)) + ((f32((_e2182 & 255u)) * _e2193) * _e2095.weights.w));
                let _e2203 = (((((f32(((_e2101 >> bitcast<u32>(8i)) & 255u)) * _e2112) * _e2095.weights.x) + ((f32(((_e2126 >> bitcast<u32>(8i)) & 255u)) * _e2137) * _e2095.weights.y)) + ((f32(((_e2154 >> bitcast<u32>(8i)) & 255u)) * _e2165) * _e2095.weights.z)) + ((f32(((_e2182 >> bitcast<u32>(8i)) & 255u)) * _e2193) * _e2095.weights.w));
                let _e2204 = (((((f32(((_e2101 >> bitcast<u32>(16i)) & 255u)) * _e2112) * _e2095.weights.x) + ((f32(((_e2126 >> bitcast<u32>(16i)) & 255u)) * _e2137) * _e2095.weights.y)) + ((f32(((_e2154 >> bitcast<u32>(16i)) & 255u)) * _e2165) * _e2095.weights.z)) + ((f32(((_e2182 >> bitcast<u32>(16i)) & 255u)) * _e2193) * _e2095.weights.w));
                phi_2916_ = vec3<f32>((_e2202 * _e2202), (_e2203 * _e2203), (_e2204 * _e2204));
            }
            let _e2210 = phi_2916_;
            let _e2212 = ((_e1994.base_color.x * ((((f32((_e1988[0].color & 255u)) * _e2011) * _e1823) + ((f32((_e1988[1].color & 255u)) * _e2030) * _e1817.u)) + ((f32((_e1988[2].color & 255u)) * _e2052) * _e1817.v))) * _e2210.x);
            let _e2214 = ((_e1994.base_color.y * ((((f32(((_e1988[0].color >> bitcast<u32>(8i)) & 255u)) * _e2011) * _e1823) + ((f32(((_e1988[1].color >> bitcast<u32>(8i)) & 255u)) * _e2030) * _e1817.u)) + ((f32(((_e1988[2].color >> bitcast<u32>(8i)) & 255u)) * _e2052) * _e1817.v))) * _e2210.y);
            let _e2216 = ((_e1994.base_color.z * ((((f32(((_e1988[0].color >> bitcast<u32>(16i)) & 255u)) * _e2011) * _e1823) + ((f32(((_e1988[1].color >> bitcast<u32>(16i)) & 255u)) * _e2030) * _e1817.u)) + ((f32(((_e1988[2].color >> bitcast<u32>(16i)) & 255u)) * _e2052) * _e1817.v))) * _e2210.z);
            let _e2217 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1889, _e1892);
            let _e2218 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1886, _e2217);
            if ((_e1994.flags & 2u) == 0u) {
                phi_2931_ = 0u;
            } else {
                phi_2931_ = 1u;
            }
            let _e2223 = phi_2931_;
            if (_e1988[0].normal == 2147516416u) {
                phi_3134_ = _e1966;
            } else {
                let _e2236 = (f32((bitcast<i32>((_e1988[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2242 = (f32((bitcast<i32>(_e1988[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2246 = ((1f - abs(_e2236)) - abs(_e2242));
                if (_e2246 < 0f) {
                    phi_2958_ = -(_e2246);
                } else {
                    phi_2958_ = 0f;
                }
                let _e2250 = phi_2958_;
                if (_e2236 < 0f) {
                    phi_2965_ = (_e2236 + _e2250);
                } else {
                    phi_2965_ = (_e2236 - _e2250);
                }
                let _e2255 = phi_2965_;
                if (_e2242 < 0f) {
                    phi_2972_ = (_e2242 + _e2250);
                } else {
                    phi_2972_ = (_e2242 - _e2250);
                }
                let _e2260 = phi_2972_;
                let _e2267 = (1f / sqrt((((_e2255 * _e2255) + (_e2260 * _e2260)) + (_e2246 * _e2246))));
                let _e2283 = (f32((bitcast<i32>((_e1988[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2289 = (f32((bitcast<i32>(_e1988[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2293 = ((1f - abs(_e2283)) - abs(_e2289));
                if (_e2293 < 0f) {
                    phi_3007_ = -(_e2293);
                } else {
                    phi_3007_ = 0f;
                }
                let _e2297 = phi_3007_;
                if (_e2283 < 0f) {
                    phi_3014_ = (_e2283 + _e2297);
                } else {
                    phi_3014_ = (_e2283 - _e2297);
                }
                let _e2302 = phi_3014_;
                if (_e2289 < 0f) {
                    phi_3021_ = (_e2289 + _e2297);
                } else {
                    phi_3021_ = (_e2289 - _e2297);
                }
                let _e2307 = phi_3021_;
                let _e2314 = (1f / sqrt((((_e2302 * _e2302) + (_e2307 * _e2307)) + (_e2293 * _e2293))));
                let _e2333 = (f32((bitcast<i32>((_e1988[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2339 = (f32((bitcast<i32>(_e1988[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2343 = ((1f - abs(_e2333)) - abs(_e2339));
                if (_e2343 < 0f) {
                    phi_3059_ = -(_e2343);
                } else {
                    phi_3059_ = 0f;
                }
                let _e2347 = phi_3059_;
                if (_e2333 < 0f) {
                    phi_3066_ = (_e2333 + _e2347);
                } else {
                    phi_3066_ = (_e2333 - _e2347);
                }
                let _e2352 = phi_3066_;
                if (_e2339 < 0f) {
                    phi_3073_ = (_e2339 + _e2347);
                } else {
                    phi_3073_ = (_e2339 - _e2347);
                }
                let _e2357 = phi_3073_;
                let _e2364 = (1f / sqrt((((_e2352 * _e2352) + (_e2357 * _e2357)) + (_e2343 * _e2343))));
                let _e2375 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(vec3<f32>(((((_e2255 * _e2267) * _e1823) + ((_e2302 * _e2314) * _e1817.u)) + ((_e2352 * _e2364) * _e1817.v)), ((((_e2260 * _e2267) * _e1823) + ((_e2307 * _e2314) * _e1817.u)) + ((_e2357 * _e2364) * _e1817.v)), ((((_e2246 * _e2267) * _e1823) + ((_e2293 * _e2314) * _e1817.u)) + ((_e2343 * _e2364) * _e1817.v))));
                let _e2387 = sqrt((((_e2375.x * _e2375.x) + (_e2375.y * _e2375.y)) + (_e2375.z * _e2375.z)));
                if (_e2387 > 0f) {
                    let _e2390 = (_e2375.x / _e2387);
                    let _e2392 = (_e2375.y / _e2387);
                    let _e2394 = (_e2375.z / _e2387);
                    if ((((_e2390 * _e1966.x) + (_e2392 * _e1966.y)) + (_e2394 * _e1966.z)) < 0f) {
                        phi_3132_ = vec3<f32>(-(_e2390), -(_e2392), -(_e2394));
                    } else {
                        phi_3132_ = (_e2375 / vec3(_e2387));
                    }
                    let _e2411 = phi_3132_;
                    phi_3133_ = _e2411;
                } else {
                    phi_3133_ = _e1966;
                }
                let _e2413 = phi_3133_;
                phi_3134_ = _e2413;
            }
            let _e2415 = phi_3134_;
            if (_e2212 > 0f) {
                if (_e2212 < 1f) {
                    phi_3143_ = _e2212;
                } else {
                    phi_3143_ = 1f;
                }
                let _e2419 = phi_3143_;
                phi_3144_ = _e2419;
            } else {
                phi_3144_ = 0f;
            }
            let _e2421 = phi_3144_;
            if (_e2214 > 0f) {
                if (_e2214 < 1f) {
                    phi_3154_ = _e2214;
                } else {
                    phi_3154_ = 1f;
                }
                let _e2426 = phi_3154_;
                phi_3155_ = _e2426;
            } else {
                phi_3155_ = 0f;
            }
            let _e2428 = phi_3155_;
            if (_e2216 > 0f) {
                if (_e2216 < 1f) {
                    phi_3165_ = _e2216;
                } else {
                    phi_3165_ = 1f;
                }
                let _e2433 = phi_3165_;
                phi_3166_ = _e2433;
            } else {
                phi_3166_ = 0f;
            }
            let _e2435 = phi_3166_;
            let _e2438 = ((sqrt(_e2421) * 255f) + 0.5f);
            let _e2447 = ((sqrt(_e2428) * 255f) + 0.5f);
            let _e2459 = ((sqrt(_e2435) * 255f) + 0.5f);
            phi_3201_ = abi_Sample(vec3<f32>(_e1853, _e1854, _e1855), _e2218, _e1966, _e2223, _e2415, ((select(select(u32(_e2438), 0u, (_e2438 < bitcast<f32>(0u))), 4294967295u, (_e2438 > bitcast<f32>(1333788671u))) | (select(select(u32(_e2447), 0u, (_e2447 < bitcast<f32>(0u))), 4294967295u, (_e2447 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e2459), 0u, (_e2459 < bitcast<f32>(0u))), 4294967295u, (_e2459 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_3201_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e2473 = phi_3201_;
        if (_e102.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e102.first_primitive)] = _e2473;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_alpha_color_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
