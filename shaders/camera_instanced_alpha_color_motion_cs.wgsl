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
    var phi_795_: bool;
    var phi_796_: bool;
    var phi_797_: bool;
    var phi_798_: bool;
    var phi_802_: bool;
    var phi_815_: bool;
    var phi_816_: bool;
    var phi_817_: bool;
    var phi_818_: bool;
    var phi_822_: bool;
    var phi_835_: bool;
    var phi_836_: bool;
    var phi_837_: bool;
    var phi_841_: bool;
    var phi_842_: bool;
    var phi_843_: bool;
    var phi_844_: bool;
    var phi_845_: bool;
    var phi_849_: bool;
    var phi_925_: f32;
    var phi_932_: f32;
    var phi_940_: f32;
    var phi_947_: f32;
    var phi_955_: f32;
    var phi_962_: f32;
    var phi_985_: f32;
    var phi_990_: f32;
    var phi_995_: f32;
    var phi_1000_: f32;
    var phi_1005_: f32;
    var phi_1024_: u32;
    var phi_1029_: u32;
    var phi_1034_: u32;
    var phi_1148_: bool;
    var phi_1149_: bool;
    var phi_1180_: u32;
    var phi_1182_: u32;
    var phi_1185_: lt_bvh_Hit;
    var phi_1270_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1297_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1324_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1330_: u32;
    var phi_1333_: u32;
    var phi_1347_: u32;
    var phi_1357_: u32;
    var phi_1367_: u32;
    var phi_1385_: u32;
    var phi_1395_: u32;
    var phi_1405_: u32;
    var phi_1441_: u32;
    var phi_1454_: u32;
    var phi_1459_: u32;
    var phi_1460_: u32;
    var phi_1461_: u32;
    var phi_1331_: u32;
    var phi_1334_: u32;
    var local_4: u32;
    var local_5: u32;
    var local_6: u32;
    var phi_1519_: u32;
    var phi_1522_: lt_bvh_Hit;
    var phi_1577_: f32;
    var phi_1582_: f32;
    var phi_1587_: f32;
    var phi_1595_: f32;
    var phi_1600_: f32;
    var phi_1605_: f32;
    var phi_1737_: bool;
    var phi_1738_: bool;
    var phi_1739_: bool;
    var phi_1740_: bool;
    var phi_1744_: bool;
    var phi_1757_: bool;
    var phi_1758_: bool;
    var phi_1759_: bool;
    var phi_1760_: bool;
    var phi_1764_: bool;
    var phi_1777_: bool;
    var phi_1778_: bool;
    var phi_1779_: bool;
    var phi_1783_: bool;
    var phi_1784_: bool;
    var phi_1785_: bool;
    var phi_1786_: bool;
    var phi_1787_: bool;
    var phi_1791_: bool;
    var phi_1861_: f32;
    var phi_1868_: f32;
    var phi_1875_: f32;
    var phi_1882_: f32;
    var phi_1889_: f32;
    var phi_1896_: f32;
    var phi_1913_: f32;
    var phi_1918_: f32;
    var phi_1923_: f32;
    var phi_1928_: f32;
    var phi_1933_: f32;
    var phi_1959_: bool;
    var phi_1960_: bool;
    var phi_1968_: u32;
    var phi_1969_: u32;
    var phi_1980_: vec3<f32>;
    var phi_1981_: vec3<f32>;
    var phi_1994_: u32;
    var phi_1999_: u32;
    var phi_2004_: u32;
    var phi_2118_: bool;
    var phi_2119_: bool;
    var phi_2150_: u32;
    var phi_2152_: lt_bvh_Hit;
    var phi_2155_: u32;
    var phi_2236_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2263_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2290_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2296_: u32;
    var phi_2299_: u32;
    var phi_2313_: u32;
    var phi_2323_: u32;
    var phi_2333_: u32;
    var phi_2351_: u32;
    var phi_2361_: u32;
    var phi_2371_: u32;
    var phi_2407_: u32;
    var phi_2420_: u32;
    var phi_2425_: u32;
    var phi_2426_: u32;
    var phi_2427_: u32;
    var phi_2297_: u32;
    var phi_2300_: u32;
    var local_7: u32;
    var local_8: u32;
    var local_9: u32;
    var phi_2485_: lt_bvh_Hit;
    var phi_2488_: u32;
    var phi_2532_: vec3<f32>;
    var phi_2533_: vec3<f32>;
    var phi_2562_: vec3<f32>;
    var phi_2563_: vec3<f32>;
    var phi_2592_: vec3<f32>;
    var phi_2593_: vec3<f32>;
    var phi_2611_: bool;
    var phi_2612_: bool;
    var phi_2616_: f32;
    var phi_2617_: f32;
    var phi_2618_: f32;
    var phi_2619_: f32;
    var phi_2627_: f32;
    var phi_2637_: bool;
    var phi_2638_: bool;
    var phi_2642_: f32;
    var phi_2643_: f32;
    var phi_2644_: f32;
    var phi_2645_: f32;
    var phi_2653_: f32;
    var phi_2663_: bool;
    var phi_2664_: bool;
    var phi_2668_: f32;
    var phi_2669_: f32;
    var phi_2670_: f32;
    var phi_2671_: f32;
    var phi_2679_: f32;
    var phi_2694_: f32;
    var phi_2695_: bool;
    var phi_2696_: f32;
    var phi_2697_: bool;
    var phi_2698_: f32;
    var phi_2699_: bool;
    var phi_2717_: f32;
    var phi_2718_: bool;
    var phi_2719_: bool;
    var phi_2720_: f32;
    var phi_2721_: bool;
    var phi_2722_: bool;
    var phi_2726_: bool;
    var phi_2727_: f32;
    var phi_2728_: bool;
    var phi_2756_: vec3<f32>;
    var phi_2757_: vec3<f32>;
    var phi_2782_: vec3<f32>;
    var phi_2783_: vec3<f32>;
    var phi_2808_: vec3<f32>;
    var phi_2809_: vec3<f32>;
    var phi_2865_: f32;
    var phi_2874_: f32;
    var phi_2883_: f32;
    var phi_2892_: f32;
    var phi_2899_: f32;
    var phi_2906_: f32;
    var phi_2919_: f32;
    var phi_2928_: f32;
    var phi_2937_: f32;
    var phi_2946_: f32;
    var phi_2953_: f32;
    var phi_2960_: f32;
    var phi_2977_: f32;
    var phi_2982_: f32;
    var phi_2987_: f32;
    var phi_2995_: f32;
    var phi_3000_: f32;
    var phi_3005_: f32;
    var phi_3017_: f32;
    var phi_3022_: f32;
    var phi_3027_: f32;
    var phi_3032_: f32;
    var phi_3037_: lt_bvh_triangle_Intersection;
    var phi_3038_: bool;
    var phi_3039_: lt_bvh_triangle_Intersection;
    var phi_3040_: bool;
    var phi_3044_: lt_bvh_triangle_Intersection;
    var phi_3045_: bool;
    var phi_3046_: lt_bvh_triangle_Intersection;
    var phi_3047_: bool;
    var phi_3048_: bool;
    var phi_3052_: bool;
    var phi_3056_: lt_bvh_triangle_Intersection;
    var phi_3094_: bool;
    var phi_3095_: bool;
    var phi_3096_: bool;
    var phi_3097_: bool;
    var phi_3098_: bool;
    var phi_3099_: bool;
    var phi_3103_: bool;
    var phi_3104_: bool;
    var phi_3307_: f32;
    var phi_3310_: bool;
    var phi_3311_: bool;
    var phi_3315_: bool;
    var phi_3323_: lt_bvh_Hit;
    var phi_3324_: lt_bvh_Hit;
    var phi_3325_: lt_bvh_Hit;
    var phi_3326_: lt_bvh_Hit;
    var phi_2486_: lt_bvh_Hit;
    var phi_2489_: u32;
    var phi_3327_: bool;
    var phi_3366_: bool;
    var phi_3367_: bool;
    var phi_3398_: u32;
    var phi_2153_: lt_bvh_Hit;
    var phi_2156_: u32;
    var phi_3399_: lt_bvh_Hit;
    var phi_3400_: lt_bvh_Hit;
    var phi_3401_: bool;
    var phi_3405_: lt_bvh_Hit;
    var phi_3406_: lt_bvh_Hit;
    var phi_3407_: lt_bvh_Hit;
    var phi_3408_: lt_bvh_Hit;
    var phi_1520_: u32;
    var phi_1523_: lt_bvh_Hit;
    var phi_3409_: bool;
    var phi_3448_: bool;
    var phi_3449_: bool;
    var phi_3480_: u32;
    var phi_1183_: u32;
    var phi_1186_: lt_bvh_Hit;
    var phi_3481_: lt_bvh_Hit;
    var phi_3482_: lt_bvh_Hit;
    var phi_3483_: bool;
    var phi_3487_: lt_bvh_Hit;
    var phi_3674_: f32;
    var phi_3679_: f32;
    var phi_3684_: f32;
    var phi_3692_: f32;
    var phi_3697_: f32;
    var phi_3702_: f32;
    var phi_3766_: vec3<f32>;
    var phi_4009_: vec3<f32>;
    var phi_4024_: u32;
    var phi_4051_: f32;
    var phi_4058_: f32;
    var phi_4065_: f32;
    var phi_4100_: f32;
    var phi_4107_: f32;
    var phi_4114_: f32;
    var phi_4152_: f32;
    var phi_4159_: f32;
    var phi_4166_: f32;
    var phi_4252_: vec3<f32>;
    var phi_4253_: vec3<f32>;
    var phi_4254_: vec3<f32>;
    var phi_4263_: f32;
    var phi_4264_: f32;
    var phi_4274_: f32;
    var phi_4275_: f32;
    var phi_4285_: f32;
    var phi_4286_: f32;
    var phi_4321_: abi_Sample;
    var phi_4544_: vec3<f32>;
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
        let _e175 = abs(_e170.direction.x);
        let _e177 = abs(_e170.direction.y);
        let _e179 = abs(_e170.direction.z);
        if (abs(_e170.origin.x) < 1000000000000000f) {
            if (abs(_e170.origin.y) < 1000000000000000f) {
                phi_795_ = (abs(_e170.origin.z) < 1000000000000000f);
                phi_796_ = false;
            } else {
                phi_795_ = bool();
                phi_796_ = true;
            }
            let _e191 = phi_795_;
            let _e193 = phi_796_;
            phi_797_ = _e191;
            phi_798_ = _e193;
        } else {
            phi_797_ = bool();
            phi_798_ = true;
        }
        let _e195 = phi_797_;
        let _e197 = phi_798_;
        if _e197 {
            phi_802_ = false;
        } else {
            phi_802_ = _e195;
        }
        let _e199 = phi_802_;
        if _e199 {
            if (_e175 < 1000000000000000f) {
                if (_e177 < 1000000000000000f) {
                    phi_815_ = (_e179 < 1000000000000000f);
                    phi_816_ = false;
                } else {
                    phi_815_ = bool();
                    phi_816_ = true;
                }
                let _e204 = phi_815_;
                let _e206 = phi_816_;
                phi_817_ = _e204;
                phi_818_ = _e206;
            } else {
                phi_817_ = bool();
                phi_818_ = true;
            }
            let _e208 = phi_817_;
            let _e210 = phi_818_;
            if _e210 {
                phi_822_ = false;
            } else {
                phi_822_ = _e208;
            }
            let _e212 = phi_822_;
            if _e212 {
                if (_e175 > 0f) {
                    phi_836_ = bool();
                    phi_837_ = true;
                } else {
                    let _e214 = (_e177 > 0f);
                    if _e214 {
                        phi_835_ = bool();
                    } else {
                        phi_835_ = (_e179 > 0f);
                    }
                    let _e217 = phi_835_;
                    phi_836_ = _e217;
                    phi_837_ = _e214;
                }
                let _e219 = phi_836_;
                let _e221 = phi_837_;
                if _e221 {
                    phi_841_ = true;
                } else {
                    phi_841_ = _e219;
                }
                let _e223 = phi_841_;
                phi_842_ = _e223;
                phi_843_ = false;
            } else {
                phi_842_ = bool();
                phi_843_ = true;
            }
            let _e225 = phi_842_;
            let _e227 = phi_843_;
            phi_844_ = _e225;
            phi_845_ = _e227;
        } else {
            phi_844_ = bool();
            phi_845_ = true;
        }
        let _e229 = phi_844_;
        let _e231 = phi_845_;
        if _e231 {
            phi_849_ = false;
        } else {
            phi_849_ = _e229;
        }
        let _e233 = phi_849_;
        if _e233 {
            let _e234 = (_e119 >= _e80);
            if _e234 {
                phi_3481_ = lt_bvh_Hit();
            } else {
                if (_e119 < _e80) {
                } else {
                    return;
                }
                let _e240 = nodes.member[(0u + _e119)].frame[0u];
                let _e244 = nodes.member[(0u + _e119)].frame[1u];
                let _e248 = nodes.member[(0u + _e119)].frame[2u];
                let _e252 = nodes.member[(0u + _e119)].frame[0u];
                let _e256 = nodes.member[(0u + _e119)].frame[1u];
                let _e260 = nodes.member[(0u + _e119)].frame[2u];
                let _e264 = nodes.member[(0u + _e119)].frame[3u];
                let _e303 = core_intrinsics_maximum_number_nsz_f32_(abs(_e170.direction.x), abs(_e170.direction.y));
                let _e304 = core_intrinsics_maximum_number_nsz_f32_(_e303, abs(_e170.direction.z));
                let _e305 = (_e304 * 0.0000000000009094947f);
                if (abs(_e170.direction.x) < _e305) {
                    phi_925_ = _e305;
                } else {
                    phi_925_ = abs(_e170.direction.x);
                }
                let _e311 = phi_925_;
                if (_e170.direction.x < 0f) {
                    phi_932_ = (-1f / _e311);
                } else {
                    phi_932_ = (1f / _e311);
                }
                let _e316 = phi_932_;
                if (abs(_e170.direction.y) < _e305) {
                    phi_940_ = _e305;
                } else {
                    phi_940_ = abs(_e170.direction.y);
                }
                let _e322 = phi_940_;
                if (_e170.direction.y < 0f) {
                    phi_947_ = (-1f / _e322);
                } else {
                    phi_947_ = (1f / _e322);
                }
                let _e327 = phi_947_;
                if (abs(_e170.direction.z) < _e305) {
                    phi_955_ = _e305;
                } else {
                    phi_955_ = abs(_e170.direction.z);
                }
                let _e333 = phi_955_;
                if (_e170.direction.z < 0f) {
                    phi_962_ = (-1f / _e333);
                } else {
                    phi_962_ = (1f / _e333);
                }
                let _e338 = phi_962_;
                let _e345 = abs((bitcast<f32>(_e240) - _e170.origin.x));
                let _e346 = abs((bitcast<f32>(_e244) - _e170.origin.y));
                let _e347 = abs((bitcast<f32>(_e248) - _e170.origin.z));
                let _e354 = abs(((bitcast<f32>(_e252) + (bitcast<f32>((((_e264 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e170.origin.x));
                let _e355 = abs(((bitcast<f32>(_e256) + (bitcast<f32>((((_e264 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e170.origin.y));
                let _e356 = abs(((bitcast<f32>(_e260) + (bitcast<f32>((((_e264 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e170.origin.z));
                if (_e345 > _e354) {
                    phi_985_ = _e345;
                } else {
                    phi_985_ = _e354;
                }
                let _e359 = phi_985_;
                if (_e346 > _e355) {
                    phi_990_ = _e346;
                } else {
                    phi_990_ = _e355;
                }
                let _e362 = phi_990_;
                if (_e347 > _e356) {
                    phi_995_ = _e347;
                } else {
                    phi_995_ = _e356;
                }
                let _e365 = phi_995_;
                if (_e359 > _e362) {
                    phi_1000_ = _e359;
                } else {
                    phi_1000_ = _e362;
                }
                let _e368 = phi_1000_;
                if (_e368 > _e365) {
                    phi_1005_ = _e368;
                } else {
                    phi_1005_ = _e365;
                }
                let _e371 = phi_1005_;
                let _e375 = (_e371 * 0.0000019073486f);
                let _e376 = (abs(_e316) * _e375);
                let _e377 = (abs(_e327) * _e375);
                let _e378 = (abs(_e338) * _e375);
                let _e382 = (_e371 * 0.0000009536743f);
                let _e383 = (abs(_e316) * _e382);
                let _e384 = (abs(_e327) * _e382);
                let _e385 = (abs(_e338) * _e382);
                if (_e316 < 0f) {
                    phi_1024_ = 0u;
                } else {
                    phi_1024_ = 1u;
                }
                let _e388 = phi_1024_;
                if (_e327 < 0f) {
                    phi_1029_ = 0u;
                } else {
                    phi_1029_ = 2u;
                }
                let _e391 = phi_1029_;
                if (_e338 < 0f) {
                    phi_1034_ = 0u;
                } else {
                    phi_1034_ = 4u;
                }
                let _e394 = phi_1034_;
                let _e396 = ((_e388 | _e391) | _e394);
                let _e397 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e119, 2147483648u);
                local_3 = lt_bvh_traverse_Stack(array<u32, 32>(_e397.first[0], _e397.first[1], _e397.first[2], _e397.first[3], _e397.first[4], _e397.first[5], _e397.first[6], _e397.first[7], _e397.first[8], _e397.first[9], _e397.first[10], _e397.first[11], _e397.first[12], _e397.first[13], _e397.first[14], _e397.first[15], _e397.first[16], _e397.first[17], _e397.first[18], _e397.first[19], _e397.first[20], _e397.first[21], _e397.first[22], _e397.first[23], _e397.first[24], _e397.first[25], _e397.first[26], _e397.first[27], _e397.first[28], _e397.first[29], _e397.first[30], _e397.first[31]), array<u32, 32>(_e397.mask[0], _e397.mask[1], _e397.mask[2], _e397.mask[3], _e397.mask[4], _e397.mask[5], _e397.mask[6], _e397.mask[7], _e397.mask[8], _e397.mask[9], _e397.mask[10], _e397.mask[11], _e397.mask[12], _e397.mask[13], _e397.mask[14], _e397.mask[15], _e397.mask[16], _e397.mask[17], _e397.mask[18], _e397.mask[19], _e397.mask[20], _e397.mask[21], _e397.mask[22], _e397.mask[23], _e397.mask[24], _e397.mask[25], _e397.mask[26], _e397.mask[27], _e397.mask[28], _e397.mask[29], _e397.mask[30], _e397.mask[31]), _e397.len, _e397.group, _e397.group_mask);
                let _e471 = local_3.group_mask;
                if ((_e471 & 4278190080u) == 0u) {
                    let _e475 = local_3.len;
                    if (_e475 == 0u) {
                        phi_1148_ = false;
                    } else {
                        let _e479 = local_3.len;
                        local_3.len = (_e479 - 1u);
                        let _e482 = local_3.len;
                        if (_e482 < 32u) {
                        } else {
                            return;
                        }
                        let _e487 = local_3.first[(0u + _e482)];
                        local_3.group = _e487;
                        let _e490 = local_3.len;
                        if (_e490 < 32u) {
                        } else {
                            return;
                        }
                        let _e495 = local_3.mask[(0u + _e490)];
                        local_3.group_mask = _e495;
                        phi_1148_ = true;
                    }
                    let _e498 = phi_1148_;
                    phi_1149_ = _e498;
                } else {
                    phi_1149_ = true;
                }
                let _e500 = phi_1149_;
                if _e500 {
                    let _e502 = local_3.group_mask;
                    let _e508 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e502)), 32u, (_e502 == 0u)));
                    let _e512 = local_3.group_mask;
                    let _e526 = local_3.group_mask;
                    local_3.group_mask = (_e526 & ~((1u << bitcast<u32>((_e508 & 31u)))));
                    let _e529 = local_3.group;
                    phi_1180_ = (_e529 + countOneBits(((_e512 & ~((4294967295u << bitcast<u32>((((_e508 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1180_ = 4294967295u;
                }
                let _e532 = phi_1180_;
                phi_1182_ = _e532;
                phi_1185_ = _e172;
                loop {
                    let _e534 = phi_1182_;
                    let _e536 = phi_1185_;
                    local_13 = _e536;
                    let _e537 = (_e534 != 4294967295u);
                    if _e537 {
                        if (_e534 < _e80) {
                        } else {
                            return;
                        }
                        let _e545 = nodes.member[(0u + _e534)].frame[3u];
                        let _e570 = (bitcast<f32>((((_e545 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e316);
                        let _e571 = (bitcast<f32>((((_e545 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e327);
                        let _e572 = (bitcast<f32>((((_e545 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e338);
                        let _e575 = nodes.member[(0u + _e534)].frame[0u];
                        let _e579 = nodes.member[(0u + _e534)].frame[1u];
                        let _e583 = nodes.member[(0u + _e534)].frame[2u];
                        let _e591 = ((bitcast<f32>(_e575) - _e170.origin.x) * _e316);
                        let _e592 = ((bitcast<f32>(_e579) - _e170.origin.y) * _e327);
                        let _e593 = ((bitcast<f32>(_e583) - _e170.origin.z) * _e338);
                        let _e601 = nodes.member[(0u + _e534)].x;
                        if (_e316 < 0f) {
                            let _e612 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e601.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e618 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e612.unnamed.word, _e601.w), _e612.unnamed_1);
                            let _e624 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e618.unnamed, lt_mask_LightPlace(_e601.x, _e618.unnamed_1.shift));
                            phi_1270_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e624.unnamed, lt_mask_LightPlace(_e624.unnamed_1.word, _e601.y));
                        } else {
                            let _e640 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e601.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e646 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e640.unnamed.word, _e601.y), _e640.unnamed_1);
                            let _e652 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e646.unnamed, lt_mask_LightPlace(_e601.z, _e646.unnamed_1.shift));
                            phi_1270_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e652.unnamed, lt_mask_LightPlace(_e652.unnamed_1.word, _e601.w));
                        }
                        let _e660 = phi_1270_;
                        let _e670 = nodes.member[(0u + _e534)].y;
                        if (_e327 < 0f) {
                            let _e681 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e670.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e687 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e681.unnamed.word, _e670.w), _e681.unnamed_1);
                            let _e693 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e687.unnamed, lt_mask_LightPlace(_e670.x, _e687.unnamed_1.shift));
                            phi_1297_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e693.unnamed, lt_mask_LightPlace(_e693.unnamed_1.word, _e670.y));
                        } else {
                            let _e709 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e670.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e715 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e709.unnamed.word, _e670.y), _e709.unnamed_1);
                            let _e721 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e715.unnamed, lt_mask_LightPlace(_e670.z, _e715.unnamed_1.shift));
                            phi_1297_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e721.unnamed, lt_mask_LightPlace(_e721.unnamed_1.word, _e670.w));
                        }
                        let _e729 = phi_1297_;
                        let _e739 = nodes.member[(0u + _e534)].z;
                        if (_e338 < 0f) {
                            let _e750 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e739.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e756 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e750.unnamed.word, _e739.w), _e750.unnamed_1);
                            let _e762 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e756.unnamed, lt_mask_LightPlace(_e739.x, _e756.unnamed_1.shift));
                            phi_1324_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e762.unnamed, lt_mask_LightPlace(_e762.unnamed_1.word, _e739.y));
                        } else {
                            let _e778 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e739.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e784 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e778.unnamed.word, _e739.y), _e778.unnamed_1);
                            let _e790 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e784.unnamed, lt_mask_LightPlace(_e739.z, _e784.unnamed_1.shift));
                            phi_1324_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e790.unnamed, lt_mask_LightPlace(_e790.unnamed_1.word, _e739.w));
                        }
                        let _e798 = phi_1324_;
                        phi_1330_ = 0u;
                        phi_1333_ = 0u;
                        loop {
                            let _e808 = phi_1330_;
                            let _e810 = phi_1333_;
                            local_4 = _e810;
                            local_5 = _e810;
                            local_6 = _e810;
                            let _e811 = (_e808 < 8u);
                            if _e811 {
                                let _e813 = (_e808 >> bitcast<u32>(2i));
                                let _e814 = (_e808 & 3u);
                                if (_e813 == 0u) {
                                    phi_1347_ = _e660.unnamed.word;
                                } else {
                                    phi_1347_ = _e660.unnamed.shift;
                                }
                                let _e817 = phi_1347_;
                                if (_e813 == 0u) {
                                    phi_1357_ = _e729.unnamed.word;
                                } else {
                                    phi_1357_ = _e729.unnamed.shift;
                                }
                                let _e826 = phi_1357_;
                                if (_e813 == 0u) {
                                    phi_1367_ = _e798.unnamed.word;
                                } else {
                                    phi_1367_ = _e798.unnamed.shift;
                                }
                                let _e835 = phi_1367_;
                                let _e848 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e817 >> bitcast<u32>(((_e814 * 8u) & 31u))) & 255u)) * _e570) + (_e591 - _e376)), ((f32(((_e826 >> bitcast<u32>(((_e814 * 8u) & 31u))) & 255u)) * _e571) + (_e592 - _e377)));
                                let _e849 = core_intrinsics_maximum_number_nsz_f32_(_e848, ((f32(((_e835 >> bitcast<u32>(((_e814 * 8u) & 31u))) & 255u)) * _e572) + (_e593 - _e378)));
                                if (_e813 == 0u) {
                                    phi_1385_ = _e660.unnamed_1.word;
                                } else {
                                    phi_1385_ = _e660.unnamed_1.shift;
                                }
                                let _e852 = phi_1385_;
                                if (_e813 == 0u) {
                                    phi_1395_ = _e729.unnamed_1.word;
                                } else {
                                    phi_1395_ = _e729.unnamed_1.shift;
                                }
                                let _e861 = phi_1395_;
                                if (_e813 == 0u) {
                                    phi_1405_ = _e798.unnamed_1.word;
                                } else {
                                    phi_1405_ = _e798.unnamed_1.shift;
                                }
                                let _e870 = phi_1405_;
                                let _e883 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e852 >> bitcast<u32>(((_e814 * 8u) & 31u))) & 255u)) * _e570) + (_e591 + _e376)), ((f32(((_e861 >> bitcast<u32>(((_e814 * 8u) & 31u))) & 255u)) * _e571) + (_e592 + _e377)));
                                let _e884 = core_intrinsics_minimum_number_nsz_f32_(_e883, ((f32(((_e870 >> bitcast<u32>(((_e814 * 8u) & 31u))) & 255u)) * _e572) + (_e593 + _e378)));
                                if (_e849 <= _e884) {
                                    if (_e849 <= _e536.t) {
                                        if (_e884 >= _e170.tmin) {
                                            if (_e813 == 0u) {
                                                let _e891 = nodes.member[(0u + _e534)].links[2u];
                                                phi_1441_ = _e891;
                                            } else {
                                                let _e894 = nodes.member[(0u + _e534)].links[3u];
                                                phi_1441_ = _e894;
                                            }
                                            let _e896 = phi_1441_;
                                            let _e901 = ((_e896 >> bitcast<u32>(((_e814 * 8u) & 31u))) & 255u);
                                            let _e902 = (_e901 & 31u);
                                            if (_e902 >= 24u) {
                                                phi_1454_ = (24u + ((_e902 - 24u) ^ _e396));
                                            } else {
                                                phi_1454_ = _e902;
                                            }
                                            let _e908 = phi_1454_;
                                            phi_1459_ = (_e810 | ((_e901 >> bitcast<u32>(5i)) << bitcast<u32>((_e908 & 31u))));
                                        } else {
                                            phi_1459_ = _e810;
                                        }
                                        let _e916 = phi_1459_;
                                        phi_1460_ = _e916;
                                    } else {
                                        phi_1460_ = _e810;
                                    }
                                    let _e918 = phi_1460_;
                                    phi_1461_ = _e918;
                                } else {
                                    phi_1461_ = _e810;
                                }
                                let _e920 = phi_1461_;
                                phi_1331_ = (_e808 + 1u);
                                phi_1334_ = _e920;
                            } else {
                                phi_1331_ = u32();
                                phi_1334_ = u32();
                            }
                            let _e923 = phi_1331_;
                            let _e925 = phi_1334_;
                            continue;
                            continuing {
                                phi_1330_ = _e923;
                                phi_1333_ = _e925;
                                break if !(_e811);
                            }
                        }
                        let _e929 = nodes.member[(0u + _e534)].links[0u];
                        let _e933 = nodes.member[(0u + _e534)].frame[3u];
                        let _e937 = local_4;
                        if ((_e937 & 4278190080u) == 0u) {
                        } else {
                            let _e941 = local_3.group_mask;
                            if ((_e941 & 4278190080u) == 0u) {
                            } else {
                                let _e945 = local_3.len;
                                if (_e945 < 32u) {
                                    let _e948 = local_3.group;
                                    let _e950 = local_3.len;
                                    if (_e950 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_3.first[(0u + _e950)] = _e948;
                                    let _e956 = local_3.group_mask;
                                    let _e958 = local_3.len;
                                    if (_e958 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_3.mask[(0u + _e958)] = _e956;
                                    let _e965 = local_3.len;
                                    local_3.len = (_e965 + 1u);
                                }
                            }
                            local_3.group = (_e119 + _e929);
                            let _e969 = local_5;
                            local_3.group_mask = ((_e969 & 4278190080u) | (_e933 >> bitcast<u32>(24i)));
                        }
                        let _e974 = local_6;
                        phi_1519_ = (_e974 & 16777215u);
                        phi_1522_ = _e536;
                        loop {
                            let _e977 = phi_1519_;
                            let _e979 = phi_1522_;
                            local_12 = _e979;
                            if (_e977 == 0u) {
                                phi_1520_ = u32();
                                phi_1523_ = lt_bvh_Hit();
                                phi_3409_ = false;
                            } else {
                                let _e983 = nodes.member[(0u + _e534)].links[1u];
                                let _e987 = (_e983 + select(firstTrailingBit(_e977), 32u, (_e977 == 0u)));
                                if (_e987 < _e95) {
                                } else {
                                    return;
                                }
                                let _e994 = instances.member[(0u + _e987)].low_world;
                                let _e996 = instances.member[(0u + _e987)].high_world;
                                let _e1006 = ((_e994.x - _e170.origin.x) * _e316);
                                let _e1007 = ((_e994.y - _e170.origin.y) * _e327);
                                let _e1008 = ((_e994.z - _e170.origin.z) * _e338);
                                let _e1018 = ((_e996.x - _e170.origin.x) * _e316);
                                let _e1019 = ((_e996.y - _e170.origin.y) * _e327);
                                let _e1020 = ((_e996.z - _e170.origin.z) * _e338);
                                if (_e1006 < _e1018) {
                                    phi_1577_ = _e1006;
                                } else {
                                    phi_1577_ = _e1018;
                                }
                                let _e1023 = phi_1577_;
                                if (_e1007 < _e1019) {
                                    phi_1582_ = _e1007;
                                } else {
                                    phi_1582_ = _e1019;
                                }
                                let _e1026 = phi_1582_;
                                if (_e1008 < _e1020) {
                                    phi_1587_ = _e1008;
                                } else {
                                    phi_1587_ = _e1020;
                                }
                                let _e1029 = phi_1587_;
                                if (_e1006 > _e1018) {
                                    phi_1595_ = _e1006;
                                } else {
                                    phi_1595_ = _e1018;
                                }
                                let _e1035 = phi_1595_;
                                if (_e1007 > _e1019) {
                                    phi_1600_ = _e1007;
                                } else {
                                    phi_1600_ = _e1019;
                                }
                                let _e1038 = phi_1600_;
                                if (_e1008 > _e1020) {
                                    phi_1605_ = _e1008;
                                } else {
                                    phi_1605_ = _e1020;
                                }
                                let _e1041 = phi_1605_;
                                let _e1045 = core_intrinsics_maximum_number_nsz_f32_((_e1023 - _e383), (_e1026 - _e384));
                                let _e1046 = core_intrinsics_maximum_number_nsz_f32_(_e1045, (_e1029 - _e385));
                                let _e1047 = core_intrinsics_minimum_number_nsz_f32_((_e1035 + _e383), (_e1038 + _e384));
                                let _e1048 = core_intrinsics_minimum_number_nsz_f32_(_e1047, (_e1041 + _e385));
                                if (_e1046 <= _e1048) {
                                    if (_e1046 <= _e979.t) {
                                        if (_e1048 >= _e170.tmin) {
                                            let _e1060 = instances.member[(0u + _e987)].world_to_object[0u];
                                            let _e1071 = ((((_e1060.x * _e170.origin.x) + (_e1060.y * _e170.origin.y)) + (_e1060.z * _e170.origin.z)) + (_e1060.w * 1f));
                                            let _e1073 = instances.member[(0u + _e987)].world_to_object[1u];
                                            let _e1084 = ((((_e1073.x * _e170.origin.x) + (_e1073.y * _e170.origin.y)) + (_e1073.z * _e170.origin.z)) + (_e1073.w * 1f));
                                            let _e1086 = instances.member[(0u + _e987)].world_to_object[2u];
                                            let _e1097 = ((((_e1086.x * _e170.origin.x) + (_e1086.y * _e170.origin.y)) + (_e1086.z * _e170.origin.z)) + (_e1086.w * 1f));
                                            let _e1104 = instances.member[(0u + _e987)].world_to_object[0u];
                                            let _e1115 = ((((_e1104.x * _e170.direction.x) + (_e1104.y * _e170.direction.y)) + (_e1104.z * _e170.direction.z)) + (_e1104.w * 0f));
                                            let _e1117 = instances.member[(0u + _e987)].world_to_object[1u];
                                            let _e1128 = ((((_e1117.x * _e170.direction.x) + (_e1117.y * _e170.direction.y)) + (_e1117.z * _e170.direction.z)) + (_e1117.w * 0f));
                                            let _e1130 = instances.member[(0u + _e987)].world_to_object[2u];
                                            let _e1141 = ((((_e1130.x * _e170.direction.x) + (_e1130.y * _e170.direction.y)) + (_e1130.z * _e170.direction.z)) + (_e1130.w * 0f));
                                            let _e1146 = instances.member[(0u + _e987)].root;
                                            let _e1148 = instances.member[(0u + _e987)].first_triangle;
                                            let _e1149 = abs(_e1115);
                                            let _e1150 = abs(_e1128);
                                            let _e1151 = abs(_e1141);
                                            if (abs(_e1071) < 1000000000000000f) {
                                                if (abs(_e1084) < 1000000000000000f) {
                                                    phi_1737_ = (abs(_e1097) < 1000000000000000f);
                                                    phi_1738_ = false;
                                                } else {
                                                    phi_1737_ = bool();
                                                    phi_1738_ = true;
                                                }
                                                let _e1159 = phi_1737_;
                                                let _e1161 = phi_1738_;
                                                phi_1739_ = _e1159;
                                                phi_1740_ = _e1161;
                                            } else {
                                                phi_1739_ = bool();
                                                phi_1740_ = true;
                                            }
                                            let _e1163 = phi_1739_;
                                            let _e1165 = phi_1740_;
                                            if _e1165 {
                                                phi_1744_ = false;
                                            } else {
                                                phi_1744_ = _e1163;
                                            }
                                            let _e1167 = phi_1744_;
                                            if _e1167 {
                                                if (_e1149 < 1000000000000000f) {
                                                    if (_e1150 < 1000000000000000f) {
                                                        phi_1757_ = (_e1151 < 1000000000000000f);
                                                        phi_1758_ = false;
                                                    } else {
                                                        phi_1757_ = bool();
                                                        phi_1758_ = true;
                                                    }
                                                    let _e1172 = phi_1757_;
                                                    let _e1174 = phi_1758_;
                                                    phi_1759_ = _e1172;
                                                    phi_1760_ = _e1174;
                                                } else {
                                                    phi_1759_ = bool();
                                                    phi_1760_ = true;
                                                }
                                                let _e1176 = phi_1759_;
                                                let _e1178 = phi_1760_;
                                                if _e1178 {
                                                    phi_1764_ = false;
                                                } else {
                                                    phi_1764_ = _e1176;
                                                }
                                                let _e1180 = phi_1764_;
                                                if _e1180 {
                                                    if (_e1149 > 0f) {
                                                        phi_1778_ = bool();
                                                        phi_1779_ = true;
                                                    } else {
                                                        let _e1182 = (_e1150 > 0f);
                                                        if _e1182 {
                                                            phi_1777_ = bool();
                                                        } else {
                                                            phi_1777_ = (_e1151 > 0f);
                                                        }
                                                        let _e1185 = phi_1777_;
                                                        phi_1778_ = _e1185;
                                                        phi_1779_ = _e1182;
                                                    }
                                                    let _e1187 = phi_1778_;
                                                    let _e1189 = phi_1779_;
                                                    if _e1189 {
                                                        phi_1783_ = true;
                                                    } else {
                                                        phi_1783_ = _e1187;
                                                    }
                                                    let _e1191 = phi_1783_;
                                                    phi_1784_ = _e1191;
                                                    phi_1785_ = false;
                                                } else {
                                                    phi_1784_ = bool();
                                                    phi_1785_ = true;
                                                }
                                                let _e1193 = phi_1784_;
                                                let _e1195 = phi_1785_;
                                                phi_1786_ = _e1193;
                                                phi_1787_ = _e1195;
                                            } else {
                                                phi_1786_ = bool();
                                                phi_1787_ = true;
                                            }
                                            let _e1197 = phi_1786_;
                                            let _e1199 = phi_1787_;
                                            if _e1199 {
                                                phi_1791_ = false;
                                            } else {
                                                phi_1791_ = _e1197;
                                            }
                                            let _e1201 = phi_1791_;
                                            if _e1201 {
                                                let _e1202 = (_e1146 >= _e80);
                                                if _e1202 {
                                                    phi_3399_ = lt_bvh_Hit();
                                                } else {
                                                    if (_e1146 < _e80) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1208 = nodes.member[(0u + _e1146)].frame[0u];
                                                    let _e1212 = nodes.member[(0u + _e1146)].frame[1u];
                                                    let _e1216 = nodes.member[(0u + _e1146)].frame[2u];
                                                    let _e1220 = nodes.member[(0u + _e1146)].frame[0u];
                                                    let _e1224 = nodes.member[(0u + _e1146)].frame[1u];
                                                    let _e1228 = nodes.member[(0u + _e1146)].frame[2u];
                                                    let _e1232 = nodes.member[(0u + _e1146)].frame[3u];
                                                    let _e1266 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1115), abs(_e1128));
                                                    let _e1267 = core_intrinsics_maximum_number_nsz_f32_(_e1266, abs(_e1141));
                                                    let _e1268 = (_e1267 * 0.0000000000009094947f);
                                                    if (abs(_e1115) < _e1268) {
                                                        phi_1861_ = _e1268;
                                                    } else {
                                                        phi_1861_ = abs(_e1115);
                                                    }
                                                    let _e1273 = phi_1861_;
                                                    if (_e1115 < 0f) {
                                                        phi_1868_ = (-1f / _e1273);
                                                    } else {
                                                        phi_1868_ = (1f / _e1273);
                                                    }
                                                    let _e1278 = phi_1868_;
                                                    if (abs(_e1128) < _e1268) {
                                                        phi_1875_ = _e1268;
                                                    } else {
                                                        phi_1875_ = abs(_e1128);
                                                    }
                                                    let _e1283 = phi_1875_;
                                                    if (_e1128 < 0f) {
                                                        phi_1882_ = (-1f / _e1283);
                                                    } else {
                                                        phi_1882_ = (1f / _e1283);
                                                    }
                                                    let _e1288 = phi_1882_;
                                                    if (abs(_e1141) < _e1268) {
                                                        phi_1889_ = _e1268;
                                                    } else {
                                                        phi_1889_ = abs(_e1141);
                                                    }
                                                    let _e1293 = phi_1889_;
                                                    if (_e1141 < 0f) {
                                                        phi_1896_ = (-1f / _e1293);
                                                    } else {
                                                        phi_1896_ = (1f / _e1293);
                                                    }
                                                    let _e1298 = phi_1896_;
                                                    let _e1302 = abs((bitcast<f32>(_e1208) - _e1071));
                                                    let _e1303 = abs((bitcast<f32>(_e1212) - _e1084));
                                                    let _e1304 = abs((bitcast<f32>(_e1216) - _e1097));
                                                    let _e1308 = abs(((bitcast<f32>(_e1220) + (bitcast<f32>((((_e1232 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1071));
                                                    let _e1309 = abs(((bitcast<f32>(_e1224) + (bitcast<f32>((((_e1232 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1084));
                                                    let _e1310 = abs(((bitcast<f32>(_e1228) + (bitcast<f32>((((_e1232 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1097));
                                                    if (_e1302 > _e1308) {
                                                        phi_1913_ = _e1302;
                                                    } else {
                                                        phi_1913_ = _e1308;
                                                    }
                                                    let _e1313 = phi_1913_;
                                                    if (_e1303 > _e1309) {
                                                        phi_1918_ = _e1303;
                                                    } else {
                                                        phi_1918_ = _e1309;
                                                    }
                                                    let _e1316 = phi_1918_;
                                                    if (_e1304 > _e1310) {
                                                        phi_1923_ = _e1304;
                                                    } else {
                                                        phi_1923_ = _e1310;
                                                    }
                                                    let _e1319 = phi_1923_;
                                                    if (_e1313 > _e1316) {
                                                        phi_1928_ = _e1313;
                                                    } else {
                                                        phi_1928_ = _e1316;
                                                    }
                                                    let _e1322 = phi_1928_;
                                                    if (_e1322 > _e1319) {
                                                        phi_1933_ = _e1322;
                                                    } else {
                                                        phi_1933_ = _e1319;
                                                    }
                                                    let _e1325 = phi_1933_;
                                                    let _e1329 = (_e1325 * 0.0000019073486f);
                                                    let _e1330 = (abs(_e1278) * _e1329);
                                                    let _e1331 = (abs(_e1288) * _e1329);
                                                    let _e1332 = (abs(_e1298) * _e1329);
                                                    let _e1336 = (_e1325 * 0.0000009536743f);
                                                    let _e1337 = (abs(_e1278) * _e1336);
                                                    let _e1338 = (abs(_e1288) * _e1336);
                                                    let _e1339 = (abs(_e1298) * _e1336);
                                                    let _e1340 = abs(_e1115);
                                                    let _e1341 = abs(_e1128);
                                                    let _e1342 = abs(_e1141);
                                                    if (_e1340 >= _e1341) {
                                                        if (_e1340 >= _e1342) {
                                                            phi_1959_ = false;
                                                        } else {
                                                            phi_1959_ = true;
                                                        }
                                                        let _e1346 = phi_1959_;
                                                        phi_1960_ = _e1346;
                                                    } else {
                                                        phi_1960_ = true;
                                                    }
                                                    let _e1348 = phi_1960_;
                                                    if _e1348 {
                                                        if (_e1341 >= _e1342) {
                                                            phi_1968_ = 1u;
                                                        } else {
                                                            phi_1968_ = 2u;
                                                        }
                                                        let _e1351 = phi_1968_;
                                                        phi_1969_ = _e1351;
                                                    } else {
                                                        phi_1969_ = 0u;
                                                    }
                                                    let _e1353 = phi_1969_;
                                                    if (_e1353 == 0u) {
                                                        phi_1981_ = vec3<f32>(_e1128, _e1141, _e1115);
                                                    } else {
                                                        if (_e1353 == 1u) {
                                                            phi_1980_ = vec3<f32>(_e1141, _e1115, _e1128);
                                                        } else {
                                                            phi_1980_ = vec3<f32>(_e1115, _e1128, _e1141);
                                                        }
                                                        let _e1359 = phi_1980_;
                                                        phi_1981_ = _e1359;
                                                    }
                                                    let _e1361 = phi_1981_;
                                                    let _e1364 = (_e1361.x / _e1361.z);
                                                    let _e1367 = (_e1361.y / _e1361.z);
                                                    if (_e1278 < 0f) {
                                                        phi_1994_ = 0u;
                                                    } else {
                                                        phi_1994_ = 1u;
                                                    }
                                                    let _e1372 = phi_1994_;
                                                    if (_e1288 < 0f) {
                                                        phi_1999_ = 0u;
                                                    } else {
                                                        phi_1999_ = 2u;
                                                    }
                                                    let _e1375 = phi_1999_;
                                                    if (_e1298 < 0f) {
                                                        phi_2004_ = 0u;
                                                    } else {
                                                        phi_2004_ = 4u;
                                                    }
                                                    let _e1378 = phi_2004_;
                                                    let _e1380 = ((_e1372 | _e1375) | _e1378);
                                                    let _e1381 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1146, 2147483648u);
                                                    local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e1381.first[0], _e1381.first[1], _e1381.first[2], _e1381.first[3], _e1381.first[4], _e1381.first[5], _e1381.first[6], _e1381.first[7], _e1381.first[8], _e1381.first[9], _e1381.first[10], _e1381.first[11], _e1381.first[12], _e1381.first[13], _e1381.first[14], _e1381.first[15], _e1381.first[16], _e1381.first[17], _e1381.first[18], _e1381.first[19], _e1381.first[20], _e1381.first[21], _e1381.first[22], _e1381.first[23], _e1381.first[24], _e1381.first[25], _e1381.first[26], _e1381.first[27], _e1381.first[28], _e1381.first[29], _e1381.first[30], _e1381.first[31]), array<u32, 32>(_e1381.mask[0], _e1381.mask[1], _e1381.mask[2], _e1381.mask[3], _e1381.mask[4], _e1381.mask[5], _e1381.mask[6], _e1381.mask[7], _e1381.mask[8], _e1381.mask[9], _e1381.mask[10], _e1381.mask[11], _e1381.mask[12], _e1381.mask[13], _e1381.mask[14], _e1381.mask[15], _e1381.mask[16], _e1381.mask[17], _e1381.mask[18], _e1381.mask[19], _e1381.mask[20], _e1381.mask[21], _e1381.mask[22], _e1381.mask[23], _e1381.mask[24], _e1381.mask[25], _e1381.mask[26], _e1381.mask[27], _e1381.mask[28], _e1381.mask[29], _e1381.mask[30], _e1381.mask[31]), _e1381.len, _e1381.group, _e1381.group_mask);
                                                    let _e1455 = local_2.group_mask;
                                                    if ((_e1455 & 4278190080u) == 0u) {
                                                        let _e1459 = local_2.len;
                                                        if (_e1459 == 0u) {
                                                            phi_2118_ = false;
                                                        } else {
                                                            let _e1463 = local_2.len;
                                                            local_2.len = (_e1463 - 1u);
                                                            let _e1466 = local_2.len;
                                                            if (_e1466 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1471 = local_2.first[(0u + _e1466)];
                                                            local_2.group = _e1471;
                                                            let _e1474 = local_2.len;
                                                            if (_e1474 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1479 = local_2.mask[(0u + _e1474)];
                                                            local_2.group_mask = _e1479;
                                                            phi_2118_ = true;
                                                        }
                                                        let _e1482 = phi_2118_;
                                                        phi_2119_ = _e1482;
                                                    } else {
                                                        phi_2119_ = true;
                                                    }
                                                    let _e1484 = phi_2119_;
                                                    if _e1484 {
                                                        let _e1486 = local_2.group_mask;
                                                        let _e1492 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1486)), 32u, (_e1486 == 0u)));
                                                        let _e1496 = local_2.group_mask;
                                                        let _e1510 = local_2.group_mask;
                                                        local_2.group_mask = (_e1510 & ~((1u << bitcast<u32>((_e1492 & 31u)))));
                                                        let _e1513 = local_2.group;
                                                        phi_2150_ = (_e1513 + countOneBits(((_e1496 & ~((4294967295u << bitcast<u32>((((_e1492 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_2150_ = 4294967295u;
                                                    }
                                                    let _e1516 = phi_2150_;
                                                    phi_2152_ = _e979;
                                                    phi_2155_ = _e1516;
                                                    loop {
                                                        let _e1518 = phi_2152_;
                                                        let _e1520 = phi_2155_;
                                                        local_11 = _e1518;
                                                        let _e1521 = (_e1520 != 4294967295u);
                                                        if _e1521 {
                                                            if (_e1520 < _e80) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1528 = nodes.member[(0u + _e1520)].frame[3u];
                                                            let _e1553 = (bitcast<f32>((((_e1528 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1278);
                                                            let _e1554 = (bitcast<f32>((((_e1528 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1288);
                                                            let _e1555 = (bitcast<f32>((((_e1528 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1298);
                                                            let _e1558 = nodes.member[(0u + _e1520)].frame[0u];
                                                            let _e1562 = nodes.member[(0u + _e1520)].frame[1u];
                                                            let _e1566 = nodes.member[(0u + _e1520)].frame[2u];
                                                            let _e1571 = ((bitcast<f32>(_e1558) - _e1071) * _e1278);
                                                            let _e1572 = ((bitcast<f32>(_e1562) - _e1084) * _e1288);
                                                            let _e1573 = ((bitcast<f32>(_e1566) - _e1097) * _e1298);
                                                            let _e1581 = nodes.member[(0u + _e1520)].x;
                                                            if (_e1278 < 0f) {
                                                                let _e1592 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1581.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1598 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1592.unnamed.word, _e1581.w), _e1592.unnamed_1);
                                                                let _e1604 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1598.unnamed, lt_mask_LightPlace(_e1581.x, _e1598.unnamed_1.shift));
                                                                phi_2236_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1604.unnamed, lt_mask_LightPlace(_e1604.unnamed_1.word, _e1581.y));
                                                            } else {
                                                                let _e1620 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1581.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1626 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1620.unnamed.word, _e1581.y), _e1620.unnamed_1);
                                                                let _e1632 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1626.unnamed, lt_mask_LightPlace(_e1581.z, _e1626.unnamed_1.shift));
                                                                phi_2236_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1632.unnamed, lt_mask_LightPlace(_e1632.unnamed_1.word, _e1581.w));
                                                            }
                                                            let _e1640 = phi_2236_;
                                                            let _e1650 = nodes.member[(0u + _e1520)].y;
                                                            if (_e1288 < 0f) {
                                                                let _e1661 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1650.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1667 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1661.unnamed.word, _e1650.w), _e1661.unnamed_1);
                                                                let _e1673 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1667.unnamed, lt_mask_LightPlace(_e1650.x, _e1667.unnamed_1.shift));
                                                                phi_2263_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1673.unnamed, lt_mask_LightPlace(_e1673.unnamed_1.word, _e1650.y));
                                                            } else {
                                                                let _e1689 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1650.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1695 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1689.unnamed.word, _e1650.y), _e1689.unnamed_1);
                                                                let _e1701 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1695.unnamed, lt_mask_LightPlace(_e1650.z, _e1695.unnamed_1.shift));
                                                                phi_2263_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1701.unnamed, lt_mask_LightPlace(_e1701.unnamed_1.word, _e1650.w));
                                                            }
                                                            let _e1709 = phi_2263_;
                                                            let _e1719 = nodes.member[(0u + _e1520)].z;
                                                            if (_e1298 < 0f) {
                                                                let _e1730 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1719.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1736 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1730.unnamed.word, _e1719.w), _e1730.unnamed_1);
                                                                let _e1742 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1736.unnamed, lt_mask_LightPlace(_e1719.x, _e1736.unnamed_1.shift));
                                                                phi_2290_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1742.unnamed, lt_mask_LightPlace(_e1742.unnamed_1.word, _e1719.y));
                                                            } else {
                                                                let _e1758 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1719.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1764 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1758.unnamed.word, _e1719.y), _e1758.unnamed_1);
                                                                let _e1770 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1764.unnamed, lt_mask_LightPlace(_e1719.z, _e1764.unnamed_1.shift));
                                                                phi_2290_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1770.unnamed, lt_mask_LightPlace(_e1770.unnamed_1.word, _e1719.w));
                                                            }
                                                            let _e1778 = phi_2290_;
                                                            phi_2296_ = 0u;
                                                            phi_2299_ = 0u;
                                                            loop {
                                                                let _e1788 = phi_2296_;
                                                                let _e1790 = phi_2299_;
                                                                local_7 = _e1790;
                                                                local_8 = _e1790;
                                                                local_9 = _e1790;
                                                                let _e1791 = (_e1788 < 8u);
                                                                if _e1791 {
                                                                    let _e1793 = (_e1788 >> bitcast<u32>(2i));
                                                                    let _e1794 = (_e1788 & 3u);
                                                                    if (_e1793 == 0u) {
                                                                        phi_2313_ = _e1640.unnamed.word;
                                                                    } else {
                                                                        phi_2313_ = _e1640.unnamed.shift;
                                                                    }
                                                                    let _e1797 = phi_2313_;
                                                                    if (_e1793 == 0u) {
                                                                        phi_2323_ = _e1709.unnamed.word;
                                                                    } else {
                                                                        phi_2323_ = _e1709.unnamed.shift;
                                                                    }
                                                                    let _e1806 = phi_2323_;
                                                                    if (_e1793 == 0u) {
                                                                        phi_2333_ = _e1778.unnamed.word;
                                                                    } else {
                                                                        phi_2333_ = _e1778.unnamed.shift;
                                                                    }
                                                                    let _e1815 = phi_2333_;
                                                                    let _e1828 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1797 >> bitcast<u32>(((_e1794 * 8u) & 31u))) & 255u)) * _e1553) + (_e1571 - _e1330)), ((f32(((_e1806 >> bitcast<u32>(((_e1794 * 8u) & 31u))) & 255u)) * _e1554) + (_e1572 - _e1331)));
                                                                    let _e1829 = core_intrinsics_maximum_number_nsz_f32_(_e1828, ((f32(((_e1815 >> bitcast<u32>(((_e1794 * 8u) & 31u))) & 255u)) * _e1555) + (_e1573 - _e1332)));
                                                                    if (_e1793 == 0u) {
                                                                        phi_2351_ = _e1640.unnamed_1.word;
                                                                    } else {
                                                                        phi_2351_ = _e1640.unnamed_1.shift;
                                                                    }
                                                                    let _e1832 = phi_2351_;
                                                                    if (_e1793 == 0u) {
                                                                        phi_2361_ = _e1709.unnamed_1.word;
                                                                    } else {
                                                                        phi_2361_ = _e1709.unnamed_1.shift;
                                                                    }
                                                                    let _e1841 = phi_2361_;
                                                                    if (_e1793 == 0u) {
                                                                        phi_2371_ = _e1778.unnamed_1.word;
                                                                    } else {
                                                                        phi_2371_ = _e1778.unnamed_1.shift;
                                                                    }
                                                                    let _e1850 = phi_2371_;
                                                                    let _e1863 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1832 >> bitcast<u32>(((_e1794 * 8u) & 31u))) & 255u)) * _e1553) + (_e1571 + _e1330)), ((f32(((_e1841 >> bitcast<u32>(((_e1794 * 8u) & 31u))) & 255u)) * _e1554) + (_e1572 + _e1331)));
                                                                    let _e1864 = core_intrinsics_minimum_number_nsz_f32_(_e1863, ((f32(((_e1850 >> bitcast<u32>(((_e1794 * 8u) & 31u))) & 255u)) * _e1555) + (_e1573 + _e1332)));
                                                                    if (_e1829 <= _e1864) {
                                                                        if (_e1829 <= _e1518.t) {
                                                                            if (_e1864 >= _e170.tmin) {
                                                                                if (_e1793 == 0u) {
                                                                                    let _e1871 = nodes.member[(0u + _e1520)].links[2u];
                                                                                    phi_2407_ = _e1871;
                                                                                } else {
                                                                                    let _e1874 = nodes.member[(0u + _e1520)].links[3u];
                                                                                    phi_2407_ = _e1874;
                                                                                }
                                                                                let _e1876 = phi_2407_;
                                                                                let _e1881 = ((_e1876 >> bitcast<u32>(((_e1794 * 8u) & 31u))) & 255u);
                                                                                let _e1882 = (_e1881 & 31u);
                                                                                if (_e1882 >= 24u) {
                                                                                    phi_2420_ = (24u + ((_e1882 - 24u) ^ _e1380));
                                                                                } else {
                                                                                    phi_2420_ = _e1882;
                                                                                }
                                                                                let _e1888 = phi_2420_;
                                                                                phi_2425_ = (_e1790 | ((_e1881 >> bitcast<u32>(5i)) << bitcast<u32>((_e1888 & 31u))));
                                                                            } else {
                                                                                phi_2425_ = _e1790;
                                                                            }
                                                                            let _e1896 = phi_2425_;
                                                                            phi_2426_ = _e1896;
                                                                        } else {
                                                                            phi_2426_ = _e1790;
                                                                        }
                                                                        let _e1898 = phi_2426_;
                                                                        phi_2427_ = _e1898;
                                                                    } else {
                                                                        phi_2427_ = _e1790;
                                                                    }
                                                                    let _e1900 = phi_2427_;
                                                                    phi_2297_ = (_e1788 + 1u);
                                                                    phi_2300_ = _e1900;
                                                                } else {
                                                                    phi_2297_ = u32();
                                                                    phi_2300_ = u32();
                                                                }
                                                                let _e1903 = phi_2297_;
                                                                let _e1905 = phi_2300_;
                                                                continue;
                                                                continuing {
                                                                    phi_2296_ = _e1903;
                                                                    phi_2299_ = _e1905;
                                                                    break if !(_e1791);
                                                                }
                                                            }
                                                            let _e1909 = nodes.member[(0u + _e1520)].links[0u];
                                                            let _e1913 = nodes.member[(0u + _e1520)].frame[3u];
                                                            let _e1917 = local_7;
                                                            if ((_e1917 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1921 = local_2.group_mask;
                                                                if ((_e1921 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1925 = local_2.len;
                                                                    if (_e1925 < 32u) {
                                                                        let _e1928 = local_2.group;
                                                                        let _e1930 = local_2.len;
                                                                        if (_e1930 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_2.first[(0u + _e1930)] = _e1928;
                                                                        let _e1936 = local_2.group_mask;
                                                                        let _e1938 = local_2.len;
                                                                        if (_e1938 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_2.mask[(0u + _e1938)] = _e1936;
                                                                        let _e1945 = local_2.len;
                                                                        local_2.len = (_e1945 + 1u);
                                                                    }
                                                                }
                                                                local_2.group = (_e1146 + _e1909);
                                                                let _e1949 = local_8;
                                                                local_2.group_mask = ((_e1949 & 4278190080u) | (_e1913 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1954 = local_9;
                                                            phi_2485_ = _e1518;
                                                            phi_2488_ = (_e1954 & 16777215u);
                                                            loop {
                                                                let _e1957 = phi_2485_;
                                                                let _e1959 = phi_2488_;
                                                                local_10 = _e1957;
                                                                if (_e1959 == 0u) {
                                                                    phi_2486_ = lt_bvh_Hit();
                                                                    phi_2489_ = u32();
                                                                    phi_3327_ = false;
                                                                } else {
                                                                    let _e1963 = nodes.member[(0u + _e1520)].links[1u];
                                                                    let _e1968 = ((_e1148 + _e1963) + select(firstTrailingBit(_e1959), 32u, (_e1959 == 0u)));
                                                                    if (_e1968 < _e83) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1975 = triangles.member[(0u + _e1968)].v0_;
                                                                    let _e1977 = (_e1975.x - _e1071);
                                                                    let _e1979 = (_e1975.y - _e1084);
                                                                    let _e1981 = (_e1975.z - _e1097);
                                                                    if (_e1353 == 0u) {
                                                                        phi_2533_ = vec3<f32>(_e1979, _e1981, _e1977);
                                                                    } else {
                                                                        if (_e1353 == 1u) {
                                                                            phi_2532_ = vec3<f32>(_e1981, _e1977, _e1979);
                                                                        } else {
                                                                            phi_2532_ = (_e1975 - vec3<f32>(_e1071, _e1084, _e1097));
                                                                        }
                                                                        let _e1989 = phi_2532_;
                                                                        phi_2533_ = _e1989;
                                                                    }
                                                                    let _e1991 = phi_2533_;
                                                                    let _e1995 = (_e1991.x - (_e1364 * _e1991.z));
                                                                    let _e1999 = (_e1991.y - (_e1367 * _e1991.z));
                                                                    let _e2001 = triangles.member[(0u + _e1968)].v1_;
                                                                    let _e2003 = (_e2001.x - _e1071);
                                                                    let _e2005 = (_e2001.y - _e1084);
                                                                    let _e2007 = (_e2001.z - _e1097);
                                                                    if (_e1353 == 0u) {
                                                                        phi_2563_ = vec3<f32>(_e2005, _e2007, _e2003);
                                                                    } else {
                                                                        if (_e1353 == 1u) {
                                                                            phi_2562_ = vec3<f32>(_e2007, _e2003, _e2005);
                                                                        } else {
                                                                            phi_2562_ = (_e2001 - vec3<f32>(_e1071, _e1084, _e1097));
                                                                        }
                                                                        let _e2015 = phi_2562_;
                                                                        phi_2563_ = _e2015;
                                                                    }
                                                                    let _e2017 = phi_2563_;
                                                                    let _e2021 = (_e2017.x - (_e1364 * _e2017.z));
                                                                    let _e2025 = (_e2017.y - (_e1367 * _e2017.z));
                                                                    let _e2027 = triangles.member[(0u + _e1968)].v2_;
                                                                    let _e2029 = (_e2027.x - _e1071);
                                                                    let _e2031 = (_e2027.y - _e1084);
                                                                    let _e2033 = (_e2027.z - _e1097);
                                                                    if (_e1353 == 0u) {
                                                                        phi_2593_ = vec3<f32>(_e2031, _e2033, _e2029);
                                                                    } else {
                                                                        if (_e1353 == 1u) {
                                                                            phi_2592_ = vec3<f32>(_e2033, _e2029, _e2031);
                                                                        } else {
                                                                            phi_2592_ = (_e2027 - vec3<f32>(_e1071, _e1084, _e1097));
                                                                        }
                                                                        let _e2041 = phi_2592_;
                                                                        phi_2593_ = _e2041;
                                                                    }
                                                                    let _e2043 = phi_2593_;
                                                                    let _e2047 = (_e2043.x - (_e1364 * _e2043.z));
                                                                    let _e2051 = (_e2043.y - (_e1367 * _e2043.z));
                                                                    if (_e2021 < _e2047) {
                                                                        phi_2612_ = true;
                                                                    } else {
                                                                        if (_e2021 == _e2047) {
                                                                            phi_2611_ = (_e2025 < _e2051);
                                                                        } else {
                                                                            phi_2611_ = false;
                                                                        }
                                                                        let _e2056 = phi_2611_;
                                                                        phi_2612_ = _e2056;
                                                                    }
                                                                    let _e2058 = phi_2612_;
                                                                    if _e2058 {
                                                                        phi_2616_ = _e2051;
                                                                        phi_2617_ = _e2047;
                                                                        phi_2618_ = _e2025;
                                                                        phi_2619_ = _e2021;
                                                                    } else {
                                                                        phi_2616_ = _e2025;
                                                                        phi_2617_ = _e2021;
                                                                        phi_2618_ = _e2051;
                                                                        phi_2619_ = _e2047;
                                                                    }
                                                                    let _e2060 = phi_2616_;
                                                                    let _e2062 = phi_2617_;
                                                                    let _e2064 = phi_2618_;
                                                                    let _e2066 = phi_2619_;
                                                                    let _e2069 = ((_e2066 * _e2060) - (_e2064 * _e2062));
                                                                    if _e2058 {
                                                                        phi_2627_ = -(_e2069);
                                                                    } else {
                                                                        phi_2627_ = _e2069;
                                                                    }
                                                                    let _e2072 = phi_2627_;
                                                                    if (_e2047 < _e1995) {
                                                                        phi_2638_ = true;
                                                                    } else {
                                                                        if (_e2047 == _e1995) {
                                                                            phi_2637_ = (_e2051 < _e1999);
                                                                        } else {
                                                                            phi_2637_ = false;
                                                                        }
                                                                        let _e2077 = phi_2637_;
                                                                        phi_2638_ = _e2077;
                                                                    }
                                                                    let _e2079 = phi_2638_;
                                                                    if _e2079 {
                                                                        phi_2642_ = _e1999;
                                                                        phi_2643_ = _e1995;
                                                                        phi_2644_ = _e2051;
                                                                        phi_2645_ = _e2047;
                                                                    } else {
                                                                        phi_2642_ = _e2051;
                                                                        phi_2643_ = _e2047;
                                                                        phi_2644_ = _e1999;
                                                                        phi_2645_ = _e1995;
                                                                    }
                                                                    let _e2081 = phi_2642_;
                                                                    let _e2083 = phi_2643_;
                                                                    let _e2085 = phi_2644_;
                                                                    let _e2087 = phi_2645_;
                                                                    let _e2090 = ((_e2087 * _e2081) - (_e2085 * _e2083));
                                                                    if _e2079 {
                                                                        phi_2653_ = -(_e2090);
                                                                    } else {
                                                                        phi_2653_ = _e2090;
                                                                    }
                                                                    let _e2093 = phi_2653_;
                                                                    if (_e1995 < _e2021) {
                                                                        phi_2664_ = true;
                                                                    } else {
                                                                        if (_e1995 == _e2021) {
                                                                            phi_2663_ = (_e1999 < _e2025);
                                                                        } else {
                                                                            phi_2663_ = false;
                                                                        }
                                                                        let _e2098 = phi_2663_;
                                                                        phi_2664_ = _e2098;
                                                                    }
                                                                    let _e2100 = phi_2664_;
                                                                    if _e2100 {
                                                                        phi_2668_ = _e2025;
                                                                        phi_2669_ = _e2021;
                                                                        phi_2670_ = _e1999;
                                                                        phi_2671_ = _e1995;
                                                                    } else {
                                                                        phi_2668_ = _e1999;
                                                                        phi_2669_ = _e1995;
                                                                        phi_2670_ = _e2025;
                                                                        phi_2671_ = _e2021;
                                                                    }
                                                                    let _e2102 = phi_2668_;
                                                                    let _e2104 = phi_2669_;
                                                                    let _e2106 = phi_2670_;
                                                                    let _e2108 = phi_2671_;
                                                                    let _e2111 = ((_e2108 * _e2102) - (_e2106 * _e2104));
                                                                    if _e2100 {
                                                                        phi_2679_ = -(_e2111);
                                                                    } else {
                                                                        phi_2679_ = _e2111;
                                                                    }
                                                                    let _e2114 = phi_2679_;
                                                                    if (_e2072 >= 0f) {
                                                                        if (_e2093 >= 0f) {
                                                                            if (_e2114 >= 0f) {
                                                                                phi_2694_ = ((_e2072 + _e2093) + _e2114);
                                                                                phi_2695_ = false;
                                                                            } else {
                                                                                phi_2694_ = f32();
                                                                                phi_2695_ = true;
                                                                            }
                                                                            let _e2121 = phi_2694_;
                                                                            let _e2123 = phi_2695_;
                                                                            phi_2696_ = _e2121;
                                                                            phi_2697_ = _e2123;
                                                                        } else {
                                                                            phi_2696_ = f32();
                                                                            phi_2697_ = true;
                                                                        }
                                                                        let _e2125 = phi_2696_;
                                                                        let _e2127 = phi_2697_;
                                                                        phi_2698_ = _e2125;
                                                                        phi_2699_ = _e2127;
                                                                    } else {
                                                                        phi_2698_ = f32();
                                                                        phi_2699_ = true;
                                                                    }
                                                                    let _e2129 = phi_2698_;
                                                                    let _e2131 = phi_2699_;
                                                                    if _e2131 {
                                                                        if (_e2072 <= 0f) {
                                                                            if (_e2093 <= 0f) {
                                                                                let _e2134 = (_e2114 <= 0f);
                                                                                if _e2134 {
                                                                                }
                                                                                phi_2717_ = ((_e2072 + _e2093) + _e2114);
                                                                                phi_2718_ = false;
                                                                                phi_2719_ = _e2134;
                                                                            } else {
                                                                                phi_2717_ = f32();
                                                                                phi_2718_ = true;
                                                                                phi_2719_ = false;
                                                                            }
                                                                            let _e2138 = phi_2717_;
                                                                            let _e2140 = phi_2718_;
                                                                            let _e2142 = phi_2719_;
                                                                            phi_2720_ = _e2138;
                                                                            phi_2721_ = _e2140;
                                                                            phi_2722_ = _e2142;
                                                                        } else {
                                                                            phi_2720_ = f32();
                                                                            phi_2721_ = true;
                                                                            phi_2722_ = false;
                                                                        }
                                                                        let _e2144 = phi_2720_;
                                                                        let _e2146 = phi_2721_;
                                                                        let _e2148 = phi_2722_;
                                                                        if _e2146 {
                                                                            phi_2726_ = false;
                                                                        } else {
                                                                            phi_2726_ = _e2148;
                                                                        }
                                                                        let _e2150 = phi_2726_;
                                                                        phi_2727_ = _e2144;
                                                                        phi_2728_ = _e2150;
                                                                    } else {
                                                                        phi_2727_ = _e2129;
                                                                        phi_2728_ = true;
                                                                    }
                                                                    let _e2152 = phi_2727_;
                                                                    let _e2154 = phi_2728_;
                                                                    if _e2154 {
                                                                        let _e2155 = (_e2152 == 0f);
                                                                        if _e2155 {
                                                                            phi_3044_ = lt_bvh_triangle_Intersection();
                                                                            phi_3045_ = false;
                                                                        } else {
                                                                            let _e2157 = triangles.member[(0u + _e1968)].v0_;
                                                                            let _e2159 = (_e2157.x - _e1071);
                                                                            let _e2161 = (_e2157.y - _e1084);
                                                                            let _e2163 = (_e2157.z - _e1097);
                                                                            if (_e1353 == 0u) {
                                                                                phi_2757_ = vec3<f32>(_e2161, _e2163, _e2159);
                                                                            } else {
                                                                                if (_e1353 == 1u) {
                                                                                    phi_2756_ = vec3<f32>(_e2163, _e2159, _e2161);
                                                                                } else {
                                                                                    phi_2756_ = (_e2157 - vec3<f32>(_e1071, _e1084, _e1097));
                                                                                }
                                                                                let _e2171 = phi_2756_;
                                                                                phi_2757_ = _e2171;
                                                                            }
                                                                            let _e2173 = phi_2757_;
                                                                            let _e2175 = triangles.member[(0u + _e1968)].v1_;
                                                                            let _e2177 = triangles.member[(0u + _e1968)].v0_;
                                                                            let _e2180 = (_e2175.x - _e2177.x);
                                                                            let _e2183 = (_e2175.y - _e2177.y);
                                                                            let _e2186 = (_e2175.z - _e2177.z);
                                                                            if (_e1353 == 0u) {
                                                                                phi_2783_ = vec3<f32>(_e2183, _e2186, _e2180);
                                                                            } else {
                                                                                if (_e1353 == 1u) {
                                                                                    phi_2782_ = vec3<f32>(_e2186, _e2180, _e2183);
                                                                                } else {
                                                                                    phi_2782_ = (_e2175 - _e2177);
                                                                                }
                                                                                let _e2193 = phi_2782_;
                                                                                phi_2783_ = _e2193;
                                                                            }
                                                                            let _e2195 = phi_2783_;
                                                                            let _e2197 = triangles.member[(0u + _e1968)].v2_;
                                                                            let _e2199 = triangles.member[(0u + _e1968)].v0_;
                                                                            let _e2202 = (_e2197.x - _e2199.x);
                                                                            let _e2205 = (_e2197.y - _e2199.y);
                                                                            let _e2208 = (_e2197.z - _e2199.z);
                                                                            if (_e1353 == 0u) {
                                                                                phi_2809_ = vec3<f32>(_e2205, _e2208, _e2202);
                                                                            } else {
                                                                                if (_e1353 == 1u) {
                                                                                    phi_2808_ = vec3<f32>(_e2208, _e2202, _e2205);
                                                                                } else {
                                                                                    phi_2808_ = (_e2197 - _e2199);
                                                                                }
                                                                                let _e2215 = phi_2808_;
                                                                                phi_2809_ = _e2215;
                                                                            }
                                                                            let _e2217 = phi_2809_;
                                                                            let _e2224 = ((_e2195.y * _e2217.z) - (_e2195.z * _e2217.y));
                                                                            let _e2231 = ((_e2195.z * _e2217.x) - (_e2195.x * _e2217.z));
                                                                            let _e2238 = ((_e2195.x * _e2217.y) - (_e2195.y * _e2217.x));
                                                                            let _e2252 = (((1f / _e1361.z) * (((_e2224 * _e2173.x) + (_e2231 * _e2173.y)) + (_e2238 * _e2173.z))) / (((_e2224 * _e1364) + (_e2231 * _e1367)) + _e2238));
                                                                            if (_e2252 > _e170.tmin) {
                                                                                if (_e2252 < _e170.tmax) {
                                                                                    let _e2256 = triangles.member[(0u + _e1968)].v0_;
                                                                                    let _e2258 = triangles.member[(0u + _e1968)].v1_;
                                                                                    if (_e2256.x < _e2258.x) {
                                                                                        phi_2865_ = _e2256.x;
                                                                                    } else {
                                                                                        phi_2865_ = _e2258.x;
                                                                                    }
                                                                                    let _e2265 = phi_2865_;
                                                                                    if (_e2256.y < _e2258.y) {
                                                                                        phi_2874_ = _e2256.y;
                                                                                    } else {
                                                                                        phi_2874_ = _e2258.y;
                                                                                    }
                                                                                    let _e2272 = phi_2874_;
                                                                                    if (_e2256.z < _e2258.z) {
                                                                                        phi_2883_ = _e2256.z;
                                                                                    } else {
                                                                                        phi_2883_ = _e2258.z;
                                                                                    }
                                                                                    let _e2279 = phi_2883_;
                                                                                    let _e2281 = triangles.member[(0u + _e1968)].v2_;
                                                                                    if (_e2265 < _e2281.x) {
                                                                                        phi_2892_ = _e2265;
                                                                                    } else {
                                                                                        phi_2892_ = _e2281.x;
                                                                                    }
                                                                                    let _e2286 = phi_2892_;
                                                                                    if (_e2272 < _e2281.y) {
                                                                                        phi_2899_ = _e2272;
                                                                                    } else {
                                                                                        phi_2899_ = _e2281.y;
                                                                                    }
                                                                                    let _e2291 = phi_2899_;
                                                                                    if (_e2279 < _e2281.z) {
                                                                                        phi_2906_ = _e2279;
                                                                                    } else {
                                                                                        phi_2906_ = _e2281.z;
                                                                                    }
                                                                                    let _e2296 = phi_2906_;
                                                                                    let _e2298 = triangles.member[(0u + _e1968)].v0_;
                                                                                    let _e2300 = triangles.member[(0u + _e1968)].v1_;
                                                                                    if (_e2298.x > _e2300.x) {
                                                                                        phi_2919_ = _e2298.x;
                                                                                    } else {
                                                                                        phi_2919_ = _e2300.x;
                                                                                    }
                                                                                    let _e2307 = phi_2919_;
                                                                                    if (_e2298.y > _e2300.y) {
                                                                                        phi_2928_ = _e2298.y;
                                                                                    } else {
                                                                                        phi_2928_ = _e2300.y;
                                                                                    }
                                                                                    let _e2314 = phi_2928_;
                                                                                    if (_e2298.z > _e2300.z) {
                                                                                        phi_2937_ = _e2298.z;
                                                                                    } else {
                                                                                        phi_2937_ = _e2300.z;
                                                                                    }
                                                                                    let _e2321 = phi_2937_;
                                                                                    let _e2323 = triangles.member[(0u + _e1968)].v2_;
                                                                                    if (_e2307 > _e2323.x) {
                                                                                        phi_2946_ = _e2307;
                                                                                    } else {
                                                                                        phi_2946_ = _e2323.x;
                                                                                    }
                                                                                    let _e2328 = phi_2946_;
                                                                                    if (_e2314 > _e2323.y) {
                                                                                        phi_2953_ = _e2314;
                                                                                    } else {
                                                                                        phi_2953_ = _e2323.y;
                                                                                    }
                                                                                    let _e2333 = phi_2953_;
                                                                                    if (_e2321 > _e2323.z) {
                                                                                        phi_2960_ = _e2321;
                                                                                    } else {
                                                                                        phi_2960_ = _e2323.z;
                                                                                    }
                                                                                    let _e2338 = phi_2960_;
                                                                                    let _e2342 = ((_e2286 - _e1071) * _e1278);
                                                                                    let _e2343 = ((_e2291 - _e1084) * _e1288);
                                                                                    let _e2344 = ((_e2296 - _e1097) * _e1298);
                                                                                    let _e2348 = ((_e2328 - _e1071) * _e1278);
                                                                                    let _e2349 = ((_e2333 - _e1084) * _e1288);
                                                                                    let _e2350 = ((_e2338 - _e1097) * _e1298);
                                                                                    if (_e2342 < _e2348) {
                                                                                        phi_2977_ = _e2342;
                                                                                    } else {
                                                                                        phi_2977_ = _e2348;
                                                                                    }
                                                                                    let _e2353 = phi_2977_;
                                                                                    if (_e2343 < _e2349) {
                                                                                        phi_2982_ = _e2343;
                                                                                    } else {
                                                                                        phi_2982_ = _e2349;
                                                                                    }
                                                                                    let _e2356 = phi_2982_;
                                                                                    if (_e2344 < _e2350) {
                                                                                        phi_2987_ = _e2344;
                                                                                    } else {
                                                                                        phi_2987_ = _e2350;
                                                                                    }
                                                                                    let _e2359 = phi_2987_;
                                                                                    if (_e2342 > _e2348) {
                                                                                        phi_2995_ = _e2342;
                                                                                    } else {
                                                                                        phi_2995_ = _e2348;
                                                                                    }
                                                                                    let _e2365 = phi_2995_;
                                                                                    if (_e2343 > _e2349) {
                                                                                        phi_3000_ = _e2343;
                                                                                    } else {
                                                                                        phi_3000_ = _e2349;
                                                                                    }
                                                                                    let _e2368 = phi_3000_;
                                                                                    if (_e2344 > _e2350) {
                                                                                        phi_3005_ = _e2344;
                                                                                    } else {
                                                                                        phi_3005_ = _e2350;
                                                                                    }
                                                                                    let _e2371 = phi_3005_;
                                                                                    let _e2375 = core_intrinsics_maximum_number_nsz_f32_((_e2353 - _e1337), (_e2356 - _e1338));
                                                                                    let _e2376 = core_intrinsics_maximum_number_nsz_f32_(_e2375, (_e2359 - _e1339));
                                                                                    let _e2377 = core_intrinsics_minimum_number_nsz_f32_((_e2365 + _e1337), (_e2368 + _e1338));
                                                                                    let _e2378 = core_intrinsics_minimum_number_nsz_f32_(_e2377, (_e2371 + _e1339));
                                                                                    if (_e2376 > _e1046) {
                                                                                        phi_3017_ = _e2376;
                                                                                    } else {
                                                                                        phi_3017_ = _e1046;
                                                                                    }
                                                                                    let _e2381 = phi_3017_;
                                                                                    if (_e2378 < _e1048) {
                                                                                        phi_3022_ = _e2378;
                                                                                    } else {
                                                                                        phi_3022_ = _e1048;
                                                                                    }
                                                                                    let _e2384 = phi_3022_;
                                                                                    if (_e2252 < _e2381) {
                                                                                        phi_3027_ = _e2381;
                                                                                    } else {
                                                                                        phi_3027_ = _e2252;
                                                                                    }
                                                                                    let _e2387 = phi_3027_;
                                                                                    if (_e2387 > _e2384) {
                                                                                        phi_3032_ = _e2384;
                                                                                    } else {
                                                                                        phi_3032_ = _e2387;
                                                                                    }
                                                                                    let _e2390 = phi_3032_;
                                                                                    phi_3037_ = lt_bvh_triangle_Intersection(_e2390, (_e2093 / _e2152), (_e2114 / _e2152), (_e2381 <= _e2384));
                                                                                    phi_3038_ = false;
                                                                                } else {
                                                                                    phi_3037_ = lt_bvh_triangle_Intersection();
                                                                                    phi_3038_ = true;
                                                                                }
                                                                                let _e2396 = phi_3037_;
                                                                                let _e2398 = phi_3038_;
                                                                                phi_3039_ = _e2396;
                                                                                phi_3040_ = _e2398;
                                                                            } else {
                                                                                phi_3039_ = lt_bvh_triangle_Intersection();
                                                                                phi_3040_ = true;
                                                                            }
                                                                            let _e2400 = phi_3039_;
                                                                            let _e2402 = phi_3040_;
                                                                            if _e2402 {
                                                                            }
                                                                            phi_3044_ = _e2400;
                                                                            phi_3045_ = _e2402;
                                                                        }
                                                                        let _e2404 = phi_3044_;
                                                                        let _e2406 = phi_3045_;
                                                                        phi_3046_ = _e2404;
                                                                        phi_3047_ = _e2155;
                                                                        phi_3048_ = _e2406;
                                                                    } else {
                                                                        phi_3046_ = lt_bvh_triangle_Intersection();
                                                                        phi_3047_ = true;
                                                                        phi_3048_ = false;
                                                                    }
                                                                    let _e2408 = phi_3046_;
                                                                    let _e2410 = phi_3047_;
                                                                    let _e2412 = phi_3048_;
                                                                    if _e2410 {
                                                                        phi_3052_ = true;
                                                                    } else {
                                                                        phi_3052_ = _e2412;
                                                                    }
                                                                    let _e2414 = phi_3052_;
                                                                    if _e2414 {
                                                                        phi_3056_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_3056_ = _e2408;
                                                                    }
                                                                    let _e2416 = phi_3056_;
                                                                    if _e2416.is_hit {
                                                                        if (_e2416.t > _e170.tmin) {
                                                                            if (_e2416.t < _e1957.t) {
                                                                                phi_3104_ = true;
                                                                            } else {
                                                                                if (_e2416.t == _e1957.t) {
                                                                                    if (_e1957.triangle != 4294967295u) {
                                                                                        if (_e1968 < _e1957.triangle) {
                                                                                            phi_3095_ = true;
                                                                                        } else {
                                                                                            if (_e1968 == _e1957.triangle) {
                                                                                                phi_3094_ = (_e987 < _e1957.instance);
                                                                                            } else {
                                                                                                phi_3094_ = false;
                                                                                            }
                                                                                            let _e2434 = phi_3094_;
                                                                                            phi_3095_ = _e2434;
                                                                                        }
                                                                                        let _e2436 = phi_3095_;
                                                                                        phi_3096_ = _e2436;
                                                                                        phi_3097_ = false;
                                                                                    } else {
                                                                                        phi_3096_ = bool();
                                                                                        phi_3097_ = true;
                                                                                    }
                                                                                    let _e2438 = phi_3096_;
                                                                                    let _e2440 = phi_3097_;
                                                                                    phi_3098_ = _e2438;
                                                                                    phi_3099_ = _e2440;
                                                                                } else {
                                                                                    phi_3098_ = bool();
                                                                                    phi_3099_ = true;
                                                                                }
                                                                                let _e2442 = phi_3098_;
                                                                                let _e2444 = phi_3099_;
                                                                                if _e2444 {
                                                                                    phi_3103_ = false;
                                                                                } else {
                                                                                    phi_3103_ = _e2442;
                                                                                }
                                                                                let _e2446 = phi_3103_;
                                                                                phi_3104_ = _e2446;
                                                                            }
                                                                            let _e2448 = phi_3104_;
                                                                            if _e2448 {
                                                                                let _e2450 = triangles.member[(0u + _e1968)].i0_;
                                                                                if ((_e2450 & 2147483648u) == 0u) {
                                                                                    phi_3315_ = true;
                                                                                } else {
                                                                                    if (_e1968 < _e83) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2459 = triangles.member[(0u + _e1968)].i0_;
                                                                                    let _e2460 = (_e2459 & 2147483647u);
                                                                                    let _e2462 = triangles.member[(0u + _e1968)].i1_;
                                                                                    let _e2464 = triangles.member[(0u + _e1968)].i2_;
                                                                                    if (_e2460 < _e86) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2468 = vertices.member[(0u + _e2460)];
                                                                                    if (_e2462 < _e86) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2472 = vertices.member[(0u + _e2462)];
                                                                                    if (_e2464 < _e86) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2476 = vertices.member[(0u + _e2464)];
                                                                                    let _e2477 = array<abi_Vertex, 3>(_e2468, _e2472, _e2476);
                                                                                    if (_e2477[0].material < _e89) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2483 = materials.member[(0u + _e2477[0].material)];
                                                                                    if ((_e2483.flags & 0u) == 0u) {
                                                                                        let _e2488 = ((1f - _e2416.u) - _e2416.v);
                                                                                        if (_e2483.cutoff <= 0f) {
                                                                                            phi_3310_ = true;
                                                                                        } else {
                                                                                            let _e2515 = (_e2483.base_color.w * ((((f32((_e2477[0].color >> bitcast<u32>(24i))) * _e2488) + (f32((_e2477[1].color >> bitcast<u32>(24i))) * _e2416.u)) + (f32((_e2477[2].color >> bitcast<u32>(24i))) * _e2416.v)) * (1f / 255f)));
                                                                                            if (_e2483.alpha_size == 0u) {
                                                                                                phi_3307_ = _e2515;
                                                                                            } else {
                                                                                                local_1.offset = _e2483.alpha_offset;
                                                                                                local_1.size = _e2483.alpha_size;
                                                                                                local_1.flags = _e2483.flags;
                                                                                                let _e2546 = _lt_shaders_texture_TextureView_quad((&local_1), (((_e2477[0].u * _e2488) + (_e2477[1].u * _e2416.u)) + (_e2477[2].u * _e2416.v)), (((_e2477[0].v * _e2488) + (_e2477[1].v * _e2416.u)) + (_e2477[2].v * _e2416.v)));
                                                                                                let _e2550 = (_e2546.indices[0] >> bitcast<u32>(2i));
                                                                                                if (_e2550 < _e98) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2554 = alpha_texels.member[(0u + _e2550)];
                                                                                                let _e2570 = (_e2546.indices[1] >> bitcast<u32>(2i));
                                                                                                if (_e2570 < _e98) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2574 = alpha_texels.member[(0u + _e2570)];
                                                                                                let _e2591 = (_e2546.indices[2] >> bitcast<u32>(2i));
                                                                                                if (_e2591 < _e98) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2595 = alpha_texels.member[(0u + _e2591)];
                                                                                                let _e2612 = (_e2546.indices[3] >> bitcast<u32>(2i));
                                                                                                if (_e2612 < _e98) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2616 = alpha_texels.member[(0u + _e2612)];
                                                                                                phi_3307_ = (_e2515 * (((((f32(((_e2554 >> bitcast<u32>((((_e2546.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2546.weights.x) + ((f32(((_e2574 >> bitcast<u32>((((_e2546.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2546.weights.y)) + ((f32(((_e2595 >> bitcast<u32>((((_e2546.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2546.weights.z)) + ((f32(((_e2616 >> bitcast<u32>((((_e2546.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2546.weights.w)));
                                                                                            }
                                                                                            let _e2632 = phi_3307_;
                                                                                            phi_3310_ = (_e2632 >= _e2483.cutoff);
                                                                                        }
                                                                                        let _e2636 = phi_3310_;
                                                                                        phi_3311_ = _e2636;
                                                                                    } else {
                                                                                        phi_3311_ = false;
                                                                                    }
                                                                                    let _e2638 = phi_3311_;
                                                                                    if _e2638 {
                                                                                    }
                                                                                    phi_3315_ = _e2638;
                                                                                }
                                                                                let _e2640 = phi_3315_;
                                                                                if _e2640 {
                                                                                    phi_3323_ = lt_bvh_Hit(_e2416.t, _e2416.u, _e2416.v, _e1968, _e987);
                                                                                } else {
                                                                                    phi_3323_ = _e1957;
                                                                                }
                                                                                let _e2646 = phi_3323_;
                                                                                phi_3324_ = _e2646;
                                                                            } else {
                                                                                phi_3324_ = _e1957;
                                                                            }
                                                                            let _e2648 = phi_3324_;
                                                                            phi_3325_ = _e2648;
                                                                        } else {
                                                                            phi_3325_ = _e1957;
                                                                        }
                                                                        let _e2650 = phi_3325_;
                                                                        phi_3326_ = _e2650;
                                                                    } else {
                                                                        phi_3326_ = _e1957;
                                                                    }
                                                                    let _e2652 = phi_3326_;
                                                                    phi_2486_ = _e2652;
                                                                    phi_2489_ = (_e1959 & (_e1959 - 1u));
                                                                    phi_3327_ = true;
                                                                }
                                                                let _e2654 = phi_2486_;
                                                                let _e2656 = phi_2489_;
                                                                let _e2658 = phi_3327_;
                                                                continue;
                                                                continuing {
                                                                    phi_2485_ = _e2654;
                                                                    phi_2488_ = _e2656;
                                                                    break if !(_e2658);
                                                                }
                                                            }
                                                            let _e2661 = local_2.group_mask;
                                                            if ((_e2661 & 4278190080u) == 0u) {
                                                                let _e2665 = local_2.len;
                                                                if (_e2665 == 0u) {
                                                                    phi_3366_ = false;
                                                                } else {
                                                                    let _e2669 = local_2.len;
                                                                    local_2.len = (_e2669 - 1u);
                                                                    let _e2672 = local_2.len;
                                                                    if (_e2672 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2677 = local_2.first[(0u + _e2672)];
                                                                    local_2.group = _e2677;
                                                                    let _e2680 = local_2.len;
                                                                    if (_e2680 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2685 = local_2.mask[(0u + _e2680)];
                                                                    local_2.group_mask = _e2685;
                                                                    phi_3366_ = true;
                                                                }
                                                                let _e2688 = phi_3366_;
                                                                phi_3367_ = _e2688;
                                                            } else {
                                                                phi_3367_ = true;
                                                            }
                                                            let _e2690 = phi_3367_;
                                                            if _e2690 {
                                                                let _e2692 = local_2.group_mask;
                                                                let _e2698 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2692)), 32u, (_e2692 == 0u)));
                                                                let _e2702 = local_2.group_mask;
                                                                let _e2716 = local_2.group_mask;
                                                                local_2.group_mask = (_e2716 & ~((1u << bitcast<u32>((_e2698 & 31u)))));
                                                                let _e2719 = local_2.group;
                                                                phi_3398_ = (_e2719 + countOneBits(((_e2702 & ~((4294967295u << bitcast<u32>((((_e2698 - 24u) ^ _e1380) & 31u))))) & 255u)));
                                                            } else {
                                                                phi_3398_ = 4294967295u;
                                                            }
                                                            let _e2722 = phi_3398_;
                                                            let _e4044 = local_10;
                                                            phi_2153_ = _e4044;
                                                            phi_2156_ = _e2722;
                                                        } else {
                                                            phi_2153_ = lt_bvh_Hit();
                                                            phi_2156_ = u32();
                                                        }
                                                        let _e2724 = phi_2153_;
                                                        let _e2726 = phi_2156_;
                                                        continue;
                                                        continuing {
                                                            phi_2152_ = _e2724;
                                                            phi_2155_ = _e2726;
                                                            break if !(_e1521);
                                                        }
                                                    }
                                                    let _e4048 = local_11;
                                                    phi_3399_ = _e4048;
                                                }
                                                let _e2729 = phi_3399_;
                                                phi_3400_ = _e2729;
                                                phi_3401_ = _e1202;
                                            } else {
                                                phi_3400_ = lt_bvh_Hit();
                                                phi_3401_ = true;
                                            }
                                            let _e2731 = phi_3400_;
                                            let _e2733 = phi_3401_;
                                            if _e2733 {
                                                phi_3405_ = _e979;
                                            } else {
                                                phi_3405_ = _e2731;
                                            }
                                            let _e2735 = phi_3405_;
                                            phi_3406_ = _e2735;
                                        } else {
                                            phi_3406_ = _e979;
                                        }
                                        let _e2737 = phi_3406_;
                                        phi_3407_ = _e2737;
                                    } else {
                                        phi_3407_ = _e979;
                                    }
                                    let _e2739 = phi_3407_;
                                    phi_3408_ = _e2739;
                                } else {
                                    phi_3408_ = _e979;
                                }
                                let _e2741 = phi_3408_;
                                phi_1520_ = (_e977 & (_e977 - 1u));
                                phi_1523_ = _e2741;
                                phi_3409_ = true;
                            }
                            let _e2743 = phi_1520_;
                            let _e2745 = phi_1523_;
                            let _e2747 = phi_3409_;
                            continue;
                            continuing {
                                phi_1519_ = _e2743;
                                phi_1522_ = _e2745;
                                break if !(_e2747);
                            }
                        }
                        let _e2750 = local_3.group_mask;
                        if ((_e2750 & 4278190080u) == 0u) {
                            let _e2754 = local_3.len;
                            if (_e2754 == 0u) {
                                phi_3448_ = false;
                            } else {
                                let _e2758 = local_3.len;
                                local_3.len = (_e2758 - 1u);
                                let _e2761 = local_3.len;
                                if (_e2761 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2766 = local_3.first[(0u + _e2761)];
                                local_3.group = _e2766;
                                let _e2769 = local_3.len;
                                if (_e2769 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2774 = local_3.mask[(0u + _e2769)];
                                local_3.group_mask = _e2774;
                                phi_3448_ = true;
                            }
                            let _e2777 = phi_3448_;
                            phi_3449_ = _e2777;
                        } else {
                            phi_3449_ = true;
                        }
                        let _e2779 = phi_3449_;
                        if _e2779 {
                            let _e2781 = local_3.group_mask;
                            let _e2787 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2781)), 32u, (_e2781 == 0u)));
                            let _e2791 = local_3.group_mask;
                            let _e2805 = local_3.group_mask;
                            local_3.group_mask = (_e2805 & ~((1u << bitcast<u32>((_e2787 & 31u)))));
                            let _e2808 = local_3.group;
                            phi_3480_ = (_e2808 + countOneBits(((_e2791 & ~((4294967295u << bitcast<u32>((((_e2787 - 24u) ^ _e396) & 31u))))) & 255u)));
                        } else {
                            phi_3480_ = 4294967295u;
                        }
                        let _e2811 = phi_3480_;
                        phi_1183_ = _e2811;
                        let _e4064 = local_12;
                        phi_1186_ = _e4064;
                    } else {
                        phi_1183_ = u32();
                        phi_1186_ = lt_bvh_Hit();
                    }
                    let _e2813 = phi_1183_;
                    let _e2815 = phi_1186_;
                    continue;
                    continuing {
                        phi_1182_ = _e2813;
                        phi_1185_ = _e2815;
                        break if !(_e537);
                    }
                }
                let _e4067 = local_13;
                phi_3481_ = _e4067;
            }
            let _e2818 = phi_3481_;
            phi_3482_ = _e2818;
            phi_3483_ = _e234;
        } else {
            phi_3482_ = lt_bvh_Hit();
            phi_3483_ = true;
        }
        let _e2820 = phi_3482_;
        let _e2822 = phi_3483_;
        if _e2822 {
            phi_3487_ = _e172;
        } else {
            phi_3487_ = _e2820;
        }
        let _e2824 = phi_3487_;
        if (_e2824.triangle != 4294967295u) {
            let _e2830 = ((1f - _e2824.u) - _e2824.v);
            if (_e2824.triangle < _e83) {
            } else {
                return;
            }
            let _e2835 = triangles.member[(0u + _e2824.triangle)];
            if (_e2824.instance < _e95) {
            } else {
                return;
            }
            let _e2846 = instances.member[(0u + _e2824.instance)].object_to_world[0u];
            let _e2857 = ((((_e2846.x * _e2835.v0_.x) + (_e2846.y * _e2835.v0_.y)) + (_e2846.z * _e2835.v0_.z)) + (_e2846.w * 1f));
            let _e2859 = instances.member[(0u + _e2824.instance)].object_to_world[1u];
            let _e2870 = ((((_e2859.x * _e2835.v0_.x) + (_e2859.y * _e2835.v0_.y)) + (_e2859.z * _e2835.v0_.z)) + (_e2859.w * 1f));
            let _e2872 = instances.member[(0u + _e2824.instance)].object_to_world[2u];
            let _e2883 = ((((_e2872.x * _e2835.v0_.x) + (_e2872.y * _e2835.v0_.y)) + (_e2872.z * _e2835.v0_.z)) + (_e2872.w * 1f));
            let _e2890 = instances.member[(0u + _e2824.instance)].object_to_world[0u];
            let _e2901 = ((((_e2890.x * _e2835.v1_.x) + (_e2890.y * _e2835.v1_.y)) + (_e2890.z * _e2835.v1_.z)) + (_e2890.w * 1f));
            let _e2903 = instances.member[(0u + _e2824.instance)].object_to_world[1u];
            let _e2914 = ((((_e2903.x * _e2835.v1_.x) + (_e2903.y * _e2835.v1_.y)) + (_e2903.z * _e2835.v1_.z)) + (_e2903.w * 1f));
            let _e2916 = instances.member[(0u + _e2824.instance)].object_to_world[2u];
            let _e2927 = ((((_e2916.x * _e2835.v1_.x) + (_e2916.y * _e2835.v1_.y)) + (_e2916.z * _e2835.v1_.z)) + (_e2916.w * 1f));
            let _e2934 = instances.member[(0u + _e2824.instance)].object_to_world[0u];
            let _e2945 = ((((_e2934.x * _e2835.v2_.x) + (_e2934.y * _e2835.v2_.y)) + (_e2934.z * _e2835.v2_.z)) + (_e2934.w * 1f));
            let _e2947 = instances.member[(0u + _e2824.instance)].object_to_world[1u];
            let _e2958 = ((((_e2947.x * _e2835.v2_.x) + (_e2947.y * _e2835.v2_.y)) + (_e2947.z * _e2835.v2_.z)) + (_e2947.w * 1f));
            let _e2960 = instances.member[(0u + _e2824.instance)].object_to_world[2u];
            let _e2971 = ((((_e2960.x * _e2835.v2_.x) + (_e2960.y * _e2835.v2_.y)) + (_e2960.z * _e2835.v2_.z)) + (_e2960.w * 1f));
            let _e2984 = (((_e2857 * _e2830) + (_e2901 * _e2824.u)) + (_e2945 * _e2824.v));
            let _e2985 = (((_e2870 * _e2830) + (_e2914 * _e2824.u)) + (_e2958 * _e2824.v));
            let _e2986 = (((_e2883 * _e2830) + (_e2927 * _e2824.u)) + (_e2971 * _e2824.v));
            let _e2988 = abs(_e2857);
            let _e2989 = abs(_e2870);
            let _e2990 = abs(_e2883);
            let _e2991 = abs(_e2901);
            let _e2992 = abs(_e2914);
            let _e2993 = abs(_e2927);
            if (_e2988 > _e2991) {
                phi_3674_ = _e2988;
            } else {
                phi_3674_ = _e2991;
            }
            let _e2996 = phi_3674_;
            if (_e2989 > _e2992) {
                phi_3679_ = _e2989;
            } else {
                phi_3679_ = _e2992;
            }
            let _e2999 = phi_3679_;
            if (_e2990 > _e2993) {
                phi_3684_ = _e2990;
            } else {
                phi_3684_ = _e2993;
            }
            let _e3002 = phi_3684_;
            let _e3003 = abs(_e2945);
            let _e3004 = abs(_e2958);
            let _e3005 = abs(_e2971);
            if (_e2996 > _e3003) {
                phi_3692_ = _e2996;
            } else {
                phi_3692_ = _e3003;
            }
            let _e3008 = phi_3692_;
            if (_e2999 > _e3004) {
                phi_3697_ = _e2999;
            } else {
                phi_3697_ = _e3004;
            }
            let _e3011 = phi_3697_;
            if (_e3002 > _e3005) {
                phi_3702_ = _e3002;
            } else {
                phi_3702_ = _e3005;
            }
            let _e3014 = phi_3702_;
            let _e3015 = (_e2901 - _e2857);
            let _e3016 = (_e2914 - _e2870);
            let _e3017 = (_e2927 - _e2883);
            let _e3018 = (_e2945 - _e2857);
            let _e3019 = (_e2958 - _e2870);
            let _e3020 = (_e2971 - _e2883);
            let _e3024 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3016), abs(_e3017));
            let _e3025 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3015), _e3024);
            let _e3026 = (_e3015 / _e3025);
            let _e3027 = (_e3016 / _e3025);
            let _e3028 = (_e3017 / _e3025);
            let _e3032 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3019), abs(_e3020));
            let _e3033 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3018), _e3032);
            let _e3034 = (_e3018 / _e3033);
            let _e3035 = (_e3019 / _e3033);
            let _e3036 = (_e3020 / _e3033);
            let _e3039 = ((_e3027 * _e3036) - (_e3035 * _e3028));
            let _e3042 = ((_e3028 * _e3034) - (_e3036 * _e3026));
            let _e3045 = ((_e3026 * _e3035) - (_e3034 * _e3027));
            let _e3047 = p.member.eye;
            let _e3060 = (1f / sqrt((((_e3039 * _e3039) + (_e3042 * _e3042)) + (_e3045 * _e3045))));
            let _e3061 = (_e3039 * _e3060);
            let _e3062 = (_e3042 * _e3060);
            let _e3063 = (_e3045 * _e3060);
            if ((((_e3061 * (_e3047.x - _e2984)) + (_e3062 * (_e3047.y - _e2985))) + (_e3063 * (_e3047.z - _e2986))) < 0f) {
                phi_3766_ = vec3<f32>(-(_e3061), -(_e3062), -(_e3063));
            } else {
                phi_3766_ = vec3<f32>(_e3061, _e3062, _e3063);
            }
            let _e3076 = phi_3766_;
            if (_e2824.triangle < _e83) {
            } else {
                return;
            }
            let _e3081 = triangles.member[(0u + _e2824.triangle)];
            let _e3083 = (_e3081.i0_ & 2147483647u);
            if (_e3083 < _e86) {
            } else {
                return;
            }
            let _e3089 = vertices.member[(0u + _e3083)];
            if (_e3081.i1_ < _e86) {
            } else {
                return;
            }
            let _e3093 = vertices.member[(0u + _e3081.i1_)];
            if (_e3081.i2_ < _e86) {
            } else {
                return;
            }
            let _e3097 = vertices.member[(0u + _e3081.i2_)];
            let _e3098 = array<abi_Vertex, 3>(_e3089, _e3093, _e3097);
            if (_e3098[0].material < _e89) {
            } else {
                return;
            }
            let _e3104 = materials.member[(0u + _e3098[0].material)];
            let _e3121 = (1f / 255f);
            let _e3140 = (1f / 255f);
            let _e3162 = (1f / 255f);
            if (_e3104.color_size == 0u) {
                phi_4009_ = vec3<f32>(1f, 1f, 1f);
            } else {
                local.offset = _e3104.color_offset;
                local.size = _e3104.color_size;
                local.flags = _e3104.flags;
                let _e3205 = _lt_shaders_texture_TextureView_quad((&local), (((_e3098[0].u * _e2830) + (_e3098[1].u * _e2824.u)) + (_e3098[2].u * _e2824.v)), (((_e3098[0].v * _e2830) + (_e3098[1].v * _e2824.u)) + (_e3098[2].v * _e2824.v)));
                if (_e3205.indices[0] < _e101) {
                } else {
                    return;
                }
                let _e3211 = color_texels.member[(0u + _e3205.indices[0])];
                let _e3222 = (1f / 255f);
                if (_e3205.indices[1] < _e101) {
                } else {
                    return;
                }
                let _e3236 = color_texels.member[(0u + _e3205.indices[1])];
                let _e3247 = (1f / 255f);
                if (_e3205.indices[2] < _e101) {
                } else {
                    return;
                }
                let _e3264 = color_texels.member[(0u + _e3205.indices[2])];
                let _e3275 = (1f / 255f);
                if (_e3205.indices[3] < _e101) {
                } else {
                    return;
                }
                let _e3292 = color_texels.member[(0u + _e3205.indices[3])];
                let _e3303 = (1f / 255f);
                let _e3312 = (((((f32((_e3211 & 255u)) * _e3222) * _e3205.weights.x) + ((f32((_e3236 & 255u)) * _e3247) * _e3205.weights.y)) + ((f32((_e3264 & 255u)) * _e3275) * _e3205.weights.z)) + ((f32((_e3292 & 255u)) * _e3303) * _e3205.weights.w));
                let _e3313 = (((((f32(((_e3211 >> bitcast<u32>(8i)) & 255u)) * _e3222) * _e3205.weights.x) + ((f32(((_e3236 >> bitcast<u32>(8i)) & 255u)) * _e3247) * _e3205.weights.y)) + ((f32(((_e3264 >> bitcast<u32>(8i)) & 255u)) * _e3275) * _e3205.weights.z)) + ((f32(((_e3292 >> bitcast<u32>(8i)) & 255u)) * _e3303) * _e3205.weights.w));
                let _e3314 = (((((f32(((_e3211 >> bitcast<u32>(16i)) & 255u)) * _e3222) * _e3205.weights.x) + ((f32(((_e3236 >> bitcast<u32>(16i)) & 255u)) * _e3247) * _e3205.weights.y)) + ((f32(((_e3264 >> bitcast<u32>(16i)) & 255u)) * _e3275) * _e3205.weights.z)) + ((f32(((_e3292 >> bitcast<u32>(16i)) & 255u)) * _e3303) * _e3205.weights.w));
                phi_4009_ = vec3<f32>((_e3312 * _e3312), (_e3313 * _e3313), (_e3314 * _e3314));
            }
            let _e3320 = phi_4009_;
            let _e3322 = ((_e3104.base_color.x * ((((f32((_e3098[0].color & 255u)) * _e3121) * _e2830) + ((f32((_e3098[1].color & 255u)) * _e3140) * _e2824.u)) + ((f32((_e3098[2].color & 255u)) * _e3162) * _e2824.v))) * _e3320.x);
            let _e3324 = ((_e3104.base_color.y * ((((f32(((_e3098[0].color >> bitcast<u32>(8i)) & 255u)) * _e3121) * _e2830) + ((f32(((_e3098[1].color >> bitcast<u32>(8i)) & 255u)) * _e3140) * _e2824.u)) + ((f32(((_e3098[2].color >> bitcast<u32>(8i)) & 255u)) * _e3162) * _e2824.v))) * _e3320.y);
            let _e3326 = ((_e3104.base_color.z * ((((f32(((_e3098[0].color >> bitcast<u32>(16i)) & 255u)) * _e3121) * _e2830) + ((f32(((_e3098[1].color >> bitcast<u32>(16i)) & 255u)) * _e3140) * _e2824.u)) + ((f32(((_e3098[2].color >> bitcast<u32>(16i)) & 255u)) * _e3162) * _e2824.v))) * _e3320.z);
            let _e3327 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e3011, _e3014);
            let _e3328 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e3008, _e3327);
            if ((_e3104.flags & 2u) == 0u) {
                phi_4024_ = 0u;
            } else {
                phi_4024_ = 1u;
            }
            let _e3333 = phi_4024_;
            if (_e3098[0].normal == 2147516416u) {
                phi_4254_ = _e3076;
            } else {
                let _e3346 = (f32((bitcast<i32>((_e3098[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3352 = (f32((bitcast<i32>(_e3098[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3356 = ((1f - abs(_e3346)) - abs(_e3352));
                if (_e3356 < 0f) {
                    phi_4051_ = -(_e3356);
                } else {
                    phi_4051_ = 0f;
                }
                let _e3360 = phi_4051_;
                if (_e3346 < 0f) {
                    phi_4058_ = (_e3346 + _e3360);
                } else {
                    phi_4058_ = (_e3346 - _e3360);
                }
                let _e3365 = phi_4058_;
                if (_e3352 < 0f) {
                    phi_4065_ = (_e3352 + _e3360);
                } else {
                    phi_4065_ = (_e3352 - _e3360);
                }
                let _e3370 = phi_4065_;
                let _e3377 = (1f / sqrt((((_e3365 * _e3365) + (_e3370 * _e3370)) + (_e3356 * _e3356))));
                let _e3393 = (f32((bitcast<i32>((_e3098[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3399 = (f32((bitcast<i32>(_e3098[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3403 = ((1f - abs(_e3393)) - abs(_e3399));
                if (_e3403 < 0f) {
                    phi_4100_ = -(_e3403);
                } else {
                    phi_4100_ = 0f;
                }
                let _e3407 = phi_4100_;
                if (_e3393 < 0f) {
                    phi_4107_ = (_e3393 + _e3407);
                } else {
                    phi_4107_ = (_e3393 - _e3407);
                }
                let _e3412 = phi_4107_;
                if (_e3399 < 0f) {
                    phi_4114_ = (_e3399 + _e3407);
                } else {
                    phi_4114_ = (_e3399 - _e3407);
                }
                let _e3417 = phi_4114_;
                let _e3424 = (1f / sqrt((((_e3412 * _e3412) + (_e3417 * _e3417)) + (_e3403 * _e3403))));
                let _e3443 = (f32((bitcast<i32>((_e3098[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3449 = (f32((bitcast<i32>(_e3098[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3453 = ((1f - abs(_e3443)) - abs(_e3449));
                if (_e3453 < 0f) {
                    phi_4152_ = -(_e3453);
                } else {
                    phi_4152_ = 0f;
                }
                let _e3457 = phi_4152_;
                if (_e3443 < 0f) {
                    phi_4159_ = (_e3443 + _e3457);
                } else {
                    phi_4159_ = (_e3443 - _e3457);
                }
                let _e3462 = phi_4159_;
                if (_e3449 < 0f) {
                    phi_4166_ = (_e3449 + _e3457);
                } else {
                    phi_4166_ = (_e3449 - _e3457);
                }
                let _e3467 = phi_4166_;
                let _e3474 = (1f / sqrt((((_e3462 * _e3462) + (_e3467 * _e3467)) + (_e3453 * _e3453))));
                let _e3481 = ((((_e3365 * _e3377) * _e2830) + ((_e3412 * _e3424) * _e2824.u)) + ((_e3462 * _e3474) * _e2824.v));
                let _e3482 = ((((_e3370 * _e3377) * _e2830) + ((_e3417 * _e3424) * _e2824.u)) + ((_e3467 * _e3474) * _e2824.v));
                let _e3483 = ((((_e3356 * _e3377) * _e2830) + ((_e3403 * _e3424) * _e2824.u)) + ((_e3453 * _e3474) * _e2824.v));
                if (_e2824.instance < _e95) {
                } else {
                    return;
                }
                let _e3490 = instances.member[(0u + _e2824.instance)].world_to_object[0u];
                let _e3499 = instances.member[(0u + _e2824.instance)].world_to_object[1u];
                let _e3511 = instances.member[(0u + _e2824.instance)].world_to_object[2u];
                let _e3518 = (((_e3490.x * _e3481) + (_e3499.x * _e3482)) + (_e3511.x * _e3483));
                let _e3519 = (((_e3490.y * _e3481) + (_e3499.y * _e3482)) + (_e3511.y * _e3483));
                let _e3520 = (((_e3490.z * _e3481) + (_e3499.z * _e3482)) + (_e3511.z * _e3483));
                let _e3526 = sqrt((((_e3518 * _e3518) + (_e3519 * _e3519)) + (_e3520 * _e3520)));
                if (_e3526 > 0f) {
                    let _e3528 = (_e3518 / _e3526);
                    let _e3529 = (_e3519 / _e3526);
                    let _e3530 = (_e3520 / _e3526);
                    if ((((_e3528 * _e3076.x) + (_e3529 * _e3076.y)) + (_e3530 * _e3076.z)) < 0f) {
                        phi_4252_ = vec3<f32>(-(_e3528), -(_e3529), -(_e3530));
                    } else {
                        phi_4252_ = vec3<f32>(_e3528, _e3529, _e3530);
                    }
                    let _e3546 = phi_4252_;
                    phi_4253_ = _e3546;
                } else {
                    phi_4253_ = _e3076;
                }
                let _e3548 = phi_4253_;
                phi_4254_ = _e3548;
            }
            let _e3550 = phi_4254_;
            if (_e3322 > 0f) {
                if (_e3322 < 1f) {
                    phi_4263_ = _e3322;
                } else {
                    phi_4263_ = 1f;
                }
                let _e3554 = phi_4263_;
                phi_4264_ = _e3554;
            } else {
                phi_4264_ = 0f;
            }
            let _e3556 = phi_4264_;
            if (_e3324 > 0f) {
                if (_e3324 < 1f) {
                    phi_4274_ = _e3324;
                } else {
                    phi_4274_ = 1f;
                }
                let _e3561 = phi_4274_;
                phi_4275_ = _e3561;
            } else {
                phi_4275_ = 0f;
            }
            let _e3563 = phi_4275_;
            if (_e3326 > 0f) {
                if (_e3326 < 1f) {
                    phi_4285_ = _e3326;
                } else {
                    phi_4285_ = 1f;
                }
                let _e3568 = phi_4285_;
                phi_4286_ = _e3568;
            } else {
                phi_4286_ = 0f;
            }
            let _e3570 = phi_4286_;
            let _e3573 = ((sqrt(_e3556) * 255f) + 0.5f);
            let _e3582 = ((sqrt(_e3563) * 255f) + 0.5f);
            let _e3594 = ((sqrt(_e3570) * 255f) + 0.5f);
            phi_4321_ = abi_Sample(vec3<f32>(_e2984, _e2985, _e2986), _e3328, _e3076, _e3333, _e3550, ((select(select(u32(_e3573), 0u, (_e3573 < bitcast<f32>(0u))), 4294967295u, (_e3573 > bitcast<f32>(1333788671u))) | (select(select(u32(_e3582), 0u, (_e3582 < bitcast<f32>(0u))), 4294967295u, (_e3582 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e3594), 0u, (_e3594 < bitcast<f32>(0u))), 4294967295u, (_e3594 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_4321_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e3608 = phi_4321_;
        if (_e113.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e113.shift)] = _e3608;
        if (_e2824.triangle != 4294967295u) {
            let _e3617 = ((1f - _e2824.u) - _e2824.v);
            if (_e2824.triangle < _e83) {
            } else {
                return;
            }
            let _e3622 = triangles.member[(0u + _e2824.triangle)];
            let _e3624 = (_e3622.i0_ & 2147483647u);
            if (_e3624 < _e104) {
            } else {
                return;
            }
            let _e3630 = before.member[(0u + _e3624)];
            if (_e3622.i1_ < _e104) {
            } else {
                return;
            }
            let _e3634 = before.member[(0u + _e3622.i1_)];
            if (_e3622.i2_ < _e104) {
            } else {
                return;
            }
            let _e3638 = before.member[(0u + _e3622.i2_)];
            if (_e2824.instance < _e95) {
            } else {
                return;
            }
            let _e3648 = instances.member[(0u + _e2824.instance)].object_to_world[0u];
            let _e3661 = instances.member[(0u + _e2824.instance)].object_to_world[1u];
            let _e3674 = instances.member[(0u + _e2824.instance)].object_to_world[2u];
            if (_e2824.instance < _e95) {
            } else {
                return;
            }
            let _e3698 = instances.member[(0u + _e2824.instance)].object_to_world[0u];
            let _e3711 = instances.member[(0u + _e2824.instance)].object_to_world[1u];
            let _e3724 = instances.member[(0u + _e2824.instance)].object_to_world[2u];
            if (_e2824.instance < _e95) {
            } else {
                return;
            }
            let _e3751 = instances.member[(0u + _e2824.instance)].object_to_world[0u];
            let _e3764 = instances.member[(0u + _e2824.instance)].object_to_world[1u];
            let _e3777 = instances.member[(0u + _e2824.instance)].object_to_world[2u];
            phi_4544_ = vec3<f32>((((((((_e3648.x * _e3630.x) + (_e3648.y * _e3630.y)) + (_e3648.z * _e3630.z)) + (_e3648.w * 1f)) * _e3617) + (((((_e3698.x * _e3634.x) + (_e3698.y * _e3634.y)) + (_e3698.z * _e3634.z)) + (_e3698.w * 1f)) * _e2824.u)) + (((((_e3751.x * _e3638.x) + (_e3751.y * _e3638.y)) + (_e3751.z * _e3638.z)) + (_e3751.w * 1f)) * _e2824.v)), (((((((_e3661.x * _e3630.x) + (_e3661.y * _e3630.y)) + (_e3661.z * _e3630.z)) + (_e3661.w * 1f)) * _e3617) + (((((_e3711.x * _e3634.x) + (_e3711.y * _e3634.y)) + (_e3711.z * _e3634.z)) + (_e3711.w * 1f)) * _e2824.u)) + (((((_e3764.x * _e3638.x) + (_e3764.y * _e3638.y)) + (_e3764.z * _e3638.z)) + (_e3764.w * 1f)) * _e2824.v)), (((((((_e3674.x * _e3630.x) + (_e3674.y * _e3630.y)) + (_e3674.z * _e3630.z)) + (_e3674.w * 1f)) * _e3617) + (((((_e3724.x * _e3634.x) + (_e3724.y * _e3634.y)) + (_e3724.z * _e3634.z)) + (_e3724.w * 1f)) * _e2824.u)) + (((((_e3777.x * _e3638.x) + (_e3777.y * _e3638.y)) + (_e3777.z * _e3638.z)) + (_e3777.w * 1f)) * _e2824.v)));
        } else {
            phi_4544_ = vec3<f32>(0f, 0f, 0f);
        }
        let _e3797 = phi_4544_;
        if (_e113.shift < arrayLength((&past.member))) {
        } else {
            return;
        }
        past.member[(0u + _e113.shift)] = vec4<f32>(_e3797.x, _e3797.y, _e3797.z, 1f);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_instanced_alpha_color_motion_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
