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
                let _e300 = phi_880_;
                if (_e151.direction.x < 0f) {
                    phi_887_ = (-1f / _e300);
                } else {
                    phi_887_ = (1f / _e300);
                }
                let _e305 = phi_887_;
                if (abs(_e151.direction.y) < _e293) {
                    phi_895_ = _e293;
                } else {
                    phi_895_ = abs(_e151.direction.y);
                }
                let _e312 = phi_895_;
                if (_e151.direction.y < 0f) {
                    phi_902_ = (-1f / _e312);
                } else {
                    phi_902_ = (1f / _e312);
                }
                let _e317 = phi_902_;
                if (abs(_e151.direction.z) < _e293) {
                    phi_910_ = _e293;
                } else {
                    phi_910_ = abs(_e151.direction.z);
                }
                let _e324 = phi_910_;
                if (_e151.direction.z < 0f) {
                    phi_917_ = (-1f / _e324);
                } else {
                    phi_917_ = (1f / _e324);
                }
                let _e329 = phi_917_;
                let _e337 = abs((bitcast<f32>(_e229) - _e151.origin.x));
                let _e338 = abs((bitcast<f32>(_e233) - _e151.origin.y));
                let _e339 = abs((bitcast<f32>(_e237) - _e151.origin.z));
                let _e347 = abs(((bitcast<f32>(_e241) + (bitcast<f32>((((_e253 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e151.origin.x));
                let _e348 = abs(((bitcast<f32>(_e245) + (bitcast<f32>((((_e253 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e151.origin.y));
                let _e349 = abs(((bitcast<f32>(_e249) + (bitcast<f32>((((_e253 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e151.origin.z));
                if (_e337 > _e347) {
                    phi_942_ = _e337;
                } else {
                    phi_942_ = _e347;
                }
                let _e352 = phi_942_;
                if (_e338 > _e348) {
                    phi_947_ = _e338;
                } else {
                    phi_947_ = _e348;
                }
                let _e355 = phi_947_;
                if (_e339 > _e349) {
                    phi_952_ = _e339;
                } else {
                    phi_952_ = _e349;
                }
                let _e358 = phi_952_;
                let _e359 = core_intrinsics_maximum_number_nsz_f32_(_e352, _e355);
                let _e360 = core_intrinsics_maximum_number_nsz_f32_(_e359, _e358);
                let _e365 = (_e360 * 0.0000019073486f);
                let _e366 = (abs(_e305) * _e365);
                let _e367 = (abs(_e317) * _e365);
                let _e368 = (abs(_e329) * _e365);
                let _e372 = (_e360 * 0.0000009536743f);
                let _e373 = (abs(_e305) * _e372);
                let _e374 = (abs(_e317) * _e372);
                let _e375 = (abs(_e329) * _e372);
                let _e378 = abs(_e151.direction.x);
                let _e380 = abs(_e151.direction.y);
                let _e382 = abs(_e151.direction.z);
                if (_e378 >= _e380) {
                    if (_e378 >= _e382) {
                        phi_985_ = false;
                    } else {
                        phi_985_ = true;
                    }
                    let _e386 = phi_985_;
                    phi_986_ = _e386;
                } else {
                    phi_986_ = true;
                }
                let _e388 = phi_986_;
                if _e388 {
                    if (_e380 >= _e382) {
                        phi_994_ = 1u;
                    } else {
                        phi_994_ = 2u;
                    }
                    let _e391 = phi_994_;
                    phi_995_ = _e391;
                } else {
                    phi_995_ = 0u;
                }
                let _e393 = phi_995_;
                if (_e393 == 0u) {
                    phi_1014_ = vec3<f32>(_e151.direction.y, _e151.direction.z, _e151.direction.x);
                } else {
                    if (_e393 == 1u) {
                        phi_1013_ = vec3<f32>(_e151.direction.z, _e151.direction.x, _e151.direction.y);
                    } else {
                        phi_1013_ = _e151.direction;
                    }
                    let _e406 = phi_1013_;
                    phi_1014_ = _e406;
                }
                let _e408 = phi_1014_;
                let _e412 = (_e408.x / _e408.z);
                let _e415 = (_e408.y / _e408.z);
                if (_e305 < 0f) {
                    phi_1028_ = 0u;
                } else {
                    phi_1028_ = 1u;
                }
                let _e420 = phi_1028_;
                if (_e317 < 0f) {
                    phi_1033_ = 0u;
                } else {
                    phi_1033_ = 2u;
                }
                let _e423 = phi_1033_;
                if (_e329 < 0f) {
                    phi_1038_ = 0u;
                } else {
                    phi_1038_ = 4u;
                }
                let _e426 = phi_1038_;
                let _e428 = ((_e420 | _e423) | _e426);
                let _e429 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e429.first[0], _e429.first[1], _e429.first[2], _e429.first[3], _e429.first[4], _e429.first[5], _e429.first[6], _e429.first[7], _e429.first[8], _e429.first[9], _e429.first[10], _e429.first[11], _e429.first[12], _e429.first[13], _e429.first[14], _e429.first[15], _e429.first[16], _e429.first[17], _e429.first[18], _e429.first[19], _e429.first[20], _e429.first[21], _e429.first[22], _e429.first[23], _e429.first[24], _e429.first[25], _e429.first[26], _e429.first[27], _e429.first[28], _e429.first[29], _e429.first[30], _e429.first[31]), array<u32, 32>(_e429.mask[0], _e429.mask[1], _e429.mask[2], _e429.mask[3], _e429.mask[4], _e429.mask[5], _e429.mask[6], _e429.mask[7], _e429.mask[8], _e429.mask[9], _e429.mask[10], _e429.mask[11], _e429.mask[12], _e429.mask[13], _e429.mask[14], _e429.mask[15], _e429.mask[16], _e429.mask[17], _e429.mask[18], _e429.mask[19], _e429.mask[20], _e429.mask[21], _e429.mask[22], _e429.mask[23], _e429.mask[24], _e429.mask[25], _e429.mask[26], _e429.mask[27], _e429.mask[28], _e429.mask[29], _e429.mask[30], _e429.mask[31]), _e429.len, _e429.group, _e429.group_mask);
                let _e503 = local_1.group_mask;
                if ((_e503 & 4278190080u) == 0u) {
                    let _e507 = local_1.len;
                    if (_e507 == 0u) {
                        phi_1152_ = false;
                    } else {
                        let _e511 = local_1.len;
                        local_1.len = (_e511 - 1u);
                        let _e514 = local_1.len;
                        if (_e514 < 32u) {
                        } else {
                            return;
                        }
                        let _e519 = local_1.first[(0u + _e514)];
                        local_1.group = _e519;
                        let _e522 = local_1.len;
                        if (_e522 < 32u) {
                        } else {
                            return;
                        }
                        let _e527 = local_1.mask[(0u + _e522)];
                        local_1.group_mask = _e527;
                        phi_1152_ = true;
                    }
                    let _e530 = phi_1152_;
                    phi_1153_ = _e530;
                } else {
                    phi_1153_ = true;
                }
                let _e532 = phi_1153_;
                if _e532 {
                    let _e534 = local_1.group_mask;
                    let _e540 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e534)), 32u, (_e534 == 0u)));
                    let _e544 = local_1.group_mask;
                    let _e558 = local_1.group_mask;
                    local_1.group_mask = (_e558 & ~((1u << bitcast<u32>((_e540 & 31u)))));
                    let _e561 = local_1.group;
                    phi_1184_ = (_e561 + countOneBits(((_e544 & ~((4294967295u << bitcast<u32>((((_e540 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1184_ = 4294967295u;
                }
                let _e564 = phi_1184_;
                phi_1186_ = _e153;
                phi_1189_ = _e564;
                loop {
                    let _e566 = phi_1186_;
                    let _e568 = phi_1189_;
                    local_6 = _e566;
                    let _e569 = (_e568 != 4294967295u);
                    if _e569 {
                        if (_e568 < _e75) {
                        } else {
                            return;
                        }
                        let _e577 = nodes.member[(0u + _e568)].frame[3u];
                        let _e602 = (bitcast<f32>((((_e577 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e305);
                        let _e603 = (bitcast<f32>((((_e577 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e317);
                        let _e604 = (bitcast<f32>((((_e577 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e329);
                        let _e607 = nodes.member[(0u + _e568)].frame[0u];
                        let _e611 = nodes.member[(0u + _e568)].frame[1u];
                        let _e615 = nodes.member[(0u + _e568)].frame[2u];
                        let _e623 = ((bitcast<f32>(_e607) - _e151.origin.x) * _e305);
                        let _e624 = ((bitcast<f32>(_e611) - _e151.origin.y) * _e317);
                        let _e625 = ((bitcast<f32>(_e615) - _e151.origin.z) * _e329);
                        let _e633 = nodes.member[(0u + _e568)].x;
                        if (_e305 < 0f) {
                            let _e644 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e633.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e650 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e644.unnamed.word, _e633.w), _e644.unnamed_1);
                            let _e656 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e650.unnamed, lt_mask_LightPlace(_e633.x, _e650.unnamed_1.shift));
                            phi_1274_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e656.unnamed, lt_mask_LightPlace(_e656.unnamed_1.word, _e633.y));
                        } else {
                            let _e672 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e633.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e678 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e672.unnamed.word, _e633.y), _e672.unnamed_1);
                            let _e684 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e678.unnamed, lt_mask_LightPlace(_e633.z, _e678.unnamed_1.shift));
                            phi_1274_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e684.unnamed, lt_mask_LightPlace(_e684.unnamed_1.word, _e633.w));
                        }
                        let _e692 = phi_1274_;
                        let _e702 = nodes.member[(0u + _e568)].y;
                        if (_e317 < 0f) {
                            let _e713 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e702.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e719 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e713.unnamed.word, _e702.w), _e713.unnamed_1);
                            let _e725 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e719.unnamed, lt_mask_LightPlace(_e702.x, _e719.unnamed_1.shift));
                            phi_1301_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e725.unnamed, lt_mask_LightPlace(_e725.unnamed_1.word, _e702.y));
                        } else {
                            let _e741 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e702.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e747 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e741.unnamed.word, _e702.y), _e741.unnamed_1);
                            let _e753 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e747.unnamed, lt_mask_LightPlace(_e702.z, _e747.unnamed_1.shift));
                            phi_1301_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e753.unnamed, lt_mask_LightPlace(_e753.unnamed_1.word, _e702.w));
                        }
                        let _e761 = phi_1301_;
                        let _e771 = nodes.member[(0u + _e568)].z;
                        if (_e329 < 0f) {
                            let _e782 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e771.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e788 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e782.unnamed.word, _e771.w), _e782.unnamed_1);
                            let _e794 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e788.unnamed, lt_mask_LightPlace(_e771.x, _e788.unnamed_1.shift));
                            phi_1328_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e794.unnamed, lt_mask_LightPlace(_e794.unnamed_1.word, _e771.y));
                        } else {
                            let _e810 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e771.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e816 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e810.unnamed.word, _e771.y), _e810.unnamed_1);
                            let _e822 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e816.unnamed, lt_mask_LightPlace(_e771.z, _e816.unnamed_1.shift));
                            phi_1328_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e822.unnamed, lt_mask_LightPlace(_e822.unnamed_1.word, _e771.w));
                        }
                        let _e830 = phi_1328_;
                        phi_1334_ = 0u;
                        phi_1337_ = 0u;
                        loop {
                            let _e840 = phi_1334_;
                            let _e842 = phi_1337_;
                            local_2 = _e842;
                            local_3 = _e842;
                            local_4 = _e842;
                            let _e843 = (_e840 < 8u);
                            if _e843 {
                                let _e845 = (_e840 >> bitcast<u32>(2i));
                                let _e846 = (_e840 & 3u);
                                if (_e845 == 0u) {
                                    phi_1351_ = _e692.unnamed.word;
                                } else {
                                    phi_1351_ = _e692.unnamed.shift;
                                }
                                let _e849 = phi_1351_;
                                if (_e845 == 0u) {
                                    phi_1361_ = _e761.unnamed.word;
                                } else {
                                    phi_1361_ = _e761.unnamed.shift;
                                }
                                let _e858 = phi_1361_;
                                if (_e845 == 0u) {
                                    phi_1371_ = _e830.unnamed.word;
                                } else {
                                    phi_1371_ = _e830.unnamed.shift;
                                }
                                let _e867 = phi_1371_;
                                let _e880 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e849 >> bitcast<u32>(((_e846 * 8u) & 31u))) & 255u)) * _e602) + (_e623 - _e366)), ((f32(((_e858 >> bitcast<u32>(((_e846 * 8u) & 31u))) & 255u)) * _e603) + (_e624 - _e367)));
                                let _e881 = core_intrinsics_maximum_number_nsz_f32_(_e880, ((f32(((_e867 >> bitcast<u32>(((_e846 * 8u) & 31u))) & 255u)) * _e604) + (_e625 - _e368)));
                                if (_e845 == 0u) {
                                    phi_1389_ = _e692.unnamed_1.word;
                                } else {
                                    phi_1389_ = _e692.unnamed_1.shift;
                                }
                                let _e884 = phi_1389_;
                                if (_e845 == 0u) {
                                    phi_1399_ = _e761.unnamed_1.word;
                                } else {
                                    phi_1399_ = _e761.unnamed_1.shift;
                                }
                                let _e893 = phi_1399_;
                                if (_e845 == 0u) {
                                    phi_1409_ = _e830.unnamed_1.word;
                                } else {
                                    phi_1409_ = _e830.unnamed_1.shift;
                                }
                                let _e902 = phi_1409_;
                                let _e915 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e884 >> bitcast<u32>(((_e846 * 8u) & 31u))) & 255u)) * _e602) + (_e623 + _e366)), ((f32(((_e893 >> bitcast<u32>(((_e846 * 8u) & 31u))) & 255u)) * _e603) + (_e624 + _e367)));
                                let _e916 = core_intrinsics_minimum_number_nsz_f32_(_e915, ((f32(((_e902 >> bitcast<u32>(((_e846 * 8u) & 31u))) & 255u)) * _e604) + (_e625 + _e368)));
                                if (_e881 <= _e916) {
                                    if (_e881 <= _e566.t) {
                                        if (_e916 >= _e151.tmin) {
                                            if (_e845 == 0u) {
                                                let _e923 = nodes.member[(0u + _e568)].links[2u];
                                                phi_1445_ = _e923;
                                            } else {
                                                let _e926 = nodes.member[(0u + _e568)].links[3u];
                                                phi_1445_ = _e926;
                                            }
                                            let _e928 = phi_1445_;
                                            let _e933 = ((_e928 >> bitcast<u32>(((_e846 * 8u) & 31u))) & 255u);
                                            let _e934 = (_e933 & 31u);
                                            if (_e934 >= 24u) {
                                                phi_1458_ = (24u + ((_e934 - 24u) ^ _e428));
                                            } else {
                                                phi_1458_ = _e934;
                                            }
                                            let _e940 = phi_1458_;
                                            phi_1463_ = (_e842 | ((_e933 >> bitcast<u32>(5i)) << bitcast<u32>((_e940 & 31u))));
                                        } else {
                                            phi_1463_ = _e842;
                                        }
                                        let _e948 = phi_1463_;
                                        phi_1464_ = _e948;
                                    } else {
                                        phi_1464_ = _e842;
                                    }
                                    let _e950 = phi_1464_;
                                    phi_1465_ = _e950;
                                } else {
                                    phi_1465_ = _e842;
                                }
                                let _e952 = phi_1465_;
                                phi_1335_ = (_e840 + 1u);
                                phi_1338_ = _e952;
                            } else {
                                phi_1335_ = u32();
                                phi_1338_ = u32();
                            }
                            let _e955 = phi_1335_;
                            let _e957 = phi_1338_;
                            continue;
                            continuing {
                                phi_1334_ = _e955;
                                phi_1337_ = _e957;
                                break if !(_e843);
                            }
                        }
                        let _e961 = nodes.member[(0u + _e568)].links[0u];
                        let _e965 = nodes.member[(0u + _e568)].frame[3u];
                        let _e969 = local_2;
                        if ((_e969 & 4278190080u) == 0u) {
                        } else {
                            let _e973 = local_1.group_mask;
                            if ((_e973 & 4278190080u) == 0u) {
                            } else {
                                let _e977 = local_1.len;
                                if (_e977 < 32u) {
                                    let _e980 = local_1.group;
                                    let _e982 = local_1.len;
                                    if (_e982 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.first[(0u + _e982)] = _e980;
                                    let _e988 = local_1.group_mask;
                                    let _e990 = local_1.len;
                                    if (_e990 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.mask[(0u + _e990)] = _e988;
                                    let _e997 = local_1.len;
                                    local_1.len = (_e997 + 1u);
                                }
                            }
                            local_1.group = (0u + _e961);
                            let _e1001 = local_3;
                            local_1.group_mask = ((_e1001 & 4278190080u) | (_e965 >> bitcast<u32>(24i)));
                        }
                        let _e1006 = local_4;
                        phi_1523_ = _e566;
                        phi_1526_ = (_e1006 & 16777215u);
                        loop {
                            let _e1009 = phi_1523_;
                            let _e1011 = phi_1526_;
                            local_5 = _e1009;
                            if (_e1011 == 0u) {
                                phi_1524_ = lt_bvh_Hit();
                                phi_1527_ = u32();
                                phi_2382_ = false;
                            } else {
                                let _e1015 = nodes.member[(0u + _e568)].links[1u];
                                let _e1020 = ((0u + _e1015) + select(firstTrailingBit(_e1011), 32u, (_e1011 == 0u)));
                                if (_e1020 < _e78) {
                                } else {
                                    return;
                                }
                                let _e1027 = triangles.member[(0u + _e1020)].v0_;
                                let _e1030 = (_e1027.x - _e151.origin.x);
                                let _e1033 = (_e1027.y - _e151.origin.y);
                                let _e1036 = (_e1027.z - _e151.origin.z);
                                if (_e393 == 0u) {
                                    phi_1573_ = vec3<f32>(_e1033, _e1036, _e1030);
                                } else {
                                    if (_e393 == 1u) {
                                        phi_1572_ = vec3<f32>(_e1036, _e1030, _e1033);
                                    } else {
                                        phi_1572_ = (_e1027 - _e151.origin);
                                    }
                                    let _e1043 = phi_1572_;
                                    phi_1573_ = _e1043;
                                }
                                let _e1045 = phi_1573_;
                                let _e1049 = (_e1045.x - (_e412 * _e1045.z));
                                let _e1053 = (_e1045.y - (_e415 * _e1045.z));
                                let _e1055 = triangles.member[(0u + _e1020)].v1_;
                                let _e1058 = (_e1055.x - _e151.origin.x);
                                let _e1061 = (_e1055.y - _e151.origin.y);
                                let _e1064 = (_e1055.z - _e151.origin.z);
                                if (_e393 == 0u) {
                                    phi_1605_ = vec3<f32>(_e1061, _e1064, _e1058);
                                } else {
                                    if (_e393 == 1u) {
                                        phi_1604_ = vec3<f32>(_e1064, _e1058, _e1061);
                                    } else {
                                        phi_1604_ = (_e1055 - _e151.origin);
                                    }
                                    let _e1071 = phi_1604_;
                                    phi_1605_ = _e1071;
                                }
                                let _e1073 = phi_1605_;
                                let _e1077 = (_e1073.x - (_e412 * _e1073.z));
                                let _e1081 = (_e1073.y - (_e415 * _e1073.z));
                                let _e1083 = triangles.member[(0u + _e1020)].v2_;
                                let _e1086 = (_e1083.x - _e151.origin.x);
                                let _e1089 = (_e1083.y - _e151.origin.y);
                                let _e1092 = (_e1083.z - _e151.origin.z);
                                if (_e393 == 0u) {
                                    phi_1637_ = vec3<f32>(_e1089, _e1092, _e1086);
                                } else {
                                    if (_e393 == 1u) {
                                        phi_1636_ = vec3<f32>(_e1092, _e1086, _e1089);
                                    } else {
                                        phi_1636_ = (_e1083 - _e151.origin);
                                    }
                                    let _e1099 = phi_1636_;
                                    phi_1637_ = _e1099;
                                }
                                let _e1101 = phi_1637_;
                                let _e1105 = (_e1101.x - (_e412 * _e1101.z));
                                let _e1109 = (_e1101.y - (_e415 * _e1101.z));
                                if (_e1077 < _e1105) {
                                    phi_1656_ = true;
                                } else {
                                    if (_e1077 == _e1105) {
                                        phi_1655_ = (_e1081 < _e1109);
                                    } else {
                                        phi_1655_ = false;
                                    }
                                    let _e1114 = phi_1655_;
                                    phi_1656_ = _e1114;
                                }
                                let _e1116 = phi_1656_;
                                if _e1116 {
                                    phi_1660_ = _e1109;
                                    phi_1661_ = _e1105;
                                    phi_1662_ = _e1081;
                                    phi_1663_ = _e1077;
                                } else {
                                    phi_1660_ = _e1081;
                                    phi_1661_ = _e1077;
                                    phi_1662_ = _e1109;
                                    phi_1663_ = _e1105;
                                }
                                let _e1118 = phi_1660_;
                                let _e1120 = phi_1661_;
                                let _e1122 = phi_1662_;
                                let _e1124 = phi_1663_;
                                let _e1127 = ((_e1124 * _e1118) - (_e1122 * _e1120));
                                if _e1116 {
                                    phi_1671_ = -(_e1127);
                                } else {
                                    phi_1671_ = _e1127;
                                }
                                let _e1130 = phi_1671_;
                                if (_e1105 < _e1049) {
                                    phi_1682_ = true;
                                } else {
                                    if (_e1105 == _e1049) {
                                        phi_1681_ = (_e1109 < _e1053);
                                    } else {
                                        phi_1681_ = false;
                                    }
                                    let _e1135 = phi_1681_;
                                    phi_1682_ = _e1135;
                                }
                                let _e1137 = phi_1682_;
                                if _e1137 {
                                    phi_1686_ = _e1053;
                                    phi_1687_ = _e1049;
                                    phi_1688_ = _e1109;
                                    phi_1689_ = _e1105;
                                } else {
                                    phi_1686_ = _e1109;
                                    phi_1687_ = _e1105;
                                    phi_1688_ = _e1053;
                                    phi_1689_ = _e1049;
                                }
                                let _e1139 = phi_1686_;
                                let _e1141 = phi_1687_;
                                let _e1143 = phi_1688_;
                                let _e1145 = phi_1689_;
                                let _e1148 = ((_e1145 * _e1139) - (_e1143 * _e1141));
                                if _e1137 {
                                    phi_1697_ = -(_e1148);
                                } else {
                                    phi_1697_ = _e1148;
                                }
                                let _e1151 = phi_1697_;
                                if (_e1049 < _e1077) {
                                    phi_1708_ = true;
                                } else {
                                    if (_e1049 == _e1077) {
                                        phi_1707_ = (_e1053 < _e1081);
                                    } else {
                                        phi_1707_ = false;
                                    }
                                    let _e1156 = phi_1707_;
                                    phi_1708_ = _e1156;
                                }
                                let _e1158 = phi_1708_;
                                if _e1158 {
                                    phi_1712_ = _e1081;
                                    phi_1713_ = _e1077;
                                    phi_1714_ = _e1053;
                                    phi_1715_ = _e1049;
                                } else {
                                    phi_1712_ = _e1053;
                                    phi_1713_ = _e1049;
                                    phi_1714_ = _e1081;
                                    phi_1715_ = _e1077;
                                }
                                let _e1160 = phi_1712_;
                                let _e1162 = phi_1713_;
                                let _e1164 = phi_1714_;
                                let _e1166 = phi_1715_;
                                let _e1169 = ((_e1166 * _e1160) - (_e1164 * _e1162));
                                if _e1158 {
                                    phi_1723_ = -(_e1169);
                                } else {
                                    phi_1723_ = _e1169;
                                }
                                let _e1172 = phi_1723_;
                                if (_e1130 >= 0f) {
                                    if (_e1151 >= 0f) {
                                        if (_e1172 >= 0f) {
                                            phi_1738_ = ((_e1130 + _e1151) + _e1172);
                                            phi_1739_ = false;
                                        } else {
                                            phi_1738_ = f32();
                                            phi_1739_ = true;
                                        }
                                        let _e1179 = phi_1738_;
                                        let _e1181 = phi_1739_;
                                        phi_1740_ = _e1179;
                                        phi_1741_ = _e1181;
                                    } else {
                                        phi_1740_ = f32();
                                        phi_1741_ = true;
                                    }
                                    let _e1183 = phi_1740_;
                                    let _e1185 = phi_1741_;
                                    phi_1742_ = _e1183;
                                    phi_1743_ = _e1185;
                                } else {
                                    phi_1742_ = f32();
                                    phi_1743_ = true;
                                }
                                let _e1187 = phi_1742_;
                                let _e1189 = phi_1743_;
                                if _e1189 {
                                    if (_e1130 <= 0f) {
                                        if (_e1151 <= 0f) {
                                            let _e1192 = (_e1172 <= 0f);
                                            if _e1192 {
                                            }
                                            phi_1761_ = ((_e1130 + _e1151) + _e1172);
                                            phi_1762_ = false;
                                            phi_1763_ = _e1192;
                                        } else {
                                            phi_1761_ = f32();
                                            phi_1762_ = true;
                                            phi_1763_ = false;
                                        }
                                        let _e1196 = phi_1761_;
                                        let _e1198 = phi_1762_;
                                        let _e1200 = phi_1763_;
                                        phi_1764_ = _e1196;
                                        phi_1765_ = _e1198;
                                        phi_1766_ = _e1200;
                                    } else {
                                        phi_1764_ = f32();
                                        phi_1765_ = true;
                                        phi_1766_ = false;
                                    }
                                    let _e1202 = phi_1764_;
                                    let _e1204 = phi_1765_;
                                    let _e1206 = phi_1766_;
                                    if _e1204 {
                                        phi_1770_ = false;
                                    } else {
                                        phi_1770_ = _e1206;
                                    }
                                    let _e1208 = phi_1770_;
                                    phi_1771_ = _e1202;
                                    phi_1772_ = _e1208;
                                } else {
                                    phi_1771_ = _e1187;
                                    phi_1772_ = true;
                                }
                                let _e1210 = phi_1771_;
                                let _e1212 = phi_1772_;
                                if _e1212 {
                                    let _e1213 = (_e1210 == 0f);
                                    if _e1213 {
                                        phi_2098_ = lt_bvh_triangle_Intersection();
                                        phi_2099_ = false;
                                    } else {
                                        let _e1215 = triangles.member[(0u + _e1020)].v0_;
                                        let _e1218 = (_e1215.x - _e151.origin.x);
                                        let _e1221 = (_e1215.y - _e151.origin.y);
                                        let _e1224 = (_e1215.z - _e151.origin.z);
                                        if (_e393 == 0u) {
                                            phi_1803_ = vec3<f32>(_e1221, _e1224, _e1218);
                                        } else {
                                            if (_e393 == 1u) {
                                                phi_1802_ = vec3<f32>(_e1224, _e1218, _e1221);
                                            } else {
                                                phi_1802_ = (_e1215 - _e151.origin);
                                            }
                                            let _e1231 = phi_1802_;
                                            phi_1803_ = _e1231;
                                        }
                                        let _e1233 = phi_1803_;
                                        let _e1235 = triangles.member[(0u + _e1020)].v1_;
                                        let _e1237 = triangles.member[(0u + _e1020)].v0_;
                                        let _e1240 = (_e1235.x - _e1237.x);
                                        let _e1243 = (_e1235.y - _e1237.y);
                                        let _e1246 = (_e1235.z - _e1237.z);
                                        if (_e393 == 0u) {
                                            phi_1829_ = vec3<f32>(_e1243, _e1246, _e1240);
                                        } else {
                                            if (_e393 == 1u) {
                                                phi_1828_ = vec3<f32>(_e1246, _e1240, _e1243);
                                            } else {
                                                phi_1828_ = (_e1235 - _e1237);
                                            }
                                            let _e1253 = phi_1828_;
                                            phi_1829_ = _e1253;
                                        }
                                        let _e1255 = phi_1829_;
                                        let _e1257 = triangles.member[(0u + _e1020)].v2_;
                                        let _e1259 = triangles.member[(0u + _e1020)].v0_;
                                        let _e1262 = (_e1257.x - _e1259.x);
                                        let _e1265 = (_e1257.y - _e1259.y);
                                        let _e1268 = (_e1257.z - _e1259.z);
                                        if (_e393 == 0u) {
                                            phi_1855_ = vec3<f32>(_e1265, _e1268, _e1262);
                                        } else {
                                            if (_e393 == 1u) {
                                                phi_1854_ = vec3<f32>(_e1268, _e1262, _e1265);
                                            } else {
                                                phi_1854_ = (_e1257 - _e1259);
                                            }
                                            let _e1275 = phi_1854_;
                                            phi_1855_ = _e1275;
                                        }
                                        let _e1277 = phi_1855_;
                                        let _e1284 = ((_e1255.y * _e1277.z) - (_e1255.z * _e1277.y));
                                        let _e1291 = ((_e1255.z * _e1277.x) - (_e1255.x * _e1277.z));
                                        let _e1298 = ((_e1255.x * _e1277.y) - (_e1255.y * _e1277.x));
                                        let _e1312 = (((1f / _e408.z) * (((_e1284 * _e1233.x) + (_e1291 * _e1233.y)) + (_e1298 * _e1233.z))) / (((_e1284 * _e412) + (_e1291 * _e415)) + _e1298));
                                        if (_e1312 > _e151.tmin) {
                                            if (_e1312 < _e151.tmax) {
                                                let _e1318 = triangles.member[(0u + _e1020)].v0_;
                                                let _e1320 = triangles.member[(0u + _e1020)].v1_;
                                                if (_e1318.x < _e1320.x) {
                                                    phi_1913_ = _e1318.x;
                                                } else {
                                                    phi_1913_ = _e1320.x;
                                                }
                                                let _e1327 = phi_1913_;
                                                if (_e1318.y < _e1320.y) {
                                                    phi_1922_ = _e1318.y;
                                                } else {
                                                    phi_1922_ = _e1320.y;
                                                }
                                                let _e1334 = phi_1922_;
                                                if (_e1318.z < _e1320.z) {
                                                    phi_1931_ = _e1318.z;
                                                } else {
                                                    phi_1931_ = _e1320.z;
                                                }
                                                let _e1341 = phi_1931_;
                                                let _e1343 = triangles.member[(0u + _e1020)].v2_;
                                                if (_e1327 < _e1343.x) {
                                                    phi_1940_ = _e1327;
                                                } else {
                                                    phi_1940_ = _e1343.x;
                                                }
                                                let _e1348 = phi_1940_;
                                                if (_e1334 < _e1343.y) {
                                                    phi_1947_ = _e1334;
                                                } else {
                                                    phi_1947_ = _e1343.y;
                                                }
                                                let _e1353 = phi_1947_;
                                                if (_e1341 < _e1343.z) {
                                                    phi_1954_ = _e1341;
                                                } else {
                                                    phi_1954_ = _e1343.z;
                                                }
                                                let _e1358 = phi_1954_;
                                                let _e1360 = triangles.member[(0u + _e1020)].v0_;
                                                let _e1362 = triangles.member[(0u + _e1020)].v1_;
                                                if (_e1360.x > _e1362.x) {
                                                    phi_1967_ = _e1360.x;
                                                } else {
                                                    phi_1967_ = _e1362.x;
                                                }
                                                let _e1369 = phi_1967_;
                                                if (_e1360.y > _e1362.y) {
                                                    phi_1976_ = _e1360.y;
                                                } else {
                                                    phi_1976_ = _e1362.y;
                                                }
                                                let _e1376 = phi_1976_;
                                                if (_e1360.z > _e1362.z) {
                                                    phi_1985_ = _e1360.z;
                                                } else {
                                                    phi_1985_ = _e1362.z;
                                                }
                                                let _e1383 = phi_1985_;
                                                let _e1385 = triangles.member[(0u + _e1020)].v2_;
                                                if (_e1369 > _e1385.x) {
                                                    phi_1994_ = _e1369;
                                                } else {
                                                    phi_1994_ = _e1385.x;
                                                }
                                                let _e1390 = phi_1994_;
                                                if (_e1376 > _e1385.y) {
                                                    phi_2001_ = _e1376;
                                                } else {
                                                    phi_2001_ = _e1385.y;
                                                }
                                                let _e1395 = phi_2001_;
                                                if (_e1383 > _e1385.z) {
                                                    phi_2008_ = _e1383;
                                                } else {
                                                    phi_2008_ = _e1385.z;
                                                }
                                                let _e1400 = phi_2008_;
                                                let _e1407 = ((_e1348 - _e151.origin.x) * _e305);
                                                let _e1408 = ((_e1353 - _e151.origin.y) * _e317);
                                                let _e1409 = ((_e1358 - _e151.origin.z) * _e329);
                                                let _e1416 = ((_e1390 - _e151.origin.x) * _e305);
                                                let _e1417 = ((_e1395 - _e151.origin.y) * _e317);
                                                let _e1418 = ((_e1400 - _e151.origin.z) * _e329);
                                                if (_e1407 < _e1416) {
                                                    phi_2031_ = _e1407;
                                                } else {
                                                    phi_2031_ = _e1416;
                                                }
                                                let _e1421 = phi_2031_;
                                                if (_e1408 < _e1417) {
                                                    phi_2036_ = _e1408;
                                                } else {
                                                    phi_2036_ = _e1417;
                                                }
                                                let _e1424 = phi_2036_;
                                                if (_e1409 < _e1418) {
                                                    phi_2041_ = _e1409;
                                                } else {
                                                    phi_2041_ = _e1418;
                                                }
                                                let _e1427 = phi_2041_;
                                                if (_e1407 > _e1416) {
                                                    phi_2049_ = _e1407;
                                                } else {
                                                    phi_2049_ = _e1416;
                                                }
                                                let _e1433 = phi_2049_;
                                                if (_e1408 > _e1417) {
                                                    phi_2054_ = _e1408;
                                                } else {
                                                    phi_2054_ = _e1417;
                                                }
                                                let _e1436 = phi_2054_;
                                                if (_e1409 > _e1418) {
                                                    phi_2059_ = _e1409;
                                                } else {
                                                    phi_2059_ = _e1418;
                                                }
                                                let _e1439 = phi_2059_;
                                                let _e1443 = core_intrinsics_maximum_number_nsz_f32_((_e1421 - _e373), (_e1424 - _e374));
                                                let _e1444 = core_intrinsics_maximum_number_nsz_f32_(_e1443, (_e1427 - _e375));
                                                let _e1445 = core_intrinsics_minimum_number_nsz_f32_((_e1433 + _e373), (_e1436 + _e374));
                                                let _e1446 = core_intrinsics_minimum_number_nsz_f32_(_e1445, (_e1439 + _e375));
                                                if (_e1444 > -300000000000000000000000000000000000000f) {
                                                    phi_2071_ = _e1444;
                                                } else {
                                                    phi_2071_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1449 = phi_2071_;
                                                if (_e1446 < 300000000000000000000000000000000000000f) {
                                                    phi_2076_ = _e1446;
                                                } else {
                                                    phi_2076_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1452 = phi_2076_;
                                                if (_e1312 < _e1449) {
                                                    phi_2081_ = _e1449;
                                                } else {
                                                    phi_2081_ = _e1312;
                                                }
                                                let _e1455 = phi_2081_;
                                                if (_e1455 > _e1452) {
                                                    phi_2086_ = _e1452;
                                                } else {
                                                    phi_2086_ = _e1455;
                                                }
                                                let _e1458 = phi_2086_;
                                                phi_2091_ = lt_bvh_triangle_Intersection(_e1458, (_e1151 / _e1210), (_e1172 / _e1210), (_e1449 <= _e1452));
                                                phi_2092_ = false;
                                            } else {
                                                phi_2091_ = lt_bvh_triangle_Intersection();
                                                phi_2092_ = true;
                                            }
                                            let _e1464 = phi_2091_;
                                            let _e1466 = phi_2092_;
                                            phi_2093_ = _e1464;
                                            phi_2094_ = _e1466;
                                        } else {
                                            phi_2093_ = lt_bvh_triangle_Intersection();
                                            phi_2094_ = true;
                                        }
                                        let _e1468 = phi_2093_;
                                        let _e1470 = phi_2094_;
                                        if _e1470 {
                                        }
                                        phi_2098_ = _e1468;
                                        phi_2099_ = _e1470;
                                    }
                                    let _e1472 = phi_2098_;
                                    let _e1474 = phi_2099_;
                                    phi_2100_ = _e1472;
                                    phi_2101_ = _e1213;
                                    phi_2102_ = _e1474;
                                } else {
                                    phi_2100_ = lt_bvh_triangle_Intersection();
                                    phi_2101_ = true;
                                    phi_2102_ = false;
                                }
                                let _e1476 = phi_2100_;
                                let _e1478 = phi_2101_;
                                let _e1480 = phi_2102_;
                                if _e1478 {
                                    phi_2106_ = true;
                                } else {
                                    phi_2106_ = _e1480;
                                }
                                let _e1482 = phi_2106_;
                                if _e1482 {
                                    phi_2110_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_2110_ = _e1476;
                                }
                                let _e1484 = phi_2110_;
                                if _e1484.is_hit {
                                    if (_e1484.t > _e151.tmin) {
                                        if (_e1484.t < _e1009.t) {
                                            phi_2159_ = true;
                                        } else {
                                            if (_e1484.t == _e1009.t) {
                                                if (_e1009.triangle != 4294967295u) {
                                                    if (_e1020 < _e1009.triangle) {
                                                        phi_2150_ = true;
                                                    } else {
                                                        if (_e1020 == _e1009.triangle) {
                                                            phi_2149_ = (4294967295u < _e1009.instance);
                                                        } else {
                                                            phi_2149_ = false;
                                                        }
                                                        let _e1503 = phi_2149_;
                                                        phi_2150_ = _e1503;
                                                    }
                                                    let _e1505 = phi_2150_;
                                                    phi_2151_ = _e1505;
                                                    phi_2152_ = false;
                                                } else {
                                                    phi_2151_ = bool();
                                                    phi_2152_ = true;
                                                }
                                                let _e1507 = phi_2151_;
                                                let _e1509 = phi_2152_;
                                                phi_2153_ = _e1507;
                                                phi_2154_ = _e1509;
                                            } else {
                                                phi_2153_ = bool();
                                                phi_2154_ = true;
                                            }
                                            let _e1511 = phi_2153_;
                                            let _e1513 = phi_2154_;
                                            if _e1513 {
                                                phi_2158_ = false;
                                            } else {
                                                phi_2158_ = _e1511;
                                            }
                                            let _e1515 = phi_2158_;
                                            phi_2159_ = _e1515;
                                        }
                                        let _e1517 = phi_2159_;
                                        if _e1517 {
                                            let _e1519 = triangles.member[(0u + _e1020)].i0_;
                                            if ((_e1519 & 2147483648u) == 0u) {
                                                phi_2370_ = true;
                                            } else {
                                                if (_e1020 < _e78) {
                                                } else {
                                                    return;
                                                }
                                                let _e1528 = triangles.member[(0u + _e1020)].i0_;
                                                let _e1529 = (_e1528 & 2147483647u);
                                                let _e1531 = triangles.member[(0u + _e1020)].i1_;
                                                let _e1533 = triangles.member[(0u + _e1020)].i2_;
                                                if (_e1529 < _e81) {
                                                } else {
                                                    return;
                                                }
                                                let _e1537 = vertices.member[(0u + _e1529)];
                                                if (_e1531 < _e81) {
                                                } else {
                                                    return;
                                                }
                                                let _e1541 = vertices.member[(0u + _e1531)];
                                                if (_e1533 < _e81) {
                                                } else {
                                                    return;
                                                }
                                                let _e1545 = vertices.member[(0u + _e1533)];
                                                let _e1546 = array<abi_Vertex, 3>(_e1537, _e1541, _e1545);
                                                if (_e1546[0].material < _e84) {
                                                } else {
                                                    return;
                                                }
                                                let _e1552 = materials.member[(0u + _e1546[0].material)];
                                                if ((_e1552.flags & 0u) == 0u) {
                                                    let _e1557 = ((1f - _e1484.u) - _e1484.v);
                                                    if (_e1552.cutoff <= 0f) {
                                                        phi_2365_ = true;
                                                    } else {
                                                        let _e1584 = (_e1552.base_color.w * ((((f32((_e1546[0].color >> bitcast<u32>(24i))) * _e1557) + (f32((_e1546[1].color >> bitcast<u32>(24i))) * _e1484.u)) + (f32((_e1546[2].color >> bitcast<u32>(24i))) * _e1484.v)) * (1f / 255f)));
                                                        if (_e1552.alpha_size == 0u) {
                                                            phi_2362_ = _e1584;
                                                        } else {
                                                            local.offset = _e1552.alpha_offset;
                                                            local.size = _e1552.alpha_size;
                                                            local.flags = _e1552.flags;
                                                            let _e1615 = _lt_shaders_texture_TextureView_quad((&local), (((_e1546[0].u * _e1557) + (_e1546[1].u * _e1484.u)) + (_e1546[2].u * _e1484.v)), (((_e1546[0].v * _e1557) + (_e1546[1].v * _e1484.u)) + (_e1546[2].v * _e1484.v)));
                                                            let _e1619 = (_e1615.indices[0] >> bitcast<u32>(2i));
                                                            if (_e1619 < _e90) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1623 = alpha_texels.member[(0u + _e1619)];
                                                            let _e1639 = (_e1615.indices[1] >> bitcast<u32>(2i));
                                                            if (_e1639 < _e90) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1643 = alpha_texels.member[(0u + _e1639)];
                                                            let _e1660 = (_e1615.indices[2] >> bitcast<u32>(2i));
                                                            if (_e1660 < _e90) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1664 = alpha_texels.member[(0u + _e1660)];
                                                            let _e1681 = (_e1615.indices[3] >> bitcast<u32>(2i));
                                                            if (_e1681 < _e90) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1685 = alpha_texels.member[(0u + _e1681)];
                                                            phi_2362_ = (_e1584 * (((((f32(((_e1623 >> bitcast<u32>((((_e1615.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1615.weights.x) + ((f32(((_e1643 >> bitcast<u32>((((_e1615.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1615.weights.y)) + ((f32(((_e1664 >> bitcast<u32>((((_e1615.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1615.weights.z)) + ((f32(((_e1685 >> bitcast<u32>((((_e1615.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1615.weights.w)));
                                                        }
                                                        let _e1701 = phi_2362_;
                                                        phi_2365_ = (_e1701 >= _e1552.cutoff);
                                                    }
                                                    let _e1705 = phi_2365_;
                                                    phi_2366_ = _e1705;
                                                } else {
                                                    phi_2366_ = false;
                                                }
                                                let _e1707 = phi_2366_;
                                                if _e1707 {
                                                }
                                                phi_2370_ = _e1707;
                                            }
                                            let _e1709 = phi_2370_;
                                            if _e1709 {
                                                phi_2378_ = lt_bvh_Hit(_e1484.t, _e1484.u, _e1484.v, _e1020, 4294967295u);
                                            } else {
                                                phi_2378_ = _e1009;
                                            }
                                            let _e1715 = phi_2378_;
                                            phi_2379_ = _e1715;
                                        } else {
                                            phi_2379_ = _e1009;
                                        }
                                        let _e1717 = phi_2379_;
                                        phi_2380_ = _e1717;
                                    } else {
                                        phi_2380_ = _e1009;
                                    }
                                    let _e1719 = phi_2380_;
                                    phi_2381_ = _e1719;
                                } else {
                                    phi_2381_ = _e1009;
                                }
                                let _e1721 = phi_2381_;
                                phi_1524_ = _e1721;
                                phi_1527_ = (_e1011 & (_e1011 - 1u));
                                phi_2382_ = true;
                            }
                            let _e1723 = phi_1524_;
                            let _e1725 = phi_1527_;
                            let _e1727 = phi_2382_;
                            continue;
                            continuing {
                                phi_1523_ = _e1723;
                                phi_1526_ = _e1725;
                                break if !(_e1727);
                            }
                        }
                        let _e1730 = local_1.group_mask;
                        if ((_e1730 & 4278190080u) == 0u) {
                            let _e1734 = local_1.len;
                            if (_e1734 == 0u) {
                                phi_2421_ = false;
                            } else {
                                let _e1738 = local_1.len;
                                local_1.len = (_e1738 - 1u);
                                let _e1741 = local_1.len;
                                if (_e1741 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1746 = local_1.first[(0u + _e1741)];
                                local_1.group = _e1746;
                                let _e1749 = local_1.len;
                                if (_e1749 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1754 = local_1.mask[(0u + _e1749)];
                                local_1.group_mask = _e1754;
                                phi_2421_ = true;
                            }
                            let _e1757 = phi_2421_;
                            phi_2422_ = _e1757;
                        } else {
                            phi_2422_ = true;
                        }
                        let _e1759 = phi_2422_;
                        if _e1759 {
                            let _e1761 = local_1.group_mask;
                            let _e1767 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1761)), 32u, (_e1761 == 0u)));
                            let _e1771 = local_1.group_mask;
                            let _e1785 = local_1.group_mask;
                            local_1.group_mask = (_e1785 & ~((1u << bitcast<u32>((_e1767 & 31u)))));
                            let _e1788 = local_1.group;
                            phi_2453_ = (_e1788 + countOneBits(((_e1771 & ~((4294967295u << bitcast<u32>((((_e1767 - 24u) ^ _e428) & 31u))))) & 255u)));
                        } else {
                            phi_2453_ = 4294967295u;
                        }
                        let _e1791 = phi_2453_;
                        let _e2494 = local_5;
                        phi_1187_ = _e2494;
                        phi_1190_ = _e1791;
                    } else {
                        phi_1187_ = lt_bvh_Hit();
                        phi_1190_ = u32();
                    }
                    let _e1793 = phi_1187_;
                    let _e1795 = phi_1190_;
                    continue;
                    continuing {
                        phi_1186_ = _e1793;
                        phi_1189_ = _e1795;
                        break if !(_e569);
                    }
                }
                let _e2498 = local_6;
                phi_2454_ = _e2498;
            }
            let _e1798 = phi_2454_;
            phi_2455_ = _e1798;
            phi_2456_ = _e223;
        } else {
            phi_2455_ = lt_bvh_Hit();
            phi_2456_ = true;
        }
        let _e1800 = phi_2455_;
        let _e1802 = phi_2456_;
        if _e1802 {
            phi_2460_ = _e153;
        } else {
            phi_2460_ = _e1800;
        }
        let _e1804 = phi_2460_;
        if (_e1804.triangle != 4294967295u) {
            let _e1810 = ((1f - _e1804.u) - _e1804.v);
            if (_e1804.triangle < _e78) {
            } else {
                return;
            }
            let _e1816 = triangles.member[(0u + _e1804.triangle)];
            let _e1841 = (((_e1816.v0_.x * _e1810) + (_e1816.v1_.x * _e1804.u)) + (_e1816.v2_.x * _e1804.v));
            let _e1842 = (((_e1816.v0_.y * _e1810) + (_e1816.v1_.y * _e1804.u)) + (_e1816.v2_.y * _e1804.v));
            let _e1843 = (((_e1816.v0_.z * _e1810) + (_e1816.v1_.z * _e1804.u)) + (_e1816.v2_.z * _e1804.v));
            let _e1846 = abs(_e1816.v0_.x);
            let _e1848 = abs(_e1816.v0_.y);
            let _e1850 = abs(_e1816.v0_.z);
            let _e1852 = abs(_e1816.v1_.x);
            let _e1854 = abs(_e1816.v1_.y);
            let _e1856 = abs(_e1816.v1_.z);
            if (_e1846 > _e1852) {
                phi_2525_ = _e1846;
            } else {
                phi_2525_ = _e1852;
            }
            let _e1859 = phi_2525_;
            if (_e1848 > _e1854) {
                phi_2530_ = _e1848;
            } else {
                phi_2530_ = _e1854;
            }
            let _e1862 = phi_2530_;
            if (_e1850 > _e1856) {
                phi_2535_ = _e1850;
            } else {
                phi_2535_ = _e1856;
            }
            let _e1865 = phi_2535_;
            let _e1867 = abs(_e1816.v2_.x);
            let _e1869 = abs(_e1816.v2_.y);
            let _e1871 = abs(_e1816.v2_.z);
            if (_e1859 > _e1867) {
                phi_2546_ = _e1859;
            } else {
                phi_2546_ = _e1867;
            }
            let _e1874 = phi_2546_;
            if (_e1862 > _e1869) {
                phi_2551_ = _e1862;
            } else {
                phi_2551_ = _e1869;
            }
            let _e1877 = phi_2551_;
            if (_e1865 > _e1871) {
                phi_2556_ = _e1865;
            } else {
                phi_2556_ = _e1871;
            }
            let _e1880 = phi_2556_;
            let _e1883 = (_e1816.v1_.x - _e1816.v0_.x);
            let _e1886 = (_e1816.v1_.y - _e1816.v0_.y);
            let _e1889 = (_e1816.v1_.z - _e1816.v0_.z);
            let _e1892 = (_e1816.v2_.x - _e1816.v0_.x);
            let _e1895 = (_e1816.v2_.y - _e1816.v0_.y);
            let _e1898 = (_e1816.v2_.z - _e1816.v0_.z);
            let _e1902 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1886), abs(_e1889));
            let _e1903 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1883), _e1902);
            let _e1904 = (_e1883 / _e1903);
            let _e1905 = (_e1886 / _e1903);
            let _e1906 = (_e1889 / _e1903);
            let _e1910 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1895), abs(_e1898));
            let _e1911 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1892), _e1910);
            let _e1912 = (_e1892 / _e1911);
            let _e1913 = (_e1895 / _e1911);
            let _e1914 = (_e1898 / _e1911);
            let _e1917 = ((_e1905 * _e1914) - (_e1913 * _e1906));
            let _e1920 = ((_e1906 * _e1912) - (_e1914 * _e1904));
            let _e1923 = ((_e1904 * _e1913) - (_e1912 * _e1905));
            let _e1925 = p.member.eye;
            let _e1938 = (1f / sqrt((((_e1917 * _e1917) + (_e1920 * _e1920)) + (_e1923 * _e1923))));
            let _e1939 = (_e1917 * _e1938);
            let _e1940 = (_e1920 * _e1938);
            let _e1941 = (_e1923 * _e1938);
            if ((((_e1939 * (_e1925.x - _e1841)) + (_e1940 * (_e1925.y - _e1842))) + (_e1941 * (_e1925.z - _e1843))) < 0f) {
                phi_2632_ = vec3<f32>(-(_e1939), -(_e1940), -(_e1941));
            } else {
                phi_2632_ = vec3<f32>(_e1939, _e1940, _e1941);
            }
            let _e1954 = phi_2632_;
            if (_e1804.triangle < _e78) {
            } else {
                return;
            }
            let _e1959 = triangles.member[(0u + _e1804.triangle)];
            let _e1961 = (_e1959.i0_ & 2147483647u);
            if (_e1961 < _e81) {
            } else {
                return;
            }
            let _e1967 = vertices.member[(0u + _e1961)];
            if (_e1959.i1_ < _e81) {
            } else {
                return;
            }
            let _e1971 = vertices.member[(0u + _e1959.i1_)];
            if (_e1959.i2_ < _e81) {
            } else {
                return;
            }
            let _e1975 = vertices.member[(0u + _e1959.i2_)];
            let _e1976 = array<abi_Vertex, 3>(_e1967, _e1971, _e1975);
            if (_e1976[0].material < _e84) {
            } else {
                return;
            }
            let _e1982 = materials.member[(0u + _e1976[0].material)];
            let _e1999 = (1f / 255f);
            let _e2018 = (1f / 255f);
            let _e2040 = (1f / 255f);
            let _e2053 = _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(vec3<f32>(_e1810, _e1804.u, _e1804.v));
            let _e2055 = ((_e1982.base_color.x * ((((f32((_e1976[0].color & 255u)) * _e1999) * _e1810) + ((f32((_e1976[1].color & 255u)) * _e2018) * _e1804.u)) + ((f32((_e1976[2].color & 255u)) * _e2040) * _e1804.v))) * _e2053.x);
            let _e2057 = ((_e1982.base_color.y * ((((f32(((_e1976[0].color >> bitcast<u32>(8i)) & 255u)) * _e1999) * _e1810) + ((f32(((_e1976[1].color >> bitcast<u32>(8i)) & 255u)) * _e2018) * _e1804.u)) + ((f32(((_e1976[2].color >> bitcast<u32>(8i)) & 255u)) * _e2040) * _e1804.v))) * _e2053.y);
            let _e2059 = ((_e1982.base_color.z * ((((f32(((_e1976[0].color >> bitcast<u32>(16i)) & 255u)) * _e1999) * _e1810) + ((f32(((_e1976[1].color >> bitcast<u32>(16i)) & 255u)) * _e2018) * _e1804.u)) + ((f32(((_e1976[2].color >> bitcast<u32>(16i)) & 255u)) * _e2040) * _e1804.v))) * _e2053.z);
            let _e2060 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1877, _e1880);
            let _e2061 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1874, _e2060);
            if ((_e1982.flags & 2u) == 0u) {
                phi_2753_ = 0u;
            } else {
                phi_2753_ = 1u;
            }
            let _e2066 = phi_2753_;
            if (_e1976[0].normal == 2147516416u) {
                phi_2956_ = _e1954;
            } else {
                let _e2079 = (f32((bitcast<i32>((_e1976[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2085 = (f32((bitcast<i32>(_e1976[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2089 = ((1f - abs(_e2079)) - abs(_e2085));
                if (_e2089 < 0f) {
                    phi_2780_ = -(_e2089);
                } else {
                    phi_2780_ = 0f;
                }
                let _e2093 = phi_2780_;
                if (_e2079 < 0f) {
                    phi_2787_ = (_e2079 + _e2093);
                } else {
                    phi_2787_ = (_e2079 - _e2093);
                }
                let _e2098 = phi_2787_;
                if (_e2085 < 0f) {
                    phi_2794_ = (_e2085 + _e2093);
                } else {
                    phi_2794_ = (_e2085 - _e2093);
                }
                let _e2103 = phi_2794_;
                let _e2110 = (1f / sqrt((((_e2098 * _e2098) + (_e2103 * _e2103)) + (_e2089 * _e2089))));
                let _e2126 = (f32((bitcast<i32>((_e1976[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2132 = (f32((bitcast<i32>(_e1976[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2136 = ((1f - abs(_e2126)) - abs(_e2132));
                if (_e2136 < 0f) {
                    phi_2829_ = -(_e2136);
                } else {
                    phi_2829_ = 0f;
                }
                let _e2140 = phi_2829_;
                if (_e2126 < 0f) {
                    phi_2836_ = (_e2126 + _e2140);
                } else {
                    phi_2836_ = (_e2126 - _e2140);
                }
                let _e2145 = phi_2836_;
                if (_e2132 < 0f) {
                    phi_2843_ = (_e2132 + _e2140);
                } else {
                    phi_2843_ = (_e2132 - _e2140);
                }
                let _e2150 = phi_2843_;
                let _e2157 = (1f / sqrt((((_e2145 * _e2145) + (_e2150 * _e2150)) + (_e2136 * _e2136))));
                let _e2176 = (f32((bitcast<i32>((_e1976[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2182 = (f32((bitcast<i32>(_e1976[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2186 = ((1f - abs(_e2176)) - abs(_e2182));
                if (_e2186 < 0f) {
                    phi_2881_ = -(_e2186);
                } else {
                    phi_2881_ = 0f;
                }
                let _e2190 = phi_2881_;
                if (_e2176 < 0f) {
                    phi_2888_ = (_e2176 + _e2190);
                } else {
                    phi_2888_ = (_e2176 - _e2190);
                }
                let _e2195 = phi_2888_;
                if (_e2182 < 0f) {
                    phi_2895_ = (_e2182 + _e2190);
                } else {
                    phi_2895_ = (_e2182 - _e2190);
                }
                let _e2200 = phi_2895_;
                let _e2207 = (1f / sqrt((((_e2195 * _e2195) + (_e2200 * _e2200)) + (_e2186 * _e2186))));
                let _e2218 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(vec3<f32>(((((_e2098 * _e2110) * _e1810) + ((_e2145 * _e2157) * _e1804.u)) + ((_e2195 * _e2207) * _e1804.v)), ((((_e2103 * _e2110) * _e1810) + ((_e2150 * _e2157) * _e1804.u)) + ((_e2200 * _e2207) * _e1804.v)), ((((_e2089 * _e2110) * _e1810) + ((_e2136 * _e2157) * _e1804.u)) + ((_e2186 * _e2207) * _e1804.v))));
                let _e2230 = sqrt((((_e2218.x * _e2218.x) + (_e2218.y * _e2218.y)) + (_e2218.z * _e2218.z)));
                if (_e2230 > 0f) {
                    let _e2233 = (_e2218.x / _e2230);
                    let _e2235 = (_e2218.y / _e2230);
                    let _e2237 = (_e2218.z / _e2230);
                    if ((((_e2233 * _e1954.x) + (_e2235 * _e1954.y)) + (_e2237 * _e1954.z)) < 0f) {
                        phi_2954_ = vec3<f32>(-(_e2233), -(_e2235), -(_e2237));
                    } else {
                        phi_2954_ = (_e2218 / vec3(_e2230));
                    }
                    let _e2254 = phi_2954_;
                    phi_2955_ = _e2254;
                } else {
                    phi_2955_ = _e1954;
                }
                let _e2256 = phi_2955_;
                phi_2956_ = _e2256;
            }
            let _e2258 = phi_2956_;
            if (_e2055 > 0f) {
                if (_e2055 < 1f) {
                    phi_2965_ = _e2055;
                } else {
                    phi_2965_ = 1f;
                }
                let _e2262 = phi_2965_;
                phi_2966_ = _e2262;
            } else {
                phi_2966_ = 0f;
            }
            let _e2264 = phi_2966_;
            if (_e2057 > 0f) {
                if (_e2057 < 1f) {
                    phi_2976_ = _e2057;
                } else {
                    phi_2976_ = 1f;
                }
                let _e2269 = phi_2976_;
                phi_2977_ = _e2269;
            } else {
                phi_2977_ = 0f;
            }
            let _e2271 = phi_2977_;
            if (_e2059 > 0f) {
                if (_e2059 < 1f) {
                    phi_2987_ = _e2059;
                } else {
                    phi_2987_ = 1f;
                }
                let _e2276 = phi_2987_;
                phi_2988_ = _e2276;
            } else {
                phi_2988_ = 0f;
            }
            let _e2278 = phi_2988_;
            let _e2281 = ((sqrt(_e2264) * 255f) + 0.5f);
            let _e2290 = ((sqrt(_e2271) * 255f) + 0.5f);
            let _e2302 = ((sqrt(_e2278) * 255f) + 0.5f);
            phi_3023_ = abi_Sample(vec3<f32>(_e1841, _e1842, _e1843), _e2061, _e1954, _e2066, _e2258, ((select(select(u32(_e2281), 0u, (_e2281 < bitcast<f32>(0u))), 4294967295u, (_e2281 > bitcast<f32>(1333788671u))) | (select(select(u32(_e2290), 0u, (_e2290 < bitcast<f32>(0u))), 4294967295u, (_e2290 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e2302), 0u, (_e2302 < bitcast<f32>(0u))), 4294967295u, (_e2302 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_3023_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e2316 = phi_3023_;
        if (_e96.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e96.shift)] = _e2316;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
