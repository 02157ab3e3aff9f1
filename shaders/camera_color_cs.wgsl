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
var<storage> color_texels: type_13;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_mask_LightPlace {
    var phi_205_: lt_mask_LightPlace;
    var phi_206_: bool;
    var phi_207_: lt_mask_LightPlace;
    var phi_208_: bool;
    var phi_213_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_205_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_206_ = false;
        } else {
            phi_205_ = lt_mask_LightPlace();
            phi_206_ = true;
        }
        let _e81 = phi_205_;
        let _e83 = phi_206_;
        phi_207_ = _e81;
        phi_208_ = _e83;
    } else {
        phi_207_ = lt_mask_LightPlace();
        phi_208_ = true;
    }
    let _e85 = phi_207_;
    let _e87 = phi_208_;
    if _e87 {
        phi_213_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_213_ = _e85;
    }
    let _e92 = phi_213_;
    return lt_mask_LightPlace(_e92.word, _e92.shift);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_228_: bool;
    var phi_232_: f32;

    if (param_3 != param_3) {
        phi_228_ = true;
    } else {
        let _e71 = (param_4 >= param_3);
        if _e71 {
        }
        phi_228_ = _e71;
    }
    let _e73 = phi_228_;
    if _e73 {
        phi_232_ = param_4;
    } else {
        phi_232_ = param_3;
    }
    let _e75 = phi_232_;
    return _e75;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_244_: bool;
    var phi_248_: f32;

    if (param_5 != param_5) {
        phi_244_ = true;
    } else {
        let _e71 = (param_6 <= param_5);
        if _e71 {
        }
        phi_244_ = _e71;
    }
    let _e73 = phi_244_;
    if _e73 {
        phi_248_ = param_6;
    } else {
        phi_248_ = param_5;
    }
    let _e75 = phi_248_;
    return _e75;
}

fn _lt_shaders_texture_TextureView_quad(param_7: ptr<function, texture_TextureView>, param_8: f32, param_9: f32) -> texture_TexelQuad {
    var phi_290_: f32;
    var phi_295_: f32;
    var phi_296_: bool;
    var phi_297_: f32;
    var phi_298_: bool;
    var phi_302_: f32;
    var phi_328_: f32;
    var phi_333_: f32;
    var phi_334_: bool;
    var phi_335_: f32;
    var phi_336_: bool;
    var phi_340_: f32;
    var phi_348_: f32;
    var phi_349_: f32;
    var phi_350_: f32;
    var phi_359_: f32;
    var phi_360_: f32;
    var phi_378_: u32;
    var phi_392_: u32;
    var phi_399_: u32;
    var phi_404_: u32;
    var phi_410_: u32;
    var phi_415_: u32;
    var phi_417_: texture_Axis;
    var phi_445_: f32;
    var phi_450_: f32;
    var phi_451_: bool;
    var phi_452_: f32;
    var phi_453_: bool;
    var phi_457_: f32;
    var phi_483_: f32;
    var phi_488_: f32;
    var phi_489_: bool;
    var phi_490_: f32;
    var phi_491_: bool;
    var phi_495_: f32;
    var phi_503_: f32;
    var phi_504_: f32;
    var phi_505_: f32;
    var phi_514_: f32;
    var phi_515_: f32;
    var phi_533_: u32;
    var phi_547_: u32;
    var phi_554_: u32;
    var phi_559_: u32;
    var phi_565_: u32;
    var phi_570_: u32;
    var phi_572_: texture_Axis;

    let _e72 = (*param_7).size;
    let _e73 = (_e72 & 65535u);
    let _e75 = (*param_7).size;
    let _e77 = (_e75 >> bitcast<u32>(16i));
    let _e79 = (*param_7).flags;
    let _e81 = ((_e79 & 4u) != 0u);
    let _e83 = (*param_7).flags;
    let _e86 = ((_e83 >> bitcast<u32>(4u)) & 3u);
    if (_e86 == 0u) {
        if (param_8 > -8388608f) {
            let _e99 = f32(select(0i, select(select(i32(param_8), i32(-2147483648), (param_8 < bitcast<f32>(3472883712u))), 2147483647i, (param_8 > bitcast<f32>(1325400063u))), (param_8 == param_8)));
            if (_e99 > param_8) {
                phi_290_ = 1f;
            } else {
                phi_290_ = 0f;
            }
            let _e102 = phi_290_;
            if (param_8 < 8388608f) {
                phi_295_ = (_e99 - _e102);
                phi_296_ = false;
            } else {
                phi_295_ = f32();
                phi_296_ = true;
            }
            let _e105 = phi_295_;
            let _e107 = phi_296_;
            phi_297_ = _e105;
            phi_298_ = _e107;
        } else {
            phi_297_ = f32();
            phi_298_ = true;
        }
        let _e109 = phi_297_;
        let _e111 = phi_298_;
        if _e111 {
            phi_302_ = param_8;
        } else {
            phi_302_ = _e109;
        }
        let _e113 = phi_302_;
        phi_350_ = (param_8 - _e113);
    } else {
        if (_e86 == 1u) {
            let _e116 = (param_8 * 0.5f);
            if (_e116 > -8388608f) {
                let _e128 = f32(select(0i, select(select(i32(_e116), i32(-2147483648), (_e116 < bitcast<f32>(3472883712u))), 2147483647i, (_e116 > bitcast<f32>(1325400063u))), (_e116 == _e116)));
                if (_e128 > _e116) {
                    phi_328_ = 1f;
                } else {
                    phi_328_ = 0f;
                }
                let _e131 = phi_328_;
                if (_e116 < 8388608f) {
                    phi_333_ = (_e128 - _e131);
                    phi_334_ = false;
                } else {
                    phi_333_ = f32();
                    phi_334_ = true;
                }
                let _e134 = phi_333_;
                let _e136 = phi_334_;
                phi_335_ = _e134;
                phi_336_ = _e136;
            } else {
                phi_335_ = f32();
                phi_336_ = true;
            }
            let _e138 = phi_335_;
            let _e140 = phi_336_;
            if _e140 {
                phi_340_ = _e116;
            } else {
                phi_340_ = _e138;
            }
            let _e142 = phi_340_;
            let _e144 = (param_8 - (2f * _e142));
            if (_e144 > 1f) {
                phi_348_ = (2f - _e144);
            } else {
                phi_348_ = _e144;
            }
            let _e148 = phi_348_;
            phi_349_ = _e148;
        } else {
            phi_349_ = param_8;
        }
        let _e150 = phi_349_;
        phi_350_ = _e150;
    }
    let _e152 = phi_350_;
    if (_e152 > 0f) {
        if (_e152 < 1f) {
            phi_359_ = _e152;
        } else {
            phi_359_ = 1f;
        }
        let _e156 = phi_359_;
        phi_360_ = _e156;
    } else {
        phi_360_ = 0f;
    }
    let _e158 = phi_360_;
    let _e159 = (_e73 - 1u);
    let _e161 = (_e158 * f32(_e73));
    if _e81 {
        let _e168 = select(select(u32(_e161), 0u, (_e161 < bitcast<f32>(0u))), 4294967295u, (_e161 > bitcast<f32>(1333788671u)));
        if (_e159 < _e168) {
            phi_378_ = _e159;
        } else {
            phi_378_ = _e168;
        }
        let _e171 = phi_378_;
        phi_417_ = texture_Axis(_e171, _e171, 0f);
    } else {
        let _e173 = (_e161 + 0.5f);
        let _e180 = select(select(u32(_e173), 0u, (_e173 < bitcast<f32>(0u))), 4294967295u, (_e173 > bitcast<f32>(1333788671u)));
        if (_e73 < _e180) {
            phi_392_ = _e73;
        } else {
            phi_392_ = _e180;
        }
        let _e183 = phi_392_;
        if (_e86 == 0u) {
            phi_399_ = _e159;
        } else {
            phi_399_ = 0u;
        }
        let _e188 = phi_399_;
        if (_e86 == 0u) {
            phi_404_ = 0u;
        } else {
            phi_404_ = _e159;
        }
        let _e191 = phi_404_;
        if (_e183 == 0u) {
            phi_410_ = _e188;
        } else {
            phi_410_ = (_e183 - 1u);
        }
        let _e195 = phi_410_;
        if (_e183 > _e159) {
            phi_415_ = _e191;
        } else {
            phi_415_ = _e183;
        }
        let _e198 = phi_415_;
        phi_417_ = texture_Axis(_e195, _e198, (_e173 - f32(_e183)));
    }
    let _e201 = phi_417_;
    let _e203 = (*param_7).flags;
    let _e206 = ((_e203 >> bitcast<u32>(6u)) & 3u);
    if (_e206 == 0u) {
        if (param_9 > -8388608f) {
            let _e219 = f32(select(0i, select(select(i32(param_9), i32(-2147483648), (param_9 < bitcast<f32>(3472883712u))), 2147483647i, (param_9 > bitcast<f32>(1325400063u))), (param_9 == param_9)));
            if (_e219 > param_9) {
                phi_445_ = 1f;
            } else {
                phi_445_ = 0f;
            }
            let _e222 = phi_445_;
            if (param_9 < 8388608f) {
                phi_450_ = (_e219 - _e222);
                phi_451_ = false;
            } else {
                phi_450_ = f32();
                phi_451_ = true;
            }
            let _e225 = phi_450_;
            let _e227 = phi_451_;
            phi_452_ = _e225;
            phi_453_ = _e227;
        } else {
            phi_452_ = f32();
            phi_453_ = true;
        }
        let _e229 = phi_452_;
        let _e231 = phi_453_;
        if _e231 {
            phi_457_ = param_9;
        } else {
            phi_457_ = _e229;
        }
        let _e233 = phi_457_;
        phi_505_ = (param_9 - _e233);
    } else {
        if (_e206 == 1u) {
            let _e236 = (param_9 * 0.5f);
            if (_e236 > -8388608f) {
                let _e248 = f32(select(0i, select(select(i32(_e236), i32(-2147483648), (_e236 < bitcast<f32>(3472883712u))), 2147483647i, (_e236 > bitcast<f32>(1325400063u))), (_e236 == _e236)));
                if (_e248 > _e236) {
                    phi_483_ = 1f;
                } else {
                    phi_483_ = 0f;
                }
                let _e251 = phi_483_;
                if (_e236 < 8388608f) {
                    phi_488_ = (_e248 - _e251);
                    phi_489_ = false;
                } else {
                    phi_488_ = f32();
                    phi_489_ = true;
                }
                let _e254 = phi_488_;
                let _e256 = phi_489_;
                phi_490_ = _e254;
                phi_491_ = _e256;
            } else {
                phi_490_ = f32();
                phi_491_ = true;
            }
            let _e258 = phi_490_;
            let _e260 = phi_491_;
            if _e260 {
                phi_495_ = _e236;
            } else {
                phi_495_ = _e258;
            }
            let _e262 = phi_495_;
            let _e264 = (param_9 - (2f * _e262));
            if (_e264 > 1f) {
                phi_503_ = (2f - _e264);
            } else {
                phi_503_ = _e264;
            }
            let _e268 = phi_503_;
            phi_504_ = _e268;
        } else {
            phi_504_ = param_9;
        }
        let _e270 = phi_504_;
        phi_505_ = _e270;
    }
    let _e272 = phi_505_;
    if (_e272 > 0f) {
        if (_e272 < 1f) {
            phi_514_ = _e272;
        } else {
            phi_514_ = 1f;
        }
        let _e276 = phi_514_;
        phi_515_ = _e276;
    } else {
        phi_515_ = 0f;
    }
    let _e278 = phi_515_;
    let _e279 = (_e77 - 1u);
    let _e281 = (_e278 * f32(_e77));
    if _e81 {
        let _e288 = select(select(u32(_e281), 0u, (_e281 < bitcast<f32>(0u))), 4294967295u, (_e281 > bitcast<f32>(1333788671u)));
        if (_e279 < _e288) {
            phi_533_ = _e279;
        } else {
            phi_533_ = _e288;
        }
        let _e291 = phi_533_;
        phi_572_ = texture_Axis(_e291, _e291, 0f);
    } else {
        let _e293 = (_e281 + 0.5f);
        let _e300 = select(select(u32(_e293), 0u, (_e293 < bitcast<f32>(0u))), 4294967295u, (_e293 > bitcast<f32>(1333788671u)));
        if (_e77 < _e300) {
            phi_547_ = _e77;
        } else {
            phi_547_ = _e300;
        }
        let _e303 = phi_547_;
        if (_e206 == 0u) {
            phi_554_ = _e279;
        } else {
            phi_554_ = 0u;
        }
        let _e308 = phi_554_;
        if (_e206 == 0u) {
            phi_559_ = 0u;
        } else {
            phi_559_ = _e279;
        }
        let _e311 = phi_559_;
        if (_e303 == 0u) {
            phi_565_ = _e308;
        } else {
            phi_565_ = (_e303 - 1u);
        }
        let _e315 = phi_565_;
        if (_e303 > _e279) {
            phi_570_ = _e311;
        } else {
            phi_570_ = _e303;
        }
        let _e318 = phi_570_;
        phi_572_ = texture_Axis(_e315, _e318, (_e293 - f32(_e303)));
    }
    let _e321 = phi_572_;
    let _e325 = (*param_7).offset;
    let _e332 = (*param_7).offset;
    let _e339 = (*param_7).offset;
    let _e346 = (*param_7).offset;
    return texture_TexelQuad(array<u32, 4>(((_e325 + (_e321.low * _e73)) + _e201.low), ((_e332 + (_e321.low * _e73)) + _e201.high), ((_e339 + (_e321.high * _e73)) + _e201.low), ((_e346 + (_e321.high * _e73)) + _e201.high)), vec4<f32>(((1f - _e201.fraction) * (1f - _e321.fraction)), (_e201.fraction * (1f - _e321.fraction)), ((1f - _e201.fraction) * _e321.fraction), (_e201.fraction * _e321.fraction)));
}

fn _lt_bvh_ray_Ray_new(param_10: vec3<f32>, param_11: vec3<f32>) -> lt_bvh_Ray {
    return lt_bvh_Ray(param_10, 0f, param_11, 300000000000000000000000000000000000000f);
}

fn _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(param_12: f32, param_13: f32) -> f32 {
    var phi_631_: f32;

    if (param_12 > param_13) {
        phi_631_ = param_12;
    } else {
        phi_631_ = param_13;
    }
    let _e72 = phi_631_;
    return _e72;
}

fn _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(param_14: vec3<f32>) -> vec3<f32> {
    return param_14;
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var phi_772_: bool;
    var phi_773_: bool;
    var phi_774_: bool;
    var phi_778_: bool;
    var phi_779_: bool;
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
    var phi_799_: bool;
    var phi_803_: bool;
    var phi_878_: f32;
    var phi_885_: f32;
    var phi_893_: f32;
    var phi_900_: f32;
    var phi_908_: f32;
    var phi_915_: f32;
    var phi_940_: f32;
    var phi_945_: f32;
    var phi_950_: f32;
    var phi_983_: bool;
    var phi_984_: bool;
    var phi_992_: u32;
    var phi_993_: u32;
    var phi_1011_: vec3<f32>;
    var phi_1012_: vec3<f32>;
    var phi_1026_: u32;
    var phi_1031_: u32;
    var phi_1036_: u32;
    var phi_1150_: bool;
    var phi_1151_: bool;
    var phi_1182_: u32;
    var phi_1184_: lt_bvh_Hit;
    var phi_1187_: u32;
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
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_1521_: lt_bvh_Hit;
    var phi_1524_: u32;
    var phi_1570_: vec3<f32>;
    var phi_1571_: vec3<f32>;
    var phi_1602_: vec3<f32>;
    var phi_1603_: vec3<f32>;
    var phi_1634_: vec3<f32>;
    var phi_1635_: vec3<f32>;
    var phi_1653_: bool;
    var phi_1654_: bool;
    var phi_1658_: f32;
    var phi_1659_: f32;
    var phi_1660_: f32;
    var phi_1661_: f32;
    var phi_1669_: f32;
    var phi_1679_: bool;
    var phi_1680_: bool;
    var phi_1684_: f32;
    var phi_1685_: f32;
    var phi_1686_: f32;
    var phi_1687_: f32;
    var phi_1695_: f32;
    var phi_1705_: bool;
    var phi_1706_: bool;
    var phi_1710_: f32;
    var phi_1711_: f32;
    var phi_1712_: f32;
    var phi_1713_: f32;
    var phi_1721_: f32;
    var phi_1736_: f32;
    var phi_1737_: bool;
    var phi_1738_: f32;
    var phi_1739_: bool;
    var phi_1740_: f32;
    var phi_1741_: bool;
    var phi_1759_: f32;
    var phi_1760_: bool;
    var phi_1761_: bool;
    var phi_1762_: f32;
    var phi_1763_: bool;
    var phi_1764_: bool;
    var phi_1768_: bool;
    var phi_1769_: f32;
    var phi_1770_: bool;
    var phi_1800_: vec3<f32>;
    var phi_1801_: vec3<f32>;
    var phi_1826_: vec3<f32>;
    var phi_1827_: vec3<f32>;
    var phi_1852_: vec3<f32>;
    var phi_1853_: vec3<f32>;
    var phi_1911_: f32;
    var phi_1920_: f32;
    var phi_1929_: f32;
    var phi_1938_: f32;
    var phi_1945_: f32;
    var phi_1952_: f32;
    var phi_1965_: f32;
    var phi_1974_: f32;
    var phi_1983_: f32;
    var phi_1992_: f32;
    var phi_1999_: f32;
    var phi_2006_: f32;
    var phi_2029_: f32;
    var phi_2034_: f32;
    var phi_2039_: f32;
    var phi_2047_: f32;
    var phi_2052_: f32;
    var phi_2057_: f32;
    var phi_2069_: f32;
    var phi_2074_: f32;
    var phi_2079_: f32;
    var phi_2084_: f32;
    var phi_2089_: lt_bvh_triangle_Intersection;
    var phi_2090_: bool;
    var phi_2091_: lt_bvh_triangle_Intersection;
    var phi_2092_: bool;
    var phi_2096_: lt_bvh_triangle_Intersection;
    var phi_2097_: bool;
    var phi_2098_: lt_bvh_triangle_Intersection;
    var phi_2099_: bool;
    var phi_2100_: bool;
    var phi_2104_: bool;
    var phi_2108_: lt_bvh_triangle_Intersection;
    var phi_2147_: bool;
    var phi_2148_: bool;
    var phi_2149_: bool;
    var phi_2150_: bool;
    var phi_2151_: bool;
    var phi_2152_: bool;
    var phi_2156_: bool;
    var phi_2157_: bool;
    var phi_2171_: bool;
    var phi_2179_: lt_bvh_Hit;
    var phi_2180_: lt_bvh_Hit;
    var phi_2181_: lt_bvh_Hit;
    var phi_2182_: lt_bvh_Hit;
    var phi_1522_: lt_bvh_Hit;
    var phi_1525_: u32;
    var phi_2183_: bool;
    var phi_2222_: bool;
    var phi_2223_: bool;
    var phi_2254_: u32;
    var phi_1185_: lt_bvh_Hit;
    var phi_1188_: u32;
    var phi_2255_: lt_bvh_Hit;
    var phi_2256_: lt_bvh_Hit;
    var phi_2257_: bool;
    var phi_2261_: lt_bvh_Hit;
    var phi_2325_: f32;
    var phi_2330_: f32;
    var phi_2335_: f32;
    var phi_2346_: f32;
    var phi_2351_: f32;
    var phi_2356_: f32;
    var phi_2432_: vec3<f32>;
    var phi_2675_: vec3<f32>;
    var phi_2690_: u32;
    var phi_2717_: f32;
    var phi_2724_: f32;
    var phi_2731_: f32;
    var phi_2766_: f32;
    var phi_2773_: f32;
    var phi_2780_: f32;
    var phi_2818_: f32;
    var phi_2825_: f32;
    var phi_2832_: f32;
    var phi_2891_: vec3<f32>;
    var phi_2892_: vec3<f32>;
    var phi_2893_: vec3<f32>;
    var phi_2902_: f32;
    var phi_2903_: f32;
    var phi_2913_: f32;
    var phi_2914_: f32;
    var phi_2924_: f32;
    var phi_2925_: f32;
    var phi_2960_: abi_Sample;
    var local_5: lt_bvh_Hit;
    var local_6: lt_bvh_Hit;

    let _e70 = id_1;
    let _e74 = arrayLength((&nodes.member));
    let _e77 = arrayLength((&triangles.member));
    let _e80 = arrayLength((&vertices.member));
    let _e89 = arrayLength((&color_texels.member));
    let _e92 = p.member.size[0u];
    let _e94 = p.member.size[1u];
    let _e95 = lt_shaders_entry_pixel_index(_e70, _e92, _e94);
    if (bitcast<i32>(_e95.word) != 0i) {
        let _e103 = p.member.eye;
        let _e108 = p.member.size[0u];
        let _e112 = ((((f32(_e70.x) + 0.5f) / f32(_e108)) * 2f) - 1f);
        let _e117 = p.member.size[1u];
        let _e121 = (1f - (((f32(_e70.y) + 0.5f) / f32(_e117)) * 2f));
        let _e123 = p.member.forward;
        let _e125 = p.member.right;
        let _e139 = p.member.up;
        let _e150 = _lt_bvh_ray_Ray_new(_e103, vec3<f32>(((_e123.x + (_e125.x * _e112)) + (_e139.x * _e121)), ((_e123.y + (_e125.y * _e112)) + (_e139.y * _e121)), ((_e123.z + (_e125.z * _e112)) + (_e139.z * _e121))));
        let _e152 = lt_bvh_Hit(_e150.tmax, 0f, 0f, 4294967295u, 4294967295u);
        let _e162 = abs(_e150.direction.x);
        let _e164 = abs(_e150.direction.y);
        let _e166 = abs(_e150.direction.z);
        if (abs(_e150.origin.x) < 1000000000000000f) {
            if (abs(_e150.origin.y) < 1000000000000000f) {
                if (abs(_e150.origin.z) < 1000000000000000f) {
                    if (_e162 < 1000000000000000f) {
                        if (_e164 < 1000000000000000f) {
                            if (_e166 < 1000000000000000f) {
                                if (_e162 > 0f) {
                                    phi_773_ = bool();
                                    phi_774_ = true;
                                } else {
                                    let _e174 = (_e164 > 0f);
                                    if _e174 {
                                        phi_772_ = bool();
                                    } else {
                                        phi_772_ = (_e166 > 0f);
                                    }
                                    let _e177 = phi_772_;
                                    phi_773_ = _e177;
                                    phi_774_ = _e174;
                                }
                                let _e179 = phi_773_;
                                let _e181 = phi_774_;
                                if _e181 {
                                    phi_778_ = true;
                                } else {
                                    phi_778_ = _e179;
                                }
                                let _e183 = phi_778_;
                                phi_779_ = _e183;
                                phi_780_ = false;
                            } else {
                                phi_779_ = bool();
                                phi_780_ = true;
                            }
                            let _e185 = phi_779_;
                            let _e187 = phi_780_;
                            phi_781_ = _e185;
                            phi_782_ = false;
                            phi_783_ = _e187;
                        } else {
                            phi_781_ = bool();
                            phi_782_ = true;
                            phi_783_ = false;
                        }
                        let _e189 = phi_781_;
                        let _e191 = phi_782_;
                        let _e193 = phi_783_;
                        phi_784_ = _e189;
                        phi_785_ = _e191;
                        phi_786_ = _e193;
                    } else {
                        phi_784_ = bool();
                        phi_785_ = true;
                        phi_786_ = false;
                    }
                    let _e195 = phi_784_;
                    let _e197 = phi_785_;
                    let _e199 = phi_786_;
                    phi_787_ = _e195;
                    phi_788_ = _e197;
                    phi_789_ = _e199;
                } else {
                    phi_787_ = bool();
                    phi_788_ = true;
                    phi_789_ = false;
                }
                let _e201 = phi_787_;
                let _e203 = phi_788_;
                let _e205 = phi_789_;
                phi_790_ = _e201;
                phi_791_ = _e203;
                phi_792_ = _e205;
            } else {
                phi_790_ = bool();
                phi_791_ = true;
                phi_792_ = false;
            }
            let _e207 = phi_790_;
            let _e209 = phi_791_;
            let _e211 = phi_792_;
            phi_793_ = _e207;
            phi_794_ = _e209;
            phi_795_ = _e211;
        } else {
            phi_793_ = bool();
            phi_794_ = true;
            phi_795_ = false;
        }
        let _e213 = phi_793_;
        let _e215 = phi_794_;
        let _e217 = phi_795_;
        if _e215 {
            phi_799_ = true;
        } else {
            phi_799_ = _e217;
        }
        let _e219 = phi_799_;
        if _e219 {
            phi_803_ = false;
        } else {
            phi_803_ = _e213;
        }
        let _e221 = phi_803_;
        if _e221 {
            let _e222 = (0u >= _e74);
            if _e222 {
                phi_2255_ = lt_bvh_Hit();
            } else {
                if (0u < _e74) {
                } else {
                    return;
                }
                let _e228 = nodes.member[(0u + 0u)].frame[0u];
                let _e232 = nodes.member[(0u + 0u)].frame[1u];
                let _e236 = nodes.member[(0u + 0u)].frame[2u];
                let _e240 = nodes.member[(0u + 0u)].frame[0u];
                let _e244 = nodes.member[(0u + 0u)].frame[1u];
                let _e248 = nodes.member[(0u + 0u)].frame[2u];
                let _e252 = nodes.member[(0u + 0u)].frame[3u];
                let _e290 = core_intrinsics_maximum_number_nsz_f32_(abs(_e150.direction.x), abs(_e150.direction.y));
                let _e291 = core_intrinsics_maximum_number_nsz_f32_(_e290, abs(_e150.direction.z));
                let _e292 = (_e291 * 0.0000000000009094947f);
                if (abs(_e150.direction.x) < _e292) {
                    phi_878_ = _e292;
                } else {
                    phi_878_ = abs(_e150.direction.x);
                }
                let _e298 = phi_878_;
                if (_e150.direction.x < 0f) {
                    phi_885_ = (-1f / _e298);
                } else {
                    phi_885_ = (1f / _e298);
                }
                let _e303 = phi_885_;
                if (abs(_e150.direction.y) < _e292) {
                    phi_893_ = _e292;
                } else {
                    phi_893_ = abs(_e150.direction.y);
                }
                let _e309 = phi_893_;
                if (_e150.direction.y < 0f) {
                    phi_900_ = (-1f / _e309);
                } else {
                    phi_900_ = (1f / _e309);
                }
                let _e314 = phi_900_;
                if (abs(_e150.direction.z) < _e292) {
                    phi_908_ = _e292;
                } else {
                    phi_908_ = abs(_e150.direction.z);
                }
                let _e320 = phi_908_;
                if (_e150.direction.z < 0f) {
                    phi_915_ = (-1f / _e320);
                } else {
                    phi_915_ = (1f / _e320);
                }
                let _e325 = phi_915_;
                let _e333 = abs((bitcast<f32>(_e228) - _e150.origin.x));
                let _e334 = abs((bitcast<f32>(_e232) - _e150.origin.y));
                let _e335 = abs((bitcast<f32>(_e236) - _e150.origin.z));
                let _e343 = abs(((bitcast<f32>(_e240) + (bitcast<f32>((((_e252 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e150.origin.x));
                let _e344 = abs(((bitcast<f32>(_e244) + (bitcast<f32>((((_e252 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e150.origin.y));
                let _e345 = abs(((bitcast<f32>(_e248) + (bitcast<f32>((((_e252 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e150.origin.z));
                if (_e333 > _e343) {
                    phi_940_ = _e333;
                } else {
                    phi_940_ = _e343;
                }
                let _e348 = phi_940_;
                if (_e334 > _e344) {
                    phi_945_ = _e334;
                } else {
                    phi_945_ = _e344;
                }
                let _e351 = phi_945_;
                if (_e335 > _e345) {
                    phi_950_ = _e335;
                } else {
                    phi_950_ = _e345;
                }
                let _e354 = phi_950_;
                let _e355 = core_intrinsics_maximum_number_nsz_f32_(_e348, _e351);
                let _e356 = core_intrinsics_maximum_number_nsz_f32_(_e355, _e354);
                let _e361 = (_e356 * 0.0000019073486f);
                let _e362 = (abs(_e303) * _e361);
                let _e363 = (abs(_e314) * _e361);
                let _e364 = (abs(_e325) * _e361);
                let _e368 = (_e356 * 0.0000009536743f);
                let _e369 = (abs(_e303) * _e368);
                let _e370 = (abs(_e314) * _e368);
                let _e371 = (abs(_e325) * _e368);
                let _e374 = abs(_e150.direction.x);
                let _e376 = abs(_e150.direction.y);
                let _e378 = abs(_e150.direction.z);
                if (_e374 >= _e376) {
                    if (_e374 >= _e378) {
                        phi_983_ = false;
                    } else {
                        phi_983_ = true;
                    }
                    let _e382 = phi_983_;
                    phi_984_ = _e382;
                } else {
                    phi_984_ = true;
                }
                let _e384 = phi_984_;
                if _e384 {
                    if (_e376 >= _e378) {
                        phi_992_ = 1u;
                    } else {
                        phi_992_ = 2u;
                    }
                    let _e387 = phi_992_;
                    phi_993_ = _e387;
                } else {
                    phi_993_ = 0u;
                }
                let _e389 = phi_993_;
                if (_e389 == 0u) {
                    phi_1012_ = vec3<f32>(_e150.direction.y, _e150.direction.z, _e150.direction.x);
                } else {
                    if (_e389 == 1u) {
                        phi_1011_ = vec3<f32>(_e150.direction.z, _e150.direction.x, _e150.direction.y);
                    } else {
                        phi_1011_ = _e150.direction;
                    }
                    let _e402 = phi_1011_;
                    phi_1012_ = _e402;
                }
                let _e404 = phi_1012_;
                let _e408 = (_e404.x / _e404.z);
                let _e411 = (_e404.y / _e404.z);
                if (_e303 < 0f) {
                    phi_1026_ = 0u;
                } else {
                    phi_1026_ = 1u;
                }
                let _e416 = phi_1026_;
                if (_e314 < 0f) {
                    phi_1031_ = 0u;
                } else {
                    phi_1031_ = 2u;
                }
                let _e419 = phi_1031_;
                if (_e325 < 0f) {
                    phi_1036_ = 0u;
                } else {
                    phi_1036_ = 4u;
                }
                let _e422 = phi_1036_;
                let _e424 = ((_e416 | _e419) | _e422);
                let _e425 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e425.first[0], _e425.first[1], _e425.first[2], _e425.first[3], _e425.first[4], _e425.first[5], _e425.first[6], _e425.first[7], _e425.first[8], _e425.first[9], _e425.first[10], _e425.first[11], _e425.first[12], _e425.first[13], _e425.first[14], _e425.first[15], _e425.first[16], _e425.first[17], _e425.first[18], _e425.first[19], _e425.first[20], _e425.first[21], _e425.first[22], _e425.first[23], _e425.first[24], _e425.first[25], _e425.first[26], _e425.first[27], _e425.first[28], _e425.first[29], _e425.first[30], _e425.first[31]), array<u32, 32>(_e425.mask[0], _e425.mask[1], _e425.mask[2], _e425.mask[3], _e425.mask[4], _e425.mask[5], _e425.mask[6], _e425.mask[7], _e425.mask[8], _e425.mask[9], _e425.mask[10], _e425.mask[11], _e425.mask[12], _e425.mask[13], _e425.mask[14], _e425.mask[15], _e425.mask[16], _e425.mask[17], _e425.mask[18], _e425.mask[19], _e425.mask[20], _e425.mask[21], _e425.mask[22], _e425.mask[23], _e425.mask[24], _e425.mask[25], _e425.mask[26], _e425.mask[27], _e425.mask[28], _e425.mask[29], _e425.mask[30], _e425.mask[31]), _e425.len, _e425.group, _e425.group_mask);
                let _e499 = local_1.group_mask;
                if ((_e499 & 4278190080u) == 0u) {
                    let _e503 = local_1.len;
                    if (_e503 == 0u) {
                        phi_1150_ = false;
                    } else {
                        let _e507 = local_1.len;
                        local_1.len = (_e507 - 1u);
                        let _e510 = local_1.len;
                        if (_e510 < 32u) {
                        } else {
                            return;
                        }
                        let _e515 = local_1.first[(0u + _e510)];
                        local_1.group = _e515;
                        let _e518 = local_1.len;
                        if (_e518 < 32u) {
                        } else {
                            return;
                        }
                        let _e523 = local_1.mask[(0u + _e518)];
                        local_1.group_mask = _e523;
                        phi_1150_ = true;
                    }
                    let _e526 = phi_1150_;
                    phi_1151_ = _e526;
                } else {
                    phi_1151_ = true;
                }
                let _e528 = phi_1151_;
                if _e528 {
                    let _e530 = local_1.group_mask;
                    let _e536 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e530)), 32u, (_e530 == 0u)));
                    let _e540 = local_1.group_mask;
                    let _e554 = local_1.group_mask;
                    local_1.group_mask = (_e554 & ~((1u << bitcast<u32>((_e536 & 31u)))));
                    let _e557 = local_1.group;
                    phi_1182_ = (_e557 + countOneBits(((_e540 & ~((4294967295u << bitcast<u32>((((_e536 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1182_ = 4294967295u;
                }
                let _e560 = phi_1182_;
                phi_1184_ = _e152;
                phi_1187_ = _e560;
                loop {
                    let _e562 = phi_1184_;
                    let _e564 = phi_1187_;
                    local_6 = _e562;
                    let _e565 = (_e564 != 4294967295u);
                    if _e565 {
                        if (_e564 < _e74) {
                        } else {
                            return;
                        }
                        let _e573 = nodes.member[(0u + _e564)].frame[3u];
                        let _e598 = (bitcast<f32>((((_e573 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e303);
                        let _e599 = (bitcast<f32>((((_e573 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e314);
                        let _e600 = (bitcast<f32>((((_e573 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e325);
                        let _e603 = nodes.member[(0u + _e564)].frame[0u];
                        let _e607 = nodes.member[(0u + _e564)].frame[1u];
                        let _e611 = nodes.member[(0u + _e564)].frame[2u];
                        let _e619 = ((bitcast<f32>(_e603) - _e150.origin.x) * _e303);
                        let _e620 = ((bitcast<f32>(_e607) - _e150.origin.y) * _e314);
                        let _e621 = ((bitcast<f32>(_e611) - _e150.origin.z) * _e325);
                        let _e629 = nodes.member[(0u + _e564)].x;
                        if (_e303 < 0f) {
                            let _e640 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e629.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e646 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e640.unnamed.word, _e629.w), _e640.unnamed_1);
                            let _e652 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e646.unnamed, lt_mask_LightPlace(_e629.x, _e646.unnamed_1.shift));
                            phi_1272_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e652.unnamed, lt_mask_LightPlace(_e652.unnamed_1.word, _e629.y));
                        } else {
                            let _e668 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e629.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e674 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e668.unnamed.word, _e629.y), _e668.unnamed_1);
                            let _e680 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e674.unnamed, lt_mask_LightPlace(_e629.z, _e674.unnamed_1.shift));
                            phi_1272_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e680.unnamed, lt_mask_LightPlace(_e680.unnamed_1.word, _e629.w));
                        }
                        let _e688 = phi_1272_;
                        let _e698 = nodes.member[(0u + _e564)].y;
                        if (_e314 < 0f) {
                            let _e709 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e698.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e715 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e709.unnamed.word, _e698.w), _e709.unnamed_1);
                            let _e721 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e715.unnamed, lt_mask_LightPlace(_e698.x, _e715.unnamed_1.shift));
                            phi_1299_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e721.unnamed, lt_mask_LightPlace(_e721.unnamed_1.word, _e698.y));
                        } else {
                            let _e737 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e698.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e743 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e737.unnamed.word, _e698.y), _e737.unnamed_1);
                            let _e749 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e743.unnamed, lt_mask_LightPlace(_e698.z, _e743.unnamed_1.shift));
                            phi_1299_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e749.unnamed, lt_mask_LightPlace(_e749.unnamed_1.word, _e698.w));
                        }
                        let _e757 = phi_1299_;
                        let _e767 = nodes.member[(0u + _e564)].z;
                        if (_e325 < 0f) {
                            let _e778 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e767.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e784 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e778.unnamed.word, _e767.w), _e778.unnamed_1);
                            let _e790 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e784.unnamed, lt_mask_LightPlace(_e767.x, _e784.unnamed_1.shift));
                            phi_1326_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e790.unnamed, lt_mask_LightPlace(_e790.unnamed_1.word, _e767.y));
                        } else {
                            let _e806 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e767.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e812 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e806.unnamed.word, _e767.y), _e806.unnamed_1);
                            let _e818 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e812.unnamed, lt_mask_LightPlace(_e767.z, _e812.unnamed_1.shift));
                            phi_1326_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e818.unnamed, lt_mask_LightPlace(_e818.unnamed_1.word, _e767.w));
                        }
                        let _e826 = phi_1326_;
                        phi_1332_ = 0u;
                        phi_1335_ = 0u;
                        loop {
                            let _e836 = phi_1332_;
                            let _e838 = phi_1335_;
                            local_2 = _e838;
                            local_3 = _e838;
                            local_4 = _e838;
                            let _e839 = (_e836 < 8u);
                            if _e839 {
                                let _e841 = (_e836 >> bitcast<u32>(2i));
                                let _e842 = (_e836 & 3u);
                                if (_e841 == 0u) {
                                    phi_1349_ = _e688.unnamed.word;
                                } else {
                                    phi_1349_ = _e688.unnamed.shift;
                                }
                                let _e845 = phi_1349_;
                                if (_e841 == 0u) {
                                    phi_1359_ = _e757.unnamed.word;
                                } else {
                                    phi_1359_ = _e757.unnamed.shift;
                                }
                                let _e854 = phi_1359_;
                                if (_e841 == 0u) {
                                    phi_1369_ = _e826.unnamed.word;
                                } else {
                                    phi_1369_ = _e826.unnamed.shift;
                                }
                                let _e863 = phi_1369_;
                                let _e876 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e845 >> bitcast<u32>(((_e842 * 8u) & 31u))) & 255u)) * _e598) + (_e619 - _e362)), ((f32(((_e854 >> bitcast<u32>(((_e842 * 8u) & 31u))) & 255u)) * _e599) + (_e620 - _e363)));
                                let _e877 = core_intrinsics_maximum_number_nsz_f32_(_e876, ((f32(((_e863 >> bitcast<u32>(((_e842 * 8u) & 31u))) & 255u)) * _e600) + (_e621 - _e364)));
                                if (_e841 == 0u) {
                                    phi_1387_ = _e688.unnamed_1.word;
                                } else {
                                    phi_1387_ = _e688.unnamed_1.shift;
                                }
                                let _e880 = phi_1387_;
                                if (_e841 == 0u) {
                                    phi_1397_ = _e757.unnamed_1.word;
                                } else {
                                    phi_1397_ = _e757.unnamed_1.shift;
                                }
                                let _e889 = phi_1397_;
                                if (_e841 == 0u) {
                                    phi_1407_ = _e826.unnamed_1.word;
                                } else {
                                    phi_1407_ = _e826.unnamed_1.shift;
                                }
                                let _e898 = phi_1407_;
                                let _e911 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e880 >> bitcast<u32>(((_e842 * 8u) & 31u))) & 255u)) * _e598) + (_e619 + _e362)), ((f32(((_e889 >> bitcast<u32>(((_e842 * 8u) & 31u))) & 255u)) * _e599) + (_e620 + _e363)));
                                let _e912 = core_intrinsics_minimum_number_nsz_f32_(_e911, ((f32(((_e898 >> bitcast<u32>(((_e842 * 8u) & 31u))) & 255u)) * _e600) + (_e621 + _e364)));
                                if (_e877 <= _e912) {
                                    if (_e877 <= _e562.t) {
                                        if (_e912 >= _e150.tmin) {
                                            if (_e841 == 0u) {
                                                let _e919 = nodes.member[(0u + _e564)].links[2u];
                                                phi_1443_ = _e919;
                                            } else {
                                                let _e922 = nodes.member[(0u + _e564)].links[3u];
                                                phi_1443_ = _e922;
                                            }
                                            let _e924 = phi_1443_;
                                            let _e929 = ((_e924 >> bitcast<u32>(((_e842 * 8u) & 31u))) & 255u);
                                            let _e930 = (_e929 & 31u);
                                            if (_e930 >= 24u) {
                                                phi_1456_ = (24u + ((_e930 - 24u) ^ _e424));
                                            } else {
                                                phi_1456_ = _e930;
                                            }
                                            let _e936 = phi_1456_;
                                            phi_1461_ = (_e838 | ((_e929 >> bitcast<u32>(5i)) << bitcast<u32>((_e936 & 31u))));
                                        } else {
                                            phi_1461_ = _e838;
                                        }
                                        let _e944 = phi_1461_;
                                        phi_1462_ = _e944;
                                    } else {
                                        phi_1462_ = _e838;
                                    }
                                    let _e946 = phi_1462_;
                                    phi_1463_ = _e946;
                                } else {
                                    phi_1463_ = _e838;
                                }
                                let _e948 = phi_1463_;
                                phi_1333_ = (_e836 + 1u);
                                phi_1336_ = _e948;
                            } else {
                                phi_1333_ = u32();
                                phi_1336_ = u32();
                            }
                            let _e951 = phi_1333_;
                            let _e953 = phi_1336_;
                            continue;
                            continuing {
                                phi_1332_ = _e951;
                                phi_1335_ = _e953;
                                break if !(_e839);
                            }
                        }
                        let _e957 = nodes.member[(0u + _e564)].links[0u];
                        let _e961 = nodes.member[(0u + _e564)].frame[3u];
                        let _e965 = local_2;
                        if ((_e965 & 4278190080u) == 0u) {
                        } else {
                            let _e969 = local_1.group_mask;
                            if ((_e969 & 4278190080u) == 0u) {
                            } else {
                                let _e973 = local_1.len;
                                if (_e973 < 32u) {
                                    let _e976 = local_1.group;
                                    let _e978 = local_1.len;
                                    if (_e978 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.first[(0u + _e978)] = _e976;
                                    let _e984 = local_1.group_mask;
                                    let _e986 = local_1.len;
                                    if (_e986 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.mask[(0u + _e986)] = _e984;
                                    let _e993 = local_1.len;
                                    local_1.len = (_e993 + 1u);
                                }
                            }
                            local_1.group = (0u + _e957);
                            let _e997 = local_3;
                            local_1.group_mask = ((_e997 & 4278190080u) | (_e961 >> bitcast<u32>(24i)));
                        }
                        let _e1002 = local_4;
                        phi_1521_ = _e562;
                        phi_1524_ = (_e1002 & 16777215u);
                        loop {
                            let _e1005 = phi_1521_;
                            let _e1007 = phi_1524_;
                            local_5 = _e1005;
                            if (_e1007 == 0u) {
                                phi_1522_ = lt_bvh_Hit();
                                phi_1525_ = u32();
                                phi_2183_ = false;
                            } else {
                                let _e1011 = nodes.member[(0u + _e564)].links[1u];
                                let _e1016 = ((0u + _e1011) + select(firstTrailingBit(_e1007), 32u, (_e1007 == 0u)));
                                if (_e1016 < _e77) {
                                } else {
                                    return;
                                }
                                let _e1023 = triangles.member[(0u + _e1016)].v0_;
                                let _e1026 = (_e1023.x - _e150.origin.x);
                                let _e1029 = (_e1023.y - _e150.origin.y);
                                let _e1032 = (_e1023.z - _e150.origin.z);
                                if (_e389 == 0u) {
                                    phi_1571_ = vec3<f32>(_e1029, _e1032, _e1026);
                                } else {
                                    if (_e389 == 1u) {
                                        phi_1570_ = vec3<f32>(_e1032, _e1026, _e1029);
                                    } else {
                                        phi_1570_ = (_e1023 - _e150.origin);
                                    }
                                    let _e1039 = phi_1570_;
                                    phi_1571_ = _e1039;
                                }
                                let _e1041 = phi_1571_;
                                let _e1045 = (_e1041.x - (_e408 * _e1041.z));
                                let _e1049 = (_e1041.y - (_e411 * _e1041.z));
                                let _e1051 = triangles.member[(0u + _e1016)].v1_;
                                let _e1054 = (_e1051.x - _e150.origin.x);
                                let _e1057 = (_e1051.y - _e150.origin.y);
                                let _e1060 = (_e1051.z - _e150.origin.z);
                                if (_e389 == 0u) {
                                    phi_1603_ = vec3<f32>(_e1057, _e1060, _e1054);
                                } else {
                                    if (_e389 == 1u) {
                                        phi_1602_ = vec3<f32>(_e1060, _e1054, _e1057);
                                    } else {
                                        phi_1602_ = (_e1051 - _e150.origin);
                                    }
                                    let _e1067 = phi_1602_;
                                    phi_1603_ = _e1067;
                                }
                                let _e1069 = phi_1603_;
                                let _e1073 = (_e1069.x - (_e408 * _e1069.z));
                                let _e1077 = (_e1069.y - (_e411 * _e1069.z));
                                let _e1079 = triangles.member[(0u + _e1016)].v2_;
                                let _e1082 = (_e1079.x - _e150.origin.x);
                                let _e1085 = (_e1079.y - _e150.origin.y);
                                let _e1088 = (_e1079.z - _e150.origin.z);
                                if (_e389 == 0u) {
                                    phi_1635_ = vec3<f32>(_e1085, _e1088, _e1082);
                                } else {
                                    if (_e389 == 1u) {
                                        phi_1634_ = vec3<f32>(_e1088, _e1082, _e1085);
                                    } else {
                                        phi_1634_ = (_e1079 - _e150.origin);
                                    }
                                    let _e1095 = phi_1634_;
                                    phi_1635_ = _e1095;
                                }
                                let _e1097 = phi_1635_;
                                let _e1101 = (_e1097.x - (_e408 * _e1097.z));
                                let _e1105 = (_e1097.y - (_e411 * _e1097.z));
                                if (_e1073 < _e1101) {
                                    phi_1654_ = true;
                                } else {
                                    if (_e1073 == _e1101) {
                                        phi_1653_ = (_e1077 < _e1105);
                                    } else {
                                        phi_1653_ = false;
                                    }
                                    let _e1110 = phi_1653_;
                                    phi_1654_ = _e1110;
                                }
                                let _e1112 = phi_1654_;
                                if _e1112 {
                                    phi_1658_ = _e1105;
                                    phi_1659_ = _e1101;
                                    phi_1660_ = _e1077;
                                    phi_1661_ = _e1073;
                                } else {
                                    phi_1658_ = _e1077;
                                    phi_1659_ = _e1073;
                                    phi_1660_ = _e1105;
                                    phi_1661_ = _e1101;
                                }
                                let _e1114 = phi_1658_;
                                let _e1116 = phi_1659_;
                                let _e1118 = phi_1660_;
                                let _e1120 = phi_1661_;
                                let _e1123 = ((_e1120 * _e1114) - (_e1118 * _e1116));
                                if _e1112 {
                                    phi_1669_ = -(_e1123);
                                } else {
                                    phi_1669_ = _e1123;
                                }
                                let _e1126 = phi_1669_;
                                if (_e1101 < _e1045) {
                                    phi_1680_ = true;
                                } else {
                                    if (_e1101 == _e1045) {
                                        phi_1679_ = (_e1105 < _e1049);
                                    } else {
                                        phi_1679_ = false;
                                    }
                                    let _e1131 = phi_1679_;
                                    phi_1680_ = _e1131;
                                }
                                let _e1133 = phi_1680_;
                                if _e1133 {
                                    phi_1684_ = _e1049;
                                    phi_1685_ = _e1045;
                                    phi_1686_ = _e1105;
                                    phi_1687_ = _e1101;
                                } else {
                                    phi_1684_ = _e1105;
                                    phi_1685_ = _e1101;
                                    phi_1686_ = _e1049;
                                    phi_1687_ = _e1045;
                                }
                                let _e1135 = phi_1684_;
                                let _e1137 = phi_1685_;
                                let _e1139 = phi_1686_;
                                let _e1141 = phi_1687_;
                                let _e1144 = ((_e1141 * _e1135) - (_e1139 * _e1137));
                                if _e1133 {
                                    phi_1695_ = -(_e1144);
                                } else {
                                    phi_1695_ = _e1144;
                                }
                                let _e1147 = phi_1695_;
                                if (_e1045 < _e1073) {
                                    phi_1706_ = true;
                                } else {
                                    if (_e1045 == _e1073) {
                                        phi_1705_ = (_e1049 < _e1077);
                                    } else {
                                        phi_1705_ = false;
                                    }
                                    let _e1152 = phi_1705_;
                                    phi_1706_ = _e1152;
                                }
                                let _e1154 = phi_1706_;
                                if _e1154 {
                                    phi_1710_ = _e1077;
                                    phi_1711_ = _e1073;
                                    phi_1712_ = _e1049;
                                    phi_1713_ = _e1045;
                                } else {
                                    phi_1710_ = _e1049;
                                    phi_1711_ = _e1045;
                                    phi_1712_ = _e1077;
                                    phi_1713_ = _e1073;
                                }
                                let _e1156 = phi_1710_;
                                let _e1158 = phi_1711_;
                                let _e1160 = phi_1712_;
                                let _e1162 = phi_1713_;
                                let _e1165 = ((_e1162 * _e1156) - (_e1160 * _e1158));
                                if _e1154 {
                                    phi_1721_ = -(_e1165);
                                } else {
                                    phi_1721_ = _e1165;
                                }
                                let _e1168 = phi_1721_;
                                if (_e1126 >= 0f) {
                                    if (_e1147 >= 0f) {
                                        if (_e1168 >= 0f) {
                                            phi_1736_ = ((_e1126 + _e1147) + _e1168);
                                            phi_1737_ = false;
                                        } else {
                                            phi_1736_ = f32();
                                            phi_1737_ = true;
                                        }
                                        let _e1175 = phi_1736_;
                                        let _e1177 = phi_1737_;
                                        phi_1738_ = _e1175;
                                        phi_1739_ = _e1177;
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
                                if _e1185 {
                                    if (_e1126 <= 0f) {
                                        if (_e1147 <= 0f) {
                                            let _e1188 = (_e1168 <= 0f);
                                            if _e1188 {
                                            }
                                            phi_1759_ = ((_e1126 + _e1147) + _e1168);
                                            phi_1760_ = false;
                                            phi_1761_ = _e1188;
                                        } else {
                                            phi_1759_ = f32();
                                            phi_1760_ = true;
                                            phi_1761_ = false;
                                        }
                                        let _e1192 = phi_1759_;
                                        let _e1194 = phi_1760_;
                                        let _e1196 = phi_1761_;
                                        phi_1762_ = _e1192;
                                        phi_1763_ = _e1194;
                                        phi_1764_ = _e1196;
                                    } else {
                                        phi_1762_ = f32();
                                        phi_1763_ = true;
                                        phi_1764_ = false;
                                    }
                                    let _e1198 = phi_1762_;
                                    let _e1200 = phi_1763_;
                                    let _e1202 = phi_1764_;
                                    if _e1200 {
                                        phi_1768_ = false;
                                    } else {
                                        phi_1768_ = _e1202;
                                    }
                                    let _e1204 = phi_1768_;
                                    phi_1769_ = _e1198;
                                    phi_1770_ = _e1204;
                                } else {
                                    phi_1769_ = _e1183;
                                    phi_1770_ = true;
                                }
                                let _e1206 = phi_1769_;
                                let _e1208 = phi_1770_;
                                if _e1208 {
                                    let _e1209 = (_e1206 == 0f);
                                    if _e1209 {
                                        phi_2096_ = lt_bvh_triangle_Intersection();
                                        phi_2097_ = false;
                                    } else {
                                        let _e1211 = triangles.member[(0u + _e1016)].v0_;
                                        let _e1214 = (_e1211.x - _e150.origin.x);
                                        let _e1217 = (_e1211.y - _e150.origin.y);
                                        let _e1220 = (_e1211.z - _e150.origin.z);
                                        if (_e389 == 0u) {
                                            phi_1801_ = vec3<f32>(_e1217, _e1220, _e1214);
                                        } else {
                                            if (_e389 == 1u) {
                                                phi_1800_ = vec3<f32>(_e1220, _e1214, _e1217);
                                            } else {
                                                phi_1800_ = (_e1211 - _e150.origin);
                                            }
                                            let _e1227 = phi_1800_;
                                            phi_1801_ = _e1227;
                                        }
                                        let _e1229 = phi_1801_;
                                        let _e1231 = triangles.member[(0u + _e1016)].v1_;
                                        let _e1233 = triangles.member[(0u + _e1016)].v0_;
                                        let _e1236 = (_e1231.x - _e1233.x);
                                        let _e1239 = (_e1231.y - _e1233.y);
                                        let _e1242 = (_e1231.z - _e1233.z);
                                        if (_e389 == 0u) {
                                            phi_1827_ = vec3<f32>(_e1239, _e1242, _e1236);
                                        } else {
                                            if (_e389 == 1u) {
                                                phi_1826_ = vec3<f32>(_e1242, _e1236, _e1239);
                                            } else {
                                                phi_1826_ = (_e1231 - _e1233);
                                            }
                                            let _e1249 = phi_1826_;
                                            phi_1827_ = _e1249;
                                        }
                                        let _e1251 = phi_1827_;
                                        let _e1253 = triangles.member[(0u + _e1016)].v2_;
                                        let _e1255 = triangles.member[(0u + _e1016)].v0_;
                                        let _e1258 = (_e1253.x - _e1255.x);
                                        let _e1261 = (_e1253.y - _e1255.y);
                                        let _e1264 = (_e1253.z - _e1255.z);
                                        if (_e389 == 0u) {
                                            phi_1853_ = vec3<f32>(_e1261, _e1264, _e1258);
                                        } else {
                                            if (_e389 == 1u) {
                                                phi_1852_ = vec3<f32>(_e1264, _e1258, _e1261);
                                            } else {
                                                phi_1852_ = (_e1253 - _e1255);
                                            }
                                            let _e1271 = phi_1852_;
                                            phi_1853_ = _e1271;
                                        }
                                        let _e1273 = phi_1853_;
                                        let _e1280 = ((_e1251.y * _e1273.z) - (_e1251.z * _e1273.y));
                                        let _e1287 = ((_e1251.z * _e1273.x) - (_e1251.x * _e1273.z));
                                        let _e1294 = ((_e1251.x * _e1273.y) - (_e1251.y * _e1273.x));
                                        let _e1308 = (((1f / _e404.z) * (((_e1280 * _e1229.x) + (_e1287 * _e1229.y)) + (_e1294 * _e1229.z))) / (((_e1280 * _e408) + (_e1287 * _e411)) + _e1294));
                                        if (_e1308 > _e150.tmin) {
                                            if (_e1308 < _e150.tmax) {
                                                let _e1314 = triangles.member[(0u + _e1016)].v0_;
                                                let _e1316 = triangles.member[(0u + _e1016)].v1_;
                                                if (_e1314.x < _e1316.x) {
                                                    phi_1911_ = _e1314.x;
                                                } else {
                                                    phi_1911_ = _e1316.x;
                                                }
                                                let _e1323 = phi_1911_;
                                                if (_e1314.y < _e1316.y) {
                                                    phi_1920_ = _e1314.y;
                                                } else {
                                                    phi_1920_ = _e1316.y;
                                                }
                                                let _e1330 = phi_1920_;
                                                if (_e1314.z < _e1316.z) {
                                                    phi_1929_ = _e1314.z;
                                                } else {
                                                    phi_1929_ = _e1316.z;
                                                }
                                                let _e1337 = phi_1929_;
                                                let _e1339 = triangles.member[(0u + _e1016)].v2_;
                                                if (_e1323 < _e1339.x) {
                                                    phi_1938_ = _e1323;
                                                } else {
                                                    phi_1938_ = _e1339.x;
                                                }
                                                let _e1344 = phi_1938_;
                                                if (_e1330 < _e1339.y) {
                                                    phi_1945_ = _e1330;
                                                } else {
                                                    phi_1945_ = _e1339.y;
                                                }
                                                let _e1349 = phi_1945_;
                                                if (_e1337 < _e1339.z) {
                                                    phi_1952_ = _e1337;
                                                } else {
                                                    phi_1952_ = _e1339.z;
                                                }
                                                let _e1354 = phi_1952_;
                                                let _e1356 = triangles.member[(0u + _e1016)].v0_;
                                                let _e1358 = triangles.member[(0u + _e1016)].v1_;
                                                if (_e1356.x > _e1358.x) {
                                                    phi_1965_ = _e1356.x;
                                                } else {
                                                    phi_1965_ = _e1358.x;
                                                }
                                                let _e1365 = phi_1965_;
                                                if (_e1356.y > _e1358.y) {
                                                    phi_1974_ = _e1356.y;
                                                } else {
                                                    phi_1974_ = _e1358.y;
                                                }
                                                let _e1372 = phi_1974_;
                                                if (_e1356.z > _e1358.z) {
                                                    phi_1983_ = _e1356.z;
                                                } else {
                                                    phi_1983_ = _e1358.z;
                                                }
                                                let _e1379 = phi_1983_;
                                                let _e1381 = triangles.member[(0u + _e1016)].v2_;
                                                if (_e1365 > _e1381.x) {
                                                    phi_1992_ = _e1365;
                                                } else {
                                                    phi_1992_ = _e1381.x;
                                                }
                                                let _e1386 = phi_1992_;
                                                if (_e1372 > _e1381.y) {
                                                    phi_1999_ = _e1372;
                                                } else {
                                                    phi_1999_ = _e1381.y;
                                                }
                                                let _e1391 = phi_1999_;
                                                if (_e1379 > _e1381.z) {
                                                    phi_2006_ = _e1379;
                                                } else {
                                                    phi_2006_ = _e1381.z;
                                                }
                                                let _e1396 = phi_2006_;
                                                let _e1403 = ((_e1344 - _e150.origin.x) * _e303);
                                                let _e1404 = ((_e1349 - _e150.origin.y) * _e314);
                                                let _e1405 = ((_e1354 - _e150.origin.z) * _e325);
                                                let _e1412 = ((_e1386 - _e150.origin.x) * _e303);
                                                let _e1413 = ((_e1391 - _e150.origin.y) * _e314);
                                                let _e1414 = ((_e1396 - _e150.origin.z) * _e325);
                                                if (_e1403 < _e1412) {
                                                    phi_2029_ = _e1403;
                                                } else {
                                                    phi_2029_ = _e1412;
                                                }
                                                let _e1417 = phi_2029_;
                                                if (_e1404 < _e1413) {
                                                    phi_2034_ = _e1404;
                                                } else {
                                                    phi_2034_ = _e1413;
                                                }
                                                let _e1420 = phi_2034_;
                                                if (_e1405 < _e1414) {
                                                    phi_2039_ = _e1405;
                                                } else {
                                                    phi_2039_ = _e1414;
                                                }
                                                let _e1423 = phi_2039_;
                                                if (_e1403 > _e1412) {
                                                    phi_2047_ = _e1403;
                                                } else {
                                                    phi_2047_ = _e1412;
                                                }
                                                let _e1429 = phi_2047_;
                                                if (_e1404 > _e1413) {
                                                    phi_2052_ = _e1404;
                                                } else {
                                                    phi_2052_ = _e1413;
                                                }
                                                let _e1432 = phi_2052_;
                                                if (_e1405 > _e1414) {
                                                    phi_2057_ = _e1405;
                                                } else {
                                                    phi_2057_ = _e1414;
                                                }
                                                let _e1435 = phi_2057_;
                                                let _e1439 = core_intrinsics_maximum_number_nsz_f32_((_e1417 - _e369), (_e1420 - _e370));
                                                let _e1440 = core_intrinsics_maximum_number_nsz_f32_(_e1439, (_e1423 - _e371));
                                                let _e1441 = core_intrinsics_minimum_number_nsz_f32_((_e1429 + _e369), (_e1432 + _e370));
                                                let _e1442 = core_intrinsics_minimum_number_nsz_f32_(_e1441, (_e1435 + _e371));
                                                if (_e1440 > -300000000000000000000000000000000000000f) {
                                                    phi_2069_ = _e1440;
                                                } else {
                                                    phi_2069_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1445 = phi_2069_;
                                                if (_e1442 < 300000000000000000000000000000000000000f) {
                                                    phi_2074_ = _e1442;
                                                } else {
                                                    phi_2074_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1448 = phi_2074_;
                                                if (_e1308 < _e1445) {
                                                    phi_2079_ = _e1445;
                                                } else {
                                                    phi_2079_ = _e1308;
                                                }
                                                let _e1451 = phi_2079_;
                                                if (_e1451 > _e1448) {
                                                    phi_2084_ = _e1448;
                                                } else {
                                                    phi_2084_ = _e1451;
                                                }
                                                let _e1454 = phi_2084_;
                                                phi_2089_ = lt_bvh_triangle_Intersection(_e1454, (_e1147 / _e1206), (_e1168 / _e1206), (_e1445 <= _e1448));
                                                phi_2090_ = false;
                                            } else {
                                                phi_2089_ = lt_bvh_triangle_Intersection();
                                                phi_2090_ = true;
                                            }
                                            let _e1460 = phi_2089_;
                                            let _e1462 = phi_2090_;
                                            phi_2091_ = _e1460;
                                            phi_2092_ = _e1462;
                                        } else {
                                            phi_2091_ = lt_bvh_triangle_Intersection();
                                            phi_2092_ = true;
                                        }
                                        let _e1464 = phi_2091_;
                                        let _e1466 = phi_2092_;
                                        if _e1466 {
                                        }
                                        phi_2096_ = _e1464;
                                        phi_2097_ = _e1466;
                                    }
                                    let _e1468 = phi_2096_;
                                    let _e1470 = phi_2097_;
                                    phi_2098_ = _e1468;
                                    phi_2099_ = _e1209;
                                    phi_2100_ = _e1470;
                                } else {
                                    phi_2098_ = lt_bvh_triangle_Intersection();
                                    phi_2099_ = true;
                                    phi_2100_ = false;
                                }
                                let _e1472 = phi_2098_;
                                let _e1474 = phi_2099_;
                                let _e1476 = phi_2100_;
                                if _e1474 {
                                    phi_2104_ = true;
                                } else {
                                    phi_2104_ = _e1476;
                                }
                                let _e1478 = phi_2104_;
                                if _e1478 {
                                    phi_2108_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_2108_ = _e1472;
                                }
                                let _e1480 = phi_2108_;
                                if _e1480.is_hit {
                                    if (_e1480.t > _e150.tmin) {
                                        if (_e1480.t < _e1005.t) {
                                            phi_2157_ = true;
                                        } else {
                                            if (_e1480.t == _e1005.t) {
                                                if (_e1005.triangle != 4294967295u) {
                                                    if (_e1016 < _e1005.triangle) {
                                                        phi_2148_ = true;
                                                    } else {
                                                        if (_e1016 == _e1005.triangle) {
                                                            phi_2147_ = (4294967295u < _e1005.instance);
                                                        } else {
                                                            phi_2147_ = false;
                                                        }
                                                        let _e1499 = phi_2147_;
                                                        phi_2148_ = _e1499;
                                                    }
                                                    let _e1501 = phi_2148_;
                                                    phi_2149_ = _e1501;
                                                    phi_2150_ = false;
                                                } else {
                                                    phi_2149_ = bool();
                                                    phi_2150_ = true;
                                                }
                                                let _e1503 = phi_2149_;
                                                let _e1505 = phi_2150_;
                                                phi_2151_ = _e1503;
                                                phi_2152_ = _e1505;
                                            } else {
                                                phi_2151_ = bool();
                                                phi_2152_ = true;
                                            }
                                            let _e1507 = phi_2151_;
                                            let _e1509 = phi_2152_;
                                            if _e1509 {
                                                phi_2156_ = false;
                                            } else {
                                                phi_2156_ = _e1507;
                                            }
                                            let _e1511 = phi_2156_;
                                            phi_2157_ = _e1511;
                                        }
                                        let _e1513 = phi_2157_;
                                        if _e1513 {
                                            let _e1515 = triangles.member[(0u + _e1016)].i0_;
                                            if ((_e1515 & 2147483648u) == 0u) {
                                                phi_2171_ = true;
                                            } else {
                                                if true {
                                                }
                                                phi_2171_ = true;
                                            }
                                            let _e1519 = phi_2171_;
                                            if _e1519 {
                                                phi_2179_ = lt_bvh_Hit(_e1480.t, _e1480.u, _e1480.v, _e1016, 4294967295u);
                                            } else {
                                                phi_2179_ = _e1005;
                                            }
                                            let _e1525 = phi_2179_;
                                            phi_2180_ = _e1525;
                                        } else {
                                            phi_2180_ = _e1005;
                                        }
                                        let _e1527 = phi_2180_;
                                        phi_2181_ = _e1527;
                                    } else {
                                        phi_2181_ = _e1005;
                                    }
                                    let _e1529 = phi_2181_;
                                    phi_2182_ = _e1529;
                                } else {
                                    phi_2182_ = _e1005;
                                }
                                let _e1531 = phi_2182_;
                                phi_1522_ = _e1531;
                                phi_1525_ = (_e1007 & (_e1007 - 1u));
                                phi_2183_ = true;
                            }
                            let _e1533 = phi_1522_;
                            let _e1535 = phi_1525_;
                            let _e1537 = phi_2183_;
                            continue;
                            continuing {
                                phi_1521_ = _e1533;
                                phi_1524_ = _e1535;
                                break if !(_e1537);
                            }
                        }
                        let _e1540 = local_1.group_mask;
                        if ((_e1540 & 4278190080u) == 0u) {
                            let _e1544 = local_1.len;
                            if (_e1544 == 0u) {
                                phi_2222_ = false;
                            } else {
                                let _e1548 = local_1.len;
                                local_1.len = (_e1548 - 1u);
                                let _e1551 = local_1.len;
                                if (_e1551 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1556 = local_1.first[(0u + _e1551)];
                                local_1.group = _e1556;
                                let _e1559 = local_1.len;
                                if (_e1559 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1564 = local_1.mask[(0u + _e1559)];
                                local_1.group_mask = _e1564;
                                phi_2222_ = true;
                            }
                            let _e1567 = phi_2222_;
                            phi_2223_ = _e1567;
                        } else {
                            phi_2223_ = true;
                        }
                        let _e1569 = phi_2223_;
                        if _e1569 {
                            let _e1571 = local_1.group_mask;
                            let _e1577 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1571)), 32u, (_e1571 == 0u)));
                            let _e1581 = local_1.group_mask;
                            let _e1595 = local_1.group_mask;
                            local_1.group_mask = (_e1595 & ~((1u << bitcast<u32>((_e1577 & 31u)))));
                            let _e1598 = local_1.group;
                            phi_2254_ = (_e1598 + countOneBits(((_e1581 & ~((4294967295u << bitcast<u32>((((_e1577 - 24u) ^ _e424) & 31u))))) & 255u)));
                        } else {
                            phi_2254_ = 4294967295u;
                        }
                        let _e1601 = phi_2254_;
                        let _e2445 = local_5;
                        phi_1185_ = _e2445;
                        phi_1188_ = _e1601;
                    } else {
                        phi_1185_ = lt_bvh_Hit();
                        phi_1188_ = u32();
                    }
                    let _e1603 = phi_1185_;
                    let _e1605 = phi_1188_;
                    continue;
                    continuing {
                        phi_1184_ = _e1603;
                        phi_1187_ = _e1605;
                        break if !(_e565);
                    }
                }
                let _e2449 = local_6;
                phi_2255_ = _e2449;
            }
            let _e1608 = phi_2255_;
            phi_2256_ = _e1608;
            phi_2257_ = _e222;
        } else {
            phi_2256_ = lt_bvh_Hit();
            phi_2257_ = true;
        }
        let _e1610 = phi_2256_;
        let _e1612 = phi_2257_;
        if _e1612 {
            phi_2261_ = _e152;
        } else {
            phi_2261_ = _e1610;
        }
        let _e1614 = phi_2261_;
        if (_e1614.triangle != 4294967295u) {
            let _e1620 = ((1f - _e1614.u) - _e1614.v);
            if (_e1614.triangle < _e77) {
            } else {
                return;
            }
            let _e1625 = triangles.member[(0u + _e1614.triangle)];
            let _e1650 = (((_e1625.v0_.x * _e1620) + (_e1625.v1_.x * _e1614.u)) + (_e1625.v2_.x * _e1614.v));
            let _e1651 = (((_e1625.v0_.y * _e1620) + (_e1625.v1_.y * _e1614.u)) + (_e1625.v2_.y * _e1614.v));
            let _e1652 = (((_e1625.v0_.z * _e1620) + (_e1625.v1_.z * _e1614.u)) + (_e1625.v2_.z * _e1614.v));
            let _e1655 = abs(_e1625.v0_.x);
            let _e1657 = abs(_e1625.v0_.y);
            let _e1659 = abs(_e1625.v0_.z);
            let _e1661 = abs(_e1625.v1_.x);
            let _e1663 = abs(_e1625.v1_.y);
            let _e1665 = abs(_e1625.v1_.z);
            if (_e1655 > _e1661) {
                phi_2325_ = _e1655;
            } else {
                phi_2325_ = _e1661;
            }
            let _e1668 = phi_2325_;
            if (_e1657 > _e1663) {
                phi_2330_ = _e1657;
            } else {
                phi_2330_ = _e1663;
            }
            let _e1671 = phi_2330_;
            if (_e1659 > _e1665) {
                phi_2335_ = _e1659;
            } else {
                phi_2335_ = _e1665;
            }
            let _e1674 = phi_2335_;
            let _e1676 = abs(_e1625.v2_.x);
            let _e1678 = abs(_e1625.v2_.y);
            let _e1680 = abs(_e1625.v2_.z);
            if (_e1668 > _e1676) {
                phi_2346_ = _e1668;
            } else {
                phi_2346_ = _e1676;
            }
            let _e1683 = phi_2346_;
            if (_e1671 > _e1678) {
                phi_2351_ = _e1671;
            } else {
                phi_2351_ = _e1678;
            }
            let _e1686 = phi_2351_;
            if (_e1674 > _e1680) {
                phi_2356_ = _e1674;
            } else {
                phi_2356_ = _e1680;
            }
            let _e1689 = phi_2356_;
            let _e1692 = (_e1625.v1_.x - _e1625.v0_.x);
            let _e1695 = (_e1625.v1_.y - _e1625.v0_.y);
            let _e1698 = (_e1625.v1_.z - _e1625.v0_.z);
            let _e1701 = (_e1625.v2_.x - _e1625.v0_.x);
            let _e1704 = (_e1625.v2_.y - _e1625.v0_.y);
            let _e1707 = (_e1625.v2_.z - _e1625.v0_.z);
            let _e1711 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1695), abs(_e1698));
            let _e1712 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1692), _e1711);
            let _e1713 = (_e1692 / _e1712);
            let _e1714 = (_e1695 / _e1712);
            let _e1715 = (_e1698 / _e1712);
            let _e1719 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1704), abs(_e1707));
            let _e1720 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1701), _e1719);
            let _e1721 = (_e1701 / _e1720);
            let _e1722 = (_e1704 / _e1720);
            let _e1723 = (_e1707 / _e1720);
            let _e1726 = ((_e1714 * _e1723) - (_e1722 * _e1715));
            let _e1729 = ((_e1715 * _e1721) - (_e1723 * _e1713));
            let _e1732 = ((_e1713 * _e1722) - (_e1721 * _e1714));
            let _e1734 = p.member.eye;
            let _e1747 = (1f / sqrt((((_e1726 * _e1726) + (_e1729 * _e1729)) + (_e1732 * _e1732))));
            let _e1748 = (_e1726 * _e1747);
            let _e1749 = (_e1729 * _e1747);
            let _e1750 = (_e1732 * _e1747);
            if ((((_e1748 * (_e1734.x - _e1650)) + (_e1749 * (_e1734.y - _e1651))) + (_e1750 * (_e1734.z - _e1652))) < 0f) {
                phi_2432_ = vec3<f32>(-(_e1748), -(_e1749), -(_e1750));
            } else {
                phi_2432_ = vec3<f32>(_e1748, _e1749, _e1750);
            }
            let _e1763 = phi_2432_;
            if (_e1614.triangle < _e77) {
            } else {
                return;
            }
            let _e1768 = triangles.member[(0u + _e1614.triangle)];
            let _e1770 = (_e1768.i0_ & 2147483647u);
            if (_e1770 < _e80) {
            } else {
                return;
            }
            let _e1776 = vertices.member[(0u + _e1770)];
            if (_e1768.i1_ < _e80) {
            } else {
                return;
            }
            let _e1780 = vertices.member[(0u + _e1768.i1_)];
            if (_e1768.i2_ < _e80) {
            } else {
                return;
            }
            let _e1784 = vertices.member[(0u + _e1768.i2_)];
            let _e1785 = array<abi_Vertex, 3>(_e1776, _e1780, _e1784);
            if (_e1785[0].material < arrayLength((&materials.member))) {
            } else {
                return;
            }
            let _e1791 = materials.member[(0u + _e1785[0].material)];
            let _e1808 = (1f / 255f);
            let _e1827 = (1f / 255f);
            let _e1849 = (1f / 255f);
            if (_e1791.color_size == 0u) {
                phi_2675_ = vec3<f32>(1f, 1f, 1f);
            } else {
                local.offset = _e1791.color_offset;
                local.size = _e1791.color_size;
                local.flags = _e1791.flags;
                let _e1892 = _lt_shaders_texture_TextureView_quad((&local), (((_e1785[0].u * _e1620) + (_e1785[1].u * _e1614.u)) + (_e1785[2].u * _e1614.v)), (((_e1785[0].v * _e1620) + (_e1785[1].v * _e1614.u)) + (_e1785[2].v * _e1614.v)));
                if (_e1892.indices[0] < _e89) {
                } else {
                    return;
                }
                let _e1898 = color_texels.member[(0u + _e1892.indices[0])];
                let _e1909 = (1f / 255f);
                if (_e1892.indices[1] < _e89) {
                } else {
                    return;
                }
                let _e1923 = color_texels.member[(0u + _e1892.indices[1])];
                let _e1934 = (1f / 255f);
                if (_e1892.indices[2] < _e89) {
                } else {
                    return;
                }
                let _e1951 = color_texels.member[(0u + _e1892.indices[2])];
                let _e1962 = (1f / 255f);
                if (_e1892.indices[3] < _e89) {
                } else {
                    return;
                }
                let _e1979 = color_texels.member[(0u + _e1892.indices[3])];
                let _e1990 = (1f / 255f);
                let _e1999 = (((((f32((_e1898 & 255u)) * _e1909) * _e1892.weights.x) + ((f32((_e1923 & 255u)) * _e1934) * _e1892.weights.y)) + ((f32((_e1951 & 255u)) * _e1962) * _e1892.weights.z)) + ((f32((_e1979 & 255u)) * _e1990) * _e1892.weights.w));
                let _e2000 = (((((f32(((_e1898 >> bitcast<u32>(8i)) & 255u)) * _e1909) * _e1892.weights.x) + ((f32(((_e1923 >> bitcast<u32>(8i)) & 255u)) * _e1934) * _e1892.weights.y)) + ((f32(((_e1951 >> bitcast<u32>(8i)) & 255u)) * _e1962) * _e1892.weights.z)) + ((f32(((_e1979 >> bitcast<u32>(8i)) & 255u)) * _e1990) * _e1892.weights.w));
                let _e2001 = (((((f32(((_e1898 >> bitcast<u32>(16i)) & 255u)) * _e1909) * _e1892.weights.x) + ((f32(((_e1923 >> bitcast<u32>(16i)) & 255u)) * _e1934) * _e1892.weights.y)) + ((f32(((_e1951 >> bitcast<u32>(16i)) & 255u)) * _e1962) * _e1892.weights.z)) + ((f32(((_e1979 >> bitcast<u32>(16i)) & 255u)) * _e1990) * _e1892.weights.w));
                phi_2675_ = vec3<f32>((_e1999 * _e1999), (_e2000 * _e2000), (_e2001 * _e2001));
            }
            let _e2007 = phi_2675_;
            let _e2009 = ((_e1791.base_color.x * ((((f32((_e1785[0].color & 255u)) * _e1808) * _e1620) + ((f32((_e1785[1].color & 255u)) * _e1827) * _e1614.u)) + ((f32((_e1785[2].color & 255u)) * _e1849) * _e1614.v))) * _e2007.x);
            let _e2011 = ((_e1791.base_color.y * ((((f32(((_e1785[0].color >> bitcast<u32>(8i)) & 255u)) * _e1808) * _e1620) + ((f32(((_e1785[1].color >> bitcast<u32>(8i)) & 255u)) * _e1827) * _e1614.u)) + ((f32(((_e1785[2].color >> bitcast<u32>(8i)) & 255u)) * _e1849) * _e1614.v))) * _e2007.y);
            let _e2013 = ((_e1791.base_color.z * ((((f32(((_e1785[0].color >> bitcast<u32>(16i)) & 255u)) * _e1808) * _e1620) + ((f32(((_e1785[1].color >> bitcast<u32>(16i)) & 255u)) * _e1827) * _e1614.u)) + ((f32(((_e1785[2].color >> bitcast<u32>(16i)) & 255u)) * _e1849) * _e1614.v))) * _e2007.z);
            let _e2014 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1686, _e1689);
            let _e2015 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1683, _e2014);
            if ((_e1791.flags & 2u) == 0u) {
                phi_2690_ = 0u;
            } else {
                phi_2690_ = 1u;
            }
            let _e2020 = phi_2690_;
            if (_e1785[0].normal == 2147516416u) {
                phi_2893_ = _e1763;
            } else {
                let _e2033 = (f32((bitcast<i32>((_e1785[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2039 = (f32((bitcast<i32>(_e1785[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2043 = ((1f - abs(_e2033)) - abs(_e2039));
                if (_e2043 < 0f) {
                    phi_2717_ = -(_e2043);
                } else {
                    phi_2717_ = 0f;
                }
                let _e2047 = phi_2717_;
                if (_e2033 < 0f) {
                    phi_2724_ = (_e2033 + _e2047);
                } else {
                    phi_2724_ = (_e2033 - _e2047);
                }
                let _e2052 = phi_2724_;
                if (_e2039 < 0f) {
                    phi_2731_ = (_e2039 + _e2047);
                } else {
                    phi_2731_ = (_e2039 - _e2047);
                }
                let _e2057 = phi_2731_;
                let _e2064 = (1f / sqrt((((_e2052 * _e2052) + (_e2057 * _e2057)) + (_e2043 * _e2043))));
                let _e2080 = (f32((bitcast<i32>((_e1785[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2086 = (f32((bitcast<i32>(_e1785[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2090 = ((1f - abs(_e2080)) - abs(_e2086));
                if (_e2090 < 0f) {
                    phi_2766_ = -(_e2090);
                } else {
                    phi_2766_ = 0f;
                }
                let _e2094 = phi_2766_;
                if (_e2080 < 0f) {
                    phi_2773_ = (_e2080 + _e2094);
                } else {
                    phi_2773_ = (_e2080 - _e2094);
                }
                let _e2099 = phi_2773_;
                if (_e2086 < 0f) {
                    phi_2780_ = (_e2086 + _e2094);
                } else {
                    phi_2780_ = (_e2086 - _e2094);
                }
                let _e2104 = phi_2780_;
                let _e2111 = (1f / sqrt((((_e2099 * _e2099) + (_e2104 * _e2104)) + (_e2090 * _e2090))));
                let _e2130 = (f32((bitcast<i32>((_e1785[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2136 = (f32((bitcast<i32>(_e1785[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2140 = ((1f - abs(_e2130)) - abs(_e2136));
                if (_e2140 < 0f) {
                    phi_2818_ = -(_e2140);
                } else {
                    phi_2818_ = 0f;
                }
                let _e2144 = phi_2818_;
                if (_e2130 < 0f) {
                    phi_2825_ = (_e2130 + _e2144);
                } else {
                    phi_2825_ = (_e2130 - _e2144);
                }
                let _e2149 = phi_2825_;
                if (_e2136 < 0f) {
                    phi_2832_ = (_e2136 + _e2144);
                } else {
                    phi_2832_ = (_e2136 - _e2144);
                }
                let _e2154 = phi_2832_;
                let _e2161 = (1f / sqrt((((_e2149 * _e2149) + (_e2154 * _e2154)) + (_e2140 * _e2140))));
                let _e2172 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(vec3<f32>(((((_e2052 * _e2064) * _e1620) + ((_e2099 * _e2111) * _e1614.u)) + ((_e2149 * _e2161) * _e1614.v)), ((((_e2057 * _e2064) * _e1620) + ((_e2104 * _e2111) * _e1614.u)) + ((_e2154 * _e2161) * _e1614.v)), ((((_e2043 * _e2064) * _e1620) + ((_e2090 * _e2111) * _e1614.u)) + ((_e2140 * _e2161) * _e1614.v))));
                let _e2184 = sqrt((((_e2172.x * _e2172.x) + (_e2172.y * _e2172.y)) + (_e2172.z * _e2172.z)));
                if (_e2184 > 0f) {
                    let _e2187 = (_e2172.x / _e2184);
                    let _e2189 = (_e2172.y / _e2184);
                    let _e2191 = (_e2172.z / _e2184);
                    if ((((_e2187 * _e1763.x) + (_e2189 * _e1763.y)) + (_e2191 * _e1763.z)) < 0f) {
                        phi_2891_ = vec3<f32>(-(_e2187), -(_e2189), -(_e2191));
                    } else {
                        phi_2891_ = (_e2172 / vec3(_e2184));
                    }
                    let _e2208 = phi_2891_;
                    phi_2892_ = _e2208;
                } else {
                    phi_2892_ = _e1763;
                }
                let _e2210 = phi_2892_;
                phi_2893_ = _e2210;
            }
            let _e2212 = phi_2893_;
            if (_e2009 > 0f) {
                if (_e2009 < 1f) {
                    phi_2902_ = _e2009;
                } else {
                    phi_2902_ = 1f;
                }
                let _e2216 = phi_2902_;
                phi_2903_ = _e2216;
            } else {
                phi_2903_ = 0f;
            }
            let _e2218 = phi_2903_;
            if (_e2011 > 0f) {
                if (_e2011 < 1f) {
                    phi_2913_ = _e2011;
                } else {
                    phi_2913_ = 1f;
                }
                let _e2223 = phi_2913_;
                phi_2914_ = _e2223;
            } else {
                phi_2914_ = 0f;
            }
            let _e2225 = phi_2914_;
            if (_e2013 > 0f) {
                if (_e2013 < 1f) {
                    phi_2924_ = _e2013;
                } else {
                    phi_2924_ = 1f;
                }
                let _e2230 = phi_2924_;
                phi_2925_ = _e2230;
            } else {
                phi_2925_ = 0f;
            }
            let _e2232 = phi_2925_;
            let _e2235 = ((sqrt(_e2218) * 255f) + 0.5f);
            let _e2244 = ((sqrt(_e2225) * 255f) + 0.5f);
            let _e2256 = ((sqrt(_e2232) * 255f) + 0.5f);
            phi_2960_ = abi_Sample(vec3<f32>(_e1650, _e1651, _e1652), _e2015, _e1763, _e2020, _e2212, ((select(select(u32(_e2235), 0u, (_e2235 < bitcast<f32>(0u))), 4294967295u, (_e2235 > bitcast<f32>(1333788671u))) | (select(select(u32(_e2244), 0u, (_e2244 < bitcast<f32>(0u))), 4294967295u, (_e2244 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e2256), 0u, (_e2256 < bitcast<f32>(0u))), 4294967295u, (_e2256 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_2960_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e2270 = phi_2960_;
        if (_e95.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e95.shift)] = _e2270;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_color_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
