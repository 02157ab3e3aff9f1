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
var<storage> color_texels: type_13;
@group(0) @binding(8) 
var<storage> before: type_26;
@group(0) @binding(9) 
var<storage, read_write> past: type_26;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_mask_LightPlace {
    var phi_224_: lt_mask_LightPlace;
    var phi_225_: bool;
    var phi_226_: lt_mask_LightPlace;
    var phi_227_: bool;
    var phi_232_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_224_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_225_ = false;
        } else {
            phi_224_ = lt_mask_LightPlace();
            phi_225_ = true;
        }
        let _e84 = phi_224_;
        let _e86 = phi_225_;
        phi_226_ = _e84;
        phi_227_ = _e86;
    } else {
        phi_226_ = lt_mask_LightPlace();
        phi_227_ = true;
    }
    let _e88 = phi_226_;
    let _e90 = phi_227_;
    if _e90 {
        phi_232_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_232_ = _e88;
    }
    let _e95 = phi_232_;
    return lt_mask_LightPlace(_e95.word, _e95.shift);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_247_: bool;
    var phi_251_: f32;

    if (param_3 != param_3) {
        phi_247_ = true;
    } else {
        let _e74 = (param_4 >= param_3);
        if _e74 {
        }
        phi_247_ = _e74;
    }
    let _e76 = phi_247_;
    if _e76 {
        phi_251_ = param_4;
    } else {
        phi_251_ = param_3;
    }
    let _e78 = phi_251_;
    return _e78;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_263_: bool;
    var phi_267_: f32;

    if (param_5 != param_5) {
        phi_263_ = true;
    } else {
        let _e74 = (param_6 <= param_5);
        if _e74 {
        }
        phi_263_ = _e74;
    }
    let _e76 = phi_263_;
    if _e76 {
        phi_267_ = param_6;
    } else {
        phi_267_ = param_5;
    }
    let _e78 = phi_267_;
    return _e78;
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

    let _e75 = (*param_7).size;
    let _e76 = (_e75 & 65535u);
    let _e78 = (*param_7).size;
    let _e80 = (_e78 >> bitcast<u32>(16i));
    let _e82 = (*param_7).flags;
    let _e84 = ((_e82 & 4u) != 0u);
    let _e86 = (*param_7).flags;
    let _e89 = ((_e86 >> bitcast<u32>(4u)) & 3u);
    if (_e89 == 0u) {
        if (param_8 > -8388608f) {
            let _e102 = f32(select(0i, select(select(i32(param_8), i32(-2147483648), (param_8 < bitcast<f32>(3472883712u))), 2147483647i, (param_8 > bitcast<f32>(1325400063u))), (param_8 == param_8)));
            if (_e102 > param_8) {
                phi_309_ = 1f;
            } else {
                phi_309_ = 0f;
            }
            let _e105 = phi_309_;
            if (param_8 < 8388608f) {
                phi_314_ = (_e102 - _e105);
                phi_315_ = false;
            } else {
                phi_314_ = f32();
                phi_315_ = true;
            }
            let _e108 = phi_314_;
            let _e110 = phi_315_;
            phi_316_ = _e108;
            phi_317_ = _e110;
        } else {
            phi_316_ = f32();
            phi_317_ = true;
        }
        let _e112 = phi_316_;
        let _e114 = phi_317_;
        if _e114 {
            phi_321_ = param_8;
        } else {
            phi_321_ = _e112;
        }
        let _e116 = phi_321_;
        phi_369_ = (param_8 - _e116);
    } else {
        if (_e89 == 1u) {
            let _e119 = (param_8 * 0.5f);
            if (_e119 > -8388608f) {
                let _e131 = f32(select(0i, select(select(i32(_e119), i32(-2147483648), (_e119 < bitcast<f32>(3472883712u))), 2147483647i, (_e119 > bitcast<f32>(1325400063u))), (_e119 == _e119)));
                if (_e131 > _e119) {
                    phi_347_ = 1f;
                } else {
                    phi_347_ = 0f;
                }
                let _e134 = phi_347_;
                if (_e119 < 8388608f) {
                    phi_352_ = (_e131 - _e134);
                    phi_353_ = false;
                } else {
                    phi_352_ = f32();
                    phi_353_ = true;
                }
                let _e137 = phi_352_;
                let _e139 = phi_353_;
                phi_354_ = _e137;
                phi_355_ = _e139;
            } else {
                phi_354_ = f32();
                phi_355_ = true;
            }
            let _e141 = phi_354_;
            let _e143 = phi_355_;
            if _e143 {
                phi_359_ = _e119;
            } else {
                phi_359_ = _e141;
            }
            let _e145 = phi_359_;
            let _e147 = (param_8 - (2f * _e145));
            if (_e147 > 1f) {
                phi_367_ = (2f - _e147);
            } else {
                phi_367_ = _e147;
            }
            let _e151 = phi_367_;
            phi_368_ = _e151;
        } else {
            phi_368_ = param_8;
        }
        let _e153 = phi_368_;
        phi_369_ = _e153;
    }
    let _e155 = phi_369_;
    if (_e155 > 0f) {
        if (_e155 < 1f) {
            phi_378_ = _e155;
        } else {
            phi_378_ = 1f;
        }
        let _e159 = phi_378_;
        phi_379_ = _e159;
    } else {
        phi_379_ = 0f;
    }
    let _e161 = phi_379_;
    let _e162 = (_e76 - 1u);
    let _e164 = (_e161 * f32(_e76));
    if _e84 {
        let _e171 = select(select(u32(_e164), 0u, (_e164 < bitcast<f32>(0u))), 4294967295u, (_e164 > bitcast<f32>(1333788671u)));
        if (_e162 < _e171) {
            phi_397_ = _e162;
        } else {
            phi_397_ = _e171;
        }
        let _e174 = phi_397_;
        phi_436_ = texture_Axis(_e174, _e174, 0f);
    } else {
        let _e176 = (_e164 + 0.5f);
        let _e183 = select(select(u32(_e176), 0u, (_e176 < bitcast<f32>(0u))), 4294967295u, (_e176 > bitcast<f32>(1333788671u)));
        if (_e76 < _e183) {
            phi_411_ = _e76;
        } else {
            phi_411_ = _e183;
        }
        let _e186 = phi_411_;
        if (_e89 == 0u) {
            phi_418_ = _e162;
        } else {
            phi_418_ = 0u;
        }
        let _e191 = phi_418_;
        if (_e89 == 0u) {
            phi_423_ = 0u;
        } else {
            phi_423_ = _e162;
        }
        let _e194 = phi_423_;
        if (_e186 == 0u) {
            phi_429_ = _e191;
        } else {
            phi_429_ = (_e186 - 1u);
        }
        let _e198 = phi_429_;
        if (_e186 > _e162) {
            phi_434_ = _e194;
        } else {
            phi_434_ = _e186;
        }
        let _e201 = phi_434_;
        phi_436_ = texture_Axis(_e198, _e201, (_e176 - f32(_e186)));
    }
    let _e204 = phi_436_;
    let _e206 = (*param_7).flags;
    let _e209 = ((_e206 >> bitcast<u32>(6u)) & 3u);
    if (_e209 == 0u) {
        if (param_9 > -8388608f) {
            let _e222 = f32(select(0i, select(select(i32(param_9), i32(-2147483648), (param_9 < bitcast<f32>(3472883712u))), 2147483647i, (param_9 > bitcast<f32>(1325400063u))), (param_9 == param_9)));
            if (_e222 > param_9) {
                phi_464_ = 1f;
            } else {
                phi_464_ = 0f;
            }
            let _e225 = phi_464_;
            if (param_9 < 8388608f) {
                phi_469_ = (_e222 - _e225);
                phi_470_ = false;
            } else {
                phi_469_ = f32();
                phi_470_ = true;
            }
            let _e228 = phi_469_;
            let _e230 = phi_470_;
            phi_471_ = _e228;
            phi_472_ = _e230;
        } else {
            phi_471_ = f32();
            phi_472_ = true;
        }
        let _e232 = phi_471_;
        let _e234 = phi_472_;
        if _e234 {
            phi_476_ = param_9;
        } else {
            phi_476_ = _e232;
        }
        let _e236 = phi_476_;
        phi_524_ = (param_9 - _e236);
    } else {
        if (_e209 == 1u) {
            let _e239 = (param_9 * 0.5f);
            if (_e239 > -8388608f) {
                let _e251 = f32(select(0i, select(select(i32(_e239), i32(-2147483648), (_e239 < bitcast<f32>(3472883712u))), 2147483647i, (_e239 > bitcast<f32>(1325400063u))), (_e239 == _e239)));
                if (_e251 > _e239) {
                    phi_502_ = 1f;
                } else {
                    phi_502_ = 0f;
                }
                let _e254 = phi_502_;
                if (_e239 < 8388608f) {
                    phi_507_ = (_e251 - _e254);
                    phi_508_ = false;
                } else {
                    phi_507_ = f32();
                    phi_508_ = true;
                }
                let _e257 = phi_507_;
                let _e259 = phi_508_;
                phi_509_ = _e257;
                phi_510_ = _e259;
            } else {
                phi_509_ = f32();
                phi_510_ = true;
            }
            let _e261 = phi_509_;
            let _e263 = phi_510_;
            if _e263 {
                phi_514_ = _e239;
            } else {
                phi_514_ = _e261;
            }
            let _e265 = phi_514_;
            let _e267 = (param_9 - (2f * _e265));
            if (_e267 > 1f) {
                phi_522_ = (2f - _e267);
            } else {
                phi_522_ = _e267;
            }
            let _e271 = phi_522_;
            phi_523_ = _e271;
        } else {
            phi_523_ = param_9;
        }
        let _e273 = phi_523_;
        phi_524_ = _e273;
    }
    let _e275 = phi_524_;
    if (_e275 > 0f) {
        if (_e275 < 1f) {
            phi_533_ = _e275;
        } else {
            phi_533_ = 1f;
        }
        let _e279 = phi_533_;
        phi_534_ = _e279;
    } else {
        phi_534_ = 0f;
    }
    let _e281 = phi_534_;
    let _e282 = (_e80 - 1u);
    let _e284 = (_e281 * f32(_e80));
    if _e84 {
        let _e291 = select(select(u32(_e284), 0u, (_e284 < bitcast<f32>(0u))), 4294967295u, (_e284 > bitcast<f32>(1333788671u)));
        if (_e282 < _e291) {
            phi_552_ = _e282;
        } else {
            phi_552_ = _e291;
        }
        let _e294 = phi_552_;
        phi_591_ = texture_Axis(_e294, _e294, 0f);
    } else {
        let _e296 = (_e284 + 0.5f);
        let _e303 = select(select(u32(_e296), 0u, (_e296 < bitcast<f32>(0u))), 4294967295u, (_e296 > bitcast<f32>(1333788671u)));
        if (_e80 < _e303) {
            phi_566_ = _e80;
        } else {
            phi_566_ = _e303;
        }
        let _e306 = phi_566_;
        if (_e209 == 0u) {
            phi_573_ = _e282;
        } else {
            phi_573_ = 0u;
        }
        let _e311 = phi_573_;
        if (_e209 == 0u) {
            phi_578_ = 0u;
        } else {
            phi_578_ = _e282;
        }
        let _e314 = phi_578_;
        if (_e306 == 0u) {
            phi_584_ = _e311;
        } else {
            phi_584_ = (_e306 - 1u);
        }
        let _e318 = phi_584_;
        if (_e306 > _e282) {
            phi_589_ = _e314;
        } else {
            phi_589_ = _e306;
        }
        let _e321 = phi_589_;
        phi_591_ = texture_Axis(_e318, _e321, (_e296 - f32(_e306)));
    }
    let _e324 = phi_591_;
    let _e328 = (*param_7).offset;
    let _e335 = (*param_7).offset;
    let _e342 = (*param_7).offset;
    let _e349 = (*param_7).offset;
    return texture_TexelQuad(array<u32, 4>(((_e328 + (_e324.low * _e76)) + _e204.low), ((_e335 + (_e324.low * _e76)) + _e204.high), ((_e342 + (_e324.high * _e76)) + _e204.low), ((_e349 + (_e324.high * _e76)) + _e204.high)), vec4<f32>(((1f - _e204.fraction) * (1f - _e324.fraction)), (_e204.fraction * (1f - _e324.fraction)), ((1f - _e204.fraction) * _e324.fraction), (_e204.fraction * _e324.fraction)));
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
    let _e75 = phi_650_;
    return _e75;
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var local_2: lt_bvh_traverse_Stack;
    var phi_779_: bool;
    var phi_780_: bool;
    var phi_781_: bool;
    var phi_782_: bool;
    var phi_786_: bool;
    var phi_799_: bool;
    var phi_800_: bool;
    var phi_801_: bool;
    var phi_802_: bool;
    var phi_806_: bool;
    var phi_819_: bool;
    var phi_820_: bool;
    var phi_821_: bool;
    var phi_825_: bool;
    var phi_826_: bool;
    var phi_827_: bool;
    var phi_828_: bool;
    var phi_829_: bool;
    var phi_833_: bool;
    var phi_909_: f32;
    var phi_916_: f32;
    var phi_924_: f32;
    var phi_931_: f32;
    var phi_939_: f32;
    var phi_946_: f32;
    var phi_969_: f32;
    var phi_974_: f32;
    var phi_979_: f32;
    var phi_984_: f32;
    var phi_989_: f32;
    var phi_1008_: u32;
    var phi_1013_: u32;
    var phi_1018_: u32;
    var phi_1132_: bool;
    var phi_1133_: bool;
    var phi_1164_: u32;
    var phi_1166_: u32;
    var phi_1169_: lt_bvh_Hit;
    var phi_1254_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1281_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1308_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1314_: u32;
    var phi_1317_: u32;
    var phi_1331_: u32;
    var phi_1341_: u32;
    var phi_1351_: u32;
    var phi_1369_: u32;
    var phi_1379_: u32;
    var phi_1389_: u32;
    var phi_1425_: u32;
    var phi_1438_: u32;
    var phi_1443_: u32;
    var phi_1444_: u32;
    var phi_1445_: u32;
    var phi_1315_: u32;
    var phi_1318_: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_1503_: u32;
    var phi_1506_: lt_bvh_Hit;
    var phi_1561_: f32;
    var phi_1566_: f32;
    var phi_1571_: f32;
    var phi_1579_: f32;
    var phi_1584_: f32;
    var phi_1589_: f32;
    var phi_1721_: bool;
    var phi_1722_: bool;
    var phi_1723_: bool;
    var phi_1724_: bool;
    var phi_1728_: bool;
    var phi_1741_: bool;
    var phi_1742_: bool;
    var phi_1743_: bool;
    var phi_1744_: bool;
    var phi_1748_: bool;
    var phi_1761_: bool;
    var phi_1762_: bool;
    var phi_1763_: bool;
    var phi_1767_: bool;
    var phi_1768_: bool;
    var phi_1769_: bool;
    var phi_1770_: bool;
    var phi_1771_: bool;
    var phi_1775_: bool;
    var phi_1845_: f32;
    var phi_1852_: f32;
    var phi_1859_: f32;
    var phi_1866_: f32;
    var phi_1873_: f32;
    var phi_1880_: f32;
    var phi_1897_: f32;
    var phi_1902_: f32;
    var phi_1907_: f32;
    var phi_1912_: f32;
    var phi_1917_: f32;
    var phi_1943_: bool;
    var phi_1944_: bool;
    var phi_1952_: u32;
    var phi_1953_: u32;
    var phi_1964_: vec3<f32>;
    var phi_1965_: vec3<f32>;
    var phi_1978_: u32;
    var phi_1983_: u32;
    var phi_1988_: u32;
    var phi_2102_: bool;
    var phi_2103_: bool;
    var phi_2134_: u32;
    var phi_2136_: lt_bvh_Hit;
    var phi_2139_: u32;
    var phi_2220_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2247_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2274_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2280_: u32;
    var phi_2283_: u32;
    var phi_2297_: u32;
    var phi_2307_: u32;
    var phi_2317_: u32;
    var phi_2335_: u32;
    var phi_2345_: u32;
    var phi_2355_: u32;
    var phi_2391_: u32;
    var phi_2404_: u32;
    var phi_2409_: u32;
    var phi_2410_: u32;
    var phi_2411_: u32;
    var phi_2281_: u32;
    var phi_2284_: u32;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_2469_: lt_bvh_Hit;
    var phi_2472_: u32;
    var phi_2516_: vec3<f32>;
    var phi_2517_: vec3<f32>;
    var phi_2546_: vec3<f32>;
    var phi_2547_: vec3<f32>;
    var phi_2576_: vec3<f32>;
    var phi_2577_: vec3<f32>;
    var phi_2595_: bool;
    var phi_2596_: bool;
    var phi_2600_: f32;
    var phi_2601_: f32;
    var phi_2602_: f32;
    var phi_2603_: f32;
    var phi_2611_: f32;
    var phi_2621_: bool;
    var phi_2622_: bool;
    var phi_2626_: f32;
    var phi_2627_: f32;
    var phi_2628_: f32;
    var phi_2629_: f32;
    var phi_2637_: f32;
    var phi_2647_: bool;
    var phi_2648_: bool;
    var phi_2652_: f32;
    var phi_2653_: f32;
    var phi_2654_: f32;
    var phi_2655_: f32;
    var phi_2663_: f32;
    var phi_2678_: f32;
    var phi_2679_: bool;
    var phi_2680_: f32;
    var phi_2681_: bool;
    var phi_2682_: f32;
    var phi_2683_: bool;
    var phi_2701_: f32;
    var phi_2702_: bool;
    var phi_2703_: bool;
    var phi_2704_: f32;
    var phi_2705_: bool;
    var phi_2706_: bool;
    var phi_2710_: bool;
    var phi_2711_: f32;
    var phi_2712_: bool;
    var phi_2740_: vec3<f32>;
    var phi_2741_: vec3<f32>;
    var phi_2766_: vec3<f32>;
    var phi_2767_: vec3<f32>;
    var phi_2792_: vec3<f32>;
    var phi_2793_: vec3<f32>;
    var phi_2849_: f32;
    var phi_2858_: f32;
    var phi_2867_: f32;
    var phi_2876_: f32;
    var phi_2883_: f32;
    var phi_2890_: f32;
    var phi_2903_: f32;
    var phi_2912_: f32;
    var phi_2921_: f32;
    var phi_2930_: f32;
    var phi_2937_: f32;
    var phi_2944_: f32;
    var phi_2961_: f32;
    var phi_2966_: f32;
    var phi_2971_: f32;
    var phi_2979_: f32;
    var phi_2984_: f32;
    var phi_2989_: f32;
    var phi_3001_: f32;
    var phi_3006_: f32;
    var phi_3011_: f32;
    var phi_3016_: f32;
    var phi_3021_: lt_bvh_triangle_Intersection;
    var phi_3022_: bool;
    var phi_3023_: lt_bvh_triangle_Intersection;
    var phi_3024_: bool;
    var phi_3028_: lt_bvh_triangle_Intersection;
    var phi_3029_: bool;
    var phi_3030_: lt_bvh_triangle_Intersection;
    var phi_3031_: bool;
    var phi_3032_: bool;
    var phi_3036_: bool;
    var phi_3040_: lt_bvh_triangle_Intersection;
    var phi_3078_: bool;
    var phi_3079_: bool;
    var phi_3080_: bool;
    var phi_3081_: bool;
    var phi_3082_: bool;
    var phi_3083_: bool;
    var phi_3087_: bool;
    var phi_3088_: bool;
    var phi_3102_: bool;
    var phi_3110_: lt_bvh_Hit;
    var phi_3111_: lt_bvh_Hit;
    var phi_3112_: lt_bvh_Hit;
    var phi_3113_: lt_bvh_Hit;
    var phi_2470_: lt_bvh_Hit;
    var phi_2473_: u32;
    var phi_3114_: bool;
    var phi_3153_: bool;
    var phi_3154_: bool;
    var phi_3185_: u32;
    var phi_2137_: lt_bvh_Hit;
    var phi_2140_: u32;
    var phi_3186_: lt_bvh_Hit;
    var phi_3187_: lt_bvh_Hit;
    var phi_3188_: bool;
    var phi_3192_: lt_bvh_Hit;
    var phi_3193_: lt_bvh_Hit;
    var phi_3194_: lt_bvh_Hit;
    var phi_3195_: lt_bvh_Hit;
    var phi_1504_: u32;
    var phi_1507_: lt_bvh_Hit;
    var phi_3196_: bool;
    var phi_3235_: bool;
    var phi_3236_: bool;
    var phi_3267_: u32;
    var phi_1167_: u32;
    var phi_1170_: lt_bvh_Hit;
    var phi_3268_: lt_bvh_Hit;
    var phi_3269_: lt_bvh_Hit;
    var phi_3270_: bool;
    var phi_3274_: lt_bvh_Hit;
    var phi_3461_: f32;
    var phi_3466_: f32;
    var phi_3471_: f32;
    var phi_3479_: f32;
    var phi_3484_: f32;
    var phi_3489_: f32;
    var phi_3553_: vec3<f32>;
    var phi_3796_: vec3<f32>;
    var phi_3811_: u32;
    var phi_3838_: f32;
    var phi_3845_: f32;
    var phi_3852_: f32;
    var phi_3887_: f32;
    var phi_3894_: f32;
    var phi_3901_: f32;
    var phi_3939_: f32;
    var phi_3946_: f32;
    var phi_3953_: f32;
    var phi_4039_: vec3<f32>;
    var phi_4040_: vec3<f32>;
    var phi_4041_: vec3<f32>;
    var phi_4050_: f32;
    var phi_4051_: f32;
    var phi_4061_: f32;
    var phi_4062_: f32;
    var phi_4072_: f32;
    var phi_4073_: f32;
    var phi_4108_: abi_Sample;
    var phi_4331_: vec3<f32>;
    var local_9: lt_bvh_Hit;
    var local_10: lt_bvh_Hit;
    var local_11: lt_bvh_Hit;
    var local_12: lt_bvh_Hit;

    let _e74 = id_1;
    let _e78 = arrayLength((&nodes.member));
    let _e81 = arrayLength((&triangles.member));
    let _e84 = arrayLength((&vertices.member));
    let _e93 = arrayLength((&instances.member));
    let _e96 = arrayLength((&color_texels.member));
    let _e99 = arrayLength((&before.member));
    let _e105 = p.member.size[0u];
    let _e107 = p.member.size[1u];
    let _e108 = lt_shaders_entry_pixel_index(_e74, _e105, _e107);
    if (bitcast<i32>(_e108.word) != 0i) {
        let _e114 = p.member.root;
        let _e118 = p.member.eye;
        let _e123 = p.member.size[0u];
        let _e127 = ((((f32(_e74.x) + 0.5f) / f32(_e123)) * 2f) - 1f);
        let _e132 = p.member.size[1u];
        let _e136 = (1f - (((f32(_e74.y) + 0.5f) / f32(_e132)) * 2f));
        let _e138 = p.member.forward;
        let _e140 = p.member.right;
        let _e154 = p.member.up;
        let _e165 = _lt_bvh_ray_Ray_new(_e118, vec3<f32>(((_e138.x + (_e140.x * _e127)) + (_e154.x * _e136)), ((_e138.y + (_e140.y * _e127)) + (_e154.y * _e136)), ((_e138.z + (_e140.z * _e127)) + (_e154.z * _e136))));
        let _e167 = lt_bvh_Hit(_e165.tmax, 0f, 0f, 4294967295u, 4294967295u);
        let _e170 = abs(_e165.direction.x);
        let _e172 = abs(_e165.direction.y);
        let _e174 = abs(_e165.direction.z);
        if (abs(_e165.origin.x) < 1000000000000000f) {
            if (abs(_e165.origin.y) < 1000000000000000f) {
                phi_779_ = (abs(_e165.origin.z) < 1000000000000000f);
                phi_780_ = false;
            } else {
                phi_779_ = bool();
                phi_780_ = true;
            }
            let _e186 = phi_779_;
            let _e188 = phi_780_;
            phi_781_ = _e186;
            phi_782_ = _e188;
        } else {
            phi_781_ = bool();
            phi_782_ = true;
        }
        let _e190 = phi_781_;
        let _e192 = phi_782_;
        if _e192 {
            phi_786_ = false;
        } else {
            phi_786_ = _e190;
        }
        let _e194 = phi_786_;
        if _e194 {
            if (_e170 < 1000000000000000f) {
                if (_e172 < 1000000000000000f) {
                    phi_799_ = (_e174 < 1000000000000000f);
                    phi_800_ = false;
                } else {
                    phi_799_ = bool();
                    phi_800_ = true;
                }
                let _e199 = phi_799_;
                let _e201 = phi_800_;
                phi_801_ = _e199;
                phi_802_ = _e201;
            } else {
                phi_801_ = bool();
                phi_802_ = true;
            }
            let _e203 = phi_801_;
            let _e205 = phi_802_;
            if _e205 {
                phi_806_ = false;
            } else {
                phi_806_ = _e203;
            }
            let _e207 = phi_806_;
            if _e207 {
                if (_e170 > 0f) {
                    phi_820_ = bool();
                    phi_821_ = true;
                } else {
                    let _e209 = (_e172 > 0f);
                    if _e209 {
                        phi_819_ = bool();
                    } else {
                        phi_819_ = (_e174 > 0f);
                    }
                    let _e212 = phi_819_;
                    phi_820_ = _e212;
                    phi_821_ = _e209;
                }
                let _e214 = phi_820_;
                let _e216 = phi_821_;
                if _e216 {
                    phi_825_ = true;
                } else {
                    phi_825_ = _e214;
                }
                let _e218 = phi_825_;
                phi_826_ = _e218;
                phi_827_ = false;
            } else {
                phi_826_ = bool();
                phi_827_ = true;
            }
            let _e220 = phi_826_;
            let _e222 = phi_827_;
            phi_828_ = _e220;
            phi_829_ = _e222;
        } else {
            phi_828_ = bool();
            phi_829_ = true;
        }
        let _e224 = phi_828_;
        let _e226 = phi_829_;
        if _e226 {
            phi_833_ = false;
        } else {
            phi_833_ = _e224;
        }
        let _e228 = phi_833_;
        if _e228 {
            let _e229 = (_e114 >= _e78);
            if _e229 {
                phi_3268_ = lt_bvh_Hit();
            } else {
                if (_e114 < _e78) {
                } else {
                    return;
                }
                let _e235 = nodes.member[(0u + _e114)].frame[0u];
                let _e239 = nodes.member[(0u + _e114)].frame[1u];
                let _e243 = nodes.member[(0u + _e114)].frame[2u];
                let _e247 = nodes.member[(0u + _e114)].frame[0u];
                let _e251 = nodes.member[(0u + _e114)].frame[1u];
                let _e255 = nodes.member[(0u + _e114)].frame[2u];
                let _e259 = nodes.member[(0u + _e114)].frame[3u];
                let _e298 = core_intrinsics_maximum_number_nsz_f32_(abs(_e165.direction.x), abs(_e165.direction.y));
                let _e299 = core_intrinsics_maximum_number_nsz_f32_(_e298, abs(_e165.direction.z));
                let _e300 = (_e299 * 0.0000000000009094947f);
                if (abs(_e165.direction.x) < _e300) {
                    phi_909_ = _e300;
                } else {
                    phi_909_ = abs(_e165.direction.x);
                }
                let _e306 = phi_909_;
                if (_e165.direction.x < 0f) {
                    phi_916_ = (-1f / _e306);
                } else {
                    phi_916_ = (1f / _e306);
                }
                let _e311 = phi_916_;
                if (abs(_e165.direction.y) < _e300) {
                    phi_924_ = _e300;
                } else {
                    phi_924_ = abs(_e165.direction.y);
                }
                let _e317 = phi_924_;
                if (_e165.direction.y < 0f) {
                    phi_931_ = (-1f / _e317);
                } else {
                    phi_931_ = (1f / _e317);
                }
                let _e322 = phi_931_;
                if (abs(_e165.direction.z) < _e300) {
                    phi_939_ = _e300;
                } else {
                    phi_939_ = abs(_e165.direction.z);
                }
                let _e328 = phi_939_;
                if (_e165.direction.z < 0f) {
                    phi_946_ = (-1f / _e328);
                } else {
                    phi_946_ = (1f / _e328);
                }
                let _e333 = phi_946_;
                let _e340 = abs((bitcast<f32>(_e235) - _e165.origin.x));
                let _e341 = abs((bitcast<f32>(_e239) - _e165.origin.y));
                let _e342 = abs((bitcast<f32>(_e243) - _e165.origin.z));
                let _e349 = abs(((bitcast<f32>(_e247) + (bitcast<f32>((((_e259 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e165.origin.x));
                let _e350 = abs(((bitcast<f32>(_e251) + (bitcast<f32>((((_e259 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e165.origin.y));
                let _e351 = abs(((bitcast<f32>(_e255) + (bitcast<f32>((((_e259 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e165.origin.z));
                if (_e340 > _e349) {
                    phi_969_ = _e340;
                } else {
                    phi_969_ = _e349;
                }
                let _e354 = phi_969_;
                if (_e341 > _e350) {
                    phi_974_ = _e341;
                } else {
                    phi_974_ = _e350;
                }
                let _e357 = phi_974_;
                if (_e342 > _e351) {
                    phi_979_ = _e342;
                } else {
                    phi_979_ = _e351;
                }
                let _e360 = phi_979_;
                if (_e354 > _e357) {
                    phi_984_ = _e354;
                } else {
                    phi_984_ = _e357;
                }
                let _e363 = phi_984_;
                if (_e363 > _e360) {
                    phi_989_ = _e363;
                } else {
                    phi_989_ = _e360;
                }
                let _e366 = phi_989_;
                let _e370 = (_e366 * 0.0000019073486f);
                let _e371 = (abs(_e311) * _e370);
                let _e372 = (abs(_e322) * _e370);
                let _e373 = (abs(_e333) * _e370);
                let _e377 = (_e366 * 0.0000009536743f);
                let _e378 = (abs(_e311) * _e377);
                let _e379 = (abs(_e322) * _e377);
                let _e380 = (abs(_e333) * _e377);
                if (_e311 < 0f) {
                    phi_1008_ = 0u;
                } else {
                    phi_1008_ = 1u;
                }
                let _e383 = phi_1008_;
                if (_e322 < 0f) {
                    phi_1013_ = 0u;
                } else {
                    phi_1013_ = 2u;
                }
                let _e386 = phi_1013_;
                if (_e333 < 0f) {
                    phi_1018_ = 0u;
                } else {
                    phi_1018_ = 4u;
                }
                let _e389 = phi_1018_;
                let _e391 = ((_e383 | _e386) | _e389);
                let _e392 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e114, 2147483648u);
                local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e392.first[0], _e392.first[1], _e392.first[2], _e392.first[3], _e392.first[4], _e392.first[5], _e392.first[6], _e392.first[7], _e392.first[8], _e392.first[9], _e392.first[10], _e392.first[11], _e392.first[12], _e392.first[13], _e392.first[14], _e392.first[15], _e392.first[16], _e392.first[17], _e392.first[18], _e392.first[19], _e392.first[20], _e392.first[21], _e392.first[22], _e392.first[23], _e392.first[24], _e392.first[25], _e392.first[26], _e392.first[27], _e392.first[28], _e392.first[29], _e392.first[30], _e392.first[31]), array<u32, 32>(_e392.mask[0], _e392.mask[1], _e392.mask[2], _e392.mask[3], _e392.mask[4], _e392.mask[5], _e392.mask[6], _e392.mask[7], _e392.mask[8], _e392.mask[9], _e392.mask[10], _e392.mask[11], _e392.mask[12], _e392.mask[13], _e392.mask[14], _e392.mask[15], _e392.mask[16], _e392.mask[17], _e392.mask[18], _e392.mask[19], _e392.mask[20], _e392.mask[21], _e392.mask[22], _e392.mask[23], _e392.mask[24], _e392.mask[25], _e392.mask[26], _e392.mask[27], _e392.mask[28], _e392.mask[29], _e392.mask[30], _e392.mask[31]), _e392.len, _e392.group, _e392.group_mask);
                let _e466 = local_2.group_mask;
                if ((_e466 & 4278190080u) == 0u) {
                    let _e470 = local_2.len;
                    if (_e470 == 0u) {
                        phi_1132_ = false;
                    } else {
                        let _e474 = local_2.len;
                        local_2.len = (_e474 - 1u);
                        let _e477 = local_2.len;
                        if (_e477 < 32u) {
                        } else {
                            return;
                        }
                        let _e482 = local_2.first[(0u + _e477)];
                        local_2.group = _e482;
                        let _e485 = local_2.len;
                        if (_e485 < 32u) {
                        } else {
                            return;
                        }
                        let _e490 = local_2.mask[(0u + _e485)];
                        local_2.group_mask = _e490;
                        phi_1132_ = true;
                    }
                    let _e493 = phi_1132_;
                    phi_1133_ = _e493;
                } else {
                    phi_1133_ = true;
                }
                let _e495 = phi_1133_;
                if _e495 {
                    let _e497 = local_2.group_mask;
                    let _e503 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e497)), 32u, (_e497 == 0u)));
                    let _e507 = local_2.group_mask;
                    let _e521 = local_2.group_mask;
                    local_2.group_mask = (_e521 & ~((1u << bitcast<u32>((_e503 & 31u)))));
                    let _e524 = local_2.group;
                    phi_1164_ = (_e524 + countOneBits(((_e507 & ~((4294967295u << bitcast<u32>((((_e503 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1164_ = 4294967295u;
                }
                let _e527 = phi_1164_;
                phi_1166_ = _e527;
                phi_1169_ = _e167;
                loop {
                    let _e529 = phi_1166_;
                    let _e531 = phi_1169_;
                    local_12 = _e531;
                    let _e532 = (_e529 != 4294967295u);
                    if _e532 {
                        if (_e529 < _e78) {
                        } else {
                            return;
                        }
                        let _e540 = nodes.member[(0u + _e529)].frame[3u];
                        let _e565 = (bitcast<f32>((((_e540 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e311);
                        let _e566 = (bitcast<f32>((((_e540 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e322);
                        let _e567 = (bitcast<f32>((((_e540 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e333);
                        let _e570 = nodes.member[(0u + _e529)].frame[0u];
                        let _e574 = nodes.member[(0u + _e529)].frame[1u];
                        let _e578 = nodes.member[(0u + _e529)].frame[2u];
                        let _e586 = ((bitcast<f32>(_e570) - _e165.origin.x) * _e311);
                        let _e587 = ((bitcast<f32>(_e574) - _e165.origin.y) * _e322);
                        let _e588 = ((bitcast<f32>(_e578) - _e165.origin.z) * _e333);
                        let _e596 = nodes.member[(0u + _e529)].x;
                        if (_e311 < 0f) {
                            let _e607 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e596.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e613 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e607.unnamed.word, _e596.w), _e607.unnamed_1);
                            let _e619 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e613.unnamed, lt_mask_LightPlace(_e596.x, _e613.unnamed_1.shift));
                            phi_1254_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e619.unnamed, lt_mask_LightPlace(_e619.unnamed_1.word, _e596.y));
                        } else {
                            let _e635 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e596.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e641 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e635.unnamed.word, _e596.y), _e635.unnamed_1);
                            let _e647 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e641.unnamed, lt_mask_LightPlace(_e596.z, _e641.unnamed_1.shift));
                            phi_1254_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e647.unnamed, lt_mask_LightPlace(_e647.unnamed_1.word, _e596.w));
                        }
                        let _e655 = phi_1254_;
                        let _e665 = nodes.member[(0u + _e529)].y;
                        if (_e322 < 0f) {
                            let _e676 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e665.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e682 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e676.unnamed.word, _e665.w), _e676.unnamed_1);
                            let _e688 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e682.unnamed, lt_mask_LightPlace(_e665.x, _e682.unnamed_1.shift));
                            phi_1281_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e688.unnamed, lt_mask_LightPlace(_e688.unnamed_1.word, _e665.y));
                        } else {
                            let _e704 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e665.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e710 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e704.unnamed.word, _e665.y), _e704.unnamed_1);
                            let _e716 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e710.unnamed, lt_mask_LightPlace(_e665.z, _e710.unnamed_1.shift));
                            phi_1281_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e716.unnamed, lt_mask_LightPlace(_e716.unnamed_1.word, _e665.w));
                        }
                        let _e724 = phi_1281_;
                        let _e734 = nodes.member[(0u + _e529)].z;
                        if (_e333 < 0f) {
                            let _e745 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e734.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e751 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e745.unnamed.word, _e734.w), _e745.unnamed_1);
                            let _e757 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e751.unnamed, lt_mask_LightPlace(_e734.x, _e751.unnamed_1.shift));
                            phi_1308_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e757.unnamed, lt_mask_LightPlace(_e757.unnamed_1.word, _e734.y));
                        } else {
                            let _e773 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e734.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e779 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e773.unnamed.word, _e734.y), _e773.unnamed_1);
                            let _e785 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e779.unnamed, lt_mask_LightPlace(_e734.z, _e779.unnamed_1.shift));
                            phi_1308_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e785.unnamed, lt_mask_LightPlace(_e785.unnamed_1.word, _e734.w));
                        }
                        let _e793 = phi_1308_;
                        phi_1314_ = 0u;
                        phi_1317_ = 0u;
                        loop {
                            let _e803 = phi_1314_;
                            let _e805 = phi_1317_;
                            local_3 = _e805;
                            local_4 = _e805;
                            local_5 = _e805;
                            let _e806 = (_e803 < 8u);
                            if _e806 {
                                let _e808 = (_e803 >> bitcast<u32>(2i));
                                let _e809 = (_e803 & 3u);
                                if (_e808 == 0u) {
                                    phi_1331_ = _e655.unnamed.word;
                                } else {
                                    phi_1331_ = _e655.unnamed.shift;
                                }
                                let _e812 = phi_1331_;
                                if (_e808 == 0u) {
                                    phi_1341_ = _e724.unnamed.word;
                                } else {
                                    phi_1341_ = _e724.unnamed.shift;
                                }
                                let _e821 = phi_1341_;
                                if (_e808 == 0u) {
                                    phi_1351_ = _e793.unnamed.word;
                                } else {
                                    phi_1351_ = _e793.unnamed.shift;
                                }
                                let _e830 = phi_1351_;
                                let _e843 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e812 >> bitcast<u32>(((_e809 * 8u) & 31u))) & 255u)) * _e565) + (_e586 - _e371)), ((f32(((_e821 >> bitcast<u32>(((_e809 * 8u) & 31u))) & 255u)) * _e566) + (_e587 - _e372)));
                                let _e844 = core_intrinsics_maximum_number_nsz_f32_(_e843, ((f32(((_e830 >> bitcast<u32>(((_e809 * 8u) & 31u))) & 255u)) * _e567) + (_e588 - _e373)));
                                if (_e808 == 0u) {
                                    phi_1369_ = _e655.unnamed_1.word;
                                } else {
                                    phi_1369_ = _e655.unnamed_1.shift;
                                }
                                let _e847 = phi_1369_;
                                if (_e808 == 0u) {
                                    phi_1379_ = _e724.unnamed_1.word;
                                } else {
                                    phi_1379_ = _e724.unnamed_1.shift;
                                }
                                let _e856 = phi_1379_;
                                if (_e808 == 0u) {
                                    phi_1389_ = _e793.unnamed_1.word;
                                } else {
                                    phi_1389_ = _e793.unnamed_1.shift;
                                }
                                let _e865 = phi_1389_;
                                let _e878 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e847 >> bitcast<u32>(((_e809 * 8u) & 31u))) & 255u)) * _e565) + (_e586 + _e371)), ((f32(((_e856 >> bitcast<u32>(((_e809 * 8u) & 31u))) & 255u)) * _e566) + (_e587 + _e372)));
                                let _e879 = core_intrinsics_minimum_number_nsz_f32_(_e878, ((f32(((_e865 >> bitcast<u32>(((_e809 * 8u) & 31u))) & 255u)) * _e567) + (_e588 + _e373)));
                                if (_e844 <= _e879) {
                                    if (_e844 <= _e531.t) {
                                        if (_e879 >= _e165.tmin) {
                                            if (_e808 == 0u) {
                                                let _e886 = nodes.member[(0u + _e529)].links[2u];
                                                phi_1425_ = _e886;
                                            } else {
                                                let _e889 = nodes.member[(0u + _e529)].links[3u];
                                                phi_1425_ = _e889;
                                            }
                                            let _e891 = phi_1425_;
                                            let _e896 = ((_e891 >> bitcast<u32>(((_e809 * 8u) & 31u))) & 255u);
                                            let _e897 = (_e896 & 31u);
                                            if (_e897 >= 24u) {
                                                phi_1438_ = (24u + ((_e897 - 24u) ^ _e391));
                                            } else {
                                                phi_1438_ = _e897;
                                            }
                                            let _e903 = phi_1438_;
                                            phi_1443_ = (_e805 | ((_e896 >> bitcast<u32>(5i)) << bitcast<u32>((_e903 & 31u))));
                                        } else {
                                            phi_1443_ = _e805;
                                        }
                                        let _e911 = phi_1443_;
                                        phi_1444_ = _e911;
                                    } else {
                                        phi_1444_ = _e805;
                                    }
                                    let _e913 = phi_1444_;
                                    phi_1445_ = _e913;
                                } else {
                                    phi_1445_ = _e805;
                                }
                                let _e915 = phi_1445_;
                                phi_1315_ = (_e803 + 1u);
                                phi_1318_ = _e915;
                            } else {
                                phi_1315_ = u32();
                                phi_1318_ = u32();
                            }
                            let _e918 = phi_1315_;
                            let _e920 = phi_1318_;
                            continue;
                            continuing {
                                phi_1314_ = _e918;
                                phi_1317_ = _e920;
                                break if !(_e806);
                            }
                        }
                        let _e924 = nodes.member[(0u + _e529)].links[0u];
                        let _e928 = nodes.member[(0u + _e529)].frame[3u];
                        let _e932 = local_3;
                        if ((_e932 & 4278190080u) == 0u) {
                        } else {
                            let _e936 = local_2.group_mask;
                            if ((_e936 & 4278190080u) == 0u) {
                            } else {
                                let _e940 = local_2.len;
                                if (_e940 < 32u) {
                                    let _e943 = local_2.group;
                                    let _e945 = local_2.len;
                                    if (_e945 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.first[(0u + _e945)] = _e943;
                                    let _e951 = local_2.group_mask;
                                    let _e953 = local_2.len;
                                    if (_e953 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.mask[(0u + _e953)] = _e951;
                                    let _e960 = local_2.len;
                                    local_2.len = (_e960 + 1u);
                                }
                            }
                            local_2.group = (_e114 + _e924);
                            let _e964 = local_4;
                            local_2.group_mask = ((_e964 & 4278190080u) | (_e928 >> bitcast<u32>(24i)));
                        }
                        let _e969 = local_5;
                        phi_1503_ = (_e969 & 16777215u);
                        phi_1506_ = _e531;
                        loop {
                            let _e972 = phi_1503_;
                            let _e974 = phi_1506_;
                            local_11 = _e974;
                            if (_e972 == 0u) {
                                phi_1504_ = u32();
                                phi_1507_ = lt_bvh_Hit();
                                phi_3196_ = false;
                            } else {
                                let _e978 = nodes.member[(0u + _e529)].links[1u];
                                let _e982 = (_e978 + select(firstTrailingBit(_e972), 32u, (_e972 == 0u)));
                                if (_e982 < _e93) {
                                } else {
                                    return;
                                }
                                let _e989 = instances.member[(0u + _e982)].low_world;
                                let _e991 = instances.member[(0u + _e982)].high_world;
                                let _e1001 = ((_e989.x - _e165.origin.x) * _e311);
                                let _e1002 = ((_e989.y - _e165.origin.y) * _e322);
                                let _e1003 = ((_e989.z - _e165.origin.z) * _e333);
                                let _e1013 = ((_e991.x - _e165.origin.x) * _e311);
                                let _e1014 = ((_e991.y - _e165.origin.y) * _e322);
                                let _e1015 = ((_e991.z - _e165.origin.z) * _e333);
                                if (_e1001 < _e1013) {
                                    phi_1561_ = _e1001;
                                } else {
                                    phi_1561_ = _e1013;
                                }
                                let _e1018 = phi_1561_;
                                if (_e1002 < _e1014) {
                                    phi_1566_ = _e1002;
                                } else {
                                    phi_1566_ = _e1014;
                                }
                                let _e1021 = phi_1566_;
                                if (_e1003 < _e1015) {
                                    phi_1571_ = _e1003;
                                } else {
                                    phi_1571_ = _e1015;
                                }
                                let _e1024 = phi_1571_;
                                if (_e1001 > _e1013) {
                                    phi_1579_ = _e1001;
                                } else {
                                    phi_1579_ = _e1013;
                                }
                                let _e1030 = phi_1579_;
                                if (_e1002 > _e1014) {
                                    phi_1584_ = _e1002;
                                } else {
                                    phi_1584_ = _e1014;
                                }
                                let _e1033 = phi_1584_;
                                if (_e1003 > _e1015) {
                                    phi_1589_ = _e1003;
                                } else {
                                    phi_1589_ = _e1015;
                                }
                                let _e1036 = phi_1589_;
                                let _e1040 = core_intrinsics_maximum_number_nsz_f32_((_e1018 - _e378), (_e1021 - _e379));
                                let _e1041 = core_intrinsics_maximum_number_nsz_f32_(_e1040, (_e1024 - _e380));
                                let _e1042 = core_intrinsics_minimum_number_nsz_f32_((_e1030 + _e378), (_e1033 + _e379));
                                let _e1043 = core_intrinsics_minimum_number_nsz_f32_(_e1042, (_e1036 + _e380));
                                if (_e1041 <= _e1043) {
                                    if (_e1041 <= _e974.t) {
                                        if (_e1043 >= _e165.tmin) {
                                            let _e1055 = instances.member[(0u + _e982)].world_to_object[0u];
                                            let _e1066 = ((((_e1055.x * _e165.origin.x) + (_e1055.y * _e165.origin.y)) + (_e1055.z * _e165.origin.z)) + (_e1055.w * 1f));
                                            let _e1068 = instances.member[(0u + _e982)].world_to_object[1u];
                                            let _e1079 = ((((_e1068.x * _e165.origin.x) + (_e1068.y * _e165.origin.y)) + (_e1068.z * _e165.origin.z)) + (_e1068.w * 1f));
                                            let _e1081 = instances.member[(0u + _e982)].world_to_object[2u];
                                            let _e1092 = ((((_e1081.x * _e165.origin.x) + (_e1081.y * _e165.origin.y)) + (_e1081.z * _e165.origin.z)) + (_e1081.w * 1f));
                                            let _e1099 = instances.member[(0u + _e982)].world_to_object[0u];
                                            let _e1110 = ((((_e1099.x * _e165.direction.x) + (_e1099.y * _e165.direction.y)) + (_e1099.z * _e165.direction.z)) + (_e1099.w * 0f));
                                            let _e1112 = instances.member[(0u + _e982)].world_to_object[1u];
                                            let _e1123 = ((((_e1112.x * _e165.direction.x) + (_e1112.y * _e165.direction.y)) + (_e1112.z * _e165.direction.z)) + (_e1112.w * 0f));
                                            let _e1125 = instances.member[(0u + _e982)].world_to_object[2u];
                                            let _e1136 = ((((_e1125.x * _e165.direction.x) + (_e1125.y * _e165.direction.y)) + (_e1125.z * _e165.direction.z)) + (_e1125.w * 0f));
                                            let _e1141 = instances.member[(0u + _e982)].root;
                                            let _e1143 = instances.member[(0u + _e982)].first_triangle;
                                            let _e1144 = abs(_e1110);
                                            let _e1145 = abs(_e1123);
                                            let _e1146 = abs(_e1136);
                                            if (abs(_e1066) < 1000000000000000f) {
                                                if (abs(_e1079) < 1000000000000000f) {
                                                    phi_1721_ = (abs(_e1092) < 1000000000000000f);
                                                    phi_1722_ = false;
                                                } else {
                                                    phi_1721_ = bool();
                                                    phi_1722_ = true;
                                                }
                                                let _e1154 = phi_1721_;
                                                let _e1156 = phi_1722_;
                                                phi_1723_ = _e1154;
                                                phi_1724_ = _e1156;
                                            } else {
                                                phi_1723_ = bool();
                                                phi_1724_ = true;
                                            }
                                            let _e1158 = phi_1723_;
                                            let _e1160 = phi_1724_;
                                            if _e1160 {
                                                phi_1728_ = false;
                                            } else {
                                                phi_1728_ = _e1158;
                                            }
                                            let _e1162 = phi_1728_;
                                            if _e1162 {
                                                if (_e1144 < 1000000000000000f) {
                                                    if (_e1145 < 1000000000000000f) {
                                                        phi_1741_ = (_e1146 < 1000000000000000f);
                                                        phi_1742_ = false;
                                                    } else {
                                                        phi_1741_ = bool();
                                                        phi_1742_ = true;
                                                    }
                                                    let _e1167 = phi_1741_;
                                                    let _e1169 = phi_1742_;
                                                    phi_1743_ = _e1167;
                                                    phi_1744_ = _e1169;
                                                } else {
                                                    phi_1743_ = bool();
                                                    phi_1744_ = true;
                                                }
                                                let _e1171 = phi_1743_;
                                                let _e1173 = phi_1744_;
                                                if _e1173 {
                                                    phi_1748_ = false;
                                                } else {
                                                    phi_1748_ = _e1171;
                                                }
                                                let _e1175 = phi_1748_;
                                                if _e1175 {
                                                    if (_e1144 > 0f) {
                                                        phi_1762_ = bool();
                                                        phi_1763_ = true;
                                                    } else {
                                                        let _e1177 = (_e1145 > 0f);
                                                        if _e1177 {
                                                            phi_1761_ = bool();
                                                        } else {
                                                            phi_1761_ = (_e1146 > 0f);
                                                        }
                                                        let _e1180 = phi_1761_;
                                                        phi_1762_ = _e1180;
                                                        phi_1763_ = _e1177;
                                                    }
                                                    let _e1182 = phi_1762_;
                                                    let _e1184 = phi_1763_;
                                                    if _e1184 {
                                                        phi_1767_ = true;
                                                    } else {
                                                        phi_1767_ = _e1182;
                                                    }
                                                    let _e1186 = phi_1767_;
                                                    phi_1768_ = _e1186;
                                                    phi_1769_ = false;
                                                } else {
                                                    phi_1768_ = bool();
                                                    phi_1769_ = true;
                                                }
                                                let _e1188 = phi_1768_;
                                                let _e1190 = phi_1769_;
                                                phi_1770_ = _e1188;
                                                phi_1771_ = _e1190;
                                            } else {
                                                phi_1770_ = bool();
                                                phi_1771_ = true;
                                            }
                                            let _e1192 = phi_1770_;
                                            let _e1194 = phi_1771_;
                                            if _e1194 {
                                                phi_1775_ = false;
                                            } else {
                                                phi_1775_ = _e1192;
                                            }
                                            let _e1196 = phi_1775_;
                                            if _e1196 {
                                                let _e1197 = (_e1141 >= _e78);
                                                if _e1197 {
                                                    phi_3186_ = lt_bvh_Hit();
                                                } else {
                                                    if (_e1141 < _e78) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1203 = nodes.member[(0u + _e1141)].frame[0u];
                                                    let _e1207 = nodes.member[(0u + _e1141)].frame[1u];
                                                    let _e1211 = nodes.member[(0u + _e1141)].frame[2u];
                                                    let _e1215 = nodes.member[(0u + _e1141)].frame[0u];
                                                    let _e1219 = nodes.member[(0u + _e1141)].frame[1u];
                                                    let _e1223 = nodes.member[(0u + _e1141)].frame[2u];
                                                    let _e1227 = nodes.member[(0u + _e1141)].frame[3u];
                                                    let _e1261 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1110), abs(_e1123));
                                                    let _e1262 = core_intrinsics_maximum_number_nsz_f32_(_e1261, abs(_e1136));
                                                    let _e1263 = (_e1262 * 0.0000000000009094947f);
                                                    if (abs(_e1110) < _e1263) {
                                                        phi_1845_ = _e1263;
                                                    } else {
                                                        phi_1845_ = abs(_e1110);
                                                    }
                                                    let _e1268 = phi_1845_;
                                                    if (_e1110 < 0f) {
                                                        phi_1852_ = (-1f / _e1268);
                                                    } else {
                                                        phi_1852_ = (1f / _e1268);
                                                    }
                                                    let _e1273 = phi_1852_;
                                                    if (abs(_e1123) < _e1263) {
                                                        phi_1859_ = _e1263;
                                                    } else {
                                                        phi_1859_ = abs(_e1123);
                                                    }
                                                    let _e1278 = phi_1859_;
                                                    if (_e1123 < 0f) {
                                                        phi_1866_ = (-1f / _e1278);
                                                    } else {
                                                        phi_1866_ = (1f / _e1278);
                                                    }
                                                    let _e1283 = phi_1866_;
                                                    if (abs(_e1136) < _e1263) {
                                                        phi_1873_ = _e1263;
                                                    } else {
                                                        phi_1873_ = abs(_e1136);
                                                    }
                                                    let _e1288 = phi_1873_;
                                                    if (_e1136 < 0f) {
                                                        phi_1880_ = (-1f / _e1288);
                                                    } else {
                                                        phi_1880_ = (1f / _e1288);
                                                    }
                                                    let _e1293 = phi_1880_;
                                                    let _e1297 = abs((bitcast<f32>(_e1203) - _e1066));
                                                    let _e1298 = abs((bitcast<f32>(_e1207) - _e1079));
                                                    let _e1299 = abs((bitcast<f32>(_e1211) - _e1092));
                                                    let _e1303 = abs(((bitcast<f32>(_e1215) + (bitcast<f32>((((_e1227 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1066));
                                                    let _e1304 = abs(((bitcast<f32>(_e1219) + (bitcast<f32>((((_e1227 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1079));
                                                    let _e1305 = abs(((bitcast<f32>(_e1223) + (bitcast<f32>((((_e1227 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1092));
                                                    if (_e1297 > _e1303) {
                                                        phi_1897_ = _e1297;
                                                    } else {
                                                        phi_1897_ = _e1303;
                                                    }
                                                    let _e1308 = phi_1897_;
                                                    if (_e1298 > _e1304) {
                                                        phi_1902_ = _e1298;
                                                    } else {
                                                        phi_1902_ = _e1304;
                                                    }
                                                    let _e1311 = phi_1902_;
                                                    if (_e1299 > _e1305) {
                                                        phi_1907_ = _e1299;
                                                    } else {
                                                        phi_1907_ = _e1305;
                                                    }
                                                    let _e1314 = phi_1907_;
                                                    if (_e1308 > _e1311) {
                                                        phi_1912_ = _e1308;
                                                    } else {
                                                        phi_1912_ = _e1311;
                                                    }
                                                    let _e1317 = phi_1912_;
                                                    if (_e1317 > _e1314) {
                                                        phi_1917_ = _e1317;
                                                    } else {
                                                        phi_1917_ = _e1314;
                                                    }
                                                    let _e1320 = phi_1917_;
                                                    let _e1324 = (_e1320 * 0.0000019073486f);
                                                    let _e1325 = (abs(_e1273) * _e1324);
                                                    let _e1326 = (abs(_e1283) * _e1324);
                                                    let _e1327 = (abs(_e1293) * _e1324);
                                                    let _e1331 = (_e1320 * 0.0000009536743f);
                                                    let _e1332 = (abs(_e1273) * _e1331);
                                                    let _e1333 = (abs(_e1283) * _e1331);
                                                    let _e1334 = (abs(_e1293) * _e1331);
                                                    let _e1335 = abs(_e1110);
                                                    let _e1336 = abs(_e1123);
                                                    let _e1337 = abs(_e1136);
                                                    if (_e1335 >= _e1336) {
                                                        if (_e1335 >= _e1337) {
                                                            phi_1943_ = false;
                                                        } else {
                                                            phi_1943_ = true;
                                                        }
                                                        let _e1341 = phi_1943_;
                                                        phi_1944_ = _e1341;
                                                    } else {
                                                        phi_1944_ = true;
                                                    }
                                                    let _e1343 = phi_1944_;
                                                    if _e1343 {
                                                        if (_e1336 >= _e1337) {
                                                            phi_1952_ = 1u;
                                                        } else {
                                                            phi_1952_ = 2u;
                                                        }
                                                        let _e1346 = phi_1952_;
                                                        phi_1953_ = _e1346;
                                                    } else {
                                                        phi_1953_ = 0u;
                                                    }
                                                    let _e1348 = phi_1953_;
                                                    if (_e1348 == 0u) {
                                                        phi_1965_ = vec3<f32>(_e1123, _e1136, _e1110);
                                                    } else {
                                                        if (_e1348 == 1u) {
                                                            phi_1964_ = vec3<f32>(_e1136, _e1110, _e1123);
                                                        } else {
                                                            phi_1964_ = vec3<f32>(_e1110, _e1123, _e1136);
                                                        }
                                                        let _e1354 = phi_1964_;
                                                        phi_1965_ = _e1354;
                                                    }
                                                    let _e1356 = phi_1965_;
                                                    let _e1359 = (_e1356.x / _e1356.z);
                                                    let _e1362 = (_e1356.y / _e1356.z);
                                                    if (_e1273 < 0f) {
                                                        phi_1978_ = 0u;
                                                    } else {
                                                        phi_1978_ = 1u;
                                                    }
                                                    let _e1367 = phi_1978_;
                                                    if (_e1283 < 0f) {
                                                        phi_1983_ = 0u;
                                                    } else {
                                                        phi_1983_ = 2u;
                                                    }
                                                    let _e1370 = phi_1983_;
                                                    if (_e1293 < 0f) {
                                                        phi_1988_ = 0u;
                                                    } else {
                                                        phi_1988_ = 4u;
                                                    }
                                                    let _e1373 = phi_1988_;
                                                    let _e1375 = ((_e1367 | _e1370) | _e1373);
                                                    let _e1376 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1141, 2147483648u);
                                                    local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e1376.first[0], _e1376.first[1], _e1376.first[2], _e1376.first[3], _e1376.first[4], _e1376.first[5], _e1376.first[6], _e1376.first[7], _e1376.first[8], _e1376.first[9], _e1376.first[10], _e1376.first[11], _e1376.first[12], _e1376.first[13], _e1376.first[14], _e1376.first[15], _e1376.first[16], _e1376.first[17], _e1376.first[18], _e1376.first[19], _e1376.first[20], _e1376.first[21], _e1376.first[22], _e1376.first[23], _e1376.first[24], _e1376.first[25], _e1376.first[26], _e1376.first[27], _e1376.first[28], _e1376.first[29], _e1376.first[30], _e1376.first[31]), array<u32, 32>(_e1376.mask[0], _e1376.mask[1], _e1376.mask[2], _e1376.mask[3], _e1376.mask[4], _e1376.mask[5], _e1376.mask[6], _e1376.mask[7], _e1376.mask[8], _e1376.mask[9], _e1376.mask[10], _e1376.mask[11], _e1376.mask[12], _e1376.mask[13], _e1376.mask[14], _e1376.mask[15], _e1376.mask[16], _e1376.mask[17], _e1376.mask[18], _e1376.mask[19], _e1376.mask[20], _e1376.mask[21], _e1376.mask[22], _e1376.mask[23], _e1376.mask[24], _e1376.mask[25], _e1376.mask[26], _e1376.mask[27], _e1376.mask[28], _e1376.mask[29], _e1376.mask[30], _e1376.mask[31]), _e1376.len, _e1376.group, _e1376.group_mask);
                                                    let _e1450 = local_1.group_mask;
                                                    if ((_e1450 & 4278190080u) == 0u) {
                                                        let _e1454 = local_1.len;
                                                        if (_e1454 == 0u) {
                                                            phi_2102_ = false;
                                                        } else {
                                                            let _e1458 = local_1.len;
                                                            local_1.len = (_e1458 - 1u);
                                                            let _e1461 = local_1.len;
                                                            if (_e1461 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1466 = local_1.first[(0u + _e1461)];
                                                            local_1.group = _e1466;
                                                            let _e1469 = local_1.len;
                                                            if (_e1469 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1474 = local_1.mask[(0u + _e1469)];
                                                            local_1.group_mask = _e1474;
                                                            phi_2102_ = true;
                                                        }
                                                        let _e1477 = phi_2102_;
                                                        phi_2103_ = _e1477;
                                                    } else {
                                                        phi_2103_ = true;
                                                    }
                                                    let _e1479 = phi_2103_;
                                                    if _e1479 {
                                                        let _e1481 = local_1.group_mask;
                                                        let _e1487 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1481)), 32u, (_e1481 == 0u)));
                                                        let _e1491 = local_1.group_mask;
                                                        let _e1505 = local_1.group_mask;
                                                        local_1.group_mask = (_e1505 & ~((1u << bitcast<u32>((_e1487 & 31u)))));
                                                        let _e1508 = local_1.group;
                                                        phi_2134_ = (_e1508 + countOneBits(((_e1491 & ~((4294967295u << bitcast<u32>((((_e1487 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_2134_ = 4294967295u;
                                                    }
                                                    let _e1511 = phi_2134_;
                                                    phi_2136_ = _e974;
                                                    phi_2139_ = _e1511;
                                                    loop {
                                                        let _e1513 = phi_2136_;
                                                        let _e1515 = phi_2139_;
                                                        local_10 = _e1513;
                                                        let _e1516 = (_e1515 != 4294967295u);
                                                        if _e1516 {
                                                            if (_e1515 < _e78) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1523 = nodes.member[(0u + _e1515)].frame[3u];
                                                            let _e1548 = (bitcast<f32>((((_e1523 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1273);
                                                            let _e1549 = (bitcast<f32>((((_e1523 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1283);
                                                            let _e1550 = (bitcast<f32>((((_e1523 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1293);
                                                            let _e1553 = nodes.member[(0u + _e1515)].frame[0u];
                                                            let _e1557 = nodes.member[(0u + _e1515)].frame[1u];
                                                            let _e1561 = nodes.member[(0u + _e1515)].frame[2u];
                                                            let _e1566 = ((bitcast<f32>(_e1553) - _e1066) * _e1273);
                                                            let _e1567 = ((bitcast<f32>(_e1557) - _e1079) * _e1283);
                                                            let _e1568 = ((bitcast<f32>(_e1561) - _e1092) * _e1293);
                                                            let _e1576 = nodes.member[(0u + _e1515)].x;
                                                            if (_e1273 < 0f) {
                                                                let _e1587 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1576.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1593 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1587.unnamed.word, _e1576.w), _e1587.unnamed_1);
                                                                let _e1599 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1593.unnamed, lt_mask_LightPlace(_e1576.x, _e1593.unnamed_1.shift));
                                                                phi_2220_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1599.unnamed, lt_mask_LightPlace(_e1599.unnamed_1.word, _e1576.y));
                                                            } else {
                                                                let _e1615 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1576.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1621 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1615.unnamed.word, _e1576.y), _e1615.unnamed_1);
                                                                let _e1627 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1621.unnamed, lt_mask_LightPlace(_e1576.z, _e1621.unnamed_1.shift));
                                                                phi_2220_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1627.unnamed, lt_mask_LightPlace(_e1627.unnamed_1.word, _e1576.w));
                                                            }
                                                            let _e1635 = phi_2220_;
                                                            let _e1645 = nodes.member[(0u + _e1515)].y;
                                                            if (_e1283 < 0f) {
                                                                let _e1656 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1645.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1662 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1656.unnamed.word, _e1645.w), _e1656.unnamed_1);
                                                                let _e1668 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1662.unnamed, lt_mask_LightPlace(_e1645.x, _e1662.unnamed_1.shift));
                                                                phi_2247_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1668.unnamed, lt_mask_LightPlace(_e1668.unnamed_1.word, _e1645.y));
                                                            } else {
                                                                let _e1684 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1645.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1690 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1684.unnamed.word, _e1645.y), _e1684.unnamed_1);
                                                                let _e1696 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1690.unnamed, lt_mask_LightPlace(_e1645.z, _e1690.unnamed_1.shift));
                                                                phi_2247_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1696.unnamed, lt_mask_LightPlace(_e1696.unnamed_1.word, _e1645.w));
                                                            }
                                                            let _e1704 = phi_2247_;
                                                            let _e1714 = nodes.member[(0u + _e1515)].z;
                                                            if (_e1293 < 0f) {
                                                                let _e1725 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1714.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1731 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1725.unnamed.word, _e1714.w), _e1725.unnamed_1);
                                                                let _e1737 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1731.unnamed, lt_mask_LightPlace(_e1714.x, _e1731.unnamed_1.shift));
                                                                phi_2274_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1737.unnamed, lt_mask_LightPlace(_e1737.unnamed_1.word, _e1714.y));
                                                            } else {
                                                                let _e1753 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1714.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1759 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1753.unnamed.word, _e1714.y), _e1753.unnamed_1);
                                                                let _e1765 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1759.unnamed, lt_mask_LightPlace(_e1714.z, _e1759.unnamed_1.shift));
                                                                phi_2274_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1765.unnamed, lt_mask_LightPlace(_e1765.unnamed_1.word, _e1714.w));
                                                            }
                                                            let _e1773 = phi_2274_;
                                                            phi_2280_ = 0u;
                                                            phi_2283_ = 0u;
                                                            loop {
                                                                let _e1783 = phi_2280_;
                                                                let _e1785 = phi_2283_;
                                                                local_6 = _e1785;
                                                                local_7 = _e1785;
                                                                local_8 = _e1785;
                                                                let _e1786 = (_e1783 < 8u);
                                                                if _e1786 {
                                                                    let _e1788 = (_e1783 >> bitcast<u32>(2i));
                                                                    let _e1789 = (_e1783 & 3u);
                                                                    if (_e1788 == 0u) {
                                                                        phi_2297_ = _e1635.unnamed.word;
                                                                    } else {
                                                                        phi_2297_ = _e1635.unnamed.shift;
                                                                    }
                                                                    let _e1792 = phi_2297_;
                                                                    if (_e1788 == 0u) {
                                                                        phi_2307_ = _e1704.unnamed.word;
                                                                    } else {
                                                                        phi_2307_ = _e1704.unnamed.shift;
                                                                    }
                                                                    let _e1801 = phi_2307_;
                                                                    if (_e1788 == 0u) {
                                                                        phi_2317_ = _e1773.unnamed.word;
                                                                    } else {
                                                                        phi_2317_ = _e1773.unnamed.shift;
                                                                    }
                                                                    let _e1810 = phi_2317_;
                                                                    let _e1823 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1792 >> bitcast<u32>(((_e1789 * 8u) & 31u))) & 255u)) * _e1548) + (_e1566 - _e1325)), ((f32(((_e1801 >> bitcast<u32>(((_e1789 * 8u) & 31u))) & 255u)) * _e1549) + (_e1567 - _e1326)));
                                                                    let _e1824 = core_intrinsics_maximum_number_nsz_f32_(_e1823, ((f32(((_e1810 >> bitcast<u32>(((_e1789 * 8u) & 31u))) & 255u)) * _e1550) + (_e1568 - _e1327)));
                                                                    if (_e1788 == 0u) {
                                                                        phi_2335_ = _e1635.unnamed_1.word;
                                                                    } else {
                                                                        phi_2335_ = _e1635.unnamed_1.shift;
                                                                    }
                                                                    let _e1827 = phi_2335_;
                                                                    if (_e1788 == 0u) {
                                                                        phi_2345_ = _e1704.unnamed_1.word;
                                                                    } else {
                                                                        phi_2345_ = _e1704.unnamed_1.shift;
                                                                    }
                                                                    let _e1836 = phi_2345_;
                                                                    if (_e1788 == 0u) {
                                                                        phi_2355_ = _e1773.unnamed_1.word;
                                                                    } else {
                                                                        phi_2355_ = _e1773.unnamed_1.shift;
                                                                    }
                                                                    let _e1845 = phi_2355_;
                                                                    let _e1858 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1827 >> bitcast<u32>(((_e1789 * 8u) & 31u))) & 255u)) * _e1548) + (_e1566 + _e1325)), ((f32(((_e1836 >> bitcast<u32>(((_e1789 * 8u) & 31u))) & 255u)) * _e1549) + (_e1567 + _e1326)));
                                                                    let _e1859 = core_intrinsics_minimum_number_nsz_f32_(_e1858, ((f32(((_e1845 >> bitcast<u32>(((_e1789 * 8u) & 31u))) & 255u)) * _e1550) + (_e1568 + _e1327)));
                                                                    if (_e1824 <= _e1859) {
                                                                        if (_e1824 <= _e1513.t) {
                                                                            if (_e1859 >= _e165.tmin) {
                                                                                if (_e1788 == 0u) {
                                                                                    let _e1866 = nodes.member[(0u + _e1515)].links[2u];
                                                                                    phi_2391_ = _e1866;
                                                                                } else {
                                                                                    let _e1869 = nodes.member[(0u + _e1515)].links[3u];
                                                                                    phi_2391_ = _e1869;
                                                                                }
                                                                                let _e1871 = phi_2391_;
                                                                                let _e1876 = ((_e1871 >> bitcast<u32>(((_e1789 * 8u) & 31u))) & 255u);
                                                                                let _e1877 = (_e1876 & 31u);
                                                                                if (_e1877 >= 24u) {
                                                                                    phi_2404_ = (24u + ((_e1877 - 24u) ^ _e1375));
                                                                                } else {
                                                                                    phi_2404_ = _e1877;
                                                                                }
                                                                                let _e1883 = phi_2404_;
                                                                                phi_2409_ = (_e1785 | ((_e1876 >> bitcast<u32>(5i)) << bitcast<u32>((_e1883 & 31u))));
                                                                            } else {
                                                                                phi_2409_ = _e1785;
                                                                            }
                                                                            let _e1891 = phi_2409_;
                                                                            phi_2410_ = _e1891;
                                                                        } else {
                                                                            phi_2410_ = _e1785;
                                                                        }
                                                                        let _e1893 = phi_2410_;
                                                                        phi_2411_ = _e1893;
                                                                    } else {
                                                                        phi_2411_ = _e1785;
                                                                    }
                                                                    let _e1895 = phi_2411_;
                                                                    phi_2281_ = (_e1783 + 1u);
                                                                    phi_2284_ = _e1895;
                                                                } else {
                                                                    phi_2281_ = u32();
                                                                    phi_2284_ = u32();
                                                                }
                                                                let _e1898 = phi_2281_;
                                                                let _e1900 = phi_2284_;
                                                                continue;
                                                                continuing {
                                                                    phi_2280_ = _e1898;
                                                                    phi_2283_ = _e1900;
                                                                    break if !(_e1786);
                                                                }
                                                            }
                                                            let _e1904 = nodes.member[(0u + _e1515)].links[0u];
                                                            let _e1908 = nodes.member[(0u + _e1515)].frame[3u];
                                                            let _e1912 = local_6;
                                                            if ((_e1912 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1916 = local_1.group_mask;
                                                                if ((_e1916 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1920 = local_1.len;
                                                                    if (_e1920 < 32u) {
                                                                        let _e1923 = local_1.group;
                                                                        let _e1925 = local_1.len;
                                                                        if (_e1925 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.first[(0u + _e1925)] = _e1923;
                                                                        let _e1931 = local_1.group_mask;
                                                                        let _e1933 = local_1.len;
                                                                        if (_e1933 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.mask[(0u + _e1933)] = _e1931;
                                                                        let _e1940 = local_1.len;
                                                                        local_1.len = (_e1940 + 1u);
                                                                    }
                                                                }
                                                                local_1.group = (_e1141 + _e1904);
                                                                let _e1944 = local_7;
                                                                local_1.group_mask = ((_e1944 & 4278190080u) | (_e1908 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1949 = local_8;
                                                            phi_2469_ = _e1513;
                                                            phi_2472_ = (_e1949 & 16777215u);
                                                            loop {
                                                                let _e1952 = phi_2469_;
                                                                let _e1954 = phi_2472_;
                                                                local_9 = _e1952;
                                                                if (_e1954 == 0u) {
                                                                    phi_2470_ = lt_bvh_Hit();
                                                                    phi_2473_ = u32();
                                                                    phi_3114_ = false;
                                                                } else {
                                                                    let _e1958 = nodes.member[(0u + _e1515)].links[1u];
                                                                    let _e1963 = ((_e1143 + _e1958) + select(firstTrailingBit(_e1954), 32u, (_e1954 == 0u)));
                                                                    if (_e1963 < _e81) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1970 = triangles.member[(0u + _e1963)].v0_;
                                                                    let _e1972 = (_e1970.x - _e1066);
                                                                    let _e1974 = (_e1970.y - _e1079);
                                                                    let _e1976 = (_e1970.z - _e1092);
                                                                    if (_e1348 == 0u) {
                                                                        phi_2517_ = vec3<f32>(_e1974, _e1976, _e1972);
                                                                    } else {
                                                                        if (_e1348 == 1u) {
                                                                            phi_2516_ = vec3<f32>(_e1976, _e1972, _e1974);
                                                                        } else {
                                                                            phi_2516_ = (_e1970 - vec3<f32>(_e1066, _e1079, _e1092));
                                                                        }
                                                                        let _e1984 = phi_2516_;
                                                                        phi_2517_ = _e1984;
                                                                    }
                                                                    let _e1986 = phi_2517_;
                                                                    let _e1990 = (_e1986.x - (_e1359 * _e1986.z));
                                                                    let _e1994 = (_e1986.y - (_e1362 * _e1986.z));
                                                                    let _e1996 = triangles.member[(0u + _e1963)].v1_;
                                                                    let _e1998 = (_e1996.x - _e1066);
                                                                    let _e2000 = (_e1996.y - _e1079);
                                                                    let _e2002 = (_e1996.z - _e1092);
                                                                    if (_e1348 == 0u) {
                                                                        phi_2547_ = vec3<f32>(_e2000, _e2002, _e1998);
                                                                    } else {
                                                                        if (_e1348 == 1u) {
                                                                            phi_2546_ = vec3<f32>(_e2002, _e1998, _e2000);
                                                                        } else {
                                                                            phi_2546_ = (_e1996 - vec3<f32>(_e1066, _e1079, _e1092));
                                                                        }
                                                                        let _e2010 = phi_2546_;
                                                                        phi_2547_ = _e2010;
                                                                    }
                                                                    let _e2012 = phi_2547_;
                                                                    let _e2016 = (_e2012.x - (_e1359 * _e2012.z));
                                                                    let _e2020 = (_e2012.y - (_e1362 * _e2012.z));
                                                                    let _e2022 = triangles.member[(0u + _e1963)].v2_;
                                                                    let _e2024 = (_e2022.x - _e1066);
                                                                    let _e2026 = (_e2022.y - _e1079);
                                                                    let _e2028 = (_e2022.z - _e1092);
                                                                    if (_e1348 == 0u) {
                                                                        phi_2577_ = vec3<f32>(_e2026, _e2028, _e2024);
                                                                    } else {
                                                                        if (_e1348 == 1u) {
                                                                            phi_2576_ = vec3<f32>(_e2028, _e2024, _e2026);
                                                                        } else {
                                                                            phi_2576_ = (_e2022 - vec3<f32>(_e1066, _e1079, _e1092));
                                                                        }
                                                                        let _e2036 = phi_2576_;
                                                                        phi_2577_ = _e2036;
                                                                    }
                                                                    let _e2038 = phi_2577_;
                                                                    let _e2042 = (_e2038.x - (_e1359 * _e2038.z));
                                                                    let _e2046 = (_e2038.y - (_e1362 * _e2038.z));
                                                                    if (_e2016 < _e2042) {
                                                                        phi_2596_ = true;
                                                                    } else {
                                                                        if (_e2016 == _e2042) {
                                                                            phi_2595_ = (_e2020 < _e2046);
                                                                        } else {
                                                                            phi_2595_ = false;
                                                                        }
                                                                        let _e2051 = phi_2595_;
                                                                        phi_2596_ = _e2051;
                                                                    }
                                                                    let _e2053 = phi_2596_;
                                                                    if _e2053 {
                                                                        phi_2600_ = _e2046;
                                                                        phi_2601_ = _e2042;
                                                                        phi_2602_ = _e2020;
                                                                        phi_2603_ = _e2016;
                                                                    } else {
                                                                        phi_2600_ = _e2020;
                                                                        phi_2601_ = _e2016;
                                                                        phi_2602_ = _e2046;
                                                                        phi_2603_ = _e2042;
                                                                    }
                                                                    let _e2055 = phi_2600_;
                                                                    let _e2057 = phi_2601_;
                                                                    let _e2059 = phi_2602_;
                                                                    let _e2061 = phi_2603_;
                                                                    let _e2064 = ((_e2061 * _e2055) - (_e2059 * _e2057));
                                                                    if _e2053 {
                                                                        phi_2611_ = -(_e2064);
                                                                    } else {
                                                                        phi_2611_ = _e2064;
                                                                    }
                                                                    let _e2067 = phi_2611_;
                                                                    if (_e2042 < _e1990) {
                                                                        phi_2622_ = true;
                                                                    } else {
                                                                        if (_e2042 == _e1990) {
                                                                            phi_2621_ = (_e2046 < _e1994);
                                                                        } else {
                                                                            phi_2621_ = false;
                                                                        }
                                                                        let _e2072 = phi_2621_;
                                                                        phi_2622_ = _e2072;
                                                                    }
                                                                    let _e2074 = phi_2622_;
                                                                    if _e2074 {
                                                                        phi_2626_ = _e1994;
                                                                        phi_2627_ = _e1990;
                                                                        phi_2628_ = _e2046;
                                                                        phi_2629_ = _e2042;
                                                                    } else {
                                                                        phi_2626_ = _e2046;
                                                                        phi_2627_ = _e2042;
                                                                        phi_2628_ = _e1994;
                                                                        phi_2629_ = _e1990;
                                                                    }
                                                                    let _e2076 = phi_2626_;
                                                                    let _e2078 = phi_2627_;
                                                                    let _e2080 = phi_2628_;
                                                                    let _e2082 = phi_2629_;
                                                                    let _e2085 = ((_e2082 * _e2076) - (_e2080 * _e2078));
                                                                    if _e2074 {
                                                                        phi_2637_ = -(_e2085);
                                                                    } else {
                                                                        phi_2637_ = _e2085;
                                                                    }
                                                                    let _e2088 = phi_2637_;
                                                                    if (_e1990 < _e2016) {
                                                                        phi_2648_ = true;
                                                                    } else {
                                                                        if (_e1990 == _e2016) {
                                                                            phi_2647_ = (_e1994 < _e2020);
                                                                        } else {
                                                                            phi_2647_ = false;
                                                                        }
                                                                        let _e2093 = phi_2647_;
                                                                        phi_2648_ = _e2093;
                                                                    }
                                                                    let _e2095 = phi_2648_;
                                                                    if _e2095 {
                                                                        phi_2652_ = _e2020;
                                                                        phi_2653_ = _e2016;
                                                                        phi_2654_ = _e1994;
                                                                        phi_2655_ = _e1990;
                                                                    } else {
                                                                        phi_2652_ = _e1994;
                                                                        phi_2653_ = _e1990;
                                                                        phi_2654_ = _e2020;
                                                                        phi_2655_ = _e2016;
                                                                    }
                                                                    let _e2097 = phi_2652_;
                                                                    let _e2099 = phi_2653_;
                                                                    let _e2101 = phi_2654_;
                                                                    let _e2103 = phi_2655_;
                                                                    let _e2106 = ((_e2103 * _e2097) - (_e2101 * _e2099));
                                                                    if _e2095 {
                                                                        phi_2663_ = -(_e2106);
                                                                    } else {
                                                                        phi_2663_ = _e2106;
                                                                    }
                                                                    let _e2109 = phi_2663_;
                                                                    if (_e2067 >= 0f) {
                                                                        if (_e2088 >= 0f) {
                                                                            if (_e2109 >= 0f) {
                                                                                phi_2678_ = ((_e2067 + _e2088) + _e2109);
                                                                                phi_2679_ = false;
                                                                            } else {
                                                                                phi_2678_ = f32();
                                                                                phi_2679_ = true;
                                                                            }
                                                                            let _e2116 = phi_2678_;
                                                                            let _e2118 = phi_2679_;
                                                                            phi_2680_ = _e2116;
                                                                            phi_2681_ = _e2118;
                                                                        } else {
                                                                            phi_2680_ = f32();
                                                                            phi_2681_ = true;
                                                                        }
                                                                        let _e2120 = phi_2680_;
                                                                        let _e2122 = phi_2681_;
                                                                        phi_2682_ = _e2120;
                                                                        phi_2683_ = _e2122;
                                                                    } else {
                                                                        phi_2682_ = f32();
                                                                        phi_2683_ = true;
                                                                    }
                                                                    let _e2124 = phi_2682_;
                                                                    let _e2126 = phi_2683_;
                                                                    if _e2126 {
                                                                        if (_e2067 <= 0f) {
                                                                            if (_e2088 <= 0f) {
                                                                                let _e2129 = (_e2109 <= 0f);
                                                                                if _e2129 {
                                                                                }
                                                                                phi_2701_ = ((_e2067 + _e2088) + _e2109);
                                                                                phi_2702_ = false;
                                                                                phi_2703_ = _e2129;
                                                                            } else {
                                                                                phi_2701_ = f32();
                                                                                phi_2702_ = true;
                                                                                phi_2703_ = false;
                                                                            }
                                                                            let _e2133 = phi_2701_;
                                                                            let _e2135 = phi_2702_;
                                                                            let _e2137 = phi_2703_;
                                                                            phi_2704_ = _e2133;
                                                                            phi_2705_ = _e2135;
                                                                            phi_2706_ = _e2137;
                                                                        } else {
                                                                            phi_2704_ = f32();
                                                                            phi_2705_ = true;
                                                                            phi_2706_ = false;
                                                                        }
                                                                        let _e2139 = phi_2704_;
                                                                        let _e2141 = phi_2705_;
                                                                        let _e2143 = phi_2706_;
                                                                        if _e2141 {
                                                                            phi_2710_ = false;
                                                                        } else {
                                                                            phi_2710_ = _e2143;
                                                                        }
                                                                        let _e2145 = phi_2710_;
                                                                        phi_2711_ = _e2139;
                                                                        phi_2712_ = _e2145;
                                                                    } else {
                                                                        phi_2711_ = _e2124;
                                                                        phi_2712_ = true;
                                                                    }
                                                                    let _e2147 = phi_2711_;
                                                                    let _e2149 = phi_2712_;
                                                                    if _e2149 {
                                                                        let _e2150 = (_e2147 == 0f);
                                                                        if _e2150 {
                                                                            phi_3028_ = lt_bvh_triangle_Intersection();
                                                                            phi_3029_ = false;
                                                                        } else {
                                                                            let _e2152 = triangles.member[(0u + _e1963)].v0_;
                                                                            let _e2154 = (_e2152.x - _e1066);
                                                                            let _e2156 = (_e2152.y - _e1079);
                                                                            let _e2158 = (_e2152.z - _e1092);
                                                                            if (_e1348 == 0u) {
                                                                                phi_2741_ = vec3<f32>(_e2156, _e2158, _e2154);
                                                                            } else {
                                                                                if (_e1348 == 1u) {
                                                                                    phi_2740_ = vec3<f32>(_e2158, _e2154, _e2156);
                                                                                } else {
                                                                                    phi_2740_ = (_e2152 - vec3<f32>(_e1066, _e1079, _e1092));
                                                                                }
                                                                                let _e2166 = phi_2740_;
                                                                                phi_2741_ = _e2166;
                                                                            }
                                                                            let _e2168 = phi_2741_;
                                                                            let _e2170 = triangles.member[(0u + _e1963)].v1_;
                                                                            let _e2172 = triangles.member[(0u + _e1963)].v0_;
                                                                            let _e2175 = (_e2170.x - _e2172.x);
                                                                            let _e2178 = (_e2170.y - _e2172.y);
                                                                            let _e2181 = (_e2170.z - _e2172.z);
                                                                            if (_e1348 == 0u) {
                                                                                phi_2767_ = vec3<f32>(_e2178, _e2181, _e2175);
                                                                            } else {
                                                                                if (_e1348 == 1u) {
                                                                                    phi_2766_ = vec3<f32>(_e2181, _e2175, _e2178);
                                                                                } else {
                                                                                    phi_2766_ = (_e2170 - _e2172);
                                                                                }
                                                                                let _e2188 = phi_2766_;
                                                                                phi_2767_ = _e2188;
                                                                            }
                                                                            let _e2190 = phi_2767_;
                                                                            let _e2192 = triangles.member[(0u + _e1963)].v2_;
                                                                            let _e2194 = triangles.member[(0u + _e1963)].v0_;
                                                                            let _e2197 = (_e2192.x - _e2194.x);
                                                                            let _e2200 = (_e2192.y - _e2194.y);
                                                                            let _e2203 = (_e2192.z - _e2194.z);
                                                                            if (_e1348 == 0u) {
                                                                                phi_2793_ = vec3<f32>(_e2200, _e2203, _e2197);
                                                                            } else {
                                                                                if (_e1348 == 1u) {
                                                                                    phi_2792_ = vec3<f32>(_e2203, _e2197, _e2200);
                                                                                } else {
                                                                                    phi_2792_ = (_e2192 - _e2194);
                                                                                }
                                                                                let _e2210 = phi_2792_;
                                                                                phi_2793_ = _e2210;
                                                                            }
                                                                            let _e2212 = phi_2793_;
                                                                            let _e2219 = ((_e2190.y * _e2212.z) - (_e2190.z * _e2212.y));
                                                                            let _e2226 = ((_e2190.z * _e2212.x) - (_e2190.x * _e2212.z));
                                                                            let _e2233 = ((_e2190.x * _e2212.y) - (_e2190.y * _e2212.x));
                                                                            let _e2247 = (((1f / _e1356.z) * (((_e2219 * _e2168.x) + (_e2226 * _e2168.y)) + (_e2233 * _e2168.z))) / (((_e2219 * _e1359) + (_e2226 * _e1362)) + _e2233));
                                                                            if (_e2247 > _e165.tmin) {
                                                                                if (_e2247 < _e165.tmax) {
                                                                                    let _e2251 = triangles.member[(0u + _e1963)].v0_;
                                                                                    let _e2253 = triangles.member[(0u + _e1963)].v1_;
                                                                                    if (_e2251.x < _e2253.x) {
                                                                                        phi_2849_ = _e2251.x;
                                                                                    } else {
                                                                                        phi_2849_ = _e2253.x;
                                                                                    }
                                                                                    let _e2260 = phi_2849_;
                                                                                    if (_e2251.y < _e2253.y) {
                                                                                        phi_2858_ = _e2251.y;
                                                                                    } else {
                                                                                        phi_2858_ = _e2253.y;
                                                                                    }
                                                                                    let _e2267 = phi_2858_;
                                                                                    if (_e2251.z < _e2253.z) {
                                                                                        phi_2867_ = _e2251.z;
                                                                                    } else {
                                                                                        phi_2867_ = _e2253.z;
                                                                                    }
                                                                                    let _e2274 = phi_2867_;
                                                                                    let _e2276 = triangles.member[(0u + _e1963)].v2_;
                                                                                    if (_e2260 < _e2276.x) {
                                                                                        phi_2876_ = _e2260;
                                                                                    } else {
                                                                                        phi_2876_ = _e2276.x;
                                                                                    }
                                                                                    let _e2281 = phi_2876_;
                                                                                    if (_e2267 < _e2276.y) {
                                                                                        phi_2883_ = _e2267;
                                                                                    } else {
                                                                                        phi_2883_ = _e2276.y;
                                                                                    }
                                                                                    let _e2286 = phi_2883_;
                                                                                    if (_e2274 < _e2276.z) {
                                                                                        phi_2890_ = _e2274;
                                                                                    } else {
                                                                                        phi_2890_ = _e2276.z;
                                                                                    }
                                                                                    let _e2291 = phi_2890_;
                                                                                    let _e2293 = triangles.member[(0u + _e1963)].v0_;
                                                                                    let _e2295 = triangles.member[(0u + _e1963)].v1_;
                                                                                    if (_e2293.x > _e2295.x) {
                                                                                        phi_2903_ = _e2293.x;
                                                                                    } else {
                                                                                        phi_2903_ = _e2295.x;
                                                                                    }
                                                                                    let _e2302 = phi_2903_;
                                                                                    if (_e2293.y > _e2295.y) {
                                                                                        phi_2912_ = _e2293.y;
                                                                                    } else {
                                                                                        phi_2912_ = _e2295.y;
                                                                                    }
                                                                                    let _e2309 = phi_2912_;
                                                                                    if (_e2293.z > _e2295.z) {
                                                                                        phi_2921_ = _e2293.z;
                                                                                    } else {
                                                                                        phi_2921_ = _e2295.z;
                                                                                    }
                                                                                    let _e2316 = phi_2921_;
                                                                                    let _e2318 = triangles.member[(0u + _e1963)].v2_;
                                                                                    if (_e2302 > _e2318.x) {
                                                                                        phi_2930_ = _e2302;
                                                                                    } else {
                                                                                        phi_2930_ = _e2318.x;
                                                                                    }
                                                                                    let _e2323 = phi_2930_;
                                                                                    if (_e2309 > _e2318.y) {
                                                                                        phi_2937_ = _e2309;
                                                                                    } else {
                                                                                        phi_2937_ = _e2318.y;
                                                                                    }
                                                                                    let _e2328 = phi_2937_;
                                                                                    if (_e2316 > _e2318.z) {
                                                                                        phi_2944_ = _e2316;
                                                                                    } else {
                                                                                        phi_2944_ = _e2318.z;
                                                                                    }
                                                                                    let _e2333 = phi_2944_;
                                                                                    let _e2337 = ((_e2281 - _e1066) * _e1273);
                                                                                    let _e2338 = ((_e2286 - _e1079) * _e1283);
                                                                                    let _e2339 = ((_e2291 - _e1092) * _e1293);
                                                                                    let _e2343 = ((_e2323 - _e1066) * _e1273);
                                                                                    let _e2344 = ((_e2328 - _e1079) * _e1283);
                                                                                    let _e2345 = ((_e2333 - _e1092) * _e1293);
                                                                                    if (_e2337 < _e2343) {
                                                                                        phi_2961_ = _e2337;
                                                                                    } else {
                                                                                        phi_2961_ = _e2343;
                                                                                    }
                                                                                    let _e2348 = phi_2961_;
                                                                                    if (_e2338 < _e2344) {
                                                                                        phi_2966_ = _e2338;
                                                                                    } else {
                                                                                        phi_2966_ = _e2344;
                                                                                    }
                                                                                    let _e2351 = phi_2966_;
                                                                                    if (_e2339 < _e2345) {
                                                                                        phi_2971_ = _e2339;
                                                                                    } else {
                                                                                        phi_2971_ = _e2345;
                                                                                    }
                                                                                    let _e2354 = phi_2971_;
                                                                                    if (_e2337 > _e2343) {
                                                                                        phi_2979_ = _e2337;
                                                                                    } else {
                                                                                        phi_2979_ = _e2343;
                                                                                    }
                                                                                    let _e2360 = phi_2979_;
                                                                                    if (_e2338 > _e2344) {
                                                                                        phi_2984_ = _e2338;
                                                                                    } else {
                                                                                        phi_2984_ = _e2344;
                                                                                    }
                                                                                    let _e2363 = phi_2984_;
                                                                                    if (_e2339 > _e2345) {
                                                                                        phi_2989_ = _e2339;
                                                                                    } else {
                                                                                        phi_2989_ = _e2345;
                                                                                    }
                                                                                    let _e2366 = phi_2989_;
                                                                                    let _e2370 = core_intrinsics_maximum_number_nsz_f32_((_e2348 - _e1332), (_e2351 - _e1333));
                                                                                    let _e2371 = core_intrinsics_maximum_number_nsz_f32_(_e2370, (_e2354 - _e1334));
                                                                                    let _e2372 = core_intrinsics_minimum_number_nsz_f32_((_e2360 + _e1332), (_e2363 + _e1333));
                                                                                    let _e2373 = core_intrinsics_minimum_number_nsz_f32_(_e2372, (_e2366 + _e1334));
                                                                                    if (_e2371 > _e1041) {
                                                                                        phi_3001_ = _e2371;
                                                                                    } else {
                                                                                        phi_3001_ = _e1041;
                                                                                    }
                                                                                    let _e2376 = phi_3001_;
                                                                                    if (_e2373 < _e1043) {
                                                                                        phi_3006_ = _e2373;
                                                                                    } else {
                                                                                        phi_3006_ = _e1043;
                                                                                    }
                                                                                    let _e2379 = phi_3006_;
                                                                                    if (_e2247 < _e2376) {
                                                                                        phi_3011_ = _e2376;
                                                                                    } else {
                                                                                        phi_3011_ = _e2247;
                                                                                    }
                                                                                    let _e2382 = phi_3011_;
                                                                                    if (_e2382 > _e2379) {
                                                                                        phi_3016_ = _e2379;
                                                                                    } else {
                                                                                        phi_3016_ = _e2382;
                                                                                    }
                                                                                    let _e2385 = phi_3016_;
                                                                                    phi_3021_ = lt_bvh_triangle_Intersection(_e2385, (_e2088 / _e2147), (_e2109 / _e2147), (_e2376 <= _e2379));
                                                                                    phi_3022_ = false;
                                                                                } else {
                                                                                    phi_3021_ = lt_bvh_triangle_Intersection();
                                                                                    phi_3022_ = true;
                                                                                }
                                                                                let _e2391 = phi_3021_;
                                                                                let _e2393 = phi_3022_;
                                                                                phi_3023_ = _e2391;
                                                                                phi_3024_ = _e2393;
                                                                            } else {
                                                                                phi_3023_ = lt_bvh_triangle_Intersection();
                                                                                phi_3024_ = true;
                                                                            }
                                                                            let _e2395 = phi_3023_;
                                                                            let _e2397 = phi_3024_;
                                                                            if _e2397 {
                                                                            }
                                                                            phi_3028_ = _e2395;
                                                                            phi_3029_ = _e2397;
                                                                        }
                                                                        let _e2399 = phi_3028_;
                                                                        let _e2401 = phi_3029_;
                                                                        phi_3030_ = _e2399;
                                                                        phi_3031_ = _e2150;
                                                                        phi_3032_ = _e2401;
                                                                    } else {
                                                                        phi_3030_ = lt_bvh_triangle_Intersection();
                                                                        phi_3031_ = true;
                                                                        phi_3032_ = false;
                                                                    }
                                                                    let _e2403 = phi_3030_;
                                                                    let _e2405 = phi_3031_;
                                                                    let _e2407 = phi_3032_;
                                                                    if _e2405 {
                                                                        phi_3036_ = true;
                                                                    } else {
                                                                        phi_3036_ = _e2407;
                                                                    }
                                                                    let _e2409 = phi_3036_;
                                                                    if _e2409 {
                                                                        phi_3040_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_3040_ = _e2403;
                                                                    }
                                                                    let _e2411 = phi_3040_;
                                                                    if _e2411.is_hit {
                                                                        if (_e2411.t > _e165.tmin) {
                                                                            if (_e2411.t < _e1952.t) {
                                                                                phi_3088_ = true;
                                                                            } else {
                                                                                if (_e2411.t == _e1952.t) {
                                                                                    if (_e1952.triangle != 4294967295u) {
                                                                                        if (_e1963 < _e1952.triangle) {
                                                                                            phi_3079_ = true;
                                                                                        } else {
                                                                                            if (_e1963 == _e1952.triangle) {
                                                                                                phi_3078_ = (_e982 < _e1952.instance);
                                                                                            } else {
                                                                                                phi_3078_ = false;
                                                                                            }
                                                                                            let _e2429 = phi_3078_;
                                                                                            phi_3079_ = _e2429;
                                                                                        }
                                                                                        let _e2431 = phi_3079_;
                                                                                        phi_3080_ = _e2431;
                                                                                        phi_3081_ = false;
                                                                                    } else {
                                                                                        phi_3080_ = bool();
                                                                                        phi_3081_ = true;
                                                                                    }
                                                                                    let _e2433 = phi_3080_;
                                                                                    let _e2435 = phi_3081_;
                                                                                    phi_3082_ = _e2433;
                                                                                    phi_3083_ = _e2435;
                                                                                } else {
                                                                                    phi_3082_ = bool();
                                                                                    phi_3083_ = true;
                                                                                }
                                                                                let _e2437 = phi_3082_;
                                                                                let _e2439 = phi_3083_;
                                                                                if _e2439 {
                                                                                    phi_3087_ = false;
                                                                                } else {
                                                                                    phi_3087_ = _e2437;
                                                                                }
                                                                                let _e2441 = phi_3087_;
                                                                                phi_3088_ = _e2441;
                                                                            }
                                                                            let _e2443 = phi_3088_;
                                                                            if _e2443 {
                                                                                let _e2445 = triangles.member[(0u + _e1963)].i0_;
                                                                                if ((_e2445 & 2147483648u) == 0u) {
                                                                                    phi_3102_ = true;
                                                                                } else {
                                                                                    if true {
                                                                                    }
                                                                                    phi_3102_ = true;
                                                                                }
                                                                                let _e2449 = phi_3102_;
                                                                                if _e2449 {
                                                                                    phi_3110_ = lt_bvh_Hit(_e2411.t, _e2411.u, _e2411.v, _e1963, _e982);
                                                                                } else {
                                                                                    phi_3110_ = _e1952;
                                                                                }
                                                                                let _e2455 = phi_3110_;
                                                                                phi_3111_ = _e2455;
                                                                            } else {
                                                                                phi_3111_ = _e1952;
                                                                            }
                                                                            let _e2457 = phi_3111_;
                                                                            phi_3112_ = _e2457;
                                                                        } else {
                                                                            phi_3112_ = _e1952;
                                                                        }
                                                                        let _e2459 = phi_3112_;
                                                                        phi_3113_ = _e2459;
                                                                    } else {
                                                                        phi_3113_ = _e1952;
                                                                    }
                                                                    let _e2461 = phi_3113_;
                                                                    phi_2470_ = _e2461;
                                                                    phi_2473_ = (_e1954 & (_e1954 - 1u));
                                                                    phi_3114_ = true;
                                                                }
                                                                let _e2463 = phi_2470_;
                                                                let _e2465 = phi_2473_;
                                                                let _e2467 = phi_3114_;
                                                                continue;
                                                                continuing {
                                                                    phi_2469_ = _e2463;
                                                                    phi_2472_ = _e2465;
                                                                    break if !(_e2467);
                                                                }
                                                            }
                                                            let _e2470 = local_1.group_mask;
                                                            if ((_e2470 & 4278190080u) == 0u) {
                                                                let _e2474 = local_1.len;
                                                                if (_e2474 == 0u) {
                                                                    phi_3153_ = false;
                                                                } else {
                                                                    let _e2478 = local_1.len;
                                                                    local_1.len = (_e2478 - 1u);
                                                                    let _e2481 = local_1.len;
                                                                    if (_e2481 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2486 = local_1.first[(0u + _e2481)];
                                                                    local_1.group = _e2486;
                                                                    let _e2489 = local_1.len;
                                                                    if (_e2489 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2494 = local_1.mask[(0u + _e2489)];
                                                                    local_1.group_mask = _e2494;
                                                                    phi_3153_ = true;
                                                                }
                                                                let _e2497 = phi_3153_;
                                                                phi_3154_ = _e2497;
                                                            } else {
                                                                phi_3154_ = true;
                                                            }
                                                            let _e2499 = phi_3154_;
                                                            if _e2499 {
                                                                let _e2501 = local_1.group_mask;
                                                                let _e2507 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2501)), 32u, (_e2501 == 0u)));
                                                                let _e2511 = local_1.group_mask;
                                                                let _e2525 = local_1.group_mask;
                                                                local_1.group_mask = (_e2525 & ~((1u << bitcast<u32>((_e2507 & 31u)))));
                                                                let _e2528 = local_1.group;
                                                                phi_3185_ = (_e2528 + countOneBits(((_e2511 & ~((4294967295u << bitcast<u32>((((_e2507 - 24u) ^ _e1375) & 31u))))) & 255u)));
                                                            } else {
                                                                phi_3185_ = 4294967295u;
                                                            }
                                                            let _e2531 = phi_3185_;
                                                            let _e3850 = local_9;
                                                            phi_2137_ = _e3850;
                                                            phi_2140_ = _e2531;
                                                        } else {
                                                            phi_2137_ = lt_bvh_Hit();
                                                            phi_2140_ = u32();
                                                        }
                                                        let _e2533 = phi_2137_;
                                                        let _e2535 = phi_2140_;
                                                        continue;
                                                        continuing {
                                                            phi_2136_ = _e2533;
                                                            phi_2139_ = _e2535;
                                                            break if !(_e1516);
                                                        }
                                                    }
                                                    let _e3854 = local_10;
                                                    phi_3186_ = _e3854;
                                                }
                                                let _e2538 = phi_3186_;
                                                phi_3187_ = _e2538;
                                                phi_3188_ = _e1197;
                                            } else {
                                                phi_3187_ = lt_bvh_Hit();
                                                phi_3188_ = true;
                                            }
                                            let _e2540 = phi_3187_;
                                            let _e2542 = phi_3188_;
                                            if _e2542 {
                                                phi_3192_ = _e974;
                                            } else {
                                                phi_3192_ = _e2540;
                                            }
                                            let _e2544 = phi_3192_;
                                            phi_3193_ = _e2544;
                                        } else {
                                            phi_3193_ = _e974;
                                        }
                                        let _e2546 = phi_3193_;
                                        phi_3194_ = _e2546;
                                    } else {
                                        phi_3194_ = _e974;
                                    }
                                    let _e2548 = phi_3194_;
                                    phi_3195_ = _e2548;
                                } else {
                                    phi_3195_ = _e974;
                                }
                                let _e2550 = phi_3195_;
                                phi_1504_ = (_e972 & (_e972 - 1u));
                                phi_1507_ = _e2550;
                                phi_3196_ = true;
                            }
                            let _e2552 = phi_1504_;
                            let _e2554 = phi_1507_;
                            let _e2556 = phi_3196_;
                            continue;
                            continuing {
                                phi_1503_ = _e2552;
                                phi_1506_ = _e2554;
                                break if !(_e2556);
                            }
                        }
                        let _e2559 = local_2.group_mask;
                        if ((_e2559 & 4278190080u) == 0u) {
                            let _e2563 = local_2.len;
                            if (_e2563 == 0u) {
                                phi_3235_ = false;
                            } else {
                                let _e2567 = local_2.len;
                                local_2.len = (_e2567 - 1u);
                                let _e2570 = local_2.len;
                                if (_e2570 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2575 = local_2.first[(0u + _e2570)];
                                local_2.group = _e2575;
                                let _e2578 = local_2.len;
                                if (_e2578 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2583 = local_2.mask[(0u + _e2578)];
                                local_2.group_mask = _e2583;
                                phi_3235_ = true;
                            }
                            let _e2586 = phi_3235_;
                            phi_3236_ = _e2586;
                        } else {
                            phi_3236_ = true;
                        }
                        let _e2588 = phi_3236_;
                        if _e2588 {
                            let _e2590 = local_2.group_mask;
                            let _e2596 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2590)), 32u, (_e2590 == 0u)));
                            let _e2600 = local_2.group_mask;
                            let _e2614 = local_2.group_mask;
                            local_2.group_mask = (_e2614 & ~((1u << bitcast<u32>((_e2596 & 31u)))));
                            let _e2617 = local_2.group;
                            phi_3267_ = (_e2617 + countOneBits(((_e2600 & ~((4294967295u << bitcast<u32>((((_e2596 - 24u) ^ _e391) & 31u))))) & 255u)));
                        } else {
                            phi_3267_ = 4294967295u;
                        }
                        let _e2620 = phi_3267_;
                        phi_1167_ = _e2620;
                        let _e3870 = local_11;
                        phi_1170_ = _e3870;
                    } else {
                        phi_1167_ = u32();
                        phi_1170_ = lt_bvh_Hit();
                    }
                    let _e2622 = phi_1167_;
                    let _e2624 = phi_1170_;
                    continue;
                    continuing {
                        phi_1166_ = _e2622;
                        phi_1169_ = _e2624;
                        break if !(_e532);
                    }
                }
                let _e3873 = local_12;
                phi_3268_ = _e3873;
            }
            let _e2627 = phi_3268_;
            phi_3269_ = _e2627;
            phi_3270_ = _e229;
        } else {
            phi_3269_ = lt_bvh_Hit();
            phi_3270_ = true;
        }
        let _e2629 = phi_3269_;
        let _e2631 = phi_3270_;
        if _e2631 {
            phi_3274_ = _e167;
        } else {
            phi_3274_ = _e2629;
        }
        let _e2633 = phi_3274_;
        if (_e2633.triangle != 4294967295u) {
            let _e2639 = ((1f - _e2633.u) - _e2633.v);
            if (_e2633.triangle < _e81) {
            } else {
                return;
            }
            let _e2644 = triangles.member[(0u + _e2633.triangle)];
            if (_e2633.instance < _e93) {
            } else {
                return;
            }
            let _e2655 = instances.member[(0u + _e2633.instance)].object_to_world[0u];
            let _e2666 = ((((_e2655.x * _e2644.v0_.x) + (_e2655.y * _e2644.v0_.y)) + (_e2655.z * _e2644.v0_.z)) + (_e2655.w * 1f));
            let _e2668 = instances.member[(0u + _e2633.instance)].object_to_world[1u];
            let _e2679 = ((((_e2668.x * _e2644.v0_.x) + (_e2668.y * _e2644.v0_.y)) + (_e2668.z * _e2644.v0_.z)) + (_e2668.w * 1f));
            let _e2681 = instances.member[(0u + _e2633.instance)].object_to_world[2u];
            let _e2692 = ((((_e2681.x * _e2644.v0_.x) + (_e2681.y * _e2644.v0_.y)) + (_e2681.z * _e2644.v0_.z)) + (_e2681.w * 1f));
            let _e2699 = instances.member[(0u + _e2633.instance)].object_to_world[0u];
            let _e2710 = ((((_e2699.x * _e2644.v1_.x) + (_e2699.y * _e2644.v1_.y)) + (_e2699.z * _e2644.v1_.z)) + (_e2699.w * 1f));
            let _e2712 = instances.member[(0u + _e2633.instance)].object_to_world[1u];
            let _e2723 = ((((_e2712.x * _e2644.v1_.x) + (_e2712.y * _e2644.v1_.y)) + (_e2712.z * _e2644.v1_.z)) + (_e2712.w * 1f));
            let _e2725 = instances.member[(0u + _e2633.instance)].object_to_world[2u];
            let _e2736 = ((((_e2725.x * _e2644.v1_.x) + (_e2725.y * _e2644.v1_.y)) + (_e2725.z * _e2644.v1_.z)) + (_e2725.w * 1f));
            let _e2743 = instances.member[(0u + _e2633.instance)].object_to_world[0u];
            let _e2754 = ((((_e2743.x * _e2644.v2_.x) + (_e2743.y * _e2644.v2_.y)) + (_e2743.z * _e2644.v2_.z)) + (_e2743.w * 1f));
            let _e2756 = instances.member[(0u + _e2633.instance)].object_to_world[1u];
            let _e2767 = ((((_e2756.x * _e2644.v2_.x) + (_e2756.y * _e2644.v2_.y)) + (_e2756.z * _e2644.v2_.z)) + (_e2756.w * 1f));
            let _e2769 = instances.member[(0u + _e2633.instance)].object_to_world[2u];
            let _e2780 = ((((_e2769.x * _e2644.v2_.x) + (_e2769.y * _e2644.v2_.y)) + (_e2769.z * _e2644.v2_.z)) + (_e2769.w * 1f));
            let _e2793 = (((_e2666 * _e2639) + (_e2710 * _e2633.u)) + (_e2754 * _e2633.v));
            let _e2794 = (((_e2679 * _e2639) + (_e2723 * _e2633.u)) + (_e2767 * _e2633.v));
            let _e2795 = (((_e2692 * _e2639) + (_e2736 * _e2633.u)) + (_e2780 * _e2633.v));
            let _e2797 = abs(_e2666);
            let _e2798 = abs(_e2679);
            let _e2799 = abs(_e2692);
            let _e2800 = abs(_e2710);
            let _e2801 = abs(_e2723);
            let _e2802 = abs(_e2736);
            if (_e2797 > _e2800) {
                phi_3461_ = _e2797;
            } else {
                phi_3461_ = _e2800;
            }
            let _e2805 = phi_3461_;
            if (_e2798 > _e2801) {
                phi_3466_ = _e2798;
            } else {
                phi_3466_ = _e2801;
            }
            let _e2808 = phi_3466_;
            if (_e2799 > _e2802) {
                phi_3471_ = _e2799;
            } else {
                phi_3471_ = _e2802;
            }
            let _e2811 = phi_3471_;
            let _e2812 = abs(_e2754);
            let _e2813 = abs(_e2767);
            let _e2814 = abs(_e2780);
            if (_e2805 > _e2812) {
                phi_3479_ = _e2805;
            } else {
                phi_3479_ = _e2812;
            }
            let _e2817 = phi_3479_;
            if (_e2808 > _e2813) {
                phi_3484_ = _e2808;
            } else {
                phi_3484_ = _e2813;
            }
            let _e2820 = phi_3484_;
            if (_e2811 > _e2814) {
                phi_3489_ = _e2811;
            } else {
                phi_3489_ = _e2814;
            }
            let _e2823 = phi_3489_;
            let _e2824 = (_e2710 - _e2666);
            let _e2825 = (_e2723 - _e2679);
            let _e2826 = (_e2736 - _e2692);
            let _e2827 = (_e2754 - _e2666);
            let _e2828 = (_e2767 - _e2679);
            let _e2829 = (_e2780 - _e2692);
            let _e2833 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2825), abs(_e2826));
            let _e2834 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2824), _e2833);
            let _e2835 = (_e2824 / _e2834);
            let _e2836 = (_e2825 / _e2834);
            let _e2837 = (_e2826 / _e2834);
            let _e2841 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2828), abs(_e2829));
            let _e2842 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2827), _e2841);
            let _e2843 = (_e2827 / _e2842);
            let _e2844 = (_e2828 / _e2842);
            let _e2845 = (_e2829 / _e2842);
            let _e2848 = ((_e2836 * _e2845) - (_e2844 * _e2837));
            let _e2851 = ((_e2837 * _e2843) - (_e2845 * _e2835));
            let _e2854 = ((_e2835 * _e2844) - (_e2843 * _e2836));
            let _e2856 = p.member.eye;
            let _e2869 = (1f / sqrt((((_e2848 * _e2848) + (_e2851 * _e2851)) + (_e2854 * _e2854))));
            let _e2870 = (_e2848 * _e2869);
            let _e2871 = (_e2851 * _e2869);
            let _e2872 = (_e2854 * _e2869);
            if ((((_e2870 * (_e2856.x - _e2793)) + (_e2871 * (_e2856.y - _e2794))) + (_e2872 * (_e2856.z - _e2795))) < 0f) {
                phi_3553_ = vec3<f32>(-(_e2870), -(_e2871), -(_e2872));
            } else {
                phi_3553_ = vec3<f32>(_e2870, _e2871, _e2872);
            }
            let _e2885 = phi_3553_;
            if (_e2633.triangle < _e81) {
            } else {
                return;
            }
            let _e2890 = triangles.member[(0u + _e2633.triangle)];
            let _e2892 = (_e2890.i0_ & 2147483647u);
            if (_e2892 < _e84) {
            } else {
                return;
            }
            let _e2898 = vertices.member[(0u + _e2892)];
            if (_e2890.i1_ < _e84) {
            } else {
                return;
            }
            let _e2902 = vertices.member[(0u + _e2890.i1_)];
            if (_e2890.i2_ < _e84) {
            } else {
                return;
            }
            let _e2906 = vertices.member[(0u + _e2890.i2_)];
            let _e2907 = array<abi_Vertex, 3>(_e2898, _e2902, _e2906);
            if (_e2907[0].material < arrayLength((&materials.member))) {
            } else {
                return;
            }
            let _e2913 = materials.member[(0u + _e2907[0].material)];
            let _e2930 = (1f / 255f);
            let _e2949 = (1f / 255f);
            let _e2971 = (1f / 255f);
            if (_e2913.color_size == 0u) {
                phi_3796_ = vec3<f32>(1f, 1f, 1f);
            } else {
                local.offset = _e2913.color_offset;
                local.size = _e2913.color_size;
                local.flags = _e2913.flags;
                let _e3014 = _lt_shaders_texture_TextureView_quad((&local), (((_e2907[0].u * _e2639) + (_e2907[1].u * _e2633.u)) + (_e2907[2].u * _e2633.v)), (((_e2907[0].v * _e2639) + (_e2907[1].v * _e2633.u)) + (_e2907[2].v * _e2633.v)));
                if (_e3014.indices[0] < _e96) {
                } else {
                    return;
                }
                let _e3020 = color_texels.member[(0u + _e3014.indices[0])];
                let _e3031 = (1f / 255f);
                if (_e3014.indices[1] < _e96) {
                } else {
                    return;
                }
                let _e3045 = color_texels.member[(0u + _e3014.indices[1])];
                let _e3056 = (1f / 255f);
                if (_e3014.indices[2] < _e96) {
                } else {
                    return;
                }
                let _e3073 = color_texels.member[(0u + _e3014.indices[2])];
                let _e3084 = (1f / 255f);
                if (_e3014.indices[3] < _e96) {
                } else {
                    return;
                }
                let _e3101 = color_texels.member[(0u + _e3014.indices[3])];
                let _e3112 = (1f / 255f);
                let _e3121 = (((((f32((_e3020 & 255u)) * _e3031) * _e3014.weights.x) + ((f32((_e3045 & 255u)) * _e3056) * _e3014.weights.y)) + ((f32((_e3073 & 255u)) * _e3084) * _e3014.weights.z)) + ((f32((_e3101 & 255u)) * _e3112) * _e3014.weights.w));
                let _e3122 = (((((f32(((_e3020 >> bitcast<u32>(8i)) & 255u)) * _e3031) * _e3014.weights.x) + ((f32(((_e3045 >> bitcast<u32>(8i)) & 255u)) * _e3056) * _e3014.weights.y)) + ((f32(((_e3073 >> bitcast<u32>(8i)) & 255u)) * _e3084) * _e3014.weights.z)) + ((f32(((_e3101 >> bitcast<u32>(8i)) & 255u)) * _e3112) * _e3014.weights.w));
                let _e3123 = (((((f32(((_e3020 >> bitcast<u32>(16i)) & 255u)) * _e3031) * _e3014.weights.x) + ((f32(((_e3045 >> bitcast<u32>(16i)) & 255u)) * _e3056) * _e3014.weights.y)) + ((f32(((_e3073 >> bitcast<u32>(16i)) & 255u)) * _e3084) * _e3014.weights.z)) + ((f32(((_e3101 >> bitcast<u32>(16i)) & 255u)) * _e3112) * _e3014.weights.w));
                phi_3796_ = vec3<f32>((_e3121 * _e3121), (_e3122 * _e3122), (_e3123 * _e3123));
            }
            let _e3129 = phi_3796_;
            let _e3131 = ((_e2913.base_color.x * ((((f32((_e2907[0].color & 255u)) * _e2930) * _e2639) + ((f32((_e2907[1].color & 255u)) * _e2949) * _e2633.u)) + ((f32((_e2907[2].color & 255u)) * _e2971) * _e2633.v))) * _e3129.x);
            let _e3133 = ((_e2913.base_color.y * ((((f32(((_e2907[0].color >> bitcast<u32>(8i)) & 255u)) * _e2930) * _e2639) + ((f32(((_e2907[1].color >> bitcast<u32>(8i)) & 255u)) * _e2949) * _e2633.u)) + ((f32(((_e2907[2].color >> bitcast<u32>(8i)) & 255u)) * _e2971) * _e2633.v))) * _e3129.y);
            let _e3135 = ((_e2913.base_color.z * ((((f32(((_e2907[0].color >> bitcast<u32>(16i)) & 255u)) * _e2930) * _e2639) + ((f32(((_e2907[1].color >> bitcast<u32>(16i)) & 255u)) * _e2949) * _e2633.u)) + ((f32(((_e2907[2].color >> bitcast<u32>(16i)) & 255u)) * _e2971) * _e2633.v))) * _e3129.z);
            let _e3136 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e2820, _e2823);
            let _e3137 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e2817, _e3136);
            if ((_e2913.flags & 2u) == 0u) {
                phi_3811_ = 0u;
            } else {
                phi_3811_ = 1u;
            }
            let _e3142 = phi_3811_;
            if (_e2907[0].normal == 2147516416u) {
                phi_4041_ = _e2885;
            } else {
                let _e3155 = (f32((bitcast<i32>((_e2907[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3161 = (f32((bitcast<i32>(_e2907[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3165 = ((1f - abs(_e3155)) - abs(_e3161));
                if (_e3165 < 0f) {
                    phi_3838_ = -(_e3165);
                } else {
                    phi_3838_ = 0f;
                }
                let _e3169 = phi_3838_;
                if (_e3155 < 0f) {
                    phi_3845_ = (_e3155 + _e3169);
                } else {
                    phi_3845_ = (_e3155 - _e3169);
                }
                let _e3174 = phi_3845_;
                if (_e3161 < 0f) {
                    phi_3852_ = (_e3161 + _e3169);
                } else {
                    phi_3852_ = (_e3161 - _e3169);
                }
                let _e3179 = phi_3852_;
                let _e3186 = (1f / sqrt((((_e3174 * _e3174) + (_e3179 * _e3179)) + (_e3165 * _e3165))));
                let _e3202 = (f32((bitcast<i32>((_e2907[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3208 = (f32((bitcast<i32>(_e2907[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3212 = ((1f - abs(_e3202)) - abs(_e3208));
                if (_e3212 < 0f) {
                    phi_3887_ = -(_e3212);
                } else {
                    phi_3887_ = 0f;
                }
                let _e3216 = phi_3887_;
                if (_e3202 < 0f) {
                    phi_3894_ = (_e3202 + _e3216);
                } else {
                    phi_3894_ = (_e3202 - _e3216);
                }
                let _e3221 = phi_3894_;
                if (_e3208 < 0f) {
                    phi_3901_ = (_e3208 + _e3216);
                } else {
                    phi_3901_ = (_e3208 - _e3216);
                }
                let _e3226 = phi_3901_;
                let _e3233 = (1f / sqrt((((_e3221 * _e3221) + (_e3226 * _e3226)) + (_e3212 * _e3212))));
                let _e3252 = (f32((bitcast<i32>((_e2907[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3258 = (f32((bitcast<i32>(_e2907[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3262 = ((1f - abs(_e3252)) - abs(_e3258));
                if (_e3262 < 0f) {
                    phi_3939_ = -(_e3262);
                } else {
                    phi_3939_ = 0f;
                }
                let _e3266 = phi_3939_;
                if (_e3252 < 0f) {
                    phi_3946_ = (_e3252 + _e3266);
                } else {
                    phi_3946_ = (_e3252 - _e3266);
                }
                let _e3271 = phi_3946_;
                if (_e3258 < 0f) {
                    phi_3953_ = (_e3258 + _e3266);
                } else {
                    phi_3953_ = (_e3258 - _e3266);
                }
                let _e3276 = phi_3953_;
                let _e3283 = (1f / sqrt((((_e3271 * _e3271) + (_e3276 * _e3276)) + (_e3262 * _e3262))));
                let _e3290 = ((((_e3174 * _e3186) * _e2639) + ((_e3221 * _e3233) * _e2633.u)) + ((_e3271 * _e3283) * _e2633.v));
                let _e3291 = ((((_e3179 * _e3186) * _e2639) + ((_e3226 * _e3233) * _e2633.u)) + ((_e3276 * _e3283) * _e2633.v));
                let _e3292 = ((((_e3165 * _e3186) * _e2639) + ((_e3212 * _e3233) * _e2633.u)) + ((_e3262 * _e3283) * _e2633.v));
                if (_e2633.instance < _e93) {
                } else {
                    return;
                }
                let _e3299 = instances.member[(0u + _e2633.instance)].world_to_object[0u];
                let _e3308 = instances.member[(0u + _e2633.instance)].world_to_object[1u];
                let _e3320 = instances.member[(0u + _e2633.instance)].world_to_object[2u];
                let _e3327 = (((_e3299.x * _e3290) + (_e3308.x * _e3291)) + (_e3320.x * _e3292));
                let _e3328 = (((_e3299.y * _e3290) + (_e3308.y * _e3291)) + (_e3320.y * _e3292));
                let _e3329 = (((_e3299.z * _e3290) + (_e3308.z * _e3291)) + (_e3320.z * _e3292));
                let _e3335 = sqrt((((_e3327 * _e3327) + (_e3328 * _e3328)) + (_e3329 * _e3329)));
                if (_e3335 > 0f) {
                    let _e3337 = (_e3327 / _e3335);
                    let _e3338 = (_e3328 / _e3335);
                    let _e3339 = (_e3329 / _e3335);
                    if ((((_e3337 * _e2885.x) + (_e3338 * _e2885.y)) + (_e3339 * _e2885.z)) < 0f) {
                        phi_4039_ = vec3<f32>(-(_e3337), -(_e3338), -(_e3339));
                    } else {
                        phi_4039_ = vec3<f32>(_e3337, _e3338, _e3339);
                    }
                    let _e3355 = phi_4039_;
                    phi_4040_ = _e3355;
                } else {
                    phi_4040_ = _e2885;
                }
                let _e3357 = phi_4040_;
                phi_4041_ = _e3357;
            }
            let _e3359 = phi_4041_;
            if (_e3131 > 0f) {
                if (_e3131 < 1f) {
                    phi_4050_ = _e3131;
                } else {
                    phi_4050_ = 1f;
                }
                let _e3363 = phi_4050_;
                phi_4051_ = _e3363;
            } else {
                phi_4051_ = 0f;
            }
            let _e3365 = phi_4051_;
            if (_e3133 > 0f) {
                if (_e3133 < 1f) {
                    phi_4061_ = _e3133;
                } else {
                    phi_4061_ = 1f;
                }
                let _e3370 = phi_4061_;
                phi_4062_ = _e3370;
            } else {
                phi_4062_ = 0f;
            }
            let _e3372 = phi_4062_;
            if (_e3135 > 0f) {
                if (_e3135 < 1f) {
                    phi_4072_ = _e3135;
                } else {
                    phi_4072_ = 1f;
                }
                let _e3377 = phi_4072_;
                phi_4073_ = _e3377;
            } else {
                phi_4073_ = 0f;
            }
            let _e3379 = phi_4073_;
            let _e3382 = ((sqrt(_e3365) * 255f) + 0.5f);
            let _e3391 = ((sqrt(_e3372) * 255f) + 0.5f);
            let _e3403 = ((sqrt(_e3379) * 255f) + 0.5f);
            phi_4108_ = abi_Sample(vec3<f32>(_e2793, _e2794, _e2795), _e3137, _e2885, _e3142, _e3359, ((select(select(u32(_e3382), 0u, (_e3382 < bitcast<f32>(0u))), 4294967295u, (_e3382 > bitcast<f32>(1333788671u))) | (select(select(u32(_e3391), 0u, (_e3391 < bitcast<f32>(0u))), 4294967295u, (_e3391 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e3403), 0u, (_e3403 < bitcast<f32>(0u))), 4294967295u, (_e3403 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_4108_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e3417 = phi_4108_;
        if (_e108.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e108.shift)] = _e3417;
        if (_e2633.triangle != 4294967295u) {
            let _e3426 = ((1f - _e2633.u) - _e2633.v);
            if (_e2633.triangle < _e81) {
            } else {
                return;
            }
            let _e3431 = triangles.member[(0u + _e2633.triangle)];
            let _e3433 = (_e3431.i0_ & 2147483647u);
            if (_e3433 < _e99) {
            } else {
                return;
            }
            let _e3439 = before.member[(0u + _e3433)];
            if (_e3431.i1_ < _e99) {
            } else {
                return;
            }
            let _e3443 = before.member[(0u + _e3431.i1_)];
            if (_e3431.i2_ < _e99) {
            } else {
                return;
            }
            let _e3447 = before.member[(0u + _e3431.i2_)];
            if (_e2633.instance < _e93) {
            } else {
                return;
            }
            let _e3457 = instances.member[(0u + _e2633.instance)].object_to_world[0u];
            let _e3470 = instances.member[(0u + _e2633.instance)].object_to_world[1u];
            let _e3483 = instances.member[(0u + _e2633.instance)].object_to_world[2u];
            if (_e2633.instance < _e93) {
            } else {
                return;
            }
            let _e3507 = instances.member[(0u + _e2633.instance)].object_to_world[0u];
            let _e3520 = instances.member[(0u + _e2633.instance)].object_to_world[1u];
            let _e3533 = instances.member[(0u + _e2633.instance)].object_to_world[2u];
            if (_e2633.instance < _e93) {
            } else {
                return;
            }
            let _e3560 = instances.member[(0u + _e2633.instance)].object_to_world[0u];
            let _e3573 = instances.member[(0u + _e2633.instance)].object_to_world[1u];
            let _e3586 = instances.member[(0u + _e2633.instance)].object_to_world[2u];
            phi_4331_ = vec3<f32>((((((((_e3457.x * _e3439.x) + (_e3457.y * _e3439.y)) + (_e3457.z * _e3439.z)) + (_e3457.w * 1f)) * _e3426) + (((((_e3507.x * _e3443.x) + (_e3507.y * _e3443.y)) + (_e3507.z * _e3443.z)) + (_e3507.w * 1f)) * _e2633.u)) + (((((_e3560.x * _e3447.x) + (_e3560.y * _e3447.y)) + (_e3560.z * _e3447.z)) + (_e3560.w * 1f)) * _e2633.v)), (((((((_e3470.x * _e3439.x) + (_e3470.y * _e3439.y)) + (_e3470.z * _e3439.z)) + (_e3470.w * 1f)) * _e3426) + (((((_e3520.x * _e3443.x) + (_e3520.y * _e3443.y)) + (_e3520.z * _e3443.z)) + (_e3520.w * 1f)) * _e2633.u)) + (((((_e3573.x * _e3447.x) + (_e3573.y * _e3447.y)) + (_e3573.z * _e3447.z)) + (_e3573.w * 1f)) * _e2633.v)), (((((((_e3483.x * _e3439.x) + (_e3483.y * _e3439.y)) + (_e3483.z * _e3439.z)) + (_e3483.w * 1f)) * _e3426) + (((((_e3533.x * _e3443.x) + (_e3533.y * _e3443.y)) + (_e3533.z * _e3443.z)) + (_e3533.w * 1f)) * _e2633.u)) + (((((_e3586.x * _e3447.x) + (_e3586.y * _e3447.y)) + (_e3586.z * _e3447.z)) + (_e3586.w * 1f)) * _e2633.v)));
        } else {
            phi_4331_ = vec3<f32>(0f, 0f, 0f);
        }
        let _e3606 = phi_4331_;
        if (_e108.shift < arrayLength((&past.member))) {
        } else {
            return;
        }
        past.member[(0u + _e108.shift)] = vec4<f32>(_e3606.x, _e3606.y, _e3606.z, 1f);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_instanced_color_motion_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
