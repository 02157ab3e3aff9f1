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

struct lt_bvh_Instance {
    world_to_object: array<vec4<f32>, 3>,
    object_to_world: array<vec4<f32>, 3>,
    low_world: vec3<f32>,
    root: u32,
    high_world: vec3<f32>,
    first_triangle: u32,
    source: u32,
    padding: array<u32, 3>,
}

struct type_51 {
    member: array<lt_bvh_Instance>,
}

struct lt_bvh_traverse_Stack {
    first: array<u32, 32>,
    mask: array<u32, 32>,
    len: u32,
    group: u32,
    group_mask: u32,
}

struct type_57 {
    member: abi_CameraParams,
}

struct lt_bvh_Node {
    frame: vec4<u32>,
    links: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    z: vec4<u32>,
}

struct type_62 {
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
var<uniform> p: type_57;
@group(0) @binding(1) 
var<storage> nodes: type_62;
@group(0) @binding(2) 
var<storage> triangles: type_32;
@group(0) @binding(5) 
var<storage, read_write> samples: type_9;
@group(0) @binding(6) 
var<storage> instances: type_51;
@group(0) @binding(7) 
var<storage> alpha_texels: type_13;
@group(0) @binding(8) 
var<storage> color_texels: type_13;
@group(0) @binding(9) 
var<storage> before: type_26;
@group(0) @binding(10) 
var<storage, read_write> past: type_26;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_228_: lt_bvh_traverse_Tree;
    var phi_229_: bool;
    var phi_230_: lt_bvh_traverse_Tree;
    var phi_231_: bool;
    var phi_236_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_228_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_229_ = false;
        } else {
            phi_228_ = lt_bvh_traverse_Tree();
            phi_229_ = true;
        }
        let _e85 = phi_228_;
        let _e87 = phi_229_;
        phi_230_ = _e85;
        phi_231_ = _e87;
    } else {
        phi_230_ = lt_bvh_traverse_Tree();
        phi_231_ = true;
    }
    let _e89 = phi_230_;
    let _e91 = phi_231_;
    if _e91 {
        phi_236_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_236_ = _e89;
    }
    let _e96 = phi_236_;
    return lt_bvh_traverse_Tree(_e96.root, _e96.first_primitive);
}

fn _lt_shaders_texture_TextureView_quad(param_3: ptr<function, texture_TextureView>, param_4: f32, param_5: f32) -> texture_TexelQuad {
    var phi_281_: f32;
    var phi_286_: f32;
    var phi_287_: bool;
    var phi_288_: f32;
    var phi_289_: bool;
    var phi_293_: f32;
    var phi_319_: f32;
    var phi_324_: f32;
    var phi_325_: bool;
    var phi_326_: f32;
    var phi_327_: bool;
    var phi_331_: f32;
    var phi_339_: f32;
    var phi_340_: f32;
    var phi_341_: f32;
    var phi_350_: f32;
    var phi_351_: f32;
    var phi_369_: u32;
    var phi_383_: u32;
    var phi_390_: u32;
    var phi_395_: u32;
    var phi_401_: u32;
    var phi_406_: u32;
    var phi_408_: texture_Axis;
    var phi_436_: f32;
    var phi_441_: f32;
    var phi_442_: bool;
    var phi_443_: f32;
    var phi_444_: bool;
    var phi_448_: f32;
    var phi_474_: f32;
    var phi_479_: f32;
    var phi_480_: bool;
    var phi_481_: f32;
    var phi_482_: bool;
    var phi_486_: f32;
    var phi_494_: f32;
    var phi_495_: f32;
    var phi_496_: f32;
    var phi_505_: f32;
    var phi_506_: f32;
    var phi_524_: u32;
    var phi_538_: u32;
    var phi_545_: u32;
    var phi_550_: u32;
    var phi_556_: u32;
    var phi_561_: u32;
    var phi_563_: texture_Axis;

    let _e76 = (*param_3).size;
    let _e77 = (_e76 & 65535u);
    let _e79 = (*param_3).size;
    let _e81 = (_e79 >> bitcast<u32>(16i));
    let _e83 = (*param_3).flags;
    let _e85 = ((_e83 & 4u) != 0u);
    let _e87 = (*param_3).flags;
    let _e90 = ((_e87 >> bitcast<u32>(4u)) & 3u);
    if (_e90 == 0u) {
        if (param_4 > -8388608f) {
            let _e103 = f32(select(0i, select(select(i32(param_4), i32(-2147483648), (param_4 < bitcast<f32>(3472883712u))), 2147483647i, (param_4 > bitcast<f32>(1325400063u))), (param_4 == param_4)));
            if (_e103 > param_4) {
                phi_281_ = 1f;
            } else {
                phi_281_ = 0f;
            }
            let _e106 = phi_281_;
            if (param_4 < 8388608f) {
                phi_286_ = (_e103 - _e106);
                phi_287_ = false;
            } else {
                phi_286_ = f32();
                phi_287_ = true;
            }
            let _e109 = phi_286_;
            let _e111 = phi_287_;
            phi_288_ = _e109;
            phi_289_ = _e111;
        } else {
            phi_288_ = f32();
            phi_289_ = true;
        }
        let _e113 = phi_288_;
        let _e115 = phi_289_;
        if _e115 {
            phi_293_ = param_4;
        } else {
            phi_293_ = _e113;
        }
        let _e117 = phi_293_;
        phi_341_ = (param_4 - _e117);
    } else {
        if (_e90 == 1u) {
            let _e120 = (param_4 * 0.5f);
            if (_e120 > -8388608f) {
                let _e132 = f32(select(0i, select(select(i32(_e120), i32(-2147483648), (_e120 < bitcast<f32>(3472883712u))), 2147483647i, (_e120 > bitcast<f32>(1325400063u))), (_e120 == _e120)));
                if (_e132 > _e120) {
                    phi_319_ = 1f;
                } else {
                    phi_319_ = 0f;
                }
                let _e135 = phi_319_;
                if (_e120 < 8388608f) {
                    phi_324_ = (_e132 - _e135);
                    phi_325_ = false;
                } else {
                    phi_324_ = f32();
                    phi_325_ = true;
                }
                let _e138 = phi_324_;
                let _e140 = phi_325_;
                phi_326_ = _e138;
                phi_327_ = _e140;
            } else {
                phi_326_ = f32();
                phi_327_ = true;
            }
            let _e142 = phi_326_;
            let _e144 = phi_327_;
            if _e144 {
                phi_331_ = _e120;
            } else {
                phi_331_ = _e142;
            }
            let _e146 = phi_331_;
            let _e148 = (param_4 - (2f * _e146));
            if (_e148 > 1f) {
                phi_339_ = (2f - _e148);
            } else {
                phi_339_ = _e148;
            }
            let _e152 = phi_339_;
            phi_340_ = _e152;
        } else {
            phi_340_ = param_4;
        }
        let _e154 = phi_340_;
        phi_341_ = _e154;
    }
    let _e156 = phi_341_;
    if (_e156 > 0f) {
        if (_e156 < 1f) {
            phi_350_ = _e156;
        } else {
            phi_350_ = 1f;
        }
        let _e160 = phi_350_;
        phi_351_ = _e160;
    } else {
        phi_351_ = 0f;
    }
    let _e162 = phi_351_;
    let _e163 = (_e77 - 1u);
    let _e165 = (_e162 * f32(_e77));
    if _e85 {
        let _e172 = select(select(u32(_e165), 0u, (_e165 < bitcast<f32>(0u))), 4294967295u, (_e165 > bitcast<f32>(1333788671u)));
        if (_e163 < _e172) {
            phi_369_ = _e163;
        } else {
            phi_369_ = _e172;
        }
        let _e175 = phi_369_;
        phi_408_ = texture_Axis(_e175, _e175, 0f);
    } else {
        let _e177 = (_e165 + 0.5f);
        let _e184 = select(select(u32(_e177), 0u, (_e177 < bitcast<f32>(0u))), 4294967295u, (_e177 > bitcast<f32>(1333788671u)));
        if (_e77 < _e184) {
            phi_383_ = _e77;
        } else {
            phi_383_ = _e184;
        }
        let _e187 = phi_383_;
        if (_e90 == 0u) {
            phi_390_ = _e163;
        } else {
            phi_390_ = 0u;
        }
        let _e192 = phi_390_;
        if (_e90 == 0u) {
            phi_395_ = 0u;
        } else {
            phi_395_ = _e163;
        }
        let _e195 = phi_395_;
        if (_e187 == 0u) {
            phi_401_ = _e192;
        } else {
            phi_401_ = (_e187 - 1u);
        }
        let _e199 = phi_401_;
        if (_e187 > _e163) {
            phi_406_ = _e195;
        } else {
            phi_406_ = _e187;
        }
        let _e202 = phi_406_;
        phi_408_ = texture_Axis(_e199, _e202, (_e177 - f32(_e187)));
    }
    let _e205 = phi_408_;
    let _e207 = (*param_3).flags;
    let _e210 = ((_e207 >> bitcast<u32>(6u)) & 3u);
    if (_e210 == 0u) {
        if (param_5 > -8388608f) {
            let _e223 = f32(select(0i, select(select(i32(param_5), i32(-2147483648), (param_5 < bitcast<f32>(3472883712u))), 2147483647i, (param_5 > bitcast<f32>(1325400063u))), (param_5 == param_5)));
            if (_e223 > param_5) {
                phi_436_ = 1f;
            } else {
                phi_436_ = 0f;
            }
            let _e226 = phi_436_;
            if (param_5 < 8388608f) {
                phi_441_ = (_e223 - _e226);
                phi_442_ = false;
            } else {
                phi_441_ = f32();
                phi_442_ = true;
            }
            let _e229 = phi_441_;
            let _e231 = phi_442_;
            phi_443_ = _e229;
            phi_444_ = _e231;
        } else {
            phi_443_ = f32();
            phi_444_ = true;
        }
        let _e233 = phi_443_;
        let _e235 = phi_444_;
        if _e235 {
            phi_448_ = param_5;
        } else {
            phi_448_ = _e233;
        }
        let _e237 = phi_448_;
        phi_496_ = (param_5 - _e237);
    } else {
        if (_e210 == 1u) {
            let _e240 = (param_5 * 0.5f);
            if (_e240 > -8388608f) {
                let _e252 = f32(select(0i, select(select(i32(_e240), i32(-2147483648), (_e240 < bitcast<f32>(3472883712u))), 2147483647i, (_e240 > bitcast<f32>(1325400063u))), (_e240 == _e240)));
                if (_e252 > _e240) {
                    phi_474_ = 1f;
                } else {
                    phi_474_ = 0f;
                }
                let _e255 = phi_474_;
                if (_e240 < 8388608f) {
                    phi_479_ = (_e252 - _e255);
                    phi_480_ = false;
                } else {
                    phi_479_ = f32();
                    phi_480_ = true;
                }
                let _e258 = phi_479_;
                let _e260 = phi_480_;
                phi_481_ = _e258;
                phi_482_ = _e260;
            } else {
                phi_481_ = f32();
                phi_482_ = true;
            }
            let _e262 = phi_481_;
            let _e264 = phi_482_;
            if _e264 {
                phi_486_ = _e240;
            } else {
                phi_486_ = _e262;
            }
            let _e266 = phi_486_;
            let _e268 = (param_5 - (2f * _e266));
            if (_e268 > 1f) {
                phi_494_ = (2f - _e268);
            } else {
                phi_494_ = _e268;
            }
            let _e272 = phi_494_;
            phi_495_ = _e272;
        } else {
            phi_495_ = param_5;
        }
        let _e274 = phi_495_;
        phi_496_ = _e274;
    }
    let _e276 = phi_496_;
    if (_e276 > 0f) {
        if (_e276 < 1f) {
            phi_505_ = _e276;
        } else {
            phi_505_ = 1f;
        }
        let _e280 = phi_505_;
        phi_506_ = _e280;
    } else {
        phi_506_ = 0f;
    }
    let _e282 = phi_506_;
    let _e283 = (_e81 - 1u);
    let _e285 = (_e282 * f32(_e81));
    if _e85 {
        let _e292 = select(select(u32(_e285), 0u, (_e285 < bitcast<f32>(0u))), 4294967295u, (_e285 > bitcast<f32>(1333788671u)));
        if (_e283 < _e292) {
            phi_524_ = _e283;
        } else {
            phi_524_ = _e292;
        }
        let _e295 = phi_524_;
        phi_563_ = texture_Axis(_e295, _e295, 0f);
    } else {
        let _e297 = (_e285 + 0.5f);
        let _e304 = select(select(u32(_e297), 0u, (_e297 < bitcast<f32>(0u))), 4294967295u, (_e297 > bitcast<f32>(1333788671u)));
        if (_e81 < _e304) {
            phi_538_ = _e81;
        } else {
            phi_538_ = _e304;
        }
        let _e307 = phi_538_;
        if (_e210 == 0u) {
            phi_545_ = _e283;
        } else {
            phi_545_ = 0u;
        }
        let _e312 = phi_545_;
        if (_e210 == 0u) {
            phi_550_ = 0u;
        } else {
            phi_550_ = _e283;
        }
        let _e315 = phi_550_;
        if (_e307 == 0u) {
            phi_556_ = _e312;
        } else {
            phi_556_ = (_e307 - 1u);
        }
        let _e319 = phi_556_;
        if (_e307 > _e283) {
            phi_561_ = _e315;
        } else {
            phi_561_ = _e307;
        }
        let _e322 = phi_561_;
        phi_563_ = texture_Axis(_e319, _e322, (_e297 - f32(_e307)));
    }
    let _e325 = phi_563_;
    let _e329 = (*param_3).offset;
    let _e336 = (*param_3).offset;
    let _e343 = (*param_3).offset;
    let _e350 = (*param_3).offset;
    return texture_TexelQuad(array<u32, 4>(((_e329 + (_e325.low * _e77)) + _e205.low), ((_e336 + (_e325.low * _e77)) + _e205.high), ((_e343 + (_e325.high * _e77)) + _e205.low), ((_e350 + (_e325.high * _e77)) + _e205.high)), vec4<f32>(((1f - _e205.fraction) * (1f - _e325.fraction)), (_e205.fraction * (1f - _e325.fraction)), ((1f - _e205.fraction) * _e325.fraction), (_e205.fraction * _e325.fraction)));
}

fn _lt_bvh_ray_Ray_new(param_6: vec3<f32>, param_7: vec3<f32>) -> lt_bvh_Ray {
    return lt_bvh_Ray(param_6, 0f, param_7, 300000000000000000000000000000000000000f);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_8: f32, param_9: f32) -> f32 {
    var phi_626_: bool;
    var phi_630_: f32;

    if (param_8 != param_8) {
        phi_626_ = true;
    } else {
        let _e75 = (param_9 >= param_8);
        if _e75 {
        }
        phi_626_ = _e75;
    }
    let _e77 = phi_626_;
    if _e77 {
        phi_630_ = param_9;
    } else {
        phi_630_ = param_8;
    }
    let _e79 = phi_630_;
    return _e79;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_10: f32, param_11: f32) -> f32 {
    var phi_642_: bool;
    var phi_646_: f32;

    if (param_10 != param_10) {
        phi_642_ = true;
    } else {
        let _e75 = (param_11 <= param_10);
        if _e75 {
        }
        phi_642_ = _e75;
    }
    let _e77 = phi_642_;
    if _e77 {
        phi_646_ = param_11;
    } else {
        phi_646_ = param_10;
    }
    let _e79 = phi_646_;
    return _e79;
}

fn _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(param_12: f32, param_13: f32) -> f32 {
    var phi_654_: f32;

    if (param_12 > param_13) {
        phi_654_ = param_12;
    } else {
        phi_654_ = param_13;
    }
    let _e76 = phi_654_;
    return _e76;
}

fn function_() {
    var local: texture_TextureView;
    var local_1: texture_TextureView;
    var local_2: lt_bvh_traverse_Stack;
    var local_3: lt_bvh_traverse_Stack;
    var phi_819_: bool;
    var phi_820_: bool;
    var phi_821_: bool;
    var phi_825_: bool;
    var phi_826_: bool;
    var phi_827_: bool;
    var phi_828_: bool;
    var phi_829_: bool;
    var phi_830_: bool;
    var phi_831_: bool;
    var phi_832_: bool;
    var phi_833_: bool;
    var phi_834_: bool;
    var phi_835_: bool;
    var phi_836_: bool;
    var phi_837_: bool;
    var phi_838_: bool;
    var phi_839_: bool;
    var phi_840_: bool;
    var phi_841_: bool;
    var phi_842_: bool;
    var phi_846_: bool;
    var phi_850_: bool;
    var phi_925_: f32;
    var phi_932_: f32;
    var phi_940_: f32;
    var phi_947_: f32;
    var phi_955_: f32;
    var phi_962_: f32;
    var phi_987_: f32;
    var phi_992_: f32;
    var phi_997_: f32;
    var phi_1019_: u32;
    var phi_1024_: u32;
    var phi_1029_: u32;
    var phi_1143_: bool;
    var phi_1144_: bool;
    var phi_1175_: u32;
    var phi_1177_: u32;
    var phi_1180_: lt_bvh_Hit;
    var phi_1265_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1292_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1319_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1325_: u32;
    var phi_1328_: u32;
    var phi_1342_: u32;
    var phi_1352_: u32;
    var phi_1362_: u32;
    var phi_1380_: u32;
    var phi_1390_: u32;
    var phi_1400_: u32;
    var phi_1436_: u32;
    var phi_1449_: u32;
    var phi_1454_: u32;
    var phi_1455_: u32;
    var phi_1456_: u32;
    var phi_1326_: u32;
    var phi_1329_: u32;
    var local_4: u32;
    var local_5: u32;
    var local_6: u32;
    var phi_1514_: u32;
    var phi_1517_: lt_bvh_Hit;
    var phi_1572_: f32;
    var phi_1577_: f32;
    var phi_1582_: f32;
    var phi_1590_: f32;
    var phi_1595_: f32;
    var phi_1600_: f32;
    var phi_1756_: bool;
    var phi_1757_: bool;
    var phi_1758_: bool;
    var phi_1762_: bool;
    var phi_1763_: bool;
    var phi_1764_: bool;
    var phi_1765_: bool;
    var phi_1766_: bool;
    var phi_1767_: bool;
    var phi_1768_: bool;
    var phi_1769_: bool;
    var phi_1770_: bool;
    var phi_1771_: bool;
    var phi_1772_: bool;
    var phi_1773_: bool;
    var phi_1774_: bool;
    var phi_1775_: bool;
    var phi_1776_: bool;
    var phi_1777_: bool;
    var phi_1778_: bool;
    var phi_1779_: bool;
    var phi_1783_: bool;
    var phi_1787_: bool;
    var phi_1857_: f32;
    var phi_1864_: f32;
    var phi_1871_: f32;
    var phi_1878_: f32;
    var phi_1885_: f32;
    var phi_1892_: f32;
    var phi_1909_: f32;
    var phi_1914_: f32;
    var phi_1919_: f32;
    var phi_1947_: bool;
    var phi_1948_: bool;
    var phi_1956_: u32;
    var phi_1957_: u32;
    var phi_1968_: vec3<f32>;
    var phi_1969_: vec3<f32>;
    var phi_1982_: u32;
    var phi_1987_: u32;
    var phi_1992_: u32;
    var phi_2106_: bool;
    var phi_2107_: bool;
    var phi_2138_: u32;
    var phi_2140_: lt_bvh_Hit;
    var phi_2143_: u32;
    var phi_2224_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2251_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2278_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2284_: u32;
    var phi_2287_: u32;
    var phi_2301_: u32;
    var phi_2311_: u32;
    var phi_2321_: u32;
    var phi_2339_: u32;
    var phi_2349_: u32;
    var phi_2359_: u32;
    var phi_2395_: u32;
    var phi_2408_: u32;
    var phi_2413_: u32;
    var phi_2414_: u32;
    var phi_2415_: u32;
    var phi_2285_: u32;
    var phi_2288_: u32;
    var local_7: u32;
    var local_8: u32;
    var local_9: u32;
    var phi_2473_: lt_bvh_Hit;
    var phi_2476_: u32;
    var phi_2520_: vec3<f32>;
    var phi_2521_: vec3<f32>;
    var phi_2552_: vec3<f32>;
    var phi_2553_: vec3<f32>;
    var phi_2584_: vec3<f32>;
    var phi_2585_: vec3<f32>;
    var phi_2605_: bool;
    var phi_2606_: bool;
    var phi_2610_: f32;
    var phi_2611_: f32;
    var phi_2612_: f32;
    var phi_2613_: f32;
    var phi_2621_: f32;
    var phi_2631_: bool;
    var phi_2632_: bool;
    var phi_2636_: f32;
    var phi_2637_: f32;
    var phi_2638_: f32;
    var phi_2639_: f32;
    var phi_2647_: f32;
    var phi_2657_: bool;
    var phi_2658_: bool;
    var phi_2662_: f32;
    var phi_2663_: f32;
    var phi_2664_: f32;
    var phi_2665_: f32;
    var phi_2673_: f32;
    var phi_2688_: f32;
    var phi_2689_: bool;
    var phi_2690_: f32;
    var phi_2691_: bool;
    var phi_2692_: f32;
    var phi_2693_: bool;
    var phi_2711_: f32;
    var phi_2712_: bool;
    var phi_2713_: bool;
    var phi_2714_: f32;
    var phi_2715_: bool;
    var phi_2716_: bool;
    var phi_2720_: bool;
    var phi_2721_: f32;
    var phi_2722_: bool;
    var phi_2756_: f32;
    var phi_2765_: f32;
    var phi_2774_: f32;
    var phi_2783_: f32;
    var phi_2790_: f32;
    var phi_2797_: f32;
    var phi_2810_: f32;
    var phi_2819_: f32;
    var phi_2828_: f32;
    var phi_2837_: f32;
    var phi_2844_: f32;
    var phi_2851_: f32;
    var phi_2868_: f32;
    var phi_2873_: f32;
    var phi_2878_: f32;
    var phi_2886_: f32;
    var phi_2891_: f32;
    var phi_2896_: f32;
    var phi_2908_: f32;
    var phi_2913_: f32;
    var phi_2918_: f32;
    var phi_2923_: f32;
    var phi_2928_: lt_bvh_triangle_Intersection;
    var phi_2929_: bool;
    var phi_2930_: lt_bvh_triangle_Intersection;
    var phi_2931_: bool;
    var phi_2935_: lt_bvh_triangle_Intersection;
    var phi_2936_: bool;
    var phi_2937_: lt_bvh_triangle_Intersection;
    var phi_2938_: bool;
    var phi_2939_: bool;
    var phi_2943_: bool;
    var phi_2947_: lt_bvh_triangle_Intersection;
    var phi_2985_: bool;
    var phi_2986_: bool;
    var phi_2987_: bool;
    var phi_2988_: bool;
    var phi_2989_: bool;
    var phi_2990_: bool;
    var phi_2994_: bool;
    var phi_2995_: bool;
    var phi_3198_: f32;
    var phi_3201_: bool;
    var phi_3202_: bool;
    var phi_3206_: bool;
    var phi_3214_: lt_bvh_Hit;
    var phi_3215_: lt_bvh_Hit;
    var phi_3216_: lt_bvh_Hit;
    var phi_3217_: lt_bvh_Hit;
    var phi_2474_: lt_bvh_Hit;
    var phi_2477_: u32;
    var phi_3218_: bool;
    var phi_3257_: bool;
    var phi_3258_: bool;
    var phi_3289_: u32;
    var phi_2141_: lt_bvh_Hit;
    var phi_2144_: u32;
    var phi_3290_: lt_bvh_Hit;
    var phi_3291_: lt_bvh_Hit;
    var phi_3292_: bool;
    var phi_3296_: lt_bvh_Hit;
    var phi_3297_: lt_bvh_Hit;
    var phi_3298_: lt_bvh_Hit;
    var phi_3299_: lt_bvh_Hit;
    var phi_1515_: u32;
    var phi_1518_: lt_bvh_Hit;
    var phi_3300_: bool;
    var phi_3339_: bool;
    var phi_3340_: bool;
    var phi_3371_: u32;
    var phi_1178_: u32;
    var phi_1181_: lt_bvh_Hit;
    var phi_3372_: lt_bvh_Hit;
    var phi_3373_: lt_bvh_Hit;
    var phi_3374_: bool;
    var phi_3378_: lt_bvh_Hit;
    var phi_3565_: f32;
    var phi_3570_: f32;
    var phi_3575_: f32;
    var phi_3583_: f32;
    var phi_3588_: f32;
    var phi_3593_: f32;
    var phi_3657_: vec3<f32>;
    var phi_3900_: vec3<f32>;
    var phi_3915_: u32;
    var phi_3942_: f32;
    var phi_3949_: f32;
    var phi_3956_: f32;
    var phi_3991_: f32;
    var phi_3998_: f32;
    var phi_4005_: f32;
    var phi_4043_: f32;
    var phi_4050_: f32;
    var phi_4057_: f32;
    var phi_4143_: vec3<f32>;
    var phi_4144_: vec3<f32>;
    var phi_4145_: vec3<f32>;
    var phi_4154_: f32;
    var phi_4155_: f32;
    var phi_4165_: f32;
    var phi_4166_: f32;
    var phi_4176_: f32;
    var phi_4177_: f32;
    var phi_4212_: abi_Sample;
    var phi_4435_: vec3<f32>;
    var local_10: lt_bvh_Hit;
    var local_11: lt_bvh_Hit;
    var local_12: lt_bvh_Hit;
    var local_13: lt_bvh_Hit;

    let _e76 = id_1;
    let _e80 = arrayLength((&nodes.member));
    let _e83 = arrayLength((&triangles.member));
    let _e86 = arrayLength((&vertices.member));
    let _e89 = arrayLength((&materials.member));
    let _e95 = arrayLength((&instances.member));
    let _e98 = arrayLength((&alpha_texels.member));
    let _e101 = arrayLength((&color_texels.member));
    let _e104 = arrayLength((&before.member));
    let _e110 = p.member.size[0u];
    let _e112 = p.member.size[1u];
    let _e113 = lt_shaders_entry_pixel_index(_e76, _e110, _e112);
    if (bitcast<i32>(_e113.root) != 0i) {
        let _e119 = p.member.root;
        let _e123 = p.member.eye;
        let _e128 = p.member.size[0u];
        let _e132 = ((((f32(_e76.x) + 0.5f) / f32(_e128)) * 2f) - 1f);
        let _e137 = p.member.size[1u];
        let _e141 = (1f - (((f32(_e76.y) + 0.5f) / f32(_e137)) * 2f));
        let _e143 = p.member.forward;
        let _e145 = p.member.right;
        let _e159 = p.member.up;
        let _e170 = _lt_bvh_ray_Ray_new(_e123, vec3<f32>(((_e143.x + (_e145.x * _e132)) + (_e159.x * _e141)), ((_e143.y + (_e145.y * _e132)) + (_e159.y * _e141)), ((_e143.z + (_e145.z * _e132)) + (_e159.z * _e141))));
        let _e172 = lt_bvh_Hit(_e170.tmax, 0f, 0f, 4294967295u, 4294967295u);
        let _e182 = abs(_e170.direction.x);
        let _e184 = abs(_e170.direction.y);
        let _e186 = abs(_e170.direction.z);
        if (abs(_e170.origin.x) < 1000000000000000f) {
            if (abs(_e170.origin.y) < 1000000000000000f) {
                if (abs(_e170.origin.z) < 1000000000000000f) {
                    if (_e182 < 1000000000000000f) {
                        if (_e184 < 1000000000000000f) {
                            if (_e186 < 1000000000000000f) {
                                if (_e182 > 0f) {
                                    phi_820_ = bool();
                                    phi_821_ = true;
                                } else {
                                    let _e194 = (_e184 > 0f);
                                    if _e194 {
                                        phi_819_ = bool();
                                    } else {
                                        phi_819_ = (_e186 > 0f);
                                    }
                                    let _e197 = phi_819_;
                                    phi_820_ = _e197;
                                    phi_821_ = _e194;
                                }
                                let _e199 = phi_820_;
                                let _e201 = phi_821_;
                                if _e201 {
                                    phi_825_ = true;
                                } else {
                                    phi_825_ = _e199;
                                }
                                let _e203 = phi_825_;
                                phi_826_ = _e203;
                                phi_827_ = false;
                            } else {
                                phi_826_ = bool();
                                phi_827_ = true;
                            }
                            let _e205 = phi_826_;
                            let _e207 = phi_827_;
                            phi_828_ = _e205;
                            phi_829_ = false;
                            phi_830_ = _e207;
                        } else {
                            phi_828_ = bool();
                            phi_829_ = true;
                            phi_830_ = false;
                        }
                        let _e209 = phi_828_;
                        let _e211 = phi_829_;
                        let _e213 = phi_830_;
                        phi_831_ = _e209;
                        phi_832_ = _e211;
                        phi_833_ = _e213;
                    } else {
                        phi_831_ = bool();
                        phi_832_ = true;
                        phi_833_ = false;
                    }
                    let _e215 = phi_831_;
                    let _e217 = phi_832_;
                    let _e219 = phi_833_;
                    phi_834_ = _e215;
                    phi_835_ = _e217;
                    phi_836_ = _e219;
                } else {
                    phi_834_ = bool();
                    phi_835_ = true;
                    phi_836_ = false;
                }
                let _e221 = phi_834_;
                let _e223 = phi_835_;
                let _e225 = phi_836_;
                phi_837_ = _e221;
                phi_838_ = _e223;
                phi_839_ = _e225;
            } else {
                phi_837_ = bool();
                phi_838_ = true;
                phi_839_ = false;
            }
            let _e227 = phi_837_;
            let _e229 = phi_838_;
            let _e231 = phi_839_;
            phi_840_ = _e227;
            phi_841_ = _e229;
            phi_842_ = _e231;
        } else {
            phi_840_ = bool();
            phi_841_ = true;
            phi_842_ = false;
        }
        let _e233 = phi_840_;
        let _e235 = phi_841_;
        let _e237 = phi_842_;
        if _e235 {
            phi_846_ = true;
        } else {
            phi_846_ = _e237;
        }
        let _e239 = phi_846_;
        if _e239 {
            phi_850_ = false;
        } else {
            phi_850_ = _e233;
        }
        let _e241 = phi_850_;
        if _e241 {
            let _e242 = (_e119 >= _e80);
            if _e242 {
                phi_3372_ = lt_bvh_Hit();
            } else {
                if (_e119 < _e80) {
                } else {
                    return;
                }
                let _e248 = nodes.member[(0u + _e119)].frame[0u];
                let _e252 = nodes.member[(0u + _e119)].frame[1u];
                let _e256 = nodes.member[(0u + _e119)].frame[2u];
                let _e260 = nodes.member[(0u + _e119)].frame[0u];
                let _e264 = nodes.member[(0u + _e119)].frame[1u];
                let _e268 = nodes.member[(0u + _e119)].frame[2u];
                let _e272 = nodes.member[(0u + _e119)].frame[3u];
                let _e310 = core_intrinsics_maximum_number_nsz_f32_(abs(_e170.direction.x), abs(_e170.direction.y));
                let _e311 = core_intrinsics_maximum_number_nsz_f32_(_e310, abs(_e170.direction.z));
                let _e312 = (_e311 * 0.0000000000009094947f);
                if (abs(_e170.direction.x) < _e312) {
                    phi_925_ = _e312;
                } else {
                    phi_925_ = abs(_e170.direction.x);
                }
                let _e319 = phi_925_;
                if (_e170.direction.x < 0f) {
                    phi_932_ = (-1f / _e319);
                } else {
                    phi_932_ = (1f / _e319);
                }
                let _e324 = phi_932_;
                if (abs(_e170.direction.y) < _e312) {
                    phi_940_ = _e312;
                } else {
                    phi_940_ = abs(_e170.direction.y);
                }
                let _e331 = phi_940_;
                if (_e170.direction.y < 0f) {
                    phi_947_ = (-1f / _e331);
                } else {
                    phi_947_ = (1f / _e331);
                }
                let _e336 = phi_947_;
                if (abs(_e170.direction.z) < _e312) {
                    phi_955_ = _e312;
                } else {
                    phi_955_ = abs(_e170.direction.z);
                }
                let _e343 = phi_955_;
                if (_e170.direction.z < 0f) {
                    phi_962_ = (-1f / _e343);
                } else {
                    phi_962_ = (1f / _e343);
                }
                let _e348 = phi_962_;
                let _e356 = abs((bitcast<f32>(_e248) - _e170.origin.x));
                let _e357 = abs((bitcast<f32>(_e252) - _e170.origin.y));
                let _e358 = abs((bitcast<f32>(_e256) - _e170.origin.z));
                let _e366 = abs(((bitcast<f32>(_e260) + (bitcast<f32>((((_e272 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e170.origin.x));
                let _e367 = abs(((bitcast<f32>(_e264) + (bitcast<f32>((((_e272 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e170.origin.y));
                let _e368 = abs(((bitcast<f32>(_e268) + (bitcast<f32>((((_e272 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e170.origin.z));
                if (_e356 > _e366) {
                    phi_987_ = _e356;
                } else {
                    phi_987_ = _e366;
                }
                let _e371 = phi_987_;
                if (_e357 > _e367) {
                    phi_992_ = _e357;
                } else {
                    phi_992_ = _e367;
                }
                let _e374 = phi_992_;
                if (_e358 > _e368) {
                    phi_997_ = _e358;
                } else {
                    phi_997_ = _e368;
                }
                let _e377 = phi_997_;
                let _e378 = core_intrinsics_maximum_number_nsz_f32_(_e371, _e374);
                let _e379 = core_intrinsics_maximum_number_nsz_f32_(_e378, _e377);
                let _e384 = (_e379 * 0.0000019073486f);
                let _e385 = (abs(_e324) * _e384);
                let _e386 = (abs(_e336) * _e384);
                let _e387 = (abs(_e348) * _e384);
                let _e391 = (_e379 * 0.0000009536743f);
                let _e392 = (abs(_e324) * _e391);
                let _e393 = (abs(_e336) * _e391);
                let _e394 = (abs(_e348) * _e391);
                if (_e324 < 0f) {
                    phi_1019_ = 0u;
                } else {
                    phi_1019_ = 1u;
                }
                let _e397 = phi_1019_;
                if (_e336 < 0f) {
                    phi_1024_ = 0u;
                } else {
                    phi_1024_ = 2u;
                }
                let _e400 = phi_1024_;
                if (_e348 < 0f) {
                    phi_1029_ = 0u;
                } else {
                    phi_1029_ = 4u;
                }
                let _e403 = phi_1029_;
                let _e405 = ((_e397 | _e400) | _e403);
                let _e406 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e119, 2147483648u);
                local_3 = lt_bvh_traverse_Stack(array<u32, 32>(_e406.first[0], _e406.first[1], _e406.first[2], _e406.first[3], _e406.first[4], _e406.first[5], _e406.first[6], _e406.first[7], _e406.first[8], _e406.first[9], _e406.first[10], _e406.first[11], _e406.first[12], _e406.first[13], _e406.first[14], _e406.first[15], _e406.first[16], _e406.first[17], _e406.first[18], _e406.first[19], _e406.first[20], _e406.first[21], _e406.first[22], _e406.first[23], _e406.first[24], _e406.first[25], _e406.first[26], _e406.first[27], _e406.first[28], _e406.first[29], _e406.first[30], _e406.first[31]), array<u32, 32>(_e406.mask[0], _e406.mask[1], _e406.mask[2], _e406.mask[3], _e406.mask[4], _e406.mask[5], _e406.mask[6], _e406.mask[7], _e406.mask[8], _e406.mask[9], _e406.mask[10], _e406.mask[11], _e406.mask[12], _e406.mask[13], _e406.mask[14], _e406.mask[15], _e406.mask[16], _e406.mask[17], _e406.mask[18], _e406.mask[19], _e406.mask[20], _e406.mask[21], _e406.mask[22], _e406.mask[23], _e406.mask[24], _e406.mask[25], _e406.mask[26], _e406.mask[27], _e406.mask[28], _e406.mask[29], _e406.mask[30], _e406.mask[31]), _e406.len, _e406.group, _e406.group_mask);
                let _e480 = local_3.group_mask;
                if ((_e480 & 4278190080u) == 0u) {
                    let _e484 = local_3.len;
                    if (_e484 == 0u) {
                        phi_1143_ = false;
                    } else {
                        let _e488 = local_3.len;
                        local_3.len = (_e488 - 1u);
                        let _e491 = local_3.len;
                        if (_e491 < 32u) {
                        } else {
                            return;
                        }
                        let _e496 = local_3.first[(0u + _e491)];
                        local_3.group = _e496;
                        let _e499 = local_3.len;
                        if (_e499 < 32u) {
                        } else {
                            return;
                        }
                        let _e504 = local_3.mask[(0u + _e499)];
                        local_3.group_mask = _e504;
                        phi_1143_ = true;
                    }
                    let _e507 = phi_1143_;
                    phi_1144_ = _e507;
                } else {
                    phi_1144_ = true;
                }
                let _e509 = phi_1144_;
                if _e509 {
                    let _e511 = local_3.group_mask;
                    let _e517 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e511)), 32u, (_e511 == 0u)));
                    let _e521 = local_3.group_mask;
                    let _e535 = local_3.group_mask;
                    local_3.group_mask = (_e535 & ~((1u << bitcast<u32>((_e517 & 31u)))));
                    let _e538 = local_3.group;
                    phi_1175_ = (_e538 + countOneBits(((_e521 & ~((4294967295u << bitcast<u32>((((_e517 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1175_ = 4294967295u;
                }
                let _e541 = phi_1175_;
                phi_1177_ = _e541;
                phi_1180_ = _e172;
                loop {
                    let _e543 = phi_1177_;
                    let _e545 = phi_1180_;
                    local_13 = _e545;
                    let _e546 = (_e543 != 4294967295u);
                    if _e546 {
                        if (_e543 < _e80) {
                        } else {
                            return;
                        }
                        let _e554 = nodes.member[(0u + _e543)].frame[3u];
                        let _e579 = (bitcast<f32>((((_e554 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e324);
                        let _e580 = (bitcast<f32>((((_e554 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e336);
                        let _e581 = (bitcast<f32>((((_e554 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e348);
                        let _e584 = nodes.member[(0u + _e543)].frame[0u];
                        let _e588 = nodes.member[(0u + _e543)].frame[1u];
                        let _e592 = nodes.member[(0u + _e543)].frame[2u];
                        let _e600 = ((bitcast<f32>(_e584) - _e170.origin.x) * _e324);
                        let _e601 = ((bitcast<f32>(_e588) - _e170.origin.y) * _e336);
                        let _e602 = ((bitcast<f32>(_e592) - _e170.origin.z) * _e348);
                        let _e610 = nodes.member[(0u + _e543)].x;
                        if (_e324 < 0f) {
                            let _e621 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e610.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e627 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e621.unnamed.root, _e610.w), _e621.unnamed_1);
                            let _e633 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e627.unnamed, lt_bvh_traverse_Tree(_e610.x, _e627.unnamed_1.first_primitive));
                            phi_1265_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e633.unnamed, lt_bvh_traverse_Tree(_e633.unnamed_1.root, _e610.y));
                        } else {
                            let _e649 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e610.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e655 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e649.unnamed.root, _e610.y), _e649.unnamed_1);
                            let _e661 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e655.unnamed, lt_bvh_traverse_Tree(_e610.z, _e655.unnamed_1.first_primitive));
                            phi_1265_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e661.unnamed, lt_bvh_traverse_Tree(_e661.unnamed_1.root, _e610.w));
                        }
                        let _e669 = phi_1265_;
                        let _e679 = nodes.member[(0u + _e543)].y;
                        if (_e336 < 0f) {
                            let _e690 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e679.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e696 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e690.unnamed.root, _e679.w), _e690.unnamed_1);
                            let _e702 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e696.unnamed, lt_bvh_traverse_Tree(_e679.x, _e696.unnamed_1.first_primitive));
                            phi_1292_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e702.unnamed, lt_bvh_traverse_Tree(_e702.unnamed_1.root, _e679.y));
                        } else {
                            let _e718 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e679.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e724 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e718.unnamed.root, _e679.y), _e718.unnamed_1);
                            let _e730 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e724.unnamed, lt_bvh_traverse_Tree(_e679.z, _e724.unnamed_1.first_primitive));
                            phi_1292_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e730.unnamed, lt_bvh_traverse_Tree(_e730.unnamed_1.root, _e679.w));
                        }
                        let _e738 = phi_1292_;
                        let _e748 = nodes.member[(0u + _e543)].z;
                        if (_e348 < 0f) {
                            let _e759 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e748.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e765 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e759.unnamed.root, _e748.w), _e759.unnamed_1);
                            let _e771 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e765.unnamed, lt_bvh_traverse_Tree(_e748.x, _e765.unnamed_1.first_primitive));
                            phi_1319_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e771.unnamed, lt_bvh_traverse_Tree(_e771.unnamed_1.root, _e748.y));
                        } else {
                            let _e787 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e748.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e793 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e787.unnamed.root, _e748.y), _e787.unnamed_1);
                            let _e799 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e793.unnamed, lt_bvh_traverse_Tree(_e748.z, _e793.unnamed_1.first_primitive));
                            phi_1319_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e799.unnamed, lt_bvh_traverse_Tree(_e799.unnamed_1.root, _e748.w));
                        }
                        let _e807 = phi_1319_;
                        phi_1325_ = 0u;
                        phi_1328_ = 0u;
                        loop {
                            let _e817 = phi_1325_;
                            let _e819 = phi_1328_;
                            local_4 = _e819;
                            local_5 = _e819;
                            local_6 = _e819;
                            let _e820 = (_e817 < 8u);
                            if _e820 {
                                let _e822 = (_e817 >> bitcast<u32>(2i));
                                let _e823 = (_e817 & 3u);
                                if (_e822 == 0u) {
                                    phi_1342_ = _e669.unnamed.root;
                                } else {
                                    phi_1342_ = _e669.unnamed.first_primitive;
                                }
                                let _e826 = phi_1342_;
                                if (_e822 == 0u) {
                                    phi_1352_ = _e738.unnamed.root;
                                } else {
                                    phi_1352_ = _e738.unnamed.first_primitive;
                                }
                                let _e835 = phi_1352_;
                                if (_e822 == 0u) {
                                    phi_1362_ = _e807.unnamed.root;
                                } else {
                                    phi_1362_ = _e807.unnamed.first_primitive;
                                }
                                let _e844 = phi_1362_;
                                let _e857 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e826 >> bitcast<u32>(((_e823 * 8u) & 31u))) & 255u)) * _e579) + (_e600 - _e385)), ((f32(((_e835 >> bitcast<u32>(((_e823 * 8u) & 31u))) & 255u)) * _e580) + (_e601 - _e386)));
                                let _e858 = core_intrinsics_maximum_number_nsz_f32_(_e857, ((f32(((_e844 >> bitcast<u32>(((_e823 * 8u) & 31u))) & 255u)) * _e581) + (_e602 - _e387)));
                                if (_e822 == 0u) {
                                    phi_1380_ = _e669.unnamed_1.root;
                                } else {
                                    phi_1380_ = _e669.unnamed_1.first_primitive;
                                }
                                let _e861 = phi_1380_;
                                if (_e822 == 0u) {
                                    phi_1390_ = _e738.unnamed_1.root;
                                } else {
                                    phi_1390_ = _e738.unnamed_1.first_primitive;
                                }
                                let _e870 = phi_1390_;
                                if (_e822 == 0u) {
                                    phi_1400_ = _e807.unnamed_1.root;
                                } else {
                                    phi_1400_ = _e807.unnamed_1.first_primitive;
                                }
                                let _e879 = phi_1400_;
                                let _e892 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e861 >> bitcast<u32>(((_e823 * 8u) & 31u))) & 255u)) * _e579) + (_e600 + _e385)), ((f32(((_e870 >> bitcast<u32>(((_e823 * 8u) & 31u))) & 255u)) * _e580) + (_e601 + _e386)));
                                let _e893 = core_intrinsics_minimum_number_nsz_f32_(_e892, ((f32(((_e879 >> bitcast<u32>(((_e823 * 8u) & 31u))) & 255u)) * _e581) + (_e602 + _e387)));
                                if (_e858 <= _e893) {
                                    if (_e858 <= _e545.t) {
                                        if (_e893 >= _e170.tmin) {
                                            if (_e822 == 0u) {
                                                let _e900 = nodes.member[(0u + _e543)].links[2u];
                                                phi_1436_ = _e900;
                                            } else {
                                                let _e903 = nodes.member[(0u + _e543)].links[3u];
                                                phi_1436_ = _e903;
                                            }
                                            let _e905 = phi_1436_;
                                            let _e910 = ((_e905 >> bitcast<u32>(((_e823 * 8u) & 31u))) & 255u);
                                            let _e911 = (_e910 & 31u);
                                            if (_e911 >= 24u) {
                                                phi_1449_ = (24u + ((_e911 - 24u) ^ _e405));
                                            } else {
                                                phi_1449_ = _e911;
                                            }
                                            let _e917 = phi_1449_;
                                            phi_1454_ = (_e819 | ((_e910 >> bitcast<u32>(5i)) << bitcast<u32>((_e917 & 31u))));
                                        } else {
                                            phi_1454_ = _e819;
                                        }
                                        let _e925 = phi_1454_;
                                        phi_1455_ = _e925;
                                    } else {
                                        phi_1455_ = _e819;
                                    }
                                    let _e927 = phi_1455_;
                                    phi_1456_ = _e927;
                                } else {
                                    phi_1456_ = _e819;
                                }
                                let _e929 = phi_1456_;
                                phi_1326_ = (_e817 + 1u);
                                phi_1329_ = _e929;
                            } else {
                                phi_1326_ = u32();
                                phi_1329_ = u32();
                            }
                            let _e932 = phi_1326_;
                            let _e934 = phi_1329_;
                            continue;
                            continuing {
                                phi_1325_ = _e932;
                                phi_1328_ = _e934;
                                break if !(_e820);
                            }
                        }
                        let _e938 = nodes.member[(0u + _e543)].links[0u];
                        let _e942 = nodes.member[(0u + _e543)].frame[3u];
                        let _e946 = local_4;
                        if ((_e946 & 4278190080u) == 0u) {
                        } else {
                            let _e950 = local_3.group_mask;
                            if ((_e950 & 4278190080u) == 0u) {
                            } else {
                                let _e954 = local_3.len;
                                if (_e954 < 32u) {
                                    let _e957 = local_3.group;
                                    let _e959 = local_3.len;
                                    if (_e959 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_3.first[(0u + _e959)] = _e957;
                                    let _e965 = local_3.group_mask;
                                    let _e967 = local_3.len;
                                    if (_e967 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_3.mask[(0u + _e967)] = _e965;
                                    let _e974 = local_3.len;
                                    local_3.len = (_e974 + 1u);
                                }
                            }
                            local_3.group = (_e119 + _e938);
                            let _e978 = local_5;
                            local_3.group_mask = ((_e978 & 4278190080u) | (_e942 >> bitcast<u32>(24i)));
                        }
                        let _e983 = local_6;
                        phi_1514_ = (_e983 & 16777215u);
                        phi_1517_ = _e545;
                        loop {
                            let _e986 = phi_1514_;
                            let _e988 = phi_1517_;
                            local_12 = _e988;
                            if (_e986 == 0u) {
                                phi_1515_ = u32();
                                phi_1518_ = lt_bvh_Hit();
                                phi_3300_ = false;
                            } else {
                                let _e992 = nodes.member[(0u + _e543)].links[1u];
                                let _e996 = (_e992 + select(firstTrailingBit(_e986), 32u, (_e986 == 0u)));
                                if (_e996 < _e95) {
                                } else {
                                    return;
                                }
                                let _e1003 = instances.member[(0u + _e996)].low_world;
                                let _e1005 = instances.member[(0u + _e996)].high_world;
                                let _e1015 = ((_e1003.x - _e170.origin.x) * _e324);
                                let _e1016 = ((_e1003.y - _e170.origin.y) * _e336);
                                let _e1017 = ((_e1003.z - _e170.origin.z) * _e348);
                                let _e1027 = ((_e1005.x - _e170.origin.x) * _e324);
                                let _e1028 = ((_e1005.y - _e170.origin.y) * _e336);
                                let _e1029 = ((_e1005.z - _e170.origin.z) * _e348);
                                if (_e1015 < _e1027) {
                                    phi_1572_ = _e1015;
                                } else {
                                    phi_1572_ = _e1027;
                                }
                                let _e1032 = phi_1572_;
                                if (_e1016 < _e1028) {
                                    phi_1577_ = _e1016;
                                } else {
                                    phi_1577_ = _e1028;
                                }
                                let _e1035 = phi_1577_;
                                if (_e1017 < _e1029) {
                                    phi_1582_ = _e1017;
                                } else {
                                    phi_1582_ = _e1029;
                                }
                                let _e1038 = phi_1582_;
                                if (_e1015 > _e1027) {
                                    phi_1590_ = _e1015;
                                } else {
                                    phi_1590_ = _e1027;
                                }
                                let _e1044 = phi_1590_;
                                if (_e1016 > _e1028) {
                                    phi_1595_ = _e1016;
                                } else {
                                    phi_1595_ = _e1028;
                                }
                                let _e1047 = phi_1595_;
                                if (_e1017 > _e1029) {
                                    phi_1600_ = _e1017;
                                } else {
                                    phi_1600_ = _e1029;
                                }
                                let _e1050 = phi_1600_;
                                let _e1054 = core_intrinsics_maximum_number_nsz_f32_((_e1032 - _e392), (_e1035 - _e393));
                                let _e1055 = core_intrinsics_maximum_number_nsz_f32_(_e1054, (_e1038 - _e394));
                                let _e1056 = core_intrinsics_minimum_number_nsz_f32_((_e1044 + _e392), (_e1047 + _e393));
                                let _e1057 = core_intrinsics_minimum_number_nsz_f32_(_e1056, (_e1050 + _e394));
                                if (_e1055 <= _e1057) {
                                    if (_e1055 <= _e988.t) {
                                        if (_e1057 >= _e170.tmin) {
                                            let _e1069 = instances.member[(0u + _e996)].world_to_object[0u];
                                            let _e1080 = ((((_e1069.x * _e170.origin.x) + (_e1069.y * _e170.origin.y)) + (_e1069.z * _e170.origin.z)) + (_e1069.w * 1f));
                                            let _e1082 = instances.member[(0u + _e996)].world_to_object[1u];
                                            let _e1093 = ((((_e1082.x * _e170.origin.x) + (_e1082.y * _e170.origin.y)) + (_e1082.z * _e170.origin.z)) + (_e1082.w * 1f));
                                            let _e1095 = instances.member[(0u + _e996)].world_to_object[2u];
                                            let _e1106 = ((((_e1095.x * _e170.origin.x) + (_e1095.y * _e170.origin.y)) + (_e1095.z * _e170.origin.z)) + (_e1095.w * 1f));
                                            let _e1113 = instances.member[(0u + _e996)].world_to_object[0u];
                                            let _e1124 = ((((_e1113.x * _e170.direction.x) + (_e1113.y * _e170.direction.y)) + (_e1113.z * _e170.direction.z)) + (_e1113.w * 0f));
                                            let _e1126 = instances.member[(0u + _e996)].world_to_object[1u];
                                            let _e1137 = ((((_e1126.x * _e170.direction.x) + (_e1126.y * _e170.direction.y)) + (_e1126.z * _e170.direction.z)) + (_e1126.w * 0f));
                                            let _e1139 = instances.member[(0u + _e996)].world_to_object[2u];
                                            let _e1150 = ((((_e1139.x * _e170.direction.x) + (_e1139.y * _e170.direction.y)) + (_e1139.z * _e170.direction.z)) + (_e1139.w * 0f));
                                            let _e1155 = instances.member[(0u + _e996)].root;
                                            let _e1157 = instances.member[(0u + _e996)].first_triangle;
                                            let _e1161 = abs(_e1124);
                                            let _e1162 = abs(_e1137);
                                            let _e1163 = abs(_e1150);
                                            if (abs(_e1080) < 1000000000000000f) {
                                                if (abs(_e1093) < 1000000000000000f) {
                                                    if (abs(_e1106) < 1000000000000000f) {
                                                        if (_e1161 < 1000000000000000f) {
                                                            if (_e1162 < 1000000000000000f) {
                                                                if (_e1163 < 1000000000000000f) {
                                                                    if (_e1161 > 0f) {
                                                                        phi_1757_ = bool();
                                                                        phi_1758_ = true;
                                                                    } else {
                                                                        let _e1171 = (_e1162 > 0f);
                                                                        if _e1171 {
                                                                            phi_1756_ = bool();
                                                                        } else {
                                                                            phi_1756_ = (_e1163 > 0f);
                                                                        }
                                                                        let _e1174 = phi_1756_;
                                                                        phi_1757_ = _e1174;
                                                                        phi_1758_ = _e1171;
                                                                    }
                                                                    let _e1176 = phi_1757_;
                                                                    let _e1178 = phi_1758_;
                                                                    if _e1178 {
                                                                        phi_1762_ = true;
                                                                    } else {
                                                                        phi_1762_ = _e1176;
                                                                    }
                                                                    let _e1180 = phi_1762_;
                                                                    phi_1763_ = _e1180;
                                                                    phi_1764_ = false;
                                                                } else {
                                                                    phi_1763_ = bool();
                                                                    phi_1764_ = true;
                                                                }
                                                                let _e1182 = phi_1763_;
                                                                let _e1184 = phi_1764_;
                                                                phi_1765_ = _e1182;
                                                                phi_1766_ = false;
                                                                phi_1767_ = _e1184;
                                                            } else {
                                                                phi_1765_ = bool();
                                                                phi_1766_ = true;
                                                                phi_1767_ = false;
                                                            }
                                                            let _e1186 = phi_1765_;
                                                            let _e1188 = phi_1766_;
                                                            let _e1190 = phi_1767_;
                                                            phi_1768_ = _e1186;
                                                            phi_1769_ = _e1188;
                                                            phi_1770_ = _e1190;
                                                        } else {
                                                            phi_1768_ = bool();
                                                            phi_1769_ = true;
                                                            phi_1770_ = false;
                                                        }
                                                        let _e1192 = phi_1768_;
                                                        let _e1194 = phi_1769_;
                                                        let _e1196 = phi_1770_;
                                                        phi_1771_ = _e1192;
                                                        phi_1772_ = _e1194;
                                                        phi_1773_ = _e1196;
                                                    } else {
                                                        phi_1771_ = bool();
                                                        phi_1772_ = true;
                                                        phi_1773_ = false;
                                                    }
                                                    let _e1198 = phi_1771_;
                                                    let _e1200 = phi_1772_;
                                                    let _e1202 = phi_1773_;
                                                    phi_1774_ = _e1198;
                                                    phi_1775_ = _e1200;
                                                    phi_1776_ = _e1202;
                                                } else {
                                                    phi_1774_ = bool();
                                                    phi_1775_ = true;
                                                    phi_1776_ = false;
                                                }
                                                let _e1204 = phi_1774_;
                                                let _e1206 = phi_1775_;
                                                let _e1208 = phi_1776_;
                                                phi_1777_ = _e1204;
                                                phi_1778_ = _e1206;
                                                phi_1779_ = _e1208;
                                            } else {
                                                phi_1777_ = bool();
                                                phi_1778_ = true;
                                                phi_1779_ = false;
                                            }
                                            let _e1210 = phi_1777_;
                                            let _e1212 = phi_1778_;
                                            let _e1214 = phi_1779_;
                                            if _e1212 {
                                                phi_1783_ = true;
                                            } else {
                                                phi_1783_ = _e1214;
                                            }
                                            let _e1216 = phi_1783_;
                                            if _e1216 {
                                                phi_1787_ = false;
                                            } else {
                                                phi_1787_ = _e1210;
                                            }
                                            let _e1218 = phi_1787_;
                                            if _e1218 {
                                                let _e1219 = (_e1155 >= _e80);
                                                if _e1219 {
                                                    phi_3290_ = lt_bvh_Hit();
                                                } else {
                                                    if (_e1155 < _e80) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1225 = nodes.member[(0u + _e1155)].frame[0u];
                                                    let _e1229 = nodes.member[(0u + _e1155)].frame[1u];
                                                    let _e1233 = nodes.member[(0u + _e1155)].frame[2u];
                                                    let _e1237 = nodes.member[(0u + _e1155)].frame[0u];
                                                    let _e1241 = nodes.member[(0u + _e1155)].frame[1u];
                                                    let _e1245 = nodes.member[(0u + _e1155)].frame[2u];
                                                    let _e1249 = nodes.member[(0u + _e1155)].frame[3u];
                                                    let _e1283 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1124), abs(_e1137));
                                                    let _e1284 = core_intrinsics_maximum_number_nsz_f32_(_e1283, abs(_e1150));
                                                    let _e1285 = (_e1284 * 0.0000000000009094947f);
                                                    if (abs(_e1124) < _e1285) {
                                                        phi_1857_ = _e1285;
                                                    } else {
                                                        phi_1857_ = abs(_e1124);
                                                    }
                                                    let _e1290 = phi_1857_;
                                                    if (_e1124 < 0f) {
                                                        phi_1864_ = (-1f / _e1290);
                                                    } else {
                                                        phi_1864_ = (1f / _e1290);
                                                    }
                                                    let _e1295 = phi_1864_;
                                                    if (abs(_e1137) < _e1285) {
                                                        phi_1871_ = _e1285;
                                                    } else {
                                                        phi_1871_ = abs(_e1137);
                                                    }
                                                    let _e1300 = phi_1871_;
                                                    if (_e1137 < 0f) {
                                                        phi_1878_ = (-1f / _e1300);
                                                    } else {
                                                        phi_1878_ = (1f / _e1300);
                                                    }
                                                    let _e1305 = phi_1878_;
                                                    if (abs(_e1150) < _e1285) {
                                                        phi_1885_ = _e1285;
                                                    } else {
                                                        phi_1885_ = abs(_e1150);
                                                    }
                                                    let _e1310 = phi_1885_;
                                                    if (_e1150 < 0f) {
                                                        phi_1892_ = (-1f / _e1310);
                                                    } else {
                                                        phi_1892_ = (1f / _e1310);
                                                    }
                                                    let _e1315 = phi_1892_;
                                                    let _e1319 = abs((bitcast<f32>(_e1225) - _e1080));
                                                    let _e1320 = abs((bitcast<f32>(_e1229) - _e1093));
                                                    let _e1321 = abs((bitcast<f32>(_e1233) - _e1106));
                                                    let _e1325 = abs(((bitcast<f32>(_e1237) + (bitcast<f32>((((_e1249 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1080));
                                                    let _e1326 = abs(((bitcast<f32>(_e1241) + (bitcast<f32>((((_e1249 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1093));
                                                    let _e1327 = abs(((bitcast<f32>(_e1245) + (bitcast<f32>((((_e1249 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1106));
                                                    if (_e1319 > _e1325) {
                                                        phi_1909_ = _e1319;
                                                    } else {
                                                        phi_1909_ = _e1325;
                                                    }
                                                    let _e1330 = phi_1909_;
                                                    if (_e1320 > _e1326) {
                                                        phi_1914_ = _e1320;
                                                    } else {
                                                        phi_1914_ = _e1326;
                                                    }
                                                    let _e1333 = phi_1914_;
                                                    if (_e1321 > _e1327) {
                                                        phi_1919_ = _e1321;
                                                    } else {
                                                        phi_1919_ = _e1327;
                                                    }
                                                    let _e1336 = phi_1919_;
                                                    let _e1337 = core_intrinsics_maximum_number_nsz_f32_(_e1330, _e1333);
                                                    let _e1338 = core_intrinsics_maximum_number_nsz_f32_(_e1337, _e1336);
                                                    let _e1342 = (_e1338 * 0.0000019073486f);
                                                    let _e1343 = (abs(_e1295) * _e1342);
                                                    let _e1344 = (abs(_e1305) * _e1342);
                                                    let _e1345 = (abs(_e1315) * _e1342);
                                                    let _e1349 = (_e1338 * 0.0000009536743f);
                                                    let _e1350 = (abs(_e1295) * _e1349);
                                                    let _e1351 = (abs(_e1305) * _e1349);
                                                    let _e1352 = (abs(_e1315) * _e1349);
                                                    let _e1353 = abs(_e1124);
                                                    let _e1354 = abs(_e1137);
                                                    let _e1355 = abs(_e1150);
                                                    if (_e1353 >= _e1354) {
                                                        if (_e1353 >= _e1355) {
                                                            phi_1947_ = false;
                                                        } else {
                                                            phi_1947_ = true;
                                                        }
                                                        let _e1359 = phi_1947_;
                                                        phi_1948_ = _e1359;
                                                    } else {
                                                        phi_1948_ = true;
                                                    }
                                                    let _e1361 = phi_1948_;
                                                    if _e1361 {
                                                        if (_e1354 >= _e1355) {
                                                            phi_1956_ = 1u;
                                                        } else {
                                                            phi_1956_ = 2u;
                                                        }
                                                        let _e1364 = phi_1956_;
                                                        phi_1957_ = _e1364;
                                                    } else {
                                                        phi_1957_ = 0u;
                                                    }
                                                    let _e1366 = phi_1957_;
                                                    if (_e1366 == 0u) {
                                                        phi_1969_ = vec3<f32>(_e1137, _e1150, _e1124);
                                                    } else {
                                                        if (_e1366 == 1u) {
                                                            phi_1968_ = vec3<f32>(_e1150, _e1124, _e1137);
                                                        } else {
                                                            phi_1968_ = vec3<f32>(_e1124, _e1137, _e1150);
                                                        }
                                                        let _e1372 = phi_1968_;
                                                        phi_1969_ = _e1372;
                                                    }
                                                    let _e1374 = phi_1969_;
                                                    let _e1377 = (_e1374.x / _e1374.z);
                                                    let _e1380 = (_e1374.y / _e1374.z);
                                                    let _e1382 = (1f / _e1374.z);
                                                    if (_e1295 < 0f) {
                                                        phi_1982_ = 0u;
                                                    } else {
                                                        phi_1982_ = 1u;
                                                    }
                                                    let _e1385 = phi_1982_;
                                                    if (_e1305 < 0f) {
                                                        phi_1987_ = 0u;
                                                    } else {
                                                        phi_1987_ = 2u;
                                                    }
                                                    let _e1388 = phi_1987_;
                                                    if (_e1315 < 0f) {
                                                        phi_1992_ = 0u;
                                                    } else {
                                                        phi_1992_ = 4u;
                                                    }
                                                    let _e1391 = phi_1992_;
                                                    let _e1393 = ((_e1385 | _e1388) | _e1391);
                                                    let _e1394 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1155, 2147483648u);
                                                    local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e1394.first[0], _e1394.first[1], _e1394.first[2], _e1394.first[3], _e1394.first[4], _e1394.first[5], _e1394.first[6], _e1394.first[7], _e1394.first[8], _e1394.first[9], _e1394.first[10], _e1394.first[11], _e1394.first[12], _e1394.first[13], _e1394.first[14], _e1394.first[15], _e1394.first[16], _e1394.first[17], _e1394.first[18], _e1394.first[19], _e1394.first[20], _e1394.first[21], _e1394.first[22], _e1394.first[23], _e1394.first[24], _e1394.first[25], _e1394.first[26], _e1394.first[27], _e1394.first[28], _e1394.first[29], _e1394.first[30], _e1394.first[31]), array<u32, 32>(_e1394.mask[0], _e1394.mask[1], _e1394.mask[2], _e1394.mask[3], _e1394.mask[4], _e1394.mask[5], _e1394.mask[6], _e1394.mask[7], _e1394.mask[8], _e1394.mask[9], _e1394.mask[10], _e1394.mask[11], _e1394.mask[12], _e1394.mask[13], _e1394.mask[14], _e1394.mask[15], _e1394.mask[16], _e1394.mask[17], _e1394.mask[18], _e1394.mask[19], _e1394.mask[20], _e1394.mask[21], _e1394.mask[22], _e1394.mask[23], _e1394.mask[24], _e1394.mask[25], _e1394.mask[26], _e1394.mask[27], _e1394.mask[28], _e1394.mask[29], _e1394.mask[30], _e1394.mask[31]), _e1394.len, _e1394.group, _e1394.group_mask);
                                                    let _e1468 = local_2.group_mask;
                                                    if ((_e1468 & 4278190080u) == 0u) {
                                                        let _e1472 = local_2.len;
                                                        if (_e1472 == 0u) {
                                                            phi_2106_ = false;
                                                        } else {
                                                            let _e1476 = local_2.len;
                                                            local_2.len = (_e1476 - 1u);
                                                            let _e1479 = local_2.len;
                                                            if (_e1479 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1484 = local_2.first[(0u + _e1479)];
                                                            local_2.group = _e1484;
                                                            let _e1487 = local_2.len;
                                                            if (_e1487 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1492 = local_2.mask[(0u + _e1487)];
                                                            local_2.group_mask = _e1492;
                                                            phi_2106_ = true;
                                                        }
                                                        let _e1495 = phi_2106_;
                                                        phi_2107_ = _e1495;
                                                    } else {
                                                        phi_2107_ = true;
                                                    }
                                                    let _e1497 = phi_2107_;
                                                    if _e1497 {
                                                        let _e1499 = local_2.group_mask;
                                                        let _e1505 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1499)), 32u, (_e1499 == 0u)));
                                                        let _e1509 = local_2.group_mask;
                                                        let _e1523 = local_2.group_mask;
                                                        local_2.group_mask = (_e1523 & ~((1u << bitcast<u32>((_e1505 & 31u)))));
                                                        let _e1526 = local_2.group;
                                                        phi_2138_ = (_e1526 + countOneBits(((_e1509 & ~((4294967295u << bitcast<u32>((((_e1505 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_2138_ = 4294967295u;
                                                    }
                                                    let _e1529 = phi_2138_;
                                                    phi_2140_ = _e988;
                                                    phi_2143_ = _e1529;
                                                    loop {
                                                        let _e1531 = phi_2140_;
                                                        let _e1533 = phi_2143_;
                                                        local_11 = _e1531;
                                                        let _e1534 = (_e1533 != 4294967295u);
                                                        if _e1534 {
                                                            if (_e1533 < _e80) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1541 = nodes.member[(0u + _e1533)].frame[3u];
                                                            let _e1566 = (bitcast<f32>((((_e1541 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1295);
                                                            let _e1567 = (bitcast<f32>((((_e1541 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1305);
                                                            let _e1568 = (bitcast<f32>((((_e1541 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1315);
                                                            let _e1571 = nodes.member[(0u + _e1533)].frame[0u];
                                                            let _e1575 = nodes.member[(0u + _e1533)].frame[1u];
                                                            let _e1579 = nodes.member[(0u + _e1533)].frame[2u];
                                                            let _e1584 = ((bitcast<f32>(_e1571) - _e1080) * _e1295);
                                                            let _e1585 = ((bitcast<f32>(_e1575) - _e1093) * _e1305);
                                                            let _e1586 = ((bitcast<f32>(_e1579) - _e1106) * _e1315);
                                                            let _e1594 = nodes.member[(0u + _e1533)].x;
                                                            if (_e1295 < 0f) {
                                                                let _e1605 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1594.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1611 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1605.unnamed.root, _e1594.w), _e1605.unnamed_1);
                                                                let _e1617 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1611.unnamed, lt_bvh_traverse_Tree(_e1594.x, _e1611.unnamed_1.first_primitive));
                                                                phi_2224_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1617.unnamed, lt_bvh_traverse_Tree(_e1617.unnamed_1.root, _e1594.y));
                                                            } else {
                                                                let _e1633 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1594.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1639 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1633.unnamed.root, _e1594.y), _e1633.unnamed_1);
                                                                let _e1645 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1639.unnamed, lt_bvh_traverse_Tree(_e1594.z, _e1639.unnamed_1.first_primitive));
                                                                phi_2224_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1645.unnamed, lt_bvh_traverse_Tree(_e1645.unnamed_1.root, _e1594.w));
                                                            }
                                                            let _e1653 = phi_2224_;
                                                            let _e1663 = nodes.member[(0u + _e1533)].y;
                                                            if (_e1305 < 0f) {
                                                                let _e1674 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1663.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1680 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1674.unnamed.root, _e1663.w), _e1674.unnamed_1);
                                                                let _e1686 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1680.unnamed, lt_bvh_traverse_Tree(_e1663.x, _e1680.unnamed_1.first_primitive));
                                                                phi_2251_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1686.unnamed, lt_bvh_traverse_Tree(_e1686.unnamed_1.root, _e1663.y));
                                                            } else {
                                                                let _e1702 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1663.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1708 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1702.unnamed.root, _e1663.y), _e1702.unnamed_1);
                                                                let _e1714 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1708.unnamed, lt_bvh_traverse_Tree(_e1663.z, _e1708.unnamed_1.first_primitive));
                                                                phi_2251_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1714.unnamed, lt_bvh_traverse_Tree(_e1714.unnamed_1.root, _e1663.w));
                                                            }
                                                            let _e1722 = phi_2251_;
                                                            let _e1732 = nodes.member[(0u + _e1533)].z;
                                                            if (_e1315 < 0f) {
                                                                let _e1743 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1732.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1749 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1743.unnamed.root, _e1732.w), _e1743.unnamed_1);
                                                                let _e1755 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1749.unnamed, lt_bvh_traverse_Tree(_e1732.x, _e1749.unnamed_1.first_primitive));
                                                                phi_2278_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1755.unnamed, lt_bvh_traverse_Tree(_e1755.unnamed_1.root, _e1732.y));
                                                            } else {
                                                                let _e1771 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1732.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1777 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1771.unnamed.root, _e1732.y), _e1771.unnamed_1);
                                                                let _e1783 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1777.unnamed, lt_bvh_traverse_Tree(_e1732.z, _e1777.unnamed_1.first_primitive));
                                                                phi_2278_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1783.unnamed, lt_bvh_traverse_Tree(_e1783.unnamed_1.root, _e1732.w));
                                                            }
                                                            let _e1791 = phi_2278_;
                                                            phi_2284_ = 0u;
                                                            phi_2287_ = 0u;
                                                            loop {
                                                                let _e1801 = phi_2284_;
                                                                let _e1803 = phi_2287_;
                                                                local_7 = _e1803;
                                                                local_8 = _e1803;
                                                                local_9 = _e1803;
                                                                let _e1804 = (_e1801 < 8u);
                                                                if _e1804 {
                                                                    let _e1806 = (_e1801 >> bitcast<u32>(2i));
                                                                    let _e1807 = (_e1801 & 3u);
                                                                    if (_e1806 == 0u) {
                                                                        phi_2301_ = _e1653.unnamed.root;
                                                                    } else {
                                                                        phi_2301_ = _e1653.unnamed.first_primitive;
                                                                    }
                                                                    let _e1810 = phi_2301_;
                                                                    if (_e1806 == 0u) {
                                                                        phi_2311_ = _e1722.unnamed.root;
                                                                    } else {
                                                                        phi_2311_ = _e1722.unnamed.first_primitive;
                                                                    }
                                                                    let _e1819 = phi_2311_;
                                                                    if (_e1806 == 0u) {
                                                                        phi_2321_ = _e1791.unnamed.root;
                                                                    } else {
                                                                        phi_2321_ = _e1791.unnamed.first_primitive;
                                                                    }
                                                                    let _e1828 = phi_2321_;
                                                                    let _e1841 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1810 >> bitcast<u32>(((_e1807 * 8u) & 31u))) & 255u)) * _e1566) + (_e1584 - _e1343)), ((f32(((_e1819 >> bitcast<u32>(((_e1807 * 8u) & 31u))) & 255u)) * _e1567) + (_e1585 - _e1344)));
                                                                    let _e1842 = core_intrinsics_maximum_number_nsz_f32_(_e1841, ((f32(((_e1828 >> bitcast<u32>(((_e1807 * 8u) & 31u))) & 255u)) * _e1568) + (_e1586 - _e1345)));
                                                                    if (_e1806 == 0u) {
                                                                        phi_2339_ = _e1653.unnamed_1.root;
                                                                    } else {
                                                                        phi_2339_ = _e1653.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1845 = phi_2339_;
                                                                    if (_e1806 == 0u) {
                                                                        phi_2349_ = _e1722.unnamed_1.root;
                                                                    } else {
                                                                        phi_2349_ = _e1722.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1854 = phi_2349_;
                                                                    if (_e1806 == 0u) {
                                                                        phi_2359_ = _e1791.unnamed_1.root;
                                                                    } else {
                                                                        phi_2359_ = _e1791.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1863 = phi_2359_;
                                                                    let _e1876 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1845 >> bitcast<u32>(((_e1807 * 8u) & 31u))) & 255u)) * _e1566) + (_e1584 + _e1343)), ((f32(((_e1854 >> bitcast<u32>(((_e1807 * 8u) & 31u))) & 255u)) * _e1567) + (_e1585 + _e1344)));
                                                                    let _e1877 = core_intrinsics_minimum_number_nsz_f32_(_e1876, ((f32(((_e1863 >> bitcast<u32>(((_e1807 * 8u) & 31u))) & 255u)) * _e1568) + (_e1586 + _e1345)));
                                                                    if (_e1842 <= _e1877) {
                                                                        if (_e1842 <= _e1531.t) {
                                                                            if (_e1877 >= _e170.tmin) {
                                                                                if (_e1806 == 0u) {
                                                                                    let _e1884 = nodes.member[(0u + _e1533)].links[2u];
                                                                                    phi_2395_ = _e1884;
                                                                                } else {
                                                                                    let _e1887 = nodes.member[(0u + _e1533)].links[3u];
                                                                                    phi_2395_ = _e1887;
                                                                                }
                                                                                let _e1889 = phi_2395_;
                                                                                let _e1894 = ((_e1889 >> bitcast<u32>(((_e1807 * 8u) & 31u))) & 255u);
                                                                                let _e1895 = (_e1894 & 31u);
                                                                                if (_e1895 >= 24u) {
                                                                                    phi_2408_ = (24u + ((_e1895 - 24u) ^ _e1393));
                                                                                } else {
                                                                                    phi_2408_ = _e1895;
                                                                                }
                                                                                let _e1901 = phi_2408_;
                                                                                phi_2413_ = (_e1803 | ((_e1894 >> bitcast<u32>(5i)) << bitcast<u32>((_e1901 & 31u))));
                                                                            } else {
                                                                                phi_2413_ = _e1803;
                                                                            }
                                                                            let _e1909 = phi_2413_;
                                                                            phi_2414_ = _e1909;
                                                                        } else {
                                                                            phi_2414_ = _e1803;
                                                                        }
                                                                        let _e1911 = phi_2414_;
                                                                        phi_2415_ = _e1911;
                                                                    } else {
                                                                        phi_2415_ = _e1803;
                                                                    }
                                                                    let _e1913 = phi_2415_;
                                                                    phi_2285_ = (_e1801 + 1u);
                                                                    phi_2288_ = _e1913;
                                                                } else {
                                                                    phi_2285_ = u32();
                                                                    phi_2288_ = u32();
                                                                }
                                                                let _e1916 = phi_2285_;
                                                                let _e1918 = phi_2288_;
                                                                continue;
                                                                continuing {
                                                                    phi_2284_ = _e1916;
                                                                    phi_2287_ = _e1918;
                                                                    break if !(_e1804);
                                                                }
                                                            }
                                                            let _e1922 = nodes.member[(0u + _e1533)].links[0u];
                                                            let _e1926 = nodes.member[(0u + _e1533)].frame[3u];
                                                            let _e1930 = local_7;
                                                            if ((_e1930 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1934 = local_2.group_mask;
                                                                if ((_e1934 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1938 = local_2.len;
                                                                    if (_e1938 < 32u) {
                                                                        let _e1941 = local_2.group;
                                                                        let _e1943 = local_2.len;
                                                                        if (_e1943 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_2.first[(0u + _e1943)] = _e1941;
                                                                        let _e1949 = local_2.group_mask;
                                                                        let _e1951 = local_2.len;
                                                                        if (_e1951 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_2.mask[(0u + _e1951)] = _e1949;
                                                                        let _e1958 = local_2.len;
                                                                        local_2.len = (_e1958 + 1u);
                                                                    }
                                                                }
                                                                local_2.group = (_e1155 + _e1922);
                                                                let _e1962 = local_8;
                                                                local_2.group_mask = ((_e1962 & 4278190080u) | (_e1926 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1967 = local_9;
                                                            phi_2473_ = _e1531;
                                                            phi_2476_ = (_e1967 & 16777215u);
                                                            loop {
                                                                let _e1970 = phi_2473_;
                                                                let _e1972 = phi_2476_;
                                                                local_10 = _e1970;
                                                                if (_e1972 == 0u) {
                                                                    phi_2474_ = lt_bvh_Hit();
                                                                    phi_2477_ = u32();
                                                                    phi_3218_ = false;
                                                                } else {
                                                                    let _e1976 = nodes.member[(0u + _e1533)].links[1u];
                                                                    let _e1981 = ((_e1157 + _e1976) + select(firstTrailingBit(_e1972), 32u, (_e1972 == 0u)));
                                                                    if (_e1981 < _e83) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1988 = triangles.member[(0u + _e1981)].v0_;
                                                                    let _e1990 = (_e1988.x - _e1080);
                                                                    let _e1992 = (_e1988.y - _e1093);
                                                                    let _e1994 = (_e1988.z - _e1106);
                                                                    if (_e1366 == 0u) {
                                                                        phi_2521_ = vec3<f32>(_e1992, _e1994, _e1990);
                                                                    } else {
                                                                        if (_e1366 == 1u) {
                                                                            phi_2520_ = vec3<f32>(_e1994, _e1990, _e1992);
                                                                        } else {
                                                                            phi_2520_ = (_e1988 - vec3<f32>(_e1080, _e1093, _e1106));
                                                                        }
                                                                        let _e2002 = phi_2520_;
                                                                        phi_2521_ = _e2002;
                                                                    }
                                                                    let _e2004 = phi_2521_;
                                                                    let _e2008 = (_e2004.x - (_e1377 * _e2004.z));
                                                                    let _e2012 = (_e2004.y - (_e1380 * _e2004.z));
                                                                    let _e2016 = triangles.member[(0u + _e1981)].v1_;
                                                                    let _e2018 = (_e2016.x - _e1080);
                                                                    let _e2020 = (_e2016.y - _e1093);
                                                                    let _e2022 = (_e2016.z - _e1106);
                                                                    if (_e1366 == 0u) {
                                                                        phi_2553_ = vec3<f32>(_e2020, _e2022, _e2018);
                                                                    } else {
                                                                        if (_e1366 == 1u) {
                                                                            phi_2552_ = vec3<f32>(_e2022, _e2018, _e2020);
                                                                        } else {
                                                                            phi_2552_ = (_e2016 - vec3<f32>(_e1080, _e1093, _e1106));
                                                                        }
                                                                        let _e2030 = phi_2552_;
                                                                        phi_2553_ = _e2030;
                                                                    }
                                                                    let _e2032 = phi_2553_;
                                                                    let _e2036 = (_e2032.x - (_e1377 * _e2032.z));
                                                                    let _e2040 = (_e2032.y - (_e1380 * _e2032.z));
                                                                    let _e2044 = triangles.member[(0u + _e1981)].v2_;
                                                                    let _e2046 = (_e2044.x - _e1080);
                                                                    let _e2048 = (_e2044.y - _e1093);
                                                                    let _e2050 = (_e2044.z - _e1106);
                                                                    if (_e1366 == 0u) {
                                                                        phi_2585_ = vec3<f32>(_e2048, _e2050, _e2046);
                                                                    } else {
                                                                        if (_e1366 == 1u) {
                                                                            phi_2584_ = vec3<f32>(_e2050, _e2046, _e2048);
                                                                        } else {
                                                                            phi_2584_ = (_e2044 - vec3<f32>(_e1080, _e1093, _e1106));
                                                                        }
                                                                        let _e2058 = phi_2584_;
                                                                        phi_2585_ = _e2058;
                                                                    }
                                                                    let _e2060 = phi_2585_;
                                                                    let _e2064 = (_e2060.x - (_e1377 * _e2060.z));
                                                                    let _e2068 = (_e2060.y - (_e1380 * _e2060.z));
                                                                    if (_e2036 < _e2064) {
                                                                        phi_2606_ = true;
                                                                    } else {
                                                                        if (_e2036 == _e2064) {
                                                                            phi_2605_ = (_e2040 < _e2068);
                                                                        } else {
                                                                            phi_2605_ = false;
                                                                        }
                                                                        let _e2075 = phi_2605_;
                                                                        phi_2606_ = _e2075;
                                                                    }
                                                                    let _e2077 = phi_2606_;
                                                                    if _e2077 {
                                                                        phi_2610_ = _e2068;
                                                                        phi_2611_ = _e2064;
                                                                        phi_2612_ = _e2040;
                                                                        phi_2613_ = _e2036;
                                                                    } else {
                                                                        phi_2610_ = _e2040;
                                                                        phi_2611_ = _e2036;
                                                                        phi_2612_ = _e2068;
                                                                        phi_2613_ = _e2064;
                                                                    }
                                                                    let _e2079 = phi_2610_;
                                                                    let _e2081 = phi_2611_;
                                                                    let _e2083 = phi_2612_;
                                                                    let _e2085 = phi_2613_;
                                                                    let _e2088 = ((_e2085 * _e2079) - (_e2083 * _e2081));
                                                                    if _e2077 {
                                                                        phi_2621_ = -(_e2088);
                                                                    } else {
                                                                        phi_2621_ = _e2088;
                                                                    }
                                                                    let _e2091 = phi_2621_;
                                                                    if (_e2064 < _e2008) {
                                                                        phi_2632_ = true;
                                                                    } else {
                                                                        if (_e2064 == _e2008) {
                                                                            phi_2631_ = (_e2068 < _e2012);
                                                                        } else {
                                                                            phi_2631_ = false;
                                                                        }
                                                                        let _e2096 = phi_2631_;
                                                                        phi_2632_ = _e2096;
                                                                    }
                                                                    let _e2098 = phi_2632_;
                                                                    if _e2098 {
                                                                        phi_2636_ = _e2012;
                                                                        phi_2637_ = _e2008;
                                                                        phi_2638_ = _e2068;
                                                                        phi_2639_ = _e2064;
                                                                    } else {
                                                                        phi_2636_ = _e2068;
                                                                        phi_2637_ = _e2064;
                                                                        phi_2638_ = _e2012;
                                                                        phi_2639_ = _e2008;
                                                                    }
                                                                    let _e2100 = phi_2636_;
                                                                    let _e2102 = phi_2637_;
                                                                    let _e2104 = phi_2638_;
                                                                    let _e2106 = phi_2639_;
                                                                    let _e2109 = ((_e2106 * _e2100) - (_e2104 * _e2102));
                                                                    if _e2098 {
                                                                        phi_2647_ = -(_e2109);
                                                                    } else {
                                                                        phi_2647_ = _e2109;
                                                                    }
                                                                    let _e2112 = phi_2647_;
                                                                    if (_e2008 < _e2036) {
                                                                        phi_2658_ = true;
                                                                    } else {
                                                                        if (_e2008 == _e2036) {
                                                                            phi_2657_ = (_e2012 < _e2040);
                                                                        } else {
                                                                            phi_2657_ = false;
                                                                        }
                                                                        let _e2117 = phi_2657_;
                                                                        phi_2658_ = _e2117;
                                                                    }
                                                                    let _e2119 = phi_2658_;
                                                                    if _e2119 {
                                                                        phi_2662_ = _e2040;
                                                                        phi_2663_ = _e2036;
                                                                        phi_2664_ = _e2012;
                                                                        phi_2665_ = _e2008;
                                                                    } else {
                                                                        phi_2662_ = _e2012;
                                                                        phi_2663_ = _e2008;
                                                                        phi_2664_ = _e2040;
                                                                        phi_2665_ = _e2036;
                                                                    }
                                                                    let _e2121 = phi_2662_;
                                                                    let _e2123 = phi_2663_;
                                                                    let _e2125 = phi_2664_;
                                                                    let _e2127 = phi_2665_;
                                                                    let _e2130 = ((_e2127 * _e2121) - (_e2125 * _e2123));
                                                                    if _e2119 {
                                                                        phi_2673_ = -(_e2130);
                                                                    } else {
                                                                        phi_2673_ = _e2130;
                                                                    }
                                                                    let _e2133 = phi_2673_;
                                                                    if (_e2091 >= 0f) {
                                                                        if (_e2112 >= 0f) {
                                                                            if (_e2133 >= 0f) {
                                                                                phi_2688_ = ((_e2091 + _e2112) + _e2133);
                                                                                phi_2689_ = false;
                                                                            } else {
                                                                                phi_2688_ = f32();
                                                                                phi_2689_ = true;
                                                                            }
                                                                            let _e2140 = phi_2688_;
                                                                            let _e2142 = phi_2689_;
                                                                            phi_2690_ = _e2140;
                                                                            phi_2691_ = _e2142;
                                                                        } else {
                                                                            phi_2690_ = f32();
                                                                            phi_2691_ = true;
                                                                        }
                                                                        let _e2144 = phi_2690_;
                                                                        let _e2146 = phi_2691_;
                                                                        phi_2692_ = _e2144;
                                                                        phi_2693_ = _e2146;
                                                                    } else {
                                                                        phi_2692_ = f32();
                                                                        phi_2693_ = true;
                                                                    }
                                                                    let _e2148 = phi_2692_;
                                                                    let _e2150 = phi_2693_;
                                                                    if _e2150 {
                                                                        if (_e2091 <= 0f) {
                                                                            if (_e2112 <= 0f) {
                                                                                let _e2153 = (_e2133 <= 0f);
                                                                                if _e2153 {
                                                                                }
                                                                                phi_2711_ = ((_e2091 + _e2112) + _e2133);
                                                                                phi_2712_ = false;
                                                                                phi_2713_ = _e2153;
                                                                            } else {
                                                                                phi_2711_ = f32();
                                                                                phi_2712_ = true;
                                                                                phi_2713_ = false;
                                                                            }
                                                                            let _e2157 = phi_2711_;
                                                                            let _e2159 = phi_2712_;
                                                                            let _e2161 = phi_2713_;
                                                                            phi_2714_ = _e2157;
                                                                            phi_2715_ = _e2159;
                                                                            phi_2716_ = _e2161;
                                                                        } else {
                                                                            phi_2714_ = f32();
                                                                            phi_2715_ = true;
                                                                            phi_2716_ = false;
                                                                        }
                                                                        let _e2163 = phi_2714_;
                                                                        let _e2165 = phi_2715_;
                                                                        let _e2167 = phi_2716_;
                                                                        if _e2165 {
                                                                            phi_2720_ = false;
                                                                        } else {
                                                                            phi_2720_ = _e2167;
                                                                        }
                                                                        let _e2169 = phi_2720_;
                                                                        phi_2721_ = _e2163;
                                                                        phi_2722_ = _e2169;
                                                                    } else {
                                                                        phi_2721_ = _e2148;
                                                                        phi_2722_ = true;
                                                                    }
                                                                    let _e2171 = phi_2721_;
                                                                    let _e2173 = phi_2722_;
                                                                    if _e2173 {
                                                                        let _e2174 = (_e2171 == 0f);
                                                                        if _e2174 {
                                                                            phi_2935_ = lt_bvh_triangle_Intersection();
                                                                            phi_2936_ = false;
                                                                        } else {
                                                                            let _e2180 = ((((_e2091 * (_e1382 * _e2004.z)) + (_e2112 * (_e1382 * _e2032.z))) + (_e2133 * (_e1382 * _e2060.z))) / _e2171);
                                                                            if (_e2180 > _e170.tmin) {
                                                                                if (_e2180 < _e170.tmax) {
                                                                                    let _e2184 = triangles.member[(0u + _e1981)].v0_;
                                                                                    let _e2186 = triangles.member[(0u + _e1981)].v1_;
                                                                                    if (_e2184.x < _e2186.x) {
                                                                                        phi_2756_ = _e2184.x;
                                                                                    } else {
                                                                                        phi_2756_ = _e2186.x;
                                                                                    }
                                                                                    let _e2193 = phi_2756_;
                                                                                    if (_e2184.y < _e2186.y) {
                                                                                        phi_2765_ = _e2184.y;
                                                                                    } else {
                                                                                        phi_2765_ = _e2186.y;
                                                                                    }
                                                                                    let _e2200 = phi_2765_;
                                                                                    if (_e2184.z < _e2186.z) {
                                                                                        phi_2774_ = _e2184.z;
                                                                                    } else {
                                                                                        phi_2774_ = _e2186.z;
                                                                                    }
                                                                                    let _e2207 = phi_2774_;
                                                                                    let _e2209 = triangles.member[(0u + _e1981)].v2_;
                                                                                    if (_e2193 < _e2209.x) {
                                                                                        phi_2783_ = _e2193;
                                                                                    } else {
                                                                                        phi_2783_ = _e2209.x;
                                                                                    }
                                                                                    let _e2214 = phi_2783_;
                                                                                    if (_e2200 < _e2209.y) {
                                                                                        phi_2790_ = _e2200;
                                                                                    } else {
                                                                                        phi_2790_ = _e2209.y;
                                                                                    }
                                                                                    let _e2219 = phi_2790_;
                                                                                    if (_e2207 < _e2209.z) {
                                                                                        phi_2797_ = _e2207;
                                                                                    } else {
                                                                                        phi_2797_ = _e2209.z;
                                                                                    }
                                                                                    let _e2224 = phi_2797_;
                                                                                    let _e2226 = triangles.member[(0u + _e1981)].v0_;
                                                                                    let _e2228 = triangles.member[(0u + _e1981)].v1_;
                                                                                    if (_e2226.x > _e2228.x) {
                                                                                        phi_2810_ = _e2226.x;
                                                                                    } else {
                                                                                        phi_2810_ = _e2228.x;
                                                                                    }
                                                                                    let _e2235 = phi_2810_;
                                                                                    if (_e2226.y > _e2228.y) {
                                                                                        phi_2819_ = _e2226.y;
                                                                                    } else {
                                                                                        phi_2819_ = _e2228.y;
                                                                                    }
                                                                                    let _e2242 = phi_2819_;
                                                                                    if (_e2226.z > _e2228.z) {
                                                                                        phi_2828_ = _e2226.z;
                                                                                    } else {
                                                                                        phi_2828_ = _e2228.z;
                                                                                    }
                                                                                    let _e2249 = phi_2828_;
                                                                                    let _e2251 = triangles.member[(0u + _e1981)].v2_;
                                                                                    if (_e2235 > _e2251.x) {
                                                                                        phi_2837_ = _e2235;
                                                                                    } else {
                                                                                        phi_2837_ = _e2251.x;
                                                                                    }
                                                                                    let _e2256 = phi_2837_;
                                                                                    if (_e2242 > _e2251.y) {
                                                                                        phi_2844_ = _e2242;
                                                                                    } else {
                                                                                        phi_2844_ = _e2251.y;
                                                                                    }
                                                                                    let _e2261 = phi_2844_;
                                                                                    if (_e2249 > _e2251.z) {
                                                                                        phi_2851_ = _e2249;
                                                                                    } else {
                                                                                        phi_2851_ = _e2251.z;
                                                                                    }
                                                                                    let _e2266 = phi_2851_;
                                                                                    let _e2270 = ((_e2214 - _e1080) * _e1295);
                                                                                    let _e2271 = ((_e2219 - _e1093) * _e1305);
                                                                                    let _e2272 = ((_e2224 - _e1106) * _e1315);
                                                                                    let _e2276 = ((_e2256 - _e1080) * _e1295);
                                                                                    let _e2277 = ((_e2261 - _e1093) * _e1305);
                                                                                    let _e2278 = ((_e2266 - _e1106) * _e1315);
                                                                                    if (_e2270 < _e2276) {
                                                                                        phi_2868_ = _e2270;
                                                                                    } else {
                                                                                        phi_2868_ = _e2276;
                                                                                    }
                                                                                    let _e2281 = phi_2868_;
                                                                                    if (_e2271 < _e2277) {
                                                                                        phi_2873_ = _e2271;
                                                                                    } else {
                                                                                        phi_2873_ = _e2277;
                                                                                    }
                                                                                    let _e2284 = phi_2873_;
                                                                                    if (_e2272 < _e2278) {
                                                                                        phi_2878_ = _e2272;
                                                                                    } else {
                                                                                        phi_2878_ = _e2278;
                                                                                    }
                                                                                    let _e2287 = phi_2878_;
                                                                                    if (_e2270 > _e2276) {
                                                                                        phi_2886_ = _e2270;
                                                                                    } else {
                                                                                        phi_2886_ = _e2276;
                                                                                    }
                                                                                    let _e2293 = phi_2886_;
                                                                                    if (_e2271 > _e2277) {
                                                                                        phi_2891_ = _e2271;
                                                                                    } else {
                                                                                        phi_2891_ = _e2277;
                                                                                    }
                                                                                    let _e2296 = phi_2891_;
                                                                                    if (_e2272 > _e2278) {
                                                                                        phi_2896_ = _e2272;
                                                                                    } else {
                                                                                        phi_2896_ = _e2278;
                                                                                    }
                                                                                    let _e2299 = phi_2896_;
                                                                                    let _e2303 = core_intrinsics_maximum_number_nsz_f32_((_e2281 - _e1350), (_e2284 - _e1351));
                                                                                    let _e2304 = core_intrinsics_maximum_number_nsz_f32_(_e2303, (_e2287 - _e1352));
                                                                                    let _e2305 = core_intrinsics_minimum_number_nsz_f32_((_e2293 + _e1350), (_e2296 + _e1351));
                                                                                    let _e2306 = core_intrinsics_minimum_number_nsz_f32_(_e2305, (_e2299 + _e1352));
                                                                                    if (_e2304 > _e1055) {
                                                                                        phi_2908_ = _e2304;
                                                                                    } else {
                                                                                        phi_2908_ = _e1055;
                                                                                    }
                                                                                    let _e2309 = phi_2908_;
                                                                                    if (_e2306 < _e1057) {
                                                                                        phi_2913_ = _e2306;
                                                                                    } else {
                                                                                        phi_2913_ = _e1057;
                                                                                    }
                                                                                    let _e2312 = phi_2913_;
                                                                                    if (_e2180 < _e2309) {
                                                                                        phi_2918_ = _e2309;
                                                                                    } else {
                                                                                        phi_2918_ = _e2180;
                                                                                    }
                                                                                    let _e2315 = phi_2918_;
                                                                                    if (_e2315 > _e2312) {
                                                                                        phi_2923_ = _e2312;
                                                                                    } else {
                                                                                        phi_2923_ = _e2315;
                                                                                    }
                                                                                    let _e2318 = phi_2923_;
                                                                                    phi_2928_ = lt_bvh_triangle_Intersection(_e2318, (_e2112 / _e2171), (_e2133 / _e2171), (_e2309 <= _e2312));
                                                                                    phi_2929_ = false;
                                                                                } else {
                                                                                    phi_2928_ = lt_bvh_triangle_Intersection();
                                                                                    phi_2929_ = true;
                                                                                }
                                                                                let _e2324 = phi_2928_;
                                                                                let _e2326 = phi_2929_;
                                                                                phi_2930_ = _e2324;
                                                                                phi_2931_ = _e2326;
                                                                            } else {
                                                                                phi_2930_ = lt_bvh_triangle_Intersection();
                                                                                phi_2931_ = true;
                                                                            }
                                                                            let _e2328 = phi_2930_;
                                                                            let _e2330 = phi_2931_;
                                                                            if _e2330 {
                                                                            }
                                                                            phi_2935_ = _e2328;
                                                                            phi_2936_ = _e2330;
                                                                        }
                                                                        let _e2332 = phi_2935_;
                                                                        let _e2334 = phi_2936_;
                                                                        phi_2937_ = _e2332;
                                                                        phi_2938_ = _e2174;
                                                                        phi_2939_ = _e2334;
                                                                    } else {
                                                                        phi_2937_ = lt_bvh_triangle_Intersection();
                                                                        phi_2938_ = true;
                                                                        phi_2939_ = false;
                                                                    }
                                                                    let _e2336 = phi_2937_;
                                                                    let _e2338 = phi_2938_;
                                                                    let _e2340 = phi_2939_;
                                                                    if _e2338 {
                                                                        phi_2943_ = true;
                                                                    } else {
                                                                        phi_2943_ = _e2340;
                                                                    }
                                                                    let _e2342 = phi_2943_;
                                                                    if _e2342 {
                                                                        phi_2947_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_2947_ = _e2336;
                                                                    }
                                                                    let _e2344 = phi_2947_;
                                                                    if _e2344.is_hit {
                                                                        if (_e2344.t > _e170.tmin) {
                                                                            if (_e2344.t < _e1970.t) {
                                                                                phi_2995_ = true;
                                                                            } else {
                                                                                if (_e2344.t == _e1970.t) {
                                                                                    if (_e1970.triangle != 4294967295u) {
                                                                                        if (_e1981 < _e1970.triangle) {
                                                                                            phi_2986_ = true;
                                                                                        } else {
                                                                                            if (_e1981 == _e1970.triangle) {
                                                                                                phi_2985_ = (_e996 < _e1970.instance);
                                                                                            } else {
                                                                                                phi_2985_ = false;
                                                                                            }
                                                                                            let _e2362 = phi_2985_;
                                                                                            phi_2986_ = _e2362;
                                                                                        }
                                                                                        let _e2364 = phi_2986_;
                                                                                        phi_2987_ = _e2364;
                                                                                        phi_2988_ = false;
                                                                                    } else {
                                                                                        phi_2987_ = bool();
                                                                                        phi_2988_ = true;
                                                                                    }
                                                                                    let _e2366 = phi_2987_;
                                                                                    let _e2368 = phi_2988_;
                                                                                    phi_2989_ = _e2366;
                                                                                    phi_2990_ = _e2368;
                                                                                } else {
                                                                                    phi_2989_ = bool();
                                                                                    phi_2990_ = true;
                                                                                }
                                                                                let _e2370 = phi_2989_;
                                                                                let _e2372 = phi_2990_;
                                                                                if _e2372 {
                                                                                    phi_2994_ = false;
                                                                                } else {
                                                                                    phi_2994_ = _e2370;
                                                                                }
                                                                                let _e2374 = phi_2994_;
                                                                                phi_2995_ = _e2374;
                                                                            }
                                                                            let _e2376 = phi_2995_;
                                                                            if _e2376 {
                                                                                let _e2378 = triangles.member[(0u + _e1981)].i0_;
                                                                                if ((_e2378 & 2147483648u) == 0u) {
                                                                                    phi_3206_ = true;
                                                                                } else {
                                                                                    if (_e1981 < _e83) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2387 = triangles.member[(0u + _e1981)].i0_;
                                                                                    let _e2388 = (_e2387 & 2147483647u);
                                                                                    let _e2390 = triangles.member[(0u + _e1981)].i1_;
                                                                                    let _e2392 = triangles.member[(0u + _e1981)].i2_;
                                                                                    if (_e2388 < _e86) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2396 = vertices.member[(0u + _e2388)];
                                                                                    if (_e2390 < _e86) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2400 = vertices.member[(0u + _e2390)];
                                                                                    if (_e2392 < _e86) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2404 = vertices.member[(0u + _e2392)];
                                                                                    let _e2405 = array<abi_Vertex, 3>(_e2396, _e2400, _e2404);
                                                                                    if (_e2405[0].material < _e89) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2411 = materials.member[(0u + _e2405[0].material)];
                                                                                    if ((_e2411.flags & 0u) == 0u) {
                                                                                        let _e2416 = ((1f - _e2344.u) - _e2344.v);
                                                                                        if (_e2411.cutoff <= 0f) {
                                                                                            phi_3201_ = true;
                                                                                        } else {
                                                                                            let _e2443 = (_e2411.base_color.w * ((((f32((_e2405[0].color >> bitcast<u32>(24i))) * _e2416) + (f32((_e2405[1].color >> bitcast<u32>(24i))) * _e2344.u)) + (f32((_e2405[2].color >> bitcast<u32>(24i))) * _e2344.v)) * (1f / 255f)));
                                                                                            if (_e2411.alpha_size == 0u) {
                                                                                                phi_3198_ = _e2443;
                                                                                            } else {
                                                                                                local_1.offset = _e2411.alpha_offset;
                                                                                                local_1.size = _e2411.alpha_size;
                                                                                                local_1.flags = _e2411.flags;
                                                                                                let _e2474 = _lt_shaders_texture_TextureView_quad((&local_1), (((_e2405[0].u * _e2416) + (_e2405[1].u * _e2344.u)) + (_e2405[2].u * _e2344.v)), (((_e2405[0].v * _e2416) + (_e2405[1].v * _e2344.u)) + (_e2405[2].v * _e2344.v)));
                                                                                                let _e2478 = (_e2474.indices[0] >> bitcast<u32>(2i));
                                                                                                if (_e2478 < _e98) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2482 = alpha_texels.member[(0u + _e2478)];
                                                                                                let _e2498 = (_e2474.indices[1] >> bitcast<u32>(2i));
                                                                                                if (_e2498 < _e98) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2502 = alpha_texels.member[(0u + _e2498)];
                                                                                                let _e2519 = (_e2474.indices[2] >> bitcast<u32>(2i));
                                                                                                if (_e2519 < _e98) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2523 = alpha_texels.member[(0u + _e2519)];
                                                                                                let _e2540 = (_e2474.indices[3] >> bitcast<u32>(2i));
                                                                                                if (_e2540 < _e98) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2544 = alpha_texels.member[(0u + _e2540)];
                                                                                                phi_3198_ = (_e2443 * (((((f32(((_e2482 >> bitcast<u32>((((_e2474.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2474.weights.x) + ((f32(((_e2502 >> bitcast<u32>((((_e2474.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2474.weights.y)) + ((f32(((_e2523 >> bitcast<u32>((((_e2474.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2474.weights.z)) + ((f32(((_e2544 >> bitcast<u32>((((_e2474.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2474.weights.w)));
                                                                                            }
                                                                                            let _e2560 = phi_3198_;
                                                                                            phi_3201_ = (_e2560 >= _e2411.cutoff);
                                                                                        }
                                                                                        let _e2564 = phi_3201_;
                                                                                        phi_3202_ = _e2564;
                                                                                    } else {
                                                                                        phi_3202_ = false;
                                                                                    }
                                                                                    let _e2566 = phi_3202_;
                                                                                    if _e2566 {
                                                                                    }
                                                                                    phi_3206_ = _e2566;
                                                                                }
                                                                                let _e2568 = phi_3206_;
                                                                                if _e2568 {
                                                                                    phi_3214_ = lt_bvh_Hit(_e2344.t, _e2344.u, _e2344.v, _e1981, _e996);
                                                                                } else {
                                                                                    phi_3214_ = _e1970;
                                                                                }
                                                                                let _e2574 = phi_3214_;
                                                                                phi_3215_ = _e2574;
                                                                            } else {
                                                                                phi_3215_ = _e1970;
                                                                            }
                                                                            let _e2576 = phi_3215_;
                                                                            phi_3216_ = _e2576;
                                                                        } else {
                                                                            phi_3216_ = _e1970;
                                                                        }
                                                                        let _e2578 = phi_3216_;
                                                                        phi_3217_ = _e2578;
                                                                    } else {
                                                                        phi_3217_ = _e1970;
                                                                    }
                                                                    let _e2580 = phi_3217_;
                                                                    phi_2474_ = _e2580;
                                                                    phi_2477_ = (_e1972 & (_e1972 - 1u));
                                                                    phi_3218_ = true;
                                                                }
                                                                let _e2582 = phi_2474_;
                                                                let _e2584 = phi_2477_;
                                                                let _e2586 = phi_3218_;
                                                                continue;
                                                                continuing {
                                                                    phi_2473_ = _e2582;
                                                                    phi_2476_ = _e2584;
                                                                    break if !(_e2586);
                                                                }
                                                            }
                                                            let _e2589 = local_2.group_mask;
                                                            if ((_e2589 & 4278190080u) == 0u) {
                                                                let _e2593 = local_2.len;
                                                                if (_e2593 == 0u) {
                                                                    phi_3257_ = false;
                                                                } else {
                                                                    let _e2597 = local_2.len;
                                                                    local_2.len = (_e2597 - 1u);
                                                                    let _e2600 = local_2.len;
                                                                    if (_e2600 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2605 = local_2.first[(0u + _e2600)];
                                                                    local_2.group = _e2605;
                                                                    let _e2608 = local_2.len;
                                                                    if (_e2608 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2613 = local_2.mask[(0u + _e2608)];
                                                                    local_2.group_mask = _e2613;
                                                                    phi_3257_ = true;
                                                                }
                                                                let _e2616 = phi_3257_;
                                                                phi_3258_ = _e2616;
                                                            } else {
                                                                phi_3258_ = true;
                                                            }
                                                            let _e2618 = phi_3258_;
                                                            if _e2618 {
                                                                let _e2620 = local_2.group_mask;
                                                                let _e2626 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2620)), 32u, (_e2620 == 0u)));
                                                                let _e2630 = local_2.group_mask;
                                                                let _e2644 = local_2.group_mask;
                                                                local_2.group_mask = (_e2644 & ~((1u << bitcast<u32>((_e2626 & 31u)))));
                                                                let _e2647 = local_2.group;
                                                                phi_3289_ = (_e2647 + countOneBits(((_e2630 & ~((4294967295u << bitcast<u32>((((_e2626 - 24u) ^ _e1393) & 31u))))) & 255u)));
                                                            } else {
                                                                phi_3289_ = 4294967295u;
                                                            }
                                                            let _e2650 = phi_3289_;
                                                            let _e3970 = local_10;
                                                            phi_2141_ = _e3970;
                                                            phi_2144_ = _e2650;
                                                        } else {
                                                            phi_2141_ = lt_bvh_Hit();
                                                            phi_2144_ = u32();
                                                        }
                                                        let _e2652 = phi_2141_;
                                                        let _e2654 = phi_2144_;
                                                        continue;
                                                        continuing {
                                                            phi_2140_ = _e2652;
                                                            phi_2143_ = _e2654;
                                                            break if !(_e1534);
                                                        }
                                                    }
                                                    let _e3974 = local_11;
                                                    phi_3290_ = _e3974;
                                                }
                                                let _e2657 = phi_3290_;
                                                phi_3291_ = _e2657;
                                                phi_3292_ = _e1219;
                                            } else {
                                                phi_3291_ = lt_bvh_Hit();
                                                phi_3292_ = true;
                                            }
                                            let _e2659 = phi_3291_;
                                            let _e2661 = phi_3292_;
                                            if _e2661 {
                                                phi_3296_ = _e988;
                                            } else {
                                                phi_3296_ = _e2659;
                                            }
                                            let _e2663 = phi_3296_;
                                            phi_3297_ = _e2663;
                                        } else {
                                            phi_3297_ = _e988;
                                        }
                                        let _e2665 = phi_3297_;
                                        phi_3298_ = _e2665;
                                    } else {
                                        phi_3298_ = _e988;
                                    }
                                    let _e2667 = phi_3298_;
                                    phi_3299_ = _e2667;
                                } else {
                                    phi_3299_ = _e988;
                                }
                                let _e2669 = phi_3299_;
                                phi_1515_ = (_e986 & (_e986 - 1u));
                                phi_1518_ = _e2669;
                                phi_3300_ = true;
                            }
                            let _e2671 = phi_1515_;
                            let _e2673 = phi_1518_;
                            let _e2675 = phi_3300_;
                            continue;
                            continuing {
                                phi_1514_ = _e2671;
                                phi_1517_ = _e2673;
                                break if !(_e2675);
                            }
                        }
                        let _e2678 = local_3.group_mask;
                        if ((_e2678 & 4278190080u) == 0u) {
                            let _e2682 = local_3.len;
                            if (_e2682 == 0u) {
                                phi_3339_ = false;
                            } else {
                                let _e2686 = local_3.len;
                                local_3.len = (_e2686 - 1u);
                                let _e2689 = local_3.len;
                                if (_e2689 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2694 = local_3.first[(0u + _e2689)];
                                local_3.group = _e2694;
                                let _e2697 = local_3.len;
                                if (_e2697 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2702 = local_3.mask[(0u + _e2697)];
                                local_3.group_mask = _e2702;
                                phi_3339_ = true;
                            }
                            let _e2705 = phi_3339_;
                            phi_3340_ = _e2705;
                        } else {
                            phi_3340_ = true;
                        }
                        let _e2707 = phi_3340_;
                        if _e2707 {
                            let _e2709 = local_3.group_mask;
                            let _e2715 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2709)), 32u, (_e2709 == 0u)));
                            let _e2719 = local_3.group_mask;
                            let _e2733 = local_3.group_mask;
                            local_3.group_mask = (_e2733 & ~((1u << bitcast<u32>((_e2715 & 31u)))));
                            let _e2736 = local_3.group;
                            phi_3371_ = (_e2736 + countOneBits(((_e2719 & ~((4294967295u << bitcast<u32>((((_e2715 - 24u) ^ _e405) & 31u))))) & 255u)));
                        } else {
                            phi_3371_ = 4294967295u;
                        }
                        let _e2739 = phi_3371_;
                        phi_1178_ = _e2739;
                        let _e3990 = local_12;
                        phi_1181_ = _e3990;
                    } else {
                        phi_1178_ = u32();
                        phi_1181_ = lt_bvh_Hit();
                    }
                    let _e2741 = phi_1178_;
                    let _e2743 = phi_1181_;
                    continue;
                    continuing {
                        phi_1177_ = _e2741;
                        phi_1180_ = _e2743;
                        break if !(_e546);
                    }
                }
                let _e3993 = local_13;
                phi_3372_ = _e3993;
            }
            let _e2746 = phi_3372_;
            phi_3373_ = _e2746;
            phi_3374_ = _e242;
        } else {
            phi_3373_ = lt_bvh_Hit();
            phi_3374_ = true;
        }
        let _e2748 = phi_3373_;
        let _e2750 = phi_3374_;
        if _e2750 {
            phi_3378_ = _e172;
        } else {
            phi_3378_ = _e2748;
        }
        let _e2752 = phi_3378_;
        if (_e2752.triangle != 4294967295u) {
            let _e2758 = ((1f - _e2752.u) - _e2752.v);
            if (_e2752.triangle < _e83) {
            } else {
                return;
            }
            let _e2763 = triangles.member[(0u + _e2752.triangle)];
            if (_e2752.instance < _e95) {
            } else {
                return;
            }
            let _e2774 = instances.member[(0u + _e2752.instance)].object_to_world[0u];
            let _e2785 = ((((_e2774.x * _e2763.v0_.x) + (_e2774.y * _e2763.v0_.y)) + (_e2774.z * _e2763.v0_.z)) + (_e2774.w * 1f));
            let _e2787 = instances.member[(0u + _e2752.instance)].object_to_world[1u];
            let _e2798 = ((((_e2787.x * _e2763.v0_.x) + (_e2787.y * _e2763.v0_.y)) + (_e2787.z * _e2763.v0_.z)) + (_e2787.w * 1f));
            let _e2800 = instances.member[(0u + _e2752.instance)].object_to_world[2u];
            let _e2811 = ((((_e2800.x * _e2763.v0_.x) + (_e2800.y * _e2763.v0_.y)) + (_e2800.z * _e2763.v0_.z)) + (_e2800.w * 1f));
            let _e2818 = instances.member[(0u + _e2752.instance)].object_to_world[0u];
            let _e2829 = ((((_e2818.x * _e2763.v1_.x) + (_e2818.y * _e2763.v1_.y)) + (_e2818.z * _e2763.v1_.z)) + (_e2818.w * 1f));
            let _e2831 = instances.member[(0u + _e2752.instance)].object_to_world[1u];
            let _e2842 = ((((_e2831.x * _e2763.v1_.x) + (_e2831.y * _e2763.v1_.y)) + (_e2831.z * _e2763.v1_.z)) + (_e2831.w * 1f));
            let _e2844 = instances.member[(0u + _e2752.instance)].object_to_world[2u];
            let _e2855 = ((((_e2844.x * _e2763.v1_.x) + (_e2844.y * _e2763.v1_.y)) + (_e2844.z * _e2763.v1_.z)) + (_e2844.w * 1f));
            let _e2862 = instances.member[(0u + _e2752.instance)].object_to_world[0u];
            let _e2873 = ((((_e2862.x * _e2763.v2_.x) + (_e2862.y * _e2763.v2_.y)) + (_e2862.z * _e2763.v2_.z)) + (_e2862.w * 1f));
            let _e2875 = instances.member[(0u + _e2752.instance)].object_to_world[1u];
            let _e2886 = ((((_e2875.x * _e2763.v2_.x) + (_e2875.y * _e2763.v2_.y)) + (_e2875.z * _e2763.v2_.z)) + (_e2875.w * 1f));
            let _e2888 = instances.member[(0u + _e2752.instance)].object_to_world[2u];
            let _e2899 = ((((_e2888.x * _e2763.v2_.x) + (_e2888.y * _e2763.v2_.y)) + (_e2888.z * _e2763.v2_.z)) + (_e2888.w * 1f));
            let _e2912 = (((_e2785 * _e2758) + (_e2829 * _e2752.u)) + (_e2873 * _e2752.v));
            let _e2913 = (((_e2798 * _e2758) + (_e2842 * _e2752.u)) + (_e2886 * _e2752.v));
            let _e2914 = (((_e2811 * _e2758) + (_e2855 * _e2752.u)) + (_e2899 * _e2752.v));
            let _e2916 = abs(_e2785);
            let _e2917 = abs(_e2798);
            let _e2918 = abs(_e2811);
            let _e2919 = abs(_e2829);
            let _e2920 = abs(_e2842);
            let _e2921 = abs(_e2855);
            if (_e2916 > _e2919) {
                phi_3565_ = _e2916;
            } else {
                phi_3565_ = _e2919;
            }
            let _e2924 = phi_3565_;
            if (_e2917 > _e2920) {
                phi_3570_ = _e2917;
            } else {
                phi_3570_ = _e2920;
            }
            let _e2927 = phi_3570_;
            if (_e2918 > _e2921) {
                phi_3575_ = _e2918;
            } else {
                phi_3575_ = _e2921;
            }
            let _e2930 = phi_3575_;
            let _e2931 = abs(_e2873);
            let _e2932 = abs(_e2886);
            let _e2933 = abs(_e2899);
            if (_e2924 > _e2931) {
                phi_3583_ = _e2924;
            } else {
                phi_3583_ = _e2931;
            }
            let _e2936 = phi_3583_;
            if (_e2927 > _e2932) {
                phi_3588_ = _e2927;
            } else {
                phi_3588_ = _e2932;
            }
            let _e2939 = phi_3588_;
            if (_e2930 > _e2933) {
                phi_3593_ = _e2930;
            } else {
                phi_3593_ = _e2933;
            }
            let _e2942 = phi_3593_;
            let _e2943 = (_e2829 - _e2785);
            let _e2944 = (_e2842 - _e2798);
            let _e2945 = (_e2855 - _e2811);
            let _e2946 = (_e2873 - _e2785);
            let _e2947 = (_e2886 - _e2798);
            let _e2948 = (_e2899 - _e2811);
            let _e2952 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2944), abs(_e2945));
            let _e2953 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2943), _e2952);
            let _e2954 = (_e2943 / _e2953);
            let _e2955 = (_e2944 / _e2953);
            let _e2956 = (_e2945 / _e2953);
            let _e2960 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2947), abs(_e2948));
            let _e2961 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2946), _e2960);
            let _e2962 = (_e2946 / _e2961);
            let _e2963 = (_e2947 / _e2961);
            let _e2964 = (_e2948 / _e2961);
            let _e2967 = ((_e2955 * _e2964) - (_e2963 * _e2956));
            let _e2970 = ((_e2956 * _e2962) - (_e2964 * _e2954));
            let _e2973 = ((_e2954 * _e2963) - (_e2962 * _e2955));
            let _e2975 = p.member.eye;
            let _e2988 = (1f / sqrt((((_e2967 * _e2967) + (_e2970 * _e2970)) + (_e2973 * _e2973))));
            let _e2989 = (_e2967 * _e2988);
            let _e2990 = (_e2970 * _e2988);
            let _e2991 = (_e2973 * _e2988);
            if ((((_e2989 * (_e2975.x - _e2912)) + (_e2990 * (_e2975.y - _e2913))) + (_e2991 * (_e2975.z - _e2914))) < 0f) {
                phi_3657_ = vec3<f32>(-(_e2989), -(_e2990), -(_e2991));
            } else {
                phi_3657_ = vec3<f32>(_e2989, _e2990, _e2991);
            }
            let _e3004 = phi_3657_;
            if (_e2752.triangle < _e83) {
            } else {
                return;
            }
            let _e3009 = triangles.member[(0u + _e2752.triangle)];
            let _e3011 = (_e3009.i0_ & 2147483647u);
            if (_e3011 < _e86) {
            } else {
                return;
            }
            let _e3017 = vertices.member[(0u + _e3011)];
            if (_e3009.i1_ < _e86) {
            } else {
                return;
            }
            let _e3021 = vertices.member[(0u + _e3009.i1_)];
            if (_e3009.i2_ < _e86) {
            } else {
                return;
            }
            let _e3025 = vertices.member[(0u + _e3009.i2_)];
            let _e3026 = array<abi_Vertex, 3>(_e3017, _e3021, _e3025);
            if (_e3026[0].material < _e89) {
            } else {
                return;
            }
            let _e3032 = materials.member[(0u + _e3026[0].material)];
            let _e3049 = (1f / 255f);
            let _e3068 = (1f / 255f);
            let _e3090 = (1f / 255f);
            if (_e3032.color_size == 0u) {
                phi_3900_ = vec3<f32>(1f, 1f, 1f);
            } else {
                local.offset = _e3032.color_offset;
                local.size = _e3032.color_size;
                local.flags = _e3032.flags;
                let _e3133 = _lt_shaders_texture_TextureView_quad((&local), (((_e3026[0].u * _e2758) + (_e3026[1].u * _e2752.u)) + (_e3026[2].u * _e2752.v)), (((_e3026[0].v * _e2758) + (_e3026[1].v * _e2752.u)) + (_e3026[2].v * _e2752.v)));
                if (_e3133.indices[0] < _e101) {
                } else {
                    return;
                }
                let _e3139 = color_texels.member[(0u + _e3133.indices[0])];
                let _e3150 = (1f / 255f);
                if (_e3133.indices[1] < _e101) {
                } else {
                    return;
                }
                let _e3164 = color_texels.member[(0u + _e3133.indices[1])];
                let _e3175 = (1f / 255f);
                if (_e3133.indices[2] < _e101) {
                } else {
                    return;
                }
                let _e3192 = color_texels.member[(0u + _e3133.indices[2])];
                let _e3203 = (1f / 255f);
                if (_e3133.indices[3] < _e101) {
                } else {
                    return;
                }
                let _e3220 = color_texels.member[(0u + _e3133.indices[3])];
                let _e3231 = (1f / 255f);
                let _e3240 = (((((f32((_e3139 & 255u)) * _e3150) * _e3133.weights.x) + ((f32((_e3164 & 255u)) * _e3175) * _e3133.weights.y)) + ((f32((_e3192 & 255u)) * _e3203) * _e3133.weights.z)) + ((f32((_e3220 & 255u)) * _e3231) * _e3133.weights.w));
                let _e3241 = (((((f32(((_e3139 >> bitcast<u32>(8i)) & 255u)) * _e3150) * _e3133.weights.x) + ((f32(((_e3164 >> bitcast<u32>(8i)) & 255u)) * _e3175) * _e3133.weights.y)) + ((f32(((_e3192 >> bitcast<u32>(8i)) & 255u)) * _e3203) * _e3133.weights.z)) + ((f32(((_e3220 >> bitcast<u32>(8i)) & 255u)) * _e3231) * _e3133.weights.w));
                let _e3242 = (((((f32(((_e3139 >> bitcast<u32>(16i)) & 255u)) * _e3150) * _e3133.weights.x) + ((f32(((_e3164 >> bitcast<u32>(16i)) & 255u)) * _e3175) * _e3133.weights.y)) + ((f32(((_e3192 >> bitcast<u32>(16i)) & 255u)) * _e3203) * _e3133.weights.z)) + ((f32(((_e3220 >> bitcast<u32>(16i)) & 255u)) * _e3231) * _e3133.weights.w));
                phi_3900_ = vec3<f32>((_e3240 * _e3240), (_e3241 * _e3241), (_e3242 * _e3242));
            }
            let _e3248 = phi_3900_;
            let _e3250 = ((_e3032.base_color.x * ((((f32((_e3026[0].color & 255u)) * _e3049) * _e2758) + ((f32((_e3026[1].color & 255u)) * _e3068) * _e2752.u)) + ((f32((_e3026[2].color & 255u)) * _e3090) * _e2752.v))) * _e3248.x);
            let _e3252 = ((_e3032.base_color.y * ((((f32(((_e3026[0].color >> bitcast<u32>(8i)) & 255u)) * _e3049) * _e2758) + ((f32(((_e3026[1].color >> bitcast<u32>(8i)) & 255u)) * _e3068) * _e2752.u)) + ((f32(((_e3026[2].color >> bitcast<u32>(8i)) & 255u)) * _e3090) * _e2752.v))) * _e3248.y);
            let _e3254 = ((_e3032.base_color.z * ((((f32(((_e3026[0].color >> bitcast<u32>(16i)) & 255u)) * _e3049) * _e2758) + ((f32(((_e3026[1].color >> bitcast<u32>(16i)) & 255u)) * _e3068) * _e2752.u)) + ((f32(((_e3026[2].color >> bitcast<u32>(16i)) & 255u)) * _e3090) * _e2752.v))) * _e3248.z);
            let _e3255 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e2939, _e2942);
            let _e3256 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e2936, _e3255);
            if ((_e3032.flags & 2u) == 0u) {
                phi_3915_ = 0u;
            } else {
                phi_3915_ = 1u;
            }
            let _e3261 = phi_3915_;
            if (_e3026[0].normal == 2147516416u) {
                phi_4145_ = _e3004;
            } else {
                let _e3274 = (f32((bitcast<i32>((_e3026[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3280 = (f32((bitcast<i32>(_e3026[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3284 = ((1f - abs(_e3274)) - abs(_e3280));
                if (_e3284 < 0f) {
                    phi_3942_ = -(_e3284);
                } else {
                    phi_3942_ = 0f;
                }
                let _e3288 = phi_3942_;
                if (_e3274 < 0f) {
                    phi_3949_ = (_e3274 + _e3288);
                } else {
                    phi_3949_ = (_e3274 - _e3288);
                }
                let _e3293 = phi_3949_;
                if (_e3280 < 0f) {
                    phi_3956_ = (_e3280 + _e3288);
                } else {
                    phi_3956_ = (_e3280 - _e3288);
                }
                let _e3298 = phi_3956_;
                let _e3305 = (1f / sqrt((((_e3293 * _e3293) + (_e3298 * _e3298)) + (_e3284 * _e3284))));
                let _e3321 = (f32((bitcast<i32>((_e3026[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3327 = (f32((bitcast<i32>(_e3026[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3331 = ((1f - abs(_e3321)) - abs(_e3327));
                if (_e3331 < 0f) {
                    phi_3991_ = -(_e3331);
                } else {
                    phi_3991_ = 0f;
                }
                let _e3335 = phi_3991_;
                if (_e3321 < 0f) {
                    phi_3998_ = (_e3321 + _e3335);
                } else {
                    phi_3998_ = (_e3321 - _e3335);
                }
                let _e3340 = phi_3998_;
                if (_e3327 < 0f) {
                    phi_4005_ = (_e3327 + _e3335);
                } else {
                    phi_4005_ = (_e3327 - _e3335);
                }
                let _e3345 = phi_4005_;
                let _e3352 = (1f / sqrt((((_e3340 * _e3340) + (_e3345 * _e3345)) + (_e3331 * _e3331))));
                let _e3371 = (f32((bitcast<i32>((_e3026[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3377 = (f32((bitcast<i32>(_e3026[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3381 = ((1f - abs(_e3371)) - abs(_e3377));
                if (_e3381 < 0f) {
                    phi_4043_ = -(_e3381);
                } else {
                    phi_4043_ = 0f;
                }
                let _e3385 = phi_4043_;
                if (_e3371 < 0f) {
                    phi_4050_ = (_e3371 + _e3385);
                } else {
                    phi_4050_ = (_e3371 - _e3385);
                }
                let _e3390 = phi_4050_;
                if (_e3377 < 0f) {
                    phi_4057_ = (_e3377 + _e3385);
                } else {
                    phi_4057_ = (_e3377 - _e3385);
                }
                let _e3395 = phi_4057_;
                let _e3402 = (1f / sqrt((((_e3390 * _e3390) + (_e3395 * _e3395)) + (_e3381 * _e3381))));
                let _e3409 = ((((_e3293 * _e3305) * _e2758) + ((_e3340 * _e3352) * _e2752.u)) + ((_e3390 * _e3402) * _e2752.v));
                let _e3410 = ((((_e3298 * _e3305) * _e2758) + ((_e3345 * _e3352) * _e2752.u)) + ((_e3395 * _e3402) * _e2752.v));
                let _e3411 = ((((_e3284 * _e3305) * _e2758) + ((_e3331 * _e3352) * _e2752.u)) + ((_e3381 * _e3402) * _e2752.v));
                if (_e2752.instance < _e95) {
                } else {
                    return;
                }
                let _e3418 = instances.member[(0u + _e2752.instance)].world_to_object[0u];
                let _e3427 = instances.member[(0u + _e2752.instance)].world_to_object[1u];
                let _e3439 = instances.member[(0u + _e2752.instance)].world_to_object[2u];
                let _e3446 = (((_e3418.x * _e3409) + (_e3427.x * _e3410)) + (_e3439.x * _e3411));
                let _e3447 = (((_e3418.y * _e3409) + (_e3427.y * _e3410)) + (_e3439.y * _e3411));
                let _e3448 = (((_e3418.z * _e3409) + (_e3427.z * _e3410)) + (_e3439.z * _e3411));
                let _e3454 = sqrt((((_e3446 * _e3446) + (_e3447 * _e3447)) + (_e3448 * _e3448)));
                if (_e3454 > 0f) {
                    let _e3456 = (_e3446 / _e3454);
                    let _e3457 = (_e3447 / _e3454);
                    let _e3458 = (_e3448 / _e3454);
                    if ((((_e3456 * _e3004.x) + (_e3457 * _e3004.y)) + (_e3458 * _e3004.z)) < 0f) {
                        phi_4143_ = vec3<f32>(-(_e3456), -(_e3457), -(_e3458));
                    } else {
                        phi_4143_ = vec3<f32>(_e3456, _e3457, _e3458);
                    }
                    let _e3474 = phi_4143_;
                    phi_4144_ = _e3474;
                } else {
                    phi_4144_ = _e3004;
                }
                let _e3476 = phi_4144_;
                phi_4145_ = _e3476;
            }
            let _e3478 = phi_4145_;
            if (_e3250 > 0f) {
                if (_e3250 < 1f) {
                    phi_4154_ = _e3250;
                } else {
                    phi_4154_ = 1f;
                }
                let _e3482 = phi_4154_;
                phi_4155_ = _e3482;
            } else {
                phi_4155_ = 0f;
            }
            let _e3484 = phi_4155_;
            if (_e3252 > 0f) {
                if (_e3252 < 1f) {
                    phi_4165_ = _e3252;
                } else {
                    phi_4165_ = 1f;
                }
                let _e3489 = phi_4165_;
                phi_4166_ = _e3489;
            } else {
                phi_4166_ = 0f;
            }
            let _e3491 = phi_4166_;
            if (_e3254 > 0f) {
                if (_e3254 < 1f) {
                    phi_4176_ = _e3254;
                } else {
                    phi_4176_ = 1f;
                }
                let _e3496 = phi_4176_;
                phi_4177_ = _e3496;
            } else {
                phi_4177_ = 0f;
            }
            let _e3498 = phi_4177_;
            let _e3501 = ((sqrt(_e3484) * 255f) + 0.5f);
            let _e3510 = ((sqrt(_e3491) * 255f) + 0.5f);
            let _e3522 = ((sqrt(_e3498) * 255f) + 0.5f);
            phi_4212_ = abi_Sample(vec3<f32>(_e2912, _e2913, _e2914), _e3256, _e3004, _e3261, _e3478, ((select(select(u32(_e3501), 0u, (_e3501 < bitcast<f32>(0u))), 4294967295u, (_e3501 > bitcast<f32>(1333788671u))) | (select(select(u32(_e3510), 0u, (_e3510 < bitcast<f32>(0u))), 4294967295u, (_e3510 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e3522), 0u, (_e3522 < bitcast<f32>(0u))), 4294967295u, (_e3522 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_4212_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e3536 = phi_4212_;
        if (_e113.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e113.first_primitive)] = _e3536;
        if (_e2752.triangle != 4294967295u) {
            let _e3545 = ((1f - _e2752.u) - _e2752.v);
            if (_e2752.triangle < _e83) {
            } else {
                return;
            }
            let _e3550 = triangles.member[(0u + _e2752.triangle)];
            let _e3552 = (_e3550.i0_ & 2147483647u);
            if (_e3552 < _e104) {
            } else {
                return;
            }
            let _e3558 = before.member[(0u + _e3552)];
            if (_e3550.i1_ < _e104) {
            } else {
                return;
            }
            let _e3562 = before.member[(0u + _e3550.i1_)];
            if (_e3550.i2_ < _e104) {
            } else {
                return;
            }
            let _e3566 = before.member[(0u + _e3550.i2_)];
            if (_e2752.instance < _e95) {
            } else {
                return;
            }
            let _e3576 = instances.member[(0u + _e2752.instance)].object_to_world[0u];
            let _e3589 = instances.member[(0u + _e2752.instance)].object_to_world[1u];
            let _e3602 = instances.member[(0u + _e2752.instance)].object_to_world[2u];
            if (_e2752.instance < _e95) {
            } else {
                return;
            }
            let _e3626 = instances.member[(0u + _e2752.instance)].object_to_world[0u];
            let _e3639 = instances.member[(0u + _e2752.instance)].object_to_world[1u];
            let _e3652 = instances.member[(0u + _e2752.instance)].object_to_world[2u];
            if (_e2752.instance < _e95) {
            } else {
                return;
            }
            let _e3679 = instances.member[(0u + _e2752.instance)].object_to_world[0u];
            let _e3692 = instances.member[(0u + _e2752.instance)].object_to_world[1u];
            let _e3705 = instances.member[(0u + _e2752.instance)].object_to_world[2u];
            phi_4435_ = vec3<f32>((((((((_e3576.x * _e3558.x) + (_e3576.y * _e3558.y)) + (_e3576.z * _e3558.z)) + (_e3576.w * 1f)) * _e3545) + (((((_e3626.x * _e3562.x) + (_e3626.y * _e3562.y)) + (_e3626.z * _e3562.z)) + (_e3626.w * 1f)) * _e2752.u)) + (((((_e3679.x * _e3566.x) + (_e3679.y * _e3566.y)) + (_e3679.z * _e3566.z)) + (_e3679.w * 1f)) * _e2752.v)), (((((((_e3589.x * _e3558.x) + (_e3589.y * _e3558.y)) + (_e3589.z * _e3558.z)) + (_e3589.w * 1f)) * _e3545) + (((((_e3639.x * _e3562.x) + (_e3639.y * _e3562.y)) + (_e3639.z * _e3562.z)) + (_e3639.w * 1f)) * _e2752.u)) + (((((_e3692.x * _e3566.x) + (_e3692.y * _e3566.y)) + (_e3692.z * _e3566.z)) + (_e3692.w * 1f)) * _e2752.v)), (((((((_e3602.x * _e3558.x) + (_e3602.y * _e3558.y)) + (_e3602.z * _e3558.z)) + (_e3602.w * 1f)) * _e3545) + (((((_e3652.x * _e3562.x) + (_e3652.y * _e3562.y)) + (_e3652.z * _e3562.z)) + (_e3652.w * 1f)) * _e2752.u)) + (((((_e3705.x * _e3566.x) + (_e3705.y * _e3566.y)) + (_e3705.z * _e3566.z)) + (_e3705.w * 1f)) * _e2752.v)));
        } else {
            phi_4435_ = vec3<f32>(0f, 0f, 0f);
        }
        let _e3725 = phi_4435_;
        if (_e113.first_primitive < arrayLength((&past.member))) {
        } else {
            return;
        }
        past.member[(0u + _e113.first_primitive)] = vec4<f32>(_e3725.x, _e3725.y, _e3725.z, 1f);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_instanced_alpha_color_motion_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
