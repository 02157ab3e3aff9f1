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

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct type_26 {
    member: array<vec4<f32>>,
}

struct texture_TextureView {
    offset: u32,
    size: u32,
    flags: u32,
}

struct lt_bvh_Triangle {
    v0_: vec3<f32>,
    i0_: u32,
    v1_: vec3<f32>,
    i1_: u32,
    v2_: vec3<f32>,
    i2_: u32,
}

struct type_32 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_36 {
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
    pad: vec2<u32>,
}

struct type_40 {
    member: array<abi_Material>,
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

struct lt_bvh_traverse_Stack {
    first: array<u32, 32>,
    mask: array<u32, 32>,
    len: u32,
    group: u32,
    group_mask: u32,
}

struct type_50 {
    member: abi_CameraParams,
}

struct lt_bvh_Node {
    frame: vec4<u32>,
    links: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    z: vec4<u32>,
}

struct type_55 {
    member: array<lt_bvh_Node>,
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

var<private> id_1: vec3<u32>;
@group(0) @binding(3) 
var<storage> vertices: type_36;
@group(0) @binding(4) 
var<storage> materials: type_40;
@group(0) @binding(0) 
var<uniform> p: type_50;
@group(0) @binding(1) 
var<storage> nodes: type_55;
@group(0) @binding(2) 
var<storage> triangles: type_32;
@group(0) @binding(5) 
var<storage, read_write> samples: type_9;
@group(0) @binding(6) 
var<storage> alpha_texels: type_13;
@group(0) @binding(7) 
var<storage> before: type_26;
@group(0) @binding(8) 
var<storage, read_write> past: type_26;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_220_: lt_bvh_traverse_Tree;
    var phi_221_: bool;
    var phi_222_: lt_bvh_traverse_Tree;
    var phi_223_: bool;
    var phi_228_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_220_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_221_ = false;
        } else {
            phi_220_ = lt_bvh_traverse_Tree();
            phi_221_ = true;
        }
        let _e84 = phi_220_;
        let _e86 = phi_221_;
        phi_222_ = _e84;
        phi_223_ = _e86;
    } else {
        phi_222_ = lt_bvh_traverse_Tree();
        phi_223_ = true;
    }
    let _e88 = phi_222_;
    let _e90 = phi_223_;
    if _e90 {
        phi_228_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_228_ = _e88;
    }
    let _e95 = phi_228_;
    return lt_bvh_traverse_Tree(_e95.root, _e95.first_primitive);
}

fn _lt_shaders_texture_TextureView_quad(param_3: ptr<function, texture_TextureView>, param_4: f32, param_5: f32) -> texture_TexelQuad {
    var phi_273_: f32;
    var phi_278_: f32;
    var phi_279_: bool;
    var phi_280_: f32;
    var phi_281_: bool;
    var phi_285_: f32;
    var phi_311_: f32;
    var phi_316_: f32;
    var phi_317_: bool;
    var phi_318_: f32;
    var phi_319_: bool;
    var phi_323_: f32;
    var phi_331_: f32;
    var phi_332_: f32;
    var phi_333_: f32;
    var phi_342_: f32;
    var phi_343_: f32;
    var phi_361_: u32;
    var phi_375_: u32;
    var phi_382_: u32;
    var phi_387_: u32;
    var phi_393_: u32;
    var phi_398_: u32;
    var phi_400_: texture_Axis;
    var phi_428_: f32;
    var phi_433_: f32;
    var phi_434_: bool;
    var phi_435_: f32;
    var phi_436_: bool;
    var phi_440_: f32;
    var phi_466_: f32;
    var phi_471_: f32;
    var phi_472_: bool;
    var phi_473_: f32;
    var phi_474_: bool;
    var phi_478_: f32;
    var phi_486_: f32;
    var phi_487_: f32;
    var phi_488_: f32;
    var phi_497_: f32;
    var phi_498_: f32;
    var phi_516_: u32;
    var phi_530_: u32;
    var phi_537_: u32;
    var phi_542_: u32;
    var phi_548_: u32;
    var phi_553_: u32;
    var phi_555_: texture_Axis;

    let _e75 = (*param_3).size;
    let _e76 = (_e75 & 65535u);
    let _e78 = (*param_3).size;
    let _e80 = (_e78 >> bitcast<u32>(16i));
    let _e82 = (*param_3).flags;
    let _e84 = ((_e82 & 4u) != 0u);
    let _e86 = (*param_3).flags;
    let _e89 = ((_e86 >> bitcast<u32>(4u)) & 3u);
    if (_e89 == 0u) {
        if (param_4 > -8388608f) {
            let _e102 = f32(select(0i, select(select(i32(param_4), i32(-2147483648), (param_4 < bitcast<f32>(3472883712u))), 2147483647i, (param_4 > bitcast<f32>(1325400063u))), (param_4 == param_4)));
            if (_e102 > param_4) {
                phi_273_ = 1f;
            } else {
                phi_273_ = 0f;
            }
            let _e105 = phi_273_;
            if (param_4 < 8388608f) {
                phi_278_ = (_e102 - _e105);
                phi_279_ = false;
            } else {
                phi_278_ = f32();
                phi_279_ = true;
            }
            let _e108 = phi_278_;
            let _e110 = phi_279_;
            phi_280_ = _e108;
            phi_281_ = _e110;
        } else {
            phi_280_ = f32();
            phi_281_ = true;
        }
        let _e112 = phi_280_;
        let _e114 = phi_281_;
        if _e114 {
            phi_285_ = param_4;
        } else {
            phi_285_ = _e112;
        }
        let _e116 = phi_285_;
        phi_333_ = (param_4 - _e116);
    } else {
        if (_e89 == 1u) {
            let _e119 = (param_4 * 0.5f);
            if (_e119 > -8388608f) {
                let _e131 = f32(select(0i, select(select(i32(_e119), i32(-2147483648), (_e119 < bitcast<f32>(3472883712u))), 2147483647i, (_e119 > bitcast<f32>(1325400063u))), (_e119 == _e119)));
                if (_e131 > _e119) {
                    phi_311_ = 1f;
                } else {
                    phi_311_ = 0f;
                }
                let _e134 = phi_311_;
                if (_e119 < 8388608f) {
                    phi_316_ = (_e131 - _e134);
                    phi_317_ = false;
                } else {
                    phi_316_ = f32();
                    phi_317_ = true;
                }
                let _e137 = phi_316_;
                let _e139 = phi_317_;
                phi_318_ = _e137;
                phi_319_ = _e139;
            } else {
                phi_318_ = f32();
                phi_319_ = true;
            }
            let _e141 = phi_318_;
            let _e143 = phi_319_;
            if _e143 {
                phi_323_ = _e119;
            } else {
                phi_323_ = _e141;
            }
            let _e145 = phi_323_;
            let _e147 = (param_4 - (2f * _e145));
            if (_e147 > 1f) {
                phi_331_ = (2f - _e147);
            } else {
                phi_331_ = _e147;
            }
            let _e151 = phi_331_;
            phi_332_ = _e151;
        } else {
            phi_332_ = param_4;
        }
        let _e153 = phi_332_;
        phi_333_ = _e153;
    }
    let _e155 = phi_333_;
    if (_e155 > 0f) {
        if (_e155 < 1f) {
            phi_342_ = _e155;
        } else {
            phi_342_ = 1f;
        }
        let _e159 = phi_342_;
        phi_343_ = _e159;
    } else {
        phi_343_ = 0f;
    }
    let _e161 = phi_343_;
    let _e162 = (_e76 - 1u);
    let _e164 = (_e161 * f32(_e76));
    if _e84 {
        let _e171 = select(select(u32(_e164), 0u, (_e164 < bitcast<f32>(0u))), 4294967295u, (_e164 > bitcast<f32>(1333788671u)));
        if (_e162 < _e171) {
            phi_361_ = _e162;
        } else {
            phi_361_ = _e171;
        }
        let _e174 = phi_361_;
        phi_400_ = texture_Axis(_e174, _e174, 0f);
    } else {
        let _e176 = (_e164 + 0.5f);
        let _e183 = select(select(u32(_e176), 0u, (_e176 < bitcast<f32>(0u))), 4294967295u, (_e176 > bitcast<f32>(1333788671u)));
        if (_e76 < _e183) {
            phi_375_ = _e76;
        } else {
            phi_375_ = _e183;
        }
        let _e186 = phi_375_;
        if (_e89 == 0u) {
            phi_382_ = _e162;
        } else {
            phi_382_ = 0u;
        }
        let _e191 = phi_382_;
        if (_e89 == 0u) {
            phi_387_ = 0u;
        } else {
            phi_387_ = _e162;
        }
        let _e194 = phi_387_;
        if (_e186 == 0u) {
            phi_393_ = _e191;
        } else {
            phi_393_ = (_e186 - 1u);
        }
        let _e198 = phi_393_;
        if (_e186 > _e162) {
            phi_398_ = _e194;
        } else {
            phi_398_ = _e186;
        }
        let _e201 = phi_398_;
        phi_400_ = texture_Axis(_e198, _e201, (_e176 - f32(_e186)));
    }
    let _e204 = phi_400_;
    let _e206 = (*param_3).flags;
    let _e209 = ((_e206 >> bitcast<u32>(6u)) & 3u);
    if (_e209 == 0u) {
        if (param_5 > -8388608f) {
            let _e222 = f32(select(0i, select(select(i32(param_5), i32(-2147483648), (param_5 < bitcast<f32>(3472883712u))), 2147483647i, (param_5 > bitcast<f32>(1325400063u))), (param_5 == param_5)));
            if (_e222 > param_5) {
                phi_428_ = 1f;
            } else {
                phi_428_ = 0f;
            }
            let _e225 = phi_428_;
            if (param_5 < 8388608f) {
                phi_433_ = (_e222 - _e225);
                phi_434_ = false;
            } else {
                phi_433_ = f32();
                phi_434_ = true;
            }
            let _e228 = phi_433_;
            let _e230 = phi_434_;
            phi_435_ = _e228;
            phi_436_ = _e230;
        } else {
            phi_435_ = f32();
            phi_436_ = true;
        }
        let _e232 = phi_435_;
        let _e234 = phi_436_;
        if _e234 {
            phi_440_ = param_5;
        } else {
            phi_440_ = _e232;
        }
        let _e236 = phi_440_;
        phi_488_ = (param_5 - _e236);
    } else {
        if (_e209 == 1u) {
            let _e239 = (param_5 * 0.5f);
            if (_e239 > -8388608f) {
                let _e251 = f32(select(0i, select(select(i32(_e239), i32(-2147483648), (_e239 < bitcast<f32>(3472883712u))), 2147483647i, (_e239 > bitcast<f32>(1325400063u))), (_e239 == _e239)));
                if (_e251 > _e239) {
                    phi_466_ = 1f;
                } else {
                    phi_466_ = 0f;
                }
                let _e254 = phi_466_;
                if (_e239 < 8388608f) {
                    phi_471_ = (_e251 - _e254);
                    phi_472_ = false;
                } else {
                    phi_471_ = f32();
                    phi_472_ = true;
                }
                let _e257 = phi_471_;
                let _e259 = phi_472_;
                phi_473_ = _e257;
                phi_474_ = _e259;
            } else {
                phi_473_ = f32();
                phi_474_ = true;
            }
            let _e261 = phi_473_;
            let _e263 = phi_474_;
            if _e263 {
                phi_478_ = _e239;
            } else {
                phi_478_ = _e261;
            }
            let _e265 = phi_478_;
            let _e267 = (param_5 - (2f * _e265));
            if (_e267 > 1f) {
                phi_486_ = (2f - _e267);
            } else {
                phi_486_ = _e267;
            }
            let _e271 = phi_486_;
            phi_487_ = _e271;
        } else {
            phi_487_ = param_5;
        }
        let _e273 = phi_487_;
        phi_488_ = _e273;
    }
    let _e275 = phi_488_;
    if (_e275 > 0f) {
        if (_e275 < 1f) {
            phi_497_ = _e275;
        } else {
            phi_497_ = 1f;
        }
        let _e279 = phi_497_;
        phi_498_ = _e279;
    } else {
        phi_498_ = 0f;
    }
    let _e281 = phi_498_;
    let _e282 = (_e80 - 1u);
    let _e284 = (_e281 * f32(_e80));
    if _e84 {
        let _e291 = select(select(u32(_e284), 0u, (_e284 < bitcast<f32>(0u))), 4294967295u, (_e284 > bitcast<f32>(1333788671u)));
        if (_e282 < _e291) {
            phi_516_ = _e282;
        } else {
            phi_516_ = _e291;
        }
        let _e294 = phi_516_;
        phi_555_ = texture_Axis(_e294, _e294, 0f);
    } else {
        let _e296 = (_e284 + 0.5f);
        let _e303 = select(select(u32(_e296), 0u, (_e296 < bitcast<f32>(0u))), 4294967295u, (_e296 > bitcast<f32>(1333788671u)));
        if (_e80 < _e303) {
            phi_530_ = _e80;
        } else {
            phi_530_ = _e303;
        }
        let _e306 = phi_530_;
        if (_e209 == 0u) {
            phi_537_ = _e282;
        } else {
            phi_537_ = 0u;
        }
        let _e311 = phi_537_;
        if (_e209 == 0u) {
            phi_542_ = 0u;
        } else {
            phi_542_ = _e282;
        }
        let _e314 = phi_542_;
        if (_e306 == 0u) {
            phi_548_ = _e311;
        } else {
            phi_548_ = (_e306 - 1u);
        }
        let _e318 = phi_548_;
        if (_e306 > _e282) {
            phi_553_ = _e314;
        } else {
            phi_553_ = _e306;
        }
        let _e321 = phi_553_;
        phi_555_ = texture_Axis(_e318, _e321, (_e296 - f32(_e306)));
    }
    let _e324 = phi_555_;
    let _e328 = (*param_3).offset;
    let _e335 = (*param_3).offset;
    let _e342 = (*param_3).offset;
    let _e349 = (*param_3).offset;
    return texture_TexelQuad(array<u32, 4>(((_e328 + (_e324.low * _e76)) + _e204.low), ((_e335 + (_e324.low * _e76)) + _e204.high), ((_e342 + (_e324.high * _e76)) + _e204.low), ((_e349 + (_e324.high * _e76)) + _e204.high)), vec4<f32>(((1f - _e204.fraction) * (1f - _e324.fraction)), (_e204.fraction * (1f - _e324.fraction)), ((1f - _e204.fraction) * _e324.fraction), (_e204.fraction * _e324.fraction)));
}

fn _lt_bvh_ray_Ray_new(param_6: vec3<f32>, param_7: vec3<f32>) -> lt_bvh_Ray {
    return lt_bvh_Ray(param_6, 0f, param_7, 300000000000000000000000000000000000000f);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_8: f32, param_9: f32) -> f32 {
    var phi_618_: bool;
    var phi_622_: f32;

    if (param_8 != param_8) {
        phi_618_ = true;
    } else {
        let _e74 = (param_9 >= param_8);
        if _e74 {
        }
        phi_618_ = _e74;
    }
    let _e76 = phi_618_;
    if _e76 {
        phi_622_ = param_9;
    } else {
        phi_622_ = param_8;
    }
    let _e78 = phi_622_;
    return _e78;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_10: f32, param_11: f32) -> f32 {
    var phi_634_: bool;
    var phi_638_: f32;

    if (param_10 != param_10) {
        phi_634_ = true;
    } else {
        let _e74 = (param_11 <= param_10);
        if _e74 {
        }
        phi_634_ = _e74;
    }
    let _e76 = phi_634_;
    if _e76 {
        phi_638_ = param_11;
    } else {
        phi_638_ = param_10;
    }
    let _e78 = phi_638_;
    return _e78;
}

fn _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(param_12: f32, param_13: f32) -> f32 {
    var phi_646_: f32;

    if (param_12 > param_13) {
        phi_646_ = param_12;
    } else {
        phi_646_ = param_13;
    }
    let _e75 = phi_646_;
    return _e75;
}

fn _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(param_14: vec3<f32>) -> vec3<f32> {
    return vec3<f32>(1f, 1f, 1f);
}

fn _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(param_15: vec3<f32>) -> vec3<f32> {
    return param_15;
}

fn _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(param_16: vec3<f32>) -> vec3<f32> {
    return param_16;
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var phi_804_: bool;
    var phi_805_: bool;
    var phi_806_: bool;
    var phi_810_: bool;
    var phi_811_: bool;
    var phi_812_: bool;
    var phi_813_: bool;
    var phi_814_: bool;
    var phi_815_: bool;
    var phi_816_: bool;
    var phi_817_: bool;
    var phi_818_: bool;
    var phi_819_: bool;
    var phi_820_: bool;
    var phi_821_: bool;
    var phi_822_: bool;
    var phi_823_: bool;
    var phi_824_: bool;
    var phi_825_: bool;
    var phi_826_: bool;
    var phi_827_: bool;
    var phi_831_: bool;
    var phi_835_: bool;
    var phi_910_: f32;
    var phi_917_: f32;
    var phi_925_: f32;
    var phi_932_: f32;
    var phi_940_: f32;
    var phi_947_: f32;
    var phi_972_: f32;
    var phi_977_: f32;
    var phi_982_: f32;
    var phi_1015_: bool;
    var phi_1016_: bool;
    var phi_1024_: u32;
    var phi_1025_: u32;
    var phi_1043_: vec3<f32>;
    var phi_1044_: vec3<f32>;
    var phi_1058_: u32;
    var phi_1063_: u32;
    var phi_1068_: u32;
    var phi_1182_: bool;
    var phi_1183_: bool;
    var phi_1214_: u32;
    var phi_1216_: lt_bvh_Hit;
    var phi_1219_: u32;
    var phi_1304_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1331_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1358_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1364_: u32;
    var phi_1367_: u32;
    var phi_1381_: u32;
    var phi_1391_: u32;
    var phi_1401_: u32;
    var phi_1419_: u32;
    var phi_1429_: u32;
    var phi_1439_: u32;
    var phi_1475_: u32;
    var phi_1488_: u32;
    var phi_1493_: u32;
    var phi_1494_: u32;
    var phi_1495_: u32;
    var phi_1365_: u32;
    var phi_1368_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_1553_: lt_bvh_Hit;
    var phi_1556_: u32;
    var phi_1602_: vec3<f32>;
    var phi_1603_: vec3<f32>;
    var phi_1636_: vec3<f32>;
    var phi_1637_: vec3<f32>;
    var phi_1670_: vec3<f32>;
    var phi_1671_: vec3<f32>;
    var phi_1691_: bool;
    var phi_1692_: bool;
    var phi_1696_: f32;
    var phi_1697_: f32;
    var phi_1698_: f32;
    var phi_1699_: f32;
    var phi_1707_: f32;
    var phi_1717_: bool;
    var phi_1718_: bool;
    var phi_1722_: f32;
    var phi_1723_: f32;
    var phi_1724_: f32;
    var phi_1725_: f32;
    var phi_1733_: f32;
    var phi_1743_: bool;
    var phi_1744_: bool;
    var phi_1748_: f32;
    var phi_1749_: f32;
    var phi_1750_: f32;
    var phi_1751_: f32;
    var phi_1759_: f32;
    var phi_1774_: f32;
    var phi_1775_: bool;
    var phi_1776_: f32;
    var phi_1777_: bool;
    var phi_1778_: f32;
    var phi_1779_: bool;
    var phi_1797_: f32;
    var phi_1798_: bool;
    var phi_1799_: bool;
    var phi_1800_: f32;
    var phi_1801_: bool;
    var phi_1802_: bool;
    var phi_1806_: bool;
    var phi_1807_: f32;
    var phi_1808_: bool;
    var phi_1844_: f32;
    var phi_1853_: f32;
    var phi_1862_: f32;
    var phi_1871_: f32;
    var phi_1878_: f32;
    var phi_1885_: f32;
    var phi_1898_: f32;
    var phi_1907_: f32;
    var phi_1916_: f32;
    var phi_1925_: f32;
    var phi_1932_: f32;
    var phi_1939_: f32;
    var phi_1962_: f32;
    var phi_1967_: f32;
    var phi_1972_: f32;
    var phi_1980_: f32;
    var phi_1985_: f32;
    var phi_1990_: f32;
    var phi_2002_: f32;
    var phi_2007_: f32;
    var phi_2012_: f32;
    var phi_2017_: f32;
    var phi_2022_: lt_bvh_triangle_Intersection;
    var phi_2023_: bool;
    var phi_2024_: lt_bvh_triangle_Intersection;
    var phi_2025_: bool;
    var phi_2029_: lt_bvh_triangle_Intersection;
    var phi_2030_: bool;
    var phi_2031_: lt_bvh_triangle_Intersection;
    var phi_2032_: bool;
    var phi_2033_: bool;
    var phi_2037_: bool;
    var phi_2041_: lt_bvh_triangle_Intersection;
    var phi_2080_: bool;
    var phi_2081_: bool;
    var phi_2082_: bool;
    var phi_2083_: bool;
    var phi_2084_: bool;
    var phi_2085_: bool;
    var phi_2089_: bool;
    var phi_2090_: bool;
    var phi_2293_: f32;
    var phi_2296_: bool;
    var phi_2297_: bool;
    var phi_2301_: bool;
    var phi_2309_: lt_bvh_Hit;
    var phi_2310_: lt_bvh_Hit;
    var phi_2311_: lt_bvh_Hit;
    var phi_2312_: lt_bvh_Hit;
    var phi_1554_: lt_bvh_Hit;
    var phi_1557_: u32;
    var phi_2313_: bool;
    var phi_2352_: bool;
    var phi_2353_: bool;
    var phi_2384_: u32;
    var phi_1217_: lt_bvh_Hit;
    var phi_1220_: u32;
    var phi_2385_: lt_bvh_Hit;
    var phi_2386_: lt_bvh_Hit;
    var phi_2387_: bool;
    var phi_2391_: lt_bvh_Hit;
    var phi_2456_: f32;
    var phi_2461_: f32;
    var phi_2466_: f32;
    var phi_2477_: f32;
    var phi_2482_: f32;
    var phi_2487_: f32;
    var phi_2563_: vec3<f32>;
    var phi_2684_: u32;
    var phi_2711_: f32;
    var phi_2718_: f32;
    var phi_2725_: f32;
    var phi_2760_: f32;
    var phi_2767_: f32;
    var phi_2774_: f32;
    var phi_2812_: f32;
    var phi_2819_: f32;
    var phi_2826_: f32;
    var phi_2885_: vec3<f32>;
    var phi_2886_: vec3<f32>;
    var phi_2887_: vec3<f32>;
    var phi_2896_: f32;
    var phi_2897_: f32;
    var phi_2907_: f32;
    var phi_2908_: f32;
    var phi_2918_: f32;
    var phi_2919_: f32;
    var phi_2954_: abi_Sample;
    var phi_3045_: vec3<f32>;
    var local_5: lt_bvh_Hit;
    var local_6: lt_bvh_Hit;

    let _e73 = id_1;
    let _e77 = arrayLength((&nodes.member));
    let _e80 = arrayLength((&triangles.member));
    let _e83 = arrayLength((&vertices.member));
    let _e86 = arrayLength((&materials.member));
    let _e92 = arrayLength((&alpha_texels.member));
    let _e95 = arrayLength((&before.member));
    let _e101 = p.member.size[0u];
    let _e103 = p.member.size[1u];
    let _e104 = lt_shaders_entry_pixel_index(_e73, _e101, _e103);
    if (bitcast<i32>(_e104.root) != 0i) {
        let _e112 = p.member.eye;
        let _e117 = p.member.size[0u];
        let _e121 = ((((f32(_e73.x) + 0.5f) / f32(_e117)) * 2f) - 1f);
        let _e126 = p.member.size[1u];
        let _e130 = (1f - (((f32(_e73.y) + 0.5f) / f32(_e126)) * 2f));
        let _e132 = p.member.forward;
        let _e134 = p.member.right;
        let _e148 = p.member.up;
        let _e159 = _lt_bvh_ray_Ray_new(_e112, vec3<f32>(((_e132.x + (_e134.x * _e121)) + (_e148.x * _e130)), ((_e132.y + (_e134.y * _e121)) + (_e148.y * _e130)), ((_e132.z + (_e134.z * _e121)) + (_e148.z * _e130))));
        let _e161 = lt_bvh_Hit(_e159.tmax, 0f, 0f, 4294967295u, 4294967295u);
        let _e171 = abs(_e159.direction.x);
        let _e173 = abs(_e159.direction.y);
        let _e175 = abs(_e159.direction.z);
        if (abs(_e159.origin.x) < 1000000000000000f) {
            if (abs(_e159.origin.y) < 1000000000000000f) {
                if (abs(_e159.origin.z) < 1000000000000000f) {
                    if (_e171 < 1000000000000000f) {
                        if (_e173 < 1000000000000000f) {
                            if (_e175 < 1000000000000000f) {
                                if (_e171 > 0f) {
                                    phi_805_ = bool();
                                    phi_806_ = true;
                                } else {
                                    let _e183 = (_e173 > 0f);
                                    if _e183 {
                                        phi_804_ = bool();
                                    } else {
                                        phi_804_ = (_e175 > 0f);
                                    }
                                    let _e186 = phi_804_;
                                    phi_805_ = _e186;
                                    phi_806_ = _e183;
                                }
                                let _e188 = phi_805_;
                                let _e190 = phi_806_;
                                if _e190 {
                                    phi_810_ = true;
                                } else {
                                    phi_810_ = _e188;
                                }
                                let _e192 = phi_810_;
                                phi_811_ = _e192;
                                phi_812_ = false;
                            } else {
                                phi_811_ = bool();
                                phi_812_ = true;
                            }
                            let _e194 = phi_811_;
                            let _e196 = phi_812_;
                            phi_813_ = _e194;
                            phi_814_ = false;
                            phi_815_ = _e196;
                        } else {
                            phi_813_ = bool();
                            phi_814_ = true;
                            phi_815_ = false;
                        }
                        let _e198 = phi_813_;
                        let _e200 = phi_814_;
                        let _e202 = phi_815_;
                        phi_816_ = _e198;
                        phi_817_ = _e200;
                        phi_818_ = _e202;
                    } else {
                        phi_816_ = bool();
                        phi_817_ = true;
                        phi_818_ = false;
                    }
                    let _e204 = phi_816_;
                    let _e206 = phi_817_;
                    let _e208 = phi_818_;
                    phi_819_ = _e204;
                    phi_820_ = _e206;
                    phi_821_ = _e208;
                } else {
                    phi_819_ = bool();
                    phi_820_ = true;
                    phi_821_ = false;
                }
                let _e210 = phi_819_;
                let _e212 = phi_820_;
                let _e214 = phi_821_;
                phi_822_ = _e210;
                phi_823_ = _e212;
                phi_824_ = _e214;
            } else {
                phi_822_ = bool();
                phi_823_ = true;
                phi_824_ = false;
            }
            let _e216 = phi_822_;
            let _e218 = phi_823_;
            let _e220 = phi_824_;
            phi_825_ = _e216;
            phi_826_ = _e218;
            phi_827_ = _e220;
        } else {
            phi_825_ = bool();
            phi_826_ = true;
            phi_827_ = false;
        }
        let _e222 = phi_825_;
        let _e224 = phi_826_;
        let _e226 = phi_827_;
        if _e224 {
            phi_831_ = true;
        } else {
            phi_831_ = _e226;
        }
        let _e228 = phi_831_;
        if _e228 {
            phi_835_ = false;
        } else {
            phi_835_ = _e222;
        }
        let _e230 = phi_835_;
        if _e230 {
            let _e231 = (0u >= _e77);
            if _e231 {
                phi_2385_ = lt_bvh_Hit();
            } else {
                if (0u < _e77) {
                } else {
                    return;
                }
                let _e237 = nodes.member[(0u + 0u)].frame[0u];
                let _e241 = nodes.member[(0u + 0u)].frame[1u];
                let _e245 = nodes.member[(0u + 0u)].frame[2u];
                let _e249 = nodes.member[(0u + 0u)].frame[0u];
                let _e253 = nodes.member[(0u + 0u)].frame[1u];
                let _e257 = nodes.member[(0u + 0u)].frame[2u];
                let _e261 = nodes.member[(0u + 0u)].frame[3u];
                let _e299 = core_intrinsics_maximum_number_nsz_f32_(abs(_e159.direction.x), abs(_e159.direction.y));
                let _e300 = core_intrinsics_maximum_number_nsz_f32_(_e299, abs(_e159.direction.z));
                let _e301 = (_e300 * 0.0000000000009094947f);
                if (abs(_e159.direction.x) < _e301) {
                    phi_910_ = _e301;
                } else {
                    phi_910_ = abs(_e159.direction.x);
                }
                let _e308 = phi_910_;
                if (_e159.direction.x < 0f) {
                    phi_917_ = (-1f / _e308);
                } else {
                    phi_917_ = (1f / _e308);
                }
                let _e313 = phi_917_;
                if (abs(_e159.direction.y) < _e301) {
                    phi_925_ = _e301;
                } else {
                    phi_925_ = abs(_e159.direction.y);
                }
                let _e320 = phi_925_;
                if (_e159.direction.y < 0f) {
                    phi_932_ = (-1f / _e320);
                } else {
                    phi_932_ = (1f / _e320);
                }
                let _e325 = phi_932_;
                if (abs(_e159.direction.z) < _e301) {
                    phi_940_ = _e301;
                } else {
                    phi_940_ = abs(_e159.direction.z);
                }
                let _e332 = phi_940_;
                if (_e159.direction.z < 0f) {
                    phi_947_ = (-1f / _e332);
                } else {
                    phi_947_ = (1f / _e332);
                }
                let _e337 = phi_947_;
                let _e345 = abs((bitcast<f32>(_e237) - _e159.origin.x));
                let _e346 = abs((bitcast<f32>(_e241) - _e159.origin.y));
                let _e347 = abs((bitcast<f32>(_e245) - _e159.origin.z));
                let _e355 = abs(((bitcast<f32>(_e249) + (bitcast<f32>((((_e261 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e159.origin.x));
                let _e356 = abs(((bitcast<f32>(_e253) + (bitcast<f32>((((_e261 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e159.origin.y));
                let _e357 = abs(((bitcast<f32>(_e257) + (bitcast<f32>((((_e261 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e159.origin.z));
                if (_e345 > _e355) {
                    phi_972_ = _e345;
                } else {
                    phi_972_ = _e355;
                }
                let _e360 = phi_972_;
                if (_e346 > _e356) {
                    phi_977_ = _e346;
                } else {
                    phi_977_ = _e356;
                }
                let _e363 = phi_977_;
                if (_e347 > _e357) {
                    phi_982_ = _e347;
                } else {
                    phi_982_ = _e357;
                }
                let _e366 = phi_982_;
                let _e367 = core_intrinsics_maximum_number_nsz_f32_(_e360, _e363);
                let _e368 = core_intrinsics_maximum_number_nsz_f32_(_e367, _e366);
                let _e373 = (_e368 * 0.0000019073486f);
                let _e374 = (abs(_e313) * _e373);
                let _e375 = (abs(_e325) * _e373);
                let _e376 = (abs(_e337) * _e373);
                let _e380 = (_e368 * 0.0000009536743f);
                let _e381 = (abs(_e313) * _e380);
                let _e382 = (abs(_e325) * _e380);
                let _e383 = (abs(_e337) * _e380);
                let _e386 = abs(_e159.direction.x);
                let _e388 = abs(_e159.direction.y);
                let _e390 = abs(_e159.direction.z);
                if (_e386 >= _e388) {
                    if (_e386 >= _e390) {
                        phi_1015_ = false;
                    } else {
                        phi_1015_ = true;
                    }
                    let _e394 = phi_1015_;
                    phi_1016_ = _e394;
                } else {
                    phi_1016_ = true;
                }
                let _e396 = phi_1016_;
                if _e396 {
                    if (_e388 >= _e390) {
                        phi_1024_ = 1u;
                    } else {
                        phi_1024_ = 2u;
                    }
                    let _e399 = phi_1024_;
                    phi_1025_ = _e399;
                } else {
                    phi_1025_ = 0u;
                }
                let _e401 = phi_1025_;
                if (_e401 == 0u) {
                    phi_1044_ = vec3<f32>(_e159.direction.y, _e159.direction.z, _e159.direction.x);
                } else {
                    if (_e401 == 1u) {
                        phi_1043_ = vec3<f32>(_e159.direction.z, _e159.direction.x, _e159.direction.y);
                    } else {
                        phi_1043_ = _e159.direction;
                    }
                    let _e414 = phi_1043_;
                    phi_1044_ = _e414;
                }
                let _e416 = phi_1044_;
                let _e420 = (_e416.x / _e416.z);
                let _e423 = (_e416.y / _e416.z);
                let _e425 = (1f / _e416.z);
                if (_e313 < 0f) {
                    phi_1058_ = 0u;
                } else {
                    phi_1058_ = 1u;
                }
                let _e428 = phi_1058_;
                if (_e325 < 0f) {
                    phi_1063_ = 0u;
                } else {
                    phi_1063_ = 2u;
                }
                let _e431 = phi_1063_;
                if (_e337 < 0f) {
                    phi_1068_ = 0u;
                } else {
                    phi_1068_ = 4u;
                }
                let _e434 = phi_1068_;
                let _e436 = ((_e428 | _e431) | _e434);
                let _e437 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e437.first[0], _e437.first[1], _e437.first[2], _e437.first[3], _e437.first[4], _e437.first[5], _e437.first[6], _e437.first[7], _e437.first[8], _e437.first[9], _e437.first[10], _e437.first[11], _e437.first[12], _e437.first[13], _e437.first[14], _e437.first[15], _e437.first[16], _e437.first[17], _e437.first[18], _e437.first[19], _e437.first[20], _e437.first[21], _e437.first[22], _e437.first[23], _e437.first[24], _e437.first[25], _e437.first[26], _e437.first[27], _e437.first[28], _e437.first[29], _e437.first[30], _e437.first[31]), array<u32, 32>(_e437.mask[0], _e437.mask[1], _e437.mask[2], _e437.mask[3], _e437.mask[4], _e437.mask[5], _e437.mask[6], _e437.mask[7], _e437.mask[8], _e437.mask[9], _e437.mask[10], _e437.mask[11], _e437.mask[12], _e437.mask[13], _e437.mask[14], _e437.mask[15], _e437.mask[16], _e437.mask[17], _e437.mask[18], _e437.mask[19], _e437.mask[20], _e437.mask[21], _e437.mask[22], _e437.mask[23], _e437.mask[24], _e437.mask[25], _e437.mask[26], _e437.mask[27], _e437.mask[28], _e437.mask[29], _e437.mask[30], _e437.mask[31]), _e437.len, _e437.group, _e437.group_mask);
                let _e511 = local_1.group_mask;
                if ((_e511 & 4278190080u) == 0u) {
                    let _e515 = local_1.len;
                    if (_e515 == 0u) {
                        phi_1182_ = false;
                    } else {
                        let _e519 = local_1.len;
                        local_1.len = (_e519 - 1u);
                        let _e522 = local_1.len;
                        if (_e522 < 32u) {
                        } else {
                            return;
                        }
                        let _e527 = local_1.first[(0u + _e522)];
                        local_1.group = _e527;
                        let _e530 = local_1.len;
                        if (_e530 < 32u) {
                        } else {
                            return;
                        }
                        let _e535 = local_1.mask[(0u + _e530)];
                        local_1.group_mask = _e535;
                        phi_1182_ = true;
                    }
                    let _e538 = phi_1182_;
                    phi_1183_ = _e538;
                } else {
                    phi_1183_ = true;
                }
                let _e540 = phi_1183_;
                if _e540 {
                    let _e542 = local_1.group_mask;
                    let _e548 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e542)), 32u, (_e542 == 0u)));
                    let _e552 = local_1.group_mask;
                    let _e566 = local_1.group_mask;
                    local_1.group_mask = (_e566 & ~((1u << bitcast<u32>((_e548 & 31u)))));
                    let _e569 = local_1.group;
                    phi_1214_ = (_e569 + countOneBits(((_e552 & ~((4294967295u << bitcast<u32>((((_e548 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1214_ = 4294967295u;
                }
                let _e572 = phi_1214_;
                phi_1216_ = _e161;
                phi_1219_ = _e572;
                loop {
                    let _e574 = phi_1216_;
                    let _e576 = phi_1219_;
                    local_6 = _e574;
                    let _e577 = (_e576 != 4294967295u);
                    if _e577 {
                        if (_e576 < _e77) {
                        } else {
                            return;
                        }
                        let _e585 = nodes.member[(0u + _e576)].frame[3u];
                        let _e610 = (bitcast<f32>((((_e585 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e313);
                        let _e611 = (bitcast<f32>((((_e585 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e325);
                        let _e612 = (bitcast<f32>((((_e585 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e337);
                        let _e615 = nodes.member[(0u + _e576)].frame[0u];
                        let _e619 = nodes.member[(0u + _e576)].frame[1u];
                        let _e623 = nodes.member[(0u + _e576)].frame[2u];
                        let _e631 = ((bitcast<f32>(_e615) - _e159.origin.x) * _e313);
                        let _e632 = ((bitcast<f32>(_e619) - _e159.origin.y) * _e325);
                        let _e633 = ((bitcast<f32>(_e623) - _e159.origin.z) * _e337);
                        let _e641 = nodes.member[(0u + _e576)].x;
                        if (_e313 < 0f) {
                            let _e652 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e641.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e658 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e652.unnamed.root, _e641.w), _e652.unnamed_1);
                            let _e664 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e658.unnamed, lt_bvh_traverse_Tree(_e641.x, _e658.unnamed_1.first_primitive));
                            phi_1304_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e664.unnamed, lt_bvh_traverse_Tree(_e664.unnamed_1.root, _e641.y));
                        } else {
                            let _e680 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e641.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e686 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e680.unnamed.root, _e641.y), _e680.unnamed_1);
                            let _e692 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e686.unnamed, lt_bvh_traverse_Tree(_e641.z, _e686.unnamed_1.first_primitive));
                            phi_1304_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e692.unnamed, lt_bvh_traverse_Tree(_e692.unnamed_1.root, _e641.w));
                        }
                        let _e700 = phi_1304_;
                        let _e710 = nodes.member[(0u + _e576)].y;
                        if (_e325 < 0f) {
                            let _e721 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e710.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e727 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e721.unnamed.root, _e710.w), _e721.unnamed_1);
                            let _e733 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e727.unnamed, lt_bvh_traverse_Tree(_e710.x, _e727.unnamed_1.first_primitive));
                            phi_1331_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e733.unnamed, lt_bvh_traverse_Tree(_e733.unnamed_1.root, _e710.y));
                        } else {
                            let _e749 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e710.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e755 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e749.unnamed.root, _e710.y), _e749.unnamed_1);
                            let _e761 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e755.unnamed, lt_bvh_traverse_Tree(_e710.z, _e755.unnamed_1.first_primitive));
                            phi_1331_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e761.unnamed, lt_bvh_traverse_Tree(_e761.unnamed_1.root, _e710.w));
                        }
                        let _e769 = phi_1331_;
                        let _e779 = nodes.member[(0u + _e576)].z;
                        if (_e337 < 0f) {
                            let _e790 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e779.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e796 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e790.unnamed.root, _e779.w), _e790.unnamed_1);
                            let _e802 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e796.unnamed, lt_bvh_traverse_Tree(_e779.x, _e796.unnamed_1.first_primitive));
                            phi_1358_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e802.unnamed, lt_bvh_traverse_Tree(_e802.unnamed_1.root, _e779.y));
                        } else {
                            let _e818 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e779.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e824 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e818.unnamed.root, _e779.y), _e818.unnamed_1);
                            let _e830 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e824.unnamed, lt_bvh_traverse_Tree(_e779.z, _e824.unnamed_1.first_primitive));
                            phi_1358_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e830.unnamed, lt_bvh_traverse_Tree(_e830.unnamed_1.root, _e779.w));
                        }
                        let _e838 = phi_1358_;
                        phi_1364_ = 0u;
                        phi_1367_ = 0u;
                        loop {
                            let _e848 = phi_1364_;
                            let _e850 = phi_1367_;
                            local_2 = _e850;
                            local_3 = _e850;
                            local_4 = _e850;
                            let _e851 = (_e848 < 8u);
                            if _e851 {
                                let _e853 = (_e848 >> bitcast<u32>(2i));
                                let _e854 = (_e848 & 3u);
                                if (_e853 == 0u) {
                                    phi_1381_ = _e700.unnamed.root;
                                } else {
                                    phi_1381_ = _e700.unnamed.first_primitive;
                                }
                                let _e857 = phi_1381_;
                                if (_e853 == 0u) {
                                    phi_1391_ = _e769.unnamed.root;
                                } else {
                                    phi_1391_ = _e769.unnamed.first_primitive;
                                }
                                let _e866 = phi_1391_;
                                if (_e853 == 0u) {
                                    phi_1401_ = _e838.unnamed.root;
                                } else {
                                    phi_1401_ = _e838.unnamed.first_primitive;
                                }
                                let _e875 = phi_1401_;
                                let _e888 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e857 >> bitcast<u32>(((_e854 * 8u) & 31u))) & 255u)) * _e610) + (_e631 - _e374)), ((f32(((_e866 >> bitcast<u32>(((_e854 * 8u) & 31u))) & 255u)) * _e611) + (_e632 - _e375)));
                                let _e889 = core_intrinsics_maximum_number_nsz_f32_(_e888, ((f32(((_e875 >> bitcast<u32>(((_e854 * 8u) & 31u))) & 255u)) * _e612) + (_e633 - _e376)));
                                if (_e853 == 0u) {
                                    phi_1419_ = _e700.unnamed_1.root;
                                } else {
                                    phi_1419_ = _e700.unnamed_1.first_primitive;
                                }
                                let _e892 = phi_1419_;
                                if (_e853 == 0u) {
                                    phi_1429_ = _e769.unnamed_1.root;
                                } else {
                                    phi_1429_ = _e769.unnamed_1.first_primitive;
                                }
                                let _e901 = phi_1429_;
                                if (_e853 == 0u) {
                                    phi_1439_ = _e838.unnamed_1.root;
                                } else {
                                    phi_1439_ = _e838.unnamed_1.first_primitive;
                                }
                                let _e910 = phi_1439_;
                                let _e923 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e892 >> bitcast<u32>(((_e854 * 8u) & 31u))) & 255u)) * _e610) + (_e631 + _e374)), ((f32(((_e901 >> bitcast<u32>(((_e854 * 8u) & 31u))) & 255u)) * _e611) + (_e632 + _e375)));
                                let _e924 = core_intrinsics_minimum_number_nsz_f32_(_e923, ((f32(((_e910 >> bitcast<u32>(((_e854 * 8u) & 31u))) & 255u)) * _e612) + (_e633 + _e376)));
                                if (_e889 <= _e924) {
                                    if (_e889 <= _e574.t) {
                                        if (_e924 >= _e159.tmin) {
                                            if (_e853 == 0u) {
                                                let _e931 = nodes.member[(0u + _e576)].links[2u];
                                                phi_1475_ = _e931;
                                            } else {
                                                let _e934 = nodes.member[(0u + _e576)].links[3u];
                                                phi_1475_ = _e934;
                                            }
                                            let _e936 = phi_1475_;
                                            let _e941 = ((_e936 >> bitcast<u32>(((_e854 * 8u) & 31u))) & 255u);
                                            let _e942 = (_e941 & 31u);
                                            if (_e942 >= 24u) {
                                                phi_1488_ = (24u + ((_e942 - 24u) ^ _e436));
                                            } else {
                                                phi_1488_ = _e942;
                                            }
                                            let _e948 = phi_1488_;
                                            phi_1493_ = (_e850 | ((_e941 >> bitcast<u32>(5i)) << bitcast<u32>((_e948 & 31u))));
                                        } else {
                                            phi_1493_ = _e850;
                                        }
                                        let _e956 = phi_1493_;
                                        phi_1494_ = _e956;
                                    } else {
                                        phi_1494_ = _e850;
                                    }
                                    let _e958 = phi_1494_;
                                    phi_1495_ = _e958;
                                } else {
                                    phi_1495_ = _e850;
                                }
                                let _e960 = phi_1495_;
                                phi_1365_ = (_e848 + 1u);
                                phi_1368_ = _e960;
                            } else {
                                phi_1365_ = u32();
                                phi_1368_ = u32();
                            }
                            let _e963 = phi_1365_;
                            let _e965 = phi_1368_;
                            continue;
                            continuing {
                                phi_1364_ = _e963;
                                phi_1367_ = _e965;
                                break if !(_e851);
                            }
                        }
                        let _e969 = nodes.member[(0u + _e576)].links[0u];
                        let _e973 = nodes.member[(0u + _e576)].frame[3u];
                        let _e977 = local_2;
                        if ((_e977 & 4278190080u) == 0u) {
                        } else {
                            let _e981 = local_1.group_mask;
                            if ((_e981 & 4278190080u) == 0u) {
                            } else {
                                let _e985 = local_1.len;
                                if (_e985 < 32u) {
                                    let _e988 = local_1.group;
                                    let _e990 = local_1.len;
                                    if (_e990 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.first[(0u + _e990)] = _e988;
                                    let _e996 = local_1.group_mask;
                                    let _e998 = local_1.len;
                                    if (_e998 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.mask[(0u + _e998)] = _e996;
                                    let _e1005 = local_1.len;
                                    local_1.len = (_e1005 + 1u);
                                }
                            }
                            local_1.group = (0u + _e969);
                            let _e1009 = local_3;
                            local_1.group_mask = ((_e1009 & 4278190080u) | (_e973 >> bitcast<u32>(24i)));
                        }
                        let _e1014 = local_4;
                        phi_1553_ = _e574;
                        phi_1556_ = (_e1014 & 16777215u);
                        loop {
                            let _e1017 = phi_1553_;
                            let _e1019 = phi_1556_;
                            local_5 = _e1017;
                            if (_e1019 == 0u) {
                                phi_1554_ = lt_bvh_Hit();
                                phi_1557_ = u32();
                                phi_2313_ = false;
                            } else {
                                let _e1023 = nodes.member[(0u + _e576)].links[1u];
                                let _e1028 = ((0u + _e1023) + select(firstTrailingBit(_e1019), 32u, (_e1019 == 0u)));
                                if (_e1028 < _e80) {
                                } else {
                                    return;
                                }
                                let _e1035 = triangles.member[(0u + _e1028)].v0_;
                                let _e1038 = (_e1035.x - _e159.origin.x);
                                let _e1041 = (_e1035.y - _e159.origin.y);
                                let _e1044 = (_e1035.z - _e159.origin.z);
                                if (_e401 == 0u) {
                                    phi_1603_ = vec3<f32>(_e1041, _e1044, _e1038);
                                } else {
                                    if (_e401 == 1u) {
                                        phi_1602_ = vec3<f32>(_e1044, _e1038, _e1041);
                                    } else {
                                        phi_1602_ = (_e1035 - _e159.origin);
                                    }
                                    let _e1051 = phi_1602_;
                                    phi_1603_ = _e1051;
                                }
                                let _e1053 = phi_1603_;
                                let _e1057 = (_e1053.x - (_e420 * _e1053.z));
                                let _e1061 = (_e1053.y - (_e423 * _e1053.z));
                                let _e1065 = triangles.member[(0u + _e1028)].v1_;
                                let _e1068 = (_e1065.x - _e159.origin.x);
                                let _e1071 = (_e1065.y - _e159.origin.y);
                                let _e1074 = (_e1065.z - _e159.origin.z);
                                if (_e401 == 0u) {
                                    phi_1637_ = vec3<f32>(_e1071, _e1074, _e1068);
                                } else {
                                    if (_e401 == 1u) {
                                        phi_1636_ = vec3<f32>(_e1074, _e1068, _e1071);
                                    } else {
                                        phi_1636_ = (_e1065 - _e159.origin);
                                    }
                                    let _e1081 = phi_1636_;
                                    phi_1637_ = _e1081;
                                }
                                let _e1083 = phi_1637_;
                                let _e1087 = (_e1083.x - (_e420 * _e1083.z));
                                let _e1091 = (_e1083.y - (_e423 * _e1083.z));
                                let _e1095 = triangles.member[(0u + _e1028)].v2_;
                                let _e1098 = (_e1095.x - _e159.origin.x);
                                let _e1101 = (_e1095.y - _e159.origin.y);
                                let _e1104 = (_e1095.z - _e159.origin.z);
                                if (_e401 == 0u) {
                                    phi_1671_ = vec3<f32>(_e1101, _e1104, _e1098);
                                } else {
                                    if (_e401 == 1u) {
                                        phi_1670_ = vec3<f32>(_e1104, _e1098, _e1101);
                                    } else {
                                        phi_1670_ = (_e1095 - _e159.origin);
                                    }
                                    let _e1111 = phi_1670_;
                                    phi_1671_ = _e1111;
                                }
                                let _e1113 = phi_1671_;
                                let _e1117 = (_e1113.x - (_e420 * _e1113.z));
                                let _e1121 = (_e1113.y - (_e423 * _e1113.z));
                                if (_e1087 < _e1117) {
                                    phi_1692_ = true;
                                } else {
                                    if (_e1087 == _e1117) {
                                        phi_1691_ = (_e1091 < _e1121);
                                    } else {
                                        phi_1691_ = false;
                                    }
                                    let _e1128 = phi_1691_;
                                    phi_1692_ = _e1128;
                                }
                                let _e1130 = phi_1692_;
                                if _e1130 {
                                    phi_1696_ = _e1121;
                                    phi_1697_ = _e1117;
                                    phi_1698_ = _e1091;
                                    phi_1699_ = _e1087;
                                } else {
                                    phi_1696_ = _e1091;
                                    phi_1697_ = _e1087;
                                    phi_1698_ = _e1121;
                                    phi_1699_ = _e1117;
                                }
                                let _e1132 = phi_1696_;
                                let _e1134 = phi_1697_;
                                let _e1136 = phi_1698_;
                                let _e1138 = phi_1699_;
                                let _e1141 = ((_e1138 * _e1132) - (_e1136 * _e1134));
                                if _e1130 {
                                    phi_1707_ = -(_e1141);
                                } else {
                                    phi_1707_ = _e1141;
                                }
                                let _e1144 = phi_1707_;
                                if (_e1117 < _e1057) {
                                    phi_1718_ = true;
                                } else {
                                    if (_e1117 == _e1057) {
                                        phi_1717_ = (_e1121 < _e1061);
                                    } else {
                                        phi_1717_ = false;
                                    }
                                    let _e1149 = phi_1717_;
                                    phi_1718_ = _e1149;
                                }
                                let _e1151 = phi_1718_;
                                if _e1151 {
                                    phi_1722_ = _e1061;
                                    phi_1723_ = _e1057;
                                    phi_1724_ = _e1121;
                                    phi_1725_ = _e1117;
                                } else {
                                    phi_1722_ = _e1121;
                                    phi_1723_ = _e1117;
                                    phi_1724_ = _e1061;
                                    phi_1725_ = _e1057;
                                }
                                let _e1153 = phi_1722_;
                                let _e1155 = phi_1723_;
                                let _e1157 = phi_1724_;
                                let _e1159 = phi_1725_;
                                let _e1162 = ((_e1159 * _e1153) - (_e1157 * _e1155));
                                if _e1151 {
                                    phi_1733_ = -(_e1162);
                                } else {
                                    phi_1733_ = _e1162;
                                }
                                let _e1165 = phi_1733_;
                                if (_e1057 < _e1087) {
                                    phi_1744_ = true;
                                } else {
                                    if (_e1057 == _e1087) {
                                        phi_1743_ = (_e1061 < _e1091);
                                    } else {
                                        phi_1743_ = false;
                                    }
                                    let _e1170 = phi_1743_;
                                    phi_1744_ = _e1170;
                                }
                                let _e1172 = phi_1744_;
                                if _e1172 {
                                    phi_1748_ = _e1091;
                                    phi_1749_ = _e1087;
                                    phi_1750_ = _e1061;
                                    phi_1751_ = _e1057;
                                } else {
                                    phi_1748_ = _e1061;
                                    phi_1749_ = _e1057;
                                    phi_1750_ = _e1091;
                                    phi_1751_ = _e1087;
                                }
                                let _e1174 = phi_1748_;
                                let _e1176 = phi_1749_;
                                let _e1178 = phi_1750_;
                                let _e1180 = phi_1751_;
                                let _e1183 = ((_e1180 * _e1174) - (_e1178 * _e1176));
                                if _e1172 {
                                    phi_1759_ = -(_e1183);
                                } else {
                                    phi_1759_ = _e1183;
                                }
                                let _e1186 = phi_1759_;
                                if (_e1144 >= 0f) {
                                    if (_e1165 >= 0f) {
                                        if (_e1186 >= 0f) {
                                            phi_1774_ = ((_e1144 + _e1165) + _e1186);
                                            phi_1775_ = false;
                                        } else {
                                            phi_1774_ = f32();
                                            phi_1775_ = true;
                                        }
                                        let _e1193 = phi_1774_;
                                        let _e1195 = phi_1775_;
                                        phi_1776_ = _e1193;
                                        phi_1777_ = _e1195;
                                    } else {
                                        phi_1776_ = f32();
                                        phi_1777_ = true;
                                    }
                                    let _e1197 = phi_1776_;
                                    let _e1199 = phi_1777_;
                                    phi_1778_ = _e1197;
                                    phi_1779_ = _e1199;
                                } else {
                                    phi_1778_ = f32();
                                    phi_1779_ = true;
                                }
                                let _e1201 = phi_1778_;
                                let _e1203 = phi_1779_;
                                if _e1203 {
                                    if (_e1144 <= 0f) {
                                        if (_e1165 <= 0f) {
                                            let _e1206 = (_e1186 <= 0f);
                                            if _e1206 {
                                            }
                                            phi_1797_ = ((_e1144 + _e1165) + _e1186);
                                            phi_1798_ = false;
                                            phi_1799_ = _e1206;
                                        } else {
                                            phi_1797_ = f32();
                                            phi_1798_ = true;
                                            phi_1799_ = false;
                                        }
                                        let _e1210 = phi_1797_;
                                        let _e1212 = phi_1798_;
                                        let _e1214 = phi_1799_;
                                        phi_1800_ = _e1210;
                                        phi_1801_ = _e1212;
                                        phi_1802_ = _e1214;
                                    } else {
                                        phi_1800_ = f32();
                                        phi_1801_ = true;
                                        phi_1802_ = false;
                                    }
                                    let _e1216 = phi_1800_;
                                    let _e1218 = phi_1801_;
                                    let _e1220 = phi_1802_;
                                    if _e1218 {
                                        phi_1806_ = false;
                                    } else {
                                        phi_1806_ = _e1220;
                                    }
                                    let _e1222 = phi_1806_;
                                    phi_1807_ = _e1216;
                                    phi_1808_ = _e1222;
                                } else {
                                    phi_1807_ = _e1201;
                                    phi_1808_ = true;
                                }
                                let _e1224 = phi_1807_;
                                let _e1226 = phi_1808_;
                                if _e1226 {
                                    let _e1227 = (_e1224 == 0f);
                                    if _e1227 {
                                        phi_2029_ = lt_bvh_triangle_Intersection();
                                        phi_2030_ = false;
                                    } else {
                                        let _e1233 = ((((_e1144 * (_e425 * _e1053.z)) + (_e1165 * (_e425 * _e1083.z))) + (_e1186 * (_e425 * _e1113.z))) / _e1224);
                                        if (_e1233 > _e159.tmin) {
                                            if (_e1233 < _e159.tmax) {
                                                let _e1239 = triangles.member[(0u + _e1028)].v0_;
                                                let _e1241 = triangles.member[(0u + _e1028)].v1_;
                                                if (_e1239.x < _e1241.x) {
                                                    phi_1844_ = _e1239.x;
                                                } else {
                                                    phi_1844_ = _e1241.x;
                                                }
                                                let _e1248 = phi_1844_;
                                                if (_e1239.y < _e1241.y) {
                                                    phi_1853_ = _e1239.y;
                                                } else {
                                                    phi_1853_ = _e1241.y;
                                                }
                                                let _e1255 = phi_1853_;
                                                if (_e1239.z < _e1241.z) {
                                                    phi_1862_ = _e1239.z;
                                                } else {
                                                    phi_1862_ = _e1241.z;
                                                }
                                                let _e1262 = phi_1862_;
                                                let _e1264 = triangles.member[(0u + _e1028)].v2_;
                                                if (_e1248 < _e1264.x) {
                                                    phi_1871_ = _e1248;
                                                } else {
                                                    phi_1871_ = _e1264.x;
                                                }
                                                let _e1269 = phi_1871_;
                                                if (_e1255 < _e1264.y) {
                                                    phi_1878_ = _e1255;
                                                } else {
                                                    phi_1878_ = _e1264.y;
                                                }
                                                let _e1274 = phi_1878_;
                                                if (_e1262 < _e1264.z) {
                                                    phi_1885_ = _e1262;
                                                } else {
                                                    phi_1885_ = _e1264.z;
                                                }
                                                let _e1279 = phi_1885_;
                                                let _e1281 = triangles.member[(0u + _e1028)].v0_;
                                                let _e1283 = triangles.member[(0u + _e1028)].v1_;
                                                if (_e1281.x > _e1283.x) {
                                                    phi_1898_ = _e1281.x;
                                                } else {
                                                    phi_1898_ = _e1283.x;
                                                }
                                                let _e1290 = phi_1898_;
                                                if (_e1281.y > _e1283.y) {
                                                    phi_1907_ = _e1281.y;
                                                } else {
                                                    phi_1907_ = _e1283.y;
                                                }
                                                let _e1297 = phi_1907_;
                                                if (_e1281.z > _e1283.z) {
                                                    phi_1916_ = _e1281.z;
                                                } else {
                                                    phi_1916_ = _e1283.z;
                                                }
                                                let _e1304 = phi_1916_;
                                                let _e1306 = triangles.member[(0u + _e1028)].v2_;
                                                if (_e1290 > _e1306.x) {
                                                    phi_1925_ = _e1290;
                                                } else {
                                                    phi_1925_ = _e1306.x;
                                                }
                                                let _e1311 = phi_1925_;
                                                if (_e1297 > _e1306.y) {
                                                    phi_1932_ = _e1297;
                                                } else {
                                                    phi_1932_ = _e1306.y;
                                                }
                                                let _e1316 = phi_1932_;
                                                if (_e1304 > _e1306.z) {
                                                    phi_1939_ = _e1304;
                                                } else {
                                                    phi_1939_ = _e1306.z;
                                                }
                                                let _e1321 = phi_1939_;
                                                let _e1328 = ((_e1269 - _e159.origin.x) * _e313);
                                                let _e1329 = ((_e1274 - _e159.origin.y) * _e325);
                                                let _e1330 = ((_e1279 - _e159.origin.z) * _e337);
                                                let _e1337 = ((_e1311 - _e159.origin.x) * _e313);
                                                let _e1338 = ((_e1316 - _e159.origin.y) * _e325);
                                                let _e1339 = ((_e1321 - _e159.origin.z) * _e337);
                                                if (_e1328 < _e1337) {
                                                    phi_1962_ = _e1328;
                                                } else {
                                                    phi_1962_ = _e1337;
                                                }
                                                let _e1342 = phi_1962_;
                                                if (_e1329 < _e1338) {
                                                    phi_1967_ = _e1329;
                                                } else {
                                                    phi_1967_ = _e1338;
                                                }
                                                let _e1345 = phi_1967_;
                                                if (_e1330 < _e1339) {
                                                    phi_1972_ = _e1330;
                                                } else {
                                                    phi_1972_ = _e1339;
                                                }
                                                let _e1348 = phi_1972_;
                                                if (_e1328 > _e1337) {
                                                    phi_1980_ = _e1328;
                                                } else {
                                                    phi_1980_ = _e1337;
                                                }
                                                let _e1354 = phi_1980_;
                                                if (_e1329 > _e1338) {
                                                    phi_1985_ = _e1329;
                                                } else {
                                                    phi_1985_ = _e1338;
                                                }
                                                let _e1357 = phi_1985_;
                                                if (_e1330 > _e1339) {
                                                    phi_1990_ = _e1330;
                                                } else {
                                                    phi_1990_ = _e1339;
                                                }
                                                let _e1360 = phi_1990_;
                                                let _e1364 = core_intrinsics_maximum_number_nsz_f32_((_e1342 - _e381), (_e1345 - _e382));
                                                let _e1365 = core_intrinsics_maximum_number_nsz_f32_(_e1364, (_e1348 - _e383));
                                                let _e1366 = core_intrinsics_minimum_number_nsz_f32_((_e1354 + _e381), (_e1357 + _e382));
                                                let _e1367 = core_intrinsics_minimum_number_nsz_f32_(_e1366, (_e1360 + _e383));
                                                if (_e1365 > -300000000000000000000000000000000000000f) {
                                                    phi_2002_ = _e1365;
                                                } else {
                                                    phi_2002_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1370 = phi_2002_;
                                                if (_e1367 < 300000000000000000000000000000000000000f) {
                                                    phi_2007_ = _e1367;
                                                } else {
                                                    phi_2007_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1373 = phi_2007_;
                                                if (_e1233 < _e1370) {
                                                    phi_2012_ = _e1370;
                                                } else {
                                                    phi_2012_ = _e1233;
                                                }
                                                let _e1376 = phi_2012_;
                                                if (_e1376 > _e1373) {
                                                    phi_2017_ = _e1373;
                                                } else {
                                                    phi_2017_ = _e1376;
                                                }
                                                let _e1379 = phi_2017_;
                                                phi_2022_ = lt_bvh_triangle_Intersection(_e1379, (_e1165 / _e1224), (_e1186 / _e1224), (_e1370 <= _e1373));
                                                phi_2023_ = false;
                                            } else {
                                                phi_2022_ = lt_bvh_triangle_Intersection();
                                                phi_2023_ = true;
                                            }
                                            let _e1385 = phi_2022_;
                                            let _e1387 = phi_2023_;
                                            phi_2024_ = _e1385;
                                            phi_2025_ = _e1387;
                                        } else {
                                            phi_2024_ = lt_bvh_triangle_Intersection();
                                            phi_2025_ = true;
                                        }
                                        let _e1389 = phi_2024_;
                                        let _e1391 = phi_2025_;
                                        if _e1391 {
                                        }
                                        phi_2029_ = _e1389;
                                        phi_2030_ = _e1391;
                                    }
                                    let _e1393 = phi_2029_;
                                    let _e1395 = phi_2030_;
                                    phi_2031_ = _e1393;
                                    phi_2032_ = _e1227;
                                    phi_2033_ = _e1395;
                                } else {
                                    phi_2031_ = lt_bvh_triangle_Intersection();
                                    phi_2032_ = true;
                                    phi_2033_ = false;
                                }
                                let _e1397 = phi_2031_;
                                let _e1399 = phi_2032_;
                                let _e1401 = phi_2033_;
                                if _e1399 {
                                    phi_2037_ = true;
                                } else {
                                    phi_2037_ = _e1401;
                                }
                                let _e1403 = phi_2037_;
                                if _e1403 {
                                    phi_2041_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_2041_ = _e1397;
                                }
                                let _e1405 = phi_2041_;
                                if _e1405.is_hit {
                                    if (_e1405.t > _e159.tmin) {
                                        if (_e1405.t < _e1017.t) {
                                            phi_2090_ = true;
                                        } else {
                                            if (_e1405.t == _e1017.t) {
                                                if (_e1017.triangle != 4294967295u) {
                                                    if (_e1028 < _e1017.triangle) {
                                                        phi_2081_ = true;
                                                    } else {
                                                        if (_e1028 == _e1017.triangle) {
                                                            phi_2080_ = (4294967295u < _e1017.instance);
                                                        } else {
                                                            phi_2080_ = false;
                                                        }
                                                        let _e1424 = phi_2080_;
                                                        phi_2081_ = _e1424;
                                                    }
                                                    let _e1426 = phi_2081_;
                                                    phi_2082_ = _e1426;
                                                    phi_2083_ = false;
                                                } else {
                                                    phi_2082_ = bool();
                                                    phi_2083_ = true;
                                                }
                                                let _e1428 = phi_2082_;
                                                let _e1430 = phi_2083_;
                                                phi_2084_ = _e1428;
                                                phi_2085_ = _e1430;
                                            } else {
                                                phi_2084_ = bool();
                                                phi_2085_ = true;
                                            }
                                            let _e1432 = phi_2084_;
                                            let _e1434 = phi_2085_;
                                            if _e1434 {
                                                phi_2089_ = false;
                                            } else {
                                                phi_2089_ = _e1432;
                                            }
                                            let _e1436 = phi_2089_;
                                            phi_2090_ = _e1436;
                                        }
                                        let _e1438 = phi_2090_;
                                        if _e1438 {
                                            let _e1440 = triangles.member[(0u + _e1028)].i0_;
                                            if ((_e1440 & 2147483648u) == 0u) {
                                                phi_2301_ = true;
                                            } else {
                                                if (_e1028 < _e80) {
                                                } else {
                                                    return;
                                                }
                                                let _e1449 = triangles.member[(0u + _e1028)].i0_;
                                                let _e1450 = (_e1449 & 2147483647u);
                                                let _e1452 = triangles.member[(0u + _e1028)].i1_;
                                                let _e1454 = triangles.member[(0u + _e1028)].i2_;
                                                if (_e1450 < _e83) {
                                                } else {
                                                    return;
                                                }
                                                let _e1458 = vertices.member[(0u + _e1450)];
                                                if (_e1452 < _e83) {
                                                } else {
                                                    return;
                                                }
                                                let _e1462 = vertices.member[(0u + _e1452)];
                                                if (_e1454 < _e83) {
                                                } else {
                                                    return;
                                                }
                                                let _e1466 = vertices.member[(0u + _e1454)];
                                                let _e1467 = array<abi_Vertex, 3>(_e1458, _e1462, _e1466);
                                                if (_e1467[0].material < _e86) {
                                                } else {
                                                    return;
                                                }
                                                let _e1473 = materials.member[(0u + _e1467[0].material)];
                                                if ((_e1473.flags & 0u) == 0u) {
                                                    let _e1478 = ((1f - _e1405.u) - _e1405.v);
                                                    if (_e1473.cutoff <= 0f) {
                                                        phi_2296_ = true;
                                                    } else {
                                                        let _e1505 = (_e1473.base_color.w * ((((f32((_e1467[0].color >> bitcast<u32>(24i))) * _e1478) + (f32((_e1467[1].color >> bitcast<u32>(24i))) * _e1405.u)) + (f32((_e1467[2].color >> bitcast<u32>(24i))) * _e1405.v)) * (1f / 255f)));
                                                        if (_e1473.alpha_size == 0u) {
                                                            phi_2293_ = _e1505;
                                                        } else {
                                                            local.offset = _e1473.alpha_offset;
                                                            local.size = _e1473.alpha_size;
                                                            local.flags = _e1473.flags;
                                                            let _e1536 = _lt_shaders_texture_TextureView_quad((&local), (((_e1467[0].u * _e1478) + (_e1467[1].u * _e1405.u)) + (_e1467[2].u * _e1405.v)), (((_e1467[0].v * _e1478) + (_e1467[1].v * _e1405.u)) + (_e1467[2].v * _e1405.v)));
                                                            let _e1540 = (_e1536.indices[0] >> bitcast<u32>(2i));
                                                            if (_e1540 < _e92) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1544 = alpha_texels.member[(0u + _e1540)];
                                                            let _e1560 = (_e1536.indices[1] >> bitcast<u32>(2i));
                                                            if (_e1560 < _e92) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1564 = alpha_texels.member[(0u + _e1560)];
                                                            let _e1581 = (_e1536.indices[2] >> bitcast<u32>(2i));
                                                            if (_e1581 < _e92) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1585 = alpha_texels.member[(0u + _e1581)];
                                                            let _e1602 = (_e1536.indices[3] >> bitcast<u32>(2i));
                                                            if (_e1602 < _e92) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1606 = alpha_texels.member[(0u + _e1602)];
                                                            phi_2293_ = (_e1505 * (((((f32(((_e1544 >> bitcast<u32>((((_e1536.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1536.weights.x) + ((f32(((_e1564 >> bitcast<u32>((((_e1536.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1536.weights.y)) + ((f32(((_e1585 >> bitcast<u32>((((_e1536.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1536.weights.z)) + ((f32(((_e1606 >> bitcast<u32>((((_e1536.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1536.weights.w)));
                                                        }
                                                        let _e1622 = phi_2293_;
                                                        phi_2296_ = (_e1622 >= _e1473.cutoff);
                                                    }
                                                    let _e1626 = phi_2296_;
                                                    phi_2297_ = _e1626;
                                                } else {
                                                    phi_2297_ = false;
                                                }
                                                let _e1628 = phi_2297_;
                                                if _e1628 {
                                                }
                                                phi_2301_ = _e1628;
                                            }
                                            let _e1630 = phi_2301_;
                                            if _e1630 {
                                                phi_2309_ = lt_bvh_Hit(_e1405.t, _e1405.u, _e1405.v, _e1028, 4294967295u);
                                            } else {
                                                phi_2309_ = _e1017;
                                            }
                                            let _e1636 = phi_2309_;
                                            phi_2310_ = _e1636;
                                        } else {
                                            phi_2310_ = _e1017;
                                        }
                                        let _e1638 = phi_2310_;
                                        phi_2311_ = _e1638;
                                    } else {
                                        phi_2311_ = _e1017;
                                    }
                                    let _e1640 = phi_2311_;
                                    phi_2312_ = _e1640;
                                } else {
                                    phi_2312_ = _e1017;
                                }
                                let _e1642 = phi_2312_;
                                phi_1554_ = _e1642;
                                phi_1557_ = (_e1019 & (_e1019 - 1u));
                                phi_2313_ = true;
                            }
                            let _e1644 = phi_1554_;
                            let _e1646 = phi_1557_;
                            let _e1648 = phi_2313_;
                            continue;
                            continuing {
                                phi_1553_ = _e1644;
                                phi_1556_ = _e1646;
                                break if !(_e1648);
                            }
                        }
                        let _e1651 = local_1.group_mask;
                        if ((_e1651 & 4278190080u) == 0u) {
                            let _e1655 = local_1.len;
                            if (_e1655 == 0u) {
                                phi_2352_ = false;
                            } else {
                                let _e1659 = local_1.len;
                                local_1.len = (_e1659 - 1u);
                                let _e1662 = local_1.len;
                                if (_e1662 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1667 = local_1.first[(0u + _e1662)];
                                local_1.group = _e1667;
                                let _e1670 = local_1.len;
                                if (_e1670 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1675 = local_1.mask[(0u + _e1670)];
                                local_1.group_mask = _e1675;
                                phi_2352_ = true;
                            }
                            let _e1678 = phi_2352_;
                            phi_2353_ = _e1678;
                        } else {
                            phi_2353_ = true;
                        }
                        let _e1680 = phi_2353_;
                        if _e1680 {
                            let _e1682 = local_1.group_mask;
                            let _e1688 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1682)), 32u, (_e1682 == 0u)));
                            let _e1692 = local_1.group_mask;
                            let _e1706 = local_1.group_mask;
                            local_1.group_mask = (_e1706 & ~((1u << bitcast<u32>((_e1688 & 31u)))));
                            let _e1709 = local_1.group;
                            phi_2384_ = (_e1709 + countOneBits(((_e1692 & ~((4294967295u << bitcast<u32>((((_e1688 - 24u) ^ _e436) & 31u))))) & 255u)));
                        } else {
                            phi_2384_ = 4294967295u;
                        }
                        let _e1712 = phi_2384_;
                        let _e2485 = local_5;
                        phi_1217_ = _e2485;
                        phi_1220_ = _e1712;
                    } else {
                        phi_1217_ = lt_bvh_Hit();
                        phi_1220_ = u32();
                    }
                    let _e1714 = phi_1217_;
                    let _e1716 = phi_1220_;
                    continue;
                    continuing {
                        phi_1216_ = _e1714;
                        phi_1219_ = _e1716;
                        break if !(_e577);
                    }
                }
                let _e2489 = local_6;
                phi_2385_ = _e2489;
            }
            let _e1719 = phi_2385_;
            phi_2386_ = _e1719;
            phi_2387_ = _e231;
        } else {
            phi_2386_ = lt_bvh_Hit();
            phi_2387_ = true;
        }
        let _e1721 = phi_2386_;
        let _e1723 = phi_2387_;
        if _e1723 {
            phi_2391_ = _e161;
        } else {
            phi_2391_ = _e1721;
        }
        let _e1725 = phi_2391_;
        if (_e1725.triangle != 4294967295u) {
            let _e1731 = ((1f - _e1725.u) - _e1725.v);
            if (_e1725.triangle < _e80) {
            } else {
                return;
            }
            let _e1737 = triangles.member[(0u + _e1725.triangle)];
            let _e1762 = (((_e1737.v0_.x * _e1731) + (_e1737.v1_.x * _e1725.u)) + (_e1737.v2_.x * _e1725.v));
            let _e1763 = (((_e1737.v0_.y * _e1731) + (_e1737.v1_.y * _e1725.u)) + (_e1737.v2_.y * _e1725.v));
            let _e1764 = (((_e1737.v0_.z * _e1731) + (_e1737.v1_.z * _e1725.u)) + (_e1737.v2_.z * _e1725.v));
            let _e1767 = abs(_e1737.v0_.x);
            let _e1769 = abs(_e1737.v0_.y);
            let _e1771 = abs(_e1737.v0_.z);
            let _e1773 = abs(_e1737.v1_.x);
            let _e1775 = abs(_e1737.v1_.y);
            let _e1777 = abs(_e1737.v1_.z);
            if (_e1767 > _e1773) {
                phi_2456_ = _e1767;
            } else {
                phi_2456_ = _e1773;
            }
            let _e1780 = phi_2456_;
            if (_e1769 > _e1775) {
                phi_2461_ = _e1769;
            } else {
                phi_2461_ = _e1775;
            }
            let _e1783 = phi_2461_;
            if (_e1771 > _e1777) {
                phi_2466_ = _e1771;
            } else {
                phi_2466_ = _e1777;
            }
            let _e1786 = phi_2466_;
            let _e1788 = abs(_e1737.v2_.x);
            let _e1790 = abs(_e1737.v2_.y);
            let _e1792 = abs(_e1737.v2_.z);
            if (_e1780 > _e1788) {
                phi_2477_ = _e1780;
            } else {
                phi_2477_ = _e1788;
            }
            let _e1795 = phi_2477_;
            if (_e1783 > _e1790) {
                phi_2482_ = _e1783;
            } else {
                phi_2482_ = _e1790;
            }
            let _e1798 = phi_2482_;
            if (_e1786 > _e1792) {
                phi_2487_ = _e1786;
            } else {
                phi_2487_ = _e1792;
            }
            let _e1801 = phi_2487_;
            let _e1804 = (_e1737.v1_.x - _e1737.v0_.x);
            let _e1807 = (_e1737.v1_.y - _e1737.v0_.y);
            let _e1810 = (_e1737.v1_.z - _e1737.v0_.z);
            let _e1813 = (_e1737.v2_.x - _e1737.v0_.x);
            let _e1816 = (_e1737.v2_.y - _e1737.v0_.y);
            let _e1819 = (_e1737.v2_.z - _e1737.v0_.z);
            let _e1823 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1807), abs(_e1810));
            let _e1824 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1804), _e1823);
            let _e1825 = (_e1804 / _e1824);
            let _e1826 = (_e1807 / _e1824);
            let _e1827 = (_e1810 / _e1824);
            let _e1831 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1816), abs(_e1819));
            let _e1832 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1813), _e1831);
            let _e1833 = (_e1813 / _e1832);
            let _e1834 = (_e1816 / _e1832);
            let _e1835 = (_e1819 / _e1832);
            let _e1838 = ((_e1826 * _e1835) - (_e1834 * _e1827));
            let _e1841 = ((_e1827 * _e1833) - (_e1835 * _e1825));
            let _e1844 = ((_e1825 * _e1834) - (_e1833 * _e1826));
            let _e1846 = p.member.eye;
            let _e1859 = (1f / sqrt((((_e1838 * _e1838) + (_e1841 * _e1841)) + (_e1844 * _e1844))));
            let _e1860 = (_e1838 * _e1859);
            let _e1861 = (_e1841 * _e1859);
            let _e1862 = (_e1844 * _e1859);
            if ((((_e1860 * (_e1846.x - _e1762)) + (_e1861 * (_e1846.y - _e1763))) + (_e1862 * (_e1846.z - _e1764))) < 0f) {
                phi_2563_ = vec3<f32>(-(_e1860), -(_e1861), -(_e1862));
            } else {
                phi_2563_ = vec3<f32>(_e1860, _e1861, _e1862);
            }
            let _e1875 = phi_2563_;
            if (_e1725.triangle < _e80) {
            } else {
                return;
            }
            let _e1880 = triangles.member[(0u + _e1725.triangle)];
            let _e1882 = (_e1880.i0_ & 2147483647u);
            if (_e1882 < _e83) {
            } else {
                return;
            }
            let _e1888 = vertices.member[(0u + _e1882)];
            if (_e1880.i1_ < _e83) {
            } else {
                return;
            }
            let _e1892 = vertices.member[(0u + _e1880.i1_)];
            if (_e1880.i2_ < _e83) {
            } else {
                return;
            }
            let _e1896 = vertices.member[(0u + _e1880.i2_)];
            let _e1897 = array<abi_Vertex, 3>(_e1888, _e1892, _e1896);
            if (_e1897[0].material < _e86) {
            } else {
                return;
            }
            let _e1903 = materials.member[(0u + _e1897[0].material)];
            let _e1920 = (1f / 255f);
            let _e1939 = (1f / 255f);
            let _e1961 = (1f / 255f);
            let _e1974 = _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(vec3<f32>(_e1731, _e1725.u, _e1725.v));
            let _e1976 = ((_e1903.base_color.x * ((((f32((_e1897[0].color & 255u)) * _e1920) * _e1731) + ((f32((_e1897[1].color & 255u)) * _e1939) * _e1725.u)) + ((f32((_e1897[2].color & 255u)) * _e1961) * _e1725.v))) * _e1974.x);
            let _e1978 = ((_e1903.base_color.y * ((((f32(((_e1897[0].color >> bitcast<u32>(8i)) & 255u)) * _e1920) * _e1731) + ((f32(((_e1897[1].color >> bitcast<u32>(8i)) & 255u)) * _e1939) * _e1725.u)) + ((f32(((_e1897[2].color >> bitcast<u32>(8i)) & 255u)) * _e1961) * _e1725.v))) * _e1974.y);
            let _e1980 = ((_e1903.base_color.z * ((((f32(((_e1897[0].color >> bitcast<u32>(16i)) & 255u)) * _e1920) * _e1731) + ((f32(((_e1897[1].color >> bitcast<u32>(16i)) & 255u)) * _e1939) * _e1725.u)) + ((f32(((_e1897[2].color >> bitcast<u32>(16i)) & 255u)) * _e1961) * _e1725.v))) * _e1974.z);
            let _e1981 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1798, _e1801);
            let _e1982 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1795, _e1981);
            if ((_e1903.flags & 2u) == 0u) {
                phi_2684_ = 0u;
            } else {
                phi_2684_ = 1u;
            }
            let _e1987 = phi_2684_;
            if (_e1897[0].normal == 2147516416u) {
                phi_2887_ = _e1875;
            } else {
                let _e2000 = (f32((bitcast<i32>((_e1897[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2006 = (f32((bitcast<i32>(_e1897[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2010 = ((1f - abs(_e2000)) - abs(_e2006));
                if (_e2010 < 0f) {
                    phi_2711_ = -(_e2010);
                } else {
                    phi_2711_ = 0f;
                }
                let _e2014 = phi_2711_;
                if (_e2000 < 0f) {
                    phi_2718_ = (_e2000 + _e2014);
                } else {
                    phi_2718_ = (_e2000 - _e2014);
                }
                let _e2019 = phi_2718_;
                if (_e2006 < 0f) {
                    phi_2725_ = (_e2006 + _e2014);
                } else {
                    phi_2725_ = (_e2006 - _e2014);
                }
                let _e2024 = phi_2725_;
                let _e2031 = (1f / sqrt((((_e2019 * _e2019) + (_e2024 * _e2024)) + (_e2010 * _e2010))));
                let _e2047 = (f32((bitcast<i32>((_e1897[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2053 = (f32((bitcast<i32>(_e1897[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2057 = ((1f - abs(_e2047)) - abs(_e2053));
                if (_e2057 < 0f) {
                    phi_2760_ = -(_e2057);
                } else {
                    phi_2760_ = 0f;
                }
                let _e2061 = phi_2760_;
                if (_e2047 < 0f) {
                    phi_2767_ = (_e2047 + _e2061);
                } else {
                    phi_2767_ = (_e2047 - _e2061);
                }
                let _e2066 = phi_2767_;
                if (_e2053 < 0f) {
                    phi_2774_ = (_e2053 + _e2061);
                } else {
                    phi_2774_ = (_e2053 - _e2061);
                }
                let _e2071 = phi_2774_;
                let _e2078 = (1f / sqrt((((_e2066 * _e2066) + (_e2071 * _e2071)) + (_e2057 * _e2057))));
                let _e2097 = (f32((bitcast<i32>((_e1897[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2103 = (f32((bitcast<i32>(_e1897[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2107 = ((1f - abs(_e2097)) - abs(_e2103));
                if (_e2107 < 0f) {
                    phi_2812_ = -(_e2107);
                } else {
                    phi_2812_ = 0f;
                }
                let _e2111 = phi_2812_;
                if (_e2097 < 0f) {
                    phi_2819_ = (_e2097 + _e2111);
                } else {
                    phi_2819_ = (_e2097 - _e2111);
                }
                let _e2116 = phi_2819_;
                if (_e2103 < 0f) {
                    phi_2826_ = (_e2103 + _e2111);
                } else {
                    phi_2826_ = (_e2103 - _e2111);
                }
                let _e2121 = phi_2826_;
                let _e2128 = (1f / sqrt((((_e2116 * _e2116) + (_e2121 * _e2121)) + (_e2107 * _e2107))));
                let _e2139 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(vec3<f32>(((((_e2019 * _e2031) * _e1731) + ((_e2066 * _e2078) * _e1725.u)) + ((_e2116 * _e2128) * _e1725.v)), ((((_e2024 * _e2031) * _e1731) + ((_e2071 * _e2078) * _e1725.u)) + ((_e2121 * _e2128) * _e1725.v)), ((((_e2010 * _e2031) * _e1731) + ((_e2057 * _e2078) * _e1725.u)) + ((_e2107 * _e2128) * _e1725.v))));
                let _e2151 = sqrt((((_e2139.x * _e2139.x) + (_e2139.y * _e2139.y)) + (_e2139.z * _e2139.z)));
                if (_e2151 > 0f) {
                    let _e2154 = (_e2139.x / _e2151);
                    let _e2156 = (_e2139.y / _e2151);
                    let _e2158 = (_e2139.z / _e2151);
                    if ((((_e2154 * _e1875.x) + (_e2156 * _e1875.y)) + (_e2158 * _e1875.z)) < 0f) {
                        phi_2885_ = vec3<f32>(-(_e2154), -(_e2156), -(_e2158));
                    } else {
                        phi_2885_ = (_e2139 / vec3(_e2151));
                    }
                    let _e2175 = phi_2885_;
                    phi_2886_ = _e2175;
                } else {
                    phi_2886_ = _e1875;
                }
                let _e2177 = phi_2886_;
                phi_2887_ = _e2177;
            }
            let _e2179 = phi_2887_;
            if (_e1976 > 0f) {
                if (_e1976 < 1f) {
                    phi_2896_ = _e1976;
                } else {
                    phi_2896_ = 1f;
                }
                let _e2183 = phi_2896_;
                phi_2897_ = _e2183;
            } else {
                phi_2897_ = 0f;
            }
            let _e2185 = phi_2897_;
            if (_e1978 > 0f) {
                if (_e1978 < 1f) {
                    phi_2907_ = _e1978;
                } else {
                    phi_2907_ = 1f;
                }
                let _e2190 = phi_2907_;
                phi_2908_ = _e2190;
            } else {
                phi_2908_ = 0f;
            }
            let _e2192 = phi_2908_;
            if (_e1980 > 0f) {
                if (_e1980 < 1f) {
                    phi_2918_ = _e1980;
                } else {
                    phi_2918_ = 1f;
                }
                let _e2197 = phi_2918_;
                phi_2919_ = _e2197;
            } else {
                phi_2919_ = 0f;
            }
            let _e2199 = phi_2919_;
            let _e2202 = ((sqrt(_e2185) * 255f) + 0.5f);
            let _e2211 = ((sqrt(_e2192) * 255f) + 0.5f);
            let _e2223 = ((sqrt(_e2199) * 255f) + 0.5f);
            phi_2954_ = abi_Sample(vec3<f32>(_e1762, _e1763, _e1764), _e1982, _e1875, _e1987, _e2179, ((select(select(u32(_e2202), 0u, (_e2202 < bitcast<f32>(0u))), 4294967295u, (_e2202 > bitcast<f32>(1333788671u))) | (select(select(u32(_e2211), 0u, (_e2211 < bitcast<f32>(0u))), 4294967295u, (_e2211 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e2223), 0u, (_e2223 < bitcast<f32>(0u))), 4294967295u, (_e2223 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_2954_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e2237 = phi_2954_;
        if (_e104.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e104.first_primitive)] = _e2237;
        if (_e1725.triangle != 4294967295u) {
            let _e2246 = ((1f - _e1725.u) - _e1725.v);
            if (_e1725.triangle < _e80) {
            } else {
                return;
            }
            let _e2251 = triangles.member[(0u + _e1725.triangle)];
            let _e2253 = (_e2251.i0_ & 2147483647u);
            if (_e2253 < _e95) {
            } else {
                return;
            }
            let _e2259 = before.member[(0u + _e2253)];
            if (_e2251.i1_ < _e95) {
            } else {
                return;
            }
            let _e2263 = before.member[(0u + _e2251.i1_)];
            if (_e2251.i2_ < _e95) {
            } else {
                return;
            }
            let _e2267 = before.member[(0u + _e2251.i2_)];
            let _e2272 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2259.x, _e2259.y, _e2259.z));
            let _e2283 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2263.x, _e2263.y, _e2263.z));
            let _e2297 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2267.x, _e2267.y, _e2267.z));
            phi_3045_ = vec3<f32>((((_e2272.x * _e2246) + (_e2283.x * _e1725.u)) + (_e2297.x * _e1725.v)), (((_e2272.y * _e2246) + (_e2283.y * _e1725.u)) + (_e2297.y * _e1725.v)), (((_e2272.z * _e2246) + (_e2283.z * _e1725.u)) + (_e2297.z * _e1725.v)));
        } else {
            phi_3045_ = vec3<f32>(0f, 0f, 0f);
        }
        let _e2309 = phi_3045_;
        if (_e104.first_primitive < arrayLength((&past.member))) {
        } else {
            return;
        }
        past.member[(0u + _e104.first_primitive)] = vec4<f32>(_e2309.x, _e2309.y, _e2309.z, 1f);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_alpha_motion_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
