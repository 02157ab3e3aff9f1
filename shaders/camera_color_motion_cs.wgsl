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
    var phi_786_: bool;
    var phi_787_: bool;
    var phi_788_: bool;
    var phi_792_: bool;
    var phi_793_: bool;
    var phi_794_: bool;
    var phi_795_: bool;
    var phi_796_: bool;
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
    var phi_813_: bool;
    var phi_817_: bool;
    var phi_892_: f32;
    var phi_899_: f32;
    var phi_907_: f32;
    var phi_914_: f32;
    var phi_922_: f32;
    var phi_929_: f32;
    var phi_954_: f32;
    var phi_959_: f32;
    var phi_964_: f32;
    var phi_997_: bool;
    var phi_998_: bool;
    var phi_1006_: u32;
    var phi_1007_: u32;
    var phi_1025_: vec3<f32>;
    var phi_1026_: vec3<f32>;
    var phi_1040_: u32;
    var phi_1045_: u32;
    var phi_1050_: u32;
    var phi_1164_: bool;
    var phi_1165_: bool;
    var phi_1196_: u32;
    var phi_1198_: lt_bvh_Hit;
    var phi_1201_: u32;
    var phi_1286_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1313_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1340_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1346_: u32;
    var phi_1349_: u32;
    var phi_1363_: u32;
    var phi_1373_: u32;
    var phi_1383_: u32;
    var phi_1401_: u32;
    var phi_1411_: u32;
    var phi_1421_: u32;
    var phi_1457_: u32;
    var phi_1470_: u32;
    var phi_1475_: u32;
    var phi_1476_: u32;
    var phi_1477_: u32;
    var phi_1347_: u32;
    var phi_1350_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_1535_: lt_bvh_Hit;
    var phi_1538_: u32;
    var phi_1584_: vec3<f32>;
    var phi_1585_: vec3<f32>;
    var phi_1616_: vec3<f32>;
    var phi_1617_: vec3<f32>;
    var phi_1648_: vec3<f32>;
    var phi_1649_: vec3<f32>;
    var phi_1667_: bool;
    var phi_1668_: bool;
    var phi_1672_: f32;
    var phi_1673_: f32;
    var phi_1674_: f32;
    var phi_1675_: f32;
    var phi_1683_: f32;
    var phi_1693_: bool;
    var phi_1694_: bool;
    var phi_1698_: f32;
    var phi_1699_: f32;
    var phi_1700_: f32;
    var phi_1701_: f32;
    var phi_1709_: f32;
    var phi_1719_: bool;
    var phi_1720_: bool;
    var phi_1724_: f32;
    var phi_1725_: f32;
    var phi_1726_: f32;
    var phi_1727_: f32;
    var phi_1735_: f32;
    var phi_1750_: f32;
    var phi_1751_: bool;
    var phi_1752_: f32;
    var phi_1753_: bool;
    var phi_1754_: f32;
    var phi_1755_: bool;
    var phi_1773_: f32;
    var phi_1774_: bool;
    var phi_1775_: bool;
    var phi_1776_: f32;
    var phi_1777_: bool;
    var phi_1778_: bool;
    var phi_1782_: bool;
    var phi_1783_: f32;
    var phi_1784_: bool;
    var phi_1814_: vec3<f32>;
    var phi_1815_: vec3<f32>;
    var phi_1840_: vec3<f32>;
    var phi_1841_: vec3<f32>;
    var phi_1866_: vec3<f32>;
    var phi_1867_: vec3<f32>;
    var phi_1925_: f32;
    var phi_1934_: f32;
    var phi_1943_: f32;
    var phi_1952_: f32;
    var phi_1959_: f32;
    var phi_1966_: f32;
    var phi_1979_: f32;
    var phi_1988_: f32;
    var phi_1997_: f32;
    var phi_2006_: f32;
    var phi_2013_: f32;
    var phi_2020_: f32;
    var phi_2043_: f32;
    var phi_2048_: f32;
    var phi_2053_: f32;
    var phi_2061_: f32;
    var phi_2066_: f32;
    var phi_2071_: f32;
    var phi_2083_: f32;
    var phi_2088_: f32;
    var phi_2093_: f32;
    var phi_2098_: f32;
    var phi_2103_: lt_bvh_triangle_Intersection;
    var phi_2104_: bool;
    var phi_2105_: lt_bvh_triangle_Intersection;
    var phi_2106_: bool;
    var phi_2110_: lt_bvh_triangle_Intersection;
    var phi_2111_: bool;
    var phi_2112_: lt_bvh_triangle_Intersection;
    var phi_2113_: bool;
    var phi_2114_: bool;
    var phi_2118_: bool;
    var phi_2122_: lt_bvh_triangle_Intersection;
    var phi_2161_: bool;
    var phi_2162_: bool;
    var phi_2163_: bool;
    var phi_2164_: bool;
    var phi_2165_: bool;
    var phi_2166_: bool;
    var phi_2170_: bool;
    var phi_2171_: bool;
    var phi_2185_: bool;
    var phi_2193_: lt_bvh_Hit;
    var phi_2194_: lt_bvh_Hit;
    var phi_2195_: lt_bvh_Hit;
    var phi_2196_: lt_bvh_Hit;
    var phi_1536_: lt_bvh_Hit;
    var phi_1539_: u32;
    var phi_2197_: bool;
    var phi_2236_: bool;
    var phi_2237_: bool;
    var phi_2268_: u32;
    var phi_1199_: lt_bvh_Hit;
    var phi_1202_: u32;
    var phi_2269_: lt_bvh_Hit;
    var phi_2270_: lt_bvh_Hit;
    var phi_2271_: bool;
    var phi_2275_: lt_bvh_Hit;
    var phi_2339_: f32;
    var phi_2344_: f32;
    var phi_2349_: f32;
    var phi_2360_: f32;
    var phi_2365_: f32;
    var phi_2370_: f32;
    var phi_2446_: vec3<f32>;
    var phi_2689_: vec3<f32>;
    var phi_2704_: u32;
    var phi_2731_: f32;
    var phi_2738_: f32;
    var phi_2745_: f32;
    var phi_2780_: f32;
    var phi_2787_: f32;
    var phi_2794_: f32;
    var phi_2832_: f32;
    var phi_2839_: f32;
    var phi_2846_: f32;
    var phi_2905_: vec3<f32>;
    var phi_2906_: vec3<f32>;
    var phi_2907_: vec3<f32>;
    var phi_2916_: f32;
    var phi_2917_: f32;
    var phi_2927_: f32;
    var phi_2928_: f32;
    var phi_2938_: f32;
    var phi_2939_: f32;
    var phi_2974_: abi_Sample;
    var phi_3065_: vec3<f32>;
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
        let _e170 = abs(_e158.direction.x);
        let _e172 = abs(_e158.direction.y);
        let _e174 = abs(_e158.direction.z);
        if (abs(_e158.origin.x) < 1000000000000000f) {
            if (abs(_e158.origin.y) < 1000000000000000f) {
                if (abs(_e158.origin.z) < 1000000000000000f) {
                    if (_e170 < 1000000000000000f) {
                        if (_e172 < 1000000000000000f) {
                            if (_e174 < 1000000000000000f) {
                                if (_e170 > 0f) {
                                    phi_787_ = bool();
                                    phi_788_ = true;
                                } else {
                                    let _e182 = (_e172 > 0f);
                                    if _e182 {
                                        phi_786_ = bool();
                                    } else {
                                        phi_786_ = (_e174 > 0f);
                                    }
                                    let _e185 = phi_786_;
                                    phi_787_ = _e185;
                                    phi_788_ = _e182;
                                }
                                let _e187 = phi_787_;
                                let _e189 = phi_788_;
                                if _e189 {
                                    phi_792_ = true;
                                } else {
                                    phi_792_ = _e187;
                                }
                                let _e191 = phi_792_;
                                phi_793_ = _e191;
                                phi_794_ = false;
                            } else {
                                phi_793_ = bool();
                                phi_794_ = true;
                            }
                            let _e193 = phi_793_;
                            let _e195 = phi_794_;
                            phi_795_ = _e193;
                            phi_796_ = false;
                            phi_797_ = _e195;
                        } else {
                            phi_795_ = bool();
                            phi_796_ = true;
                            phi_797_ = false;
                        }
                        let _e197 = phi_795_;
                        let _e199 = phi_796_;
                        let _e201 = phi_797_;
                        phi_798_ = _e197;
                        phi_799_ = _e199;
                        phi_800_ = _e201;
                    } else {
                        phi_798_ = bool();
                        phi_799_ = true;
                        phi_800_ = false;
                    }
                    let _e203 = phi_798_;
                    let _e205 = phi_799_;
                    let _e207 = phi_800_;
                    phi_801_ = _e203;
                    phi_802_ = _e205;
                    phi_803_ = _e207;
                } else {
                    phi_801_ = bool();
                    phi_802_ = true;
                    phi_803_ = false;
                }
                let _e209 = phi_801_;
                let _e211 = phi_802_;
                let _e213 = phi_803_;
                phi_804_ = _e209;
                phi_805_ = _e211;
                phi_806_ = _e213;
            } else {
                phi_804_ = bool();
                phi_805_ = true;
                phi_806_ = false;
            }
            let _e215 = phi_804_;
            let _e217 = phi_805_;
            let _e219 = phi_806_;
            phi_807_ = _e215;
            phi_808_ = _e217;
            phi_809_ = _e219;
        } else {
            phi_807_ = bool();
            phi_808_ = true;
            phi_809_ = false;
        }
        let _e221 = phi_807_;
        let _e223 = phi_808_;
        let _e225 = phi_809_;
        if _e223 {
            phi_813_ = true;
        } else {
            phi_813_ = _e225;
        }
        let _e227 = phi_813_;
        if _e227 {
            phi_817_ = false;
        } else {
            phi_817_ = _e221;
        }
        let _e229 = phi_817_;
        if _e229 {
            let _e230 = (0u >= _e76);
            if _e230 {
                phi_2269_ = lt_bvh_Hit();
            } else {
                if (0u < _e76) {
                } else {
                    return;
                }
                let _e236 = nodes.member[(0u + 0u)].frame[0u];
                let _e240 = nodes.member[(0u + 0u)].frame[1u];
                let _e244 = nodes.member[(0u + 0u)].frame[2u];
                let _e248 = nodes.member[(0u + 0u)].frame[0u];
                let _e252 = nodes.member[(0u + 0u)].frame[1u];
                let _e256 = nodes.member[(0u + 0u)].frame[2u];
                let _e260 = nodes.member[(0u + 0u)].frame[3u];
                let _e298 = core_intrinsics_maximum_number_nsz_f32_(abs(_e158.direction.x), abs(_e158.direction.y));
                let _e299 = core_intrinsics_maximum_number_nsz_f32_(_e298, abs(_e158.direction.z));
                let _e300 = (_e299 * 0.0000000000009094947f);
                if (abs(_e158.direction.x) < _e300) {
                    phi_892_ = _e300;
                } else {
                    phi_892_ = abs(_e158.direction.x);
                }
                let _e306 = phi_892_;
                if (_e158.direction.x < 0f) {
                    phi_899_ = (-1f / _e306);
                } else {
                    phi_899_ = (1f / _e306);
                }
                let _e311 = phi_899_;
                if (abs(_e158.direction.y) < _e300) {
                    phi_907_ = _e300;
                } else {
                    phi_907_ = abs(_e158.direction.y);
                }
                let _e317 = phi_907_;
                if (_e158.direction.y < 0f) {
                    phi_914_ = (-1f / _e317);
                } else {
                    phi_914_ = (1f / _e317);
                }
                let _e322 = phi_914_;
                if (abs(_e158.direction.z) < _e300) {
                    phi_922_ = _e300;
                } else {
                    phi_922_ = abs(_e158.direction.z);
                }
                let _e328 = phi_922_;
                if (_e158.direction.z < 0f) {
                    phi_929_ = (-1f / _e328);
                } else {
                    phi_929_ = (1f / _e328);
                }
                let _e333 = phi_929_;
                let _e341 = abs((bitcast<f32>(_e236) - _e158.origin.x));
                let _e342 = abs((bitcast<f32>(_e240) - _e158.origin.y));
                let _e343 = abs((bitcast<f32>(_e244) - _e158.origin.z));
                let _e351 = abs(((bitcast<f32>(_e248) + (bitcast<f32>((((_e260 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e158.origin.x));
                let _e352 = abs(((bitcast<f32>(_e252) + (bitcast<f32>((((_e260 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e158.origin.y));
                let _e353 = abs(((bitcast<f32>(_e256) + (bitcast<f32>((((_e260 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e158.origin.z));
                if (_e341 > _e351) {
                    phi_954_ = _e341;
                } else {
                    phi_954_ = _e351;
                }
                let _e356 = phi_954_;
                if (_e342 > _e352) {
                    phi_959_ = _e342;
                } else {
                    phi_959_ = _e352;
                }
                let _e359 = phi_959_;
                if (_e343 > _e353) {
                    phi_964_ = _e343;
                } else {
                    phi_964_ = _e353;
                }
                let _e362 = phi_964_;
                let _e363 = core_intrinsics_maximum_number_nsz_f32_(_e356, _e359);
                let _e364 = core_intrinsics_maximum_number_nsz_f32_(_e363, _e362);
                let _e369 = (_e364 * 0.0000019073486f);
                let _e370 = (abs(_e311) * _e369);
                let _e371 = (abs(_e322) * _e369);
                let _e372 = (abs(_e333) * _e369);
                let _e376 = (_e364 * 0.0000009536743f);
                let _e377 = (abs(_e311) * _e376);
                let _e378 = (abs(_e322) * _e376);
                let _e379 = (abs(_e333) * _e376);
                let _e382 = abs(_e158.direction.x);
                let _e384 = abs(_e158.direction.y);
                let _e386 = abs(_e158.direction.z);
                if (_e382 >= _e384) {
                    if (_e382 >= _e386) {
                        phi_997_ = false;
                    } else {
                        phi_997_ = true;
                    }
                    let _e390 = phi_997_;
                    phi_998_ = _e390;
                } else {
                    phi_998_ = true;
                }
                let _e392 = phi_998_;
                if _e392 {
                    if (_e384 >= _e386) {
                        phi_1006_ = 1u;
                    } else {
                        phi_1006_ = 2u;
                    }
                    let _e395 = phi_1006_;
                    phi_1007_ = _e395;
                } else {
                    phi_1007_ = 0u;
                }
                let _e397 = phi_1007_;
                if (_e397 == 0u) {
                    phi_1026_ = vec3<f32>(_e158.direction.y, _e158.direction.z, _e158.direction.x);
                } else {
                    if (_e397 == 1u) {
                        phi_1025_ = vec3<f32>(_e158.direction.z, _e158.direction.x, _e158.direction.y);
                    } else {
                        phi_1025_ = _e158.direction;
                    }
                    let _e410 = phi_1025_;
                    phi_1026_ = _e410;
                }
                let _e412 = phi_1026_;
                let _e416 = (_e412.x / _e412.z);
                let _e419 = (_e412.y / _e412.z);
                if (_e311 < 0f) {
                    phi_1040_ = 0u;
                } else {
                    phi_1040_ = 1u;
                }
                let _e424 = phi_1040_;
                if (_e322 < 0f) {
                    phi_1045_ = 0u;
                } else {
                    phi_1045_ = 2u;
                }
                let _e427 = phi_1045_;
                if (_e333 < 0f) {
                    phi_1050_ = 0u;
                } else {
                    phi_1050_ = 4u;
                }
                let _e430 = phi_1050_;
                let _e432 = ((_e424 | _e427) | _e430);
                let _e433 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e433.first[0], _e433.first[1], _e433.first[2], _e433.first[3], _e433.first[4], _e433.first[5], _e433.first[6], _e433.first[7], _e433.first[8], _e433.first[9], _e433.first[10], _e433.first[11], _e433.first[12], _e433.first[13], _e433.first[14], _e433.first[15], _e433.first[16], _e433.first[17], _e433.first[18], _e433.first[19], _e433.first[20], _e433.first[21], _e433.first[22], _e433.first[23], _e433.first[24], _e433.first[25], _e433.first[26], _e433.first[27], _e433.first[28], _e433.first[29], _e433.first[30], _e433.first[31]), array<u32, 32>(_e433.mask[0], _e433.mask[1], _e433.mask[2], _e433.mask[3], _e433.mask[4], _e433.mask[5], _e433.mask[6], _e433.mask[7], _e433.mask[8], _e433.mask[9], _e433.mask[10], _e433.mask[11], _e433.mask[12], _e433.mask[13], _e433.mask[14], _e433.mask[15], _e433.mask[16], _e433.mask[17], _e433.mask[18], _e433.mask[19], _e433.mask[20], _e433.mask[21], _e433.mask[22], _e433.mask[23], _e433.mask[24], _e433.mask[25], _e433.mask[26], _e433.mask[27], _e433.mask[28], _e433.mask[29], _e433.mask[30], _e433.mask[31]), _e433.len, _e433.group, _e433.group_mask);
                let _e507 = local_1.group_mask;
                if ((_e507 & 4278190080u) == 0u) {
                    let _e511 = local_1.len;
                    if (_e511 == 0u) {
                        phi_1164_ = false;
                    } else {
                        let _e515 = local_1.len;
                        local_1.len = (_e515 - 1u);
                        let _e518 = local_1.len;
                        if (_e518 < 32u) {
                        } else {
                            return;
                        }
                        let _e523 = local_1.first[(0u + _e518)];
                        local_1.group = _e523;
                        let _e526 = local_1.len;
                        if (_e526 < 32u) {
                        } else {
                            return;
                        }
                        let _e531 = local_1.mask[(0u + _e526)];
                        local_1.group_mask = _e531;
                        phi_1164_ = true;
                    }
                    let _e534 = phi_1164_;
                    phi_1165_ = _e534;
                } else {
                    phi_1165_ = true;
                }
                let _e536 = phi_1165_;
                if _e536 {
                    let _e538 = local_1.group_mask;
                    let _e544 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e538)), 32u, (_e538 == 0u)));
                    let _e548 = local_1.group_mask;
                    let _e562 = local_1.group_mask;
                    local_1.group_mask = (_e562 & ~((1u << bitcast<u32>((_e544 & 31u)))));
                    let _e565 = local_1.group;
                    phi_1196_ = (_e565 + countOneBits(((_e548 & ~((4294967295u << bitcast<u32>((((_e544 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1196_ = 4294967295u;
                }
                let _e568 = phi_1196_;
                phi_1198_ = _e160;
                phi_1201_ = _e568;
                loop {
                    let _e570 = phi_1198_;
                    let _e572 = phi_1201_;
                    local_6 = _e570;
                    let _e573 = (_e572 != 4294967295u);
                    if _e573 {
                        if (_e572 < _e76) {
                        } else {
                            return;
                        }
                        let _e581 = nodes.member[(0u + _e572)].frame[3u];
                        let _e606 = (bitcast<f32>((((_e581 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e311);
                        let _e607 = (bitcast<f32>((((_e581 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e322);
                        let _e608 = (bitcast<f32>((((_e581 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e333);
                        let _e611 = nodes.member[(0u + _e572)].frame[0u];
                        let _e615 = nodes.member[(0u + _e572)].frame[1u];
                        let _e619 = nodes.member[(0u + _e572)].frame[2u];
                        let _e627 = ((bitcast<f32>(_e611) - _e158.origin.x) * _e311);
                        let _e628 = ((bitcast<f32>(_e615) - _e158.origin.y) * _e322);
                        let _e629 = ((bitcast<f32>(_e619) - _e158.origin.z) * _e333);
                        let _e637 = nodes.member[(0u + _e572)].x;
                        if (_e311 < 0f) {
                            let _e648 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e637.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e654 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e648.unnamed.word, _e637.w), _e648.unnamed_1);
                            let _e660 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e654.unnamed, lt_mask_LightPlace(_e637.x, _e654.unnamed_1.shift));
                            phi_1286_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e660.unnamed, lt_mask_LightPlace(_e660.unnamed_1.word, _e637.y));
                        } else {
                            let _e676 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e637.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e682 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e676.unnamed.word, _e637.y), _e676.unnamed_1);
                            let _e688 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e682.unnamed, lt_mask_LightPlace(_e637.z, _e682.unnamed_1.shift));
                            phi_1286_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e688.unnamed, lt_mask_LightPlace(_e688.unnamed_1.word, _e637.w));
                        }
                        let _e696 = phi_1286_;
                        let _e706 = nodes.member[(0u + _e572)].y;
                        if (_e322 < 0f) {
                            let _e717 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e706.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e723 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e717.unnamed.word, _e706.w), _e717.unnamed_1);
                            let _e729 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e723.unnamed, lt_mask_LightPlace(_e706.x, _e723.unnamed_1.shift));
                            phi_1313_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e729.unnamed, lt_mask_LightPlace(_e729.unnamed_1.word, _e706.y));
                        } else {
                            let _e745 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e706.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e751 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e745.unnamed.word, _e706.y), _e745.unnamed_1);
                            let _e757 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e751.unnamed, lt_mask_LightPlace(_e706.z, _e751.unnamed_1.shift));
                            phi_1313_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e757.unnamed, lt_mask_LightPlace(_e757.unnamed_1.word, _e706.w));
                        }
                        let _e765 = phi_1313_;
                        let _e775 = nodes.member[(0u + _e572)].z;
                        if (_e333 < 0f) {
                            let _e786 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e775.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e792 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e786.unnamed.word, _e775.w), _e786.unnamed_1);
                            let _e798 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e792.unnamed, lt_mask_LightPlace(_e775.x, _e792.unnamed_1.shift));
                            phi_1340_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e798.unnamed, lt_mask_LightPlace(_e798.unnamed_1.word, _e775.y));
                        } else {
                            let _e814 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e775.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e820 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e814.unnamed.word, _e775.y), _e814.unnamed_1);
                            let _e826 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e820.unnamed, lt_mask_LightPlace(_e775.z, _e820.unnamed_1.shift));
                            phi_1340_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e826.unnamed, lt_mask_LightPlace(_e826.unnamed_1.word, _e775.w));
                        }
                        let _e834 = phi_1340_;
                        phi_1346_ = 0u;
                        phi_1349_ = 0u;
                        loop {
                            let _e844 = phi_1346_;
                            let _e846 = phi_1349_;
                            local_2 = _e846;
                            local_3 = _e846;
                            local_4 = _e846;
                            let _e847 = (_e844 < 8u);
                            if _e847 {
                                let _e849 = (_e844 >> bitcast<u32>(2i));
                                let _e850 = (_e844 & 3u);
                                if (_e849 == 0u) {
                                    phi_1363_ = _e696.unnamed.word;
                                } else {
                                    phi_1363_ = _e696.unnamed.shift;
                                }
                                let _e853 = phi_1363_;
                                if (_e849 == 0u) {
                                    phi_1373_ = _e765.unnamed.word;
                                } else {
                                    phi_1373_ = _e765.unnamed.shift;
                                }
                                let _e862 = phi_1373_;
                                if (_e849 == 0u) {
                                    phi_1383_ = _e834.unnamed.word;
                                } else {
                                    phi_1383_ = _e834.unnamed.shift;
                                }
                                let _e871 = phi_1383_;
                                let _e884 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e853 >> bitcast<u32>(((_e850 * 8u) & 31u))) & 255u)) * _e606) + (_e627 - _e370)), ((f32(((_e862 >> bitcast<u32>(((_e850 * 8u) & 31u))) & 255u)) * _e607) + (_e628 - _e371)));
                                let _e885 = core_intrinsics_maximum_number_nsz_f32_(_e884, ((f32(((_e871 >> bitcast<u32>(((_e850 * 8u) & 31u))) & 255u)) * _e608) + (_e629 - _e372)));
                                if (_e849 == 0u) {
                                    phi_1401_ = _e696.unnamed_1.word;
                                } else {
                                    phi_1401_ = _e696.unnamed_1.shift;
                                }
                                let _e888 = phi_1401_;
                                if (_e849 == 0u) {
                                    phi_1411_ = _e765.unnamed_1.word;
                                } else {
                                    phi_1411_ = _e765.unnamed_1.shift;
                                }
                                let _e897 = phi_1411_;
                                if (_e849 == 0u) {
                                    phi_1421_ = _e834.unnamed_1.word;
                                } else {
                                    phi_1421_ = _e834.unnamed_1.shift;
                                }
                                let _e906 = phi_1421_;
                                let _e919 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e888 >> bitcast<u32>(((_e850 * 8u) & 31u))) & 255u)) * _e606) + (_e627 + _e370)), ((f32(((_e897 >> bitcast<u32>(((_e850 * 8u) & 31u))) & 255u)) * _e607) + (_e628 + _e371)));
                                let _e920 = core_intrinsics_minimum_number_nsz_f32_(_e919, ((f32(((_e906 >> bitcast<u32>(((_e850 * 8u) & 31u))) & 255u)) * _e608) + (_e629 + _e372)));
                                if (_e885 <= _e920) {
                                    if (_e885 <= _e570.t) {
                                        if (_e920 >= _e158.tmin) {
                                            if (_e849 == 0u) {
                                                let _e927 = nodes.member[(0u + _e572)].links[2u];
                                                phi_1457_ = _e927;
                                            } else {
                                                let _e930 = nodes.member[(0u + _e572)].links[3u];
                                                phi_1457_ = _e930;
                                            }
                                            let _e932 = phi_1457_;
                                            let _e937 = ((_e932 >> bitcast<u32>(((_e850 * 8u) & 31u))) & 255u);
                                            let _e938 = (_e937 & 31u);
                                            if (_e938 >= 24u) {
                                                phi_1470_ = (24u + ((_e938 - 24u) ^ _e432));
                                            } else {
                                                phi_1470_ = _e938;
                                            }
                                            let _e944 = phi_1470_;
                                            phi_1475_ = (_e846 | ((_e937 >> bitcast<u32>(5i)) << bitcast<u32>((_e944 & 31u))));
                                        } else {
                                            phi_1475_ = _e846;
                                        }
                                        let _e952 = phi_1475_;
                                        phi_1476_ = _e952;
                                    } else {
                                        phi_1476_ = _e846;
                                    }
                                    let _e954 = phi_1476_;
                                    phi_1477_ = _e954;
                                } else {
                                    phi_1477_ = _e846;
                                }
                                let _e956 = phi_1477_;
                                phi_1347_ = (_e844 + 1u);
                                phi_1350_ = _e956;
                            } else {
                                phi_1347_ = u32();
                                phi_1350_ = u32();
                            }
                            let _e959 = phi_1347_;
                            let _e961 = phi_1350_;
                            continue;
                            continuing {
                                phi_1346_ = _e959;
                                phi_1349_ = _e961;
                                break if !(_e847);
                            }
                        }
                        let _e965 = nodes.member[(0u + _e572)].links[0u];
                        let _e969 = nodes.member[(0u + _e572)].frame[3u];
                        let _e973 = local_2;
                        if ((_e973 & 4278190080u) == 0u) {
                        } else {
                            let _e977 = local_1.group_mask;
                            if ((_e977 & 4278190080u) == 0u) {
                            } else {
                                let _e981 = local_1.len;
                                if (_e981 < 32u) {
                                    let _e984 = local_1.group;
                                    let _e986 = local_1.len;
                                    if (_e986 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.first[(0u + _e986)] = _e984;
                                    let _e992 = local_1.group_mask;
                                    let _e994 = local_1.len;
                                    if (_e994 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.mask[(0u + _e994)] = _e992;
                                    let _e1001 = local_1.len;
                                    local_1.len = (_e1001 + 1u);
                                }
                            }
                            local_1.group = (0u + _e965);
                            let _e1005 = local_3;
                            local_1.group_mask = ((_e1005 & 4278190080u) | (_e969 >> bitcast<u32>(24i)));
                        }
                        let _e1010 = local_4;
                        phi_1535_ = _e570;
                        phi_1538_ = (_e1010 & 16777215u);
                        loop {
                            let _e1013 = phi_1535_;
                            let _e1015 = phi_1538_;
                            local_5 = _e1013;
                            if (_e1015 == 0u) {
                                phi_1536_ = lt_bvh_Hit();
                                phi_1539_ = u32();
                                phi_2197_ = false;
                            } else {
                                let _e1019 = nodes.member[(0u + _e572)].links[1u];
                                let _e1024 = ((0u + _e1019) + select(firstTrailingBit(_e1015), 32u, (_e1015 == 0u)));
                                if (_e1024 < _e79) {
                                } else {
                                    return;
                                }
                                let _e1031 = triangles.member[(0u + _e1024)].v0_;
                                let _e1034 = (_e1031.x - _e158.origin.x);
                                let _e1037 = (_e1031.y - _e158.origin.y);
                                let _e1040 = (_e1031.z - _e158.origin.z);
                                if (_e397 == 0u) {
                                    phi_1585_ = vec3<f32>(_e1037, _e1040, _e1034);
                                } else {
                                    if (_e397 == 1u) {
                                        phi_1584_ = vec3<f32>(_e1040, _e1034, _e1037);
                                    } else {
                                        phi_1584_ = (_e1031 - _e158.origin);
                                    }
                                    let _e1047 = phi_1584_;
                                    phi_1585_ = _e1047;
                                }
                                let _e1049 = phi_1585_;
                                let _e1053 = (_e1049.x - (_e416 * _e1049.z));
                                let _e1057 = (_e1049.y - (_e419 * _e1049.z));
                                let _e1059 = triangles.member[(0u + _e1024)].v1_;
                                let _e1062 = (_e1059.x - _e158.origin.x);
                                let _e1065 = (_e1059.y - _e158.origin.y);
                                let _e1068 = (_e1059.z - _e158.origin.z);
                                if (_e397 == 0u) {
                                    phi_1617_ = vec3<f32>(_e1065, _e1068, _e1062);
                                } else {
                                    if (_e397 == 1u) {
                                        phi_1616_ = vec3<f32>(_e1068, _e1062, _e1065);
                                    } else {
                                        phi_1616_ = (_e1059 - _e158.origin);
                                    }
                                    let _e1075 = phi_1616_;
                                    phi_1617_ = _e1075;
                                }
                                let _e1077 = phi_1617_;
                                let _e1081 = (_e1077.x - (_e416 * _e1077.z));
                                let _e1085 = (_e1077.y - (_e419 * _e1077.z));
                                let _e1087 = triangles.member[(0u + _e1024)].v2_;
                                let _e1090 = (_e1087.x - _e158.origin.x);
                                let _e1093 = (_e1087.y - _e158.origin.y);
                                let _e1096 = (_e1087.z - _e158.origin.z);
                                if (_e397 == 0u) {
                                    phi_1649_ = vec3<f32>(_e1093, _e1096, _e1090);
                                } else {
                                    if (_e397 == 1u) {
                                        phi_1648_ = vec3<f32>(_e1096, _e1090, _e1093);
                                    } else {
                                        phi_1648_ = (_e1087 - _e158.origin);
                                    }
                                    let _e1103 = phi_1648_;
                                    phi_1649_ = _e1103;
                                }
                                let _e1105 = phi_1649_;
                                let _e1109 = (_e1105.x - (_e416 * _e1105.z));
                                let _e1113 = (_e1105.y - (_e419 * _e1105.z));
                                if (_e1081 < _e1109) {
                                    phi_1668_ = true;
                                } else {
                                    if (_e1081 == _e1109) {
                                        phi_1667_ = (_e1085 < _e1113);
                                    } else {
                                        phi_1667_ = false;
                                    }
                                    let _e1118 = phi_1667_;
                                    phi_1668_ = _e1118;
                                }
                                let _e1120 = phi_1668_;
                                if _e1120 {
                                    phi_1672_ = _e1113;
                                    phi_1673_ = _e1109;
                                    phi_1674_ = _e1085;
                                    phi_1675_ = _e1081;
                                } else {
                                    phi_1672_ = _e1085;
                                    phi_1673_ = _e1081;
                                    phi_1674_ = _e1113;
                                    phi_1675_ = _e1109;
                                }
                                let _e1122 = phi_1672_;
                                let _e1124 = phi_1673_;
                                let _e1126 = phi_1674_;
                                let _e1128 = phi_1675_;
                                let _e1131 = ((_e1128 * _e1122) - (_e1126 * _e1124));
                                if _e1120 {
                                    phi_1683_ = -(_e1131);
                                } else {
                                    phi_1683_ = _e1131;
                                }
                                let _e1134 = phi_1683_;
                                if (_e1109 < _e1053) {
                                    phi_1694_ = true;
                                } else {
                                    if (_e1109 == _e1053) {
                                        phi_1693_ = (_e1113 < _e1057);
                                    } else {
                                        phi_1693_ = false;
                                    }
                                    let _e1139 = phi_1693_;
                                    phi_1694_ = _e1139;
                                }
                                let _e1141 = phi_1694_;
                                if _e1141 {
                                    phi_1698_ = _e1057;
                                    phi_1699_ = _e1053;
                                    phi_1700_ = _e1113;
                                    phi_1701_ = _e1109;
                                } else {
                                    phi_1698_ = _e1113;
                                    phi_1699_ = _e1109;
                                    phi_1700_ = _e1057;
                                    phi_1701_ = _e1053;
                                }
                                let _e1143 = phi_1698_;
                                let _e1145 = phi_1699_;
                                let _e1147 = phi_1700_;
                                let _e1149 = phi_1701_;
                                let _e1152 = ((_e1149 * _e1143) - (_e1147 * _e1145));
                                if _e1141 {
                                    phi_1709_ = -(_e1152);
                                } else {
                                    phi_1709_ = _e1152;
                                }
                                let _e1155 = phi_1709_;
                                if (_e1053 < _e1081) {
                                    phi_1720_ = true;
                                } else {
                                    if (_e1053 == _e1081) {
                                        phi_1719_ = (_e1057 < _e1085);
                                    } else {
                                        phi_1719_ = false;
                                    }
                                    let _e1160 = phi_1719_;
                                    phi_1720_ = _e1160;
                                }
                                let _e1162 = phi_1720_;
                                if _e1162 {
                                    phi_1724_ = _e1085;
                                    phi_1725_ = _e1081;
                                    phi_1726_ = _e1057;
                                    phi_1727_ = _e1053;
                                } else {
                                    phi_1724_ = _e1057;
                                    phi_1725_ = _e1053;
                                    phi_1726_ = _e1085;
                                    phi_1727_ = _e1081;
                                }
                                let _e1164 = phi_1724_;
                                let _e1166 = phi_1725_;
                                let _e1168 = phi_1726_;
                                let _e1170 = phi_1727_;
                                let _e1173 = ((_e1170 * _e1164) - (_e1168 * _e1166));
                                if _e1162 {
                                    phi_1735_ = -(_e1173);
                                } else {
                                    phi_1735_ = _e1173;
                                }
                                let _e1176 = phi_1735_;
                                if (_e1134 >= 0f) {
                                    if (_e1155 >= 0f) {
                                        if (_e1176 >= 0f) {
                                            phi_1750_ = ((_e1134 + _e1155) + _e1176);
                                            phi_1751_ = false;
                                        } else {
                                            phi_1750_ = f32();
                                            phi_1751_ = true;
                                        }
                                        let _e1183 = phi_1750_;
                                        let _e1185 = phi_1751_;
                                        phi_1752_ = _e1183;
                                        phi_1753_ = _e1185;
                                    } else {
                                        phi_1752_ = f32();
                                        phi_1753_ = true;
                                    }
                                    let _e1187 = phi_1752_;
                                    let _e1189 = phi_1753_;
                                    phi_1754_ = _e1187;
                                    phi_1755_ = _e1189;
                                } else {
                                    phi_1754_ = f32();
                                    phi_1755_ = true;
                                }
                                let _e1191 = phi_1754_;
                                let _e1193 = phi_1755_;
                                if _e1193 {
                                    if (_e1134 <= 0f) {
                                        if (_e1155 <= 0f) {
                                            let _e1196 = (_e1176 <= 0f);
                                            if _e1196 {
                                            }
                                            phi_1773_ = ((_e1134 + _e1155) + _e1176);
                                            phi_1774_ = false;
                                            phi_1775_ = _e1196;
                                        } else {
                                            phi_1773_ = f32();
                                            phi_1774_ = true;
                                            phi_1775_ = false;
                                        }
                                        let _e1200 = phi_1773_;
                                        let _e1202 = phi_1774_;
                                        let _e1204 = phi_1775_;
                                        phi_1776_ = _e1200;
                                        phi_1777_ = _e1202;
                                        phi_1778_ = _e1204;
                                    } else {
                                        phi_1776_ = f32();
                                        phi_1777_ = true;
                                        phi_1778_ = false;
                                    }
                                    let _e1206 = phi_1776_;
                                    let _e1208 = phi_1777_;
                                    let _e1210 = phi_1778_;
                                    if _e1208 {
                                        phi_1782_ = false;
                                    } else {
                                        phi_1782_ = _e1210;
                                    }
                                    let _e1212 = phi_1782_;
                                    phi_1783_ = _e1206;
                                    phi_1784_ = _e1212;
                                } else {
                                    phi_1783_ = _e1191;
                                    phi_1784_ = true;
                                }
                                let _e1214 = phi_1783_;
                                let _e1216 = phi_1784_;
                                if _e1216 {
                                    let _e1217 = (_e1214 == 0f);
                                    if _e1217 {
                                        phi_2110_ = lt_bvh_triangle_Intersection();
                                        phi_2111_ = false;
                                    } else {
                                        let _e1219 = triangles.member[(0u + _e1024)].v0_;
                                        let _e1222 = (_e1219.x - _e158.origin.x);
                                        let _e1225 = (_e1219.y - _e158.origin.y);
                                        let _e1228 = (_e1219.z - _e158.origin.z);
                                        if (_e397 == 0u) {
                                            phi_1815_ = vec3<f32>(_e1225, _e1228, _e1222);
                                        } else {
                                            if (_e397 == 1u) {
                                                phi_1814_ = vec3<f32>(_e1228, _e1222, _e1225);
                                            } else {
                                                phi_1814_ = (_e1219 - _e158.origin);
                                            }
                                            let _e1235 = phi_1814_;
                                            phi_1815_ = _e1235;
                                        }
                                        let _e1237 = phi_1815_;
                                        let _e1239 = triangles.member[(0u + _e1024)].v1_;
                                        let _e1241 = triangles.member[(0u + _e1024)].v0_;
                                        let _e1244 = (_e1239.x - _e1241.x);
                                        let _e1247 = (_e1239.y - _e1241.y);
                                        let _e1250 = (_e1239.z - _e1241.z);
                                        if (_e397 == 0u) {
                                            phi_1841_ = vec3<f32>(_e1247, _e1250, _e1244);
                                        } else {
                                            if (_e397 == 1u) {
                                                phi_1840_ = vec3<f32>(_e1250, _e1244, _e1247);
                                            } else {
                                                phi_1840_ = (_e1239 - _e1241);
                                            }
                                            let _e1257 = phi_1840_;
                                            phi_1841_ = _e1257;
                                        }
                                        let _e1259 = phi_1841_;
                                        let _e1261 = triangles.member[(0u + _e1024)].v2_;
                                        let _e1263 = triangles.member[(0u + _e1024)].v0_;
                                        let _e1266 = (_e1261.x - _e1263.x);
                                        let _e1269 = (_e1261.y - _e1263.y);
                                        let _e1272 = (_e1261.z - _e1263.z);
                                        if (_e397 == 0u) {
                                            phi_1867_ = vec3<f32>(_e1269, _e1272, _e1266);
                                        } else {
                                            if (_e397 == 1u) {
                                                phi_1866_ = vec3<f32>(_e1272, _e1266, _e1269);
                                            } else {
                                                phi_1866_ = (_e1261 - _e1263);
                                            }
                                            let _e1279 = phi_1866_;
                                            phi_1867_ = _e1279;
                                        }
                                        let _e1281 = phi_1867_;
                                        let _e1288 = ((_e1259.y * _e1281.z) - (_e1259.z * _e1281.y));
                                        let _e1295 = ((_e1259.z * _e1281.x) - (_e1259.x * _e1281.z));
                                        let _e1302 = ((_e1259.x * _e1281.y) - (_e1259.y * _e1281.x));
                                        let _e1316 = (((1f / _e412.z) * (((_e1288 * _e1237.x) + (_e1295 * _e1237.y)) + (_e1302 * _e1237.z))) / (((_e1288 * _e416) + (_e1295 * _e419)) + _e1302));
                                        if (_e1316 > _e158.tmin) {
                                            if (_e1316 < _e158.tmax) {
                                                let _e1322 = triangles.member[(0u + _e1024)].v0_;
                                                let _e1324 = triangles.member[(0u + _e1024)].v1_;
                                                if (_e1322.x < _e1324.x) {
                                                    phi_1925_ = _e1322.x;
                                                } else {
                                                    phi_1925_ = _e1324.x;
                                                }
                                                let _e1331 = phi_1925_;
                                                if (_e1322.y < _e1324.y) {
                                                    phi_1934_ = _e1322.y;
                                                } else {
                                                    phi_1934_ = _e1324.y;
                                                }
                                                let _e1338 = phi_1934_;
                                                if (_e1322.z < _e1324.z) {
                                                    phi_1943_ = _e1322.z;
                                                } else {
                                                    phi_1943_ = _e1324.z;
                                                }
                                                let _e1345 = phi_1943_;
                                                let _e1347 = triangles.member[(0u + _e1024)].v2_;
                                                if (_e1331 < _e1347.x) {
                                                    phi_1952_ = _e1331;
                                                } else {
                                                    phi_1952_ = _e1347.x;
                                                }
                                                let _e1352 = phi_1952_;
                                                if (_e1338 < _e1347.y) {
                                                    phi_1959_ = _e1338;
                                                } else {
                                                    phi_1959_ = _e1347.y;
                                                }
                                                let _e1357 = phi_1959_;
                                                if (_e1345 < _e1347.z) {
                                                    phi_1966_ = _e1345;
                                                } else {
                                                    phi_1966_ = _e1347.z;
                                                }
                                                let _e1362 = phi_1966_;
                                                let _e1364 = triangles.member[(0u + _e1024)].v0_;
                                                let _e1366 = triangles.member[(0u + _e1024)].v1_;
                                                if (_e1364.x > _e1366.x) {
                                                    phi_1979_ = _e1364.x;
                                                } else {
                                                    phi_1979_ = _e1366.x;
                                                }
                                                let _e1373 = phi_1979_;
                                                if (_e1364.y > _e1366.y) {
                                                    phi_1988_ = _e1364.y;
                                                } else {
                                                    phi_1988_ = _e1366.y;
                                                }
                                                let _e1380 = phi_1988_;
                                                if (_e1364.z > _e1366.z) {
                                                    phi_1997_ = _e1364.z;
                                                } else {
                                                    phi_1997_ = _e1366.z;
                                                }
                                                let _e1387 = phi_1997_;
                                                let _e1389 = triangles.member[(0u + _e1024)].v2_;
                                                if (_e1373 > _e1389.x) {
                                                    phi_2006_ = _e1373;
                                                } else {
                                                    phi_2006_ = _e1389.x;
                                                }
                                                let _e1394 = phi_2006_;
                                                if (_e1380 > _e1389.y) {
                                                    phi_2013_ = _e1380;
                                                } else {
                                                    phi_2013_ = _e1389.y;
                                                }
                                                let _e1399 = phi_2013_;
                                                if (_e1387 > _e1389.z) {
                                                    phi_2020_ = _e1387;
                                                } else {
                                                    phi_2020_ = _e1389.z;
                                                }
                                                let _e1404 = phi_2020_;
                                                let _e1411 = ((_e1352 - _e158.origin.x) * _e311);
                                                let _e1412 = ((_e1357 - _e158.origin.y) * _e322);
                                                let _e1413 = ((_e1362 - _e158.origin.z) * _e333);
                                                let _e1420 = ((_e1394 - _e158.origin.x) * _e311);
                                                let _e1421 = ((_e1399 - _e158.origin.y) * _e322);
                                                let _e1422 = ((_e1404 - _e158.origin.z) * _e333);
                                                if (_e1411 < _e1420) {
                                                    phi_2043_ = _e1411;
                                                } else {
                                                    phi_2043_ = _e1420;
                                                }
                                                let _e1425 = phi_2043_;
                                                if (_e1412 < _e1421) {
                                                    phi_2048_ = _e1412;
                                                } else {
                                                    phi_2048_ = _e1421;
                                                }
                                                let _e1428 = phi_2048_;
                                                if (_e1413 < _e1422) {
                                                    phi_2053_ = _e1413;
                                                } else {
                                                    phi_2053_ = _e1422;
                                                }
                                                let _e1431 = phi_2053_;
                                                if (_e1411 > _e1420) {
                                                    phi_2061_ = _e1411;
                                                } else {
                                                    phi_2061_ = _e1420;
                                                }
                                                let _e1437 = phi_2061_;
                                                if (_e1412 > _e1421) {
                                                    phi_2066_ = _e1412;
                                                } else {
                                                    phi_2066_ = _e1421;
                                                }
                                                let _e1440 = phi_2066_;
                                                if (_e1413 > _e1422) {
                                                    phi_2071_ = _e1413;
                                                } else {
                                                    phi_2071_ = _e1422;
                                                }
                                                let _e1443 = phi_2071_;
                                                let _e1447 = core_intrinsics_maximum_number_nsz_f32_((_e1425 - _e377), (_e1428 - _e378));
                                                let _e1448 = core_intrinsics_maximum_number_nsz_f32_(_e1447, (_e1431 - _e379));
                                                let _e1449 = core_intrinsics_minimum_number_nsz_f32_((_e1437 + _e377), (_e1440 + _e378));
                                                let _e1450 = core_intrinsics_minimum_number_nsz_f32_(_e1449, (_e1443 + _e379));
                                                if (_e1448 > -300000000000000000000000000000000000000f) {
                                                    phi_2083_ = _e1448;
                                                } else {
                                                    phi_2083_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1453 = phi_2083_;
                                                if (_e1450 < 300000000000000000000000000000000000000f) {
                                                    phi_2088_ = _e1450;
                                                } else {
                                                    phi_2088_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1456 = phi_2088_;
                                                if (_e1316 < _e1453) {
                                                    phi_2093_ = _e1453;
                                                } else {
                                                    phi_2093_ = _e1316;
                                                }
                                                let _e1459 = phi_2093_;
                                                if (_e1459 > _e1456) {
                                                    phi_2098_ = _e1456;
                                                } else {
                                                    phi_2098_ = _e1459;
                                                }
                                                let _e1462 = phi_2098_;
                                                phi_2103_ = lt_bvh_triangle_Intersection(_e1462, (_e1155 / _e1214), (_e1176 / _e1214), (_e1453 <= _e1456));
                                                phi_2104_ = false;
                                            } else {
                                                phi_2103_ = lt_bvh_triangle_Intersection();
                                                phi_2104_ = true;
                                            }
                                            let _e1468 = phi_2103_;
                                            let _e1470 = phi_2104_;
                                            phi_2105_ = _e1468;
                                            phi_2106_ = _e1470;
                                        } else {
                                            phi_2105_ = lt_bvh_triangle_Intersection();
                                            phi_2106_ = true;
                                        }
                                        let _e1472 = phi_2105_;
                                        let _e1474 = phi_2106_;
                                        if _e1474 {
                                        }
                                        phi_2110_ = _e1472;
                                        phi_2111_ = _e1474;
                                    }
                                    let _e1476 = phi_2110_;
                                    let _e1478 = phi_2111_;
                                    phi_2112_ = _e1476;
                                    phi_2113_ = _e1217;
                                    phi_2114_ = _e1478;
                                } else {
                                    phi_2112_ = lt_bvh_triangle_Intersection();
                                    phi_2113_ = true;
                                    phi_2114_ = false;
                                }
                                let _e1480 = phi_2112_;
                                let _e1482 = phi_2113_;
                                let _e1484 = phi_2114_;
                                if _e1482 {
                                    phi_2118_ = true;
                                } else {
                                    phi_2118_ = _e1484;
                                }
                                let _e1486 = phi_2118_;
                                if _e1486 {
                                    phi_2122_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_2122_ = _e1480;
                                }
                                let _e1488 = phi_2122_;
                                if _e1488.is_hit {
                                    if (_e1488.t > _e158.tmin) {
                                        if (_e1488.t < _e1013.t) {
                                            phi_2171_ = true;
                                        } else {
                                            if (_e1488.t == _e1013.t) {
                                                if (_e1013.triangle != 4294967295u) {
                                                    if (_e1024 < _e1013.triangle) {
                                                        phi_2162_ = true;
                                                    } else {
                                                        if (_e1024 == _e1013.triangle) {
                                                            phi_2161_ = (4294967295u < _e1013.instance);
                                                        } else {
                                                            phi_2161_ = false;
                                                        }
                                                        let _e1507 = phi_2161_;
                                                        phi_2162_ = _e1507;
                                                    }
                                                    let _e1509 = phi_2162_;
                                                    phi_2163_ = _e1509;
                                                    phi_2164_ = false;
                                                } else {
                                                    phi_2163_ = bool();
                                                    phi_2164_ = true;
                                                }
                                                let _e1511 = phi_2163_;
                                                let _e1513 = phi_2164_;
                                                phi_2165_ = _e1511;
                                                phi_2166_ = _e1513;
                                            } else {
                                                phi_2165_ = bool();
                                                phi_2166_ = true;
                                            }
                                            let _e1515 = phi_2165_;
                                            let _e1517 = phi_2166_;
                                            if _e1517 {
                                                phi_2170_ = false;
                                            } else {
                                                phi_2170_ = _e1515;
                                            }
                                            let _e1519 = phi_2170_;
                                            phi_2171_ = _e1519;
                                        }
                                        let _e1521 = phi_2171_;
                                        if _e1521 {
                                            let _e1523 = triangles.member[(0u + _e1024)].i0_;
                                            if ((_e1523 & 2147483648u) == 0u) {
                                                phi_2185_ = true;
                                            } else {
                                                if true {
                                                }
                                                phi_2185_ = true;
                                            }
                                            let _e1527 = phi_2185_;
                                            if _e1527 {
                                                phi_2193_ = lt_bvh_Hit(_e1488.t, _e1488.u, _e1488.v, _e1024, 4294967295u);
                                            } else {
                                                phi_2193_ = _e1013;
                                            }
                                            let _e1533 = phi_2193_;
                                            phi_2194_ = _e1533;
                                        } else {
                                            phi_2194_ = _e1013;
                                        }
                                        let _e1535 = phi_2194_;
                                        phi_2195_ = _e1535;
                                    } else {
                                        phi_2195_ = _e1013;
                                    }
                                    let _e1537 = phi_2195_;
                                    phi_2196_ = _e1537;
                                } else {
                                    phi_2196_ = _e1013;
                                }
                                let _e1539 = phi_2196_;
                                phi_1536_ = _e1539;
                                phi_1539_ = (_e1015 & (_e1015 - 1u));
                                phi_2197_ = true;
                            }
                            let _e1541 = phi_1536_;
                            let _e1543 = phi_1539_;
                            let _e1545 = phi_2197_;
                            continue;
                            continuing {
                                phi_1535_ = _e1541;
                                phi_1538_ = _e1543;
                                break if !(_e1545);
                            }
                        }
                        let _e1548 = local_1.group_mask;
                        if ((_e1548 & 4278190080u) == 0u) {
                            let _e1552 = local_1.len;
                            if (_e1552 == 0u) {
                                phi_2236_ = false;
                            } else {
                                let _e1556 = local_1.len;
                                local_1.len = (_e1556 - 1u);
                                let _e1559 = local_1.len;
                                if (_e1559 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1564 = local_1.first[(0u + _e1559)];
                                local_1.group = _e1564;
                                let _e1567 = local_1.len;
                                if (_e1567 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1572 = local_1.mask[(0u + _e1567)];
                                local_1.group_mask = _e1572;
                                phi_2236_ = true;
                            }
                            let _e1575 = phi_2236_;
                            phi_2237_ = _e1575;
                        } else {
                            phi_2237_ = true;
                        }
                        let _e1577 = phi_2237_;
                        if _e1577 {
                            let _e1579 = local_1.group_mask;
                            let _e1585 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1579)), 32u, (_e1579 == 0u)));
                            let _e1589 = local_1.group_mask;
                            let _e1603 = local_1.group_mask;
                            local_1.group_mask = (_e1603 & ~((1u << bitcast<u32>((_e1585 & 31u)))));
                            let _e1606 = local_1.group;
                            phi_2268_ = (_e1606 + countOneBits(((_e1589 & ~((4294967295u << bitcast<u32>((((_e1585 - 24u) ^ _e432) & 31u))))) & 255u)));
                        } else {
                            phi_2268_ = 4294967295u;
                        }
                        let _e1609 = phi_2268_;
                        let _e2529 = local_5;
                        phi_1199_ = _e2529;
                        phi_1202_ = _e1609;
                    } else {
                        phi_1199_ = lt_bvh_Hit();
                        phi_1202_ = u32();
                    }
                    let _e1611 = phi_1199_;
                    let _e1613 = phi_1202_;
                    continue;
                    continuing {
                        phi_1198_ = _e1611;
                        phi_1201_ = _e1613;
                        break if !(_e573);
                    }
                }
                let _e2533 = local_6;
                phi_2269_ = _e2533;
            }
            let _e1616 = phi_2269_;
            phi_2270_ = _e1616;
            phi_2271_ = _e230;
        } else {
            phi_2270_ = lt_bvh_Hit();
            phi_2271_ = true;
        }
        let _e1618 = phi_2270_;
        let _e1620 = phi_2271_;
        if _e1620 {
            phi_2275_ = _e160;
        } else {
            phi_2275_ = _e1618;
        }
        let _e1622 = phi_2275_;
        if (_e1622.triangle != 4294967295u) {
            let _e1628 = ((1f - _e1622.u) - _e1622.v);
            if (_e1622.triangle < _e79) {
            } else {
                return;
            }
            let _e1633 = triangles.member[(0u + _e1622.triangle)];
            let _e1658 = (((_e1633.v0_.x * _e1628) + (_e1633.v1_.x * _e1622.u)) + (_e1633.v2_.x * _e1622.v));
            let _e1659 = (((_e1633.v0_.y * _e1628) + (_e1633.v1_.y * _e1622.u)) + (_e1633.v2_.y * _e1622.v));
            let _e1660 = (((_e1633.v0_.z * _e1628) + (_e1633.v1_.z * _e1622.u)) + (_e1633.v2_.z * _e1622.v));
            let _e1663 = abs(_e1633.v0_.x);
            let _e1665 = abs(_e1633.v0_.y);
            let _e1667 = abs(_e1633.v0_.z);
            let _e1669 = abs(_e1633.v1_.x);
            let _e1671 = abs(_e1633.v1_.y);
            let _e1673 = abs(_e1633.v1_.z);
            if (_e1663 > _e1669) {
                phi_2339_ = _e1663;
            } else {
                phi_2339_ = _e1669;
            }
            let _e1676 = phi_2339_;
            if (_e1665 > _e1671) {
                phi_2344_ = _e1665;
            } else {
                phi_2344_ = _e1671;
            }
            let _e1679 = phi_2344_;
            if (_e1667 > _e1673) {
                phi_2349_ = _e1667;
            } else {
                phi_2349_ = _e1673;
            }
            let _e1682 = phi_2349_;
            let _e1684 = abs(_e1633.v2_.x);
            let _e1686 = abs(_e1633.v2_.y);
            let _e1688 = abs(_e1633.v2_.z);
            if (_e1676 > _e1684) {
                phi_2360_ = _e1676;
            } else {
                phi_2360_ = _e1684;
            }
            let _e1691 = phi_2360_;
            if (_e1679 > _e1686) {
                phi_2365_ = _e1679;
            } else {
                phi_2365_ = _e1686;
            }
            let _e1694 = phi_2365_;
            if (_e1682 > _e1688) {
                phi_2370_ = _e1682;
            } else {
                phi_2370_ = _e1688;
            }
            let _e1697 = phi_2370_;
            let _e1700 = (_e1633.v1_.x - _e1633.v0_.x);
            let _e1703 = (_e1633.v1_.y - _e1633.v0_.y);
            let _e1706 = (_e1633.v1_.z - _e1633.v0_.z);
            let _e1709 = (_e1633.v2_.x - _e1633.v0_.x);
            let _e1712 = (_e1633.v2_.y - _e1633.v0_.y);
            let _e1715 = (_e1633.v2_.z - _e1633.v0_.z);
            let _e1719 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1703), abs(_e1706));
            let _e1720 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1700), _e1719);
            let _e1721 = (_e1700 / _e1720);
            let _e1722 = (_e1703 / _e1720);
            let _e1723 = (_e1706 / _e1720);
            let _e1727 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1712), abs(_e1715));
            let _e1728 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1709), _e1727);
            let _e1729 = (_e1709 / _e1728);
            let _e1730 = (_e1712 / _e1728);
            let _e1731 = (_e1715 / _e1728);
            let _e1734 = ((_e1722 * _e1731) - (_e1730 * _e1723));
            let _e1737 = ((_e1723 * _e1729) - (_e1731 * _e1721));
            let _e1740 = ((_e1721 * _e1730) - (_e1729 * _e1722));
            let _e1742 = p.member.eye;
            let _e1755 = (1f / sqrt((((_e1734 * _e1734) + (_e1737 * _e1737)) + (_e1740 * _e1740))));
            let _e1756 = (_e1734 * _e1755);
            let _e1757 = (_e1737 * _e1755);
            let _e1758 = (_e1740 * _e1755);
            if ((((_e1756 * (_e1742.x - _e1658)) + (_e1757 * (_e1742.y - _e1659))) + (_e1758 * (_e1742.z - _e1660))) < 0f) {
                phi_2446_ = vec3<f32>(-(_e1756), -(_e1757), -(_e1758));
            } else {
                phi_2446_ = vec3<f32>(_e1756, _e1757, _e1758);
            }
            let _e1771 = phi_2446_;
            if (_e1622.triangle < _e79) {
            } else {
                return;
            }
            let _e1776 = triangles.member[(0u + _e1622.triangle)];
            let _e1778 = (_e1776.i0_ & 2147483647u);
            if (_e1778 < _e82) {
            } else {
                return;
            }
            let _e1784 = vertices.member[(0u + _e1778)];
            if (_e1776.i1_ < _e82) {
            } else {
                return;
            }
            let _e1788 = vertices.member[(0u + _e1776.i1_)];
            if (_e1776.i2_ < _e82) {
            } else {
                return;
            }
            let _e1792 = vertices.member[(0u + _e1776.i2_)];
            let _e1793 = array<abi_Vertex, 3>(_e1784, _e1788, _e1792);
            if (_e1793[0].material < arrayLength((&materials.member))) {
            } else {
                return;
            }
            let _e1799 = materials.member[(0u + _e1793[0].material)];
            let _e1816 = (1f / 255f);
            let _e1835 = (1f / 255f);
            let _e1857 = (1f / 255f);
            if (_e1799.color_size == 0u) {
                phi_2689_ = vec3<f32>(1f, 1f, 1f);
            } else {
                local.offset = _e1799.color_offset;
                local.size = _e1799.color_size;
                local.flags = _e1799.flags;
                let _e1900 = _lt_shaders_texture_TextureView_quad((&local), (((_e1793[0].u * _e1628) + (_e1793[1].u * _e1622.u)) + (_e1793[2].u * _e1622.v)), (((_e1793[0].v * _e1628) + (_e1793[1].v * _e1622.u)) + (_e1793[2].v * _e1622.v)));
                if (_e1900.indices[0] < _e91) {
                } else {
                    return;
                }
                let _e1906 = color_texels.member[(0u + _e1900.indices[0])];
                let _e1917 = (1f / 255f);
                if (_e1900.indices[1] < _e91) {
                } else {
                    return;
                }
                let _e1931 = color_texels.member[(0u + _e1900.indices[1])];
                let _e1942 = (1f / 255f);
                if (_e1900.indices[2] < _e91) {
                } else {
                    return;
                }
                let _e1959 = color_texels.member[(0u + _e1900.indices[2])];
                let _e1970 = (1f / 255f);
                if (_e1900.indices[3] < _e91) {
                } else {
                    return;
                }
                let _e1987 = color_texels.member[(0u + _e1900.indices[3])];
                let _e1998 = (1f / 255f);
                let _e2007 = (((((f32((_e1906 & 255u)) * _e1917) * _e1900.weights.x) + ((f32((_e1931 & 255u)) * _e1942) * _e1900.weights.y)) + ((f32((_e1959 & 255u)) * _e1970) * _e1900.weights.z)) + ((f32((_e1987 & 255u)) * _e1998) * _e1900.weights.w));
                let _e2008 = (((((f32(((_e1906 >> bitcast<u32>(8i)) & 255u)) * _e1917) * _e1900.weights.x) + ((f32(((_e1931 >> bitcast<u32>(8i)) & 255u)) * _e1942) * _e1900.weights.y)) + ((f32(((_e1959 >> bitcast<u32>(8i)) & 255u)) * _e1970) * _e1900.weights.z)) + ((f32(((_e1987 >> bitcast<u32>(8i)) & 255u)) * _e1998) * _e1900.weights.w));
                let _e2009 = (((((f32(((_e1906 >> bitcast<u32>(16i)) & 255u)) * _e1917) * _e1900.weights.x) + ((f32(((_e1931 >> bitcast<u32>(16i)) & 255u)) * _e1942) * _e1900.weights.y)) + ((f32(((_e1959 >> bitcast<u32>(16i)) & 255u)) * _e1970) * _e1900.weights.z)) + ((f32(((_e1987 >> bitcast<u32>(16i)) & 255u)) * _e1998) * _e1900.weights.w));
                phi_2689_ = vec3<f32>((_e2007 * _e2007), (_e2008 * _e2008), (_e2009 * _e2009));
            }
            let _e2015 = phi_2689_;
            let _e2017 = ((_e1799.base_color.x * ((((f32((_e1793[0].color & 255u)) * _e1816) * _e1628) + ((f32((_e1793[1].color & 255u)) * _e1835) * _e1622.u)) + ((f32((_e1793[2].color & 255u)) * _e1857) * _e1622.v))) * _e2015.x);
            let _e2019 = ((_e1799.base_color.y * ((((f32(((_e1793[0].color >> bitcast<u32>(8i)) & 255u)) * _e1816) * _e1628) + ((f32(((_e1793[1].color >> bitcast<u32>(8i)) & 255u)) * _e1835) * _e1622.u)) + ((f32(((_e1793[2].color >> bitcast<u32>(8i)) & 255u)) * _e1857) * _e1622.v))) * _e2015.y);
            let _e2021 = ((_e1799.base_color.z * ((((f32(((_e1793[0].color >> bitcast<u32>(16i)) & 255u)) * _e1816) * _e1628) + ((f32(((_e1793[1].color >> bitcast<u32>(16i)) & 255u)) * _e1835) * _e1622.u)) + ((f32(((_e1793[2].color >> bitcast<u32>(16i)) & 255u)) * _e1857) * _e1622.v))) * _e2015.z);
            let _e2022 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1694, _e1697);
            let _e2023 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1691, _e2022);
            if ((_e1799.flags & 2u) == 0u) {
                phi_2704_ = 0u;
            } else {
                phi_2704_ = 1u;
            }
            let _e2028 = phi_2704_;
            if (_e1793[0].normal == 2147516416u) {
                phi_2907_ = _e1771;
            } else {
                let _e2041 = (f32((bitcast<i32>((_e1793[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2047 = (f32((bitcast<i32>(_e1793[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2051 = ((1f - abs(_e2041)) - abs(_e2047));
                if (_e2051 < 0f) {
                    phi_2731_ = -(_e2051);
                } else {
                    phi_2731_ = 0f;
                }
                let _e2055 = phi_2731_;
                if (_e2041 < 0f) {
                    phi_2738_ = (_e2041 + _e2055);
                } else {
                    phi_2738_ = (_e2041 - _e2055);
                }
                let _e2060 = phi_2738_;
                if (_e2047 < 0f) {
                    phi_2745_ = (_e2047 + _e2055);
                } else {
                    phi_2745_ = (_e2047 - _e2055);
                }
                let _e2065 = phi_2745_;
                let _e2072 = (1f / sqrt((((_e2060 * _e2060) + (_e2065 * _e2065)) + (_e2051 * _e2051))));
                let _e2088 = (f32((bitcast<i32>((_e1793[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2094 = (f32((bitcast<i32>(_e1793[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2098 = ((1f - abs(_e2088)) - abs(_e2094));
                if (_e2098 < 0f) {
                    phi_2780_ = -(_e2098);
                } else {
                    phi_2780_ = 0f;
                }
                let _e2102 = phi_2780_;
                if (_e2088 < 0f) {
                    phi_2787_ = (_e2088 + _e2102);
                } else {
                    phi_2787_ = (_e2088 - _e2102);
                }
                let _e2107 = phi_2787_;
                if (_e2094 < 0f) {
                    phi_2794_ = (_e2094 + _e2102);
                } else {
                    phi_2794_ = (_e2094 - _e2102);
                }
                let _e2112 = phi_2794_;
                let _e2119 = (1f / sqrt((((_e2107 * _e2107) + (_e2112 * _e2112)) + (_e2098 * _e2098))));
                let _e2138 = (f32((bitcast<i32>((_e1793[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2144 = (f32((bitcast<i32>(_e1793[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2148 = ((1f - abs(_e2138)) - abs(_e2144));
                if (_e2148 < 0f) {
                    phi_2832_ = -(_e2148);
                } else {
                    phi_2832_ = 0f;
                }
                let _e2152 = phi_2832_;
                if (_e2138 < 0f) {
                    phi_2839_ = (_e2138 + _e2152);
                } else {
                    phi_2839_ = (_e2138 - _e2152);
                }
                let _e2157 = phi_2839_;
                if (_e2144 < 0f) {
                    phi_2846_ = (_e2144 + _e2152);
                } else {
                    phi_2846_ = (_e2144 - _e2152);
                }
                let _e2162 = phi_2846_;
                let _e2169 = (1f / sqrt((((_e2157 * _e2157) + (_e2162 * _e2162)) + (_e2148 * _e2148))));
                let _e2180 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(vec3<f32>(((((_e2060 * _e2072) * _e1628) + ((_e2107 * _e2119) * _e1622.u)) + ((_e2157 * _e2169) * _e1622.v)), ((((_e2065 * _e2072) * _e1628) + ((_e2112 * _e2119) * _e1622.u)) + ((_e2162 * _e2169) * _e1622.v)), ((((_e2051 * _e2072) * _e1628) + ((_e2098 * _e2119) * _e1622.u)) + ((_e2148 * _e2169) * _e1622.v))));
                let _e2192 = sqrt((((_e2180.x * _e2180.x) + (_e2180.y * _e2180.y)) + (_e2180.z * _e2180.z)));
                if (_e2192 > 0f) {
                    let _e2195 = (_e2180.x / _e2192);
                    let _e2197 = (_e2180.y / _e2192);
                    let _e2199 = (_e2180.z / _e2192);
                    if ((((_e2195 * _e1771.x) + (_e2197 * _e1771.y)) + (_e2199 * _e1771.z)) < 0f) {
                        phi_2905_ = vec3<f32>(-(_e2195), -(_e2197), -(_e2199));
                    } else {
                        phi_2905_ = (_e2180 / vec3(_e2192));
                    }
                    let _e2216 = phi_2905_;
                    phi_2906_ = _e2216;
                } else {
                    phi_2906_ = _e1771;
                }
                let _e2218 = phi_2906_;
                phi_2907_ = _e2218;
            }
            let _e2220 = phi_2907_;
            if (_e2017 > 0f) {
                if (_e2017 < 1f) {
                    phi_2916_ = _e2017;
                } else {
                    phi_2916_ = 1f;
                }
                let _e2224 = phi_2916_;
                phi_2917_ = _e2224;
            } else {
                phi_2917_ = 0f;
            }
            let _e2226 = phi_2917_;
            if (_e2019 > 0f) {
                if (_e2019 < 1f) {
                    phi_2927_ = _e2019;
                } else {
                    phi_2927_ = 1f;
                }
                let _e2231 = phi_2927_;
                phi_2928_ = _e2231;
            } else {
                phi_2928_ = 0f;
            }
            let _e2233 = phi_2928_;
            if (_e2021 > 0f) {
                if (_e2021 < 1f) {
                    phi_2938_ = _e2021;
                } else {
                    phi_2938_ = 1f;
                }
                let _e2238 = phi_2938_;
                phi_2939_ = _e2238;
            } else {
                phi_2939_ = 0f;
            }
            let _e2240 = phi_2939_;
            let _e2243 = ((sqrt(_e2226) * 255f) + 0.5f);
            let _e2252 = ((sqrt(_e2233) * 255f) + 0.5f);
            let _e2264 = ((sqrt(_e2240) * 255f) + 0.5f);
            phi_2974_ = abi_Sample(vec3<f32>(_e1658, _e1659, _e1660), _e2023, _e1771, _e2028, _e2220, ((select(select(u32(_e2243), 0u, (_e2243 < bitcast<f32>(0u))), 4294967295u, (_e2243 > bitcast<f32>(1333788671u))) | (select(select(u32(_e2252), 0u, (_e2252 < bitcast<f32>(0u))), 4294967295u, (_e2252 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e2264), 0u, (_e2264 < bitcast<f32>(0u))), 4294967295u, (_e2264 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_2974_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e2278 = phi_2974_;
        if (_e103.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e103.shift)] = _e2278;
        if (_e1622.triangle != 4294967295u) {
            let _e2287 = ((1f - _e1622.u) - _e1622.v);
            if (_e1622.triangle < _e79) {
            } else {
                return;
            }
            let _e2292 = triangles.member[(0u + _e1622.triangle)];
            let _e2294 = (_e2292.i0_ & 2147483647u);
            if (_e2294 < _e94) {
            } else {
                return;
            }
            let _e2300 = before.member[(0u + _e2294)];
            if (_e2292.i1_ < _e94) {
            } else {
                return;
            }
            let _e2304 = before.member[(0u + _e2292.i1_)];
            if (_e2292.i2_ < _e94) {
            } else {
                return;
            }
            let _e2308 = before.member[(0u + _e2292.i2_)];
            let _e2313 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2300.x, _e2300.y, _e2300.z));
            let _e2324 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2304.x, _e2304.y, _e2304.z));
            let _e2338 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2308.x, _e2308.y, _e2308.z));
            phi_3065_ = vec3<f32>((((_e2313.x * _e2287) + (_e2324.x * _e1622.u)) + (_e2338.x * _e1622.v)), (((_e2313.y * _e2287) + (_e2324.y * _e1622.u)) + (_e2338.y * _e1622.v)), (((_e2313.z * _e2287) + (_e2324.z * _e1622.u)) + (_e2338.z * _e1622.v)));
        } else {
            phi_3065_ = vec3<f32>(0f, 0f, 0f);
        }
        let _e2350 = phi_3065_;
        if (_e103.shift < arrayLength((&past.member))) {
        } else {
            return;
        }
        past.member[(0u + _e103.shift)] = vec4<f32>(_e2350.x, _e2350.y, _e2350.z, 1f);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_color_motion_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
