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

struct type_30 {
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

struct type_34 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_38 {
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

struct type_42 {
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

struct abi_Sight {
    kept: vec3<f32>,
    t: f32,
}

struct type_55 {
    member: array<abi_Sight>,
}

struct type_58 {
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
var<storage> vertices: type_38;
@group(0) @binding(4) 
var<storage> materials: type_42;
@group(0) @binding(0) 
var<uniform> p: type_58;
@group(0) @binding(1) 
var<storage> nodes: type_30;
@group(0) @binding(2) 
var<storage> triangles: type_34;
@group(0) @binding(5) 
var<storage, read_write> samples: type_9;
@group(0) @binding(6) 
var<storage> alpha_texels: type_13;
@group(0) @binding(7) 
var<storage> color_texels: type_13;
@group(0) @binding(8) 
var<storage, read_write> sights: type_55;

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
        let _e88 = phi_228_;
        let _e90 = phi_229_;
        phi_230_ = _e88;
        phi_231_ = _e90;
    } else {
        phi_230_ = lt_mask_LightPlace();
        phi_231_ = true;
    }
    let _e92 = phi_230_;
    let _e94 = phi_231_;
    if _e94 {
        phi_236_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_236_ = _e92;
    }
    let _e99 = phi_236_;
    return lt_mask_LightPlace(_e99.word, _e99.shift);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_251_: bool;
    var phi_255_: f32;

    if (param_3 != param_3) {
        phi_251_ = true;
    } else {
        let _e78 = (param_4 >= param_3);
        if _e78 {
        }
        phi_251_ = _e78;
    }
    let _e80 = phi_251_;
    if _e80 {
        phi_255_ = param_4;
    } else {
        phi_255_ = param_3;
    }
    let _e82 = phi_255_;
    return _e82;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_267_: bool;
    var phi_271_: f32;

    if (param_5 != param_5) {
        phi_267_ = true;
    } else {
        let _e78 = (param_6 <= param_5);
        if _e78 {
        }
        phi_267_ = _e78;
    }
    let _e80 = phi_267_;
    if _e80 {
        phi_271_ = param_6;
    } else {
        phi_271_ = param_5;
    }
    let _e82 = phi_271_;
    return _e82;
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
                phi_313_ = 1f;
            } else {
                phi_313_ = 0f;
            }
            let _e109 = phi_313_;
            if (param_8 < 8388608f) {
                phi_318_ = (_e106 - _e109);
                phi_319_ = false;
            } else {
                phi_318_ = f32();
                phi_319_ = true;
            }
            let _e112 = phi_318_;
            let _e114 = phi_319_;
            phi_320_ = _e112;
            phi_321_ = _e114;
        } else {
            phi_320_ = f32();
            phi_321_ = true;
        }
        let _e116 = phi_320_;
        let _e118 = phi_321_;
        if _e118 {
            phi_325_ = param_8;
        } else {
            phi_325_ = _e116;
        }
        let _e120 = phi_325_;
        phi_373_ = (param_8 - _e120);
    } else {
        if (_e93 == 1u) {
            let _e123 = (param_8 * 0.5f);
            if (_e123 > -8388608f) {
                let _e135 = f32(select(0i, select(select(i32(_e123), i32(-2147483648), (_e123 < bitcast<f32>(3472883712u))), 2147483647i, (_e123 > bitcast<f32>(1325400063u))), (_e123 == _e123)));
                if (_e135 > _e123) {
                    phi_351_ = 1f;
                } else {
                    phi_351_ = 0f;
                }
                let _e138 = phi_351_;
                if (_e123 < 8388608f) {
                    phi_356_ = (_e135 - _e138);
                    phi_357_ = false;
                } else {
                    phi_356_ = f32();
                    phi_357_ = true;
                }
                let _e141 = phi_356_;
                let _e143 = phi_357_;
                phi_358_ = _e141;
                phi_359_ = _e143;
            } else {
                phi_358_ = f32();
                phi_359_ = true;
            }
            let _e145 = phi_358_;
            let _e147 = phi_359_;
            if _e147 {
                phi_363_ = _e123;
            } else {
                phi_363_ = _e145;
            }
            let _e149 = phi_363_;
            let _e151 = (param_8 - (2f * _e149));
            if (_e151 > 1f) {
                phi_371_ = (2f - _e151);
            } else {
                phi_371_ = _e151;
            }
            let _e155 = phi_371_;
            phi_372_ = _e155;
        } else {
            phi_372_ = param_8;
        }
        let _e157 = phi_372_;
        phi_373_ = _e157;
    }
    let _e159 = phi_373_;
    if (_e159 > 0f) {
        if (_e159 < 1f) {
            phi_382_ = _e159;
        } else {
            phi_382_ = 1f;
        }
        let _e163 = phi_382_;
        phi_383_ = _e163;
    } else {
        phi_383_ = 0f;
    }
    let _e165 = phi_383_;
    let _e166 = (_e80 - 1u);
    let _e168 = (_e165 * f32(_e80));
    if _e88 {
        let _e175 = select(select(u32(_e168), 0u, (_e168 < bitcast<f32>(0u))), 4294967295u, (_e168 > bitcast<f32>(1333788671u)));
        if (_e166 < _e175) {
            phi_401_ = _e166;
        } else {
            phi_401_ = _e175;
        }
        let _e178 = phi_401_;
        phi_440_ = texture_Axis(_e178, _e178, 0f);
    } else {
        let _e180 = (_e168 + 0.5f);
        let _e187 = select(select(u32(_e180), 0u, (_e180 < bitcast<f32>(0u))), 4294967295u, (_e180 > bitcast<f32>(1333788671u)));
        if (_e80 < _e187) {
            phi_415_ = _e80;
        } else {
            phi_415_ = _e187;
        }
        let _e190 = phi_415_;
        if (_e93 == 0u) {
            phi_422_ = _e166;
        } else {
            phi_422_ = 0u;
        }
        let _e195 = phi_422_;
        if (_e93 == 0u) {
            phi_427_ = 0u;
        } else {
            phi_427_ = _e166;
        }
        let _e198 = phi_427_;
        if (_e190 == 0u) {
            phi_433_ = _e195;
        } else {
            phi_433_ = (_e190 - 1u);
        }
        let _e202 = phi_433_;
        if (_e190 > _e166) {
            phi_438_ = _e198;
        } else {
            phi_438_ = _e190;
        }
        let _e205 = phi_438_;
        phi_440_ = texture_Axis(_e202, _e205, (_e180 - f32(_e190)));
    }
    let _e208 = phi_440_;
    let _e210 = (*param_7).flags;
    let _e213 = ((_e210 >> bitcast<u32>(6u)) & 3u);
    if (_e213 == 0u) {
        if (param_9 > -8388608f) {
            let _e226 = f32(select(0i, select(select(i32(param_9), i32(-2147483648), (param_9 < bitcast<f32>(3472883712u))), 2147483647i, (param_9 > bitcast<f32>(1325400063u))), (param_9 == param_9)));
            if (_e226 > param_9) {
                phi_468_ = 1f;
            } else {
                phi_468_ = 0f;
            }
            let _e229 = phi_468_;
            if (param_9 < 8388608f) {
                phi_473_ = (_e226 - _e229);
                phi_474_ = false;
            } else {
                phi_473_ = f32();
                phi_474_ = true;
            }
            let _e232 = phi_473_;
            let _e234 = phi_474_;
            phi_475_ = _e232;
            phi_476_ = _e234;
        } else {
            phi_475_ = f32();
            phi_476_ = true;
        }
        let _e236 = phi_475_;
        let _e238 = phi_476_;
        if _e238 {
            phi_480_ = param_9;
        } else {
            phi_480_ = _e236;
        }
        let _e240 = phi_480_;
        phi_528_ = (param_9 - _e240);
    } else {
        if (_e213 == 1u) {
            let _e243 = (param_9 * 0.5f);
            if (_e243 > -8388608f) {
                let _e255 = f32(select(0i, select(select(i32(_e243), i32(-2147483648), (_e243 < bitcast<f32>(3472883712u))), 2147483647i, (_e243 > bitcast<f32>(1325400063u))), (_e243 == _e243)));
                if (_e255 > _e243) {
                    phi_506_ = 1f;
                } else {
                    phi_506_ = 0f;
                }
                let _e258 = phi_506_;
                if (_e243 < 8388608f) {
                    phi_511_ = (_e255 - _e258);
                    phi_512_ = false;
                } else {
                    phi_511_ = f32();
                    phi_512_ = true;
                }
                let _e261 = phi_511_;
                let _e263 = phi_512_;
                phi_513_ = _e261;
                phi_514_ = _e263;
            } else {
                phi_513_ = f32();
                phi_514_ = true;
            }
            let _e265 = phi_513_;
            let _e267 = phi_514_;
            if _e267 {
                phi_518_ = _e243;
            } else {
                phi_518_ = _e265;
            }
            let _e269 = phi_518_;
            let _e271 = (param_9 - (2f * _e269));
            if (_e271 > 1f) {
                phi_526_ = (2f - _e271);
            } else {
                phi_526_ = _e271;
            }
            let _e275 = phi_526_;
            phi_527_ = _e275;
        } else {
            phi_527_ = param_9;
        }
        let _e277 = phi_527_;
        phi_528_ = _e277;
    }
    let _e279 = phi_528_;
    if (_e279 > 0f) {
        if (_e279 < 1f) {
            phi_537_ = _e279;
        } else {
            phi_537_ = 1f;
        }
        let _e283 = phi_537_;
        phi_538_ = _e283;
    } else {
        phi_538_ = 0f;
    }
    let _e285 = phi_538_;
    let _e286 = (_e84 - 1u);
    let _e288 = (_e285 * f32(_e84));
    if _e88 {
        let _e295 = select(select(u32(_e288), 0u, (_e288 < bitcast<f32>(0u))), 4294967295u, (_e288 > bitcast<f32>(1333788671u)));
        if (_e286 < _e295) {
            phi_556_ = _e286;
        } else {
            phi_556_ = _e295;
        }
        let _e298 = phi_556_;
        phi_595_ = texture_Axis(_e298, _e298, 0f);
    } else {
        let _e300 = (_e288 + 0.5f);
        let _e307 = select(select(u32(_e300), 0u, (_e300 < bitcast<f32>(0u))), 4294967295u, (_e300 > bitcast<f32>(1333788671u)));
        if (_e84 < _e307) {
            phi_570_ = _e84;
        } else {
            phi_570_ = _e307;
        }
        let _e310 = phi_570_;
        if (_e213 == 0u) {
            phi_577_ = _e286;
        } else {
            phi_577_ = 0u;
        }
        let _e315 = phi_577_;
        if (_e213 == 0u) {
            phi_582_ = 0u;
        } else {
            phi_582_ = _e286;
        }
        let _e318 = phi_582_;
        if (_e310 == 0u) {
            phi_588_ = _e315;
        } else {
            phi_588_ = (_e310 - 1u);
        }
        let _e322 = phi_588_;
        if (_e310 > _e286) {
            phi_593_ = _e318;
        } else {
            phi_593_ = _e310;
        }
        let _e325 = phi_593_;
        phi_595_ = texture_Axis(_e322, _e325, (_e300 - f32(_e310)));
    }
    let _e328 = phi_595_;
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
    var phi_654_: f32;

    if (param_12 > param_13) {
        phi_654_ = param_12;
    } else {
        phi_654_ = param_13;
    }
    let _e79 = phi_654_;
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
    var phi_729_: bool;
    var phi_730_: bool;
    var phi_731_: bool;
    var phi_735_: bool;
    var phi_835_: bool;
    var phi_836_: bool;
    var phi_837_: bool;
    var phi_838_: bool;
    var phi_842_: bool;
    var phi_855_: bool;
    var phi_856_: bool;
    var phi_857_: bool;
    var phi_858_: bool;
    var phi_862_: bool;
    var phi_875_: bool;
    var phi_876_: bool;
    var phi_877_: bool;
    var phi_881_: bool;
    var phi_882_: bool;
    var phi_883_: bool;
    var phi_884_: bool;
    var phi_885_: bool;
    var phi_889_: bool;
    var phi_963_: f32;
    var phi_970_: f32;
    var phi_978_: f32;
    var phi_985_: f32;
    var phi_993_: f32;
    var phi_1000_: f32;
    var phi_1023_: f32;
    var phi_1028_: f32;
    var phi_1033_: f32;
    var phi_1038_: f32;
    var phi_1043_: f32;
    var phi_1072_: bool;
    var phi_1073_: bool;
    var phi_1081_: u32;
    var phi_1082_: u32;
    var phi_1099_: vec3<f32>;
    var phi_1100_: vec3<f32>;
    var phi_1113_: u32;
    var phi_1118_: u32;
    var phi_1123_: u32;
    var phi_1237_: bool;
    var phi_1238_: bool;
    var phi_1269_: u32;
    var phi_1271_: lt_bvh_Hit;
    var phi_1274_: u32;
    var phi_1358_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1385_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1412_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1418_: u32;
    var phi_1421_: u32;
    var phi_1435_: u32;
    var phi_1445_: u32;
    var phi_1455_: u32;
    var phi_1473_: u32;
    var phi_1483_: u32;
    var phi_1493_: u32;
    var phi_1529_: u32;
    var phi_1542_: u32;
    var phi_1547_: u32;
    var phi_1548_: u32;
    var phi_1549_: u32;
    var phi_1419_: u32;
    var phi_1422_: u32;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_1607_: lt_bvh_Hit;
    var phi_1610_: u32;
    var phi_1656_: vec3<f32>;
    var phi_1657_: vec3<f32>;
    var phi_1688_: vec3<f32>;
    var phi_1689_: vec3<f32>;
    var phi_1720_: vec3<f32>;
    var phi_1721_: vec3<f32>;
    var phi_1739_: bool;
    var phi_1740_: bool;
    var phi_1744_: f32;
    var phi_1745_: f32;
    var phi_1746_: f32;
    var phi_1747_: f32;
    var phi_1755_: f32;
    var phi_1765_: bool;
    var phi_1766_: bool;
    var phi_1770_: f32;
    var phi_1771_: f32;
    var phi_1772_: f32;
    var phi_1773_: f32;
    var phi_1781_: f32;
    var phi_1791_: bool;
    var phi_1792_: bool;
    var phi_1796_: f32;
    var phi_1797_: f32;
    var phi_1798_: f32;
    var phi_1799_: f32;
    var phi_1807_: f32;
    var phi_1822_: f32;
    var phi_1823_: bool;
    var phi_1824_: f32;
    var phi_1825_: bool;
    var phi_1826_: f32;
    var phi_1827_: bool;
    var phi_1845_: f32;
    var phi_1846_: bool;
    var phi_1847_: bool;
    var phi_1848_: f32;
    var phi_1849_: bool;
    var phi_1850_: bool;
    var phi_1854_: bool;
    var phi_1855_: f32;
    var phi_1856_: bool;
    var phi_1886_: vec3<f32>;
    var phi_1887_: vec3<f32>;
    var phi_1912_: vec3<f32>;
    var phi_1913_: vec3<f32>;
    var phi_1938_: vec3<f32>;
    var phi_1939_: vec3<f32>;
    var phi_1995_: f32;
    var phi_2004_: f32;
    var phi_2013_: f32;
    var phi_2022_: f32;
    var phi_2029_: f32;
    var phi_2036_: f32;
    var phi_2049_: f32;
    var phi_2058_: f32;
    var phi_2067_: f32;
    var phi_2076_: f32;
    var phi_2083_: f32;
    var phi_2090_: f32;
    var phi_2113_: f32;
    var phi_2118_: f32;
    var phi_2123_: f32;
    var phi_2131_: f32;
    var phi_2136_: f32;
    var phi_2141_: f32;
    var phi_2153_: f32;
    var phi_2158_: f32;
    var phi_2163_: f32;
    var phi_2168_: f32;
    var phi_2173_: lt_bvh_triangle_Intersection;
    var phi_2174_: bool;
    var phi_2175_: lt_bvh_triangle_Intersection;
    var phi_2176_: bool;
    var phi_2180_: lt_bvh_triangle_Intersection;
    var phi_2181_: bool;
    var phi_2182_: lt_bvh_triangle_Intersection;
    var phi_2183_: bool;
    var phi_2184_: bool;
    var phi_2188_: bool;
    var phi_2192_: lt_bvh_triangle_Intersection;
    var phi_2230_: bool;
    var phi_2231_: bool;
    var phi_2232_: bool;
    var phi_2233_: bool;
    var phi_2234_: bool;
    var phi_2235_: bool;
    var phi_2239_: bool;
    var phi_2240_: bool;
    var phi_2443_: f32;
    var phi_2446_: bool;
    var phi_2447_: bool;
    var phi_2451_: bool;
    var phi_2459_: lt_bvh_Hit;
    var phi_2460_: lt_bvh_Hit;
    var phi_2461_: lt_bvh_Hit;
    var phi_2462_: lt_bvh_Hit;
    var phi_1608_: lt_bvh_Hit;
    var phi_1611_: u32;
    var phi_2463_: bool;
    var phi_2502_: bool;
    var phi_2503_: bool;
    var phi_2534_: u32;
    var phi_1272_: lt_bvh_Hit;
    var phi_1275_: u32;
    var phi_2535_: lt_bvh_Hit;
    var phi_2536_: lt_bvh_Hit;
    var phi_2537_: bool;
    var phi_2541_: lt_bvh_Hit;
    var phi_2543_: lt_bvh_Hit;
    var phi_2630_: f32;
    var phi_2635_: f32;
    var phi_2640_: f32;
    var phi_2651_: f32;
    var phi_2656_: f32;
    var phi_2661_: f32;
    var phi_2737_: vec3<f32>;
    var phi_2980_: vec3<f32>;
    var phi_2995_: u32;
    var phi_3022_: f32;
    var phi_3029_: f32;
    var phi_3036_: f32;
    var phi_3071_: f32;
    var phi_3078_: f32;
    var phi_3085_: f32;
    var phi_3123_: f32;
    var phi_3130_: f32;
    var phi_3137_: f32;
    var phi_3196_: vec3<f32>;
    var phi_3197_: vec3<f32>;
    var phi_3198_: vec3<f32>;
    var phi_3207_: f32;
    var phi_3208_: f32;
    var phi_3218_: f32;
    var phi_3219_: f32;
    var phi_3229_: f32;
    var phi_3230_: f32;
    var phi_3265_: abi_Sample;
    var phi_3471_: f32;
    var phi_3483_: f32;
    var phi_3492_: f32;
    var phi_3493_: f32;
    var phi_3494_: f32;
    var phi_3495_: f32;
    var phi_3507_: f32;
    var phi_3508_: f32;
    var phi_3640_: f32;
    var phi_3652_: f32;
    var phi_3661_: f32;
    var phi_3662_: f32;
    var phi_3663_: f32;
    var phi_3664_: f32;
    var phi_3863_: vec3<f32>;
    var phi_3887_: f32;
    var phi_3888_: f32;
    var phi_3897_: f32;
    var phi_3898_: f32;
    var phi_3907_: f32;
    var phi_3908_: f32;
    var phi_3946_: u0028_abi_Sample_u0020_abi_Sight_u0029_;
    var phi_3947_: u0028_abi_Sample_u0020_abi_Sight_u0029_;
    var phi_3950_: u0028_abi_Sample_u0020_abi_Sight_u0029_;
    var phi_3951_: u0028_abi_Sample_u0020_abi_Sight_u0029_;
    var phi_3952_: bool;
    var phi_3956_: u0028_abi_Sample_u0020_abi_Sight_u0029_;
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
    if (bitcast<i32>(_e112.word) != 0i) {
        if (_e112.shift < _e106) {
        } else {
            return;
        }
        let _e120 = sights.member[(0u + _e112.shift)];
        if (_e120.kept.x < 1f) {
            phi_730_ = bool();
            phi_731_ = true;
        } else {
            let _e128 = (_e120.kept.y < 1f);
            if _e128 {
                phi_729_ = bool();
            } else {
                phi_729_ = (_e120.kept.z < 1f);
            }
            let _e133 = phi_729_;
            phi_730_ = _e133;
            phi_731_ = _e128;
        }
        let _e135 = phi_730_;
        let _e137 = phi_731_;
        if _e137 {
            phi_735_ = true;
        } else {
            phi_735_ = _e135;
        }
        let _e139 = phi_735_;
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
                    phi_835_ = (abs(_e206.origin.z) < 1000000000000000f);
                    phi_836_ = false;
                } else {
                    phi_835_ = bool();
                    phi_836_ = true;
                }
                let _e227 = phi_835_;
                let _e229 = phi_836_;
                phi_837_ = _e227;
                phi_838_ = _e229;
            } else {
                phi_837_ = bool();
                phi_838_ = true;
            }
            let _e231 = phi_837_;
            let _e233 = phi_838_;
            if _e233 {
                phi_842_ = false;
            } else {
                phi_842_ = _e231;
            }
            let _e235 = phi_842_;
            if _e235 {
                if (_e212 < 1000000000000000f) {
                    if (_e214 < 1000000000000000f) {
                        phi_855_ = (_e216 < 1000000000000000f);
                        phi_856_ = false;
                    } else {
                        phi_855_ = bool();
                        phi_856_ = true;
                    }
                    let _e240 = phi_855_;
                    let _e242 = phi_856_;
                    phi_857_ = _e240;
                    phi_858_ = _e242;
                } else {
                    phi_857_ = bool();
                    phi_858_ = true;
                }
                let _e244 = phi_857_;
                let _e246 = phi_858_;
                if _e246 {
                    phi_862_ = false;
                } else {
                    phi_862_ = _e244;
                }
                let _e248 = phi_862_;
                if _e248 {
                    if (_e212 > 0f) {
                        phi_876_ = bool();
                        phi_877_ = true;
                    } else {
                        let _e250 = (_e214 > 0f);
                        if _e250 {
                            phi_875_ = bool();
                        } else {
                            phi_875_ = (_e216 > 0f);
                        }
                        let _e253 = phi_875_;
                        phi_876_ = _e253;
                        phi_877_ = _e250;
                    }
                    let _e255 = phi_876_;
                    let _e257 = phi_877_;
                    if _e257 {
                        phi_881_ = true;
                    } else {
                        phi_881_ = _e255;
                    }
                    let _e259 = phi_881_;
                    phi_882_ = _e259;
                    phi_883_ = false;
                } else {
                    phi_882_ = bool();
                    phi_883_ = true;
                }
                let _e261 = phi_882_;
                let _e263 = phi_883_;
                phi_884_ = _e261;
                phi_885_ = _e263;
            } else {
                phi_884_ = bool();
                phi_885_ = true;
            }
            let _e265 = phi_884_;
            let _e267 = phi_885_;
            if _e267 {
                phi_889_ = false;
            } else {
                phi_889_ = _e265;
            }
            let _e269 = phi_889_;
            if _e269 {
                let _e270 = (0u >= _e85);
                if _e270 {
                    phi_2535_ = lt_bvh_Hit();
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
                        phi_963_ = _e339;
                    } else {
                        phi_963_ = abs(_e206.direction.x);
                    }
                    let _e345 = phi_963_;
                    if (_e206.direction.x < 0f) {
                        phi_970_ = (-1f / _e345);
                    } else {
                        phi_970_ = (1f / _e345);
                    }
                    let _e350 = phi_970_;
                    if (abs(_e206.direction.y) < _e339) {
                        phi_978_ = _e339;
                    } else {
                        phi_978_ = abs(_e206.direction.y);
                    }
                    let _e356 = phi_978_;
                    if (_e206.direction.y < 0f) {
                        phi_985_ = (-1f / _e356);
                    } else {
                        phi_985_ = (1f / _e356);
                    }
                    let _e361 = phi_985_;
                    if (abs(_e206.direction.z) < _e339) {
                        phi_993_ = _e339;
                    } else {
                        phi_993_ = abs(_e206.direction.z);
                    }
                    let _e367 = phi_993_;
                    if (_e206.direction.z < 0f) {
                        phi_1000_ = (-1f / _e367);
                    } else {
                        phi_1000_ = (1f / _e367);
                    }
                    let _e372 = phi_1000_;
                    let _e379 = abs((bitcast<f32>(_e276) - _e206.origin.x));
                    let _e380 = abs((bitcast<f32>(_e280) - _e206.origin.y));
                    let _e381 = abs((bitcast<f32>(_e284) - _e206.origin.z));
                    let _e388 = abs(((bitcast<f32>(_e288) + (bitcast<f32>((((_e300 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e206.origin.x));
                    let _e389 = abs(((bitcast<f32>(_e292) + (bitcast<f32>((((_e300 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e206.origin.y));
                    let _e390 = abs(((bitcast<f32>(_e296) + (bitcast<f32>((((_e300 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e206.origin.z));
                    if (_e379 > _e388) {
                        phi_1023_ = _e379;
                    } else {
                        phi_1023_ = _e388;
                    }
                    let _e393 = phi_1023_;
                    if (_e380 > _e389) {
                        phi_1028_ = _e380;
                    } else {
                        phi_1028_ = _e389;
                    }
                    let _e396 = phi_1028_;
                    if (_e381 > _e390) {
                        phi_1033_ = _e381;
                    } else {
                        phi_1033_ = _e390;
                    }
                    let _e399 = phi_1033_;
                    if (_e393 > _e396) {
                        phi_1038_ = _e393;
                    } else {
                        phi_1038_ = _e396;
                    }
                    let _e402 = phi_1038_;
                    if (_e402 > _e399) {
                        phi_1043_ = _e402;
                    } else {
                        phi_1043_ = _e399;
                    }
                    let _e405 = phi_1043_;
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
                            phi_1072_ = false;
                        } else {
                            phi_1072_ = true;
                        }
                        let _e429 = phi_1072_;
                        phi_1073_ = _e429;
                    } else {
                        phi_1073_ = true;
                    }
                    let _e431 = phi_1073_;
                    if _e431 {
                        if (_e423 >= _e425) {
                            phi_1081_ = 1u;
                        } else {
                            phi_1081_ = 2u;
                        }
                        let _e434 = phi_1081_;
                        phi_1082_ = _e434;
                    } else {
                        phi_1082_ = 0u;
                    }
                    let _e436 = phi_1082_;
                    if (_e436 == 0u) {
                        phi_1100_ = vec3<f32>(_e206.direction.y, _e206.direction.z, _e206.direction.x);
                    } else {
                        if (_e436 == 1u) {
                            phi_1099_ = vec3<f32>(_e206.direction.z, _e206.direction.x, _e206.direction.y);
                        } else {
                            phi_1099_ = _e206.direction;
                        }
                        let _e448 = phi_1099_;
                        phi_1100_ = _e448;
                    }
                    let _e450 = phi_1100_;
                    let _e453 = (_e450.x / _e450.z);
                    let _e456 = (_e450.y / _e450.z);
                    if (_e350 < 0f) {
                        phi_1113_ = 0u;
                    } else {
                        phi_1113_ = 1u;
                    }
                    let _e461 = phi_1113_;
                    if (_e361 < 0f) {
                        phi_1118_ = 0u;
                    } else {
                        phi_1118_ = 2u;
                    }
                    let _e464 = phi_1118_;
                    if (_e372 < 0f) {
                        phi_1123_ = 0u;
                    } else {
                        phi_1123_ = 4u;
                    }
                    let _e467 = phi_1123_;
                    let _e469 = ((_e461 | _e464) | _e467);
                    let _e470 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                    local_5 = lt_bvh_traverse_Stack(array<u32, 32>(_e470.first[0], _e470.first[1], _e470.first[2], _e470.first[3], _e470.first[4], _e470.first[5], _e470.first[6], _e470.first[7], _e470.first[8], _e470.first[9], _e470.first[10], _e470.first[11], _e470.first[12], _e470.first[13], _e470.first[14], _e470.first[15], _e470.first[16], _e470.first[17], _e470.first[18], _e470.first[19], _e470.first[20], _e470.first[21], _e470.first[22], _e470.first[23], _e470.first[24], _e470.first[25], _e470.first[26], _e470.first[27], _e470.first[28], _e470.first[29], _e470.first[30], _e470.first[31]), array<u32, 32>(_e470.mask[0], _e470.mask[1], _e470.mask[2], _e470.mask[3], _e470.mask[4], _e470.mask[5], _e470.mask[6], _e470.mask[7], _e470.mask[8], _e470.mask[9], _e470.mask[10], _e470.mask[11], _e470.mask[12], _e470.mask[13], _e470.mask[14], _e470.mask[15], _e470.mask[16], _e470.mask[17], _e470.mask[18], _e470.mask[19], _e470.mask[20], _e470.mask[21], _e470.mask[22], _e470.mask[23], _e470.mask[24], _e470.mask[25], _e470.mask[26], _e470.mask[27], _e470.mask[28], _e470.mask[29], _e470.mask[30], _e470.mask[31]), _e470.len, _e470.group, _e470.group_mask);
                    let _e544 = local_5.group_mask;
                    if ((_e544 & 4278190080u) == 0u) {
                        let _e548 = local_5.len;
                        if (_e548 == 0u) {
                            phi_1237_ = false;
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
                            phi_1237_ = true;
                        }
                        let _e571 = phi_1237_;
                        phi_1238_ = _e571;
                    } else {
                        phi_1238_ = true;
                    }
                    let _e573 = phi_1238_;
                    if _e573 {
                        let _e575 = local_5.group_mask;
                        let _e581 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e575)), 32u, (_e575 == 0u)));
                        let _e585 = local_5.group_mask;
                        let _e599 = local_5.group_mask;
                        local_5.group_mask = (_e599 & ~((1u << bitcast<u32>((_e581 & 31u)))));
                        let _e602 = local_5.group;
                        phi_1269_ = (_e602 + countOneBits(((_e585 & ~((4294967295u << bitcast<u32>((((_e581 - 24u) ^ 7u) & 31u))))) & 255u)));
                    } else {
                        phi_1269_ = 4294967295u;
                    }
                    let _e605 = phi_1269_;
                    phi_1271_ = _e210;
                    phi_1274_ = _e605;
                    loop {
                        let _e607 = phi_1271_;
                        let _e609 = phi_1274_;
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
                                let _e684 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e673.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e690 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e684.unnamed.word, _e673.w), _e684.unnamed_1);
                                let _e696 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e690.unnamed, lt_mask_LightPlace(_e673.x, _e690.unnamed_1.shift));
                                phi_1358_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e696.unnamed, lt_mask_LightPlace(_e696.unnamed_1.word, _e673.y));
                            } else {
                                let _e712 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e673.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e718 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e712.unnamed.word, _e673.y), _e712.unnamed_1);
                                let _e724 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e718.unnamed, lt_mask_LightPlace(_e673.z, _e718.unnamed_1.shift));
                                phi_1358_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e724.unnamed, lt_mask_LightPlace(_e724.unnamed_1.word, _e673.w));
                            }
                            let _e732 = phi_1358_;
                            let _e742 = nodes.member[(0u + _e609)].y;
                            if (_e361 < 0f) {
                                let _e753 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e742.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e759 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e753.unnamed.word, _e742.w), _e753.unnamed_1);
                                let _e765 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e759.unnamed, lt_mask_LightPlace(_e742.x, _e759.unnamed_1.shift));
                                phi_1385_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e765.unnamed, lt_mask_LightPlace(_e765.unnamed_1.word, _e742.y));
                            } else {
                                let _e781 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e742.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e787 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e781.unnamed.word, _e742.y), _e781.unnamed_1);
                                let _e793 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e787.unnamed, lt_mask_LightPlace(_e742.z, _e787.unnamed_1.shift));
                                phi_1385_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e793.unnamed, lt_mask_LightPlace(_e793.unnamed_1.word, _e742.w));
                            }
                            let _e801 = phi_1385_;
                            let _e811 = nodes.member[(0u + _e609)].z;
                            if (_e372 < 0f) {
                                let _e822 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e811.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e828 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e822.unnamed.word, _e811.w), _e822.unnamed_1);
                                let _e834 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e828.unnamed, lt_mask_LightPlace(_e811.x, _e828.unnamed_1.shift));
                                phi_1412_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e834.unnamed, lt_mask_LightPlace(_e834.unnamed_1.word, _e811.y));
                            } else {
                                let _e850 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e811.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e856 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e850.unnamed.word, _e811.y), _e850.unnamed_1);
                                let _e862 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e856.unnamed, lt_mask_LightPlace(_e811.z, _e856.unnamed_1.shift));
                                phi_1412_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e862.unnamed, lt_mask_LightPlace(_e862.unnamed_1.word, _e811.w));
                            }
                            let _e870 = phi_1412_;
                            phi_1418_ = 0u;
                            phi_1421_ = 0u;
                            loop {
                                let _e880 = phi_1418_;
                                let _e882 = phi_1421_;
                                local_6 = _e882;
                                local_7 = _e882;
                                local_8 = _e882;
                                let _e883 = (_e880 < 8u);
                                if _e883 {
                                    let _e885 = (_e880 >> bitcast<u32>(2i));
                                    let _e886 = (_e880 & 3u);
                                    if (_e885 == 0u) {
                                        phi_1435_ = _e732.unnamed.word;
                                    } else {
                                        phi_1435_ = _e732.unnamed.shift;
                                    }
                                    let _e889 = phi_1435_;
                                    if (_e885 == 0u) {
                                        phi_1445_ = _e801.unnamed.word;
                                    } else {
                                        phi_1445_ = _e801.unnamed.shift;
                                    }
                                    let _e898 = phi_1445_;
                                    if (_e885 == 0u) {
                                        phi_1455_ = _e870.unnamed.word;
                                    } else {
                                        phi_1455_ = _e870.unnamed.shift;
                                    }
                                    let _e907 = phi_1455_;
                                    let _e920 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e889 >> bitcast<u32>(((_e886 * 8u) & 31u))) & 255u)) * _e642) + (_e663 - _e410)), ((f32(((_e898 >> bitcast<u32>(((_e886 * 8u) & 31u))) & 255u)) * _e643) + (_e664 - _e411)));
                                    let _e921 = core_intrinsics_maximum_number_nsz_f32_(_e920, ((f32(((_e907 >> bitcast<u32>(((_e886 * 8u) & 31u))) & 255u)) * _e644) + (_e665 - _e412)));
                                    if (_e885 == 0u) {
                                        phi_1473_ = _e732.unnamed_1.word;
                                    } else {
                                        phi_1473_ = _e732.unnamed_1.shift;
                                    }
                                    let _e924 = phi_1473_;
                                    if (_e885 == 0u) {
                                        phi_1483_ = _e801.unnamed_1.word;
                                    } else {
                                        phi_1483_ = _e801.unnamed_1.shift;
                                    }
                                    let _e933 = phi_1483_;
                                    if (_e885 == 0u) {
                                        phi_1493_ = _e870.unnamed_1.word;
                                    } else {
                                        phi_1493_ = _e870.unnamed_1.shift;
                                    }
                                    let _e942 = phi_1493_;
                                    let _e955 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e924 >> bitcast<u32>(((_e886 * 8u) & 31u))) & 255u)) * _e642) + (_e663 + _e410)), ((f32(((_e933 >> bitcast<u32>(((_e886 * 8u) & 31u))) & 255u)) * _e643) + (_e664 + _e411)));
                                    let _e956 = core_intrinsics_minimum_number_nsz_f32_(_e955, ((f32(((_e942 >> bitcast<u32>(((_e886 * 8u) & 31u))) & 255u)) * _e644) + (_e665 + _e412)));
                                    if (_e921 <= _e956) {
                                        if (_e921 <= _e607.t) {
                                            if (_e956 >= _e120.t) {
                                                if (_e885 == 0u) {
                                                    let _e963 = nodes.member[(0u + _e609)].links[2u];
                                                    phi_1529_ = _e963;
                                                } else {
                                                    let _e966 = nodes.member[(0u + _e609)].links[3u];
                                                    phi_1529_ = _e966;
                                                }
                                                let _e968 = phi_1529_;
                                                let _e973 = ((_e968 >> bitcast<u32>(((_e886 * 8u) & 31u))) & 255u);
                                                let _e974 = (_e973 & 31u);
                                                if (_e974 >= 24u) {
                                                    phi_1542_ = (24u + ((_e974 - 24u) ^ _e469));
                                                } else {
                                                    phi_1542_ = _e974;
                                                }
                                                let _e980 = phi_1542_;
                                                phi_1547_ = (_e882 | ((_e973 >> bitcast<u32>(5i)) << bitcast<u32>((_e980 & 31u))));
                                            } else {
                                                phi_1547_ = _e882;
                                            }
                                            let _e988 = phi_1547_;
                                            phi_1548_ = _e988;
                                        } else {
                                            phi_1548_ = _e882;
                                        }
                                        let _e990 = phi_1548_;
                                        phi_1549_ = _e990;
                                    } else {
                                        phi_1549_ = _e882;
                                    }
                                    let _e992 = phi_1549_;
                                    phi_1419_ = (_e880 + 1u);
                                    phi_1422_ = _e992;
                                } else {
                                    phi_1419_ = u32();
                                    phi_1422_ = u32();
                                }
                                let _e995 = phi_1419_;
                                let _e997 = phi_1422_;
                                continue;
                                continuing {
                                    phi_1418_ = _e995;
                                    phi_1421_ = _e997;
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
                            phi_1607_ = _e607;
                            phi_1610_ = (_e1046 & 16777215u);
                            loop {
                                let _e1049 = phi_1607_;
                                let _e1051 = phi_1610_;
                                local_9 = _e1049;
                                if (_e1051 == 0u) {
                                    phi_1608_ = lt_bvh_Hit();
                                    phi_1611_ = u32();
                                    phi_2463_ = false;
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
                                        phi_1657_ = vec3<f32>(_e1073, _e1076, _e1070);
                                    } else {
                                        if (_e436 == 1u) {
                                            phi_1656_ = vec3<f32>(_e1076, _e1070, _e1073);
                                        } else {
                                            phi_1656_ = (_e1067 - _e206.origin);
                                        }
                                        let _e1083 = phi_1656_;
                                        phi_1657_ = _e1083;
                                    }
                                    let _e1085 = phi_1657_;
                                    let _e1089 = (_e1085.x - (_e453 * _e1085.z));
                                    let _e1093 = (_e1085.y - (_e456 * _e1085.z));
                                    let _e1095 = triangles.member[(0u + _e1060)].v1_;
                                    let _e1098 = (_e1095.x - _e206.origin.x);
                                    let _e1101 = (_e1095.y - _e206.origin.y);
                                    let _e1104 = (_e1095.z - _e206.origin.z);
                                    if (_e436 == 0u) {
                                        phi_1689_ = vec3<f32>(_e1101, _e1104, _e1098);
                                    } else {
                                        if (_e436 == 1u) {
                                            phi_1688_ = vec3<f32>(_e1104, _e1098, _e1101);
                                        } else {
                                            phi_1688_ = (_e1095 - _e206.origin);
                                        }
                                        let _e1111 = phi_1688_;
                                        phi_1689_ = _e1111;
                                    }
                                    let _e1113 = phi_1689_;
                                    let _e1117 = (_e1113.x - (_e453 * _e1113.z));
                                    let _e1121 = (_e1113.y - (_e456 * _e1113.z));
                                    let _e1123 = triangles.member[(0u + _e1060)].v2_;
                                    let _e1126 = (_e1123.x - _e206.origin.x);
                                    let _e1129 = (_e1123.y - _e206.origin.y);
                                    let _e1132 = (_e1123.z - _e206.origin.z);
                                    if (_e436 == 0u) {
                                        phi_1721_ = vec3<f32>(_e1129, _e1132, _e1126);
                                    } else {
                                        if (_e436 == 1u) {
                                            phi_1720_ = vec3<f32>(_e1132, _e1126, _e1129);
                                        } else {
                                            phi_1720_ = (_e1123 - _e206.origin);
                                        }
                                        let _e1139 = phi_1720_;
                                        phi_1721_ = _e1139;
                                    }
                                    let _e1141 = phi_1721_;
                                    let _e1145 = (_e1141.x - (_e453 * _e1141.z));
                                    let _e1149 = (_e1141.y - (_e456 * _e1141.z));
                                    if (_e1117 < _e1145) {
                                        phi_1740_ = true;
                                    } else {
                                        if (_e1117 == _e1145) {
                                            phi_1739_ = (_e1121 < _e1149);
                                        } else {
                                            phi_1739_ = false;
                                        }
                                        let _e1154 = phi_1739_;
                                        phi_1740_ = _e1154;
                                    }
                                    let _e1156 = phi_1740_;
                                    if _e1156 {
                                        phi_1744_ = _e1149;
                                        phi_1745_ = _e1145;
                                        phi_1746_ = _e1121;
                                        phi_1747_ = _e1117;
                                    } else {
                                        phi_1744_ = _e1121;
                                        phi_1745_ = _e1117;
                                        phi_1746_ = _e1149;
                                        phi_1747_ = _e1145;
                                    }
                                    let _e1158 = phi_1744_;
                                    let _e1160 = phi_1745_;
                                    let _e1162 = phi_1746_;
                                    let _e1164 = phi_1747_;
                                    let _e1167 = ((_e1164 * _e1158) - (_e1162 * _e1160));
                                    if _e1156 {
                                        phi_1755_ = -(_e1167);
                                    } else {
                                        phi_1755_ = _e1167;
                                    }
                                    let _e1170 = phi_1755_;
                                    if (_e1145 < _e1089) {
                                        phi_1766_ = true;
                                    } else {
                                        if (_e1145 == _e1089) {
                                            phi_1765_ = (_e1149 < _e1093);
                                        } else {
                                            phi_1765_ = false;
                                        }
                                        let _e1175 = phi_1765_;
                                        phi_1766_ = _e1175;
                                    }
                                    let _e1177 = phi_1766_;
                                    if _e1177 {
                                        phi_1770_ = _e1093;
                                        phi_1771_ = _e1089;
                                        phi_1772_ = _e1149;
                                        phi_1773_ = _e1145;
                                    } else {
                                        phi_1770_ = _e1149;
                                        phi_1771_ = _e1145;
                                        phi_1772_ = _e1093;
                                        phi_1773_ = _e1089;
                                    }
                                    let _e1179 = phi_1770_;
                                    let _e1181 = phi_1771_;
                                    let _e1183 = phi_1772_;
                                    let _e1185 = phi_1773_;
                                    let _e1188 = ((_e1185 * _e1179) - (_e1183 * _e1181));
                                    if _e1177 {
                                        phi_1781_ = -(_e1188);
                                    } else {
                                        phi_1781_ = _e1188;
                                    }
                                    let _e1191 = phi_1781_;
                                    if (_e1089 < _e1117) {
                                        phi_1792_ = true;
                                    } else {
                                        if (_e1089 == _e1117) {
                                            phi_1791_ = (_e1093 < _e1121);
                                        } else {
                                            phi_1791_ = false;
                                        }
                                        let _e1196 = phi_1791_;
                                        phi_1792_ = _e1196;
                                    }
                                    let _e1198 = phi_1792_;
                                    if _e1198 {
                                        phi_1796_ = _e1121;
                                        phi_1797_ = _e1117;
                                        phi_1798_ = _e1093;
                                        phi_1799_ = _e1089;
                                    } else {
                                        phi_1796_ = _e1093;
                                        phi_1797_ = _e1089;
                                        phi_1798_ = _e1121;
                                        phi_1799_ = _e1117;
                                    }
                                    let _e1200 = phi_1796_;
                                    let _e1202 = phi_1797_;
                                    let _e1204 = phi_1798_;
                                    let _e1206 = phi_1799_;
                                    let _e1209 = ((_e1206 * _e1200) - (_e1204 * _e1202));
                                    if _e1198 {
                                        phi_1807_ = -(_e1209);
                                    } else {
                                        phi_1807_ = _e1209;
                                    }
                                    let _e1212 = phi_1807_;
                                    if (_e1170 >= 0f) {
                                        if (_e1191 >= 0f) {
                                            if (_e1212 >= 0f) {
                                                phi_1822_ = ((_e1170 + _e1191) + _e1212);
                                                phi_1823_ = false;
                                            } else {
                                                phi_1822_ = f32();
                                                phi_1823_ = true;
                                            }
                                            let _e1219 = phi_1822_;
                                            let _e1221 = phi_1823_;
                                            phi_1824_ = _e1219;
                                            phi_1825_ = _e1221;
                                        } else {
                                            phi_1824_ = f32();
                                            phi_1825_ = true;
                                        }
                                        let _e1223 = phi_1824_;
                                        let _e1225 = phi_1825_;
                                        phi_1826_ = _e1223;
                                        phi_1827_ = _e1225;
                                    } else {
                                        phi_1826_ = f32();
                                        phi_1827_ = true;
                                    }
                                    let _e1227 = phi_1826_;
                                    let _e1229 = phi_1827_;
                                    if _e1229 {
                                        if (_e1170 <= 0f) {
                                            if (_e1191 <= 0f) {
                                                let _e1232 = (_e1212 <= 0f);
                                                if _e1232 {
                                                }
                                                phi_1845_ = ((_e1170 + _e1191) + _e1212);
                                                phi_1846_ = false;
                                                phi_1847_ = _e1232;
                                            } else {
                                                phi_1845_ = f32();
                                                phi_1846_ = true;
                                                phi_1847_ = false;
                                            }
                                            let _e1236 = phi_1845_;
                                            let _e1238 = phi_1846_;
                                            let _e1240 = phi_1847_;
                                            phi_1848_ = _e1236;
                                            phi_1849_ = _e1238;
                                            phi_1850_ = _e1240;
                                        } else {
                                            phi_1848_ = f32();
                                            phi_1849_ = true;
                                            phi_1850_ = false;
                                        }
                                        let _e1242 = phi_1848_;
                                        let _e1244 = phi_1849_;
                                        let _e1246 = phi_1850_;
                                        if _e1244 {
                                            phi_1854_ = false;
                                        } else {
                                            phi_1854_ = _e1246;
                                        }
                                        let _e1248 = phi_1854_;
                                        phi_1855_ = _e1242;
                                        phi_1856_ = _e1248;
                                    } else {
                                        phi_1855_ = _e1227;
                                        phi_1856_ = true;
                                    }
                                    let _e1250 = phi_1855_;
                                    let _e1252 = phi_1856_;
                                    if _e1252 {
                                        let _e1253 = (_e1250 == 0f);
                                        if _e1253 {
                                            phi_2180_ = lt_bvh_triangle_Intersection();
                                            phi_2181_ = false;
                                        } else {
                                            let _e1255 = triangles.member[(0u + _e1060)].v0_;
                                            let _e1258 = (_e1255.x - _e206.origin.x);
                                            let _e1261 = (_e1255.y - _e206.origin.y);
                                            let _e1264 = (_e1255.z - _e206.origin.z);
                                            if (_e436 == 0u) {
                                                phi_1887_ = vec3<f32>(_e1261, _e1264, _e1258);
                                            } else {
                                                if (_e436 == 1u) {
                                                    phi_1886_ = vec3<f32>(_e1264, _e1258, _e1261);
                                                } else {
                                                    phi_1886_ = (_e1255 - _e206.origin);
                                                }
                                                let _e1271 = phi_1886_;
                                                phi_1887_ = _e1271;
                                            }
                                            let _e1273 = phi_1887_;
                                            let _e1275 = triangles.member[(0u + _e1060)].v1_;
                                            let _e1277 = triangles.member[(0u + _e1060)].v0_;
                                            let _e1280 = (_e1275.x - _e1277.x);
                                            let _e1283 = (_e1275.y - _e1277.y);
                                            let _e1286 = (_e1275.z - _e1277.z);
                                            if (_e436 == 0u) {
                                                phi_1913_ = vec3<f32>(_e1283, _e1286, _e1280);
                                            } else {
                                                if (_e436 == 1u) {
                                                    phi_1912_ = vec3<f32>(_e1286, _e1280, _e1283);
                                                } else {
                                                    phi_1912_ = (_e1275 - _e1277);
                                                }
                                                let _e1293 = phi_1912_;
                                                phi_1913_ = _e1293;
                                            }
                                            let _e1295 = phi_1913_;
                                            let _e1297 = triangles.member[(0u + _e1060)].v2_;
                                            let _e1299 = triangles.member[(0u + _e1060)].v0_;
                                            let _e1302 = (_e1297.x - _e1299.x);
                                            let _e1305 = (_e1297.y - _e1299.y);
                                            let _e1308 = (_e1297.z - _e1299.z);
                                            if (_e436 == 0u) {
                                                phi_1939_ = vec3<f32>(_e1305, _e1308, _e1302);
                                            } else {
                                                if (_e436 == 1u) {
                                                    phi_1938_ = vec3<f32>(_e1308, _e1302, _e1305);
                                                } else {
                                                    phi_1938_ = (_e1297 - _e1299);
                                                }
                                                let _e1315 = phi_1938_;
                                                phi_1939_ = _e1315;
                                            }
                                            let _e1317 = phi_1939_;
                                            let _e1324 = ((_e1295.y * _e1317.z) - (_e1295.z * _e1317.y));
                                            let _e1331 = ((_e1295.z * _e1317.x) - (_e1295.x * _e1317.z));
                                            let _e1338 = ((_e1295.x * _e1317.y) - (_e1295.y * _e1317.x));
                                            let _e1352 = (((1f / _e450.z) * (((_e1324 * _e1273.x) + (_e1331 * _e1273.y)) + (_e1338 * _e1273.z))) / (((_e1324 * _e453) + (_e1331 * _e456)) + _e1338));
                                            if (_e1352 > _e120.t) {
                                                if (_e1352 < _e206.tmax) {
                                                    let _e1356 = triangles.member[(0u + _e1060)].v0_;
                                                    let _e1358 = triangles.member[(0u + _e1060)].v1_;
                                                    if (_e1356.x < _e1358.x) {
                                                        phi_1995_ = _e1356.x;
                                                    } else {
                                                        phi_1995_ = _e1358.x;
                                                    }
                                                    let _e1365 = phi_1995_;
                                                    if (_e1356.y < _e1358.y) {
                                                        phi_2004_ = _e1356.y;
                                                    } else {
                                                        phi_2004_ = _e1358.y;
                                                    }
                                                    let _e1372 = phi_2004_;
                                                    if (_e1356.z < _e1358.z) {
                                                        phi_2013_ = _e1356.z;
                                                    } else {
                                                        phi_2013_ = _e1358.z;
                                                    }
                                                    let _e1379 = phi_2013_;
                                                    let _e1381 = triangles.member[(0u + _e1060)].v2_;
                                                    if (_e1365 < _e1381.x) {
                                                        phi_2022_ = _e1365;
                                                    } else {
                                                        phi_2022_ = _e1381.x;
                                                    }
                                                    let _e1386 = phi_2022_;
                                                    if (_e1372 < _e1381.y) {
                                                        phi_2029_ = _e1372;
                                                    } else {
                                                        phi_2029_ = _e1381.y;
                                                    }
                                                    let _e1391 = phi_2029_;
                                                    if (_e1379 < _e1381.z) {
                                                        phi_2036_ = _e1379;
                                                    } else {
                                                        phi_2036_ = _e1381.z;
                                                    }
                                                    let _e1396 = phi_2036_;
                                                    let _e1398 = triangles.member[(0u + _e1060)].v0_;
                                                    let _e1400 = triangles.member[(0u + _e1060)].v1_;
                                                    if (_e1398.x > _e1400.x) {
                                                        phi_2049_ = _e1398.x;
                                                    } else {
                                                        phi_2049_ = _e1400.x;
                                                    }
                                                    let _e1407 = phi_2049_;
                                                    if (_e1398.y > _e1400.y) {
                                                        phi_2058_ = _e1398.y;
                                                    } else {
                                                        phi_2058_ = _e1400.y;
                                                    }
                                                    let _e1414 = phi_2058_;
                                                    if (_e1398.z > _e1400.z) {
                                                        phi_2067_ = _e1398.z;
                                                    } else {
                                                        phi_2067_ = _e1400.z;
                                                    }
                                                    let _e1421 = phi_2067_;
                                                    let _e1423 = triangles.member[(0u + _e1060)].v2_;
                                                    if (_e1407 > _e1423.x) {
                                                        phi_2076_ = _e1407;
                                                    } else {
                                                        phi_2076_ = _e1423.x;
                                                    }
                                                    let _e1428 = phi_2076_;
                                                    if (_e1414 > _e1423.y) {
                                                        phi_2083_ = _e1414;
                                                    } else {
                                                        phi_2083_ = _e1423.y;
                                                    }
                                                    let _e1433 = phi_2083_;
                                                    if (_e1421 > _e1423.z) {
                                                        phi_2090_ = _e1421;
                                                    } else {
                                                        phi_2090_ = _e1423.z;
                                                    }
                                                    let _e1438 = phi_2090_;
                                                    let _e1445 = ((_e1386 - _e206.origin.x) * _e350);
                                                    let _e1446 = ((_e1391 - _e206.origin.y) * _e361);
                                                    let _e1447 = ((_e1396 - _e206.origin.z) * _e372);
                                                    let _e1454 = ((_e1428 - _e206.origin.x) * _e350);
                                                    let _e1455 = ((_e1433 - _e206.origin.y) * _e361);
                                                    let _e1456 = ((_e1438 - _e206.origin.z) * _e372);
                                                    if (_e1445 < _e1454) {
                                                        phi_2113_ = _e1445;
                                                    } else {
                                                        phi_2113_ = _e1454;
                                                    }
                                                    let _e1459 = phi_2113_;
                                                    if (_e1446 < _e1455) {
                                                        phi_2118_ = _e1446;
                                                    } else {
                                                        phi_2118_ = _e1455;
                                                    }
                                                    let _e1462 = phi_2118_;
                                                    if (_e1447 < _e1456) {
                                                        phi_2123_ = _e1447;
                                                    } else {
                                                        phi_2123_ = _e1456;
                                                    }
                                                    let _e1465 = phi_2123_;
                                                    if (_e1445 > _e1454) {
                                                        phi_2131_ = _e1445;
                                                    } else {
                                                        phi_2131_ = _e1454;
                                                    }
                                                    let _e1471 = phi_2131_;
                                                    if (_e1446 > _e1455) {
                                                        phi_2136_ = _e1446;
                                                    } else {
                                                        phi_2136_ = _e1455;
                                                    }
                                                    let _e1474 = phi_2136_;
                                                    if (_e1447 > _e1456) {
                                                        phi_2141_ = _e1447;
                                                    } else {
                                                        phi_2141_ = _e1456;
                                                    }
                                                    let _e1477 = phi_2141_;
                                                    let _e1481 = core_intrinsics_maximum_number_nsz_f32_((_e1459 - _e417), (_e1462 - _e418));
                                                    let _e1482 = core_intrinsics_maximum_number_nsz_f32_(_e1481, (_e1465 - _e419));
                                                    let _e1483 = core_intrinsics_minimum_number_nsz_f32_((_e1471 + _e417), (_e1474 + _e418));
                                                    let _e1484 = core_intrinsics_minimum_number_nsz_f32_(_e1483, (_e1477 + _e419));
                                                    if (_e1482 > -300000000000000000000000000000000000000f) {
                                                        phi_2153_ = _e1482;
                                                    } else {
                                                        phi_2153_ = -300000000000000000000000000000000000000f;
                                                    }
                                                    let _e1487 = phi_2153_;
                                                    if (_e1484 < 300000000000000000000000000000000000000f) {
                                                        phi_2158_ = _e1484;
                                                    } else {
                                                        phi_2158_ = 300000000000000000000000000000000000000f;
                                                    }
                                                    let _e1490 = phi_2158_;
                                                    if (_e1352 < _e1487) {
                                                        phi_2163_ = _e1487;
                                                    } else {
                                                        phi_2163_ = _e1352;
                                                    }
                                                    let _e1493 = phi_2163_;
                                                    if (_e1493 > _e1490) {
                                                        phi_2168_ = _e1490;
                                                    } else {
                                                        phi_2168_ = _e1493;
                                                    }
                                                    let _e1496 = phi_2168_;
                                                    phi_2173_ = lt_bvh_triangle_Intersection(_e1496, (_e1191 / _e1250), (_e1212 / _e1250), (_e1487 <= _e1490));
                                                    phi_2174_ = false;
                                                } else {
                                                    phi_2173_ = lt_bvh_triangle_Intersection();
                                                    phi_2174_ = true;
                                                }
                                                let _e1502 = phi_2173_;
                                                let _e1504 = phi_2174_;
                                                phi_2175_ = _e1502;
                                                phi_2176_ = _e1504;
                                            } else {
                                                phi_2175_ = lt_bvh_triangle_Intersection();
                                                phi_2176_ = true;
                                            }
                                            let _e1506 = phi_2175_;
                                            let _e1508 = phi_2176_;
                                            if _e1508 {
                                            }
                                            phi_2180_ = _e1506;
                                            phi_2181_ = _e1508;
                                        }
                                        let _e1510 = phi_2180_;
                                        let _e1512 = phi_2181_;
                                        phi_2182_ = _e1510;
                                        phi_2183_ = _e1253;
                                        phi_2184_ = _e1512;
                                    } else {
                                        phi_2182_ = lt_bvh_triangle_Intersection();
                                        phi_2183_ = true;
                                        phi_2184_ = false;
                                    }
                                    let _e1514 = phi_2182_;
                                    let _e1516 = phi_2183_;
                                    let _e1518 = phi_2184_;
                                    if _e1516 {
                                        phi_2188_ = true;
                                    } else {
                                        phi_2188_ = _e1518;
                                    }
                                    let _e1520 = phi_2188_;
                                    if _e1520 {
                                        phi_2192_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                    } else {
                                        phi_2192_ = _e1514;
                                    }
                                    let _e1522 = phi_2192_;
                                    if _e1522.is_hit {
                                        if (_e1522.t > _e120.t) {
                                            if (_e1522.t < _e1049.t) {
                                                phi_2240_ = true;
                                            } else {
                                                if (_e1522.t == _e1049.t) {
                                                    if (_e1049.triangle != 4294967295u) {
                                                        if (_e1060 < _e1049.triangle) {
                                                            phi_2231_ = true;
                                                        } else {
                                                            if (_e1060 == _e1049.triangle) {
                                                                phi_2230_ = (4294967295u < _e1049.instance);
                                                            } else {
                                                                phi_2230_ = false;
                                                            }
                                                            let _e1540 = phi_2230_;
                                                            phi_2231_ = _e1540;
                                                        }
                                                        let _e1542 = phi_2231_;
                                                        phi_2232_ = _e1542;
                                                        phi_2233_ = false;
                                                    } else {
                                                        phi_2232_ = bool();
                                                        phi_2233_ = true;
                                                    }
                                                    let _e1544 = phi_2232_;
                                                    let _e1546 = phi_2233_;
                                                    phi_2234_ = _e1544;
                                                    phi_2235_ = _e1546;
                                                } else {
                                                    phi_2234_ = bool();
                                                    phi_2235_ = true;
                                                }
                                                let _e1548 = phi_2234_;
                                                let _e1550 = phi_2235_;
                                                if _e1550 {
                                                    phi_2239_ = false;
                                                } else {
                                                    phi_2239_ = _e1548;
                                                }
                                                let _e1552 = phi_2239_;
                                                phi_2240_ = _e1552;
                                            }
                                            let _e1554 = phi_2240_;
                                            if _e1554 {
                                                let _e1556 = triangles.member[(0u + _e1060)].i0_;
                                                if ((_e1556 & 2147483648u) == 0u) {
                                                    phi_2451_ = true;
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
                                                            phi_2446_ = true;
                                                        } else {
                                                            let _e1621 = (_e1589.base_color.w * ((((f32((_e1583[0].color >> bitcast<u32>(24i))) * _e1594) + (f32((_e1583[1].color >> bitcast<u32>(24i))) * _e1522.u)) + (f32((_e1583[2].color >> bitcast<u32>(24i))) * _e1522.v)) * (1f / 255f)));
                                                            if (_e1589.alpha_size == 0u) {
                                                                phi_2443_ = _e1621;
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
                                                                phi_2443_ = (_e1621 * (((((f32(((_e1660 >> bitcast<u32>((((_e1652.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1652.weights.x) + ((f32(((_e1680 >> bitcast<u32>((((_e1652.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1652.weights.y)) + ((f32(((_e1701 >> bitcast<u32>((((_e1652.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1652.weights.z)) + ((f32(((_e1722 >> bitcast<u32>((((_e1652.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1652.weights.w)));
                                                            }
                                                            let _e1738 = phi_2443_;
                                                            phi_2446_ = (_e1738 >= _e1589.cutoff);
                                                        }
                                                        let _e1742 = phi_2446_;
                                                        phi_2447_ = _e1742;
                                                    } else {
                                                        phi_2447_ = false;
                                                    }
                                                    let _e1744 = phi_2447_;
                                                    if _e1744 {
                                                    }
                                                    phi_2451_ = _e1744;
                                                }
                                                let _e1746 = phi_2451_;
                                                if _e1746 {
                                                    phi_2459_ = lt_bvh_Hit(_e1522.t, _e1522.u, _e1522.v, _e1060, 4294967295u);
                                                } else {
                                                    phi_2459_ = _e1049;
                                                }
                                                let _e1752 = phi_2459_;
                                                phi_2460_ = _e1752;
                                            } else {
                                                phi_2460_ = _e1049;
                                            }
                                            let _e1754 = phi_2460_;
                                            phi_2461_ = _e1754;
                                        } else {
                                            phi_2461_ = _e1049;
                                        }
                                        let _e1756 = phi_2461_;
                                        phi_2462_ = _e1756;
                                    } else {
                                        phi_2462_ = _e1049;
                                    }
                                    let _e1758 = phi_2462_;
                                    phi_1608_ = _e1758;
                                    phi_1611_ = (_e1051 & (_e1051 - 1u));
                                    phi_2463_ = true;
                                }
                                let _e1760 = phi_1608_;
                                let _e1762 = phi_1611_;
                                let _e1764 = phi_2463_;
                                continue;
                                continuing {
                                    phi_1607_ = _e1760;
                                    phi_1610_ = _e1762;
                                    break if !(_e1764);
                                }
                            }
                            let _e1767 = local_5.group_mask;
                            if ((_e1767 & 4278190080u) == 0u) {
                                let _e1771 = local_5.len;
                                if (_e1771 == 0u) {
                                    phi_2502_ = false;
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
                                    phi_2502_ = true;
                                }
                                let _e1794 = phi_2502_;
                                phi_2503_ = _e1794;
                            } else {
                                phi_2503_ = true;
                            }
                            let _e1796 = phi_2503_;
                            if _e1796 {
                                let _e1798 = local_5.group_mask;
                                let _e1804 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1798)), 32u, (_e1798 == 0u)));
                                let _e1808 = local_5.group_mask;
                                let _e1822 = local_5.group_mask;
                                local_5.group_mask = (_e1822 & ~((1u << bitcast<u32>((_e1804 & 31u)))));
                                let _e1825 = local_5.group;
                                phi_2534_ = (_e1825 + countOneBits(((_e1808 & ~((4294967295u << bitcast<u32>((((_e1804 - 24u) ^ _e469) & 31u))))) & 255u)));
                            } else {
                                phi_2534_ = 4294967295u;
                            }
                            let _e1828 = phi_2534_;
                            let _e3377 = local_9;
                            phi_1272_ = _e3377;
                            phi_1275_ = _e1828;
                        } else {
                            phi_1272_ = lt_bvh_Hit();
                            phi_1275_ = u32();
                        }
                        let _e1830 = phi_1272_;
                        let _e1832 = phi_1275_;
                        continue;
                        continuing {
                            phi_1271_ = _e1830;
                            phi_1274_ = _e1832;
                            break if !(_e610);
                        }
                    }
                    let _e3381 = local_10;
                    phi_2535_ = _e3381;
                }
                let _e1835 = phi_2535_;
                phi_2536_ = _e1835;
                phi_2537_ = _e270;
            } else {
                phi_2536_ = lt_bvh_Hit();
                phi_2537_ = true;
            }
            let _e1837 = phi_2536_;
            let _e1839 = phi_2537_;
            if _e1839 {
                phi_2541_ = _e210;
            } else {
                phi_2541_ = _e1837;
            }
            let _e1841 = phi_2541_;
            phi_2543_ = _e1841;
        } else {
            phi_2543_ = lt_bvh_Hit(300000000000000000000000000000000000000f, 0f, 0f, 4294967295u, 4294967295u);
        }
        let _e1844 = phi_2543_;
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
                    phi_2630_ = _e1889;
                } else {
                    phi_2630_ = _e1895;
                }
                let _e1902 = phi_2630_;
                if (_e1891 > _e1897) {
                    phi_2635_ = _e1891;
                } else {
                    phi_2635_ = _e1897;
                }
                let _e1905 = phi_2635_;
                if (_e1893 > _e1899) {
                    phi_2640_ = _e1893;
                } else {
                    phi_2640_ = _e1899;
                }
                let _e1908 = phi_2640_;
                let _e1910 = abs(_e1859.v2_.x);
                let _e1912 = abs(_e1859.v2_.y);
                let _e1914 = abs(_e1859.v2_.z);
                if (_e1902 > _e1910) {
                    phi_2651_ = _e1902;
                } else {
                    phi_2651_ = _e1910;
                }
                let _e1917 = phi_2651_;
                if (_e1905 > _e1912) {
                    phi_2656_ = _e1905;
                } else {
                    phi_2656_ = _e1912;
                }
                let _e1920 = phi_2656_;
                if (_e1908 > _e1914) {
                    phi_2661_ = _e1908;
                } else {
                    phi_2661_ = _e1914;
                }
                let _e1923 = phi_2661_;
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
                    phi_2737_ = vec3<f32>(-(_e1982), -(_e1983), -(_e1984));
                } else {
                    phi_2737_ = vec3<f32>(_e1982, _e1983, _e1984);
                }
                let _e1997 = phi_2737_;
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
                    phi_2980_ = vec3<f32>(1f, 1f, 1f);
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
                    phi_2980_ = vec3<f32>((_e2233 * _e2233), (_e2234 * _e2234), (_e2235 * _e2235));
                }
                let _e2241 = phi_2980_;
                let _e2243 = ((_e2025.base_color.x * ((((f32((_e2019[0].color & 255u)) * _e2042) * _e1854) + ((f32((_e2019[1].color & 255u)) * _e2061) * _e1844.u)) + ((f32((_e2019[2].color & 255u)) * _e2083) * _e1844.v))) * _e2241.x);
                let _e2245 = ((_e2025.base_color.y * ((((f32(((_e2019[0].color >> bitcast<u32>(8i)) & 255u)) * _e2042) * _e1854) + ((f32(((_e2019[1].color >> bitcast<u32>(8i)) & 255u)) * _e2061) * _e1844.u)) + ((f32(((_e2019[2].color >> bitcast<u32>(8i)) & 255u)) * _e2083) * _e1844.v))) * _e2241.y);
                let _e2247 = ((_e2025.base_color.z * ((((f32(((_e2019[0].color >> bitcast<u32>(16i)) & 255u)) * _e2042) * _e1854) + ((f32(((_e2019[1].color >> bitcast<u32>(16i)) & 255u)) * _e2061) * _e1844.u)) + ((f32(((_e2019[2].color >> bitcast<u32>(16i)) & 255u)) * _e2083) * _e1844.v))) * _e2241.z);
                let _e2248 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1920, _e1923);
                let _e2249 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1917, _e2248);
                if ((_e2025.flags & 2u) == 0u) {
                    phi_2995_ = 0u;
                } else {
                    phi_2995_ = 1u;
                }
                let _e2254 = phi_2995_;
                if (_e2019[0].normal == 2147516416u) {
                    phi_3198_ = _e1997;
                } else {
                    let _e2267 = (f32((bitcast<i32>((_e2019[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                    let _e2273 = (f32((bitcast<i32>(_e2019[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                    let _e2277 = ((1f - abs(_e2267)) - abs(_e2273));
                    if (_e2277 < 0f) {
                        phi_3022_ = -(_e2277);
                    } else {
                        phi_3022_ = 0f;
                    }
                    let _e2281 = phi_3022_;
                    if (_e2267 < 0f) {
                        phi_3029_ = (_e2267 + _e2281);
                    } else {
                        phi_3029_ = (_e2267 - _e2281);
                    }
                    let _e2286 = phi_3029_;
                    if (_e2273 < 0f) {
                        phi_3036_ = (_e2273 + _e2281);
                    } else {
                        phi_3036_ = (_e2273 - _e2281);
                    }
                    let _e2291 = phi_3036_;
                    let _e2298 = (1f / sqrt((((_e2286 * _e2286) + (_e2291 * _e2291)) + (_e2277 * _e2277))));
                    let _e2314 = (f32((bitcast<i32>((_e2019[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                    let _e2320 = (f32((bitcast<i32>(_e2019[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                    let _e2324 = ((1f - abs(_e2314)) - abs(_e2320));
                    if (_e2324 < 0f) {
                        phi_3071_ = -(_e2324);
                    } else {
                        phi_3071_ = 0f;
                    }
                    let _e2328 = phi_3071_;
                    if (_e2314 < 0f) {
                        phi_3078_ = (_e2314 + _e2328);
                    } else {
                        phi_3078_ = (_e2314 - _e2328);
                    }
                    let _e2333 = phi_3078_;
                    if (_e2320 < 0f) {
                        phi_3085_ = (_e2320 + _e2328);
                    } else {
                        phi_3085_ = (_e2320 - _e2328);
                    }
                    let _e2338 = phi_3085_;
                    let _e2345 = (1f / sqrt((((_e2333 * _e2333) + (_e2338 * _e2338)) + (_e2324 * _e2324))));
                    let _e2364 = (f32((bitcast<i32>((_e2019[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                    let _e2370 = (f32((bitcast<i32>(_e2019[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                    let _e2374 = ((1f - abs(_e2364)) - abs(_e2370));
                    if (_e2374 < 0f) {
                        phi_3123_ = -(_e2374);
                    } else {
                        phi_3123_ = 0f;
                    }
                    let _e2378 = phi_3123_;
                    if (_e2364 < 0f) {
                        phi_3130_ = (_e2364 + _e2378);
                    } else {
                        phi_3130_ = (_e2364 - _e2378);
                    }
                    let _e2383 = phi_3130_;
                    if (_e2370 < 0f) {
                        phi_3137_ = (_e2370 + _e2378);
                    } else {
                        phi_3137_ = (_e2370 - _e2378);
                    }
                    let _e2388 = phi_3137_;
                    let _e2395 = (1f / sqrt((((_e2383 * _e2383) + (_e2388 * _e2388)) + (_e2374 * _e2374))));
                    let _e2406 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(vec3<f32>(((((_e2286 * _e2298) * _e1854) + ((_e2333 * _e2345) * _e1844.u)) + ((_e2383 * _e2395) * _e1844.v)), ((((_e2291 * _e2298) * _e1854) + ((_e2338 * _e2345) * _e1844.u)) + ((_e2388 * _e2395) * _e1844.v)), ((((_e2277 * _e2298) * _e1854) + ((_e2324 * _e2345) * _e1844.u)) + ((_e2374 * _e2395) * _e1844.v))));
                    let _e2418 = sqrt((((_e2406.x * _e2406.x) + (_e2406.y * _e2406.y)) + (_e2406.z * _e2406.z)));
                    if (_e2418 > 0f) {
                        let _e2421 = (_e2406.x / _e2418);
                        let _e2423 = (_e2406.y / _e2418);
                        let _e2425 = (_e2406.z / _e2418);
                        if ((((_e2421 * _e1997.x) + (_e2423 * _e1997.y)) + (_e2425 * _e1997.z)) < 0f) {
                            phi_3196_ = vec3<f32>(-(_e2421), -(_e2423), -(_e2425));
                        } else {
                            phi_3196_ = (_e2406 / vec3(_e2418));
                        }
                        let _e2442 = phi_3196_;
                        phi_3197_ = _e2442;
                    } else {
                        phi_3197_ = _e1997;
                    }
                    let _e2444 = phi_3197_;
                    phi_3198_ = _e2444;
                }
                let _e2446 = phi_3198_;
                if (_e2243 > 0f) {
                    if (_e2243 < 1f) {
                        phi_3207_ = _e2243;
                    } else {
                        phi_3207_ = 1f;
                    }
                    let _e2450 = phi_3207_;
                    phi_3208_ = _e2450;
                } else {
                    phi_3208_ = 0f;
                }
                let _e2452 = phi_3208_;
                if (_e2245 > 0f) {
                    if (_e2245 < 1f) {
                        phi_3218_ = _e2245;
                    } else {
                        phi_3218_ = 1f;
                    }
                    let _e2457 = phi_3218_;
                    phi_3219_ = _e2457;
                } else {
                    phi_3219_ = 0f;
                }
                let _e2459 = phi_3219_;
                if (_e2247 > 0f) {
                    if (_e2247 < 1f) {
                        phi_3229_ = _e2247;
                    } else {
                        phi_3229_ = 1f;
                    }
                    let _e2464 = phi_3229_;
                    phi_3230_ = _e2464;
                } else {
                    phi_3230_ = 0f;
                }
                let _e2466 = phi_3230_;
                let _e2469 = ((sqrt(_e2452) * 255f) + 0.5f);
                let _e2478 = ((sqrt(_e2459) * 255f) + 0.5f);
                let _e2490 = ((sqrt(_e2466) * 255f) + 0.5f);
                phi_3265_ = abi_Sample(vec3<f32>(_e1884, _e1885, _e1886), _e2249, _e1997, _e2254, _e2446, ((select(select(u32(_e2469), 0u, (_e2469 < bitcast<f32>(0u))), 4294967295u, (_e2469 > bitcast<f32>(1333788671u))) | (select(select(u32(_e2478), 0u, (_e2478 < bitcast<f32>(0u))), 4294967295u, (_e2478 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e2490), 0u, (_e2490 < bitcast<f32>(0u))), 4294967295u, (_e2490 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
            } else {
                phi_3265_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
            }
            let _e2504 = phi_3265_;
            let _e2506 = p.member.layers_behind;
            let _e2507 = (_e2506 == 0u);
            if _e2507 {
                let _e2509 = ((1f * 65535f) + 0.5f);
                phi_3946_ = u0028_abi_Sample_u0020_abi_Sight_u0029_(abi_Sample(_e2504.position, _e2504.magnitude, _e2504.normal, ((_e2504.flags & 65535u) | (select(select(u32(_e2509), 0u, (_e2509 < bitcast<f32>(0u))), 4294967295u, (_e2509 > bitcast<f32>(1333788671u))) << bitcast<u32>(16u))), _e2504.shading_normal, _e2504.albedo), _e1846);
                phi_3947_ = u0028_abi_Sample_u0020_abi_Sight_u0029_();
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
                    phi_3495_ = 1f;
                } else {
                    let _e2587 = (_e2560.base_color.w * ((((f32((_e2554[0].color >> bitcast<u32>(24i))) * _e2532) + (f32((_e2554[1].color >> bitcast<u32>(24i))) * _e1844.u)) + (f32((_e2554[2].color >> bitcast<u32>(24i))) * _e1844.v)) * (1f / 255f)));
                    if (_e2560.alpha_size == 0u) {
                        phi_3471_ = _e2587;
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
                        phi_3471_ = (_e2587 * (((((f32(((_e2626 >> bitcast<u32>((((_e2618.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2618.weights.x) + ((f32(((_e2646 >> bitcast<u32>((((_e2618.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2618.weights.y)) + ((f32(((_e2667 >> bitcast<u32>((((_e2618.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2618.weights.z)) + ((f32(((_e2688 >> bitcast<u32>((((_e2618.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2618.weights.w)));
                    }
                    let _e2704 = phi_3471_;
                    if ((_e2560.flags & 8u) == 0u) {
                        if (_e2704 >= _e2560.cutoff) {
                            phi_3483_ = 1f;
                        } else {
                            phi_3483_ = 0f;
                        }
                        let _e2711 = phi_3483_;
                        phi_3494_ = _e2711;
                    } else {
                        if (_e2704 > 0f) {
                            if (_e2704 < 1f) {
                                phi_3492_ = _e2704;
                            } else {
                                phi_3492_ = 1f;
                            }
                            let _e2715 = phi_3492_;
                            phi_3493_ = _e2715;
                        } else {
                            phi_3493_ = 0f;
                        }
                        let _e2717 = phi_3493_;
                        phi_3494_ = _e2717;
                    }
                    let _e2719 = phi_3494_;
                    phi_3495_ = _e2719;
                }
                let _e2721 = phi_3495_;
                let _e2724 = (_e2721 * (1f - _e2560.transmission));
                if (_e2724 > 0f) {
                    if (_e2724 < 1f) {
                        phi_3507_ = _e2724;
                    } else {
                        phi_3507_ = 1f;
                    }
                    let _e2728 = phi_3507_;
                    phi_3508_ = _e2728;
                } else {
                    phi_3508_ = 0f;
                }
                let _e2730 = phi_3508_;
                if (_e2560.cutoff <= 0f) {
                    phi_3664_ = 1f;
                } else {
                    let _e2757 = (_e2560.base_color.w * ((((f32((_e2554[0].color >> bitcast<u32>(24i))) * _e2532) + (f32((_e2554[1].color >> bitcast<u32>(24i))) * _e1844.u)) + (f32((_e2554[2].color >> bitcast<u32>(24i))) * _e1844.v)) * (1f / 255f)));
                    if (_e2560.alpha_size == 0u) {
                        phi_3640_ = _e2757;
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
                        phi_3640_ = (_e2757 * (((((f32(((_e2796 >> bitcast<u32>((((_e2788.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2788.weights.x) + ((f32(((_e2816 >> bitcast<u32>((((_e2788.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2788.weights.y)) + ((f32(((_e2837 >> bitcast<u32>((((_e2788.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2788.weights.z)) + ((f32(((_e2858 >> bitcast<u32>((((_e2788.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2788.weights.w)));
                    }
                    let _e2874 = phi_3640_;
                    if ((_e2560.flags & 8u) == 0u) {
                        if (_e2874 >= _e2560.cutoff) {
                            phi_3652_ = 1f;
                        } else {
                            phi_3652_ = 0f;
                        }
                        let _e2881 = phi_3652_;
                        phi_3663_ = _e2881;
                    } else {
                        if (_e2874 > 0f) {
                            if (_e2874 < 1f) {
                                phi_3661_ = _e2874;
                            } else {
                                phi_3661_ = 1f;
                            }
                            let _e2885 = phi_3661_;
                            phi_3662_ = _e2885;
                        } else {
                            phi_3662_ = 0f;
                        }
                        let _e2887 = phi_3662_;
                        phi_3663_ = _e2887;
                    }
                    let _e2889 = phi_3663_;
                    phi_3664_ = _e2889;
                }
                let _e2891 = phi_3664_;
                let _e2908 = (1f / 255f);
                let _e2927 = (1f / 255f);
                let _e2949 = (1f / 255f);
                if (_e2560.color_size == 0u) {
                    phi_3863_ = vec3<f32>(1f, 1f, 1f);
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
                    phi_3863_ = vec3<f32>((_e3099 * _e3099), (_e3100 * _e3100), (_e3101 * _e3101));
                }
                let _e3107 = phi_3863_;
                let _e3115 = (_e2891 * _e2560.transmission);
                let _e3119 = (1f - _e2891);
                let _e3120 = ((((_e2560.base_color.x * ((((f32((_e2554[0].color & 255u)) * _e2908) * _e2532) + ((f32((_e2554[1].color & 255u)) * _e2927) * _e1844.u)) + ((f32((_e2554[2].color & 255u)) * _e2949) * _e1844.v))) * _e3107.x) * _e3115) + _e3119);
                let _e3121 = ((((_e2560.base_color.y * ((((f32(((_e2554[0].color >> bitcast<u32>(8i)) & 255u)) * _e2908) * _e2532) + ((f32(((_e2554[1].color >> bitcast<u32>(8i)) & 255u)) * _e2927) * _e1844.u)) + ((f32(((_e2554[2].color >> bitcast<u32>(8i)) & 255u)) * _e2949) * _e1844.v))) * _e3107.y) * _e3115) + _e3119);
                let _e3122 = ((((_e2560.base_color.z * ((((f32(((_e2554[0].color >> bitcast<u32>(16i)) & 255u)) * _e2908) * _e2532) + ((f32(((_e2554[1].color >> bitcast<u32>(16i)) & 255u)) * _e2927) * _e1844.u)) + ((f32(((_e2554[2].color >> bitcast<u32>(16i)) & 255u)) * _e2949) * _e1844.v))) * _e3107.z) * _e3115) + _e3119);
                if (_e3120 > 0f) {
                    if (_e3120 < 1f) {
                        phi_3887_ = _e3120;
                    } else {
                        phi_3887_ = 1f;
                    }
                    let _e3126 = phi_3887_;
                    phi_3888_ = _e3126;
                } else {
                    phi_3888_ = 0f;
                }
                let _e3128 = phi_3888_;
                if (_e3121 > 0f) {
                    if (_e3121 < 1f) {
                        phi_3897_ = _e3121;
                    } else {
                        phi_3897_ = 1f;
                    }
                    let _e3132 = phi_3897_;
                    phi_3898_ = _e3132;
                } else {
                    phi_3898_ = 0f;
                }
                let _e3134 = phi_3898_;
                if (_e3122 > 0f) {
                    if (_e3122 < 1f) {
                        phi_3907_ = _e3122;
                    } else {
                        phi_3907_ = 1f;
                    }
                    let _e3138 = phi_3907_;
                    phi_3908_ = _e3138;
                } else {
                    phi_3908_ = 0f;
                }
                let _e3140 = phi_3908_;
                let _e3142 = ((_e2730 * 65535f) + 0.5f);
                phi_3946_ = u0028_abi_Sample_u0020_abi_Sight_u0029_();
                phi_3947_ = u0028_abi_Sample_u0020_abi_Sight_u0029_(abi_Sample(_e2504.position, _e2504.magnitude, _e2504.normal, ((_e2504.flags & 65535u) | (select(select(u32(_e3142), 0u, (_e3142 < bitcast<f32>(0u))), 4294967295u, (_e3142 > bitcast<f32>(1333788671u))) << bitcast<u32>(16u))), _e2504.shading_normal, _e2504.albedo), abi_Sight((vec3<f32>(1f, 1f, 1f) - vec3<f32>(((vec3<f32>(1f, 1f, 1f).x - _e120.kept.x) * _e3128), ((vec3<f32>(1f, 1f, 1f).y - _e120.kept.y) * _e3134), ((vec3<f32>(1f, 1f, 1f).z - _e120.kept.z) * _e3140))), _e1844.t));
            }
            let _e3180 = phi_3946_;
            let _e3182 = phi_3947_;
            phi_3950_ = _e3180;
            phi_3951_ = _e3182;
            phi_3952_ = _e2507;
        } else {
            phi_3950_ = u0028_abi_Sample_u0020_abi_Sight_u0029_(abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u), _e1846);
            phi_3951_ = u0028_abi_Sample_u0020_abi_Sight_u0029_();
            phi_3952_ = true;
        }
        let _e3186 = phi_3950_;
        let _e3188 = phi_3951_;
        let _e3190 = phi_3952_;
        if _e3190 {
            phi_3956_ = _e3186;
        } else {
            phi_3956_ = _e3188;
        }
        let _e3192 = phi_3956_;
        if (_e112.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e112.shift)] = _e3192.unnamed;
        if (_e112.shift < _e106) {
        } else {
            return;
        }
        sights.member[(0u + _e112.shift)] = _e3192.unnamed_1;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_layers_layer_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
