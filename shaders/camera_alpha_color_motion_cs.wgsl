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

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct type_26 {
    member: array<vec4<f32>>,
}

struct texture_TextureView {
    offset: u32,
    size: u32,
    flags: u32,
}

struct lt_bvh_Triangle {
    v0_: vec3<f32>,
    i0_: u32,
    v1_: vec3<f32>,
    i1_: u32,
    v2_: vec3<f32>,
    i2_: u32,
}

struct type_32 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_36 {
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
    pad: vec2<u32>,
}

struct type_40 {
    member: array<abi_Material>,
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

struct lt_bvh_traverse_Stack {
    first: array<u32, 32>,
    mask: array<u32, 32>,
    len: u32,
    group: u32,
    group_mask: u32,
}

struct type_50 {
    member: abi_CameraParams,
}

struct lt_bvh_Node {
    frame: vec4<u32>,
    links: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    z: vec4<u32>,
}

struct type_55 {
    member: array<lt_bvh_Node>,
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

var<private> id_1: vec3<u32>;
@group(0) @binding(3) 
var<storage> vertices: type_36;
@group(0) @binding(4) 
var<storage> materials: type_40;
@group(0) @binding(0) 
var<uniform> p: type_50;
@group(0) @binding(1) 
var<storage> nodes: type_55;
@group(0) @binding(2) 
var<storage> triangles: type_32;
@group(0) @binding(5) 
var<storage, read_write> samples: type_9;
@group(0) @binding(6) 
var<storage> alpha_texels: type_13;
@group(0) @binding(7) 
var<storage> color_texels: type_13;
@group(0) @binding(8) 
var<storage> before: type_26;
@group(0) @binding(9) 
var<storage, read_write> past: type_26;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_220_: lt_bvh_traverse_Tree;
    var phi_221_: bool;
    var phi_222_: lt_bvh_traverse_Tree;
    var phi_223_: bool;
    var phi_228_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_220_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_221_ = false;
        } else {
            phi_220_ = lt_bvh_traverse_Tree();
            phi_221_ = true;
        }
        let _e85 = phi_220_;
        let _e87 = phi_221_;
        phi_222_ = _e85;
        phi_223_ = _e87;
    } else {
        phi_222_ = lt_bvh_traverse_Tree();
        phi_223_ = true;
    }
    let _e89 = phi_222_;
    let _e91 = phi_223_;
    if _e91 {
        phi_228_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_228_ = _e89;
    }
    let _e96 = phi_228_;
    return lt_bvh_traverse_Tree(_e96.root, _e96.first_primitive);
}

fn _lt_shaders_texture_TextureView_quad(param_3: ptr<function, texture_TextureView>, param_4: f32, param_5: f32) -> texture_TexelQuad {
    var phi_273_: f32;
    var phi_278_: f32;
    var phi_279_: bool;
    var phi_280_: f32;
    var phi_281_: bool;
    var phi_285_: f32;
    var phi_311_: f32;
    var phi_316_: f32;
    var phi_317_: bool;
    var phi_318_: f32;
    var phi_319_: bool;
    var phi_323_: f32;
    var phi_331_: f32;
    var phi_332_: f32;
    var phi_333_: f32;
    var phi_342_: f32;
    var phi_343_: f32;
    var phi_361_: u32;
    var phi_375_: u32;
    var phi_382_: u32;
    var phi_387_: u32;
    var phi_393_: u32;
    var phi_398_: u32;
    var phi_400_: texture_Axis;
    var phi_428_: f32;
    var phi_433_: f32;
    var phi_434_: bool;
    var phi_435_: f32;
    var phi_436_: bool;
    var phi_440_: f32;
    var phi_466_: f32;
    var phi_471_: f32;
    var phi_472_: bool;
    var phi_473_: f32;
    var phi_474_: bool;
    var phi_478_: f32;
    var phi_486_: f32;
    var phi_487_: f32;
    var phi_488_: f32;
    var phi_497_: f32;
    var phi_498_: f32;
    var phi_516_: u32;
    var phi_530_: u32;
    var phi_537_: u32;
    var phi_542_: u32;
    var phi_548_: u32;
    var phi_553_: u32;
    var phi_555_: texture_Axis;

    let _e76 = (*param_3).size;
    let _e77 = (_e76 & 65535u);
    let _e79 = (*param_3).size;
    let _e81 = (_e79 >> bitcast<u32>(16i));
    let _e83 = (*param_3).flags;
    let _e85 = ((_e83 & 4u) != 0u);
    let _e87 = (*param_3).flags;
    let _e90 = ((_e87 >> bitcast<u32>(4u)) & 3u);
    if (_e90 == 0u) {
        if (param_4 > -8388608f) {
            let _e103 = f32(select(0i, select(select(i32(param_4), i32(-2147483648), (param_4 < bitcast<f32>(3472883712u))), 2147483647i, (param_4 > bitcast<f32>(1325400063u))), (param_4 == param_4)));
            if (_e103 > param_4) {
                phi_273_ = 1f;
            } else {
                phi_273_ = 0f;
            }
            let _e106 = phi_273_;
            if (param_4 < 8388608f) {
                phi_278_ = (_e103 - _e106);
                phi_279_ = false;
            } else {
                phi_278_ = f32();
                phi_279_ = true;
            }
            let _e109 = phi_278_;
            let _e111 = phi_279_;
            phi_280_ = _e109;
            phi_281_ = _e111;
        } else {
            phi_280_ = f32();
            phi_281_ = true;
        }
        let _e113 = phi_280_;
        let _e115 = phi_281_;
        if _e115 {
            phi_285_ = param_4;
        } else {
            phi_285_ = _e113;
        }
        let _e117 = phi_285_;
        phi_333_ = (param_4 - _e117);
    } else {
        if (_e90 == 1u) {
            let _e120 = (param_4 * 0.5f);
            if (_e120 > -8388608f) {
                let _e132 = f32(select(0i, select(select(i32(_e120), i32(-2147483648), (_e120 < bitcast<f32>(3472883712u))), 2147483647i, (_e120 > bitcast<f32>(1325400063u))), (_e120 == _e120)));
                if (_e132 > _e120) {
                    phi_311_ = 1f;
                } else {
                    phi_311_ = 0f;
                }
                let _e135 = phi_311_;
                if (_e120 < 8388608f) {
                    phi_316_ = (_e132 - _e135);
                    phi_317_ = false;
                } else {
                    phi_316_ = f32();
                    phi_317_ = true;
                }
                let _e138 = phi_316_;
                let _e140 = phi_317_;
                phi_318_ = _e138;
                phi_319_ = _e140;
            } else {
                phi_318_ = f32();
                phi_319_ = true;
            }
            let _e142 = phi_318_;
            let _e144 = phi_319_;
            if _e144 {
                phi_323_ = _e120;
            } else {
                phi_323_ = _e142;
            }
            let _e146 = phi_323_;
            let _e148 = (param_4 - (2f * _e146));
            if (_e148 > 1f) {
                phi_331_ = (2f - _e148);
            } else {
                phi_331_ = _e148;
            }
            let _e152 = phi_331_;
            phi_332_ = _e152;
        } else {
            phi_332_ = param_4;
        }
        let _e154 = phi_332_;
        phi_333_ = _e154;
    }
    let _e156 = phi_333_;
    if (_e156 > 0f) {
        if (_e156 < 1f) {
            phi_342_ = _e156;
        } else {
            phi_342_ = 1f;
        }
        let _e160 = phi_342_;
        phi_343_ = _e160;
    } else {
        phi_343_ = 0f;
    }
    let _e162 = phi_343_;
    let _e163 = (_e77 - 1u);
    let _e165 = (_e162 * f32(_e77));
    if _e85 {
        let _e172 = select(select(u32(_e165), 0u, (_e165 < bitcast<f32>(0u))), 4294967295u, (_e165 > bitcast<f32>(1333788671u)));
        if (_e163 < _e172) {
            phi_361_ = _e163;
        } else {
            phi_361_ = _e172;
        }
        let _e175 = phi_361_;
        phi_400_ = texture_Axis(_e175, _e175, 0f);
    } else {
        let _e177 = (_e165 + 0.5f);
        let _e184 = select(select(u32(_e177), 0u, (_e177 < bitcast<f32>(0u))), 4294967295u, (_e177 > bitcast<f32>(1333788671u)));
        if (_e77 < _e184) {
            phi_375_ = _e77;
        } else {
            phi_375_ = _e184;
        }
        let _e187 = phi_375_;
        if (_e90 == 0u) {
            phi_382_ = _e163;
        } else {
            phi_382_ = 0u;
        }
        let _e192 = phi_382_;
        if (_e90 == 0u) {
            phi_387_ = 0u;
        } else {
            phi_387_ = _e163;
        }
        let _e195 = phi_387_;
        if (_e187 == 0u) {
            phi_393_ = _e192;
        } else {
            phi_393_ = (_e187 - 1u);
        }
        let _e199 = phi_393_;
        if (_e187 > _e163) {
            phi_398_ = _e195;
        } else {
            phi_398_ = _e187;
        }
        let _e202 = phi_398_;
        phi_400_ = texture_Axis(_e199, _e202, (_e177 - f32(_e187)));
    }
    let _e205 = phi_400_;
    let _e207 = (*param_3).flags;
    let _e210 = ((_e207 >> bitcast<u32>(6u)) & 3u);
    if (_e210 == 0u) {
        if (param_5 > -8388608f) {
            let _e223 = f32(select(0i, select(select(i32(param_5), i32(-2147483648), (param_5 < bitcast<f32>(3472883712u))), 2147483647i, (param_5 > bitcast<f32>(1325400063u))), (param_5 == param_5)));
            if (_e223 > param_5) {
                phi_428_ = 1f;
            } else {
                phi_428_ = 0f;
            }
            let _e226 = phi_428_;
            if (param_5 < 8388608f) {
                phi_433_ = (_e223 - _e226);
                phi_434_ = false;
            } else {
                phi_433_ = f32();
                phi_434_ = true;
            }
            let _e229 = phi_433_;
            let _e231 = phi_434_;
            phi_435_ = _e229;
            phi_436_ = _e231;
        } else {
            phi_435_ = f32();
            phi_436_ = true;
        }
        let _e233 = phi_435_;
        let _e235 = phi_436_;
        if _e235 {
            phi_440_ = param_5;
        } else {
            phi_440_ = _e233;
        }
        let _e237 = phi_440_;
        phi_488_ = (param_5 - _e237);
    } else {
        if (_e210 == 1u) {
            let _e240 = (param_5 * 0.5f);
            if (_e240 > -8388608f) {
                let _e252 = f32(select(0i, select(select(i32(_e240), i32(-2147483648), (_e240 < bitcast<f32>(3472883712u))), 2147483647i, (_e240 > bitcast<f32>(1325400063u))), (_e240 == _e240)));
                if (_e252 > _e240) {
                    phi_466_ = 1f;
                } else {
                    phi_466_ = 0f;
                }
                let _e255 = phi_466_;
                if (_e240 < 8388608f) {
                    phi_471_ = (_e252 - _e255);
                    phi_472_ = false;
                } else {
                    phi_471_ = f32();
                    phi_472_ = true;
                }
                let _e258 = phi_471_;
                let _e260 = phi_472_;
                phi_473_ = _e258;
                phi_474_ = _e260;
            } else {
                phi_473_ = f32();
                phi_474_ = true;
            }
            let _e262 = phi_473_;
            let _e264 = phi_474_;
            if _e264 {
                phi_478_ = _e240;
            } else {
                phi_478_ = _e262;
            }
            let _e266 = phi_478_;
            let _e268 = (param_5 - (2f * _e266));
            if (_e268 > 1f) {
                phi_486_ = (2f - _e268);
            } else {
                phi_486_ = _e268;
            }
            let _e272 = phi_486_;
            phi_487_ = _e272;
        } else {
            phi_487_ = param_5;
        }
        let _e274 = phi_487_;
        phi_488_ = _e274;
    }
    let _e276 = phi_488_;
    if (_e276 > 0f) {
        if (_e276 < 1f) {
            phi_497_ = _e276;
        } else {
            phi_497_ = 1f;
        }
        let _e280 = phi_497_;
        phi_498_ = _e280;
    } else {
        phi_498_ = 0f;
    }
    let _e282 = phi_498_;
    let _e283 = (_e81 - 1u);
    let _e285 = (_e282 * f32(_e81));
    if _e85 {
        let _e292 = select(select(u32(_e285), 0u, (_e285 < bitcast<f32>(0u))), 4294967295u, (_e285 > bitcast<f32>(1333788671u)));
        if (_e283 < _e292) {
            phi_516_ = _e283;
        } else {
            phi_516_ = _e292;
        }
        let _e295 = phi_516_;
        phi_555_ = texture_Axis(_e295, _e295, 0f);
    } else {
        let _e297 = (_e285 + 0.5f);
        let _e304 = select(select(u32(_e297), 0u, (_e297 < bitcast<f32>(0u))), 4294967295u, (_e297 > bitcast<f32>(1333788671u)));
        if (_e81 < _e304) {
            phi_530_ = _e81;
        } else {
            phi_530_ = _e304;
        }
        let _e307 = phi_530_;
        if (_e210 == 0u) {
            phi_537_ = _e283;
        } else {
            phi_537_ = 0u;
        }
        let _e312 = phi_537_;
        if (_e210 == 0u) {
            phi_542_ = 0u;
        } else {
            phi_542_ = _e283;
        }
        let _e315 = phi_542_;
        if (_e307 == 0u) {
            phi_548_ = _e312;
        } else {
            phi_548_ = (_e307 - 1u);
        }
        let _e319 = phi_548_;
        if (_e307 > _e283) {
            phi_553_ = _e315;
        } else {
            phi_553_ = _e307;
        }
        let _e322 = phi_553_;
        phi_555_ = texture_Axis(_e319, _e322, (_e297 - f32(_e307)));
    }
    let _e325 = phi_555_;
    let _e329 = (*param_3).offset;
    let _e336 = (*param_3).offset;
    let _e343 = (*param_3).offset;
    let _e350 = (*param_3).offset;
    return texture_TexelQuad(array<u32, 4>(((_e329 + (_e325.low * _e77)) + _e205.low), ((_e336 + (_e325.low * _e77)) + _e205.high), ((_e343 + (_e325.high * _e77)) + _e205.low), ((_e350 + (_e325.high * _e77)) + _e205.high)), vec4<f32>(((1f - _e205.fraction) * (1f - _e325.fraction)), (_e205.fraction * (1f - _e325.fraction)), ((1f - _e205.fraction) * _e325.fraction), (_e205.fraction * _e325.fraction)));
}

fn _lt_bvh_ray_Ray_new(param_6: vec3<f32>, param_7: vec3<f32>) -> lt_bvh_Ray {
    return lt_bvh_Ray(param_6, 0f, param_7, 300000000000000000000000000000000000000f);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_8: f32, param_9: f32) -> f32 {
    var phi_618_: bool;
    var phi_622_: f32;

    if (param_8 != param_8) {
        phi_618_ = true;
    } else {
        let _e75 = (param_9 >= param_8);
        if _e75 {
        }
        phi_618_ = _e75;
    }
    let _e77 = phi_618_;
    if _e77 {
        phi_622_ = param_9;
    } else {
        phi_622_ = param_8;
    }
    let _e79 = phi_622_;
    return _e79;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_10: f32, param_11: f32) -> f32 {
    var phi_634_: bool;
    var phi_638_: f32;

    if (param_10 != param_10) {
        phi_634_ = true;
    } else {
        let _e75 = (param_11 <= param_10);
        if _e75 {
        }
        phi_634_ = _e75;
    }
    let _e77 = phi_634_;
    if _e77 {
        phi_638_ = param_11;
    } else {
        phi_638_ = param_10;
    }
    let _e79 = phi_638_;
    return _e79;
}

fn _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(param_12: f32, param_13: f32) -> f32 {
    var phi_646_: f32;

    if (param_12 > param_13) {
        phi_646_ = param_12;
    } else {
        phi_646_ = param_13;
    }
    let _e76 = phi_646_;
    return _e76;
}

fn _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(param_14: vec3<f32>) -> vec3<f32> {
    return param_14;
}

fn _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(param_15: vec3<f32>) -> vec3<f32> {
    return param_15;
}

fn function_() {
    var local: texture_TextureView;
    var local_1: texture_TextureView;
    var local_2: lt_bvh_traverse_Stack;
    var phi_805_: bool;
    var phi_806_: bool;
    var phi_807_: bool;
    var phi_811_: bool;
    var phi_812_: bool;
    var phi_813_: bool;
    var phi_814_: bool;
    var phi_815_: bool;
    var phi_816_: bool;
    var phi_817_: bool;
    var phi_818_: bool;
    var phi_819_: bool;
    var phi_820_: bool;
    var phi_821_: bool;
    var phi_822_: bool;
    var phi_823_: bool;
    var phi_824_: bool;
    var phi_825_: bool;
    var phi_826_: bool;
    var phi_827_: bool;
    var phi_828_: bool;
    var phi_832_: bool;
    var phi_836_: bool;
    var phi_911_: f32;
    var phi_918_: f32;
    var phi_926_: f32;
    var phi_933_: f32;
    var phi_941_: f32;
    var phi_948_: f32;
    var phi_973_: f32;
    var phi_978_: f32;
    var phi_983_: f32;
    var phi_1016_: bool;
    var phi_1017_: bool;
    var phi_1025_: u32;
    var phi_1026_: u32;
    var phi_1044_: vec3<f32>;
    var phi_1045_: vec3<f32>;
    var phi_1059_: u32;
    var phi_1064_: u32;
    var phi_1069_: u32;
    var phi_1183_: bool;
    var phi_1184_: bool;
    var phi_1215_: u32;
    var phi_1217_: lt_bvh_Hit;
    var phi_1220_: u32;
    var phi_1305_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1332_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1359_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1365_: u32;
    var phi_1368_: u32;
    var phi_1382_: u32;
    var phi_1392_: u32;
    var phi_1402_: u32;
    var phi_1420_: u32;
    var phi_1430_: u32;
    var phi_1440_: u32;
    var phi_1476_: u32;
    var phi_1489_: u32;
    var phi_1494_: u32;
    var phi_1495_: u32;
    var phi_1496_: u32;
    var phi_1366_: u32;
    var phi_1369_: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_1554_: lt_bvh_Hit;
    var phi_1557_: u32;
    var phi_1603_: vec3<f32>;
    var phi_1604_: vec3<f32>;
    var phi_1637_: vec3<f32>;
    var phi_1638_: vec3<f32>;
    var phi_1671_: vec3<f32>;
    var phi_1672_: vec3<f32>;
    var phi_1692_: bool;
    var phi_1693_: bool;
    var phi_1697_: f32;
    var phi_1698_: f32;
    var phi_1699_: f32;
    var phi_1700_: f32;
    var phi_1708_: f32;
    var phi_1718_: bool;
    var phi_1719_: bool;
    var phi_1723_: f32;
    var phi_1724_: f32;
    var phi_1725_: f32;
    var phi_1726_: f32;
    var phi_1734_: f32;
    var phi_1744_: bool;
    var phi_1745_: bool;
    var phi_1749_: f32;
    var phi_1750_: f32;
    var phi_1751_: f32;
    var phi_1752_: f32;
    var phi_1760_: f32;
    var phi_1775_: f32;
    var phi_1776_: bool;
    var phi_1777_: f32;
    var phi_1778_: bool;
    var phi_1779_: f32;
    var phi_1780_: bool;
    var phi_1798_: f32;
    var phi_1799_: bool;
    var phi_1800_: bool;
    var phi_1801_: f32;
    var phi_1802_: bool;
    var phi_1803_: bool;
    var phi_1807_: bool;
    var phi_1808_: f32;
    var phi_1809_: bool;
    var phi_1845_: f32;
    var phi_1854_: f32;
    var phi_1863_: f32;
    var phi_1872_: f32;
    var phi_1879_: f32;
    var phi_1886_: f32;
    var phi_1899_: f32;
    var phi_1908_: f32;
    var phi_1917_: f32;
    var phi_1926_: f32;
    var phi_1933_: f32;
    var phi_1940_: f32;
    var phi_1963_: f32;
    var phi_1968_: f32;
    var phi_1973_: f32;
    var phi_1981_: f32;
    var phi_1986_: f32;
    var phi_1991_: f32;
    var phi_2003_: f32;
    var phi_2008_: f32;
    var phi_2013_: f32;
    var phi_2018_: f32;
    var phi_2023_: lt_bvh_triangle_Intersection;
    var phi_2024_: bool;
    var phi_2025_: lt_bvh_triangle_Intersection;
    var phi_2026_: bool;
    var phi_2030_: lt_bvh_triangle_Intersection;
    var phi_2031_: bool;
    var phi_2032_: lt_bvh_triangle_Intersection;
    var phi_2033_: bool;
    var phi_2034_: bool;
    var phi_2038_: bool;
    var phi_2042_: lt_bvh_triangle_Intersection;
    var phi_2081_: bool;
    var phi_2082_: bool;
    var phi_2083_: bool;
    var phi_2084_: bool;
    var phi_2085_: bool;
    var phi_2086_: bool;
    var phi_2090_: bool;
    var phi_2091_: bool;
    var phi_2294_: f32;
    var phi_2297_: bool;
    var phi_2298_: bool;
    var phi_2302_: bool;
    var phi_2310_: lt_bvh_Hit;
    var phi_2311_: lt_bvh_Hit;
    var phi_2312_: lt_bvh_Hit;
    var phi_2313_: lt_bvh_Hit;
    var phi_1555_: lt_bvh_Hit;
    var phi_1558_: u32;
    var phi_2314_: bool;
    var phi_2353_: bool;
    var phi_2354_: bool;
    var phi_2385_: u32;
    var phi_1218_: lt_bvh_Hit;
    var phi_1221_: u32;
    var phi_2386_: lt_bvh_Hit;
    var phi_2387_: lt_bvh_Hit;
    var phi_2388_: bool;
    var phi_2392_: lt_bvh_Hit;
    var phi_2456_: f32;
    var phi_2461_: f32;
    var phi_2466_: f32;
    var phi_2477_: f32;
    var phi_2482_: f32;
    var phi_2487_: f32;
    var phi_2563_: vec3<f32>;
    var phi_2806_: vec3<f32>;
    var phi_2821_: u32;
    var phi_2848_: f32;
    var phi_2855_: f32;
    var phi_2862_: f32;
    var phi_2897_: f32;
    var phi_2904_: f32;
    var phi_2911_: f32;
    var phi_2949_: f32;
    var phi_2956_: f32;
    var phi_2963_: f32;
    var phi_3022_: vec3<f32>;
    var phi_3023_: vec3<f32>;
    var phi_3024_: vec3<f32>;
    var phi_3033_: f32;
    var phi_3034_: f32;
    var phi_3044_: f32;
    var phi_3045_: f32;
    var phi_3055_: f32;
    var phi_3056_: f32;
    var phi_3091_: abi_Sample;
    var phi_3182_: vec3<f32>;
    var local_6: lt_bvh_Hit;
    var local_7: lt_bvh_Hit;

    let _e75 = id_1;
    let _e79 = arrayLength((&nodes.member));
    let _e82 = arrayLength((&triangles.member));
    let _e85 = arrayLength((&vertices.member));
    let _e88 = arrayLength((&materials.member));
    let _e94 = arrayLength((&alpha_texels.member));
    let _e97 = arrayLength((&color_texels.member));
    let _e100 = arrayLength((&before.member));
    let _e106 = p.member.size[0u];
    let _e108 = p.member.size[1u];
    let _e109 = lt_shaders_entry_pixel_index(_e75, _e106, _e108);
    if (bitcast<i32>(_e109.root) != 0i) {
        let _e117 = p.member.eye;
        let _e122 = p.member.size[0u];
        let _e126 = ((((f32(_e75.x) + 0.5f) / f32(_e122)) * 2f) - 1f);
        let _e131 = p.member.size[1u];
        let _e135 = (1f - (((f32(_e75.y) + 0.5f) / f32(_e131)) * 2f));
        let _e137 = p.member.forward;
        let _e139 = p.member.right;
        let _e153 = p.member.up;
        let _e164 = _lt_bvh_ray_Ray_new(_e117, vec3<f32>(((_e137.x + (_e139.x * _e126)) + (_e153.x * _e135)), ((_e137.y + (_e139.y * _e126)) + (_e153.y * _e135)), ((_e137.z + (_e139.z * _e126)) + (_e153.z * _e135))));
        let _e166 = lt_bvh_Hit(_e164.tmax, 0f, 0f, 4294967295u, 4294967295u);
        let _e176 = abs(_e164.direction.x);
        let _e178 = abs(_e164.direction.y);
        let _e180 = abs(_e164.direction.z);
        if (abs(_e164.origin.x) < 1000000000000000f) {
            if (abs(_e164.origin.y) < 1000000000000000f) {
                if (abs(_e164.origin.z) < 1000000000000000f) {
                    if (_e176 < 1000000000000000f) {
                        if (_e178 < 1000000000000000f) {
                            if (_e180 < 1000000000000000f) {
                                if (_e176 > 0f) {
                                    phi_806_ = bool();
                                    phi_807_ = true;
                                } else {
                                    let _e188 = (_e178 > 0f);
                                    if _e188 {
                                        phi_805_ = bool();
                                    } else {
                                        phi_805_ = (_e180 > 0f);
                                    }
                                    let _e191 = phi_805_;
                                    phi_806_ = _e191;
                                    phi_807_ = _e188;
                                }
                                let _e193 = phi_806_;
                                let _e195 = phi_807_;
                                if _e195 {
                                    phi_811_ = true;
                                } else {
                                    phi_811_ = _e193;
                                }
                                let _e197 = phi_811_;
                                phi_812_ = _e197;
                                phi_813_ = false;
                            } else {
                                phi_812_ = bool();
                                phi_813_ = true;
                            }
                            let _e199 = phi_812_;
                            let _e201 = phi_813_;
                            phi_814_ = _e199;
                            phi_815_ = false;
                            phi_816_ = _e201;
                        } else {
                            phi_814_ = bool();
                            phi_815_ = true;
                            phi_816_ = false;
                        }
                        let _e203 = phi_814_;
                        let _e205 = phi_815_;
                        let _e207 = phi_816_;
                        phi_817_ = _e203;
                        phi_818_ = _e205;
                        phi_819_ = _e207;
                    } else {
                        phi_817_ = bool();
                        phi_818_ = true;
                        phi_819_ = false;
                    }
                    let _e209 = phi_817_;
                    let _e211 = phi_818_;
                    let _e213 = phi_819_;
                    phi_820_ = _e209;
                    phi_821_ = _e211;
                    phi_822_ = _e213;
                } else {
                    phi_820_ = bool();
                    phi_821_ = true;
                    phi_822_ = false;
                }
                let _e215 = phi_820_;
                let _e217 = phi_821_;
                let _e219 = phi_822_;
                phi_823_ = _e215;
                phi_824_ = _e217;
                phi_825_ = _e219;
            } else {
                phi_823_ = bool();
                phi_824_ = true;
                phi_825_ = false;
            }
            let _e221 = phi_823_;
            let _e223 = phi_824_;
            let _e225 = phi_825_;
            phi_826_ = _e221;
            phi_827_ = _e223;
            phi_828_ = _e225;
        } else {
            phi_826_ = bool();
            phi_827_ = true;
            phi_828_ = false;
        }
        let _e227 = phi_826_;
        let _e229 = phi_827_;
        let _e231 = phi_828_;
        if _e229 {
            phi_832_ = true;
        } else {
            phi_832_ = _e231;
        }
        let _e233 = phi_832_;
        if _e233 {
            phi_836_ = false;
        } else {
            phi_836_ = _e227;
        }
        let _e235 = phi_836_;
        if _e235 {
            let _e236 = (0u >= _e79);
            if _e236 {
                phi_2386_ = lt_bvh_Hit();
            } else {
                if (0u < _e79) {
                } else {
                    return;
                }
                let _e242 = nodes.member[(0u + 0u)].frame[0u];
                let _e246 = nodes.member[(0u + 0u)].frame[1u];
                let _e250 = nodes.member[(0u + 0u)].frame[2u];
                let _e254 = nodes.member[(0u + 0u)].frame[0u];
                let _e258 = nodes.member[(0u + 0u)].frame[1u];
                let _e262 = nodes.member[(0u + 0u)].frame[2u];
                let _e266 = nodes.member[(0u + 0u)].frame[3u];
                let _e304 = core_intrinsics_maximum_number_nsz_f32_(abs(_e164.direction.x), abs(_e164.direction.y));
                let _e305 = core_intrinsics_maximum_number_nsz_f32_(_e304, abs(_e164.direction.z));
                let _e306 = (_e305 * 0.0000000000009094947f);
                if (abs(_e164.direction.x) < _e306) {
                    phi_911_ = _e306;
                } else {
                    phi_911_ = abs(_e164.direction.x);
                }
                let _e313 = phi_911_;
                if (_e164.direction.x < 0f) {
                    phi_918_ = (-1f / _e313);
                } else {
                    phi_918_ = (1f / _e313);
                }
                let _e318 = phi_918_;
                if (abs(_e164.direction.y) < _e306) {
                    phi_926_ = _e306;
                } else {
                    phi_926_ = abs(_e164.direction.y);
                }
                let _e325 = phi_926_;
                if (_e164.direction.y < 0f) {
                    phi_933_ = (-1f / _e325);
                } else {
                    phi_933_ = (1f / _e325);
                }
                let _e330 = phi_933_;
                if (abs(_e164.direction.z) < _e306) {
                    phi_941_ = _e306;
                } else {
                    phi_941_ = abs(_e164.direction.z);
                }
                let _e337 = phi_941_;
                if (_e164.direction.z < 0f) {
                    phi_948_ = (-1f / _e337);
                } else {
                    phi_948_ = (1f / _e337);
                }
                let _e342 = phi_948_;
                let _e350 = abs((bitcast<f32>(_e242) - _e164.origin.x));
                let _e351 = abs((bitcast<f32>(_e246) - _e164.origin.y));
                let _e352 = abs((bitcast<f32>(_e250) - _e164.origin.z));
                let _e360 = abs(((bitcast<f32>(_e254) + (bitcast<f32>((((_e266 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e164.origin.x));
                let _e361 = abs(((bitcast<f32>(_e258) + (bitcast<f32>((((_e266 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e164.origin.y));
                let _e362 = abs(((bitcast<f32>(_e262) + (bitcast<f32>((((_e266 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e164.origin.z));
                if (_e350 > _e360) {
                    phi_973_ = _e350;
                } else {
                    phi_973_ = _e360;
                }
                let _e365 = phi_973_;
                if (_e351 > _e361) {
                    phi_978_ = _e351;
                } else {
                    phi_978_ = _e361;
                }
                let _e368 = phi_978_;
                if (_e352 > _e362) {
                    phi_983_ = _e352;
                } else {
                    phi_983_ = _e362;
                }
                let _e371 = phi_983_;
                let _e372 = core_intrinsics_maximum_number_nsz_f32_(_e365, _e368);
                let _e373 = core_intrinsics_maximum_number_nsz_f32_(_e372, _e371);
                let _e378 = (_e373 * 0.0000019073486f);
                let _e379 = (abs(_e318) * _e378);
                let _e380 = (abs(_e330) * _e378);
                let _e381 = (abs(_e342) * _e378);
                let _e385 = (_e373 * 0.0000009536743f);
                let _e386 = (abs(_e318) * _e385);
                let _e387 = (abs(_e330) * _e385);
                let _e388 = (abs(_e342) * _e385);
                let _e391 = abs(_e164.direction.x);
                let _e393 = abs(_e164.direction.y);
                let _e395 = abs(_e164.direction.z);
                if (_e391 >= _e393) {
                    if (_e391 >= _e395) {
                        phi_1016_ = false;
                    } else {
                        phi_1016_ = true;
                    }
                    let _e399 = phi_1016_;
                    phi_1017_ = _e399;
                } else {
                    phi_1017_ = true;
                }
                let _e401 = phi_1017_;
                if _e401 {
                    if (_e393 >= _e395) {
                        phi_1025_ = 1u;
                    } else {
                        phi_1025_ = 2u;
                    }
                    let _e404 = phi_1025_;
                    phi_1026_ = _e404;
                } else {
                    phi_1026_ = 0u;
                }
                let _e406 = phi_1026_;
                if (_e406 == 0u) {
                    phi_1045_ = vec3<f32>(_e164.direction.y, _e164.direction.z, _e164.direction.x);
                } else {
                    if (_e406 == 1u) {
                        phi_1044_ = vec3<f32>(_e164.direction.z, _e164.direction.x, _e164.direction.y);
                    } else {
                        phi_1044_ = _e164.direction;
                    }
                    let _e419 = phi_1044_;
                    phi_1045_ = _e419;
                }
                let _e421 = phi_1045_;
                let _e425 = (_e421.x / _e421.z);
                let _e428 = (_e421.y / _e421.z);
                let _e430 = (1f / _e421.z);
                if (_e318 < 0f) {
                    phi_1059_ = 0u;
                } else {
                    phi_1059_ = 1u;
                }
                let _e433 = phi_1059_;
                if (_e330 < 0f) {
                    phi_1064_ = 0u;
                } else {
                    phi_1064_ = 2u;
                }
                let _e436 = phi_1064_;
                if (_e342 < 0f) {
                    phi_1069_ = 0u;
                } else {
                    phi_1069_ = 4u;
                }
                let _e439 = phi_1069_;
                let _e441 = ((_e433 | _e436) | _e439);
                let _e442 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e442.first[0], _e442.first[1], _e442.first[2], _e442.first[3], _e442.first[4], _e442.first[5], _e442.first[6], _e442.first[7], _e442.first[8], _e442.first[9], _e442.first[10], _e442.first[11], _e442.first[12], _e442.first[13], _e442.first[14], _e442.first[15], _e442.first[16], _e442.first[17], _e442.first[18], _e442.first[19], _e442.first[20], _e442.first[21], _e442.first[22], _e442.first[23], _e442.first[24], _e442.first[25], _e442.first[26], _e442.first[27], _e442.first[28], _e442.first[29], _e442.first[30], _e442.first[31]), array<u32, 32>(_e442.mask[0], _e442.mask[1], _e442.mask[2], _e442.mask[3], _e442.mask[4], _e442.mask[5], _e442.mask[6], _e442.mask[7], _e442.mask[8], _e442.mask[9], _e442.mask[10], _e442.mask[11], _e442.mask[12], _e442.mask[13], _e442.mask[14], _e442.mask[15], _e442.mask[16], _e442.mask[17], _e442.mask[18], _e442.mask[19], _e442.mask[20], _e442.mask[21], _e442.mask[22], _e442.mask[23], _e442.mask[24], _e442.mask[25], _e442.mask[26], _e442.mask[27], _e442.mask[28], _e442.mask[29], _e442.mask[30], _e442.mask[31]), _e442.len, _e442.group, _e442.group_mask);
                let _e516 = local_2.group_mask;
                if ((_e516 & 4278190080u) == 0u) {
                    let _e520 = local_2.len;
                    if (_e520 == 0u) {
                        phi_1183_ = false;
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
                        phi_1183_ = true;
                    }
                    let _e543 = phi_1183_;
                    phi_1184_ = _e543;
                } else {
                    phi_1184_ = true;
                }
                let _e545 = phi_1184_;
                if _e545 {
                    let _e547 = local_2.group_mask;
                    let _e553 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e547)), 32u, (_e547 == 0u)));
                    let _e557 = local_2.group_mask;
                    let _e571 = local_2.group_mask;
                    local_2.group_mask = (_e571 & ~((1u << bitcast<u32>((_e553 & 31u)))));
                    let _e574 = local_2.group;
                    phi_1215_ = (_e574 + countOneBits(((_e557 & ~((4294967295u << bitcast<u32>((((_e553 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1215_ = 4294967295u;
                }
                let _e577 = phi_1215_;
                phi_1217_ = _e166;
                phi_1220_ = _e577;
                loop {
                    let _e579 = phi_1217_;
                    let _e581 = phi_1220_;
                    local_7 = _e579;
                    let _e582 = (_e581 != 4294967295u);
                    if _e582 {
                        if (_e581 < _e79) {
                        } else {
                            return;
                        }
                        let _e590 = nodes.member[(0u + _e581)].frame[3u];
                        let _e615 = (bitcast<f32>((((_e590 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e318);
                        let _e616 = (bitcast<f32>((((_e590 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e330);
                        let _e617 = (bitcast<f32>((((_e590 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e342);
                        let _e620 = nodes.member[(0u + _e581)].frame[0u];
                        let _e624 = nodes.member[(0u + _e581)].frame[1u];
                        let _e628 = nodes.member[(0u + _e581)].frame[2u];
                        let _e636 = ((bitcast<f32>(_e620) - _e164.origin.x) * _e318);
                        let _e637 = ((bitcast<f32>(_e624) - _e164.origin.y) * _e330);
                        let _e638 = ((bitcast<f32>(_e628) - _e164.origin.z) * _e342);
                        let _e646 = nodes.member[(0u + _e581)].x;
                        if (_e318 < 0f) {
                            let _e657 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e646.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e663 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e657.unnamed.root, _e646.w), _e657.unnamed_1);
                            let _e669 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e663.unnamed, lt_bvh_traverse_Tree(_e646.x, _e663.unnamed_1.first_primitive));
                            phi_1305_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e669.unnamed, lt_bvh_traverse_Tree(_e669.unnamed_1.root, _e646.y));
                        } else {
                            let _e685 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e646.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e691 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e685.unnamed.root, _e646.y), _e685.unnamed_1);
                            let _e697 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e691.unnamed, lt_bvh_traverse_Tree(_e646.z, _e691.unnamed_1.first_primitive));
                            phi_1305_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e697.unnamed, lt_bvh_traverse_Tree(_e697.unnamed_1.root, _e646.w));
                        }
                        let _e705 = phi_1305_;
                        let _e715 = nodes.member[(0u + _e581)].y;
                        if (_e330 < 0f) {
                            let _e726 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e715.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e732 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e726.unnamed.root, _e715.w), _e726.unnamed_1);
                            let _e738 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e732.unnamed, lt_bvh_traverse_Tree(_e715.x, _e732.unnamed_1.first_primitive));
                            phi_1332_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e738.unnamed, lt_bvh_traverse_Tree(_e738.unnamed_1.root, _e715.y));
                        } else {
                            let _e754 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e715.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e760 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e754.unnamed.root, _e715.y), _e754.unnamed_1);
                            let _e766 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e760.unnamed, lt_bvh_traverse_Tree(_e715.z, _e760.unnamed_1.first_primitive));
                            phi_1332_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e766.unnamed, lt_bvh_traverse_Tree(_e766.unnamed_1.root, _e715.w));
                        }
                        let _e774 = phi_1332_;
                        let _e784 = nodes.member[(0u + _e581)].z;
                        if (_e342 < 0f) {
                            let _e795 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e784.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e801 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e795.unnamed.root, _e784.w), _e795.unnamed_1);
                            let _e807 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e801.unnamed, lt_bvh_traverse_Tree(_e784.x, _e801.unnamed_1.first_primitive));
                            phi_1359_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e807.unnamed, lt_bvh_traverse_Tree(_e807.unnamed_1.root, _e784.y));
                        } else {
                            let _e823 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e784.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e829 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e823.unnamed.root, _e784.y), _e823.unnamed_1);
                            let _e835 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e829.unnamed, lt_bvh_traverse_Tree(_e784.z, _e829.unnamed_1.first_primitive));
                            phi_1359_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e835.unnamed, lt_bvh_traverse_Tree(_e835.unnamed_1.root, _e784.w));
                        }
                        let _e843 = phi_1359_;
                        phi_1365_ = 0u;
                        phi_1368_ = 0u;
                        loop {
                            let _e853 = phi_1365_;
                            let _e855 = phi_1368_;
                            local_3 = _e855;
                            local_4 = _e855;
                            local_5 = _e855;
                            let _e856 = (_e853 < 8u);
                            if _e856 {
                                let _e858 = (_e853 >> bitcast<u32>(2i));
                                let _e859 = (_e853 & 3u);
                                if (_e858 == 0u) {
                                    phi_1382_ = _e705.unnamed.root;
                                } else {
                                    phi_1382_ = _e705.unnamed.first_primitive;
                                }
                                let _e862 = phi_1382_;
                                if (_e858 == 0u) {
                                    phi_1392_ = _e774.unnamed.root;
                                } else {
                                    phi_1392_ = _e774.unnamed.first_primitive;
                                }
                                let _e871 = phi_1392_;
                                if (_e858 == 0u) {
                                    phi_1402_ = _e843.unnamed.root;
                                } else {
                                    phi_1402_ = _e843.unnamed.first_primitive;
                                }
                                let _e880 = phi_1402_;
                                let _e893 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e862 >> bitcast<u32>(((_e859 * 8u) & 31u))) & 255u)) * _e615) + (_e636 - _e379)), ((f32(((_e871 >> bitcast<u32>(((_e859 * 8u) & 31u))) & 255u)) * _e616) + (_e637 - _e380)));
                                let _e894 = core_intrinsics_maximum_number_nsz_f32_(_e893, ((f32(((_e880 >> bitcast<u32>(((_e859 * 8u) & 31u))) & 255u)) * _e617) + (_e638 - _e381)));
                                if (_e858 == 0u) {
                                    phi_1420_ = _e705.unnamed_1.root;
                                } else {
                                    phi_1420_ = _e705.unnamed_1.first_primitive;
                                }
                                let _e897 = phi_1420_;
                                if (_e858 == 0u) {
                                    phi_1430_ = _e774.unnamed_1.root;
                                } else {
                                    phi_1430_ = _e774.unnamed_1.first_primitive;
                                }
                                let _e906 = phi_1430_;
                                if (_e858 == 0u) {
                                    phi_1440_ = _e843.unnamed_1.root;
                                } else {
                                    phi_1440_ = _e843.unnamed_1.first_primitive;
                                }
                                let _e915 = phi_1440_;
                                let _e928 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e897 >> bitcast<u32>(((_e859 * 8u) & 31u))) & 255u)) * _e615) + (_e636 + _e379)), ((f32(((_e906 >> bitcast<u32>(((_e859 * 8u) & 31u))) & 255u)) * _e616) + (_e637 + _e380)));
                                let _e929 = core_intrinsics_minimum_number_nsz_f32_(_e928, ((f32(((_e915 >> bitcast<u32>(((_e859 * 8u) & 31u))) & 255u)) * _e617) + (_e638 + _e381)));
                                if (_e894 <= _e929) {
                                    if (_e894 <= _e579.t) {
                                        if (_e929 >= _e164.tmin) {
                                            if (_e858 == 0u) {
                                                let _e936 = nodes.member[(0u + _e581)].links[2u];
                                                phi_1476_ = _e936;
                                            } else {
                                                let _e939 = nodes.member[(0u + _e581)].links[3u];
                                                phi_1476_ = _e939;
                                            }
                                            let _e941 = phi_1476_;
                                            let _e946 = ((_e941 >> bitcast<u32>(((_e859 * 8u) & 31u))) & 255u);
                                            let _e947 = (_e946 & 31u);
                                            if (_e947 >= 24u) {
                                                phi_1489_ = (24u + ((_e947 - 24u) ^ _e441));
                                            } else {
                                                phi_1489_ = _e947;
                                            }
                                            let _e953 = phi_1489_;
                                            phi_1494_ = (_e855 | ((_e946 >> bitcast<u32>(5i)) << bitcast<u32>((_e953 & 31u))));
                                        } else {
                                            phi_1494_ = _e855;
                                        }
                                        let _e961 = phi_1494_;
                                        phi_1495_ = _e961;
                                    } else {
                                        phi_1495_ = _e855;
                                    }
                                    let _e963 = phi_1495_;
                                    phi_1496_ = _e963;
                                } else {
                                    phi_1496_ = _e855;
                                }
                                let _e965 = phi_1496_;
                                phi_1366_ = (_e853 + 1u);
                                phi_1369_ = _e965;
                            } else {
                                phi_1366_ = u32();
                                phi_1369_ = u32();
                            }
                            let _e968 = phi_1366_;
                            let _e970 = phi_1369_;
                            continue;
                            continuing {
                                phi_1365_ = _e968;
                                phi_1368_ = _e970;
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
                        phi_1554_ = _e579;
                        phi_1557_ = (_e1019 & 16777215u);
                        loop {
                            let _e1022 = phi_1554_;
                            let _e1024 = phi_1557_;
                            local_6 = _e1022;
                            if (_e1024 == 0u) {
                                phi_1555_ = lt_bvh_Hit();
                                phi_1558_ = u32();
                                phi_2314_ = false;
                            } else {
                                let _e1028 = nodes.member[(0u + _e581)].links[1u];
                                let _e1033 = ((0u + _e1028) + select(firstTrailingBit(_e1024), 32u, (_e1024 == 0u)));
                                if (_e1033 < _e82) {
                                } else {
                                    return;
                                }
                                let _e1040 = triangles.member[(0u + _e1033)].v0_;
                                let _e1043 = (_e1040.x - _e164.origin.x);
                                let _e1046 = (_e1040.y - _e164.origin.y);
                                let _e1049 = (_e1040.z - _e164.origin.z);
                                if (_e406 == 0u) {
                                    phi_1604_ = vec3<f32>(_e1046, _e1049, _e1043);
                                } else {
                                    if (_e406 == 1u) {
                                        phi_1603_ = vec3<f32>(_e1049, _e1043, _e1046);
                                    } else {
                                        phi_1603_ = (_e1040 - _e164.origin);
                                    }
                                    let _e1056 = phi_1603_;
                                    phi_1604_ = _e1056;
                                }
                                let _e1058 = phi_1604_;
                                let _e1062 = (_e1058.x - (_e425 * _e1058.z));
                                let _e1066 = (_e1058.y - (_e428 * _e1058.z));
                                let _e1070 = triangles.member[(0u + _e1033)].v1_;
                                let _e1073 = (_e1070.x - _e164.origin.x);
                                let _e1076 = (_e1070.y - _e164.origin.y);
                                let _e1079 = (_e1070.z - _e164.origin.z);
                                if (_e406 == 0u) {
                                    phi_1638_ = vec3<f32>(_e1076, _e1079, _e1073);
                                } else {
                                    if (_e406 == 1u) {
                                        phi_1637_ = vec3<f32>(_e1079, _e1073, _e1076);
                                    } else {
                                        phi_1637_ = (_e1070 - _e164.origin);
                                    }
                                    let _e1086 = phi_1637_;
                                    phi_1638_ = _e1086;
                                }
                                let _e1088 = phi_1638_;
                                let _e1092 = (_e1088.x - (_e425 * _e1088.z));
                                let _e1096 = (_e1088.y - (_e428 * _e1088.z));
                                let _e1100 = triangles.member[(0u + _e1033)].v2_;
                                let _e1103 = (_e1100.x - _e164.origin.x);
                                let _e1106 = (_e1100.y - _e164.origin.y);
                                let _e1109 = (_e1100.z - _e164.origin.z);
                                if (_e406 == 0u) {
                                    phi_1672_ = vec3<f32>(_e1106, _e1109, _e1103);
                                } else {
                                    if (_e406 == 1u) {
                                        phi_1671_ = vec3<f32>(_e1109, _e1103, _e1106);
                                    } else {
                                        phi_1671_ = (_e1100 - _e164.origin);
                                    }
                                    let _e1116 = phi_1671_;
                                    phi_1672_ = _e1116;
                                }
                                let _e1118 = phi_1672_;
                                let _e1122 = (_e1118.x - (_e425 * _e1118.z));
                                let _e1126 = (_e1118.y - (_e428 * _e1118.z));
                                if (_e1092 < _e1122) {
                                    phi_1693_ = true;
                                } else {
                                    if (_e1092 == _e1122) {
                                        phi_1692_ = (_e1096 < _e1126);
                                    } else {
                                        phi_1692_ = false;
                                    }
                                    let _e1133 = phi_1692_;
                                    phi_1693_ = _e1133;
                                }
                                let _e1135 = phi_1693_;
                                if _e1135 {
                                    phi_1697_ = _e1126;
                                    phi_1698_ = _e1122;
                                    phi_1699_ = _e1096;
                                    phi_1700_ = _e1092;
                                } else {
                                    phi_1697_ = _e1096;
                                    phi_1698_ = _e1092;
                                    phi_1699_ = _e1126;
                                    phi_1700_ = _e1122;
                                }
                                let _e1137 = phi_1697_;
                                let _e1139 = phi_1698_;
                                let _e1141 = phi_1699_;
                                let _e1143 = phi_1700_;
                                let _e1146 = ((_e1143 * _e1137) - (_e1141 * _e1139));
                                if _e1135 {
                                    phi_1708_ = -(_e1146);
                                } else {
                                    phi_1708_ = _e1146;
                                }
                                let _e1149 = phi_1708_;
                                if (_e1122 < _e1062) {
                                    phi_1719_ = true;
                                } else {
                                    if (_e1122 == _e1062) {
                                        phi_1718_ = (_e1126 < _e1066);
                                    } else {
                                        phi_1718_ = false;
                                    }
                                    let _e1154 = phi_1718_;
                                    phi_1719_ = _e1154;
                                }
                                let _e1156 = phi_1719_;
                                if _e1156 {
                                    phi_1723_ = _e1066;
                                    phi_1724_ = _e1062;
                                    phi_1725_ = _e1126;
                                    phi_1726_ = _e1122;
                                } else {
                                    phi_1723_ = _e1126;
                                    phi_1724_ = _e1122;
                                    phi_1725_ = _e1066;
                                    phi_1726_ = _e1062;
                                }
                                let _e1158 = phi_1723_;
                                let _e1160 = phi_1724_;
                                let _e1162 = phi_1725_;
                                let _e1164 = phi_1726_;
                                let _e1167 = ((_e1164 * _e1158) - (_e1162 * _e1160));
                                if _e1156 {
                                    phi_1734_ = -(_e1167);
                                } else {
                                    phi_1734_ = _e1167;
                                }
                                let _e1170 = phi_1734_;
                                if (_e1062 < _e1092) {
                                    phi_1745_ = true;
                                } else {
                                    if (_e1062 == _e1092) {
                                        phi_1744_ = (_e1066 < _e1096);
                                    } else {
                                        phi_1744_ = false;
                                    }
                                    let _e1175 = phi_1744_;
                                    phi_1745_ = _e1175;
                                }
                                let _e1177 = phi_1745_;
                                if _e1177 {
                                    phi_1749_ = _e1096;
                                    phi_1750_ = _e1092;
                                    phi_1751_ = _e1066;
                                    phi_1752_ = _e1062;
                                } else {
                                    phi_1749_ = _e1066;
                                    phi_1750_ = _e1062;
                                    phi_1751_ = _e1096;
                                    phi_1752_ = _e1092;
                                }
                                let _e1179 = phi_1749_;
                                let _e1181 = phi_1750_;
                                let _e1183 = phi_1751_;
                                let _e1185 = phi_1752_;
                                let _e1188 = ((_e1185 * _e1179) - (_e1183 * _e1181));
                                if _e1177 {
                                    phi_1760_ = -(_e1188);
                                } else {
                                    phi_1760_ = _e1188;
                                }
                                let _e1191 = phi_1760_;
                                if (_e1149 >= 0f) {
                                    if (_e1170 >= 0f) {
                                        if (_e1191 >= 0f) {
                                            phi_1775_ = ((_e1149 + _e1170) + _e1191);
                                            phi_1776_ = false;
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
                                    phi_1779_ = _e1202;
                                    phi_1780_ = _e1204;
                                } else {
                                    phi_1779_ = f32();
                                    phi_1780_ = true;
                                }
                                let _e1206 = phi_1779_;
                                let _e1208 = phi_1780_;
                                if _e1208 {
                                    if (_e1149 <= 0f) {
                                        if (_e1170 <= 0f) {
                                            let _e1211 = (_e1191 <= 0f);
                                            if _e1211 {
                                            }
                                            phi_1798_ = ((_e1149 + _e1170) + _e1191);
                                            phi_1799_ = false;
                                            phi_1800_ = _e1211;
                                        } else {
                                            phi_1798_ = f32();
                                            phi_1799_ = true;
                                            phi_1800_ = false;
                                        }
                                        let _e1215 = phi_1798_;
                                        let _e1217 = phi_1799_;
                                        let _e1219 = phi_1800_;
                                        phi_1801_ = _e1215;
                                        phi_1802_ = _e1217;
                                        phi_1803_ = _e1219;
                                    } else {
                                        phi_1801_ = f32();
                                        phi_1802_ = true;
                                        phi_1803_ = false;
                                    }
                                    let _e1221 = phi_1801_;
                                    let _e1223 = phi_1802_;
                                    let _e1225 = phi_1803_;
                                    if _e1223 {
                                        phi_1807_ = false;
                                    } else {
                                        phi_1807_ = _e1225;
                                    }
                                    let _e1227 = phi_1807_;
                                    phi_1808_ = _e1221;
                                    phi_1809_ = _e1227;
                                } else {
                                    phi_1808_ = _e1206;
                                    phi_1809_ = true;
                                }
                                let _e1229 = phi_1808_;
                                let _e1231 = phi_1809_;
                                if _e1231 {
                                    let _e1232 = (_e1229 == 0f);
                                    if _e1232 {
                                        phi_2030_ = lt_bvh_triangle_Intersection();
                                        phi_2031_ = false;
                                    } else {
                                        let _e1238 = ((((_e1149 * (_e430 * _e1058.z)) + (_e1170 * (_e430 * _e1088.z))) + (_e1191 * (_e430 * _e1118.z))) / _e1229);
                                        if (_e1238 > _e164.tmin) {
                                            if (_e1238 < _e164.tmax) {
                                                let _e1244 = triangles.member[(0u + _e1033)].v0_;
                                                let _e1246 = triangles.member[(0u + _e1033)].v1_;
                                                if (_e1244.x < _e1246.x) {
                                                    phi_1845_ = _e1244.x;
                                                } else {
                                                    phi_1845_ = _e1246.x;
                                                }
                                                let _e1253 = phi_1845_;
                                                if (_e1244.y < _e1246.y) {
                                                    phi_1854_ = _e1244.y;
                                                } else {
                                                    phi_1854_ = _e1246.y;
                                                }
                                                let _e1260 = phi_1854_;
                                                if (_e1244.z < _e1246.z) {
                                                    phi_1863_ = _e1244.z;
                                                } else {
                                                    phi_1863_ = _e1246.z;
                                                }
                                                let _e1267 = phi_1863_;
                                                let _e1269 = triangles.member[(0u + _e1033)].v2_;
                                                if (_e1253 < _e1269.x) {
                                                    phi_1872_ = _e1253;
                                                } else {
                                                    phi_1872_ = _e1269.x;
                                                }
                                                let _e1274 = phi_1872_;
                                                if (_e1260 < _e1269.y) {
                                                    phi_1879_ = _e1260;
                                                } else {
                                                    phi_1879_ = _e1269.y;
                                                }
                                                let _e1279 = phi_1879_;
                                                if (_e1267 < _e1269.z) {
                                                    phi_1886_ = _e1267;
                                                } else {
                                                    phi_1886_ = _e1269.z;
                                                }
                                                let _e1284 = phi_1886_;
                                                let _e1286 = triangles.member[(0u + _e1033)].v0_;
                                                let _e1288 = triangles.member[(0u + _e1033)].v1_;
                                                if (_e1286.x > _e1288.x) {
                                                    phi_1899_ = _e1286.x;
                                                } else {
                                                    phi_1899_ = _e1288.x;
                                                }
                                                let _e1295 = phi_1899_;
                                                if (_e1286.y > _e1288.y) {
                                                    phi_1908_ = _e1286.y;
                                                } else {
                                                    phi_1908_ = _e1288.y;
                                                }
                                                let _e1302 = phi_1908_;
                                                if (_e1286.z > _e1288.z) {
                                                    phi_1917_ = _e1286.z;
                                                } else {
                                                    phi_1917_ = _e1288.z;
                                                }
                                                let _e1309 = phi_1917_;
                                                let _e1311 = triangles.member[(0u + _e1033)].v2_;
                                                if (_e1295 > _e1311.x) {
                                                    phi_1926_ = _e1295;
                                                } else {
                                                    phi_1926_ = _e1311.x;
                                                }
                                                let _e1316 = phi_1926_;
                                                if (_e1302 > _e1311.y) {
                                                    phi_1933_ = _e1302;
                                                } else {
                                                    phi_1933_ = _e1311.y;
                                                }
                                                let _e1321 = phi_1933_;
                                                if (_e1309 > _e1311.z) {
                                                    phi_1940_ = _e1309;
                                                } else {
                                                    phi_1940_ = _e1311.z;
                                                }
                                                let _e1326 = phi_1940_;
                                                let _e1333 = ((_e1274 - _e164.origin.x) * _e318);
                                                let _e1334 = ((_e1279 - _e164.origin.y) * _e330);
                                                let _e1335 = ((_e1284 - _e164.origin.z) * _e342);
                                                let _e1342 = ((_e1316 - _e164.origin.x) * _e318);
                                                let _e1343 = ((_e1321 - _e164.origin.y) * _e330);
                                                let _e1344 = ((_e1326 - _e164.origin.z) * _e342);
                                                if (_e1333 < _e1342) {
                                                    phi_1963_ = _e1333;
                                                } else {
                                                    phi_1963_ = _e1342;
                                                }
                                                let _e1347 = phi_1963_;
                                                if (_e1334 < _e1343) {
                                                    phi_1968_ = _e1334;
                                                } else {
                                                    phi_1968_ = _e1343;
                                                }
                                                let _e1350 = phi_1968_;
                                                if (_e1335 < _e1344) {
                                                    phi_1973_ = _e1335;
                                                } else {
                                                    phi_1973_ = _e1344;
                                                }
                                                let _e1353 = phi_1973_;
                                                if (_e1333 > _e1342) {
                                                    phi_1981_ = _e1333;
                                                } else {
                                                    phi_1981_ = _e1342;
                                                }
                                                let _e1359 = phi_1981_;
                                                if (_e1334 > _e1343) {
                                                    phi_1986_ = _e1334;
                                                } else {
                                                    phi_1986_ = _e1343;
                                                }
                                                let _e1362 = phi_1986_;
                                                if (_e1335 > _e1344) {
                                                    phi_1991_ = _e1335;
                                                } else {
                                                    phi_1991_ = _e1344;
                                                }
                                                let _e1365 = phi_1991_;
                                                let _e1369 = core_intrinsics_maximum_number_nsz_f32_((_e1347 - _e386), (_e1350 - _e387));
                                                let _e1370 = core_intrinsics_maximum_number_nsz_f32_(_e1369, (_e1353 - _e388));
                                                let _e1371 = core_intrinsics_minimum_number_nsz_f32_((_e1359 + _e386), (_e1362 + _e387));
                                                let _e1372 = core_intrinsics_minimum_number_nsz_f32_(_e1371, (_e1365 + _e388));
                                                if (_e1370 > -300000000000000000000000000000000000000f) {
                                                    phi_2003_ = _e1370;
                                                } else {
                                                    phi_2003_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1375 = phi_2003_;
                                                if (_e1372 < 300000000000000000000000000000000000000f) {
                                                    phi_2008_ = _e1372;
                                                } else {
                                                    phi_2008_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1378 = phi_2008_;
                                                if (_e1238 < _e1375) {
                                                    phi_2013_ = _e1375;
                                                } else {
                                                    phi_2013_ = _e1238;
                                                }
                                                let _e1381 = phi_2013_;
                                                if (_e1381 > _e1378) {
                                                    phi_2018_ = _e1378;
                                                } else {
                                                    phi_2018_ = _e1381;
                                                }
                                                let _e1384 = phi_2018_;
                                                phi_2023_ = lt_bvh_triangle_Intersection(_e1384, (_e1170 / _e1229), (_e1191 / _e1229), (_e1375 <= _e1378));
                                                phi_2024_ = false;
                                            } else {
                                                phi_2023_ = lt_bvh_triangle_Intersection();
                                                phi_2024_ = true;
                                            }
                                            let _e1390 = phi_2023_;
                                            let _e1392 = phi_2024_;
                                            phi_2025_ = _e1390;
                                            phi_2026_ = _e1392;
                                        } else {
                                            phi_2025_ = lt_bvh_triangle_Intersection();
                                            phi_2026_ = true;
                                        }
                                        let _e1394 = phi_2025_;
                                        let _e1396 = phi_2026_;
                                        if _e1396 {
                                        }
                                        phi_2030_ = _e1394;
                                        phi_2031_ = _e1396;
                                    }
                                    let _e1398 = phi_2030_;
                                    let _e1400 = phi_2031_;
                                    phi_2032_ = _e1398;
                                    phi_2033_ = _e1232;
                                    phi_2034_ = _e1400;
                                } else {
                                    phi_2032_ = lt_bvh_triangle_Intersection();
                                    phi_2033_ = true;
                                    phi_2034_ = false;
                                }
                                let _e1402 = phi_2032_;
                                let _e1404 = phi_2033_;
                                let _e1406 = phi_2034_;
                                if _e1404 {
                                    phi_2038_ = true;
                                } else {
                                    phi_2038_ = _e1406;
                                }
                                let _e1408 = phi_2038_;
                                if _e1408 {
                                    phi_2042_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_2042_ = _e1402;
                                }
                                let _e1410 = phi_2042_;
                                if _e1410.is_hit {
                                    if (_e1410.t > _e164.tmin) {
                                        if (_e1410.t < _e1022.t) {
                                            phi_2091_ = true;
                                        } else {
                                            if (_e1410.t == _e1022.t) {
                                                if (_e1022.triangle != 4294967295u) {
                                                    if (_e1033 < _e1022.triangle) {
                                                        phi_2082_ = true;
                                                    } else {
                                                        if (_e1033 == _e1022.triangle) {
                                                            phi_2081_ = (4294967295u < _e1022.instance);
                                                        } else {
                                                            phi_2081_ = false;
                                                        }
                                                        let _e1429 = phi_2081_;
                                                        phi_2082_ = _e1429;
                                                    }
                                                    let _e1431 = phi_2082_;
                                                    phi_2083_ = _e1431;
                                                    phi_2084_ = false;
                                                } else {
                                                    phi_2083_ = bool();
                                                    phi_2084_ = true;
                                                }
                                                let _e1433 = phi_2083_;
                                                let _e1435 = phi_2084_;
                                                phi_2085_ = _e1433;
                                                phi_2086_ = _e1435;
                                            } else {
                                                phi_2085_ = bool();
                                                phi_2086_ = true;
                                            }
                                            let _e1437 = phi_2085_;
                                            let _e1439 = phi_2086_;
                                            if _e1439 {
                                                phi_2090_ = false;
                                            } else {
                                                phi_2090_ = _e1437;
                                            }
                                            let _e1441 = phi_2090_;
                                            phi_2091_ = _e1441;
                                        }
                                        let _e1443 = phi_2091_;
                                        if _e1443 {
                                            let _e1445 = triangles.member[(0u + _e1033)].i0_;
                                            if ((_e1445 & 2147483648u) == 0u) {
                                                phi_2302_ = true;
                                            } else {
                                                if (_e1033 < _e82) {
                                                } else {
                                                    return;
                                                }
                                                let _e1454 = triangles.member[(0u + _e1033)].i0_;
                                                let _e1455 = (_e1454 & 2147483647u);
                                                let _e1457 = triangles.member[(0u + _e1033)].i1_;
                                                let _e1459 = triangles.member[(0u + _e1033)].i2_;
                                                if (_e1455 < _e85) {
                                                } else {
                                                    return;
                                                }
                                                let _e1463 = vertices.member[(0u + _e1455)];
                                                if (_e1457 < _e85) {
                                                } else {
                                                    return;
                                                }
                                                let _e1467 = vertices.member[(0u + _e1457)];
                                                if (_e1459 < _e85) {
                                                } else {
                                                    return;
                                                }
                                                let _e1471 = vertices.member[(0u + _e1459)];
                                                let _e1472 = array<abi_Vertex, 3>(_e1463, _e1467, _e1471);
                                                if (_e1472[0].material < _e88) {
                                                } else {
                                                    return;
                                                }
                                                let _e1478 = materials.member[(0u + _e1472[0].material)];
                                                if ((_e1478.flags & 0u) == 0u) {
                                                    let _e1483 = ((1f - _e1410.u) - _e1410.v);
                                                    if (_e1478.cutoff <= 0f) {
                                                        phi_2297_ = true;
                                                    } else {
                                                        let _e1510 = (_e1478.base_color.w * ((((f32((_e1472[0].color >> bitcast<u32>(24i))) * _e1483) + (f32((_e1472[1].color >> bitcast<u32>(24i))) * _e1410.u)) + (f32((_e1472[2].color >> bitcast<u32>(24i))) * _e1410.v)) * (1f / 255f)));
                                                        if (_e1478.alpha_size == 0u) {
                                                            phi_2294_ = _e1510;
                                                        } else {
                                                            local_1.offset = _e1478.alpha_offset;
                                                            local_1.size = _e1478.alpha_size;
                                                            local_1.flags = _e1478.flags;
                                                            let _e1541 = _lt_shaders_texture_TextureView_quad((&local_1), (((_e1472[0].u * _e1483) + (_e1472[1].u * _e1410.u)) + (_e1472[2].u * _e1410.v)), (((_e1472[0].v * _e1483) + (_e1472[1].v * _e1410.u)) + (_e1472[2].v * _e1410.v)));
                                                            let _e1545 = (_e1541.indices[0] >> bitcast<u32>(2i));
                                                            if (_e1545 < _e94) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1549 = alpha_texels.member[(0u + _e1545)];
                                                            let _e1565 = (_e1541.indices[1] >> bitcast<u32>(2i));
                                                            if (_e1565 < _e94) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1569 = alpha_texels.member[(0u + _e1565)];
                                                            let _e1586 = (_e1541.indices[2] >> bitcast<u32>(2i));
                                                            if (_e1586 < _e94) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1590 = alpha_texels.member[(0u + _e1586)];
                                                            let _e1607 = (_e1541.indices[3] >> bitcast<u32>(2i));
                                                            if (_e1607 < _e94) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1611 = alpha_texels.member[(0u + _e1607)];
                                                            phi_2294_ = (_e1510 * (((((f32(((_e1549 >> bitcast<u32>((((_e1541.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1541.weights.x) + ((f32(((_e1569 >> bitcast<u32>((((_e1541.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1541.weights.y)) + ((f32(((_e1590 >> bitcast<u32>((((_e1541.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1541.weights.z)) + ((f32(((_e1611 >> bitcast<u32>((((_e1541.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1541.weights.w)));
                                                        }
                                                        let _e1627 = phi_2294_;
                                                        phi_2297_ = (_e1627 >= _e1478.cutoff);
                                                    }
                                                    let _e1631 = phi_2297_;
                                                    phi_2298_ = _e1631;
                                                } else {
                                                    phi_2298_ = false;
                                                }
                                                let _e1633 = phi_2298_;
                                                if _e1633 {
                                                }
                                                phi_2302_ = _e1633;
                                            }
                                            let _e1635 = phi_2302_;
                                            if _e1635 {
                                                phi_2310_ = lt_bvh_Hit(_e1410.t, _e1410.u, _e1410.v, _e1033, 4294967295u);
                                            } else {
                                                phi_2310_ = _e1022;
                                            }
                                            let _e1641 = phi_2310_;
                                            phi_2311_ = _e1641;
                                        } else {
                                            phi_2311_ = _e1022;
                                        }
                                        let _e1643 = phi_2311_;
                                        phi_2312_ = _e1643;
                                    } else {
                                        phi_2312_ = _e1022;
                                    }
                                    let _e1645 = phi_2312_;
                                    phi_2313_ = _e1645;
                                } else {
                                    phi_2313_ = _e1022;
                                }
                                let _e1647 = phi_2313_;
                                phi_1555_ = _e1647;
                                phi_1558_ = (_e1024 & (_e1024 - 1u));
                                phi_2314_ = true;
                            }
                            let _e1649 = phi_1555_;
                            let _e1651 = phi_1558_;
                            let _e1653 = phi_2314_;
                            continue;
                            continuing {
                                phi_1554_ = _e1649;
                                phi_1557_ = _e1651;
                                break if !(_e1653);
                            }
                        }
                        let _e1656 = local_2.group_mask;
                        if ((_e1656 & 4278190080u) == 0u) {
                            let _e1660 = local_2.len;
                            if (_e1660 == 0u) {
                                phi_2353_ = false;
                            } else {
                                let _e1664 = local_2.len;
                                local_2.len = (_e1664 - 1u);
                                let _e1667 = local_2.len;
                                if (_e1667 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1672 = local_2.first[(0u + _e1667)];
                                local_2.group = _e1672;
                                let _e1675 = local_2.len;
                                if (_e1675 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1680 = local_2.mask[(0u + _e1675)];
                                local_2.group_mask = _e1680;
                                phi_2353_ = true;
                            }
                            let _e1683 = phi_2353_;
                            phi_2354_ = _e1683;
                        } else {
                            phi_2354_ = true;
                        }
                        let _e1685 = phi_2354_;
                        if _e1685 {
                            let _e1687 = local_2.group_mask;
                            let _e1693 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1687)), 32u, (_e1687 == 0u)));
                            let _e1697 = local_2.group_mask;
                            let _e1711 = local_2.group_mask;
                            local_2.group_mask = (_e1711 & ~((1u << bitcast<u32>((_e1693 & 31u)))));
                            let _e1714 = local_2.group;
                            phi_2385_ = (_e1714 + countOneBits(((_e1697 & ~((4294967295u << bitcast<u32>((((_e1693 - 24u) ^ _e441) & 31u))))) & 255u)));
                        } else {
                            phi_2385_ = 4294967295u;
                        }
                        let _e1717 = phi_2385_;
                        let _e2634 = local_6;
                        phi_1218_ = _e2634;
                        phi_1221_ = _e1717;
                    } else {
                        phi_1218_ = lt_bvh_Hit();
                        phi_1221_ = u32();
                    }
                    let _e1719 = phi_1218_;
                    let _e1721 = phi_1221_;
                    continue;
                    continuing {
                        phi_1217_ = _e1719;
                        phi_1220_ = _e1721;
                        break if !(_e582);
                    }
                }
                let _e2638 = local_7;
                phi_2386_ = _e2638;
            }
            let _e1724 = phi_2386_;
            phi_2387_ = _e1724;
            phi_2388_ = _e236;
        } else {
            phi_2387_ = lt_bvh_Hit();
            phi_2388_ = true;
        }
        let _e1726 = phi_2387_;
        let _e1728 = phi_2388_;
        if _e1728 {
            phi_2392_ = _e166;
        } else {
            phi_2392_ = _e1726;
        }
        let _e1730 = phi_2392_;
        if (_e1730.triangle != 4294967295u) {
            let _e1736 = ((1f - _e1730.u) - _e1730.v);
            if (_e1730.triangle < _e82) {
            } else {
                return;
            }
            let _e1741 = triangles.member[(0u + _e1730.triangle)];
            let _e1766 = (((_e1741.v0_.x * _e1736) + (_e1741.v1_.x * _e1730.u)) + (_e1741.v2_.x * _e1730.v));
            let _e1767 = (((_e1741.v0_.y * _e1736) + (_e1741.v1_.y * _e1730.u)) + (_e1741.v2_.y * _e1730.v));
            let _e1768 = (((_e1741.v0_.z * _e1736) + (_e1741.v1_.z * _e1730.u)) + (_e1741.v2_.z * _e1730.v));
            let _e1771 = abs(_e1741.v0_.x);
            let _e1773 = abs(_e1741.v0_.y);
            let _e1775 = abs(_e1741.v0_.z);
            let _e1777 = abs(_e1741.v1_.x);
            let _e1779 = abs(_e1741.v1_.y);
            let _e1781 = abs(_e1741.v1_.z);
            if (_e1771 > _e1777) {
                phi_2456_ = _e1771;
            } else {
                phi_2456_ = _e1777;
            }
            let _e1784 = phi_2456_;
            if (_e1773 > _e1779) {
                phi_2461_ = _e1773;
            } else {
                phi_2461_ = _e1779;
            }
            let _e1787 = phi_2461_;
            if (_e1775 > _e1781) {
                phi_2466_ = _e1775;
            } else {
                phi_2466_ = _e1781;
            }
            let _e1790 = phi_2466_;
            let _e1792 = abs(_e1741.v2_.x);
            let _e1794 = abs(_e1741.v2_.y);
            let _e1796 = abs(_e1741.v2_.z);
            if (_e1784 > _e1792) {
                phi_2477_ = _e1784;
            } else {
                phi_2477_ = _e1792;
            }
            let _e1799 = phi_2477_;
            if (_e1787 > _e1794) {
                phi_2482_ = _e1787;
            } else {
                phi_2482_ = _e1794;
            }
            let _e1802 = phi_2482_;
            if (_e1790 > _e1796) {
                phi_2487_ = _e1790;
            } else {
                phi_2487_ = _e1796;
            }
            let _e1805 = phi_2487_;
            let _e1808 = (_e1741.v1_.x - _e1741.v0_.x);
            let _e1811 = (_e1741.v1_.y - _e1741.v0_.y);
            let _e1814 = (_e1741.v1_.z - _e1741.v0_.z);
            let _e1817 = (_e1741.v2_.x - _e1741.v0_.x);
            let _e1820 = (_e1741.v2_.y - _e1741.v0_.y);
            let _e1823 = (_e1741.v2_.z - _e1741.v0_.z);
            let _e1827 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1811), abs(_e1814));
            let _e1828 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1808), _e1827);
            let _e1829 = (_e1808 / _e1828);
            let _e1830 = (_e1811 / _e1828);
            let _e1831 = (_e1814 / _e1828);
            let _e1835 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1820), abs(_e1823));
            let _e1836 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1817), _e1835);
            let _e1837 = (_e1817 / _e1836);
            let _e1838 = (_e1820 / _e1836);
            let _e1839 = (_e1823 / _e1836);
            let _e1842 = ((_e1830 * _e1839) - (_e1838 * _e1831));
            let _e1845 = ((_e1831 * _e1837) - (_e1839 * _e1829));
            let _e1848 = ((_e1829 * _e1838) - (_e1837 * _e1830));
            let _e1850 = p.member.eye;
            let _e1863 = (1f / sqrt((((_e1842 * _e1842) + (_e1845 * _e1845)) + (_e1848 * _e1848))));
            let _e1864 = (_e1842 * _e1863);
            let _e1865 = (_e1845 * _e1863);
            let _e1866 = (_e1848 * _e1863);
            if ((((_e1864 * (_e1850.x - _e1766)) + (_e1865 * (_e1850.y - _e1767))) + (_e1866 * (_e1850.z - _e1768))) < 0f) {
                phi_2563_ = vec3<f32>(-(_e1864), -(_e1865), -(_e1866));
            } else {
                phi_2563_ = vec3<f32>(_e1864, _e1865, _e1866);
            }
            let _e1879 = phi_2563_;
            if (_e1730.triangle < _e82) {
            } else {
                return;
            }
            let _e1884 = triangles.member[(0u + _e1730.triangle)];
            let _e1886 = (_e1884.i0_ & 2147483647u);
            if (_e1886 < _e85) {
            } else {
                return;
            }
            let _e1892 = vertices.member[(0u + _e1886)];
            if (_e1884.i1_ < _e85) {
            } else {
                return;
            }
            let _e1896 = vertices.member[(0u + _e1884.i1_)];
            if (_e1884.i2_ < _e85) {
            } else {
                return;
            }
            let _e1900 = vertices.member[(0u + _e1884.i2_)];
            let _e1901 = array<abi_Vertex, 3>(_e1892, _e1896, _e1900);
            if (_e1901[0].material < _e88) {
            } else {
                return;
            }
            let _e1907 = materials.member[(0u + _e1901[0].material)];
            let _e1924 = (1f / 255f);
            let _e1943 = (1f / 255f);
            let _e1965 = (1f / 255f);
            if (_e1907.color_size == 0u) {
                phi_2806_ = vec3<f32>(1f, 1f, 1f);
            } else {
                local.offset = _e1907.color_offset;
                local.size = _e1907.color_size;
                local.flags = _e1907.flags;
                let _e2008 = _lt_shaders_texture_TextureView_quad((&local), (((_e1901[0].u * _e1736) + (_e1901[1].u * _e1730.u)) + (_e1901[2].u * _e1730.v)), (((_e1901[0].v * _e1736) + (_e1901[1].v * _e1730.u)) + (_e1901[2].v * _e1730.v)));
                if (_e2008.indices[0] < _e97) {
                } else {
                    return;
                }
                let _e2014 = color_texels.member[(0u + _e2008.indices[0])];
                let _e2025 = (1f / 255f);
                if (_e2008.indices[1] < _e97) {
                } else {
                    return;
                }
                let _e2039 = color_texels.member[(0u + _e2008.indices[1])];
                let _e2050 = (1f / 255f);
                if (_e2008.indices[2] < _e97) {
                } else {
                    return;
                }
                let _e2067 = color_texels.member[(0u + _e2008.indices[2])];
                let _e2078 = (1f / 255f);
                if (_e2008.indices[3] < _e97) {
                } else {
                    return;
                }
                let _e2095 = color_texels.member[(0u + _e2008.indices[3])];
                let _e2106 = (1f / 255f);
                let _e2115 = (((((f32((_e2014 & 255u)) * _e2025) * _e2008.weights.x) + ((f32((_e2039 & 255u)) * _e2050) * _e2008.weights.y)) + ((f32((_e2067 & 255u)) * _e2078) * _e2008.weights.z)) + ((f32((_e2095 & 255u)) * _e2106) * _e2008.weights.w));
                let _e2116 = (((((f32(((_e2014 >> bitcast<u32>(8i)) & 255u)) * _e2025) * _e2008.weights.x) + ((f32(((_e2039 >> bitcast<u32>(8i)) & 255u)) * _e2050) * _e2008.weights.y)) + ((f32(((_e2067 >> bitcast<u32>(8i)) & 255u)) * _e2078) * _e2008.weights.z)) + ((f32(((_e2095 >> bitcast<u32>(8i)) & 255u)) * _e2106) * _e2008.weights.w));
                let _e2117 = (((((f32(((_e2014 >> bitcast<u32>(16i)) & 255u)) * _e2025) * _e2008.weights.x) + ((f32(((_e2039 >> bitcast<u32>(16i)) & 255u)) * _e2050) * _e2008.weights.y)) + ((f32(((_e2067 >> bitcast<u32>(16i)) & 255u)) * _e2078) * _e2008.weights.z)) + ((f32(((_e2095 >> bitcast<u32>(16i)) & 255u)) * _e2106) * _e2008.weights.w));
                phi_2806_ = vec3<f32>((_e2115 * _e2115), (_e2116 * _e2116), (_e2117 * _e2117));
            }
            let _e2123 = phi_2806_;
            let _e2125 = ((_e1907.base_color.x * ((((f32((_e1901[0].color & 255u)) * _e1924) * _e1736) + ((f32((_e1901[1].color & 255u)) * _e1943) * _e1730.u)) + ((f32((_e1901[2].color & 255u)) * _e1965) * _e1730.v))) * _e2123.x);
            let _e2127 = ((_e1907.base_color.y * ((((f32(((_e1901[0].color >> bitcast<u32>(8i)) & 255u)) * _e1924) * _e1736) + ((f32(((_e1901[1].color >> bitcast<u32>(8i)) & 255u)) * _e1943) * _e1730.u)) + ((f32(((_e1901[2].color >> bitcast<u32>(8i)) & 255u)) * _e1965) * _e1730.v))) * _e2123.y);
            let _e2129 = ((_e1907.base_color.z * ((((f32(((_e1901[0].color >> bitcast<u32>(16i)) & 255u)) * _e1924) * _e1736) + ((f32(((_e1901[1].color >> bitcast<u32>(16i)) & 255u)) * _e1943) * _e1730.u)) + ((f32(((_e1901[2].color >> bitcast<u32>(16i)) & 255u)) * _e1965) * _e1730.v))) * _e2123.z);
            let _e2130 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1802, _e1805);
            let _e2131 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1799, _e2130);
            if ((_e1907.flags & 2u) == 0u) {
                phi_2821_ = 0u;
            } else {
                phi_2821_ = 1u;
            }
            let _e2136 = phi_2821_;
            if (_e1901[0].normal == 2147516416u) {
                phi_3024_ = _e1879;
            } else {
                let _e2149 = (f32((bitcast<i32>((_e1901[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2155 = (f32((bitcast<i32>(_e1901[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2159 = ((1f - abs(_e2149)) - abs(_e2155));
                if (_e2159 < 0f) {
                    phi_2848_ = -(_e2159);
                } else {
                    phi_2848_ = 0f;
                }
                let _e2163 = phi_2848_;
                if (_e2149 < 0f) {
                    phi_2855_ = (_e2149 + _e2163);
                } else {
                    phi_2855_ = (_e2149 - _e2163);
                }
                let _e2168 = phi_2855_;
                if (_e2155 < 0f) {
                    phi_2862_ = (_e2155 + _e2163);
                } else {
                    phi_2862_ = (_e2155 - _e2163);
                }
                let _e2173 = phi_2862_;
                let _e2180 = (1f / sqrt((((_e2168 * _e2168) + (_e2173 * _e2173)) + (_e2159 * _e2159))));
                let _e2196 = (f32((bitcast<i32>((_e1901[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2202 = (f32((bitcast<i32>(_e1901[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2206 = ((1f - abs(_e2196)) - abs(_e2202));
                if (_e2206 < 0f) {
                    phi_2897_ = -(_e2206);
                } else {
                    phi_2897_ = 0f;
                }
                let _e2210 = phi_2897_;
                if (_e2196 < 0f) {
                    phi_2904_ = (_e2196 + _e2210);
                } else {
                    phi_2904_ = (_e2196 - _e2210);
                }
                let _e2215 = phi_2904_;
                if (_e2202 < 0f) {
                    phi_2911_ = (_e2202 + _e2210);
                } else {
                    phi_2911_ = (_e2202 - _e2210);
                }
                let _e2220 = phi_2911_;
                let _e2227 = (1f / sqrt((((_e2215 * _e2215) + (_e2220 * _e2220)) + (_e2206 * _e2206))));
                let _e2246 = (f32((bitcast<i32>((_e1901[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2252 = (f32((bitcast<i32>(_e1901[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2256 = ((1f - abs(_e2246)) - abs(_e2252));
                if (_e2256 < 0f) {
                    phi_2949_ = -(_e2256);
                } else {
                    phi_2949_ = 0f;
                }
                let _e2260 = phi_2949_;
                if (_e2246 < 0f) {
                    phi_2956_ = (_e2246 + _e2260);
                } else {
                    phi_2956_ = (_e2246 - _e2260);
                }
                let _e2265 = phi_2956_;
                if (_e2252 < 0f) {
                    phi_2963_ = (_e2252 + _e2260);
                } else {
                    phi_2963_ = (_e2252 - _e2260);
                }
                let _e2270 = phi_2963_;
                let _e2277 = (1f / sqrt((((_e2265 * _e2265) + (_e2270 * _e2270)) + (_e2256 * _e2256))));
                let _e2288 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(vec3<f32>(((((_e2168 * _e2180) * _e1736) + ((_e2215 * _e2227) * _e1730.u)) + ((_e2265 * _e2277) * _e1730.v)), ((((_e2173 * _e2180) * _e1736) + ((_e2220 * _e2227) * _e1730.u)) + ((_e2270 * _e2277) * _e1730.v)), ((((_e2159 * _e2180) * _e1736) + ((_e2206 * _e2227) * _e1730.u)) + ((_e2256 * _e2277) * _e1730.v))));
                let _e2300 = sqrt((((_e2288.x * _e2288.x) + (_e2288.y * _e2288.y)) + (_e2288.z * _e2288.z)));
                if (_e2300 > 0f) {
                    let _e2303 = (_e2288.x / _e2300);
                    let _e2305 = (_e2288.y / _e2300);
                    let _e2307 = (_e2288.z / _e2300);
                    if ((((_e2303 * _e1879.x) + (_e2305 * _e1879.y)) + (_e2307 * _e1879.z)) < 0f) {
                        phi_3022_ = vec3<f32>(-(_e2303), -(_e2305), -(_e2307));
                    } else {
                        phi_3022_ = (_e2288 / vec3(_e2300));
                    }
                    let _e2324 = phi_3022_;
                    phi_3023_ = _e2324;
                } else {
                    phi_3023_ = _e1879;
                }
                let _e2326 = phi_3023_;
                phi_3024_ = _e2326;
            }
            let _e2328 = phi_3024_;
            if (_e2125 > 0f) {
                if (_e2125 < 1f) {
                    phi_3033_ = _e2125;
                } else {
                    phi_3033_ = 1f;
                }
                let _e2332 = phi_3033_;
                phi_3034_ = _e2332;
            } else {
                phi_3034_ = 0f;
            }
            let _e2334 = phi_3034_;
            if (_e2127 > 0f) {
                if (_e2127 < 1f) {
                    phi_3044_ = _e2127;
                } else {
                    phi_3044_ = 1f;
                }
                let _e2339 = phi_3044_;
                phi_3045_ = _e2339;
            } else {
                phi_3045_ = 0f;
            }
            let _e2341 = phi_3045_;
            if (_e2129 > 0f) {
                if (_e2129 < 1f) {
                    phi_3055_ = _e2129;
                } else {
                    phi_3055_ = 1f;
                }
                let _e2346 = phi_3055_;
                phi_3056_ = _e2346;
            } else {
                phi_3056_ = 0f;
            }
            let _e2348 = phi_3056_;
            let _e2351 = ((sqrt(_e2334) * 255f) + 0.5f);
            let _e2360 = ((sqrt(_e2341) * 255f) + 0.5f);
            let _e2372 = ((sqrt(_e2348) * 255f) + 0.5f);
            phi_3091_ = abi_Sample(vec3<f32>(_e1766, _e1767, _e1768), _e2131, _e1879, _e2136, _e2328, ((select(select(u32(_e2351), 0u, (_e2351 < bitcast<f32>(0u))), 4294967295u, (_e2351 > bitcast<f32>(1333788671u))) | (select(select(u32(_e2360), 0u, (_e2360 < bitcast<f32>(0u))), 4294967295u, (_e2360 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e2372), 0u, (_e2372 < bitcast<f32>(0u))), 4294967295u, (_e2372 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_3091_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e2386 = phi_3091_;
        if (_e109.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e109.first_primitive)] = _e2386;
        if (_e1730.triangle != 4294967295u) {
            let _e2395 = ((1f - _e1730.u) - _e1730.v);
            if (_e1730.triangle < _e82) {
            } else {
                return;
            }
            let _e2400 = triangles.member[(0u + _e1730.triangle)];
            let _e2402 = (_e2400.i0_ & 2147483647u);
            if (_e2402 < _e100) {
            } else {
                return;
            }
            let _e2408 = before.member[(0u + _e2402)];
            if (_e2400.i1_ < _e100) {
            } else {
                return;
            }
            let _e2412 = before.member[(0u + _e2400.i1_)];
            if (_e2400.i2_ < _e100) {
            } else {
                return;
            }
            let _e2416 = before.member[(0u + _e2400.i2_)];
            let _e2421 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2408.x, _e2408.y, _e2408.z));
            let _e2432 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2412.x, _e2412.y, _e2412.z));
            let _e2446 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2416.x, _e2416.y, _e2416.z));
            phi_3182_ = vec3<f32>((((_e2421.x * _e2395) + (_e2432.x * _e1730.u)) + (_e2446.x * _e1730.v)), (((_e2421.y * _e2395) + (_e2432.y * _e1730.u)) + (_e2446.y * _e1730.v)), (((_e2421.z * _e2395) + (_e2432.z * _e1730.u)) + (_e2446.z * _e1730.v)));
        } else {
            phi_3182_ = vec3<f32>(0f, 0f, 0f);
        }
        let _e2458 = phi_3182_;
        if (_e109.first_primitive < arrayLength((&past.member))) {
        } else {
            return;
        }
        past.member[(0u + _e109.first_primitive)] = vec4<f32>(_e2458.x, _e2458.y, _e2458.z, 1f);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_alpha_color_motion_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
