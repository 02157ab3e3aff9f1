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
                let _e299 = phi_878_;
                if (_e150.direction.x < 0f) {
                    phi_885_ = (-1f / _e299);
                } else {
                    phi_885_ = (1f / _e299);
                }
                let _e304 = phi_885_;
                if (abs(_e150.direction.y) < _e292) {
                    phi_893_ = _e292;
                } else {
                    phi_893_ = abs(_e150.direction.y);
                }
                let _e311 = phi_893_;
                if (_e150.direction.y < 0f) {
                    phi_900_ = (-1f / _e311);
                } else {
                    phi_900_ = (1f / _e311);
                }
                let _e316 = phi_900_;
                if (abs(_e150.direction.z) < _e292) {
                    phi_908_ = _e292;
                } else {
                    phi_908_ = abs(_e150.direction.z);
                }
                let _e323 = phi_908_;
                if (_e150.direction.z < 0f) {
                    phi_915_ = (-1f / _e323);
                } else {
                    phi_915_ = (1f / _e323);
                }
                let _e328 = phi_915_;
                let _e336 = abs((bitcast<f32>(_e228) - _e150.origin.x));
                let _e337 = abs((bitcast<f32>(_e232) - _e150.origin.y));
                let _e338 = abs((bitcast<f32>(_e236) - _e150.origin.z));
                let _e346 = abs(((bitcast<f32>(_e240) + (bitcast<f32>((((_e252 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e150.origin.x));
                let _e347 = abs(((bitcast<f32>(_e244) + (bitcast<f32>((((_e252 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e150.origin.y));
                let _e348 = abs(((bitcast<f32>(_e248) + (bitcast<f32>((((_e252 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e150.origin.z));
                if (_e336 > _e346) {
                    phi_940_ = _e336;
                } else {
                    phi_940_ = _e346;
                }
                let _e351 = phi_940_;
                if (_e337 > _e347) {
                    phi_945_ = _e337;
                } else {
                    phi_945_ = _e347;
                }
                let _e354 = phi_945_;
                if (_e338 > _e348) {
                    phi_950_ = _e338;
                } else {
                    phi_950_ = _e348;
                }
                let _e357 = phi_950_;
                let _e358 = core_intrinsics_maximum_number_nsz_f32_(_e351, _e354);
                let _e359 = core_intrinsics_maximum_number_nsz_f32_(_e358, _e357);
                let _e364 = (_e359 * 0.0000019073486f);
                let _e365 = (abs(_e304) * _e364);
                let _e366 = (abs(_e316) * _e364);
                let _e367 = (abs(_e328) * _e364);
                let _e371 = (_e359 * 0.0000009536743f);
                let _e372 = (abs(_e304) * _e371);
                let _e373 = (abs(_e316) * _e371);
                let _e374 = (abs(_e328) * _e371);
                let _e377 = abs(_e150.direction.x);
                let _e379 = abs(_e150.direction.y);
                let _e381 = abs(_e150.direction.z);
                if (_e377 >= _e379) {
                    if (_e377 >= _e381) {
                        phi_983_ = false;
                    } else {
                        phi_983_ = true;
                    }
                    let _e385 = phi_983_;
                    phi_984_ = _e385;
                } else {
                    phi_984_ = true;
                }
                let _e387 = phi_984_;
                if _e387 {
                    if (_e379 >= _e381) {
                        phi_992_ = 1u;
                    } else {
                        phi_992_ = 2u;
                    }
                    let _e390 = phi_992_;
                    phi_993_ = _e390;
                } else {
                    phi_993_ = 0u;
                }
                let _e392 = phi_993_;
                if (_e392 == 0u) {
                    phi_1012_ = vec3<f32>(_e150.direction.y, _e150.direction.z, _e150.direction.x);
                } else {
                    if (_e392 == 1u) {
                        phi_1011_ = vec3<f32>(_e150.direction.z, _e150.direction.x, _e150.direction.y);
                    } else {
                        phi_1011_ = _e150.direction;
                    }
                    let _e405 = phi_1011_;
                    phi_1012_ = _e405;
                }
                let _e407 = phi_1012_;
                let _e411 = (_e407.x / _e407.z);
                let _e414 = (_e407.y / _e407.z);
                if (_e304 < 0f) {
                    phi_1026_ = 0u;
                } else {
                    phi_1026_ = 1u;
                }
                let _e419 = phi_1026_;
                if (_e316 < 0f) {
                    phi_1031_ = 0u;
                } else {
                    phi_1031_ = 2u;
                }
                let _e422 = phi_1031_;
                if (_e328 < 0f) {
                    phi_1036_ = 0u;
                } else {
                    phi_1036_ = 4u;
                }
                let _e425 = phi_1036_;
                let _e427 = ((_e419 | _e422) | _e425);
                let _e428 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e428.first[0], _e428.first[1], _e428.first[2], _e428.first[3], _e428.first[4], _e428.first[5], _e428.first[6], _e428.first[7], _e428.first[8], _e428.first[9], _e428.first[10], _e428.first[11], _e428.first[12], _e428.first[13], _e428.first[14], _e428.first[15], _e428.first[16], _e428.first[17], _e428.first[18], _e428.first[19], _e428.first[20], _e428.first[21], _e428.first[22], _e428.first[23], _e428.first[24], _e428.first[25], _e428.first[26], _e428.first[27], _e428.first[28], _e428.first[29], _e428.first[30], _e428.first[31]), array<u32, 32>(_e428.mask[0], _e428.mask[1], _e428.mask[2], _e428.mask[3], _e428.mask[4], _e428.mask[5], _e428.mask[6], _e428.mask[7], _e428.mask[8], _e428.mask[9], _e428.mask[10], _e428.mask[11], _e428.mask[12], _e428.mask[13], _e428.mask[14], _e428.mask[15], _e428.mask[16], _e428.mask[17], _e428.mask[18], _e428.mask[19], _e428.mask[20], _e428.mask[21], _e428.mask[22], _e428.mask[23], _e428.mask[24], _e428.mask[25], _e428.mask[26], _e428.mask[27], _e428.mask[28], _e428.mask[29], _e428.mask[30], _e428.mask[31]), _e428.len, _e428.group, _e428.group_mask);
                let _e502 = local_1.group_mask;
                if ((_e502 & 4278190080u) == 0u) {
                    let _e506 = local_1.len;
                    if (_e506 == 0u) {
                        phi_1150_ = false;
                    } else {
                        let _e510 = local_1.len;
                        local_1.len = (_e510 - 1u);
                        let _e513 = local_1.len;
                        if (_e513 < 32u) {
                        } else {
                            return;
                        }
                        let _e518 = local_1.first[(0u + _e513)];
                        local_1.group = _e518;
                        let _e521 = local_1.len;
                        if (_e521 < 32u) {
                        } else {
                            return;
                        }
                        let _e526 = local_1.mask[(0u + _e521)];
                        local_1.group_mask = _e526;
                        phi_1150_ = true;
                    }
                    let _e529 = phi_1150_;
                    phi_1151_ = _e529;
                } else {
                    phi_1151_ = true;
                }
                let _e531 = phi_1151_;
                if _e531 {
                    let _e533 = local_1.group_mask;
                    let _e539 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e533)), 32u, (_e533 == 0u)));
                    let _e543 = local_1.group_mask;
                    let _e557 = local_1.group_mask;
                    local_1.group_mask = (_e557 & ~((1u << bitcast<u32>((_e539 & 31u)))));
                    let _e560 = local_1.group;
                    phi_1182_ = (_e560 + countOneBits(((_e543 & ~((4294967295u << bitcast<u32>((((_e539 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1182_ = 4294967295u;
                }
                let _e563 = phi_1182_;
                phi_1184_ = _e152;
                phi_1187_ = _e563;
                loop {
                    let _e565 = phi_1184_;
                    let _e567 = phi_1187_;
                    local_6 = _e565;
                    let _e568 = (_e567 != 4294967295u);
                    if _e568 {
                        if (_e567 < _e74) {
                        } else {
                            return;
                        }
                        let _e576 = nodes.member[(0u + _e567)].frame[3u];
                        let _e601 = (bitcast<f32>((((_e576 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e304);
                        let _e602 = (bitcast<f32>((((_e576 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e316);
                        let _e603 = (bitcast<f32>((((_e576 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e328);
                        let _e606 = nodes.member[(0u + _e567)].frame[0u];
                        let _e610 = nodes.member[(0u + _e567)].frame[1u];
                        let _e614 = nodes.member[(0u + _e567)].frame[2u];
                        let _e622 = ((bitcast<f32>(_e606) - _e150.origin.x) * _e304);
                        let _e623 = ((bitcast<f32>(_e610) - _e150.origin.y) * _e316);
                        let _e624 = ((bitcast<f32>(_e614) - _e150.origin.z) * _e328);
                        let _e632 = nodes.member[(0u + _e567)].x;
                        if (_e304 < 0f) {
                            let _e643 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e632.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e649 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e643.unnamed.word, _e632.w), _e643.unnamed_1);
                            let _e655 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e649.unnamed, lt_mask_LightPlace(_e632.x, _e649.unnamed_1.shift));
                            phi_1272_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e655.unnamed, lt_mask_LightPlace(_e655.unnamed_1.word, _e632.y));
                        } else {
                            let _e671 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e632.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e677 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e671.unnamed.word, _e632.y), _e671.unnamed_1);
                            let _e683 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e677.unnamed, lt_mask_LightPlace(_e632.z, _e677.unnamed_1.shift));
                            phi_1272_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e683.unnamed, lt_mask_LightPlace(_e683.unnamed_1.word, _e632.w));
                        }
                        let _e691 = phi_1272_;
                        let _e701 = nodes.member[(0u + _e567)].y;
                        if (_e316 < 0f) {
                            let _e712 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e701.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e718 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e712.unnamed.word, _e701.w), _e712.unnamed_1);
                            let _e724 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e718.unnamed, lt_mask_LightPlace(_e701.x, _e718.unnamed_1.shift));
                            phi_1299_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e724.unnamed, lt_mask_LightPlace(_e724.unnamed_1.word, _e701.y));
                        } else {
                            let _e740 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e701.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e746 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e740.unnamed.word, _e701.y), _e740.unnamed_1);
                            let _e752 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e746.unnamed, lt_mask_LightPlace(_e701.z, _e746.unnamed_1.shift));
                            phi_1299_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e752.unnamed, lt_mask_LightPlace(_e752.unnamed_1.word, _e701.w));
                        }
                        let _e760 = phi_1299_;
                        let _e770 = nodes.member[(0u + _e567)].z;
                        if (_e328 < 0f) {
                            let _e781 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e770.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e787 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e781.unnamed.word, _e770.w), _e781.unnamed_1);
                            let _e793 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e787.unnamed, lt_mask_LightPlace(_e770.x, _e787.unnamed_1.shift));
                            phi_1326_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e793.unnamed, lt_mask_LightPlace(_e793.unnamed_1.word, _e770.y));
                        } else {
                            let _e809 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e770.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e815 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e809.unnamed.word, _e770.y), _e809.unnamed_1);
                            let _e821 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e815.unnamed, lt_mask_LightPlace(_e770.z, _e815.unnamed_1.shift));
                            phi_1326_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e821.unnamed, lt_mask_LightPlace(_e821.unnamed_1.word, _e770.w));
                        }
                        let _e829 = phi_1326_;
                        phi_1332_ = 0u;
                        phi_1335_ = 0u;
                        loop {
                            let _e839 = phi_1332_;
                            let _e841 = phi_1335_;
                            local_2 = _e841;
                            local_3 = _e841;
                            local_4 = _e841;
                            let _e842 = (_e839 < 8u);
                            if _e842 {
                                let _e844 = (_e839 >> bitcast<u32>(2i));
                                let _e845 = (_e839 & 3u);
                                if (_e844 == 0u) {
                                    phi_1349_ = _e691.unnamed.word;
                                } else {
                                    phi_1349_ = _e691.unnamed.shift;
                                }
                                let _e848 = phi_1349_;
                                if (_e844 == 0u) {
                                    phi_1359_ = _e760.unnamed.word;
                                } else {
                                    phi_1359_ = _e760.unnamed.shift;
                                }
                                let _e857 = phi_1359_;
                                if (_e844 == 0u) {
                                    phi_1369_ = _e829.unnamed.word;
                                } else {
                                    phi_1369_ = _e829.unnamed.shift;
                                }
                                let _e866 = phi_1369_;
                                let _e879 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e848 >> bitcast<u32>(((_e845 * 8u) & 31u))) & 255u)) * _e601) + (_e622 - _e365)), ((f32(((_e857 >> bitcast<u32>(((_e845 * 8u) & 31u))) & 255u)) * _e602) + (_e623 - _e366)));
                                let _e880 = core_intrinsics_maximum_number_nsz_f32_(_e879, ((f32(((_e866 >> bitcast<u32>(((_e845 * 8u) & 31u))) & 255u)) * _e603) + (_e624 - _e367)));
                                if (_e844 == 0u) {
                                    phi_1387_ = _e691.unnamed_1.word;
                                } else {
                                    phi_1387_ = _e691.unnamed_1.shift;
                                }
                                let _e883 = phi_1387_;
                                if (_e844 == 0u) {
                                    phi_1397_ = _e760.unnamed_1.word;
                                } else {
                                    phi_1397_ = _e760.unnamed_1.shift;
                                }
                                let _e892 = phi_1397_;
                                if (_e844 == 0u) {
                                    phi_1407_ = _e829.unnamed_1.word;
                                } else {
                                    phi_1407_ = _e829.unnamed_1.shift;
                                }
                                let _e901 = phi_1407_;
                                let _e914 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e883 >> bitcast<u32>(((_e845 * 8u) & 31u))) & 255u)) * _e601) + (_e622 + _e365)), ((f32(((_e892 >> bitcast<u32>(((_e845 * 8u) & 31u))) & 255u)) * _e602) + (_e623 + _e366)));
                                let _e915 = core_intrinsics_minimum_number_nsz_f32_(_e914, ((f32(((_e901 >> bitcast<u32>(((_e845 * 8u) & 31u))) & 255u)) * _e603) + (_e624 + _e367)));
                                if (_e880 <= _e915) {
                                    if (_e880 <= _e565.t) {
                                        if (_e915 >= _e150.tmin) {
                                            if (_e844 == 0u) {
                                                let _e922 = nodes.member[(0u + _e567)].links[2u];
                                                phi_1443_ = _e922;
                                            } else {
                                                let _e925 = nodes.member[(0u + _e567)].links[3u];
                                                phi_1443_ = _e925;
                                            }
                                            let _e927 = phi_1443_;
                                            let _e932 = ((_e927 >> bitcast<u32>(((_e845 * 8u) & 31u))) & 255u);
                                            let _e933 = (_e932 & 31u);
                                            if (_e933 >= 24u) {
                                                phi_1456_ = (24u + ((_e933 - 24u) ^ _e427));
                                            } else {
                                                phi_1456_ = _e933;
                                            }
                                            let _e939 = phi_1456_;
                                            phi_1461_ = (_e841 | ((_e932 >> bitcast<u32>(5i)) << bitcast<u32>((_e939 & 31u))));
                                        } else {
                                            phi_1461_ = _e841;
                                        }
                                        let _e947 = phi_1461_;
                                        phi_1462_ = _e947;
                                    } else {
                                        phi_1462_ = _e841;
                                    }
                                    let _e949 = phi_1462_;
                                    phi_1463_ = _e949;
                                } else {
                                    phi_1463_ = _e841;
                                }
                                let _e951 = phi_1463_;
                                phi_1333_ = (_e839 + 1u);
                                phi_1336_ = _e951;
                            } else {
                                phi_1333_ = u32();
                                phi_1336_ = u32();
                            }
                            let _e954 = phi_1333_;
                            let _e956 = phi_1336_;
                            continue;
                            continuing {
                                phi_1332_ = _e954;
                                phi_1335_ = _e956;
                                break if !(_e842);
                            }
                        }
                        let _e960 = nodes.member[(0u + _e567)].links[0u];
                        let _e964 = nodes.member[(0u + _e567)].frame[3u];
                        let _e968 = local_2;
                        if ((_e968 & 4278190080u) == 0u) {
                        } else {
                            let _e972 = local_1.group_mask;
                            if ((_e972 & 4278190080u) == 0u) {
                            } else {
                                let _e976 = local_1.len;
                                if (_e976 < 32u) {
                                    let _e979 = local_1.group;
                                    let _e981 = local_1.len;
                                    if (_e981 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.first[(0u + _e981)] = _e979;
                                    let _e987 = local_1.group_mask;
                                    let _e989 = local_1.len;
                                    if (_e989 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.mask[(0u + _e989)] = _e987;
                                    let _e996 = local_1.len;
                                    local_1.len = (_e996 + 1u);
                                }
                            }
                            local_1.group = (0u + _e960);
                            let _e1000 = local_3;
                            local_1.group_mask = ((_e1000 & 4278190080u) | (_e964 >> bitcast<u32>(24i)));
                        }
                        let _e1005 = local_4;
                        phi_1521_ = _e565;
                        phi_1524_ = (_e1005 & 16777215u);
                        loop {
                            let _e1008 = phi_1521_;
                            let _e1010 = phi_1524_;
                            local_5 = _e1008;
                            if (_e1010 == 0u) {
                                phi_1522_ = lt_bvh_Hit();
                                phi_1525_ = u32();
                                phi_2183_ = false;
                            } else {
                                let _e1014 = nodes.member[(0u + _e567)].links[1u];
                                let _e1019 = ((0u + _e1014) + select(firstTrailingBit(_e1010), 32u, (_e1010 == 0u)));
                                if (_e1019 < _e77) {
                                } else {
                                    return;
                                }
                                let _e1026 = triangles.member[(0u + _e1019)].v0_;
                                let _e1029 = (_e1026.x - _e150.origin.x);
                                let _e1032 = (_e1026.y - _e150.origin.y);
                                let _e1035 = (_e1026.z - _e150.origin.z);
                                if (_e392 == 0u) {
                                    phi_1571_ = vec3<f32>(_e1032, _e1035, _e1029);
                                } else {
                                    if (_e392 == 1u) {
                                        phi_1570_ = vec3<f32>(_e1035, _e1029, _e1032);
                                    } else {
                                        phi_1570_ = (_e1026 - _e150.origin);
                                    }
                                    let _e1042 = phi_1570_;
                                    phi_1571_ = _e1042;
                                }
                                let _e1044 = phi_1571_;
                                let _e1048 = (_e1044.x - (_e411 * _e1044.z));
                                let _e1052 = (_e1044.y - (_e414 * _e1044.z));
                                let _e1054 = triangles.member[(0u + _e1019)].v1_;
                                let _e1057 = (_e1054.x - _e150.origin.x);
                                let _e1060 = (_e1054.y - _e150.origin.y);
                                let _e1063 = (_e1054.z - _e150.origin.z);
                                if (_e392 == 0u) {
                                    phi_1603_ = vec3<f32>(_e1060, _e1063, _e1057);
                                } else {
                                    if (_e392 == 1u) {
                                        phi_1602_ = vec3<f32>(_e1063, _e1057, _e1060);
                                    } else {
                                        phi_1602_ = (_e1054 - _e150.origin);
                                    }
                                    let _e1070 = phi_1602_;
                                    phi_1603_ = _e1070;
                                }
                                let _e1072 = phi_1603_;
                                let _e1076 = (_e1072.x - (_e411 * _e1072.z));
                                let _e1080 = (_e1072.y - (_e414 * _e1072.z));
                                let _e1082 = triangles.member[(0u + _e1019)].v2_;
                                let _e1085 = (_e1082.x - _e150.origin.x);
                                let _e1088 = (_e1082.y - _e150.origin.y);
                                let _e1091 = (_e1082.z - _e150.origin.z);
                                if (_e392 == 0u) {
                                    phi_1635_ = vec3<f32>(_e1088, _e1091, _e1085);
                                } else {
                                    if (_e392 == 1u) {
                                        phi_1634_ = vec3<f32>(_e1091, _e1085, _e1088);
                                    } else {
                                        phi_1634_ = (_e1082 - _e150.origin);
                                    }
                                    let _e1098 = phi_1634_;
                                    phi_1635_ = _e1098;
                                }
                                let _e1100 = phi_1635_;
                                let _e1104 = (_e1100.x - (_e411 * _e1100.z));
                                let _e1108 = (_e1100.y - (_e414 * _e1100.z));
                                if (_e1076 < _e1104) {
                                    phi_1654_ = true;
                                } else {
                                    if (_e1076 == _e1104) {
                                        phi_1653_ = (_e1080 < _e1108);
                                    } else {
                                        phi_1653_ = false;
                                    }
                                    let _e1113 = phi_1653_;
                                    phi_1654_ = _e1113;
                                }
                                let _e1115 = phi_1654_;
                                if _e1115 {
                                    phi_1658_ = _e1108;
                                    phi_1659_ = _e1104;
                                    phi_1660_ = _e1080;
                                    phi_1661_ = _e1076;
                                } else {
                                    phi_1658_ = _e1080;
                                    phi_1659_ = _e1076;
                                    phi_1660_ = _e1108;
                                    phi_1661_ = _e1104;
                                }
                                let _e1117 = phi_1658_;
                                let _e1119 = phi_1659_;
                                let _e1121 = phi_1660_;
                                let _e1123 = phi_1661_;
                                let _e1126 = ((_e1123 * _e1117) - (_e1121 * _e1119));
                                if _e1115 {
                                    phi_1669_ = -(_e1126);
                                } else {
                                    phi_1669_ = _e1126;
                                }
                                let _e1129 = phi_1669_;
                                if (_e1104 < _e1048) {
                                    phi_1680_ = true;
                                } else {
                                    if (_e1104 == _e1048) {
                                        phi_1679_ = (_e1108 < _e1052);
                                    } else {
                                        phi_1679_ = false;
                                    }
                                    let _e1134 = phi_1679_;
                                    phi_1680_ = _e1134;
                                }
                                let _e1136 = phi_1680_;
                                if _e1136 {
                                    phi_1684_ = _e1052;
                                    phi_1685_ = _e1048;
                                    phi_1686_ = _e1108;
                                    phi_1687_ = _e1104;
                                } else {
                                    phi_1684_ = _e1108;
                                    phi_1685_ = _e1104;
                                    phi_1686_ = _e1052;
                                    phi_1687_ = _e1048;
                                }
                                let _e1138 = phi_1684_;
                                let _e1140 = phi_1685_;
                                let _e1142 = phi_1686_;
                                let _e1144 = phi_1687_;
                                let _e1147 = ((_e1144 * _e1138) - (_e1142 * _e1140));
                                if _e1136 {
                                    phi_1695_ = -(_e1147);
                                } else {
                                    phi_1695_ = _e1147;
                                }
                                let _e1150 = phi_1695_;
                                if (_e1048 < _e1076) {
                                    phi_1706_ = true;
                                } else {
                                    if (_e1048 == _e1076) {
                                        phi_1705_ = (_e1052 < _e1080);
                                    } else {
                                        phi_1705_ = false;
                                    }
                                    let _e1155 = phi_1705_;
                                    phi_1706_ = _e1155;
                                }
                                let _e1157 = phi_1706_;
                                if _e1157 {
                                    phi_1710_ = _e1080;
                                    phi_1711_ = _e1076;
                                    phi_1712_ = _e1052;
                                    phi_1713_ = _e1048;
                                } else {
                                    phi_1710_ = _e1052;
                                    phi_1711_ = _e1048;
                                    phi_1712_ = _e1080;
                                    phi_1713_ = _e1076;
                                }
                                let _e1159 = phi_1710_;
                                let _e1161 = phi_1711_;
                                let _e1163 = phi_1712_;
                                let _e1165 = phi_1713_;
                                let _e1168 = ((_e1165 * _e1159) - (_e1163 * _e1161));
                                if _e1157 {
                                    phi_1721_ = -(_e1168);
                                } else {
                                    phi_1721_ = _e1168;
                                }
                                let _e1171 = phi_1721_;
                                if (_e1129 >= 0f) {
                                    if (_e1150 >= 0f) {
                                        if (_e1171 >= 0f) {
                                            phi_1736_ = ((_e1129 + _e1150) + _e1171);
                                            phi_1737_ = false;
                                        } else {
                                            phi_1736_ = f32();
                                            phi_1737_ = true;
                                        }
                                        let _e1178 = phi_1736_;
                                        let _e1180 = phi_1737_;
                                        phi_1738_ = _e1178;
                                        phi_1739_ = _e1180;
                                    } else {
                                        phi_1738_ = f32();
                                        phi_1739_ = true;
                                    }
                                    let _e1182 = phi_1738_;
                                    let _e1184 = phi_1739_;
                                    phi_1740_ = _e1182;
                                    phi_1741_ = _e1184;
                                } else {
                                    phi_1740_ = f32();
                                    phi_1741_ = true;
                                }
                                let _e1186 = phi_1740_;
                                let _e1188 = phi_1741_;
                                if _e1188 {
                                    if (_e1129 <= 0f) {
                                        if (_e1150 <= 0f) {
                                            let _e1191 = (_e1171 <= 0f);
                                            if _e1191 {
                                            }
                                            phi_1759_ = ((_e1129 + _e1150) + _e1171);
                                            phi_1760_ = false;
                                            phi_1761_ = _e1191;
                                        } else {
                                            phi_1759_ = f32();
                                            phi_1760_ = true;
                                            phi_1761_ = false;
                                        }
                                        let _e1195 = phi_1759_;
                                        let _e1197 = phi_1760_;
                                        let _e1199 = phi_1761_;
                                        phi_1762_ = _e1195;
                                        phi_1763_ = _e1197;
                                        phi_1764_ = _e1199;
                                    } else {
                                        phi_1762_ = f32();
                                        phi_1763_ = true;
                                        phi_1764_ = false;
                                    }
                                    let _e1201 = phi_1762_;
                                    let _e1203 = phi_1763_;
                                    let _e1205 = phi_1764_;
                                    if _e1203 {
                                        phi_1768_ = false;
                                    } else {
                                        phi_1768_ = _e1205;
                                    }
                                    let _e1207 = phi_1768_;
                                    phi_1769_ = _e1201;
                                    phi_1770_ = _e1207;
                                } else {
                                    phi_1769_ = _e1186;
                                    phi_1770_ = true;
                                }
                                let _e1209 = phi_1769_;
                                let _e1211 = phi_1770_;
                                if _e1211 {
                                    let _e1212 = (_e1209 == 0f);
                                    if _e1212 {
                                        phi_2096_ = lt_bvh_triangle_Intersection();
                                        phi_2097_ = false;
                                    } else {
                                        let _e1214 = triangles.member[(0u + _e1019)].v0_;
                                        let _e1217 = (_e1214.x - _e150.origin.x);
                                        let _e1220 = (_e1214.y - _e150.origin.y);
                                        let _e1223 = (_e1214.z - _e150.origin.z);
                                        if (_e392 == 0u) {
                                            phi_1801_ = vec3<f32>(_e1220, _e1223, _e1217);
                                        } else {
                                            if (_e392 == 1u) {
                                                phi_1800_ = vec3<f32>(_e1223, _e1217, _e1220);
                                            } else {
                                                phi_1800_ = (_e1214 - _e150.origin);
                                            }
                                            let _e1230 = phi_1800_;
                                            phi_1801_ = _e1230;
                                        }
                                        let _e1232 = phi_1801_;
                                        let _e1234 = triangles.member[(0u + _e1019)].v1_;
                                        let _e1236 = triangles.member[(0u + _e1019)].v0_;
                                        let _e1239 = (_e1234.x - _e1236.x);
                                        let _e1242 = (_e1234.y - _e1236.y);
                                        let _e1245 = (_e1234.z - _e1236.z);
                                        if (_e392 == 0u) {
                                            phi_1827_ = vec3<f32>(_e1242, _e1245, _e1239);
                                        } else {
                                            if (_e392 == 1u) {
                                                phi_1826_ = vec3<f32>(_e1245, _e1239, _e1242);
                                            } else {
                                                phi_1826_ = (_e1234 - _e1236);
                                            }
                                            let _e1252 = phi_1826_;
                                            phi_1827_ = _e1252;
                                        }
                                        let _e1254 = phi_1827_;
                                        let _e1256 = triangles.member[(0u + _e1019)].v2_;
                                        let _e1258 = triangles.member[(0u + _e1019)].v0_;
                                        let _e1261 = (_e1256.x - _e1258.x);
                                        let _e1264 = (_e1256.y - _e1258.y);
                                        let _e1267 = (_e1256.z - _e1258.z);
                                        if (_e392 == 0u) {
                                            phi_1853_ = vec3<f32>(_e1264, _e1267, _e1261);
                                        } else {
                                            if (_e392 == 1u) {
                                                phi_1852_ = vec3<f32>(_e1267, _e1261, _e1264);
                                            } else {
                                                phi_1852_ = (_e1256 - _e1258);
                                            }
                                            let _e1274 = phi_1852_;
                                            phi_1853_ = _e1274;
                                        }
                                        let _e1276 = phi_1853_;
                                        let _e1283 = ((_e1254.y * _e1276.z) - (_e1254.z * _e1276.y));
                                        let _e1290 = ((_e1254.z * _e1276.x) - (_e1254.x * _e1276.z));
                                        let _e1297 = ((_e1254.x * _e1276.y) - (_e1254.y * _e1276.x));
                                        let _e1311 = (((1f / _e407.z) * (((_e1283 * _e1232.x) + (_e1290 * _e1232.y)) + (_e1297 * _e1232.z))) / (((_e1283 * _e411) + (_e1290 * _e414)) + _e1297));
                                        if (_e1311 > _e150.tmin) {
                                            if (_e1311 < _e150.tmax) {
                                                let _e1317 = triangles.member[(0u + _e1019)].v0_;
                                                let _e1319 = triangles.member[(0u + _e1019)].v1_;
                                                if (_e1317.x < _e1319.x) {
                                                    phi_1911_ = _e1317.x;
                                                } else {
                                                    phi_1911_ = _e1319.x;
                                                }
                                                let _e1326 = phi_1911_;
                                                if (_e1317.y < _e1319.y) {
                                                    phi_1920_ = _e1317.y;
                                                } else {
                                                    phi_1920_ = _e1319.y;
                                                }
                                                let _e1333 = phi_1920_;
                                                if (_e1317.z < _e1319.z) {
                                                    phi_1929_ = _e1317.z;
                                                } else {
                                                    phi_1929_ = _e1319.z;
                                                }
                                                let _e1340 = phi_1929_;
                                                let _e1342 = triangles.member[(0u + _e1019)].v2_;
                                                if (_e1326 < _e1342.x) {
                                                    phi_1938_ = _e1326;
                                                } else {
                                                    phi_1938_ = _e1342.x;
                                                }
                                                let _e1347 = phi_1938_;
                                                if (_e1333 < _e1342.y) {
                                                    phi_1945_ = _e1333;
                                                } else {
                                                    phi_1945_ = _e1342.y;
                                                }
                                                let _e1352 = phi_1945_;
                                                if (_e1340 < _e1342.z) {
                                                    phi_1952_ = _e1340;
                                                } else {
                                                    phi_1952_ = _e1342.z;
                                                }
                                                let _e1357 = phi_1952_;
                                                let _e1359 = triangles.member[(0u + _e1019)].v0_;
                                                let _e1361 = triangles.member[(0u + _e1019)].v1_;
                                                if (_e1359.x > _e1361.x) {
                                                    phi_1965_ = _e1359.x;
                                                } else {
                                                    phi_1965_ = _e1361.x;
                                                }
                                                let _e1368 = phi_1965_;
                                                if (_e1359.y > _e1361.y) {
                                                    phi_1974_ = _e1359.y;
                                                } else {
                                                    phi_1974_ = _e1361.y;
                                                }
                                                let _e1375 = phi_1974_;
                                                if (_e1359.z > _e1361.z) {
                                                    phi_1983_ = _e1359.z;
                                                } else {
                                                    phi_1983_ = _e1361.z;
                                                }
                                                let _e1382 = phi_1983_;
                                                let _e1384 = triangles.member[(0u + _e1019)].v2_;
                                                if (_e1368 > _e1384.x) {
                                                    phi_1992_ = _e1368;
                                                } else {
                                                    phi_1992_ = _e1384.x;
                                                }
                                                let _e1389 = phi_1992_;
                                                if (_e1375 > _e1384.y) {
                                                    phi_1999_ = _e1375;
                                                } else {
                                                    phi_1999_ = _e1384.y;
                                                }
                                                let _e1394 = phi_1999_;
                                                if (_e1382 > _e1384.z) {
                                                    phi_2006_ = _e1382;
                                                } else {
                                                    phi_2006_ = _e1384.z;
                                                }
                                                let _e1399 = phi_2006_;
                                                let _e1406 = ((_e1347 - _e150.origin.x) * _e304);
                                                let _e1407 = ((_e1352 - _e150.origin.y) * _e316);
                                                let _e1408 = ((_e1357 - _e150.origin.z) * _e328);
                                                let _e1415 = ((_e1389 - _e150.origin.x) * _e304);
                                                let _e1416 = ((_e1394 - _e150.origin.y) * _e316);
                                                let _e1417 = ((_e1399 - _e150.origin.z) * _e328);
                                                if (_e1406 < _e1415) {
                                                    phi_2029_ = _e1406;
                                                } else {
                                                    phi_2029_ = _e1415;
                                                }
                                                let _e1420 = phi_2029_;
                                                if (_e1407 < _e1416) {
                                                    phi_2034_ = _e1407;
                                                } else {
                                                    phi_2034_ = _e1416;
                                                }
                                                let _e1423 = phi_2034_;
                                                if (_e1408 < _e1417) {
                                                    phi_2039_ = _e1408;
                                                } else {
                                                    phi_2039_ = _e1417;
                                                }
                                                let _e1426 = phi_2039_;
                                                if (_e1406 > _e1415) {
                                                    phi_2047_ = _e1406;
                                                } else {
                                                    phi_2047_ = _e1415;
                                                }
                                                let _e1432 = phi_2047_;
                                                if (_e1407 > _e1416) {
                                                    phi_2052_ = _e1407;
                                                } else {
                                                    phi_2052_ = _e1416;
                                                }
                                                let _e1435 = phi_2052_;
                                                if (_e1408 > _e1417) {
                                                    phi_2057_ = _e1408;
                                                } else {
                                                    phi_2057_ = _e1417;
                                                }
                                                let _e1438 = phi_2057_;
                                                let _e1442 = core_intrinsics_maximum_number_nsz_f32_((_e1420 - _e372), (_e1423 - _e373));
                                                let _e1443 = core_intrinsics_maximum_number_nsz_f32_(_e1442, (_e1426 - _e374));
                                                let _e1444 = core_intrinsics_minimum_number_nsz_f32_((_e1432 + _e372), (_e1435 + _e373));
                                                let _e1445 = core_intrinsics_minimum_number_nsz_f32_(_e1444, (_e1438 + _e374));
                                                if (_e1443 > -300000000000000000000000000000000000000f) {
                                                    phi_2069_ = _e1443;
                                                } else {
                                                    phi_2069_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1448 = phi_2069_;
                                                if (_e1445 < 300000000000000000000000000000000000000f) {
                                                    phi_2074_ = _e1445;
                                                } else {
                                                    phi_2074_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1451 = phi_2074_;
                                                if (_e1311 < _e1448) {
                                                    phi_2079_ = _e1448;
                                                } else {
                                                    phi_2079_ = _e1311;
                                                }
                                                let _e1454 = phi_2079_;
                                                if (_e1454 > _e1451) {
                                                    phi_2084_ = _e1451;
                                                } else {
                                                    phi_2084_ = _e1454;
                                                }
                                                let _e1457 = phi_2084_;
                                                phi_2089_ = lt_bvh_triangle_Intersection(_e1457, (_e1150 / _e1209), (_e1171 / _e1209), (_e1448 <= _e1451));
                                                phi_2090_ = false;
                                            } else {
                                                phi_2089_ = lt_bvh_triangle_Intersection();
                                                phi_2090_ = true;
                                            }
                                            let _e1463 = phi_2089_;
                                            let _e1465 = phi_2090_;
                                            phi_2091_ = _e1463;
                                            phi_2092_ = _e1465;
                                        } else {
                                            phi_2091_ = lt_bvh_triangle_Intersection();
                                            phi_2092_ = true;
                                        }
                                        let _e1467 = phi_2091_;
                                        let _e1469 = phi_2092_;
                                        if _e1469 {
                                        }
                                        phi_2096_ = _e1467;
                                        phi_2097_ = _e1469;
                                    }
                                    let _e1471 = phi_2096_;
                                    let _e1473 = phi_2097_;
                                    phi_2098_ = _e1471;
                                    phi_2099_ = _e1212;
                                    phi_2100_ = _e1473;
                                } else {
                                    phi_2098_ = lt_bvh_triangle_Intersection();
                                    phi_2099_ = true;
                                    phi_2100_ = false;
                                }
                                let _e1475 = phi_2098_;
                                let _e1477 = phi_2099_;
                                let _e1479 = phi_2100_;
                                if _e1477 {
                                    phi_2104_ = true;
                                } else {
                                    phi_2104_ = _e1479;
                                }
                                let _e1481 = phi_2104_;
                                if _e1481 {
                                    phi_2108_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_2108_ = _e1475;
                                }
                                let _e1483 = phi_2108_;
                                if _e1483.is_hit {
                                    if (_e1483.t > _e150.tmin) {
                                        if (_e1483.t < _e1008.t) {
                                            phi_2157_ = true;
                                        } else {
                                            if (_e1483.t == _e1008.t) {
                                                if (_e1008.triangle != 4294967295u) {
                                                    if (_e1019 < _e1008.triangle) {
                                                        phi_2148_ = true;
                                                    } else {
                                                        if (_e1019 == _e1008.triangle) {
                                                            phi_2147_ = (4294967295u < _e1008.instance);
                                                        } else {
                                                            phi_2147_ = false;
                                                        }
                                                        let _e1502 = phi_2147_;
                                                        phi_2148_ = _e1502;
                                                    }
                                                    let _e1504 = phi_2148_;
                                                    phi_2149_ = _e1504;
                                                    phi_2150_ = false;
                                                } else {
                                                    phi_2149_ = bool();
                                                    phi_2150_ = true;
                                                }
                                                let _e1506 = phi_2149_;
                                                let _e1508 = phi_2150_;
                                                phi_2151_ = _e1506;
                                                phi_2152_ = _e1508;
                                            } else {
                                                phi_2151_ = bool();
                                                phi_2152_ = true;
                                            }
                                            let _e1510 = phi_2151_;
                                            let _e1512 = phi_2152_;
                                            if _e1512 {
                                                phi_2156_ = false;
                                            } else {
                                                phi_2156_ = _e1510;
                                            }
                                            let _e1514 = phi_2156_;
                                            phi_2157_ = _e1514;
                                        }
                                        let _e1516 = phi_2157_;
                                        if _e1516 {
                                            let _e1518 = triangles.member[(0u + _e1019)].i0_;
                                            if ((_e1518 & 2147483648u) == 0u) {
                                                phi_2171_ = true;
                                            } else {
                                                if true {
                                                }
                                                phi_2171_ = true;
                                            }
                                            let _e1522 = phi_2171_;
                                            if _e1522 {
                                                phi_2179_ = lt_bvh_Hit(_e1483.t, _e1483.u, _e1483.v, _e1019, 4294967295u);
                                            } else {
                                                phi_2179_ = _e1008;
                                            }
                                            let _e1528 = phi_2179_;
                                            phi_2180_ = _e1528;
                                        } else {
                                            phi_2180_ = _e1008;
                                        }
                                        let _e1530 = phi_2180_;
                                        phi_2181_ = _e1530;
                                    } else {
                                        phi_2181_ = _e1008;
                                    }
                                    let _e1532 = phi_2181_;
                                    phi_2182_ = _e1532;
                                } else {
                                    phi_2182_ = _e1008;
                                }
                                let _e1534 = phi_2182_;
                                phi_1522_ = _e1534;
                                phi_1525_ = (_e1010 & (_e1010 - 1u));
                                phi_2183_ = true;
                            }
                            let _e1536 = phi_1522_;
                            let _e1538 = phi_1525_;
                            let _e1540 = phi_2183_;
                            continue;
                            continuing {
                                phi_1521_ = _e1536;
                                phi_1524_ = _e1538;
                                break if !(_e1540);
                            }
                        }
                        let _e1543 = local_1.group_mask;
                        if ((_e1543 & 4278190080u) == 0u) {
                            let _e1547 = local_1.len;
                            if (_e1547 == 0u) {
                                phi_2222_ = false;
                            } else {
                                let _e1551 = local_1.len;
                                local_1.len = (_e1551 - 1u);
                                let _e1554 = local_1.len;
                                if (_e1554 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1559 = local_1.first[(0u + _e1554)];
                                local_1.group = _e1559;
                                let _e1562 = local_1.len;
                                if (_e1562 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1567 = local_1.mask[(0u + _e1562)];
                                local_1.group_mask = _e1567;
                                phi_2222_ = true;
                            }
                            let _e1570 = phi_2222_;
                            phi_2223_ = _e1570;
                        } else {
                            phi_2223_ = true;
                        }
                        let _e1572 = phi_2223_;
                        if _e1572 {
                            let _e1574 = local_1.group_mask;
                            let _e1580 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1574)), 32u, (_e1574 == 0u)));
                            let _e1584 = local_1.group_mask;
                            let _e1598 = local_1.group_mask;
                            local_1.group_mask = (_e1598 & ~((1u << bitcast<u32>((_e1580 & 31u)))));
                            let _e1601 = local_1.group;
                            phi_2254_ = (_e1601 + countOneBits(((_e1584 & ~((4294967295u << bitcast<u32>((((_e1580 - 24u) ^ _e427) & 31u))))) & 255u)));
                        } else {
                            phi_2254_ = 4294967295u;
                        }
                        let _e1604 = phi_2254_;
                        let _e2448 = local_5;
                        phi_1185_ = _e2448;
                        phi_1188_ = _e1604;
                    } else {
                        phi_1185_ = lt_bvh_Hit();
                        phi_1188_ = u32();
                    }
                    let _e1606 = phi_1185_;
                    let _e1608 = phi_1188_;
                    continue;
                    continuing {
                        phi_1184_ = _e1606;
                        phi_1187_ = _e1608;
                        break if !(_e568);
                    }
                }
                let _e2452 = local_6;
                phi_2255_ = _e2452;
            }
            let _e1611 = phi_2255_;
            phi_2256_ = _e1611;
            phi_2257_ = _e222;
        } else {
            phi_2256_ = lt_bvh_Hit();
            phi_2257_ = true;
        }
        let _e1613 = phi_2256_;
        let _e1615 = phi_2257_;
        if _e1615 {
            phi_2261_ = _e152;
        } else {
            phi_2261_ = _e1613;
        }
        let _e1617 = phi_2261_;
        if (_e1617.triangle != 4294967295u) {
            let _e1623 = ((1f - _e1617.u) - _e1617.v);
            if (_e1617.triangle < _e77) {
            } else {
                return;
            }
            let _e1628 = triangles.member[(0u + _e1617.triangle)];
            let _e1653 = (((_e1628.v0_.x * _e1623) + (_e1628.v1_.x * _e1617.u)) + (_e1628.v2_.x * _e1617.v));
            let _e1654 = (((_e1628.v0_.y * _e1623) + (_e1628.v1_.y * _e1617.u)) + (_e1628.v2_.y * _e1617.v));
            let _e1655 = (((_e1628.v0_.z * _e1623) + (_e1628.v1_.z * _e1617.u)) + (_e1628.v2_.z * _e1617.v));
            let _e1658 = abs(_e1628.v0_.x);
            let _e1660 = abs(_e1628.v0_.y);
            let _e1662 = abs(_e1628.v0_.z);
            let _e1664 = abs(_e1628.v1_.x);
            let _e1666 = abs(_e1628.v1_.y);
            let _e1668 = abs(_e1628.v1_.z);
            if (_e1658 > _e1664) {
                phi_2325_ = _e1658;
            } else {
                phi_2325_ = _e1664;
            }
            let _e1671 = phi_2325_;
            if (_e1660 > _e1666) {
                phi_2330_ = _e1660;
            } else {
                phi_2330_ = _e1666;
            }
            let _e1674 = phi_2330_;
            if (_e1662 > _e1668) {
                phi_2335_ = _e1662;
            } else {
                phi_2335_ = _e1668;
            }
            let _e1677 = phi_2335_;
            let _e1679 = abs(_e1628.v2_.x);
            let _e1681 = abs(_e1628.v2_.y);
            let _e1683 = abs(_e1628.v2_.z);
            if (_e1671 > _e1679) {
                phi_2346_ = _e1671;
            } else {
                phi_2346_ = _e1679;
            }
            let _e1686 = phi_2346_;
            if (_e1674 > _e1681) {
                phi_2351_ = _e1674;
            } else {
                phi_2351_ = _e1681;
            }
            let _e1689 = phi_2351_;
            if (_e1677 > _e1683) {
                phi_2356_ = _e1677;
            } else {
                phi_2356_ = _e1683;
            }
            let _e1692 = phi_2356_;
            let _e1695 = (_e1628.v1_.x - _e1628.v0_.x);
            let _e1698 = (_e1628.v1_.y - _e1628.v0_.y);
            let _e1701 = (_e1628.v1_.z - _e1628.v0_.z);
            let _e1704 = (_e1628.v2_.x - _e1628.v0_.x);
            let _e1707 = (_e1628.v2_.y - _e1628.v0_.y);
            let _e1710 = (_e1628.v2_.z - _e1628.v0_.z);
            let _e1714 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1698), abs(_e1701));
            let _e1715 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1695), _e1714);
            let _e1716 = (_e1695 / _e1715);
            let _e1717 = (_e1698 / _e1715);
            let _e1718 = (_e1701 / _e1715);
            let _e1722 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1707), abs(_e1710));
            let _e1723 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1704), _e1722);
            let _e1724 = (_e1704 / _e1723);
            let _e1725 = (_e1707 / _e1723);
            let _e1726 = (_e1710 / _e1723);
            let _e1729 = ((_e1717 * _e1726) - (_e1725 * _e1718));
            let _e1732 = ((_e1718 * _e1724) - (_e1726 * _e1716));
            let _e1735 = ((_e1716 * _e1725) - (_e1724 * _e1717));
            let _e1737 = p.member.eye;
            let _e1750 = (1f / sqrt((((_e1729 * _e1729) + (_e1732 * _e1732)) + (_e1735 * _e1735))));
            let _e1751 = (_e1729 * _e1750);
            let _e1752 = (_e1732 * _e1750);
            let _e1753 = (_e1735 * _e1750);
            if ((((_e1751 * (_e1737.x - _e1653)) + (_e1752 * (_e1737.y - _e1654))) + (_e1753 * (_e1737.z - _e1655))) < 0f) {
                phi_2432_ = vec3<f32>(-(_e1751), -(_e1752), -(_e1753));
            } else {
                phi_2432_ = vec3<f32>(_e1751, _e1752, _e1753);
            }
            let _e1766 = phi_2432_;
            if (_e1617.triangle < _e77) {
            } else {
                return;
            }
            let _e1771 = triangles.member[(0u + _e1617.triangle)];
            let _e1773 = (_e1771.i0_ & 2147483647u);
            if (_e1773 < _e80) {
            } else {
                return;
            }
            let _e1779 = vertices.member[(0u + _e1773)];
            if (_e1771.i1_ < _e80) {
            } else {
                return;
            }
            let _e1783 = vertices.member[(0u + _e1771.i1_)];
            if (_e1771.i2_ < _e80) {
            } else {
                return;
            }
            let _e1787 = vertices.member[(0u + _e1771.i2_)];
            let _e1788 = array<abi_Vertex, 3>(_e1779, _e1783, _e1787);
            if (_e1788[0].material < arrayLength((&materials.member))) {
            } else {
                return;
            }
            let _e1794 = materials.member[(0u + _e1788[0].material)];
            let _e1811 = (1f / 255f);
            let _e1830 = (1f / 255f);
            let _e1852 = (1f / 255f);
            if (_e1794.color_size == 0u) {
                phi_2675_ = vec3<f32>(1f, 1f, 1f);
            } else {
                local.offset = _e1794.color_offset;
                local.size = _e1794.color_size;
                local.flags = _e1794.flags;
                let _e1895 = _lt_shaders_texture_TextureView_quad((&local), (((_e1788[0].u * _e1623) + (_e1788[1].u * _e1617.u)) + (_e1788[2].u * _e1617.v)), (((_e1788[0].v * _e1623) + (_e1788[1].v * _e1617.u)) + (_e1788[2].v * _e1617.v)));
                if (_e1895.indices[0] < _e89) {
                } else {
                    return;
                }
                let _e1901 = color_texels.member[(0u + _e1895.indices[0])];
                let _e1912 = (1f / 255f);
                if (_e1895.indices[1] < _e89) {
                } else {
                    return;
                }
                let _e1926 = color_texels.member[(0u + _e1895.indices[1])];
                let _e1937 = (1f / 255f);
                if (_e1895.indices[2] < _e89) {
                } else {
                    return;
                }
                let _e1954 = color_texels.member[(0u + _e1895.indices[2])];
                let _e1965 = (1f / 255f);
                if (_e1895.indices[3] < _e89) {
                } else {
                    return;
                }
                let _e1982 = color_texels.member[(0u + _e1895.indices[3])];
                let _e1993 = (1f / 255f);
                let _e2002 = (((((f32((_e1901 & 255u)) * _e1912) * _e1895.weights.x) + ((f32((_e1926 & 255u)) * _e1937) * _e1895.weights.y)) + ((f32((_e1954 & 255u)) * _e1965) * _e1895.weights.z)) + ((f32((_e1982 & 255u)) * _e1993) * _e1895.weights.w));
                let _e2003 = (((((f32(((_e1901 >> bitcast<u32>(8i)) & 255u)) * _e1912) * _e1895.weights.x) + ((f32(((_e1926 >> bitcast<u32>(8i)) & 255u)) * _e1937) * _e1895.weights.y)) + ((f32(((_e1954 >> bitcast<u32>(8i)) & 255u)) * _e1965) * _e1895.weights.z)) + ((f32(((_e1982 >> bitcast<u32>(8i)) & 255u)) * _e1993) * _e1895.weights.w));
                let _e2004 = (((((f32(((_e1901 >> bitcast<u32>(16i)) & 255u)) * _e1912) * _e1895.weights.x) + ((f32(((_e1926 >> bitcast<u32>(16i)) & 255u)) * _e1937) * _e1895.weights.y)) + ((f32(((_e1954 >> bitcast<u32>(16i)) & 255u)) * _e1965) * _e1895.weights.z)) + ((f32(((_e1982 >> bitcast<u32>(16i)) & 255u)) * _e1993) * _e1895.weights.w));
                phi_2675_ = vec3<f32>((_e2002 * _e2002), (_e2003 * _e2003), (_e2004 * _e2004));
            }
            let _e2010 = phi_2675_;
            let _e2012 = ((_e1794.base_color.x * ((((f32((_e1788[0].color & 255u)) * _e1811) * _e1623) + ((f32((_e1788[1].color & 255u)) * _e1830) * _e1617.u)) + ((f32((_e1788[2].color & 255u)) * _e1852) * _e1617.v))) * _e2010.x);
            let _e2014 = ((_e1794.base_color.y * ((((f32(((_e1788[0].color >> bitcast<u32>(8i)) & 255u)) * _e1811) * _e1623) + ((f32(((_e1788[1].color >> bitcast<u32>(8i)) & 255u)) * _e1830) * _e1617.u)) + ((f32(((_e1788[2].color >> bitcast<u32>(8i)) & 255u)) * _e1852) * _e1617.v))) * _e2010.y);
            let _e2016 = ((_e1794.base_color.z * ((((f32(((_e1788[0].color >> bitcast<u32>(16i)) & 255u)) * _e1811) * _e1623) + ((f32(((_e1788[1].color >> bitcast<u32>(16i)) & 255u)) * _e1830) * _e1617.u)) + ((f32(((_e1788[2].color >> bitcast<u32>(16i)) & 255u)) * _e1852) * _e1617.v))) * _e2010.z);
            let _e2017 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1689, _e1692);
            let _e2018 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1686, _e2017);
            if ((_e1794.flags & 2u) == 0u) {
                phi_2690_ = 0u;
            } else {
                phi_2690_ = 1u;
            }
            let _e2023 = phi_2690_;
            if (_e1788[0].normal == 2147516416u) {
                phi_2893_ = _e1766;
            } else {
                let _e2036 = (f32((bitcast<i32>((_e1788[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2042 = (f32((bitcast<i32>(_e1788[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2046 = ((1f - abs(_e2036)) - abs(_e2042));
                if (_e2046 < 0f) {
                    phi_2717_ = -(_e2046);
                } else {
                    phi_2717_ = 0f;
                }
                let _e2050 = phi_2717_;
                if (_e2036 < 0f) {
                    phi_2724_ = (_e2036 + _e2050);
                } else {
                    phi_2724_ = (_e2036 - _e2050);
                }
                let _e2055 = phi_2724_;
                if (_e2042 < 0f) {
                    phi_2731_ = (_e2042 + _e2050);
                } else {
                    phi_2731_ = (_e2042 - _e2050);
                }
                let _e2060 = phi_2731_;
                let _e2067 = (1f / sqrt((((_e2055 * _e2055) + (_e2060 * _e2060)) + (_e2046 * _e2046))));
                let _e2083 = (f32((bitcast<i32>((_e1788[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2089 = (f32((bitcast<i32>(_e1788[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2093 = ((1f - abs(_e2083)) - abs(_e2089));
                if (_e2093 < 0f) {
                    phi_2766_ = -(_e2093);
                } else {
                    phi_2766_ = 0f;
                }
                let _e2097 = phi_2766_;
                if (_e2083 < 0f) {
                    phi_2773_ = (_e2083 + _e2097);
                } else {
                    phi_2773_ = (_e2083 - _e2097);
                }
                let _e2102 = phi_2773_;
                if (_e2089 < 0f) {
                    phi_2780_ = (_e2089 + _e2097);
                } else {
                    phi_2780_ = (_e2089 - _e2097);
                }
                let _e2107 = phi_2780_;
                let _e2114 = (1f / sqrt((((_e2102 * _e2102) + (_e2107 * _e2107)) + (_e2093 * _e2093))));
                let _e2133 = (f32((bitcast<i32>((_e1788[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2139 = (f32((bitcast<i32>(_e1788[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2143 = ((1f - abs(_e2133)) - abs(_e2139));
                if (_e2143 < 0f) {
                    phi_2818_ = -(_e2143);
                } else {
                    phi_2818_ = 0f;
                }
                let _e2147 = phi_2818_;
                if (_e2133 < 0f) {
                    phi_2825_ = (_e2133 + _e2147);
                } else {
                    phi_2825_ = (_e2133 - _e2147);
                }
                let _e2152 = phi_2825_;
                if (_e2139 < 0f) {
                    phi_2832_ = (_e2139 + _e2147);
                } else {
                    phi_2832_ = (_e2139 - _e2147);
                }
                let _e2157 = phi_2832_;
                let _e2164 = (1f / sqrt((((_e2152 * _e2152) + (_e2157 * _e2157)) + (_e2143 * _e2143))));
                let _e2175 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(vec3<f32>(((((_e2055 * _e2067) * _e1623) + ((_e2102 * _e2114) * _e1617.u)) + ((_e2152 * _e2164) * _e1617.v)), ((((_e2060 * _e2067) * _e1623) + ((_e2107 * _e2114) * _e1617.u)) + ((_e2157 * _e2164) * _e1617.v)), ((((_e2046 * _e2067) * _e1623) + ((_e2093 * _e2114) * _e1617.u)) + ((_e2143 * _e2164) * _e1617.v))));
                let _e2187 = sqrt((((_e2175.x * _e2175.x) + (_e2175.y * _e2175.y)) + (_e2175.z * _e2175.z)));
                if (_e2187 > 0f) {
                    let _e2190 = (_e2175.x / _e2187);
                    let _e2192 = (_e2175.y / _e2187);
                    let _e2194 = (_e2175.z / _e2187);
                    if ((((_e2190 * _e1766.x) + (_e2192 * _e1766.y)) + (_e2194 * _e1766.z)) < 0f) {
                        phi_2891_ = vec3<f32>(-(_e2190), -(_e2192), -(_e2194));
                    } else {
                        phi_2891_ = (_e2175 / vec3(_e2187));
                    }
                    let _e2211 = phi_2891_;
                    phi_2892_ = _e2211;
                } else {
                    phi_2892_ = _e1766;
                }
                let _e2213 = phi_2892_;
                phi_2893_ = _e2213;
            }
            let _e2215 = phi_2893_;
            if (_e2012 > 0f) {
                if (_e2012 < 1f) {
                    phi_2902_ = _e2012;
                } else {
                    phi_2902_ = 1f;
                }
                let _e2219 = phi_2902_;
                phi_2903_ = _e2219;
            } else {
                phi_2903_ = 0f;
            }
            let _e2221 = phi_2903_;
            if (_e2014 > 0f) {
                if (_e2014 < 1f) {
                    phi_2913_ = _e2014;
                } else {
                    phi_2913_ = 1f;
                }
                let _e2226 = phi_2913_;
                phi_2914_ = _e2226;
            } else {
                phi_2914_ = 0f;
            }
            let _e2228 = phi_2914_;
            if (_e2016 > 0f) {
                if (_e2016 < 1f) {
                    phi_2924_ = _e2016;
                } else {
                    phi_2924_ = 1f;
                }
                let _e2233 = phi_2924_;
                phi_2925_ = _e2233;
            } else {
                phi_2925_ = 0f;
            }
            let _e2235 = phi_2925_;
            let _e2238 = ((sqrt(_e2221) * 255f) + 0.5f);
            let _e2247 = ((sqrt(_e2228) * 255f) + 0.5f);
            let _e2259 = ((sqrt(_e2235) * 255f) + 0.5f);
            phi_2960_ = abi_Sample(vec3<f32>(_e1653, _e1654, _e1655), _e2018, _e1766, _e2023, _e2215, ((select(select(u32(_e2238), 0u, (_e2238 < bitcast<f32>(0u))), 4294967295u, (_e2238 > bitcast<f32>(1333788671u))) | (select(select(u32(_e2247), 0u, (_e2247 < bitcast<f32>(0u))), 4294967295u, (_e2247 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e2259), 0u, (_e2259 < bitcast<f32>(0u))), 4294967295u, (_e2259 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_2960_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e2273 = phi_2960_;
        if (_e95.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e95.shift)] = _e2273;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_color_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
