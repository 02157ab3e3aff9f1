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
    var phi_207_: lt_mask_LightPlace;
    var phi_208_: bool;
    var phi_209_: lt_mask_LightPlace;
    var phi_210_: bool;
    var phi_215_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_207_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_208_ = false;
        } else {
            phi_207_ = lt_mask_LightPlace();
            phi_208_ = true;
        }
        let _e81 = phi_207_;
        let _e83 = phi_208_;
        phi_209_ = _e81;
        phi_210_ = _e83;
    } else {
        phi_209_ = lt_mask_LightPlace();
        phi_210_ = true;
    }
    let _e85 = phi_209_;
    let _e87 = phi_210_;
    if _e87 {
        phi_215_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_215_ = _e85;
    }
    let _e92 = phi_215_;
    return lt_mask_LightPlace(_e92.word, _e92.shift);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_230_: bool;
    var phi_234_: f32;

    if (param_3 != param_3) {
        phi_230_ = true;
    } else {
        let _e71 = (param_4 >= param_3);
        if _e71 {
        }
        phi_230_ = _e71;
    }
    let _e73 = phi_230_;
    if _e73 {
        phi_234_ = param_4;
    } else {
        phi_234_ = param_3;
    }
    let _e75 = phi_234_;
    return _e75;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_246_: bool;
    var phi_250_: f32;

    if (param_5 != param_5) {
        phi_246_ = true;
    } else {
        let _e71 = (param_6 <= param_5);
        if _e71 {
        }
        phi_246_ = _e71;
    }
    let _e73 = phi_246_;
    if _e73 {
        phi_250_ = param_6;
    } else {
        phi_250_ = param_5;
    }
    let _e75 = phi_250_;
    return _e75;
}

fn _lt_shaders_texture_TextureView_quad(param_7: ptr<function, texture_TextureView>, param_8: f32, param_9: f32) -> texture_TexelQuad {
    var phi_292_: f32;
    var phi_297_: f32;
    var phi_298_: bool;
    var phi_299_: f32;
    var phi_300_: bool;
    var phi_304_: f32;
    var phi_330_: f32;
    var phi_335_: f32;
    var phi_336_: bool;
    var phi_337_: f32;
    var phi_338_: bool;
    var phi_342_: f32;
    var phi_350_: f32;
    var phi_351_: f32;
    var phi_352_: f32;
    var phi_361_: f32;
    var phi_362_: f32;
    var phi_380_: u32;
    var phi_394_: u32;
    var phi_401_: u32;
    var phi_406_: u32;
    var phi_412_: u32;
    var phi_417_: u32;
    var phi_419_: texture_Axis;
    var phi_447_: f32;
    var phi_452_: f32;
    var phi_453_: bool;
    var phi_454_: f32;
    var phi_455_: bool;
    var phi_459_: f32;
    var phi_485_: f32;
    var phi_490_: f32;
    var phi_491_: bool;
    var phi_492_: f32;
    var phi_493_: bool;
    var phi_497_: f32;
    var phi_505_: f32;
    var phi_506_: f32;
    var phi_507_: f32;
    var phi_516_: f32;
    var phi_517_: f32;
    var phi_535_: u32;
    var phi_549_: u32;
    var phi_556_: u32;
    var phi_561_: u32;
    var phi_567_: u32;
    var phi_572_: u32;
    var phi_574_: texture_Axis;

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
                phi_292_ = 1f;
            } else {
                phi_292_ = 0f;
            }
            let _e102 = phi_292_;
            if (param_8 < 8388608f) {
                phi_297_ = (_e99 - _e102);
                phi_298_ = false;
            } else {
                phi_297_ = f32();
                phi_298_ = true;
            }
            let _e105 = phi_297_;
            let _e107 = phi_298_;
            phi_299_ = _e105;
            phi_300_ = _e107;
        } else {
            phi_299_ = f32();
            phi_300_ = true;
        }
        let _e109 = phi_299_;
        let _e111 = phi_300_;
        if _e111 {
            phi_304_ = param_8;
        } else {
            phi_304_ = _e109;
        }
        let _e113 = phi_304_;
        phi_352_ = (param_8 - _e113);
    } else {
        if (_e86 == 1u) {
            let _e116 = (param_8 * 0.5f);
            if (_e116 > -8388608f) {
                let _e128 = f32(select(0i, select(select(i32(_e116), i32(-2147483648), (_e116 < bitcast<f32>(3472883712u))), 2147483647i, (_e116 > bitcast<f32>(1325400063u))), (_e116 == _e116)));
                if (_e128 > _e116) {
                    phi_330_ = 1f;
                } else {
                    phi_330_ = 0f;
                }
                let _e131 = phi_330_;
                if (_e116 < 8388608f) {
                    phi_335_ = (_e128 - _e131);
                    phi_336_ = false;
                } else {
                    phi_335_ = f32();
                    phi_336_ = true;
                }
                let _e134 = phi_335_;
                let _e136 = phi_336_;
                phi_337_ = _e134;
                phi_338_ = _e136;
            } else {
                phi_337_ = f32();
                phi_338_ = true;
            }
            let _e138 = phi_337_;
            let _e140 = phi_338_;
            if _e140 {
                phi_342_ = _e116;
            } else {
                phi_342_ = _e138;
            }
            let _e142 = phi_342_;
            let _e144 = (param_8 - (2f * _e142));
            if (_e144 > 1f) {
                phi_350_ = (2f - _e144);
            } else {
                phi_350_ = _e144;
            }
            let _e148 = phi_350_;
            phi_351_ = _e148;
        } else {
            phi_351_ = param_8;
        }
        let _e150 = phi_351_;
        phi_352_ = _e150;
    }
    let _e152 = phi_352_;
    if (_e152 > 0f) {
        if (_e152 < 1f) {
            phi_361_ = _e152;
        } else {
            phi_361_ = 1f;
        }
        let _e156 = phi_361_;
        phi_362_ = _e156;
    } else {
        phi_362_ = 0f;
    }
    let _e158 = phi_362_;
    let _e159 = (_e73 - 1u);
    let _e161 = (_e158 * f32(_e73));
    if _e81 {
        let _e168 = select(select(u32(_e161), 0u, (_e161 < bitcast<f32>(0u))), 4294967295u, (_e161 > bitcast<f32>(1333788671u)));
        if (_e159 < _e168) {
            phi_380_ = _e159;
        } else {
            phi_380_ = _e168;
        }
        let _e171 = phi_380_;
        phi_419_ = texture_Axis(_e171, _e171, 0f);
    } else {
        let _e173 = (_e161 + 0.5f);
        let _e180 = select(select(u32(_e173), 0u, (_e173 < bitcast<f32>(0u))), 4294967295u, (_e173 > bitcast<f32>(1333788671u)));
        if (_e73 < _e180) {
            phi_394_ = _e73;
        } else {
            phi_394_ = _e180;
        }
        let _e183 = phi_394_;
        if (_e86 == 0u) {
            phi_401_ = _e159;
        } else {
            phi_401_ = 0u;
        }
        let _e188 = phi_401_;
        if (_e86 == 0u) {
            phi_406_ = 0u;
        } else {
            phi_406_ = _e159;
        }
        let _e191 = phi_406_;
        if (_e183 == 0u) {
            phi_412_ = _e188;
        } else {
            phi_412_ = (_e183 - 1u);
        }
        let _e195 = phi_412_;
        if (_e183 > _e159) {
            phi_417_ = _e191;
        } else {
            phi_417_ = _e183;
        }
        let _e198 = phi_417_;
        phi_419_ = texture_Axis(_e195, _e198, (_e173 - f32(_e183)));
    }
    let _e201 = phi_419_;
    let _e203 = (*param_7).flags;
    let _e206 = ((_e203 >> bitcast<u32>(6u)) & 3u);
    if (_e206 == 0u) {
        if (param_9 > -8388608f) {
            let _e219 = f32(select(0i, select(select(i32(param_9), i32(-2147483648), (param_9 < bitcast<f32>(3472883712u))), 2147483647i, (param_9 > bitcast<f32>(1325400063u))), (param_9 == param_9)));
            if (_e219 > param_9) {
                phi_447_ = 1f;
            } else {
                phi_447_ = 0f;
            }
            let _e222 = phi_447_;
            if (param_9 < 8388608f) {
                phi_452_ = (_e219 - _e222);
                phi_453_ = false;
            } else {
                phi_452_ = f32();
                phi_453_ = true;
            }
            let _e225 = phi_452_;
            let _e227 = phi_453_;
            phi_454_ = _e225;
            phi_455_ = _e227;
        } else {
            phi_454_ = f32();
            phi_455_ = true;
        }
        let _e229 = phi_454_;
        let _e231 = phi_455_;
        if _e231 {
            phi_459_ = param_9;
        } else {
            phi_459_ = _e229;
        }
        let _e233 = phi_459_;
        phi_507_ = (param_9 - _e233);
    } else {
        if (_e206 == 1u) {
            let _e236 = (param_9 * 0.5f);
            if (_e236 > -8388608f) {
                let _e248 = f32(select(0i, select(select(i32(_e236), i32(-2147483648), (_e236 < bitcast<f32>(3472883712u))), 2147483647i, (_e236 > bitcast<f32>(1325400063u))), (_e236 == _e236)));
                if (_e248 > _e236) {
                    phi_485_ = 1f;
                } else {
                    phi_485_ = 0f;
                }
                let _e251 = phi_485_;
                if (_e236 < 8388608f) {
                    phi_490_ = (_e248 - _e251);
                    phi_491_ = false;
                } else {
                    phi_490_ = f32();
                    phi_491_ = true;
                }
                let _e254 = phi_490_;
                let _e256 = phi_491_;
                phi_492_ = _e254;
                phi_493_ = _e256;
            } else {
                phi_492_ = f32();
                phi_493_ = true;
            }
            let _e258 = phi_492_;
            let _e260 = phi_493_;
            if _e260 {
                phi_497_ = _e236;
            } else {
                phi_497_ = _e258;
            }
            let _e262 = phi_497_;
            let _e264 = (param_9 - (2f * _e262));
            if (_e264 > 1f) {
                phi_505_ = (2f - _e264);
            } else {
                phi_505_ = _e264;
            }
            let _e268 = phi_505_;
            phi_506_ = _e268;
        } else {
            phi_506_ = param_9;
        }
        let _e270 = phi_506_;
        phi_507_ = _e270;
    }
    let _e272 = phi_507_;
    if (_e272 > 0f) {
        if (_e272 < 1f) {
            phi_516_ = _e272;
        } else {
            phi_516_ = 1f;
        }
        let _e276 = phi_516_;
        phi_517_ = _e276;
    } else {
        phi_517_ = 0f;
    }
    let _e278 = phi_517_;
    let _e279 = (_e77 - 1u);
    let _e281 = (_e278 * f32(_e77));
    if _e81 {
        let _e288 = select(select(u32(_e281), 0u, (_e281 < bitcast<f32>(0u))), 4294967295u, (_e281 > bitcast<f32>(1333788671u)));
        if (_e279 < _e288) {
            phi_535_ = _e279;
        } else {
            phi_535_ = _e288;
        }
        let _e291 = phi_535_;
        phi_574_ = texture_Axis(_e291, _e291, 0f);
    } else {
        let _e293 = (_e281 + 0.5f);
        let _e300 = select(select(u32(_e293), 0u, (_e293 < bitcast<f32>(0u))), 4294967295u, (_e293 > bitcast<f32>(1333788671u)));
        if (_e77 < _e300) {
            phi_549_ = _e77;
        } else {
            phi_549_ = _e300;
        }
        let _e303 = phi_549_;
        if (_e206 == 0u) {
            phi_556_ = _e279;
        } else {
            phi_556_ = 0u;
        }
        let _e308 = phi_556_;
        if (_e206 == 0u) {
            phi_561_ = 0u;
        } else {
            phi_561_ = _e279;
        }
        let _e311 = phi_561_;
        if (_e303 == 0u) {
            phi_567_ = _e308;
        } else {
            phi_567_ = (_e303 - 1u);
        }
        let _e315 = phi_567_;
        if (_e303 > _e279) {
            phi_572_ = _e311;
        } else {
            phi_572_ = _e303;
        }
        let _e318 = phi_572_;
        phi_574_ = texture_Axis(_e315, _e318, (_e293 - f32(_e303)));
    }
    let _e321 = phi_574_;
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
    var phi_633_: f32;

    if (param_12 > param_13) {
        phi_633_ = param_12;
    } else {
        phi_633_ = param_13;
    }
    let _e72 = phi_633_;
    return _e72;
}

fn _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(param_14: vec3<f32>) -> vec3<f32> {
    return param_14;
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var phi_750_: bool;
    var phi_751_: bool;
    var phi_752_: bool;
    var phi_753_: bool;
    var phi_757_: bool;
    var phi_770_: bool;
    var phi_771_: bool;
    var phi_772_: bool;
    var phi_773_: bool;
    var phi_777_: bool;
    var phi_790_: bool;
    var phi_791_: bool;
    var phi_792_: bool;
    var phi_796_: bool;
    var phi_797_: bool;
    var phi_798_: bool;
    var phi_799_: bool;
    var phi_800_: bool;
    var phi_804_: bool;
    var phi_880_: f32;
    var phi_887_: f32;
    var phi_895_: f32;
    var phi_902_: f32;
    var phi_910_: f32;
    var phi_917_: f32;
    var phi_940_: f32;
    var phi_945_: f32;
    var phi_950_: f32;
    var phi_955_: f32;
    var phi_960_: f32;
    var phi_991_: bool;
    var phi_992_: bool;
    var phi_1000_: u32;
    var phi_1001_: u32;
    var phi_1018_: vec3<f32>;
    var phi_1019_: vec3<f32>;
    var phi_1032_: u32;
    var phi_1037_: u32;
    var phi_1042_: u32;
    var phi_1156_: bool;
    var phi_1157_: bool;
    var phi_1188_: u32;
    var phi_1190_: lt_bvh_Hit;
    var phi_1193_: u32;
    var phi_1278_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1305_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1332_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1338_: u32;
    var phi_1341_: u32;
    var phi_1355_: u32;
    var phi_1365_: u32;
    var phi_1375_: u32;
    var phi_1393_: u32;
    var phi_1403_: u32;
    var phi_1413_: u32;
    var phi_1449_: u32;
    var phi_1462_: u32;
    var phi_1467_: u32;
    var phi_1468_: u32;
    var phi_1469_: u32;
    var phi_1339_: u32;
    var phi_1342_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_1527_: lt_bvh_Hit;
    var phi_1530_: u32;
    var phi_1576_: vec3<f32>;
    var phi_1577_: vec3<f32>;
    var phi_1608_: vec3<f32>;
    var phi_1609_: vec3<f32>;
    var phi_1640_: vec3<f32>;
    var phi_1641_: vec3<f32>;
    var phi_1659_: bool;
    var phi_1660_: bool;
    var phi_1664_: f32;
    var phi_1665_: f32;
    var phi_1666_: f32;
    var phi_1667_: f32;
    var phi_1675_: f32;
    var phi_1685_: bool;
    var phi_1686_: bool;
    var phi_1690_: f32;
    var phi_1691_: f32;
    var phi_1692_: f32;
    var phi_1693_: f32;
    var phi_1701_: f32;
    var phi_1711_: bool;
    var phi_1712_: bool;
    var phi_1716_: f32;
    var phi_1717_: f32;
    var phi_1718_: f32;
    var phi_1719_: f32;
    var phi_1727_: f32;
    var phi_1742_: f32;
    var phi_1743_: bool;
    var phi_1744_: f32;
    var phi_1745_: bool;
    var phi_1746_: f32;
    var phi_1747_: bool;
    var phi_1765_: f32;
    var phi_1766_: bool;
    var phi_1767_: bool;
    var phi_1768_: f32;
    var phi_1769_: bool;
    var phi_1770_: bool;
    var phi_1774_: bool;
    var phi_1775_: f32;
    var phi_1776_: bool;
    var phi_1806_: vec3<f32>;
    var phi_1807_: vec3<f32>;
    var phi_1832_: vec3<f32>;
    var phi_1833_: vec3<f32>;
    var phi_1858_: vec3<f32>;
    var phi_1859_: vec3<f32>;
    var phi_1917_: f32;
    var phi_1926_: f32;
    var phi_1935_: f32;
    var phi_1944_: f32;
    var phi_1951_: f32;
    var phi_1958_: f32;
    var phi_1971_: f32;
    var phi_1980_: f32;
    var phi_1989_: f32;
    var phi_1998_: f32;
    var phi_2005_: f32;
    var phi_2012_: f32;
    var phi_2035_: f32;
    var phi_2040_: f32;
    var phi_2045_: f32;
    var phi_2053_: f32;
    var phi_2058_: f32;
    var phi_2063_: f32;
    var phi_2075_: f32;
    var phi_2080_: f32;
    var phi_2085_: f32;
    var phi_2090_: f32;
    var phi_2095_: lt_bvh_triangle_Intersection;
    var phi_2096_: bool;
    var phi_2097_: lt_bvh_triangle_Intersection;
    var phi_2098_: bool;
    var phi_2102_: lt_bvh_triangle_Intersection;
    var phi_2103_: bool;
    var phi_2104_: lt_bvh_triangle_Intersection;
    var phi_2105_: bool;
    var phi_2106_: bool;
    var phi_2110_: bool;
    var phi_2114_: lt_bvh_triangle_Intersection;
    var phi_2153_: bool;
    var phi_2154_: bool;
    var phi_2155_: bool;
    var phi_2156_: bool;
    var phi_2157_: bool;
    var phi_2158_: bool;
    var phi_2162_: bool;
    var phi_2163_: bool;
    var phi_2177_: bool;
    var phi_2185_: lt_bvh_Hit;
    var phi_2186_: lt_bvh_Hit;
    var phi_2187_: lt_bvh_Hit;
    var phi_2188_: lt_bvh_Hit;
    var phi_1528_: lt_bvh_Hit;
    var phi_1531_: u32;
    var phi_2189_: bool;
    var phi_2228_: bool;
    var phi_2229_: bool;
    var phi_2260_: u32;
    var phi_1191_: lt_bvh_Hit;
    var phi_1194_: u32;
    var phi_2261_: lt_bvh_Hit;
    var phi_2262_: lt_bvh_Hit;
    var phi_2263_: bool;
    var phi_2267_: lt_bvh_Hit;
    var phi_2331_: f32;
    var phi_2336_: f32;
    var phi_2341_: f32;
    var phi_2352_: f32;
    var phi_2357_: f32;
    var phi_2362_: f32;
    var phi_2438_: vec3<f32>;
    var phi_2681_: vec3<f32>;
    var phi_2696_: u32;
    var phi_2723_: f32;
    var phi_2730_: f32;
    var phi_2737_: f32;
    var phi_2772_: f32;
    var phi_2779_: f32;
    var phi_2786_: f32;
    var phi_2824_: f32;
    var phi_2831_: f32;
    var phi_2838_: f32;
    var phi_2897_: vec3<f32>;
    var phi_2898_: vec3<f32>;
    var phi_2899_: vec3<f32>;
    var phi_2908_: f32;
    var phi_2909_: f32;
    var phi_2919_: f32;
    var phi_2920_: f32;
    var phi_2930_: f32;
    var phi_2931_: f32;
    var phi_2966_: abi_Sample;
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
        let _e155 = abs(_e150.direction.x);
        let _e157 = abs(_e150.direction.y);
        let _e159 = abs(_e150.direction.z);
        if (abs(_e150.origin.x) < 1000000000000000f) {
            if (abs(_e150.origin.y) < 1000000000000000f) {
                phi_750_ = (abs(_e150.origin.z) < 1000000000000000f);
                phi_751_ = false;
            } else {
                phi_750_ = bool();
                phi_751_ = true;
            }
            let _e171 = phi_750_;
            let _e173 = phi_751_;
            phi_752_ = _e171;
            phi_753_ = _e173;
        } else {
            phi_752_ = bool();
            phi_753_ = true;
        }
        let _e175 = phi_752_;
        let _e177 = phi_753_;
        if _e177 {
            phi_757_ = false;
        } else {
            phi_757_ = _e175;
        }
        let _e179 = phi_757_;
        if _e179 {
            if (_e155 < 1000000000000000f) {
                if (_e157 < 1000000000000000f) {
                    phi_770_ = (_e159 < 1000000000000000f);
                    phi_771_ = false;
                } else {
                    phi_770_ = bool();
                    phi_771_ = true;
                }
                let _e184 = phi_770_;
                let _e186 = phi_771_;
                phi_772_ = _e184;
                phi_773_ = _e186;
            } else {
                phi_772_ = bool();
                phi_773_ = true;
            }
            let _e188 = phi_772_;
            let _e190 = phi_773_;
            if _e190 {
                phi_777_ = false;
            } else {
                phi_777_ = _e188;
            }
            let _e192 = phi_777_;
            if _e192 {
                if (_e155 > 0f) {
                    phi_791_ = bool();
                    phi_792_ = true;
                } else {
                    let _e194 = (_e157 > 0f);
                    if _e194 {
                        phi_790_ = bool();
                    } else {
                        phi_790_ = (_e159 > 0f);
                    }
                    let _e197 = phi_790_;
                    phi_791_ = _e197;
                    phi_792_ = _e194;
                }
                let _e199 = phi_791_;
                let _e201 = phi_792_;
                if _e201 {
                    phi_796_ = true;
                } else {
                    phi_796_ = _e199;
                }
                let _e203 = phi_796_;
                phi_797_ = _e203;
                phi_798_ = false;
            } else {
                phi_797_ = bool();
                phi_798_ = true;
            }
            let _e205 = phi_797_;
            let _e207 = phi_798_;
            phi_799_ = _e205;
            phi_800_ = _e207;
        } else {
            phi_799_ = bool();
            phi_800_ = true;
        }
        let _e209 = phi_799_;
        let _e211 = phi_800_;
        if _e211 {
            phi_804_ = false;
        } else {
            phi_804_ = _e209;
        }
        let _e213 = phi_804_;
        if _e213 {
            let _e214 = (0u >= _e74);
            if _e214 {
                phi_2261_ = lt_bvh_Hit();
            } else {
                if (0u < _e74) {
                } else {
                    return;
                }
                let _e220 = nodes.member[(0u + 0u)].frame[0u];
                let _e224 = nodes.member[(0u + 0u)].frame[1u];
                let _e228 = nodes.member[(0u + 0u)].frame[2u];
                let _e232 = nodes.member[(0u + 0u)].frame[0u];
                let _e236 = nodes.member[(0u + 0u)].frame[1u];
                let _e240 = nodes.member[(0u + 0u)].frame[2u];
                let _e244 = nodes.member[(0u + 0u)].frame[3u];
                let _e283 = core_intrinsics_maximum_number_nsz_f32_(abs(_e150.direction.x), abs(_e150.direction.y));
                let _e284 = core_intrinsics_maximum_number_nsz_f32_(_e283, abs(_e150.direction.z));
                let _e285 = (_e284 * 0.0000000000009094947f);
                if (abs(_e150.direction.x) < _e285) {
                    phi_880_ = _e285;
                } else {
                    phi_880_ = abs(_e150.direction.x);
                }
                let _e291 = phi_880_;
                if (_e150.direction.x < 0f) {
                    phi_887_ = (-1f / _e291);
                } else {
                    phi_887_ = (1f / _e291);
                }
                let _e296 = phi_887_;
                if (abs(_e150.direction.y) < _e285) {
                    phi_895_ = _e285;
                } else {
                    phi_895_ = abs(_e150.direction.y);
                }
                let _e302 = phi_895_;
                if (_e150.direction.y < 0f) {
                    phi_902_ = (-1f / _e302);
                } else {
                    phi_902_ = (1f / _e302);
                }
                let _e307 = phi_902_;
                if (abs(_e150.direction.z) < _e285) {
                    phi_910_ = _e285;
                } else {
                    phi_910_ = abs(_e150.direction.z);
                }
                let _e313 = phi_910_;
                if (_e150.direction.z < 0f) {
                    phi_917_ = (-1f / _e313);
                } else {
                    phi_917_ = (1f / _e313);
                }
                let _e318 = phi_917_;
                let _e325 = abs((bitcast<f32>(_e220) - _e150.origin.x));
                let _e326 = abs((bitcast<f32>(_e224) - _e150.origin.y));
                let _e327 = abs((bitcast<f32>(_e228) - _e150.origin.z));
                let _e334 = abs(((bitcast<f32>(_e232) + (bitcast<f32>((((_e244 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e150.origin.x));
                let _e335 = abs(((bitcast<f32>(_e236) + (bitcast<f32>((((_e244 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e150.origin.y));
                let _e336 = abs(((bitcast<f32>(_e240) + (bitcast<f32>((((_e244 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e150.origin.z));
                if (_e325 > _e334) {
                    phi_940_ = _e325;
                } else {
                    phi_940_ = _e334;
                }
                let _e339 = phi_940_;
                if (_e326 > _e335) {
                    phi_945_ = _e326;
                } else {
                    phi_945_ = _e335;
                }
                let _e342 = phi_945_;
                if (_e327 > _e336) {
                    phi_950_ = _e327;
                } else {
                    phi_950_ = _e336;
                }
                let _e345 = phi_950_;
                if (_e339 > _e342) {
                    phi_955_ = _e339;
                } else {
                    phi_955_ = _e342;
                }
                let _e348 = phi_955_;
                if (_e348 > _e345) {
                    phi_960_ = _e348;
                } else {
                    phi_960_ = _e345;
                }
                let _e351 = phi_960_;
                let _e355 = (_e351 * 0.0000019073486f);
                let _e356 = (abs(_e296) * _e355);
                let _e357 = (abs(_e307) * _e355);
                let _e358 = (abs(_e318) * _e355);
                let _e362 = (_e351 * 0.0000009536743f);
                let _e363 = (abs(_e296) * _e362);
                let _e364 = (abs(_e307) * _e362);
                let _e365 = (abs(_e318) * _e362);
                let _e369 = abs(_e150.direction.x);
                let _e371 = abs(_e150.direction.y);
                let _e373 = abs(_e150.direction.z);
                if (_e369 >= _e371) {
                    if (_e369 >= _e373) {
                        phi_991_ = false;
                    } else {
                        phi_991_ = true;
                    }
                    let _e377 = phi_991_;
                    phi_992_ = _e377;
                } else {
                    phi_992_ = true;
                }
                let _e379 = phi_992_;
                if _e379 {
                    if (_e371 >= _e373) {
                        phi_1000_ = 1u;
                    } else {
                        phi_1000_ = 2u;
                    }
                    let _e382 = phi_1000_;
                    phi_1001_ = _e382;
                } else {
                    phi_1001_ = 0u;
                }
                let _e384 = phi_1001_;
                if (_e384 == 0u) {
                    phi_1019_ = vec3<f32>(_e150.direction.y, _e150.direction.z, _e150.direction.x);
                } else {
                    if (_e384 == 1u) {
                        phi_1018_ = vec3<f32>(_e150.direction.z, _e150.direction.x, _e150.direction.y);
                    } else {
                        phi_1018_ = _e150.direction;
                    }
                    let _e396 = phi_1018_;
                    phi_1019_ = _e396;
                }
                let _e398 = phi_1019_;
                let _e401 = (_e398.x / _e398.z);
                let _e404 = (_e398.y / _e398.z);
                if (_e296 < 0f) {
                    phi_1032_ = 0u;
                } else {
                    phi_1032_ = 1u;
                }
                let _e409 = phi_1032_;
                if (_e307 < 0f) {
                    phi_1037_ = 0u;
                } else {
                    phi_1037_ = 2u;
                }
                let _e412 = phi_1037_;
                if (_e318 < 0f) {
                    phi_1042_ = 0u;
                } else {
                    phi_1042_ = 4u;
                }
                let _e415 = phi_1042_;
                let _e417 = ((_e409 | _e412) | _e415);
                let _e418 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e418.first[0], _e418.first[1], _e418.first[2], _e418.first[3], _e418.first[4], _e418.first[5], _e418.first[6], _e418.first[7], _e418.first[8], _e418.first[9], _e418.first[10], _e418.first[11], _e418.first[12], _e418.first[13], _e418.first[14], _e418.first[15], _e418.first[16], _e418.first[17], _e418.first[18], _e418.first[19], _e418.first[20], _e418.first[21], _e418.first[22], _e418.first[23], _e418.first[24], _e418.first[25], _e418.first[26], _e418.first[27], _e418.first[28], _e418.first[29], _e418.first[30], _e418.first[31]), array<u32, 32>(_e418.mask[0], _e418.mask[1], _e418.mask[2], _e418.mask[3], _e418.mask[4], _e418.mask[5], _e418.mask[6], _e418.mask[7], _e418.mask[8], _e418.mask[9], _e418.mask[10], _e418.mask[11], _e418.mask[12], _e418.mask[13], _e418.mask[14], _e418.mask[15], _e418.mask[16], _e418.mask[17], _e418.mask[18], _e418.mask[19], _e418.mask[20], _e418.mask[21], _e418.mask[22], _e418.mask[23], _e418.mask[24], _e418.mask[25], _e418.mask[26], _e418.mask[27], _e418.mask[28], _e418.mask[29], _e418.mask[30], _e418.mask[31]), _e418.len, _e418.group, _e418.group_mask);
                let _e492 = local_1.group_mask;
                if ((_e492 & 4278190080u) == 0u) {
                    let _e496 = local_1.len;
                    if (_e496 == 0u) {
                        phi_1156_ = false;
                    } else {
                        let _e500 = local_1.len;
                        local_1.len = (_e500 - 1u);
                        let _e503 = local_1.len;
                        if (_e503 < 32u) {
                        } else {
                            return;
                        }
                        let _e508 = local_1.first[(0u + _e503)];
                        local_1.group = _e508;
                        let _e511 = local_1.len;
                        if (_e511 < 32u) {
                        } else {
                            return;
                        }
                        let _e516 = local_1.mask[(0u + _e511)];
                        local_1.group_mask = _e516;
                        phi_1156_ = true;
                    }
                    let _e519 = phi_1156_;
                    phi_1157_ = _e519;
                } else {
                    phi_1157_ = true;
                }
                let _e521 = phi_1157_;
                if _e521 {
                    let _e523 = local_1.group_mask;
                    let _e529 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e523)), 32u, (_e523 == 0u)));
                    let _e533 = local_1.group_mask;
                    let _e547 = local_1.group_mask;
                    local_1.group_mask = (_e547 & ~((1u << bitcast<u32>((_e529 & 31u)))));
                    let _e550 = local_1.group;
                    phi_1188_ = (_e550 + countOneBits(((_e533 & ~((4294967295u << bitcast<u32>((((_e529 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1188_ = 4294967295u;
                }
                let _e553 = phi_1188_;
                phi_1190_ = _e152;
                phi_1193_ = _e553;
                loop {
                    let _e555 = phi_1190_;
                    let _e557 = phi_1193_;
                    local_6 = _e555;
                    let _e558 = (_e557 != 4294967295u);
                    if _e558 {
                        if (_e557 < _e74) {
                        } else {
                            return;
                        }
                        let _e566 = nodes.member[(0u + _e557)].frame[3u];
                        let _e591 = (bitcast<f32>((((_e566 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e296);
                        let _e592 = (bitcast<f32>((((_e566 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e307);
                        let _e593 = (bitcast<f32>((((_e566 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e318);
                        let _e596 = nodes.member[(0u + _e557)].frame[0u];
                        let _e600 = nodes.member[(0u + _e557)].frame[1u];
                        let _e604 = nodes.member[(0u + _e557)].frame[2u];
                        let _e612 = ((bitcast<f32>(_e596) - _e150.origin.x) * _e296);
                        let _e613 = ((bitcast<f32>(_e600) - _e150.origin.y) * _e307);
                        let _e614 = ((bitcast<f32>(_e604) - _e150.origin.z) * _e318);
                        let _e622 = nodes.member[(0u + _e557)].x;
                        if (_e296 < 0f) {
                            let _e633 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e622.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e639 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e633.unnamed.word, _e622.w), _e633.unnamed_1);
                            let _e645 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e639.unnamed, lt_mask_LightPlace(_e622.x, _e639.unnamed_1.shift));
                            phi_1278_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e645.unnamed, lt_mask_LightPlace(_e645.unnamed_1.word, _e622.y));
                        } else {
                            let _e661 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e622.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e667 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e661.unnamed.word, _e622.y), _e661.unnamed_1);
                            let _e673 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e667.unnamed, lt_mask_LightPlace(_e622.z, _e667.unnamed_1.shift));
                            phi_1278_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e673.unnamed, lt_mask_LightPlace(_e673.unnamed_1.word, _e622.w));
                        }
                        let _e681 = phi_1278_;
                        let _e691 = nodes.member[(0u + _e557)].y;
                        if (_e307 < 0f) {
                            let _e702 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e691.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e708 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e702.unnamed.word, _e691.w), _e702.unnamed_1);
                            let _e714 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e708.unnamed, lt_mask_LightPlace(_e691.x, _e708.unnamed_1.shift));
                            phi_1305_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e714.unnamed, lt_mask_LightPlace(_e714.unnamed_1.word, _e691.y));
                        } else {
                            let _e730 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e691.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e736 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e730.unnamed.word, _e691.y), _e730.unnamed_1);
                            let _e742 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e736.unnamed, lt_mask_LightPlace(_e691.z, _e736.unnamed_1.shift));
                            phi_1305_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e742.unnamed, lt_mask_LightPlace(_e742.unnamed_1.word, _e691.w));
                        }
                        let _e750 = phi_1305_;
                        let _e760 = nodes.member[(0u + _e557)].z;
                        if (_e318 < 0f) {
                            let _e771 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e760.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e777 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e771.unnamed.word, _e760.w), _e771.unnamed_1);
                            let _e783 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e777.unnamed, lt_mask_LightPlace(_e760.x, _e777.unnamed_1.shift));
                            phi_1332_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e783.unnamed, lt_mask_LightPlace(_e783.unnamed_1.word, _e760.y));
                        } else {
                            let _e799 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e760.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e805 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e799.unnamed.word, _e760.y), _e799.unnamed_1);
                            let _e811 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e805.unnamed, lt_mask_LightPlace(_e760.z, _e805.unnamed_1.shift));
                            phi_1332_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e811.unnamed, lt_mask_LightPlace(_e811.unnamed_1.word, _e760.w));
                        }
                        let _e819 = phi_1332_;
                        phi_1338_ = 0u;
                        phi_1341_ = 0u;
                        loop {
                            let _e829 = phi_1338_;
                            let _e831 = phi_1341_;
                            local_2 = _e831;
                            local_3 = _e831;
                            local_4 = _e831;
                            let _e832 = (_e829 < 8u);
                            if _e832 {
                                let _e834 = (_e829 >> bitcast<u32>(2i));
                                let _e835 = (_e829 & 3u);
                                if (_e834 == 0u) {
                                    phi_1355_ = _e681.unnamed.word;
                                } else {
                                    phi_1355_ = _e681.unnamed.shift;
                                }
                                let _e838 = phi_1355_;
                                if (_e834 == 0u) {
                                    phi_1365_ = _e750.unnamed.word;
                                } else {
                                    phi_1365_ = _e750.unnamed.shift;
                                }
                                let _e847 = phi_1365_;
                                if (_e834 == 0u) {
                                    phi_1375_ = _e819.unnamed.word;
                                } else {
                                    phi_1375_ = _e819.unnamed.shift;
                                }
                                let _e856 = phi_1375_;
                                let _e869 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e838 >> bitcast<u32>(((_e835 * 8u) & 31u))) & 255u)) * _e591) + (_e612 - _e356)), ((f32(((_e847 >> bitcast<u32>(((_e835 * 8u) & 31u))) & 255u)) * _e592) + (_e613 - _e357)));
                                let _e870 = core_intrinsics_maximum_number_nsz_f32_(_e869, ((f32(((_e856 >> bitcast<u32>(((_e835 * 8u) & 31u))) & 255u)) * _e593) + (_e614 - _e358)));
                                if (_e834 == 0u) {
                                    phi_1393_ = _e681.unnamed_1.word;
                                } else {
                                    phi_1393_ = _e681.unnamed_1.shift;
                                }
                                let _e873 = phi_1393_;
                                if (_e834 == 0u) {
                                    phi_1403_ = _e750.unnamed_1.word;
                                } else {
                                    phi_1403_ = _e750.unnamed_1.shift;
                                }
                                let _e882 = phi_1403_;
                                if (_e834 == 0u) {
                                    phi_1413_ = _e819.unnamed_1.word;
                                } else {
                                    phi_1413_ = _e819.unnamed_1.shift;
                                }
                                let _e891 = phi_1413_;
                                let _e904 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e873 >> bitcast<u32>(((_e835 * 8u) & 31u))) & 255u)) * _e591) + (_e612 + _e356)), ((f32(((_e882 >> bitcast<u32>(((_e835 * 8u) & 31u))) & 255u)) * _e592) + (_e613 + _e357)));
                                let _e905 = core_intrinsics_minimum_number_nsz_f32_(_e904, ((f32(((_e891 >> bitcast<u32>(((_e835 * 8u) & 31u))) & 255u)) * _e593) + (_e614 + _e358)));
                                if (_e870 <= _e905) {
                                    if (_e870 <= _e555.t) {
                                        if (_e905 >= _e150.tmin) {
                                            if (_e834 == 0u) {
                                                let _e912 = nodes.member[(0u + _e557)].links[2u];
                                                phi_1449_ = _e912;
                                            } else {
                                                let _e915 = nodes.member[(0u + _e557)].links[3u];
                                                phi_1449_ = _e915;
                                            }
                                            let _e917 = phi_1449_;
                                            let _e922 = ((_e917 >> bitcast<u32>(((_e835 * 8u) & 31u))) & 255u);
                                            let _e923 = (_e922 & 31u);
                                            if (_e923 >= 24u) {
                                                phi_1462_ = (24u + ((_e923 - 24u) ^ _e417));
                                            } else {
                                                phi_1462_ = _e923;
                                            }
                                            let _e929 = phi_1462_;
                                            phi_1467_ = (_e831 | ((_e922 >> bitcast<u32>(5i)) << bitcast<u32>((_e929 & 31u))));
                                        } else {
                                            phi_1467_ = _e831;
                                        }
                                        let _e937 = phi_1467_;
                                        phi_1468_ = _e937;
                                    } else {
                                        phi_1468_ = _e831;
                                    }
                                    let _e939 = phi_1468_;
                                    phi_1469_ = _e939;
                                } else {
                                    phi_1469_ = _e831;
                                }
                                let _e941 = phi_1469_;
                                phi_1339_ = (_e829 + 1u);
                                phi_1342_ = _e941;
                            } else {
                                phi_1339_ = u32();
                                phi_1342_ = u32();
                            }
                            let _e944 = phi_1339_;
                            let _e946 = phi_1342_;
                            continue;
                            continuing {
                                phi_1338_ = _e944;
                                phi_1341_ = _e946;
                                break if !(_e832);
                            }
                        }
                        let _e950 = nodes.member[(0u + _e557)].links[0u];
                        let _e954 = nodes.member[(0u + _e557)].frame[3u];
                        let _e958 = local_2;
                        if ((_e958 & 4278190080u) == 0u) {
                        } else {
                            let _e962 = local_1.group_mask;
                            if ((_e962 & 4278190080u) == 0u) {
                            } else {
                                let _e966 = local_1.len;
                                if (_e966 < 32u) {
                                    let _e969 = local_1.group;
                                    let _e971 = local_1.len;
                                    if (_e971 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.first[(0u + _e971)] = _e969;
                                    let _e977 = local_1.group_mask;
                                    let _e979 = local_1.len;
                                    if (_e979 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.mask[(0u + _e979)] = _e977;
                                    let _e986 = local_1.len;
                                    local_1.len = (_e986 + 1u);
                                }
                            }
                            local_1.group = (0u + _e950);
                            let _e990 = local_3;
                            local_1.group_mask = ((_e990 & 4278190080u) | (_e954 >> bitcast<u32>(24i)));
                        }
                        let _e995 = local_4;
                        phi_1527_ = _e555;
                        phi_1530_ = (_e995 & 16777215u);
                        loop {
                            let _e998 = phi_1527_;
                            let _e1000 = phi_1530_;
                            local_5 = _e998;
                            if (_e1000 == 0u) {
                                phi_1528_ = lt_bvh_Hit();
                                phi_1531_ = u32();
                                phi_2189_ = false;
                            } else {
                                let _e1004 = nodes.member[(0u + _e557)].links[1u];
                                let _e1009 = ((0u + _e1004) + select(firstTrailingBit(_e1000), 32u, (_e1000 == 0u)));
                                if (_e1009 < _e77) {
                                } else {
                                    return;
                                }
                                let _e1016 = triangles.member[(0u + _e1009)].v0_;
                                let _e1019 = (_e1016.x - _e150.origin.x);
                                let _e1022 = (_e1016.y - _e150.origin.y);
                                let _e1025 = (_e1016.z - _e150.origin.z);
                                if (_e384 == 0u) {
                                    phi_1577_ = vec3<f32>(_e1022, _e1025, _e1019);
                                } else {
                                    if (_e384 == 1u) {
                                        phi_1576_ = vec3<f32>(_e1025, _e1019, _e1022);
                                    } else {
                                        phi_1576_ = (_e1016 - _e150.origin);
                                    }
                                    let _e1032 = phi_1576_;
                                    phi_1577_ = _e1032;
                                }
                                let _e1034 = phi_1577_;
                                let _e1038 = (_e1034.x - (_e401 * _e1034.z));
                                let _e1042 = (_e1034.y - (_e404 * _e1034.z));
                                let _e1044 = triangles.member[(0u + _e1009)].v1_;
                                let _e1047 = (_e1044.x - _e150.origin.x);
                                let _e1050 = (_e1044.y - _e150.origin.y);
                                let _e1053 = (_e1044.z - _e150.origin.z);
                                if (_e384 == 0u) {
                                    phi_1609_ = vec3<f32>(_e1050, _e1053, _e1047);
                                } else {
                                    if (_e384 == 1u) {
                                        phi_1608_ = vec3<f32>(_e1053, _e1047, _e1050);
                                    } else {
                                        phi_1608_ = (_e1044 - _e150.origin);
                                    }
                                    let _e1060 = phi_1608_;
                                    phi_1609_ = _e1060;
                                }
                                let _e1062 = phi_1609_;
                                let _e1066 = (_e1062.x - (_e401 * _e1062.z));
                                let _e1070 = (_e1062.y - (_e404 * _e1062.z));
                                let _e1072 = triangles.member[(0u + _e1009)].v2_;
                                let _e1075 = (_e1072.x - _e150.origin.x);
                                let _e1078 = (_e1072.y - _e150.origin.y);
                                let _e1081 = (_e1072.z - _e150.origin.z);
                                if (_e384 == 0u) {
                                    phi_1641_ = vec3<f32>(_e1078, _e1081, _e1075);
                                } else {
                                    if (_e384 == 1u) {
                                        phi_1640_ = vec3<f32>(_e1081, _e1075, _e1078);
                                    } else {
                                        phi_1640_ = (_e1072 - _e150.origin);
                                    }
                                    let _e1088 = phi_1640_;
                                    phi_1641_ = _e1088;
                                }
                                let _e1090 = phi_1641_;
                                let _e1094 = (_e1090.x - (_e401 * _e1090.z));
                                let _e1098 = (_e1090.y - (_e404 * _e1090.z));
                                if (_e1066 < _e1094) {
                                    phi_1660_ = true;
                                } else {
                                    if (_e1066 == _e1094) {
                                        phi_1659_ = (_e1070 < _e1098);
                                    } else {
                                        phi_1659_ = false;
                                    }
                                    let _e1103 = phi_1659_;
                                    phi_1660_ = _e1103;
                                }
                                let _e1105 = phi_1660_;
                                if _e1105 {
                                    phi_1664_ = _e1098;
                                    phi_1665_ = _e1094;
                                    phi_1666_ = _e1070;
                                    phi_1667_ = _e1066;
                                } else {
                                    phi_1664_ = _e1070;
                                    phi_1665_ = _e1066;
                                    phi_1666_ = _e1098;
                                    phi_1667_ = _e1094;
                                }
                                let _e1107 = phi_1664_;
                                let _e1109 = phi_1665_;
                                let _e1111 = phi_1666_;
                                let _e1113 = phi_1667_;
                                let _e1116 = ((_e1113 * _e1107) - (_e1111 * _e1109));
                                if _e1105 {
                                    phi_1675_ = -(_e1116);
                                } else {
                                    phi_1675_ = _e1116;
                                }
                                let _e1119 = phi_1675_;
                                if (_e1094 < _e1038) {
                                    phi_1686_ = true;
                                } else {
                                    if (_e1094 == _e1038) {
                                        phi_1685_ = (_e1098 < _e1042);
                                    } else {
                                        phi_1685_ = false;
                                    }
                                    let _e1124 = phi_1685_;
                                    phi_1686_ = _e1124;
                                }
                                let _e1126 = phi_1686_;
                                if _e1126 {
                                    phi_1690_ = _e1042;
                                    phi_1691_ = _e1038;
                                    phi_1692_ = _e1098;
                                    phi_1693_ = _e1094;
                                } else {
                                    phi_1690_ = _e1098;
                                    phi_1691_ = _e1094;
                                    phi_1692_ = _e1042;
                                    phi_1693_ = _e1038;
                                }
                                let _e1128 = phi_1690_;
                                let _e1130 = phi_1691_;
                                let _e1132 = phi_1692_;
                                let _e1134 = phi_1693_;
                                let _e1137 = ((_e1134 * _e1128) - (_e1132 * _e1130));
                                if _e1126 {
                                    phi_1701_ = -(_e1137);
                                } else {
                                    phi_1701_ = _e1137;
                                }
                                let _e1140 = phi_1701_;
                                if (_e1038 < _e1066) {
                                    phi_1712_ = true;
                                } else {
                                    if (_e1038 == _e1066) {
                                        phi_1711_ = (_e1042 < _e1070);
                                    } else {
                                        phi_1711_ = false;
                                    }
                                    let _e1145 = phi_1711_;
                                    phi_1712_ = _e1145;
                                }
                                let _e1147 = phi_1712_;
                                if _e1147 {
                                    phi_1716_ = _e1070;
                                    phi_1717_ = _e1066;
                                    phi_1718_ = _e1042;
                                    phi_1719_ = _e1038;
                                } else {
                                    phi_1716_ = _e1042;
                                    phi_1717_ = _e1038;
                                    phi_1718_ = _e1070;
                                    phi_1719_ = _e1066;
                                }
                                let _e1149 = phi_1716_;
                                let _e1151 = phi_1717_;
                                let _e1153 = phi_1718_;
                                let _e1155 = phi_1719_;
                                let _e1158 = ((_e1155 * _e1149) - (_e1153 * _e1151));
                                if _e1147 {
                                    phi_1727_ = -(_e1158);
                                } else {
                                    phi_1727_ = _e1158;
                                }
                                let _e1161 = phi_1727_;
                                if (_e1119 >= 0f) {
                                    if (_e1140 >= 0f) {
                                        if (_e1161 >= 0f) {
                                            phi_1742_ = ((_e1119 + _e1140) + _e1161);
                                            phi_1743_ = false;
                                        } else {
                                            phi_1742_ = f32();
                                            phi_1743_ = true;
                                        }
                                        let _e1168 = phi_1742_;
                                        let _e1170 = phi_1743_;
                                        phi_1744_ = _e1168;
                                        phi_1745_ = _e1170;
                                    } else {
                                        phi_1744_ = f32();
                                        phi_1745_ = true;
                                    }
                                    let _e1172 = phi_1744_;
                                    let _e1174 = phi_1745_;
                                    phi_1746_ = _e1172;
                                    phi_1747_ = _e1174;
                                } else {
                                    phi_1746_ = f32();
                                    phi_1747_ = true;
                                }
                                let _e1176 = phi_1746_;
                                let _e1178 = phi_1747_;
                                if _e1178 {
                                    if (_e1119 <= 0f) {
                                        if (_e1140 <= 0f) {
                                            let _e1181 = (_e1161 <= 0f);
                                            if _e1181 {
                                            }
                                            phi_1765_ = ((_e1119 + _e1140) + _e1161);
                                            phi_1766_ = false;
                                            phi_1767_ = _e1181;
                                        } else {
                                            phi_1765_ = f32();
                                            phi_1766_ = true;
                                            phi_1767_ = false;
                                        }
                                        let _e1185 = phi_1765_;
                                        let _e1187 = phi_1766_;
                                        let _e1189 = phi_1767_;
                                        phi_1768_ = _e1185;
                                        phi_1769_ = _e1187;
                                        phi_1770_ = _e1189;
                                    } else {
                                        phi_1768_ = f32();
                                        phi_1769_ = true;
                                        phi_1770_ = false;
                                    }
                                    let _e1191 = phi_1768_;
                                    let _e1193 = phi_1769_;
                                    let _e1195 = phi_1770_;
                                    if _e1193 {
                                        phi_1774_ = false;
                                    } else {
                                        phi_1774_ = _e1195;
                                    }
                                    let _e1197 = phi_1774_;
                                    phi_1775_ = _e1191;
                                    phi_1776_ = _e1197;
                                } else {
                                    phi_1775_ = _e1176;
                                    phi_1776_ = true;
                                }
                                let _e1199 = phi_1775_;
                                let _e1201 = phi_1776_;
                                if _e1201 {
                                    let _e1202 = (_e1199 == 0f);
                                    if _e1202 {
                                        phi_2102_ = lt_bvh_triangle_Intersection();
                                        phi_2103_ = false;
                                    } else {
                                        let _e1204 = triangles.member[(0u + _e1009)].v0_;
                                        let _e1207 = (_e1204.x - _e150.origin.x);
                                        let _e1210 = (_e1204.y - _e150.origin.y);
                                        let _e1213 = (_e1204.z - _e150.origin.z);
                                        if (_e384 == 0u) {
                                            phi_1807_ = vec3<f32>(_e1210, _e1213, _e1207);
                                        } else {
                                            if (_e384 == 1u) {
                                                phi_1806_ = vec3<f32>(_e1213, _e1207, _e1210);
                                            } else {
                                                phi_1806_ = (_e1204 - _e150.origin);
                                            }
                                            let _e1220 = phi_1806_;
                                            phi_1807_ = _e1220;
                                        }
                                        let _e1222 = phi_1807_;
                                        let _e1224 = triangles.member[(0u + _e1009)].v1_;
                                        let _e1226 = triangles.member[(0u + _e1009)].v0_;
                                        let _e1229 = (_e1224.x - _e1226.x);
                                        let _e1232 = (_e1224.y - _e1226.y);
                                        let _e1235 = (_e1224.z - _e1226.z);
                                        if (_e384 == 0u) {
                                            phi_1833_ = vec3<f32>(_e1232, _e1235, _e1229);
                                        } else {
                                            if (_e384 == 1u) {
                                                phi_1832_ = vec3<f32>(_e1235, _e1229, _e1232);
                                            } else {
                                                phi_1832_ = (_e1224 - _e1226);
                                            }
                                            let _e1242 = phi_1832_;
                                            phi_1833_ = _e1242;
                                        }
                                        let _e1244 = phi_1833_;
                                        let _e1246 = triangles.member[(0u + _e1009)].v2_;
                                        let _e1248 = triangles.member[(0u + _e1009)].v0_;
                                        let _e1251 = (_e1246.x - _e1248.x);
                                        let _e1254 = (_e1246.y - _e1248.y);
                                        let _e1257 = (_e1246.z - _e1248.z);
                                        if (_e384 == 0u) {
                                            phi_1859_ = vec3<f32>(_e1254, _e1257, _e1251);
                                        } else {
                                            if (_e384 == 1u) {
                                                phi_1858_ = vec3<f32>(_e1257, _e1251, _e1254);
                                            } else {
                                                phi_1858_ = (_e1246 - _e1248);
                                            }
                                            let _e1264 = phi_1858_;
                                            phi_1859_ = _e1264;
                                        }
                                        let _e1266 = phi_1859_;
                                        let _e1273 = ((_e1244.y * _e1266.z) - (_e1244.z * _e1266.y));
                                        let _e1280 = ((_e1244.z * _e1266.x) - (_e1244.x * _e1266.z));
                                        let _e1287 = ((_e1244.x * _e1266.y) - (_e1244.y * _e1266.x));
                                        let _e1301 = (((1f / _e398.z) * (((_e1273 * _e1222.x) + (_e1280 * _e1222.y)) + (_e1287 * _e1222.z))) / (((_e1273 * _e401) + (_e1280 * _e404)) + _e1287));
                                        if (_e1301 > _e150.tmin) {
                                            if (_e1301 < _e150.tmax) {
                                                let _e1307 = triangles.member[(0u + _e1009)].v0_;
                                                let _e1309 = triangles.member[(0u + _e1009)].v1_;
                                                if (_e1307.x < _e1309.x) {
                                                    phi_1917_ = _e1307.x;
                                                } else {
                                                    phi_1917_ = _e1309.x;
                                                }
                                                let _e1316 = phi_1917_;
                                                if (_e1307.y < _e1309.y) {
                                                    phi_1926_ = _e1307.y;
                                                } else {
                                                    phi_1926_ = _e1309.y;
                                                }
                                                let _e1323 = phi_1926_;
                                                if (_e1307.z < _e1309.z) {
                                                    phi_1935_ = _e1307.z;
                                                } else {
                                                    phi_1935_ = _e1309.z;
                                                }
                                                let _e1330 = phi_1935_;
                                                let _e1332 = triangles.member[(0u + _e1009)].v2_;
                                                if (_e1316 < _e1332.x) {
                                                    phi_1944_ = _e1316;
                                                } else {
                                                    phi_1944_ = _e1332.x;
                                                }
                                                let _e1337 = phi_1944_;
                                                if (_e1323 < _e1332.y) {
                                                    phi_1951_ = _e1323;
                                                } else {
                                                    phi_1951_ = _e1332.y;
                                                }
                                                let _e1342 = phi_1951_;
                                                if (_e1330 < _e1332.z) {
                                                    phi_1958_ = _e1330;
                                                } else {
                                                    phi_1958_ = _e1332.z;
                                                }
                                                let _e1347 = phi_1958_;
                                                let _e1349 = triangles.member[(0u + _e1009)].v0_;
                                                let _e1351 = triangles.member[(0u + _e1009)].v1_;
                                                if (_e1349.x > _e1351.x) {
                                                    phi_1971_ = _e1349.x;
                                                } else {
                                                    phi_1971_ = _e1351.x;
                                                }
                                                let _e1358 = phi_1971_;
                                                if (_e1349.y > _e1351.y) {
                                                    phi_1980_ = _e1349.y;
                                                } else {
                                                    phi_1980_ = _e1351.y;
                                                }
                                                let _e1365 = phi_1980_;
                                                if (_e1349.z > _e1351.z) {
                                                    phi_1989_ = _e1349.z;
                                                } else {
                                                    phi_1989_ = _e1351.z;
                                                }
                                                let _e1372 = phi_1989_;
                                                let _e1374 = triangles.member[(0u + _e1009)].v2_;
                                                if (_e1358 > _e1374.x) {
                                                    phi_1998_ = _e1358;
                                                } else {
                                                    phi_1998_ = _e1374.x;
                                                }
                                                let _e1379 = phi_1998_;
                                                if (_e1365 > _e1374.y) {
                                                    phi_2005_ = _e1365;
                                                } else {
                                                    phi_2005_ = _e1374.y;
                                                }
                                                let _e1384 = phi_2005_;
                                                if (_e1372 > _e1374.z) {
                                                    phi_2012_ = _e1372;
                                                } else {
                                                    phi_2012_ = _e1374.z;
                                                }
                                                let _e1389 = phi_2012_;
                                                let _e1396 = ((_e1337 - _e150.origin.x) * _e296);
                                                let _e1397 = ((_e1342 - _e150.origin.y) * _e307);
                                                let _e1398 = ((_e1347 - _e150.origin.z) * _e318);
                                                let _e1405 = ((_e1379 - _e150.origin.x) * _e296);
                                                let _e1406 = ((_e1384 - _e150.origin.y) * _e307);
                                                let _e1407 = ((_e1389 - _e150.origin.z) * _e318);
                                                if (_e1396 < _e1405) {
                                                    phi_2035_ = _e1396;
                                                } else {
                                                    phi_2035_ = _e1405;
                                                }
                                                let _e1410 = phi_2035_;
                                                if (_e1397 < _e1406) {
                                                    phi_2040_ = _e1397;
                                                } else {
                                                    phi_2040_ = _e1406;
                                                }
                                                let _e1413 = phi_2040_;
                                                if (_e1398 < _e1407) {
                                                    phi_2045_ = _e1398;
                                                } else {
                                                    phi_2045_ = _e1407;
                                                }
                                                let _e1416 = phi_2045_;
                                                if (_e1396 > _e1405) {
                                                    phi_2053_ = _e1396;
                                                } else {
                                                    phi_2053_ = _e1405;
                                                }
                                                let _e1422 = phi_2053_;
                                                if (_e1397 > _e1406) {
                                                    phi_2058_ = _e1397;
                                                } else {
                                                    phi_2058_ = _e1406;
                                                }
                                                let _e1425 = phi_2058_;
                                                if (_e1398 > _e1407) {
                                                    phi_2063_ = _e1398;
                                                } else {
                                                    phi_2063_ = _e1407;
                                                }
                                                let _e1428 = phi_2063_;
                                                let _e1432 = core_intrinsics_maximum_number_nsz_f32_((_e1410 - _e363), (_e1413 - _e364));
                                                let _e1433 = core_intrinsics_maximum_number_nsz_f32_(_e1432, (_e1416 - _e365));
                                                let _e1434 = core_intrinsics_minimum_number_nsz_f32_((_e1422 + _e363), (_e1425 + _e364));
                                                let _e1435 = core_intrinsics_minimum_number_nsz_f32_(_e1434, (_e1428 + _e365));
                                                if (_e1433 > -300000000000000000000000000000000000000f) {
                                                    phi_2075_ = _e1433;
                                                } else {
                                                    phi_2075_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1438 = phi_2075_;
                                                if (_e1435 < 300000000000000000000000000000000000000f) {
                                                    phi_2080_ = _e1435;
                                                } else {
                                                    phi_2080_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1441 = phi_2080_;
                                                if (_e1301 < _e1438) {
                                                    phi_2085_ = _e1438;
                                                } else {
                                                    phi_2085_ = _e1301;
                                                }
                                                let _e1444 = phi_2085_;
                                                if (_e1444 > _e1441) {
                                                    phi_2090_ = _e1441;
                                                } else {
                                                    phi_2090_ = _e1444;
                                                }
                                                let _e1447 = phi_2090_;
                                                phi_2095_ = lt_bvh_triangle_Intersection(_e1447, (_e1140 / _e1199), (_e1161 / _e1199), (_e1438 <= _e1441));
                                                phi_2096_ = false;
                                            } else {
                                                phi_2095_ = lt_bvh_triangle_Intersection();
                                                phi_2096_ = true;
                                            }
                                            let _e1453 = phi_2095_;
                                            let _e1455 = phi_2096_;
                                            phi_2097_ = _e1453;
                                            phi_2098_ = _e1455;
                                        } else {
                                            phi_2097_ = lt_bvh_triangle_Intersection();
                                            phi_2098_ = true;
                                        }
                                        let _e1457 = phi_2097_;
                                        let _e1459 = phi_2098_;
                                        if _e1459 {
                                        }
                                        phi_2102_ = _e1457;
                                        phi_2103_ = _e1459;
                                    }
                                    let _e1461 = phi_2102_;
                                    let _e1463 = phi_2103_;
                                    phi_2104_ = _e1461;
                                    phi_2105_ = _e1202;
                                    phi_2106_ = _e1463;
                                } else {
                                    phi_2104_ = lt_bvh_triangle_Intersection();
                                    phi_2105_ = true;
                                    phi_2106_ = false;
                                }
                                let _e1465 = phi_2104_;
                                let _e1467 = phi_2105_;
                                let _e1469 = phi_2106_;
                                if _e1467 {
                                    phi_2110_ = true;
                                } else {
                                    phi_2110_ = _e1469;
                                }
                                let _e1471 = phi_2110_;
                                if _e1471 {
                                    phi_2114_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_2114_ = _e1465;
                                }
                                let _e1473 = phi_2114_;
                                if _e1473.is_hit {
                                    if (_e1473.t > _e150.tmin) {
                                        if (_e1473.t < _e998.t) {
                                            phi_2163_ = true;
                                        } else {
                                            if (_e1473.t == _e998.t) {
                                                if (_e998.triangle != 4294967295u) {
                                                    if (_e1009 < _e998.triangle) {
                                                        phi_2154_ = true;
                                                    } else {
                                                        if (_e1009 == _e998.triangle) {
                                                            phi_2153_ = (4294967295u < _e998.instance);
                                                        } else {
                                                            phi_2153_ = false;
                                                        }
                                                        let _e1492 = phi_2153_;
                                                        phi_2154_ = _e1492;
                                                    }
                                                    let _e1494 = phi_2154_;
                                                    phi_2155_ = _e1494;
                                                    phi_2156_ = false;
                                                } else {
                                                    phi_2155_ = bool();
                                                    phi_2156_ = true;
                                                }
                                                let _e1496 = phi_2155_;
                                                let _e1498 = phi_2156_;
                                                phi_2157_ = _e1496;
                                                phi_2158_ = _e1498;
                                            } else {
                                                phi_2157_ = bool();
                                                phi_2158_ = true;
                                            }
                                            let _e1500 = phi_2157_;
                                            let _e1502 = phi_2158_;
                                            if _e1502 {
                                                phi_2162_ = false;
                                            } else {
                                                phi_2162_ = _e1500;
                                            }
                                            let _e1504 = phi_2162_;
                                            phi_2163_ = _e1504;
                                        }
                                        let _e1506 = phi_2163_;
                                        if _e1506 {
                                            let _e1508 = triangles.member[(0u + _e1009)].i0_;
                                            if ((_e1508 & 2147483648u) == 0u) {
                                                phi_2177_ = true;
                                            } else {
                                                if true {
                                                }
                                                phi_2177_ = true;
                                            }
                                            let _e1512 = phi_2177_;
                                            if _e1512 {
                                                phi_2185_ = lt_bvh_Hit(_e1473.t, _e1473.u, _e1473.v, _e1009, 4294967295u);
                                            } else {
                                                phi_2185_ = _e998;
                                            }
                                            let _e1518 = phi_2185_;
                                            phi_2186_ = _e1518;
                                        } else {
                                            phi_2186_ = _e998;
                                        }
                                        let _e1520 = phi_2186_;
                                        phi_2187_ = _e1520;
                                    } else {
                                        phi_2187_ = _e998;
                                    }
                                    let _e1522 = phi_2187_;
                                    phi_2188_ = _e1522;
                                } else {
                                    phi_2188_ = _e998;
                                }
                                let _e1524 = phi_2188_;
                                phi_1528_ = _e1524;
                                phi_1531_ = (_e1000 & (_e1000 - 1u));
                                phi_2189_ = true;
                            }
                            let _e1526 = phi_1528_;
                            let _e1528 = phi_1531_;
                            let _e1530 = phi_2189_;
                            continue;
                            continuing {
                                phi_1527_ = _e1526;
                                phi_1530_ = _e1528;
                                break if !(_e1530);
                            }
                        }
                        let _e1533 = local_1.group_mask;
                        if ((_e1533 & 4278190080u) == 0u) {
                            let _e1537 = local_1.len;
                            if (_e1537 == 0u) {
                                phi_2228_ = false;
                            } else {
                                let _e1541 = local_1.len;
                                local_1.len = (_e1541 - 1u);
                                let _e1544 = local_1.len;
                                if (_e1544 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1549 = local_1.first[(0u + _e1544)];
                                local_1.group = _e1549;
                                let _e1552 = local_1.len;
                                if (_e1552 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1557 = local_1.mask[(0u + _e1552)];
                                local_1.group_mask = _e1557;
                                phi_2228_ = true;
                            }
                            let _e1560 = phi_2228_;
                            phi_2229_ = _e1560;
                        } else {
                            phi_2229_ = true;
                        }
                        let _e1562 = phi_2229_;
                        if _e1562 {
                            let _e1564 = local_1.group_mask;
                            let _e1570 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1564)), 32u, (_e1564 == 0u)));
                            let _e1574 = local_1.group_mask;
                            let _e1588 = local_1.group_mask;
                            local_1.group_mask = (_e1588 & ~((1u << bitcast<u32>((_e1570 & 31u)))));
                            let _e1591 = local_1.group;
                            phi_2260_ = (_e1591 + countOneBits(((_e1574 & ~((4294967295u << bitcast<u32>((((_e1570 - 24u) ^ _e417) & 31u))))) & 255u)));
                        } else {
                            phi_2260_ = 4294967295u;
                        }
                        let _e1594 = phi_2260_;
                        let _e2436 = local_5;
                        phi_1191_ = _e2436;
                        phi_1194_ = _e1594;
                    } else {
                        phi_1191_ = lt_bvh_Hit();
                        phi_1194_ = u32();
                    }
                    let _e1596 = phi_1191_;
                    let _e1598 = phi_1194_;
                    continue;
                    continuing {
                        phi_1190_ = _e1596;
                        phi_1193_ = _e1598;
                        break if !(_e558);
                    }
                }
                let _e2440 = local_6;
                phi_2261_ = _e2440;
            }
            let _e1601 = phi_2261_;
            phi_2262_ = _e1601;
            phi_2263_ = _e214;
        } else {
            phi_2262_ = lt_bvh_Hit();
            phi_2263_ = true;
        }
        let _e1603 = phi_2262_;
        let _e1605 = phi_2263_;
        if _e1605 {
            phi_2267_ = _e152;
        } else {
            phi_2267_ = _e1603;
        }
        let _e1607 = phi_2267_;
        if (_e1607.triangle != 4294967295u) {
            let _e1613 = ((1f - _e1607.u) - _e1607.v);
            if (_e1607.triangle < _e77) {
            } else {
                return;
            }
            let _e1618 = triangles.member[(0u + _e1607.triangle)];
            let _e1643 = (((_e1618.v0_.x * _e1613) + (_e1618.v1_.x * _e1607.u)) + (_e1618.v2_.x * _e1607.v));
            let _e1644 = (((_e1618.v0_.y * _e1613) + (_e1618.v1_.y * _e1607.u)) + (_e1618.v2_.y * _e1607.v));
            let _e1645 = (((_e1618.v0_.z * _e1613) + (_e1618.v1_.z * _e1607.u)) + (_e1618.v2_.z * _e1607.v));
            let _e1648 = abs(_e1618.v0_.x);
            let _e1650 = abs(_e1618.v0_.y);
            let _e1652 = abs(_e1618.v0_.z);
            let _e1654 = abs(_e1618.v1_.x);
            let _e1656 = abs(_e1618.v1_.y);
            let _e1658 = abs(_e1618.v1_.z);
            if (_e1648 > _e1654) {
                phi_2331_ = _e1648;
            } else {
                phi_2331_ = _e1654;
            }
            let _e1661 = phi_2331_;
            if (_e1650 > _e1656) {
                phi_2336_ = _e1650;
            } else {
                phi_2336_ = _e1656;
            }
            let _e1664 = phi_2336_;
            if (_e1652 > _e1658) {
                phi_2341_ = _e1652;
            } else {
                phi_2341_ = _e1658;
            }
            let _e1667 = phi_2341_;
            let _e1669 = abs(_e1618.v2_.x);
            let _e1671 = abs(_e1618.v2_.y);
            let _e1673 = abs(_e1618.v2_.z);
            if (_e1661 > _e1669) {
                phi_2352_ = _e1661;
            } else {
                phi_2352_ = _e1669;
            }
            let _e1676 = phi_2352_;
            if (_e1664 > _e1671) {
                phi_2357_ = _e1664;
            } else {
                phi_2357_ = _e1671;
            }
            let _e1679 = phi_2357_;
            if (_e1667 > _e1673) {
                phi_2362_ = _e1667;
            } else {
                phi_2362_ = _e1673;
            }
            let _e1682 = phi_2362_;
            let _e1685 = (_e1618.v1_.x - _e1618.v0_.x);
            let _e1688 = (_e1618.v1_.y - _e1618.v0_.y);
            let _e1691 = (_e1618.v1_.z - _e1618.v0_.z);
            let _e1694 = (_e1618.v2_.x - _e1618.v0_.x);
            let _e1697 = (_e1618.v2_.y - _e1618.v0_.y);
            let _e1700 = (_e1618.v2_.z - _e1618.v0_.z);
            let _e1704 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1688), abs(_e1691));
            let _e1705 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1685), _e1704);
            let _e1706 = (_e1685 / _e1705);
            let _e1707 = (_e1688 / _e1705);
            let _e1708 = (_e1691 / _e1705);
            let _e1712 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1697), abs(_e1700));
            let _e1713 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1694), _e1712);
            let _e1714 = (_e1694 / _e1713);
            let _e1715 = (_e1697 / _e1713);
            let _e1716 = (_e1700 / _e1713);
            let _e1719 = ((_e1707 * _e1716) - (_e1715 * _e1708));
            let _e1722 = ((_e1708 * _e1714) - (_e1716 * _e1706));
            let _e1725 = ((_e1706 * _e1715) - (_e1714 * _e1707));
            let _e1727 = p.member.eye;
            let _e1740 = (1f / sqrt((((_e1719 * _e1719) + (_e1722 * _e1722)) + (_e1725 * _e1725))));
            let _e1741 = (_e1719 * _e1740);
            let _e1742 = (_e1722 * _e1740);
            let _e1743 = (_e1725 * _e1740);
            if ((((_e1741 * (_e1727.x - _e1643)) + (_e1742 * (_e1727.y - _e1644))) + (_e1743 * (_e1727.z - _e1645))) < 0f) {
                phi_2438_ = vec3<f32>(-(_e1741), -(_e1742), -(_e1743));
            } else {
                phi_2438_ = vec3<f32>(_e1741, _e1742, _e1743);
            }
            let _e1756 = phi_2438_;
            if (_e1607.triangle < _e77) {
            } else {
                return;
            }
            let _e1761 = triangles.member[(0u + _e1607.triangle)];
            let _e1763 = (_e1761.i0_ & 2147483647u);
            if (_e1763 < _e80) {
            } else {
                return;
            }
            let _e1769 = vertices.member[(0u + _e1763)];
            if (_e1761.i1_ < _e80) {
            } else {
                return;
            }
            let _e1773 = vertices.member[(0u + _e1761.i1_)];
            if (_e1761.i2_ < _e80) {
            } else {
                return;
            }
            let _e1777 = vertices.member[(0u + _e1761.i2_)];
            let _e1778 = array<abi_Vertex, 3>(_e1769, _e1773, _e1777);
            if (_e1778[0].material < arrayLength((&materials.member))) {
            } else {
                return;
            }
            let _e1784 = materials.member[(0u + _e1778[0].material)];
            let _e1801 = (1f / 255f);
            let _e1820 = (1f / 255f);
            let _e1842 = (1f / 255f);
            if (_e1784.color_size == 0u) {
                phi_2681_ = vec3<f32>(1f, 1f, 1f);
            } else {
                local.offset = _e1784.color_offset;
                local.size = _e1784.color_size;
                local.flags = _e1784.flags;
                let _e1885 = _lt_shaders_texture_TextureView_quad((&local), (((_e1778[0].u * _e1613) + (_e1778[1].u * _e1607.u)) + (_e1778[2].u * _e1607.v)), (((_e1778[0].v * _e1613) + (_e1778[1].v * _e1607.u)) + (_e1778[2].v * _e1607.v)));
                if (_e1885.indices[0] < _e89) {
                } else {
                    return;
                }
                let _e1891 = color_texels.member[(0u + _e1885.indices[0])];
                let _e1902 = (1f / 255f);
                if (_e1885.indices[1] < _e89) {
                } else {
                    return;
                }
                let _e1916 = color_texels.member[(0u + _e1885.indices[1])];
                let _e1927 = (1f / 255f);
                if (_e1885.indices[2] < _e89) {
                } else {
                    return;
                }
                let _e1944 = color_texels.member[(0u + _e1885.indices[2])];
                let _e1955 = (1f / 255f);
                if (_e1885.indices[3] < _e89) {
                } else {
                    return;
                }
                let _e1972 = color_texels.member[(0u + _e1885.indices[3])];
                let _e1983 = (1f / 255f);
                let _e1992 = (((((f32((_e1891 & 255u)) * _e1902) * _e1885.weights.x) + ((f32((_e1916 & 255u)) * _e1927) * _e1885.weights.y)) + ((f32((_e1944 & 255u)) * _e1955) * _e1885.weights.z)) + ((f32((_e1972 & 255u)) * _e1983) * _e1885.weights.w));
                let _e1993 = (((((f32(((_e1891 >> bitcast<u32>(8i)) & 255u)) * _e1902) * _e1885.weights.x) + ((f32(((_e1916 >> bitcast<u32>(8i)) & 255u)) * _e1927) * _e1885.weights.y)) + ((f32(((_e1944 >> bitcast<u32>(8i)) & 255u)) * _e1955) * _e1885.weights.z)) + ((f32(((_e1972 >> bitcast<u32>(8i)) & 255u)) * _e1983) * _e1885.weights.w));
                let _e1994 = (((((f32(((_e1891 >> bitcast<u32>(16i)) & 255u)) * _e1902) * _e1885.weights.x) + ((f32(((_e1916 >> bitcast<u32>(16i)) & 255u)) * _e1927) * _e1885.weights.y)) + ((f32(((_e1944 >> bitcast<u32>(16i)) & 255u)) * _e1955) * _e1885.weights.z)) + ((f32(((_e1972 >> bitcast<u32>(16i)) & 255u)) * _e1983) * _e1885.weights.w));
                phi_2681_ = vec3<f32>((_e1992 * _e1992), (_e1993 * _e1993), (_e1994 * _e1994));
            }
            let _e2000 = phi_2681_;
            let _e2002 = ((_e1784.base_color.x * ((((f32((_e1778[0].color & 255u)) * _e1801) * _e1613) + ((f32((_e1778[1].color & 255u)) * _e1820) * _e1607.u)) + ((f32((_e1778[2].color & 255u)) * _e1842) * _e1607.v))) * _e2000.x);
            let _e2004 = ((_e1784.base_color.y * ((((f32(((_e1778[0].color >> bitcast<u32>(8i)) & 255u)) * _e1801) * _e1613) + ((f32(((_e1778[1].color >> bitcast<u32>(8i)) & 255u)) * _e1820) * _e1607.u)) + ((f32(((_e1778[2].color >> bitcast<u32>(8i)) & 255u)) * _e1842) * _e1607.v))) * _e2000.y);
            let _e2006 = ((_e1784.base_color.z * ((((f32(((_e1778[0].color >> bitcast<u32>(16i)) & 255u)) * _e1801) * _e1613) + ((f32(((_e1778[1].color >> bitcast<u32>(16i)) & 255u)) * _e1820) * _e1607.u)) + ((f32(((_e1778[2].color >> bitcast<u32>(16i)) & 255u)) * _e1842) * _e1607.v))) * _e2000.z);
            let _e2007 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1679, _e1682);
            let _e2008 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1676, _e2007);
            if ((_e1784.flags & 2u) == 0u) {
                phi_2696_ = 0u;
            } else {
                phi_2696_ = 1u;
            }
            let _e2013 = phi_2696_;
            if (_e1778[0].normal == 2147516416u) {
                phi_2899_ = _e1756;
            } else {
                let _e2026 = (f32((bitcast<i32>((_e1778[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2032 = (f32((bitcast<i32>(_e1778[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2036 = ((1f - abs(_e2026)) - abs(_e2032));
                if (_e2036 < 0f) {
                    phi_2723_ = -(_e2036);
                } else {
                    phi_2723_ = 0f;
                }
                let _e2040 = phi_2723_;
                if (_e2026 < 0f) {
                    phi_2730_ = (_e2026 + _e2040);
                } else {
                    phi_2730_ = (_e2026 - _e2040);
                }
                let _e2045 = phi_2730_;
                if (_e2032 < 0f) {
                    phi_2737_ = (_e2032 + _e2040);
                } else {
                    phi_2737_ = (_e2032 - _e2040);
                }
                let _e2050 = phi_2737_;
                let _e2057 = (1f / sqrt((((_e2045 * _e2045) + (_e2050 * _e2050)) + (_e2036 * _e2036))));
                let _e2073 = (f32((bitcast<i32>((_e1778[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2079 = (f32((bitcast<i32>(_e1778[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2083 = ((1f - abs(_e2073)) - abs(_e2079));
                if (_e2083 < 0f) {
                    phi_2772_ = -(_e2083);
                } else {
                    phi_2772_ = 0f;
                }
                let _e2087 = phi_2772_;
                if (_e2073 < 0f) {
                    phi_2779_ = (_e2073 + _e2087);
                } else {
                    phi_2779_ = (_e2073 - _e2087);
                }
                let _e2092 = phi_2779_;
                if (_e2079 < 0f) {
                    phi_2786_ = (_e2079 + _e2087);
                } else {
                    phi_2786_ = (_e2079 - _e2087);
                }
                let _e2097 = phi_2786_;
                let _e2104 = (1f / sqrt((((_e2092 * _e2092) + (_e2097 * _e2097)) + (_e2083 * _e2083))));
                let _e2123 = (f32((bitcast<i32>((_e1778[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2129 = (f32((bitcast<i32>(_e1778[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2133 = ((1f - abs(_e2123)) - abs(_e2129));
                if (_e2133 < 0f) {
                    phi_2824_ = -(_e2133);
                } else {
                    phi_2824_ = 0f;
                }
                let _e2137 = phi_2824_;
                if (_e2123 < 0f) {
                    phi_2831_ = (_e2123 + _e2137);
                } else {
                    phi_2831_ = (_e2123 - _e2137);
                }
                let _e2142 = phi_2831_;
                if (_e2129 < 0f) {
                    phi_2838_ = (_e2129 + _e2137);
                } else {
                    phi_2838_ = (_e2129 - _e2137);
                }
                let _e2147 = phi_2838_;
                let _e2154 = (1f / sqrt((((_e2142 * _e2142) + (_e2147 * _e2147)) + (_e2133 * _e2133))));
                let _e2165 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(vec3<f32>(((((_e2045 * _e2057) * _e1613) + ((_e2092 * _e2104) * _e1607.u)) + ((_e2142 * _e2154) * _e1607.v)), ((((_e2050 * _e2057) * _e1613) + ((_e2097 * _e2104) * _e1607.u)) + ((_e2147 * _e2154) * _e1607.v)), ((((_e2036 * _e2057) * _e1613) + ((_e2083 * _e2104) * _e1607.u)) + ((_e2133 * _e2154) * _e1607.v))));
                let _e2177 = sqrt((((_e2165.x * _e2165.x) + (_e2165.y * _e2165.y)) + (_e2165.z * _e2165.z)));
                if (_e2177 > 0f) {
                    let _e2180 = (_e2165.x / _e2177);
                    let _e2182 = (_e2165.y / _e2177);
                    let _e2184 = (_e2165.z / _e2177);
                    if ((((_e2180 * _e1756.x) + (_e2182 * _e1756.y)) + (_e2184 * _e1756.z)) < 0f) {
                        phi_2897_ = vec3<f32>(-(_e2180), -(_e2182), -(_e2184));
                    } else {
                        phi_2897_ = (_e2165 / vec3(_e2177));
                    }
                    let _e2201 = phi_2897_;
                    phi_2898_ = _e2201;
                } else {
                    phi_2898_ = _e1756;
                }
                let _e2203 = phi_2898_;
                phi_2899_ = _e2203;
            }
            let _e2205 = phi_2899_;
            if (_e2002 > 0f) {
                if (_e2002 < 1f) {
                    phi_2908_ = _e2002;
                } else {
                    phi_2908_ = 1f;
                }
                let _e2209 = phi_2908_;
                phi_2909_ = _e2209;
            } else {
                phi_2909_ = 0f;
            }
            let _e2211 = phi_2909_;
            if (_e2004 > 0f) {
                if (_e2004 < 1f) {
                    phi_2919_ = _e2004;
                } else {
                    phi_2919_ = 1f;
                }
                let _e2216 = phi_2919_;
                phi_2920_ = _e2216;
            } else {
                phi_2920_ = 0f;
            }
            let _e2218 = phi_2920_;
            if (_e2006 > 0f) {
                if (_e2006 < 1f) {
                    phi_2930_ = _e2006;
                } else {
                    phi_2930_ = 1f;
                }
                let _e2223 = phi_2930_;
                phi_2931_ = _e2223;
            } else {
                phi_2931_ = 0f;
            }
            let _e2225 = phi_2931_;
            let _e2228 = ((sqrt(_e2211) * 255f) + 0.5f);
            let _e2237 = ((sqrt(_e2218) * 255f) + 0.5f);
            let _e2249 = ((sqrt(_e2225) * 255f) + 0.5f);
            phi_2966_ = abi_Sample(vec3<f32>(_e1643, _e1644, _e1645), _e2008, _e1756, _e2013, _e2205, ((select(select(u32(_e2228), 0u, (_e2228 < bitcast<f32>(0u))), 4294967295u, (_e2228 > bitcast<f32>(1333788671u))) | (select(select(u32(_e2237), 0u, (_e2237 < bitcast<f32>(0u))), 4294967295u, (_e2237 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e2249), 0u, (_e2249 < bitcast<f32>(0u))), 4294967295u, (_e2249 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_2966_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e2263 = phi_2966_;
        if (_e95.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e95.shift)] = _e2263;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_color_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
