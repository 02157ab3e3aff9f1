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

struct type_28 {
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

struct type_36 {
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

struct type_40 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_44 {
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

struct type_48 {
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

var<private> id_1: vec3<u32>;
@group(0) @binding(3) 
var<storage> vertices: type_44;
@group(0) @binding(4) 
var<storage> materials: type_48;
@group(0) @binding(0) 
var<uniform> p: type_56;
@group(0) @binding(1) 
var<storage> nodes: type_36;
@group(0) @binding(2) 
var<storage> triangles: type_40;
@group(0) @binding(5) 
var<storage, read_write> samples: type_20;
@group(0) @binding(6) 
var<storage> alpha_texels: type_9;
@group(0) @binding(7) 
var<storage> color_texels: type_9;
@group(0) @binding(8) 
var<storage> before: type_28;
@group(0) @binding(9) 
var<storage, read_write> past: type_28;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_224_: lt_bvh_traverse_Tree;
    var phi_225_: bool;
    var phi_226_: lt_bvh_traverse_Tree;
    var phi_227_: bool;
    var phi_232_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_224_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_225_ = false;
        } else {
            phi_224_ = lt_bvh_traverse_Tree();
            phi_225_ = true;
        }
        let _e86 = phi_224_;
        let _e88 = phi_225_;
        phi_226_ = _e86;
        phi_227_ = _e88;
    } else {
        phi_226_ = lt_bvh_traverse_Tree();
        phi_227_ = true;
    }
    let _e90 = phi_226_;
    let _e92 = phi_227_;
    if _e92 {
        phi_232_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_232_ = _e90;
    }
    let _e97 = phi_232_;
    return lt_bvh_traverse_Tree(_e97.root, _e97.first_primitive);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_247_: bool;
    var phi_251_: f32;

    if (param_3 != param_3) {
        phi_247_ = true;
    } else {
        let _e76 = (param_4 >= param_3);
        if _e76 {
        }
        phi_247_ = _e76;
    }
    let _e78 = phi_247_;
    if _e78 {
        phi_251_ = param_4;
    } else {
        phi_251_ = param_3;
    }
    let _e80 = phi_251_;
    return _e80;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_263_: bool;
    var phi_267_: f32;

    if (param_5 != param_5) {
        phi_263_ = true;
    } else {
        let _e76 = (param_6 <= param_5);
        if _e76 {
        }
        phi_263_ = _e76;
    }
    let _e78 = phi_263_;
    if _e78 {
        phi_267_ = param_6;
    } else {
        phi_267_ = param_5;
    }
    let _e80 = phi_267_;
    return _e80;
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

    let _e77 = (*param_7).size;
    let _e78 = (_e77 & 65535u);
    let _e80 = (*param_7).size;
    let _e82 = (_e80 >> bitcast<u32>(16i));
    let _e84 = (*param_7).flags;
    let _e86 = ((_e84 & 4u) != 0u);
    let _e88 = (*param_7).flags;
    let _e91 = ((_e88 >> bitcast<u32>(4u)) & 3u);
    if (_e91 == 0u) {
        if (param_8 > -8388608f) {
            let _e104 = f32(select(0i, select(select(i32(param_8), i32(-2147483648), (param_8 < bitcast<f32>(3472883712u))), 2147483647i, (param_8 > bitcast<f32>(1325400063u))), (param_8 == param_8)));
            if (_e104 > param_8) {
                phi_309_ = 1f;
            } else {
                phi_309_ = 0f;
            }
            let _e107 = phi_309_;
            if (param_8 < 8388608f) {
                phi_314_ = (_e104 - _e107);
                phi_315_ = false;
            } else {
                phi_314_ = f32();
                phi_315_ = true;
            }
            let _e110 = phi_314_;
            let _e112 = phi_315_;
            phi_316_ = _e110;
            phi_317_ = _e112;
        } else {
            phi_316_ = f32();
            phi_317_ = true;
        }
        let _e114 = phi_316_;
        let _e116 = phi_317_;
        if _e116 {
            phi_321_ = param_8;
        } else {
            phi_321_ = _e114;
        }
        let _e118 = phi_321_;
        phi_369_ = (param_8 - _e118);
    } else {
        if (_e91 == 1u) {
            let _e121 = (param_8 * 0.5f);
            if (_e121 > -8388608f) {
                let _e133 = f32(select(0i, select(select(i32(_e121), i32(-2147483648), (_e121 < bitcast<f32>(3472883712u))), 2147483647i, (_e121 > bitcast<f32>(1325400063u))), (_e121 == _e121)));
                if (_e133 > _e121) {
                    phi_347_ = 1f;
                } else {
                    phi_347_ = 0f;
                }
                let _e136 = phi_347_;
                if (_e121 < 8388608f) {
                    phi_352_ = (_e133 - _e136);
                    phi_353_ = false;
                } else {
                    phi_352_ = f32();
                    phi_353_ = true;
                }
                let _e139 = phi_352_;
                let _e141 = phi_353_;
                phi_354_ = _e139;
                phi_355_ = _e141;
            } else {
                phi_354_ = f32();
                phi_355_ = true;
            }
            let _e143 = phi_354_;
            let _e145 = phi_355_;
            if _e145 {
                phi_359_ = _e121;
            } else {
                phi_359_ = _e143;
            }
            let _e147 = phi_359_;
            let _e149 = (param_8 - (2f * _e147));
            if (_e149 > 1f) {
                phi_367_ = (2f - _e149);
            } else {
                phi_367_ = _e149;
            }
            let _e153 = phi_367_;
            phi_368_ = _e153;
        } else {
            phi_368_ = param_8;
        }
        let _e155 = phi_368_;
        phi_369_ = _e155;
    }
    let _e157 = phi_369_;
    if (_e157 > 0f) {
        if (_e157 < 1f) {
            phi_378_ = _e157;
        } else {
            phi_378_ = 1f;
        }
        let _e161 = phi_378_;
        phi_379_ = _e161;
    } else {
        phi_379_ = 0f;
    }
    let _e163 = phi_379_;
    let _e164 = (_e78 - 1u);
    let _e166 = (_e163 * f32(_e78));
    if _e86 {
        let _e173 = select(select(u32(_e166), 0u, (_e166 < bitcast<f32>(0u))), 4294967295u, (_e166 > bitcast<f32>(1333788671u)));
        if (_e164 < _e173) {
            phi_397_ = _e164;
        } else {
            phi_397_ = _e173;
        }
        let _e176 = phi_397_;
        phi_436_ = texture_Axis(_e176, _e176, 0f);
    } else {
        let _e178 = (_e166 + 0.5f);
        let _e185 = select(select(u32(_e178), 0u, (_e178 < bitcast<f32>(0u))), 4294967295u, (_e178 > bitcast<f32>(1333788671u)));
        if (_e78 < _e185) {
            phi_411_ = _e78;
        } else {
            phi_411_ = _e185;
        }
        let _e188 = phi_411_;
        if (_e91 == 0u) {
            phi_418_ = _e164;
        } else {
            phi_418_ = 0u;
        }
        let _e193 = phi_418_;
        if (_e91 == 0u) {
            phi_423_ = 0u;
        } else {
            phi_423_ = _e164;
        }
        let _e196 = phi_423_;
        if (_e188 == 0u) {
            phi_429_ = _e193;
        } else {
            phi_429_ = (_e188 - 1u);
        }
        let _e200 = phi_429_;
        if (_e188 > _e164) {
            phi_434_ = _e196;
        } else {
            phi_434_ = _e188;
        }
        let _e203 = phi_434_;
        phi_436_ = texture_Axis(_e200, _e203, (_e178 - f32(_e188)));
    }
    let _e206 = phi_436_;
    let _e208 = (*param_7).flags;
    let _e211 = ((_e208 >> bitcast<u32>(6u)) & 3u);
    if (_e211 == 0u) {
        if (param_9 > -8388608f) {
            let _e224 = f32(select(0i, select(select(i32(param_9), i32(-2147483648), (param_9 < bitcast<f32>(3472883712u))), 2147483647i, (param_9 > bitcast<f32>(1325400063u))), (param_9 == param_9)));
            if (_e224 > param_9) {
                phi_464_ = 1f;
            } else {
                phi_464_ = 0f;
            }
            let _e227 = phi_464_;
            if (param_9 < 8388608f) {
                phi_469_ = (_e224 - _e227);
                phi_470_ = false;
            } else {
                phi_469_ = f32();
                phi_470_ = true;
            }
            let _e230 = phi_469_;
            let _e232 = phi_470_;
            phi_471_ = _e230;
            phi_472_ = _e232;
        } else {
            phi_471_ = f32();
            phi_472_ = true;
        }
        let _e234 = phi_471_;
        let _e236 = phi_472_;
        if _e236 {
            phi_476_ = param_9;
        } else {
            phi_476_ = _e234;
        }
        let _e238 = phi_476_;
        phi_524_ = (param_9 - _e238);
    } else {
        if (_e211 == 1u) {
            let _e241 = (param_9 * 0.5f);
            if (_e241 > -8388608f) {
                let _e253 = f32(select(0i, select(select(i32(_e241), i32(-2147483648), (_e241 < bitcast<f32>(3472883712u))), 2147483647i, (_e241 > bitcast<f32>(1325400063u))), (_e241 == _e241)));
                if (_e253 > _e241) {
                    phi_502_ = 1f;
                } else {
                    phi_502_ = 0f;
                }
                let _e256 = phi_502_;
                if (_e241 < 8388608f) {
                    phi_507_ = (_e253 - _e256);
                    phi_508_ = false;
                } else {
                    phi_507_ = f32();
                    phi_508_ = true;
                }
                let _e259 = phi_507_;
                let _e261 = phi_508_;
                phi_509_ = _e259;
                phi_510_ = _e261;
            } else {
                phi_509_ = f32();
                phi_510_ = true;
            }
            let _e263 = phi_509_;
            let _e265 = phi_510_;
            if _e265 {
                phi_514_ = _e241;
            } else {
                phi_514_ = _e263;
            }
            let _e267 = phi_514_;
            let _e269 = (param_9 - (2f * _e267));
            if (_e269 > 1f) {
                phi_522_ = (2f - _e269);
            } else {
                phi_522_ = _e269;
            }
            let _e273 = phi_522_;
            phi_523_ = _e273;
        } else {
            phi_523_ = param_9;
        }
        let _e275 = phi_523_;
        phi_524_ = _e275;
    }
    let _e277 = phi_524_;
    if (_e277 > 0f) {
        if (_e277 < 1f) {
            phi_533_ = _e277;
        } else {
            phi_533_ = 1f;
        }
        let _e281 = phi_533_;
        phi_534_ = _e281;
    } else {
        phi_534_ = 0f;
    }
    let _e283 = phi_534_;
    let _e284 = (_e82 - 1u);
    let _e286 = (_e283 * f32(_e82));
    if _e86 {
        let _e293 = select(select(u32(_e286), 0u, (_e286 < bitcast<f32>(0u))), 4294967295u, (_e286 > bitcast<f32>(1333788671u)));
        if (_e284 < _e293) {
            phi_552_ = _e284;
        } else {
            phi_552_ = _e293;
        }
        let _e296 = phi_552_;
        phi_591_ = texture_Axis(_e296, _e296, 0f);
    } else {
        let _e298 = (_e286 + 0.5f);
        let _e305 = select(select(u32(_e298), 0u, (_e298 < bitcast<f32>(0u))), 4294967295u, (_e298 > bitcast<f32>(1333788671u)));
        if (_e82 < _e305) {
            phi_566_ = _e82;
        } else {
            phi_566_ = _e305;
        }
        let _e308 = phi_566_;
        if (_e211 == 0u) {
            phi_573_ = _e284;
        } else {
            phi_573_ = 0u;
        }
        let _e313 = phi_573_;
        if (_e211 == 0u) {
            phi_578_ = 0u;
        } else {
            phi_578_ = _e284;
        }
        let _e316 = phi_578_;
        if (_e308 == 0u) {
            phi_584_ = _e313;
        } else {
            phi_584_ = (_e308 - 1u);
        }
        let _e320 = phi_584_;
        if (_e308 > _e284) {
            phi_589_ = _e316;
        } else {
            phi_589_ = _e308;
        }
        let _e323 = phi_589_;
        phi_591_ = texture_Axis(_e320, _e323, (_e298 - f32(_e308)));
    }
    let _e326 = phi_591_;
    let _e330 = (*param_7).offset;
    let _e337 = (*param_7).offset;
    let _e344 = (*param_7).offset;
    let _e351 = (*param_7).offset;
    return texture_TexelQuad(array<u32, 4>(((_e330 + (_e326.low * _e78)) + _e206.low), ((_e337 + (_e326.low * _e78)) + _e206.high), ((_e344 + (_e326.high * _e78)) + _e206.low), ((_e351 + (_e326.high * _e78)) + _e206.high)), vec4<f32>(((1f - _e206.fraction) * (1f - _e326.fraction)), (_e206.fraction * (1f - _e326.fraction)), ((1f - _e206.fraction) * _e326.fraction), (_e206.fraction * _e326.fraction)));
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
    let _e77 = phi_650_;
    return _e77;
}

fn _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(param_14: vec3<f32>) -> vec3<f32> {
    return param_14;
}

fn _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(param_15: vec3<f32>) -> vec3<f32> {
    return param_15;
}

fn function_() {
    var local: texture_TextureView;
    var local_1: texture_TextureView;
    var local_2: lt_bvh_traverse_Stack;
    var phi_802_: bool;
    var phi_803_: bool;
    var phi_804_: bool;
    var phi_805_: bool;
    var phi_809_: bool;
    var phi_822_: bool;
    var phi_823_: bool;
    var phi_824_: bool;
    var phi_825_: bool;
    var phi_829_: bool;
    var phi_842_: bool;
    var phi_843_: bool;
    var phi_844_: bool;
    var phi_848_: bool;
    var phi_849_: bool;
    var phi_850_: bool;
    var phi_851_: bool;
    var phi_852_: bool;
    var phi_856_: bool;
    var phi_932_: f32;
    var phi_939_: f32;
    var phi_947_: f32;
    var phi_954_: f32;
    var phi_962_: f32;
    var phi_969_: f32;
    var phi_992_: f32;
    var phi_997_: f32;
    var phi_1002_: f32;
    var phi_1007_: f32;
    var phi_1012_: f32;
    var phi_1043_: bool;
    var phi_1044_: bool;
    var phi_1052_: u32;
    var phi_1053_: u32;
    var phi_1070_: vec3<f32>;
    var phi_1071_: vec3<f32>;
    var phi_1084_: u32;
    var phi_1089_: u32;
    var phi_1094_: u32;
    var phi_1208_: bool;
    var phi_1209_: bool;
    var phi_1240_: u32;
    var phi_1242_: lt_bvh_Hit;
    var phi_1245_: u32;
    var phi_1330_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1357_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1384_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1390_: u32;
    var phi_1393_: u32;
    var phi_1407_: u32;
    var phi_1417_: u32;
    var phi_1427_: u32;
    var phi_1445_: u32;
    var phi_1455_: u32;
    var phi_1465_: u32;
    var phi_1501_: u32;
    var phi_1514_: u32;
    var phi_1519_: u32;
    var phi_1520_: u32;
    var phi_1521_: u32;
    var phi_1391_: u32;
    var phi_1394_: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_1579_: lt_bvh_Hit;
    var phi_1582_: u32;
    var phi_1628_: vec3<f32>;
    var phi_1629_: vec3<f32>;
    var phi_1660_: vec3<f32>;
    var phi_1661_: vec3<f32>;
    var phi_1692_: vec3<f32>;
    var phi_1693_: vec3<f32>;
    var phi_1711_: bool;
    var phi_1712_: bool;
    var phi_1716_: f32;
    var phi_1717_: f32;
    var phi_1718_: f32;
    var phi_1719_: f32;
    var phi_1727_: f32;
    var phi_1737_: bool;
    var phi_1738_: bool;
    var phi_1742_: f32;
    var phi_1743_: f32;
    var phi_1744_: f32;
    var phi_1745_: f32;
    var phi_1753_: f32;
    var phi_1763_: bool;
    var phi_1764_: bool;
    var phi_1768_: f32;
    var phi_1769_: f32;
    var phi_1770_: f32;
    var phi_1771_: f32;
    var phi_1779_: f32;
    var phi_1794_: f32;
    var phi_1795_: bool;
    var phi_1796_: f32;
    var phi_1797_: bool;
    var phi_1798_: f32;
    var phi_1799_: bool;
    var phi_1817_: f32;
    var phi_1818_: bool;
    var phi_1819_: bool;
    var phi_1820_: f32;
    var phi_1821_: bool;
    var phi_1822_: bool;
    var phi_1826_: bool;
    var phi_1827_: f32;
    var phi_1828_: bool;
    var phi_1858_: vec3<f32>;
    var phi_1859_: vec3<f32>;
    var phi_1884_: vec3<f32>;
    var phi_1885_: vec3<f32>;
    var phi_1910_: vec3<f32>;
    var phi_1911_: vec3<f32>;
    var phi_1969_: f32;
    var phi_1978_: f32;
    var phi_1987_: f32;
    var phi_1996_: f32;
    var phi_2003_: f32;
    var phi_2010_: f32;
    var phi_2023_: f32;
    var phi_2032_: f32;
    var phi_2041_: f32;
    var phi_2050_: f32;
    var phi_2057_: f32;
    var phi_2064_: f32;
    var phi_2087_: f32;
    var phi_2092_: f32;
    var phi_2097_: f32;
    var phi_2105_: f32;
    var phi_2110_: f32;
    var phi_2115_: f32;
    var phi_2127_: f32;
    var phi_2132_: f32;
    var phi_2137_: f32;
    var phi_2142_: f32;
    var phi_2147_: lt_bvh_triangle_Intersection;
    var phi_2148_: bool;
    var phi_2149_: lt_bvh_triangle_Intersection;
    var phi_2150_: bool;
    var phi_2154_: lt_bvh_triangle_Intersection;
    var phi_2155_: bool;
    var phi_2156_: lt_bvh_triangle_Intersection;
    var phi_2157_: bool;
    var phi_2158_: bool;
    var phi_2162_: bool;
    var phi_2166_: lt_bvh_triangle_Intersection;
    var phi_2205_: bool;
    var phi_2206_: bool;
    var phi_2207_: bool;
    var phi_2208_: bool;
    var phi_2209_: bool;
    var phi_2210_: bool;
    var phi_2214_: bool;
    var phi_2215_: bool;
    var phi_2418_: f32;
    var phi_2421_: bool;
    var phi_2422_: bool;
    var phi_2426_: bool;
    var phi_2434_: lt_bvh_Hit;
    var phi_2435_: lt_bvh_Hit;
    var phi_2436_: lt_bvh_Hit;
    var phi_2437_: lt_bvh_Hit;
    var phi_1580_: lt_bvh_Hit;
    var phi_1583_: u32;
    var phi_2438_: bool;
    var phi_2477_: bool;
    var phi_2478_: bool;
    var phi_2509_: u32;
    var phi_1243_: lt_bvh_Hit;
    var phi_1246_: u32;
    var phi_2510_: lt_bvh_Hit;
    var phi_2511_: lt_bvh_Hit;
    var phi_2512_: bool;
    var phi_2516_: lt_bvh_Hit;
    var phi_2580_: f32;
    var phi_2585_: f32;
    var phi_2590_: f32;
    var phi_2601_: f32;
    var phi_2606_: f32;
    var phi_2611_: f32;
    var phi_2687_: vec3<f32>;
    var phi_2930_: vec3<f32>;
    var phi_2945_: u32;
    var phi_2972_: f32;
    var phi_2979_: f32;
    var phi_2986_: f32;
    var phi_3021_: f32;
    var phi_3028_: f32;
    var phi_3035_: f32;
    var phi_3073_: f32;
    var phi_3080_: f32;
    var phi_3087_: f32;
    var phi_3146_: vec3<f32>;
    var phi_3147_: vec3<f32>;
    var phi_3148_: vec3<f32>;
    var phi_3157_: f32;
    var phi_3158_: f32;
    var phi_3168_: f32;
    var phi_3169_: f32;
    var phi_3179_: f32;
    var phi_3180_: f32;
    var phi_3215_: abi_Sample;
    var phi_3306_: vec3<f32>;
    var local_6: lt_bvh_Hit;
    var local_7: lt_bvh_Hit;

    let _e76 = id_1;
    let _e80 = arrayLength((&nodes.member));
    let _e83 = arrayLength((&triangles.member));
    let _e86 = arrayLength((&vertices.member));
    let _e89 = arrayLength((&materials.member));
    let _e95 = arrayLength((&alpha_texels.member));
    let _e98 = arrayLength((&color_texels.member));
    let _e101 = arrayLength((&before.member));
    let _e107 = p.member.size[0u];
    let _e109 = p.member.size[1u];
    let _e110 = lt_shaders_entry_pixel_index(_e76, _e107, _e109);
    if (bitcast<i32>(_e110.root) != 0i) {
        let _e118 = p.member.eye;
        let _e121 = p.member.grid[0u];
        let _e123 = p.member.grid[1u];
        let _e142 = p.member.size[0u];
        let _e146 = ((((f32(_e76.x) + ((f32((_e76.y & (_e123 - 1u))) + 0.5f) / f32(_e123))) / f32(_e142)) * 2f) - 1f);
        let _e149 = p.member.size[1u];
        let _e153 = (1f - (((f32(_e76.y) + ((f32((_e76.x & (_e121 - 1u))) + 0.5f) / f32(_e121))) / f32(_e149)) * 2f));
        let _e155 = p.member.forward;
        let _e157 = p.member.right;
        let _e171 = p.member.up;
        let _e182 = _lt_bvh_ray_Ray_new(_e118, vec3<f32>(((_e155.x + (_e157.x * _e146)) + (_e171.x * _e153)), ((_e155.y + (_e157.y * _e146)) + (_e171.y * _e153)), ((_e155.z + (_e157.z * _e146)) + (_e171.z * _e153))));
        let _e184 = lt_bvh_Hit(_e182.tmax, 0f, 0f, 4294967295u, 4294967295u);
        let _e187 = abs(_e182.direction.x);
        let _e189 = abs(_e182.direction.y);
        let _e191 = abs(_e182.direction.z);
        if (abs(_e182.origin.x) < 1000000000000000f) {
            if (abs(_e182.origin.y) < 1000000000000000f) {
                phi_802_ = (abs(_e182.origin.z) < 1000000000000000f);
                phi_803_ = false;
            } else {
                phi_802_ = bool();
                phi_803_ = true;
            }
            let _e203 = phi_802_;
            let _e205 = phi_803_;
            phi_804_ = _e203;
            phi_805_ = _e205;
        } else {
            phi_804_ = bool();
            phi_805_ = true;
        }
        let _e207 = phi_804_;
        let _e209 = phi_805_;
        if _e209 {
            phi_809_ = false;
        } else {
            phi_809_ = _e207;
        }
        let _e211 = phi_809_;
        if _e211 {
            if (_e187 < 1000000000000000f) {
                if (_e189 < 1000000000000000f) {
                    phi_822_ = (_e191 < 1000000000000000f);
                    phi_823_ = false;
                } else {
                    phi_822_ = bool();
                    phi_823_ = true;
                }
                let _e216 = phi_822_;
                let _e218 = phi_823_;
                phi_824_ = _e216;
                phi_825_ = _e218;
            } else {
                phi_824_ = bool();
                phi_825_ = true;
            }
            let _e220 = phi_824_;
            let _e222 = phi_825_;
            if _e222 {
                phi_829_ = false;
            } else {
                phi_829_ = _e220;
            }
            let _e224 = phi_829_;
            if _e224 {
                if (_e187 > 0f) {
                    phi_843_ = bool();
                    phi_844_ = true;
                } else {
                    let _e226 = (_e189 > 0f);
                    if _e226 {
                        phi_842_ = bool();
                    } else {
                        phi_842_ = (_e191 > 0f);
                    }
                    let _e229 = phi_842_;
                    phi_843_ = _e229;
                    phi_844_ = _e226;
                }
                let _e231 = phi_843_;
                let _e233 = phi_844_;
                if _e233 {
                    phi_848_ = true;
                } else {
                    phi_848_ = _e231;
                }
                let _e235 = phi_848_;
                phi_849_ = _e235;
                phi_850_ = false;
            } else {
                phi_849_ = bool();
                phi_850_ = true;
            }
            let _e237 = phi_849_;
            let _e239 = phi_850_;
            phi_851_ = _e237;
            phi_852_ = _e239;
        } else {
            phi_851_ = bool();
            phi_852_ = true;
        }
        let _e241 = phi_851_;
        let _e243 = phi_852_;
        if _e243 {
            phi_856_ = false;
        } else {
            phi_856_ = _e241;
        }
        let _e245 = phi_856_;
        if _e245 {
            let _e246 = (0u >= _e80);
            if _e246 {
                phi_2510_ = lt_bvh_Hit();
            } else {
                if (0u < _e80) {
                } else {
                    return;
                }
                let _e252 = nodes.member[(0u + 0u)].frame[0u];
                let _e256 = nodes.member[(0u + 0u)].frame[1u];
                let _e260 = nodes.member[(0u + 0u)].frame[2u];
                let _e264 = nodes.member[(0u + 0u)].frame[0u];
                let _e268 = nodes.member[(0u + 0u)].frame[1u];
                let _e272 = nodes.member[(0u + 0u)].frame[2u];
                let _e276 = nodes.member[(0u + 0u)].frame[3u];
                let _e315 = core_intrinsics_maximum_number_nsz_f32_(abs(_e182.direction.x), abs(_e182.direction.y));
                let _e316 = core_intrinsics_maximum_number_nsz_f32_(_e315, abs(_e182.direction.z));
                let _e317 = (_e316 * 0.0000000000009094947f);
                if (abs(_e182.direction.x) < _e317) {
                    phi_932_ = _e317;
                } else {
                    phi_932_ = abs(_e182.direction.x);
                }
                let _e323 = phi_932_;
                if (_e182.direction.x < 0f) {
                    phi_939_ = (-1f / _e323);
                } else {
                    phi_939_ = (1f / _e323);
                }
                let _e328 = phi_939_;
                if (abs(_e182.direction.y) < _e317) {
                    phi_947_ = _e317;
                } else {
                    phi_947_ = abs(_e182.direction.y);
                }
                let _e334 = phi_947_;
                if (_e182.direction.y < 0f) {
                    phi_954_ = (-1f / _e334);
                } else {
                    phi_954_ = (1f / _e334);
                }
                let _e339 = phi_954_;
                if (abs(_e182.direction.z) < _e317) {
                    phi_962_ = _e317;
                } else {
                    phi_962_ = abs(_e182.direction.z);
                }
                let _e345 = phi_962_;
                if (_e182.direction.z < 0f) {
                    phi_969_ = (-1f / _e345);
                } else {
                    phi_969_ = (1f / _e345);
                }
                let _e350 = phi_969_;
                let _e357 = abs((bitcast<f32>(_e252) - _e182.origin.x));
                let _e358 = abs((bitcast<f32>(_e256) - _e182.origin.y));
                let _e359 = abs((bitcast<f32>(_e260) - _e182.origin.z));
                let _e366 = abs(((bitcast<f32>(_e264) + (bitcast<f32>((((_e276 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e182.origin.x));
                let _e367 = abs(((bitcast<f32>(_e268) + (bitcast<f32>((((_e276 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e182.origin.y));
                let _e368 = abs(((bitcast<f32>(_e272) + (bitcast<f32>((((_e276 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e182.origin.z));
                if (_e357 > _e366) {
                    phi_992_ = _e357;
                } else {
                    phi_992_ = _e366;
                }
                let _e371 = phi_992_;
                if (_e358 > _e367) {
                    phi_997_ = _e358;
                } else {
                    phi_997_ = _e367;
                }
                let _e374 = phi_997_;
                if (_e359 > _e368) {
                    phi_1002_ = _e359;
                } else {
                    phi_1002_ = _e368;
                }
                let _e377 = phi_1002_;
                if (_e371 > _e374) {
                    phi_1007_ = _e371;
                } else {
                    phi_1007_ = _e374;
                }
                let _e380 = phi_1007_;
                if (_e380 > _e377) {
                    phi_1012_ = _e380;
                } else {
                    phi_1012_ = _e377;
                }
                let _e383 = phi_1012_;
                let _e387 = (_e383 * 0.0000019073486f);
                let _e388 = (abs(_e328) * _e387);
                let _e389 = (abs(_e339) * _e387);
                let _e390 = (abs(_e350) * _e387);
                let _e394 = (_e383 * 0.0000009536743f);
                let _e395 = (abs(_e328) * _e394);
                let _e396 = (abs(_e339) * _e394);
                let _e397 = (abs(_e350) * _e394);
                let _e401 = abs(_e182.direction.x);
                let _e403 = abs(_e182.direction.y);
                let _e405 = abs(_e182.direction.z);
                if (_e401 >= _e403) {
                    if (_e401 >= _e405) {
                        phi_1043_ = false;
                    } else {
                        phi_1043_ = true;
                    }
                    let _e409 = phi_1043_;
                    phi_1044_ = _e409;
                } else {
                    phi_1044_ = true;
                }
                let _e411 = phi_1044_;
                if _e411 {
                    if (_e403 >= _e405) {
                        phi_1052_ = 1u;
                    } else {
                        phi_1052_ = 2u;
                    }
                    let _e414 = phi_1052_;
                    phi_1053_ = _e414;
                } else {
                    phi_1053_ = 0u;
                }
                let _e416 = phi_1053_;
                if (_e416 == 0u) {
                    phi_1071_ = vec3<f32>(_e182.direction.y, _e182.direction.z, _e182.direction.x);
                } else {
                    if (_e416 == 1u) {
                        phi_1070_ = vec3<f32>(_e182.direction.z, _e182.direction.x, _e182.direction.y);
                    } else {
                        phi_1070_ = _e182.direction;
                    }
                    let _e428 = phi_1070_;
                    phi_1071_ = _e428;
                }
                let _e430 = phi_1071_;
                let _e433 = (_e430.x / _e430.z);
                let _e436 = (_e430.y / _e430.z);
                if (_e328 < 0f) {
                    phi_1084_ = 0u;
                } else {
                    phi_1084_ = 1u;
                }
                let _e441 = phi_1084_;
                if (_e339 < 0f) {
                    phi_1089_ = 0u;
                } else {
                    phi_1089_ = 2u;
                }
                let _e444 = phi_1089_;
                if (_e350 < 0f) {
                    phi_1094_ = 0u;
                } else {
                    phi_1094_ = 4u;
                }
                let _e447 = phi_1094_;
                let _e449 = ((_e441 | _e444) | _e447);
                let _e450 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e450.first[0], _e450.first[1], _e450.first[2], _e450.first[3], _e450.first[4], _e450.first[5], _e450.first[6], _e450.first[7], _e450.first[8], _e450.first[9], _e450.first[10], _e450.first[11], _e450.first[12], _e450.first[13], _e450.first[14], _e450.first[15], _e450.first[16], _e450.first[17], _e450.first[18], _e450.first[19], _e450.first[20], _e450.first[21], _e450.first[22], _e450.first[23], _e450.first[24], _e450.first[25], _e450.first[26], _e450.first[27], _e450.first[28], _e450.first[29], _e450.first[30], _e450.first[31]), array<u32, 32>(_e450.mask[0], _e450.mask[1], _e450.mask[2], _e450.mask[3], _e450.mask[4], _e450.mask[5], _e450.mask[6], _e450.mask[7], _e450.mask[8], _e450.mask[9], _e450.mask[10], _e450.mask[11], _e450.mask[12], _e450.mask[13], _e450.mask[14], _e450.mask[15], _e450.mask[16], _e450.mask[17], _e450.mask[18], _e450.mask[19], _e450.mask[20], _e450.mask[21], _e450.mask[22], _e450.mask[23], _e450.mask[24], _e450.mask[25], _e450.mask[26], _e450.mask[27], _e450.mask[28], _e450.mask[29], _e450.mask[30], _e450.mask[31]), _e450.len, _e450.group, _e450.group_mask);
                let _e524 = local_2.group_mask;
                if ((_e524 & 4278190080u) == 0u) {
                    let _e528 = local_2.len;
                    if (_e528 == 0u) {
                        phi_1208_ = false;
                    } else {
                        let _e532 = local_2.len;
                        local_2.len = (_e532 - 1u);
                        let _e535 = local_2.len;
                        if (_e535 < 32u) {
                        } else {
                            return;
                        }
                        let _e540 = local_2.first[(0u + _e535)];
                        local_2.group = _e540;
                        let _e543 = local_2.len;
                        if (_e543 < 32u) {
                        } else {
                            return;
                        }
                        let _e548 = local_2.mask[(0u + _e543)];
                        local_2.group_mask = _e548;
                        phi_1208_ = true;
                    }
                    let _e551 = phi_1208_;
                    phi_1209_ = _e551;
                } else {
                    phi_1209_ = true;
                }
                let _e553 = phi_1209_;
                if _e553 {
                    let _e555 = local_2.group_mask;
                    let _e561 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e555)), 32u, (_e555 == 0u)));
                    let _e565 = local_2.group_mask;
                    let _e579 = local_2.group_mask;
                    local_2.group_mask = (_e579 & ~((1u << bitcast<u32>((_e561 & 31u)))));
                    let _e582 = local_2.group;
                    phi_1240_ = (_e582 + countOneBits(((_e565 & ~((4294967295u << bitcast<u32>((((_e561 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1240_ = 4294967295u;
                }
                let _e585 = phi_1240_;
                phi_1242_ = _e184;
                phi_1245_ = _e585;
                loop {
                    let _e587 = phi_1242_;
                    let _e589 = phi_1245_;
                    local_7 = _e587;
                    let _e590 = (_e589 != 4294967295u);
                    if _e590 {
                        if (_e589 < _e80) {
                        } else {
                            return;
                        }
                        let _e598 = nodes.member[(0u + _e589)].frame[3u];
                        let _e623 = (bitcast<f32>((((_e598 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e328);
                        let _e624 = (bitcast<f32>((((_e598 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e339);
                        let _e625 = (bitcast<f32>((((_e598 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e350);
                        let _e628 = nodes.member[(0u + _e589)].frame[0u];
                        let _e632 = nodes.member[(0u + _e589)].frame[1u];
                        let _e636 = nodes.member[(0u + _e589)].frame[2u];
                        let _e644 = ((bitcast<f32>(_e628) - _e182.origin.x) * _e328);
                        let _e645 = ((bitcast<f32>(_e632) - _e182.origin.y) * _e339);
                        let _e646 = ((bitcast<f32>(_e636) - _e182.origin.z) * _e350);
                        let _e654 = nodes.member[(0u + _e589)].x;
                        if (_e328 < 0f) {
                            let _e665 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e654.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e671 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e665.unnamed.root, _e654.w), _e665.unnamed_1);
                            let _e677 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e671.unnamed, lt_bvh_traverse_Tree(_e654.x, _e671.unnamed_1.first_primitive));
                            phi_1330_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e677.unnamed, lt_bvh_traverse_Tree(_e677.unnamed_1.root, _e654.y));
                        } else {
                            let _e693 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e654.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e699 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e693.unnamed.root, _e654.y), _e693.unnamed_1);
                            let _e705 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e699.unnamed, lt_bvh_traverse_Tree(_e654.z, _e699.unnamed_1.first_primitive));
                            phi_1330_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e705.unnamed, lt_bvh_traverse_Tree(_e705.unnamed_1.root, _e654.w));
                        }
                        let _e713 = phi_1330_;
                        let _e723 = nodes.member[(0u + _e589)].y;
                        if (_e339 < 0f) {
                            let _e734 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e723.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e740 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e734.unnamed.root, _e723.w), _e734.unnamed_1);
                            let _e746 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e740.unnamed, lt_bvh_traverse_Tree(_e723.x, _e740.unnamed_1.first_primitive));
                            phi_1357_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e746.unnamed, lt_bvh_traverse_Tree(_e746.unnamed_1.root, _e723.y));
                        } else {
                            let _e762 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e723.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e768 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e762.unnamed.root, _e723.y), _e762.unnamed_1);
                            let _e774 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e768.unnamed, lt_bvh_traverse_Tree(_e723.z, _e768.unnamed_1.first_primitive));
                            phi_1357_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e774.unnamed, lt_bvh_traverse_Tree(_e774.unnamed_1.root, _e723.w));
                        }
                        let _e782 = phi_1357_;
                        let _e792 = nodes.member[(0u + _e589)].z;
                        if (_e350 < 0f) {
                            let _e803 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e792.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e809 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e803.unnamed.root, _e792.w), _e803.unnamed_1);
                            let _e815 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e809.unnamed, lt_bvh_traverse_Tree(_e792.x, _e809.unnamed_1.first_primitive));
                            phi_1384_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e815.unnamed, lt_bvh_traverse_Tree(_e815.unnamed_1.root, _e792.y));
                        } else {
                            let _e831 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e792.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e837 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e831.unnamed.root, _e792.y), _e831.unnamed_1);
                            let _e843 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e837.unnamed, lt_bvh_traverse_Tree(_e792.z, _e837.unnamed_1.first_primitive));
                            phi_1384_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e843.unnamed, lt_bvh_traverse_Tree(_e843.unnamed_1.root, _e792.w));
                        }
                        let _e851 = phi_1384_;
                        phi_1390_ = 0u;
                        phi_1393_ = 0u;
                        loop {
                            let _e861 = phi_1390_;
                            let _e863 = phi_1393_;
                            local_3 = _e863;
                            local_4 = _e863;
                            local_5 = _e863;
                            let _e864 = (_e861 < 8u);
                            if _e864 {
                                let _e866 = (_e861 >> bitcast<u32>(2i));
                                let _e867 = (_e861 & 3u);
                                if (_e866 == 0u) {
                                    phi_1407_ = _e713.unnamed.root;
                                } else {
                                    phi_1407_ = _e713.unnamed.first_primitive;
                                }
                                let _e870 = phi_1407_;
                                if (_e866 == 0u) {
                                    phi_1417_ = _e782.unnamed.root;
                                } else {
                                    phi_1417_ = _e782.unnamed.first_primitive;
                                }
                                let _e879 = phi_1417_;
                                if (_e866 == 0u) {
                                    phi_1427_ = _e851.unnamed.root;
                                } else {
                                    phi_1427_ = _e851.unnamed.first_primitive;
                                }
                                let _e888 = phi_1427_;
                                let _e901 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e870 >> bitcast<u32>(((_e867 * 8u) & 31u))) & 255u)) * _e623) + (_e644 - _e388)), ((f32(((_e879 >> bitcast<u32>(((_e867 * 8u) & 31u))) & 255u)) * _e624) + (_e645 - _e389)));
                                let _e902 = core_intrinsics_maximum_number_nsz_f32_(_e901, ((f32(((_e888 >> bitcast<u32>(((_e867 * 8u) & 31u))) & 255u)) * _e625) + (_e646 - _e390)));
                                if (_e866 == 0u) {
                                    phi_1445_ = _e713.unnamed_1.root;
                                } else {
                                    phi_1445_ = _e713.unnamed_1.first_primitive;
                                }
                                let _e905 = phi_1445_;
                                if (_e866 == 0u) {
                                    phi_1455_ = _e782.unnamed_1.root;
                                } else {
                                    phi_1455_ = _e782.unnamed_1.first_primitive;
                                }
                                let _e914 = phi_1455_;
                                if (_e866 == 0u) {
                                    phi_1465_ = _e851.unnamed_1.root;
                                } else {
                                    phi_1465_ = _e851.unnamed_1.first_primitive;
                                }
                                let _e923 = phi_1465_;
                                let _e936 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e905 >> bitcast<u32>(((_e867 * 8u) & 31u))) & 255u)) * _e623) + (_e644 + _e388)), ((f32(((_e914 >> bitcast<u32>(((_e867 * 8u) & 31u))) & 255u)) * _e624) + (_e645 + _e389)));
                                let _e937 = core_intrinsics_minimum_number_nsz_f32_(_e936, ((f32(((_e923 >> bitcast<u32>(((_e867 * 8u) & 31u))) & 255u)) * _e625) + (_e646 + _e390)));
                                if (_e902 <= _e937) {
                                    if (_e902 <= _e587.t) {
                                        if (_e937 >= _e182.tmin) {
                                            if (_e866 == 0u) {
                                                let _e944 = nodes.member[(0u + _e589)].links[2u];
                                                phi_1501_ = _e944;
                                            } else {
                                                let _e947 = nodes.member[(0u + _e589)].links[3u];
                                                phi_1501_ = _e947;
                                            }
                                            let _e949 = phi_1501_;
                                            let _e954 = ((_e949 >> bitcast<u32>(((_e867 * 8u) & 31u))) & 255u);
                                            let _e955 = (_e954 & 31u);
                                            if (_e955 >= 24u) {
                                                phi_1514_ = (24u + ((_e955 - 24u) ^ _e449));
                                            } else {
                                                phi_1514_ = _e955;
                                            }
                                            let _e961 = phi_1514_;
                                            phi_1519_ = (_e863 | ((_e954 >> bitcast<u32>(5i)) << bitcast<u32>((_e961 & 31u))));
                                        } else {
                                            phi_1519_ = _e863;
                                        }
                                        let _e969 = phi_1519_;
                                        phi_1520_ = _e969;
                                    } else {
                                        phi_1520_ = _e863;
                                    }
                                    let _e971 = phi_1520_;
                                    phi_1521_ = _e971;
                                } else {
                                    phi_1521_ = _e863;
                                }
                                let _e973 = phi_1521_;
                                phi_1391_ = (_e861 + 1u);
                                phi_1394_ = _e973;
                            } else {
                                phi_1391_ = u32();
                                phi_1394_ = u32();
                            }
                            let _e976 = phi_1391_;
                            let _e978 = phi_1394_;
                            continue;
                            continuing {
                                phi_1390_ = _e976;
                                phi_1393_ = _e978;
                                break if !(_e864);
                            }
                        }
                        let _e982 = nodes.member[(0u + _e589)].links[0u];
                        let _e986 = nodes.member[(0u + _e589)].frame[3u];
                        let _e990 = local_3;
                        if ((_e990 & 4278190080u) == 0u) {
                        } else {
                            let _e994 = local_2.group_mask;
                            if ((_e994 & 4278190080u) == 0u) {
                            } else {
                                let _e998 = local_2.len;
                                if (_e998 < 32u) {
                                    let _e1001 = local_2.group;
                                    let _e1003 = local_2.len;
                                    if (_e1003 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.first[(0u + _e1003)] = _e1001;
                                    let _e1009 = local_2.group_mask;
                                    let _e1011 = local_2.len;
                                    if (_e1011 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.mask[(0u + _e1011)] = _e1009;
                                    let _e1018 = local_2.len;
                                    local_2.len = (_e1018 + 1u);
                                }
                            }
                            local_2.group = (0u + _e982);
                            let _e1022 = local_4;
                            local_2.group_mask = ((_e1022 & 4278190080u) | (_e986 >> bitcast<u32>(24i)));
                        }
                        let _e1027 = local_5;
                        phi_1579_ = _e587;
                        phi_1582_ = (_e1027 & 16777215u);
                        loop {
                            let _e1030 = phi_1579_;
                            let _e1032 = phi_1582_;
                            local_6 = _e1030;
                            if (_e1032 == 0u) {
                                phi_1580_ = lt_bvh_Hit();
                                phi_1583_ = u32();
                                phi_2438_ = false;
                            } else {
                                let _e1036 = nodes.member[(0u + _e589)].links[1u];
                                let _e1041 = ((0u + _e1036) + select(firstTrailingBit(_e1032), 32u, (_e1032 == 0u)));
                                if (_e1041 < _e83) {
                                } else {
                                    return;
                                }
                                let _e1048 = triangles.member[(0u + _e1041)].v0_;
                                let _e1051 = (_e1048.x - _e182.origin.x);
                                let _e1054 = (_e1048.y - _e182.origin.y);
                                let _e1057 = (_e1048.z - _e182.origin.z);
                                if (_e416 == 0u) {
                                    phi_1629_ = vec3<f32>(_e1054, _e1057, _e1051);
                                } else {
                                    if (_e416 == 1u) {
                                        phi_1628_ = vec3<f32>(_e1057, _e1051, _e1054);
                                    } else {
                                        phi_1628_ = (_e1048 - _e182.origin);
                                    }
                                    let _e1064 = phi_1628_;
                                    phi_1629_ = _e1064;
                                }
                                let _e1066 = phi_1629_;
                                let _e1070 = (_e1066.x - (_e433 * _e1066.z));
                                let _e1074 = (_e1066.y - (_e436 * _e1066.z));
                                let _e1076 = triangles.member[(0u + _e1041)].v1_;
                                let _e1079 = (_e1076.x - _e182.origin.x);
                                let _e1082 = (_e1076.y - _e182.origin.y);
                                let _e1085 = (_e1076.z - _e182.origin.z);
                                if (_e416 == 0u) {
                                    phi_1661_ = vec3<f32>(_e1082, _e1085, _e1079);
                                } else {
                                    if (_e416 == 1u) {
                                        phi_1660_ = vec3<f32>(_e1085, _e1079, _e1082);
                                    } else {
                                        phi_1660_ = (_e1076 - _e182.origin);
                                    }
                                    let _e1092 = phi_1660_;
                                    phi_1661_ = _e1092;
                                }
                                let _e1094 = phi_1661_;
                                let _e1098 = (_e1094.x - (_e433 * _e1094.z));
                                let _e1102 = (_e1094.y - (_e436 * _e1094.z));
                                let _e1104 = triangles.member[(0u + _e1041)].v2_;
                                let _e1107 = (_e1104.x - _e182.origin.x);
                                let _e1110 = (_e1104.y - _e182.origin.y);
                                let _e1113 = (_e1104.z - _e182.origin.z);
                                if (_e416 == 0u) {
                                    phi_1693_ = vec3<f32>(_e1110, _e1113, _e1107);
                                } else {
                                    if (_e416 == 1u) {
                                        phi_1692_ = vec3<f32>(_e1113, _e1107, _e1110);
                                    } else {
                                        phi_1692_ = (_e1104 - _e182.origin);
                                    }
                                    let _e1120 = phi_1692_;
                                    phi_1693_ = _e1120;
                                }
                                let _e1122 = phi_1693_;
                                let _e1126 = (_e1122.x - (_e433 * _e1122.z));
                                let _e1130 = (_e1122.y - (_e436 * _e1122.z));
                                if (_e1098 < _e1126) {
                                    phi_1712_ = true;
                                } else {
                                    if (_e1098 == _e1126) {
                                        phi_1711_ = (_e1102 < _e1130);
                                    } else {
                                        phi_1711_ = false;
                                    }
                                    let _e1135 = phi_1711_;
                                    phi_1712_ = _e1135;
                                }
                                let _e1137 = phi_1712_;
                                if _e1137 {
                                    phi_1716_ = _e1130;
                                    phi_1717_ = _e1126;
                                    phi_1718_ = _e1102;
                                    phi_1719_ = _e1098;
                                } else {
                                    phi_1716_ = _e1102;
                                    phi_1717_ = _e1098;
                                    phi_1718_ = _e1130;
                                    phi_1719_ = _e1126;
                                }
                                let _e1139 = phi_1716_;
                                let _e1141 = phi_1717_;
                                let _e1143 = phi_1718_;
                                let _e1145 = phi_1719_;
                                let _e1148 = ((_e1145 * _e1139) - (_e1143 * _e1141));
                                if _e1137 {
                                    phi_1727_ = -(_e1148);
                                } else {
                                    phi_1727_ = _e1148;
                                }
                                let _e1151 = phi_1727_;
                                if (_e1126 < _e1070) {
                                    phi_1738_ = true;
                                } else {
                                    if (_e1126 == _e1070) {
                                        phi_1737_ = (_e1130 < _e1074);
                                    } else {
                                        phi_1737_ = false;
                                    }
                                    let _e1156 = phi_1737_;
                                    phi_1738_ = _e1156;
                                }
                                let _e1158 = phi_1738_;
                                if _e1158 {
                                    phi_1742_ = _e1074;
                                    phi_1743_ = _e1070;
                                    phi_1744_ = _e1130;
                                    phi_1745_ = _e1126;
                                } else {
                                    phi_1742_ = _e1130;
                                    phi_1743_ = _e1126;
                                    phi_1744_ = _e1074;
                                    phi_1745_ = _e1070;
                                }
                                let _e1160 = phi_1742_;
                                let _e1162 = phi_1743_;
                                let _e1164 = phi_1744_;
                                let _e1166 = phi_1745_;
                                let _e1169 = ((_e1166 * _e1160) - (_e1164 * _e1162));
                                if _e1158 {
                                    phi_1753_ = -(_e1169);
                                } else {
                                    phi_1753_ = _e1169;
                                }
                                let _e1172 = phi_1753_;
                                if (_e1070 < _e1098) {
                                    phi_1764_ = true;
                                } else {
                                    if (_e1070 == _e1098) {
                                        phi_1763_ = (_e1074 < _e1102);
                                    } else {
                                        phi_1763_ = false;
                                    }
                                    let _e1177 = phi_1763_;
                                    phi_1764_ = _e1177;
                                }
                                let _e1179 = phi_1764_;
                                if _e1179 {
                                    phi_1768_ = _e1102;
                                    phi_1769_ = _e1098;
                                    phi_1770_ = _e1074;
                                    phi_1771_ = _e1070;
                                } else {
                                    phi_1768_ = _e1074;
                                    phi_1769_ = _e1070;
                                    phi_1770_ = _e1102;
                                    phi_1771_ = _e1098;
                                }
                                let _e1181 = phi_1768_;
                                let _e1183 = phi_1769_;
                                let _e1185 = phi_1770_;
                                let _e1187 = phi_1771_;
                                let _e1190 = ((_e1187 * _e1181) - (_e1185 * _e1183));
                                if _e1179 {
                                    phi_1779_ = -(_e1190);
                                } else {
                                    phi_1779_ = _e1190;
                                }
                                let _e1193 = phi_1779_;
                                if (_e1151 >= 0f) {
                                    if (_e1172 >= 0f) {
                                        if (_e1193 >= 0f) {
                                            phi_1794_ = ((_e1151 + _e1172) + _e1193);
                                            phi_1795_ = false;
                                        } else {
                                            phi_1794_ = f32();
                                            phi_1795_ = true;
                                        }
                                        let _e1200 = phi_1794_;
                                        let _e1202 = phi_1795_;
                                        phi_1796_ = _e1200;
                                        phi_1797_ = _e1202;
                                    } else {
                                        phi_1796_ = f32();
                                        phi_1797_ = true;
                                    }
                                    let _e1204 = phi_1796_;
                                    let _e1206 = phi_1797_;
                                    phi_1798_ = _e1204;
                                    phi_1799_ = _e1206;
                                } else {
                                    phi_1798_ = f32();
                                    phi_1799_ = true;
                                }
                                let _e1208 = phi_1798_;
                                let _e1210 = phi_1799_;
                                if _e1210 {
                                    if (_e1151 <= 0f) {
                                        if (_e1172 <= 0f) {
                                            let _e1213 = (_e1193 <= 0f);
                                            if _e1213 {
                                            }
                                            phi_1817_ = ((_e1151 + _e1172) + _e1193);
                                            phi_1818_ = false;
                                            phi_1819_ = _e1213;
                                        } else {
                                            phi_1817_ = f32();
                                            phi_1818_ = true;
                                            phi_1819_ = false;
                                        }
                                        let _e1217 = phi_1817_;
                                        let _e1219 = phi_1818_;
                                        let _e1221 = phi_1819_;
                                        phi_1820_ = _e1217;
                                        phi_1821_ = _e1219;
                                        phi_1822_ = _e1221;
                                    } else {
                                        phi_1820_ = f32();
                                        phi_1821_ = true;
                                        phi_1822_ = false;
                                    }
                                    let _e1223 = phi_1820_;
                                    let _e1225 = phi_1821_;
                                    let _e1227 = phi_1822_;
                                    if _e1225 {
                                        phi_1826_ = false;
                                    } else {
                                        phi_1826_ = _e1227;
                                    }
                                    let _e1229 = phi_1826_;
                                    phi_1827_ = _e1223;
                                    phi_1828_ = _e1229;
                                } else {
                                    phi_1827_ = _e1208;
                                    phi_1828_ = true;
                                }
                                let _e1231 = phi_1827_;
                                let _e1233 = phi_1828_;
                                if _e1233 {
                                    let _e1234 = (_e1231 == 0f);
                                    if _e1234 {
                                        phi_2154_ = lt_bvh_triangle_Intersection();
                                        phi_2155_ = false;
                                    } else {
                                        let _e1236 = triangles.member[(0u + _e1041)].v0_;
                                        let _e1239 = (_e1236.x - _e182.origin.x);
                                        let _e1242 = (_e1236.y - _e182.origin.y);
                                        let _e1245 = (_e1236.z - _e182.origin.z);
                                        if (_e416 == 0u) {
                                            phi_1859_ = vec3<f32>(_e1242, _e1245, _e1239);
                                        } else {
                                            if (_e416 == 1u) {
                                                phi_1858_ = vec3<f32>(_e1245, _e1239, _e1242);
                                            } else {
                                                phi_1858_ = (_e1236 - _e182.origin);
                                            }
                                            let _e1252 = phi_1858_;
                                            phi_1859_ = _e1252;
                                        }
                                        let _e1254 = phi_1859_;
                                        let _e1256 = triangles.member[(0u + _e1041)].v1_;
                                        let _e1258 = triangles.member[(0u + _e1041)].v0_;
                                        let _e1261 = (_e1256.x - _e1258.x);
                                        let _e1264 = (_e1256.y - _e1258.y);
                                        let _e1267 = (_e1256.z - _e1258.z);
                                        if (_e416 == 0u) {
                                            phi_1885_ = vec3<f32>(_e1264, _e1267, _e1261);
                                        } else {
                                            if (_e416 == 1u) {
                                                phi_1884_ = vec3<f32>(_e1267, _e1261, _e1264);
                                            } else {
                                                phi_1884_ = (_e1256 - _e1258);
                                            }
                                            let _e1274 = phi_1884_;
                                            phi_1885_ = _e1274;
                                        }
                                        let _e1276 = phi_1885_;
                                        let _e1278 = triangles.member[(0u + _e1041)].v2_;
                                        let _e1280 = triangles.member[(0u + _e1041)].v0_;
                                        let _e1283 = (_e1278.x - _e1280.x);
                                        let _e1286 = (_e1278.y - _e1280.y);
                                        let _e1289 = (_e1278.z - _e1280.z);
                                        if (_e416 == 0u) {
                                            phi_1911_ = vec3<f32>(_e1286, _e1289, _e1283);
                                        } else {
                                            if (_e416 == 1u) {
                                                phi_1910_ = vec3<f32>(_e1289, _e1283, _e1286);
                                            } else {
                                                phi_1910_ = (_e1278 - _e1280);
                                            }
                                            let _e1296 = phi_1910_;
                                            phi_1911_ = _e1296;
                                        }
                                        let _e1298 = phi_1911_;
                                        let _e1305 = ((_e1276.y * _e1298.z) - (_e1276.z * _e1298.y));
                                        let _e1312 = ((_e1276.z * _e1298.x) - (_e1276.x * _e1298.z));
                                        let _e1319 = ((_e1276.x * _e1298.y) - (_e1276.y * _e1298.x));
                                        let _e1333 = (((1f / _e430.z) * (((_e1305 * _e1254.x) + (_e1312 * _e1254.y)) + (_e1319 * _e1254.z))) / (((_e1305 * _e433) + (_e1312 * _e436)) + _e1319));
                                        if (_e1333 > _e182.tmin) {
                                            if (_e1333 < _e182.tmax) {
                                                let _e1339 = triangles.member[(0u + _e1041)].v0_;
                                                let _e1341 = triangles.member[(0u + _e1041)].v1_;
                                                if (_e1339.x < _e1341.x) {
                                                    phi_1969_ = _e1339.x;
                                                } else {
                                                    phi_1969_ = _e1341.x;
                                                }
                                                let _e1348 = phi_1969_;
                                                if (_e1339.y < _e1341.y) {
                                                    phi_1978_ = _e1339.y;
                                                } else {
                                                    phi_1978_ = _e1341.y;
                                                }
                                                let _e1355 = phi_1978_;
                                                if (_e1339.z < _e1341.z) {
                                                    phi_1987_ = _e1339.z;
                                                } else {
                                                    phi_1987_ = _e1341.z;
                                                }
                                                let _e1362 = phi_1987_;
                                                let _e1364 = triangles.member[(0u + _e1041)].v2_;
                                                if (_e1348 < _e1364.x) {
                                                    phi_1996_ = _e1348;
                                                } else {
                                                    phi_1996_ = _e1364.x;
                                                }
                                                let _e1369 = phi_1996_;
                                                if (_e1355 < _e1364.y) {
                                                    phi_2003_ = _e1355;
                                                } else {
                                                    phi_2003_ = _e1364.y;
                                                }
                                                let _e1374 = phi_2003_;
                                                if (_e1362 < _e1364.z) {
                                                    phi_2010_ = _e1362;
                                                } else {
                                                    phi_2010_ = _e1364.z;
                                                }
                                                let _e1379 = phi_2010_;
                                                let _e1381 = triangles.member[(0u + _e1041)].v0_;
                                                let _e1383 = triangles.member[(0u + _e1041)].v1_;
                                                if (_e1381.x > _e1383.x) {
                                                    phi_2023_ = _e1381.x;
                                                } else {
                                                    phi_2023_ = _e1383.x;
                                                }
                                                let _e1390 = phi_2023_;
                                                if (_e1381.y > _e1383.y) {
                                                    phi_2032_ = _e1381.y;
                                                } else {
                                                    phi_2032_ = _e1383.y;
                                                }
                                                let _e1397 = phi_2032_;
                                                if (_e1381.z > _e1383.z) {
                                                    phi_2041_ = _e1381.z;
                                                } else {
                                                    phi_2041_ = _e1383.z;
                                                }
                                                let _e1404 = phi_2041_;
                                                let _e1406 = triangles.member[(0u + _e1041)].v2_;
                                                if (_e1390 > _e1406.x) {
                                                    phi_2050_ = _e1390;
                                                } else {
                                                    phi_2050_ = _e1406.x;
                                                }
                                                let _e1411 = phi_2050_;
                                                if (_e1397 > _e1406.y) {
                                                    phi_2057_ = _e1397;
                                                } else {
                                                    phi_2057_ = _e1406.y;
                                                }
                                                let _e1416 = phi_2057_;
                                                if (_e1404 > _e1406.z) {
                                                    phi_2064_ = _e1404;
                                                } else {
                                                    phi_2064_ = _e1406.z;
                                                }
                                                let _e1421 = phi_2064_;
                                                let _e1428 = ((_e1369 - _e182.origin.x) * _e328);
                                                let _e1429 = ((_e1374 - _e182.origin.y) * _e339);
                                                let _e1430 = ((_e1379 - _e182.origin.z) * _e350);
                                                let _e1437 = ((_e1411 - _e182.origin.x) * _e328);
                                                let _e1438 = ((_e1416 - _e182.origin.y) * _e339);
                                                let _e1439 = ((_e1421 - _e182.origin.z) * _e350);
                                                if (_e1428 < _e1437) {
                                                    phi_2087_ = _e1428;
                                                } else {
                                                    phi_2087_ = _e1437;
                                                }
                                                let _e1442 = phi_2087_;
                                                if (_e1429 < _e1438) {
                                                    phi_2092_ = _e1429;
                                                } else {
                                                    phi_2092_ = _e1438;
                                                }
                                                let _e1445 = phi_2092_;
                                                if (_e1430 < _e1439) {
                                                    phi_2097_ = _e1430;
                                                } else {
                                                    phi_2097_ = _e1439;
                                                }
                                                let _e1448 = phi_2097_;
                                                if (_e1428 > _e1437) {
                                                    phi_2105_ = _e1428;
                                                } else {
                                                    phi_2105_ = _e1437;
                                                }
                                                let _e1454 = phi_2105_;
                                                if (_e1429 > _e1438) {
                                                    phi_2110_ = _e1429;
                                                } else {
                                                    phi_2110_ = _e1438;
                                                }
                                                let _e1457 = phi_2110_;
                                                if (_e1430 > _e1439) {
                                                    phi_2115_ = _e1430;
                                                } else {
                                                    phi_2115_ = _e1439;
                                                }
                                                let _e1460 = phi_2115_;
                                                let _e1464 = core_intrinsics_maximum_number_nsz_f32_((_e1442 - _e395), (_e1445 - _e396));
                                                let _e1465 = core_intrinsics_maximum_number_nsz_f32_(_e1464, (_e1448 - _e397));
                                                let _e1466 = core_intrinsics_minimum_number_nsz_f32_((_e1454 + _e395), (_e1457 + _e396));
                                                let _e1467 = core_intrinsics_minimum_number_nsz_f32_(_e1466, (_e1460 + _e397));
                                                if (_e1465 > -300000000000000000000000000000000000000f) {
                                                    phi_2127_ = _e1465;
                                                } else {
                                                    phi_2127_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1470 = phi_2127_;
                                                if (_e1467 < 300000000000000000000000000000000000000f) {
                                                    phi_2132_ = _e1467;
                                                } else {
                                                    phi_2132_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1473 = phi_2132_;
                                                if (_e1333 < _e1470) {
                                                    phi_2137_ = _e1470;
                                                } else {
                                                    phi_2137_ = _e1333;
                                                }
                                                let _e1476 = phi_2137_;
                                                if (_e1476 > _e1473) {
                                                    phi_2142_ = _e1473;
                                                } else {
                                                    phi_2142_ = _e1476;
                                                }
                                                let _e1479 = phi_2142_;
                                                phi_2147_ = lt_bvh_triangle_Intersection(_e1479, (_e1172 / _e1231), (_e1193 / _e1231), (_e1470 <= _e1473));
                                                phi_2148_ = false;
                                            } else {
                                                phi_2147_ = lt_bvh_triangle_Intersection();
                                                phi_2148_ = true;
                                            }
                                            let _e1485 = phi_2147_;
                                            let _e1487 = phi_2148_;
                                            phi_2149_ = _e1485;
                                            phi_2150_ = _e1487;
                                        } else {
                                            phi_2149_ = lt_bvh_triangle_Intersection();
                                            phi_2150_ = true;
                                        }
                                        let _e1489 = phi_2149_;
                                        let _e1491 = phi_2150_;
                                        if _e1491 {
                                        }
                                        phi_2154_ = _e1489;
                                        phi_2155_ = _e1491;
                                    }
                                    let _e1493 = phi_2154_;
                                    let _e1495 = phi_2155_;
                                    phi_2156_ = _e1493;
                                    phi_2157_ = _e1234;
                                    phi_2158_ = _e1495;
                                } else {
                                    phi_2156_ = lt_bvh_triangle_Intersection();
                                    phi_2157_ = true;
                                    phi_2158_ = false;
                                }
                                let _e1497 = phi_2156_;
                                let _e1499 = phi_2157_;
                                let _e1501 = phi_2158_;
                                if _e1499 {
                                    phi_2162_ = true;
                                } else {
                                    phi_2162_ = _e1501;
                                }
                                let _e1503 = phi_2162_;
                                if _e1503 {
                                    phi_2166_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_2166_ = _e1497;
                                }
                                let _e1505 = phi_2166_;
                                if _e1505.is_hit {
                                    if (_e1505.t > _e182.tmin) {
                                        if (_e1505.t < _e1030.t) {
                                            phi_2215_ = true;
                                        } else {
                                            if (_e1505.t == _e1030.t) {
                                                if (_e1030.triangle != 4294967295u) {
                                                    if (_e1041 < _e1030.triangle) {
                                                        phi_2206_ = true;
                                                    } else {
                                                        if (_e1041 == _e1030.triangle) {
                                                            phi_2205_ = (4294967295u < _e1030.instance);
                                                        } else {
                                                            phi_2205_ = false;
                                                        }
                                                        let _e1524 = phi_2205_;
                                                        phi_2206_ = _e1524;
                                                    }
                                                    let _e1526 = phi_2206_;
                                                    phi_2207_ = _e1526;
                                                    phi_2208_ = false;
                                                } else {
                                                    phi_2207_ = bool();
                                                    phi_2208_ = true;
                                                }
                                                let _e1528 = phi_2207_;
                                                let _e1530 = phi_2208_;
                                                phi_2209_ = _e1528;
                                                phi_2210_ = _e1530;
                                            } else {
                                                phi_2209_ = bool();
                                                phi_2210_ = true;
                                            }
                                            let _e1532 = phi_2209_;
                                            let _e1534 = phi_2210_;
                                            if _e1534 {
                                                phi_2214_ = false;
                                            } else {
                                                phi_2214_ = _e1532;
                                            }
                                            let _e1536 = phi_2214_;
                                            phi_2215_ = _e1536;
                                        }
                                        let _e1538 = phi_2215_;
                                        if _e1538 {
                                            let _e1540 = triangles.member[(0u + _e1041)].i0_;
                                            if ((_e1540 & 2147483648u) == 0u) {
                                                phi_2426_ = true;
                                            } else {
                                                if (_e1041 < _e83) {
                                                } else {
                                                    return;
                                                }
                                                let _e1549 = triangles.member[(0u + _e1041)].i0_;
                                                let _e1550 = (_e1549 & 2147483647u);
                                                let _e1552 = triangles.member[(0u + _e1041)].i1_;
                                                let _e1554 = triangles.member[(0u + _e1041)].i2_;
                                                if (_e1550 < _e86) {
                                                } else {
                                                    return;
                                                }
                                                let _e1558 = vertices.member[(0u + _e1550)];
                                                if (_e1552 < _e86) {
                                                } else {
                                                    return;
                                                }
                                                let _e1562 = vertices.member[(0u + _e1552)];
                                                if (_e1554 < _e86) {
                                                } else {
                                                    return;
                                                }
                                                let _e1566 = vertices.member[(0u + _e1554)];
                                                let _e1567 = array<abi_Vertex, 3>(_e1558, _e1562, _e1566);
                                                if (_e1567[0].material < _e89) {
                                                } else {
                                                    return;
                                                }
                                                let _e1573 = materials.member[(0u + _e1567[0].material)];
                                                if ((_e1573.flags & 0u) == 0u) {
                                                    let _e1578 = ((1f - _e1505.u) - _e1505.v);
                                                    if (_e1573.cutoff <= 0f) {
                                                        phi_2421_ = true;
                                                    } else {
                                                        let _e1605 = (_e1573.base_color.w * ((((f32((_e1567[0].color >> bitcast<u32>(24i))) * _e1578) + (f32((_e1567[1].color >> bitcast<u32>(24i))) * _e1505.u)) + (f32((_e1567[2].color >> bitcast<u32>(24i))) * _e1505.v)) * (1f / 255f)));
                                                        if (_e1573.alpha_size == 0u) {
                                                            phi_2418_ = _e1605;
                                                        } else {
                                                            local_1.offset = _e1573.alpha_offset;
                                                            local_1.size = _e1573.alpha_size;
                                                            local_1.flags = _e1573.flags;
                                                            let _e1636 = _lt_shaders_texture_TextureView_quad((&local_1), (((_e1567[0].u * _e1578) + (_e1567[1].u * _e1505.u)) + (_e1567[2].u * _e1505.v)), (((_e1567[0].v * _e1578) + (_e1567[1].v * _e1505.u)) + (_e1567[2].v * _e1505.v)));
                                                            let _e1640 = (_e1636.indices[0] >> bitcast<u32>(2i));
                                                            if (_e1640 < _e95) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1644 = alpha_texels.member[(0u + _e1640)];
                                                            let _e1660 = (_e1636.indices[1] >> bitcast<u32>(2i));
                                                            if (_e1660 < _e95) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1664 = alpha_texels.member[(0u + _e1660)];
                                                            let _e1681 = (_e1636.indices[2] >> bitcast<u32>(2i));
                                                            if (_e1681 < _e95) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1685 = alpha_texels.member[(0u + _e1681)];
                                                            let _e1702 = (_e1636.indices[3] >> bitcast<u32>(2i));
                                                            if (_e1702 < _e95) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1706 = alpha_texels.member[(0u + _e1702)];
                                                            phi_2418_ = (_e1605 * (((((f32(((_e1644 >> bitcast<u32>((((_e1636.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1636.weights.x) + ((f32(((_e1664 >> bitcast<u32>((((_e1636.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1636.weights.y)) + ((f32(((_e1685 >> bitcast<u32>((((_e1636.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1636.weights.z)) + ((f32(((_e1706 >> bitcast<u32>((((_e1636.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1636.weights.w)));
                                                        }
                                                        let _e1722 = phi_2418_;
                                                        phi_2421_ = (_e1722 >= _e1573.cutoff);
                                                    }
                                                    let _e1726 = phi_2421_;
                                                    phi_2422_ = _e1726;
                                                } else {
                                                    phi_2422_ = false;
                                                }
                                                let _e1728 = phi_2422_;
                                                if _e1728 {
                                                }
                                                phi_2426_ = _e1728;
                                            }
                                            let _e1730 = phi_2426_;
                                            if _e1730 {
                                                phi_2434_ = lt_bvh_Hit(_e1505.t, _e1505.u, _e1505.v, _e1041, 4294967295u);
                                            } else {
                                                phi_2434_ = _e1030;
                                            }
                                            let _e1736 = phi_2434_;
                                            phi_2435_ = _e1736;
                                        } else {
                                            phi_2435_ = _e1030;
                                        }
                                        let _e1738 = phi_2435_;
                                        phi_2436_ = _e1738;
                                    } else {
                                        phi_2436_ = _e1030;
                                    }
                                    let _e1740 = phi_2436_;
                                    phi_2437_ = _e1740;
                                } else {
                                    phi_2437_ = _e1030;
                                }
                                let _e1742 = phi_2437_;
                                phi_1580_ = _e1742;
                                phi_1583_ = (_e1032 & (_e1032 - 1u));
                                phi_2438_ = true;
                            }
                            let _e1744 = phi_1580_;
                            let _e1746 = phi_1583_;
                            let _e1748 = phi_2438_;
                            continue;
                            continuing {
                                phi_1579_ = _e1744;
                                phi_1582_ = _e1746;
                                break if !(_e1748);
                            }
                        }
                        let _e1751 = local_2.group_mask;
                        if ((_e1751 & 4278190080u) == 0u) {
                            let _e1755 = local_2.len;
                            if (_e1755 == 0u) {
                                phi_2477_ = false;
                            } else {
                                let _e1759 = local_2.len;
                                local_2.len = (_e1759 - 1u);
                                let _e1762 = local_2.len;
                                if (_e1762 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1767 = local_2.first[(0u + _e1762)];
                                local_2.group = _e1767;
                                let _e1770 = local_2.len;
                                if (_e1770 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1775 = local_2.mask[(0u + _e1770)];
                                local_2.group_mask = _e1775;
                                phi_2477_ = true;
                            }
                            let _e1778 = phi_2477_;
                            phi_2478_ = _e1778;
                        } else {
                            phi_2478_ = true;
                        }
                        let _e1780 = phi_2478_;
                        if _e1780 {
                            let _e1782 = local_2.group_mask;
                            let _e1788 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1782)), 32u, (_e1782 == 0u)));
                            let _e1792 = local_2.group_mask;
                            let _e1806 = local_2.group_mask;
                            local_2.group_mask = (_e1806 & ~((1u << bitcast<u32>((_e1788 & 31u)))));
                            let _e1809 = local_2.group;
                            phi_2509_ = (_e1809 + countOneBits(((_e1792 & ~((4294967295u << bitcast<u32>((((_e1788 - 24u) ^ _e449) & 31u))))) & 255u)));
                        } else {
                            phi_2509_ = 4294967295u;
                        }
                        let _e1812 = phi_2509_;
                        let _e2733 = local_6;
                        phi_1243_ = _e2733;
                        phi_1246_ = _e1812;
                    } else {
                        phi_1243_ = lt_bvh_Hit();
                        phi_1246_ = u32();
                    }
                    let _e1814 = phi_1243_;
                    let _e1816 = phi_1246_;
                    continue;
                    continuing {
                        phi_1242_ = _e1814;
                        phi_1245_ = _e1816;
                        break if !(_e590);
                    }
                }
                let _e2737 = local_7;
                phi_2510_ = _e2737;
            }
            let _e1819 = phi_2510_;
            phi_2511_ = _e1819;
            phi_2512_ = _e246;
        } else {
            phi_2511_ = lt_bvh_Hit();
            phi_2512_ = true;
        }
        let _e1821 = phi_2511_;
        let _e1823 = phi_2512_;
        if _e1823 {
            phi_2516_ = _e184;
        } else {
            phi_2516_ = _e1821;
        }
        let _e1825 = phi_2516_;
        if (_e1825.triangle != 4294967295u) {
            let _e1831 = ((1f - _e1825.u) - _e1825.v);
            if (_e1825.triangle < _e83) {
            } else {
                return;
            }
            let _e1836 = triangles.member[(0u + _e1825.triangle)];
            let _e1861 = (((_e1836.v0_.x * _e1831) + (_e1836.v1_.x * _e1825.u)) + (_e1836.v2_.x * _e1825.v));
            let _e1862 = (((_e1836.v0_.y * _e1831) + (_e1836.v1_.y * _e1825.u)) + (_e1836.v2_.y * _e1825.v));
            let _e1863 = (((_e1836.v0_.z * _e1831) + (_e1836.v1_.z * _e1825.u)) + (_e1836.v2_.z * _e1825.v));
            let _e1866 = abs(_e1836.v0_.x);
            let _e1868 = abs(_e1836.v0_.y);
            let _e1870 = abs(_e1836.v0_.z);
            let _e1872 = abs(_e1836.v1_.x);
            let _e1874 = abs(_e1836.v1_.y);
            let _e1876 = abs(_e1836.v1_.z);
            if (_e1866 > _e1872) {
                phi_2580_ = _e1866;
            } else {
                phi_2580_ = _e1872;
            }
            let _e1879 = phi_2580_;
            if (_e1868 > _e1874) {
                phi_2585_ = _e1868;
            } else {
                phi_2585_ = _e1874;
            }
            let _e1882 = phi_2585_;
            if (_e1870 > _e1876) {
                phi_2590_ = _e1870;
            } else {
                phi_2590_ = _e1876;
            }
            let _e1885 = phi_2590_;
            let _e1887 = abs(_e1836.v2_.x);
            let _e1889 = abs(_e1836.v2_.y);
            let _e1891 = abs(_e1836.v2_.z);
            if (_e1879 > _e1887) {
                phi_2601_ = _e1879;
            } else {
                phi_2601_ = _e1887;
            }
            let _e1894 = phi_2601_;
            if (_e1882 > _e1889) {
                phi_2606_ = _e1882;
            } else {
                phi_2606_ = _e1889;
            }
            let _e1897 = phi_2606_;
            if (_e1885 > _e1891) {
                phi_2611_ = _e1885;
            } else {
                phi_2611_ = _e1891;
            }
            let _e1900 = phi_2611_;
            let _e1903 = (_e1836.v1_.x - _e1836.v0_.x);
            let _e1906 = (_e1836.v1_.y - _e1836.v0_.y);
            let _e1909 = (_e1836.v1_.z - _e1836.v0_.z);
            let _e1912 = (_e1836.v2_.x - _e1836.v0_.x);
            let _e1915 = (_e1836.v2_.y - _e1836.v0_.y);
            let _e1918 = (_e1836.v2_.z - _e1836.v0_.z);
            let _e1922 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1906), abs(_e1909));
            let _e1923 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1903), _e1922);
            let _e1924 = (_e1903 / _e1923);
            let _e1925 = (_e1906 / _e1923);
            let _e1926 = (_e1909 / _e1923);
            let _e1930 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1915), abs(_e1918));
            let _e1931 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1912), _e1930);
            let _e1932 = (_e1912 / _e1931);
            let _e1933 = (_e1915 / _e1931);
            let _e1934 = (_e1918 / _e1931);
            let _e1937 = ((_e1925 * _e1934) - (_e1933 * _e1926));
            let _e1940 = ((_e1926 * _e1932) - (_e1934 * _e1924));
            let _e1943 = ((_e1924 * _e1933) - (_e1932 * _e1925));
            let _e1945 = p.member.eye;
            let _e1958 = (1f / sqrt((((_e1937 * _e1937) + (_e1940 * _e1940)) + (_e1943 * _e1943))));
            let _e1959 = (_e1937 * _e1958);
            let _e1960 = (_e1940 * _e1958);
            let _e1961 = (_e1943 * _e1958);
            if ((((_e1959 * (_e1945.x - _e1861)) + (_e1960 * (_e1945.y - _e1862))) + (_e1961 * (_e1945.z - _e1863))) < 0f) {
                phi_2687_ = vec3<f32>(-(_e1959), -(_e1960), -(_e1961));
            } else {
                phi_2687_ = vec3<f32>(_e1959, _e1960, _e1961);
            }
            let _e1974 = phi_2687_;
            if (_e1825.triangle < _e83) {
            } else {
                return;
            }
            let _e1979 = triangles.member[(0u + _e1825.triangle)];
            let _e1981 = (_e1979.i0_ & 2147483647u);
            if (_e1981 < _e86) {
            } else {
                return;
            }
            let _e1987 = vertices.member[(0u + _e1981)];
            if (_e1979.i1_ < _e86) {
            } else {
                return;
            }
            let _e1991 = vertices.member[(0u + _e1979.i1_)];
            if (_e1979.i2_ < _e86) {
            } else {
                return;
            }
            let _e1995 = vertices.member[(0u + _e1979.i2_)];
            let _e1996 = array<abi_Vertex, 3>(_e1987, _e1991, _e1995);
            if (_e1996[0].material < _e89) {
            } else {
                return;
            }
            let _e2002 = materials.member[(0u + _e1996[0].material)];
            let _e2019 = (1f / 255f);
            let _e2038 = (1f / 255f);
            let _e2060 = (1f / 255f);
            if (_e2002.color_size == 0u) {
                phi_2930_ = vec3<f32>(1f, 1f, 1f);
            } else {
                local.offset = _e2002.color_offset;
                local.size = _e2002.color_size;
                local.flags = _e2002.flags;
                let _e2103 = _lt_shaders_texture_TextureView_quad((&local), (((_e1996[0].u * _e1831) + (_e1996[1].u * _e1825.u)) + (_e1996[2].u * _e1825.v)), (((_e1996[0].v * _e1831) + (_e1996[1].v * _e1825.u)) + (_e1996[2].v * _e1825.v)));
                if (_e2103.indices[0] < _e98) {
                } else {
                    return;
                }
                let _e2109 = color_texels.member[(0u + _e2103.indices[0])];
                let _e2120 = (1f / 255f);
                if (_e2103.indices[1] < _e98) {
                } else {
                    return;
                }
                let _e2134 = color_texels.member[(0u + _e2103.indices[1])];
                let _e2145 = (1f / 255f);
                if (_e2103.indices[2] < _e98) {
                } else {
                    return;
                }
                let _e2162 = color_texels.member[(0u + _e2103.indices[2])];
                let _e2173 = (1f / 255f);
                if (_e2103.indices[3] < _e98) {
                } else {
                    return;
                }
                let _e2190 = color_texels.member[(0u + _e2103.indices[3])];
                let _e2201 = (1f / 255f);
                let _e2210 = (((((f32((_e2109 & 255u)) * _e2120) * _e2103.weights.x) + ((f32((_e2134 & 255u)) * _e2145) * _e2103.weights.y)) + ((f32((_e2162 & 255u)) * _e2173) * _e2103.weights.z)) + ((f32((_e2190 & 255u)) * _e2201) * _e2103.weights.w));
                let _e2211 = (((((f32(((_e2109 >> bitcast<u32>(8i)) & 255u)) * _e2120) * _e2103.weights.x) + ((f32(((_e2134 >> bitcast<u32>(8i)) & 255u)) * _e2145) * _e2103.weights.y)) + ((f32(((_e2162 >> bitcast<u32>(8i)) & 255u)) * _e2173) * _e2103.weights.z)) + ((f32(((_e2190 >> bitcast<u32>(8i)) & 255u)) * _e2201) * _e2103.weights.w));
                let _e2212 = (((((f32(((_e2109 >> bitcast<u32>(16i)) & 255u)) * _e2120) * _e2103.weights.x) + ((f32(((_e2134 >> bitcast<u32>(16i)) & 255u)) * _e2145) * _e2103.weights.y)) + ((f32(((_e2162 >> bitcast<u32>(16i)) & 255u)) * _e2173) * _e2103.weights.z)) + ((f32(((_e2190 >> bitcast<u32>(16i)) & 255u)) * _e2201) * _e2103.weights.w));
                phi_2930_ = vec3<f32>((_e2210 * _e2210), (_e2211 * _e2211), (_e2212 * _e2212));
            }
            let _e2218 = phi_2930_;
            let _e2220 = ((_e2002.base_color.x * ((((f32((_e1996[0].color & 255u)) * _e2019) * _e1831) + ((f32((_e1996[1].color & 255u)) * _e2038) * _e1825.u)) + ((f32((_e1996[2].color & 255u)) * _e2060) * _e1825.v))) * _e2218.x);
            let _e2222 = ((_e2002.base_color.y * ((((f32(((_e1996[0].color >> bitcast<u32>(8i)) & 255u)) * _e2019) * _e1831) + ((f32(((_e1996[1].color >> bitcast<u32>(8i)) & 255u)) * _e2038) * _e1825.u)) + ((f32(((_e1996[2].color >> bitcast<u32>(8i)) & 255u)) * _e2060) * _e1825.v))) * _e2218.y);
            let _e2224 = ((_e2002.base_color.z * ((((f32(((_e1996[0].color >> bitcast<u32>(16i)) & 255u)) * _e2019) * _e1831) + ((f32(((_e1996[1].color >> bitcast<u32>(16i)) & 255u)) * _e2038) * _e1825.u)) + ((f32(((_e1996[2].color >> bitcast<u32>(16i)) & 255u)) * _e2060) * _e1825.v))) * _e2218.z);
            let _e2225 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1897, _e1900);
            let _e2226 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1894, _e2225);
            if ((_e2002.flags & 2u) == 0u) {
                phi_2945_ = 0u;
            } else {
                phi_2945_ = 1u;
            }
            let _e2231 = phi_2945_;
            if (_e1996[0].normal == 2147516416u) {
                phi_3148_ = _e1974;
            } else {
                let _e2244 = (f32((bitcast<i32>((_e1996[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2250 = (f32((bitcast<i32>(_e1996[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2254 = ((1f - abs(_e2244)) - abs(_e2250));
                if (_e2254 < 0f) {
                    phi_2972_ = -(_e2254);
                } else {
                    phi_2972_ = 0f;
                }
                let _e2258 = phi_2972_;
                if (_e2244 < 0f) {
                    phi_2979_ = (_e2244 + _e2258);
                } else {
                    phi_2979_ = (_e2244 - _e2258);
                }
                let _e2263 = phi_2979_;
                if (_e2250 < 0f) {
                    phi_2986_ = (_e2250 + _e2258);
                } else {
                    phi_2986_ = (_e2250 - _e2258);
                }
                let _e2268 = phi_2986_;
                let _e2275 = (1f / sqrt((((_e2263 * _e2263) + (_e2268 * _e2268)) + (_e2254 * _e2254))));
                let _e2291 = (f32((bitcast<i32>((_e1996[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2297 = (f32((bitcast<i32>(_e1996[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2301 = ((1f - abs(_e2291)) - abs(_e2297));
                if (_e2301 < 0f) {
                    phi_3021_ = -(_e2301);
                } else {
                    phi_3021_ = 0f;
                }
                let _e2305 = phi_3021_;
                if (_e2291 < 0f) {
                    phi_3028_ = (_e2291 + _e2305);
                } else {
                    phi_3028_ = (_e2291 - _e2305);
                }
                let _e2310 = phi_3028_;
                if (_e2297 < 0f) {
                    phi_3035_ = (_e2297 + _e2305);
                } else {
                    phi_3035_ = (_e2297 - _e2305);
                }
                let _e2315 = phi_3035_;
                let _e2322 = (1f / sqrt((((_e2310 * _e2310) + (_e2315 * _e2315)) + (_e2301 * _e2301))));
                let _e2341 = (f32((bitcast<i32>((_e1996[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2347 = (f32((bitcast<i32>(_e1996[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2351 = ((1f - abs(_e2341)) - abs(_e2347));
                if (_e2351 < 0f) {
                    phi_3073_ = -(_e2351);
                } else {
                    phi_3073_ = 0f;
                }
                let _e2355 = phi_3073_;
                if (_e2341 < 0f) {
                    phi_3080_ = (_e2341 + _e2355);
                } else {
                    phi_3080_ = (_e2341 - _e2355);
                }
                let _e2360 = phi_3080_;
                if (_e2347 < 0f) {
                    phi_3087_ = (_e2347 + _e2355);
                } else {
                    phi_3087_ = (_e2347 - _e2355);
                }
                let _e2365 = phi_3087_;
                let _e2372 = (1f / sqrt((((_e2360 * _e2360) + (_e2365 * _e2365)) + (_e2351 * _e2351))));
                let _e2383 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(vec3<f32>(((((_e2263 * _e2275) * _e1831) + ((_e2310 * _e2322) * _e1825.u)) + ((_e2360 * _e2372) * _e1825.v)), ((((_e2268 * _e2275) * _e1831) + ((_e2315 * _e2322) * _e1825.u)) + ((_e2365 * _e2372) * _e1825.v)), ((((_e2254 * _e2275) * _e1831) + ((_e2301 * _e2322) * _e1825.u)) + ((_e2351 * _e2372) * _e1825.v))));
                let _e2395 = sqrt((((_e2383.x * _e2383.x) + (_e2383.y * _e2383.y)) + (_e2383.z * _e2383.z)));
                if (_e2395 > 0f) {
                    let _e2398 = (_e2383.x / _e2395);
                    let _e2400 = (_e2383.y / _e2395);
                    let _e2402 = (_e2383.z / _e2395);
                    if ((((_e2398 * _e1974.x) + (_e2400 * _e1974.y)) + (_e2402 * _e1974.z)) < 0f) {
                        phi_3146_ = vec3<f32>(-(_e2398), -(_e2400), -(_e2402));
                    } else {
                        phi_3146_ = (_e2383 / vec3(_e2395));
                    }
                    let _e2419 = phi_3146_;
                    phi_3147_ = _e2419;
                } else {
                    phi_3147_ = _e1974;
                }
                let _e2421 = phi_3147_;
                phi_3148_ = _e2421;
            }
            let _e2423 = phi_3148_;
            if (_e2220 > 0f) {
                if (_e2220 < 1f) {
                    phi_3157_ = _e2220;
                } else {
                    phi_3157_ = 1f;
                }
                let _e2427 = phi_3157_;
                phi_3158_ = _e2427;
            } else {
                phi_3158_ = 0f;
            }
            let _e2429 = phi_3158_;
            if (_e2222 > 0f) {
                if (_e2222 < 1f) {
                    phi_3168_ = _e2222;
                } else {
                    phi_3168_ = 1f;
                }
                let _e2434 = phi_3168_;
                phi_3169_ = _e2434;
            } else {
                phi_3169_ = 0f;
            }
            let _e2436 = phi_3169_;
            if (_e2224 > 0f) {
                if (_e2224 < 1f) {
                    phi_3179_ = _e2224;
                } else {
                    phi_3179_ = 1f;
                }
                let _e2441 = phi_3179_;
                phi_3180_ = _e2441;
            } else {
                phi_3180_ = 0f;
            }
            let _e2443 = phi_3180_;
            let _e2446 = ((sqrt(_e2429) * 255f) + 0.5f);
            let _e2455 = ((sqrt(_e2436) * 255f) + 0.5f);
            let _e2467 = ((sqrt(_e2443) * 255f) + 0.5f);
            phi_3215_ = abi_Sample(vec3<f32>(_e1861, _e1862, _e1863), _e2226, _e1974, _e2231, _e2423, ((select(select(u32(_e2446), 0u, (_e2446 < bitcast<f32>(0u))), 4294967295u, (_e2446 > bitcast<f32>(1333788671u))) | (select(select(u32(_e2455), 0u, (_e2455 < bitcast<f32>(0u))), 4294967295u, (_e2455 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e2467), 0u, (_e2467 < bitcast<f32>(0u))), 4294967295u, (_e2467 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_3215_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e2481 = phi_3215_;
        if (_e110.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e110.first_primitive)] = _e2481;
        if (_e1825.triangle != 4294967295u) {
            let _e2490 = ((1f - _e1825.u) - _e1825.v);
            if (_e1825.triangle < _e83) {
            } else {
                return;
            }
            let _e2495 = triangles.member[(0u + _e1825.triangle)];
            let _e2497 = (_e2495.i0_ & 2147483647u);
            if (_e2497 < _e101) {
            } else {
                return;
            }
            let _e2503 = before.member[(0u + _e2497)];
            if (_e2495.i1_ < _e101) {
            } else {
                return;
            }
            let _e2507 = before.member[(0u + _e2495.i1_)];
            if (_e2495.i2_ < _e101) {
            } else {
                return;
            }
            let _e2511 = before.member[(0u + _e2495.i2_)];
            let _e2516 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2503.x, _e2503.y, _e2503.z));
            let _e2527 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2507.x, _e2507.y, _e2507.z));
            let _e2541 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2511.x, _e2511.y, _e2511.z));
            phi_3306_ = vec3<f32>((((_e2516.x * _e2490) + (_e2527.x * _e1825.u)) + (_e2541.x * _e1825.v)), (((_e2516.y * _e2490) + (_e2527.y * _e1825.u)) + (_e2541.y * _e1825.v)), (((_e2516.z * _e2490) + (_e2527.z * _e1825.u)) + (_e2541.z * _e1825.v)));
        } else {
            phi_3306_ = vec3<f32>(0f, 0f, 0f);
        }
        let _e2553 = phi_3306_;
        if (_e110.first_primitive < arrayLength((&past.member))) {
        } else {
            return;
        }
        past.member[(0u + _e110.first_primitive)] = vec4<f32>(_e2553.x, _e2553.y, _e2553.z, 1f);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_alpha_color_motion_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
