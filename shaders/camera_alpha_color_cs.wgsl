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

struct type_30 {
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

struct type_34 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_38 {
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

struct type_42 {
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

struct type_53 {
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
var<storage> vertices: type_38;
@group(0) @binding(4) 
var<storage> materials: type_42;
@group(0) @binding(0) 
var<uniform> p: type_53;
@group(0) @binding(1) 
var<storage> nodes: type_30;
@group(0) @binding(2) 
var<storage> triangles: type_34;
@group(0) @binding(5) 
var<storage, read_write> samples: type_9;
@group(0) @binding(6) 
var<storage> alpha_texels: type_13;
@group(0) @binding(7) 
var<storage> color_texels: type_13;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_mask_LightPlace {
    var phi_212_: lt_mask_LightPlace;
    var phi_213_: bool;
    var phi_214_: lt_mask_LightPlace;
    var phi_215_: bool;
    var phi_220_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_212_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_213_ = false;
        } else {
            phi_212_ = lt_mask_LightPlace();
            phi_213_ = true;
        }
        let _e83 = phi_212_;
        let _e85 = phi_213_;
        phi_214_ = _e83;
        phi_215_ = _e85;
    } else {
        phi_214_ = lt_mask_LightPlace();
        phi_215_ = true;
    }
    let _e87 = phi_214_;
    let _e89 = phi_215_;
    if _e89 {
        phi_220_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_220_ = _e87;
    }
    let _e94 = phi_220_;
    return lt_mask_LightPlace(_e94.word, _e94.shift);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_235_: bool;
    var phi_239_: f32;

    if (param_3 != param_3) {
        phi_235_ = true;
    } else {
        let _e73 = (param_4 >= param_3);
        if _e73 {
        }
        phi_235_ = _e73;
    }
    let _e75 = phi_235_;
    if _e75 {
        phi_239_ = param_4;
    } else {
        phi_239_ = param_3;
    }
    let _e77 = phi_239_;
    return _e77;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_251_: bool;
    var phi_255_: f32;

    if (param_5 != param_5) {
        phi_251_ = true;
    } else {
        let _e73 = (param_6 <= param_5);
        if _e73 {
        }
        phi_251_ = _e73;
    }
    let _e75 = phi_251_;
    if _e75 {
        phi_255_ = param_6;
    } else {
        phi_255_ = param_5;
    }
    let _e77 = phi_255_;
    return _e77;
}

fn _lt_shaders_texture_TextureView_quad(param_7: ptr<function, texture_TextureView>, param_8: f32, param_9: f32) -> texture_TexelQuad {
    var phi_297_: f32;
    var phi_302_: f32;
    var phi_303_: bool;
    var phi_304_: f32;
    var phi_305_: bool;
    var phi_309_: f32;
    var phi_335_: f32;
    var phi_340_: f32;
    var phi_341_: bool;
    var phi_342_: f32;
    var phi_343_: bool;
    var phi_347_: f32;
    var phi_355_: f32;
    var phi_356_: f32;
    var phi_357_: f32;
    var phi_366_: f32;
    var phi_367_: f32;
    var phi_385_: u32;
    var phi_399_: u32;
    var phi_406_: u32;
    var phi_411_: u32;
    var phi_417_: u32;
    var phi_422_: u32;
    var phi_424_: texture_Axis;
    var phi_452_: f32;
    var phi_457_: f32;
    var phi_458_: bool;
    var phi_459_: f32;
    var phi_460_: bool;
    var phi_464_: f32;
    var phi_490_: f32;
    var phi_495_: f32;
    var phi_496_: bool;
    var phi_497_: f32;
    var phi_498_: bool;
    var phi_502_: f32;
    var phi_510_: f32;
    var phi_511_: f32;
    var phi_512_: f32;
    var phi_521_: f32;
    var phi_522_: f32;
    var phi_540_: u32;
    var phi_554_: u32;
    var phi_561_: u32;
    var phi_566_: u32;
    var phi_572_: u32;
    var phi_577_: u32;
    var phi_579_: texture_Axis;

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
                phi_297_ = 1f;
            } else {
                phi_297_ = 0f;
            }
            let _e104 = phi_297_;
            if (param_8 < 8388608f) {
                phi_302_ = (_e101 - _e104);
                phi_303_ = false;
            } else {
                phi_302_ = f32();
                phi_303_ = true;
            }
            let _e107 = phi_302_;
            let _e109 = phi_303_;
            phi_304_ = _e107;
            phi_305_ = _e109;
        } else {
            phi_304_ = f32();
            phi_305_ = true;
        }
        let _e111 = phi_304_;
        let _e113 = phi_305_;
        if _e113 {
            phi_309_ = param_8;
        } else {
            phi_309_ = _e111;
        }
        let _e115 = phi_309_;
        phi_357_ = (param_8 - _e115);
    } else {
        if (_e88 == 1u) {
            let _e118 = (param_8 * 0.5f);
            if (_e118 > -8388608f) {
                let _e130 = f32(select(0i, select(select(i32(_e118), i32(-2147483648), (_e118 < bitcast<f32>(3472883712u))), 2147483647i, (_e118 > bitcast<f32>(1325400063u))), (_e118 == _e118)));
                if (_e130 > _e118) {
                    phi_335_ = 1f;
                } else {
                    phi_335_ = 0f;
                }
                let _e133 = phi_335_;
                if (_e118 < 8388608f) {
                    phi_340_ = (_e130 - _e133);
                    phi_341_ = false;
                } else {
                    phi_340_ = f32();
                    phi_341_ = true;
                }
                let _e136 = phi_340_;
                let _e138 = phi_341_;
                phi_342_ = _e136;
                phi_343_ = _e138;
            } else {
                phi_342_ = f32();
                phi_343_ = true;
            }
            let _e140 = phi_342_;
            let _e142 = phi_343_;
            if _e142 {
                phi_347_ = _e118;
            } else {
                phi_347_ = _e140;
            }
            let _e144 = phi_347_;
            let _e146 = (param_8 - (2f * _e144));
            if (_e146 > 1f) {
                phi_355_ = (2f - _e146);
            } else {
                phi_355_ = _e146;
            }
            let _e150 = phi_355_;
            phi_356_ = _e150;
        } else {
            phi_356_ = param_8;
        }
        let _e152 = phi_356_;
        phi_357_ = _e152;
    }
    let _e154 = phi_357_;
    if (_e154 > 0f) {
        if (_e154 < 1f) {
            phi_366_ = _e154;
        } else {
            phi_366_ = 1f;
        }
        let _e158 = phi_366_;
        phi_367_ = _e158;
    } else {
        phi_367_ = 0f;
    }
    let _e160 = phi_367_;
    let _e161 = (_e75 - 1u);
    let _e163 = (_e160 * f32(_e75));
    if _e83 {
        let _e170 = select(select(u32(_e163), 0u, (_e163 < bitcast<f32>(0u))), 4294967295u, (_e163 > bitcast<f32>(1333788671u)));
        if (_e161 < _e170) {
            phi_385_ = _e161;
        } else {
            phi_385_ = _e170;
        }
        let _e173 = phi_385_;
        phi_424_ = texture_Axis(_e173, _e173, 0f);
    } else {
        let _e175 = (_e163 + 0.5f);
        let _e182 = select(select(u32(_e175), 0u, (_e175 < bitcast<f32>(0u))), 4294967295u, (_e175 > bitcast<f32>(1333788671u)));
        if (_e75 < _e182) {
            phi_399_ = _e75;
        } else {
            phi_399_ = _e182;
        }
        let _e185 = phi_399_;
        if (_e88 == 0u) {
            phi_406_ = _e161;
        } else {
            phi_406_ = 0u;
        }
        let _e190 = phi_406_;
        if (_e88 == 0u) {
            phi_411_ = 0u;
        } else {
            phi_411_ = _e161;
        }
        let _e193 = phi_411_;
        if (_e185 == 0u) {
            phi_417_ = _e190;
        } else {
            phi_417_ = (_e185 - 1u);
        }
        let _e197 = phi_417_;
        if (_e185 > _e161) {
            phi_422_ = _e193;
        } else {
            phi_422_ = _e185;
        }
        let _e200 = phi_422_;
        phi_424_ = texture_Axis(_e197, _e200, (_e175 - f32(_e185)));
    }
    let _e203 = phi_424_;
    let _e205 = (*param_7).flags;
    let _e208 = ((_e205 >> bitcast<u32>(6u)) & 3u);
    if (_e208 == 0u) {
        if (param_9 > -8388608f) {
            let _e221 = f32(select(0i, select(select(i32(param_9), i32(-2147483648), (param_9 < bitcast<f32>(3472883712u))), 2147483647i, (param_9 > bitcast<f32>(1325400063u))), (param_9 == param_9)));
            if (_e221 > param_9) {
                phi_452_ = 1f;
            } else {
                phi_452_ = 0f;
            }
            let _e224 = phi_452_;
            if (param_9 < 8388608f) {
                phi_457_ = (_e221 - _e224);
                phi_458_ = false;
            } else {
                phi_457_ = f32();
                phi_458_ = true;
            }
            let _e227 = phi_457_;
            let _e229 = phi_458_;
            phi_459_ = _e227;
            phi_460_ = _e229;
        } else {
            phi_459_ = f32();
            phi_460_ = true;
        }
        let _e231 = phi_459_;
        let _e233 = phi_460_;
        if _e233 {
            phi_464_ = param_9;
        } else {
            phi_464_ = _e231;
        }
        let _e235 = phi_464_;
        phi_512_ = (param_9 - _e235);
    } else {
        if (_e208 == 1u) {
            let _e238 = (param_9 * 0.5f);
            if (_e238 > -8388608f) {
                let _e250 = f32(select(0i, select(select(i32(_e238), i32(-2147483648), (_e238 < bitcast<f32>(3472883712u))), 2147483647i, (_e238 > bitcast<f32>(1325400063u))), (_e238 == _e238)));
                if (_e250 > _e238) {
                    phi_490_ = 1f;
                } else {
                    phi_490_ = 0f;
                }
                let _e253 = phi_490_;
                if (_e238 < 8388608f) {
                    phi_495_ = (_e250 - _e253);
                    phi_496_ = false;
                } else {
                    phi_495_ = f32();
                    phi_496_ = true;
                }
                let _e256 = phi_495_;
                let _e258 = phi_496_;
                phi_497_ = _e256;
                phi_498_ = _e258;
            } else {
                phi_497_ = f32();
                phi_498_ = true;
            }
            let _e260 = phi_497_;
            let _e262 = phi_498_;
            if _e262 {
                phi_502_ = _e238;
            } else {
                phi_502_ = _e260;
            }
            let _e264 = phi_502_;
            let _e266 = (param_9 - (2f * _e264));
            if (_e266 > 1f) {
                phi_510_ = (2f - _e266);
            } else {
                phi_510_ = _e266;
            }
            let _e270 = phi_510_;
            phi_511_ = _e270;
        } else {
            phi_511_ = param_9;
        }
        let _e272 = phi_511_;
        phi_512_ = _e272;
    }
    let _e274 = phi_512_;
    if (_e274 > 0f) {
        if (_e274 < 1f) {
            phi_521_ = _e274;
        } else {
            phi_521_ = 1f;
        }
        let _e278 = phi_521_;
        phi_522_ = _e278;
    } else {
        phi_522_ = 0f;
    }
    let _e280 = phi_522_;
    let _e281 = (_e79 - 1u);
    let _e283 = (_e280 * f32(_e79));
    if _e83 {
        let _e290 = select(select(u32(_e283), 0u, (_e283 < bitcast<f32>(0u))), 4294967295u, (_e283 > bitcast<f32>(1333788671u)));
        if (_e281 < _e290) {
            phi_540_ = _e281;
        } else {
            phi_540_ = _e290;
        }
        let _e293 = phi_540_;
        phi_579_ = texture_Axis(_e293, _e293, 0f);
    } else {
        let _e295 = (_e283 + 0.5f);
        let _e302 = select(select(u32(_e295), 0u, (_e295 < bitcast<f32>(0u))), 4294967295u, (_e295 > bitcast<f32>(1333788671u)));
        if (_e79 < _e302) {
            phi_554_ = _e79;
        } else {
            phi_554_ = _e302;
        }
        let _e305 = phi_554_;
        if (_e208 == 0u) {
            phi_561_ = _e281;
        } else {
            phi_561_ = 0u;
        }
        let _e310 = phi_561_;
        if (_e208 == 0u) {
            phi_566_ = 0u;
        } else {
            phi_566_ = _e281;
        }
        let _e313 = phi_566_;
        if (_e305 == 0u) {
            phi_572_ = _e310;
        } else {
            phi_572_ = (_e305 - 1u);
        }
        let _e317 = phi_572_;
        if (_e305 > _e281) {
            phi_577_ = _e313;
        } else {
            phi_577_ = _e305;
        }
        let _e320 = phi_577_;
        phi_579_ = texture_Axis(_e317, _e320, (_e295 - f32(_e305)));
    }
    let _e323 = phi_579_;
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
    var phi_638_: f32;

    if (param_12 > param_13) {
        phi_638_ = param_12;
    } else {
        phi_638_ = param_13;
    }
    let _e74 = phi_638_;
    return _e74;
}

fn _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(param_14: vec3<f32>) -> vec3<f32> {
    return param_14;
}

fn function_() {
    var local: texture_TextureView;
    var local_1: texture_TextureView;
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
    var phi_1002_: bool;
    var phi_1003_: bool;
    var phi_1011_: u32;
    var phi_1012_: u32;
    var phi_1030_: vec3<f32>;
    var phi_1031_: vec3<f32>;
    var phi_1045_: u32;
    var phi_1050_: u32;
    var phi_1055_: u32;
    var phi_1169_: bool;
    var phi_1170_: bool;
    var phi_1201_: u32;
    var phi_1203_: lt_bvh_Hit;
    var phi_1206_: u32;
    var phi_1291_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1318_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1345_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1351_: u32;
    var phi_1354_: u32;
    var phi_1368_: u32;
    var phi_1378_: u32;
    var phi_1388_: u32;
    var phi_1406_: u32;
    var phi_1416_: u32;
    var phi_1426_: u32;
    var phi_1462_: u32;
    var phi_1475_: u32;
    var phi_1480_: u32;
    var phi_1481_: u32;
    var phi_1482_: u32;
    var phi_1352_: u32;
    var phi_1355_: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_1540_: lt_bvh_Hit;
    var phi_1543_: u32;
    var phi_1589_: vec3<f32>;
    var phi_1590_: vec3<f32>;
    var phi_1621_: vec3<f32>;
    var phi_1622_: vec3<f32>;
    var phi_1653_: vec3<f32>;
    var phi_1654_: vec3<f32>;
    var phi_1672_: bool;
    var phi_1673_: bool;
    var phi_1677_: f32;
    var phi_1678_: f32;
    var phi_1679_: f32;
    var phi_1680_: f32;
    var phi_1688_: f32;
    var phi_1698_: bool;
    var phi_1699_: bool;
    var phi_1703_: f32;
    var phi_1704_: f32;
    var phi_1705_: f32;
    var phi_1706_: f32;
    var phi_1714_: f32;
    var phi_1724_: bool;
    var phi_1725_: bool;
    var phi_1729_: f32;
    var phi_1730_: f32;
    var phi_1731_: f32;
    var phi_1732_: f32;
    var phi_1740_: f32;
    var phi_1755_: f32;
    var phi_1756_: bool;
    var phi_1757_: f32;
    var phi_1758_: bool;
    var phi_1759_: f32;
    var phi_1760_: bool;
    var phi_1778_: f32;
    var phi_1779_: bool;
    var phi_1780_: bool;
    var phi_1781_: f32;
    var phi_1782_: bool;
    var phi_1783_: bool;
    var phi_1787_: bool;
    var phi_1788_: f32;
    var phi_1789_: bool;
    var phi_1819_: vec3<f32>;
    var phi_1820_: vec3<f32>;
    var phi_1845_: vec3<f32>;
    var phi_1846_: vec3<f32>;
    var phi_1871_: vec3<f32>;
    var phi_1872_: vec3<f32>;
    var phi_1930_: f32;
    var phi_1939_: f32;
    var phi_1948_: f32;
    var phi_1957_: f32;
    var phi_1964_: f32;
    var phi_1971_: f32;
    var phi_1984_: f32;
    var phi_1993_: f32;
    var phi_2002_: f32;
    var phi_2011_: f32;
    var phi_2018_: f32;
    var phi_2025_: f32;
    var phi_2048_: f32;
    var phi_2053_: f32;
    var phi_2058_: f32;
    var phi_2066_: f32;
    var phi_2071_: f32;
    var phi_2076_: f32;
    var phi_2088_: f32;
    var phi_2093_: f32;
    var phi_2098_: f32;
    var phi_2103_: f32;
    var phi_2108_: lt_bvh_triangle_Intersection;
    var phi_2109_: bool;
    var phi_2110_: lt_bvh_triangle_Intersection;
    var phi_2111_: bool;
    var phi_2115_: lt_bvh_triangle_Intersection;
    var phi_2116_: bool;
    var phi_2117_: lt_bvh_triangle_Intersection;
    var phi_2118_: bool;
    var phi_2119_: bool;
    var phi_2123_: bool;
    var phi_2127_: lt_bvh_triangle_Intersection;
    var phi_2166_: bool;
    var phi_2167_: bool;
    var phi_2168_: bool;
    var phi_2169_: bool;
    var phi_2170_: bool;
    var phi_2171_: bool;
    var phi_2175_: bool;
    var phi_2176_: bool;
    var phi_2379_: f32;
    var phi_2382_: bool;
    var phi_2383_: bool;
    var phi_2387_: bool;
    var phi_2395_: lt_bvh_Hit;
    var phi_2396_: lt_bvh_Hit;
    var phi_2397_: lt_bvh_Hit;
    var phi_2398_: lt_bvh_Hit;
    var phi_1541_: lt_bvh_Hit;
    var phi_1544_: u32;
    var phi_2399_: bool;
    var phi_2438_: bool;
    var phi_2439_: bool;
    var phi_2470_: u32;
    var phi_1204_: lt_bvh_Hit;
    var phi_1207_: u32;
    var phi_2471_: lt_bvh_Hit;
    var phi_2472_: lt_bvh_Hit;
    var phi_2473_: bool;
    var phi_2477_: lt_bvh_Hit;
    var phi_2541_: f32;
    var phi_2546_: f32;
    var phi_2551_: f32;
    var phi_2562_: f32;
    var phi_2567_: f32;
    var phi_2572_: f32;
    var phi_2648_: vec3<f32>;
    var phi_2891_: vec3<f32>;
    var phi_2906_: u32;
    var phi_2933_: f32;
    var phi_2940_: f32;
    var phi_2947_: f32;
    var phi_2982_: f32;
    var phi_2989_: f32;
    var phi_2996_: f32;
    var phi_3034_: f32;
    var phi_3041_: f32;
    var phi_3048_: f32;
    var phi_3107_: vec3<f32>;
    var phi_3108_: vec3<f32>;
    var phi_3109_: vec3<f32>;
    var phi_3118_: f32;
    var phi_3119_: f32;
    var phi_3129_: f32;
    var phi_3130_: f32;
    var phi_3140_: f32;
    var phi_3141_: f32;
    var phi_3176_: abi_Sample;
    var local_6: lt_bvh_Hit;
    var local_7: lt_bvh_Hit;

    let _e73 = id_1;
    let _e77 = arrayLength((&nodes.member));
    let _e80 = arrayLength((&triangles.member));
    let _e83 = arrayLength((&vertices.member));
    let _e86 = arrayLength((&materials.member));
    let _e92 = arrayLength((&alpha_texels.member));
    let _e95 = arrayLength((&color_texels.member));
    let _e98 = p.member.size[0u];
    let _e100 = p.member.size[1u];
    let _e101 = lt_shaders_entry_pixel_index(_e73, _e98, _e100);
    if (bitcast<i32>(_e101.word) != 0i) {
        let _e109 = p.member.eye;
        let _e114 = p.member.size[0u];
        let _e118 = ((((f32(_e73.x) + 0.5f) / f32(_e114)) * 2f) - 1f);
        let _e123 = p.member.size[1u];
        let _e127 = (1f - (((f32(_e73.y) + 0.5f) / f32(_e123)) * 2f));
        let _e129 = p.member.forward;
        let _e131 = p.member.right;
        let _e145 = p.member.up;
        let _e156 = _lt_bvh_ray_Ray_new(_e109, vec3<f32>(((_e129.x + (_e131.x * _e118)) + (_e145.x * _e127)), ((_e129.y + (_e131.y * _e118)) + (_e145.y * _e127)), ((_e129.z + (_e131.z * _e118)) + (_e145.z * _e127))));
        let _e158 = lt_bvh_Hit(_e156.tmax, 0f, 0f, 4294967295u, 4294967295u);
        let _e168 = abs(_e156.direction.x);
        let _e170 = abs(_e156.direction.y);
        let _e172 = abs(_e156.direction.z);
        if (abs(_e156.origin.x) < 1000000000000000f) {
            if (abs(_e156.origin.y) < 1000000000000000f) {
                if (abs(_e156.origin.z) < 1000000000000000f) {
                    if (_e168 < 1000000000000000f) {
                        if (_e170 < 1000000000000000f) {
                            if (_e172 < 1000000000000000f) {
                                if (_e168 > 0f) {
                                    phi_792_ = bool();
                                    phi_793_ = true;
                                } else {
                                    let _e180 = (_e170 > 0f);
                                    if _e180 {
                                        phi_791_ = bool();
                                    } else {
                                        phi_791_ = (_e172 > 0f);
                                    }
                                    let _e183 = phi_791_;
                                    phi_792_ = _e183;
                                    phi_793_ = _e180;
                                }
                                let _e185 = phi_792_;
                                let _e187 = phi_793_;
                                if _e187 {
                                    phi_797_ = true;
                                } else {
                                    phi_797_ = _e185;
                                }
                                let _e189 = phi_797_;
                                phi_798_ = _e189;
                                phi_799_ = false;
                            } else {
                                phi_798_ = bool();
                                phi_799_ = true;
                            }
                            let _e191 = phi_798_;
                            let _e193 = phi_799_;
                            phi_800_ = _e191;
                            phi_801_ = false;
                            phi_802_ = _e193;
                        } else {
                            phi_800_ = bool();
                            phi_801_ = true;
                            phi_802_ = false;
                        }
                        let _e195 = phi_800_;
                        let _e197 = phi_801_;
                        let _e199 = phi_802_;
                        phi_803_ = _e195;
                        phi_804_ = _e197;
                        phi_805_ = _e199;
                    } else {
                        phi_803_ = bool();
                        phi_804_ = true;
                        phi_805_ = false;
                    }
                    let _e201 = phi_803_;
                    let _e203 = phi_804_;
                    let _e205 = phi_805_;
                    phi_806_ = _e201;
                    phi_807_ = _e203;
                    phi_808_ = _e205;
                } else {
                    phi_806_ = bool();
                    phi_807_ = true;
                    phi_808_ = false;
                }
                let _e207 = phi_806_;
                let _e209 = phi_807_;
                let _e211 = phi_808_;
                phi_809_ = _e207;
                phi_810_ = _e209;
                phi_811_ = _e211;
            } else {
                phi_809_ = bool();
                phi_810_ = true;
                phi_811_ = false;
            }
            let _e213 = phi_809_;
            let _e215 = phi_810_;
            let _e217 = phi_811_;
            phi_812_ = _e213;
            phi_813_ = _e215;
            phi_814_ = _e217;
        } else {
            phi_812_ = bool();
            phi_813_ = true;
            phi_814_ = false;
        }
        let _e219 = phi_812_;
        let _e221 = phi_813_;
        let _e223 = phi_814_;
        if _e221 {
            phi_818_ = true;
        } else {
            phi_818_ = _e223;
        }
        let _e225 = phi_818_;
        if _e225 {
            phi_822_ = false;
        } else {
            phi_822_ = _e219;
        }
        let _e227 = phi_822_;
        if _e227 {
            let _e228 = (0u >= _e77);
            if _e228 {
                phi_2471_ = lt_bvh_Hit();
            } else {
                if (0u < _e77) {
                } else {
                    return;
                }
                let _e234 = nodes.member[(0u + 0u)].frame[0u];
                let _e238 = nodes.member[(0u + 0u)].frame[1u];
                let _e242 = nodes.member[(0u + 0u)].frame[2u];
                let _e246 = nodes.member[(0u + 0u)].frame[0u];
                let _e250 = nodes.member[(0u + 0u)].frame[1u];
                let _e254 = nodes.member[(0u + 0u)].frame[2u];
                let _e258 = nodes.member[(0u + 0u)].frame[3u];
                let _e296 = core_intrinsics_maximum_number_nsz_f32_(abs(_e156.direction.x), abs(_e156.direction.y));
                let _e297 = core_intrinsics_maximum_number_nsz_f32_(_e296, abs(_e156.direction.z));
                let _e298 = (_e297 * 0.0000000000009094947f);
                if (abs(_e156.direction.x) < _e298) {
                    phi_897_ = _e298;
                } else {
                    phi_897_ = abs(_e156.direction.x);
                }
                let _e304 = phi_897_;
                if (_e156.direction.x < 0f) {
                    phi_904_ = (-1f / _e304);
                } else {
                    phi_904_ = (1f / _e304);
                }
                let _e309 = phi_904_;
                if (abs(_e156.direction.y) < _e298) {
                    phi_912_ = _e298;
                } else {
                    phi_912_ = abs(_e156.direction.y);
                }
                let _e315 = phi_912_;
                if (_e156.direction.y < 0f) {
                    phi_919_ = (-1f / _e315);
                } else {
                    phi_919_ = (1f / _e315);
                }
                let _e320 = phi_919_;
                if (abs(_e156.direction.z) < _e298) {
                    phi_927_ = _e298;
                } else {
                    phi_927_ = abs(_e156.direction.z);
                }
                let _e326 = phi_927_;
                if (_e156.direction.z < 0f) {
                    phi_934_ = (-1f / _e326);
                } else {
                    phi_934_ = (1f / _e326);
                }
                let _e331 = phi_934_;
                let _e339 = abs((bitcast<f32>(_e234) - _e156.origin.x));
                let _e340 = abs((bitcast<f32>(_e238) - _e156.origin.y));
                let _e341 = abs((bitcast<f32>(_e242) - _e156.origin.z));
                let _e349 = abs(((bitcast<f32>(_e246) + (bitcast<f32>((((_e258 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e156.origin.x));
                let _e350 = abs(((bitcast<f32>(_e250) + (bitcast<f32>((((_e258 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e156.origin.y));
                let _e351 = abs(((bitcast<f32>(_e254) + (bitcast<f32>((((_e258 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e156.origin.z));
                if (_e339 > _e349) {
                    phi_959_ = _e339;
                } else {
                    phi_959_ = _e349;
                }
                let _e354 = phi_959_;
                if (_e340 > _e350) {
                    phi_964_ = _e340;
                } else {
                    phi_964_ = _e350;
                }
                let _e357 = phi_964_;
                if (_e341 > _e351) {
                    phi_969_ = _e341;
                } else {
                    phi_969_ = _e351;
                }
                let _e360 = phi_969_;
                let _e361 = core_intrinsics_maximum_number_nsz_f32_(_e354, _e357);
                let _e362 = core_intrinsics_maximum_number_nsz_f32_(_e361, _e360);
                let _e367 = (_e362 * 0.0000019073486f);
                let _e368 = (abs(_e309) * _e367);
                let _e369 = (abs(_e320) * _e367);
                let _e370 = (abs(_e331) * _e367);
                let _e374 = (_e362 * 0.0000009536743f);
                let _e375 = (abs(_e309) * _e374);
                let _e376 = (abs(_e320) * _e374);
                let _e377 = (abs(_e331) * _e374);
                let _e380 = abs(_e156.direction.x);
                let _e382 = abs(_e156.direction.y);
                let _e384 = abs(_e156.direction.z);
                if (_e380 >= _e382) {
                    if (_e380 >= _e384) {
                        phi_1002_ = false;
                    } else {
                        phi_1002_ = true;
                    }
                    let _e388 = phi_1002_;
                    phi_1003_ = _e388;
                } else {
                    phi_1003_ = true;
                }
                let _e390 = phi_1003_;
                if _e390 {
                    if (_e382 >= _e384) {
                        phi_1011_ = 1u;
                    } else {
                        phi_1011_ = 2u;
                    }
                    let _e393 = phi_1011_;
                    phi_1012_ = _e393;
                } else {
                    phi_1012_ = 0u;
                }
                let _e395 = phi_1012_;
                if (_e395 == 0u) {
                    phi_1031_ = vec3<f32>(_e156.direction.y, _e156.direction.z, _e156.direction.x);
                } else {
                    if (_e395 == 1u) {
                        phi_1030_ = vec3<f32>(_e156.direction.z, _e156.direction.x, _e156.direction.y);
                    } else {
                        phi_1030_ = _e156.direction;
                    }
                    let _e408 = phi_1030_;
                    phi_1031_ = _e408;
                }
                let _e410 = phi_1031_;
                let _e414 = (_e410.x / _e410.z);
                let _e417 = (_e410.y / _e410.z);
                if (_e309 < 0f) {
                    phi_1045_ = 0u;
                } else {
                    phi_1045_ = 1u;
                }
                let _e422 = phi_1045_;
                if (_e320 < 0f) {
                    phi_1050_ = 0u;
                } else {
                    phi_1050_ = 2u;
                }
                let _e425 = phi_1050_;
                if (_e331 < 0f) {
                    phi_1055_ = 0u;
                } else {
                    phi_1055_ = 4u;
                }
                let _e428 = phi_1055_;
                let _e430 = ((_e422 | _e425) | _e428);
                let _e431 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e431.first[0], _e431.first[1], _e431.first[2], _e431.first[3], _e431.first[4], _e431.first[5], _e431.first[6], _e431.first[7], _e431.first[8], _e431.first[9], _e431.first[10], _e431.first[11], _e431.first[12], _e431.first[13], _e431.first[14], _e431.first[15], _e431.first[16], _e431.first[17], _e431.first[18], _e431.first[19], _e431.first[20], _e431.first[21], _e431.first[22], _e431.first[23], _e431.first[24], _e431.first[25], _e431.first[26], _e431.first[27], _e431.first[28], _e431.first[29], _e431.first[30], _e431.first[31]), array<u32, 32>(_e431.mask[0], _e431.mask[1], _e431.mask[2], _e431.mask[3], _e431.mask[4], _e431.mask[5], _e431.mask[6], _e431.mask[7], _e431.mask[8], _e431.mask[9], _e431.mask[10], _e431.mask[11], _e431.mask[12], _e431.mask[13], _e431.mask[14], _e431.mask[15], _e431.mask[16], _e431.mask[17], _e431.mask[18], _e431.mask[19], _e431.mask[20], _e431.mask[21], _e431.mask[22], _e431.mask[23], _e431.mask[24], _e431.mask[25], _e431.mask[26], _e431.mask[27], _e431.mask[28], _e431.mask[29], _e431.mask[30], _e431.mask[31]), _e431.len, _e431.group, _e431.group_mask);
                let _e505 = local_2.group_mask;
                if ((_e505 & 4278190080u) == 0u) {
                    let _e509 = local_2.len;
                    if (_e509 == 0u) {
                        phi_1169_ = false;
                    } else {
                        let _e513 = local_2.len;
                        local_2.len = (_e513 - 1u);
                        let _e516 = local_2.len;
                        if (_e516 < 32u) {
                        } else {
                            return;
                        }
                        let _e521 = local_2.first[(0u + _e516)];
                        local_2.group = _e521;
                        let _e524 = local_2.len;
                        if (_e524 < 32u) {
                        } else {
                            return;
                        }
                        let _e529 = local_2.mask[(0u + _e524)];
                        local_2.group_mask = _e529;
                        phi_1169_ = true;
                    }
                    let _e532 = phi_1169_;
                    phi_1170_ = _e532;
                } else {
                    phi_1170_ = true;
                }
                let _e534 = phi_1170_;
                if _e534 {
                    let _e536 = local_2.group_mask;
                    let _e542 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e536)), 32u, (_e536 == 0u)));
                    let _e546 = local_2.group_mask;
                    let _e560 = local_2.group_mask;
                    local_2.group_mask = (_e560 & ~((1u << bitcast<u32>((_e542 & 31u)))));
                    let _e563 = local_2.group;
                    phi_1201_ = (_e563 + countOneBits(((_e546 & ~((4294967295u << bitcast<u32>((((_e542 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1201_ = 4294967295u;
                }
                let _e566 = phi_1201_;
                phi_1203_ = _e158;
                phi_1206_ = _e566;
                loop {
                    let _e568 = phi_1203_;
                    let _e570 = phi_1206_;
                    local_7 = _e568;
                    let _e571 = (_e570 != 4294967295u);
                    if _e571 {
                        if (_e570 < _e77) {
                        } else {
                            return;
                        }
                        let _e579 = nodes.member[(0u + _e570)].frame[3u];
                        let _e604 = (bitcast<f32>((((_e579 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e309);
                        let _e605 = (bitcast<f32>((((_e579 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e320);
                        let _e606 = (bitcast<f32>((((_e579 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e331);
                        let _e609 = nodes.member[(0u + _e570)].frame[0u];
                        let _e613 = nodes.member[(0u + _e570)].frame[1u];
                        let _e617 = nodes.member[(0u + _e570)].frame[2u];
                        let _e625 = ((bitcast<f32>(_e609) - _e156.origin.x) * _e309);
                        let _e626 = ((bitcast<f32>(_e613) - _e156.origin.y) * _e320);
                        let _e627 = ((bitcast<f32>(_e617) - _e156.origin.z) * _e331);
                        let _e635 = nodes.member[(0u + _e570)].x;
                        if (_e309 < 0f) {
                            let _e646 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e635.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e652 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e646.unnamed.word, _e635.w), _e646.unnamed_1);
                            let _e658 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e652.unnamed, lt_mask_LightPlace(_e635.x, _e652.unnamed_1.shift));
                            phi_1291_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e658.unnamed, lt_mask_LightPlace(_e658.unnamed_1.word, _e635.y));
                        } else {
                            let _e674 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e635.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e680 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e674.unnamed.word, _e635.y), _e674.unnamed_1);
                            let _e686 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e680.unnamed, lt_mask_LightPlace(_e635.z, _e680.unnamed_1.shift));
                            phi_1291_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e686.unnamed, lt_mask_LightPlace(_e686.unnamed_1.word, _e635.w));
                        }
                        let _e694 = phi_1291_;
                        let _e704 = nodes.member[(0u + _e570)].y;
                        if (_e320 < 0f) {
                            let _e715 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e704.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e721 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e715.unnamed.word, _e704.w), _e715.unnamed_1);
                            let _e727 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e721.unnamed, lt_mask_LightPlace(_e704.x, _e721.unnamed_1.shift));
                            phi_1318_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e727.unnamed, lt_mask_LightPlace(_e727.unnamed_1.word, _e704.y));
                        } else {
                            let _e743 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e704.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e749 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e743.unnamed.word, _e704.y), _e743.unnamed_1);
                            let _e755 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e749.unnamed, lt_mask_LightPlace(_e704.z, _e749.unnamed_1.shift));
                            phi_1318_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e755.unnamed, lt_mask_LightPlace(_e755.unnamed_1.word, _e704.w));
                        }
                        let _e763 = phi_1318_;
                        let _e773 = nodes.member[(0u + _e570)].z;
                        if (_e331 < 0f) {
                            let _e784 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e773.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e790 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e784.unnamed.word, _e773.w), _e784.unnamed_1);
                            let _e796 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e790.unnamed, lt_mask_LightPlace(_e773.x, _e790.unnamed_1.shift));
                            phi_1345_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e796.unnamed, lt_mask_LightPlace(_e796.unnamed_1.word, _e773.y));
                        } else {
                            let _e812 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e773.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e818 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e812.unnamed.word, _e773.y), _e812.unnamed_1);
                            let _e824 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e818.unnamed, lt_mask_LightPlace(_e773.z, _e818.unnamed_1.shift));
                            phi_1345_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e824.unnamed, lt_mask_LightPlace(_e824.unnamed_1.word, _e773.w));
                        }
                        let _e832 = phi_1345_;
                        phi_1351_ = 0u;
                        phi_1354_ = 0u;
                        loop {
                            let _e842 = phi_1351_;
                            let _e844 = phi_1354_;
                            local_3 = _e844;
                            local_4 = _e844;
                            local_5 = _e844;
                            let _e845 = (_e842 < 8u);
                            if _e845 {
                                let _e847 = (_e842 >> bitcast<u32>(2i));
                                let _e848 = (_e842 & 3u);
                                if (_e847 == 0u) {
                                    phi_1368_ = _e694.unnamed.word;
                                } else {
                                    phi_1368_ = _e694.unnamed.shift;
                                }
                                let _e851 = phi_1368_;
                                if (_e847 == 0u) {
                                    phi_1378_ = _e763.unnamed.word;
                                } else {
                                    phi_1378_ = _e763.unnamed.shift;
                                }
                                let _e860 = phi_1378_;
                                if (_e847 == 0u) {
                                    phi_1388_ = _e832.unnamed.word;
                                } else {
                                    phi_1388_ = _e832.unnamed.shift;
                                }
                                let _e869 = phi_1388_;
                                let _e882 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e851 >> bitcast<u32>(((_e848 * 8u) & 31u))) & 255u)) * _e604) + (_e625 - _e368)), ((f32(((_e860 >> bitcast<u32>(((_e848 * 8u) & 31u))) & 255u)) * _e605) + (_e626 - _e369)));
                                let _e883 = core_intrinsics_maximum_number_nsz_f32_(_e882, ((f32(((_e869 >> bitcast<u32>(((_e848 * 8u) & 31u))) & 255u)) * _e606) + (_e627 - _e370)));
                                if (_e847 == 0u) {
                                    phi_1406_ = _e694.unnamed_1.word;
                                } else {
                                    phi_1406_ = _e694.unnamed_1.shift;
                                }
                                let _e886 = phi_1406_;
                                if (_e847 == 0u) {
                                    phi_1416_ = _e763.unnamed_1.word;
                                } else {
                                    phi_1416_ = _e763.unnamed_1.shift;
                                }
                                let _e895 = phi_1416_;
                                if (_e847 == 0u) {
                                    phi_1426_ = _e832.unnamed_1.word;
                                } else {
                                    phi_1426_ = _e832.unnamed_1.shift;
                                }
                                let _e904 = phi_1426_;
                                let _e917 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e886 >> bitcast<u32>(((_e848 * 8u) & 31u))) & 255u)) * _e604) + (_e625 + _e368)), ((f32(((_e895 >> bitcast<u32>(((_e848 * 8u) & 31u))) & 255u)) * _e605) + (_e626 + _e369)));
                                let _e918 = core_intrinsics_minimum_number_nsz_f32_(_e917, ((f32(((_e904 >> bitcast<u32>(((_e848 * 8u) & 31u))) & 255u)) * _e606) + (_e627 + _e370)));
                                if (_e883 <= _e918) {
                                    if (_e883 <= _e568.t) {
                                        if (_e918 >= _e156.tmin) {
                                            if (_e847 == 0u) {
                                                let _e925 = nodes.member[(0u + _e570)].links[2u];
                                                phi_1462_ = _e925;
                                            } else {
                                                let _e928 = nodes.member[(0u + _e570)].links[3u];
                                                phi_1462_ = _e928;
                                            }
                                            let _e930 = phi_1462_;
                                            let _e935 = ((_e930 >> bitcast<u32>(((_e848 * 8u) & 31u))) & 255u);
                                            let _e936 = (_e935 & 31u);
                                            if (_e936 >= 24u) {
                                                phi_1475_ = (24u + ((_e936 - 24u) ^ _e430));
                                            } else {
                                                phi_1475_ = _e936;
                                            }
                                            let _e942 = phi_1475_;
                                            phi_1480_ = (_e844 | ((_e935 >> bitcast<u32>(5i)) << bitcast<u32>((_e942 & 31u))));
                                        } else {
                                            phi_1480_ = _e844;
                                        }
                                        let _e950 = phi_1480_;
                                        phi_1481_ = _e950;
                                    } else {
                                        phi_1481_ = _e844;
                                    }
                                    let _e952 = phi_1481_;
                                    phi_1482_ = _e952;
                                } else {
                                    phi_1482_ = _e844;
                                }
                                let _e954 = phi_1482_;
                                phi_1352_ = (_e842 + 1u);
                                phi_1355_ = _e954;
                            } else {
                                phi_1352_ = u32();
                                phi_1355_ = u32();
                            }
                            let _e957 = phi_1352_;
                            let _e959 = phi_1355_;
                            continue;
                            continuing {
                                phi_1351_ = _e957;
                                phi_1354_ = _e959;
                                break if !(_e845);
                            }
                        }
                        let _e963 = nodes.member[(0u + _e570)].links[0u];
                        let _e967 = nodes.member[(0u + _e570)].frame[3u];
                        let _e971 = local_3;
                        if ((_e971 & 4278190080u) == 0u) {
                        } else {
                            let _e975 = local_2.group_mask;
                            if ((_e975 & 4278190080u) == 0u) {
                            } else {
                                let _e979 = local_2.len;
                                if (_e979 < 32u) {
                                    let _e982 = local_2.group;
                                    let _e984 = local_2.len;
                                    if (_e984 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.first[(0u + _e984)] = _e982;
                                    let _e990 = local_2.group_mask;
                                    let _e992 = local_2.len;
                                    if (_e992 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.mask[(0u + _e992)] = _e990;
                                    let _e999 = local_2.len;
                                    local_2.len = (_e999 + 1u);
                                }
                            }
                            local_2.group = (0u + _e963);
                            let _e1003 = local_4;
                            local_2.group_mask = ((_e1003 & 4278190080u) | (_e967 >> bitcast<u32>(24i)));
                        }
                        let _e1008 = local_5;
                        phi_1540_ = _e568;
                        phi_1543_ = (_e1008 & 16777215u);
                        loop {
                            let _e1011 = phi_1540_;
                            let _e1013 = phi_1543_;
                            local_6 = _e1011;
                            if (_e1013 == 0u) {
                                phi_1541_ = lt_bvh_Hit();
                                phi_1544_ = u32();
                                phi_2399_ = false;
                            } else {
                                let _e1017 = nodes.member[(0u + _e570)].links[1u];
                                let _e1022 = ((0u + _e1017) + select(firstTrailingBit(_e1013), 32u, (_e1013 == 0u)));
                                if (_e1022 < _e80) {
                                } else {
                                    return;
                                }
                                let _e1029 = triangles.member[(0u + _e1022)].v0_;
                                let _e1032 = (_e1029.x - _e156.origin.x);
                                let _e1035 = (_e1029.y - _e156.origin.y);
                                let _e1038 = (_e1029.z - _e156.origin.z);
                                if (_e395 == 0u) {
                                    phi_1590_ = vec3<f32>(_e1035, _e1038, _e1032);
                                } else {
                                    if (_e395 == 1u) {
                                        phi_1589_ = vec3<f32>(_e1038, _e1032, _e1035);
                                    } else {
                                        phi_1589_ = (_e1029 - _e156.origin);
                                    }
                                    let _e1045 = phi_1589_;
                                    phi_1590_ = _e1045;
                                }
                                let _e1047 = phi_1590_;
                                let _e1051 = (_e1047.x - (_e414 * _e1047.z));
                                let _e1055 = (_e1047.y - (_e417 * _e1047.z));
                                let _e1057 = triangles.member[(0u + _e1022)].v1_;
                                let _e1060 = (_e1057.x - _e156.origin.x);
                                let _e1063 = (_e1057.y - _e156.origin.y);
                                let _e1066 = (_e1057.z - _e156.origin.z);
                                if (_e395 == 0u) {
                                    phi_1622_ = vec3<f32>(_e1063, _e1066, _e1060);
                                } else {
                                    if (_e395 == 1u) {
                                        phi_1621_ = vec3<f32>(_e1066, _e1060, _e1063);
                                    } else {
                                        phi_1621_ = (_e1057 - _e156.origin);
                                    }
                                    let _e1073 = phi_1621_;
                                    phi_1622_ = _e1073;
                                }
                                let _e1075 = phi_1622_;
                                let _e1079 = (_e1075.x - (_e414 * _e1075.z));
                                let _e1083 = (_e1075.y - (_e417 * _e1075.z));
                                let _e1085 = triangles.member[(0u + _e1022)].v2_;
                                let _e1088 = (_e1085.x - _e156.origin.x);
                                let _e1091 = (_e1085.y - _e156.origin.y);
                                let _e1094 = (_e1085.z - _e156.origin.z);
                                if (_e395 == 0u) {
                                    phi_1654_ = vec3<f32>(_e1091, _e1094, _e1088);
                                } else {
                                    if (_e395 == 1u) {
                                        phi_1653_ = vec3<f32>(_e1094, _e1088, _e1091);
                                    } else {
                                        phi_1653_ = (_e1085 - _e156.origin);
                                    }
                                    let _e1101 = phi_1653_;
                                    phi_1654_ = _e1101;
                                }
                                let _e1103 = phi_1654_;
                                let _e1107 = (_e1103.x - (_e414 * _e1103.z));
                                let _e1111 = (_e1103.y - (_e417 * _e1103.z));
                                if (_e1079 < _e1107) {
                                    phi_1673_ = true;
                                } else {
                                    if (_e1079 == _e1107) {
                                        phi_1672_ = (_e1083 < _e1111);
                                    } else {
                                        phi_1672_ = false;
                                    }
                                    let _e1116 = phi_1672_;
                                    phi_1673_ = _e1116;
                                }
                                let _e1118 = phi_1673_;
                                if _e1118 {
                                    phi_1677_ = _e1111;
                                    phi_1678_ = _e1107;
                                    phi_1679_ = _e1083;
                                    phi_1680_ = _e1079;
                                } else {
                                    phi_1677_ = _e1083;
                                    phi_1678_ = _e1079;
                                    phi_1679_ = _e1111;
                                    phi_1680_ = _e1107;
                                }
                                let _e1120 = phi_1677_;
                                let _e1122 = phi_1678_;
                                let _e1124 = phi_1679_;
                                let _e1126 = phi_1680_;
                                let _e1129 = ((_e1126 * _e1120) - (_e1124 * _e1122));
                                if _e1118 {
                                    phi_1688_ = -(_e1129);
                                } else {
                                    phi_1688_ = _e1129;
                                }
                                let _e1132 = phi_1688_;
                                if (_e1107 < _e1051) {
                                    phi_1699_ = true;
                                } else {
                                    if (_e1107 == _e1051) {
                                        phi_1698_ = (_e1111 < _e1055);
                                    } else {
                                        phi_1698_ = false;
                                    }
                                    let _e1137 = phi_1698_;
                                    phi_1699_ = _e1137;
                                }
                                let _e1139 = phi_1699_;
                                if _e1139 {
                                    phi_1703_ = _e1055;
                                    phi_1704_ = _e1051;
                                    phi_1705_ = _e1111;
                                    phi_1706_ = _e1107;
                                } else {
                                    phi_1703_ = _e1111;
                                    phi_1704_ = _e1107;
                                    phi_1705_ = _e1055;
                                    phi_1706_ = _e1051;
                                }
                                let _e1141 = phi_1703_;
                                let _e1143 = phi_1704_;
                                let _e1145 = phi_1705_;
                                let _e1147 = phi_1706_;
                                let _e1150 = ((_e1147 * _e1141) - (_e1145 * _e1143));
                                if _e1139 {
                                    phi_1714_ = -(_e1150);
                                } else {
                                    phi_1714_ = _e1150;
                                }
                                let _e1153 = phi_1714_;
                                if (_e1051 < _e1079) {
                                    phi_1725_ = true;
                                } else {
                                    if (_e1051 == _e1079) {
                                        phi_1724_ = (_e1055 < _e1083);
                                    } else {
                                        phi_1724_ = false;
                                    }
                                    let _e1158 = phi_1724_;
                                    phi_1725_ = _e1158;
                                }
                                let _e1160 = phi_1725_;
                                if _e1160 {
                                    phi_1729_ = _e1083;
                                    phi_1730_ = _e1079;
                                    phi_1731_ = _e1055;
                                    phi_1732_ = _e1051;
                                } else {
                                    phi_1729_ = _e1055;
                                    phi_1730_ = _e1051;
                                    phi_1731_ = _e1083;
                                    phi_1732_ = _e1079;
                                }
                                let _e1162 = phi_1729_;
                                let _e1164 = phi_1730_;
                                let _e1166 = phi_1731_;
                                let _e1168 = phi_1732_;
                                let _e1171 = ((_e1168 * _e1162) - (_e1166 * _e1164));
                                if _e1160 {
                                    phi_1740_ = -(_e1171);
                                } else {
                                    phi_1740_ = _e1171;
                                }
                                let _e1174 = phi_1740_;
                                if (_e1132 >= 0f) {
                                    if (_e1153 >= 0f) {
                                        if (_e1174 >= 0f) {
                                            phi_1755_ = ((_e1132 + _e1153) + _e1174);
                                            phi_1756_ = false;
                                        } else {
                                            phi_1755_ = f32();
                                            phi_1756_ = true;
                                        }
                                        let _e1181 = phi_1755_;
                                        let _e1183 = phi_1756_;
                                        phi_1757_ = _e1181;
                                        phi_1758_ = _e1183;
                                    } else {
                                        phi_1757_ = f32();
                                        phi_1758_ = true;
                                    }
                                    let _e1185 = phi_1757_;
                                    let _e1187 = phi_1758_;
                                    phi_1759_ = _e1185;
                                    phi_1760_ = _e1187;
                                } else {
                                    phi_1759_ = f32();
                                    phi_1760_ = true;
                                }
                                let _e1189 = phi_1759_;
                                let _e1191 = phi_1760_;
                                if _e1191 {
                                    if (_e1132 <= 0f) {
                                        if (_e1153 <= 0f) {
                                            let _e1194 = (_e1174 <= 0f);
                                            if _e1194 {
                                            }
                                            phi_1778_ = ((_e1132 + _e1153) + _e1174);
                                            phi_1779_ = false;
                                            phi_1780_ = _e1194;
                                        } else {
                                            phi_1778_ = f32();
                                            phi_1779_ = true;
                                            phi_1780_ = false;
                                        }
                                        let _e1198 = phi_1778_;
                                        let _e1200 = phi_1779_;
                                        let _e1202 = phi_1780_;
                                        phi_1781_ = _e1198;
                                        phi_1782_ = _e1200;
                                        phi_1783_ = _e1202;
                                    } else {
                                        phi_1781_ = f32();
                                        phi_1782_ = true;
                                        phi_1783_ = false;
                                    }
                                    let _e1204 = phi_1781_;
                                    let _e1206 = phi_1782_;
                                    let _e1208 = phi_1783_;
                                    if _e1206 {
                                        phi_1787_ = false;
                                    } else {
                                        phi_1787_ = _e1208;
                                    }
                                    let _e1210 = phi_1787_;
                                    phi_1788_ = _e1204;
                                    phi_1789_ = _e1210;
                                } else {
                                    phi_1788_ = _e1189;
                                    phi_1789_ = true;
                                }
                                let _e1212 = phi_1788_;
                                let _e1214 = phi_1789_;
                                if _e1214 {
                                    let _e1215 = (_e1212 == 0f);
                                    if _e1215 {
                                        phi_2115_ = lt_bvh_triangle_Intersection();
                                        phi_2116_ = false;
                                    } else {
                                        let _e1217 = triangles.member[(0u + _e1022)].v0_;
                                        let _e1220 = (_e1217.x - _e156.origin.x);
                                        let _e1223 = (_e1217.y - _e156.origin.y);
                                        let _e1226 = (_e1217.z - _e156.origin.z);
                                        if (_e395 == 0u) {
                                            phi_1820_ = vec3<f32>(_e1223, _e1226, _e1220);
                                        } else {
                                            if (_e395 == 1u) {
                                                phi_1819_ = vec3<f32>(_e1226, _e1220, _e1223);
                                            } else {
                                                phi_1819_ = (_e1217 - _e156.origin);
                                            }
                                            let _e1233 = phi_1819_;
                                            phi_1820_ = _e1233;
                                        }
                                        let _e1235 = phi_1820_;
                                        let _e1237 = triangles.member[(0u + _e1022)].v1_;
                                        let _e1239 = triangles.member[(0u + _e1022)].v0_;
                                        let _e1242 = (_e1237.x - _e1239.x);
                                        let _e1245 = (_e1237.y - _e1239.y);
                                        let _e1248 = (_e1237.z - _e1239.z);
                                        if (_e395 == 0u) {
                                            phi_1846_ = vec3<f32>(_e1245, _e1248, _e1242);
                                        } else {
                                            if (_e395 == 1u) {
                                                phi_1845_ = vec3<f32>(_e1248, _e1242, _e1245);
                                            } else {
                                                phi_1845_ = (_e1237 - _e1239);
                                            }
                                            let _e1255 = phi_1845_;
                                            phi_1846_ = _e1255;
                                        }
                                        let _e1257 = phi_1846_;
                                        let _e1259 = triangles.member[(0u + _e1022)].v2_;
                                        let _e1261 = triangles.member[(0u + _e1022)].v0_;
                                        let _e1264 = (_e1259.x - _e1261.x);
                                        let _e1267 = (_e1259.y - _e1261.y);
                                        let _e1270 = (_e1259.z - _e1261.z);
                                        if (_e395 == 0u) {
                                            phi_1872_ = vec3<f32>(_e1267, _e1270, _e1264);
                                        } else {
                                            if (_e395 == 1u) {
                                                phi_1871_ = vec3<f32>(_e1270, _e1264, _e1267);
                                            } else {
                                                phi_1871_ = (_e1259 - _e1261);
                                            }
                                            let _e1277 = phi_1871_;
                                            phi_1872_ = _e1277;
                                        }
                                        let _e1279 = phi_1872_;
                                        let _e1286 = ((_e1257.y * _e1279.z) - (_e1257.z * _e1279.y));
                                        let _e1293 = ((_e1257.z * _e1279.x) - (_e1257.x * _e1279.z));
                                        let _e1300 = ((_e1257.x * _e1279.y) - (_e1257.y * _e1279.x));
                                        let _e1314 = (((1f / _e410.z) * (((_e1286 * _e1235.x) + (_e1293 * _e1235.y)) + (_e1300 * _e1235.z))) / (((_e1286 * _e414) + (_e1293 * _e417)) + _e1300));
                                        if (_e1314 > _e156.tmin) {
                                            if (_e1314 < _e156.tmax) {
                                                let _e1320 = triangles.member[(0u + _e1022)].v0_;
                                                let _e1322 = triangles.member[(0u + _e1022)].v1_;
                                                if (_e1320.x < _e1322.x) {
                                                    phi_1930_ = _e1320.x;
                                                } else {
                                                    phi_1930_ = _e1322.x;
                                                }
                                                let _e1329 = phi_1930_;
                                                if (_e1320.y < _e1322.y) {
                                                    phi_1939_ = _e1320.y;
                                                } else {
                                                    phi_1939_ = _e1322.y;
                                                }
                                                let _e1336 = phi_1939_;
                                                if (_e1320.z < _e1322.z) {
                                                    phi_1948_ = _e1320.z;
                                                } else {
                                                    phi_1948_ = _e1322.z;
                                                }
                                                let _e1343 = phi_1948_;
                                                let _e1345 = triangles.member[(0u + _e1022)].v2_;
                                                if (_e1329 < _e1345.x) {
                                                    phi_1957_ = _e1329;
                                                } else {
                                                    phi_1957_ = _e1345.x;
                                                }
                                                let _e1350 = phi_1957_;
                                                if (_e1336 < _e1345.y) {
                                                    phi_1964_ = _e1336;
                                                } else {
                                                    phi_1964_ = _e1345.y;
                                                }
                                                let _e1355 = phi_1964_;
                                                if (_e1343 < _e1345.z) {
                                                    phi_1971_ = _e1343;
                                                } else {
                                                    phi_1971_ = _e1345.z;
                                                }
                                                let _e1360 = phi_1971_;
                                                let _e1362 = triangles.member[(0u + _e1022)].v0_;
                                                let _e1364 = triangles.member[(0u + _e1022)].v1_;
                                                if (_e1362.x > _e1364.x) {
                                                    phi_1984_ = _e1362.x;
                                                } else {
                                                    phi_1984_ = _e1364.x;
                                                }
                                                let _e1371 = phi_1984_;
                                                if (_e1362.y > _e1364.y) {
                                                    phi_1993_ = _e1362.y;
                                                } else {
                                                    phi_1993_ = _e1364.y;
                                                }
                                                let _e1378 = phi_1993_;
                                                if (_e1362.z > _e1364.z) {
                                                    phi_2002_ = _e1362.z;
                                                } else {
                                                    phi_2002_ = _e1364.z;
                                                }
                                                let _e1385 = phi_2002_;
                                                let _e1387 = triangles.member[(0u + _e1022)].v2_;
                                                if (_e1371 > _e1387.x) {
                                                    phi_2011_ = _e1371;
                                                } else {
                                                    phi_2011_ = _e1387.x;
                                                }
                                                let _e1392 = phi_2011_;
                                                if (_e1378 > _e1387.y) {
                                                    phi_2018_ = _e1378;
                                                } else {
                                                    phi_2018_ = _e1387.y;
                                                }
                                                let _e1397 = phi_2018_;
                                                if (_e1385 > _e1387.z) {
                                                    phi_2025_ = _e1385;
                                                } else {
                                                    phi_2025_ = _e1387.z;
                                                }
                                                let _e1402 = phi_2025_;
                                                let _e1409 = ((_e1350 - _e156.origin.x) * _e309);
                                                let _e1410 = ((_e1355 - _e156.origin.y) * _e320);
                                                let _e1411 = ((_e1360 - _e156.origin.z) * _e331);
                                                let _e1418 = ((_e1392 - _e156.origin.x) * _e309);
                                                let _e1419 = ((_e1397 - _e156.origin.y) * _e320);
                                                let _e1420 = ((_e1402 - _e156.origin.z) * _e331);
                                                if (_e1409 < _e1418) {
                                                    phi_2048_ = _e1409;
                                                } else {
                                                    phi_2048_ = _e1418;
                                                }
                                                let _e1423 = phi_2048_;
                                                if (_e1410 < _e1419) {
                                                    phi_2053_ = _e1410;
                                                } else {
                                                    phi_2053_ = _e1419;
                                                }
                                                let _e1426 = phi_2053_;
                                                if (_e1411 < _e1420) {
                                                    phi_2058_ = _e1411;
                                                } else {
                                                    phi_2058_ = _e1420;
                                                }
                                                let _e1429 = phi_2058_;
                                                if (_e1409 > _e1418) {
                                                    phi_2066_ = _e1409;
                                                } else {
                                                    phi_2066_ = _e1418;
                                                }
                                                let _e1435 = phi_2066_;
                                                if (_e1410 > _e1419) {
                                                    phi_2071_ = _e1410;
                                                } else {
                                                    phi_2071_ = _e1419;
                                                }
                                                let _e1438 = phi_2071_;
                                                if (_e1411 > _e1420) {
                                                    phi_2076_ = _e1411;
                                                } else {
                                                    phi_2076_ = _e1420;
                                                }
                                                let _e1441 = phi_2076_;
                                                let _e1445 = core_intrinsics_maximum_number_nsz_f32_((_e1423 - _e375), (_e1426 - _e376));
                                                let _e1446 = core_intrinsics_maximum_number_nsz_f32_(_e1445, (_e1429 - _e377));
                                                let _e1447 = core_intrinsics_minimum_number_nsz_f32_((_e1435 + _e375), (_e1438 + _e376));
                                                let _e1448 = core_intrinsics_minimum_number_nsz_f32_(_e1447, (_e1441 + _e377));
                                                if (_e1446 > -300000000000000000000000000000000000000f) {
                                                    phi_2088_ = _e1446;
                                                } else {
                                                    phi_2088_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1451 = phi_2088_;
                                                if (_e1448 < 300000000000000000000000000000000000000f) {
                                                    phi_2093_ = _e1448;
                                                } else {
                                                    phi_2093_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1454 = phi_2093_;
                                                if (_e1314 < _e1451) {
                                                    phi_2098_ = _e1451;
                                                } else {
                                                    phi_2098_ = _e1314;
                                                }
                                                let _e1457 = phi_2098_;
                                                if (_e1457 > _e1454) {
                                                    phi_2103_ = _e1454;
                                                } else {
                                                    phi_2103_ = _e1457;
                                                }
                                                let _e1460 = phi_2103_;
                                                phi_2108_ = lt_bvh_triangle_Intersection(_e1460, (_e1153 / _e1212), (_e1174 / _e1212), (_e1451 <= _e1454));
                                                phi_2109_ = false;
                                            } else {
                                                phi_2108_ = lt_bvh_triangle_Intersection();
                                                phi_2109_ = true;
                                            }
                                            let _e1466 = phi_2108_;
                                            let _e1468 = phi_2109_;
                                            phi_2110_ = _e1466;
                                            phi_2111_ = _e1468;
                                        } else {
                                            phi_2110_ = lt_bvh_triangle_Intersection();
                                            phi_2111_ = true;
                                        }
                                        let _e1470 = phi_2110_;
                                        let _e1472 = phi_2111_;
                                        if _e1472 {
                                        }
                                        phi_2115_ = _e1470;
                                        phi_2116_ = _e1472;
                                    }
                                    let _e1474 = phi_2115_;
                                    let _e1476 = phi_2116_;
                                    phi_2117_ = _e1474;
                                    phi_2118_ = _e1215;
                                    phi_2119_ = _e1476;
                                } else {
                                    phi_2117_ = lt_bvh_triangle_Intersection();
                                    phi_2118_ = true;
                                    phi_2119_ = false;
                                }
                                let _e1478 = phi_2117_;
                                let _e1480 = phi_2118_;
                                let _e1482 = phi_2119_;
                                if _e1480 {
                                    phi_2123_ = true;
                                } else {
                                    phi_2123_ = _e1482;
                                }
                                let _e1484 = phi_2123_;
                                if _e1484 {
                                    phi_2127_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_2127_ = _e1478;
                                }
                                let _e1486 = phi_2127_;
                                if _e1486.is_hit {
                                    if (_e1486.t > _e156.tmin) {
                                        if (_e1486.t < _e1011.t) {
                                            phi_2176_ = true;
                                        } else {
                                            if (_e1486.t == _e1011.t) {
                                                if (_e1011.triangle != 4294967295u) {
                                                    if (_e1022 < _e1011.triangle) {
                                                        phi_2167_ = true;
                                                    } else {
                                                        if (_e1022 == _e1011.triangle) {
                                                            phi_2166_ = (4294967295u < _e1011.instance);
                                                        } else {
                                                            phi_2166_ = false;
                                                        }
                                                        let _e1505 = phi_2166_;
                                                        phi_2167_ = _e1505;
                                                    }
                                                    let _e1507 = phi_2167_;
                                                    phi_2168_ = _e1507;
                                                    phi_2169_ = false;
                                                } else {
                                                    phi_2168_ = bool();
                                                    phi_2169_ = true;
                                                }
                                                let _e1509 = phi_2168_;
                                                let _e1511 = phi_2169_;
                                                phi_2170_ = _e1509;
                                                phi_2171_ = _e1511;
                                            } else {
                                                phi_2170_ = bool();
                                                phi_2171_ = true;
                                            }
                                            let _e1513 = phi_2170_;
                                            let _e1515 = phi_2171_;
                                            if _e1515 {
                                                phi_2175_ = false;
                                            } else {
                                                phi_2175_ = _e1513;
                                            }
                                            let _e1517 = phi_2175_;
                                            phi_2176_ = _e1517;
                                        }
                                        let _e1519 = phi_2176_;
                                        if _e1519 {
                                            let _e1521 = triangles.member[(0u + _e1022)].i0_;
                                            if ((_e1521 & 2147483648u) == 0u) {
                                                phi_2387_ = true;
                                            } else {
                                                if (_e1022 < _e80) {
                                                } else {
                                                    return;
                                                }
                                                let _e1530 = triangles.member[(0u + _e1022)].i0_;
                                                let _e1531 = (_e1530 & 2147483647u);
                                                let _e1533 = triangles.member[(0u + _e1022)].i1_;
                                                let _e1535 = triangles.member[(0u + _e1022)].i2_;
                                                if (_e1531 < _e83) {
                                                } else {
                                                    return;
                                                }
                                                let _e1539 = vertices.member[(0u + _e1531)];
                                                if (_e1533 < _e83) {
                                                } else {
                                                    return;
                                                }
                                                let _e1543 = vertices.member[(0u + _e1533)];
                                                if (_e1535 < _e83) {
                                                } else {
                                                    return;
                                                }
                                                let _e1547 = vertices.member[(0u + _e1535)];
                                                let _e1548 = array<abi_Vertex, 3>(_e1539, _e1543, _e1547);
                                                if (_e1548[0].material < _e86) {
                                                } else {
                                                    return;
                                                }
                                                let _e1554 = materials.member[(0u + _e1548[0].material)];
                                                if ((_e1554.flags & 0u) == 0u) {
                                                    let _e1559 = ((1f - _e1486.u) - _e1486.v);
                                                    if (_e1554.cutoff <= 0f) {
                                                        phi_2382_ = true;
                                                    } else {
                                                        let _e1586 = (_e1554.base_color.w * ((((f32((_e1548[0].color >> bitcast<u32>(24i))) * _e1559) + (f32((_e1548[1].color >> bitcast<u32>(24i))) * _e1486.u)) + (f32((_e1548[2].color >> bitcast<u32>(24i))) * _e1486.v)) * (1f / 255f)));
                                                        if (_e1554.alpha_size == 0u) {
                                                            phi_2379_ = _e1586;
                                                        } else {
                                                            local_1.offset = _e1554.alpha_offset;
                                                            local_1.size = _e1554.alpha_size;
                                                            local_1.flags = _e1554.flags;
                                                            let _e1617 = _lt_shaders_texture_TextureView_quad((&local_1), (((_e1548[0].u * _e1559) + (_e1548[1].u * _e1486.u)) + (_e1548[2].u * _e1486.v)), (((_e1548[0].v * _e1559) + (_e1548[1].v * _e1486.u)) + (_e1548[2].v * _e1486.v)));
                                                            let _e1621 = (_e1617.indices[0] >> bitcast<u32>(2i));
                                                            if (_e1621 < _e92) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1625 = alpha_texels.member[(0u + _e1621)];
                                                            let _e1641 = (_e1617.indices[1] >> bitcast<u32>(2i));
                                                            if (_e1641 < _e92) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1645 = alpha_texels.member[(0u + _e1641)];
                                                            let _e1662 = (_e1617.indices[2] >> bitcast<u32>(2i));
                                                            if (_e1662 < _e92) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1666 = alpha_texels.member[(0u + _e1662)];
                                                            let _e1683 = (_e1617.indices[3] >> bitcast<u32>(2i));
                                                            if (_e1683 < _e92) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1687 = alpha_texels.member[(0u + _e1683)];
                                                            phi_2379_ = (_e1586 * (((((f32(((_e1625 >> bitcast<u32>((((_e1617.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1617.weights.x) + ((f32(((_e1645 >> bitcast<u32>((((_e1617.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1617.weights.y)) + ((f32(((_e1666 >> bitcast<u32>((((_e1617.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1617.weights.z)) + ((f32(((_e1687 >> bitcast<u32>((((_e1617.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1617.weights.w)));
                                                        }
                                                        let _e1703 = phi_2379_;
                                                        phi_2382_ = (_e1703 >= _e1554.cutoff);
                                                    }
                                                    let _e1707 = phi_2382_;
                                                    phi_2383_ = _e1707;
                                                } else {
                                                    phi_2383_ = false;
                                                }
                                                let _e1709 = phi_2383_;
                                                if _e1709 {
                                                }
                                                phi_2387_ = _e1709;
                                            }
                                            let _e1711 = phi_2387_;
                                            if _e1711 {
                                                phi_2395_ = lt_bvh_Hit(_e1486.t, _e1486.u, _e1486.v, _e1022, 4294967295u);
                                            } else {
                                                phi_2395_ = _e1011;
                                            }
                                            let _e1717 = phi_2395_;
                                            phi_2396_ = _e1717;
                                        } else {
                                            phi_2396_ = _e1011;
                                        }
                                        let _e1719 = phi_2396_;
                                        phi_2397_ = _e1719;
                                    } else {
                                        phi_2397_ = _e1011;
                                    }
                                    let _e1721 = phi_2397_;
                                    phi_2398_ = _e1721;
                                } else {
                                    phi_2398_ = _e1011;
                                }
                                let _e1723 = phi_2398_;
                                phi_1541_ = _e1723;
                                phi_1544_ = (_e1013 & (_e1013 - 1u));
                                phi_2399_ = true;
                            }
                            let _e1725 = phi_1541_;
                            let _e1727 = phi_1544_;
                            let _e1729 = phi_2399_;
                            continue;
                            continuing {
                                phi_1540_ = _e1725;
                                phi_1543_ = _e1727;
                                break if !(_e1729);
                            }
                        }
                        let _e1732 = local_2.group_mask;
                        if ((_e1732 & 4278190080u) == 0u) {
                            let _e1736 = local_2.len;
                            if (_e1736 == 0u) {
                                phi_2438_ = false;
                            } else {
                                let _e1740 = local_2.len;
                                local_2.len = (_e1740 - 1u);
                                let _e1743 = local_2.len;
                                if (_e1743 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1748 = local_2.first[(0u + _e1743)];
                                local_2.group = _e1748;
                                let _e1751 = local_2.len;
                                if (_e1751 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1756 = local_2.mask[(0u + _e1751)];
                                local_2.group_mask = _e1756;
                                phi_2438_ = true;
                            }
                            let _e1759 = phi_2438_;
                            phi_2439_ = _e1759;
                        } else {
                            phi_2439_ = true;
                        }
                        let _e1761 = phi_2439_;
                        if _e1761 {
                            let _e1763 = local_2.group_mask;
                            let _e1769 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1763)), 32u, (_e1763 == 0u)));
                            let _e1773 = local_2.group_mask;
                            let _e1787 = local_2.group_mask;
                            local_2.group_mask = (_e1787 & ~((1u << bitcast<u32>((_e1769 & 31u)))));
                            let _e1790 = local_2.group;
                            phi_2470_ = (_e1790 + countOneBits(((_e1773 & ~((4294967295u << bitcast<u32>((((_e1769 - 24u) ^ _e430) & 31u))))) & 255u)));
                        } else {
                            phi_2470_ = 4294967295u;
                        }
                        let _e1793 = phi_2470_;
                        let _e2640 = local_6;
                        phi_1204_ = _e2640;
                        phi_1207_ = _e1793;
                    } else {
                        phi_1204_ = lt_bvh_Hit();
                        phi_1207_ = u32();
                    }
                    let _e1795 = phi_1204_;
                    let _e1797 = phi_1207_;
                    continue;
                    continuing {
                        phi_1203_ = _e1795;
                        phi_1206_ = _e1797;
                        break if !(_e571);
                    }
                }
                let _e2644 = local_7;
                phi_2471_ = _e2644;
            }
            let _e1800 = phi_2471_;
            phi_2472_ = _e1800;
            phi_2473_ = _e228;
        } else {
            phi_2472_ = lt_bvh_Hit();
            phi_2473_ = true;
        }
        let _e1802 = phi_2472_;
        let _e1804 = phi_2473_;
        if _e1804 {
            phi_2477_ = _e158;
        } else {
            phi_2477_ = _e1802;
        }
        let _e1806 = phi_2477_;
        if (_e1806.triangle != 4294967295u) {
            let _e1812 = ((1f - _e1806.u) - _e1806.v);
            if (_e1806.triangle < _e80) {
            } else {
                return;
            }
            let _e1817 = triangles.member[(0u + _e1806.triangle)];
            let _e1842 = (((_e1817.v0_.x * _e1812) + (_e1817.v1_.x * _e1806.u)) + (_e1817.v2_.x * _e1806.v));
            let _e1843 = (((_e1817.v0_.y * _e1812) + (_e1817.v1_.y * _e1806.u)) + (_e1817.v2_.y * _e1806.v));
            let _e1844 = (((_e1817.v0_.z * _e1812) + (_e1817.v1_.z * _e1806.u)) + (_e1817.v2_.z * _e1806.v));
            let _e1847 = abs(_e1817.v0_.x);
            let _e1849 = abs(_e1817.v0_.y);
            let _e1851 = abs(_e1817.v0_.z);
            let _e1853 = abs(_e1817.v1_.x);
            let _e1855 = abs(_e1817.v1_.y);
            let _e1857 = abs(_e1817.v1_.z);
            if (_e1847 > _e1853) {
                phi_2541_ = _e1847;
            } else {
                phi_2541_ = _e1853;
            }
            let _e1860 = phi_2541_;
            if (_e1849 > _e1855) {
                phi_2546_ = _e1849;
            } else {
                phi_2546_ = _e1855;
            }
            let _e1863 = phi_2546_;
            if (_e1851 > _e1857) {
                phi_2551_ = _e1851;
            } else {
                phi_2551_ = _e1857;
            }
            let _e1866 = phi_2551_;
            let _e1868 = abs(_e1817.v2_.x);
            let _e1870 = abs(_e1817.v2_.y);
            let _e1872 = abs(_e1817.v2_.z);
            if (_e1860 > _e1868) {
                phi_2562_ = _e1860;
            } else {
                phi_2562_ = _e1868;
            }
            let _e1875 = phi_2562_;
            if (_e1863 > _e1870) {
                phi_2567_ = _e1863;
            } else {
                phi_2567_ = _e1870;
            }
            let _e1878 = phi_2567_;
            if (_e1866 > _e1872) {
                phi_2572_ = _e1866;
            } else {
                phi_2572_ = _e1872;
            }
            let _e1881 = phi_2572_;
            let _e1884 = (_e1817.v1_.x - _e1817.v0_.x);
            let _e1887 = (_e1817.v1_.y - _e1817.v0_.y);
            let _e1890 = (_e1817.v1_.z - _e1817.v0_.z);
            let _e1893 = (_e1817.v2_.x - _e1817.v0_.x);
            let _e1896 = (_e1817.v2_.y - _e1817.v0_.y);
            let _e1899 = (_e1817.v2_.z - _e1817.v0_.z);
            let _e1903 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1887), abs(_e1890));
            let _e1904 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1884), _e1903);
            let _e1905 = (_e1884 / _e1904);
            let _e1906 = (_e1887 / _e1904);
            let _e1907 = (_e1890 / _e1904);
            let _e1911 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1896), abs(_e1899));
            let _e1912 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1893), _e1911);
            let _e1913 = (_e1893 / _e1912);
            let _e1914 = (_e1896 / _e1912);
            let _e1915 = (_e1899 / _e1912);
            let _e1918 = ((_e1906 * _e1915) - (_e1914 * _e1907));
            let _e1921 = ((_e1907 * _e1913) - (_e1915 * _e1905));
            let _e1924 = ((_e1905 * _e1914) - (_e1913 * _e1906));
            let _e1926 = p.member.eye;
            let _e1939 = (1f / sqrt((((_e1918 * _e1918) + (_e1921 * _e1921)) + (_e1924 * _e1924))));
            let _e1940 = (_e1918 * _e1939);
            let _e1941 = (_e1921 * _e1939);
            let _e1942 = (_e1924 * _e1939);
            if ((((_e1940 * (_e1926.x - _e1842)) + (_e1941 * (_e1926.y - _e1843))) + (_e1942 * (_e1926.z - _e1844))) < 0f) {
                phi_2648_ = vec3<f32>(-(_e1940), -(_e1941), -(_e1942));
            } else {
                phi_2648_ = vec3<f32>(_e1940, _e1941, _e1942);
            }
            let _e1955 = phi_2648_;
            if (_e1806.triangle < _e80) {
            } else {
                return;
            }
            let _e1960 = triangles.member[(0u + _e1806.triangle)];
            let _e1962 = (_e1960.i0_ & 2147483647u);
            if (_e1962 < _e83) {
            } else {
                return;
            }
            let _e1968 = vertices.member[(0u + _e1962)];
            if (_e1960.i1_ < _e83) {
            } else {
                return;
            }
            let _e1972 = vertices.member[(0u + _e1960.i1_)];
            if (_e1960.i2_ < _e83) {
            } else {
                return;
            }
            let _e1976 = vertices.member[(0u + _e1960.i2_)];
            let _e1977 = array<abi_Vertex, 3>(_e1968, _e1972, _e1976);
            if (_e1977[0].material < _e86) {
            } else {
                return;
            }
            let _e1983 = materials.member[(0u + _e1977[0].material)];
            let _e2000 = (1f / 255f);
            let _e2019 = (1f / 255f);
            let _e2041 = (1f / 255f);
            if (_e1983.color_size == 0u) {
                phi_2891_ = vec3<f32>(1f, 1f, 1f);
            } else {
                local.offset = _e1983.color_offset;
                local.size = _e1983.color_size;
                local.flags = _e1983.flags;
                let _e2084 = _lt_shaders_texture_TextureView_quad((&local), (((_e1977[0].u * _e1812) + (_e1977[1].u * _e1806.u)) + (_e1977[2].u * _e1806.v)), (((_e1977[0].v * _e1812) + (_e1977[1].v * _e1806.u)) + (_e1977[2].v * _e1806.v)));
                if (_e2084.indices[0] < _e95) {
                } else {
                    return;
                }
                let _e2090 = color_texels.member[(0u + _e2084.indices[0])];
                let _e2101 = (1f / 255f);
                if (_e2084.indices[1] < _e95) {
                } else {
                    return;
                }
                let _e2115 = color_texels.member[(0u + _e2084.indices[1])];
                let _e2126 = (1f / 255f);
                if (_e2084.indices[2] < _e95) {
                } else {
                    return;
                }
                let _e2143 = color_texels.member[(0u + _e2084.indices[2])];
                let _e2154 = (1f / 255f);
                if (_e2084.indices[3] < _e95) {
                } else {
                    return;
                }
                let _e2171 = color_texels.member[(0u + _e2084.indices[3])];
                let _e2182 = (1f / 255f);
                let _e2191 = (((((f32((_e2090 & 255u)) * _e2101) * _e2084.weights.x) + ((f32((_e2115 & 255u)) * _e2126) * _e2084.weights.y)) + ((f32((_e2143 & 255u)) * _e2154) * _e2084.weights.z)) + ((f32((_e2171 & 255u)) * _e2182) * _e2084.weights.w));
                let _e2192 = (((((f32(((_e2090 >> bitcast<u32>(8i)) & 255u)) * _e2101) * _e2084.weights.x) + ((f32(((_e2115 >> bitcast<u32>(8i)) & 255u)) * _e2126) * _e2084.weights.y)) + ((f32(((_e2143 >> bitcast<u32>(8i)) & 255u)) * _e2154) * _e2084.weights.z)) + ((f32(((_e2171 >> bitcast<u32>(8i)) & 255u)) * _e2182) * _e2084.weights.w));
                let _e2193 = (((((f32(((_e2090 >> bitcast<u32>(16i)) & 255u)) * _e2101) * _e2084.weights.x) + ((f32(((_e2115 >> bitcast<u32>(16i)) & 255u)) * _e2126) * _e2084.weights.y)) + ((f32(((_e2143 >> bitcast<u32>(16i)) & 255u)) * _e2154) * _e2084.weights.z)) + ((f32(((_e2171 >> bitcast<u32>(16i)) & 255u)) * _e2182) * _e2084.weights.w));
                phi_2891_ = vec3<f32>((_e2191 * _e2191), (_e2192 * _e2192), (_e2193 * _e2193));
            }
            let _e2199 = phi_2891_;
            let _e2201 = ((_e1983.base_color.x * ((((f32((_e1977[0].color & 255u)) * _e2000) * _e1812) + ((f32((_e1977[1].color & 255u)) * _e2019) * _e1806.u)) + ((f32((_e1977[2].color & 255u)) * _e2041) * _e1806.v))) * _e2199.x);
            let _e2203 = ((_e1983.base_color.y * ((((f32(((_e1977[0].color >> bitcast<u32>(8i)) & 255u)) * _e2000) * _e1812) + ((f32(((_e1977[1].color >> bitcast<u32>(8i)) & 255u)) * _e2019) * _e1806.u)) + ((f32(((_e1977[2].color >> bitcast<u32>(8i)) & 255u)) * _e2041) * _e1806.v))) * _e2199.y);
            let _e2205 = ((_e1983.base_color.z * ((((f32(((_e1977[0].color >> bitcast<u32>(16i)) & 255u)) * _e2000) * _e1812) + ((f32(((_e1977[1].color >> bitcast<u32>(16i)) & 255u)) * _e2019) * _e1806.u)) + ((f32(((_e1977[2].color >> bitcast<u32>(16i)) & 255u)) * _e2041) * _e1806.v))) * _e2199.z);
            let _e2206 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1878, _e1881);
            let _e2207 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1875, _e2206);
            if ((_e1983.flags & 2u) == 0u) {
                phi_2906_ = 0u;
            } else {
                phi_2906_ = 1u;
            }
            let _e2212 = phi_2906_;
            if (_e1977[0].normal == 2147516416u) {
                phi_3109_ = _e1955;
            } else {
                let _e2225 = (f32((bitcast<i32>((_e1977[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2231 = (f32((bitcast<i32>(_e1977[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2235 = ((1f - abs(_e2225)) - abs(_e2231));
                if (_e2235 < 0f) {
                    phi_2933_ = -(_e2235);
                } else {
                    phi_2933_ = 0f;
                }
                let _e2239 = phi_2933_;
                if (_e2225 < 0f) {
                    phi_2940_ = (_e2225 + _e2239);
                } else {
                    phi_2940_ = (_e2225 - _e2239);
                }
                let _e2244 = phi_2940_;
                if (_e2231 < 0f) {
                    phi_2947_ = (_e2231 + _e2239);
                } else {
                    phi_2947_ = (_e2231 - _e2239);
                }
                let _e2249 = phi_2947_;
                let _e2256 = (1f / sqrt((((_e2244 * _e2244) + (_e2249 * _e2249)) + (_e2235 * _e2235))));
                let _e2272 = (f32((bitcast<i32>((_e1977[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2278 = (f32((bitcast<i32>(_e1977[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2282 = ((1f - abs(_e2272)) - abs(_e2278));
                if (_e2282 < 0f) {
                    phi_2982_ = -(_e2282);
                } else {
                    phi_2982_ = 0f;
                }
                let _e2286 = phi_2982_;
                if (_e2272 < 0f) {
                    phi_2989_ = (_e2272 + _e2286);
                } else {
                    phi_2989_ = (_e2272 - _e2286);
                }
                let _e2291 = phi_2989_;
                if (_e2278 < 0f) {
                    phi_2996_ = (_e2278 + _e2286);
                } else {
                    phi_2996_ = (_e2278 - _e2286);
                }
                let _e2296 = phi_2996_;
                let _e2303 = (1f / sqrt((((_e2291 * _e2291) + (_e2296 * _e2296)) + (_e2282 * _e2282))));
                let _e2322 = (f32((bitcast<i32>((_e1977[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2328 = (f32((bitcast<i32>(_e1977[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2332 = ((1f - abs(_e2322)) - abs(_e2328));
                if (_e2332 < 0f) {
                    phi_3034_ = -(_e2332);
                } else {
                    phi_3034_ = 0f;
                }
                let _e2336 = phi_3034_;
                if (_e2322 < 0f) {
                    phi_3041_ = (_e2322 + _e2336);
                } else {
                    phi_3041_ = (_e2322 - _e2336);
                }
                let _e2341 = phi_3041_;
                if (_e2328 < 0f) {
                    phi_3048_ = (_e2328 + _e2336);
                } else {
                    phi_3048_ = (_e2328 - _e2336);
                }
                let _e2346 = phi_3048_;
                let _e2353 = (1f / sqrt((((_e2341 * _e2341) + (_e2346 * _e2346)) + (_e2332 * _e2332))));
                let _e2364 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(vec3<f32>(((((_e2244 * _e2256) * _e1812) + ((_e2291 * _e2303) * _e1806.u)) + ((_e2341 * _e2353) * _e1806.v)), ((((_e2249 * _e2256) * _e1812) + ((_e2296 * _e2303) * _e1806.u)) + ((_e2346 * _e2353) * _e1806.v)), ((((_e2235 * _e2256) * _e1812) + ((_e2282 * _e2303) * _e1806.u)) + ((_e2332 * _e2353) * _e1806.v))));
                let _e2376 = sqrt((((_e2364.x * _e2364.x) + (_e2364.y * _e2364.y)) + (_e2364.z * _e2364.z)));
                if (_e2376 > 0f) {
                    let _e2379 = (_e2364.x / _e2376);
                    let _e2381 = (_e2364.y / _e2376);
                    let _e2383 = (_e2364.z / _e2376);
                    if ((((_e2379 * _e1955.x) + (_e2381 * _e1955.y)) + (_e2383 * _e1955.z)) < 0f) {
                        phi_3107_ = vec3<f32>(-(_e2379), -(_e2381), -(_e2383));
                    } else {
                        phi_3107_ = (_e2364 / vec3(_e2376));
                    }
                    let _e2400 = phi_3107_;
                    phi_3108_ = _e2400;
                } else {
                    phi_3108_ = _e1955;
                }
                let _e2402 = phi_3108_;
                phi_3109_ = _e2402;
            }
            let _e2404 = phi_3109_;
            if (_e2201 > 0f) {
                if (_e2201 < 1f) {
                    phi_3118_ = _e2201;
                } else {
                    phi_3118_ = 1f;
                }
                let _e2408 = phi_3118_;
                phi_3119_ = _e2408;
            } else {
                phi_3119_ = 0f;
            }
            let _e2410 = phi_3119_;
            if (_e2203 > 0f) {
                if (_e2203 < 1f) {
                    phi_3129_ = _e2203;
                } else {
                    phi_3129_ = 1f;
                }
                let _e2415 = phi_3129_;
                phi_3130_ = _e2415;
            } else {
                phi_3130_ = 0f;
            }
            let _e2417 = phi_3130_;
            if (_e2205 > 0f) {
                if (_e2205 < 1f) {
                    phi_3140_ = _e2205;
                } else {
                    phi_3140_ = 1f;
                }
                let _e2422 = phi_3140_;
                phi_3141_ = _e2422;
            } else {
                phi_3141_ = 0f;
            }
            let _e2424 = phi_3141_;
            let _e2427 = ((sqrt(_e2410) * 255f) + 0.5f);
            let _e2436 = ((sqrt(_e2417) * 255f) + 0.5f);
            let _e2448 = ((sqrt(_e2424) * 255f) + 0.5f);
            phi_3176_ = abi_Sample(vec3<f32>(_e1842, _e1843, _e1844), _e2207, _e1955, _e2212, _e2404, ((select(select(u32(_e2427), 0u, (_e2427 < bitcast<f32>(0u))), 4294967295u, (_e2427 > bitcast<f32>(1333788671u))) | (select(select(u32(_e2436), 0u, (_e2436 < bitcast<f32>(0u))), 4294967295u, (_e2436 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e2448), 0u, (_e2448 < bitcast<f32>(0u))), 4294967295u, (_e2448 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_3176_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e2462 = phi_3176_;
        if (_e101.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e101.shift)] = _e2462;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_alpha_color_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
