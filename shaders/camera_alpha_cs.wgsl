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
    var phi_212_: lt_mask_LightPlace;
    var phi_213_: bool;
    var phi_214_: lt_mask_LightPlace;
    var phi_215_: bool;
    var phi_220_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_212_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_213_ = false;
        } else {
            phi_212_ = lt_mask_LightPlace();
            phi_213_ = true;
        }
        let _e82 = phi_212_;
        let _e84 = phi_213_;
        phi_214_ = _e82;
        phi_215_ = _e84;
    } else {
        phi_214_ = lt_mask_LightPlace();
        phi_215_ = true;
    }
    let _e86 = phi_214_;
    let _e88 = phi_215_;
    if _e88 {
        phi_220_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_220_ = _e86;
    }
    let _e93 = phi_220_;
    return lt_mask_LightPlace(_e93.word, _e93.shift);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_235_: bool;
    var phi_239_: f32;

    if (param_3 != param_3) {
        phi_235_ = true;
    } else {
        let _e72 = (param_4 >= param_3);
        if _e72 {
        }
        phi_235_ = _e72;
    }
    let _e74 = phi_235_;
    if _e74 {
        phi_239_ = param_4;
    } else {
        phi_239_ = param_3;
    }
    let _e76 = phi_239_;
    return _e76;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_251_: bool;
    var phi_255_: f32;

    if (param_5 != param_5) {
        phi_251_ = true;
    } else {
        let _e72 = (param_6 <= param_5);
        if _e72 {
        }
        phi_251_ = _e72;
    }
    let _e74 = phi_251_;
    if _e74 {
        phi_255_ = param_6;
    } else {
        phi_255_ = param_5;
    }
    let _e76 = phi_255_;
    return _e76;
}

fn _lt_shaders_texture_TextureView_quad(param_7: ptr<function, texture_TextureView>, param_8: f32, param_9: f32) -> texture_TexelQuad {
    var phi_297_: f32;
    var phi_302_: f32;
    var phi_303_: bool;
    var phi_304_: f32;
    var phi_305_: bool;
    var phi_309_: f32;
    var phi_335_: f32;
    var phi_340_: f32;
    var phi_341_: bool;
    var phi_342_: f32;
    var phi_343_: bool;
    var phi_347_: f32;
    var phi_355_: f32;
    var phi_356_: f32;
    var phi_357_: f32;
    var phi_366_: f32;
    var phi_367_: f32;
    var phi_385_: u32;
    var phi_399_: u32;
    var phi_406_: u32;
    var phi_411_: u32;
    var phi_417_: u32;
    var phi_422_: u32;
    var phi_424_: texture_Axis;
    var phi_452_: f32;
    var phi_457_: f32;
    var phi_458_: bool;
    var phi_459_: f32;
    var phi_460_: bool;
    var phi_464_: f32;
    var phi_490_: f32;
    var phi_495_: f32;
    var phi_496_: bool;
    var phi_497_: f32;
    var phi_498_: bool;
    var phi_502_: f32;
    var phi_510_: f32;
    var phi_511_: f32;
    var phi_512_: f32;
    var phi_521_: f32;
    var phi_522_: f32;
    var phi_540_: u32;
    var phi_554_: u32;
    var phi_561_: u32;
    var phi_566_: u32;
    var phi_572_: u32;
    var phi_577_: u32;
    var phi_579_: texture_Axis;

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
                phi_297_ = 1f;
            } else {
                phi_297_ = 0f;
            }
            let _e103 = phi_297_;
            if (param_8 < 8388608f) {
                phi_302_ = (_e100 - _e103);
                phi_303_ = false;
            } else {
                phi_302_ = f32();
                phi_303_ = true;
            }
            let _e106 = phi_302_;
            let _e108 = phi_303_;
            phi_304_ = _e106;
            phi_305_ = _e108;
        } else {
            phi_304_ = f32();
            phi_305_ = true;
        }
        let _e110 = phi_304_;
        let _e112 = phi_305_;
        if _e112 {
            phi_309_ = param_8;
        } else {
            phi_309_ = _e110;
        }
        let _e114 = phi_309_;
        phi_357_ = (param_8 - _e114);
    } else {
        if (_e87 == 1u) {
            let _e117 = (param_8 * 0.5f);
            if (_e117 > -8388608f) {
                let _e129 = f32(select(0i, select(select(i32(_e117), i32(-2147483648), (_e117 < bitcast<f32>(3472883712u))), 2147483647i, (_e117 > bitcast<f32>(1325400063u))), (_e117 == _e117)));
                if (_e129 > _e117) {
                    phi_335_ = 1f;
                } else {
                    phi_335_ = 0f;
                }
                let _e132 = phi_335_;
                if (_e117 < 8388608f) {
                    phi_340_ = (_e129 - _e132);
                    phi_341_ = false;
                } else {
                    phi_340_ = f32();
                    phi_341_ = true;
                }
                let _e135 = phi_340_;
                let _e137 = phi_341_;
                phi_342_ = _e135;
                phi_343_ = _e137;
            } else {
                phi_342_ = f32();
                phi_343_ = true;
            }
            let _e139 = phi_342_;
            let _e141 = phi_343_;
            if _e141 {
                phi_347_ = _e117;
            } else {
                phi_347_ = _e139;
            }
            let _e143 = phi_347_;
            let _e145 = (param_8 - (2f * _e143));
            if (_e145 > 1f) {
                phi_355_ = (2f - _e145);
            } else {
                phi_355_ = _e145;
            }
            let _e149 = phi_355_;
            phi_356_ = _e149;
        } else {
            phi_356_ = param_8;
        }
        let _e151 = phi_356_;
        phi_357_ = _e151;
    }
    let _e153 = phi_357_;
    if (_e153 > 0f) {
        if (_e153 < 1f) {
            phi_366_ = _e153;
        } else {
            phi_366_ = 1f;
        }
        let _e157 = phi_366_;
        phi_367_ = _e157;
    } else {
        phi_367_ = 0f;
    }
    let _e159 = phi_367_;
    let _e160 = (_e74 - 1u);
    let _e162 = (_e159 * f32(_e74));
    if _e82 {
        let _e169 = select(select(u32(_e162), 0u, (_e162 < bitcast<f32>(0u))), 4294967295u, (_e162 > bitcast<f32>(1333788671u)));
        if (_e160 < _e169) {
            phi_385_ = _e160;
        } else {
            phi_385_ = _e169;
        }
        let _e172 = phi_385_;
        phi_424_ = texture_Axis(_e172, _e172, 0f);
    } else {
        let _e174 = (_e162 + 0.5f);
        let _e181 = select(select(u32(_e174), 0u, (_e174 < bitcast<f32>(0u))), 4294967295u, (_e174 > bitcast<f32>(1333788671u)));
        if (_e74 < _e181) {
            phi_399_ = _e74;
        } else {
            phi_399_ = _e181;
        }
        let _e184 = phi_399_;
        if (_e87 == 0u) {
            phi_406_ = _e160;
        } else {
            phi_406_ = 0u;
        }
        let _e189 = phi_406_;
        if (_e87 == 0u) {
            phi_411_ = 0u;
        } else {
            phi_411_ = _e160;
        }
        let _e192 = phi_411_;
        if (_e184 == 0u) {
            phi_417_ = _e189;
        } else {
            phi_417_ = (_e184 - 1u);
        }
        let _e196 = phi_417_;
        if (_e184 > _e160) {
            phi_422_ = _e192;
        } else {
            phi_422_ = _e184;
        }
        let _e199 = phi_422_;
        phi_424_ = texture_Axis(_e196, _e199, (_e174 - f32(_e184)));
    }
    let _e202 = phi_424_;
    let _e204 = (*param_7).flags;
    let _e207 = ((_e204 >> bitcast<u32>(6u)) & 3u);
    if (_e207 == 0u) {
        if (param_9 > -8388608f) {
            let _e220 = f32(select(0i, select(select(i32(param_9), i32(-2147483648), (param_9 < bitcast<f32>(3472883712u))), 2147483647i, (param_9 > bitcast<f32>(1325400063u))), (param_9 == param_9)));
            if (_e220 > param_9) {
                phi_452_ = 1f;
            } else {
                phi_452_ = 0f;
            }
            let _e223 = phi_452_;
            if (param_9 < 8388608f) {
                phi_457_ = (_e220 - _e223);
                phi_458_ = false;
            } else {
                phi_457_ = f32();
                phi_458_ = true;
            }
            let _e226 = phi_457_;
            let _e228 = phi_458_;
            phi_459_ = _e226;
            phi_460_ = _e228;
        } else {
            phi_459_ = f32();
            phi_460_ = true;
        }
        let _e230 = phi_459_;
        let _e232 = phi_460_;
        if _e232 {
            phi_464_ = param_9;
        } else {
            phi_464_ = _e230;
        }
        let _e234 = phi_464_;
        phi_512_ = (param_9 - _e234);
    } else {
        if (_e207 == 1u) {
            let _e237 = (param_9 * 0.5f);
            if (_e237 > -8388608f) {
                let _e249 = f32(select(0i, select(select(i32(_e237), i32(-2147483648), (_e237 < bitcast<f32>(3472883712u))), 2147483647i, (_e237 > bitcast<f32>(1325400063u))), (_e237 == _e237)));
                if (_e249 > _e237) {
                    phi_490_ = 1f;
                } else {
                    phi_490_ = 0f;
                }
                let _e252 = phi_490_;
                if (_e237 < 8388608f) {
                    phi_495_ = (_e249 - _e252);
                    phi_496_ = false;
                } else {
                    phi_495_ = f32();
                    phi_496_ = true;
                }
                let _e255 = phi_495_;
                let _e257 = phi_496_;
                phi_497_ = _e255;
                phi_498_ = _e257;
            } else {
                phi_497_ = f32();
                phi_498_ = true;
            }
            let _e259 = phi_497_;
            let _e261 = phi_498_;
            if _e261 {
                phi_502_ = _e237;
            } else {
                phi_502_ = _e259;
            }
            let _e263 = phi_502_;
            let _e265 = (param_9 - (2f * _e263));
            if (_e265 > 1f) {
                phi_510_ = (2f - _e265);
            } else {
                phi_510_ = _e265;
            }
            let _e269 = phi_510_;
            phi_511_ = _e269;
        } else {
            phi_511_ = param_9;
        }
        let _e271 = phi_511_;
        phi_512_ = _e271;
    }
    let _e273 = phi_512_;
    if (_e273 > 0f) {
        if (_e273 < 1f) {
            phi_521_ = _e273;
        } else {
            phi_521_ = 1f;
        }
        let _e277 = phi_521_;
        phi_522_ = _e277;
    } else {
        phi_522_ = 0f;
    }
    let _e279 = phi_522_;
    let _e280 = (_e78 - 1u);
    let _e282 = (_e279 * f32(_e78));
    if _e82 {
        let _e289 = select(select(u32(_e282), 0u, (_e282 < bitcast<f32>(0u))), 4294967295u, (_e282 > bitcast<f32>(1333788671u)));
        if (_e280 < _e289) {
            phi_540_ = _e280;
        } else {
            phi_540_ = _e289;
        }
        let _e292 = phi_540_;
        phi_579_ = texture_Axis(_e292, _e292, 0f);
    } else {
        let _e294 = (_e282 + 0.5f);
        let _e301 = select(select(u32(_e294), 0u, (_e294 < bitcast<f32>(0u))), 4294967295u, (_e294 > bitcast<f32>(1333788671u)));
        if (_e78 < _e301) {
            phi_554_ = _e78;
        } else {
            phi_554_ = _e301;
        }
        let _e304 = phi_554_;
        if (_e207 == 0u) {
            phi_561_ = _e280;
        } else {
            phi_561_ = 0u;
        }
        let _e309 = phi_561_;
        if (_e207 == 0u) {
            phi_566_ = 0u;
        } else {
            phi_566_ = _e280;
        }
        let _e312 = phi_566_;
        if (_e304 == 0u) {
            phi_572_ = _e309;
        } else {
            phi_572_ = (_e304 - 1u);
        }
        let _e316 = phi_572_;
        if (_e304 > _e280) {
            phi_577_ = _e312;
        } else {
            phi_577_ = _e304;
        }
        let _e319 = phi_577_;
        phi_579_ = texture_Axis(_e316, _e319, (_e294 - f32(_e304)));
    }
    let _e322 = phi_579_;
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
    var phi_3041_: f32;

    if (param_12 > param_13) {
        phi_3041_ = param_12;
    } else {
        phi_3041_ = param_13;
    }
    let _e73 = phi_3041_;
    return _e73;
}

fn _lt_bvh_ray_Ray_new(param_14: vec3<f32>, param_15: vec3<f32>) -> lt_bvh_Ray {
    return lt_bvh_Ray(param_14, 0f, param_15, 300000000000000000000000000000000000000f);
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var phi_774_: bool;
    var phi_775_: bool;
    var phi_776_: bool;
    var phi_780_: bool;
    var phi_781_: bool;
    var phi_782_: bool;
    var phi_783_: bool;
    var phi_784_: bool;
    var phi_785_: bool;
    var phi_786_: bool;
    var phi_787_: bool;
    var phi_788_: bool;
    var phi_789_: bool;
    var phi_790_: bool;
    var phi_791_: bool;
    var phi_792_: bool;
    var phi_793_: bool;
    var phi_794_: bool;
    var phi_795_: bool;
    var phi_796_: bool;
    var phi_797_: bool;
    var phi_801_: bool;
    var phi_805_: bool;
    var phi_880_: f32;
    var phi_887_: f32;
    var phi_895_: f32;
    var phi_902_: f32;
    var phi_910_: f32;
    var phi_917_: f32;
    var phi_942_: f32;
    var phi_947_: f32;
    var phi_952_: f32;
    var phi_985_: bool;
    var phi_986_: bool;
    var phi_994_: u32;
    var phi_995_: u32;
    var phi_1013_: vec3<f32>;
    var phi_1014_: vec3<f32>;
    var phi_1028_: u32;
    var phi_1033_: u32;
    var phi_1038_: u32;
    var phi_1152_: bool;
    var phi_1153_: bool;
    var phi_1184_: u32;
    var phi_1186_: lt_bvh_Hit;
    var phi_1189_: u32;
    var phi_1274_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1301_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1328_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1334_: u32;
    var phi_1337_: u32;
    var phi_1351_: u32;
    var phi_1361_: u32;
    var phi_1371_: u32;
    var phi_1389_: u32;
    var phi_1399_: u32;
    var phi_1409_: u32;
    var phi_1445_: u32;
    var phi_1458_: u32;
    var phi_1463_: u32;
    var phi_1464_: u32;
    var phi_1465_: u32;
    var phi_1335_: u32;
    var phi_1338_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_1523_: lt_bvh_Hit;
    var phi_1526_: u32;
    var phi_1572_: vec3<f32>;
    var phi_1573_: vec3<f32>;
    var phi_1604_: vec3<f32>;
    var phi_1605_: vec3<f32>;
    var phi_1636_: vec3<f32>;
    var phi_1637_: vec3<f32>;
    var phi_1655_: bool;
    var phi_1656_: bool;
    var phi_1660_: f32;
    var phi_1661_: f32;
    var phi_1662_: f32;
    var phi_1663_: f32;
    var phi_1671_: f32;
    var phi_1681_: bool;
    var phi_1682_: bool;
    var phi_1686_: f32;
    var phi_1687_: f32;
    var phi_1688_: f32;
    var phi_1689_: f32;
    var phi_1697_: f32;
    var phi_1707_: bool;
    var phi_1708_: bool;
    var phi_1712_: f32;
    var phi_1713_: f32;
    var phi_1714_: f32;
    var phi_1715_: f32;
    var phi_1723_: f32;
    var phi_1738_: f32;
    var phi_1739_: bool;
    var phi_1740_: f32;
    var phi_1741_: bool;
    var phi_1742_: f32;
    var phi_1743_: bool;
    var phi_1761_: f32;
    var phi_1762_: bool;
    var phi_1763_: bool;
    var phi_1764_: f32;
    var phi_1765_: bool;
    var phi_1766_: bool;
    var phi_1770_: bool;
    var phi_1771_: f32;
    var phi_1772_: bool;
    var phi_1802_: vec3<f32>;
    var phi_1803_: vec3<f32>;
    var phi_1828_: vec3<f32>;
    var phi_1829_: vec3<f32>;
    var phi_1854_: vec3<f32>;
    var phi_1855_: vec3<f32>;
    var phi_1913_: f32;
    var phi_1922_: f32;
    var phi_1931_: f32;
    var phi_1940_: f32;
    var phi_1947_: f32;
    var phi_1954_: f32;
    var phi_1967_: f32;
    var phi_1976_: f32;
    var phi_1985_: f32;
    var phi_1994_: f32;
    var phi_2001_: f32;
    var phi_2008_: f32;
    var phi_2031_: f32;
    var phi_2036_: f32;
    var phi_2041_: f32;
    var phi_2049_: f32;
    var phi_2054_: f32;
    var phi_2059_: f32;
    var phi_2071_: f32;
    var phi_2076_: f32;
    var phi_2081_: f32;
    var phi_2086_: f32;
    var phi_2091_: lt_bvh_triangle_Intersection;
    var phi_2092_: bool;
    var phi_2093_: lt_bvh_triangle_Intersection;
    var phi_2094_: bool;
    var phi_2098_: lt_bvh_triangle_Intersection;
    var phi_2099_: bool;
    var phi_2100_: lt_bvh_triangle_Intersection;
    var phi_2101_: bool;
    var phi_2102_: bool;
    var phi_2106_: bool;
    var phi_2110_: lt_bvh_triangle_Intersection;
    var phi_2149_: bool;
    var phi_2150_: bool;
    var phi_2151_: bool;
    var phi_2152_: bool;
    var phi_2153_: bool;
    var phi_2154_: bool;
    var phi_2158_: bool;
    var phi_2159_: bool;
    var phi_2362_: f32;
    var phi_2365_: bool;
    var phi_2366_: bool;
    var phi_2370_: bool;
    var phi_2378_: lt_bvh_Hit;
    var phi_2379_: lt_bvh_Hit;
    var phi_2380_: lt_bvh_Hit;
    var phi_2381_: lt_bvh_Hit;
    var phi_1524_: lt_bvh_Hit;
    var phi_1527_: u32;
    var phi_2382_: bool;
    var phi_2421_: bool;
    var phi_2422_: bool;
    var phi_2453_: u32;
    var phi_1187_: lt_bvh_Hit;
    var phi_1190_: u32;
    var phi_2454_: lt_bvh_Hit;
    var phi_2455_: lt_bvh_Hit;
    var phi_2456_: bool;
    var phi_2460_: lt_bvh_Hit;
    var phi_2525_: f32;
    var phi_2530_: f32;
    var phi_2535_: f32;
    var phi_2546_: f32;
    var phi_2551_: f32;
    var phi_2556_: f32;
    var phi_2632_: vec3<f32>;
    var phi_2753_: u32;
    var phi_2780_: f32;
    var phi_2787_: f32;
    var phi_2794_: f32;
    var phi_2829_: f32;
    var phi_2836_: f32;
    var phi_2843_: f32;
    var phi_2881_: f32;
    var phi_2888_: f32;
    var phi_2895_: f32;
    var phi_2954_: vec3<f32>;
    var phi_2955_: vec3<f32>;
    var phi_2956_: vec3<f32>;
    var phi_2965_: f32;
    var phi_2966_: f32;
    var phi_2976_: f32;
    var phi_2977_: f32;
    var phi_2987_: f32;
    var phi_2988_: f32;
    var phi_3023_: abi_Sample;
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
        let _e163 = abs(_e151.direction.x);
        let _e165 = abs(_e151.direction.y);
        let _e167 = abs(_e151.direction.z);
        if (abs(_e151.origin.x) < 1000000000000000f) {
            if (abs(_e151.origin.y) < 1000000000000000f) {
                if (abs(_e151.origin.z) < 1000000000000000f) {
                    if (_e163 < 1000000000000000f) {
                        if (_e165 < 1000000000000000f) {
                            if (_e167 < 1000000000000000f) {
                                if (_e163 > 0f) {
                                    phi_775_ = bool();
                                    phi_776_ = true;
                                } else {
                                    let _e175 = (_e165 > 0f);
                                    if _e175 {
                                        phi_774_ = bool();
                                    } else {
                                        phi_774_ = (_e167 > 0f);
                                    }
                                    let _e178 = phi_774_;
                                    phi_775_ = _e178;
                                    phi_776_ = _e175;
                                }
                                let _e180 = phi_775_;
                                let _e182 = phi_776_;
                                if _e182 {
                                    phi_780_ = true;
                                } else {
                                    phi_780_ = _e180;
                                }
                                let _e184 = phi_780_;
                                phi_781_ = _e184;
                                phi_782_ = false;
                            } else {
                                phi_781_ = bool();
                                phi_782_ = true;
                            }
                            let _e186 = phi_781_;
                            let _e188 = phi_782_;
                            phi_783_ = _e186;
                            phi_784_ = false;
                            phi_785_ = _e188;
                        } else {
                            phi_783_ = bool();
                            phi_784_ = true;
                            phi_785_ = false;
                        }
                        let _e190 = phi_783_;
                        let _e192 = phi_784_;
                        let _e194 = phi_785_;
                        phi_786_ = _e190;
                        phi_787_ = _e192;
                        phi_788_ = _e194;
                    } else {
                        phi_786_ = bool();
                        phi_787_ = true;
                        phi_788_ = false;
                    }
                    let _e196 = phi_786_;
                    let _e198 = phi_787_;
                    let _e200 = phi_788_;
                    phi_789_ = _e196;
                    phi_790_ = _e198;
                    phi_791_ = _e200;
                } else {
                    phi_789_ = bool();
                    phi_790_ = true;
                    phi_791_ = false;
                }
                let _e202 = phi_789_;
                let _e204 = phi_790_;
                let _e206 = phi_791_;
                phi_792_ = _e202;
                phi_793_ = _e204;
                phi_794_ = _e206;
            } else {
                phi_792_ = bool();
                phi_793_ = true;
                phi_794_ = false;
            }
            let _e208 = phi_792_;
            let _e210 = phi_793_;
            let _e212 = phi_794_;
            phi_795_ = _e208;
            phi_796_ = _e210;
            phi_797_ = _e212;
        } else {
            phi_795_ = bool();
            phi_796_ = true;
            phi_797_ = false;
        }
        let _e214 = phi_795_;
        let _e216 = phi_796_;
        let _e218 = phi_797_;
        if _e216 {
            phi_801_ = true;
        } else {
            phi_801_ = _e218;
        }
        let _e220 = phi_801_;
        if _e220 {
            phi_805_ = false;
        } else {
            phi_805_ = _e214;
        }
        let _e222 = phi_805_;
        if _e222 {
            let _e223 = (0u >= _e75);
            if _e223 {
                phi_2454_ = lt_bvh_Hit();
            } else {
                if (0u < _e75) {
                } else {
                    return;
                }
                let _e229 = nodes.member[(0u + 0u)].frame[0u];
                let _e233 = nodes.member[(0u + 0u)].frame[1u];
                let _e237 = nodes.member[(0u + 0u)].frame[2u];
                let _e241 = nodes.member[(0u + 0u)].frame[0u];
                let _e245 = nodes.member[(0u + 0u)].frame[1u];
                let _e249 = nodes.member[(0u + 0u)].frame[2u];
                let _e253 = nodes.member[(0u + 0u)].frame[3u];
                let _e291 = core_intrinsics_maximum_number_nsz_f32_(abs(_e151.direction.x), abs(_e151.direction.y));
                let _e292 = core_intrinsics_maximum_number_nsz_f32_(_e291, abs(_e151.direction.z));
                let _e293 = (_e292 * 0.0000000000009094947f);
                if (abs(_e151.direction.x) < _e293) {
                    phi_880_ = _e293;
                } else {
                    phi_880_ = abs(_e151.direction.x);
                }
                let _e299 = phi_880_;
                if (_e151.direction.x < 0f) {
                    phi_887_ = (-1f / _e299);
                } else {
                    phi_887_ = (1f / _e299);
                }
                let _e304 = phi_887_;
                if (abs(_e151.direction.y) < _e293) {
                    phi_895_ = _e293;
                } else {
                    phi_895_ = abs(_e151.direction.y);
                }
                let _e310 = phi_895_;
                if (_e151.direction.y < 0f) {
                    phi_902_ = (-1f / _e310);
                } else {
                    phi_902_ = (1f / _e310);
                }
                let _e315 = phi_902_;
                if (abs(_e151.direction.z) < _e293) {
                    phi_910_ = _e293;
                } else {
                    phi_910_ = abs(_e151.direction.z);
                }
                let _e321 = phi_910_;
                if (_e151.direction.z < 0f) {
                    phi_917_ = (-1f / _e321);
                } else {
                    phi_917_ = (1f / _e321);
                }
                let _e326 = phi_917_;
                let _e334 = abs((bitcast<f32>(_e229) - _e151.origin.x));
                let _e335 = abs((bitcast<f32>(_e233) - _e151.origin.y));
                let _e336 = abs((bitcast<f32>(_e237) - _e151.origin.z));
                let _e344 = abs(((bitcast<f32>(_e241) + (bitcast<f32>((((_e253 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e151.origin.x));
                let _e345 = abs(((bitcast<f32>(_e245) + (bitcast<f32>((((_e253 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e151.origin.y));
                let _e346 = abs(((bitcast<f32>(_e249) + (bitcast<f32>((((_e253 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e151.origin.z));
                if (_e334 > _e344) {
                    phi_942_ = _e334;
                } else {
                    phi_942_ = _e344;
                }
                let _e349 = phi_942_;
                if (_e335 > _e345) {
                    phi_947_ = _e335;
                } else {
                    phi_947_ = _e345;
                }
                let _e352 = phi_947_;
                if (_e336 > _e346) {
                    phi_952_ = _e336;
                } else {
                    phi_952_ = _e346;
                }
                let _e355 = phi_952_;
                let _e356 = core_intrinsics_maximum_number_nsz_f32_(_e349, _e352);
                let _e357 = core_intrinsics_maximum_number_nsz_f32_(_e356, _e355);
                let _e362 = (_e357 * 0.0000019073486f);
                let _e363 = (abs(_e304) * _e362);
                let _e364 = (abs(_e315) * _e362);
                let _e365 = (abs(_e326) * _e362);
                let _e369 = (_e357 * 0.0000009536743f);
                let _e370 = (abs(_e304) * _e369);
                let _e371 = (abs(_e315) * _e369);
                let _e372 = (abs(_e326) * _e369);
                let _e375 = abs(_e151.direction.x);
                let _e377 = abs(_e151.direction.y);
                let _e379 = abs(_e151.direction.z);
                if (_e375 >= _e377) {
                    if (_e375 >= _e379) {
                        phi_985_ = false;
                    } else {
                        phi_985_ = true;
                    }
                    let _e383 = phi_985_;
                    phi_986_ = _e383;
                } else {
                    phi_986_ = true;
                }
                let _e385 = phi_986_;
                if _e385 {
                    if (_e377 >= _e379) {
                        phi_994_ = 1u;
                    } else {
                        phi_994_ = 2u;
                    }
                    let _e388 = phi_994_;
                    phi_995_ = _e388;
                } else {
                    phi_995_ = 0u;
                }
                let _e390 = phi_995_;
                if (_e390 == 0u) {
                    phi_1014_ = vec3<f32>(_e151.direction.y, _e151.direction.z, _e151.direction.x);
                } else {
                    if (_e390 == 1u) {
                        phi_1013_ = vec3<f32>(_e151.direction.z, _e151.direction.x, _e151.direction.y);
                    } else {
                        phi_1013_ = _e151.direction;
                    }
                    let _e403 = phi_1013_;
                    phi_1014_ = _e403;
                }
                let _e405 = phi_1014_;
                let _e409 = (_e405.x / _e405.z);
                let _e412 = (_e405.y / _e405.z);
                if (_e304 < 0f) {
                    phi_1028_ = 0u;
                } else {
                    phi_1028_ = 1u;
                }
                let _e417 = phi_1028_;
                if (_e315 < 0f) {
                    phi_1033_ = 0u;
                } else {
                    phi_1033_ = 2u;
                }
                let _e420 = phi_1033_;
                if (_e326 < 0f) {
                    phi_1038_ = 0u;
                } else {
                    phi_1038_ = 4u;
                }
                let _e423 = phi_1038_;
                let _e425 = ((_e417 | _e420) | _e423);
                let _e426 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e426.first[0], _e426.first[1], _e426.first[2], _e426.first[3], _e426.first[4], _e426.first[5], _e426.first[6], _e426.first[7], _e426.first[8], _e426.first[9], _e426.first[10], _e426.first[11], _e426.first[12], _e426.first[13], _e426.first[14], _e426.first[15], _e426.first[16], _e426.first[17], _e426.first[18], _e426.first[19], _e426.first[20], _e426.first[21], _e426.first[22], _e426.first[23], _e426.first[24], _e426.first[25], _e426.first[26], _e426.first[27], _e426.first[28], _e426.first[29], _e426.first[30], _e426.first[31]), array<u32, 32>(_e426.mask[0], _e426.mask[1], _e426.mask[2], _e426.mask[3], _e426.mask[4], _e426.mask[5], _e426.mask[6], _e426.mask[7], _e426.mask[8], _e426.mask[9], _e426.mask[10], _e426.mask[11], _e426.mask[12], _e426.mask[13], _e426.mask[14], _e426.mask[15], _e426.mask[16], _e426.mask[17], _e426.mask[18], _e426.mask[19], _e426.mask[20], _e426.mask[21], _e426.mask[22], _e426.mask[23], _e426.mask[24], _e426.mask[25], _e426.mask[26], _e426.mask[27], _e426.mask[28], _e426.mask[29], _e426.mask[30], _e426.mask[31]), _e426.len, _e426.group, _e426.group_mask);
                let _e500 = local_1.group_mask;
                if ((_e500 & 4278190080u) == 0u) {
                    let _e504 = local_1.len;
                    if (_e504 == 0u) {
                        phi_1152_ = false;
                    } else {
                        let _e508 = local_1.len;
                        local_1.len = (_e508 - 1u);
                        let _e511 = local_1.len;
                        if (_e511 < 32u) {
                        } else {
                            return;
                        }
                        let _e516 = local_1.first[(0u + _e511)];
                        local_1.group = _e516;
                        let _e519 = local_1.len;
                        if (_e519 < 32u) {
                        } else {
                            return;
                        }
                        let _e524 = local_1.mask[(0u + _e519)];
                        local_1.group_mask = _e524;
                        phi_1152_ = true;
                    }
                    let _e527 = phi_1152_;
                    phi_1153_ = _e527;
                } else {
                    phi_1153_ = true;
                }
                let _e529 = phi_1153_;
                if _e529 {
                    let _e531 = local_1.group_mask;
                    let _e537 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e531)), 32u, (_e531 == 0u)));
                    let _e541 = local_1.group_mask;
                    let _e555 = local_1.group_mask;
                    local_1.group_mask = (_e555 & ~((1u << bitcast<u32>((_e537 & 31u)))));
                    let _e558 = local_1.group;
                    phi_1184_ = (_e558 + countOneBits(((_e541 & ~((4294967295u << bitcast<u32>((((_e537 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1184_ = 4294967295u;
                }
                let _e561 = phi_1184_;
                phi_1186_ = _e153;
                phi_1189_ = _e561;
                loop {
                    let _e563 = phi_1186_;
                    let _e565 = phi_1189_;
                    local_6 = _e563;
                    let _e566 = (_e565 != 4294967295u);
                    if _e566 {
                        if (_e565 < _e75) {
                        } else {
                            return;
                        }
                        let _e574 = nodes.member[(0u + _e565)].frame[3u];
                        let _e599 = (bitcast<f32>((((_e574 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e304);
                        let _e600 = (bitcast<f32>((((_e574 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e315);
                        let _e601 = (bitcast<f32>((((_e574 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e326);
                        let _e604 = nodes.member[(0u + _e565)].frame[0u];
                        let _e608 = nodes.member[(0u + _e565)].frame[1u];
                        let _e612 = nodes.member[(0u + _e565)].frame[2u];
                        let _e620 = ((bitcast<f32>(_e604) - _e151.origin.x) * _e304);
                        let _e621 = ((bitcast<f32>(_e608) - _e151.origin.y) * _e315);
                        let _e622 = ((bitcast<f32>(_e612) - _e151.origin.z) * _e326);
                        let _e630 = nodes.member[(0u + _e565)].x;
                        if (_e304 < 0f) {
                            let _e641 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e630.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e647 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e641.unnamed.word, _e630.w), _e641.unnamed_1);
                            let _e653 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e647.unnamed, lt_mask_LightPlace(_e630.x, _e647.unnamed_1.shift));
                            phi_1274_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e653.unnamed, lt_mask_LightPlace(_e653.unnamed_1.word, _e630.y));
                        } else {
                            let _e669 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e630.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e675 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e669.unnamed.word, _e630.y), _e669.unnamed_1);
                            let _e681 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e675.unnamed, lt_mask_LightPlace(_e630.z, _e675.unnamed_1.shift));
                            phi_1274_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e681.unnamed, lt_mask_LightPlace(_e681.unnamed_1.word, _e630.w));
                        }
                        let _e689 = phi_1274_;
                        let _e699 = nodes.member[(0u + _e565)].y;
                        if (_e315 < 0f) {
                            let _e710 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e699.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e716 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e710.unnamed.word, _e699.w), _e710.unnamed_1);
                            let _e722 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e716.unnamed, lt_mask_LightPlace(_e699.x, _e716.unnamed_1.shift));
                            phi_1301_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e722.unnamed, lt_mask_LightPlace(_e722.unnamed_1.word, _e699.y));
                        } else {
                            let _e738 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e699.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e744 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e738.unnamed.word, _e699.y), _e738.unnamed_1);
                            let _e750 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e744.unnamed, lt_mask_LightPlace(_e699.z, _e744.unnamed_1.shift));
                            phi_1301_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e750.unnamed, lt_mask_LightPlace(_e750.unnamed_1.word, _e699.w));
                        }
                        let _e758 = phi_1301_;
                        let _e768 = nodes.member[(0u + _e565)].z;
                        if (_e326 < 0f) {
                            let _e779 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e768.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e785 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e779.unnamed.word, _e768.w), _e779.unnamed_1);
                            let _e791 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e785.unnamed, lt_mask_LightPlace(_e768.x, _e785.unnamed_1.shift));
                            phi_1328_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e791.unnamed, lt_mask_LightPlace(_e791.unnamed_1.word, _e768.y));
                        } else {
                            let _e807 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e768.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e813 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e807.unnamed.word, _e768.y), _e807.unnamed_1);
                            let _e819 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e813.unnamed, lt_mask_LightPlace(_e768.z, _e813.unnamed_1.shift));
                            phi_1328_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e819.unnamed, lt_mask_LightPlace(_e819.unnamed_1.word, _e768.w));
                        }
                        let _e827 = phi_1328_;
                        phi_1334_ = 0u;
                        phi_1337_ = 0u;
                        loop {
                            let _e837 = phi_1334_;
                            let _e839 = phi_1337_;
                            local_2 = _e839;
                            local_3 = _e839;
                            local_4 = _e839;
                            let _e840 = (_e837 < 8u);
                            if _e840 {
                                let _e842 = (_e837 >> bitcast<u32>(2i));
                                let _e843 = (_e837 & 3u);
                                if (_e842 == 0u) {
                                    phi_1351_ = _e689.unnamed.word;
                                } else {
                                    phi_1351_ = _e689.unnamed.shift;
                                }
                                let _e846 = phi_1351_;
                                if (_e842 == 0u) {
                                    phi_1361_ = _e758.unnamed.word;
                                } else {
                                    phi_1361_ = _e758.unnamed.shift;
                                }
                                let _e855 = phi_1361_;
                                if (_e842 == 0u) {
                                    phi_1371_ = _e827.unnamed.word;
                                } else {
                                    phi_1371_ = _e827.unnamed.shift;
                                }
                                let _e864 = phi_1371_;
                                let _e877 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e846 >> bitcast<u32>(((_e843 * 8u) & 31u))) & 255u)) * _e599) + (_e620 - _e363)), ((f32(((_e855 >> bitcast<u32>(((_e843 * 8u) & 31u))) & 255u)) * _e600) + (_e621 - _e364)));
                                let _e878 = core_intrinsics_maximum_number_nsz_f32_(_e877, ((f32(((_e864 >> bitcast<u32>(((_e843 * 8u) & 31u))) & 255u)) * _e601) + (_e622 - _e365)));
                                if (_e842 == 0u) {
                                    phi_1389_ = _e689.unnamed_1.word;
                                } else {
                                    phi_1389_ = _e689.unnamed_1.shift;
                                }
                                let _e881 = phi_1389_;
                                if (_e842 == 0u) {
                                    phi_1399_ = _e758.unnamed_1.word;
                                } else {
                                    phi_1399_ = _e758.unnamed_1.shift;
                                }
                                let _e890 = phi_1399_;
                                if (_e842 == 0u) {
                                    phi_1409_ = _e827.unnamed_1.word;
                                } else {
                                    phi_1409_ = _e827.unnamed_1.shift;
                                }
                                let _e899 = phi_1409_;
                                let _e912 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e881 >> bitcast<u32>(((_e843 * 8u) & 31u))) & 255u)) * _e599) + (_e620 + _e363)), ((f32(((_e890 >> bitcast<u32>(((_e843 * 8u) & 31u))) & 255u)) * _e600) + (_e621 + _e364)));
                                let _e913 = core_intrinsics_minimum_number_nsz_f32_(_e912, ((f32(((_e899 >> bitcast<u32>(((_e843 * 8u) & 31u))) & 255u)) * _e601) + (_e622 + _e365)));
                                if (_e878 <= _e913) {
                                    if (_e878 <= _e563.t) {
                                        if (_e913 >= _e151.tmin) {
                                            if (_e842 == 0u) {
                                                let _e920 = nodes.member[(0u + _e565)].links[2u];
                                                phi_1445_ = _e920;
                                            } else {
                                                let _e923 = nodes.member[(0u + _e565)].links[3u];
                                                phi_1445_ = _e923;
                                            }
                                            let _e925 = phi_1445_;
                                            let _e930 = ((_e925 >> bitcast<u32>(((_e843 * 8u) & 31u))) & 255u);
                                            let _e931 = (_e930 & 31u);
                                            if (_e931 >= 24u) {
                                                phi_1458_ = (24u + ((_e931 - 24u) ^ _e425));
                                            } else {
                                                phi_1458_ = _e931;
                                            }
                                            let _e937 = phi_1458_;
                                            phi_1463_ = (_e839 | ((_e930 >> bitcast<u32>(5i)) << bitcast<u32>((_e937 & 31u))));
                                        } else {
                                            phi_1463_ = _e839;
                                        }
                                        let _e945 = phi_1463_;
                                        phi_1464_ = _e945;
                                    } else {
                                        phi_1464_ = _e839;
                                    }
                                    let _e947 = phi_1464_;
                                    phi_1465_ = _e947;
                                } else {
                                    phi_1465_ = _e839;
                                }
                                let _e949 = phi_1465_;
                                phi_1335_ = (_e837 + 1u);
                                phi_1338_ = _e949;
                            } else {
                                phi_1335_ = u32();
                                phi_1338_ = u32();
                            }
                            let _e952 = phi_1335_;
                            let _e954 = phi_1338_;
                            continue;
                            continuing {
                                phi_1334_ = _e952;
                                phi_1337_ = _e954;
                                break if !(_e840);
                            }
                        }
                        let _e958 = nodes.member[(0u + _e565)].links[0u];
                        let _e962 = nodes.member[(0u + _e565)].frame[3u];
                        let _e966 = local_2;
                        if ((_e966 & 4278190080u) == 0u) {
                        } else {
                            let _e970 = local_1.group_mask;
                            if ((_e970 & 4278190080u) == 0u) {
                            } else {
                                let _e974 = local_1.len;
                                if (_e974 < 32u) {
                                    let _e977 = local_1.group;
                                    let _e979 = local_1.len;
                                    if (_e979 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.first[(0u + _e979)] = _e977;
                                    let _e985 = local_1.group_mask;
                                    let _e987 = local_1.len;
                                    if (_e987 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.mask[(0u + _e987)] = _e985;
                                    let _e994 = local_1.len;
                                    local_1.len = (_e994 + 1u);
                                }
                            }
                            local_1.group = (0u + _e958);
                            let _e998 = local_3;
                            local_1.group_mask = ((_e998 & 4278190080u) | (_e962 >> bitcast<u32>(24i)));
                        }
                        let _e1003 = local_4;
                        phi_1523_ = _e563;
                        phi_1526_ = (_e1003 & 16777215u);
                        loop {
                            let _e1006 = phi_1523_;
                            let _e1008 = phi_1526_;
                            local_5 = _e1006;
                            if (_e1008 == 0u) {
                                phi_1524_ = lt_bvh_Hit();
                                phi_1527_ = u32();
                                phi_2382_ = false;
                            } else {
                                let _e1012 = nodes.member[(0u + _e565)].links[1u];
                                let _e1017 = ((0u + _e1012) + select(firstTrailingBit(_e1008), 32u, (_e1008 == 0u)));
                                if (_e1017 < _e78) {
                                } else {
                                    return;
                                }
                                let _e1024 = triangles.member[(0u + _e1017)].v0_;
                                let _e1027 = (_e1024.x - _e151.origin.x);
                                let _e1030 = (_e1024.y - _e151.origin.y);
                                let _e1033 = (_e1024.z - _e151.origin.z);
                                if (_e390 == 0u) {
                                    phi_1573_ = vec3<f32>(_e1030, _e1033, _e1027);
                                } else {
                                    if (_e390 == 1u) {
                                        phi_1572_ = vec3<f32>(_e1033, _e1027, _e1030);
                                    } else {
                                        phi_1572_ = (_e1024 - _e151.origin);
                                    }
                                    let _e1040 = phi_1572_;
                                    phi_1573_ = _e1040;
                                }
                                let _e1042 = phi_1573_;
                                let _e1046 = (_e1042.x - (_e409 * _e1042.z));
                                let _e1050 = (_e1042.y - (_e412 * _e1042.z));
                                let _e1052 = triangles.member[(0u + _e1017)].v1_;
                                let _e1055 = (_e1052.x - _e151.origin.x);
                                let _e1058 = (_e1052.y - _e151.origin.y);
                                let _e1061 = (_e1052.z - _e151.origin.z);
                                if (_e390 == 0u) {
                                    phi_1605_ = vec3<f32>(_e1058, _e1061, _e1055);
                                } else {
                                    if (_e390 == 1u) {
                                        phi_1604_ = vec3<f32>(_e1061, _e1055, _e1058);
                                    } else {
                                        phi_1604_ = (_e1052 - _e151.origin);
                                    }
                                    let _e1068 = phi_1604_;
                                    phi_1605_ = _e1068;
                                }
                                let _e1070 = phi_1605_;
                                let _e1074 = (_e1070.x - (_e409 * _e1070.z));
                                let _e1078 = (_e1070.y - (_e412 * _e1070.z));
                                let _e1080 = triangles.member[(0u + _e1017)].v2_;
                                let _e1083 = (_e1080.x - _e151.origin.x);
                                let _e1086 = (_e1080.y - _e151.origin.y);
                                let _e1089 = (_e1080.z - _e151.origin.z);
                                if (_e390 == 0u) {
                                    phi_1637_ = vec3<f32>(_e1086, _e1089, _e1083);
                                } else {
                                    if (_e390 == 1u) {
                                        phi_1636_ = vec3<f32>(_e1089, _e1083, _e1086);
                                    } else {
                                        phi_1636_ = (_e1080 - _e151.origin);
                                    }
                                    let _e1096 = phi_1636_;
                                    phi_1637_ = _e1096;
                                }
                                let _e1098 = phi_1637_;
                                let _e1102 = (_e1098.x - (_e409 * _e1098.z));
                                let _e1106 = (_e1098.y - (_e412 * _e1098.z));
                                if (_e1074 < _e1102) {
                                    phi_1656_ = true;
                                } else {
                                    if (_e1074 == _e1102) {
                                        phi_1655_ = (_e1078 < _e1106);
                                    } else {
                                        phi_1655_ = false;
                                    }
                                    let _e1111 = phi_1655_;
                                    phi_1656_ = _e1111;
                                }
                                let _e1113 = phi_1656_;
                                if _e1113 {
                                    phi_1660_ = _e1106;
                                    phi_1661_ = _e1102;
                                    phi_1662_ = _e1078;
                                    phi_1663_ = _e1074;
                                } else {
                                    phi_1660_ = _e1078;
                                    phi_1661_ = _e1074;
                                    phi_1662_ = _e1106;
                                    phi_1663_ = _e1102;
                                }
                                let _e1115 = phi_1660_;
                                let _e1117 = phi_1661_;
                                let _e1119 = phi_1662_;
                                let _e1121 = phi_1663_;
                                let _e1124 = ((_e1121 * _e1115) - (_e1119 * _e1117));
                                if _e1113 {
                                    phi_1671_ = -(_e1124);
                                } else {
                                    phi_1671_ = _e1124;
                                }
                                let _e1127 = phi_1671_;
                                if (_e1102 < _e1046) {
                                    phi_1682_ = true;
                                } else {
                                    if (_e1102 == _e1046) {
                                        phi_1681_ = (_e1106 < _e1050);
                                    } else {
                                        phi_1681_ = false;
                                    }
                                    let _e1132 = phi_1681_;
                                    phi_1682_ = _e1132;
                                }
                                let _e1134 = phi_1682_;
                                if _e1134 {
                                    phi_1686_ = _e1050;
                                    phi_1687_ = _e1046;
                                    phi_1688_ = _e1106;
                                    phi_1689_ = _e1102;
                                } else {
                                    phi_1686_ = _e1106;
                                    phi_1687_ = _e1102;
                                    phi_1688_ = _e1050;
                                    phi_1689_ = _e1046;
                                }
                                let _e1136 = phi_1686_;
                                let _e1138 = phi_1687_;
                                let _e1140 = phi_1688_;
                                let _e1142 = phi_1689_;
                                let _e1145 = ((_e1142 * _e1136) - (_e1140 * _e1138));
                                if _e1134 {
                                    phi_1697_ = -(_e1145);
                                } else {
                                    phi_1697_ = _e1145;
                                }
                                let _e1148 = phi_1697_;
                                if (_e1046 < _e1074) {
                                    phi_1708_ = true;
                                } else {
                                    if (_e1046 == _e1074) {
                                        phi_1707_ = (_e1050 < _e1078);
                                    } else {
                                        phi_1707_ = false;
                                    }
                                    let _e1153 = phi_1707_;
                                    phi_1708_ = _e1153;
                                }
                                let _e1155 = phi_1708_;
                                if _e1155 {
                                    phi_1712_ = _e1078;
                                    phi_1713_ = _e1074;
                                    phi_1714_ = _e1050;
                                    phi_1715_ = _e1046;
                                } else {
                                    phi_1712_ = _e1050;
                                    phi_1713_ = _e1046;
                                    phi_1714_ = _e1078;
                                    phi_1715_ = _e1074;
                                }
                                let _e1157 = phi_1712_;
                                let _e1159 = phi_1713_;
                                let _e1161 = phi_1714_;
                                let _e1163 = phi_1715_;
                                let _e1166 = ((_e1163 * _e1157) - (_e1161 * _e1159));
                                if _e1155 {
                                    phi_1723_ = -(_e1166);
                                } else {
                                    phi_1723_ = _e1166;
                                }
                                let _e1169 = phi_1723_;
                                if (_e1127 >= 0f) {
                                    if (_e1148 >= 0f) {
                                        if (_e1169 >= 0f) {
                                            phi_1738_ = ((_e1127 + _e1148) + _e1169);
                                            phi_1739_ = false;
                                        } else {
                                            phi_1738_ = f32();
                                            phi_1739_ = true;
                                        }
                                        let _e1176 = phi_1738_;
                                        let _e1178 = phi_1739_;
                                        phi_1740_ = _e1176;
                                        phi_1741_ = _e1178;
                                    } else {
                                        phi_1740_ = f32();
                                        phi_1741_ = true;
                                    }
                                    let _e1180 = phi_1740_;
                                    let _e1182 = phi_1741_;
                                    phi_1742_ = _e1180;
                                    phi_1743_ = _e1182;
                                } else {
                                    phi_1742_ = f32();
                                    phi_1743_ = true;
                                }
                                let _e1184 = phi_1742_;
                                let _e1186 = phi_1743_;
                                if _e1186 {
                                    if (_e1127 <= 0f) {
                                        if (_e1148 <= 0f) {
                                            let _e1189 = (_e1169 <= 0f);
                                            if _e1189 {
                                            }
                                            phi_1761_ = ((_e1127 + _e1148) + _e1169);
                                            phi_1762_ = false;
                                            phi_1763_ = _e1189;
                                        } else {
                                            phi_1761_ = f32();
                                            phi_1762_ = true;
                                            phi_1763_ = false;
                                        }
                                        let _e1193 = phi_1761_;
                                        let _e1195 = phi_1762_;
                                        let _e1197 = phi_1763_;
                                        phi_1764_ = _e1193;
                                        phi_1765_ = _e1195;
                                        phi_1766_ = _e1197;
                                    } else {
                                        phi_1764_ = f32();
                                        phi_1765_ = true;
                                        phi_1766_ = false;
                                    }
                                    let _e1199 = phi_1764_;
                                    let _e1201 = phi_1765_;
                                    let _e1203 = phi_1766_;
                                    if _e1201 {
                                        phi_1770_ = false;
                                    } else {
                                        phi_1770_ = _e1203;
                                    }
                                    let _e1205 = phi_1770_;
                                    phi_1771_ = _e1199;
                                    phi_1772_ = _e1205;
                                } else {
                                    phi_1771_ = _e1184;
                                    phi_1772_ = true;
                                }
                                let _e1207 = phi_1771_;
                                let _e1209 = phi_1772_;
                                if _e1209 {
                                    let _e1210 = (_e1207 == 0f);
                                    if _e1210 {
                                        phi_2098_ = lt_bvh_triangle_Intersection();
                                        phi_2099_ = false;
                                    } else {
                                        let _e1212 = triangles.member[(0u + _e1017)].v0_;
                                        let _e1215 = (_e1212.x - _e151.origin.x);
                                        let _e1218 = (_e1212.y - _e151.origin.y);
                                        let _e1221 = (_e1212.z - _e151.origin.z);
                                        if (_e390 == 0u) {
                                            phi_1803_ = vec3<f32>(_e1218, _e1221, _e1215);
                                        } else {
                                            if (_e390 == 1u) {
                                                phi_1802_ = vec3<f32>(_e1221, _e1215, _e1218);
                                            } else {
                                                phi_1802_ = (_e1212 - _e151.origin);
                                            }
                                            let _e1228 = phi_1802_;
                                            phi_1803_ = _e1228;
                                        }
                                        let _e1230 = phi_1803_;
                                        let _e1232 = triangles.member[(0u + _e1017)].v1_;
                                        let _e1234 = triangles.member[(0u + _e1017)].v0_;
                                        let _e1237 = (_e1232.x - _e1234.x);
                                        let _e1240 = (_e1232.y - _e1234.y);
                                        let _e1243 = (_e1232.z - _e1234.z);
                                        if (_e390 == 0u) {
                                            phi_1829_ = vec3<f32>(_e1240, _e1243, _e1237);
                                        } else {
                                            if (_e390 == 1u) {
                                                phi_1828_ = vec3<f32>(_e1243, _e1237, _e1240);
                                            } else {
                                                phi_1828_ = (_e1232 - _e1234);
                                            }
                                            let _e1250 = phi_1828_;
                                            phi_1829_ = _e1250;
                                        }
                                        let _e1252 = phi_1829_;
                                        let _e1254 = triangles.member[(0u + _e1017)].v2_;
                                        let _e1256 = triangles.member[(0u + _e1017)].v0_;
                                        let _e1259 = (_e1254.x - _e1256.x);
                                        let _e1262 = (_e1254.y - _e1256.y);
                                        let _e1265 = (_e1254.z - _e1256.z);
                                        if (_e390 == 0u) {
                                            phi_1855_ = vec3<f32>(_e1262, _e1265, _e1259);
                                        } else {
                                            if (_e390 == 1u) {
                                                phi_1854_ = vec3<f32>(_e1265, _e1259, _e1262);
                                            } else {
                                                phi_1854_ = (_e1254 - _e1256);
                                            }
                                            let _e1272 = phi_1854_;
                                            phi_1855_ = _e1272;
                                        }
                                        let _e1274 = phi_1855_;
                                        let _e1281 = ((_e1252.y * _e1274.z) - (_e1252.z * _e1274.y));
                                        let _e1288 = ((_e1252.z * _e1274.x) - (_e1252.x * _e1274.z));
                                        let _e1295 = ((_e1252.x * _e1274.y) - (_e1252.y * _e1274.x));
                                        let _e1309 = (((1f / _e405.z) * (((_e1281 * _e1230.x) + (_e1288 * _e1230.y)) + (_e1295 * _e1230.z))) / (((_e1281 * _e409) + (_e1288 * _e412)) + _e1295));
                                        if (_e1309 > _e151.tmin) {
                                            if (_e1309 < _e151.tmax) {
                                                let _e1315 = triangles.member[(0u + _e1017)].v0_;
                                                let _e1317 = triangles.member[(0u + _e1017)].v1_;
                                                if (_e1315.x < _e1317.x) {
                                                    phi_1913_ = _e1315.x;
                                                } else {
                                                    phi_1913_ = _e1317.x;
                                                }
                                                let _e1324 = phi_1913_;
                                                if (_e1315.y < _e1317.y) {
                                                    phi_1922_ = _e1315.y;
                                                } else {
                                                    phi_1922_ = _e1317.y;
                                                }
                                                let _e1331 = phi_1922_;
                                                if (_e1315.z < _e1317.z) {
                                                    phi_1931_ = _e1315.z;
                                                } else {
                                                    phi_1931_ = _e1317.z;
                                                }
                                                let _e1338 = phi_1931_;
                                                let _e1340 = triangles.member[(0u + _e1017)].v2_;
                                                if (_e1324 < _e1340.x) {
                                                    phi_1940_ = _e1324;
                                                } else {
                                                    phi_1940_ = _e1340.x;
                                                }
                                                let _e1345 = phi_1940_;
                                                if (_e1331 < _e1340.y) {
                                                    phi_1947_ = _e1331;
                                                } else {
                                                    phi_1947_ = _e1340.y;
                                                }
                                                let _e1350 = phi_1947_;
                                                if (_e1338 < _e1340.z) {
                                                    phi_1954_ = _e1338;
                                                } else {
                                                    phi_1954_ = _e1340.z;
                                                }
                                                let _e1355 = phi_1954_;
                                                let _e1357 = triangles.member[(0u + _e1017)].v0_;
                                                let _e1359 = triangles.member[(0u + _e1017)].v1_;
                                                if (_e1357.x > _e1359.x) {
                                                    phi_1967_ = _e1357.x;
                                                } else {
                                                    phi_1967_ = _e1359.x;
                                                }
                                                let _e1366 = phi_1967_;
                                                if (_e1357.y > _e1359.y) {
                                                    phi_1976_ = _e1357.y;
                                                } else {
                                                    phi_1976_ = _e1359.y;
                                                }
                                                let _e1373 = phi_1976_;
                                                if (_e1357.z > _e1359.z) {
                                                    phi_1985_ = _e1357.z;
                                                } else {
                                                    phi_1985_ = _e1359.z;
                                                }
                                                let _e1380 = phi_1985_;
                                                let _e1382 = triangles.member[(0u + _e1017)].v2_;
                                                if (_e1366 > _e1382.x) {
                                                    phi_1994_ = _e1366;
                                                } else {
                                                    phi_1994_ = _e1382.x;
                                                }
                                                let _e1387 = phi_1994_;
                                                if (_e1373 > _e1382.y) {
                                                    phi_2001_ = _e1373;
                                                } else {
                                                    phi_2001_ = _e1382.y;
                                                }
                                                let _e1392 = phi_2001_;
                                                if (_e1380 > _e1382.z) {
                                                    phi_2008_ = _e1380;
                                                } else {
                                                    phi_2008_ = _e1382.z;
                                                }
                                                let _e1397 = phi_2008_;
                                                let _e1404 = ((_e1345 - _e151.origin.x) * _e304);
                                                let _e1405 = ((_e1350 - _e151.origin.y) * _e315);
                                                let _e1406 = ((_e1355 - _e151.origin.z) * _e326);
                                                let _e1413 = ((_e1387 - _e151.origin.x) * _e304);
                                                let _e1414 = ((_e1392 - _e151.origin.y) * _e315);
                                                let _e1415 = ((_e1397 - _e151.origin.z) * _e326);
                                                if (_e1404 < _e1413) {
                                                    phi_2031_ = _e1404;
                                                } else {
                                                    phi_2031_ = _e1413;
                                                }
                                                let _e1418 = phi_2031_;
                                                if (_e1405 < _e1414) {
                                                    phi_2036_ = _e1405;
                                                } else {
                                                    phi_2036_ = _e1414;
                                                }
                                                let _e1421 = phi_2036_;
                                                if (_e1406 < _e1415) {
                                                    phi_2041_ = _e1406;
                                                } else {
                                                    phi_2041_ = _e1415;
                                                }
                                                let _e1424 = phi_2041_;
                                                if (_e1404 > _e1413) {
                                                    phi_2049_ = _e1404;
                                                } else {
                                                    phi_2049_ = _e1413;
                                                }
                                                let _e1430 = phi_2049_;
                                                if (_e1405 > _e1414) {
                                                    phi_2054_ = _e1405;
                                                } else {
                                                    phi_2054_ = _e1414;
                                                }
                                                let _e1433 = phi_2054_;
                                                if (_e1406 > _e1415) {
                                                    phi_2059_ = _e1406;
                                                } else {
                                                    phi_2059_ = _e1415;
                                                }
                                                let _e1436 = phi_2059_;
                                                let _e1440 = core_intrinsics_maximum_number_nsz_f32_((_e1418 - _e370), (_e1421 - _e371));
                                                let _e1441 = core_intrinsics_maximum_number_nsz_f32_(_e1440, (_e1424 - _e372));
                                                let _e1442 = core_intrinsics_minimum_number_nsz_f32_((_e1430 + _e370), (_e1433 + _e371));
                                                let _e1443 = core_intrinsics_minimum_number_nsz_f32_(_e1442, (_e1436 + _e372));
                                                if (_e1441 > -300000000000000000000000000000000000000f) {
                                                    phi_2071_ = _e1441;
                                                } else {
                                                    phi_2071_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1446 = phi_2071_;
                                                if (_e1443 < 300000000000000000000000000000000000000f) {
                                                    phi_2076_ = _e1443;
                                                } else {
                                                    phi_2076_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1449 = phi_2076_;
                                                if (_e1309 < _e1446) {
                                                    phi_2081_ = _e1446;
                                                } else {
                                                    phi_2081_ = _e1309;
                                                }
                                                let _e1452 = phi_2081_;
                                                if (_e1452 > _e1449) {
                                                    phi_2086_ = _e1449;
                                                } else {
                                                    phi_2086_ = _e1452;
                                                }
                                                let _e1455 = phi_2086_;
                                                phi_2091_ = lt_bvh_triangle_Intersection(_e1455, (_e1148 / _e1207), (_e1169 / _e1207), (_e1446 <= _e1449));
                                                phi_2092_ = false;
                                            } else {
                                                phi_2091_ = lt_bvh_triangle_Intersection();
                                                phi_2092_ = true;
                                            }
                                            let _e1461 = phi_2091_;
                                            let _e1463 = phi_2092_;
                                            phi_2093_ = _e1461;
                                            phi_2094_ = _e1463;
                                        } else {
                                            phi_2093_ = lt_bvh_triangle_Intersection();
                                            phi_2094_ = true;
                                        }
                                        let _e1465 = phi_2093_;
                                        let _e1467 = phi_2094_;
                                        if _e1467 {
                                        }
                                        phi_2098_ = _e1465;
                                        phi_2099_ = _e1467;
                                    }
                                    let _e1469 = phi_2098_;
                                    let _e1471 = phi_2099_;
                                    phi_2100_ = _e1469;
                                    phi_2101_ = _e1210;
                                    phi_2102_ = _e1471;
                                } else {
                                    phi_2100_ = lt_bvh_triangle_Intersection();
                                    phi_2101_ = true;
                                    phi_2102_ = false;
                                }
                                let _e1473 = phi_2100_;
                                let _e1475 = phi_2101_;
                                let _e1477 = phi_2102_;
                                if _e1475 {
                                    phi_2106_ = true;
                                } else {
                                    phi_2106_ = _e1477;
                                }
                                let _e1479 = phi_2106_;
                                if _e1479 {
                                    phi_2110_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_2110_ = _e1473;
                                }
                                let _e1481 = phi_2110_;
                                if _e1481.is_hit {
                                    if (_e1481.t > _e151.tmin) {
                                        if (_e1481.t < _e1006.t) {
                                            phi_2159_ = true;
                                        } else {
                                            if (_e1481.t == _e1006.t) {
                                                if (_e1006.triangle != 4294967295u) {
                                                    if (_e1017 < _e1006.triangle) {
                                                        phi_2150_ = true;
                                                    } else {
                                                        if (_e1017 == _e1006.triangle) {
                                                            phi_2149_ = (4294967295u < _e1006.instance);
                                                        } else {
                                                            phi_2149_ = false;
                                                        }
                                                        let _e1500 = phi_2149_;
                                                        phi_2150_ = _e1500;
                                                    }
                                                    let _e1502 = phi_2150_;
                                                    phi_2151_ = _e1502;
                                                    phi_2152_ = false;
                                                } else {
                                                    phi_2151_ = bool();
                                                    phi_2152_ = true;
                                                }
                                                let _e1504 = phi_2151_;
                                                let _e1506 = phi_2152_;
                                                phi_2153_ = _e1504;
                                                phi_2154_ = _e1506;
                                            } else {
                                                phi_2153_ = bool();
                                                phi_2154_ = true;
                                            }
                                            let _e1508 = phi_2153_;
                                            let _e1510 = phi_2154_;
                                            if _e1510 {
                                                phi_2158_ = false;
                                            } else {
                                                phi_2158_ = _e1508;
                                            }
                                            let _e1512 = phi_2158_;
                                            phi_2159_ = _e1512;
                                        }
                                        let _e1514 = phi_2159_;
                                        if _e1514 {
                                            let _e1516 = triangles.member[(0u + _e1017)].i0_;
                                            if ((_e1516 & 2147483648u) == 0u) {
                                                phi_2370_ = true;
                                            } else {
                                                if (_e1017 < _e78) {
                                                } else {
                                                    return;
                                                }
                                                let _e1525 = triangles.member[(0u + _e1017)].i0_;
                                                let _e1526 = (_e1525 & 2147483647u);
                                                let _e1528 = triangles.member[(0u + _e1017)].i1_;
                                                let _e1530 = triangles.member[(0u + _e1017)].i2_;
                                                if (_e1526 < _e81) {
                                                } else {
                                                    return;
                                                }
                                                let _e1534 = vertices.member[(0u + _e1526)];
                                                if (_e1528 < _e81) {
                                                } else {
                                                    return;
                                                }
                                                let _e1538 = vertices.member[(0u + _e1528)];
                                                if (_e1530 < _e81) {
                                                } else {
                                                    return;
                                                }
                                                let _e1542 = vertices.member[(0u + _e1530)];
                                                let _e1543 = array<abi_Vertex, 3>(_e1534, _e1538, _e1542);
                                                if (_e1543[0].material < _e84) {
                                                } else {
                                                    return;
                                                }
                                                let _e1549 = materials.member[(0u + _e1543[0].material)];
                                                if ((_e1549.flags & 0u) == 0u) {
                                                    let _e1554 = ((1f - _e1481.u) - _e1481.v);
                                                    if (_e1549.cutoff <= 0f) {
                                                        phi_2365_ = true;
                                                    } else {
                                                        let _e1581 = (_e1549.base_color.w * ((((f32((_e1543[0].color >> bitcast<u32>(24i))) * _e1554) + (f32((_e1543[1].color >> bitcast<u32>(24i))) * _e1481.u)) + (f32((_e1543[2].color >> bitcast<u32>(24i))) * _e1481.v)) * (1f / 255f)));
                                                        if (_e1549.alpha_size == 0u) {
                                                            phi_2362_ = _e1581;
                                                        } else {
                                                            local.offset = _e1549.alpha_offset;
                                                            local.size = _e1549.alpha_size;
                                                            local.flags = _e1549.flags;
                                                            let _e1612 = _lt_shaders_texture_TextureView_quad((&local), (((_e1543[0].u * _e1554) + (_e1543[1].u * _e1481.u)) + (_e1543[2].u * _e1481.v)), (((_e1543[0].v * _e1554) + (_e1543[1].v * _e1481.u)) + (_e1543[2].v * _e1481.v)));
                                                            let _e1616 = (_e1612.indices[0] >> bitcast<u32>(2i));
                                                            if (_e1616 < _e90) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1620 = alpha_texels.member[(0u + _e1616)];
                                                            let _e1636 = (_e1612.indices[1] >> bitcast<u32>(2i));
                                                            if (_e1636 < _e90) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1640 = alpha_texels.member[(0u + _e1636)];
                                                            let _e1657 = (_e1612.indices[2] >> bitcast<u32>(2i));
                                                            if (_e1657 < _e90) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1661 = alpha_texels.member[(0u + _e1657)];
                                                            let _e1678 = (_e1612.indices[3] >> bitcast<u32>(2i));
                                                            if (_e1678 < _e90) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1682 = alpha_texels.member[(0u + _e1678)];
                                                            phi_2362_ = (_e1581 * (((((f32(((_e1620 >> bitcast<u32>((((_e1612.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1612.weights.x) + ((f32(((_e1640 >> bitcast<u32>((((_e1612.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1612.weights.y)) + ((f32(((_e1661 >> bitcast<u32>((((_e1612.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1612.weights.z)) + ((f32(((_e1682 >> bitcast<u32>((((_e1612.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1612.weights.w)));
                                                        }
                                                        let _e1698 = phi_2362_;
                                                        phi_2365_ = (_e1698 >= _e1549.cutoff);
                                                    }
                                                    let _e1702 = phi_2365_;
                                                    phi_2366_ = _e1702;
                                                } else {
                                                    phi_2366_ = false;
                                                }
                                                let _e1704 = phi_2366_;
                                                if _e1704 {
                                                }
                                                phi_2370_ = _e1704;
                                            }
                                            let _e1706 = phi_2370_;
                                            if _e1706 {
                                                phi_2378_ = lt_bvh_Hit(_e1481.t, _e1481.u, _e1481.v, _e1017, 4294967295u);
                                            } else {
                                                phi_2378_ = _e1006;
                                            }
                                            let _e1712 = phi_2378_;
                                            phi_2379_ = _e1712;
                                        } else {
                                            phi_2379_ = _e1006;
                                        }
                                        let _e1714 = phi_2379_;
                                        phi_2380_ = _e1714;
                                    } else {
                                        phi_2380_ = _e1006;
                                    }
                                    let _e1716 = phi_2380_;
                                    phi_2381_ = _e1716;
                                } else {
                                    phi_2381_ = _e1006;
                                }
                                let _e1718 = phi_2381_;
                                phi_1524_ = _e1718;
                                phi_1527_ = (_e1008 & (_e1008 - 1u));
                                phi_2382_ = true;
                            }
                            let _e1720 = phi_1524_;
                            let _e1722 = phi_1527_;
                            let _e1724 = phi_2382_;
                            continue;
                            continuing {
                                phi_1523_ = _e1720;
                                phi_1526_ = _e1722;
                                break if !(_e1724);
                            }
                        }
                        let _e1727 = local_1.group_mask;
                        if ((_e1727 & 4278190080u) == 0u) {
                            let _e1731 = local_1.len;
                            if (_e1731 == 0u) {
                                phi_2421_ = false;
                            } else {
                                let _e1735 = local_1.len;
                                local_1.len = (_e1735 - 1u);
                                let _e1738 = local_1.len;
                                if (_e1738 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1743 = local_1.first[(0u + _e1738)];
                                local_1.group = _e1743;
                                let _e1746 = local_1.len;
                                if (_e1746 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1751 = local_1.mask[(0u + _e1746)];
                                local_1.group_mask = _e1751;
                                phi_2421_ = true;
                            }
                            let _e1754 = phi_2421_;
                            phi_2422_ = _e1754;
                        } else {
                            phi_2422_ = true;
                        }
                        let _e1756 = phi_2422_;
                        if _e1756 {
                            let _e1758 = local_1.group_mask;
                            let _e1764 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1758)), 32u, (_e1758 == 0u)));
                            let _e1768 = local_1.group_mask;
                            let _e1782 = local_1.group_mask;
                            local_1.group_mask = (_e1782 & ~((1u << bitcast<u32>((_e1764 & 31u)))));
                            let _e1785 = local_1.group;
                            phi_2453_ = (_e1785 + countOneBits(((_e1768 & ~((4294967295u << bitcast<u32>((((_e1764 - 24u) ^ _e425) & 31u))))) & 255u)));
                        } else {
                            phi_2453_ = 4294967295u;
                        }
                        let _e1788 = phi_2453_;
                        let _e2491 = local_5;
                        phi_1187_ = _e2491;
                        phi_1190_ = _e1788;
                    } else {
                        phi_1187_ = lt_bvh_Hit();
                        phi_1190_ = u32();
                    }
                    let _e1790 = phi_1187_;
                    let _e1792 = phi_1190_;
                    continue;
                    continuing {
                        phi_1186_ = _e1790;
                        phi_1189_ = _e1792;
                        break if !(_e566);
                    }
                }
                let _e2495 = local_6;
                phi_2454_ = _e2495;
            }
            let _e1795 = phi_2454_;
            phi_2455_ = _e1795;
            phi_2456_ = _e223;
        } else {
            phi_2455_ = lt_bvh_Hit();
            phi_2456_ = true;
        }
        let _e1797 = phi_2455_;
        let _e1799 = phi_2456_;
        if _e1799 {
            phi_2460_ = _e153;
        } else {
            phi_2460_ = _e1797;
        }
        let _e1801 = phi_2460_;
        if (_e1801.triangle != 4294967295u) {
            let _e1807 = ((1f - _e1801.u) - _e1801.v);
            if (_e1801.triangle < _e78) {
            } else {
                return;
            }
            let _e1813 = triangles.member[(0u + _e1801.triangle)];
            let _e1838 = (((_e1813.v0_.x * _e1807) + (_e1813.v1_.x * _e1801.u)) + (_e1813.v2_.x * _e1801.v));
            let _e1839 = (((_e1813.v0_.y * _e1807) + (_e1813.v1_.y * _e1801.u)) + (_e1813.v2_.y * _e1801.v));
            let _e1840 = (((_e1813.v0_.z * _e1807) + (_e1813.v1_.z * _e1801.u)) + (_e1813.v2_.z * _e1801.v));
            let _e1843 = abs(_e1813.v0_.x);
            let _e1845 = abs(_e1813.v0_.y);
            let _e1847 = abs(_e1813.v0_.z);
            let _e1849 = abs(_e1813.v1_.x);
            let _e1851 = abs(_e1813.v1_.y);
            let _e1853 = abs(_e1813.v1_.z);
            if (_e1843 > _e1849) {
                phi_2525_ = _e1843;
            } else {
                phi_2525_ = _e1849;
            }
            let _e1856 = phi_2525_;
            if (_e1845 > _e1851) {
                phi_2530_ = _e1845;
            } else {
                phi_2530_ = _e1851;
            }
            let _e1859 = phi_2530_;
            if (_e1847 > _e1853) {
                phi_2535_ = _e1847;
            } else {
                phi_2535_ = _e1853;
            }
            let _e1862 = phi_2535_;
            let _e1864 = abs(_e1813.v2_.x);
            let _e1866 = abs(_e1813.v2_.y);
            let _e1868 = abs(_e1813.v2_.z);
            if (_e1856 > _e1864) {
                phi_2546_ = _e1856;
            } else {
                phi_2546_ = _e1864;
            }
            let _e1871 = phi_2546_;
            if (_e1859 > _e1866) {
                phi_2551_ = _e1859;
            } else {
                phi_2551_ = _e1866;
            }
            let _e1874 = phi_2551_;
            if (_e1862 > _e1868) {
                phi_2556_ = _e1862;
            } else {
                phi_2556_ = _e1868;
            }
            let _e1877 = phi_2556_;
            let _e1880 = (_e1813.v1_.x - _e1813.v0_.x);
            let _e1883 = (_e1813.v1_.y - _e1813.v0_.y);
            let _e1886 = (_e1813.v1_.z - _e1813.v0_.z);
            let _e1889 = (_e1813.v2_.x - _e1813.v0_.x);
            let _e1892 = (_e1813.v2_.y - _e1813.v0_.y);
            let _e1895 = (_e1813.v2_.z - _e1813.v0_.z);
            let _e1899 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1883), abs(_e1886));
            let _e1900 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1880), _e1899);
            let _e1901 = (_e1880 / _e1900);
            let _e1902 = (_e1883 / _e1900);
            let _e1903 = (_e1886 / _e1900);
            let _e1907 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1892), abs(_e1895));
            let _e1908 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1889), _e1907);
            let _e1909 = (_e1889 / _e1908);
            let _e1910 = (_e1892 / _e1908);
            let _e1911 = (_e1895 / _e1908);
            let _e1914 = ((_e1902 * _e1911) - (_e1910 * _e1903));
            let _e1917 = ((_e1903 * _e1909) - (_e1911 * _e1901));
            let _e1920 = ((_e1901 * _e1910) - (_e1909 * _e1902));
            let _e1922 = p.member.eye;
            let _e1935 = (1f / sqrt((((_e1914 * _e1914) + (_e1917 * _e1917)) + (_e1920 * _e1920))));
            let _e1936 = (_e1914 * _e1935);
            let _e1937 = (_e1917 * _e1935);
            let _e1938 = (_e1920 * _e1935);
            if ((((_e1936 * (_e1922.x - _e1838)) + (_e1937 * (_e1922.y - _e1839))) + (_e1938 * (_e1922.z - _e1840))) < 0f) {
                phi_2632_ = vec3<f32>(-(_e1936), -(_e1937), -(_e1938));
            } else {
                phi_2632_ = vec3<f32>(_e1936, _e1937, _e1938);
            }
            let _e1951 = phi_2632_;
            if (_e1801.triangle < _e78) {
            } else {
                return;
            }
            let _e1956 = triangles.member[(0u + _e1801.triangle)];
            let _e1958 = (_e1956.i0_ & 2147483647u);
            if (_e1958 < _e81) {
            } else {
                return;
            }
            let _e1964 = vertices.member[(0u + _e1958)];
            if (_e1956.i1_ < _e81) {
            } else {
                return;
            }
            let _e1968 = vertices.member[(0u + _e1956.i1_)];
            if (_e1956.i2_ < _e81) {
            } else {
                return;
            }
            let _e1972 = vertices.member[(0u + _e1956.i2_)];
            let _e1973 = array<abi_Vertex, 3>(_e1964, _e1968, _e1972);
            if (_e1973[0].material < _e84) {
            } else {
                return;
            }
            let _e1979 = materials.member[(0u + _e1973[0].material)];
            let _e1996 = (1f / 255f);
            let _e2015 = (1f / 255f);
            let _e2037 = (1f / 255f);
            let _e2050 = _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(vec3<f32>(_e1807, _e1801.u, _e1801.v));
            let _e2052 = ((_e1979.base_color.x * ((((f32((_e1973[0].color & 255u)) * _e1996) * _e1807) + ((f32((_e1973[1].color & 255u)) * _e2015) * _e1801.u)) + ((f32((_e1973[2].color & 255u)) * _e2037) * _e1801.v))) * _e2050.x);
            let _e2054 = ((_e1979.base_color.y * ((((f32(((_e1973[0].color >> bitcast<u32>(8i)) & 255u)) * _e1996) * _e1807) + ((f32(((_e1973[1].color >> bitcast<u32>(8i)) & 255u)) * _e2015) * _e1801.u)) + ((f32(((_e1973[2].color >> bitcast<u32>(8i)) & 255u)) * _e2037) * _e1801.v))) * _e2050.y);
            let _e2056 = ((_e1979.base_color.z * ((((f32(((_e1973[0].color >> bitcast<u32>(16i)) & 255u)) * _e1996) * _e1807) + ((f32(((_e1973[1].color >> bitcast<u32>(16i)) & 255u)) * _e2015) * _e1801.u)) + ((f32(((_e1973[2].color >> bitcast<u32>(16i)) & 255u)) * _e2037) * _e1801.v))) * _e2050.z);
            let _e2057 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1874, _e1877);
            let _e2058 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1871, _e2057);
            if ((_e1979.flags & 2u) == 0u) {
                phi_2753_ = 0u;
            } else {
                phi_2753_ = 1u;
            }
            let _e2063 = phi_2753_;
            if (_e1973[0].normal == 2147516416u) {
                phi_2956_ = _e1951;
            } else {
                let _e2076 = (f32((bitcast<i32>((_e1973[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2082 = (f32((bitcast<i32>(_e1973[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2086 = ((1f - abs(_e2076)) - abs(_e2082));
                if (_e2086 < 0f) {
                    phi_2780_ = -(_e2086);
                } else {
                    phi_2780_ = 0f;
                }
                let _e2090 = phi_2780_;
                if (_e2076 < 0f) {
                    phi_2787_ = (_e2076 + _e2090);
                } else {
                    phi_2787_ = (_e2076 - _e2090);
                }
                let _e2095 = phi_2787_;
                if (_e2082 < 0f) {
                    phi_2794_ = (_e2082 + _e2090);
                } else {
                    phi_2794_ = (_e2082 - _e2090);
                }
                let _e2100 = phi_2794_;
                let _e2107 = (1f / sqrt((((_e2095 * _e2095) + (_e2100 * _e2100)) + (_e2086 * _e2086))));
                let _e2123 = (f32((bitcast<i32>((_e1973[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2129 = (f32((bitcast<i32>(_e1973[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2133 = ((1f - abs(_e2123)) - abs(_e2129));
                if (_e2133 < 0f) {
                    phi_2829_ = -(_e2133);
                } else {
                    phi_2829_ = 0f;
                }
                let _e2137 = phi_2829_;
                if (_e2123 < 0f) {
                    phi_2836_ = (_e2123 + _e2137);
                } else {
                    phi_2836_ = (_e2123 - _e2137);
                }
                let _e2142 = phi_2836_;
                if (_e2129 < 0f) {
                    phi_2843_ = (_e2129 + _e2137);
                } else {
                    phi_2843_ = (_e2129 - _e2137);
                }
                let _e2147 = phi_2843_;
                let _e2154 = (1f / sqrt((((_e2142 * _e2142) + (_e2147 * _e2147)) + (_e2133 * _e2133))));
                let _e2173 = (f32((bitcast<i32>((_e1973[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2179 = (f32((bitcast<i32>(_e1973[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2183 = ((1f - abs(_e2173)) - abs(_e2179));
                if (_e2183 < 0f) {
                    phi_2881_ = -(_e2183);
                } else {
                    phi_2881_ = 0f;
                }
                let _e2187 = phi_2881_;
                if (_e2173 < 0f) {
                    phi_2888_ = (_e2173 + _e2187);
                } else {
                    phi_2888_ = (_e2173 - _e2187);
                }
                let _e2192 = phi_2888_;
                if (_e2179 < 0f) {
                    phi_2895_ = (_e2179 + _e2187);
                } else {
                    phi_2895_ = (_e2179 - _e2187);
                }
                let _e2197 = phi_2895_;
                let _e2204 = (1f / sqrt((((_e2192 * _e2192) + (_e2197 * _e2197)) + (_e2183 * _e2183))));
                let _e2215 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(vec3<f32>(((((_e2095 * _e2107) * _e1807) + ((_e2142 * _e2154) * _e1801.u)) + ((_e2192 * _e2204) * _e1801.v)), ((((_e2100 * _e2107) * _e1807) + ((_e2147 * _e2154) * _e1801.u)) + ((_e2197 * _e2204) * _e1801.v)), ((((_e2086 * _e2107) * _e1807) + ((_e2133 * _e2154) * _e1801.u)) + ((_e2183 * _e2204) * _e1801.v))));
                let _e2227 = sqrt((((_e2215.x * _e2215.x) + (_e2215.y * _e2215.y)) + (_e2215.z * _e2215.z)));
                if (_e2227 > 0f) {
                    let _e2230 = (_e2215.x / _e2227);
                    let _e2232 = (_e2215.y / _e2227);
                    let _e2234 = (_e2215.z / _e2227);
                    if ((((_e2230 * _e1951.x) + (_e2232 * _e1951.y)) + (_e2234 * _e1951.z)) < 0f) {
                        phi_2954_ = vec3<f32>(-(_e2230), -(_e2232), -(_e2234));
                    } else {
                        phi_2954_ = (_e2215 / vec3(_e2227));
                    }
                    let _e2251 = phi_2954_;
                    phi_2955_ = _e2251;
                } else {
                    phi_2955_ = _e1951;
                }
                let _e2253 = phi_2955_;
                phi_2956_ = _e2253;
            }
            let _e2255 = phi_2956_;
            if (_e2052 > 0f) {
                if (_e2052 < 1f) {
                    phi_2965_ = _e2052;
                } else {
                    phi_2965_ = 1f;
                }
                let _e2259 = phi_2965_;
                phi_2966_ = _e2259;
            } else {
                phi_2966_ = 0f;
            }
            let _e2261 = phi_2966_;
            if (_e2054 > 0f) {
                if (_e2054 < 1f) {
                    phi_2976_ = _e2054;
                } else {
                    phi_2976_ = 1f;
                }
                let _e2266 = phi_2976_;
                phi_2977_ = _e2266;
            } else {
                phi_2977_ = 0f;
            }
            let _e2268 = phi_2977_;
            if (_e2056 > 0f) {
                if (_e2056 < 1f) {
                    phi_2987_ = _e2056;
                } else {
                    phi_2987_ = 1f;
                }
                let _e2273 = phi_2987_;
                phi_2988_ = _e2273;
            } else {
                phi_2988_ = 0f;
            }
            let _e2275 = phi_2988_;
            let _e2278 = ((sqrt(_e2261) * 255f) + 0.5f);
            let _e2287 = ((sqrt(_e2268) * 255f) + 0.5f);
            let _e2299 = ((sqrt(_e2275) * 255f) + 0.5f);
            phi_3023_ = abi_Sample(vec3<f32>(_e1838, _e1839, _e1840), _e2058, _e1951, _e2063, _e2255, ((select(select(u32(_e2278), 0u, (_e2278 < bitcast<f32>(0u))), 4294967295u, (_e2278 > bitcast<f32>(1333788671u))) | (select(select(u32(_e2287), 0u, (_e2287 < bitcast<f32>(0u))), 4294967295u, (_e2287 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e2299), 0u, (_e2299 < bitcast<f32>(0u))), 4294967295u, (_e2299 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_3023_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e2313 = phi_3023_;
        if (_e96.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e96.shift)] = _e2313;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
