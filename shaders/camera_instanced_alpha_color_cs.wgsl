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

struct type_32 {
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

struct type_36 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_40 {
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

struct type_44 {
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

struct type_55 {
    member: array<lt_bvh_Instance>,
}

struct type_59 {
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
var<storage> vertices: type_40;
@group(0) @binding(4) 
var<storage> materials: type_44;
@group(0) @binding(0) 
var<uniform> p: type_59;
@group(0) @binding(1) 
var<storage> nodes: type_32;
@group(0) @binding(2) 
var<storage> triangles: type_36;
@group(0) @binding(5) 
var<storage, read_write> samples: type_20;
@group(0) @binding(6) 
var<storage> instances: type_55;
@group(0) @binding(7) 
var<storage> alpha_texels: type_9;
@group(0) @binding(8) 
var<storage> color_texels: type_9;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_226_: lt_bvh_traverse_Tree;
    var phi_227_: bool;
    var phi_228_: lt_bvh_traverse_Tree;
    var phi_229_: bool;
    var phi_234_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_226_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_227_ = false;
        } else {
            phi_226_ = lt_bvh_traverse_Tree();
            phi_227_ = true;
        }
        let _e84 = phi_226_;
        let _e86 = phi_227_;
        phi_228_ = _e84;
        phi_229_ = _e86;
    } else {
        phi_228_ = lt_bvh_traverse_Tree();
        phi_229_ = true;
    }
    let _e88 = phi_228_;
    let _e90 = phi_229_;
    if _e90 {
        phi_234_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_234_ = _e88;
    }
    let _e95 = phi_234_;
    return lt_bvh_traverse_Tree(_e95.root, _e95.first_primitive);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_249_: bool;
    var phi_253_: f32;

    if (param_3 != param_3) {
        phi_249_ = true;
    } else {
        let _e74 = (param_4 >= param_3);
        if _e74 {
        }
        phi_249_ = _e74;
    }
    let _e76 = phi_249_;
    if _e76 {
        phi_253_ = param_4;
    } else {
        phi_253_ = param_3;
    }
    let _e78 = phi_253_;
    return _e78;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_265_: bool;
    var phi_269_: f32;

    if (param_5 != param_5) {
        phi_265_ = true;
    } else {
        let _e74 = (param_6 <= param_5);
        if _e74 {
        }
        phi_265_ = _e74;
    }
    let _e76 = phi_265_;
    if _e76 {
        phi_269_ = param_6;
    } else {
        phi_269_ = param_5;
    }
    let _e78 = phi_269_;
    return _e78;
}

fn _lt_shaders_texture_TextureView_quad(param_7: ptr<function, texture_TextureView>, param_8: f32, param_9: f32) -> texture_TexelQuad {
    var phi_311_: f32;
    var phi_316_: f32;
    var phi_317_: bool;
    var phi_318_: f32;
    var phi_319_: bool;
    var phi_323_: f32;
    var phi_349_: f32;
    var phi_354_: f32;
    var phi_355_: bool;
    var phi_356_: f32;
    var phi_357_: bool;
    var phi_361_: f32;
    var phi_369_: f32;
    var phi_370_: f32;
    var phi_371_: f32;
    var phi_380_: f32;
    var phi_381_: f32;
    var phi_399_: u32;
    var phi_413_: u32;
    var phi_420_: u32;
    var phi_425_: u32;
    var phi_431_: u32;
    var phi_436_: u32;
    var phi_438_: texture_Axis;
    var phi_466_: f32;
    var phi_471_: f32;
    var phi_472_: bool;
    var phi_473_: f32;
    var phi_474_: bool;
    var phi_478_: f32;
    var phi_504_: f32;
    var phi_509_: f32;
    var phi_510_: bool;
    var phi_511_: f32;
    var phi_512_: bool;
    var phi_516_: f32;
    var phi_524_: f32;
    var phi_525_: f32;
    var phi_526_: f32;
    var phi_535_: f32;
    var phi_536_: f32;
    var phi_554_: u32;
    var phi_568_: u32;
    var phi_575_: u32;
    var phi_580_: u32;
    var phi_586_: u32;
    var phi_591_: u32;
    var phi_593_: texture_Axis;

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
                phi_311_ = 1f;
            } else {
                phi_311_ = 0f;
            }
            let _e105 = phi_311_;
            if (param_8 < 8388608f) {
                phi_316_ = (_e102 - _e105);
                phi_317_ = false;
            } else {
                phi_316_ = f32();
                phi_317_ = true;
            }
            let _e108 = phi_316_;
            let _e110 = phi_317_;
            phi_318_ = _e108;
            phi_319_ = _e110;
        } else {
            phi_318_ = f32();
            phi_319_ = true;
        }
        let _e112 = phi_318_;
        let _e114 = phi_319_;
        if _e114 {
            phi_323_ = param_8;
        } else {
            phi_323_ = _e112;
        }
        let _e116 = phi_323_;
        phi_371_ = (param_8 - _e116);
    } else {
        if (_e89 == 1u) {
            let _e119 = (param_8 * 0.5f);
            if (_e119 > -8388608f) {
                let _e131 = f32(select(0i, select(select(i32(_e119), i32(-2147483648), (_e119 < bitcast<f32>(3472883712u))), 2147483647i, (_e119 > bitcast<f32>(1325400063u))), (_e119 == _e119)));
                if (_e131 > _e119) {
                    phi_349_ = 1f;
                } else {
                    phi_349_ = 0f;
                }
                let _e134 = phi_349_;
                if (_e119 < 8388608f) {
                    phi_354_ = (_e131 - _e134);
                    phi_355_ = false;
                } else {
                    phi_354_ = f32();
                    phi_355_ = true;
                }
                let _e137 = phi_354_;
                let _e139 = phi_355_;
                phi_356_ = _e137;
                phi_357_ = _e139;
            } else {
                phi_356_ = f32();
                phi_357_ = true;
            }
            let _e141 = phi_356_;
            let _e143 = phi_357_;
            if _e143 {
                phi_361_ = _e119;
            } else {
                phi_361_ = _e141;
            }
            let _e145 = phi_361_;
            let _e147 = (param_8 - (2f * _e145));
            if (_e147 > 1f) {
                phi_369_ = (2f - _e147);
            } else {
                phi_369_ = _e147;
            }
            let _e151 = phi_369_;
            phi_370_ = _e151;
        } else {
            phi_370_ = param_8;
        }
        let _e153 = phi_370_;
        phi_371_ = _e153;
    }
    let _e155 = phi_371_;
    if (_e155 > 0f) {
        if (_e155 < 1f) {
            phi_380_ = _e155;
        } else {
            phi_380_ = 1f;
        }
        let _e159 = phi_380_;
        phi_381_ = _e159;
    } else {
        phi_381_ = 0f;
    }
    let _e161 = phi_381_;
    let _e162 = (_e76 - 1u);
    let _e164 = (_e161 * f32(_e76));
    if _e84 {
        let _e171 = select(select(u32(_e164), 0u, (_e164 < bitcast<f32>(0u))), 4294967295u, (_e164 > bitcast<f32>(1333788671u)));
        if (_e162 < _e171) {
            phi_399_ = _e162;
        } else {
            phi_399_ = _e171;
        }
        let _e174 = phi_399_;
        phi_438_ = texture_Axis(_e174, _e174, 0f);
    } else {
        let _e176 = (_e164 + 0.5f);
        let _e183 = select(select(u32(_e176), 0u, (_e176 < bitcast<f32>(0u))), 4294967295u, (_e176 > bitcast<f32>(1333788671u)));
        if (_e76 < _e183) {
            phi_413_ = _e76;
        } else {
            phi_413_ = _e183;
        }
        let _e186 = phi_413_;
        if (_e89 == 0u) {
            phi_420_ = _e162;
        } else {
            phi_420_ = 0u;
        }
        let _e191 = phi_420_;
        if (_e89 == 0u) {
            phi_425_ = 0u;
        } else {
            phi_425_ = _e162;
        }
        let _e194 = phi_425_;
        if (_e186 == 0u) {
            phi_431_ = _e191;
        } else {
            phi_431_ = (_e186 - 1u);
        }
        let _e198 = phi_431_;
        if (_e186 > _e162) {
            phi_436_ = _e194;
        } else {
            phi_436_ = _e186;
        }
        let _e201 = phi_436_;
        phi_438_ = texture_Axis(_e198, _e201, (_e176 - f32(_e186)));
    }
    let _e204 = phi_438_;
    let _e206 = (*param_7).flags;
    let _e209 = ((_e206 >> bitcast<u32>(6u)) & 3u);
    if (_e209 == 0u) {
        if (param_9 > -8388608f) {
            let _e222 = f32(select(0i, select(select(i32(param_9), i32(-2147483648), (param_9 < bitcast<f32>(3472883712u))), 2147483647i, (param_9 > bitcast<f32>(1325400063u))), (param_9 == param_9)));
            if (_e222 > param_9) {
                phi_466_ = 1f;
            } else {
                phi_466_ = 0f;
            }
            let _e225 = phi_466_;
            if (param_9 < 8388608f) {
                phi_471_ = (_e222 - _e225);
                phi_472_ = false;
            } else {
                phi_471_ = f32();
                phi_472_ = true;
            }
            let _e228 = phi_471_;
            let _e230 = phi_472_;
            phi_473_ = _e228;
            phi_474_ = _e230;
        } else {
            phi_473_ = f32();
            phi_474_ = true;
        }
        let _e232 = phi_473_;
        let _e234 = phi_474_;
        if _e234 {
            phi_478_ = param_9;
        } else {
            phi_478_ = _e232;
        }
        let _e236 = phi_478_;
        phi_526_ = (param_9 - _e236);
    } else {
        if (_e209 == 1u) {
            let _e239 = (param_9 * 0.5f);
            if (_e239 > -8388608f) {
                let _e251 = f32(select(0i, select(select(i32(_e239), i32(-2147483648), (_e239 < bitcast<f32>(3472883712u))), 2147483647i, (_e239 > bitcast<f32>(1325400063u))), (_e239 == _e239)));
                if (_e251 > _e239) {
                    phi_504_ = 1f;
                } else {
                    phi_504_ = 0f;
                }
                let _e254 = phi_504_;
                if (_e239 < 8388608f) {
                    phi_509_ = (_e251 - _e254);
                    phi_510_ = false;
                } else {
                    phi_509_ = f32();
                    phi_510_ = true;
                }
                let _e257 = phi_509_;
                let _e259 = phi_510_;
                phi_511_ = _e257;
                phi_512_ = _e259;
            } else {
                phi_511_ = f32();
                phi_512_ = true;
            }
            let _e261 = phi_511_;
            let _e263 = phi_512_;
            if _e263 {
                phi_516_ = _e239;
            } else {
                phi_516_ = _e261;
            }
            let _e265 = phi_516_;
            let _e267 = (param_9 - (2f * _e265));
            if (_e267 > 1f) {
                phi_524_ = (2f - _e267);
            } else {
                phi_524_ = _e267;
            }
            let _e271 = phi_524_;
            phi_525_ = _e271;
        } else {
            phi_525_ = param_9;
        }
        let _e273 = phi_525_;
        phi_526_ = _e273;
    }
    let _e275 = phi_526_;
    if (_e275 > 0f) {
        if (_e275 < 1f) {
            phi_535_ = _e275;
        } else {
            phi_535_ = 1f;
        }
        let _e279 = phi_535_;
        phi_536_ = _e279;
    } else {
        phi_536_ = 0f;
    }
    let _e281 = phi_536_;
    let _e282 = (_e80 - 1u);
    let _e284 = (_e281 * f32(_e80));
    if _e84 {
        let _e291 = select(select(u32(_e284), 0u, (_e284 < bitcast<f32>(0u))), 4294967295u, (_e284 > bitcast<f32>(1333788671u)));
        if (_e282 < _e291) {
            phi_554_ = _e282;
        } else {
            phi_554_ = _e291;
        }
        let _e294 = phi_554_;
        phi_593_ = texture_Axis(_e294, _e294, 0f);
    } else {
        let _e296 = (_e284 + 0.5f);
        let _e303 = select(select(u32(_e296), 0u, (_e296 < bitcast<f32>(0u))), 4294967295u, (_e296 > bitcast<f32>(1333788671u)));
        if (_e80 < _e303) {
            phi_568_ = _e80;
        } else {
            phi_568_ = _e303;
        }
        let _e306 = phi_568_;
        if (_e209 == 0u) {
            phi_575_ = _e282;
        } else {
            phi_575_ = 0u;
        }
        let _e311 = phi_575_;
        if (_e209 == 0u) {
            phi_580_ = 0u;
        } else {
            phi_580_ = _e282;
        }
        let _e314 = phi_580_;
        if (_e306 == 0u) {
            phi_586_ = _e311;
        } else {
            phi_586_ = (_e306 - 1u);
        }
        let _e318 = phi_586_;
        if (_e306 > _e282) {
            phi_591_ = _e314;
        } else {
            phi_591_ = _e306;
        }
        let _e321 = phi_591_;
        phi_593_ = texture_Axis(_e318, _e321, (_e296 - f32(_e306)));
    }
    let _e324 = phi_593_;
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
    var phi_652_: f32;

    if (param_12 > param_13) {
        phi_652_ = param_12;
    } else {
        phi_652_ = param_13;
    }
    let _e75 = phi_652_;
    return _e75;
}

fn function_() {
    var local: texture_TextureView;
    var local_1: texture_TextureView;
    var local_2: lt_bvh_traverse_Stack;
    var local_3: lt_bvh_traverse_Stack;
    var phi_806_: bool;
    var phi_807_: bool;
    var phi_808_: bool;
    var phi_809_: bool;
    var phi_813_: bool;
    var phi_826_: bool;
    var phi_827_: bool;
    var phi_828_: bool;
    var phi_829_: bool;
    var phi_833_: bool;
    var phi_846_: bool;
    var phi_847_: bool;
    var phi_848_: bool;
    var phi_852_: bool;
    var phi_853_: bool;
    var phi_854_: bool;
    var phi_855_: bool;
    var phi_856_: bool;
    var phi_860_: bool;
    var phi_936_: f32;
    var phi_943_: f32;
    var phi_951_: f32;
    var phi_958_: f32;
    var phi_966_: f32;
    var phi_973_: f32;
    var phi_996_: f32;
    var phi_1001_: f32;
    var phi_1006_: f32;
    var phi_1011_: f32;
    var phi_1016_: f32;
    var phi_1035_: u32;
    var phi_1040_: u32;
    var phi_1045_: u32;
    var phi_1159_: bool;
    var phi_1160_: bool;
    var phi_1191_: u32;
    var phi_1193_: u32;
    var phi_1196_: lt_bvh_Hit;
    var phi_1281_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1308_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1335_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1341_: u32;
    var phi_1344_: u32;
    var phi_1358_: u32;
    var phi_1368_: u32;
    var phi_1378_: u32;
    var phi_1396_: u32;
    var phi_1406_: u32;
    var phi_1416_: u32;
    var phi_1452_: u32;
    var phi_1465_: u32;
    var phi_1470_: u32;
    var phi_1471_: u32;
    var phi_1472_: u32;
    var phi_1342_: u32;
    var phi_1345_: u32;
    var local_4: u32;
    var local_5: u32;
    var local_6: u32;
    var phi_1530_: u32;
    var phi_1533_: lt_bvh_Hit;
    var phi_1588_: f32;
    var phi_1593_: f32;
    var phi_1598_: f32;
    var phi_1606_: f32;
    var phi_1611_: f32;
    var phi_1616_: f32;
    var phi_1748_: bool;
    var phi_1749_: bool;
    var phi_1750_: bool;
    var phi_1751_: bool;
    var phi_1755_: bool;
    var phi_1768_: bool;
    var phi_1769_: bool;
    var phi_1770_: bool;
    var phi_1771_: bool;
    var phi_1775_: bool;
    var phi_1788_: bool;
    var phi_1789_: bool;
    var phi_1790_: bool;
    var phi_1794_: bool;
    var phi_1795_: bool;
    var phi_1796_: bool;
    var phi_1797_: bool;
    var phi_1798_: bool;
    var phi_1802_: bool;
    var phi_1872_: f32;
    var phi_1879_: f32;
    var phi_1886_: f32;
    var phi_1893_: f32;
    var phi_1900_: f32;
    var phi_1907_: f32;
    var phi_1924_: f32;
    var phi_1929_: f32;
    var phi_1934_: f32;
    var phi_1939_: f32;
    var phi_1944_: f32;
    var phi_1970_: bool;
    var phi_1971_: bool;
    var phi_1979_: u32;
    var phi_1980_: u32;
    var phi_1991_: vec3<f32>;
    var phi_1992_: vec3<f32>;
    var phi_2005_: u32;
    var phi_2010_: u32;
    var phi_2015_: u32;
    var phi_2129_: bool;
    var phi_2130_: bool;
    var phi_2161_: u32;
    var phi_2163_: lt_bvh_Hit;
    var phi_2166_: u32;
    var phi_2247_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2274_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2301_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2307_: u32;
    var phi_2310_: u32;
    var phi_2324_: u32;
    var phi_2334_: u32;
    var phi_2344_: u32;
    var phi_2362_: u32;
    var phi_2372_: u32;
    var phi_2382_: u32;
    var phi_2418_: u32;
    var phi_2431_: u32;
    var phi_2436_: u32;
    var phi_2437_: u32;
    var phi_2438_: u32;
    var phi_2308_: u32;
    var phi_2311_: u32;
    var local_7: u32;
    var local_8: u32;
    var local_9: u32;
    var phi_2496_: lt_bvh_Hit;
    var phi_2499_: u32;
    var phi_2543_: vec3<f32>;
    var phi_2544_: vec3<f32>;
    var phi_2573_: vec3<f32>;
    var phi_2574_: vec3<f32>;
    var phi_2603_: vec3<f32>;
    var phi_2604_: vec3<f32>;
    var phi_2622_: bool;
    var phi_2623_: bool;
    var phi_2627_: f32;
    var phi_2628_: f32;
    var phi_2629_: f32;
    var phi_2630_: f32;
    var phi_2638_: f32;
    var phi_2648_: bool;
    var phi_2649_: bool;
    var phi_2653_: f32;
    var phi_2654_: f32;
    var phi_2655_: f32;
    var phi_2656_: f32;
    var phi_2664_: f32;
    var phi_2674_: bool;
    var phi_2675_: bool;
    var phi_2679_: f32;
    var phi_2680_: f32;
    var phi_2681_: f32;
    var phi_2682_: f32;
    var phi_2690_: f32;
    var phi_2705_: f32;
    var phi_2706_: bool;
    var phi_2707_: f32;
    var phi_2708_: bool;
    var phi_2709_: f32;
    var phi_2710_: bool;
    var phi_2728_: f32;
    var phi_2729_: bool;
    var phi_2730_: bool;
    var phi_2731_: f32;
    var phi_2732_: bool;
    var phi_2733_: bool;
    var phi_2737_: bool;
    var phi_2738_: f32;
    var phi_2739_: bool;
    var phi_2767_: vec3<f32>;
    var phi_2768_: vec3<f32>;
    var phi_2793_: vec3<f32>;
    var phi_2794_: vec3<f32>;
    var phi_2819_: vec3<f32>;
    var phi_2820_: vec3<f32>;
    var phi_2876_: f32;
    var phi_2885_: f32;
    var phi_2894_: f32;
    var phi_2903_: f32;
    var phi_2910_: f32;
    var phi_2917_: f32;
    var phi_2930_: f32;
    var phi_2939_: f32;
    var phi_2948_: f32;
    var phi_2957_: f32;
    var phi_2964_: f32;
    var phi_2971_: f32;
    var phi_2988_: f32;
    var phi_2993_: f32;
    var phi_2998_: f32;
    var phi_3006_: f32;
    var phi_3011_: f32;
    var phi_3016_: f32;
    var phi_3028_: f32;
    var phi_3033_: f32;
    var phi_3038_: f32;
    var phi_3043_: f32;
    var phi_3048_: lt_bvh_triangle_Intersection;
    var phi_3049_: bool;
    var phi_3050_: lt_bvh_triangle_Intersection;
    var phi_3051_: bool;
    var phi_3055_: lt_bvh_triangle_Intersection;
    var phi_3056_: bool;
    var phi_3057_: lt_bvh_triangle_Intersection;
    var phi_3058_: bool;
    var phi_3059_: bool;
    var phi_3063_: bool;
    var phi_3067_: lt_bvh_triangle_Intersection;
    var phi_3105_: bool;
    var phi_3106_: bool;
    var phi_3107_: bool;
    var phi_3108_: bool;
    var phi_3109_: bool;
    var phi_3110_: bool;
    var phi_3114_: bool;
    var phi_3115_: bool;
    var phi_3318_: f32;
    var phi_3321_: bool;
    var phi_3322_: bool;
    var phi_3326_: bool;
    var phi_3334_: lt_bvh_Hit;
    var phi_3335_: lt_bvh_Hit;
    var phi_3336_: lt_bvh_Hit;
    var phi_3337_: lt_bvh_Hit;
    var phi_2497_: lt_bvh_Hit;
    var phi_2500_: u32;
    var phi_3338_: bool;
    var phi_3377_: bool;
    var phi_3378_: bool;
    var phi_3409_: u32;
    var phi_2164_: lt_bvh_Hit;
    var phi_2167_: u32;
    var phi_3410_: lt_bvh_Hit;
    var phi_3411_: lt_bvh_Hit;
    var phi_3412_: bool;
    var phi_3416_: lt_bvh_Hit;
    var phi_3417_: lt_bvh_Hit;
    var phi_3418_: lt_bvh_Hit;
    var phi_3419_: lt_bvh_Hit;
    var phi_1531_: u32;
    var phi_1534_: lt_bvh_Hit;
    var phi_3420_: bool;
    var phi_3459_: bool;
    var phi_3460_: bool;
    var phi_3491_: u32;
    var phi_1194_: u32;
    var phi_1197_: lt_bvh_Hit;
    var phi_3492_: lt_bvh_Hit;
    var phi_3493_: lt_bvh_Hit;
    var phi_3494_: bool;
    var phi_3498_: lt_bvh_Hit;
    var phi_3685_: f32;
    var phi_3690_: f32;
    var phi_3695_: f32;
    var phi_3703_: f32;
    var phi_3708_: f32;
    var phi_3713_: f32;
    var phi_3777_: vec3<f32>;
    var phi_4020_: vec3<f32>;
    var phi_4035_: u32;
    var phi_4062_: f32;
    var phi_4069_: f32;
    var phi_4076_: f32;
    var phi_4111_: f32;
    var phi_4118_: f32;
    var phi_4125_: f32;
    var phi_4163_: f32;
    var phi_4170_: f32;
    var phi_4177_: f32;
    var phi_4263_: vec3<f32>;
    var phi_4264_: vec3<f32>;
    var phi_4265_: vec3<f32>;
    var phi_4274_: f32;
    var phi_4275_: f32;
    var phi_4285_: f32;
    var phi_4286_: f32;
    var phi_4296_: f32;
    var phi_4297_: f32;
    var phi_4332_: abi_Sample;
    var local_10: lt_bvh_Hit;
    var local_11: lt_bvh_Hit;
    var local_12: lt_bvh_Hit;
    var local_13: lt_bvh_Hit;

    let _e75 = id_1;
    let _e79 = arrayLength((&nodes.member));
    let _e82 = arrayLength((&triangles.member));
    let _e85 = arrayLength((&vertices.member));
    let _e88 = arrayLength((&materials.member));
    let _e94 = arrayLength((&instances.member));
    let _e97 = arrayLength((&alpha_texels.member));
    let _e100 = arrayLength((&color_texels.member));
    let _e103 = p.member.size[0u];
    let _e105 = p.member.size[1u];
    let _e106 = lt_shaders_entry_pixel_index(_e75, _e103, _e105);
    if (bitcast<i32>(_e106.root) != 0i) {
        let _e112 = p.member.root;
        let _e116 = p.member.eye;
        let _e119 = p.member.grid[0u];
        let _e121 = p.member.grid[1u];
        let _e140 = p.member.size[0u];
        let _e144 = ((((f32(_e75.x) + ((f32((_e75.y & (_e121 - 1u))) + 0.5f) / f32(_e121))) / f32(_e140)) * 2f) - 1f);
        let _e147 = p.member.size[1u];
        let _e151 = (1f - (((f32(_e75.y) + ((f32((_e75.x & (_e119 - 1u))) + 0.5f) / f32(_e119))) / f32(_e147)) * 2f));
        let _e153 = p.member.forward;
        let _e155 = p.member.right;
        let _e169 = p.member.up;
        let _e180 = _lt_bvh_ray_Ray_new(_e116, vec3<f32>(((_e153.x + (_e155.x * _e144)) + (_e169.x * _e151)), ((_e153.y + (_e155.y * _e144)) + (_e169.y * _e151)), ((_e153.z + (_e155.z * _e144)) + (_e169.z * _e151))));
        let _e182 = lt_bvh_Hit(_e180.tmax, 0f, 0f, 4294967295u, 4294967295u);
        let _e185 = abs(_e180.direction.x);
        let _e187 = abs(_e180.direction.y);
        let _e189 = abs(_e180.direction.z);
        if (abs(_e180.origin.x) < 1000000000000000f) {
            if (abs(_e180.origin.y) < 1000000000000000f) {
                phi_806_ = (abs(_e180.origin.z) < 1000000000000000f);
                phi_807_ = false;
            } else {
                phi_806_ = bool();
                phi_807_ = true;
            }
            let _e201 = phi_806_;
            let _e203 = phi_807_;
            phi_808_ = _e201;
            phi_809_ = _e203;
        } else {
            phi_808_ = bool();
            phi_809_ = true;
        }
        let _e205 = phi_808_;
        let _e207 = phi_809_;
        if _e207 {
            phi_813_ = false;
        } else {
            phi_813_ = _e205;
        }
        let _e209 = phi_813_;
        if _e209 {
            if (_e185 < 1000000000000000f) {
                if (_e187 < 1000000000000000f) {
                    phi_826_ = (_e189 < 1000000000000000f);
                    phi_827_ = false;
                } else {
                    phi_826_ = bool();
                    phi_827_ = true;
                }
                let _e214 = phi_826_;
                let _e216 = phi_827_;
                phi_828_ = _e214;
                phi_829_ = _e216;
            } else {
                phi_828_ = bool();
                phi_829_ = true;
            }
            let _e218 = phi_828_;
            let _e220 = phi_829_;
            if _e220 {
                phi_833_ = false;
            } else {
                phi_833_ = _e218;
            }
            let _e222 = phi_833_;
            if _e222 {
                if (_e185 > 0f) {
                    phi_847_ = bool();
                    phi_848_ = true;
                } else {
                    let _e224 = (_e187 > 0f);
                    if _e224 {
                        phi_846_ = bool();
                    } else {
                        phi_846_ = (_e189 > 0f);
                    }
                    let _e227 = phi_846_;
                    phi_847_ = _e227;
                    phi_848_ = _e224;
                }
                let _e229 = phi_847_;
                let _e231 = phi_848_;
                if _e231 {
                    phi_852_ = true;
                } else {
                    phi_852_ = _e229;
                }
                let _e233 = phi_852_;
                phi_853_ = _e233;
                phi_854_ = false;
            } else {
                phi_853_ = bool();
                phi_854_ = true;
            }
            let _e235 = phi_853_;
            let _e237 = phi_854_;
            phi_855_ = _e235;
            phi_856_ = _e237;
        } else {
            phi_855_ = bool();
            phi_856_ = true;
        }
        let _e239 = phi_855_;
        let _e241 = phi_856_;
        if _e241 {
            phi_860_ = false;
        } else {
            phi_860_ = _e239;
        }
        let _e243 = phi_860_;
        if _e243 {
            let _e244 = (_e112 >= _e79);
            if _e244 {
                phi_3492_ = lt_bvh_Hit();
            } else {
                if (_e112 < _e79) {
                } else {
                    return;
                }
                let _e250 = nodes.member[(0u + _e112)].frame[0u];
                let _e254 = nodes.member[(0u + _e112)].frame[1u];
                let _e258 = nodes.member[(0u + _e112)].frame[2u];
                let _e262 = nodes.member[(0u + _e112)].frame[0u];
                let _e266 = nodes.member[(0u + _e112)].frame[1u];
                let _e270 = nodes.member[(0u + _e112)].frame[2u];
                let _e274 = nodes.member[(0u + _e112)].frame[3u];
                let _e313 = core_intrinsics_maximum_number_nsz_f32_(abs(_e180.direction.x), abs(_e180.direction.y));
                let _e314 = core_intrinsics_maximum_number_nsz_f32_(_e313, abs(_e180.direction.z));
                let _e315 = (_e314 * 0.0000000000009094947f);
                if (abs(_e180.direction.x) < _e315) {
                    phi_936_ = _e315;
                } else {
                    phi_936_ = abs(_e180.direction.x);
                }
                let _e321 = phi_936_;
                if (_e180.direction.x < 0f) {
                    phi_943_ = (-1f / _e321);
                } else {
                    phi_943_ = (1f / _e321);
                }
                let _e326 = phi_943_;
                if (abs(_e180.direction.y) < _e315) {
                    phi_951_ = _e315;
                } else {
                    phi_951_ = abs(_e180.direction.y);
                }
                let _e332 = phi_951_;
                if (_e180.direction.y < 0f) {
                    phi_958_ = (-1f / _e332);
                } else {
                    phi_958_ = (1f / _e332);
                }
                let _e337 = phi_958_;
                if (abs(_e180.direction.z) < _e315) {
                    phi_966_ = _e315;
                } else {
                    phi_966_ = abs(_e180.direction.z);
                }
                let _e343 = phi_966_;
                if (_e180.direction.z < 0f) {
                    phi_973_ = (-1f / _e343);
                } else {
                    phi_973_ = (1f / _e343);
                }
                let _e348 = phi_973_;
                let _e355 = abs((bitcast<f32>(_e250) - _e180.origin.x));
                let _e356 = abs((bitcast<f32>(_e254) - _e180.origin.y));
                let _e357 = abs((bitcast<f32>(_e258) - _e180.origin.z));
                let _e364 = abs(((bitcast<f32>(_e262) + (bitcast<f32>((((_e274 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e180.origin.x));
                let _e365 = abs(((bitcast<f32>(_e266) + (bitcast<f32>((((_e274 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e180.origin.y));
                let _e366 = abs(((bitcast<f32>(_e270) + (bitcast<f32>((((_e274 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e180.origin.z));
                if (_e355 > _e364) {
                    phi_996_ = _e355;
                } else {
                    phi_996_ = _e364;
                }
                let _e369 = phi_996_;
                if (_e356 > _e365) {
                    phi_1001_ = _e356;
                } else {
                    phi_1001_ = _e365;
                }
                let _e372 = phi_1001_;
                if (_e357 > _e366) {
                    phi_1006_ = _e357;
                } else {
                    phi_1006_ = _e366;
                }
                let _e375 = phi_1006_;
                if (_e369 > _e372) {
                    phi_1011_ = _e369;
                } else {
                    phi_1011_ = _e372;
                }
                let _e378 = phi_1011_;
                if (_e378 > _e375) {
                    phi_1016_ = _e378;
                } else {
                    phi_1016_ = _e375;
                }
                let _e381 = phi_1016_;
                let _e385 = (_e381 * 0.0000019073486f);
                let _e386 = (abs(_e326) * _e385);
                let _e387 = (abs(_e337) * _e385);
                let _e388 = (abs(_e348) * _e385);
                let _e392 = (_e381 * 0.0000009536743f);
                let _e393 = (abs(_e326) * _e392);
                let _e394 = (abs(_e337) * _e392);
                let _e395 = (abs(_e348) * _e392);
                if (_e326 < 0f) {
                    phi_1035_ = 0u;
                } else {
                    phi_1035_ = 1u;
                }
                let _e398 = phi_1035_;
                if (_e337 < 0f) {
                    phi_1040_ = 0u;
                } else {
                    phi_1040_ = 2u;
                }
                let _e401 = phi_1040_;
                if (_e348 < 0f) {
                    phi_1045_ = 0u;
                } else {
                    phi_1045_ = 4u;
                }
                let _e404 = phi_1045_;
                let _e406 = ((_e398 | _e401) | _e404);
                let _e407 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e112, 2147483648u);
                local_3 = lt_bvh_traverse_Stack(array<u32, 32>(_e407.first[0], _e407.first[1], _e407.first[2], _e407.first[3], _e407.first[4], _e407.first[5], _e407.first[6], _e407.first[7], _e407.first[8], _e407.first[9], _e407.first[10], _e407.first[11], _e407.first[12], _e407.first[13], _e407.first[14], _e407.first[15], _e407.first[16], _e407.first[17], _e407.first[18], _e407.first[19], _e407.first[20], _e407.first[21], _e407.first[22], _e407.first[23], _e407.first[24], _e407.first[25], _e407.first[26], _e407.first[27], _e407.first[28], _e407.first[29], _e407.first[30], _e407.first[31]), array<u32, 32>(_e407.mask[0], _e407.mask[1], _e407.mask[2], _e407.mask[3], _e407.mask[4], _e407.mask[5], _e407.mask[6], _e407.mask[7], _e407.mask[8], _e407.mask[9], _e407.mask[10], _e407.mask[11], _e407.mask[12], _e407.mask[13], _e407.mask[14], _e407.mask[15], _e407.mask[16], _e407.mask[17], _e407.mask[18], _e407.mask[19], _e407.mask[20], _e407.mask[21], _e407.mask[22], _e407.mask[23], _e407.mask[24], _e407.mask[25], _e407.mask[26], _e407.mask[27], _e407.mask[28], _e407.mask[29], _e407.mask[30], _e407.mask[31]), _e407.len, _e407.group, _e407.group_mask);
                let _e481 = local_3.group_mask;
                if ((_e481 & 4278190080u) == 0u) {
                    let _e485 = local_3.len;
                    if (_e485 == 0u) {
                        phi_1159_ = false;
                    } else {
                        let _e489 = local_3.len;
                        local_3.len = (_e489 - 1u);
                        let _e492 = local_3.len;
                        if (_e492 < 32u) {
                        } else {
                            return;
                        }
                        let _e497 = local_3.first[(0u + _e492)];
                        local_3.group = _e497;
                        let _e500 = local_3.len;
                        if (_e500 < 32u) {
                        } else {
                            return;
                        }
                        let _e505 = local_3.mask[(0u + _e500)];
                        local_3.group_mask = _e505;
                        phi_1159_ = true;
                    }
                    let _e508 = phi_1159_;
                    phi_1160_ = _e508;
                } else {
                    phi_1160_ = true;
                }
                let _e510 = phi_1160_;
                if _e510 {
                    let _e512 = local_3.group_mask;
                    let _e518 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e512)), 32u, (_e512 == 0u)));
                    let _e522 = local_3.group_mask;
                    let _e536 = local_3.group_mask;
                    local_3.group_mask = (_e536 & ~((1u << bitcast<u32>((_e518 & 31u)))));
                    let _e539 = local_3.group;
                    phi_1191_ = (_e539 + countOneBits(((_e522 & ~((4294967295u << bitcast<u32>((((_e518 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1191_ = 4294967295u;
                }
                let _e542 = phi_1191_;
                phi_1193_ = _e542;
                phi_1196_ = _e182;
                loop {
                    let _e544 = phi_1193_;
                    let _e546 = phi_1196_;
                    local_13 = _e546;
                    let _e547 = (_e544 != 4294967295u);
                    if _e547 {
                        if (_e544 < _e79) {
                        } else {
                            return;
                        }
                        let _e555 = nodes.member[(0u + _e544)].frame[3u];
                        let _e580 = (bitcast<f32>((((_e555 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e326);
                        let _e581 = (bitcast<f32>((((_e555 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e337);
                        let _e582 = (bitcast<f32>((((_e555 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e348);
                        let _e585 = nodes.member[(0u + _e544)].frame[0u];
                        let _e589 = nodes.member[(0u + _e544)].frame[1u];
                        let _e593 = nodes.member[(0u + _e544)].frame[2u];
                        let _e601 = ((bitcast<f32>(_e585) - _e180.origin.x) * _e326);
                        let _e602 = ((bitcast<f32>(_e589) - _e180.origin.y) * _e337);
                        let _e603 = ((bitcast<f32>(_e593) - _e180.origin.z) * _e348);
                        let _e611 = nodes.member[(0u + _e544)].x;
                        if (_e326 < 0f) {
                            let _e622 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e611.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e628 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e622.unnamed.root, _e611.w), _e622.unnamed_1);
                            let _e634 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e628.unnamed, lt_bvh_traverse_Tree(_e611.x, _e628.unnamed_1.first_primitive));
                            phi_1281_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e634.unnamed, lt_bvh_traverse_Tree(_e634.unnamed_1.root, _e611.y));
                        } else {
                            let _e650 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e611.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e656 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e650.unnamed.root, _e611.y), _e650.unnamed_1);
                            let _e662 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e656.unnamed, lt_bvh_traverse_Tree(_e611.z, _e656.unnamed_1.first_primitive));
                            phi_1281_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e662.unnamed, lt_bvh_traverse_Tree(_e662.unnamed_1.root, _e611.w));
                        }
                        let _e670 = phi_1281_;
                        let _e680 = nodes.member[(0u + _e544)].y;
                        if (_e337 < 0f) {
                            let _e691 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e680.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e697 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e691.unnamed.root, _e680.w), _e691.unnamed_1);
                            let _e703 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e697.unnamed, lt_bvh_traverse_Tree(_e680.x, _e697.unnamed_1.first_primitive));
                            phi_1308_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e703.unnamed, lt_bvh_traverse_Tree(_e703.unnamed_1.root, _e680.y));
                        } else {
                            let _e719 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e680.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e725 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e719.unnamed.root, _e680.y), _e719.unnamed_1);
                            let _e731 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e725.unnamed, lt_bvh_traverse_Tree(_e680.z, _e725.unnamed_1.first_primitive));
                            phi_1308_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e731.unnamed, lt_bvh_traverse_Tree(_e731.unnamed_1.root, _e680.w));
                        }
                        let _e739 = phi_1308_;
                        let _e749 = nodes.member[(0u + _e544)].z;
                        if (_e348 < 0f) {
                            let _e760 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e749.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e766 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e760.unnamed.root, _e749.w), _e760.unnamed_1);
                            let _e772 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e766.unnamed, lt_bvh_traverse_Tree(_e749.x, _e766.unnamed_1.first_primitive));
                            phi_1335_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e772.unnamed, lt_bvh_traverse_Tree(_e772.unnamed_1.root, _e749.y));
                        } else {
                            let _e788 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e749.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e794 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e788.unnamed.root, _e749.y), _e788.unnamed_1);
                            let _e800 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e794.unnamed, lt_bvh_traverse_Tree(_e749.z, _e794.unnamed_1.first_primitive));
                            phi_1335_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e800.unnamed, lt_bvh_traverse_Tree(_e800.unnamed_1.root, _e749.w));
                        }
                        let _e808 = phi_1335_;
                        phi_1341_ = 0u;
                        phi_1344_ = 0u;
                        loop {
                            let _e818 = phi_1341_;
                            let _e820 = phi_1344_;
                            local_4 = _e820;
                            local_5 = _e820;
                            local_6 = _e820;
                            let _e821 = (_e818 < 8u);
                            if _e821 {
                                let _e823 = (_e818 >> bitcast<u32>(2i));
                                let _e824 = (_e818 & 3u);
                                if (_e823 == 0u) {
                                    phi_1358_ = _e670.unnamed.root;
                                } else {
                                    phi_1358_ = _e670.unnamed.first_primitive;
                                }
                                let _e827 = phi_1358_;
                                if (_e823 == 0u) {
                                    phi_1368_ = _e739.unnamed.root;
                                } else {
                                    phi_1368_ = _e739.unnamed.first_primitive;
                                }
                                let _e836 = phi_1368_;
                                if (_e823 == 0u) {
                                    phi_1378_ = _e808.unnamed.root;
                                } else {
                                    phi_1378_ = _e808.unnamed.first_primitive;
                                }
                                let _e845 = phi_1378_;
                                let _e858 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e827 >> bitcast<u32>(((_e824 * 8u) & 31u))) & 255u)) * _e580) + (_e601 - _e386)), ((f32(((_e836 >> bitcast<u32>(((_e824 * 8u) & 31u))) & 255u)) * _e581) + (_e602 - _e387)));
                                let _e859 = core_intrinsics_maximum_number_nsz_f32_(_e858, ((f32(((_e845 >> bitcast<u32>(((_e824 * 8u) & 31u))) & 255u)) * _e582) + (_e603 - _e388)));
                                if (_e823 == 0u) {
                                    phi_1396_ = _e670.unnamed_1.root;
                                } else {
                                    phi_1396_ = _e670.unnamed_1.first_primitive;
                                }
                                let _e862 = phi_1396_;
                                if (_e823 == 0u) {
                                    phi_1406_ = _e739.unnamed_1.root;
                                } else {
                                    phi_1406_ = _e739.unnamed_1.first_primitive;
                                }
                                let _e871 = phi_1406_;
                                if (_e823 == 0u) {
                                    phi_1416_ = _e808.unnamed_1.root;
                                } else {
                                    phi_1416_ = _e808.unnamed_1.first_primitive;
                                }
                                let _e880 = phi_1416_;
                                let _e893 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e862 >> bitcast<u32>(((_e824 * 8u) & 31u))) & 255u)) * _e580) + (_e601 + _e386)), ((f32(((_e871 >> bitcast<u32>(((_e824 * 8u) & 31u))) & 255u)) * _e581) + (_e602 + _e387)));
                                let _e894 = core_intrinsics_minimum_number_nsz_f32_(_e893, ((f32(((_e880 >> bitcast<u32>(((_e824 * 8u) & 31u))) & 255u)) * _e582) + (_e603 + _e388)));
                                if (_e859 <= _e894) {
                                    if (_e859 <= _e546.t) {
                                        if (_e894 >= _e180.tmin) {
                                            if (_e823 == 0u) {
                                                let _e901 = nodes.member[(0u + _e544)].links[2u];
                                                phi_1452_ = _e901;
                                            } else {
                                                let _e904 = nodes.member[(0u + _e544)].links[3u];
                                                phi_1452_ = _e904;
                                            }
                                            let _e906 = phi_1452_;
                                            let _e911 = ((_e906 >> bitcast<u32>(((_e824 * 8u) & 31u))) & 255u);
                                            let _e912 = (_e911 & 31u);
                                            if (_e912 >= 24u) {
                                                phi_1465_ = (24u + ((_e912 - 24u) ^ _e406));
                                            } else {
                                                phi_1465_ = _e912;
                                            }
                                            let _e918 = phi_1465_;
                                            phi_1470_ = (_e820 | ((_e911 >> bitcast<u32>(5i)) << bitcast<u32>((_e918 & 31u))));
                                        } else {
                                            phi_1470_ = _e820;
                                        }
                                        let _e926 = phi_1470_;
                                        phi_1471_ = _e926;
                                    } else {
                                        phi_1471_ = _e820;
                                    }
                                    let _e928 = phi_1471_;
                                    phi_1472_ = _e928;
                                } else {
                                    phi_1472_ = _e820;
                                }
                                let _e930 = phi_1472_;
                                phi_1342_ = (_e818 + 1u);
                                phi_1345_ = _e930;
                            } else {
                                phi_1342_ = u32();
                                phi_1345_ = u32();
                            }
                            let _e933 = phi_1342_;
                            let _e935 = phi_1345_;
                            continue;
                            continuing {
                                phi_1341_ = _e933;
                                phi_1344_ = _e935;
                                break if !(_e821);
                            }
                        }
                        let _e939 = nodes.member[(0u + _e544)].links[0u];
                        let _e943 = nodes.member[(0u + _e544)].frame[3u];
                        let _e947 = local_4;
                        if ((_e947 & 4278190080u) == 0u) {
                        } else {
                            let _e951 = local_3.group_mask;
                            if ((_e951 & 4278190080u) == 0u) {
                            } else {
                                let _e955 = local_3.len;
                                if (_e955 < 32u) {
                                    let _e958 = local_3.group;
                                    let _e960 = local_3.len;
                                    if (_e960 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_3.first[(0u + _e960)] = _e958;
                                    let _e966 = local_3.group_mask;
                                    let _e968 = local_3.len;
                                    if (_e968 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_3.mask[(0u + _e968)] = _e966;
                                    let _e975 = local_3.len;
                                    local_3.len = (_e975 + 1u);
                                }
                            }
                            local_3.group = (_e112 + _e939);
                            let _e979 = local_5;
                            local_3.group_mask = ((_e979 & 4278190080u) | (_e943 >> bitcast<u32>(24i)));
                        }
                        let _e984 = local_6;
                        phi_1530_ = (_e984 & 16777215u);
                        phi_1533_ = _e546;
                        loop {
                            let _e987 = phi_1530_;
                            let _e989 = phi_1533_;
                            local_12 = _e989;
                            if (_e987 == 0u) {
                                phi_1531_ = u32();
                                phi_1534_ = lt_bvh_Hit();
                                phi_3420_ = false;
                            } else {
                                let _e993 = nodes.member[(0u + _e544)].links[1u];
                                let _e997 = (_e993 + select(firstTrailingBit(_e987), 32u, (_e987 == 0u)));
                                if (_e997 < _e94) {
                                } else {
                                    return;
                                }
                                let _e1004 = instances.member[(0u + _e997)].low_world;
                                let _e1006 = instances.member[(0u + _e997)].high_world;
                                let _e1016 = ((_e1004.x - _e180.origin.x) * _e326);
                                let _e1017 = ((_e1004.y - _e180.origin.y) * _e337);
                                let _e1018 = ((_e1004.z - _e180.origin.z) * _e348);
                                let _e1028 = ((_e1006.x - _e180.origin.x) * _e326);
                                let _e1029 = ((_e1006.y - _e180.origin.y) * _e337);
                                let _e1030 = ((_e1006.z - _e180.origin.z) * _e348);
                                if (_e1016 < _e1028) {
                                    phi_1588_ = _e1016;
                                } else {
                                    phi_1588_ = _e1028;
                                }
                                let _e1033 = phi_1588_;
                                if (_e1017 < _e1029) {
                                    phi_1593_ = _e1017;
                                } else {
                                    phi_1593_ = _e1029;
                                }
                                let _e1036 = phi_1593_;
                                if (_e1018 < _e1030) {
                                    phi_1598_ = _e1018;
                                } else {
                                    phi_1598_ = _e1030;
                                }
                                let _e1039 = phi_1598_;
                                if (_e1016 > _e1028) {
                                    phi_1606_ = _e1016;
                                } else {
                                    phi_1606_ = _e1028;
                                }
                                let _e1045 = phi_1606_;
                                if (_e1017 > _e1029) {
                                    phi_1611_ = _e1017;
                                } else {
                                    phi_1611_ = _e1029;
                                }
                                let _e1048 = phi_1611_;
                                if (_e1018 > _e1030) {
                                    phi_1616_ = _e1018;
                                } else {
                                    phi_1616_ = _e1030;
                                }
                                let _e1051 = phi_1616_;
                                let _e1055 = core_intrinsics_maximum_number_nsz_f32_((_e1033 - _e393), (_e1036 - _e394));
                                let _e1056 = core_intrinsics_maximum_number_nsz_f32_(_e1055, (_e1039 - _e395));
                                let _e1057 = core_intrinsics_minimum_number_nsz_f32_((_e1045 + _e393), (_e1048 + _e394));
                                let _e1058 = core_intrinsics_minimum_number_nsz_f32_(_e1057, (_e1051 + _e395));
                                if (_e1056 <= _e1058) {
                                    if (_e1056 <= _e989.t) {
                                        if (_e1058 >= _e180.tmin) {
                                            let _e1070 = instances.member[(0u + _e997)].world_to_object[0u];
                                            let _e1081 = ((((_e1070.x * _e180.origin.x) + (_e1070.y * _e180.origin.y)) + (_e1070.z * _e180.origin.z)) + (_e1070.w * 1f));
                                            let _e1083 = instances.member[(0u + _e997)].world_to_object[1u];
                                            let _e1094 = ((((_e1083.x * _e180.origin.x) + (_e1083.y * _e180.origin.y)) + (_e1083.z * _e180.origin.z)) + (_e1083.w * 1f));
                                            let _e1096 = instances.member[(0u + _e997)].world_to_object[2u];
                                            let _e1107 = ((((_e1096.x * _e180.origin.x) + (_e1096.y * _e180.origin.y)) + (_e1096.z * _e180.origin.z)) + (_e1096.w * 1f));
                                            let _e1114 = instances.member[(0u + _e997)].world_to_object[0u];
                                            let _e1125 = ((((_e1114.x * _e180.direction.x) + (_e1114.y * _e180.direction.y)) + (_e1114.z * _e180.direction.z)) + (_e1114.w * 0f));
                                            let _e1127 = instances.member[(0u + _e997)].world_to_object[1u];
                                            let _e1138 = ((((_e1127.x * _e180.direction.x) + (_e1127.y * _e180.direction.y)) + (_e1127.z * _e180.direction.z)) + (_e1127.w * 0f));
                                            let _e1140 = instances.member[(0u + _e997)].world_to_object[2u];
                                            let _e1151 = ((((_e1140.x * _e180.direction.x) + (_e1140.y * _e180.direction.y)) + (_e1140.z * _e180.direction.z)) + (_e1140.w * 0f));
                                            let _e1156 = instances.member[(0u + _e997)].root;
                                            let _e1158 = instances.member[(0u + _e997)].first_triangle;
                                            let _e1159 = abs(_e1125);
                                            let _e1160 = abs(_e1138);
                                            let _e1161 = abs(_e1151);
                                            if (abs(_e1081) < 1000000000000000f) {
                                                if (abs(_e1094) < 1000000000000000f) {
                                                    phi_1748_ = (abs(_e1107) < 1000000000000000f);
                                                    phi_1749_ = false;
                                                } else {
                                                    phi_1748_ = bool();
                                                    phi_1749_ = true;
                                                }
                                                let _e1169 = phi_1748_;
                                                let _e1171 = phi_1749_;
                                                phi_1750_ = _e1169;
                                                phi_1751_ = _e1171;
                                            } else {
                                                phi_1750_ = bool();
                                                phi_1751_ = true;
                                            }
                                            let _e1173 = phi_1750_;
                                            let _e1175 = phi_1751_;
                                            if _e1175 {
                                                phi_1755_ = false;
                                            } else {
                                                phi_1755_ = _e1173;
                                            }
                                            let _e1177 = phi_1755_;
                                            if _e1177 {
                                                if (_e1159 < 1000000000000000f) {
                                                    if (_e1160 < 1000000000000000f) {
                                                        phi_1768_ = (_e1161 < 1000000000000000f);
                                                        phi_1769_ = false;
                                                    } else {
                                                        phi_1768_ = bool();
                                                        phi_1769_ = true;
                                                    }
                                                    let _e1182 = phi_1768_;
                                                    let _e1184 = phi_1769_;
                                                    phi_1770_ = _e1182;
                                                    phi_1771_ = _e1184;
                                                } else {
                                                    phi_1770_ = bool();
                                                    phi_1771_ = true;
                                                }
                                                let _e1186 = phi_1770_;
                                                let _e1188 = phi_1771_;
                                                if _e1188 {
                                                    phi_1775_ = false;
                                                } else {
                                                    phi_1775_ = _e1186;
                                                }
                                                let _e1190 = phi_1775_;
                                                if _e1190 {
                                                    if (_e1159 > 0f) {
                                                        phi_1789_ = bool();
                                                        phi_1790_ = true;
                                                    } else {
                                                        let _e1192 = (_e1160 > 0f);
                                                        if _e1192 {
                                                            phi_1788_ = bool();
                                                        } else {
                                                            phi_1788_ = (_e1161 > 0f);
                                                        }
                                                        let _e1195 = phi_1788_;
                                                        phi_1789_ = _e1195;
                                                        phi_1790_ = _e1192;
                                                    }
                                                    let _e1197 = phi_1789_;
                                                    let _e1199 = phi_1790_;
                                                    if _e1199 {
                                                        phi_1794_ = true;
                                                    } else {
                                                        phi_1794_ = _e1197;
                                                    }
                                                    let _e1201 = phi_1794_;
                                                    phi_1795_ = _e1201;
                                                    phi_1796_ = false;
                                                } else {
                                                    phi_1795_ = bool();
                                                    phi_1796_ = true;
                                                }
                                                let _e1203 = phi_1795_;
                                                let _e1205 = phi_1796_;
                                                phi_1797_ = _e1203;
                                                phi_1798_ = _e1205;
                                            } else {
                                                phi_1797_ = bool();
                                                phi_1798_ = true;
                                            }
                                            let _e1207 = phi_1797_;
                                            let _e1209 = phi_1798_;
                                            if _e1209 {
                                                phi_1802_ = false;
                                            } else {
                                                phi_1802_ = _e1207;
                                            }
                                            let _e1211 = phi_1802_;
                                            if _e1211 {
                                                let _e1212 = (_e1156 >= _e79);
                                                if _e1212 {
                                                    phi_3410_ = lt_bvh_Hit();
                                                } else {
                                                    if (_e1156 < _e79) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1218 = nodes.member[(0u + _e1156)].frame[0u];
                                                    let _e1222 = nodes.member[(0u + _e1156)].frame[1u];
                                                    let _e1226 = nodes.member[(0u + _e1156)].frame[2u];
                                                    let _e1230 = nodes.member[(0u + _e1156)].frame[0u];
                                                    let _e1234 = nodes.member[(0u + _e1156)].frame[1u];
                                                    let _e1238 = nodes.member[(0u + _e1156)].frame[2u];
                                                    let _e1242 = nodes.member[(0u + _e1156)].frame[3u];
                                                    let _e1276 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1125), abs(_e1138));
                                                    let _e1277 = core_intrinsics_maximum_number_nsz_f32_(_e1276, abs(_e1151));
                                                    let _e1278 = (_e1277 * 0.0000000000009094947f);
                                                    if (abs(_e1125) < _e1278) {
                                                        phi_1872_ = _e1278;
                                                    } else {
                                                        phi_1872_ = abs(_e1125);
                                                    }
                                                    let _e1283 = phi_1872_;
                                                    if (_e1125 < 0f) {
                                                        phi_1879_ = (-1f / _e1283);
                                                    } else {
                                                        phi_1879_ = (1f / _e1283);
                                                    }
                                                    let _e1288 = phi_1879_;
                                                    if (abs(_e1138) < _e1278) {
                                                        phi_1886_ = _e1278;
                                                    } else {
                                                        phi_1886_ = abs(_e1138);
                                                    }
                                                    let _e1293 = phi_1886_;
                                                    if (_e1138 < 0f) {
                                                        phi_1893_ = (-1f / _e1293);
                                                    } else {
                                                        phi_1893_ = (1f / _e1293);
                                                    }
                                                    let _e1298 = phi_1893_;
                                                    if (abs(_e1151) < _e1278) {
                                                        phi_1900_ = _e1278;
                                                    } else {
                                                        phi_1900_ = abs(_e1151);
                                                    }
                                                    let _e1303 = phi_1900_;
                                                    if (_e1151 < 0f) {
                                                        phi_1907_ = (-1f / _e1303);
                                                    } else {
                                                        phi_1907_ = (1f / _e1303);
                                                    }
                                                    let _e1308 = phi_1907_;
                                                    let _e1312 = abs((bitcast<f32>(_e1218) - _e1081));
                                                    let _e1313 = abs((bitcast<f32>(_e1222) - _e1094));
                                                    let _e1314 = abs((bitcast<f32>(_e1226) - _e1107));
                                                    let _e1318 = abs(((bitcast<f32>(_e1230) + (bitcast<f32>((((_e1242 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1081));
                                                    let _e1319 = abs(((bitcast<f32>(_e1234) + (bitcast<f32>((((_e1242 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1094));
                                                    let _e1320 = abs(((bitcast<f32>(_e1238) + (bitcast<f32>((((_e1242 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1107));
                                                    if (_e1312 > _e1318) {
                                                        phi_1924_ = _e1312;
                                                    } else {
                                                        phi_1924_ = _e1318;
                                                    }
                                                    let _e1323 = phi_1924_;
                                                    if (_e1313 > _e1319) {
                                                        phi_1929_ = _e1313;
                                                    } else {
                                                        phi_1929_ = _e1319;
                                                    }
                                                    let _e1326 = phi_1929_;
                                                    if (_e1314 > _e1320) {
                                                        phi_1934_ = _e1314;
                                                    } else {
                                                        phi_1934_ = _e1320;
                                                    }
                                                    let _e1329 = phi_1934_;
                                                    if (_e1323 > _e1326) {
                                                        phi_1939_ = _e1323;
                                                    } else {
                                                        phi_1939_ = _e1326;
                                                    }
                                                    let _e1332 = phi_1939_;
                                                    if (_e1332 > _e1329) {
                                                        phi_1944_ = _e1332;
                                                    } else {
                                                        phi_1944_ = _e1329;
                                                    }
                                                    let _e1335 = phi_1944_;
                                                    let _e1339 = (_e1335 * 0.0000019073486f);
                                                    let _e1340 = (abs(_e1288) * _e1339);
                                                    let _e1341 = (abs(_e1298) * _e1339);
                                                    let _e1342 = (abs(_e1308) * _e1339);
                                                    let _e1346 = (_e1335 * 0.0000009536743f);
                                                    let _e1347 = (abs(_e1288) * _e1346);
                                                    let _e1348 = (abs(_e1298) * _e1346);
                                                    let _e1349 = (abs(_e1308) * _e1346);
                                                    let _e1350 = abs(_e1125);
                                                    let _e1351 = abs(_e1138);
                                                    let _e1352 = abs(_e1151);
                                                    if (_e1350 >= _e1351) {
                                                        if (_e1350 >= _e1352) {
                                                            phi_1970_ = false;
                                                        } else {
                                                            phi_1970_ = true;
                                                        }
                                                        let _e1356 = phi_1970_;
                                                        phi_1971_ = _e1356;
                                                    } else {
                                                        phi_1971_ = true;
                                                    }
                                                    let _e1358 = phi_1971_;
                                                    if _e1358 {
                                                        if (_e1351 >= _e1352) {
                                                            phi_1979_ = 1u;
                                                        } else {
                                                            phi_1979_ = 2u;
                                                        }
                                                        let _e1361 = phi_1979_;
                                                        phi_1980_ = _e1361;
                                                    } else {
                                                        phi_1980_ = 0u;
                                                    }
                                                    let _e1363 = phi_1980_;
                                                    if (_e1363 == 0u) {
                                                        phi_1992_ = vec3<f32>(_e1138, _e1151, _e1125);
                                                    } else {
                                                        if (_e1363 == 1u) {
                                                            phi_1991_ = vec3<f32>(_e1151, _e1125, _e1138);
                                                        } else {
                                                            phi_1991_ = vec3<f32>(_e1125, _e1138, _e1151);
                                                        }
                                                        let _e1369 = phi_1991_;
                                                        phi_1992_ = _e1369;
                                                    }
                                                    let _e1371 = phi_1992_;
                                                    let _e1374 = (_e1371.x / _e1371.z);
                                                    let _e1377 = (_e1371.y / _e1371.z);
                                                    if (_e1288 < 0f) {
                                                        phi_2005_ = 0u;
                                                    } else {
                                                        phi_2005_ = 1u;
                                                    }
                                                    let _e1382 = phi_2005_;
                                                    if (_e1298 < 0f) {
                                                        phi_2010_ = 0u;
                                                    } else {
                                                        phi_2010_ = 2u;
                                                    }
                                                    let _e1385 = phi_2010_;
                                                    if (_e1308 < 0f) {
                                                        phi_2015_ = 0u;
                                                    } else {
                                                        phi_2015_ = 4u;
                                                    }
                                                    let _e1388 = phi_2015_;
                                                    let _e1390 = ((_e1382 | _e1385) | _e1388);
                                                    let _e1391 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1156, 2147483648u);
                                                    local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e1391.first[0], _e1391.first[1], _e1391.first[2], _e1391.first[3], _e1391.first[4], _e1391.first[5], _e1391.first[6], _e1391.first[7], _e1391.first[8], _e1391.first[9], _e1391.first[10], _e1391.first[11], _e1391.first[12], _e1391.first[13], _e1391.first[14], _e1391.first[15], _e1391.first[16], _e1391.first[17], _e1391.first[18], _e1391.first[19], _e1391.first[20], _e1391.first[21], _e1391.first[22], _e1391.first[23], _e1391.first[24], _e1391.first[25], _e1391.first[26], _e1391.first[27], _e1391.first[28], _e1391.first[29], _e1391.first[30], _e1391.first[31]), array<u32, 32>(_e1391.mask[0], _e1391.mask[1], _e1391.mask[2], _e1391.mask[3], _e1391.mask[4], _e1391.mask[5], _e1391.mask[6], _e1391.mask[7], _e1391.mask[8], _e1391.mask[9], _e1391.mask[10], _e1391.mask[11], _e1391.mask[12], _e1391.mask[13], _e1391.mask[14], _e1391.mask[15], _e1391.mask[16], _e1391.mask[17], _e1391.mask[18], _e1391.mask[19], _e1391.mask[20], _e1391.mask[21], _e1391.mask[22], _e1391.mask[23], _e1391.mask[24], _e1391.mask[25], _e1391.mask[26], _e1391.mask[27], _e1391.mask[28], _e1391.mask[29], _e1391.mask[30], _e1391.mask[31]), _e1391.len, _e1391.group, _e1391.group_mask);
                                                    let _e1465 = local_2.group_mask;
                                                    if ((_e1465 & 4278190080u) == 0u) {
                                                        let _e1469 = local_2.len;
                                                        if (_e1469 == 0u) {
                                                            phi_2129_ = false;
                                                        } else {
                                                            let _e1473 = local_2.len;
                                                            local_2.len = (_e1473 - 1u);
                                                            let _e1476 = local_2.len;
                                                            if (_e1476 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1481 = local_2.first[(0u + _e1476)];
                                                            local_2.group = _e1481;
                                                            let _e1484 = local_2.len;
                                                            if (_e1484 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1489 = local_2.mask[(0u + _e1484)];
                                                            local_2.group_mask = _e1489;
                                                            phi_2129_ = true;
                                                        }
                                                        let _e1492 = phi_2129_;
                                                        phi_2130_ = _e1492;
                                                    } else {
                                                        phi_2130_ = true;
                                                    }
                                                    let _e1494 = phi_2130_;
                                                    if _e1494 {
                                                        let _e1496 = local_2.group_mask;
                                                        let _e1502 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1496)), 32u, (_e1496 == 0u)));
                                                        let _e1506 = local_2.group_mask;
                                                        let _e1520 = local_2.group_mask;
                                                        local_2.group_mask = (_e1520 & ~((1u << bitcast<u32>((_e1502 & 31u)))));
                                                        let _e1523 = local_2.group;
                                                        phi_2161_ = (_e1523 + countOneBits(((_e1506 & ~((4294967295u << bitcast<u32>((((_e1502 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_2161_ = 4294967295u;
                                                    }
                                                    let _e1526 = phi_2161_;
                                                    phi_2163_ = _e989;
                                                    phi_2166_ = _e1526;
                                                    loop {
                                                        let _e1528 = phi_2163_;
                                                        let _e1530 = phi_2166_;
                                                        local_11 = _e1528;
                                                        let _e1531 = (_e1530 != 4294967295u);
                                                        if _e1531 {
                                                            if (_e1530 < _e79) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1538 = nodes.member[(0u + _e1530)].frame[3u];
                                                            let _e1563 = (bitcast<f32>((((_e1538 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1288);
                                                            let _e1564 = (bitcast<f32>((((_e1538 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1298);
                                                            let _e1565 = (bitcast<f32>((((_e1538 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1308);
                                                            let _e1568 = nodes.member[(0u + _e1530)].frame[0u];
                                                            let _e1572 = nodes.member[(0u + _e1530)].frame[1u];
                                                            let _e1576 = nodes.member[(0u + _e1530)].frame[2u];
                                                            let _e1581 = ((bitcast<f32>(_e1568) - _e1081) * _e1288);
                                                            let _e1582 = ((bitcast<f32>(_e1572) - _e1094) * _e1298);
                                                            let _e1583 = ((bitcast<f32>(_e1576) - _e1107) * _e1308);
                                                            let _e1591 = nodes.member[(0u + _e1530)].x;
                                                            if (_e1288 < 0f) {
                                                                let _e1602 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1591.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1608 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1602.unnamed.root, _e1591.w), _e1602.unnamed_1);
                                                                let _e1614 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1608.unnamed, lt_bvh_traverse_Tree(_e1591.x, _e1608.unnamed_1.first_primitive));
                                                                phi_2247_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1614.unnamed, lt_bvh_traverse_Tree(_e1614.unnamed_1.root, _e1591.y));
                                                            } else {
                                                                let _e1630 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1591.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1636 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1630.unnamed.root, _e1591.y), _e1630.unnamed_1);
                                                                let _e1642 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1636.unnamed, lt_bvh_traverse_Tree(_e1591.z, _e1636.unnamed_1.first_primitive));
                                                                phi_2247_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1642.unnamed, lt_bvh_traverse_Tree(_e1642.unnamed_1.root, _e1591.w));
                                                            }
                                                            let _e1650 = phi_2247_;
                                                            let _e1660 = nodes.member[(0u + _e1530)].y;
                                                            if (_e1298 < 0f) {
                                                                let _e1671 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1660.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1677 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1671.unnamed.root, _e1660.w), _e1671.unnamed_1);
                                                                let _e1683 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1677.unnamed, lt_bvh_traverse_Tree(_e1660.x, _e1677.unnamed_1.first_primitive));
                                                                phi_2274_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1683.unnamed, lt_bvh_traverse_Tree(_e1683.unnamed_1.root, _e1660.y));
                                                            } else {
                                                                let _e1699 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1660.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1705 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1699.unnamed.root, _e1660.y), _e1699.unnamed_1);
                                                                let _e1711 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1705.unnamed, lt_bvh_traverse_Tree(_e1660.z, _e1705.unnamed_1.first_primitive));
                                                                phi_2274_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1711.unnamed, lt_bvh_traverse_Tree(_e1711.unnamed_1.root, _e1660.w));
                                                            }
                                                            let _e1719 = phi_2274_;
                                                            let _e1729 = nodes.member[(0u + _e1530)].z;
                                                            if (_e1308 < 0f) {
                                                                let _e1740 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1729.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1746 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1740.unnamed.root, _e1729.w), _e1740.unnamed_1);
                                                                let _e1752 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1746.unnamed, lt_bvh_traverse_Tree(_e1729.x, _e1746.unnamed_1.first_primitive));
                                                                phi_2301_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1752.unnamed, lt_bvh_traverse_Tree(_e1752.unnamed_1.root, _e1729.y));
                                                            } else {
                                                                let _e1768 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1729.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1774 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1768.unnamed.root, _e1729.y), _e1768.unnamed_1);
                                                                let _e1780 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1774.unnamed, lt_bvh_traverse_Tree(_e1729.z, _e1774.unnamed_1.first_primitive));
                                                                phi_2301_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1780.unnamed, lt_bvh_traverse_Tree(_e1780.unnamed_1.root, _e1729.w));
                                                            }
                                                            let _e1788 = phi_2301_;
                                                            phi_2307_ = 0u;
                                                            phi_2310_ = 0u;
                                                            loop {
                                                                let _e1798 = phi_2307_;
                                                                let _e1800 = phi_2310_;
                                                                local_7 = _e1800;
                                                                local_8 = _e1800;
                                                                local_9 = _e1800;
                                                                let _e1801 = (_e1798 < 8u);
                                                                if _e1801 {
                                                                    let _e1803 = (_e1798 >> bitcast<u32>(2i));
                                                                    let _e1804 = (_e1798 & 3u);
                                                                    if (_e1803 == 0u) {
                                                                        phi_2324_ = _e1650.unnamed.root;
                                                                    } else {
                                                                        phi_2324_ = _e1650.unnamed.first_primitive;
                                                                    }
                                                                    let _e1807 = phi_2324_;
                                                                    if (_e1803 == 0u) {
                                                                        phi_2334_ = _e1719.unnamed.root;
                                                                    } else {
                                                                        phi_2334_ = _e1719.unnamed.first_primitive;
                                                                    }
                                                                    let _e1816 = phi_2334_;
                                                                    if (_e1803 == 0u) {
                                                                        phi_2344_ = _e1788.unnamed.root;
                                                                    } else {
                                                                        phi_2344_ = _e1788.unnamed.first_primitive;
                                                                    }
                                                                    let _e1825 = phi_2344_;
                                                                    let _e1838 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1807 >> bitcast<u32>(((_e1804 * 8u) & 31u))) & 255u)) * _e1563) + (_e1581 - _e1340)), ((f32(((_e1816 >> bitcast<u32>(((_e1804 * 8u) & 31u))) & 255u)) * _e1564) + (_e1582 - _e1341)));
                                                                    let _e1839 = core_intrinsics_maximum_number_nsz_f32_(_e1838, ((f32(((_e1825 >> bitcast<u32>(((_e1804 * 8u) & 31u))) & 255u)) * _e1565) + (_e1583 - _e1342)));
                                                                    if (_e1803 == 0u) {
                                                                        phi_2362_ = _e1650.unnamed_1.root;
                                                                    } else {
                                                                        phi_2362_ = _e1650.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1842 = phi_2362_;
                                                                    if (_e1803 == 0u) {
                                                                        phi_2372_ = _e1719.unnamed_1.root;
                                                                    } else {
                                                                        phi_2372_ = _e1719.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1851 = phi_2372_;
                                                                    if (_e1803 == 0u) {
                                                                        phi_2382_ = _e1788.unnamed_1.root;
                                                                    } else {
                                                                        phi_2382_ = _e1788.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1860 = phi_2382_;
                                                                    let _e1873 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1842 >> bitcast<u32>(((_e1804 * 8u) & 31u))) & 255u)) * _e1563) + (_e1581 + _e1340)), ((f32(((_e1851 >> bitcast<u32>(((_e1804 * 8u) & 31u))) & 255u)) * _e1564) + (_e1582 + _e1341)));
                                                                    let _e1874 = core_intrinsics_minimum_number_nsz_f32_(_e1873, ((f32(((_e1860 >> bitcast<u32>(((_e1804 * 8u) & 31u))) & 255u)) * _e1565) + (_e1583 + _e1342)));
                                                                    if (_e1839 <= _e1874) {
                                                                        if (_e1839 <= _e1528.t) {
                                                                            if (_e1874 >= _e180.tmin) {
                                                                                if (_e1803 == 0u) {
                                                                                    let _e1881 = nodes.member[(0u + _e1530)].links[2u];
                                                                                    phi_2418_ = _e1881;
                                                                                } else {
                                                                                    let _e1884 = nodes.member[(0u + _e1530)].links[3u];
                                                                                    phi_2418_ = _e1884;
                                                                                }
                                                                                let _e1886 = phi_2418_;
                                                                                let _e1891 = ((_e1886 >> bitcast<u32>(((_e1804 * 8u) & 31u))) & 255u);
                                                                                let _e1892 = (_e1891 & 31u);
                                                                                if (_e1892 >= 24u) {
                                                                                    phi_2431_ = (24u + ((_e1892 - 24u) ^ _e1390));
                                                                                } else {
                                                                                    phi_2431_ = _e1892;
                                                                                }
                                                                                let _e1898 = phi_2431_;
                                                                                phi_2436_ = (_e1800 | ((_e1891 >> bitcast<u32>(5i)) << bitcast<u32>((_e1898 & 31u))));
                                                                            } else {
                                                                                phi_2436_ = _e1800;
                                                                            }
                                                                            let _e1906 = phi_2436_;
                                                                            phi_2437_ = _e1906;
                                                                        } else {
                                                                            phi_2437_ = _e1800;
                                                                        }
                                                                        let _e1908 = phi_2437_;
                                                                        phi_2438_ = _e1908;
                                                                    } else {
                                                                        phi_2438_ = _e1800;
                                                                    }
                                                                    let _e1910 = phi_2438_;
                                                                    phi_2308_ = (_e1798 + 1u);
                                                                    phi_2311_ = _e1910;
                                                                } else {
                                                                    phi_2308_ = u32();
                                                                    phi_2311_ = u32();
                                                                }
                                                                let _e1913 = phi_2308_;
                                                                let _e1915 = phi_2311_;
                                                                continue;
                                                                continuing {
                                                                    phi_2307_ = _e1913;
                                                                    phi_2310_ = _e1915;
                                                                    break if !(_e1801);
                                                                }
                                                            }
                                                            let _e1919 = nodes.member[(0u + _e1530)].links[0u];
                                                            let _e1923 = nodes.member[(0u + _e1530)].frame[3u];
                                                            let _e1927 = local_7;
                                                            if ((_e1927 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1931 = local_2.group_mask;
                                                                if ((_e1931 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1935 = local_2.len;
                                                                    if (_e1935 < 32u) {
                                                                        let _e1938 = local_2.group;
                                                                        let _e1940 = local_2.len;
                                                                        if (_e1940 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_2.first[(0u + _e1940)] = _e1938;
                                                                        let _e1946 = local_2.group_mask;
                                                                        let _e1948 = local_2.len;
                                                                        if (_e1948 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_2.mask[(0u + _e1948)] = _e1946;
                                                                        let _e1955 = local_2.len;
                                                                        local_2.len = (_e1955 + 1u);
                                                                    }
                                                                }
                                                                local_2.group = (_e1156 + _e1919);
                                                                let _e1959 = local_8;
                                                                local_2.group_mask = ((_e1959 & 4278190080u) | (_e1923 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1964 = local_9;
                                                            phi_2496_ = _e1528;
                                                            phi_2499_ = (_e1964 & 16777215u);
                                                            loop {
                                                                let _e1967 = phi_2496_;
                                                                let _e1969 = phi_2499_;
                                                                local_10 = _e1967;
                                                                if (_e1969 == 0u) {
                                                                    phi_2497_ = lt_bvh_Hit();
                                                                    phi_2500_ = u32();
                                                                    phi_3338_ = false;
                                                                } else {
                                                                    let _e1973 = nodes.member[(0u + _e1530)].links[1u];
                                                                    let _e1978 = ((_e1158 + _e1973) + select(firstTrailingBit(_e1969), 32u, (_e1969 == 0u)));
                                                                    if (_e1978 < _e82) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1985 = triangles.member[(0u + _e1978)].v0_;
                                                                    let _e1987 = (_e1985.x - _e1081);
                                                                    let _e1989 = (_e1985.y - _e1094);
                                                                    let _e1991 = (_e1985.z - _e1107);
                                                                    if (_e1363 == 0u) {
                                                                        phi_2544_ = vec3<f32>(_e1989, _e1991, _e1987);
                                                                    } else {
                                                                        if (_e1363 == 1u) {
                                                                            phi_2543_ = vec3<f32>(_e1991, _e1987, _e1989);
                                                                        } else {
                                                                            phi_2543_ = (_e1985 - vec3<f32>(_e1081, _e1094, _e1107));
                                                                        }
                                                                        let _e1999 = phi_2543_;
                                                                        phi_2544_ = _e1999;
                                                                    }
                                                                    let _e2001 = phi_2544_;
                                                                    let _e2005 = (_e2001.x - (_e1374 * _e2001.z));
                                                                    let _e2009 = (_e2001.y - (_e1377 * _e2001.z));
                                                                    let _e2011 = triangles.member[(0u + _e1978)].v1_;
                                                                    let _e2013 = (_e2011.x - _e1081);
                                                                    let _e2015 = (_e2011.y - _e1094);
                                                                    let _e2017 = (_e2011.z - _e1107);
                                                                    if (_e1363 == 0u) {
                                                                        phi_2574_ = vec3<f32>(_e2015, _e2017, _e2013);
                                                                    } else {
                                                                        if (_e1363 == 1u) {
                                                                            phi_2573_ = vec3<f32>(_e2017, _e2013, _e2015);
                                                                        } else {
                                                                            phi_2573_ = (_e2011 - vec3<f32>(_e1081, _e1094, _e1107));
                                                                        }
                                                                        let _e2025 = phi_2573_;
                                                                        phi_2574_ = _e2025;
                                                                    }
                                                                    let _e2027 = phi_2574_;
                                                                    let _e2031 = (_e2027.x - (_e1374 * _e2027.z));
                                                                    let _e2035 = (_e2027.y - (_e1377 * _e2027.z));
                                                                    let _e2037 = triangles.member[(0u + _e1978)].v2_;
                                                                    let _e2039 = (_e2037.x - _e1081);
                                                                    let _e2041 = (_e2037.y - _e1094);
                                                                    let _e2043 = (_e2037.z - _e1107);
                                                                    if (_e1363 == 0u) {
                                                                        phi_2604_ = vec3<f32>(_e2041, _e2043, _e2039);
                                                                    } else {
                                                                        if (_e1363 == 1u) {
                                                                            phi_2603_ = vec3<f32>(_e2043, _e2039, _e2041);
                                                                        } else {
                                                                            phi_2603_ = (_e2037 - vec3<f32>(_e1081, _e1094, _e1107));
                                                                        }
                                                                        let _e2051 = phi_2603_;
                                                                        phi_2604_ = _e2051;
                                                                    }
                                                                    let _e2053 = phi_2604_;
                                                                    let _e2057 = (_e2053.x - (_e1374 * _e2053.z));
                                                                    let _e2061 = (_e2053.y - (_e1377 * _e2053.z));
                                                                    if (_e2031 < _e2057) {
                                                                        phi_2623_ = true;
                                                                    } else {
                                                                        if (_e2031 == _e2057) {
                                                                            phi_2622_ = (_e2035 < _e2061);
                                                                        } else {
                                                                            phi_2622_ = false;
                                                                        }
                                                                        let _e2066 = phi_2622_;
                                                                        phi_2623_ = _e2066;
                                                                    }
                                                                    let _e2068 = phi_2623_;
                                                                    if _e2068 {
                                                                        phi_2627_ = _e2061;
                                                                        phi_2628_ = _e2057;
                                                                        phi_2629_ = _e2035;
                                                                        phi_2630_ = _e2031;
                                                                    } else {
                                                                        phi_2627_ = _e2035;
                                                                        phi_2628_ = _e2031;
                                                                        phi_2629_ = _e2061;
                                                                        phi_2630_ = _e2057;
                                                                    }
                                                                    let _e2070 = phi_2627_;
                                                                    let _e2072 = phi_2628_;
                                                                    let _e2074 = phi_2629_;
                                                                    let _e2076 = phi_2630_;
                                                                    let _e2079 = ((_e2076 * _e2070) - (_e2074 * _e2072));
                                                                    if _e2068 {
                                                                        phi_2638_ = -(_e2079);
                                                                    } else {
                                                                        phi_2638_ = _e2079;
                                                                    }
                                                                    let _e2082 = phi_2638_;
                                                                    if (_e2057 < _e2005) {
                                                                        phi_2649_ = true;
                                                                    } else {
                                                                        if (_e2057 == _e2005) {
                                                                            phi_2648_ = (_e2061 < _e2009);
                                                                        } else {
                                                                            phi_2648_ = false;
                                                                        }
                                                                        let _e2087 = phi_2648_;
                                                                        phi_2649_ = _e2087;
                                                                    }
                                                                    let _e2089 = phi_2649_;
                                                                    if _e2089 {
                                                                        phi_2653_ = _e2009;
                                                                        phi_2654_ = _e2005;
                                                                        phi_2655_ = _e2061;
                                                                        phi_2656_ = _e2057;
                                                                    } else {
                                                                        phi_2653_ = _e2061;
                                                                        phi_2654_ = _e2057;
                                                                        phi_2655_ = _e2009;
                                                                        phi_2656_ = _e2005;
                                                                    }
                                                                    let _e2091 = phi_2653_;
                                                                    let _e2093 = phi_2654_;
                                                                    let _e2095 = phi_2655_;
                                                                    let _e2097 = phi_2656_;
                                                                    let _e2100 = ((_e2097 * _e2091) - (_e2095 * _e2093));
                                                                    if _e2089 {
                                                                        phi_2664_ = -(_e2100);
                                                                    } else {
                                                                        phi_2664_ = _e2100;
                                                                    }
                                                                    let _e2103 = phi_2664_;
                                                                    if (_e2005 < _e2031) {
                                                                        phi_2675_ = true;
                                                                    } else {
                                                                        if (_e2005 == _e2031) {
                                                                            phi_2674_ = (_e2009 < _e2035);
                                                                        } else {
                                                                            phi_2674_ = false;
                                                                        }
                                                                        let _e2108 = phi_2674_;
                                                                        phi_2675_ = _e2108;
                                                                    }
                                                                    let _e2110 = phi_2675_;
                                                                    if _e2110 {
                                                                        phi_2679_ = _e2035;
                                                                        phi_2680_ = _e2031;
                                                                        phi_2681_ = _e2009;
                                                                        phi_2682_ = _e2005;
                                                                    } else {
                                                                        phi_2679_ = _e2009;
                                                                        phi_2680_ = _e2005;
                                                                        phi_2681_ = _e2035;
                                                                        phi_2682_ = _e2031;
                                                                    }
                                                                    let _e2112 = phi_2679_;
                                                                    let _e2114 = phi_2680_;
                                                                    let _e2116 = phi_2681_;
                                                                    let _e2118 = phi_2682_;
                                                                    let _e2121 = ((_e2118 * _e2112) - (_e2116 * _e2114));
                                                                    if _e2110 {
                                                                        phi_2690_ = -(_e2121);
                                                                    } else {
                                                                        phi_2690_ = _e2121;
                                                                    }
                                                                    let _e2124 = phi_2690_;
                                                                    if (_e2082 >= 0f) {
                                                                        if (_e2103 >= 0f) {
                                                                            if (_e2124 >= 0f) {
                                                                                phi_2705_ = ((_e2082 + _e2103) + _e2124);
                                                                                phi_2706_ = false;
                                                                            } else {
                                                                                phi_2705_ = f32();
                                                                                phi_2706_ = true;
                                                                            }
                                                                            let _e2131 = phi_2705_;
                                                                            let _e2133 = phi_2706_;
                                                                            phi_2707_ = _e2131;
                                                                            phi_2708_ = _e2133;
                                                                        } else {
                                                                            phi_2707_ = f32();
                                                                            phi_2708_ = true;
                                                                        }
                                                                        let _e2135 = phi_2707_;
                                                                        let _e2137 = phi_2708_;
                                                                        phi_2709_ = _e2135;
                                                                        phi_2710_ = _e2137;
                                                                    } else {
                                                                        phi_2709_ = f32();
                                                                        phi_2710_ = true;
                                                                    }
                                                                    let _e2139 = phi_2709_;
                                                                    let _e2141 = phi_2710_;
                                                                    if _e2141 {
                                                                        if (_e2082 <= 0f) {
                                                                            if (_e2103 <= 0f) {
                                                                                let _e2144 = (_e2124 <= 0f);
                                                                                if _e2144 {
                                                                                }
                                                                                phi_2728_ = ((_e2082 + _e2103) + _e2124);
                                                                                phi_2729_ = false;
                                                                                phi_2730_ = _e2144;
                                                                            } else {
                                                                                phi_2728_ = f32();
                                                                                phi_2729_ = true;
                                                                                phi_2730_ = false;
                                                                            }
                                                                            let _e2148 = phi_2728_;
                                                                            let _e2150 = phi_2729_;
                                                                            let _e2152 = phi_2730_;
                                                                            phi_2731_ = _e2148;
                                                                            phi_2732_ = _e2150;
                                                                            phi_2733_ = _e2152;
                                                                        } else {
                                                                            phi_2731_ = f32();
                                                                            phi_2732_ = true;
                                                                            phi_2733_ = false;
                                                                        }
                                                                        let _e2154 = phi_2731_;
                                                                        let _e2156 = phi_2732_;
                                                                        let _e2158 = phi_2733_;
                                                                        if _e2156 {
                                                                            phi_2737_ = false;
                                                                        } else {
                                                                            phi_2737_ = _e2158;
                                                                        }
                                                                        let _e2160 = phi_2737_;
                                                                        phi_2738_ = _e2154;
                                                                        phi_2739_ = _e2160;
                                                                    } else {
                                                                        phi_2738_ = _e2139;
                                                                        phi_2739_ = true;
                                                                    }
                                                                    let _e2162 = phi_2738_;
                                                                    let _e2164 = phi_2739_;
                                                                    if _e2164 {
                                                                        let _e2165 = (_e2162 == 0f);
                                                                        if _e2165 {
                                                                            phi_3055_ = lt_bvh_triangle_Intersection();
                                                                            phi_3056_ = false;
                                                                        } else {
                                                                            let _e2167 = triangles.member[(0u + _e1978)].v0_;
                                                                            let _e2169 = (_e2167.x - _e1081);
                                                                            let _e2171 = (_e2167.y - _e1094);
                                                                            let _e2173 = (_e2167.z - _e1107);
                                                                            if (_e1363 == 0u) {
                                                                                phi_2768_ = vec3<f32>(_e2171, _e2173, _e2169);
                                                                            } else {
                                                                                if (_e1363 == 1u) {
                                                                                    phi_2767_ = vec3<f32>(_e2173, _e2169, _e2171);
                                                                                } else {
                                                                                    phi_2767_ = (_e2167 - vec3<f32>(_e1081, _e1094, _e1107));
                                                                                }
                                                                                let _e2181 = phi_2767_;
                                                                                phi_2768_ = _e2181;
                                                                            }
                                                                            let _e2183 = phi_2768_;
                                                                            let _e2185 = triangles.member[(0u + _e1978)].v1_;
                                                                            let _e2187 = triangles.member[(0u + _e1978)].v0_;
                                                                            let _e2190 = (_e2185.x - _e2187.x);
                                                                            let _e2193 = (_e2185.y - _e2187.y);
                                                                            let _e2196 = (_e2185.z - _e2187.z);
                                                                            if (_e1363 == 0u) {
                                                                                phi_2794_ = vec3<f32>(_e2193, _e2196, _e2190);
                                                                            } else {
                                                                                if (_e1363 == 1u) {
                                                                                    phi_2793_ = vec3<f32>(_e2196, _e2190, _e2193);
                                                                                } else {
                                                                                    phi_2793_ = (_e2185 - _e2187);
                                                                                }
                                                                                let _e2203 = phi_2793_;
                                                                                phi_2794_ = _e2203;
                                                                            }
                                                                            let _e2205 = phi_2794_;
                                                                            let _e2207 = triangles.member[(0u + _e1978)].v2_;
                                                                            let _e2209 = triangles.member[(0u + _e1978)].v0_;
                                                                            let _e2212 = (_e2207.x - _e2209.x);
                                                                            let _e2215 = (_e2207.y - _e2209.y);
                                                                            let _e2218 = (_e2207.z - _e2209.z);
                                                                            if (_e1363 == 0u) {
                                                                                phi_2820_ = vec3<f32>(_e2215, _e2218, _e2212);
                                                                            } else {
                                                                                if (_e1363 == 1u) {
                                                                                    phi_2819_ = vec3<f32>(_e2218, _e2212, _e2215);
                                                                                } else {
                                                                                    phi_2819_ = (_e2207 - _e2209);
                                                                                }
                                                                                let _e2225 = phi_2819_;
                                                                                phi_2820_ = _e2225;
                                                                            }
                                                                            let _e2227 = phi_2820_;
                                                                            let _e2234 = ((_e2205.y * _e2227.z) - (_e2205.z * _e2227.y));
                                                                            let _e2241 = ((_e2205.z * _e2227.x) - (_e2205.x * _e2227.z));
                                                                            let _e2248 = ((_e2205.x * _e2227.y) - (_e2205.y * _e2227.x));
                                                                            let _e2262 = (((1f / _e1371.z) * (((_e2234 * _e2183.x) + (_e2241 * _e2183.y)) + (_e2248 * _e2183.z))) / (((_e2234 * _e1374) + (_e2241 * _e1377)) + _e2248));
                                                                            if (_e2262 > _e180.tmin) {
                                                                                if (_e2262 < _e180.tmax) {
                                                                                    let _e2266 = triangles.member[(0u + _e1978)].v0_;
                                                                                    let _e2268 = triangles.member[(0u + _e1978)].v1_;
                                                                                    if (_e2266.x < _e2268.x) {
                                                                                        phi_2876_ = _e2266.x;
                                                                                    } else {
                                                                                        phi_2876_ = _e2268.x;
                                                                                    }
                                                                                    let _e2275 = phi_2876_;
                                                                                    if (_e2266.y < _e2268.y) {
                                                                                        phi_2885_ = _e2266.y;
                                                                                    } else {
                                                                                        phi_2885_ = _e2268.y;
                                                                                    }
                                                                                    let _e2282 = phi_2885_;
                                                                                    if (_e2266.z < _e2268.z) {
                                                                                        phi_2894_ = _e2266.z;
                                                                                    } else {
                                                                                        phi_2894_ = _e2268.z;
                                                                                    }
                                                                                    let _e2289 = phi_2894_;
                                                                                    let _e2291 = triangles.member[(0u + _e1978)].v2_;
                                                                                    if (_e2275 < _e2291.x) {
                                                                                        phi_2903_ = _e2275;
                                                                                    } else {
                                                                                        phi_2903_ = _e2291.x;
                                                                                    }
                                                                                    let _e2296 = phi_2903_;
                                                                                    if (_e2282 < _e2291.y) {
                                                                                        phi_2910_ = _e2282;
                                                                                    } else {
                                                                                        phi_2910_ = _e2291.y;
                                                                                    }
                                                                                    let _e2301 = phi_2910_;
                                                                                    if (_e2289 < _e2291.z) {
                                                                                        phi_2917_ = _e2289;
                                                                                    } else {
                                                                                        phi_2917_ = _e2291.z;
                                                                                    }
                                                                                    let _e2306 = phi_2917_;
                                                                                    let _e2308 = triangles.member[(0u + _e1978)].v0_;
                                                                                    let _e2310 = triangles.member[(0u + _e1978)].v1_;
                                                                                    if (_e2308.x > _e2310.x) {
                                                                                        phi_2930_ = _e2308.x;
                                                                                    } else {
                                                                                        phi_2930_ = _e2310.x;
                                                                                    }
                                                                                    let _e2317 = phi_2930_;
                                                                                    if (_e2308.y > _e2310.y) {
                                                                                        phi_2939_ = _e2308.y;
                                                                                    } else {
                                                                                        phi_2939_ = _e2310.y;
                                                                                    }
                                                                                    let _e2324 = phi_2939_;
                                                                                    if (_e2308.z > _e2310.z) {
                                                                                        phi_2948_ = _e2308.z;
                                                                                    } else {
                                                                                        phi_2948_ = _e2310.z;
                                                                                    }
                                                                                    let _e2331 = phi_2948_;
                                                                                    let _e2333 = triangles.member[(0u + _e1978)].v2_;
                                                                                    if (_e2317 > _e2333.x) {
                                                                                        phi_2957_ = _e2317;
                                                                                    } else {
                                                                                        phi_2957_ = _e2333.x;
                                                                                    }
                                                                                    let _e2338 = phi_2957_;
                                                                                    if (_e2324 > _e2333.y) {
                                                                                        phi_2964_ = _e2324;
                                                                                    } else {
                                                                                        phi_2964_ = _e2333.y;
                                                                                    }
                                                                                    let _e2343 = phi_2964_;
                                                                                    if (_e2331 > _e2333.z) {
                                                                                        phi_2971_ = _e2331;
                                                                                    } else {
                                                                                        phi_2971_ = _e2333.z;
                                                                                    }
                                                                                    let _e2348 = phi_2971_;
                                                                                    let _e2352 = ((_e2296 - _e1081) * _e1288);
                                                                                    let _e2353 = ((_e2301 - _e1094) * _e1298);
                                                                                    let _e2354 = ((_e2306 - _e1107) * _e1308);
                                                                                    let _e2358 = ((_e2338 - _e1081) * _e1288);
                                                                                    let _e2359 = ((_e2343 - _e1094) * _e1298);
                                                                                    let _e2360 = ((_e2348 - _e1107) * _e1308);
                                                                                    if (_e2352 < _e2358) {
                                                                                        phi_2988_ = _e2352;
                                                                                    } else {
                                                                                        phi_2988_ = _e2358;
                                                                                    }
                                                                                    let _e2363 = phi_2988_;
                                                                                    if (_e2353 < _e2359) {
                                                                                        phi_2993_ = _e2353;
                                                                                    } else {
                                                                                        phi_2993_ = _e2359;
                                                                                    }
                                                                                    let _e2366 = phi_2993_;
                                                                                    if (_e2354 < _e2360) {
                                                                                        phi_2998_ = _e2354;
                                                                                    } else {
                                                                                        phi_2998_ = _e2360;
                                                                                    }
                                                                                    let _e2369 = phi_2998_;
                                                                                    if (_e2352 > _e2358) {
                                                                                        phi_3006_ = _e2352;
                                                                                    } else {
                                                                                        phi_3006_ = _e2358;
                                                                                    }
                                                                                    let _e2375 = phi_3006_;
                                                                                    if (_e2353 > _e2359) {
                                                                                        phi_3011_ = _e2353;
                                                                                    } else {
                                                                                        phi_3011_ = _e2359;
                                                                                    }
                                                                                    let _e2378 = phi_3011_;
                                                                                    if (_e2354 > _e2360) {
                                                                                        phi_3016_ = _e2354;
                                                                                    } else {
                                                                                        phi_3016_ = _e2360;
                                                                                    }
                                                                                    let _e2381 = phi_3016_;
                                                                                    let _e2385 = core_intrinsics_maximum_number_nsz_f32_((_e2363 - _e1347), (_e2366 - _e1348));
                                                                                    let _e2386 = core_intrinsics_maximum_number_nsz_f32_(_e2385, (_e2369 - _e1349));
                                                                                    let _e2387 = core_intrinsics_minimum_number_nsz_f32_((_e2375 + _e1347), (_e2378 + _e1348));
                                                                                    let _e2388 = core_intrinsics_minimum_number_nsz_f32_(_e2387, (_e2381 + _e1349));
                                                                                    if (_e2386 > _e1056) {
                                                                                        phi_3028_ = _e2386;
                                                                                    } else {
                                                                                        phi_3028_ = _e1056;
                                                                                    }
                                                                                    let _e2391 = phi_3028_;
                                                                                    if (_e2388 < _e1058) {
                                                                                        phi_3033_ = _e2388;
                                                                                    } else {
                                                                                        phi_3033_ = _e1058;
                                                                                    }
                                                                                    let _e2394 = phi_3033_;
                                                                                    if (_e2262 < _e2391) {
                                                                                        phi_3038_ = _e2391;
                                                                                    } else {
                                                                                        phi_3038_ = _e2262;
                                                                                    }
                                                                                    let _e2397 = phi_3038_;
                                                                                    if (_e2397 > _e2394) {
                                                                                        phi_3043_ = _e2394;
                                                                                    } else {
                                                                                        phi_3043_ = _e2397;
                                                                                    }
                                                                                    let _e2400 = phi_3043_;
                                                                                    phi_3048_ = lt_bvh_triangle_Intersection(_e2400, (_e2103 / _e2162), (_e2124 / _e2162), (_e2391 <= _e2394));
                                                                                    phi_3049_ = false;
                                                                                } else {
                                                                                    phi_3048_ = lt_bvh_triangle_Intersection();
                                                                                    phi_3049_ = true;
                                                                                }
                                                                                let _e2406 = phi_3048_;
                                                                                let _e2408 = phi_3049_;
                                                                                phi_3050_ = _e2406;
                                                                                phi_3051_ = _e2408;
                                                                            } else {
                                                                                phi_3050_ = lt_bvh_triangle_Intersection();
                                                                                phi_3051_ = true;
                                                                            }
                                                                            let _e2410 = phi_3050_;
                                                                            let _e2412 = phi_3051_;
                                                                            if _e2412 {
                                                                            }
                                                                            phi_3055_ = _e2410;
                                                                            phi_3056_ = _e2412;
                                                                        }
                                                                        let _e2414 = phi_3055_;
                                                                        let _e2416 = phi_3056_;
                                                                        phi_3057_ = _e2414;
                                                                        phi_3058_ = _e2165;
                                                                        phi_3059_ = _e2416;
                                                                    } else {
                                                                        phi_3057_ = lt_bvh_triangle_Intersection();
                                                                        phi_3058_ = true;
                                                                        phi_3059_ = false;
                                                                    }
                                                                    let _e2418 = phi_3057_;
                                                                    let _e2420 = phi_3058_;
                                                                    let _e2422 = phi_3059_;
                                                                    if _e2420 {
                                                                        phi_3063_ = true;
                                                                    } else {
                                                                        phi_3063_ = _e2422;
                                                                    }
                                                                    let _e2424 = phi_3063_;
                                                                    if _e2424 {
                                                                        phi_3067_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_3067_ = _e2418;
                                                                    }
                                                                    let _e2426 = phi_3067_;
                                                                    if _e2426.is_hit {
                                                                        if (_e2426.t > _e180.tmin) {
                                                                            if (_e2426.t < _e1967.t) {
                                                                                phi_3115_ = true;
                                                                            } else {
                                                                                if (_e2426.t == _e1967.t) {
                                                                                    if (_e1967.triangle != 4294967295u) {
                                                                                        if (_e1978 < _e1967.triangle) {
                                                                                            phi_3106_ = true;
                                                                                        } else {
                                                                                            if (_e1978 == _e1967.triangle) {
                                                                                                phi_3105_ = (_e997 < _e1967.instance);
                                                                                            } else {
                                                                                                phi_3105_ = false;
                                                                                            }
                                                                                            let _e2444 = phi_3105_;
                                                                                            phi_3106_ = _e2444;
                                                                                        }
                                                                                        let _e2446 = phi_3106_;
                                                                                        phi_3107_ = _e2446;
                                                                                        phi_3108_ = false;
                                                                                    } else {
                                                                                        phi_3107_ = bool();
                                                                                        phi_3108_ = true;
                                                                                    }
                                                                                    let _e2448 = phi_3107_;
                                                                                    let _e2450 = phi_3108_;
                                                                                    phi_3109_ = _e2448;
                                                                                    phi_3110_ = _e2450;
                                                                                } else {
                                                                                    phi_3109_ = bool();
                                                                                    phi_3110_ = true;
                                                                                }
                                                                                let _e2452 = phi_3109_;
                                                                                let _e2454 = phi_3110_;
                                                                                if _e2454 {
                                                                                    phi_3114_ = false;
                                                                                } else {
                                                                                    phi_3114_ = _e2452;
                                                                                }
                                                                                let _e2456 = phi_3114_;
                                                                                phi_3115_ = _e2456;
                                                                            }
                                                                            let _e2458 = phi_3115_;
                                                                            if _e2458 {
                                                                                let _e2460 = triangles.member[(0u + _e1978)].i0_;
                                                                                if ((_e2460 & 2147483648u) == 0u) {
                                                                                    phi_3326_ = true;
                                                                                } else {
                                                                                    if (_e1978 < _e82) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2469 = triangles.member[(0u + _e1978)].i0_;
                                                                                    let _e2470 = (_e2469 & 2147483647u);
                                                                                    let _e2472 = triangles.member[(0u + _e1978)].i1_;
                                                                                    let _e2474 = triangles.member[(0u + _e1978)].i2_;
                                                                                    if (_e2470 < _e85) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2478 = vertices.member[(0u + _e2470)];
                                                                                    if (_e2472 < _e85) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2482 = vertices.member[(0u + _e2472)];
                                                                                    if (_e2474 < _e85) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2486 = vertices.member[(0u + _e2474)];
                                                                                    let _e2487 = array<abi_Vertex, 3>(_e2478, _e2482, _e2486);
                                                                                    if (_e2487[0].material < _e88) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2493 = materials.member[(0u + _e2487[0].material)];
                                                                                    if ((_e2493.flags & 0u) == 0u) {
                                                                                        let _e2498 = ((1f - _e2426.u) - _e2426.v);
                                                                                        if (_e2493.cutoff <= 0f) {
                                                                                            phi_3321_ = true;
                                                                                        } else {
                                                                                            let _e2525 = (_e2493.base_color.w * ((((f32((_e2487[0].color >> bitcast<u32>(24i))) * _e2498) + (f32((_e2487[1].color >> bitcast<u32>(24i))) * _e2426.u)) + (f32((_e2487[2].color >> bitcast<u32>(24i))) * _e2426.v)) * (1f / 255f)));
                                                                                            if (_e2493.alpha_size == 0u) {
                                                                                                phi_3318_ = _e2525;
                                                                                            } else {
                                                                                                local_1.offset = _e2493.alpha_offset;
                                                                                                local_1.size = _e2493.alpha_size;
                                                                                                local_1.flags = _e2493.flags;
                                                                                                let _e2556 = _lt_shaders_texture_TextureView_quad((&local_1), (((_e2487[0].u * _e2498) + (_e2487[1].u * _e2426.u)) + (_e2487[2].u * _e2426.v)), (((_e2487[0].v * _e2498) + (_e2487[1].v * _e2426.u)) + (_e2487[2].v * _e2426.v)));
                                                                                                let _e2560 = (_e2556.indices[0] >> bitcast<u32>(2i));
                                                                                                if (_e2560 < _e97) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2564 = alpha_texels.member[(0u + _e2560)];
                                                                                                let _e2580 = (_e2556.indices[1] >> bitcast<u32>(2i));
                                                                                                if (_e2580 < _e97) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2584 = alpha_texels.member[(0u + _e2580)];
                                                                                                let _e2601 = (_e2556.indices[2] >> bitcast<u32>(2i));
                                                                                                if (_e2601 < _e97) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2605 = alpha_texels.member[(0u + _e2601)];
                                                                                                let _e2622 = (_e2556.indices[3] >> bitcast<u32>(2i));
                                                                                                if (_e2622 < _e97) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2626 = alpha_texels.member[(0u + _e2622)];
                                                                                                phi_3318_ = (_e2525 * (((((f32(((_e2564 >> bitcast<u32>((((_e2556.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2556.weights.x) + ((f32(((_e2584 >> bitcast<u32>((((_e2556.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2556.weights.y)) + ((f32(((_e2605 >> bitcast<u32>((((_e2556.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2556.weights.z)) + ((f32(((_e2626 >> bitcast<u32>((((_e2556.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2556.weights.w)));
                                                                                            }
                                                                                            let _e2642 = phi_3318_;
                                                                                            phi_3321_ = (_e2642 >= _e2493.cutoff);
                                                                                        }
                                                                                        let _e2646 = phi_3321_;
                                                                                        phi_3322_ = _e2646;
                                                                                    } else {
                                                                                        phi_3322_ = false;
                                                                                    }
                                                                                    let _e2648 = phi_3322_;
                                                                                    if _e2648 {
                                                                                    }
                                                                                    phi_3326_ = _e2648;
                                                                                }
                                                                                let _e2650 = phi_3326_;
                                                                                if _e2650 {
                                                                                    phi_3334_ = lt_bvh_Hit(_e2426.t, _e2426.u, _e2426.v, _e1978, _e997);
                                                                                } else {
                                                                                    phi_3334_ = _e1967;
                                                                                }
                                                                                let _e2656 = phi_3334_;
                                                                                phi_3335_ = _e2656;
                                                                            } else {
                                                                                phi_3335_ = _e1967;
                                                                            }
                                                                            let _e2658 = phi_3335_;
                                                                            phi_3336_ = _e2658;
                                                                        } else {
                                                                            phi_3336_ = _e1967;
                                                                        }
                                                                        let _e2660 = phi_3336_;
                                                                        phi_3337_ = _e2660;
                                                                    } else {
                                                                        phi_3337_ = _e1967;
                                                                    }
                                                                    let _e2662 = phi_3337_;
                                                                    phi_2497_ = _e2662;
                                                                    phi_2500_ = (_e1969 & (_e1969 - 1u));
                                                                    phi_3338_ = true;
                                                                }
                                                                let _e2664 = phi_2497_;
                                                                let _e2666 = phi_2500_;
                                                                let _e2668 = phi_3338_;
                                                                continue;
                                                                continuing {
                                                                    phi_2496_ = _e2664;
                                                                    phi_2499_ = _e2666;
                                                                    break if !(_e2668);
                                                                }
                                                            }
                                                            let _e2671 = local_2.group_mask;
                                                            if ((_e2671 & 4278190080u) == 0u) {
                                                                let _e2675 = local_2.len;
                                                                if (_e2675 == 0u) {
                                                                    phi_3377_ = false;
                                                                } else {
                                                                    let _e2679 = local_2.len;
                                                                    local_2.len = (_e2679 - 1u);
                                                                    let _e2682 = local_2.len;
                                                                    if (_e2682 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2687 = local_2.first[(0u + _e2682)];
                                                                    local_2.group = _e2687;
                                                                    let _e2690 = local_2.len;
                                                                    if (_e2690 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2695 = local_2.mask[(0u + _e2690)];
                                                                    local_2.group_mask = _e2695;
                                                                    phi_3377_ = true;
                                                                }
                                                                let _e2698 = phi_3377_;
                                                                phi_3378_ = _e2698;
                                                            } else {
                                                                phi_3378_ = true;
                                                            }
                                                            let _e2700 = phi_3378_;
                                                            if _e2700 {
                                                                let _e2702 = local_2.group_mask;
                                                                let _e2708 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2702)), 32u, (_e2702 == 0u)));
                                                                let _e2712 = local_2.group_mask;
                                                                let _e2726 = local_2.group_mask;
                                                                local_2.group_mask = (_e2726 & ~((1u << bitcast<u32>((_e2708 & 31u)))));
                                                                let _e2729 = local_2.group;
                                                                phi_3409_ = (_e2729 + countOneBits(((_e2712 & ~((4294967295u << bitcast<u32>((((_e2708 - 24u) ^ _e1390) & 31u))))) & 255u)));
                                                            } else {
                                                                phi_3409_ = 4294967295u;
                                                            }
                                                            let _e2732 = phi_3409_;
                                                            let _e3861 = local_10;
                                                            phi_2164_ = _e3861;
                                                            phi_2167_ = _e2732;
                                                        } else {
                                                            phi_2164_ = lt_bvh_Hit();
                                                            phi_2167_ = u32();
                                                        }
                                                        let _e2734 = phi_2164_;
                                                        let _e2736 = phi_2167_;
                                                        continue;
                                                        continuing {
                                                            phi_2163_ = _e2734;
                                                            phi_2166_ = _e2736;
                                                            break if !(_e1531);
                                                        }
                                                    }
                                                    let _e3865 = local_11;
                                                    phi_3410_ = _e3865;
                                                }
                                                let _e2739 = phi_3410_;
                                                phi_3411_ = _e2739;
                                                phi_3412_ = _e1212;
                                            } else {
                                                phi_3411_ = lt_bvh_Hit();
                                                phi_3412_ = true;
                                            }
                                            let _e2741 = phi_3411_;
                                            let _e2743 = phi_3412_;
                                            if _e2743 {
                                                phi_3416_ = _e989;
                                            } else {
                                                phi_3416_ = _e2741;
                                            }
                                            let _e2745 = phi_3416_;
                                            phi_3417_ = _e2745;
                                        } else {
                                            phi_3417_ = _e989;
                                        }
                                        let _e2747 = phi_3417_;
                                        phi_3418_ = _e2747;
                                    } else {
                                        phi_3418_ = _e989;
                                    }
                                    let _e2749 = phi_3418_;
                                    phi_3419_ = _e2749;
                                } else {
                                    phi_3419_ = _e989;
                                }
                                let _e2751 = phi_3419_;
                                phi_1531_ = (_e987 & (_e987 - 1u));
                                phi_1534_ = _e2751;
                                phi_3420_ = true;
                            }
                            let _e2753 = phi_1531_;
                            let _e2755 = phi_1534_;
                            let _e2757 = phi_3420_;
                            continue;
                            continuing {
                                phi_1530_ = _e2753;
                                phi_1533_ = _e2755;
                                break if !(_e2757);
                            }
                        }
                        let _e2760 = local_3.group_mask;
                        if ((_e2760 & 4278190080u) == 0u) {
                            let _e2764 = local_3.len;
                            if (_e2764 == 0u) {
                                phi_3459_ = false;
                            } else {
                                let _e2768 = local_3.len;
                                local_3.len = (_e2768 - 1u);
                                let _e2771 = local_3.len;
                                if (_e2771 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2776 = local_3.first[(0u + _e2771)];
                                local_3.group = _e2776;
                                let _e2779 = local_3.len;
                                if (_e2779 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2784 = local_3.mask[(0u + _e2779)];
                                local_3.group_mask = _e2784;
                                phi_3459_ = true;
                            }
                            let _e2787 = phi_3459_;
                            phi_3460_ = _e2787;
                        } else {
                            phi_3460_ = true;
                        }
                        let _e2789 = phi_3460_;
                        if _e2789 {
                            let _e2791 = local_3.group_mask;
                            let _e2797 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2791)), 32u, (_e2791 == 0u)));
                            let _e2801 = local_3.group_mask;
                            let _e2815 = local_3.group_mask;
                            local_3.group_mask = (_e2815 & ~((1u << bitcast<u32>((_e2797 & 31u)))));
                            let _e2818 = local_3.group;
                            phi_3491_ = (_e2818 + countOneBits(((_e2801 & ~((4294967295u << bitcast<u32>((((_e2797 - 24u) ^ _e406) & 31u))))) & 255u)));
                        } else {
                            phi_3491_ = 4294967295u;
                        }
                        let _e2821 = phi_3491_;
                        phi_1194_ = _e2821;
                        let _e3881 = local_12;
                        phi_1197_ = _e3881;
                    } else {
                        phi_1194_ = u32();
                        phi_1197_ = lt_bvh_Hit();
                    }
                    let _e2823 = phi_1194_;
                    let _e2825 = phi_1197_;
                    continue;
                    continuing {
                        phi_1193_ = _e2823;
                        phi_1196_ = _e2825;
                        break if !(_e547);
                    }
                }
                let _e3884 = local_13;
                phi_3492_ = _e3884;
            }
            let _e2828 = phi_3492_;
            phi_3493_ = _e2828;
            phi_3494_ = _e244;
        } else {
            phi_3493_ = lt_bvh_Hit();
            phi_3494_ = true;
        }
        let _e2830 = phi_3493_;
        let _e2832 = phi_3494_;
        if _e2832 {
            phi_3498_ = _e182;
        } else {
            phi_3498_ = _e2830;
        }
        let _e2834 = phi_3498_;
        if (_e2834.triangle != 4294967295u) {
            let _e2840 = ((1f - _e2834.u) - _e2834.v);
            if (_e2834.triangle < _e82) {
            } else {
                return;
            }
            let _e2845 = triangles.member[(0u + _e2834.triangle)];
            if (_e2834.instance < _e94) {
            } else {
                return;
            }
            let _e2856 = instances.member[(0u + _e2834.instance)].object_to_world[0u];
            let _e2867 = ((((_e2856.x * _e2845.v0_.x) + (_e2856.y * _e2845.v0_.y)) + (_e2856.z * _e2845.v0_.z)) + (_e2856.w * 1f));
            let _e2869 = instances.member[(0u + _e2834.instance)].object_to_world[1u];
            let _e2880 = ((((_e2869.x * _e2845.v0_.x) + (_e2869.y * _e2845.v0_.y)) + (_e2869.z * _e2845.v0_.z)) + (_e2869.w * 1f));
            let _e2882 = instances.member[(0u + _e2834.instance)].object_to_world[2u];
            let _e2893 = ((((_e2882.x * _e2845.v0_.x) + (_e2882.y * _e2845.v0_.y)) + (_e2882.z * _e2845.v0_.z)) + (_e2882.w * 1f));
            let _e2900 = instances.member[(0u + _e2834.instance)].object_to_world[0u];
            let _e2911 = ((((_e2900.x * _e2845.v1_.x) + (_e2900.y * _e2845.v1_.y)) + (_e2900.z * _e2845.v1_.z)) + (_e2900.w * 1f));
            let _e2913 = instances.member[(0u + _e2834.instance)].object_to_world[1u];
            let _e2924 = ((((_e2913.x * _e2845.v1_.x) + (_e2913.y * _e2845.v1_.y)) + (_e2913.z * _e2845.v1_.z)) + (_e2913.w * 1f));
            let _e2926 = instances.member[(0u + _e2834.instance)].object_to_world[2u];
            let _e2937 = ((((_e2926.x * _e2845.v1_.x) + (_e2926.y * _e2845.v1_.y)) + (_e2926.z * _e2845.v1_.z)) + (_e2926.w * 1f));
            let _e2944 = instances.member[(0u + _e2834.instance)].object_to_world[0u];
            let _e2955 = ((((_e2944.x * _e2845.v2_.x) + (_e2944.y * _e2845.v2_.y)) + (_e2944.z * _e2845.v2_.z)) + (_e2944.w * 1f));
            let _e2957 = instances.member[(0u + _e2834.instance)].object_to_world[1u];
            let _e2968 = ((((_e2957.x * _e2845.v2_.x) + (_e2957.y * _e2845.v2_.y)) + (_e2957.z * _e2845.v2_.z)) + (_e2957.w * 1f));
            let _e2970 = instances.member[(0u + _e2834.instance)].object_to_world[2u];
            let _e2981 = ((((_e2970.x * _e2845.v2_.x) + (_e2970.y * _e2845.v2_.y)) + (_e2970.z * _e2845.v2_.z)) + (_e2970.w * 1f));
            let _e2994 = (((_e2867 * _e2840) + (_e2911 * _e2834.u)) + (_e2955 * _e2834.v));
            let _e2995 = (((_e2880 * _e2840) + (_e2924 * _e2834.u)) + (_e2968 * _e2834.v));
            let _e2996 = (((_e2893 * _e2840) + (_e2937 * _e2834.u)) + (_e2981 * _e2834.v));
            let _e2998 = abs(_e2867);
            let _e2999 = abs(_e2880);
            let _e3000 = abs(_e2893);
            let _e3001 = abs(_e2911);
            let _e3002 = abs(_e2924);
            let _e3003 = abs(_e2937);
            if (_e2998 > _e3001) {
                phi_3685_ = _e2998;
            } else {
                phi_3685_ = _e3001;
            }
            let _e3006 = phi_3685_;
            if (_e2999 > _e3002) {
                phi_3690_ = _e2999;
            } else {
                phi_3690_ = _e3002;
            }
            let _e3009 = phi_3690_;
            if (_e3000 > _e3003) {
                phi_3695_ = _e3000;
            } else {
                phi_3695_ = _e3003;
            }
            let _e3012 = phi_3695_;
            let _e3013 = abs(_e2955);
            let _e3014 = abs(_e2968);
            let _e3015 = abs(_e2981);
            if (_e3006 > _e3013) {
                phi_3703_ = _e3006;
            } else {
                phi_3703_ = _e3013;
            }
            let _e3018 = phi_3703_;
            if (_e3009 > _e3014) {
                phi_3708_ = _e3009;
            } else {
                phi_3708_ = _e3014;
            }
            let _e3021 = phi_3708_;
            if (_e3012 > _e3015) {
                phi_3713_ = _e3012;
            } else {
                phi_3713_ = _e3015;
            }
            let _e3024 = phi_3713_;
            let _e3025 = (_e2911 - _e2867);
            let _e3026 = (_e2924 - _e2880);
            let _e3027 = (_e2937 - _e2893);
            let _e3028 = (_e2955 - _e2867);
            let _e3029 = (_e2968 - _e2880);
            let _e3030 = (_e2981 - _e2893);
            let _e3034 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3026), abs(_e3027));
            let _e3035 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3025), _e3034);
            let _e3036 = (_e3025 / _e3035);
            let _e3037 = (_e3026 / _e3035);
            let _e3038 = (_e3027 / _e3035);
            let _e3042 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3029), abs(_e3030));
            let _e3043 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3028), _e3042);
            let _e3044 = (_e3028 / _e3043);
            let _e3045 = (_e3029 / _e3043);
            let _e3046 = (_e3030 / _e3043);
            let _e3049 = ((_e3037 * _e3046) - (_e3045 * _e3038));
            let _e3052 = ((_e3038 * _e3044) - (_e3046 * _e3036));
            let _e3055 = ((_e3036 * _e3045) - (_e3044 * _e3037));
            let _e3057 = p.member.eye;
            let _e3070 = (1f / sqrt((((_e3049 * _e3049) + (_e3052 * _e3052)) + (_e3055 * _e3055))));
            let _e3071 = (_e3049 * _e3070);
            let _e3072 = (_e3052 * _e3070);
            let _e3073 = (_e3055 * _e3070);
            if ((((_e3071 * (_e3057.x - _e2994)) + (_e3072 * (_e3057.y - _e2995))) + (_e3073 * (_e3057.z - _e2996))) < 0f) {
                phi_3777_ = vec3<f32>(-(_e3071), -(_e3072), -(_e3073));
            } else {
                phi_3777_ = vec3<f32>(_e3071, _e3072, _e3073);
            }
            let _e3086 = phi_3777_;
            if (_e2834.triangle < _e82) {
            } else {
                return;
            }
            let _e3091 = triangles.member[(0u + _e2834.triangle)];
            let _e3093 = (_e3091.i0_ & 2147483647u);
            if (_e3093 < _e85) {
            } else {
                return;
            }
            let _e3099 = vertices.member[(0u + _e3093)];
            if (_e3091.i1_ < _e85) {
            } else {
                return;
            }
            let _e3103 = vertices.member[(0u + _e3091.i1_)];
            if (_e3091.i2_ < _e85) {
            } else {
                return;
            }
            let _e3107 = vertices.member[(0u + _e3091.i2_)];
            let _e3108 = array<abi_Vertex, 3>(_e3099, _e3103, _e3107);
            if (_e3108[0].material < _e88) {
            } else {
                return;
            }
            let _e3114 = materials.member[(0u + _e3108[0].material)];
            let _e3131 = (1f / 255f);
            let _e3150 = (1f / 255f);
            let _e3172 = (1f / 255f);
            if (_e3114.color_size == 0u) {
                phi_4020_ = vec3<f32>(1f, 1f, 1f);
            } else {
                local.offset = _e3114.color_offset;
                local.size = _e3114.color_size;
                local.flags = _e3114.flags;
                let _e3215 = _lt_shaders_texture_TextureView_quad((&local), (((_e3108[0].u * _e2840) + (_e3108[1].u * _e2834.u)) + (_e3108[2].u * _e2834.v)), (((_e3108[0].v * _e2840) + (_e3108[1].v * _e2834.u)) + (_e3108[2].v * _e2834.v)));
                if (_e3215.indices[0] < _e100) {
                } else {
                    return;
                }
                let _e3221 = color_texels.member[(0u + _e3215.indices[0])];
                let _e3232 = (1f / 255f);
                if (_e3215.indices[1] < _e100) {
                } else {
                    return;
                }
                let _e3246 = color_texels.member[(0u + _e3215.indices[1])];
                let _e3257 = (1f / 255f);
                if (_e3215.indices[2] < _e100) {
                } else {
                    return;
                }
                let _e3274 = color_texels.member[(0u + _e3215.indices[2])];
                let _e3285 = (1f / 255f);
                if (_e3215.indices[3] < _e100) {
                } else {
                    return;
                }
                let _e3302 = color_texels.member[(0u + _e3215.indices[3])];
                let _e3313 = (1f / 255f);
                let _e3322 = (((((f32((_e3221 & 255u)) * _e3232) * _e3215.weights.x) + ((f32((_e3246 & 255u)) * _e3257) * _e3215.weights.y)) + ((f32((_e3274 & 255u)) * _e3285) * _e3215.weights.z)) + ((f32((_e3302 & 255u)) * _e3313) * _e3215.weights.w));
                let _e3323 = (((((f32(((_e3221 >> bitcast<u32>(8i)) & 255u)) * _e3232) * _e3215.weights.x) + ((f32(((_e3246 >> bitcast<u32>(8i)) & 255u)) * _e3257) * _e3215.weights.y)) + ((f32(((_e3274 >> bitcast<u32>(8i)) & 255u)) * _e3285) * _e3215.weights.z)) + ((f32(((_e3302 >> bitcast<u32>(8i)) & 255u)) * _e3313) * _e3215.weights.w));
                let _e3324 = (((((f32(((_e3221 >> bitcast<u32>(16i)) & 255u)) * _e3232) * _e3215.weights.x) + ((f32(((_e3246 >> bitcast<u32>(16i)) & 255u)) * _e3257) * _e3215.weights.y)) + ((f32(((_e3274 >> bitcast<u32>(16i)) & 255u)) * _e3285) * _e3215.weights.z)) + ((f32(((_e3302 >> bitcast<u32>(16i)) & 255u)) * _e3313) * _e3215.weights.w));
                phi_4020_ = vec3<f32>((_e3322 * _e3322), (_e3323 * _e3323), (_e3324 * _e3324));
            }
            let _e3330 = phi_4020_;
            let _e3332 = ((_e3114.base_color.x * ((((f32((_e3108[0].color & 255u)) * _e3131) * _e2840) + ((f32((_e3108[1].color & 255u)) * _e3150) * _e2834.u)) + ((f32((_e3108[2].color & 255u)) * _e3172) * _e2834.v))) * _e3330.x);
            let _e3334 = ((_e3114.base_color.y * ((((f32(((_e3108[0].color >> bitcast<u32>(8i)) & 255u)) * _e3131) * _e2840) + ((f32(((_e3108[1].color >> bitcast<u32>(8i)) & 255u)) * _e3150) * _e2834.u)) + ((f32(((_e3108[2].color >> bitcast<u32>(8i)) & 255u)) * _e3172) * _e2834.v))) * _e3330.y);
            let _e3336 = ((_e3114.base_color.z * ((((f32(((_e3108[0].color >> bitcast<u32>(16i)) & 255u)) * _e3131) * _e2840) + ((f32(((_e3108[1].color >> bitcast<u32>(16i)) & 255u)) * _e3150) * _e2834.u)) + ((f32(((_e3108[2].color >> bitcast<u32>(16i)) & 255u)) * _e3172) * _e2834.v))) * _e3330.z);
            let _e3337 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e3021, _e3024);
            let _e3338 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e3018, _e3337);
            if ((_e3114.flags & 2u) == 0u) {
                phi_4035_ = 0u;
            } else {
                phi_4035_ = 1u;
            }
            let _e3343 = phi_4035_;
            if (_e3108[0].normal == 2147516416u) {
                phi_4265_ = _e3086;
            } else {
                let _e3356 = (f32((bitcast<i32>((_e3108[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3362 = (f32((bitcast<i32>(_e3108[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3366 = ((1f - abs(_e3356)) - abs(_e3362));
                if (_e3366 < 0f) {
                    phi_4062_ = -(_e3366);
                } else {
                    phi_4062_ = 0f;
                }
                let _e3370 = phi_4062_;
                if (_e3356 < 0f) {
                    phi_4069_ = (_e3356 + _e3370);
                } else {
                    phi_4069_ = (_e3356 - _e3370);
                }
                let _e3375 = phi_4069_;
                if (_e3362 < 0f) {
                    phi_4076_ = (_e3362 + _e3370);
                } else {
                    phi_4076_ = (_e3362 - _e3370);
                }
                let _e3380 = phi_4076_;
                let _e3387 = (1f / sqrt((((_e3375 * _e3375) + (_e3380 * _e3380)) + (_e3366 * _e3366))));
                let _e3403 = (f32((bitcast<i32>((_e3108[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3409 = (f32((bitcast<i32>(_e3108[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3413 = ((1f - abs(_e3403)) - abs(_e3409));
                if (_e3413 < 0f) {
                    phi_4111_ = -(_e3413);
                } else {
                    phi_4111_ = 0f;
                }
                let _e3417 = phi_4111_;
                if (_e3403 < 0f) {
                    phi_4118_ = (_e3403 + _e3417);
                } else {
                    phi_4118_ = (_e3403 - _e3417);
                }
                let _e3422 = phi_4118_;
                if (_e3409 < 0f) {
                    phi_4125_ = (_e3409 + _e3417);
                } else {
                    phi_4125_ = (_e3409 - _e3417);
                }
                let _e3427 = phi_4125_;
                let _e3434 = (1f / sqrt((((_e3422 * _e3422) + (_e3427 * _e3427)) + (_e3413 * _e3413))));
                let _e3453 = (f32((bitcast<i32>((_e3108[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3459 = (f32((bitcast<i32>(_e3108[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3463 = ((1f - abs(_e3453)) - abs(_e3459));
                if (_e3463 < 0f) {
                    phi_4163_ = -(_e3463);
                } else {
                    phi_4163_ = 0f;
                }
                let _e3467 = phi_4163_;
                if (_e3453 < 0f) {
                    phi_4170_ = (_e3453 + _e3467);
                } else {
                    phi_4170_ = (_e3453 - _e3467);
                }
                let _e3472 = phi_4170_;
                if (_e3459 < 0f) {
                    phi_4177_ = (_e3459 + _e3467);
                } else {
                    phi_4177_ = (_e3459 - _e3467);
                }
                let _e3477 = phi_4177_;
                let _e3484 = (1f / sqrt((((_e3472 * _e3472) + (_e3477 * _e3477)) + (_e3463 * _e3463))));
                let _e3491 = ((((_e3375 * _e3387) * _e2840) + ((_e3422 * _e3434) * _e2834.u)) + ((_e3472 * _e3484) * _e2834.v));
                let _e3492 = ((((_e3380 * _e3387) * _e2840) + ((_e3427 * _e3434) * _e2834.u)) + ((_e3477 * _e3484) * _e2834.v));
                let _e3493 = ((((_e3366 * _e3387) * _e2840) + ((_e3413 * _e3434) * _e2834.u)) + ((_e3463 * _e3484) * _e2834.v));
                if (_e2834.instance < _e94) {
                } else {
                    return;
                }
                let _e3500 = instances.member[(0u + _e2834.instance)].world_to_object[0u];
                let _e3509 = instances.member[(0u + _e2834.instance)].world_to_object[1u];
                let _e3521 = instances.member[(0u + _e2834.instance)].world_to_object[2u];
                let _e3528 = (((_e3500.x * _e3491) + (_e3509.x * _e3492)) + (_e3521.x * _e3493));
                let _e3529 = (((_e3500.y * _e3491) + (_e3509.y * _e3492)) + (_e3521.y * _e3493));
                let _e3530 = (((_e3500.z * _e3491) + (_e3509.z * _e3492)) + (_e3521.z * _e3493));
                let _e3536 = sqrt((((_e3528 * _e3528) + (_e3529 * _e3529)) + (_e3530 * _e3530)));
                if (_e3536 > 0f) {
                    let _e3538 = (_e3528 / _e3536);
                    let _e3539 = (_e3529 / _e3536);
                    let _e3540 = (_e3530 / _e3536);
                    if ((((_e3538 * _e3086.x) + (_e3539 * _e3086.y)) + (_e3540 * _e3086.z)) < 0f) {
                        phi_4263_ = vec3<f32>(-(_e3538), -(_e3539), -(_e3540));
                    } else {
                        phi_4263_ = vec3<f32>(_e3538, _e3539, _e3540);
                    }
                    let _e3556 = phi_4263_;
                    phi_4264_ = _e3556;
                } else {
                    phi_4264_ = _e3086;
                }
                let _e3558 = phi_4264_;
                phi_4265_ = _e3558;
            }
            let _e3560 = phi_4265_;
            if (_e3332 > 0f) {
                if (_e3332 < 1f) {
                    phi_4274_ = _e3332;
                } else {
                    phi_4274_ = 1f;
                }
                let _e3564 = phi_4274_;
                phi_4275_ = _e3564;
            } else {
                phi_4275_ = 0f;
            }
            let _e3566 = phi_4275_;
            if (_e3334 > 0f) {
                if (_e3334 < 1f) {
                    phi_4285_ = _e3334;
                } else {
                    phi_4285_ = 1f;
                }
                let _e3571 = phi_4285_;
                phi_4286_ = _e3571;
            } else {
                phi_4286_ = 0f;
            }
            let _e3573 = phi_4286_;
            if (_e3336 > 0f) {
                if (_e3336 < 1f) {
                    phi_4296_ = _e3336;
                } else {
                    phi_4296_ = 1f;
                }
                let _e3578 = phi_4296_;
                phi_4297_ = _e3578;
            } else {
                phi_4297_ = 0f;
            }
            let _e3580 = phi_4297_;
            let _e3583 = ((sqrt(_e3566) * 255f) + 0.5f);
            let _e3592 = ((sqrt(_e3573) * 255f) + 0.5f);
            let _e3604 = ((sqrt(_e3580) * 255f) + 0.5f);
            phi_4332_ = abi_Sample(vec3<f32>(_e2994, _e2995, _e2996), _e3338, _e3086, _e3343, _e3560, ((select(select(u32(_e3583), 0u, (_e3583 < bitcast<f32>(0u))), 4294967295u, (_e3583 > bitcast<f32>(1333788671u))) | (select(select(u32(_e3592), 0u, (_e3592 < bitcast<f32>(0u))), 4294967295u, (_e3592 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e3604), 0u, (_e3604 < bitcast<f32>(0u))), 4294967295u, (_e3604 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_4332_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e3618 = phi_4332_;
        if (_e106.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e106.first_primitive)] = _e3618;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_instanced_alpha_color_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
