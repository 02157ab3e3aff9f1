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
var<storage> color_texels: type_13;
@group(0) @binding(9) 
var<storage> before: type_26;
@group(0) @binding(10) 
var<storage, read_write> past: type_26;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_mask_LightPlace {
    var phi_228_: lt_mask_LightPlace;
    var phi_229_: bool;
    var phi_230_: lt_mask_LightPlace;
    var phi_231_: bool;
    var phi_236_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_228_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_229_ = false;
        } else {
            phi_228_ = lt_mask_LightPlace();
            phi_229_ = true;
        }
        let _e85 = phi_228_;
        let _e87 = phi_229_;
        phi_230_ = _e85;
        phi_231_ = _e87;
    } else {
        phi_230_ = lt_mask_LightPlace();
        phi_231_ = true;
    }
    let _e89 = phi_230_;
    let _e91 = phi_231_;
    if _e91 {
        phi_236_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_236_ = _e89;
    }
    let _e96 = phi_236_;
    return lt_mask_LightPlace(_e96.word, _e96.shift);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_251_: bool;
    var phi_255_: f32;

    if (param_3 != param_3) {
        phi_251_ = true;
    } else {
        let _e75 = (param_4 >= param_3);
        if _e75 {
        }
        phi_251_ = _e75;
    }
    let _e77 = phi_251_;
    if _e77 {
        phi_255_ = param_4;
    } else {
        phi_255_ = param_3;
    }
    let _e79 = phi_255_;
    return _e79;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_267_: bool;
    var phi_271_: f32;

    if (param_5 != param_5) {
        phi_267_ = true;
    } else {
        let _e75 = (param_6 <= param_5);
        if _e75 {
        }
        phi_267_ = _e75;
    }
    let _e77 = phi_267_;
    if _e77 {
        phi_271_ = param_6;
    } else {
        phi_271_ = param_5;
    }
    let _e79 = phi_271_;
    return _e79;
}

fn _lt_shaders_texture_TextureView_quad(param_7: ptr<function, texture_TextureView>, param_8: f32, param_9: f32) -> texture_TexelQuad {
    var phi_313_: f32;
    var phi_318_: f32;
    var phi_319_: bool;
    var phi_320_: f32;
    var phi_321_: bool;
    var phi_325_: f32;
    var phi_351_: f32;
    var phi_356_: f32;
    var phi_357_: bool;
    var phi_358_: f32;
    var phi_359_: bool;
    var phi_363_: f32;
    var phi_371_: f32;
    var phi_372_: f32;
    var phi_373_: f32;
    var phi_382_: f32;
    var phi_383_: f32;
    var phi_401_: u32;
    var phi_415_: u32;
    var phi_422_: u32;
    var phi_427_: u32;
    var phi_433_: u32;
    var phi_438_: u32;
    var phi_440_: texture_Axis;
    var phi_468_: f32;
    var phi_473_: f32;
    var phi_474_: bool;
    var phi_475_: f32;
    var phi_476_: bool;
    var phi_480_: f32;
    var phi_506_: f32;
    var phi_511_: f32;
    var phi_512_: bool;
    var phi_513_: f32;
    var phi_514_: bool;
    var phi_518_: f32;
    var phi_526_: f32;
    var phi_527_: f32;
    var phi_528_: f32;
    var phi_537_: f32;
    var phi_538_: f32;
    var phi_556_: u32;
    var phi_570_: u32;
    var phi_577_: u32;
    var phi_582_: u32;
    var phi_588_: u32;
    var phi_593_: u32;
    var phi_595_: texture_Axis;

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
                phi_313_ = 1f;
            } else {
                phi_313_ = 0f;
            }
            let _e106 = phi_313_;
            if (param_8 < 8388608f) {
                phi_318_ = (_e103 - _e106);
                phi_319_ = false;
            } else {
                phi_318_ = f32();
                phi_319_ = true;
            }
            let _e109 = phi_318_;
            let _e111 = phi_319_;
            phi_320_ = _e109;
            phi_321_ = _e111;
        } else {
            phi_320_ = f32();
            phi_321_ = true;
        }
        let _e113 = phi_320_;
        let _e115 = phi_321_;
        if _e115 {
            phi_325_ = param_8;
        } else {
            phi_325_ = _e113;
        }
        let _e117 = phi_325_;
        phi_373_ = (param_8 - _e117);
    } else {
        if (_e90 == 1u) {
            let _e120 = (param_8 * 0.5f);
            if (_e120 > -8388608f) {
                let _e132 = f32(select(0i, select(select(i32(_e120), i32(-2147483648), (_e120 < bitcast<f32>(3472883712u))), 2147483647i, (_e120 > bitcast<f32>(1325400063u))), (_e120 == _e120)));
                if (_e132 > _e120) {
                    phi_351_ = 1f;
                } else {
                    phi_351_ = 0f;
                }
                let _e135 = phi_351_;
                if (_e120 < 8388608f) {
                    phi_356_ = (_e132 - _e135);
                    phi_357_ = false;
                } else {
                    phi_356_ = f32();
                    phi_357_ = true;
                }
                let _e138 = phi_356_;
                let _e140 = phi_357_;
                phi_358_ = _e138;
                phi_359_ = _e140;
            } else {
                phi_358_ = f32();
                phi_359_ = true;
            }
            let _e142 = phi_358_;
            let _e144 = phi_359_;
            if _e144 {
                phi_363_ = _e120;
            } else {
                phi_363_ = _e142;
            }
            let _e146 = phi_363_;
            let _e148 = (param_8 - (2f * _e146));
            if (_e148 > 1f) {
                phi_371_ = (2f - _e148);
            } else {
                phi_371_ = _e148;
            }
            let _e152 = phi_371_;
            phi_372_ = _e152;
        } else {
            phi_372_ = param_8;
        }
        let _e154 = phi_372_;
        phi_373_ = _e154;
    }
    let _e156 = phi_373_;
    if (_e156 > 0f) {
        if (_e156 < 1f) {
            phi_382_ = _e156;
        } else {
            phi_382_ = 1f;
        }
        let _e160 = phi_382_;
        phi_383_ = _e160;
    } else {
        phi_383_ = 0f;
    }
    let _e162 = phi_383_;
    let _e163 = (_e77 - 1u);
    let _e165 = (_e162 * f32(_e77));
    if _e85 {
        let _e172 = select(select(u32(_e165), 0u, (_e165 < bitcast<f32>(0u))), 4294967295u, (_e165 > bitcast<f32>(1333788671u)));
        if (_e163 < _e172) {
            phi_401_ = _e163;
        } else {
            phi_401_ = _e172;
        }
        let _e175 = phi_401_;
        phi_440_ = texture_Axis(_e175, _e175, 0f);
    } else {
        let _e177 = (_e165 + 0.5f);
        let _e184 = select(select(u32(_e177), 0u, (_e177 < bitcast<f32>(0u))), 4294967295u, (_e177 > bitcast<f32>(1333788671u)));
        if (_e77 < _e184) {
            phi_415_ = _e77;
        } else {
            phi_415_ = _e184;
        }
        let _e187 = phi_415_;
        if (_e90 == 0u) {
            phi_422_ = _e163;
        } else {
            phi_422_ = 0u;
        }
        let _e192 = phi_422_;
        if (_e90 == 0u) {
            phi_427_ = 0u;
        } else {
            phi_427_ = _e163;
        }
        let _e195 = phi_427_;
        if (_e187 == 0u) {
            phi_433_ = _e192;
        } else {
            phi_433_ = (_e187 - 1u);
        }
        let _e199 = phi_433_;
        if (_e187 > _e163) {
            phi_438_ = _e195;
        } else {
            phi_438_ = _e187;
        }
        let _e202 = phi_438_;
        phi_440_ = texture_Axis(_e199, _e202, (_e177 - f32(_e187)));
    }
    let _e205 = phi_440_;
    let _e207 = (*param_7).flags;
    let _e210 = ((_e207 >> bitcast<u32>(6u)) & 3u);
    if (_e210 == 0u) {
        if (param_9 > -8388608f) {
            let _e223 = f32(select(0i, select(select(i32(param_9), i32(-2147483648), (param_9 < bitcast<f32>(3472883712u))), 2147483647i, (param_9 > bitcast<f32>(1325400063u))), (param_9 == param_9)));
            if (_e223 > param_9) {
                phi_468_ = 1f;
            } else {
                phi_468_ = 0f;
            }
            let _e226 = phi_468_;
            if (param_9 < 8388608f) {
                phi_473_ = (_e223 - _e226);
                phi_474_ = false;
            } else {
                phi_473_ = f32();
                phi_474_ = true;
            }
            let _e229 = phi_473_;
            let _e231 = phi_474_;
            phi_475_ = _e229;
            phi_476_ = _e231;
        } else {
            phi_475_ = f32();
            phi_476_ = true;
        }
        let _e233 = phi_475_;
        let _e235 = phi_476_;
        if _e235 {
            phi_480_ = param_9;
        } else {
            phi_480_ = _e233;
        }
        let _e237 = phi_480_;
        phi_528_ = (param_9 - _e237);
    } else {
        if (_e210 == 1u) {
            let _e240 = (param_9 * 0.5f);
            if (_e240 > -8388608f) {
                let _e252 = f32(select(0i, select(select(i32(_e240), i32(-2147483648), (_e240 < bitcast<f32>(3472883712u))), 2147483647i, (_e240 > bitcast<f32>(1325400063u))), (_e240 == _e240)));
                if (_e252 > _e240) {
                    phi_506_ = 1f;
                } else {
                    phi_506_ = 0f;
                }
                let _e255 = phi_506_;
                if (_e240 < 8388608f) {
                    phi_511_ = (_e252 - _e255);
                    phi_512_ = false;
                } else {
                    phi_511_ = f32();
                    phi_512_ = true;
                }
                let _e258 = phi_511_;
                let _e260 = phi_512_;
                phi_513_ = _e258;
                phi_514_ = _e260;
            } else {
                phi_513_ = f32();
                phi_514_ = true;
            }
            let _e262 = phi_513_;
            let _e264 = phi_514_;
            if _e264 {
                phi_518_ = _e240;
            } else {
                phi_518_ = _e262;
            }
            let _e266 = phi_518_;
            let _e268 = (param_9 - (2f * _e266));
            if (_e268 > 1f) {
                phi_526_ = (2f - _e268);
            } else {
                phi_526_ = _e268;
            }
            let _e272 = phi_526_;
            phi_527_ = _e272;
        } else {
            phi_527_ = param_9;
        }
        let _e274 = phi_527_;
        phi_528_ = _e274;
    }
    let _e276 = phi_528_;
    if (_e276 > 0f) {
        if (_e276 < 1f) {
            phi_537_ = _e276;
        } else {
            phi_537_ = 1f;
        }
        let _e280 = phi_537_;
        phi_538_ = _e280;
    } else {
        phi_538_ = 0f;
    }
    let _e282 = phi_538_;
    let _e283 = (_e81 - 1u);
    let _e285 = (_e282 * f32(_e81));
    if _e85 {
        let _e292 = select(select(u32(_e285), 0u, (_e285 < bitcast<f32>(0u))), 4294967295u, (_e285 > bitcast<f32>(1333788671u)));
        if (_e283 < _e292) {
            phi_556_ = _e283;
        } else {
            phi_556_ = _e292;
        }
        let _e295 = phi_556_;
        phi_595_ = texture_Axis(_e295, _e295, 0f);
    } else {
        let _e297 = (_e285 + 0.5f);
        let _e304 = select(select(u32(_e297), 0u, (_e297 < bitcast<f32>(0u))), 4294967295u, (_e297 > bitcast<f32>(1333788671u)));
        if (_e81 < _e304) {
            phi_570_ = _e81;
        } else {
            phi_570_ = _e304;
        }
        let _e307 = phi_570_;
        if (_e210 == 0u) {
            phi_577_ = _e283;
        } else {
            phi_577_ = 0u;
        }
        let _e312 = phi_577_;
        if (_e210 == 0u) {
            phi_582_ = 0u;
        } else {
            phi_582_ = _e283;
        }
        let _e315 = phi_582_;
        if (_e307 == 0u) {
            phi_588_ = _e312;
        } else {
            phi_588_ = (_e307 - 1u);
        }
        let _e319 = phi_588_;
        if (_e307 > _e283) {
            phi_593_ = _e315;
        } else {
            phi_593_ = _e307;
        }
        let _e322 = phi_593_;
        phi_595_ = texture_Axis(_e319, _e322, (_e297 - f32(_e307)));
    }
    let _e325 = phi_595_;
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
    var phi_654_: f32;

    if (param_12 > param_13) {
        phi_654_ = param_12;
    } else {
        phi_654_ = param_13;
    }
    let _e76 = phi_654_;
    return _e76;
}

fn function_() {
    var local: texture_TextureView;
    var local_1: texture_TextureView;
    var local_2: lt_bvh_traverse_Stack;
    var local_3: lt_bvh_traverse_Stack;
    var phi_819_: bool;
    var phi_820_: bool;
    var phi_821_: bool;
    var phi_825_: bool;
    var phi_826_: bool;
    var phi_827_: bool;
    var phi_828_: bool;
    var phi_829_: bool;
    var phi_830_: bool;
    var phi_831_: bool;
    var phi_832_: bool;
    var phi_833_: bool;
    var phi_834_: bool;
    var phi_835_: bool;
    var phi_836_: bool;
    var phi_837_: bool;
    var phi_838_: bool;
    var phi_839_: bool;
    var phi_840_: bool;
    var phi_841_: bool;
    var phi_842_: bool;
    var phi_846_: bool;
    var phi_850_: bool;
    var phi_925_: f32;
    var phi_932_: f32;
    var phi_940_: f32;
    var phi_947_: f32;
    var phi_955_: f32;
    var phi_962_: f32;
    var phi_987_: f32;
    var phi_992_: f32;
    var phi_997_: f32;
    var phi_1019_: u32;
    var phi_1024_: u32;
    var phi_1029_: u32;
    var phi_1143_: bool;
    var phi_1144_: bool;
    var phi_1175_: u32;
    var phi_1177_: u32;
    var phi_1180_: lt_bvh_Hit;
    var phi_1265_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1292_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1319_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1325_: u32;
    var phi_1328_: u32;
    var phi_1342_: u32;
    var phi_1352_: u32;
    var phi_1362_: u32;
    var phi_1380_: u32;
    var phi_1390_: u32;
    var phi_1400_: u32;
    var phi_1436_: u32;
    var phi_1449_: u32;
    var phi_1454_: u32;
    var phi_1455_: u32;
    var phi_1456_: u32;
    var phi_1326_: u32;
    var phi_1329_: u32;
    var local_4: u32;
    var local_5: u32;
    var local_6: u32;
    var phi_1514_: u32;
    var phi_1517_: lt_bvh_Hit;
    var phi_1572_: f32;
    var phi_1577_: f32;
    var phi_1582_: f32;
    var phi_1590_: f32;
    var phi_1595_: f32;
    var phi_1600_: f32;
    var phi_1756_: bool;
    var phi_1757_: bool;
    var phi_1758_: bool;
    var phi_1762_: bool;
    var phi_1763_: bool;
    var phi_1764_: bool;
    var phi_1765_: bool;
    var phi_1766_: bool;
    var phi_1767_: bool;
    var phi_1768_: bool;
    var phi_1769_: bool;
    var phi_1770_: bool;
    var phi_1771_: bool;
    var phi_1772_: bool;
    var phi_1773_: bool;
    var phi_1774_: bool;
    var phi_1775_: bool;
    var phi_1776_: bool;
    var phi_1777_: bool;
    var phi_1778_: bool;
    var phi_1779_: bool;
    var phi_1783_: bool;
    var phi_1787_: bool;
    var phi_1857_: f32;
    var phi_1864_: f32;
    var phi_1871_: f32;
    var phi_1878_: f32;
    var phi_1885_: f32;
    var phi_1892_: f32;
    var phi_1909_: f32;
    var phi_1914_: f32;
    var phi_1919_: f32;
    var phi_1947_: bool;
    var phi_1948_: bool;
    var phi_1956_: u32;
    var phi_1957_: u32;
    var phi_1968_: vec3<f32>;
    var phi_1969_: vec3<f32>;
    var phi_1982_: u32;
    var phi_1987_: u32;
    var phi_1992_: u32;
    var phi_2106_: bool;
    var phi_2107_: bool;
    var phi_2138_: u32;
    var phi_2140_: lt_bvh_Hit;
    var phi_2143_: u32;
    var phi_2224_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2251_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2278_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2284_: u32;
    var phi_2287_: u32;
    var phi_2301_: u32;
    var phi_2311_: u32;
    var phi_2321_: u32;
    var phi_2339_: u32;
    var phi_2349_: u32;
    var phi_2359_: u32;
    var phi_2395_: u32;
    var phi_2408_: u32;
    var phi_2413_: u32;
    var phi_2414_: u32;
    var phi_2415_: u32;
    var phi_2285_: u32;
    var phi_2288_: u32;
    var local_7: u32;
    var local_8: u32;
    var local_9: u32;
    var phi_2473_: lt_bvh_Hit;
    var phi_2476_: u32;
    var phi_2520_: vec3<f32>;
    var phi_2521_: vec3<f32>;
    var phi_2550_: vec3<f32>;
    var phi_2551_: vec3<f32>;
    var phi_2580_: vec3<f32>;
    var phi_2581_: vec3<f32>;
    var phi_2599_: bool;
    var phi_2600_: bool;
    var phi_2604_: f32;
    var phi_2605_: f32;
    var phi_2606_: f32;
    var phi_2607_: f32;
    var phi_2615_: f32;
    var phi_2625_: bool;
    var phi_2626_: bool;
    var phi_2630_: f32;
    var phi_2631_: f32;
    var phi_2632_: f32;
    var phi_2633_: f32;
    var phi_2641_: f32;
    var phi_2651_: bool;
    var phi_2652_: bool;
    var phi_2656_: f32;
    var phi_2657_: f32;
    var phi_2658_: f32;
    var phi_2659_: f32;
    var phi_2667_: f32;
    var phi_2682_: f32;
    var phi_2683_: bool;
    var phi_2684_: f32;
    var phi_2685_: bool;
    var phi_2686_: f32;
    var phi_2687_: bool;
    var phi_2705_: f32;
    var phi_2706_: bool;
    var phi_2707_: bool;
    var phi_2708_: f32;
    var phi_2709_: bool;
    var phi_2710_: bool;
    var phi_2714_: bool;
    var phi_2715_: f32;
    var phi_2716_: bool;
    var phi_2744_: vec3<f32>;
    var phi_2745_: vec3<f32>;
    var phi_2770_: vec3<f32>;
    var phi_2771_: vec3<f32>;
    var phi_2796_: vec3<f32>;
    var phi_2797_: vec3<f32>;
    var phi_2853_: f32;
    var phi_2862_: f32;
    var phi_2871_: f32;
    var phi_2880_: f32;
    var phi_2887_: f32;
    var phi_2894_: f32;
    var phi_2907_: f32;
    var phi_2916_: f32;
    var phi_2925_: f32;
    var phi_2934_: f32;
    var phi_2941_: f32;
    var phi_2948_: f32;
    var phi_2965_: f32;
    var phi_2970_: f32;
    var phi_2975_: f32;
    var phi_2983_: f32;
    var phi_2988_: f32;
    var phi_2993_: f32;
    var phi_3005_: f32;
    var phi_3010_: f32;
    var phi_3015_: f32;
    var phi_3020_: f32;
    var phi_3025_: lt_bvh_triangle_Intersection;
    var phi_3026_: bool;
    var phi_3027_: lt_bvh_triangle_Intersection;
    var phi_3028_: bool;
    var phi_3032_: lt_bvh_triangle_Intersection;
    var phi_3033_: bool;
    var phi_3034_: lt_bvh_triangle_Intersection;
    var phi_3035_: bool;
    var phi_3036_: bool;
    var phi_3040_: bool;
    var phi_3044_: lt_bvh_triangle_Intersection;
    var phi_3082_: bool;
    var phi_3083_: bool;
    var phi_3084_: bool;
    var phi_3085_: bool;
    var phi_3086_: bool;
    var phi_3087_: bool;
    var phi_3091_: bool;
    var phi_3092_: bool;
    var phi_3295_: f32;
    var phi_3298_: bool;
    var phi_3299_: bool;
    var phi_3303_: bool;
    var phi_3311_: lt_bvh_Hit;
    var phi_3312_: lt_bvh_Hit;
    var phi_3313_: lt_bvh_Hit;
    var phi_3314_: lt_bvh_Hit;
    var phi_2474_: lt_bvh_Hit;
    var phi_2477_: u32;
    var phi_3315_: bool;
    var phi_3354_: bool;
    var phi_3355_: bool;
    var phi_3386_: u32;
    var phi_2141_: lt_bvh_Hit;
    var phi_2144_: u32;
    var phi_3387_: lt_bvh_Hit;
    var phi_3388_: lt_bvh_Hit;
    var phi_3389_: bool;
    var phi_3393_: lt_bvh_Hit;
    var phi_3394_: lt_bvh_Hit;
    var phi_3395_: lt_bvh_Hit;
    var phi_3396_: lt_bvh_Hit;
    var phi_1515_: u32;
    var phi_1518_: lt_bvh_Hit;
    var phi_3397_: bool;
    var phi_3436_: bool;
    var phi_3437_: bool;
    var phi_3468_: u32;
    var phi_1178_: u32;
    var phi_1181_: lt_bvh_Hit;
    var phi_3469_: lt_bvh_Hit;
    var phi_3470_: lt_bvh_Hit;
    var phi_3471_: bool;
    var phi_3475_: lt_bvh_Hit;
    var phi_3662_: f32;
    var phi_3667_: f32;
    var phi_3672_: f32;
    var phi_3680_: f32;
    var phi_3685_: f32;
    var phi_3690_: f32;
    var phi_3754_: vec3<f32>;
    var phi_3997_: vec3<f32>;
    var phi_4012_: u32;
    var phi_4039_: f32;
    var phi_4046_: f32;
    var phi_4053_: f32;
    var phi_4088_: f32;
    var phi_4095_: f32;
    var phi_4102_: f32;
    var phi_4140_: f32;
    var phi_4147_: f32;
    var phi_4154_: f32;
    var phi_4240_: vec3<f32>;
    var phi_4241_: vec3<f32>;
    var phi_4242_: vec3<f32>;
    var phi_4251_: f32;
    var phi_4252_: f32;
    var phi_4262_: f32;
    var phi_4263_: f32;
    var phi_4273_: f32;
    var phi_4274_: f32;
    var phi_4309_: abi_Sample;
    var phi_4532_: vec3<f32>;
    var local_10: lt_bvh_Hit;
    var local_11: lt_bvh_Hit;
    var local_12: lt_bvh_Hit;
    var local_13: lt_bvh_Hit;

    let _e76 = id_1;
    let _e80 = arrayLength((&nodes.member));
    let _e83 = arrayLength((&triangles.member));
    let _e86 = arrayLength((&vertices.member));
    let _e89 = arrayLength((&materials.member));
    let _e95 = arrayLength((&instances.member));
    let _e98 = arrayLength((&alpha_texels.member));
    let _e101 = arrayLength((&color_texels.member));
    let _e104 = arrayLength((&before.member));
    let _e110 = p.member.size[0u];
    let _e112 = p.member.size[1u];
    let _e113 = lt_shaders_entry_pixel_index(_e76, _e110, _e112);
    if (bitcast<i32>(_e113.word) != 0i) {
        let _e119 = p.member.root;
        let _e123 = p.member.eye;
        let _e128 = p.member.size[0u];
        let _e132 = ((((f32(_e76.x) + 0.5f) / f32(_e128)) * 2f) - 1f);
        let _e137 = p.member.size[1u];
        let _e141 = (1f - (((f32(_e76.y) + 0.5f) / f32(_e137)) * 2f));
        let _e143 = p.member.forward;
        let _e145 = p.member.right;
        let _e159 = p.member.up;
        let _e170 = _lt_bvh_ray_Ray_new(_e123, vec3<f32>(((_e143.x + (_e145.x * _e132)) + (_e159.x * _e141)), ((_e143.y + (_e145.y * _e132)) + (_e159.y * _e141)), ((_e143.z + (_e145.z * _e132)) + (_e159.z * _e141))));
        let _e172 = lt_bvh_Hit(_e170.tmax, 0f, 0f, 4294967295u, 4294967295u);
        let _e182 = abs(_e170.direction.x);
        let _e184 = abs(_e170.direction.y);
        let _e186 = abs(_e170.direction.z);
        if (abs(_e170.origin.x) < 1000000000000000f) {
            if (abs(_e170.origin.y) < 1000000000000000f) {
                if (abs(_e170.origin.z) < 1000000000000000f) {
                    if (_e182 < 1000000000000000f) {
                        if (_e184 < 1000000000000000f) {
                            if (_e186 < 1000000000000000f) {
                                if (_e182 > 0f) {
                                    phi_820_ = bool();
                                    phi_821_ = true;
                                } else {
                                    let _e194 = (_e184 > 0f);
                                    if _e194 {
                                        phi_819_ = bool();
                                    } else {
                                        phi_819_ = (_e186 > 0f);
                                    }
                                    let _e197 = phi_819_;
                                    phi_820_ = _e197;
                                    phi_821_ = _e194;
                                }
                                let _e199 = phi_820_;
                                let _e201 = phi_821_;
                                if _e201 {
                                    phi_825_ = true;
                                } else {
                                    phi_825_ = _e199;
                                }
                                let _e203 = phi_825_;
                                phi_826_ = _e203;
                                phi_827_ = false;
                            } else {
                                phi_826_ = bool();
                                phi_827_ = true;
                            }
                            let _e205 = phi_826_;
                            let _e207 = phi_827_;
                            phi_828_ = _e205;
                            phi_829_ = false;
                            phi_830_ = _e207;
                        } else {
                            phi_828_ = bool();
                            phi_829_ = true;
                            phi_830_ = false;
                        }
                        let _e209 = phi_828_;
                        let _e211 = phi_829_;
                        let _e213 = phi_830_;
                        phi_831_ = _e209;
                        phi_832_ = _e211;
                        phi_833_ = _e213;
                    } else {
                        phi_831_ = bool();
                        phi_832_ = true;
                        phi_833_ = false;
                    }
                    let _e215 = phi_831_;
                    let _e217 = phi_832_;
                    let _e219 = phi_833_;
                    phi_834_ = _e215;
                    phi_835_ = _e217;
                    phi_836_ = _e219;
                } else {
                    phi_834_ = bool();
                    phi_835_ = true;
                    phi_836_ = false;
                }
                let _e221 = phi_834_;
                let _e223 = phi_835_;
                let _e225 = phi_836_;
                phi_837_ = _e221;
                phi_838_ = _e223;
                phi_839_ = _e225;
            } else {
                phi_837_ = bool();
                phi_838_ = true;
                phi_839_ = false;
            }
            let _e227 = phi_837_;
            let _e229 = phi_838_;
            let _e231 = phi_839_;
            phi_840_ = _e227;
            phi_841_ = _e229;
            phi_842_ = _e231;
        } else {
            phi_840_ = bool();
            phi_841_ = true;
            phi_842_ = false;
        }
        let _e233 = phi_840_;
        let _e235 = phi_841_;
        let _e237 = phi_842_;
        if _e235 {
            phi_846_ = true;
        } else {
            phi_846_ = _e237;
        }
        let _e239 = phi_846_;
        if _e239 {
            phi_850_ = false;
        } else {
            phi_850_ = _e233;
        }
        let _e241 = phi_850_;
        if _e241 {
            let _e242 = (_e119 >= _e80);
            if _e242 {
                phi_3469_ = lt_bvh_Hit();
            } else {
                if (_e119 < _e80) {
                } else {
                    return;
                }
                let _e248 = nodes.member[(0u + _e119)].frame[0u];
                let _e252 = nodes.member[(0u + _e119)].frame[1u];
                let _e256 = nodes.member[(0u + _e119)].frame[2u];
                let _e260 = nodes.member[(0u + _e119)].frame[0u];
                let _e264 = nodes.member[(0u + _e119)].frame[1u];
                let _e268 = nodes.member[(0u + _e119)].frame[2u];
                let _e272 = nodes.member[(0u + _e119)].frame[3u];
                let _e310 = core_intrinsics_maximum_number_nsz_f32_(abs(_e170.direction.x), abs(_e170.direction.y));
                let _e311 = core_intrinsics_maximum_number_nsz_f32_(_e310, abs(_e170.direction.z));
                let _e312 = (_e311 * 0.0000000000009094947f);
                if (abs(_e170.direction.x) < _e312) {
                    phi_925_ = _e312;
                } else {
                    phi_925_ = abs(_e170.direction.x);
                }
                let _e318 = phi_925_;
                if (_e170.direction.x < 0f) {
                    phi_932_ = (-1f / _e318);
                } else {
                    phi_932_ = (1f / _e318);
                }
                let _e323 = phi_932_;
                if (abs(_e170.direction.y) < _e312) {
                    phi_940_ = _e312;
                } else {
                    phi_940_ = abs(_e170.direction.y);
                }
                let _e329 = phi_940_;
                if (_e170.direction.y < 0f) {
                    phi_947_ = (-1f / _e329);
                } else {
                    phi_947_ = (1f / _e329);
                }
                let _e334 = phi_947_;
                if (abs(_e170.direction.z) < _e312) {
                    phi_955_ = _e312;
                } else {
                    phi_955_ = abs(_e170.direction.z);
                }
                let _e340 = phi_955_;
                if (_e170.direction.z < 0f) {
                    phi_962_ = (-1f / _e340);
                } else {
                    phi_962_ = (1f / _e340);
                }
                let _e345 = phi_962_;
                let _e353 = abs((bitcast<f32>(_e248) - _e170.origin.x));
                let _e354 = abs((bitcast<f32>(_e252) - _e170.origin.y));
                let _e355 = abs((bitcast<f32>(_e256) - _e170.origin.z));
                let _e363 = abs(((bitcast<f32>(_e260) + (bitcast<f32>((((_e272 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e170.origin.x));
                let _e364 = abs(((bitcast<f32>(_e264) + (bitcast<f32>((((_e272 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e170.origin.y));
                let _e365 = abs(((bitcast<f32>(_e268) + (bitcast<f32>((((_e272 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e170.origin.z));
                if (_e353 > _e363) {
                    phi_987_ = _e353;
                } else {
                    phi_987_ = _e363;
                }
                let _e368 = phi_987_;
                if (_e354 > _e364) {
                    phi_992_ = _e354;
                } else {
                    phi_992_ = _e364;
                }
                let _e371 = phi_992_;
                if (_e355 > _e365) {
                    phi_997_ = _e355;
                } else {
                    phi_997_ = _e365;
                }
                let _e374 = phi_997_;
                let _e375 = core_intrinsics_maximum_number_nsz_f32_(_e368, _e371);
                let _e376 = core_intrinsics_maximum_number_nsz_f32_(_e375, _e374);
                let _e381 = (_e376 * 0.0000019073486f);
                let _e382 = (abs(_e323) * _e381);
                let _e383 = (abs(_e334) * _e381);
                let _e384 = (abs(_e345) * _e381);
                let _e388 = (_e376 * 0.0000009536743f);
                let _e389 = (abs(_e323) * _e388);
                let _e390 = (abs(_e334) * _e388);
                let _e391 = (abs(_e345) * _e388);
                if (_e323 < 0f) {
                    phi_1019_ = 0u;
                } else {
                    phi_1019_ = 1u;
                }
                let _e394 = phi_1019_;
                if (_e334 < 0f) {
                    phi_1024_ = 0u;
                } else {
                    phi_1024_ = 2u;
                }
                let _e397 = phi_1024_;
                if (_e345 < 0f) {
                    phi_1029_ = 0u;
                } else {
                    phi_1029_ = 4u;
                }
                let _e400 = phi_1029_;
                let _e402 = ((_e394 | _e397) | _e400);
                let _e403 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e119, 2147483648u);
                local_3 = lt_bvh_traverse_Stack(array<u32, 32>(_e403.first[0], _e403.first[1], _e403.first[2], _e403.first[3], _e403.first[4], _e403.first[5], _e403.first[6], _e403.first[7], _e403.first[8], _e403.first[9], _e403.first[10], _e403.first[11], _e403.first[12], _e403.first[13], _e403.first[14], _e403.first[15], _e403.first[16], _e403.first[17], _e403.first[18], _e403.first[19], _e403.first[20], _e403.first[21], _e403.first[22], _e403.first[23], _e403.first[24], _e403.first[25], _e403.first[26], _e403.first[27], _e403.first[28], _e403.first[29], _e403.first[30], _e403.first[31]), array<u32, 32>(_e403.mask[0], _e403.mask[1], _e403.mask[2], _e403.mask[3], _e403.mask[4], _e403.mask[5], _e403.mask[6], _e403.mask[7], _e403.mask[8], _e403.mask[9], _e403.mask[10], _e403.mask[11], _e403.mask[12], _e403.mask[13], _e403.mask[14], _e403.mask[15], _e403.mask[16], _e403.mask[17], _e403.mask[18], _e403.mask[19], _e403.mask[20], _e403.mask[21], _e403.mask[22], _e403.mask[23], _e403.mask[24], _e403.mask[25], _e403.mask[26], _e403.mask[27], _e403.mask[28], _e403.mask[29], _e403.mask[30], _e403.mask[31]), _e403.len, _e403.group, _e403.group_mask);
                let _e477 = local_3.group_mask;
                if ((_e477 & 4278190080u) == 0u) {
                    let _e481 = local_3.len;
                    if (_e481 == 0u) {
                        phi_1143_ = false;
                    } else {
                        let _e485 = local_3.len;
                        local_3.len = (_e485 - 1u);
                        let _e488 = local_3.len;
                        if (_e488 < 32u) {
                        } else {
                            return;
                        }
                        let _e493 = local_3.first[(0u + _e488)];
                        local_3.group = _e493;
                        let _e496 = local_3.len;
                        if (_e496 < 32u) {
                        } else {
                            return;
                        }
                        let _e501 = local_3.mask[(0u + _e496)];
                        local_3.group_mask = _e501;
                        phi_1143_ = true;
                    }
                    let _e504 = phi_1143_;
                    phi_1144_ = _e504;
                } else {
                    phi_1144_ = true;
                }
                let _e506 = phi_1144_;
                if _e506 {
                    let _e508 = local_3.group_mask;
                    let _e514 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e508)), 32u, (_e508 == 0u)));
                    let _e518 = local_3.group_mask;
                    let _e532 = local_3.group_mask;
                    local_3.group_mask = (_e532 & ~((1u << bitcast<u32>((_e514 & 31u)))));
                    let _e535 = local_3.group;
                    phi_1175_ = (_e535 + countOneBits(((_e518 & ~((4294967295u << bitcast<u32>((((_e514 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1175_ = 4294967295u;
                }
                let _e538 = phi_1175_;
                phi_1177_ = _e538;
                phi_1180_ = _e172;
                loop {
                    let _e540 = phi_1177_;
                    let _e542 = phi_1180_;
                    local_13 = _e542;
                    let _e543 = (_e540 != 4294967295u);
                    if _e543 {
                        if (_e540 < _e80) {
                        } else {
                            return;
                        }
                        let _e551 = nodes.member[(0u + _e540)].frame[3u];
                        let _e576 = (bitcast<f32>((((_e551 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e323);
                        let _e577 = (bitcast<f32>((((_e551 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e334);
                        let _e578 = (bitcast<f32>((((_e551 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e345);
                        let _e581 = nodes.member[(0u + _e540)].frame[0u];
                        let _e585 = nodes.member[(0u + _e540)].frame[1u];
                        let _e589 = nodes.member[(0u + _e540)].frame[2u];
                        let _e597 = ((bitcast<f32>(_e581) - _e170.origin.x) * _e323);
                        let _e598 = ((bitcast<f32>(_e585) - _e170.origin.y) * _e334);
                        let _e599 = ((bitcast<f32>(_e589) - _e170.origin.z) * _e345);
                        let _e607 = nodes.member[(0u + _e540)].x;
                        if (_e323 < 0f) {
                            let _e618 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e607.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e624 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e618.unnamed.word, _e607.w), _e618.unnamed_1);
                            let _e630 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e624.unnamed, lt_mask_LightPlace(_e607.x, _e624.unnamed_1.shift));
                            phi_1265_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e630.unnamed, lt_mask_LightPlace(_e630.unnamed_1.word, _e607.y));
                        } else {
                            let _e646 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e607.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e652 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e646.unnamed.word, _e607.y), _e646.unnamed_1);
                            let _e658 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e652.unnamed, lt_mask_LightPlace(_e607.z, _e652.unnamed_1.shift));
                            phi_1265_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e658.unnamed, lt_mask_LightPlace(_e658.unnamed_1.word, _e607.w));
                        }
                        let _e666 = phi_1265_;
                        let _e676 = nodes.member[(0u + _e540)].y;
                        if (_e334 < 0f) {
                            let _e687 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e676.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e693 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e687.unnamed.word, _e676.w), _e687.unnamed_1);
                            let _e699 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e693.unnamed, lt_mask_LightPlace(_e676.x, _e693.unnamed_1.shift));
                            phi_1292_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e699.unnamed, lt_mask_LightPlace(_e699.unnamed_1.word, _e676.y));
                        } else {
                            let _e715 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e676.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e721 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e715.unnamed.word, _e676.y), _e715.unnamed_1);
                            let _e727 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e721.unnamed, lt_mask_LightPlace(_e676.z, _e721.unnamed_1.shift));
                            phi_1292_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e727.unnamed, lt_mask_LightPlace(_e727.unnamed_1.word, _e676.w));
                        }
                        let _e735 = phi_1292_;
                        let _e745 = nodes.member[(0u + _e540)].z;
                        if (_e345 < 0f) {
                            let _e756 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e745.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e762 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e756.unnamed.word, _e745.w), _e756.unnamed_1);
                            let _e768 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e762.unnamed, lt_mask_LightPlace(_e745.x, _e762.unnamed_1.shift));
                            phi_1319_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e768.unnamed, lt_mask_LightPlace(_e768.unnamed_1.word, _e745.y));
                        } else {
                            let _e784 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e745.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e790 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e784.unnamed.word, _e745.y), _e784.unnamed_1);
                            let _e796 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e790.unnamed, lt_mask_LightPlace(_e745.z, _e790.unnamed_1.shift));
                            phi_1319_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e796.unnamed, lt_mask_LightPlace(_e796.unnamed_1.word, _e745.w));
                        }
                        let _e804 = phi_1319_;
                        phi_1325_ = 0u;
                        phi_1328_ = 0u;
                        loop {
                            let _e814 = phi_1325_;
                            let _e816 = phi_1328_;
                            local_4 = _e816;
                            local_5 = _e816;
                            local_6 = _e816;
                            let _e817 = (_e814 < 8u);
                            if _e817 {
                                let _e819 = (_e814 >> bitcast<u32>(2i));
                                let _e820 = (_e814 & 3u);
                                if (_e819 == 0u) {
                                    phi_1342_ = _e666.unnamed.word;
                                } else {
                                    phi_1342_ = _e666.unnamed.shift;
                                }
                                let _e823 = phi_1342_;
                                if (_e819 == 0u) {
                                    phi_1352_ = _e735.unnamed.word;
                                } else {
                                    phi_1352_ = _e735.unnamed.shift;
                                }
                                let _e832 = phi_1352_;
                                if (_e819 == 0u) {
                                    phi_1362_ = _e804.unnamed.word;
                                } else {
                                    phi_1362_ = _e804.unnamed.shift;
                                }
                                let _e841 = phi_1362_;
                                let _e854 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e823 >> bitcast<u32>(((_e820 * 8u) & 31u))) & 255u)) * _e576) + (_e597 - _e382)), ((f32(((_e832 >> bitcast<u32>(((_e820 * 8u) & 31u))) & 255u)) * _e577) + (_e598 - _e383)));
                                let _e855 = core_intrinsics_maximum_number_nsz_f32_(_e854, ((f32(((_e841 >> bitcast<u32>(((_e820 * 8u) & 31u))) & 255u)) * _e578) + (_e599 - _e384)));
                                if (_e819 == 0u) {
                                    phi_1380_ = _e666.unnamed_1.word;
                                } else {
                                    phi_1380_ = _e666.unnamed_1.shift;
                                }
                                let _e858 = phi_1380_;
                                if (_e819 == 0u) {
                                    phi_1390_ = _e735.unnamed_1.word;
                                } else {
                                    phi_1390_ = _e735.unnamed_1.shift;
                                }
                                let _e867 = phi_1390_;
                                if (_e819 == 0u) {
                                    phi_1400_ = _e804.unnamed_1.word;
                                } else {
                                    phi_1400_ = _e804.unnamed_1.shift;
                                }
                                let _e876 = phi_1400_;
                                let _e889 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e858 >> bitcast<u32>(((_e820 * 8u) & 31u))) & 255u)) * _e576) + (_e597 + _e382)), ((f32(((_e867 >> bitcast<u32>(((_e820 * 8u) & 31u))) & 255u)) * _e577) + (_e598 + _e383)));
                                let _e890 = core_intrinsics_minimum_number_nsz_f32_(_e889, ((f32(((_e876 >> bitcast<u32>(((_e820 * 8u) & 31u))) & 255u)) * _e578) + (_e599 + _e384)));
                                if (_e855 <= _e890) {
                                    if (_e855 <= _e542.t) {
                                        if (_e890 >= _e170.tmin) {
                                            if (_e819 == 0u) {
                                                let _e897 = nodes.member[(0u + _e540)].links[2u];
                                                phi_1436_ = _e897;
                                            } else {
                                                let _e900 = nodes.member[(0u + _e540)].links[3u];
                                                phi_1436_ = _e900;
                                            }
                                            let _e902 = phi_1436_;
                                            let _e907 = ((_e902 >> bitcast<u32>(((_e820 * 8u) & 31u))) & 255u);
                                            let _e908 = (_e907 & 31u);
                                            if (_e908 >= 24u) {
                                                phi_1449_ = (24u + ((_e908 - 24u) ^ _e402));
                                            } else {
                                                phi_1449_ = _e908;
                                            }
                                            let _e914 = phi_1449_;
                                            phi_1454_ = (_e816 | ((_e907 >> bitcast<u32>(5i)) << bitcast<u32>((_e914 & 31u))));
                                        } else {
                                            phi_1454_ = _e816;
                                        }
                                        let _e922 = phi_1454_;
                                        phi_1455_ = _e922;
                                    } else {
                                        phi_1455_ = _e816;
                                    }
                                    let _e924 = phi_1455_;
                                    phi_1456_ = _e924;
                                } else {
                                    phi_1456_ = _e816;
                                }
                                let _e926 = phi_1456_;
                                phi_1326_ = (_e814 + 1u);
                                phi_1329_ = _e926;
                            } else {
                                phi_1326_ = u32();
                                phi_1329_ = u32();
                            }
                            let _e929 = phi_1326_;
                            let _e931 = phi_1329_;
                            continue;
                            continuing {
                                phi_1325_ = _e929;
                                phi_1328_ = _e931;
                                break if !(_e817);
                            }
                        }
                        let _e935 = nodes.member[(0u + _e540)].links[0u];
                        let _e939 = nodes.member[(0u + _e540)].frame[3u];
                        let _e943 = local_4;
                        if ((_e943 & 4278190080u) == 0u) {
                        } else {
                            let _e947 = local_3.group_mask;
                            if ((_e947 & 4278190080u) == 0u) {
                            } else {
                                let _e951 = local_3.len;
                                if (_e951 < 32u) {
                                    let _e954 = local_3.group;
                                    let _e956 = local_3.len;
                                    if (_e956 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_3.first[(0u + _e956)] = _e954;
                                    let _e962 = local_3.group_mask;
                                    let _e964 = local_3.len;
                                    if (_e964 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_3.mask[(0u + _e964)] = _e962;
                                    let _e971 = local_3.len;
                                    local_3.len = (_e971 + 1u);
                                }
                            }
                            local_3.group = (_e119 + _e935);
                            let _e975 = local_5;
                            local_3.group_mask = ((_e975 & 4278190080u) | (_e939 >> bitcast<u32>(24i)));
                        }
                        let _e980 = local_6;
                        phi_1514_ = (_e980 & 16777215u);
                        phi_1517_ = _e542;
                        loop {
                            let _e983 = phi_1514_;
                            let _e985 = phi_1517_;
                            local_12 = _e985;
                            if (_e983 == 0u) {
                                phi_1515_ = u32();
                                phi_1518_ = lt_bvh_Hit();
                                phi_3397_ = false;
                            } else {
                                let _e989 = nodes.member[(0u + _e540)].links[1u];
                                let _e993 = (_e989 + select(firstTrailingBit(_e983), 32u, (_e983 == 0u)));
                                if (_e993 < _e95) {
                                } else {
                                    return;
                                }
                                let _e1000 = instances.member[(0u + _e993)].low_world;
                                let _e1002 = instances.member[(0u + _e993)].high_world;
                                let _e1012 = ((_e1000.x - _e170.origin.x) * _e323);
                                let _e1013 = ((_e1000.y - _e170.origin.y) * _e334);
                                let _e1014 = ((_e1000.z - _e170.origin.z) * _e345);
                                let _e1024 = ((_e1002.x - _e170.origin.x) * _e323);
                                let _e1025 = ((_e1002.y - _e170.origin.y) * _e334);
                                let _e1026 = ((_e1002.z - _e170.origin.z) * _e345);
                                if (_e1012 < _e1024) {
                                    phi_1572_ = _e1012;
                                } else {
                                    phi_1572_ = _e1024;
                                }
                                let _e1029 = phi_1572_;
                                if (_e1013 < _e1025) {
                                    phi_1577_ = _e1013;
                                } else {
                                    phi_1577_ = _e1025;
                                }
                                let _e1032 = phi_1577_;
                                if (_e1014 < _e1026) {
                                    phi_1582_ = _e1014;
                                } else {
                                    phi_1582_ = _e1026;
                                }
                                let _e1035 = phi_1582_;
                                if (_e1012 > _e1024) {
                                    phi_1590_ = _e1012;
                                } else {
                                    phi_1590_ = _e1024;
                                }
                                let _e1041 = phi_1590_;
                                if (_e1013 > _e1025) {
                                    phi_1595_ = _e1013;
                                } else {
                                    phi_1595_ = _e1025;
                                }
                                let _e1044 = phi_1595_;
                                if (_e1014 > _e1026) {
                                    phi_1600_ = _e1014;
                                } else {
                                    phi_1600_ = _e1026;
                                }
                                let _e1047 = phi_1600_;
                                let _e1051 = core_intrinsics_maximum_number_nsz_f32_((_e1029 - _e389), (_e1032 - _e390));
                                let _e1052 = core_intrinsics_maximum_number_nsz_f32_(_e1051, (_e1035 - _e391));
                                let _e1053 = core_intrinsics_minimum_number_nsz_f32_((_e1041 + _e389), (_e1044 + _e390));
                                let _e1054 = core_intrinsics_minimum_number_nsz_f32_(_e1053, (_e1047 + _e391));
                                if (_e1052 <= _e1054) {
                                    if (_e1052 <= _e985.t) {
                                        if (_e1054 >= _e170.tmin) {
                                            let _e1066 = instances.member[(0u + _e993)].world_to_object[0u];
                                            let _e1077 = ((((_e1066.x * _e170.origin.x) + (_e1066.y * _e170.origin.y)) + (_e1066.z * _e170.origin.z)) + (_e1066.w * 1f));
                                            let _e1079 = instances.member[(0u + _e993)].world_to_object[1u];
                                            let _e1090 = ((((_e1079.x * _e170.origin.x) + (_e1079.y * _e170.origin.y)) + (_e1079.z * _e170.origin.z)) + (_e1079.w * 1f));
                                            let _e1092 = instances.member[(0u + _e993)].world_to_object[2u];
                                            let _e1103 = ((((_e1092.x * _e170.origin.x) + (_e1092.y * _e170.origin.y)) + (_e1092.z * _e170.origin.z)) + (_e1092.w * 1f));
                                            let _e1110 = instances.member[(0u + _e993)].world_to_object[0u];
                                            let _e1121 = ((((_e1110.x * _e170.direction.x) + (_e1110.y * _e170.direction.y)) + (_e1110.z * _e170.direction.z)) + (_e1110.w * 0f));
                                            let _e1123 = instances.member[(0u + _e993)].world_to_object[1u];
                                            let _e1134 = ((((_e1123.x * _e170.direction.x) + (_e1123.y * _e170.direction.y)) + (_e1123.z * _e170.direction.z)) + (_e1123.w * 0f));
                                            let _e1136 = instances.member[(0u + _e993)].world_to_object[2u];
                                            let _e1147 = ((((_e1136.x * _e170.direction.x) + (_e1136.y * _e170.direction.y)) + (_e1136.z * _e170.direction.z)) + (_e1136.w * 0f));
                                            let _e1152 = instances.member[(0u + _e993)].root;
                                            let _e1154 = instances.member[(0u + _e993)].first_triangle;
                                            let _e1158 = abs(_e1121);
                                            let _e1159 = abs(_e1134);
                                            let _e1160 = abs(_e1147);
                                            if (abs(_e1077) < 1000000000000000f) {
                                                if (abs(_e1090) < 1000000000000000f) {
                                                    if (abs(_e1103) < 1000000000000000f) {
                                                        if (_e1158 < 1000000000000000f) {
                                                            if (_e1159 < 1000000000000000f) {
                                                                if (_e1160 < 1000000000000000f) {
                                                                    if (_e1158 > 0f) {
                                                                        phi_1757_ = bool();
                                                                        phi_1758_ = true;
                                                                    } else {
                                                                        let _e1168 = (_e1159 > 0f);
                                                                        if _e1168 {
                                                                            phi_1756_ = bool();
                                                                        } else {
                                                                            phi_1756_ = (_e1160 > 0f);
                                                                        }
                                                                        let _e1171 = phi_1756_;
                                                                        phi_1757_ = _e1171;
                                                                        phi_1758_ = _e1168;
                                                                    }
                                                                    let _e1173 = phi_1757_;
                                                                    let _e1175 = phi_1758_;
                                                                    if _e1175 {
                                                                        phi_1762_ = true;
                                                                    } else {
                                                                        phi_1762_ = _e1173;
                                                                    }
                                                                    let _e1177 = phi_1762_;
                                                                    phi_1763_ = _e1177;
                                                                    phi_1764_ = false;
                                                                } else {
                                                                    phi_1763_ = bool();
                                                                    phi_1764_ = true;
                                                                }
                                                                let _e1179 = phi_1763_;
                                                                let _e1181 = phi_1764_;
                                                                phi_1765_ = _e1179;
                                                                phi_1766_ = false;
                                                                phi_1767_ = _e1181;
                                                            } else {
                                                                phi_1765_ = bool();
                                                                phi_1766_ = true;
                                                                phi_1767_ = false;
                                                            }
                                                            let _e1183 = phi_1765_;
                                                            let _e1185 = phi_1766_;
                                                            let _e1187 = phi_1767_;
                                                            phi_1768_ = _e1183;
                                                            phi_1769_ = _e1185;
                                                            phi_1770_ = _e1187;
                                                        } else {
                                                            phi_1768_ = bool();
                                                            phi_1769_ = true;
                                                            phi_1770_ = false;
                                                        }
                                                        let _e1189 = phi_1768_;
                                                        let _e1191 = phi_1769_;
                                                        let _e1193 = phi_1770_;
                                                        phi_1771_ = _e1189;
                                                        phi_1772_ = _e1191;
                                                        phi_1773_ = _e1193;
                                                    } else {
                                                        phi_1771_ = bool();
                                                        phi_1772_ = true;
                                                        phi_1773_ = false;
                                                    }
                                                    let _e1195 = phi_1771_;
                                                    let _e1197 = phi_1772_;
                                                    let _e1199 = phi_1773_;
                                                    phi_1774_ = _e1195;
                                                    phi_1775_ = _e1197;
                                                    phi_1776_ = _e1199;
                                                } else {
                                                    phi_1774_ = bool();
                                                    phi_1775_ = true;
                                                    phi_1776_ = false;
                                                }
                                                let _e1201 = phi_1774_;
                                                let _e1203 = phi_1775_;
                                                let _e1205 = phi_1776_;
                                                phi_1777_ = _e1201;
                                                phi_1778_ = _e1203;
                                                phi_1779_ = _e1205;
                                            } else {
                                                phi_1777_ = bool();
                                                phi_1778_ = true;
                                                phi_1779_ = false;
                                            }
                                            let _e1207 = phi_1777_;
                                            let _e1209 = phi_1778_;
                                            let _e1211 = phi_1779_;
                                            if _e1209 {
                                                phi_1783_ = true;
                                            } else {
                                                phi_1783_ = _e1211;
                                            }
                                            let _e1213 = phi_1783_;
                                            if _e1213 {
                                                phi_1787_ = false;
                                            } else {
                                                phi_1787_ = _e1207;
                                            }
                                            let _e1215 = phi_1787_;
                                            if _e1215 {
                                                let _e1216 = (_e1152 >= _e80);
                                                if _e1216 {
                                                    phi_3387_ = lt_bvh_Hit();
                                                } else {
                                                    if (_e1152 < _e80) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1222 = nodes.member[(0u + _e1152)].frame[0u];
                                                    let _e1226 = nodes.member[(0u + _e1152)].frame[1u];
                                                    let _e1230 = nodes.member[(0u + _e1152)].frame[2u];
                                                    let _e1234 = nodes.member[(0u + _e1152)].frame[0u];
                                                    let _e1238 = nodes.member[(0u + _e1152)].frame[1u];
                                                    let _e1242 = nodes.member[(0u + _e1152)].frame[2u];
                                                    let _e1246 = nodes.member[(0u + _e1152)].frame[3u];
                                                    let _e1280 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1121), abs(_e1134));
                                                    let _e1281 = core_intrinsics_maximum_number_nsz_f32_(_e1280, abs(_e1147));
                                                    let _e1282 = (_e1281 * 0.0000000000009094947f);
                                                    if (abs(_e1121) < _e1282) {
                                                        phi_1857_ = _e1282;
                                                    } else {
                                                        phi_1857_ = abs(_e1121);
                                                    }
                                                    let _e1287 = phi_1857_;
                                                    if (_e1121 < 0f) {
                                                        phi_1864_ = (-1f / _e1287);
                                                    } else {
                                                        phi_1864_ = (1f / _e1287);
                                                    }
                                                    let _e1292 = phi_1864_;
                                                    if (abs(_e1134) < _e1282) {
                                                        phi_1871_ = _e1282;
                                                    } else {
                                                        phi_1871_ = abs(_e1134);
                                                    }
                                                    let _e1297 = phi_1871_;
                                                    if (_e1134 < 0f) {
                                                        phi_1878_ = (-1f / _e1297);
                                                    } else {
                                                        phi_1878_ = (1f / _e1297);
                                                    }
                                                    let _e1302 = phi_1878_;
                                                    if (abs(_e1147) < _e1282) {
                                                        phi_1885_ = _e1282;
                                                    } else {
                                                        phi_1885_ = abs(_e1147);
                                                    }
                                                    let _e1307 = phi_1885_;
                                                    if (_e1147 < 0f) {
                                                        phi_1892_ = (-1f / _e1307);
                                                    } else {
                                                        phi_1892_ = (1f / _e1307);
                                                    }
                                                    let _e1312 = phi_1892_;
                                                    let _e1316 = abs((bitcast<f32>(_e1222) - _e1077));
                                                    let _e1317 = abs((bitcast<f32>(_e1226) - _e1090));
                                                    let _e1318 = abs((bitcast<f32>(_e1230) - _e1103));
                                                    let _e1322 = abs(((bitcast<f32>(_e1234) + (bitcast<f32>((((_e1246 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1077));
                                                    let _e1323 = abs(((bitcast<f32>(_e1238) + (bitcast<f32>((((_e1246 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1090));
                                                    let _e1324 = abs(((bitcast<f32>(_e1242) + (bitcast<f32>((((_e1246 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1103));
                                                    if (_e1316 > _e1322) {
                                                        phi_1909_ = _e1316;
                                                    } else {
                                                        phi_1909_ = _e1322;
                                                    }
                                                    let _e1327 = phi_1909_;
                                                    if (_e1317 > _e1323) {
                                                        phi_1914_ = _e1317;
                                                    } else {
                                                        phi_1914_ = _e1323;
                                                    }
                                                    let _e1330 = phi_1914_;
                                                    if (_e1318 > _e1324) {
                                                        phi_1919_ = _e1318;
                                                    } else {
                                                        phi_1919_ = _e1324;
                                                    }
                                                    let _e1333 = phi_1919_;
                                                    let _e1334 = core_intrinsics_maximum_number_nsz_f32_(_e1327, _e1330);
                                                    let _e1335 = core_intrinsics_maximum_number_nsz_f32_(_e1334, _e1333);
                                                    let _e1339 = (_e1335 * 0.0000019073486f);
                                                    let _e1340 = (abs(_e1292) * _e1339);
                                                    let _e1341 = (abs(_e1302) * _e1339);
                                                    let _e1342 = (abs(_e1312) * _e1339);
                                                    let _e1346 = (_e1335 * 0.0000009536743f);
                                                    let _e1347 = (abs(_e1292) * _e1346);
                                                    let _e1348 = (abs(_e1302) * _e1346);
                                                    let _e1349 = (abs(_e1312) * _e1346);
                                                    let _e1350 = abs(_e1121);
                                                    let _e1351 = abs(_e1134);
                                                    let _e1352 = abs(_e1147);
                                                    if (_e1350 >= _e1351) {
                                                        if (_e1350 >= _e1352) {
                                                            phi_1947_ = false;
                                                        } else {
                                                            phi_1947_ = true;
                                                        }
                                                        let _e1356 = phi_1947_;
                                                        phi_1948_ = _e1356;
                                                    } else {
                                                        phi_1948_ = true;
                                                    }
                                                    let _e1358 = phi_1948_;
                                                    if _e1358 {
                                                        if (_e1351 >= _e1352) {
                                                            phi_1956_ = 1u;
                                                        } else {
                                                            phi_1956_ = 2u;
                                                        }
                                                        let _e1361 = phi_1956_;
                                                        phi_1957_ = _e1361;
                                                    } else {
                                                        phi_1957_ = 0u;
                                                    }
                                                    let _e1363 = phi_1957_;
                                                    if (_e1363 == 0u) {
                                                        phi_1969_ = vec3<f32>(_e1134, _e1147, _e1121);
                                                    } else {
                                                        if (_e1363 == 1u) {
                                                            phi_1968_ = vec3<f32>(_e1147, _e1121, _e1134);
                                                        } else {
                                                            phi_1968_ = vec3<f32>(_e1121, _e1134, _e1147);
                                                        }
                                                        let _e1369 = phi_1968_;
                                                        phi_1969_ = _e1369;
                                                    }
                                                    let _e1371 = phi_1969_;
                                                    let _e1374 = (_e1371.x / _e1371.z);
                                                    let _e1377 = (_e1371.y / _e1371.z);
                                                    if (_e1292 < 0f) {
                                                        phi_1982_ = 0u;
                                                    } else {
                                                        phi_1982_ = 1u;
                                                    }
                                                    let _e1382 = phi_1982_;
                                                    if (_e1302 < 0f) {
                                                        phi_1987_ = 0u;
                                                    } else {
                                                        phi_1987_ = 2u;
                                                    }
                                                    let _e1385 = phi_1987_;
                                                    if (_e1312 < 0f) {
                                                        phi_1992_ = 0u;
                                                    } else {
                                                        phi_1992_ = 4u;
                                                    }
                                                    let _e1388 = phi_1992_;
                                                    let _e1390 = ((_e1382 | _e1385) | _e1388);
                                                    let _e1391 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1152, 2147483648u);
                                                    local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e1391.first[0], _e1391.first[1], _e1391.first[2], _e1391.first[3], _e1391.first[4], _e1391.first[5], _e1391.first[6], _e1391.first[7], _e1391.first[8], _e1391.first[9], _e1391.first[10], _e1391.first[11], _e1391.first[12], _e1391.first[13], _e1391.first[14], _e1391.first[15], _e1391.first[16], _e1391.first[17], _e1391.first[18], _e1391.first[19], _e1391.first[20], _e1391.first[21], _e1391.first[22], _e1391.first[23], _e1391.first[24], _e1391.first[25], _e1391.first[26], _e1391.first[27], _e1391.first[28], _e1391.first[29], _e1391.first[30], _e1391.first[31]), array<u32, 32>(_e1391.mask[0], _e1391.mask[1], _e1391.mask[2], _e1391.mask[3], _e1391.mask[4], _e1391.mask[5], _e1391.mask[6], _e1391.mask[7], _e1391.mask[8], _e1391.mask[9], _e1391.mask[10], _e1391.mask[11], _e1391.mask[12], _e1391.mask[13], _e1391.mask[14], _e1391.mask[15], _e1391.mask[16], _e1391.mask[17], _e1391.mask[18], _e1391.mask[19], _e1391.mask[20], _e1391.mask[21], _e1391.mask[22], _e1391.mask[23], _e1391.mask[24], _e1391.mask[25], _e1391.mask[26], _e1391.mask[27], _e1391.mask[28], _e1391.mask[29], _e1391.mask[30], _e1391.mask[31]), _e1391.len, _e1391.group, _e1391.group_mask);
                                                    let _e1465 = local_2.group_mask;
                                                    if ((_e1465 & 4278190080u) == 0u) {
                                                        let _e1469 = local_2.len;
                                                        if (_e1469 == 0u) {
                                                            phi_2106_ = false;
                                                        } else {
                                                            let _e1473 = local_2.len;
                                                            local_2.len = (_e1473 - 1u);
                                                            let _e1476 = local_2.len;
                                                            if (_e1476 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1481 = local_2.first[(0u + _e1476)];
                                                            local_2.group = _e1481;
                                                            let _e1484 = local_2.len;
                                                            if (_e1484 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1489 = local_2.mask[(0u + _e1484)];
                                                            local_2.group_mask = _e1489;
                                                            phi_2106_ = true;
                                                        }
                                                        let _e1492 = phi_2106_;
                                                        phi_2107_ = _e1492;
                                                    } else {
                                                        phi_2107_ = true;
                                                    }
                                                    let _e1494 = phi_2107_;
                                                    if _e1494 {
                                                        let _e1496 = local_2.group_mask;
                                                        let _e1502 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1496)), 32u, (_e1496 == 0u)));
                                                        let _e1506 = local_2.group_mask;
                                                        let _e1520 = local_2.group_mask;
                                                        local_2.group_mask = (_e1520 & ~((1u << bitcast<u32>((_e1502 & 31u)))));
                                                        let _e1523 = local_2.group;
                                                        phi_2138_ = (_e1523 + countOneBits(((_e1506 & ~((4294967295u << bitcast<u32>((((_e1502 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_2138_ = 4294967295u;
                                                    }
                                                    let _e1526 = phi_2138_;
                                                    phi_2140_ = _e985;
                                                    phi_2143_ = _e1526;
                                                    loop {
                                                        let _e1528 = phi_2140_;
                                                        let _e1530 = phi_2143_;
                                                        local_11 = _e1528;
                                                        let _e1531 = (_e1530 != 4294967295u);
                                                        if _e1531 {
                                                            if (_e1530 < _e80) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1538 = nodes.member[(0u + _e1530)].frame[3u];
                                                            let _e1563 = (bitcast<f32>((((_e1538 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1292);
                                                            let _e1564 = (bitcast<f32>((((_e1538 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1302);
                                                            let _e1565 = (bitcast<f32>((((_e1538 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1312);
                                                            let _e1568 = nodes.member[(0u + _e1530)].frame[0u];
                                                            let _e1572 = nodes.member[(0u + _e1530)].frame[1u];
                                                            let _e1576 = nodes.member[(0u + _e1530)].frame[2u];
                                                            let _e1581 = ((bitcast<f32>(_e1568) - _e1077) * _e1292);
                                                            let _e1582 = ((bitcast<f32>(_e1572) - _e1090) * _e1302);
                                                            let _e1583 = ((bitcast<f32>(_e1576) - _e1103) * _e1312);
                                                            let _e1591 = nodes.member[(0u + _e1530)].x;
                                                            if (_e1292 < 0f) {
                                                                let _e1602 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1591.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1608 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1602.unnamed.word, _e1591.w), _e1602.unnamed_1);
                                                                let _e1614 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1608.unnamed, lt_mask_LightPlace(_e1591.x, _e1608.unnamed_1.shift));
                                                                phi_2224_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1614.unnamed, lt_mask_LightPlace(_e1614.unnamed_1.word, _e1591.y));
                                                            } else {
                                                                let _e1630 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1591.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1636 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1630.unnamed.word, _e1591.y), _e1630.unnamed_1);
                                                                let _e1642 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1636.unnamed, lt_mask_LightPlace(_e1591.z, _e1636.unnamed_1.shift));
                                                                phi_2224_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1642.unnamed, lt_mask_LightPlace(_e1642.unnamed_1.word, _e1591.w));
                                                            }
                                                            let _e1650 = phi_2224_;
                                                            let _e1660 = nodes.member[(0u + _e1530)].y;
                                                            if (_e1302 < 0f) {
                                                                let _e1671 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1660.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1677 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1671.unnamed.word, _e1660.w), _e1671.unnamed_1);
                                                                let _e1683 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1677.unnamed, lt_mask_LightPlace(_e1660.x, _e1677.unnamed_1.shift));
                                                                phi_2251_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1683.unnamed, lt_mask_LightPlace(_e1683.unnamed_1.word, _e1660.y));
                                                            } else {
                                                                let _e1699 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1660.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1705 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1699.unnamed.word, _e1660.y), _e1699.unnamed_1);
                                                                let _e1711 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1705.unnamed, lt_mask_LightPlace(_e1660.z, _e1705.unnamed_1.shift));
                                                                phi_2251_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1711.unnamed, lt_mask_LightPlace(_e1711.unnamed_1.word, _e1660.w));
                                                            }
                                                            let _e1719 = phi_2251_;
                                                            let _e1729 = nodes.member[(0u + _e1530)].z;
                                                            if (_e1312 < 0f) {
                                                                let _e1740 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1729.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1746 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1740.unnamed.word, _e1729.w), _e1740.unnamed_1);
                                                                let _e1752 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1746.unnamed, lt_mask_LightPlace(_e1729.x, _e1746.unnamed_1.shift));
                                                                phi_2278_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1752.unnamed, lt_mask_LightPlace(_e1752.unnamed_1.word, _e1729.y));
                                                            } else {
                                                                let _e1768 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1729.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1774 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1768.unnamed.word, _e1729.y), _e1768.unnamed_1);
                                                                let _e1780 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1774.unnamed, lt_mask_LightPlace(_e1729.z, _e1774.unnamed_1.shift));
                                                                phi_2278_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1780.unnamed, lt_mask_LightPlace(_e1780.unnamed_1.word, _e1729.w));
                                                            }
                                                            let _e1788 = phi_2278_;
                                                            phi_2284_ = 0u;
                                                            phi_2287_ = 0u;
                                                            loop {
                                                                let _e1798 = phi_2284_;
                                                                let _e1800 = phi_2287_;
                                                                local_7 = _e1800;
                                                                local_8 = _e1800;
                                                                local_9 = _e1800;
                                                                let _e1801 = (_e1798 < 8u);
                                                                if _e1801 {
                                                                    let _e1803 = (_e1798 >> bitcast<u32>(2i));
                                                                    let _e1804 = (_e1798 & 3u);
                                                                    if (_e1803 == 0u) {
                                                                        phi_2301_ = _e1650.unnamed.word;
                                                                    } else {
                                                                        phi_2301_ = _e1650.unnamed.shift;
                                                                    }
                                                                    let _e1807 = phi_2301_;
                                                                    if (_e1803 == 0u) {
                                                                        phi_2311_ = _e1719.unnamed.word;
                                                                    } else {
                                                                        phi_2311_ = _e1719.unnamed.shift;
                                                                    }
                                                                    let _e1816 = phi_2311_;
                                                                    if (_e1803 == 0u) {
                                                                        phi_2321_ = _e1788.unnamed.word;
                                                                    } else {
                                                                        phi_2321_ = _e1788.unnamed.shift;
                                                                    }
                                                                    let _e1825 = phi_2321_;
                                                                    let _e1838 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1807 >> bitcast<u32>(((_e1804 * 8u) & 31u))) & 255u)) * _e1563) + (_e1581 - _e1340)), ((f32(((_e1816 >> bitcast<u32>(((_e1804 * 8u) & 31u))) & 255u)) * _e1564) + (_e1582 - _e1341)));
                                                                    let _e1839 = core_intrinsics_maximum_number_nsz_f32_(_e1838, ((f32(((_e1825 >> bitcast<u32>(((_e1804 * 8u) & 31u))) & 255u)) * _e1565) + (_e1583 - _e1342)));
                                                                    if (_e1803 == 0u) {
                                                                        phi_2339_ = _e1650.unnamed_1.word;
                                                                    } else {
                                                                        phi_2339_ = _e1650.unnamed_1.shift;
                                                                    }
                                                                    let _e1842 = phi_2339_;
                                                                    if (_e1803 == 0u) {
                                                                        phi_2349_ = _e1719.unnamed_1.word;
                                                                    } else {
                                                                        phi_2349_ = _e1719.unnamed_1.shift;
                                                                    }
                                                                    let _e1851 = phi_2349_;
                                                                    if (_e1803 == 0u) {
                                                                        phi_2359_ = _e1788.unnamed_1.word;
                                                                    } else {
                                                                        phi_2359_ = _e1788.unnamed_1.shift;
                                                                    }
                                                                    let _e1860 = phi_2359_;
                                                                    let _e1873 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1842 >> bitcast<u32>(((_e1804 * 8u) & 31u))) & 255u)) * _e1563) + (_e1581 + _e1340)), ((f32(((_e1851 >> bitcast<u32>(((_e1804 * 8u) & 31u))) & 255u)) * _e1564) + (_e1582 + _e1341)));
                                                                    let _e1874 = core_intrinsics_minimum_number_nsz_f32_(_e1873, ((f32(((_e1860 >> bitcast<u32>(((_e1804 * 8u) & 31u))) & 255u)) * _e1565) + (_e1583 + _e1342)));
                                                                    if (_e1839 <= _e1874) {
                                                                        if (_e1839 <= _e1528.t) {
                                                                            if (_e1874 >= _e170.tmin) {
                                                                                if (_e1803 == 0u) {
                                                                                    let _e1881 = nodes.member[(0u + _e1530)].links[2u];
                                                                                    phi_2395_ = _e1881;
                                                                                } else {
                                                                                    let _e1884 = nodes.member[(0u + _e1530)].links[3u];
                                                                                    phi_2395_ = _e1884;
                                                                                }
                                                                                let _e1886 = phi_2395_;
                                                                                let _e1891 = ((_e1886 >> bitcast<u32>(((_e1804 * 8u) & 31u))) & 255u);
                                                                                let _e1892 = (_e1891 & 31u);
                                                                                if (_e1892 >= 24u) {
                                                                                    phi_2408_ = (24u + ((_e1892 - 24u) ^ _e1390));
                                                                                } else {
                                                                                    phi_2408_ = _e1892;
                                                                                }
                                                                                let _e1898 = phi_2408_;
                                                                                phi_2413_ = (_e1800 | ((_e1891 >> bitcast<u32>(5i)) << bitcast<u32>((_e1898 & 31u))));
                                                                            } else {
                                                                                phi_2413_ = _e1800;
                                                                            }
                                                                            let _e1906 = phi_2413_;
                                                                            phi_2414_ = _e1906;
                                                                        } else {
                                                                            phi_2414_ = _e1800;
                                                                        }
                                                                        let _e1908 = phi_2414_;
                                                                        phi_2415_ = _e1908;
                                                                    } else {
                                                                        phi_2415_ = _e1800;
                                                                    }
                                                                    let _e1910 = phi_2415_;
                                                                    phi_2285_ = (_e1798 + 1u);
                                                                    phi_2288_ = _e1910;
                                                                } else {
                                                                    phi_2285_ = u32();
                                                                    phi_2288_ = u32();
                                                                }
                                                                let _e1913 = phi_2285_;
                                                                let _e1915 = phi_2288_;
                                                                continue;
                                                                continuing {
                                                                    phi_2284_ = _e1913;
                                                                    phi_2287_ = _e1915;
                                                                    break if !(_e1801);
                                                                }
                                                            }
                                                            let _e1919 = nodes.member[(0u + _e1530)].links[0u];
                                                            let _e1923 = nodes.member[(0u + _e1530)].frame[3u];
                                                            let _e1927 = local_7;
                                                            if ((_e1927 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1931 = local_2.group_mask;
                                                                if ((_e1931 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1935 = local_2.len;
                                                                    if (_e1935 < 32u) {
                                                                        let _e1938 = local_2.group;
                                                                        let _e1940 = local_2.len;
                                                                        if (_e1940 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_2.first[(0u + _e1940)] = _e1938;
                                                                        let _e1946 = local_2.group_mask;
                                                                        let _e1948 = local_2.len;
                                                                        if (_e1948 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_2.mask[(0u + _e1948)] = _e1946;
                                                                        let _e1955 = local_2.len;
                                                                        local_2.len = (_e1955 + 1u);
                                                                    }
                                                                }
                                                                local_2.group = (_e1152 + _e1919);
                                                                let _e1959 = local_8;
                                                                local_2.group_mask = ((_e1959 & 4278190080u) | (_e1923 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1964 = local_9;
                                                            phi_2473_ = _e1528;
                                                            phi_2476_ = (_e1964 & 16777215u);
                                                            loop {
                                                                let _e1967 = phi_2473_;
                                                                let _e1969 = phi_2476_;
                                                                local_10 = _e1967;
                                                                if (_e1969 == 0u) {
                                                                    phi_2474_ = lt_bvh_Hit();
                                                                    phi_2477_ = u32();
                                                                    phi_3315_ = false;
                                                                } else {
                                                                    let _e1973 = nodes.member[(0u + _e1530)].links[1u];
                                                                    let _e1978 = ((_e1154 + _e1973) + select(firstTrailingBit(_e1969), 32u, (_e1969 == 0u)));
                                                                    if (_e1978 < _e83) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1985 = triangles.member[(0u + _e1978)].v0_;
                                                                    let _e1987 = (_e1985.x - _e1077);
                                                                    let _e1989 = (_e1985.y - _e1090);
                                                                    let _e1991 = (_e1985.z - _e1103);
                                                                    if (_e1363 == 0u) {
                                                                        phi_2521_ = vec3<f32>(_e1989, _e1991, _e1987);
                                                                    } else {
                                                                        if (_e1363 == 1u) {
                                                                            phi_2520_ = vec3<f32>(_e1991, _e1987, _e1989);
                                                                        } else {
                                                                            phi_2520_ = (_e1985 - vec3<f32>(_e1077, _e1090, _e1103));
                                                                        }
                                                                        let _e1999 = phi_2520_;
                                                                        phi_2521_ = _e1999;
                                                                    }
                                                                    let _e2001 = phi_2521_;
                                                                    let _e2005 = (_e2001.x - (_e1374 * _e2001.z));
                                                                    let _e2009 = (_e2001.y - (_e1377 * _e2001.z));
                                                                    let _e2011 = triangles.member[(0u + _e1978)].v1_;
                                                                    let _e2013 = (_e2011.x - _e1077);
                                                                    let _e2015 = (_e2011.y - _e1090);
                                                                    let _e2017 = (_e2011.z - _e1103);
                                                                    if (_e1363 == 0u) {
                                                                        phi_2551_ = vec3<f32>(_e2015, _e2017, _e2013);
                                                                    } else {
                                                                        if (_e1363 == 1u) {
                                                                            phi_2550_ = vec3<f32>(_e2017, _e2013, _e2015);
                                                                        } else {
                                                                            phi_2550_ = (_e2011 - vec3<f32>(_e1077, _e1090, _e1103));
                                                                        }
                                                                        let _e2025 = phi_2550_;
                                                                        phi_2551_ = _e2025;
                                                                    }
                                                                    let _e2027 = phi_2551_;
                                                                    let _e2031 = (_e2027.x - (_e1374 * _e2027.z));
                                                                    let _e2035 = (_e2027.y - (_e1377 * _e2027.z));
                                                                    let _e2037 = triangles.member[(0u + _e1978)].v2_;
                                                                    let _e2039 = (_e2037.x - _e1077);
                                                                    let _e2041 = (_e2037.y - _e1090);
                                                                    let _e2043 = (_e2037.z - _e1103);
                                                                    if (_e1363 == 0u) {
                                                                        phi_2581_ = vec3<f32>(_e2041, _e2043, _e2039);
                                                                    } else {
                                                                        if (_e1363 == 1u) {
                                                                            phi_2580_ = vec3<f32>(_e2043, _e2039, _e2041);
                                                                        } else {
                                                                            phi_2580_ = (_e2037 - vec3<f32>(_e1077, _e1090, _e1103));
                                                                        }
                                                                        let _e2051 = phi_2580_;
                                                                        phi_2581_ = _e2051;
                                                                    }
                                                                    let _e2053 = phi_2581_;
                                                                    let _e2057 = (_e2053.x - (_e1374 * _e2053.z));
                                                                    let _e2061 = (_e2053.y - (_e1377 * _e2053.z));
                                                                    if (_e2031 < _e2057) {
                                                                        phi_2600_ = true;
                                                                    } else {
                                                                        if (_e2031 == _e2057) {
                                                                            phi_2599_ = (_e2035 < _e2061);
                                                                        } else {
                                                                            phi_2599_ = false;
                                                                        }
                                                                        let _e2066 = phi_2599_;
                                                                        phi_2600_ = _e2066;
                                                                    }
                                                                    let _e2068 = phi_2600_;
                                                                    if _e2068 {
                                                                        phi_2604_ = _e2061;
                                                                        phi_2605_ = _e2057;
                                                                        phi_2606_ = _e2035;
                                                                        phi_2607_ = _e2031;
                                                                    } else {
                                                                        phi_2604_ = _e2035;
                                                                        phi_2605_ = _e2031;
                                                                        phi_2606_ = _e2061;
                                                                        phi_2607_ = _e2057;
                                                                    }
                                                                    let _e2070 = phi_2604_;
                                                                    let _e2072 = phi_2605_;
                                                                    let _e2074 = phi_2606_;
                                                                    let _e2076 = phi_2607_;
                                                                    let _e2079 = ((_e2076 * _e2070) - (_e2074 * _e2072));
                                                                    if _e2068 {
                                                                        phi_2615_ = -(_e2079);
                                                                    } else {
                                                                        phi_2615_ = _e2079;
                                                                    }
                                                                    let _e2082 = phi_2615_;
                                                                    if (_e2057 < _e2005) {
                                                                        phi_2626_ = true;
                                                                    } else {
                                                                        if (_e2057 == _e2005) {
                                                                            phi_2625_ = (_e2061 < _e2009);
                                                                        } else {
                                                                            phi_2625_ = false;
                                                                        }
                                                                        let _e2087 = phi_2625_;
                                                                        phi_2626_ = _e2087;
                                                                    }
                                                                    let _e2089 = phi_2626_;
                                                                    if _e2089 {
                                                                        phi_2630_ = _e2009;
                                                                        phi_2631_ = _e2005;
                                                                        phi_2632_ = _e2061;
                                                                        phi_2633_ = _e2057;
                                                                    } else {
                                                                        phi_2630_ = _e2061;
                                                                        phi_2631_ = _e2057;
                                                                        phi_2632_ = _e2009;
                                                                        phi_2633_ = _e2005;
                                                                    }
                                                                    let _e2091 = phi_2630_;
                                                                    let _e2093 = phi_2631_;
                                                                    let _e2095 = phi_2632_;
                                                                    let _e2097 = phi_2633_;
                                                                    let _e2100 = ((_e2097 * _e2091) - (_e2095 * _e2093));
                                                                    if _e2089 {
                                                                        phi_2641_ = -(_e2100);
                                                                    } else {
                                                                        phi_2641_ = _e2100;
                                                                    }
                                                                    let _e2103 = phi_2641_;
                                                                    if (_e2005 < _e2031) {
                                                                        phi_2652_ = true;
                                                                    } else {
                                                                        if (_e2005 == _e2031) {
                                                                            phi_2651_ = (_e2009 < _e2035);
                                                                        } else {
                                                                            phi_2651_ = false;
                                                                        }
                                                                        let _e2108 = phi_2651_;
                                                                        phi_2652_ = _e2108;
                                                                    }
                                                                    let _e2110 = phi_2652_;
                                                                    if _e2110 {
                                                                        phi_2656_ = _e2035;
                                                                        phi_2657_ = _e2031;
                                                                        phi_2658_ = _e2009;
                                                                        phi_2659_ = _e2005;
                                                                    } else {
                                                                        phi_2656_ = _e2009;
                                                                        phi_2657_ = _e2005;
                                                                        phi_2658_ = _e2035;
                                                                        phi_2659_ = _e2031;
                                                                    }
                                                                    let _e2112 = phi_2656_;
                                                                    let _e2114 = phi_2657_;
                                                                    let _e2116 = phi_2658_;
                                                                    let _e2118 = phi_2659_;
                                                                    let _e2121 = ((_e2118 * _e2112) - (_e2116 * _e2114));
                                                                    if _e2110 {
                                                                        phi_2667_ = -(_e2121);
                                                                    } else {
                                                                        phi_2667_ = _e2121;
                                                                    }
                                                                    let _e2124 = phi_2667_;
                                                                    if (_e2082 >= 0f) {
                                                                        if (_e2103 >= 0f) {
                                                                            if (_e2124 >= 0f) {
                                                                                phi_2682_ = ((_e2082 + _e2103) + _e2124);
                                                                                phi_2683_ = false;
                                                                            } else {
                                                                                phi_2682_ = f32();
                                                                                phi_2683_ = true;
                                                                            }
                                                                            let _e2131 = phi_2682_;
                                                                            let _e2133 = phi_2683_;
                                                                            phi_2684_ = _e2131;
                                                                            phi_2685_ = _e2133;
                                                                        } else {
                                                                            phi_2684_ = f32();
                                                                            phi_2685_ = true;
                                                                        }
                                                                        let _e2135 = phi_2684_;
                                                                        let _e2137 = phi_2685_;
                                                                        phi_2686_ = _e2135;
                                                                        phi_2687_ = _e2137;
                                                                    } else {
                                                                        phi_2686_ = f32();
                                                                        phi_2687_ = true;
                                                                    }
                                                                    let _e2139 = phi_2686_;
                                                                    let _e2141 = phi_2687_;
                                                                    if _e2141 {
                                                                        if (_e2082 <= 0f) {
                                                                            if (_e2103 <= 0f) {
                                                                                let _e2144 = (_e2124 <= 0f);
                                                                                if _e2144 {
                                                                                }
                                                                                phi_2705_ = ((_e2082 + _e2103) + _e2124);
                                                                                phi_2706_ = false;
                                                                                phi_2707_ = _e2144;
                                                                            } else {
                                                                                phi_2705_ = f32();
                                                                                phi_2706_ = true;
                                                                                phi_2707_ = false;
                                                                            }
                                                                            let _e2148 = phi_2705_;
                                                                            let _e2150 = phi_2706_;
                                                                            let _e2152 = phi_2707_;
                                                                            phi_2708_ = _e2148;
                                                                            phi_2709_ = _e2150;
                                                                            phi_2710_ = _e2152;
                                                                        } else {
                                                                            phi_2708_ = f32();
                                                                            phi_2709_ = true;
                                                                            phi_2710_ = false;
                                                                        }
                                                                        let _e2154 = phi_2708_;
                                                                        let _e2156 = phi_2709_;
                                                                        let _e2158 = phi_2710_;
                                                                        if _e2156 {
                                                                            phi_2714_ = false;
                                                                        } else {
                                                                            phi_2714_ = _e2158;
                                                                        }
                                                                        let _e2160 = phi_2714_;
                                                                        phi_2715_ = _e2154;
                                                                        phi_2716_ = _e2160;
                                                                    } else {
                                                                        phi_2715_ = _e2139;
                                                                        phi_2716_ = true;
                                                                    }
                                                                    let _e2162 = phi_2715_;
                                                                    let _e2164 = phi_2716_;
                                                                    if _e2164 {
                                                                        let _e2165 = (_e2162 == 0f);
                                                                        if _e2165 {
                                                                            phi_3032_ = lt_bvh_triangle_Intersection();
                                                                            phi_3033_ = false;
                                                                        } else {
                                                                            let _e2167 = triangles.member[(0u + _e1978)].v0_;
                                                                            let _e2169 = (_e2167.x - _e1077);
                                                                            let _e2171 = (_e2167.y - _e1090);
                                                                            let _e2173 = (_e2167.z - _e1103);
                                                                            if (_e1363 == 0u) {
                                                                                phi_2745_ = vec3<f32>(_e2171, _e2173, _e2169);
                                                                            } else {
                                                                                if (_e1363 == 1u) {
                                                                                    phi_2744_ = vec3<f32>(_e2173, _e2169, _e2171);
                                                                                } else {
                                                                                    phi_2744_ = (_e2167 - vec3<f32>(_e1077, _e1090, _e1103));
                                                                                }
                                                                                let _e2181 = phi_2744_;
                                                                                phi_2745_ = _e2181;
                                                                            }
                                                                            let _e2183 = phi_2745_;
                                                                            let _e2185 = triangles.member[(0u + _e1978)].v1_;
                                                                            let _e2187 = triangles.member[(0u + _e1978)].v0_;
                                                                            let _e2190 = (_e2185.x - _e2187.x);
                                                                            let _e2193 = (_e2185.y - _e2187.y);
                                                                            let _e2196 = (_e2185.z - _e2187.z);
                                                                            if (_e1363 == 0u) {
                                                                                phi_2771_ = vec3<f32>(_e2193, _e2196, _e2190);
                                                                            } else {
                                                                                if (_e1363 == 1u) {
                                                                                    phi_2770_ = vec3<f32>(_e2196, _e2190, _e2193);
                                                                                } else {
                                                                                    phi_2770_ = (_e2185 - _e2187);
                                                                                }
                                                                                let _e2203 = phi_2770_;
                                                                                phi_2771_ = _e2203;
                                                                            }
                                                                            let _e2205 = phi_2771_;
                                                                            let _e2207 = triangles.member[(0u + _e1978)].v2_;
                                                                            let _e2209 = triangles.member[(0u + _e1978)].v0_;
                                                                            let _e2212 = (_e2207.x - _e2209.x);
                                                                            let _e2215 = (_e2207.y - _e2209.y);
                                                                            let _e2218 = (_e2207.z - _e2209.z);
                                                                            if (_e1363 == 0u) {
                                                                                phi_2797_ = vec3<f32>(_e2215, _e2218, _e2212);
                                                                            } else {
                                                                                if (_e1363 == 1u) {
                                                                                    phi_2796_ = vec3<f32>(_e2218, _e2212, _e2215);
                                                                                } else {
                                                                                    phi_2796_ = (_e2207 - _e2209);
                                                                                }
                                                                                let _e2225 = phi_2796_;
                                                                                phi_2797_ = _e2225;
                                                                            }
                                                                            let _e2227 = phi_2797_;
                                                                            let _e2234 = ((_e2205.y * _e2227.z) - (_e2205.z * _e2227.y));
                                                                            let _e2241 = ((_e2205.z * _e2227.x) - (_e2205.x * _e2227.z));
                                                                            let _e2248 = ((_e2205.x * _e2227.y) - (_e2205.y * _e2227.x));
                                                                            let _e2262 = (((1f / _e1371.z) * (((_e2234 * _e2183.x) + (_e2241 * _e2183.y)) + (_e2248 * _e2183.z))) / (((_e2234 * _e1374) + (_e2241 * _e1377)) + _e2248));
                                                                            if (_e2262 > _e170.tmin) {
                                                                                if (_e2262 < _e170.tmax) {
                                                                                    let _e2266 = triangles.member[(0u + _e1978)].v0_;
                                                                                    let _e2268 = triangles.member[(0u + _e1978)].v1_;
                                                                                    if (_e2266.x < _e2268.x) {
                                                                                        phi_2853_ = _e2266.x;
                                                                                    } else {
                                                                                        phi_2853_ = _e2268.x;
                                                                                    }
                                                                                    let _e2275 = phi_2853_;
                                                                                    if (_e2266.y < _e2268.y) {
                                                                                        phi_2862_ = _e2266.y;
                                                                                    } else {
                                                                                        phi_2862_ = _e2268.y;
                                                                                    }
                                                                                    let _e2282 = phi_2862_;
                                                                                    if (_e2266.z < _e2268.z) {
                                                                                        phi_2871_ = _e2266.z;
                                                                                    } else {
                                                                                        phi_2871_ = _e2268.z;
                                                                                    }
                                                                                    let _e2289 = phi_2871_;
                                                                                    let _e2291 = triangles.member[(0u + _e1978)].v2_;
                                                                                    if (_e2275 < _e2291.x) {
                                                                                        phi_2880_ = _e2275;
                                                                                    } else {
                                                                                        phi_2880_ = _e2291.x;
                                                                                    }
                                                                                    let _e2296 = phi_2880_;
                                                                                    if (_e2282 < _e2291.y) {
                                                                                        phi_2887_ = _e2282;
                                                                                    } else {
                                                                                        phi_2887_ = _e2291.y;
                                                                                    }
                                                                                    let _e2301 = phi_2887_;
                                                                                    if (_e2289 < _e2291.z) {
                                                                                        phi_2894_ = _e2289;
                                                                                    } else {
                                                                                        phi_2894_ = _e2291.z;
                                                                                    }
                                                                                    let _e2306 = phi_2894_;
                                                                                    let _e2308 = triangles.member[(0u + _e1978)].v0_;
                                                                                    let _e2310 = triangles.member[(0u + _e1978)].v1_;
                                                                                    if (_e2308.x > _e2310.x) {
                                                                                        phi_2907_ = _e2308.x;
                                                                                    } else {
                                                                                        phi_2907_ = _e2310.x;
                                                                                    }
                                                                                    let _e2317 = phi_2907_;
                                                                                    if (_e2308.y > _e2310.y) {
                                                                                        phi_2916_ = _e2308.y;
                                                                                    } else {
                                                                                        phi_2916_ = _e2310.y;
                                                                                    }
                                                                                    let _e2324 = phi_2916_;
                                                                                    if (_e2308.z > _e2310.z) {
                                                                                        phi_2925_ = _e2308.z;
                                                                                    } else {
                                                                                        phi_2925_ = _e2310.z;
                                                                                    }
                                                                                    let _e2331 = phi_2925_;
                                                                                    let _e2333 = triangles.member[(0u + _e1978)].v2_;
                                                                                    if (_e2317 > _e2333.x) {
                                                                                        phi_2934_ = _e2317;
                                                                                    } else {
                                                                                        phi_2934_ = _e2333.x;
                                                                                    }
                                                                                    let _e2338 = phi_2934_;
                                                                                    if (_e2324 > _e2333.y) {
                                                                                        phi_2941_ = _e2324;
                                                                                    } else {
                                                                                        phi_2941_ = _e2333.y;
                                                                                    }
                                                                                    let _e2343 = phi_2941_;
                                                                                    if (_e2331 > _e2333.z) {
                                                                                        phi_2948_ = _e2331;
                                                                                    } else {
                                                                                        phi_2948_ = _e2333.z;
                                                                                    }
                                                                                    let _e2348 = phi_2948_;
                                                                                    let _e2352 = ((_e2296 - _e1077) * _e1292);
                                                                                    let _e2353 = ((_e2301 - _e1090) * _e1302);
                                                                                    let _e2354 = ((_e2306 - _e1103) * _e1312);
                                                                                    let _e2358 = ((_e2338 - _e1077) * _e1292);
                                                                                    let _e2359 = ((_e2343 - _e1090) * _e1302);
                                                                                    let _e2360 = ((_e2348 - _e1103) * _e1312);
                                                                                    if (_e2352 < _e2358) {
                                                                                        phi_2965_ = _e2352;
                                                                                    } else {
                                                                                        phi_2965_ = _e2358;
                                                                                    }
                                                                                    let _e2363 = phi_2965_;
                                                                                    if (_e2353 < _e2359) {
                                                                                        phi_2970_ = _e2353;
                                                                                    } else {
                                                                                        phi_2970_ = _e2359;
                                                                                    }
                                                                                    let _e2366 = phi_2970_;
                                                                                    if (_e2354 < _e2360) {
                                                                                        phi_2975_ = _e2354;
                                                                                    } else {
                                                                                        phi_2975_ = _e2360;
                                                                                    }
                                                                                    let _e2369 = phi_2975_;
                                                                                    if (_e2352 > _e2358) {
                                                                                        phi_2983_ = _e2352;
                                                                                    } else {
                                                                                        phi_2983_ = _e2358;
                                                                                    }
                                                                                    let _e2375 = phi_2983_;
                                                                                    if (_e2353 > _e2359) {
                                                                                        phi_2988_ = _e2353;
                                                                                    } else {
                                                                                        phi_2988_ = _e2359;
                                                                                    }
                                                                                    let _e2378 = phi_2988_;
                                                                                    if (_e2354 > _e2360) {
                                                                                        phi_2993_ = _e2354;
                                                                                    } else {
                                                                                        phi_2993_ = _e2360;
                                                                                    }
                                                                                    let _e2381 = phi_2993_;
                                                                                    let _e2385 = core_intrinsics_maximum_number_nsz_f32_((_e2363 - _e1347), (_e2366 - _e1348));
                                                                                    let _e2386 = core_intrinsics_maximum_number_nsz_f32_(_e2385, (_e2369 - _e1349));
                                                                                    let _e2387 = core_intrinsics_minimum_number_nsz_f32_((_e2375 + _e1347), (_e2378 + _e1348));
                                                                                    let _e2388 = core_intrinsics_minimum_number_nsz_f32_(_e2387, (_e2381 + _e1349));
                                                                                    if (_e2386 > _e1052) {
                                                                                        phi_3005_ = _e2386;
                                                                                    } else {
                                                                                        phi_3005_ = _e1052;
                                                                                    }
                                                                                    let _e2391 = phi_3005_;
                                                                                    if (_e2388 < _e1054) {
                                                                                        phi_3010_ = _e2388;
                                                                                    } else {
                                                                                        phi_3010_ = _e1054;
                                                                                    }
                                                                                    let _e2394 = phi_3010_;
                                                                                    if (_e2262 < _e2391) {
                                                                                        phi_3015_ = _e2391;
                                                                                    } else {
                                                                                        phi_3015_ = _e2262;
                                                                                    }
                                                                                    let _e2397 = phi_3015_;
                                                                                    if (_e2397 > _e2394) {
                                                                                        phi_3020_ = _e2394;
                                                                                    } else {
                                                                                        phi_3020_ = _e2397;
                                                                                    }
                                                                                    let _e2400 = phi_3020_;
                                                                                    phi_3025_ = lt_bvh_triangle_Intersection(_e2400, (_e2103 / _e2162), (_e2124 / _e2162), (_e2391 <= _e2394));
                                                                                    phi_3026_ = false;
                                                                                } else {
                                                                                    phi_3025_ = lt_bvh_triangle_Intersection();
                                                                                    phi_3026_ = true;
                                                                                }
                                                                                let _e2406 = phi_3025_;
                                                                                let _e2408 = phi_3026_;
                                                                                phi_3027_ = _e2406;
                                                                                phi_3028_ = _e2408;
                                                                            } else {
                                                                                phi_3027_ = lt_bvh_triangle_Intersection();
                                                                                phi_3028_ = true;
                                                                            }
                                                                            let _e2410 = phi_3027_;
                                                                            let _e2412 = phi_3028_;
                                                                            if _e2412 {
                                                                            }
                                                                            phi_3032_ = _e2410;
                                                                            phi_3033_ = _e2412;
                                                                        }
                                                                        let _e2414 = phi_3032_;
                                                                        let _e2416 = phi_3033_;
                                                                        phi_3034_ = _e2414;
                                                                        phi_3035_ = _e2165;
                                                                        phi_3036_ = _e2416;
                                                                    } else {
                                                                        phi_3034_ = lt_bvh_triangle_Intersection();
                                                                        phi_3035_ = true;
                                                                        phi_3036_ = false;
                                                                    }
                                                                    let _e2418 = phi_3034_;
                                                                    let _e2420 = phi_3035_;
                                                                    let _e2422 = phi_3036_;
                                                                    if _e2420 {
                                                                        phi_3040_ = true;
                                                                    } else {
                                                                        phi_3040_ = _e2422;
                                                                    }
                                                                    let _e2424 = phi_3040_;
                                                                    if _e2424 {
                                                                        phi_3044_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_3044_ = _e2418;
                                                                    }
                                                                    let _e2426 = phi_3044_;
                                                                    if _e2426.is_hit {
                                                                        if (_e2426.t > _e170.tmin) {
                                                                            if (_e2426.t < _e1967.t) {
                                                                                phi_3092_ = true;
                                                                            } else {
                                                                                if (_e2426.t == _e1967.t) {
                                                                                    if (_e1967.triangle != 4294967295u) {
                                                                                        if (_e1978 < _e1967.triangle) {
                                                                                            phi_3083_ = true;
                                                                                        } else {
                                                                                            if (_e1978 == _e1967.triangle) {
                                                                                                phi_3082_ = (_e993 < _e1967.instance);
                                                                                            } else {
                                                                                                phi_3082_ = false;
                                                                                            }
                                                                                            let _e2444 = phi_3082_;
                                                                                            phi_3083_ = _e2444;
                                                                                        }
                                                                                        let _e2446 = phi_3083_;
                                                                                        phi_3084_ = _e2446;
                                                                                        phi_3085_ = false;
                                                                                    } else {
                                                                                        phi_3084_ = bool();
                                                                                        phi_3085_ = true;
                                                                                    }
                                                                                    let _e2448 = phi_3084_;
                                                                                    let _e2450 = phi_3085_;
                                                                                    phi_3086_ = _e2448;
                                                                                    phi_3087_ = _e2450;
                                                                                } else {
                                                                                    phi_3086_ = bool();
                                                                                    phi_3087_ = true;
                                                                                }
                                                                                let _e2452 = phi_3086_;
                                                                                let _e2454 = phi_3087_;
                                                                                if _e2454 {
                                                                                    phi_3091_ = false;
                                                                                } else {
                                                                                    phi_3091_ = _e2452;
                                                                                }
                                                                                let _e2456 = phi_3091_;
                                                                                phi_3092_ = _e2456;
                                                                            }
                                                                            let _e2458 = phi_3092_;
                                                                            if _e2458 {
                                                                                let _e2460 = triangles.member[(0u + _e1978)].i0_;
                                                                                if ((_e2460 & 2147483648u) == 0u) {
                                                                                    phi_3303_ = true;
                                                                                } else {
                                                                                    if (_e1978 < _e83) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2469 = triangles.member[(0u + _e1978)].i0_;
                                                                                    let _e2470 = (_e2469 & 2147483647u);
                                                                                    let _e2472 = triangles.member[(0u + _e1978)].i1_;
                                                                                    let _e2474 = triangles.member[(0u + _e1978)].i2_;
                                                                                    if (_e2470 < _e86) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2478 = vertices.member[(0u + _e2470)];
                                                                                    if (_e2472 < _e86) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2482 = vertices.member[(0u + _e2472)];
                                                                                    if (_e2474 < _e86) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2486 = vertices.member[(0u + _e2474)];
                                                                                    let _e2487 = array<abi_Vertex, 3>(_e2478, _e2482, _e2486);
                                                                                    if (_e2487[0].material < _e89) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2493 = materials.member[(0u + _e2487[0].material)];
                                                                                    if ((_e2493.flags & 0u) == 0u) {
                                                                                        let _e2498 = ((1f - _e2426.u) - _e2426.v);
                                                                                        if (_e2493.cutoff <= 0f) {
                                                                                            phi_3298_ = true;
                                                                                        } else {
                                                                                            let _e2525 = (_e2493.base_color.w * ((((f32((_e2487[0].color >> bitcast<u32>(24i))) * _e2498) + (f32((_e2487[1].color >> bitcast<u32>(24i))) * _e2426.u)) + (f32((_e2487[2].color >> bitcast<u32>(24i))) * _e2426.v)) * (1f / 255f)));
                                                                                            if (_e2493.alpha_size == 0u) {
                                                                                                phi_3295_ = _e2525;
                                                                                            } else {
                                                                                                local_1.offset = _e2493.alpha_offset;
                                                                                                local_1.size = _e2493.alpha_size;
                                                                                                local_1.flags = _e2493.flags;
                                                                                                let _e2556 = _lt_shaders_texture_TextureView_quad((&local_1), (((_e2487[0].u * _e2498) + (_e2487[1].u * _e2426.u)) + (_e2487[2].u * _e2426.v)), (((_e2487[0].v * _e2498) + (_e2487[1].v * _e2426.u)) + (_e2487[2].v * _e2426.v)));
                                                                                                let _e2560 = (_e2556.indices[0] >> bitcast<u32>(2i));
                                                                                                if (_e2560 < _e98) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2564 = alpha_texels.member[(0u + _e2560)];
                                                                                                let _e2580 = (_e2556.indices[1] >> bitcast<u32>(2i));
                                                                                                if (_e2580 < _e98) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2584 = alpha_texels.member[(0u + _e2580)];
                                                                                                let _e2601 = (_e2556.indices[2] >> bitcast<u32>(2i));
                                                                                                if (_e2601 < _e98) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2605 = alpha_texels.member[(0u + _e2601)];
                                                                                                let _e2622 = (_e2556.indices[3] >> bitcast<u32>(2i));
                                                                                                if (_e2622 < _e98) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2626 = alpha_texels.member[(0u + _e2622)];
                                                                                                phi_3295_ = (_e2525 * (((((f32(((_e2564 >> bitcast<u32>((((_e2556.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2556.weights.x) + ((f32(((_e2584 >> bitcast<u32>((((_e2556.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2556.weights.y)) + ((f32(((_e2605 >> bitcast<u32>((((_e2556.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2556.weights.z)) + ((f32(((_e2626 >> bitcast<u32>((((_e2556.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2556.weights.w)));
                                                                                            }
                                                                                            let _e2642 = phi_3295_;
                                                                                            phi_3298_ = (_e2642 >= _e2493.cutoff);
                                                                                        }
                                                                                        let _e2646 = phi_3298_;
                                                                                        phi_3299_ = _e2646;
                                                                                    } else {
                                                                                        phi_3299_ = false;
                                                                                    }
                                                                                    let _e2648 = phi_3299_;
                                                                                    if _e2648 {
                                                                                    }
                                                                                    phi_3303_ = _e2648;
                                                                                }
                                                                                let _e2650 = phi_3303_;
                                                                                if _e2650 {
                                                                                    phi_3311_ = lt_bvh_Hit(_e2426.t, _e2426.u, _e2426.v, _e1978, _e993);
                                                                                } else {
                                                                                    phi_3311_ = _e1967;
                                                                                }
                                                                                let _e2656 = phi_3311_;
                                                                                phi_3312_ = _e2656;
                                                                            } else {
                                                                                phi_3312_ = _e1967;
                                                                            }
                                                                            let _e2658 = phi_3312_;
                                                                            phi_3313_ = _e2658;
                                                                        } else {
                                                                            phi_3313_ = _e1967;
                                                                        }
                                                                        let _e2660 = phi_3313_;
                                                                        phi_3314_ = _e2660;
                                                                    } else {
                                                                        phi_3314_ = _e1967;
                                                                    }
                                                                    let _e2662 = phi_3314_;
                                                                    phi_2474_ = _e2662;
                                                                    phi_2477_ = (_e1969 & (_e1969 - 1u));
                                                                    phi_3315_ = true;
                                                                }
                                                                let _e2664 = phi_2474_;
                                                                let _e2666 = phi_2477_;
                                                                let _e2668 = phi_3315_;
                                                                continue;
                                                                continuing {
                                                                    phi_2473_ = _e2664;
                                                                    phi_2476_ = _e2666;
                                                                    break if !(_e2668);
                                                                }
                                                            }
                                                            let _e2671 = local_2.group_mask;
                                                            if ((_e2671 & 4278190080u) == 0u) {
                                                                let _e2675 = local_2.len;
                                                                if (_e2675 == 0u) {
                                                                    phi_3354_ = false;
                                                                } else {
                                                                    let _e2679 = local_2.len;
                                                                    local_2.len = (_e2679 - 1u);
                                                                    let _e2682 = local_2.len;
                                                                    if (_e2682 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2687 = local_2.first[(0u + _e2682)];
                                                                    local_2.group = _e2687;
                                                                    let _e2690 = local_2.len;
                                                                    if (_e2690 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2695 = local_2.mask[(0u + _e2690)];
                                                                    local_2.group_mask = _e2695;
                                                                    phi_3354_ = true;
                                                                }
                                                                let _e2698 = phi_3354_;
                                                                phi_3355_ = _e2698;
                                                            } else {
                                                                phi_3355_ = true;
                                                            }
                                                            let _e2700 = phi_3355_;
                                                            if _e2700 {
                                                                let _e2702 = local_2.group_mask;
                                                                let _e2708 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2702)), 32u, (_e2702 == 0u)));
                                                                let _e2712 = local_2.group_mask;
                                                                let _e2726 = local_2.group_mask;
                                                                local_2.group_mask = (_e2726 & ~((1u << bitcast<u32>((_e2708 & 31u)))));
                                                                let _e2729 = local_2.group;
                                                                phi_3386_ = (_e2729 + countOneBits(((_e2712 & ~((4294967295u << bitcast<u32>((((_e2708 - 24u) ^ _e1390) & 31u))))) & 255u)));
                                                            } else {
                                                                phi_3386_ = 4294967295u;
                                                            }
                                                            let _e2732 = phi_3386_;
                                                            let _e4058 = local_10;
                                                            phi_2141_ = _e4058;
                                                            phi_2144_ = _e2732;
                                                        } else {
                                                            phi_2141_ = lt_bvh_Hit();
                                                            phi_2144_ = u32();
                                                        }
                                                        let _e2734 = phi_2141_;
                                                        let _e2736 = phi_2144_;
                                                        continue;
                                                        continuing {
                                                            phi_2140_ = _e2734;
                                                            phi_2143_ = _e2736;
                                                            break if !(_e1531);
                                                        }
                                                    }
                                                    let _e4062 = local_11;
                                                    phi_3387_ = _e4062;
                                                }
                                                let _e2739 = phi_3387_;
                                                phi_3388_ = _e2739;
                                                phi_3389_ = _e1216;
                                            } else {
                                                phi_3388_ = lt_bvh_Hit();
                                                phi_3389_ = true;
                                            }
                                            let _e2741 = phi_3388_;
                                            let _e2743 = phi_3389_;
                                            if _e2743 {
                                                phi_3393_ = _e985;
                                            } else {
                                                phi_3393_ = _e2741;
                                            }
                                            let _e2745 = phi_3393_;
                                            phi_3394_ = _e2745;
                                        } else {
                                            phi_3394_ = _e985;
                                        }
                                        let _e2747 = phi_3394_;
                                        phi_3395_ = _e2747;
                                    } else {
                                        phi_3395_ = _e985;
                                    }
                                    let _e2749 = phi_3395_;
                                    phi_3396_ = _e2749;
                                } else {
                                    phi_3396_ = _e985;
                                }
                                let _e2751 = phi_3396_;
                                phi_1515_ = (_e983 & (_e983 - 1u));
                                phi_1518_ = _e2751;
                                phi_3397_ = true;
                            }
                            let _e2753 = phi_1515_;
                            let _e2755 = phi_1518_;
                            let _e2757 = phi_3397_;
                            continue;
                            continuing {
                                phi_1514_ = _e2753;
                                phi_1517_ = _e2755;
                                break if !(_e2757);
                            }
                        }
                        let _e2760 = local_3.group_mask;
                        if ((_e2760 & 4278190080u) == 0u) {
                            let _e2764 = local_3.len;
                            if (_e2764 == 0u) {
                                phi_3436_ = false;
                            } else {
                                let _e2768 = local_3.len;
                                local_3.len = (_e2768 - 1u);
                                let _e2771 = local_3.len;
                                if (_e2771 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2776 = local_3.first[(0u + _e2771)];
                                local_3.group = _e2776;
                                let _e2779 = local_3.len;
                                if (_e2779 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2784 = local_3.mask[(0u + _e2779)];
                                local_3.group_mask = _e2784;
                                phi_3436_ = true;
                            }
                            let _e2787 = phi_3436_;
                            phi_3437_ = _e2787;
                        } else {
                            phi_3437_ = true;
                        }
                        let _e2789 = phi_3437_;
                        if _e2789 {
                            let _e2791 = local_3.group_mask;
                            let _e2797 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2791)), 32u, (_e2791 == 0u)));
                            let _e2801 = local_3.group_mask;
                            let _e2815 = local_3.group_mask;
                            local_3.group_mask = (_e2815 & ~((1u << bitcast<u32>((_e2797 & 31u)))));
                            let _e2818 = local_3.group;
                            phi_3468_ = (_e2818 + countOneBits(((_e2801 & ~((4294967295u << bitcast<u32>((((_e2797 - 24u) ^ _e402) & 31u))))) & 255u)));
                        } else {
                            phi_3468_ = 4294967295u;
                        }
                        let _e2821 = phi_3468_;
                        phi_1178_ = _e2821;
                        let _e4078 = local_12;
                        phi_1181_ = _e4078;
                    } else {
                        phi_1178_ = u32();
                        phi_1181_ = lt_bvh_Hit();
                    }
                    let _e2823 = phi_1178_;
                    let _e2825 = phi_1181_;
                    continue;
                    continuing {
                        phi_1177_ = _e2823;
                        phi_1180_ = _e2825;
                        break if !(_e543);
                    }
                }
                let _e4081 = local_13;
                phi_3469_ = _e4081;
            }
            let _e2828 = phi_3469_;
            phi_3470_ = _e2828;
            phi_3471_ = _e242;
        } else {
            phi_3470_ = lt_bvh_Hit();
            phi_3471_ = true;
        }
        let _e2830 = phi_3470_;
        let _e2832 = phi_3471_;
        if _e2832 {
            phi_3475_ = _e172;
        } else {
            phi_3475_ = _e2830;
        }
        let _e2834 = phi_3475_;
        if (_e2834.triangle != 4294967295u) {
            let _e2840 = ((1f - _e2834.u) - _e2834.v);
            if (_e2834.triangle < _e83) {
            } else {
                return;
            }
            let _e2845 = triangles.member[(0u + _e2834.triangle)];
            if (_e2834.instance < _e95) {
            } else {
                return;
            }
            let _e2856 = instances.member[(0u + _e2834.instance)].object_to_world[0u];
            let _e2867 = ((((_e2856.x * _e2845.v0_.x) + (_e2856.y * _e2845.v0_.y)) + (_e2856.z * _e2845.v0_.z)) + (_e2856.w * 1f));
            let _e2869 = instances.member[(0u + _e2834.instance)].object_to_world[1u];
            let _e2880 = ((((_e2869.x * _e2845.v0_.x) + (_e2869.y * _e2845.v0_.y)) + (_e2869.z * _e2845.v0_.z)) + (_e2869.w * 1f));
            let _e2882 = instances.member[(0u + _e2834.instance)].object_to_world[2u];
            let _e2893 = ((((_e2882.x * _e2845.v0_.x) + (_e2882.y * _e2845.v0_.y)) + (_e2882.z * _e2845.v0_.z)) + (_e2882.w * 1f));
            let _e2900 = instances.member[(0u + _e2834.instance)].object_to_world[0u];
            let _e2911 = ((((_e2900.x * _e2845.v1_.x) + (_e2900.y * _e2845.v1_.y)) + (_e2900.z * _e2845.v1_.z)) + (_e2900.w * 1f));
            let _e2913 = instances.member[(0u + _e2834.instance)].object_to_world[1u];
            let _e2924 = ((((_e2913.x * _e2845.v1_.x) + (_e2913.y * _e2845.v1_.y)) + (_e2913.z * _e2845.v1_.z)) + (_e2913.w * 1f));
            let _e2926 = instances.member[(0u + _e2834.instance)].object_to_world[2u];
            let _e2937 = ((((_e2926.x * _e2845.v1_.x) + (_e2926.y * _e2845.v1_.y)) + (_e2926.z * _e2845.v1_.z)) + (_e2926.w * 1f));
            let _e2944 = instances.member[(0u + _e2834.instance)].object_to_world[0u];
            let _e2955 = ((((_e2944.x * _e2845.v2_.x) + (_e2944.y * _e2845.v2_.y)) + (_e2944.z * _e2845.v2_.z)) + (_e2944.w * 1f));
            let _e2957 = instances.member[(0u + _e2834.instance)].object_to_world[1u];
            let _e2968 = ((((_e2957.x * _e2845.v2_.x) + (_e2957.y * _e2845.v2_.y)) + (_e2957.z * _e2845.v2_.z)) + (_e2957.w * 1f));
            let _e2970 = instances.member[(0u + _e2834.instance)].object_to_world[2u];
            let _e2981 = ((((_e2970.x * _e2845.v2_.x) + (_e2970.y * _e2845.v2_.y)) + (_e2970.z * _e2845.v2_.z)) + (_e2970.w * 1f));
            let _e2994 = (((_e2867 * _e2840) + (_e2911 * _e2834.u)) + (_e2955 * _e2834.v));
            let _e2995 = (((_e2880 * _e2840) + (_e2924 * _e2834.u)) + (_e2968 * _e2834.v));
            let _e2996 = (((_e2893 * _e2840) + (_e2937 * _e2834.u)) + (_e2981 * _e2834.v));
            let _e2998 = abs(_e2867);
            let _e2999 = abs(_e2880);
            let _e3000 = abs(_e2893);
            let _e3001 = abs(_e2911);
            let _e3002 = abs(_e2924);
            let _e3003 = abs(_e2937);
            if (_e2998 > _e3001) {
                phi_3662_ = _e2998;
            } else {
                phi_3662_ = _e3001;
            }
            let _e3006 = phi_3662_;
            if (_e2999 > _e3002) {
                phi_3667_ = _e2999;
            } else {
                phi_3667_ = _e3002;
            }
            let _e3009 = phi_3667_;
            if (_e3000 > _e3003) {
                phi_3672_ = _e3000;
            } else {
                phi_3672_ = _e3003;
            }
            let _e3012 = phi_3672_;
            let _e3013 = abs(_e2955);
            let _e3014 = abs(_e2968);
            let _e3015 = abs(_e2981);
            if (_e3006 > _e3013) {
                phi_3680_ = _e3006;
            } else {
                phi_3680_ = _e3013;
            }
            let _e3018 = phi_3680_;
            if (_e3009 > _e3014) {
                phi_3685_ = _e3009;
            } else {
                phi_3685_ = _e3014;
            }
            let _e3021 = phi_3685_;
            if (_e3012 > _e3015) {
                phi_3690_ = _e3012;
            } else {
                phi_3690_ = _e3015;
            }
            let _e3024 = phi_3690_;
            let _e3025 = (_e2911 - _e2867);
            let _e3026 = (_e2924 - _e2880);
            let _e3027 = (_e2937 - _e2893);
            let _e3028 = (_e2955 - _e2867);
            let _e3029 = (_e2968 - _e2880);
            let _e3030 = (_e2981 - _e2893);
            let _e3034 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3026), abs(_e3027));
            let _e3035 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3025), _e3034);
            let _e3036 = (_e3025 / _e3035);
            let _e3037 = (_e3026 / _e3035);
            let _e3038 = (_e3027 / _e3035);
            let _e3042 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3029), abs(_e3030));
            let _e3043 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3028), _e3042);
            let _e3044 = (_e3028 / _e3043);
            let _e3045 = (_e3029 / _e3043);
            let _e3046 = (_e3030 / _e3043);
            let _e3049 = ((_e3037 * _e3046) - (_e3045 * _e3038));
            let _e3052 = ((_e3038 * _e3044) - (_e3046 * _e3036));
            let _e3055 = ((_e3036 * _e3045) - (_e3044 * _e3037));
            let _e3057 = p.member.eye;
            let _e3070 = (1f / sqrt((((_e3049 * _e3049) + (_e3052 * _e3052)) + (_e3055 * _e3055))));
            let _e3071 = (_e3049 * _e3070);
            let _e3072 = (_e3052 * _e3070);
            let _e3073 = (_e3055 * _e3070);
            if ((((_e3071 * (_e3057.x - _e2994)) + (_e3072 * (_e3057.y - _e2995))) + (_e3073 * (_e3057.z - _e2996))) < 0f) {
                phi_3754_ = vec3<f32>(-(_e3071), -(_e3072), -(_e3073));
            } else {
                phi_3754_ = vec3<f32>(_e3071, _e3072, _e3073);
            }
            let _e3086 = phi_3754_;
            if (_e2834.triangle < _e83) {
            } else {
                return;
            }
            let _e3091 = triangles.member[(0u + _e2834.triangle)];
            let _e3093 = (_e3091.i0_ & 2147483647u);
            if (_e3093 < _e86) {
            } else {
                return;
            }
            let _e3099 = vertices.member[(0u + _e3093)];
            if (_e3091.i1_ < _e86) {
            } else {
                return;
            }
            let _e3103 = vertices.member[(0u + _e3091.i1_)];
            if (_e3091.i2_ < _e86) {
            } else {
                return;
            }
            let _e3107 = vertices.member[(0u + _e3091.i2_)];
            let _e3108 = array<abi_Vertex, 3>(_e3099, _e3103, _e3107);
            if (_e3108[0].material < _e89) {
            } else {
                return;
            }
            let _e3114 = materials.member[(0u + _e3108[0].material)];
            let _e3131 = (1f / 255f);
            let _e3150 = (1f / 255f);
            let _e3172 = (1f / 255f);
            if (_e3114.color_size == 0u) {
                phi_3997_ = vec3<f32>(1f, 1f, 1f);
            } else {
                local.offset = _e3114.color_offset;
                local.size = _e3114.color_size;
                local.flags = _e3114.flags;
                let _e3215 = _lt_shaders_texture_TextureView_quad((&local), (((_e3108[0].u * _e2840) + (_e3108[1].u * _e2834.u)) + (_e3108[2].u * _e2834.v)), (((_e3108[0].v * _e2840) + (_e3108[1].v * _e2834.u)) + (_e3108[2].v * _e2834.v)));
                if (_e3215.indices[0] < _e101) {
                } else {
                    return;
                }
                let _e3221 = color_texels.member[(0u + _e3215.indices[0])];
                let _e3232 = (1f / 255f);
                if (_e3215.indices[1] < _e101) {
                } else {
                    return;
                }
                let _e3246 = color_texels.member[(0u + _e3215.indices[1])];
                let _e3257 = (1f / 255f);
                if (_e3215.indices[2] < _e101) {
                } else {
                    return;
                }
                let _e3274 = color_texels.member[(0u + _e3215.indices[2])];
                let _e3285 = (1f / 255f);
                if (_e3215.indices[3] < _e101) {
                } else {
                    return;
                }
                let _e3302 = color_texels.member[(0u + _e3215.indices[3])];
                let _e3313 = (1f / 255f);
                let _e3322 = (((((f32((_e3221 & 255u)) * _e3232) * _e3215.weights.x) + ((f32((_e3246 & 255u)) * _e3257) * _e3215.weights.y)) + ((f32((_e3274 & 255u)) * _e3285) * _e3215.weights.z)) + ((f32((_e3302 & 255u)) * _e3313) * _e3215.weights.w));
                let _e3323 = (((((f32(((_e3221 >> bitcast<u32>(8i)) & 255u)) * _e3232) * _e3215.weights.x) + ((f32(((_e3246 >> bitcast<u32>(8i)) & 255u)) * _e3257) * _e3215.weights.y)) + ((f32(((_e3274 >> bitcast<u32>(8i)) & 255u)) * _e3285) * _e3215.weights.z)) + ((f32(((_e3302 >> bitcast<u32>(8i)) & 255u)) * _e3313) * _e3215.weights.w));
                let _e3324 = (((((f32(((_e3221 >> bitcast<u32>(16i)) & 255u)) * _e3232) * _e3215.weights.x) + ((f32(((_e3246 >> bitcast<u32>(16i)) & 255u)) * _e3257) * _e3215.weights.y)) + ((f32(((_e3274 >> bitcast<u32>(16i)) & 255u)) * _e3285) * _e3215.weights.z)) + ((f32(((_e3302 >> bitcast<u32>(16i)) & 255u)) * _e3313) * _e3215.weights.w));
                phi_3997_ = vec3<f32>((_e3322 * _e3322), (_e3323 * _e3323), (_e3324 * _e3324));
            }
            let _e3330 = phi_3997_;
            let _e3332 = ((_e3114.base_color.x * ((((f32((_e3108[0].color & 255u)) * _e3131) * _e2840) + ((f32((_e3108[1].color & 255u)) * _e3150) * _e2834.u)) + ((f32((_e3108[2].color & 255u)) * _e3172) * _e2834.v))) * _e3330.x);
            let _e3334 = ((_e3114.base_color.y * ((((f32(((_e3108[0].color >> bitcast<u32>(8i)) & 255u)) * _e3131) * _e2840) + ((f32(((_e3108[1].color >> bitcast<u32>(8i)) & 255u)) * _e3150) * _e2834.u)) + ((f32(((_e3108[2].color >> bitcast<u32>(8i)) & 255u)) * _e3172) * _e2834.v))) * _e3330.y);
            let _e3336 = ((_e3114.base_color.z * ((((f32(((_e3108[0].color >> bitcast<u32>(16i)) & 255u)) * _e3131) * _e2840) + ((f32(((_e3108[1].color >> bitcast<u32>(16i)) & 255u)) * _e3150) * _e2834.u)) + ((f32(((_e3108[2].color >> bitcast<u32>(16i)) & 255u)) * _e3172) * _e2834.v))) * _e3330.z);
            let _e3337 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e3021, _e3024);
            let _e3338 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e3018, _e3337);
            if ((_e3114.flags & 2u) == 0u) {
                phi_4012_ = 0u;
            } else {
                phi_4012_ = 1u;
            }
            let _e3343 = phi_4012_;
            if (_e3108[0].normal == 2147516416u) {
                phi_4242_ = _e3086;
            } else {
                let _e3356 = (f32((bitcast<i32>((_e3108[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3362 = (f32((bitcast<i32>(_e3108[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3366 = ((1f - abs(_e3356)) - abs(_e3362));
                if (_e3366 < 0f) {
                    phi_4039_ = -(_e3366);
                } else {
                    phi_4039_ = 0f;
                }
                let _e3370 = phi_4039_;
                if (_e3356 < 0f) {
                    phi_4046_ = (_e3356 + _e3370);
                } else {
                    phi_4046_ = (_e3356 - _e3370);
                }
                let _e3375 = phi_4046_;
                if (_e3362 < 0f) {
                    phi_4053_ = (_e3362 + _e3370);
                } else {
                    phi_4053_ = (_e3362 - _e3370);
                }
                let _e3380 = phi_4053_;
                let _e3387 = (1f / sqrt((((_e3375 * _e3375) + (_e3380 * _e3380)) + (_e3366 * _e3366))));
                let _e3403 = (f32((bitcast<i32>((_e3108[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3409 = (f32((bitcast<i32>(_e3108[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3413 = ((1f - abs(_e3403)) - abs(_e3409));
                if (_e3413 < 0f) {
                    phi_4088_ = -(_e3413);
                } else {
                    phi_4088_ = 0f;
                }
                let _e3417 = phi_4088_;
                if (_e3403 < 0f) {
                    phi_4095_ = (_e3403 + _e3417);
                } else {
                    phi_4095_ = (_e3403 - _e3417);
                }
                let _e3422 = phi_4095_;
                if (_e3409 < 0f) {
                    phi_4102_ = (_e3409 + _e3417);
                } else {
                    phi_4102_ = (_e3409 - _e3417);
                }
                let _e3427 = phi_4102_;
                let _e3434 = (1f / sqrt((((_e3422 * _e3422) + (_e3427 * _e3427)) + (_e3413 * _e3413))));
                let _e3453 = (f32((bitcast<i32>((_e3108[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3459 = (f32((bitcast<i32>(_e3108[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3463 = ((1f - abs(_e3453)) - abs(_e3459));
                if (_e3463 < 0f) {
                    phi_4140_ = -(_e3463);
                } else {
                    phi_4140_ = 0f;
                }
                let _e3467 = phi_4140_;
                if (_e3453 < 0f) {
                    phi_4147_ = (_e3453 + _e3467);
                } else {
                    phi_4147_ = (_e3453 - _e3467);
                }
                let _e3472 = phi_4147_;
                if (_e3459 < 0f) {
                    phi_4154_ = (_e3459 + _e3467);
                } else {
                    phi_4154_ = (_e3459 - _e3467);
                }
                let _e3477 = phi_4154_;
                let _e3484 = (1f / sqrt((((_e3472 * _e3472) + (_e3477 * _e3477)) + (_e3463 * _e3463))));
                let _e3491 = ((((_e3375 * _e3387) * _e2840) + ((_e3422 * _e3434) * _e2834.u)) + ((_e3472 * _e3484) * _e2834.v));
                let _e3492 = ((((_e3380 * _e3387) * _e2840) + ((_e3427 * _e3434) * _e2834.u)) + ((_e3477 * _e3484) * _e2834.v));
                let _e3493 = ((((_e3366 * _e3387) * _e2840) + ((_e3413 * _e3434) * _e2834.u)) + ((_e3463 * _e3484) * _e2834.v));
                if (_e2834.instance < _e95) {
                } else {
                    return;
                }
                let _e3500 = instances.member[(0u + _e2834.instance)].world_to_object[0u];
                let _e3509 = instances.member[(0u + _e2834.instance)].world_to_object[1u];
                let _e3521 = instances.member[(0u + _e2834.instance)].world_to_object[2u];
                let _e3528 = (((_e3500.x * _e3491) + (_e3509.x * _e3492)) + (_e3521.x * _e3493));
                let _e3529 = (((_e3500.y * _e3491) + (_e3509.y * _e3492)) + (_e3521.y * _e3493));
                let _e3530 = (((_e3500.z * _e3491) + (_e3509.z * _e3492)) + (_e3521.z * _e3493));
                let _e3536 = sqrt((((_e3528 * _e3528) + (_e3529 * _e3529)) + (_e3530 * _e3530)));
                if (_e3536 > 0f) {
                    let _e3538 = (_e3528 / _e3536);
                    let _e3539 = (_e3529 / _e3536);
                    let _e3540 = (_e3530 / _e3536);
                    if ((((_e3538 * _e3086.x) + (_e3539 * _e3086.y)) + (_e3540 * _e3086.z)) < 0f) {
                        phi_4240_ = vec3<f32>(-(_e3538), -(_e3539), -(_e3540));
                    } else {
                        phi_4240_ = vec3<f32>(_e3538, _e3539, _e3540);
                    }
                    let _e3556 = phi_4240_;
                    phi_4241_ = _e3556;
                } else {
                    phi_4241_ = _e3086;
                }
                let _e3558 = phi_4241_;
                phi_4242_ = _e3558;
            }
            let _e3560 = phi_4242_;
            if (_e3332 > 0f) {
                if (_e3332 < 1f) {
                    phi_4251_ = _e3332;
                } else {
                    phi_4251_ = 1f;
                }
                let _e3564 = phi_4251_;
                phi_4252_ = _e3564;
            } else {
                phi_4252_ = 0f;
            }
            let _e3566 = phi_4252_;
            if (_e3334 > 0f) {
                if (_e3334 < 1f) {
                    phi_4262_ = _e3334;
                } else {
                    phi_4262_ = 1f;
                }
                let _e3571 = phi_4262_;
                phi_4263_ = _e3571;
            } else {
                phi_4263_ = 0f;
            }
            let _e3573 = phi_4263_;
            if (_e3336 > 0f) {
                if (_e3336 < 1f) {
                    phi_4273_ = _e3336;
                } else {
                    phi_4273_ = 1f;
                }
                let _e3578 = phi_4273_;
                phi_4274_ = _e3578;
            } else {
                phi_4274_ = 0f;
            }
            let _e3580 = phi_4274_;
            let _e3583 = ((sqrt(_e3566) * 255f) + 0.5f);
            let _e3592 = ((sqrt(_e3573) * 255f) + 0.5f);
            let _e3604 = ((sqrt(_e3580) * 255f) + 0.5f);
            phi_4309_ = abi_Sample(vec3<f32>(_e2994, _e2995, _e2996), _e3338, _e3086, _e3343, _e3560, ((select(select(u32(_e3583), 0u, (_e3583 < bitcast<f32>(0u))), 4294967295u, (_e3583 > bitcast<f32>(1333788671u))) | (select(select(u32(_e3592), 0u, (_e3592 < bitcast<f32>(0u))), 4294967295u, (_e3592 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e3604), 0u, (_e3604 < bitcast<f32>(0u))), 4294967295u, (_e3604 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_4309_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e3618 = phi_4309_;
        if (_e113.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e113.shift)] = _e3618;
        if (_e2834.triangle != 4294967295u) {
            let _e3627 = ((1f - _e2834.u) - _e2834.v);
            if (_e2834.triangle < _e83) {
            } else {
                return;
            }
            let _e3632 = triangles.member[(0u + _e2834.triangle)];
            let _e3634 = (_e3632.i0_ & 2147483647u);
            if (_e3634 < _e104) {
            } else {
                return;
            }
            let _e3640 = before.member[(0u + _e3634)];
            if (_e3632.i1_ < _e104) {
            } else {
                return;
            }
            let _e3644 = before.member[(0u + _e3632.i1_)];
            if (_e3632.i2_ < _e104) {
            } else {
                return;
            }
            let _e3648 = before.member[(0u + _e3632.i2_)];
            if (_e2834.instance < _e95) {
            } else {
                return;
            }
            let _e3658 = instances.member[(0u + _e2834.instance)].object_to_world[0u];
            let _e3671 = instances.member[(0u + _e2834.instance)].object_to_world[1u];
            let _e3684 = instances.member[(0u + _e2834.instance)].object_to_world[2u];
            if (_e2834.instance < _e95) {
            } else {
                return;
            }
            let _e3708 = instances.member[(0u + _e2834.instance)].object_to_world[0u];
            let _e3721 = instances.member[(0u + _e2834.instance)].object_to_world[1u];
            let _e3734 = instances.member[(0u + _e2834.instance)].object_to_world[2u];
            if (_e2834.instance < _e95) {
            } else {
                return;
            }
            let _e3761 = instances.member[(0u + _e2834.instance)].object_to_world[0u];
            let _e3774 = instances.member[(0u + _e2834.instance)].object_to_world[1u];
            let _e3787 = instances.member[(0u + _e2834.instance)].object_to_world[2u];
            phi_4532_ = vec3<f32>((((((((_e3658.x * _e3640.x) + (_e3658.y * _e3640.y)) + (_e3658.z * _e3640.z)) + (_e3658.w * 1f)) * _e3627) + (((((_e3708.x * _e3644.x) + (_e3708.y * _e3644.y)) + (_e3708.z * _e3644.z)) + (_e3708.w * 1f)) * _e2834.u)) + (((((_e3761.x * _e3648.x) + (_e3761.y * _e3648.y)) + (_e3761.z * _e3648.z)) + (_e3761.w * 1f)) * _e2834.v)), (((((((_e3671.x * _e3640.x) + (_e3671.y * _e3640.y)) + (_e3671.z * _e3640.z)) + (_e3671.w * 1f)) * _e3627) + (((((_e3721.x * _e3644.x) + (_e3721.y * _e3644.y)) + (_e3721.z * _e3644.z)) + (_e3721.w * 1f)) * _e2834.u)) + (((((_e3774.x * _e3648.x) + (_e3774.y * _e3648.y)) + (_e3774.z * _e3648.z)) + (_e3774.w * 1f)) * _e2834.v)), (((((((_e3684.x * _e3640.x) + (_e3684.y * _e3640.y)) + (_e3684.z * _e3640.z)) + (_e3684.w * 1f)) * _e3627) + (((((_e3734.x * _e3644.x) + (_e3734.y * _e3644.y)) + (_e3734.z * _e3644.z)) + (_e3734.w * 1f)) * _e2834.u)) + (((((_e3787.x * _e3648.x) + (_e3787.y * _e3648.y)) + (_e3787.z * _e3648.z)) + (_e3787.w * 1f)) * _e2834.v)));
        } else {
            phi_4532_ = vec3<f32>(0f, 0f, 0f);
        }
        let _e3807 = phi_4532_;
        if (_e113.shift < arrayLength((&past.member))) {
        } else {
            return;
        }
        past.member[(0u + _e113.shift)] = vec4<f32>(_e3807.x, _e3807.y, _e3807.z, 1f);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_instanced_alpha_color_motion_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
