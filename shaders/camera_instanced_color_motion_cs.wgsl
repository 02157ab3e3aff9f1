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
var<storage> color_texels: type_9;
@group(0) @binding(8) 
var<storage> before: type_28;
@group(0) @binding(9) 
var<storage, read_write> past: type_28;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_226_: lt_bvh_traverse_Tree;
    var phi_227_: bool;
    var phi_228_: lt_bvh_traverse_Tree;
    var phi_229_: bool;
    var phi_234_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_226_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_227_ = false;
        } else {
            phi_226_ = lt_bvh_traverse_Tree();
            phi_227_ = true;
        }
        let _e85 = phi_226_;
        let _e87 = phi_227_;
        phi_228_ = _e85;
        phi_229_ = _e87;
    } else {
        phi_228_ = lt_bvh_traverse_Tree();
        phi_229_ = true;
    }
    let _e89 = phi_228_;
    let _e91 = phi_229_;
    if _e91 {
        phi_234_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_234_ = _e89;
    }
    let _e96 = phi_234_;
    return lt_bvh_traverse_Tree(_e96.root, _e96.first_primitive);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_249_: bool;
    var phi_253_: f32;

    if (param_3 != param_3) {
        phi_249_ = true;
    } else {
        let _e75 = (param_4 >= param_3);
        if _e75 {
        }
        phi_249_ = _e75;
    }
    let _e77 = phi_249_;
    if _e77 {
        phi_253_ = param_4;
    } else {
        phi_253_ = param_3;
    }
    let _e79 = phi_253_;
    return _e79;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_265_: bool;
    var phi_269_: f32;

    if (param_5 != param_5) {
        phi_265_ = true;
    } else {
        let _e75 = (param_6 <= param_5);
        if _e75 {
        }
        phi_265_ = _e75;
    }
    let _e77 = phi_265_;
    if _e77 {
        phi_269_ = param_6;
    } else {
        phi_269_ = param_5;
    }
    let _e79 = phi_269_;
    return _e79;
}

fn _lt_shaders_texture_TextureView_quad(param_7: ptr<function, texture_TextureView>, param_8: f32, param_9: f32) -> texture_TexelQuad {
    var phi_311_: f32;
    var phi_316_: f32;
    var phi_317_: bool;
    var phi_318_: f32;
    var phi_319_: bool;
    var phi_323_: f32;
    var phi_349_: f32;
    var phi_354_: f32;
    var phi_355_: bool;
    var phi_356_: f32;
    var phi_357_: bool;
    var phi_361_: f32;
    var phi_369_: f32;
    var phi_370_: f32;
    var phi_371_: f32;
    var phi_380_: f32;
    var phi_381_: f32;
    var phi_399_: u32;
    var phi_413_: u32;
    var phi_420_: u32;
    var phi_425_: u32;
    var phi_431_: u32;
    var phi_436_: u32;
    var phi_438_: texture_Axis;
    var phi_466_: f32;
    var phi_471_: f32;
    var phi_472_: bool;
    var phi_473_: f32;
    var phi_474_: bool;
    var phi_478_: f32;
    var phi_504_: f32;
    var phi_509_: f32;
    var phi_510_: bool;
    var phi_511_: f32;
    var phi_512_: bool;
    var phi_516_: f32;
    var phi_524_: f32;
    var phi_525_: f32;
    var phi_526_: f32;
    var phi_535_: f32;
    var phi_536_: f32;
    var phi_554_: u32;
    var phi_568_: u32;
    var phi_575_: u32;
    var phi_580_: u32;
    var phi_586_: u32;
    var phi_591_: u32;
    var phi_593_: texture_Axis;

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
                phi_311_ = 1f;
            } else {
                phi_311_ = 0f;
            }
            let _e106 = phi_311_;
            if (param_8 < 8388608f) {
                phi_316_ = (_e103 - _e106);
                phi_317_ = false;
            } else {
                phi_316_ = f32();
                phi_317_ = true;
            }
            let _e109 = phi_316_;
            let _e111 = phi_317_;
            phi_318_ = _e109;
            phi_319_ = _e111;
        } else {
            phi_318_ = f32();
            phi_319_ = true;
        }
        let _e113 = phi_318_;
        let _e115 = phi_319_;
        if _e115 {
            phi_323_ = param_8;
        } else {
            phi_323_ = _e113;
        }
        let _e117 = phi_323_;
        phi_371_ = (param_8 - _e117);
    } else {
        if (_e90 == 1u) {
            let _e120 = (param_8 * 0.5f);
            if (_e120 > -8388608f) {
                let _e132 = f32(select(0i, select(select(i32(_e120), i32(-2147483648), (_e120 < bitcast<f32>(3472883712u))), 2147483647i, (_e120 > bitcast<f32>(1325400063u))), (_e120 == _e120)));
                if (_e132 > _e120) {
                    phi_349_ = 1f;
                } else {
                    phi_349_ = 0f;
                }
                let _e135 = phi_349_;
                if (_e120 < 8388608f) {
                    phi_354_ = (_e132 - _e135);
                    phi_355_ = false;
                } else {
                    phi_354_ = f32();
                    phi_355_ = true;
                }
                let _e138 = phi_354_;
                let _e140 = phi_355_;
                phi_356_ = _e138;
                phi_357_ = _e140;
            } else {
                phi_356_ = f32();
                phi_357_ = true;
            }
            let _e142 = phi_356_;
            let _e144 = phi_357_;
            if _e144 {
                phi_361_ = _e120;
            } else {
                phi_361_ = _e142;
            }
            let _e146 = phi_361_;
            let _e148 = (param_8 - (2f * _e146));
            if (_e148 > 1f) {
                phi_369_ = (2f - _e148);
            } else {
                phi_369_ = _e148;
            }
            let _e152 = phi_369_;
            phi_370_ = _e152;
        } else {
            phi_370_ = param_8;
        }
        let _e154 = phi_370_;
        phi_371_ = _e154;
    }
    let _e156 = phi_371_;
    if (_e156 > 0f) {
        if (_e156 < 1f) {
            phi_380_ = _e156;
        } else {
            phi_380_ = 1f;
        }
        let _e160 = phi_380_;
        phi_381_ = _e160;
    } else {
        phi_381_ = 0f;
    }
    let _e162 = phi_381_;
    let _e163 = (_e77 - 1u);
    let _e165 = (_e162 * f32(_e77));
    if _e85 {
        let _e172 = select(select(u32(_e165), 0u, (_e165 < bitcast<f32>(0u))), 4294967295u, (_e165 > bitcast<f32>(1333788671u)));
        if (_e163 < _e172) {
            phi_399_ = _e163;
        } else {
            phi_399_ = _e172;
        }
        let _e175 = phi_399_;
        phi_438_ = texture_Axis(_e175, _e175, 0f);
    } else {
        let _e177 = (_e165 + 0.5f);
        let _e184 = select(select(u32(_e177), 0u, (_e177 < bitcast<f32>(0u))), 4294967295u, (_e177 > bitcast<f32>(1333788671u)));
        if (_e77 < _e184) {
            phi_413_ = _e77;
        } else {
            phi_413_ = _e184;
        }
        let _e187 = phi_413_;
        if (_e90 == 0u) {
            phi_420_ = _e163;
        } else {
            phi_420_ = 0u;
        }
        let _e192 = phi_420_;
        if (_e90 == 0u) {
            phi_425_ = 0u;
        } else {
            phi_425_ = _e163;
        }
        let _e195 = phi_425_;
        if (_e187 == 0u) {
            phi_431_ = _e192;
        } else {
            phi_431_ = (_e187 - 1u);
        }
        let _e199 = phi_431_;
        if (_e187 > _e163) {
            phi_436_ = _e195;
        } else {
            phi_436_ = _e187;
        }
        let _e202 = phi_436_;
        phi_438_ = texture_Axis(_e199, _e202, (_e177 - f32(_e187)));
    }
    let _e205 = phi_438_;
    let _e207 = (*param_7).flags;
    let _e210 = ((_e207 >> bitcast<u32>(6u)) & 3u);
    if (_e210 == 0u) {
        if (param_9 > -8388608f) {
            let _e223 = f32(select(0i, select(select(i32(param_9), i32(-2147483648), (param_9 < bitcast<f32>(3472883712u))), 2147483647i, (param_9 > bitcast<f32>(1325400063u))), (param_9 == param_9)));
            if (_e223 > param_9) {
                phi_466_ = 1f;
            } else {
                phi_466_ = 0f;
            }
            let _e226 = phi_466_;
            if (param_9 < 8388608f) {
                phi_471_ = (_e223 - _e226);
                phi_472_ = false;
            } else {
                phi_471_ = f32();
                phi_472_ = true;
            }
            let _e229 = phi_471_;
            let _e231 = phi_472_;
            phi_473_ = _e229;
            phi_474_ = _e231;
        } else {
            phi_473_ = f32();
            phi_474_ = true;
        }
        let _e233 = phi_473_;
        let _e235 = phi_474_;
        if _e235 {
            phi_478_ = param_9;
        } else {
            phi_478_ = _e233;
        }
        let _e237 = phi_478_;
        phi_526_ = (param_9 - _e237);
    } else {
        if (_e210 == 1u) {
            let _e240 = (param_9 * 0.5f);
            if (_e240 > -8388608f) {
                let _e252 = f32(select(0i, select(select(i32(_e240), i32(-2147483648), (_e240 < bitcast<f32>(3472883712u))), 2147483647i, (_e240 > bitcast<f32>(1325400063u))), (_e240 == _e240)));
                if (_e252 > _e240) {
                    phi_504_ = 1f;
                } else {
                    phi_504_ = 0f;
                }
                let _e255 = phi_504_;
                if (_e240 < 8388608f) {
                    phi_509_ = (_e252 - _e255);
                    phi_510_ = false;
                } else {
                    phi_509_ = f32();
                    phi_510_ = true;
                }
                let _e258 = phi_509_;
                let _e260 = phi_510_;
                phi_511_ = _e258;
                phi_512_ = _e260;
            } else {
                phi_511_ = f32();
                phi_512_ = true;
            }
            let _e262 = phi_511_;
            let _e264 = phi_512_;
            if _e264 {
                phi_516_ = _e240;
            } else {
                phi_516_ = _e262;
            }
            let _e266 = phi_516_;
            let _e268 = (param_9 - (2f * _e266));
            if (_e268 > 1f) {
                phi_524_ = (2f - _e268);
            } else {
                phi_524_ = _e268;
            }
            let _e272 = phi_524_;
            phi_525_ = _e272;
        } else {
            phi_525_ = param_9;
        }
        let _e274 = phi_525_;
        phi_526_ = _e274;
    }
    let _e276 = phi_526_;
    if (_e276 > 0f) {
        if (_e276 < 1f) {
            phi_535_ = _e276;
        } else {
            phi_535_ = 1f;
        }
        let _e280 = phi_535_;
        phi_536_ = _e280;
    } else {
        phi_536_ = 0f;
    }
    let _e282 = phi_536_;
    let _e283 = (_e81 - 1u);
    let _e285 = (_e282 * f32(_e81));
    if _e85 {
        let _e292 = select(select(u32(_e285), 0u, (_e285 < bitcast<f32>(0u))), 4294967295u, (_e285 > bitcast<f32>(1333788671u)));
        if (_e283 < _e292) {
            phi_554_ = _e283;
        } else {
            phi_554_ = _e292;
        }
        let _e295 = phi_554_;
        phi_593_ = texture_Axis(_e295, _e295, 0f);
    } else {
        let _e297 = (_e285 + 0.5f);
        let _e304 = select(select(u32(_e297), 0u, (_e297 < bitcast<f32>(0u))), 4294967295u, (_e297 > bitcast<f32>(1333788671u)));
        if (_e81 < _e304) {
            phi_568_ = _e81;
        } else {
            phi_568_ = _e304;
        }
        let _e307 = phi_568_;
        if (_e210 == 0u) {
            phi_575_ = _e283;
        } else {
            phi_575_ = 0u;
        }
        let _e312 = phi_575_;
        if (_e210 == 0u) {
            phi_580_ = 0u;
        } else {
            phi_580_ = _e283;
        }
        let _e315 = phi_580_;
        if (_e307 == 0u) {
            phi_586_ = _e312;
        } else {
            phi_586_ = (_e307 - 1u);
        }
        let _e319 = phi_586_;
        if (_e307 > _e283) {
            phi_591_ = _e315;
        } else {
            phi_591_ = _e307;
        }
        let _e322 = phi_591_;
        phi_593_ = texture_Axis(_e319, _e322, (_e297 - f32(_e307)));
    }
    let _e325 = phi_593_;
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
    var phi_652_: f32;

    if (param_12 > param_13) {
        phi_652_ = param_12;
    } else {
        phi_652_ = param_13;
    }
    let _e76 = phi_652_;
    return _e76;
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var local_2: lt_bvh_traverse_Stack;
    var phi_798_: bool;
    var phi_799_: bool;
    var phi_800_: bool;
    var phi_801_: bool;
    var phi_805_: bool;
    var phi_818_: bool;
    var phi_819_: bool;
    var phi_820_: bool;
    var phi_821_: bool;
    var phi_825_: bool;
    var phi_838_: bool;
    var phi_839_: bool;
    var phi_840_: bool;
    var phi_844_: bool;
    var phi_845_: bool;
    var phi_846_: bool;
    var phi_847_: bool;
    var phi_848_: bool;
    var phi_852_: bool;
    var phi_928_: f32;
    var phi_935_: f32;
    var phi_943_: f32;
    var phi_950_: f32;
    var phi_958_: f32;
    var phi_965_: f32;
    var phi_988_: f32;
    var phi_993_: f32;
    var phi_998_: f32;
    var phi_1003_: f32;
    var phi_1008_: f32;
    var phi_1027_: u32;
    var phi_1032_: u32;
    var phi_1037_: u32;
    var phi_1151_: bool;
    var phi_1152_: bool;
    var phi_1183_: u32;
    var phi_1185_: u32;
    var phi_1188_: lt_bvh_Hit;
    var phi_1273_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1300_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1327_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1333_: u32;
    var phi_1336_: u32;
    var phi_1350_: u32;
    var phi_1360_: u32;
    var phi_1370_: u32;
    var phi_1388_: u32;
    var phi_1398_: u32;
    var phi_1408_: u32;
    var phi_1444_: u32;
    var phi_1457_: u32;
    var phi_1462_: u32;
    var phi_1463_: u32;
    var phi_1464_: u32;
    var phi_1334_: u32;
    var phi_1337_: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_1522_: u32;
    var phi_1525_: lt_bvh_Hit;
    var phi_1580_: f32;
    var phi_1585_: f32;
    var phi_1590_: f32;
    var phi_1598_: f32;
    var phi_1603_: f32;
    var phi_1608_: f32;
    var phi_1740_: bool;
    var phi_1741_: bool;
    var phi_1742_: bool;
    var phi_1743_: bool;
    var phi_1747_: bool;
    var phi_1760_: bool;
    var phi_1761_: bool;
    var phi_1762_: bool;
    var phi_1763_: bool;
    var phi_1767_: bool;
    var phi_1780_: bool;
    var phi_1781_: bool;
    var phi_1782_: bool;
    var phi_1786_: bool;
    var phi_1787_: bool;
    var phi_1788_: bool;
    var phi_1789_: bool;
    var phi_1790_: bool;
    var phi_1794_: bool;
    var phi_1864_: f32;
    var phi_1871_: f32;
    var phi_1878_: f32;
    var phi_1885_: f32;
    var phi_1892_: f32;
    var phi_1899_: f32;
    var phi_1916_: f32;
    var phi_1921_: f32;
    var phi_1926_: f32;
    var phi_1931_: f32;
    var phi_1936_: f32;
    var phi_1962_: bool;
    var phi_1963_: bool;
    var phi_1971_: u32;
    var phi_1972_: u32;
    var phi_1983_: vec3<f32>;
    var phi_1984_: vec3<f32>;
    var phi_1997_: u32;
    var phi_2002_: u32;
    var phi_2007_: u32;
    var phi_2121_: bool;
    var phi_2122_: bool;
    var phi_2153_: u32;
    var phi_2155_: lt_bvh_Hit;
    var phi_2158_: u32;
    var phi_2239_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2266_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2293_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2299_: u32;
    var phi_2302_: u32;
    var phi_2316_: u32;
    var phi_2326_: u32;
    var phi_2336_: u32;
    var phi_2354_: u32;
    var phi_2364_: u32;
    var phi_2374_: u32;
    var phi_2410_: u32;
    var phi_2423_: u32;
    var phi_2428_: u32;
    var phi_2429_: u32;
    var phi_2430_: u32;
    var phi_2300_: u32;
    var phi_2303_: u32;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_2488_: lt_bvh_Hit;
    var phi_2491_: u32;
    var phi_2535_: vec3<f32>;
    var phi_2536_: vec3<f32>;
    var phi_2565_: vec3<f32>;
    var phi_2566_: vec3<f32>;
    var phi_2595_: vec3<f32>;
    var phi_2596_: vec3<f32>;
    var phi_2614_: bool;
    var phi_2615_: bool;
    var phi_2619_: f32;
    var phi_2620_: f32;
    var phi_2621_: f32;
    var phi_2622_: f32;
    var phi_2630_: f32;
    var phi_2640_: bool;
    var phi_2641_: bool;
    var phi_2645_: f32;
    var phi_2646_: f32;
    var phi_2647_: f32;
    var phi_2648_: f32;
    var phi_2656_: f32;
    var phi_2666_: bool;
    var phi_2667_: bool;
    var phi_2671_: f32;
    var phi_2672_: f32;
    var phi_2673_: f32;
    var phi_2674_: f32;
    var phi_2682_: f32;
    var phi_2697_: f32;
    var phi_2698_: bool;
    var phi_2699_: f32;
    var phi_2700_: bool;
    var phi_2701_: f32;
    var phi_2702_: bool;
    var phi_2720_: f32;
    var phi_2721_: bool;
    var phi_2722_: bool;
    var phi_2723_: f32;
    var phi_2724_: bool;
    var phi_2725_: bool;
    var phi_2729_: bool;
    var phi_2730_: f32;
    var phi_2731_: bool;
    var phi_2759_: vec3<f32>;
    var phi_2760_: vec3<f32>;
    var phi_2785_: vec3<f32>;
    var phi_2786_: vec3<f32>;
    var phi_2811_: vec3<f32>;
    var phi_2812_: vec3<f32>;
    var phi_2868_: f32;
    var phi_2877_: f32;
    var phi_2886_: f32;
    var phi_2895_: f32;
    var phi_2902_: f32;
    var phi_2909_: f32;
    var phi_2922_: f32;
    var phi_2931_: f32;
    var phi_2940_: f32;
    var phi_2949_: f32;
    var phi_2956_: f32;
    var phi_2963_: f32;
    var phi_2980_: f32;
    var phi_2985_: f32;
    var phi_2990_: f32;
    var phi_2998_: f32;
    var phi_3003_: f32;
    var phi_3008_: f32;
    var phi_3020_: f32;
    var phi_3025_: f32;
    var phi_3030_: f32;
    var phi_3035_: f32;
    var phi_3040_: lt_bvh_triangle_Intersection;
    var phi_3041_: bool;
    var phi_3042_: lt_bvh_triangle_Intersection;
    var phi_3043_: bool;
    var phi_3047_: lt_bvh_triangle_Intersection;
    var phi_3048_: bool;
    var phi_3049_: lt_bvh_triangle_Intersection;
    var phi_3050_: bool;
    var phi_3051_: bool;
    var phi_3055_: bool;
    var phi_3059_: lt_bvh_triangle_Intersection;
    var phi_3097_: bool;
    var phi_3098_: bool;
    var phi_3099_: bool;
    var phi_3100_: bool;
    var phi_3101_: bool;
    var phi_3102_: bool;
    var phi_3106_: bool;
    var phi_3107_: bool;
    var phi_3121_: bool;
    var phi_3129_: lt_bvh_Hit;
    var phi_3130_: lt_bvh_Hit;
    var phi_3131_: lt_bvh_Hit;
    var phi_3132_: lt_bvh_Hit;
    var phi_2489_: lt_bvh_Hit;
    var phi_2492_: u32;
    var phi_3133_: bool;
    var phi_3172_: bool;
    var phi_3173_: bool;
    var phi_3204_: u32;
    var phi_2156_: lt_bvh_Hit;
    var phi_2159_: u32;
    var phi_3205_: lt_bvh_Hit;
    var phi_3206_: lt_bvh_Hit;
    var phi_3207_: bool;
    var phi_3211_: lt_bvh_Hit;
    var phi_3212_: lt_bvh_Hit;
    var phi_3213_: lt_bvh_Hit;
    var phi_3214_: lt_bvh_Hit;
    var phi_1523_: u32;
    var phi_1526_: lt_bvh_Hit;
    var phi_3215_: bool;
    var phi_3254_: bool;
    var phi_3255_: bool;
    var phi_3286_: u32;
    var phi_1186_: u32;
    var phi_1189_: lt_bvh_Hit;
    var phi_3287_: lt_bvh_Hit;
    var phi_3288_: lt_bvh_Hit;
    var phi_3289_: bool;
    var phi_3293_: lt_bvh_Hit;
    var phi_3480_: f32;
    var phi_3485_: f32;
    var phi_3490_: f32;
    var phi_3498_: f32;
    var phi_3503_: f32;
    var phi_3508_: f32;
    var phi_3572_: vec3<f32>;
    var phi_3815_: vec3<f32>;
    var phi_3830_: u32;
    var phi_3857_: f32;
    var phi_3864_: f32;
    var phi_3871_: f32;
    var phi_3906_: f32;
    var phi_3913_: f32;
    var phi_3920_: f32;
    var phi_3958_: f32;
    var phi_3965_: f32;
    var phi_3972_: f32;
    var phi_4058_: vec3<f32>;
    var phi_4059_: vec3<f32>;
    var phi_4060_: vec3<f32>;
    var phi_4069_: f32;
    var phi_4070_: f32;
    var phi_4080_: f32;
    var phi_4081_: f32;
    var phi_4091_: f32;
    var phi_4092_: f32;
    var phi_4127_: abi_Sample;
    var phi_4350_: vec3<f32>;
    var local_9: lt_bvh_Hit;
    var local_10: lt_bvh_Hit;
    var local_11: lt_bvh_Hit;
    var local_12: lt_bvh_Hit;

    let _e75 = id_1;
    let _e79 = arrayLength((&nodes.member));
    let _e82 = arrayLength((&triangles.member));
    let _e85 = arrayLength((&vertices.member));
    let _e94 = arrayLength((&instances.member));
    let _e97 = arrayLength((&color_texels.member));
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
                phi_798_ = (abs(_e183.origin.z) < 1000000000000000f);
                phi_799_ = false;
            } else {
                phi_798_ = bool();
                phi_799_ = true;
            }
            let _e204 = phi_798_;
            let _e206 = phi_799_;
            phi_800_ = _e204;
            phi_801_ = _e206;
        } else {
            phi_800_ = bool();
            phi_801_ = true;
        }
        let _e208 = phi_800_;
        let _e210 = phi_801_;
        if _e210 {
            phi_805_ = false;
        } else {
            phi_805_ = _e208;
        }
        let _e212 = phi_805_;
        if _e212 {
            if (_e188 < 1000000000000000f) {
                if (_e190 < 1000000000000000f) {
                    phi_818_ = (_e192 < 1000000000000000f);
                    phi_819_ = false;
                } else {
                    phi_818_ = bool();
                    phi_819_ = true;
                }
                let _e217 = phi_818_;
                let _e219 = phi_819_;
                phi_820_ = _e217;
                phi_821_ = _e219;
            } else {
                phi_820_ = bool();
                phi_821_ = true;
            }
            let _e221 = phi_820_;
            let _e223 = phi_821_;
            if _e223 {
                phi_825_ = false;
            } else {
                phi_825_ = _e221;
            }
            let _e225 = phi_825_;
            if _e225 {
                if (_e188 > 0f) {
                    phi_839_ = bool();
                    phi_840_ = true;
                } else {
                    let _e227 = (_e190 > 0f);
                    if _e227 {
                        phi_838_ = bool();
                    } else {
                        phi_838_ = (_e192 > 0f);
                    }
                    let _e230 = phi_838_;
                    phi_839_ = _e230;
                    phi_840_ = _e227;
                }
                let _e232 = phi_839_;
                let _e234 = phi_840_;
                if _e234 {
                    phi_844_ = true;
                } else {
                    phi_844_ = _e232;
                }
                let _e236 = phi_844_;
                phi_845_ = _e236;
                phi_846_ = false;
            } else {
                phi_845_ = bool();
                phi_846_ = true;
            }
            let _e238 = phi_845_;
            let _e240 = phi_846_;
            phi_847_ = _e238;
            phi_848_ = _e240;
        } else {
            phi_847_ = bool();
            phi_848_ = true;
        }
        let _e242 = phi_847_;
        let _e244 = phi_848_;
        if _e244 {
            phi_852_ = false;
        } else {
            phi_852_ = _e242;
        }
        let _e246 = phi_852_;
        if _e246 {
            let _e247 = (_e115 >= _e79);
            if _e247 {
                phi_3287_ = lt_bvh_Hit();
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
                    phi_928_ = _e318;
                } else {
                    phi_928_ = abs(_e183.direction.x);
                }
                let _e324 = phi_928_;
                if (_e183.direction.x < 0f) {
                    phi_935_ = (-1f / _e324);
                } else {
                    phi_935_ = (1f / _e324);
                }
                let _e329 = phi_935_;
                if (abs(_e183.direction.y) < _e318) {
                    phi_943_ = _e318;
                } else {
                    phi_943_ = abs(_e183.direction.y);
                }
                let _e335 = phi_943_;
                if (_e183.direction.y < 0f) {
                    phi_950_ = (-1f / _e335);
                } else {
                    phi_950_ = (1f / _e335);
                }
                let _e340 = phi_950_;
                if (abs(_e183.direction.z) < _e318) {
                    phi_958_ = _e318;
                } else {
                    phi_958_ = abs(_e183.direction.z);
                }
                let _e346 = phi_958_;
                if (_e183.direction.z < 0f) {
                    phi_965_ = (-1f / _e346);
                } else {
                    phi_965_ = (1f / _e346);
                }
                let _e351 = phi_965_;
                let _e358 = abs((bitcast<f32>(_e253) - _e183.origin.x));
                let _e359 = abs((bitcast<f32>(_e257) - _e183.origin.y));
                let _e360 = abs((bitcast<f32>(_e261) - _e183.origin.z));
                let _e367 = abs(((bitcast<f32>(_e265) + (bitcast<f32>((((_e277 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e183.origin.x));
                let _e368 = abs(((bitcast<f32>(_e269) + (bitcast<f32>((((_e277 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e183.origin.y));
                let _e369 = abs(((bitcast<f32>(_e273) + (bitcast<f32>((((_e277 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e183.origin.z));
                if (_e358 > _e367) {
                    phi_988_ = _e358;
                } else {
                    phi_988_ = _e367;
                }
                let _e372 = phi_988_;
                if (_e359 > _e368) {
                    phi_993_ = _e359;
                } else {
                    phi_993_ = _e368;
                }
                let _e375 = phi_993_;
                if (_e360 > _e369) {
                    phi_998_ = _e360;
                } else {
                    phi_998_ = _e369;
                }
                let _e378 = phi_998_;
                if (_e372 > _e375) {
                    phi_1003_ = _e372;
                } else {
                    phi_1003_ = _e375;
                }
                let _e381 = phi_1003_;
                if (_e381 > _e378) {
                    phi_1008_ = _e381;
                } else {
                    phi_1008_ = _e378;
                }
                let _e384 = phi_1008_;
                let _e388 = (_e384 * 0.0000019073486f);
                let _e389 = (abs(_e329) * _e388);
                let _e390 = (abs(_e340) * _e388);
                let _e391 = (abs(_e351) * _e388);
                let _e395 = (_e384 * 0.0000009536743f);
                let _e396 = (abs(_e329) * _e395);
                let _e397 = (abs(_e340) * _e395);
                let _e398 = (abs(_e351) * _e395);
                if (_e329 < 0f) {
                    phi_1027_ = 0u;
                } else {
                    phi_1027_ = 1u;
                }
                let _e401 = phi_1027_;
                if (_e340 < 0f) {
                    phi_1032_ = 0u;
                } else {
                    phi_1032_ = 2u;
                }
                let _e404 = phi_1032_;
                if (_e351 < 0f) {
                    phi_1037_ = 0u;
                } else {
                    phi_1037_ = 4u;
                }
                let _e407 = phi_1037_;
                let _e409 = ((_e401 | _e404) | _e407);
                let _e410 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e115, 2147483648u);
                local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e410.first[0], _e410.first[1], _e410.first[2], _e410.first[3], _e410.first[4], _e410.first[5], _e410.first[6], _e410.first[7], _e410.first[8], _e410.first[9], _e410.first[10], _e410.first[11], _e410.first[12], _e410.first[13], _e410.first[14], _e410.first[15], _e410.first[16], _e410.first[17], _e410.first[18], _e410.first[19], _e410.first[20], _e410.first[21], _e410.first[22], _e410.first[23], _e410.first[24], _e410.first[25], _e410.first[26], _e410.first[27], _e410.first[28], _e410.first[29], _e410.first[30], _e410.first[31]), array<u32, 32>(_e410.mask[0], _e410.mask[1], _e410.mask[2], _e410.mask[3], _e410.mask[4], _e410.mask[5], _e410.mask[6], _e410.mask[7], _e410.mask[8], _e410.mask[9], _e410.mask[10], _e410.mask[11], _e410.mask[12], _e410.mask[13], _e410.mask[14], _e410.mask[15], _e410.mask[16], _e410.mask[17], _e410.mask[18], _e410.mask[19], _e410.mask[20], _e410.mask[21], _e410.mask[22], _e410.mask[23], _e410.mask[24], _e410.mask[25], _e410.mask[26], _e410.mask[27], _e410.mask[28], _e410.mask[29], _e410.mask[30], _e410.mask[31]), _e410.len, _e410.group, _e410.group_mask);
                let _e484 = local_2.group_mask;
                if ((_e484 & 4278190080u) == 0u) {
                    let _e488 = local_2.len;
                    if (_e488 == 0u) {
                        phi_1151_ = false;
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
                        phi_1151_ = true;
                    }
                    let _e511 = phi_1151_;
                    phi_1152_ = _e511;
                } else {
                    phi_1152_ = true;
                }
                let _e513 = phi_1152_;
                if _e513 {
                    let _e515 = local_2.group_mask;
                    let _e521 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e515)), 32u, (_e515 == 0u)));
                    let _e525 = local_2.group_mask;
                    let _e539 = local_2.group_mask;
                    local_2.group_mask = (_e539 & ~((1u << bitcast<u32>((_e521 & 31u)))));
                    let _e542 = local_2.group;
                    phi_1183_ = (_e542 + countOneBits(((_e525 & ~((4294967295u << bitcast<u32>((((_e521 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1183_ = 4294967295u;
                }
                let _e545 = phi_1183_;
                phi_1185_ = _e545;
                phi_1188_ = _e185;
                loop {
                    let _e547 = phi_1185_;
                    let _e549 = phi_1188_;
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
                            phi_1273_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e637.unnamed, lt_bvh_traverse_Tree(_e637.unnamed_1.root, _e614.y));
                        } else {
                            let _e653 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e614.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e659 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e653.unnamed.root, _e614.y), _e653.unnamed_1);
                            let _e665 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e659.unnamed, lt_bvh_traverse_Tree(_e614.z, _e659.unnamed_1.first_primitive));
                            phi_1273_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e665.unnamed, lt_bvh_traverse_Tree(_e665.unnamed_1.root, _e614.w));
                        }
                        let _e673 = phi_1273_;
                        let _e683 = nodes.member[(0u + _e547)].y;
                        if (_e340 < 0f) {
                            let _e694 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e683.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e700 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e694.unnamed.root, _e683.w), _e694.unnamed_1);
                            let _e706 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e700.unnamed, lt_bvh_traverse_Tree(_e683.x, _e700.unnamed_1.first_primitive));
                            phi_1300_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e706.unnamed, lt_bvh_traverse_Tree(_e706.unnamed_1.root, _e683.y));
                        } else {
                            let _e722 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e683.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e728 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e722.unnamed.root, _e683.y), _e722.unnamed_1);
                            let _e734 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e728.unnamed, lt_bvh_traverse_Tree(_e683.z, _e728.unnamed_1.first_primitive));
                            phi_1300_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e734.unnamed, lt_bvh_traverse_Tree(_e734.unnamed_1.root, _e683.w));
                        }
                        let _e742 = phi_1300_;
                        let _e752 = nodes.member[(0u + _e547)].z;
                        if (_e351 < 0f) {
                            let _e763 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e752.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e769 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e763.unnamed.root, _e752.w), _e763.unnamed_1);
                            let _e775 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e769.unnamed, lt_bvh_traverse_Tree(_e752.x, _e769.unnamed_1.first_primitive));
                            phi_1327_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e775.unnamed, lt_bvh_traverse_Tree(_e775.unnamed_1.root, _e752.y));
                        } else {
                            let _e791 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e752.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e797 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e791.unnamed.root, _e752.y), _e791.unnamed_1);
                            let _e803 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e797.unnamed, lt_bvh_traverse_Tree(_e752.z, _e797.unnamed_1.first_primitive));
                            phi_1327_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e803.unnamed, lt_bvh_traverse_Tree(_e803.unnamed_1.root, _e752.w));
                        }
                        let _e811 = phi_1327_;
                        phi_1333_ = 0u;
                        phi_1336_ = 0u;
                        loop {
                            let _e821 = phi_1333_;
                            let _e823 = phi_1336_;
                            local_3 = _e823;
                            local_4 = _e823;
                            local_5 = _e823;
                            let _e824 = (_e821 < 8u);
                            if _e824 {
                                let _e826 = (_e821 >> bitcast<u32>(2i));
                                let _e827 = (_e821 & 3u);
                                if (_e826 == 0u) {
                                    phi_1350_ = _e673.unnamed.root;
                                } else {
                                    phi_1350_ = _e673.unnamed.first_primitive;
                                }
                                let _e830 = phi_1350_;
                                if (_e826 == 0u) {
                                    phi_1360_ = _e742.unnamed.root;
                                } else {
                                    phi_1360_ = _e742.unnamed.first_primitive;
                                }
                                let _e839 = phi_1360_;
                                if (_e826 == 0u) {
                                    phi_1370_ = _e811.unnamed.root;
                                } else {
                                    phi_1370_ = _e811.unnamed.first_primitive;
                                }
                                let _e848 = phi_1370_;
                                let _e861 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e830 >> bitcast<u32>(((_e827 * 8u) & 31u))) & 255u)) * _e583) + (_e604 - _e389)), ((f32(((_e839 >> bitcast<u32>(((_e827 * 8u) & 31u))) & 255u)) * _e584) + (_e605 - _e390)));
                                let _e862 = core_intrinsics_maximum_number_nsz_f32_(_e861, ((f32(((_e848 >> bitcast<u32>(((_e827 * 8u) & 31u))) & 255u)) * _e585) + (_e606 - _e391)));
                                if (_e826 == 0u) {
                                    phi_1388_ = _e673.unnamed_1.root;
                                } else {
                                    phi_1388_ = _e673.unnamed_1.first_primitive;
                                }
                                let _e865 = phi_1388_;
                                if (_e826 == 0u) {
                                    phi_1398_ = _e742.unnamed_1.root;
                                } else {
                                    phi_1398_ = _e742.unnamed_1.first_primitive;
                                }
                                let _e874 = phi_1398_;
                                if (_e826 == 0u) {
                                    phi_1408_ = _e811.unnamed_1.root;
                                } else {
                                    phi_1408_ = _e811.unnamed_1.first_primitive;
                                }
                                let _e883 = phi_1408_;
                                let _e896 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e865 >> bitcast<u32>(((_e827 * 8u) & 31u))) & 255u)) * _e583) + (_e604 + _e389)), ((f32(((_e874 >> bitcast<u32>(((_e827 * 8u) & 31u))) & 255u)) * _e584) + (_e605 + _e390)));
                                let _e897 = core_intrinsics_minimum_number_nsz_f32_(_e896, ((f32(((_e883 >> bitcast<u32>(((_e827 * 8u) & 31u))) & 255u)) * _e585) + (_e606 + _e391)));
                                if (_e862 <= _e897) {
                                    if (_e862 <= _e549.t) {
                                        if (_e897 >= _e183.tmin) {
                                            if (_e826 == 0u) {
                                                let _e904 = nodes.member[(0u + _e547)].links[2u];
                                                phi_1444_ = _e904;
                                            } else {
                                                let _e907 = nodes.member[(0u + _e547)].links[3u];
                                                phi_1444_ = _e907;
                                            }
                                            let _e909 = phi_1444_;
                                            let _e914 = ((_e909 >> bitcast<u32>(((_e827 * 8u) & 31u))) & 255u);
                                            let _e915 = (_e914 & 31u);
                                            if (_e915 >= 24u) {
                                                phi_1457_ = (24u + ((_e915 - 24u) ^ _e409));
                                            } else {
                                                phi_1457_ = _e915;
                                            }
                                            let _e921 = phi_1457_;
                                            phi_1462_ = (_e823 | ((_e914 >> bitcast<u32>(5i)) << bitcast<u32>((_e921 & 31u))));
                                        } else {
                                            phi_1462_ = _e823;
                                        }
                                        let _e929 = phi_1462_;
                                        phi_1463_ = _e929;
                                    } else {
                                        phi_1463_ = _e823;
                                    }
                                    let _e931 = phi_1463_;
                                    phi_1464_ = _e931;
                                } else {
                                    phi_1464_ = _e823;
                                }
                                let _e933 = phi_1464_;
                                phi_1334_ = (_e821 + 1u);
                                phi_1337_ = _e933;
                            } else {
                                phi_1334_ = u32();
                                phi_1337_ = u32();
                            }
                            let _e936 = phi_1334_;
                            let _e938 = phi_1337_;
                            continue;
                            continuing {
                                phi_1333_ = _e936;
                                phi_1336_ = _e938;
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
                        phi_1522_ = (_e987 & 16777215u);
                        phi_1525_ = _e549;
                        loop {
                            let _e990 = phi_1522_;
                            let _e992 = phi_1525_;
                            local_11 = _e992;
                            if (_e990 == 0u) {
                                phi_1523_ = u32();
                                phi_1526_ = lt_bvh_Hit();
                                phi_3215_ = false;
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
                                    phi_1580_ = _e1019;
                                } else {
                                    phi_1580_ = _e1031;
                                }
                                let _e1036 = phi_1580_;
                                if (_e1020 < _e1032) {
                                    phi_1585_ = _e1020;
                                } else {
                                    phi_1585_ = _e1032;
                                }
                                let _e1039 = phi_1585_;
                                if (_e1021 < _e1033) {
                                    phi_1590_ = _e1021;
                                } else {
                                    phi_1590_ = _e1033;
                                }
                                let _e1042 = phi_1590_;
                                if (_e1019 > _e1031) {
                                    phi_1598_ = _e1019;
                                } else {
                                    phi_1598_ = _e1031;
                                }
                                let _e1048 = phi_1598_;
                                if (_e1020 > _e1032) {
                                    phi_1603_ = _e1020;
                                } else {
                                    phi_1603_ = _e1032;
                                }
                                let _e1051 = phi_1603_;
                                if (_e1021 > _e1033) {
                                    phi_1608_ = _e1021;
                                } else {
                                    phi_1608_ = _e1033;
                                }
                                let _e1054 = phi_1608_;
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
                                                    phi_1740_ = (abs(_e1110) < 1000000000000000f);
                                                    phi_1741_ = false;
                                                } else {
                                                    phi_1740_ = bool();
                                                    phi_1741_ = true;
                                                }
                                                let _e1172 = phi_1740_;
                                                let _e1174 = phi_1741_;
                                                phi_1742_ = _e1172;
                                                phi_1743_ = _e1174;
                                            } else {
                                                phi_1742_ = bool();
                                                phi_1743_ = true;
                                            }
                                            let _e1176 = phi_1742_;
                                            let _e1178 = phi_1743_;
                                            if _e1178 {
                                                phi_1747_ = false;
                                            } else {
                                                phi_1747_ = _e1176;
                                            }
                                            let _e1180 = phi_1747_;
                                            if _e1180 {
                                                if (_e1162 < 1000000000000000f) {
                                                    if (_e1163 < 1000000000000000f) {
                                                        phi_1760_ = (_e1164 < 1000000000000000f);
                                                        phi_1761_ = false;
                                                    } else {
                                                        phi_1760_ = bool();
                                                        phi_1761_ = true;
                                                    }
                                                    let _e1185 = phi_1760_;
                                                    let _e1187 = phi_1761_;
                                                    phi_1762_ = _e1185;
                                                    phi_1763_ = _e1187;
                                                } else {
                                                    phi_1762_ = bool();
                                                    phi_1763_ = true;
                                                }
                                                let _e1189 = phi_1762_;
                                                let _e1191 = phi_1763_;
                                                if _e1191 {
                                                    phi_1767_ = false;
                                                } else {
                                                    phi_1767_ = _e1189;
                                                }
                                                let _e1193 = phi_1767_;
                                                if _e1193 {
                                                    if (_e1162 > 0f) {
                                                        phi_1781_ = bool();
                                                        phi_1782_ = true;
                                                    } else {
                                                        let _e1195 = (_e1163 > 0f);
                                                        if _e1195 {
                                                            phi_1780_ = bool();
                                                        } else {
                                                            phi_1780_ = (_e1164 > 0f);
                                                        }
                                                        let _e1198 = phi_1780_;
                                                        phi_1781_ = _e1198;
                                                        phi_1782_ = _e1195;
                                                    }
                                                    let _e1200 = phi_1781_;
                                                    let _e1202 = phi_1782_;
                                                    if _e1202 {
                                                        phi_1786_ = true;
                                                    } else {
                                                        phi_1786_ = _e1200;
                                                    }
                                                    let _e1204 = phi_1786_;
                                                    phi_1787_ = _e1204;
                                                    phi_1788_ = false;
                                                } else {
                                                    phi_1787_ = bool();
                                                    phi_1788_ = true;
                                                }
                                                let _e1206 = phi_1787_;
                                                let _e1208 = phi_1788_;
                                                phi_1789_ = _e1206;
                                                phi_1790_ = _e1208;
                                            } else {
                                                phi_1789_ = bool();
                                                phi_1790_ = true;
                                            }
                                            let _e1210 = phi_1789_;
                                            let _e1212 = phi_1790_;
                                            if _e1212 {
                                                phi_1794_ = false;
                                            } else {
                                                phi_1794_ = _e1210;
                                            }
                                            let _e1214 = phi_1794_;
                                            if _e1214 {
                                                let _e1215 = (_e1159 >= _e79);
                                                if _e1215 {
                                                    phi_3205_ = lt_bvh_Hit();
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
                                                        phi_1864_ = _e1281;
                                                    } else {
                                                        phi_1864_ = abs(_e1128);
                                                    }
                                                    let _e1286 = phi_1864_;
                                                    if (_e1128 < 0f) {
                                                        phi_1871_ = (-1f / _e1286);
                                                    } else {
                                                        phi_1871_ = (1f / _e1286);
                                                    }
                                                    let _e1291 = phi_1871_;
                                                    if (abs(_e1141) < _e1281) {
                                                        phi_1878_ = _e1281;
                                                    } else {
                                                        phi_1878_ = abs(_e1141);
                                                    }
                                                    let _e1296 = phi_1878_;
                                                    if (_e1141 < 0f) {
                                                        phi_1885_ = (-1f / _e1296);
                                                    } else {
                                                        phi_1885_ = (1f / _e1296);
                                                    }
                                                    let _e1301 = phi_1885_;
                                                    if (abs(_e1154) < _e1281) {
                                                        phi_1892_ = _e1281;
                                                    } else {
                                                        phi_1892_ = abs(_e1154);
                                                    }
                                                    let _e1306 = phi_1892_;
                                                    if (_e1154 < 0f) {
                                                        phi_1899_ = (-1f / _e1306);
                                                    } else {
                                                        phi_1899_ = (1f / _e1306);
                                                    }
                                                    let _e1311 = phi_1899_;
                                                    let _e1315 = abs((bitcast<f32>(_e1221) - _e1084));
                                                    let _e1316 = abs((bitcast<f32>(_e1225) - _e1097));
                                                    let _e1317 = abs((bitcast<f32>(_e1229) - _e1110));
                                                    let _e1321 = abs(((bitcast<f32>(_e1233) + (bitcast<f32>((((_e1245 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1084));
                                                    let _e1322 = abs(((bitcast<f32>(_e1237) + (bitcast<f32>((((_e1245 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1097));
                                                    let _e1323 = abs(((bitcast<f32>(_e1241) + (bitcast<f32>((((_e1245 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1110));
                                                    if (_e1315 > _e1321) {
                                                        phi_1916_ = _e1315;
                                                    } else {
                                                        phi_1916_ = _e1321;
                                                    }
                                                    let _e1326 = phi_1916_;
                                                    if (_e1316 > _e1322) {
                                                        phi_1921_ = _e1316;
                                                    } else {
                                                        phi_1921_ = _e1322;
                                                    }
                                                    let _e1329 = phi_1921_;
                                                    if (_e1317 > _e1323) {
                                                        phi_1926_ = _e1317;
                                                    } else {
                                                        phi_1926_ = _e1323;
                                                    }
                                                    let _e1332 = phi_1926_;
                                                    if (_e1326 > _e1329) {
                                                        phi_1931_ = _e1326;
                                                    } else {
                                                        phi_1931_ = _e1329;
                                                    }
                                                    let _e1335 = phi_1931_;
                                                    if (_e1335 > _e1332) {
                                                        phi_1936_ = _e1335;
                                                    } else {
                                                        phi_1936_ = _e1332;
                                                    }
                                                    let _e1338 = phi_1936_;
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
                                                            phi_1962_ = false;
                                                        } else {
                                                            phi_1962_ = true;
                                                        }
                                                        let _e1359 = phi_1962_;
                                                        phi_1963_ = _e1359;
                                                    } else {
                                                        phi_1963_ = true;
                                                    }
                                                    let _e1361 = phi_1963_;
                                                    if _e1361 {
                                                        if (_e1354 >= _e1355) {
                                                            phi_1971_ = 1u;
                                                        } else {
                                                            phi_1971_ = 2u;
                                                        }
                                                        let _e1364 = phi_1971_;
                                                        phi_1972_ = _e1364;
                                                    } else {
                                                        phi_1972_ = 0u;
                                                    }
                                                    let _e1366 = phi_1972_;
                                                    if (_e1366 == 0u) {
                                                        phi_1984_ = vec3<f32>(_e1141, _e1154, _e1128);
                                                    } else {
                                                        if (_e1366 == 1u) {
                                                            phi_1983_ = vec3<f32>(_e1154, _e1128, _e1141);
                                                        } else {
                                                            phi_1983_ = vec3<f32>(_e1128, _e1141, _e1154);
                                                        }
                                                        let _e1372 = phi_1983_;
                                                        phi_1984_ = _e1372;
                                                    }
                                                    let _e1374 = phi_1984_;
                                                    let _e1377 = (_e1374.x / _e1374.z);
                                                    let _e1380 = (_e1374.y / _e1374.z);
                                                    if (_e1291 < 0f) {
                                                        phi_1997_ = 0u;
                                                    } else {
                                                        phi_1997_ = 1u;
                                                    }
                                                    let _e1385 = phi_1997_;
                                                    if (_e1301 < 0f) {
                                                        phi_2002_ = 0u;
                                                    } else {
                                                        phi_2002_ = 2u;
                                                    }
                                                    let _e1388 = phi_2002_;
                                                    if (_e1311 < 0f) {
                                                        phi_2007_ = 0u;
                                                    } else {
                                                        phi_2007_ = 4u;
                                                    }
                                                    let _e1391 = phi_2007_;
                                                    let _e1393 = ((_e1385 | _e1388) | _e1391);
                                                    let _e1394 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1159, 2147483648u);
                                                    local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e1394.first[0], _e1394.first[1], _e1394.first[2], _e1394.first[3], _e1394.first[4], _e1394.first[5], _e1394.first[6], _e1394.first[7], _e1394.first[8], _e1394.first[9], _e1394.first[10], _e1394.first[11], _e1394.first[12], _e1394.first[13], _e1394.first[14], _e1394.first[15], _e1394.first[16], _e1394.first[17], _e1394.first[18], _e1394.first[19], _e1394.first[20], _e1394.first[21], _e1394.first[22], _e1394.first[23], _e1394.first[24], _e1394.first[25], _e1394.first[26], _e1394.first[27], _e1394.first[28], _e1394.first[29], _e1394.first[30], _e1394.first[31]), array<u32, 32>(_e1394.mask[0], _e1394.mask[1], _e1394.mask[2], _e1394.mask[3], _e1394.mask[4], _e1394.mask[5], _e1394.mask[6], _e1394.mask[7], _e1394.mask[8], _e1394.mask[9], _e1394.mask[10], _e1394.mask[11], _e1394.mask[12], _e1394.mask[13], _e1394.mask[14], _e1394.mask[15], _e1394.mask[16], _e1394.mask[17], _e1394.mask[18], _e1394.mask[19], _e1394.mask[20], _e1394.mask[21], _e1394.mask[22], _e1394.mask[23], _e1394.mask[24], _e1394.mask[25], _e1394.mask[26], _e1394.mask[27], _e1394.mask[28], _e1394.mask[29], _e1394.mask[30], _e1394.mask[31]), _e1394.len, _e1394.group, _e1394.group_mask);
                                                    let _e1468 = local_1.group_mask;
                                                    if ((_e1468 & 4278190080u) == 0u) {
                                                        let _e1472 = local_1.len;
                                                        if (_e1472 == 0u) {
                                                            phi_2121_ = false;
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
                                                            phi_2121_ = true;
                                                        }
                                                        let _e1495 = phi_2121_;
                                                        phi_2122_ = _e1495;
                                                    } else {
                                                        phi_2122_ = true;
                                                    }
                                                    let _e1497 = phi_2122_;
                                                    if _e1497 {
                                                        let _e1499 = local_1.group_mask;
                                                        let _e1505 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1499)), 32u, (_e1499 == 0u)));
                                                        let _e1509 = local_1.group_mask;
                                                        let _e1523 = local_1.group_mask;
                                                        local_1.group_mask = (_e1523 & ~((1u << bitcast<u32>((_e1505 & 31u)))));
                                                        let _e1526 = local_1.group;
                                                        phi_2153_ = (_e1526 + countOneBits(((_e1509 & ~((4294967295u << bitcast<u32>((((_e1505 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_2153_ = 4294967295u;
                                                    }
                                                    let _e1529 = phi_2153_;
                                                    phi_2155_ = _e992;
                                                    phi_2158_ = _e1529;
                                                    loop {
                                                        let _e1531 = phi_2155_;
                                                        let _e1533 = phi_2158_;
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
                                                                phi_2239_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1617.unnamed, lt_bvh_traverse_Tree(_e1617.unnamed_1.root, _e1594.y));
                                                            } else {
                                                                let _e1633 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1594.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1639 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1633.unnamed.root, _e1594.y), _e1633.unnamed_1);
                                                                let _e1645 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1639.unnamed, lt_bvh_traverse_Tree(_e1594.z, _e1639.unnamed_1.first_primitive));
                                                                phi_2239_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1645.unnamed, lt_bvh_traverse_Tree(_e1645.unnamed_1.root, _e1594.w));
                                                            }
                                                            let _e1653 = phi_2239_;
                                                            let _e1663 = nodes.member[(0u + _e1533)].y;
                                                            if (_e1301 < 0f) {
                                                                let _e1674 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1663.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1680 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1674.unnamed.root, _e1663.w), _e1674.unnamed_1);
                                                                let _e1686 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1680.unnamed, lt_bvh_traverse_Tree(_e1663.x, _e1680.unnamed_1.first_primitive));
                                                                phi_2266_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1686.unnamed, lt_bvh_traverse_Tree(_e1686.unnamed_1.root, _e1663.y));
                                                            } else {
                                                                let _e1702 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1663.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1708 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1702.unnamed.root, _e1663.y), _e1702.unnamed_1);
                                                                let _e1714 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1708.unnamed, lt_bvh_traverse_Tree(_e1663.z, _e1708.unnamed_1.first_primitive));
                                                                phi_2266_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1714.unnamed, lt_bvh_traverse_Tree(_e1714.unnamed_1.root, _e1663.w));
                                                            }
                                                            let _e1722 = phi_2266_;
                                                            let _e1732 = nodes.member[(0u + _e1533)].z;
                                                            if (_e1311 < 0f) {
                                                                let _e1743 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1732.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1749 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1743.unnamed.root, _e1732.w), _e1743.unnamed_1);
                                                                let _e1755 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1749.unnamed, lt_bvh_traverse_Tree(_e1732.x, _e1749.unnamed_1.first_primitive));
                                                                phi_2293_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1755.unnamed, lt_bvh_traverse_Tree(_e1755.unnamed_1.root, _e1732.y));
                                                            } else {
                                                                let _e1771 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1732.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1777 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1771.unnamed.root, _e1732.y), _e1771.unnamed_1);
                                                                let _e1783 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1777.unnamed, lt_bvh_traverse_Tree(_e1732.z, _e1777.unnamed_1.first_primitive));
                                                                phi_2293_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1783.unnamed, lt_bvh_traverse_Tree(_e1783.unnamed_1.root, _e1732.w));
                                                            }
                                                            let _e1791 = phi_2293_;
                                                            phi_2299_ = 0u;
                                                            phi_2302_ = 0u;
                                                            loop {
                                                                let _e1801 = phi_2299_;
                                                                let _e1803 = phi_2302_;
                                                                local_6 = _e1803;
                                                                local_7 = _e1803;
                                                                local_8 = _e1803;
                                                                let _e1804 = (_e1801 < 8u);
                                                                if _e1804 {
                                                                    let _e1806 = (_e1801 >> bitcast<u32>(2i));
                                                                    let _e1807 = (_e1801 & 3u);
                                                                    if (_e1806 == 0u) {
                                                                        phi_2316_ = _e1653.unnamed.root;
                                                                    } else {
                                                                        phi_2316_ = _e1653.unnamed.first_primitive;
                                                                    }
                                                                    let _e1810 = phi_2316_;
                                                                    if (_e1806 == 0u) {
                                                                        phi_2326_ = _e1722.unnamed.root;
                                                                    } else {
                                                                        phi_2326_ = _e1722.unnamed.first_primitive;
                                                                    }
                                                                    let _e1819 = phi_2326_;
                                                                    if (_e1806 == 0u) {
                                                                        phi_2336_ = _e1791.unnamed.root;
                                                                    } else {
                                                                        phi_2336_ = _e1791.unnamed.first_primitive;
                                                                    }
                                                                    let _e1828 = phi_2336_;
                                                                    let _e1841 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1810 >> bitcast<u32>(((_e1807 * 8u) & 31u))) & 255u)) * _e1566) + (_e1584 - _e1343)), ((f32(((_e1819 >> bitcast<u32>(((_e1807 * 8u) & 31u))) & 255u)) * _e1567) + (_e1585 - _e1344)));
                                                                    let _e1842 = core_intrinsics_maximum_number_nsz_f32_(_e1841, ((f32(((_e1828 >> bitcast<u32>(((_e1807 * 8u) & 31u))) & 255u)) * _e1568) + (_e1586 - _e1345)));
                                                                    if (_e1806 == 0u) {
                                                                        phi_2354_ = _e1653.unnamed_1.root;
                                                                    } else {
                                                                        phi_2354_ = _e1653.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1845 = phi_2354_;
                                                                    if (_e1806 == 0u) {
                                                                        phi_2364_ = _e1722.unnamed_1.root;
                                                                    } else {
                                                                        phi_2364_ = _e1722.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1854 = phi_2364_;
                                                                    if (_e1806 == 0u) {
                                                                        phi_2374_ = _e1791.unnamed_1.root;
                                                                    } else {
                                                                        phi_2374_ = _e1791.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1863 = phi_2374_;
                                                                    let _e1876 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1845 >> bitcast<u32>(((_e1807 * 8u) & 31u))) & 255u)) * _e1566) + (_e1584 + _e1343)), ((f32(((_e1854 >> bitcast<u32>(((_e1807 * 8u) & 31u))) & 255u)) * _e1567) + (_e1585 + _e1344)));
                                                                    let _e1877 = core_intrinsics_minimum_number_nsz_f32_(_e1876, ((f32(((_e1863 >> bitcast<u32>(((_e1807 * 8u) & 31u))) & 255u)) * _e1568) + (_e1586 + _e1345)));
                                                                    if (_e1842 <= _e1877) {
                                                                        if (_e1842 <= _e1531.t) {
                                                                            if (_e1877 >= _e183.tmin) {
                                                                                if (_e1806 == 0u) {
                                                                                    let _e1884 = nodes.member[(0u + _e1533)].links[2u];
                                                                                    phi_2410_ = _e1884;
                                                                                } else {
                                                                                    let _e1887 = nodes.member[(0u + _e1533)].links[3u];
                                                                                    phi_2410_ = _e1887;
                                                                                }
                                                                                let _e1889 = phi_2410_;
                                                                                let _e1894 = ((_e1889 >> bitcast<u32>(((_e1807 * 8u) & 31u))) & 255u);
                                                                                let _e1895 = (_e1894 & 31u);
                                                                                if (_e1895 >= 24u) {
                                                                                    phi_2423_ = (24u + ((_e1895 - 24u) ^ _e1393));
                                                                                } else {
                                                                                    phi_2423_ = _e1895;
                                                                                }
                                                                                let _e1901 = phi_2423_;
                                                                                phi_2428_ = (_e1803 | ((_e1894 >> bitcast<u32>(5i)) << bitcast<u32>((_e1901 & 31u))));
                                                                            } else {
                                                                                phi_2428_ = _e1803;
                                                                            }
                                                                            let _e1909 = phi_2428_;
                                                                            phi_2429_ = _e1909;
                                                                        } else {
                                                                            phi_2429_ = _e1803;
                                                                        }
                                                                        let _e1911 = phi_2429_;
                                                                        phi_2430_ = _e1911;
                                                                    } else {
                                                                        phi_2430_ = _e1803;
                                                                    }
                                                                    let _e1913 = phi_2430_;
                                                                    phi_2300_ = (_e1801 + 1u);
                                                                    phi_2303_ = _e1913;
                                                                } else {
                                                                    phi_2300_ = u32();
                                                                    phi_2303_ = u32();
                                                                }
                                                                let _e1916 = phi_2300_;
                                                                let _e1918 = phi_2303_;
                                                                continue;
                                                                continuing {
                                                                    phi_2299_ = _e1916;
                                                                    phi_2302_ = _e1918;
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
                                                            phi_2488_ = _e1531;
                                                            phi_2491_ = (_e1967 & 16777215u);
                                                            loop {
                                                                let _e1970 = phi_2488_;
                                                                let _e1972 = phi_2491_;
                                                                local_9 = _e1970;
                                                                if (_e1972 == 0u) {
                                                                    phi_2489_ = lt_bvh_Hit();
                                                                    phi_2492_ = u32();
                                                                    phi_3133_ = false;
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
                                                                        phi_2536_ = vec3<f32>(_e1992, _e1994, _e1990);
                                                                    } else {
                                                                        if (_e1366 == 1u) {
                                                                            phi_2535_ = vec3<f32>(_e1994, _e1990, _e1992);
                                                                        } else {
                                                                            phi_2535_ = (_e1988 - vec3<f32>(_e1084, _e1097, _e1110));
                                                                        }
                                                                        let _e2002 = phi_2535_;
                                                                        phi_2536_ = _e2002;
                                                                    }
                                                                    let _e2004 = phi_2536_;
                                                                    let _e2008 = (_e2004.x - (_e1377 * _e2004.z));
                                                                    let _e2012 = (_e2004.y - (_e1380 * _e2004.z));
                                                                    let _e2014 = triangles.member[(0u + _e1981)].v1_;
                                                                    let _e2016 = (_e2014.x - _e1084);
                                                                    let _e2018 = (_e2014.y - _e1097);
                                                                    let _e2020 = (_e2014.z - _e1110);
                                                                    if (_e1366 == 0u) {
                                                                        phi_2566_ = vec3<f32>(_e2018, _e2020, _e2016);
                                                                    } else {
                                                                        if (_e1366 == 1u) {
                                                                            phi_2565_ = vec3<f32>(_e2020, _e2016, _e2018);
                                                                        } else {
                                                                            phi_2565_ = (_e2014 - vec3<f32>(_e1084, _e1097, _e1110));
                                                                        }
                                                                        let _e2028 = phi_2565_;
                                                                        phi_2566_ = _e2028;
                                                                    }
                                                                    let _e2030 = phi_2566_;
                                                                    let _e2034 = (_e2030.x - (_e1377 * _e2030.z));
                                                                    let _e2038 = (_e2030.y - (_e1380 * _e2030.z));
                                                                    let _e2040 = triangles.member[(0u + _e1981)].v2_;
                                                                    let _e2042 = (_e2040.x - _e1084);
                                                                    let _e2044 = (_e2040.y - _e1097);
                                                                    let _e2046 = (_e2040.z - _e1110);
                                                                    if (_e1366 == 0u) {
                                                                        phi_2596_ = vec3<f32>(_e2044, _e2046, _e2042);
                                                                    } else {
                                                                        if (_e1366 == 1u) {
                                                                            phi_2595_ = vec3<f32>(_e2046, _e2042, _e2044);
                                                                        } else {
                                                                            phi_2595_ = (_e2040 - vec3<f32>(_e1084, _e1097, _e1110));
                                                                        }
                                                                        let _e2054 = phi_2595_;
                                                                        phi_2596_ = _e2054;
                                                                    }
                                                                    let _e2056 = phi_2596_;
                                                                    let _e2060 = (_e2056.x - (_e1377 * _e2056.z));
                                                                    let _e2064 = (_e2056.y - (_e1380 * _e2056.z));
                                                                    if (_e2034 < _e2060) {
                                                                        phi_2615_ = true;
                                                                    } else {
                                                                        if (_e2034 == _e2060) {
                                                                            phi_2614_ = (_e2038 < _e2064);
                                                                        } else {
                                                                            phi_2614_ = false;
                                                                        }
                                                                        let _e2069 = phi_2614_;
                                                                        phi_2615_ = _e2069;
                                                                    }
                                                                    let _e2071 = phi_2615_;
                                                                    if _e2071 {
                                                                        phi_2619_ = _e2064;
                                                                        phi_2620_ = _e2060;
                                                                        phi_2621_ = _e2038;
                                                                        phi_2622_ = _e2034;
                                                                    } else {
                                                                        phi_2619_ = _e2038;
                                                                        phi_2620_ = _e2034;
                                                                        phi_2621_ = _e2064;
                                                                        phi_2622_ = _e2060;
                                                                    }
                                                                    let _e2073 = phi_2619_;
                                                                    let _e2075 = phi_2620_;
                                                                    let _e2077 = phi_2621_;
                                                                    let _e2079 = phi_2622_;
                                                                    let _e2082 = ((_e2079 * _e2073) - (_e2077 * _e2075));
                                                                    if _e2071 {
                                                                        phi_2630_ = -(_e2082);
                                                                    } else {
                                                                        phi_2630_ = _e2082;
                                                                    }
                                                                    let _e2085 = phi_2630_;
                                                                    if (_e2060 < _e2008) {
                                                                        phi_2641_ = true;
                                                                    } else {
                                                                        if (_e2060 == _e2008) {
                                                                            phi_2640_ = (_e2064 < _e2012);
                                                                        } else {
                                                                            phi_2640_ = false;
                                                                        }
                                                                        let _e2090 = phi_2640_;
                                                                        phi_2641_ = _e2090;
                                                                    }
                                                                    let _e2092 = phi_2641_;
                                                                    if _e2092 {
                                                                        phi_2645_ = _e2012;
                                                                        phi_2646_ = _e2008;
                                                                        phi_2647_ = _e2064;
                                                                        phi_2648_ = _e2060;
                                                                    } else {
                                                                        phi_2645_ = _e2064;
                                                                        phi_2646_ = _e2060;
                                                                        phi_2647_ = _e2012;
                                                                        phi_2648_ = _e2008;
                                                                    }
                                                                    let _e2094 = phi_2645_;
                                                                    let _e2096 = phi_2646_;
                                                                    let _e2098 = phi_2647_;
                                                                    let _e2100 = phi_2648_;
                                                                    let _e2103 = ((_e2100 * _e2094) - (_e2098 * _e2096));
                                                                    if _e2092 {
                                                                        phi_2656_ = -(_e2103);
                                                                    } else {
                                                                        phi_2656_ = _e2103;
                                                                    }
                                                                    let _e2106 = phi_2656_;
                                                                    if (_e2008 < _e2034) {
                                                                        phi_2667_ = true;
                                                                    } else {
                                                                        if (_e2008 == _e2034) {
                                                                            phi_2666_ = (_e2012 < _e2038);
                                                                        } else {
                                                                            phi_2666_ = false;
                                                                        }
                                                                        let _e2111 = phi_2666_;
                                                                        phi_2667_ = _e2111;
                                                                    }
                                                                    let _e2113 = phi_2667_;
                                                                    if _e2113 {
                                                                        phi_2671_ = _e2038;
                                                                        phi_2672_ = _e2034;
                                                                        phi_2673_ = _e2012;
                                                                        phi_2674_ = _e2008;
                                                                    } else {
                                                                        phi_2671_ = _e2012;
                                                                        phi_2672_ = _e2008;
                                                                        phi_2673_ = _e2038;
                                                                        phi_2674_ = _e2034;
                                                                    }
                                                                    let _e2115 = phi_2671_;
                                                                    let _e2117 = phi_2672_;
                                                                    let _e2119 = phi_2673_;
                                                                    let _e2121 = phi_2674_;
                                                                    let _e2124 = ((_e2121 * _e2115) - (_e2119 * _e2117));
                                                                    if _e2113 {
                                                                        phi_2682_ = -(_e2124);
                                                                    } else {
                                                                        phi_2682_ = _e2124;
                                                                    }
                                                                    let _e2127 = phi_2682_;
                                                                    if (_e2085 >= 0f) {
                                                                        if (_e2106 >= 0f) {
                                                                            if (_e2127 >= 0f) {
                                                                                phi_2697_ = ((_e2085 + _e2106) + _e2127);
                                                                                phi_2698_ = false;
                                                                            } else {
                                                                                phi_2697_ = f32();
                                                                                phi_2698_ = true;
                                                                            }
                                                                            let _e2134 = phi_2697_;
                                                                            let _e2136 = phi_2698_;
                                                                            phi_2699_ = _e2134;
                                                                            phi_2700_ = _e2136;
                                                                        } else {
                                                                            phi_2699_ = f32();
                                                                            phi_2700_ = true;
                                                                        }
                                                                        let _e2138 = phi_2699_;
                                                                        let _e2140 = phi_2700_;
                                                                        phi_2701_ = _e2138;
                                                                        phi_2702_ = _e2140;
                                                                    } else {
                                                                        phi_2701_ = f32();
                                                                        phi_2702_ = true;
                                                                    }
                                                                    let _e2142 = phi_2701_;
                                                                    let _e2144 = phi_2702_;
                                                                    if _e2144 {
                                                                        if (_e2085 <= 0f) {
                                                                            if (_e2106 <= 0f) {
                                                                                let _e2147 = (_e2127 <= 0f);
                                                                                if _e2147 {
                                                                                }
                                                                                phi_2720_ = ((_e2085 + _e2106) + _e2127);
                                                                                phi_2721_ = false;
                                                                                phi_2722_ = _e2147;
                                                                            } else {
                                                                                phi_2720_ = f32();
                                                                                phi_2721_ = true;
                                                                                phi_2722_ = false;
                                                                            }
                                                                            let _e2151 = phi_2720_;
                                                                            let _e2153 = phi_2721_;
                                                                            let _e2155 = phi_2722_;
                                                                            phi_2723_ = _e2151;
                                                                            phi_2724_ = _e2153;
                                                                            phi_2725_ = _e2155;
                                                                        } else {
                                                                            phi_2723_ = f32();
                                                                            phi_2724_ = true;
                                                                            phi_2725_ = false;
                                                                        }
                                                                        let _e2157 = phi_2723_;
                                                                        let _e2159 = phi_2724_;
                                                                        let _e2161 = phi_2725_;
                                                                        if _e2159 {
                                                                            phi_2729_ = false;
                                                                        } else {
                                                                            phi_2729_ = _e2161;
                                                                        }
                                                                        let _e2163 = phi_2729_;
                                                                        phi_2730_ = _e2157;
                                                                        phi_2731_ = _e2163;
                                                                    } else {
                                                                        phi_2730_ = _e2142;
                                                                        phi_2731_ = true;
                                                                    }
                                                                    let _e2165 = phi_2730_;
                                                                    let _e2167 = phi_2731_;
                                                                    if _e2167 {
                                                                        let _e2168 = (_e2165 == 0f);
                                                                        if _e2168 {
                                                                            phi_3047_ = lt_bvh_triangle_Intersection();
                                                                            phi_3048_ = false;
                                                                        } else {
                                                                            let _e2170 = triangles.member[(0u + _e1981)].v0_;
                                                                            let _e2172 = (_e2170.x - _e1084);
                                                                            let _e2174 = (_e2170.y - _e1097);
                                                                            let _e2176 = (_e2170.z - _e1110);
                                                                            if (_e1366 == 0u) {
                                                                                phi_2760_ = vec3<f32>(_e2174, _e2176, _e2172);
                                                                            } else {
                                                                                if (_e1366 == 1u) {
                                                                                    phi_2759_ = vec3<f32>(_e2176, _e2172, _e2174);
                                                                                } else {
                                                                                    phi_2759_ = (_e2170 - vec3<f32>(_e1084, _e1097, _e1110));
                                                                                }
                                                                                let _e2184 = phi_2759_;
                                                                                phi_2760_ = _e2184;
                                                                            }
                                                                            let _e2186 = phi_2760_;
                                                                            let _e2188 = triangles.member[(0u + _e1981)].v1_;
                                                                            let _e2190 = triangles.member[(0u + _e1981)].v0_;
                                                                            let _e2193 = (_e2188.x - _e2190.x);
                                                                            let _e2196 = (_e2188.y - _e2190.y);
                                                                            let _e2199 = (_e2188.z - _e2190.z);
                                                                            if (_e1366 == 0u) {
                                                                                phi_2786_ = vec3<f32>(_e2196, _e2199, _e2193);
                                                                            } else {
                                                                                if (_e1366 == 1u) {
                                                                                    phi_2785_ = vec3<f32>(_e2199, _e2193, _e2196);
                                                                                } else {
                                                                                    phi_2785_ = (_e2188 - _e2190);
                                                                                }
                                                                                let _e2206 = phi_2785_;
                                                                                phi_2786_ = _e2206;
                                                                            }
                                                                            let _e2208 = phi_2786_;
                                                                            let _e2210 = triangles.member[(0u + _e1981)].v2_;
                                                                            let _e2212 = triangles.member[(0u + _e1981)].v0_;
                                                                            let _e2215 = (_e2210.x - _e2212.x);
                                                                            let _e2218 = (_e2210.y - _e2212.y);
                                                                            let _e2221 = (_e2210.z - _e2212.z);
                                                                            if (_e1366 == 0u) {
                                                                                phi_2812_ = vec3<f32>(_e2218, _e2221, _e2215);
                                                                            } else {
                                                                                if (_e1366 == 1u) {
                                                                                    phi_2811_ = vec3<f32>(_e2221, _e2215, _e2218);
                                                                                } else {
                                                                                    phi_2811_ = (_e2210 - _e2212);
                                                                                }
                                                                                let _e2228 = phi_2811_;
                                                                                phi_2812_ = _e2228;
                                                                            }
                                                                            let _e2230 = phi_2812_;
                                                                            let _e2237 = ((_e2208.y * _e2230.z) - (_e2208.z * _e2230.y));
                                                                            let _e2244 = ((_e2208.z * _e2230.x) - (_e2208.x * _e2230.z));
                                                                            let _e2251 = ((_e2208.x * _e2230.y) - (_e2208.y * _e2230.x));
                                                                            let _e2265 = (((1f / _e1374.z) * (((_e2237 * _e2186.x) + (_e2244 * _e2186.y)) + (_e2251 * _e2186.z))) / (((_e2237 * _e1377) + (_e2244 * _e1380)) + _e2251));
                                                                            if (_e2265 > _e183.tmin) {
                                                                                if (_e2265 < _e183.tmax) {
                                                                                    let _e2269 = triangles.member[(0u + _e1981)].v0_;
                                                                                    let _e2271 = triangles.member[(0u + _e1981)].v1_;
                                                                                    if (_e2269.x < _e2271.x) {
                                                                                        phi_2868_ = _e2269.x;
                                                                                    } else {
                                                                                        phi_2868_ = _e2271.x;
                                                                                    }
                                                                                    let _e2278 = phi_2868_;
                                                                                    if (_e2269.y < _e2271.y) {
                                                                                        phi_2877_ = _e2269.y;
                                                                                    } else {
                                                                                        phi_2877_ = _e2271.y;
                                                                                    }
                                                                                    let _e2285 = phi_2877_;
                                                                                    if (_e2269.z < _e2271.z) {
                                                                                        phi_2886_ = _e2269.z;
                                                                                    } else {
                                                                                        phi_2886_ = _e2271.z;
                                                                                    }
                                                                                    let _e2292 = phi_2886_;
                                                                                    let _e2294 = triangles.member[(0u + _e1981)].v2_;
                                                                                    if (_e2278 < _e2294.x) {
                                                                                        phi_2895_ = _e2278;
                                                                                    } else {
                                                                                        phi_2895_ = _e2294.x;
                                                                                    }
                                                                                    let _e2299 = phi_2895_;
                                                                                    if (_e2285 < _e2294.y) {
                                                                                        phi_2902_ = _e2285;
                                                                                    } else {
                                                                                        phi_2902_ = _e2294.y;
                                                                                    }
                                                                                    let _e2304 = phi_2902_;
                                                                                    if (_e2292 < _e2294.z) {
                                                                                        phi_2909_ = _e2292;
                                                                                    } else {
                                                                                        phi_2909_ = _e2294.z;
                                                                                    }
                                                                                    let _e2309 = phi_2909_;
                                                                                    let _e2311 = triangles.member[(0u + _e1981)].v0_;
                                                                                    let _e2313 = triangles.member[(0u + _e1981)].v1_;
                                                                                    if (_e2311.x > _e2313.x) {
                                                                                        phi_2922_ = _e2311.x;
                                                                                    } else {
                                                                                        phi_2922_ = _e2313.x;
                                                                                    }
                                                                                    let _e2320 = phi_2922_;
                                                                                    if (_e2311.y > _e2313.y) {
                                                                                        phi_2931_ = _e2311.y;
                                                                                    } else {
                                                                                        phi_2931_ = _e2313.y;
                                                                                    }
                                                                                    let _e2327 = phi_2931_;
                                                                                    if (_e2311.z > _e2313.z) {
                                                                                        phi_2940_ = _e2311.z;
                                                                                    } else {
                                                                                        phi_2940_ = _e2313.z;
                                                                                    }
                                                                                    let _e2334 = phi_2940_;
                                                                                    let _e2336 = triangles.member[(0u + _e1981)].v2_;
                                                                                    if (_e2320 > _e2336.x) {
                                                                                        phi_2949_ = _e2320;
                                                                                    } else {
                                                                                        phi_2949_ = _e2336.x;
                                                                                    }
                                                                                    let _e2341 = phi_2949_;
                                                                                    if (_e2327 > _e2336.y) {
                                                                                        phi_2956_ = _e2327;
                                                                                    } else {
                                                                                        phi_2956_ = _e2336.y;
                                                                                    }
                                                                                    let _e2346 = phi_2956_;
                                                                                    if (_e2334 > _e2336.z) {
                                                                                        phi_2963_ = _e2334;
                                                                                    } else {
                                                                                        phi_2963_ = _e2336.z;
                                                                                    }
                                                                                    let _e2351 = phi_2963_;
                                                                                    let _e2355 = ((_e2299 - _e1084) * _e1291);
                                                                                    let _e2356 = ((_e2304 - _e1097) * _e1301);
                                                                                    let _e2357 = ((_e2309 - _e1110) * _e1311);
                                                                                    let _e2361 = ((_e2341 - _e1084) * _e1291);
                                                                                    let _e2362 = ((_e2346 - _e1097) * _e1301);
                                                                                    let _e2363 = ((_e2351 - _e1110) * _e1311);
                                                                                    if (_e2355 < _e2361) {
                                                                                        phi_2980_ = _e2355;
                                                                                    } else {
                                                                                        phi_2980_ = _e2361;
                                                                                    }
                                                                                    let _e2366 = phi_2980_;
                                                                                    if (_e2356 < _e2362) {
                                                                                        phi_2985_ = _e2356;
                                                                                    } else {
                                                                                        phi_2985_ = _e2362;
                                                                                    }
                                                                                    let _e2369 = phi_2985_;
                                                                                    if (_e2357 < _e2363) {
                                                                                        phi_2990_ = _e2357;
                                                                                    } else {
                                                                                        phi_2990_ = _e2363;
                                                                                    }
                                                                                    let _e2372 = phi_2990_;
                                                                                    if (_e2355 > _e2361) {
                                                                                        phi_2998_ = _e2355;
                                                                                    } else {
                                                                                        phi_2998_ = _e2361;
                                                                                    }
                                                                                    let _e2378 = phi_2998_;
                                                                                    if (_e2356 > _e2362) {
                                                                                        phi_3003_ = _e2356;
                                                                                    } else {
                                                                                        phi_3003_ = _e2362;
                                                                                    }
                                                                                    let _e2381 = phi_3003_;
                                                                                    if (_e2357 > _e2363) {
                                                                                        phi_3008_ = _e2357;
                                                                                    } else {
                                                                                        phi_3008_ = _e2363;
                                                                                    }
                                                                                    let _e2384 = phi_3008_;
                                                                                    let _e2388 = core_intrinsics_maximum_number_nsz_f32_((_e2366 - _e1350), (_e2369 - _e1351));
                                                                                    let _e2389 = core_intrinsics_maximum_number_nsz_f32_(_e2388, (_e2372 - _e1352));
                                                                                    let _e2390 = core_intrinsics_minimum_number_nsz_f32_((_e2378 + _e1350), (_e2381 + _e1351));
                                                                                    let _e2391 = core_intrinsics_minimum_number_nsz_f32_(_e2390, (_e2384 + _e1352));
                                                                                    if (_e2389 > _e1059) {
                                                                                        phi_3020_ = _e2389;
                                                                                    } else {
                                                                                        phi_3020_ = _e1059;
                                                                                    }
                                                                                    let _e2394 = phi_3020_;
                                                                                    if (_e2391 < _e1061) {
                                                                                        phi_3025_ = _e2391;
                                                                                    } else {
                                                                                        phi_3025_ = _e1061;
                                                                                    }
                                                                                    let _e2397 = phi_3025_;
                                                                                    if (_e2265 < _e2394) {
                                                                                        phi_3030_ = _e2394;
                                                                                    } else {
                                                                                        phi_3030_ = _e2265;
                                                                                    }
                                                                                    let _e2400 = phi_3030_;
                                                                                    if (_e2400 > _e2397) {
                                                                                        phi_3035_ = _e2397;
                                                                                    } else {
                                                                                        phi_3035_ = _e2400;
                                                                                    }
                                                                                    let _e2403 = phi_3035_;
                                                                                    phi_3040_ = lt_bvh_triangle_Intersection(_e2403, (_e2106 / _e2165), (_e2127 / _e2165), (_e2394 <= _e2397));
                                                                                    phi_3041_ = false;
                                                                                } else {
                                                                                    phi_3040_ = lt_bvh_triangle_Intersection();
                                                                                    phi_3041_ = true;
                                                                                }
                                                                                let _e2409 = phi_3040_;
                                                                                let _e2411 = phi_3041_;
                                                                                phi_3042_ = _e2409;
                                                                                phi_3043_ = _e2411;
                                                                            } else {
                                                                                phi_3042_ = lt_bvh_triangle_Intersection();
                                                                                phi_3043_ = true;
                                                                            }
                                                                            let _e2413 = phi_3042_;
                                                                            let _e2415 = phi_3043_;
                                                                            if _e2415 {
                                                                            }
                                                                            phi_3047_ = _e2413;
                                                                            phi_3048_ = _e2415;
                                                                        }
                                                                        let _e2417 = phi_3047_;
                                                                        let _e2419 = phi_3048_;
                                                                        phi_3049_ = _e2417;
                                                                        phi_3050_ = _e2168;
                                                                        phi_3051_ = _e2419;
                                                                    } else {
                                                                        phi_3049_ = lt_bvh_triangle_Intersection();
                                                                        phi_3050_ = true;
                                                                        phi_3051_ = false;
                                                                    }
                                                                    let _e2421 = phi_3049_;
                                                                    let _e2423 = phi_3050_;
                                                                    let _e2425 = phi_3051_;
                                                                    if _e2423 {
                                                                        phi_3055_ = true;
                                                                    } else {
                                                                        phi_3055_ = _e2425;
                                                                    }
                                                                    let _e2427 = phi_3055_;
                                                                    if _e2427 {
                                                                        phi_3059_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_3059_ = _e2421;
                                                                    }
                                                                    let _e2429 = phi_3059_;
                                                                    if _e2429.is_hit {
                                                                        if (_e2429.t > _e183.tmin) {
                                                                            if (_e2429.t < _e1970.t) {
                                                                                phi_3107_ = true;
                                                                            } else {
                                                                                if (_e2429.t == _e1970.t) {
                                                                                    if (_e1970.triangle != 4294967295u) {
                                                                                        if (_e1981 < _e1970.triangle) {
                                                                                            phi_3098_ = true;
                                                                                        } else {
                                                                                            if (_e1981 == _e1970.triangle) {
                                                                                                phi_3097_ = (_e1000 < _e1970.instance);
                                                                                            } else {
                                                                                                phi_3097_ = false;
                                                                                            }
                                                                                            let _e2447 = phi_3097_;
                                                                                            phi_3098_ = _e2447;
                                                                                        }
                                                                                        let _e2449 = phi_3098_;
                                                                                        phi_3099_ = _e2449;
                                                                                        phi_3100_ = false;
                                                                                    } else {
                                                                                        phi_3099_ = bool();
                                                                                        phi_3100_ = true;
                                                                                    }
                                                                                    let _e2451 = phi_3099_;
                                                                                    let _e2453 = phi_3100_;
                                                                                    phi_3101_ = _e2451;
                                                                                    phi_3102_ = _e2453;
                                                                                } else {
                                                                                    phi_3101_ = bool();
                                                                                    phi_3102_ = true;
                                                                                }
                                                                                let _e2455 = phi_3101_;
                                                                                let _e2457 = phi_3102_;
                                                                                if _e2457 {
                                                                                    phi_3106_ = false;
                                                                                } else {
                                                                                    phi_3106_ = _e2455;
                                                                                }
                                                                                let _e2459 = phi_3106_;
                                                                                phi_3107_ = _e2459;
                                                                            }
                                                                            let _e2461 = phi_3107_;
                                                                            if _e2461 {
                                                                                let _e2463 = triangles.member[(0u + _e1981)].i0_;
                                                                                if ((_e2463 & 2147483648u) == 0u) {
                                                                                    phi_3121_ = true;
                                                                                } else {
                                                                                    if true {
                                                                                    }
                                                                                    phi_3121_ = true;
                                                                                }
                                                                                let _e2467 = phi_3121_;
                                                                                if _e2467 {
                                                                                    phi_3129_ = lt_bvh_Hit(_e2429.t, _e2429.u, _e2429.v, _e1981, _e1000);
                                                                                } else {
                                                                                    phi_3129_ = _e1970;
                                                                                }
                                                                                let _e2473 = phi_3129_;
                                                                                phi_3130_ = _e2473;
                                                                            } else {
                                                                                phi_3130_ = _e1970;
                                                                            }
                                                                            let _e2475 = phi_3130_;
                                                                            phi_3131_ = _e2475;
                                                                        } else {
                                                                            phi_3131_ = _e1970;
                                                                        }
                                                                        let _e2477 = phi_3131_;
                                                                        phi_3132_ = _e2477;
                                                                    } else {
                                                                        phi_3132_ = _e1970;
                                                                    }
                                                                    let _e2479 = phi_3132_;
                                                                    phi_2489_ = _e2479;
                                                                    phi_2492_ = (_e1972 & (_e1972 - 1u));
                                                                    phi_3133_ = true;
                                                                }
                                                                let _e2481 = phi_2489_;
                                                                let _e2483 = phi_2492_;
                                                                let _e2485 = phi_3133_;
                                                                continue;
                                                                continuing {
                                                                    phi_2488_ = _e2481;
                                                                    phi_2491_ = _e2483;
                                                                    break if !(_e2485);
                                                                }
                                                            }
                                                            let _e2488 = local_1.group_mask;
                                                            if ((_e2488 & 4278190080u) == 0u) {
                                                                let _e2492 = local_1.len;
                                                                if (_e2492 == 0u) {
                                                                    phi_3172_ = false;
                                                                } else {
                                                                    let _e2496 = local_1.len;
                                                                    local_1.len = (_e2496 - 1u);
                                                                    let _e2499 = local_1.len;
                                                                    if (_e2499 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2504 = local_1.first[(0u + _e2499)];
                                                                    local_1.group = _e2504;
                                                                    let _e2507 = local_1.len;
                                                                    if (_e2507 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2512 = local_1.mask[(0u + _e2507)];
                                                                    local_1.group_mask = _e2512;
                                                                    phi_3172_ = true;
                                                                }
                                                                let _e2515 = phi_3172_;
                                                                phi_3173_ = _e2515;
                                                            } else {
                                                                phi_3173_ = true;
                                                            }
                                                            let _e2517 = phi_3173_;
                                                            if _e2517 {
                                                                let _e2519 = local_1.group_mask;
                                                                let _e2525 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2519)), 32u, (_e2519 == 0u)));
                                                                let _e2529 = local_1.group_mask;
                                                                let _e2543 = local_1.group_mask;
                                                                local_1.group_mask = (_e2543 & ~((1u << bitcast<u32>((_e2525 & 31u)))));
                                                                let _e2546 = local_1.group;
                                                                phi_3204_ = (_e2546 + countOneBits(((_e2529 & ~((4294967295u << bitcast<u32>((((_e2525 - 24u) ^ _e1393) & 31u))))) & 255u)));
                                                            } else {
                                                                phi_3204_ = 4294967295u;
                                                            }
                                                            let _e2549 = phi_3204_;
                                                            let _e3868 = local_9;
                                                            phi_2156_ = _e3868;
                                                            phi_2159_ = _e2549;
                                                        } else {
                                                            phi_2156_ = lt_bvh_Hit();
                                                            phi_2159_ = u32();
                                                        }
                                                        let _e2551 = phi_2156_;
                                                        let _e2553 = phi_2159_;
                                                        continue;
                                                        continuing {
                                                            phi_2155_ = _e2551;
                                                            phi_2158_ = _e2553;
                                                            break if !(_e1534);
                                                        }
                                                    }
                                                    let _e3872 = local_10;
                                                    phi_3205_ = _e3872;
                                                }
                                                let _e2556 = phi_3205_;
                                                phi_3206_ = _e2556;
                                                phi_3207_ = _e1215;
                                            } else {
                                                phi_3206_ = lt_bvh_Hit();
                                                phi_3207_ = true;
                                            }
                                            let _e2558 = phi_3206_;
                                            let _e2560 = phi_3207_;
                                            if _e2560 {
                                                phi_3211_ = _e992;
                                            } else {
                                                phi_3211_ = _e2558;
                                            }
                                            let _e2562 = phi_3211_;
                                            phi_3212_ = _e2562;
                                        } else {
                                            phi_3212_ = _e992;
                                        }
                                        let _e2564 = phi_3212_;
                                        phi_3213_ = _e2564;
                                    } else {
                                        phi_3213_ = _e992;
                                    }
                                    let _e2566 = phi_3213_;
                                    phi_3214_ = _e2566;
                                } else {
                                    phi_3214_ = _e992;
                                }
                                let _e2568 = phi_3214_;
                                phi_1523_ = (_e990 & (_e990 - 1u));
                                phi_1526_ = _e2568;
                                phi_3215_ = true;
                            }
                            let _e2570 = phi_1523_;
                            let _e2572 = phi_1526_;
                            let _e2574 = phi_3215_;
                            continue;
                            continuing {
                                phi_1522_ = _e2570;
                                phi_1525_ = _e2572;
                                break if !(_e2574);
                            }
                        }
                        let _e2577 = local_2.group_mask;
                        if ((_e2577 & 4278190080u) == 0u) {
                            let _e2581 = local_2.len;
                            if (_e2581 == 0u) {
                                phi_3254_ = false;
                            } else {
                                let _e2585 = local_2.len;
                                local_2.len = (_e2585 - 1u);
                                let _e2588 = local_2.len;
                                if (_e2588 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2593 = local_2.first[(0u + _e2588)];
                                local_2.group = _e2593;
                                let _e2596 = local_2.len;
                                if (_e2596 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2601 = local_2.mask[(0u + _e2596)];
                                local_2.group_mask = _e2601;
                                phi_3254_ = true;
                            }
                            let _e2604 = phi_3254_;
                            phi_3255_ = _e2604;
                        } else {
                            phi_3255_ = true;
                        }
                        let _e2606 = phi_3255_;
                        if _e2606 {
                            let _e2608 = local_2.group_mask;
                            let _e2614 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2608)), 32u, (_e2608 == 0u)));
                            let _e2618 = local_2.group_mask;
                            let _e2632 = local_2.group_mask;
                            local_2.group_mask = (_e2632 & ~((1u << bitcast<u32>((_e2614 & 31u)))));
                            let _e2635 = local_2.group;
                            phi_3286_ = (_e2635 + countOneBits(((_e2618 & ~((4294967295u << bitcast<u32>((((_e2614 - 24u) ^ _e409) & 31u))))) & 255u)));
                        } else {
                            phi_3286_ = 4294967295u;
                        }
                        let _e2638 = phi_3286_;
                        phi_1186_ = _e2638;
                        let _e3888 = local_11;
                        phi_1189_ = _e3888;
                    } else {
                        phi_1186_ = u32();
                        phi_1189_ = lt_bvh_Hit();
                    }
                    let _e2640 = phi_1186_;
                    let _e2642 = phi_1189_;
                    continue;
                    continuing {
                        phi_1185_ = _e2640;
                        phi_1188_ = _e2642;
                        break if !(_e550);
                    }
                }
                let _e3891 = local_12;
                phi_3287_ = _e3891;
            }
            let _e2645 = phi_3287_;
            phi_3288_ = _e2645;
            phi_3289_ = _e247;
        } else {
            phi_3288_ = lt_bvh_Hit();
            phi_3289_ = true;
        }
        let _e2647 = phi_3288_;
        let _e2649 = phi_3289_;
        if _e2649 {
            phi_3293_ = _e185;
        } else {
            phi_3293_ = _e2647;
        }
        let _e2651 = phi_3293_;
        if (_e2651.triangle != 4294967295u) {
            let _e2657 = ((1f - _e2651.u) - _e2651.v);
            if (_e2651.triangle < _e82) {
            } else {
                return;
            }
            let _e2662 = triangles.member[(0u + _e2651.triangle)];
            if (_e2651.instance < _e94) {
            } else {
                return;
            }
            let _e2673 = instances.member[(0u + _e2651.instance)].object_to_world[0u];
            let _e2684 = ((((_e2673.x * _e2662.v0_.x) + (_e2673.y * _e2662.v0_.y)) + (_e2673.z * _e2662.v0_.z)) + (_e2673.w * 1f));
            let _e2686 = instances.member[(0u + _e2651.instance)].object_to_world[1u];
            let _e2697 = ((((_e2686.x * _e2662.v0_.x) + (_e2686.y * _e2662.v0_.y)) + (_e2686.z * _e2662.v0_.z)) + (_e2686.w * 1f));
            let _e2699 = instances.member[(0u + _e2651.instance)].object_to_world[2u];
            let _e2710 = ((((_e2699.x * _e2662.v0_.x) + (_e2699.y * _e2662.v0_.y)) + (_e2699.z * _e2662.v0_.z)) + (_e2699.w * 1f));
            let _e2717 = instances.member[(0u + _e2651.instance)].object_to_world[0u];
            let _e2728 = ((((_e2717.x * _e2662.v1_.x) + (_e2717.y * _e2662.v1_.y)) + (_e2717.z * _e2662.v1_.z)) + (_e2717.w * 1f));
            let _e2730 = instances.member[(0u + _e2651.instance)].object_to_world[1u];
            let _e2741 = ((((_e2730.x * _e2662.v1_.x) + (_e2730.y * _e2662.v1_.y)) + (_e2730.z * _e2662.v1_.z)) + (_e2730.w * 1f));
            let _e2743 = instances.member[(0u + _e2651.instance)].object_to_world[2u];
            let _e2754 = ((((_e2743.x * _e2662.v1_.x) + (_e2743.y * _e2662.v1_.y)) + (_e2743.z * _e2662.v1_.z)) + (_e2743.w * 1f));
            let _e2761 = instances.member[(0u + _e2651.instance)].object_to_world[0u];
            let _e2772 = ((((_e2761.x * _e2662.v2_.x) + (_e2761.y * _e2662.v2_.y)) + (_e2761.z * _e2662.v2_.z)) + (_e2761.w * 1f));
            let _e2774 = instances.member[(0u + _e2651.instance)].object_to_world[1u];
            let _e2785 = ((((_e2774.x * _e2662.v2_.x) + (_e2774.y * _e2662.v2_.y)) + (_e2774.z * _e2662.v2_.z)) + (_e2774.w * 1f));
            let _e2787 = instances.member[(0u + _e2651.instance)].object_to_world[2u];
            let _e2798 = ((((_e2787.x * _e2662.v2_.x) + (_e2787.y * _e2662.v2_.y)) + (_e2787.z * _e2662.v2_.z)) + (_e2787.w * 1f));
            let _e2811 = (((_e2684 * _e2657) + (_e2728 * _e2651.u)) + (_e2772 * _e2651.v));
            let _e2812 = (((_e2697 * _e2657) + (_e2741 * _e2651.u)) + (_e2785 * _e2651.v));
            let _e2813 = (((_e2710 * _e2657) + (_e2754 * _e2651.u)) + (_e2798 * _e2651.v));
            let _e2815 = abs(_e2684);
            let _e2816 = abs(_e2697);
            let _e2817 = abs(_e2710);
            let _e2818 = abs(_e2728);
            let _e2819 = abs(_e2741);
            let _e2820 = abs(_e2754);
            if (_e2815 > _e2818) {
                phi_3480_ = _e2815;
            } else {
                phi_3480_ = _e2818;
            }
            let _e2823 = phi_3480_;
            if (_e2816 > _e2819) {
                phi_3485_ = _e2816;
            } else {
                phi_3485_ = _e2819;
            }
            let _e2826 = phi_3485_;
            if (_e2817 > _e2820) {
                phi_3490_ = _e2817;
            } else {
                phi_3490_ = _e2820;
            }
            let _e2829 = phi_3490_;
            let _e2830 = abs(_e2772);
            let _e2831 = abs(_e2785);
            let _e2832 = abs(_e2798);
            if (_e2823 > _e2830) {
                phi_3498_ = _e2823;
            } else {
                phi_3498_ = _e2830;
            }
            let _e2835 = phi_3498_;
            if (_e2826 > _e2831) {
                phi_3503_ = _e2826;
            } else {
                phi_3503_ = _e2831;
            }
            let _e2838 = phi_3503_;
            if (_e2829 > _e2832) {
                phi_3508_ = _e2829;
            } else {
                phi_3508_ = _e2832;
            }
            let _e2841 = phi_3508_;
            let _e2842 = (_e2728 - _e2684);
            let _e2843 = (_e2741 - _e2697);
            let _e2844 = (_e2754 - _e2710);
            let _e2845 = (_e2772 - _e2684);
            let _e2846 = (_e2785 - _e2697);
            let _e2847 = (_e2798 - _e2710);
            let _e2851 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2843), abs(_e2844));
            let _e2852 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2842), _e2851);
            let _e2853 = (_e2842 / _e2852);
            let _e2854 = (_e2843 / _e2852);
            let _e2855 = (_e2844 / _e2852);
            let _e2859 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2846), abs(_e2847));
            let _e2860 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2845), _e2859);
            let _e2861 = (_e2845 / _e2860);
            let _e2862 = (_e2846 / _e2860);
            let _e2863 = (_e2847 / _e2860);
            let _e2866 = ((_e2854 * _e2863) - (_e2862 * _e2855));
            let _e2869 = ((_e2855 * _e2861) - (_e2863 * _e2853));
            let _e2872 = ((_e2853 * _e2862) - (_e2861 * _e2854));
            let _e2874 = p.member.eye;
            let _e2887 = (1f / sqrt((((_e2866 * _e2866) + (_e2869 * _e2869)) + (_e2872 * _e2872))));
            let _e2888 = (_e2866 * _e2887);
            let _e2889 = (_e2869 * _e2887);
            let _e2890 = (_e2872 * _e2887);
            if ((((_e2888 * (_e2874.x - _e2811)) + (_e2889 * (_e2874.y - _e2812))) + (_e2890 * (_e2874.z - _e2813))) < 0f) {
                phi_3572_ = vec3<f32>(-(_e2888), -(_e2889), -(_e2890));
            } else {
                phi_3572_ = vec3<f32>(_e2888, _e2889, _e2890);
            }
            let _e2903 = phi_3572_;
            if (_e2651.triangle < _e82) {
            } else {
                return;
            }
            let _e2908 = triangles.member[(0u + _e2651.triangle)];
            let _e2910 = (_e2908.i0_ & 2147483647u);
            if (_e2910 < _e85) {
            } else {
                return;
            }
            let _e2916 = vertices.member[(0u + _e2910)];
            if (_e2908.i1_ < _e85) {
            } else {
                return;
            }
            let _e2920 = vertices.member[(0u + _e2908.i1_)];
            if (_e2908.i2_ < _e85) {
            } else {
                return;
            }
            let _e2924 = vertices.member[(0u + _e2908.i2_)];
            let _e2925 = array<abi_Vertex, 3>(_e2916, _e2920, _e2924);
            if (_e2925[0].material < arrayLength((&materials.member))) {
            } else {
                return;
            }
            let _e2931 = materials.member[(0u + _e2925[0].material)];
            let _e2948 = (1f / 255f);
            let _e2967 = (1f / 255f);
            let _e2989 = (1f / 255f);
            if (_e2931.color_size == 0u) {
                phi_3815_ = vec3<f32>(1f, 1f, 1f);
            } else {
                local.offset = _e2931.color_offset;
                local.size = _e2931.color_size;
                local.flags = _e2931.flags;
                let _e3032 = _lt_shaders_texture_TextureView_quad((&local), (((_e2925[0].u * _e2657) + (_e2925[1].u * _e2651.u)) + (_e2925[2].u * _e2651.v)), (((_e2925[0].v * _e2657) + (_e2925[1].v * _e2651.u)) + (_e2925[2].v * _e2651.v)));
                if (_e3032.indices[0] < _e97) {
                } else {
                    return;
                }
                let _e3038 = color_texels.member[(0u + _e3032.indices[0])];
                let _e3049 = (1f / 255f);
                if (_e3032.indices[1] < _e97) {
                } else {
                    return;
                }
                let _e3063 = color_texels.member[(0u + _e3032.indices[1])];
                let _e3074 = (1f / 255f);
                if (_e3032.indices[2] < _e97) {
                } else {
                    return;
                }
                let _e3091 = color_texels.member[(0u + _e3032.indices[2])];
                let _e3102 = (1f / 255f);
                if (_e3032.indices[3] < _e97) {
                } else {
                    return;
                }
                let _e3119 = color_texels.member[(0u + _e3032.indices[3])];
                let _e3130 = (1f / 255f);
                let _e3139 = (((((f32((_e3038 & 255u)) * _e3049) * _e3032.weights.x) + ((f32((_e3063 & 255u)) * _e3074) * _e3032.weights.y)) + ((f32((_e3091 & 255u)) * _e3102) * _e3032.weights.z)) + ((f32((_e3119 & 255u)) * _e3130) * _e3032.weights.w));
                let _e3140 = (((((f32(((_e3038 >> bitcast<u32>(8i)) & 255u)) * _e3049) * _e3032.weights.x) + ((f32(((_e3063 >> bitcast<u32>(8i)) & 255u)) * _e3074) * _e3032.weights.y)) + ((f32(((_e3091 >> bitcast<u32>(8i)) & 255u)) * _e3102) * _e3032.weights.z)) + ((f32(((_e3119 >> bitcast<u32>(8i)) & 255u)) * _e3130) * _e3032.weights.w));
                let _e3141 = (((((f32(((_e3038 >> bitcast<u32>(16i)) & 255u)) * _e3049) * _e3032.weights.x) + ((f32(((_e3063 >> bitcast<u32>(16i)) & 255u)) * _e3074) * _e3032.weights.y)) + ((f32(((_e3091 >> bitcast<u32>(16i)) & 255u)) * _e3102) * _e3032.weights.z)) + ((f32(((_e3119 >> bitcast<u32>(16i)) & 255u)) * _e3130) * _e3032.weights.w));
                phi_3815_ = vec3<f32>((_e3139 * _e3139), (_e3140 * _e3140), (_e3141 * _e3141));
            }
            let _e3147 = phi_3815_;
            let _e3149 = ((_e2931.base_color.x * ((((f32((_e2925[0].color & 255u)) * _e2948) * _e2657) + ((f32((_e2925[1].color & 255u)) * _e2967) * _e2651.u)) + ((f32((_e2925[2].color & 255u)) * _e2989) * _e2651.v))) * _e3147.x);
            let _e3151 = ((_e2931.base_color.y * ((((f32(((_e2925[0].color >> bitcast<u32>(8i)) & 255u)) * _e2948) * _e2657) + ((f32(((_e2925[1].color >> bitcast<u32>(8i)) & 255u)) * _e2967) * _e2651.u)) + ((f32(((_e2925[2].color >> bitcast<u32>(8i)) & 255u)) * _e2989) * _e2651.v))) * _e3147.y);
            let _e3153 = ((_e2931.base_color.z * ((((f32(((_e2925[0].color >> bitcast<u32>(16i)) & 255u)) * _e2948) * _e2657) + ((f32(((_e2925[1].color >> bitcast<u32>(16i)) & 255u)) * _e2967) * _e2651.u)) + ((f32(((_e2925[2].color >> bitcast<u32>(16i)) & 255u)) * _e2989) * _e2651.v))) * _e3147.z);
            let _e3154 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e2838, _e2841);
            let _e3155 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e2835, _e3154);
            if ((_e2931.flags & 2u) == 0u) {
                phi_3830_ = 0u;
            } else {
                phi_3830_ = 1u;
            }
            let _e3160 = phi_3830_;
            if (_e2925[0].normal == 2147516416u) {
                phi_4060_ = _e2903;
            } else {
                let _e3173 = (f32((bitcast<i32>((_e2925[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3179 = (f32((bitcast<i32>(_e2925[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3183 = ((1f - abs(_e3173)) - abs(_e3179));
                if (_e3183 < 0f) {
                    phi_3857_ = -(_e3183);
                } else {
                    phi_3857_ = 0f;
                }
                let _e3187 = phi_3857_;
                if (_e3173 < 0f) {
                    phi_3864_ = (_e3173 + _e3187);
                } else {
                    phi_3864_ = (_e3173 - _e3187);
                }
                let _e3192 = phi_3864_;
                if (_e3179 < 0f) {
                    phi_3871_ = (_e3179 + _e3187);
                } else {
                    phi_3871_ = (_e3179 - _e3187);
                }
                let _e3197 = phi_3871_;
                let _e3204 = (1f / sqrt((((_e3192 * _e3192) + (_e3197 * _e3197)) + (_e3183 * _e3183))));
                let _e3220 = (f32((bitcast<i32>((_e2925[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3226 = (f32((bitcast<i32>(_e2925[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3230 = ((1f - abs(_e3220)) - abs(_e3226));
                if (_e3230 < 0f) {
                    phi_3906_ = -(_e3230);
                } else {
                    phi_3906_ = 0f;
                }
                let _e3234 = phi_3906_;
                if (_e3220 < 0f) {
                    phi_3913_ = (_e3220 + _e3234);
                } else {
                    phi_3913_ = (_e3220 - _e3234);
                }
                let _e3239 = phi_3913_;
                if (_e3226 < 0f) {
                    phi_3920_ = (_e3226 + _e3234);
                } else {
                    phi_3920_ = (_e3226 - _e3234);
                }
                let _e3244 = phi_3920_;
                let _e3251 = (1f / sqrt((((_e3239 * _e3239) + (_e3244 * _e3244)) + (_e3230 * _e3230))));
                let _e3270 = (f32((bitcast<i32>((_e2925[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3276 = (f32((bitcast<i32>(_e2925[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3280 = ((1f - abs(_e3270)) - abs(_e3276));
                if (_e3280 < 0f) {
                    phi_3958_ = -(_e3280);
                } else {
                    phi_3958_ = 0f;
                }
                let _e3284 = phi_3958_;
                if (_e3270 < 0f) {
                    phi_3965_ = (_e3270 + _e3284);
                } else {
                    phi_3965_ = (_e3270 - _e3284);
                }
                let _e3289 = phi_3965_;
                if (_e3276 < 0f) {
                    phi_3972_ = (_e3276 + _e3284);
                } else {
                    phi_3972_ = (_e3276 - _e3284);
                }
                let _e3294 = phi_3972_;
                let _e3301 = (1f / sqrt((((_e3289 * _e3289) + (_e3294 * _e3294)) + (_e3280 * _e3280))));
                let _e3308 = ((((_e3192 * _e3204) * _e2657) + ((_e3239 * _e3251) * _e2651.u)) + ((_e3289 * _e3301) * _e2651.v));
                let _e3309 = ((((_e3197 * _e3204) * _e2657) + ((_e3244 * _e3251) * _e2651.u)) + ((_e3294 * _e3301) * _e2651.v));
                let _e3310 = ((((_e3183 * _e3204) * _e2657) + ((_e3230 * _e3251) * _e2651.u)) + ((_e3280 * _e3301) * _e2651.v));
                if (_e2651.instance < _e94) {
                } else {
                    return;
                }
                let _e3317 = instances.member[(0u + _e2651.instance)].world_to_object[0u];
                let _e3326 = instances.member[(0u + _e2651.instance)].world_to_object[1u];
                let _e3338 = instances.member[(0u + _e2651.instance)].world_to_object[2u];
                let _e3345 = (((_e3317.x * _e3308) + (_e3326.x * _e3309)) + (_e3338.x * _e3310));
                let _e3346 = (((_e3317.y * _e3308) + (_e3326.y * _e3309)) + (_e3338.y * _e3310));
                let _e3347 = (((_e3317.z * _e3308) + (_e3326.z * _e3309)) + (_e3338.z * _e3310));
                let _e3353 = sqrt((((_e3345 * _e3345) + (_e3346 * _e3346)) + (_e3347 * _e3347)));
                if (_e3353 > 0f) {
                    let _e3355 = (_e3345 / _e3353);
                    let _e3356 = (_e3346 / _e3353);
                    let _e3357 = (_e3347 / _e3353);
                    if ((((_e3355 * _e2903.x) + (_e3356 * _e2903.y)) + (_e3357 * _e2903.z)) < 0f) {
                        phi_4058_ = vec3<f32>(-(_e3355), -(_e3356), -(_e3357));
                    } else {
                        phi_4058_ = vec3<f32>(_e3355, _e3356, _e3357);
                    }
                    let _e3373 = phi_4058_;
                    phi_4059_ = _e3373;
                } else {
                    phi_4059_ = _e2903;
                }
                let _e3375 = phi_4059_;
                phi_4060_ = _e3375;
            }
            let _e3377 = phi_4060_;
            if (_e3149 > 0f) {
                if (_e3149 < 1f) {
                    phi_4069_ = _e3149;
                } else {
                    phi_4069_ = 1f;
                }
                let _e3381 = phi_4069_;
                phi_4070_ = _e3381;
            } else {
                phi_4070_ = 0f;
            }
            let _e3383 = phi_4070_;
            if (_e3151 > 0f) {
                if (_e3151 < 1f) {
                    phi_4080_ = _e3151;
                } else {
                    phi_4080_ = 1f;
                }
                let _e3388 = phi_4080_;
                phi_4081_ = _e3388;
            } else {
                phi_4081_ = 0f;
            }
            let _e3390 = phi_4081_;
            if (_e3153 > 0f) {
                if (_e3153 < 1f) {
                    phi_4091_ = _e3153;
                } else {
                    phi_4091_ = 1f;
                }
                let _e3395 = phi_4091_;
                phi_4092_ = _e3395;
            } else {
                phi_4092_ = 0f;
            }
            let _e3397 = phi_4092_;
            let _e3400 = ((sqrt(_e3383) * 255f) + 0.5f);
            let _e3409 = ((sqrt(_e3390) * 255f) + 0.5f);
            let _e3421 = ((sqrt(_e3397) * 255f) + 0.5f);
            phi_4127_ = abi_Sample(vec3<f32>(_e2811, _e2812, _e2813), _e3155, _e2903, _e3160, _e3377, ((select(select(u32(_e3400), 0u, (_e3400 < bitcast<f32>(0u))), 4294967295u, (_e3400 > bitcast<f32>(1333788671u))) | (select(select(u32(_e3409), 0u, (_e3409 < bitcast<f32>(0u))), 4294967295u, (_e3409 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e3421), 0u, (_e3421 < bitcast<f32>(0u))), 4294967295u, (_e3421 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_4127_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e3435 = phi_4127_;
        if (_e109.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e109.first_primitive)] = _e3435;
        if (_e2651.triangle != 4294967295u) {
            let _e3444 = ((1f - _e2651.u) - _e2651.v);
            if (_e2651.triangle < _e82) {
            } else {
                return;
            }
            let _e3449 = triangles.member[(0u + _e2651.triangle)];
            let _e3451 = (_e3449.i0_ & 2147483647u);
            if (_e3451 < _e100) {
            } else {
                return;
            }
            let _e3457 = before.member[(0u + _e3451)];
            if (_e3449.i1_ < _e100) {
            } else {
                return;
            }
            let _e3461 = before.member[(0u + _e3449.i1_)];
            if (_e3449.i2_ < _e100) {
            } else {
                return;
            }
            let _e3465 = before.member[(0u + _e3449.i2_)];
            if (_e2651.instance < _e94) {
            } else {
                return;
            }
            let _e3475 = instances.member[(0u + _e2651.instance)].object_to_world[0u];
            let _e3488 = instances.member[(0u + _e2651.instance)].object_to_world[1u];
            let _e3501 = instances.member[(0u + _e2651.instance)].object_to_world[2u];
            if (_e2651.instance < _e94) {
            } else {
                return;
            }
            let _e3525 = instances.member[(0u + _e2651.instance)].object_to_world[0u];
            let _e3538 = instances.member[(0u + _e2651.instance)].object_to_world[1u];
            let _e3551 = instances.member[(0u + _e2651.instance)].object_to_world[2u];
            if (_e2651.instance < _e94) {
            } else {
                return;
            }
            let _e3578 = instances.member[(0u + _e2651.instance)].object_to_world[0u];
            let _e3591 = instances.member[(0u + _e2651.instance)].object_to_world[1u];
            let _e3604 = instances.member[(0u + _e2651.instance)].object_to_world[2u];
            phi_4350_ = vec3<f32>((((((((_e3475.x * _e3457.x) + (_e3475.y * _e3457.y)) + (_e3475.z * _e3457.z)) + (_e3475.w * 1f)) * _e3444) + (((((_e3525.x * _e3461.x) + (_e3525.y * _e3461.y)) + (_e3525.z * _e3461.z)) + (_e3525.w * 1f)) * _e2651.u)) + (((((_e3578.x * _e3465.x) + (_e3578.y * _e3465.y)) + (_e3578.z * _e3465.z)) + (_e3578.w * 1f)) * _e2651.v)), (((((((_e3488.x * _e3457.x) + (_e3488.y * _e3457.y)) + (_e3488.z * _e3457.z)) + (_e3488.w * 1f)) * _e3444) + (((((_e3538.x * _e3461.x) + (_e3538.y * _e3461.y)) + (_e3538.z * _e3461.z)) + (_e3538.w * 1f)) * _e2651.u)) + (((((_e3591.x * _e3465.x) + (_e3591.y * _e3465.y)) + (_e3591.z * _e3465.z)) + (_e3591.w * 1f)) * _e2651.v)), (((((((_e3501.x * _e3457.x) + (_e3501.y * _e3457.y)) + (_e3501.z * _e3457.z)) + (_e3501.w * 1f)) * _e3444) + (((((_e3551.x * _e3461.x) + (_e3551.y * _e3461.y)) + (_e3551.z * _e3461.z)) + (_e3551.w * 1f)) * _e2651.u)) + (((((_e3604.x * _e3465.x) + (_e3604.y * _e3465.y)) + (_e3604.z * _e3465.z)) + (_e3604.w * 1f)) * _e2651.v)));
        } else {
            phi_4350_ = vec3<f32>(0f, 0f, 0f);
        }
        let _e3624 = phi_4350_;
        if (_e109.first_primitive < arrayLength((&past.member))) {
        } else {
            return;
        }
        past.member[(0u + _e109.first_primitive)] = vec4<f32>(_e3624.x, _e3624.y, _e3624.z, 1f);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_instanced_color_motion_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
