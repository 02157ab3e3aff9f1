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
        let _e83 = phi_215_;
        let _e85 = phi_216_;
        phi_217_ = _e83;
        phi_218_ = _e85;
    } else {
        phi_217_ = lt_mask_LightPlace();
        phi_218_ = true;
    }
    let _e87 = phi_217_;
    let _e89 = phi_218_;
    if _e89 {
        phi_223_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_223_ = _e87;
    }
    let _e94 = phi_223_;
    return lt_mask_LightPlace(_e94.word, _e94.shift);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_238_: bool;
    var phi_242_: f32;

    if (param_3 != param_3) {
        phi_238_ = true;
    } else {
        let _e73 = (param_4 >= param_3);
        if _e73 {
        }
        phi_238_ = _e73;
    }
    let _e75 = phi_238_;
    if _e75 {
        phi_242_ = param_4;
    } else {
        phi_242_ = param_3;
    }
    let _e77 = phi_242_;
    return _e77;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_254_: bool;
    var phi_258_: f32;

    if (param_5 != param_5) {
        phi_254_ = true;
    } else {
        let _e73 = (param_6 <= param_5);
        if _e73 {
        }
        phi_254_ = _e73;
    }
    let _e75 = phi_254_;
    if _e75 {
        phi_258_ = param_6;
    } else {
        phi_258_ = param_5;
    }
    let _e77 = phi_258_;
    return _e77;
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

    let _e74 = (*param_7).size;
    let _e75 = (_e74 & 65535u);
    let _e77 = (*param_7).size;
    let _e79 = (_e77 >> bitcast<u32>(16i));
    let _e81 = (*param_7).flags;
    let _e83 = ((_e81 & 4u) != 0u);
    let _e85 = (*param_7).flags;
    let _e88 = ((_e85 >> bitcast<u32>(4u)) & 3u);
    if (_e88 == 0u) {
        if (param_8 > -8388608f) {
            let _e101 = f32(select(0i, select(select(i32(param_8), i32(-2147483648), (param_8 < bitcast<f32>(3472883712u))), 2147483647i, (param_8 > bitcast<f32>(1325400063u))), (param_8 == param_8)));
            if (_e101 > param_8) {
                phi_300_ = 1f;
            } else {
                phi_300_ = 0f;
            }
            let _e104 = phi_300_;
            if (param_8 < 8388608f) {
                phi_305_ = (_e101 - _e104);
                phi_306_ = false;
            } else {
                phi_305_ = f32();
                phi_306_ = true;
            }
            let _e107 = phi_305_;
            let _e109 = phi_306_;
            phi_307_ = _e107;
            phi_308_ = _e109;
        } else {
            phi_307_ = f32();
            phi_308_ = true;
        }
        let _e111 = phi_307_;
        let _e113 = phi_308_;
        if _e113 {
            phi_312_ = param_8;
        } else {
            phi_312_ = _e111;
        }
        let _e115 = phi_312_;
        phi_360_ = (param_8 - _e115);
    } else {
        if (_e88 == 1u) {
            let _e118 = (param_8 * 0.5f);
            if (_e118 > -8388608f) {
                let _e130 = f32(select(0i, select(select(i32(_e118), i32(-2147483648), (_e118 < bitcast<f32>(3472883712u))), 2147483647i, (_e118 > bitcast<f32>(1325400063u))), (_e118 == _e118)));
                if (_e130 > _e118) {
                    phi_338_ = 1f;
                } else {
                    phi_338_ = 0f;
                }
                let _e133 = phi_338_;
                if (_e118 < 8388608f) {
                    phi_343_ = (_e130 - _e133);
                    phi_344_ = false;
                } else {
                    phi_343_ = f32();
                    phi_344_ = true;
                }
                let _e136 = phi_343_;
                let _e138 = phi_344_;
                phi_345_ = _e136;
                phi_346_ = _e138;
            } else {
                phi_345_ = f32();
                phi_346_ = true;
            }
            let _e140 = phi_345_;
            let _e142 = phi_346_;
            if _e142 {
                phi_350_ = _e118;
            } else {
                phi_350_ = _e140;
            }
            let _e144 = phi_350_;
            let _e146 = (param_8 - (2f * _e144));
            if (_e146 > 1f) {
                phi_358_ = (2f - _e146);
            } else {
                phi_358_ = _e146;
            }
            let _e150 = phi_358_;
            phi_359_ = _e150;
        } else {
            phi_359_ = param_8;
        }
        let _e152 = phi_359_;
        phi_360_ = _e152;
    }
    let _e154 = phi_360_;
    if (_e154 > 0f) {
        if (_e154 < 1f) {
            phi_369_ = _e154;
        } else {
            phi_369_ = 1f;
        }
        let _e158 = phi_369_;
        phi_370_ = _e158;
    } else {
        phi_370_ = 0f;
    }
    let _e160 = phi_370_;
    let _e161 = (_e75 - 1u);
    let _e163 = (_e160 * f32(_e75));
    if _e83 {
        let _e170 = select(select(u32(_e163), 0u, (_e163 < bitcast<f32>(0u))), 4294967295u, (_e163 > bitcast<f32>(1333788671u)));
        if (_e161 < _e170) {
            phi_388_ = _e161;
        } else {
            phi_388_ = _e170;
        }
        let _e173 = phi_388_;
        phi_427_ = texture_Axis(_e173, _e173, 0f);
    } else {
        let _e175 = (_e163 + 0.5f);
        let _e182 = select(select(u32(_e175), 0u, (_e175 < bitcast<f32>(0u))), 4294967295u, (_e175 > bitcast<f32>(1333788671u)));
        if (_e75 < _e182) {
            phi_402_ = _e75;
        } else {
            phi_402_ = _e182;
        }
        let _e185 = phi_402_;
        if (_e88 == 0u) {
            phi_409_ = _e161;
        } else {
            phi_409_ = 0u;
        }
        let _e190 = phi_409_;
        if (_e88 == 0u) {
            phi_414_ = 0u;
        } else {
            phi_414_ = _e161;
        }
        let _e193 = phi_414_;
        if (_e185 == 0u) {
            phi_420_ = _e190;
        } else {
            phi_420_ = (_e185 - 1u);
        }
        let _e197 = phi_420_;
        if (_e185 > _e161) {
            phi_425_ = _e193;
        } else {
            phi_425_ = _e185;
        }
        let _e200 = phi_425_;
        phi_427_ = texture_Axis(_e197, _e200, (_e175 - f32(_e185)));
    }
    let _e203 = phi_427_;
    let _e205 = (*param_7).flags;
    let _e208 = ((_e205 >> bitcast<u32>(6u)) & 3u);
    if (_e208 == 0u) {
        if (param_9 > -8388608f) {
            let _e221 = f32(select(0i, select(select(i32(param_9), i32(-2147483648), (param_9 < bitcast<f32>(3472883712u))), 2147483647i, (param_9 > bitcast<f32>(1325400063u))), (param_9 == param_9)));
            if (_e221 > param_9) {
                phi_455_ = 1f;
            } else {
                phi_455_ = 0f;
            }
            let _e224 = phi_455_;
            if (param_9 < 8388608f) {
                phi_460_ = (_e221 - _e224);
                phi_461_ = false;
            } else {
                phi_460_ = f32();
                phi_461_ = true;
            }
            let _e227 = phi_460_;
            let _e229 = phi_461_;
            phi_462_ = _e227;
            phi_463_ = _e229;
        } else {
            phi_462_ = f32();
            phi_463_ = true;
        }
        let _e231 = phi_462_;
        let _e233 = phi_463_;
        if _e233 {
            phi_467_ = param_9;
        } else {
            phi_467_ = _e231;
        }
        let _e235 = phi_467_;
        phi_515_ = (param_9 - _e235);
    } else {
        if (_e208 == 1u) {
            let _e238 = (param_9 * 0.5f);
            if (_e238 > -8388608f) {
                let _e250 = f32(select(0i, select(select(i32(_e238), i32(-2147483648), (_e238 < bitcast<f32>(3472883712u))), 2147483647i, (_e238 > bitcast<f32>(1325400063u))), (_e238 == _e238)));
                if (_e250 > _e238) {
                    phi_493_ = 1f;
                } else {
                    phi_493_ = 0f;
                }
                let _e253 = phi_493_;
                if (_e238 < 8388608f) {
                    phi_498_ = (_e250 - _e253);
                    phi_499_ = false;
                } else {
                    phi_498_ = f32();
                    phi_499_ = true;
                }
                let _e256 = phi_498_;
                let _e258 = phi_499_;
                phi_500_ = _e256;
                phi_501_ = _e258;
            } else {
                phi_500_ = f32();
                phi_501_ = true;
            }
            let _e260 = phi_500_;
            let _e262 = phi_501_;
            if _e262 {
                phi_505_ = _e238;
            } else {
                phi_505_ = _e260;
            }
            let _e264 = phi_505_;
            let _e266 = (param_9 - (2f * _e264));
            if (_e266 > 1f) {
                phi_513_ = (2f - _e266);
            } else {
                phi_513_ = _e266;
            }
            let _e270 = phi_513_;
            phi_514_ = _e270;
        } else {
            phi_514_ = param_9;
        }
        let _e272 = phi_514_;
        phi_515_ = _e272;
    }
    let _e274 = phi_515_;
    if (_e274 > 0f) {
        if (_e274 < 1f) {
            phi_524_ = _e274;
        } else {
            phi_524_ = 1f;
        }
        let _e278 = phi_524_;
        phi_525_ = _e278;
    } else {
        phi_525_ = 0f;
    }
    let _e280 = phi_525_;
    let _e281 = (_e79 - 1u);
    let _e283 = (_e280 * f32(_e79));
    if _e83 {
        let _e290 = select(select(u32(_e283), 0u, (_e283 < bitcast<f32>(0u))), 4294967295u, (_e283 > bitcast<f32>(1333788671u)));
        if (_e281 < _e290) {
            phi_543_ = _e281;
        } else {
            phi_543_ = _e290;
        }
        let _e293 = phi_543_;
        phi_582_ = texture_Axis(_e293, _e293, 0f);
    } else {
        let _e295 = (_e283 + 0.5f);
        let _e302 = select(select(u32(_e295), 0u, (_e295 < bitcast<f32>(0u))), 4294967295u, (_e295 > bitcast<f32>(1333788671u)));
        if (_e79 < _e302) {
            phi_557_ = _e79;
        } else {
            phi_557_ = _e302;
        }
        let _e305 = phi_557_;
        if (_e208 == 0u) {
            phi_564_ = _e281;
        } else {
            phi_564_ = 0u;
        }
        let _e310 = phi_564_;
        if (_e208 == 0u) {
            phi_569_ = 0u;
        } else {
            phi_569_ = _e281;
        }
        let _e313 = phi_569_;
        if (_e305 == 0u) {
            phi_575_ = _e310;
        } else {
            phi_575_ = (_e305 - 1u);
        }
        let _e317 = phi_575_;
        if (_e305 > _e281) {
            phi_580_ = _e313;
        } else {
            phi_580_ = _e305;
        }
        let _e320 = phi_580_;
        phi_582_ = texture_Axis(_e317, _e320, (_e295 - f32(_e305)));
    }
    let _e323 = phi_582_;
    let _e327 = (*param_7).offset;
    let _e334 = (*param_7).offset;
    let _e341 = (*param_7).offset;
    let _e348 = (*param_7).offset;
    return texture_TexelQuad(array<u32, 4>(((_e327 + (_e323.low * _e75)) + _e203.low), ((_e334 + (_e323.low * _e75)) + _e203.high), ((_e341 + (_e323.high * _e75)) + _e203.low), ((_e348 + (_e323.high * _e75)) + _e203.high)), vec4<f32>(((1f - _e203.fraction) * (1f - _e323.fraction)), (_e203.fraction * (1f - _e323.fraction)), ((1f - _e203.fraction) * _e323.fraction), (_e203.fraction * _e323.fraction)));
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
    let _e74 = phi_641_;
    return _e74;
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
    var phi_764_: bool;
    var phi_765_: bool;
    var phi_766_: bool;
    var phi_767_: bool;
    var phi_771_: bool;
    var phi_784_: bool;
    var phi_785_: bool;
    var phi_786_: bool;
    var phi_787_: bool;
    var phi_791_: bool;
    var phi_804_: bool;
    var phi_805_: bool;
    var phi_806_: bool;
    var phi_810_: bool;
    var phi_811_: bool;
    var phi_812_: bool;
    var phi_813_: bool;
    var phi_814_: bool;
    var phi_818_: bool;
    var phi_894_: f32;
    var phi_901_: f32;
    var phi_909_: f32;
    var phi_916_: f32;
    var phi_924_: f32;
    var phi_931_: f32;
    var phi_954_: f32;
    var phi_959_: f32;
    var phi_964_: f32;
    var phi_969_: f32;
    var phi_974_: f32;
    var phi_1005_: bool;
    var phi_1006_: bool;
    var phi_1014_: u32;
    var phi_1015_: u32;
    var phi_1032_: vec3<f32>;
    var phi_1033_: vec3<f32>;
    var phi_1046_: u32;
    var phi_1051_: u32;
    var phi_1056_: u32;
    var phi_1170_: bool;
    var phi_1171_: bool;
    var phi_1202_: u32;
    var phi_1204_: lt_bvh_Hit;
    var phi_1207_: u32;
    var phi_1292_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1319_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1346_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1352_: u32;
    var phi_1355_: u32;
    var phi_1369_: u32;
    var phi_1379_: u32;
    var phi_1389_: u32;
    var phi_1407_: u32;
    var phi_1417_: u32;
    var phi_1427_: u32;
    var phi_1463_: u32;
    var phi_1476_: u32;
    var phi_1481_: u32;
    var phi_1482_: u32;
    var phi_1483_: u32;
    var phi_1353_: u32;
    var phi_1356_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_1541_: lt_bvh_Hit;
    var phi_1544_: u32;
    var phi_1590_: vec3<f32>;
    var phi_1591_: vec3<f32>;
    var phi_1622_: vec3<f32>;
    var phi_1623_: vec3<f32>;
    var phi_1654_: vec3<f32>;
    var phi_1655_: vec3<f32>;
    var phi_1673_: bool;
    var phi_1674_: bool;
    var phi_1678_: f32;
    var phi_1679_: f32;
    var phi_1680_: f32;
    var phi_1681_: f32;
    var phi_1689_: f32;
    var phi_1699_: bool;
    var phi_1700_: bool;
    var phi_1704_: f32;
    var phi_1705_: f32;
    var phi_1706_: f32;
    var phi_1707_: f32;
    var phi_1715_: f32;
    var phi_1725_: bool;
    var phi_1726_: bool;
    var phi_1730_: f32;
    var phi_1731_: f32;
    var phi_1732_: f32;
    var phi_1733_: f32;
    var phi_1741_: f32;
    var phi_1756_: f32;
    var phi_1757_: bool;
    var phi_1758_: f32;
    var phi_1759_: bool;
    var phi_1760_: f32;
    var phi_1761_: bool;
    var phi_1779_: f32;
    var phi_1780_: bool;
    var phi_1781_: bool;
    var phi_1782_: f32;
    var phi_1783_: bool;
    var phi_1784_: bool;
    var phi_1788_: bool;
    var phi_1789_: f32;
    var phi_1790_: bool;
    var phi_1820_: vec3<f32>;
    var phi_1821_: vec3<f32>;
    var phi_1846_: vec3<f32>;
    var phi_1847_: vec3<f32>;
    var phi_1872_: vec3<f32>;
    var phi_1873_: vec3<f32>;
    var phi_1931_: f32;
    var phi_1940_: f32;
    var phi_1949_: f32;
    var phi_1958_: f32;
    var phi_1965_: f32;
    var phi_1972_: f32;
    var phi_1985_: f32;
    var phi_1994_: f32;
    var phi_2003_: f32;
    var phi_2012_: f32;
    var phi_2019_: f32;
    var phi_2026_: f32;
    var phi_2049_: f32;
    var phi_2054_: f32;
    var phi_2059_: f32;
    var phi_2067_: f32;
    var phi_2072_: f32;
    var phi_2077_: f32;
    var phi_2089_: f32;
    var phi_2094_: f32;
    var phi_2099_: f32;
    var phi_2104_: f32;
    var phi_2109_: lt_bvh_triangle_Intersection;
    var phi_2110_: bool;
    var phi_2111_: lt_bvh_triangle_Intersection;
    var phi_2112_: bool;
    var phi_2116_: lt_bvh_triangle_Intersection;
    var phi_2117_: bool;
    var phi_2118_: lt_bvh_triangle_Intersection;
    var phi_2119_: bool;
    var phi_2120_: bool;
    var phi_2124_: bool;
    var phi_2128_: lt_bvh_triangle_Intersection;
    var phi_2167_: bool;
    var phi_2168_: bool;
    var phi_2169_: bool;
    var phi_2170_: bool;
    var phi_2171_: bool;
    var phi_2172_: bool;
    var phi_2176_: bool;
    var phi_2177_: bool;
    var phi_2191_: bool;
    var phi_2199_: lt_bvh_Hit;
    var phi_2200_: lt_bvh_Hit;
    var phi_2201_: lt_bvh_Hit;
    var phi_2202_: lt_bvh_Hit;
    var phi_1542_: lt_bvh_Hit;
    var phi_1545_: u32;
    var phi_2203_: bool;
    var phi_2242_: bool;
    var phi_2243_: bool;
    var phi_2274_: u32;
    var phi_1205_: lt_bvh_Hit;
    var phi_1208_: u32;
    var phi_2275_: lt_bvh_Hit;
    var phi_2276_: lt_bvh_Hit;
    var phi_2277_: bool;
    var phi_2281_: lt_bvh_Hit;
    var phi_2345_: f32;
    var phi_2350_: f32;
    var phi_2355_: f32;
    var phi_2366_: f32;
    var phi_2371_: f32;
    var phi_2376_: f32;
    var phi_2452_: vec3<f32>;
    var phi_2695_: vec3<f32>;
    var phi_2710_: u32;
    var phi_2737_: f32;
    var phi_2744_: f32;
    var phi_2751_: f32;
    var phi_2786_: f32;
    var phi_2793_: f32;
    var phi_2800_: f32;
    var phi_2838_: f32;
    var phi_2845_: f32;
    var phi_2852_: f32;
    var phi_2911_: vec3<f32>;
    var phi_2912_: vec3<f32>;
    var phi_2913_: vec3<f32>;
    var phi_2922_: f32;
    var phi_2923_: f32;
    var phi_2933_: f32;
    var phi_2934_: f32;
    var phi_2944_: f32;
    var phi_2945_: f32;
    var phi_2980_: abi_Sample;
    var phi_3071_: vec3<f32>;
    var local_5: lt_bvh_Hit;
    var local_6: lt_bvh_Hit;

    let _e72 = id_1;
    let _e76 = arrayLength((&nodes.member));
    let _e79 = arrayLength((&triangles.member));
    let _e82 = arrayLength((&vertices.member));
    let _e91 = arrayLength((&color_texels.member));
    let _e94 = arrayLength((&before.member));
    let _e100 = p.member.size[0u];
    let _e102 = p.member.size[1u];
    let _e103 = lt_shaders_entry_pixel_index(_e72, _e100, _e102);
    if (bitcast<i32>(_e103.word) != 0i) {
        let _e111 = p.member.eye;
        let _e116 = p.member.size[0u];
        let _e120 = ((((f32(_e72.x) + 0.5f) / f32(_e116)) * 2f) - 1f);
        let _e125 = p.member.size[1u];
        let _e129 = (1f - (((f32(_e72.y) + 0.5f) / f32(_e125)) * 2f));
        let _e131 = p.member.forward;
        let _e133 = p.member.right;
        let _e147 = p.member.up;
        let _e158 = _lt_bvh_ray_Ray_new(_e111, vec3<f32>(((_e131.x + (_e133.x * _e120)) + (_e147.x * _e129)), ((_e131.y + (_e133.y * _e120)) + (_e147.y * _e129)), ((_e131.z + (_e133.z * _e120)) + (_e147.z * _e129))));
        let _e160 = lt_bvh_Hit(_e158.tmax, 0f, 0f, 4294967295u, 4294967295u);
        let _e163 = abs(_e158.direction.x);
        let _e165 = abs(_e158.direction.y);
        let _e167 = abs(_e158.direction.z);
        if (abs(_e158.origin.x) < 1000000000000000f) {
            if (abs(_e158.origin.y) < 1000000000000000f) {
                phi_764_ = (abs(_e158.origin.z) < 1000000000000000f);
                phi_765_ = false;
            } else {
                phi_764_ = bool();
                phi_765_ = true;
            }
            let _e179 = phi_764_;
            let _e181 = phi_765_;
            phi_766_ = _e179;
            phi_767_ = _e181;
        } else {
            phi_766_ = bool();
            phi_767_ = true;
        }
        let _e183 = phi_766_;
        let _e185 = phi_767_;
        if _e185 {
            phi_771_ = false;
        } else {
            phi_771_ = _e183;
        }
        let _e187 = phi_771_;
        if _e187 {
            if (_e163 < 1000000000000000f) {
                if (_e165 < 1000000000000000f) {
                    phi_784_ = (_e167 < 1000000000000000f);
                    phi_785_ = false;
                } else {
                    phi_784_ = bool();
                    phi_785_ = true;
                }
                let _e192 = phi_784_;
                let _e194 = phi_785_;
                phi_786_ = _e192;
                phi_787_ = _e194;
            } else {
                phi_786_ = bool();
                phi_787_ = true;
            }
            let _e196 = phi_786_;
            let _e198 = phi_787_;
            if _e198 {
                phi_791_ = false;
            } else {
                phi_791_ = _e196;
            }
            let _e200 = phi_791_;
            if _e200 {
                if (_e163 > 0f) {
                    phi_805_ = bool();
                    phi_806_ = true;
                } else {
                    let _e202 = (_e165 > 0f);
                    if _e202 {
                        phi_804_ = bool();
                    } else {
                        phi_804_ = (_e167 > 0f);
                    }
                    let _e205 = phi_804_;
                    phi_805_ = _e205;
                    phi_806_ = _e202;
                }
                let _e207 = phi_805_;
                let _e209 = phi_806_;
                if _e209 {
                    phi_810_ = true;
                } else {
                    phi_810_ = _e207;
                }
                let _e211 = phi_810_;
                phi_811_ = _e211;
                phi_812_ = false;
            } else {
                phi_811_ = bool();
                phi_812_ = true;
            }
            let _e213 = phi_811_;
            let _e215 = phi_812_;
            phi_813_ = _e213;
            phi_814_ = _e215;
        } else {
            phi_813_ = bool();
            phi_814_ = true;
        }
        let _e217 = phi_813_;
        let _e219 = phi_814_;
        if _e219 {
            phi_818_ = false;
        } else {
            phi_818_ = _e217;
        }
        let _e221 = phi_818_;
        if _e221 {
            let _e222 = (0u >= _e76);
            if _e222 {
                phi_2275_ = lt_bvh_Hit();
            } else {
                if (0u < _e76) {
                } else {
                    return;
                }
                let _e228 = nodes.member[(0u + 0u)].frame[0u];
                let _e232 = nodes.member[(0u + 0u)].frame[1u];
                let _e236 = nodes.member[(0u + 0u)].frame[2u];
                let _e240 = nodes.member[(0u + 0u)].frame[0u];
                let _e244 = nodes.member[(0u + 0u)].frame[1u];
                let _e248 = nodes.member[(0u + 0u)].frame[2u];
                let _e252 = nodes.member[(0u + 0u)].frame[3u];
                let _e291 = core_intrinsics_maximum_number_nsz_f32_(abs(_e158.direction.x), abs(_e158.direction.y));
                let _e292 = core_intrinsics_maximum_number_nsz_f32_(_e291, abs(_e158.direction.z));
                let _e293 = (_e292 * 0.0000000000009094947f);
                if (abs(_e158.direction.x) < _e293) {
                    phi_894_ = _e293;
                } else {
                    phi_894_ = abs(_e158.direction.x);
                }
                let _e299 = phi_894_;
                if (_e158.direction.x < 0f) {
                    phi_901_ = (-1f / _e299);
                } else {
                    phi_901_ = (1f / _e299);
                }
                let _e304 = phi_901_;
                if (abs(_e158.direction.y) < _e293) {
                    phi_909_ = _e293;
                } else {
                    phi_909_ = abs(_e158.direction.y);
                }
                let _e310 = phi_909_;
                if (_e158.direction.y < 0f) {
                    phi_916_ = (-1f / _e310);
                } else {
                    phi_916_ = (1f / _e310);
                }
                let _e315 = phi_916_;
                if (abs(_e158.direction.z) < _e293) {
                    phi_924_ = _e293;
                } else {
                    phi_924_ = abs(_e158.direction.z);
                }
                let _e321 = phi_924_;
                if (_e158.direction.z < 0f) {
                    phi_931_ = (-1f / _e321);
                } else {
                    phi_931_ = (1f / _e321);
                }
                let _e326 = phi_931_;
                let _e333 = abs((bitcast<f32>(_e228) - _e158.origin.x));
                let _e334 = abs((bitcast<f32>(_e232) - _e158.origin.y));
                let _e335 = abs((bitcast<f32>(_e236) - _e158.origin.z));
                let _e342 = abs(((bitcast<f32>(_e240) + (bitcast<f32>((((_e252 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e158.origin.x));
                let _e343 = abs(((bitcast<f32>(_e244) + (bitcast<f32>((((_e252 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e158.origin.y));
                let _e344 = abs(((bitcast<f32>(_e248) + (bitcast<f32>((((_e252 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e158.origin.z));
                if (_e333 > _e342) {
                    phi_954_ = _e333;
                } else {
                    phi_954_ = _e342;
                }
                let _e347 = phi_954_;
                if (_e334 > _e343) {
                    phi_959_ = _e334;
                } else {
                    phi_959_ = _e343;
                }
                let _e350 = phi_959_;
                if (_e335 > _e344) {
                    phi_964_ = _e335;
                } else {
                    phi_964_ = _e344;
                }
                let _e353 = phi_964_;
                if (_e347 > _e350) {
                    phi_969_ = _e347;
                } else {
                    phi_969_ = _e350;
                }
                let _e356 = phi_969_;
                if (_e356 > _e353) {
                    phi_974_ = _e356;
                } else {
                    phi_974_ = _e353;
                }
                let _e359 = phi_974_;
                let _e363 = (_e359 * 0.0000019073486f);
                let _e364 = (abs(_e304) * _e363);
                let _e365 = (abs(_e315) * _e363);
                let _e366 = (abs(_e326) * _e363);
                let _e370 = (_e359 * 0.0000009536743f);
                let _e371 = (abs(_e304) * _e370);
                let _e372 = (abs(_e315) * _e370);
                let _e373 = (abs(_e326) * _e370);
                let _e377 = abs(_e158.direction.x);
                let _e379 = abs(_e158.direction.y);
                let _e381 = abs(_e158.direction.z);
                if (_e377 >= _e379) {
                    if (_e377 >= _e381) {
                        phi_1005_ = false;
                    } else {
                        phi_1005_ = true;
                    }
                    let _e385 = phi_1005_;
                    phi_1006_ = _e385;
                } else {
                    phi_1006_ = true;
                }
                let _e387 = phi_1006_;
                if _e387 {
                    if (_e379 >= _e381) {
                        phi_1014_ = 1u;
                    } else {
                        phi_1014_ = 2u;
                    }
                    let _e390 = phi_1014_;
                    phi_1015_ = _e390;
                } else {
                    phi_1015_ = 0u;
                }
                let _e392 = phi_1015_;
                if (_e392 == 0u) {
                    phi_1033_ = vec3<f32>(_e158.direction.y, _e158.direction.z, _e158.direction.x);
                } else {
                    if (_e392 == 1u) {
                        phi_1032_ = vec3<f32>(_e158.direction.z, _e158.direction.x, _e158.direction.y);
                    } else {
                        phi_1032_ = _e158.direction;
                    }
                    let _e404 = phi_1032_;
                    phi_1033_ = _e404;
                }
                let _e406 = phi_1033_;
                let _e409 = (_e406.x / _e406.z);
                let _e412 = (_e406.y / _e406.z);
                if (_e304 < 0f) {
                    phi_1046_ = 0u;
                } else {
                    phi_1046_ = 1u;
                }
                let _e417 = phi_1046_;
                if (_e315 < 0f) {
                    phi_1051_ = 0u;
                } else {
                    phi_1051_ = 2u;
                }
                let _e420 = phi_1051_;
                if (_e326 < 0f) {
                    phi_1056_ = 0u;
                } else {
                    phi_1056_ = 4u;
                }
                let _e423 = phi_1056_;
                let _e425 = ((_e417 | _e420) | _e423);
                let _e426 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e426.first[0], _e426.first[1], _e426.first[2], _e426.first[3], _e426.first[4], _e426.first[5], _e426.first[6], _e426.first[7], _e426.first[8], _e426.first[9], _e426.first[10], _e426.first[11], _e426.first[12], _e426.first[13], _e426.first[14], _e426.first[15], _e426.first[16], _e426.first[17], _e426.first[18], _e426.first[19], _e426.first[20], _e426.first[21], _e426.first[22], _e426.first[23], _e426.first[24], _e426.first[25], _e426.first[26], _e426.first[27], _e426.first[28], _e426.first[29], _e426.first[30], _e426.first[31]), array<u32, 32>(_e426.mask[0], _e426.mask[1], _e426.mask[2], _e426.mask[3], _e426.mask[4], _e426.mask[5], _e426.mask[6], _e426.mask[7], _e426.mask[8], _e426.mask[9], _e426.mask[10], _e426.mask[11], _e426.mask[12], _e426.mask[13], _e426.mask[14], _e426.mask[15], _e426.mask[16], _e426.mask[17], _e426.mask[18], _e426.mask[19], _e426.mask[20], _e426.mask[21], _e426.mask[22], _e426.mask[23], _e426.mask[24], _e426.mask[25], _e426.mask[26], _e426.mask[27], _e426.mask[28], _e426.mask[29], _e426.mask[30], _e426.mask[31]), _e426.len, _e426.group, _e426.group_mask);
                let _e500 = local_1.group_mask;
                if ((_e500 & 4278190080u) == 0u) {
                    let _e504 = local_1.len;
                    if (_e504 == 0u) {
                        phi_1170_ = false;
                    } else {
                        let _e508 = local_1.len;
                        local_1.len = (_e508 - 1u);
                        let _e511 = local_1.len;
                        if (_e511 < 32u) {
                        } else {
                            return;
                        }
                        let _e516 = local_1.first[(0u + _e511)];
                        local_1.group = _e516;
                        let _e519 = local_1.len;
                        if (_e519 < 32u) {
                        } else {
                            return;
                        }
                        let _e524 = local_1.mask[(0u + _e519)];
                        local_1.group_mask = _e524;
                        phi_1170_ = true;
                    }
                    let _e527 = phi_1170_;
                    phi_1171_ = _e527;
                } else {
                    phi_1171_ = true;
                }
                let _e529 = phi_1171_;
                if _e529 {
                    let _e531 = local_1.group_mask;
                    let _e537 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e531)), 32u, (_e531 == 0u)));
                    let _e541 = local_1.group_mask;
                    let _e555 = local_1.group_mask;
                    local_1.group_mask = (_e555 & ~((1u << bitcast<u32>((_e537 & 31u)))));
                    let _e558 = local_1.group;
                    phi_1202_ = (_e558 + countOneBits(((_e541 & ~((4294967295u << bitcast<u32>((((_e537 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1202_ = 4294967295u;
                }
                let _e561 = phi_1202_;
                phi_1204_ = _e160;
                phi_1207_ = _e561;
                loop {
                    let _e563 = phi_1204_;
                    let _e565 = phi_1207_;
                    local_6 = _e563;
                    let _e566 = (_e565 != 4294967295u);
                    if _e566 {
                        if (_e565 < _e76) {
                        } else {
                            return;
                        }
                        let _e574 = nodes.member[(0u + _e565)].frame[3u];
                        let _e599 = (bitcast<f32>((((_e574 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e304);
                        let _e600 = (bitcast<f32>((((_e574 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e315);
                        let _e601 = (bitcast<f32>((((_e574 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e326);
                        let _e604 = nodes.member[(0u + _e565)].frame[0u];
                        let _e608 = nodes.member[(0u + _e565)].frame[1u];
                        let _e612 = nodes.member[(0u + _e565)].frame[2u];
                        let _e620 = ((bitcast<f32>(_e604) - _e158.origin.x) * _e304);
                        let _e621 = ((bitcast<f32>(_e608) - _e158.origin.y) * _e315);
                        let _e622 = ((bitcast<f32>(_e612) - _e158.origin.z) * _e326);
                        let _e630 = nodes.member[(0u + _e565)].x;
                        if (_e304 < 0f) {
                            let _e641 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e630.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e647 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e641.unnamed.word, _e630.w), _e641.unnamed_1);
                            let _e653 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e647.unnamed, lt_mask_LightPlace(_e630.x, _e647.unnamed_1.shift));
                            phi_1292_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e653.unnamed, lt_mask_LightPlace(_e653.unnamed_1.word, _e630.y));
                        } else {
                            let _e669 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e630.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e675 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e669.unnamed.word, _e630.y), _e669.unnamed_1);
                            let _e681 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e675.unnamed, lt_mask_LightPlace(_e630.z, _e675.unnamed_1.shift));
                            phi_1292_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e681.unnamed, lt_mask_LightPlace(_e681.unnamed_1.word, _e630.w));
                        }
                        let _e689 = phi_1292_;
                        let _e699 = nodes.member[(0u + _e565)].y;
                        if (_e315 < 0f) {
                            let _e710 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e699.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e716 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e710.unnamed.word, _e699.w), _e710.unnamed_1);
                            let _e722 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e716.unnamed, lt_mask_LightPlace(_e699.x, _e716.unnamed_1.shift));
                            phi_1319_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e722.unnamed, lt_mask_LightPlace(_e722.unnamed_1.word, _e699.y));
                        } else {
                            let _e738 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e699.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e744 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e738.unnamed.word, _e699.y), _e738.unnamed_1);
                            let _e750 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e744.unnamed, lt_mask_LightPlace(_e699.z, _e744.unnamed_1.shift));
                            phi_1319_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e750.unnamed, lt_mask_LightPlace(_e750.unnamed_1.word, _e699.w));
                        }
                        let _e758 = phi_1319_;
                        let _e768 = nodes.member[(0u + _e565)].z;
                        if (_e326 < 0f) {
                            let _e779 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e768.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e785 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e779.unnamed.word, _e768.w), _e779.unnamed_1);
                            let _e791 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e785.unnamed, lt_mask_LightPlace(_e768.x, _e785.unnamed_1.shift));
                            phi_1346_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e791.unnamed, lt_mask_LightPlace(_e791.unnamed_1.word, _e768.y));
                        } else {
                            let _e807 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e768.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e813 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e807.unnamed.word, _e768.y), _e807.unnamed_1);
                            let _e819 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e813.unnamed, lt_mask_LightPlace(_e768.z, _e813.unnamed_1.shift));
                            phi_1346_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e819.unnamed, lt_mask_LightPlace(_e819.unnamed_1.word, _e768.w));
                        }
                        let _e827 = phi_1346_;
                        phi_1352_ = 0u;
                        phi_1355_ = 0u;
                        loop {
                            let _e837 = phi_1352_;
                            let _e839 = phi_1355_;
                            local_2 = _e839;
                            local_3 = _e839;
                            local_4 = _e839;
                            let _e840 = (_e837 < 8u);
                            if _e840 {
                                let _e842 = (_e837 >> bitcast<u32>(2i));
                                let _e843 = (_e837 & 3u);
                                if (_e842 == 0u) {
                                    phi_1369_ = _e689.unnamed.word;
                                } else {
                                    phi_1369_ = _e689.unnamed.shift;
                                }
                                let _e846 = phi_1369_;
                                if (_e842 == 0u) {
                                    phi_1379_ = _e758.unnamed.word;
                                } else {
                                    phi_1379_ = _e758.unnamed.shift;
                                }
                                let _e855 = phi_1379_;
                                if (_e842 == 0u) {
                                    phi_1389_ = _e827.unnamed.word;
                                } else {
                                    phi_1389_ = _e827.unnamed.shift;
                                }
                                let _e864 = phi_1389_;
                                let _e877 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e846 >> bitcast<u32>(((_e843 * 8u) & 31u))) & 255u)) * _e599) + (_e620 - _e364)), ((f32(((_e855 >> bitcast<u32>(((_e843 * 8u) & 31u))) & 255u)) * _e600) + (_e621 - _e365)));
                                let _e878 = core_intrinsics_maximum_number_nsz_f32_(_e877, ((f32(((_e864 >> bitcast<u32>(((_e843 * 8u) & 31u))) & 255u)) * _e601) + (_e622 - _e366)));
                                if (_e842 == 0u) {
                                    phi_1407_ = _e689.unnamed_1.word;
                                } else {
                                    phi_1407_ = _e689.unnamed_1.shift;
                                }
                                let _e881 = phi_1407_;
                                if (_e842 == 0u) {
                                    phi_1417_ = _e758.unnamed_1.word;
                                } else {
                                    phi_1417_ = _e758.unnamed_1.shift;
                                }
                                let _e890 = phi_1417_;
                                if (_e842 == 0u) {
                                    phi_1427_ = _e827.unnamed_1.word;
                                } else {
                                    phi_1427_ = _e827.unnamed_1.shift;
                                }
                                let _e899 = phi_1427_;
                                let _e912 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e881 >> bitcast<u32>(((_e843 * 8u) & 31u))) & 255u)) * _e599) + (_e620 + _e364)), ((f32(((_e890 >> bitcast<u32>(((_e843 * 8u) & 31u))) & 255u)) * _e600) + (_e621 + _e365)));
                                let _e913 = core_intrinsics_minimum_number_nsz_f32_(_e912, ((f32(((_e899 >> bitcast<u32>(((_e843 * 8u) & 31u))) & 255u)) * _e601) + (_e622 + _e366)));
                                if (_e878 <= _e913) {
                                    if (_e878 <= _e563.t) {
                                        if (_e913 >= _e158.tmin) {
                                            if (_e842 == 0u) {
                                                let _e920 = nodes.member[(0u + _e565)].links[2u];
                                                phi_1463_ = _e920;
                                            } else {
                                                let _e923 = nodes.member[(0u + _e565)].links[3u];
                                                phi_1463_ = _e923;
                                            }
                                            let _e925 = phi_1463_;
                                            let _e930 = ((_e925 >> bitcast<u32>(((_e843 * 8u) & 31u))) & 255u);
                                            let _e931 = (_e930 & 31u);
                                            if (_e931 >= 24u) {
                                                phi_1476_ = (24u + ((_e931 - 24u) ^ _e425));
                                            } else {
                                                phi_1476_ = _e931;
                                            }
                                            let _e937 = phi_1476_;
                                            phi_1481_ = (_e839 | ((_e930 >> bitcast<u32>(5i)) << bitcast<u32>((_e937 & 31u))));
                                        } else {
                                            phi_1481_ = _e839;
                                        }
                                        let _e945 = phi_1481_;
                                        phi_1482_ = _e945;
                                    } else {
                                        phi_1482_ = _e839;
                                    }
                                    let _e947 = phi_1482_;
                                    phi_1483_ = _e947;
                                } else {
                                    phi_1483_ = _e839;
                                }
                                let _e949 = phi_1483_;
                                phi_1353_ = (_e837 + 1u);
                                phi_1356_ = _e949;
                            } else {
                                phi_1353_ = u32();
                                phi_1356_ = u32();
                            }
                            let _e952 = phi_1353_;
                            let _e954 = phi_1356_;
                            continue;
                            continuing {
                                phi_1352_ = _e952;
                                phi_1355_ = _e954;
                                break if !(_e840);
                            }
                        }
                        let _e958 = nodes.member[(0u + _e565)].links[0u];
                        let _e962 = nodes.member[(0u + _e565)].frame[3u];
                        let _e966 = local_2;
                        if ((_e966 & 4278190080u) == 0u) {
                        } else {
                            let _e970 = local_1.group_mask;
                            if ((_e970 & 4278190080u) == 0u) {
                            } else {
                                let _e974 = local_1.len;
                                if (_e974 < 32u) {
                                    let _e977 = local_1.group;
                                    let _e979 = local_1.len;
                                    if (_e979 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.first[(0u + _e979)] = _e977;
                                    let _e985 = local_1.group_mask;
                                    let _e987 = local_1.len;
                                    if (_e987 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.mask[(0u + _e987)] = _e985;
                                    let _e994 = local_1.len;
                                    local_1.len = (_e994 + 1u);
                                }
                            }
                            local_1.group = (0u + _e958);
                            let _e998 = local_3;
                            local_1.group_mask = ((_e998 & 4278190080u) | (_e962 >> bitcast<u32>(24i)));
                        }
                        let _e1003 = local_4;
                        phi_1541_ = _e563;
                        phi_1544_ = (_e1003 & 16777215u);
                        loop {
                            let _e1006 = phi_1541_;
                            let _e1008 = phi_1544_;
                            local_5 = _e1006;
                            if (_e1008 == 0u) {
                                phi_1542_ = lt_bvh_Hit();
                                phi_1545_ = u32();
                                phi_2203_ = false;
                            } else {
                                let _e1012 = nodes.member[(0u + _e565)].links[1u];
                                let _e1017 = ((0u + _e1012) + select(firstTrailingBit(_e1008), 32u, (_e1008 == 0u)));
                                if (_e1017 < _e79) {
                                } else {
                                    return;
                                }
                                let _e1024 = triangles.member[(0u + _e1017)].v0_;
                                let _e1027 = (_e1024.x - _e158.origin.x);
                                let _e1030 = (_e1024.y - _e158.origin.y);
                                let _e1033 = (_e1024.z - _e158.origin.z);
                                if (_e392 == 0u) {
                                    phi_1591_ = vec3<f32>(_e1030, _e1033, _e1027);
                                } else {
                                    if (_e392 == 1u) {
                                        phi_1590_ = vec3<f32>(_e1033, _e1027, _e1030);
                                    } else {
                                        phi_1590_ = (_e1024 - _e158.origin);
                                    }
                                    let _e1040 = phi_1590_;
                                    phi_1591_ = _e1040;
                                }
                                let _e1042 = phi_1591_;
                                let _e1046 = (_e1042.x - (_e409 * _e1042.z));
                                let _e1050 = (_e1042.y - (_e412 * _e1042.z));
                                let _e1052 = triangles.member[(0u + _e1017)].v1_;
                                let _e1055 = (_e1052.x - _e158.origin.x);
                                let _e1058 = (_e1052.y - _e158.origin.y);
                                let _e1061 = (_e1052.z - _e158.origin.z);
                                if (_e392 == 0u) {
                                    phi_1623_ = vec3<f32>(_e1058, _e1061, _e1055);
                                } else {
                                    if (_e392 == 1u) {
                                        phi_1622_ = vec3<f32>(_e1061, _e1055, _e1058);
                                    } else {
                                        phi_1622_ = (_e1052 - _e158.origin);
                                    }
                                    let _e1068 = phi_1622_;
                                    phi_1623_ = _e1068;
                                }
                                let _e1070 = phi_1623_;
                                let _e1074 = (_e1070.x - (_e409 * _e1070.z));
                                let _e1078 = (_e1070.y - (_e412 * _e1070.z));
                                let _e1080 = triangles.member[(0u + _e1017)].v2_;
                                let _e1083 = (_e1080.x - _e158.origin.x);
                                let _e1086 = (_e1080.y - _e158.origin.y);
                                let _e1089 = (_e1080.z - _e158.origin.z);
                                if (_e392 == 0u) {
                                    phi_1655_ = vec3<f32>(_e1086, _e1089, _e1083);
                                } else {
                                    if (_e392 == 1u) {
                                        phi_1654_ = vec3<f32>(_e1089, _e1083, _e1086);
                                    } else {
                                        phi_1654_ = (_e1080 - _e158.origin);
                                    }
                                    let _e1096 = phi_1654_;
                                    phi_1655_ = _e1096;
                                }
                                let _e1098 = phi_1655_;
                                let _e1102 = (_e1098.x - (_e409 * _e1098.z));
                                let _e1106 = (_e1098.y - (_e412 * _e1098.z));
                                if (_e1074 < _e1102) {
                                    phi_1674_ = true;
                                } else {
                                    if (_e1074 == _e1102) {
                                        phi_1673_ = (_e1078 < _e1106);
                                    } else {
                                        phi_1673_ = false;
                                    }
                                    let _e1111 = phi_1673_;
                                    phi_1674_ = _e1111;
                                }
                                let _e1113 = phi_1674_;
                                if _e1113 {
                                    phi_1678_ = _e1106;
                                    phi_1679_ = _e1102;
                                    phi_1680_ = _e1078;
                                    phi_1681_ = _e1074;
                                } else {
                                    phi_1678_ = _e1078;
                                    phi_1679_ = _e1074;
                                    phi_1680_ = _e1106;
                                    phi_1681_ = _e1102;
                                }
                                let _e1115 = phi_1678_;
                                let _e1117 = phi_1679_;
                                let _e1119 = phi_1680_;
                                let _e1121 = phi_1681_;
                                let _e1124 = ((_e1121 * _e1115) - (_e1119 * _e1117));
                                if _e1113 {
                                    phi_1689_ = -(_e1124);
                                } else {
                                    phi_1689_ = _e1124;
                                }
                                let _e1127 = phi_1689_;
                                if (_e1102 < _e1046) {
                                    phi_1700_ = true;
                                } else {
                                    if (_e1102 == _e1046) {
                                        phi_1699_ = (_e1106 < _e1050);
                                    } else {
                                        phi_1699_ = false;
                                    }
                                    let _e1132 = phi_1699_;
                                    phi_1700_ = _e1132;
                                }
                                let _e1134 = phi_1700_;
                                if _e1134 {
                                    phi_1704_ = _e1050;
                                    phi_1705_ = _e1046;
                                    phi_1706_ = _e1106;
                                    phi_1707_ = _e1102;
                                } else {
                                    phi_1704_ = _e1106;
                                    phi_1705_ = _e1102;
                                    phi_1706_ = _e1050;
                                    phi_1707_ = _e1046;
                                }
                                let _e1136 = phi_1704_;
                                let _e1138 = phi_1705_;
                                let _e1140 = phi_1706_;
                                let _e1142 = phi_1707_;
                                let _e1145 = ((_e1142 * _e1136) - (_e1140 * _e1138));
                                if _e1134 {
                                    phi_1715_ = -(_e1145);
                                } else {
                                    phi_1715_ = _e1145;
                                }
                                let _e1148 = phi_1715_;
                                if (_e1046 < _e1074) {
                                    phi_1726_ = true;
                                } else {
                                    if (_e1046 == _e1074) {
                                        phi_1725_ = (_e1050 < _e1078);
                                    } else {
                                        phi_1725_ = false;
                                    }
                                    let _e1153 = phi_1725_;
                                    phi_1726_ = _e1153;
                                }
                                let _e1155 = phi_1726_;
                                if _e1155 {
                                    phi_1730_ = _e1078;
                                    phi_1731_ = _e1074;
                                    phi_1732_ = _e1050;
                                    phi_1733_ = _e1046;
                                } else {
                                    phi_1730_ = _e1050;
                                    phi_1731_ = _e1046;
                                    phi_1732_ = _e1078;
                                    phi_1733_ = _e1074;
                                }
                                let _e1157 = phi_1730_;
                                let _e1159 = phi_1731_;
                                let _e1161 = phi_1732_;
                                let _e1163 = phi_1733_;
                                let _e1166 = ((_e1163 * _e1157) - (_e1161 * _e1159));
                                if _e1155 {
                                    phi_1741_ = -(_e1166);
                                } else {
                                    phi_1741_ = _e1166;
                                }
                                let _e1169 = phi_1741_;
                                if (_e1127 >= 0f) {
                                    if (_e1148 >= 0f) {
                                        if (_e1169 >= 0f) {
                                            phi_1756_ = ((_e1127 + _e1148) + _e1169);
                                            phi_1757_ = false;
                                        } else {
                                            phi_1756_ = f32();
                                            phi_1757_ = true;
                                        }
                                        let _e1176 = phi_1756_;
                                        let _e1178 = phi_1757_;
                                        phi_1758_ = _e1176;
                                        phi_1759_ = _e1178;
                                    } else {
                                        phi_1758_ = f32();
                                        phi_1759_ = true;
                                    }
                                    let _e1180 = phi_1758_;
                                    let _e1182 = phi_1759_;
                                    phi_1760_ = _e1180;
                                    phi_1761_ = _e1182;
                                } else {
                                    phi_1760_ = f32();
                                    phi_1761_ = true;
                                }
                                let _e1184 = phi_1760_;
                                let _e1186 = phi_1761_;
                                if _e1186 {
                                    if (_e1127 <= 0f) {
                                        if (_e1148 <= 0f) {
                                            let _e1189 = (_e1169 <= 0f);
                                            if _e1189 {
                                            }
                                            phi_1779_ = ((_e1127 + _e1148) + _e1169);
                                            phi_1780_ = false;
                                            phi_1781_ = _e1189;
                                        } else {
                                            phi_1779_ = f32();
                                            phi_1780_ = true;
                                            phi_1781_ = false;
                                        }
                                        let _e1193 = phi_1779_;
                                        let _e1195 = phi_1780_;
                                        let _e1197 = phi_1781_;
                                        phi_1782_ = _e1193;
                                        phi_1783_ = _e1195;
                                        phi_1784_ = _e1197;
                                    } else {
                                        phi_1782_ = f32();
                                        phi_1783_ = true;
                                        phi_1784_ = false;
                                    }
                                    let _e1199 = phi_1782_;
                                    let _e1201 = phi_1783_;
                                    let _e1203 = phi_1784_;
                                    if _e1201 {
                                        phi_1788_ = false;
                                    } else {
                                        phi_1788_ = _e1203;
                                    }
                                    let _e1205 = phi_1788_;
                                    phi_1789_ = _e1199;
                                    phi_1790_ = _e1205;
                                } else {
                                    phi_1789_ = _e1184;
                                    phi_1790_ = true;
                                }
                                let _e1207 = phi_1789_;
                                let _e1209 = phi_1790_;
                                if _e1209 {
                                    let _e1210 = (_e1207 == 0f);
                                    if _e1210 {
                                        phi_2116_ = lt_bvh_triangle_Intersection();
                                        phi_2117_ = false;
                                    } else {
                                        let _e1212 = triangles.member[(0u + _e1017)].v0_;
                                        let _e1215 = (_e1212.x - _e158.origin.x);
                                        let _e1218 = (_e1212.y - _e158.origin.y);
                                        let _e1221 = (_e1212.z - _e158.origin.z);
                                        if (_e392 == 0u) {
                                            phi_1821_ = vec3<f32>(_e1218, _e1221, _e1215);
                                        } else {
                                            if (_e392 == 1u) {
                                                phi_1820_ = vec3<f32>(_e1221, _e1215, _e1218);
                                            } else {
                                                phi_1820_ = (_e1212 - _e158.origin);
                                            }
                                            let _e1228 = phi_1820_;
                                            phi_1821_ = _e1228;
                                        }
                                        let _e1230 = phi_1821_;
                                        let _e1232 = triangles.member[(0u + _e1017)].v1_;
                                        let _e1234 = triangles.member[(0u + _e1017)].v0_;
                                        let _e1237 = (_e1232.x - _e1234.x);
                                        let _e1240 = (_e1232.y - _e1234.y);
                                        let _e1243 = (_e1232.z - _e1234.z);
                                        if (_e392 == 0u) {
                                            phi_1847_ = vec3<f32>(_e1240, _e1243, _e1237);
                                        } else {
                                            if (_e392 == 1u) {
                                                phi_1846_ = vec3<f32>(_e1243, _e1237, _e1240);
                                            } else {
                                                phi_1846_ = (_e1232 - _e1234);
                                            }
                                            let _e1250 = phi_1846_;
                                            phi_1847_ = _e1250;
                                        }
                                        let _e1252 = phi_1847_;
                                        let _e1254 = triangles.member[(0u + _e1017)].v2_;
                                        let _e1256 = triangles.member[(0u + _e1017)].v0_;
                                        let _e1259 = (_e1254.x - _e1256.x);
                                        let _e1262 = (_e1254.y - _e1256.y);
                                        let _e1265 = (_e1254.z - _e1256.z);
                                        if (_e392 == 0u) {
                                            phi_1873_ = vec3<f32>(_e1262, _e1265, _e1259);
                                        } else {
                                            if (_e392 == 1u) {
                                                phi_1872_ = vec3<f32>(_e1265, _e1259, _e1262);
                                            } else {
                                                phi_1872_ = (_e1254 - _e1256);
                                            }
                                            let _e1272 = phi_1872_;
                                            phi_1873_ = _e1272;
                                        }
                                        let _e1274 = phi_1873_;
                                        let _e1281 = ((_e1252.y * _e1274.z) - (_e1252.z * _e1274.y));
                                        let _e1288 = ((_e1252.z * _e1274.x) - (_e1252.x * _e1274.z));
                                        let _e1295 = ((_e1252.x * _e1274.y) - (_e1252.y * _e1274.x));
                                        let _e1309 = (((1f / _e406.z) * (((_e1281 * _e1230.x) + (_e1288 * _e1230.y)) + (_e1295 * _e1230.z))) / (((_e1281 * _e409) + (_e1288 * _e412)) + _e1295));
                                        if (_e1309 > _e158.tmin) {
                                            if (_e1309 < _e158.tmax) {
                                                let _e1315 = triangles.member[(0u + _e1017)].v0_;
                                                let _e1317 = triangles.member[(0u + _e1017)].v1_;
                                                if (_e1315.x < _e1317.x) {
                                                    phi_1931_ = _e1315.x;
                                                } else {
                                                    phi_1931_ = _e1317.x;
                                                }
                                                let _e1324 = phi_1931_;
                                                if (_e1315.y < _e1317.y) {
                                                    phi_1940_ = _e1315.y;
                                                } else {
                                                    phi_1940_ = _e1317.y;
                                                }
                                                let _e1331 = phi_1940_;
                                                if (_e1315.z < _e1317.z) {
                                                    phi_1949_ = _e1315.z;
                                                } else {
                                                    phi_1949_ = _e1317.z;
                                                }
                                                let _e1338 = phi_1949_;
                                                let _e1340 = triangles.member[(0u + _e1017)].v2_;
                                                if (_e1324 < _e1340.x) {
                                                    phi_1958_ = _e1324;
                                                } else {
                                                    phi_1958_ = _e1340.x;
                                                }
                                                let _e1345 = phi_1958_;
                                                if (_e1331 < _e1340.y) {
                                                    phi_1965_ = _e1331;
                                                } else {
                                                    phi_1965_ = _e1340.y;
                                                }
                                                let _e1350 = phi_1965_;
                                                if (_e1338 < _e1340.z) {
                                                    phi_1972_ = _e1338;
                                                } else {
                                                    phi_1972_ = _e1340.z;
                                                }
                                                let _e1355 = phi_1972_;
                                                let _e1357 = triangles.member[(0u + _e1017)].v0_;
                                                let _e1359 = triangles.member[(0u + _e1017)].v1_;
                                                if (_e1357.x > _e1359.x) {
                                                    phi_1985_ = _e1357.x;
                                                } else {
                                                    phi_1985_ = _e1359.x;
                                                }
                                                let _e1366 = phi_1985_;
                                                if (_e1357.y > _e1359.y) {
                                                    phi_1994_ = _e1357.y;
                                                } else {
                                                    phi_1994_ = _e1359.y;
                                                }
                                                let _e1373 = phi_1994_;
                                                if (_e1357.z > _e1359.z) {
                                                    phi_2003_ = _e1357.z;
                                                } else {
                                                    phi_2003_ = _e1359.z;
                                                }
                                                let _e1380 = phi_2003_;
                                                let _e1382 = triangles.member[(0u + _e1017)].v2_;
                                                if (_e1366 > _e1382.x) {
                                                    phi_2012_ = _e1366;
                                                } else {
                                                    phi_2012_ = _e1382.x;
                                                }
                                                let _e1387 = phi_2012_;
                                                if (_e1373 > _e1382.y) {
                                                    phi_2019_ = _e1373;
                                                } else {
                                                    phi_2019_ = _e1382.y;
                                                }
                                                let _e1392 = phi_2019_;
                                                if (_e1380 > _e1382.z) {
                                                    phi_2026_ = _e1380;
                                                } else {
                                                    phi_2026_ = _e1382.z;
                                                }
                                                let _e1397 = phi_2026_;
                                                let _e1404 = ((_e1345 - _e158.origin.x) * _e304);
                                                let _e1405 = ((_e1350 - _e158.origin.y) * _e315);
                                                let _e1406 = ((_e1355 - _e158.origin.z) * _e326);
                                                let _e1413 = ((_e1387 - _e158.origin.x) * _e304);
                                                let _e1414 = ((_e1392 - _e158.origin.y) * _e315);
                                                let _e1415 = ((_e1397 - _e158.origin.z) * _e326);
                                                if (_e1404 < _e1413) {
                                                    phi_2049_ = _e1404;
                                                } else {
                                                    phi_2049_ = _e1413;
                                                }
                                                let _e1418 = phi_2049_;
                                                if (_e1405 < _e1414) {
                                                    phi_2054_ = _e1405;
                                                } else {
                                                    phi_2054_ = _e1414;
                                                }
                                                let _e1421 = phi_2054_;
                                                if (_e1406 < _e1415) {
                                                    phi_2059_ = _e1406;
                                                } else {
                                                    phi_2059_ = _e1415;
                                                }
                                                let _e1424 = phi_2059_;
                                                if (_e1404 > _e1413) {
                                                    phi_2067_ = _e1404;
                                                } else {
                                                    phi_2067_ = _e1413;
                                                }
                                                let _e1430 = phi_2067_;
                                                if (_e1405 > _e1414) {
                                                    phi_2072_ = _e1405;
                                                } else {
                                                    phi_2072_ = _e1414;
                                                }
                                                let _e1433 = phi_2072_;
                                                if (_e1406 > _e1415) {
                                                    phi_2077_ = _e1406;
                                                } else {
                                                    phi_2077_ = _e1415;
                                                }
                                                let _e1436 = phi_2077_;
                                                let _e1440 = core_intrinsics_maximum_number_nsz_f32_((_e1418 - _e371), (_e1421 - _e372));
                                                let _e1441 = core_intrinsics_maximum_number_nsz_f32_(_e1440, (_e1424 - _e373));
                                                let _e1442 = core_intrinsics_minimum_number_nsz_f32_((_e1430 + _e371), (_e1433 + _e372));
                                                let _e1443 = core_intrinsics_minimum_number_nsz_f32_(_e1442, (_e1436 + _e373));
                                                if (_e1441 > -300000000000000000000000000000000000000f) {
                                                    phi_2089_ = _e1441;
                                                } else {
                                                    phi_2089_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1446 = phi_2089_;
                                                if (_e1443 < 300000000000000000000000000000000000000f) {
                                                    phi_2094_ = _e1443;
                                                } else {
                                                    phi_2094_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1449 = phi_2094_;
                                                if (_e1309 < _e1446) {
                                                    phi_2099_ = _e1446;
                                                } else {
                                                    phi_2099_ = _e1309;
                                                }
                                                let _e1452 = phi_2099_;
                                                if (_e1452 > _e1449) {
                                                    phi_2104_ = _e1449;
                                                } else {
                                                    phi_2104_ = _e1452;
                                                }
                                                let _e1455 = phi_2104_;
                                                phi_2109_ = lt_bvh_triangle_Intersection(_e1455, (_e1148 / _e1207), (_e1169 / _e1207), (_e1446 <= _e1449));
                                                phi_2110_ = false;
                                            } else {
                                                phi_2109_ = lt_bvh_triangle_Intersection();
                                                phi_2110_ = true;
                                            }
                                            let _e1461 = phi_2109_;
                                            let _e1463 = phi_2110_;
                                            phi_2111_ = _e1461;
                                            phi_2112_ = _e1463;
                                        } else {
                                            phi_2111_ = lt_bvh_triangle_Intersection();
                                            phi_2112_ = true;
                                        }
                                        let _e1465 = phi_2111_;
                                        let _e1467 = phi_2112_;
                                        if _e1467 {
                                        }
                                        phi_2116_ = _e1465;
                                        phi_2117_ = _e1467;
                                    }
                                    let _e1469 = phi_2116_;
                                    let _e1471 = phi_2117_;
                                    phi_2118_ = _e1469;
                                    phi_2119_ = _e1210;
                                    phi_2120_ = _e1471;
                                } else {
                                    phi_2118_ = lt_bvh_triangle_Intersection();
                                    phi_2119_ = true;
                                    phi_2120_ = false;
                                }
                                let _e1473 = phi_2118_;
                                let _e1475 = phi_2119_;
                                let _e1477 = phi_2120_;
                                if _e1475 {
                                    phi_2124_ = true;
                                } else {
                                    phi_2124_ = _e1477;
                                }
                                let _e1479 = phi_2124_;
                                if _e1479 {
                                    phi_2128_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_2128_ = _e1473;
                                }
                                let _e1481 = phi_2128_;
                                if _e1481.is_hit {
                                    if (_e1481.t > _e158.tmin) {
                                        if (_e1481.t < _e1006.t) {
                                            phi_2177_ = true;
                                        } else {
                                            if (_e1481.t == _e1006.t) {
                                                if (_e1006.triangle != 4294967295u) {
                                                    if (_e1017 < _e1006.triangle) {
                                                        phi_2168_ = true;
                                                    } else {
                                                        if (_e1017 == _e1006.triangle) {
                                                            phi_2167_ = (4294967295u < _e1006.instance);
                                                        } else {
                                                            phi_2167_ = false;
                                                        }
                                                        let _e1500 = phi_2167_;
                                                        phi_2168_ = _e1500;
                                                    }
                                                    let _e1502 = phi_2168_;
                                                    phi_2169_ = _e1502;
                                                    phi_2170_ = false;
                                                } else {
                                                    phi_2169_ = bool();
                                                    phi_2170_ = true;
                                                }
                                                let _e1504 = phi_2169_;
                                                let _e1506 = phi_2170_;
                                                phi_2171_ = _e1504;
                                                phi_2172_ = _e1506;
                                            } else {
                                                phi_2171_ = bool();
                                                phi_2172_ = true;
                                            }
                                            let _e1508 = phi_2171_;
                                            let _e1510 = phi_2172_;
                                            if _e1510 {
                                                phi_2176_ = false;
                                            } else {
                                                phi_2176_ = _e1508;
                                            }
                                            let _e1512 = phi_2176_;
                                            phi_2177_ = _e1512;
                                        }
                                        let _e1514 = phi_2177_;
                                        if _e1514 {
                                            let _e1516 = triangles.member[(0u + _e1017)].i0_;
                                            if ((_e1516 & 2147483648u) == 0u) {
                                                phi_2191_ = true;
                                            } else {
                                                if true {
                                                }
                                                phi_2191_ = true;
                                            }
                                            let _e1520 = phi_2191_;
                                            if _e1520 {
                                                phi_2199_ = lt_bvh_Hit(_e1481.t, _e1481.u, _e1481.v, _e1017, 4294967295u);
                                            } else {
                                                phi_2199_ = _e1006;
                                            }
                                            let _e1526 = phi_2199_;
                                            phi_2200_ = _e1526;
                                        } else {
                                            phi_2200_ = _e1006;
                                        }
                                        let _e1528 = phi_2200_;
                                        phi_2201_ = _e1528;
                                    } else {
                                        phi_2201_ = _e1006;
                                    }
                                    let _e1530 = phi_2201_;
                                    phi_2202_ = _e1530;
                                } else {
                                    phi_2202_ = _e1006;
                                }
                                let _e1532 = phi_2202_;
                                phi_1542_ = _e1532;
                                phi_1545_ = (_e1008 & (_e1008 - 1u));
                                phi_2203_ = true;
                            }
                            let _e1534 = phi_1542_;
                            let _e1536 = phi_1545_;
                            let _e1538 = phi_2203_;
                            continue;
                            continuing {
                                phi_1541_ = _e1534;
                                phi_1544_ = _e1536;
                                break if !(_e1538);
                            }
                        }
                        let _e1541 = local_1.group_mask;
                        if ((_e1541 & 4278190080u) == 0u) {
                            let _e1545 = local_1.len;
                            if (_e1545 == 0u) {
                                phi_2242_ = false;
                            } else {
                                let _e1549 = local_1.len;
                                local_1.len = (_e1549 - 1u);
                                let _e1552 = local_1.len;
                                if (_e1552 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1557 = local_1.first[(0u + _e1552)];
                                local_1.group = _e1557;
                                let _e1560 = local_1.len;
                                if (_e1560 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1565 = local_1.mask[(0u + _e1560)];
                                local_1.group_mask = _e1565;
                                phi_2242_ = true;
                            }
                            let _e1568 = phi_2242_;
                            phi_2243_ = _e1568;
                        } else {
                            phi_2243_ = true;
                        }
                        let _e1570 = phi_2243_;
                        if _e1570 {
                            let _e1572 = local_1.group_mask;
                            let _e1578 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1572)), 32u, (_e1572 == 0u)));
                            let _e1582 = local_1.group_mask;
                            let _e1596 = local_1.group_mask;
                            local_1.group_mask = (_e1596 & ~((1u << bitcast<u32>((_e1578 & 31u)))));
                            let _e1599 = local_1.group;
                            phi_2274_ = (_e1599 + countOneBits(((_e1582 & ~((4294967295u << bitcast<u32>((((_e1578 - 24u) ^ _e425) & 31u))))) & 255u)));
                        } else {
                            phi_2274_ = 4294967295u;
                        }
                        let _e1602 = phi_2274_;
                        let _e2520 = local_5;
                        phi_1205_ = _e2520;
                        phi_1208_ = _e1602;
                    } else {
                        phi_1205_ = lt_bvh_Hit();
                        phi_1208_ = u32();
                    }
                    let _e1604 = phi_1205_;
                    let _e1606 = phi_1208_;
                    continue;
                    continuing {
                        phi_1204_ = _e1604;
                        phi_1207_ = _e1606;
                        break if !(_e566);
                    }
                }
                let _e2524 = local_6;
                phi_2275_ = _e2524;
            }
            let _e1609 = phi_2275_;
            phi_2276_ = _e1609;
            phi_2277_ = _e222;
        } else {
            phi_2276_ = lt_bvh_Hit();
            phi_2277_ = true;
        }
        let _e1611 = phi_2276_;
        let _e1613 = phi_2277_;
        if _e1613 {
            phi_2281_ = _e160;
        } else {
            phi_2281_ = _e1611;
        }
        let _e1615 = phi_2281_;
        if (_e1615.triangle != 4294967295u) {
            let _e1621 = ((1f - _e1615.u) - _e1615.v);
            if (_e1615.triangle < _e79) {
            } else {
                return;
            }
            let _e1626 = triangles.member[(0u + _e1615.triangle)];
            let _e1651 = (((_e1626.v0_.x * _e1621) + (_e1626.v1_.x * _e1615.u)) + (_e1626.v2_.x * _e1615.v));
            let _e1652 = (((_e1626.v0_.y * _e1621) + (_e1626.v1_.y * _e1615.u)) + (_e1626.v2_.y * _e1615.v));
            let _e1653 = (((_e1626.v0_.z * _e1621) + (_e1626.v1_.z * _e1615.u)) + (_e1626.v2_.z * _e1615.v));
            let _e1656 = abs(_e1626.v0_.x);
            let _e1658 = abs(_e1626.v0_.y);
            let _e1660 = abs(_e1626.v0_.z);
            let _e1662 = abs(_e1626.v1_.x);
            let _e1664 = abs(_e1626.v1_.y);
            let _e1666 = abs(_e1626.v1_.z);
            if (_e1656 > _e1662) {
                phi_2345_ = _e1656;
            } else {
                phi_2345_ = _e1662;
            }
            let _e1669 = phi_2345_;
            if (_e1658 > _e1664) {
                phi_2350_ = _e1658;
            } else {
                phi_2350_ = _e1664;
            }
            let _e1672 = phi_2350_;
            if (_e1660 > _e1666) {
                phi_2355_ = _e1660;
            } else {
                phi_2355_ = _e1666;
            }
            let _e1675 = phi_2355_;
            let _e1677 = abs(_e1626.v2_.x);
            let _e1679 = abs(_e1626.v2_.y);
            let _e1681 = abs(_e1626.v2_.z);
            if (_e1669 > _e1677) {
                phi_2366_ = _e1669;
            } else {
                phi_2366_ = _e1677;
            }
            let _e1684 = phi_2366_;
            if (_e1672 > _e1679) {
                phi_2371_ = _e1672;
            } else {
                phi_2371_ = _e1679;
            }
            let _e1687 = phi_2371_;
            if (_e1675 > _e1681) {
                phi_2376_ = _e1675;
            } else {
                phi_2376_ = _e1681;
            }
            let _e1690 = phi_2376_;
            let _e1693 = (_e1626.v1_.x - _e1626.v0_.x);
            let _e1696 = (_e1626.v1_.y - _e1626.v0_.y);
            let _e1699 = (_e1626.v1_.z - _e1626.v0_.z);
            let _e1702 = (_e1626.v2_.x - _e1626.v0_.x);
            let _e1705 = (_e1626.v2_.y - _e1626.v0_.y);
            let _e1708 = (_e1626.v2_.z - _e1626.v0_.z);
            let _e1712 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1696), abs(_e1699));
            let _e1713 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1693), _e1712);
            let _e1714 = (_e1693 / _e1713);
            let _e1715 = (_e1696 / _e1713);
            let _e1716 = (_e1699 / _e1713);
            let _e1720 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1705), abs(_e1708));
            let _e1721 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1702), _e1720);
            let _e1722 = (_e1702 / _e1721);
            let _e1723 = (_e1705 / _e1721);
            let _e1724 = (_e1708 / _e1721);
            let _e1727 = ((_e1715 * _e1724) - (_e1723 * _e1716));
            let _e1730 = ((_e1716 * _e1722) - (_e1724 * _e1714));
            let _e1733 = ((_e1714 * _e1723) - (_e1722 * _e1715));
            let _e1735 = p.member.eye;
            let _e1748 = (1f / sqrt((((_e1727 * _e1727) + (_e1730 * _e1730)) + (_e1733 * _e1733))));
            let _e1749 = (_e1727 * _e1748);
            let _e1750 = (_e1730 * _e1748);
            let _e1751 = (_e1733 * _e1748);
            if ((((_e1749 * (_e1735.x - _e1651)) + (_e1750 * (_e1735.y - _e1652))) + (_e1751 * (_e1735.z - _e1653))) < 0f) {
                phi_2452_ = vec3<f32>(-(_e1749), -(_e1750), -(_e1751));
            } else {
                phi_2452_ = vec3<f32>(_e1749, _e1750, _e1751);
            }
            let _e1764 = phi_2452_;
            if (_e1615.triangle < _e79) {
            } else {
                return;
            }
            let _e1769 = triangles.member[(0u + _e1615.triangle)];
            let _e1771 = (_e1769.i0_ & 2147483647u);
            if (_e1771 < _e82) {
            } else {
                return;
            }
            let _e1777 = vertices.member[(0u + _e1771)];
            if (_e1769.i1_ < _e82) {
            } else {
                return;
            }
            let _e1781 = vertices.member[(0u + _e1769.i1_)];
            if (_e1769.i2_ < _e82) {
            } else {
                return;
            }
            let _e1785 = vertices.member[(0u + _e1769.i2_)];
            let _e1786 = array<abi_Vertex, 3>(_e1777, _e1781, _e1785);
            if (_e1786[0].material < arrayLength((&materials.member))) {
            } else {
                return;
            }
            let _e1792 = materials.member[(0u + _e1786[0].material)];
            let _e1809 = (1f / 255f);
            let _e1828 = (1f / 255f);
            let _e1850 = (1f / 255f);
            if (_e1792.color_size == 0u) {
                phi_2695_ = vec3<f32>(1f, 1f, 1f);
            } else {
                local.offset = _e1792.color_offset;
                local.size = _e1792.color_size;
                local.flags = _e1792.flags;
                let _e1893 = _lt_shaders_texture_TextureView_quad((&local), (((_e1786[0].u * _e1621) + (_e1786[1].u * _e1615.u)) + (_e1786[2].u * _e1615.v)), (((_e1786[0].v * _e1621) + (_e1786[1].v * _e1615.u)) + (_e1786[2].v * _e1615.v)));
                if (_e1893.indices[0] < _e91) {
                } else {
                    return;
                }
                let _e1899 = color_texels.member[(0u + _e1893.indices[0])];
                let _e1910 = (1f / 255f);
                if (_e1893.indices[1] < _e91) {
                } else {
                    return;
                }
                let _e1924 = color_texels.member[(0u + _e1893.indices[1])];
                let _e1935 = (1f / 255f);
                if (_e1893.indices[2] < _e91) {
                } else {
                    return;
                }
                let _e1952 = color_texels.member[(0u + _e1893.indices[2])];
                let _e1963 = (1f / 255f);
                if (_e1893.indices[3] < _e91) {
                } else {
                    return;
                }
                let _e1980 = color_texels.member[(0u + _e1893.indices[3])];
                let _e1991 = (1f / 255f);
                let _e2000 = (((((f32((_e1899 & 255u)) * _e1910) * _e1893.weights.x) + ((f32((_e1924 & 255u)) * _e1935) * _e1893.weights.y)) + ((f32((_e1952 & 255u)) * _e1963) * _e1893.weights.z)) + ((f32((_e1980 & 255u)) * _e1991) * _e1893.weights.w));
                let _e2001 = (((((f32(((_e1899 >> bitcast<u32>(8i)) & 255u)) * _e1910) * _e1893.weights.x) + ((f32(((_e1924 >> bitcast<u32>(8i)) & 255u)) * _e1935) * _e1893.weights.y)) + ((f32(((_e1952 >> bitcast<u32>(8i)) & 255u)) * _e1963) * _e1893.weights.z)) + ((f32(((_e1980 >> bitcast<u32>(8i)) & 255u)) * _e1991) * _e1893.weights.w));
                let _e2002 = (((((f32(((_e1899 >> bitcast<u32>(16i)) & 255u)) * _e1910) * _e1893.weights.x) + ((f32(((_e1924 >> bitcast<u32>(16i)) & 255u)) * _e1935) * _e1893.weights.y)) + ((f32(((_e1952 >> bitcast<u32>(16i)) & 255u)) * _e1963) * _e1893.weights.z)) + ((f32(((_e1980 >> bitcast<u32>(16i)) & 255u)) * _e1991) * _e1893.weights.w));
                phi_2695_ = vec3<f32>((_e2000 * _e2000), (_e2001 * _e2001), (_e2002 * _e2002));
            }
            let _e2008 = phi_2695_;
            let _e2010 = ((_e1792.base_color.x * ((((f32((_e1786[0].color & 255u)) * _e1809) * _e1621) + ((f32((_e1786[1].color & 255u)) * _e1828) * _e1615.u)) + ((f32((_e1786[2].color & 255u)) * _e1850) * _e1615.v))) * _e2008.x);
            let _e2012 = ((_e1792.base_color.y * ((((f32(((_e1786[0].color >> bitcast<u32>(8i)) & 255u)) * _e1809) * _e1621) + ((f32(((_e1786[1].color >> bitcast<u32>(8i)) & 255u)) * _e1828) * _e1615.u)) + ((f32(((_e1786[2].color >> bitcast<u32>(8i)) & 255u)) * _e1850) * _e1615.v))) * _e2008.y);
            let _e2014 = ((_e1792.base_color.z * ((((f32(((_e1786[0].color >> bitcast<u32>(16i)) & 255u)) * _e1809) * _e1621) + ((f32(((_e1786[1].color >> bitcast<u32>(16i)) & 255u)) * _e1828) * _e1615.u)) + ((f32(((_e1786[2].color >> bitcast<u32>(16i)) & 255u)) * _e1850) * _e1615.v))) * _e2008.z);
            let _e2015 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1687, _e1690);
            let _e2016 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1684, _e2015);
            if ((_e1792.flags & 2u) == 0u) {
                phi_2710_ = 0u;
            } else {
                phi_2710_ = 1u;
            }
            let _e2021 = phi_2710_;
            if (_e1786[0].normal == 2147516416u) {
                phi_2913_ = _e1764;
            } else {
                let _e2034 = (f32((bitcast<i32>((_e1786[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2040 = (f32((bitcast<i32>(_e1786[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2044 = ((1f - abs(_e2034)) - abs(_e2040));
                if (_e2044 < 0f) {
                    phi_2737_ = -(_e2044);
                } else {
                    phi_2737_ = 0f;
                }
                let _e2048 = phi_2737_;
                if (_e2034 < 0f) {
                    phi_2744_ = (_e2034 + _e2048);
                } else {
                    phi_2744_ = (_e2034 - _e2048);
                }
                let _e2053 = phi_2744_;
                if (_e2040 < 0f) {
                    phi_2751_ = (_e2040 + _e2048);
                } else {
                    phi_2751_ = (_e2040 - _e2048);
                }
                let _e2058 = phi_2751_;
                let _e2065 = (1f / sqrt((((_e2053 * _e2053) + (_e2058 * _e2058)) + (_e2044 * _e2044))));
                let _e2081 = (f32((bitcast<i32>((_e1786[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2087 = (f32((bitcast<i32>(_e1786[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2091 = ((1f - abs(_e2081)) - abs(_e2087));
                if (_e2091 < 0f) {
                    phi_2786_ = -(_e2091);
                } else {
                    phi_2786_ = 0f;
                }
                let _e2095 = phi_2786_;
                if (_e2081 < 0f) {
                    phi_2793_ = (_e2081 + _e2095);
                } else {
                    phi_2793_ = (_e2081 - _e2095);
                }
                let _e2100 = phi_2793_;
                if (_e2087 < 0f) {
                    phi_2800_ = (_e2087 + _e2095);
                } else {
                    phi_2800_ = (_e2087 - _e2095);
                }
                let _e2105 = phi_2800_;
                let _e2112 = (1f / sqrt((((_e2100 * _e2100) + (_e2105 * _e2105)) + (_e2091 * _e2091))));
                let _e2131 = (f32((bitcast<i32>((_e1786[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2137 = (f32((bitcast<i32>(_e1786[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2141 = ((1f - abs(_e2131)) - abs(_e2137));
                if (_e2141 < 0f) {
                    phi_2838_ = -(_e2141);
                } else {
                    phi_2838_ = 0f;
                }
                let _e2145 = phi_2838_;
                if (_e2131 < 0f) {
                    phi_2845_ = (_e2131 + _e2145);
                } else {
                    phi_2845_ = (_e2131 - _e2145);
                }
                let _e2150 = phi_2845_;
                if (_e2137 < 0f) {
                    phi_2852_ = (_e2137 + _e2145);
                } else {
                    phi_2852_ = (_e2137 - _e2145);
                }
                let _e2155 = phi_2852_;
                let _e2162 = (1f / sqrt((((_e2150 * _e2150) + (_e2155 * _e2155)) + (_e2141 * _e2141))));
                let _e2173 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(vec3<f32>(((((_e2053 * _e2065) * _e1621) + ((_e2100 * _e2112) * _e1615.u)) + ((_e2150 * _e2162) * _e1615.v)), ((((_e2058 * _e2065) * _e1621) + ((_e2105 * _e2112) * _e1615.u)) + ((_e2155 * _e2162) * _e1615.v)), ((((_e2044 * _e2065) * _e1621) + ((_e2091 * _e2112) * _e1615.u)) + ((_e2141 * _e2162) * _e1615.v))));
                let _e2185 = sqrt((((_e2173.x * _e2173.x) + (_e2173.y * _e2173.y)) + (_e2173.z * _e2173.z)));
                if (_e2185 > 0f) {
                    let _e2188 = (_e2173.x / _e2185);
                    let _e2190 = (_e2173.y / _e2185);
                    let _e2192 = (_e2173.z / _e2185);
                    if ((((_e2188 * _e1764.x) + (_e2190 * _e1764.y)) + (_e2192 * _e1764.z)) < 0f) {
                        phi_2911_ = vec3<f32>(-(_e2188), -(_e2190), -(_e2192));
                    } else {
                        phi_2911_ = (_e2173 / vec3(_e2185));
                    }
                    let _e2209 = phi_2911_;
                    phi_2912_ = _e2209;
                } else {
                    phi_2912_ = _e1764;
                }
                let _e2211 = phi_2912_;
                phi_2913_ = _e2211;
            }
            let _e2213 = phi_2913_;
            if (_e2010 > 0f) {
                if (_e2010 < 1f) {
                    phi_2922_ = _e2010;
                } else {
                    phi_2922_ = 1f;
                }
                let _e2217 = phi_2922_;
                phi_2923_ = _e2217;
            } else {
                phi_2923_ = 0f;
            }
            let _e2219 = phi_2923_;
            if (_e2012 > 0f) {
                if (_e2012 < 1f) {
                    phi_2933_ = _e2012;
                } else {
                    phi_2933_ = 1f;
                }
                let _e2224 = phi_2933_;
                phi_2934_ = _e2224;
            } else {
                phi_2934_ = 0f;
            }
            let _e2226 = phi_2934_;
            if (_e2014 > 0f) {
                if (_e2014 < 1f) {
                    phi_2944_ = _e2014;
                } else {
                    phi_2944_ = 1f;
                }
                let _e2231 = phi_2944_;
                phi_2945_ = _e2231;
            } else {
                phi_2945_ = 0f;
            }
            let _e2233 = phi_2945_;
            let _e2236 = ((sqrt(_e2219) * 255f) + 0.5f);
            let _e2245 = ((sqrt(_e2226) * 255f) + 0.5f);
            let _e2257 = ((sqrt(_e2233) * 255f) + 0.5f);
            phi_2980_ = abi_Sample(vec3<f32>(_e1651, _e1652, _e1653), _e2016, _e1764, _e2021, _e2213, ((select(select(u32(_e2236), 0u, (_e2236 < bitcast<f32>(0u))), 4294967295u, (_e2236 > bitcast<f32>(1333788671u))) | (select(select(u32(_e2245), 0u, (_e2245 < bitcast<f32>(0u))), 4294967295u, (_e2245 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e2257), 0u, (_e2257 < bitcast<f32>(0u))), 4294967295u, (_e2257 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_2980_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e2271 = phi_2980_;
        if (_e103.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e103.shift)] = _e2271;
        if (_e1615.triangle != 4294967295u) {
            let _e2280 = ((1f - _e1615.u) - _e1615.v);
            if (_e1615.triangle < _e79) {
            } else {
                return;
            }
            let _e2285 = triangles.member[(0u + _e1615.triangle)];
            let _e2287 = (_e2285.i0_ & 2147483647u);
            if (_e2287 < _e94) {
            } else {
                return;
            }
            let _e2293 = before.member[(0u + _e2287)];
            if (_e2285.i1_ < _e94) {
            } else {
                return;
            }
            let _e2297 = before.member[(0u + _e2285.i1_)];
            if (_e2285.i2_ < _e94) {
            } else {
                return;
            }
            let _e2301 = before.member[(0u + _e2285.i2_)];
            let _e2306 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2293.x, _e2293.y, _e2293.z));
            let _e2317 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2297.x, _e2297.y, _e2297.z));
            let _e2331 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2301.x, _e2301.y, _e2301.z));
            phi_3071_ = vec3<f32>((((_e2306.x * _e2280) + (_e2317.x * _e1615.u)) + (_e2331.x * _e1615.v)), (((_e2306.y * _e2280) + (_e2317.y * _e1615.u)) + (_e2331.y * _e1615.v)), (((_e2306.z * _e2280) + (_e2317.z * _e1615.u)) + (_e2331.z * _e1615.v)));
        } else {
            phi_3071_ = vec3<f32>(0f, 0f, 0f);
        }
        let _e2343 = phi_3071_;
        if (_e103.shift < arrayLength((&past.member))) {
        } else {
            return;
        }
        past.member[(0u + _e103.shift)] = vec4<f32>(_e2343.x, _e2343.y, _e2343.z, 1f);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_color_motion_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
