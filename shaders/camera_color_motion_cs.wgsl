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
    var phi_213_: lt_mask_LightPlace;
    var phi_214_: bool;
    var phi_215_: lt_mask_LightPlace;
    var phi_216_: bool;
    var phi_221_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_213_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_214_ = false;
        } else {
            phi_213_ = lt_mask_LightPlace();
            phi_214_ = true;
        }
        let _e83 = phi_213_;
        let _e85 = phi_214_;
        phi_215_ = _e83;
        phi_216_ = _e85;
    } else {
        phi_215_ = lt_mask_LightPlace();
        phi_216_ = true;
    }
    let _e87 = phi_215_;
    let _e89 = phi_216_;
    if _e89 {
        phi_221_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_221_ = _e87;
    }
    let _e94 = phi_221_;
    return lt_mask_LightPlace(_e94.word, _e94.shift);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_236_: bool;
    var phi_240_: f32;

    if (param_3 != param_3) {
        phi_236_ = true;
    } else {
        let _e73 = (param_4 >= param_3);
        if _e73 {
        }
        phi_236_ = _e73;
    }
    let _e75 = phi_236_;
    if _e75 {
        phi_240_ = param_4;
    } else {
        phi_240_ = param_3;
    }
    let _e77 = phi_240_;
    return _e77;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_252_: bool;
    var phi_256_: f32;

    if (param_5 != param_5) {
        phi_252_ = true;
    } else {
        let _e73 = (param_6 <= param_5);
        if _e73 {
        }
        phi_252_ = _e73;
    }
    let _e75 = phi_252_;
    if _e75 {
        phi_256_ = param_6;
    } else {
        phi_256_ = param_5;
    }
    let _e77 = phi_256_;
    return _e77;
}

fn _lt_shaders_texture_TextureView_quad(param_7: ptr<function, texture_TextureView>, param_8: f32, param_9: f32) -> texture_TexelQuad {
    var phi_298_: f32;
    var phi_303_: f32;
    var phi_304_: bool;
    var phi_305_: f32;
    var phi_306_: bool;
    var phi_310_: f32;
    var phi_336_: f32;
    var phi_341_: f32;
    var phi_342_: bool;
    var phi_343_: f32;
    var phi_344_: bool;
    var phi_348_: f32;
    var phi_356_: f32;
    var phi_357_: f32;
    var phi_358_: f32;
    var phi_367_: f32;
    var phi_368_: f32;
    var phi_386_: u32;
    var phi_400_: u32;
    var phi_407_: u32;
    var phi_412_: u32;
    var phi_418_: u32;
    var phi_423_: u32;
    var phi_425_: texture_Axis;
    var phi_453_: f32;
    var phi_458_: f32;
    var phi_459_: bool;
    var phi_460_: f32;
    var phi_461_: bool;
    var phi_465_: f32;
    var phi_491_: f32;
    var phi_496_: f32;
    var phi_497_: bool;
    var phi_498_: f32;
    var phi_499_: bool;
    var phi_503_: f32;
    var phi_511_: f32;
    var phi_512_: f32;
    var phi_513_: f32;
    var phi_522_: f32;
    var phi_523_: f32;
    var phi_541_: u32;
    var phi_555_: u32;
    var phi_562_: u32;
    var phi_567_: u32;
    var phi_573_: u32;
    var phi_578_: u32;
    var phi_580_: texture_Axis;

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
                phi_298_ = 1f;
            } else {
                phi_298_ = 0f;
            }
            let _e104 = phi_298_;
            if (param_8 < 8388608f) {
                phi_303_ = (_e101 - _e104);
                phi_304_ = false;
            } else {
                phi_303_ = f32();
                phi_304_ = true;
            }
            let _e107 = phi_303_;
            let _e109 = phi_304_;
            phi_305_ = _e107;
            phi_306_ = _e109;
        } else {
            phi_305_ = f32();
            phi_306_ = true;
        }
        let _e111 = phi_305_;
        let _e113 = phi_306_;
        if _e113 {
            phi_310_ = param_8;
        } else {
            phi_310_ = _e111;
        }
        let _e115 = phi_310_;
        phi_358_ = (param_8 - _e115);
    } else {
        if (_e88 == 1u) {
            let _e118 = (param_8 * 0.5f);
            if (_e118 > -8388608f) {
                let _e130 = f32(select(0i, select(select(i32(_e118), i32(-2147483648), (_e118 < bitcast<f32>(3472883712u))), 2147483647i, (_e118 > bitcast<f32>(1325400063u))), (_e118 == _e118)));
                if (_e130 > _e118) {
                    phi_336_ = 1f;
                } else {
                    phi_336_ = 0f;
                }
                let _e133 = phi_336_;
                if (_e118 < 8388608f) {
                    phi_341_ = (_e130 - _e133);
                    phi_342_ = false;
                } else {
                    phi_341_ = f32();
                    phi_342_ = true;
                }
                let _e136 = phi_341_;
                let _e138 = phi_342_;
                phi_343_ = _e136;
                phi_344_ = _e138;
            } else {
                phi_343_ = f32();
                phi_344_ = true;
            }
            let _e140 = phi_343_;
            let _e142 = phi_344_;
            if _e142 {
                phi_348_ = _e118;
            } else {
                phi_348_ = _e140;
            }
            let _e144 = phi_348_;
            let _e146 = (param_8 - (2f * _e144));
            if (_e146 > 1f) {
                phi_356_ = (2f - _e146);
            } else {
                phi_356_ = _e146;
            }
            let _e150 = phi_356_;
            phi_357_ = _e150;
        } else {
            phi_357_ = param_8;
        }
        let _e152 = phi_357_;
        phi_358_ = _e152;
    }
    let _e154 = phi_358_;
    if (_e154 > 0f) {
        if (_e154 < 1f) {
            phi_367_ = _e154;
        } else {
            phi_367_ = 1f;
        }
        let _e158 = phi_367_;
        phi_368_ = _e158;
    } else {
        phi_368_ = 0f;
    }
    let _e160 = phi_368_;
    let _e161 = (_e75 - 1u);
    let _e163 = (_e160 * f32(_e75));
    if _e83 {
        let _e170 = select(select(u32(_e163), 0u, (_e163 < bitcast<f32>(0u))), 4294967295u, (_e163 > bitcast<f32>(1333788671u)));
        if (_e161 < _e170) {
            phi_386_ = _e161;
        } else {
            phi_386_ = _e170;
        }
        let _e173 = phi_386_;
        phi_425_ = texture_Axis(_e173, _e173, 0f);
    } else {
        let _e175 = (_e163 + 0.5f);
        let _e182 = select(select(u32(_e175), 0u, (_e175 < bitcast<f32>(0u))), 4294967295u, (_e175 > bitcast<f32>(1333788671u)));
        if (_e75 < _e182) {
            phi_400_ = _e75;
        } else {
            phi_400_ = _e182;
        }
        let _e185 = phi_400_;
        if (_e88 == 0u) {
            phi_407_ = _e161;
        } else {
            phi_407_ = 0u;
        }
        let _e190 = phi_407_;
        if (_e88 == 0u) {
            phi_412_ = 0u;
        } else {
            phi_412_ = _e161;
        }
        let _e193 = phi_412_;
        if (_e185 == 0u) {
            phi_418_ = _e190;
        } else {
            phi_418_ = (_e185 - 1u);
        }
        let _e197 = phi_418_;
        if (_e185 > _e161) {
            phi_423_ = _e193;
        } else {
            phi_423_ = _e185;
        }
        let _e200 = phi_423_;
        phi_425_ = texture_Axis(_e197, _e200, (_e175 - f32(_e185)));
    }
    let _e203 = phi_425_;
    let _e205 = (*param_7).flags;
    let _e208 = ((_e205 >> bitcast<u32>(6u)) & 3u);
    if (_e208 == 0u) {
        if (param_9 > -8388608f) {
            let _e221 = f32(select(0i, select(select(i32(param_9), i32(-2147483648), (param_9 < bitcast<f32>(3472883712u))), 2147483647i, (param_9 > bitcast<f32>(1325400063u))), (param_9 == param_9)));
            if (_e221 > param_9) {
                phi_453_ = 1f;
            } else {
                phi_453_ = 0f;
            }
            let _e224 = phi_453_;
            if (param_9 < 8388608f) {
                phi_458_ = (_e221 - _e224);
                phi_459_ = false;
            } else {
                phi_458_ = f32();
                phi_459_ = true;
            }
            let _e227 = phi_458_;
            let _e229 = phi_459_;
            phi_460_ = _e227;
            phi_461_ = _e229;
        } else {
            phi_460_ = f32();
            phi_461_ = true;
        }
        let _e231 = phi_460_;
        let _e233 = phi_461_;
        if _e233 {
            phi_465_ = param_9;
        } else {
            phi_465_ = _e231;
        }
        let _e235 = phi_465_;
        phi_513_ = (param_9 - _e235);
    } else {
        if (_e208 == 1u) {
            let _e238 = (param_9 * 0.5f);
            if (_e238 > -8388608f) {
                let _e250 = f32(select(0i, select(select(i32(_e238), i32(-2147483648), (_e238 < bitcast<f32>(3472883712u))), 2147483647i, (_e238 > bitcast<f32>(1325400063u))), (_e238 == _e238)));
                if (_e250 > _e238) {
                    phi_491_ = 1f;
                } else {
                    phi_491_ = 0f;
                }
                let _e253 = phi_491_;
                if (_e238 < 8388608f) {
                    phi_496_ = (_e250 - _e253);
                    phi_497_ = false;
                } else {
                    phi_496_ = f32();
                    phi_497_ = true;
                }
                let _e256 = phi_496_;
                let _e258 = phi_497_;
                phi_498_ = _e256;
                phi_499_ = _e258;
            } else {
                phi_498_ = f32();
                phi_499_ = true;
            }
            let _e260 = phi_498_;
            let _e262 = phi_499_;
            if _e262 {
                phi_503_ = _e238;
            } else {
                phi_503_ = _e260;
            }
            let _e264 = phi_503_;
            let _e266 = (param_9 - (2f * _e264));
            if (_e266 > 1f) {
                phi_511_ = (2f - _e266);
            } else {
                phi_511_ = _e266;
            }
            let _e270 = phi_511_;
            phi_512_ = _e270;
        } else {
            phi_512_ = param_9;
        }
        let _e272 = phi_512_;
        phi_513_ = _e272;
    }
    let _e274 = phi_513_;
    if (_e274 > 0f) {
        if (_e274 < 1f) {
            phi_522_ = _e274;
        } else {
            phi_522_ = 1f;
        }
        let _e278 = phi_522_;
        phi_523_ = _e278;
    } else {
        phi_523_ = 0f;
    }
    let _e280 = phi_523_;
    let _e281 = (_e79 - 1u);
    let _e283 = (_e280 * f32(_e79));
    if _e83 {
        let _e290 = select(select(u32(_e283), 0u, (_e283 < bitcast<f32>(0u))), 4294967295u, (_e283 > bitcast<f32>(1333788671u)));
        if (_e281 < _e290) {
            phi_541_ = _e281;
        } else {
            phi_541_ = _e290;
        }
        let _e293 = phi_541_;
        phi_580_ = texture_Axis(_e293, _e293, 0f);
    } else {
        let _e295 = (_e283 + 0.5f);
        let _e302 = select(select(u32(_e295), 0u, (_e295 < bitcast<f32>(0u))), 4294967295u, (_e295 > bitcast<f32>(1333788671u)));
        if (_e79 < _e302) {
            phi_555_ = _e79;
        } else {
            phi_555_ = _e302;
        }
        let _e305 = phi_555_;
        if (_e208 == 0u) {
            phi_562_ = _e281;
        } else {
            phi_562_ = 0u;
        }
        let _e310 = phi_562_;
        if (_e208 == 0u) {
            phi_567_ = 0u;
        } else {
            phi_567_ = _e281;
        }
        let _e313 = phi_567_;
        if (_e305 == 0u) {
            phi_573_ = _e310;
        } else {
            phi_573_ = (_e305 - 1u);
        }
        let _e317 = phi_573_;
        if (_e305 > _e281) {
            phi_578_ = _e313;
        } else {
            phi_578_ = _e305;
        }
        let _e320 = phi_578_;
        phi_580_ = texture_Axis(_e317, _e320, (_e295 - f32(_e305)));
    }
    let _e323 = phi_580_;
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
    var phi_639_: f32;

    if (param_12 > param_13) {
        phi_639_ = param_12;
    } else {
        phi_639_ = param_13;
    }
    let _e74 = phi_639_;
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
    var phi_762_: bool;
    var phi_763_: bool;
    var phi_764_: bool;
    var phi_765_: bool;
    var phi_769_: bool;
    var phi_782_: bool;
    var phi_783_: bool;
    var phi_784_: bool;
    var phi_785_: bool;
    var phi_789_: bool;
    var phi_802_: bool;
    var phi_803_: bool;
    var phi_804_: bool;
    var phi_808_: bool;
    var phi_809_: bool;
    var phi_810_: bool;
    var phi_811_: bool;
    var phi_812_: bool;
    var phi_816_: bool;
    var phi_892_: f32;
    var phi_899_: f32;
    var phi_907_: f32;
    var phi_914_: f32;
    var phi_922_: f32;
    var phi_929_: f32;
    var phi_952_: f32;
    var phi_957_: f32;
    var phi_962_: f32;
    var phi_967_: f32;
    var phi_972_: f32;
    var phi_1003_: bool;
    var phi_1004_: bool;
    var phi_1012_: u32;
    var phi_1013_: u32;
    var phi_1030_: vec3<f32>;
    var phi_1031_: vec3<f32>;
    var phi_1044_: u32;
    var phi_1049_: u32;
    var phi_1054_: u32;
    var phi_1168_: bool;
    var phi_1169_: bool;
    var phi_1200_: u32;
    var phi_1202_: lt_bvh_Hit;
    var phi_1205_: u32;
    var phi_1290_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1317_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1344_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1350_: u32;
    var phi_1353_: u32;
    var phi_1367_: u32;
    var phi_1377_: u32;
    var phi_1387_: u32;
    var phi_1405_: u32;
    var phi_1415_: u32;
    var phi_1425_: u32;
    var phi_1461_: u32;
    var phi_1474_: u32;
    var phi_1479_: u32;
    var phi_1480_: u32;
    var phi_1481_: u32;
    var phi_1351_: u32;
    var phi_1354_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_1539_: lt_bvh_Hit;
    var phi_1542_: u32;
    var phi_1588_: vec3<f32>;
    var phi_1589_: vec3<f32>;
    var phi_1620_: vec3<f32>;
    var phi_1621_: vec3<f32>;
    var phi_1652_: vec3<f32>;
    var phi_1653_: vec3<f32>;
    var phi_1671_: bool;
    var phi_1672_: bool;
    var phi_1676_: f32;
    var phi_1677_: f32;
    var phi_1678_: f32;
    var phi_1679_: f32;
    var phi_1687_: f32;
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
    var phi_1754_: f32;
    var phi_1755_: bool;
    var phi_1756_: f32;
    var phi_1757_: bool;
    var phi_1758_: f32;
    var phi_1759_: bool;
    var phi_1777_: f32;
    var phi_1778_: bool;
    var phi_1779_: bool;
    var phi_1780_: f32;
    var phi_1781_: bool;
    var phi_1782_: bool;
    var phi_1786_: bool;
    var phi_1787_: f32;
    var phi_1788_: bool;
    var phi_1818_: vec3<f32>;
    var phi_1819_: vec3<f32>;
    var phi_1844_: vec3<f32>;
    var phi_1845_: vec3<f32>;
    var phi_1870_: vec3<f32>;
    var phi_1871_: vec3<f32>;
    var phi_1929_: f32;
    var phi_1938_: f32;
    var phi_1947_: f32;
    var phi_1956_: f32;
    var phi_1963_: f32;
    var phi_1970_: f32;
    var phi_1983_: f32;
    var phi_1992_: f32;
    var phi_2001_: f32;
    var phi_2010_: f32;
    var phi_2017_: f32;
    var phi_2024_: f32;
    var phi_2047_: f32;
    var phi_2052_: f32;
    var phi_2057_: f32;
    var phi_2065_: f32;
    var phi_2070_: f32;
    var phi_2075_: f32;
    var phi_2087_: f32;
    var phi_2092_: f32;
    var phi_2097_: f32;
    var phi_2102_: f32;
    var phi_2107_: lt_bvh_triangle_Intersection;
    var phi_2108_: bool;
    var phi_2109_: lt_bvh_triangle_Intersection;
    var phi_2110_: bool;
    var phi_2114_: lt_bvh_triangle_Intersection;
    var phi_2115_: bool;
    var phi_2116_: lt_bvh_triangle_Intersection;
    var phi_2117_: bool;
    var phi_2118_: bool;
    var phi_2122_: bool;
    var phi_2126_: lt_bvh_triangle_Intersection;
    var phi_2165_: bool;
    var phi_2166_: bool;
    var phi_2167_: bool;
    var phi_2168_: bool;
    var phi_2169_: bool;
    var phi_2170_: bool;
    var phi_2174_: bool;
    var phi_2175_: bool;
    var phi_2189_: bool;
    var phi_2197_: lt_bvh_Hit;
    var phi_2198_: lt_bvh_Hit;
    var phi_2199_: lt_bvh_Hit;
    var phi_2200_: lt_bvh_Hit;
    var phi_1540_: lt_bvh_Hit;
    var phi_1543_: u32;
    var phi_2201_: bool;
    var phi_2240_: bool;
    var phi_2241_: bool;
    var phi_2272_: u32;
    var phi_1203_: lt_bvh_Hit;
    var phi_1206_: u32;
    var phi_2273_: lt_bvh_Hit;
    var phi_2274_: lt_bvh_Hit;
    var phi_2275_: bool;
    var phi_2279_: lt_bvh_Hit;
    var phi_2343_: f32;
    var phi_2348_: f32;
    var phi_2353_: f32;
    var phi_2364_: f32;
    var phi_2369_: f32;
    var phi_2374_: f32;
    var phi_2450_: vec3<f32>;
    var phi_2693_: vec3<f32>;
    var phi_2708_: u32;
    var phi_2735_: f32;
    var phi_2742_: f32;
    var phi_2749_: f32;
    var phi_2784_: f32;
    var phi_2791_: f32;
    var phi_2798_: f32;
    var phi_2836_: f32;
    var phi_2843_: f32;
    var phi_2850_: f32;
    var phi_2909_: vec3<f32>;
    var phi_2910_: vec3<f32>;
    var phi_2911_: vec3<f32>;
    var phi_2920_: f32;
    var phi_2921_: f32;
    var phi_2931_: f32;
    var phi_2932_: f32;
    var phi_2942_: f32;
    var phi_2943_: f32;
    var phi_2978_: abi_Sample;
    var phi_3069_: vec3<f32>;
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
                phi_762_ = (abs(_e158.origin.z) < 1000000000000000f);
                phi_763_ = false;
            } else {
                phi_762_ = bool();
                phi_763_ = true;
            }
            let _e179 = phi_762_;
            let _e181 = phi_763_;
            phi_764_ = _e179;
            phi_765_ = _e181;
        } else {
            phi_764_ = bool();
            phi_765_ = true;
        }
        let _e183 = phi_764_;
        let _e185 = phi_765_;
        if _e185 {
            phi_769_ = false;
        } else {
            phi_769_ = _e183;
        }
        let _e187 = phi_769_;
        if _e187 {
            if (_e163 < 1000000000000000f) {
                if (_e165 < 1000000000000000f) {
                    phi_782_ = (_e167 < 1000000000000000f);
                    phi_783_ = false;
                } else {
                    phi_782_ = bool();
                    phi_783_ = true;
                }
                let _e192 = phi_782_;
                let _e194 = phi_783_;
                phi_784_ = _e192;
                phi_785_ = _e194;
            } else {
                phi_784_ = bool();
                phi_785_ = true;
            }
            let _e196 = phi_784_;
            let _e198 = phi_785_;
            if _e198 {
                phi_789_ = false;
            } else {
                phi_789_ = _e196;
            }
            let _e200 = phi_789_;
            if _e200 {
                if (_e163 > 0f) {
                    phi_803_ = bool();
                    phi_804_ = true;
                } else {
                    let _e202 = (_e165 > 0f);
                    if _e202 {
                        phi_802_ = bool();
                    } else {
                        phi_802_ = (_e167 > 0f);
                    }
                    let _e205 = phi_802_;
                    phi_803_ = _e205;
                    phi_804_ = _e202;
                }
                let _e207 = phi_803_;
                let _e209 = phi_804_;
                if _e209 {
                    phi_808_ = true;
                } else {
                    phi_808_ = _e207;
                }
                let _e211 = phi_808_;
                phi_809_ = _e211;
                phi_810_ = false;
            } else {
                phi_809_ = bool();
                phi_810_ = true;
            }
            let _e213 = phi_809_;
            let _e215 = phi_810_;
            phi_811_ = _e213;
            phi_812_ = _e215;
        } else {
            phi_811_ = bool();
            phi_812_ = true;
        }
        let _e217 = phi_811_;
        let _e219 = phi_812_;
        if _e219 {
            phi_816_ = false;
        } else {
            phi_816_ = _e217;
        }
        let _e221 = phi_816_;
        if _e221 {
            let _e222 = (0u >= _e76);
            if _e222 {
                phi_2273_ = lt_bvh_Hit();
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
                    phi_892_ = _e293;
                } else {
                    phi_892_ = abs(_e158.direction.x);
                }
                let _e299 = phi_892_;
                if (_e158.direction.x < 0f) {
                    phi_899_ = (-1f / _e299);
                } else {
                    phi_899_ = (1f / _e299);
                }
                let _e304 = phi_899_;
                if (abs(_e158.direction.y) < _e293) {
                    phi_907_ = _e293;
                } else {
                    phi_907_ = abs(_e158.direction.y);
                }
                let _e310 = phi_907_;
                if (_e158.direction.y < 0f) {
                    phi_914_ = (-1f / _e310);
                } else {
                    phi_914_ = (1f / _e310);
                }
                let _e315 = phi_914_;
                if (abs(_e158.direction.z) < _e293) {
                    phi_922_ = _e293;
                } else {
                    phi_922_ = abs(_e158.direction.z);
                }
                let _e321 = phi_922_;
                if (_e158.direction.z < 0f) {
                    phi_929_ = (-1f / _e321);
                } else {
                    phi_929_ = (1f / _e321);
                }
                let _e326 = phi_929_;
                let _e333 = abs((bitcast<f32>(_e228) - _e158.origin.x));
                let _e334 = abs((bitcast<f32>(_e232) - _e158.origin.y));
                let _e335 = abs((bitcast<f32>(_e236) - _e158.origin.z));
                let _e342 = abs(((bitcast<f32>(_e240) + (bitcast<f32>((((_e252 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e158.origin.x));
                let _e343 = abs(((bitcast<f32>(_e244) + (bitcast<f32>((((_e252 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e158.origin.y));
                let _e344 = abs(((bitcast<f32>(_e248) + (bitcast<f32>((((_e252 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e158.origin.z));
                if (_e333 > _e342) {
                    phi_952_ = _e333;
                } else {
                    phi_952_ = _e342;
                }
                let _e347 = phi_952_;
                if (_e334 > _e343) {
                    phi_957_ = _e334;
                } else {
                    phi_957_ = _e343;
                }
                let _e350 = phi_957_;
                if (_e335 > _e344) {
                    phi_962_ = _e335;
                } else {
                    phi_962_ = _e344;
                }
                let _e353 = phi_962_;
                if (_e347 > _e350) {
                    phi_967_ = _e347;
                } else {
                    phi_967_ = _e350;
                }
                let _e356 = phi_967_;
                if (_e356 > _e353) {
                    phi_972_ = _e356;
                } else {
                    phi_972_ = _e353;
                }
                let _e359 = phi_972_;
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
                        phi_1003_ = false;
                    } else {
                        phi_1003_ = true;
                    }
                    let _e385 = phi_1003_;
                    phi_1004_ = _e385;
                } else {
                    phi_1004_ = true;
                }
                let _e387 = phi_1004_;
                if _e387 {
                    if (_e379 >= _e381) {
                        phi_1012_ = 1u;
                    } else {
                        phi_1012_ = 2u;
                    }
                    let _e390 = phi_1012_;
                    phi_1013_ = _e390;
                } else {
                    phi_1013_ = 0u;
                }
                let _e392 = phi_1013_;
                if (_e392 == 0u) {
                    phi_1031_ = vec3<f32>(_e158.direction.y, _e158.direction.z, _e158.direction.x);
                } else {
                    if (_e392 == 1u) {
                        phi_1030_ = vec3<f32>(_e158.direction.z, _e158.direction.x, _e158.direction.y);
                    } else {
                        phi_1030_ = _e158.direction;
                    }
                    let _e404 = phi_1030_;
                    phi_1031_ = _e404;
                }
                let _e406 = phi_1031_;
                let _e409 = (_e406.x / _e406.z);
                let _e412 = (_e406.y / _e406.z);
                if (_e304 < 0f) {
                    phi_1044_ = 0u;
                } else {
                    phi_1044_ = 1u;
                }
                let _e417 = phi_1044_;
                if (_e315 < 0f) {
                    phi_1049_ = 0u;
                } else {
                    phi_1049_ = 2u;
                }
                let _e420 = phi_1049_;
                if (_e326 < 0f) {
                    phi_1054_ = 0u;
                } else {
                    phi_1054_ = 4u;
                }
                let _e423 = phi_1054_;
                let _e425 = ((_e417 | _e420) | _e423);
                let _e426 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e426.first[0], _e426.first[1], _e426.first[2], _e426.first[3], _e426.first[4], _e426.first[5], _e426.first[6], _e426.first[7], _e426.first[8], _e426.first[9], _e426.first[10], _e426.first[11], _e426.first[12], _e426.first[13], _e426.first[14], _e426.first[15], _e426.first[16], _e426.first[17], _e426.first[18], _e426.first[19], _e426.first[20], _e426.first[21], _e426.first[22], _e426.first[23], _e426.first[24], _e426.first[25], _e426.first[26], _e426.first[27], _e426.first[28], _e426.first[29], _e426.first[30], _e426.first[31]), array<u32, 32>(_e426.mask[0], _e426.mask[1], _e426.mask[2], _e426.mask[3], _e426.mask[4], _e426.mask[5], _e426.mask[6], _e426.mask[7], _e426.mask[8], _e426.mask[9], _e426.mask[10], _e426.mask[11], _e426.mask[12], _e426.mask[13], _e426.mask[14], _e426.mask[15], _e426.mask[16], _e426.mask[17], _e426.mask[18], _e426.mask[19], _e426.mask[20], _e426.mask[21], _e426.mask[22], _e426.mask[23], _e426.mask[24], _e426.mask[25], _e426.mask[26], _e426.mask[27], _e426.mask[28], _e426.mask[29], _e426.mask[30], _e426.mask[31]), _e426.len, _e426.group, _e426.group_mask);
                let _e500 = local_1.group_mask;
                if ((_e500 & 4278190080u) == 0u) {
                    let _e504 = local_1.len;
                    if (_e504 == 0u) {
                        phi_1168_ = false;
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
                        phi_1168_ = true;
                    }
                    let _e527 = phi_1168_;
                    phi_1169_ = _e527;
                } else {
                    phi_1169_ = true;
                }
                let _e529 = phi_1169_;
                if _e529 {
                    let _e531 = local_1.group_mask;
                    let _e537 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e531)), 32u, (_e531 == 0u)));
                    let _e541 = local_1.group_mask;
                    let _e555 = local_1.group_mask;
                    local_1.group_mask = (_e555 & ~((1u << bitcast<u32>((_e537 & 31u)))));
                    let _e558 = local_1.group;
                    phi_1200_ = (_e558 + countOneBits(((_e541 & ~((4294967295u << bitcast<u32>((((_e537 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1200_ = 4294967295u;
                }
                let _e561 = phi_1200_;
                phi_1202_ = _e160;
                phi_1205_ = _e561;
                loop {
                    let _e563 = phi_1202_;
                    let _e565 = phi_1205_;
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
                            phi_1290_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e653.unnamed, lt_mask_LightPlace(_e653.unnamed_1.word, _e630.y));
                        } else {
                            let _e669 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e630.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e675 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e669.unnamed.word, _e630.y), _e669.unnamed_1);
                            let _e681 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e675.unnamed, lt_mask_LightPlace(_e630.z, _e675.unnamed_1.shift));
                            phi_1290_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e681.unnamed, lt_mask_LightPlace(_e681.unnamed_1.word, _e630.w));
                        }
                        let _e689 = phi_1290_;
                        let _e699 = nodes.member[(0u + _e565)].y;
                        if (_e315 < 0f) {
                            let _e710 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e699.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e716 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e710.unnamed.word, _e699.w), _e710.unnamed_1);
                            let _e722 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e716.unnamed, lt_mask_LightPlace(_e699.x, _e716.unnamed_1.shift));
                            phi_1317_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e722.unnamed, lt_mask_LightPlace(_e722.unnamed_1.word, _e699.y));
                        } else {
                            let _e738 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e699.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e744 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e738.unnamed.word, _e699.y), _e738.unnamed_1);
                            let _e750 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e744.unnamed, lt_mask_LightPlace(_e699.z, _e744.unnamed_1.shift));
                            phi_1317_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e750.unnamed, lt_mask_LightPlace(_e750.unnamed_1.word, _e699.w));
                        }
                        let _e758 = phi_1317_;
                        let _e768 = nodes.member[(0u + _e565)].z;
                        if (_e326 < 0f) {
                            let _e779 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e768.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e785 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e779.unnamed.word, _e768.w), _e779.unnamed_1);
                            let _e791 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e785.unnamed, lt_mask_LightPlace(_e768.x, _e785.unnamed_1.shift));
                            phi_1344_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e791.unnamed, lt_mask_LightPlace(_e791.unnamed_1.word, _e768.y));
                        } else {
                            let _e807 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e768.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e813 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e807.unnamed.word, _e768.y), _e807.unnamed_1);
                            let _e819 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e813.unnamed, lt_mask_LightPlace(_e768.z, _e813.unnamed_1.shift));
                            phi_1344_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e819.unnamed, lt_mask_LightPlace(_e819.unnamed_1.word, _e768.w));
                        }
                        let _e827 = phi_1344_;
                        phi_1350_ = 0u;
                        phi_1353_ = 0u;
                        loop {
                            let _e837 = phi_1350_;
                            let _e839 = phi_1353_;
                            local_2 = _e839;
                            local_3 = _e839;
                            local_4 = _e839;
                            let _e840 = (_e837 < 8u);
                            if _e840 {
                                let _e842 = (_e837 >> bitcast<u32>(2i));
                                let _e843 = (_e837 & 3u);
                                if (_e842 == 0u) {
                                    phi_1367_ = _e689.unnamed.word;
                                } else {
                                    phi_1367_ = _e689.unnamed.shift;
                                }
                                let _e846 = phi_1367_;
                                if (_e842 == 0u) {
                                    phi_1377_ = _e758.unnamed.word;
                                } else {
                                    phi_1377_ = _e758.unnamed.shift;
                                }
                                let _e855 = phi_1377_;
                                if (_e842 == 0u) {
                                    phi_1387_ = _e827.unnamed.word;
                                } else {
                                    phi_1387_ = _e827.unnamed.shift;
                                }
                                let _e864 = phi_1387_;
                                let _e877 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e846 >> bitcast<u32>(((_e843 * 8u) & 31u))) & 255u)) * _e599) + (_e620 - _e364)), ((f32(((_e855 >> bitcast<u32>(((_e843 * 8u) & 31u))) & 255u)) * _e600) + (_e621 - _e365)));
                                let _e878 = core_intrinsics_maximum_number_nsz_f32_(_e877, ((f32(((_e864 >> bitcast<u32>(((_e843 * 8u) & 31u))) & 255u)) * _e601) + (_e622 - _e366)));
                                if (_e842 == 0u) {
                                    phi_1405_ = _e689.unnamed_1.word;
                                } else {
                                    phi_1405_ = _e689.unnamed_1.shift;
                                }
                                let _e881 = phi_1405_;
                                if (_e842 == 0u) {
                                    phi_1415_ = _e758.unnamed_1.word;
                                } else {
                                    phi_1415_ = _e758.unnamed_1.shift;
                                }
                                let _e890 = phi_1415_;
                                if (_e842 == 0u) {
                                    phi_1425_ = _e827.unnamed_1.word;
                                } else {
                                    phi_1425_ = _e827.unnamed_1.shift;
                                }
                                let _e899 = phi_1425_;
                                let _e912 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e881 >> bitcast<u32>(((_e843 * 8u) & 31u))) & 255u)) * _e599) + (_e620 + _e364)), ((f32(((_e890 >> bitcast<u32>(((_e843 * 8u) & 31u))) & 255u)) * _e600) + (_e621 + _e365)));
                                let _e913 = core_intrinsics_minimum_number_nsz_f32_(_e912, ((f32(((_e899 >> bitcast<u32>(((_e843 * 8u) & 31u))) & 255u)) * _e601) + (_e622 + _e366)));
                                if (_e878 <= _e913) {
                                    if (_e878 <= _e563.t) {
                                        if (_e913 >= _e158.tmin) {
                                            if (_e842 == 0u) {
                                                let _e920 = nodes.member[(0u + _e565)].links[2u];
                                                phi_1461_ = _e920;
                                            } else {
                                                let _e923 = nodes.member[(0u + _e565)].links[3u];
                                                phi_1461_ = _e923;
                                            }
                                            let _e925 = phi_1461_;
                                            let _e930 = ((_e925 >> bitcast<u32>(((_e843 * 8u) & 31u))) & 255u);
                                            let _e931 = (_e930 & 31u);
                                            if (_e931 >= 24u) {
                                                phi_1474_ = (24u + ((_e931 - 24u) ^ _e425));
                                            } else {
                                                phi_1474_ = _e931;
                                            }
                                            let _e937 = phi_1474_;
                                            phi_1479_ = (_e839 | ((_e930 >> bitcast<u32>(5i)) << bitcast<u32>((_e937 & 31u))));
                                        } else {
                                            phi_1479_ = _e839;
                                        }
                                        let _e945 = phi_1479_;
                                        phi_1480_ = _e945;
                                    } else {
                                        phi_1480_ = _e839;
                                    }
                                    let _e947 = phi_1480_;
                                    phi_1481_ = _e947;
                                } else {
                                    phi_1481_ = _e839;
                                }
                                let _e949 = phi_1481_;
                                phi_1351_ = (_e837 + 1u);
                                phi_1354_ = _e949;
                            } else {
                                phi_1351_ = u32();
                                phi_1354_ = u32();
                            }
                            let _e952 = phi_1351_;
                            let _e954 = phi_1354_;
                            continue;
                            continuing {
                                phi_1350_ = _e952;
                                phi_1353_ = _e954;
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
                        phi_1539_ = _e563;
                        phi_1542_ = (_e1003 & 16777215u);
                        loop {
                            let _e1006 = phi_1539_;
                            let _e1008 = phi_1542_;
                            local_5 = _e1006;
                            if (_e1008 == 0u) {
                                phi_1540_ = lt_bvh_Hit();
                                phi_1543_ = u32();
                                phi_2201_ = false;
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
                                    phi_1589_ = vec3<f32>(_e1030, _e1033, _e1027);
                                } else {
                                    if (_e392 == 1u) {
                                        phi_1588_ = vec3<f32>(_e1033, _e1027, _e1030);
                                    } else {
                                        phi_1588_ = (_e1024 - _e158.origin);
                                    }
                                    let _e1040 = phi_1588_;
                                    phi_1589_ = _e1040;
                                }
                                let _e1042 = phi_1589_;
                                let _e1046 = (_e1042.x - (_e409 * _e1042.z));
                                let _e1050 = (_e1042.y - (_e412 * _e1042.z));
                                let _e1052 = triangles.member[(0u + _e1017)].v1_;
                                let _e1055 = (_e1052.x - _e158.origin.x);
                                let _e1058 = (_e1052.y - _e158.origin.y);
                                let _e1061 = (_e1052.z - _e158.origin.z);
                                if (_e392 == 0u) {
                                    phi_1621_ = vec3<f32>(_e1058, _e1061, _e1055);
                                } else {
                                    if (_e392 == 1u) {
                                        phi_1620_ = vec3<f32>(_e1061, _e1055, _e1058);
                                    } else {
                                        phi_1620_ = (_e1052 - _e158.origin);
                                    }
                                    let _e1068 = phi_1620_;
                                    phi_1621_ = _e1068;
                                }
                                let _e1070 = phi_1621_;
                                let _e1074 = (_e1070.x - (_e409 * _e1070.z));
                                let _e1078 = (_e1070.y - (_e412 * _e1070.z));
                                let _e1080 = triangles.member[(0u + _e1017)].v2_;
                                let _e1083 = (_e1080.x - _e158.origin.x);
                                let _e1086 = (_e1080.y - _e158.origin.y);
                                let _e1089 = (_e1080.z - _e158.origin.z);
                                if (_e392 == 0u) {
                                    phi_1653_ = vec3<f32>(_e1086, _e1089, _e1083);
                                } else {
                                    if (_e392 == 1u) {
                                        phi_1652_ = vec3<f32>(_e1089, _e1083, _e1086);
                                    } else {
                                        phi_1652_ = (_e1080 - _e158.origin);
                                    }
                                    let _e1096 = phi_1652_;
                                    phi_1653_ = _e1096;
                                }
                                let _e1098 = phi_1653_;
                                let _e1102 = (_e1098.x - (_e409 * _e1098.z));
                                let _e1106 = (_e1098.y - (_e412 * _e1098.z));
                                if (_e1074 < _e1102) {
                                    phi_1672_ = true;
                                } else {
                                    if (_e1074 == _e1102) {
                                        phi_1671_ = (_e1078 < _e1106);
                                    } else {
                                        phi_1671_ = false;
                                    }
                                    let _e1111 = phi_1671_;
                                    phi_1672_ = _e1111;
                                }
                                let _e1113 = phi_1672_;
                                if _e1113 {
                                    phi_1676_ = _e1106;
                                    phi_1677_ = _e1102;
                                    phi_1678_ = _e1078;
                                    phi_1679_ = _e1074;
                                } else {
                                    phi_1676_ = _e1078;
                                    phi_1677_ = _e1074;
                                    phi_1678_ = _e1106;
                                    phi_1679_ = _e1102;
                                }
                                let _e1115 = phi_1676_;
                                let _e1117 = phi_1677_;
                                let _e1119 = phi_1678_;
                                let _e1121 = phi_1679_;
                                let _e1124 = ((_e1121 * _e1115) - (_e1119 * _e1117));
                                if _e1113 {
                                    phi_1687_ = -(_e1124);
                                } else {
                                    phi_1687_ = _e1124;
                                }
                                let _e1127 = phi_1687_;
                                if (_e1102 < _e1046) {
                                    phi_1698_ = true;
                                } else {
                                    if (_e1102 == _e1046) {
                                        phi_1697_ = (_e1106 < _e1050);
                                    } else {
                                        phi_1697_ = false;
                                    }
                                    let _e1132 = phi_1697_;
                                    phi_1698_ = _e1132;
                                }
                                let _e1134 = phi_1698_;
                                if _e1134 {
                                    phi_1702_ = _e1050;
                                    phi_1703_ = _e1046;
                                    phi_1704_ = _e1106;
                                    phi_1705_ = _e1102;
                                } else {
                                    phi_1702_ = _e1106;
                                    phi_1703_ = _e1102;
                                    phi_1704_ = _e1050;
                                    phi_1705_ = _e1046;
                                }
                                let _e1136 = phi_1702_;
                                let _e1138 = phi_1703_;
                                let _e1140 = phi_1704_;
                                let _e1142 = phi_1705_;
                                let _e1145 = ((_e1142 * _e1136) - (_e1140 * _e1138));
                                if _e1134 {
                                    phi_1713_ = -(_e1145);
                                } else {
                                    phi_1713_ = _e1145;
                                }
                                let _e1148 = phi_1713_;
                                if (_e1046 < _e1074) {
                                    phi_1724_ = true;
                                } else {
                                    if (_e1046 == _e1074) {
                                        phi_1723_ = (_e1050 < _e1078);
                                    } else {
                                        phi_1723_ = false;
                                    }
                                    let _e1153 = phi_1723_;
                                    phi_1724_ = _e1153;
                                }
                                let _e1155 = phi_1724_;
                                if _e1155 {
                                    phi_1728_ = _e1078;
                                    phi_1729_ = _e1074;
                                    phi_1730_ = _e1050;
                                    phi_1731_ = _e1046;
                                } else {
                                    phi_1728_ = _e1050;
                                    phi_1729_ = _e1046;
                                    phi_1730_ = _e1078;
                                    phi_1731_ = _e1074;
                                }
                                let _e1157 = phi_1728_;
                                let _e1159 = phi_1729_;
                                let _e1161 = phi_1730_;
                                let _e1163 = phi_1731_;
                                let _e1166 = ((_e1163 * _e1157) - (_e1161 * _e1159));
                                if _e1155 {
                                    phi_1739_ = -(_e1166);
                                } else {
                                    phi_1739_ = _e1166;
                                }
                                let _e1169 = phi_1739_;
                                if (_e1127 >= 0f) {
                                    if (_e1148 >= 0f) {
                                        if (_e1169 >= 0f) {
                                            phi_1754_ = ((_e1127 + _e1148) + _e1169);
                                            phi_1755_ = false;
                                        } else {
                                            phi_1754_ = f32();
                                            phi_1755_ = true;
                                        }
                                        let _e1176 = phi_1754_;
                                        let _e1178 = phi_1755_;
                                        phi_1756_ = _e1176;
                                        phi_1757_ = _e1178;
                                    } else {
                                        phi_1756_ = f32();
                                        phi_1757_ = true;
                                    }
                                    let _e1180 = phi_1756_;
                                    let _e1182 = phi_1757_;
                                    phi_1758_ = _e1180;
                                    phi_1759_ = _e1182;
                                } else {
                                    phi_1758_ = f32();
                                    phi_1759_ = true;
                                }
                                let _e1184 = phi_1758_;
                                let _e1186 = phi_1759_;
                                if _e1186 {
                                    if (_e1127 <= 0f) {
                                        if (_e1148 <= 0f) {
                                            let _e1189 = (_e1169 <= 0f);
                                            if _e1189 {
                                            }
                                            phi_1777_ = ((_e1127 + _e1148) + _e1169);
                                            phi_1778_ = false;
                                            phi_1779_ = _e1189;
                                        } else {
                                            phi_1777_ = f32();
                                            phi_1778_ = true;
                                            phi_1779_ = false;
                                        }
                                        let _e1193 = phi_1777_;
                                        let _e1195 = phi_1778_;
                                        let _e1197 = phi_1779_;
                                        phi_1780_ = _e1193;
                                        phi_1781_ = _e1195;
                                        phi_1782_ = _e1197;
                                    } else {
                                        phi_1780_ = f32();
                                        phi_1781_ = true;
                                        phi_1782_ = false;
                                    }
                                    let _e1199 = phi_1780_;
                                    let _e1201 = phi_1781_;
                                    let _e1203 = phi_1782_;
                                    if _e1201 {
                                        phi_1786_ = false;
                                    } else {
                                        phi_1786_ = _e1203;
                                    }
                                    let _e1205 = phi_1786_;
                                    phi_1787_ = _e1199;
                                    phi_1788_ = _e1205;
                                } else {
                                    phi_1787_ = _e1184;
                                    phi_1788_ = true;
                                }
                                let _e1207 = phi_1787_;
                                let _e1209 = phi_1788_;
                                if _e1209 {
                                    let _e1210 = (_e1207 == 0f);
                                    if _e1210 {
                                        phi_2114_ = lt_bvh_triangle_Intersection();
                                        phi_2115_ = false;
                                    } else {
                                        let _e1212 = triangles.member[(0u + _e1017)].v0_;
                                        let _e1215 = (_e1212.x - _e158.origin.x);
                                        let _e1218 = (_e1212.y - _e158.origin.y);
                                        let _e1221 = (_e1212.z - _e158.origin.z);
                                        if (_e392 == 0u) {
                                            phi_1819_ = vec3<f32>(_e1218, _e1221, _e1215);
                                        } else {
                                            if (_e392 == 1u) {
                                                phi_1818_ = vec3<f32>(_e1221, _e1215, _e1218);
                                            } else {
                                                phi_1818_ = (_e1212 - _e158.origin);
                                            }
                                            let _e1228 = phi_1818_;
                                            phi_1819_ = _e1228;
                                        }
                                        let _e1230 = phi_1819_;
                                        let _e1232 = triangles.member[(0u + _e1017)].v1_;
                                        let _e1234 = triangles.member[(0u + _e1017)].v0_;
                                        let _e1237 = (_e1232.x - _e1234.x);
                                        let _e1240 = (_e1232.y - _e1234.y);
                                        let _e1243 = (_e1232.z - _e1234.z);
                                        if (_e392 == 0u) {
                                            phi_1845_ = vec3<f32>(_e1240, _e1243, _e1237);
                                        } else {
                                            if (_e392 == 1u) {
                                                phi_1844_ = vec3<f32>(_e1243, _e1237, _e1240);
                                            } else {
                                                phi_1844_ = (_e1232 - _e1234);
                                            }
                                            let _e1250 = phi_1844_;
                                            phi_1845_ = _e1250;
                                        }
                                        let _e1252 = phi_1845_;
                                        let _e1254 = triangles.member[(0u + _e1017)].v2_;
                                        let _e1256 = triangles.member[(0u + _e1017)].v0_;
                                        let _e1259 = (_e1254.x - _e1256.x);
                                        let _e1262 = (_e1254.y - _e1256.y);
                                        let _e1265 = (_e1254.z - _e1256.z);
                                        if (_e392 == 0u) {
                                            phi_1871_ = vec3<f32>(_e1262, _e1265, _e1259);
                                        } else {
                                            if (_e392 == 1u) {
                                                phi_1870_ = vec3<f32>(_e1265, _e1259, _e1262);
                                            } else {
                                                phi_1870_ = (_e1254 - _e1256);
                                            }
                                            let _e1272 = phi_1870_;
                                            phi_1871_ = _e1272;
                                        }
                                        let _e1274 = phi_1871_;
                                        let _e1281 = ((_e1252.y * _e1274.z) - (_e1252.z * _e1274.y));
                                        let _e1288 = ((_e1252.z * _e1274.x) - (_e1252.x * _e1274.z));
                                        let _e1295 = ((_e1252.x * _e1274.y) - (_e1252.y * _e1274.x));
                                        let _e1309 = (((1f / _e406.z) * (((_e1281 * _e1230.x) + (_e1288 * _e1230.y)) + (_e1295 * _e1230.z))) / (((_e1281 * _e409) + (_e1288 * _e412)) + _e1295));
                                        if (_e1309 > _e158.tmin) {
                                            if (_e1309 < _e158.tmax) {
                                                let _e1315 = triangles.member[(0u + _e1017)].v0_;
                                                let _e1317 = triangles.member[(0u + _e1017)].v1_;
                                                if (_e1315.x < _e1317.x) {
                                                    phi_1929_ = _e1315.x;
                                                } else {
                                                    phi_1929_ = _e1317.x;
                                                }
                                                let _e1324 = phi_1929_;
                                                if (_e1315.y < _e1317.y) {
                                                    phi_1938_ = _e1315.y;
                                                } else {
                                                    phi_1938_ = _e1317.y;
                                                }
                                                let _e1331 = phi_1938_;
                                                if (_e1315.z < _e1317.z) {
                                                    phi_1947_ = _e1315.z;
                                                } else {
                                                    phi_1947_ = _e1317.z;
                                                }
                                                let _e1338 = phi_1947_;
                                                let _e1340 = triangles.member[(0u + _e1017)].v2_;
                                                if (_e1324 < _e1340.x) {
                                                    phi_1956_ = _e1324;
                                                } else {
                                                    phi_1956_ = _e1340.x;
                                                }
                                                let _e1345 = phi_1956_;
                                                if (_e1331 < _e1340.y) {
                                                    phi_1963_ = _e1331;
                                                } else {
                                                    phi_1963_ = _e1340.y;
                                                }
                                                let _e1350 = phi_1963_;
                                                if (_e1338 < _e1340.z) {
                                                    phi_1970_ = _e1338;
                                                } else {
                                                    phi_1970_ = _e1340.z;
                                                }
                                                let _e1355 = phi_1970_;
                                                let _e1357 = triangles.member[(0u + _e1017)].v0_;
                                                let _e1359 = triangles.member[(0u + _e1017)].v1_;
                                                if (_e1357.x > _e1359.x) {
                                                    phi_1983_ = _e1357.x;
                                                } else {
                                                    phi_1983_ = _e1359.x;
                                                }
                                                let _e1366 = phi_1983_;
                                                if (_e1357.y > _e1359.y) {
                                                    phi_1992_ = _e1357.y;
                                                } else {
                                                    phi_1992_ = _e1359.y;
                                                }
                                                let _e1373 = phi_1992_;
                                                if (_e1357.z > _e1359.z) {
                                                    phi_2001_ = _e1357.z;
                                                } else {
                                                    phi_2001_ = _e1359.z;
                                                }
                                                let _e1380 = phi_2001_;
                                                let _e1382 = triangles.member[(0u + _e1017)].v2_;
                                                if (_e1366 > _e1382.x) {
                                                    phi_2010_ = _e1366;
                                                } else {
                                                    phi_2010_ = _e1382.x;
                                                }
                                                let _e1387 = phi_2010_;
                                                if (_e1373 > _e1382.y) {
                                                    phi_2017_ = _e1373;
                                                } else {
                                                    phi_2017_ = _e1382.y;
                                                }
                                                let _e1392 = phi_2017_;
                                                if (_e1380 > _e1382.z) {
                                                    phi_2024_ = _e1380;
                                                } else {
                                                    phi_2024_ = _e1382.z;
                                                }
                                                let _e1397 = phi_2024_;
                                                let _e1404 = ((_e1345 - _e158.origin.x) * _e304);
                                                let _e1405 = ((_e1350 - _e158.origin.y) * _e315);
                                                let _e1406 = ((_e1355 - _e158.origin.z) * _e326);
                                                let _e1413 = ((_e1387 - _e158.origin.x) * _e304);
                                                let _e1414 = ((_e1392 - _e158.origin.y) * _e315);
                                                let _e1415 = ((_e1397 - _e158.origin.z) * _e326);
                                                if (_e1404 < _e1413) {
                                                    phi_2047_ = _e1404;
                                                } else {
                                                    phi_2047_ = _e1413;
                                                }
                                                let _e1418 = phi_2047_;
                                                if (_e1405 < _e1414) {
                                                    phi_2052_ = _e1405;
                                                } else {
                                                    phi_2052_ = _e1414;
                                                }
                                                let _e1421 = phi_2052_;
                                                if (_e1406 < _e1415) {
                                                    phi_2057_ = _e1406;
                                                } else {
                                                    phi_2057_ = _e1415;
                                                }
                                                let _e1424 = phi_2057_;
                                                if (_e1404 > _e1413) {
                                                    phi_2065_ = _e1404;
                                                } else {
                                                    phi_2065_ = _e1413;
                                                }
                                                let _e1430 = phi_2065_;
                                                if (_e1405 > _e1414) {
                                                    phi_2070_ = _e1405;
                                                } else {
                                                    phi_2070_ = _e1414;
                                                }
                                                let _e1433 = phi_2070_;
                                                if (_e1406 > _e1415) {
                                                    phi_2075_ = _e1406;
                                                } else {
                                                    phi_2075_ = _e1415;
                                                }
                                                let _e1436 = phi_2075_;
                                                let _e1440 = core_intrinsics_maximum_number_nsz_f32_((_e1418 - _e371), (_e1421 - _e372));
                                                let _e1441 = core_intrinsics_maximum_number_nsz_f32_(_e1440, (_e1424 - _e373));
                                                let _e1442 = core_intrinsics_minimum_number_nsz_f32_((_e1430 + _e371), (_e1433 + _e372));
                                                let _e1443 = core_intrinsics_minimum_number_nsz_f32_(_e1442, (_e1436 + _e373));
                                                if (_e1441 > -300000000000000000000000000000000000000f) {
                                                    phi_2087_ = _e1441;
                                                } else {
                                                    phi_2087_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1446 = phi_2087_;
                                                if (_e1443 < 300000000000000000000000000000000000000f) {
                                                    phi_2092_ = _e1443;
                                                } else {
                                                    phi_2092_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1449 = phi_2092_;
                                                if (_e1309 < _e1446) {
                                                    phi_2097_ = _e1446;
                                                } else {
                                                    phi_2097_ = _e1309;
                                                }
                                                let _e1452 = phi_2097_;
                                                if (_e1452 > _e1449) {
                                                    phi_2102_ = _e1449;
                                                } else {
                                                    phi_2102_ = _e1452;
                                                }
                                                let _e1455 = phi_2102_;
                                                phi_2107_ = lt_bvh_triangle_Intersection(_e1455, (_e1148 / _e1207), (_e1169 / _e1207), (_e1446 <= _e1449));
                                                phi_2108_ = false;
                                            } else {
                                                phi_2107_ = lt_bvh_triangle_Intersection();
                                                phi_2108_ = true;
                                            }
                                            let _e1461 = phi_2107_;
                                            let _e1463 = phi_2108_;
                                            phi_2109_ = _e1461;
                                            phi_2110_ = _e1463;
                                        } else {
                                            phi_2109_ = lt_bvh_triangle_Intersection();
                                            phi_2110_ = true;
                                        }
                                        let _e1465 = phi_2109_;
                                        let _e1467 = phi_2110_;
                                        if _e1467 {
                                        }
                                        phi_2114_ = _e1465;
                                        phi_2115_ = _e1467;
                                    }
                                    let _e1469 = phi_2114_;
                                    let _e1471 = phi_2115_;
                                    phi_2116_ = _e1469;
                                    phi_2117_ = _e1210;
                                    phi_2118_ = _e1471;
                                } else {
                                    phi_2116_ = lt_bvh_triangle_Intersection();
                                    phi_2117_ = true;
                                    phi_2118_ = false;
                                }
                                let _e1473 = phi_2116_;
                                let _e1475 = phi_2117_;
                                let _e1477 = phi_2118_;
                                if _e1475 {
                                    phi_2122_ = true;
                                } else {
                                    phi_2122_ = _e1477;
                                }
                                let _e1479 = phi_2122_;
                                if _e1479 {
                                    phi_2126_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_2126_ = _e1473;
                                }
                                let _e1481 = phi_2126_;
                                if _e1481.is_hit {
                                    if (_e1481.t > _e158.tmin) {
                                        if (_e1481.t < _e1006.t) {
                                            phi_2175_ = true;
                                        } else {
                                            if (_e1481.t == _e1006.t) {
                                                if (_e1006.triangle != 4294967295u) {
                                                    if (_e1017 < _e1006.triangle) {
                                                        phi_2166_ = true;
                                                    } else {
                                                        if (_e1017 == _e1006.triangle) {
                                                            phi_2165_ = (4294967295u < _e1006.instance);
                                                        } else {
                                                            phi_2165_ = false;
                                                        }
                                                        let _e1500 = phi_2165_;
                                                        phi_2166_ = _e1500;
                                                    }
                                                    let _e1502 = phi_2166_;
                                                    phi_2167_ = _e1502;
                                                    phi_2168_ = false;
                                                } else {
                                                    phi_2167_ = bool();
                                                    phi_2168_ = true;
                                                }
                                                let _e1504 = phi_2167_;
                                                let _e1506 = phi_2168_;
                                                phi_2169_ = _e1504;
                                                phi_2170_ = _e1506;
                                            } else {
                                                phi_2169_ = bool();
                                                phi_2170_ = true;
                                            }
                                            let _e1508 = phi_2169_;
                                            let _e1510 = phi_2170_;
                                            if _e1510 {
                                                phi_2174_ = false;
                                            } else {
                                                phi_2174_ = _e1508;
                                            }
                                            let _e1512 = phi_2174_;
                                            phi_2175_ = _e1512;
                                        }
                                        let _e1514 = phi_2175_;
                                        if _e1514 {
                                            let _e1516 = triangles.member[(0u + _e1017)].i0_;
                                            if ((_e1516 & 2147483648u) == 0u) {
                                                phi_2189_ = true;
                                            } else {
                                                if true {
                                                }
                                                phi_2189_ = true;
                                            }
                                            let _e1520 = phi_2189_;
                                            if _e1520 {
                                                phi_2197_ = lt_bvh_Hit(_e1481.t, _e1481.u, _e1481.v, _e1017, 4294967295u);
                                            } else {
                                                phi_2197_ = _e1006;
                                            }
                                            let _e1526 = phi_2197_;
                                            phi_2198_ = _e1526;
                                        } else {
                                            phi_2198_ = _e1006;
                                        }
                                        let _e1528 = phi_2198_;
                                        phi_2199_ = _e1528;
                                    } else {
                                        phi_2199_ = _e1006;
                                    }
                                    let _e1530 = phi_2199_;
                                    phi_2200_ = _e1530;
                                } else {
                                    phi_2200_ = _e1006;
                                }
                                let _e1532 = phi_2200_;
                                phi_1540_ = _e1532;
                                phi_1543_ = (_e1008 & (_e1008 - 1u));
                                phi_2201_ = true;
                            }
                            let _e1534 = phi_1540_;
                            let _e1536 = phi_1543_;
                            let _e1538 = phi_2201_;
                            continue;
                            continuing {
                                phi_1539_ = _e1534;
                                phi_1542_ = _e1536;
                                break if !(_e1538);
                            }
                        }
                        let _e1541 = local_1.group_mask;
                        if ((_e1541 & 4278190080u) == 0u) {
                            let _e1545 = local_1.len;
                            if (_e1545 == 0u) {
                                phi_2240_ = false;
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
                                phi_2240_ = true;
                            }
                            let _e1568 = phi_2240_;
                            phi_2241_ = _e1568;
                        } else {
                            phi_2241_ = true;
                        }
                        let _e1570 = phi_2241_;
                        if _e1570 {
                            let _e1572 = local_1.group_mask;
                            let _e1578 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1572)), 32u, (_e1572 == 0u)));
                            let _e1582 = local_1.group_mask;
                            let _e1596 = local_1.group_mask;
                            local_1.group_mask = (_e1596 & ~((1u << bitcast<u32>((_e1578 & 31u)))));
                            let _e1599 = local_1.group;
                            phi_2272_ = (_e1599 + countOneBits(((_e1582 & ~((4294967295u << bitcast<u32>((((_e1578 - 24u) ^ _e425) & 31u))))) & 255u)));
                        } else {
                            phi_2272_ = 4294967295u;
                        }
                        let _e1602 = phi_2272_;
                        let _e2520 = local_5;
                        phi_1203_ = _e2520;
                        phi_1206_ = _e1602;
                    } else {
                        phi_1203_ = lt_bvh_Hit();
                        phi_1206_ = u32();
                    }
                    let _e1604 = phi_1203_;
                    let _e1606 = phi_1206_;
                    continue;
                    continuing {
                        phi_1202_ = _e1604;
                        phi_1205_ = _e1606;
                        break if !(_e566);
                    }
                }
                let _e2524 = local_6;
                phi_2273_ = _e2524;
            }
            let _e1609 = phi_2273_;
            phi_2274_ = _e1609;
            phi_2275_ = _e222;
        } else {
            phi_2274_ = lt_bvh_Hit();
            phi_2275_ = true;
        }
        let _e1611 = phi_2274_;
        let _e1613 = phi_2275_;
        if _e1613 {
            phi_2279_ = _e160;
        } else {
            phi_2279_ = _e1611;
        }
        let _e1615 = phi_2279_;
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
                phi_2343_ = _e1656;
            } else {
                phi_2343_ = _e1662;
            }
            let _e1669 = phi_2343_;
            if (_e1658 > _e1664) {
                phi_2348_ = _e1658;
            } else {
                phi_2348_ = _e1664;
            }
            let _e1672 = phi_2348_;
            if (_e1660 > _e1666) {
                phi_2353_ = _e1660;
            } else {
                phi_2353_ = _e1666;
            }
            let _e1675 = phi_2353_;
            let _e1677 = abs(_e1626.v2_.x);
            let _e1679 = abs(_e1626.v2_.y);
            let _e1681 = abs(_e1626.v2_.z);
            if (_e1669 > _e1677) {
                phi_2364_ = _e1669;
            } else {
                phi_2364_ = _e1677;
            }
            let _e1684 = phi_2364_;
            if (_e1672 > _e1679) {
                phi_2369_ = _e1672;
            } else {
                phi_2369_ = _e1679;
            }
            let _e1687 = phi_2369_;
            if (_e1675 > _e1681) {
                phi_2374_ = _e1675;
            } else {
                phi_2374_ = _e1681;
            }
            let _e1690 = phi_2374_;
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
                phi_2450_ = vec3<f32>(-(_e1749), -(_e1750), -(_e1751));
            } else {
                phi_2450_ = vec3<f32>(_e1749, _e1750, _e1751);
            }
            let _e1764 = phi_2450_;
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
                phi_2693_ = vec3<f32>(1f, 1f, 1f);
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
                phi_2693_ = vec3<f32>((_e2000 * _e2000), (_e2001 * _e2001), (_e2002 * _e2002));
            }
            let _e2008 = phi_2693_;
            let _e2010 = ((_e1792.base_color.x * ((((f32((_e1786[0].color & 255u)) * _e1809) * _e1621) + ((f32((_e1786[1].color & 255u)) * _e1828) * _e1615.u)) + ((f32((_e1786[2].color & 255u)) * _e1850) * _e1615.v))) * _e2008.x);
            let _e2012 = ((_e1792.base_color.y * ((((f32(((_e1786[0].color >> bitcast<u32>(8i)) & 255u)) * _e1809) * _e1621) + ((f32(((_e1786[1].color >> bitcast<u32>(8i)) & 255u)) * _e1828) * _e1615.u)) + ((f32(((_e1786[2].color >> bitcast<u32>(8i)) & 255u)) * _e1850) * _e1615.v))) * _e2008.y);
            let _e2014 = ((_e1792.base_color.z * ((((f32(((_e1786[0].color >> bitcast<u32>(16i)) & 255u)) * _e1809) * _e1621) + ((f32(((_e1786[1].color >> bitcast<u32>(16i)) & 255u)) * _e1828) * _e1615.u)) + ((f32(((_e1786[2].color >> bitcast<u32>(16i)) & 255u)) * _e1850) * _e1615.v))) * _e2008.z);
            let _e2015 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1687, _e1690);
            let _e2016 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1684, _e2015);
            if ((_e1792.flags & 2u) == 0u) {
                phi_2708_ = 0u;
            } else {
                phi_2708_ = 1u;
            }
            let _e2021 = phi_2708_;
            if (_e1786[0].normal == 2147516416u) {
                phi_2911_ = _e1764;
            } else {
                let _e2034 = (f32((bitcast<i32>((_e1786[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2040 = (f32((bitcast<i32>(_e1786[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2044 = ((1f - abs(_e2034)) - abs(_e2040));
                if (_e2044 < 0f) {
                    phi_2735_ = -(_e2044);
                } else {
                    phi_2735_ = 0f;
                }
                let _e2048 = phi_2735_;
                if (_e2034 < 0f) {
                    phi_2742_ = (_e2034 + _e2048);
                } else {
                    phi_2742_ = (_e2034 - _e2048);
                }
                let _e2053 = phi_2742_;
                if (_e2040 < 0f) {
                    phi_2749_ = (_e2040 + _e2048);
                } else {
                    phi_2749_ = (_e2040 - _e2048);
                }
                let _e2058 = phi_2749_;
                let _e2065 = (1f / sqrt((((_e2053 * _e2053) + (_e2058 * _e2058)) + (_e2044 * _e2044))));
                let _e2081 = (f32((bitcast<i32>((_e1786[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2087 = (f32((bitcast<i32>(_e1786[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2091 = ((1f - abs(_e2081)) - abs(_e2087));
                if (_e2091 < 0f) {
                    phi_2784_ = -(_e2091);
                } else {
                    phi_2784_ = 0f;
                }
                let _e2095 = phi_2784_;
                if (_e2081 < 0f) {
                    phi_2791_ = (_e2081 + _e2095);
                } else {
                    phi_2791_ = (_e2081 - _e2095);
                }
                let _e2100 = phi_2791_;
                if (_e2087 < 0f) {
                    phi_2798_ = (_e2087 + _e2095);
                } else {
                    phi_2798_ = (_e2087 - _e2095);
                }
                let _e2105 = phi_2798_;
                let _e2112 = (1f / sqrt((((_e2100 * _e2100) + (_e2105 * _e2105)) + (_e2091 * _e2091))));
                let _e2131 = (f32((bitcast<i32>((_e1786[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2137 = (f32((bitcast<i32>(_e1786[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2141 = ((1f - abs(_e2131)) - abs(_e2137));
                if (_e2141 < 0f) {
                    phi_2836_ = -(_e2141);
                } else {
                    phi_2836_ = 0f;
                }
                let _e2145 = phi_2836_;
                if (_e2131 < 0f) {
                    phi_2843_ = (_e2131 + _e2145);
                } else {
                    phi_2843_ = (_e2131 - _e2145);
                }
                let _e2150 = phi_2843_;
                if (_e2137 < 0f) {
                    phi_2850_ = (_e2137 + _e2145);
                } else {
                    phi_2850_ = (_e2137 - _e2145);
                }
                let _e2155 = phi_2850_;
                let _e2162 = (1f / sqrt((((_e2150 * _e2150) + (_e2155 * _e2155)) + (_e2141 * _e2141))));
                let _e2173 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(vec3<f32>(((((_e2053 * _e2065) * _e1621) + ((_e2100 * _e2112) * _e1615.u)) + ((_e2150 * _e2162) * _e1615.v)), ((((_e2058 * _e2065) * _e1621) + ((_e2105 * _e2112) * _e1615.u)) + ((_e2155 * _e2162) * _e1615.v)), ((((_e2044 * _e2065) * _e1621) + ((_e2091 * _e2112) * _e1615.u)) + ((_e2141 * _e2162) * _e1615.v))));
                let _e2185 = sqrt((((_e2173.x * _e2173.x) + (_e2173.y * _e2173.y)) + (_e2173.z * _e2173.z)));
                if (_e2185 > 0f) {
                    let _e2188 = (_e2173.x / _e2185);
                    let _e2190 = (_e2173.y / _e2185);
                    let _e2192 = (_e2173.z / _e2185);
                    if ((((_e2188 * _e1764.x) + (_e2190 * _e1764.y)) + (_e2192 * _e1764.z)) < 0f) {
                        phi_2909_ = vec3<f32>(-(_e2188), -(_e2190), -(_e2192));
                    } else {
                        phi_2909_ = (_e2173 / vec3(_e2185));
                    }
                    let _e2209 = phi_2909_;
                    phi_2910_ = _e2209;
                } else {
                    phi_2910_ = _e1764;
                }
                let _e2211 = phi_2910_;
                phi_2911_ = _e2211;
            }
            let _e2213 = phi_2911_;
            if (_e2010 > 0f) {
                if (_e2010 < 1f) {
                    phi_2920_ = _e2010;
                } else {
                    phi_2920_ = 1f;
                }
                let _e2217 = phi_2920_;
                phi_2921_ = _e2217;
            } else {
                phi_2921_ = 0f;
            }
            let _e2219 = phi_2921_;
            if (_e2012 > 0f) {
                if (_e2012 < 1f) {
                    phi_2931_ = _e2012;
                } else {
                    phi_2931_ = 1f;
                }
                let _e2224 = phi_2931_;
                phi_2932_ = _e2224;
            } else {
                phi_2932_ = 0f;
            }
            let _e2226 = phi_2932_;
            if (_e2014 > 0f) {
                if (_e2014 < 1f) {
                    phi_2942_ = _e2014;
                } else {
                    phi_2942_ = 1f;
                }
                let _e2231 = phi_2942_;
                phi_2943_ = _e2231;
            } else {
                phi_2943_ = 0f;
            }
            let _e2233 = phi_2943_;
            let _e2236 = ((sqrt(_e2219) * 255f) + 0.5f);
            let _e2245 = ((sqrt(_e2226) * 255f) + 0.5f);
            let _e2257 = ((sqrt(_e2233) * 255f) + 0.5f);
            phi_2978_ = abi_Sample(vec3<f32>(_e1651, _e1652, _e1653), _e2016, _e1764, _e2021, _e2213, ((select(select(u32(_e2236), 0u, (_e2236 < bitcast<f32>(0u))), 4294967295u, (_e2236 > bitcast<f32>(1333788671u))) | (select(select(u32(_e2245), 0u, (_e2245 < bitcast<f32>(0u))), 4294967295u, (_e2245 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e2257), 0u, (_e2257 < bitcast<f32>(0u))), 4294967295u, (_e2257 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_2978_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e2271 = phi_2978_;
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
            phi_3069_ = vec3<f32>((((_e2306.x * _e2280) + (_e2317.x * _e1615.u)) + (_e2331.x * _e1615.v)), (((_e2306.y * _e2280) + (_e2317.y * _e1615.u)) + (_e2331.y * _e1615.v)), (((_e2306.z * _e2280) + (_e2317.z * _e1615.u)) + (_e2331.z * _e1615.v)));
        } else {
            phi_3069_ = vec3<f32>(0f, 0f, 0f);
        }
        let _e2343 = phi_3069_;
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
