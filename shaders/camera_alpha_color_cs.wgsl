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
    var phi_767_: bool;
    var phi_768_: bool;
    var phi_769_: bool;
    var phi_770_: bool;
    var phi_774_: bool;
    var phi_787_: bool;
    var phi_788_: bool;
    var phi_789_: bool;
    var phi_790_: bool;
    var phi_794_: bool;
    var phi_807_: bool;
    var phi_808_: bool;
    var phi_809_: bool;
    var phi_813_: bool;
    var phi_814_: bool;
    var phi_815_: bool;
    var phi_816_: bool;
    var phi_817_: bool;
    var phi_821_: bool;
    var phi_897_: f32;
    var phi_904_: f32;
    var phi_912_: f32;
    var phi_919_: f32;
    var phi_927_: f32;
    var phi_934_: f32;
    var phi_957_: f32;
    var phi_962_: f32;
    var phi_967_: f32;
    var phi_972_: f32;
    var phi_977_: f32;
    var phi_1008_: bool;
    var phi_1009_: bool;
    var phi_1017_: u32;
    var phi_1018_: u32;
    var phi_1035_: vec3<f32>;
    var phi_1036_: vec3<f32>;
    var phi_1049_: u32;
    var phi_1054_: u32;
    var phi_1059_: u32;
    var phi_1173_: bool;
    var phi_1174_: bool;
    var phi_1205_: u32;
    var phi_1207_: lt_bvh_Hit;
    var phi_1210_: u32;
    var phi_1295_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1322_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1349_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1355_: u32;
    var phi_1358_: u32;
    var phi_1372_: u32;
    var phi_1382_: u32;
    var phi_1392_: u32;
    var phi_1410_: u32;
    var phi_1420_: u32;
    var phi_1430_: u32;
    var phi_1466_: u32;
    var phi_1479_: u32;
    var phi_1484_: u32;
    var phi_1485_: u32;
    var phi_1486_: u32;
    var phi_1356_: u32;
    var phi_1359_: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_1544_: lt_bvh_Hit;
    var phi_1547_: u32;
    var phi_1593_: vec3<f32>;
    var phi_1594_: vec3<f32>;
    var phi_1625_: vec3<f32>;
    var phi_1626_: vec3<f32>;
    var phi_1657_: vec3<f32>;
    var phi_1658_: vec3<f32>;
    var phi_1676_: bool;
    var phi_1677_: bool;
    var phi_1681_: f32;
    var phi_1682_: f32;
    var phi_1683_: f32;
    var phi_1684_: f32;
    var phi_1692_: f32;
    var phi_1702_: bool;
    var phi_1703_: bool;
    var phi_1707_: f32;
    var phi_1708_: f32;
    var phi_1709_: f32;
    var phi_1710_: f32;
    var phi_1718_: f32;
    var phi_1728_: bool;
    var phi_1729_: bool;
    var phi_1733_: f32;
    var phi_1734_: f32;
    var phi_1735_: f32;
    var phi_1736_: f32;
    var phi_1744_: f32;
    var phi_1759_: f32;
    var phi_1760_: bool;
    var phi_1761_: f32;
    var phi_1762_: bool;
    var phi_1763_: f32;
    var phi_1764_: bool;
    var phi_1782_: f32;
    var phi_1783_: bool;
    var phi_1784_: bool;
    var phi_1785_: f32;
    var phi_1786_: bool;
    var phi_1787_: bool;
    var phi_1791_: bool;
    var phi_1792_: f32;
    var phi_1793_: bool;
    var phi_1823_: vec3<f32>;
    var phi_1824_: vec3<f32>;
    var phi_1849_: vec3<f32>;
    var phi_1850_: vec3<f32>;
    var phi_1875_: vec3<f32>;
    var phi_1876_: vec3<f32>;
    var phi_1934_: f32;
    var phi_1943_: f32;
    var phi_1952_: f32;
    var phi_1961_: f32;
    var phi_1968_: f32;
    var phi_1975_: f32;
    var phi_1988_: f32;
    var phi_1997_: f32;
    var phi_2006_: f32;
    var phi_2015_: f32;
    var phi_2022_: f32;
    var phi_2029_: f32;
    var phi_2052_: f32;
    var phi_2057_: f32;
    var phi_2062_: f32;
    var phi_2070_: f32;
    var phi_2075_: f32;
    var phi_2080_: f32;
    var phi_2092_: f32;
    var phi_2097_: f32;
    var phi_2102_: f32;
    var phi_2107_: f32;
    var phi_2112_: lt_bvh_triangle_Intersection;
    var phi_2113_: bool;
    var phi_2114_: lt_bvh_triangle_Intersection;
    var phi_2115_: bool;
    var phi_2119_: lt_bvh_triangle_Intersection;
    var phi_2120_: bool;
    var phi_2121_: lt_bvh_triangle_Intersection;
    var phi_2122_: bool;
    var phi_2123_: bool;
    var phi_2127_: bool;
    var phi_2131_: lt_bvh_triangle_Intersection;
    var phi_2170_: bool;
    var phi_2171_: bool;
    var phi_2172_: bool;
    var phi_2173_: bool;
    var phi_2174_: bool;
    var phi_2175_: bool;
    var phi_2179_: bool;
    var phi_2180_: bool;
    var phi_2383_: f32;
    var phi_2386_: bool;
    var phi_2387_: bool;
    var phi_2391_: bool;
    var phi_2399_: lt_bvh_Hit;
    var phi_2400_: lt_bvh_Hit;
    var phi_2401_: lt_bvh_Hit;
    var phi_2402_: lt_bvh_Hit;
    var phi_1545_: lt_bvh_Hit;
    var phi_1548_: u32;
    var phi_2403_: bool;
    var phi_2442_: bool;
    var phi_2443_: bool;
    var phi_2474_: u32;
    var phi_1208_: lt_bvh_Hit;
    var phi_1211_: u32;
    var phi_2475_: lt_bvh_Hit;
    var phi_2476_: lt_bvh_Hit;
    var phi_2477_: bool;
    var phi_2481_: lt_bvh_Hit;
    var phi_2545_: f32;
    var phi_2550_: f32;
    var phi_2555_: f32;
    var phi_2566_: f32;
    var phi_2571_: f32;
    var phi_2576_: f32;
    var phi_2652_: vec3<f32>;
    var phi_2895_: vec3<f32>;
    var phi_2910_: u32;
    var phi_2937_: f32;
    var phi_2944_: f32;
    var phi_2951_: f32;
    var phi_2986_: f32;
    var phi_2993_: f32;
    var phi_3000_: f32;
    var phi_3038_: f32;
    var phi_3045_: f32;
    var phi_3052_: f32;
    var phi_3111_: vec3<f32>;
    var phi_3112_: vec3<f32>;
    var phi_3113_: vec3<f32>;
    var phi_3122_: f32;
    var phi_3123_: f32;
    var phi_3133_: f32;
    var phi_3134_: f32;
    var phi_3144_: f32;
    var phi_3145_: f32;
    var phi_3180_: abi_Sample;
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
        let _e161 = abs(_e156.direction.x);
        let _e163 = abs(_e156.direction.y);
        let _e165 = abs(_e156.direction.z);
        if (abs(_e156.origin.x) < 1000000000000000f) {
            if (abs(_e156.origin.y) < 1000000000000000f) {
                phi_767_ = (abs(_e156.origin.z) < 1000000000000000f);
                phi_768_ = false;
            } else {
                phi_767_ = bool();
                phi_768_ = true;
            }
            let _e177 = phi_767_;
            let _e179 = phi_768_;
            phi_769_ = _e177;
            phi_770_ = _e179;
        } else {
            phi_769_ = bool();
            phi_770_ = true;
        }
        let _e181 = phi_769_;
        let _e183 = phi_770_;
        if _e183 {
            phi_774_ = false;
        } else {
            phi_774_ = _e181;
        }
        let _e185 = phi_774_;
        if _e185 {
            if (_e161 < 1000000000000000f) {
                if (_e163 < 1000000000000000f) {
                    phi_787_ = (_e165 < 1000000000000000f);
                    phi_788_ = false;
                } else {
                    phi_787_ = bool();
                    phi_788_ = true;
                }
                let _e190 = phi_787_;
                let _e192 = phi_788_;
                phi_789_ = _e190;
                phi_790_ = _e192;
            } else {
                phi_789_ = bool();
                phi_790_ = true;
            }
            let _e194 = phi_789_;
            let _e196 = phi_790_;
            if _e196 {
                phi_794_ = false;
            } else {
                phi_794_ = _e194;
            }
            let _e198 = phi_794_;
            if _e198 {
                if (_e161 > 0f) {
                    phi_808_ = bool();
                    phi_809_ = true;
                } else {
                    let _e200 = (_e163 > 0f);
                    if _e200 {
                        phi_807_ = bool();
                    } else {
                        phi_807_ = (_e165 > 0f);
                    }
                    let _e203 = phi_807_;
                    phi_808_ = _e203;
                    phi_809_ = _e200;
                }
                let _e205 = phi_808_;
                let _e207 = phi_809_;
                if _e207 {
                    phi_813_ = true;
                } else {
                    phi_813_ = _e205;
                }
                let _e209 = phi_813_;
                phi_814_ = _e209;
                phi_815_ = false;
            } else {
                phi_814_ = bool();
                phi_815_ = true;
            }
            let _e211 = phi_814_;
            let _e213 = phi_815_;
            phi_816_ = _e211;
            phi_817_ = _e213;
        } else {
            phi_816_ = bool();
            phi_817_ = true;
        }
        let _e215 = phi_816_;
        let _e217 = phi_817_;
        if _e217 {
            phi_821_ = false;
        } else {
            phi_821_ = _e215;
        }
        let _e219 = phi_821_;
        if _e219 {
            let _e220 = (0u >= _e77);
            if _e220 {
                phi_2475_ = lt_bvh_Hit();
            } else {
                if (0u < _e77) {
                } else {
                    return;
                }
                let _e226 = nodes.member[(0u + 0u)].frame[0u];
                let _e230 = nodes.member[(0u + 0u)].frame[1u];
                let _e234 = nodes.member[(0u + 0u)].frame[2u];
                let _e238 = nodes.member[(0u + 0u)].frame[0u];
                let _e242 = nodes.member[(0u + 0u)].frame[1u];
                let _e246 = nodes.member[(0u + 0u)].frame[2u];
                let _e250 = nodes.member[(0u + 0u)].frame[3u];
                let _e289 = core_intrinsics_maximum_number_nsz_f32_(abs(_e156.direction.x), abs(_e156.direction.y));
                let _e290 = core_intrinsics_maximum_number_nsz_f32_(_e289, abs(_e156.direction.z));
                let _e291 = (_e290 * 0.0000000000009094947f);
                if (abs(_e156.direction.x) < _e291) {
                    phi_897_ = _e291;
                } else {
                    phi_897_ = abs(_e156.direction.x);
                }
                let _e297 = phi_897_;
                if (_e156.direction.x < 0f) {
                    phi_904_ = (-1f / _e297);
                } else {
                    phi_904_ = (1f / _e297);
                }
                let _e302 = phi_904_;
                if (abs(_e156.direction.y) < _e291) {
                    phi_912_ = _e291;
                } else {
                    phi_912_ = abs(_e156.direction.y);
                }
                let _e308 = phi_912_;
                if (_e156.direction.y < 0f) {
                    phi_919_ = (-1f / _e308);
                } else {
                    phi_919_ = (1f / _e308);
                }
                let _e313 = phi_919_;
                if (abs(_e156.direction.z) < _e291) {
                    phi_927_ = _e291;
                } else {
                    phi_927_ = abs(_e156.direction.z);
                }
                let _e319 = phi_927_;
                if (_e156.direction.z < 0f) {
                    phi_934_ = (-1f / _e319);
                } else {
                    phi_934_ = (1f / _e319);
                }
                let _e324 = phi_934_;
                let _e331 = abs((bitcast<f32>(_e226) - _e156.origin.x));
                let _e332 = abs((bitcast<f32>(_e230) - _e156.origin.y));
                let _e333 = abs((bitcast<f32>(_e234) - _e156.origin.z));
                let _e340 = abs(((bitcast<f32>(_e238) + (bitcast<f32>((((_e250 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e156.origin.x));
                let _e341 = abs(((bitcast<f32>(_e242) + (bitcast<f32>((((_e250 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e156.origin.y));
                let _e342 = abs(((bitcast<f32>(_e246) + (bitcast<f32>((((_e250 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e156.origin.z));
                if (_e331 > _e340) {
                    phi_957_ = _e331;
                } else {
                    phi_957_ = _e340;
                }
                let _e345 = phi_957_;
                if (_e332 > _e341) {
                    phi_962_ = _e332;
                } else {
                    phi_962_ = _e341;
                }
                let _e348 = phi_962_;
                if (_e333 > _e342) {
                    phi_967_ = _e333;
                } else {
                    phi_967_ = _e342;
                }
                let _e351 = phi_967_;
                if (_e345 > _e348) {
                    phi_972_ = _e345;
                } else {
                    phi_972_ = _e348;
                }
                let _e354 = phi_972_;
                if (_e354 > _e351) {
                    phi_977_ = _e354;
                } else {
                    phi_977_ = _e351;
                }
                let _e357 = phi_977_;
                let _e361 = (_e357 * 0.0000019073486f);
                let _e362 = (abs(_e302) * _e361);
                let _e363 = (abs(_e313) * _e361);
                let _e364 = (abs(_e324) * _e361);
                let _e368 = (_e357 * 0.0000009536743f);
                let _e369 = (abs(_e302) * _e368);
                let _e370 = (abs(_e313) * _e368);
                let _e371 = (abs(_e324) * _e368);
                let _e375 = abs(_e156.direction.x);
                let _e377 = abs(_e156.direction.y);
                let _e379 = abs(_e156.direction.z);
                if (_e375 >= _e377) {
                    if (_e375 >= _e379) {
                        phi_1008_ = false;
                    } else {
                        phi_1008_ = true;
                    }
                    let _e383 = phi_1008_;
                    phi_1009_ = _e383;
                } else {
                    phi_1009_ = true;
                }
                let _e385 = phi_1009_;
                if _e385 {
                    if (_e377 >= _e379) {
                        phi_1017_ = 1u;
                    } else {
                        phi_1017_ = 2u;
                    }
                    let _e388 = phi_1017_;
                    phi_1018_ = _e388;
                } else {
                    phi_1018_ = 0u;
                }
                let _e390 = phi_1018_;
                if (_e390 == 0u) {
                    phi_1036_ = vec3<f32>(_e156.direction.y, _e156.direction.z, _e156.direction.x);
                } else {
                    if (_e390 == 1u) {
                        phi_1035_ = vec3<f32>(_e156.direction.z, _e156.direction.x, _e156.direction.y);
                    } else {
                        phi_1035_ = _e156.direction;
                    }
                    let _e402 = phi_1035_;
                    phi_1036_ = _e402;
                }
                let _e404 = phi_1036_;
                let _e407 = (_e404.x / _e404.z);
                let _e410 = (_e404.y / _e404.z);
                if (_e302 < 0f) {
                    phi_1049_ = 0u;
                } else {
                    phi_1049_ = 1u;
                }
                let _e415 = phi_1049_;
                if (_e313 < 0f) {
                    phi_1054_ = 0u;
                } else {
                    phi_1054_ = 2u;
                }
                let _e418 = phi_1054_;
                if (_e324 < 0f) {
                    phi_1059_ = 0u;
                } else {
                    phi_1059_ = 4u;
                }
                let _e421 = phi_1059_;
                let _e423 = ((_e415 | _e418) | _e421);
                let _e424 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e424.first[0], _e424.first[1], _e424.first[2], _e424.first[3], _e424.first[4], _e424.first[5], _e424.first[6], _e424.first[7], _e424.first[8], _e424.first[9], _e424.first[10], _e424.first[11], _e424.first[12], _e424.first[13], _e424.first[14], _e424.first[15], _e424.first[16], _e424.first[17], _e424.first[18], _e424.first[19], _e424.first[20], _e424.first[21], _e424.first[22], _e424.first[23], _e424.first[24], _e424.first[25], _e424.first[26], _e424.first[27], _e424.first[28], _e424.first[29], _e424.first[30], _e424.first[31]), array<u32, 32>(_e424.mask[0], _e424.mask[1], _e424.mask[2], _e424.mask[3], _e424.mask[4], _e424.mask[5], _e424.mask[6], _e424.mask[7], _e424.mask[8], _e424.mask[9], _e424.mask[10], _e424.mask[11], _e424.mask[12], _e424.mask[13], _e424.mask[14], _e424.mask[15], _e424.mask[16], _e424.mask[17], _e424.mask[18], _e424.mask[19], _e424.mask[20], _e424.mask[21], _e424.mask[22], _e424.mask[23], _e424.mask[24], _e424.mask[25], _e424.mask[26], _e424.mask[27], _e424.mask[28], _e424.mask[29], _e424.mask[30], _e424.mask[31]), _e424.len, _e424.group, _e424.group_mask);
                let _e498 = local_2.group_mask;
                if ((_e498 & 4278190080u) == 0u) {
                    let _e502 = local_2.len;
                    if (_e502 == 0u) {
                        phi_1173_ = false;
                    } else {
                        let _e506 = local_2.len;
                        local_2.len = (_e506 - 1u);
                        let _e509 = local_2.len;
                        if (_e509 < 32u) {
                        } else {
                            return;
                        }
                        let _e514 = local_2.first[(0u + _e509)];
                        local_2.group = _e514;
                        let _e517 = local_2.len;
                        if (_e517 < 32u) {
                        } else {
                            return;
                        }
                        let _e522 = local_2.mask[(0u + _e517)];
                        local_2.group_mask = _e522;
                        phi_1173_ = true;
                    }
                    let _e525 = phi_1173_;
                    phi_1174_ = _e525;
                } else {
                    phi_1174_ = true;
                }
                let _e527 = phi_1174_;
                if _e527 {
                    let _e529 = local_2.group_mask;
                    let _e535 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e529)), 32u, (_e529 == 0u)));
                    let _e539 = local_2.group_mask;
                    let _e553 = local_2.group_mask;
                    local_2.group_mask = (_e553 & ~((1u << bitcast<u32>((_e535 & 31u)))));
                    let _e556 = local_2.group;
                    phi_1205_ = (_e556 + countOneBits(((_e539 & ~((4294967295u << bitcast<u32>((((_e535 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1205_ = 4294967295u;
                }
                let _e559 = phi_1205_;
                phi_1207_ = _e158;
                phi_1210_ = _e559;
                loop {
                    let _e561 = phi_1207_;
                    let _e563 = phi_1210_;
                    local_7 = _e561;
                    let _e564 = (_e563 != 4294967295u);
                    if _e564 {
                        if (_e563 < _e77) {
                        } else {
                            return;
                        }
                        let _e572 = nodes.member[(0u + _e563)].frame[3u];
                        let _e597 = (bitcast<f32>((((_e572 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e302);
                        let _e598 = (bitcast<f32>((((_e572 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e313);
                        let _e599 = (bitcast<f32>((((_e572 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e324);
                        let _e602 = nodes.member[(0u + _e563)].frame[0u];
                        let _e606 = nodes.member[(0u + _e563)].frame[1u];
                        let _e610 = nodes.member[(0u + _e563)].frame[2u];
                        let _e618 = ((bitcast<f32>(_e602) - _e156.origin.x) * _e302);
                        let _e619 = ((bitcast<f32>(_e606) - _e156.origin.y) * _e313);
                        let _e620 = ((bitcast<f32>(_e610) - _e156.origin.z) * _e324);
                        let _e628 = nodes.member[(0u + _e563)].x;
                        if (_e302 < 0f) {
                            let _e639 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e628.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e645 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e639.unnamed.word, _e628.w), _e639.unnamed_1);
                            let _e651 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e645.unnamed, lt_mask_LightPlace(_e628.x, _e645.unnamed_1.shift));
                            phi_1295_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e651.unnamed, lt_mask_LightPlace(_e651.unnamed_1.word, _e628.y));
                        } else {
                            let _e667 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e628.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e673 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e667.unnamed.word, _e628.y), _e667.unnamed_1);
                            let _e679 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e673.unnamed, lt_mask_LightPlace(_e628.z, _e673.unnamed_1.shift));
                            phi_1295_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e679.unnamed, lt_mask_LightPlace(_e679.unnamed_1.word, _e628.w));
                        }
                        let _e687 = phi_1295_;
                        let _e697 = nodes.member[(0u + _e563)].y;
                        if (_e313 < 0f) {
                            let _e708 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e697.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e714 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e708.unnamed.word, _e697.w), _e708.unnamed_1);
                            let _e720 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e714.unnamed, lt_mask_LightPlace(_e697.x, _e714.unnamed_1.shift));
                            phi_1322_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e720.unnamed, lt_mask_LightPlace(_e720.unnamed_1.word, _e697.y));
                        } else {
                            let _e736 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e697.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e742 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e736.unnamed.word, _e697.y), _e736.unnamed_1);
                            let _e748 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e742.unnamed, lt_mask_LightPlace(_e697.z, _e742.unnamed_1.shift));
                            phi_1322_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e748.unnamed, lt_mask_LightPlace(_e748.unnamed_1.word, _e697.w));
                        }
                        let _e756 = phi_1322_;
                        let _e766 = nodes.member[(0u + _e563)].z;
                        if (_e324 < 0f) {
                            let _e777 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e766.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e783 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e777.unnamed.word, _e766.w), _e777.unnamed_1);
                            let _e789 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e783.unnamed, lt_mask_LightPlace(_e766.x, _e783.unnamed_1.shift));
                            phi_1349_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e789.unnamed, lt_mask_LightPlace(_e789.unnamed_1.word, _e766.y));
                        } else {
                            let _e805 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e766.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e811 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e805.unnamed.word, _e766.y), _e805.unnamed_1);
                            let _e817 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e811.unnamed, lt_mask_LightPlace(_e766.z, _e811.unnamed_1.shift));
                            phi_1349_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e817.unnamed, lt_mask_LightPlace(_e817.unnamed_1.word, _e766.w));
                        }
                        let _e825 = phi_1349_;
                        phi_1355_ = 0u;
                        phi_1358_ = 0u;
                        loop {
                            let _e835 = phi_1355_;
                            let _e837 = phi_1358_;
                            local_3 = _e837;
                            local_4 = _e837;
                            local_5 = _e837;
                            let _e838 = (_e835 < 8u);
                            if _e838 {
                                let _e840 = (_e835 >> bitcast<u32>(2i));
                                let _e841 = (_e835 & 3u);
                                if (_e840 == 0u) {
                                    phi_1372_ = _e687.unnamed.word;
                                } else {
                                    phi_1372_ = _e687.unnamed.shift;
                                }
                                let _e844 = phi_1372_;
                                if (_e840 == 0u) {
                                    phi_1382_ = _e756.unnamed.word;
                                } else {
                                    phi_1382_ = _e756.unnamed.shift;
                                }
                                let _e853 = phi_1382_;
                                if (_e840 == 0u) {
                                    phi_1392_ = _e825.unnamed.word;
                                } else {
                                    phi_1392_ = _e825.unnamed.shift;
                                }
                                let _e862 = phi_1392_;
                                let _e875 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e844 >> bitcast<u32>(((_e841 * 8u) & 31u))) & 255u)) * _e597) + (_e618 - _e362)), ((f32(((_e853 >> bitcast<u32>(((_e841 * 8u) & 31u))) & 255u)) * _e598) + (_e619 - _e363)));
                                let _e876 = core_intrinsics_maximum_number_nsz_f32_(_e875, ((f32(((_e862 >> bitcast<u32>(((_e841 * 8u) & 31u))) & 255u)) * _e599) + (_e620 - _e364)));
                                if (_e840 == 0u) {
                                    phi_1410_ = _e687.unnamed_1.word;
                                } else {
                                    phi_1410_ = _e687.unnamed_1.shift;
                                }
                                let _e879 = phi_1410_;
                                if (_e840 == 0u) {
                                    phi_1420_ = _e756.unnamed_1.word;
                                } else {
                                    phi_1420_ = _e756.unnamed_1.shift;
                                }
                                let _e888 = phi_1420_;
                                if (_e840 == 0u) {
                                    phi_1430_ = _e825.unnamed_1.word;
                                } else {
                                    phi_1430_ = _e825.unnamed_1.shift;
                                }
                                let _e897 = phi_1430_;
                                let _e910 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e879 >> bitcast<u32>(((_e841 * 8u) & 31u))) & 255u)) * _e597) + (_e618 + _e362)), ((f32(((_e888 >> bitcast<u32>(((_e841 * 8u) & 31u))) & 255u)) * _e598) + (_e619 + _e363)));
                                let _e911 = core_intrinsics_minimum_number_nsz_f32_(_e910, ((f32(((_e897 >> bitcast<u32>(((_e841 * 8u) & 31u))) & 255u)) * _e599) + (_e620 + _e364)));
                                if (_e876 <= _e911) {
                                    if (_e876 <= _e561.t) {
                                        if (_e911 >= _e156.tmin) {
                                            if (_e840 == 0u) {
                                                let _e918 = nodes.member[(0u + _e563)].links[2u];
                                                phi_1466_ = _e918;
                                            } else {
                                                let _e921 = nodes.member[(0u + _e563)].links[3u];
                                                phi_1466_ = _e921;
                                            }
                                            let _e923 = phi_1466_;
                                            let _e928 = ((_e923 >> bitcast<u32>(((_e841 * 8u) & 31u))) & 255u);
                                            let _e929 = (_e928 & 31u);
                                            if (_e929 >= 24u) {
                                                phi_1479_ = (24u + ((_e929 - 24u) ^ _e423));
                                            } else {
                                                phi_1479_ = _e929;
                                            }
                                            let _e935 = phi_1479_;
                                            phi_1484_ = (_e837 | ((_e928 >> bitcast<u32>(5i)) << bitcast<u32>((_e935 & 31u))));
                                        } else {
                                            phi_1484_ = _e837;
                                        }
                                        let _e943 = phi_1484_;
                                        phi_1485_ = _e943;
                                    } else {
                                        phi_1485_ = _e837;
                                    }
                                    let _e945 = phi_1485_;
                                    phi_1486_ = _e945;
                                } else {
                                    phi_1486_ = _e837;
                                }
                                let _e947 = phi_1486_;
                                phi_1356_ = (_e835 + 1u);
                                phi_1359_ = _e947;
                            } else {
                                phi_1356_ = u32();
                                phi_1359_ = u32();
                            }
                            let _e950 = phi_1356_;
                            let _e952 = phi_1359_;
                            continue;
                            continuing {
                                phi_1355_ = _e950;
                                phi_1358_ = _e952;
                                break if !(_e838);
                            }
                        }
                        let _e956 = nodes.member[(0u + _e563)].links[0u];
                        let _e960 = nodes.member[(0u + _e563)].frame[3u];
                        let _e964 = local_3;
                        if ((_e964 & 4278190080u) == 0u) {
                        } else {
                            let _e968 = local_2.group_mask;
                            if ((_e968 & 4278190080u) == 0u) {
                            } else {
                                let _e972 = local_2.len;
                                if (_e972 < 32u) {
                                    let _e975 = local_2.group;
                                    let _e977 = local_2.len;
                                    if (_e977 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.first[(0u + _e977)] = _e975;
                                    let _e983 = local_2.group_mask;
                                    let _e985 = local_2.len;
                                    if (_e985 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.mask[(0u + _e985)] = _e983;
                                    let _e992 = local_2.len;
                                    local_2.len = (_e992 + 1u);
                                }
                            }
                            local_2.group = (0u + _e956);
                            let _e996 = local_4;
                            local_2.group_mask = ((_e996 & 4278190080u) | (_e960 >> bitcast<u32>(24i)));
                        }
                        let _e1001 = local_5;
                        phi_1544_ = _e561;
                        phi_1547_ = (_e1001 & 16777215u);
                        loop {
                            let _e1004 = phi_1544_;
                            let _e1006 = phi_1547_;
                            local_6 = _e1004;
                            if (_e1006 == 0u) {
                                phi_1545_ = lt_bvh_Hit();
                                phi_1548_ = u32();
                                phi_2403_ = false;
                            } else {
                                let _e1010 = nodes.member[(0u + _e563)].links[1u];
                                let _e1015 = ((0u + _e1010) + select(firstTrailingBit(_e1006), 32u, (_e1006 == 0u)));
                                if (_e1015 < _e80) {
                                } else {
                                    return;
                                }
                                let _e1022 = triangles.member[(0u + _e1015)].v0_;
                                let _e1025 = (_e1022.x - _e156.origin.x);
                                let _e1028 = (_e1022.y - _e156.origin.y);
                                let _e1031 = (_e1022.z - _e156.origin.z);
                                if (_e390 == 0u) {
                                    phi_1594_ = vec3<f32>(_e1028, _e1031, _e1025);
                                } else {
                                    if (_e390 == 1u) {
                                        phi_1593_ = vec3<f32>(_e1031, _e1025, _e1028);
                                    } else {
                                        phi_1593_ = (_e1022 - _e156.origin);
                                    }
                                    let _e1038 = phi_1593_;
                                    phi_1594_ = _e1038;
                                }
                                let _e1040 = phi_1594_;
                                let _e1044 = (_e1040.x - (_e407 * _e1040.z));
                                let _e1048 = (_e1040.y - (_e410 * _e1040.z));
                                let _e1050 = triangles.member[(0u + _e1015)].v1_;
                                let _e1053 = (_e1050.x - _e156.origin.x);
                                let _e1056 = (_e1050.y - _e156.origin.y);
                                let _e1059 = (_e1050.z - _e156.origin.z);
                                if (_e390 == 0u) {
                                    phi_1626_ = vec3<f32>(_e1056, _e1059, _e1053);
                                } else {
                                    if (_e390 == 1u) {
                                        phi_1625_ = vec3<f32>(_e1059, _e1053, _e1056);
                                    } else {
                                        phi_1625_ = (_e1050 - _e156.origin);
                                    }
                                    let _e1066 = phi_1625_;
                                    phi_1626_ = _e1066;
                                }
                                let _e1068 = phi_1626_;
                                let _e1072 = (_e1068.x - (_e407 * _e1068.z));
                                let _e1076 = (_e1068.y - (_e410 * _e1068.z));
                                let _e1078 = triangles.member[(0u + _e1015)].v2_;
                                let _e1081 = (_e1078.x - _e156.origin.x);
                                let _e1084 = (_e1078.y - _e156.origin.y);
                                let _e1087 = (_e1078.z - _e156.origin.z);
                                if (_e390 == 0u) {
                                    phi_1658_ = vec3<f32>(_e1084, _e1087, _e1081);
                                } else {
                                    if (_e390 == 1u) {
                                        phi_1657_ = vec3<f32>(_e1087, _e1081, _e1084);
                                    } else {
                                        phi_1657_ = (_e1078 - _e156.origin);
                                    }
                                    let _e1094 = phi_1657_;
                                    phi_1658_ = _e1094;
                                }
                                let _e1096 = phi_1658_;
                                let _e1100 = (_e1096.x - (_e407 * _e1096.z));
                                let _e1104 = (_e1096.y - (_e410 * _e1096.z));
                                if (_e1072 < _e1100) {
                                    phi_1677_ = true;
                                } else {
                                    if (_e1072 == _e1100) {
                                        phi_1676_ = (_e1076 < _e1104);
                                    } else {
                                        phi_1676_ = false;
                                    }
                                    let _e1109 = phi_1676_;
                                    phi_1677_ = _e1109;
                                }
                                let _e1111 = phi_1677_;
                                if _e1111 {
                                    phi_1681_ = _e1104;
                                    phi_1682_ = _e1100;
                                    phi_1683_ = _e1076;
                                    phi_1684_ = _e1072;
                                } else {
                                    phi_1681_ = _e1076;
                                    phi_1682_ = _e1072;
                                    phi_1683_ = _e1104;
                                    phi_1684_ = _e1100;
                                }
                                let _e1113 = phi_1681_;
                                let _e1115 = phi_1682_;
                                let _e1117 = phi_1683_;
                                let _e1119 = phi_1684_;
                                let _e1122 = ((_e1119 * _e1113) - (_e1117 * _e1115));
                                if _e1111 {
                                    phi_1692_ = -(_e1122);
                                } else {
                                    phi_1692_ = _e1122;
                                }
                                let _e1125 = phi_1692_;
                                if (_e1100 < _e1044) {
                                    phi_1703_ = true;
                                } else {
                                    if (_e1100 == _e1044) {
                                        phi_1702_ = (_e1104 < _e1048);
                                    } else {
                                        phi_1702_ = false;
                                    }
                                    let _e1130 = phi_1702_;
                                    phi_1703_ = _e1130;
                                }
                                let _e1132 = phi_1703_;
                                if _e1132 {
                                    phi_1707_ = _e1048;
                                    phi_1708_ = _e1044;
                                    phi_1709_ = _e1104;
                                    phi_1710_ = _e1100;
                                } else {
                                    phi_1707_ = _e1104;
                                    phi_1708_ = _e1100;
                                    phi_1709_ = _e1048;
                                    phi_1710_ = _e1044;
                                }
                                let _e1134 = phi_1707_;
                                let _e1136 = phi_1708_;
                                let _e1138 = phi_1709_;
                                let _e1140 = phi_1710_;
                                let _e1143 = ((_e1140 * _e1134) - (_e1138 * _e1136));
                                if _e1132 {
                                    phi_1718_ = -(_e1143);
                                } else {
                                    phi_1718_ = _e1143;
                                }
                                let _e1146 = phi_1718_;
                                if (_e1044 < _e1072) {
                                    phi_1729_ = true;
                                } else {
                                    if (_e1044 == _e1072) {
                                        phi_1728_ = (_e1048 < _e1076);
                                    } else {
                                        phi_1728_ = false;
                                    }
                                    let _e1151 = phi_1728_;
                                    phi_1729_ = _e1151;
                                }
                                let _e1153 = phi_1729_;
                                if _e1153 {
                                    phi_1733_ = _e1076;
                                    phi_1734_ = _e1072;
                                    phi_1735_ = _e1048;
                                    phi_1736_ = _e1044;
                                } else {
                                    phi_1733_ = _e1048;
                                    phi_1734_ = _e1044;
                                    phi_1735_ = _e1076;
                                    phi_1736_ = _e1072;
                                }
                                let _e1155 = phi_1733_;
                                let _e1157 = phi_1734_;
                                let _e1159 = phi_1735_;
                                let _e1161 = phi_1736_;
                                let _e1164 = ((_e1161 * _e1155) - (_e1159 * _e1157));
                                if _e1153 {
                                    phi_1744_ = -(_e1164);
                                } else {
                                    phi_1744_ = _e1164;
                                }
                                let _e1167 = phi_1744_;
                                if (_e1125 >= 0f) {
                                    if (_e1146 >= 0f) {
                                        if (_e1167 >= 0f) {
                                            phi_1759_ = ((_e1125 + _e1146) + _e1167);
                                            phi_1760_ = false;
                                        } else {
                                            phi_1759_ = f32();
                                            phi_1760_ = true;
                                        }
                                        let _e1174 = phi_1759_;
                                        let _e1176 = phi_1760_;
                                        phi_1761_ = _e1174;
                                        phi_1762_ = _e1176;
                                    } else {
                                        phi_1761_ = f32();
                                        phi_1762_ = true;
                                    }
                                    let _e1178 = phi_1761_;
                                    let _e1180 = phi_1762_;
                                    phi_1763_ = _e1178;
                                    phi_1764_ = _e1180;
                                } else {
                                    phi_1763_ = f32();
                                    phi_1764_ = true;
                                }
                                let _e1182 = phi_1763_;
                                let _e1184 = phi_1764_;
                                if _e1184 {
                                    if (_e1125 <= 0f) {
                                        if (_e1146 <= 0f) {
                                            let _e1187 = (_e1167 <= 0f);
                                            if _e1187 {
                                            }
                                            phi_1782_ = ((_e1125 + _e1146) + _e1167);
                                            phi_1783_ = false;
                                            phi_1784_ = _e1187;
                                        } else {
                                            phi_1782_ = f32();
                                            phi_1783_ = true;
                                            phi_1784_ = false;
                                        }
                                        let _e1191 = phi_1782_;
                                        let _e1193 = phi_1783_;
                                        let _e1195 = phi_1784_;
                                        phi_1785_ = _e1191;
                                        phi_1786_ = _e1193;
                                        phi_1787_ = _e1195;
                                    } else {
                                        phi_1785_ = f32();
                                        phi_1786_ = true;
                                        phi_1787_ = false;
                                    }
                                    let _e1197 = phi_1785_;
                                    let _e1199 = phi_1786_;
                                    let _e1201 = phi_1787_;
                                    if _e1199 {
                                        phi_1791_ = false;
                                    } else {
                                        phi_1791_ = _e1201;
                                    }
                                    let _e1203 = phi_1791_;
                                    phi_1792_ = _e1197;
                                    phi_1793_ = _e1203;
                                } else {
                                    phi_1792_ = _e1182;
                                    phi_1793_ = true;
                                }
                                let _e1205 = phi_1792_;
                                let _e1207 = phi_1793_;
                                if _e1207 {
                                    let _e1208 = (_e1205 == 0f);
                                    if _e1208 {
                                        phi_2119_ = lt_bvh_triangle_Intersection();
                                        phi_2120_ = false;
                                    } else {
                                        let _e1210 = triangles.member[(0u + _e1015)].v0_;
                                        let _e1213 = (_e1210.x - _e156.origin.x);
                                        let _e1216 = (_e1210.y - _e156.origin.y);
                                        let _e1219 = (_e1210.z - _e156.origin.z);
                                        if (_e390 == 0u) {
                                            phi_1824_ = vec3<f32>(_e1216, _e1219, _e1213);
                                        } else {
                                            if (_e390 == 1u) {
                                                phi_1823_ = vec3<f32>(_e1219, _e1213, _e1216);
                                            } else {
                                                phi_1823_ = (_e1210 - _e156.origin);
                                            }
                                            let _e1226 = phi_1823_;
                                            phi_1824_ = _e1226;
                                        }
                                        let _e1228 = phi_1824_;
                                        let _e1230 = triangles.member[(0u + _e1015)].v1_;
                                        let _e1232 = triangles.member[(0u + _e1015)].v0_;
                                        let _e1235 = (_e1230.x - _e1232.x);
                                        let _e1238 = (_e1230.y - _e1232.y);
                                        let _e1241 = (_e1230.z - _e1232.z);
                                        if (_e390 == 0u) {
                                            phi_1850_ = vec3<f32>(_e1238, _e1241, _e1235);
                                        } else {
                                            if (_e390 == 1u) {
                                                phi_1849_ = vec3<f32>(_e1241, _e1235, _e1238);
                                            } else {
                                                phi_1849_ = (_e1230 - _e1232);
                                            }
                                            let _e1248 = phi_1849_;
                                            phi_1850_ = _e1248;
                                        }
                                        let _e1250 = phi_1850_;
                                        let _e1252 = triangles.member[(0u + _e1015)].v2_;
                                        let _e1254 = triangles.member[(0u + _e1015)].v0_;
                                        let _e1257 = (_e1252.x - _e1254.x);
                                        let _e1260 = (_e1252.y - _e1254.y);
                                        let _e1263 = (_e1252.z - _e1254.z);
                                        if (_e390 == 0u) {
                                            phi_1876_ = vec3<f32>(_e1260, _e1263, _e1257);
                                        } else {
                                            if (_e390 == 1u) {
                                                phi_1875_ = vec3<f32>(_e1263, _e1257, _e1260);
                                            } else {
                                                phi_1875_ = (_e1252 - _e1254);
                                            }
                                            let _e1270 = phi_1875_;
                                            phi_1876_ = _e1270;
                                        }
                                        let _e1272 = phi_1876_;
                                        let _e1279 = ((_e1250.y * _e1272.z) - (_e1250.z * _e1272.y));
                                        let _e1286 = ((_e1250.z * _e1272.x) - (_e1250.x * _e1272.z));
                                        let _e1293 = ((_e1250.x * _e1272.y) - (_e1250.y * _e1272.x));
                                        let _e1307 = (((1f / _e404.z) * (((_e1279 * _e1228.x) + (_e1286 * _e1228.y)) + (_e1293 * _e1228.z))) / (((_e1279 * _e407) + (_e1286 * _e410)) + _e1293));
                                        if (_e1307 > _e156.tmin) {
                                            if (_e1307 < _e156.tmax) {
                                                let _e1313 = triangles.member[(0u + _e1015)].v0_;
                                                let _e1315 = triangles.member[(0u + _e1015)].v1_;
                                                if (_e1313.x < _e1315.x) {
                                                    phi_1934_ = _e1313.x;
                                                } else {
                                                    phi_1934_ = _e1315.x;
                                                }
                                                let _e1322 = phi_1934_;
                                                if (_e1313.y < _e1315.y) {
                                                    phi_1943_ = _e1313.y;
                                                } else {
                                                    phi_1943_ = _e1315.y;
                                                }
                                                let _e1329 = phi_1943_;
                                                if (_e1313.z < _e1315.z) {
                                                    phi_1952_ = _e1313.z;
                                                } else {
                                                    phi_1952_ = _e1315.z;
                                                }
                                                let _e1336 = phi_1952_;
                                                let _e1338 = triangles.member[(0u + _e1015)].v2_;
                                                if (_e1322 < _e1338.x) {
                                                    phi_1961_ = _e1322;
                                                } else {
                                                    phi_1961_ = _e1338.x;
                                                }
                                                let _e1343 = phi_1961_;
                                                if (_e1329 < _e1338.y) {
                                                    phi_1968_ = _e1329;
                                                } else {
                                                    phi_1968_ = _e1338.y;
                                                }
                                                let _e1348 = phi_1968_;
                                                if (_e1336 < _e1338.z) {
                                                    phi_1975_ = _e1336;
                                                } else {
                                                    phi_1975_ = _e1338.z;
                                                }
                                                let _e1353 = phi_1975_;
                                                let _e1355 = triangles.member[(0u + _e1015)].v0_;
                                                let _e1357 = triangles.member[(0u + _e1015)].v1_;
                                                if (_e1355.x > _e1357.x) {
                                                    phi_1988_ = _e1355.x;
                                                } else {
                                                    phi_1988_ = _e1357.x;
                                                }
                                                let _e1364 = phi_1988_;
                                                if (_e1355.y > _e1357.y) {
                                                    phi_1997_ = _e1355.y;
                                                } else {
                                                    phi_1997_ = _e1357.y;
                                                }
                                                let _e1371 = phi_1997_;
                                                if (_e1355.z > _e1357.z) {
                                                    phi_2006_ = _e1355.z;
                                                } else {
                                                    phi_2006_ = _e1357.z;
                                                }
                                                let _e1378 = phi_2006_;
                                                let _e1380 = triangles.member[(0u + _e1015)].v2_;
                                                if (_e1364 > _e1380.x) {
                                                    phi_2015_ = _e1364;
                                                } else {
                                                    phi_2015_ = _e1380.x;
                                                }
                                                let _e1385 = phi_2015_;
                                                if (_e1371 > _e1380.y) {
                                                    phi_2022_ = _e1371;
                                                } else {
                                                    phi_2022_ = _e1380.y;
                                                }
                                                let _e1390 = phi_2022_;
                                                if (_e1378 > _e1380.z) {
                                                    phi_2029_ = _e1378;
                                                } else {
                                                    phi_2029_ = _e1380.z;
                                                }
                                                let _e1395 = phi_2029_;
                                                let _e1402 = ((_e1343 - _e156.origin.x) * _e302);
                                                let _e1403 = ((_e1348 - _e156.origin.y) * _e313);
                                                let _e1404 = ((_e1353 - _e156.origin.z) * _e324);
                                                let _e1411 = ((_e1385 - _e156.origin.x) * _e302);
                                                let _e1412 = ((_e1390 - _e156.origin.y) * _e313);
                                                let _e1413 = ((_e1395 - _e156.origin.z) * _e324);
                                                if (_e1402 < _e1411) {
                                                    phi_2052_ = _e1402;
                                                } else {
                                                    phi_2052_ = _e1411;
                                                }
                                                let _e1416 = phi_2052_;
                                                if (_e1403 < _e1412) {
                                                    phi_2057_ = _e1403;
                                                } else {
                                                    phi_2057_ = _e1412;
                                                }
                                                let _e1419 = phi_2057_;
                                                if (_e1404 < _e1413) {
                                                    phi_2062_ = _e1404;
                                                } else {
                                                    phi_2062_ = _e1413;
                                                }
                                                let _e1422 = phi_2062_;
                                                if (_e1402 > _e1411) {
                                                    phi_2070_ = _e1402;
                                                } else {
                                                    phi_2070_ = _e1411;
                                                }
                                                let _e1428 = phi_2070_;
                                                if (_e1403 > _e1412) {
                                                    phi_2075_ = _e1403;
                                                } else {
                                                    phi_2075_ = _e1412;
                                                }
                                                let _e1431 = phi_2075_;
                                                if (_e1404 > _e1413) {
                                                    phi_2080_ = _e1404;
                                                } else {
                                                    phi_2080_ = _e1413;
                                                }
                                                let _e1434 = phi_2080_;
                                                let _e1438 = core_intrinsics_maximum_number_nsz_f32_((_e1416 - _e369), (_e1419 - _e370));
                                                let _e1439 = core_intrinsics_maximum_number_nsz_f32_(_e1438, (_e1422 - _e371));
                                                let _e1440 = core_intrinsics_minimum_number_nsz_f32_((_e1428 + _e369), (_e1431 + _e370));
                                                let _e1441 = core_intrinsics_minimum_number_nsz_f32_(_e1440, (_e1434 + _e371));
                                                if (_e1439 > -300000000000000000000000000000000000000f) {
                                                    phi_2092_ = _e1439;
                                                } else {
                                                    phi_2092_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1444 = phi_2092_;
                                                if (_e1441 < 300000000000000000000000000000000000000f) {
                                                    phi_2097_ = _e1441;
                                                } else {
                                                    phi_2097_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1447 = phi_2097_;
                                                if (_e1307 < _e1444) {
                                                    phi_2102_ = _e1444;
                                                } else {
                                                    phi_2102_ = _e1307;
                                                }
                                                let _e1450 = phi_2102_;
                                                if (_e1450 > _e1447) {
                                                    phi_2107_ = _e1447;
                                                } else {
                                                    phi_2107_ = _e1450;
                                                }
                                                let _e1453 = phi_2107_;
                                                phi_2112_ = lt_bvh_triangle_Intersection(_e1453, (_e1146 / _e1205), (_e1167 / _e1205), (_e1444 <= _e1447));
                                                phi_2113_ = false;
                                            } else {
                                                phi_2112_ = lt_bvh_triangle_Intersection();
                                                phi_2113_ = true;
                                            }
                                            let _e1459 = phi_2112_;
                                            let _e1461 = phi_2113_;
                                            phi_2114_ = _e1459;
                                            phi_2115_ = _e1461;
                                        } else {
                                            phi_2114_ = lt_bvh_triangle_Intersection();
                                            phi_2115_ = true;
                                        }
                                        let _e1463 = phi_2114_;
                                        let _e1465 = phi_2115_;
                                        if _e1465 {
                                        }
                                        phi_2119_ = _e1463;
                                        phi_2120_ = _e1465;
                                    }
                                    let _e1467 = phi_2119_;
                                    let _e1469 = phi_2120_;
                                    phi_2121_ = _e1467;
                                    phi_2122_ = _e1208;
                                    phi_2123_ = _e1469;
                                } else {
                                    phi_2121_ = lt_bvh_triangle_Intersection();
                                    phi_2122_ = true;
                                    phi_2123_ = false;
                                }
                                let _e1471 = phi_2121_;
                                let _e1473 = phi_2122_;
                                let _e1475 = phi_2123_;
                                if _e1473 {
                                    phi_2127_ = true;
                                } else {
                                    phi_2127_ = _e1475;
                                }
                                let _e1477 = phi_2127_;
                                if _e1477 {
                                    phi_2131_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_2131_ = _e1471;
                                }
                                let _e1479 = phi_2131_;
                                if _e1479.is_hit {
                                    if (_e1479.t > _e156.tmin) {
                                        if (_e1479.t < _e1004.t) {
                                            phi_2180_ = true;
                                        } else {
                                            if (_e1479.t == _e1004.t) {
                                                if (_e1004.triangle != 4294967295u) {
                                                    if (_e1015 < _e1004.triangle) {
                                                        phi_2171_ = true;
                                                    } else {
                                                        if (_e1015 == _e1004.triangle) {
                                                            phi_2170_ = (4294967295u < _e1004.instance);
                                                        } else {
                                                            phi_2170_ = false;
                                                        }
                                                        let _e1498 = phi_2170_;
                                                        phi_2171_ = _e1498;
                                                    }
                                                    let _e1500 = phi_2171_;
                                                    phi_2172_ = _e1500;
                                                    phi_2173_ = false;
                                                } else {
                                                    phi_2172_ = bool();
                                                    phi_2173_ = true;
                                                }
                                                let _e1502 = phi_2172_;
                                                let _e1504 = phi_2173_;
                                                phi_2174_ = _e1502;
                                                phi_2175_ = _e1504;
                                            } else {
                                                phi_2174_ = bool();
                                                phi_2175_ = true;
                                            }
                                            let _e1506 = phi_2174_;
                                            let _e1508 = phi_2175_;
                                            if _e1508 {
                                                phi_2179_ = false;
                                            } else {
                                                phi_2179_ = _e1506;
                                            }
                                            let _e1510 = phi_2179_;
                                            phi_2180_ = _e1510;
                                        }
                                        let _e1512 = phi_2180_;
                                        if _e1512 {
                                            let _e1514 = triangles.member[(0u + _e1015)].i0_;
                                            if ((_e1514 & 2147483648u) == 0u) {
                                                phi_2391_ = true;
                                            } else {
                                                if (_e1015 < _e80) {
                                                } else {
                                                    return;
                                                }
                                                let _e1523 = triangles.member[(0u + _e1015)].i0_;
                                                let _e1524 = (_e1523 & 2147483647u);
                                                let _e1526 = triangles.member[(0u + _e1015)].i1_;
                                                let _e1528 = triangles.member[(0u + _e1015)].i2_;
                                                if (_e1524 < _e83) {
                                                } else {
                                                    return;
                                                }
                                                let _e1532 = vertices.member[(0u + _e1524)];
                                                if (_e1526 < _e83) {
                                                } else {
                                                    return;
                                                }
                                                let _e1536 = vertices.member[(0u + _e1526)];
                                                if (_e1528 < _e83) {
                                                } else {
                                                    return;
                                                }
                                                let _e1540 = vertices.member[(0u + _e1528)];
                                                let _e1541 = array<abi_Vertex, 3>(_e1532, _e1536, _e1540);
                                                if (_e1541[0].material < _e86) {
                                                } else {
                                                    return;
                                                }
                                                let _e1547 = materials.member[(0u + _e1541[0].material)];
                                                if ((_e1547.flags & 0u) == 0u) {
                                                    let _e1552 = ((1f - _e1479.u) - _e1479.v);
                                                    if (_e1547.cutoff <= 0f) {
                                                        phi_2386_ = true;
                                                    } else {
                                                        let _e1579 = (_e1547.base_color.w * ((((f32((_e1541[0].color >> bitcast<u32>(24i))) * _e1552) + (f32((_e1541[1].color >> bitcast<u32>(24i))) * _e1479.u)) + (f32((_e1541[2].color >> bitcast<u32>(24i))) * _e1479.v)) * (1f / 255f)));
                                                        if (_e1547.alpha_size == 0u) {
                                                            phi_2383_ = _e1579;
                                                        } else {
                                                            local_1.offset = _e1547.alpha_offset;
                                                            local_1.size = _e1547.alpha_size;
                                                            local_1.flags = _e1547.flags;
                                                            let _e1610 = _lt_shaders_texture_TextureView_quad((&local_1), (((_e1541[0].u * _e1552) + (_e1541[1].u * _e1479.u)) + (_e1541[2].u * _e1479.v)), (((_e1541[0].v * _e1552) + (_e1541[1].v * _e1479.u)) + (_e1541[2].v * _e1479.v)));
                                                            let _e1614 = (_e1610.indices[0] >> bitcast<u32>(2i));
                                                            if (_e1614 < _e92) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1618 = alpha_texels.member[(0u + _e1614)];
                                                            let _e1634 = (_e1610.indices[1] >> bitcast<u32>(2i));
                                                            if (_e1634 < _e92) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1638 = alpha_texels.member[(0u + _e1634)];
                                                            let _e1655 = (_e1610.indices[2] >> bitcast<u32>(2i));
                                                            if (_e1655 < _e92) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1659 = alpha_texels.member[(0u + _e1655)];
                                                            let _e1676 = (_e1610.indices[3] >> bitcast<u32>(2i));
                                                            if (_e1676 < _e92) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1680 = alpha_texels.member[(0u + _e1676)];
                                                            phi_2383_ = (_e1579 * (((((f32(((_e1618 >> bitcast<u32>((((_e1610.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1610.weights.x) + ((f32(((_e1638 >> bitcast<u32>((((_e1610.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1610.weights.y)) + ((f32(((_e1659 >> bitcast<u32>((((_e1610.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1610.weights.z)) + ((f32(((_e1680 >> bitcast<u32>((((_e1610.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1610.weights.w)));
                                                        }
                                                        let _e1696 = phi_2383_;
                                                        phi_2386_ = (_e1696 >= _e1547.cutoff);
                                                    }
                                                    let _e1700 = phi_2386_;
                                                    phi_2387_ = _e1700;
                                                } else {
                                                    phi_2387_ = false;
                                                }
                                                let _e1702 = phi_2387_;
                                                if _e1702 {
                                                }
                                                phi_2391_ = _e1702;
                                            }
                                            let _e1704 = phi_2391_;
                                            if _e1704 {
                                                phi_2399_ = lt_bvh_Hit(_e1479.t, _e1479.u, _e1479.v, _e1015, 4294967295u);
                                            } else {
                                                phi_2399_ = _e1004;
                                            }
                                            let _e1710 = phi_2399_;
                                            phi_2400_ = _e1710;
                                        } else {
                                            phi_2400_ = _e1004;
                                        }
                                        let _e1712 = phi_2400_;
                                        phi_2401_ = _e1712;
                                    } else {
                                        phi_2401_ = _e1004;
                                    }
                                    let _e1714 = phi_2401_;
                                    phi_2402_ = _e1714;
                                } else {
                                    phi_2402_ = _e1004;
                                }
                                let _e1716 = phi_2402_;
                                phi_1545_ = _e1716;
                                phi_1548_ = (_e1006 & (_e1006 - 1u));
                                phi_2403_ = true;
                            }
                            let _e1718 = phi_1545_;
                            let _e1720 = phi_1548_;
                            let _e1722 = phi_2403_;
                            continue;
                            continuing {
                                phi_1544_ = _e1718;
                                phi_1547_ = _e1720;
                                break if !(_e1722);
                            }
                        }
                        let _e1725 = local_2.group_mask;
                        if ((_e1725 & 4278190080u) == 0u) {
                            let _e1729 = local_2.len;
                            if (_e1729 == 0u) {
                                phi_2442_ = false;
                            } else {
                                let _e1733 = local_2.len;
                                local_2.len = (_e1733 - 1u);
                                let _e1736 = local_2.len;
                                if (_e1736 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1741 = local_2.first[(0u + _e1736)];
                                local_2.group = _e1741;
                                let _e1744 = local_2.len;
                                if (_e1744 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1749 = local_2.mask[(0u + _e1744)];
                                local_2.group_mask = _e1749;
                                phi_2442_ = true;
                            }
                            let _e1752 = phi_2442_;
                            phi_2443_ = _e1752;
                        } else {
                            phi_2443_ = true;
                        }
                        let _e1754 = phi_2443_;
                        if _e1754 {
                            let _e1756 = local_2.group_mask;
                            let _e1762 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1756)), 32u, (_e1756 == 0u)));
                            let _e1766 = local_2.group_mask;
                            let _e1780 = local_2.group_mask;
                            local_2.group_mask = (_e1780 & ~((1u << bitcast<u32>((_e1762 & 31u)))));
                            let _e1783 = local_2.group;
                            phi_2474_ = (_e1783 + countOneBits(((_e1766 & ~((4294967295u << bitcast<u32>((((_e1762 - 24u) ^ _e423) & 31u))))) & 255u)));
                        } else {
                            phi_2474_ = 4294967295u;
                        }
                        let _e1786 = phi_2474_;
                        let _e2631 = local_6;
                        phi_1208_ = _e2631;
                        phi_1211_ = _e1786;
                    } else {
                        phi_1208_ = lt_bvh_Hit();
                        phi_1211_ = u32();
                    }
                    let _e1788 = phi_1208_;
                    let _e1790 = phi_1211_;
                    continue;
                    continuing {
                        phi_1207_ = _e1788;
                        phi_1210_ = _e1790;
                        break if !(_e564);
                    }
                }
                let _e2635 = local_7;
                phi_2475_ = _e2635;
            }
            let _e1793 = phi_2475_;
            phi_2476_ = _e1793;
            phi_2477_ = _e220;
        } else {
            phi_2476_ = lt_bvh_Hit();
            phi_2477_ = true;
        }
        let _e1795 = phi_2476_;
        let _e1797 = phi_2477_;
        if _e1797 {
            phi_2481_ = _e158;
        } else {
            phi_2481_ = _e1795;
        }
        let _e1799 = phi_2481_;
        if (_e1799.triangle != 4294967295u) {
            let _e1805 = ((1f - _e1799.u) - _e1799.v);
            if (_e1799.triangle < _e80) {
            } else {
                return;
            }
            let _e1810 = triangles.member[(0u + _e1799.triangle)];
            let _e1835 = (((_e1810.v0_.x * _e1805) + (_e1810.v1_.x * _e1799.u)) + (_e1810.v2_.x * _e1799.v));
            let _e1836 = (((_e1810.v0_.y * _e1805) + (_e1810.v1_.y * _e1799.u)) + (_e1810.v2_.y * _e1799.v));
            let _e1837 = (((_e1810.v0_.z * _e1805) + (_e1810.v1_.z * _e1799.u)) + (_e1810.v2_.z * _e1799.v));
            let _e1840 = abs(_e1810.v0_.x);
            let _e1842 = abs(_e1810.v0_.y);
            let _e1844 = abs(_e1810.v0_.z);
            let _e1846 = abs(_e1810.v1_.x);
            let _e1848 = abs(_e1810.v1_.y);
            let _e1850 = abs(_e1810.v1_.z);
            if (_e1840 > _e1846) {
                phi_2545_ = _e1840;
            } else {
                phi_2545_ = _e1846;
            }
            let _e1853 = phi_2545_;
            if (_e1842 > _e1848) {
                phi_2550_ = _e1842;
            } else {
                phi_2550_ = _e1848;
            }
            let _e1856 = phi_2550_;
            if (_e1844 > _e1850) {
                phi_2555_ = _e1844;
            } else {
                phi_2555_ = _e1850;
            }
            let _e1859 = phi_2555_;
            let _e1861 = abs(_e1810.v2_.x);
            let _e1863 = abs(_e1810.v2_.y);
            let _e1865 = abs(_e1810.v2_.z);
            if (_e1853 > _e1861) {
                phi_2566_ = _e1853;
            } else {
                phi_2566_ = _e1861;
            }
            let _e1868 = phi_2566_;
            if (_e1856 > _e1863) {
                phi_2571_ = _e1856;
            } else {
                phi_2571_ = _e1863;
            }
            let _e1871 = phi_2571_;
            if (_e1859 > _e1865) {
                phi_2576_ = _e1859;
            } else {
                phi_2576_ = _e1865;
            }
            let _e1874 = phi_2576_;
            let _e1877 = (_e1810.v1_.x - _e1810.v0_.x);
            let _e1880 = (_e1810.v1_.y - _e1810.v0_.y);
            let _e1883 = (_e1810.v1_.z - _e1810.v0_.z);
            let _e1886 = (_e1810.v2_.x - _e1810.v0_.x);
            let _e1889 = (_e1810.v2_.y - _e1810.v0_.y);
            let _e1892 = (_e1810.v2_.z - _e1810.v0_.z);
            let _e1896 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1880), abs(_e1883));
            let _e1897 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1877), _e1896);
            let _e1898 = (_e1877 / _e1897);
            let _e1899 = (_e1880 / _e1897);
            let _e1900 = (_e1883 / _e1897);
            let _e1904 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1889), abs(_e1892));
            let _e1905 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1886), _e1904);
            let _e1906 = (_e1886 / _e1905);
            let _e1907 = (_e1889 / _e1905);
            let _e1908 = (_e1892 / _e1905);
            let _e1911 = ((_e1899 * _e1908) - (_e1907 * _e1900));
            let _e1914 = ((_e1900 * _e1906) - (_e1908 * _e1898));
            let _e1917 = ((_e1898 * _e1907) - (_e1906 * _e1899));
            let _e1919 = p.member.eye;
            let _e1932 = (1f / sqrt((((_e1911 * _e1911) + (_e1914 * _e1914)) + (_e1917 * _e1917))));
            let _e1933 = (_e1911 * _e1932);
            let _e1934 = (_e1914 * _e1932);
            let _e1935 = (_e1917 * _e1932);
            if ((((_e1933 * (_e1919.x - _e1835)) + (_e1934 * (_e1919.y - _e1836))) + (_e1935 * (_e1919.z - _e1837))) < 0f) {
                phi_2652_ = vec3<f32>(-(_e1933), -(_e1934), -(_e1935));
            } else {
                phi_2652_ = vec3<f32>(_e1933, _e1934, _e1935);
            }
            let _e1948 = phi_2652_;
            if (_e1799.triangle < _e80) {
            } else {
                return;
            }
            let _e1953 = triangles.member[(0u + _e1799.triangle)];
            let _e1955 = (_e1953.i0_ & 2147483647u);
            if (_e1955 < _e83) {
            } else {
                return;
            }
            let _e1961 = vertices.member[(0u + _e1955)];
            if (_e1953.i1_ < _e83) {
            } else {
                return;
            }
            let _e1965 = vertices.member[(0u + _e1953.i1_)];
            if (_e1953.i2_ < _e83) {
            } else {
                return;
            }
            let _e1969 = vertices.member[(0u + _e1953.i2_)];
            let _e1970 = array<abi_Vertex, 3>(_e1961, _e1965, _e1969);
            if (_e1970[0].material < _e86) {
            } else {
                return;
            }
            let _e1976 = materials.member[(0u + _e1970[0].material)];
            let _e1993 = (1f / 255f);
            let _e2012 = (1f / 255f);
            let _e2034 = (1f / 255f);
            if (_e1976.color_size == 0u) {
                phi_2895_ = vec3<f32>(1f, 1f, 1f);
            } else {
                local.offset = _e1976.color_offset;
                local.size = _e1976.color_size;
                local.flags = _e1976.flags;
                let _e2077 = _lt_shaders_texture_TextureView_quad((&local), (((_e1970[0].u * _e1805) + (_e1970[1].u * _e1799.u)) + (_e1970[2].u * _e1799.v)), (((_e1970[0].v * _e1805) + (_e1970[1].v * _e1799.u)) + (_e1970[2].v * _e1799.v)));
                if (_e2077.indices[0] < _e95) {
                } else {
                    return;
                }
                let _e2083 = color_texels.member[(0u + _e2077.indices[0])];
                let _e2094 = (1f / 255f);
                if (_e2077.indices[1] < _e95) {
                } else {
                    return;
                }
                let _e2108 = color_texels.member[(0u + _e2077.indices[1])];
                let _e2119 = (1f / 255f);
                if (_e2077.indices[2] < _e95) {
                } else {
                    return;
                }
                let _e2136 = color_texels.member[(0u + _e2077.indices[2])];
                let _e2147 = (1f / 255f);
                if (_e2077.indices[3] < _e95) {
                } else {
                    return;
                }
                let _e2164 = color_texels.member[(0u + _e2077.indices[3])];
                let _e2175 = (1f / 255f);
                let _e2184 = (((((f32((_e2083 & 255u)) * _e2094) * _e2077.weights.x) + ((f32((_e2108 & 255u)) * _e2119) * _e2077.weights.y)) + ((f32((_e2136 & 255u)) * _e2147) * _e2077.weights.z)) + ((f32((_e2164 & 255u)) * _e2175) * _e2077.weights.w));
                let _e2185 = (((((f32(((_e2083 >> bitcast<u32>(8i)) & 255u)) * _e2094) * _e2077.weights.x) + ((f32(((_e2108 >> bitcast<u32>(8i)) & 255u)) * _e2119) * _e2077.weights.y)) + ((f32(((_e2136 >> bitcast<u32>(8i)) & 255u)) * _e2147) * _e2077.weights.z)) + ((f32(((_e2164 >> bitcast<u32>(8i)) & 255u)) * _e2175) * _e2077.weights.w));
                let _e2186 = (((((f32(((_e2083 >> bitcast<u32>(16i)) & 255u)) * _e2094) * _e2077.weights.x) + ((f32(((_e2108 >> bitcast<u32>(16i)) & 255u)) * _e2119) * _e2077.weights.y)) + ((f32(((_e2136 >> bitcast<u32>(16i)) & 255u)) * _e2147) * _e2077.weights.z)) + ((f32(((_e2164 >> bitcast<u32>(16i)) & 255u)) * _e2175) * _e2077.weights.w));
                phi_2895_ = vec3<f32>((_e2184 * _e2184), (_e2185 * _e2185), (_e2186 * _e2186));
            }
            let _e2192 = phi_2895_;
            let _e2194 = ((_e1976.base_color.x * ((((f32((_e1970[0].color & 255u)) * _e1993) * _e1805) + ((f32((_e1970[1].color & 255u)) * _e2012) * _e1799.u)) + ((f32((_e1970[2].color & 255u)) * _e2034) * _e1799.v))) * _e2192.x);
            let _e2196 = ((_e1976.base_color.y * ((((f32(((_e1970[0].color >> bitcast<u32>(8i)) & 255u)) * _e1993) * _e1805) + ((f32(((_e1970[1].color >> bitcast<u32>(8i)) & 255u)) * _e2012) * _e1799.u)) + ((f32(((_e1970[2].color >> bitcast<u32>(8i)) & 255u)) * _e2034) * _e1799.v))) * _e2192.y);
            let _e2198 = ((_e1976.base_color.z * ((((f32(((_e1970[0].color >> bitcast<u32>(16i)) & 255u)) * _e1993) * _e1805) + ((f32(((_e1970[1].color >> bitcast<u32>(16i)) & 255u)) * _e2012) * _e1799.u)) + ((f32(((_e1970[2].color >> bitcast<u32>(16i)) & 255u)) * _e2034) * _e1799.v))) * _e2192.z);
            let _e2199 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1871, _e1874);
            let _e2200 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1868, _e2199);
            if ((_e1976.flags & 2u) == 0u) {
                phi_2910_ = 0u;
            } else {
                phi_2910_ = 1u;
            }
            let _e2205 = phi_2910_;
            if (_e1970[0].normal == 2147516416u) {
                phi_3113_ = _e1948;
            } else {
                let _e2218 = (f32((bitcast<i32>((_e1970[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2224 = (f32((bitcast<i32>(_e1970[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2228 = ((1f - abs(_e2218)) - abs(_e2224));
                if (_e2228 < 0f) {
                    phi_2937_ = -(_e2228);
                } else {
                    phi_2937_ = 0f;
                }
                let _e2232 = phi_2937_;
                if (_e2218 < 0f) {
                    phi_2944_ = (_e2218 + _e2232);
                } else {
                    phi_2944_ = (_e2218 - _e2232);
                }
                let _e2237 = phi_2944_;
                if (_e2224 < 0f) {
                    phi_2951_ = (_e2224 + _e2232);
                } else {
                    phi_2951_ = (_e2224 - _e2232);
                }
                let _e2242 = phi_2951_;
                let _e2249 = (1f / sqrt((((_e2237 * _e2237) + (_e2242 * _e2242)) + (_e2228 * _e2228))));
                let _e2265 = (f32((bitcast<i32>((_e1970[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2271 = (f32((bitcast<i32>(_e1970[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2275 = ((1f - abs(_e2265)) - abs(_e2271));
                if (_e2275 < 0f) {
                    phi_2986_ = -(_e2275);
                } else {
                    phi_2986_ = 0f;
                }
                let _e2279 = phi_2986_;
                if (_e2265 < 0f) {
                    phi_2993_ = (_e2265 + _e2279);
                } else {
                    phi_2993_ = (_e2265 - _e2279);
                }
                let _e2284 = phi_2993_;
                if (_e2271 < 0f) {
                    phi_3000_ = (_e2271 + _e2279);
                } else {
                    phi_3000_ = (_e2271 - _e2279);
                }
                let _e2289 = phi_3000_;
                let _e2296 = (1f / sqrt((((_e2284 * _e2284) + (_e2289 * _e2289)) + (_e2275 * _e2275))));
                let _e2315 = (f32((bitcast<i32>((_e1970[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2321 = (f32((bitcast<i32>(_e1970[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2325 = ((1f - abs(_e2315)) - abs(_e2321));
                if (_e2325 < 0f) {
                    phi_3038_ = -(_e2325);
                } else {
                    phi_3038_ = 0f;
                }
                let _e2329 = phi_3038_;
                if (_e2315 < 0f) {
                    phi_3045_ = (_e2315 + _e2329);
                } else {
                    phi_3045_ = (_e2315 - _e2329);
                }
                let _e2334 = phi_3045_;
                if (_e2321 < 0f) {
                    phi_3052_ = (_e2321 + _e2329);
                } else {
                    phi_3052_ = (_e2321 - _e2329);
                }
                let _e2339 = phi_3052_;
                let _e2346 = (1f / sqrt((((_e2334 * _e2334) + (_e2339 * _e2339)) + (_e2325 * _e2325))));
                let _e2357 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(vec3<f32>(((((_e2237 * _e2249) * _e1805) + ((_e2284 * _e2296) * _e1799.u)) + ((_e2334 * _e2346) * _e1799.v)), ((((_e2242 * _e2249) * _e1805) + ((_e2289 * _e2296) * _e1799.u)) + ((_e2339 * _e2346) * _e1799.v)), ((((_e2228 * _e2249) * _e1805) + ((_e2275 * _e2296) * _e1799.u)) + ((_e2325 * _e2346) * _e1799.v))));
                let _e2369 = sqrt((((_e2357.x * _e2357.x) + (_e2357.y * _e2357.y)) + (_e2357.z * _e2357.z)));
                if (_e2369 > 0f) {
                    let _e2372 = (_e2357.x / _e2369);
                    let _e2374 = (_e2357.y / _e2369);
                    let _e2376 = (_e2357.z / _e2369);
                    if ((((_e2372 * _e1948.x) + (_e2374 * _e1948.y)) + (_e2376 * _e1948.z)) < 0f) {
                        phi_3111_ = vec3<f32>(-(_e2372), -(_e2374), -(_e2376));
                    } else {
                        phi_3111_ = (_e2357 / vec3(_e2369));
                    }
                    let _e2393 = phi_3111_;
                    phi_3112_ = _e2393;
                } else {
                    phi_3112_ = _e1948;
                }
                let _e2395 = phi_3112_;
                phi_3113_ = _e2395;
            }
            let _e2397 = phi_3113_;
            if (_e2194 > 0f) {
                if (_e2194 < 1f) {
                    phi_3122_ = _e2194;
                } else {
                    phi_3122_ = 1f;
                }
                let _e2401 = phi_3122_;
                phi_3123_ = _e2401;
            } else {
                phi_3123_ = 0f;
            }
            let _e2403 = phi_3123_;
            if (_e2196 > 0f) {
                if (_e2196 < 1f) {
                    phi_3133_ = _e2196;
                } else {
                    phi_3133_ = 1f;
                }
                let _e2408 = phi_3133_;
                phi_3134_ = _e2408;
            } else {
                phi_3134_ = 0f;
            }
            let _e2410 = phi_3134_;
            if (_e2198 > 0f) {
                if (_e2198 < 1f) {
                    phi_3144_ = _e2198;
                } else {
                    phi_3144_ = 1f;
                }
                let _e2415 = phi_3144_;
                phi_3145_ = _e2415;
            } else {
                phi_3145_ = 0f;
            }
            let _e2417 = phi_3145_;
            let _e2420 = ((sqrt(_e2403) * 255f) + 0.5f);
            let _e2429 = ((sqrt(_e2410) * 255f) + 0.5f);
            let _e2441 = ((sqrt(_e2417) * 255f) + 0.5f);
            phi_3180_ = abi_Sample(vec3<f32>(_e1835, _e1836, _e1837), _e2200, _e1948, _e2205, _e2397, ((select(select(u32(_e2420), 0u, (_e2420 < bitcast<f32>(0u))), 4294967295u, (_e2420 > bitcast<f32>(1333788671u))) | (select(select(u32(_e2429), 0u, (_e2429 < bitcast<f32>(0u))), 4294967295u, (_e2429 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e2441), 0u, (_e2441 < bitcast<f32>(0u))), 4294967295u, (_e2441 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_3180_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e2455 = phi_3180_;
        if (_e101.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e101.shift)] = _e2455;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_alpha_color_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
