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
var<storage> color_texels: type_9;
@group(0) @binding(7) 
var<storage> before: type_28;
@group(0) @binding(8) 
var<storage, read_write> past: type_28;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_217_: lt_bvh_traverse_Tree;
    var phi_218_: bool;
    var phi_219_: lt_bvh_traverse_Tree;
    var phi_220_: bool;
    var phi_225_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_217_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_218_ = false;
        } else {
            phi_217_ = lt_bvh_traverse_Tree();
            phi_218_ = true;
        }
        let _e84 = phi_217_;
        let _e86 = phi_218_;
        phi_219_ = _e84;
        phi_220_ = _e86;
    } else {
        phi_219_ = lt_bvh_traverse_Tree();
        phi_220_ = true;
    }
    let _e88 = phi_219_;
    let _e90 = phi_220_;
    if _e90 {
        phi_225_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_225_ = _e88;
    }
    let _e95 = phi_225_;
    return lt_bvh_traverse_Tree(_e95.root, _e95.first_primitive);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_240_: bool;
    var phi_244_: f32;

    if (param_3 != param_3) {
        phi_240_ = true;
    } else {
        let _e74 = (param_4 >= param_3);
        if _e74 {
        }
        phi_240_ = _e74;
    }
    let _e76 = phi_240_;
    if _e76 {
        phi_244_ = param_4;
    } else {
        phi_244_ = param_3;
    }
    let _e78 = phi_244_;
    return _e78;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_256_: bool;
    var phi_260_: f32;

    if (param_5 != param_5) {
        phi_256_ = true;
    } else {
        let _e74 = (param_6 <= param_5);
        if _e74 {
        }
        phi_256_ = _e74;
    }
    let _e76 = phi_256_;
    if _e76 {
        phi_260_ = param_6;
    } else {
        phi_260_ = param_5;
    }
    let _e78 = phi_260_;
    return _e78;
}

fn _lt_shaders_texture_TextureView_quad(param_7: ptr<function, texture_TextureView>, param_8: f32, param_9: f32) -> texture_TexelQuad {
    var phi_302_: f32;
    var phi_307_: f32;
    var phi_308_: bool;
    var phi_309_: f32;
    var phi_310_: bool;
    var phi_314_: f32;
    var phi_340_: f32;
    var phi_345_: f32;
    var phi_346_: bool;
    var phi_347_: f32;
    var phi_348_: bool;
    var phi_352_: f32;
    var phi_360_: f32;
    var phi_361_: f32;
    var phi_362_: f32;
    var phi_371_: f32;
    var phi_372_: f32;
    var phi_390_: u32;
    var phi_404_: u32;
    var phi_411_: u32;
    var phi_416_: u32;
    var phi_422_: u32;
    var phi_427_: u32;
    var phi_429_: texture_Axis;
    var phi_457_: f32;
    var phi_462_: f32;
    var phi_463_: bool;
    var phi_464_: f32;
    var phi_465_: bool;
    var phi_469_: f32;
    var phi_495_: f32;
    var phi_500_: f32;
    var phi_501_: bool;
    var phi_502_: f32;
    var phi_503_: bool;
    var phi_507_: f32;
    var phi_515_: f32;
    var phi_516_: f32;
    var phi_517_: f32;
    var phi_526_: f32;
    var phi_527_: f32;
    var phi_545_: u32;
    var phi_559_: u32;
    var phi_566_: u32;
    var phi_571_: u32;
    var phi_577_: u32;
    var phi_582_: u32;
    var phi_584_: texture_Axis;

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
                phi_302_ = 1f;
            } else {
                phi_302_ = 0f;
            }
            let _e105 = phi_302_;
            if (param_8 < 8388608f) {
                phi_307_ = (_e102 - _e105);
                phi_308_ = false;
            } else {
                phi_307_ = f32();
                phi_308_ = true;
            }
            let _e108 = phi_307_;
            let _e110 = phi_308_;
            phi_309_ = _e108;
            phi_310_ = _e110;
        } else {
            phi_309_ = f32();
            phi_310_ = true;
        }
        let _e112 = phi_309_;
        let _e114 = phi_310_;
        if _e114 {
            phi_314_ = param_8;
        } else {
            phi_314_ = _e112;
        }
        let _e116 = phi_314_;
        phi_362_ = (param_8 - _e116);
    } else {
        if (_e89 == 1u) {
            let _e119 = (param_8 * 0.5f);
            if (_e119 > -8388608f) {
                let _e131 = f32(select(0i, select(select(i32(_e119), i32(-2147483648), (_e119 < bitcast<f32>(3472883712u))), 2147483647i, (_e119 > bitcast<f32>(1325400063u))), (_e119 == _e119)));
                if (_e131 > _e119) {
                    phi_340_ = 1f;
                } else {
                    phi_340_ = 0f;
                }
                let _e134 = phi_340_;
                if (_e119 < 8388608f) {
                    phi_345_ = (_e131 - _e134);
                    phi_346_ = false;
                } else {
                    phi_345_ = f32();
                    phi_346_ = true;
                }
                let _e137 = phi_345_;
                let _e139 = phi_346_;
                phi_347_ = _e137;
                phi_348_ = _e139;
            } else {
                phi_347_ = f32();
                phi_348_ = true;
            }
            let _e141 = phi_347_;
            let _e143 = phi_348_;
            if _e143 {
                phi_352_ = _e119;
            } else {
                phi_352_ = _e141;
            }
            let _e145 = phi_352_;
            let _e147 = (param_8 - (2f * _e145));
            if (_e147 > 1f) {
                phi_360_ = (2f - _e147);
            } else {
                phi_360_ = _e147;
            }
            let _e151 = phi_360_;
            phi_361_ = _e151;
        } else {
            phi_361_ = param_8;
        }
        let _e153 = phi_361_;
        phi_362_ = _e153;
    }
    let _e155 = phi_362_;
    if (_e155 > 0f) {
        if (_e155 < 1f) {
            phi_371_ = _e155;
        } else {
            phi_371_ = 1f;
        }
        let _e159 = phi_371_;
        phi_372_ = _e159;
    } else {
        phi_372_ = 0f;
    }
    let _e161 = phi_372_;
    let _e162 = (_e76 - 1u);
    let _e164 = (_e161 * f32(_e76));
    if _e84 {
        let _e171 = select(select(u32(_e164), 0u, (_e164 < bitcast<f32>(0u))), 4294967295u, (_e164 > bitcast<f32>(1333788671u)));
        if (_e162 < _e171) {
            phi_390_ = _e162;
        } else {
            phi_390_ = _e171;
        }
        let _e174 = phi_390_;
        phi_429_ = texture_Axis(_e174, _e174, 0f);
    } else {
        let _e176 = (_e164 + 0.5f);
        let _e183 = select(select(u32(_e176), 0u, (_e176 < bitcast<f32>(0u))), 4294967295u, (_e176 > bitcast<f32>(1333788671u)));
        if (_e76 < _e183) {
            phi_404_ = _e76;
        } else {
            phi_404_ = _e183;
        }
        let _e186 = phi_404_;
        if (_e89 == 0u) {
            phi_411_ = _e162;
        } else {
            phi_411_ = 0u;
        }
        let _e191 = phi_411_;
        if (_e89 == 0u) {
            phi_416_ = 0u;
        } else {
            phi_416_ = _e162;
        }
        let _e194 = phi_416_;
        if (_e186 == 0u) {
            phi_422_ = _e191;
        } else {
            phi_422_ = (_e186 - 1u);
        }
        let _e198 = phi_422_;
        if (_e186 > _e162) {
            phi_427_ = _e194;
        } else {
            phi_427_ = _e186;
        }
        let _e201 = phi_427_;
        phi_429_ = texture_Axis(_e198, _e201, (_e176 - f32(_e186)));
    }
    let _e204 = phi_429_;
    let _e206 = (*param_7).flags;
    let _e209 = ((_e206 >> bitcast<u32>(6u)) & 3u);
    if (_e209 == 0u) {
        if (param_9 > -8388608f) {
            let _e222 = f32(select(0i, select(select(i32(param_9), i32(-2147483648), (param_9 < bitcast<f32>(3472883712u))), 2147483647i, (param_9 > bitcast<f32>(1325400063u))), (param_9 == param_9)));
            if (_e222 > param_9) {
                phi_457_ = 1f;
            } else {
                phi_457_ = 0f;
            }
            let _e225 = phi_457_;
            if (param_9 < 8388608f) {
                phi_462_ = (_e222 - _e225);
                phi_463_ = false;
            } else {
                phi_462_ = f32();
                phi_463_ = true;
            }
            let _e228 = phi_462_;
            let _e230 = phi_463_;
            phi_464_ = _e228;
            phi_465_ = _e230;
        } else {
            phi_464_ = f32();
            phi_465_ = true;
        }
        let _e232 = phi_464_;
        let _e234 = phi_465_;
        if _e234 {
            phi_469_ = param_9;
        } else {
            phi_469_ = _e232;
        }
        let _e236 = phi_469_;
        phi_517_ = (param_9 - _e236);
    } else {
        if (_e209 == 1u) {
            let _e239 = (param_9 * 0.5f);
            if (_e239 > -8388608f) {
                let _e251 = f32(select(0i, select(select(i32(_e239), i32(-2147483648), (_e239 < bitcast<f32>(3472883712u))), 2147483647i, (_e239 > bitcast<f32>(1325400063u))), (_e239 == _e239)));
                if (_e251 > _e239) {
                    phi_495_ = 1f;
                } else {
                    phi_495_ = 0f;
                }
                let _e254 = phi_495_;
                if (_e239 < 8388608f) {
                    phi_500_ = (_e251 - _e254);
                    phi_501_ = false;
                } else {
                    phi_500_ = f32();
                    phi_501_ = true;
                }
                let _e257 = phi_500_;
                let _e259 = phi_501_;
                phi_502_ = _e257;
                phi_503_ = _e259;
            } else {
                phi_502_ = f32();
                phi_503_ = true;
            }
            let _e261 = phi_502_;
            let _e263 = phi_503_;
            if _e263 {
                phi_507_ = _e239;
            } else {
                phi_507_ = _e261;
            }
            let _e265 = phi_507_;
            let _e267 = (param_9 - (2f * _e265));
            if (_e267 > 1f) {
                phi_515_ = (2f - _e267);
            } else {
                phi_515_ = _e267;
            }
            let _e271 = phi_515_;
            phi_516_ = _e271;
        } else {
            phi_516_ = param_9;
        }
        let _e273 = phi_516_;
        phi_517_ = _e273;
    }
    let _e275 = phi_517_;
    if (_e275 > 0f) {
        if (_e275 < 1f) {
            phi_526_ = _e275;
        } else {
            phi_526_ = 1f;
        }
        let _e279 = phi_526_;
        phi_527_ = _e279;
    } else {
        phi_527_ = 0f;
    }
    let _e281 = phi_527_;
    let _e282 = (_e80 - 1u);
    let _e284 = (_e281 * f32(_e80));
    if _e84 {
        let _e291 = select(select(u32(_e284), 0u, (_e284 < bitcast<f32>(0u))), 4294967295u, (_e284 > bitcast<f32>(1333788671u)));
        if (_e282 < _e291) {
            phi_545_ = _e282;
        } else {
            phi_545_ = _e291;
        }
        let _e294 = phi_545_;
        phi_584_ = texture_Axis(_e294, _e294, 0f);
    } else {
        let _e296 = (_e284 + 0.5f);
        let _e303 = select(select(u32(_e296), 0u, (_e296 < bitcast<f32>(0u))), 4294967295u, (_e296 > bitcast<f32>(1333788671u)));
        if (_e80 < _e303) {
            phi_559_ = _e80;
        } else {
            phi_559_ = _e303;
        }
        let _e306 = phi_559_;
        if (_e209 == 0u) {
            phi_566_ = _e282;
        } else {
            phi_566_ = 0u;
        }
        let _e311 = phi_566_;
        if (_e209 == 0u) {
            phi_571_ = 0u;
        } else {
            phi_571_ = _e282;
        }
        let _e314 = phi_571_;
        if (_e306 == 0u) {
            phi_577_ = _e311;
        } else {
            phi_577_ = (_e306 - 1u);
        }
        let _e318 = phi_577_;
        if (_e306 > _e282) {
            phi_582_ = _e314;
        } else {
            phi_582_ = _e306;
        }
        let _e321 = phi_582_;
        phi_584_ = texture_Axis(_e318, _e321, (_e296 - f32(_e306)));
    }
    let _e324 = phi_584_;
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
    var phi_643_: f32;

    if (param_12 > param_13) {
        phi_643_ = param_12;
    } else {
        phi_643_ = param_13;
    }
    let _e75 = phi_643_;
    return _e75;
}

fn _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(param_14: vec3<f32>) -> vec3<f32> {
    return param_14;
}

fn _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(param_15: vec3<f32>) -> vec3<f32> {
    return param_15;
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var phi_783_: bool;
    var phi_784_: bool;
    var phi_785_: bool;
    var phi_786_: bool;
    var phi_790_: bool;
    var phi_803_: bool;
    var phi_804_: bool;
    var phi_805_: bool;
    var phi_806_: bool;
    var phi_810_: bool;
    var phi_823_: bool;
    var phi_824_: bool;
    var phi_825_: bool;
    var phi_829_: bool;
    var phi_830_: bool;
    var phi_831_: bool;
    var phi_832_: bool;
    var phi_833_: bool;
    var phi_837_: bool;
    var phi_913_: f32;
    var phi_920_: f32;
    var phi_928_: f32;
    var phi_935_: f32;
    var phi_943_: f32;
    var phi_950_: f32;
    var phi_973_: f32;
    var phi_978_: f32;
    var phi_983_: f32;
    var phi_988_: f32;
    var phi_993_: f32;
    var phi_1024_: bool;
    var phi_1025_: bool;
    var phi_1033_: u32;
    var phi_1034_: u32;
    var phi_1051_: vec3<f32>;
    var phi_1052_: vec3<f32>;
    var phi_1065_: u32;
    var phi_1070_: u32;
    var phi_1075_: u32;
    var phi_1189_: bool;
    var phi_1190_: bool;
    var phi_1221_: u32;
    var phi_1223_: lt_bvh_Hit;
    var phi_1226_: u32;
    var phi_1311_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1338_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1365_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1371_: u32;
    var phi_1374_: u32;
    var phi_1388_: u32;
    var phi_1398_: u32;
    var phi_1408_: u32;
    var phi_1426_: u32;
    var phi_1436_: u32;
    var phi_1446_: u32;
    var phi_1482_: u32;
    var phi_1495_: u32;
    var phi_1500_: u32;
    var phi_1501_: u32;
    var phi_1502_: u32;
    var phi_1372_: u32;
    var phi_1375_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_1560_: lt_bvh_Hit;
    var phi_1563_: u32;
    var phi_1609_: vec3<f32>;
    var phi_1610_: vec3<f32>;
    var phi_1641_: vec3<f32>;
    var phi_1642_: vec3<f32>;
    var phi_1673_: vec3<f32>;
    var phi_1674_: vec3<f32>;
    var phi_1692_: bool;
    var phi_1693_: bool;
    var phi_1697_: f32;
    var phi_1698_: f32;
    var phi_1699_: f32;
    var phi_1700_: f32;
    var phi_1708_: f32;
    var phi_1718_: bool;
    var phi_1719_: bool;
    var phi_1723_: f32;
    var phi_1724_: f32;
    var phi_1725_: f32;
    var phi_1726_: f32;
    var phi_1734_: f32;
    var phi_1744_: bool;
    var phi_1745_: bool;
    var phi_1749_: f32;
    var phi_1750_: f32;
    var phi_1751_: f32;
    var phi_1752_: f32;
    var phi_1760_: f32;
    var phi_1775_: f32;
    var phi_1776_: bool;
    var phi_1777_: f32;
    var phi_1778_: bool;
    var phi_1779_: f32;
    var phi_1780_: bool;
    var phi_1798_: f32;
    var phi_1799_: bool;
    var phi_1800_: bool;
    var phi_1801_: f32;
    var phi_1802_: bool;
    var phi_1803_: bool;
    var phi_1807_: bool;
    var phi_1808_: f32;
    var phi_1809_: bool;
    var phi_1839_: vec3<f32>;
    var phi_1840_: vec3<f32>;
    var phi_1865_: vec3<f32>;
    var phi_1866_: vec3<f32>;
    var phi_1891_: vec3<f32>;
    var phi_1892_: vec3<f32>;
    var phi_1950_: f32;
    var phi_1959_: f32;
    var phi_1968_: f32;
    var phi_1977_: f32;
    var phi_1984_: f32;
    var phi_1991_: f32;
    var phi_2004_: f32;
    var phi_2013_: f32;
    var phi_2022_: f32;
    var phi_2031_: f32;
    var phi_2038_: f32;
    var phi_2045_: f32;
    var phi_2068_: f32;
    var phi_2073_: f32;
    var phi_2078_: f32;
    var phi_2086_: f32;
    var phi_2091_: f32;
    var phi_2096_: f32;
    var phi_2108_: f32;
    var phi_2113_: f32;
    var phi_2118_: f32;
    var phi_2123_: f32;
    var phi_2128_: lt_bvh_triangle_Intersection;
    var phi_2129_: bool;
    var phi_2130_: lt_bvh_triangle_Intersection;
    var phi_2131_: bool;
    var phi_2135_: lt_bvh_triangle_Intersection;
    var phi_2136_: bool;
    var phi_2137_: lt_bvh_triangle_Intersection;
    var phi_2138_: bool;
    var phi_2139_: bool;
    var phi_2143_: bool;
    var phi_2147_: lt_bvh_triangle_Intersection;
    var phi_2186_: bool;
    var phi_2187_: bool;
    var phi_2188_: bool;
    var phi_2189_: bool;
    var phi_2190_: bool;
    var phi_2191_: bool;
    var phi_2195_: bool;
    var phi_2196_: bool;
    var phi_2210_: bool;
    var phi_2218_: lt_bvh_Hit;
    var phi_2219_: lt_bvh_Hit;
    var phi_2220_: lt_bvh_Hit;
    var phi_2221_: lt_bvh_Hit;
    var phi_1561_: lt_bvh_Hit;
    var phi_1564_: u32;
    var phi_2222_: bool;
    var phi_2261_: bool;
    var phi_2262_: bool;
    var phi_2293_: u32;
    var phi_1224_: lt_bvh_Hit;
    var phi_1227_: u32;
    var phi_2294_: lt_bvh_Hit;
    var phi_2295_: lt_bvh_Hit;
    var phi_2296_: bool;
    var phi_2300_: lt_bvh_Hit;
    var phi_2364_: f32;
    var phi_2369_: f32;
    var phi_2374_: f32;
    var phi_2385_: f32;
    var phi_2390_: f32;
    var phi_2395_: f32;
    var phi_2471_: vec3<f32>;
    var phi_2714_: vec3<f32>;
    var phi_2729_: u32;
    var phi_2756_: f32;
    var phi_2763_: f32;
    var phi_2770_: f32;
    var phi_2805_: f32;
    var phi_2812_: f32;
    var phi_2819_: f32;
    var phi_2857_: f32;
    var phi_2864_: f32;
    var phi_2871_: f32;
    var phi_2930_: vec3<f32>;
    var phi_2931_: vec3<f32>;
    var phi_2932_: vec3<f32>;
    var phi_2941_: f32;
    var phi_2942_: f32;
    var phi_2952_: f32;
    var phi_2953_: f32;
    var phi_2963_: f32;
    var phi_2964_: f32;
    var phi_2999_: abi_Sample;
    var phi_3090_: vec3<f32>;
    var local_5: lt_bvh_Hit;
    var local_6: lt_bvh_Hit;

    let _e73 = id_1;
    let _e77 = arrayLength((&nodes.member));
    let _e80 = arrayLength((&triangles.member));
    let _e83 = arrayLength((&vertices.member));
    let _e92 = arrayLength((&color_texels.member));
    let _e95 = arrayLength((&before.member));
    let _e101 = p.member.size[0u];
    let _e103 = p.member.size[1u];
    let _e104 = lt_shaders_entry_pixel_index(_e73, _e101, _e103);
    if (bitcast<i32>(_e104.root) != 0i) {
        let _e112 = p.member.eye;
        let _e115 = p.member.grid[0u];
        let _e117 = p.member.grid[1u];
        let _e136 = p.member.size[0u];
        let _e140 = ((((f32(_e73.x) + ((f32((_e73.y & (_e117 - 1u))) + 0.5f) / f32(_e117))) / f32(_e136)) * 2f) - 1f);
        let _e143 = p.member.size[1u];
        let _e147 = (1f - (((f32(_e73.y) + ((f32((_e73.x & (_e115 - 1u))) + 0.5f) / f32(_e115))) / f32(_e143)) * 2f));
        let _e149 = p.member.forward;
        let _e151 = p.member.right;
        let _e165 = p.member.up;
        let _e176 = _lt_bvh_ray_Ray_new(_e112, vec3<f32>(((_e149.x + (_e151.x * _e140)) + (_e165.x * _e147)), ((_e149.y + (_e151.y * _e140)) + (_e165.y * _e147)), ((_e149.z + (_e151.z * _e140)) + (_e165.z * _e147))));
        let _e178 = lt_bvh_Hit(_e176.tmax, 0f, 0f, 4294967295u, 4294967295u);
        let _e181 = abs(_e176.direction.x);
        let _e183 = abs(_e176.direction.y);
        let _e185 = abs(_e176.direction.z);
        if (abs(_e176.origin.x) < 1000000000000000f) {
            if (abs(_e176.origin.y) < 1000000000000000f) {
                phi_783_ = (abs(_e176.origin.z) < 1000000000000000f);
                phi_784_ = false;
            } else {
                phi_783_ = bool();
                phi_784_ = true;
            }
            let _e197 = phi_783_;
            let _e199 = phi_784_;
            phi_785_ = _e197;
            phi_786_ = _e199;
        } else {
            phi_785_ = bool();
            phi_786_ = true;
        }
        let _e201 = phi_785_;
        let _e203 = phi_786_;
        if _e203 {
            phi_790_ = false;
        } else {
            phi_790_ = _e201;
        }
        let _e205 = phi_790_;
        if _e205 {
            if (_e181 < 1000000000000000f) {
                if (_e183 < 1000000000000000f) {
                    phi_803_ = (_e185 < 1000000000000000f);
                    phi_804_ = false;
                } else {
                    phi_803_ = bool();
                    phi_804_ = true;
                }
                let _e210 = phi_803_;
                let _e212 = phi_804_;
                phi_805_ = _e210;
                phi_806_ = _e212;
            } else {
                phi_805_ = bool();
                phi_806_ = true;
            }
            let _e214 = phi_805_;
            let _e216 = phi_806_;
            if _e216 {
                phi_810_ = false;
            } else {
                phi_810_ = _e214;
            }
            let _e218 = phi_810_;
            if _e218 {
                if (_e181 > 0f) {
                    phi_824_ = bool();
                    phi_825_ = true;
                } else {
                    let _e220 = (_e183 > 0f);
                    if _e220 {
                        phi_823_ = bool();
                    } else {
                        phi_823_ = (_e185 > 0f);
                    }
                    let _e223 = phi_823_;
                    phi_824_ = _e223;
                    phi_825_ = _e220;
                }
                let _e225 = phi_824_;
                let _e227 = phi_825_;
                if _e227 {
                    phi_829_ = true;
                } else {
                    phi_829_ = _e225;
                }
                let _e229 = phi_829_;
                phi_830_ = _e229;
                phi_831_ = false;
            } else {
                phi_830_ = bool();
                phi_831_ = true;
            }
            let _e231 = phi_830_;
            let _e233 = phi_831_;
            phi_832_ = _e231;
            phi_833_ = _e233;
        } else {
            phi_832_ = bool();
            phi_833_ = true;
        }
        let _e235 = phi_832_;
        let _e237 = phi_833_;
        if _e237 {
            phi_837_ = false;
        } else {
            phi_837_ = _e235;
        }
        let _e239 = phi_837_;
        if _e239 {
            let _e240 = (0u >= _e77);
            if _e240 {
                phi_2294_ = lt_bvh_Hit();
            } else {
                if (0u < _e77) {
                } else {
                    return;
                }
                let _e246 = nodes.member[(0u + 0u)].frame[0u];
                let _e250 = nodes.member[(0u + 0u)].frame[1u];
                let _e254 = nodes.member[(0u + 0u)].frame[2u];
                let _e258 = nodes.member[(0u + 0u)].frame[0u];
                let _e262 = nodes.member[(0u + 0u)].frame[1u];
                let _e266 = nodes.member[(0u + 0u)].frame[2u];
                let _e270 = nodes.member[(0u + 0u)].frame[3u];
                let _e309 = core_intrinsics_maximum_number_nsz_f32_(abs(_e176.direction.x), abs(_e176.direction.y));
                let _e310 = core_intrinsics_maximum_number_nsz_f32_(_e309, abs(_e176.direction.z));
                let _e311 = (_e310 * 0.0000000000009094947f);
                if (abs(_e176.direction.x) < _e311) {
                    phi_913_ = _e311;
                } else {
                    phi_913_ = abs(_e176.direction.x);
                }
                let _e317 = phi_913_;
                if (_e176.direction.x < 0f) {
                    phi_920_ = (-1f / _e317);
                } else {
                    phi_920_ = (1f / _e317);
                }
                let _e322 = phi_920_;
                if (abs(_e176.direction.y) < _e311) {
                    phi_928_ = _e311;
                } else {
                    phi_928_ = abs(_e176.direction.y);
                }
                let _e328 = phi_928_;
                if (_e176.direction.y < 0f) {
                    phi_935_ = (-1f / _e328);
                } else {
                    phi_935_ = (1f / _e328);
                }
                let _e333 = phi_935_;
                if (abs(_e176.direction.z) < _e311) {
                    phi_943_ = _e311;
                } else {
                    phi_943_ = abs(_e176.direction.z);
                }
                let _e339 = phi_943_;
                if (_e176.direction.z < 0f) {
                    phi_950_ = (-1f / _e339);
                } else {
                    phi_950_ = (1f / _e339);
                }
                let _e344 = phi_950_;
                let _e351 = abs((bitcast<f32>(_e246) - _e176.origin.x));
                let _e352 = abs((bitcast<f32>(_e250) - _e176.origin.y));
                let _e353 = abs((bitcast<f32>(_e254) - _e176.origin.z));
                let _e360 = abs(((bitcast<f32>(_e258) + (bitcast<f32>((((_e270 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e176.origin.x));
                let _e361 = abs(((bitcast<f32>(_e262) + (bitcast<f32>((((_e270 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e176.origin.y));
                let _e362 = abs(((bitcast<f32>(_e266) + (bitcast<f32>((((_e270 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e176.origin.z));
                if (_e351 > _e360) {
                    phi_973_ = _e351;
                } else {
                    phi_973_ = _e360;
                }
                let _e365 = phi_973_;
                if (_e352 > _e361) {
                    phi_978_ = _e352;
                } else {
                    phi_978_ = _e361;
                }
                let _e368 = phi_978_;
                if (_e353 > _e362) {
                    phi_983_ = _e353;
                } else {
                    phi_983_ = _e362;
                }
                let _e371 = phi_983_;
                if (_e365 > _e368) {
                    phi_988_ = _e365;
                } else {
                    phi_988_ = _e368;
                }
                let _e374 = phi_988_;
                if (_e374 > _e371) {
                    phi_993_ = _e374;
                } else {
                    phi_993_ = _e371;
                }
                let _e377 = phi_993_;
                let _e381 = (_e377 * 0.0000019073486f);
                let _e382 = (abs(_e322) * _e381);
                let _e383 = (abs(_e333) * _e381);
                let _e384 = (abs(_e344) * _e381);
                let _e388 = (_e377 * 0.0000009536743f);
                let _e389 = (abs(_e322) * _e388);
                let _e390 = (abs(_e333) * _e388);
                let _e391 = (abs(_e344) * _e388);
                let _e395 = abs(_e176.direction.x);
                let _e397 = abs(_e176.direction.y);
                let _e399 = abs(_e176.direction.z);
                if (_e395 >= _e397) {
                    if (_e395 >= _e399) {
                        phi_1024_ = false;
                    } else {
                        phi_1024_ = true;
                    }
                    let _e403 = phi_1024_;
                    phi_1025_ = _e403;
                } else {
                    phi_1025_ = true;
                }
                let _e405 = phi_1025_;
                if _e405 {
                    if (_e397 >= _e399) {
                        phi_1033_ = 1u;
                    } else {
                        phi_1033_ = 2u;
                    }
                    let _e408 = phi_1033_;
                    phi_1034_ = _e408;
                } else {
                    phi_1034_ = 0u;
                }
                let _e410 = phi_1034_;
                if (_e410 == 0u) {
                    phi_1052_ = vec3<f32>(_e176.direction.y, _e176.direction.z, _e176.direction.x);
                } else {
                    if (_e410 == 1u) {
                        phi_1051_ = vec3<f32>(_e176.direction.z, _e176.direction.x, _e176.direction.y);
                    } else {
                        phi_1051_ = _e176.direction;
                    }
                    let _e422 = phi_1051_;
                    phi_1052_ = _e422;
                }
                let _e424 = phi_1052_;
                let _e427 = (_e424.x / _e424.z);
                let _e430 = (_e424.y / _e424.z);
                if (_e322 < 0f) {
                    phi_1065_ = 0u;
                } else {
                    phi_1065_ = 1u;
                }
                let _e435 = phi_1065_;
                if (_e333 < 0f) {
                    phi_1070_ = 0u;
                } else {
                    phi_1070_ = 2u;
                }
                let _e438 = phi_1070_;
                if (_e344 < 0f) {
                    phi_1075_ = 0u;
                } else {
                    phi_1075_ = 4u;
                }
                let _e441 = phi_1075_;
                let _e443 = ((_e435 | _e438) | _e441);
                let _e444 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e444.first[0], _e444.first[1], _e444.first[2], _e444.first[3], _e444.first[4], _e444.first[5], _e444.first[6], _e444.first[7], _e444.first[8], _e444.first[9], _e444.first[10], _e444.first[11], _e444.first[12], _e444.first[13], _e444.first[14], _e444.first[15], _e444.first[16], _e444.first[17], _e444.first[18], _e444.first[19], _e444.first[20], _e444.first[21], _e444.first[22], _e444.first[23], _e444.first[24], _e444.first[25], _e444.first[26], _e444.first[27], _e444.first[28], _e444.first[29], _e444.first[30], _e444.first[31]), array<u32, 32>(_e444.mask[0], _e444.mask[1], _e444.mask[2], _e444.mask[3], _e444.mask[4], _e444.mask[5], _e444.mask[6], _e444.mask[7], _e444.mask[8], _e444.mask[9], _e444.mask[10], _e444.mask[11], _e444.mask[12], _e444.mask[13], _e444.mask[14], _e444.mask[15], _e444.mask[16], _e444.mask[17], _e444.mask[18], _e444.mask[19], _e444.mask[20], _e444.mask[21], _e444.mask[22], _e444.mask[23], _e444.mask[24], _e444.mask[25], _e444.mask[26], _e444.mask[27], _e444.mask[28], _e444.mask[29], _e444.mask[30], _e444.mask[31]), _e444.len, _e444.group, _e444.group_mask);
                let _e518 = local_1.group_mask;
                if ((_e518 & 4278190080u) == 0u) {
                    let _e522 = local_1.len;
                    if (_e522 == 0u) {
                        phi_1189_ = false;
                    } else {
                        let _e526 = local_1.len;
                        local_1.len = (_e526 - 1u);
                        let _e529 = local_1.len;
                        if (_e529 < 32u) {
                        } else {
                            return;
                        }
                        let _e534 = local_1.first[(0u + _e529)];
                        local_1.group = _e534;
                        let _e537 = local_1.len;
                        if (_e537 < 32u) {
                        } else {
                            return;
                        }
                        let _e542 = local_1.mask[(0u + _e537)];
                        local_1.group_mask = _e542;
                        phi_1189_ = true;
                    }
                    let _e545 = phi_1189_;
                    phi_1190_ = _e545;
                } else {
                    phi_1190_ = true;
                }
                let _e547 = phi_1190_;
                if _e547 {
                    let _e549 = local_1.group_mask;
                    let _e555 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e549)), 32u, (_e549 == 0u)));
                    let _e559 = local_1.group_mask;
                    let _e573 = local_1.group_mask;
                    local_1.group_mask = (_e573 & ~((1u << bitcast<u32>((_e555 & 31u)))));
                    let _e576 = local_1.group;
                    phi_1221_ = (_e576 + countOneBits(((_e559 & ~((4294967295u << bitcast<u32>((((_e555 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1221_ = 4294967295u;
                }
                let _e579 = phi_1221_;
                phi_1223_ = _e178;
                phi_1226_ = _e579;
                loop {
                    let _e581 = phi_1223_;
                    let _e583 = phi_1226_;
                    local_6 = _e581;
                    let _e584 = (_e583 != 4294967295u);
                    if _e584 {
                        if (_e583 < _e77) {
                        } else {
                            return;
                        }
                        let _e592 = nodes.member[(0u + _e583)].frame[3u];
                        let _e617 = (bitcast<f32>((((_e592 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e322);
                        let _e618 = (bitcast<f32>((((_e592 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e333);
                        let _e619 = (bitcast<f32>((((_e592 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e344);
                        let _e622 = nodes.member[(0u + _e583)].frame[0u];
                        let _e626 = nodes.member[(0u + _e583)].frame[1u];
                        let _e630 = nodes.member[(0u + _e583)].frame[2u];
                        let _e638 = ((bitcast<f32>(_e622) - _e176.origin.x) * _e322);
                        let _e639 = ((bitcast<f32>(_e626) - _e176.origin.y) * _e333);
                        let _e640 = ((bitcast<f32>(_e630) - _e176.origin.z) * _e344);
                        let _e648 = nodes.member[(0u + _e583)].x;
                        if (_e322 < 0f) {
                            let _e659 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e648.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e665 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e659.unnamed.root, _e648.w), _e659.unnamed_1);
                            let _e671 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e665.unnamed, lt_bvh_traverse_Tree(_e648.x, _e665.unnamed_1.first_primitive));
                            phi_1311_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e671.unnamed, lt_bvh_traverse_Tree(_e671.unnamed_1.root, _e648.y));
                        } else {
                            let _e687 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e648.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e693 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e687.unnamed.root, _e648.y), _e687.unnamed_1);
                            let _e699 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e693.unnamed, lt_bvh_traverse_Tree(_e648.z, _e693.unnamed_1.first_primitive));
                            phi_1311_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e699.unnamed, lt_bvh_traverse_Tree(_e699.unnamed_1.root, _e648.w));
                        }
                        let _e707 = phi_1311_;
                        let _e717 = nodes.member[(0u + _e583)].y;
                        if (_e333 < 0f) {
                            let _e728 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e717.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e734 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e728.unnamed.root, _e717.w), _e728.unnamed_1);
                            let _e740 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e734.unnamed, lt_bvh_traverse_Tree(_e717.x, _e734.unnamed_1.first_primitive));
                            phi_1338_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e740.unnamed, lt_bvh_traverse_Tree(_e740.unnamed_1.root, _e717.y));
                        } else {
                            let _e756 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e717.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e762 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e756.unnamed.root, _e717.y), _e756.unnamed_1);
                            let _e768 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e762.unnamed, lt_bvh_traverse_Tree(_e717.z, _e762.unnamed_1.first_primitive));
                            phi_1338_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e768.unnamed, lt_bvh_traverse_Tree(_e768.unnamed_1.root, _e717.w));
                        }
                        let _e776 = phi_1338_;
                        let _e786 = nodes.member[(0u + _e583)].z;
                        if (_e344 < 0f) {
                            let _e797 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e786.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e803 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e797.unnamed.root, _e786.w), _e797.unnamed_1);
                            let _e809 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e803.unnamed, lt_bvh_traverse_Tree(_e786.x, _e803.unnamed_1.first_primitive));
                            phi_1365_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e809.unnamed, lt_bvh_traverse_Tree(_e809.unnamed_1.root, _e786.y));
                        } else {
                            let _e825 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e786.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e831 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e825.unnamed.root, _e786.y), _e825.unnamed_1);
                            let _e837 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e831.unnamed, lt_bvh_traverse_Tree(_e786.z, _e831.unnamed_1.first_primitive));
                            phi_1365_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e837.unnamed, lt_bvh_traverse_Tree(_e837.unnamed_1.root, _e786.w));
                        }
                        let _e845 = phi_1365_;
                        phi_1371_ = 0u;
                        phi_1374_ = 0u;
                        loop {
                            let _e855 = phi_1371_;
                            let _e857 = phi_1374_;
                            local_2 = _e857;
                            local_3 = _e857;
                            local_4 = _e857;
                            let _e858 = (_e855 < 8u);
                            if _e858 {
                                let _e860 = (_e855 >> bitcast<u32>(2i));
                                let _e861 = (_e855 & 3u);
                                if (_e860 == 0u) {
                                    phi_1388_ = _e707.unnamed.root;
                                } else {
                                    phi_1388_ = _e707.unnamed.first_primitive;
                                }
                                let _e864 = phi_1388_;
                                if (_e860 == 0u) {
                                    phi_1398_ = _e776.unnamed.root;
                                } else {
                                    phi_1398_ = _e776.unnamed.first_primitive;
                                }
                                let _e873 = phi_1398_;
                                if (_e860 == 0u) {
                                    phi_1408_ = _e845.unnamed.root;
                                } else {
                                    phi_1408_ = _e845.unnamed.first_primitive;
                                }
                                let _e882 = phi_1408_;
                                let _e895 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e864 >> bitcast<u32>(((_e861 * 8u) & 31u))) & 255u)) * _e617) + (_e638 - _e382)), ((f32(((_e873 >> bitcast<u32>(((_e861 * 8u) & 31u))) & 255u)) * _e618) + (_e639 - _e383)));
                                let _e896 = core_intrinsics_maximum_number_nsz_f32_(_e895, ((f32(((_e882 >> bitcast<u32>(((_e861 * 8u) & 31u))) & 255u)) * _e619) + (_e640 - _e384)));
                                if (_e860 == 0u) {
                                    phi_1426_ = _e707.unnamed_1.root;
                                } else {
                                    phi_1426_ = _e707.unnamed_1.first_primitive;
                                }
                                let _e899 = phi_1426_;
                                if (_e860 == 0u) {
                                    phi_1436_ = _e776.unnamed_1.root;
                                } else {
                                    phi_1436_ = _e776.unnamed_1.first_primitive;
                                }
                                let _e908 = phi_1436_;
                                if (_e860 == 0u) {
                                    phi_1446_ = _e845.unnamed_1.root;
                                } else {
                                    phi_1446_ = _e845.unnamed_1.first_primitive;
                                }
                                let _e917 = phi_1446_;
                                let _e930 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e899 >> bitcast<u32>(((_e861 * 8u) & 31u))) & 255u)) * _e617) + (_e638 + _e382)), ((f32(((_e908 >> bitcast<u32>(((_e861 * 8u) & 31u))) & 255u)) * _e618) + (_e639 + _e383)));
                                let _e931 = core_intrinsics_minimum_number_nsz_f32_(_e930, ((f32(((_e917 >> bitcast<u32>(((_e861 * 8u) & 31u))) & 255u)) * _e619) + (_e640 + _e384)));
                                if (_e896 <= _e931) {
                                    if (_e896 <= _e581.t) {
                                        if (_e931 >= _e176.tmin) {
                                            if (_e860 == 0u) {
                                                let _e938 = nodes.member[(0u + _e583)].links[2u];
                                                phi_1482_ = _e938;
                                            } else {
                                                let _e941 = nodes.member[(0u + _e583)].links[3u];
                                                phi_1482_ = _e941;
                                            }
                                            let _e943 = phi_1482_;
                                            let _e948 = ((_e943 >> bitcast<u32>(((_e861 * 8u) & 31u))) & 255u);
                                            let _e949 = (_e948 & 31u);
                                            if (_e949 >= 24u) {
                                                phi_1495_ = (24u + ((_e949 - 24u) ^ _e443));
                                            } else {
                                                phi_1495_ = _e949;
                                            }
                                            let _e955 = phi_1495_;
                                            phi_1500_ = (_e857 | ((_e948 >> bitcast<u32>(5i)) << bitcast<u32>((_e955 & 31u))));
                                        } else {
                                            phi_1500_ = _e857;
                                        }
                                        let _e963 = phi_1500_;
                                        phi_1501_ = _e963;
                                    } else {
                                        phi_1501_ = _e857;
                                    }
                                    let _e965 = phi_1501_;
                                    phi_1502_ = _e965;
                                } else {
                                    phi_1502_ = _e857;
                                }
                                let _e967 = phi_1502_;
                                phi_1372_ = (_e855 + 1u);
                                phi_1375_ = _e967;
                            } else {
                                phi_1372_ = u32();
                                phi_1375_ = u32();
                            }
                            let _e970 = phi_1372_;
                            let _e972 = phi_1375_;
                            continue;
                            continuing {
                                phi_1371_ = _e970;
                                phi_1374_ = _e972;
                                break if !(_e858);
                            }
                        }
                        let _e976 = nodes.member[(0u + _e583)].links[0u];
                        let _e980 = nodes.member[(0u + _e583)].frame[3u];
                        let _e984 = local_2;
                        if ((_e984 & 4278190080u) == 0u) {
                        } else {
                            let _e988 = local_1.group_mask;
                            if ((_e988 & 4278190080u) == 0u) {
                            } else {
                                let _e992 = local_1.len;
                                if (_e992 < 32u) {
                                    let _e995 = local_1.group;
                                    let _e997 = local_1.len;
                                    if (_e997 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.first[(0u + _e997)] = _e995;
                                    let _e1003 = local_1.group_mask;
                                    let _e1005 = local_1.len;
                                    if (_e1005 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.mask[(0u + _e1005)] = _e1003;
                                    let _e1012 = local_1.len;
                                    local_1.len = (_e1012 + 1u);
                                }
                            }
                            local_1.group = (0u + _e976);
                            let _e1016 = local_3;
                            local_1.group_mask = ((_e1016 & 4278190080u) | (_e980 >> bitcast<u32>(24i)));
                        }
                        let _e1021 = local_4;
                        phi_1560_ = _e581;
                        phi_1563_ = (_e1021 & 16777215u);
                        loop {
                            let _e1024 = phi_1560_;
                            let _e1026 = phi_1563_;
                            local_5 = _e1024;
                            if (_e1026 == 0u) {
                                phi_1561_ = lt_bvh_Hit();
                                phi_1564_ = u32();
                                phi_2222_ = false;
                            } else {
                                let _e1030 = nodes.member[(0u + _e583)].links[1u];
                                let _e1035 = ((0u + _e1030) + select(firstTrailingBit(_e1026), 32u, (_e1026 == 0u)));
                                if (_e1035 < _e80) {
                                } else {
                                    return;
                                }
                                let _e1042 = triangles.member[(0u + _e1035)].v0_;
                                let _e1045 = (_e1042.x - _e176.origin.x);
                                let _e1048 = (_e1042.y - _e176.origin.y);
                                let _e1051 = (_e1042.z - _e176.origin.z);
                                if (_e410 == 0u) {
                                    phi_1610_ = vec3<f32>(_e1048, _e1051, _e1045);
                                } else {
                                    if (_e410 == 1u) {
                                        phi_1609_ = vec3<f32>(_e1051, _e1045, _e1048);
                                    } else {
                                        phi_1609_ = (_e1042 - _e176.origin);
                                    }
                                    let _e1058 = phi_1609_;
                                    phi_1610_ = _e1058;
                                }
                                let _e1060 = phi_1610_;
                                let _e1064 = (_e1060.x - (_e427 * _e1060.z));
                                let _e1068 = (_e1060.y - (_e430 * _e1060.z));
                                let _e1070 = triangles.member[(0u + _e1035)].v1_;
                                let _e1073 = (_e1070.x - _e176.origin.x);
                                let _e1076 = (_e1070.y - _e176.origin.y);
                                let _e1079 = (_e1070.z - _e176.origin.z);
                                if (_e410 == 0u) {
                                    phi_1642_ = vec3<f32>(_e1076, _e1079, _e1073);
                                } else {
                                    if (_e410 == 1u) {
                                        phi_1641_ = vec3<f32>(_e1079, _e1073, _e1076);
                                    } else {
                                        phi_1641_ = (_e1070 - _e176.origin);
                                    }
                                    let _e1086 = phi_1641_;
                                    phi_1642_ = _e1086;
                                }
                                let _e1088 = phi_1642_;
                                let _e1092 = (_e1088.x - (_e427 * _e1088.z));
                                let _e1096 = (_e1088.y - (_e430 * _e1088.z));
                                let _e1098 = triangles.member[(0u + _e1035)].v2_;
                                let _e1101 = (_e1098.x - _e176.origin.x);
                                let _e1104 = (_e1098.y - _e176.origin.y);
                                let _e1107 = (_e1098.z - _e176.origin.z);
                                if (_e410 == 0u) {
                                    phi_1674_ = vec3<f32>(_e1104, _e1107, _e1101);
                                } else {
                                    if (_e410 == 1u) {
                                        phi_1673_ = vec3<f32>(_e1107, _e1101, _e1104);
                                    } else {
                                        phi_1673_ = (_e1098 - _e176.origin);
                                    }
                                    let _e1114 = phi_1673_;
                                    phi_1674_ = _e1114;
                                }
                                let _e1116 = phi_1674_;
                                let _e1120 = (_e1116.x - (_e427 * _e1116.z));
                                let _e1124 = (_e1116.y - (_e430 * _e1116.z));
                                if (_e1092 < _e1120) {
                                    phi_1693_ = true;
                                } else {
                                    if (_e1092 == _e1120) {
                                        phi_1692_ = (_e1096 < _e1124);
                                    } else {
                                        phi_1692_ = false;
                                    }
                                    let _e1129 = phi_1692_;
                                    phi_1693_ = _e1129;
                                }
                                let _e1131 = phi_1693_;
                                if _e1131 {
                                    phi_1697_ = _e1124;
                                    phi_1698_ = _e1120;
                                    phi_1699_ = _e1096;
                                    phi_1700_ = _e1092;
                                } else {
                                    phi_1697_ = _e1096;
                                    phi_1698_ = _e1092;
                                    phi_1699_ = _e1124;
                                    phi_1700_ = _e1120;
                                }
                                let _e1133 = phi_1697_;
                                let _e1135 = phi_1698_;
                                let _e1137 = phi_1699_;
                                let _e1139 = phi_1700_;
                                let _e1142 = ((_e1139 * _e1133) - (_e1137 * _e1135));
                                if _e1131 {
                                    phi_1708_ = -(_e1142);
                                } else {
                                    phi_1708_ = _e1142;
                                }
                                let _e1145 = phi_1708_;
                                if (_e1120 < _e1064) {
                                    phi_1719_ = true;
                                } else {
                                    if (_e1120 == _e1064) {
                                        phi_1718_ = (_e1124 < _e1068);
                                    } else {
                                        phi_1718_ = false;
                                    }
                                    let _e1150 = phi_1718_;
                                    phi_1719_ = _e1150;
                                }
                                let _e1152 = phi_1719_;
                                if _e1152 {
                                    phi_1723_ = _e1068;
                                    phi_1724_ = _e1064;
                                    phi_1725_ = _e1124;
                                    phi_1726_ = _e1120;
                                } else {
                                    phi_1723_ = _e1124;
                                    phi_1724_ = _e1120;
                                    phi_1725_ = _e1068;
                                    phi_1726_ = _e1064;
                                }
                                let _e1154 = phi_1723_;
                                let _e1156 = phi_1724_;
                                let _e1158 = phi_1725_;
                                let _e1160 = phi_1726_;
                                let _e1163 = ((_e1160 * _e1154) - (_e1158 * _e1156));
                                if _e1152 {
                                    phi_1734_ = -(_e1163);
                                } else {
                                    phi_1734_ = _e1163;
                                }
                                let _e1166 = phi_1734_;
                                if (_e1064 < _e1092) {
                                    phi_1745_ = true;
                                } else {
                                    if (_e1064 == _e1092) {
                                        phi_1744_ = (_e1068 < _e1096);
                                    } else {
                                        phi_1744_ = false;
                                    }
                                    let _e1171 = phi_1744_;
                                    phi_1745_ = _e1171;
                                }
                                let _e1173 = phi_1745_;
                                if _e1173 {
                                    phi_1749_ = _e1096;
                                    phi_1750_ = _e1092;
                                    phi_1751_ = _e1068;
                                    phi_1752_ = _e1064;
                                } else {
                                    phi_1749_ = _e1068;
                                    phi_1750_ = _e1064;
                                    phi_1751_ = _e1096;
                                    phi_1752_ = _e1092;
                                }
                                let _e1175 = phi_1749_;
                                let _e1177 = phi_1750_;
                                let _e1179 = phi_1751_;
                                let _e1181 = phi_1752_;
                                let _e1184 = ((_e1181 * _e1175) - (_e1179 * _e1177));
                                if _e1173 {
                                    phi_1760_ = -(_e1184);
                                } else {
                                    phi_1760_ = _e1184;
                                }
                                let _e1187 = phi_1760_;
                                if (_e1145 >= 0f) {
                                    if (_e1166 >= 0f) {
                                        if (_e1187 >= 0f) {
                                            phi_1775_ = ((_e1145 + _e1166) + _e1187);
                                            phi_1776_ = false;
                                        } else {
                                            phi_1775_ = f32();
                                            phi_1776_ = true;
                                        }
                                        let _e1194 = phi_1775_;
                                        let _e1196 = phi_1776_;
                                        phi_1777_ = _e1194;
                                        phi_1778_ = _e1196;
                                    } else {
                                        phi_1777_ = f32();
                                        phi_1778_ = true;
                                    }
                                    let _e1198 = phi_1777_;
                                    let _e1200 = phi_1778_;
                                    phi_1779_ = _e1198;
                                    phi_1780_ = _e1200;
                                } else {
                                    phi_1779_ = f32();
                                    phi_1780_ = true;
                                }
                                let _e1202 = phi_1779_;
                                let _e1204 = phi_1780_;
                                if _e1204 {
                                    if (_e1145 <= 0f) {
                                        if (_e1166 <= 0f) {
                                            let _e1207 = (_e1187 <= 0f);
                                            if _e1207 {
                                            }
                                            phi_1798_ = ((_e1145 + _e1166) + _e1187);
                                            phi_1799_ = false;
                                            phi_1800_ = _e1207;
                                        } else {
                                            phi_1798_ = f32();
                                            phi_1799_ = true;
                                            phi_1800_ = false;
                                        }
                                        let _e1211 = phi_1798_;
                                        let _e1213 = phi_1799_;
                                        let _e1215 = phi_1800_;
                                        phi_1801_ = _e1211;
                                        phi_1802_ = _e1213;
                                        phi_1803_ = _e1215;
                                    } else {
                                        phi_1801_ = f32();
                                        phi_1802_ = true;
                                        phi_1803_ = false;
                                    }
                                    let _e1217 = phi_1801_;
                                    let _e1219 = phi_1802_;
                                    let _e1221 = phi_1803_;
                                    if _e1219 {
                                        phi_1807_ = false;
                                    } else {
                                        phi_1807_ = _e1221;
                                    }
                                    let _e1223 = phi_1807_;
                                    phi_1808_ = _e1217;
                                    phi_1809_ = _e1223;
                                } else {
                                    phi_1808_ = _e1202;
                                    phi_1809_ = true;
                                }
                                let _e1225 = phi_1808_;
                                let _e1227 = phi_1809_;
                                if _e1227 {
                                    let _e1228 = (_e1225 == 0f);
                                    if _e1228 {
                                        phi_2135_ = lt_bvh_triangle_Intersection();
                                        phi_2136_ = false;
                                    } else {
                                        let _e1230 = triangles.member[(0u + _e1035)].v0_;
                                        let _e1233 = (_e1230.x - _e176.origin.x);
                                        let _e1236 = (_e1230.y - _e176.origin.y);
                                        let _e1239 = (_e1230.z - _e176.origin.z);
                                        if (_e410 == 0u) {
                                            phi_1840_ = vec3<f32>(_e1236, _e1239, _e1233);
                                        } else {
                                            if (_e410 == 1u) {
                                                phi_1839_ = vec3<f32>(_e1239, _e1233, _e1236);
                                            } else {
                                                phi_1839_ = (_e1230 - _e176.origin);
                                            }
                                            let _e1246 = phi_1839_;
                                            phi_1840_ = _e1246;
                                        }
                                        let _e1248 = phi_1840_;
                                        let _e1250 = triangles.member[(0u + _e1035)].v1_;
                                        let _e1252 = triangles.member[(0u + _e1035)].v0_;
                                        let _e1255 = (_e1250.x - _e1252.x);
                                        let _e1258 = (_e1250.y - _e1252.y);
                                        let _e1261 = (_e1250.z - _e1252.z);
                                        if (_e410 == 0u) {
                                            phi_1866_ = vec3<f32>(_e1258, _e1261, _e1255);
                                        } else {
                                            if (_e410 == 1u) {
                                                phi_1865_ = vec3<f32>(_e1261, _e1255, _e1258);
                                            } else {
                                                phi_1865_ = (_e1250 - _e1252);
                                            }
                                            let _e1268 = phi_1865_;
                                            phi_1866_ = _e1268;
                                        }
                                        let _e1270 = phi_1866_;
                                        let _e1272 = triangles.member[(0u + _e1035)].v2_;
                                        let _e1274 = triangles.member[(0u + _e1035)].v0_;
                                        let _e1277 = (_e1272.x - _e1274.x);
                                        let _e1280 = (_e1272.y - _e1274.y);
                                        let _e1283 = (_e1272.z - _e1274.z);
                                        if (_e410 == 0u) {
                                            phi_1892_ = vec3<f32>(_e1280, _e1283, _e1277);
                                        } else {
                                            if (_e410 == 1u) {
                                                phi_1891_ = vec3<f32>(_e1283, _e1277, _e1280);
                                            } else {
                                                phi_1891_ = (_e1272 - _e1274);
                                            }
                                            let _e1290 = phi_1891_;
                                            phi_1892_ = _e1290;
                                        }
                                        let _e1292 = phi_1892_;
                                        let _e1299 = ((_e1270.y * _e1292.z) - (_e1270.z * _e1292.y));
                                        let _e1306 = ((_e1270.z * _e1292.x) - (_e1270.x * _e1292.z));
                                        let _e1313 = ((_e1270.x * _e1292.y) - (_e1270.y * _e1292.x));
                                        let _e1327 = (((1f / _e424.z) * (((_e1299 * _e1248.x) + (_e1306 * _e1248.y)) + (_e1313 * _e1248.z))) / (((_e1299 * _e427) + (_e1306 * _e430)) + _e1313));
                                        if (_e1327 > _e176.tmin) {
                                            if (_e1327 < _e176.tmax) {
                                                let _e1333 = triangles.member[(0u + _e1035)].v0_;
                                                let _e1335 = triangles.member[(0u + _e1035)].v1_;
                                                if (_e1333.x < _e1335.x) {
                                                    phi_1950_ = _e1333.x;
                                                } else {
                                                    phi_1950_ = _e1335.x;
                                                }
                                                let _e1342 = phi_1950_;
                                                if (_e1333.y < _e1335.y) {
                                                    phi_1959_ = _e1333.y;
                                                } else {
                                                    phi_1959_ = _e1335.y;
                                                }
                                                let _e1349 = phi_1959_;
                                                if (_e1333.z < _e1335.z) {
                                                    phi_1968_ = _e1333.z;
                                                } else {
                                                    phi_1968_ = _e1335.z;
                                                }
                                                let _e1356 = phi_1968_;
                                                let _e1358 = triangles.member[(0u + _e1035)].v2_;
                                                if (_e1342 < _e1358.x) {
                                                    phi_1977_ = _e1342;
                                                } else {
                                                    phi_1977_ = _e1358.x;
                                                }
                                                let _e1363 = phi_1977_;
                                                if (_e1349 < _e1358.y) {
                                                    phi_1984_ = _e1349;
                                                } else {
                                                    phi_1984_ = _e1358.y;
                                                }
                                                let _e1368 = phi_1984_;
                                                if (_e1356 < _e1358.z) {
                                                    phi_1991_ = _e1356;
                                                } else {
                                                    phi_1991_ = _e1358.z;
                                                }
                                                let _e1373 = phi_1991_;
                                                let _e1375 = triangles.member[(0u + _e1035)].v0_;
                                                let _e1377 = triangles.member[(0u + _e1035)].v1_;
                                                if (_e1375.x > _e1377.x) {
                                                    phi_2004_ = _e1375.x;
                                                } else {
                                                    phi_2004_ = _e1377.x;
                                                }
                                                let _e1384 = phi_2004_;
                                                if (_e1375.y > _e1377.y) {
                                                    phi_2013_ = _e1375.y;
                                                } else {
                                                    phi_2013_ = _e1377.y;
                                                }
                                                let _e1391 = phi_2013_;
                                                if (_e1375.z > _e1377.z) {
                                                    phi_2022_ = _e1375.z;
                                                } else {
                                                    phi_2022_ = _e1377.z;
                                                }
                                                let _e1398 = phi_2022_;
                                                let _e1400 = triangles.member[(0u + _e1035)].v2_;
                                                if (_e1384 > _e1400.x) {
                                                    phi_2031_ = _e1384;
                                                } else {
                                                    phi_2031_ = _e1400.x;
                                                }
                                                let _e1405 = phi_2031_;
                                                if (_e1391 > _e1400.y) {
                                                    phi_2038_ = _e1391;
                                                } else {
                                                    phi_2038_ = _e1400.y;
                                                }
                                                let _e1410 = phi_2038_;
                                                if (_e1398 > _e1400.z) {
                                                    phi_2045_ = _e1398;
                                                } else {
                                                    phi_2045_ = _e1400.z;
                                                }
                                                let _e1415 = phi_2045_;
                                                let _e1422 = ((_e1363 - _e176.origin.x) * _e322);
                                                let _e1423 = ((_e1368 - _e176.origin.y) * _e333);
                                                let _e1424 = ((_e1373 - _e176.origin.z) * _e344);
                                                let _e1431 = ((_e1405 - _e176.origin.x) * _e322);
                                                let _e1432 = ((_e1410 - _e176.origin.y) * _e333);
                                                let _e1433 = ((_e1415 - _e176.origin.z) * _e344);
                                                if (_e1422 < _e1431) {
                                                    phi_2068_ = _e1422;
                                                } else {
                                                    phi_2068_ = _e1431;
                                                }
                                                let _e1436 = phi_2068_;
                                                if (_e1423 < _e1432) {
                                                    phi_2073_ = _e1423;
                                                } else {
                                                    phi_2073_ = _e1432;
                                                }
                                                let _e1439 = phi_2073_;
                                                if (_e1424 < _e1433) {
                                                    phi_2078_ = _e1424;
                                                } else {
                                                    phi_2078_ = _e1433;
                                                }
                                                let _e1442 = phi_2078_;
                                                if (_e1422 > _e1431) {
                                                    phi_2086_ = _e1422;
                                                } else {
                                                    phi_2086_ = _e1431;
                                                }
                                                let _e1448 = phi_2086_;
                                                if (_e1423 > _e1432) {
                                                    phi_2091_ = _e1423;
                                                } else {
                                                    phi_2091_ = _e1432;
                                                }
                                                let _e1451 = phi_2091_;
                                                if (_e1424 > _e1433) {
                                                    phi_2096_ = _e1424;
                                                } else {
                                                    phi_2096_ = _e1433;
                                                }
                                                let _e1454 = phi_2096_;
                                                let _e1458 = core_intrinsics_maximum_number_nsz_f32_((_e1436 - _e389), (_e1439 - _e390));
                                                let _e1459 = core_intrinsics_maximum_number_nsz_f32_(_e1458, (_e1442 - _e391));
                                                let _e1460 = core_intrinsics_minimum_number_nsz_f32_((_e1448 + _e389), (_e1451 + _e390));
                                                let _e1461 = core_intrinsics_minimum_number_nsz_f32_(_e1460, (_e1454 + _e391));
                                                if (_e1459 > -300000000000000000000000000000000000000f) {
                                                    phi_2108_ = _e1459;
                                                } else {
                                                    phi_2108_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1464 = phi_2108_;
                                                if (_e1461 < 300000000000000000000000000000000000000f) {
                                                    phi_2113_ = _e1461;
                                                } else {
                                                    phi_2113_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1467 = phi_2113_;
                                                if (_e1327 < _e1464) {
                                                    phi_2118_ = _e1464;
                                                } else {
                                                    phi_2118_ = _e1327;
                                                }
                                                let _e1470 = phi_2118_;
                                                if (_e1470 > _e1467) {
                                                    phi_2123_ = _e1467;
                                                } else {
                                                    phi_2123_ = _e1470;
                                                }
                                                let _e1473 = phi_2123_;
                                                phi_2128_ = lt_bvh_triangle_Intersection(_e1473, (_e1166 / _e1225), (_e1187 / _e1225), (_e1464 <= _e1467));
                                                phi_2129_ = false;
                                            } else {
                                                phi_2128_ = lt_bvh_triangle_Intersection();
                                                phi_2129_ = true;
                                            }
                                            let _e1479 = phi_2128_;
                                            let _e1481 = phi_2129_;
                                            phi_2130_ = _e1479;
                                            phi_2131_ = _e1481;
                                        } else {
                                            phi_2130_ = lt_bvh_triangle_Intersection();
                                            phi_2131_ = true;
                                        }
                                        let _e1483 = phi_2130_;
                                        let _e1485 = phi_2131_;
                                        if _e1485 {
                                        }
                                        phi_2135_ = _e1483;
                                        phi_2136_ = _e1485;
                                    }
                                    let _e1487 = phi_2135_;
                                    let _e1489 = phi_2136_;
                                    phi_2137_ = _e1487;
                                    phi_2138_ = _e1228;
                                    phi_2139_ = _e1489;
                                } else {
                                    phi_2137_ = lt_bvh_triangle_Intersection();
                                    phi_2138_ = true;
                                    phi_2139_ = false;
                                }
                                let _e1491 = phi_2137_;
                                let _e1493 = phi_2138_;
                                let _e1495 = phi_2139_;
                                if _e1493 {
                                    phi_2143_ = true;
                                } else {
                                    phi_2143_ = _e1495;
                                }
                                let _e1497 = phi_2143_;
                                if _e1497 {
                                    phi_2147_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_2147_ = _e1491;
                                }
                                let _e1499 = phi_2147_;
                                if _e1499.is_hit {
                                    if (_e1499.t > _e176.tmin) {
                                        if (_e1499.t < _e1024.t) {
                                            phi_2196_ = true;
                                        } else {
                                            if (_e1499.t == _e1024.t) {
                                                if (_e1024.triangle != 4294967295u) {
                                                    if (_e1035 < _e1024.triangle) {
                                                        phi_2187_ = true;
                                                    } else {
                                                        if (_e1035 == _e1024.triangle) {
                                                            phi_2186_ = (4294967295u < _e1024.instance);
                                                        } else {
                                                            phi_2186_ = false;
                                                        }
                                                        let _e1518 = phi_2186_;
                                                        phi_2187_ = _e1518;
                                                    }
                                                    let _e1520 = phi_2187_;
                                                    phi_2188_ = _e1520;
                                                    phi_2189_ = false;
                                                } else {
                                                    phi_2188_ = bool();
                                                    phi_2189_ = true;
                                                }
                                                let _e1522 = phi_2188_;
                                                let _e1524 = phi_2189_;
                                                phi_2190_ = _e1522;
                                                phi_2191_ = _e1524;
                                            } else {
                                                phi_2190_ = bool();
                                                phi_2191_ = true;
                                            }
                                            let _e1526 = phi_2190_;
                                            let _e1528 = phi_2191_;
                                            if _e1528 {
                                                phi_2195_ = false;
                                            } else {
                                                phi_2195_ = _e1526;
                                            }
                                            let _e1530 = phi_2195_;
                                            phi_2196_ = _e1530;
                                        }
                                        let _e1532 = phi_2196_;
                                        if _e1532 {
                                            let _e1534 = triangles.member[(0u + _e1035)].i0_;
                                            if ((_e1534 & 2147483648u) == 0u) {
                                                phi_2210_ = true;
                                            } else {
                                                if true {
                                                }
                                                phi_2210_ = true;
                                            }
                                            let _e1538 = phi_2210_;
                                            if _e1538 {
                                                phi_2218_ = lt_bvh_Hit(_e1499.t, _e1499.u, _e1499.v, _e1035, 4294967295u);
                                            } else {
                                                phi_2218_ = _e1024;
                                            }
                                            let _e1544 = phi_2218_;
                                            phi_2219_ = _e1544;
                                        } else {
                                            phi_2219_ = _e1024;
                                        }
                                        let _e1546 = phi_2219_;
                                        phi_2220_ = _e1546;
                                    } else {
                                        phi_2220_ = _e1024;
                                    }
                                    let _e1548 = phi_2220_;
                                    phi_2221_ = _e1548;
                                } else {
                                    phi_2221_ = _e1024;
                                }
                                let _e1550 = phi_2221_;
                                phi_1561_ = _e1550;
                                phi_1564_ = (_e1026 & (_e1026 - 1u));
                                phi_2222_ = true;
                            }
                            let _e1552 = phi_1561_;
                            let _e1554 = phi_1564_;
                            let _e1556 = phi_2222_;
                            continue;
                            continuing {
                                phi_1560_ = _e1552;
                                phi_1563_ = _e1554;
                                break if !(_e1556);
                            }
                        }
                        let _e1559 = local_1.group_mask;
                        if ((_e1559 & 4278190080u) == 0u) {
                            let _e1563 = local_1.len;
                            if (_e1563 == 0u) {
                                phi_2261_ = false;
                            } else {
                                let _e1567 = local_1.len;
                                local_1.len = (_e1567 - 1u);
                                let _e1570 = local_1.len;
                                if (_e1570 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1575 = local_1.first[(0u + _e1570)];
                                local_1.group = _e1575;
                                let _e1578 = local_1.len;
                                if (_e1578 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1583 = local_1.mask[(0u + _e1578)];
                                local_1.group_mask = _e1583;
                                phi_2261_ = true;
                            }
                            let _e1586 = phi_2261_;
                            phi_2262_ = _e1586;
                        } else {
                            phi_2262_ = true;
                        }
                        let _e1588 = phi_2262_;
                        if _e1588 {
                            let _e1590 = local_1.group_mask;
                            let _e1596 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1590)), 32u, (_e1590 == 0u)));
                            let _e1600 = local_1.group_mask;
                            let _e1614 = local_1.group_mask;
                            local_1.group_mask = (_e1614 & ~((1u << bitcast<u32>((_e1596 & 31u)))));
                            let _e1617 = local_1.group;
                            phi_2293_ = (_e1617 + countOneBits(((_e1600 & ~((4294967295u << bitcast<u32>((((_e1596 - 24u) ^ _e443) & 31u))))) & 255u)));
                        } else {
                            phi_2293_ = 4294967295u;
                        }
                        let _e1620 = phi_2293_;
                        let _e2538 = local_5;
                        phi_1224_ = _e2538;
                        phi_1227_ = _e1620;
                    } else {
                        phi_1224_ = lt_bvh_Hit();
                        phi_1227_ = u32();
                    }
                    let _e1622 = phi_1224_;
                    let _e1624 = phi_1227_;
                    continue;
                    continuing {
                        phi_1223_ = _e1622;
                        phi_1226_ = _e1624;
                        break if !(_e584);
                    }
                }
                let _e2542 = local_6;
                phi_2294_ = _e2542;
            }
            let _e1627 = phi_2294_;
            phi_2295_ = _e1627;
            phi_2296_ = _e240;
        } else {
            phi_2295_ = lt_bvh_Hit();
            phi_2296_ = true;
        }
        let _e1629 = phi_2295_;
        let _e1631 = phi_2296_;
        if _e1631 {
            phi_2300_ = _e178;
        } else {
            phi_2300_ = _e1629;
        }
        let _e1633 = phi_2300_;
        if (_e1633.triangle != 4294967295u) {
            let _e1639 = ((1f - _e1633.u) - _e1633.v);
            if (_e1633.triangle < _e80) {
            } else {
                return;
            }
            let _e1644 = triangles.member[(0u + _e1633.triangle)];
            let _e1669 = (((_e1644.v0_.x * _e1639) + (_e1644.v1_.x * _e1633.u)) + (_e1644.v2_.x * _e1633.v));
            let _e1670 = (((_e1644.v0_.y * _e1639) + (_e1644.v1_.y * _e1633.u)) + (_e1644.v2_.y * _e1633.v));
            let _e1671 = (((_e1644.v0_.z * _e1639) + (_e1644.v1_.z * _e1633.u)) + (_e1644.v2_.z * _e1633.v));
            let _e1674 = abs(_e1644.v0_.x);
            let _e1676 = abs(_e1644.v0_.y);
            let _e1678 = abs(_e1644.v0_.z);
            let _e1680 = abs(_e1644.v1_.x);
            let _e1682 = abs(_e1644.v1_.y);
            let _e1684 = abs(_e1644.v1_.z);
            if (_e1674 > _e1680) {
                phi_2364_ = _e1674;
            } else {
                phi_2364_ = _e1680;
            }
            let _e1687 = phi_2364_;
            if (_e1676 > _e1682) {
                phi_2369_ = _e1676;
            } else {
                phi_2369_ = _e1682;
            }
            let _e1690 = phi_2369_;
            if (_e1678 > _e1684) {
                phi_2374_ = _e1678;
            } else {
                phi_2374_ = _e1684;
            }
            let _e1693 = phi_2374_;
            let _e1695 = abs(_e1644.v2_.x);
            let _e1697 = abs(_e1644.v2_.y);
            let _e1699 = abs(_e1644.v2_.z);
            if (_e1687 > _e1695) {
                phi_2385_ = _e1687;
            } else {
                phi_2385_ = _e1695;
            }
            let _e1702 = phi_2385_;
            if (_e1690 > _e1697) {
                phi_2390_ = _e1690;
            } else {
                phi_2390_ = _e1697;
            }
            let _e1705 = phi_2390_;
            if (_e1693 > _e1699) {
                phi_2395_ = _e1693;
            } else {
                phi_2395_ = _e1699;
            }
            let _e1708 = phi_2395_;
            let _e1711 = (_e1644.v1_.x - _e1644.v0_.x);
            let _e1714 = (_e1644.v1_.y - _e1644.v0_.y);
            let _e1717 = (_e1644.v1_.z - _e1644.v0_.z);
            let _e1720 = (_e1644.v2_.x - _e1644.v0_.x);
            let _e1723 = (_e1644.v2_.y - _e1644.v0_.y);
            let _e1726 = (_e1644.v2_.z - _e1644.v0_.z);
            let _e1730 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1714), abs(_e1717));
            let _e1731 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1711), _e1730);
            let _e1732 = (_e1711 / _e1731);
            let _e1733 = (_e1714 / _e1731);
            let _e1734 = (_e1717 / _e1731);
            let _e1738 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1723), abs(_e1726));
            let _e1739 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1720), _e1738);
            let _e1740 = (_e1720 / _e1739);
            let _e1741 = (_e1723 / _e1739);
            let _e1742 = (_e1726 / _e1739);
            let _e1745 = ((_e1733 * _e1742) - (_e1741 * _e1734));
            let _e1748 = ((_e1734 * _e1740) - (_e1742 * _e1732));
            let _e1751 = ((_e1732 * _e1741) - (_e1740 * _e1733));
            let _e1753 = p.member.eye;
            let _e1766 = (1f / sqrt((((_e1745 * _e1745) + (_e1748 * _e1748)) + (_e1751 * _e1751))));
            let _e1767 = (_e1745 * _e1766);
            let _e1768 = (_e1748 * _e1766);
            let _e1769 = (_e1751 * _e1766);
            if ((((_e1767 * (_e1753.x - _e1669)) + (_e1768 * (_e1753.y - _e1670))) + (_e1769 * (_e1753.z - _e1671))) < 0f) {
                phi_2471_ = vec3<f32>(-(_e1767), -(_e1768), -(_e1769));
            } else {
                phi_2471_ = vec3<f32>(_e1767, _e1768, _e1769);
            }
            let _e1782 = phi_2471_;
            if (_e1633.triangle < _e80) {
            } else {
                return;
            }
            let _e1787 = triangles.member[(0u + _e1633.triangle)];
            let _e1789 = (_e1787.i0_ & 2147483647u);
            if (_e1789 < _e83) {
            } else {
                return;
            }
            let _e1795 = vertices.member[(0u + _e1789)];
            if (_e1787.i1_ < _e83) {
            } else {
                return;
            }
            let _e1799 = vertices.member[(0u + _e1787.i1_)];
            if (_e1787.i2_ < _e83) {
            } else {
                return;
            }
            let _e1803 = vertices.member[(0u + _e1787.i2_)];
            let _e1804 = array<abi_Vertex, 3>(_e1795, _e1799, _e1803);
            if (_e1804[0].material < arrayLength((&materials.member))) {
            } else {
                return;
            }
            let _e1810 = materials.member[(0u + _e1804[0].material)];
            let _e1827 = (1f / 255f);
            let _e1846 = (1f / 255f);
            let _e1868 = (1f / 255f);
            if (_e1810.color_size == 0u) {
                phi_2714_ = vec3<f32>(1f, 1f, 1f);
            } else {
                local.offset = _e1810.color_offset;
                local.size = _e1810.color_size;
                local.flags = _e1810.flags;
                let _e1911 = _lt_shaders_texture_TextureView_quad((&local), (((_e1804[0].u * _e1639) + (_e1804[1].u * _e1633.u)) + (_e1804[2].u * _e1633.v)), (((_e1804[0].v * _e1639) + (_e1804[1].v * _e1633.u)) + (_e1804[2].v * _e1633.v)));
                if (_e1911.indices[0] < _e92) {
                } else {
                    return;
                }
                let _e1917 = color_texels.member[(0u + _e1911.indices[0])];
                let _e1928 = (1f / 255f);
                if (_e1911.indices[1] < _e92) {
                } else {
                    return;
                }
                let _e1942 = color_texels.member[(0u + _e1911.indices[1])];
                let _e1953 = (1f / 255f);
                if (_e1911.indices[2] < _e92) {
                } else {
                    return;
                }
                let _e1970 = color_texels.member[(0u + _e1911.indices[2])];
                let _e1981 = (1f / 255f);
                if (_e1911.indices[3] < _e92) {
                } else {
                    return;
                }
                let _e1998 = color_texels.member[(0u + _e1911.indices[3])];
                let _e2009 = (1f / 255f);
                let _e2018 = (((((f32((_e1917 & 255u)) * _e1928) * _e1911.weights.x) + ((f32((_e1942 & 255u)) * _e1953) * _e1911.weights.y)) + ((f32((_e1970 & 255u)) * _e1981) * _e1911.weights.z)) + ((f32((_e1998 & 255u)) * _e2009) * _e1911.weights.w));
                let _e2019 = (((((f32(((_e1917 >> bitcast<u32>(8i)) & 255u)) * _e1928) * _e1911.weights.x) + ((f32(((_e1942 >> bitcast<u32>(8i)) & 255u)) * _e1953) * _e1911.weights.y)) + ((f32(((_e1970 >> bitcast<u32>(8i)) & 255u)) * _e1981) * _e1911.weights.z)) + ((f32(((_e1998 >> bitcast<u32>(8i)) & 255u)) * _e2009) * _e1911.weights.w));
                let _e2020 = (((((f32(((_e1917 >> bitcast<u32>(16i)) & 255u)) * _e1928) * _e1911.weights.x) + ((f32(((_e1942 >> bitcast<u32>(16i)) & 255u)) * _e1953) * _e1911.weights.y)) + ((f32(((_e1970 >> bitcast<u32>(16i)) & 255u)) * _e1981) * _e1911.weights.z)) + ((f32(((_e1998 >> bitcast<u32>(16i)) & 255u)) * _e2009) * _e1911.weights.w));
                phi_2714_ = vec3<f32>((_e2018 * _e2018), (_e2019 * _e2019), (_e2020 * _e2020));
            }
            let _e2026 = phi_2714_;
            let _e2028 = ((_e1810.base_color.x * ((((f32((_e1804[0].color & 255u)) * _e1827) * _e1639) + ((f32((_e1804[1].color & 255u)) * _e1846) * _e1633.u)) + ((f32((_e1804[2].color & 255u)) * _e1868) * _e1633.v))) * _e2026.x);
            let _e2030 = ((_e1810.base_color.y * ((((f32(((_e1804[0].color >> bitcast<u32>(8i)) & 255u)) * _e1827) * _e1639) + ((f32(((_e1804[1].color >> bitcast<u32>(8i)) & 255u)) * _e1846) * _e1633.u)) + ((f32(((_e1804[2].color >> bitcast<u32>(8i)) & 255u)) * _e1868) * _e1633.v))) * _e2026.y);
            let _e2032 = ((_e1810.base_color.z * ((((f32(((_e1804[0].color >> bitcast<u32>(16i)) & 255u)) * _e1827) * _e1639) + ((f32(((_e1804[1].color >> bitcast<u32>(16i)) & 255u)) * _e1846) * _e1633.u)) + ((f32(((_e1804[2].color >> bitcast<u32>(16i)) & 255u)) * _e1868) * _e1633.v))) * _e2026.z);
            let _e2033 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1705, _e1708);
            let _e2034 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1702, _e2033);
            if ((_e1810.flags & 2u) == 0u) {
                phi_2729_ = 0u;
            } else {
                phi_2729_ = 1u;
            }
            let _e2039 = phi_2729_;
            if (_e1804[0].normal == 2147516416u) {
                phi_2932_ = _e1782;
            } else {
                let _e2052 = (f32((bitcast<i32>((_e1804[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2058 = (f32((bitcast<i32>(_e1804[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2062 = ((1f - abs(_e2052)) - abs(_e2058));
                if (_e2062 < 0f) {
                    phi_2756_ = -(_e2062);
                } else {
                    phi_2756_ = 0f;
                }
                let _e2066 = phi_2756_;
                if (_e2052 < 0f) {
                    phi_2763_ = (_e2052 + _e2066);
                } else {
                    phi_2763_ = (_e2052 - _e2066);
                }
                let _e2071 = phi_2763_;
                if (_e2058 < 0f) {
                    phi_2770_ = (_e2058 + _e2066);
                } else {
                    phi_2770_ = (_e2058 - _e2066);
                }
                let _e2076 = phi_2770_;
                let _e2083 = (1f / sqrt((((_e2071 * _e2071) + (_e2076 * _e2076)) + (_e2062 * _e2062))));
                let _e2099 = (f32((bitcast<i32>((_e1804[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2105 = (f32((bitcast<i32>(_e1804[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2109 = ((1f - abs(_e2099)) - abs(_e2105));
                if (_e2109 < 0f) {
                    phi_2805_ = -(_e2109);
                } else {
                    phi_2805_ = 0f;
                }
                let _e2113 = phi_2805_;
                if (_e2099 < 0f) {
                    phi_2812_ = (_e2099 + _e2113);
                } else {
                    phi_2812_ = (_e2099 - _e2113);
                }
                let _e2118 = phi_2812_;
                if (_e2105 < 0f) {
                    phi_2819_ = (_e2105 + _e2113);
                } else {
                    phi_2819_ = (_e2105 - _e2113);
                }
                let _e2123 = phi_2819_;
                let _e2130 = (1f / sqrt((((_e2118 * _e2118) + (_e2123 * _e2123)) + (_e2109 * _e2109))));
                let _e2149 = (f32((bitcast<i32>((_e1804[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2155 = (f32((bitcast<i32>(_e1804[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2159 = ((1f - abs(_e2149)) - abs(_e2155));
                if (_e2159 < 0f) {
                    phi_2857_ = -(_e2159);
                } else {
                    phi_2857_ = 0f;
                }
                let _e2163 = phi_2857_;
                if (_e2149 < 0f) {
                    phi_2864_ = (_e2149 + _e2163);
                } else {
                    phi_2864_ = (_e2149 - _e2163);
                }
                let _e2168 = phi_2864_;
                if (_e2155 < 0f) {
                    phi_2871_ = (_e2155 + _e2163);
                } else {
                    phi_2871_ = (_e2155 - _e2163);
                }
                let _e2173 = phi_2871_;
                let _e2180 = (1f / sqrt((((_e2168 * _e2168) + (_e2173 * _e2173)) + (_e2159 * _e2159))));
                let _e2191 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(vec3<f32>(((((_e2071 * _e2083) * _e1639) + ((_e2118 * _e2130) * _e1633.u)) + ((_e2168 * _e2180) * _e1633.v)), ((((_e2076 * _e2083) * _e1639) + ((_e2123 * _e2130) * _e1633.u)) + ((_e2173 * _e2180) * _e1633.v)), ((((_e2062 * _e2083) * _e1639) + ((_e2109 * _e2130) * _e1633.u)) + ((_e2159 * _e2180) * _e1633.v))));
                let _e2203 = sqrt((((_e2191.x * _e2191.x) + (_e2191.y * _e2191.y)) + (_e2191.z * _e2191.z)));
                if (_e2203 > 0f) {
                    let _e2206 = (_e2191.x / _e2203);
                    let _e2208 = (_e2191.y / _e2203);
                    let _e2210 = (_e2191.z / _e2203);
                    if ((((_e2206 * _e1782.x) + (_e2208 * _e1782.y)) + (_e2210 * _e1782.z)) < 0f) {
                        phi_2930_ = vec3<f32>(-(_e2206), -(_e2208), -(_e2210));
                    } else {
                        phi_2930_ = (_e2191 / vec3(_e2203));
                    }
                    let _e2227 = phi_2930_;
                    phi_2931_ = _e2227;
                } else {
                    phi_2931_ = _e1782;
                }
                let _e2229 = phi_2931_;
                phi_2932_ = _e2229;
            }
            let _e2231 = phi_2932_;
            if (_e2028 > 0f) {
                if (_e2028 < 1f) {
                    phi_2941_ = _e2028;
                } else {
                    phi_2941_ = 1f;
                }
                let _e2235 = phi_2941_;
                phi_2942_ = _e2235;
            } else {
                phi_2942_ = 0f;
            }
            let _e2237 = phi_2942_;
            if (_e2030 > 0f) {
                if (_e2030 < 1f) {
                    phi_2952_ = _e2030;
                } else {
                    phi_2952_ = 1f;
                }
                let _e2242 = phi_2952_;
                phi_2953_ = _e2242;
            } else {
                phi_2953_ = 0f;
            }
            let _e2244 = phi_2953_;
            if (_e2032 > 0f) {
                if (_e2032 < 1f) {
                    phi_2963_ = _e2032;
                } else {
                    phi_2963_ = 1f;
                }
                let _e2249 = phi_2963_;
                phi_2964_ = _e2249;
            } else {
                phi_2964_ = 0f;
            }
            let _e2251 = phi_2964_;
            let _e2254 = ((sqrt(_e2237) * 255f) + 0.5f);
            let _e2263 = ((sqrt(_e2244) * 255f) + 0.5f);
            let _e2275 = ((sqrt(_e2251) * 255f) + 0.5f);
            phi_2999_ = abi_Sample(vec3<f32>(_e1669, _e1670, _e1671), _e2034, _e1782, _e2039, _e2231, ((select(select(u32(_e2254), 0u, (_e2254 < bitcast<f32>(0u))), 4294967295u, (_e2254 > bitcast<f32>(1333788671u))) | (select(select(u32(_e2263), 0u, (_e2263 < bitcast<f32>(0u))), 4294967295u, (_e2263 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e2275), 0u, (_e2275 < bitcast<f32>(0u))), 4294967295u, (_e2275 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_2999_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e2289 = phi_2999_;
        if (_e104.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e104.first_primitive)] = _e2289;
        if (_e1633.triangle != 4294967295u) {
            let _e2298 = ((1f - _e1633.u) - _e1633.v);
            if (_e1633.triangle < _e80) {
            } else {
                return;
            }
            let _e2303 = triangles.member[(0u + _e1633.triangle)];
            let _e2305 = (_e2303.i0_ & 2147483647u);
            if (_e2305 < _e95) {
            } else {
                return;
            }
            let _e2311 = before.member[(0u + _e2305)];
            if (_e2303.i1_ < _e95) {
            } else {
                return;
            }
            let _e2315 = before.member[(0u + _e2303.i1_)];
            if (_e2303.i2_ < _e95) {
            } else {
                return;
            }
            let _e2319 = before.member[(0u + _e2303.i2_)];
            let _e2324 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2311.x, _e2311.y, _e2311.z));
            let _e2335 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2315.x, _e2315.y, _e2315.z));
            let _e2349 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2319.x, _e2319.y, _e2319.z));
            phi_3090_ = vec3<f32>((((_e2324.x * _e2298) + (_e2335.x * _e1633.u)) + (_e2349.x * _e1633.v)), (((_e2324.y * _e2298) + (_e2335.y * _e1633.u)) + (_e2349.y * _e1633.v)), (((_e2324.z * _e2298) + (_e2335.z * _e1633.u)) + (_e2349.z * _e1633.v)));
        } else {
            phi_3090_ = vec3<f32>(0f, 0f, 0f);
        }
        let _e2361 = phi_3090_;
        if (_e104.first_primitive < arrayLength((&past.member))) {
        } else {
            return;
        }
        past.member[(0u + _e104.first_primitive)] = vec4<f32>(_e2361.x, _e2361.y, _e2361.z, 1f);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_color_motion_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
