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

struct type_31 {
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

struct type_35 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_39 {
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

struct type_43 {
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

struct abi_Sight {
    kept: vec3<f32>,
    t: f32,
}

struct type_53 {
    member: array<abi_Sight>,
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

struct u0028_abi_Sample_u0020_abi_Sight_u0029_ {
    unnamed: abi_Sample,
    unnamed_1: abi_Sight,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(3) 
var<storage> vertices: type_39;
@group(0) @binding(4) 
var<storage> materials: type_43;
@group(0) @binding(0) 
var<uniform> p: type_56;
@group(0) @binding(1) 
var<storage> nodes: type_31;
@group(0) @binding(2) 
var<storage> triangles: type_35;
@group(0) @binding(5) 
var<storage, read_write> samples: type_20;
@group(0) @binding(6) 
var<storage> alpha_texels: type_9;
@group(0) @binding(7) 
var<storage> color_texels: type_9;
@group(0) @binding(8) 
var<storage, read_write> sights: type_53;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_230_: lt_bvh_traverse_Tree;
    var phi_231_: bool;
    var phi_232_: lt_bvh_traverse_Tree;
    var phi_233_: bool;
    var phi_238_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_230_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_231_ = false;
        } else {
            phi_230_ = lt_bvh_traverse_Tree();
            phi_231_ = true;
        }
        let _e88 = phi_230_;
        let _e90 = phi_231_;
        phi_232_ = _e88;
        phi_233_ = _e90;
    } else {
        phi_232_ = lt_bvh_traverse_Tree();
        phi_233_ = true;
    }
    let _e92 = phi_232_;
    let _e94 = phi_233_;
    if _e94 {
        phi_238_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_238_ = _e92;
    }
    let _e99 = phi_238_;
    return lt_bvh_traverse_Tree(_e99.root, _e99.first_primitive);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_253_: bool;
    var phi_257_: f32;

    if (param_3 != param_3) {
        phi_253_ = true;
    } else {
        let _e78 = (param_4 >= param_3);
        if _e78 {
        }
        phi_253_ = _e78;
    }
    let _e80 = phi_253_;
    if _e80 {
        phi_257_ = param_4;
    } else {
        phi_257_ = param_3;
    }
    let _e82 = phi_257_;
    return _e82;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_269_: bool;
    var phi_273_: f32;

    if (param_5 != param_5) {
        phi_269_ = true;
    } else {
        let _e78 = (param_6 <= param_5);
        if _e78 {
        }
        phi_269_ = _e78;
    }
    let _e80 = phi_269_;
    if _e80 {
        phi_273_ = param_6;
    } else {
        phi_273_ = param_5;
    }
    let _e82 = phi_273_;
    return _e82;
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

    let _e79 = (*param_7).size;
    let _e80 = (_e79 & 65535u);
    let _e82 = (*param_7).size;
    let _e84 = (_e82 >> bitcast<u32>(16i));
    let _e86 = (*param_7).flags;
    let _e88 = ((_e86 & 4u) != 0u);
    let _e90 = (*param_7).flags;
    let _e93 = ((_e90 >> bitcast<u32>(4u)) & 3u);
    if (_e93 == 0u) {
        if (param_8 > -8388608f) {
            let _e106 = f32(select(0i, select(select(i32(param_8), i32(-2147483648), (param_8 < bitcast<f32>(3472883712u))), 2147483647i, (param_8 > bitcast<f32>(1325400063u))), (param_8 == param_8)));
            if (_e106 > param_8) {
                phi_315_ = 1f;
            } else {
                phi_315_ = 0f;
            }
            let _e109 = phi_315_;
            if (param_8 < 8388608f) {
                phi_320_ = (_e106 - _e109);
                phi_321_ = false;
            } else {
                phi_320_ = f32();
                phi_321_ = true;
            }
            let _e112 = phi_320_;
            let _e114 = phi_321_;
            phi_322_ = _e112;
            phi_323_ = _e114;
        } else {
            phi_322_ = f32();
            phi_323_ = true;
        }
        let _e116 = phi_322_;
        let _e118 = phi_323_;
        if _e118 {
            phi_327_ = param_8;
        } else {
            phi_327_ = _e116;
        }
        let _e120 = phi_327_;
        phi_375_ = (param_8 - _e120);
    } else {
        if (_e93 == 1u) {
            let _e123 = (param_8 * 0.5f);
            if (_e123 > -8388608f) {
                let _e135 = f32(select(0i, select(select(i32(_e123), i32(-2147483648), (_e123 < bitcast<f32>(3472883712u))), 2147483647i, (_e123 > bitcast<f32>(1325400063u))), (_e123 == _e123)));
                if (_e135 > _e123) {
                    phi_353_ = 1f;
                } else {
                    phi_353_ = 0f;
                }
                let _e138 = phi_353_;
                if (_e123 < 8388608f) {
                    phi_358_ = (_e135 - _e138);
                    phi_359_ = false;
                } else {
                    phi_358_ = f32();
                    phi_359_ = true;
                }
                let _e141 = phi_358_;
                let _e143 = phi_359_;
                phi_360_ = _e141;
                phi_361_ = _e143;
            } else {
                phi_360_ = f32();
                phi_361_ = true;
            }
            let _e145 = phi_360_;
            let _e147 = phi_361_;
            if _e147 {
                phi_365_ = _e123;
            } else {
                phi_365_ = _e145;
            }
            let _e149 = phi_365_;
            let _e151 = (param_8 - (2f * _e149));
            if (_e151 > 1f) {
                phi_373_ = (2f - _e151);
            } else {
                phi_373_ = _e151;
            }
            let _e155 = phi_373_;
            phi_374_ = _e155;
        } else {
            phi_374_ = param_8;
        }
        let _e157 = phi_374_;
        phi_375_ = _e157;
    }
    let _e159 = phi_375_;
    if (_e159 > 0f) {
        if (_e159 < 1f) {
            phi_384_ = _e159;
        } else {
            phi_384_ = 1f;
        }
        let _e163 = phi_384_;
        phi_385_ = _e163;
    } else {
        phi_385_ = 0f;
    }
    let _e165 = phi_385_;
    let _e166 = (_e80 - 1u);
    let _e168 = (_e165 * f32(_e80));
    if _e88 {
        let _e175 = select(select(u32(_e168), 0u, (_e168 < bitcast<f32>(0u))), 4294967295u, (_e168 > bitcast<f32>(1333788671u)));
        if (_e166 < _e175) {
            phi_403_ = _e166;
        } else {
            phi_403_ = _e175;
        }
        let _e178 = phi_403_;
        phi_442_ = texture_Axis(_e178, _e178, 0f);
    } else {
        let _e180 = (_e168 + 0.5f);
        let _e187 = select(select(u32(_e180), 0u, (_e180 < bitcast<f32>(0u))), 4294967295u, (_e180 > bitcast<f32>(1333788671u)));
        if (_e80 < _e187) {
            phi_417_ = _e80;
        } else {
            phi_417_ = _e187;
        }
        let _e190 = phi_417_;
        if (_e93 == 0u) {
            phi_424_ = _e166;
        } else {
            phi_424_ = 0u;
        }
        let _e195 = phi_424_;
        if (_e93 == 0u) {
            phi_429_ = 0u;
        } else {
            phi_429_ = _e166;
        }
        let _e198 = phi_429_;
        if (_e190 == 0u) {
            phi_435_ = _e195;
        } else {
            phi_435_ = (_e190 - 1u);
        }
        let _e202 = phi_435_;
        if (_e190 > _e166) {
            phi_440_ = _e198;
        } else {
            phi_440_ = _e190;
        }
        let _e205 = phi_440_;
        phi_442_ = texture_Axis(_e202, _e205, (_e180 - f32(_e190)));
    }
    let _e208 = phi_442_;
    let _e210 = (*param_7).flags;
    let _e213 = ((_e210 >> bitcast<u32>(6u)) & 3u);
    if (_e213 == 0u) {
        if (param_9 > -8388608f) {
            let _e226 = f32(select(0i, select(select(i32(param_9), i32(-2147483648), (param_9 < bitcast<f32>(3472883712u))), 2147483647i, (param_9 > bitcast<f32>(1325400063u))), (param_9 == param_9)));
            if (_e226 > param_9) {
                phi_470_ = 1f;
            } else {
                phi_470_ = 0f;
            }
            let _e229 = phi_470_;
            if (param_9 < 8388608f) {
                phi_475_ = (_e226 - _e229);
                phi_476_ = false;
            } else {
                phi_475_ = f32();
                phi_476_ = true;
            }
            let _e232 = phi_475_;
            let _e234 = phi_476_;
            phi_477_ = _e232;
            phi_478_ = _e234;
        } else {
            phi_477_ = f32();
            phi_478_ = true;
        }
        let _e236 = phi_477_;
        let _e238 = phi_478_;
        if _e238 {
            phi_482_ = param_9;
        } else {
            phi_482_ = _e236;
        }
        let _e240 = phi_482_;
        phi_530_ = (param_9 - _e240);
    } else {
        if (_e213 == 1u) {
            let _e243 = (param_9 * 0.5f);
            if (_e243 > -8388608f) {
                let _e255 = f32(select(0i, select(select(i32(_e243), i32(-2147483648), (_e243 < bitcast<f32>(3472883712u))), 2147483647i, (_e243 > bitcast<f32>(1325400063u))), (_e243 == _e243)));
                if (_e255 > _e243) {
                    phi_508_ = 1f;
                } else {
                    phi_508_ = 0f;
                }
                let _e258 = phi_508_;
                if (_e243 < 8388608f) {
                    phi_513_ = (_e255 - _e258);
                    phi_514_ = false;
                } else {
                    phi_513_ = f32();
                    phi_514_ = true;
                }
                let _e261 = phi_513_;
                let _e263 = phi_514_;
                phi_515_ = _e261;
                phi_516_ = _e263;
            } else {
                phi_515_ = f32();
                phi_516_ = true;
            }
            let _e265 = phi_515_;
            let _e267 = phi_516_;
            if _e267 {
                phi_520_ = _e243;
            } else {
                phi_520_ = _e265;
            }
            let _e269 = phi_520_;
            let _e271 = (param_9 - (2f * _e269));
            if (_e271 > 1f) {
                phi_528_ = (2f - _e271);
            } else {
                phi_528_ = _e271;
            }
            let _e275 = phi_528_;
            phi_529_ = _e275;
        } else {
            phi_529_ = param_9;
        }
        let _e277 = phi_529_;
        phi_530_ = _e277;
    }
    let _e279 = phi_530_;
    if (_e279 > 0f) {
        if (_e279 < 1f) {
            phi_539_ = _e279;
        } else {
            phi_539_ = 1f;
        }
        let _e283 = phi_539_;
        phi_540_ = _e283;
    } else {
        phi_540_ = 0f;
    }
    let _e285 = phi_540_;
    let _e286 = (_e84 - 1u);
    let _e288 = (_e285 * f32(_e84));
    if _e88 {
        let _e295 = select(select(u32(_e288), 0u, (_e288 < bitcast<f32>(0u))), 4294967295u, (_e288 > bitcast<f32>(1333788671u)));
        if (_e286 < _e295) {
            phi_558_ = _e286;
        } else {
            phi_558_ = _e295;
        }
        let _e298 = phi_558_;
        phi_597_ = texture_Axis(_e298, _e298, 0f);
    } else {
        let _e300 = (_e288 + 0.5f);
        let _e307 = select(select(u32(_e300), 0u, (_e300 < bitcast<f32>(0u))), 4294967295u, (_e300 > bitcast<f32>(1333788671u)));
        if (_e84 < _e307) {
            phi_572_ = _e84;
        } else {
            phi_572_ = _e307;
        }
        let _e310 = phi_572_;
        if (_e213 == 0u) {
            phi_579_ = _e286;
        } else {
            phi_579_ = 0u;
        }
        let _e315 = phi_579_;
        if (_e213 == 0u) {
            phi_584_ = 0u;
        } else {
            phi_584_ = _e286;
        }
        let _e318 = phi_584_;
        if (_e310 == 0u) {
            phi_590_ = _e315;
        } else {
            phi_590_ = (_e310 - 1u);
        }
        let _e322 = phi_590_;
        if (_e310 > _e286) {
            phi_595_ = _e318;
        } else {
            phi_595_ = _e310;
        }
        let _e325 = phi_595_;
        phi_597_ = texture_Axis(_e322, _e325, (_e300 - f32(_e310)));
    }
    let _e328 = phi_597_;
    let _e332 = (*param_7).offset;
    let _e339 = (*param_7).offset;
    let _e346 = (*param_7).offset;
    let _e353 = (*param_7).offset;
    return texture_TexelQuad(array<u32, 4>(((_e332 + (_e328.low * _e80)) + _e208.low), ((_e339 + (_e328.low * _e80)) + _e208.high), ((_e346 + (_e328.high * _e80)) + _e208.low), ((_e353 + (_e328.high * _e80)) + _e208.high)), vec4<f32>(((1f - _e208.fraction) * (1f - _e328.fraction)), (_e208.fraction * (1f - _e328.fraction)), ((1f - _e208.fraction) * _e328.fraction), (_e208.fraction * _e328.fraction)));
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
    let _e79 = phi_656_;
    return _e79;
}

fn _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(param_14: vec3<f32>) -> vec3<f32> {
    return param_14;
}

fn function_() {
    var local: texture_TextureView;
    var local_1: texture_TextureView;
    var local_2: texture_TextureView;
    var local_3: texture_TextureView;
    var local_4: texture_TextureView;
    var local_5: lt_bvh_traverse_Stack;
    var phi_731_: bool;
    var phi_732_: bool;
    var phi_733_: bool;
    var phi_737_: bool;
    var phi_837_: bool;
    var phi_838_: bool;
    var phi_839_: bool;
    var phi_840_: bool;
    var phi_844_: bool;
    var phi_857_: bool;
    var phi_858_: bool;
    var phi_859_: bool;
    var phi_860_: bool;
    var phi_864_: bool;
    var phi_877_: bool;
    var phi_878_: bool;
    var phi_879_: bool;
    var phi_883_: bool;
    var phi_884_: bool;
    var phi_885_: bool;
    var phi_886_: bool;
    var phi_887_: bool;
    var phi_891_: bool;
    var phi_965_: f32;
    var phi_972_: f32;
    var phi_980_: f32;
    var phi_987_: f32;
    var phi_995_: f32;
    var phi_1002_: f32;
    var phi_1025_: f32;
    var phi_1030_: f32;
    var phi_1035_: f32;
    var phi_1040_: f32;
    var phi_1045_: f32;
    var phi_1074_: bool;
    var phi_1075_: bool;
    var phi_1083_: u32;
    var phi_1084_: u32;
    var phi_1101_: vec3<f32>;
    var phi_1102_: vec3<f32>;
    var phi_1115_: u32;
    var phi_1120_: u32;
    var phi_1125_: u32;
    var phi_1239_: bool;
    var phi_1240_: bool;
    var phi_1271_: u32;
    var phi_1273_: lt_bvh_Hit;
    var phi_1276_: u32;
    var phi_1360_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1387_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1414_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1420_: u32;
    var phi_1423_: u32;
    var phi_1437_: u32;
    var phi_1447_: u32;
    var phi_1457_: u32;
    var phi_1475_: u32;
    var phi_1485_: u32;
    var phi_1495_: u32;
    var phi_1531_: u32;
    var phi_1544_: u32;
    var phi_1549_: u32;
    var phi_1550_: u32;
    var phi_1551_: u32;
    var phi_1421_: u32;
    var phi_1424_: u32;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_1609_: lt_bvh_Hit;
    var phi_1612_: u32;
    var phi_1658_: vec3<f32>;
    var phi_1659_: vec3<f32>;
    var phi_1690_: vec3<f32>;
    var phi_1691_: vec3<f32>;
    var phi_1722_: vec3<f32>;
    var phi_1723_: vec3<f32>;
    var phi_1741_: bool;
    var phi_1742_: bool;
    var phi_1746_: f32;
    var phi_1747_: f32;
    var phi_1748_: f32;
    var phi_1749_: f32;
    var phi_1757_: f32;
    var phi_1767_: bool;
    var phi_1768_: bool;
    var phi_1772_: f32;
    var phi_1773_: f32;
    var phi_1774_: f32;
    var phi_1775_: f32;
    var phi_1783_: f32;
    var phi_1793_: bool;
    var phi_1794_: bool;
    var phi_1798_: f32;
    var phi_1799_: f32;
    var phi_1800_: f32;
    var phi_1801_: f32;
    var phi_1809_: f32;
    var phi_1824_: f32;
    var phi_1825_: bool;
    var phi_1826_: f32;
    var phi_1827_: bool;
    var phi_1828_: f32;
    var phi_1829_: bool;
    var phi_1847_: f32;
    var phi_1848_: bool;
    var phi_1849_: bool;
    var phi_1850_: f32;
    var phi_1851_: bool;
    var phi_1852_: bool;
    var phi_1856_: bool;
    var phi_1857_: f32;
    var phi_1858_: bool;
    var phi_1888_: vec3<f32>;
    var phi_1889_: vec3<f32>;
    var phi_1914_: vec3<f32>;
    var phi_1915_: vec3<f32>;
    var phi_1940_: vec3<f32>;
    var phi_1941_: vec3<f32>;
    var phi_1997_: f32;
    var phi_2006_: f32;
    var phi_2015_: f32;
    var phi_2024_: f32;
    var phi_2031_: f32;
    var phi_2038_: f32;
    var phi_2051_: f32;
    var phi_2060_: f32;
    var phi_2069_: f32;
    var phi_2078_: f32;
    var phi_2085_: f32;
    var phi_2092_: f32;
    var phi_2115_: f32;
    var phi_2120_: f32;
    var phi_2125_: f32;
    var phi_2133_: f32;
    var phi_2138_: f32;
    var phi_2143_: f32;
    var phi_2155_: f32;
    var phi_2160_: f32;
    var phi_2165_: f32;
    var phi_2170_: f32;
    var phi_2175_: lt_bvh_triangle_Intersection;
    var phi_2176_: bool;
    var phi_2177_: lt_bvh_triangle_Intersection;
    var phi_2178_: bool;
    var phi_2182_: lt_bvh_triangle_Intersection;
    var phi_2183_: bool;
    var phi_2184_: lt_bvh_triangle_Intersection;
    var phi_2185_: bool;
    var phi_2186_: bool;
    var phi_2190_: bool;
    var phi_2194_: lt_bvh_triangle_Intersection;
    var phi_2232_: bool;
    var phi_2233_: bool;
    var phi_2234_: bool;
    var phi_2235_: bool;
    var phi_2236_: bool;
    var phi_2237_: bool;
    var phi_2241_: bool;
    var phi_2242_: bool;
    var phi_2445_: f32;
    var phi_2448_: bool;
    var phi_2449_: bool;
    var phi_2453_: bool;
    var phi_2461_: lt_bvh_Hit;
    var phi_2462_: lt_bvh_Hit;
    var phi_2463_: lt_bvh_Hit;
    var phi_2464_: lt_bvh_Hit;
    var phi_1610_: lt_bvh_Hit;
    var phi_1613_: u32;
    var phi_2465_: bool;
    var phi_2504_: bool;
    var phi_2505_: bool;
    var phi_2536_: u32;
    var phi_1274_: lt_bvh_Hit;
    var phi_1277_: u32;
    var phi_2537_: lt_bvh_Hit;
    var phi_2538_: lt_bvh_Hit;
    var phi_2539_: bool;
    var phi_2543_: lt_bvh_Hit;
    var phi_2545_: lt_bvh_Hit;
    var phi_2632_: f32;
    var phi_2637_: f32;
    var phi_2642_: f32;
    var phi_2653_: f32;
    var phi_2658_: f32;
    var phi_2663_: f32;
    var phi_2739_: vec3<f32>;
    var phi_2982_: vec3<f32>;
    var phi_2997_: u32;
    var phi_3024_: f32;
    var phi_3031_: f32;
    var phi_3038_: f32;
    var phi_3073_: f32;
    var phi_3080_: f32;
    var phi_3087_: f32;
    var phi_3125_: f32;
    var phi_3132_: f32;
    var phi_3139_: f32;
    var phi_3198_: vec3<f32>;
    var phi_3199_: vec3<f32>;
    var phi_3200_: vec3<f32>;
    var phi_3209_: f32;
    var phi_3210_: f32;
    var phi_3220_: f32;
    var phi_3221_: f32;
    var phi_3231_: f32;
    var phi_3232_: f32;
    var phi_3267_: abi_Sample;
    var phi_3473_: f32;
    var phi_3485_: f32;
    var phi_3494_: f32;
    var phi_3495_: f32;
    var phi_3496_: f32;
    var phi_3497_: f32;
    var phi_3509_: f32;
    var phi_3510_: f32;
    var phi_3642_: f32;
    var phi_3654_: f32;
    var phi_3663_: f32;
    var phi_3664_: f32;
    var phi_3665_: f32;
    var phi_3666_: f32;
    var phi_3865_: vec3<f32>;
    var phi_3889_: f32;
    var phi_3890_: f32;
    var phi_3899_: f32;
    var phi_3900_: f32;
    var phi_3909_: f32;
    var phi_3910_: f32;
    var phi_3948_: u0028_abi_Sample_u0020_abi_Sight_u0029_;
    var phi_3949_: u0028_abi_Sample_u0020_abi_Sight_u0029_;
    var phi_3952_: u0028_abi_Sample_u0020_abi_Sight_u0029_;
    var phi_3953_: u0028_abi_Sample_u0020_abi_Sight_u0029_;
    var phi_3954_: bool;
    var phi_3958_: u0028_abi_Sample_u0020_abi_Sight_u0029_;
    var local_9: lt_bvh_Hit;
    var local_10: lt_bvh_Hit;

    let _e81 = id_1;
    let _e85 = arrayLength((&nodes.member));
    let _e88 = arrayLength((&triangles.member));
    let _e91 = arrayLength((&vertices.member));
    let _e94 = arrayLength((&materials.member));
    let _e100 = arrayLength((&alpha_texels.member));
    let _e103 = arrayLength((&color_texels.member));
    let _e106 = arrayLength((&sights.member));
    let _e109 = p.member.size[0u];
    let _e111 = p.member.size[1u];
    let _e112 = lt_shaders_entry_pixel_index(_e81, _e109, _e111);
    if (bitcast<i32>(_e112.root) != 0i) {
        if (_e112.first_primitive < _e106) {
        } else {
            return;
        }
        let _e120 = sights.member[(0u + _e112.first_primitive)];
        if (_e120.kept.x < 1f) {
            phi_732_ = bool();
            phi_733_ = true;
        } else {
            let _e128 = (_e120.kept.y < 1f);
            if _e128 {
                phi_731_ = bool();
            } else {
                phi_731_ = (_e120.kept.z < 1f);
            }
            let _e133 = phi_731_;
            phi_732_ = _e133;
            phi_733_ = _e128;
        }
        let _e135 = phi_732_;
        let _e137 = phi_733_;
        if _e137 {
            phi_737_ = true;
        } else {
            phi_737_ = _e135;
        }
        let _e139 = phi_737_;
        if _e139 {
            let _e142 = p.member.eye;
            let _e145 = p.member.grid[0u];
            let _e147 = p.member.grid[1u];
            let _e166 = p.member.size[0u];
            let _e170 = ((((f32(_e81.x) + ((f32((_e81.y & (_e147 - 1u))) + 0.5f) / f32(_e147))) / f32(_e166)) * 2f) - 1f);
            let _e173 = p.member.size[1u];
            let _e177 = (1f - (((f32(_e81.y) + ((f32((_e81.x & (_e145 - 1u))) + 0.5f) / f32(_e145))) / f32(_e173)) * 2f));
            let _e179 = p.member.forward;
            let _e181 = p.member.right;
            let _e195 = p.member.up;
            let _e206 = _lt_bvh_ray_Ray_new(_e142, vec3<f32>(((_e179.x + (_e181.x * _e170)) + (_e195.x * _e177)), ((_e179.y + (_e181.y * _e170)) + (_e195.y * _e177)), ((_e179.z + (_e181.z * _e170)) + (_e195.z * _e177))));
            let _e210 = lt_bvh_Hit(_e206.tmax, 0f, 0f, 4294967295u, 4294967295u);
            let _e212 = abs(_e206.direction.x);
            let _e214 = abs(_e206.direction.y);
            let _e216 = abs(_e206.direction.z);
            if (abs(_e206.origin.x) < 1000000000000000f) {
                if (abs(_e206.origin.y) < 1000000000000000f) {
                    phi_837_ = (abs(_e206.origin.z) < 1000000000000000f);
                    phi_838_ = false;
                } else {
                    phi_837_ = bool();
                    phi_838_ = true;
                }
                let _e227 = phi_837_;
                let _e229 = phi_838_;
                phi_839_ = _e227;
                phi_840_ = _e229;
            } else {
                phi_839_ = bool();
                phi_840_ = true;
            }
            let _e231 = phi_839_;
            let _e233 = phi_840_;
            if _e233 {
                phi_844_ = false;
            } else {
                phi_844_ = _e231;
            }
            let _e235 = phi_844_;
            if _e235 {
                if (_e212 < 1000000000000000f) {
                    if (_e214 < 1000000000000000f) {
                        phi_857_ = (_e216 < 1000000000000000f);
                        phi_858_ = false;
                    } else {
                        phi_857_ = bool();
                        phi_858_ = true;
                    }
                    let _e240 = phi_857_;
                    let _e242 = phi_858_;
                    phi_859_ = _e240;
                    phi_860_ = _e242;
                } else {
                    phi_859_ = bool();
                    phi_860_ = true;
                }
                let _e244 = phi_859_;
                let _e246 = phi_860_;
                if _e246 {
                    phi_864_ = false;
                } else {
                    phi_864_ = _e244;
                }
                let _e248 = phi_864_;
                if _e248 {
                    if (_e212 > 0f) {
                        phi_878_ = bool();
                        phi_879_ = true;
                    } else {
                        let _e250 = (_e214 > 0f);
                        if _e250 {
                            phi_877_ = bool();
                        } else {
                            phi_877_ = (_e216 > 0f);
                        }
                        let _e253 = phi_877_;
                        phi_878_ = _e253;
                        phi_879_ = _e250;
                    }
                    let _e255 = phi_878_;
                    let _e257 = phi_879_;
                    if _e257 {
                        phi_883_ = true;
                    } else {
                        phi_883_ = _e255;
                    }
                    let _e259 = phi_883_;
                    phi_884_ = _e259;
                    phi_885_ = false;
                } else {
                    phi_884_ = bool();
                    phi_885_ = true;
                }
                let _e261 = phi_884_;
                let _e263 = phi_885_;
                phi_886_ = _e261;
                phi_887_ = _e263;
            } else {
                phi_886_ = bool();
                phi_887_ = true;
            }
            let _e265 = phi_886_;
            let _e267 = phi_887_;
            if _e267 {
                phi_891_ = false;
            } else {
                phi_891_ = _e265;
            }
            let _e269 = phi_891_;
            if _e269 {
                let _e270 = (0u >= _e85);
                if _e270 {
                    phi_2537_ = lt_bvh_Hit();
                } else {
                    if (0u < _e85) {
                    } else {
                        return;
                    }
                    let _e276 = nodes.member[(0u + 0u)].frame[0u];
                    let _e280 = nodes.member[(0u + 0u)].frame[1u];
                    let _e284 = nodes.member[(0u + 0u)].frame[2u];
                    let _e288 = nodes.member[(0u + 0u)].frame[0u];
                    let _e292 = nodes.member[(0u + 0u)].frame[1u];
                    let _e296 = nodes.member[(0u + 0u)].frame[2u];
                    let _e300 = nodes.member[(0u + 0u)].frame[3u];
                    let _e337 = core_intrinsics_maximum_number_nsz_f32_(abs(_e206.direction.x), abs(_e206.direction.y));
                    let _e338 = core_intrinsics_maximum_number_nsz_f32_(_e337, abs(_e206.direction.z));
                    let _e339 = (_e338 * 0.0000000000009094947f);
                    if (abs(_e206.direction.x) < _e339) {
                        phi_965_ = _e339;
                    } else {
                        phi_965_ = abs(_e206.direction.x);
                    }
                    let _e345 = phi_965_;
                    if (_e206.direction.x < 0f) {
                        phi_972_ = (-1f / _e345);
                    } else {
                        phi_972_ = (1f / _e345);
                    }
                    let _e350 = phi_972_;
                    if (abs(_e206.direction.y) < _e339) {
                        phi_980_ = _e339;
                    } else {
                        phi_980_ = abs(_e206.direction.y);
                    }
                    let _e356 = phi_980_;
                    if (_e206.direction.y < 0f) {
                        phi_987_ = (-1f / _e356);
                    } else {
                        phi_987_ = (1f / _e356);
                    }
                    let _e361 = phi_987_;
                    if (abs(_e206.direction.z) < _e339) {
                        phi_995_ = _e339;
                    } else {
                        phi_995_ = abs(_e206.direction.z);
                    }
                    let _e367 = phi_995_;
                    if (_e206.direction.z < 0f) {
                        phi_1002_ = (-1f / _e367);
                    } else {
                        phi_1002_ = (1f / _e367);
                    }
                    let _e372 = phi_1002_;
                    let _e379 = abs((bitcast<f32>(_e276) - _e206.origin.x));
                    let _e380 = abs((bitcast<f32>(_e280) - _e206.origin.y));
                    let _e381 = abs((bitcast<f32>(_e284) - _e206.origin.z));
                    let _e388 = abs(((bitcast<f32>(_e288) + (bitcast<f32>((((_e300 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e206.origin.x));
                    let _e389 = abs(((bitcast<f32>(_e292) + (bitcast<f32>((((_e300 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e206.origin.y));
                    let _e390 = abs(((bitcast<f32>(_e296) + (bitcast<f32>((((_e300 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e206.origin.z));
                    if (_e379 > _e388) {
                        phi_1025_ = _e379;
                    } else {
                        phi_1025_ = _e388;
                    }
                    let _e393 = phi_1025_;
                    if (_e380 > _e389) {
                        phi_1030_ = _e380;
                    } else {
                        phi_1030_ = _e389;
                    }
                    let _e396 = phi_1030_;
                    if (_e381 > _e390) {
                        phi_1035_ = _e381;
                    } else {
                        phi_1035_ = _e390;
                    }
                    let _e399 = phi_1035_;
                    if (_e393 > _e396) {
                        phi_1040_ = _e393;
                    } else {
                        phi_1040_ = _e396;
                    }
                    let _e402 = phi_1040_;
                    if (_e402 > _e399) {
                        phi_1045_ = _e402;
                    } else {
                        phi_1045_ = _e399;
                    }
                    let _e405 = phi_1045_;
                    let _e409 = (_e405 * 0.0000019073486f);
                    let _e410 = (abs(_e350) * _e409);
                    let _e411 = (abs(_e361) * _e409);
                    let _e412 = (abs(_e372) * _e409);
                    let _e416 = (_e405 * 0.0000009536743f);
                    let _e417 = (abs(_e350) * _e416);
                    let _e418 = (abs(_e361) * _e416);
                    let _e419 = (abs(_e372) * _e416);
                    let _e421 = abs(_e206.direction.x);
                    let _e423 = abs(_e206.direction.y);
                    let _e425 = abs(_e206.direction.z);
                    if (_e421 >= _e423) {
                        if (_e421 >= _e425) {
                            phi_1074_ = false;
                        } else {
                            phi_1074_ = true;
                        }
                        let _e429 = phi_1074_;
                        phi_1075_ = _e429;
                    } else {
                        phi_1075_ = true;
                    }
                    let _e431 = phi_1075_;
                    if _e431 {
                        if (_e423 >= _e425) {
                            phi_1083_ = 1u;
                        } else {
                            phi_1083_ = 2u;
                        }
                        let _e434 = phi_1083_;
                        phi_1084_ = _e434;
                    } else {
                        phi_1084_ = 0u;
                    }
                    let _e436 = phi_1084_;
                    if (_e436 == 0u) {
                        phi_1102_ = vec3<f32>(_e206.direction.y, _e206.direction.z, _e206.direction.x);
                    } else {
                        if (_e436 == 1u) {
                            phi_1101_ = vec3<f32>(_e206.direction.z, _e206.direction.x, _e206.direction.y);
                        } else {
                            phi_1101_ = _e206.direction;
                        }
                        let _e448 = phi_1101_;
                        phi_1102_ = _e448;
                    }
                    let _e450 = phi_1102_;
                    let _e453 = (_e450.x / _e450.z);
                    let _e456 = (_e450.y / _e450.z);
                    if (_e350 < 0f) {
                        phi_1115_ = 0u;
                    } else {
                        phi_1115_ = 1u;
                    }
                    let _e461 = phi_1115_;
                    if (_e361 < 0f) {
                        phi_1120_ = 0u;
                    } else {
                        phi_1120_ = 2u;
                    }
                    let _e464 = phi_1120_;
                    if (_e372 < 0f) {
                        phi_1125_ = 0u;
                    } else {
                        phi_1125_ = 4u;
                    }
                    let _e467 = phi_1125_;
                    let _e469 = ((_e461 | _e464) | _e467);
                    let _e470 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                    local_5 = lt_bvh_traverse_Stack(array<u32, 32>(_e470.first[0], _e470.first[1], _e470.first[2], _e470.first[3], _e470.first[4], _e470.first[5], _e470.first[6], _e470.first[7], _e470.first[8], _e470.first[9], _e470.first[10], _e470.first[11], _e470.first[12], _e470.first[13], _e470.first[14], _e470.first[15], _e470.first[16], _e470.first[17], _e470.first[18], _e470.first[19], _e470.first[20], _e470.first[21], _e470.first[22], _e470.first[23], _e470.first[24], _e470.first[25], _e470.first[26], _e470.first[27], _e470.first[28], _e470.first[29], _e470.first[30], _e470.first[31]), array<u32, 32>(_e470.mask[0], _e470.mask[1], _e470.mask[2], _e470.mask[3], _e470.mask[4], _e470.mask[5], _e470.mask[6], _e470.mask[7], _e470.mask[8], _e470.mask[9], _e470.mask[10], _e470.mask[11], _e470.mask[12], _e470.mask[13], _e470.mask[14], _e470.mask[15], _e470.mask[16], _e470.mask[17], _e470.mask[18], _e470.mask[19], _e470.mask[20], _e470.mask[21], _e470.mask[22], _e470.mask[23], _e470.mask[24], _e470.mask[25], _e470.mask[26], _e470.mask[27], _e470.mask[28], _e470.mask[29], _e470.mask[30], _e470.mask[31]), _e470.len, _e470.group, _e470.group_mask);
                    let _e544 = local_5.group_mask;
                    if ((_e544 & 4278190080u) == 0u) {
                        let _e548 = local_5.len;
                        if (_e548 == 0u) {
                            phi_1239_ = false;
                        } else {
                            let _e552 = local_5.len;
                            local_5.len = (_e552 - 1u);
                            let _e555 = local_5.len;
                            if (_e555 < 32u) {
                            } else {
                                return;
                            }
                            let _e560 = local_5.first[(0u + _e555)];
                            local_5.group = _e560;
                            let _e563 = local_5.len;
                            if (_e563 < 32u) {
                            } else {
                                return;
                            }
                            let _e568 = local_5.mask[(0u + _e563)];
                            local_5.group_mask = _e568;
                            phi_1239_ = true;
                        }
                        let _e571 = phi_1239_;
                        phi_1240_ = _e571;
                    } else {
                        phi_1240_ = true;
                    }
                    let _e573 = phi_1240_;
                    if _e573 {
                        let _e575 = local_5.group_mask;
                        let _e581 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e575)), 32u, (_e575 == 0u)));
                        let _e585 = local_5.group_mask;
                        let _e599 = local_5.group_mask;
                        local_5.group_mask = (_e599 & ~((1u << bitcast<u32>((_e581 & 31u)))));
                        let _e602 = local_5.group;
                        phi_1271_ = (_e602 + countOneBits(((_e585 & ~((4294967295u << bitcast<u32>((((_e581 - 24u) ^ 7u) & 31u))))) & 255u)));
                    } else {
                        phi_1271_ = 4294967295u;
                    }
                    let _e605 = phi_1271_;
                    phi_1273_ = _e210;
                    phi_1276_ = _e605;
                    loop {
                        let _e607 = phi_1273_;
                        let _e609 = phi_1276_;
                        local_10 = _e607;
                        let _e610 = (_e609 != 4294967295u);
                        if _e610 {
                            if (_e609 < _e85) {
                            } else {
                                return;
                            }
                            let _e617 = nodes.member[(0u + _e609)].frame[3u];
                            let _e642 = (bitcast<f32>((((_e617 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e350);
                            let _e643 = (bitcast<f32>((((_e617 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e361);
                            let _e644 = (bitcast<f32>((((_e617 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e372);
                            let _e647 = nodes.member[(0u + _e609)].frame[0u];
                            let _e651 = nodes.member[(0u + _e609)].frame[1u];
                            let _e655 = nodes.member[(0u + _e609)].frame[2u];
                            let _e663 = ((bitcast<f32>(_e647) - _e206.origin.x) * _e350);
                            let _e664 = ((bitcast<f32>(_e651) - _e206.origin.y) * _e361);
                            let _e665 = ((bitcast<f32>(_e655) - _e206.origin.z) * _e372);
                            let _e673 = nodes.member[(0u + _e609)].x;
                            if (_e350 < 0f) {
                                let _e684 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e673.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e690 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e684.unnamed.root, _e673.w), _e684.unnamed_1);
                                let _e696 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e690.unnamed, lt_bvh_traverse_Tree(_e673.x, _e690.unnamed_1.first_primitive));
                                phi_1360_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e696.unnamed, lt_bvh_traverse_Tree(_e696.unnamed_1.root, _e673.y));
                            } else {
                                let _e712 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e673.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e718 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e712.unnamed.root, _e673.y), _e712.unnamed_1);
                                let _e724 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e718.unnamed, lt_bvh_traverse_Tree(_e673.z, _e718.unnamed_1.first_primitive));
                                phi_1360_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e724.unnamed, lt_bvh_traverse_Tree(_e724.unnamed_1.root, _e673.w));
                            }
                            let _e732 = phi_1360_;
                            let _e742 = nodes.member[(0u + _e609)].y;
                            if (_e361 < 0f) {
                                let _e753 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e742.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e759 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e753.unnamed.root, _e742.w), _e753.unnamed_1);
                                let _e765 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e759.unnamed, lt_bvh_traverse_Tree(_e742.x, _e759.unnamed_1.first_primitive));
                                phi_1387_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e765.unnamed, lt_bvh_traverse_Tree(_e765.unnamed_1.root, _e742.y));
                            } else {
                                let _e781 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e742.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e787 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e781.unnamed.root, _e742.y), _e781.unnamed_1);
                                let _e793 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e787.unnamed, lt_bvh_traverse_Tree(_e742.z, _e787.unnamed_1.first_primitive));
                                phi_1387_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e793.unnamed, lt_bvh_traverse_Tree(_e793.unnamed_1.root, _e742.w));
                            }
                            let _e801 = phi_1387_;
                            let _e811 = nodes.member[(0u + _e609)].z;
                            if (_e372 < 0f) {
                                let _e822 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e811.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e828 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e822.unnamed.root, _e811.w), _e822.unnamed_1);
                                let _e834 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e828.unnamed, lt_bvh_traverse_Tree(_e811.x, _e828.unnamed_1.first_primitive));
                                phi_1414_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e834.unnamed, lt_bvh_traverse_Tree(_e834.unnamed_1.root, _e811.y));
                            } else {
                                let _e850 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e811.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e856 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e850.unnamed.root, _e811.y), _e850.unnamed_1);
                                let _e862 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e856.unnamed, lt_bvh_traverse_Tree(_e811.z, _e856.unnamed_1.first_primitive));
                                phi_1414_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e862.unnamed, lt_bvh_traverse_Tree(_e862.unnamed_1.root, _e811.w));
                            }
                            let _e870 = phi_1414_;
                            phi_1420_ = 0u;
                            phi_1423_ = 0u;
                            loop {
                                let _e880 = phi_1420_;
                                let _e882 = phi_1423_;
                                local_6 = _e882;
                                local_7 = _e882;
                                local_8 = _e882;
                                let _e883 = (_e880 < 8u);
                                if _e883 {
                                    let _e885 = (_e880 >> bitcast<u32>(2i));
                                    let _e886 = (_e880 & 3u);
                                    if (_e885 == 0u) {
                                        phi_1437_ = _e732.unnamed.root;
                                    } else {
                                        phi_1437_ = _e732.unnamed.first_primitive;
                                    }
                                    let _e889 = phi_1437_;
                                    if (_e885 == 0u) {
                                        phi_1447_ = _e801.unnamed.root;
                                    } else {
                                        phi_1447_ = _e801.unnamed.first_primitive;
                                    }
                                    let _e898 = phi_1447_;
                                    if (_e885 == 0u) {
                                        phi_1457_ = _e870.unnamed.root;
                                    } else {
                                        phi_1457_ = _e870.unnamed.first_primitive;
                                    }
                                    let _e907 = phi_1457_;
                                    let _e920 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e889 >> bitcast<u32>(((_e886 * 8u) & 31u))) & 255u)) * _e642) + (_e663 - _e410)), ((f32(((_e898 >> bitcast<u32>(((_e886 * 8u) & 31u))) & 255u)) * _e643) + (_e664 - _e411)));
                                    let _e921 = core_intrinsics_maximum_number_nsz_f32_(_e920, ((f32(((_e907 >> bitcast<u32>(((_e886 * 8u) & 31u))) & 255u)) * _e644) + (_e665 - _e412)));
                                    if (_e885 == 0u) {
                                        phi_1475_ = _e732.unnamed_1.root;
                                    } else {
                                        phi_1475_ = _e732.unnamed_1.first_primitive;
                                    }
                                    let _e924 = phi_1475_;
                                    if (_e885 == 0u) {
                                        phi_1485_ = _e801.unnamed_1.root;
                                    } else {
                                        phi_1485_ = _e801.unnamed_1.first_primitive;
                                    }
                                    let _e933 = phi_1485_;
                                    if (_e885 == 0u) {
                                        phi_1495_ = _e870.unnamed_1.root;
                                    } else {
                                        phi_1495_ = _e870.unnamed_1.first_primitive;
                                    }
                                    let _e942 = phi_1495_;
                                    let _e955 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e924 >> bitcast<u32>(((_e886 * 8u) & 31u))) & 255u)) * _e642) + (_e663 + _e410)), ((f32(((_e933 >> bitcast<u32>(((_e886 * 8u) & 31u))) & 255u)) * _e643) + (_e664 + _e411)));
                                    let _e956 = core_intrinsics_minimum_number_nsz_f32_(_e955, ((f32(((_e942 >> bitcast<u32>(((_e886 * 8u) & 31u))) & 255u)) * _e644) + (_e665 + _e412)));
                                    if (_e921 <= _e956) {
                                        if (_e921 <= _e607.t) {
                                            if (_e956 >= _e120.t) {
                                                if (_e885 == 0u) {
                                                    let _e963 = nodes.member[(0u + _e609)].links[2u];
                                                    phi_1531_ = _e963;
                                                } else {
                                                    let _e966 = nodes.member[(0u + _e609)].links[3u];
                                                    phi_1531_ = _e966;
                                                }
                                                let _e968 = phi_1531_;
                                                let _e973 = ((_e968 >> bitcast<u32>(((_e886 * 8u) & 31u))) & 255u);
                                                let _e974 = (_e973 & 31u);
                                                if (_e974 >= 24u) {
                                                    phi_1544_ = (24u + ((_e974 - 24u) ^ _e469));
                                                } else {
                                                    phi_1544_ = _e974;
                                                }
                                                let _e980 = phi_1544_;
                                                phi_1549_ = (_e882 | ((_e973 >> bitcast<u32>(5i)) << bitcast<u32>((_e980 & 31u))));
                                            } else {
                                                phi_1549_ = _e882;
                                            }
                                            let _e988 = phi_1549_;
                                            phi_1550_ = _e988;
                                        } else {
                                            phi_1550_ = _e882;
                                        }
                                        let _e990 = phi_1550_;
                                        phi_1551_ = _e990;
                                    } else {
                                        phi_1551_ = _e882;
                                    }
                                    let _e992 = phi_1551_;
                                    phi_1421_ = (_e880 + 1u);
                                    phi_1424_ = _e992;
                                } else {
                                    phi_1421_ = u32();
                                    phi_1424_ = u32();
                                }
                                let _e995 = phi_1421_;
                                let _e997 = phi_1424_;
                                continue;
                                continuing {
                                    phi_1420_ = _e995;
                                    phi_1423_ = _e997;
                                    break if !(_e883);
                                }
                            }
                            let _e1001 = nodes.member[(0u + _e609)].links[0u];
                            let _e1005 = nodes.member[(0u + _e609)].frame[3u];
                            let _e1009 = local_6;
                            if ((_e1009 & 4278190080u) == 0u) {
                            } else {
                                let _e1013 = local_5.group_mask;
                                if ((_e1013 & 4278190080u) == 0u) {
                                } else {
                                    let _e1017 = local_5.len;
                                    if (_e1017 < 32u) {
                                        let _e1020 = local_5.group;
                                        let _e1022 = local_5.len;
                                        if (_e1022 < 32u) {
                                        } else {
                                            return;
                                        }
                                        local_5.first[(0u + _e1022)] = _e1020;
                                        let _e1028 = local_5.group_mask;
                                        let _e1030 = local_5.len;
                                        if (_e1030 < 32u) {
                                        } else {
                                            return;
                                        }
                                        local_5.mask[(0u + _e1030)] = _e1028;
                                        let _e1037 = local_5.len;
                                        local_5.len = (_e1037 + 1u);
                                    }
                                }
                                local_5.group = (0u + _e1001);
                                let _e1041 = local_7;
                                local_5.group_mask = ((_e1041 & 4278190080u) | (_e1005 >> bitcast<u32>(24i)));
                            }
                            let _e1046 = local_8;
                            phi_1609_ = _e607;
                            phi_1612_ = (_e1046 & 16777215u);
                            loop {
                                let _e1049 = phi_1609_;
                                let _e1051 = phi_1612_;
                                local_9 = _e1049;
                                if (_e1051 == 0u) {
                                    phi_1610_ = lt_bvh_Hit();
                                    phi_1613_ = u32();
                                    phi_2465_ = false;
                                } else {
                                    let _e1055 = nodes.member[(0u + _e609)].links[1u];
                                    let _e1060 = ((0u + _e1055) + select(firstTrailingBit(_e1051), 32u, (_e1051 == 0u)));
                                    if (_e1060 < _e88) {
                                    } else {
                                        return;
                                    }
                                    let _e1067 = triangles.member[(0u + _e1060)].v0_;
                                    let _e1070 = (_e1067.x - _e206.origin.x);
                                    let _e1073 = (_e1067.y - _e206.origin.y);
                                    let _e1076 = (_e1067.z - _e206.origin.z);
                                    if (_e436 == 0u) {
                                        phi_1659_ = vec3<f32>(_e1073, _e1076, _e1070);
                                    } else {
                                        if (_e436 == 1u) {
                                            phi_1658_ = vec3<f32>(_e1076, _e1070, _e1073);
                                        } else {
                                            phi_1658_ = (_e1067 - _e206.origin);
                                        }
                                        let _e1083 = phi_1658_;
                                        phi_1659_ = _e1083;
                                    }
                                    let _e1085 = phi_1659_;
                                    let _e1089 = (_e1085.x - (_e453 * _e1085.z));
                                    let _e1093 = (_e1085.y - (_e456 * _e1085.z));
                                    let _e1095 = triangles.member[(0u + _e1060)].v1_;
                                    let _e1098 = (_e1095.x - _e206.origin.x);
                                    let _e1101 = (_e1095.y - _e206.origin.y);
                                    let _e1104 = (_e1095.z - _e206.origin.z);
                                    if (_e436 == 0u) {
                                        phi_1691_ = vec3<f32>(_e1101, _e1104, _e1098);
                                    } else {
                                        if (_e436 == 1u) {
                                            phi_1690_ = vec3<f32>(_e1104, _e1098, _e1101);
                                        } else {
                                            phi_1690_ = (_e1095 - _e206.origin);
                                        }
                                        let _e1111 = phi_1690_;
                                        phi_1691_ = _e1111;
                                    }
                                    let _e1113 = phi_1691_;
                                    let _e1117 = (_e1113.x - (_e453 * _e1113.z));
                                    let _e1121 = (_e1113.y - (_e456 * _e1113.z));
                                    let _e1123 = triangles.member[(0u + _e1060)].v2_;
                                    let _e1126 = (_e1123.x - _e206.origin.x);
                                    let _e1129 = (_e1123.y - _e206.origin.y);
                                    let _e1132 = (_e1123.z - _e206.origin.z);
                                    if (_e436 == 0u) {
                                        phi_1723_ = vec3<f32>(_e1129, _e1132, _e1126);
                                    } else {
                                        if (_e436 == 1u) {
                                            phi_1722_ = vec3<f32>(_e1132, _e1126, _e1129);
                                        } else {
                                            phi_1722_ = (_e1123 - _e206.origin);
                                        }
                                        let _e1139 = phi_1722_;
                                        phi_1723_ = _e1139;
                                    }
                                    let _e1141 = phi_1723_;
                                    let _e1145 = (_e1141.x - (_e453 * _e1141.z));
                                    let _e1149 = (_e1141.y - (_e456 * _e1141.z));
                                    if (_e1117 < _e1145) {
                                        phi_1742_ = true;
                                    } else {
                                        if (_e1117 == _e1145) {
                                            phi_1741_ = (_e1121 < _e1149);
                                        } else {
                                            phi_1741_ = false;
                                        }
                                        let _e1154 = phi_1741_;
                                        phi_1742_ = _e1154;
                                    }
                                    let _e1156 = phi_1742_;
                                    if _e1156 {
                                        phi_1746_ = _e1149;
                                        phi_1747_ = _e1145;
                                        phi_1748_ = _e1121;
                                        phi_1749_ = _e1117;
                                    } else {
                                        phi_1746_ = _e1121;
                                        phi_1747_ = _e1117;
                                        phi_1748_ = _e1149;
                                        phi_1749_ = _e1145;
                                    }
                                    let _e1158 = phi_1746_;
                                    let _e1160 = phi_1747_;
                                    let _e1162 = phi_1748_;
                                    let _e1164 = phi_1749_;
                                    let _e1167 = ((_e1164 * _e1158) - (_e1162 * _e1160));
                                    if _e1156 {
                                        phi_1757_ = -(_e1167);
                                    } else {
                                        phi_1757_ = _e1167;
                                    }
                                    let _e1170 = phi_1757_;
                                    if (_e1145 < _e1089) {
                                        phi_1768_ = true;
                                    } else {
                                        if (_e1145 == _e1089) {
                                            phi_1767_ = (_e1149 < _e1093);
                                        } else {
                                            phi_1767_ = false;
                                        }
                                        let _e1175 = phi_1767_;
                                        phi_1768_ = _e1175;
                                    }
                                    let _e1177 = phi_1768_;
                                    if _e1177 {
                                        phi_1772_ = _e1093;
                                        phi_1773_ = _e1089;
                                        phi_1774_ = _e1149;
                                        phi_1775_ = _e1145;
                                    } else {
                                        phi_1772_ = _e1149;
                                        phi_1773_ = _e1145;
                                        phi_1774_ = _e1093;
                                        phi_1775_ = _e1089;
                                    }
                                    let _e1179 = phi_1772_;
                                    let _e1181 = phi_1773_;
                                    let _e1183 = phi_1774_;
                                    let _e1185 = phi_1775_;
                                    let _e1188 = ((_e1185 * _e1179) - (_e1183 * _e1181));
                                    if _e1177 {
                                        phi_1783_ = -(_e1188);
                                    } else {
                                        phi_1783_ = _e1188;
                                    }
                                    let _e1191 = phi_1783_;
                                    if (_e1089 < _e1117) {
                                        phi_1794_ = true;
                                    } else {
                                        if (_e1089 == _e1117) {
                                            phi_1793_ = (_e1093 < _e1121);
                                        } else {
                                            phi_1793_ = false;
                                        }
                                        let _e1196 = phi_1793_;
                                        phi_1794_ = _e1196;
                                    }
                                    let _e1198 = phi_1794_;
                                    if _e1198 {
                                        phi_1798_ = _e1121;
                                        phi_1799_ = _e1117;
                                        phi_1800_ = _e1093;
                                        phi_1801_ = _e1089;
                                    } else {
                                        phi_1798_ = _e1093;
                                        phi_1799_ = _e1089;
                                        phi_1800_ = _e1121;
                                        phi_1801_ = _e1117;
                                    }
                                    let _e1200 = phi_1798_;
                                    let _e1202 = phi_1799_;
                                    let _e1204 = phi_1800_;
                                    let _e1206 = phi_1801_;
                                    let _e1209 = ((_e1206 * _e1200) - (_e1204 * _e1202));
                                    if _e1198 {
                                        phi_1809_ = -(_e1209);
                                    } else {
                                        phi_1809_ = _e1209;
                                    }
                                    let _e1212 = phi_1809_;
                                    if (_e1170 >= 0f) {
                                        if (_e1191 >= 0f) {
                                            if (_e1212 >= 0f) {
                                                phi_1824_ = ((_e1170 + _e1191) + _e1212);
                                                phi_1825_ = false;
                                            } else {
                                                phi_1824_ = f32();
                                                phi_1825_ = true;
                                            }
                                            let _e1219 = phi_1824_;
                                            let _e1221 = phi_1825_;
                                            phi_1826_ = _e1219;
                                            phi_1827_ = _e1221;
                                        } else {
                                            phi_1826_ = f32();
                                            phi_1827_ = true;
                                        }
                                        let _e1223 = phi_1826_;
                                        let _e1225 = phi_1827_;
                                        phi_1828_ = _e1223;
                                        phi_1829_ = _e1225;
                                    } else {
                                        phi_1828_ = f32();
                                        phi_1829_ = true;
                                    }
                                    let _e1227 = phi_1828_;
                                    let _e1229 = phi_1829_;
                                    if _e1229 {
                                        if (_e1170 <= 0f) {
                                            if (_e1191 <= 0f) {
                                                let _e1232 = (_e1212 <= 0f);
                                                if _e1232 {
                                                }
                                                phi_1847_ = ((_e1170 + _e1191) + _e1212);
                                                phi_1848_ = false;
                                                phi_1849_ = _e1232;
                                            } else {
                                                phi_1847_ = f32();
                                                phi_1848_ = true;
                                                phi_1849_ = false;
                                            }
                                            let _e1236 = phi_1847_;
                                            let _e1238 = phi_1848_;
                                            let _e1240 = phi_1849_;
                                            phi_1850_ = _e1236;
                                            phi_1851_ = _e1238;
                                            phi_1852_ = _e1240;
                                        } else {
                                            phi_1850_ = f32();
                                            phi_1851_ = true;
                                            phi_1852_ = false;
                                        }
                                        let _e1242 = phi_1850_;
                                        let _e1244 = phi_1851_;
                                        let _e1246 = phi_1852_;
                                        if _e1244 {
                                            phi_1856_ = false;
                                        } else {
                                            phi_1856_ = _e1246;
                                        }
                                        let _e1248 = phi_1856_;
                                        phi_1857_ = _e1242;
                                        phi_1858_ = _e1248;
                                    } else {
                                        phi_1857_ = _e1227;
                                        phi_1858_ = true;
                                    }
                                    let _e1250 = phi_1857_;
                                    let _e1252 = phi_1858_;
                                    if _e1252 {
                                        let _e1253 = (_e1250 == 0f);
                                        if _e1253 {
                                            phi_2182_ = lt_bvh_triangle_Intersection();
                                            phi_2183_ = false;
                                        } else {
                                            let _e1255 = triangles.member[(0u + _e1060)].v0_;
                                            let _e1258 = (_e1255.x - _e206.origin.x);
                                            let _e1261 = (_e1255.y - _e206.origin.y);
                                            let _e1264 = (_e1255.z - _e206.origin.z);
                                            if (_e436 == 0u) {
                                                phi_1889_ = vec3<f32>(_e1261, _e1264, _e1258);
                                            } else {
                                                if (_e436 == 1u) {
                                                    phi_1888_ = vec3<f32>(_e1264, _e1258, _e1261);
                                                } else {
                                                    phi_1888_ = (_e1255 - _e206.origin);
                                                }
                                                let _e1271 = phi_1888_;
                                                phi_1889_ = _e1271;
                                            }
                                            let _e1273 = phi_1889_;
                                            let _e1275 = triangles.member[(0u + _e1060)].v1_;
                                            let _e1277 = triangles.member[(0u + _e1060)].v0_;
                                            let _e1280 = (_e1275.x - _e1277.x);
                                            let _e1283 = (_e1275.y - _e1277.y);
                                            let _e1286 = (_e1275.z - _e1277.z);
                                            if (_e436 == 0u) {
                                                phi_1915_ = vec3<f32>(_e1283, _e1286, _e1280);
                                            } else {
                                                if (_e436 == 1u) {
                                                    phi_1914_ = vec3<f32>(_e1286, _e1280, _e1283);
                                                } else {
                                                    phi_1914_ = (_e1275 - _e1277);
                                                }
                                                let _e1293 = phi_1914_;
                                                phi_1915_ = _e1293;
                                            }
                                            let _e1295 = phi_1915_;
                                            let _e1297 = triangles.member[(0u + _e1060)].v2_;
                                            let _e1299 = triangles.member[(0u + _e1060)].v0_;
                                            let _e1302 = (_e1297.x - _e1299.x);
                                            let _e1305 = (_e1297.y - _e1299.y);
                                            let _e1308 = (_e1297.z - _e1299.z);
                                            if (_e436 == 0u) {
                                                phi_1941_ = vec3<f32>(_e1305, _e1308, _e1302);
                                            } else {
                                                if (_e436 == 1u) {
                                                    phi_1940_ = vec3<f32>(_e1308, _e1302, _e1305);
                                                } else {
                                                    phi_1940_ = (_e1297 - _e1299);
                                                }
                                                let _e1315 = phi_1940_;
                                                phi_1941_ = _e1315;
                                            }
                                            let _e1317 = phi_1941_;
                                            let _e1324 = ((_e1295.y * _e1317.z) - (_e1295.z * _e1317.y));
                                            let _e1331 = ((_e1295.z * _e1317.x) - (_e1295.x * _e1317.z));
                                            let _e1338 = ((_e1295.x * _e1317.y) - (_e1295.y * _e1317.x));
                                            let _e1352 = (((1f / _e450.z) * (((_e1324 * _e1273.x) + (_e1331 * _e1273.y)) + (_e1338 * _e1273.z))) / (((_e1324 * _e453) + (_e1331 * _e456)) + _e1338));
                                            if (_e1352 > _e120.t) {
                                                if (_e1352 < _e206.tmax) {
                                                    let _e1356 = triangles.member[(0u + _e1060)].v0_;
                                                    let _e1358 = triangles.member[(0u + _e1060)].v1_;
                                                    if (_e1356.x < _e1358.x) {
                                                        phi_1997_ = _e1356.x;
                                                    } else {
                                                        phi_1997_ = _e1358.x;
                                                    }
                                                    let _e1365 = phi_1997_;
                                                    if (_e1356.y < _e1358.y) {
                                                        phi_2006_ = _e1356.y;
                                                    } else {
                                                        phi_2006_ = _e1358.y;
                                                    }
                                                    let _e1372 = phi_2006_;
                                                    if (_e1356.z < _e1358.z) {
                                                        phi_2015_ = _e1356.z;
                                                    } else {
                                                        phi_2015_ = _e1358.z;
                                                    }
                                                    let _e1379 = phi_2015_;
                                                    let _e1381 = triangles.member[(0u + _e1060)].v2_;
                                                    if (_e1365 < _e1381.x) {
                                                        phi_2024_ = _e1365;
                                                    } else {
                                                        phi_2024_ = _e1381.x;
                                                    }
                                                    let _e1386 = phi_2024_;
                                                    if (_e1372 < _e1381.y) {
                                                        phi_2031_ = _e1372;
                                                    } else {
                                                        phi_2031_ = _e1381.y;
                                                    }
                                                    let _e1391 = phi_2031_;
                                                    if (_e1379 < _e1381.z) {
                                                        phi_2038_ = _e1379;
                                                    } else {
                                                        phi_2038_ = _e1381.z;
                                                    }
                                                    let _e1396 = phi_2038_;
                                                    let _e1398 = triangles.member[(0u + _e1060)].v0_;
                                                    let _e1400 = triangles.member[(0u + _e1060)].v1_;
                                                    if (_e1398.x > _e1400.x) {
                                                        phi_2051_ = _e1398.x;
                                                    } else {
                                                        phi_2051_ = _e1400.x;
                                                    }
                                                    let _e1407 = phi_2051_;
                                                    if (_e1398.y > _e1400.y) {
                                                        phi_2060_ = _e1398.y;
                                                    } else {
                                                        phi_2060_ = _e1400.y;
                                                    }
                                                    let _e1414 = phi_2060_;
                                                    if (_e1398.z > _e1400.z) {
                                                        phi_2069_ = _e1398.z;
                                                    } else {
                                                        phi_2069_ = _e1400.z;
                                                    }
                                                    let _e1421 = phi_2069_;
                                                    let _e1423 = triangles.member[(0u + _e1060)].v2_;
                                                    if (_e1407 > _e1423.x) {
                                                        phi_2078_ = _e1407;
                                                    } else {
                                                        phi_2078_ = _e1423.x;
                                                    }
                                                    let _e1428 = phi_2078_;
                                                    if (_e1414 > _e1423.y) {
                                                        phi_2085_ = _e1414;
                                                    } else {
                                                        phi_2085_ = _e1423.y;
                                                    }
                                                    let _e1433 = phi_2085_;
                                                    if (_e1421 > _e1423.z) {
                                                        phi_2092_ = _e1421;
                                                    } else {
                                                        phi_2092_ = _e1423.z;
                                                    }
                                                    let _e1438 = phi_2092_;
                                                    let _e1445 = ((_e1386 - _e206.origin.x) * _e350);
                                                    let _e1446 = ((_e1391 - _e206.origin.y) * _e361);
                                                    let _e1447 = ((_e1396 - _e206.origin.z) * _e372);
                                                    let _e1454 = ((_e1428 - _e206.origin.x) * _e350);
                                                    let _e1455 = ((_e1433 - _e206.origin.y) * _e361);
                                                    let _e1456 = ((_e1438 - _e206.origin.z) * _e372);
                                                    if (_e1445 < _e1454) {
                                                        phi_2115_ = _e1445;
                                                    } else {
                                                        phi_2115_ = _e1454;
                                                    }
                                                    let _e1459 = phi_2115_;
                                                    if (_e1446 < _e1455) {
                                                        phi_2120_ = _e1446;
                                                    } else {
                                                        phi_2120_ = _e1455;
                                                    }
                                                    let _e1462 = phi_2120_;
                                                    if (_e1447 < _e1456) {
                                                        phi_2125_ = _e1447;
                                                    } else {
                                                        phi_2125_ = _e1456;
                                                    }
                                                    let _e1465 = phi_2125_;
                                                    if (_e1445 > _e1454) {
                                                        phi_2133_ = _e1445;
                                                    } else {
                                                        phi_2133_ = _e1454;
                                                    }
                                                    let _e1471 = phi_2133_;
                                                    if (_e1446 > _e1455) {
                                                        phi_2138_ = _e1446;
                                                    } else {
                                                        phi_2138_ = _e1455;
                                                    }
                                                    let _e1474 = phi_2138_;
                                                    if (_e1447 > _e1456) {
                                                        phi_2143_ = _e1447;
                                                    } else {
                                                        phi_2143_ = _e1456;
                                                    }
                                                    let _e1477 = phi_2143_;
                                                    let _e1481 = core_intrinsics_maximum_number_nsz_f32_((_e1459 - _e417), (_e1462 - _e418));
                                                    let _e1482 = core_intrinsics_maximum_number_nsz_f32_(_e1481, (_e1465 - _e419));
                                                    let _e1483 = core_intrinsics_minimum_number_nsz_f32_((_e1471 + _e417), (_e1474 + _e418));
                                                    let _e1484 = core_intrinsics_minimum_number_nsz_f32_(_e1483, (_e1477 + _e419));
                                                    if (_e1482 > -300000000000000000000000000000000000000f) {
                                                        phi_2155_ = _e1482;
                                                    } else {
                                                        phi_2155_ = -300000000000000000000000000000000000000f;
                                                    }
                                                    let _e1487 = phi_2155_;
                                                    if (_e1484 < 300000000000000000000000000000000000000f) {
                                                        phi_2160_ = _e1484;
                                                    } else {
                                                        phi_2160_ = 300000000000000000000000000000000000000f;
                                                    }
                                                    let _e1490 = phi_2160_;
                                                    if (_e1352 < _e1487) {
                                                        phi_2165_ = _e1487;
                                                    } else {
                                                        phi_2165_ = _e1352;
                                                    }
                                                    let _e1493 = phi_2165_;
                                                    if (_e1493 > _e1490) {
                                                        phi_2170_ = _e1490;
                                                    } else {
                                                        phi_2170_ = _e1493;
                                                    }
                                                    let _e1496 = phi_2170_;
                                                    phi_2175_ = lt_bvh_triangle_Intersection(_e1496, (_e1191 / _e1250), (_e1212 / _e1250), (_e1487 <= _e1490));
                                                    phi_2176_ = false;
                                                } else {
                                                    phi_2175_ = lt_bvh_triangle_Intersection();
                                                    phi_2176_ = true;
                                                }
                                                let _e1502 = phi_2175_;
                                                let _e1504 = phi_2176_;
                                                phi_2177_ = _e1502;
                                                phi_2178_ = _e1504;
                                            } else {
                                                phi_2177_ = lt_bvh_triangle_Intersection();
                                                phi_2178_ = true;
                                            }
                                            let _e1506 = phi_2177_;
                                            let _e1508 = phi_2178_;
                                            if _e1508 {
                                            }
                                            phi_2182_ = _e1506;
                                            phi_2183_ = _e1508;
                                        }
                                        let _e1510 = phi_2182_;
                                        let _e1512 = phi_2183_;
                                        phi_2184_ = _e1510;
                                        phi_2185_ = _e1253;
                                        phi_2186_ = _e1512;
                                    } else {
                                        phi_2184_ = lt_bvh_triangle_Intersection();
                                        phi_2185_ = true;
                                        phi_2186_ = false;
                                    }
                                    let _e1514 = phi_2184_;
                                    let _e1516 = phi_2185_;
                                    let _e1518 = phi_2186_;
                                    if _e1516 {
                                        phi_2190_ = true;
                                    } else {
                                        phi_2190_ = _e1518;
                                    }
                                    let _e1520 = phi_2190_;
                                    if _e1520 {
                                        phi_2194_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                    } else {
                                        phi_2194_ = _e1514;
                                    }
                                    let _e1522 = phi_2194_;
                                    if _e1522.is_hit {
                                        if (_e1522.t > _e120.t) {
                                            if (_e1522.t < _e1049.t) {
                                                phi_2242_ = true;
                                            } else {
                                                if (_e1522.t == _e1049.t) {
                                                    if (_e1049.triangle != 4294967295u) {
                                                        if (_e1060 < _e1049.triangle) {
                                                            phi_2233_ = true;
                                                        } else {
                                                            if (_e1060 == _e1049.triangle) {
                                                                phi_2232_ = (4294967295u < _e1049.instance);
                                                            } else {
                                                                phi_2232_ = false;
                                                            }
                                                            let _e1540 = phi_2232_;
                                                            phi_2233_ = _e1540;
                                                        }
                                                        let _e1542 = phi_2233_;
                                                        phi_2234_ = _e1542;
                                                        phi_2235_ = false;
                                                    } else {
                                                        phi_2234_ = bool();
                                                        phi_2235_ = true;
                                                    }
                                                    let _e1544 = phi_2234_;
                                                    let _e1546 = phi_2235_;
                                                    phi_2236_ = _e1544;
                                                    phi_2237_ = _e1546;
                                                } else {
                                                    phi_2236_ = bool();
                                                    phi_2237_ = true;
                                                }
                                                let _e1548 = phi_2236_;
                                                let _e1550 = phi_2237_;
                                                if _e1550 {
                                                    phi_2241_ = false;
                                                } else {
                                                    phi_2241_ = _e1548;
                                                }
                                                let _e1552 = phi_2241_;
                                                phi_2242_ = _e1552;
                                            }
                                            let _e1554 = phi_2242_;
                                            if _e1554 {
                                                let _e1556 = triangles.member[(0u + _e1060)].i0_;
                                                if ((_e1556 & 2147483648u) == 0u) {
                                                    phi_2453_ = true;
                                                } else {
                                                    if (_e1060 < _e88) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1565 = triangles.member[(0u + _e1060)].i0_;
                                                    let _e1566 = (_e1565 & 2147483647u);
                                                    let _e1568 = triangles.member[(0u + _e1060)].i1_;
                                                    let _e1570 = triangles.member[(0u + _e1060)].i2_;
                                                    if (_e1566 < _e91) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1574 = vertices.member[(0u + _e1566)];
                                                    if (_e1568 < _e91) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1578 = vertices.member[(0u + _e1568)];
                                                    if (_e1570 < _e91) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1582 = vertices.member[(0u + _e1570)];
                                                    let _e1583 = array<abi_Vertex, 3>(_e1574, _e1578, _e1582);
                                                    if (_e1583[0].material < _e94) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1589 = materials.member[(0u + _e1583[0].material)];
                                                    if ((_e1589.flags & 0u) == 0u) {
                                                        let _e1594 = ((1f - _e1522.u) - _e1522.v);
                                                        if (_e1589.cutoff <= 0f) {
                                                            phi_2448_ = true;
                                                        } else {
                                                            let _e1621 = (_e1589.base_color.w * ((((f32((_e1583[0].color >> bitcast<u32>(24i))) * _e1594) + (f32((_e1583[1].color >> bitcast<u32>(24i))) * _e1522.u)) + (f32((_e1583[2].color >> bitcast<u32>(24i))) * _e1522.v)) * (1f / 255f)));
                                                            if (_e1589.alpha_size == 0u) {
                                                                phi_2445_ = _e1621;
                                                            } else {
                                                                local_4.offset = _e1589.alpha_offset;
                                                                local_4.size = _e1589.alpha_size;
                                                                local_4.flags = _e1589.flags;
                                                                let _e1652 = _lt_shaders_texture_TextureView_quad((&local_4), (((_e1583[0].u * _e1594) + (_e1583[1].u * _e1522.u)) + (_e1583[2].u * _e1522.v)), (((_e1583[0].v * _e1594) + (_e1583[1].v * _e1522.u)) + (_e1583[2].v * _e1522.v)));
                                                                let _e1656 = (_e1652.indices[0] >> bitcast<u32>(2i));
                                                                if (_e1656 < _e100) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1660 = alpha_texels.member[(0u + _e1656)];
                                                                let _e1676 = (_e1652.indices[1] >> bitcast<u32>(2i));
                                                                if (_e1676 < _e100) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1680 = alpha_texels.member[(0u + _e1676)];
                                                                let _e1697 = (_e1652.indices[2] >> bitcast<u32>(2i));
                                                                if (_e1697 < _e100) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1701 = alpha_texels.member[(0u + _e1697)];
                                                                let _e1718 = (_e1652.indices[3] >> bitcast<u32>(2i));
                                                                if (_e1718 < _e100) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1722 = alpha_texels.member[(0u + _e1718)];
                                                                phi_2445_ = (_e1621 * (((((f32(((_e1660 >> bitcast<u32>((((_e1652.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1652.weights.x) + ((f32(((_e1680 >> bitcast<u32>((((_e1652.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1652.weights.y)) + ((f32(((_e1701 >> bitcast<u32>((((_e1652.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1652.weights.z)) + ((f32(((_e1722 >> bitcast<u32>((((_e1652.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1652.weights.w)));
                                                            }
                                                            let _e1738 = phi_2445_;
                                                            phi_2448_ = (_e1738 >= _e1589.cutoff);
                                                        }
                                                        let _e1742 = phi_2448_;
                                                        phi_2449_ = _e1742;
                                                    } else {
                                                        phi_2449_ = false;
                                                    }
                                                    let _e1744 = phi_2449_;
                                                    if _e1744 {
                                                    }
                                                    phi_2453_ = _e1744;
                                                }
                                                let _e1746 = phi_2453_;
                                                if _e1746 {
                                                    phi_2461_ = lt_bvh_Hit(_e1522.t, _e1522.u, _e1522.v, _e1060, 4294967295u);
                                                } else {
                                                    phi_2461_ = _e1049;
                                                }
                                                let _e1752 = phi_2461_;
                                                phi_2462_ = _e1752;
                                            } else {
                                                phi_2462_ = _e1049;
                                            }
                                            let _e1754 = phi_2462_;
                                            phi_2463_ = _e1754;
                                        } else {
                                            phi_2463_ = _e1049;
                                        }
                                        let _e1756 = phi_2463_;
                                        phi_2464_ = _e1756;
                                    } else {
                                        phi_2464_ = _e1049;
                                    }
                                    let _e1758 = phi_2464_;
                                    phi_1610_ = _e1758;
                                    phi_1613_ = (_e1051 & (_e1051 - 1u));
                                    phi_2465_ = true;
                                }
                                let _e1760 = phi_1610_;
                                let _e1762 = phi_1613_;
                                let _e1764 = phi_2465_;
                                continue;
                                continuing {
                                    phi_1609_ = _e1760;
                                    phi_1612_ = _e1762;
                                    break if !(_e1764);
                                }
                            }
                            let _e1767 = local_5.group_mask;
                            if ((_e1767 & 4278190080u) == 0u) {
                                let _e1771 = local_5.len;
                                if (_e1771 == 0u) {
                                    phi_2504_ = false;
                                } else {
                                    let _e1775 = local_5.len;
                                    local_5.len = (_e1775 - 1u);
                                    let _e1778 = local_5.len;
                                    if (_e1778 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1783 = local_5.first[(0u + _e1778)];
                                    local_5.group = _e1783;
                                    let _e1786 = local_5.len;
                                    if (_e1786 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1791 = local_5.mask[(0u + _e1786)];
                                    local_5.group_mask = _e1791;
                                    phi_2504_ = true;
                                }
                                let _e1794 = phi_2504_;
                                phi_2505_ = _e1794;
                            } else {
                                phi_2505_ = true;
                            }
                            let _e1796 = phi_2505_;
                            if _e1796 {
                                let _e1798 = local_5.group_mask;
                                let _e1804 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1798)), 32u, (_e1798 == 0u)));
                                let _e1808 = local_5.group_mask;
                                let _e1822 = local_5.group_mask;
                                local_5.group_mask = (_e1822 & ~((1u << bitcast<u32>((_e1804 & 31u)))));
                                let _e1825 = local_5.group;
                                phi_2536_ = (_e1825 + countOneBits(((_e1808 & ~((4294967295u << bitcast<u32>((((_e1804 - 24u) ^ _e469) & 31u))))) & 255u)));
                            } else {
                                phi_2536_ = 4294967295u;
                            }
                            let _e1828 = phi_2536_;
                            let _e3377 = local_9;
                            phi_1274_ = _e3377;
                            phi_1277_ = _e1828;
                        } else {
                            phi_1274_ = lt_bvh_Hit();
                            phi_1277_ = u32();
                        }
                        let _e1830 = phi_1274_;
                        let _e1832 = phi_1277_;
                        continue;
                        continuing {
                            phi_1273_ = _e1830;
                            phi_1276_ = _e1832;
                            break if !(_e610);
                        }
                    }
                    let _e3381 = local_10;
                    phi_2537_ = _e3381;
                }
                let _e1835 = phi_2537_;
                phi_2538_ = _e1835;
                phi_2539_ = _e270;
            } else {
                phi_2538_ = lt_bvh_Hit();
                phi_2539_ = true;
            }
            let _e1837 = phi_2538_;
            let _e1839 = phi_2539_;
            if _e1839 {
                phi_2543_ = _e210;
            } else {
                phi_2543_ = _e1837;
            }
            let _e1841 = phi_2543_;
            phi_2545_ = _e1841;
        } else {
            phi_2545_ = lt_bvh_Hit(300000000000000000000000000000000000000f, 0f, 0f, 4294967295u, 4294967295u);
        }
        let _e1844 = phi_2545_;
        let _e1846 = abi_Sight(vec3<f32>(1f, 1f, 1f), _e120.t);
        if (_e1844.triangle != 4294967295u) {
            if (_e1844.triangle != 4294967295u) {
                let _e1854 = ((1f - _e1844.u) - _e1844.v);
                if (_e1844.triangle < _e88) {
                } else {
                    return;
                }
                let _e1859 = triangles.member[(0u + _e1844.triangle)];
                let _e1884 = (((_e1859.v0_.x * _e1854) + (_e1859.v1_.x * _e1844.u)) + (_e1859.v2_.x * _e1844.v));
                let _e1885 = (((_e1859.v0_.y * _e1854) + (_e1859.v1_.y * _e1844.u)) + (_e1859.v2_.y * _e1844.v));
                let _e1886 = (((_e1859.v0_.z * _e1854) + (_e1859.v1_.z * _e1844.u)) + (_e1859.v2_.z * _e1844.v));
                let _e1889 = abs(_e1859.v0_.x);
                let _e1891 = abs(_e1859.v0_.y);
                let _e1893 = abs(_e1859.v0_.z);
                let _e1895 = abs(_e1859.v1_.x);
                let _e1897 = abs(_e1859.v1_.y);
                let _e1899 = abs(_e1859.v1_.z);
                if (_e1889 > _e1895) {
                    phi_2632_ = _e1889;
                } else {
                    phi_2632_ = _e1895;
                }
                let _e1902 = phi_2632_;
                if (_e1891 > _e1897) {
                    phi_2637_ = _e1891;
                } else {
                    phi_2637_ = _e1897;
                }
                let _e1905 = phi_2637_;
                if (_e1893 > _e1899) {
                    phi_2642_ = _e1893;
                } else {
                    phi_2642_ = _e1899;
                }
                let _e1908 = phi_2642_;
                let _e1910 = abs(_e1859.v2_.x);
                let _e1912 = abs(_e1859.v2_.y);
                let _e1914 = abs(_e1859.v2_.z);
                if (_e1902 > _e1910) {
                    phi_2653_ = _e1902;
                } else {
                    phi_2653_ = _e1910;
                }
                let _e1917 = phi_2653_;
                if (_e1905 > _e1912) {
                    phi_2658_ = _e1905;
                } else {
                    phi_2658_ = _e1912;
                }
                let _e1920 = phi_2658_;
                if (_e1908 > _e1914) {
                    phi_2663_ = _e1908;
                } else {
                    phi_2663_ = _e1914;
                }
                let _e1923 = phi_2663_;
                let _e1926 = (_e1859.v1_.x - _e1859.v0_.x);
                let _e1929 = (_e1859.v1_.y - _e1859.v0_.y);
                let _e1932 = (_e1859.v1_.z - _e1859.v0_.z);
                let _e1935 = (_e1859.v2_.x - _e1859.v0_.x);
                let _e1938 = (_e1859.v2_.y - _e1859.v0_.y);
                let _e1941 = (_e1859.v2_.z - _e1859.v0_.z);
                let _e1945 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1929), abs(_e1932));
                let _e1946 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1926), _e1945);
                let _e1947 = (_e1926 / _e1946);
                let _e1948 = (_e1929 / _e1946);
                let _e1949 = (_e1932 / _e1946);
                let _e1953 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1938), abs(_e1941));
                let _e1954 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1935), _e1953);
                let _e1955 = (_e1935 / _e1954);
                let _e1956 = (_e1938 / _e1954);
                let _e1957 = (_e1941 / _e1954);
                let _e1960 = ((_e1948 * _e1957) - (_e1956 * _e1949));
                let _e1963 = ((_e1949 * _e1955) - (_e1957 * _e1947));
                let _e1966 = ((_e1947 * _e1956) - (_e1955 * _e1948));
                let _e1968 = p.member.eye;
                let _e1981 = (1f / sqrt((((_e1960 * _e1960) + (_e1963 * _e1963)) + (_e1966 * _e1966))));
                let _e1982 = (_e1960 * _e1981);
                let _e1983 = (_e1963 * _e1981);
                let _e1984 = (_e1966 * _e1981);
                if ((((_e1982 * (_e1968.x - _e1884)) + (_e1983 * (_e1968.y - _e1885))) + (_e1984 * (_e1968.z - _e1886))) < 0f) {
                    phi_2739_ = vec3<f32>(-(_e1982), -(_e1983), -(_e1984));
                } else {
                    phi_2739_ = vec3<f32>(_e1982, _e1983, _e1984);
                }
                let _e1997 = phi_2739_;
                if (_e1844.triangle < _e88) {
                } else {
                    return;
                }
                let _e2002 = triangles.member[(0u + _e1844.triangle)];
                let _e2004 = (_e2002.i0_ & 2147483647u);
                if (_e2004 < _e91) {
                } else {
                    return;
                }
                let _e2010 = vertices.member[(0u + _e2004)];
                if (_e2002.i1_ < _e91) {
                } else {
                    return;
                }
                let _e2014 = vertices.member[(0u + _e2002.i1_)];
                if (_e2002.i2_ < _e91) {
                } else {
                    return;
                }
                let _e2018 = vertices.member[(0u + _e2002.i2_)];
                let _e2019 = array<abi_Vertex, 3>(_e2010, _e2014, _e2018);
                if (_e2019[0].material < _e94) {
                } else {
                    return;
                }
                let _e2025 = materials.member[(0u + _e2019[0].material)];
                let _e2042 = (1f / 255f);
                let _e2061 = (1f / 255f);
                let _e2083 = (1f / 255f);
                if (_e2025.color_size == 0u) {
                    phi_2982_ = vec3<f32>(1f, 1f, 1f);
                } else {
                    local_3.offset = _e2025.color_offset;
                    local_3.size = _e2025.color_size;
                    local_3.flags = _e2025.flags;
                    let _e2126 = _lt_shaders_texture_TextureView_quad((&local_3), (((_e2019[0].u * _e1854) + (_e2019[1].u * _e1844.u)) + (_e2019[2].u * _e1844.v)), (((_e2019[0].v * _e1854) + (_e2019[1].v * _e1844.u)) + (_e2019[2].v * _e1844.v)));
                    if (_e2126.indices[0] < _e103) {
                    } else {
                        return;
                    }
                    let _e2132 = color_texels.member[(0u + _e2126.indices[0])];
                    let _e2143 = (1f / 255f);
                    if (_e2126.indices[1] < _e103) {
                    } else {
                        return;
                    }
                    let _e2157 = color_texels.member[(0u + _e2126.indices[1])];
                    let _e2168 = (1f / 255f);
                    if (_e2126.indices[2] < _e103) {
                    } else {
                        return;
                    }
                    let _e2185 = color_texels.member[(0u + _e2126.indices[2])];
                    let _e2196 = (1f / 255f);
                    if (_e2126.indices[3] < _e103) {
                    } else {
                        return;
                    }
                    let _e2213 = color_texels.member[(0u + _e2126.indices[3])];
                    let _e2224 = (1f / 255f);
                    let _e2233 = (((((f32((_e2132 & 255u)) * _e2143) * _e2126.weights.x) + ((f32((_e2157 & 255u)) * _e2168) * _e2126.weights.y)) + ((f32((_e2185 & 255u)) * _e2196) * _e2126.weights.z)) + ((f32((_e2213 & 255u)) * _e2224) * _e2126.weights.w));
                    let _e2234 = (((((f32(((_e2132 >> bitcast<u32>(8i)) & 255u)) * _e2143) * _e2126.weights.x) + ((f32(((_e2157 >> bitcast<u32>(8i)) & 255u)) * _e2168) * _e2126.weights.y)) + ((f32(((_e2185 >> bitcast<u32>(8i)) & 255u)) * _e2196) * _e2126.weights.z)) + ((f32(((_e2213 >> bitcast<u32>(8i)) & 255u)) * _e2224) * _e2126.weights.w));
                    let _e2235 = (((((f32(((_e2132 >> bitcast<u32>(16i)) & 255u)) * _e2143) * _e2126.weights.x) + ((f32(((_e2157 >> bitcast<u32>(16i)) & 255u)) * _e2168) * _e2126.weights.y)) + ((f32(((_e2185 >> bitcast<u32>(16i)) & 255u)) * _e2196) * _e2126.weights.z)) + ((f32(((_e2213 >> bitcast<u32>(16i)) & 255u)) * _e2224) * _e2126.weights.w));
                    phi_2982_ = vec3<f32>((_e2233 * _e2233), (_e2234 * _e2234), (_e2235 * _e2235));
                }
                let _e2241 = phi_2982_;
                let _e2243 = ((_e2025.base_color.x * ((((f32((_e2019[0].color & 255u)) * _e2042) * _e1854) + ((f32((_e2019[1].color & 255u)) * _e2061) * _e1844.u)) + ((f32((_e2019[2].color & 255u)) * _e2083) * _e1844.v))) * _e2241.x);
                let _e2245 = ((_e2025.base_color.y * ((((f32(((_e2019[0].color >> bitcast<u32>(8i)) & 255u)) * _e2042) * _e1854) + ((f32(((_e2019[1].color >> bitcast<u32>(8i)) & 255u)) * _e2061) * _e1844.u)) + ((f32(((_e2019[2].color >> bitcast<u32>(8i)) & 255u)) * _e2083) * _e1844.v))) * _e2241.y);
                let _e2247 = ((_e2025.base_color.z * ((((f32(((_e2019[0].color >> bitcast<u32>(16i)) & 255u)) * _e2042) * _e1854) + ((f32(((_e2019[1].color >> bitcast<u32>(16i)) & 255u)) * _e2061) * _e1844.u)) + ((f32(((_e2019[2].color >> bitcast<u32>(16i)) & 255u)) * _e2083) * _e1844.v))) * _e2241.z);
                let _e2248 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1920, _e1923);
                let _e2249 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1917, _e2248);
                if ((_e2025.flags & 2u) == 0u) {
                    phi_2997_ = 0u;
                } else {
                    phi_2997_ = 1u;
                }
                let _e2254 = phi_2997_;
                if (_e2019[0].normal == 2147516416u) {
                    phi_3200_ = _e1997;
                } else {
                    let _e2267 = (f32((bitcast<i32>((_e2019[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                    let _e2273 = (f32((bitcast<i32>(_e2019[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                    let _e2277 = ((1f - abs(_e2267)) - abs(_e2273));
                    if (_e2277 < 0f) {
                        phi_3024_ = -(_e2277);
                    } else {
                        phi_3024_ = 0f;
                    }
                    let _e2281 = phi_3024_;
                    if (_e2267 < 0f) {
                        phi_3031_ = (_e2267 + _e2281);
                    } else {
                        phi_3031_ = (_e2267 - _e2281);
                    }
                    let _e2286 = phi_3031_;
                    if (_e2273 < 0f) {
                        phi_3038_ = (_e2273 + _e2281);
                    } else {
                        phi_3038_ = (_e2273 - _e2281);
                    }
                    let _e2291 = phi_3038_;
                    let _e2298 = (1f / sqrt((((_e2286 * _e2286) + (_e2291 * _e2291)) + (_e2277 * _e2277))));
                    let _e2314 = (f32((bitcast<i32>((_e2019[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                    let _e2320 = (f32((bitcast<i32>(_e2019[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                    let _e2324 = ((1f - abs(_e2314)) - abs(_e2320));
                    if (_e2324 < 0f) {
                        phi_3073_ = -(_e2324);
                    } else {
                        phi_3073_ = 0f;
                    }
                    let _e2328 = phi_3073_;
                    if (_e2314 < 0f) {
                        phi_3080_ = (_e2314 + _e2328);
                    } else {
                        phi_3080_ = (_e2314 - _e2328);
                    }
                    let _e2333 = phi_3080_;
                    if (_e2320 < 0f) {
                        phi_3087_ = (_e2320 + _e2328);
                    } else {
                        phi_3087_ = (_e2320 - _e2328);
                    }
                    let _e2338 = phi_3087_;
                    let _e2345 = (1f / sqrt((((_e2333 * _e2333) + (_e2338 * _e2338)) + (_e2324 * _e2324))));
                    let _e2364 = (f32((bitcast<i32>((_e2019[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                    let _e2370 = (f32((bitcast<i32>(_e2019[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                    let _e2374 = ((1f - abs(_e2364)) - abs(_e2370));
                    if (_e2374 < 0f) {
                        phi_3125_ = -(_e2374);
                    } else {
                        phi_3125_ = 0f;
                    }
                    let _e2378 = phi_3125_;
                    if (_e2364 < 0f) {
                        phi_3132_ = (_e2364 + _e2378);
                    } else {
                        phi_3132_ = (_e2364 - _e2378);
                    }
                    let _e2383 = phi_3132_;
                    if (_e2370 < 0f) {
                        phi_3139_ = (_e2370 + _e2378);
                    } else {
                        phi_3139_ = (_e2370 - _e2378);
                    }
                    let _e2388 = phi_3139_;
                    let _e2395 = (1f / sqrt((((_e2383 * _e2383) + (_e2388 * _e2388)) + (_e2374 * _e2374))));
                    let _e2406 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(vec3<f32>(((((_e2286 * _e2298) * _e1854) + ((_e2333 * _e2345) * _e1844.u)) + ((_e2383 * _e2395) * _e1844.v)), ((((_e2291 * _e2298) * _e1854) + ((_e2338 * _e2345) * _e1844.u)) + ((_e2388 * _e2395) * _e1844.v)), ((((_e2277 * _e2298) * _e1854) + ((_e2324 * _e2345) * _e1844.u)) + ((_e2374 * _e2395) * _e1844.v))));
                    let _e2418 = sqrt((((_e2406.x * _e2406.x) + (_e2406.y * _e2406.y)) + (_e2406.z * _e2406.z)));
                    if (_e2418 > 0f) {
                        let _e2421 = (_e2406.x / _e2418);
                        let _e2423 = (_e2406.y / _e2418);
                        let _e2425 = (_e2406.z / _e2418);
                        if ((((_e2421 * _e1997.x) + (_e2423 * _e1997.y)) + (_e2425 * _e1997.z)) < 0f) {
                            phi_3198_ = vec3<f32>(-(_e2421), -(_e2423), -(_e2425));
                        } else {
                            phi_3198_ = (_e2406 / vec3(_e2418));
                        }
                        let _e2442 = phi_3198_;
                        phi_3199_ = _e2442;
                    } else {
                        phi_3199_ = _e1997;
                    }
                    let _e2444 = phi_3199_;
                    phi_3200_ = _e2444;
                }
                let _e2446 = phi_3200_;
                if (_e2243 > 0f) {
                    if (_e2243 < 1f) {
                        phi_3209_ = _e2243;
                    } else {
                        phi_3209_ = 1f;
                    }
                    let _e2450 = phi_3209_;
                    phi_3210_ = _e2450;
                } else {
                    phi_3210_ = 0f;
                }
                let _e2452 = phi_3210_;
                if (_e2245 > 0f) {
                    if (_e2245 < 1f) {
                        phi_3220_ = _e2245;
                    } else {
                        phi_3220_ = 1f;
                    }
                    let _e2457 = phi_3220_;
                    phi_3221_ = _e2457;
                } else {
                    phi_3221_ = 0f;
                }
                let _e2459 = phi_3221_;
                if (_e2247 > 0f) {
                    if (_e2247 < 1f) {
                        phi_3231_ = _e2247;
                    } else {
                        phi_3231_ = 1f;
                    }
                    let _e2464 = phi_3231_;
                    phi_3232_ = _e2464;
                } else {
                    phi_3232_ = 0f;
                }
                let _e2466 = phi_3232_;
                let _e2469 = ((sqrt(_e2452) * 255f) + 0.5f);
                let _e2478 = ((sqrt(_e2459) * 255f) + 0.5f);
                let _e2490 = ((sqrt(_e2466) * 255f) + 0.5f);
                phi_3267_ = abi_Sample(vec3<f32>(_e1884, _e1885, _e1886), _e2249, _e1997, _e2254, _e2446, ((select(select(u32(_e2469), 0u, (_e2469 < bitcast<f32>(0u))), 4294967295u, (_e2469 > bitcast<f32>(1333788671u))) | (select(select(u32(_e2478), 0u, (_e2478 < bitcast<f32>(0u))), 4294967295u, (_e2478 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e2490), 0u, (_e2490 < bitcast<f32>(0u))), 4294967295u, (_e2490 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
            } else {
                phi_3267_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
            }
            let _e2504 = phi_3267_;
            let _e2506 = p.member.layers_behind;
            let _e2507 = (_e2506 == 0u);
            if _e2507 {
                let _e2509 = ((1f * 65535f) + 0.5f);
                phi_3948_ = u0028_abi_Sample_u0020_abi_Sight_u0029_(abi_Sample(_e2504.position, _e2504.magnitude, _e2504.normal, ((_e2504.flags & 65535u) | (select(select(u32(_e2509), 0u, (_e2509 < bitcast<f32>(0u))), 4294967295u, (_e2509 > bitcast<f32>(1333788671u))) << bitcast<u32>(16u))), _e2504.shading_normal, _e2504.albedo), _e1846);
                phi_3949_ = u0028_abi_Sample_u0020_abi_Sight_u0029_();
            } else {
                let _e2532 = ((1f - _e1844.u) - _e1844.v);
                if (_e1844.triangle < _e88) {
                } else {
                    return;
                }
                let _e2537 = triangles.member[(0u + _e1844.triangle)];
                let _e2539 = (_e2537.i0_ & 2147483647u);
                if (_e2539 < _e91) {
                } else {
                    return;
                }
                let _e2545 = vertices.member[(0u + _e2539)];
                if (_e2537.i1_ < _e91) {
                } else {
                    return;
                }
                let _e2549 = vertices.member[(0u + _e2537.i1_)];
                if (_e2537.i2_ < _e91) {
                } else {
                    return;
                }
                let _e2553 = vertices.member[(0u + _e2537.i2_)];
                let _e2554 = array<abi_Vertex, 3>(_e2545, _e2549, _e2553);
                if (_e2554[0].material < _e94) {
                } else {
                    return;
                }
                let _e2560 = materials.member[(0u + _e2554[0].material)];
                if (_e2560.cutoff <= 0f) {
                    phi_3497_ = 1f;
                } else {
                    let _e2587 = (_e2560.base_color.w * ((((f32((_e2554[0].color >> bitcast<u32>(24i))) * _e2532) + (f32((_e2554[1].color >> bitcast<u32>(24i))) * _e1844.u)) + (f32((_e2554[2].color >> bitcast<u32>(24i))) * _e1844.v)) * (1f / 255f)));
                    if (_e2560.alpha_size == 0u) {
                        phi_3473_ = _e2587;
                    } else {
                        local_2.offset = _e2560.alpha_offset;
                        local_2.size = _e2560.alpha_size;
                        local_2.flags = _e2560.flags;
                        let _e2618 = _lt_shaders_texture_TextureView_quad((&local_2), (((_e2554[0].u * _e2532) + (_e2554[1].u * _e1844.u)) + (_e2554[2].u * _e1844.v)), (((_e2554[0].v * _e2532) + (_e2554[1].v * _e1844.u)) + (_e2554[2].v * _e1844.v)));
                        let _e2622 = (_e2618.indices[0] >> bitcast<u32>(2i));
                        if (_e2622 < _e100) {
                        } else {
                            return;
                        }
                        let _e2626 = alpha_texels.member[(0u + _e2622)];
                        let _e2642 = (_e2618.indices[1] >> bitcast<u32>(2i));
                        if (_e2642 < _e100) {
                        } else {
                            return;
                        }
                        let _e2646 = alpha_texels.member[(0u + _e2642)];
                        let _e2663 = (_e2618.indices[2] >> bitcast<u32>(2i));
                        if (_e2663 < _e100) {
                        } else {
                            return;
                        }
                        let _e2667 = alpha_texels.member[(0u + _e2663)];
                        let _e2684 = (_e2618.indices[3] >> bitcast<u32>(2i));
                        if (_e2684 < _e100) {
                        } else {
                            return;
                        }
                        let _e2688 = alpha_texels.member[(0u + _e2684)];
                        phi_3473_ = (_e2587 * (((((f32(((_e2626 >> bitcast<u32>((((_e2618.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2618.weights.x) + ((f32(((_e2646 >> bitcast<u32>((((_e2618.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2618.weights.y)) + ((f32(((_e2667 >> bitcast<u32>((((_e2618.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2618.weights.z)) + ((f32(((_e2688 >> bitcast<u32>((((_e2618.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2618.weights.w)));
                    }
                    let _e2704 = phi_3473_;
                    if ((_e2560.flags & 8u) == 0u) {
                        if (_e2704 >= _e2560.cutoff) {
                            phi_3485_ = 1f;
                        } else {
                            phi_3485_ = 0f;
                        }
                        let _e2711 = phi_3485_;
                        phi_3496_ = _e2711;
                    } else {
                        if (_e2704 > 0f) {
                            if (_e2704 < 1f) {
                                phi_3494_ = _e2704;
                            } else {
                                phi_3494_ = 1f;
                            }
                            let _e2715 = phi_3494_;
                            phi_3495_ = _e2715;
                        } else {
                            phi_3495_ = 0f;
                        }
                        let _e2717 = phi_3495_;
                        phi_3496_ = _e2717;
                    }
                    let _e2719 = phi_3496_;
                    phi_3497_ = _e2719;
                }
                let _e2721 = phi_3497_;
                let _e2724 = (_e2721 * (1f - _e2560.transmission));
                if (_e2724 > 0f) {
                    if (_e2724 < 1f) {
                        phi_3509_ = _e2724;
                    } else {
                        phi_3509_ = 1f;
                    }
                    let _e2728 = phi_3509_;
                    phi_3510_ = _e2728;
                } else {
                    phi_3510_ = 0f;
                }
                let _e2730 = phi_3510_;
                if (_e2560.cutoff <= 0f) {
                    phi_3666_ = 1f;
                } else {
                    let _e2757 = (_e2560.base_color.w * ((((f32((_e2554[0].color >> bitcast<u32>(24i))) * _e2532) + (f32((_e2554[1].color >> bitcast<u32>(24i))) * _e1844.u)) + (f32((_e2554[2].color >> bitcast<u32>(24i))) * _e1844.v)) * (1f / 255f)));
                    if (_e2560.alpha_size == 0u) {
                        phi_3642_ = _e2757;
                    } else {
                        local_1.offset = _e2560.alpha_offset;
                        local_1.size = _e2560.alpha_size;
                        local_1.flags = _e2560.flags;
                        let _e2788 = _lt_shaders_texture_TextureView_quad((&local_1), (((_e2554[0].u * _e2532) + (_e2554[1].u * _e1844.u)) + (_e2554[2].u * _e1844.v)), (((_e2554[0].v * _e2532) + (_e2554[1].v * _e1844.u)) + (_e2554[2].v * _e1844.v)));
                        let _e2792 = (_e2788.indices[0] >> bitcast<u32>(2i));
                        if (_e2792 < _e100) {
                        } else {
                            return;
                        }
                        let _e2796 = alpha_texels.member[(0u + _e2792)];
                        let _e2812 = (_e2788.indices[1] >> bitcast<u32>(2i));
                        if (_e2812 < _e100) {
                        } else {
                            return;
                        }
                        let _e2816 = alpha_texels.member[(0u + _e2812)];
                        let _e2833 = (_e2788.indices[2] >> bitcast<u32>(2i));
                        if (_e2833 < _e100) {
                        } else {
                            return;
                        }
                        let _e2837 = alpha_texels.member[(0u + _e2833)];
                        let _e2854 = (_e2788.indices[3] >> bitcast<u32>(2i));
                        if (_e2854 < _e100) {
                        } else {
                            return;
                        }
                        let _e2858 = alpha_texels.member[(0u + _e2854)];
                        phi_3642_ = (_e2757 * (((((f32(((_e2796 >> bitcast<u32>((((_e2788.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2788.weights.x) + ((f32(((_e2816 >> bitcast<u32>((((_e2788.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2788.weights.y)) + ((f32(((_e2837 >> bitcast<u32>((((_e2788.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2788.weights.z)) + ((f32(((_e2858 >> bitcast<u32>((((_e2788.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2788.weights.w)));
                    }
                    let _e2874 = phi_3642_;
                    if ((_e2560.flags & 8u) == 0u) {
                        if (_e2874 >= _e2560.cutoff) {
                            phi_3654_ = 1f;
                        } else {
                            phi_3654_ = 0f;
                        }
                        let _e2881 = phi_3654_;
                        phi_3665_ = _e2881;
                    } else {
                        if (_e2874 > 0f) {
                            if (_e2874 < 1f) {
                                phi_3663_ = _e2874;
                            } else {
                                phi_3663_ = 1f;
                            }
                            let _e2885 = phi_3663_;
                            phi_3664_ = _e2885;
                        } else {
                            phi_3664_ = 0f;
                        }
                        let _e2887 = phi_3664_;
                        phi_3665_ = _e2887;
                    }
                    let _e2889 = phi_3665_;
                    phi_3666_ = _e2889;
                }
                let _e2891 = phi_3666_;
                let _e2908 = (1f / 255f);
                let _e2927 = (1f / 255f);
                let _e2949 = (1f / 255f);
                if (_e2560.color_size == 0u) {
                    phi_3865_ = vec3<f32>(1f, 1f, 1f);
                } else {
                    local.offset = _e2560.color_offset;
                    local.size = _e2560.color_size;
                    local.flags = _e2560.flags;
                    let _e2992 = _lt_shaders_texture_TextureView_quad((&local), (((_e2554[0].u * _e2532) + (_e2554[1].u * _e1844.u)) + (_e2554[2].u * _e1844.v)), (((_e2554[0].v * _e2532) + (_e2554[1].v * _e1844.u)) + (_e2554[2].v * _e1844.v)));
                    if (_e2992.indices[0] < _e103) {
                    } else {
                        return;
                    }
                    let _e2998 = color_texels.member[(0u + _e2992.indices[0])];
                    let _e3009 = (1f / 255f);
                    if (_e2992.indices[1] < _e103) {
                    } else {
                        return;
                    }
                    let _e3023 = color_texels.member[(0u + _e2992.indices[1])];
                    let _e3034 = (1f / 255f);
                    if (_e2992.indices[2] < _e103) {
                    } else {
                        return;
                    }
                    let _e3051 = color_texels.member[(0u + _e2992.indices[2])];
                    let _e3062 = (1f / 255f);
                    if (_e2992.indices[3] < _e103) {
                    } else {
                        return;
                    }
                    let _e3079 = color_texels.member[(0u + _e2992.indices[3])];
                    let _e3090 = (1f / 255f);
                    let _e3099 = (((((f32((_e2998 & 255u)) * _e3009) * _e2992.weights.x) + ((f32((_e3023 & 255u)) * _e3034) * _e2992.weights.y)) + ((f32((_e3051 & 255u)) * _e3062) * _e2992.weights.z)) + ((f32((_e3079 & 255u)) * _e3090) * _e2992.weights.w));
                    let _e3100 = (((((f32(((_e2998 >> bitcast<u32>(8i)) & 255u)) * _e3009) * _e2992.weights.x) + ((f32(((_e3023 >> bitcast<u32>(8i)) & 255u)) * _e3034) * _e2992.weights.y)) + ((f32(((_e3051 >> bitcast<u32>(8i)) & 255u)) * _e3062) * _e2992.weights.z)) + ((f32(((_e3079 >> bitcast<u32>(8i)) & 255u)) * _e3090) * _e2992.weights.w));
                    let _e3101 = (((((f32(((_e2998 >> bitcast<u32>(16i)) & 255u)) * _e3009) * _e2992.weights.x) + ((f32(((_e3023 >> bitcast<u32>(16i)) & 255u)) * _e3034) * _e2992.weights.y)) + ((f32(((_e3051 >> bitcast<u32>(16i)) & 255u)) * _e3062) * _e2992.weights.z)) + ((f32(((_e3079 >> bitcast<u32>(16i)) & 255u)) * _e3090) * _e2992.weights.w));
                    phi_3865_ = vec3<f32>((_e3099 * _e3099), (_e3100 * _e3100), (_e3101 * _e3101));
                }
                let _e3107 = phi_3865_;
                let _e3115 = (_e2891 * _e2560.transmission);
                let _e3119 = (1f - _e2891);
                let _e3120 = ((((_e2560.base_color.x * ((((f32((_e2554[0].color & 255u)) * _e2908) * _e2532) + ((f32((_e2554[1].color & 255u)) * _e2927) * _e1844.u)) + ((f32((_e2554[2].color & 255u)) * _e2949) * _e1844.v))) * _e3107.x) * _e3115) + _e3119);
                let _e3121 = ((((_e2560.base_color.y * ((((f32(((_e2554[0].color >> bitcast<u32>(8i)) & 255u)) * _e2908) * _e2532) + ((f32(((_e2554[1].color >> bitcast<u32>(8i)) & 255u)) * _e2927) * _e1844.u)) + ((f32(((_e2554[2].color >> bitcast<u32>(8i)) & 255u)) * _e2949) * _e1844.v))) * _e3107.y) * _e3115) + _e3119);
                let _e3122 = ((((_e2560.base_color.z * ((((f32(((_e2554[0].color >> bitcast<u32>(16i)) & 255u)) * _e2908) * _e2532) + ((f32(((_e2554[1].color >> bitcast<u32>(16i)) & 255u)) * _e2927) * _e1844.u)) + ((f32(((_e2554[2].color >> bitcast<u32>(16i)) & 255u)) * _e2949) * _e1844.v))) * _e3107.z) * _e3115) + _e3119);
                if (_e3120 > 0f) {
                    if (_e3120 < 1f) {
                        phi_3889_ = _e3120;
                    } else {
                        phi_3889_ = 1f;
                    }
                    let _e3126 = phi_3889_;
                    phi_3890_ = _e3126;
                } else {
                    phi_3890_ = 0f;
                }
                let _e3128 = phi_3890_;
                if (_e3121 > 0f) {
                    if (_e3121 < 1f) {
                        phi_3899_ = _e3121;
                    } else {
                        phi_3899_ = 1f;
                    }
                    let _e3132 = phi_3899_;
                    phi_3900_ = _e3132;
                } else {
                    phi_3900_ = 0f;
                }
                let _e3134 = phi_3900_;
                if (_e3122 > 0f) {
                    if (_e3122 < 1f) {
                        phi_3909_ = _e3122;
                    } else {
                        phi_3909_ = 1f;
                    }
                    let _e3138 = phi_3909_;
                    phi_3910_ = _e3138;
                } else {
                    phi_3910_ = 0f;
                }
                let _e3140 = phi_3910_;
                let _e3142 = ((_e2730 * 65535f) + 0.5f);
                phi_3948_ = u0028_abi_Sample_u0020_abi_Sight_u0029_();
                phi_3949_ = u0028_abi_Sample_u0020_abi_Sight_u0029_(abi_Sample(_e2504.position, _e2504.magnitude, _e2504.normal, ((_e2504.flags & 65535u) | (select(select(u32(_e3142), 0u, (_e3142 < bitcast<f32>(0u))), 4294967295u, (_e3142 > bitcast<f32>(1333788671u))) << bitcast<u32>(16u))), _e2504.shading_normal, _e2504.albedo), abi_Sight((vec3<f32>(1f, 1f, 1f) - vec3<f32>(((vec3<f32>(1f, 1f, 1f).x - _e120.kept.x) * _e3128), ((vec3<f32>(1f, 1f, 1f).y - _e120.kept.y) * _e3134), ((vec3<f32>(1f, 1f, 1f).z - _e120.kept.z) * _e3140))), _e1844.t));
            }
            let _e3180 = phi_3948_;
            let _e3182 = phi_3949_;
            phi_3952_ = _e3180;
            phi_3953_ = _e3182;
            phi_3954_ = _e2507;
        } else {
            phi_3952_ = u0028_abi_Sample_u0020_abi_Sight_u0029_(abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u), _e1846);
            phi_3953_ = u0028_abi_Sample_u0020_abi_Sight_u0029_();
            phi_3954_ = true;
        }
        let _e3186 = phi_3952_;
        let _e3188 = phi_3953_;
        let _e3190 = phi_3954_;
        if _e3190 {
            phi_3958_ = _e3186;
        } else {
            phi_3958_ = _e3188;
        }
        let _e3192 = phi_3958_;
        if (_e112.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e112.first_primitive)] = _e3192.unnamed;
        if (_e112.first_primitive < _e106) {
        } else {
            return;
        }
        sights.member[(0u + _e112.first_primitive)] = _e3192.unnamed_1;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_layers_layer_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
