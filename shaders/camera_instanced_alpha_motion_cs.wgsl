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

struct lt_bvh_Instance {
    world_to_object: array<vec4<f32>, 3>,
    object_to_world: array<vec4<f32>, 3>,
    low_world: vec3<f32>,
    root: u32,
    high_world: vec3<f32>,
    first_triangle: u32,
    source: u32,
    padding: array<u32, 3>,
}

struct type_59 {
    member: array<lt_bvh_Instance>,
}

struct type_63 {
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
var<uniform> p: type_63;
@group(0) @binding(1) 
var<storage> nodes: type_36;
@group(0) @binding(2) 
var<storage> triangles: type_40;
@group(0) @binding(5) 
var<storage, read_write> samples: type_20;
@group(0) @binding(6) 
var<storage> instances: type_59;
@group(0) @binding(7) 
var<storage> alpha_texels: type_9;
@group(0) @binding(8) 
var<storage> before: type_28;
@group(0) @binding(9) 
var<storage, read_write> past: type_28;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_233_: lt_bvh_traverse_Tree;
    var phi_234_: bool;
    var phi_235_: lt_bvh_traverse_Tree;
    var phi_236_: bool;
    var phi_241_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_233_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_234_ = false;
        } else {
            phi_233_ = lt_bvh_traverse_Tree();
            phi_234_ = true;
        }
        let _e85 = phi_233_;
        let _e87 = phi_234_;
        phi_235_ = _e85;
        phi_236_ = _e87;
    } else {
        phi_235_ = lt_bvh_traverse_Tree();
        phi_236_ = true;
    }
    let _e89 = phi_235_;
    let _e91 = phi_236_;
    if _e91 {
        phi_241_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_241_ = _e89;
    }
    let _e96 = phi_241_;
    return lt_bvh_traverse_Tree(_e96.root, _e96.first_primitive);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_256_: bool;
    var phi_260_: f32;

    if (param_3 != param_3) {
        phi_256_ = true;
    } else {
        let _e75 = (param_4 >= param_3);
        if _e75 {
        }
        phi_256_ = _e75;
    }
    let _e77 = phi_256_;
    if _e77 {
        phi_260_ = param_4;
    } else {
        phi_260_ = param_3;
    }
    let _e79 = phi_260_;
    return _e79;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_272_: bool;
    var phi_276_: f32;

    if (param_5 != param_5) {
        phi_272_ = true;
    } else {
        let _e75 = (param_6 <= param_5);
        if _e75 {
        }
        phi_272_ = _e75;
    }
    let _e77 = phi_272_;
    if _e77 {
        phi_276_ = param_6;
    } else {
        phi_276_ = param_5;
    }
    let _e79 = phi_276_;
    return _e79;
}

fn _lt_shaders_texture_TextureView_quad(param_7: ptr<function, texture_TextureView>, param_8: f32, param_9: f32) -> texture_TexelQuad {
    var phi_318_: f32;
    var phi_323_: f32;
    var phi_324_: bool;
    var phi_325_: f32;
    var phi_326_: bool;
    var phi_330_: f32;
    var phi_356_: f32;
    var phi_361_: f32;
    var phi_362_: bool;
    var phi_363_: f32;
    var phi_364_: bool;
    var phi_368_: f32;
    var phi_376_: f32;
    var phi_377_: f32;
    var phi_378_: f32;
    var phi_387_: f32;
    var phi_388_: f32;
    var phi_406_: u32;
    var phi_420_: u32;
    var phi_427_: u32;
    var phi_432_: u32;
    var phi_438_: u32;
    var phi_443_: u32;
    var phi_445_: texture_Axis;
    var phi_473_: f32;
    var phi_478_: f32;
    var phi_479_: bool;
    var phi_480_: f32;
    var phi_481_: bool;
    var phi_485_: f32;
    var phi_511_: f32;
    var phi_516_: f32;
    var phi_517_: bool;
    var phi_518_: f32;
    var phi_519_: bool;
    var phi_523_: f32;
    var phi_531_: f32;
    var phi_532_: f32;
    var phi_533_: f32;
    var phi_542_: f32;
    var phi_543_: f32;
    var phi_561_: u32;
    var phi_575_: u32;
    var phi_582_: u32;
    var phi_587_: u32;
    var phi_593_: u32;
    var phi_598_: u32;
    var phi_600_: texture_Axis;

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
                phi_318_ = 1f;
            } else {
                phi_318_ = 0f;
            }
            let _e106 = phi_318_;
            if (param_8 < 8388608f) {
                phi_323_ = (_e103 - _e106);
                phi_324_ = false;
            } else {
                phi_323_ = f32();
                phi_324_ = true;
            }
            let _e109 = phi_323_;
            let _e111 = phi_324_;
            phi_325_ = _e109;
            phi_326_ = _e111;
        } else {
            phi_325_ = f32();
            phi_326_ = true;
        }
        let _e113 = phi_325_;
        let _e115 = phi_326_;
        if _e115 {
            phi_330_ = param_8;
        } else {
            phi_330_ = _e113;
        }
        let _e117 = phi_330_;
        phi_378_ = (param_8 - _e117);
    } else {
        if (_e90 == 1u) {
            let _e120 = (param_8 * 0.5f);
            if (_e120 > -8388608f) {
                let _e132 = f32(select(0i, select(select(i32(_e120), i32(-2147483648), (_e120 < bitcast<f32>(3472883712u))), 2147483647i, (_e120 > bitcast<f32>(1325400063u))), (_e120 == _e120)));
                if (_e132 > _e120) {
                    phi_356_ = 1f;
                } else {
                    phi_356_ = 0f;
                }
                let _e135 = phi_356_;
                if (_e120 < 8388608f) {
                    phi_361_ = (_e132 - _e135);
                    phi_362_ = false;
                } else {
                    phi_361_ = f32();
                    phi_362_ = true;
                }
                let _e138 = phi_361_;
                let _e140 = phi_362_;
                phi_363_ = _e138;
                phi_364_ = _e140;
            } else {
                phi_363_ = f32();
                phi_364_ = true;
            }
            let _e142 = phi_363_;
            let _e144 = phi_364_;
            if _e144 {
                phi_368_ = _e120;
            } else {
                phi_368_ = _e142;
            }
            let _e146 = phi_368_;
            let _e148 = (param_8 - (2f * _e146));
            if (_e148 > 1f) {
                phi_376_ = (2f - _e148);
            } else {
                phi_376_ = _e148;
            }
            let _e152 = phi_376_;
            phi_377_ = _e152;
        } else {
            phi_377_ = param_8;
        }
        let _e154 = phi_377_;
        phi_378_ = _e154;
    }
    let _e156 = phi_378_;
    if (_e156 > 0f) {
        if (_e156 < 1f) {
            phi_387_ = _e156;
        } else {
            phi_387_ = 1f;
        }
        let _e160 = phi_387_;
        phi_388_ = _e160;
    } else {
        phi_388_ = 0f;
    }
    let _e162 = phi_388_;
    let _e163 = (_e77 - 1u);
    let _e165 = (_e162 * f32(_e77));
    if _e85 {
        let _e172 = select(select(u32(_e165), 0u, (_e165 < bitcast<f32>(0u))), 4294967295u, (_e165 > bitcast<f32>(1333788671u)));
        if (_e163 < _e172) {
            phi_406_ = _e163;
        } else {
            phi_406_ = _e172;
        }
        let _e175 = phi_406_;
        phi_445_ = texture_Axis(_e175, _e175, 0f);
    } else {
        let _e177 = (_e165 + 0.5f);
        let _e184 = select(select(u32(_e177), 0u, (_e177 < bitcast<f32>(0u))), 4294967295u, (_e177 > bitcast<f32>(1333788671u)));
        if (_e77 < _e184) {
            phi_420_ = _e77;
        } else {
            phi_420_ = _e184;
        }
        let _e187 = phi_420_;
        if (_e90 == 0u) {
            phi_427_ = _e163;
        } else {
            phi_427_ = 0u;
        }
        let _e192 = phi_427_;
        if (_e90 == 0u) {
            phi_432_ = 0u;
        } else {
            phi_432_ = _e163;
        }
        let _e195 = phi_432_;
        if (_e187 == 0u) {
            phi_438_ = _e192;
        } else {
            phi_438_ = (_e187 - 1u);
        }
        let _e199 = phi_438_;
        if (_e187 > _e163) {
            phi_443_ = _e195;
        } else {
            phi_443_ = _e187;
        }
        let _e202 = phi_443_;
        phi_445_ = texture_Axis(_e199, _e202, (_e177 - f32(_e187)));
    }
    let _e205 = phi_445_;
    let _e207 = (*param_7).flags;
    let _e210 = ((_e207 >> bitcast<u32>(6u)) & 3u);
    if (_e210 == 0u) {
        if (param_9 > -8388608f) {
            let _e223 = f32(select(0i, select(select(i32(param_9), i32(-2147483648), (param_9 < bitcast<f32>(3472883712u))), 2147483647i, (param_9 > bitcast<f32>(1325400063u))), (param_9 == param_9)));
            if (_e223 > param_9) {
                phi_473_ = 1f;
            } else {
                phi_473_ = 0f;
            }
            let _e226 = phi_473_;
            if (param_9 < 8388608f) {
                phi_478_ = (_e223 - _e226);
                phi_479_ = false;
            } else {
                phi_478_ = f32();
                phi_479_ = true;
            }
            let _e229 = phi_478_;
            let _e231 = phi_479_;
            phi_480_ = _e229;
            phi_481_ = _e231;
        } else {
            phi_480_ = f32();
            phi_481_ = true;
        }
        let _e233 = phi_480_;
        let _e235 = phi_481_;
        if _e235 {
            phi_485_ = param_9;
        } else {
            phi_485_ = _e233;
        }
        let _e237 = phi_485_;
        phi_533_ = (param_9 - _e237);
    } else {
        if (_e210 == 1u) {
            let _e240 = (param_9 * 0.5f);
            if (_e240 > -8388608f) {
                let _e252 = f32(select(0i, select(select(i32(_e240), i32(-2147483648), (_e240 < bitcast<f32>(3472883712u))), 2147483647i, (_e240 > bitcast<f32>(1325400063u))), (_e240 == _e240)));
                if (_e252 > _e240) {
                    phi_511_ = 1f;
                } else {
                    phi_511_ = 0f;
                }
                let _e255 = phi_511_;
                if (_e240 < 8388608f) {
                    phi_516_ = (_e252 - _e255);
                    phi_517_ = false;
                } else {
                    phi_516_ = f32();
                    phi_517_ = true;
                }
                let _e258 = phi_516_;
                let _e260 = phi_517_;
                phi_518_ = _e258;
                phi_519_ = _e260;
            } else {
                phi_518_ = f32();
                phi_519_ = true;
            }
            let _e262 = phi_518_;
            let _e264 = phi_519_;
            if _e264 {
                phi_523_ = _e240;
            } else {
                phi_523_ = _e262;
            }
            let _e266 = phi_523_;
            let _e268 = (param_9 - (2f * _e266));
            if (_e268 > 1f) {
                phi_531_ = (2f - _e268);
            } else {
                phi_531_ = _e268;
            }
            let _e272 = phi_531_;
            phi_532_ = _e272;
        } else {
            phi_532_ = param_9;
        }
        let _e274 = phi_532_;
        phi_533_ = _e274;
    }
    let _e276 = phi_533_;
    if (_e276 > 0f) {
        if (_e276 < 1f) {
            phi_542_ = _e276;
        } else {
            phi_542_ = 1f;
        }
        let _e280 = phi_542_;
        phi_543_ = _e280;
    } else {
        phi_543_ = 0f;
    }
    let _e282 = phi_543_;
    let _e283 = (_e81 - 1u);
    let _e285 = (_e282 * f32(_e81));
    if _e85 {
        let _e292 = select(select(u32(_e285), 0u, (_e285 < bitcast<f32>(0u))), 4294967295u, (_e285 > bitcast<f32>(1333788671u)));
        if (_e283 < _e292) {
            phi_561_ = _e283;
        } else {
            phi_561_ = _e292;
        }
        let _e295 = phi_561_;
        phi_600_ = texture_Axis(_e295, _e295, 0f);
    } else {
        let _e297 = (_e285 + 0.5f);
        let _e304 = select(select(u32(_e297), 0u, (_e297 < bitcast<f32>(0u))), 4294967295u, (_e297 > bitcast<f32>(1333788671u)));
        if (_e81 < _e304) {
            phi_575_ = _e81;
        } else {
            phi_575_ = _e304;
        }
        let _e307 = phi_575_;
        if (_e210 == 0u) {
            phi_582_ = _e283;
        } else {
            phi_582_ = 0u;
        }
        let _e312 = phi_582_;
        if (_e210 == 0u) {
            phi_587_ = 0u;
        } else {
            phi_587_ = _e283;
        }
        let _e315 = phi_587_;
        if (_e307 == 0u) {
            phi_593_ = _e312;
        } else {
            phi_593_ = (_e307 - 1u);
        }
        let _e319 = phi_593_;
        if (_e307 > _e283) {
            phi_598_ = _e315;
        } else {
            phi_598_ = _e307;
        }
        let _e322 = phi_598_;
        phi_600_ = texture_Axis(_e319, _e322, (_e297 - f32(_e307)));
    }
    let _e325 = phi_600_;
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
    var phi_659_: f32;

    if (param_12 > param_13) {
        phi_659_ = param_12;
    } else {
        phi_659_ = param_13;
    }
    let _e76 = phi_659_;
    return _e76;
}

fn _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(param_14: vec3<f32>) -> vec3<f32> {
    return vec3<f32>(1f, 1f, 1f);
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var local_2: lt_bvh_traverse_Stack;
    var phi_816_: bool;
    var phi_817_: bool;
    var phi_818_: bool;
    var phi_819_: bool;
    var phi_823_: bool;
    var phi_836_: bool;
    var phi_837_: bool;
    var phi_838_: bool;
    var phi_839_: bool;
    var phi_843_: bool;
    var phi_856_: bool;
    var phi_857_: bool;
    var phi_858_: bool;
    var phi_862_: bool;
    var phi_863_: bool;
    var phi_864_: bool;
    var phi_865_: bool;
    var phi_866_: bool;
    var phi_870_: bool;
    var phi_946_: f32;
    var phi_953_: f32;
    var phi_961_: f32;
    var phi_968_: f32;
    var phi_976_: f32;
    var phi_983_: f32;
    var phi_1006_: f32;
    var phi_1011_: f32;
    var phi_1016_: f32;
    var phi_1021_: f32;
    var phi_1026_: f32;
    var phi_1045_: u32;
    var phi_1050_: u32;
    var phi_1055_: u32;
    var phi_1169_: bool;
    var phi_1170_: bool;
    var phi_1201_: u32;
    var phi_1203_: u32;
    var phi_1206_: lt_bvh_Hit;
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
    var phi_1540_: u32;
    var phi_1543_: lt_bvh_Hit;
    var phi_1598_: f32;
    var phi_1603_: f32;
    var phi_1608_: f32;
    var phi_1616_: f32;
    var phi_1621_: f32;
    var phi_1626_: f32;
    var phi_1758_: bool;
    var phi_1759_: bool;
    var phi_1760_: bool;
    var phi_1761_: bool;
    var phi_1765_: bool;
    var phi_1778_: bool;
    var phi_1779_: bool;
    var phi_1780_: bool;
    var phi_1781_: bool;
    var phi_1785_: bool;
    var phi_1798_: bool;
    var phi_1799_: bool;
    var phi_1800_: bool;
    var phi_1804_: bool;
    var phi_1805_: bool;
    var phi_1806_: bool;
    var phi_1807_: bool;
    var phi_1808_: bool;
    var phi_1812_: bool;
    var phi_1882_: f32;
    var phi_1889_: f32;
    var phi_1896_: f32;
    var phi_1903_: f32;
    var phi_1910_: f32;
    var phi_1917_: f32;
    var phi_1934_: f32;
    var phi_1939_: f32;
    var phi_1944_: f32;
    var phi_1949_: f32;
    var phi_1954_: f32;
    var phi_1980_: bool;
    var phi_1981_: bool;
    var phi_1989_: u32;
    var phi_1990_: u32;
    var phi_2001_: vec3<f32>;
    var phi_2002_: vec3<f32>;
    var phi_2015_: u32;
    var phi_2020_: u32;
    var phi_2025_: u32;
    var phi_2139_: bool;
    var phi_2140_: bool;
    var phi_2171_: u32;
    var phi_2173_: lt_bvh_Hit;
    var phi_2176_: u32;
    var phi_2257_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2284_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2311_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2317_: u32;
    var phi_2320_: u32;
    var phi_2334_: u32;
    var phi_2344_: u32;
    var phi_2354_: u32;
    var phi_2372_: u32;
    var phi_2382_: u32;
    var phi_2392_: u32;
    var phi_2428_: u32;
    var phi_2441_: u32;
    var phi_2446_: u32;
    var phi_2447_: u32;
    var phi_2448_: u32;
    var phi_2318_: u32;
    var phi_2321_: u32;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_2506_: lt_bvh_Hit;
    var phi_2509_: u32;
    var phi_2553_: vec3<f32>;
    var phi_2554_: vec3<f32>;
    var phi_2583_: vec3<f32>;
    var phi_2584_: vec3<f32>;
    var phi_2613_: vec3<f32>;
    var phi_2614_: vec3<f32>;
    var phi_2632_: bool;
    var phi_2633_: bool;
    var phi_2637_: f32;
    var phi_2638_: f32;
    var phi_2639_: f32;
    var phi_2640_: f32;
    var phi_2648_: f32;
    var phi_2658_: bool;
    var phi_2659_: bool;
    var phi_2663_: f32;
    var phi_2664_: f32;
    var phi_2665_: f32;
    var phi_2666_: f32;
    var phi_2674_: f32;
    var phi_2684_: bool;
    var phi_2685_: bool;
    var phi_2689_: f32;
    var phi_2690_: f32;
    var phi_2691_: f32;
    var phi_2692_: f32;
    var phi_2700_: f32;
    var phi_2715_: f32;
    var phi_2716_: bool;
    var phi_2717_: f32;
    var phi_2718_: bool;
    var phi_2719_: f32;
    var phi_2720_: bool;
    var phi_2738_: f32;
    var phi_2739_: bool;
    var phi_2740_: bool;
    var phi_2741_: f32;
    var phi_2742_: bool;
    var phi_2743_: bool;
    var phi_2747_: bool;
    var phi_2748_: f32;
    var phi_2749_: bool;
    var phi_2777_: vec3<f32>;
    var phi_2778_: vec3<f32>;
    var phi_2803_: vec3<f32>;
    var phi_2804_: vec3<f32>;
    var phi_2829_: vec3<f32>;
    var phi_2830_: vec3<f32>;
    var phi_2886_: f32;
    var phi_2895_: f32;
    var phi_2904_: f32;
    var phi_2913_: f32;
    var phi_2920_: f32;
    var phi_2927_: f32;
    var phi_2940_: f32;
    var phi_2949_: f32;
    var phi_2958_: f32;
    var phi_2967_: f32;
    var phi_2974_: f32;
    var phi_2981_: f32;
    var phi_2998_: f32;
    var phi_3003_: f32;
    var phi_3008_: f32;
    var phi_3016_: f32;
    var phi_3021_: f32;
    var phi_3026_: f32;
    var phi_3038_: f32;
    var phi_3043_: f32;
    var phi_3048_: f32;
    var phi_3053_: f32;
    var phi_3058_: lt_bvh_triangle_Intersection;
    var phi_3059_: bool;
    var phi_3060_: lt_bvh_triangle_Intersection;
    var phi_3061_: bool;
    var phi_3065_: lt_bvh_triangle_Intersection;
    var phi_3066_: bool;
    var phi_3067_: lt_bvh_triangle_Intersection;
    var phi_3068_: bool;
    var phi_3069_: bool;
    var phi_3073_: bool;
    var phi_3077_: lt_bvh_triangle_Intersection;
    var phi_3115_: bool;
    var phi_3116_: bool;
    var phi_3117_: bool;
    var phi_3118_: bool;
    var phi_3119_: bool;
    var phi_3120_: bool;
    var phi_3124_: bool;
    var phi_3125_: bool;
    var phi_3328_: f32;
    var phi_3331_: bool;
    var phi_3332_: bool;
    var phi_3336_: bool;
    var phi_3344_: lt_bvh_Hit;
    var phi_3345_: lt_bvh_Hit;
    var phi_3346_: lt_bvh_Hit;
    var phi_3347_: lt_bvh_Hit;
    var phi_2507_: lt_bvh_Hit;
    var phi_2510_: u32;
    var phi_3348_: bool;
    var phi_3387_: bool;
    var phi_3388_: bool;
    var phi_3419_: u32;
    var phi_2174_: lt_bvh_Hit;
    var phi_2177_: u32;
    var phi_3420_: lt_bvh_Hit;
    var phi_3421_: lt_bvh_Hit;
    var phi_3422_: bool;
    var phi_3426_: lt_bvh_Hit;
    var phi_3427_: lt_bvh_Hit;
    var phi_3428_: lt_bvh_Hit;
    var phi_3429_: lt_bvh_Hit;
    var phi_1541_: u32;
    var phi_1544_: lt_bvh_Hit;
    var phi_3430_: bool;
    var phi_3469_: bool;
    var phi_3470_: bool;
    var phi_3501_: u32;
    var phi_1204_: u32;
    var phi_1207_: lt_bvh_Hit;
    var phi_3502_: lt_bvh_Hit;
    var phi_3503_: lt_bvh_Hit;
    var phi_3504_: bool;
    var phi_3508_: lt_bvh_Hit;
    var phi_3696_: f32;
    var phi_3701_: f32;
    var phi_3706_: f32;
    var phi_3714_: f32;
    var phi_3719_: f32;
    var phi_3724_: f32;
    var phi_3788_: vec3<f32>;
    var phi_3909_: u32;
    var phi_3936_: f32;
    var phi_3943_: f32;
    var phi_3950_: f32;
    var phi_3985_: f32;
    var phi_3992_: f32;
    var phi_3999_: f32;
    var phi_4037_: f32;
    var phi_4044_: f32;
    var phi_4051_: f32;
    var phi_4137_: vec3<f32>;
    var phi_4138_: vec3<f32>;
    var phi_4139_: vec3<f32>;
    var phi_4148_: f32;
    var phi_4149_: f32;
    var phi_4159_: f32;
    var phi_4160_: f32;
    var phi_4170_: f32;
    var phi_4171_: f32;
    var phi_4206_: abi_Sample;
    var phi_4429_: vec3<f32>;
    var local_9: lt_bvh_Hit;
    var local_10: lt_bvh_Hit;
    var local_11: lt_bvh_Hit;
    var local_12: lt_bvh_Hit;

    let _e75 = id_1;
    let _e79 = arrayLength((&nodes.member));
    let _e82 = arrayLength((&triangles.member));
    let _e85 = arrayLength((&vertices.member));
    let _e88 = arrayLength((&materials.member));
    let _e94 = arrayLength((&instances.member));
    let _e97 = arrayLength((&alpha_texels.member));
    let _e100 = arrayLength((&before.member));
    let _e106 = p.member.size[0u];
    let _e108 = p.member.size[1u];
    let _e109 = lt_shaders_entry_pixel_index(_e75, _e106, _e108);
    if (bitcast<i32>(_e109.root) != 0i) {
        let _e115 = p.member.root;
        let _e119 = p.member.eye;
        let _e122 = p.member.grid[0u];
        let _e124 = p.member.grid[1u];
        let _e143 = p.member.size[0u];
        let _e147 = ((((f32(_e75.x) + ((f32((_e75.y & (_e124 - 1u))) + 0.5f) / f32(_e124))) / f32(_e143)) * 2f) - 1f);
        let _e150 = p.member.size[1u];
        let _e154 = (1f - (((f32(_e75.y) + ((f32((_e75.x & (_e122 - 1u))) + 0.5f) / f32(_e122))) / f32(_e150)) * 2f));
        let _e156 = p.member.forward;
        let _e158 = p.member.right;
        let _e172 = p.member.up;
        let _e183 = _lt_bvh_ray_Ray_new(_e119, vec3<f32>(((_e156.x + (_e158.x * _e147)) + (_e172.x * _e154)), ((_e156.y + (_e158.y * _e147)) + (_e172.y * _e154)), ((_e156.z + (_e158.z * _e147)) + (_e172.z * _e154))));
        let _e185 = lt_bvh_Hit(_e183.tmax, 0f, 0f, 4294967295u, 4294967295u);
        let _e188 = abs(_e183.direction.x);
        let _e190 = abs(_e183.direction.y);
        let _e192 = abs(_e183.direction.z);
        if (abs(_e183.origin.x) < 1000000000000000f) {
            if (abs(_e183.origin.y) < 1000000000000000f) {
                phi_816_ = (abs(_e183.origin.z) < 1000000000000000f);
                phi_817_ = false;
            } else {
                phi_816_ = bool();
                phi_817_ = true;
            }
            let _e204 = phi_816_;
            let _e206 = phi_817_;
            phi_818_ = _e204;
            phi_819_ = _e206;
        } else {
            phi_818_ = bool();
            phi_819_ = true;
        }
        let _e208 = phi_818_;
        let _e210 = phi_819_;
        if _e210 {
            phi_823_ = false;
        } else {
            phi_823_ = _e208;
        }
        let _e212 = phi_823_;
        if _e212 {
            if (_e188 < 1000000000000000f) {
                if (_e190 < 1000000000000000f) {
                    phi_836_ = (_e192 < 1000000000000000f);
                    phi_837_ = false;
                } else {
                    phi_836_ = bool();
                    phi_837_ = true;
                }
                let _e217 = phi_836_;
                let _e219 = phi_837_;
                phi_838_ = _e217;
                phi_839_ = _e219;
            } else {
                phi_838_ = bool();
                phi_839_ = true;
            }
            let _e221 = phi_838_;
            let _e223 = phi_839_;
            if _e223 {
                phi_843_ = false;
            } else {
                phi_843_ = _e221;
            }
            let _e225 = phi_843_;
            if _e225 {
                if (_e188 > 0f) {
                    phi_857_ = bool();
                    phi_858_ = true;
                } else {
                    let _e227 = (_e190 > 0f);
                    if _e227 {
                        phi_856_ = bool();
                    } else {
                        phi_856_ = (_e192 > 0f);
                    }
                    let _e230 = phi_856_;
                    phi_857_ = _e230;
                    phi_858_ = _e227;
                }
                let _e232 = phi_857_;
                let _e234 = phi_858_;
                if _e234 {
                    phi_862_ = true;
                } else {
                    phi_862_ = _e232;
                }
                let _e236 = phi_862_;
                phi_863_ = _e236;
                phi_864_ = false;
            } else {
                phi_863_ = bool();
                phi_864_ = true;
            }
            let _e238 = phi_863_;
            let _e240 = phi_864_;
            phi_865_ = _e238;
            phi_866_ = _e240;
        } else {
            phi_865_ = bool();
            phi_866_ = true;
        }
        let _e242 = phi_865_;
        let _e244 = phi_866_;
        if _e244 {
            phi_870_ = false;
        } else {
            phi_870_ = _e242;
        }
        let _e246 = phi_870_;
        if _e246 {
            let _e247 = (_e115 >= _e79);
            if _e247 {
                phi_3502_ = lt_bvh_Hit();
            } else {
                if (_e115 < _e79) {
                } else {
                    return;
                }
                let _e253 = nodes.member[(0u + _e115)].frame[0u];
                let _e257 = nodes.member[(0u + _e115)].frame[1u];
                let _e261 = nodes.member[(0u + _e115)].frame[2u];
                let _e265 = nodes.member[(0u + _e115)].frame[0u];
                let _e269 = nodes.member[(0u + _e115)].frame[1u];
                let _e273 = nodes.member[(0u + _e115)].frame[2u];
                let _e277 = nodes.member[(0u + _e115)].frame[3u];
                let _e316 = core_intrinsics_maximum_number_nsz_f32_(abs(_e183.direction.x), abs(_e183.direction.y));
                let _e317 = core_intrinsics_maximum_number_nsz_f32_(_e316, abs(_e183.direction.z));
                let _e318 = (_e317 * 0.0000000000009094947f);
                if (abs(_e183.direction.x) < _e318) {
                    phi_946_ = _e318;
                } else {
                    phi_946_ = abs(_e183.direction.x);
                }
                let _e324 = phi_946_;
                if (_e183.direction.x < 0f) {
                    phi_953_ = (-1f / _e324);
                } else {
                    phi_953_ = (1f / _e324);
                }
                let _e329 = phi_953_;
                if (abs(_e183.direction.y) < _e318) {
                    phi_961_ = _e318;
                } else {
                    phi_961_ = abs(_e183.direction.y);
                }
                let _e335 = phi_961_;
                if (_e183.direction.y < 0f) {
                    phi_968_ = (-1f / _e335);
                } else {
                    phi_968_ = (1f / _e335);
                }
                let _e340 = phi_968_;
                if (abs(_e183.direction.z) < _e318) {
                    phi_976_ = _e318;
                } else {
                    phi_976_ = abs(_e183.direction.z);
                }
                let _e346 = phi_976_;
                if (_e183.direction.z < 0f) {
                    phi_983_ = (-1f / _e346);
                } else {
                    phi_983_ = (1f / _e346);
                }
                let _e351 = phi_983_;
                let _e358 = abs((bitcast<f32>(_e253) - _e183.origin.x));
                let _e359 = abs((bitcast<f32>(_e257) - _e183.origin.y));
                let _e360 = abs((bitcast<f32>(_e261) - _e183.origin.z));
                let _e367 = abs(((bitcast<f32>(_e265) + (bitcast<f32>((((_e277 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e183.origin.x));
                let _e368 = abs(((bitcast<f32>(_e269) + (bitcast<f32>((((_e277 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e183.origin.y));
                let _e369 = abs(((bitcast<f32>(_e273) + (bitcast<f32>((((_e277 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e183.origin.z));
                if (_e358 > _e367) {
                    phi_1006_ = _e358;
                } else {
                    phi_1006_ = _e367;
                }
                let _e372 = phi_1006_;
                if (_e359 > _e368) {
                    phi_1011_ = _e359;
                } else {
                    phi_1011_ = _e368;
                }
                let _e375 = phi_1011_;
                if (_e360 > _e369) {
                    phi_1016_ = _e360;
                } else {
                    phi_1016_ = _e369;
                }
                let _e378 = phi_1016_;
                if (_e372 > _e375) {
                    phi_1021_ = _e372;
                } else {
                    phi_1021_ = _e375;
                }
                let _e381 = phi_1021_;
                if (_e381 > _e378) {
                    phi_1026_ = _e381;
                } else {
                    phi_1026_ = _e378;
                }
                let _e384 = phi_1026_;
                let _e388 = (_e384 * 0.0000019073486f);
                let _e389 = (abs(_e329) * _e388);
                let _e390 = (abs(_e340) * _e388);
                let _e391 = (abs(_e351) * _e388);
                let _e395 = (_e384 * 0.0000009536743f);
                let _e396 = (abs(_e329) * _e395);
                let _e397 = (abs(_e340) * _e395);
                let _e398 = (abs(_e351) * _e395);
                if (_e329 < 0f) {
                    phi_1045_ = 0u;
                } else {
                    phi_1045_ = 1u;
                }
                let _e401 = phi_1045_;
                if (_e340 < 0f) {
                    phi_1050_ = 0u;
                } else {
                    phi_1050_ = 2u;
                }
                let _e404 = phi_1050_;
                if (_e351 < 0f) {
                    phi_1055_ = 0u;
                } else {
                    phi_1055_ = 4u;
                }
                let _e407 = phi_1055_;
                let _e409 = ((_e401 | _e404) | _e407);
                let _e410 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e115, 2147483648u);
                local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e410.first[0], _e410.first[1], _e410.first[2], _e410.first[3], _e410.first[4], _e410.first[5], _e410.first[6], _e410.first[7], _e410.first[8], _e410.first[9], _e410.first[10], _e410.first[11], _e410.first[12], _e410.first[13], _e410.first[14], _e410.first[15], _e410.first[16], _e410.first[17], _e410.first[18], _e410.first[19], _e410.first[20], _e410.first[21], _e410.first[22], _e410.first[23], _e410.first[24], _e410.first[25], _e410.first[26], _e410.first[27], _e410.first[28], _e410.first[29], _e410.first[30], _e410.first[31]), array<u32, 32>(_e410.mask[0], _e410.mask[1], _e410.mask[2], _e410.mask[3], _e410.mask[4], _e410.mask[5], _e410.mask[6], _e410.mask[7], _e410.mask[8], _e410.mask[9], _e410.mask[10], _e410.mask[11], _e410.mask[12], _e410.mask[13], _e410.mask[14], _e410.mask[15], _e410.mask[16], _e410.mask[17], _e410.mask[18], _e410.mask[19], _e410.mask[20], _e410.mask[21], _e410.mask[22], _e410.mask[23], _e410.mask[24], _e410.mask[25], _e410.mask[26], _e410.mask[27], _e410.mask[28], _e410.mask[29], _e410.mask[30], _e410.mask[31]), _e410.len, _e410.group, _e410.group_mask);
                let _e484 = local_2.group_mask;
                if ((_e484 & 4278190080u) == 0u) {
                    let _e488 = local_2.len;
                    if (_e488 == 0u) {
                        phi_1169_ = false;
                    } else {
                        let _e492 = local_2.len;
                        local_2.len = (_e492 - 1u);
                        let _e495 = local_2.len;
                        if (_e495 < 32u) {
                        } else {
                            return;
                        }
                        let _e500 = local_2.first[(0u + _e495)];
                        local_2.group = _e500;
                        let _e503 = local_2.len;
                        if (_e503 < 32u) {
                        } else {
                            return;
                        }
                        let _e508 = local_2.mask[(0u + _e503)];
                        local_2.group_mask = _e508;
                        phi_1169_ = true;
                    }
                    let _e511 = phi_1169_;
                    phi_1170_ = _e511;
                } else {
                    phi_1170_ = true;
                }
                let _e513 = phi_1170_;
                if _e513 {
                    let _e515 = local_2.group_mask;
                    let _e521 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e515)), 32u, (_e515 == 0u)));
                    let _e525 = local_2.group_mask;
                    let _e539 = local_2.group_mask;
                    local_2.group_mask = (_e539 & ~((1u << bitcast<u32>((_e521 & 31u)))));
                    let _e542 = local_2.group;
                    phi_1201_ = (_e542 + countOneBits(((_e525 & ~((4294967295u << bitcast<u32>((((_e521 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1201_ = 4294967295u;
                }
                let _e545 = phi_1201_;
                phi_1203_ = _e545;
                phi_1206_ = _e185;
                loop {
                    let _e547 = phi_1203_;
                    let _e549 = phi_1206_;
                    local_12 = _e549;
                    let _e550 = (_e547 != 4294967295u);
                    if _e550 {
                        if (_e547 < _e79) {
                        } else {
                            return;
                        }
                        let _e558 = nodes.member[(0u + _e547)].frame[3u];
                        let _e583 = (bitcast<f32>((((_e558 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e329);
                        let _e584 = (bitcast<f32>((((_e558 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e340);
                        let _e585 = (bitcast<f32>((((_e558 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e351);
                        let _e588 = nodes.member[(0u + _e547)].frame[0u];
                        let _e592 = nodes.member[(0u + _e547)].frame[1u];
                        let _e596 = nodes.member[(0u + _e547)].frame[2u];
                        let _e604 = ((bitcast<f32>(_e588) - _e183.origin.x) * _e329);
                        let _e605 = ((bitcast<f32>(_e592) - _e183.origin.y) * _e340);
                        let _e606 = ((bitcast<f32>(_e596) - _e183.origin.z) * _e351);
                        let _e614 = nodes.member[(0u + _e547)].x;
                        if (_e329 < 0f) {
                            let _e625 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e614.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e631 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e625.unnamed.root, _e614.w), _e625.unnamed_1);
                            let _e637 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e631.unnamed, lt_bvh_traverse_Tree(_e614.x, _e631.unnamed_1.first_primitive));
                            phi_1291_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e637.unnamed, lt_bvh_traverse_Tree(_e637.unnamed_1.root, _e614.y));
                        } else {
                            let _e653 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e614.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e659 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e653.unnamed.root, _e614.y), _e653.unnamed_1);
                            let _e665 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e659.unnamed, lt_bvh_traverse_Tree(_e614.z, _e659.unnamed_1.first_primitive));
                            phi_1291_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e665.unnamed, lt_bvh_traverse_Tree(_e665.unnamed_1.root, _e614.w));
                        }
                        let _e673 = phi_1291_;
                        let _e683 = nodes.member[(0u + _e547)].y;
                        if (_e340 < 0f) {
                            let _e694 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e683.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e700 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e694.unnamed.root, _e683.w), _e694.unnamed_1);
                            let _e706 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e700.unnamed, lt_bvh_traverse_Tree(_e683.x, _e700.unnamed_1.first_primitive));
                            phi_1318_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e706.unnamed, lt_bvh_traverse_Tree(_e706.unnamed_1.root, _e683.y));
                        } else {
                            let _e722 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e683.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e728 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e722.unnamed.root, _e683.y), _e722.unnamed_1);
                            let _e734 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e728.unnamed, lt_bvh_traverse_Tree(_e683.z, _e728.unnamed_1.first_primitive));
                            phi_1318_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e734.unnamed, lt_bvh_traverse_Tree(_e734.unnamed_1.root, _e683.w));
                        }
                        let _e742 = phi_1318_;
                        let _e752 = nodes.member[(0u + _e547)].z;
                        if (_e351 < 0f) {
                            let _e763 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e752.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e769 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e763.unnamed.root, _e752.w), _e763.unnamed_1);
                            let _e775 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e769.unnamed, lt_bvh_traverse_Tree(_e752.x, _e769.unnamed_1.first_primitive));
                            phi_1345_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e775.unnamed, lt_bvh_traverse_Tree(_e775.unnamed_1.root, _e752.y));
                        } else {
                            let _e791 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e752.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e797 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e791.unnamed.root, _e752.y), _e791.unnamed_1);
                            let _e803 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e797.unnamed, lt_bvh_traverse_Tree(_e752.z, _e797.unnamed_1.first_primitive));
                            phi_1345_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e803.unnamed, lt_bvh_traverse_Tree(_e803.unnamed_1.root, _e752.w));
                        }
                        let _e811 = phi_1345_;
                        phi_1351_ = 0u;
                        phi_1354_ = 0u;
                        loop {
                            let _e821 = phi_1351_;
                            let _e823 = phi_1354_;
                            local_3 = _e823;
                            local_4 = _e823;
                            local_5 = _e823;
                            let _e824 = (_e821 < 8u);
                            if _e824 {
                                let _e826 = (_e821 >> bitcast<u32>(2i));
                                let _e827 = (_e821 & 3u);
                                if (_e826 == 0u) {
                                    phi_1368_ = _e673.unnamed.root;
                                } else {
                                    phi_1368_ = _e673.unnamed.first_primitive;
                                }
                                let _e830 = phi_1368_;
                                if (_e826 == 0u) {
                                    phi_1378_ = _e742.unnamed.root;
                                } else {
                                    phi_1378_ = _e742.unnamed.first_primitive;
                                }
                                let _e839 = phi_1378_;
                                if (_e826 == 0u) {
                                    phi_1388_ = _e811.unnamed.root;
                                } else {
                                    phi_1388_ = _e811.unnamed.first_primitive;
                                }
                                let _e848 = phi_1388_;
                                let _e861 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e830 >> bitcast<u32>(((_e827 * 8u) & 31u))) & 255u)) * _e583) + (_e604 - _e389)), ((f32(((_e839 >> bitcast<u32>(((_e827 * 8u) & 31u))) & 255u)) * _e584) + (_e605 - _e390)));
                                let _e862 = core_intrinsics_maximum_number_nsz_f32_(_e861, ((f32(((_e848 >> bitcast<u32>(((_e827 * 8u) & 31u))) & 255u)) * _e585) + (_e606 - _e391)));
                                if (_e826 == 0u) {
                                    phi_1406_ = _e673.unnamed_1.root;
                                } else {
                                    phi_1406_ = _e673.unnamed_1.first_primitive;
                                }
                                let _e865 = phi_1406_;
                                if (_e826 == 0u) {
                                    phi_1416_ = _e742.unnamed_1.root;
                                } else {
                                    phi_1416_ = _e742.unnamed_1.first_primitive;
                                }
                                let _e874 = phi_1416_;
                                if (_e826 == 0u) {
                                    phi_1426_ = _e811.unnamed_1.root;
                                } else {
                                    phi_1426_ = _e811.unnamed_1.first_primitive;
                                }
                                let _e883 = phi_1426_;
                                let _e896 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e865 >> bitcast<u32>(((_e827 * 8u) & 31u))) & 255u)) * _e583) + (_e604 + _e389)), ((f32(((_e874 >> bitcast<u32>(((_e827 * 8u) & 31u))) & 255u)) * _e584) + (_e605 + _e390)));
                                let _e897 = core_intrinsics_minimum_number_nsz_f32_(_e896, ((f32(((_e883 >> bitcast<u32>(((_e827 * 8u) & 31u))) & 255u)) * _e585) + (_e606 + _e391)));
                                if (_e862 <= _e897) {
                                    if (_e862 <= _e549.t) {
                                        if (_e897 >= _e183.tmin) {
                                            if (_e826 == 0u) {
                                                let _e904 = nodes.member[(0u + _e547)].links[2u];
                                                phi_1462_ = _e904;
                                            } else {
                                                let _e907 = nodes.member[(0u + _e547)].links[3u];
                                                phi_1462_ = _e907;
                                            }
                                            let _e909 = phi_1462_;
                                            let _e914 = ((_e909 >> bitcast<u32>(((_e827 * 8u) & 31u))) & 255u);
                                            let _e915 = (_e914 & 31u);
                                            if (_e915 >= 24u) {
                                                phi_1475_ = (24u + ((_e915 - 24u) ^ _e409));
                                            } else {
                                                phi_1475_ = _e915;
                                            }
                                            let _e921 = phi_1475_;
                                            phi_1480_ = (_e823 | ((_e914 >> bitcast<u32>(5i)) << bitcast<u32>((_e921 & 31u))));
                                        } else {
                                            phi_1480_ = _e823;
                                        }
                                        let _e929 = phi_1480_;
                                        phi_1481_ = _e929;
                                    } else {
                                        phi_1481_ = _e823;
                                    }
                                    let _e931 = phi_1481_;
                                    phi_1482_ = _e931;
                                } else {
                                    phi_1482_ = _e823;
                                }
                                let _e933 = phi_1482_;
                                phi_1352_ = (_e821 + 1u);
                                phi_1355_ = _e933;
                            } else {
                                phi_1352_ = u32();
                                phi_1355_ = u32();
                            }
                            let _e936 = phi_1352_;
                            let _e938 = phi_1355_;
                            continue;
                            continuing {
                                phi_1351_ = _e936;
                                phi_1354_ = _e938;
                                break if !(_e824);
                            }
                        }
                        let _e942 = nodes.member[(0u + _e547)].links[0u];
                        let _e946 = nodes.member[(0u + _e547)].frame[3u];
                        let _e950 = local_3;
                        if ((_e950 & 4278190080u) == 0u) {
                        } else {
                            let _e954 = local_2.group_mask;
                            if ((_e954 & 4278190080u) == 0u) {
                            } else {
                                let _e958 = local_2.len;
                                if (_e958 < 32u) {
                                    let _e961 = local_2.group;
                                    let _e963 = local_2.len;
                                    if (_e963 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.first[(0u + _e963)] = _e961;
                                    let _e969 = local_2.group_mask;
                                    let _e971 = local_2.len;
                                    if (_e971 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.mask[(0u + _e971)] = _e969;
                                    let _e978 = local_2.len;
                                    local_2.len = (_e978 + 1u);
                                }
                            }
                            local_2.group = (_e115 + _e942);
                            let _e982 = local_4;
                            local_2.group_mask = ((_e982 & 4278190080u) | (_e946 >> bitcast<u32>(24i)));
                        }
                        let _e987 = local_5;
                        phi_1540_ = (_e987 & 16777215u);
                        phi_1543_ = _e549;
                        loop {
                            let _e990 = phi_1540_;
                            let _e992 = phi_1543_;
                            local_11 = _e992;
                            if (_e990 == 0u) {
                                phi_1541_ = u32();
                                phi_1544_ = lt_bvh_Hit();
                                phi_3430_ = false;
                            } else {
                                let _e996 = nodes.member[(0u + _e547)].links[1u];
                                let _e1000 = (_e996 + select(firstTrailingBit(_e990), 32u, (_e990 == 0u)));
                                if (_e1000 < _e94) {
                                } else {
                                    return;
                                }
                                let _e1007 = instances.member[(0u + _e1000)].low_world;
                                let _e1009 = instances.member[(0u + _e1000)].high_world;
                                let _e1019 = ((_e1007.x - _e183.origin.x) * _e329);
                                let _e1020 = ((_e1007.y - _e183.origin.y) * _e340);
                                let _e1021 = ((_e1007.z - _e183.origin.z) * _e351);
                                let _e1031 = ((_e1009.x - _e183.origin.x) * _e329);
                                let _e1032 = ((_e1009.y - _e183.origin.y) * _e340);
                                let _e1033 = ((_e1009.z - _e183.origin.z) * _e351);
                                if (_e1019 < _e1031) {
                                    phi_1598_ = _e1019;
                                } else {
                                    phi_1598_ = _e1031;
                                }
                                let _e1036 = phi_1598_;
                                if (_e1020 < _e1032) {
                                    phi_1603_ = _e1020;
                                } else {
                                    phi_1603_ = _e1032;
                                }
                                let _e1039 = phi_1603_;
                                if (_e1021 < _e1033) {
                                    phi_1608_ = _e1021;
                                } else {
                                    phi_1608_ = _e1033;
                                }
                                let _e1042 = phi_1608_;
                                if (_e1019 > _e1031) {
                                    phi_1616_ = _e1019;
                                } else {
                                    phi_1616_ = _e1031;
                                }
                                let _e1048 = phi_1616_;
                                if (_e1020 > _e1032) {
                                    phi_1621_ = _e1020;
                                } else {
                                    phi_1621_ = _e1032;
                                }
                                let _e1051 = phi_1621_;
                                if (_e1021 > _e1033) {
                                    phi_1626_ = _e1021;
                                } else {
                                    phi_1626_ = _e1033;
                                }
                                let _e1054 = phi_1626_;
                                let _e1058 = core_intrinsics_maximum_number_nsz_f32_((_e1036 - _e396), (_e1039 - _e397));
                                let _e1059 = core_intrinsics_maximum_number_nsz_f32_(_e1058, (_e1042 - _e398));
                                let _e1060 = core_intrinsics_minimum_number_nsz_f32_((_e1048 + _e396), (_e1051 + _e397));
                                let _e1061 = core_intrinsics_minimum_number_nsz_f32_(_e1060, (_e1054 + _e398));
                                if (_e1059 <= _e1061) {
                                    if (_e1059 <= _e992.t) {
                                        if (_e1061 >= _e183.tmin) {
                                            let _e1073 = instances.member[(0u + _e1000)].world_to_object[0u];
                                            let _e1084 = ((((_e1073.x * _e183.origin.x) + (_e1073.y * _e183.origin.y)) + (_e1073.z * _e183.origin.z)) + (_e1073.w * 1f));
                                            let _e1086 = instances.member[(0u + _e1000)].world_to_object[1u];
                                            let _e1097 = ((((_e1086.x * _e183.origin.x) + (_e1086.y * _e183.origin.y)) + (_e1086.z * _e183.origin.z)) + (_e1086.w * 1f));
                                            let _e1099 = instances.member[(0u + _e1000)].world_to_object[2u];
                                            let _e1110 = ((((_e1099.x * _e183.origin.x) + (_e1099.y * _e183.origin.y)) + (_e1099.z * _e183.origin.z)) + (_e1099.w * 1f));
                                            let _e1117 = instances.member[(0u + _e1000)].world_to_object[0u];
                                            let _e1128 = ((((_e1117.x * _e183.direction.x) + (_e1117.y * _e183.direction.y)) + (_e1117.z * _e183.direction.z)) + (_e1117.w * 0f));
                                            let _e1130 = instances.member[(0u + _e1000)].world_to_object[1u];
                                            let _e1141 = ((((_e1130.x * _e183.direction.x) + (_e1130.y * _e183.direction.y)) + (_e1130.z * _e183.direction.z)) + (_e1130.w * 0f));
                                            let _e1143 = instances.member[(0u + _e1000)].world_to_object[2u];
                                            let _e1154 = ((((_e1143.x * _e183.direction.x) + (_e1143.y * _e183.direction.y)) + (_e1143.z * _e183.direction.z)) + (_e1143.w * 0f));
                                            let _e1159 = instances.member[(0u + _e1000)].root;
                                            let _e1161 = instances.member[(0u + _e1000)].first_triangle;
                                            let _e1162 = abs(_e1128);
                                            let _e1163 = abs(_e1141);
                                            let _e1164 = abs(_e1154);
                                            if (abs(_e1084) < 1000000000000000f) {
                                                if (abs(_e1097) < 1000000000000000f) {
                                                    phi_1758_ = (abs(_e1110) < 1000000000000000f);
                                                    phi_1759_ = false;
                                                } else {
                                                    phi_1758_ = bool();
                                                    phi_1759_ = true;
                                                }
                                                let _e1172 = phi_1758_;
                                                let _e1174 = phi_1759_;
                                                phi_1760_ = _e1172;
                                                phi_1761_ = _e1174;
                                            } else {
                                                phi_1760_ = bool();
                                                phi_1761_ = true;
                                            }
                                            let _e1176 = phi_1760_;
                                            let _e1178 = phi_1761_;
                                            if _e1178 {
                                                phi_1765_ = false;
                                            } else {
                                                phi_1765_ = _e1176;
                                            }
                                            let _e1180 = phi_1765_;
                                            if _e1180 {
                                                if (_e1162 < 1000000000000000f) {
                                                    if (_e1163 < 1000000000000000f) {
                                                        phi_1778_ = (_e1164 < 1000000000000000f);
                                                        phi_1779_ = false;
                                                    } else {
                                                        phi_1778_ = bool();
                                                        phi_1779_ = true;
                                                    }
                                                    let _e1185 = phi_1778_;
                                                    let _e1187 = phi_1779_;
                                                    phi_1780_ = _e1185;
                                                    phi_1781_ = _e1187;
                                                } else {
                                                    phi_1780_ = bool();
                                                    phi_1781_ = true;
                                                }
                                                let _e1189 = phi_1780_;
                                                let _e1191 = phi_1781_;
                                                if _e1191 {
                                                    phi_1785_ = false;
                                                } else {
                                                    phi_1785_ = _e1189;
                                                }
                                                let _e1193 = phi_1785_;
                                                if _e1193 {
                                                    if (_e1162 > 0f) {
                                                        phi_1799_ = bool();
                                                        phi_1800_ = true;
                                                    } else {
                                                        let _e1195 = (_e1163 > 0f);
                                                        if _e1195 {
                                                            phi_1798_ = bool();
                                                        } else {
                                                            phi_1798_ = (_e1164 > 0f);
                                                        }
                                                        let _e1198 = phi_1798_;
                                                        phi_1799_ = _e1198;
                                                        phi_1800_ = _e1195;
                                                    }
                                                    let _e1200 = phi_1799_;
                                                    let _e1202 = phi_1800_;
                                                    if _e1202 {
                                                        phi_1804_ = true;
                                                    } else {
                                                        phi_1804_ = _e1200;
                                                    }
                                                    let _e1204 = phi_1804_;
                                                    phi_1805_ = _e1204;
                                                    phi_1806_ = false;
                                                } else {
                                                    phi_1805_ = bool();
                                                    phi_1806_ = true;
                                                }
                                                let _e1206 = phi_1805_;
                                                let _e1208 = phi_1806_;
                                                phi_1807_ = _e1206;
                                                phi_1808_ = _e1208;
                                            } else {
                                                phi_1807_ = bool();
                                                phi_1808_ = true;
                                            }
                                            let _e1210 = phi_1807_;
                                            let _e1212 = phi_1808_;
                                            if _e1212 {
                                                phi_1812_ = false;
                                            } else {
                                                phi_1812_ = _e1210;
                                            }
                                            let _e1214 = phi_1812_;
                                            if _e1214 {
                                                let _e1215 = (_e1159 >= _e79);
                                                if _e1215 {
                                                    phi_3420_ = lt_bvh_Hit();
                                                } else {
                                                    if (_e1159 < _e79) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1221 = nodes.member[(0u + _e1159)].frame[0u];
                                                    let _e1225 = nodes.member[(0u + _e1159)].frame[1u];
                                                    let _e1229 = nodes.member[(0u + _e1159)].frame[2u];
                                                    let _e1233 = nodes.member[(0u + _e1159)].frame[0u];
                                                    let _e1237 = nodes.member[(0u + _e1159)].frame[1u];
                                                    let _e1241 = nodes.member[(0u + _e1159)].frame[2u];
                                                    let _e1245 = nodes.member[(0u + _e1159)].frame[3u];
                                                    let _e1279 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1128), abs(_e1141));
                                                    let _e1280 = core_intrinsics_maximum_number_nsz_f32_(_e1279, abs(_e1154));
                                                    let _e1281 = (_e1280 * 0.0000000000009094947f);
                                                    if (abs(_e1128) < _e1281) {
                                                        phi_1882_ = _e1281;
                                                    } else {
                                                        phi_1882_ = abs(_e1128);
                                                    }
                                                    let _e1286 = phi_1882_;
                                                    if (_e1128 < 0f) {
                                                        phi_1889_ = (-1f / _e1286);
                                                    } else {
                                                        phi_1889_ = (1f / _e1286);
                                                    }
                                                    let _e1291 = phi_1889_;
                                                    if (abs(_e1141) < _e1281) {
                                                        phi_1896_ = _e1281;
                                                    } else {
                                                        phi_1896_ = abs(_e1141);
                                                    }
                                                    let _e1296 = phi_1896_;
                                                    if (_e1141 < 0f) {
                                                        phi_1903_ = (-1f / _e1296);
                                                    } else {
                                                        phi_1903_ = (1f / _e1296);
                                                    }
                                                    let _e1301 = phi_1903_;
                                                    if (abs(_e1154) < _e1281) {
                                                        phi_1910_ = _e1281;
                                                    } else {
                                                        phi_1910_ = abs(_e1154);
                                                    }
                                                    let _e1306 = phi_1910_;
                                                    if (_e1154 < 0f) {
                                                        phi_1917_ = (-1f / _e1306);
                                                    } else {
                                                        phi_1917_ = (1f / _e1306);
                                                    }
                                                    let _e1311 = phi_1917_;
                                                    let _e1315 = abs((bitcast<f32>(_e1221) - _e1084));
                                                    let _e1316 = abs((bitcast<f32>(_e1225) - _e1097));
                                                    let _e1317 = abs((bitcast<f32>(_e1229) - _e1110));
                                                    let _e1321 = abs(((bitcast<f32>(_e1233) + (bitcast<f32>((((_e1245 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1084));
                                                    let _e1322 = abs(((bitcast<f32>(_e1237) + (bitcast<f32>((((_e1245 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1097));
                                                    let _e1323 = abs(((bitcast<f32>(_e1241) + (bitcast<f32>((((_e1245 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1110));
                                                    if (_e1315 > _e1321) {
                                                        phi_1934_ = _e1315;
                                                    } else {
                                                        phi_1934_ = _e1321;
                                                    }
                                                    let _e1326 = phi_1934_;
                                                    if (_e1316 > _e1322) {
                                                        phi_1939_ = _e1316;
                                                    } else {
                                                        phi_1939_ = _e1322;
                                                    }
                                                    let _e1329 = phi_1939_;
                                                    if (_e1317 > _e1323) {
                                                        phi_1944_ = _e1317;
                                                    } else {
                                                        phi_1944_ = _e1323;
                                                    }
                                                    let _e1332 = phi_1944_;
                                                    if (_e1326 > _e1329) {
                                                        phi_1949_ = _e1326;
                                                    } else {
                                                        phi_1949_ = _e1329;
                                                    }
                                                    let _e1335 = phi_1949_;
                                                    if (_e1335 > _e1332) {
                                                        phi_1954_ = _e1335;
                                                    } else {
                                                        phi_1954_ = _e1332;
                                                    }
                                                    let _e1338 = phi_1954_;
                                                    let _e1342 = (_e1338 * 0.0000019073486f);
                                                    let _e1343 = (abs(_e1291) * _e1342);
                                                    let _e1344 = (abs(_e1301) * _e1342);
                                                    let _e1345 = (abs(_e1311) * _e1342);
                                                    let _e1349 = (_e1338 * 0.0000009536743f);
                                                    let _e1350 = (abs(_e1291) * _e1349);
                                                    let _e1351 = (abs(_e1301) * _e1349);
                                                    let _e1352 = (abs(_e1311) * _e1349);
                                                    let _e1353 = abs(_e1128);
                                                    let _e1354 = abs(_e1141);
                                                    let _e1355 = abs(_e1154);
                                                    if (_e1353 >= _e1354) {
                                                        if (_e1353 >= _e1355) {
                                                            phi_1980_ = false;
                                                        } else {
                                                            phi_1980_ = true;
                                                        }
                                                        let _e1359 = phi_1980_;
                                                        phi_1981_ = _e1359;
                                                    } else {
                                                        phi_1981_ = true;
                                                    }
                                                    let _e1361 = phi_1981_;
                                                    if _e1361 {
                                                        if (_e1354 >= _e1355) {
                                                            phi_1989_ = 1u;
                                                        } else {
                                                            phi_1989_ = 2u;
                                                        }
                                                        let _e1364 = phi_1989_;
                                                        phi_1990_ = _e1364;
                                                    } else {
                                                        phi_1990_ = 0u;
                                                    }
                                                    let _e1366 = phi_1990_;
                                                    if (_e1366 == 0u) {
                                                        phi_2002_ = vec3<f32>(_e1141, _e1154, _e1128);
                                                    } else {
                                                        if (_e1366 == 1u) {
                                                            phi_2001_ = vec3<f32>(_e1154, _e1128, _e1141);
                                                        } else {
                                                            phi_2001_ = vec3<f32>(_e1128, _e1141, _e1154);
                                                        }
                                                        let _e1372 = phi_2001_;
                                                        phi_2002_ = _e1372;
                                                    }
                                                    let _e1374 = phi_2002_;
                                                    let _e1377 = (_e1374.x / _e1374.z);
                                                    let _e1380 = (_e1374.y / _e1374.z);
                                                    if (_e1291 < 0f) {
                                                        phi_2015_ = 0u;
                                                    } else {
                                                        phi_2015_ = 1u;
                                                    }
                                                    let _e1385 = phi_2015_;
                                                    if (_e1301 < 0f) {
                                                        phi_2020_ = 0u;
                                                    } else {
                                                        phi_2020_ = 2u;
                                                    }
                                                    let _e1388 = phi_2020_;
                                                    if (_e1311 < 0f) {
                                                        phi_2025_ = 0u;
                                                    } else {
                                                        phi_2025_ = 4u;
                                                    }
                                                    let _e1391 = phi_2025_;
                                                    let _e1393 = ((_e1385 | _e1388) | _e1391);
                                                    let _e1394 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1159, 2147483648u);
                                                    local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e1394.first[0], _e1394.first[1], _e1394.first[2], _e1394.first[3], _e1394.first[4], _e1394.first[5], _e1394.first[6], _e1394.first[7], _e1394.first[8], _e1394.first[9], _e1394.first[10], _e1394.first[11], _e1394.first[12], _e1394.first[13], _e1394.first[14], _e1394.first[15], _e1394.first[16], _e1394.first[17], _e1394.first[18], _e1394.first[19], _e1394.first[20], _e1394.first[21], _e1394.first[22], _e1394.first[23], _e1394.first[24], _e1394.first[25], _e1394.first[26], _e1394.first[27], _e1394.first[28], _e1394.first[29], _e1394.first[30], _e1394.first[31]), array<u32, 32>(_e1394.mask[0], _e1394.mask[1], _e1394.mask[2], _e1394.mask[3], _e1394.mask[4], _e1394.mask[5], _e1394.mask[6], _e1394.mask[7], _e1394.mask[8], _e1394.mask[9], _e1394.mask[10], _e1394.mask[11], _e1394.mask[12], _e1394.mask[13], _e1394.mask[14], _e1394.mask[15], _e1394.mask[16], _e1394.mask[17], _e1394.mask[18], _e1394.mask[19], _e1394.mask[20], _e1394.mask[21], _e1394.mask[22], _e1394.mask[23], _e1394.mask[24], _e1394.mask[25], _e1394.mask[26], _e1394.mask[27], _e1394.mask[28], _e1394.mask[29], _e1394.mask[30], _e1394.mask[31]), _e1394.len, _e1394.group, _e1394.group_mask);
                                                    let _e1468 = local_1.group_mask;
                                                    if ((_e1468 & 4278190080u) == 0u) {
                                                        let _e1472 = local_1.len;
                                                        if (_e1472 == 0u) {
                                                            phi_2139_ = false;
                                                        } else {
                                                            let _e1476 = local_1.len;
                                                            local_1.len = (_e1476 - 1u);
                                                            let _e1479 = local_1.len;
                                                            if (_e1479 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1484 = local_1.first[(0u + _e1479)];
                                                            local_1.group = _e1484;
                                                            let _e1487 = local_1.len;
                                                            if (_e1487 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1492 = local_1.mask[(0u + _e1487)];
                                                            local_1.group_mask = _e1492;
                                                            phi_2139_ = true;
                                                        }
                                                        let _e1495 = phi_2139_;
                                                        phi_2140_ = _e1495;
                                                    } else {
                                                        phi_2140_ = true;
                                                    }
                                                    let _e1497 = phi_2140_;
                                                    if _e1497 {
                                                        let _e1499 = local_1.group_mask;
                                                        let _e1505 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1499)), 32u, (_e1499 == 0u)));
                                                        let _e1509 = local_1.group_mask;
                                                        let _e1523 = local_1.group_mask;
                                                        local_1.group_mask = (_e1523 & ~((1u << bitcast<u32>((_e1505 & 31u)))));
                                                        let _e1526 = local_1.group;
                                                        phi_2171_ = (_e1526 + countOneBits(((_e1509 & ~((4294967295u << bitcast<u32>((((_e1505 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_2171_ = 4294967295u;
                                                    }
                                                    let _e1529 = phi_2171_;
                                                    phi_2173_ = _e992;
                                                    phi_2176_ = _e1529;
                                                    loop {
                                                        let _e1531 = phi_2173_;
                                                        let _e1533 = phi_2176_;
                                                        local_10 = _e1531;
                                                        let _e1534 = (_e1533 != 4294967295u);
                                                        if _e1534 {
                                                            if (_e1533 < _e79) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1541 = nodes.member[(0u + _e1533)].frame[3u];
                                                            let _e1566 = (bitcast<f32>((((_e1541 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1291);
                                                            let _e1567 = (bitcast<f32>((((_e1541 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1301);
                                                            let _e1568 = (bitcast<f32>((((_e1541 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1311);
                                                            let _e1571 = nodes.member[(0u + _e1533)].frame[0u];
                                                            let _e1575 = nodes.member[(0u + _e1533)].frame[1u];
                                                            let _e1579 = nodes.member[(0u + _e1533)].frame[2u];
                                                            let _e1584 = ((bitcast<f32>(_e1571) - _e1084) * _e1291);
                                                            let _e1585 = ((bitcast<f32>(_e1575) - _e1097) * _e1301);
                                                            let _e1586 = ((bitcast<f32>(_e1579) - _e1110) * _e1311);
                                                            let _e1594 = nodes.member[(0u + _e1533)].x;
                                                            if (_e1291 < 0f) {
                                                                let _e1605 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1594.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1611 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1605.unnamed.root, _e1594.w), _e1605.unnamed_1);
                                                                let _e1617 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1611.unnamed, lt_bvh_traverse_Tree(_e1594.x, _e1611.unnamed_1.first_primitive));
                                                                phi_2257_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1617.unnamed, lt_bvh_traverse_Tree(_e1617.unnamed_1.root, _e1594.y));
                                                            } else {
                                                                let _e1633 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1594.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1639 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1633.unnamed.root, _e1594.y), _e1633.unnamed_1);
                                                                let _e1645 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1639.unnamed, lt_bvh_traverse_Tree(_e1594.z, _e1639.unnamed_1.first_primitive));
                                                                phi_2257_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1645.unnamed, lt_bvh_traverse_Tree(_e1645.unnamed_1.root, _e1594.w));
                                                            }
                                                            let _e1653 = phi_2257_;
                                                            let _e1663 = nodes.member[(0u + _e1533)].y;
                                                            if (_e1301 < 0f) {
                                                                let _e1674 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1663.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1680 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1674.unnamed.root, _e1663.w), _e1674.unnamed_1);
                                                                let _e1686 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1680.unnamed, lt_bvh_traverse_Tree(_e1663.x, _e1680.unnamed_1.first_primitive));
                                                                phi_2284_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1686.unnamed, lt_bvh_traverse_Tree(_e1686.unnamed_1.root, _e1663.y));
                                                            } else {
                                                                let _e1702 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1663.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1708 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1702.unnamed.root, _e1663.y), _e1702.unnamed_1);
                                                                let _e1714 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1708.unnamed, lt_bvh_traverse_Tree(_e1663.z, _e1708.unnamed_1.first_primitive));
                                                                phi_2284_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1714.unnamed, lt_bvh_traverse_Tree(_e1714.unnamed_1.root, _e1663.w));
                                                            }
                                                            let _e1722 = phi_2284_;
                                                            let _e1732 = nodes.member[(0u + _e1533)].z;
                                                            if (_e1311 < 0f) {
                                                                let _e1743 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1732.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1749 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1743.unnamed.root, _e1732.w), _e1743.unnamed_1);
                                                                let _e1755 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1749.unnamed, lt_bvh_traverse_Tree(_e1732.x, _e1749.unnamed_1.first_primitive));
                                                                phi_2311_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1755.unnamed, lt_bvh_traverse_Tree(_e1755.unnamed_1.root, _e1732.y));
                                                            } else {
                                                                let _e1771 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1732.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1777 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1771.unnamed.root, _e1732.y), _e1771.unnamed_1);
                                                                let _e1783 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1777.unnamed, lt_bvh_traverse_Tree(_e1732.z, _e1777.unnamed_1.first_primitive));
                                                                phi_2311_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1783.unnamed, lt_bvh_traverse_Tree(_e1783.unnamed_1.root, _e1732.w));
                                                            }
                                                            let _e1791 = phi_2311_;
                                                            phi_2317_ = 0u;
                                                            phi_2320_ = 0u;
                                                            loop {
                                                                let _e1801 = phi_2317_;
                                                                let _e1803 = phi_2320_;
                                                                local_6 = _e1803;
                                                                local_7 = _e1803;
                                                                local_8 = _e1803;
                                                                let _e1804 = (_e1801 < 8u);
                                                                if _e1804 {
                                                                    let _e1806 = (_e1801 >> bitcast<u32>(2i));
                                                                    let _e1807 = (_e1801 & 3u);
                                                                    if (_e1806 == 0u) {
                                                                        phi_2334_ = _e1653.unnamed.root;
                                                                    } else {
                                                                        phi_2334_ = _e1653.unnamed.first_primitive;
                                                                    }
                                                                    let _e1810 = phi_2334_;
                                                                    if (_e1806 == 0u) {
                                                                        phi_2344_ = _e1722.unnamed.root;
                                                                    } else {
                                                                        phi_2344_ = _e1722.unnamed.first_primitive;
                                                                    }
                                                                    let _e1819 = phi_2344_;
                                                                    if (_e1806 == 0u) {
                                                                        phi_2354_ = _e1791.unnamed.root;
                                                                    } else {
                                                                        phi_2354_ = _e1791.unnamed.first_primitive;
                                                                    }
                                                                    let _e1828 = phi_2354_;
                                                                    let _e1841 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1810 >> bitcast<u32>(((_e1807 * 8u) & 31u))) & 255u)) * _e1566) + (_e1584 - _e1343)), ((f32(((_e1819 >> bitcast<u32>(((_e1807 * 8u) & 31u))) & 255u)) * _e1567) + (_e1585 - _e1344)));
                                                                    let _e1842 = core_intrinsics_maximum_number_nsz_f32_(_e1841, ((f32(((_e1828 >> bitcast<u32>(((_e1807 * 8u) & 31u))) & 255u)) * _e1568) + (_e1586 - _e1345)));
                                                                    if (_e1806 == 0u) {
                                                                        phi_2372_ = _e1653.unnamed_1.root;
                                                                    } else {
                                                                        phi_2372_ = _e1653.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1845 = phi_2372_;
                                                                    if (_e1806 == 0u) {
                                                                        phi_2382_ = _e1722.unnamed_1.root;
                                                                    } else {
                                                                        phi_2382_ = _e1722.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1854 = phi_2382_;
                                                                    if (_e1806 == 0u) {
                                                                        phi_2392_ = _e1791.unnamed_1.root;
                                                                    } else {
                                                                        phi_2392_ = _e1791.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1863 = phi_2392_;
                                                                    let _e1876 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1845 >> bitcast<u32>(((_e1807 * 8u) & 31u))) & 255u)) * _e1566) + (_e1584 + _e1343)), ((f32(((_e1854 >> bitcast<u32>(((_e1807 * 8u) & 31u))) & 255u)) * _e1567) + (_e1585 + _e1344)));
                                                                    let _e1877 = core_intrinsics_minimum_number_nsz_f32_(_e1876, ((f32(((_e1863 >> bitcast<u32>(((_e1807 * 8u) & 31u))) & 255u)) * _e1568) + (_e1586 + _e1345)));
                                                                    if (_e1842 <= _e1877) {
                                                                        if (_e1842 <= _e1531.t) {
                                                                            if (_e1877 >= _e183.tmin) {
                                                                                if (_e1806 == 0u) {
                                                                                    let _e1884 = nodes.member[(0u + _e1533)].links[2u];
                                                                                    phi_2428_ = _e1884;
                                                                                } else {
                                                                                    let _e1887 = nodes.member[(0u + _e1533)].links[3u];
                                                                                    phi_2428_ = _e1887;
                                                                                }
                                                                                let _e1889 = phi_2428_;
                                                                                let _e1894 = ((_e1889 >> bitcast<u32>(((_e1807 * 8u) & 31u))) & 255u);
                                                                                let _e1895 = (_e1894 & 31u);
                                                                                if (_e1895 >= 24u) {
                                                                                    phi_2441_ = (24u + ((_e1895 - 24u) ^ _e1393));
                                                                                } else {
                                                                                    phi_2441_ = _e1895;
                                                                                }
                                                                                let _e1901 = phi_2441_;
                                                                                phi_2446_ = (_e1803 | ((_e1894 >> bitcast<u32>(5i)) << bitcast<u32>((_e1901 & 31u))));
                                                                            } else {
                                                                                phi_2446_ = _e1803;
                                                                            }
                                                                            let _e1909 = phi_2446_;
                                                                            phi_2447_ = _e1909;
                                                                        } else {
                                                                            phi_2447_ = _e1803;
                                                                        }
                                                                        let _e1911 = phi_2447_;
                                                                        phi_2448_ = _e1911;
                                                                    } else {
                                                                        phi_2448_ = _e1803;
                                                                    }
                                                                    let _e1913 = phi_2448_;
                                                                    phi_2318_ = (_e1801 + 1u);
                                                                    phi_2321_ = _e1913;
                                                                } else {
                                                                    phi_2318_ = u32();
                                                                    phi_2321_ = u32();
                                                                }
                                                                let _e1916 = phi_2318_;
                                                                let _e1918 = phi_2321_;
                                                                continue;
                                                                continuing {
                                                                    phi_2317_ = _e1916;
                                                                    phi_2320_ = _e1918;
                                                                    break if !(_e1804);
                                                                }
                                                            }
                                                            let _e1922 = nodes.member[(0u + _e1533)].links[0u];
                                                            let _e1926 = nodes.member[(0u + _e1533)].frame[3u];
                                                            let _e1930 = local_6;
                                                            if ((_e1930 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1934 = local_1.group_mask;
                                                                if ((_e1934 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1938 = local_1.len;
                                                                    if (_e1938 < 32u) {
                                                                        let _e1941 = local_1.group;
                                                                        let _e1943 = local_1.len;
                                                                        if (_e1943 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.first[(0u + _e1943)] = _e1941;
                                                                        let _e1949 = local_1.group_mask;
                                                                        let _e1951 = local_1.len;
                                                                        if (_e1951 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.mask[(0u + _e1951)] = _e1949;
                                                                        let _e1958 = local_1.len;
                                                                        local_1.len = (_e1958 + 1u);
                                                                    }
                                                                }
                                                                local_1.group = (_e1159 + _e1922);
                                                                let _e1962 = local_7;
                                                                local_1.group_mask = ((_e1962 & 4278190080u) | (_e1926 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1967 = local_8;
                                                            phi_2506_ = _e1531;
                                                            phi_2509_ = (_e1967 & 16777215u);
                                                            loop {
                                                                let _e1970 = phi_2506_;
                                                                let _e1972 = phi_2509_;
                                                                local_9 = _e1970;
                                                                if (_e1972 == 0u) {
                                                                    phi_2507_ = lt_bvh_Hit();
                                                                    phi_2510_ = u32();
                                                                    phi_3348_ = false;
                                                                } else {
                                                                    let _e1976 = nodes.member[(0u + _e1533)].links[1u];
                                                                    let _e1981 = ((_e1161 + _e1976) + select(firstTrailingBit(_e1972), 32u, (_e1972 == 0u)));
                                                                    if (_e1981 < _e82) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1988 = triangles.member[(0u + _e1981)].v0_;
                                                                    let _e1990 = (_e1988.x - _e1084);
                                                                    let _e1992 = (_e1988.y - _e1097);
                                                                    let _e1994 = (_e1988.z - _e1110);
                                                                    if (_e1366 == 0u) {
                                                                        phi_2554_ = vec3<f32>(_e1992, _e1994, _e1990);
                                                                    } else {
                                                                        if (_e1366 == 1u) {
                                                                            phi_2553_ = vec3<f32>(_e1994, _e1990, _e1992);
                                                                        } else {
                                                                            phi_2553_ = (_e1988 - vec3<f32>(_e1084, _e1097, _e1110));
                                                                        }
                                                                        let _e2002 = phi_2553_;
                                                                        phi_2554_ = _e2002;
                                                                    }
                                                                    let _e2004 = phi_2554_;
                                                                    let _e2008 = (_e2004.x - (_e1377 * _e2004.z));
                                                                    let _e2012 = (_e2004.y - (_e1380 * _e2004.z));
                                                                    let _e2014 = triangles.member[(0u + _e1981)].v1_;
                                                                    let _e2016 = (_e2014.x - _e1084);
                                                                    let _e2018 = (_e2014.y - _e1097);
                                                                    let _e2020 = (_e2014.z - _e1110);
                                                                    if (_e1366 == 0u) {
                                                                        phi_2584_ = vec3<f32>(_e2018, _e2020, _e2016);
                                                                    } else {
                                                                        if (_e1366 == 1u) {
                                                                            phi_2583_ = vec3<f32>(_e2020, _e2016, _e2018);
                                                                        } else {
                                                                            phi_2583_ = (_e2014 - vec3<f32>(_e1084, _e1097, _e1110));
                                                                        }
                                                                        let _e2028 = phi_2583_;
                                                                        phi_2584_ = _e2028;
                                                                    }
                                                                    let _e2030 = phi_2584_;
                                                                    let _e2034 = (_e2030.x - (_e1377 * _e2030.z));
                                                                    let _e2038 = (_e2030.y - (_e1380 * _e2030.z));
                                                                    let _e2040 = triangles.member[(0u + _e1981)].v2_;
                                                                    let _e2042 = (_e2040.x - _e1084);
                                                                    let _e2044 = (_e2040.y - _e1097);
                                                                    let _e2046 = (_e2040.z - _e1110);
                                                                    if (_e1366 == 0u) {
                                                                        phi_2614_ = vec3<f32>(_e2044, _e2046, _e2042);
                                                                    } else {
                                                                        if (_e1366 == 1u) {
                                                                            phi_2613_ = vec3<f32>(_e2046, _e2042, _e2044);
                                                                        } else {
                                                                            phi_2613_ = (_e2040 - vec3<f32>(_e1084, _e1097, _e1110));
                                                                        }
                                                                        let _e2054 = phi_2613_;
                                                                        phi_2614_ = _e2054;
                                                                    }
                                                                    let _e2056 = phi_2614_;
                                                                    let _e2060 = (_e2056.x - (_e1377 * _e2056.z));
                                                                    let _e2064 = (_e2056.y - (_e1380 * _e2056.z));
                                                                    if (_e2034 < _e2060) {
                                                                        phi_2633_ = true;
                                                                    } else {
                                                                        if (_e2034 == _e2060) {
                                                                            phi_2632_ = (_e2038 < _e2064);
                                                                        } else {
                                                                            phi_2632_ = false;
                                                                        }
                                                                        let _e2069 = phi_2632_;
                                                                        phi_2633_ = _e2069;
                                                                    }
                                                                    let _e2071 = phi_2633_;
                                                                    if _e2071 {
                                                                        phi_2637_ = _e2064;
                                                                        phi_2638_ = _e2060;
                                                                        phi_2639_ = _e2038;
                                                                        phi_2640_ = _e2034;
                                                                    } else {
                                                                        phi_2637_ = _e2038;
                                                                        phi_2638_ = _e2034;
                                                                        phi_2639_ = _e2064;
                                                                        phi_2640_ = _e2060;
                                                                    }
                                                                    let _e2073 = phi_2637_;
                                                                    let _e2075 = phi_2638_;
                                                                    let _e2077 = phi_2639_;
                                                                    let _e2079 = phi_2640_;
                                                                    let _e2082 = ((_e2079 * _e2073) - (_e2077 * _e2075));
                                                                    if _e2071 {
                                                                        phi_2648_ = -(_e2082);
                                                                    } else {
                                                                        phi_2648_ = _e2082;
                                                                    }
                                                                    let _e2085 = phi_2648_;
                                                                    if (_e2060 < _e2008) {
                                                                        phi_2659_ = true;
                                                                    } else {
                                                                        if (_e2060 == _e2008) {
                                                                            phi_2658_ = (_e2064 < _e2012);
                                                                        } else {
                                                                            phi_2658_ = false;
                                                                        }
                                                                        let _e2090 = phi_2658_;
                                                                        phi_2659_ = _e2090;
                                                                    }
                                                                    let _e2092 = phi_2659_;
                                                                    if _e2092 {
                                                                        phi_2663_ = _e2012;
                                                                        phi_2664_ = _e2008;
                                                                        phi_2665_ = _e2064;
                                                                        phi_2666_ = _e2060;
                                                                    } else {
                                                                        phi_2663_ = _e2064;
                                                                        phi_2664_ = _e2060;
                                                                        phi_2665_ = _e2012;
                                                                        phi_2666_ = _e2008;
                                                                    }
                                                                    let _e2094 = phi_2663_;
                                                                    let _e2096 = phi_2664_;
                                                                    let _e2098 = phi_2665_;
                                                                    let _e2100 = phi_2666_;
                                                                    let _e2103 = ((_e2100 * _e2094) - (_e2098 * _e2096));
                                                                    if _e2092 {
                                                                        phi_2674_ = -(_e2103);
                                                                    } else {
                                                                        phi_2674_ = _e2103;
                                                                    }
                                                                    let _e2106 = phi_2674_;
                                                                    if (_e2008 < _e2034) {
                                                                        phi_2685_ = true;
                                                                    } else {
                                                                        if (_e2008 == _e2034) {
                                                                            phi_2684_ = (_e2012 < _e2038);
                                                                        } else {
                                                                            phi_2684_ = false;
                                                                        }
                                                                        let _e2111 = phi_2684_;
                                                                        phi_2685_ = _e2111;
                                                                    }
                                                                    let _e2113 = phi_2685_;
                                                                    if _e2113 {
                                                                        phi_2689_ = _e2038;
                                                                        phi_2690_ = _e2034;
                                                                        phi_2691_ = _e2012;
                                                                        phi_2692_ = _e2008;
                                                                    } else {
                                                                        phi_2689_ = _e2012;
                                                                        phi_2690_ = _e2008;
                                                                        phi_2691_ = _e2038;
                                                                        phi_2692_ = _e2034;
                                                                    }
                                                                    let _e2115 = phi_2689_;
                                                                    let _e2117 = phi_2690_;
                                                                    let _e2119 = phi_2691_;
                                                                    let _e2121 = phi_2692_;
                                                                    let _e2124 = ((_e2121 * _e2115) - (_e2119 * _e2117));
                                                                    if _e2113 {
                                                                        phi_2700_ = -(_e2124);
                                                                    } else {
                                                                        phi_2700_ = _e2124;
                                                                    }
                                                                    let _e2127 = phi_2700_;
                                                                    if (_e2085 >= 0f) {
                                                                        if (_e2106 >= 0f) {
                                                                            if (_e2127 >= 0f) {
                                                                                phi_2715_ = ((_e2085 + _e2106) + _e2127);
                                                                                phi_2716_ = false;
                                                                            } else {
                                                                                phi_2715_ = f32();
                                                                                phi_2716_ = true;
                                                                            }
                                                                            let _e2134 = phi_2715_;
                                                                            let _e2136 = phi_2716_;
                                                                            phi_2717_ = _e2134;
                                                                            phi_2718_ = _e2136;
                                                                        } else {
                                                                            phi_2717_ = f32();
                                                                            phi_2718_ = true;
                                                                        }
                                                                        let _e2138 = phi_2717_;
                                                                        let _e2140 = phi_2718_;
                                                                        phi_2719_ = _e2138;
                                                                        phi_2720_ = _e2140;
                                                                    } else {
                                                                        phi_2719_ = f32();
                                                                        phi_2720_ = true;
                                                                    }
                                                                    let _e2142 = phi_2719_;
                                                                    let _e2144 = phi_2720_;
                                                                    if _e2144 {
                                                                        if (_e2085 <= 0f) {
                                                                            if (_e2106 <= 0f) {
                                                                                let _e2147 = (_e2127 <= 0f);
                                                                                if _e2147 {
                                                                                }
                                                                                phi_2738_ = ((_e2085 + _e2106) + _e2127);
                                                                                phi_2739_ = false;
                                                                                phi_2740_ = _e2147;
                                                                            } else {
                                                                                phi_2738_ = f32();
                                                                                phi_2739_ = true;
                                                                                phi_2740_ = false;
                                                                            }
                                                                            let _e2151 = phi_2738_;
                                                                            let _e2153 = phi_2739_;
                                                                            let _e2155 = phi_2740_;
                                                                            phi_2741_ = _e2151;
                                                                            phi_2742_ = _e2153;
                                                                            phi_2743_ = _e2155;
                                                                        } else {
                                                                            phi_2741_ = f32();
                                                                            phi_2742_ = true;
                                                                            phi_2743_ = false;
                                                                        }
                                                                        let _e2157 = phi_2741_;
                                                                        let _e2159 = phi_2742_;
                                                                        let _e2161 = phi_2743_;
                                                                        if _e2159 {
                                                                            phi_2747_ = false;
                                                                        } else {
                                                                            phi_2747_ = _e2161;
                                                                        }
                                                                        let _e2163 = phi_2747_;
                                                                        phi_2748_ = _e2157;
                                                                        phi_2749_ = _e2163;
                                                                    } else {
                                                                        phi_2748_ = _e2142;
                                                                        phi_2749_ = true;
                                                                    }
                                                                    let _e2165 = phi_2748_;
                                                                    let _e2167 = phi_2749_;
                                                                    if _e2167 {
                                                                        let _e2168 = (_e2165 == 0f);
                                                                        if _e2168 {
                                                                            phi_3065_ = lt_bvh_triangle_Intersection();
                                                                            phi_3066_ = false;
                                                                        } else {
                                                                            let _e2170 = triangles.member[(0u + _e1981)].v0_;
                                                                            let _e2172 = (_e2170.x - _e1084);
                                                                            let _e2174 = (_e2170.y - _e1097);
                                                                            let _e2176 = (_e2170.z - _e1110);
                                                                            if (_e1366 == 0u) {
                                                                                phi_2778_ = vec3<f32>(_e2174, _e2176, _e2172);
                                                                            } else {
                                                                                if (_e1366 == 1u) {
                                                                                    phi_2777_ = vec3<f32>(_e2176, _e2172, _e2174);
                                                                                } else {
                                                                                    phi_2777_ = (_e2170 - vec3<f32>(_e1084, _e1097, _e1110));
                                                                                }
                                                                                let _e2184 = phi_2777_;
                                                                                phi_2778_ = _e2184;
                                                                            }
                                                                            let _e2186 = phi_2778_;
                                                                            let _e2188 = triangles.member[(0u + _e1981)].v1_;
                                                                            let _e2190 = triangles.member[(0u + _e1981)].v0_;
                                                                            let _e2193 = (_e2188.x - _e2190.x);
                                                                            let _e2196 = (_e2188.y - _e2190.y);
                                                                            let _e2199 = (_e2188.z - _e2190.z);
                                                                            if (_e1366 == 0u) {
                                                                                phi_2804_ = vec3<f32>(_e2196, _e2199, _e2193);
                                                                            } else {
                                                                                if (_e1366 == 1u) {
                                                                                    phi_2803_ = vec3<f32>(_e2199, _e2193, _e2196);
                                                                                } else {
                                                                                    phi_2803_ = (_e2188 - _e2190);
                                                                                }
                                                                                let _e2206 = phi_2803_;
                                                                                phi_2804_ = _e2206;
                                                                            }
                                                                            let _e2208 = phi_2804_;
                                                                            let _e2210 = triangles.member[(0u + _e1981)].v2_;
                                                                            let _e2212 = triangles.member[(0u + _e1981)].v0_;
                                                                            let _e2215 = (_e2210.x - _e2212.x);
                                                                            let _e2218 = (_e2210.y - _e2212.y);
                                                                            let _e2221 = (_e2210.z - _e2212.z);
                                                                            if (_e1366 == 0u) {
                                                                                phi_2830_ = vec3<f32>(_e2218, _e2221, _e2215);
                                                                            } else {
                                                                                if (_e1366 == 1u) {
                                                                                    phi_2829_ = vec3<f32>(_e2221, _e2215, _e2218);
                                                                                } else {
                                                                                    phi_2829_ = (_e2210 - _e2212);
                                                                                }
                                                                                let _e2228 = phi_2829_;
                                                                                phi_2830_ = _e2228;
                                                                            }
                                                                            let _e2230 = phi_2830_;
                                                                            let _e2237 = ((_e2208.y * _e2230.z) - (_e2208.z * _e2230.y));
                                                                            let _e2244 = ((_e2208.z * _e2230.x) - (_e2208.x * _e2230.z));
                                                                            let _e2251 = ((_e2208.x * _e2230.y) - (_e2208.y * _e2230.x));
                                                                            let _e2265 = (((1f / _e1374.z) * (((_e2237 * _e2186.x) + (_e2244 * _e2186.y)) + (_e2251 * _e2186.z))) / (((_e2237 * _e1377) + (_e2244 * _e1380)) + _e2251));
                                                                            if (_e2265 > _e183.tmin) {
                                                                                if (_e2265 < _e183.tmax) {
                                                                                    let _e2269 = triangles.member[(0u + _e1981)].v0_;
                                                                                    let _e2271 = triangles.member[(0u + _e1981)].v1_;
                                                                                    if (_e2269.x < _e2271.x) {
                                                                                        phi_2886_ = _e2269.x;
                                                                                    } else {
                                                                                        phi_2886_ = _e2271.x;
                                                                                    }
                                                                                    let _e2278 = phi_2886_;
                                                                                    if (_e2269.y < _e2271.y) {
                                                                                        phi_2895_ = _e2269.y;
                                                                                    } else {
                                                                                        phi_2895_ = _e2271.y;
                                                                                    }
                                                                                    let _e2285 = phi_2895_;
                                                                                    if (_e2269.z < _e2271.z) {
                                                                                        phi_2904_ = _e2269.z;
                                                                                    } else {
                                                                                        phi_2904_ = _e2271.z;
                                                                                    }
                                                                                    let _e2292 = phi_2904_;
                                                                                    let _e2294 = triangles.member[(0u + _e1981)].v2_;
                                                                                    if (_e2278 < _e2294.x) {
                                                                                        phi_2913_ = _e2278;
                                                                                    } else {
                                                                                        phi_2913_ = _e2294.x;
                                                                                    }
                                                                                    let _e2299 = phi_2913_;
                                                                                    if (_e2285 < _e2294.y) {
                                                                                        phi_2920_ = _e2285;
                                                                                    } else {
                                                                                        phi_2920_ = _e2294.y;
                                                                                    }
                                                                                    let _e2304 = phi_2920_;
                                                                                    if (_e2292 < _e2294.z) {
                                                                                        phi_2927_ = _e2292;
                                                                                    } else {
                                                                                        phi_2927_ = _e2294.z;
                                                                                    }
                                                                                    let _e2309 = phi_2927_;
                                                                                    let _e2311 = triangles.member[(0u + _e1981)].v0_;
                                                                                    let _e2313 = triangles.member[(0u + _e1981)].v1_;
                                                                                    if (_e2311.x > _e2313.x) {
                                                                                        phi_2940_ = _e2311.x;
                                                                                    } else {
                                                                                        phi_2940_ = _e2313.x;
                                                                                    }
                                                                                    let _e2320 = phi_2940_;
                                                                                    if (_e2311.y > _e2313.y) {
                                                                                        phi_2949_ = _e2311.y;
                                                                                    } else {
                                                                                        phi_2949_ = _e2313.y;
                                                                                    }
                                                                                    let _e2327 = phi_2949_;
                                                                                    if (_e2311.z > _e2313.z) {
                                                                                        phi_2958_ = _e2311.z;
                                                                                    } else {
                                                                                        phi_2958_ = _e2313.z;
                                                                                    }
                                                                                    let _e2334 = phi_2958_;
                                                                                    let _e2336 = triangles.member[(0u + _e1981)].v2_;
                                                                                    if (_e2320 > _e2336.x) {
                                                                                        phi_2967_ = _e2320;
                                                                                    } else {
                                                                                        phi_2967_ = _e2336.x;
                                                                                    }
                                                                                    let _e2341 = phi_2967_;
                                                                                    if (_e2327 > _e2336.y) {
                                                                                        phi_2974_ = _e2327;
                                                                                    } else {
                                                                                        phi_2974_ = _e2336.y;
                                                                                    }
                                                                                    let _e2346 = phi_2974_;
                                                                                    if (_e2334 > _e2336.z) {
                                                                                        phi_2981_ = _e2334;
                                                                                    } else {
                                                                                        phi_2981_ = _e2336.z;
                                                                                    }
                                                                                    let _e2351 = phi_2981_;
                                                                                    let _e2355 = ((_e2299 - _e1084) * _e1291);
                                                                                    let _e2356 = ((_e2304 - _e1097) * _e1301);
                                                                                    let _e2357 = ((_e2309 - _e1110) * _e1311);
                                                                                    let _e2361 = ((_e2341 - _e1084) * _e1291);
                                                                                    let _e2362 = ((_e2346 - _e1097) * _e1301);
                                                                                    let _e2363 = ((_e2351 - _e1110) * _e1311);
                                                                                    if (_e2355 < _e2361) {
                                                                                        phi_2998_ = _e2355;
                                                                                    } else {
                                                                                        phi_2998_ = _e2361;
                                                                                    }
                                                                                    let _e2366 = phi_2998_;
                                                                                    if (_e2356 < _e2362) {
                                                                                        phi_3003_ = _e2356;
                                                                                    } else {
                                                                                        phi_3003_ = _e2362;
                                                                                    }
                                                                                    let _e2369 = phi_3003_;
                                                                                    if (_e2357 < _e2363) {
                                                                                        phi_3008_ = _e2357;
                                                                                    } else {
                                                                                        phi_3008_ = _e2363;
                                                                                    }
                                                                                    let _e2372 = phi_3008_;
                                                                                    if (_e2355 > _e2361) {
                                                                                        phi_3016_ = _e2355;
                                                                                    } else {
                                                                                        phi_3016_ = _e2361;
                                                                                    }
                                                                                    let _e2378 = phi_3016_;
                                                                                    if (_e2356 > _e2362) {
                                                                                        phi_3021_ = _e2356;
                                                                                    } else {
                                                                                        phi_3021_ = _e2362;
                                                                                    }
                                                                                    let _e2381 = phi_3021_;
                                                                                    if (_e2357 > _e2363) {
                                                                                        phi_3026_ = _e2357;
                                                                                    } else {
                                                                                        phi_3026_ = _e2363;
                                                                                    }
                                                                                    let _e2384 = phi_3026_;
                                                                                    let _e2388 = core_intrinsics_maximum_number_nsz_f32_((_e2366 - _e1350), (_e2369 - _e1351));
                                                                                    let _e2389 = core_intrinsics_maximum_number_nsz_f32_(_e2388, (_e2372 - _e1352));
                                                                                    let _e2390 = core_intrinsics_minimum_number_nsz_f32_((_e2378 + _e1350), (_e2381 + _e1351));
                                                                                    let _e2391 = core_intrinsics_minimum_number_nsz_f32_(_e2390, (_e2384 + _e1352));
                                                                                    if (_e2389 > _e1059) {
                                                                                        phi_3038_ = _e2389;
                                                                                    } else {
                                                                                        phi_3038_ = _e1059;
                                                                                    }
                                                                                    let _e2394 = phi_3038_;
                                                                                    if (_e2391 < _e1061) {
                                                                                        phi_3043_ = _e2391;
                                                                                    } else {
                                                                                        phi_3043_ = _e1061;
                                                                                    }
                                                                                    let _e2397 = phi_3043_;
                                                                                    if (_e2265 < _e2394) {
                                                                                        phi_3048_ = _e2394;
                                                                                    } else {
                                                                                        phi_3048_ = _e2265;
                                                                                    }
                                                                                    let _e2400 = phi_3048_;
                                                                                    if (_e2400 > _e2397) {
                                                                                        phi_3053_ = _e2397;
                                                                                    } else {
                                                                                        phi_3053_ = _e2400;
                                                                                    }
                                                                                    let _e2403 = phi_3053_;
                                                                                    phi_3058_ = lt_bvh_triangle_Intersection(_e2403, (_e2106 / _e2165), (_e2127 / _e2165), (_e2394 <= _e2397));
                                                                                    phi_3059_ = false;
                                                                                } else {
                                                                                    phi_3058_ = lt_bvh_triangle_Intersection();
                                                                                    phi_3059_ = true;
                                                                                }
                                                                                let _e2409 = phi_3058_;
                                                                                let _e2411 = phi_3059_;
                                                                                phi_3060_ = _e2409;
                                                                                phi_3061_ = _e2411;
                                                                            } else {
                                                                                phi_3060_ = lt_bvh_triangle_Intersection();
                                                                                phi_3061_ = true;
                                                                            }
                                                                            let _e2413 = phi_3060_;
                                                                            let _e2415 = phi_3061_;
                                                                            if _e2415 {
                                                                            }
                                                                            phi_3065_ = _e2413;
                                                                            phi_3066_ = _e2415;
                                                                        }
                                                                        let _e2417 = phi_3065_;
                                                                        let _e2419 = phi_3066_;
                                                                        phi_3067_ = _e2417;
                                                                        phi_3068_ = _e2168;
                                                                        phi_3069_ = _e2419;
                                                                    } else {
                                                                        phi_3067_ = lt_bvh_triangle_Intersection();
                                                                        phi_3068_ = true;
                                                                        phi_3069_ = false;
                                                                    }
                                                                    let _e2421 = phi_3067_;
                                                                    let _e2423 = phi_3068_;
                                                                    let _e2425 = phi_3069_;
                                                                    if _e2423 {
                                                                        phi_3073_ = true;
                                                                    } else {
                                                                        phi_3073_ = _e2425;
                                                                    }
                                                                    let _e2427 = phi_3073_;
                                                                    if _e2427 {
                                                                        phi_3077_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_3077_ = _e2421;
                                                                    }
                                                                    let _e2429 = phi_3077_;
                                                                    if _e2429.is_hit {
                                                                        if (_e2429.t > _e183.tmin) {
                                                                            if (_e2429.t < _e1970.t) {
                                                                                phi_3125_ = true;
                                                                            } else {
                                                                                if (_e2429.t == _e1970.t) {
                                                                                    if (_e1970.triangle != 4294967295u) {
                                                                                        if (_e1981 < _e1970.triangle) {
                                                                                            phi_3116_ = true;
                                                                                        } else {
                                                                                            if (_e1981 == _e1970.triangle) {
                                                                                                phi_3115_ = (_e1000 < _e1970.instance);
                                                                                            } else {
                                                                                                phi_3115_ = false;
                                                                                            }
                                                                                            let _e2447 = phi_3115_;
                                                                                            phi_3116_ = _e2447;
                                                                                        }
                                                                                        let _e2449 = phi_3116_;
                                                                                        phi_3117_ = _e2449;
                                                                                        phi_3118_ = false;
                                                                                    } else {
                                                                                        phi_3117_ = bool();
                                                                                        phi_3118_ = true;
                                                                                    }
                                                                                    let _e2451 = phi_3117_;
                                                                                    let _e2453 = phi_3118_;
                                                                                    phi_3119_ = _e2451;
                                                                                    phi_3120_ = _e2453;
                                                                                } else {
                                                                                    phi_3119_ = bool();
                                                                                    phi_3120_ = true;
                                                                                }
                                                                                let _e2455 = phi_3119_;
                                                                                let _e2457 = phi_3120_;
                                                                                if _e2457 {
                                                                                    phi_3124_ = false;
                                                                                } else {
                                                                                    phi_3124_ = _e2455;
                                                                                }
                                                                                let _e2459 = phi_3124_;
                                                                                phi_3125_ = _e2459;
                                                                            }
                                                                            let _e2461 = phi_3125_;
                                                                            if _e2461 {
                                                                                let _e2463 = triangles.member[(0u + _e1981)].i0_;
                                                                                if ((_e2463 & 2147483648u) == 0u) {
                                                                                    phi_3336_ = true;
                                                                                } else {
                                                                                    if (_e1981 < _e82) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2472 = triangles.member[(0u + _e1981)].i0_;
                                                                                    let _e2473 = (_e2472 & 2147483647u);
                                                                                    let _e2475 = triangles.member[(0u + _e1981)].i1_;
                                                                                    let _e2477 = triangles.member[(0u + _e1981)].i2_;
                                                                                    if (_e2473 < _e85) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2481 = vertices.member[(0u + _e2473)];
                                                                                    if (_e2475 < _e85) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2485 = vertices.member[(0u + _e2475)];
                                                                                    if (_e2477 < _e85) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2489 = vertices.member[(0u + _e2477)];
                                                                                    let _e2490 = array<abi_Vertex, 3>(_e2481, _e2485, _e2489);
                                                                                    if (_e2490[0].material < _e88) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2496 = materials.member[(0u + _e2490[0].material)];
                                                                                    if ((_e2496.flags & 0u) == 0u) {
                                                                                        let _e2501 = ((1f - _e2429.u) - _e2429.v);
                                                                                        if (_e2496.cutoff <= 0f) {
                                                                                            phi_3331_ = true;
                                                                                        } else {
                                                                                            let _e2528 = (_e2496.base_color.w * ((((f32((_e2490[0].color >> bitcast<u32>(24i))) * _e2501) + (f32((_e2490[1].color >> bitcast<u32>(24i))) * _e2429.u)) + (f32((_e2490[2].color >> bitcast<u32>(24i))) * _e2429.v)) * (1f / 255f)));
                                                                                            if (_e2496.alpha_size == 0u) {
                                                                                                phi_3328_ = _e2528;
                                                                                            } else {
                                                                                                local.offset = _e2496.alpha_offset;
                                                                                                local.size = _e2496.alpha_size;
                                                                                                local.flags = _e2496.flags;
                                                                                                let _e2559 = _lt_shaders_texture_TextureView_quad((&local), (((_e2490[0].u * _e2501) + (_e2490[1].u * _e2429.u)) + (_e2490[2].u * _e2429.v)), (((_e2490[0].v * _e2501) + (_e2490[1].v * _e2429.u)) + (_e2490[2].v * _e2429.v)));
                                                                                                let _e2563 = (_e2559.indices[0] >> bitcast<u32>(2i));
                                                                                                if (_e2563 < _e97) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2567 = alpha_texels.member[(0u + _e2563)];
                                                                                                let _e2583 = (_e2559.indices[1] >> bitcast<u32>(2i));
                                                                                                if (_e2583 < _e97) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2587 = alpha_texels.member[(0u + _e2583)];
                                                                                                let _e2604 = (_e2559.indices[2] >> bitcast<u32>(2i));
                                                                                                if (_e2604 < _e97) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2608 = alpha_texels.member[(0u + _e2604)];
                                                                                                let _e2625 = (_e2559.indices[3] >> bitcast<u32>(2i));
                                                                                                if (_e2625 < _e97) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2629 = alpha_texels.member[(0u + _e2625)];
                                                                                                phi_3328_ = (_e2528 * (((((f32(((_e2567 >> bitcast<u32>((((_e2559.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2559.weights.x) + ((f32(((_e2587 >> bitcast<u32>((((_e2559.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2559.weights.y)) + ((f32(((_e2608 >> bitcast<u32>((((_e2559.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2559.weights.z)) + ((f32(((_e2629 >> bitcast<u32>((((_e2559.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2559.weights.w)));
                                                                                            }
                                                                                            let _e2645 = phi_3328_;
                                                                                            phi_3331_ = (_e2645 >= _e2496.cutoff);
                                                                                        }
                                                                                        let _e2649 = phi_3331_;
                                                                                        phi_3332_ = _e2649;
                                                                                    } else {
                                                                                        phi_3332_ = false;
                                                                                    }
                                                                                    let _e2651 = phi_3332_;
                                                                                    if _e2651 {
                                                                                    }
                                                                                    phi_3336_ = _e2651;
                                                                                }
                                                                                let _e2653 = phi_3336_;
                                                                                if _e2653 {
                                                                                    phi_3344_ = lt_bvh_Hit(_e2429.t, _e2429.u, _e2429.v, _e1981, _e1000);
                                                                                } else {
                                                                                    phi_3344_ = _e1970;
                                                                                }
                                                                                let _e2659 = phi_3344_;
                                                                                phi_3345_ = _e2659;
                                                                            } else {
                                                                                phi_3345_ = _e1970;
                                                                            }
                                                                            let _e2661 = phi_3345_;
                                                                            phi_3346_ = _e2661;
                                                                        } else {
                                                                            phi_3346_ = _e1970;
                                                                        }
                                                                        let _e2663 = phi_3346_;
                                                                        phi_3347_ = _e2663;
                                                                    } else {
                                                                        phi_3347_ = _e1970;
                                                                    }
                                                                    let _e2665 = phi_3347_;
                                                                    phi_2507_ = _e2665;
                                                                    phi_2510_ = (_e1972 & (_e1972 - 1u));
                                                                    phi_3348_ = true;
                                                                }
                                                                let _e2667 = phi_2507_;
                                                                let _e2669 = phi_2510_;
                                                                let _e2671 = phi_3348_;
                                                                continue;
                                                                continuing {
                                                                    phi_2506_ = _e2667;
                                                                    phi_2509_ = _e2669;
                                                                    break if !(_e2671);
                                                                }
                                                            }
                                                            let _e2674 = local_1.group_mask;
                                                            if ((_e2674 & 4278190080u) == 0u) {
                                                                let _e2678 = local_1.len;
                                                                if (_e2678 == 0u) {
                                                                    phi_3387_ = false;
                                                                } else {
                                                                    let _e2682 = local_1.len;
                                                                    local_1.len = (_e2682 - 1u);
                                                                    let _e2685 = local_1.len;
                                                                    if (_e2685 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2690 = local_1.first[(0u + _e2685)];
                                                                    local_1.group = _e2690;
                                                                    let _e2693 = local_1.len;
                                                                    if (_e2693 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2698 = local_1.mask[(0u + _e2693)];
                                                                    local_1.group_mask = _e2698;
                                                                    phi_3387_ = true;
                                                                }
                                                                let _e2701 = phi_3387_;
                                                                phi_3388_ = _e2701;
                                                            } else {
                                                                phi_3388_ = true;
                                                            }
                                                            let _e2703 = phi_3388_;
                                                            if _e2703 {
                                                                let _e2705 = local_1.group_mask;
                                                                let _e2711 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2705)), 32u, (_e2705 == 0u)));
                                                                let _e2715 = local_1.group_mask;
                                                                let _e2729 = local_1.group_mask;
                                                                local_1.group_mask = (_e2729 & ~((1u << bitcast<u32>((_e2711 & 31u)))));
                                                                let _e2732 = local_1.group;
                                                                phi_3419_ = (_e2732 + countOneBits(((_e2715 & ~((4294967295u << bitcast<u32>((((_e2711 - 24u) ^ _e1393) & 31u))))) & 255u)));
                                                            } else {
                                                                phi_3419_ = 4294967295u;
                                                            }
                                                            let _e2735 = phi_3419_;
                                                            let _e3913 = local_9;
                                                            phi_2174_ = _e3913;
                                                            phi_2177_ = _e2735;
                                                        } else {
                                                            phi_2174_ = lt_bvh_Hit();
                                                            phi_2177_ = u32();
                                                        }
                                                        let _e2737 = phi_2174_;
                                                        let _e2739 = phi_2177_;
                                                        continue;
                                                        continuing {
                                                            phi_2173_ = _e2737;
                                                            phi_2176_ = _e2739;
                                                            break if !(_e1534);
                                                        }
                                                    }
                                                    let _e3917 = local_10;
                                                    phi_3420_ = _e3917;
                                                }
                                                let _e2742 = phi_3420_;
                                                phi_3421_ = _e2742;
                                                phi_3422_ = _e1215;
                                            } else {
                                                phi_3421_ = lt_bvh_Hit();
                                                phi_3422_ = true;
                                            }
                                            let _e2744 = phi_3421_;
                                            let _e2746 = phi_3422_;
                                            if _e2746 {
                                                phi_3426_ = _e992;
                                            } else {
                                                phi_3426_ = _e2744;
                                            }
                                            let _e2748 = phi_3426_;
                                            phi_3427_ = _e2748;
                                        } else {
                                            phi_3427_ = _e992;
                                        }
                                        let _e2750 = phi_3427_;
                                        phi_3428_ = _e2750;
                                    } else {
                                        phi_3428_ = _e992;
                                    }
                                    let _e2752 = phi_3428_;
                                    phi_3429_ = _e2752;
                                } else {
                                    phi_3429_ = _e992;
                                }
                                let _e2754 = phi_3429_;
                                phi_1541_ = (_e990 & (_e990 - 1u));
                                phi_1544_ = _e2754;
                                phi_3430_ = true;
                            }
                            let _e2756 = phi_1541_;
                            let _e2758 = phi_1544_;
                            let _e2760 = phi_3430_;
                            continue;
                            continuing {
                                phi_1540_ = _e2756;
                                phi_1543_ = _e2758;
                                break if !(_e2760);
                            }
                        }
                        let _e2763 = local_2.group_mask;
                        if ((_e2763 & 4278190080u) == 0u) {
                            let _e2767 = local_2.len;
                            if (_e2767 == 0u) {
                                phi_3469_ = false;
                            } else {
                                let _e2771 = local_2.len;
                                local_2.len = (_e2771 - 1u);
                                let _e2774 = local_2.len;
                                if (_e2774 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2779 = local_2.first[(0u + _e2774)];
                                local_2.group = _e2779;
                                let _e2782 = local_2.len;
                                if (_e2782 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2787 = local_2.mask[(0u + _e2782)];
                                local_2.group_mask = _e2787;
                                phi_3469_ = true;
                            }
                            let _e2790 = phi_3469_;
                            phi_3470_ = _e2790;
                        } else {
                            phi_3470_ = true;
                        }
                        let _e2792 = phi_3470_;
                        if _e2792 {
                            let _e2794 = local_2.group_mask;
                            let _e2800 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2794)), 32u, (_e2794 == 0u)));
                            let _e2804 = local_2.group_mask;
                            let _e2818 = local_2.group_mask;
                            local_2.group_mask = (_e2818 & ~((1u << bitcast<u32>((_e2800 & 31u)))));
                            let _e2821 = local_2.group;
                            phi_3501_ = (_e2821 + countOneBits(((_e2804 & ~((4294967295u << bitcast<u32>((((_e2800 - 24u) ^ _e409) & 31u))))) & 255u)));
                        } else {
                            phi_3501_ = 4294967295u;
                        }
                        let _e2824 = phi_3501_;
                        phi_1204_ = _e2824;
                        let _e3933 = local_11;
                        phi_1207_ = _e3933;
                    } else {
                        phi_1204_ = u32();
                        phi_1207_ = lt_bvh_Hit();
                    }
                    let _e2826 = phi_1204_;
                    let _e2828 = phi_1207_;
                    continue;
                    continuing {
                        phi_1203_ = _e2826;
                        phi_1206_ = _e2828;
                        break if !(_e550);
                    }
                }
                let _e3936 = local_12;
                phi_3502_ = _e3936;
            }
            let _e2831 = phi_3502_;
            phi_3503_ = _e2831;
            phi_3504_ = _e247;
        } else {
            phi_3503_ = lt_bvh_Hit();
            phi_3504_ = true;
        }
        let _e2833 = phi_3503_;
        let _e2835 = phi_3504_;
        if _e2835 {
            phi_3508_ = _e185;
        } else {
            phi_3508_ = _e2833;
        }
        let _e2837 = phi_3508_;
        if (_e2837.triangle != 4294967295u) {
            let _e2843 = ((1f - _e2837.u) - _e2837.v);
            if (_e2837.triangle < _e82) {
            } else {
                return;
            }
            let _e2849 = triangles.member[(0u + _e2837.triangle)];
            if (_e2837.instance < _e94) {
            } else {
                return;
            }
            let _e2860 = instances.member[(0u + _e2837.instance)].object_to_world[0u];
            let _e2871 = ((((_e2860.x * _e2849.v0_.x) + (_e2860.y * _e2849.v0_.y)) + (_e2860.z * _e2849.v0_.z)) + (_e2860.w * 1f));
            let _e2873 = instances.member[(0u + _e2837.instance)].object_to_world[1u];
            let _e2884 = ((((_e2873.x * _e2849.v0_.x) + (_e2873.y * _e2849.v0_.y)) + (_e2873.z * _e2849.v0_.z)) + (_e2873.w * 1f));
            let _e2886 = instances.member[(0u + _e2837.instance)].object_to_world[2u];
            let _e2897 = ((((_e2886.x * _e2849.v0_.x) + (_e2886.y * _e2849.v0_.y)) + (_e2886.z * _e2849.v0_.z)) + (_e2886.w * 1f));
            let _e2904 = instances.member[(0u + _e2837.instance)].object_to_world[0u];
            let _e2915 = ((((_e2904.x * _e2849.v1_.x) + (_e2904.y * _e2849.v1_.y)) + (_e2904.z * _e2849.v1_.z)) + (_e2904.w * 1f));
            let _e2917 = instances.member[(0u + _e2837.instance)].object_to_world[1u];
            let _e2928 = ((((_e2917.x * _e2849.v1_.x) + (_e2917.y * _e2849.v1_.y)) + (_e2917.z * _e2849.v1_.z)) + (_e2917.w * 1f));
            let _e2930 = instances.member[(0u + _e2837.instance)].object_to_world[2u];
            let _e2941 = ((((_e2930.x * _e2849.v1_.x) + (_e2930.y * _e2849.v1_.y)) + (_e2930.z * _e2849.v1_.z)) + (_e2930.w * 1f));
            let _e2948 = instances.member[(0u + _e2837.instance)].object_to_world[0u];
            let _e2959 = ((((_e2948.x * _e2849.v2_.x) + (_e2948.y * _e2849.v2_.y)) + (_e2948.z * _e2849.v2_.z)) + (_e2948.w * 1f));
            let _e2961 = instances.member[(0u + _e2837.instance)].object_to_world[1u];
            let _e2972 = ((((_e2961.x * _e2849.v2_.x) + (_e2961.y * _e2849.v2_.y)) + (_e2961.z * _e2849.v2_.z)) + (_e2961.w * 1f));
            let _e2974 = instances.member[(0u + _e2837.instance)].object_to_world[2u];
            let _e2985 = ((((_e2974.x * _e2849.v2_.x) + (_e2974.y * _e2849.v2_.y)) + (_e2974.z * _e2849.v2_.z)) + (_e2974.w * 1f));
            let _e2998 = (((_e2871 * _e2843) + (_e2915 * _e2837.u)) + (_e2959 * _e2837.v));
            let _e2999 = (((_e2884 * _e2843) + (_e2928 * _e2837.u)) + (_e2972 * _e2837.v));
            let _e3000 = (((_e2897 * _e2843) + (_e2941 * _e2837.u)) + (_e2985 * _e2837.v));
            let _e3002 = abs(_e2871);
            let _e3003 = abs(_e2884);
            let _e3004 = abs(_e2897);
            let _e3005 = abs(_e2915);
            let _e3006 = abs(_e2928);
            let _e3007 = abs(_e2941);
            if (_e3002 > _e3005) {
                phi_3696_ = _e3002;
            } else {
                phi_3696_ = _e3005;
            }
            let _e3010 = phi_3696_;
            if (_e3003 > _e3006) {
                phi_3701_ = _e3003;
            } else {
                phi_3701_ = _e3006;
            }
            let _e3013 = phi_3701_;
            if (_e3004 > _e3007) {
                phi_3706_ = _e3004;
            } else {
                phi_3706_ = _e3007;
            }
            let _e3016 = phi_3706_;
            let _e3017 = abs(_e2959);
            let _e3018 = abs(_e2972);
            let _e3019 = abs(_e2985);
            if (_e3010 > _e3017) {
                phi_3714_ = _e3010;
            } else {
                phi_3714_ = _e3017;
            }
            let _e3022 = phi_3714_;
            if (_e3013 > _e3018) {
                phi_3719_ = _e3013;
            } else {
                phi_3719_ = _e3018;
            }
            let _e3025 = phi_3719_;
            if (_e3016 > _e3019) {
                phi_3724_ = _e3016;
            } else {
                phi_3724_ = _e3019;
            }
            let _e3028 = phi_3724_;
            let _e3029 = (_e2915 - _e2871);
            let _e3030 = (_e2928 - _e2884);
            let _e3031 = (_e2941 - _e2897);
            let _e3032 = (_e2959 - _e2871);
            let _e3033 = (_e2972 - _e2884);
            let _e3034 = (_e2985 - _e2897);
            let _e3038 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3030), abs(_e3031));
            let _e3039 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3029), _e3038);
            let _e3040 = (_e3029 / _e3039);
            let _e3041 = (_e3030 / _e3039);
            let _e3042 = (_e3031 / _e3039);
            let _e3046 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3033), abs(_e3034));
            let _e3047 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3032), _e3046);
            let _e3048 = (_e3032 / _e3047);
            let _e3049 = (_e3033 / _e3047);
            let _e3050 = (_e3034 / _e3047);
            let _e3053 = ((_e3041 * _e3050) - (_e3049 * _e3042));
            let _e3056 = ((_e3042 * _e3048) - (_e3050 * _e3040));
            let _e3059 = ((_e3040 * _e3049) - (_e3048 * _e3041));
            let _e3061 = p.member.eye;
            let _e3074 = (1f / sqrt((((_e3053 * _e3053) + (_e3056 * _e3056)) + (_e3059 * _e3059))));
            let _e3075 = (_e3053 * _e3074);
            let _e3076 = (_e3056 * _e3074);
            let _e3077 = (_e3059 * _e3074);
            if ((((_e3075 * (_e3061.x - _e2998)) + (_e3076 * (_e3061.y - _e2999))) + (_e3077 * (_e3061.z - _e3000))) < 0f) {
                phi_3788_ = vec3<f32>(-(_e3075), -(_e3076), -(_e3077));
            } else {
                phi_3788_ = vec3<f32>(_e3075, _e3076, _e3077);
            }
            let _e3090 = phi_3788_;
            if (_e2837.triangle < _e82) {
            } else {
                return;
            }
            let _e3095 = triangles.member[(0u + _e2837.triangle)];
            let _e3097 = (_e3095.i0_ & 2147483647u);
            if (_e3097 < _e85) {
            } else {
                return;
            }
            let _e3103 = vertices.member[(0u + _e3097)];
            if (_e3095.i1_ < _e85) {
            } else {
                return;
            }
            let _e3107 = vertices.member[(0u + _e3095.i1_)];
            if (_e3095.i2_ < _e85) {
            } else {
                return;
            }
            let _e3111 = vertices.member[(0u + _e3095.i2_)];
            let _e3112 = array<abi_Vertex, 3>(_e3103, _e3107, _e3111);
            if (_e3112[0].material < _e88) {
            } else {
                return;
            }
            let _e3118 = materials.member[(0u + _e3112[0].material)];
            let _e3135 = (1f / 255f);
            let _e3154 = (1f / 255f);
            let _e3176 = (1f / 255f);
            let _e3189 = _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(vec3<f32>(_e2843, _e2837.u, _e2837.v));
            let _e3191 = ((_e3118.base_color.x * ((((f32((_e3112[0].color & 255u)) * _e3135) * _e2843) + ((f32((_e3112[1].color & 255u)) * _e3154) * _e2837.u)) + ((f32((_e3112[2].color & 255u)) * _e3176) * _e2837.v))) * _e3189.x);
            let _e3193 = ((_e3118.base_color.y * ((((f32(((_e3112[0].color >> bitcast<u32>(8i)) & 255u)) * _e3135) * _e2843) + ((f32(((_e3112[1].color >> bitcast<u32>(8i)) & 255u)) * _e3154) * _e2837.u)) + ((f32(((_e3112[2].color >> bitcast<u32>(8i)) & 255u)) * _e3176) * _e2837.v))) * _e3189.y);
            let _e3195 = ((_e3118.base_color.z * ((((f32(((_e3112[0].color >> bitcast<u32>(16i)) & 255u)) * _e3135) * _e2843) + ((f32(((_e3112[1].color >> bitcast<u32>(16i)) & 255u)) * _e3154) * _e2837.u)) + ((f32(((_e3112[2].color >> bitcast<u32>(16i)) & 255u)) * _e3176) * _e2837.v))) * _e3189.z);
            let _e3196 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e3025, _e3028);
            let _e3197 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e3022, _e3196);
            if ((_e3118.flags & 2u) == 0u) {
                phi_3909_ = 0u;
            } else {
                phi_3909_ = 1u;
            }
            let _e3202 = phi_3909_;
            if (_e3112[0].normal == 2147516416u) {
                phi_4139_ = _e3090;
            } else {
                let _e3215 = (f32((bitcast<i32>((_e3112[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3221 = (f32((bitcast<i32>(_e3112[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3225 = ((1f - abs(_e3215)) - abs(_e3221));
                if (_e3225 < 0f) {
                    phi_3936_ = -(_e3225);
                } else {
                    phi_3936_ = 0f;
                }
                let _e3229 = phi_3936_;
                if (_e3215 < 0f) {
                    phi_3943_ = (_e3215 + _e3229);
                } else {
                    phi_3943_ = (_e3215 - _e3229);
                }
                let _e3234 = phi_3943_;
                if (_e3221 < 0f) {
                    phi_3950_ = (_e3221 + _e3229);
                } else {
                    phi_3950_ = (_e3221 - _e3229);
                }
                let _e3239 = phi_3950_;
                let _e3246 = (1f / sqrt((((_e3234 * _e3234) + (_e3239 * _e3239)) + (_e3225 * _e3225))));
                let _e3262 = (f32((bitcast<i32>((_e3112[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3268 = (f32((bitcast<i32>(_e3112[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3272 = ((1f - abs(_e3262)) - abs(_e3268));
                if (_e3272 < 0f) {
                    phi_3985_ = -(_e3272);
                } else {
                    phi_3985_ = 0f;
                }
                let _e3276 = phi_3985_;
                if (_e3262 < 0f) {
                    phi_3992_ = (_e3262 + _e3276);
                } else {
                    phi_3992_ = (_e3262 - _e3276);
                }
                let _e3281 = phi_3992_;
                if (_e3268 < 0f) {
                    phi_3999_ = (_e3268 + _e3276);
                } else {
                    phi_3999_ = (_e3268 - _e3276);
                }
                let _e3286 = phi_3999_;
                let _e3293 = (1f / sqrt((((_e3281 * _e3281) + (_e3286 * _e3286)) + (_e3272 * _e3272))));
                let _e3312 = (f32((bitcast<i32>((_e3112[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3318 = (f32((bitcast<i32>(_e3112[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3322 = ((1f - abs(_e3312)) - abs(_e3318));
                if (_e3322 < 0f) {
                    phi_4037_ = -(_e3322);
                } else {
                    phi_4037_ = 0f;
                }
                let _e3326 = phi_4037_;
                if (_e3312 < 0f) {
                    phi_4044_ = (_e3312 + _e3326);
                } else {
                    phi_4044_ = (_e3312 - _e3326);
                }
                let _e3331 = phi_4044_;
                if (_e3318 < 0f) {
                    phi_4051_ = (_e3318 + _e3326);
                } else {
                    phi_4051_ = (_e3318 - _e3326);
                }
                let _e3336 = phi_4051_;
                let _e3343 = (1f / sqrt((((_e3331 * _e3331) + (_e3336 * _e3336)) + (_e3322 * _e3322))));
                let _e3350 = ((((_e3234 * _e3246) * _e2843) + ((_e3281 * _e3293) * _e2837.u)) + ((_e3331 * _e3343) * _e2837.v));
                let _e3351 = ((((_e3239 * _e3246) * _e2843) + ((_e3286 * _e3293) * _e2837.u)) + ((_e3336 * _e3343) * _e2837.v));
                let _e3352 = ((((_e3225 * _e3246) * _e2843) + ((_e3272 * _e3293) * _e2837.u)) + ((_e3322 * _e3343) * _e2837.v));
                if (_e2837.instance < _e94) {
                } else {
                    return;
                }
                let _e3359 = instances.member[(0u + _e2837.instance)].world_to_object[0u];
                let _e3368 = instances.member[(0u + _e2837.instance)].world_to_object[1u];
                let _e3380 = instances.member[(0u + _e2837.instance)].world_to_object[2u];
                let _e3387 = (((_e3359.x * _e3350) + (_e3368.x * _e3351)) + (_e3380.x * _e3352));
                let _e3388 = (((_e3359.y * _e3350) + (_e3368.y * _e3351)) + (_e3380.y * _e3352));
                let _e3389 = (((_e3359.z * _e3350) + (_e3368.z * _e3351)) + (_e3380.z * _e3352));
                let _e3395 = sqrt((((_e3387 * _e3387) + (_e3388 * _e3388)) + (_e3389 * _e3389)));
                if (_e3395 > 0f) {
                    let _e3397 = (_e3387 / _e3395);
                    let _e3398 = (_e3388 / _e3395);
                    let _e3399 = (_e3389 / _e3395);
                    if ((((_e3397 * _e3090.x) + (_e3398 * _e3090.y)) + (_e3399 * _e3090.z)) < 0f) {
                        phi_4137_ = vec3<f32>(-(_e3397), -(_e3398), -(_e3399));
                    } else {
                        phi_4137_ = vec3<f32>(_e3397, _e3398, _e3399);
                    }
                    let _e3415 = phi_4137_;
                    phi_4138_ = _e3415;
                } else {
                    phi_4138_ = _e3090;
                }
                let _e3417 = phi_4138_;
                phi_4139_ = _e3417;
            }
            let _e3419 = phi_4139_;
            if (_e3191 > 0f) {
                if (_e3191 < 1f) {
                    phi_4148_ = _e3191;
                } else {
                    phi_4148_ = 1f;
                }
                let _e3423 = phi_4148_;
                phi_4149_ = _e3423;
            } else {
                phi_4149_ = 0f;
            }
            let _e3425 = phi_4149_;
            if (_e3193 > 0f) {
                if (_e3193 < 1f) {
                    phi_4159_ = _e3193;
                } else {
                    phi_4159_ = 1f;
                }
                let _e3430 = phi_4159_;
                phi_4160_ = _e3430;
            } else {
                phi_4160_ = 0f;
            }
            let _e3432 = phi_4160_;
            if (_e3195 > 0f) {
                if (_e3195 < 1f) {
                    phi_4170_ = _e3195;
                } else {
                    phi_4170_ = 1f;
                }
                let _e3437 = phi_4170_;
                phi_4171_ = _e3437;
            } else {
                phi_4171_ = 0f;
            }
            let _e3439 = phi_4171_;
            let _e3442 = ((sqrt(_e3425) * 255f) + 0.5f);
            let _e3451 = ((sqrt(_e3432) * 255f) + 0.5f);
            let _e3463 = ((sqrt(_e3439) * 255f) + 0.5f);
            phi_4206_ = abi_Sample(vec3<f32>(_e2998, _e2999, _e3000), _e3197, _e3090, _e3202, _e3419, ((select(select(u32(_e3442), 0u, (_e3442 < bitcast<f32>(0u))), 4294967295u, (_e3442 > bitcast<f32>(1333788671u))) | (select(select(u32(_e3451), 0u, (_e3451 < bitcast<f32>(0u))), 4294967295u, (_e3451 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e3463), 0u, (_e3463 < bitcast<f32>(0u))), 4294967295u, (_e3463 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_4206_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e3477 = phi_4206_;
        if (_e109.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e109.first_primitive)] = _e3477;
        if (_e2837.triangle != 4294967295u) {
            let _e3486 = ((1f - _e2837.u) - _e2837.v);
            if (_e2837.triangle < _e82) {
            } else {
                return;
            }
            let _e3491 = triangles.member[(0u + _e2837.triangle)];
            let _e3493 = (_e3491.i0_ & 2147483647u);
            if (_e3493 < _e100) {
            } else {
                return;
            }
            let _e3499 = before.member[(0u + _e3493)];
            if (_e3491.i1_ < _e100) {
            } else {
                return;
            }
            let _e3503 = before.member[(0u + _e3491.i1_)];
            if (_e3491.i2_ < _e100) {
            } else {
                return;
            }
            let _e3507 = before.member[(0u + _e3491.i2_)];
            if (_e2837.instance < _e94) {
            } else {
                return;
            }
            let _e3517 = instances.member[(0u + _e2837.instance)].object_to_world[0u];
            let _e3530 = instances.member[(0u + _e2837.instance)].object_to_world[1u];
            let _e3543 = instances.member[(0u + _e2837.instance)].object_to_world[2u];
            if (_e2837.instance < _e94) {
            } else {
                return;
            }
            let _e3567 = instances.member[(0u + _e2837.instance)].object_to_world[0u];
            let _e3580 = instances.member[(0u + _e2837.instance)].object_to_world[1u];
            let _e3593 = instances.member[(0u + _e2837.instance)].object_to_world[2u];
            if (_e2837.instance < _e94) {
            } else {
                return;
            }
            let _e3620 = instances.member[(0u + _e2837.instance)].object_to_world[0u];
            let _e3633 = instances.member[(0u + _e2837.instance)].object_to_world[1u];
            let _e3646 = instances.member[(0u + _e2837.instance)].object_to_world[2u];
            phi_4429_ = vec3<f32>((((((((_e3517.x * _e3499.x) + (_e3517.y * _e3499.y)) + (_e3517.z * _e3499.z)) + (_e3517.w * 1f)) * _e3486) + (((((_e3567.x * _e3503.x) + (_e3567.y * _e3503.y)) + (_e3567.z * _e3503.z)) + (_e3567.w * 1f)) * _e2837.u)) + (((((_e3620.x * _e3507.x) + (_e3620.y * _e3507.y)) + (_e3620.z * _e3507.z)) + (_e3620.w * 1f)) * _e2837.v)), (((((((_e3530.x * _e3499.x) + (_e3530.y * _e3499.y)) + (_e3530.z * _e3499.z)) + (_e3530.w * 1f)) * _e3486) + (((((_e3580.x * _e3503.x) + (_e3580.y * _e3503.y)) + (_e3580.z * _e3503.z)) + (_e3580.w * 1f)) * _e2837.u)) + (((((_e3633.x * _e3507.x) + (_e3633.y * _e3507.y)) + (_e3633.z * _e3507.z)) + (_e3633.w * 1f)) * _e2837.v)), (((((((_e3543.x * _e3499.x) + (_e3543.y * _e3499.y)) + (_e3543.z * _e3499.z)) + (_e3543.w * 1f)) * _e3486) + (((((_e3593.x * _e3503.x) + (_e3593.y * _e3503.y)) + (_e3593.z * _e3503.z)) + (_e3593.w * 1f)) * _e2837.u)) + (((((_e3646.x * _e3507.x) + (_e3646.y * _e3507.y)) + (_e3646.z * _e3507.z)) + (_e3646.w * 1f)) * _e2837.v)));
        } else {
            phi_4429_ = vec3<f32>(0f, 0f, 0f);
        }
        let _e3666 = phi_4429_;
        if (_e109.first_primitive < arrayLength((&past.member))) {
        } else {
            return;
        }
        past.member[(0u + _e109.first_primitive)] = vec4<f32>(_e3666.x, _e3666.y, _e3666.z, 1f);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_instanced_alpha_motion_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
