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
var<storage> color_texels: type_13;
@group(0) @binding(7) 
var<storage> before: type_26;
@group(0) @binding(8) 
var<storage, read_write> past: type_26;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_mask_LightPlace {
    var phi_215_: lt_mask_LightPlace;
    var phi_216_: bool;
    var phi_217_: lt_mask_LightPlace;
    var phi_218_: bool;
    var phi_223_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_215_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_216_ = false;
        } else {
            phi_215_ = lt_mask_LightPlace();
            phi_216_ = true;
        }
        let _e84 = phi_215_;
        let _e86 = phi_216_;
        phi_217_ = _e84;
        phi_218_ = _e86;
    } else {
        phi_217_ = lt_mask_LightPlace();
        phi_218_ = true;
    }
    let _e88 = phi_217_;
    let _e90 = phi_218_;
    if _e90 {
        phi_223_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_223_ = _e88;
    }
    let _e95 = phi_223_;
    return lt_mask_LightPlace(_e95.word, _e95.shift);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_238_: bool;
    var phi_242_: f32;

    if (param_3 != param_3) {
        phi_238_ = true;
    } else {
        let _e74 = (param_4 >= param_3);
        if _e74 {
        }
        phi_238_ = _e74;
    }
    let _e76 = phi_238_;
    if _e76 {
        phi_242_ = param_4;
    } else {
        phi_242_ = param_3;
    }
    let _e78 = phi_242_;
    return _e78;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_254_: bool;
    var phi_258_: f32;

    if (param_5 != param_5) {
        phi_254_ = true;
    } else {
        let _e74 = (param_6 <= param_5);
        if _e74 {
        }
        phi_254_ = _e74;
    }
    let _e76 = phi_254_;
    if _e76 {
        phi_258_ = param_6;
    } else {
        phi_258_ = param_5;
    }
    let _e78 = phi_258_;
    return _e78;
}

fn _lt_shaders_texture_TextureView_quad(param_7: ptr<function, texture_TextureView>, param_8: f32, param_9: f32) -> texture_TexelQuad {
    var phi_300_: f32;
    var phi_305_: f32;
    var phi_306_: bool;
    var phi_307_: f32;
    var phi_308_: bool;
    var phi_312_: f32;
    var phi_338_: f32;
    var phi_343_: f32;
    var phi_344_: bool;
    var phi_345_: f32;
    var phi_346_: bool;
    var phi_350_: f32;
    var phi_358_: f32;
    var phi_359_: f32;
    var phi_360_: f32;
    var phi_369_: f32;
    var phi_370_: f32;
    var phi_388_: u32;
    var phi_402_: u32;
    var phi_409_: u32;
    var phi_414_: u32;
    var phi_420_: u32;
    var phi_425_: u32;
    var phi_427_: texture_Axis;
    var phi_455_: f32;
    var phi_460_: f32;
    var phi_461_: bool;
    var phi_462_: f32;
    var phi_463_: bool;
    var phi_467_: f32;
    var phi_493_: f32;
    var phi_498_: f32;
    var phi_499_: bool;
    var phi_500_: f32;
    var phi_501_: bool;
    var phi_505_: f32;
    var phi_513_: f32;
    var phi_514_: f32;
    var phi_515_: f32;
    var phi_524_: f32;
    var phi_525_: f32;
    var phi_543_: u32;
    var phi_557_: u32;
    var phi_564_: u32;
    var phi_569_: u32;
    var phi_575_: u32;
    var phi_580_: u32;
    var phi_582_: texture_Axis;

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
                phi_300_ = 1f;
            } else {
                phi_300_ = 0f;
            }
            let _e105 = phi_300_;
            if (param_8 < 8388608f) {
                phi_305_ = (_e102 - _e105);
                phi_306_ = false;
            } else {
                phi_305_ = f32();
                phi_306_ = true;
            }
            let _e108 = phi_305_;
            let _e110 = phi_306_;
            phi_307_ = _e108;
            phi_308_ = _e110;
        } else {
            phi_307_ = f32();
            phi_308_ = true;
        }
        let _e112 = phi_307_;
        let _e114 = phi_308_;
        if _e114 {
            phi_312_ = param_8;
        } else {
            phi_312_ = _e112;
        }
        let _e116 = phi_312_;
        phi_360_ = (param_8 - _e116);
    } else {
        if (_e89 == 1u) {
            let _e119 = (param_8 * 0.5f);
            if (_e119 > -8388608f) {
                let _e131 = f32(select(0i, select(select(i32(_e119), i32(-2147483648), (_e119 < bitcast<f32>(3472883712u))), 2147483647i, (_e119 > bitcast<f32>(1325400063u))), (_e119 == _e119)));
                if (_e131 > _e119) {
                    phi_338_ = 1f;
                } else {
                    phi_338_ = 0f;
                }
                let _e134 = phi_338_;
                if (_e119 < 8388608f) {
                    phi_343_ = (_e131 - _e134);
                    phi_344_ = false;
                } else {
                    phi_343_ = f32();
                    phi_344_ = true;
                }
                let _e137 = phi_343_;
                let _e139 = phi_344_;
                phi_345_ = _e137;
                phi_346_ = _e139;
            } else {
                phi_345_ = f32();
                phi_346_ = true;
            }
            let _e141 = phi_345_;
            let _e143 = phi_346_;
            if _e143 {
                phi_350_ = _e119;
            } else {
                phi_350_ = _e141;
            }
            let _e145 = phi_350_;
            let _e147 = (param_8 - (2f * _e145));
            if (_e147 > 1f) {
                phi_358_ = (2f - _e147);
            } else {
                phi_358_ = _e147;
            }
            let _e151 = phi_358_;
            phi_359_ = _e151;
        } else {
            phi_359_ = param_8;
        }
        let _e153 = phi_359_;
        phi_360_ = _e153;
    }
    let _e155 = phi_360_;
    if (_e155 > 0f) {
        if (_e155 < 1f) {
            phi_369_ = _e155;
        } else {
            phi_369_ = 1f;
        }
        let _e159 = phi_369_;
        phi_370_ = _e159;
    } else {
        phi_370_ = 0f;
    }
    let _e161 = phi_370_;
    let _e162 = (_e76 - 1u);
    let _e164 = (_e161 * f32(_e76));
    if _e84 {
        let _e171 = select(select(u32(_e164), 0u, (_e164 < bitcast<f32>(0u))), 4294967295u, (_e164 > bitcast<f32>(1333788671u)));
        if (_e162 < _e171) {
            phi_388_ = _e162;
        } else {
            phi_388_ = _e171;
        }
        let _e174 = phi_388_;
        phi_427_ = texture_Axis(_e174, _e174, 0f);
    } else {
        let _e176 = (_e164 + 0.5f);
        let _e183 = select(select(u32(_e176), 0u, (_e176 < bitcast<f32>(0u))), 4294967295u, (_e176 > bitcast<f32>(1333788671u)));
        if (_e76 < _e183) {
            phi_402_ = _e76;
        } else {
            phi_402_ = _e183;
        }
        let _e186 = phi_402_;
        if (_e89 == 0u) {
            phi_409_ = _e162;
        } else {
            phi_409_ = 0u;
        }
        let _e191 = phi_409_;
        if (_e89 == 0u) {
            phi_414_ = 0u;
        } else {
            phi_414_ = _e162;
        }
        let _e194 = phi_414_;
        if (_e186 == 0u) {
            phi_420_ = _e191;
        } else {
            phi_420_ = (_e186 - 1u);
        }
        let _e198 = phi_420_;
        if (_e186 > _e162) {
            phi_425_ = _e194;
        } else {
            phi_425_ = _e186;
        }
        let _e201 = phi_425_;
        phi_427_ = texture_Axis(_e198, _e201, (_e176 - f32(_e186)));
    }
    let _e204 = phi_427_;
    let _e206 = (*param_7).flags;
    let _e209 = ((_e206 >> bitcast<u32>(6u)) & 3u);
    if (_e209 == 0u) {
        if (param_9 > -8388608f) {
            let _e222 = f32(select(0i, select(select(i32(param_9), i32(-2147483648), (param_9 < bitcast<f32>(3472883712u))), 2147483647i, (param_9 > bitcast<f32>(1325400063u))), (param_9 == param_9)));
            if (_e222 > param_9) {
                phi_455_ = 1f;
            } else {
                phi_455_ = 0f;
            }
            let _e225 = phi_455_;
            if (param_9 < 8388608f) {
                phi_460_ = (_e222 - _e225);
                phi_461_ = false;
            } else {
                phi_460_ = f32();
                phi_461_ = true;
            }
            let _e228 = phi_460_;
            let _e230 = phi_461_;
            phi_462_ = _e228;
            phi_463_ = _e230;
        } else {
            phi_462_ = f32();
            phi_463_ = true;
        }
        let _e232 = phi_462_;
        let _e234 = phi_463_;
        if _e234 {
            phi_467_ = param_9;
        } else {
            phi_467_ = _e232;
        }
        let _e236 = phi_467_;
        phi_515_ = (param_9 - _e236);
    } else {
        if (_e209 == 1u) {
            let _e239 = (param_9 * 0.5f);
            if (_e239 > -8388608f) {
                let _e251 = f32(select(0i, select(select(i32(_e239), i32(-2147483648), (_e239 < bitcast<f32>(3472883712u))), 2147483647i, (_e239 > bitcast<f32>(1325400063u))), (_e239 == _e239)));
                if (_e251 > _e239) {
                    phi_493_ = 1f;
                } else {
                    phi_493_ = 0f;
                }
                let _e254 = phi_493_;
                if (_e239 < 8388608f) {
                    phi_498_ = (_e251 - _e254);
                    phi_499_ = false;
                } else {
                    phi_498_ = f32();
                    phi_499_ = true;
                }
                let _e257 = phi_498_;
                let _e259 = phi_499_;
                phi_500_ = _e257;
                phi_501_ = _e259;
            } else {
                phi_500_ = f32();
                phi_501_ = true;
            }
            let _e261 = phi_500_;
            let _e263 = phi_501_;
            if _e263 {
                phi_505_ = _e239;
            } else {
                phi_505_ = _e261;
            }
            let _e265 = phi_505_;
            let _e267 = (param_9 - (2f * _e265));
            if (_e267 > 1f) {
                phi_513_ = (2f - _e267);
            } else {
                phi_513_ = _e267;
            }
            let _e271 = phi_513_;
            phi_514_ = _e271;
        } else {
            phi_514_ = param_9;
        }
        let _e273 = phi_514_;
        phi_515_ = _e273;
    }
    let _e275 = phi_515_;
    if (_e275 > 0f) {
        if (_e275 < 1f) {
            phi_524_ = _e275;
        } else {
            phi_524_ = 1f;
        }
        let _e279 = phi_524_;
        phi_525_ = _e279;
    } else {
        phi_525_ = 0f;
    }
    let _e281 = phi_525_;
    let _e282 = (_e80 - 1u);
    let _e284 = (_e281 * f32(_e80));
    if _e84 {
        let _e291 = select(select(u32(_e284), 0u, (_e284 < bitcast<f32>(0u))), 4294967295u, (_e284 > bitcast<f32>(1333788671u)));
        if (_e282 < _e291) {
            phi_543_ = _e282;
        } else {
            phi_543_ = _e291;
        }
        let _e294 = phi_543_;
        phi_582_ = texture_Axis(_e294, _e294, 0f);
    } else {
        let _e296 = (_e284 + 0.5f);
        let _e303 = select(select(u32(_e296), 0u, (_e296 < bitcast<f32>(0u))), 4294967295u, (_e296 > bitcast<f32>(1333788671u)));
        if (_e80 < _e303) {
            phi_557_ = _e80;
        } else {
            phi_557_ = _e303;
        }
        let _e306 = phi_557_;
        if (_e209 == 0u) {
            phi_564_ = _e282;
        } else {
            phi_564_ = 0u;
        }
        let _e311 = phi_564_;
        if (_e209 == 0u) {
            phi_569_ = 0u;
        } else {
            phi_569_ = _e282;
        }
        let _e314 = phi_569_;
        if (_e306 == 0u) {
            phi_575_ = _e311;
        } else {
            phi_575_ = (_e306 - 1u);
        }
        let _e318 = phi_575_;
        if (_e306 > _e282) {
            phi_580_ = _e314;
        } else {
            phi_580_ = _e306;
        }
        let _e321 = phi_580_;
        phi_582_ = texture_Axis(_e318, _e321, (_e296 - f32(_e306)));
    }
    let _e324 = phi_582_;
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
    var phi_641_: f32;

    if (param_12 > param_13) {
        phi_641_ = param_12;
    } else {
        phi_641_ = param_13;
    }
    let _e75 = phi_641_;
    return _e75;
}

fn _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(param_14: vec3<f32>) -> vec3<f32> {
    return param_14;
}

fn _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(param_15: vec3<f32>) -> vec3<f32> {
    return param_15;
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var phi_781_: bool;
    var phi_782_: bool;
    var phi_783_: bool;
    var phi_784_: bool;
    var phi_788_: bool;
    var phi_801_: bool;
    var phi_802_: bool;
    var phi_803_: bool;
    var phi_804_: bool;
    var phi_808_: bool;
    var phi_821_: bool;
    var phi_822_: bool;
    var phi_823_: bool;
    var phi_827_: bool;
    var phi_828_: bool;
    var phi_829_: bool;
    var phi_830_: bool;
    var phi_831_: bool;
    var phi_835_: bool;
    var phi_911_: f32;
    var phi_918_: f32;
    var phi_926_: f32;
    var phi_933_: f32;
    var phi_941_: f32;
    var phi_948_: f32;
    var phi_971_: f32;
    var phi_976_: f32;
    var phi_981_: f32;
    var phi_986_: f32;
    var phi_991_: f32;
    var phi_1022_: bool;
    var phi_1023_: bool;
    var phi_1031_: u32;
    var phi_1032_: u32;
    var phi_1049_: vec3<f32>;
    var phi_1050_: vec3<f32>;
    var phi_1063_: u32;
    var phi_1068_: u32;
    var phi_1073_: u32;
    var phi_1187_: bool;
    var phi_1188_: bool;
    var phi_1219_: u32;
    var phi_1221_: lt_bvh_Hit;
    var phi_1224_: u32;
    var phi_1309_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1336_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1363_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1369_: u32;
    var phi_1372_: u32;
    var phi_1386_: u32;
    var phi_1396_: u32;
    var phi_1406_: u32;
    var phi_1424_: u32;
    var phi_1434_: u32;
    var phi_1444_: u32;
    var phi_1480_: u32;
    var phi_1493_: u32;
    var phi_1498_: u32;
    var phi_1499_: u32;
    var phi_1500_: u32;
    var phi_1370_: u32;
    var phi_1373_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_1558_: lt_bvh_Hit;
    var phi_1561_: u32;
    var phi_1607_: vec3<f32>;
    var phi_1608_: vec3<f32>;
    var phi_1639_: vec3<f32>;
    var phi_1640_: vec3<f32>;
    var phi_1671_: vec3<f32>;
    var phi_1672_: vec3<f32>;
    var phi_1690_: bool;
    var phi_1691_: bool;
    var phi_1695_: f32;
    var phi_1696_: f32;
    var phi_1697_: f32;
    var phi_1698_: f32;
    var phi_1706_: f32;
    var phi_1716_: bool;
    var phi_1717_: bool;
    var phi_1721_: f32;
    var phi_1722_: f32;
    var phi_1723_: f32;
    var phi_1724_: f32;
    var phi_1732_: f32;
    var phi_1742_: bool;
    var phi_1743_: bool;
    var phi_1747_: f32;
    var phi_1748_: f32;
    var phi_1749_: f32;
    var phi_1750_: f32;
    var phi_1758_: f32;
    var phi_1773_: f32;
    var phi_1774_: bool;
    var phi_1775_: f32;
    var phi_1776_: bool;
    var phi_1777_: f32;
    var phi_1778_: bool;
    var phi_1796_: f32;
    var phi_1797_: bool;
    var phi_1798_: bool;
    var phi_1799_: f32;
    var phi_1800_: bool;
    var phi_1801_: bool;
    var phi_1805_: bool;
    var phi_1806_: f32;
    var phi_1807_: bool;
    var phi_1837_: vec3<f32>;
    var phi_1838_: vec3<f32>;
    var phi_1863_: vec3<f32>;
    var phi_1864_: vec3<f32>;
    var phi_1889_: vec3<f32>;
    var phi_1890_: vec3<f32>;
    var phi_1948_: f32;
    var phi_1957_: f32;
    var phi_1966_: f32;
    var phi_1975_: f32;
    var phi_1982_: f32;
    var phi_1989_: f32;
    var phi_2002_: f32;
    var phi_2011_: f32;
    var phi_2020_: f32;
    var phi_2029_: f32;
    var phi_2036_: f32;
    var phi_2043_: f32;
    var phi_2066_: f32;
    var phi_2071_: f32;
    var phi_2076_: f32;
    var phi_2084_: f32;
    var phi_2089_: f32;
    var phi_2094_: f32;
    var phi_2106_: f32;
    var phi_2111_: f32;
    var phi_2116_: f32;
    var phi_2121_: f32;
    var phi_2126_: lt_bvh_triangle_Intersection;
    var phi_2127_: bool;
    var phi_2128_: lt_bvh_triangle_Intersection;
    var phi_2129_: bool;
    var phi_2133_: lt_bvh_triangle_Intersection;
    var phi_2134_: bool;
    var phi_2135_: lt_bvh_triangle_Intersection;
    var phi_2136_: bool;
    var phi_2137_: bool;
    var phi_2141_: bool;
    var phi_2145_: lt_bvh_triangle_Intersection;
    var phi_2184_: bool;
    var phi_2185_: bool;
    var phi_2186_: bool;
    var phi_2187_: bool;
    var phi_2188_: bool;
    var phi_2189_: bool;
    var phi_2193_: bool;
    var phi_2194_: bool;
    var phi_2208_: bool;
    var phi_2216_: lt_bvh_Hit;
    var phi_2217_: lt_bvh_Hit;
    var phi_2218_: lt_bvh_Hit;
    var phi_2219_: lt_bvh_Hit;
    var phi_1559_: lt_bvh_Hit;
    var phi_1562_: u32;
    var phi_2220_: bool;
    var phi_2259_: bool;
    var phi_2260_: bool;
    var phi_2291_: u32;
    var phi_1222_: lt_bvh_Hit;
    var phi_1225_: u32;
    var phi_2292_: lt_bvh_Hit;
    var phi_2293_: lt_bvh_Hit;
    var phi_2294_: bool;
    var phi_2298_: lt_bvh_Hit;
    var phi_2362_: f32;
    var phi_2367_: f32;
    var phi_2372_: f32;
    var phi_2383_: f32;
    var phi_2388_: f32;
    var phi_2393_: f32;
    var phi_2469_: vec3<f32>;
    var phi_2712_: vec3<f32>;
    var phi_2727_: u32;
    var phi_2754_: f32;
    var phi_2761_: f32;
    var phi_2768_: f32;
    var phi_2803_: f32;
    var phi_2810_: f32;
    var phi_2817_: f32;
    var phi_2855_: f32;
    var phi_2862_: f32;
    var phi_2869_: f32;
    var phi_2928_: vec3<f32>;
    var phi_2929_: vec3<f32>;
    var phi_2930_: vec3<f32>;
    var phi_2939_: f32;
    var phi_2940_: f32;
    var phi_2950_: f32;
    var phi_2951_: f32;
    var phi_2961_: f32;
    var phi_2962_: f32;
    var phi_2997_: abi_Sample;
    var phi_3088_: vec3<f32>;
    var local_5: lt_bvh_Hit;
    var local_6: lt_bvh_Hit;

    let _e73 = id_1;
    let _e77 = arrayLength((&nodes.member));
    let _e80 = arrayLength((&triangles.member));
    let _e83 = arrayLength((&vertices.member));
    let _e92 = arrayLength((&color_texels.member));
    let _e95 = arrayLength((&before.member));
    let _e101 = p.member.size[0u];
    let _e103 = p.member.size[1u];
    let _e104 = lt_shaders_entry_pixel_index(_e73, _e101, _e103);
    if (bitcast<i32>(_e104.word) != 0i) {
        let _e112 = p.member.eye;
        let _e115 = p.member.grid[0u];
        let _e117 = p.member.grid[1u];
        let _e136 = p.member.size[0u];
        let _e140 = ((((f32(_e73.x) + ((f32((_e73.y & (_e117 - 1u))) + 0.5f) / f32(_e117))) / f32(_e136)) * 2f) - 1f);
        let _e143 = p.member.size[1u];
        let _e147 = (1f - (((f32(_e73.y) + ((f32((_e73.x & (_e115 - 1u))) + 0.5f) / f32(_e115))) / f32(_e143)) * 2f));
        let _e149 = p.member.forward;
        let _e151 = p.member.right;
        let _e165 = p.member.up;
        let _e176 = _lt_bvh_ray_Ray_new(_e112, vec3<f32>(((_e149.x + (_e151.x * _e140)) + (_e165.x * _e147)), ((_e149.y + (_e151.y * _e140)) + (_e165.y * _e147)), ((_e149.z + (_e151.z * _e140)) + (_e165.z * _e147))));
        let _e178 = lt_bvh_Hit(_e176.tmax, 0f, 0f, 4294967295u, 4294967295u);
        let _e181 = abs(_e176.direction.x);
        let _e183 = abs(_e176.direction.y);
        let _e185 = abs(_e176.direction.z);
        if (abs(_e176.origin.x) < 1000000000000000f) {
            if (abs(_e176.origin.y) < 1000000000000000f) {
                phi_781_ = (abs(_e176.origin.z) < 1000000000000000f);
                phi_782_ = false;
            } else {
                phi_781_ = bool();
                phi_782_ = true;
            }
            let _e197 = phi_781_;
            let _e199 = phi_782_;
            phi_783_ = _e197;
            phi_784_ = _e199;
        } else {
            phi_783_ = bool();
            phi_784_ = true;
        }
        let _e201 = phi_783_;
        let _e203 = phi_784_;
        if _e203 {
            phi_788_ = false;
        } else {
            phi_788_ = _e201;
        }
        let _e205 = phi_788_;
        if _e205 {
            if (_e181 < 1000000000000000f) {
                if (_e183 < 1000000000000000f) {
                    phi_801_ = (_e185 < 1000000000000000f);
                    phi_802_ = false;
                } else {
                    phi_801_ = bool();
                    phi_802_ = true;
                }
                let _e210 = phi_801_;
                let _e212 = phi_802_;
                phi_803_ = _e210;
                phi_804_ = _e212;
            } else {
                phi_803_ = bool();
                phi_804_ = true;
            }
            let _e214 = phi_803_;
            let _e216 = phi_804_;
            if _e216 {
                phi_808_ = false;
            } else {
                phi_808_ = _e214;
            }
            let _e218 = phi_808_;
            if _e218 {
                if (_e181 > 0f) {
                    phi_822_ = bool();
                    phi_823_ = true;
                } else {
                    let _e220 = (_e183 > 0f);
                    if _e220 {
                        phi_821_ = bool();
                    } else {
                        phi_821_ = (_e185 > 0f);
                    }
                    let _e223 = phi_821_;
                    phi_822_ = _e223;
                    phi_823_ = _e220;
                }
                let _e225 = phi_822_;
                let _e227 = phi_823_;
                if _e227 {
                    phi_827_ = true;
                } else {
                    phi_827_ = _e225;
                }
                let _e229 = phi_827_;
                phi_828_ = _e229;
                phi_829_ = false;
            } else {
                phi_828_ = bool();
                phi_829_ = true;
            }
            let _e231 = phi_828_;
            let _e233 = phi_829_;
            phi_830_ = _e231;
            phi_831_ = _e233;
        } else {
            phi_830_ = bool();
            phi_831_ = true;
        }
        let _e235 = phi_830_;
        let _e237 = phi_831_;
        if _e237 {
            phi_835_ = false;
        } else {
            phi_835_ = _e235;
        }
        let _e239 = phi_835_;
        if _e239 {
            let _e240 = (0u >= _e77);
            if _e240 {
                phi_2292_ = lt_bvh_Hit();
            } else {
                if (0u < _e77) {
                } else {
                    return;
                }
                let _e246 = nodes.member[(0u + 0u)].frame[0u];
                let _e250 = nodes.member[(0u + 0u)].frame[1u];
                let _e254 = nodes.member[(0u + 0u)].frame[2u];
                let _e258 = nodes.member[(0u + 0u)].frame[0u];
                let _e262 = nodes.member[(0u + 0u)].frame[1u];
                let _e266 = nodes.member[(0u + 0u)].frame[2u];
                let _e270 = nodes.member[(0u + 0u)].frame[3u];
                let _e309 = core_intrinsics_maximum_number_nsz_f32_(abs(_e176.direction.x), abs(_e176.direction.y));
                let _e310 = core_intrinsics_maximum_number_nsz_f32_(_e309, abs(_e176.direction.z));
                let _e311 = (_e310 * 0.0000000000009094947f);
                if (abs(_e176.direction.x) < _e311) {
                    phi_911_ = _e311;
                } else {
                    phi_911_ = abs(_e176.direction.x);
                }
                let _e317 = phi_911_;
                if (_e176.direction.x < 0f) {
                    phi_918_ = (-1f / _e317);
                } else {
                    phi_918_ = (1f / _e317);
                }
                let _e322 = phi_918_;
                if (abs(_e176.direction.y) < _e311) {
                    phi_926_ = _e311;
                } else {
                    phi_926_ = abs(_e176.direction.y);
                }
                let _e328 = phi_926_;
                if (_e176.direction.y < 0f) {
                    phi_933_ = (-1f / _e328);
                } else {
                    phi_933_ = (1f / _e328);
                }
                let _e333 = phi_933_;
                if (abs(_e176.direction.z) < _e311) {
                    phi_941_ = _e311;
                } else {
                    phi_941_ = abs(_e176.direction.z);
                }
                let _e339 = phi_941_;
                if (_e176.direction.z < 0f) {
                    phi_948_ = (-1f / _e339);
                } else {
                    phi_948_ = (1f / _e339);
                }
                let _e344 = phi_948_;
                let _e351 = abs((bitcast<f32>(_e246) - _e176.origin.x));
                let _e352 = abs((bitcast<f32>(_e250) - _e176.origin.y));
                let _e353 = abs((bitcast<f32>(_e254) - _e176.origin.z));
                let _e360 = abs(((bitcast<f32>(_e258) + (bitcast<f32>((((_e270 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e176.origin.x));
                let _e361 = abs(((bitcast<f32>(_e262) + (bitcast<f32>((((_e270 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e176.origin.y));
                let _e362 = abs(((bitcast<f32>(_e266) + (bitcast<f32>((((_e270 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e176.origin.z));
                if (_e351 > _e360) {
                    phi_971_ = _e351;
                } else {
                    phi_971_ = _e360;
                }
                let _e365 = phi_971_;
                if (_e352 > _e361) {
                    phi_976_ = _e352;
                } else {
                    phi_976_ = _e361;
                }
                let _e368 = phi_976_;
                if (_e353 > _e362) {
                    phi_981_ = _e353;
                } else {
                    phi_981_ = _e362;
                }
                let _e371 = phi_981_;
                if (_e365 > _e368) {
                    phi_986_ = _e365;
                } else {
                    phi_986_ = _e368;
                }
                let _e374 = phi_986_;
                if (_e374 > _e371) {
                    phi_991_ = _e374;
                } else {
                    phi_991_ = _e371;
                }
                let _e377 = phi_991_;
                let _e381 = (_e377 * 0.0000019073486f);
                let _e382 = (abs(_e322) * _e381);
                let _e383 = (abs(_e333) * _e381);
                let _e384 = (abs(_e344) * _e381);
                let _e388 = (_e377 * 0.0000009536743f);
                let _e389 = (abs(_e322) * _e388);
                let _e390 = (abs(_e333) * _e388);
                let _e391 = (abs(_e344) * _e388);
                let _e395 = abs(_e176.direction.x);
                let _e397 = abs(_e176.direction.y);
                let _e399 = abs(_e176.direction.z);
                if (_e395 >= _e397) {
                    if (_e395 >= _e399) {
                        phi_1022_ = false;
                    } else {
                        phi_1022_ = true;
                    }
                    let _e403 = phi_1022_;
                    phi_1023_ = _e403;
                } else {
                    phi_1023_ = true;
                }
                let _e405 = phi_1023_;
                if _e405 {
                    if (_e397 >= _e399) {
                        phi_1031_ = 1u;
                    } else {
                        phi_1031_ = 2u;
                    }
                    let _e408 = phi_1031_;
                    phi_1032_ = _e408;
                } else {
                    phi_1032_ = 0u;
                }
                let _e410 = phi_1032_;
                if (_e410 == 0u) {
                    phi_1050_ = vec3<f32>(_e176.direction.y, _e176.direction.z, _e176.direction.x);
                } else {
                    if (_e410 == 1u) {
                        phi_1049_ = vec3<f32>(_e176.direction.z, _e176.direction.x, _e176.direction.y);
                    } else {
                        phi_1049_ = _e176.direction;
                    }
                    let _e422 = phi_1049_;
                    phi_1050_ = _e422;
                }
                let _e424 = phi_1050_;
                let _e427 = (_e424.x / _e424.z);
                let _e430 = (_e424.y / _e424.z);
                if (_e322 < 0f) {
                    phi_1063_ = 0u;
                } else {
                    phi_1063_ = 1u;
                }
                let _e435 = phi_1063_;
                if (_e333 < 0f) {
                    phi_1068_ = 0u;
                } else {
                    phi_1068_ = 2u;
                }
                let _e438 = phi_1068_;
                if (_e344 < 0f) {
                    phi_1073_ = 0u;
                } else {
                    phi_1073_ = 4u;
                }
                let _e441 = phi_1073_;
                let _e443 = ((_e435 | _e438) | _e441);
                let _e444 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e444.first[0], _e444.first[1], _e444.first[2], _e444.first[3], _e444.first[4], _e444.first[5], _e444.first[6], _e444.first[7], _e444.first[8], _e444.first[9], _e444.first[10], _e444.first[11], _e444.first[12], _e444.first[13], _e444.first[14], _e444.first[15], _e444.first[16], _e444.first[17], _e444.first[18], _e444.first[19], _e444.first[20], _e444.first[21], _e444.first[22], _e444.first[23], _e444.first[24], _e444.first[25], _e444.first[26], _e444.first[27], _e444.first[28], _e444.first[29], _e444.first[30], _e444.first[31]), array<u32, 32>(_e444.mask[0], _e444.mask[1], _e444.mask[2], _e444.mask[3], _e444.mask[4], _e444.mask[5], _e444.mask[6], _e444.mask[7], _e444.mask[8], _e444.mask[9], _e444.mask[10], _e444.mask[11], _e444.mask[12], _e444.mask[13], _e444.mask[14], _e444.mask[15], _e444.mask[16], _e444.mask[17], _e444.mask[18], _e444.mask[19], _e444.mask[20], _e444.mask[21], _e444.mask[22], _e444.mask[23], _e444.mask[24], _e444.mask[25], _e444.mask[26], _e444.mask[27], _e444.mask[28], _e444.mask[29], _e444.mask[30], _e444.mask[31]), _e444.len, _e444.group, _e444.group_mask);
                let _e518 = local_1.group_mask;
                if ((_e518 & 4278190080u) == 0u) {
                    let _e522 = local_1.len;
                    if (_e522 == 0u) {
                        phi_1187_ = false;
                    } else {
                        let _e526 = local_1.len;
                        local_1.len = (_e526 - 1u);
                        let _e529 = local_1.len;
                        if (_e529 < 32u) {
                        } else {
                            return;
                        }
                        let _e534 = local_1.first[(0u + _e529)];
                        local_1.group = _e534;
                        let _e537 = local_1.len;
                        if (_e537 < 32u) {
                        } else {
                            return;
                        }
                        let _e542 = local_1.mask[(0u + _e537)];
                        local_1.group_mask = _e542;
                        phi_1187_ = true;
                    }
                    let _e545 = phi_1187_;
                    phi_1188_ = _e545;
                } else {
                    phi_1188_ = true;
                }
                let _e547 = phi_1188_;
                if _e547 {
                    let _e549 = local_1.group_mask;
                    let _e555 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e549)), 32u, (_e549 == 0u)));
                    let _e559 = local_1.group_mask;
                    let _e573 = local_1.group_mask;
                    local_1.group_mask = (_e573 & ~((1u << bitcast<u32>((_e555 & 31u)))));
                    let _e576 = local_1.group;
                    phi_1219_ = (_e576 + countOneBits(((_e559 & ~((4294967295u << bitcast<u32>((((_e555 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1219_ = 4294967295u;
                }
                let _e579 = phi_1219_;
                phi_1221_ = _e178;
                phi_1224_ = _e579;
                loop {
                    let _e581 = phi_1221_;
                    let _e583 = phi_1224_;
                    local_6 = _e581;
                    let _e584 = (_e583 != 4294967295u);
                    if _e584 {
                        if (_e583 < _e77) {
                        } else {
                            return;
                        }
                        let _e592 = nodes.member[(0u + _e583)].frame[3u];
                        let _e617 = (bitcast<f32>((((_e592 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e322);
                        let _e618 = (bitcast<f32>((((_e592 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e333);
                        let _e619 = (bitcast<f32>((((_e592 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e344);
                        let _e622 = nodes.member[(0u + _e583)].frame[0u];
                        let _e626 = nodes.member[(0u + _e583)].frame[1u];
                        let _e630 = nodes.member[(0u + _e583)].frame[2u];
                        let _e638 = ((bitcast<f32>(_e622) - _e176.origin.x) * _e322);
                        let _e639 = ((bitcast<f32>(_e626) - _e176.origin.y) * _e333);
                        let _e640 = ((bitcast<f32>(_e630) - _e176.origin.z) * _e344);
                        let _e648 = nodes.member[(0u + _e583)].x;
                        if (_e322 < 0f) {
                            let _e659 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e648.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e665 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e659.unnamed.word, _e648.w), _e659.unnamed_1);
                            let _e671 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e665.unnamed, lt_mask_LightPlace(_e648.x, _e665.unnamed_1.shift));
                            phi_1309_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e671.unnamed, lt_mask_LightPlace(_e671.unnamed_1.word, _e648.y));
                        } else {
                            let _e687 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e648.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e693 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e687.unnamed.word, _e648.y), _e687.unnamed_1);
                            let _e699 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e693.unnamed, lt_mask_LightPlace(_e648.z, _e693.unnamed_1.shift));
                            phi_1309_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e699.unnamed, lt_mask_LightPlace(_e699.unnamed_1.word, _e648.w));
                        }
                        let _e707 = phi_1309_;
                        let _e717 = nodes.member[(0u + _e583)].y;
                        if (_e333 < 0f) {
                            let _e728 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e717.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e734 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e728.unnamed.word, _e717.w), _e728.unnamed_1);
                            let _e740 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e734.unnamed, lt_mask_LightPlace(_e717.x, _e734.unnamed_1.shift));
                            phi_1336_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e740.unnamed, lt_mask_LightPlace(_e740.unnamed_1.word, _e717.y));
                        } else {
                            let _e756 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e717.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e762 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e756.unnamed.word, _e717.y), _e756.unnamed_1);
                            let _e768 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e762.unnamed, lt_mask_LightPlace(_e717.z, _e762.unnamed_1.shift));
                            phi_1336_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e768.unnamed, lt_mask_LightPlace(_e768.unnamed_1.word, _e717.w));
                        }
                        let _e776 = phi_1336_;
                        let _e786 = nodes.member[(0u + _e583)].z;
                        if (_e344 < 0f) {
                            let _e797 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e786.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e803 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e797.unnamed.word, _e786.w), _e797.unnamed_1);
                            let _e809 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e803.unnamed, lt_mask_LightPlace(_e786.x, _e803.unnamed_1.shift));
                            phi_1363_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e809.unnamed, lt_mask_LightPlace(_e809.unnamed_1.word, _e786.y));
                        } else {
                            let _e825 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e786.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e831 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e825.unnamed.word, _e786.y), _e825.unnamed_1);
                            let _e837 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e831.unnamed, lt_mask_LightPlace(_e786.z, _e831.unnamed_1.shift));
                            phi_1363_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e837.unnamed, lt_mask_LightPlace(_e837.unnamed_1.word, _e786.w));
                        }
                        let _e845 = phi_1363_;
                        phi_1369_ = 0u;
                        phi_1372_ = 0u;
                        loop {
                            let _e855 = phi_1369_;
                            let _e857 = phi_1372_;
                            local_2 = _e857;
                            local_3 = _e857;
                            local_4 = _e857;
                            let _e858 = (_e855 < 8u);
                            if _e858 {
                                let _e860 = (_e855 >> bitcast<u32>(2i));
                                let _e861 = (_e855 & 3u);
                                if (_e860 == 0u) {
                                    phi_1386_ = _e707.unnamed.word;
                                } else {
                                    phi_1386_ = _e707.unnamed.shift;
                                }
                                let _e864 = phi_1386_;
                                if (_e860 == 0u) {
                                    phi_1396_ = _e776.unnamed.word;
                                } else {
                                    phi_1396_ = _e776.unnamed.shift;
                                }
                                let _e873 = phi_1396_;
                                if (_e860 == 0u) {
                                    phi_1406_ = _e845.unnamed.word;
                                } else {
                                    phi_1406_ = _e845.unnamed.shift;
                                }
                                let _e882 = phi_1406_;
                                let _e895 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e864 >> bitcast<u32>(((_e861 * 8u) & 31u))) & 255u)) * _e617) + (_e638 - _e382)), ((f32(((_e873 >> bitcast<u32>(((_e861 * 8u) & 31u))) & 255u)) * _e618) + (_e639 - _e383)));
                                let _e896 = core_intrinsics_maximum_number_nsz_f32_(_e895, ((f32(((_e882 >> bitcast<u32>(((_e861 * 8u) & 31u))) & 255u)) * _e619) + (_e640 - _e384)));
                                if (_e860 == 0u) {
                                    phi_1424_ = _e707.unnamed_1.word;
                                } else {
                                    phi_1424_ = _e707.unnamed_1.shift;
                                }
                                let _e899 = phi_1424_;
                                if (_e860 == 0u) {
                                    phi_1434_ = _e776.unnamed_1.word;
                                } else {
                                    phi_1434_ = _e776.unnamed_1.shift;
                                }
                                let _e908 = phi_1434_;
                                if (_e860 == 0u) {
                                    phi_1444_ = _e845.unnamed_1.word;
                                } else {
                                    phi_1444_ = _e845.unnamed_1.shift;
                                }
                                let _e917 = phi_1444_;
                                let _e930 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e899 >> bitcast<u32>(((_e861 * 8u) & 31u))) & 255u)) * _e617) + (_e638 + _e382)), ((f32(((_e908 >> bitcast<u32>(((_e861 * 8u) & 31u))) & 255u)) * _e618) + (_e639 + _e383)));
                                let _e931 = core_intrinsics_minimum_number_nsz_f32_(_e930, ((f32(((_e917 >> bitcast<u32>(((_e861 * 8u) & 31u))) & 255u)) * _e619) + (_e640 + _e384)));
                                if (_e896 <= _e931) {
                                    if (_e896 <= _e581.t) {
                                        if (_e931 >= _e176.tmin) {
                                            if (_e860 == 0u) {
                                                let _e938 = nodes.member[(0u + _e583)].links[2u];
                                                phi_1480_ = _e938;
                                            } else {
                                                let _e941 = nodes.member[(0u + _e583)].links[3u];
                                                phi_1480_ = _e941;
                                            }
                                            let _e943 = phi_1480_;
                                            let _e948 = ((_e943 >> bitcast<u32>(((_e861 * 8u) & 31u))) & 255u);
                                            let _e949 = (_e948 & 31u);
                                            if (_e949 >= 24u) {
                                                phi_1493_ = (24u + ((_e949 - 24u) ^ _e443));
                                            } else {
                                                phi_1493_ = _e949;
                                            }
                                            let _e955 = phi_1493_;
                                            phi_1498_ = (_e857 | ((_e948 >> bitcast<u32>(5i)) << bitcast<u32>((_e955 & 31u))));
                                        } else {
                                            phi_1498_ = _e857;
                                        }
                                        let _e963 = phi_1498_;
                                        phi_1499_ = _e963;
                                    } else {
                                        phi_1499_ = _e857;
                                    }
                                    let _e965 = phi_1499_;
                                    phi_1500_ = _e965;
                                } else {
                                    phi_1500_ = _e857;
                                }
                                let _e967 = phi_1500_;
                                phi_1370_ = (_e855 + 1u);
                                phi_1373_ = _e967;
                            } else {
                                phi_1370_ = u32();
                                phi_1373_ = u32();
                            }
                            let _e970 = phi_1370_;
                            let _e972 = phi_1373_;
                            continue;
                            continuing {
                                phi_1369_ = _e970;
                                phi_1372_ = _e972;
                                break if !(_e858);
                            }
                        }
                        let _e976 = nodes.member[(0u + _e583)].links[0u];
                        let _e980 = nodes.member[(0u + _e583)].frame[3u];
                        let _e984 = local_2;
                        if ((_e984 & 4278190080u) == 0u) {
                        } else {
                            let _e988 = local_1.group_mask;
                            if ((_e988 & 4278190080u) == 0u) {
                            } else {
                                let _e992 = local_1.len;
                                if (_e992 < 32u) {
                                    let _e995 = local_1.group;
                                    let _e997 = local_1.len;
                                    if (_e997 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.first[(0u + _e997)] = _e995;
                                    let _e1003 = local_1.group_mask;
                                    let _e1005 = local_1.len;
                                    if (_e1005 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.mask[(0u + _e1005)] = _e1003;
                                    let _e1012 = local_1.len;
                                    local_1.len = (_e1012 + 1u);
                                }
                            }
                            local_1.group = (0u + _e976);
                            let _e1016 = local_3;
                            local_1.group_mask = ((_e1016 & 4278190080u) | (_e980 >> bitcast<u32>(24i)));
                        }
                        let _e1021 = local_4;
                        phi_1558_ = _e581;
                        phi_1561_ = (_e1021 & 16777215u);
                        loop {
                            let _e1024 = phi_1558_;
                            let _e1026 = phi_1561_;
                            local_5 = _e1024;
                            if (_e1026 == 0u) {
                                phi_1559_ = lt_bvh_Hit();
                                phi_1562_ = u32();
                                phi_2220_ = false;
                            } else {
                                let _e1030 = nodes.member[(0u + _e583)].links[1u];
                                let _e1035 = ((0u + _e1030) + select(firstTrailingBit(_e1026), 32u, (_e1026 == 0u)));
                                if (_e1035 < _e80) {
                                } else {
                                    return;
                                }
                                let _e1042 = triangles.member[(0u + _e1035)].v0_;
                                let _e1045 = (_e1042.x - _e176.origin.x);
                                let _e1048 = (_e1042.y - _e176.origin.y);
                                let _e1051 = (_e1042.z - _e176.origin.z);
                                if (_e410 == 0u) {
                                    phi_1608_ = vec3<f32>(_e1048, _e1051, _e1045);
                                } else {
                                    if (_e410 == 1u) {
                                        phi_1607_ = vec3<f32>(_e1051, _e1045, _e1048);
                                    } else {
                                        phi_1607_ = (_e1042 - _e176.origin);
                                    }
                                    let _e1058 = phi_1607_;
                                    phi_1608_ = _e1058;
                                }
                                let _e1060 = phi_1608_;
                                let _e1064 = (_e1060.x - (_e427 * _e1060.z));
                                let _e1068 = (_e1060.y - (_e430 * _e1060.z));
                                let _e1070 = triangles.member[(0u + _e1035)].v1_;
                                let _e1073 = (_e1070.x - _e176.origin.x);
                                let _e1076 = (_e1070.y - _e176.origin.y);
                                let _e1079 = (_e1070.z - _e176.origin.z);
                                if (_e410 == 0u) {
                                    phi_1640_ = vec3<f32>(_e1076, _e1079, _e1073);
                                } else {
                                    if (_e410 == 1u) {
                                        phi_1639_ = vec3<f32>(_e1079, _e1073, _e1076);
                                    } else {
                                        phi_1639_ = (_e1070 - _e176.origin);
                                    }
                                    let _e1086 = phi_1639_;
                                    phi_1640_ = _e1086;
                                }
                                let _e1088 = phi_1640_;
                                let _e1092 = (_e1088.x - (_e427 * _e1088.z));
                                let _e1096 = (_e1088.y - (_e430 * _e1088.z));
                                let _e1098 = triangles.member[(0u + _e1035)].v2_;
                                let _e1101 = (_e1098.x - _e176.origin.x);
                                let _e1104 = (_e1098.y - _e176.origin.y);
                                let _e1107 = (_e1098.z - _e176.origin.z);
                                if (_e410 == 0u) {
                                    phi_1672_ = vec3<f32>(_e1104, _e1107, _e1101);
                                } else {
                                    if (_e410 == 1u) {
                                        phi_1671_ = vec3<f32>(_e1107, _e1101, _e1104);
                                    } else {
                                        phi_1671_ = (_e1098 - _e176.origin);
                                    }
                                    let _e1114 = phi_1671_;
                                    phi_1672_ = _e1114;
                                }
                                let _e1116 = phi_1672_;
                                let _e1120 = (_e1116.x - (_e427 * _e1116.z));
                                let _e1124 = (_e1116.y - (_e430 * _e1116.z));
                                if (_e1092 < _e1120) {
                                    phi_1691_ = true;
                                } else {
                                    if (_e1092 == _e1120) {
                                        phi_1690_ = (_e1096 < _e1124);
                                    } else {
                                        phi_1690_ = false;
                                    }
                                    let _e1129 = phi_1690_;
                                    phi_1691_ = _e1129;
                                }
                                let _e1131 = phi_1691_;
                                if _e1131 {
                                    phi_1695_ = _e1124;
                                    phi_1696_ = _e1120;
                                    phi_1697_ = _e1096;
                                    phi_1698_ = _e1092;
                                } else {
                                    phi_1695_ = _e1096;
                                    phi_1696_ = _e1092;
                                    phi_1697_ = _e1124;
                                    phi_1698_ = _e1120;
                                }
                                let _e1133 = phi_1695_;
                                let _e1135 = phi_1696_;
                                let _e1137 = phi_1697_;
                                let _e1139 = phi_1698_;
                                let _e1142 = ((_e1139 * _e1133) - (_e1137 * _e1135));
                                if _e1131 {
                                    phi_1706_ = -(_e1142);
                                } else {
                                    phi_1706_ = _e1142;
                                }
                                let _e1145 = phi_1706_;
                                if (_e1120 < _e1064) {
                                    phi_1717_ = true;
                                } else {
                                    if (_e1120 == _e1064) {
                                        phi_1716_ = (_e1124 < _e1068);
                                    } else {
                                        phi_1716_ = false;
                                    }
                                    let _e1150 = phi_1716_;
                                    phi_1717_ = _e1150;
                                }
                                let _e1152 = phi_1717_;
                                if _e1152 {
                                    phi_1721_ = _e1068;
                                    phi_1722_ = _e1064;
                                    phi_1723_ = _e1124;
                                    phi_1724_ = _e1120;
                                } else {
                                    phi_1721_ = _e1124;
                                    phi_1722_ = _e1120;
                                    phi_1723_ = _e1068;
                                    phi_1724_ = _e1064;
                                }
                                let _e1154 = phi_1721_;
                                let _e1156 = phi_1722_;
                                let _e1158 = phi_1723_;
                                let _e1160 = phi_1724_;
                                let _e1163 = ((_e1160 * _e1154) - (_e1158 * _e1156));
                                if _e1152 {
                                    phi_1732_ = -(_e1163);
                                } else {
                                    phi_1732_ = _e1163;
                                }
                                let _e1166 = phi_1732_;
                                if (_e1064 < _e1092) {
                                    phi_1743_ = true;
                                } else {
                                    if (_e1064 == _e1092) {
                                        phi_1742_ = (_e1068 < _e1096);
                                    } else {
                                        phi_1742_ = false;
                                    }
                                    let _e1171 = phi_1742_;
                                    phi_1743_ = _e1171;
                                }
                                let _e1173 = phi_1743_;
                                if _e1173 {
                                    phi_1747_ = _e1096;
                                    phi_1748_ = _e1092;
                                    phi_1749_ = _e1068;
                                    phi_1750_ = _e1064;
                                } else {
                                    phi_1747_ = _e1068;
                                    phi_1748_ = _e1064;
                                    phi_1749_ = _e1096;
                                    phi_1750_ = _e1092;
                                }
                                let _e1175 = phi_1747_;
                                let _e1177 = phi_1748_;
                                let _e1179 = phi_1749_;
                                let _e1181 = phi_1750_;
                                let _e1184 = ((_e1181 * _e1175) - (_e1179 * _e1177));
                                if _e1173 {
                                    phi_1758_ = -(_e1184);
                                } else {
                                    phi_1758_ = _e1184;
                                }
                                let _e1187 = phi_1758_;
                                if (_e1145 >= 0f) {
                                    if (_e1166 >= 0f) {
                                        if (_e1187 >= 0f) {
                                            phi_1773_ = ((_e1145 + _e1166) + _e1187);
                                            phi_1774_ = false;
                                        } else {
                                            phi_1773_ = f32();
                                            phi_1774_ = true;
                                        }
                                        let _e1194 = phi_1773_;
                                        let _e1196 = phi_1774_;
                                        phi_1775_ = _e1194;
                                        phi_1776_ = _e1196;
                                    } else {
                                        phi_1775_ = f32();
                                        phi_1776_ = true;
                                    }
                                    let _e1198 = phi_1775_;
                                    let _e1200 = phi_1776_;
                                    phi_1777_ = _e1198;
                                    phi_1778_ = _e1200;
                                } else {
                                    phi_1777_ = f32();
                                    phi_1778_ = true;
                                }
                                let _e1202 = phi_1777_;
                                let _e1204 = phi_1778_;
                                if _e1204 {
                                    if (_e1145 <= 0f) {
                                        if (_e1166 <= 0f) {
                                            let _e1207 = (_e1187 <= 0f);
                                            if _e1207 {
                                            }
                                            phi_1796_ = ((_e1145 + _e1166) + _e1187);
                                            phi_1797_ = false;
                                            phi_1798_ = _e1207;
                                        } else {
                                            phi_1796_ = f32();
                                            phi_1797_ = true;
                                            phi_1798_ = false;
                                        }
                                        let _e1211 = phi_1796_;
                                        let _e1213 = phi_1797_;
                                        let _e1215 = phi_1798_;
                                        phi_1799_ = _e1211;
                                        phi_1800_ = _e1213;
                                        phi_1801_ = _e1215;
                                    } else {
                                        phi_1799_ = f32();
                                        phi_1800_ = true;
                                        phi_1801_ = false;
                                    }
                                    let _e1217 = phi_1799_;
                                    let _e1219 = phi_1800_;
                                    let _e1221 = phi_1801_;
                                    if _e1219 {
                                        phi_1805_ = false;
                                    } else {
                                        phi_1805_ = _e1221;
                                    }
                                    let _e1223 = phi_1805_;
                                    phi_1806_ = _e1217;
                                    phi_1807_ = _e1223;
                                } else {
                                    phi_1806_ = _e1202;
                                    phi_1807_ = true;
                                }
                                let _e1225 = phi_1806_;
                                let _e1227 = phi_1807_;
                                if _e1227 {
                                    let _e1228 = (_e1225 == 0f);
                                    if _e1228 {
                                        phi_2133_ = lt_bvh_triangle_Intersection();
                                        phi_2134_ = false;
                                    } else {
                                        let _e1230 = triangles.member[(0u + _e1035)].v0_;
                                        let _e1233 = (_e1230.x - _e176.origin.x);
                                        let _e1236 = (_e1230.y - _e176.origin.y);
                                        let _e1239 = (_e1230.z - _e176.origin.z);
                                        if (_e410 == 0u) {
                                            phi_1838_ = vec3<f32>(_e1236, _e1239, _e1233);
                                        } else {
                                            if (_e410 == 1u) {
                                                phi_1837_ = vec3<f32>(_e1239, _e1233, _e1236);
                                            } else {
                                                phi_1837_ = (_e1230 - _e176.origin);
                                            }
                                            let _e1246 = phi_1837_;
                                            phi_1838_ = _e1246;
                                        }
                                        let _e1248 = phi_1838_;
                                        let _e1250 = triangles.member[(0u + _e1035)].v1_;
                                        let _e1252 = triangles.member[(0u + _e1035)].v0_;
                                        let _e1255 = (_e1250.x - _e1252.x);
                                        let _e1258 = (_e1250.y - _e1252.y);
                                        let _e1261 = (_e1250.z - _e1252.z);
                                        if (_e410 == 0u) {
                                            phi_1864_ = vec3<f32>(_e1258, _e1261, _e1255);
                                        } else {
                                            if (_e410 == 1u) {
                                                phi_1863_ = vec3<f32>(_e1261, _e1255, _e1258);
                                            } else {
                                                phi_1863_ = (_e1250 - _e1252);
                                            }
                                            let _e1268 = phi_1863_;
                                            phi_1864_ = _e1268;
                                        }
                                        let _e1270 = phi_1864_;
                                        let _e1272 = triangles.member[(0u + _e1035)].v2_;
                                        let _e1274 = triangles.member[(0u + _e1035)].v0_;
                                        let _e1277 = (_e1272.x - _e1274.x);
                                        let _e1280 = (_e1272.y - _e1274.y);
                                        let _e1283 = (_e1272.z - _e1274.z);
                                        if (_e410 == 0u) {
                                            phi_1890_ = vec3<f32>(_e1280, _e1283, _e1277);
                                        } else {
                                            if (_e410 == 1u) {
                                                phi_1889_ = vec3<f32>(_e1283, _e1277, _e1280);
                                            } else {
                                                phi_1889_ = (_e1272 - _e1274);
                                            }
                                            let _e1290 = phi_1889_;
                                            phi_1890_ = _e1290;
                                        }
                                        let _e1292 = phi_1890_;
                                        let _e1299 = ((_e1270.y * _e1292.z) - (_e1270.z * _e1292.y));
                                        let _e1306 = ((_e1270.z * _e1292.x) - (_e1270.x * _e1292.z));
                                        let _e1313 = ((_e1270.x * _e1292.y) - (_e1270.y * _e1292.x));
                                        let _e1327 = (((1f / _e424.z) * (((_e1299 * _e1248.x) + (_e1306 * _e1248.y)) + (_e1313 * _e1248.z))) / (((_e1299 * _e427) + (_e1306 * _e430)) + _e1313));
                                        if (_e1327 > _e176.tmin) {
                                            if (_e1327 < _e176.tmax) {
                                                let _e1333 = triangles.member[(0u + _e1035)].v0_;
                                                let _e1335 = triangles.member[(0u + _e1035)].v1_;
                                                if (_e1333.x < _e1335.x) {
                                                    phi_1948_ = _e1333.x;
                                                } else {
                                                    phi_1948_ = _e1335.x;
                                                }
                                                let _e1342 = phi_1948_;
                                                if (_e1333.y < _e1335.y) {
                                                    phi_1957_ = _e1333.y;
                                                } else {
                                                    phi_1957_ = _e1335.y;
                                                }
                                                let _e1349 = phi_1957_;
                                                if (_e1333.z < _e1335.z) {
                                                    phi_1966_ = _e1333.z;
                                                } else {
                                                    phi_1966_ = _e1335.z;
                                                }
                                                let _e1356 = phi_1966_;
                                                let _e1358 = triangles.member[(0u + _e1035)].v2_;
                                                if (_e1342 < _e1358.x) {
                                                    phi_1975_ = _e1342;
                                                } else {
                                                    phi_1975_ = _e1358.x;
                                                }
                                                let _e1363 = phi_1975_;
                                                if (_e1349 < _e1358.y) {
                                                    phi_1982_ = _e1349;
                                                } else {
                                                    phi_1982_ = _e1358.y;
                                                }
                                                let _e1368 = phi_1982_;
                                                if (_e1356 < _e1358.z) {
                                                    phi_1989_ = _e1356;
                                                } else {
                                                    phi_1989_ = _e1358.z;
                                                }
                                                let _e1373 = phi_1989_;
                                                let _e1375 = triangles.member[(0u + _e1035)].v0_;
                                                let _e1377 = triangles.member[(0u + _e1035)].v1_;
                                                if (_e1375.x > _e1377.x) {
                                                    phi_2002_ = _e1375.x;
                                                } else {
                                                    phi_2002_ = _e1377.x;
                                                }
                                                let _e1384 = phi_2002_;
                                                if (_e1375.y > _e1377.y) {
                                                    phi_2011_ = _e1375.y;
                                                } else {
                                                    phi_2011_ = _e1377.y;
                                                }
                                                let _e1391 = phi_2011_;
                                                if (_e1375.z > _e1377.z) {
                                                    phi_2020_ = _e1375.z;
                                                } else {
                                                    phi_2020_ = _e1377.z;
                                                }
                                                let _e1398 = phi_2020_;
                                                let _e1400 = triangles.member[(0u + _e1035)].v2_;
                                                if (_e1384 > _e1400.x) {
                                                    phi_2029_ = _e1384;
                                                } else {
                                                    phi_2029_ = _e1400.x;
                                                }
                                                let _e1405 = phi_2029_;
                                                if (_e1391 > _e1400.y) {
                                                    phi_2036_ = _e1391;
                                                } else {
                                                    phi_2036_ = _e1400.y;
                                                }
                                                let _e1410 = phi_2036_;
                                                if (_e1398 > _e1400.z) {
                                                    phi_2043_ = _e1398;
                                                } else {
                                                    phi_2043_ = _e1400.z;
                                                }
                                                let _e1415 = phi_2043_;
                                                let _e1422 = ((_e1363 - _e176.origin.x) * _e322);
                                                let _e1423 = ((_e1368 - _e176.origin.y) * _e333);
                                                let _e1424 = ((_e1373 - _e176.origin.z) * _e344);
                                                let _e1431 = ((_e1405 - _e176.origin.x) * _e322);
                                                let _e1432 = ((_e1410 - _e176.origin.y) * _e333);
                                                let _e1433 = ((_e1415 - _e176.origin.z) * _e344);
                                                if (_e1422 < _e1431) {
                                                    phi_2066_ = _e1422;
                                                } else {
                                                    phi_2066_ = _e1431;
                                                }
                                                let _e1436 = phi_2066_;
                                                if (_e1423 < _e1432) {
                                                    phi_2071_ = _e1423;
                                                } else {
                                                    phi_2071_ = _e1432;
                                                }
                                                let _e1439 = phi_2071_;
                                                if (_e1424 < _e1433) {
                                                    phi_2076_ = _e1424;
                                                } else {
                                                    phi_2076_ = _e1433;
                                                }
                                                let _e1442 = phi_2076_;
                                                if (_e1422 > _e1431) {
                                                    phi_2084_ = _e1422;
                                                } else {
                                                    phi_2084_ = _e1431;
                                                }
                                                let _e1448 = phi_2084_;
                                                if (_e1423 > _e1432) {
                                                    phi_2089_ = _e1423;
                                                } else {
                                                    phi_2089_ = _e1432;
                                                }
                                                let _e1451 = phi_2089_;
                                                if (_e1424 > _e1433) {
                                                    phi_2094_ = _e1424;
                                                } else {
                                                    phi_2094_ = _e1433;
                                                }
                                                let _e1454 = phi_2094_;
                                                let _e1458 = core_intrinsics_maximum_number_nsz_f32_((_e1436 - _e389), (_e1439 - _e390));
                                                let _e1459 = core_intrinsics_maximum_number_nsz_f32_(_e1458, (_e1442 - _e391));
                                                let _e1460 = core_intrinsics_minimum_number_nsz_f32_((_e1448 + _e389), (_e1451 + _e390));
                                                let _e1461 = core_intrinsics_minimum_number_nsz_f32_(_e1460, (_e1454 + _e391));
                                                if (_e1459 > -300000000000000000000000000000000000000f) {
                                                    phi_2106_ = _e1459;
                                                } else {
                                                    phi_2106_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1464 = phi_2106_;
                                                if (_e1461 < 300000000000000000000000000000000000000f) {
                                                    phi_2111_ = _e1461;
                                                } else {
                                                    phi_2111_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1467 = phi_2111_;
                                                if (_e1327 < _e1464) {
                                                    phi_2116_ = _e1464;
                                                } else {
                                                    phi_2116_ = _e1327;
                                                }
                                                let _e1470 = phi_2116_;
                                                if (_e1470 > _e1467) {
                                                    phi_2121_ = _e1467;
                                                } else {
                                                    phi_2121_ = _e1470;
                                                }
                                                let _e1473 = phi_2121_;
                                                phi_2126_ = lt_bvh_triangle_Intersection(_e1473, (_e1166 / _e1225), (_e1187 / _e1225), (_e1464 <= _e1467));
                                                phi_2127_ = false;
                                            } else {
                                                phi_2126_ = lt_bvh_triangle_Intersection();
                                                phi_2127_ = true;
                                            }
                                            let _e1479 = phi_2126_;
                                            let _e1481 = phi_2127_;
                                            phi_2128_ = _e1479;
                                            phi_2129_ = _e1481;
                                        } else {
                                            phi_2128_ = lt_bvh_triangle_Intersection();
                                            phi_2129_ = true;
                                        }
                                        let _e1483 = phi_2128_;
                                        let _e1485 = phi_2129_;
                                        if _e1485 {
                                        }
                                        phi_2133_ = _e1483;
                                        phi_2134_ = _e1485;
                                    }
                                    let _e1487 = phi_2133_;
                                    let _e1489 = phi_2134_;
                                    phi_2135_ = _e1487;
                                    phi_2136_ = _e1228;
                                    phi_2137_ = _e1489;
                                } else {
                                    phi_2135_ = lt_bvh_triangle_Intersection();
                                    phi_2136_ = true;
                                    phi_2137_ = false;
                                }
                                let _e1491 = phi_2135_;
                                let _e1493 = phi_2136_;
                                let _e1495 = phi_2137_;
                                if _e1493 {
                                    phi_2141_ = true;
                                } else {
                                    phi_2141_ = _e1495;
                                }
                                let _e1497 = phi_2141_;
                                if _e1497 {
                                    phi_2145_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_2145_ = _e1491;
                                }
                                let _e1499 = phi_2145_;
                                if _e1499.is_hit {
                                    if (_e1499.t > _e176.tmin) {
                                        if (_e1499.t < _e1024.t) {
                                            phi_2194_ = true;
                                        } else {
                                            if (_e1499.t == _e1024.t) {
                                                if (_e1024.triangle != 4294967295u) {
                                                    if (_e1035 < _e1024.triangle) {
                                                        phi_2185_ = true;
                                                    } else {
                                                        if (_e1035 == _e1024.triangle) {
                                                            phi_2184_ = (4294967295u < _e1024.instance);
                                                        } else {
                                                            phi_2184_ = false;
                                                        }
                                                        let _e1518 = phi_2184_;
                                                        phi_2185_ = _e1518;
                                                    }
                                                    let _e1520 = phi_2185_;
                                                    phi_2186_ = _e1520;
                                                    phi_2187_ = false;
                                                } else {
                                                    phi_2186_ = bool();
                                                    phi_2187_ = true;
                                                }
                                                let _e1522 = phi_2186_;
                                                let _e1524 = phi_2187_;
                                                phi_2188_ = _e1522;
                                                phi_2189_ = _e1524;
                                            } else {
                                                phi_2188_ = bool();
                                                phi_2189_ = true;
                                            }
                                            let _e1526 = phi_2188_;
                                            let _e1528 = phi_2189_;
                                            if _e1528 {
                                                phi_2193_ = false;
                                            } else {
                                                phi_2193_ = _e1526;
                                            }
                                            let _e1530 = phi_2193_;
                                            phi_2194_ = _e1530;
                                        }
                                        let _e1532 = phi_2194_;
                                        if _e1532 {
                                            let _e1534 = triangles.member[(0u + _e1035)].i0_;
                                            if ((_e1534 & 2147483648u) == 0u) {
                                                phi_2208_ = true;
                                            } else {
                                                if true {
                                                }
                                                phi_2208_ = true;
                                            }
                                            let _e1538 = phi_2208_;
                                            if _e1538 {
                                                phi_2216_ = lt_bvh_Hit(_e1499.t, _e1499.u, _e1499.v, _e1035, 4294967295u);
                                            } else {
                                                phi_2216_ = _e1024;
                                            }
                                            let _e1544 = phi_2216_;
                                            phi_2217_ = _e1544;
                                        } else {
                                            phi_2217_ = _e1024;
                                        }
                                        let _e1546 = phi_2217_;
                                        phi_2218_ = _e1546;
                                    } else {
                                        phi_2218_ = _e1024;
                                    }
                                    let _e1548 = phi_2218_;
                                    phi_2219_ = _e1548;
                                } else {
                                    phi_2219_ = _e1024;
                                }
                                let _e1550 = phi_2219_;
                                phi_1559_ = _e1550;
                                phi_1562_ = (_e1026 & (_e1026 - 1u));
                                phi_2220_ = true;
                            }
                            let _e1552 = phi_1559_;
                            let _e1554 = phi_1562_;
                            let _e1556 = phi_2220_;
                            continue;
                            continuing {
                                phi_1558_ = _e1552;
                                phi_1561_ = _e1554;
                                break if !(_e1556);
                            }
                        }
                        let _e1559 = local_1.group_mask;
                        if ((_e1559 & 4278190080u) == 0u) {
                            let _e1563 = local_1.len;
                            if (_e1563 == 0u) {
                                phi_2259_ = false;
                            } else {
                                let _e1567 = local_1.len;
                                local_1.len = (_e1567 - 1u);
                                let _e1570 = local_1.len;
                                if (_e1570 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1575 = local_1.first[(0u + _e1570)];
                                local_1.group = _e1575;
                                let _e1578 = local_1.len;
                                if (_e1578 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1583 = local_1.mask[(0u + _e1578)];
                                local_1.group_mask = _e1583;
                                phi_2259_ = true;
                            }
                            let _e1586 = phi_2259_;
                            phi_2260_ = _e1586;
                        } else {
                            phi_2260_ = true;
                        }
                        let _e1588 = phi_2260_;
                        if _e1588 {
                            let _e1590 = local_1.group_mask;
                            let _e1596 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1590)), 32u, (_e1590 == 0u)));
                            let _e1600 = local_1.group_mask;
                            let _e1614 = local_1.group_mask;
                            local_1.group_mask = (_e1614 & ~((1u << bitcast<u32>((_e1596 & 31u)))));
                            let _e1617 = local_1.group;
                            phi_2291_ = (_e1617 + countOneBits(((_e1600 & ~((4294967295u << bitcast<u32>((((_e1596 - 24u) ^ _e443) & 31u))))) & 255u)));
                        } else {
                            phi_2291_ = 4294967295u;
                        }
                        let _e1620 = phi_2291_;
                        let _e2538 = local_5;
                        phi_1222_ = _e2538;
                        phi_1225_ = _e1620;
                    } else {
                        phi_1222_ = lt_bvh_Hit();
                        phi_1225_ = u32();
                    }
                    let _e1622 = phi_1222_;
                    let _e1624 = phi_1225_;
                    continue;
                    continuing {
                        phi_1221_ = _e1622;
                        phi_1224_ = _e1624;
                        break if !(_e584);
                    }
                }
                let _e2542 = local_6;
                phi_2292_ = _e2542;
            }
            let _e1627 = phi_2292_;
            phi_2293_ = _e1627;
            phi_2294_ = _e240;
        } else {
            phi_2293_ = lt_bvh_Hit();
            phi_2294_ = true;
        }
        let _e1629 = phi_2293_;
        let _e1631 = phi_2294_;
        if _e1631 {
            phi_2298_ = _e178;
        } else {
            phi_2298_ = _e1629;
        }
        let _e1633 = phi_2298_;
        if (_e1633.triangle != 4294967295u) {
            let _e1639 = ((1f - _e1633.u) - _e1633.v);
            if (_e1633.triangle < _e80) {
            } else {
                return;
            }
            let _e1644 = triangles.member[(0u + _e1633.triangle)];
            let _e1669 = (((_e1644.v0_.x * _e1639) + (_e1644.v1_.x * _e1633.u)) + (_e1644.v2_.x * _e1633.v));
            let _e1670 = (((_e1644.v0_.y * _e1639) + (_e1644.v1_.y * _e1633.u)) + (_e1644.v2_.y * _e1633.v));
            let _e1671 = (((_e1644.v0_.z * _e1639) + (_e1644.v1_.z * _e1633.u)) + (_e1644.v2_.z * _e1633.v));
            let _e1674 = abs(_e1644.v0_.x);
            let _e1676 = abs(_e1644.v0_.y);
            let _e1678 = abs(_e1644.v0_.z);
            let _e1680 = abs(_e1644.v1_.x);
            let _e1682 = abs(_e1644.v1_.y);
            let _e1684 = abs(_e1644.v1_.z);
            if (_e1674 > _e1680) {
                phi_2362_ = _e1674;
            } else {
                phi_2362_ = _e1680;
            }
            let _e1687 = phi_2362_;
            if (_e1676 > _e1682) {
                phi_2367_ = _e1676;
            } else {
                phi_2367_ = _e1682;
            }
            let _e1690 = phi_2367_;
            if (_e1678 > _e1684) {
                phi_2372_ = _e1678;
            } else {
                phi_2372_ = _e1684;
            }
            let _e1693 = phi_2372_;
            let _e1695 = abs(_e1644.v2_.x);
            let _e1697 = abs(_e1644.v2_.y);
            let _e1699 = abs(_e1644.v2_.z);
            if (_e1687 > _e1695) {
                phi_2383_ = _e1687;
            } else {
                phi_2383_ = _e1695;
            }
            let _e1702 = phi_2383_;
            if (_e1690 > _e1697) {
                phi_2388_ = _e1690;
            } else {
                phi_2388_ = _e1697;
            }
            let _e1705 = phi_2388_;
            if (_e1693 > _e1699) {
                phi_2393_ = _e1693;
            } else {
                phi_2393_ = _e1699;
            }
            let _e1708 = phi_2393_;
            let _e1711 = (_e1644.v1_.x - _e1644.v0_.x);
            let _e1714 = (_e1644.v1_.y - _e1644.v0_.y);
            let _e1717 = (_e1644.v1_.z - _e1644.v0_.z);
            let _e1720 = (_e1644.v2_.x - _e1644.v0_.x);
            let _e1723 = (_e1644.v2_.y - _e1644.v0_.y);
            let _e1726 = (_e1644.v2_.z - _e1644.v0_.z);
            let _e1730 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1714), abs(_e1717));
            let _e1731 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1711), _e1730);
            let _e1732 = (_e1711 / _e1731);
            let _e1733 = (_e1714 / _e1731);
            let _e1734 = (_e1717 / _e1731);
            let _e1738 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1723), abs(_e1726));
            let _e1739 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1720), _e1738);
            let _e1740 = (_e1720 / _e1739);
            let _e1741 = (_e1723 / _e1739);
            let _e1742 = (_e1726 / _e1739);
            let _e1745 = ((_e1733 * _e1742) - (_e1741 * _e1734));
            let _e1748 = ((_e1734 * _e1740) - (_e1742 * _e1732));
            let _e1751 = ((_e1732 * _e1741) - (_e1740 * _e1733));
            let _e1753 = p.member.eye;
            let _e1766 = (1f / sqrt((((_e1745 * _e1745) + (_e1748 * _e1748)) + (_e1751 * _e1751))));
            let _e1767 = (_e1745 * _e1766);
            let _e1768 = (_e1748 * _e1766);
            let _e1769 = (_e1751 * _e1766);
            if ((((_e1767 * (_e1753.x - _e1669)) + (_e1768 * (_e1753.y - _e1670))) + (_e1769 * (_e1753.z - _e1671))) < 0f) {
                phi_2469_ = vec3<f32>(-(_e1767), -(_e1768), -(_e1769));
            } else {
                phi_2469_ = vec3<f32>(_e1767, _e1768, _e1769);
            }
            let _e1782 = phi_2469_;
            if (_e1633.triangle < _e80) {
            } else {
                return;
            }
            let _e1787 = triangles.member[(0u + _e1633.triangle)];
            let _e1789 = (_e1787.i0_ & 2147483647u);
            if (_e1789 < _e83) {
            } else {
                return;
            }
            let _e1795 = vertices.member[(0u + _e1789)];
            if (_e1787.i1_ < _e83) {
            } else {
                return;
            }
            let _e1799 = vertices.member[(0u + _e1787.i1_)];
            if (_e1787.i2_ < _e83) {
            } else {
                return;
            }
            let _e1803 = vertices.member[(0u + _e1787.i2_)];
            let _e1804 = array<abi_Vertex, 3>(_e1795, _e1799, _e1803);
            if (_e1804[0].material < arrayLength((&materials.member))) {
            } else {
                return;
            }
            let _e1810 = materials.member[(0u + _e1804[0].material)];
            let _e1827 = (1f / 255f);
            let _e1846 = (1f / 255f);
            let _e1868 = (1f / 255f);
            if (_e1810.color_size == 0u) {
                phi_2712_ = vec3<f32>(1f, 1f, 1f);
            } else {
                local.offset = _e1810.color_offset;
                local.size = _e1810.color_size;
                local.flags = _e1810.flags;
                let _e1911 = _lt_shaders_texture_TextureView_quad((&local), (((_e1804[0].u * _e1639) + (_e1804[1].u * _e1633.u)) + (_e1804[2].u * _e1633.v)), (((_e1804[0].v * _e1639) + (_e1804[1].v * _e1633.u)) + (_e1804[2].v * _e1633.v)));
                if (_e1911.indices[0] < _e92) {
                } else {
                    return;
                }
                let _e1917 = color_texels.member[(0u + _e1911.indices[0])];
                let _e1928 = (1f / 255f);
                if (_e1911.indices[1] < _e92) {
                } else {
                    return;
                }
                let _e1942 = color_texels.member[(0u + _e1911.indices[1])];
                let _e1953 = (1f / 255f);
                if (_e1911.indices[2] < _e92) {
                } else {
                    return;
                }
                let _e1970 = color_texels.member[(0u + _e1911.indices[2])];
                let _e1981 = (1f / 255f);
                if (_e1911.indices[3] < _e92) {
                } else {
                    return;
                }
                let _e1998 = color_texels.member[(0u + _e1911.indices[3])];
                let _e2009 = (1f / 255f);
                let _e2018 = (((((f32((_e1917 & 255u)) * _e1928) * _e1911.weights.x) + ((f32((_e1942 & 255u)) * _e1953) * _e1911.weights.y)) + ((f32((_e1970 & 255u)) * _e1981) * _e1911.weights.z)) + ((f32((_e1998 & 255u)) * _e2009) * _e1911.weights.w));
                let _e2019 = (((((f32(((_e1917 >> bitcast<u32>(8i)) & 255u)) * _e1928) * _e1911.weights.x) + ((f32(((_e1942 >> bitcast<u32>(8i)) & 255u)) * _e1953) * _e1911.weights.y)) + ((f32(((_e1970 >> bitcast<u32>(8i)) & 255u)) * _e1981) * _e1911.weights.z)) + ((f32(((_e1998 >> bitcast<u32>(8i)) & 255u)) * _e2009) * _e1911.weights.w));
                let _e2020 = (((((f32(((_e1917 >> bitcast<u32>(16i)) & 255u)) * _e1928) * _e1911.weights.x) + ((f32(((_e1942 >> bitcast<u32>(16i)) & 255u)) * _e1953) * _e1911.weights.y)) + ((f32(((_e1970 >> bitcast<u32>(16i)) & 255u)) * _e1981) * _e1911.weights.z)) + ((f32(((_e1998 >> bitcast<u32>(16i)) & 255u)) * _e2009) * _e1911.weights.w));
                phi_2712_ = vec3<f32>((_e2018 * _e2018), (_e2019 * _e2019), (_e2020 * _e2020));
            }
            let _e2026 = phi_2712_;
            let _e2028 = ((_e1810.base_color.x * ((((f32((_e1804[0].color & 255u)) * _e1827) * _e1639) + ((f32((_e1804[1].color & 255u)) * _e1846) * _e1633.u)) + ((f32((_e1804[2].color & 255u)) * _e1868) * _e1633.v))) * _e2026.x);
            let _e2030 = ((_e1810.base_color.y * ((((f32(((_e1804[0].color >> bitcast<u32>(8i)) & 255u)) * _e1827) * _e1639) + ((f32(((_e1804[1].color >> bitcast<u32>(8i)) & 255u)) * _e1846) * _e1633.u)) + ((f32(((_e1804[2].color >> bitcast<u32>(8i)) & 255u)) * _e1868) * _e1633.v))) * _e2026.y);
            let _e2032 = ((_e1810.base_color.z * ((((f32(((_e1804[0].color >> bitcast<u32>(16i)) & 255u)) * _e1827) * _e1639) + ((f32(((_e1804[1].color >> bitcast<u32>(16i)) & 255u)) * _e1846) * _e1633.u)) + ((f32(((_e1804[2].color >> bitcast<u32>(16i)) & 255u)) * _e1868) * _e1633.v))) * _e2026.z);
            let _e2033 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1705, _e1708);
            let _e2034 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1702, _e2033);
            if ((_e1810.flags & 2u) == 0u) {
                phi_2727_ = 0u;
            } else {
                phi_2727_ = 1u;
            }
            let _e2039 = phi_2727_;
            if (_e1804[0].normal == 2147516416u) {
                phi_2930_ = _e1782;
            } else {
                let _e2052 = (f32((bitcast<i32>((_e1804[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2058 = (f32((bitcast<i32>(_e1804[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2062 = ((1f - abs(_e2052)) - abs(_e2058));
                if (_e2062 < 0f) {
                    phi_2754_ = -(_e2062);
                } else {
                    phi_2754_ = 0f;
                }
                let _e2066 = phi_2754_;
                if (_e2052 < 0f) {
                    phi_2761_ = (_e2052 + _e2066);
                } else {
                    phi_2761_ = (_e2052 - _e2066);
                }
                let _e2071 = phi_2761_;
                if (_e2058 < 0f) {
                    phi_2768_ = (_e2058 + _e2066);
                } else {
                    phi_2768_ = (_e2058 - _e2066);
                }
                let _e2076 = phi_2768_;
                let _e2083 = (1f / sqrt((((_e2071 * _e2071) + (_e2076 * _e2076)) + (_e2062 * _e2062))));
                let _e2099 = (f32((bitcast<i32>((_e1804[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2105 = (f32((bitcast<i32>(_e1804[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2109 = ((1f - abs(_e2099)) - abs(_e2105));
                if (_e2109 < 0f) {
                    phi_2803_ = -(_e2109);
                } else {
                    phi_2803_ = 0f;
                }
                let _e2113 = phi_2803_;
                if (_e2099 < 0f) {
                    phi_2810_ = (_e2099 + _e2113);
                } else {
                    phi_2810_ = (_e2099 - _e2113);
                }
                let _e2118 = phi_2810_;
                if (_e2105 < 0f) {
                    phi_2817_ = (_e2105 + _e2113);
                } else {
                    phi_2817_ = (_e2105 - _e2113);
                }
                let _e2123 = phi_2817_;
                let _e2130 = (1f / sqrt((((_e2118 * _e2118) + (_e2123 * _e2123)) + (_e2109 * _e2109))));
                let _e2149 = (f32((bitcast<i32>((_e1804[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2155 = (f32((bitcast<i32>(_e1804[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2159 = ((1f - abs(_e2149)) - abs(_e2155));
                if (_e2159 < 0f) {
                    phi_2855_ = -(_e2159);
                } else {
                    phi_2855_ = 0f;
                }
                let _e2163 = phi_2855_;
                if (_e2149 < 0f) {
                    phi_2862_ = (_e2149 + _e2163);
                } else {
                    phi_2862_ = (_e2149 - _e2163);
                }
                let _e2168 = phi_2862_;
                if (_e2155 < 0f) {
                    phi_2869_ = (_e2155 + _e2163);
                } else {
                    phi_2869_ = (_e2155 - _e2163);
                }
                let _e2173 = phi_2869_;
                let _e2180 = (1f / sqrt((((_e2168 * _e2168) + (_e2173 * _e2173)) + (_e2159 * _e2159))));
                let _e2191 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(vec3<f32>(((((_e2071 * _e2083) * _e1639) + ((_e2118 * _e2130) * _e1633.u)) + ((_e2168 * _e2180) * _e1633.v)), ((((_e2076 * _e2083) * _e1639) + ((_e2123 * _e2130) * _e1633.u)) + ((_e2173 * _e2180) * _e1633.v)), ((((_e2062 * _e2083) * _e1639) + ((_e2109 * _e2130) * _e1633.u)) + ((_e2159 * _e2180) * _e1633.v))));
                let _e2203 = sqrt((((_e2191.x * _e2191.x) + (_e2191.y * _e2191.y)) + (_e2191.z * _e2191.z)));
                if (_e2203 > 0f) {
                    let _e2206 = (_e2191.x / _e2203);
                    let _e2208 = (_e2191.y / _e2203);
                    let _e2210 = (_e2191.z / _e2203);
                    if ((((_e2206 * _e1782.x) + (_e2208 * _e1782.y)) + (_e2210 * _e1782.z)) < 0f) {
                        phi_2928_ = vec3<f32>(-(_e2206), -(_e2208), -(_e2210));
                    } else {
                        phi_2928_ = (_e2191 / vec3(_e2203));
                    }
                    let _e2227 = phi_2928_;
                    phi_2929_ = _e2227;
                } else {
                    phi_2929_ = _e1782;
                }
                let _e2229 = phi_2929_;
                phi_2930_ = _e2229;
            }
            let _e2231 = phi_2930_;
            if (_e2028 > 0f) {
                if (_e2028 < 1f) {
                    phi_2939_ = _e2028;
                } else {
                    phi_2939_ = 1f;
                }
                let _e2235 = phi_2939_;
                phi_2940_ = _e2235;
            } else {
                phi_2940_ = 0f;
            }
            let _e2237 = phi_2940_;
            if (_e2030 > 0f) {
                if (_e2030 < 1f) {
                    phi_2950_ = _e2030;
                } else {
                    phi_2950_ = 1f;
                }
                let _e2242 = phi_2950_;
                phi_2951_ = _e2242;
            } else {
                phi_2951_ = 0f;
            }
            let _e2244 = phi_2951_;
            if (_e2032 > 0f) {
                if (_e2032 < 1f) {
                    phi_2961_ = _e2032;
                } else {
                    phi_2961_ = 1f;
                }
                let _e2249 = phi_2961_;
                phi_2962_ = _e2249;
            } else {
                phi_2962_ = 0f;
            }
            let _e2251 = phi_2962_;
            let _e2254 = ((sqrt(_e2237) * 255f) + 0.5f);
            let _e2263 = ((sqrt(_e2244) * 255f) + 0.5f);
            let _e2275 = ((sqrt(_e2251) * 255f) + 0.5f);
            phi_2997_ = abi_Sample(vec3<f32>(_e1669, _e1670, _e1671), _e2034, _e1782, _e2039, _e2231, ((select(select(u32(_e2254), 0u, (_e2254 < bitcast<f32>(0u))), 4294967295u, (_e2254 > bitcast<f32>(1333788671u))) | (select(select(u32(_e2263), 0u, (_e2263 < bitcast<f32>(0u))), 4294967295u, (_e2263 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e2275), 0u, (_e2275 < bitcast<f32>(0u))), 4294967295u, (_e2275 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_2997_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e2289 = phi_2997_;
        if (_e104.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e104.shift)] = _e2289;
        if (_e1633.triangle != 4294967295u) {
            let _e2298 = ((1f - _e1633.u) - _e1633.v);
            if (_e1633.triangle < _e80) {
            } else {
                return;
            }
            let _e2303 = triangles.member[(0u + _e1633.triangle)];
            let _e2305 = (_e2303.i0_ & 2147483647u);
            if (_e2305 < _e95) {
            } else {
                return;
            }
            let _e2311 = before.member[(0u + _e2305)];
            if (_e2303.i1_ < _e95) {
            } else {
                return;
            }
            let _e2315 = before.member[(0u + _e2303.i1_)];
            if (_e2303.i2_ < _e95) {
            } else {
                return;
            }
            let _e2319 = before.member[(0u + _e2303.i2_)];
            let _e2324 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2311.x, _e2311.y, _e2311.z));
            let _e2335 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2315.x, _e2315.y, _e2315.z));
            let _e2349 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2319.x, _e2319.y, _e2319.z));
            phi_3088_ = vec3<f32>((((_e2324.x * _e2298) + (_e2335.x * _e1633.u)) + (_e2349.x * _e1633.v)), (((_e2324.y * _e2298) + (_e2335.y * _e1633.u)) + (_e2349.y * _e1633.v)), (((_e2324.z * _e2298) + (_e2335.z * _e1633.u)) + (_e2349.z * _e1633.v)));
        } else {
            phi_3088_ = vec3<f32>(0f, 0f, 0f);
        }
        let _e2361 = phi_3088_;
        if (_e104.shift < arrayLength((&past.member))) {
        } else {
            return;
        }
        past.member[(0u + _e104.shift)] = vec4<f32>(_e2361.x, _e2361.y, _e2361.z, 1f);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_color_motion_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
