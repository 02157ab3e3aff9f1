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
                let _e319 = phi_925_;
                if (_e170.direction.x < 0f) {
                    phi_932_ = (-1f / _e319);
                } else {
                    phi_932_ = (1f / _e319);
                }
                let _e324 = phi_932_;
                if (abs(_e170.direction.y) < _e312) {
                    phi_940_ = _e312;
                } else {
                    phi_940_ = abs(_e170.direction.y);
                }
                let _e331 = phi_940_;
                if (_e170.direction.y < 0f) {
                    phi_947_ = (-1f / _e331);
                } else {
                    phi_947_ = (1f / _e331);
                }
                let _e336 = phi_947_;
                if (abs(_e170.direction.z) < _e312) {
                    phi_955_ = _e312;
                } else {
                    phi_955_ = abs(_e170.direction.z);
                }
                let _e343 = phi_955_;
                if (_e170.direction.z < 0f) {
                    phi_962_ = (-1f / _e343);
                } else {
                    phi_962_ = (1f / _e343);
                }
                let _e348 = phi_962_;
                let _e356 = abs((bitcast<f32>(_e248) - _e170.origin.x));
                let _e357 = abs((bitcast<f32>(_e252) - _e170.origin.y));
                let _e358 = abs((bitcast<f32>(_e256) - _e170.origin.z));
                let _e366 = abs(((bitcast<f32>(_e260) + (bitcast<f32>((((_e272 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e170.origin.x));
                let _e367 = abs(((bitcast<f32>(_e264) + (bitcast<f32>((((_e272 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e170.origin.y));
                let _e368 = abs(((bitcast<f32>(_e268) + (bitcast<f32>((((_e272 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e170.origin.z));
                if (_e356 > _e366) {
                    phi_987_ = _e356;
                } else {
                    phi_987_ = _e366;
                }
                let _e371 = phi_987_;
                if (_e357 > _e367) {
                    phi_992_ = _e357;
                } else {
                    phi_992_ = _e367;
                }
                let _e374 = phi_992_;
                if (_e358 > _e368) {
                    phi_997_ = _e358;
                } else {
                    phi_997_ = _e368;
                }
                let _e377 = phi_997_;
                let _e378 = core_intrinsics_maximum_number_nsz_f32_(_e371, _e374);
                let _e379 = core_intrinsics_maximum_number_nsz_f32_(_e378, _e377);
                let _e384 = (_e379 * 0.0000019073486f);
                let _e385 = (abs(_e324) * _e384);
                let _e386 = (abs(_e336) * _e384);
                let _e387 = (abs(_e348) * _e384);
                let _e391 = (_e379 * 0.0000009536743f);
                let _e392 = (abs(_e324) * _e391);
                let _e393 = (abs(_e336) * _e391);
                let _e394 = (abs(_e348) * _e391);
                if (_e324 < 0f) {
                    phi_1019_ = 0u;
                } else {
                    phi_1019_ = 1u;
                }
                let _e397 = phi_1019_;
                if (_e336 < 0f) {
                    phi_1024_ = 0u;
                } else {
                    phi_1024_ = 2u;
                }
                let _e400 = phi_1024_;
                if (_e348 < 0f) {
                    phi_1029_ = 0u;
                } else {
                    phi_1029_ = 4u;
                }
                let _e403 = phi_1029_;
                let _e405 = ((_e397 | _e400) | _e403);
                let _e406 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e119, 2147483648u);
                local_3 = lt_bvh_traverse_Stack(array<u32, 32>(_e406.first[0], _e406.first[1], _e406.first[2], _e406.first[3], _e406.first[4], _e406.first[5], _e406.first[6], _e406.first[7], _e406.first[8], _e406.first[9], _e406.first[10], _e406.first[11], _e406.first[12], _e406.first[13], _e406.first[14], _e406.first[15], _e406.first[16], _e406.first[17], _e406.first[18], _e406.first[19], _e406.first[20], _e406.first[21], _e406.first[22], _e406.first[23], _e406.first[24], _e406.first[25], _e406.first[26], _e406.first[27], _e406.first[28], _e406.first[29], _e406.first[30], _e406.first[31]), array<u32, 32>(_e406.mask[0], _e406.mask[1], _e406.mask[2], _e406.mask[3], _e406.mask[4], _e406.mask[5], _e406.mask[6], _e406.mask[7], _e406.mask[8], _e406.mask[9], _e406.mask[10], _e406.mask[11], _e406.mask[12], _e406.mask[13], _e406.mask[14], _e406.mask[15], _e406.mask[16], _e406.mask[17], _e406.mask[18], _e406.mask[19], _e406.mask[20], _e406.mask[21], _e406.mask[22], _e406.mask[23], _e406.mask[24], _e406.mask[25], _e406.mask[26], _e406.mask[27], _e406.mask[28], _e406.mask[29], _e406.mask[30], _e406.mask[31]), _e406.len, _e406.group, _e406.group_mask);
                let _e480 = local_3.group_mask;
                if ((_e480 & 4278190080u) == 0u) {
                    let _e484 = local_3.len;
                    if (_e484 == 0u) {
                        phi_1143_ = false;
                    } else {
                        let _e488 = local_3.len;
                        local_3.len = (_e488 - 1u);
                        let _e491 = local_3.len;
                        if (_e491 < 32u) {
                        } else {
                            return;
                        }
                        let _e496 = local_3.first[(0u + _e491)];
                        local_3.group = _e496;
                        let _e499 = local_3.len;
                        if (_e499 < 32u) {
                        } else {
                            return;
                        }
                        let _e504 = local_3.mask[(0u + _e499)];
                        local_3.group_mask = _e504;
                        phi_1143_ = true;
                    }
                    let _e507 = phi_1143_;
                    phi_1144_ = _e507;
                } else {
                    phi_1144_ = true;
                }
                let _e509 = phi_1144_;
                if _e509 {
                    let _e511 = local_3.group_mask;
                    let _e517 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e511)), 32u, (_e511 == 0u)));
                    let _e521 = local_3.group_mask;
                    let _e535 = local_3.group_mask;
                    local_3.group_mask = (_e535 & ~((1u << bitcast<u32>((_e517 & 31u)))));
                    let _e538 = local_3.group;
                    phi_1175_ = (_e538 + countOneBits(((_e521 & ~((4294967295u << bitcast<u32>((((_e517 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1175_ = 4294967295u;
                }
                let _e541 = phi_1175_;
                phi_1177_ = _e541;
                phi_1180_ = _e172;
                loop {
                    let _e543 = phi_1177_;
                    let _e545 = phi_1180_;
                    local_13 = _e545;
                    let _e546 = (_e543 != 4294967295u);
                    if _e546 {
                        if (_e543 < _e80) {
                        } else {
                            return;
                        }
                        let _e554 = nodes.member[(0u + _e543)].frame[3u];
                        let _e579 = (bitcast<f32>((((_e554 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e324);
                        let _e580 = (bitcast<f32>((((_e554 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e336);
                        let _e581 = (bitcast<f32>((((_e554 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e348);
                        let _e584 = nodes.member[(0u + _e543)].frame[0u];
                        let _e588 = nodes.member[(0u + _e543)].frame[1u];
                        let _e592 = nodes.member[(0u + _e543)].frame[2u];
                        let _e600 = ((bitcast<f32>(_e584) - _e170.origin.x) * _e324);
                        let _e601 = ((bitcast<f32>(_e588) - _e170.origin.y) * _e336);
                        let _e602 = ((bitcast<f32>(_e592) - _e170.origin.z) * _e348);
                        let _e610 = nodes.member[(0u + _e543)].x;
                        if (_e324 < 0f) {
                            let _e621 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e610.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e627 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e621.unnamed.word, _e610.w), _e621.unnamed_1);
                            let _e633 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e627.unnamed, lt_mask_LightPlace(_e610.x, _e627.unnamed_1.shift));
                            phi_1265_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e633.unnamed, lt_mask_LightPlace(_e633.unnamed_1.word, _e610.y));
                        } else {
                            let _e649 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e610.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e655 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e649.unnamed.word, _e610.y), _e649.unnamed_1);
                            let _e661 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e655.unnamed, lt_mask_LightPlace(_e610.z, _e655.unnamed_1.shift));
                            phi_1265_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e661.unnamed, lt_mask_LightPlace(_e661.unnamed_1.word, _e610.w));
                        }
                        let _e669 = phi_1265_;
                        let _e679 = nodes.member[(0u + _e543)].y;
                        if (_e336 < 0f) {
                            let _e690 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e679.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e696 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e690.unnamed.word, _e679.w), _e690.unnamed_1);
                            let _e702 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e696.unnamed, lt_mask_LightPlace(_e679.x, _e696.unnamed_1.shift));
                            phi_1292_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e702.unnamed, lt_mask_LightPlace(_e702.unnamed_1.word, _e679.y));
                        } else {
                            let _e718 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e679.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e724 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e718.unnamed.word, _e679.y), _e718.unnamed_1);
                            let _e730 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e724.unnamed, lt_mask_LightPlace(_e679.z, _e724.unnamed_1.shift));
                            phi_1292_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e730.unnamed, lt_mask_LightPlace(_e730.unnamed_1.word, _e679.w));
                        }
                        let _e738 = phi_1292_;
                        let _e748 = nodes.member[(0u + _e543)].z;
                        if (_e348 < 0f) {
                            let _e759 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e748.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e765 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e759.unnamed.word, _e748.w), _e759.unnamed_1);
                            let _e771 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e765.unnamed, lt_mask_LightPlace(_e748.x, _e765.unnamed_1.shift));
                            phi_1319_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e771.unnamed, lt_mask_LightPlace(_e771.unnamed_1.word, _e748.y));
                        } else {
                            let _e787 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e748.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e793 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e787.unnamed.word, _e748.y), _e787.unnamed_1);
                            let _e799 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e793.unnamed, lt_mask_LightPlace(_e748.z, _e793.unnamed_1.shift));
                            phi_1319_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e799.unnamed, lt_mask_LightPlace(_e799.unnamed_1.word, _e748.w));
                        }
                        let _e807 = phi_1319_;
                        phi_1325_ = 0u;
                        phi_1328_ = 0u;
                        loop {
                            let _e817 = phi_1325_;
                            let _e819 = phi_1328_;
                            local_4 = _e819;
                            local_5 = _e819;
                            local_6 = _e819;
                            let _e820 = (_e817 < 8u);
                            if _e820 {
                                let _e822 = (_e817 >> bitcast<u32>(2i));
                                let _e823 = (_e817 & 3u);
                                if (_e822 == 0u) {
                                    phi_1342_ = _e669.unnamed.word;
                                } else {
                                    phi_1342_ = _e669.unnamed.shift;
                                }
                                let _e826 = phi_1342_;
                                if (_e822 == 0u) {
                                    phi_1352_ = _e738.unnamed.word;
                                } else {
                                    phi_1352_ = _e738.unnamed.shift;
                                }
                                let _e835 = phi_1352_;
                                if (_e822 == 0u) {
                                    phi_1362_ = _e807.unnamed.word;
                                } else {
                                    phi_1362_ = _e807.unnamed.shift;
                                }
                                let _e844 = phi_1362_;
                                let _e857 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e826 >> bitcast<u32>(((_e823 * 8u) & 31u))) & 255u)) * _e579) + (_e600 - _e385)), ((f32(((_e835 >> bitcast<u32>(((_e823 * 8u) & 31u))) & 255u)) * _e580) + (_e601 - _e386)));
                                let _e858 = core_intrinsics_maximum_number_nsz_f32_(_e857, ((f32(((_e844 >> bitcast<u32>(((_e823 * 8u) & 31u))) & 255u)) * _e581) + (_e602 - _e387)));
                                if (_e822 == 0u) {
                                    phi_1380_ = _e669.unnamed_1.word;
                                } else {
                                    phi_1380_ = _e669.unnamed_1.shift;
                                }
                                let _e861 = phi_1380_;
                                if (_e822 == 0u) {
                                    phi_1390_ = _e738.unnamed_1.word;
                                } else {
                                    phi_1390_ = _e738.unnamed_1.shift;
                                }
                                let _e870 = phi_1390_;
                                if (_e822 == 0u) {
                                    phi_1400_ = _e807.unnamed_1.word;
                                } else {
                                    phi_1400_ = _e807.unnamed_1.shift;
                                }
                                let _e879 = phi_1400_;
                                let _e892 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e861 >> bitcast<u32>(((_e823 * 8u) & 31u))) & 255u)) * _e579) + (_e600 + _e385)), ((f32(((_e870 >> bitcast<u32>(((_e823 * 8u) & 31u))) & 255u)) * _e580) + (_e601 + _e386)));
                                let _e893 = core_intrinsics_minimum_number_nsz_f32_(_e892, ((f32(((_e879 >> bitcast<u32>(((_e823 * 8u) & 31u))) & 255u)) * _e581) + (_e602 + _e387)));
                                if (_e858 <= _e893) {
                                    if (_e858 <= _e545.t) {
                                        if (_e893 >= _e170.tmin) {
                                            if (_e822 == 0u) {
                                                let _e900 = nodes.member[(0u + _e543)].links[2u];
                                                phi_1436_ = _e900;
                                            } else {
                                                let _e903 = nodes.member[(0u + _e543)].links[3u];
                                                phi_1436_ = _e903;
                                            }
                                            let _e905 = phi_1436_;
                                            let _e910 = ((_e905 >> bitcast<u32>(((_e823 * 8u) & 31u))) & 255u);
                                            let _e911 = (_e910 & 31u);
                                            if (_e911 >= 24u) {
                                                phi_1449_ = (24u + ((_e911 - 24u) ^ _e405));
                                            } else {
                                                phi_1449_ = _e911;
                                            }
                                            let _e917 = phi_1449_;
                                            phi_1454_ = (_e819 | ((_e910 >> bitcast<u32>(5i)) << bitcast<u32>((_e917 & 31u))));
                                        } else {
                                            phi_1454_ = _e819;
                                        }
                                        let _e925 = phi_1454_;
                                        phi_1455_ = _e925;
                                    } else {
                                        phi_1455_ = _e819;
                                    }
                                    let _e927 = phi_1455_;
                                    phi_1456_ = _e927;
                                } else {
                                    phi_1456_ = _e819;
                                }
                                let _e929 = phi_1456_;
                                phi_1326_ = (_e817 + 1u);
                                phi_1329_ = _e929;
                            } else {
                                phi_1326_ = u32();
                                phi_1329_ = u32();
                            }
                            let _e932 = phi_1326_;
                            let _e934 = phi_1329_;
                            continue;
                            continuing {
                                phi_1325_ = _e932;
                                phi_1328_ = _e934;
                                break if !(_e820);
                            }
                        }
                        let _e938 = nodes.member[(0u + _e543)].links[0u];
                        let _e942 = nodes.member[(0u + _e543)].frame[3u];
                        let _e946 = local_4;
                        if ((_e946 & 4278190080u) == 0u) {
                        } else {
                            let _e950 = local_3.group_mask;
                            if ((_e950 & 4278190080u) == 0u) {
                            } else {
                                let _e954 = local_3.len;
                                if (_e954 < 32u) {
                                    let _e957 = local_3.group;
                                    let _e959 = local_3.len;
                                    if (_e959 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_3.first[(0u + _e959)] = _e957;
                                    let _e965 = local_3.group_mask;
                                    let _e967 = local_3.len;
                                    if (_e967 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_3.mask[(0u + _e967)] = _e965;
                                    let _e974 = local_3.len;
                                    local_3.len = (_e974 + 1u);
                                }
                            }
                            local_3.group = (_e119 + _e938);
                            let _e978 = local_5;
                            local_3.group_mask = ((_e978 & 4278190080u) | (_e942 >> bitcast<u32>(24i)));
                        }
                        let _e983 = local_6;
                        phi_1514_ = (_e983 & 16777215u);
                        phi_1517_ = _e545;
                        loop {
                            let _e986 = phi_1514_;
                            let _e988 = phi_1517_;
                            local_12 = _e988;
                            if (_e986 == 0u) {
                                phi_1515_ = u32();
                                phi_1518_ = lt_bvh_Hit();
                                phi_3397_ = false;
                            } else {
                                let _e992 = nodes.member[(0u + _e543)].links[1u];
                                let _e996 = (_e992 + select(firstTrailingBit(_e986), 32u, (_e986 == 0u)));
                                if (_e996 < _e95) {
                                } else {
                                    return;
                                }
                                let _e1003 = instances.member[(0u + _e996)].low_world;
                                let _e1005 = instances.member[(0u + _e996)].high_world;
                                let _e1015 = ((_e1003.x - _e170.origin.x) * _e324);
                                let _e1016 = ((_e1003.y - _e170.origin.y) * _e336);
                                let _e1017 = ((_e1003.z - _e170.origin.z) * _e348);
                                let _e1027 = ((_e1005.x - _e170.origin.x) * _e324);
                                let _e1028 = ((_e1005.y - _e170.origin.y) * _e336);
                                let _e1029 = ((_e1005.z - _e170.origin.z) * _e348);
                                if (_e1015 < _e1027) {
                                    phi_1572_ = _e1015;
                                } else {
                                    phi_1572_ = _e1027;
                                }
                                let _e1032 = phi_1572_;
                                if (_e1016 < _e1028) {
                                    phi_1577_ = _e1016;
                                } else {
                                    phi_1577_ = _e1028;
                                }
                                let _e1035 = phi_1577_;
                                if (_e1017 < _e1029) {
                                    phi_1582_ = _e1017;
                                } else {
                                    phi_1582_ = _e1029;
                                }
                                let _e1038 = phi_1582_;
                                if (_e1015 > _e1027) {
                                    phi_1590_ = _e1015;
                                } else {
                                    phi_1590_ = _e1027;
                                }
                                let _e1044 = phi_1590_;
                                if (_e1016 > _e1028) {
                                    phi_1595_ = _e1016;
                                } else {
                                    phi_1595_ = _e1028;
                                }
                                let _e1047 = phi_1595_;
                                if (_e1017 > _e1029) {
                                    phi_1600_ = _e1017;
                                } else {
                                    phi_1600_ = _e1029;
                                }
                                let _e1050 = phi_1600_;
                                let _e1054 = core_intrinsics_maximum_number_nsz_f32_((_e1032 - _e392), (_e1035 - _e393));
                                let _e1055 = core_intrinsics_maximum_number_nsz_f32_(_e1054, (_e1038 - _e394));
                                let _e1056 = core_intrinsics_minimum_number_nsz_f32_((_e1044 + _e392), (_e1047 + _e393));
                                let _e1057 = core_intrinsics_minimum_number_nsz_f32_(_e1056, (_e1050 + _e394));
                                if (_e1055 <= _e1057) {
                                    if (_e1055 <= _e988.t) {
                                        if (_e1057 >= _e170.tmin) {
                                            let _e1069 = instances.member[(0u + _e996)].world_to_object[0u];
                                            let _e1080 = ((((_e1069.x * _e170.origin.x) + (_e1069.y * _e170.origin.y)) + (_e1069.z * _e170.origin.z)) + (_e1069.w * 1f));
                                            let _e1082 = instances.member[(0u + _e996)].world_to_object[1u];
                                            let _e1093 = ((((_e1082.x * _e170.origin.x) + (_e1082.y * _e170.origin.y)) + (_e1082.z * _e170.origin.z)) + (_e1082.w * 1f));
                                            let _e1095 = instances.member[(0u + _e996)].world_to_object[2u];
                                            let _e1106 = ((((_e1095.x * _e170.origin.x) + (_e1095.y * _e170.origin.y)) + (_e1095.z * _e170.origin.z)) + (_e1095.w * 1f));
                                            let _e1113 = instances.member[(0u + _e996)].world_to_object[0u];
                                            let _e1124 = ((((_e1113.x * _e170.direction.x) + (_e1113.y * _e170.direction.y)) + (_e1113.z * _e170.direction.z)) + (_e1113.w * 0f));
                                            let _e1126 = instances.member[(0u + _e996)].world_to_object[1u];
                                            let _e1137 = ((((_e1126.x * _e170.direction.x) + (_e1126.y * _e170.direction.y)) + (_e1126.z * _e170.direction.z)) + (_e1126.w * 0f));
                                            let _e1139 = instances.member[(0u + _e996)].world_to_object[2u];
                                            let _e1150 = ((((_e1139.x * _e170.direction.x) + (_e1139.y * _e170.direction.y)) + (_e1139.z * _e170.direction.z)) + (_e1139.w * 0f));
                                            let _e1155 = instances.member[(0u + _e996)].root;
                                            let _e1157 = instances.member[(0u + _e996)].first_triangle;
                                            let _e1161 = abs(_e1124);
                                            let _e1162 = abs(_e1137);
                                            let _e1163 = abs(_e1150);
                                            if (abs(_e1080) < 1000000000000000f) {
                                                if (abs(_e1093) < 1000000000000000f) {
                                                    if (abs(_e1106) < 1000000000000000f) {
                                                        if (_e1161 < 1000000000000000f) {
                                                            if (_e1162 < 1000000000000000f) {
                                                                if (_e1163 < 1000000000000000f) {
                                                                    if (_e1161 > 0f) {
                                                                        phi_1757_ = bool();
                                                                        phi_1758_ = true;
                                                                    } else {
                                                                        let _e1171 = (_e1162 > 0f);
                                                                        if _e1171 {
                                                                            phi_1756_ = bool();
                                                                        } else {
                                                                            phi_1756_ = (_e1163 > 0f);
                                                                        }
                                                                        let _e1174 = phi_1756_;
                                                                        phi_1757_ = _e1174;
                                                                        phi_1758_ = _e1171;
                                                                    }
                                                                    let _e1176 = phi_1757_;
                                                                    let _e1178 = phi_1758_;
                                                                    if _e1178 {
                                                                        phi_1762_ = true;
                                                                    } else {
                                                                        phi_1762_ = _e1176;
                                                                    }
                                                                    let _e1180 = phi_1762_;
                                                                    phi_1763_ = _e1180;
                                                                    phi_1764_ = false;
                                                                } else {
                                                                    phi_1763_ = bool();
                                                                    phi_1764_ = true;
                                                                }
                                                                let _e1182 = phi_1763_;
                                                                let _e1184 = phi_1764_;
                                                                phi_1765_ = _e1182;
                                                                phi_1766_ = false;
                                                                phi_1767_ = _e1184;
                                                            } else {
                                                                phi_1765_ = bool();
                                                                phi_1766_ = true;
                                                                phi_1767_ = false;
                                                            }
                                                            let _e1186 = phi_1765_;
                                                            let _e1188 = phi_1766_;
                                                            let _e1190 = phi_1767_;
                                                            phi_1768_ = _e1186;
                                                            phi_1769_ = _e1188;
                                                            phi_1770_ = _e1190;
                                                        } else {
                                                            phi_1768_ = bool();
                                                            phi_1769_ = true;
                                                            phi_1770_ = false;
                                                        }
                                                        let _e1192 = phi_1768_;
                                                        let _e1194 = phi_1769_;
                                                        let _e1196 = phi_1770_;
                                                        phi_1771_ = _e1192;
                                                        phi_1772_ = _e1194;
                                                        phi_1773_ = _e1196;
                                                    } else {
                                                        phi_1771_ = bool();
                                                        phi_1772_ = true;
                                                        phi_1773_ = false;
                                                    }
                                                    let _e1198 = phi_1771_;
                                                    let _e1200 = phi_1772_;
                                                    let _e1202 = phi_1773_;
                                                    phi_1774_ = _e1198;
                                                    phi_1775_ = _e1200;
                                                    phi_1776_ = _e1202;
                                                } else {
                                                    phi_1774_ = bool();
                                                    phi_1775_ = true;
                                                    phi_1776_ = false;
                                                }
                                                let _e1204 = phi_1774_;
                                                let _e1206 = phi_1775_;
                                                let _e1208 = phi_1776_;
                                                phi_1777_ = _e1204;
                                                phi_1778_ = _e1206;
                                                phi_1779_ = _e1208;
                                            } else {
                                                phi_1777_ = bool();
                                                phi_1778_ = true;
                                                phi_1779_ = false;
                                            }
                                            let _e1210 = phi_1777_;
                                            let _e1212 = phi_1778_;
                                            let _e1214 = phi_1779_;
                                            if _e1212 {
                                                phi_1783_ = true;
                                            } else {
                                                phi_1783_ = _e1214;
                                            }
                                            let _e1216 = phi_1783_;
                                            if _e1216 {
                                                phi_1787_ = false;
                                            } else {
                                                phi_1787_ = _e1210;
                                            }
                                            let _e1218 = phi_1787_;
                                            if _e1218 {
                                                let _e1219 = (_e1155 >= _e80);
                                                if _e1219 {
                                                    phi_3387_ = lt_bvh_Hit();
                                                } else {
                                                    if (_e1155 < _e80) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1225 = nodes.member[(0u + _e1155)].frame[0u];
                                                    let _e1229 = nodes.member[(0u + _e1155)].frame[1u];
                                                    let _e1233 = nodes.member[(0u + _e1155)].frame[2u];
                                                    let _e1237 = nodes.member[(0u + _e1155)].frame[0u];
                                                    let _e1241 = nodes.member[(0u + _e1155)].frame[1u];
                                                    let _e1245 = nodes.member[(0u + _e1155)].frame[2u];
                                                    let _e1249 = nodes.member[(0u + _e1155)].frame[3u];
                                                    let _e1283 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1124), abs(_e1137));
                                                    let _e1284 = core_intrinsics_maximum_number_nsz_f32_(_e1283, abs(_e1150));
                                                    let _e1285 = (_e1284 * 0.0000000000009094947f);
                                                    if (abs(_e1124) < _e1285) {
                                                        phi_1857_ = _e1285;
                                                    } else {
                                                        phi_1857_ = abs(_e1124);
                                                    }
                                                    let _e1290 = phi_1857_;
                                                    if (_e1124 < 0f) {
                                                        phi_1864_ = (-1f / _e1290);
                                                    } else {
                                                        phi_1864_ = (1f / _e1290);
                                                    }
                                                    let _e1295 = phi_1864_;
                                                    if (abs(_e1137) < _e1285) {
                                                        phi_1871_ = _e1285;
                                                    } else {
                                                        phi_1871_ = abs(_e1137);
                                                    }
                                                    let _e1300 = phi_1871_;
                                                    if (_e1137 < 0f) {
                                                        phi_1878_ = (-1f / _e1300);
                                                    } else {
                                                        phi_1878_ = (1f / _e1300);
                                                    }
                                                    let _e1305 = phi_1878_;
                                                    if (abs(_e1150) < _e1285) {
                                                        phi_1885_ = _e1285;
                                                    } else {
                                                        phi_1885_ = abs(_e1150);
                                                    }
                                                    let _e1310 = phi_1885_;
                                                    if (_e1150 < 0f) {
                                                        phi_1892_ = (-1f / _e1310);
                                                    } else {
                                                        phi_1892_ = (1f / _e1310);
                                                    }
                                                    let _e1315 = phi_1892_;
                                                    let _e1319 = abs((bitcast<f32>(_e1225) - _e1080));
                                                    let _e1320 = abs((bitcast<f32>(_e1229) - _e1093));
                                                    let _e1321 = abs((bitcast<f32>(_e1233) - _e1106));
                                                    let _e1325 = abs(((bitcast<f32>(_e1237) + (bitcast<f32>((((_e1249 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1080));
                                                    let _e1326 = abs(((bitcast<f32>(_e1241) + (bitcast<f32>((((_e1249 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1093));
                                                    let _e1327 = abs(((bitcast<f32>(_e1245) + (bitcast<f32>((((_e1249 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1106));
                                                    if (_e1319 > _e1325) {
                                                        phi_1909_ = _e1319;
                                                    } else {
                                                        phi_1909_ = _e1325;
                                                    }
                                                    let _e1330 = phi_1909_;
                                                    if (_e1320 > _e1326) {
                                                        phi_1914_ = _e1320;
                                                    } else {
                                                        phi_1914_ = _e1326;
                                                    }
                                                    let _e1333 = phi_1914_;
                                                    if (_e1321 > _e1327) {
                                                        phi_1919_ = _e1321;
                                                    } else {
                                                        phi_1919_ = _e1327;
                                                    }
                                                    let _e1336 = phi_1919_;
                                                    let _e1337 = core_intrinsics_maximum_number_nsz_f32_(_e1330, _e1333);
                                                    let _e1338 = core_intrinsics_maximum_number_nsz_f32_(_e1337, _e1336);
                                                    let _e1342 = (_e1338 * 0.0000019073486f);
                                                    let _e1343 = (abs(_e1295) * _e1342);
                                                    let _e1344 = (abs(_e1305) * _e1342);
                                                    let _e1345 = (abs(_e1315) * _e1342);
                                                    let _e1349 = (_e1338 * 0.0000009536743f);
                                                    let _e1350 = (abs(_e1295) * _e1349);
                                                    let _e1351 = (abs(_e1305) * _e1349);
                                                    let _e1352 = (abs(_e1315) * _e1349);
                                                    let _e1353 = abs(_e1124);
                                                    let _e1354 = abs(_e1137);
                                                    let _e1355 = abs(_e1150);
                                                    if (_e1353 >= _e1354) {
                                                        if (_e1353 >= _e1355) {
                                                            phi_1947_ = false;
                                                        } else {
                                                            phi_1947_ = true;
                                                        }
                                                        let _e1359 = phi_1947_;
                                                        phi_1948_ = _e1359;
                                                    } else {
                                                        phi_1948_ = true;
                                                    }
                                                    let _e1361 = phi_1948_;
                                                    if _e1361 {
                                                        if (_e1354 >= _e1355) {
                                                            phi_1956_ = 1u;
                                                        } else {
                                                            phi_1956_ = 2u;
                                                        }
                                                        let _e1364 = phi_1956_;
                                                        phi_1957_ = _e1364;
                                                    } else {
                                                        phi_1957_ = 0u;
                                                    }
                                                    let _e1366 = phi_1957_;
                                                    if (_e1366 == 0u) {
                                                        phi_1969_ = vec3<f32>(_e1137, _e1150, _e1124);
                                                    } else {
                                                        if (_e1366 == 1u) {
                                                            phi_1968_ = vec3<f32>(_e1150, _e1124, _e1137);
                                                        } else {
                                                            phi_1968_ = vec3<f32>(_e1124, _e1137, _e1150);
                                                        }
                                                        let _e1372 = phi_1968_;
                                                        phi_1969_ = _e1372;
                                                    }
                                                    let _e1374 = phi_1969_;
                                                    let _e1377 = (_e1374.x / _e1374.z);
                                                    let _e1380 = (_e1374.y / _e1374.z);
                                                    if (_e1295 < 0f) {
                                                        phi_1982_ = 0u;
                                                    } else {
                                                        phi_1982_ = 1u;
                                                    }
                                                    let _e1385 = phi_1982_;
                                                    if (_e1305 < 0f) {
                                                        phi_1987_ = 0u;
                                                    } else {
                                                        phi_1987_ = 2u;
                                                    }
                                                    let _e1388 = phi_1987_;
                                                    if (_e1315 < 0f) {
                                                        phi_1992_ = 0u;
                                                    } else {
                                                        phi_1992_ = 4u;
                                                    }
                                                    let _e1391 = phi_1992_;
                                                    let _e1393 = ((_e1385 | _e1388) | _e1391);
                                                    let _e1394 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1155, 2147483648u);
                                                    local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e1394.first[0], _e1394.first[1], _e1394.first[2], _e1394.first[3], _e1394.first[4], _e1394.first[5], _e1394.first[6], _e1394.first[7], _e1394.first[8], _e1394.first[9], _e1394.first[10], _e1394.first[11], _e1394.first[12], _e1394.first[13], _e1394.first[14], _e1394.first[15], _e1394.first[16], _e1394.first[17], _e1394.first[18], _e1394.first[19], _e1394.first[20], _e1394.first[21], _e1394.first[22], _e1394.first[23], _e1394.first[24], _e1394.first[25], _e1394.first[26], _e1394.first[27], _e1394.first[28], _e1394.first[29], _e1394.first[30], _e1394.first[31]), array<u32, 32>(_e1394.mask[0], _e1394.mask[1], _e1394.mask[2], _e1394.mask[3], _e1394.mask[4], _e1394.mask[5], _e1394.mask[6], _e1394.mask[7], _e1394.mask[8], _e1394.mask[9], _e1394.mask[10], _e1394.mask[11], _e1394.mask[12], _e1394.mask[13], _e1394.mask[14], _e1394.mask[15], _e1394.mask[16], _e1394.mask[17], _e1394.mask[18], _e1394.mask[19], _e1394.mask[20], _e1394.mask[21], _e1394.mask[22], _e1394.mask[23], _e1394.mask[24], _e1394.mask[25], _e1394.mask[26], _e1394.mask[27], _e1394.mask[28], _e1394.mask[29], _e1394.mask[30], _e1394.mask[31]), _e1394.len, _e1394.group, _e1394.group_mask);
                                                    let _e1468 = local_2.group_mask;
                                                    if ((_e1468 & 4278190080u) == 0u) {
                                                        let _e1472 = local_2.len;
                                                        if (_e1472 == 0u) {
                                                            phi_2106_ = false;
                                                        } else {
                                                            let _e1476 = local_2.len;
                                                            local_2.len = (_e1476 - 1u);
                                                            let _e1479 = local_2.len;
                                                            if (_e1479 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1484 = local_2.first[(0u + _e1479)];
                                                            local_2.group = _e1484;
                                                            let _e1487 = local_2.len;
                                                            if (_e1487 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1492 = local_2.mask[(0u + _e1487)];
                                                            local_2.group_mask = _e1492;
                                                            phi_2106_ = true;
                                                        }
                                                        let _e1495 = phi_2106_;
                                                        phi_2107_ = _e1495;
                                                    } else {
                                                        phi_2107_ = true;
                                                    }
                                                    let _e1497 = phi_2107_;
                                                    if _e1497 {
                                                        let _e1499 = local_2.group_mask;
                                                        let _e1505 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1499)), 32u, (_e1499 == 0u)));
                                                        let _e1509 = local_2.group_mask;
                                                        let _e1523 = local_2.group_mask;
                                                        local_2.group_mask = (_e1523 & ~((1u << bitcast<u32>((_e1505 & 31u)))));
                                                        let _e1526 = local_2.group;
                                                        phi_2138_ = (_e1526 + countOneBits(((_e1509 & ~((4294967295u << bitcast<u32>((((_e1505 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_2138_ = 4294967295u;
                                                    }
                                                    let _e1529 = phi_2138_;
                                                    phi_2140_ = _e988;
                                                    phi_2143_ = _e1529;
                                                    loop {
                                                        let _e1531 = phi_2140_;
                                                        let _e1533 = phi_2143_;
                                                        local_11 = _e1531;
                                                        let _e1534 = (_e1533 != 4294967295u);
                                                        if _e1534 {
                                                            if (_e1533 < _e80) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1541 = nodes.member[(0u + _e1533)].frame[3u];
                                                            let _e1566 = (bitcast<f32>((((_e1541 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1295);
                                                            let _e1567 = (bitcast<f32>((((_e1541 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1305);
                                                            let _e1568 = (bitcast<f32>((((_e1541 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1315);
                                                            let _e1571 = nodes.member[(0u + _e1533)].frame[0u];
                                                            let _e1575 = nodes.member[(0u + _e1533)].frame[1u];
                                                            let _e1579 = nodes.member[(0u + _e1533)].frame[2u];
                                                            let _e1584 = ((bitcast<f32>(_e1571) - _e1080) * _e1295);
                                                            let _e1585 = ((bitcast<f32>(_e1575) - _e1093) * _e1305);
                                                            let _e1586 = ((bitcast<f32>(_e1579) - _e1106) * _e1315);
                                                            let _e1594 = nodes.member[(0u + _e1533)].x;
                                                            if (_e1295 < 0f) {
                                                                let _e1605 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1594.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1611 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1605.unnamed.word, _e1594.w), _e1605.unnamed_1);
                                                                let _e1617 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1611.unnamed, lt_mask_LightPlace(_e1594.x, _e1611.unnamed_1.shift));
                                                                phi_2224_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1617.unnamed, lt_mask_LightPlace(_e1617.unnamed_1.word, _e1594.y));
                                                            } else {
                                                                let _e1633 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1594.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1639 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1633.unnamed.word, _e1594.y), _e1633.unnamed_1);
                                                                let _e1645 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1639.unnamed, lt_mask_LightPlace(_e1594.z, _e1639.unnamed_1.shift));
                                                                phi_2224_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1645.unnamed, lt_mask_LightPlace(_e1645.unnamed_1.word, _e1594.w));
                                                            }
                                                            let _e1653 = phi_2224_;
                                                            let _e1663 = nodes.member[(0u + _e1533)].y;
                                                            if (_e1305 < 0f) {
                                                                let _e1674 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1663.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1680 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1674.unnamed.word, _e1663.w), _e1674.unnamed_1);
                                                                let _e1686 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1680.unnamed, lt_mask_LightPlace(_e1663.x, _e1680.unnamed_1.shift));
                                                                phi_2251_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1686.unnamed, lt_mask_LightPlace(_e1686.unnamed_1.word, _e1663.y));
                                                            } else {
                                                                let _e1702 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1663.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1708 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1702.unnamed.word, _e1663.y), _e1702.unnamed_1);
                                                                let _e1714 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1708.unnamed, lt_mask_LightPlace(_e1663.z, _e1708.unnamed_1.shift));
                                                                phi_2251_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1714.unnamed, lt_mask_LightPlace(_e1714.unnamed_1.word, _e1663.w));
                                                            }
                                                            let _e1722 = phi_2251_;
                                                            let _e1732 = nodes.member[(0u + _e1533)].z;
                                                            if (_e1315 < 0f) {
                                                                let _e1743 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1732.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1749 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1743.unnamed.word, _e1732.w), _e1743.unnamed_1);
                                                                let _e1755 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1749.unnamed, lt_mask_LightPlace(_e1732.x, _e1749.unnamed_1.shift));
                                                                phi_2278_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1755.unnamed, lt_mask_LightPlace(_e1755.unnamed_1.word, _e1732.y));
                                                            } else {
                                                                let _e1771 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1732.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1777 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1771.unnamed.word, _e1732.y), _e1771.unnamed_1);
                                                                let _e1783 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1777.unnamed, lt_mask_LightPlace(_e1732.z, _e1777.unnamed_1.shift));
                                                                phi_2278_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1783.unnamed, lt_mask_LightPlace(_e1783.unnamed_1.word, _e1732.w));
                                                            }
                                                            let _e1791 = phi_2278_;
                                                            phi_2284_ = 0u;
                                                            phi_2287_ = 0u;
                                                            loop {
                                                                let _e1801 = phi_2284_;
                                                                let _e1803 = phi_2287_;
                                                                local_7 = _e1803;
                                                                local_8 = _e1803;
                                                                local_9 = _e1803;
                                                                let _e1804 = (_e1801 < 8u);
                                                                if _e1804 {
                                                                    let _e1806 = (_e1801 >> bitcast<u32>(2i));
                                                                    let _e1807 = (_e1801 & 3u);
                                                                    if (_e1806 == 0u) {
                                                                        phi_2301_ = _e1653.unnamed.word;
                                                                    } else {
                                                                        phi_2301_ = _e1653.unnamed.shift;
                                                                    }
                                                                    let _e1810 = phi_2301_;
                                                                    if (_e1806 == 0u) {
                                                                        phi_2311_ = _e1722.unnamed.word;
                                                                    } else {
                                                                        phi_2311_ = _e1722.unnamed.shift;
                                                                    }
                                                                    let _e1819 = phi_2311_;
                                                                    if (_e1806 == 0u) {
                                                                        phi_2321_ = _e1791.unnamed.word;
                                                                    } else {
                                                                        phi_2321_ = _e1791.unnamed.shift;
                                                                    }
                                                                    let _e1828 = phi_2321_;
                                                                    let _e1841 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1810 >> bitcast<u32>(((_e1807 * 8u) & 31u))) & 255u)) * _e1566) + (_e1584 - _e1343)), ((f32(((_e1819 >> bitcast<u32>(((_e1807 * 8u) & 31u))) & 255u)) * _e1567) + (_e1585 - _e1344)));
                                                                    let _e1842 = core_intrinsics_maximum_number_nsz_f32_(_e1841, ((f32(((_e1828 >> bitcast<u32>(((_e1807 * 8u) & 31u))) & 255u)) * _e1568) + (_e1586 - _e1345)));
                                                                    if (_e1806 == 0u) {
                                                                        phi_2339_ = _e1653.unnamed_1.word;
                                                                    } else {
                                                                        phi_2339_ = _e1653.unnamed_1.shift;
                                                                    }
                                                                    let _e1845 = phi_2339_;
                                                                    if (_e1806 == 0u) {
                                                                        phi_2349_ = _e1722.unnamed_1.word;
                                                                    } else {
                                                                        phi_2349_ = _e1722.unnamed_1.shift;
                                                                    }
                                                                    let _e1854 = phi_2349_;
                                                                    if (_e1806 == 0u) {
                                                                        phi_2359_ = _e1791.unnamed_1.word;
                                                                    } else {
                                                                        phi_2359_ = _e1791.unnamed_1.shift;
                                                                    }
                                                                    let _e1863 = phi_2359_;
                                                                    let _e1876 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1845 >> bitcast<u32>(((_e1807 * 8u) & 31u))) & 255u)) * _e1566) + (_e1584 + _e1343)), ((f32(((_e1854 >> bitcast<u32>(((_e1807 * 8u) & 31u))) & 255u)) * _e1567) + (_e1585 + _e1344)));
                                                                    let _e1877 = core_intrinsics_minimum_number_nsz_f32_(_e1876, ((f32(((_e1863 >> bitcast<u32>(((_e1807 * 8u) & 31u))) & 255u)) * _e1568) + (_e1586 + _e1345)));
                                                                    if (_e1842 <= _e1877) {
                                                                        if (_e1842 <= _e1531.t) {
                                                                            if (_e1877 >= _e170.tmin) {
                                                                                if (_e1806 == 0u) {
                                                                                    let _e1884 = nodes.member[(0u + _e1533)].links[2u];
                                                                                    phi_2395_ = _e1884;
                                                                                } else {
                                                                                    let _e1887 = nodes.member[(0u + _e1533)].links[3u];
                                                                                    phi_2395_ = _e1887;
                                                                                }
                                                                                let _e1889 = phi_2395_;
                                                                                let _e1894 = ((_e1889 >> bitcast<u32>(((_e1807 * 8u) & 31u))) & 255u);
                                                                                let _e1895 = (_e1894 & 31u);
                                                                                if (_e1895 >= 24u) {
                                                                                    phi_2408_ = (24u + ((_e1895 - 24u) ^ _e1393));
                                                                                } else {
                                                                                    phi_2408_ = _e1895;
                                                                                }
                                                                                let _e1901 = phi_2408_;
                                                                                phi_2413_ = (_e1803 | ((_e1894 >> bitcast<u32>(5i)) << bitcast<u32>((_e1901 & 31u))));
                                                                            } else {
                                                                                phi_2413_ = _e1803;
                                                                            }
                                                                            let _e1909 = phi_2413_;
                                                                            phi_2414_ = _e1909;
                                                                        } else {
                                                                            phi_2414_ = _e1803;
                                                                        }
                                                                        let _e1911 = phi_2414_;
                                                                        phi_2415_ = _e1911;
                                                                    } else {
                                                                        phi_2415_ = _e1803;
                                                                    }
                                                                    let _e1913 = phi_2415_;
                                                                    phi_2285_ = (_e1801 + 1u);
                                                                    phi_2288_ = _e1913;
                                                                } else {
                                                                    phi_2285_ = u32();
                                                                    phi_2288_ = u32();
                                                                }
                                                                let _e1916 = phi_2285_;
                                                                let _e1918 = phi_2288_;
                                                                continue;
                                                                continuing {
                                                                    phi_2284_ = _e1916;
                                                                    phi_2287_ = _e1918;
                                                                    break if !(_e1804);
                                                                }
                                                            }
                                                            let _e1922 = nodes.member[(0u + _e1533)].links[0u];
                                                            let _e1926 = nodes.member[(0u + _e1533)].frame[3u];
                                                            let _e1930 = local_7;
                                                            if ((_e1930 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1934 = local_2.group_mask;
                                                                if ((_e1934 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1938 = local_2.len;
                                                                    if (_e1938 < 32u) {
                                                                        let _e1941 = local_2.group;
                                                                        let _e1943 = local_2.len;
                                                                        if (_e1943 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_2.first[(0u + _e1943)] = _e1941;
                                                                        let _e1949 = local_2.group_mask;
                                                                        let _e1951 = local_2.len;
                                                                        if (_e1951 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_2.mask[(0u + _e1951)] = _e1949;
                                                                        let _e1958 = local_2.len;
                                                                        local_2.len = (_e1958 + 1u);
                                                                    }
                                                                }
                                                                local_2.group = (_e1155 + _e1922);
                                                                let _e1962 = local_8;
                                                                local_2.group_mask = ((_e1962 & 4278190080u) | (_e1926 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1967 = local_9;
                                                            phi_2473_ = _e1531;
                                                            phi_2476_ = (_e1967 & 16777215u);
                                                            loop {
                                                                let _e1970 = phi_2473_;
                                                                let _e1972 = phi_2476_;
                                                                local_10 = _e1970;
                                                                if (_e1972 == 0u) {
                                                                    phi_2474_ = lt_bvh_Hit();
                                                                    phi_2477_ = u32();
                                                                    phi_3315_ = false;
                                                                } else {
                                                                    let _e1976 = nodes.member[(0u + _e1533)].links[1u];
                                                                    let _e1981 = ((_e1157 + _e1976) + select(firstTrailingBit(_e1972), 32u, (_e1972 == 0u)));
                                                                    if (_e1981 < _e83) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1988 = triangles.member[(0u + _e1981)].v0_;
                                                                    let _e1990 = (_e1988.x - _e1080);
                                                                    let _e1992 = (_e1988.y - _e1093);
                                                                    let _e1994 = (_e1988.z - _e1106);
                                                                    if (_e1366 == 0u) {
                                                                        phi_2521_ = vec3<f32>(_e1992, _e1994, _e1990);
                                                                    } else {
                                                                        if (_e1366 == 1u) {
                                                                            phi_2520_ = vec3<f32>(_e1994, _e1990, _e1992);
                                                                        } else {
                                                                            phi_2520_ = (_e1988 - vec3<f32>(_e1080, _e1093, _e1106));
                                                                        }
                                                                        let _e2002 = phi_2520_;
                                                                        phi_2521_ = _e2002;
                                                                    }
                                                                    let _e2004 = phi_2521_;
                                                                    let _e2008 = (_e2004.x - (_e1377 * _e2004.z));
                                                                    let _e2012 = (_e2004.y - (_e1380 * _e2004.z));
                                                                    let _e2014 = triangles.member[(0u + _e1981)].v1_;
                                                                    let _e2016 = (_e2014.x - _e1080);
                                                                    let _e2018 = (_e2014.y - _e1093);
                                                                    let _e2020 = (_e2014.z - _e1106);
                                                                    if (_e1366 == 0u) {
                                                                        phi_2551_ = vec3<f32>(_e2018, _e2020, _e2016);
                                                                    } else {
                                                                        if (_e1366 == 1u) {
                                                                            phi_2550_ = vec3<f32>(_e2020, _e2016, _e2018);
                                                                        } else {
                                                                            phi_2550_ = (_e2014 - vec3<f32>(_e1080, _e1093, _e1106));
                                                                        }
                                                                        let _e2028 = phi_2550_;
                                                                        phi_2551_ = _e2028;
                                                                    }
                                                                    let _e2030 = phi_2551_;
                                                                    let _e2034 = (_e2030.x - (_e1377 * _e2030.z));
                                                                    let _e2038 = (_e2030.y - (_e1380 * _e2030.z));
                                                                    let _e2040 = triangles.member[(0u + _e1981)].v2_;
                                                                    let _e2042 = (_e2040.x - _e1080);
                                                                    let _e2044 = (_e2040.y - _e1093);
                                                                    let _e2046 = (_e2040.z - _e1106);
                                                                    if (_e1366 == 0u) {
                                                                        phi_2581_ = vec3<f32>(_e2044, _e2046, _e2042);
                                                                    } else {
                                                                        if (_e1366 == 1u) {
                                                                            phi_2580_ = vec3<f32>(_e2046, _e2042, _e2044);
                                                                        } else {
                                                                            phi_2580_ = (_e2040 - vec3<f32>(_e1080, _e1093, _e1106));
                                                                        }
                                                                        let _e2054 = phi_2580_;
                                                                        phi_2581_ = _e2054;
                                                                    }
                                                                    let _e2056 = phi_2581_;
                                                                    let _e2060 = (_e2056.x - (_e1377 * _e2056.z));
                                                                    let _e2064 = (_e2056.y - (_e1380 * _e2056.z));
                                                                    if (_e2034 < _e2060) {
                                                                        phi_2600_ = true;
                                                                    } else {
                                                                        if (_e2034 == _e2060) {
                                                                            phi_2599_ = (_e2038 < _e2064);
                                                                        } else {
                                                                            phi_2599_ = false;
                                                                        }
                                                                        let _e2069 = phi_2599_;
                                                                        phi_2600_ = _e2069;
                                                                    }
                                                                    let _e2071 = phi_2600_;
                                                                    if _e2071 {
                                                                        phi_2604_ = _e2064;
                                                                        phi_2605_ = _e2060;
                                                                        phi_2606_ = _e2038;
                                                                        phi_2607_ = _e2034;
                                                                    } else {
                                                                        phi_2604_ = _e2038;
                                                                        phi_2605_ = _e2034;
                                                                        phi_2606_ = _e2064;
                                                                        phi_2607_ = _e2060;
                                                                    }
                                                                    let _e2073 = phi_2604_;
                                                                    let _e2075 = phi_2605_;
                                                                    let _e2077 = phi_2606_;
                                                                    let _e2079 = phi_2607_;
                                                                    let _e2082 = ((_e2079 * _e2073) - (_e2077 * _e2075));
                                                                    if _e2071 {
                                                                        phi_2615_ = -(_e2082);
                                                                    } else {
                                                                        phi_2615_ = _e2082;
                                                                    }
                                                                    let _e2085 = phi_2615_;
                                                                    if (_e2060 < _e2008) {
                                                                        phi_2626_ = true;
                                                                    } else {
                                                                        if (_e2060 == _e2008) {
                                                                            phi_2625_ = (_e2064 < _e2012);
                                                                        } else {
                                                                            phi_2625_ = false;
                                                                        }
                                                                        let _e2090 = phi_2625_;
                                                                        phi_2626_ = _e2090;
                                                                    }
                                                                    let _e2092 = phi_2626_;
                                                                    if _e2092 {
                                                                        phi_2630_ = _e2012;
                                                                        phi_2631_ = _e2008;
                                                                        phi_2632_ = _e2064;
                                                                        phi_2633_ = _e2060;
                                                                    } else {
                                                                        phi_2630_ = _e2064;
                                                                        phi_2631_ = _e2060;
                                                                        phi_2632_ = _e2012;
                                                                        phi_2633_ = _e2008;
                                                                    }
                                                                    let _e2094 = phi_2630_;
                                                                    let _e2096 = phi_2631_;
                                                                    let _e2098 = phi_2632_;
                                                                    let _e2100 = phi_2633_;
                                                                    let _e2103 = ((_e2100 * _e2094) - (_e2098 * _e2096));
                                                                    if _e2092 {
                                                                        phi_2641_ = -(_e2103);
                                                                    } else {
                                                                        phi_2641_ = _e2103;
                                                                    }
                                                                    let _e2106 = phi_2641_;
                                                                    if (_e2008 < _e2034) {
                                                                        phi_2652_ = true;
                                                                    } else {
                                                                        if (_e2008 == _e2034) {
                                                                            phi_2651_ = (_e2012 < _e2038);
                                                                        } else {
                                                                            phi_2651_ = false;
                                                                        }
                                                                        let _e2111 = phi_2651_;
                                                                        phi_2652_ = _e2111;
                                                                    }
                                                                    let _e2113 = phi_2652_;
                                                                    if _e2113 {
                                                                        phi_2656_ = _e2038;
                                                                        phi_2657_ = _e2034;
                                                                        phi_2658_ = _e2012;
                                                                        phi_2659_ = _e2008;
                                                                    } else {
                                                                        phi_2656_ = _e2012;
                                                                        phi_2657_ = _e2008;
                                                                        phi_2658_ = _e2038;
                                                                        phi_2659_ = _e2034;
                                                                    }
                                                                    let _e2115 = phi_2656_;
                                                                    let _e2117 = phi_2657_;
                                                                    let _e2119 = phi_2658_;
                                                                    let _e2121 = phi_2659_;
                                                                    let _e2124 = ((_e2121 * _e2115) - (_e2119 * _e2117));
                                                                    if _e2113 {
                                                                        phi_2667_ = -(_e2124);
                                                                    } else {
                                                                        phi_2667_ = _e2124;
                                                                    }
                                                                    let _e2127 = phi_2667_;
                                                                    if (_e2085 >= 0f) {
                                                                        if (_e2106 >= 0f) {
                                                                            if (_e2127 >= 0f) {
                                                                                phi_2682_ = ((_e2085 + _e2106) + _e2127);
                                                                                phi_2683_ = false;
                                                                            } else {
                                                                                phi_2682_ = f32();
                                                                                phi_2683_ = true;
                                                                            }
                                                                            let _e2134 = phi_2682_;
                                                                            let _e2136 = phi_2683_;
                                                                            phi_2684_ = _e2134;
                                                                            phi_2685_ = _e2136;
                                                                        } else {
                                                                            phi_2684_ = f32();
                                                                            phi_2685_ = true;
                                                                        }
                                                                        let _e2138 = phi_2684_;
                                                                        let _e2140 = phi_2685_;
                                                                        phi_2686_ = _e2138;
                                                                        phi_2687_ = _e2140;
                                                                    } else {
                                                                        phi_2686_ = f32();
                                                                        phi_2687_ = true;
                                                                    }
                                                                    let _e2142 = phi_2686_;
                                                                    let _e2144 = phi_2687_;
                                                                    if _e2144 {
                                                                        if (_e2085 <= 0f) {
                                                                            if (_e2106 <= 0f) {
                                                                                let _e2147 = (_e2127 <= 0f);
                                                                                if _e2147 {
                                                                                }
                                                                                phi_2705_ = ((_e2085 + _e2106) + _e2127);
                                                                                phi_2706_ = false;
                                                                                phi_2707_ = _e2147;
                                                                            } else {
                                                                                phi_2705_ = f32();
                                                                                phi_2706_ = true;
                                                                                phi_2707_ = false;
                                                                            }
                                                                            let _e2151 = phi_2705_;
                                                                            let _e2153 = phi_2706_;
                                                                            let _e2155 = phi_2707_;
                                                                            phi_2708_ = _e2151;
                                                                            phi_2709_ = _e2153;
                                                                            phi_2710_ = _e2155;
                                                                        } else {
                                                                            phi_2708_ = f32();
                                                                            phi_2709_ = true;
                                                                            phi_2710_ = false;
                                                                        }
                                                                        let _e2157 = phi_2708_;
                                                                        let _e2159 = phi_2709_;
                                                                        let _e2161 = phi_2710_;
                                                                        if _e2159 {
                                                                            phi_2714_ = false;
                                                                        } else {
                                                                            phi_2714_ = _e2161;
                                                                        }
                                                                        let _e2163 = phi_2714_;
                                                                        phi_2715_ = _e2157;
                                                                        phi_2716_ = _e2163;
                                                                    } else {
                                                                        phi_2715_ = _e2142;
                                                                        phi_2716_ = true;
                                                                    }
                                                                    let _e2165 = phi_2715_;
                                                                    let _e2167 = phi_2716_;
                                                                    if _e2167 {
                                                                        let _e2168 = (_e2165 == 0f);
                                                                        if _e2168 {
                                                                            phi_3032_ = lt_bvh_triangle_Intersection();
                                                                            phi_3033_ = false;
                                                                        } else {
                                                                            let _e2170 = triangles.member[(0u + _e1981)].v0_;
                                                                            let _e2172 = (_e2170.x - _e1080);
                                                                            let _e2174 = (_e2170.y - _e1093);
                                                                            let _e2176 = (_e2170.z - _e1106);
                                                                            if (_e1366 == 0u) {
                                                                                phi_2745_ = vec3<f32>(_e2174, _e2176, _e2172);
                                                                            } else {
                                                                                if (_e1366 == 1u) {
                                                                                    phi_2744_ = vec3<f32>(_e2176, _e2172, _e2174);
                                                                                } else {
                                                                                    phi_2744_ = (_e2170 - vec3<f32>(_e1080, _e1093, _e1106));
                                                                                }
                                                                                let _e2184 = phi_2744_;
                                                                                phi_2745_ = _e2184;
                                                                            }
                                                                            let _e2186 = phi_2745_;
                                                                            let _e2188 = triangles.member[(0u + _e1981)].v1_;
                                                                            let _e2190 = triangles.member[(0u + _e1981)].v0_;
                                                                            let _e2193 = (_e2188.x - _e2190.x);
                                                                            let _e2196 = (_e2188.y - _e2190.y);
                                                                            let _e2199 = (_e2188.z - _e2190.z);
                                                                            if (_e1366 == 0u) {
                                                                                phi_2771_ = vec3<f32>(_e2196, _e2199, _e2193);
                                                                            } else {
                                                                                if (_e1366 == 1u) {
                                                                                    phi_2770_ = vec3<f32>(_e2199, _e2193, _e2196);
                                                                                } else {
                                                                                    phi_2770_ = (_e2188 - _e2190);
                                                                                }
                                                                                let _e2206 = phi_2770_;
                                                                                phi_2771_ = _e2206;
                                                                            }
                                                                            let _e2208 = phi_2771_;
                                                                            let _e2210 = triangles.member[(0u + _e1981)].v2_;
                                                                            let _e2212 = triangles.member[(0u + _e1981)].v0_;
                                                                            let _e2215 = (_e2210.x - _e2212.x);
                                                                            let _e2218 = (_e2210.y - _e2212.y);
                                                                            let _e2221 = (_e2210.z - _e2212.z);
                                                                            if (_e1366 == 0u) {
                                                                                phi_2797_ = vec3<f32>(_e2218, _e2221, _e2215);
                                                                            } else {
                                                                                if (_e1366 == 1u) {
                                                                                    phi_2796_ = vec3<f32>(_e2221, _e2215, _e2218);
                                                                                } else {
                                                                                    phi_2796_ = (_e2210 - _e2212);
                                                                                }
                                                                                let _e2228 = phi_2796_;
                                                                                phi_2797_ = _e2228;
                                                                            }
                                                                            let _e2230 = phi_2797_;
                                                                            let _e2237 = ((_e2208.y * _e2230.z) - (_e2208.z * _e2230.y));
                                                                            let _e2244 = ((_e2208.z * _e2230.x) - (_e2208.x * _e2230.z));
                                                                            let _e2251 = ((_e2208.x * _e2230.y) - (_e2208.y * _e2230.x));
                                                                            let _e2265 = (((1f / _e1374.z) * (((_e2237 * _e2186.x) + (_e2244 * _e2186.y)) + (_e2251 * _e2186.z))) / (((_e2237 * _e1377) + (_e2244 * _e1380)) + _e2251));
                                                                            if (_e2265 > _e170.tmin) {
                                                                                if (_e2265 < _e170.tmax) {
                                                                                    let _e2269 = triangles.member[(0u + _e1981)].v0_;
                                                                                    let _e2271 = triangles.member[(0u + _e1981)].v1_;
                                                                                    if (_e2269.x < _e2271.x) {
                                                                                        phi_2853_ = _e2269.x;
                                                                                    } else {
                                                                                        phi_2853_ = _e2271.x;
                                                                                    }
                                                                                    let _e2278 = phi_2853_;
                                                                                    if (_e2269.y < _e2271.y) {
                                                                                        phi_2862_ = _e2269.y;
                                                                                    } else {
                                                                                        phi_2862_ = _e2271.y;
                                                                                    }
                                                                                    let _e2285 = phi_2862_;
                                                                                    if (_e2269.z < _e2271.z) {
                                                                                        phi_2871_ = _e2269.z;
                                                                                    } else {
                                                                                        phi_2871_ = _e2271.z;
                                                                                    }
                                                                                    let _e2292 = phi_2871_;
                                                                                    let _e2294 = triangles.member[(0u + _e1981)].v2_;
                                                                                    if (_e2278 < _e2294.x) {
                                                                                        phi_2880_ = _e2278;
                                                                                    } else {
                                                                                        phi_2880_ = _e2294.x;
                                                                                    }
                                                                                    let _e2299 = phi_2880_;
                                                                                    if (_e2285 < _e2294.y) {
                                                                                        phi_2887_ = _e2285;
                                                                                    } else {
                                                                                        phi_2887_ = _e2294.y;
                                                                                    }
                                                                                    let _e2304 = phi_2887_;
                                                                                    if (_e2292 < _e2294.z) {
                                                                                        phi_2894_ = _e2292;
                                                                                    } else {
                                                                                        phi_2894_ = _e2294.z;
                                                                                    }
                                                                                    let _e2309 = phi_2894_;
                                                                                    let _e2311 = triangles.member[(0u + _e1981)].v0_;
                                                                                    let _e2313 = triangles.member[(0u + _e1981)].v1_;
                                                                                    if (_e2311.x > _e2313.x) {
                                                                                        phi_2907_ = _e2311.x;
                                                                                    } else {
                                                                                        phi_2907_ = _e2313.x;
                                                                                    }
                                                                                    let _e2320 = phi_2907_;
                                                                                    if (_e2311.y > _e2313.y) {
                                                                                        phi_2916_ = _e2311.y;
                                                                                    } else {
                                                                                        phi_2916_ = _e2313.y;
                                                                                    }
                                                                                    let _e2327 = phi_2916_;
                                                                                    if (_e2311.z > _e2313.z) {
                                                                                        phi_2925_ = _e2311.z;
                                                                                    } else {
                                                                                        phi_2925_ = _e2313.z;
                                                                                    }
                                                                                    let _e2334 = phi_2925_;
                                                                                    let _e2336 = triangles.member[(0u + _e1981)].v2_;
                                                                                    if (_e2320 > _e2336.x) {
                                                                                        phi_2934_ = _e2320;
                                                                                    } else {
                                                                                        phi_2934_ = _e2336.x;
                                                                                    }
                                                                                    let _e2341 = phi_2934_;
                                                                                    if (_e2327 > _e2336.y) {
                                                                                        phi_2941_ = _e2327;
                                                                                    } else {
                                                                                        phi_2941_ = _e2336.y;
                                                                                    }
                                                                                    let _e2346 = phi_2941_;
                                                                                    if (_e2334 > _e2336.z) {
                                                                                        phi_2948_ = _e2334;
                                                                                    } else {
                                                                                        phi_2948_ = _e2336.z;
                                                                                    }
                                                                                    let _e2351 = phi_2948_;
                                                                                    let _e2355 = ((_e2299 - _e1080) * _e1295);
                                                                                    let _e2356 = ((_e2304 - _e1093) * _e1305);
                                                                                    let _e2357 = ((_e2309 - _e1106) * _e1315);
                                                                                    let _e2361 = ((_e2341 - _e1080) * _e1295);
                                                                                    let _e2362 = ((_e2346 - _e1093) * _e1305);
                                                                                    let _e2363 = ((_e2351 - _e1106) * _e1315);
                                                                                    if (_e2355 < _e2361) {
                                                                                        phi_2965_ = _e2355;
                                                                                    } else {
                                                                                        phi_2965_ = _e2361;
                                                                                    }
                                                                                    let _e2366 = phi_2965_;
                                                                                    if (_e2356 < _e2362) {
                                                                                        phi_2970_ = _e2356;
                                                                                    } else {
                                                                                        phi_2970_ = _e2362;
                                                                                    }
                                                                                    let _e2369 = phi_2970_;
                                                                                    if (_e2357 < _e2363) {
                                                                                        phi_2975_ = _e2357;
                                                                                    } else {
                                                                                        phi_2975_ = _e2363;
                                                                                    }
                                                                                    let _e2372 = phi_2975_;
                                                                                    if (_e2355 > _e2361) {
                                                                                        phi_2983_ = _e2355;
                                                                                    } else {
                                                                                        phi_2983_ = _e2361;
                                                                                    }
                                                                                    let _e2378 = phi_2983_;
                                                                                    if (_e2356 > _e2362) {
                                                                                        phi_2988_ = _e2356;
                                                                                    } else {
                                                                                        phi_2988_ = _e2362;
                                                                                    }
                                                                                    let _e2381 = phi_2988_;
                                                                                    if (_e2357 > _e2363) {
                                                                                        phi_2993_ = _e2357;
                                                                                    } else {
                                                                                        phi_2993_ = _e2363;
                                                                                    }
                                                                                    let _e2384 = phi_2993_;
                                                                                    let _e2388 = core_intrinsics_maximum_number_nsz_f32_((_e2366 - _e1350), (_e2369 - _e1351));
                                                                                    let _e2389 = core_intrinsics_maximum_number_nsz_f32_(_e2388, (_e2372 - _e1352));
                                                                                    let _e2390 = core_intrinsics_minimum_number_nsz_f32_((_e2378 + _e1350), (_e2381 + _e1351));
                                                                                    let _e2391 = core_intrinsics_minimum_number_nsz_f32_(_e2390, (_e2384 + _e1352));
                                                                                    if (_e2389 > _e1055) {
                                                                                        phi_3005_ = _e2389;
                                                                                    } else {
                                                                                        phi_3005_ = _e1055;
                                                                                    }
                                                                                    let _e2394 = phi_3005_;
                                                                                    if (_e2391 < _e1057) {
                                                                                        phi_3010_ = _e2391;
                                                                                    } else {
                                                                                        phi_3010_ = _e1057;
                                                                                    }
                                                                                    let _e2397 = phi_3010_;
                                                                                    if (_e2265 < _e2394) {
                                                                                        phi_3015_ = _e2394;
                                                                                    } else {
                                                                                        phi_3015_ = _e2265;
                                                                                    }
                                                                                    let _e2400 = phi_3015_;
                                                                                    if (_e2400 > _e2397) {
                                                                                        phi_3020_ = _e2397;
                                                                                    } else {
                                                                                        phi_3020_ = _e2400;
                                                                                    }
                                                                                    let _e2403 = phi_3020_;
                                                                                    phi_3025_ = lt_bvh_triangle_Intersection(_e2403, (_e2106 / _e2165), (_e2127 / _e2165), (_e2394 <= _e2397));
                                                                                    phi_3026_ = false;
                                                                                } else {
                                                                                    phi_3025_ = lt_bvh_triangle_Intersection();
                                                                                    phi_3026_ = true;
                                                                                }
                                                                                let _e2409 = phi_3025_;
                                                                                let _e2411 = phi_3026_;
                                                                                phi_3027_ = _e2409;
                                                                                phi_3028_ = _e2411;
                                                                            } else {
                                                                                phi_3027_ = lt_bvh_triangle_Intersection();
                                                                                phi_3028_ = true;
                                                                            }
                                                                            let _e2413 = phi_3027_;
                                                                            let _e2415 = phi_3028_;
                                                                            if _e2415 {
                                                                            }
                                                                            phi_3032_ = _e2413;
                                                                            phi_3033_ = _e2415;
                                                                        }
                                                                        let _e2417 = phi_3032_;
                                                                        let _e2419 = phi_3033_;
                                                                        phi_3034_ = _e2417;
                                                                        phi_3035_ = _e2168;
                                                                        phi_3036_ = _e2419;
                                                                    } else {
                                                                        phi_3034_ = lt_bvh_triangle_Intersection();
                                                                        phi_3035_ = true;
                                                                        phi_3036_ = false;
                                                                    }
                                                                    let _e2421 = phi_3034_;
                                                                    let _e2423 = phi_3035_;
                                                                    let _e2425 = phi_3036_;
                                                                    if _e2423 {
                                                                        phi_3040_ = true;
                                                                    } else {
                                                                        phi_3040_ = _e2425;
                                                                    }
                                                                    let _e2427 = phi_3040_;
                                                                    if _e2427 {
                                                                        phi_3044_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_3044_ = _e2421;
                                                                    }
                                                                    let _e2429 = phi_3044_;
                                                                    if _e2429.is_hit {
                                                                        if (_e2429.t > _e170.tmin) {
                                                                            if (_e2429.t < _e1970.t) {
                                                                                phi_3092_ = true;
                                                                            } else {
                                                                                if (_e2429.t == _e1970.t) {
                                                                                    if (_e1970.triangle != 4294967295u) {
                                                                                        if (_e1981 < _e1970.triangle) {
                                                                                            phi_3083_ = true;
                                                                                        } else {
                                                                                            if (_e1981 == _e1970.triangle) {
                                                                                                phi_3082_ = (_e996 < _e1970.instance);
                                                                                            } else {
                                                                                                phi_3082_ = false;
                                                                                            }
                                                                                            let _e2447 = phi_3082_;
                                                                                            phi_3083_ = _e2447;
                                                                                        }
                                                                                        let _e2449 = phi_3083_;
                                                                                        phi_3084_ = _e2449;
                                                                                        phi_3085_ = false;
                                                                                    } else {
                                                                                        phi_3084_ = bool();
                                                                                        phi_3085_ = true;
                                                                                    }
                                                                                    let _e2451 = phi_3084_;
                                                                                    let _e2453 = phi_3085_;
                                                                                    phi_3086_ = _e2451;
                                                                                    phi_3087_ = _e2453;
                                                                                } else {
                                                                                    phi_3086_ = bool();
                                                                                    phi_3087_ = true;
                                                                                }
                                                                                let _e2455 = phi_3086_;
                                                                                let _e2457 = phi_3087_;
                                                                                if _e2457 {
                                                                                    phi_3091_ = false;
                                                                                } else {
                                                                                    phi_3091_ = _e2455;
                                                                                }
                                                                                let _e2459 = phi_3091_;
                                                                                phi_3092_ = _e2459;
                                                                            }
                                                                            let _e2461 = phi_3092_;
                                                                            if _e2461 {
                                                                                let _e2463 = triangles.member[(0u + _e1981)].i0_;
                                                                                if ((_e2463 & 2147483648u) == 0u) {
                                                                                    phi_3303_ = true;
                                                                                } else {
                                                                                    if (_e1981 < _e83) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2472 = triangles.member[(0u + _e1981)].i0_;
                                                                                    let _e2473 = (_e2472 & 2147483647u);
                                                                                    let _e2475 = triangles.member[(0u + _e1981)].i1_;
                                                                                    let _e2477 = triangles.member[(0u + _e1981)].i2_;
                                                                                    if (_e2473 < _e86) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2481 = vertices.member[(0u + _e2473)];
                                                                                    if (_e2475 < _e86) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2485 = vertices.member[(0u + _e2475)];
                                                                                    if (_e2477 < _e86) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2489 = vertices.member[(0u + _e2477)];
                                                                                    let _e2490 = array<abi_Vertex, 3>(_e2481, _e2485, _e2489);
                                                                                    if (_e2490[0].material < _e89) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2496 = materials.member[(0u + _e2490[0].material)];
                                                                                    if ((_e2496.flags & 0u) == 0u) {
                                                                                        let _e2501 = ((1f - _e2429.u) - _e2429.v);
                                                                                        if (_e2496.cutoff <= 0f) {
                                                                                            phi_3298_ = true;
                                                                                        } else {
                                                                                            let _e2528 = (_e2496.base_color.w * ((((f32((_e2490[0].color >> bitcast<u32>(24i))) * _e2501) + (f32((_e2490[1].color >> bitcast<u32>(24i))) * _e2429.u)) + (f32((_e2490[2].color >> bitcast<u32>(24i))) * _e2429.v)) * (1f / 255f)));
                                                                                            if (_e2496.alpha_size == 0u) {
                                                                                                phi_3295_ = _e2528;
                                                                                            } else {
                                                                                                local_1.offset = _e2496.alpha_offset;
                                                                                                local_1.size = _e2496.alpha_size;
                                                                                                local_1.flags = _e2496.flags;
                                                                                                let _e2559 = _lt_shaders_texture_TextureView_quad((&local_1), (((_e2490[0].u * _e2501) + (_e2490[1].u * _e2429.u)) + (_e2490[2].u * _e2429.v)), (((_e2490[0].v * _e2501) + (_e2490[1].v * _e2429.u)) + (_e2490[2].v * _e2429.v)));
                                                                                                let _e2563 = (_e2559.indices[0] >> bitcast<u32>(2i));
                                                                                                if (_e2563 < _e98) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2567 = alpha_texels.member[(0u + _e2563)];
                                                                                                let _e2583 = (_e2559.indices[1] >> bitcast<u32>(2i));
                                                                                                if (_e2583 < _e98) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2587 = alpha_texels.member[(0u + _e2583)];
                                                                                                let _e2604 = (_e2559.indices[2] >> bitcast<u32>(2i));
                                                                                                if (_e2604 < _e98) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2608 = alpha_texels.member[(0u + _e2604)];
                                                                                                let _e2625 = (_e2559.indices[3] >> bitcast<u32>(2i));
                                                                                                if (_e2625 < _e98) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2629 = alpha_texels.member[(0u + _e2625)];
                                                                                                phi_3295_ = (_e2528 * (((((f32(((_e2567 >> bitcast<u32>((((_e2559.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2559.weights.x) + ((f32(((_e2587 >> bitcast<u32>((((_e2559.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2559.weights.y)) + ((f32(((_e2608 >> bitcast<u32>((((_e2559.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2559.weights.z)) + ((f32(((_e2629 >> bitcast<u32>((((_e2559.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2559.weights.w)));
                                                                                            }
                                                                                            let _e2645 = phi_3295_;
                                                                                            phi_3298_ = (_e2645 >= _e2496.cutoff);
                                                                                        }
                                                                                        let _e2649 = phi_3298_;
                                                                                        phi_3299_ = _e2649;
                                                                                    } else {
                                                                                        phi_3299_ = false;
                                                                                    }
                                                                                    let _e2651 = phi_3299_;
                                                                                    if _e2651 {
                                                                                    }
                                                                                    phi_3303_ = _e2651;
                                                                                }
                                                                                let _e2653 = phi_3303_;
                                                                                if _e2653 {
                                                                                    phi_3311_ = lt_bvh_Hit(_e2429.t, _e2429.u, _e2429.v, _e1981, _e996);
                                                                                } else {
                                                                                    phi_3311_ = _e1970;
                                                                                }
                                                                                let _e2659 = phi_3311_;
                                                                                phi_3312_ = _e2659;
                                                                            } else {
                                                                                phi_3312_ = _e1970;
                                                                            }
                                                                            let _e2661 = phi_3312_;
                                                                            phi_3313_ = _e2661;
                                                                        } else {
                                                                            phi_3313_ = _e1970;
                                                                        }
                                                                        let _e2663 = phi_3313_;
                                                                        phi_3314_ = _e2663;
                                                                    } else {
                                                                        phi_3314_ = _e1970;
                                                                    }
                                                                    let _e2665 = phi_3314_;
                                                                    phi_2474_ = _e2665;
                                                                    phi_2477_ = (_e1972 & (_e1972 - 1u));
                                                                    phi_3315_ = true;
                                                                }
                                                                let _e2667 = phi_2474_;
                                                                let _e2669 = phi_2477_;
                                                                let _e2671 = phi_3315_;
                                                                continue;
                                                                continuing {
                                                                    phi_2473_ = _e2667;
                                                                    phi_2476_ = _e2669;
                                                                    break if !(_e2671);
                                                                }
                                                            }
                                                            let _e2674 = local_2.group_mask;
                                                            if ((_e2674 & 4278190080u) == 0u) {
                                                                let _e2678 = local_2.len;
                                                                if (_e2678 == 0u) {
                                                                    phi_3354_ = false;
                                                                } else {
                                                                    let _e2682 = local_2.len;
                                                                    local_2.len = (_e2682 - 1u);
                                                                    let _e2685 = local_2.len;
                                                                    if (_e2685 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2690 = local_2.first[(0u + _e2685)];
                                                                    local_2.group = _e2690;
                                                                    let _e2693 = local_2.len;
                                                                    if (_e2693 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2698 = local_2.mask[(0u + _e2693)];
                                                                    local_2.group_mask = _e2698;
                                                                    phi_3354_ = true;
                                                                }
                                                                let _e2701 = phi_3354_;
                                                                phi_3355_ = _e2701;
                                                            } else {
                                                                phi_3355_ = true;
                                                            }
                                                            let _e2703 = phi_3355_;
                                                            if _e2703 {
                                                                let _e2705 = local_2.group_mask;
                                                                let _e2711 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2705)), 32u, (_e2705 == 0u)));
                                                                let _e2715 = local_2.group_mask;
                                                                let _e2729 = local_2.group_mask;
                                                                local_2.group_mask = (_e2729 & ~((1u << bitcast<u32>((_e2711 & 31u)))));
                                                                let _e2732 = local_2.group;
                                                                phi_3386_ = (_e2732 + countOneBits(((_e2715 & ~((4294967295u << bitcast<u32>((((_e2711 - 24u) ^ _e1393) & 31u))))) & 255u)));
                                                            } else {
                                                                phi_3386_ = 4294967295u;
                                                            }
                                                            let _e2735 = phi_3386_;
                                                            let _e4061 = local_10;
                                                            phi_2141_ = _e4061;
                                                            phi_2144_ = _e2735;
                                                        } else {
                                                            phi_2141_ = lt_bvh_Hit();
                                                            phi_2144_ = u32();
                                                        }
                                                        let _e2737 = phi_2141_;
                                                        let _e2739 = phi_2144_;
                                                        continue;
                                                        continuing {
                                                            phi_2140_ = _e2737;
                                                            phi_2143_ = _e2739;
                                                            break if !(_e1534);
                                                        }
                                                    }
                                                    let _e4065 = local_11;
                                                    phi_3387_ = _e4065;
                                                }
                                                let _e2742 = phi_3387_;
                                                phi_3388_ = _e2742;
                                                phi_3389_ = _e1219;
                                            } else {
                                                phi_3388_ = lt_bvh_Hit();
                                                phi_3389_ = true;
                                            }
                                            let _e2744 = phi_3388_;
                                            let _e2746 = phi_3389_;
                                            if _e2746 {
                                                phi_3393_ = _e988;
                                            } else {
                                                phi_3393_ = _e2744;
                                            }
                                            let _e2748 = phi_3393_;
                                            phi_3394_ = _e2748;
                                        } else {
                                            phi_3394_ = _e988;
                                        }
                                        let _e2750 = phi_3394_;
                                        phi_3395_ = _e2750;
                                    } else {
                                        phi_3395_ = _e988;
                                    }
                                    let _e2752 = phi_3395_;
                                    phi_3396_ = _e2752;
                                } else {
                                    phi_3396_ = _e988;
                                }
                                let _e2754 = phi_3396_;
                                phi_1515_ = (_e986 & (_e986 - 1u));
                                phi_1518_ = _e2754;
                                phi_3397_ = true;
                            }
                            let _e2756 = phi_1515_;
                            let _e2758 = phi_1518_;
                            let _e2760 = phi_3397_;
                            continue;
                            continuing {
                                phi_1514_ = _e2756;
                                phi_1517_ = _e2758;
                                break if !(_e2760);
                            }
                        }
                        let _e2763 = local_3.group_mask;
                        if ((_e2763 & 4278190080u) == 0u) {
                            let _e2767 = local_3.len;
                            if (_e2767 == 0u) {
                                phi_3436_ = false;
                            } else {
                                let _e2771 = local_3.len;
                                local_3.len = (_e2771 - 1u);
                                let _e2774 = local_3.len;
                                if (_e2774 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2779 = local_3.first[(0u + _e2774)];
                                local_3.group = _e2779;
                                let _e2782 = local_3.len;
                                if (_e2782 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2787 = local_3.mask[(0u + _e2782)];
                                local_3.group_mask = _e2787;
                                phi_3436_ = true;
                            }
                            let _e2790 = phi_3436_;
                            phi_3437_ = _e2790;
                        } else {
                            phi_3437_ = true;
                        }
                        let _e2792 = phi_3437_;
                        if _e2792 {
                            let _e2794 = local_3.group_mask;
                            let _e2800 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2794)), 32u, (_e2794 == 0u)));
                            let _e2804 = local_3.group_mask;
                            let _e2818 = local_3.group_mask;
                            local_3.group_mask = (_e2818 & ~((1u << bitcast<u32>((_e2800 & 31u)))));
                            let _e2821 = local_3.group;
                            phi_3468_ = (_e2821 + countOneBits(((_e2804 & ~((4294967295u << bitcast<u32>((((_e2800 - 24u) ^ _e405) & 31u))))) & 255u)));
                        } else {
                            phi_3468_ = 4294967295u;
                        }
                        let _e2824 = phi_3468_;
                        phi_1178_ = _e2824;
                        let _e4081 = local_12;
                        phi_1181_ = _e4081;
                    } else {
                        phi_1178_ = u32();
                        phi_1181_ = lt_bvh_Hit();
                    }
                    let _e2826 = phi_1178_;
                    let _e2828 = phi_1181_;
                    continue;
                    continuing {
                        phi_1177_ = _e2826;
                        phi_1180_ = _e2828;
                        break if !(_e546);
                    }
                }
                let _e4084 = local_13;
                phi_3469_ = _e4084;
            }
            let _e2831 = phi_3469_;
            phi_3470_ = _e2831;
            phi_3471_ = _e242;
        } else {
            phi_3470_ = lt_bvh_Hit();
            phi_3471_ = true;
        }
        let _e2833 = phi_3470_;
        let _e2835 = phi_3471_;
        if _e2835 {
            phi_3475_ = _e172;
        } else {
            phi_3475_ = _e2833;
        }
        let _e2837 = phi_3475_;
        if (_e2837.triangle != 4294967295u) {
            let _e2843 = ((1f - _e2837.u) - _e2837.v);
            if (_e2837.triangle < _e83) {
            } else {
                return;
            }
            let _e2848 = triangles.member[(0u + _e2837.triangle)];
            if (_e2837.instance < _e95) {
            } else {
                return;
            }
            let _e2859 = instances.member[(0u + _e2837.instance)].object_to_world[0u];
            let _e2870 = ((((_e2859.x * _e2848.v0_.x) + (_e2859.y * _e2848.v0_.y)) + (_e2859.z * _e2848.v0_.z)) + (_e2859.w * 1f));
            let _e2872 = instances.member[(0u + _e2837.instance)].object_to_world[1u];
            let _e2883 = ((((_e2872.x * _e2848.v0_.x) + (_e2872.y * _e2848.v0_.y)) + (_e2872.z * _e2848.v0_.z)) + (_e2872.w * 1f));
            let _e2885 = instances.member[(0u + _e2837.instance)].object_to_world[2u];
            let _e2896 = ((((_e2885.x * _e2848.v0_.x) + (_e2885.y * _e2848.v0_.y)) + (_e2885.z * _e2848.v0_.z)) + (_e2885.w * 1f));
            let _e2903 = instances.member[(0u + _e2837.instance)].object_to_world[0u];
            let _e2914 = ((((_e2903.x * _e2848.v1_.x) + (_e2903.y * _e2848.v1_.y)) + (_e2903.z * _e2848.v1_.z)) + (_e2903.w * 1f));
            let _e2916 = instances.member[(0u + _e2837.instance)].object_to_world[1u];
            let _e2927 = ((((_e2916.x * _e2848.v1_.x) + (_e2916.y * _e2848.v1_.y)) + (_e2916.z * _e2848.v1_.z)) + (_e2916.w * 1f));
            let _e2929 = instances.member[(0u + _e2837.instance)].object_to_world[2u];
            let _e2940 = ((((_e2929.x * _e2848.v1_.x) + (_e2929.y * _e2848.v1_.y)) + (_e2929.z * _e2848.v1_.z)) + (_e2929.w * 1f));
            let _e2947 = instances.member[(0u + _e2837.instance)].object_to_world[0u];
            let _e2958 = ((((_e2947.x * _e2848.v2_.x) + (_e2947.y * _e2848.v2_.y)) + (_e2947.z * _e2848.v2_.z)) + (_e2947.w * 1f));
            let _e2960 = instances.member[(0u + _e2837.instance)].object_to_world[1u];
            let _e2971 = ((((_e2960.x * _e2848.v2_.x) + (_e2960.y * _e2848.v2_.y)) + (_e2960.z * _e2848.v2_.z)) + (_e2960.w * 1f));
            let _e2973 = instances.member[(0u + _e2837.instance)].object_to_world[2u];
            let _e2984 = ((((_e2973.x * _e2848.v2_.x) + (_e2973.y * _e2848.v2_.y)) + (_e2973.z * _e2848.v2_.z)) + (_e2973.w * 1f));
            let _e2997 = (((_e2870 * _e2843) + (_e2914 * _e2837.u)) + (_e2958 * _e2837.v));
            let _e2998 = (((_e2883 * _e2843) + (_e2927 * _e2837.u)) + (_e2971 * _e2837.v));
            let _e2999 = (((_e2896 * _e2843) + (_e2940 * _e2837.u)) + (_e2984 * _e2837.v));
            let _e3001 = abs(_e2870);
            let _e3002 = abs(_e2883);
            let _e3003 = abs(_e2896);
            let _e3004 = abs(_e2914);
            let _e3005 = abs(_e2927);
            let _e3006 = abs(_e2940);
            if (_e3001 > _e3004) {
                phi_3662_ = _e3001;
            } else {
                phi_3662_ = _e3004;
            }
            let _e3009 = phi_3662_;
            if (_e3002 > _e3005) {
                phi_3667_ = _e3002;
            } else {
                phi_3667_ = _e3005;
            }
            let _e3012 = phi_3667_;
            if (_e3003 > _e3006) {
                phi_3672_ = _e3003;
            } else {
                phi_3672_ = _e3006;
            }
            let _e3015 = phi_3672_;
            let _e3016 = abs(_e2958);
            let _e3017 = abs(_e2971);
            let _e3018 = abs(_e2984);
            if (_e3009 > _e3016) {
                phi_3680_ = _e3009;
            } else {
                phi_3680_ = _e3016;
            }
            let _e3021 = phi_3680_;
            if (_e3012 > _e3017) {
                phi_3685_ = _e3012;
            } else {
                phi_3685_ = _e3017;
            }
            let _e3024 = phi_3685_;
            if (_e3015 > _e3018) {
                phi_3690_ = _e3015;
            } else {
                phi_3690_ = _e3018;
            }
            let _e3027 = phi_3690_;
            let _e3028 = (_e2914 - _e2870);
            let _e3029 = (_e2927 - _e2883);
            let _e3030 = (_e2940 - _e2896);
            let _e3031 = (_e2958 - _e2870);
            let _e3032 = (_e2971 - _e2883);
            let _e3033 = (_e2984 - _e2896);
            let _e3037 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3029), abs(_e3030));
            let _e3038 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3028), _e3037);
            let _e3039 = (_e3028 / _e3038);
            let _e3040 = (_e3029 / _e3038);
            let _e3041 = (_e3030 / _e3038);
            let _e3045 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3032), abs(_e3033));
            let _e3046 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3031), _e3045);
            let _e3047 = (_e3031 / _e3046);
            let _e3048 = (_e3032 / _e3046);
            let _e3049 = (_e3033 / _e3046);
            let _e3052 = ((_e3040 * _e3049) - (_e3048 * _e3041));
            let _e3055 = ((_e3041 * _e3047) - (_e3049 * _e3039));
            let _e3058 = ((_e3039 * _e3048) - (_e3047 * _e3040));
            let _e3060 = p.member.eye;
            let _e3073 = (1f / sqrt((((_e3052 * _e3052) + (_e3055 * _e3055)) + (_e3058 * _e3058))));
            let _e3074 = (_e3052 * _e3073);
            let _e3075 = (_e3055 * _e3073);
            let _e3076 = (_e3058 * _e3073);
            if ((((_e3074 * (_e3060.x - _e2997)) + (_e3075 * (_e3060.y - _e2998))) + (_e3076 * (_e3060.z - _e2999))) < 0f) {
                phi_3754_ = vec3<f32>(-(_e3074), -(_e3075), -(_e3076));
            } else {
                phi_3754_ = vec3<f32>(_e3074, _e3075, _e3076);
            }
            let _e3089 = phi_3754_;
            if (_e2837.triangle < _e83) {
            } else {
                return;
            }
            let _e3094 = triangles.member[(0u + _e2837.triangle)];
            let _e3096 = (_e3094.i0_ & 2147483647u);
            if (_e3096 < _e86) {
            } else {
                return;
            }
            let _e3102 = vertices.member[(0u + _e3096)];
            if (_e3094.i1_ < _e86) {
            } else {
                return;
            }
            let _e3106 = vertices.member[(0u + _e3094.i1_)];
            if (_e3094.i2_ < _e86) {
            } else {
                return;
            }
            let _e3110 = vertices.member[(0u + _e3094.i2_)];
            let _e3111 = array<abi_Vertex, 3>(_e3102, _e3106, _e3110);
            if (_e3111[0].material < _e89) {
            } else {
                return;
            }
            let _e3117 = materials.member[(0u + _e3111[0].material)];
            let _e3134 = (1f / 255f);
            let _e3153 = (1f / 255f);
            let _e3175 = (1f / 255f);
            if (_e3117.color_size == 0u) {
                phi_3997_ = vec3<f32>(1f, 1f, 1f);
            } else {
                local.offset = _e3117.color_offset;
                local.size = _e3117.color_size;
                local.flags = _e3117.flags;
                let _e3218 = _lt_shaders_texture_TextureView_quad((&local), (((_e3111[0].u * _e2843) + (_e3111[1].u * _e2837.u)) + (_e3111[2].u * _e2837.v)), (((_e3111[0].v * _e2843) + (_e3111[1].v * _e2837.u)) + (_e3111[2].v * _e2837.v)));
                if (_e3218.indices[0] < _e101) {
                } else {
                    return;
                }
                let _e3224 = color_texels.member[(0u + _e3218.indices[0])];
                let _e3235 = (1f / 255f);
                if (_e3218.indices[1] < _e101) {
                } else {
                    return;
                }
                let _e3249 = color_texels.member[(0u + _e3218.indices[1])];
                let _e3260 = (1f / 255f);
                if (_e3218.indices[2] < _e101) {
                } else {
                    return;
                }
                let _e3277 = color_texels.member[(0u + _e3218.indices[2])];
                let _e3288 = (1f / 255f);
                if (_e3218.indices[3] < _e101) {
                } else {
                    return;
                }
                let _e3305 = color_texels.member[(0u + _e3218.indices[3])];
                let _e3316 = (1f / 255f);
                let _e3325 = (((((f32((_e3224 & 255u)) * _e3235) * _e3218.weights.x) + ((f32((_e3249 & 255u)) * _e3260) * _e3218.weights.y)) + ((f32((_e3277 & 255u)) * _e3288) * _e3218.weights.z)) + ((f32((_e3305 & 255u)) * _e3316) * _e3218.weights.w));
                let _e3326 = (((((f32(((_e3224 >> bitcast<u32>(8i)) & 255u)) * _e3235) * _e3218.weights.x) + ((f32(((_e3249 >> bitcast<u32>(8i)) & 255u)) * _e3260) * _e3218.weights.y)) + ((f32(((_e3277 >> bitcast<u32>(8i)) & 255u)) * _e3288) * _e3218.weights.z)) + ((f32(((_e3305 >> bitcast<u32>(8i)) & 255u)) * _e3316) * _e3218.weights.w));
                let _e3327 = (((((f32(((_e3224 >> bitcast<u32>(16i)) & 255u)) * _e3235) * _e3218.weights.x) + ((f32(((_e3249 >> bitcast<u32>(16i)) & 255u)) * _e3260) * _e3218.weights.y)) + ((f32(((_e3277 >> bitcast<u32>(16i)) & 255u)) * _e3288) * _e3218.weights.z)) + ((f32(((_e3305 >> bitcast<u32>(16i)) & 255u)) * _e3316) * _e3218.weights.w));
                phi_3997_ = vec3<f32>((_e3325 * _e3325), (_e3326 * _e3326), (_e3327 * _e3327));
            }
            let _e3333 = phi_3997_;
            let _e3335 = ((_e3117.base_color.x * ((((f32((_e3111[0].color & 255u)) * _e3134) * _e2843) + ((f32((_e3111[1].color & 255u)) * _e3153) * _e2837.u)) + ((f32((_e3111[2].color & 255u)) * _e3175) * _e2837.v))) * _e3333.x);
            let _e3337 = ((_e3117.base_color.y * ((((f32(((_e3111[0].color >> bitcast<u32>(8i)) & 255u)) * _e3134) * _e2843) + ((f32(((_e3111[1].color >> bitcast<u32>(8i)) & 255u)) * _e3153) * _e2837.u)) + ((f32(((_e3111[2].color >> bitcast<u32>(8i)) & 255u)) * _e3175) * _e2837.v))) * _e3333.y);
            let _e3339 = ((_e3117.base_color.z * ((((f32(((_e3111[0].color >> bitcast<u32>(16i)) & 255u)) * _e3134) * _e2843) + ((f32(((_e3111[1].color >> bitcast<u32>(16i)) & 255u)) * _e3153) * _e2837.u)) + ((f32(((_e3111[2].color >> bitcast<u32>(16i)) & 255u)) * _e3175) * _e2837.v))) * _e3333.z);
            let _e3340 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e3024, _e3027);
            let _e3341 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e3021, _e3340);
            if ((_e3117.flags & 2u) == 0u) {
                phi_4012_ = 0u;
            } else {
                phi_4012_ = 1u;
            }
            let _e3346 = phi_4012_;
            if (_e3111[0].normal == 2147516416u) {
                phi_4242_ = _e3089;
            } else {
                let _e3359 = (f32((bitcast<i32>((_e3111[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3365 = (f32((bitcast<i32>(_e3111[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3369 = ((1f - abs(_e3359)) - abs(_e3365));
                if (_e3369 < 0f) {
                    phi_4039_ = -(_e3369);
                } else {
                    phi_4039_ = 0f;
                }
                let _e3373 = phi_4039_;
                if (_e3359 < 0f) {
                    phi_4046_ = (_e3359 + _e3373);
                } else {
                    phi_4046_ = (_e3359 - _e3373);
                }
                let _e3378 = phi_4046_;
                if (_e3365 < 0f) {
                    phi_4053_ = (_e3365 + _e3373);
                } else {
                    phi_4053_ = (_e3365 - _e3373);
                }
                let _e3383 = phi_4053_;
                let _e3390 = (1f / sqrt((((_e3378 * _e3378) + (_e3383 * _e3383)) + (_e3369 * _e3369))));
                let _e3406 = (f32((bitcast<i32>((_e3111[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3412 = (f32((bitcast<i32>(_e3111[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3416 = ((1f - abs(_e3406)) - abs(_e3412));
                if (_e3416 < 0f) {
                    phi_4088_ = -(_e3416);
                } else {
                    phi_4088_ = 0f;
                }
                let _e3420 = phi_4088_;
                if (_e3406 < 0f) {
                    phi_4095_ = (_e3406 + _e3420);
                } else {
                    phi_4095_ = (_e3406 - _e3420);
                }
                let _e3425 = phi_4095_;
                if (_e3412 < 0f) {
                    phi_4102_ = (_e3412 + _e3420);
                } else {
                    phi_4102_ = (_e3412 - _e3420);
                }
                let _e3430 = phi_4102_;
                let _e3437 = (1f / sqrt((((_e3425 * _e3425) + (_e3430 * _e3430)) + (_e3416 * _e3416))));
                let _e3456 = (f32((bitcast<i32>((_e3111[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3462 = (f32((bitcast<i32>(_e3111[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3466 = ((1f - abs(_e3456)) - abs(_e3462));
                if (_e3466 < 0f) {
                    phi_4140_ = -(_e3466);
                } else {
                    phi_4140_ = 0f;
                }
                let _e3470 = phi_4140_;
                if (_e3456 < 0f) {
                    phi_4147_ = (_e3456 + _e3470);
                } else {
                    phi_4147_ = (_e3456 - _e3470);
                }
                let _e3475 = phi_4147_;
                if (_e3462 < 0f) {
                    phi_4154_ = (_e3462 + _e3470);
                } else {
                    phi_4154_ = (_e3462 - _e3470);
                }
                let _e3480 = phi_4154_;
                let _e3487 = (1f / sqrt((((_e3475 * _e3475) + (_e3480 * _e3480)) + (_e3466 * _e3466))));
                let _e3494 = ((((_e3378 * _e3390) * _e2843) + ((_e3425 * _e3437) * _e2837.u)) + ((_e3475 * _e3487) * _e2837.v));
                let _e3495 = ((((_e3383 * _e3390) * _e2843) + ((_e3430 * _e3437) * _e2837.u)) + ((_e3480 * _e3487) * _e2837.v));
                let _e3496 = ((((_e3369 * _e3390) * _e2843) + ((_e3416 * _e3437) * _e2837.u)) + ((_e3466 * _e3487) * _e2837.v));
                if (_e2837.instance < _e95) {
                } else {
                    return;
                }
                let _e3503 = instances.member[(0u + _e2837.instance)].world_to_object[0u];
                let _e3512 = instances.member[(0u + _e2837.instance)].world_to_object[1u];
                let _e3524 = instances.member[(0u + _e2837.instance)].world_to_object[2u];
                let _e3531 = (((_e3503.x * _e3494) + (_e3512.x * _e3495)) + (_e3524.x * _e3496));
                let _e3532 = (((_e3503.y * _e3494) + (_e3512.y * _e3495)) + (_e3524.y * _e3496));
                let _e3533 = (((_e3503.z * _e3494) + (_e3512.z * _e3495)) + (_e3524.z * _e3496));
                let _e3539 = sqrt((((_e3531 * _e3531) + (_e3532 * _e3532)) + (_e3533 * _e3533)));
                if (_e3539 > 0f) {
                    let _e3541 = (_e3531 / _e3539);
                    let _e3542 = (_e3532 / _e3539);
                    let _e3543 = (_e3533 / _e3539);
                    if ((((_e3541 * _e3089.x) + (_e3542 * _e3089.y)) + (_e3543 * _e3089.z)) < 0f) {
                        phi_4240_ = vec3<f32>(-(_e3541), -(_e3542), -(_e3543));
                    } else {
                        phi_4240_ = vec3<f32>(_e3541, _e3542, _e3543);
                    }
                    let _e3559 = phi_4240_;
                    phi_4241_ = _e3559;
                } else {
                    phi_4241_ = _e3089;
                }
                let _e3561 = phi_4241_;
                phi_4242_ = _e3561;
            }
            let _e3563 = phi_4242_;
            if (_e3335 > 0f) {
                if (_e3335 < 1f) {
                    phi_4251_ = _e3335;
                } else {
                    phi_4251_ = 1f;
                }
                let _e3567 = phi_4251_;
                phi_4252_ = _e3567;
            } else {
                phi_4252_ = 0f;
            }
            let _e3569 = phi_4252_;
            if (_e3337 > 0f) {
                if (_e3337 < 1f) {
                    phi_4262_ = _e3337;
                } else {
                    phi_4262_ = 1f;
                }
                let _e3574 = phi_4262_;
                phi_4263_ = _e3574;
            } else {
                phi_4263_ = 0f;
            }
            let _e3576 = phi_4263_;
            if (_e3339 > 0f) {
                if (_e3339 < 1f) {
                    phi_4273_ = _e3339;
                } else {
                    phi_4273_ = 1f;
                }
                let _e3581 = phi_4273_;
                phi_4274_ = _e3581;
            } else {
                phi_4274_ = 0f;
            }
            let _e3583 = phi_4274_;
            let _e3586 = ((sqrt(_e3569) * 255f) + 0.5f);
            let _e3595 = ((sqrt(_e3576) * 255f) + 0.5f);
            let _e3607 = ((sqrt(_e3583) * 255f) + 0.5f);
            phi_4309_ = abi_Sample(vec3<f32>(_e2997, _e2998, _e2999), _e3341, _e3089, _e3346, _e3563, ((select(select(u32(_e3586), 0u, (_e3586 < bitcast<f32>(0u))), 4294967295u, (_e3586 > bitcast<f32>(1333788671u))) | (select(select(u32(_e3595), 0u, (_e3595 < bitcast<f32>(0u))), 4294967295u, (_e3595 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e3607), 0u, (_e3607 < bitcast<f32>(0u))), 4294967295u, (_e3607 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_4309_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e3621 = phi_4309_;
        if (_e113.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e113.shift)] = _e3621;
        if (_e2837.triangle != 4294967295u) {
            let _e3630 = ((1f - _e2837.u) - _e2837.v);
            if (_e2837.triangle < _e83) {
            } else {
                return;
            }
            let _e3635 = triangles.member[(0u + _e2837.triangle)];
            let _e3637 = (_e3635.i0_ & 2147483647u);
            if (_e3637 < _e104) {
            } else {
                return;
            }
            let _e3643 = before.member[(0u + _e3637)];
            if (_e3635.i1_ < _e104) {
            } else {
                return;
            }
            let _e3647 = before.member[(0u + _e3635.i1_)];
            if (_e3635.i2_ < _e104) {
            } else {
                return;
            }
            let _e3651 = before.member[(0u + _e3635.i2_)];
            if (_e2837.instance < _e95) {
            } else {
                return;
            }
            let _e3661 = instances.member[(0u + _e2837.instance)].object_to_world[0u];
            let _e3674 = instances.member[(0u + _e2837.instance)].object_to_world[1u];
            let _e3687 = instances.member[(0u + _e2837.instance)].object_to_world[2u];
            if (_e2837.instance < _e95) {
            } else {
                return;
            }
            let _e3711 = instances.member[(0u + _e2837.instance)].object_to_world[0u];
            let _e3724 = instances.member[(0u + _e2837.instance)].object_to_world[1u];
            let _e3737 = instances.member[(0u + _e2837.instance)].object_to_world[2u];
            if (_e2837.instance < _e95) {
            } else {
                return;
            }
            let _e3764 = instances.member[(0u + _e2837.instance)].object_to_world[0u];
            let _e3777 = instances.member[(0u + _e2837.instance)].object_to_world[1u];
            let _e3790 = instances.member[(0u + _e2837.instance)].object_to_world[2u];
            phi_4532_ = vec3<f32>((((((((_e3661.x * _e3643.x) + (_e3661.y * _e3643.y)) + (_e3661.z * _e3643.z)) + (_e3661.w * 1f)) * _e3630) + (((((_e3711.x * _e3647.x) + (_e3711.y * _e3647.y)) + (_e3711.z * _e3647.z)) + (_e3711.w * 1f)) * _e2837.u)) + (((((_e3764.x * _e3651.x) + (_e3764.y * _e3651.y)) + (_e3764.z * _e3651.z)) + (_e3764.w * 1f)) * _e2837.v)), (((((((_e3674.x * _e3643.x) + (_e3674.y * _e3643.y)) + (_e3674.z * _e3643.z)) + (_e3674.w * 1f)) * _e3630) + (((((_e3724.x * _e3647.x) + (_e3724.y * _e3647.y)) + (_e3724.z * _e3647.z)) + (_e3724.w * 1f)) * _e2837.u)) + (((((_e3777.x * _e3651.x) + (_e3777.y * _e3651.y)) + (_e3777.z * _e3651.z)) + (_e3777.w * 1f)) * _e2837.v)), (((((((_e3687.x * _e3643.x) + (_e3687.y * _e3643.y)) + (_e3687.z * _e3643.z)) + (_e3687.w * 1f)) * _e3630) + (((((_e3737.x * _e3647.x) + (_e3737.y * _e3647.y)) + (_e3737.z * _e3647.z)) + (_e3737.w * 1f)) * _e2837.u)) + (((((_e3790.x * _e3651.x) + (_e3790.y * _e3651.y)) + (_e3790.z * _e3651.z)) + (_e3790.w * 1f)) * _e2837.v)));
        } else {
            phi_4532_ = vec3<f32>(0f, 0f, 0f);
        }
        let _e3810 = phi_4532_;
        if (_e113.shift < arrayLength((&past.member))) {
        } else {
            return;
        }
        past.member[(0u + _e113.shift)] = vec4<f32>(_e3810.x, _e3810.y, _e3810.z, 1f);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_instanced_alpha_color_motion_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
