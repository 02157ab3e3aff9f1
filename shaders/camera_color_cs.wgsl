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

struct type_27 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_31 {
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

struct type_35 {
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

struct type_45 {
    member: abi_CameraParams,
}

struct lt_bvh_Node {
    frame: vec4<u32>,
    links: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    z: vec4<u32>,
}

struct type_50 {
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
var<storage> vertices: type_31;
@group(0) @binding(4) 
var<storage> materials: type_35;
@group(0) @binding(0) 
var<uniform> p: type_45;
@group(0) @binding(1) 
var<storage> nodes: type_50;
@group(0) @binding(2) 
var<storage> triangles: type_27;
@group(0) @binding(5) 
var<storage, read_write> samples: type_9;
@group(0) @binding(6) 
var<storage> color_texels: type_13;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_205_: lt_bvh_traverse_Tree;
    var phi_206_: bool;
    var phi_207_: lt_bvh_traverse_Tree;
    var phi_208_: bool;
    var phi_213_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_205_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_206_ = false;
        } else {
            phi_205_ = lt_bvh_traverse_Tree();
            phi_206_ = true;
        }
        let _e81 = phi_205_;
        let _e83 = phi_206_;
        phi_207_ = _e81;
        phi_208_ = _e83;
    } else {
        phi_207_ = lt_bvh_traverse_Tree();
        phi_208_ = true;
    }
    let _e85 = phi_207_;
    let _e87 = phi_208_;
    if _e87 {
        phi_213_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_213_ = _e85;
    }
    let _e92 = phi_213_;
    return lt_bvh_traverse_Tree(_e92.root, _e92.first_primitive);
}

fn _lt_shaders_texture_TextureView_quad(param_3: ptr<function, texture_TextureView>, param_4: f32, param_5: f32) -> texture_TexelQuad {
    var phi_258_: f32;
    var phi_263_: f32;
    var phi_264_: bool;
    var phi_265_: f32;
    var phi_266_: bool;
    var phi_270_: f32;
    var phi_296_: f32;
    var phi_301_: f32;
    var phi_302_: bool;
    var phi_303_: f32;
    var phi_304_: bool;
    var phi_308_: f32;
    var phi_316_: f32;
    var phi_317_: f32;
    var phi_318_: f32;
    var phi_327_: f32;
    var phi_328_: f32;
    var phi_346_: u32;
    var phi_360_: u32;
    var phi_367_: u32;
    var phi_372_: u32;
    var phi_378_: u32;
    var phi_383_: u32;
    var phi_385_: texture_Axis;
    var phi_413_: f32;
    var phi_418_: f32;
    var phi_419_: bool;
    var phi_420_: f32;
    var phi_421_: bool;
    var phi_425_: f32;
    var phi_451_: f32;
    var phi_456_: f32;
    var phi_457_: bool;
    var phi_458_: f32;
    var phi_459_: bool;
    var phi_463_: f32;
    var phi_471_: f32;
    var phi_472_: f32;
    var phi_473_: f32;
    var phi_482_: f32;
    var phi_483_: f32;
    var phi_501_: u32;
    var phi_515_: u32;
    var phi_522_: u32;
    var phi_527_: u32;
    var phi_533_: u32;
    var phi_538_: u32;
    var phi_540_: texture_Axis;

    let _e72 = (*param_3).size;
    let _e73 = (_e72 & 65535u);
    let _e75 = (*param_3).size;
    let _e77 = (_e75 >> bitcast<u32>(16i));
    let _e79 = (*param_3).flags;
    let _e81 = ((_e79 & 4u) != 0u);
    let _e83 = (*param_3).flags;
    let _e86 = ((_e83 >> bitcast<u32>(4u)) & 3u);
    if (_e86 == 0u) {
        if (param_4 > -8388608f) {
            let _e99 = f32(select(0i, select(select(i32(param_4), i32(-2147483648), (param_4 < bitcast<f32>(3472883712u))), 2147483647i, (param_4 > bitcast<f32>(1325400063u))), (param_4 == param_4)));
            if (_e99 > param_4) {
                phi_258_ = 1f;
            } else {
                phi_258_ = 0f;
            }
            let _e102 = phi_258_;
            if (param_4 < 8388608f) {
                phi_263_ = (_e99 - _e102);
                phi_264_ = false;
            } else {
                phi_263_ = f32();
                phi_264_ = true;
            }
            let _e105 = phi_263_;
            let _e107 = phi_264_;
            phi_265_ = _e105;
            phi_266_ = _e107;
        } else {
            phi_265_ = f32();
            phi_266_ = true;
        }
        let _e109 = phi_265_;
        let _e111 = phi_266_;
        if _e111 {
            phi_270_ = param_4;
        } else {
            phi_270_ = _e109;
        }
        let _e113 = phi_270_;
        phi_318_ = (param_4 - _e113);
    } else {
        if (_e86 == 1u) {
            let _e116 = (param_4 * 0.5f);
            if (_e116 > -8388608f) {
                let _e128 = f32(select(0i, select(select(i32(_e116), i32(-2147483648), (_e116 < bitcast<f32>(3472883712u))), 2147483647i, (_e116 > bitcast<f32>(1325400063u))), (_e116 == _e116)));
                if (_e128 > _e116) {
                    phi_296_ = 1f;
                } else {
                    phi_296_ = 0f;
                }
                let _e131 = phi_296_;
                if (_e116 < 8388608f) {
                    phi_301_ = (_e128 - _e131);
                    phi_302_ = false;
                } else {
                    phi_301_ = f32();
                    phi_302_ = true;
                }
                let _e134 = phi_301_;
                let _e136 = phi_302_;
                phi_303_ = _e134;
                phi_304_ = _e136;
            } else {
                phi_303_ = f32();
                phi_304_ = true;
            }
            let _e138 = phi_303_;
            let _e140 = phi_304_;
            if _e140 {
                phi_308_ = _e116;
            } else {
                phi_308_ = _e138;
            }
            let _e142 = phi_308_;
            let _e144 = (param_4 - (2f * _e142));
            if (_e144 > 1f) {
                phi_316_ = (2f - _e144);
            } else {
                phi_316_ = _e144;
            }
            let _e148 = phi_316_;
            phi_317_ = _e148;
        } else {
            phi_317_ = param_4;
        }
        let _e150 = phi_317_;
        phi_318_ = _e150;
    }
    let _e152 = phi_318_;
    if (_e152 > 0f) {
        if (_e152 < 1f) {
            phi_327_ = _e152;
        } else {
            phi_327_ = 1f;
        }
        let _e156 = phi_327_;
        phi_328_ = _e156;
    } else {
        phi_328_ = 0f;
    }
    let _e158 = phi_328_;
    let _e159 = (_e73 - 1u);
    let _e161 = (_e158 * f32(_e73));
    if _e81 {
        let _e168 = select(select(u32(_e161), 0u, (_e161 < bitcast<f32>(0u))), 4294967295u, (_e161 > bitcast<f32>(1333788671u)));
        if (_e159 < _e168) {
            phi_346_ = _e159;
        } else {
            phi_346_ = _e168;
        }
        let _e171 = phi_346_;
        phi_385_ = texture_Axis(_e171, _e171, 0f);
    } else {
        let _e173 = (_e161 + 0.5f);
        let _e180 = select(select(u32(_e173), 0u, (_e173 < bitcast<f32>(0u))), 4294967295u, (_e173 > bitcast<f32>(1333788671u)));
        if (_e73 < _e180) {
            phi_360_ = _e73;
        } else {
            phi_360_ = _e180;
        }
        let _e183 = phi_360_;
        if (_e86 == 0u) {
            phi_367_ = _e159;
        } else {
            phi_367_ = 0u;
        }
        let _e188 = phi_367_;
        if (_e86 == 0u) {
            phi_372_ = 0u;
        } else {
            phi_372_ = _e159;
        }
        let _e191 = phi_372_;
        if (_e183 == 0u) {
            phi_378_ = _e188;
        } else {
            phi_378_ = (_e183 - 1u);
        }
        let _e195 = phi_378_;
        if (_e183 > _e159) {
            phi_383_ = _e191;
        } else {
            phi_383_ = _e183;
        }
        let _e198 = phi_383_;
        phi_385_ = texture_Axis(_e195, _e198, (_e173 - f32(_e183)));
    }
    let _e201 = phi_385_;
    let _e203 = (*param_3).flags;
    let _e206 = ((_e203 >> bitcast<u32>(6u)) & 3u);
    if (_e206 == 0u) {
        if (param_5 > -8388608f) {
            let _e219 = f32(select(0i, select(select(i32(param_5), i32(-2147483648), (param_5 < bitcast<f32>(3472883712u))), 2147483647i, (param_5 > bitcast<f32>(1325400063u))), (param_5 == param_5)));
            if (_e219 > param_5) {
                phi_413_ = 1f;
            } else {
                phi_413_ = 0f;
            }
            let _e222 = phi_413_;
            if (param_5 < 8388608f) {
                phi_418_ = (_e219 - _e222);
                phi_419_ = false;
            } else {
                phi_418_ = f32();
                phi_419_ = true;
            }
            let _e225 = phi_418_;
            let _e227 = phi_419_;
            phi_420_ = _e225;
            phi_421_ = _e227;
        } else {
            phi_420_ = f32();
            phi_421_ = true;
        }
        let _e229 = phi_420_;
        let _e231 = phi_421_;
        if _e231 {
            phi_425_ = param_5;
        } else {
            phi_425_ = _e229;
        }
        let _e233 = phi_425_;
        phi_473_ = (param_5 - _e233);
    } else {
        if (_e206 == 1u) {
            let _e236 = (param_5 * 0.5f);
            if (_e236 > -8388608f) {
                let _e248 = f32(select(0i, select(select(i32(_e236), i32(-2147483648), (_e236 < bitcast<f32>(3472883712u))), 2147483647i, (_e236 > bitcast<f32>(1325400063u))), (_e236 == _e236)));
                if (_e248 > _e236) {
                    phi_451_ = 1f;
                } else {
                    phi_451_ = 0f;
                }
                let _e251 = phi_451_;
                if (_e236 < 8388608f) {
                    phi_456_ = (_e248 - _e251);
                    phi_457_ = false;
                } else {
                    phi_456_ = f32();
                    phi_457_ = true;
                }
                let _e254 = phi_456_;
                let _e256 = phi_457_;
                phi_458_ = _e254;
                phi_459_ = _e256;
            } else {
                phi_458_ = f32();
                phi_459_ = true;
            }
            let _e258 = phi_458_;
            let _e260 = phi_459_;
            if _e260 {
                phi_463_ = _e236;
            } else {
                phi_463_ = _e258;
            }
            let _e262 = phi_463_;
            let _e264 = (param_5 - (2f * _e262));
            if (_e264 > 1f) {
                phi_471_ = (2f - _e264);
            } else {
                phi_471_ = _e264;
            }
            let _e268 = phi_471_;
            phi_472_ = _e268;
        } else {
            phi_472_ = param_5;
        }
        let _e270 = phi_472_;
        phi_473_ = _e270;
    }
    let _e272 = phi_473_;
    if (_e272 > 0f) {
        if (_e272 < 1f) {
            phi_482_ = _e272;
        } else {
            phi_482_ = 1f;
        }
        let _e276 = phi_482_;
        phi_483_ = _e276;
    } else {
        phi_483_ = 0f;
    }
    let _e278 = phi_483_;
    let _e279 = (_e77 - 1u);
    let _e281 = (_e278 * f32(_e77));
    if _e81 {
        let _e288 = select(select(u32(_e281), 0u, (_e281 < bitcast<f32>(0u))), 4294967295u, (_e281 > bitcast<f32>(1333788671u)));
        if (_e279 < _e288) {
            phi_501_ = _e279;
        } else {
            phi_501_ = _e288;
        }
        let _e291 = phi_501_;
        phi_540_ = texture_Axis(_e291, _e291, 0f);
    } else {
        let _e293 = (_e281 + 0.5f);
        let _e300 = select(select(u32(_e293), 0u, (_e293 < bitcast<f32>(0u))), 4294967295u, (_e293 > bitcast<f32>(1333788671u)));
        if (_e77 < _e300) {
            phi_515_ = _e77;
        } else {
            phi_515_ = _e300;
        }
        let _e303 = phi_515_;
        if (_e206 == 0u) {
            phi_522_ = _e279;
        } else {
            phi_522_ = 0u;
        }
        let _e308 = phi_522_;
        if (_e206 == 0u) {
            phi_527_ = 0u;
        } else {
            phi_527_ = _e279;
        }
        let _e311 = phi_527_;
        if (_e303 == 0u) {
            phi_533_ = _e308;
        } else {
            phi_533_ = (_e303 - 1u);
        }
        let _e315 = phi_533_;
        if (_e303 > _e279) {
            phi_538_ = _e311;
        } else {
            phi_538_ = _e303;
        }
        let _e318 = phi_538_;
        phi_540_ = texture_Axis(_e315, _e318, (_e293 - f32(_e303)));
    }
    let _e321 = phi_540_;
    let _e325 = (*param_3).offset;
    let _e332 = (*param_3).offset;
    let _e339 = (*param_3).offset;
    let _e346 = (*param_3).offset;
    return texture_TexelQuad(array<u32, 4>(((_e325 + (_e321.low * _e73)) + _e201.low), ((_e332 + (_e321.low * _e73)) + _e201.high), ((_e339 + (_e321.high * _e73)) + _e201.low), ((_e346 + (_e321.high * _e73)) + _e201.high)), vec4<f32>(((1f - _e201.fraction) * (1f - _e321.fraction)), (_e201.fraction * (1f - _e321.fraction)), ((1f - _e201.fraction) * _e321.fraction), (_e201.fraction * _e321.fraction)));
}

fn _lt_bvh_ray_Ray_new(param_6: vec3<f32>, param_7: vec3<f32>) -> lt_bvh_Ray {
    return lt_bvh_Ray(param_6, 0f, param_7, 300000000000000000000000000000000000000f);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_8: f32, param_9: f32) -> f32 {
    var phi_603_: bool;
    var phi_607_: f32;

    if (param_8 != param_8) {
        phi_603_ = true;
    } else {
        let _e71 = (param_9 >= param_8);
        if _e71 {
        }
        phi_603_ = _e71;
    }
    let _e73 = phi_603_;
    if _e73 {
        phi_607_ = param_9;
    } else {
        phi_607_ = param_8;
    }
    let _e75 = phi_607_;
    return _e75;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_10: f32, param_11: f32) -> f32 {
    var phi_619_: bool;
    var phi_623_: f32;

    if (param_10 != param_10) {
        phi_619_ = true;
    } else {
        let _e71 = (param_11 <= param_10);
        if _e71 {
        }
        phi_619_ = _e71;
    }
    let _e73 = phi_619_;
    if _e73 {
        phi_623_ = param_11;
    } else {
        phi_623_ = param_10;
    }
    let _e75 = phi_623_;
    return _e75;
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
    var phi_1604_: vec3<f32>;
    var phi_1605_: vec3<f32>;
    var phi_1638_: vec3<f32>;
    var phi_1639_: vec3<f32>;
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
    var phi_1812_: f32;
    var phi_1821_: f32;
    var phi_1830_: f32;
    var phi_1839_: f32;
    var phi_1846_: f32;
    var phi_1853_: f32;
    var phi_1866_: f32;
    var phi_1875_: f32;
    var phi_1884_: f32;
    var phi_1893_: f32;
    var phi_1900_: f32;
    var phi_1907_: f32;
    var phi_1930_: f32;
    var phi_1935_: f32;
    var phi_1940_: f32;
    var phi_1948_: f32;
    var phi_1953_: f32;
    var phi_1958_: f32;
    var phi_1970_: f32;
    var phi_1975_: f32;
    var phi_1980_: f32;
    var phi_1985_: f32;
    var phi_1990_: lt_bvh_triangle_Intersection;
    var phi_1991_: bool;
    var phi_1992_: lt_bvh_triangle_Intersection;
    var phi_1993_: bool;
    var phi_1997_: lt_bvh_triangle_Intersection;
    var phi_1998_: bool;
    var phi_1999_: lt_bvh_triangle_Intersection;
    var phi_2000_: bool;
    var phi_2001_: bool;
    var phi_2005_: bool;
    var phi_2009_: lt_bvh_triangle_Intersection;
    var phi_2048_: bool;
    var phi_2049_: bool;
    var phi_2050_: bool;
    var phi_2051_: bool;
    var phi_2052_: bool;
    var phi_2053_: bool;
    var phi_2057_: bool;
    var phi_2058_: bool;
    var phi_2072_: bool;
    var phi_2080_: lt_bvh_Hit;
    var phi_2081_: lt_bvh_Hit;
    var phi_2082_: lt_bvh_Hit;
    var phi_2083_: lt_bvh_Hit;
    var phi_1522_: lt_bvh_Hit;
    var phi_1525_: u32;
    var phi_2084_: bool;
    var phi_2123_: bool;
    var phi_2124_: bool;
    var phi_2155_: u32;
    var phi_1185_: lt_bvh_Hit;
    var phi_1188_: u32;
    var phi_2156_: lt_bvh_Hit;
    var phi_2157_: lt_bvh_Hit;
    var phi_2158_: bool;
    var phi_2162_: lt_bvh_Hit;
    var phi_2226_: f32;
    var phi_2231_: f32;
    var phi_2236_: f32;
    var phi_2247_: f32;
    var phi_2252_: f32;
    var phi_2257_: f32;
    var phi_2333_: vec3<f32>;
    var phi_2576_: vec3<f32>;
    var phi_2591_: u32;
    var phi_2618_: f32;
    var phi_2625_: f32;
    var phi_2632_: f32;
    var phi_2667_: f32;
    var phi_2674_: f32;
    var phi_2681_: f32;
    var phi_2719_: f32;
    var phi_2726_: f32;
    var phi_2733_: f32;
    var phi_2792_: vec3<f32>;
    var phi_2793_: vec3<f32>;
    var phi_2794_: vec3<f32>;
    var phi_2803_: f32;
    var phi_2804_: f32;
    var phi_2814_: f32;
    var phi_2815_: f32;
    var phi_2825_: f32;
    var phi_2826_: f32;
    var phi_2861_: abi_Sample;
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
    if (bitcast<i32>(_e95.root) != 0i) {
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
                phi_2156_ = lt_bvh_Hit();
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
                let _e416 = (1f / _e407.z);
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
                            let _e643 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e632.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e649 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e643.unnamed.root, _e632.w), _e643.unnamed_1);
                            let _e655 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e649.unnamed, lt_bvh_traverse_Tree(_e632.x, _e649.unnamed_1.first_primitive));
                            phi_1272_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e655.unnamed, lt_bvh_traverse_Tree(_e655.unnamed_1.root, _e632.y));
                        } else {
                            let _e671 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e632.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e677 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e671.unnamed.root, _e632.y), _e671.unnamed_1);
                            let _e683 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e677.unnamed, lt_bvh_traverse_Tree(_e632.z, _e677.unnamed_1.first_primitive));
                            phi_1272_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e683.unnamed, lt_bvh_traverse_Tree(_e683.unnamed_1.root, _e632.w));
                        }
                        let _e691 = phi_1272_;
                        let _e701 = nodes.member[(0u + _e567)].y;
                        if (_e316 < 0f) {
                            let _e712 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e701.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e718 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e712.unnamed.root, _e701.w), _e712.unnamed_1);
                            let _e724 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e718.unnamed, lt_bvh_traverse_Tree(_e701.x, _e718.unnamed_1.first_primitive));
                            phi_1299_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e724.unnamed, lt_bvh_traverse_Tree(_e724.unnamed_1.root, _e701.y));
                        } else {
                            let _e740 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e701.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e746 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e740.unnamed.root, _e701.y), _e740.unnamed_1);
                            let _e752 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e746.unnamed, lt_bvh_traverse_Tree(_e701.z, _e746.unnamed_1.first_primitive));
                            phi_1299_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e752.unnamed, lt_bvh_traverse_Tree(_e752.unnamed_1.root, _e701.w));
                        }
                        let _e760 = phi_1299_;
                        let _e770 = nodes.member[(0u + _e567)].z;
                        if (_e328 < 0f) {
                            let _e781 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e770.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e787 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e781.unnamed.root, _e770.w), _e781.unnamed_1);
                            let _e793 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e787.unnamed, lt_bvh_traverse_Tree(_e770.x, _e787.unnamed_1.first_primitive));
                            phi_1326_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e793.unnamed, lt_bvh_traverse_Tree(_e793.unnamed_1.root, _e770.y));
                        } else {
                            let _e809 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e770.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e815 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e809.unnamed.root, _e770.y), _e809.unnamed_1);
                            let _e821 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e815.unnamed, lt_bvh_traverse_Tree(_e770.z, _e815.unnamed_1.first_primitive));
                            phi_1326_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e821.unnamed, lt_bvh_traverse_Tree(_e821.unnamed_1.root, _e770.w));
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
                                    phi_1349_ = _e691.unnamed.root;
                                } else {
                                    phi_1349_ = _e691.unnamed.first_primitive;
                                }
                                let _e848 = phi_1349_;
                                if (_e844 == 0u) {
                                    phi_1359_ = _e760.unnamed.root;
                                } else {
                                    phi_1359_ = _e760.unnamed.first_primitive;
                                }
                                let _e857 = phi_1359_;
                                if (_e844 == 0u) {
                                    phi_1369_ = _e829.unnamed.root;
                                } else {
                                    phi_1369_ = _e829.unnamed.first_primitive;
                                }
                                let _e866 = phi_1369_;
                                let _e879 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e848 >> bitcast<u32>(((_e845 * 8u) & 31u))) & 255u)) * _e601) + (_e622 - _e365)), ((f32(((_e857 >> bitcast<u32>(((_e845 * 8u) & 31u))) & 255u)) * _e602) + (_e623 - _e366)));
                                let _e880 = core_intrinsics_maximum_number_nsz_f32_(_e879, ((f32(((_e866 >> bitcast<u32>(((_e845 * 8u) & 31u))) & 255u)) * _e603) + (_e624 - _e367)));
                                if (_e844 == 0u) {
                                    phi_1387_ = _e691.unnamed_1.root;
                                } else {
                                    phi_1387_ = _e691.unnamed_1.first_primitive;
                                }
                                let _e883 = phi_1387_;
                                if (_e844 == 0u) {
                                    phi_1397_ = _e760.unnamed_1.root;
                                } else {
                                    phi_1397_ = _e760.unnamed_1.first_primitive;
                                }
                                let _e892 = phi_1397_;
                                if (_e844 == 0u) {
                                    phi_1407_ = _e829.unnamed_1.root;
                                } else {
                                    phi_1407_ = _e829.unnamed_1.first_primitive;
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
                                phi_2084_ = false;
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
                                let _e1056 = triangles.member[(0u + _e1019)].v1_;
                                let _e1059 = (_e1056.x - _e150.origin.x);
                                let _e1062 = (_e1056.y - _e150.origin.y);
                                let _e1065 = (_e1056.z - _e150.origin.z);
                                if (_e392 == 0u) {
                                    phi_1605_ = vec3<f32>(_e1062, _e1065, _e1059);
                                } else {
                                    if (_e392 == 1u) {
                                        phi_1604_ = vec3<f32>(_e1065, _e1059, _e1062);
                                    } else {
                                        phi_1604_ = (_e1056 - _e150.origin);
                                    }
                                    let _e1072 = phi_1604_;
                                    phi_1605_ = _e1072;
                                }
                                let _e1074 = phi_1605_;
                                let _e1078 = (_e1074.x - (_e411 * _e1074.z));
                                let _e1082 = (_e1074.y - (_e414 * _e1074.z));
                                let _e1086 = triangles.member[(0u + _e1019)].v2_;
                                let _e1089 = (_e1086.x - _e150.origin.x);
                                let _e1092 = (_e1086.y - _e150.origin.y);
                                let _e1095 = (_e1086.z - _e150.origin.z);
                                if (_e392 == 0u) {
                                    phi_1639_ = vec3<f32>(_e1092, _e1095, _e1089);
                                } else {
                                    if (_e392 == 1u) {
                                        phi_1638_ = vec3<f32>(_e1095, _e1089, _e1092);
                                    } else {
                                        phi_1638_ = (_e1086 - _e150.origin);
                                    }
                                    let _e1102 = phi_1638_;
                                    phi_1639_ = _e1102;
                                }
                                let _e1104 = phi_1639_;
                                let _e1108 = (_e1104.x - (_e411 * _e1104.z));
                                let _e1112 = (_e1104.y - (_e414 * _e1104.z));
                                if (_e1078 < _e1108) {
                                    phi_1660_ = true;
                                } else {
                                    if (_e1078 == _e1108) {
                                        phi_1659_ = (_e1082 < _e1112);
                                    } else {
                                        phi_1659_ = false;
                                    }
                                    let _e1119 = phi_1659_;
                                    phi_1660_ = _e1119;
                                }
                                let _e1121 = phi_1660_;
                                if _e1121 {
                                    phi_1664_ = _e1112;
                                    phi_1665_ = _e1108;
                                    phi_1666_ = _e1082;
                                    phi_1667_ = _e1078;
                                } else {
                                    phi_1664_ = _e1082;
                                    phi_1665_ = _e1078;
                                    phi_1666_ = _e1112;
                                    phi_1667_ = _e1108;
                                }
                                let _e1123 = phi_1664_;
                                let _e1125 = phi_1665_;
                                let _e1127 = phi_1666_;
                                let _e1129 = phi_1667_;
                                let _e1132 = ((_e1129 * _e1123) - (_e1127 * _e1125));
                                if _e1121 {
                                    phi_1675_ = -(_e1132);
                                } else {
                                    phi_1675_ = _e1132;
                                }
                                let _e1135 = phi_1675_;
                                if (_e1108 < _e1048) {
                                    phi_1686_ = true;
                                } else {
                                    if (_e1108 == _e1048) {
                                        phi_1685_ = (_e1112 < _e1052);
                                    } else {
                                        phi_1685_ = false;
                                    }
                                    let _e1140 = phi_1685_;
                                    phi_1686_ = _e1140;
                                }
                                let _e1142 = phi_1686_;
                                if _e1142 {
                                    phi_1690_ = _e1052;
                                    phi_1691_ = _e1048;
                                    phi_1692_ = _e1112;
                                    phi_1693_ = _e1108;
                                } else {
                                    phi_1690_ = _e1112;
                                    phi_1691_ = _e1108;
                                    phi_1692_ = _e1052;
                                    phi_1693_ = _e1048;
                                }
                                let _e1144 = phi_1690_;
                                let _e1146 = phi_1691_;
                                let _e1148 = phi_1692_;
                                let _e1150 = phi_1693_;
                                let _e1153 = ((_e1150 * _e1144) - (_e1148 * _e1146));
                                if _e1142 {
                                    phi_1701_ = -(_e1153);
                                } else {
                                    phi_1701_ = _e1153;
                                }
                                let _e1156 = phi_1701_;
                                if (_e1048 < _e1078) {
                                    phi_1712_ = true;
                                } else {
                                    if (_e1048 == _e1078) {
                                        phi_1711_ = (_e1052 < _e1082);
                                    } else {
                                        phi_1711_ = false;
                                    }
                                    let _e1161 = phi_1711_;
                                    phi_1712_ = _e1161;
                                }
                                let _e1163 = phi_1712_;
                                if _e1163 {
                                    phi_1716_ = _e1082;
                                    phi_1717_ = _e1078;
                                    phi_1718_ = _e1052;
                                    phi_1719_ = _e1048;
                                } else {
                                    phi_1716_ = _e1052;
                                    phi_1717_ = _e1048;
                                    phi_1718_ = _e1082;
                                    phi_1719_ = _e1078;
                                }
                                let _e1165 = phi_1716_;
                                let _e1167 = phi_1717_;
                                let _e1169 = phi_1718_;
                                let _e1171 = phi_1719_;
                                let _e1174 = ((_e1171 * _e1165) - (_e1169 * _e1167));
                                if _e1163 {
                                    phi_1727_ = -(_e1174);
                                } else {
                                    phi_1727_ = _e1174;
                                }
                                let _e1177 = phi_1727_;
                                if (_e1135 >= 0f) {
                                    if (_e1156 >= 0f) {
                                        if (_e1177 >= 0f) {
                                            phi_1742_ = ((_e1135 + _e1156) + _e1177);
                                            phi_1743_ = false;
                                        } else {
                                            phi_1742_ = f32();
                                            phi_1743_ = true;
                                        }
                                        let _e1184 = phi_1742_;
                                        let _e1186 = phi_1743_;
                                        phi_1744_ = _e1184;
                                        phi_1745_ = _e1186;
                                    } else {
                                        phi_1744_ = f32();
                                        phi_1745_ = true;
                                    }
                                    let _e1188 = phi_1744_;
                                    let _e1190 = phi_1745_;
                                    phi_1746_ = _e1188;
                                    phi_1747_ = _e1190;
                                } else {
                                    phi_1746_ = f32();
                                    phi_1747_ = true;
                                }
                                let _e1192 = phi_1746_;
                                let _e1194 = phi_1747_;
                                if _e1194 {
                                    if (_e1135 <= 0f) {
                                        if (_e1156 <= 0f) {
                                            let _e1197 = (_e1177 <= 0f);
                                            if _e1197 {
                                            }
                                            phi_1765_ = ((_e1135 + _e1156) + _e1177);
                                            phi_1766_ = false;
                                            phi_1767_ = _e1197;
                                        } else {
                                            phi_1765_ = f32();
                                            phi_1766_ = true;
                                            phi_1767_ = false;
                                        }
                                        let _e1201 = phi_1765_;
                                        let _e1203 = phi_1766_;
                                        let _e1205 = phi_1767_;
                                        phi_1768_ = _e1201;
                                        phi_1769_ = _e1203;
                                        phi_1770_ = _e1205;
                                    } else {
                                        phi_1768_ = f32();
                                        phi_1769_ = true;
                                        phi_1770_ = false;
                                    }
                                    let _e1207 = phi_1768_;
                                    let _e1209 = phi_1769_;
                                    let _e1211 = phi_1770_;
                                    if _e1209 {
                                        phi_1774_ = false;
                                    } else {
                                        phi_1774_ = _e1211;
                                    }
                                    let _e1213 = phi_1774_;
                                    phi_1775_ = _e1207;
                                    phi_1776_ = _e1213;
                                } else {
                                    phi_1775_ = _e1192;
                                    phi_1776_ = true;
                                }
                                let _e1215 = phi_1775_;
                                let _e1217 = phi_1776_;
                                if _e1217 {
                                    let _e1218 = (_e1215 == 0f);
                                    if _e1218 {
                                        phi_1997_ = lt_bvh_triangle_Intersection();
                                        phi_1998_ = false;
                                    } else {
                                        let _e1224 = ((((_e1135 * (_e416 * _e1044.z)) + (_e1156 * (_e416 * _e1074.z))) + (_e1177 * (_e416 * _e1104.z))) / _e1215);
                                        if (_e1224 > _e150.tmin) {
                                            if (_e1224 < _e150.tmax) {
                                                let _e1230 = triangles.member[(0u + _e1019)].v0_;
                                                let _e1232 = triangles.member[(0u + _e1019)].v1_;
                                                if (_e1230.x < _e1232.x) {
                                                    phi_1812_ = _e1230.x;
                                                } else {
                                                    phi_1812_ = _e1232.x;
                                                }
                                                let _e1239 = phi_1812_;
                                                if (_e1230.y < _e1232.y) {
                                                    phi_1821_ = _e1230.y;
                                                } else {
                                                    phi_1821_ = _e1232.y;
                                                }
                                                let _e1246 = phi_1821_;
                                                if (_e1230.z < _e1232.z) {
                                                    phi_1830_ = _e1230.z;
                                                } else {
                                                    phi_1830_ = _e1232.z;
                                                }
                                                let _e1253 = phi_1830_;
                                                let _e1255 = triangles.member[(0u + _e1019)].v2_;
                                                if (_e1239 < _e1255.x) {
                                                    phi_1839_ = _e1239;
                                                } else {
                                                    phi_1839_ = _e1255.x;
                                                }
                                                let _e1260 = phi_1839_;
                                                if (_e1246 < _e1255.y) {
                                                    phi_1846_ = _e1246;
                                                } else {
                                                    phi_1846_ = _e1255.y;
                                                }
                                                let _e1265 = phi_1846_;
                                                if (_e1253 < _e1255.z) {
                                                    phi_1853_ = _e1253;
                                                } else {
                                                    phi_1853_ = _e1255.z;
                                                }
                                                let _e1270 = phi_1853_;
                                                let _e1272 = triangles.member[(0u + _e1019)].v0_;
                                                let _e1274 = triangles.member[(0u + _e1019)].v1_;
                                                if (_e1272.x > _e1274.x) {
                                                    phi_1866_ = _e1272.x;
                                                } else {
                                                    phi_1866_ = _e1274.x;
                                                }
                                                let _e1281 = phi_1866_;
                                                if (_e1272.y > _e1274.y) {
                                                    phi_1875_ = _e1272.y;
                                                } else {
                                                    phi_1875_ = _e1274.y;
                                                }
                                                let _e1288 = phi_1875_;
                                                if (_e1272.z > _e1274.z) {
                                                    phi_1884_ = _e1272.z;
                                                } else {
                                                    phi_1884_ = _e1274.z;
                                                }
                                                let _e1295 = phi_1884_;
                                                let _e1297 = triangles.member[(0u + _e1019)].v2_;
                                                if (_e1281 > _e1297.x) {
                                                    phi_1893_ = _e1281;
                                                } else {
                                                    phi_1893_ = _e1297.x;
                                                }
                                                let _e1302 = phi_1893_;
                                                if (_e1288 > _e1297.y) {
                                                    phi_1900_ = _e1288;
                                                } else {
                                                    phi_1900_ = _e1297.y;
                                                }
                                                let _e1307 = phi_1900_;
                                                if (_e1295 > _e1297.z) {
                                                    phi_1907_ = _e1295;
                                                } else {
                                                    phi_1907_ = _e1297.z;
                                                }
                                                let _e1312 = phi_1907_;
                                                let _e1319 = ((_e1260 - _e150.origin.x) * _e304);
                                                let _e1320 = ((_e1265 - _e150.origin.y) * _e316);
                                                let _e1321 = ((_e1270 - _e150.origin.z) * _e328);
                                                let _e1328 = ((_e1302 - _e150.origin.x) * _e304);
                                                let _e1329 = ((_e1307 - _e150.origin.y) * _e316);
                                                let _e1330 = ((_e1312 - _e150.origin.z) * _e328);
                                                if (_e1319 < _e1328) {
                                                    phi_1930_ = _e1319;
                                                } else {
                                                    phi_1930_ = _e1328;
                                                }
                                                let _e1333 = phi_1930_;
                                                if (_e1320 < _e1329) {
                                                    phi_1935_ = _e1320;
                                                } else {
                                                    phi_1935_ = _e1329;
                                                }
                                                let _e1336 = phi_1935_;
                                                if (_e1321 < _e1330) {
                                                    phi_1940_ = _e1321;
                                                } else {
                                                    phi_1940_ = _e1330;
                                                }
                                                let _e1339 = phi_1940_;
                                                if (_e1319 > _e1328) {
                                                    phi_1948_ = _e1319;
                                                } else {
                                                    phi_1948_ = _e1328;
                                                }
                                                let _e1345 = phi_1948_;
                                                if (_e1320 > _e1329) {
                                                    phi_1953_ = _e1320;
                                                } else {
                                                    phi_1953_ = _e1329;
                                                }
                                                let _e1348 = phi_1953_;
                                                if (_e1321 > _e1330) {
                                                    phi_1958_ = _e1321;
                                                } else {
                                                    phi_1958_ = _e1330;
                                                }
                                                let _e1351 = phi_1958_;
                                                let _e1355 = core_intrinsics_maximum_number_nsz_f32_((_e1333 - _e372), (_e1336 - _e373));
                                                let _e1356 = core_intrinsics_maximum_number_nsz_f32_(_e1355, (_e1339 - _e374));
                                                let _e1357 = core_intrinsics_minimum_number_nsz_f32_((_e1345 + _e372), (_e1348 + _e373));
                                                let _e1358 = core_intrinsics_minimum_number_nsz_f32_(_e1357, (_e1351 + _e374));
                                                if (_e1356 > -300000000000000000000000000000000000000f) {
                                                    phi_1970_ = _e1356;
                                                } else {
                                                    phi_1970_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1361 = phi_1970_;
                                                if (_e1358 < 300000000000000000000000000000000000000f) {
                                                    phi_1975_ = _e1358;
                                                } else {
                                                    phi_1975_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1364 = phi_1975_;
                                                if (_e1224 < _e1361) {
                                                    phi_1980_ = _e1361;
                                                } else {
                                                    phi_1980_ = _e1224;
                                                }
                                                let _e1367 = phi_1980_;
                                                if (_e1367 > _e1364) {
                                                    phi_1985_ = _e1364;
                                                } else {
                                                    phi_1985_ = _e1367;
                                                }
                                                let _e1370 = phi_1985_;
                                                phi_1990_ = lt_bvh_triangle_Intersection(_e1370, (_e1156 / _e1215), (_e1177 / _e1215), (_e1361 <= _e1364));
                                                phi_1991_ = false;
                                            } else {
                                                phi_1990_ = lt_bvh_triangle_Intersection();
                                                phi_1991_ = true;
                                            }
                                            let _e1376 = phi_1990_;
                                            let _e1378 = phi_1991_;
                                            phi_1992_ = _e1376;
                                            phi_1993_ = _e1378;
                                        } else {
                                            phi_1992_ = lt_bvh_triangle_Intersection();
                                            phi_1993_ = true;
                                        }
                                        let _e1380 = phi_1992_;
                                        let _e1382 = phi_1993_;
                                        if _e1382 {
                                        }
                                        phi_1997_ = _e1380;
                                        phi_1998_ = _e1382;
                                    }
                                    let _e1384 = phi_1997_;
                                    let _e1386 = phi_1998_;
                                    phi_1999_ = _e1384;
                                    phi_2000_ = _e1218;
                                    phi_2001_ = _e1386;
                                } else {
                                    phi_1999_ = lt_bvh_triangle_Intersection();
                                    phi_2000_ = true;
                                    phi_2001_ = false;
                                }
                                let _e1388 = phi_1999_;
                                let _e1390 = phi_2000_;
                                let _e1392 = phi_2001_;
                                if _e1390 {
                                    phi_2005_ = true;
                                } else {
                                    phi_2005_ = _e1392;
                                }
                                let _e1394 = phi_2005_;
                                if _e1394 {
                                    phi_2009_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_2009_ = _e1388;
                                }
                                let _e1396 = phi_2009_;
                                if _e1396.is_hit {
                                    if (_e1396.t > _e150.tmin) {
                                        if (_e1396.t < _e1008.t) {
                                            phi_2058_ = true;
                                        } else {
                                            if (_e1396.t == _e1008.t) {
                                                if (_e1008.triangle != 4294967295u) {
                                                    if (_e1019 < _e1008.triangle) {
                                                        phi_2049_ = true;
                                                    } else {
                                                        if (_e1019 == _e1008.triangle) {
                                                            phi_2048_ = (4294967295u < _e1008.instance);
                                                        } else {
                                                            phi_2048_ = false;
                                                        }
                                                        let _e1415 = phi_2048_;
                                                        phi_2049_ = _e1415;
                                                    }
                                                    let _e1417 = phi_2049_;
                                                    phi_2050_ = _e1417;
                                                    phi_2051_ = false;
                                                } else {
                                                    phi_2050_ = bool();
                                                    phi_2051_ = true;
                                                }
                                                let _e1419 = phi_2050_;
                                                let _e1421 = phi_2051_;
                                                phi_2052_ = _e1419;
                                                phi_2053_ = _e1421;
                                            } else {
                                                phi_2052_ = bool();
                                                phi_2053_ = true;
                                            }
                                            let _e1423 = phi_2052_;
                                            let _e1425 = phi_2053_;
                                            if _e1425 {
                                                phi_2057_ = false;
                                            } else {
                                                phi_2057_ = _e1423;
                                            }
                                            let _e1427 = phi_2057_;
                                            phi_2058_ = _e1427;
                                        }
                                        let _e1429 = phi_2058_;
                                        if _e1429 {
                                            let _e1431 = triangles.member[(0u + _e1019)].i0_;
                                            if ((_e1431 & 2147483648u) == 0u) {
                                                phi_2072_ = true;
                                            } else {
                                                if true {
                                                }
                                                phi_2072_ = true;
                                            }
                                            let _e1435 = phi_2072_;
                                            if _e1435 {
                                                phi_2080_ = lt_bvh_Hit(_e1396.t, _e1396.u, _e1396.v, _e1019, 4294967295u);
                                            } else {
                                                phi_2080_ = _e1008;
                                            }
                                            let _e1441 = phi_2080_;
                                            phi_2081_ = _e1441;
                                        } else {
                                            phi_2081_ = _e1008;
                                        }
                                        let _e1443 = phi_2081_;
                                        phi_2082_ = _e1443;
                                    } else {
                                        phi_2082_ = _e1008;
                                    }
                                    let _e1445 = phi_2082_;
                                    phi_2083_ = _e1445;
                                } else {
                                    phi_2083_ = _e1008;
                                }
                                let _e1447 = phi_2083_;
                                phi_1522_ = _e1447;
                                phi_1525_ = (_e1010 & (_e1010 - 1u));
                                phi_2084_ = true;
                            }
                            let _e1449 = phi_1522_;
                            let _e1451 = phi_1525_;
                            let _e1453 = phi_2084_;
                            continue;
                            continuing {
                                phi_1521_ = _e1449;
                                phi_1524_ = _e1451;
                                break if !(_e1453);
                            }
                        }
                        let _e1456 = local_1.group_mask;
                        if ((_e1456 & 4278190080u) == 0u) {
                            let _e1460 = local_1.len;
                            if (_e1460 == 0u) {
                                phi_2123_ = false;
                            } else {
                                let _e1464 = local_1.len;
                                local_1.len = (_e1464 - 1u);
                                let _e1467 = local_1.len;
                                if (_e1467 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1472 = local_1.first[(0u + _e1467)];
                                local_1.group = _e1472;
                                let _e1475 = local_1.len;
                                if (_e1475 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1480 = local_1.mask[(0u + _e1475)];
                                local_1.group_mask = _e1480;
                                phi_2123_ = true;
                            }
                            let _e1483 = phi_2123_;
                            phi_2124_ = _e1483;
                        } else {
                            phi_2124_ = true;
                        }
                        let _e1485 = phi_2124_;
                        if _e1485 {
                            let _e1487 = local_1.group_mask;
                            let _e1493 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1487)), 32u, (_e1487 == 0u)));
                            let _e1497 = local_1.group_mask;
                            let _e1511 = local_1.group_mask;
                            local_1.group_mask = (_e1511 & ~((1u << bitcast<u32>((_e1493 & 31u)))));
                            let _e1514 = local_1.group;
                            phi_2155_ = (_e1514 + countOneBits(((_e1497 & ~((4294967295u << bitcast<u32>((((_e1493 - 24u) ^ _e427) & 31u))))) & 255u)));
                        } else {
                            phi_2155_ = 4294967295u;
                        }
                        let _e1517 = phi_2155_;
                        let _e2355 = local_5;
                        phi_1185_ = _e2355;
                        phi_1188_ = _e1517;
                    } else {
                        phi_1185_ = lt_bvh_Hit();
                        phi_1188_ = u32();
                    }
                    let _e1519 = phi_1185_;
                    let _e1521 = phi_1188_;
                    continue;
                    continuing {
                        phi_1184_ = _e1519;
                        phi_1187_ = _e1521;
                        break if !(_e568);
                    }
                }
                let _e2359 = local_6;
                phi_2156_ = _e2359;
            }
            let _e1524 = phi_2156_;
            phi_2157_ = _e1524;
            phi_2158_ = _e222;
        } else {
            phi_2157_ = lt_bvh_Hit();
            phi_2158_ = true;
        }
        let _e1526 = phi_2157_;
        let _e1528 = phi_2158_;
        if _e1528 {
            phi_2162_ = _e152;
        } else {
            phi_2162_ = _e1526;
        }
        let _e1530 = phi_2162_;
        if (_e1530.triangle != 4294967295u) {
            let _e1536 = ((1f - _e1530.u) - _e1530.v);
            if (_e1530.triangle < _e77) {
            } else {
                return;
            }
            let _e1541 = triangles.member[(0u + _e1530.triangle)];
            let _e1566 = (((_e1541.v0_.x * _e1536) + (_e1541.v1_.x * _e1530.u)) + (_e1541.v2_.x * _e1530.v));
            let _e1567 = (((_e1541.v0_.y * _e1536) + (_e1541.v1_.y * _e1530.u)) + (_e1541.v2_.y * _e1530.v));
            let _e1568 = (((_e1541.v0_.z * _e1536) + (_e1541.v1_.z * _e1530.u)) + (_e1541.v2_.z * _e1530.v));
            let _e1571 = abs(_e1541.v0_.x);
            let _e1573 = abs(_e1541.v0_.y);
            let _e1575 = abs(_e1541.v0_.z);
            let _e1577 = abs(_e1541.v1_.x);
            let _e1579 = abs(_e1541.v1_.y);
            let _e1581 = abs(_e1541.v1_.z);
            if (_e1571 > _e1577) {
                phi_2226_ = _e1571;
            } else {
                phi_2226_ = _e1577;
            }
            let _e1584 = phi_2226_;
            if (_e1573 > _e1579) {
                phi_2231_ = _e1573;
            } else {
                phi_2231_ = _e1579;
            }
            let _e1587 = phi_2231_;
            if (_e1575 > _e1581) {
                phi_2236_ = _e1575;
            } else {
                phi_2236_ = _e1581;
            }
            let _e1590 = phi_2236_;
            let _e1592 = abs(_e1541.v2_.x);
            let _e1594 = abs(_e1541.v2_.y);
            let _e1596 = abs(_e1541.v2_.z);
            if (_e1584 > _e1592) {
                phi_2247_ = _e1584;
            } else {
                phi_2247_ = _e1592;
            }
            let _e1599 = phi_2247_;
            if (_e1587 > _e1594) {
                phi_2252_ = _e1587;
            } else {
                phi_2252_ = _e1594;
            }
            let _e1602 = phi_2252_;
            if (_e1590 > _e1596) {
                phi_2257_ = _e1590;
            } else {
                phi_2257_ = _e1596;
            }
            let _e1605 = phi_2257_;
            let _e1608 = (_e1541.v1_.x - _e1541.v0_.x);
            let _e1611 = (_e1541.v1_.y - _e1541.v0_.y);
            let _e1614 = (_e1541.v1_.z - _e1541.v0_.z);
            let _e1617 = (_e1541.v2_.x - _e1541.v0_.x);
            let _e1620 = (_e1541.v2_.y - _e1541.v0_.y);
            let _e1623 = (_e1541.v2_.z - _e1541.v0_.z);
            let _e1627 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1611), abs(_e1614));
            let _e1628 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1608), _e1627);
            let _e1629 = (_e1608 / _e1628);
            let _e1630 = (_e1611 / _e1628);
            let _e1631 = (_e1614 / _e1628);
            let _e1635 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1620), abs(_e1623));
            let _e1636 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1617), _e1635);
            let _e1637 = (_e1617 / _e1636);
            let _e1638 = (_e1620 / _e1636);
            let _e1639 = (_e1623 / _e1636);
            let _e1642 = ((_e1630 * _e1639) - (_e1638 * _e1631));
            let _e1645 = ((_e1631 * _e1637) - (_e1639 * _e1629));
            let _e1648 = ((_e1629 * _e1638) - (_e1637 * _e1630));
            let _e1650 = p.member.eye;
            let _e1663 = (1f / sqrt((((_e1642 * _e1642) + (_e1645 * _e1645)) + (_e1648 * _e1648))));
            let _e1664 = (_e1642 * _e1663);
            let _e1665 = (_e1645 * _e1663);
            let _e1666 = (_e1648 * _e1663);
            if ((((_e1664 * (_e1650.x - _e1566)) + (_e1665 * (_e1650.y - _e1567))) + (_e1666 * (_e1650.z - _e1568))) < 0f) {
                phi_2333_ = vec3<f32>(-(_e1664), -(_e1665), -(_e1666));
            } else {
                phi_2333_ = vec3<f32>(_e1664, _e1665, _e1666);
            }
            let _e1679 = phi_2333_;
            if (_e1530.triangle < _e77) {
            } else {
                return;
            }
            let _e1684 = triangles.member[(0u + _e1530.triangle)];
            let _e1686 = (_e1684.i0_ & 2147483647u);
            if (_e1686 < _e80) {
            } else {
                return;
            }
            let _e1692 = vertices.member[(0u + _e1686)];
            if (_e1684.i1_ < _e80) {
            } else {
                return;
            }
            let _e1696 = vertices.member[(0u + _e1684.i1_)];
            if (_e1684.i2_ < _e80) {
            } else {
                return;
            }
            let _e1700 = vertices.member[(0u + _e1684.i2_)];
            let _e1701 = array<abi_Vertex, 3>(_e1692, _e1696, _e1700);
            if (_e1701[0].material < arrayLength((&materials.member))) {
            } else {
                return;
            }
            let _e1707 = materials.member[(0u + _e1701[0].material)];
            let _e1724 = (1f / 255f);
            let _e1743 = (1f / 255f);
            let _e1765 = (1f / 255f);
            if (_e1707.color_size == 0u) {
                phi_2576_ = vec3<f32>(1f, 1f, 1f);
            } else {
                local.offset = _e1707.color_offset;
                local.size = _e1707.color_size;
                local.flags = _e1707.flags;
                let _e1808 = _lt_shaders_texture_TextureView_quad((&local), (((_e1701[0].u * _e1536) + (_e1701[1].u * _e1530.u)) + (_e1701[2].u * _e1530.v)), (((_e1701[0].v * _e1536) + (_e1701[1].v * _e1530.u)) + (_e1701[2].v * _e1530.v)));
                if (_e1808.indices[0] < _e89) {
                } else {
                    return;
                }
                let _e1814 = color_texels.member[(0u + _e1808.indices[0])];
                let _e1825 = (1f / 255f);
                if (_e1808.indices[1] < _e89) {
                } else {
                    return;
                }
                let _e1839 = color_texels.member[(0u + _e1808.indices[1])];
                let _e1850 = (1f / 255f);
                if (_e1808.indices[2] < _e89) {
                } else {
                    return;
                }
                let _e1867 = color_texels.member[(0u + _e1808.indices[2])];
                let _e1878 = (1f / 255f);
                if (_e1808.indices[3] < _e89) {
                } else {
                    return;
                }
                let _e1895 = color_texels.member[(0u + _e1808.indices[3])];
                let _e1906 = (1f / 255f);
                let _e1915 = (((((f32((_e1814 & 255u)) * _e1825) * _e1808.weights.x) + ((f32((_e1839 & 255u)) * _e1850) * _e1808.weights.y)) + ((f32((_e1867 & 255u)) * _e1878) * _e1808.weights.z)) + ((f32((_e1895 & 255u)) * _e1906) * _e1808.weights.w));
                let _e1916 = (((((f32(((_e1814 >> bitcast<u32>(8i)) & 255u)) * _e1825) * _e1808.weights.x) + ((f32(((_e1839 >> bitcast<u32>(8i)) & 255u)) * _e1850) * _e1808.weights.y)) + ((f32(((_e1867 >> bitcast<u32>(8i)) & 255u)) * _e1878) * _e1808.weights.z)) + ((f32(((_e1895 >> bitcast<u32>(8i)) & 255u)) * _e1906) * _e1808.weights.w));
                let _e1917 = (((((f32(((_e1814 >> bitcast<u32>(16i)) & 255u)) * _e1825) * _e1808.weights.x) + ((f32(((_e1839 >> bitcast<u32>(16i)) & 255u)) * _e1850) * _e1808.weights.y)) + ((f32(((_e1867 >> bitcast<u32>(16i)) & 255u)) * _e1878) * _e1808.weights.z)) + ((f32(((_e1895 >> bitcast<u32>(16i)) & 255u)) * _e1906) * _e1808.weights.w));
                phi_2576_ = vec3<f32>((_e1915 * _e1915), (_e1916 * _e1916), (_e1917 * _e1917));
            }
            let _e1923 = phi_2576_;
            let _e1925 = ((_e1707.base_color.x * ((((f32((_e1701[0].color & 255u)) * _e1724) * _e1536) + ((f32((_e1701[1].color & 255u)) * _e1743) * _e1530.u)) + ((f32((_e1701[2].color & 255u)) * _e1765) * _e1530.v))) * _e1923.x);
            let _e1927 = ((_e1707.base_color.y * ((((f32(((_e1701[0].color >> bitcast<u32>(8i)) & 255u)) * _e1724) * _e1536) + ((f32(((_e1701[1].color >> bitcast<u32>(8i)) & 255u)) * _e1743) * _e1530.u)) + ((f32(((_e1701[2].color >> bitcast<u32>(8i)) & 255u)) * _e1765) * _e1530.v))) * _e1923.y);
            let _e1929 = ((_e1707.base_color.z * ((((f32(((_e1701[0].color >> bitcast<u32>(16i)) & 255u)) * _e1724) * _e1536) + ((f32(((_e1701[1].color >> bitcast<u32>(16i)) & 255u)) * _e1743) * _e1530.u)) + ((f32(((_e1701[2].color >> bitcast<u32>(16i)) & 255u)) * _e1765) * _e1530.v))) * _e1923.z);
            let _e1930 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1602, _e1605);
            let _e1931 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1599, _e1930);
            if ((_e1707.flags & 2u) == 0u) {
                phi_2591_ = 0u;
            } else {
                phi_2591_ = 1u;
            }
            let _e1936 = phi_2591_;
            if (_e1701[0].normal == 2147516416u) {
                phi_2794_ = _e1679;
            } else {
                let _e1949 = (f32((bitcast<i32>((_e1701[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1955 = (f32((bitcast<i32>(_e1701[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1959 = ((1f - abs(_e1949)) - abs(_e1955));
                if (_e1959 < 0f) {
                    phi_2618_ = -(_e1959);
                } else {
                    phi_2618_ = 0f;
                }
                let _e1963 = phi_2618_;
                if (_e1949 < 0f) {
                    phi_2625_ = (_e1949 + _e1963);
                } else {
                    phi_2625_ = (_e1949 - _e1963);
                }
                let _e1968 = phi_2625_;
                if (_e1955 < 0f) {
                    phi_2632_ = (_e1955 + _e1963);
                } else {
                    phi_2632_ = (_e1955 - _e1963);
                }
                let _e1973 = phi_2632_;
                let _e1980 = (1f / sqrt((((_e1968 * _e1968) + (_e1973 * _e1973)) + (_e1959 * _e1959))));
                let _e1996 = (f32((bitcast<i32>((_e1701[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2002 = (f32((bitcast<i32>(_e1701[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2006 = ((1f - abs(_e1996)) - abs(_e2002));
                if (_e2006 < 0f) {
                    phi_2667_ = -(_e2006);
                } else {
                    phi_2667_ = 0f;
                }
                let _e2010 = phi_2667_;
                if (_e1996 < 0f) {
                    phi_2674_ = (_e1996 + _e2010);
                } else {
                    phi_2674_ = (_e1996 - _e2010);
                }
                let _e2015 = phi_2674_;
                if (_e2002 < 0f) {
                    phi_2681_ = (_e2002 + _e2010);
                } else {
                    phi_2681_ = (_e2002 - _e2010);
                }
                let _e2020 = phi_2681_;
                let _e2027 = (1f / sqrt((((_e2015 * _e2015) + (_e2020 * _e2020)) + (_e2006 * _e2006))));
                let _e2046 = (f32((bitcast<i32>((_e1701[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2052 = (f32((bitcast<i32>(_e1701[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2056 = ((1f - abs(_e2046)) - abs(_e2052));
                if (_e2056 < 0f) {
                    phi_2719_ = -(_e2056);
                } else {
                    phi_2719_ = 0f;
                }
                let _e2060 = phi_2719_;
                if (_e2046 < 0f) {
                    phi_2726_ = (_e2046 + _e2060);
                } else {
                    phi_2726_ = (_e2046 - _e2060);
                }
                let _e2065 = phi_2726_;
                if (_e2052 < 0f) {
                    phi_2733_ = (_e2052 + _e2060);
                } else {
                    phi_2733_ = (_e2052 - _e2060);
                }
                let _e2070 = phi_2733_;
                let _e2077 = (1f / sqrt((((_e2065 * _e2065) + (_e2070 * _e2070)) + (_e2056 * _e2056))));
                let _e2088 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(vec3<f32>(((((_e1968 * _e1980) * _e1536) + ((_e2015 * _e2027) * _e1530.u)) + ((_e2065 * _e2077) * _e1530.v)), ((((_e1973 * _e1980) * _e1536) + ((_e2020 * _e2027) * _e1530.u)) + ((_e2070 * _e2077) * _e1530.v)), ((((_e1959 * _e1980) * _e1536) + ((_e2006 * _e2027) * _e1530.u)) + ((_e2056 * _e2077) * _e1530.v))));
                let _e2100 = sqrt((((_e2088.x * _e2088.x) + (_e2088.y * _e2088.y)) + (_e2088.z * _e2088.z)));
                if (_e2100 > 0f) {
                    let _e2103 = (_e2088.x / _e2100);
                    let _e2105 = (_e2088.y / _e2100);
                    let _e2107 = (_e2088.z / _e2100);
                    if ((((_e2103 * _e1679.x) + (_e2105 * _e1679.y)) + (_e2107 * _e1679.z)) < 0f) {
                        phi_2792_ = vec3<f32>(-(_e2103), -(_e2105), -(_e2107));
                    } else {
                        phi_2792_ = (_e2088 / vec3(_e2100));
                    }
                    let _e2124 = phi_2792_;
                    phi_2793_ = _e2124;
                } else {
                    phi_2793_ = _e1679;
                }
                let _e2126 = phi_2793_;
                phi_2794_ = _e2126;
            }
            let _e2128 = phi_2794_;
            if (_e1925 > 0f) {
                if (_e1925 < 1f) {
                    phi_2803_ = _e1925;
                } else {
                    phi_2803_ = 1f;
                }
                let _e2132 = phi_2803_;
                phi_2804_ = _e2132;
            } else {
                phi_2804_ = 0f;
            }
            let _e2134 = phi_2804_;
            if (_e1927 > 0f) {
                if (_e1927 < 1f) {
                    phi_2814_ = _e1927;
                } else {
                    phi_2814_ = 1f;
                }
                let _e2139 = phi_2814_;
                phi_2815_ = _e2139;
            } else {
                phi_2815_ = 0f;
            }
            let _e2141 = phi_2815_;
            if (_e1929 > 0f) {
                if (_e1929 < 1f) {
                    phi_2825_ = _e1929;
                } else {
                    phi_2825_ = 1f;
                }
                let _e2146 = phi_2825_;
                phi_2826_ = _e2146;
            } else {
                phi_2826_ = 0f;
            }
            let _e2148 = phi_2826_;
            let _e2151 = ((sqrt(_e2134) * 255f) + 0.5f);
            let _e2160 = ((sqrt(_e2141) * 255f) + 0.5f);
            let _e2172 = ((sqrt(_e2148) * 255f) + 0.5f);
            phi_2861_ = abi_Sample(vec3<f32>(_e1566, _e1567, _e1568), _e1931, _e1679, _e1936, _e2128, ((select(select(u32(_e2151), 0u, (_e2151 < bitcast<f32>(0u))), 4294967295u, (_e2151 > bitcast<f32>(1333788671u))) | (select(select(u32(_e2160), 0u, (_e2160 < bitcast<f32>(0u))), 4294967295u, (_e2160 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e2172), 0u, (_e2172 < bitcast<f32>(0u))), 4294967295u, (_e2172 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_2861_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e2186 = phi_2861_;
        if (_e95.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e95.first_primitive)] = _e2186;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_color_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
