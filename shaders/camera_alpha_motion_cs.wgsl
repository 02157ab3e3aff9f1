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

struct type_28 {
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

struct type_36 {
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

struct type_40 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_44 {
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

struct type_48 {
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

struct type_56 {
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
var<storage> vertices: type_44;
@group(0) @binding(4) 
var<storage> materials: type_48;
@group(0) @binding(0) 
var<uniform> p: type_56;
@group(0) @binding(1) 
var<storage> nodes: type_36;
@group(0) @binding(2) 
var<storage> triangles: type_40;
@group(0) @binding(5) 
var<storage, read_write> samples: type_20;
@group(0) @binding(6) 
var<storage> alpha_texels: type_9;
@group(0) @binding(7) 
var<storage> before: type_28;
@group(0) @binding(8) 
var<storage, read_write> past: type_28;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_224_: lt_bvh_traverse_Tree;
    var phi_225_: bool;
    var phi_226_: lt_bvh_traverse_Tree;
    var phi_227_: bool;
    var phi_232_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_224_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_225_ = false;
        } else {
            phi_224_ = lt_bvh_traverse_Tree();
            phi_225_ = true;
        }
        let _e85 = phi_224_;
        let _e87 = phi_225_;
        phi_226_ = _e85;
        phi_227_ = _e87;
    } else {
        phi_226_ = lt_bvh_traverse_Tree();
        phi_227_ = true;
    }
    let _e89 = phi_226_;
    let _e91 = phi_227_;
    if _e91 {
        phi_232_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_232_ = _e89;
    }
    let _e96 = phi_232_;
    return lt_bvh_traverse_Tree(_e96.root, _e96.first_primitive);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_247_: bool;
    var phi_251_: f32;

    if (param_3 != param_3) {
        phi_247_ = true;
    } else {
        let _e75 = (param_4 >= param_3);
        if _e75 {
        }
        phi_247_ = _e75;
    }
    let _e77 = phi_247_;
    if _e77 {
        phi_251_ = param_4;
    } else {
        phi_251_ = param_3;
    }
    let _e79 = phi_251_;
    return _e79;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_263_: bool;
    var phi_267_: f32;

    if (param_5 != param_5) {
        phi_263_ = true;
    } else {
        let _e75 = (param_6 <= param_5);
        if _e75 {
        }
        phi_263_ = _e75;
    }
    let _e77 = phi_263_;
    if _e77 {
        phi_267_ = param_6;
    } else {
        phi_267_ = param_5;
    }
    let _e79 = phi_267_;
    return _e79;
}

fn _lt_shaders_texture_TextureView_quad(param_7: ptr<function, texture_TextureView>, param_8: f32, param_9: f32) -> texture_TexelQuad {
    var phi_309_: f32;
    var phi_314_: f32;
    var phi_315_: bool;
    var phi_316_: f32;
    var phi_317_: bool;
    var phi_321_: f32;
    var phi_347_: f32;
    var phi_352_: f32;
    var phi_353_: bool;
    var phi_354_: f32;
    var phi_355_: bool;
    var phi_359_: f32;
    var phi_367_: f32;
    var phi_368_: f32;
    var phi_369_: f32;
    var phi_378_: f32;
    var phi_379_: f32;
    var phi_397_: u32;
    var phi_411_: u32;
    var phi_418_: u32;
    var phi_423_: u32;
    var phi_429_: u32;
    var phi_434_: u32;
    var phi_436_: texture_Axis;
    var phi_464_: f32;
    var phi_469_: f32;
    var phi_470_: bool;
    var phi_471_: f32;
    var phi_472_: bool;
    var phi_476_: f32;
    var phi_502_: f32;
    var phi_507_: f32;
    var phi_508_: bool;
    var phi_509_: f32;
    var phi_510_: bool;
    var phi_514_: f32;
    var phi_522_: f32;
    var phi_523_: f32;
    var phi_524_: f32;
    var phi_533_: f32;
    var phi_534_: f32;
    var phi_552_: u32;
    var phi_566_: u32;
    var phi_573_: u32;
    var phi_578_: u32;
    var phi_584_: u32;
    var phi_589_: u32;
    var phi_591_: texture_Axis;

    let _e76 = (*param_7).size;
    let _e77 = (_e76 & 65535u);
    let _e79 = (*param_7).size;
    let _e81 = (_e79 >> bitcast<u32>(16i));
    let _e83 = (*param_7).flags;
    let _e85 = ((_e83 & 4u) != 0u);
    let _e87 = (*param_7).flags;
    let _e90 = ((_e87 >> bitcast<u32>(4u)) & 3u);
    if (_e90 == 0u) {
        if (param_8 > -8388608f) {
            let _e103 = f32(select(0i, select(select(i32(param_8), i32(-2147483648), (param_8 < bitcast<f32>(3472883712u))), 2147483647i, (param_8 > bitcast<f32>(1325400063u))), (param_8 == param_8)));
            if (_e103 > param_8) {
                phi_309_ = 1f;
            } else {
                phi_309_ = 0f;
            }
            let _e106 = phi_309_;
            if (param_8 < 8388608f) {
                phi_314_ = (_e103 - _e106);
                phi_315_ = false;
            } else {
                phi_314_ = f32();
                phi_315_ = true;
            }
            let _e109 = phi_314_;
            let _e111 = phi_315_;
            phi_316_ = _e109;
            phi_317_ = _e111;
        } else {
            phi_316_ = f32();
            phi_317_ = true;
        }
        let _e113 = phi_316_;
        let _e115 = phi_317_;
        if _e115 {
            phi_321_ = param_8;
        } else {
            phi_321_ = _e113;
        }
        let _e117 = phi_321_;
        phi_369_ = (param_8 - _e117);
    } else {
        if (_e90 == 1u) {
            let _e120 = (param_8 * 0.5f);
            if (_e120 > -8388608f) {
                let _e132 = f32(select(0i, select(select(i32(_e120), i32(-2147483648), (_e120 < bitcast<f32>(3472883712u))), 2147483647i, (_e120 > bitcast<f32>(1325400063u))), (_e120 == _e120)));
                if (_e132 > _e120) {
                    phi_347_ = 1f;
                } else {
                    phi_347_ = 0f;
                }
                let _e135 = phi_347_;
                if (_e120 < 8388608f) {
                    phi_352_ = (_e132 - _e135);
                    phi_353_ = false;
                } else {
                    phi_352_ = f32();
                    phi_353_ = true;
                }
                let _e138 = phi_352_;
                let _e140 = phi_353_;
                phi_354_ = _e138;
                phi_355_ = _e140;
            } else {
                phi_354_ = f32();
                phi_355_ = true;
            }
            let _e142 = phi_354_;
            let _e144 = phi_355_;
            if _e144 {
                phi_359_ = _e120;
            } else {
                phi_359_ = _e142;
            }
            let _e146 = phi_359_;
            let _e148 = (param_8 - (2f * _e146));
            if (_e148 > 1f) {
                phi_367_ = (2f - _e148);
            } else {
                phi_367_ = _e148;
            }
            let _e152 = phi_367_;
            phi_368_ = _e152;
        } else {
            phi_368_ = param_8;
        }
        let _e154 = phi_368_;
        phi_369_ = _e154;
    }
    let _e156 = phi_369_;
    if (_e156 > 0f) {
        if (_e156 < 1f) {
            phi_378_ = _e156;
        } else {
            phi_378_ = 1f;
        }
        let _e160 = phi_378_;
        phi_379_ = _e160;
    } else {
        phi_379_ = 0f;
    }
    let _e162 = phi_379_;
    let _e163 = (_e77 - 1u);
    let _e165 = (_e162 * f32(_e77));
    if _e85 {
        let _e172 = select(select(u32(_e165), 0u, (_e165 < bitcast<f32>(0u))), 4294967295u, (_e165 > bitcast<f32>(1333788671u)));
        if (_e163 < _e172) {
            phi_397_ = _e163;
        } else {
            phi_397_ = _e172;
        }
        let _e175 = phi_397_;
        phi_436_ = texture_Axis(_e175, _e175, 0f);
    } else {
        let _e177 = (_e165 + 0.5f);
        let _e184 = select(select(u32(_e177), 0u, (_e177 < bitcast<f32>(0u))), 4294967295u, (_e177 > bitcast<f32>(1333788671u)));
        if (_e77 < _e184) {
            phi_411_ = _e77;
        } else {
            phi_411_ = _e184;
        }
        let _e187 = phi_411_;
        if (_e90 == 0u) {
            phi_418_ = _e163;
        } else {
            phi_418_ = 0u;
        }
        let _e192 = phi_418_;
        if (_e90 == 0u) {
            phi_423_ = 0u;
        } else {
            phi_423_ = _e163;
        }
        let _e195 = phi_423_;
        if (_e187 == 0u) {
            phi_429_ = _e192;
        } else {
            phi_429_ = (_e187 - 1u);
        }
        let _e199 = phi_429_;
        if (_e187 > _e163) {
            phi_434_ = _e195;
        } else {
            phi_434_ = _e187;
        }
        let _e202 = phi_434_;
        phi_436_ = texture_Axis(_e199, _e202, (_e177 - f32(_e187)));
    }
    let _e205 = phi_436_;
    let _e207 = (*param_7).flags;
    let _e210 = ((_e207 >> bitcast<u32>(6u)) & 3u);
    if (_e210 == 0u) {
        if (param_9 > -8388608f) {
            let _e223 = f32(select(0i, select(select(i32(param_9), i32(-2147483648), (param_9 < bitcast<f32>(3472883712u))), 2147483647i, (param_9 > bitcast<f32>(1325400063u))), (param_9 == param_9)));
            if (_e223 > param_9) {
                phi_464_ = 1f;
            } else {
                phi_464_ = 0f;
            }
            let _e226 = phi_464_;
            if (param_9 < 8388608f) {
                phi_469_ = (_e223 - _e226);
                phi_470_ = false;
            } else {
                phi_469_ = f32();
                phi_470_ = true;
            }
            let _e229 = phi_469_;
            let _e231 = phi_470_;
            phi_471_ = _e229;
            phi_472_ = _e231;
        } else {
            phi_471_ = f32();
            phi_472_ = true;
        }
        let _e233 = phi_471_;
        let _e235 = phi_472_;
        if _e235 {
            phi_476_ = param_9;
        } else {
            phi_476_ = _e233;
        }
        let _e237 = phi_476_;
        phi_524_ = (param_9 - _e237);
    } else {
        if (_e210 == 1u) {
            let _e240 = (param_9 * 0.5f);
            if (_e240 > -8388608f) {
                let _e252 = f32(select(0i, select(select(i32(_e240), i32(-2147483648), (_e240 < bitcast<f32>(3472883712u))), 2147483647i, (_e240 > bitcast<f32>(1325400063u))), (_e240 == _e240)));
                if (_e252 > _e240) {
                    phi_502_ = 1f;
                } else {
                    phi_502_ = 0f;
                }
                let _e255 = phi_502_;
                if (_e240 < 8388608f) {
                    phi_507_ = (_e252 - _e255);
                    phi_508_ = false;
                } else {
                    phi_507_ = f32();
                    phi_508_ = true;
                }
                let _e258 = phi_507_;
                let _e260 = phi_508_;
                phi_509_ = _e258;
                phi_510_ = _e260;
            } else {
                phi_509_ = f32();
                phi_510_ = true;
            }
            let _e262 = phi_509_;
            let _e264 = phi_510_;
            if _e264 {
                phi_514_ = _e240;
            } else {
                phi_514_ = _e262;
            }
            let _e266 = phi_514_;
            let _e268 = (param_9 - (2f * _e266));
            if (_e268 > 1f) {
                phi_522_ = (2f - _e268);
            } else {
                phi_522_ = _e268;
            }
            let _e272 = phi_522_;
            phi_523_ = _e272;
        } else {
            phi_523_ = param_9;
        }
        let _e274 = phi_523_;
        phi_524_ = _e274;
    }
    let _e276 = phi_524_;
    if (_e276 > 0f) {
        if (_e276 < 1f) {
            phi_533_ = _e276;
        } else {
            phi_533_ = 1f;
        }
        let _e280 = phi_533_;
        phi_534_ = _e280;
    } else {
        phi_534_ = 0f;
    }
    let _e282 = phi_534_;
    let _e283 = (_e81 - 1u);
    let _e285 = (_e282 * f32(_e81));
    if _e85 {
        let _e292 = select(select(u32(_e285), 0u, (_e285 < bitcast<f32>(0u))), 4294967295u, (_e285 > bitcast<f32>(1333788671u)));
        if (_e283 < _e292) {
            phi_552_ = _e283;
        } else {
            phi_552_ = _e292;
        }
        let _e295 = phi_552_;
        phi_591_ = texture_Axis(_e295, _e295, 0f);
    } else {
        let _e297 = (_e285 + 0.5f);
        let _e304 = select(select(u32(_e297), 0u, (_e297 < bitcast<f32>(0u))), 4294967295u, (_e297 > bitcast<f32>(1333788671u)));
        if (_e81 < _e304) {
            phi_566_ = _e81;
        } else {
            phi_566_ = _e304;
        }
        let _e307 = phi_566_;
        if (_e210 == 0u) {
            phi_573_ = _e283;
        } else {
            phi_573_ = 0u;
        }
        let _e312 = phi_573_;
        if (_e210 == 0u) {
            phi_578_ = 0u;
        } else {
            phi_578_ = _e283;
        }
        let _e315 = phi_578_;
        if (_e307 == 0u) {
            phi_584_ = _e312;
        } else {
            phi_584_ = (_e307 - 1u);
        }
        let _e319 = phi_584_;
        if (_e307 > _e283) {
            phi_589_ = _e315;
        } else {
            phi_589_ = _e307;
        }
        let _e322 = phi_589_;
        phi_591_ = texture_Axis(_e319, _e322, (_e297 - f32(_e307)));
    }
    let _e325 = phi_591_;
    let _e329 = (*param_7).offset;
    let _e336 = (*param_7).offset;
    let _e343 = (*param_7).offset;
    let _e350 = (*param_7).offset;
    return texture_TexelQuad(array<u32, 4>(((_e329 + (_e325.low * _e77)) + _e205.low), ((_e336 + (_e325.low * _e77)) + _e205.high), ((_e343 + (_e325.high * _e77)) + _e205.low), ((_e350 + (_e325.high * _e77)) + _e205.high)), vec4<f32>(((1f - _e205.fraction) * (1f - _e325.fraction)), (_e205.fraction * (1f - _e325.fraction)), ((1f - _e205.fraction) * _e325.fraction), (_e205.fraction * _e325.fraction)));
}

fn _lt_bvh_ray_Ray_new(param_10: vec3<f32>, param_11: vec3<f32>) -> lt_bvh_Ray {
    return lt_bvh_Ray(param_10, 0f, param_11, 300000000000000000000000000000000000000f);
}

fn _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(param_12: f32, param_13: f32) -> f32 {
    var phi_650_: f32;

    if (param_12 > param_13) {
        phi_650_ = param_12;
    } else {
        phi_650_ = param_13;
    }
    let _e76 = phi_650_;
    return _e76;
}

fn _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(param_14: vec3<f32>) -> vec3<f32> {
    return vec3<f32>(1f, 1f, 1f);
}

fn _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(param_15: vec3<f32>) -> vec3<f32> {
    return param_15;
}

fn _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(param_16: vec3<f32>) -> vec3<f32> {
    return param_16;
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var phi_801_: bool;
    var phi_802_: bool;
    var phi_803_: bool;
    var phi_804_: bool;
    var phi_808_: bool;
    var phi_821_: bool;
    var phi_822_: bool;
    var phi_823_: bool;
    var phi_824_: bool;
    var phi_828_: bool;
    var phi_841_: bool;
    var phi_842_: bool;
    var phi_843_: bool;
    var phi_847_: bool;
    var phi_848_: bool;
    var phi_849_: bool;
    var phi_850_: bool;
    var phi_851_: bool;
    var phi_855_: bool;
    var phi_931_: f32;
    var phi_938_: f32;
    var phi_946_: f32;
    var phi_953_: f32;
    var phi_961_: f32;
    var phi_968_: f32;
    var phi_991_: f32;
    var phi_996_: f32;
    var phi_1001_: f32;
    var phi_1006_: f32;
    var phi_1011_: f32;
    var phi_1042_: bool;
    var phi_1043_: bool;
    var phi_1051_: u32;
    var phi_1052_: u32;
    var phi_1069_: vec3<f32>;
    var phi_1070_: vec3<f32>;
    var phi_1083_: u32;
    var phi_1088_: u32;
    var phi_1093_: u32;
    var phi_1207_: bool;
    var phi_1208_: bool;
    var phi_1239_: u32;
    var phi_1241_: lt_bvh_Hit;
    var phi_1244_: u32;
    var phi_1329_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1356_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1383_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1389_: u32;
    var phi_1392_: u32;
    var phi_1406_: u32;
    var phi_1416_: u32;
    var phi_1426_: u32;
    var phi_1444_: u32;
    var phi_1454_: u32;
    var phi_1464_: u32;
    var phi_1500_: u32;
    var phi_1513_: u32;
    var phi_1518_: u32;
    var phi_1519_: u32;
    var phi_1520_: u32;
    var phi_1390_: u32;
    var phi_1393_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_1578_: lt_bvh_Hit;
    var phi_1581_: u32;
    var phi_1627_: vec3<f32>;
    var phi_1628_: vec3<f32>;
    var phi_1659_: vec3<f32>;
    var phi_1660_: vec3<f32>;
    var phi_1691_: vec3<f32>;
    var phi_1692_: vec3<f32>;
    var phi_1710_: bool;
    var phi_1711_: bool;
    var phi_1715_: f32;
    var phi_1716_: f32;
    var phi_1717_: f32;
    var phi_1718_: f32;
    var phi_1726_: f32;
    var phi_1736_: bool;
    var phi_1737_: bool;
    var phi_1741_: f32;
    var phi_1742_: f32;
    var phi_1743_: f32;
    var phi_1744_: f32;
    var phi_1752_: f32;
    var phi_1762_: bool;
    var phi_1763_: bool;
    var phi_1767_: f32;
    var phi_1768_: f32;
    var phi_1769_: f32;
    var phi_1770_: f32;
    var phi_1778_: f32;
    var phi_1793_: f32;
    var phi_1794_: bool;
    var phi_1795_: f32;
    var phi_1796_: bool;
    var phi_1797_: f32;
    var phi_1798_: bool;
    var phi_1816_: f32;
    var phi_1817_: bool;
    var phi_1818_: bool;
    var phi_1819_: f32;
    var phi_1820_: bool;
    var phi_1821_: bool;
    var phi_1825_: bool;
    var phi_1826_: f32;
    var phi_1827_: bool;
    var phi_1857_: vec3<f32>;
    var phi_1858_: vec3<f32>;
    var phi_1883_: vec3<f32>;
    var phi_1884_: vec3<f32>;
    var phi_1909_: vec3<f32>;
    var phi_1910_: vec3<f32>;
    var phi_1968_: f32;
    var phi_1977_: f32;
    var phi_1986_: f32;
    var phi_1995_: f32;
    var phi_2002_: f32;
    var phi_2009_: f32;
    var phi_2022_: f32;
    var phi_2031_: f32;
    var phi_2040_: f32;
    var phi_2049_: f32;
    var phi_2056_: f32;
    var phi_2063_: f32;
    var phi_2086_: f32;
    var phi_2091_: f32;
    var phi_2096_: f32;
    var phi_2104_: f32;
    var phi_2109_: f32;
    var phi_2114_: f32;
    var phi_2126_: f32;
    var phi_2131_: f32;
    var phi_2136_: f32;
    var phi_2141_: f32;
    var phi_2146_: lt_bvh_triangle_Intersection;
    var phi_2147_: bool;
    var phi_2148_: lt_bvh_triangle_Intersection;
    var phi_2149_: bool;
    var phi_2153_: lt_bvh_triangle_Intersection;
    var phi_2154_: bool;
    var phi_2155_: lt_bvh_triangle_Intersection;
    var phi_2156_: bool;
    var phi_2157_: bool;
    var phi_2161_: bool;
    var phi_2165_: lt_bvh_triangle_Intersection;
    var phi_2204_: bool;
    var phi_2205_: bool;
    var phi_2206_: bool;
    var phi_2207_: bool;
    var phi_2208_: bool;
    var phi_2209_: bool;
    var phi_2213_: bool;
    var phi_2214_: bool;
    var phi_2417_: f32;
    var phi_2420_: bool;
    var phi_2421_: bool;
    var phi_2425_: bool;
    var phi_2433_: lt_bvh_Hit;
    var phi_2434_: lt_bvh_Hit;
    var phi_2435_: lt_bvh_Hit;
    var phi_2436_: lt_bvh_Hit;
    var phi_1579_: lt_bvh_Hit;
    var phi_1582_: u32;
    var phi_2437_: bool;
    var phi_2476_: bool;
    var phi_2477_: bool;
    var phi_2508_: u32;
    var phi_1242_: lt_bvh_Hit;
    var phi_1245_: u32;
    var phi_2509_: lt_bvh_Hit;
    var phi_2510_: lt_bvh_Hit;
    var phi_2511_: bool;
    var phi_2515_: lt_bvh_Hit;
    var phi_2580_: f32;
    var phi_2585_: f32;
    var phi_2590_: f32;
    var phi_2601_: f32;
    var phi_2606_: f32;
    var phi_2611_: f32;
    var phi_2687_: vec3<f32>;
    var phi_2808_: u32;
    var phi_2835_: f32;
    var phi_2842_: f32;
    var phi_2849_: f32;
    var phi_2884_: f32;
    var phi_2891_: f32;
    var phi_2898_: f32;
    var phi_2936_: f32;
    var phi_2943_: f32;
    var phi_2950_: f32;
    var phi_3009_: vec3<f32>;
    var phi_3010_: vec3<f32>;
    var phi_3011_: vec3<f32>;
    var phi_3020_: f32;
    var phi_3021_: f32;
    var phi_3031_: f32;
    var phi_3032_: f32;
    var phi_3042_: f32;
    var phi_3043_: f32;
    var phi_3078_: abi_Sample;
    var phi_3169_: vec3<f32>;
    var local_5: lt_bvh_Hit;
    var local_6: lt_bvh_Hit;

    let _e74 = id_1;
    let _e78 = arrayLength((&nodes.member));
    let _e81 = arrayLength((&triangles.member));
    let _e84 = arrayLength((&vertices.member));
    let _e87 = arrayLength((&materials.member));
    let _e93 = arrayLength((&alpha_texels.member));
    let _e96 = arrayLength((&before.member));
    let _e102 = p.member.size[0u];
    let _e104 = p.member.size[1u];
    let _e105 = lt_shaders_entry_pixel_index(_e74, _e102, _e104);
    if (bitcast<i32>(_e105.root) != 0i) {
        let _e113 = p.member.eye;
        let _e116 = p.member.grid[0u];
        let _e118 = p.member.grid[1u];
        let _e137 = p.member.size[0u];
        let _e141 = ((((f32(_e74.x) + ((f32((_e74.y & (_e118 - 1u))) + 0.5f) / f32(_e118))) / f32(_e137)) * 2f) - 1f);
        let _e144 = p.member.size[1u];
        let _e148 = (1f - (((f32(_e74.y) + ((f32((_e74.x & (_e116 - 1u))) + 0.5f) / f32(_e116))) / f32(_e144)) * 2f));
        let _e150 = p.member.forward;
        let _e152 = p.member.right;
        let _e166 = p.member.up;
        let _e177 = _lt_bvh_ray_Ray_new(_e113, vec3<f32>(((_e150.x + (_e152.x * _e141)) + (_e166.x * _e148)), ((_e150.y + (_e152.y * _e141)) + (_e166.y * _e148)), ((_e150.z + (_e152.z * _e141)) + (_e166.z * _e148))));
        let _e179 = lt_bvh_Hit(_e177.tmax, 0f, 0f, 4294967295u, 4294967295u);
        let _e182 = abs(_e177.direction.x);
        let _e184 = abs(_e177.direction.y);
        let _e186 = abs(_e177.direction.z);
        if (abs(_e177.origin.x) < 1000000000000000f) {
            if (abs(_e177.origin.y) < 1000000000000000f) {
                phi_801_ = (abs(_e177.origin.z) < 1000000000000000f);
                phi_802_ = false;
            } else {
                phi_801_ = bool();
                phi_802_ = true;
            }
            let _e198 = phi_801_;
            let _e200 = phi_802_;
            phi_803_ = _e198;
            phi_804_ = _e200;
        } else {
            phi_803_ = bool();
            phi_804_ = true;
        }
        let _e202 = phi_803_;
        let _e204 = phi_804_;
        if _e204 {
            phi_808_ = false;
        } else {
            phi_808_ = _e202;
        }
        let _e206 = phi_808_;
        if _e206 {
            if (_e182 < 1000000000000000f) {
                if (_e184 < 1000000000000000f) {
                    phi_821_ = (_e186 < 1000000000000000f);
                    phi_822_ = false;
                } else {
                    phi_821_ = bool();
                    phi_822_ = true;
                }
                let _e211 = phi_821_;
                let _e213 = phi_822_;
                phi_823_ = _e211;
                phi_824_ = _e213;
            } else {
                phi_823_ = bool();
                phi_824_ = true;
            }
            let _e215 = phi_823_;
            let _e217 = phi_824_;
            if _e217 {
                phi_828_ = false;
            } else {
                phi_828_ = _e215;
            }
            let _e219 = phi_828_;
            if _e219 {
                if (_e182 > 0f) {
                    phi_842_ = bool();
                    phi_843_ = true;
                } else {
                    let _e221 = (_e184 > 0f);
                    if _e221 {
                        phi_841_ = bool();
                    } else {
                        phi_841_ = (_e186 > 0f);
                    }
                    let _e224 = phi_841_;
                    phi_842_ = _e224;
                    phi_843_ = _e221;
                }
                let _e226 = phi_842_;
                let _e228 = phi_843_;
                if _e228 {
                    phi_847_ = true;
                } else {
                    phi_847_ = _e226;
                }
                let _e230 = phi_847_;
                phi_848_ = _e230;
                phi_849_ = false;
            } else {
                phi_848_ = bool();
                phi_849_ = true;
            }
            let _e232 = phi_848_;
            let _e234 = phi_849_;
            phi_850_ = _e232;
            phi_851_ = _e234;
        } else {
            phi_850_ = bool();
            phi_851_ = true;
        }
        let _e236 = phi_850_;
        let _e238 = phi_851_;
        if _e238 {
            phi_855_ = false;
        } else {
            phi_855_ = _e236;
        }
        let _e240 = phi_855_;
        if _e240 {
            let _e241 = (0u >= _e78);
            if _e241 {
                phi_2509_ = lt_bvh_Hit();
            } else {
                if (0u < _e78) {
                } else {
                    return;
                }
                let _e247 = nodes.member[(0u + 0u)].frame[0u];
                let _e251 = nodes.member[(0u + 0u)].frame[1u];
                let _e255 = nodes.member[(0u + 0u)].frame[2u];
                let _e259 = nodes.member[(0u + 0u)].frame[0u];
                let _e263 = nodes.member[(0u + 0u)].frame[1u];
                let _e267 = nodes.member[(0u + 0u)].frame[2u];
                let _e271 = nodes.member[(0u + 0u)].frame[3u];
                let _e310 = core_intrinsics_maximum_number_nsz_f32_(abs(_e177.direction.x), abs(_e177.direction.y));
                let _e311 = core_intrinsics_maximum_number_nsz_f32_(_e310, abs(_e177.direction.z));
                let _e312 = (_e311 * 0.0000000000009094947f);
                if (abs(_e177.direction.x) < _e312) {
                    phi_931_ = _e312;
                } else {
                    phi_931_ = abs(_e177.direction.x);
                }
                let _e318 = phi_931_;
                if (_e177.direction.x < 0f) {
                    phi_938_ = (-1f / _e318);
                } else {
                    phi_938_ = (1f / _e318);
                }
                let _e323 = phi_938_;
                if (abs(_e177.direction.y) < _e312) {
                    phi_946_ = _e312;
                } else {
                    phi_946_ = abs(_e177.direction.y);
                }
                let _e329 = phi_946_;
                if (_e177.direction.y < 0f) {
                    phi_953_ = (-1f / _e329);
                } else {
                    phi_953_ = (1f / _e329);
                }
                let _e334 = phi_953_;
                if (abs(_e177.direction.z) < _e312) {
                    phi_961_ = _e312;
                } else {
                    phi_961_ = abs(_e177.direction.z);
                }
                let _e340 = phi_961_;
                if (_e177.direction.z < 0f) {
                    phi_968_ = (-1f / _e340);
                } else {
                    phi_968_ = (1f / _e340);
                }
                let _e345 = phi_968_;
                let _e352 = abs((bitcast<f32>(_e247) - _e177.origin.x));
                let _e353 = abs((bitcast<f32>(_e251) - _e177.origin.y));
                let _e354 = abs((bitcast<f32>(_e255) - _e177.origin.z));
                let _e361 = abs(((bitcast<f32>(_e259) + (bitcast<f32>((((_e271 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e177.origin.x));
                let _e362 = abs(((bitcast<f32>(_e263) + (bitcast<f32>((((_e271 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e177.origin.y));
                let _e363 = abs(((bitcast<f32>(_e267) + (bitcast<f32>((((_e271 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e177.origin.z));
                if (_e352 > _e361) {
                    phi_991_ = _e352;
                } else {
                    phi_991_ = _e361;
                }
                let _e366 = phi_991_;
                if (_e353 > _e362) {
                    phi_996_ = _e353;
                } else {
                    phi_996_ = _e362;
                }
                let _e369 = phi_996_;
                if (_e354 > _e363) {
                    phi_1001_ = _e354;
                } else {
                    phi_1001_ = _e363;
                }
                let _e372 = phi_1001_;
                if (_e366 > _e369) {
                    phi_1006_ = _e366;
                } else {
                    phi_1006_ = _e369;
                }
                let _e375 = phi_1006_;
                if (_e375 > _e372) {
                    phi_1011_ = _e375;
                } else {
                    phi_1011_ = _e372;
                }
                let _e378 = phi_1011_;
                let _e382 = (_e378 * 0.0000019073486f);
                let _e383 = (abs(_e323) * _e382);
                let _e384 = (abs(_e334) * _e382);
                let _e385 = (abs(_e345) * _e382);
                let _e389 = (_e378 * 0.0000009536743f);
                let _e390 = (abs(_e323) * _e389);
                let _e391 = (abs(_e334) * _e389);
                let _e392 = (abs(_e345) * _e389);
                let _e396 = abs(_e177.direction.x);
                let _e398 = abs(_e177.direction.y);
                let _e400 = abs(_e177.direction.z);
                if (_e396 >= _e398) {
                    if (_e396 >= _e400) {
                        phi_1042_ = false;
                    } else {
                        phi_1042_ = true;
                    }
                    let _e404 = phi_1042_;
                    phi_1043_ = _e404;
                } else {
                    phi_1043_ = true;
                }
                let _e406 = phi_1043_;
                if _e406 {
                    if (_e398 >= _e400) {
                        phi_1051_ = 1u;
                    } else {
                        phi_1051_ = 2u;
                    }
                    let _e409 = phi_1051_;
                    phi_1052_ = _e409;
                } else {
                    phi_1052_ = 0u;
                }
                let _e411 = phi_1052_;
                if (_e411 == 0u) {
                    phi_1070_ = vec3<f32>(_e177.direction.y, _e177.direction.z, _e177.direction.x);
                } else {
                    if (_e411 == 1u) {
                        phi_1069_ = vec3<f32>(_e177.direction.z, _e177.direction.x, _e177.direction.y);
                    } else {
                        phi_1069_ = _e177.direction;
                    }
                    let _e423 = phi_1069_;
                    phi_1070_ = _e423;
                }
                let _e425 = phi_1070_;
                let _e428 = (_e425.x / _e425.z);
                let _e431 = (_e425.y / _e425.z);
                if (_e323 < 0f) {
                    phi_1083_ = 0u;
                } else {
                    phi_1083_ = 1u;
                }
                let _e436 = phi_1083_;
                if (_e334 < 0f) {
                    phi_1088_ = 0u;
                } else {
                    phi_1088_ = 2u;
                }
                let _e439 = phi_1088_;
                if (_e345 < 0f) {
                    phi_1093_ = 0u;
                } else {
                    phi_1093_ = 4u;
                }
                let _e442 = phi_1093_;
                let _e444 = ((_e436 | _e439) | _e442);
                let _e445 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e445.first[0], _e445.first[1], _e445.first[2], _e445.first[3], _e445.first[4], _e445.first[5], _e445.first[6], _e445.first[7], _e445.first[8], _e445.first[9], _e445.first[10], _e445.first[11], _e445.first[12], _e445.first[13], _e445.first[14], _e445.first[15], _e445.first[16], _e445.first[17], _e445.first[18], _e445.first[19], _e445.first[20], _e445.first[21], _e445.first[22], _e445.first[23], _e445.first[24], _e445.first[25], _e445.first[26], _e445.first[27], _e445.first[28], _e445.first[29], _e445.first[30], _e445.first[31]), array<u32, 32>(_e445.mask[0], _e445.mask[1], _e445.mask[2], _e445.mask[3], _e445.mask[4], _e445.mask[5], _e445.mask[6], _e445.mask[7], _e445.mask[8], _e445.mask[9], _e445.mask[10], _e445.mask[11], _e445.mask[12], _e445.mask[13], _e445.mask[14], _e445.mask[15], _e445.mask[16], _e445.mask[17], _e445.mask[18], _e445.mask[19], _e445.mask[20], _e445.mask[21], _e445.mask[22], _e445.mask[23], _e445.mask[24], _e445.mask[25], _e445.mask[26], _e445.mask[27], _e445.mask[28], _e445.mask[29], _e445.mask[30], _e445.mask[31]), _e445.len, _e445.group, _e445.group_mask);
                let _e519 = local_1.group_mask;
                if ((_e519 & 4278190080u) == 0u) {
                    let _e523 = local_1.len;
                    if (_e523 == 0u) {
                        phi_1207_ = false;
                    } else {
                        let _e527 = local_1.len;
                        local_1.len = (_e527 - 1u);
                        let _e530 = local_1.len;
                        if (_e530 < 32u) {
                        } else {
                            return;
                        }
                        let _e535 = local_1.first[(0u + _e530)];
                        local_1.group = _e535;
                        let _e538 = local_1.len;
                        if (_e538 < 32u) {
                        } else {
                            return;
                        }
                        let _e543 = local_1.mask[(0u + _e538)];
                        local_1.group_mask = _e543;
                        phi_1207_ = true;
                    }
                    let _e546 = phi_1207_;
                    phi_1208_ = _e546;
                } else {
                    phi_1208_ = true;
                }
                let _e548 = phi_1208_;
                if _e548 {
                    let _e550 = local_1.group_mask;
                    let _e556 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e550)), 32u, (_e550 == 0u)));
                    let _e560 = local_1.group_mask;
                    let _e574 = local_1.group_mask;
                    local_1.group_mask = (_e574 & ~((1u << bitcast<u32>((_e556 & 31u)))));
                    let _e577 = local_1.group;
                    phi_1239_ = (_e577 + countOneBits(((_e560 & ~((4294967295u << bitcast<u32>((((_e556 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1239_ = 4294967295u;
                }
                let _e580 = phi_1239_;
                phi_1241_ = _e179;
                phi_1244_ = _e580;
                loop {
                    let _e582 = phi_1241_;
                    let _e584 = phi_1244_;
                    local_6 = _e582;
                    let _e585 = (_e584 != 4294967295u);
                    if _e585 {
                        if (_e584 < _e78) {
                        } else {
                            return;
                        }
                        let _e593 = nodes.member[(0u + _e584)].frame[3u];
                        let _e618 = (bitcast<f32>((((_e593 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e323);
                        let _e619 = (bitcast<f32>((((_e593 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e334);
                        let _e620 = (bitcast<f32>((((_e593 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e345);
                        let _e623 = nodes.member[(0u + _e584)].frame[0u];
                        let _e627 = nodes.member[(0u + _e584)].frame[1u];
                        let _e631 = nodes.member[(0u + _e584)].frame[2u];
                        let _e639 = ((bitcast<f32>(_e623) - _e177.origin.x) * _e323);
                        let _e640 = ((bitcast<f32>(_e627) - _e177.origin.y) * _e334);
                        let _e641 = ((bitcast<f32>(_e631) - _e177.origin.z) * _e345);
                        let _e649 = nodes.member[(0u + _e584)].x;
                        if (_e323 < 0f) {
                            let _e660 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e649.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e666 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e660.unnamed.root, _e649.w), _e660.unnamed_1);
                            let _e672 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e666.unnamed, lt_bvh_traverse_Tree(_e649.x, _e666.unnamed_1.first_primitive));
                            phi_1329_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e672.unnamed, lt_bvh_traverse_Tree(_e672.unnamed_1.root, _e649.y));
                        } else {
                            let _e688 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e649.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e694 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e688.unnamed.root, _e649.y), _e688.unnamed_1);
                            let _e700 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e694.unnamed, lt_bvh_traverse_Tree(_e649.z, _e694.unnamed_1.first_primitive));
                            phi_1329_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e700.unnamed, lt_bvh_traverse_Tree(_e700.unnamed_1.root, _e649.w));
                        }
                        let _e708 = phi_1329_;
                        let _e718 = nodes.member[(0u + _e584)].y;
                        if (_e334 < 0f) {
                            let _e729 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e718.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e735 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e729.unnamed.root, _e718.w), _e729.unnamed_1);
                            let _e741 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e735.unnamed, lt_bvh_traverse_Tree(_e718.x, _e735.unnamed_1.first_primitive));
                            phi_1356_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e741.unnamed, lt_bvh_traverse_Tree(_e741.unnamed_1.root, _e718.y));
                        } else {
                            let _e757 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e718.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e763 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e757.unnamed.root, _e718.y), _e757.unnamed_1);
                            let _e769 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e763.unnamed, lt_bvh_traverse_Tree(_e718.z, _e763.unnamed_1.first_primitive));
                            phi_1356_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e769.unnamed, lt_bvh_traverse_Tree(_e769.unnamed_1.root, _e718.w));
                        }
                        let _e777 = phi_1356_;
                        let _e787 = nodes.member[(0u + _e584)].z;
                        if (_e345 < 0f) {
                            let _e798 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e787.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e804 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e798.unnamed.root, _e787.w), _e798.unnamed_1);
                            let _e810 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e804.unnamed, lt_bvh_traverse_Tree(_e787.x, _e804.unnamed_1.first_primitive));
                            phi_1383_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e810.unnamed, lt_bvh_traverse_Tree(_e810.unnamed_1.root, _e787.y));
                        } else {
                            let _e826 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e787.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e832 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e826.unnamed.root, _e787.y), _e826.unnamed_1);
                            let _e838 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e832.unnamed, lt_bvh_traverse_Tree(_e787.z, _e832.unnamed_1.first_primitive));
                            phi_1383_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e838.unnamed, lt_bvh_traverse_Tree(_e838.unnamed_1.root, _e787.w));
                        }
                        let _e846 = phi_1383_;
                        phi_1389_ = 0u;
                        phi_1392_ = 0u;
                        loop {
                            let _e856 = phi_1389_;
                            let _e858 = phi_1392_;
                            local_2 = _e858;
                            local_3 = _e858;
                            local_4 = _e858;
                            let _e859 = (_e856 < 8u);
                            if _e859 {
                                let _e861 = (_e856 >> bitcast<u32>(2i));
                                let _e862 = (_e856 & 3u);
                                if (_e861 == 0u) {
                                    phi_1406_ = _e708.unnamed.root;
                                } else {
                                    phi_1406_ = _e708.unnamed.first_primitive;
                                }
                                let _e865 = phi_1406_;
                                if (_e861 == 0u) {
                                    phi_1416_ = _e777.unnamed.root;
                                } else {
                                    phi_1416_ = _e777.unnamed.first_primitive;
                                }
                                let _e874 = phi_1416_;
                                if (_e861 == 0u) {
                                    phi_1426_ = _e846.unnamed.root;
                                } else {
                                    phi_1426_ = _e846.unnamed.first_primitive;
                                }
                                let _e883 = phi_1426_;
                                let _e896 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e865 >> bitcast<u32>(((_e862 * 8u) & 31u))) & 255u)) * _e618) + (_e639 - _e383)), ((f32(((_e874 >> bitcast<u32>(((_e862 * 8u) & 31u))) & 255u)) * _e619) + (_e640 - _e384)));
                                let _e897 = core_intrinsics_maximum_number_nsz_f32_(_e896, ((f32(((_e883 >> bitcast<u32>(((_e862 * 8u) & 31u))) & 255u)) * _e620) + (_e641 - _e385)));
                                if (_e861 == 0u) {
                                    phi_1444_ = _e708.unnamed_1.root;
                                } else {
                                    phi_1444_ = _e708.unnamed_1.first_primitive;
                                }
                                let _e900 = phi_1444_;
                                if (_e861 == 0u) {
                                    phi_1454_ = _e777.unnamed_1.root;
                                } else {
                                    phi_1454_ = _e777.unnamed_1.first_primitive;
                                }
                                let _e909 = phi_1454_;
                                if (_e861 == 0u) {
                                    phi_1464_ = _e846.unnamed_1.root;
                                } else {
                                    phi_1464_ = _e846.unnamed_1.first_primitive;
                                }
                                let _e918 = phi_1464_;
                                let _e931 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e900 >> bitcast<u32>(((_e862 * 8u) & 31u))) & 255u)) * _e618) + (_e639 + _e383)), ((f32(((_e909 >> bitcast<u32>(((_e862 * 8u) & 31u))) & 255u)) * _e619) + (_e640 + _e384)));
                                let _e932 = core_intrinsics_minimum_number_nsz_f32_(_e931, ((f32(((_e918 >> bitcast<u32>(((_e862 * 8u) & 31u))) & 255u)) * _e620) + (_e641 + _e385)));
                                if (_e897 <= _e932) {
                                    if (_e897 <= _e582.t) {
                                        if (_e932 >= _e177.tmin) {
                                            if (_e861 == 0u) {
                                                let _e939 = nodes.member[(0u + _e584)].links[2u];
                                                phi_1500_ = _e939;
                                            } else {
                                                let _e942 = nodes.member[(0u + _e584)].links[3u];
                                                phi_1500_ = _e942;
                                            }
                                            let _e944 = phi_1500_;
                                            let _e949 = ((_e944 >> bitcast<u32>(((_e862 * 8u) & 31u))) & 255u);
                                            let _e950 = (_e949 & 31u);
                                            if (_e950 >= 24u) {
                                                phi_1513_ = (24u + ((_e950 - 24u) ^ _e444));
                                            } else {
                                                phi_1513_ = _e950;
                                            }
                                            let _e956 = phi_1513_;
                                            phi_1518_ = (_e858 | ((_e949 >> bitcast<u32>(5i)) << bitcast<u32>((_e956 & 31u))));
                                        } else {
                                            phi_1518_ = _e858;
                                        }
                                        let _e964 = phi_1518_;
                                        phi_1519_ = _e964;
                                    } else {
                                        phi_1519_ = _e858;
                                    }
                                    let _e966 = phi_1519_;
                                    phi_1520_ = _e966;
                                } else {
                                    phi_1520_ = _e858;
                                }
                                let _e968 = phi_1520_;
                                phi_1390_ = (_e856 + 1u);
                                phi_1393_ = _e968;
                            } else {
                                phi_1390_ = u32();
                                phi_1393_ = u32();
                            }
                            let _e971 = phi_1390_;
                            let _e973 = phi_1393_;
                            continue;
                            continuing {
                                phi_1389_ = _e971;
                                phi_1392_ = _e973;
                                break if !(_e859);
                            }
                        }
                        let _e977 = nodes.member[(0u + _e584)].links[0u];
                        let _e981 = nodes.member[(0u + _e584)].frame[3u];
                        let _e985 = local_2;
                        if ((_e985 & 4278190080u) == 0u) {
                        } else {
                            let _e989 = local_1.group_mask;
                            if ((_e989 & 4278190080u) == 0u) {
                            } else {
                                let _e993 = local_1.len;
                                if (_e993 < 32u) {
                                    let _e996 = local_1.group;
                                    let _e998 = local_1.len;
                                    if (_e998 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.first[(0u + _e998)] = _e996;
                                    let _e1004 = local_1.group_mask;
                                    let _e1006 = local_1.len;
                                    if (_e1006 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.mask[(0u + _e1006)] = _e1004;
                                    let _e1013 = local_1.len;
                                    local_1.len = (_e1013 + 1u);
                                }
                            }
                            local_1.group = (0u + _e977);
                            let _e1017 = local_3;
                            local_1.group_mask = ((_e1017 & 4278190080u) | (_e981 >> bitcast<u32>(24i)));
                        }
                        let _e1022 = local_4;
                        phi_1578_ = _e582;
                        phi_1581_ = (_e1022 & 16777215u);
                        loop {
                            let _e1025 = phi_1578_;
                            let _e1027 = phi_1581_;
                            local_5 = _e1025;
                            if (_e1027 == 0u) {
                                phi_1579_ = lt_bvh_Hit();
                                phi_1582_ = u32();
                                phi_2437_ = false;
                            } else {
                                let _e1031 = nodes.member[(0u + _e584)].links[1u];
                                let _e1036 = ((0u + _e1031) + select(firstTrailingBit(_e1027), 32u, (_e1027 == 0u)));
                                if (_e1036 < _e81) {
                                } else {
                                    return;
                                }
                                let _e1043 = triangles.member[(0u + _e1036)].v0_;
                                let _e1046 = (_e1043.x - _e177.origin.x);
                                let _e1049 = (_e1043.y - _e177.origin.y);
                                let _e1052 = (_e1043.z - _e177.origin.z);
                                if (_e411 == 0u) {
                                    phi_1628_ = vec3<f32>(_e1049, _e1052, _e1046);
                                } else {
                                    if (_e411 == 1u) {
                                        phi_1627_ = vec3<f32>(_e1052, _e1046, _e1049);
                                    } else {
                                        phi_1627_ = (_e1043 - _e177.origin);
                                    }
                                    let _e1059 = phi_1627_;
                                    phi_1628_ = _e1059;
                                }
                                let _e1061 = phi_1628_;
                                let _e1065 = (_e1061.x - (_e428 * _e1061.z));
                                let _e1069 = (_e1061.y - (_e431 * _e1061.z));
                                let _e1071 = triangles.member[(0u + _e1036)].v1_;
                                let _e1074 = (_e1071.x - _e177.origin.x);
                                let _e1077 = (_e1071.y - _e177.origin.y);
                                let _e1080 = (_e1071.z - _e177.origin.z);
                                if (_e411 == 0u) {
                                    phi_1660_ = vec3<f32>(_e1077, _e1080, _e1074);
                                } else {
                                    if (_e411 == 1u) {
                                        phi_1659_ = vec3<f32>(_e1080, _e1074, _e1077);
                                    } else {
                                        phi_1659_ = (_e1071 - _e177.origin);
                                    }
                                    let _e1087 = phi_1659_;
                                    phi_1660_ = _e1087;
                                }
                                let _e1089 = phi_1660_;
                                let _e1093 = (_e1089.x - (_e428 * _e1089.z));
                                let _e1097 = (_e1089.y - (_e431 * _e1089.z));
                                let _e1099 = triangles.member[(0u + _e1036)].v2_;
                                let _e1102 = (_e1099.x - _e177.origin.x);
                                let _e1105 = (_e1099.y - _e177.origin.y);
                                let _e1108 = (_e1099.z - _e177.origin.z);
                                if (_e411 == 0u) {
                                    phi_1692_ = vec3<f32>(_e1105, _e1108, _e1102);
                                } else {
                                    if (_e411 == 1u) {
                                        phi_1691_ = vec3<f32>(_e1108, _e1102, _e1105);
                                    } else {
                                        phi_1691_ = (_e1099 - _e177.origin);
                                    }
                                    let _e1115 = phi_1691_;
                                    phi_1692_ = _e1115;
                                }
                                let _e1117 = phi_1692_;
                                let _e1121 = (_e1117.x - (_e428 * _e1117.z));
                                let _e1125 = (_e1117.y - (_e431 * _e1117.z));
                                if (_e1093 < _e1121) {
                                    phi_1711_ = true;
                                } else {
                                    if (_e1093 == _e1121) {
                                        phi_1710_ = (_e1097 < _e1125);
                                    } else {
                                        phi_1710_ = false;
                                    }
                                    let _e1130 = phi_1710_;
                                    phi_1711_ = _e1130;
                                }
                                let _e1132 = phi_1711_;
                                if _e1132 {
                                    phi_1715_ = _e1125;
                                    phi_1716_ = _e1121;
                                    phi_1717_ = _e1097;
                                    phi_1718_ = _e1093;
                                } else {
                                    phi_1715_ = _e1097;
                                    phi_1716_ = _e1093;
                                    phi_1717_ = _e1125;
                                    phi_1718_ = _e1121;
                                }
                                let _e1134 = phi_1715_;
                                let _e1136 = phi_1716_;
                                let _e1138 = phi_1717_;
                                let _e1140 = phi_1718_;
                                let _e1143 = ((_e1140 * _e1134) - (_e1138 * _e1136));
                                if _e1132 {
                                    phi_1726_ = -(_e1143);
                                } else {
                                    phi_1726_ = _e1143;
                                }
                                let _e1146 = phi_1726_;
                                if (_e1121 < _e1065) {
                                    phi_1737_ = true;
                                } else {
                                    if (_e1121 == _e1065) {
                                        phi_1736_ = (_e1125 < _e1069);
                                    } else {
                                        phi_1736_ = false;
                                    }
                                    let _e1151 = phi_1736_;
                                    phi_1737_ = _e1151;
                                }
                                let _e1153 = phi_1737_;
                                if _e1153 {
                                    phi_1741_ = _e1069;
                                    phi_1742_ = _e1065;
                                    phi_1743_ = _e1125;
                                    phi_1744_ = _e1121;
                                } else {
                                    phi_1741_ = _e1125;
                                    phi_1742_ = _e1121;
                                    phi_1743_ = _e1069;
                                    phi_1744_ = _e1065;
                                }
                                let _e1155 = phi_1741_;
                                let _e1157 = phi_1742_;
                                let _e1159 = phi_1743_;
                                let _e1161 = phi_1744_;
                                let _e1164 = ((_e1161 * _e1155) - (_e1159 * _e1157));
                                if _e1153 {
                                    phi_1752_ = -(_e1164);
                                } else {
                                    phi_1752_ = _e1164;
                                }
                                let _e1167 = phi_1752_;
                                if (_e1065 < _e1093) {
                                    phi_1763_ = true;
                                } else {
                                    if (_e1065 == _e1093) {
                                        phi_1762_ = (_e1069 < _e1097);
                                    } else {
                                        phi_1762_ = false;
                                    }
                                    let _e1172 = phi_1762_;
                                    phi_1763_ = _e1172;
                                }
                                let _e1174 = phi_1763_;
                                if _e1174 {
                                    phi_1767_ = _e1097;
                                    phi_1768_ = _e1093;
                                    phi_1769_ = _e1069;
                                    phi_1770_ = _e1065;
                                } else {
                                    phi_1767_ = _e1069;
                                    phi_1768_ = _e1065;
                                    phi_1769_ = _e1097;
                                    phi_1770_ = _e1093;
                                }
                                let _e1176 = phi_1767_;
                                let _e1178 = phi_1768_;
                                let _e1180 = phi_1769_;
                                let _e1182 = phi_1770_;
                                let _e1185 = ((_e1182 * _e1176) - (_e1180 * _e1178));
                                if _e1174 {
                                    phi_1778_ = -(_e1185);
                                } else {
                                    phi_1778_ = _e1185;
                                }
                                let _e1188 = phi_1778_;
                                if (_e1146 >= 0f) {
                                    if (_e1167 >= 0f) {
                                        if (_e1188 >= 0f) {
                                            phi_1793_ = ((_e1146 + _e1167) + _e1188);
                                            phi_1794_ = false;
                                        } else {
                                            phi_1793_ = f32();
                                            phi_1794_ = true;
                                        }
                                        let _e1195 = phi_1793_;
                                        let _e1197 = phi_1794_;
                                        phi_1795_ = _e1195;
                                        phi_1796_ = _e1197;
                                    } else {
                                        phi_1795_ = f32();
                                        phi_1796_ = true;
                                    }
                                    let _e1199 = phi_1795_;
                                    let _e1201 = phi_1796_;
                                    phi_1797_ = _e1199;
                                    phi_1798_ = _e1201;
                                } else {
                                    phi_1797_ = f32();
                                    phi_1798_ = true;
                                }
                                let _e1203 = phi_1797_;
                                let _e1205 = phi_1798_;
                                if _e1205 {
                                    if (_e1146 <= 0f) {
                                        if (_e1167 <= 0f) {
                                            let _e1208 = (_e1188 <= 0f);
                                            if _e1208 {
                                            }
                                            phi_1816_ = ((_e1146 + _e1167) + _e1188);
                                            phi_1817_ = false;
                                            phi_1818_ = _e1208;
                                        } else {
                                            phi_1816_ = f32();
                                            phi_1817_ = true;
                                            phi_1818_ = false;
                                        }
                                        let _e1212 = phi_1816_;
                                        let _e1214 = phi_1817_;
                                        let _e1216 = phi_1818_;
                                        phi_1819_ = _e1212;
                                        phi_1820_ = _e1214;
                                        phi_1821_ = _e1216;
                                    } else {
                                        phi_1819_ = f32();
                                        phi_1820_ = true;
                                        phi_1821_ = false;
                                    }
                                    let _e1218 = phi_1819_;
                                    let _e1220 = phi_1820_;
                                    let _e1222 = phi_1821_;
                                    if _e1220 {
                                        phi_1825_ = false;
                                    } else {
                                        phi_1825_ = _e1222;
                                    }
                                    let _e1224 = phi_1825_;
                                    phi_1826_ = _e1218;
                                    phi_1827_ = _e1224;
                                } else {
                                    phi_1826_ = _e1203;
                                    phi_1827_ = true;
                                }
                                let _e1226 = phi_1826_;
                                let _e1228 = phi_1827_;
                                if _e1228 {
                                    let _e1229 = (_e1226 == 0f);
                                    if _e1229 {
                                        phi_2153_ = lt_bvh_triangle_Intersection();
                                        phi_2154_ = false;
                                    } else {
                                        let _e1231 = triangles.member[(0u + _e1036)].v0_;
                                        let _e1234 = (_e1231.x - _e177.origin.x);
                                        let _e1237 = (_e1231.y - _e177.origin.y);
                                        let _e1240 = (_e1231.z - _e177.origin.z);
                                        if (_e411 == 0u) {
                                            phi_1858_ = vec3<f32>(_e1237, _e1240, _e1234);
                                        } else {
                                            if (_e411 == 1u) {
                                                phi_1857_ = vec3<f32>(_e1240, _e1234, _e1237);
                                            } else {
                                                phi_1857_ = (_e1231 - _e177.origin);
                                            }
                                            let _e1247 = phi_1857_;
                                            phi_1858_ = _e1247;
                                        }
                                        let _e1249 = phi_1858_;
                                        let _e1251 = triangles.member[(0u + _e1036)].v1_;
                                        let _e1253 = triangles.member[(0u + _e1036)].v0_;
                                        let _e1256 = (_e1251.x - _e1253.x);
                                        let _e1259 = (_e1251.y - _e1253.y);
                                        let _e1262 = (_e1251.z - _e1253.z);
                                        if (_e411 == 0u) {
                                            phi_1884_ = vec3<f32>(_e1259, _e1262, _e1256);
                                        } else {
                                            if (_e411 == 1u) {
                                                phi_1883_ = vec3<f32>(_e1262, _e1256, _e1259);
                                            } else {
                                                phi_1883_ = (_e1251 - _e1253);
                                            }
                                            let _e1269 = phi_1883_;
                                            phi_1884_ = _e1269;
                                        }
                                        let _e1271 = phi_1884_;
                                        let _e1273 = triangles.member[(0u + _e1036)].v2_;
                                        let _e1275 = triangles.member[(0u + _e1036)].v0_;
                                        let _e1278 = (_e1273.x - _e1275.x);
                                        let _e1281 = (_e1273.y - _e1275.y);
                                        let _e1284 = (_e1273.z - _e1275.z);
                                        if (_e411 == 0u) {
                                            phi_1910_ = vec3<f32>(_e1281, _e1284, _e1278);
                                        } else {
                                            if (_e411 == 1u) {
                                                phi_1909_ = vec3<f32>(_e1284, _e1278, _e1281);
                                            } else {
                                                phi_1909_ = (_e1273 - _e1275);
                                            }
                                            let _e1291 = phi_1909_;
                                            phi_1910_ = _e1291;
                                        }
                                        let _e1293 = phi_1910_;
                                        let _e1300 = ((_e1271.y * _e1293.z) - (_e1271.z * _e1293.y));
                                        let _e1307 = ((_e1271.z * _e1293.x) - (_e1271.x * _e1293.z));
                                        let _e1314 = ((_e1271.x * _e1293.y) - (_e1271.y * _e1293.x));
                                        let _e1328 = (((1f / _e425.z) * (((_e1300 * _e1249.x) + (_e1307 * _e1249.y)) + (_e1314 * _e1249.z))) / (((_e1300 * _e428) + (_e1307 * _e431)) + _e1314));
                                        if (_e1328 > _e177.tmin) {
                                            if (_e1328 < _e177.tmax) {
                                                let _e1334 = triangles.member[(0u + _e1036)].v0_;
                                                let _e1336 = triangles.member[(0u + _e1036)].v1_;
                                                if (_e1334.x < _e1336.x) {
                                                    phi_1968_ = _e1334.x;
                                                } else {
                                                    phi_1968_ = _e1336.x;
                                                }
                                                let _e1343 = phi_1968_;
                                                if (_e1334.y < _e1336.y) {
                                                    phi_1977_ = _e1334.y;
                                                } else {
                                                    phi_1977_ = _e1336.y;
                                                }
                                                let _e1350 = phi_1977_;
                                                if (_e1334.z < _e1336.z) {
                                                    phi_1986_ = _e1334.z;
                                                } else {
                                                    phi_1986_ = _e1336.z;
                                                }
                                                let _e1357 = phi_1986_;
                                                let _e1359 = triangles.member[(0u + _e1036)].v2_;
                                                if (_e1343 < _e1359.x) {
                                                    phi_1995_ = _e1343;
                                                } else {
                                                    phi_1995_ = _e1359.x;
                                                }
                                                let _e1364 = phi_1995_;
                                                if (_e1350 < _e1359.y) {
                                                    phi_2002_ = _e1350;
                                                } else {
                                                    phi_2002_ = _e1359.y;
                                                }
                                                let _e1369 = phi_2002_;
                                                if (_e1357 < _e1359.z) {
                                                    phi_2009_ = _e1357;
                                                } else {
                                                    phi_2009_ = _e1359.z;
                                                }
                                                let _e1374 = phi_2009_;
                                                let _e1376 = triangles.member[(0u + _e1036)].v0_;
                                                let _e1378 = triangles.member[(0u + _e1036)].v1_;
                                                if (_e1376.x > _e1378.x) {
                                                    phi_2022_ = _e1376.x;
                                                } else {
                                                    phi_2022_ = _e1378.x;
                                                }
                                                let _e1385 = phi_2022_;
                                                if (_e1376.y > _e1378.y) {
                                                    phi_2031_ = _e1376.y;
                                                } else {
                                                    phi_2031_ = _e1378.y;
                                                }
                                                let _e1392 = phi_2031_;
                                                if (_e1376.z > _e1378.z) {
                                                    phi_2040_ = _e1376.z;
                                                } else {
                                                    phi_2040_ = _e1378.z;
                                                }
                                                let _e1399 = phi_2040_;
                                                let _e1401 = triangles.member[(0u + _e1036)].v2_;
                                                if (_e1385 > _e1401.x) {
                                                    phi_2049_ = _e1385;
                                                } else {
                                                    phi_2049_ = _e1401.x;
                                                }
                                                let _e1406 = phi_2049_;
                                                if (_e1392 > _e1401.y) {
                                                    phi_2056_ = _e1392;
                                                } else {
                                                    phi_2056_ = _e1401.y;
                                                }
                                                let _e1411 = phi_2056_;
                                                if (_e1399 > _e1401.z) {
                                                    phi_2063_ = _e1399;
                                                } else {
                                                    phi_2063_ = _e1401.z;
                                                }
                                                let _e1416 = phi_2063_;
                                                let _e1423 = ((_e1364 - _e177.origin.x) * _e323);
                                                let _e1424 = ((_e1369 - _e177.origin.y) * _e334);
                                                let _e1425 = ((_e1374 - _e177.origin.z) * _e345);
                                                let _e1432 = ((_e1406 - _e177.origin.x) * _e323);
                                                let _e1433 = ((_e1411 - _e177.origin.y) * _e334);
                                                let _e1434 = ((_e1416 - _e177.origin.z) * _e345);
                                                if (_e1423 < _e1432) {
                                                    phi_2086_ = _e1423;
                                                } else {
                                                    phi_2086_ = _e1432;
                                                }
                                                let _e1437 = phi_2086_;
                                                if (_e1424 < _e1433) {
                                                    phi_2091_ = _e1424;
                                                } else {
                                                    phi_2091_ = _e1433;
                                                }
                                                let _e1440 = phi_2091_;
                                                if (_e1425 < _e1434) {
                                                    phi_2096_ = _e1425;
                                                } else {
                                                    phi_2096_ = _e1434;
                                                }
                                                let _e1443 = phi_2096_;
                                                if (_e1423 > _e1432) {
                                                    phi_2104_ = _e1423;
                                                } else {
                                                    phi_2104_ = _e1432;
                                                }
                                                let _e1449 = phi_2104_;
                                                if (_e1424 > _e1433) {
                                                    phi_2109_ = _e1424;
                                                } else {
                                                    phi_2109_ = _e1433;
                                                }
                                                let _e1452 = phi_2109_;
                                                if (_e1425 > _e1434) {
                                                    phi_2114_ = _e1425;
                                                } else {
                                                    phi_2114_ = _e1434;
                                                }
                                                let _e1455 = phi_2114_;
                                                let _e1459 = core_intrinsics_maximum_number_nsz_f32_((_e1437 - _e390), (_e1440 - _e391));
                                                let _e1460 = core_intrinsics_maximum_number_nsz_f32_(_e1459, (_e1443 - _e392));
                                                let _e1461 = core_intrinsics_minimum_number_nsz_f32_((_e1449 + _e390), (_e1452 + _e391));
                                                let _e1462 = core_intrinsics_minimum_number_nsz_f32_(_e1461, (_e1455 + _e392));
                                                if (_e1460 > -300000000000000000000000000000000000000f) {
                                                    phi_2126_ = _e1460;
                                                } else {
                                                    phi_2126_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1465 = phi_2126_;
                                                if (_e1462 < 300000000000000000000000000000000000000f) {
                                                    phi_2131_ = _e1462;
                                                } else {
                                                    phi_2131_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1468 = phi_2131_;
                                                if (_e1328 < _e1465) {
                                                    phi_2136_ = _e1465;
                                                } else {
                                                    phi_2136_ = _e1328;
                                                }
                                                let _e1471 = phi_2136_;
                                                if (_e1471 > _e1468) {
                                                    phi_2141_ = _e1468;
                                                } else {
                                                    phi_2141_ = _e1471;
                                                }
                                                let _e1474 = phi_2141_;
                                                phi_2146_ = lt_bvh_triangle_Intersection(_e1474, (_e1167 / _e1226), (_e1188 / _e1226), (_e1465 <= _e1468));
                                                phi_2147_ = false;
                                            } else {
                                                phi_2146_ = lt_bvh_triangle_Intersection();
                                                phi_2147_ = true;
                                            }
                                            let _e1480 = phi_2146_;
                                            let _e1482 = phi_2147_;
                                            phi_2148_ = _e1480;
                                            phi_2149_ = _e1482;
                                        } else {
                                            phi_2148_ = lt_bvh_triangle_Intersection();
                                            phi_2149_ = true;
                                        }
                                        let _e1484 = phi_2148_;
                                        let _e1486 = phi_2149_;
                                        if _e1486 {
                                        }
                                        phi_2153_ = _e1484;
                                        phi_2154_ = _e1486;
                                    }
                                    let _e1488 = phi_2153_;
                                    let _e1490 = phi_2154_;
                                    phi_2155_ = _e1488;
                                    phi_2156_ = _e1229;
                                    phi_2157_ = _e1490;
                                } else {
                                    phi_2155_ = lt_bvh_triangle_Intersection();
                                    phi_2156_ = true;
                                    phi_2157_ = false;
                                }
                                let _e1492 = phi_2155_;
                                let _e1494 = phi_2156_;
                                let _e1496 = phi_2157_;
                                if _e1494 {
                                    phi_2161_ = true;
                                } else {
                                    phi_2161_ = _e1496;
                                }
                                let _e1498 = phi_2161_;
                                if _e1498 {
                                    phi_2165_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_2165_ = _e1492;
                                }
                                let _e1500 = phi_2165_;
                                if _e1500.is_hit {
                                    if (_e1500.t > _e177.tmin) {
                                        if (_e1500.t < _e1025.t) {
                                            phi_2214_ = true;
                                        } else {
                                            if (_e1500.t == _e1025.t) {
                                                if (_e1025.triangle != 4294967295u) {
                                                    if (_e1036 < _e1025.triangle) {
                                                        phi_2205_ = true;
                                                    } else {
                                                        if (_e1036 == _e1025.triangle) {
                                                            phi_2204_ = (4294967295u < _e1025.instance);
                                                        } else {
                                                            phi_2204_ = false;
                                                        }
                                                        let _e1519 = phi_2204_;
                                                        phi_2205_ = _e1519;
                                                    }
                                                    let _e1521 = phi_2205_;
                                                    phi_2206_ = _e1521;
                                                    phi_2207_ = false;
                                                } else {
                                                    phi_2206_ = bool();
                                                    phi_2207_ = true;
                                                }
                                                let _e1523 = phi_2206_;
                                                let _e1525 = phi_2207_;
                                                phi_2208_ = _e1523;
                                                phi_2209_ = _e1525;
                                            } else {
                                                phi_2208_ = bool();
                                                phi_2209_ = true;
                                            }
                                            let _e1527 = phi_2208_;
                                            let _e1529 = phi_2209_;
                                            if _e1529 {
                                                phi_2213_ = false;
                                            } else {
                                                phi_2213_ = _e1527;
                                            }
                                            let _e1531 = phi_2213_;
                                            phi_2214_ = _e1531;
                                        }
                                        let _e1533 = phi_2214_;
                                        if _e1533 {
                                            let _e1535 = triangles.member[(0u + _e1036)].i0_;
                                            if ((_e1535 & 2147483648u) == 0u) {
                                                phi_2425_ = true;
                                            } else {
                                                if (_e1036 < _e81) {
                                                } else {
                                                    return;
                                                }
                                                let _e1544 = triangles.member[(0u + _e1036)].i0_;
                                                let _e1545 = (_e1544 & 2147483647u);
                                                let _e1547 = triangles.member[(0u + _e1036)].i1_;
                                                let _e1549 = triangles.member[(0u + _e1036)].i2_;
                                                if (_e1545 < _e84) {
                                                } else {
                                                    return;
                                                }
                                                let _e1553 = vertices.member[(0u + _e1545)];
                                                if (_e1547 < _e84) {
                                                } else {
                                                    return;
                                                }
                                                let _e1557 = vertices.member[(0u + _e1547)];
                                                if (_e1549 < _e84) {
                                                } else {
                                                    return;
                                                }
                                                let _e1561 = vertices.member[(0u + _e1549)];
                                                let _e1562 = array<abi_Vertex, 3>(_e1553, _e1557, _e1561);
                                                if (_e1562[0].material < _e87) {
                                                } else {
                                                    return;
                                                }
                                                let _e1568 = materials.member[(0u + _e1562[0].material)];
                                                if ((_e1568.flags & 0u) == 0u) {
                                                    let _e1573 = ((1f - _e1500.u) - _e1500.v);
                                                    if (_e1568.cutoff <= 0f) {
                                                        phi_2420_ = true;
                                                    } else {
                                                        let _e1600 = (_e1568.base_color.w * ((((f32((_e1562[0].color >> bitcast<u32>(24i))) * _e1573) + (f32((_e1562[1].color >> bitcast<u32>(24i))) * _e1500.u)) + (f32((_e1562[2].color >> bitcast<u32>(24i))) * _e1500.v)) * (1f / 255f)));
                                                        if (_e1568.alpha_size == 0u) {
                                                            phi_2417_ = _e1600;
                                                        } else {
                                                            local.offset = _e1568.alpha_offset;
                                                            local.size = _e1568.alpha_size;
                                                            local.flags = _e1568.flags;
                                                            let _e1631 = _lt_shaders_texture_TextureView_quad((&local), (((_e1562[0].u * _e1573) + (_e1562[1].u * _e1500.u)) + (_e1562[2].u * _e1500.v)), (((_e1562[0].v * _e1573) + (_e1562[1].v * _e1500.u)) + (_e1562[2].v * _e1500.v)));
                                                            let _e1635 = (_e1631.indices[0] >> bitcast<u32>(2i));
                                                            if (_e1635 < _e93) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1639 = alpha_texels.member[(0u + _e1635)];
                                                            let _e1655 = (_e1631.indices[1] >> bitcast<u32>(2i));
                                                            if (_e1655 < _e93) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1659 = alpha_texels.member[(0u + _e1655)];
                                                            let _e1676 = (_e1631.indices[2] >> bitcast<u32>(2i));
                                                            if (_e1676 < _e93) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1680 = alpha_texels.member[(0u + _e1676)];
                                                            let _e1697 = (_e1631.indices[3] >> bitcast<u32>(2i));
                                                            if (_e1697 < _e93) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1701 = alpha_texels.member[(0u + _e1697)];
                                                            phi_2417_ = (_e1600 * (((((f32(((_e1639 >> bitcast<u32>((((_e1631.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1631.weights.x) + ((f32(((_e1659 >> bitcast<u32>((((_e1631.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1631.weights.y)) + ((f32(((_e1680 >> bitcast<u32>((((_e1631.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1631.weights.z)) + ((f32(((_e1701 >> bitcast<u32>((((_e1631.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1631.weights.w)));
                                                        }
                                                        let _e1717 = phi_2417_;
                                                        phi_2420_ = (_e1717 >= _e1568.cutoff);
                                                    }
                                                    let _e1721 = phi_2420_;
                                                    phi_2421_ = _e1721;
                                                } else {
                                                    phi_2421_ = false;
                                                }
                                                let _e1723 = phi_2421_;
                                                if _e1723 {
                                                }
                                                phi_2425_ = _e1723;
                                            }
                                            let _e1725 = phi_2425_;
                                            if _e1725 {
                                                phi_2433_ = lt_bvh_Hit(_e1500.t, _e1500.u, _e1500.v, _e1036, 4294967295u);
                                            } else {
                                                phi_2433_ = _e1025;
                                            }
                                            let _e1731 = phi_2433_;
                                            phi_2434_ = _e1731;
                                        } else {
                                            phi_2434_ = _e1025;
                                        }
                                        let _e1733 = phi_2434_;
                                        phi_2435_ = _e1733;
                                    } else {
                                        phi_2435_ = _e1025;
                                    }
                                    let _e1735 = phi_2435_;
                                    phi_2436_ = _e1735;
                                } else {
                                    phi_2436_ = _e1025;
                                }
                                let _e1737 = phi_2436_;
                                phi_1579_ = _e1737;
                                phi_1582_ = (_e1027 & (_e1027 - 1u));
                                phi_2437_ = true;
                            }
                            let _e1739 = phi_1579_;
                            let _e1741 = phi_1582_;
                            let _e1743 = phi_2437_;
                            continue;
                            continuing {
                                phi_1578_ = _e1739;
                                phi_1581_ = _e1741;
                                break if !(_e1743);
                            }
                        }
                        let _e1746 = local_1.group_mask;
                        if ((_e1746 & 4278190080u) == 0u) {
                            let _e1750 = local_1.len;
                            if (_e1750 == 0u) {
                                phi_2476_ = false;
                            } else {
                                let _e1754 = local_1.len;
                                local_1.len = (_e1754 - 1u);
                                let _e1757 = local_1.len;
                                if (_e1757 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1762 = local_1.first[(0u + _e1757)];
                                local_1.group = _e1762;
                                let _e1765 = local_1.len;
                                if (_e1765 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1770 = local_1.mask[(0u + _e1765)];
                                local_1.group_mask = _e1770;
                                phi_2476_ = true;
                            }
                            let _e1773 = phi_2476_;
                            phi_2477_ = _e1773;
                        } else {
                            phi_2477_ = true;
                        }
                        let _e1775 = phi_2477_;
                        if _e1775 {
                            let _e1777 = local_1.group_mask;
                            let _e1783 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1777)), 32u, (_e1777 == 0u)));
                            let _e1787 = local_1.group_mask;
                            let _e1801 = local_1.group_mask;
                            local_1.group_mask = (_e1801 & ~((1u << bitcast<u32>((_e1783 & 31u)))));
                            let _e1804 = local_1.group;
                            phi_2508_ = (_e1804 + countOneBits(((_e1787 & ~((4294967295u << bitcast<u32>((((_e1783 - 24u) ^ _e444) & 31u))))) & 255u)));
                        } else {
                            phi_2508_ = 4294967295u;
                        }
                        let _e1807 = phi_2508_;
                        let _e2584 = local_5;
                        phi_1242_ = _e2584;
                        phi_1245_ = _e1807;
                    } else {
                        phi_1242_ = lt_bvh_Hit();
                        phi_1245_ = u32();
                    }
                    let _e1809 = phi_1242_;
                    let _e1811 = phi_1245_;
                    continue;
                    continuing {
                        phi_1241_ = _e1809;
                        phi_1244_ = _e1811;
                        break if !(_e585);
                    }
                }
                let _e2588 = local_6;
                phi_2509_ = _e2588;
            }
            let _e1814 = phi_2509_;
            phi_2510_ = _e1814;
            phi_2511_ = _e241;
        } else {
            phi_2510_ = lt_bvh_Hit();
            phi_2511_ = true;
        }
        let _e1816 = phi_2510_;
        let _e1818 = phi_2511_;
        if _e1818 {
            phi_2515_ = _e179;
        } else {
            phi_2515_ = _e1816;
        }
        let _e1820 = phi_2515_;
        if (_e1820.triangle != 4294967295u) {
            let _e1826 = ((1f - _e1820.u) - _e1820.v);
            if (_e1820.triangle < _e81) {
            } else {
                return;
            }
            let _e1832 = triangles.member[(0u + _e1820.triangle)];
            let _e1857 = (((_e1832.v0_.x * _e1826) + (_e1832.v1_.x * _e1820.u)) + (_e1832.v2_.x * _e1820.v));
            let _e1858 = (((_e1832.v0_.y * _e1826) + (_e1832.v1_.y * _e1820.u)) + (_e1832.v2_.y * _e1820.v));
            let _e1859 = (((_e1832.v0_.z * _e1826) + (_e1832.v1_.z * _e1820.u)) + (_e1832.v2_.z * _e1820.v));
            let _e1862 = abs(_e1832.v0_.x);
            let _e1864 = abs(_e1832.v0_.y);
            let _e1866 = abs(_e1832.v0_.z);
            let _e1868 = abs(_e1832.v1_.x);
            let _e1870 = abs(_e1832.v1_.y);
            let _e1872 = abs(_e1832.v1_.z);
            if (_e1862 > _e1868) {
                phi_2580_ = _e1862;
            } else {
                phi_2580_ = _e1868;
            }
            let _e1875 = phi_2580_;
            if (_e1864 > _e1870) {
                phi_2585_ = _e1864;
            } else {
                phi_2585_ = _e1870;
            }
            let _e1878 = phi_2585_;
            if (_e1866 > _e1872) {
                phi_2590_ = _e1866;
            } else {
                phi_2590_ = _e1872;
            }
            let _e1881 = phi_2590_;
            let _e1883 = abs(_e1832.v2_.x);
            let _e1885 = abs(_e1832.v2_.y);
            let _e1887 = abs(_e1832.v2_.z);
            if (_e1875 > _e1883) {
                phi_2601_ = _e1875;
            } else {
                phi_2601_ = _e1883;
            }
            let _e1890 = phi_2601_;
            if (_e1878 > _e1885) {
                phi_2606_ = _e1878;
            } else {
                phi_2606_ = _e1885;
            }
            let _e1893 = phi_2606_;
            if (_e1881 > _e1887) {
                phi_2611_ = _e1881;
            } else {
                phi_2611_ = _e1887;
            }
            let _e1896 = phi_2611_;
            let _e1899 = (_e1832.v1_.x - _e1832.v0_.x);
            let _e1902 = (_e1832.v1_.y - _e1832.v0_.y);
            let _e1905 = (_e1832.v1_.z - _e1832.v0_.z);
            let _e1908 = (_e1832.v2_.x - _e1832.v0_.x);
            let _e1911 = (_e1832.v2_.y - _e1832.v0_.y);
            let _e1914 = (_e1832.v2_.z - _e1832.v0_.z);
            let _e1918 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1902), abs(_e1905));
            let _e1919 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1899), _e1918);
            let _e1920 = (_e1899 / _e1919);
            let _e1921 = (_e1902 / _e1919);
            let _e1922 = (_e1905 / _e1919);
            let _e1926 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1911), abs(_e1914));
            let _e1927 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1908), _e1926);
            let _e1928 = (_e1908 / _e1927);
            let _e1929 = (_e1911 / _e1927);
            let _e1930 = (_e1914 / _e1927);
            let _e1933 = ((_e1921 * _e1930) - (_e1929 * _e1922));
            let _e1936 = ((_e1922 * _e1928) - (_e1930 * _e1920));
            let _e1939 = ((_e1920 * _e1929) - (_e1928 * _e1921));
            let _e1941 = p.member.eye;
            let _e1954 = (1f / sqrt((((_e1933 * _e1933) + (_e1936 * _e1936)) + (_e1939 * _e1939))));
            let _e1955 = (_e1933 * _e1954);
            let _e1956 = (_e1936 * _e1954);
            let _e1957 = (_e1939 * _e1954);
            if ((((_e1955 * (_e1941.x - _e1857)) + (_e1956 * (_e1941.y - _e1858))) + (_e1957 * (_e1941.z - _e1859))) < 0f) {
                phi_2687_ = vec3<f32>(-(_e1955), -(_e1956), -(_e1957));
            } else {
                phi_2687_ = vec3<f32>(_e1955, _e1956, _e1957);
            }
            let _e1970 = phi_2687_;
            if (_e1820.triangle < _e81) {
            } else {
                return;
            }
            let _e1975 = triangles.member[(0u + _e1820.triangle)];
            let _e1977 = (_e1975.i0_ & 2147483647u);
            if (_e1977 < _e84) {
            } else {
                return;
            }
            let _e1983 = vertices.member[(0u + _e1977)];
            if (_e1975.i1_ < _e84) {
            } else {
                return;
            }
            let _e1987 = vertices.member[(0u + _e1975.i1_)];
            if (_e1975.i2_ < _e84) {
            } else {
                return;
            }
            let _e1991 = vertices.member[(0u + _e1975.i2_)];
            let _e1992 = array<abi_Vertex, 3>(_e1983, _e1987, _e1991);
            if (_e1992[0].material < _e87) {
            } else {
                return;
            }
            let _e1998 = materials.member[(0u + _e1992[0].material)];
            let _e2015 = (1f / 255f);
            let _e2034 = (1f / 255f);
            let _e2056 = (1f / 255f);
            let _e2069 = _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(vec3<f32>(_e1826, _e1820.u, _e1820.v));
            let _e2071 = ((_e1998.base_color.x * ((((f32((_e1992[0].color & 255u)) * _e2015) * _e1826) + ((f32((_e1992[1].color & 255u)) * _e2034) * _e1820.u)) + ((f32((_e1992[2].color & 255u)) * _e2056) * _e1820.v))) * _e2069.x);
            let _e2073 = ((_e1998.base_color.y * ((((f32(((_e1992[0].color >> bitcast<u32>(8i)) & 255u)) * _e2015) * _e1826) + ((f32(((_e1992[1].color >> bitcast<u32>(8i)) & 255u)) * _e2034) * _e1820.u)) + ((f32(((_e1992[2].color >> bitcast<u32>(8i)) & 255u)) * _e2056) * _e1820.v))) * _e2069.y);
            let _e2075 = ((_e1998.base_color.z * ((((f32(((_e1992[0].color >> bitcast<u32>(16i)) & 255u)) * _e2015) * _e1826) + ((f32(((_e1992[1].color >> bitcast<u32>(16i)) & 255u)) * _e2034) * _e1820.u)) + ((f32(((_e1992[2].color >> bitcast<u32>(16i)) & 255u)) * _e2056) * _e1820.v))) * _e2069.z);
            let _e2076 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1893, _e1896);
            let _e2077 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1890, _e2076);
            if ((_e1998.flags & 2u) == 0u) {
                phi_2808_ = 0u;
            } else {
                phi_2808_ = 1u;
            }
            let _e2082 = phi_2808_;
            if (_e1992[0].normal == 2147516416u) {
                phi_3011_ = _e1970;
            } else {
                let _e2095 = (f32((bitcast<i32>((_e1992[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2101 = (f32((bitcast<i32>(_e1992[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2105 = ((1f - abs(_e2095)) - abs(_e2101));
                if (_e2105 < 0f) {
                    phi_2835_ = -(_e2105);
                } else {
                    phi_2835_ = 0f;
                }
                let _e2109 = phi_2835_;
                if (_e2095 < 0f) {
                    phi_2842_ = (_e2095 + _e2109);
                } else {
                    phi_2842_ = (_e2095 - _e2109);
                }
                let _e2114 = phi_2842_;
                if (_e2101 < 0f) {
                    phi_2849_ = (_e2101 + _e2109);
                } else {
                    phi_2849_ = (_e2101 - _e2109);
                }
                let _e2119 = phi_2849_;
                let _e2126 = (1f / sqrt((((_e2114 * _e2114) + (_e2119 * _e2119)) + (_e2105 * _e2105))));
                let _e2142 = (f32((bitcast<i32>((_e1992[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2148 = (f32((bitcast<i32>(_e1992[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2152 = ((1f - abs(_e2142)) - abs(_e2148));
                if (_e2152 < 0f) {
                    phi_2884_ = -(_e2152);
                } else {
                    phi_2884_ = 0f;
                }
                let _e2156 = phi_2884_;
                if (_e2142 < 0f) {
                    phi_2891_ = (_e2142 + _e2156);
                } else {
                    phi_2891_ = (_e2142 - _e2156);
                }
                let _e2161 = phi_2891_;
                if (_e2148 < 0f) {
                    phi_2898_ = (_e2148 + _e2156);
                } else {
                    phi_2898_ = (_e2148 - _e2156);
                }
                let _e2166 = phi_2898_;
                let _e2173 = (1f / sqrt((((_e2161 * _e2161) + (_e2166 * _e2166)) + (_e2152 * _e2152))));
                let _e2192 = (f32((bitcast<i32>((_e1992[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2198 = (f32((bitcast<i32>(_e1992[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2202 = ((1f - abs(_e2192)) - abs(_e2198));
                if (_e2202 < 0f) {
                    phi_2936_ = -(_e2202);
                } else {
                    phi_2936_ = 0f;
                }
                let _e2206 = phi_2936_;
                if (_e2192 < 0f) {
                    phi_2943_ = (_e2192 + _e2206);
                } else {
                    phi_2943_ = (_e2192 - _e2206);
                }
                let _e2211 = phi_2943_;
                if (_e2198 < 0f) {
                    phi_2950_ = (_e2198 + _e2206);
                } else {
                    phi_2950_ = (_e2198 - _e2206);
                }
                let _e2216 = phi_2950_;
                let _e2223 = (1f / sqrt((((_e2211 * _e2211) + (_e2216 * _e2216)) + (_e2202 * _e2202))));
                let _e2234 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(vec3<f32>(((((_e2114 * _e2126) * _e1826) + ((_e2161 * _e2173) * _e1820.u)) + ((_e2211 * _e2223) * _e1820.v)), ((((_e2119 * _e2126) * _e1826) + ((_e2166 * _e2173) * _e1820.u)) + ((_e2216 * _e2223) * _e1820.v)), ((((_e2105 * _e2126) * _e1826) + ((_e2152 * _e2173) * _e1820.u)) + ((_e2202 * _e2223) * _e1820.v))));
                let _e2246 = sqrt((((_e2234.x * _e2234.x) + (_e2234.y * _e2234.y)) + (_e2234.z * _e2234.z)));
                if (_e2246 > 0f) {
                    let _e2249 = (_e2234.x / _e2246);
                    let _e2251 = (_e2234.y / _e2246);
                    let _e2253 = (_e2234.z / _e2246);
                    if ((((_e2249 * _e1970.x) + (_e2251 * _e1970.y)) + (_e2253 * _e1970.z)) < 0f) {
                        phi_3009_ = vec3<f32>(-(_e2249), -(_e2251), -(_e2253));
                    } else {
                        phi_3009_ = (_e2234 / vec3(_e2246));
                    }
                    let _e2270 = phi_3009_;
                    phi_3010_ = _e2270;
                } else {
                    phi_3010_ = _e1970;
                }
                let _e2272 = phi_3010_;
                phi_3011_ = _e2272;
            }
            let _e2274 = phi_3011_;
            if (_e2071 > 0f) {
                if (_e2071 < 1f) {
                    phi_3020_ = _e2071;
                } else {
                    phi_3020_ = 1f;
                }
                let _e2278 = phi_3020_;
                phi_3021_ = _e2278;
            } else {
                phi_3021_ = 0f;
            }
            let _e2280 = phi_3021_;
            if (_e2073 > 0f) {
                if (_e2073 < 1f) {
                    phi_3031_ = _e2073;
                } else {
                    phi_3031_ = 1f;
                }
                let _e2285 = phi_3031_;
                phi_3032_ = _e2285;
            } else {
                phi_3032_ = 0f;
            }
            let _e2287 = phi_3032_;
            if (_e2075 > 0f) {
                if (_e2075 < 1f) {
                    phi_3042_ = _e2075;
                } else {
                    phi_3042_ = 1f;
                }
                let _e2292 = phi_3042_;
                phi_3043_ = _e2292;
            } else {
                phi_3043_ = 0f;
            }
            let _e2294 = phi_3043_;
            let _e2297 = ((sqrt(_e2280) * 255f) + 0.5f);
            let _e2306 = ((sqrt(_e2287) * 255f) + 0.5f);
            let _e2318 = ((sqrt(_e2294) * 255f) + 0.5f);
            phi_3078_ = abi_Sample(vec3<f32>(_e1857, _e1858, _e1859), _e2077, _e1970, _e2082, _e2274, ((select(select(u32(_e2297), 0u, (_e2297 < bitcast<f32>(0u))), 4294967295u, (_e2297 > bitcast<f32>(1333788671u))) | (select(select(u32(_e2306), 0u, (_e2306 < bitcast<f32>(0u))), 4294967295u, (_e2306 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e2318), 0u, (_e2318 < bitcast<f32>(0u))), 4294967295u, (_e2318 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_3078_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e2332 = phi_3078_;
        if (_e105.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e105.first_primitive)] = _e2332;
        if (_e1820.triangle != 4294967295u) {
            let _e2341 = ((1f - _e1820.u) - _e1820.v);
            if (_e1820.triangle < _e81) {
            } else {
                return;
            }
            let _e2346 = triangles.member[(0u + _e1820.triangle)];
            let _e2348 = (_e2346.i0_ & 2147483647u);
            if (_e2348 < _e96) {
            } else {
                return;
            }
            let _e2354 = before.member[(0u + _e2348)];
            if (_e2346.i1_ < _e96) {
            } else {
                return;
            }
            let _e2358 = before.member[(0u + _e2346.i1_)];
            if (_e2346.i2_ < _e96) {
            } else {
                return;
            }
            let _e2362 = before.member[(0u + _e2346.i2_)];
            let _e2367 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2354.x, _e2354.y, _e2354.z));
            let _e2378 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2358.x, _e2358.y, _e2358.z));
            let _e2392 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2362.x, _e2362.y, _e2362.z));
            phi_3169_ = vec3<f32>((((_e2367.x * _e2341) + (_e2378.x * _e1820.u)) + (_e2392.x * _e1820.v)), (((_e2367.y * _e2341) + (_e2378.y * _e1820.u)) + (_e2392.y * _e1820.v)), (((_e2367.z * _e2341) + (_e2378.z * _e1820.u)) + (_e2392.z * _e1820.v)));
        } else {
            phi_3169_ = vec3<f32>(0f, 0f, 0f);
        }
        let _e2404 = phi_3169_;
        if (_e105.first_primitive < arrayLength((&past.member))) {
        } else {
            return;
        }
        past.member[(0u + _e105.first_primitive)] = vec4<f32>(_e2404.x, _e2404.y, _e2404.z, 1f);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_alpha_motion_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
