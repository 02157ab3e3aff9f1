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

struct type_53 {
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
var<storage> vertices: type_38;
@group(0) @binding(4) 
var<storage> materials: type_42;
@group(0) @binding(0) 
var<uniform> p: type_53;
@group(0) @binding(1) 
var<storage> nodes: type_30;
@group(0) @binding(2) 
var<storage> triangles: type_34;
@group(0) @binding(5) 
var<storage, read_write> samples: type_9;
@group(0) @binding(6) 
var<storage> alpha_texels: type_13;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_mask_LightPlace {
    var phi_214_: lt_mask_LightPlace;
    var phi_215_: bool;
    var phi_216_: lt_mask_LightPlace;
    var phi_217_: bool;
    var phi_222_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_214_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_215_ = false;
        } else {
            phi_214_ = lt_mask_LightPlace();
            phi_215_ = true;
        }
        let _e82 = phi_214_;
        let _e84 = phi_215_;
        phi_216_ = _e82;
        phi_217_ = _e84;
    } else {
        phi_216_ = lt_mask_LightPlace();
        phi_217_ = true;
    }
    let _e86 = phi_216_;
    let _e88 = phi_217_;
    if _e88 {
        phi_222_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_222_ = _e86;
    }
    let _e93 = phi_222_;
    return lt_mask_LightPlace(_e93.word, _e93.shift);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_237_: bool;
    var phi_241_: f32;

    if (param_3 != param_3) {
        phi_237_ = true;
    } else {
        let _e72 = (param_4 >= param_3);
        if _e72 {
        }
        phi_237_ = _e72;
    }
    let _e74 = phi_237_;
    if _e74 {
        phi_241_ = param_4;
    } else {
        phi_241_ = param_3;
    }
    let _e76 = phi_241_;
    return _e76;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_253_: bool;
    var phi_257_: f32;

    if (param_5 != param_5) {
        phi_253_ = true;
    } else {
        let _e72 = (param_6 <= param_5);
        if _e72 {
        }
        phi_253_ = _e72;
    }
    let _e74 = phi_253_;
    if _e74 {
        phi_257_ = param_6;
    } else {
        phi_257_ = param_5;
    }
    let _e76 = phi_257_;
    return _e76;
}

fn _lt_shaders_texture_TextureView_quad(param_7: ptr<function, texture_TextureView>, param_8: f32, param_9: f32) -> texture_TexelQuad {
    var phi_299_: f32;
    var phi_304_: f32;
    var phi_305_: bool;
    var phi_306_: f32;
    var phi_307_: bool;
    var phi_311_: f32;
    var phi_337_: f32;
    var phi_342_: f32;
    var phi_343_: bool;
    var phi_344_: f32;
    var phi_345_: bool;
    var phi_349_: f32;
    var phi_357_: f32;
    var phi_358_: f32;
    var phi_359_: f32;
    var phi_368_: f32;
    var phi_369_: f32;
    var phi_387_: u32;
    var phi_401_: u32;
    var phi_408_: u32;
    var phi_413_: u32;
    var phi_419_: u32;
    var phi_424_: u32;
    var phi_426_: texture_Axis;
    var phi_454_: f32;
    var phi_459_: f32;
    var phi_460_: bool;
    var phi_461_: f32;
    var phi_462_: bool;
    var phi_466_: f32;
    var phi_492_: f32;
    var phi_497_: f32;
    var phi_498_: bool;
    var phi_499_: f32;
    var phi_500_: bool;
    var phi_504_: f32;
    var phi_512_: f32;
    var phi_513_: f32;
    var phi_514_: f32;
    var phi_523_: f32;
    var phi_524_: f32;
    var phi_542_: u32;
    var phi_556_: u32;
    var phi_563_: u32;
    var phi_568_: u32;
    var phi_574_: u32;
    var phi_579_: u32;
    var phi_581_: texture_Axis;

    let _e73 = (*param_7).size;
    let _e74 = (_e73 & 65535u);
    let _e76 = (*param_7).size;
    let _e78 = (_e76 >> bitcast<u32>(16i));
    let _e80 = (*param_7).flags;
    let _e82 = ((_e80 & 4u) != 0u);
    let _e84 = (*param_7).flags;
    let _e87 = ((_e84 >> bitcast<u32>(4u)) & 3u);
    if (_e87 == 0u) {
        if (param_8 > -8388608f) {
            let _e100 = f32(select(0i, select(select(i32(param_8), i32(-2147483648), (param_8 < bitcast<f32>(3472883712u))), 2147483647i, (param_8 > bitcast<f32>(1325400063u))), (param_8 == param_8)));
            if (_e100 > param_8) {
                phi_299_ = 1f;
            } else {
                phi_299_ = 0f;
            }
            let _e103 = phi_299_;
            if (param_8 < 8388608f) {
                phi_304_ = (_e100 - _e103);
                phi_305_ = false;
            } else {
                phi_304_ = f32();
                phi_305_ = true;
            }
            let _e106 = phi_304_;
            let _e108 = phi_305_;
            phi_306_ = _e106;
            phi_307_ = _e108;
        } else {
            phi_306_ = f32();
            phi_307_ = true;
        }
        let _e110 = phi_306_;
        let _e112 = phi_307_;
        if _e112 {
            phi_311_ = param_8;
        } else {
            phi_311_ = _e110;
        }
        let _e114 = phi_311_;
        phi_359_ = (param_8 - _e114);
    } else {
        if (_e87 == 1u) {
            let _e117 = (param_8 * 0.5f);
            if (_e117 > -8388608f) {
                let _e129 = f32(select(0i, select(select(i32(_e117), i32(-2147483648), (_e117 < bitcast<f32>(3472883712u))), 2147483647i, (_e117 > bitcast<f32>(1325400063u))), (_e117 == _e117)));
                if (_e129 > _e117) {
                    phi_337_ = 1f;
                } else {
                    phi_337_ = 0f;
                }
                let _e132 = phi_337_;
                if (_e117 < 8388608f) {
                    phi_342_ = (_e129 - _e132);
                    phi_343_ = false;
                } else {
                    phi_342_ = f32();
                    phi_343_ = true;
                }
                let _e135 = phi_342_;
                let _e137 = phi_343_;
                phi_344_ = _e135;
                phi_345_ = _e137;
            } else {
                phi_344_ = f32();
                phi_345_ = true;
            }
            let _e139 = phi_344_;
            let _e141 = phi_345_;
            if _e141 {
                phi_349_ = _e117;
            } else {
                phi_349_ = _e139;
            }
            let _e143 = phi_349_;
            let _e145 = (param_8 - (2f * _e143));
            if (_e145 > 1f) {
                phi_357_ = (2f - _e145);
            } else {
                phi_357_ = _e145;
            }
            let _e149 = phi_357_;
            phi_358_ = _e149;
        } else {
            phi_358_ = param_8;
        }
        let _e151 = phi_358_;
        phi_359_ = _e151;
    }
    let _e153 = phi_359_;
    if (_e153 > 0f) {
        if (_e153 < 1f) {
            phi_368_ = _e153;
        } else {
            phi_368_ = 1f;
        }
        let _e157 = phi_368_;
        phi_369_ = _e157;
    } else {
        phi_369_ = 0f;
    }
    let _e159 = phi_369_;
    let _e160 = (_e74 - 1u);
    let _e162 = (_e159 * f32(_e74));
    if _e82 {
        let _e169 = select(select(u32(_e162), 0u, (_e162 < bitcast<f32>(0u))), 4294967295u, (_e162 > bitcast<f32>(1333788671u)));
        if (_e160 < _e169) {
            phi_387_ = _e160;
        } else {
            phi_387_ = _e169;
        }
        let _e172 = phi_387_;
        phi_426_ = texture_Axis(_e172, _e172, 0f);
    } else {
        let _e174 = (_e162 + 0.5f);
        let _e181 = select(select(u32(_e174), 0u, (_e174 < bitcast<f32>(0u))), 4294967295u, (_e174 > bitcast<f32>(1333788671u)));
        if (_e74 < _e181) {
            phi_401_ = _e74;
        } else {
            phi_401_ = _e181;
        }
        let _e184 = phi_401_;
        if (_e87 == 0u) {
            phi_408_ = _e160;
        } else {
            phi_408_ = 0u;
        }
        let _e189 = phi_408_;
        if (_e87 == 0u) {
            phi_413_ = 0u;
        } else {
            phi_413_ = _e160;
        }
        let _e192 = phi_413_;
        if (_e184 == 0u) {
            phi_419_ = _e189;
        } else {
            phi_419_ = (_e184 - 1u);
        }
        let _e196 = phi_419_;
        if (_e184 > _e160) {
            phi_424_ = _e192;
        } else {
            phi_424_ = _e184;
        }
        let _e199 = phi_424_;
        phi_426_ = texture_Axis(_e196, _e199, (_e174 - f32(_e184)));
    }
    let _e202 = phi_426_;
    let _e204 = (*param_7).flags;
    let _e207 = ((_e204 >> bitcast<u32>(6u)) & 3u);
    if (_e207 == 0u) {
        if (param_9 > -8388608f) {
            let _e220 = f32(select(0i, select(select(i32(param_9), i32(-2147483648), (param_9 < bitcast<f32>(3472883712u))), 2147483647i, (param_9 > bitcast<f32>(1325400063u))), (param_9 == param_9)));
            if (_e220 > param_9) {
                phi_454_ = 1f;
            } else {
                phi_454_ = 0f;
            }
            let _e223 = phi_454_;
            if (param_9 < 8388608f) {
                phi_459_ = (_e220 - _e223);
                phi_460_ = false;
            } else {
                phi_459_ = f32();
                phi_460_ = true;
            }
            let _e226 = phi_459_;
            let _e228 = phi_460_;
            phi_461_ = _e226;
            phi_462_ = _e228;
        } else {
            phi_461_ = f32();
            phi_462_ = true;
        }
        let _e230 = phi_461_;
        let _e232 = phi_462_;
        if _e232 {
            phi_466_ = param_9;
        } else {
            phi_466_ = _e230;
        }
        let _e234 = phi_466_;
        phi_514_ = (param_9 - _e234);
    } else {
        if (_e207 == 1u) {
            let _e237 = (param_9 * 0.5f);
            if (_e237 > -8388608f) {
                let _e249 = f32(select(0i, select(select(i32(_e237), i32(-2147483648), (_e237 < bitcast<f32>(3472883712u))), 2147483647i, (_e237 > bitcast<f32>(1325400063u))), (_e237 == _e237)));
                if (_e249 > _e237) {
                    phi_492_ = 1f;
                } else {
                    phi_492_ = 0f;
                }
                let _e252 = phi_492_;
                if (_e237 < 8388608f) {
                    phi_497_ = (_e249 - _e252);
                    phi_498_ = false;
                } else {
                    phi_497_ = f32();
                    phi_498_ = true;
                }
                let _e255 = phi_497_;
                let _e257 = phi_498_;
                phi_499_ = _e255;
                phi_500_ = _e257;
            } else {
                phi_499_ = f32();
                phi_500_ = true;
            }
            let _e259 = phi_499_;
            let _e261 = phi_500_;
            if _e261 {
                phi_504_ = _e237;
            } else {
                phi_504_ = _e259;
            }
            let _e263 = phi_504_;
            let _e265 = (param_9 - (2f * _e263));
            if (_e265 > 1f) {
                phi_512_ = (2f - _e265);
            } else {
                phi_512_ = _e265;
            }
            let _e269 = phi_512_;
            phi_513_ = _e269;
        } else {
            phi_513_ = param_9;
        }
        let _e271 = phi_513_;
        phi_514_ = _e271;
    }
    let _e273 = phi_514_;
    if (_e273 > 0f) {
        if (_e273 < 1f) {
            phi_523_ = _e273;
        } else {
            phi_523_ = 1f;
        }
        let _e277 = phi_523_;
        phi_524_ = _e277;
    } else {
        phi_524_ = 0f;
    }
    let _e279 = phi_524_;
    let _e280 = (_e78 - 1u);
    let _e282 = (_e279 * f32(_e78));
    if _e82 {
        let _e289 = select(select(u32(_e282), 0u, (_e282 < bitcast<f32>(0u))), 4294967295u, (_e282 > bitcast<f32>(1333788671u)));
        if (_e280 < _e289) {
            phi_542_ = _e280;
        } else {
            phi_542_ = _e289;
        }
        let _e292 = phi_542_;
        phi_581_ = texture_Axis(_e292, _e292, 0f);
    } else {
        let _e294 = (_e282 + 0.5f);
        let _e301 = select(select(u32(_e294), 0u, (_e294 < bitcast<f32>(0u))), 4294967295u, (_e294 > bitcast<f32>(1333788671u)));
        if (_e78 < _e301) {
            phi_556_ = _e78;
        } else {
            phi_556_ = _e301;
        }
        let _e304 = phi_556_;
        if (_e207 == 0u) {
            phi_563_ = _e280;
        } else {
            phi_563_ = 0u;
        }
        let _e309 = phi_563_;
        if (_e207 == 0u) {
            phi_568_ = 0u;
        } else {
            phi_568_ = _e280;
        }
        let _e312 = phi_568_;
        if (_e304 == 0u) {
            phi_574_ = _e309;
        } else {
            phi_574_ = (_e304 - 1u);
        }
        let _e316 = phi_574_;
        if (_e304 > _e280) {
            phi_579_ = _e312;
        } else {
            phi_579_ = _e304;
        }
        let _e319 = phi_579_;
        phi_581_ = texture_Axis(_e316, _e319, (_e294 - f32(_e304)));
    }
    let _e322 = phi_581_;
    let _e326 = (*param_7).offset;
    let _e333 = (*param_7).offset;
    let _e340 = (*param_7).offset;
    let _e347 = (*param_7).offset;
    return texture_TexelQuad(array<u32, 4>(((_e326 + (_e322.low * _e74)) + _e202.low), ((_e333 + (_e322.low * _e74)) + _e202.high), ((_e340 + (_e322.high * _e74)) + _e202.low), ((_e347 + (_e322.high * _e74)) + _e202.high)), vec4<f32>(((1f - _e202.fraction) * (1f - _e322.fraction)), (_e202.fraction * (1f - _e322.fraction)), ((1f - _e202.fraction) * _e322.fraction), (_e202.fraction * _e322.fraction)));
}

fn _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(param_10: vec3<f32>) -> vec3<f32> {
    return param_10;
}

fn _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(param_11: vec3<f32>) -> vec3<f32> {
    return vec3<f32>(1f, 1f, 1f);
}

fn _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(param_12: f32, param_13: f32) -> f32 {
    var phi_3047_: f32;

    if (param_12 > param_13) {
        phi_3047_ = param_12;
    } else {
        phi_3047_ = param_13;
    }
    let _e73 = phi_3047_;
    return _e73;
}

fn _lt_bvh_ray_Ray_new(param_14: vec3<f32>, param_15: vec3<f32>) -> lt_bvh_Ray {
    return lt_bvh_Ray(param_14, 0f, param_15, 300000000000000000000000000000000000000f);
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var phi_752_: bool;
    var phi_753_: bool;
    var phi_754_: bool;
    var phi_755_: bool;
    var phi_759_: bool;
    var phi_772_: bool;
    var phi_773_: bool;
    var phi_774_: bool;
    var phi_775_: bool;
    var phi_779_: bool;
    var phi_792_: bool;
    var phi_793_: bool;
    var phi_794_: bool;
    var phi_798_: bool;
    var phi_799_: bool;
    var phi_800_: bool;
    var phi_801_: bool;
    var phi_802_: bool;
    var phi_806_: bool;
    var phi_882_: f32;
    var phi_889_: f32;
    var phi_897_: f32;
    var phi_904_: f32;
    var phi_912_: f32;
    var phi_919_: f32;
    var phi_942_: f32;
    var phi_947_: f32;
    var phi_952_: f32;
    var phi_957_: f32;
    var phi_962_: f32;
    var phi_993_: bool;
    var phi_994_: bool;
    var phi_1002_: u32;
    var phi_1003_: u32;
    var phi_1020_: vec3<f32>;
    var phi_1021_: vec3<f32>;
    var phi_1034_: u32;
    var phi_1039_: u32;
    var phi_1044_: u32;
    var phi_1158_: bool;
    var phi_1159_: bool;
    var phi_1190_: u32;
    var phi_1192_: lt_bvh_Hit;
    var phi_1195_: u32;
    var phi_1280_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1307_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1334_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1340_: u32;
    var phi_1343_: u32;
    var phi_1357_: u32;
    var phi_1367_: u32;
    var phi_1377_: u32;
    var phi_1395_: u32;
    var phi_1405_: u32;
    var phi_1415_: u32;
    var phi_1451_: u32;
    var phi_1464_: u32;
    var phi_1469_: u32;
    var phi_1470_: u32;
    var phi_1471_: u32;
    var phi_1341_: u32;
    var phi_1344_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_1529_: lt_bvh_Hit;
    var phi_1532_: u32;
    var phi_1578_: vec3<f32>;
    var phi_1579_: vec3<f32>;
    var phi_1610_: vec3<f32>;
    var phi_1611_: vec3<f32>;
    var phi_1642_: vec3<f32>;
    var phi_1643_: vec3<f32>;
    var phi_1661_: bool;
    var phi_1662_: bool;
    var phi_1666_: f32;
    var phi_1667_: f32;
    var phi_1668_: f32;
    var phi_1669_: f32;
    var phi_1677_: f32;
    var phi_1687_: bool;
    var phi_1688_: bool;
    var phi_1692_: f32;
    var phi_1693_: f32;
    var phi_1694_: f32;
    var phi_1695_: f32;
    var phi_1703_: f32;
    var phi_1713_: bool;
    var phi_1714_: bool;
    var phi_1718_: f32;
    var phi_1719_: f32;
    var phi_1720_: f32;
    var phi_1721_: f32;
    var phi_1729_: f32;
    var phi_1744_: f32;
    var phi_1745_: bool;
    var phi_1746_: f32;
    var phi_1747_: bool;
    var phi_1748_: f32;
    var phi_1749_: bool;
    var phi_1767_: f32;
    var phi_1768_: bool;
    var phi_1769_: bool;
    var phi_1770_: f32;
    var phi_1771_: bool;
    var phi_1772_: bool;
    var phi_1776_: bool;
    var phi_1777_: f32;
    var phi_1778_: bool;
    var phi_1808_: vec3<f32>;
    var phi_1809_: vec3<f32>;
    var phi_1834_: vec3<f32>;
    var phi_1835_: vec3<f32>;
    var phi_1860_: vec3<f32>;
    var phi_1861_: vec3<f32>;
    var phi_1919_: f32;
    var phi_1928_: f32;
    var phi_1937_: f32;
    var phi_1946_: f32;
    var phi_1953_: f32;
    var phi_1960_: f32;
    var phi_1973_: f32;
    var phi_1982_: f32;
    var phi_1991_: f32;
    var phi_2000_: f32;
    var phi_2007_: f32;
    var phi_2014_: f32;
    var phi_2037_: f32;
    var phi_2042_: f32;
    var phi_2047_: f32;
    var phi_2055_: f32;
    var phi_2060_: f32;
    var phi_2065_: f32;
    var phi_2077_: f32;
    var phi_2082_: f32;
    var phi_2087_: f32;
    var phi_2092_: f32;
    var phi_2097_: lt_bvh_triangle_Intersection;
    var phi_2098_: bool;
    var phi_2099_: lt_bvh_triangle_Intersection;
    var phi_2100_: bool;
    var phi_2104_: lt_bvh_triangle_Intersection;
    var phi_2105_: bool;
    var phi_2106_: lt_bvh_triangle_Intersection;
    var phi_2107_: bool;
    var phi_2108_: bool;
    var phi_2112_: bool;
    var phi_2116_: lt_bvh_triangle_Intersection;
    var phi_2155_: bool;
    var phi_2156_: bool;
    var phi_2157_: bool;
    var phi_2158_: bool;
    var phi_2159_: bool;
    var phi_2160_: bool;
    var phi_2164_: bool;
    var phi_2165_: bool;
    var phi_2368_: f32;
    var phi_2371_: bool;
    var phi_2372_: bool;
    var phi_2376_: bool;
    var phi_2384_: lt_bvh_Hit;
    var phi_2385_: lt_bvh_Hit;
    var phi_2386_: lt_bvh_Hit;
    var phi_2387_: lt_bvh_Hit;
    var phi_1530_: lt_bvh_Hit;
    var phi_1533_: u32;
    var phi_2388_: bool;
    var phi_2427_: bool;
    var phi_2428_: bool;
    var phi_2459_: u32;
    var phi_1193_: lt_bvh_Hit;
    var phi_1196_: u32;
    var phi_2460_: lt_bvh_Hit;
    var phi_2461_: lt_bvh_Hit;
    var phi_2462_: bool;
    var phi_2466_: lt_bvh_Hit;
    var phi_2531_: f32;
    var phi_2536_: f32;
    var phi_2541_: f32;
    var phi_2552_: f32;
    var phi_2557_: f32;
    var phi_2562_: f32;
    var phi_2638_: vec3<f32>;
    var phi_2759_: u32;
    var phi_2786_: f32;
    var phi_2793_: f32;
    var phi_2800_: f32;
    var phi_2835_: f32;
    var phi_2842_: f32;
    var phi_2849_: f32;
    var phi_2887_: f32;
    var phi_2894_: f32;
    var phi_2901_: f32;
    var phi_2960_: vec3<f32>;
    var phi_2961_: vec3<f32>;
    var phi_2962_: vec3<f32>;
    var phi_2971_: f32;
    var phi_2972_: f32;
    var phi_2982_: f32;
    var phi_2983_: f32;
    var phi_2993_: f32;
    var phi_2994_: f32;
    var phi_3029_: abi_Sample;
    var local_5: lt_bvh_Hit;
    var local_6: lt_bvh_Hit;

    let _e71 = id_1;
    let _e75 = arrayLength((&nodes.member));
    let _e78 = arrayLength((&triangles.member));
    let _e81 = arrayLength((&vertices.member));
    let _e84 = arrayLength((&materials.member));
    let _e90 = arrayLength((&alpha_texels.member));
    let _e93 = p.member.size[0u];
    let _e95 = p.member.size[1u];
    let _e96 = lt_shaders_entry_pixel_index(_e71, _e93, _e95);
    if (bitcast<i32>(_e96.word) != 0i) {
        let _e104 = p.member.eye;
        let _e109 = p.member.size[0u];
        let _e113 = ((((f32(_e71.x) + 0.5f) / f32(_e109)) * 2f) - 1f);
        let _e118 = p.member.size[1u];
        let _e122 = (1f - (((f32(_e71.y) + 0.5f) / f32(_e118)) * 2f));
        let _e124 = p.member.forward;
        let _e126 = p.member.right;
        let _e140 = p.member.up;
        let _e151 = _lt_bvh_ray_Ray_new(_e104, vec3<f32>(((_e124.x + (_e126.x * _e113)) + (_e140.x * _e122)), ((_e124.y + (_e126.y * _e113)) + (_e140.y * _e122)), ((_e124.z + (_e126.z * _e113)) + (_e140.z * _e122))));
        let _e153 = lt_bvh_Hit(_e151.tmax, 0f, 0f, 4294967295u, 4294967295u);
        let _e156 = abs(_e151.direction.x);
        let _e158 = abs(_e151.direction.y);
        let _e160 = abs(_e151.direction.z);
        if (abs(_e151.origin.x) < 1000000000000000f) {
            if (abs(_e151.origin.y) < 1000000000000000f) {
                phi_752_ = (abs(_e151.origin.z) < 1000000000000000f);
                phi_753_ = false;
            } else {
                phi_752_ = bool();
                phi_753_ = true;
            }
            let _e172 = phi_752_;
            let _e174 = phi_753_;
            phi_754_ = _e172;
            phi_755_ = _e174;
        } else {
            phi_754_ = bool();
            phi_755_ = true;
        }
        let _e176 = phi_754_;
        let _e178 = phi_755_;
        if _e178 {
            phi_759_ = false;
        } else {
            phi_759_ = _e176;
        }
        let _e180 = phi_759_;
        if _e180 {
            if (_e156 < 1000000000000000f) {
                if (_e158 < 1000000000000000f) {
                    phi_772_ = (_e160 < 1000000000000000f);
                    phi_773_ = false;
                } else {
                    phi_772_ = bool();
                    phi_773_ = true;
                }
                let _e185 = phi_772_;
                let _e187 = phi_773_;
                phi_774_ = _e185;
                phi_775_ = _e187;
            } else {
                phi_774_ = bool();
                phi_775_ = true;
            }
            let _e189 = phi_774_;
            let _e191 = phi_775_;
            if _e191 {
                phi_779_ = false;
            } else {
                phi_779_ = _e189;
            }
            let _e193 = phi_779_;
            if _e193 {
                if (_e156 > 0f) {
                    phi_793_ = bool();
                    phi_794_ = true;
                } else {
                    let _e195 = (_e158 > 0f);
                    if _e195 {
                        phi_792_ = bool();
                    } else {
                        phi_792_ = (_e160 > 0f);
                    }
                    let _e198 = phi_792_;
                    phi_793_ = _e198;
                    phi_794_ = _e195;
                }
                let _e200 = phi_793_;
                let _e202 = phi_794_;
                if _e202 {
                    phi_798_ = true;
                } else {
                    phi_798_ = _e200;
                }
                let _e204 = phi_798_;
                phi_799_ = _e204;
                phi_800_ = false;
            } else {
                phi_799_ = bool();
                phi_800_ = true;
            }
            let _e206 = phi_799_;
            let _e208 = phi_800_;
            phi_801_ = _e206;
            phi_802_ = _e208;
        } else {
            phi_801_ = bool();
            phi_802_ = true;
        }
        let _e210 = phi_801_;
        let _e212 = phi_802_;
        if _e212 {
            phi_806_ = false;
        } else {
            phi_806_ = _e210;
        }
        let _e214 = phi_806_;
        if _e214 {
            let _e215 = (0u >= _e75);
            if _e215 {
                phi_2460_ = lt_bvh_Hit();
            } else {
                if (0u < _e75) {
                } else {
                    return;
                }
                let _e221 = nodes.member[(0u + 0u)].frame[0u];
                let _e225 = nodes.member[(0u + 0u)].frame[1u];
                let _e229 = nodes.member[(0u + 0u)].frame[2u];
                let _e233 = nodes.member[(0u + 0u)].frame[0u];
                let _e237 = nodes.member[(0u + 0u)].frame[1u];
                let _e241 = nodes.member[(0u + 0u)].frame[2u];
                let _e245 = nodes.member[(0u + 0u)].frame[3u];
                let _e284 = core_intrinsics_maximum_number_nsz_f32_(abs(_e151.direction.x), abs(_e151.direction.y));
                let _e285 = core_intrinsics_maximum_number_nsz_f32_(_e284, abs(_e151.direction.z));
                let _e286 = (_e285 * 0.0000000000009094947f);
                if (abs(_e151.direction.x) < _e286) {
                    phi_882_ = _e286;
                } else {
                    phi_882_ = abs(_e151.direction.x);
                }
                let _e292 = phi_882_;
                if (_e151.direction.x < 0f) {
                    phi_889_ = (-1f / _e292);
                } else {
                    phi_889_ = (1f / _e292);
                }
                let _e297 = phi_889_;
                if (abs(_e151.direction.y) < _e286) {
                    phi_897_ = _e286;
                } else {
                    phi_897_ = abs(_e151.direction.y);
                }
                let _e303 = phi_897_;
                if (_e151.direction.y < 0f) {
                    phi_904_ = (-1f / _e303);
                } else {
                    phi_904_ = (1f / _e303);
                }
                let _e308 = phi_904_;
                if (abs(_e151.direction.z) < _e286) {
                    phi_912_ = _e286;
                } else {
                    phi_912_ = abs(_e151.direction.z);
                }
                let _e314 = phi_912_;
                if (_e151.direction.z < 0f) {
                    phi_919_ = (-1f / _e314);
                } else {
                    phi_919_ = (1f / _e314);
                }
                let _e319 = phi_919_;
                let _e326 = abs((bitcast<f32>(_e221) - _e151.origin.x));
                let _e327 = abs((bitcast<f32>(_e225) - _e151.origin.y));
                let _e328 = abs((bitcast<f32>(_e229) - _e151.origin.z));
                let _e335 = abs(((bitcast<f32>(_e233) + (bitcast<f32>((((_e245 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e151.origin.x));
                let _e336 = abs(((bitcast<f32>(_e237) + (bitcast<f32>((((_e245 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e151.origin.y));
                let _e337 = abs(((bitcast<f32>(_e241) + (bitcast<f32>((((_e245 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e151.origin.z));
                if (_e326 > _e335) {
                    phi_942_ = _e326;
                } else {
                    phi_942_ = _e335;
                }
                let _e340 = phi_942_;
                if (_e327 > _e336) {
                    phi_947_ = _e327;
                } else {
                    phi_947_ = _e336;
                }
                let _e343 = phi_947_;
                if (_e328 > _e337) {
                    phi_952_ = _e328;
                } else {
                    phi_952_ = _e337;
                }
                let _e346 = phi_952_;
                if (_e340 > _e343) {
                    phi_957_ = _e340;
                } else {
                    phi_957_ = _e343;
                }
                let _e349 = phi_957_;
                if (_e349 > _e346) {
                    phi_962_ = _e349;
                } else {
                    phi_962_ = _e346;
                }
                let _e352 = phi_962_;
                let _e356 = (_e352 * 0.0000019073486f);
                let _e357 = (abs(_e297) * _e356);
                let _e358 = (abs(_e308) * _e356);
                let _e359 = (abs(_e319) * _e356);
                let _e363 = (_e352 * 0.0000009536743f);
                let _e364 = (abs(_e297) * _e363);
                let _e365 = (abs(_e308) * _e363);
                let _e366 = (abs(_e319) * _e363);
                let _e370 = abs(_e151.direction.x);
                let _e372 = abs(_e151.direction.y);
                let _e374 = abs(_e151.direction.z);
                if (_e370 >= _e372) {
                    if (_e370 >= _e374) {
                        phi_993_ = false;
                    } else {
                        phi_993_ = true;
                    }
                    let _e378 = phi_993_;
                    phi_994_ = _e378;
                } else {
                    phi_994_ = true;
                }
                let _e380 = phi_994_;
                if _e380 {
                    if (_e372 >= _e374) {
                        phi_1002_ = 1u;
                    } else {
                        phi_1002_ = 2u;
                    }
                    let _e383 = phi_1002_;
                    phi_1003_ = _e383;
                } else {
                    phi_1003_ = 0u;
                }
                let _e385 = phi_1003_;
                if (_e385 == 0u) {
                    phi_1021_ = vec3<f32>(_e151.direction.y, _e151.direction.z, _e151.direction.x);
                } else {
                    if (_e385 == 1u) {
                        phi_1020_ = vec3<f32>(_e151.direction.z, _e151.direction.x, _e151.direction.y);
                    } else {
                        phi_1020_ = _e151.direction;
                    }
                    let _e397 = phi_1020_;
                    phi_1021_ = _e397;
                }
                let _e399 = phi_1021_;
                let _e402 = (_e399.x / _e399.z);
                let _e405 = (_e399.y / _e399.z);
                if (_e297 < 0f) {
                    phi_1034_ = 0u;
                } else {
                    phi_1034_ = 1u;
                }
                let _e410 = phi_1034_;
                if (_e308 < 0f) {
                    phi_1039_ = 0u;
                } else {
                    phi_1039_ = 2u;
                }
                let _e413 = phi_1039_;
                if (_e319 < 0f) {
                    phi_1044_ = 0u;
                } else {
                    phi_1044_ = 4u;
                }
                let _e416 = phi_1044_;
                let _e418 = ((_e410 | _e413) | _e416);
                let _e419 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e419.first[0], _e419.first[1], _e419.first[2], _e419.first[3], _e419.first[4], _e419.first[5], _e419.first[6], _e419.first[7], _e419.first[8], _e419.first[9], _e419.first[10], _e419.first[11], _e419.first[12], _e419.first[13], _e419.first[14], _e419.first[15], _e419.first[16], _e419.first[17], _e419.first[18], _e419.first[19], _e419.first[20], _e419.first[21], _e419.first[22], _e419.first[23], _e419.first[24], _e419.first[25], _e419.first[26], _e419.first[27], _e419.first[28], _e419.first[29], _e419.first[30], _e419.first[31]), array<u32, 32>(_e419.mask[0], _e419.mask[1], _e419.mask[2], _e419.mask[3], _e419.mask[4], _e419.mask[5], _e419.mask[6], _e419.mask[7], _e419.mask[8], _e419.mask[9], _e419.mask[10], _e419.mask[11], _e419.mask[12], _e419.mask[13], _e419.mask[14], _e419.mask[15], _e419.mask[16], _e419.mask[17], _e419.mask[18], _e419.mask[19], _e419.mask[20], _e419.mask[21], _e419.mask[22], _e419.mask[23], _e419.mask[24], _e419.mask[25], _e419.mask[26], _e419.mask[27], _e419.mask[28], _e419.mask[29], _e419.mask[30], _e419.mask[31]), _e419.len, _e419.group, _e419.group_mask);
                let _e493 = local_1.group_mask;
                if ((_e493 & 4278190080u) == 0u) {
                    let _e497 = local_1.len;
                    if (_e497 == 0u) {
                        phi_1158_ = false;
                    } else {
                        let _e501 = local_1.len;
                        local_1.len = (_e501 - 1u);
                        let _e504 = local_1.len;
                        if (_e504 < 32u) {
                        } else {
                            return;
                        }
                        let _e509 = local_1.first[(0u + _e504)];
                        local_1.group = _e509;
                        let _e512 = local_1.len;
                        if (_e512 < 32u) {
                        } else {
                            return;
                        }
                        let _e517 = local_1.mask[(0u + _e512)];
                        local_1.group_mask = _e517;
                        phi_1158_ = true;
                    }
                    let _e520 = phi_1158_;
                    phi_1159_ = _e520;
                } else {
                    phi_1159_ = true;
                }
                let _e522 = phi_1159_;
                if _e522 {
                    let _e524 = local_1.group_mask;
                    let _e530 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e524)), 32u, (_e524 == 0u)));
                    let _e534 = local_1.group_mask;
                    let _e548 = local_1.group_mask;
                    local_1.group_mask = (_e548 & ~((1u << bitcast<u32>((_e530 & 31u)))));
                    let _e551 = local_1.group;
                    phi_1190_ = (_e551 + countOneBits(((_e534 & ~((4294967295u << bitcast<u32>((((_e530 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1190_ = 4294967295u;
                }
                let _e554 = phi_1190_;
                phi_1192_ = _e153;
                phi_1195_ = _e554;
                loop {
                    let _e556 = phi_1192_;
                    let _e558 = phi_1195_;
                    local_6 = _e556;
                    let _e559 = (_e558 != 4294967295u);
                    if _e559 {
                        if (_e558 < _e75) {
                        } else {
                            return;
                        }
                        let _e567 = nodes.member[(0u + _e558)].frame[3u];
                        let _e592 = (bitcast<f32>((((_e567 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e297);
                        let _e593 = (bitcast<f32>((((_e567 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e308);
                        let _e594 = (bitcast<f32>((((_e567 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e319);
                        let _e597 = nodes.member[(0u + _e558)].frame[0u];
                        let _e601 = nodes.member[(0u + _e558)].frame[1u];
                        let _e605 = nodes.member[(0u + _e558)].frame[2u];
                        let _e613 = ((bitcast<f32>(_e597) - _e151.origin.x) * _e297);
                        let _e614 = ((bitcast<f32>(_e601) - _e151.origin.y) * _e308);
                        let _e615 = ((bitcast<f32>(_e605) - _e151.origin.z) * _e319);
                        let _e623 = nodes.member[(0u + _e558)].x;
                        if (_e297 < 0f) {
                            let _e634 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e623.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e640 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e634.unnamed.word, _e623.w), _e634.unnamed_1);
                            let _e646 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e640.unnamed, lt_mask_LightPlace(_e623.x, _e640.unnamed_1.shift));
                            phi_1280_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e646.unnamed, lt_mask_LightPlace(_e646.unnamed_1.word, _e623.y));
                        } else {
                            let _e662 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e623.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e668 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e662.unnamed.word, _e623.y), _e662.unnamed_1);
                            let _e674 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e668.unnamed, lt_mask_LightPlace(_e623.z, _e668.unnamed_1.shift));
                            phi_1280_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e674.unnamed, lt_mask_LightPlace(_e674.unnamed_1.word, _e623.w));
                        }
                        let _e682 = phi_1280_;
                        let _e692 = nodes.member[(0u + _e558)].y;
                        if (_e308 < 0f) {
                            let _e703 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e692.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e709 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e703.unnamed.word, _e692.w), _e703.unnamed_1);
                            let _e715 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e709.unnamed, lt_mask_LightPlace(_e692.x, _e709.unnamed_1.shift));
                            phi_1307_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e715.unnamed, lt_mask_LightPlace(_e715.unnamed_1.word, _e692.y));
                        } else {
                            let _e731 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e692.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e737 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e731.unnamed.word, _e692.y), _e731.unnamed_1);
                            let _e743 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e737.unnamed, lt_mask_LightPlace(_e692.z, _e737.unnamed_1.shift));
                            phi_1307_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e743.unnamed, lt_mask_LightPlace(_e743.unnamed_1.word, _e692.w));
                        }
                        let _e751 = phi_1307_;
                        let _e761 = nodes.member[(0u + _e558)].z;
                        if (_e319 < 0f) {
                            let _e772 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e761.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e778 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e772.unnamed.word, _e761.w), _e772.unnamed_1);
                            let _e784 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e778.unnamed, lt_mask_LightPlace(_e761.x, _e778.unnamed_1.shift));
                            phi_1334_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e784.unnamed, lt_mask_LightPlace(_e784.unnamed_1.word, _e761.y));
                        } else {
                            let _e800 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e761.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e806 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e800.unnamed.word, _e761.y), _e800.unnamed_1);
                            let _e812 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e806.unnamed, lt_mask_LightPlace(_e761.z, _e806.unnamed_1.shift));
                            phi_1334_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e812.unnamed, lt_mask_LightPlace(_e812.unnamed_1.word, _e761.w));
                        }
                        let _e820 = phi_1334_;
                        phi_1340_ = 0u;
                        phi_1343_ = 0u;
                        loop {
                            let _e830 = phi_1340_;
                            let _e832 = phi_1343_;
                            local_2 = _e832;
                            local_3 = _e832;
                            local_4 = _e832;
                            let _e833 = (_e830 < 8u);
                            if _e833 {
                                let _e835 = (_e830 >> bitcast<u32>(2i));
                                let _e836 = (_e830 & 3u);
                                if (_e835 == 0u) {
                                    phi_1357_ = _e682.unnamed.word;
                                } else {
                                    phi_1357_ = _e682.unnamed.shift;
                                }
                                let _e839 = phi_1357_;
                                if (_e835 == 0u) {
                                    phi_1367_ = _e751.unnamed.word;
                                } else {
                                    phi_1367_ = _e751.unnamed.shift;
                                }
                                let _e848 = phi_1367_;
                                if (_e835 == 0u) {
                                    phi_1377_ = _e820.unnamed.word;
                                } else {
                                    phi_1377_ = _e820.unnamed.shift;
                                }
                                let _e857 = phi_1377_;
                                let _e870 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e839 >> bitcast<u32>(((_e836 * 8u) & 31u))) & 255u)) * _e592) + (_e613 - _e357)), ((f32(((_e848 >> bitcast<u32>(((_e836 * 8u) & 31u))) & 255u)) * _e593) + (_e614 - _e358)));
                                let _e871 = core_intrinsics_maximum_number_nsz_f32_(_e870, ((f32(((_e857 >> bitcast<u32>(((_e836 * 8u) & 31u))) & 255u)) * _e594) + (_e615 - _e359)));
                                if (_e835 == 0u) {
                                    phi_1395_ = _e682.unnamed_1.word;
                                } else {
                                    phi_1395_ = _e682.unnamed_1.shift;
                                }
                                let _e874 = phi_1395_;
                                if (_e835 == 0u) {
                                    phi_1405_ = _e751.unnamed_1.word;
                                } else {
                                    phi_1405_ = _e751.unnamed_1.shift;
                                }
                                let _e883 = phi_1405_;
                                if (_e835 == 0u) {
                                    phi_1415_ = _e820.unnamed_1.word;
                                } else {
                                    phi_1415_ = _e820.unnamed_1.shift;
                                }
                                let _e892 = phi_1415_;
                                let _e905 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e874 >> bitcast<u32>(((_e836 * 8u) & 31u))) & 255u)) * _e592) + (_e613 + _e357)), ((f32(((_e883 >> bitcast<u32>(((_e836 * 8u) & 31u))) & 255u)) * _e593) + (_e614 + _e358)));
                                let _e906 = core_intrinsics_minimum_number_nsz_f32_(_e905, ((f32(((_e892 >> bitcast<u32>(((_e836 * 8u) & 31u))) & 255u)) * _e594) + (_e615 + _e359)));
                                if (_e871 <= _e906) {
                                    if (_e871 <= _e556.t) {
                                        if (_e906 >= _e151.tmin) {
                                            if (_e835 == 0u) {
                                                let _e913 = nodes.member[(0u + _e558)].links[2u];
                                                phi_1451_ = _e913;
                                            } else {
                                                let _e916 = nodes.member[(0u + _e558)].links[3u];
                                                phi_1451_ = _e916;
                                            }
                                            let _e918 = phi_1451_;
                                            let _e923 = ((_e918 >> bitcast<u32>(((_e836 * 8u) & 31u))) & 255u);
                                            let _e924 = (_e923 & 31u);
                                            if (_e924 >= 24u) {
                                                phi_1464_ = (24u + ((_e924 - 24u) ^ _e418));
                                            } else {
                                                phi_1464_ = _e924;
                                            }
                                            let _e930 = phi_1464_;
                                            phi_1469_ = (_e832 | ((_e923 >> bitcast<u32>(5i)) << bitcast<u32>((_e930 & 31u))));
                                        } else {
                                            phi_1469_ = _e832;
                                        }
                                        let _e938 = phi_1469_;
                                        phi_1470_ = _e938;
                                    } else {
                                        phi_1470_ = _e832;
                                    }
                                    let _e940 = phi_1470_;
                                    phi_1471_ = _e940;
                                } else {
                                    phi_1471_ = _e832;
                                }
                                let _e942 = phi_1471_;
                                phi_1341_ = (_e830 + 1u);
                                phi_1344_ = _e942;
                            } else {
                                phi_1341_ = u32();
                                phi_1344_ = u32();
                            }
                            let _e945 = phi_1341_;
                            let _e947 = phi_1344_;
                            continue;
                            continuing {
                                phi_1340_ = _e945;
                                phi_1343_ = _e947;
                                break if !(_e833);
                            }
                        }
                        let _e951 = nodes.member[(0u + _e558)].links[0u];
                        let _e955 = nodes.member[(0u + _e558)].frame[3u];
                        let _e959 = local_2;
                        if ((_e959 & 4278190080u) == 0u) {
                        } else {
                            let _e963 = local_1.group_mask;
                            if ((_e963 & 4278190080u) == 0u) {
                            } else {
                                let _e967 = local_1.len;
                                if (_e967 < 32u) {
                                    let _e970 = local_1.group;
                                    let _e972 = local_1.len;
                                    if (_e972 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.first[(0u + _e972)] = _e970;
                                    let _e978 = local_1.group_mask;
                                    let _e980 = local_1.len;
                                    if (_e980 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.mask[(0u + _e980)] = _e978;
                                    let _e987 = local_1.len;
                                    local_1.len = (_e987 + 1u);
                                }
                            }
                            local_1.group = (0u + _e951);
                            let _e991 = local_3;
                            local_1.group_mask = ((_e991 & 4278190080u) | (_e955 >> bitcast<u32>(24i)));
                        }
                        let _e996 = local_4;
                        phi_1529_ = _e556;
                        phi_1532_ = (_e996 & 16777215u);
                        loop {
                            let _e999 = phi_1529_;
                            let _e1001 = phi_1532_;
                            local_5 = _e999;
                            if (_e1001 == 0u) {
                                phi_1530_ = lt_bvh_Hit();
                                phi_1533_ = u32();
                                phi_2388_ = false;
                            } else {
                                let _e1005 = nodes.member[(0u + _e558)].links[1u];
                                let _e1010 = ((0u + _e1005) + select(firstTrailingBit(_e1001), 32u, (_e1001 == 0u)));
                                if (_e1010 < _e78) {
                                } else {
                                    return;
                                }
                                let _e1017 = triangles.member[(0u + _e1010)].v0_;
                                let _e1020 = (_e1017.x - _e151.origin.x);
                                let _e1023 = (_e1017.y - _e151.origin.y);
                                let _e1026 = (_e1017.z - _e151.origin.z);
                                if (_e385 == 0u) {
                                    phi_1579_ = vec3<f32>(_e1023, _e1026, _e1020);
                                } else {
                                    if (_e385 == 1u) {
                                        phi_1578_ = vec3<f32>(_e1026, _e1020, _e1023);
                                    } else {
                                        phi_1578_ = (_e1017 - _e151.origin);
                                    }
                                    let _e1033 = phi_1578_;
                                    phi_1579_ = _e1033;
                                }
                                let _e1035 = phi_1579_;
                                let _e1039 = (_e1035.x - (_e402 * _e1035.z));
                                let _e1043 = (_e1035.y - (_e405 * _e1035.z));
                                let _e1045 = triangles.member[(0u + _e1010)].v1_;
                                let _e1048 = (_e1045.x - _e151.origin.x);
                                let _e1051 = (_e1045.y - _e151.origin.y);
                                let _e1054 = (_e1045.z - _e151.origin.z);
                                if (_e385 == 0u) {
                                    phi_1611_ = vec3<f32>(_e1051, _e1054, _e1048);
                                } else {
                                    if (_e385 == 1u) {
                                        phi_1610_ = vec3<f32>(_e1054, _e1048, _e1051);
                                    } else {
                                        phi_1610_ = (_e1045 - _e151.origin);
                                    }
                                    let _e1061 = phi_1610_;
                                    phi_1611_ = _e1061;
                                }
                                let _e1063 = phi_1611_;
                                let _e1067 = (_e1063.x - (_e402 * _e1063.z));
                                let _e1071 = (_e1063.y - (_e405 * _e1063.z));
                                let _e1073 = triangles.member[(0u + _e1010)].v2_;
                                let _e1076 = (_e1073.x - _e151.origin.x);
                                let _e1079 = (_e1073.y - _e151.origin.y);
                                let _e1082 = (_e1073.z - _e151.origin.z);
                                if (_e385 == 0u) {
                                    phi_1643_ = vec3<f32>(_e1079, _e1082, _e1076);
                                } else {
                                    if (_e385 == 1u) {
                                        phi_1642_ = vec3<f32>(_e1082, _e1076, _e1079);
                                    } else {
                                        phi_1642_ = (_e1073 - _e151.origin);
                                    }
                                    let _e1089 = phi_1642_;
                                    phi_1643_ = _e1089;
                                }
                                let _e1091 = phi_1643_;
                                let _e1095 = (_e1091.x - (_e402 * _e1091.z));
                                let _e1099 = (_e1091.y - (_e405 * _e1091.z));
                                if (_e1067 < _e1095) {
                                    phi_1662_ = true;
                                } else {
                                    if (_e1067 == _e1095) {
                                        phi_1661_ = (_e1071 < _e1099);
                                    } else {
                                        phi_1661_ = false;
                                    }
                                    let _e1104 = phi_1661_;
                                    phi_1662_ = _e1104;
                                }
                                let _e1106 = phi_1662_;
                                if _e1106 {
                                    phi_1666_ = _e1099;
                                    phi_1667_ = _e1095;
                                    phi_1668_ = _e1071;
                                    phi_1669_ = _e1067;
                                } else {
                                    phi_1666_ = _e1071;
                                    phi_1667_ = _e1067;
                                    phi_1668_ = _e1099;
                                    phi_1669_ = _e1095;
                                }
                                let _e1108 = phi_1666_;
                                let _e1110 = phi_1667_;
                                let _e1112 = phi_1668_;
                                let _e1114 = phi_1669_;
                                let _e1117 = ((_e1114 * _e1108) - (_e1112 * _e1110));
                                if _e1106 {
                                    phi_1677_ = -(_e1117);
                                } else {
                                    phi_1677_ = _e1117;
                                }
                                let _e1120 = phi_1677_;
                                if (_e1095 < _e1039) {
                                    phi_1688_ = true;
                                } else {
                                    if (_e1095 == _e1039) {
                                        phi_1687_ = (_e1099 < _e1043);
                                    } else {
                                        phi_1687_ = false;
                                    }
                                    let _e1125 = phi_1687_;
                                    phi_1688_ = _e1125;
                                }
                                let _e1127 = phi_1688_;
                                if _e1127 {
                                    phi_1692_ = _e1043;
                                    phi_1693_ = _e1039;
                                    phi_1694_ = _e1099;
                                    phi_1695_ = _e1095;
                                } else {
                                    phi_1692_ = _e1099;
                                    phi_1693_ = _e1095;
                                    phi_1694_ = _e1043;
                                    phi_1695_ = _e1039;
                                }
                                let _e1129 = phi_1692_;
                                let _e1131 = phi_1693_;
                                let _e1133 = phi_1694_;
                                let _e1135 = phi_1695_;
                                let _e1138 = ((_e1135 * _e1129) - (_e1133 * _e1131));
                                if _e1127 {
                                    phi_1703_ = -(_e1138);
                                } else {
                                    phi_1703_ = _e1138;
                                }
                                let _e1141 = phi_1703_;
                                if (_e1039 < _e1067) {
                                    phi_1714_ = true;
                                } else {
                                    if (_e1039 == _e1067) {
                                        phi_1713_ = (_e1043 < _e1071);
                                    } else {
                                        phi_1713_ = false;
                                    }
                                    let _e1146 = phi_1713_;
                                    phi_1714_ = _e1146;
                                }
                                let _e1148 = phi_1714_;
                                if _e1148 {
                                    phi_1718_ = _e1071;
                                    phi_1719_ = _e1067;
                                    phi_1720_ = _e1043;
                                    phi_1721_ = _e1039;
                                } else {
                                    phi_1718_ = _e1043;
                                    phi_1719_ = _e1039;
                                    phi_1720_ = _e1071;
                                    phi_1721_ = _e1067;
                                }
                                let _e1150 = phi_1718_;
                                let _e1152 = phi_1719_;
                                let _e1154 = phi_1720_;
                                let _e1156 = phi_1721_;
                                let _e1159 = ((_e1156 * _e1150) - (_e1154 * _e1152));
                                if _e1148 {
                                    phi_1729_ = -(_e1159);
                                } else {
                                    phi_1729_ = _e1159;
                                }
                                let _e1162 = phi_1729_;
                                if (_e1120 >= 0f) {
                                    if (_e1141 >= 0f) {
                                        if (_e1162 >= 0f) {
                                            phi_1744_ = ((_e1120 + _e1141) + _e1162);
                                            phi_1745_ = false;
                                        } else {
                                            phi_1744_ = f32();
                                            phi_1745_ = true;
                                        }
                                        let _e1169 = phi_1744_;
                                        let _e1171 = phi_1745_;
                                        phi_1746_ = _e1169;
                                        phi_1747_ = _e1171;
                                    } else {
                                        phi_1746_ = f32();
                                        phi_1747_ = true;
                                    }
                                    let _e1173 = phi_1746_;
                                    let _e1175 = phi_1747_;
                                    phi_1748_ = _e1173;
                                    phi_1749_ = _e1175;
                                } else {
                                    phi_1748_ = f32();
                                    phi_1749_ = true;
                                }
                                let _e1177 = phi_1748_;
                                let _e1179 = phi_1749_;
                                if _e1179 {
                                    if (_e1120 <= 0f) {
                                        if (_e1141 <= 0f) {
                                            let _e1182 = (_e1162 <= 0f);
                                            if _e1182 {
                                            }
                                            phi_1767_ = ((_e1120 + _e1141) + _e1162);
                                            phi_1768_ = false;
                                            phi_1769_ = _e1182;
                                        } else {
                                            phi_1767_ = f32();
                                            phi_1768_ = true;
                                            phi_1769_ = false;
                                        }
                                        let _e1186 = phi_1767_;
                                        let _e1188 = phi_1768_;
                                        let _e1190 = phi_1769_;
                                        phi_1770_ = _e1186;
                                        phi_1771_ = _e1188;
                                        phi_1772_ = _e1190;
                                    } else {
                                        phi_1770_ = f32();
                                        phi_1771_ = true;
                                        phi_1772_ = false;
                                    }
                                    let _e1192 = phi_1770_;
                                    let _e1194 = phi_1771_;
                                    let _e1196 = phi_1772_;
                                    if _e1194 {
                                        phi_1776_ = false;
                                    } else {
                                        phi_1776_ = _e1196;
                                    }
                                    let _e1198 = phi_1776_;
                                    phi_1777_ = _e1192;
                                    phi_1778_ = _e1198;
                                } else {
                                    phi_1777_ = _e1177;
                                    phi_1778_ = true;
                                }
                                let _e1200 = phi_1777_;
                                let _e1202 = phi_1778_;
                                if _e1202 {
                                    let _e1203 = (_e1200 == 0f);
                                    if _e1203 {
                                        phi_2104_ = lt_bvh_triangle_Intersection();
                                        phi_2105_ = false;
                                    } else {
                                        let _e1205 = triangles.member[(0u + _e1010)].v0_;
                                        let _e1208 = (_e1205.x - _e151.origin.x);
                                        let _e1211 = (_e1205.y - _e151.origin.y);
                                        let _e1214 = (_e1205.z - _e151.origin.z);
                                        if (_e385 == 0u) {
                                            phi_1809_ = vec3<f32>(_e1211, _e1214, _e1208);
                                        } else {
                                            if (_e385 == 1u) {
                                                phi_1808_ = vec3<f32>(_e1214, _e1208, _e1211);
                                            } else {
                                                phi_1808_ = (_e1205 - _e151.origin);
                                            }
                                            let _e1221 = phi_1808_;
                                            phi_1809_ = _e1221;
                                        }
                                        let _e1223 = phi_1809_;
                                        let _e1225 = triangles.member[(0u + _e1010)].v1_;
                                        let _e1227 = triangles.member[(0u + _e1010)].v0_;
                                        let _e1230 = (_e1225.x - _e1227.x);
                                        let _e1233 = (_e1225.y - _e1227.y);
                                        let _e1236 = (_e1225.z - _e1227.z);
                                        if (_e385 == 0u) {
                                            phi_1835_ = vec3<f32>(_e1233, _e1236, _e1230);
                                        } else {
                                            if (_e385 == 1u) {
                                                phi_1834_ = vec3<f32>(_e1236, _e1230, _e1233);
                                            } else {
                                                phi_1834_ = (_e1225 - _e1227);
                                            }
                                            let _e1243 = phi_1834_;
                                            phi_1835_ = _e1243;
                                        }
                                        let _e1245 = phi_1835_;
                                        let _e1247 = triangles.member[(0u + _e1010)].v2_;
                                        let _e1249 = triangles.member[(0u + _e1010)].v0_;
                                        let _e1252 = (_e1247.x - _e1249.x);
                                        let _e1255 = (_e1247.y - _e1249.y);
                                        let _e1258 = (_e1247.z - _e1249.z);
                                        if (_e385 == 0u) {
                                            phi_1861_ = vec3<f32>(_e1255, _e1258, _e1252);
                                        } else {
                                            if (_e385 == 1u) {
                                                phi_1860_ = vec3<f32>(_e1258, _e1252, _e1255);
                                            } else {
                                                phi_1860_ = (_e1247 - _e1249);
                                            }
                                            let _e1265 = phi_1860_;
                                            phi_1861_ = _e1265;
                                        }
                                        let _e1267 = phi_1861_;
                                        let _e1274 = ((_e1245.y * _e1267.z) - (_e1245.z * _e1267.y));
                                        let _e1281 = ((_e1245.z * _e1267.x) - (_e1245.x * _e1267.z));
                                        let _e1288 = ((_e1245.x * _e1267.y) - (_e1245.y * _e1267.x));
                                        let _e1302 = (((1f / _e399.z) * (((_e1274 * _e1223.x) + (_e1281 * _e1223.y)) + (_e1288 * _e1223.z))) / (((_e1274 * _e402) + (_e1281 * _e405)) + _e1288));
                                        if (_e1302 > _e151.tmin) {
                                            if (_e1302 < _e151.tmax) {
                                                let _e1308 = triangles.member[(0u + _e1010)].v0_;
                                                let _e1310 = triangles.member[(0u + _e1010)].v1_;
                                                if (_e1308.x < _e1310.x) {
                                                    phi_1919_ = _e1308.x;
                                                } else {
                                                    phi_1919_ = _e1310.x;
                                                }
                                                let _e1317 = phi_1919_;
                                                if (_e1308.y < _e1310.y) {
                                                    phi_1928_ = _e1308.y;
                                                } else {
                                                    phi_1928_ = _e1310.y;
                                                }
                                                let _e1324 = phi_1928_;
                                                if (_e1308.z < _e1310.z) {
                                                    phi_1937_ = _e1308.z;
                                                } else {
                                                    phi_1937_ = _e1310.z;
                                                }
                                                let _e1331 = phi_1937_;
                                                let _e1333 = triangles.member[(0u + _e1010)].v2_;
                                                if (_e1317 < _e1333.x) {
                                                    phi_1946_ = _e1317;
                                                } else {
                                                    phi_1946_ = _e1333.x;
                                                }
                                                let _e1338 = phi_1946_;
                                                if (_e1324 < _e1333.y) {
                                                    phi_1953_ = _e1324;
                                                } else {
                                                    phi_1953_ = _e1333.y;
                                                }
                                                let _e1343 = phi_1953_;
                                                if (_e1331 < _e1333.z) {
                                                    phi_1960_ = _e1331;
                                                } else {
                                                    phi_1960_ = _e1333.z;
                                                }
                                                let _e1348 = phi_1960_;
                                                let _e1350 = triangles.member[(0u + _e1010)].v0_;
                                                let _e1352 = triangles.member[(0u + _e1010)].v1_;
                                                if (_e1350.x > _e1352.x) {
                                                    phi_1973_ = _e1350.x;
                                                } else {
                                                    phi_1973_ = _e1352.x;
                                                }
                                                let _e1359 = phi_1973_;
                                                if (_e1350.y > _e1352.y) {
                                                    phi_1982_ = _e1350.y;
                                                } else {
                                                    phi_1982_ = _e1352.y;
                                                }
                                                let _e1366 = phi_1982_;
                                                if (_e1350.z > _e1352.z) {
                                                    phi_1991_ = _e1350.z;
                                                } else {
                                                    phi_1991_ = _e1352.z;
                                                }
                                                let _e1373 = phi_1991_;
                                                let _e1375 = triangles.member[(0u + _e1010)].v2_;
                                                if (_e1359 > _e1375.x) {
                                                    phi_2000_ = _e1359;
                                                } else {
                                                    phi_2000_ = _e1375.x;
                                                }
                                                let _e1380 = phi_2000_;
                                                if (_e1366 > _e1375.y) {
                                                    phi_2007_ = _e1366;
                                                } else {
                                                    phi_2007_ = _e1375.y;
                                                }
                                                let _e1385 = phi_2007_;
                                                if (_e1373 > _e1375.z) {
                                                    phi_2014_ = _e1373;
                                                } else {
                                                    phi_2014_ = _e1375.z;
                                                }
                                                let _e1390 = phi_2014_;
                                                let _e1397 = ((_e1338 - _e151.origin.x) * _e297);
                                                let _e1398 = ((_e1343 - _e151.origin.y) * _e308);
                                                let _e1399 = ((_e1348 - _e151.origin.z) * _e319);
                                                let _e1406 = ((_e1380 - _e151.origin.x) * _e297);
                                                let _e1407 = ((_e1385 - _e151.origin.y) * _e308);
                                                let _e1408 = ((_e1390 - _e151.origin.z) * _e319);
                                                if (_e1397 < _e1406) {
                                                    phi_2037_ = _e1397;
                                                } else {
                                                    phi_2037_ = _e1406;
                                                }
                                                let _e1411 = phi_2037_;
                                                if (_e1398 < _e1407) {
                                                    phi_2042_ = _e1398;
                                                } else {
                                                    phi_2042_ = _e1407;
                                                }
                                                let _e1414 = phi_2042_;
                                                if (_e1399 < _e1408) {
                                                    phi_2047_ = _e1399;
                                                } else {
                                                    phi_2047_ = _e1408;
                                                }
                                                let _e1417 = phi_2047_;
                                                if (_e1397 > _e1406) {
                                                    phi_2055_ = _e1397;
                                                } else {
                                                    phi_2055_ = _e1406;
                                                }
                                                let _e1423 = phi_2055_;
                                                if (_e1398 > _e1407) {
                                                    phi_2060_ = _e1398;
                                                } else {
                                                    phi_2060_ = _e1407;
                                                }
                                                let _e1426 = phi_2060_;
                                                if (_e1399 > _e1408) {
                                                    phi_2065_ = _e1399;
                                                } else {
                                                    phi_2065_ = _e1408;
                                                }
                                                let _e1429 = phi_2065_;
                                                let _e1433 = core_intrinsics_maximum_number_nsz_f32_((_e1411 - _e364), (_e1414 - _e365));
                                                let _e1434 = core_intrinsics_maximum_number_nsz_f32_(_e1433, (_e1417 - _e366));
                                                let _e1435 = core_intrinsics_minimum_number_nsz_f32_((_e1423 + _e364), (_e1426 + _e365));
                                                let _e1436 = core_intrinsics_minimum_number_nsz_f32_(_e1435, (_e1429 + _e366));
                                                if (_e1434 > -300000000000000000000000000000000000000f) {
                                                    phi_2077_ = _e1434;
                                                } else {
                                                    phi_2077_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1439 = phi_2077_;
                                                if (_e1436 < 300000000000000000000000000000000000000f) {
                                                    phi_2082_ = _e1436;
                                                } else {
                                                    phi_2082_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1442 = phi_2082_;
                                                if (_e1302 < _e1439) {
                                                    phi_2087_ = _e1439;
                                                } else {
                                                    phi_2087_ = _e1302;
                                                }
                                                let _e1445 = phi_2087_;
                                                if (_e1445 > _e1442) {
                                                    phi_2092_ = _e1442;
                                                } else {
                                                    phi_2092_ = _e1445;
                                                }
                                                let _e1448 = phi_2092_;
                                                phi_2097_ = lt_bvh_triangle_Intersection(_e1448, (_e1141 / _e1200), (_e1162 / _e1200), (_e1439 <= _e1442));
                                                phi_2098_ = false;
                                            } else {
                                                phi_2097_ = lt_bvh_triangle_Intersection();
                                                phi_2098_ = true;
                                            }
                                            let _e1454 = phi_2097_;
                                            let _e1456 = phi_2098_;
                                            phi_2099_ = _e1454;
                                            phi_2100_ = _e1456;
                                        } else {
                                            phi_2099_ = lt_bvh_triangle_Intersection();
                                            phi_2100_ = true;
                                        }
                                        let _e1458 = phi_2099_;
                                        let _e1460 = phi_2100_;
                                        if _e1460 {
                                        }
                                        phi_2104_ = _e1458;
                                        phi_2105_ = _e1460;
                                    }
                                    let _e1462 = phi_2104_;
                                    let _e1464 = phi_2105_;
                                    phi_2106_ = _e1462;
                                    phi_2107_ = _e1203;
                                    phi_2108_ = _e1464;
                                } else {
                                    phi_2106_ = lt_bvh_triangle_Intersection();
                                    phi_2107_ = true;
                                    phi_2108_ = false;
                                }
                                let _e1466 = phi_2106_;
                                let _e1468 = phi_2107_;
                                let _e1470 = phi_2108_;
                                if _e1468 {
                                    phi_2112_ = true;
                                } else {
                                    phi_2112_ = _e1470;
                                }
                                let _e1472 = phi_2112_;
                                if _e1472 {
                                    phi_2116_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_2116_ = _e1466;
                                }
                                let _e1474 = phi_2116_;
                                if _e1474.is_hit {
                                    if (_e1474.t > _e151.tmin) {
                                        if (_e1474.t < _e999.t) {
                                            phi_2165_ = true;
                                        } else {
                                            if (_e1474.t == _e999.t) {
                                                if (_e999.triangle != 4294967295u) {
                                                    if (_e1010 < _e999.triangle) {
                                                        phi_2156_ = true;
                                                    } else {
                                                        if (_e1010 == _e999.triangle) {
                                                            phi_2155_ = (4294967295u < _e999.instance);
                                                        } else {
                                                            phi_2155_ = false;
                                                        }
                                                        let _e1493 = phi_2155_;
                                                        phi_2156_ = _e1493;
                                                    }
                                                    let _e1495 = phi_2156_;
                                                    phi_2157_ = _e1495;
                                                    phi_2158_ = false;
                                                } else {
                                                    phi_2157_ = bool();
                                                    phi_2158_ = true;
                                                }
                                                let _e1497 = phi_2157_;
                                                let _e1499 = phi_2158_;
                                                phi_2159_ = _e1497;
                                                phi_2160_ = _e1499;
                                            } else {
                                                phi_2159_ = bool();
                                                phi_2160_ = true;
                                            }
                                            let _e1501 = phi_2159_;
                                            let _e1503 = phi_2160_;
                                            if _e1503 {
                                                phi_2164_ = false;
                                            } else {
                                                phi_2164_ = _e1501;
                                            }
                                            let _e1505 = phi_2164_;
                                            phi_2165_ = _e1505;
                                        }
                                        let _e1507 = phi_2165_;
                                        if _e1507 {
                                            let _e1509 = triangles.member[(0u + _e1010)].i0_;
                                            if ((_e1509 & 2147483648u) == 0u) {
                                                phi_2376_ = true;
                                            } else {
                                                if (_e1010 < _e78) {
                                                } else {
                                                    return;
                                                }
                                                let _e1518 = triangles.member[(0u + _e1010)].i0_;
                                                let _e1519 = (_e1518 & 2147483647u);
                                                let _e1521 = triangles.member[(0u + _e1010)].i1_;
                                                let _e1523 = triangles.member[(0u + _e1010)].i2_;
                                                if (_e1519 < _e81) {
                                                } else {
                                                    return;
                                                }
                                                let _e1527 = vertices.member[(0u + _e1519)];
                                                if (_e1521 < _e81) {
                                                } else {
                                                    return;
                                                }
                                                let _e1531 = vertices.member[(0u + _e1521)];
                                                if (_e1523 < _e81) {
                                                } else {
                                                    return;
                                                }
                                                let _e1535 = vertices.member[(0u + _e1523)];
                                                let _e1536 = array<abi_Vertex, 3>(_e1527, _e1531, _e1535);
                                                if (_e1536[0].material < _e84) {
                                                } else {
                                                    return;
                                                }
                                                let _e1542 = materials.member[(0u + _e1536[0].material)];
                                                if ((_e1542.flags & 0u) == 0u) {
                                                    let _e1547 = ((1f - _e1474.u) - _e1474.v);
                                                    if (_e1542.cutoff <= 0f) {
                                                        phi_2371_ = true;
                                                    } else {
                                                        let _e1574 = (_e1542.base_color.w * ((((f32((_e1536[0].color >> bitcast<u32>(24i))) * _e1547) + (f32((_e1536[1].color >> bitcast<u32>(24i))) * _e1474.u)) + (f32((_e1536[2].color >> bitcast<u32>(24i))) * _e1474.v)) * (1f / 255f)));
                                                        if (_e1542.alpha_size == 0u) {
                                                            phi_2368_ = _e1574;
                                                        } else {
                                                            local.offset = _e1542.alpha_offset;
                                                            local.size = _e1542.alpha_size;
                                                            local.flags = _e1542.flags;
                                                            let _e1605 = _lt_shaders_texture_TextureView_quad((&local), (((_e1536[0].u * _e1547) + (_e1536[1].u * _e1474.u)) + (_e1536[2].u * _e1474.v)), (((_e1536[0].v * _e1547) + (_e1536[1].v * _e1474.u)) + (_e1536[2].v * _e1474.v)));
                                                            let _e1609 = (_e1605.indices[0] >> bitcast<u32>(2i));
                                                            if (_e1609 < _e90) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1613 = alpha_texels.member[(0u + _e1609)];
                                                            let _e1629 = (_e1605.indices[1] >> bitcast<u32>(2i));
                                                            if (_e1629 < _e90) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1633 = alpha_texels.member[(0u + _e1629)];
                                                            let _e1650 = (_e1605.indices[2] >> bitcast<u32>(2i));
                                                            if (_e1650 < _e90) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1654 = alpha_texels.member[(0u + _e1650)];
                                                            let _e1671 = (_e1605.indices[3] >> bitcast<u32>(2i));
                                                            if (_e1671 < _e90) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1675 = alpha_texels.member[(0u + _e1671)];
                                                            phi_2368_ = (_e1574 * (((((f32(((_e1613 >> bitcast<u32>((((_e1605.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1605.weights.x) + ((f32(((_e1633 >> bitcast<u32>((((_e1605.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1605.weights.y)) + ((f32(((_e1654 >> bitcast<u32>((((_e1605.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1605.weights.z)) + ((f32(((_e1675 >> bitcast<u32>((((_e1605.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1605.weights.w)));
                                                        }
                                                        let _e1691 = phi_2368_;
                                                        phi_2371_ = (_e1691 >= _e1542.cutoff);
                                                    }
                                                    let _e1695 = phi_2371_;
                                                    phi_2372_ = _e1695;
                                                } else {
                                                    phi_2372_ = false;
                                                }
                                                let _e1697 = phi_2372_;
                                                if _e1697 {
                                                }
                                                phi_2376_ = _e1697;
                                            }
                                            let _e1699 = phi_2376_;
                                            if _e1699 {
                                                phi_2384_ = lt_bvh_Hit(_e1474.t, _e1474.u, _e1474.v, _e1010, 4294967295u);
                                            } else {
                                                phi_2384_ = _e999;
                                            }
                                            let _e1705 = phi_2384_;
                                            phi_2385_ = _e1705;
                                        } else {
                                            phi_2385_ = _e999;
                                        }
                                        let _e1707 = phi_2385_;
                                        phi_2386_ = _e1707;
                                    } else {
                                        phi_2386_ = _e999;
                                    }
                                    let _e1709 = phi_2386_;
                                    phi_2387_ = _e1709;
                                } else {
                                    phi_2387_ = _e999;
                                }
                                let _e1711 = phi_2387_;
                                phi_1530_ = _e1711;
                                phi_1533_ = (_e1001 & (_e1001 - 1u));
                                phi_2388_ = true;
                            }
                            let _e1713 = phi_1530_;
                            let _e1715 = phi_1533_;
                            let _e1717 = phi_2388_;
                            continue;
                            continuing {
                                phi_1529_ = _e1713;
                                phi_1532_ = _e1715;
                                break if !(_e1717);
                            }
                        }
                        let _e1720 = local_1.group_mask;
                        if ((_e1720 & 4278190080u) == 0u) {
                            let _e1724 = local_1.len;
                            if (_e1724 == 0u) {
                                phi_2427_ = false;
                            } else {
                                let _e1728 = local_1.len;
                                local_1.len = (_e1728 - 1u);
                                let _e1731 = local_1.len;
                                if (_e1731 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1736 = local_1.first[(0u + _e1731)];
                                local_1.group = _e1736;
                                let _e1739 = local_1.len;
                                if (_e1739 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1744 = local_1.mask[(0u + _e1739)];
                                local_1.group_mask = _e1744;
                                phi_2427_ = true;
                            }
                            let _e1747 = phi_2427_;
                            phi_2428_ = _e1747;
                        } else {
                            phi_2428_ = true;
                        }
                        let _e1749 = phi_2428_;
                        if _e1749 {
                            let _e1751 = local_1.group_mask;
                            let _e1757 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1751)), 32u, (_e1751 == 0u)));
                            let _e1761 = local_1.group_mask;
                            let _e1775 = local_1.group_mask;
                            local_1.group_mask = (_e1775 & ~((1u << bitcast<u32>((_e1757 & 31u)))));
                            let _e1778 = local_1.group;
                            phi_2459_ = (_e1778 + countOneBits(((_e1761 & ~((4294967295u << bitcast<u32>((((_e1757 - 24u) ^ _e418) & 31u))))) & 255u)));
                        } else {
                            phi_2459_ = 4294967295u;
                        }
                        let _e1781 = phi_2459_;
                        let _e2482 = local_5;
                        phi_1193_ = _e2482;
                        phi_1196_ = _e1781;
                    } else {
                        phi_1193_ = lt_bvh_Hit();
                        phi_1196_ = u32();
                    }
                    let _e1783 = phi_1193_;
                    let _e1785 = phi_1196_;
                    continue;
                    continuing {
                        phi_1192_ = _e1783;
                        phi_1195_ = _e1785;
                        break if !(_e559);
                    }
                }
                let _e2486 = local_6;
                phi_2460_ = _e2486;
            }
            let _e1788 = phi_2460_;
            phi_2461_ = _e1788;
            phi_2462_ = _e215;
        } else {
            phi_2461_ = lt_bvh_Hit();
            phi_2462_ = true;
        }
        let _e1790 = phi_2461_;
        let _e1792 = phi_2462_;
        if _e1792 {
            phi_2466_ = _e153;
        } else {
            phi_2466_ = _e1790;
        }
        let _e1794 = phi_2466_;
        if (_e1794.triangle != 4294967295u) {
            let _e1800 = ((1f - _e1794.u) - _e1794.v);
            if (_e1794.triangle < _e78) {
            } else {
                return;
            }
            let _e1806 = triangles.member[(0u + _e1794.triangle)];
            let _e1831 = (((_e1806.v0_.x * _e1800) + (_e1806.v1_.x * _e1794.u)) + (_e1806.v2_.x * _e1794.v));
            let _e1832 = (((_e1806.v0_.y * _e1800) + (_e1806.v1_.y * _e1794.u)) + (_e1806.v2_.y * _e1794.v));
            let _e1833 = (((_e1806.v0_.z * _e1800) + (_e1806.v1_.z * _e1794.u)) + (_e1806.v2_.z * _e1794.v));
            let _e1836 = abs(_e1806.v0_.x);
            let _e1838 = abs(_e1806.v0_.y);
            let _e1840 = abs(_e1806.v0_.z);
            let _e1842 = abs(_e1806.v1_.x);
            let _e1844 = abs(_e1806.v1_.y);
            let _e1846 = abs(_e1806.v1_.z);
            if (_e1836 > _e1842) {
                phi_2531_ = _e1836;
            } else {
                phi_2531_ = _e1842;
            }
            let _e1849 = phi_2531_;
            if (_e1838 > _e1844) {
                phi_2536_ = _e1838;
            } else {
                phi_2536_ = _e1844;
            }
            let _e1852 = phi_2536_;
            if (_e1840 > _e1846) {
                phi_2541_ = _e1840;
            } else {
                phi_2541_ = _e1846;
            }
            let _e1855 = phi_2541_;
            let _e1857 = abs(_e1806.v2_.x);
            let _e1859 = abs(_e1806.v2_.y);
            let _e1861 = abs(_e1806.v2_.z);
            if (_e1849 > _e1857) {
                phi_2552_ = _e1849;
            } else {
                phi_2552_ = _e1857;
            }
            let _e1864 = phi_2552_;
            if (_e1852 > _e1859) {
                phi_2557_ = _e1852;
            } else {
                phi_2557_ = _e1859;
            }
            let _e1867 = phi_2557_;
            if (_e1855 > _e1861) {
                phi_2562_ = _e1855;
            } else {
                phi_2562_ = _e1861;
            }
            let _e1870 = phi_2562_;
            let _e1873 = (_e1806.v1_.x - _e1806.v0_.x);
            let _e1876 = (_e1806.v1_.y - _e1806.v0_.y);
            let _e1879 = (_e1806.v1_.z - _e1806.v0_.z);
            let _e1882 = (_e1806.v2_.x - _e1806.v0_.x);
            let _e1885 = (_e1806.v2_.y - _e1806.v0_.y);
            let _e1888 = (_e1806.v2_.z - _e1806.v0_.z);
            let _e1892 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1876), abs(_e1879));
            let _e1893 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1873), _e1892);
            let _e1894 = (_e1873 / _e1893);
            let _e1895 = (_e1876 / _e1893);
            let _e1896 = (_e1879 / _e1893);
            let _e1900 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1885), abs(_e1888));
            let _e1901 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1882), _e1900);
            let _e1902 = (_e1882 / _e1901);
            let _e1903 = (_e1885 / _e1901);
            let _e1904 = (_e1888 / _e1901);
            let _e1907 = ((_e1895 * _e1904) - (_e1903 * _e1896));
            let _e1910 = ((_e1896 * _e1902) - (_e1904 * _e1894));
            let _e1913 = ((_e1894 * _e1903) - (_e1902 * _e1895));
            let _e1915 = p.member.eye;
            let _e1928 = (1f / sqrt((((_e1907 * _e1907) + (_e1910 * _e1910)) + (_e1913 * _e1913))));
            let _e1929 = (_e1907 * _e1928);
            let _e1930 = (_e1910 * _e1928);
            let _e1931 = (_e1913 * _e1928);
            if ((((_e1929 * (_e1915.x - _e1831)) + (_e1930 * (_e1915.y - _e1832))) + (_e1931 * (_e1915.z - _e1833))) < 0f) {
                phi_2638_ = vec3<f32>(-(_e1929), -(_e1930), -(_e1931));
            } else {
                phi_2638_ = vec3<f32>(_e1929, _e1930, _e1931);
            }
            let _e1944 = phi_2638_;
            if (_e1794.triangle < _e78) {
            } else {
                return;
            }
            let _e1949 = triangles.member[(0u + _e1794.triangle)];
            let _e1951 = (_e1949.i0_ & 2147483647u);
            if (_e1951 < _e81) {
            } else {
                return;
            }
            let _e1957 = vertices.member[(0u + _e1951)];
            if (_e1949.i1_ < _e81) {
            } else {
                return;
            }
            let _e1961 = vertices.member[(0u + _e1949.i1_)];
            if (_e1949.i2_ < _e81) {
            } else {
                return;
            }
            let _e1965 = vertices.member[(0u + _e1949.i2_)];
            let _e1966 = array<abi_Vertex, 3>(_e1957, _e1961, _e1965);
            if (_e1966[0].material < _e84) {
            } else {
                return;
            }
            let _e1972 = materials.member[(0u + _e1966[0].material)];
            let _e1989 = (1f / 255f);
            let _e2008 = (1f / 255f);
            let _e2030 = (1f / 255f);
            let _e2043 = _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(vec3<f32>(_e1800, _e1794.u, _e1794.v));
            let _e2045 = ((_e1972.base_color.x * ((((f32((_e1966[0].color & 255u)) * _e1989) * _e1800) + ((f32((_e1966[1].color & 255u)) * _e2008) * _e1794.u)) + ((f32((_e1966[2].color & 255u)) * _e2030) * _e1794.v))) * _e2043.x);
            let _e2047 = ((_e1972.base_color.y * ((((f32(((_e1966[0].color >> bitcast<u32>(8i)) & 255u)) * _e1989) * _e1800) + ((f32(((_e1966[1].color >> bitcast<u32>(8i)) & 255u)) * _e2008) * _e1794.u)) + ((f32(((_e1966[2].color >> bitcast<u32>(8i)) & 255u)) * _e2030) * _e1794.v))) * _e2043.y);
            let _e2049 = ((_e1972.base_color.z * ((((f32(((_e1966[0].color >> bitcast<u32>(16i)) & 255u)) * _e1989) * _e1800) + ((f32(((_e1966[1].color >> bitcast<u32>(16i)) & 255u)) * _e2008) * _e1794.u)) + ((f32(((_e1966[2].color >> bitcast<u32>(16i)) & 255u)) * _e2030) * _e1794.v))) * _e2043.z);
            let _e2050 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1867, _e1870);
            let _e2051 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1864, _e2050);
            if ((_e1972.flags & 2u) == 0u) {
                phi_2759_ = 0u;
            } else {
                phi_2759_ = 1u;
            }
            let _e2056 = phi_2759_;
            if (_e1966[0].normal == 2147516416u) {
                phi_2962_ = _e1944;
            } else {
                let _e2069 = (f32((bitcast<i32>((_e1966[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2075 = (f32((bitcast<i32>(_e1966[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2079 = ((1f - abs(_e2069)) - abs(_e2075));
                if (_e2079 < 0f) {
                    phi_2786_ = -(_e2079);
                } else {
                    phi_2786_ = 0f;
                }
                let _e2083 = phi_2786_;
                if (_e2069 < 0f) {
                    phi_2793_ = (_e2069 + _e2083);
                } else {
                    phi_2793_ = (_e2069 - _e2083);
                }
                let _e2088 = phi_2793_;
                if (_e2075 < 0f) {
                    phi_2800_ = (_e2075 + _e2083);
                } else {
                    phi_2800_ = (_e2075 - _e2083);
                }
                let _e2093 = phi_2800_;
                let _e2100 = (1f / sqrt((((_e2088 * _e2088) + (_e2093 * _e2093)) + (_e2079 * _e2079))));
                let _e2116 = (f32((bitcast<i32>((_e1966[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2122 = (f32((bitcast<i32>(_e1966[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2126 = ((1f - abs(_e2116)) - abs(_e2122));
                if (_e2126 < 0f) {
                    phi_2835_ = -(_e2126);
                } else {
                    phi_2835_ = 0f;
                }
                let _e2130 = phi_2835_;
                if (_e2116 < 0f) {
                    phi_2842_ = (_e2116 + _e2130);
                } else {
                    phi_2842_ = (_e2116 - _e2130);
                }
                let _e2135 = phi_2842_;
                if (_e2122 < 0f) {
                    phi_2849_ = (_e2122 + _e2130);
                } else {
                    phi_2849_ = (_e2122 - _e2130);
                }
                let _e2140 = phi_2849_;
                let _e2147 = (1f / sqrt((((_e2135 * _e2135) + (_e2140 * _e2140)) + (_e2126 * _e2126))));
                let _e2166 = (f32((bitcast<i32>((_e1966[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2172 = (f32((bitcast<i32>(_e1966[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2176 = ((1f - abs(_e2166)) - abs(_e2172));
                if (_e2176 < 0f) {
                    phi_2887_ = -(_e2176);
                } else {
                    phi_2887_ = 0f;
                }
                let _e2180 = phi_2887_;
                if (_e2166 < 0f) {
                    phi_2894_ = (_e2166 + _e2180);
                } else {
                    phi_2894_ = (_e2166 - _e2180);
                }
                let _e2185 = phi_2894_;
                if (_e2172 < 0f) {
                    phi_2901_ = (_e2172 + _e2180);
                } else {
                    phi_2901_ = (_e2172 - _e2180);
                }
                let _e2190 = phi_2901_;
                let _e2197 = (1f / sqrt((((_e2185 * _e2185) + (_e2190 * _e2190)) + (_e2176 * _e2176))));
                let _e2208 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(vec3<f32>(((((_e2088 * _e2100) * _e1800) + ((_e2135 * _e2147) * _e1794.u)) + ((_e2185 * _e2197) * _e1794.v)), ((((_e2093 * _e2100) * _e1800) + ((_e2140 * _e2147) * _e1794.u)) + ((_e2190 * _e2197) * _e1794.v)), ((((_e2079 * _e2100) * _e1800) + ((_e2126 * _e2147) * _e1794.u)) + ((_e2176 * _e2197) * _e1794.v))));
                let _e2220 = sqrt((((_e2208.x * _e2208.x) + (_e2208.y * _e2208.y)) + (_e2208.z * _e2208.z)));
                if (_e2220 > 0f) {
                    let _e2223 = (_e2208.x / _e2220);
                    let _e2225 = (_e2208.y / _e2220);
                    let _e2227 = (_e2208.z / _e2220);
                    if ((((_e2223 * _e1944.x) + (_e2225 * _e1944.y)) + (_e2227 * _e1944.z)) < 0f) {
                        phi_2960_ = vec3<f32>(-(_e2223), -(_e2225), -(_e2227));
                    } else {
                        phi_2960_ = (_e2208 / vec3(_e2220));
                    }
                    let _e2244 = phi_2960_;
                    phi_2961_ = _e2244;
                } else {
                    phi_2961_ = _e1944;
                }
                let _e2246 = phi_2961_;
                phi_2962_ = _e2246;
            }
            let _e2248 = phi_2962_;
            if (_e2045 > 0f) {
                if (_e2045 < 1f) {
                    phi_2971_ = _e2045;
                } else {
                    phi_2971_ = 1f;
                }
                let _e2252 = phi_2971_;
                phi_2972_ = _e2252;
            } else {
                phi_2972_ = 0f;
            }
            let _e2254 = phi_2972_;
            if (_e2047 > 0f) {
                if (_e2047 < 1f) {
                    phi_2982_ = _e2047;
                } else {
                    phi_2982_ = 1f;
                }
                let _e2259 = phi_2982_;
                phi_2983_ = _e2259;
            } else {
                phi_2983_ = 0f;
            }
            let _e2261 = phi_2983_;
            if (_e2049 > 0f) {
                if (_e2049 < 1f) {
                    phi_2993_ = _e2049;
                } else {
                    phi_2993_ = 1f;
                }
                let _e2266 = phi_2993_;
                phi_2994_ = _e2266;
            } else {
                phi_2994_ = 0f;
            }
            let _e2268 = phi_2994_;
            let _e2271 = ((sqrt(_e2254) * 255f) + 0.5f);
            let _e2280 = ((sqrt(_e2261) * 255f) + 0.5f);
            let _e2292 = ((sqrt(_e2268) * 255f) + 0.5f);
            phi_3029_ = abi_Sample(vec3<f32>(_e1831, _e1832, _e1833), _e2051, _e1944, _e2056, _e2248, ((select(select(u32(_e2271), 0u, (_e2271 < bitcast<f32>(0u))), 4294967295u, (_e2271 > bitcast<f32>(1333788671u))) | (select(select(u32(_e2280), 0u, (_e2280 < bitcast<f32>(0u))), 4294967295u, (_e2280 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e2292), 0u, (_e2292 < bitcast<f32>(0u))), 4294967295u, (_e2292 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_3029_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e2306 = phi_3029_;
        if (_e96.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e96.shift)] = _e2306;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
