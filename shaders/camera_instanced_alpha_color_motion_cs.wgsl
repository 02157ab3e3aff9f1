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
    var phi_230_: lt_mask_LightPlace;
    var phi_231_: bool;
    var phi_232_: lt_mask_LightPlace;
    var phi_233_: bool;
    var phi_238_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_230_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_231_ = false;
        } else {
            phi_230_ = lt_mask_LightPlace();
            phi_231_ = true;
        }
        let _e85 = phi_230_;
        let _e87 = phi_231_;
        phi_232_ = _e85;
        phi_233_ = _e87;
    } else {
        phi_232_ = lt_mask_LightPlace();
        phi_233_ = true;
    }
    let _e89 = phi_232_;
    let _e91 = phi_233_;
    if _e91 {
        phi_238_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_238_ = _e89;
    }
    let _e96 = phi_238_;
    return lt_mask_LightPlace(_e96.word, _e96.shift);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_253_: bool;
    var phi_257_: f32;

    if (param_3 != param_3) {
        phi_253_ = true;
    } else {
        let _e75 = (param_4 >= param_3);
        if _e75 {
        }
        phi_253_ = _e75;
    }
    let _e77 = phi_253_;
    if _e77 {
        phi_257_ = param_4;
    } else {
        phi_257_ = param_3;
    }
    let _e79 = phi_257_;
    return _e79;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_269_: bool;
    var phi_273_: f32;

    if (param_5 != param_5) {
        phi_269_ = true;
    } else {
        let _e75 = (param_6 <= param_5);
        if _e75 {
        }
        phi_269_ = _e75;
    }
    let _e77 = phi_269_;
    if _e77 {
        phi_273_ = param_6;
    } else {
        phi_273_ = param_5;
    }
    let _e79 = phi_273_;
    return _e79;
}

fn _lt_shaders_texture_TextureView_quad(param_7: ptr<function, texture_TextureView>, param_8: f32, param_9: f32) -> texture_TexelQuad {
    var phi_315_: f32;
    var phi_320_: f32;
    var phi_321_: bool;
    var phi_322_: f32;
    var phi_323_: bool;
    var phi_327_: f32;
    var phi_353_: f32;
    var phi_358_: f32;
    var phi_359_: bool;
    var phi_360_: f32;
    var phi_361_: bool;
    var phi_365_: f32;
    var phi_373_: f32;
    var phi_374_: f32;
    var phi_375_: f32;
    var phi_384_: f32;
    var phi_385_: f32;
    var phi_403_: u32;
    var phi_417_: u32;
    var phi_424_: u32;
    var phi_429_: u32;
    var phi_435_: u32;
    var phi_440_: u32;
    var phi_442_: texture_Axis;
    var phi_470_: f32;
    var phi_475_: f32;
    var phi_476_: bool;
    var phi_477_: f32;
    var phi_478_: bool;
    var phi_482_: f32;
    var phi_508_: f32;
    var phi_513_: f32;
    var phi_514_: bool;
    var phi_515_: f32;
    var phi_516_: bool;
    var phi_520_: f32;
    var phi_528_: f32;
    var phi_529_: f32;
    var phi_530_: f32;
    var phi_539_: f32;
    var phi_540_: f32;
    var phi_558_: u32;
    var phi_572_: u32;
    var phi_579_: u32;
    var phi_584_: u32;
    var phi_590_: u32;
    var phi_595_: u32;
    var phi_597_: texture_Axis;

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
                phi_315_ = 1f;
            } else {
                phi_315_ = 0f;
            }
            let _e106 = phi_315_;
            if (param_8 < 8388608f) {
                phi_320_ = (_e103 - _e106);
                phi_321_ = false;
            } else {
                phi_320_ = f32();
                phi_321_ = true;
            }
            let _e109 = phi_320_;
            let _e111 = phi_321_;
            phi_322_ = _e109;
            phi_323_ = _e111;
        } else {
            phi_322_ = f32();
            phi_323_ = true;
        }
        let _e113 = phi_322_;
        let _e115 = phi_323_;
        if _e115 {
            phi_327_ = param_8;
        } else {
            phi_327_ = _e113;
        }
        let _e117 = phi_327_;
        phi_375_ = (param_8 - _e117);
    } else {
        if (_e90 == 1u) {
            let _e120 = (param_8 * 0.5f);
            if (_e120 > -8388608f) {
                let _e132 = f32(select(0i, select(select(i32(_e120), i32(-2147483648), (_e120 < bitcast<f32>(3472883712u))), 2147483647i, (_e120 > bitcast<f32>(1325400063u))), (_e120 == _e120)));
                if (_e132 > _e120) {
                    phi_353_ = 1f;
                } else {
                    phi_353_ = 0f;
                }
                let _e135 = phi_353_;
                if (_e120 < 8388608f) {
                    phi_358_ = (_e132 - _e135);
                    phi_359_ = false;
                } else {
                    phi_358_ = f32();
                    phi_359_ = true;
                }
                let _e138 = phi_358_;
                let _e140 = phi_359_;
                phi_360_ = _e138;
                phi_361_ = _e140;
            } else {
                phi_360_ = f32();
                phi_361_ = true;
            }
            let _e142 = phi_360_;
            let _e144 = phi_361_;
            if _e144 {
                phi_365_ = _e120;
            } else {
                phi_365_ = _e142;
            }
            let _e146 = phi_365_;
            let _e148 = (param_8 - (2f * _e146));
            if (_e148 > 1f) {
                phi_373_ = (2f - _e148);
            } else {
                phi_373_ = _e148;
            }
            let _e152 = phi_373_;
            phi_374_ = _e152;
        } else {
            phi_374_ = param_8;
        }
        let _e154 = phi_374_;
        phi_375_ = _e154;
    }
    let _e156 = phi_375_;
    if (_e156 > 0f) {
        if (_e156 < 1f) {
            phi_384_ = _e156;
        } else {
            phi_384_ = 1f;
        }
        let _e160 = phi_384_;
        phi_385_ = _e160;
    } else {
        phi_385_ = 0f;
    }
    let _e162 = phi_385_;
    let _e163 = (_e77 - 1u);
    let _e165 = (_e162 * f32(_e77));
    if _e85 {
        let _e172 = select(select(u32(_e165), 0u, (_e165 < bitcast<f32>(0u))), 4294967295u, (_e165 > bitcast<f32>(1333788671u)));
        if (_e163 < _e172) {
            phi_403_ = _e163;
        } else {
            phi_403_ = _e172;
        }
        let _e175 = phi_403_;
        phi_442_ = texture_Axis(_e175, _e175, 0f);
    } else {
        let _e177 = (_e165 + 0.5f);
        let _e184 = select(select(u32(_e177), 0u, (_e177 < bitcast<f32>(0u))), 4294967295u, (_e177 > bitcast<f32>(1333788671u)));
        if (_e77 < _e184) {
            phi_417_ = _e77;
        } else {
            phi_417_ = _e184;
        }
        let _e187 = phi_417_;
        if (_e90 == 0u) {
            phi_424_ = _e163;
        } else {
            phi_424_ = 0u;
        }
        let _e192 = phi_424_;
        if (_e90 == 0u) {
            phi_429_ = 0u;
        } else {
            phi_429_ = _e163;
        }
        let _e195 = phi_429_;
        if (_e187 == 0u) {
            phi_435_ = _e192;
        } else {
            phi_435_ = (_e187 - 1u);
        }
        let _e199 = phi_435_;
        if (_e187 > _e163) {
            phi_440_ = _e195;
        } else {
            phi_440_ = _e187;
        }
        let _e202 = phi_440_;
        phi_442_ = texture_Axis(_e199, _e202, (_e177 - f32(_e187)));
    }
    let _e205 = phi_442_;
    let _e207 = (*param_7).flags;
    let _e210 = ((_e207 >> bitcast<u32>(6u)) & 3u);
    if (_e210 == 0u) {
        if (param_9 > -8388608f) {
            let _e223 = f32(select(0i, select(select(i32(param_9), i32(-2147483648), (param_9 < bitcast<f32>(3472883712u))), 2147483647i, (param_9 > bitcast<f32>(1325400063u))), (param_9 == param_9)));
            if (_e223 > param_9) {
                phi_470_ = 1f;
            } else {
                phi_470_ = 0f;
            }
            let _e226 = phi_470_;
            if (param_9 < 8388608f) {
                phi_475_ = (_e223 - _e226);
                phi_476_ = false;
            } else {
                phi_475_ = f32();
                phi_476_ = true;
            }
            let _e229 = phi_475_;
            let _e231 = phi_476_;
            phi_477_ = _e229;
            phi_478_ = _e231;
        } else {
            phi_477_ = f32();
            phi_478_ = true;
        }
        let _e233 = phi_477_;
        let _e235 = phi_478_;
        if _e235 {
            phi_482_ = param_9;
        } else {
            phi_482_ = _e233;
        }
        let _e237 = phi_482_;
        phi_530_ = (param_9 - _e237);
    } else {
        if (_e210 == 1u) {
            let _e240 = (param_9 * 0.5f);
            if (_e240 > -8388608f) {
                let _e252 = f32(select(0i, select(select(i32(_e240), i32(-2147483648), (_e240 < bitcast<f32>(3472883712u))), 2147483647i, (_e240 > bitcast<f32>(1325400063u))), (_e240 == _e240)));
                if (_e252 > _e240) {
                    phi_508_ = 1f;
                } else {
                    phi_508_ = 0f;
                }
                let _e255 = phi_508_;
                if (_e240 < 8388608f) {
                    phi_513_ = (_e252 - _e255);
                    phi_514_ = false;
                } else {
                    phi_513_ = f32();
                    phi_514_ = true;
                }
                let _e258 = phi_513_;
                let _e260 = phi_514_;
                phi_515_ = _e258;
                phi_516_ = _e260;
            } else {
                phi_515_ = f32();
                phi_516_ = true;
            }
            let _e262 = phi_515_;
            let _e264 = phi_516_;
            if _e264 {
                phi_520_ = _e240;
            } else {
                phi_520_ = _e262;
            }
            let _e266 = phi_520_;
            let _e268 = (param_9 - (2f * _e266));
            if (_e268 > 1f) {
                phi_528_ = (2f - _e268);
            } else {
                phi_528_ = _e268;
            }
            let _e272 = phi_528_;
            phi_529_ = _e272;
        } else {
            phi_529_ = param_9;
        }
        let _e274 = phi_529_;
        phi_530_ = _e274;
    }
    let _e276 = phi_530_;
    if (_e276 > 0f) {
        if (_e276 < 1f) {
            phi_539_ = _e276;
        } else {
            phi_539_ = 1f;
        }
        let _e280 = phi_539_;
        phi_540_ = _e280;
    } else {
        phi_540_ = 0f;
    }
    let _e282 = phi_540_;
    let _e283 = (_e81 - 1u);
    let _e285 = (_e282 * f32(_e81));
    if _e85 {
        let _e292 = select(select(u32(_e285), 0u, (_e285 < bitcast<f32>(0u))), 4294967295u, (_e285 > bitcast<f32>(1333788671u)));
        if (_e283 < _e292) {
            phi_558_ = _e283;
        } else {
            phi_558_ = _e292;
        }
        let _e295 = phi_558_;
        phi_597_ = texture_Axis(_e295, _e295, 0f);
    } else {
        let _e297 = (_e285 + 0.5f);
        let _e304 = select(select(u32(_e297), 0u, (_e297 < bitcast<f32>(0u))), 4294967295u, (_e297 > bitcast<f32>(1333788671u)));
        if (_e81 < _e304) {
            phi_572_ = _e81;
        } else {
            phi_572_ = _e304;
        }
        let _e307 = phi_572_;
        if (_e210 == 0u) {
            phi_579_ = _e283;
        } else {
            phi_579_ = 0u;
        }
        let _e312 = phi_579_;
        if (_e210 == 0u) {
            phi_584_ = 0u;
        } else {
            phi_584_ = _e283;
        }
        let _e315 = phi_584_;
        if (_e307 == 0u) {
            phi_590_ = _e312;
        } else {
            phi_590_ = (_e307 - 1u);
        }
        let _e319 = phi_590_;
        if (_e307 > _e283) {
            phi_595_ = _e315;
        } else {
            phi_595_ = _e307;
        }
        let _e322 = phi_595_;
        phi_597_ = texture_Axis(_e319, _e322, (_e297 - f32(_e307)));
    }
    let _e325 = phi_597_;
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
    var phi_656_: f32;

    if (param_12 > param_13) {
        phi_656_ = param_12;
    } else {
        phi_656_ = param_13;
    }
    let _e76 = phi_656_;
    return _e76;
}

fn function_() {
    var local: texture_TextureView;
    var local_1: texture_TextureView;
    var local_2: lt_bvh_traverse_Stack;
    var local_3: lt_bvh_traverse_Stack;
    var phi_797_: bool;
    var phi_798_: bool;
    var phi_799_: bool;
    var phi_800_: bool;
    var phi_804_: bool;
    var phi_817_: bool;
    var phi_818_: bool;
    var phi_819_: bool;
    var phi_820_: bool;
    var phi_824_: bool;
    var phi_837_: bool;
    var phi_838_: bool;
    var phi_839_: bool;
    var phi_843_: bool;
    var phi_844_: bool;
    var phi_845_: bool;
    var phi_846_: bool;
    var phi_847_: bool;
    var phi_851_: bool;
    var phi_927_: f32;
    var phi_934_: f32;
    var phi_942_: f32;
    var phi_949_: f32;
    var phi_957_: f32;
    var phi_964_: f32;
    var phi_987_: f32;
    var phi_992_: f32;
    var phi_997_: f32;
    var phi_1002_: f32;
    var phi_1007_: f32;
    var phi_1026_: u32;
    var phi_1031_: u32;
    var phi_1036_: u32;
    var phi_1150_: bool;
    var phi_1151_: bool;
    var phi_1182_: u32;
    var phi_1184_: u32;
    var phi_1187_: lt_bvh_Hit;
    var phi_1272_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1299_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1326_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1332_: u32;
    var phi_1335_: u32;
    var phi_1349_: u32;
    var phi_1359_: u32;
    var phi_1369_: u32;
    var phi_1387_: u32;
    var phi_1397_: u32;
    var phi_1407_: u32;
    var phi_1443_: u32;
    var phi_1456_: u32;
    var phi_1461_: u32;
    var phi_1462_: u32;
    var phi_1463_: u32;
    var phi_1333_: u32;
    var phi_1336_: u32;
    var local_4: u32;
    var local_5: u32;
    var local_6: u32;
    var phi_1521_: u32;
    var phi_1524_: lt_bvh_Hit;
    var phi_1579_: f32;
    var phi_1584_: f32;
    var phi_1589_: f32;
    var phi_1597_: f32;
    var phi_1602_: f32;
    var phi_1607_: f32;
    var phi_1739_: bool;
    var phi_1740_: bool;
    var phi_1741_: bool;
    var phi_1742_: bool;
    var phi_1746_: bool;
    var phi_1759_: bool;
    var phi_1760_: bool;
    var phi_1761_: bool;
    var phi_1762_: bool;
    var phi_1766_: bool;
    var phi_1779_: bool;
    var phi_1780_: bool;
    var phi_1781_: bool;
    var phi_1785_: bool;
    var phi_1786_: bool;
    var phi_1787_: bool;
    var phi_1788_: bool;
    var phi_1789_: bool;
    var phi_1793_: bool;
    var phi_1863_: f32;
    var phi_1870_: f32;
    var phi_1877_: f32;
    var phi_1884_: f32;
    var phi_1891_: f32;
    var phi_1898_: f32;
    var phi_1915_: f32;
    var phi_1920_: f32;
    var phi_1925_: f32;
    var phi_1930_: f32;
    var phi_1935_: f32;
    var phi_1961_: bool;
    var phi_1962_: bool;
    var phi_1970_: u32;
    var phi_1971_: u32;
    var phi_1982_: vec3<f32>;
    var phi_1983_: vec3<f32>;
    var phi_1996_: u32;
    var phi_2001_: u32;
    var phi_2006_: u32;
    var phi_2120_: bool;
    var phi_2121_: bool;
    var phi_2152_: u32;
    var phi_2154_: lt_bvh_Hit;
    var phi_2157_: u32;
    var phi_2238_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2265_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2292_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2298_: u32;
    var phi_2301_: u32;
    var phi_2315_: u32;
    var phi_2325_: u32;
    var phi_2335_: u32;
    var phi_2353_: u32;
    var phi_2363_: u32;
    var phi_2373_: u32;
    var phi_2409_: u32;
    var phi_2422_: u32;
    var phi_2427_: u32;
    var phi_2428_: u32;
    var phi_2429_: u32;
    var phi_2299_: u32;
    var phi_2302_: u32;
    var local_7: u32;
    var local_8: u32;
    var local_9: u32;
    var phi_2487_: lt_bvh_Hit;
    var phi_2490_: u32;
    var phi_2534_: vec3<f32>;
    var phi_2535_: vec3<f32>;
    var phi_2564_: vec3<f32>;
    var phi_2565_: vec3<f32>;
    var phi_2594_: vec3<f32>;
    var phi_2595_: vec3<f32>;
    var phi_2613_: bool;
    var phi_2614_: bool;
    var phi_2618_: f32;
    var phi_2619_: f32;
    var phi_2620_: f32;
    var phi_2621_: f32;
    var phi_2629_: f32;
    var phi_2639_: bool;
    var phi_2640_: bool;
    var phi_2644_: f32;
    var phi_2645_: f32;
    var phi_2646_: f32;
    var phi_2647_: f32;
    var phi_2655_: f32;
    var phi_2665_: bool;
    var phi_2666_: bool;
    var phi_2670_: f32;
    var phi_2671_: f32;
    var phi_2672_: f32;
    var phi_2673_: f32;
    var phi_2681_: f32;
    var phi_2696_: f32;
    var phi_2697_: bool;
    var phi_2698_: f32;
    var phi_2699_: bool;
    var phi_2700_: f32;
    var phi_2701_: bool;
    var phi_2719_: f32;
    var phi_2720_: bool;
    var phi_2721_: bool;
    var phi_2722_: f32;
    var phi_2723_: bool;
    var phi_2724_: bool;
    var phi_2728_: bool;
    var phi_2729_: f32;
    var phi_2730_: bool;
    var phi_2758_: vec3<f32>;
    var phi_2759_: vec3<f32>;
    var phi_2784_: vec3<f32>;
    var phi_2785_: vec3<f32>;
    var phi_2810_: vec3<f32>;
    var phi_2811_: vec3<f32>;
    var phi_2867_: f32;
    var phi_2876_: f32;
    var phi_2885_: f32;
    var phi_2894_: f32;
    var phi_2901_: f32;
    var phi_2908_: f32;
    var phi_2921_: f32;
    var phi_2930_: f32;
    var phi_2939_: f32;
    var phi_2948_: f32;
    var phi_2955_: f32;
    var phi_2962_: f32;
    var phi_2979_: f32;
    var phi_2984_: f32;
    var phi_2989_: f32;
    var phi_2997_: f32;
    var phi_3002_: f32;
    var phi_3007_: f32;
    var phi_3019_: f32;
    var phi_3024_: f32;
    var phi_3029_: f32;
    var phi_3034_: f32;
    var phi_3039_: lt_bvh_triangle_Intersection;
    var phi_3040_: bool;
    var phi_3041_: lt_bvh_triangle_Intersection;
    var phi_3042_: bool;
    var phi_3046_: lt_bvh_triangle_Intersection;
    var phi_3047_: bool;
    var phi_3048_: lt_bvh_triangle_Intersection;
    var phi_3049_: bool;
    var phi_3050_: bool;
    var phi_3054_: bool;
    var phi_3058_: lt_bvh_triangle_Intersection;
    var phi_3096_: bool;
    var phi_3097_: bool;
    var phi_3098_: bool;
    var phi_3099_: bool;
    var phi_3100_: bool;
    var phi_3101_: bool;
    var phi_3105_: bool;
    var phi_3106_: bool;
    var phi_3309_: f32;
    var phi_3312_: bool;
    var phi_3313_: bool;
    var phi_3317_: bool;
    var phi_3325_: lt_bvh_Hit;
    var phi_3326_: lt_bvh_Hit;
    var phi_3327_: lt_bvh_Hit;
    var phi_3328_: lt_bvh_Hit;
    var phi_2488_: lt_bvh_Hit;
    var phi_2491_: u32;
    var phi_3329_: bool;
    var phi_3368_: bool;
    var phi_3369_: bool;
    var phi_3400_: u32;
    var phi_2155_: lt_bvh_Hit;
    var phi_2158_: u32;
    var phi_3401_: lt_bvh_Hit;
    var phi_3402_: lt_bvh_Hit;
    var phi_3403_: bool;
    var phi_3407_: lt_bvh_Hit;
    var phi_3408_: lt_bvh_Hit;
    var phi_3409_: lt_bvh_Hit;
    var phi_3410_: lt_bvh_Hit;
    var phi_1522_: u32;
    var phi_1525_: lt_bvh_Hit;
    var phi_3411_: bool;
    var phi_3450_: bool;
    var phi_3451_: bool;
    var phi_3482_: u32;
    var phi_1185_: u32;
    var phi_1188_: lt_bvh_Hit;
    var phi_3483_: lt_bvh_Hit;
    var phi_3484_: lt_bvh_Hit;
    var phi_3485_: bool;
    var phi_3489_: lt_bvh_Hit;
    var phi_3676_: f32;
    var phi_3681_: f32;
    var phi_3686_: f32;
    var phi_3694_: f32;
    var phi_3699_: f32;
    var phi_3704_: f32;
    var phi_3768_: vec3<f32>;
    var phi_4011_: vec3<f32>;
    var phi_4026_: u32;
    var phi_4053_: f32;
    var phi_4060_: f32;
    var phi_4067_: f32;
    var phi_4102_: f32;
    var phi_4109_: f32;
    var phi_4116_: f32;
    var phi_4154_: f32;
    var phi_4161_: f32;
    var phi_4168_: f32;
    var phi_4254_: vec3<f32>;
    var phi_4255_: vec3<f32>;
    var phi_4256_: vec3<f32>;
    var phi_4265_: f32;
    var phi_4266_: f32;
    var phi_4276_: f32;
    var phi_4277_: f32;
    var phi_4287_: f32;
    var phi_4288_: f32;
    var phi_4323_: abi_Sample;
    var phi_4546_: vec3<f32>;
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
                phi_797_ = (abs(_e170.origin.z) < 1000000000000000f);
                phi_798_ = false;
            } else {
                phi_797_ = bool();
                phi_798_ = true;
            }
            let _e191 = phi_797_;
            let _e193 = phi_798_;
            phi_799_ = _e191;
            phi_800_ = _e193;
        } else {
            phi_799_ = bool();
            phi_800_ = true;
        }
        let _e195 = phi_799_;
        let _e197 = phi_800_;
        if _e197 {
            phi_804_ = false;
        } else {
            phi_804_ = _e195;
        }
        let _e199 = phi_804_;
        if _e199 {
            if (_e175 < 1000000000000000f) {
                if (_e177 < 1000000000000000f) {
                    phi_817_ = (_e179 < 1000000000000000f);
                    phi_818_ = false;
                } else {
                    phi_817_ = bool();
                    phi_818_ = true;
                }
                let _e204 = phi_817_;
                let _e206 = phi_818_;
                phi_819_ = _e204;
                phi_820_ = _e206;
            } else {
                phi_819_ = bool();
                phi_820_ = true;
            }
            let _e208 = phi_819_;
            let _e210 = phi_820_;
            if _e210 {
                phi_824_ = false;
            } else {
                phi_824_ = _e208;
            }
            let _e212 = phi_824_;
            if _e212 {
                if (_e175 > 0f) {
                    phi_838_ = bool();
                    phi_839_ = true;
                } else {
                    let _e214 = (_e177 > 0f);
                    if _e214 {
                        phi_837_ = bool();
                    } else {
                        phi_837_ = (_e179 > 0f);
                    }
                    let _e217 = phi_837_;
                    phi_838_ = _e217;
                    phi_839_ = _e214;
                }
                let _e219 = phi_838_;
                let _e221 = phi_839_;
                if _e221 {
                    phi_843_ = true;
                } else {
                    phi_843_ = _e219;
                }
                let _e223 = phi_843_;
                phi_844_ = _e223;
                phi_845_ = false;
            } else {
                phi_844_ = bool();
                phi_845_ = true;
            }
            let _e225 = phi_844_;
            let _e227 = phi_845_;
            phi_846_ = _e225;
            phi_847_ = _e227;
        } else {
            phi_846_ = bool();
            phi_847_ = true;
        }
        let _e229 = phi_846_;
        let _e231 = phi_847_;
        if _e231 {
            phi_851_ = false;
        } else {
            phi_851_ = _e229;
        }
        let _e233 = phi_851_;
        if _e233 {
            let _e234 = (_e119 >= _e80);
            if _e234 {
                phi_3483_ = lt_bvh_Hit();
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
                    phi_927_ = _e305;
                } else {
                    phi_927_ = abs(_e170.direction.x);
                }
                let _e311 = phi_927_;
                if (_e170.direction.x < 0f) {
                    phi_934_ = (-1f / _e311);
                } else {
                    phi_934_ = (1f / _e311);
                }
                let _e316 = phi_934_;
                if (abs(_e170.direction.y) < _e305) {
                    phi_942_ = _e305;
                } else {
                    phi_942_ = abs(_e170.direction.y);
                }
                let _e322 = phi_942_;
                if (_e170.direction.y < 0f) {
                    phi_949_ = (-1f / _e322);
                } else {
                    phi_949_ = (1f / _e322);
                }
                let _e327 = phi_949_;
                if (abs(_e170.direction.z) < _e305) {
                    phi_957_ = _e305;
                } else {
                    phi_957_ = abs(_e170.direction.z);
                }
                let _e333 = phi_957_;
                if (_e170.direction.z < 0f) {
                    phi_964_ = (-1f / _e333);
                } else {
                    phi_964_ = (1f / _e333);
                }
                let _e338 = phi_964_;
                let _e345 = abs((bitcast<f32>(_e240) - _e170.origin.x));
                let _e346 = abs((bitcast<f32>(_e244) - _e170.origin.y));
                let _e347 = abs((bitcast<f32>(_e248) - _e170.origin.z));
                let _e354 = abs(((bitcast<f32>(_e252) + (bitcast<f32>((((_e264 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e170.origin.x));
                let _e355 = abs(((bitcast<f32>(_e256) + (bitcast<f32>((((_e264 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e170.origin.y));
                let _e356 = abs(((bitcast<f32>(_e260) + (bitcast<f32>((((_e264 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e170.origin.z));
                if (_e345 > _e354) {
                    phi_987_ = _e345;
                } else {
                    phi_987_ = _e354;
                }
                let _e359 = phi_987_;
                if (_e346 > _e355) {
                    phi_992_ = _e346;
                } else {
                    phi_992_ = _e355;
                }
                let _e362 = phi_992_;
                if (_e347 > _e356) {
                    phi_997_ = _e347;
                } else {
                    phi_997_ = _e356;
                }
                let _e365 = phi_997_;
                if (_e359 > _e362) {
                    phi_1002_ = _e359;
                } else {
                    phi_1002_ = _e362;
                }
                let _e368 = phi_1002_;
                if (_e368 > _e365) {
                    phi_1007_ = _e368;
                } else {
                    phi_1007_ = _e365;
                }
                let _e371 = phi_1007_;
                let _e375 = (_e371 * 0.0000019073486f);
                let _e376 = (abs(_e316) * _e375);
                let _e377 = (abs(_e327) * _e375);
                let _e378 = (abs(_e338) * _e375);
                let _e382 = (_e371 * 0.0000009536743f);
                let _e383 = (abs(_e316) * _e382);
                let _e384 = (abs(_e327) * _e382);
                let _e385 = (abs(_e338) * _e382);
                if (_e316 < 0f) {
                    phi_1026_ = 0u;
                } else {
                    phi_1026_ = 1u;
                }
                let _e388 = phi_1026_;
                if (_e327 < 0f) {
                    phi_1031_ = 0u;
                } else {
                    phi_1031_ = 2u;
                }
                let _e391 = phi_1031_;
                if (_e338 < 0f) {
                    phi_1036_ = 0u;
                } else {
                    phi_1036_ = 4u;
                }
                let _e394 = phi_1036_;
                let _e396 = ((_e388 | _e391) | _e394);
                let _e397 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e119, 2147483648u);
                local_3 = lt_bvh_traverse_Stack(array<u32, 32>(_e397.first[0], _e397.first[1], _e397.first[2], _e397.first[3], _e397.first[4], _e397.first[5], _e397.first[6], _e397.first[7], _e397.first[8], _e397.first[9], _e397.first[10], _e397.first[11], _e397.first[12], _e397.first[13], _e397.first[14], _e397.first[15], _e397.first[16], _e397.first[17], _e397.first[18], _e397.first[19], _e397.first[20], _e397.first[21], _e397.first[22], _e397.first[23], _e397.first[24], _e397.first[25], _e397.first[26], _e397.first[27], _e397.first[28], _e397.first[29], _e397.first[30], _e397.first[31]), array<u32, 32>(_e397.mask[0], _e397.mask[1], _e397.mask[2], _e397.mask[3], _e397.mask[4], _e397.mask[5], _e397.mask[6], _e397.mask[7], _e397.mask[8], _e397.mask[9], _e397.mask[10], _e397.mask[11], _e397.mask[12], _e397.mask[13], _e397.mask[14], _e397.mask[15], _e397.mask[16], _e397.mask[17], _e397.mask[18], _e397.mask[19], _e397.mask[20], _e397.mask[21], _e397.mask[22], _e397.mask[23], _e397.mask[24], _e397.mask[25], _e397.mask[26], _e397.mask[27], _e397.mask[28], _e397.mask[29], _e397.mask[30], _e397.mask[31]), _e397.len, _e397.group, _e397.group_mask);
                let _e471 = local_3.group_mask;
                if ((_e471 & 4278190080u) == 0u) {
                    let _e475 = local_3.len;
                    if (_e475 == 0u) {
                        phi_1150_ = false;
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
                        phi_1150_ = true;
                    }
                    let _e498 = phi_1150_;
                    phi_1151_ = _e498;
                } else {
                    phi_1151_ = true;
                }
                let _e500 = phi_1151_;
                if _e500 {
                    let _e502 = local_3.group_mask;
                    let _e508 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e502)), 32u, (_e502 == 0u)));
                    let _e512 = local_3.group_mask;
                    let _e526 = local_3.group_mask;
                    local_3.group_mask = (_e526 & ~((1u << bitcast<u32>((_e508 & 31u)))));
                    let _e529 = local_3.group;
                    phi_1182_ = (_e529 + countOneBits(((_e512 & ~((4294967295u << bitcast<u32>((((_e508 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1182_ = 4294967295u;
                }
                let _e532 = phi_1182_;
                phi_1184_ = _e532;
                phi_1187_ = _e172;
                loop {
                    let _e534 = phi_1184_;
                    let _e536 = phi_1187_;
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
                            phi_1272_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e624.unnamed, lt_mask_LightPlace(_e624.unnamed_1.word, _e601.y));
                        } else {
                            let _e640 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e601.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e646 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e640.unnamed.word, _e601.y), _e640.unnamed_1);
                            let _e652 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e646.unnamed, lt_mask_LightPlace(_e601.z, _e646.unnamed_1.shift));
                            phi_1272_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e652.unnamed, lt_mask_LightPlace(_e652.unnamed_1.word, _e601.w));
                        }
                        let _e660 = phi_1272_;
                        let _e670 = nodes.member[(0u + _e534)].y;
                        if (_e327 < 0f) {
                            let _e681 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e670.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e687 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e681.unnamed.word, _e670.w), _e681.unnamed_1);
                            let _e693 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e687.unnamed, lt_mask_LightPlace(_e670.x, _e687.unnamed_1.shift));
                            phi_1299_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e693.unnamed, lt_mask_LightPlace(_e693.unnamed_1.word, _e670.y));
                        } else {
                            let _e709 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e670.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e715 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e709.unnamed.word, _e670.y), _e709.unnamed_1);
                            let _e721 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e715.unnamed, lt_mask_LightPlace(_e670.z, _e715.unnamed_1.shift));
                            phi_1299_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e721.unnamed, lt_mask_LightPlace(_e721.unnamed_1.word, _e670.w));
                        }
                        let _e729 = phi_1299_;
                        let _e739 = nodes.member[(0u + _e534)].z;
                        if (_e338 < 0f) {
                            let _e750 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e739.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e756 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e750.unnamed.word, _e739.w), _e750.unnamed_1);
                            let _e762 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e756.unnamed, lt_mask_LightPlace(_e739.x, _e756.unnamed_1.shift));
                            phi_1326_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e762.unnamed, lt_mask_LightPlace(_e762.unnamed_1.word, _e739.y));
                        } else {
                            let _e778 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e739.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e784 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e778.unnamed.word, _e739.y), _e778.unnamed_1);
                            let _e790 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e784.unnamed, lt_mask_LightPlace(_e739.z, _e784.unnamed_1.shift));
                            phi_1326_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e790.unnamed, lt_mask_LightPlace(_e790.unnamed_1.word, _e739.w));
                        }
                        let _e798 = phi_1326_;
                        phi_1332_ = 0u;
                        phi_1335_ = 0u;
                        loop {
                            let _e808 = phi_1332_;
                            let _e810 = phi_1335_;
                            local_4 = _e810;
                            local_5 = _e810;
                            local_6 = _e810;
                            let _e811 = (_e808 < 8u);
                            if _e811 {
                                let _e813 = (_e808 >> bitcast<u32>(2i));
                                let _e814 = (_e808 & 3u);
                                if (_e813 == 0u) {
                                    phi_1349_ = _e660.unnamed.word;
                                } else {
                                    phi_1349_ = _e660.unnamed.shift;
                                }
                                let _e817 = phi_1349_;
                                if (_e813 == 0u) {
                                    phi_1359_ = _e729.unnamed.word;
                                } else {
                                    phi_1359_ = _e729.unnamed.shift;
                                }
                                let _e826 = phi_1359_;
                                if (_e813 == 0u) {
                                    phi_1369_ = _e798.unnamed.word;
                                } else {
                                    phi_1369_ = _e798.unnamed.shift;
                                }
                                let _e835 = phi_1369_;
                                let _e848 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e817 >> bitcast<u32>(((_e814 * 8u) & 31u))) & 255u)) * _e570) + (_e591 - _e376)), ((f32(((_e826 >> bitcast<u32>(((_e814 * 8u) & 31u))) & 255u)) * _e571) + (_e592 - _e377)));
                                let _e849 = core_intrinsics_maximum_number_nsz_f32_(_e848, ((f32(((_e835 >> bitcast<u32>(((_e814 * 8u) & 31u))) & 255u)) * _e572) + (_e593 - _e378)));
                                if (_e813 == 0u) {
                                    phi_1387_ = _e660.unnamed_1.word;
                                } else {
                                    phi_1387_ = _e660.unnamed_1.shift;
                                }
                                let _e852 = phi_1387_;
                                if (_e813 == 0u) {
                                    phi_1397_ = _e729.unnamed_1.word;
                                } else {
                                    phi_1397_ = _e729.unnamed_1.shift;
                                }
                                let _e861 = phi_1397_;
                                if (_e813 == 0u) {
                                    phi_1407_ = _e798.unnamed_1.word;
                                } else {
                                    phi_1407_ = _e798.unnamed_1.shift;
                                }
                                let _e870 = phi_1407_;
                                let _e883 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e852 >> bitcast<u32>(((_e814 * 8u) & 31u))) & 255u)) * _e570) + (_e591 + _e376)), ((f32(((_e861 >> bitcast<u32>(((_e814 * 8u) & 31u))) & 255u)) * _e571) + (_e592 + _e377)));
                                let _e884 = core_intrinsics_minimum_number_nsz_f32_(_e883, ((f32(((_e870 >> bitcast<u32>(((_e814 * 8u) & 31u))) & 255u)) * _e572) + (_e593 + _e378)));
                                if (_e849 <= _e884) {
                                    if (_e849 <= _e536.t) {
                                        if (_e884 >= _e170.tmin) {
                                            if (_e813 == 0u) {
                                                let _e891 = nodes.member[(0u + _e534)].links[2u];
                                                phi_1443_ = _e891;
                                            } else {
                                                let _e894 = nodes.member[(0u + _e534)].links[3u];
                                                phi_1443_ = _e894;
                                            }
                                            let _e896 = phi_1443_;
                                            let _e901 = ((_e896 >> bitcast<u32>(((_e814 * 8u) & 31u))) & 255u);
                                            let _e902 = (_e901 & 31u);
                                            if (_e902 >= 24u) {
                                                phi_1456_ = (24u + ((_e902 - 24u) ^ _e396));
                                            } else {
                                                phi_1456_ = _e902;
                                            }
                                            let _e908 = phi_1456_;
                                            phi_1461_ = (_e810 | ((_e901 >> bitcast<u32>(5i)) << bitcast<u32>((_e908 & 31u))));
                                        } else {
                                            phi_1461_ = _e810;
                                        }
                                        let _e916 = phi_1461_;
                                        phi_1462_ = _e916;
                                    } else {
                                        phi_1462_ = _e810;
                                    }
                                    let _e918 = phi_1462_;
                                    phi_1463_ = _e918;
                                } else {
                                    phi_1463_ = _e810;
                                }
                                let _e920 = phi_1463_;
                                phi_1333_ = (_e808 + 1u);
                                phi_1336_ = _e920;
                            } else {
                                phi_1333_ = u32();
                                phi_1336_ = u32();
                            }
                            let _e923 = phi_1333_;
                            let _e925 = phi_1336_;
                            continue;
                            continuing {
                                phi_1332_ = _e923;
                                phi_1335_ = _e925;
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
                        phi_1521_ = (_e974 & 16777215u);
                        phi_1524_ = _e536;
                        loop {
                            let _e977 = phi_1521_;
                            let _e979 = phi_1524_;
                            local_12 = _e979;
                            if (_e977 == 0u) {
                                phi_1522_ = u32();
                                phi_1525_ = lt_bvh_Hit();
                                phi_3411_ = false;
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
                                    phi_1579_ = _e1006;
                                } else {
                                    phi_1579_ = _e1018;
                                }
                                let _e1023 = phi_1579_;
                                if (_e1007 < _e1019) {
                                    phi_1584_ = _e1007;
                                } else {
                                    phi_1584_ = _e1019;
                                }
                                let _e1026 = phi_1584_;
                                if (_e1008 < _e1020) {
                                    phi_1589_ = _e1008;
                                } else {
                                    phi_1589_ = _e1020;
                                }
                                let _e1029 = phi_1589_;
                                if (_e1006 > _e1018) {
                                    phi_1597_ = _e1006;
                                } else {
                                    phi_1597_ = _e1018;
                                }
                                let _e1035 = phi_1597_;
                                if (_e1007 > _e1019) {
                                    phi_1602_ = _e1007;
                                } else {
                                    phi_1602_ = _e1019;
                                }
                                let _e1038 = phi_1602_;
                                if (_e1008 > _e1020) {
                                    phi_1607_ = _e1008;
                                } else {
                                    phi_1607_ = _e1020;
                                }
                                let _e1041 = phi_1607_;
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
                                                    phi_1739_ = (abs(_e1097) < 1000000000000000f);
                                                    phi_1740_ = false;
                                                } else {
                                                    phi_1739_ = bool();
                                                    phi_1740_ = true;
                                                }
                                                let _e1159 = phi_1739_;
                                                let _e1161 = phi_1740_;
                                                phi_1741_ = _e1159;
                                                phi_1742_ = _e1161;
                                            } else {
                                                phi_1741_ = bool();
                                                phi_1742_ = true;
                                            }
                                            let _e1163 = phi_1741_;
                                            let _e1165 = phi_1742_;
                                            if _e1165 {
                                                phi_1746_ = false;
                                            } else {
                                                phi_1746_ = _e1163;
                                            }
                                            let _e1167 = phi_1746_;
                                            if _e1167 {
                                                if (_e1149 < 1000000000000000f) {
                                                    if (_e1150 < 1000000000000000f) {
                                                        phi_1759_ = (_e1151 < 1000000000000000f);
                                                        phi_1760_ = false;
                                                    } else {
                                                        phi_1759_ = bool();
                                                        phi_1760_ = true;
                                                    }
                                                    let _e1172 = phi_1759_;
                                                    let _e1174 = phi_1760_;
                                                    phi_1761_ = _e1172;
                                                    phi_1762_ = _e1174;
                                                } else {
                                                    phi_1761_ = bool();
                                                    phi_1762_ = true;
                                                }
                                                let _e1176 = phi_1761_;
                                                let _e1178 = phi_1762_;
                                                if _e1178 {
                                                    phi_1766_ = false;
                                                } else {
                                                    phi_1766_ = _e1176;
                                                }
                                                let _e1180 = phi_1766_;
                                                if _e1180 {
                                                    if (_e1149 > 0f) {
                                                        phi_1780_ = bool();
                                                        phi_1781_ = true;
                                                    } else {
                                                        let _e1182 = (_e1150 > 0f);
                                                        if _e1182 {
                                                            phi_1779_ = bool();
                                                        } else {
                                                            phi_1779_ = (_e1151 > 0f);
                                                        }
                                                        let _e1185 = phi_1779_;
                                                        phi_1780_ = _e1185;
                                                        phi_1781_ = _e1182;
                                                    }
                                                    let _e1187 = phi_1780_;
                                                    let _e1189 = phi_1781_;
                                                    if _e1189 {
                                                        phi_1785_ = true;
                                                    } else {
                                                        phi_1785_ = _e1187;
                                                    }
                                                    let _e1191 = phi_1785_;
                                                    phi_1786_ = _e1191;
                                                    phi_1787_ = false;
                                                } else {
                                                    phi_1786_ = bool();
                                                    phi_1787_ = true;
                                                }
                                                let _e1193 = phi_1786_;
                                                let _e1195 = phi_1787_;
                                                phi_1788_ = _e1193;
                                                phi_1789_ = _e1195;
                                            } else {
                                                phi_1788_ = bool();
                                                phi_1789_ = true;
                                            }
                                            let _e1197 = phi_1788_;
                                            let _e1199 = phi_1789_;
                                            if _e1199 {
                                                phi_1793_ = false;
                                            } else {
                                                phi_1793_ = _e1197;
                                            }
                                            let _e1201 = phi_1793_;
                                            if _e1201 {
                                                let _e1202 = (_e1146 >= _e80);
                                                if _e1202 {
                                                    phi_3401_ = lt_bvh_Hit();
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
                                                        phi_1863_ = _e1268;
                                                    } else {
                                                        phi_1863_ = abs(_e1115);
                                                    }
                                                    let _e1273 = phi_1863_;
                                                    if (_e1115 < 0f) {
                                                        phi_1870_ = (-1f / _e1273);
                                                    } else {
                                                        phi_1870_ = (1f / _e1273);
                                                    }
                                                    let _e1278 = phi_1870_;
                                                    if (abs(_e1128) < _e1268) {
                                                        phi_1877_ = _e1268;
                                                    } else {
                                                        phi_1877_ = abs(_e1128);
                                                    }
                                                    let _e1283 = phi_1877_;
                                                    if (_e1128 < 0f) {
                                                        phi_1884_ = (-1f / _e1283);
                                                    } else {
                                                        phi_1884_ = (1f / _e1283);
                                                    }
                                                    let _e1288 = phi_1884_;
                                                    if (abs(_e1141) < _e1268) {
                                                        phi_1891_ = _e1268;
                                                    } else {
                                                        phi_1891_ = abs(_e1141);
                                                    }
                                                    let _e1293 = phi_1891_;
                                                    if (_e1141 < 0f) {
                                                        phi_1898_ = (-1f / _e1293);
                                                    } else {
                                                        phi_1898_ = (1f / _e1293);
                                                    }
                                                    let _e1298 = phi_1898_;
                                                    let _e1302 = abs((bitcast<f32>(_e1208) - _e1071));
                                                    let _e1303 = abs((bitcast<f32>(_e1212) - _e1084));
                                                    let _e1304 = abs((bitcast<f32>(_e1216) - _e1097));
                                                    let _e1308 = abs(((bitcast<f32>(_e1220) + (bitcast<f32>((((_e1232 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1071));
                                                    let _e1309 = abs(((bitcast<f32>(_e1224) + (bitcast<f32>((((_e1232 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1084));
                                                    let _e1310 = abs(((bitcast<f32>(_e1228) + (bitcast<f32>((((_e1232 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1097));
                                                    if (_e1302 > _e1308) {
                                                        phi_1915_ = _e1302;
                                                    } else {
                                                        phi_1915_ = _e1308;
                                                    }
                                                    let _e1313 = phi_1915_;
                                                    if (_e1303 > _e1309) {
                                                        phi_1920_ = _e1303;
                                                    } else {
                                                        phi_1920_ = _e1309;
                                                    }
                                                    let _e1316 = phi_1920_;
                                                    if (_e1304 > _e1310) {
                                                        phi_1925_ = _e1304;
                                                    } else {
                                                        phi_1925_ = _e1310;
                                                    }
                                                    let _e1319 = phi_1925_;
                                                    if (_e1313 > _e1316) {
                                                        phi_1930_ = _e1313;
                                                    } else {
                                                        phi_1930_ = _e1316;
                                                    }
                                                    let _e1322 = phi_1930_;
                                                    if (_e1322 > _e1319) {
                                                        phi_1935_ = _e1322;
                                                    } else {
                                                        phi_1935_ = _e1319;
                                                    }
                                                    let _e1325 = phi_1935_;
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
                                                            phi_1961_ = false;
                                                        } else {
                                                            phi_1961_ = true;
                                                        }
                                                        let _e1346 = phi_1961_;
                                                        phi_1962_ = _e1346;
                                                    } else {
                                                        phi_1962_ = true;
                                                    }
                                                    let _e1348 = phi_1962_;
                                                    if _e1348 {
                                                        if (_e1341 >= _e1342) {
                                                            phi_1970_ = 1u;
                                                        } else {
                                                            phi_1970_ = 2u;
                                                        }
                                                        let _e1351 = phi_1970_;
                                                        phi_1971_ = _e1351;
                                                    } else {
                                                        phi_1971_ = 0u;
                                                    }
                                                    let _e1353 = phi_1971_;
                                                    if (_e1353 == 0u) {
                                                        phi_1983_ = vec3<f32>(_e1128, _e1141, _e1115);
                                                    } else {
                                                        if (_e1353 == 1u) {
                                                            phi_1982_ = vec3<f32>(_e1141, _e1115, _e1128);
                                                        } else {
                                                            phi_1982_ = vec3<f32>(_e1115, _e1128, _e1141);
                                                        }
                                                        let _e1359 = phi_1982_;
                                                        phi_1983_ = _e1359;
                                                    }
                                                    let _e1361 = phi_1983_;
                                                    let _e1364 = (_e1361.x / _e1361.z);
                                                    let _e1367 = (_e1361.y / _e1361.z);
                                                    if (_e1278 < 0f) {
                                                        phi_1996_ = 0u;
                                                    } else {
                                                        phi_1996_ = 1u;
                                                    }
                                                    let _e1372 = phi_1996_;
                                                    if (_e1288 < 0f) {
                                                        phi_2001_ = 0u;
                                                    } else {
                                                        phi_2001_ = 2u;
                                                    }
                                                    let _e1375 = phi_2001_;
                                                    if (_e1298 < 0f) {
                                                        phi_2006_ = 0u;
                                                    } else {
                                                        phi_2006_ = 4u;
                                                    }
                                                    let _e1378 = phi_2006_;
                                                    let _e1380 = ((_e1372 | _e1375) | _e1378);
                                                    let _e1381 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1146, 2147483648u);
                                                    local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e1381.first[0], _e1381.first[1], _e1381.first[2], _e1381.first[3], _e1381.first[4], _e1381.first[5], _e1381.first[6], _e1381.first[7], _e1381.first[8], _e1381.first[9], _e1381.first[10], _e1381.first[11], _e1381.first[12], _e1381.first[13], _e1381.first[14], _e1381.first[15], _e1381.first[16], _e1381.first[17], _e1381.first[18], _e1381.first[19], _e1381.first[20], _e1381.first[21], _e1381.first[22], _e1381.first[23], _e1381.first[24], _e1381.first[25], _e1381.first[26], _e1381.first[27], _e1381.first[28], _e1381.first[29], _e1381.first[30], _e1381.first[31]), array<u32, 32>(_e1381.mask[0], _e1381.mask[1], _e1381.mask[2], _e1381.mask[3], _e1381.mask[4], _e1381.mask[5], _e1381.mask[6], _e1381.mask[7], _e1381.mask[8], _e1381.mask[9], _e1381.mask[10], _e1381.mask[11], _e1381.mask[12], _e1381.mask[13], _e1381.mask[14], _e1381.mask[15], _e1381.mask[16], _e1381.mask[17], _e1381.mask[18], _e1381.mask[19], _e1381.mask[20], _e1381.mask[21], _e1381.mask[22], _e1381.mask[23], _e1381.mask[24], _e1381.mask[25], _e1381.mask[26], _e1381.mask[27], _e1381.mask[28], _e1381.mask[29], _e1381.mask[30], _e1381.mask[31]), _e1381.len, _e1381.group, _e1381.group_mask);
                                                    let _e1455 = local_2.group_mask;
                                                    if ((_e1455 & 4278190080u) == 0u) {
                                                        let _e1459 = local_2.len;
                                                        if (_e1459 == 0u) {
                                                            phi_2120_ = false;
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
                                                            phi_2120_ = true;
                                                        }
                                                        let _e1482 = phi_2120_;
                                                        phi_2121_ = _e1482;
                                                    } else {
                                                        phi_2121_ = true;
                                                    }
                                                    let _e1484 = phi_2121_;
                                                    if _e1484 {
                                                        let _e1486 = local_2.group_mask;
                                                        let _e1492 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1486)), 32u, (_e1486 == 0u)));
                                                        let _e1496 = local_2.group_mask;
                                                        let _e1510 = local_2.group_mask;
                                                        local_2.group_mask = (_e1510 & ~((1u << bitcast<u32>((_e1492 & 31u)))));
                                                        let _e1513 = local_2.group;
                                                        phi_2152_ = (_e1513 + countOneBits(((_e1496 & ~((4294967295u << bitcast<u32>((((_e1492 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_2152_ = 4294967295u;
                                                    }
                                                    let _e1516 = phi_2152_;
                                                    phi_2154_ = _e979;
                                                    phi_2157_ = _e1516;
                                                    loop {
                                                        let _e1518 = phi_2154_;
                                                        let _e1520 = phi_2157_;
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
                                                                phi_2238_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1604.unnamed, lt_mask_LightPlace(_e1604.unnamed_1.word, _e1581.y));
                                                            } else {
                                                                let _e1620 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1581.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1626 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1620.unnamed.word, _e1581.y), _e1620.unnamed_1);
                                                                let _e1632 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1626.unnamed, lt_mask_LightPlace(_e1581.z, _e1626.unnamed_1.shift));
                                                                phi_2238_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1632.unnamed, lt_mask_LightPlace(_e1632.unnamed_1.word, _e1581.w));
                                                            }
                                                            let _e1640 = phi_2238_;
                                                            let _e1650 = nodes.member[(0u + _e1520)].y;
                                                            if (_e1288 < 0f) {
                                                                let _e1661 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1650.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1667 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1661.unnamed.word, _e1650.w), _e1661.unnamed_1);
                                                                let _e1673 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1667.unnamed, lt_mask_LightPlace(_e1650.x, _e1667.unnamed_1.shift));
                                                                phi_2265_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1673.unnamed, lt_mask_LightPlace(_e1673.unnamed_1.word, _e1650.y));
                                                            } else {
                                                                let _e1689 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1650.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1695 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1689.unnamed.word, _e1650.y), _e1689.unnamed_1);
                                                                let _e1701 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1695.unnamed, lt_mask_LightPlace(_e1650.z, _e1695.unnamed_1.shift));
                                                                phi_2265_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1701.unnamed, lt_mask_LightPlace(_e1701.unnamed_1.word, _e1650.w));
                                                            }
                                                            let _e1709 = phi_2265_;
                                                            let _e1719 = nodes.member[(0u + _e1520)].z;
                                                            if (_e1298 < 0f) {
                                                                let _e1730 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1719.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1736 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1730.unnamed.word, _e1719.w), _e1730.unnamed_1);
                                                                let _e1742 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1736.unnamed, lt_mask_LightPlace(_e1719.x, _e1736.unnamed_1.shift));
                                                                phi_2292_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1742.unnamed, lt_mask_LightPlace(_e1742.unnamed_1.word, _e1719.y));
                                                            } else {
                                                                let _e1758 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1719.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1764 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1758.unnamed.word, _e1719.y), _e1758.unnamed_1);
                                                                let _e1770 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1764.unnamed, lt_mask_LightPlace(_e1719.z, _e1764.unnamed_1.shift));
                                                                phi_2292_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1770.unnamed, lt_mask_LightPlace(_e1770.unnamed_1.word, _e1719.w));
                                                            }
                                                            let _e1778 = phi_2292_;
                                                            phi_2298_ = 0u;
                                                            phi_2301_ = 0u;
                                                            loop {
                                                                let _e1788 = phi_2298_;
                                                                let _e1790 = phi_2301_;
                                                                local_7 = _e1790;
                                                                local_8 = _e1790;
                                                                local_9 = _e1790;
                                                                let _e1791 = (_e1788 < 8u);
                                                                if _e1791 {
                                                                    let _e1793 = (_e1788 >> bitcast<u32>(2i));
                                                                    let _e1794 = (_e1788 & 3u);
                                                                    if (_e1793 == 0u) {
                                                                        phi_2315_ = _e1640.unnamed.word;
                                                                    } else {
                                                                        phi_2315_ = _e1640.unnamed.shift;
                                                                    }
                                                                    let _e1797 = phi_2315_;
                                                                    if (_e1793 == 0u) {
                                                                        phi_2325_ = _e1709.unnamed.word;
                                                                    } else {
                                                                        phi_2325_ = _e1709.unnamed.shift;
                                                                    }
                                                                    let _e1806 = phi_2325_;
                                                                    if (_e1793 == 0u) {
                                                                        phi_2335_ = _e1778.unnamed.word;
                                                                    } else {
                                                                        phi_2335_ = _e1778.unnamed.shift;
                                                                    }
                                                                    let _e1815 = phi_2335_;
                                                                    let _e1828 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1797 >> bitcast<u32>(((_e1794 * 8u) & 31u))) & 255u)) * _e1553) + (_e1571 - _e1330)), ((f32(((_e1806 >> bitcast<u32>(((_e1794 * 8u) & 31u))) & 255u)) * _e1554) + (_e1572 - _e1331)));
                                                                    let _e1829 = core_intrinsics_maximum_number_nsz_f32_(_e1828, ((f32(((_e1815 >> bitcast<u32>(((_e1794 * 8u) & 31u))) & 255u)) * _e1555) + (_e1573 - _e1332)));
                                                                    if (_e1793 == 0u) {
                                                                        phi_2353_ = _e1640.unnamed_1.word;
                                                                    } else {
                                                                        phi_2353_ = _e1640.unnamed_1.shift;
                                                                    }
                                                                    let _e1832 = phi_2353_;
                                                                    if (_e1793 == 0u) {
                                                                        phi_2363_ = _e1709.unnamed_1.word;
                                                                    } else {
                                                                        phi_2363_ = _e1709.unnamed_1.shift;
                                                                    }
                                                                    let _e1841 = phi_2363_;
                                                                    if (_e1793 == 0u) {
                                                                        phi_2373_ = _e1778.unnamed_1.word;
                                                                    } else {
                                                                        phi_2373_ = _e1778.unnamed_1.shift;
                                                                    }
                                                                    let _e1850 = phi_2373_;
                                                                    let _e1863 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1832 >> bitcast<u32>(((_e1794 * 8u) & 31u))) & 255u)) * _e1553) + (_e1571 + _e1330)), ((f32(((_e1841 >> bitcast<u32>(((_e1794 * 8u) & 31u))) & 255u)) * _e1554) + (_e1572 + _e1331)));
                                                                    let _e1864 = core_intrinsics_minimum_number_nsz_f32_(_e1863, ((f32(((_e1850 >> bitcast<u32>(((_e1794 * 8u) & 31u))) & 255u)) * _e1555) + (_e1573 + _e1332)));
                                                                    if (_e1829 <= _e1864) {
                                                                        if (_e1829 <= _e1518.t) {
                                                                            if (_e1864 >= _e170.tmin) {
                                                                                if (_e1793 == 0u) {
                                                                                    let _e1871 = nodes.member[(0u + _e1520)].links[2u];
                                                                                    phi_2409_ = _e1871;
                                                                                } else {
                                                                                    let _e1874 = nodes.member[(0u + _e1520)].links[3u];
                                                                                    phi_2409_ = _e1874;
                                                                                }
                                                                                let _e1876 = phi_2409_;
                                                                                let _e1881 = ((_e1876 >> bitcast<u32>(((_e1794 * 8u) & 31u))) & 255u);
                                                                                let _e1882 = (_e1881 & 31u);
                                                                                if (_e1882 >= 24u) {
                                                                                    phi_2422_ = (24u + ((_e1882 - 24u) ^ _e1380));
                                                                                } else {
                                                                                    phi_2422_ = _e1882;
                                                                                }
                                                                                let _e1888 = phi_2422_;
                                                                                phi_2427_ = (_e1790 | ((_e1881 >> bitcast<u32>(5i)) << bitcast<u32>((_e1888 & 31u))));
                                                                            } else {
                                                                                phi_2427_ = _e1790;
                                                                            }
                                                                            let _e1896 = phi_2427_;
                                                                            phi_2428_ = _e1896;
                                                                        } else {
                                                                            phi_2428_ = _e1790;
                                                                        }
                                                                        let _e1898 = phi_2428_;
                                                                        phi_2429_ = _e1898;
                                                                    } else {
                                                                        phi_2429_ = _e1790;
                                                                    }
                                                                    let _e1900 = phi_2429_;
                                                                    phi_2299_ = (_e1788 + 1u);
                                                                    phi_2302_ = _e1900;
                                                                } else {
                                                                    phi_2299_ = u32();
                                                                    phi_2302_ = u32();
                                                                }
                                                                let _e1903 = phi_2299_;
                                                                let _e1905 = phi_2302_;
                                                                continue;
                                                                continuing {
                                                                    phi_2298_ = _e1903;
                                                                    phi_2301_ = _e1905;
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
                                                            phi_2487_ = _e1518;
                                                            phi_2490_ = (_e1954 & 16777215u);
                                                            loop {
                                                                let _e1957 = phi_2487_;
                                                                let _e1959 = phi_2490_;
                                                                local_10 = _e1957;
                                                                if (_e1959 == 0u) {
                                                                    phi_2488_ = lt_bvh_Hit();
                                                                    phi_2491_ = u32();
                                                                    phi_3329_ = false;
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
                                                                        phi_2535_ = vec3<f32>(_e1979, _e1981, _e1977);
                                                                    } else {
                                                                        if (_e1353 == 1u) {
                                                                            phi_2534_ = vec3<f32>(_e1981, _e1977, _e1979);
                                                                        } else {
                                                                            phi_2534_ = (_e1975 - vec3<f32>(_e1071, _e1084, _e1097));
                                                                        }
                                                                        let _e1989 = phi_2534_;
                                                                        phi_2535_ = _e1989;
                                                                    }
                                                                    let _e1991 = phi_2535_;
                                                                    let _e1995 = (_e1991.x - (_e1364 * _e1991.z));
                                                                    let _e1999 = (_e1991.y - (_e1367 * _e1991.z));
                                                                    let _e2001 = triangles.member[(0u + _e1968)].v1_;
                                                                    let _e2003 = (_e2001.x - _e1071);
                                                                    let _e2005 = (_e2001.y - _e1084);
                                                                    let _e2007 = (_e2001.z - _e1097);
                                                                    if (_e1353 == 0u) {
                                                                        phi_2565_ = vec3<f32>(_e2005, _e2007, _e2003);
                                                                    } else {
                                                                        if (_e1353 == 1u) {
                                                                            phi_2564_ = vec3<f32>(_e2007, _e2003, _e2005);
                                                                        } else {
                                                                            phi_2564_ = (_e2001 - vec3<f32>(_e1071, _e1084, _e1097));
                                                                        }
                                                                        let _e2015 = phi_2564_;
                                                                        phi_2565_ = _e2015;
                                                                    }
                                                                    let _e2017 = phi_2565_;
                                                                    let _e2021 = (_e2017.x - (_e1364 * _e2017.z));
                                                                    let _e2025 = (_e2017.y - (_e1367 * _e2017.z));
                                                                    let _e2027 = triangles.member[(0u + _e1968)].v2_;
                                                                    let _e2029 = (_e2027.x - _e1071);
                                                                    let _e2031 = (_e2027.y - _e1084);
                                                                    let _e2033 = (_e2027.z - _e1097);
                                                                    if (_e1353 == 0u) {
                                                                        phi_2595_ = vec3<f32>(_e2031, _e2033, _e2029);
                                                                    } else {
                                                                        if (_e1353 == 1u) {
                                                                            phi_2594_ = vec3<f32>(_e2033, _e2029, _e2031);
                                                                        } else {
                                                                            phi_2594_ = (_e2027 - vec3<f32>(_e1071, _e1084, _e1097));
                                                                        }
                                                                        let _e2041 = phi_2594_;
                                                                        phi_2595_ = _e2041;
                                                                    }
                                                                    let _e2043 = phi_2595_;
                                                                    let _e2047 = (_e2043.x - (_e1364 * _e2043.z));
                                                                    let _e2051 = (_e2043.y - (_e1367 * _e2043.z));
                                                                    if (_e2021 < _e2047) {
                                                                        phi_2614_ = true;
                                                                    } else {
                                                                        if (_e2021 == _e2047) {
                                                                            phi_2613_ = (_e2025 < _e2051);
                                                                        } else {
                                                                            phi_2613_ = false;
                                                                        }
                                                                        let _e2056 = phi_2613_;
                                                                        phi_2614_ = _e2056;
                                                                    }
                                                                    let _e2058 = phi_2614_;
                                                                    if _e2058 {
                                                                        phi_2618_ = _e2051;
                                                                        phi_2619_ = _e2047;
                                                                        phi_2620_ = _e2025;
                                                                        phi_2621_ = _e2021;
                                                                    } else {
                                                                        phi_2618_ = _e2025;
                                                                        phi_2619_ = _e2021;
                                                                        phi_2620_ = _e2051;
                                                                        phi_2621_ = _e2047;
                                                                    }
                                                                    let _e2060 = phi_2618_;
                                                                    let _e2062 = phi_2619_;
                                                                    let _e2064 = phi_2620_;
                                                                    let _e2066 = phi_2621_;
                                                                    let _e2069 = ((_e2066 * _e2060) - (_e2064 * _e2062));
                                                                    if _e2058 {
                                                                        phi_2629_ = -(_e2069);
                                                                    } else {
                                                                        phi_2629_ = _e2069;
                                                                    }
                                                                    let _e2072 = phi_2629_;
                                                                    if (_e2047 < _e1995) {
                                                                        phi_2640_ = true;
                                                                    } else {
                                                                        if (_e2047 == _e1995) {
                                                                            phi_2639_ = (_e2051 < _e1999);
                                                                        } else {
                                                                            phi_2639_ = false;
                                                                        }
                                                                        let _e2077 = phi_2639_;
                                                                        phi_2640_ = _e2077;
                                                                    }
                                                                    let _e2079 = phi_2640_;
                                                                    if _e2079 {
                                                                        phi_2644_ = _e1999;
                                                                        phi_2645_ = _e1995;
                                                                        phi_2646_ = _e2051;
                                                                        phi_2647_ = _e2047;
                                                                    } else {
                                                                        phi_2644_ = _e2051;
                                                                        phi_2645_ = _e2047;
                                                                        phi_2646_ = _e1999;
                                                                        phi_2647_ = _e1995;
                                                                    }
                                                                    let _e2081 = phi_2644_;
                                                                    let _e2083 = phi_2645_;
                                                                    let _e2085 = phi_2646_;
                                                                    let _e2087 = phi_2647_;
                                                                    let _e2090 = ((_e2087 * _e2081) - (_e2085 * _e2083));
                                                                    if _e2079 {
                                                                        phi_2655_ = -(_e2090);
                                                                    } else {
                                                                        phi_2655_ = _e2090;
                                                                    }
                                                                    let _e2093 = phi_2655_;
                                                                    if (_e1995 < _e2021) {
                                                                        phi_2666_ = true;
                                                                    } else {
                                                                        if (_e1995 == _e2021) {
                                                                            phi_2665_ = (_e1999 < _e2025);
                                                                        } else {
                                                                            phi_2665_ = false;
                                                                        }
                                                                        let _e2098 = phi_2665_;
                                                                        phi_2666_ = _e2098;
                                                                    }
                                                                    let _e2100 = phi_2666_;
                                                                    if _e2100 {
                                                                        phi_2670_ = _e2025;
                                                                        phi_2671_ = _e2021;
                                                                        phi_2672_ = _e1999;
                                                                        phi_2673_ = _e1995;
                                                                    } else {
                                                                        phi_2670_ = _e1999;
                                                                        phi_2671_ = _e1995;
                                                                        phi_2672_ = _e2025;
                                                                        phi_2673_ = _e2021;
                                                                    }
                                                                    let _e2102 = phi_2670_;
                                                                    let _e2104 = phi_2671_;
                                                                    let _e2106 = phi_2672_;
                                                                    let _e2108 = phi_2673_;
                                                                    let _e2111 = ((_e2108 * _e2102) - (_e2106 * _e2104));
                                                                    if _e2100 {
                                                                        phi_2681_ = -(_e2111);
                                                                    } else {
                                                                        phi_2681_ = _e2111;
                                                                    }
                                                                    let _e2114 = phi_2681_;
                                                                    if (_e2072 >= 0f) {
                                                                        if (_e2093 >= 0f) {
                                                                            if (_e2114 >= 0f) {
                                                                                phi_2696_ = ((_e2072 + _e2093) + _e2114);
                                                                                phi_2697_ = false;
                                                                            } else {
                                                                                phi_2696_ = f32();
                                                                                phi_2697_ = true;
                                                                            }
                                                                            let _e2121 = phi_2696_;
                                                                            let _e2123 = phi_2697_;
                                                                            phi_2698_ = _e2121;
                                                                            phi_2699_ = _e2123;
                                                                        } else {
                                                                            phi_2698_ = f32();
                                                                            phi_2699_ = true;
                                                                        }
                                                                        let _e2125 = phi_2698_;
                                                                        let _e2127 = phi_2699_;
                                                                        phi_2700_ = _e2125;
                                                                        phi_2701_ = _e2127;
                                                                    } else {
                                                                        phi_2700_ = f32();
                                                                        phi_2701_ = true;
                                                                    }
                                                                    let _e2129 = phi_2700_;
                                                                    let _e2131 = phi_2701_;
                                                                    if _e2131 {
                                                                        if (_e2072 <= 0f) {
                                                                            if (_e2093 <= 0f) {
                                                                                let _e2134 = (_e2114 <= 0f);
                                                                                if _e2134 {
                                                                                }
                                                                                phi_2719_ = ((_e2072 + _e2093) + _e2114);
                                                                                phi_2720_ = false;
                                                                                phi_2721_ = _e2134;
                                                                            } else {
                                                                                phi_2719_ = f32();
                                                                                phi_2720_ = true;
                                                                                phi_2721_ = false;
                                                                            }
                                                                            let _e2138 = phi_2719_;
                                                                            let _e2140 = phi_2720_;
                                                                            let _e2142 = phi_2721_;
                                                                            phi_2722_ = _e2138;
                                                                            phi_2723_ = _e2140;
                                                                            phi_2724_ = _e2142;
                                                                        } else {
                                                                            phi_2722_ = f32();
                                                                            phi_2723_ = true;
                                                                            phi_2724_ = false;
                                                                        }
                                                                        let _e2144 = phi_2722_;
                                                                        let _e2146 = phi_2723_;
                                                                        let _e2148 = phi_2724_;
                                                                        if _e2146 {
                                                                            phi_2728_ = false;
                                                                        } else {
                                                                            phi_2728_ = _e2148;
                                                                        }
                                                                        let _e2150 = phi_2728_;
                                                                        phi_2729_ = _e2144;
                                                                        phi_2730_ = _e2150;
                                                                    } else {
                                                                        phi_2729_ = _e2129;
                                                                        phi_2730_ = true;
                                                                    }
                                                                    let _e2152 = phi_2729_;
                                                                    let _e2154 = phi_2730_;
                                                                    if _e2154 {
                                                                        let _e2155 = (_e2152 == 0f);
                                                                        if _e2155 {
                                                                            phi_3046_ = lt_bvh_triangle_Intersection();
                                                                            phi_3047_ = false;
                                                                        } else {
                                                                            let _e2157 = triangles.member[(0u + _e1968)].v0_;
                                                                            let _e2159 = (_e2157.x - _e1071);
                                                                            let _e2161 = (_e2157.y - _e1084);
                                                                            let _e2163 = (_e2157.z - _e1097);
                                                                            if (_e1353 == 0u) {
                                                                                phi_2759_ = vec3<f32>(_e2161, _e2163, _e2159);
                                                                            } else {
                                                                                if (_e1353 == 1u) {
                                                                                    phi_2758_ = vec3<f32>(_e2163, _e2159, _e2161);
                                                                                } else {
                                                                                    phi_2758_ = (_e2157 - vec3<f32>(_e1071, _e1084, _e1097));
                                                                                }
                                                                                let _e2171 = phi_2758_;
                                                                                phi_2759_ = _e2171;
                                                                            }
                                                                            let _e2173 = phi_2759_;
                                                                            let _e2175 = triangles.member[(0u + _e1968)].v1_;
                                                                            let _e2177 = triangles.member[(0u + _e1968)].v0_;
                                                                            let _e2180 = (_e2175.x - _e2177.x);
                                                                            let _e2183 = (_e2175.y - _e2177.y);
                                                                            let _e2186 = (_e2175.z - _e2177.z);
                                                                            if (_e1353 == 0u) {
                                                                                phi_2785_ = vec3<f32>(_e2183, _e2186, _e2180);
                                                                            } else {
                                                                                if (_e1353 == 1u) {
                                                                                    phi_2784_ = vec3<f32>(_e2186, _e2180, _e2183);
                                                                                } else {
                                                                                    phi_2784_ = (_e2175 - _e2177);
                                                                                }
                                                                                let _e2193 = phi_2784_;
                                                                                phi_2785_ = _e2193;
                                                                            }
                                                                            let _e2195 = phi_2785_;
                                                                            let _e2197 = triangles.member[(0u + _e1968)].v2_;
                                                                            let _e2199 = triangles.member[(0u + _e1968)].v0_;
                                                                            let _e2202 = (_e2197.x - _e2199.x);
                                                                            let _e2205 = (_e2197.y - _e2199.y);
                                                                            let _e2208 = (_e2197.z - _e2199.z);
                                                                            if (_e1353 == 0u) {
                                                                                phi_2811_ = vec3<f32>(_e2205, _e2208, _e2202);
                                                                            } else {
                                                                                if (_e1353 == 1u) {
                                                                                    phi_2810_ = vec3<f32>(_e2208, _e2202, _e2205);
                                                                                } else {
                                                                                    phi_2810_ = (_e2197 - _e2199);
                                                                                }
                                                                                let _e2215 = phi_2810_;
                                                                                phi_2811_ = _e2215;
                                                                            }
                                                                            let _e2217 = phi_2811_;
                                                                            let _e2224 = ((_e2195.y * _e2217.z) - (_e2195.z * _e2217.y));
                                                                            let _e2231 = ((_e2195.z * _e2217.x) - (_e2195.x * _e2217.z));
                                                                            let _e2238 = ((_e2195.x * _e2217.y) - (_e2195.y * _e2217.x));
                                                                            let _e2252 = (((1f / _e1361.z) * (((_e2224 * _e2173.x) + (_e2231 * _e2173.y)) + (_e2238 * _e2173.z))) / (((_e2224 * _e1364) + (_e2231 * _e1367)) + _e2238));
                                                                            if (_e2252 > _e170.tmin) {
                                                                                if (_e2252 < _e170.tmax) {
                                                                                    let _e2256 = triangles.member[(0u + _e1968)].v0_;
                                                                                    let _e2258 = triangles.member[(0u + _e1968)].v1_;
                                                                                    if (_e2256.x < _e2258.x) {
                                                                                        phi_2867_ = _e2256.x;
                                                                                    } else {
                                                                                        phi_2867_ = _e2258.x;
                                                                                    }
                                                                                    let _e2265 = phi_2867_;
                                                                                    if (_e2256.y < _e2258.y) {
                                                                                        phi_2876_ = _e2256.y;
                                                                                    } else {
                                                                                        phi_2876_ = _e2258.y;
                                                                                    }
                                                                                    let _e2272 = phi_2876_;
                                                                                    if (_e2256.z < _e2258.z) {
                                                                                        phi_2885_ = _e2256.z;
                                                                                    } else {
                                                                                        phi_2885_ = _e2258.z;
                                                                                    }
                                                                                    let _e2279 = phi_2885_;
                                                                                    let _e2281 = triangles.member[(0u + _e1968)].v2_;
                                                                                    if (_e2265 < _e2281.x) {
                                                                                        phi_2894_ = _e2265;
                                                                                    } else {
                                                                                        phi_2894_ = _e2281.x;
                                                                                    }
                                                                                    let _e2286 = phi_2894_;
                                                                                    if (_e2272 < _e2281.y) {
                                                                                        phi_2901_ = _e2272;
                                                                                    } else {
                                                                                        phi_2901_ = _e2281.y;
                                                                                    }
                                                                                    let _e2291 = phi_2901_;
                                                                                    if (_e2279 < _e2281.z) {
                                                                                        phi_2908_ = _e2279;
                                                                                    } else {
                                                                                        phi_2908_ = _e2281.z;
                                                                                    }
                                                                                    let _e2296 = phi_2908_;
                                                                                    let _e2298 = triangles.member[(0u + _e1968)].v0_;
                                                                                    let _e2300 = triangles.member[(0u + _e1968)].v1_;
                                                                                    if (_e2298.x > _e2300.x) {
                                                                                        phi_2921_ = _e2298.x;
                                                                                    } else {
                                                                                        phi_2921_ = _e2300.x;
                                                                                    }
                                                                                    let _e2307 = phi_2921_;
                                                                                    if (_e2298.y > _e2300.y) {
                                                                                        phi_2930_ = _e2298.y;
                                                                                    } else {
                                                                                        phi_2930_ = _e2300.y;
                                                                                    }
                                                                                    let _e2314 = phi_2930_;
                                                                                    if (_e2298.z > _e2300.z) {
                                                                                        phi_2939_ = _e2298.z;
                                                                                    } else {
                                                                                        phi_2939_ = _e2300.z;
                                                                                    }
                                                                                    let _e2321 = phi_2939_;
                                                                                    let _e2323 = triangles.member[(0u + _e1968)].v2_;
                                                                                    if (_e2307 > _e2323.x) {
                                                                                        phi_2948_ = _e2307;
                                                                                    } else {
                                                                                        phi_2948_ = _e2323.x;
                                                                                    }
                                                                                    let _e2328 = phi_2948_;
                                                                                    if (_e2314 > _e2323.y) {
                                                                                        phi_2955_ = _e2314;
                                                                                    } else {
                                                                                        phi_2955_ = _e2323.y;
                                                                                    }
                                                                                    let _e2333 = phi_2955_;
                                                                                    if (_e2321 > _e2323.z) {
                                                                                        phi_2962_ = _e2321;
                                                                                    } else {
                                                                                        phi_2962_ = _e2323.z;
                                                                                    }
                                                                                    let _e2338 = phi_2962_;
                                                                                    let _e2342 = ((_e2286 - _e1071) * _e1278);
                                                                                    let _e2343 = ((_e2291 - _e1084) * _e1288);
                                                                                    let _e2344 = ((_e2296 - _e1097) * _e1298);
                                                                                    let _e2348 = ((_e2328 - _e1071) * _e1278);
                                                                                    let _e2349 = ((_e2333 - _e1084) * _e1288);
                                                                                    let _e2350 = ((_e2338 - _e1097) * _e1298);
                                                                                    if (_e2342 < _e2348) {
                                                                                        phi_2979_ = _e2342;
                                                                                    } else {
                                                                                        phi_2979_ = _e2348;
                                                                                    }
                                                                                    let _e2353 = phi_2979_;
                                                                                    if (_e2343 < _e2349) {
                                                                                        phi_2984_ = _e2343;
                                                                                    } else {
                                                                                        phi_2984_ = _e2349;
                                                                                    }
                                                                                    let _e2356 = phi_2984_;
                                                                                    if (_e2344 < _e2350) {
                                                                                        phi_2989_ = _e2344;
                                                                                    } else {
                                                                                        phi_2989_ = _e2350;
                                                                                    }
                                                                                    let _e2359 = phi_2989_;
                                                                                    if (_e2342 > _e2348) {
                                                                                        phi_2997_ = _e2342;
                                                                                    } else {
                                                                                        phi_2997_ = _e2348;
                                                                                    }
                                                                                    let _e2365 = phi_2997_;
                                                                                    if (_e2343 > _e2349) {
                                                                                        phi_3002_ = _e2343;
                                                                                    } else {
                                                                                        phi_3002_ = _e2349;
                                                                                    }
                                                                                    let _e2368 = phi_3002_;
                                                                                    if (_e2344 > _e2350) {
                                                                                        phi_3007_ = _e2344;
                                                                                    } else {
                                                                                        phi_3007_ = _e2350;
                                                                                    }
                                                                                    let _e2371 = phi_3007_;
                                                                                    let _e2375 = core_intrinsics_maximum_number_nsz_f32_((_e2353 - _e1337), (_e2356 - _e1338));
                                                                                    let _e2376 = core_intrinsics_maximum_number_nsz_f32_(_e2375, (_e2359 - _e1339));
                                                                                    let _e2377 = core_intrinsics_minimum_number_nsz_f32_((_e2365 + _e1337), (_e2368 + _e1338));
                                                                                    let _e2378 = core_intrinsics_minimum_number_nsz_f32_(_e2377, (_e2371 + _e1339));
                                                                                    if (_e2376 > _e1046) {
                                                                                        phi_3019_ = _e2376;
                                                                                    } else {
                                                                                        phi_3019_ = _e1046;
                                                                                    }
                                                                                    let _e2381 = phi_3019_;
                                                                                    if (_e2378 < _e1048) {
                                                                                        phi_3024_ = _e2378;
                                                                                    } else {
                                                                                        phi_3024_ = _e1048;
                                                                                    }
                                                                                    let _e2384 = phi_3024_;
                                                                                    if (_e2252 < _e2381) {
                                                                                        phi_3029_ = _e2381;
                                                                                    } else {
                                                                                        phi_3029_ = _e2252;
                                                                                    }
                                                                                    let _e2387 = phi_3029_;
                                                                                    if (_e2387 > _e2384) {
                                                                                        phi_3034_ = _e2384;
                                                                                    } else {
                                                                                        phi_3034_ = _e2387;
                                                                                    }
                                                                                    let _e2390 = phi_3034_;
                                                                                    phi_3039_ = lt_bvh_triangle_Intersection(_e2390, (_e2093 / _e2152), (_e2114 / _e2152), (_e2381 <= _e2384));
                                                                                    phi_3040_ = false;
                                                                                } else {
                                                                                    phi_3039_ = lt_bvh_triangle_Intersection();
                                                                                    phi_3040_ = true;
                                                                                }
                                                                                let _e2396 = phi_3039_;
                                                                                let _e2398 = phi_3040_;
                                                                                phi_3041_ = _e2396;
                                                                                phi_3042_ = _e2398;
                                                                            } else {
                                                                                phi_3041_ = lt_bvh_triangle_Intersection();
                                                                                phi_3042_ = true;
                                                                            }
                                                                            let _e2400 = phi_3041_;
                                                                            let _e2402 = phi_3042_;
                                                                            if _e2402 {
                                                                            }
                                                                            phi_3046_ = _e2400;
                                                                            phi_3047_ = _e2402;
                                                                        }
                                                                        let _e2404 = phi_3046_;
                                                                        let _e2406 = phi_3047_;
                                                                        phi_3048_ = _e2404;
                                                                        phi_3049_ = _e2155;
                                                                        phi_3050_ = _e2406;
                                                                    } else {
                                                                        phi_3048_ = lt_bvh_triangle_Intersection();
                                                                        phi_3049_ = true;
                                                                        phi_3050_ = false;
                                                                    }
                                                                    let _e2408 = phi_3048_;
                                                                    let _e2410 = phi_3049_;
                                                                    let _e2412 = phi_3050_;
                                                                    if _e2410 {
                                                                        phi_3054_ = true;
                                                                    } else {
                                                                        phi_3054_ = _e2412;
                                                                    }
                                                                    let _e2414 = phi_3054_;
                                                                    if _e2414 {
                                                                        phi_3058_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_3058_ = _e2408;
                                                                    }
                                                                    let _e2416 = phi_3058_;
                                                                    if _e2416.is_hit {
                                                                        if (_e2416.t > _e170.tmin) {
                                                                            if (_e2416.t < _e1957.t) {
                                                                                phi_3106_ = true;
                                                                            } else {
                                                                                if (_e2416.t == _e1957.t) {
                                                                                    if (_e1957.triangle != 4294967295u) {
                                                                                        if (_e1968 < _e1957.triangle) {
                                                                                            phi_3097_ = true;
                                                                                        } else {
                                                                                            if (_e1968 == _e1957.triangle) {
                                                                                                phi_3096_ = (_e987 < _e1957.instance);
                                                                                            } else {
                                                                                                phi_3096_ = false;
                                                                                            }
                                                                                            let _e2434 = phi_3096_;
                                                                                            phi_3097_ = _e2434;
                                                                                        }
                                                                                        let _e2436 = phi_3097_;
                                                                                        phi_3098_ = _e2436;
                                                                                        phi_3099_ = false;
                                                                                    } else {
                                                                                        phi_3098_ = bool();
                                                                                        phi_3099_ = true;
                                                                                    }
                                                                                    let _e2438 = phi_3098_;
                                                                                    let _e2440 = phi_3099_;
                                                                                    phi_3100_ = _e2438;
                                                                                    phi_3101_ = _e2440;
                                                                                } else {
                                                                                    phi_3100_ = bool();
                                                                                    phi_3101_ = true;
                                                                                }
                                                                                let _e2442 = phi_3100_;
                                                                                let _e2444 = phi_3101_;
                                                                                if _e2444 {
                                                                                    phi_3105_ = false;
                                                                                } else {
                                                                                    phi_3105_ = _e2442;
                                                                                }
                                                                                let _e2446 = phi_3105_;
                                                                                phi_3106_ = _e2446;
                                                                            }
                                                                            let _e2448 = phi_3106_;
                                                                            if _e2448 {
                                                                                let _e2450 = triangles.member[(0u + _e1968)].i0_;
                                                                                if ((_e2450 & 2147483648u) == 0u) {
                                                                                    phi_3317_ = true;
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
                                                                                            phi_3312_ = true;
                                                                                        } else {
                                                                                            let _e2515 = (_e2483.base_color.w * ((((f32((_e2477[0].color >> bitcast<u32>(24i))) * _e2488) + (f32((_e2477[1].color >> bitcast<u32>(24i))) * _e2416.u)) + (f32((_e2477[2].color >> bitcast<u32>(24i))) * _e2416.v)) * (1f / 255f)));
                                                                                            if (_e2483.alpha_size == 0u) {
                                                                                                phi_3309_ = _e2515;
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
                                                                                                phi_3309_ = (_e2515 * (((((f32(((_e2554 >> bitcast<u32>((((_e2546.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2546.weights.x) + ((f32(((_e2574 >> bitcast<u32>((((_e2546.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2546.weights.y)) + ((f32(((_e2595 >> bitcast<u32>((((_e2546.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2546.weights.z)) + ((f32(((_e2616 >> bitcast<u32>((((_e2546.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2546.weights.w)));
                                                                                            }
                                                                                            let _e2632 = phi_3309_;
                                                                                            phi_3312_ = (_e2632 >= _e2483.cutoff);
                                                                                        }
                                                                                        let _e2636 = phi_3312_;
                                                                                        phi_3313_ = _e2636;
                                                                                    } else {
                                                                                        phi_3313_ = false;
                                                                                    }
                                                                                    let _e2638 = phi_3313_;
                                                                                    if _e2638 {
                                                                                    }
                                                                                    phi_3317_ = _e2638;
                                                                                }
                                                                                let _e2640 = phi_3317_;
                                                                                if _e2640 {
                                                                                    phi_3325_ = lt_bvh_Hit(_e2416.t, _e2416.u, _e2416.v, _e1968, _e987);
                                                                                } else {
                                                                                    phi_3325_ = _e1957;
                                                                                }
                                                                                let _e2646 = phi_3325_;
                                                                                phi_3326_ = _e2646;
                                                                            } else {
                                                                                phi_3326_ = _e1957;
                                                                            }
                                                                            let _e2648 = phi_3326_;
                                                                            phi_3327_ = _e2648;
                                                                        } else {
                                                                            phi_3327_ = _e1957;
                                                                        }
                                                                        let _e2650 = phi_3327_;
                                                                        phi_3328_ = _e2650;
                                                                    } else {
                                                                        phi_3328_ = _e1957;
                                                                    }
                                                                    let _e2652 = phi_3328_;
                                                                    phi_2488_ = _e2652;
                                                                    phi_2491_ = (_e1959 & (_e1959 - 1u));
                                                                    phi_3329_ = true;
                                                                }
                                                                let _e2654 = phi_2488_;
                                                                let _e2656 = phi_2491_;
                                                                let _e2658 = phi_3329_;
                                                                continue;
                                                                continuing {
                                                                    phi_2487_ = _e2654;
                                                                    phi_2490_ = _e2656;
                                                                    break if !(_e2658);
                                                                }
                                                            }
                                                            let _e2661 = local_2.group_mask;
                                                            if ((_e2661 & 4278190080u) == 0u) {
                                                                let _e2665 = local_2.len;
                                                                if (_e2665 == 0u) {
                                                                    phi_3368_ = false;
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
                                                                    phi_3368_ = true;
                                                                }
                                                                let _e2688 = phi_3368_;
                                                                phi_3369_ = _e2688;
                                                            } else {
                                                                phi_3369_ = true;
                                                            }
                                                            let _e2690 = phi_3369_;
                                                            if _e2690 {
                                                                let _e2692 = local_2.group_mask;
                                                                let _e2698 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2692)), 32u, (_e2692 == 0u)));
                                                                let _e2702 = local_2.group_mask;
                                                                let _e2716 = local_2.group_mask;
                                                                local_2.group_mask = (_e2716 & ~((1u << bitcast<u32>((_e2698 & 31u)))));
                                                                let _e2719 = local_2.group;
                                                                phi_3400_ = (_e2719 + countOneBits(((_e2702 & ~((4294967295u << bitcast<u32>((((_e2698 - 24u) ^ _e1380) & 31u))))) & 255u)));
                                                            } else {
                                                                phi_3400_ = 4294967295u;
                                                            }
                                                            let _e2722 = phi_3400_;
                                                            let _e4044 = local_10;
                                                            phi_2155_ = _e4044;
                                                            phi_2158_ = _e2722;
                                                        } else {
                                                            phi_2155_ = lt_bvh_Hit();
                                                            phi_2158_ = u32();
                                                        }
                                                        let _e2724 = phi_2155_;
                                                        let _e2726 = phi_2158_;
                                                        continue;
                                                        continuing {
                                                            phi_2154_ = _e2724;
                                                            phi_2157_ = _e2726;
                                                            break if !(_e1521);
                                                        }
                                                    }
                                                    let _e4048 = local_11;
                                                    phi_3401_ = _e4048;
                                                }
                                                let _e2729 = phi_3401_;
                                                phi_3402_ = _e2729;
                                                phi_3403_ = _e1202;
                                            } else {
                                                phi_3402_ = lt_bvh_Hit();
                                                phi_3403_ = true;
                                            }
                                            let _e2731 = phi_3402_;
                                            let _e2733 = phi_3403_;
                                            if _e2733 {
                                                phi_3407_ = _e979;
                                            } else {
                                                phi_3407_ = _e2731;
                                            }
                                            let _e2735 = phi_3407_;
                                            phi_3408_ = _e2735;
                                        } else {
                                            phi_3408_ = _e979;
                                        }
                                        let _e2737 = phi_3408_;
                                        phi_3409_ = _e2737;
                                    } else {
                                        phi_3409_ = _e979;
                                    }
                                    let _e2739 = phi_3409_;
                                    phi_3410_ = _e2739;
                                } else {
                                    phi_3410_ = _e979;
                                }
                                let _e2741 = phi_3410_;
                                phi_1522_ = (_e977 & (_e977 - 1u));
                                phi_1525_ = _e2741;
                                phi_3411_ = true;
                            }
                            let _e2743 = phi_1522_;
                            let _e2745 = phi_1525_;
                            let _e2747 = phi_3411_;
                            continue;
                            continuing {
                                phi_1521_ = _e2743;
                                phi_1524_ = _e2745;
                                break if !(_e2747);
                            }
                        }
                        let _e2750 = local_3.group_mask;
                        if ((_e2750 & 4278190080u) == 0u) {
                            let _e2754 = local_3.len;
                            if (_e2754 == 0u) {
                                phi_3450_ = false;
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
                                phi_3450_ = true;
                            }
                            let _e2777 = phi_3450_;
                            phi_3451_ = _e2777;
                        } else {
                            phi_3451_ = true;
                        }
                        let _e2779 = phi_3451_;
                        if _e2779 {
                            let _e2781 = local_3.group_mask;
                            let _e2787 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2781)), 32u, (_e2781 == 0u)));
                            let _e2791 = local_3.group_mask;
                            let _e2805 = local_3.group_mask;
                            local_3.group_mask = (_e2805 & ~((1u << bitcast<u32>((_e2787 & 31u)))));
                            let _e2808 = local_3.group;
                            phi_3482_ = (_e2808 + countOneBits(((_e2791 & ~((4294967295u << bitcast<u32>((((_e2787 - 24u) ^ _e396) & 31u))))) & 255u)));
                        } else {
                            phi_3482_ = 4294967295u;
                        }
                        let _e2811 = phi_3482_;
                        phi_1185_ = _e2811;
                        let _e4064 = local_12;
                        phi_1188_ = _e4064;
                    } else {
                        phi_1185_ = u32();
                        phi_1188_ = lt_bvh_Hit();
                    }
                    let _e2813 = phi_1185_;
                    let _e2815 = phi_1188_;
                    continue;
                    continuing {
                        phi_1184_ = _e2813;
                        phi_1187_ = _e2815;
                        break if !(_e537);
                    }
                }
                let _e4067 = local_13;
                phi_3483_ = _e4067;
            }
            let _e2818 = phi_3483_;
            phi_3484_ = _e2818;
            phi_3485_ = _e234;
        } else {
            phi_3484_ = lt_bvh_Hit();
            phi_3485_ = true;
        }
        let _e2820 = phi_3484_;
        let _e2822 = phi_3485_;
        if _e2822 {
            phi_3489_ = _e172;
        } else {
            phi_3489_ = _e2820;
        }
        let _e2824 = phi_3489_;
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
                phi_3676_ = _e2988;
            } else {
                phi_3676_ = _e2991;
            }
            let _e2996 = phi_3676_;
            if (_e2989 > _e2992) {
                phi_3681_ = _e2989;
            } else {
                phi_3681_ = _e2992;
            }
            let _e2999 = phi_3681_;
            if (_e2990 > _e2993) {
                phi_3686_ = _e2990;
            } else {
                phi_3686_ = _e2993;
            }
            let _e3002 = phi_3686_;
            let _e3003 = abs(_e2945);
            let _e3004 = abs(_e2958);
            let _e3005 = abs(_e2971);
            if (_e2996 > _e3003) {
                phi_3694_ = _e2996;
            } else {
                phi_3694_ = _e3003;
            }
            let _e3008 = phi_3694_;
            if (_e2999 > _e3004) {
                phi_3699_ = _e2999;
            } else {
                phi_3699_ = _e3004;
            }
            let _e3011 = phi_3699_;
            if (_e3002 > _e3005) {
                phi_3704_ = _e3002;
            } else {
                phi_3704_ = _e3005;
            }
            let _e3014 = phi_3704_;
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
                phi_3768_ = vec3<f32>(-(_e3061), -(_e3062), -(_e3063));
            } else {
                phi_3768_ = vec3<f32>(_e3061, _e3062, _e3063);
            }
            let _e3076 = phi_3768_;
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
                phi_4011_ = vec3<f32>(1f, 1f, 1f);
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
                phi_4011_ = vec3<f32>((_e3312 * _e3312), (_e3313 * _e3313), (_e3314 * _e3314));
            }
            let _e3320 = phi_4011_;
            let _e3322 = ((_e3104.base_color.x * ((((f32((_e3098[0].color & 255u)) * _e3121) * _e2830) + ((f32((_e3098[1].color & 255u)) * _e3140) * _e2824.u)) + ((f32((_e3098[2].color & 255u)) * _e3162) * _e2824.v))) * _e3320.x);
            let _e3324 = ((_e3104.base_color.y * ((((f32(((_e3098[0].color >> bitcast<u32>(8i)) & 255u)) * _e3121) * _e2830) + ((f32(((_e3098[1].color >> bitcast<u32>(8i)) & 255u)) * _e3140) * _e2824.u)) + ((f32(((_e3098[2].color >> bitcast<u32>(8i)) & 255u)) * _e3162) * _e2824.v))) * _e3320.y);
            let _e3326 = ((_e3104.base_color.z * ((((f32(((_e3098[0].color >> bitcast<u32>(16i)) & 255u)) * _e3121) * _e2830) + ((f32(((_e3098[1].color >> bitcast<u32>(16i)) & 255u)) * _e3140) * _e2824.u)) + ((f32(((_e3098[2].color >> bitcast<u32>(16i)) & 255u)) * _e3162) * _e2824.v))) * _e3320.z);
            let _e3327 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e3011, _e3014);
            let _e3328 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e3008, _e3327);
            if ((_e3104.flags & 2u) == 0u) {
                phi_4026_ = 0u;
            } else {
                phi_4026_ = 1u;
            }
            let _e3333 = phi_4026_;
            if (_e3098[0].normal == 2147516416u) {
                phi_4256_ = _e3076;
            } else {
                let _e3346 = (f32((bitcast<i32>((_e3098[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3352 = (f32((bitcast<i32>(_e3098[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3356 = ((1f - abs(_e3346)) - abs(_e3352));
                if (_e3356 < 0f) {
                    phi_4053_ = -(_e3356);
                } else {
                    phi_4053_ = 0f;
                }
                let _e3360 = phi_4053_;
                if (_e3346 < 0f) {
                    phi_4060_ = (_e3346 + _e3360);
                } else {
                    phi_4060_ = (_e3346 - _e3360);
                }
                let _e3365 = phi_4060_;
                if (_e3352 < 0f) {
                    phi_4067_ = (_e3352 + _e3360);
                } else {
                    phi_4067_ = (_e3352 - _e3360);
                }
                let _e3370 = phi_4067_;
                let _e3377 = (1f / sqrt((((_e3365 * _e3365) + (_e3370 * _e3370)) + (_e3356 * _e3356))));
                let _e3393 = (f32((bitcast<i32>((_e3098[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3399 = (f32((bitcast<i32>(_e3098[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3403 = ((1f - abs(_e3393)) - abs(_e3399));
                if (_e3403 < 0f) {
                    phi_4102_ = -(_e3403);
                } else {
                    phi_4102_ = 0f;
                }
                let _e3407 = phi_4102_;
                if (_e3393 < 0f) {
                    phi_4109_ = (_e3393 + _e3407);
                } else {
                    phi_4109_ = (_e3393 - _e3407);
                }
                let _e3412 = phi_4109_;
                if (_e3399 < 0f) {
                    phi_4116_ = (_e3399 + _e3407);
                } else {
                    phi_4116_ = (_e3399 - _e3407);
                }
                let _e3417 = phi_4116_;
                let _e3424 = (1f / sqrt((((_e3412 * _e3412) + (_e3417 * _e3417)) + (_e3403 * _e3403))));
                let _e3443 = (f32((bitcast<i32>((_e3098[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3449 = (f32((bitcast<i32>(_e3098[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3453 = ((1f - abs(_e3443)) - abs(_e3449));
                if (_e3453 < 0f) {
                    phi_4154_ = -(_e3453);
                } else {
                    phi_4154_ = 0f;
                }
                let _e3457 = phi_4154_;
                if (_e3443 < 0f) {
                    phi_4161_ = (_e3443 + _e3457);
                } else {
                    phi_4161_ = (_e3443 - _e3457);
                }
                let _e3462 = phi_4161_;
                if (_e3449 < 0f) {
                    phi_4168_ = (_e3449 + _e3457);
                } else {
                    phi_4168_ = (_e3449 - _e3457);
                }
                let _e3467 = phi_4168_;
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
                        phi_4254_ = vec3<f32>(-(_e3528), -(_e3529), -(_e3530));
                    } else {
                        phi_4254_ = vec3<f32>(_e3528, _e3529, _e3530);
                    }
                    let _e3546 = phi_4254_;
                    phi_4255_ = _e3546;
                } else {
                    phi_4255_ = _e3076;
                }
                let _e3548 = phi_4255_;
                phi_4256_ = _e3548;
            }
            let _e3550 = phi_4256_;
            if (_e3322 > 0f) {
                if (_e3322 < 1f) {
                    phi_4265_ = _e3322;
                } else {
                    phi_4265_ = 1f;
                }
                let _e3554 = phi_4265_;
                phi_4266_ = _e3554;
            } else {
                phi_4266_ = 0f;
            }
            let _e3556 = phi_4266_;
            if (_e3324 > 0f) {
                if (_e3324 < 1f) {
                    phi_4276_ = _e3324;
                } else {
                    phi_4276_ = 1f;
                }
                let _e3561 = phi_4276_;
                phi_4277_ = _e3561;
            } else {
                phi_4277_ = 0f;
            }
            let _e3563 = phi_4277_;
            if (_e3326 > 0f) {
                if (_e3326 < 1f) {
                    phi_4287_ = _e3326;
                } else {
                    phi_4287_ = 1f;
                }
                let _e3568 = phi_4287_;
                phi_4288_ = _e3568;
            } else {
                phi_4288_ = 0f;
            }
            let _e3570 = phi_4288_;
            let _e3573 = ((sqrt(_e3556) * 255f) + 0.5f);
            let _e3582 = ((sqrt(_e3563) * 255f) + 0.5f);
            let _e3594 = ((sqrt(_e3570) * 255f) + 0.5f);
            phi_4323_ = abi_Sample(vec3<f32>(_e2984, _e2985, _e2986), _e3328, _e3076, _e3333, _e3550, ((select(select(u32(_e3573), 0u, (_e3573 < bitcast<f32>(0u))), 4294967295u, (_e3573 > bitcast<f32>(1333788671u))) | (select(select(u32(_e3582), 0u, (_e3582 < bitcast<f32>(0u))), 4294967295u, (_e3582 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e3594), 0u, (_e3594 < bitcast<f32>(0u))), 4294967295u, (_e3594 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_4323_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e3608 = phi_4323_;
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
            phi_4546_ = vec3<f32>((((((((_e3648.x * _e3630.x) + (_e3648.y * _e3630.y)) + (_e3648.z * _e3630.z)) + (_e3648.w * 1f)) * _e3617) + (((((_e3698.x * _e3634.x) + (_e3698.y * _e3634.y)) + (_e3698.z * _e3634.z)) + (_e3698.w * 1f)) * _e2824.u)) + (((((_e3751.x * _e3638.x) + (_e3751.y * _e3638.y)) + (_e3751.z * _e3638.z)) + (_e3751.w * 1f)) * _e2824.v)), (((((((_e3661.x * _e3630.x) + (_e3661.y * _e3630.y)) + (_e3661.z * _e3630.z)) + (_e3661.w * 1f)) * _e3617) + (((((_e3711.x * _e3634.x) + (_e3711.y * _e3634.y)) + (_e3711.z * _e3634.z)) + (_e3711.w * 1f)) * _e2824.u)) + (((((_e3764.x * _e3638.x) + (_e3764.y * _e3638.y)) + (_e3764.z * _e3638.z)) + (_e3764.w * 1f)) * _e2824.v)), (((((((_e3674.x * _e3630.x) + (_e3674.y * _e3630.y)) + (_e3674.z * _e3630.z)) + (_e3674.w * 1f)) * _e3617) + (((((_e3724.x * _e3634.x) + (_e3724.y * _e3634.y)) + (_e3724.z * _e3634.z)) + (_e3724.w * 1f)) * _e2824.u)) + (((((_e3777.x * _e3638.x) + (_e3777.y * _e3638.y)) + (_e3777.z * _e3638.z)) + (_e3777.w * 1f)) * _e2824.v)));
        } else {
            phi_4546_ = vec3<f32>(0f, 0f, 0f);
        }
        let _e3797 = phi_4546_;
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
