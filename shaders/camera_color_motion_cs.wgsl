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
                let _e307 = phi_892_;
                if (_e158.direction.x < 0f) {
                    phi_899_ = (-1f / _e307);
                } else {
                    phi_899_ = (1f / _e307);
                }
                let _e312 = phi_899_;
                if (abs(_e158.direction.y) < _e300) {
                    phi_907_ = _e300;
                } else {
                    phi_907_ = abs(_e158.direction.y);
                }
                let _e319 = phi_907_;
                if (_e158.direction.y < 0f) {
                    phi_914_ = (-1f / _e319);
                } else {
                    phi_914_ = (1f / _e319);
                }
                let _e324 = phi_914_;
                if (abs(_e158.direction.z) < _e300) {
                    phi_922_ = _e300;
                } else {
                    phi_922_ = abs(_e158.direction.z);
                }
                let _e331 = phi_922_;
                if (_e158.direction.z < 0f) {
                    phi_929_ = (-1f / _e331);
                } else {
                    phi_929_ = (1f / _e331);
                }
                let _e336 = phi_929_;
                let _e344 = abs((bitcast<f32>(_e236) - _e158.origin.x));
                let _e345 = abs((bitcast<f32>(_e240) - _e158.origin.y));
                let _e346 = abs((bitcast<f32>(_e244) - _e158.origin.z));
                let _e354 = abs(((bitcast<f32>(_e248) + (bitcast<f32>((((_e260 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e158.origin.x));
                let _e355 = abs(((bitcast<f32>(_e252) + (bitcast<f32>((((_e260 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e158.origin.y));
                let _e356 = abs(((bitcast<f32>(_e256) + (bitcast<f32>((((_e260 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e158.origin.z));
                if (_e344 > _e354) {
                    phi_954_ = _e344;
                } else {
                    phi_954_ = _e354;
                }
                let _e359 = phi_954_;
                if (_e345 > _e355) {
                    phi_959_ = _e345;
                } else {
                    phi_959_ = _e355;
                }
                let _e362 = phi_959_;
                if (_e346 > _e356) {
                    phi_964_ = _e346;
                } else {
                    phi_964_ = _e356;
                }
                let _e365 = phi_964_;
                let _e366 = core_intrinsics_maximum_number_nsz_f32_(_e359, _e362);
                let _e367 = core_intrinsics_maximum_number_nsz_f32_(_e366, _e365);
                let _e372 = (_e367 * 0.0000019073486f);
                let _e373 = (abs(_e312) * _e372);
                let _e374 = (abs(_e324) * _e372);
                let _e375 = (abs(_e336) * _e372);
                let _e379 = (_e367 * 0.0000009536743f);
                let _e380 = (abs(_e312) * _e379);
                let _e381 = (abs(_e324) * _e379);
                let _e382 = (abs(_e336) * _e379);
                let _e385 = abs(_e158.direction.x);
                let _e387 = abs(_e158.direction.y);
                let _e389 = abs(_e158.direction.z);
                if (_e385 >= _e387) {
                    if (_e385 >= _e389) {
                        phi_997_ = false;
                    } else {
                        phi_997_ = true;
                    }
                    let _e393 = phi_997_;
                    phi_998_ = _e393;
                } else {
                    phi_998_ = true;
                }
                let _e395 = phi_998_;
                if _e395 {
                    if (_e387 >= _e389) {
                        phi_1006_ = 1u;
                    } else {
                        phi_1006_ = 2u;
                    }
                    let _e398 = phi_1006_;
                    phi_1007_ = _e398;
                } else {
                    phi_1007_ = 0u;
                }
                let _e400 = phi_1007_;
                if (_e400 == 0u) {
                    phi_1026_ = vec3<f32>(_e158.direction.y, _e158.direction.z, _e158.direction.x);
                } else {
                    if (_e400 == 1u) {
                        phi_1025_ = vec3<f32>(_e158.direction.z, _e158.direction.x, _e158.direction.y);
                    } else {
                        phi_1025_ = _e158.direction;
                    }
                    let _e413 = phi_1025_;
                    phi_1026_ = _e413;
                }
                let _e415 = phi_1026_;
                let _e419 = (_e415.x / _e415.z);
                let _e422 = (_e415.y / _e415.z);
                if (_e312 < 0f) {
                    phi_1040_ = 0u;
                } else {
                    phi_1040_ = 1u;
                }
                let _e427 = phi_1040_;
                if (_e324 < 0f) {
                    phi_1045_ = 0u;
                } else {
                    phi_1045_ = 2u;
                }
                let _e430 = phi_1045_;
                if (_e336 < 0f) {
                    phi_1050_ = 0u;
                } else {
                    phi_1050_ = 4u;
                }
                let _e433 = phi_1050_;
                let _e435 = ((_e427 | _e430) | _e433);
                let _e436 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e436.first[0], _e436.first[1], _e436.first[2], _e436.first[3], _e436.first[4], _e436.first[5], _e436.first[6], _e436.first[7], _e436.first[8], _e436.first[9], _e436.first[10], _e436.first[11], _e436.first[12], _e436.first[13], _e436.first[14], _e436.first[15], _e436.first[16], _e436.first[17], _e436.first[18], _e436.first[19], _e436.first[20], _e436.first[21], _e436.first[22], _e436.first[23], _e436.first[24], _e436.first[25], _e436.first[26], _e436.first[27], _e436.first[28], _e436.first[29], _e436.first[30], _e436.first[31]), array<u32, 32>(_e436.mask[0], _e436.mask[1], _e436.mask[2], _e436.mask[3], _e436.mask[4], _e436.mask[5], _e436.mask[6], _e436.mask[7], _e436.mask[8], _e436.mask[9], _e436.mask[10], _e436.mask[11], _e436.mask[12], _e436.mask[13], _e436.mask[14], _e436.mask[15], _e436.mask[16], _e436.mask[17], _e436.mask[18], _e436.mask[19], _e436.mask[20], _e436.mask[21], _e436.mask[22], _e436.mask[23], _e436.mask[24], _e436.mask[25], _e436.mask[26], _e436.mask[27], _e436.mask[28], _e436.mask[29], _e436.mask[30], _e436.mask[31]), _e436.len, _e436.group, _e436.group_mask);
                let _e510 = local_1.group_mask;
                if ((_e510 & 4278190080u) == 0u) {
                    let _e514 = local_1.len;
                    if (_e514 == 0u) {
                        phi_1164_ = false;
                    } else {
                        let _e518 = local_1.len;
                        local_1.len = (_e518 - 1u);
                        let _e521 = local_1.len;
                        if (_e521 < 32u) {
                        } else {
                            return;
                        }
                        let _e526 = local_1.first[(0u + _e521)];
                        local_1.group = _e526;
                        let _e529 = local_1.len;
                        if (_e529 < 32u) {
                        } else {
                            return;
                        }
                        let _e534 = local_1.mask[(0u + _e529)];
                        local_1.group_mask = _e534;
                        phi_1164_ = true;
                    }
                    let _e537 = phi_1164_;
                    phi_1165_ = _e537;
                } else {
                    phi_1165_ = true;
                }
                let _e539 = phi_1165_;
                if _e539 {
                    let _e541 = local_1.group_mask;
                    let _e547 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e541)), 32u, (_e541 == 0u)));
                    let _e551 = local_1.group_mask;
                    let _e565 = local_1.group_mask;
                    local_1.group_mask = (_e565 & ~((1u << bitcast<u32>((_e547 & 31u)))));
                    let _e568 = local_1.group;
                    phi_1196_ = (_e568 + countOneBits(((_e551 & ~((4294967295u << bitcast<u32>((((_e547 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1196_ = 4294967295u;
                }
                let _e571 = phi_1196_;
                phi_1198_ = _e160;
                phi_1201_ = _e571;
                loop {
                    let _e573 = phi_1198_;
                    let _e575 = phi_1201_;
                    local_6 = _e573;
                    let _e576 = (_e575 != 4294967295u);
                    if _e576 {
                        if (_e575 < _e76) {
                        } else {
                            return;
                        }
                        let _e584 = nodes.member[(0u + _e575)].frame[3u];
                        let _e609 = (bitcast<f32>((((_e584 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e312);
                        let _e610 = (bitcast<f32>((((_e584 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e324);
                        let _e611 = (bitcast<f32>((((_e584 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e336);
                        let _e614 = nodes.member[(0u + _e575)].frame[0u];
                        let _e618 = nodes.member[(0u + _e575)].frame[1u];
                        let _e622 = nodes.member[(0u + _e575)].frame[2u];
                        let _e630 = ((bitcast<f32>(_e614) - _e158.origin.x) * _e312);
                        let _e631 = ((bitcast<f32>(_e618) - _e158.origin.y) * _e324);
                        let _e632 = ((bitcast<f32>(_e622) - _e158.origin.z) * _e336);
                        let _e640 = nodes.member[(0u + _e575)].x;
                        if (_e312 < 0f) {
                            let _e651 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e640.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e657 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e651.unnamed.word, _e640.w), _e651.unnamed_1);
                            let _e663 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e657.unnamed, lt_mask_LightPlace(_e640.x, _e657.unnamed_1.shift));
                            phi_1286_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e663.unnamed, lt_mask_LightPlace(_e663.unnamed_1.word, _e640.y));
                        } else {
                            let _e679 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e640.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e685 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e679.unnamed.word, _e640.y), _e679.unnamed_1);
                            let _e691 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e685.unnamed, lt_mask_LightPlace(_e640.z, _e685.unnamed_1.shift));
                            phi_1286_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e691.unnamed, lt_mask_LightPlace(_e691.unnamed_1.word, _e640.w));
                        }
                        let _e699 = phi_1286_;
                        let _e709 = nodes.member[(0u + _e575)].y;
                        if (_e324 < 0f) {
                            let _e720 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e709.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e726 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e720.unnamed.word, _e709.w), _e720.unnamed_1);
                            let _e732 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e726.unnamed, lt_mask_LightPlace(_e709.x, _e726.unnamed_1.shift));
                            phi_1313_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e732.unnamed, lt_mask_LightPlace(_e732.unnamed_1.word, _e709.y));
                        } else {
                            let _e748 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e709.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e754 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e748.unnamed.word, _e709.y), _e748.unnamed_1);
                            let _e760 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e754.unnamed, lt_mask_LightPlace(_e709.z, _e754.unnamed_1.shift));
                            phi_1313_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e760.unnamed, lt_mask_LightPlace(_e760.unnamed_1.word, _e709.w));
                        }
                        let _e768 = phi_1313_;
                        let _e778 = nodes.member[(0u + _e575)].z;
                        if (_e336 < 0f) {
                            let _e789 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e778.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e795 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e789.unnamed.word, _e778.w), _e789.unnamed_1);
                            let _e801 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e795.unnamed, lt_mask_LightPlace(_e778.x, _e795.unnamed_1.shift));
                            phi_1340_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e801.unnamed, lt_mask_LightPlace(_e801.unnamed_1.word, _e778.y));
                        } else {
                            let _e817 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e778.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e823 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e817.unnamed.word, _e778.y), _e817.unnamed_1);
                            let _e829 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e823.unnamed, lt_mask_LightPlace(_e778.z, _e823.unnamed_1.shift));
                            phi_1340_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e829.unnamed, lt_mask_LightPlace(_e829.unnamed_1.word, _e778.w));
                        }
                        let _e837 = phi_1340_;
                        phi_1346_ = 0u;
                        phi_1349_ = 0u;
                        loop {
                            let _e847 = phi_1346_;
                            let _e849 = phi_1349_;
                            local_2 = _e849;
                            local_3 = _e849;
                            local_4 = _e849;
                            let _e850 = (_e847 < 8u);
                            if _e850 {
                                let _e852 = (_e847 >> bitcast<u32>(2i));
                                let _e853 = (_e847 & 3u);
                                if (_e852 == 0u) {
                                    phi_1363_ = _e699.unnamed.word;
                                } else {
                                    phi_1363_ = _e699.unnamed.shift;
                                }
                                let _e856 = phi_1363_;
                                if (_e852 == 0u) {
                                    phi_1373_ = _e768.unnamed.word;
                                } else {
                                    phi_1373_ = _e768.unnamed.shift;
                                }
                                let _e865 = phi_1373_;
                                if (_e852 == 0u) {
                                    phi_1383_ = _e837.unnamed.word;
                                } else {
                                    phi_1383_ = _e837.unnamed.shift;
                                }
                                let _e874 = phi_1383_;
                                let _e887 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e856 >> bitcast<u32>(((_e853 * 8u) & 31u))) & 255u)) * _e609) + (_e630 - _e373)), ((f32(((_e865 >> bitcast<u32>(((_e853 * 8u) & 31u))) & 255u)) * _e610) + (_e631 - _e374)));
                                let _e888 = core_intrinsics_maximum_number_nsz_f32_(_e887, ((f32(((_e874 >> bitcast<u32>(((_e853 * 8u) & 31u))) & 255u)) * _e611) + (_e632 - _e375)));
                                if (_e852 == 0u) {
                                    phi_1401_ = _e699.unnamed_1.word;
                                } else {
                                    phi_1401_ = _e699.unnamed_1.shift;
                                }
                                let _e891 = phi_1401_;
                                if (_e852 == 0u) {
                                    phi_1411_ = _e768.unnamed_1.word;
                                } else {
                                    phi_1411_ = _e768.unnamed_1.shift;
                                }
                                let _e900 = phi_1411_;
                                if (_e852 == 0u) {
                                    phi_1421_ = _e837.unnamed_1.word;
                                } else {
                                    phi_1421_ = _e837.unnamed_1.shift;
                                }
                                let _e909 = phi_1421_;
                                let _e922 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e891 >> bitcast<u32>(((_e853 * 8u) & 31u))) & 255u)) * _e609) + (_e630 + _e373)), ((f32(((_e900 >> bitcast<u32>(((_e853 * 8u) & 31u))) & 255u)) * _e610) + (_e631 + _e374)));
                                let _e923 = core_intrinsics_minimum_number_nsz_f32_(_e922, ((f32(((_e909 >> bitcast<u32>(((_e853 * 8u) & 31u))) & 255u)) * _e611) + (_e632 + _e375)));
                                if (_e888 <= _e923) {
                                    if (_e888 <= _e573.t) {
                                        if (_e923 >= _e158.tmin) {
                                            if (_e852 == 0u) {
                                                let _e930 = nodes.member[(0u + _e575)].links[2u];
                                                phi_1457_ = _e930;
                                            } else {
                                                let _e933 = nodes.member[(0u + _e575)].links[3u];
                                                phi_1457_ = _e933;
                                            }
                                            let _e935 = phi_1457_;
                                            let _e940 = ((_e935 >> bitcast<u32>(((_e853 * 8u) & 31u))) & 255u);
                                            let _e941 = (_e940 & 31u);
                                            if (_e941 >= 24u) {
                                                phi_1470_ = (24u + ((_e941 - 24u) ^ _e435));
                                            } else {
                                                phi_1470_ = _e941;
                                            }
                                            let _e947 = phi_1470_;
                                            phi_1475_ = (_e849 | ((_e940 >> bitcast<u32>(5i)) << bitcast<u32>((_e947 & 31u))));
                                        } else {
                                            phi_1475_ = _e849;
                                        }
                                        let _e955 = phi_1475_;
                                        phi_1476_ = _e955;
                                    } else {
                                        phi_1476_ = _e849;
                                    }
                                    let _e957 = phi_1476_;
                                    phi_1477_ = _e957;
                                } else {
                                    phi_1477_ = _e849;
                                }
                                let _e959 = phi_1477_;
                                phi_1347_ = (_e847 + 1u);
                                phi_1350_ = _e959;
                            } else {
                                phi_1347_ = u32();
                                phi_1350_ = u32();
                            }
                            let _e962 = phi_1347_;
                            let _e964 = phi_1350_;
                            continue;
                            continuing {
                                phi_1346_ = _e962;
                                phi_1349_ = _e964;
                                break if !(_e850);
                            }
                        }
                        let _e968 = nodes.member[(0u + _e575)].links[0u];
                        let _e972 = nodes.member[(0u + _e575)].frame[3u];
                        let _e976 = local_2;
                        if ((_e976 & 4278190080u) == 0u) {
                        } else {
                            let _e980 = local_1.group_mask;
                            if ((_e980 & 4278190080u) == 0u) {
                            } else {
                                let _e984 = local_1.len;
                                if (_e984 < 32u) {
                                    let _e987 = local_1.group;
                                    let _e989 = local_1.len;
                                    if (_e989 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.first[(0u + _e989)] = _e987;
                                    let _e995 = local_1.group_mask;
                                    let _e997 = local_1.len;
                                    if (_e997 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.mask[(0u + _e997)] = _e995;
                                    let _e1004 = local_1.len;
                                    local_1.len = (_e1004 + 1u);
                                }
                            }
                            local_1.group = (0u + _e968);
                            let _e1008 = local_3;
                            local_1.group_mask = ((_e1008 & 4278190080u) | (_e972 >> bitcast<u32>(24i)));
                        }
                        let _e1013 = local_4;
                        phi_1535_ = _e573;
                        phi_1538_ = (_e1013 & 16777215u);
                        loop {
                            let _e1016 = phi_1535_;
                            let _e1018 = phi_1538_;
                            local_5 = _e1016;
                            if (_e1018 == 0u) {
                                phi_1536_ = lt_bvh_Hit();
                                phi_1539_ = u32();
                                phi_2197_ = false;
                            } else {
                                let _e1022 = nodes.member[(0u + _e575)].links[1u];
                                let _e1027 = ((0u + _e1022) + select(firstTrailingBit(_e1018), 32u, (_e1018 == 0u)));
                                if (_e1027 < _e79) {
                                } else {
                                    return;
                                }
                                let _e1034 = triangles.member[(0u + _e1027)].v0_;
                                let _e1037 = (_e1034.x - _e158.origin.x);
                                let _e1040 = (_e1034.y - _e158.origin.y);
                                let _e1043 = (_e1034.z - _e158.origin.z);
                                if (_e400 == 0u) {
                                    phi_1585_ = vec3<f32>(_e1040, _e1043, _e1037);
                                } else {
                                    if (_e400 == 1u) {
                                        phi_1584_ = vec3<f32>(_e1043, _e1037, _e1040);
                                    } else {
                                        phi_1584_ = (_e1034 - _e158.origin);
                                    }
                                    let _e1050 = phi_1584_;
                                    phi_1585_ = _e1050;
                                }
                                let _e1052 = phi_1585_;
                                let _e1056 = (_e1052.x - (_e419 * _e1052.z));
                                let _e1060 = (_e1052.y - (_e422 * _e1052.z));
                                let _e1062 = triangles.member[(0u + _e1027)].v1_;
                                let _e1065 = (_e1062.x - _e158.origin.x);
                                let _e1068 = (_e1062.y - _e158.origin.y);
                                let _e1071 = (_e1062.z - _e158.origin.z);
                                if (_e400 == 0u) {
                                    phi_1617_ = vec3<f32>(_e1068, _e1071, _e1065);
                                } else {
                                    if (_e400 == 1u) {
                                        phi_1616_ = vec3<f32>(_e1071, _e1065, _e1068);
                                    } else {
                                        phi_1616_ = (_e1062 - _e158.origin);
                                    }
                                    let _e1078 = phi_1616_;
                                    phi_1617_ = _e1078;
                                }
                                let _e1080 = phi_1617_;
                                let _e1084 = (_e1080.x - (_e419 * _e1080.z));
                                let _e1088 = (_e1080.y - (_e422 * _e1080.z));
                                let _e1090 = triangles.member[(0u + _e1027)].v2_;
                                let _e1093 = (_e1090.x - _e158.origin.x);
                                let _e1096 = (_e1090.y - _e158.origin.y);
                                let _e1099 = (_e1090.z - _e158.origin.z);
                                if (_e400 == 0u) {
                                    phi_1649_ = vec3<f32>(_e1096, _e1099, _e1093);
                                } else {
                                    if (_e400 == 1u) {
                                        phi_1648_ = vec3<f32>(_e1099, _e1093, _e1096);
                                    } else {
                                        phi_1648_ = (_e1090 - _e158.origin);
                                    }
                                    let _e1106 = phi_1648_;
                                    phi_1649_ = _e1106;
                                }
                                let _e1108 = phi_1649_;
                                let _e1112 = (_e1108.x - (_e419 * _e1108.z));
                                let _e1116 = (_e1108.y - (_e422 * _e1108.z));
                                if (_e1084 < _e1112) {
                                    phi_1668_ = true;
                                } else {
                                    if (_e1084 == _e1112) {
                                        phi_1667_ = (_e1088 < _e1116);
                                    } else {
                                        phi_1667_ = false;
                                    }
                                    let _e1121 = phi_1667_;
                                    phi_1668_ = _e1121;
                                }
                                let _e1123 = phi_1668_;
                                if _e1123 {
                                    phi_1672_ = _e1116;
                                    phi_1673_ = _e1112;
                                    phi_1674_ = _e1088;
                                    phi_1675_ = _e1084;
                                } else {
                                    phi_1672_ = _e1088;
                                    phi_1673_ = _e1084;
                                    phi_1674_ = _e1116;
                                    phi_1675_ = _e1112;
                                }
                                let _e1125 = phi_1672_;
                                let _e1127 = phi_1673_;
                                let _e1129 = phi_1674_;
                                let _e1131 = phi_1675_;
                                let _e1134 = ((_e1131 * _e1125) - (_e1129 * _e1127));
                                if _e1123 {
                                    phi_1683_ = -(_e1134);
                                } else {
                                    phi_1683_ = _e1134;
                                }
                                let _e1137 = phi_1683_;
                                if (_e1112 < _e1056) {
                                    phi_1694_ = true;
                                } else {
                                    if (_e1112 == _e1056) {
                                        phi_1693_ = (_e1116 < _e1060);
                                    } else {
                                        phi_1693_ = false;
                                    }
                                    let _e1142 = phi_1693_;
                                    phi_1694_ = _e1142;
                                }
                                let _e1144 = phi_1694_;
                                if _e1144 {
                                    phi_1698_ = _e1060;
                                    phi_1699_ = _e1056;
                                    phi_1700_ = _e1116;
                                    phi_1701_ = _e1112;
                                } else {
                                    phi_1698_ = _e1116;
                                    phi_1699_ = _e1112;
                                    phi_1700_ = _e1060;
                                    phi_1701_ = _e1056;
                                }
                                let _e1146 = phi_1698_;
                                let _e1148 = phi_1699_;
                                let _e1150 = phi_1700_;
                                let _e1152 = phi_1701_;
                                let _e1155 = ((_e1152 * _e1146) - (_e1150 * _e1148));
                                if _e1144 {
                                    phi_1709_ = -(_e1155);
                                } else {
                                    phi_1709_ = _e1155;
                                }
                                let _e1158 = phi_1709_;
                                if (_e1056 < _e1084) {
                                    phi_1720_ = true;
                                } else {
                                    if (_e1056 == _e1084) {
                                        phi_1719_ = (_e1060 < _e1088);
                                    } else {
                                        phi_1719_ = false;
                                    }
                                    let _e1163 = phi_1719_;
                                    phi_1720_ = _e1163;
                                }
                                let _e1165 = phi_1720_;
                                if _e1165 {
                                    phi_1724_ = _e1088;
                                    phi_1725_ = _e1084;
                                    phi_1726_ = _e1060;
                                    phi_1727_ = _e1056;
                                } else {
                                    phi_1724_ = _e1060;
                                    phi_1725_ = _e1056;
                                    phi_1726_ = _e1088;
                                    phi_1727_ = _e1084;
                                }
                                let _e1167 = phi_1724_;
                                let _e1169 = phi_1725_;
                                let _e1171 = phi_1726_;
                                let _e1173 = phi_1727_;
                                let _e1176 = ((_e1173 * _e1167) - (_e1171 * _e1169));
                                if _e1165 {
                                    phi_1735_ = -(_e1176);
                                } else {
                                    phi_1735_ = _e1176;
                                }
                                let _e1179 = phi_1735_;
                                if (_e1137 >= 0f) {
                                    if (_e1158 >= 0f) {
                                        if (_e1179 >= 0f) {
                                            phi_1750_ = ((_e1137 + _e1158) + _e1179);
                                            phi_1751_ = false;
                                        } else {
                                            phi_1750_ = f32();
                                            phi_1751_ = true;
                                        }
                                        let _e1186 = phi_1750_;
                                        let _e1188 = phi_1751_;
                                        phi_1752_ = _e1186;
                                        phi_1753_ = _e1188;
                                    } else {
                                        phi_1752_ = f32();
                                        phi_1753_ = true;
                                    }
                                    let _e1190 = phi_1752_;
                                    let _e1192 = phi_1753_;
                                    phi_1754_ = _e1190;
                                    phi_1755_ = _e1192;
                                } else {
                                    phi_1754_ = f32();
                                    phi_1755_ = true;
                                }
                                let _e1194 = phi_1754_;
                                let _e1196 = phi_1755_;
                                if _e1196 {
                                    if (_e1137 <= 0f) {
                                        if (_e1158 <= 0f) {
                                            let _e1199 = (_e1179 <= 0f);
                                            if _e1199 {
                                            }
                                            phi_1773_ = ((_e1137 + _e1158) + _e1179);
                                            phi_1774_ = false;
                                            phi_1775_ = _e1199;
                                        } else {
                                            phi_1773_ = f32();
                                            phi_1774_ = true;
                                            phi_1775_ = false;
                                        }
                                        let _e1203 = phi_1773_;
                                        let _e1205 = phi_1774_;
                                        let _e1207 = phi_1775_;
                                        phi_1776_ = _e1203;
                                        phi_1777_ = _e1205;
                                        phi_1778_ = _e1207;
                                    } else {
                                        phi_1776_ = f32();
                                        phi_1777_ = true;
                                        phi_1778_ = false;
                                    }
                                    let _e1209 = phi_1776_;
                                    let _e1211 = phi_1777_;
                                    let _e1213 = phi_1778_;
                                    if _e1211 {
                                        phi_1782_ = false;
                                    } else {
                                        phi_1782_ = _e1213;
                                    }
                                    let _e1215 = phi_1782_;
                                    phi_1783_ = _e1209;
                                    phi_1784_ = _e1215;
                                } else {
                                    phi_1783_ = _e1194;
                                    phi_1784_ = true;
                                }
                                let _e1217 = phi_1783_;
                                let _e1219 = phi_1784_;
                                if _e1219 {
                                    let _e1220 = (_e1217 == 0f);
                                    if _e1220 {
                                        phi_2110_ = lt_bvh_triangle_Intersection();
                                        phi_2111_ = false;
                                    } else {
                                        let _e1222 = triangles.member[(0u + _e1027)].v0_;
                                        let _e1225 = (_e1222.x - _e158.origin.x);
                                        let _e1228 = (_e1222.y - _e158.origin.y);
                                        let _e1231 = (_e1222.z - _e158.origin.z);
                                        if (_e400 == 0u) {
                                            phi_1815_ = vec3<f32>(_e1228, _e1231, _e1225);
                                        } else {
                                            if (_e400 == 1u) {
                                                phi_1814_ = vec3<f32>(_e1231, _e1225, _e1228);
                                            } else {
                                                phi_1814_ = (_e1222 - _e158.origin);
                                            }
                                            let _e1238 = phi_1814_;
                                            phi_1815_ = _e1238;
                                        }
                                        let _e1240 = phi_1815_;
                                        let _e1242 = triangles.member[(0u + _e1027)].v1_;
                                        let _e1244 = triangles.member[(0u + _e1027)].v0_;
                                        let _e1247 = (_e1242.x - _e1244.x);
                                        let _e1250 = (_e1242.y - _e1244.y);
                                        let _e1253 = (_e1242.z - _e1244.z);
                                        if (_e400 == 0u) {
                                            phi_1841_ = vec3<f32>(_e1250, _e1253, _e1247);
                                        } else {
                                            if (_e400 == 1u) {
                                                phi_1840_ = vec3<f32>(_e1253, _e1247, _e1250);
                                            } else {
                                                phi_1840_ = (_e1242 - _e1244);
                                            }
                                            let _e1260 = phi_1840_;
                                            phi_1841_ = _e1260;
                                        }
                                        let _e1262 = phi_1841_;
                                        let _e1264 = triangles.member[(0u + _e1027)].v2_;
                                        let _e1266 = triangles.member[(0u + _e1027)].v0_;
                                        let _e1269 = (_e1264.x - _e1266.x);
                                        let _e1272 = (_e1264.y - _e1266.y);
                                        let _e1275 = (_e1264.z - _e1266.z);
                                        if (_e400 == 0u) {
                                            phi_1867_ = vec3<f32>(_e1272, _e1275, _e1269);
                                        } else {
                                            if (_e400 == 1u) {
                                                phi_1866_ = vec3<f32>(_e1275, _e1269, _e1272);
                                            } else {
                                                phi_1866_ = (_e1264 - _e1266);
                                            }
                                            let _e1282 = phi_1866_;
                                            phi_1867_ = _e1282;
                                        }
                                        let _e1284 = phi_1867_;
                                        let _e1291 = ((_e1262.y * _e1284.z) - (_e1262.z * _e1284.y));
                                        let _e1298 = ((_e1262.z * _e1284.x) - (_e1262.x * _e1284.z));
                                        let _e1305 = ((_e1262.x * _e1284.y) - (_e1262.y * _e1284.x));
                                        let _e1319 = (((1f / _e415.z) * (((_e1291 * _e1240.x) + (_e1298 * _e1240.y)) + (_e1305 * _e1240.z))) / (((_e1291 * _e419) + (_e1298 * _e422)) + _e1305));
                                        if (_e1319 > _e158.tmin) {
                                            if (_e1319 < _e158.tmax) {
                                                let _e1325 = triangles.member[(0u + _e1027)].v0_;
                                                let _e1327 = triangles.member[(0u + _e1027)].v1_;
                                                if (_e1325.x < _e1327.x) {
                                                    phi_1925_ = _e1325.x;
                                                } else {
                                                    phi_1925_ = _e1327.x;
                                                }
                                                let _e1334 = phi_1925_;
                                                if (_e1325.y < _e1327.y) {
                                                    phi_1934_ = _e1325.y;
                                                } else {
                                                    phi_1934_ = _e1327.y;
                                                }
                                                let _e1341 = phi_1934_;
                                                if (_e1325.z < _e1327.z) {
                                                    phi_1943_ = _e1325.z;
                                                } else {
                                                    phi_1943_ = _e1327.z;
                                                }
                                                let _e1348 = phi_1943_;
                                                let _e1350 = triangles.member[(0u + _e1027)].v2_;
                                                if (_e1334 < _e1350.x) {
                                                    phi_1952_ = _e1334;
                                                } else {
                                                    phi_1952_ = _e1350.x;
                                                }
                                                let _e1355 = phi_1952_;
                                                if (_e1341 < _e1350.y) {
                                                    phi_1959_ = _e1341;
                                                } else {
                                                    phi_1959_ = _e1350.y;
                                                }
                                                let _e1360 = phi_1959_;
                                                if (_e1348 < _e1350.z) {
                                                    phi_1966_ = _e1348;
                                                } else {
                                                    phi_1966_ = _e1350.z;
                                                }
                                                let _e1365 = phi_1966_;
                                                let _e1367 = triangles.member[(0u + _e1027)].v0_;
                                                let _e1369 = triangles.member[(0u + _e1027)].v1_;
                                                if (_e1367.x > _e1369.x) {
                                                    phi_1979_ = _e1367.x;
                                                } else {
                                                    phi_1979_ = _e1369.x;
                                                }
                                                let _e1376 = phi_1979_;
                                                if (_e1367.y > _e1369.y) {
                                                    phi_1988_ = _e1367.y;
                                                } else {
                                                    phi_1988_ = _e1369.y;
                                                }
                                                let _e1383 = phi_1988_;
                                                if (_e1367.z > _e1369.z) {
                                                    phi_1997_ = _e1367.z;
                                                } else {
                                                    phi_1997_ = _e1369.z;
                                                }
                                                let _e1390 = phi_1997_;
                                                let _e1392 = triangles.member[(0u + _e1027)].v2_;
                                                if (_e1376 > _e1392.x) {
                                                    phi_2006_ = _e1376;
                                                } else {
                                                    phi_2006_ = _e1392.x;
                                                }
                                                let _e1397 = phi_2006_;
                                                if (_e1383 > _e1392.y) {
                                                    phi_2013_ = _e1383;
                                                } else {
                                                    phi_2013_ = _e1392.y;
                                                }
                                                let _e1402 = phi_2013_;
                                                if (_e1390 > _e1392.z) {
                                                    phi_2020_ = _e1390;
                                                } else {
                                                    phi_2020_ = _e1392.z;
                                                }
                                                let _e1407 = phi_2020_;
                                                let _e1414 = ((_e1355 - _e158.origin.x) * _e312);
                                                let _e1415 = ((_e1360 - _e158.origin.y) * _e324);
                                                let _e1416 = ((_e1365 - _e158.origin.z) * _e336);
                                                let _e1423 = ((_e1397 - _e158.origin.x) * _e312);
                                                let _e1424 = ((_e1402 - _e158.origin.y) * _e324);
                                                let _e1425 = ((_e1407 - _e158.origin.z) * _e336);
                                                if (_e1414 < _e1423) {
                                                    phi_2043_ = _e1414;
                                                } else {
                                                    phi_2043_ = _e1423;
                                                }
                                                let _e1428 = phi_2043_;
                                                if (_e1415 < _e1424) {
                                                    phi_2048_ = _e1415;
                                                } else {
                                                    phi_2048_ = _e1424;
                                                }
                                                let _e1431 = phi_2048_;
                                                if (_e1416 < _e1425) {
                                                    phi_2053_ = _e1416;
                                                } else {
                                                    phi_2053_ = _e1425;
                                                }
                                                let _e1434 = phi_2053_;
                                                if (_e1414 > _e1423) {
                                                    phi_2061_ = _e1414;
                                                } else {
                                                    phi_2061_ = _e1423;
                                                }
                                                let _e1440 = phi_2061_;
                                                if (_e1415 > _e1424) {
                                                    phi_2066_ = _e1415;
                                                } else {
                                                    phi_2066_ = _e1424;
                                                }
                                                let _e1443 = phi_2066_;
                                                if (_e1416 > _e1425) {
                                                    phi_2071_ = _e1416;
                                                } else {
                                                    phi_2071_ = _e1425;
                                                }
                                                let _e1446 = phi_2071_;
                                                let _e1450 = core_intrinsics_maximum_number_nsz_f32_((_e1428 - _e380), (_e1431 - _e381));
                                                let _e1451 = core_intrinsics_maximum_number_nsz_f32_(_e1450, (_e1434 - _e382));
                                                let _e1452 = core_intrinsics_minimum_number_nsz_f32_((_e1440 + _e380), (_e1443 + _e381));
                                                let _e1453 = core_intrinsics_minimum_number_nsz_f32_(_e1452, (_e1446 + _e382));
                                                if (_e1451 > -300000000000000000000000000000000000000f) {
                                                    phi_2083_ = _e1451;
                                                } else {
                                                    phi_2083_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1456 = phi_2083_;
                                                if (_e1453 < 300000000000000000000000000000000000000f) {
                                                    phi_2088_ = _e1453;
                                                } else {
                                                    phi_2088_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1459 = phi_2088_;
                                                if (_e1319 < _e1456) {
                                                    phi_2093_ = _e1456;
                                                } else {
                                                    phi_2093_ = _e1319;
                                                }
                                                let _e1462 = phi_2093_;
                                                if (_e1462 > _e1459) {
                                                    phi_2098_ = _e1459;
                                                } else {
                                                    phi_2098_ = _e1462;
                                                }
                                                let _e1465 = phi_2098_;
                                                phi_2103_ = lt_bvh_triangle_Intersection(_e1465, (_e1158 / _e1217), (_e1179 / _e1217), (_e1456 <= _e1459));
                                                phi_2104_ = false;
                                            } else {
                                                phi_2103_ = lt_bvh_triangle_Intersection();
                                                phi_2104_ = true;
                                            }
                                            let _e1471 = phi_2103_;
                                            let _e1473 = phi_2104_;
                                            phi_2105_ = _e1471;
                                            phi_2106_ = _e1473;
                                        } else {
                                            phi_2105_ = lt_bvh_triangle_Intersection();
                                            phi_2106_ = true;
                                        }
                                        let _e1475 = phi_2105_;
                                        let _e1477 = phi_2106_;
                                        if _e1477 {
                                        }
                                        phi_2110_ = _e1475;
                                        phi_2111_ = _e1477;
                                    }
                                    let _e1479 = phi_2110_;
                                    let _e1481 = phi_2111_;
                                    phi_2112_ = _e1479;
                                    phi_2113_ = _e1220;
                                    phi_2114_ = _e1481;
                                } else {
                                    phi_2112_ = lt_bvh_triangle_Intersection();
                                    phi_2113_ = true;
                                    phi_2114_ = false;
                                }
                                let _e1483 = phi_2112_;
                                let _e1485 = phi_2113_;
                                let _e1487 = phi_2114_;
                                if _e1485 {
                                    phi_2118_ = true;
                                } else {
                                    phi_2118_ = _e1487;
                                }
                                let _e1489 = phi_2118_;
                                if _e1489 {
                                    phi_2122_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_2122_ = _e1483;
                                }
                                let _e1491 = phi_2122_;
                                if _e1491.is_hit {
                                    if (_e1491.t > _e158.tmin) {
                                        if (_e1491.t < _e1016.t) {
                                            phi_2171_ = true;
                                        } else {
                                            if (_e1491.t == _e1016.t) {
                                                if (_e1016.triangle != 4294967295u) {
                                                    if (_e1027 < _e1016.triangle) {
                                                        phi_2162_ = true;
                                                    } else {
                                                        if (_e1027 == _e1016.triangle) {
                                                            phi_2161_ = (4294967295u < _e1016.instance);
                                                        } else {
                                                            phi_2161_ = false;
                                                        }
                                                        let _e1510 = phi_2161_;
                                                        phi_2162_ = _e1510;
                                                    }
                                                    let _e1512 = phi_2162_;
                                                    phi_2163_ = _e1512;
                                                    phi_2164_ = false;
                                                } else {
                                                    phi_2163_ = bool();
                                                    phi_2164_ = true;
                                                }
                                                let _e1514 = phi_2163_;
                                                let _e1516 = phi_2164_;
                                                phi_2165_ = _e1514;
                                                phi_2166_ = _e1516;
                                            } else {
                                                phi_2165_ = bool();
                                                phi_2166_ = true;
                                            }
                                            let _e1518 = phi_2165_;
                                            let _e1520 = phi_2166_;
                                            if _e1520 {
                                                phi_2170_ = false;
                                            } else {
                                                phi_2170_ = _e1518;
                                            }
                                            let _e1522 = phi_2170_;
                                            phi_2171_ = _e1522;
                                        }
                                        let _e1524 = phi_2171_;
                                        if _e1524 {
                                            let _e1526 = triangles.member[(0u + _e1027)].i0_;
                                            if ((_e1526 & 2147483648u) == 0u) {
                                                phi_2185_ = true;
                                            } else {
                                                if true {
                                                }
                                                phi_2185_ = true;
                                            }
                                            let _e1530 = phi_2185_;
                                            if _e1530 {
                                                phi_2193_ = lt_bvh_Hit(_e1491.t, _e1491.u, _e1491.v, _e1027, 4294967295u);
                                            } else {
                                                phi_2193_ = _e1016;
                                            }
                                            let _e1536 = phi_2193_;
                                            phi_2194_ = _e1536;
                                        } else {
                                            phi_2194_ = _e1016;
                                        }
                                        let _e1538 = phi_2194_;
                                        phi_2195_ = _e1538;
                                    } else {
                                        phi_2195_ = _e1016;
                                    }
                                    let _e1540 = phi_2195_;
                                    phi_2196_ = _e1540;
                                } else {
                                    phi_2196_ = _e1016;
                                }
                                let _e1542 = phi_2196_;
                                phi_1536_ = _e1542;
                                phi_1539_ = (_e1018 & (_e1018 - 1u));
                                phi_2197_ = true;
                            }
                            let _e1544 = phi_1536_;
                            let _e1546 = phi_1539_;
                            let _e1548 = phi_2197_;
                            continue;
                            continuing {
                                phi_1535_ = _e1544;
                                phi_1538_ = _e1546;
                                break if !(_e1548);
                            }
                        }
                        let _e1551 = local_1.group_mask;
                        if ((_e1551 & 4278190080u) == 0u) {
                            let _e1555 = local_1.len;
                            if (_e1555 == 0u) {
                                phi_2236_ = false;
                            } else {
                                let _e1559 = local_1.len;
                                local_1.len = (_e1559 - 1u);
                                let _e1562 = local_1.len;
                                if (_e1562 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1567 = local_1.first[(0u + _e1562)];
                                local_1.group = _e1567;
                                let _e1570 = local_1.len;
                                if (_e1570 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1575 = local_1.mask[(0u + _e1570)];
                                local_1.group_mask = _e1575;
                                phi_2236_ = true;
                            }
                            let _e1578 = phi_2236_;
                            phi_2237_ = _e1578;
                        } else {
                            phi_2237_ = true;
                        }
                        let _e1580 = phi_2237_;
                        if _e1580 {
                            let _e1582 = local_1.group_mask;
                            let _e1588 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1582)), 32u, (_e1582 == 0u)));
                            let _e1592 = local_1.group_mask;
                            let _e1606 = local_1.group_mask;
                            local_1.group_mask = (_e1606 & ~((1u << bitcast<u32>((_e1588 & 31u)))));
                            let _e1609 = local_1.group;
                            phi_2268_ = (_e1609 + countOneBits(((_e1592 & ~((4294967295u << bitcast<u32>((((_e1588 - 24u) ^ _e435) & 31u))))) & 255u)));
                        } else {
                            phi_2268_ = 4294967295u;
                        }
                        let _e1612 = phi_2268_;
                        let _e2532 = local_5;
                        phi_1199_ = _e2532;
                        phi_1202_ = _e1612;
                    } else {
                        phi_1199_ = lt_bvh_Hit();
                        phi_1202_ = u32();
                    }
                    let _e1614 = phi_1199_;
                    let _e1616 = phi_1202_;
                    continue;
                    continuing {
                        phi_1198_ = _e1614;
                        phi_1201_ = _e1616;
                        break if !(_e576);
                    }
                }
                let _e2536 = local_6;
                phi_2269_ = _e2536;
            }
            let _e1619 = phi_2269_;
            phi_2270_ = _e1619;
            phi_2271_ = _e230;
        } else {
            phi_2270_ = lt_bvh_Hit();
            phi_2271_ = true;
        }
        let _e1621 = phi_2270_;
        let _e1623 = phi_2271_;
        if _e1623 {
            phi_2275_ = _e160;
        } else {
            phi_2275_ = _e1621;
        }
        let _e1625 = phi_2275_;
        if (_e1625.triangle != 4294967295u) {
            let _e1631 = ((1f - _e1625.u) - _e1625.v);
            if (_e1625.triangle < _e79) {
            } else {
                return;
            }
            let _e1636 = triangles.member[(0u + _e1625.triangle)];
            let _e1661 = (((_e1636.v0_.x * _e1631) + (_e1636.v1_.x * _e1625.u)) + (_e1636.v2_.x * _e1625.v));
            let _e1662 = (((_e1636.v0_.y * _e1631) + (_e1636.v1_.y * _e1625.u)) + (_e1636.v2_.y * _e1625.v));
            let _e1663 = (((_e1636.v0_.z * _e1631) + (_e1636.v1_.z * _e1625.u)) + (_e1636.v2_.z * _e1625.v));
            let _e1666 = abs(_e1636.v0_.x);
            let _e1668 = abs(_e1636.v0_.y);
            let _e1670 = abs(_e1636.v0_.z);
            let _e1672 = abs(_e1636.v1_.x);
            let _e1674 = abs(_e1636.v1_.y);
            let _e1676 = abs(_e1636.v1_.z);
            if (_e1666 > _e1672) {
                phi_2339_ = _e1666;
            } else {
                phi_2339_ = _e1672;
            }
            let _e1679 = phi_2339_;
            if (_e1668 > _e1674) {
                phi_2344_ = _e1668;
            } else {
                phi_2344_ = _e1674;
            }
            let _e1682 = phi_2344_;
            if (_e1670 > _e1676) {
                phi_2349_ = _e1670;
            } else {
                phi_2349_ = _e1676;
            }
            let _e1685 = phi_2349_;
            let _e1687 = abs(_e1636.v2_.x);
            let _e1689 = abs(_e1636.v2_.y);
            let _e1691 = abs(_e1636.v2_.z);
            if (_e1679 > _e1687) {
                phi_2360_ = _e1679;
            } else {
                phi_2360_ = _e1687;
            }
            let _e1694 = phi_2360_;
            if (_e1682 > _e1689) {
                phi_2365_ = _e1682;
            } else {
                phi_2365_ = _e1689;
            }
            let _e1697 = phi_2365_;
            if (_e1685 > _e1691) {
                phi_2370_ = _e1685;
            } else {
                phi_2370_ = _e1691;
            }
            let _e1700 = phi_2370_;
            let _e1703 = (_e1636.v1_.x - _e1636.v0_.x);
            let _e1706 = (_e1636.v1_.y - _e1636.v0_.y);
            let _e1709 = (_e1636.v1_.z - _e1636.v0_.z);
            let _e1712 = (_e1636.v2_.x - _e1636.v0_.x);
            let _e1715 = (_e1636.v2_.y - _e1636.v0_.y);
            let _e1718 = (_e1636.v2_.z - _e1636.v0_.z);
            let _e1722 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1706), abs(_e1709));
            let _e1723 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1703), _e1722);
            let _e1724 = (_e1703 / _e1723);
            let _e1725 = (_e1706 / _e1723);
            let _e1726 = (_e1709 / _e1723);
            let _e1730 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1715), abs(_e1718));
            let _e1731 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1712), _e1730);
            let _e1732 = (_e1712 / _e1731);
            let _e1733 = (_e1715 / _e1731);
            let _e1734 = (_e1718 / _e1731);
            let _e1737 = ((_e1725 * _e1734) - (_e1733 * _e1726));
            let _e1740 = ((_e1726 * _e1732) - (_e1734 * _e1724));
            let _e1743 = ((_e1724 * _e1733) - (_e1732 * _e1725));
            let _e1745 = p.member.eye;
            let _e1758 = (1f / sqrt((((_e1737 * _e1737) + (_e1740 * _e1740)) + (_e1743 * _e1743))));
            let _e1759 = (_e1737 * _e1758);
            let _e1760 = (_e1740 * _e1758);
            let _e1761 = (_e1743 * _e1758);
            if ((((_e1759 * (_e1745.x - _e1661)) + (_e1760 * (_e1745.y - _e1662))) + (_e1761 * (_e1745.z - _e1663))) < 0f) {
                phi_2446_ = vec3<f32>(-(_e1759), -(_e1760), -(_e1761));
            } else {
                phi_2446_ = vec3<f32>(_e1759, _e1760, _e1761);
            }
            let _e1774 = phi_2446_;
            if (_e1625.triangle < _e79) {
            } else {
                return;
            }
            let _e1779 = triangles.member[(0u + _e1625.triangle)];
            let _e1781 = (_e1779.i0_ & 2147483647u);
            if (_e1781 < _e82) {
            } else {
                return;
            }
            let _e1787 = vertices.member[(0u + _e1781)];
            if (_e1779.i1_ < _e82) {
            } else {
                return;
            }
            let _e1791 = vertices.member[(0u + _e1779.i1_)];
            if (_e1779.i2_ < _e82) {
            } else {
                return;
            }
            let _e1795 = vertices.member[(0u + _e1779.i2_)];
            let _e1796 = array<abi_Vertex, 3>(_e1787, _e1791, _e1795);
            if (_e1796[0].material < arrayLength((&materials.member))) {
            } else {
                return;
            }
            let _e1802 = materials.member[(0u + _e1796[0].material)];
            let _e1819 = (1f / 255f);
            let _e1838 = (1f / 255f);
            let _e1860 = (1f / 255f);
            if (_e1802.color_size == 0u) {
                phi_2689_ = vec3<f32>(1f, 1f, 1f);
            } else {
                local.offset = _e1802.color_offset;
                local.size = _e1802.color_size;
                local.flags = _e1802.flags;
                let _e1903 = _lt_shaders_texture_TextureView_quad((&local), (((_e1796[0].u * _e1631) + (_e1796[1].u * _e1625.u)) + (_e1796[2].u * _e1625.v)), (((_e1796[0].v * _e1631) + (_e1796[1].v * _e1625.u)) + (_e1796[2].v * _e1625.v)));
                if (_e1903.indices[0] < _e91) {
                } else {
                    return;
                }
                let _e1909 = color_texels.member[(0u + _e1903.indices[0])];
                let _e1920 = (1f / 255f);
                if (_e1903.indices[1] < _e91) {
                } else {
                    return;
                }
                let _e1934 = color_texels.member[(0u + _e1903.indices[1])];
                let _e1945 = (1f / 255f);
                if (_e1903.indices[2] < _e91) {
                } else {
                    return;
                }
                let _e1962 = color_texels.member[(0u + _e1903.indices[2])];
                let _e1973 = (1f / 255f);
                if (_e1903.indices[3] < _e91) {
                } else {
                    return;
                }
                let _e1990 = color_texels.member[(0u + _e1903.indices[3])];
                let _e2001 = (1f / 255f);
                let _e2010 = (((((f32((_e1909 & 255u)) * _e1920) * _e1903.weights.x) + ((f32((_e1934 & 255u)) * _e1945) * _e1903.weights.y)) + ((f32((_e1962 & 255u)) * _e1973) * _e1903.weights.z)) + ((f32((_e1990 & 255u)) * _e2001) * _e1903.weights.w));
                let _e2011 = (((((f32(((_e1909 >> bitcast<u32>(8i)) & 255u)) * _e1920) * _e1903.weights.x) + ((f32(((_e1934 >> bitcast<u32>(8i)) & 255u)) * _e1945) * _e1903.weights.y)) + ((f32(((_e1962 >> bitcast<u32>(8i)) & 255u)) * _e1973) * _e1903.weights.z)) + ((f32(((_e1990 >> bitcast<u32>(8i)) & 255u)) * _e2001) * _e1903.weights.w));
                let _e2012 = (((((f32(((_e1909 >> bitcast<u32>(16i)) & 255u)) * _e1920) * _e1903.weights.x) + ((f32(((_e1934 >> bitcast<u32>(16i)) & 255u)) * _e1945) * _e1903.weights.y)) + ((f32(((_e1962 >> bitcast<u32>(16i)) & 255u)) * _e1973) * _e1903.weights.z)) + ((f32(((_e1990 >> bitcast<u32>(16i)) & 255u)) * _e2001) * _e1903.weights.w));
                phi_2689_ = vec3<f32>((_e2010 * _e2010), (_e2011 * _e2011), (_e2012 * _e2012));
            }
            let _e2018 = phi_2689_;
            let _e2020 = ((_e1802.base_color.x * ((((f32((_e1796[0].color & 255u)) * _e1819) * _e1631) + ((f32((_e1796[1].color & 255u)) * _e1838) * _e1625.u)) + ((f32((_e1796[2].color & 255u)) * _e1860) * _e1625.v))) * _e2018.x);
            let _e2022 = ((_e1802.base_color.y * ((((f32(((_e1796[0].color >> bitcast<u32>(8i)) & 255u)) * _e1819) * _e1631) + ((f32(((_e1796[1].color >> bitcast<u32>(8i)) & 255u)) * _e1838) * _e1625.u)) + ((f32(((_e1796[2].color >> bitcast<u32>(8i)) & 255u)) * _e1860) * _e1625.v))) * _e2018.y);
            let _e2024 = ((_e1802.base_color.z * ((((f32(((_e1796[0].color >> bitcast<u32>(16i)) & 255u)) * _e1819) * _e1631) + ((f32(((_e1796[1].color >> bitcast<u32>(16i)) & 255u)) * _e1838) * _e1625.u)) + ((f32(((_e1796[2].color >> bitcast<u32>(16i)) & 255u)) * _e1860) * _e1625.v))) * _e2018.z);
            let _e2025 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1697, _e1700);
            let _e2026 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1694, _e2025);
            if ((_e1802.flags & 2u) == 0u) {
                phi_2704_ = 0u;
            } else {
                phi_2704_ = 1u;
            }
            let _e2031 = phi_2704_;
            if (_e1796[0].normal == 2147516416u) {
                phi_2907_ = _e1774;
            } else {
                let _e2044 = (f32((bitcast<i32>((_e1796[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2050 = (f32((bitcast<i32>(_e1796[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2054 = ((1f - abs(_e2044)) - abs(_e2050));
                if (_e2054 < 0f) {
                    phi_2731_ = -(_e2054);
                } else {
                    phi_2731_ = 0f;
                }
                let _e2058 = phi_2731_;
                if (_e2044 < 0f) {
                    phi_2738_ = (_e2044 + _e2058);
                } else {
                    phi_2738_ = (_e2044 - _e2058);
                }
                let _e2063 = phi_2738_;
                if (_e2050 < 0f) {
                    phi_2745_ = (_e2050 + _e2058);
                } else {
                    phi_2745_ = (_e2050 - _e2058);
                }
                let _e2068 = phi_2745_;
                let _e2075 = (1f / sqrt((((_e2063 * _e2063) + (_e2068 * _e2068)) + (_e2054 * _e2054))));
                let _e2091 = (f32((bitcast<i32>((_e1796[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2097 = (f32((bitcast<i32>(_e1796[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2101 = ((1f - abs(_e2091)) - abs(_e2097));
                if (_e2101 < 0f) {
                    phi_2780_ = -(_e2101);
                } else {
                    phi_2780_ = 0f;
                }
                let _e2105 = phi_2780_;
                if (_e2091 < 0f) {
                    phi_2787_ = (_e2091 + _e2105);
                } else {
                    phi_2787_ = (_e2091 - _e2105);
                }
                let _e2110 = phi_2787_;
                if (_e2097 < 0f) {
                    phi_2794_ = (_e2097 + _e2105);
                } else {
                    phi_2794_ = (_e2097 - _e2105);
                }
                let _e2115 = phi_2794_;
                let _e2122 = (1f / sqrt((((_e2110 * _e2110) + (_e2115 * _e2115)) + (_e2101 * _e2101))));
                let _e2141 = (f32((bitcast<i32>((_e1796[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2147 = (f32((bitcast<i32>(_e1796[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2151 = ((1f - abs(_e2141)) - abs(_e2147));
                if (_e2151 < 0f) {
                    phi_2832_ = -(_e2151);
                } else {
                    phi_2832_ = 0f;
                }
                let _e2155 = phi_2832_;
                if (_e2141 < 0f) {
                    phi_2839_ = (_e2141 + _e2155);
                } else {
                    phi_2839_ = (_e2141 - _e2155);
                }
                let _e2160 = phi_2839_;
                if (_e2147 < 0f) {
                    phi_2846_ = (_e2147 + _e2155);
                } else {
                    phi_2846_ = (_e2147 - _e2155);
                }
                let _e2165 = phi_2846_;
                let _e2172 = (1f / sqrt((((_e2160 * _e2160) + (_e2165 * _e2165)) + (_e2151 * _e2151))));
                let _e2183 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(vec3<f32>(((((_e2063 * _e2075) * _e1631) + ((_e2110 * _e2122) * _e1625.u)) + ((_e2160 * _e2172) * _e1625.v)), ((((_e2068 * _e2075) * _e1631) + ((_e2115 * _e2122) * _e1625.u)) + ((_e2165 * _e2172) * _e1625.v)), ((((_e2054 * _e2075) * _e1631) + ((_e2101 * _e2122) * _e1625.u)) + ((_e2151 * _e2172) * _e1625.v))));
                let _e2195 = sqrt((((_e2183.x * _e2183.x) + (_e2183.y * _e2183.y)) + (_e2183.z * _e2183.z)));
                if (_e2195 > 0f) {
                    let _e2198 = (_e2183.x / _e2195);
                    let _e2200 = (_e2183.y / _e2195);
                    let _e2202 = (_e2183.z / _e2195);
                    if ((((_e2198 * _e1774.x) + (_e2200 * _e1774.y)) + (_e2202 * _e1774.z)) < 0f) {
                        phi_2905_ = vec3<f32>(-(_e2198), -(_e2200), -(_e2202));
                    } else {
                        phi_2905_ = (_e2183 / vec3(_e2195));
                    }
                    let _e2219 = phi_2905_;
                    phi_2906_ = _e2219;
                } else {
                    phi_2906_ = _e1774;
                }
                let _e2221 = phi_2906_;
                phi_2907_ = _e2221;
            }
            let _e2223 = phi_2907_;
            if (_e2020 > 0f) {
                if (_e2020 < 1f) {
                    phi_2916_ = _e2020;
                } else {
                    phi_2916_ = 1f;
                }
                let _e2227 = phi_2916_;
                phi_2917_ = _e2227;
            } else {
                phi_2917_ = 0f;
            }
            let _e2229 = phi_2917_;
            if (_e2022 > 0f) {
                if (_e2022 < 1f) {
                    phi_2927_ = _e2022;
                } else {
                    phi_2927_ = 1f;
                }
                let _e2234 = phi_2927_;
                phi_2928_ = _e2234;
            } else {
                phi_2928_ = 0f;
            }
            let _e2236 = phi_2928_;
            if (_e2024 > 0f) {
                if (_e2024 < 1f) {
                    phi_2938_ = _e2024;
                } else {
                    phi_2938_ = 1f;
                }
                let _e2241 = phi_2938_;
                phi_2939_ = _e2241;
            } else {
                phi_2939_ = 0f;
            }
            let _e2243 = phi_2939_;
            let _e2246 = ((sqrt(_e2229) * 255f) + 0.5f);
            let _e2255 = ((sqrt(_e2236) * 255f) + 0.5f);
            let _e2267 = ((sqrt(_e2243) * 255f) + 0.5f);
            phi_2974_ = abi_Sample(vec3<f32>(_e1661, _e1662, _e1663), _e2026, _e1774, _e2031, _e2223, ((select(select(u32(_e2246), 0u, (_e2246 < bitcast<f32>(0u))), 4294967295u, (_e2246 > bitcast<f32>(1333788671u))) | (select(select(u32(_e2255), 0u, (_e2255 < bitcast<f32>(0u))), 4294967295u, (_e2255 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e2267), 0u, (_e2267 < bitcast<f32>(0u))), 4294967295u, (_e2267 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_2974_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e2281 = phi_2974_;
        if (_e103.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e103.shift)] = _e2281;
        if (_e1625.triangle != 4294967295u) {
            let _e2290 = ((1f - _e1625.u) - _e1625.v);
            if (_e1625.triangle < _e79) {
            } else {
                return;
            }
            let _e2295 = triangles.member[(0u + _e1625.triangle)];
            let _e2297 = (_e2295.i0_ & 2147483647u);
            if (_e2297 < _e94) {
            } else {
                return;
            }
            let _e2303 = before.member[(0u + _e2297)];
            if (_e2295.i1_ < _e94) {
            } else {
                return;
            }
            let _e2307 = before.member[(0u + _e2295.i1_)];
            if (_e2295.i2_ < _e94) {
            } else {
                return;
            }
            let _e2311 = before.member[(0u + _e2295.i2_)];
            let _e2316 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2303.x, _e2303.y, _e2303.z));
            let _e2327 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2307.x, _e2307.y, _e2307.z));
            let _e2341 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2311.x, _e2311.y, _e2311.z));
            phi_3065_ = vec3<f32>((((_e2316.x * _e2290) + (_e2327.x * _e1625.u)) + (_e2341.x * _e1625.v)), (((_e2316.y * _e2290) + (_e2327.y * _e1625.u)) + (_e2341.y * _e1625.v)), (((_e2316.z * _e2290) + (_e2327.z * _e1625.u)) + (_e2341.z * _e1625.v)));
        } else {
            phi_3065_ = vec3<f32>(0f, 0f, 0f);
        }
        let _e2353 = phi_3065_;
        if (_e103.shift < arrayLength((&past.member))) {
        } else {
            return;
        }
        past.member[(0u + _e103.shift)] = vec4<f32>(_e2353.x, _e2353.y, _e2353.z, 1f);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_color_motion_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
