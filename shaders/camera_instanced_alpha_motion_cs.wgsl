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

struct type_61 {
    member: array<lt_bvh_Instance>,
}

struct type_65 {
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
var<uniform> p: type_65;
@group(0) @binding(1) 
var<storage> nodes: type_35;
@group(0) @binding(2) 
var<storage> triangles: type_39;
@group(0) @binding(5) 
var<storage, read_write> samples: type_9;
@group(0) @binding(6) 
var<storage> instances: type_61;
@group(0) @binding(7) 
var<storage> alpha_texels: type_13;
@group(0) @binding(8) 
var<storage> before: type_26;
@group(0) @binding(9) 
var<storage, read_write> past: type_26;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_mask_LightPlace {
    var phi_231_: lt_mask_LightPlace;
    var phi_232_: bool;
    var phi_233_: lt_mask_LightPlace;
    var phi_234_: bool;
    var phi_239_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_231_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_232_ = false;
        } else {
            phi_231_ = lt_mask_LightPlace();
            phi_232_ = true;
        }
        let _e85 = phi_231_;
        let _e87 = phi_232_;
        phi_233_ = _e85;
        phi_234_ = _e87;
    } else {
        phi_233_ = lt_mask_LightPlace();
        phi_234_ = true;
    }
    let _e89 = phi_233_;
    let _e91 = phi_234_;
    if _e91 {
        phi_239_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_239_ = _e89;
    }
    let _e96 = phi_239_;
    return lt_mask_LightPlace(_e96.word, _e96.shift);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_254_: bool;
    var phi_258_: f32;

    if (param_3 != param_3) {
        phi_254_ = true;
    } else {
        let _e75 = (param_4 >= param_3);
        if _e75 {
        }
        phi_254_ = _e75;
    }
    let _e77 = phi_254_;
    if _e77 {
        phi_258_ = param_4;
    } else {
        phi_258_ = param_3;
    }
    let _e79 = phi_258_;
    return _e79;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_270_: bool;
    var phi_274_: f32;

    if (param_5 != param_5) {
        phi_270_ = true;
    } else {
        let _e75 = (param_6 <= param_5);
        if _e75 {
        }
        phi_270_ = _e75;
    }
    let _e77 = phi_270_;
    if _e77 {
        phi_274_ = param_6;
    } else {
        phi_274_ = param_5;
    }
    let _e79 = phi_274_;
    return _e79;
}

fn _lt_shaders_texture_TextureView_quad(param_7: ptr<function, texture_TextureView>, param_8: f32, param_9: f32) -> texture_TexelQuad {
    var phi_316_: f32;
    var phi_321_: f32;
    var phi_322_: bool;
    var phi_323_: f32;
    var phi_324_: bool;
    var phi_328_: f32;
    var phi_354_: f32;
    var phi_359_: f32;
    var phi_360_: bool;
    var phi_361_: f32;
    var phi_362_: bool;
    var phi_366_: f32;
    var phi_374_: f32;
    var phi_375_: f32;
    var phi_376_: f32;
    var phi_385_: f32;
    var phi_386_: f32;
    var phi_404_: u32;
    var phi_418_: u32;
    var phi_425_: u32;
    var phi_430_: u32;
    var phi_436_: u32;
    var phi_441_: u32;
    var phi_443_: texture_Axis;
    var phi_471_: f32;
    var phi_476_: f32;
    var phi_477_: bool;
    var phi_478_: f32;
    var phi_479_: bool;
    var phi_483_: f32;
    var phi_509_: f32;
    var phi_514_: f32;
    var phi_515_: bool;
    var phi_516_: f32;
    var phi_517_: bool;
    var phi_521_: f32;
    var phi_529_: f32;
    var phi_530_: f32;
    var phi_531_: f32;
    var phi_540_: f32;
    var phi_541_: f32;
    var phi_559_: u32;
    var phi_573_: u32;
    var phi_580_: u32;
    var phi_585_: u32;
    var phi_591_: u32;
    var phi_596_: u32;
    var phi_598_: texture_Axis;

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
                phi_316_ = 1f;
            } else {
                phi_316_ = 0f;
            }
            let _e106 = phi_316_;
            if (param_8 < 8388608f) {
                phi_321_ = (_e103 - _e106);
                phi_322_ = false;
            } else {
                phi_321_ = f32();
                phi_322_ = true;
            }
            let _e109 = phi_321_;
            let _e111 = phi_322_;
            phi_323_ = _e109;
            phi_324_ = _e111;
        } else {
            phi_323_ = f32();
            phi_324_ = true;
        }
        let _e113 = phi_323_;
        let _e115 = phi_324_;
        if _e115 {
            phi_328_ = param_8;
        } else {
            phi_328_ = _e113;
        }
        let _e117 = phi_328_;
        phi_376_ = (param_8 - _e117);
    } else {
        if (_e90 == 1u) {
            let _e120 = (param_8 * 0.5f);
            if (_e120 > -8388608f) {
                let _e132 = f32(select(0i, select(select(i32(_e120), i32(-2147483648), (_e120 < bitcast<f32>(3472883712u))), 2147483647i, (_e120 > bitcast<f32>(1325400063u))), (_e120 == _e120)));
                if (_e132 > _e120) {
                    phi_354_ = 1f;
                } else {
                    phi_354_ = 0f;
                }
                let _e135 = phi_354_;
                if (_e120 < 8388608f) {
                    phi_359_ = (_e132 - _e135);
                    phi_360_ = false;
                } else {
                    phi_359_ = f32();
                    phi_360_ = true;
                }
                let _e138 = phi_359_;
                let _e140 = phi_360_;
                phi_361_ = _e138;
                phi_362_ = _e140;
            } else {
                phi_361_ = f32();
                phi_362_ = true;
            }
            let _e142 = phi_361_;
            let _e144 = phi_362_;
            if _e144 {
                phi_366_ = _e120;
            } else {
                phi_366_ = _e142;
            }
            let _e146 = phi_366_;
            let _e148 = (param_8 - (2f * _e146));
            if (_e148 > 1f) {
                phi_374_ = (2f - _e148);
            } else {
                phi_374_ = _e148;
            }
            let _e152 = phi_374_;
            phi_375_ = _e152;
        } else {
            phi_375_ = param_8;
        }
        let _e154 = phi_375_;
        phi_376_ = _e154;
    }
    let _e156 = phi_376_;
    if (_e156 > 0f) {
        if (_e156 < 1f) {
            phi_385_ = _e156;
        } else {
            phi_385_ = 1f;
        }
        let _e160 = phi_385_;
        phi_386_ = _e160;
    } else {
        phi_386_ = 0f;
    }
    let _e162 = phi_386_;
    let _e163 = (_e77 - 1u);
    let _e165 = (_e162 * f32(_e77));
    if _e85 {
        let _e172 = select(select(u32(_e165), 0u, (_e165 < bitcast<f32>(0u))), 4294967295u, (_e165 > bitcast<f32>(1333788671u)));
        if (_e163 < _e172) {
            phi_404_ = _e163;
        } else {
            phi_404_ = _e172;
        }
        let _e175 = phi_404_;
        phi_443_ = texture_Axis(_e175, _e175, 0f);
    } else {
        let _e177 = (_e165 + 0.5f);
        let _e184 = select(select(u32(_e177), 0u, (_e177 < bitcast<f32>(0u))), 4294967295u, (_e177 > bitcast<f32>(1333788671u)));
        if (_e77 < _e184) {
            phi_418_ = _e77;
        } else {
            phi_418_ = _e184;
        }
        let _e187 = phi_418_;
        if (_e90 == 0u) {
            phi_425_ = _e163;
        } else {
            phi_425_ = 0u;
        }
        let _e192 = phi_425_;
        if (_e90 == 0u) {
            phi_430_ = 0u;
        } else {
            phi_430_ = _e163;
        }
        let _e195 = phi_430_;
        if (_e187 == 0u) {
            phi_436_ = _e192;
        } else {
            phi_436_ = (_e187 - 1u);
        }
        let _e199 = phi_436_;
        if (_e187 > _e163) {
            phi_441_ = _e195;
        } else {
            phi_441_ = _e187;
        }
        let _e202 = phi_441_;
        phi_443_ = texture_Axis(_e199, _e202, (_e177 - f32(_e187)));
    }
    let _e205 = phi_443_;
    let _e207 = (*param_7).flags;
    let _e210 = ((_e207 >> bitcast<u32>(6u)) & 3u);
    if (_e210 == 0u) {
        if (param_9 > -8388608f) {
            let _e223 = f32(select(0i, select(select(i32(param_9), i32(-2147483648), (param_9 < bitcast<f32>(3472883712u))), 2147483647i, (param_9 > bitcast<f32>(1325400063u))), (param_9 == param_9)));
            if (_e223 > param_9) {
                phi_471_ = 1f;
            } else {
                phi_471_ = 0f;
            }
            let _e226 = phi_471_;
            if (param_9 < 8388608f) {
                phi_476_ = (_e223 - _e226);
                phi_477_ = false;
            } else {
                phi_476_ = f32();
                phi_477_ = true;
            }
            let _e229 = phi_476_;
            let _e231 = phi_477_;
            phi_478_ = _e229;
            phi_479_ = _e231;
        } else {
            phi_478_ = f32();
            phi_479_ = true;
        }
        let _e233 = phi_478_;
        let _e235 = phi_479_;
        if _e235 {
            phi_483_ = param_9;
        } else {
            phi_483_ = _e233;
        }
        let _e237 = phi_483_;
        phi_531_ = (param_9 - _e237);
    } else {
        if (_e210 == 1u) {
            let _e240 = (param_9 * 0.5f);
            if (_e240 > -8388608f) {
                let _e252 = f32(select(0i, select(select(i32(_e240), i32(-2147483648), (_e240 < bitcast<f32>(3472883712u))), 2147483647i, (_e240 > bitcast<f32>(1325400063u))), (_e240 == _e240)));
                if (_e252 > _e240) {
                    phi_509_ = 1f;
                } else {
                    phi_509_ = 0f;
                }
                let _e255 = phi_509_;
                if (_e240 < 8388608f) {
                    phi_514_ = (_e252 - _e255);
                    phi_515_ = false;
                } else {
                    phi_514_ = f32();
                    phi_515_ = true;
                }
                let _e258 = phi_514_;
                let _e260 = phi_515_;
                phi_516_ = _e258;
                phi_517_ = _e260;
            } else {
                phi_516_ = f32();
                phi_517_ = true;
            }
            let _e262 = phi_516_;
            let _e264 = phi_517_;
            if _e264 {
                phi_521_ = _e240;
            } else {
                phi_521_ = _e262;
            }
            let _e266 = phi_521_;
            let _e268 = (param_9 - (2f * _e266));
            if (_e268 > 1f) {
                phi_529_ = (2f - _e268);
            } else {
                phi_529_ = _e268;
            }
            let _e272 = phi_529_;
            phi_530_ = _e272;
        } else {
            phi_530_ = param_9;
        }
        let _e274 = phi_530_;
        phi_531_ = _e274;
    }
    let _e276 = phi_531_;
    if (_e276 > 0f) {
        if (_e276 < 1f) {
            phi_540_ = _e276;
        } else {
            phi_540_ = 1f;
        }
        let _e280 = phi_540_;
        phi_541_ = _e280;
    } else {
        phi_541_ = 0f;
    }
    let _e282 = phi_541_;
    let _e283 = (_e81 - 1u);
    let _e285 = (_e282 * f32(_e81));
    if _e85 {
        let _e292 = select(select(u32(_e285), 0u, (_e285 < bitcast<f32>(0u))), 4294967295u, (_e285 > bitcast<f32>(1333788671u)));
        if (_e283 < _e292) {
            phi_559_ = _e283;
        } else {
            phi_559_ = _e292;
        }
        let _e295 = phi_559_;
        phi_598_ = texture_Axis(_e295, _e295, 0f);
    } else {
        let _e297 = (_e285 + 0.5f);
        let _e304 = select(select(u32(_e297), 0u, (_e297 < bitcast<f32>(0u))), 4294967295u, (_e297 > bitcast<f32>(1333788671u)));
        if (_e81 < _e304) {
            phi_573_ = _e81;
        } else {
            phi_573_ = _e304;
        }
        let _e307 = phi_573_;
        if (_e210 == 0u) {
            phi_580_ = _e283;
        } else {
            phi_580_ = 0u;
        }
        let _e312 = phi_580_;
        if (_e210 == 0u) {
            phi_585_ = 0u;
        } else {
            phi_585_ = _e283;
        }
        let _e315 = phi_585_;
        if (_e307 == 0u) {
            phi_591_ = _e312;
        } else {
            phi_591_ = (_e307 - 1u);
        }
        let _e319 = phi_591_;
        if (_e307 > _e283) {
            phi_596_ = _e315;
        } else {
            phi_596_ = _e307;
        }
        let _e322 = phi_596_;
        phi_598_ = texture_Axis(_e319, _e322, (_e297 - f32(_e307)));
    }
    let _e325 = phi_598_;
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
    var phi_657_: f32;

    if (param_12 > param_13) {
        phi_657_ = param_12;
    } else {
        phi_657_ = param_13;
    }
    let _e76 = phi_657_;
    return _e76;
}

fn _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(param_14: vec3<f32>) -> vec3<f32> {
    return vec3<f32>(1f, 1f, 1f);
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var local_2: lt_bvh_traverse_Stack;
    var phi_814_: bool;
    var phi_815_: bool;
    var phi_816_: bool;
    var phi_817_: bool;
    var phi_821_: bool;
    var phi_834_: bool;
    var phi_835_: bool;
    var phi_836_: bool;
    var phi_837_: bool;
    var phi_841_: bool;
    var phi_854_: bool;
    var phi_855_: bool;
    var phi_856_: bool;
    var phi_860_: bool;
    var phi_861_: bool;
    var phi_862_: bool;
    var phi_863_: bool;
    var phi_864_: bool;
    var phi_868_: bool;
    var phi_944_: f32;
    var phi_951_: f32;
    var phi_959_: f32;
    var phi_966_: f32;
    var phi_974_: f32;
    var phi_981_: f32;
    var phi_1004_: f32;
    var phi_1009_: f32;
    var phi_1014_: f32;
    var phi_1019_: f32;
    var phi_1024_: f32;
    var phi_1043_: u32;
    var phi_1048_: u32;
    var phi_1053_: u32;
    var phi_1167_: bool;
    var phi_1168_: bool;
    var phi_1199_: u32;
    var phi_1201_: u32;
    var phi_1204_: lt_bvh_Hit;
    var phi_1289_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1316_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1343_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1349_: u32;
    var phi_1352_: u32;
    var phi_1366_: u32;
    var phi_1376_: u32;
    var phi_1386_: u32;
    var phi_1404_: u32;
    var phi_1414_: u32;
    var phi_1424_: u32;
    var phi_1460_: u32;
    var phi_1473_: u32;
    var phi_1478_: u32;
    var phi_1479_: u32;
    var phi_1480_: u32;
    var phi_1350_: u32;
    var phi_1353_: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_1538_: u32;
    var phi_1541_: lt_bvh_Hit;
    var phi_1596_: f32;
    var phi_1601_: f32;
    var phi_1606_: f32;
    var phi_1614_: f32;
    var phi_1619_: f32;
    var phi_1624_: f32;
    var phi_1756_: bool;
    var phi_1757_: bool;
    var phi_1758_: bool;
    var phi_1759_: bool;
    var phi_1763_: bool;
    var phi_1776_: bool;
    var phi_1777_: bool;
    var phi_1778_: bool;
    var phi_1779_: bool;
    var phi_1783_: bool;
    var phi_1796_: bool;
    var phi_1797_: bool;
    var phi_1798_: bool;
    var phi_1802_: bool;
    var phi_1803_: bool;
    var phi_1804_: bool;
    var phi_1805_: bool;
    var phi_1806_: bool;
    var phi_1810_: bool;
    var phi_1880_: f32;
    var phi_1887_: f32;
    var phi_1894_: f32;
    var phi_1901_: f32;
    var phi_1908_: f32;
    var phi_1915_: f32;
    var phi_1932_: f32;
    var phi_1937_: f32;
    var phi_1942_: f32;
    var phi_1947_: f32;
    var phi_1952_: f32;
    var phi_1978_: bool;
    var phi_1979_: bool;
    var phi_1987_: u32;
    var phi_1988_: u32;
    var phi_1999_: vec3<f32>;
    var phi_2000_: vec3<f32>;
    var phi_2013_: u32;
    var phi_2018_: u32;
    var phi_2023_: u32;
    var phi_2137_: bool;
    var phi_2138_: bool;
    var phi_2169_: u32;
    var phi_2171_: lt_bvh_Hit;
    var phi_2174_: u32;
    var phi_2255_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2282_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2309_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2315_: u32;
    var phi_2318_: u32;
    var phi_2332_: u32;
    var phi_2342_: u32;
    var phi_2352_: u32;
    var phi_2370_: u32;
    var phi_2380_: u32;
    var phi_2390_: u32;
    var phi_2426_: u32;
    var phi_2439_: u32;
    var phi_2444_: u32;
    var phi_2445_: u32;
    var phi_2446_: u32;
    var phi_2316_: u32;
    var phi_2319_: u32;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_2504_: lt_bvh_Hit;
    var phi_2507_: u32;
    var phi_2551_: vec3<f32>;
    var phi_2552_: vec3<f32>;
    var phi_2581_: vec3<f32>;
    var phi_2582_: vec3<f32>;
    var phi_2611_: vec3<f32>;
    var phi_2612_: vec3<f32>;
    var phi_2630_: bool;
    var phi_2631_: bool;
    var phi_2635_: f32;
    var phi_2636_: f32;
    var phi_2637_: f32;
    var phi_2638_: f32;
    var phi_2646_: f32;
    var phi_2656_: bool;
    var phi_2657_: bool;
    var phi_2661_: f32;
    var phi_2662_: f32;
    var phi_2663_: f32;
    var phi_2664_: f32;
    var phi_2672_: f32;
    var phi_2682_: bool;
    var phi_2683_: bool;
    var phi_2687_: f32;
    var phi_2688_: f32;
    var phi_2689_: f32;
    var phi_2690_: f32;
    var phi_2698_: f32;
    var phi_2713_: f32;
    var phi_2714_: bool;
    var phi_2715_: f32;
    var phi_2716_: bool;
    var phi_2717_: f32;
    var phi_2718_: bool;
    var phi_2736_: f32;
    var phi_2737_: bool;
    var phi_2738_: bool;
    var phi_2739_: f32;
    var phi_2740_: bool;
    var phi_2741_: bool;
    var phi_2745_: bool;
    var phi_2746_: f32;
    var phi_2747_: bool;
    var phi_2775_: vec3<f32>;
    var phi_2776_: vec3<f32>;
    var phi_2801_: vec3<f32>;
    var phi_2802_: vec3<f32>;
    var phi_2827_: vec3<f32>;
    var phi_2828_: vec3<f32>;
    var phi_2884_: f32;
    var phi_2893_: f32;
    var phi_2902_: f32;
    var phi_2911_: f32;
    var phi_2918_: f32;
    var phi_2925_: f32;
    var phi_2938_: f32;
    var phi_2947_: f32;
    var phi_2956_: f32;
    var phi_2965_: f32;
    var phi_2972_: f32;
    var phi_2979_: f32;
    var phi_2996_: f32;
    var phi_3001_: f32;
    var phi_3006_: f32;
    var phi_3014_: f32;
    var phi_3019_: f32;
    var phi_3024_: f32;
    var phi_3036_: f32;
    var phi_3041_: f32;
    var phi_3046_: f32;
    var phi_3051_: f32;
    var phi_3056_: lt_bvh_triangle_Intersection;
    var phi_3057_: bool;
    var phi_3058_: lt_bvh_triangle_Intersection;
    var phi_3059_: bool;
    var phi_3063_: lt_bvh_triangle_Intersection;
    var phi_3064_: bool;
    var phi_3065_: lt_bvh_triangle_Intersection;
    var phi_3066_: bool;
    var phi_3067_: bool;
    var phi_3071_: bool;
    var phi_3075_: lt_bvh_triangle_Intersection;
    var phi_3113_: bool;
    var phi_3114_: bool;
    var phi_3115_: bool;
    var phi_3116_: bool;
    var phi_3117_: bool;
    var phi_3118_: bool;
    var phi_3122_: bool;
    var phi_3123_: bool;
    var phi_3326_: f32;
    var phi_3329_: bool;
    var phi_3330_: bool;
    var phi_3334_: bool;
    var phi_3342_: lt_bvh_Hit;
    var phi_3343_: lt_bvh_Hit;
    var phi_3344_: lt_bvh_Hit;
    var phi_3345_: lt_bvh_Hit;
    var phi_2505_: lt_bvh_Hit;
    var phi_2508_: u32;
    var phi_3346_: bool;
    var phi_3385_: bool;
    var phi_3386_: bool;
    var phi_3417_: u32;
    var phi_2172_: lt_bvh_Hit;
    var phi_2175_: u32;
    var phi_3418_: lt_bvh_Hit;
    var phi_3419_: lt_bvh_Hit;
    var phi_3420_: bool;
    var phi_3424_: lt_bvh_Hit;
    var phi_3425_: lt_bvh_Hit;
    var phi_3426_: lt_bvh_Hit;
    var phi_3427_: lt_bvh_Hit;
    var phi_1539_: u32;
    var phi_1542_: lt_bvh_Hit;
    var phi_3428_: bool;
    var phi_3467_: bool;
    var phi_3468_: bool;
    var phi_3499_: u32;
    var phi_1202_: u32;
    var phi_1205_: lt_bvh_Hit;
    var phi_3500_: lt_bvh_Hit;
    var phi_3501_: lt_bvh_Hit;
    var phi_3502_: bool;
    var phi_3506_: lt_bvh_Hit;
    var phi_3694_: f32;
    var phi_3699_: f32;
    var phi_3704_: f32;
    var phi_3712_: f32;
    var phi_3717_: f32;
    var phi_3722_: f32;
    var phi_3786_: vec3<f32>;
    var phi_3907_: u32;
    var phi_3934_: f32;
    var phi_3941_: f32;
    var phi_3948_: f32;
    var phi_3983_: f32;
    var phi_3990_: f32;
    var phi_3997_: f32;
    var phi_4035_: f32;
    var phi_4042_: f32;
    var phi_4049_: f32;
    var phi_4135_: vec3<f32>;
    var phi_4136_: vec3<f32>;
    var phi_4137_: vec3<f32>;
    var phi_4146_: f32;
    var phi_4147_: f32;
    var phi_4157_: f32;
    var phi_4158_: f32;
    var phi_4168_: f32;
    var phi_4169_: f32;
    var phi_4204_: abi_Sample;
    var phi_4427_: vec3<f32>;
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
    if (bitcast<i32>(_e109.word) != 0i) {
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
                phi_814_ = (abs(_e183.origin.z) < 1000000000000000f);
                phi_815_ = false;
            } else {
                phi_814_ = bool();
                phi_815_ = true;
            }
            let _e204 = phi_814_;
            let _e206 = phi_815_;
            phi_816_ = _e204;
            phi_817_ = _e206;
        } else {
            phi_816_ = bool();
            phi_817_ = true;
        }
        let _e208 = phi_816_;
        let _e210 = phi_817_;
        if _e210 {
            phi_821_ = false;
        } else {
            phi_821_ = _e208;
        }
        let _e212 = phi_821_;
        if _e212 {
            if (_e188 < 1000000000000000f) {
                if (_e190 < 1000000000000000f) {
                    phi_834_ = (_e192 < 1000000000000000f);
                    phi_835_ = false;
                } else {
                    phi_834_ = bool();
                    phi_835_ = true;
                }
                let _e217 = phi_834_;
                let _e219 = phi_835_;
                phi_836_ = _e217;
                phi_837_ = _e219;
            } else {
                phi_836_ = bool();
                phi_837_ = true;
            }
            let _e221 = phi_836_;
            let _e223 = phi_837_;
            if _e223 {
                phi_841_ = false;
            } else {
                phi_841_ = _e221;
            }
            let _e225 = phi_841_;
            if _e225 {
                if (_e188 > 0f) {
                    phi_855_ = bool();
                    phi_856_ = true;
                } else {
                    let _e227 = (_e190 > 0f);
                    if _e227 {
                        phi_854_ = bool();
                    } else {
                        phi_854_ = (_e192 > 0f);
                    }
                    let _e230 = phi_854_;
                    phi_855_ = _e230;
                    phi_856_ = _e227;
                }
                let _e232 = phi_855_;
                let _e234 = phi_856_;
                if _e234 {
                    phi_860_ = true;
                } else {
                    phi_860_ = _e232;
                }
                let _e236 = phi_860_;
                phi_861_ = _e236;
                phi_862_ = false;
            } else {
                phi_861_ = bool();
                phi_862_ = true;
            }
            let _e238 = phi_861_;
            let _e240 = phi_862_;
            phi_863_ = _e238;
            phi_864_ = _e240;
        } else {
            phi_863_ = bool();
            phi_864_ = true;
        }
        let _e242 = phi_863_;
        let _e244 = phi_864_;
        if _e244 {
            phi_868_ = false;
        } else {
            phi_868_ = _e242;
        }
        let _e246 = phi_868_;
        if _e246 {
            let _e247 = (_e115 >= _e79);
            if _e247 {
                phi_3500_ = lt_bvh_Hit();
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
                    phi_944_ = _e318;
                } else {
                    phi_944_ = abs(_e183.direction.x);
                }
                let _e324 = phi_944_;
                if (_e183.direction.x < 0f) {
                    phi_951_ = (-1f / _e324);
                } else {
                    phi_951_ = (1f / _e324);
                }
                let _e329 = phi_951_;
                if (abs(_e183.direction.y) < _e318) {
                    phi_959_ = _e318;
                } else {
                    phi_959_ = abs(_e183.direction.y);
                }
                let _e335 = phi_959_;
                if (_e183.direction.y < 0f) {
                    phi_966_ = (-1f / _e335);
                } else {
                    phi_966_ = (1f / _e335);
                }
                let _e340 = phi_966_;
                if (abs(_e183.direction.z) < _e318) {
                    phi_974_ = _e318;
                } else {
                    phi_974_ = abs(_e183.direction.z);
                }
                let _e346 = phi_974_;
                if (_e183.direction.z < 0f) {
                    phi_981_ = (-1f / _e346);
                } else {
                    phi_981_ = (1f / _e346);
                }
                let _e351 = phi_981_;
                let _e358 = abs((bitcast<f32>(_e253) - _e183.origin.x));
                let _e359 = abs((bitcast<f32>(_e257) - _e183.origin.y));
                let _e360 = abs((bitcast<f32>(_e261) - _e183.origin.z));
                let _e367 = abs(((bitcast<f32>(_e265) + (bitcast<f32>((((_e277 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e183.origin.x));
                let _e368 = abs(((bitcast<f32>(_e269) + (bitcast<f32>((((_e277 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e183.origin.y));
                let _e369 = abs(((bitcast<f32>(_e273) + (bitcast<f32>((((_e277 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e183.origin.z));
                if (_e358 > _e367) {
                    phi_1004_ = _e358;
                } else {
                    phi_1004_ = _e367;
                }
                let _e372 = phi_1004_;
                if (_e359 > _e368) {
                    phi_1009_ = _e359;
                } else {
                    phi_1009_ = _e368;
                }
                let _e375 = phi_1009_;
                if (_e360 > _e369) {
                    phi_1014_ = _e360;
                } else {
                    phi_1014_ = _e369;
                }
                let _e378 = phi_1014_;
                if (_e372 > _e375) {
                    phi_1019_ = _e372;
                } else {
                    phi_1019_ = _e375;
                }
                let _e381 = phi_1019_;
                if (_e381 > _e378) {
                    phi_1024_ = _e381;
                } else {
                    phi_1024_ = _e378;
                }
                let _e384 = phi_1024_;
                let _e388 = (_e384 * 0.0000019073486f);
                let _e389 = (abs(_e329) * _e388);
                let _e390 = (abs(_e340) * _e388);
                let _e391 = (abs(_e351) * _e388);
                let _e395 = (_e384 * 0.0000009536743f);
                let _e396 = (abs(_e329) * _e395);
                let _e397 = (abs(_e340) * _e395);
                let _e398 = (abs(_e351) * _e395);
                if (_e329 < 0f) {
                    phi_1043_ = 0u;
                } else {
                    phi_1043_ = 1u;
                }
                let _e401 = phi_1043_;
                if (_e340 < 0f) {
                    phi_1048_ = 0u;
                } else {
                    phi_1048_ = 2u;
                }
                let _e404 = phi_1048_;
                if (_e351 < 0f) {
                    phi_1053_ = 0u;
                } else {
                    phi_1053_ = 4u;
                }
                let _e407 = phi_1053_;
                let _e409 = ((_e401 | _e404) | _e407);
                let _e410 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e115, 2147483648u);
                local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e410.first[0], _e410.first[1], _e410.first[2], _e410.first[3], _e410.first[4], _e410.first[5], _e410.first[6], _e410.first[7], _e410.first[8], _e410.first[9], _e410.first[10], _e410.first[11], _e410.first[12], _e410.first[13], _e410.first[14], _e410.first[15], _e410.first[16], _e410.first[17], _e410.first[18], _e410.first[19], _e410.first[20], _e410.first[21], _e410.first[22], _e410.first[23], _e410.first[24], _e410.first[25], _e410.first[26], _e410.first[27], _e410.first[28], _e410.first[29], _e410.first[30], _e410.first[31]), array<u32, 32>(_e410.mask[0], _e410.mask[1], _e410.mask[2], _e410.mask[3], _e410.mask[4], _e410.mask[5], _e410.mask[6], _e410.mask[7], _e410.mask[8], _e410.mask[9], _e410.mask[10], _e410.mask[11], _e410.mask[12], _e410.mask[13], _e410.mask[14], _e410.mask[15], _e410.mask[16], _e410.mask[17], _e410.mask[18], _e410.mask[19], _e410.mask[20], _e410.mask[21], _e410.mask[22], _e410.mask[23], _e410.mask[24], _e410.mask[25], _e410.mask[26], _e410.mask[27], _e410.mask[28], _e410.mask[29], _e410.mask[30], _e410.mask[31]), _e410.len, _e410.group, _e410.group_mask);
                let _e484 = local_2.group_mask;
                if ((_e484 & 4278190080u) == 0u) {
                    let _e488 = local_2.len;
                    if (_e488 == 0u) {
                        phi_1167_ = false;
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
                        phi_1167_ = true;
                    }
                    let _e511 = phi_1167_;
                    phi_1168_ = _e511;
                } else {
                    phi_1168_ = true;
                }
                let _e513 = phi_1168_;
                if _e513 {
                    let _e515 = local_2.group_mask;
                    let _e521 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e515)), 32u, (_e515 == 0u)));
                    let _e525 = local_2.group_mask;
                    let _e539 = local_2.group_mask;
                    local_2.group_mask = (_e539 & ~((1u << bitcast<u32>((_e521 & 31u)))));
                    let _e542 = local_2.group;
                    phi_1199_ = (_e542 + countOneBits(((_e525 & ~((4294967295u << bitcast<u32>((((_e521 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1199_ = 4294967295u;
                }
                let _e545 = phi_1199_;
                phi_1201_ = _e545;
                phi_1204_ = _e185;
                loop {
                    let _e547 = phi_1201_;
                    let _e549 = phi_1204_;
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
                            let _e625 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e614.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e631 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e625.unnamed.word, _e614.w), _e625.unnamed_1);
                            let _e637 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e631.unnamed, lt_mask_LightPlace(_e614.x, _e631.unnamed_1.shift));
                            phi_1289_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e637.unnamed, lt_mask_LightPlace(_e637.unnamed_1.word, _e614.y));
                        } else {
                            let _e653 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e614.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e659 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e653.unnamed.word, _e614.y), _e653.unnamed_1);
                            let _e665 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e659.unnamed, lt_mask_LightPlace(_e614.z, _e659.unnamed_1.shift));
                            phi_1289_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e665.unnamed, lt_mask_LightPlace(_e665.unnamed_1.word, _e614.w));
                        }
                        let _e673 = phi_1289_;
                        let _e683 = nodes.member[(0u + _e547)].y;
                        if (_e340 < 0f) {
                            let _e694 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e683.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e700 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e694.unnamed.word, _e683.w), _e694.unnamed_1);
                            let _e706 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e700.unnamed, lt_mask_LightPlace(_e683.x, _e700.unnamed_1.shift));
                            phi_1316_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e706.unnamed, lt_mask_LightPlace(_e706.unnamed_1.word, _e683.y));
                        } else {
                            let _e722 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e683.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e728 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e722.unnamed.word, _e683.y), _e722.unnamed_1);
                            let _e734 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e728.unnamed, lt_mask_LightPlace(_e683.z, _e728.unnamed_1.shift));
                            phi_1316_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e734.unnamed, lt_mask_LightPlace(_e734.unnamed_1.word, _e683.w));
                        }
                        let _e742 = phi_1316_;
                        let _e752 = nodes.member[(0u + _e547)].z;
                        if (_e351 < 0f) {
                            let _e763 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e752.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e769 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e763.unnamed.word, _e752.w), _e763.unnamed_1);
                            let _e775 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e769.unnamed, lt_mask_LightPlace(_e752.x, _e769.unnamed_1.shift));
                            phi_1343_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e775.unnamed, lt_mask_LightPlace(_e775.unnamed_1.word, _e752.y));
                        } else {
                            let _e791 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e752.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e797 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e791.unnamed.word, _e752.y), _e791.unnamed_1);
                            let _e803 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e797.unnamed, lt_mask_LightPlace(_e752.z, _e797.unnamed_1.shift));
                            phi_1343_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e803.unnamed, lt_mask_LightPlace(_e803.unnamed_1.word, _e752.w));
                        }
                        let _e811 = phi_1343_;
                        phi_1349_ = 0u;
                        phi_1352_ = 0u;
                        loop {
                            let _e821 = phi_1349_;
                            let _e823 = phi_1352_;
                            local_3 = _e823;
                            local_4 = _e823;
                            local_5 = _e823;
                            let _e824 = (_e821 < 8u);
                            if _e824 {
                                let _e826 = (_e821 >> bitcast<u32>(2i));
                                let _e827 = (_e821 & 3u);
                                if (_e826 == 0u) {
                                    phi_1366_ = _e673.unnamed.word;
                                } else {
                                    phi_1366_ = _e673.unnamed.shift;
                                }
                                let _e830 = phi_1366_;
                                if (_e826 == 0u) {
                                    phi_1376_ = _e742.unnamed.word;
                                } else {
                                    phi_1376_ = _e742.unnamed.shift;
                                }
                                let _e839 = phi_1376_;
                                if (_e826 == 0u) {
                                    phi_1386_ = _e811.unnamed.word;
                                } else {
                                    phi_1386_ = _e811.unnamed.shift;
                                }
                                let _e848 = phi_1386_;
                                let _e861 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e830 >> bitcast<u32>(((_e827 * 8u) & 31u))) & 255u)) * _e583) + (_e604 - _e389)), ((f32(((_e839 >> bitcast<u32>(((_e827 * 8u) & 31u))) & 255u)) * _e584) + (_e605 - _e390)));
                                let _e862 = core_intrinsics_maximum_number_nsz_f32_(_e861, ((f32(((_e848 >> bitcast<u32>(((_e827 * 8u) & 31u))) & 255u)) * _e585) + (_e606 - _e391)));
                                if (_e826 == 0u) {
                                    phi_1404_ = _e673.unnamed_1.word;
                                } else {
                                    phi_1404_ = _e673.unnamed_1.shift;
                                }
                                let _e865 = phi_1404_;
                                if (_e826 == 0u) {
                                    phi_1414_ = _e742.unnamed_1.word;
                                } else {
                                    phi_1414_ = _e742.unnamed_1.shift;
                                }
                                let _e874 = phi_1414_;
                                if (_e826 == 0u) {
                                    phi_1424_ = _e811.unnamed_1.word;
                                } else {
                                    phi_1424_ = _e811.unnamed_1.shift;
                                }
                                let _e883 = phi_1424_;
                                let _e896 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e865 >> bitcast<u32>(((_e827 * 8u) & 31u))) & 255u)) * _e583) + (_e604 + _e389)), ((f32(((_e874 >> bitcast<u32>(((_e827 * 8u) & 31u))) & 255u)) * _e584) + (_e605 + _e390)));
                                let _e897 = core_intrinsics_minimum_number_nsz_f32_(_e896, ((f32(((_e883 >> bitcast<u32>(((_e827 * 8u) & 31u))) & 255u)) * _e585) + (_e606 + _e391)));
                                if (_e862 <= _e897) {
                                    if (_e862 <= _e549.t) {
                                        if (_e897 >= _e183.tmin) {
                                            if (_e826 == 0u) {
                                                let _e904 = nodes.member[(0u + _e547)].links[2u];
                                                phi_1460_ = _e904;
                                            } else {
                                                let _e907 = nodes.member[(0u + _e547)].links[3u];
                                                phi_1460_ = _e907;
                                            }
                                            let _e909 = phi_1460_;
                                            let _e914 = ((_e909 >> bitcast<u32>(((_e827 * 8u) & 31u))) & 255u);
                                            let _e915 = (_e914 & 31u);
                                            if (_e915 >= 24u) {
                                                phi_1473_ = (24u + ((_e915 - 24u) ^ _e409));
                                            } else {
                                                phi_1473_ = _e915;
                                            }
                                            let _e921 = phi_1473_;
                                            phi_1478_ = (_e823 | ((_e914 >> bitcast<u32>(5i)) << bitcast<u32>((_e921 & 31u))));
                                        } else {
                                            phi_1478_ = _e823;
                                        }
                                        let _e929 = phi_1478_;
                                        phi_1479_ = _e929;
                                    } else {
                                        phi_1479_ = _e823;
                                    }
                                    let _e931 = phi_1479_;
                                    phi_1480_ = _e931;
                                } else {
                                    phi_1480_ = _e823;
                                }
                                let _e933 = phi_1480_;
                                phi_1350_ = (_e821 + 1u);
                                phi_1353_ = _e933;
                            } else {
                                phi_1350_ = u32();
                                phi_1353_ = u32();
                            }
                            let _e936 = phi_1350_;
                            let _e938 = phi_1353_;
                            continue;
                            continuing {
                                phi_1349_ = _e936;
                                phi_1352_ = _e938;
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
                        phi_1538_ = (_e987 & 16777215u);
                        phi_1541_ = _e549;
                        loop {
                            let _e990 = phi_1538_;
                            let _e992 = phi_1541_;
                            local_11 = _e992;
                            if (_e990 == 0u) {
                                phi_1539_ = u32();
                                phi_1542_ = lt_bvh_Hit();
                                phi_3428_ = false;
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
                                    phi_1596_ = _e1019;
                                } else {
                                    phi_1596_ = _e1031;
                                }
                                let _e1036 = phi_1596_;
                                if (_e1020 < _e1032) {
                                    phi_1601_ = _e1020;
                                } else {
                                    phi_1601_ = _e1032;
                                }
                                let _e1039 = phi_1601_;
                                if (_e1021 < _e1033) {
                                    phi_1606_ = _e1021;
                                } else {
                                    phi_1606_ = _e1033;
                                }
                                let _e1042 = phi_1606_;
                                if (_e1019 > _e1031) {
                                    phi_1614_ = _e1019;
                                } else {
                                    phi_1614_ = _e1031;
                                }
                                let _e1048 = phi_1614_;
                                if (_e1020 > _e1032) {
                                    phi_1619_ = _e1020;
                                } else {
                                    phi_1619_ = _e1032;
                                }
                                let _e1051 = phi_1619_;
                                if (_e1021 > _e1033) {
                                    phi_1624_ = _e1021;
                                } else {
                                    phi_1624_ = _e1033;
                                }
                                let _e1054 = phi_1624_;
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
                                                    phi_1756_ = (abs(_e1110) < 1000000000000000f);
                                                    phi_1757_ = false;
                                                } else {
                                                    phi_1756_ = bool();
                                                    phi_1757_ = true;
                                                }
                                                let _e1172 = phi_1756_;
                                                let _e1174 = phi_1757_;
                                                phi_1758_ = _e1172;
                                                phi_1759_ = _e1174;
                                            } else {
                                                phi_1758_ = bool();
                                                phi_1759_ = true;
                                            }
                                            let _e1176 = phi_1758_;
                                            let _e1178 = phi_1759_;
                                            if _e1178 {
                                                phi_1763_ = false;
                                            } else {
                                                phi_1763_ = _e1176;
                                            }
                                            let _e1180 = phi_1763_;
                                            if _e1180 {
                                                if (_e1162 < 1000000000000000f) {
                                                    if (_e1163 < 1000000000000000f) {
                                                        phi_1776_ = (_e1164 < 1000000000000000f);
                                                        phi_1777_ = false;
                                                    } else {
                                                        phi_1776_ = bool();
                                                        phi_1777_ = true;
                                                    }
                                                    let _e1185 = phi_1776_;
                                                    let _e1187 = phi_1777_;
                                                    phi_1778_ = _e1185;
                                                    phi_1779_ = _e1187;
                                                } else {
                                                    phi_1778_ = bool();
                                                    phi_1779_ = true;
                                                }
                                                let _e1189 = phi_1778_;
                                                let _e1191 = phi_1779_;
                                                if _e1191 {
                                                    phi_1783_ = false;
                                                } else {
                                                    phi_1783_ = _e1189;
                                                }
                                                let _e1193 = phi_1783_;
                                                if _e1193 {
                                                    if (_e1162 > 0f) {
                                                        phi_1797_ = bool();
                                                        phi_1798_ = true;
                                                    } else {
                                                        let _e1195 = (_e1163 > 0f);
                                                        if _e1195 {
                                                            phi_1796_ = bool();
                                                        } else {
                                                            phi_1796_ = (_e1164 > 0f);
                                                        }
                                                        let _e1198 = phi_1796_;
                                                        phi_1797_ = _e1198;
                                                        phi_1798_ = _e1195;
                                                    }
                                                    let _e1200 = phi_1797_;
                                                    let _e1202 = phi_1798_;
                                                    if _e1202 {
                                                        phi_1802_ = true;
                                                    } else {
                                                        phi_1802_ = _e1200;
                                                    }
                                                    let _e1204 = phi_1802_;
                                                    phi_1803_ = _e1204;
                                                    phi_1804_ = false;
                                                } else {
                                                    phi_1803_ = bool();
                                                    phi_1804_ = true;
                                                }
                                                let _e1206 = phi_1803_;
                                                let _e1208 = phi_1804_;
                                                phi_1805_ = _e1206;
                                                phi_1806_ = _e1208;
                                            } else {
                                                phi_1805_ = bool();
                                                phi_1806_ = true;
                                            }
                                            let _e1210 = phi_1805_;
                                            let _e1212 = phi_1806_;
                                            if _e1212 {
                                                phi_1810_ = false;
                                            } else {
                                                phi_1810_ = _e1210;
                                            }
                                            let _e1214 = phi_1810_;
                                            if _e1214 {
                                                let _e1215 = (_e1159 >= _e79);
                                                if _e1215 {
                                                    phi_3418_ = lt_bvh_Hit();
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
                                                        phi_1880_ = _e1281;
                                                    } else {
                                                        phi_1880_ = abs(_e1128);
                                                    }
                                                    let _e1286 = phi_1880_;
                                                    if (_e1128 < 0f) {
                                                        phi_1887_ = (-1f / _e1286);
                                                    } else {
                                                        phi_1887_ = (1f / _e1286);
                                                    }
                                                    let _e1291 = phi_1887_;
                                                    if (abs(_e1141) < _e1281) {
                                                        phi_1894_ = _e1281;
                                                    } else {
                                                        phi_1894_ = abs(_e1141);
                                                    }
                                                    let _e1296 = phi_1894_;
                                                    if (_e1141 < 0f) {
                                                        phi_1901_ = (-1f / _e1296);
                                                    } else {
                                                        phi_1901_ = (1f / _e1296);
                                                    }
                                                    let _e1301 = phi_1901_;
                                                    if (abs(_e1154) < _e1281) {
                                                        phi_1908_ = _e1281;
                                                    } else {
                                                        phi_1908_ = abs(_e1154);
                                                    }
                                                    let _e1306 = phi_1908_;
                                                    if (_e1154 < 0f) {
                                                        phi_1915_ = (-1f / _e1306);
                                                    } else {
                                                        phi_1915_ = (1f / _e1306);
                                                    }
                                                    let _e1311 = phi_1915_;
                                                    let _e1315 = abs((bitcast<f32>(_e1221) - _e1084));
                                                    let _e1316 = abs((bitcast<f32>(_e1225) - _e1097));
                                                    let _e1317 = abs((bitcast<f32>(_e1229) - _e1110));
                                                    let _e1321 = abs(((bitcast<f32>(_e1233) + (bitcast<f32>((((_e1245 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1084));
                                                    let _e1322 = abs(((bitcast<f32>(_e1237) + (bitcast<f32>((((_e1245 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1097));
                                                    let _e1323 = abs(((bitcast<f32>(_e1241) + (bitcast<f32>((((_e1245 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1110));
                                                    if (_e1315 > _e1321) {
                                                        phi_1932_ = _e1315;
                                                    } else {
                                                        phi_1932_ = _e1321;
                                                    }
                                                    let _e1326 = phi_1932_;
                                                    if (_e1316 > _e1322) {
                                                        phi_1937_ = _e1316;
                                                    } else {
                                                        phi_1937_ = _e1322;
                                                    }
                                                    let _e1329 = phi_1937_;
                                                    if (_e1317 > _e1323) {
                                                        phi_1942_ = _e1317;
                                                    } else {
                                                        phi_1942_ = _e1323;
                                                    }
                                                    let _e1332 = phi_1942_;
                                                    if (_e1326 > _e1329) {
                                                        phi_1947_ = _e1326;
                                                    } else {
                                                        phi_1947_ = _e1329;
                                                    }
                                                    let _e1335 = phi_1947_;
                                                    if (_e1335 > _e1332) {
                                                        phi_1952_ = _e1335;
                                                    } else {
                                                        phi_1952_ = _e1332;
                                                    }
                                                    let _e1338 = phi_1952_;
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
                                                            phi_1978_ = false;
                                                        } else {
                                                            phi_1978_ = true;
                                                        }
                                                        let _e1359 = phi_1978_;
                                                        phi_1979_ = _e1359;
                                                    } else {
                                                        phi_1979_ = true;
                                                    }
                                                    let _e1361 = phi_1979_;
                                                    if _e1361 {
                                                        if (_e1354 >= _e1355) {
                                                            phi_1987_ = 1u;
                                                        } else {
                                                            phi_1987_ = 2u;
                                                        }
                                                        let _e1364 = phi_1987_;
                                                        phi_1988_ = _e1364;
                                                    } else {
                                                        phi_1988_ = 0u;
                                                    }
                                                    let _e1366 = phi_1988_;
                                                    if (_e1366 == 0u) {
                                                        phi_2000_ = vec3<f32>(_e1141, _e1154, _e1128);
                                                    } else {
                                                        if (_e1366 == 1u) {
                                                            phi_1999_ = vec3<f32>(_e1154, _e1128, _e1141);
                                                        } else {
                                                            phi_1999_ = vec3<f32>(_e1128, _e1141, _e1154);
                                                        }
                                                        let _e1372 = phi_1999_;
                                                        phi_2000_ = _e1372;
                                                    }
                                                    let _e1374 = phi_2000_;
                                                    let _e1377 = (_e1374.x / _e1374.z);
                                                    let _e1380 = (_e1374.y / _e1374.z);
                                                    if (_e1291 < 0f) {
                                                        phi_2013_ = 0u;
                                                    } else {
                                                        phi_2013_ = 1u;
                                                    }
                                                    let _e1385 = phi_2013_;
                                                    if (_e1301 < 0f) {
                                                        phi_2018_ = 0u;
                                                    } else {
                                                        phi_2018_ = 2u;
                                                    }
                                                    let _e1388 = phi_2018_;
                                                    if (_e1311 < 0f) {
                                                        phi_2023_ = 0u;
                                                    } else {
                                                        phi_2023_ = 4u;
                                                    }
                                                    let _e1391 = phi_2023_;
                                                    let _e1393 = ((_e1385 | _e1388) | _e1391);
                                                    let _e1394 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1159, 2147483648u);
                                                    local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e1394.first[0], _e1394.first[1], _e1394.first[2], _e1394.first[3], _e1394.first[4], _e1394.first[5], _e1394.first[6], _e1394.first[7], _e1394.first[8], _e1394.first[9], _e1394.first[10], _e1394.first[11], _e1394.first[12], _e1394.first[13], _e1394.first[14], _e1394.first[15], _e1394.first[16], _e1394.first[17], _e1394.first[18], _e1394.first[19], _e1394.first[20], _e1394.first[21], _e1394.first[22], _e1394.first[23], _e1394.first[24], _e1394.first[25], _e1394.first[26], _e1394.first[27], _e1394.first[28], _e1394.first[29], _e1394.first[30], _e1394.first[31]), array<u32, 32>(_e1394.mask[0], _e1394.mask[1], _e1394.mask[2], _e1394.mask[3], _e1394.mask[4], _e1394.mask[5], _e1394.mask[6], _e1394.mask[7], _e1394.mask[8], _e1394.mask[9], _e1394.mask[10], _e1394.mask[11], _e1394.mask[12], _e1394.mask[13], _e1394.mask[14], _e1394.mask[15], _e1394.mask[16], _e1394.mask[17], _e1394.mask[18], _e1394.mask[19], _e1394.mask[20], _e1394.mask[21], _e1394.mask[22], _e1394.mask[23], _e1394.mask[24], _e1394.mask[25], _e1394.mask[26], _e1394.mask[27], _e1394.mask[28], _e1394.mask[29], _e1394.mask[30], _e1394.mask[31]), _e1394.len, _e1394.group, _e1394.group_mask);
                                                    let _e1468 = local_1.group_mask;
                                                    if ((_e1468 & 4278190080u) == 0u) {
                                                        let _e1472 = local_1.len;
                                                        if (_e1472 == 0u) {
                                                            phi_2137_ = false;
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
                                                            phi_2137_ = true;
                                                        }
                                                        let _e1495 = phi_2137_;
                                                        phi_2138_ = _e1495;
                                                    } else {
                                                        phi_2138_ = true;
                                                    }
                                                    let _e1497 = phi_2138_;
                                                    if _e1497 {
                                                        let _e1499 = local_1.group_mask;
                                                        let _e1505 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1499)), 32u, (_e1499 == 0u)));
                                                        let _e1509 = local_1.group_mask;
                                                        let _e1523 = local_1.group_mask;
                                                        local_1.group_mask = (_e1523 & ~((1u << bitcast<u32>((_e1505 & 31u)))));
                                                        let _e1526 = local_1.group;
                                                        phi_2169_ = (_e1526 + countOneBits(((_e1509 & ~((4294967295u << bitcast<u32>((((_e1505 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_2169_ = 4294967295u;
                                                    }
                                                    let _e1529 = phi_2169_;
                                                    phi_2171_ = _e992;
                                                    phi_2174_ = _e1529;
                                                    loop {
                                                        let _e1531 = phi_2171_;
                                                        let _e1533 = phi_2174_;
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
                                                                let _e1605 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1594.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1611 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1605.unnamed.word, _e1594.w), _e1605.unnamed_1);
                                                                let _e1617 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1611.unnamed, lt_mask_LightPlace(_e1594.x, _e1611.unnamed_1.shift));
                                                                phi_2255_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1617.unnamed, lt_mask_LightPlace(_e1617.unnamed_1.word, _e1594.y));
                                                            } else {
                                                                let _e1633 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1594.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1639 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1633.unnamed.word, _e1594.y), _e1633.unnamed_1);
                                                                let _e1645 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1639.unnamed, lt_mask_LightPlace(_e1594.z, _e1639.unnamed_1.shift));
                                                                phi_2255_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1645.unnamed, lt_mask_LightPlace(_e1645.unnamed_1.word, _e1594.w));
                                                            }
                                                            let _e1653 = phi_2255_;
                                                            let _e1663 = nodes.member[(0u + _e1533)].y;
                                                            if (_e1301 < 0f) {
                                                                let _e1674 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1663.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1680 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1674.unnamed.word, _e1663.w), _e1674.unnamed_1);
                                                                let _e1686 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1680.unnamed, lt_mask_LightPlace(_e1663.x, _e1680.unnamed_1.shift));
                                                                phi_2282_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1686.unnamed, lt_mask_LightPlace(_e1686.unnamed_1.word, _e1663.y));
                                                            } else {
                                                                let _e1702 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1663.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1708 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1702.unnamed.word, _e1663.y), _e1702.unnamed_1);
                                                                let _e1714 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1708.unnamed, lt_mask_LightPlace(_e1663.z, _e1708.unnamed_1.shift));
                                                                phi_2282_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1714.unnamed, lt_mask_LightPlace(_e1714.unnamed_1.word, _e1663.w));
                                                            }
                                                            let _e1722 = phi_2282_;
                                                            let _e1732 = nodes.member[(0u + _e1533)].z;
                                                            if (_e1311 < 0f) {
                                                                let _e1743 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1732.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1749 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1743.unnamed.word, _e1732.w), _e1743.unnamed_1);
                                                                let _e1755 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1749.unnamed, lt_mask_LightPlace(_e1732.x, _e1749.unnamed_1.shift));
                                                                phi_2309_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1755.unnamed, lt_mask_LightPlace(_e1755.unnamed_1.word, _e1732.y));
                                                            } else {
                                                                let _e1771 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1732.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1777 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1771.unnamed.word, _e1732.y), _e1771.unnamed_1);
                                                                let _e1783 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1777.unnamed, lt_mask_LightPlace(_e1732.z, _e1777.unnamed_1.shift));
                                                                phi_2309_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1783.unnamed, lt_mask_LightPlace(_e1783.unnamed_1.word, _e1732.w));
                                                            }
                                                            let _e1791 = phi_2309_;
                                                            phi_2315_ = 0u;
                                                            phi_2318_ = 0u;
                                                            loop {
                                                                let _e1801 = phi_2315_;
                                                                let _e1803 = phi_2318_;
                                                                local_6 = _e1803;
                                                                local_7 = _e1803;
                                                                local_8 = _e1803;
                                                                let _e1804 = (_e1801 < 8u);
                                                                if _e1804 {
                                                                    let _e1806 = (_e1801 >> bitcast<u32>(2i));
                                                                    let _e1807 = (_e1801 & 3u);
                                                                    if (_e1806 == 0u) {
                                                                        phi_2332_ = _e1653.unnamed.word;
                                                                    } else {
                                                                        phi_2332_ = _e1653.unnamed.shift;
                                                                    }
                                                                    let _e1810 = phi_2332_;
                                                                    if (_e1806 == 0u) {
                                                                        phi_2342_ = _e1722.unnamed.word;
                                                                    } else {
                                                                        phi_2342_ = _e1722.unnamed.shift;
                                                                    }
                                                                    let _e1819 = phi_2342_;
                                                                    if (_e1806 == 0u) {
                                                                        phi_2352_ = _e1791.unnamed.word;
                                                                    } else {
                                                                        phi_2352_ = _e1791.unnamed.shift;
                                                                    }
                                                                    let _e1828 = phi_2352_;
                                                                    let _e1841 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1810 >> bitcast<u32>(((_e1807 * 8u) & 31u))) & 255u)) * _e1566) + (_e1584 - _e1343)), ((f32(((_e1819 >> bitcast<u32>(((_e1807 * 8u) & 31u))) & 255u)) * _e1567) + (_e1585 - _e1344)));
                                                                    let _e1842 = core_intrinsics_maximum_number_nsz_f32_(_e1841, ((f32(((_e1828 >> bitcast<u32>(((_e1807 * 8u) & 31u))) & 255u)) * _e1568) + (_e1586 - _e1345)));
                                                                    if (_e1806 == 0u) {
                                                                        phi_2370_ = _e1653.unnamed_1.word;
                                                                    } else {
                                                                        phi_2370_ = _e1653.unnamed_1.shift;
                                                                    }
                                                                    let _e1845 = phi_2370_;
                                                                    if (_e1806 == 0u) {
                                                                        phi_2380_ = _e1722.unnamed_1.word;
                                                                    } else {
                                                                        phi_2380_ = _e1722.unnamed_1.shift;
                                                                    }
                                                                    let _e1854 = phi_2380_;
                                                                    if (_e1806 == 0u) {
                                                                        phi_2390_ = _e1791.unnamed_1.word;
                                                                    } else {
                                                                        phi_2390_ = _e1791.unnamed_1.shift;
                                                                    }
                                                                    let _e1863 = phi_2390_;
                                                                    let _e1876 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1845 >> bitcast<u32>(((_e1807 * 8u) & 31u))) & 255u)) * _e1566) + (_e1584 + _e1343)), ((f32(((_e1854 >> bitcast<u32>(((_e1807 * 8u) & 31u))) & 255u)) * _e1567) + (_e1585 + _e1344)));
                                                                    let _e1877 = core_intrinsics_minimum_number_nsz_f32_(_e1876, ((f32(((_e1863 >> bitcast<u32>(((_e1807 * 8u) & 31u))) & 255u)) * _e1568) + (_e1586 + _e1345)));
                                                                    if (_e1842 <= _e1877) {
                                                                        if (_e1842 <= _e1531.t) {
                                                                            if (_e1877 >= _e183.tmin) {
                                                                                if (_e1806 == 0u) {
                                                                                    let _e1884 = nodes.member[(0u + _e1533)].links[2u];
                                                                                    phi_2426_ = _e1884;
                                                                                } else {
                                                                                    let _e1887 = nodes.member[(0u + _e1533)].links[3u];
                                                                                    phi_2426_ = _e1887;
                                                                                }
                                                                                let _e1889 = phi_2426_;
                                                                                let _e1894 = ((_e1889 >> bitcast<u32>(((_e1807 * 8u) & 31u))) & 255u);
                                                                                let _e1895 = (_e1894 & 31u);
                                                                                if (_e1895 >= 24u) {
                                                                                    phi_2439_ = (24u + ((_e1895 - 24u) ^ _e1393));
                                                                                } else {
                                                                                    phi_2439_ = _e1895;
                                                                                }
                                                                                let _e1901 = phi_2439_;
                                                                                phi_2444_ = (_e1803 | ((_e1894 >> bitcast<u32>(5i)) << bitcast<u32>((_e1901 & 31u))));
                                                                            } else {
                                                                                phi_2444_ = _e1803;
                                                                            }
                                                                            let _e1909 = phi_2444_;
                                                                            phi_2445_ = _e1909;
                                                                        } else {
                                                                            phi_2445_ = _e1803;
                                                                        }
                                                                        let _e1911 = phi_2445_;
                                                                        phi_2446_ = _e1911;
                                                                    } else {
                                                                        phi_2446_ = _e1803;
                                                                    }
                                                                    let _e1913 = phi_2446_;
                                                                    phi_2316_ = (_e1801 + 1u);
                                                                    phi_2319_ = _e1913;
                                                                } else {
                                                                    phi_2316_ = u32();
                                                                    phi_2319_ = u32();
                                                                }
                                                                let _e1916 = phi_2316_;
                                                                let _e1918 = phi_2319_;
                                                                continue;
                                                                continuing {
                                                                    phi_2315_ = _e1916;
                                                                    phi_2318_ = _e1918;
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
                                                            phi_2504_ = _e1531;
                                                            phi_2507_ = (_e1967 & 16777215u);
                                                            loop {
                                                                let _e1970 = phi_2504_;
                                                                let _e1972 = phi_2507_;
                                                                local_9 = _e1970;
                                                                if (_e1972 == 0u) {
                                                                    phi_2505_ = lt_bvh_Hit();
                                                                    phi_2508_ = u32();
                                                                    phi_3346_ = false;
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
                                                                        phi_2552_ = vec3<f32>(_e1992, _e1994, _e1990);
                                                                    } else {
                                                                        if (_e1366 == 1u) {
                                                                            phi_2551_ = vec3<f32>(_e1994, _e1990, _e1992);
                                                                        } else {
                                                                            phi_2551_ = (_e1988 - vec3<f32>(_e1084, _e1097, _e1110));
                                                                        }
                                                                        let _e2002 = phi_2551_;
                                                                        phi_2552_ = _e2002;
                                                                    }
                                                                    let _e2004 = phi_2552_;
                                                                    let _e2008 = (_e2004.x - (_e1377 * _e2004.z));
                                                                    let _e2012 = (_e2004.y - (_e1380 * _e2004.z));
                                                                    let _e2014 = triangles.member[(0u + _e1981)].v1_;
                                                                    let _e2016 = (_e2014.x - _e1084);
                                                                    let _e2018 = (_e2014.y - _e1097);
                                                                    let _e2020 = (_e2014.z - _e1110);
                                                                    if (_e1366 == 0u) {
                                                                        phi_2582_ = vec3<f32>(_e2018, _e2020, _e2016);
                                                                    } else {
                                                                        if (_e1366 == 1u) {
                                                                            phi_2581_ = vec3<f32>(_e2020, _e2016, _e2018);
                                                                        } else {
                                                                            phi_2581_ = (_e2014 - vec3<f32>(_e1084, _e1097, _e1110));
                                                                        }
                                                                        let _e2028 = phi_2581_;
                                                                        phi_2582_ = _e2028;
                                                                    }
                                                                    let _e2030 = phi_2582_;
                                                                    let _e2034 = (_e2030.x - (_e1377 * _e2030.z));
                                                                    let _e2038 = (_e2030.y - (_e1380 * _e2030.z));
                                                                    let _e2040 = triangles.member[(0u + _e1981)].v2_;
                                                                    let _e2042 = (_e2040.x - _e1084);
                                                                    let _e2044 = (_e2040.y - _e1097);
                                                                    let _e2046 = (_e2040.z - _e1110);
                                                                    if (_e1366 == 0u) {
                                                                        phi_2612_ = vec3<f32>(_e2044, _e2046, _e2042);
                                                                    } else {
                                                                        if (_e1366 == 1u) {
                                                                            phi_2611_ = vec3<f32>(_e2046, _e2042, _e2044);
                                                                        } else {
                                                                            phi_2611_ = (_e2040 - vec3<f32>(_e1084, _e1097, _e1110));
                                                                        }
                                                                        let _e2054 = phi_2611_;
                                                                        phi_2612_ = _e2054;
                                                                    }
                                                                    let _e2056 = phi_2612_;
                                                                    let _e2060 = (_e2056.x - (_e1377 * _e2056.z));
                                                                    let _e2064 = (_e2056.y - (_e1380 * _e2056.z));
                                                                    if (_e2034 < _e2060) {
                                                                        phi_2631_ = true;
                                                                    } else {
                                                                        if (_e2034 == _e2060) {
                                                                            phi_2630_ = (_e2038 < _e2064);
                                                                        } else {
                                                                            phi_2630_ = false;
                                                                        }
                                                                        let _e2069 = phi_2630_;
                                                                        phi_2631_ = _e2069;
                                                                    }
                                                                    let _e2071 = phi_2631_;
                                                                    if _e2071 {
                                                                        phi_2635_ = _e2064;
                                                                        phi_2636_ = _e2060;
                                                                        phi_2637_ = _e2038;
                                                                        phi_2638_ = _e2034;
                                                                    } else {
                                                                        phi_2635_ = _e2038;
                                                                        phi_2636_ = _e2034;
                                                                        phi_2637_ = _e2064;
                                                                        phi_2638_ = _e2060;
                                                                    }
                                                                    let _e2073 = phi_2635_;
                                                                    let _e2075 = phi_2636_;
                                                                    let _e2077 = phi_2637_;
                                                                    let _e2079 = phi_2638_;
                                                                    let _e2082 = ((_e2079 * _e2073) - (_e2077 * _e2075));
                                                                    if _e2071 {
                                                                        phi_2646_ = -(_e2082);
                                                                    } else {
                                                                        phi_2646_ = _e2082;
                                                                    }
                                                                    let _e2085 = phi_2646_;
                                                                    if (_e2060 < _e2008) {
                                                                        phi_2657_ = true;
                                                                    } else {
                                                                        if (_e2060 == _e2008) {
                                                                            phi_2656_ = (_e2064 < _e2012);
                                                                        } else {
                                                                            phi_2656_ = false;
                                                                        }
                                                                        let _e2090 = phi_2656_;
                                                                        phi_2657_ = _e2090;
                                                                    }
                                                                    let _e2092 = phi_2657_;
                                                                    if _e2092 {
                                                                        phi_2661_ = _e2012;
                                                                        phi_2662_ = _e2008;
                                                                        phi_2663_ = _e2064;
                                                                        phi_2664_ = _e2060;
                                                                    } else {
                                                                        phi_2661_ = _e2064;
                                                                        phi_2662_ = _e2060;
                                                                        phi_2663_ = _e2012;
                                                                        phi_2664_ = _e2008;
                                                                    }
                                                                    let _e2094 = phi_2661_;
                                                                    let _e2096 = phi_2662_;
                                                                    let _e2098 = phi_2663_;
                                                                    let _e2100 = phi_2664_;
                                                                    let _e2103 = ((_e2100 * _e2094) - (_e2098 * _e2096));
                                                                    if _e2092 {
                                                                        phi_2672_ = -(_e2103);
                                                                    } else {
                                                                        phi_2672_ = _e2103;
                                                                    }
                                                                    let _e2106 = phi_2672_;
                                                                    if (_e2008 < _e2034) {
                                                                        phi_2683_ = true;
                                                                    } else {
                                                                        if (_e2008 == _e2034) {
                                                                            phi_2682_ = (_e2012 < _e2038);
                                                                        } else {
                                                                            phi_2682_ = false;
                                                                        }
                                                                        let _e2111 = phi_2682_;
                                                                        phi_2683_ = _e2111;
                                                                    }
                                                                    let _e2113 = phi_2683_;
                                                                    if _e2113 {
                                                                        phi_2687_ = _e2038;
                                                                        phi_2688_ = _e2034;
                                                                        phi_2689_ = _e2012;
                                                                        phi_2690_ = _e2008;
                                                                    } else {
                                                                        phi_2687_ = _e2012;
                                                                        phi_2688_ = _e2008;
                                                                        phi_2689_ = _e2038;
                                                                        phi_2690_ = _e2034;
                                                                    }
                                                                    let _e2115 = phi_2687_;
                                                                    let _e2117 = phi_2688_;
                                                                    let _e2119 = phi_2689_;
                                                                    let _e2121 = phi_2690_;
                                                                    let _e2124 = ((_e2121 * _e2115) - (_e2119 * _e2117));
                                                                    if _e2113 {
                                                                        phi_2698_ = -(_e2124);
                                                                    } else {
                                                                        phi_2698_ = _e2124;
                                                                    }
                                                                    let _e2127 = phi_2698_;
                                                                    if (_e2085 >= 0f) {
                                                                        if (_e2106 >= 0f) {
                                                                            if (_e2127 >= 0f) {
                                                                                phi_2713_ = ((_e2085 + _e2106) + _e2127);
                                                                                phi_2714_ = false;
                                                                            } else {
                                                                                phi_2713_ = f32();
                                                                                phi_2714_ = true;
                                                                            }
                                                                            let _e2134 = phi_2713_;
                                                                            let _e2136 = phi_2714_;
                                                                            phi_2715_ = _e2134;
                                                                            phi_2716_ = _e2136;
                                                                        } else {
                                                                            phi_2715_ = f32();
                                                                            phi_2716_ = true;
                                                                        }
                                                                        let _e2138 = phi_2715_;
                                                                        let _e2140 = phi_2716_;
                                                                        phi_2717_ = _e2138;
                                                                        phi_2718_ = _e2140;
                                                                    } else {
                                                                        phi_2717_ = f32();
                                                                        phi_2718_ = true;
                                                                    }
                                                                    let _e2142 = phi_2717_;
                                                                    let _e2144 = phi_2718_;
                                                                    if _e2144 {
                                                                        if (_e2085 <= 0f) {
                                                                            if (_e2106 <= 0f) {
                                                                                let _e2147 = (_e2127 <= 0f);
                                                                                if _e2147 {
                                                                                }
                                                                                phi_2736_ = ((_e2085 + _e2106) + _e2127);
                                                                                phi_2737_ = false;
                                                                                phi_2738_ = _e2147;
                                                                            } else {
                                                                                phi_2736_ = f32();
                                                                                phi_2737_ = true;
                                                                                phi_2738_ = false;
                                                                            }
                                                                            let _e2151 = phi_2736_;
                                                                            let _e2153 = phi_2737_;
                                                                            let _e2155 = phi_2738_;
                                                                            phi_2739_ = _e2151;
                                                                            phi_2740_ = _e2153;
                                                                            phi_2741_ = _e2155;
                                                                        } else {
                                                                            phi_2739_ = f32();
                                                                            phi_2740_ = true;
                                                                            phi_2741_ = false;
                                                                        }
                                                                        let _e2157 = phi_2739_;
                                                                        let _e2159 = phi_2740_;
                                                                        let _e2161 = phi_2741_;
                                                                        if _e2159 {
                                                                            phi_2745_ = false;
                                                                        } else {
                                                                            phi_2745_ = _e2161;
                                                                        }
                                                                        let _e2163 = phi_2745_;
                                                                        phi_2746_ = _e2157;
                                                                        phi_2747_ = _e2163;
                                                                    } else {
                                                                        phi_2746_ = _e2142;
                                                                        phi_2747_ = true;
                                                                    }
                                                                    let _e2165 = phi_2746_;
                                                                    let _e2167 = phi_2747_;
                                                                    if _e2167 {
                                                                        let _e2168 = (_e2165 == 0f);
                                                                        if _e2168 {
                                                                            phi_3063_ = lt_bvh_triangle_Intersection();
                                                                            phi_3064_ = false;
                                                                        } else {
                                                                            let _e2170 = triangles.member[(0u + _e1981)].v0_;
                                                                            let _e2172 = (_e2170.x - _e1084);
                                                                            let _e2174 = (_e2170.y - _e1097);
                                                                            let _e2176 = (_e2170.z - _e1110);
                                                                            if (_e1366 == 0u) {
                                                                                phi_2776_ = vec3<f32>(_e2174, _e2176, _e2172);
                                                                            } else {
                                                                                if (_e1366 == 1u) {
                                                                                    phi_2775_ = vec3<f32>(_e2176, _e2172, _e2174);
                                                                                } else {
                                                                                    phi_2775_ = (_e2170 - vec3<f32>(_e1084, _e1097, _e1110));
                                                                                }
                                                                                let _e2184 = phi_2775_;
                                                                                phi_2776_ = _e2184;
                                                                            }
                                                                            let _e2186 = phi_2776_;
                                                                            let _e2188 = triangles.member[(0u + _e1981)].v1_;
                                                                            let _e2190 = triangles.member[(0u + _e1981)].v0_;
                                                                            let _e2193 = (_e2188.x - _e2190.x);
                                                                            let _e2196 = (_e2188.y - _e2190.y);
                                                                            let _e2199 = (_e2188.z - _e2190.z);
                                                                            if (_e1366 == 0u) {
                                                                                phi_2802_ = vec3<f32>(_e2196, _e2199, _e2193);
                                                                            } else {
                                                                                if (_e1366 == 1u) {
                                                                                    phi_2801_ = vec3<f32>(_e2199, _e2193, _e2196);
                                                                                } else {
                                                                                    phi_2801_ = (_e2188 - _e2190);
                                                                                }
                                                                                let _e2206 = phi_2801_;
                                                                                phi_2802_ = _e2206;
                                                                            }
                                                                            let _e2208 = phi_2802_;
                                                                            let _e2210 = triangles.member[(0u + _e1981)].v2_;
                                                                            let _e2212 = triangles.member[(0u + _e1981)].v0_;
                                                                            let _e2215 = (_e2210.x - _e2212.x);
                                                                            let _e2218 = (_e2210.y - _e2212.y);
                                                                            let _e2221 = (_e2210.z - _e2212.z);
                                                                            if (_e1366 == 0u) {
                                                                                phi_2828_ = vec3<f32>(_e2218, _e2221, _e2215);
                                                                            } else {
                                                                                if (_e1366 == 1u) {
                                                                                    phi_2827_ = vec3<f32>(_e2221, _e2215, _e2218);
                                                                                } else {
                                                                                    phi_2827_ = (_e2210 - _e2212);
                                                                                }
                                                                                let _e2228 = phi_2827_;
                                                                                phi_2828_ = _e2228;
                                                                            }
                                                                            let _e2230 = phi_2828_;
                                                                            let _e2237 = ((_e2208.y * _e2230.z) - (_e2208.z * _e2230.y));
                                                                            let _e2244 = ((_e2208.z * _e2230.x) - (_e2208.x * _e2230.z));
                                                                            let _e2251 = ((_e2208.x * _e2230.y) - (_e2208.y * _e2230.x));
                                                                            let _e2265 = (((1f / _e1374.z) * (((_e2237 * _e2186.x) + (_e2244 * _e2186.y)) + (_e2251 * _e2186.z))) / (((_e2237 * _e1377) + (_e2244 * _e1380)) + _e2251));
                                                                            if (_e2265 > _e183.tmin) {
                                                                                if (_e2265 < _e183.tmax) {
                                                                                    let _e2269 = triangles.member[(0u + _e1981)].v0_;
                                                                                    let _e2271 = triangles.member[(0u + _e1981)].v1_;
                                                                                    if (_e2269.x < _e2271.x) {
                                                                                        phi_2884_ = _e2269.x;
                                                                                    } else {
                                                                                        phi_2884_ = _e2271.x;
                                                                                    }
                                                                                    let _e2278 = phi_2884_;
                                                                                    if (_e2269.y < _e2271.y) {
                                                                                        phi_2893_ = _e2269.y;
                                                                                    } else {
                                                                                        phi_2893_ = _e2271.y;
                                                                                    }
                                                                                    let _e2285 = phi_2893_;
                                                                                    if (_e2269.z < _e2271.z) {
                                                                                        phi_2902_ = _e2269.z;
                                                                                    } else {
                                                                                        phi_2902_ = _e2271.z;
                                                                                    }
                                                                                    let _e2292 = phi_2902_;
                                                                                    let _e2294 = triangles.member[(0u + _e1981)].v2_;
                                                                                    if (_e2278 < _e2294.x) {
                                                                                        phi_2911_ = _e2278;
                                                                                    } else {
                                                                                        phi_2911_ = _e2294.x;
                                                                                    }
                                                                                    let _e2299 = phi_2911_;
                                                                                    if (_e2285 < _e2294.y) {
                                                                                        phi_2918_ = _e2285;
                                                                                    } else {
                                                                                        phi_2918_ = _e2294.y;
                                                                                    }
                                                                                    let _e2304 = phi_2918_;
                                                                                    if (_e2292 < _e2294.z) {
                                                                                        phi_2925_ = _e2292;
                                                                                    } else {
                                                                                        phi_2925_ = _e2294.z;
                                                                                    }
                                                                                    let _e2309 = phi_2925_;
                                                                                    let _e2311 = triangles.member[(0u + _e1981)].v0_;
                                                                                    let _e2313 = triangles.member[(0u + _e1981)].v1_;
                                                                                    if (_e2311.x > _e2313.x) {
                                                                                        phi_2938_ = _e2311.x;
                                                                                    } else {
                                                                                        phi_2938_ = _e2313.x;
                                                                                    }
                                                                                    let _e2320 = phi_2938_;
                                                                                    if (_e2311.y > _e2313.y) {
                                                                                        phi_2947_ = _e2311.y;
                                                                                    } else {
                                                                                        phi_2947_ = _e2313.y;
                                                                                    }
                                                                                    let _e2327 = phi_2947_;
                                                                                    if (_e2311.z > _e2313.z) {
                                                                                        phi_2956_ = _e2311.z;
                                                                                    } else {
                                                                                        phi_2956_ = _e2313.z;
                                                                                    }
                                                                                    let _e2334 = phi_2956_;
                                                                                    let _e2336 = triangles.member[(0u + _e1981)].v2_;
                                                                                    if (_e2320 > _e2336.x) {
                                                                                        phi_2965_ = _e2320;
                                                                                    } else {
                                                                                        phi_2965_ = _e2336.x;
                                                                                    }
                                                                                    let _e2341 = phi_2965_;
                                                                                    if (_e2327 > _e2336.y) {
                                                                                        phi_2972_ = _e2327;
                                                                                    } else {
                                                                                        phi_2972_ = _e2336.y;
                                                                                    }
                                                                                    let _e2346 = phi_2972_;
                                                                                    if (_e2334 > _e2336.z) {
                                                                                        phi_2979_ = _e2334;
                                                                                    } else {
                                                                                        phi_2979_ = _e2336.z;
                                                                                    }
                                                                                    let _e2351 = phi_2979_;
                                                                                    let _e2355 = ((_e2299 - _e1084) * _e1291);
                                                                                    let _e2356 = ((_e2304 - _e1097) * _e1301);
                                                                                    let _e2357 = ((_e2309 - _e1110) * _e1311);
                                                                                    let _e2361 = ((_e2341 - _e1084) * _e1291);
                                                                                    let _e2362 = ((_e2346 - _e1097) * _e1301);
                                                                                    let _e2363 = ((_e2351 - _e1110) * _e1311);
                                                                                    if (_e2355 < _e2361) {
                                                                                        phi_2996_ = _e2355;
                                                                                    } else {
                                                                                        phi_2996_ = _e2361;
                                                                                    }
                                                                                    let _e2366 = phi_2996_;
                                                                                    if (_e2356 < _e2362) {
                                                                                        phi_3001_ = _e2356;
                                                                                    } else {
                                                                                        phi_3001_ = _e2362;
                                                                                    }
                                                                                    let _e2369 = phi_3001_;
                                                                                    if (_e2357 < _e2363) {
                                                                                        phi_3006_ = _e2357;
                                                                                    } else {
                                                                                        phi_3006_ = _e2363;
                                                                                    }
                                                                                    let _e2372 = phi_3006_;
                                                                                    if (_e2355 > _e2361) {
                                                                                        phi_3014_ = _e2355;
                                                                                    } else {
                                                                                        phi_3014_ = _e2361;
                                                                                    }
                                                                                    let _e2378 = phi_3014_;
                                                                                    if (_e2356 > _e2362) {
                                                                                        phi_3019_ = _e2356;
                                                                                    } else {
                                                                                        phi_3019_ = _e2362;
                                                                                    }
                                                                                    let _e2381 = phi_3019_;
                                                                                    if (_e2357 > _e2363) {
                                                                                        phi_3024_ = _e2357;
                                                                                    } else {
                                                                                        phi_3024_ = _e2363;
                                                                                    }
                                                                                    let _e2384 = phi_3024_;
                                                                                    let _e2388 = core_intrinsics_maximum_number_nsz_f32_((_e2366 - _e1350), (_e2369 - _e1351));
                                                                                    let _e2389 = core_intrinsics_maximum_number_nsz_f32_(_e2388, (_e2372 - _e1352));
                                                                                    let _e2390 = core_intrinsics_minimum_number_nsz_f32_((_e2378 + _e1350), (_e2381 + _e1351));
                                                                                    let _e2391 = core_intrinsics_minimum_number_nsz_f32_(_e2390, (_e2384 + _e1352));
                                                                                    if (_e2389 > _e1059) {
                                                                                        phi_3036_ = _e2389;
                                                                                    } else {
                                                                                        phi_3036_ = _e1059;
                                                                                    }
                                                                                    let _e2394 = phi_3036_;
                                                                                    if (_e2391 < _e1061) {
                                                                                        phi_3041_ = _e2391;
                                                                                    } else {
                                                                                        phi_3041_ = _e1061;
                                                                                    }
                                                                                    let _e2397 = phi_3041_;
                                                                                    if (_e2265 < _e2394) {
                                                                                        phi_3046_ = _e2394;
                                                                                    } else {
                                                                                        phi_3046_ = _e2265;
                                                                                    }
                                                                                    let _e2400 = phi_3046_;
                                                                                    if (_e2400 > _e2397) {
                                                                                        phi_3051_ = _e2397;
                                                                                    } else {
                                                                                        phi_3051_ = _e2400;
                                                                                    }
                                                                                    let _e2403 = phi_3051_;
                                                                                    phi_3056_ = lt_bvh_triangle_Intersection(_e2403, (_e2106 / _e2165), (_e2127 / _e2165), (_e2394 <= _e2397));
                                                                                    phi_3057_ = false;
                                                                                } else {
                                                                                    phi_3056_ = lt_bvh_triangle_Intersection();
                                                                                    phi_3057_ = true;
                                                                                }
                                                                                let _e2409 = phi_3056_;
                                                                                let _e2411 = phi_3057_;
                                                                                phi_3058_ = _e2409;
                                                                                phi_3059_ = _e2411;
                                                                            } else {
                                                                                phi_3058_ = lt_bvh_triangle_Intersection();
                                                                                phi_3059_ = true;
                                                                            }
                                                                            let _e2413 = phi_3058_;
                                                                            let _e2415 = phi_3059_;
                                                                            if _e2415 {
                                                                            }
                                                                            phi_3063_ = _e2413;
                                                                            phi_3064_ = _e2415;
                                                                        }
                                                                        let _e2417 = phi_3063_;
                                                                        let _e2419 = phi_3064_;
                                                                        phi_3065_ = _e2417;
                                                                        phi_3066_ = _e2168;
                                                                        phi_3067_ = _e2419;
                                                                    } else {
                                                                        phi_3065_ = lt_bvh_triangle_Intersection();
                                                                        phi_3066_ = true;
                                                                        phi_3067_ = false;
                                                                    }
                                                                    let _e2421 = phi_3065_;
                                                                    let _e2423 = phi_3066_;
                                                                    let _e2425 = phi_3067_;
                                                                    if _e2423 {
                                                                        phi_3071_ = true;
                                                                    } else {
                                                                        phi_3071_ = _e2425;
                                                                    }
                                                                    let _e2427 = phi_3071_;
                                                                    if _e2427 {
                                                                        phi_3075_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_3075_ = _e2421;
                                                                    }
                                                                    let _e2429 = phi_3075_;
                                                                    if _e2429.is_hit {
                                                                        if (_e2429.t > _e183.tmin) {
                                                                            if (_e2429.t < _e1970.t) {
                                                                                phi_3123_ = true;
                                                                            } else {
                                                                                if (_e2429.t == _e1970.t) {
                                                                                    if (_e1970.triangle != 4294967295u) {
                                                                                        if (_e1981 < _e1970.triangle) {
                                                                                            phi_3114_ = true;
                                                                                        } else {
                                                                                            if (_e1981 == _e1970.triangle) {
                                                                                                phi_3113_ = (_e1000 < _e1970.instance);
                                                                                            } else {
                                                                                                phi_3113_ = false;
                                                                                            }
                                                                                            let _e2447 = phi_3113_;
                                                                                            phi_3114_ = _e2447;
                                                                                        }
                                                                                        let _e2449 = phi_3114_;
                                                                                        phi_3115_ = _e2449;
                                                                                        phi_3116_ = false;
                                                                                    } else {
                                                                                        phi_3115_ = bool();
                                                                                        phi_3116_ = true;
                                                                                    }
                                                                                    let _e2451 = phi_3115_;
                                                                                    let _e2453 = phi_3116_;
                                                                                    phi_3117_ = _e2451;
                                                                                    phi_3118_ = _e2453;
                                                                                } else {
                                                                                    phi_3117_ = bool();
                                                                                    phi_3118_ = true;
                                                                                }
                                                                                let _e2455 = phi_3117_;
                                                                                let _e2457 = phi_3118_;
                                                                                if _e2457 {
                                                                                    phi_3122_ = false;
                                                                                } else {
                                                                                    phi_3122_ = _e2455;
                                                                                }
                                                                                let _e2459 = phi_3122_;
                                                                                phi_3123_ = _e2459;
                                                                            }
                                                                            let _e2461 = phi_3123_;
                                                                            if _e2461 {
                                                                                let _e2463 = triangles.member[(0u + _e1981)].i0_;
                                                                                if ((_e2463 & 2147483648u) == 0u) {
                                                                                    phi_3334_ = true;
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
                                                                                            phi_3329_ = true;
                                                                                        } else {
                                                                                            let _e2528 = (_e2496.base_color.w * ((((f32((_e2490[0].color >> bitcast<u32>(24i))) * _e2501) + (f32((_e2490[1].color >> bitcast<u32>(24i))) * _e2429.u)) + (f32((_e2490[2].color >> bitcast<u32>(24i))) * _e2429.v)) * (1f / 255f)));
                                                                                            if (_e2496.alpha_size == 0u) {
                                                                                                phi_3326_ = _e2528;
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
                                                                                                phi_3326_ = (_e2528 * (((((f32(((_e2567 >> bitcast<u32>((((_e2559.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2559.weights.x) + ((f32(((_e2587 >> bitcast<u32>((((_e2559.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2559.weights.y)) + ((f32(((_e2608 >> bitcast<u32>((((_e2559.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2559.weights.z)) + ((f32(((_e2629 >> bitcast<u32>((((_e2559.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2559.weights.w)));
                                                                                            }
                                                                                            let _e2645 = phi_3326_;
                                                                                            phi_3329_ = (_e2645 >= _e2496.cutoff);
                                                                                        }
                                                                                        let _e2649 = phi_3329_;
                                                                                        phi_3330_ = _e2649;
                                                                                    } else {
                                                                                        phi_3330_ = false;
                                                                                    }
                                                                                    let _e2651 = phi_3330_;
                                                                                    if _e2651 {
                                                                                    }
                                                                                    phi_3334_ = _e2651;
                                                                                }
                                                                                let _e2653 = phi_3334_;
                                                                                if _e2653 {
                                                                                    phi_3342_ = lt_bvh_Hit(_e2429.t, _e2429.u, _e2429.v, _e1981, _e1000);
                                                                                } else {
                                                                                    phi_3342_ = _e1970;
                                                                                }
                                                                                let _e2659 = phi_3342_;
                                                                                phi_3343_ = _e2659;
                                                                            } else {
                                                                                phi_3343_ = _e1970;
                                                                            }
                                                                            let _e2661 = phi_3343_;
                                                                            phi_3344_ = _e2661;
                                                                        } else {
                                                                            phi_3344_ = _e1970;
                                                                        }
                                                                        let _e2663 = phi_3344_;
                                                                        phi_3345_ = _e2663;
                                                                    } else {
                                                                        phi_3345_ = _e1970;
                                                                    }
                                                                    let _e2665 = phi_3345_;
                                                                    phi_2505_ = _e2665;
                                                                    phi_2508_ = (_e1972 & (_e1972 - 1u));
                                                                    phi_3346_ = true;
                                                                }
                                                                let _e2667 = phi_2505_;
                                                                let _e2669 = phi_2508_;
                                                                let _e2671 = phi_3346_;
                                                                continue;
                                                                continuing {
                                                                    phi_2504_ = _e2667;
                                                                    phi_2507_ = _e2669;
                                                                    break if !(_e2671);
                                                                }
                                                            }
                                                            let _e2674 = local_1.group_mask;
                                                            if ((_e2674 & 4278190080u) == 0u) {
                                                                let _e2678 = local_1.len;
                                                                if (_e2678 == 0u) {
                                                                    phi_3385_ = false;
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
                                                                    phi_3385_ = true;
                                                                }
                                                                let _e2701 = phi_3385_;
                                                                phi_3386_ = _e2701;
                                                            } else {
                                                                phi_3386_ = true;
                                                            }
                                                            let _e2703 = phi_3386_;
                                                            if _e2703 {
                                                                let _e2705 = local_1.group_mask;
                                                                let _e2711 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2705)), 32u, (_e2705 == 0u)));
                                                                let _e2715 = local_1.group_mask;
                                                                let _e2729 = local_1.group_mask;
                                                                local_1.group_mask = (_e2729 & ~((1u << bitcast<u32>((_e2711 & 31u)))));
                                                                let _e2732 = local_1.group;
                                                                phi_3417_ = (_e2732 + countOneBits(((_e2715 & ~((4294967295u << bitcast<u32>((((_e2711 - 24u) ^ _e1393) & 31u))))) & 255u)));
                                                            } else {
                                                                phi_3417_ = 4294967295u;
                                                            }
                                                            let _e2735 = phi_3417_;
                                                            let _e3913 = local_9;
                                                            phi_2172_ = _e3913;
                                                            phi_2175_ = _e2735;
                                                        } else {
                                                            phi_2172_ = lt_bvh_Hit();
                                                            phi_2175_ = u32();
                                                        }
                                                        let _e2737 = phi_2172_;
                                                        let _e2739 = phi_2175_;
                                                        continue;
                                                        continuing {
                                                            phi_2171_ = _e2737;
                                                            phi_2174_ = _e2739;
                                                            break if !(_e1534);
                                                        }
                                                    }
                                                    let _e3917 = local_10;
                                                    phi_3418_ = _e3917;
                                                }
                                                let _e2742 = phi_3418_;
                                                phi_3419_ = _e2742;
                                                phi_3420_ = _e1215;
                                            } else {
                                                phi_3419_ = lt_bvh_Hit();
                                                phi_3420_ = true;
                                            }
                                            let _e2744 = phi_3419_;
                                            let _e2746 = phi_3420_;
                                            if _e2746 {
                                                phi_3424_ = _e992;
                                            } else {
                                                phi_3424_ = _e2744;
                                            }
                                            let _e2748 = phi_3424_;
                                            phi_3425_ = _e2748;
                                        } else {
                                            phi_3425_ = _e992;
                                        }
                                        let _e2750 = phi_3425_;
                                        phi_3426_ = _e2750;
                                    } else {
                                        phi_3426_ = _e992;
                                    }
                                    let _e2752 = phi_3426_;
                                    phi_3427_ = _e2752;
                                } else {
                                    phi_3427_ = _e992;
                                }
                                let _e2754 = phi_3427_;
                                phi_1539_ = (_e990 & (_e990 - 1u));
                                phi_1542_ = _e2754;
                                phi_3428_ = true;
                            }
                            let _e2756 = phi_1539_;
                            let _e2758 = phi_1542_;
                            let _e2760 = phi_3428_;
                            continue;
                            continuing {
                                phi_1538_ = _e2756;
                                phi_1541_ = _e2758;
                                break if !(_e2760);
                            }
                        }
                        let _e2763 = local_2.group_mask;
                        if ((_e2763 & 4278190080u) == 0u) {
                            let _e2767 = local_2.len;
                            if (_e2767 == 0u) {
                                phi_3467_ = false;
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
                                phi_3467_ = true;
                            }
                            let _e2790 = phi_3467_;
                            phi_3468_ = _e2790;
                        } else {
                            phi_3468_ = true;
                        }
                        let _e2792 = phi_3468_;
                        if _e2792 {
                            let _e2794 = local_2.group_mask;
                            let _e2800 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2794)), 32u, (_e2794 == 0u)));
                            let _e2804 = local_2.group_mask;
                            let _e2818 = local_2.group_mask;
                            local_2.group_mask = (_e2818 & ~((1u << bitcast<u32>((_e2800 & 31u)))));
                            let _e2821 = local_2.group;
                            phi_3499_ = (_e2821 + countOneBits(((_e2804 & ~((4294967295u << bitcast<u32>((((_e2800 - 24u) ^ _e409) & 31u))))) & 255u)));
                        } else {
                            phi_3499_ = 4294967295u;
                        }
                        let _e2824 = phi_3499_;
                        phi_1202_ = _e2824;
                        let _e3933 = local_11;
                        phi_1205_ = _e3933;
                    } else {
                        phi_1202_ = u32();
                        phi_1205_ = lt_bvh_Hit();
                    }
                    let _e2826 = phi_1202_;
                    let _e2828 = phi_1205_;
                    continue;
                    continuing {
                        phi_1201_ = _e2826;
                        phi_1204_ = _e2828;
                        break if !(_e550);
                    }
                }
                let _e3936 = local_12;
                phi_3500_ = _e3936;
            }
            let _e2831 = phi_3500_;
            phi_3501_ = _e2831;
            phi_3502_ = _e247;
        } else {
            phi_3501_ = lt_bvh_Hit();
            phi_3502_ = true;
        }
        let _e2833 = phi_3501_;
        let _e2835 = phi_3502_;
        if _e2835 {
            phi_3506_ = _e185;
        } else {
            phi_3506_ = _e2833;
        }
        let _e2837 = phi_3506_;
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
                phi_3694_ = _e3002;
            } else {
                phi_3694_ = _e3005;
            }
            let _e3010 = phi_3694_;
            if (_e3003 > _e3006) {
                phi_3699_ = _e3003;
            } else {
                phi_3699_ = _e3006;
            }
            let _e3013 = phi_3699_;
            if (_e3004 > _e3007) {
                phi_3704_ = _e3004;
            } else {
                phi_3704_ = _e3007;
            }
            let _e3016 = phi_3704_;
            let _e3017 = abs(_e2959);
            let _e3018 = abs(_e2972);
            let _e3019 = abs(_e2985);
            if (_e3010 > _e3017) {
                phi_3712_ = _e3010;
            } else {
                phi_3712_ = _e3017;
            }
            let _e3022 = phi_3712_;
            if (_e3013 > _e3018) {
                phi_3717_ = _e3013;
            } else {
                phi_3717_ = _e3018;
            }
            let _e3025 = phi_3717_;
            if (_e3016 > _e3019) {
                phi_3722_ = _e3016;
            } else {
                phi_3722_ = _e3019;
            }
            let _e3028 = phi_3722_;
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
                phi_3786_ = vec3<f32>(-(_e3075), -(_e3076), -(_e3077));
            } else {
                phi_3786_ = vec3<f32>(_e3075, _e3076, _e3077);
            }
            let _e3090 = phi_3786_;
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
                phi_3907_ = 0u;
            } else {
                phi_3907_ = 1u;
            }
            let _e3202 = phi_3907_;
            if (_e3112[0].normal == 2147516416u) {
                phi_4137_ = _e3090;
            } else {
                let _e3215 = (f32((bitcast<i32>((_e3112[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3221 = (f32((bitcast<i32>(_e3112[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3225 = ((1f - abs(_e3215)) - abs(_e3221));
                if (_e3225 < 0f) {
                    phi_3934_ = -(_e3225);
                } else {
                    phi_3934_ = 0f;
                }
                let _e3229 = phi_3934_;
                if (_e3215 < 0f) {
                    phi_3941_ = (_e3215 + _e3229);
                } else {
                    phi_3941_ = (_e3215 - _e3229);
                }
                let _e3234 = phi_3941_;
                if (_e3221 < 0f) {
                    phi_3948_ = (_e3221 + _e3229);
                } else {
                    phi_3948_ = (_e3221 - _e3229);
                }
                let _e3239 = phi_3948_;
                let _e3246 = (1f / sqrt((((_e3234 * _e3234) + (_e3239 * _e3239)) + (_e3225 * _e3225))));
                let _e3262 = (f32((bitcast<i32>((_e3112[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3268 = (f32((bitcast<i32>(_e3112[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3272 = ((1f - abs(_e3262)) - abs(_e3268));
                if (_e3272 < 0f) {
                    phi_3983_ = -(_e3272);
                } else {
                    phi_3983_ = 0f;
                }
                let _e3276 = phi_3983_;
                if (_e3262 < 0f) {
                    phi_3990_ = (_e3262 + _e3276);
                } else {
                    phi_3990_ = (_e3262 - _e3276);
                }
                let _e3281 = phi_3990_;
                if (_e3268 < 0f) {
                    phi_3997_ = (_e3268 + _e3276);
                } else {
                    phi_3997_ = (_e3268 - _e3276);
                }
                let _e3286 = phi_3997_;
                let _e3293 = (1f / sqrt((((_e3281 * _e3281) + (_e3286 * _e3286)) + (_e3272 * _e3272))));
                let _e3312 = (f32((bitcast<i32>((_e3112[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3318 = (f32((bitcast<i32>(_e3112[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3322 = ((1f - abs(_e3312)) - abs(_e3318));
                if (_e3322 < 0f) {
                    phi_4035_ = -(_e3322);
                } else {
                    phi_4035_ = 0f;
                }
                let _e3326 = phi_4035_;
                if (_e3312 < 0f) {
                    phi_4042_ = (_e3312 + _e3326);
                } else {
                    phi_4042_ = (_e3312 - _e3326);
                }
                let _e3331 = phi_4042_;
                if (_e3318 < 0f) {
                    phi_4049_ = (_e3318 + _e3326);
                } else {
                    phi_4049_ = (_e3318 - _e3326);
                }
                let _e3336 = phi_4049_;
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
                        phi_4135_ = vec3<f32>(-(_e3397), -(_e3398), -(_e3399));
                    } else {
                        phi_4135_ = vec3<f32>(_e3397, _e3398, _e3399);
                    }
                    let _e3415 = phi_4135_;
                    phi_4136_ = _e3415;
                } else {
                    phi_4136_ = _e3090;
                }
                let _e3417 = phi_4136_;
                phi_4137_ = _e3417;
            }
            let _e3419 = phi_4137_;
            if (_e3191 > 0f) {
                if (_e3191 < 1f) {
                    phi_4146_ = _e3191;
                } else {
                    phi_4146_ = 1f;
                }
                let _e3423 = phi_4146_;
                phi_4147_ = _e3423;
            } else {
                phi_4147_ = 0f;
            }
            let _e3425 = phi_4147_;
            if (_e3193 > 0f) {
                if (_e3193 < 1f) {
                    phi_4157_ = _e3193;
                } else {
                    phi_4157_ = 1f;
                }
                let _e3430 = phi_4157_;
                phi_4158_ = _e3430;
            } else {
                phi_4158_ = 0f;
            }
            let _e3432 = phi_4158_;
            if (_e3195 > 0f) {
                if (_e3195 < 1f) {
                    phi_4168_ = _e3195;
                } else {
                    phi_4168_ = 1f;
                }
                let _e3437 = phi_4168_;
                phi_4169_ = _e3437;
            } else {
                phi_4169_ = 0f;
            }
            let _e3439 = phi_4169_;
            let _e3442 = ((sqrt(_e3425) * 255f) + 0.5f);
            let _e3451 = ((sqrt(_e3432) * 255f) + 0.5f);
            let _e3463 = ((sqrt(_e3439) * 255f) + 0.5f);
            phi_4204_ = abi_Sample(vec3<f32>(_e2998, _e2999, _e3000), _e3197, _e3090, _e3202, _e3419, ((select(select(u32(_e3442), 0u, (_e3442 < bitcast<f32>(0u))), 4294967295u, (_e3442 > bitcast<f32>(1333788671u))) | (select(select(u32(_e3451), 0u, (_e3451 < bitcast<f32>(0u))), 4294967295u, (_e3451 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e3463), 0u, (_e3463 < bitcast<f32>(0u))), 4294967295u, (_e3463 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_4204_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e3477 = phi_4204_;
        if (_e109.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e109.shift)] = _e3477;
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
            phi_4427_ = vec3<f32>((((((((_e3517.x * _e3499.x) + (_e3517.y * _e3499.y)) + (_e3517.z * _e3499.z)) + (_e3517.w * 1f)) * _e3486) + (((((_e3567.x * _e3503.x) + (_e3567.y * _e3503.y)) + (_e3567.z * _e3503.z)) + (_e3567.w * 1f)) * _e2837.u)) + (((((_e3620.x * _e3507.x) + (_e3620.y * _e3507.y)) + (_e3620.z * _e3507.z)) + (_e3620.w * 1f)) * _e2837.v)), (((((((_e3530.x * _e3499.x) + (_e3530.y * _e3499.y)) + (_e3530.z * _e3499.z)) + (_e3530.w * 1f)) * _e3486) + (((((_e3580.x * _e3503.x) + (_e3580.y * _e3503.y)) + (_e3580.z * _e3503.z)) + (_e3580.w * 1f)) * _e2837.u)) + (((((_e3633.x * _e3507.x) + (_e3633.y * _e3507.y)) + (_e3633.z * _e3507.z)) + (_e3633.w * 1f)) * _e2837.v)), (((((((_e3543.x * _e3499.x) + (_e3543.y * _e3499.y)) + (_e3543.z * _e3499.z)) + (_e3543.w * 1f)) * _e3486) + (((((_e3593.x * _e3503.x) + (_e3593.y * _e3503.y)) + (_e3593.z * _e3503.z)) + (_e3593.w * 1f)) * _e2837.u)) + (((((_e3646.x * _e3507.x) + (_e3646.y * _e3507.y)) + (_e3646.z * _e3507.z)) + (_e3646.w * 1f)) * _e2837.v)));
        } else {
            phi_4427_ = vec3<f32>(0f, 0f, 0f);
        }
        let _e3666 = phi_4427_;
        if (_e109.shift < arrayLength((&past.member))) {
        } else {
            return;
        }
        past.member[(0u + _e109.shift)] = vec4<f32>(_e3666.x, _e3666.y, _e3666.z, 1f);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_instanced_alpha_motion_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
