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
                let _e305 = phi_897_;
                if (_e156.direction.x < 0f) {
                    phi_904_ = (-1f / _e305);
                } else {
                    phi_904_ = (1f / _e305);
                }
                let _e310 = phi_904_;
                if (abs(_e156.direction.y) < _e298) {
                    phi_912_ = _e298;
                } else {
                    phi_912_ = abs(_e156.direction.y);
                }
                let _e317 = phi_912_;
                if (_e156.direction.y < 0f) {
                    phi_919_ = (-1f / _e317);
                } else {
                    phi_919_ = (1f / _e317);
                }
                let _e322 = phi_919_;
                if (abs(_e156.direction.z) < _e298) {
                    phi_927_ = _e298;
                } else {
                    phi_927_ = abs(_e156.direction.z);
                }
                let _e329 = phi_927_;
                if (_e156.direction.z < 0f) {
                    phi_934_ = (-1f / _e329);
                } else {
                    phi_934_ = (1f / _e329);
                }
                let _e334 = phi_934_;
                let _e342 = abs((bitcast<f32>(_e234) - _e156.origin.x));
                let _e343 = abs((bitcast<f32>(_e238) - _e156.origin.y));
                let _e344 = abs((bitcast<f32>(_e242) - _e156.origin.z));
                let _e352 = abs(((bitcast<f32>(_e246) + (bitcast<f32>((((_e258 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e156.origin.x));
                let _e353 = abs(((bitcast<f32>(_e250) + (bitcast<f32>((((_e258 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e156.origin.y));
                let _e354 = abs(((bitcast<f32>(_e254) + (bitcast<f32>((((_e258 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e156.origin.z));
                if (_e342 > _e352) {
                    phi_959_ = _e342;
                } else {
                    phi_959_ = _e352;
                }
                let _e357 = phi_959_;
                if (_e343 > _e353) {
                    phi_964_ = _e343;
                } else {
                    phi_964_ = _e353;
                }
                let _e360 = phi_964_;
                if (_e344 > _e354) {
                    phi_969_ = _e344;
                } else {
                    phi_969_ = _e354;
                }
                let _e363 = phi_969_;
                let _e364 = core_intrinsics_maximum_number_nsz_f32_(_e357, _e360);
                let _e365 = core_intrinsics_maximum_number_nsz_f32_(_e364, _e363);
                let _e370 = (_e365 * 0.0000019073486f);
                let _e371 = (abs(_e310) * _e370);
                let _e372 = (abs(_e322) * _e370);
                let _e373 = (abs(_e334) * _e370);
                let _e377 = (_e365 * 0.0000009536743f);
                let _e378 = (abs(_e310) * _e377);
                let _e379 = (abs(_e322) * _e377);
                let _e380 = (abs(_e334) * _e377);
                let _e383 = abs(_e156.direction.x);
                let _e385 = abs(_e156.direction.y);
                let _e387 = abs(_e156.direction.z);
                if (_e383 >= _e385) {
                    if (_e383 >= _e387) {
                        phi_1002_ = false;
                    } else {
                        phi_1002_ = true;
                    }
                    let _e391 = phi_1002_;
                    phi_1003_ = _e391;
                } else {
                    phi_1003_ = true;
                }
                let _e393 = phi_1003_;
                if _e393 {
                    if (_e385 >= _e387) {
                        phi_1011_ = 1u;
                    } else {
                        phi_1011_ = 2u;
                    }
                    let _e396 = phi_1011_;
                    phi_1012_ = _e396;
                } else {
                    phi_1012_ = 0u;
                }
                let _e398 = phi_1012_;
                if (_e398 == 0u) {
                    phi_1031_ = vec3<f32>(_e156.direction.y, _e156.direction.z, _e156.direction.x);
                } else {
                    if (_e398 == 1u) {
                        phi_1030_ = vec3<f32>(_e156.direction.z, _e156.direction.x, _e156.direction.y);
                    } else {
                        phi_1030_ = _e156.direction;
                    }
                    let _e411 = phi_1030_;
                    phi_1031_ = _e411;
                }
                let _e413 = phi_1031_;
                let _e417 = (_e413.x / _e413.z);
                let _e420 = (_e413.y / _e413.z);
                if (_e310 < 0f) {
                    phi_1045_ = 0u;
                } else {
                    phi_1045_ = 1u;
                }
                let _e425 = phi_1045_;
                if (_e322 < 0f) {
                    phi_1050_ = 0u;
                } else {
                    phi_1050_ = 2u;
                }
                let _e428 = phi_1050_;
                if (_e334 < 0f) {
                    phi_1055_ = 0u;
                } else {
                    phi_1055_ = 4u;
                }
                let _e431 = phi_1055_;
                let _e433 = ((_e425 | _e428) | _e431);
                let _e434 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e434.first[0], _e434.first[1], _e434.first[2], _e434.first[3], _e434.first[4], _e434.first[5], _e434.first[6], _e434.first[7], _e434.first[8], _e434.first[9], _e434.first[10], _e434.first[11], _e434.first[12], _e434.first[13], _e434.first[14], _e434.first[15], _e434.first[16], _e434.first[17], _e434.first[18], _e434.first[19], _e434.first[20], _e434.first[21], _e434.first[22], _e434.first[23], _e434.first[24], _e434.first[25], _e434.first[26], _e434.first[27], _e434.first[28], _e434.first[29], _e434.first[30], _e434.first[31]), array<u32, 32>(_e434.mask[0], _e434.mask[1], _e434.mask[2], _e434.mask[3], _e434.mask[4], _e434.mask[5], _e434.mask[6], _e434.mask[7], _e434.mask[8], _e434.mask[9], _e434.mask[10], _e434.mask[11], _e434.mask[12], _e434.mask[13], _e434.mask[14], _e434.mask[15], _e434.mask[16], _e434.mask[17], _e434.mask[18], _e434.mask[19], _e434.mask[20], _e434.mask[21], _e434.mask[22], _e434.mask[23], _e434.mask[24], _e434.mask[25], _e434.mask[26], _e434.mask[27], _e434.mask[28], _e434.mask[29], _e434.mask[30], _e434.mask[31]), _e434.len, _e434.group, _e434.group_mask);
                let _e508 = local_2.group_mask;
                if ((_e508 & 4278190080u) == 0u) {
                    let _e512 = local_2.len;
                    if (_e512 == 0u) {
                        phi_1169_ = false;
                    } else {
                        let _e516 = local_2.len;
                        local_2.len = (_e516 - 1u);
                        let _e519 = local_2.len;
                        if (_e519 < 32u) {
                        } else {
                            return;
                        }
                        let _e524 = local_2.first[(0u + _e519)];
                        local_2.group = _e524;
                        let _e527 = local_2.len;
                        if (_e527 < 32u) {
                        } else {
                            return;
                        }
                        let _e532 = local_2.mask[(0u + _e527)];
                        local_2.group_mask = _e532;
                        phi_1169_ = true;
                    }
                    let _e535 = phi_1169_;
                    phi_1170_ = _e535;
                } else {
                    phi_1170_ = true;
                }
                let _e537 = phi_1170_;
                if _e537 {
                    let _e539 = local_2.group_mask;
                    let _e545 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e539)), 32u, (_e539 == 0u)));
                    let _e549 = local_2.group_mask;
                    let _e563 = local_2.group_mask;
                    local_2.group_mask = (_e563 & ~((1u << bitcast<u32>((_e545 & 31u)))));
                    let _e566 = local_2.group;
                    phi_1201_ = (_e566 + countOneBits(((_e549 & ~((4294967295u << bitcast<u32>((((_e545 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1201_ = 4294967295u;
                }
                let _e569 = phi_1201_;
                phi_1203_ = _e158;
                phi_1206_ = _e569;
                loop {
                    let _e571 = phi_1203_;
                    let _e573 = phi_1206_;
                    local_7 = _e571;
                    let _e574 = (_e573 != 4294967295u);
                    if _e574 {
                        if (_e573 < _e77) {
                        } else {
                            return;
                        }
                        let _e582 = nodes.member[(0u + _e573)].frame[3u];
                        let _e607 = (bitcast<f32>((((_e582 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e310);
                        let _e608 = (bitcast<f32>((((_e582 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e322);
                        let _e609 = (bitcast<f32>((((_e582 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e334);
                        let _e612 = nodes.member[(0u + _e573)].frame[0u];
                        let _e616 = nodes.member[(0u + _e573)].frame[1u];
                        let _e620 = nodes.member[(0u + _e573)].frame[2u];
                        let _e628 = ((bitcast<f32>(_e612) - _e156.origin.x) * _e310);
                        let _e629 = ((bitcast<f32>(_e616) - _e156.origin.y) * _e322);
                        let _e630 = ((bitcast<f32>(_e620) - _e156.origin.z) * _e334);
                        let _e638 = nodes.member[(0u + _e573)].x;
                        if (_e310 < 0f) {
                            let _e649 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e638.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e655 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e649.unnamed.word, _e638.w), _e649.unnamed_1);
                            let _e661 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e655.unnamed, lt_mask_LightPlace(_e638.x, _e655.unnamed_1.shift));
                            phi_1291_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e661.unnamed, lt_mask_LightPlace(_e661.unnamed_1.word, _e638.y));
                        } else {
                            let _e677 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e638.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e683 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e677.unnamed.word, _e638.y), _e677.unnamed_1);
                            let _e689 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e683.unnamed, lt_mask_LightPlace(_e638.z, _e683.unnamed_1.shift));
                            phi_1291_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e689.unnamed, lt_mask_LightPlace(_e689.unnamed_1.word, _e638.w));
                        }
                        let _e697 = phi_1291_;
                        let _e707 = nodes.member[(0u + _e573)].y;
                        if (_e322 < 0f) {
                            let _e718 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e707.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e724 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e718.unnamed.word, _e707.w), _e718.unnamed_1);
                            let _e730 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e724.unnamed, lt_mask_LightPlace(_e707.x, _e724.unnamed_1.shift));
                            phi_1318_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e730.unnamed, lt_mask_LightPlace(_e730.unnamed_1.word, _e707.y));
                        } else {
                            let _e746 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e707.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e752 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e746.unnamed.word, _e707.y), _e746.unnamed_1);
                            let _e758 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e752.unnamed, lt_mask_LightPlace(_e707.z, _e752.unnamed_1.shift));
                            phi_1318_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e758.unnamed, lt_mask_LightPlace(_e758.unnamed_1.word, _e707.w));
                        }
                        let _e766 = phi_1318_;
                        let _e776 = nodes.member[(0u + _e573)].z;
                        if (_e334 < 0f) {
                            let _e787 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e776.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e793 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e787.unnamed.word, _e776.w), _e787.unnamed_1);
                            let _e799 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e793.unnamed, lt_mask_LightPlace(_e776.x, _e793.unnamed_1.shift));
                            phi_1345_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e799.unnamed, lt_mask_LightPlace(_e799.unnamed_1.word, _e776.y));
                        } else {
                            let _e815 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e776.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e821 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e815.unnamed.word, _e776.y), _e815.unnamed_1);
                            let _e827 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e821.unnamed, lt_mask_LightPlace(_e776.z, _e821.unnamed_1.shift));
                            phi_1345_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e827.unnamed, lt_mask_LightPlace(_e827.unnamed_1.word, _e776.w));
                        }
                        let _e835 = phi_1345_;
                        phi_1351_ = 0u;
                        phi_1354_ = 0u;
                        loop {
                            let _e845 = phi_1351_;
                            let _e847 = phi_1354_;
                            local_3 = _e847;
                            local_4 = _e847;
                            local_5 = _e847;
                            let _e848 = (_e845 < 8u);
                            if _e848 {
                                let _e850 = (_e845 >> bitcast<u32>(2i));
                                let _e851 = (_e845 & 3u);
                                if (_e850 == 0u) {
                                    phi_1368_ = _e697.unnamed.word;
                                } else {
                                    phi_1368_ = _e697.unnamed.shift;
                                }
                                let _e854 = phi_1368_;
                                if (_e850 == 0u) {
                                    phi_1378_ = _e766.unnamed.word;
                                } else {
                                    phi_1378_ = _e766.unnamed.shift;
                                }
                                let _e863 = phi_1378_;
                                if (_e850 == 0u) {
                                    phi_1388_ = _e835.unnamed.word;
                                } else {
                                    phi_1388_ = _e835.unnamed.shift;
                                }
                                let _e872 = phi_1388_;
                                let _e885 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e854 >> bitcast<u32>(((_e851 * 8u) & 31u))) & 255u)) * _e607) + (_e628 - _e371)), ((f32(((_e863 >> bitcast<u32>(((_e851 * 8u) & 31u))) & 255u)) * _e608) + (_e629 - _e372)));
                                let _e886 = core_intrinsics_maximum_number_nsz_f32_(_e885, ((f32(((_e872 >> bitcast<u32>(((_e851 * 8u) & 31u))) & 255u)) * _e609) + (_e630 - _e373)));
                                if (_e850 == 0u) {
                                    phi_1406_ = _e697.unnamed_1.word;
                                } else {
                                    phi_1406_ = _e697.unnamed_1.shift;
                                }
                                let _e889 = phi_1406_;
                                if (_e850 == 0u) {
                                    phi_1416_ = _e766.unnamed_1.word;
                                } else {
                                    phi_1416_ = _e766.unnamed_1.shift;
                                }
                                let _e898 = phi_1416_;
                                if (_e850 == 0u) {
                                    phi_1426_ = _e835.unnamed_1.word;
                                } else {
                                    phi_1426_ = _e835.unnamed_1.shift;
                                }
                                let _e907 = phi_1426_;
                                let _e920 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e889 >> bitcast<u32>(((_e851 * 8u) & 31u))) & 255u)) * _e607) + (_e628 + _e371)), ((f32(((_e898 >> bitcast<u32>(((_e851 * 8u) & 31u))) & 255u)) * _e608) + (_e629 + _e372)));
                                let _e921 = core_intrinsics_minimum_number_nsz_f32_(_e920, ((f32(((_e907 >> bitcast<u32>(((_e851 * 8u) & 31u))) & 255u)) * _e609) + (_e630 + _e373)));
                                if (_e886 <= _e921) {
                                    if (_e886 <= _e571.t) {
                                        if (_e921 >= _e156.tmin) {
                                            if (_e850 == 0u) {
                                                let _e928 = nodes.member[(0u + _e573)].links[2u];
                                                phi_1462_ = _e928;
                                            } else {
                                                let _e931 = nodes.member[(0u + _e573)].links[3u];
                                                phi_1462_ = _e931;
                                            }
                                            let _e933 = phi_1462_;
                                            let _e938 = ((_e933 >> bitcast<u32>(((_e851 * 8u) & 31u))) & 255u);
                                            let _e939 = (_e938 & 31u);
                                            if (_e939 >= 24u) {
                                                phi_1475_ = (24u + ((_e939 - 24u) ^ _e433));
                                            } else {
                                                phi_1475_ = _e939;
                                            }
                                            let _e945 = phi_1475_;
                                            phi_1480_ = (_e847 | ((_e938 >> bitcast<u32>(5i)) << bitcast<u32>((_e945 & 31u))));
                                        } else {
                                            phi_1480_ = _e847;
                                        }
                                        let _e953 = phi_1480_;
                                        phi_1481_ = _e953;
                                    } else {
                                        phi_1481_ = _e847;
                                    }
                                    let _e955 = phi_1481_;
                                    phi_1482_ = _e955;
                                } else {
                                    phi_1482_ = _e847;
                                }
                                let _e957 = phi_1482_;
                                phi_1352_ = (_e845 + 1u);
                                phi_1355_ = _e957;
                            } else {
                                phi_1352_ = u32();
                                phi_1355_ = u32();
                            }
                            let _e960 = phi_1352_;
                            let _e962 = phi_1355_;
                            continue;
                            continuing {
                                phi_1351_ = _e960;
                                phi_1354_ = _e962;
                                break if !(_e848);
                            }
                        }
                        let _e966 = nodes.member[(0u + _e573)].links[0u];
                        let _e970 = nodes.member[(0u + _e573)].frame[3u];
                        let _e974 = local_3;
                        if ((_e974 & 4278190080u) == 0u) {
                        } else {
                            let _e978 = local_2.group_mask;
                            if ((_e978 & 4278190080u) == 0u) {
                            } else {
                                let _e982 = local_2.len;
                                if (_e982 < 32u) {
                                    let _e985 = local_2.group;
                                    let _e987 = local_2.len;
                                    if (_e987 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.first[(0u + _e987)] = _e985;
                                    let _e993 = local_2.group_mask;
                                    let _e995 = local_2.len;
                                    if (_e995 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.mask[(0u + _e995)] = _e993;
                                    let _e1002 = local_2.len;
                                    local_2.len = (_e1002 + 1u);
                                }
                            }
                            local_2.group = (0u + _e966);
                            let _e1006 = local_4;
                            local_2.group_mask = ((_e1006 & 4278190080u) | (_e970 >> bitcast<u32>(24i)));
                        }
                        let _e1011 = local_5;
                        phi_1540_ = _e571;
                        phi_1543_ = (_e1011 & 16777215u);
                        loop {
                            let _e1014 = phi_1540_;
                            let _e1016 = phi_1543_;
                            local_6 = _e1014;
                            if (_e1016 == 0u) {
                                phi_1541_ = lt_bvh_Hit();
                                phi_1544_ = u32();
                                phi_2399_ = false;
                            } else {
                                let _e1020 = nodes.member[(0u + _e573)].links[1u];
                                let _e1025 = ((0u + _e1020) + select(firstTrailingBit(_e1016), 32u, (_e1016 == 0u)));
                                if (_e1025 < _e80) {
                                } else {
                                    return;
                                }
                                let _e1032 = triangles.member[(0u + _e1025)].v0_;
                                let _e1035 = (_e1032.x - _e156.origin.x);
                                let _e1038 = (_e1032.y - _e156.origin.y);
                                let _e1041 = (_e1032.z - _e156.origin.z);
                                if (_e398 == 0u) {
                                    phi_1590_ = vec3<f32>(_e1038, _e1041, _e1035);
                                } else {
                                    if (_e398 == 1u) {
                                        phi_1589_ = vec3<f32>(_e1041, _e1035, _e1038);
                                    } else {
                                        phi_1589_ = (_e1032 - _e156.origin);
                                    }
                                    let _e1048 = phi_1589_;
                                    phi_1590_ = _e1048;
                                }
                                let _e1050 = phi_1590_;
                                let _e1054 = (_e1050.x - (_e417 * _e1050.z));
                                let _e1058 = (_e1050.y - (_e420 * _e1050.z));
                                let _e1060 = triangles.member[(0u + _e1025)].v1_;
                                let _e1063 = (_e1060.x - _e156.origin.x);
                                let _e1066 = (_e1060.y - _e156.origin.y);
                                let _e1069 = (_e1060.z - _e156.origin.z);
                                if (_e398 == 0u) {
                                    phi_1622_ = vec3<f32>(_e1066, _e1069, _e1063);
                                } else {
                                    if (_e398 == 1u) {
                                        phi_1621_ = vec3<f32>(_e1069, _e1063, _e1066);
                                    } else {
                                        phi_1621_ = (_e1060 - _e156.origin);
                                    }
                                    let _e1076 = phi_1621_;
                                    phi_1622_ = _e1076;
                                }
                                let _e1078 = phi_1622_;
                                let _e1082 = (_e1078.x - (_e417 * _e1078.z));
                                let _e1086 = (_e1078.y - (_e420 * _e1078.z));
                                let _e1088 = triangles.member[(0u + _e1025)].v2_;
                                let _e1091 = (_e1088.x - _e156.origin.x);
                                let _e1094 = (_e1088.y - _e156.origin.y);
                                let _e1097 = (_e1088.z - _e156.origin.z);
                                if (_e398 == 0u) {
                                    phi_1654_ = vec3<f32>(_e1094, _e1097, _e1091);
                                } else {
                                    if (_e398 == 1u) {
                                        phi_1653_ = vec3<f32>(_e1097, _e1091, _e1094);
                                    } else {
                                        phi_1653_ = (_e1088 - _e156.origin);
                                    }
                                    let _e1104 = phi_1653_;
                                    phi_1654_ = _e1104;
                                }
                                let _e1106 = phi_1654_;
                                let _e1110 = (_e1106.x - (_e417 * _e1106.z));
                                let _e1114 = (_e1106.y - (_e420 * _e1106.z));
                                if (_e1082 < _e1110) {
                                    phi_1673_ = true;
                                } else {
                                    if (_e1082 == _e1110) {
                                        phi_1672_ = (_e1086 < _e1114);
                                    } else {
                                        phi_1672_ = false;
                                    }
                                    let _e1119 = phi_1672_;
                                    phi_1673_ = _e1119;
                                }
                                let _e1121 = phi_1673_;
                                if _e1121 {
                                    phi_1677_ = _e1114;
                                    phi_1678_ = _e1110;
                                    phi_1679_ = _e1086;
                                    phi_1680_ = _e1082;
                                } else {
                                    phi_1677_ = _e1086;
                                    phi_1678_ = _e1082;
                                    phi_1679_ = _e1114;
                                    phi_1680_ = _e1110;
                                }
                                let _e1123 = phi_1677_;
                                let _e1125 = phi_1678_;
                                let _e1127 = phi_1679_;
                                let _e1129 = phi_1680_;
                                let _e1132 = ((_e1129 * _e1123) - (_e1127 * _e1125));
                                if _e1121 {
                                    phi_1688_ = -(_e1132);
                                } else {
                                    phi_1688_ = _e1132;
                                }
                                let _e1135 = phi_1688_;
                                if (_e1110 < _e1054) {
                                    phi_1699_ = true;
                                } else {
                                    if (_e1110 == _e1054) {
                                        phi_1698_ = (_e1114 < _e1058);
                                    } else {
                                        phi_1698_ = false;
                                    }
                                    let _e1140 = phi_1698_;
                                    phi_1699_ = _e1140;
                                }
                                let _e1142 = phi_1699_;
                                if _e1142 {
                                    phi_1703_ = _e1058;
                                    phi_1704_ = _e1054;
                                    phi_1705_ = _e1114;
                                    phi_1706_ = _e1110;
                                } else {
                                    phi_1703_ = _e1114;
                                    phi_1704_ = _e1110;
                                    phi_1705_ = _e1058;
                                    phi_1706_ = _e1054;
                                }
                                let _e1144 = phi_1703_;
                                let _e1146 = phi_1704_;
                                let _e1148 = phi_1705_;
                                let _e1150 = phi_1706_;
                                let _e1153 = ((_e1150 * _e1144) - (_e1148 * _e1146));
                                if _e1142 {
                                    phi_1714_ = -(_e1153);
                                } else {
                                    phi_1714_ = _e1153;
                                }
                                let _e1156 = phi_1714_;
                                if (_e1054 < _e1082) {
                                    phi_1725_ = true;
                                } else {
                                    if (_e1054 == _e1082) {
                                        phi_1724_ = (_e1058 < _e1086);
                                    } else {
                                        phi_1724_ = false;
                                    }
                                    let _e1161 = phi_1724_;
                                    phi_1725_ = _e1161;
                                }
                                let _e1163 = phi_1725_;
                                if _e1163 {
                                    phi_1729_ = _e1086;
                                    phi_1730_ = _e1082;
                                    phi_1731_ = _e1058;
                                    phi_1732_ = _e1054;
                                } else {
                                    phi_1729_ = _e1058;
                                    phi_1730_ = _e1054;
                                    phi_1731_ = _e1086;
                                    phi_1732_ = _e1082;
                                }
                                let _e1165 = phi_1729_;
                                let _e1167 = phi_1730_;
                                let _e1169 = phi_1731_;
                                let _e1171 = phi_1732_;
                                let _e1174 = ((_e1171 * _e1165) - (_e1169 * _e1167));
                                if _e1163 {
                                    phi_1740_ = -(_e1174);
                                } else {
                                    phi_1740_ = _e1174;
                                }
                                let _e1177 = phi_1740_;
                                if (_e1135 >= 0f) {
                                    if (_e1156 >= 0f) {
                                        if (_e1177 >= 0f) {
                                            phi_1755_ = ((_e1135 + _e1156) + _e1177);
                                            phi_1756_ = false;
                                        } else {
                                            phi_1755_ = f32();
                                            phi_1756_ = true;
                                        }
                                        let _e1184 = phi_1755_;
                                        let _e1186 = phi_1756_;
                                        phi_1757_ = _e1184;
                                        phi_1758_ = _e1186;
                                    } else {
                                        phi_1757_ = f32();
                                        phi_1758_ = true;
                                    }
                                    let _e1188 = phi_1757_;
                                    let _e1190 = phi_1758_;
                                    phi_1759_ = _e1188;
                                    phi_1760_ = _e1190;
                                } else {
                                    phi_1759_ = f32();
                                    phi_1760_ = true;
                                }
                                let _e1192 = phi_1759_;
                                let _e1194 = phi_1760_;
                                if _e1194 {
                                    if (_e1135 <= 0f) {
                                        if (_e1156 <= 0f) {
                                            let _e1197 = (_e1177 <= 0f);
                                            if _e1197 {
                                            }
                                            phi_1778_ = ((_e1135 + _e1156) + _e1177);
                                            phi_1779_ = false;
                                            phi_1780_ = _e1197;
                                        } else {
                                            phi_1778_ = f32();
                                            phi_1779_ = true;
                                            phi_1780_ = false;
                                        }
                                        let _e1201 = phi_1778_;
                                        let _e1203 = phi_1779_;
                                        let _e1205 = phi_1780_;
                                        phi_1781_ = _e1201;
                                        phi_1782_ = _e1203;
                                        phi_1783_ = _e1205;
                                    } else {
                                        phi_1781_ = f32();
                                        phi_1782_ = true;
                                        phi_1783_ = false;
                                    }
                                    let _e1207 = phi_1781_;
                                    let _e1209 = phi_1782_;
                                    let _e1211 = phi_1783_;
                                    if _e1209 {
                                        phi_1787_ = false;
                                    } else {
                                        phi_1787_ = _e1211;
                                    }
                                    let _e1213 = phi_1787_;
                                    phi_1788_ = _e1207;
                                    phi_1789_ = _e1213;
                                } else {
                                    phi_1788_ = _e1192;
                                    phi_1789_ = true;
                                }
                                let _e1215 = phi_1788_;
                                let _e1217 = phi_1789_;
                                if _e1217 {
                                    let _e1218 = (_e1215 == 0f);
                                    if _e1218 {
                                        phi_2115_ = lt_bvh_triangle_Intersection();
                                        phi_2116_ = false;
                                    } else {
                                        let _e1220 = triangles.member[(0u + _e1025)].v0_;
                                        let _e1223 = (_e1220.x - _e156.origin.x);
                                        let _e1226 = (_e1220.y - _e156.origin.y);
                                        let _e1229 = (_e1220.z - _e156.origin.z);
                                        if (_e398 == 0u) {
                                            phi_1820_ = vec3<f32>(_e1226, _e1229, _e1223);
                                        } else {
                                            if (_e398 == 1u) {
                                                phi_1819_ = vec3<f32>(_e1229, _e1223, _e1226);
                                            } else {
                                                phi_1819_ = (_e1220 - _e156.origin);
                                            }
                                            let _e1236 = phi_1819_;
                                            phi_1820_ = _e1236;
                                        }
                                        let _e1238 = phi_1820_;
                                        let _e1240 = triangles.member[(0u + _e1025)].v1_;
                                        let _e1242 = triangles.member[(0u + _e1025)].v0_;
                                        let _e1245 = (_e1240.x - _e1242.x);
                                        let _e1248 = (_e1240.y - _e1242.y);
                                        let _e1251 = (_e1240.z - _e1242.z);
                                        if (_e398 == 0u) {
                                            phi_1846_ = vec3<f32>(_e1248, _e1251, _e1245);
                                        } else {
                                            if (_e398 == 1u) {
                                                phi_1845_ = vec3<f32>(_e1251, _e1245, _e1248);
                                            } else {
                                                phi_1845_ = (_e1240 - _e1242);
                                            }
                                            let _e1258 = phi_1845_;
                                            phi_1846_ = _e1258;
                                        }
                                        let _e1260 = phi_1846_;
                                        let _e1262 = triangles.member[(0u + _e1025)].v2_;
                                        let _e1264 = triangles.member[(0u + _e1025)].v0_;
                                        let _e1267 = (_e1262.x - _e1264.x);
                                        let _e1270 = (_e1262.y - _e1264.y);
                                        let _e1273 = (_e1262.z - _e1264.z);
                                        if (_e398 == 0u) {
                                            phi_1872_ = vec3<f32>(_e1270, _e1273, _e1267);
                                        } else {
                                            if (_e398 == 1u) {
                                                phi_1871_ = vec3<f32>(_e1273, _e1267, _e1270);
                                            } else {
                                                phi_1871_ = (_e1262 - _e1264);
                                            }
                                            let _e1280 = phi_1871_;
                                            phi_1872_ = _e1280;
                                        }
                                        let _e1282 = phi_1872_;
                                        let _e1289 = ((_e1260.y * _e1282.z) - (_e1260.z * _e1282.y));
                                        let _e1296 = ((_e1260.z * _e1282.x) - (_e1260.x * _e1282.z));
                                        let _e1303 = ((_e1260.x * _e1282.y) - (_e1260.y * _e1282.x));
                                        let _e1317 = (((1f / _e413.z) * (((_e1289 * _e1238.x) + (_e1296 * _e1238.y)) + (_e1303 * _e1238.z))) / (((_e1289 * _e417) + (_e1296 * _e420)) + _e1303));
                                        if (_e1317 > _e156.tmin) {
                                            if (_e1317 < _e156.tmax) {
                                                let _e1323 = triangles.member[(0u + _e1025)].v0_;
                                                let _e1325 = triangles.member[(0u + _e1025)].v1_;
                                                if (_e1323.x < _e1325.x) {
                                                    phi_1930_ = _e1323.x;
                                                } else {
                                                    phi_1930_ = _e1325.x;
                                                }
                                                let _e1332 = phi_1930_;
                                                if (_e1323.y < _e1325.y) {
                                                    phi_1939_ = _e1323.y;
                                                } else {
                                                    phi_1939_ = _e1325.y;
                                                }
                                                let _e1339 = phi_1939_;
                                                if (_e1323.z < _e1325.z) {
                                                    phi_1948_ = _e1323.z;
                                                } else {
                                                    phi_1948_ = _e1325.z;
                                                }
                                                let _e1346 = phi_1948_;
                                                let _e1348 = triangles.member[(0u + _e1025)].v2_;
                                                if (_e1332 < _e1348.x) {
                                                    phi_1957_ = _e1332;
                                                } else {
                                                    phi_1957_ = _e1348.x;
                                                }
                                                let _e1353 = phi_1957_;
                                                if (_e1339 < _e1348.y) {
                                                    phi_1964_ = _e1339;
                                                } else {
                                                    phi_1964_ = _e1348.y;
                                                }
                                                let _e1358 = phi_1964_;
                                                if (_e1346 < _e1348.z) {
                                                    phi_1971_ = _e1346;
                                                } else {
                                                    phi_1971_ = _e1348.z;
                                                }
                                                let _e1363 = phi_1971_;
                                                let _e1365 = triangles.member[(0u + _e1025)].v0_;
                                                let _e1367 = triangles.member[(0u + _e1025)].v1_;
                                                if (_e1365.x > _e1367.x) {
                                                    phi_1984_ = _e1365.x;
                                                } else {
                                                    phi_1984_ = _e1367.x;
                                                }
                                                let _e1374 = phi_1984_;
                                                if (_e1365.y > _e1367.y) {
                                                    phi_1993_ = _e1365.y;
                                                } else {
                                                    phi_1993_ = _e1367.y;
                                                }
                                                let _e1381 = phi_1993_;
                                                if (_e1365.z > _e1367.z) {
                                                    phi_2002_ = _e1365.z;
                                                } else {
                                                    phi_2002_ = _e1367.z;
                                                }
                                                let _e1388 = phi_2002_;
                                                let _e1390 = triangles.member[(0u + _e1025)].v2_;
                                                if (_e1374 > _e1390.x) {
                                                    phi_2011_ = _e1374;
                                                } else {
                                                    phi_2011_ = _e1390.x;
                                                }
                                                let _e1395 = phi_2011_;
                                                if (_e1381 > _e1390.y) {
                                                    phi_2018_ = _e1381;
                                                } else {
                                                    phi_2018_ = _e1390.y;
                                                }
                                                let _e1400 = phi_2018_;
                                                if (_e1388 > _e1390.z) {
                                                    phi_2025_ = _e1388;
                                                } else {
                                                    phi_2025_ = _e1390.z;
                                                }
                                                let _e1405 = phi_2025_;
                                                let _e1412 = ((_e1353 - _e156.origin.x) * _e310);
                                                let _e1413 = ((_e1358 - _e156.origin.y) * _e322);
                                                let _e1414 = ((_e1363 - _e156.origin.z) * _e334);
                                                let _e1421 = ((_e1395 - _e156.origin.x) * _e310);
                                                let _e1422 = ((_e1400 - _e156.origin.y) * _e322);
                                                let _e1423 = ((_e1405 - _e156.origin.z) * _e334);
                                                if (_e1412 < _e1421) {
                                                    phi_2048_ = _e1412;
                                                } else {
                                                    phi_2048_ = _e1421;
                                                }
                                                let _e1426 = phi_2048_;
                                                if (_e1413 < _e1422) {
                                                    phi_2053_ = _e1413;
                                                } else {
                                                    phi_2053_ = _e1422;
                                                }
                                                let _e1429 = phi_2053_;
                                                if (_e1414 < _e1423) {
                                                    phi_2058_ = _e1414;
                                                } else {
                                                    phi_2058_ = _e1423;
                                                }
                                                let _e1432 = phi_2058_;
                                                if (_e1412 > _e1421) {
                                                    phi_2066_ = _e1412;
                                                } else {
                                                    phi_2066_ = _e1421;
                                                }
                                                let _e1438 = phi_2066_;
                                                if (_e1413 > _e1422) {
                                                    phi_2071_ = _e1413;
                                                } else {
                                                    phi_2071_ = _e1422;
                                                }
                                                let _e1441 = phi_2071_;
                                                if (_e1414 > _e1423) {
                                                    phi_2076_ = _e1414;
                                                } else {
                                                    phi_2076_ = _e1423;
                                                }
                                                let _e1444 = phi_2076_;
                                                let _e1448 = core_intrinsics_maximum_number_nsz_f32_((_e1426 - _e378), (_e1429 - _e379));
                                                let _e1449 = core_intrinsics_maximum_number_nsz_f32_(_e1448, (_e1432 - _e380));
                                                let _e1450 = core_intrinsics_minimum_number_nsz_f32_((_e1438 + _e378), (_e1441 + _e379));
                                                let _e1451 = core_intrinsics_minimum_number_nsz_f32_(_e1450, (_e1444 + _e380));
                                                if (_e1449 > -300000000000000000000000000000000000000f) {
                                                    phi_2088_ = _e1449;
                                                } else {
                                                    phi_2088_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1454 = phi_2088_;
                                                if (_e1451 < 300000000000000000000000000000000000000f) {
                                                    phi_2093_ = _e1451;
                                                } else {
                                                    phi_2093_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1457 = phi_2093_;
                                                if (_e1317 < _e1454) {
                                                    phi_2098_ = _e1454;
                                                } else {
                                                    phi_2098_ = _e1317;
                                                }
                                                let _e1460 = phi_2098_;
                                                if (_e1460 > _e1457) {
                                                    phi_2103_ = _e1457;
                                                } else {
                                                    phi_2103_ = _e1460;
                                                }
                                                let _e1463 = phi_2103_;
                                                phi_2108_ = lt_bvh_triangle_Intersection(_e1463, (_e1156 / _e1215), (_e1177 / _e1215), (_e1454 <= _e1457));
                                                phi_2109_ = false;
                                            } else {
                                                phi_2108_ = lt_bvh_triangle_Intersection();
                                                phi_2109_ = true;
                                            }
                                            let _e1469 = phi_2108_;
                                            let _e1471 = phi_2109_;
                                            phi_2110_ = _e1469;
                                            phi_2111_ = _e1471;
                                        } else {
                                            phi_2110_ = lt_bvh_triangle_Intersection();
                                            phi_2111_ = true;
                                        }
                                        let _e1473 = phi_2110_;
                                        let _e1475 = phi_2111_;
                                        if _e1475 {
                                        }
                                        phi_2115_ = _e1473;
                                        phi_2116_ = _e1475;
                                    }
                                    let _e1477 = phi_2115_;
                                    let _e1479 = phi_2116_;
                                    phi_2117_ = _e1477;
                                    phi_2118_ = _e1218;
                                    phi_2119_ = _e1479;
                                } else {
                                    phi_2117_ = lt_bvh_triangle_Intersection();
                                    phi_2118_ = true;
                                    phi_2119_ = false;
                                }
                                let _e1481 = phi_2117_;
                                let _e1483 = phi_2118_;
                                let _e1485 = phi_2119_;
                                if _e1483 {
                                    phi_2123_ = true;
                                } else {
                                    phi_2123_ = _e1485;
                                }
                                let _e1487 = phi_2123_;
                                if _e1487 {
                                    phi_2127_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_2127_ = _e1481;
                                }
                                let _e1489 = phi_2127_;
                                if _e1489.is_hit {
                                    if (_e1489.t > _e156.tmin) {
                                        if (_e1489.t < _e1014.t) {
                                            phi_2176_ = true;
                                        } else {
                                            if (_e1489.t == _e1014.t) {
                                                if (_e1014.triangle != 4294967295u) {
                                                    if (_e1025 < _e1014.triangle) {
                                                        phi_2167_ = true;
                                                    } else {
                                                        if (_e1025 == _e1014.triangle) {
                                                            phi_2166_ = (4294967295u < _e1014.instance);
                                                        } else {
                                                            phi_2166_ = false;
                                                        }
                                                        let _e1508 = phi_2166_;
                                                        phi_2167_ = _e1508;
                                                    }
                                                    let _e1510 = phi_2167_;
                                                    phi_2168_ = _e1510;
                                                    phi_2169_ = false;
                                                } else {
                                                    phi_2168_ = bool();
                                                    phi_2169_ = true;
                                                }
                                                let _e1512 = phi_2168_;
                                                let _e1514 = phi_2169_;
                                                phi_2170_ = _e1512;
                                                phi_2171_ = _e1514;
                                            } else {
                                                phi_2170_ = bool();
                                                phi_2171_ = true;
                                            }
                                            let _e1516 = phi_2170_;
                                            let _e1518 = phi_2171_;
                                            if _e1518 {
                                                phi_2175_ = false;
                                            } else {
                                                phi_2175_ = _e1516;
                                            }
                                            let _e1520 = phi_2175_;
                                            phi_2176_ = _e1520;
                                        }
                                        let _e1522 = phi_2176_;
                                        if _e1522 {
                                            let _e1524 = triangles.member[(0u + _e1025)].i0_;
                                            if ((_e1524 & 2147483648u) == 0u) {
                                                phi_2387_ = true;
                                            } else {
                                                if (_e1025 < _e80) {
                                                } else {
                                                    return;
                                                }
                                                let _e1533 = triangles.member[(0u + _e1025)].i0_;
                                                let _e1534 = (_e1533 & 2147483647u);
                                                let _e1536 = triangles.member[(0u + _e1025)].i1_;
                                                let _e1538 = triangles.member[(0u + _e1025)].i2_;
                                                if (_e1534 < _e83) {
                                                } else {
                                                    return;
                                                }
                                                let _e1542 = vertices.member[(0u + _e1534)];
                                                if (_e1536 < _e83) {
                                                } else {
                                                    return;
                                                }
                                                let _e1546 = vertices.member[(0u + _e1536)];
                                                if (_e1538 < _e83) {
                                                } else {
                                                    return;
                                                }
                                                let _e1550 = vertices.member[(0u + _e1538)];
                                                let _e1551 = array<abi_Vertex, 3>(_e1542, _e1546, _e1550);
                                                if (_e1551[0].material < _e86) {
                                                } else {
                                                    return;
                                                }
                                                let _e1557 = materials.member[(0u + _e1551[0].material)];
                                                if ((_e1557.flags & 0u) == 0u) {
                                                    let _e1562 = ((1f - _e1489.u) - _e1489.v);
                                                    if (_e1557.cutoff <= 0f) {
                                                        phi_2382_ = true;
                                                    } else {
                                                        let _e1589 = (_e1557.base_color.w * ((((f32((_e1551[0].color >> bitcast<u32>(24i))) * _e1562) + (f32((_e1551[1].color >> bitcast<u32>(24i))) * _e1489.u)) + (f32((_e1551[2].color >> bitcast<u32>(24i))) * _e1489.v)) * (1f / 255f)));
                                                        if (_e1557.alpha_size == 0u) {
                                                            phi_2379_ = _e1589;
                                                        } else {
                                                            local_1.offset = _e1557.alpha_offset;
                                                            local_1.size = _e1557.alpha_size;
                                                            local_1.flags = _e1557.flags;
                                                            let _e1620 = _lt_shaders_texture_TextureView_quad((&local_1), (((_e1551[0].u * _e1562) + (_e1551[1].u * _e1489.u)) + (_e1551[2].u * _e1489.v)), (((_e1551[0].v * _e1562) + (_e1551[1].v * _e1489.u)) + (_e1551[2].v * _e1489.v)));
                                                            let _e1624 = (_e1620.indices[0] >> bitcast<u32>(2i));
                                                            if (_e1624 < _e92) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1628 = alpha_texels.member[(0u + _e1624)];
                                                            let _e1644 = (_e1620.indices[1] >> bitcast<u32>(2i));
                                                            if (_e1644 < _e92) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1648 = alpha_texels.member[(0u + _e1644)];
                                                            let _e1665 = (_e1620.indices[2] >> bitcast<u32>(2i));
                                                            if (_e1665 < _e92) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1669 = alpha_texels.member[(0u + _e1665)];
                                                            let _e1686 = (_e1620.indices[3] >> bitcast<u32>(2i));
                                                            if (_e1686 < _e92) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1690 = alpha_texels.member[(0u + _e1686)];
                                                            phi_2379_ = (_e1589 * (((((f32(((_e1628 >> bitcast<u32>((((_e1620.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1620.weights.x) + ((f32(((_e1648 >> bitcast<u32>((((_e1620.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1620.weights.y)) + ((f32(((_e1669 >> bitcast<u32>((((_e1620.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1620.weights.z)) + ((f32(((_e1690 >> bitcast<u32>((((_e1620.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1620.weights.w)));
                                                        }
                                                        let _e1706 = phi_2379_;
                                                        phi_2382_ = (_e1706 >= _e1557.cutoff);
                                                    }
                                                    let _e1710 = phi_2382_;
                                                    phi_2383_ = _e1710;
                                                } else {
                                                    phi_2383_ = false;
                                                }
                                                let _e1712 = phi_2383_;
                                                if _e1712 {
                                                }
                                                phi_2387_ = _e1712;
                                            }
                                            let _e1714 = phi_2387_;
                                            if _e1714 {
                                                phi_2395_ = lt_bvh_Hit(_e1489.t, _e1489.u, _e1489.v, _e1025, 4294967295u);
                                            } else {
                                                phi_2395_ = _e1014;
                                            }
                                            let _e1720 = phi_2395_;
                                            phi_2396_ = _e1720;
                                        } else {
                                            phi_2396_ = _e1014;
                                        }
                                        let _e1722 = phi_2396_;
                                        phi_2397_ = _e1722;
                                    } else {
                                        phi_2397_ = _e1014;
                                    }
                                    let _e1724 = phi_2397_;
                                    phi_2398_ = _e1724;
                                } else {
                                    phi_2398_ = _e1014;
                                }
                                let _e1726 = phi_2398_;
                                phi_1541_ = _e1726;
                                phi_1544_ = (_e1016 & (_e1016 - 1u));
                                phi_2399_ = true;
                            }
                            let _e1728 = phi_1541_;
                            let _e1730 = phi_1544_;
                            let _e1732 = phi_2399_;
                            continue;
                            continuing {
                                phi_1540_ = _e1728;
                                phi_1543_ = _e1730;
                                break if !(_e1732);
                            }
                        }
                        let _e1735 = local_2.group_mask;
                        if ((_e1735 & 4278190080u) == 0u) {
                            let _e1739 = local_2.len;
                            if (_e1739 == 0u) {
                                phi_2438_ = false;
                            } else {
                                let _e1743 = local_2.len;
                                local_2.len = (_e1743 - 1u);
                                let _e1746 = local_2.len;
                                if (_e1746 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1751 = local_2.first[(0u + _e1746)];
                                local_2.group = _e1751;
                                let _e1754 = local_2.len;
                                if (_e1754 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1759 = local_2.mask[(0u + _e1754)];
                                local_2.group_mask = _e1759;
                                phi_2438_ = true;
                            }
                            let _e1762 = phi_2438_;
                            phi_2439_ = _e1762;
                        } else {
                            phi_2439_ = true;
                        }
                        let _e1764 = phi_2439_;
                        if _e1764 {
                            let _e1766 = local_2.group_mask;
                            let _e1772 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1766)), 32u, (_e1766 == 0u)));
                            let _e1776 = local_2.group_mask;
                            let _e1790 = local_2.group_mask;
                            local_2.group_mask = (_e1790 & ~((1u << bitcast<u32>((_e1772 & 31u)))));
                            let _e1793 = local_2.group;
                            phi_2470_ = (_e1793 + countOneBits(((_e1776 & ~((4294967295u << bitcast<u32>((((_e1772 - 24u) ^ _e433) & 31u))))) & 255u)));
                        } else {
                            phi_2470_ = 4294967295u;
                        }
                        let _e1796 = phi_2470_;
                        let _e2643 = local_6;
                        phi_1204_ = _e2643;
                        phi_1207_ = _e1796;
                    } else {
                        phi_1204_ = lt_bvh_Hit();
                        phi_1207_ = u32();
                    }
                    let _e1798 = phi_1204_;
                    let _e1800 = phi_1207_;
                    continue;
                    continuing {
                        phi_1203_ = _e1798;
                        phi_1206_ = _e1800;
                        break if !(_e574);
                    }
                }
                let _e2647 = local_7;
                phi_2471_ = _e2647;
            }
            let _e1803 = phi_2471_;
            phi_2472_ = _e1803;
            phi_2473_ = _e228;
        } else {
            phi_2472_ = lt_bvh_Hit();
            phi_2473_ = true;
        }
        let _e1805 = phi_2472_;
        let _e1807 = phi_2473_;
        if _e1807 {
            phi_2477_ = _e158;
        } else {
            phi_2477_ = _e1805;
        }
        let _e1809 = phi_2477_;
        if (_e1809.triangle != 4294967295u) {
            let _e1815 = ((1f - _e1809.u) - _e1809.v);
            if (_e1809.triangle < _e80) {
            } else {
                return;
            }
            let _e1820 = triangles.member[(0u + _e1809.triangle)];
            let _e1845 = (((_e1820.v0_.x * _e1815) + (_e1820.v1_.x * _e1809.u)) + (_e1820.v2_.x * _e1809.v));
            let _e1846 = (((_e1820.v0_.y * _e1815) + (_e1820.v1_.y * _e1809.u)) + (_e1820.v2_.y * _e1809.v));
            let _e1847 = (((_e1820.v0_.z * _e1815) + (_e1820.v1_.z * _e1809.u)) + (_e1820.v2_.z * _e1809.v));
            let _e1850 = abs(_e1820.v0_.x);
            let _e1852 = abs(_e1820.v0_.y);
            let _e1854 = abs(_e1820.v0_.z);
            let _e1856 = abs(_e1820.v1_.x);
            let _e1858 = abs(_e1820.v1_.y);
            let _e1860 = abs(_e1820.v1_.z);
            if (_e1850 > _e1856) {
                phi_2541_ = _e1850;
            } else {
                phi_2541_ = _e1856;
            }
            let _e1863 = phi_2541_;
            if (_e1852 > _e1858) {
                phi_2546_ = _e1852;
            } else {
                phi_2546_ = _e1858;
            }
            let _e1866 = phi_2546_;
            if (_e1854 > _e1860) {
                phi_2551_ = _e1854;
            } else {
                phi_2551_ = _e1860;
            }
            let _e1869 = phi_2551_;
            let _e1871 = abs(_e1820.v2_.x);
            let _e1873 = abs(_e1820.v2_.y);
            let _e1875 = abs(_e1820.v2_.z);
            if (_e1863 > _e1871) {
                phi_2562_ = _e1863;
            } else {
                phi_2562_ = _e1871;
            }
            let _e1878 = phi_2562_;
            if (_e1866 > _e1873) {
                phi_2567_ = _e1866;
            } else {
                phi_2567_ = _e1873;
            }
            let _e1881 = phi_2567_;
            if (_e1869 > _e1875) {
                phi_2572_ = _e1869;
            } else {
                phi_2572_ = _e1875;
            }
            let _e1884 = phi_2572_;
            let _e1887 = (_e1820.v1_.x - _e1820.v0_.x);
            let _e1890 = (_e1820.v1_.y - _e1820.v0_.y);
            let _e1893 = (_e1820.v1_.z - _e1820.v0_.z);
            let _e1896 = (_e1820.v2_.x - _e1820.v0_.x);
            let _e1899 = (_e1820.v2_.y - _e1820.v0_.y);
            let _e1902 = (_e1820.v2_.z - _e1820.v0_.z);
            let _e1906 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1890), abs(_e1893));
            let _e1907 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1887), _e1906);
            let _e1908 = (_e1887 / _e1907);
            let _e1909 = (_e1890 / _e1907);
            let _e1910 = (_e1893 / _e1907);
            let _e1914 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1899), abs(_e1902));
            let _e1915 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1896), _e1914);
            let _e1916 = (_e1896 / _e1915);
            let _e1917 = (_e1899 / _e1915);
            let _e1918 = (_e1902 / _e1915);
            let _e1921 = ((_e1909 * _e1918) - (_e1917 * _e1910));
            let _e1924 = ((_e1910 * _e1916) - (_e1918 * _e1908));
            let _e1927 = ((_e1908 * _e1917) - (_e1916 * _e1909));
            let _e1929 = p.member.eye;
            let _e1942 = (1f / sqrt((((_e1921 * _e1921) + (_e1924 * _e1924)) + (_e1927 * _e1927))));
            let _e1943 = (_e1921 * _e1942);
            let _e1944 = (_e1924 * _e1942);
            let _e1945 = (_e1927 * _e1942);
            if ((((_e1943 * (_e1929.x - _e1845)) + (_e1944 * (_e1929.y - _e1846))) + (_e1945 * (_e1929.z - _e1847))) < 0f) {
                phi_2648_ = vec3<f32>(-(_e1943), -(_e1944), -(_e1945));
            } else {
                phi_2648_ = vec3<f32>(_e1943, _e1944, _e1945);
            }
            let _e1958 = phi_2648_;
            if (_e1809.triangle < _e80) {
            } else {
                return;
            }
            let _e1963 = triangles.member[(0u + _e1809.triangle)];
            let _e1965 = (_e1963.i0_ & 2147483647u);
            if (_e1965 < _e83) {
            } else {
                return;
            }
            let _e1971 = vertices.member[(0u + _e1965)];
            if (_e1963.i1_ < _e83) {
            } else {
                return;
            }
            let _e1975 = vertices.member[(0u + _e1963.i1_)];
            if (_e1963.i2_ < _e83) {
            } else {
                return;
            }
            let _e1979 = vertices.member[(0u + _e1963.i2_)];
            let _e1980 = array<abi_Vertex, 3>(_e1971, _e1975, _e1979);
            if (_e1980[0].material < _e86) {
            } else {
                return;
            }
            let _e1986 = materials.member[(0u + _e1980[0].material)];
            let _e2003 = (1f / 255f);
            let _e2022 = (1f / 255f);
            let _e2044 = (1f / 255f);
            if (_e1986.color_size == 0u) {
                phi_2891_ = vec3<f32>(1f, 1f, 1f);
            } else {
                local.offset = _e1986.color_offset;
                local.size = _e1986.color_size;
                local.flags = _e1986.flags;
                let _e2087 = _lt_shaders_texture_TextureView_quad((&local), (((_e1980[0].u * _e1815) + (_e1980[1].u * _e1809.u)) + (_e1980[2].u * _e1809.v)), (((_e1980[0].v * _e1815) + (_e1980[1].v * _e1809.u)) + (_e1980[2].v * _e1809.v)));
                if (_e2087.indices[0] < _e95) {
                } else {
                    return;
                }
                let _e2093 = color_texels.member[(0u + _e2087.indices[0])];
                let _e2104 = (1f / 255f);
                if (_e2087.indices[1] < _e95) {
                } else {
                    return;
                }
                let _e2118 = color_texels.member[(0u + _e2087.indices[1])];
                let _e2129 = (1f / 255f);
                if (_e2087.indices[2] < _e95) {
                } else {
                    return;
                }
                let _e2146 = color_texels.member[(0u + _e2087.indices[2])];
                let _e2157 = (1f / 255f);
                if (_e2087.indices[3] < _e95) {
                } else {
                    return;
                }
                let _e2174 = color_texels.member[(0u + _e2087.indices[3])];
                let _e2185 = (1f / 255f);
                let _e2194 = (((((f32((_e2093 & 255u)) * _e2104) * _e2087.weights.x) + ((f32((_e2118 & 255u)) * _e2129) * _e2087.weights.y)) + ((f32((_e2146 & 255u)) * _e2157) * _e2087.weights.z)) + ((f32((_e2174 & 255u)) * _e2185) * _e2087.weights.w));
                let _e2195 = (((((f32(((_e2093 >> bitcast<u32>(8i)) & 255u)) * _e2104) * _e2087.weights.x) + ((f32(((_e2118 >> bitcast<u32>(8i)) & 255u)) * _e2129) * _e2087.weights.y)) + ((f32(((_e2146 >> bitcast<u32>(8i)) & 255u)) * _e2157) * _e2087.weights.z)) + ((f32(((_e2174 >> bitcast<u32>(8i)) & 255u)) * _e2185) * _e2087.weights.w));
                let _e2196 = (((((f32(((_e2093 >> bitcast<u32>(16i)) & 255u)) * _e2104) * _e2087.weights.x) + ((f32(((_e2118 >> bitcast<u32>(16i)) & 255u)) * _e2129) * _e2087.weights.y)) + ((f32(((_e2146 >> bitcast<u32>(16i)) & 255u)) * _e2157) * _e2087.weights.z)) + ((f32(((_e2174 >> bitcast<u32>(16i)) & 255u)) * _e2185) * _e2087.weights.w));
                phi_2891_ = vec3<f32>((_e2194 * _e2194), (_e2195 * _e2195), (_e2196 * _e2196));
            }
            let _e2202 = phi_2891_;
            let _e2204 = ((_e1986.base_color.x * ((((f32((_e1980[0].color & 255u)) * _e2003) * _e1815) + ((f32((_e1980[1].color & 255u)) * _e2022) * _e1809.u)) + ((f32((_e1980[2].color & 255u)) * _e2044) * _e1809.v))) * _e2202.x);
            let _e2206 = ((_e1986.base_color.y * ((((f32(((_e1980[0].color >> bitcast<u32>(8i)) & 255u)) * _e2003) * _e1815) + ((f32(((_e1980[1].color >> bitcast<u32>(8i)) & 255u)) * _e2022) * _e1809.u)) + ((f32(((_e1980[2].color >> bitcast<u32>(8i)) & 255u)) * _e2044) * _e1809.v))) * _e2202.y);
            let _e2208 = ((_e1986.base_color.z * ((((f32(((_e1980[0].color >> bitcast<u32>(16i)) & 255u)) * _e2003) * _e1815) + ((f32(((_e1980[1].color >> bitcast<u32>(16i)) & 255u)) * _e2022) * _e1809.u)) + ((f32(((_e1980[2].color >> bitcast<u32>(16i)) & 255u)) * _e2044) * _e1809.v))) * _e2202.z);
            let _e2209 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1881, _e1884);
            let _e2210 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1878, _e2209);
            if ((_e1986.flags & 2u) == 0u) {
                phi_2906_ = 0u;
            } else {
                phi_2906_ = 1u;
            }
            let _e2215 = phi_2906_;
            if (_e1980[0].normal == 2147516416u) {
                phi_3109_ = _e1958;
            } else {
                let _e2228 = (f32((bitcast<i32>((_e1980[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2234 = (f32((bitcast<i32>(_e1980[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2238 = ((1f - abs(_e2228)) - abs(_e2234));
                if (_e2238 < 0f) {
                    phi_2933_ = -(_e2238);
                } else {
                    phi_2933_ = 0f;
                }
                let _e2242 = phi_2933_;
                if (_e2228 < 0f) {
                    phi_2940_ = (_e2228 + _e2242);
                } else {
                    phi_2940_ = (_e2228 - _e2242);
                }
                let _e2247 = phi_2940_;
                if (_e2234 < 0f) {
                    phi_2947_ = (_e2234 + _e2242);
                } else {
                    phi_2947_ = (_e2234 - _e2242);
                }
                let _e2252 = phi_2947_;
                let _e2259 = (1f / sqrt((((_e2247 * _e2247) + (_e2252 * _e2252)) + (_e2238 * _e2238))));
                let _e2275 = (f32((bitcast<i32>((_e1980[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2281 = (f32((bitcast<i32>(_e1980[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2285 = ((1f - abs(_e2275)) - abs(_e2281));
                if (_e2285 < 0f) {
                    phi_2982_ = -(_e2285);
                } else {
                    phi_2982_ = 0f;
                }
                let _e2289 = phi_2982_;
                if (_e2275 < 0f) {
                    phi_2989_ = (_e2275 + _e2289);
                } else {
                    phi_2989_ = (_e2275 - _e2289);
                }
                let _e2294 = phi_2989_;
                if (_e2281 < 0f) {
                    phi_2996_ = (_e2281 + _e2289);
                } else {
                    phi_2996_ = (_e2281 - _e2289);
                }
                let _e2299 = phi_2996_;
                let _e2306 = (1f / sqrt((((_e2294 * _e2294) + (_e2299 * _e2299)) + (_e2285 * _e2285))));
                let _e2325 = (f32((bitcast<i32>((_e1980[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2331 = (f32((bitcast<i32>(_e1980[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2335 = ((1f - abs(_e2325)) - abs(_e2331));
                if (_e2335 < 0f) {
                    phi_3034_ = -(_e2335);
                } else {
                    phi_3034_ = 0f;
                }
                let _e2339 = phi_3034_;
                if (_e2325 < 0f) {
                    phi_3041_ = (_e2325 + _e2339);
                } else {
                    phi_3041_ = (_e2325 - _e2339);
                }
                let _e2344 = phi_3041_;
                if (_e2331 < 0f) {
                    phi_3048_ = (_e2331 + _e2339);
                } else {
                    phi_3048_ = (_e2331 - _e2339);
                }
                let _e2349 = phi_3048_;
                let _e2356 = (1f / sqrt((((_e2344 * _e2344) + (_e2349 * _e2349)) + (_e2335 * _e2335))));
                let _e2367 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(vec3<f32>(((((_e2247 * _e2259) * _e1815) + ((_e2294 * _e2306) * _e1809.u)) + ((_e2344 * _e2356) * _e1809.v)), ((((_e2252 * _e2259) * _e1815) + ((_e2299 * _e2306) * _e1809.u)) + ((_e2349 * _e2356) * _e1809.v)), ((((_e2238 * _e2259) * _e1815) + ((_e2285 * _e2306) * _e1809.u)) + ((_e2335 * _e2356) * _e1809.v))));
                let _e2379 = sqrt((((_e2367.x * _e2367.x) + (_e2367.y * _e2367.y)) + (_e2367.z * _e2367.z)));
                if (_e2379 > 0f) {
                    let _e2382 = (_e2367.x / _e2379);
                    let _e2384 = (_e2367.y / _e2379);
                    let _e2386 = (_e2367.z / _e2379);
                    if ((((_e2382 * _e1958.x) + (_e2384 * _e1958.y)) + (_e2386 * _e1958.z)) < 0f) {
                        phi_3107_ = vec3<f32>(-(_e2382), -(_e2384), -(_e2386));
                    } else {
                        phi_3107_ = (_e2367 / vec3(_e2379));
                    }
                    let _e2403 = phi_3107_;
                    phi_3108_ = _e2403;
                } else {
                    phi_3108_ = _e1958;
                }
                let _e2405 = phi_3108_;
                phi_3109_ = _e2405;
            }
            let _e2407 = phi_3109_;
            if (_e2204 > 0f) {
                if (_e2204 < 1f) {
                    phi_3118_ = _e2204;
                } else {
                    phi_3118_ = 1f;
                }
                let _e2411 = phi_3118_;
                phi_3119_ = _e2411;
            } else {
                phi_3119_ = 0f;
            }
            let _e2413 = phi_3119_;
            if (_e2206 > 0f) {
                if (_e2206 < 1f) {
                    phi_3129_ = _e2206;
                } else {
                    phi_3129_ = 1f;
                }
                let _e2418 = phi_3129_;
                phi_3130_ = _e2418;
            } else {
                phi_3130_ = 0f;
            }
            let _e2420 = phi_3130_;
            if (_e2208 > 0f) {
                if (_e2208 < 1f) {
                    phi_3140_ = _e2208;
                } else {
                    phi_3140_ = 1f;
                }
                let _e2425 = phi_3140_;
                phi_3141_ = _e2425;
            } else {
                phi_3141_ = 0f;
            }
            let _e2427 = phi_3141_;
            let _e2430 = ((sqrt(_e2413) * 255f) + 0.5f);
            let _e2439 = ((sqrt(_e2420) * 255f) + 0.5f);
            let _e2451 = ((sqrt(_e2427) * 255f) + 0.5f);
            phi_3176_ = abi_Sample(vec3<f32>(_e1845, _e1846, _e1847), _e2210, _e1958, _e2215, _e2407, ((select(select(u32(_e2430), 0u, (_e2430 < bitcast<f32>(0u))), 4294967295u, (_e2430 > bitcast<f32>(1333788671u))) | (select(select(u32(_e2439), 0u, (_e2439 < bitcast<f32>(0u))), 4294967295u, (_e2439 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e2451), 0u, (_e2451 < bitcast<f32>(0u))), 4294967295u, (_e2451 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_3176_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e2465 = phi_3176_;
        if (_e101.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e101.shift)] = _e2465;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_alpha_color_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
