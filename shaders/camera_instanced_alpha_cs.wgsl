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

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_227_: lt_bvh_traverse_Tree;
    var phi_228_: bool;
    var phi_229_: lt_bvh_traverse_Tree;
    var phi_230_: bool;
    var phi_235_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_227_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_228_ = false;
        } else {
            phi_227_ = lt_bvh_traverse_Tree();
            phi_228_ = true;
        }
        let _e83 = phi_227_;
        let _e85 = phi_228_;
        phi_229_ = _e83;
        phi_230_ = _e85;
    } else {
        phi_229_ = lt_bvh_traverse_Tree();
        phi_230_ = true;
    }
    let _e87 = phi_229_;
    let _e89 = phi_230_;
    if _e89 {
        phi_235_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_235_ = _e87;
    }
    let _e94 = phi_235_;
    return lt_bvh_traverse_Tree(_e94.root, _e94.first_primitive);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_250_: bool;
    var phi_254_: f32;

    if (param_3 != param_3) {
        phi_250_ = true;
    } else {
        let _e73 = (param_4 >= param_3);
        if _e73 {
        }
        phi_250_ = _e73;
    }
    let _e75 = phi_250_;
    if _e75 {
        phi_254_ = param_4;
    } else {
        phi_254_ = param_3;
    }
    let _e77 = phi_254_;
    return _e77;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_266_: bool;
    var phi_270_: f32;

    if (param_5 != param_5) {
        phi_266_ = true;
    } else {
        let _e73 = (param_6 <= param_5);
        if _e73 {
        }
        phi_266_ = _e73;
    }
    let _e75 = phi_266_;
    if _e75 {
        phi_270_ = param_6;
    } else {
        phi_270_ = param_5;
    }
    let _e77 = phi_270_;
    return _e77;
}

fn _lt_shaders_texture_TextureView_quad(param_7: ptr<function, texture_TextureView>, param_8: f32, param_9: f32) -> texture_TexelQuad {
    var phi_312_: f32;
    var phi_317_: f32;
    var phi_318_: bool;
    var phi_319_: f32;
    var phi_320_: bool;
    var phi_324_: f32;
    var phi_350_: f32;
    var phi_355_: f32;
    var phi_356_: bool;
    var phi_357_: f32;
    var phi_358_: bool;
    var phi_362_: f32;
    var phi_370_: f32;
    var phi_371_: f32;
    var phi_372_: f32;
    var phi_381_: f32;
    var phi_382_: f32;
    var phi_400_: u32;
    var phi_414_: u32;
    var phi_421_: u32;
    var phi_426_: u32;
    var phi_432_: u32;
    var phi_437_: u32;
    var phi_439_: texture_Axis;
    var phi_467_: f32;
    var phi_472_: f32;
    var phi_473_: bool;
    var phi_474_: f32;
    var phi_475_: bool;
    var phi_479_: f32;
    var phi_505_: f32;
    var phi_510_: f32;
    var phi_511_: bool;
    var phi_512_: f32;
    var phi_513_: bool;
    var phi_517_: f32;
    var phi_525_: f32;
    var phi_526_: f32;
    var phi_527_: f32;
    var phi_536_: f32;
    var phi_537_: f32;
    var phi_555_: u32;
    var phi_569_: u32;
    var phi_576_: u32;
    var phi_581_: u32;
    var phi_587_: u32;
    var phi_592_: u32;
    var phi_594_: texture_Axis;

    let _e74 = (*param_7).size;
    let _e75 = (_e74 & 65535u);
    let _e77 = (*param_7).size;
    let _e79 = (_e77 >> bitcast<u32>(16i));
    let _e81 = (*param_7).flags;
    let _e83 = ((_e81 & 4u) != 0u);
    let _e85 = (*param_7).flags;
    let _e88 = ((_e85 >> bitcast<u32>(4u)) & 3u);
    if (_e88 == 0u) {
        if (param_8 > -8388608f) {
            let _e101 = f32(select(0i, select(select(i32(param_8), i32(-2147483648), (param_8 < bitcast<f32>(3472883712u))), 2147483647i, (param_8 > bitcast<f32>(1325400063u))), (param_8 == param_8)));
            if (_e101 > param_8) {
                phi_312_ = 1f;
            } else {
                phi_312_ = 0f;
            }
            let _e104 = phi_312_;
            if (param_8 < 8388608f) {
                phi_317_ = (_e101 - _e104);
                phi_318_ = false;
            } else {
                phi_317_ = f32();
                phi_318_ = true;
            }
            let _e107 = phi_317_;
            let _e109 = phi_318_;
            phi_319_ = _e107;
            phi_320_ = _e109;
        } else {
            phi_319_ = f32();
            phi_320_ = true;
        }
        let _e111 = phi_319_;
        let _e113 = phi_320_;
        if _e113 {
            phi_324_ = param_8;
        } else {
            phi_324_ = _e111;
        }
        let _e115 = phi_324_;
        phi_372_ = (param_8 - _e115);
    } else {
        if (_e88 == 1u) {
            let _e118 = (param_8 * 0.5f);
            if (_e118 > -8388608f) {
                let _e130 = f32(select(0i, select(select(i32(_e118), i32(-2147483648), (_e118 < bitcast<f32>(3472883712u))), 2147483647i, (_e118 > bitcast<f32>(1325400063u))), (_e118 == _e118)));
                if (_e130 > _e118) {
                    phi_350_ = 1f;
                } else {
                    phi_350_ = 0f;
                }
                let _e133 = phi_350_;
                if (_e118 < 8388608f) {
                    phi_355_ = (_e130 - _e133);
                    phi_356_ = false;
                } else {
                    phi_355_ = f32();
                    phi_356_ = true;
                }
                let _e136 = phi_355_;
                let _e138 = phi_356_;
                phi_357_ = _e136;
                phi_358_ = _e138;
            } else {
                phi_357_ = f32();
                phi_358_ = true;
            }
            let _e140 = phi_357_;
            let _e142 = phi_358_;
            if _e142 {
                phi_362_ = _e118;
            } else {
                phi_362_ = _e140;
            }
            let _e144 = phi_362_;
            let _e146 = (param_8 - (2f * _e144));
            if (_e146 > 1f) {
                phi_370_ = (2f - _e146);
            } else {
                phi_370_ = _e146;
            }
            let _e150 = phi_370_;
            phi_371_ = _e150;
        } else {
            phi_371_ = param_8;
        }
        let _e152 = phi_371_;
        phi_372_ = _e152;
    }
    let _e154 = phi_372_;
    if (_e154 > 0f) {
        if (_e154 < 1f) {
            phi_381_ = _e154;
        } else {
            phi_381_ = 1f;
        }
        let _e158 = phi_381_;
        phi_382_ = _e158;
    } else {
        phi_382_ = 0f;
    }
    let _e160 = phi_382_;
    let _e161 = (_e75 - 1u);
    let _e163 = (_e160 * f32(_e75));
    if _e83 {
        let _e170 = select(select(u32(_e163), 0u, (_e163 < bitcast<f32>(0u))), 4294967295u, (_e163 > bitcast<f32>(1333788671u)));
        if (_e161 < _e170) {
            phi_400_ = _e161;
        } else {
            phi_400_ = _e170;
        }
        let _e173 = phi_400_;
        phi_439_ = texture_Axis(_e173, _e173, 0f);
    } else {
        let _e175 = (_e163 + 0.5f);
        let _e182 = select(select(u32(_e175), 0u, (_e175 < bitcast<f32>(0u))), 4294967295u, (_e175 > bitcast<f32>(1333788671u)));
        if (_e75 < _e182) {
            phi_414_ = _e75;
        } else {
            phi_414_ = _e182;
        }
        let _e185 = phi_414_;
        if (_e88 == 0u) {
            phi_421_ = _e161;
        } else {
            phi_421_ = 0u;
        }
        let _e190 = phi_421_;
        if (_e88 == 0u) {
            phi_426_ = 0u;
        } else {
            phi_426_ = _e161;
        }
        let _e193 = phi_426_;
        if (_e185 == 0u) {
            phi_432_ = _e190;
        } else {
            phi_432_ = (_e185 - 1u);
        }
        let _e197 = phi_432_;
        if (_e185 > _e161) {
            phi_437_ = _e193;
        } else {
            phi_437_ = _e185;
        }
        let _e200 = phi_437_;
        phi_439_ = texture_Axis(_e197, _e200, (_e175 - f32(_e185)));
    }
    let _e203 = phi_439_;
    let _e205 = (*param_7).flags;
    let _e208 = ((_e205 >> bitcast<u32>(6u)) & 3u);
    if (_e208 == 0u) {
        if (param_9 > -8388608f) {
            let _e221 = f32(select(0i, select(select(i32(param_9), i32(-2147483648), (param_9 < bitcast<f32>(3472883712u))), 2147483647i, (param_9 > bitcast<f32>(1325400063u))), (param_9 == param_9)));
            if (_e221 > param_9) {
                phi_467_ = 1f;
            } else {
                phi_467_ = 0f;
            }
            let _e224 = phi_467_;
            if (param_9 < 8388608f) {
                phi_472_ = (_e221 - _e224);
                phi_473_ = false;
            } else {
                phi_472_ = f32();
                phi_473_ = true;
            }
            let _e227 = phi_472_;
            let _e229 = phi_473_;
            phi_474_ = _e227;
            phi_475_ = _e229;
        } else {
            phi_474_ = f32();
            phi_475_ = true;
        }
        let _e231 = phi_474_;
        let _e233 = phi_475_;
        if _e233 {
            phi_479_ = param_9;
        } else {
            phi_479_ = _e231;
        }
        let _e235 = phi_479_;
        phi_527_ = (param_9 - _e235);
    } else {
        if (_e208 == 1u) {
            let _e238 = (param_9 * 0.5f);
            if (_e238 > -8388608f) {
                let _e250 = f32(select(0i, select(select(i32(_e238), i32(-2147483648), (_e238 < bitcast<f32>(3472883712u))), 2147483647i, (_e238 > bitcast<f32>(1325400063u))), (_e238 == _e238)));
                if (_e250 > _e238) {
                    phi_505_ = 1f;
                } else {
                    phi_505_ = 0f;
                }
                let _e253 = phi_505_;
                if (_e238 < 8388608f) {
                    phi_510_ = (_e250 - _e253);
                    phi_511_ = false;
                } else {
                    phi_510_ = f32();
                    phi_511_ = true;
                }
                let _e256 = phi_510_;
                let _e258 = phi_511_;
                phi_512_ = _e256;
                phi_513_ = _e258;
            } else {
                phi_512_ = f32();
                phi_513_ = true;
            }
            let _e260 = phi_512_;
            let _e262 = phi_513_;
            if _e262 {
                phi_517_ = _e238;
            } else {
                phi_517_ = _e260;
            }
            let _e264 = phi_517_;
            let _e266 = (param_9 - (2f * _e264));
            if (_e266 > 1f) {
                phi_525_ = (2f - _e266);
            } else {
                phi_525_ = _e266;
            }
            let _e270 = phi_525_;
            phi_526_ = _e270;
        } else {
            phi_526_ = param_9;
        }
        let _e272 = phi_526_;
        phi_527_ = _e272;
    }
    let _e274 = phi_527_;
    if (_e274 > 0f) {
        if (_e274 < 1f) {
            phi_536_ = _e274;
        } else {
            phi_536_ = 1f;
        }
        let _e278 = phi_536_;
        phi_537_ = _e278;
    } else {
        phi_537_ = 0f;
    }
    let _e280 = phi_537_;
    let _e281 = (_e79 - 1u);
    let _e283 = (_e280 * f32(_e79));
    if _e83 {
        let _e290 = select(select(u32(_e283), 0u, (_e283 < bitcast<f32>(0u))), 4294967295u, (_e283 > bitcast<f32>(1333788671u)));
        if (_e281 < _e290) {
            phi_555_ = _e281;
        } else {
            phi_555_ = _e290;
        }
        let _e293 = phi_555_;
        phi_594_ = texture_Axis(_e293, _e293, 0f);
    } else {
        let _e295 = (_e283 + 0.5f);
        let _e302 = select(select(u32(_e295), 0u, (_e295 < bitcast<f32>(0u))), 4294967295u, (_e295 > bitcast<f32>(1333788671u)));
        if (_e79 < _e302) {
            phi_569_ = _e79;
        } else {
            phi_569_ = _e302;
        }
        let _e305 = phi_569_;
        if (_e208 == 0u) {
            phi_576_ = _e281;
        } else {
            phi_576_ = 0u;
        }
        let _e310 = phi_576_;
        if (_e208 == 0u) {
            phi_581_ = 0u;
        } else {
            phi_581_ = _e281;
        }
        let _e313 = phi_581_;
        if (_e305 == 0u) {
            phi_587_ = _e310;
        } else {
            phi_587_ = (_e305 - 1u);
        }
        let _e317 = phi_587_;
        if (_e305 > _e281) {
            phi_592_ = _e313;
        } else {
            phi_592_ = _e305;
        }
        let _e320 = phi_592_;
        phi_594_ = texture_Axis(_e317, _e320, (_e295 - f32(_e305)));
    }
    let _e323 = phi_594_;
    let _e327 = (*param_7).offset;
    let _e334 = (*param_7).offset;
    let _e341 = (*param_7).offset;
    let _e348 = (*param_7).offset;
    return texture_TexelQuad(array<u32, 4>(((_e327 + (_e323.low * _e75)) + _e203.low), ((_e334 + (_e323.low * _e75)) + _e203.high), ((_e341 + (_e323.high * _e75)) + _e203.low), ((_e348 + (_e323.high * _e75)) + _e203.high)), vec4<f32>(((1f - _e203.fraction) * (1f - _e323.fraction)), (_e203.fraction * (1f - _e323.fraction)), ((1f - _e203.fraction) * _e323.fraction), (_e203.fraction * _e323.fraction)));
}

fn _lt_bvh_ray_Ray_new(param_10: vec3<f32>, param_11: vec3<f32>) -> lt_bvh_Ray {
    return lt_bvh_Ray(param_10, 0f, param_11, 300000000000000000000000000000000000000f);
}

fn _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(param_12: f32, param_13: f32) -> f32 {
    var phi_653_: f32;

    if (param_12 > param_13) {
        phi_653_ = param_12;
    } else {
        phi_653_ = param_13;
    }
    let _e74 = phi_653_;
    return _e74;
}

fn _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(param_14: vec3<f32>) -> vec3<f32> {
    return vec3<f32>(1f, 1f, 1f);
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var local_2: lt_bvh_traverse_Stack;
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
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
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
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
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
    var phi_3686_: f32;
    var phi_3691_: f32;
    var phi_3696_: f32;
    var phi_3704_: f32;
    var phi_3709_: f32;
    var phi_3714_: f32;
    var phi_3778_: vec3<f32>;
    var phi_3899_: u32;
    var phi_3926_: f32;
    var phi_3933_: f32;
    var phi_3940_: f32;
    var phi_3975_: f32;
    var phi_3982_: f32;
    var phi_3989_: f32;
    var phi_4027_: f32;
    var phi_4034_: f32;
    var phi_4041_: f32;
    var phi_4127_: vec3<f32>;
    var phi_4128_: vec3<f32>;
    var phi_4129_: vec3<f32>;
    var phi_4138_: f32;
    var phi_4139_: f32;
    var phi_4149_: f32;
    var phi_4150_: f32;
    var phi_4160_: f32;
    var phi_4161_: f32;
    var phi_4196_: abi_Sample;
    var local_9: lt_bvh_Hit;
    var local_10: lt_bvh_Hit;
    var local_11: lt_bvh_Hit;
    var local_12: lt_bvh_Hit;

    let _e73 = id_1;
    let _e77 = arrayLength((&nodes.member));
    let _e80 = arrayLength((&triangles.member));
    let _e83 = arrayLength((&vertices.member));
    let _e86 = arrayLength((&materials.member));
    let _e92 = arrayLength((&instances.member));
    let _e95 = arrayLength((&alpha_texels.member));
    let _e98 = p.member.size[0u];
    let _e100 = p.member.size[1u];
    let _e101 = lt_shaders_entry_pixel_index(_e73, _e98, _e100);
    if (bitcast<i32>(_e101.root) != 0i) {
        let _e107 = p.member.root;
        let _e111 = p.member.eye;
        let _e114 = p.member.grid[0u];
        let _e116 = p.member.grid[1u];
        let _e135 = p.member.size[0u];
        let _e139 = ((((f32(_e73.x) + ((f32((_e73.y & (_e116 - 1u))) + 0.5f) / f32(_e116))) / f32(_e135)) * 2f) - 1f);
        let _e142 = p.member.size[1u];
        let _e146 = (1f - (((f32(_e73.y) + ((f32((_e73.x & (_e114 - 1u))) + 0.5f) / f32(_e114))) / f32(_e142)) * 2f));
        let _e148 = p.member.forward;
        let _e150 = p.member.right;
        let _e164 = p.member.up;
        let _e175 = _lt_bvh_ray_Ray_new(_e111, vec3<f32>(((_e148.x + (_e150.x * _e139)) + (_e164.x * _e146)), ((_e148.y + (_e150.y * _e139)) + (_e164.y * _e146)), ((_e148.z + (_e150.z * _e139)) + (_e164.z * _e146))));
        let _e177 = lt_bvh_Hit(_e175.tmax, 0f, 0f, 4294967295u, 4294967295u);
        let _e180 = abs(_e175.direction.x);
        let _e182 = abs(_e175.direction.y);
        let _e184 = abs(_e175.direction.z);
        if (abs(_e175.origin.x) < 1000000000000000f) {
            if (abs(_e175.origin.y) < 1000000000000000f) {
                phi_806_ = (abs(_e175.origin.z) < 1000000000000000f);
                phi_807_ = false;
            } else {
                phi_806_ = bool();
                phi_807_ = true;
            }
            let _e196 = phi_806_;
            let _e198 = phi_807_;
            phi_808_ = _e196;
            phi_809_ = _e198;
        } else {
            phi_808_ = bool();
            phi_809_ = true;
        }
        let _e200 = phi_808_;
        let _e202 = phi_809_;
        if _e202 {
            phi_813_ = false;
        } else {
            phi_813_ = _e200;
        }
        let _e204 = phi_813_;
        if _e204 {
            if (_e180 < 1000000000000000f) {
                if (_e182 < 1000000000000000f) {
                    phi_826_ = (_e184 < 1000000000000000f);
                    phi_827_ = false;
                } else {
                    phi_826_ = bool();
                    phi_827_ = true;
                }
                let _e209 = phi_826_;
                let _e211 = phi_827_;
                phi_828_ = _e209;
                phi_829_ = _e211;
            } else {
                phi_828_ = bool();
                phi_829_ = true;
            }
            let _e213 = phi_828_;
            let _e215 = phi_829_;
            if _e215 {
                phi_833_ = false;
            } else {
                phi_833_ = _e213;
            }
            let _e217 = phi_833_;
            if _e217 {
                if (_e180 > 0f) {
                    phi_847_ = bool();
                    phi_848_ = true;
                } else {
                    let _e219 = (_e182 > 0f);
                    if _e219 {
                        phi_846_ = bool();
                    } else {
                        phi_846_ = (_e184 > 0f);
                    }
                    let _e222 = phi_846_;
                    phi_847_ = _e222;
                    phi_848_ = _e219;
                }
                let _e224 = phi_847_;
                let _e226 = phi_848_;
                if _e226 {
                    phi_852_ = true;
                } else {
                    phi_852_ = _e224;
                }
                let _e228 = phi_852_;
                phi_853_ = _e228;
                phi_854_ = false;
            } else {
                phi_853_ = bool();
                phi_854_ = true;
            }
            let _e230 = phi_853_;
            let _e232 = phi_854_;
            phi_855_ = _e230;
            phi_856_ = _e232;
        } else {
            phi_855_ = bool();
            phi_856_ = true;
        }
        let _e234 = phi_855_;
        let _e236 = phi_856_;
        if _e236 {
            phi_860_ = false;
        } else {
            phi_860_ = _e234;
        }
        let _e238 = phi_860_;
        if _e238 {
            let _e239 = (_e107 >= _e77);
            if _e239 {
                phi_3492_ = lt_bvh_Hit();
            } else {
                if (_e107 < _e77) {
                } else {
                    return;
                }
                let _e245 = nodes.member[(0u + _e107)].frame[0u];
                let _e249 = nodes.member[(0u + _e107)].frame[1u];
                let _e253 = nodes.member[(0u + _e107)].frame[2u];
                let _e257 = nodes.member[(0u + _e107)].frame[0u];
                let _e261 = nodes.member[(0u + _e107)].frame[1u];
                let _e265 = nodes.member[(0u + _e107)].frame[2u];
                let _e269 = nodes.member[(0u + _e107)].frame[3u];
                let _e308 = core_intrinsics_maximum_number_nsz_f32_(abs(_e175.direction.x), abs(_e175.direction.y));
                let _e309 = core_intrinsics_maximum_number_nsz_f32_(_e308, abs(_e175.direction.z));
                let _e310 = (_e309 * 0.0000000000009094947f);
                if (abs(_e175.direction.x) < _e310) {
                    phi_936_ = _e310;
                } else {
                    phi_936_ = abs(_e175.direction.x);
                }
                let _e316 = phi_936_;
                if (_e175.direction.x < 0f) {
                    phi_943_ = (-1f / _e316);
                } else {
                    phi_943_ = (1f / _e316);
                }
                let _e321 = phi_943_;
                if (abs(_e175.direction.y) < _e310) {
                    phi_951_ = _e310;
                } else {
                    phi_951_ = abs(_e175.direction.y);
                }
                let _e327 = phi_951_;
                if (_e175.direction.y < 0f) {
                    phi_958_ = (-1f / _e327);
                } else {
                    phi_958_ = (1f / _e327);
                }
                let _e332 = phi_958_;
                if (abs(_e175.direction.z) < _e310) {
                    phi_966_ = _e310;
                } else {
                    phi_966_ = abs(_e175.direction.z);
                }
                let _e338 = phi_966_;
                if (_e175.direction.z < 0f) {
                    phi_973_ = (-1f / _e338);
                } else {
                    phi_973_ = (1f / _e338);
                }
                let _e343 = phi_973_;
                let _e350 = abs((bitcast<f32>(_e245) - _e175.origin.x));
                let _e351 = abs((bitcast<f32>(_e249) - _e175.origin.y));
                let _e352 = abs((bitcast<f32>(_e253) - _e175.origin.z));
                let _e359 = abs(((bitcast<f32>(_e257) + (bitcast<f32>((((_e269 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e175.origin.x));
                let _e360 = abs(((bitcast<f32>(_e261) + (bitcast<f32>((((_e269 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e175.origin.y));
                let _e361 = abs(((bitcast<f32>(_e265) + (bitcast<f32>((((_e269 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e175.origin.z));
                if (_e350 > _e359) {
                    phi_996_ = _e350;
                } else {
                    phi_996_ = _e359;
                }
                let _e364 = phi_996_;
                if (_e351 > _e360) {
                    phi_1001_ = _e351;
                } else {
                    phi_1001_ = _e360;
                }
                let _e367 = phi_1001_;
                if (_e352 > _e361) {
                    phi_1006_ = _e352;
                } else {
                    phi_1006_ = _e361;
                }
                let _e370 = phi_1006_;
                if (_e364 > _e367) {
                    phi_1011_ = _e364;
                } else {
                    phi_1011_ = _e367;
                }
                let _e373 = phi_1011_;
                if (_e373 > _e370) {
                    phi_1016_ = _e373;
                } else {
                    phi_1016_ = _e370;
                }
                let _e376 = phi_1016_;
                let _e380 = (_e376 * 0.0000019073486f);
                let _e381 = (abs(_e321) * _e380);
                let _e382 = (abs(_e332) * _e380);
                let _e383 = (abs(_e343) * _e380);
                let _e387 = (_e376 * 0.0000009536743f);
                let _e388 = (abs(_e321) * _e387);
                let _e389 = (abs(_e332) * _e387);
                let _e390 = (abs(_e343) * _e387);
                if (_e321 < 0f) {
                    phi_1035_ = 0u;
                } else {
                    phi_1035_ = 1u;
                }
                let _e393 = phi_1035_;
                if (_e332 < 0f) {
                    phi_1040_ = 0u;
                } else {
                    phi_1040_ = 2u;
                }
                let _e396 = phi_1040_;
                if (_e343 < 0f) {
                    phi_1045_ = 0u;
                } else {
                    phi_1045_ = 4u;
                }
                let _e399 = phi_1045_;
                let _e401 = ((_e393 | _e396) | _e399);
                let _e402 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e107, 2147483648u);
                local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e402.first[0], _e402.first[1], _e402.first[2], _e402.first[3], _e402.first[4], _e402.first[5], _e402.first[6], _e402.first[7], _e402.first[8], _e402.first[9], _e402.first[10], _e402.first[11], _e402.first[12], _e402.first[13], _e402.first[14], _e402.first[15], _e402.first[16], _e402.first[17], _e402.first[18], _e402.first[19], _e402.first[20], _e402.first[21], _e402.first[22], _e402.first[23], _e402.first[24], _e402.first[25], _e402.first[26], _e402.first[27], _e402.first[28], _e402.first[29], _e402.first[30], _e402.first[31]), array<u32, 32>(_e402.mask[0], _e402.mask[1], _e402.mask[2], _e402.mask[3], _e402.mask[4], _e402.mask[5], _e402.mask[6], _e402.mask[7], _e402.mask[8], _e402.mask[9], _e402.mask[10], _e402.mask[11], _e402.mask[12], _e402.mask[13], _e402.mask[14], _e402.mask[15], _e402.mask[16], _e402.mask[17], _e402.mask[18], _e402.mask[19], _e402.mask[20], _e402.mask[21], _e402.mask[22], _e402.mask[23], _e402.mask[24], _e402.mask[25], _e402.mask[26], _e402.mask[27], _e402.mask[28], _e402.mask[29], _e402.mask[30], _e402.mask[31]), _e402.len, _e402.group, _e402.group_mask);
                let _e476 = local_2.group_mask;
                if ((_e476 & 4278190080u) == 0u) {
                    let _e480 = local_2.len;
                    if (_e480 == 0u) {
                        phi_1159_ = false;
                    } else {
                        let _e484 = local_2.len;
                        local_2.len = (_e484 - 1u);
                        let _e487 = local_2.len;
                        if (_e487 < 32u) {
                        } else {
                            return;
                        }
                        let _e492 = local_2.first[(0u + _e487)];
                        local_2.group = _e492;
                        let _e495 = local_2.len;
                        if (_e495 < 32u) {
                        } else {
                            return;
                        }
                        let _e500 = local_2.mask[(0u + _e495)];
                        local_2.group_mask = _e500;
                        phi_1159_ = true;
                    }
                    let _e503 = phi_1159_;
                    phi_1160_ = _e503;
                } else {
                    phi_1160_ = true;
                }
                let _e505 = phi_1160_;
                if _e505 {
                    let _e507 = local_2.group_mask;
                    let _e513 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e507)), 32u, (_e507 == 0u)));
                    let _e517 = local_2.group_mask;
                    let _e531 = local_2.group_mask;
                    local_2.group_mask = (_e531 & ~((1u << bitcast<u32>((_e513 & 31u)))));
                    let _e534 = local_2.group;
                    phi_1191_ = (_e534 + countOneBits(((_e517 & ~((4294967295u << bitcast<u32>((((_e513 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1191_ = 4294967295u;
                }
                let _e537 = phi_1191_;
                phi_1193_ = _e537;
                phi_1196_ = _e177;
                loop {
                    let _e539 = phi_1193_;
                    let _e541 = phi_1196_;
                    local_12 = _e541;
                    let _e542 = (_e539 != 4294967295u);
                    if _e542 {
                        if (_e539 < _e77) {
                        } else {
                            return;
                        }
                        let _e550 = nodes.member[(0u + _e539)].frame[3u];
                        let _e575 = (bitcast<f32>((((_e550 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e321);
                        let _e576 = (bitcast<f32>((((_e550 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e332);
                        let _e577 = (bitcast<f32>((((_e550 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e343);
                        let _e580 = nodes.member[(0u + _e539)].frame[0u];
                        let _e584 = nodes.member[(0u + _e539)].frame[1u];
                        let _e588 = nodes.member[(0u + _e539)].frame[2u];
                        let _e596 = ((bitcast<f32>(_e580) - _e175.origin.x) * _e321);
                        let _e597 = ((bitcast<f32>(_e584) - _e175.origin.y) * _e332);
                        let _e598 = ((bitcast<f32>(_e588) - _e175.origin.z) * _e343);
                        let _e606 = nodes.member[(0u + _e539)].x;
                        if (_e321 < 0f) {
                            let _e617 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e606.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e623 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e617.unnamed.root, _e606.w), _e617.unnamed_1);
                            let _e629 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e623.unnamed, lt_bvh_traverse_Tree(_e606.x, _e623.unnamed_1.first_primitive));
                            phi_1281_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e629.unnamed, lt_bvh_traverse_Tree(_e629.unnamed_1.root, _e606.y));
                        } else {
                            let _e645 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e606.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e651 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e645.unnamed.root, _e606.y), _e645.unnamed_1);
                            let _e657 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e651.unnamed, lt_bvh_traverse_Tree(_e606.z, _e651.unnamed_1.first_primitive));
                            phi_1281_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e657.unnamed, lt_bvh_traverse_Tree(_e657.unnamed_1.root, _e606.w));
                        }
                        let _e665 = phi_1281_;
                        let _e675 = nodes.member[(0u + _e539)].y;
                        if (_e332 < 0f) {
                            let _e686 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e675.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e692 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e686.unnamed.root, _e675.w), _e686.unnamed_1);
                            let _e698 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e692.unnamed, lt_bvh_traverse_Tree(_e675.x, _e692.unnamed_1.first_primitive));
                            phi_1308_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e698.unnamed, lt_bvh_traverse_Tree(_e698.unnamed_1.root, _e675.y));
                        } else {
                            let _e714 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e675.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e720 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e714.unnamed.root, _e675.y), _e714.unnamed_1);
                            let _e726 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e720.unnamed, lt_bvh_traverse_Tree(_e675.z, _e720.unnamed_1.first_primitive));
                            phi_1308_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e726.unnamed, lt_bvh_traverse_Tree(_e726.unnamed_1.root, _e675.w));
                        }
                        let _e734 = phi_1308_;
                        let _e744 = nodes.member[(0u + _e539)].z;
                        if (_e343 < 0f) {
                            let _e755 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e744.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e761 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e755.unnamed.root, _e744.w), _e755.unnamed_1);
                            let _e767 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e761.unnamed, lt_bvh_traverse_Tree(_e744.x, _e761.unnamed_1.first_primitive));
                            phi_1335_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e767.unnamed, lt_bvh_traverse_Tree(_e767.unnamed_1.root, _e744.y));
                        } else {
                            let _e783 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e744.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e789 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e783.unnamed.root, _e744.y), _e783.unnamed_1);
                            let _e795 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e789.unnamed, lt_bvh_traverse_Tree(_e744.z, _e789.unnamed_1.first_primitive));
                            phi_1335_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e795.unnamed, lt_bvh_traverse_Tree(_e795.unnamed_1.root, _e744.w));
                        }
                        let _e803 = phi_1335_;
                        phi_1341_ = 0u;
                        phi_1344_ = 0u;
                        loop {
                            let _e813 = phi_1341_;
                            let _e815 = phi_1344_;
                            local_3 = _e815;
                            local_4 = _e815;
                            local_5 = _e815;
                            let _e816 = (_e813 < 8u);
                            if _e816 {
                                let _e818 = (_e813 >> bitcast<u32>(2i));
                                let _e819 = (_e813 & 3u);
                                if (_e818 == 0u) {
                                    phi_1358_ = _e665.unnamed.root;
                                } else {
                                    phi_1358_ = _e665.unnamed.first_primitive;
                                }
                                let _e822 = phi_1358_;
                                if (_e818 == 0u) {
                                    phi_1368_ = _e734.unnamed.root;
                                } else {
                                    phi_1368_ = _e734.unnamed.first_primitive;
                                }
                                let _e831 = phi_1368_;
                                if (_e818 == 0u) {
                                    phi_1378_ = _e803.unnamed.root;
                                } else {
                                    phi_1378_ = _e803.unnamed.first_primitive;
                                }
                                let _e840 = phi_1378_;
                                let _e853 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e822 >> bitcast<u32>(((_e819 * 8u) & 31u))) & 255u)) * _e575) + (_e596 - _e381)), ((f32(((_e831 >> bitcast<u32>(((_e819 * 8u) & 31u))) & 255u)) * _e576) + (_e597 - _e382)));
                                let _e854 = core_intrinsics_maximum_number_nsz_f32_(_e853, ((f32(((_e840 >> bitcast<u32>(((_e819 * 8u) & 31u))) & 255u)) * _e577) + (_e598 - _e383)));
                                if (_e818 == 0u) {
                                    phi_1396_ = _e665.unnamed_1.root;
                                } else {
                                    phi_1396_ = _e665.unnamed_1.first_primitive;
                                }
                                let _e857 = phi_1396_;
                                if (_e818 == 0u) {
                                    phi_1406_ = _e734.unnamed_1.root;
                                } else {
                                    phi_1406_ = _e734.unnamed_1.first_primitive;
                                }
                                let _e866 = phi_1406_;
                                if (_e818 == 0u) {
                                    phi_1416_ = _e803.unnamed_1.root;
                                } else {
                                    phi_1416_ = _e803.unnamed_1.first_primitive;
                                }
                                let _e875 = phi_1416_;
                                let _e888 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e857 >> bitcast<u32>(((_e819 * 8u) & 31u))) & 255u)) * _e575) + (_e596 + _e381)), ((f32(((_e866 >> bitcast<u32>(((_e819 * 8u) & 31u))) & 255u)) * _e576) + (_e597 + _e382)));
                                let _e889 = core_intrinsics_minimum_number_nsz_f32_(_e888, ((f32(((_e875 >> bitcast<u32>(((_e819 * 8u) & 31u))) & 255u)) * _e577) + (_e598 + _e383)));
                                if (_e854 <= _e889) {
                                    if (_e854 <= _e541.t) {
                                        if (_e889 >= _e175.tmin) {
                                            if (_e818 == 0u) {
                                                let _e896 = nodes.member[(0u + _e539)].links[2u];
                                                phi_1452_ = _e896;
                                            } else {
                                                let _e899 = nodes.member[(0u + _e539)].links[3u];
                                                phi_1452_ = _e899;
                                            }
                                            let _e901 = phi_1452_;
                                            let _e906 = ((_e901 >> bitcast<u32>(((_e819 * 8u) & 31u))) & 255u);
                                            let _e907 = (_e906 & 31u);
                                            if (_e907 >= 24u) {
                                                phi_1465_ = (24u + ((_e907 - 24u) ^ _e401));
                                            } else {
                                                phi_1465_ = _e907;
                                            }
                                            let _e913 = phi_1465_;
                                            phi_1470_ = (_e815 | ((_e906 >> bitcast<u32>(5i)) << bitcast<u32>((_e913 & 31u))));
                                        } else {
                                            phi_1470_ = _e815;
                                        }
                                        let _e921 = phi_1470_;
                                        phi_1471_ = _e921;
                                    } else {
                                        phi_1471_ = _e815;
                                    }
                                    let _e923 = phi_1471_;
                                    phi_1472_ = _e923;
                                } else {
                                    phi_1472_ = _e815;
                                }
                                let _e925 = phi_1472_;
                                phi_1342_ = (_e813 + 1u);
                                phi_1345_ = _e925;
                            } else {
                                phi_1342_ = u32();
                                phi_1345_ = u32();
                            }
                            let _e928 = phi_1342_;
                            let _e930 = phi_1345_;
                            continue;
                            continuing {
                                phi_1341_ = _e928;
                                phi_1344_ = _e930;
                                break if !(_e816);
                            }
                        }
                        let _e934 = nodes.member[(0u + _e539)].links[0u];
                        let _e938 = nodes.member[(0u + _e539)].frame[3u];
                        let _e942 = local_3;
                        if ((_e942 & 4278190080u) == 0u) {
                        } else {
                            let _e946 = local_2.group_mask;
                            if ((_e946 & 4278190080u) == 0u) {
                            } else {
                                let _e950 = local_2.len;
                                if (_e950 < 32u) {
                                    let _e953 = local_2.group;
                                    let _e955 = local_2.len;
                                    if (_e955 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.first[(0u + _e955)] = _e953;
                                    let _e961 = local_2.group_mask;
                                    let _e963 = local_2.len;
                                    if (_e963 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.mask[(0u + _e963)] = _e961;
                                    let _e970 = local_2.len;
                                    local_2.len = (_e970 + 1u);
                                }
                            }
                            local_2.group = (_e107 + _e934);
                            let _e974 = local_4;
                            local_2.group_mask = ((_e974 & 4278190080u) | (_e938 >> bitcast<u32>(24i)));
                        }
                        let _e979 = local_5;
                        phi_1530_ = (_e979 & 16777215u);
                        phi_1533_ = _e541;
                        loop {
                            let _e982 = phi_1530_;
                            let _e984 = phi_1533_;
                            local_11 = _e984;
                            if (_e982 == 0u) {
                                phi_1531_ = u32();
                                phi_1534_ = lt_bvh_Hit();
                                phi_3420_ = false;
                            } else {
                                let _e988 = nodes.member[(0u + _e539)].links[1u];
                                let _e992 = (_e988 + select(firstTrailingBit(_e982), 32u, (_e982 == 0u)));
                                if (_e992 < _e92) {
                                } else {
                                    return;
                                }
                                let _e999 = instances.member[(0u + _e992)].low_world;
                                let _e1001 = instances.member[(0u + _e992)].high_world;
                                let _e1011 = ((_e999.x - _e175.origin.x) * _e321);
                                let _e1012 = ((_e999.y - _e175.origin.y) * _e332);
                                let _e1013 = ((_e999.z - _e175.origin.z) * _e343);
                                let _e1023 = ((_e1001.x - _e175.origin.x) * _e321);
                                let _e1024 = ((_e1001.y - _e175.origin.y) * _e332);
                                let _e1025 = ((_e1001.z - _e175.origin.z) * _e343);
                                if (_e1011 < _e1023) {
                                    phi_1588_ = _e1011;
                                } else {
                                    phi_1588_ = _e1023;
                                }
                                let _e1028 = phi_1588_;
                                if (_e1012 < _e1024) {
                                    phi_1593_ = _e1012;
                                } else {
                                    phi_1593_ = _e1024;
                                }
                                let _e1031 = phi_1593_;
                                if (_e1013 < _e1025) {
                                    phi_1598_ = _e1013;
                                } else {
                                    phi_1598_ = _e1025;
                                }
                                let _e1034 = phi_1598_;
                                if (_e1011 > _e1023) {
                                    phi_1606_ = _e1011;
                                } else {
                                    phi_1606_ = _e1023;
                                }
                                let _e1040 = phi_1606_;
                                if (_e1012 > _e1024) {
                                    phi_1611_ = _e1012;
                                } else {
                                    phi_1611_ = _e1024;
                                }
                                let _e1043 = phi_1611_;
                                if (_e1013 > _e1025) {
                                    phi_1616_ = _e1013;
                                } else {
                                    phi_1616_ = _e1025;
                                }
                                let _e1046 = phi_1616_;
                                let _e1050 = core_intrinsics_maximum_number_nsz_f32_((_e1028 - _e388), (_e1031 - _e389));
                                let _e1051 = core_intrinsics_maximum_number_nsz_f32_(_e1050, (_e1034 - _e390));
                                let _e1052 = core_intrinsics_minimum_number_nsz_f32_((_e1040 + _e388), (_e1043 + _e389));
                                let _e1053 = core_intrinsics_minimum_number_nsz_f32_(_e1052, (_e1046 + _e390));
                                if (_e1051 <= _e1053) {
                                    if (_e1051 <= _e984.t) {
                                        if (_e1053 >= _e175.tmin) {
                                            let _e1065 = instances.member[(0u + _e992)].world_to_object[0u];
                                            let _e1076 = ((((_e1065.x * _e175.origin.x) + (_e1065.y * _e175.origin.y)) + (_e1065.z * _e175.origin.z)) + (_e1065.w * 1f));
                                            let _e1078 = instances.member[(0u + _e992)].world_to_object[1u];
                                            let _e1089 = ((((_e1078.x * _e175.origin.x) + (_e1078.y * _e175.origin.y)) + (_e1078.z * _e175.origin.z)) + (_e1078.w * 1f));
                                            let _e1091 = instances.member[(0u + _e992)].world_to_object[2u];
                                            let _e1102 = ((((_e1091.x * _e175.origin.x) + (_e1091.y * _e175.origin.y)) + (_e1091.z * _e175.origin.z)) + (_e1091.w * 1f));
                                            let _e1109 = instances.member[(0u + _e992)].world_to_object[0u];
                                            let _e1120 = ((((_e1109.x * _e175.direction.x) + (_e1109.y * _e175.direction.y)) + (_e1109.z * _e175.direction.z)) + (_e1109.w * 0f));
                                            let _e1122 = instances.member[(0u + _e992)].world_to_object[1u];
                                            let _e1133 = ((((_e1122.x * _e175.direction.x) + (_e1122.y * _e175.direction.y)) + (_e1122.z * _e175.direction.z)) + (_e1122.w * 0f));
                                            let _e1135 = instances.member[(0u + _e992)].world_to_object[2u];
                                            let _e1146 = ((((_e1135.x * _e175.direction.x) + (_e1135.y * _e175.direction.y)) + (_e1135.z * _e175.direction.z)) + (_e1135.w * 0f));
                                            let _e1151 = instances.member[(0u + _e992)].root;
                                            let _e1153 = instances.member[(0u + _e992)].first_triangle;
                                            let _e1154 = abs(_e1120);
                                            let _e1155 = abs(_e1133);
                                            let _e1156 = abs(_e1146);
                                            if (abs(_e1076) < 1000000000000000f) {
                                                if (abs(_e1089) < 1000000000000000f) {
                                                    phi_1748_ = (abs(_e1102) < 1000000000000000f);
                                                    phi_1749_ = false;
                                                } else {
                                                    phi_1748_ = bool();
                                                    phi_1749_ = true;
                                                }
                                                let _e1164 = phi_1748_;
                                                let _e1166 = phi_1749_;
                                                phi_1750_ = _e1164;
                                                phi_1751_ = _e1166;
                                            } else {
                                                phi_1750_ = bool();
                                                phi_1751_ = true;
                                            }
                                            let _e1168 = phi_1750_;
                                            let _e1170 = phi_1751_;
                                            if _e1170 {
                                                phi_1755_ = false;
                                            } else {
                                                phi_1755_ = _e1168;
                                            }
                                            let _e1172 = phi_1755_;
                                            if _e1172 {
                                                if (_e1154 < 1000000000000000f) {
                                                    if (_e1155 < 1000000000000000f) {
                                                        phi_1768_ = (_e1156 < 1000000000000000f);
                                                        phi_1769_ = false;
                                                    } else {
                                                        phi_1768_ = bool();
                                                        phi_1769_ = true;
                                                    }
                                                    let _e1177 = phi_1768_;
                                                    let _e1179 = phi_1769_;
                                                    phi_1770_ = _e1177;
                                                    phi_1771_ = _e1179;
                                                } else {
                                                    phi_1770_ = bool();
                                                    phi_1771_ = true;
                                                }
                                                let _e1181 = phi_1770_;
                                                let _e1183 = phi_1771_;
                                                if _e1183 {
                                                    phi_1775_ = false;
                                                } else {
                                                    phi_1775_ = _e1181;
                                                }
                                                let _e1185 = phi_1775_;
                                                if _e1185 {
                                                    if (_e1154 > 0f) {
                                                        phi_1789_ = bool();
                                                        phi_1790_ = true;
                                                    } else {
                                                        let _e1187 = (_e1155 > 0f);
                                                        if _e1187 {
                                                            phi_1788_ = bool();
                                                        } else {
                                                            phi_1788_ = (_e1156 > 0f);
                                                        }
                                                        let _e1190 = phi_1788_;
                                                        phi_1789_ = _e1190;
                                                        phi_1790_ = _e1187;
                                                    }
                                                    let _e1192 = phi_1789_;
                                                    let _e1194 = phi_1790_;
                                                    if _e1194 {
                                                        phi_1794_ = true;
                                                    } else {
                                                        phi_1794_ = _e1192;
                                                    }
                                                    let _e1196 = phi_1794_;
                                                    phi_1795_ = _e1196;
                                                    phi_1796_ = false;
                                                } else {
                                                    phi_1795_ = bool();
                                                    phi_1796_ = true;
                                                }
                                                let _e1198 = phi_1795_;
                                                let _e1200 = phi_1796_;
                                                phi_1797_ = _e1198;
                                                phi_1798_ = _e1200;
                                            } else {
                                                phi_1797_ = bool();
                                                phi_1798_ = true;
                                            }
                                            let _e1202 = phi_1797_;
                                            let _e1204 = phi_1798_;
                                            if _e1204 {
                                                phi_1802_ = false;
                                            } else {
                                                phi_1802_ = _e1202;
                                            }
                                            let _e1206 = phi_1802_;
                                            if _e1206 {
                                                let _e1207 = (_e1151 >= _e77);
                                                if _e1207 {
                                                    phi_3410_ = lt_bvh_Hit();
                                                } else {
                                                    if (_e1151 < _e77) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1213 = nodes.member[(0u + _e1151)].frame[0u];
                                                    let _e1217 = nodes.member[(0u + _e1151)].frame[1u];
                                                    let _e1221 = nodes.member[(0u + _e1151)].frame[2u];
                                                    let _e1225 = nodes.member[(0u + _e1151)].frame[0u];
                                                    let _e1229 = nodes.member[(0u + _e1151)].frame[1u];
                                                    let _e1233 = nodes.member[(0u + _e1151)].frame[2u];
                                                    let _e1237 = nodes.member[(0u + _e1151)].frame[3u];
                                                    let _e1271 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1120), abs(_e1133));
                                                    let _e1272 = core_intrinsics_maximum_number_nsz_f32_(_e1271, abs(_e1146));
                                                    let _e1273 = (_e1272 * 0.0000000000009094947f);
                                                    if (abs(_e1120) < _e1273) {
                                                        phi_1872_ = _e1273;
                                                    } else {
                                                        phi_1872_ = abs(_e1120);
                                                    }
                                                    let _e1278 = phi_1872_;
                                                    if (_e1120 < 0f) {
                                                        phi_1879_ = (-1f / _e1278);
                                                    } else {
                                                        phi_1879_ = (1f / _e1278);
                                                    }
                                                    let _e1283 = phi_1879_;
                                                    if (abs(_e1133) < _e1273) {
                                                        phi_1886_ = _e1273;
                                                    } else {
                                                        phi_1886_ = abs(_e1133);
                                                    }
                                                    let _e1288 = phi_1886_;
                                                    if (_e1133 < 0f) {
                                                        phi_1893_ = (-1f / _e1288);
                                                    } else {
                                                        phi_1893_ = (1f / _e1288);
                                                    }
                                                    let _e1293 = phi_1893_;
                                                    if (abs(_e1146) < _e1273) {
                                                        phi_1900_ = _e1273;
                                                    } else {
                                                        phi_1900_ = abs(_e1146);
                                                    }
                                                    let _e1298 = phi_1900_;
                                                    if (_e1146 < 0f) {
                                                        phi_1907_ = (-1f / _e1298);
                                                    } else {
                                                        phi_1907_ = (1f / _e1298);
                                                    }
                                                    let _e1303 = phi_1907_;
                                                    let _e1307 = abs((bitcast<f32>(_e1213) - _e1076));
                                                    let _e1308 = abs((bitcast<f32>(_e1217) - _e1089));
                                                    let _e1309 = abs((bitcast<f32>(_e1221) - _e1102));
                                                    let _e1313 = abs(((bitcast<f32>(_e1225) + (bitcast<f32>((((_e1237 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1076));
                                                    let _e1314 = abs(((bitcast<f32>(_e1229) + (bitcast<f32>((((_e1237 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1089));
                                                    let _e1315 = abs(((bitcast<f32>(_e1233) + (bitcast<f32>((((_e1237 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1102));
                                                    if (_e1307 > _e1313) {
                                                        phi_1924_ = _e1307;
                                                    } else {
                                                        phi_1924_ = _e1313;
                                                    }
                                                    let _e1318 = phi_1924_;
                                                    if (_e1308 > _e1314) {
                                                        phi_1929_ = _e1308;
                                                    } else {
                                                        phi_1929_ = _e1314;
                                                    }
                                                    let _e1321 = phi_1929_;
                                                    if (_e1309 > _e1315) {
                                                        phi_1934_ = _e1309;
                                                    } else {
                                                        phi_1934_ = _e1315;
                                                    }
                                                    let _e1324 = phi_1934_;
                                                    if (_e1318 > _e1321) {
                                                        phi_1939_ = _e1318;
                                                    } else {
                                                        phi_1939_ = _e1321;
                                                    }
                                                    let _e1327 = phi_1939_;
                                                    if (_e1327 > _e1324) {
                                                        phi_1944_ = _e1327;
                                                    } else {
                                                        phi_1944_ = _e1324;
                                                    }
                                                    let _e1330 = phi_1944_;
                                                    let _e1334 = (_e1330 * 0.0000019073486f);
                                                    let _e1335 = (abs(_e1283) * _e1334);
                                                    let _e1336 = (abs(_e1293) * _e1334);
                                                    let _e1337 = (abs(_e1303) * _e1334);
                                                    let _e1341 = (_e1330 * 0.0000009536743f);
                                                    let _e1342 = (abs(_e1283) * _e1341);
                                                    let _e1343 = (abs(_e1293) * _e1341);
                                                    let _e1344 = (abs(_e1303) * _e1341);
                                                    let _e1345 = abs(_e1120);
                                                    let _e1346 = abs(_e1133);
                                                    let _e1347 = abs(_e1146);
                                                    if (_e1345 >= _e1346) {
                                                        if (_e1345 >= _e1347) {
                                                            phi_1970_ = false;
                                                        } else {
                                                            phi_1970_ = true;
                                                        }
                                                        let _e1351 = phi_1970_;
                                                        phi_1971_ = _e1351;
                                                    } else {
                                                        phi_1971_ = true;
                                                    }
                                                    let _e1353 = phi_1971_;
                                                    if _e1353 {
                                                        if (_e1346 >= _e1347) {
                                                            phi_1979_ = 1u;
                                                        } else {
                                                            phi_1979_ = 2u;
                                                        }
                                                        let _e1356 = phi_1979_;
                                                        phi_1980_ = _e1356;
                                                    } else {
                                                        phi_1980_ = 0u;
                                                    }
                                                    let _e1358 = phi_1980_;
                                                    if (_e1358 == 0u) {
                                                        phi_1992_ = vec3<f32>(_e1133, _e1146, _e1120);
                                                    } else {
                                                        if (_e1358 == 1u) {
                                                            phi_1991_ = vec3<f32>(_e1146, _e1120, _e1133);
                                                        } else {
                                                            phi_1991_ = vec3<f32>(_e1120, _e1133, _e1146);
                                                        }
                                                        let _e1364 = phi_1991_;
                                                        phi_1992_ = _e1364;
                                                    }
                                                    let _e1366 = phi_1992_;
                                                    let _e1369 = (_e1366.x / _e1366.z);
                                                    let _e1372 = (_e1366.y / _e1366.z);
                                                    if (_e1283 < 0f) {
                                                        phi_2005_ = 0u;
                                                    } else {
                                                        phi_2005_ = 1u;
                                                    }
                                                    let _e1377 = phi_2005_;
                                                    if (_e1293 < 0f) {
                                                        phi_2010_ = 0u;
                                                    } else {
                                                        phi_2010_ = 2u;
                                                    }
                                                    let _e1380 = phi_2010_;
                                                    if (_e1303 < 0f) {
                                                        phi_2015_ = 0u;
                                                    } else {
                                                        phi_2015_ = 4u;
                                                    }
                                                    let _e1383 = phi_2015_;
                                                    let _e1385 = ((_e1377 | _e1380) | _e1383);
                                                    let _e1386 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1151, 2147483648u);
                                                    local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e1386.first[0], _e1386.first[1], _e1386.first[2], _e1386.first[3], _e1386.first[4], _e1386.first[5], _e1386.first[6], _e1386.first[7], _e1386.first[8], _e1386.first[9], _e1386.first[10], _e1386.first[11], _e1386.first[12], _e1386.first[13], _e1386.first[14], _e1386.first[15], _e1386.first[16], _e1386.first[17], _e1386.first[18], _e1386.first[19], _e1386.first[20], _e1386.first[21], _e1386.first[22], _e1386.first[23], _e1386.first[24], _e1386.first[25], _e1386.first[26], _e1386.first[27], _e1386.first[28], _e1386.first[29], _e1386.first[30], _e1386.first[31]), array<u32, 32>(_e1386.mask[0], _e1386.mask[1], _e1386.mask[2], _e1386.mask[3], _e1386.mask[4], _e1386.mask[5], _e1386.mask[6], _e1386.mask[7], _e1386.mask[8], _e1386.mask[9], _e1386.mask[10], _e1386.mask[11], _e1386.mask[12], _e1386.mask[13], _e1386.mask[14], _e1386.mask[15], _e1386.mask[16], _e1386.mask[17], _e1386.mask[18], _e1386.mask[19], _e1386.mask[20], _e1386.mask[21], _e1386.mask[22], _e1386.mask[23], _e1386.mask[24], _e1386.mask[25], _e1386.mask[26], _e1386.mask[27], _e1386.mask[28], _e1386.mask[29], _e1386.mask[30], _e1386.mask[31]), _e1386.len, _e1386.group, _e1386.group_mask);
                                                    let _e1460 = local_1.group_mask;
                                                    if ((_e1460 & 4278190080u) == 0u) {
                                                        let _e1464 = local_1.len;
                                                        if (_e1464 == 0u) {
                                                            phi_2129_ = false;
                                                        } else {
                                                            let _e1468 = local_1.len;
                                                            local_1.len = (_e1468 - 1u);
                                                            let _e1471 = local_1.len;
                                                            if (_e1471 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1476 = local_1.first[(0u + _e1471)];
                                                            local_1.group = _e1476;
                                                            let _e1479 = local_1.len;
                                                            if (_e1479 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1484 = local_1.mask[(0u + _e1479)];
                                                            local_1.group_mask = _e1484;
                                                            phi_2129_ = true;
                                                        }
                                                        let _e1487 = phi_2129_;
                                                        phi_2130_ = _e1487;
                                                    } else {
                                                        phi_2130_ = true;
                                                    }
                                                    let _e1489 = phi_2130_;
                                                    if _e1489 {
                                                        let _e1491 = local_1.group_mask;
                                                        let _e1497 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1491)), 32u, (_e1491 == 0u)));
                                                        let _e1501 = local_1.group_mask;
                                                        let _e1515 = local_1.group_mask;
                                                        local_1.group_mask = (_e1515 & ~((1u << bitcast<u32>((_e1497 & 31u)))));
                                                        let _e1518 = local_1.group;
                                                        phi_2161_ = (_e1518 + countOneBits(((_e1501 & ~((4294967295u << bitcast<u32>((((_e1497 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_2161_ = 4294967295u;
                                                    }
                                                    let _e1521 = phi_2161_;
                                                    phi_2163_ = _e984;
                                                    phi_2166_ = _e1521;
                                                    loop {
                                                        let _e1523 = phi_2163_;
                                                        let _e1525 = phi_2166_;
                                                        local_10 = _e1523;
                                                        let _e1526 = (_e1525 != 4294967295u);
                                                        if _e1526 {
                                                            if (_e1525 < _e77) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1533 = nodes.member[(0u + _e1525)].frame[3u];
                                                            let _e1558 = (bitcast<f32>((((_e1533 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1283);
                                                            let _e1559 = (bitcast<f32>((((_e1533 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1293);
                                                            let _e1560 = (bitcast<f32>((((_e1533 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1303);
                                                            let _e1563 = nodes.member[(0u + _e1525)].frame[0u];
                                                            let _e1567 = nodes.member[(0u + _e1525)].frame[1u];
                                                            let _e1571 = nodes.member[(0u + _e1525)].frame[2u];
                                                            let _e1576 = ((bitcast<f32>(_e1563) - _e1076) * _e1283);
                                                            let _e1577 = ((bitcast<f32>(_e1567) - _e1089) * _e1293);
                                                            let _e1578 = ((bitcast<f32>(_e1571) - _e1102) * _e1303);
                                                            let _e1586 = nodes.member[(0u + _e1525)].x;
                                                            if (_e1283 < 0f) {
                                                                let _e1597 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1586.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1603 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1597.unnamed.root, _e1586.w), _e1597.unnamed_1);
                                                                let _e1609 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1603.unnamed, lt_bvh_traverse_Tree(_e1586.x, _e1603.unnamed_1.first_primitive));
                                                                phi_2247_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1609.unnamed, lt_bvh_traverse_Tree(_e1609.unnamed_1.root, _e1586.y));
                                                            } else {
                                                                let _e1625 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1586.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1631 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1625.unnamed.root, _e1586.y), _e1625.unnamed_1);
                                                                let _e1637 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1631.unnamed, lt_bvh_traverse_Tree(_e1586.z, _e1631.unnamed_1.first_primitive));
                                                                phi_2247_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1637.unnamed, lt_bvh_traverse_Tree(_e1637.unnamed_1.root, _e1586.w));
                                                            }
                                                            let _e1645 = phi_2247_;
                                                            let _e1655 = nodes.member[(0u + _e1525)].y;
                                                            if (_e1293 < 0f) {
                                                                let _e1666 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1655.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1672 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1666.unnamed.root, _e1655.w), _e1666.unnamed_1);
                                                                let _e1678 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1672.unnamed, lt_bvh_traverse_Tree(_e1655.x, _e1672.unnamed_1.first_primitive));
                                                                phi_2274_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1678.unnamed, lt_bvh_traverse_Tree(_e1678.unnamed_1.root, _e1655.y));
                                                            } else {
                                                                let _e1694 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1655.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1700 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1694.unnamed.root, _e1655.y), _e1694.unnamed_1);
                                                                let _e1706 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1700.unnamed, lt_bvh_traverse_Tree(_e1655.z, _e1700.unnamed_1.first_primitive));
                                                                phi_2274_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1706.unnamed, lt_bvh_traverse_Tree(_e1706.unnamed_1.root, _e1655.w));
                                                            }
                                                            let _e1714 = phi_2274_;
                                                            let _e1724 = nodes.member[(0u + _e1525)].z;
                                                            if (_e1303 < 0f) {
                                                                let _e1735 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1724.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1741 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1735.unnamed.root, _e1724.w), _e1735.unnamed_1);
                                                                let _e1747 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1741.unnamed, lt_bvh_traverse_Tree(_e1724.x, _e1741.unnamed_1.first_primitive));
                                                                phi_2301_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1747.unnamed, lt_bvh_traverse_Tree(_e1747.unnamed_1.root, _e1724.y));
                                                            } else {
                                                                let _e1763 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1724.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1769 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1763.unnamed.root, _e1724.y), _e1763.unnamed_1);
                                                                let _e1775 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1769.unnamed, lt_bvh_traverse_Tree(_e1724.z, _e1769.unnamed_1.first_primitive));
                                                                phi_2301_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1775.unnamed, lt_bvh_traverse_Tree(_e1775.unnamed_1.root, _e1724.w));
                                                            }
                                                            let _e1783 = phi_2301_;
                                                            phi_2307_ = 0u;
                                                            phi_2310_ = 0u;
                                                            loop {
                                                                let _e1793 = phi_2307_;
                                                                let _e1795 = phi_2310_;
                                                                local_6 = _e1795;
                                                                local_7 = _e1795;
                                                                local_8 = _e1795;
                                                                let _e1796 = (_e1793 < 8u);
                                                                if _e1796 {
                                                                    let _e1798 = (_e1793 >> bitcast<u32>(2i));
                                                                    let _e1799 = (_e1793 & 3u);
                                                                    if (_e1798 == 0u) {
                                                                        phi_2324_ = _e1645.unnamed.root;
                                                                    } else {
                                                                        phi_2324_ = _e1645.unnamed.first_primitive;
                                                                    }
                                                                    let _e1802 = phi_2324_;
                                                                    if (_e1798 == 0u) {
                                                                        phi_2334_ = _e1714.unnamed.root;
                                                                    } else {
                                                                        phi_2334_ = _e1714.unnamed.first_primitive;
                                                                    }
                                                                    let _e1811 = phi_2334_;
                                                                    if (_e1798 == 0u) {
                                                                        phi_2344_ = _e1783.unnamed.root;
                                                                    } else {
                                                                        phi_2344_ = _e1783.unnamed.first_primitive;
                                                                    }
                                                                    let _e1820 = phi_2344_;
                                                                    let _e1833 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1802 >> bitcast<u32>(((_e1799 * 8u) & 31u))) & 255u)) * _e1558) + (_e1576 - _e1335)), ((f32(((_e1811 >> bitcast<u32>(((_e1799 * 8u) & 31u))) & 255u)) * _e1559) + (_e1577 - _e1336)));
                                                                    let _e1834 = core_intrinsics_maximum_number_nsz_f32_(_e1833, ((f32(((_e1820 >> bitcast<u32>(((_e1799 * 8u) & 31u))) & 255u)) * _e1560) + (_e1578 - _e1337)));
                                                                    if (_e1798 == 0u) {
                                                                        phi_2362_ = _e1645.unnamed_1.root;
                                                                    } else {
                                                                        phi_2362_ = _e1645.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1837 = phi_2362_;
                                                                    if (_e1798 == 0u) {
                                                                        phi_2372_ = _e1714.unnamed_1.root;
                                                                    } else {
                                                                        phi_2372_ = _e1714.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1846 = phi_2372_;
                                                                    if (_e1798 == 0u) {
                                                                        phi_2382_ = _e1783.unnamed_1.root;
                                                                    } else {
                                                                        phi_2382_ = _e1783.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1855 = phi_2382_;
                                                                    let _e1868 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1837 >> bitcast<u32>(((_e1799 * 8u) & 31u))) & 255u)) * _e1558) + (_e1576 + _e1335)), ((f32(((_e1846 >> bitcast<u32>(((_e1799 * 8u) & 31u))) & 255u)) * _e1559) + (_e1577 + _e1336)));
                                                                    let _e1869 = core_intrinsics_minimum_number_nsz_f32_(_e1868, ((f32(((_e1855 >> bitcast<u32>(((_e1799 * 8u) & 31u))) & 255u)) * _e1560) + (_e1578 + _e1337)));
                                                                    if (_e1834 <= _e1869) {
                                                                        if (_e1834 <= _e1523.t) {
                                                                            if (_e1869 >= _e175.tmin) {
                                                                                if (_e1798 == 0u) {
                                                                                    let _e1876 = nodes.member[(0u + _e1525)].links[2u];
                                                                                    phi_2418_ = _e1876;
                                                                                } else {
                                                                                    let _e1879 = nodes.member[(0u + _e1525)].links[3u];
                                                                                    phi_2418_ = _e1879;
                                                                                }
                                                                                let _e1881 = phi_2418_;
                                                                                let _e1886 = ((_e1881 >> bitcast<u32>(((_e1799 * 8u) & 31u))) & 255u);
                                                                                let _e1887 = (_e1886 & 31u);
                                                                                if (_e1887 >= 24u) {
                                                                                    phi_2431_ = (24u + ((_e1887 - 24u) ^ _e1385));
                                                                                } else {
                                                                                    phi_2431_ = _e1887;
                                                                                }
                                                                                let _e1893 = phi_2431_;
                                                                                phi_2436_ = (_e1795 | ((_e1886 >> bitcast<u32>(5i)) << bitcast<u32>((_e1893 & 31u))));
                                                                            } else {
                                                                                phi_2436_ = _e1795;
                                                                            }
                                                                            let _e1901 = phi_2436_;
                                                                            phi_2437_ = _e1901;
                                                                        } else {
                                                                            phi_2437_ = _e1795;
                                                                        }
                                                                        let _e1903 = phi_2437_;
                                                                        phi_2438_ = _e1903;
                                                                    } else {
                                                                        phi_2438_ = _e1795;
                                                                    }
                                                                    let _e1905 = phi_2438_;
                                                                    phi_2308_ = (_e1793 + 1u);
                                                                    phi_2311_ = _e1905;
                                                                } else {
                                                                    phi_2308_ = u32();
                                                                    phi_2311_ = u32();
                                                                }
                                                                let _e1908 = phi_2308_;
                                                                let _e1910 = phi_2311_;
                                                                continue;
                                                                continuing {
                                                                    phi_2307_ = _e1908;
                                                                    phi_2310_ = _e1910;
                                                                    break if !(_e1796);
                                                                }
                                                            }
                                                            let _e1914 = nodes.member[(0u + _e1525)].links[0u];
                                                            let _e1918 = nodes.member[(0u + _e1525)].frame[3u];
                                                            let _e1922 = local_6;
                                                            if ((_e1922 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1926 = local_1.group_mask;
                                                                if ((_e1926 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1930 = local_1.len;
                                                                    if (_e1930 < 32u) {
                                                                        let _e1933 = local_1.group;
                                                                        let _e1935 = local_1.len;
                                                                        if (_e1935 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.first[(0u + _e1935)] = _e1933;
                                                                        let _e1941 = local_1.group_mask;
                                                                        let _e1943 = local_1.len;
                                                                        if (_e1943 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.mask[(0u + _e1943)] = _e1941;
                                                                        let _e1950 = local_1.len;
                                                                        local_1.len = (_e1950 + 1u);
                                                                    }
                                                                }
                                                                local_1.group = (_e1151 + _e1914);
                                                                let _e1954 = local_7;
                                                                local_1.group_mask = ((_e1954 & 4278190080u) | (_e1918 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1959 = local_8;
                                                            phi_2496_ = _e1523;
                                                            phi_2499_ = (_e1959 & 16777215u);
                                                            loop {
                                                                let _e1962 = phi_2496_;
                                                                let _e1964 = phi_2499_;
                                                                local_9 = _e1962;
                                                                if (_e1964 == 0u) {
                                                                    phi_2497_ = lt_bvh_Hit();
                                                                    phi_2500_ = u32();
                                                                    phi_3338_ = false;
                                                                } else {
                                                                    let _e1968 = nodes.member[(0u + _e1525)].links[1u];
                                                                    let _e1973 = ((_e1153 + _e1968) + select(firstTrailingBit(_e1964), 32u, (_e1964 == 0u)));
                                                                    if (_e1973 < _e80) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1980 = triangles.member[(0u + _e1973)].v0_;
                                                                    let _e1982 = (_e1980.x - _e1076);
                                                                    let _e1984 = (_e1980.y - _e1089);
                                                                    let _e1986 = (_e1980.z - _e1102);
                                                                    if (_e1358 == 0u) {
                                                                        phi_2544_ = vec3<f32>(_e1984, _e1986, _e1982);
                                                                    } else {
                                                                        if (_e1358 == 1u) {
                                                                            phi_2543_ = vec3<f32>(_e1986, _e1982, _e1984);
                                                                        } else {
                                                                            phi_2543_ = (_e1980 - vec3<f32>(_e1076, _e1089, _e1102));
                                                                        }
                                                                        let _e1994 = phi_2543_;
                                                                        phi_2544_ = _e1994;
                                                                    }
                                                                    let _e1996 = phi_2544_;
                                                                    let _e2000 = (_e1996.x - (_e1369 * _e1996.z));
                                                                    let _e2004 = (_e1996.y - (_e1372 * _e1996.z));
                                                                    let _e2006 = triangles.member[(0u + _e1973)].v1_;
                                                                    let _e2008 = (_e2006.x - _e1076);
                                                                    let _e2010 = (_e2006.y - _e1089);
                                                                    let _e2012 = (_e2006.z - _e1102);
                                                                    if (_e1358 == 0u) {
                                                                        phi_2574_ = vec3<f32>(_e2010, _e2012, _e2008);
                                                                    } else {
                                                                        if (_e1358 == 1u) {
                                                                            phi_2573_ = vec3<f32>(_e2012, _e2008, _e2010);
                                                                        } else {
                                                                            phi_2573_ = (_e2006 - vec3<f32>(_e1076, _e1089, _e1102));
                                                                        }
                                                                        let _e2020 = phi_2573_;
                                                                        phi_2574_ = _e2020;
                                                                    }
                                                                    let _e2022 = phi_2574_;
                                                                    let _e2026 = (_e2022.x - (_e1369 * _e2022.z));
                                                                    let _e2030 = (_e2022.y - (_e1372 * _e2022.z));
                                                                    let _e2032 = triangles.member[(0u + _e1973)].v2_;
                                                                    let _e2034 = (_e2032.x - _e1076);
                                                                    let _e2036 = (_e2032.y - _e1089);
                                                                    let _e2038 = (_e2032.z - _e1102);
                                                                    if (_e1358 == 0u) {
                                                                        phi_2604_ = vec3<f32>(_e2036, _e2038, _e2034);
                                                                    } else {
                                                                        if (_e1358 == 1u) {
                                                                            phi_2603_ = vec3<f32>(_e2038, _e2034, _e2036);
                                                                        } else {
                                                                            phi_2603_ = (_e2032 - vec3<f32>(_e1076, _e1089, _e1102));
                                                                        }
                                                                        let _e2046 = phi_2603_;
                                                                        phi_2604_ = _e2046;
                                                                    }
                                                                    let _e2048 = phi_2604_;
                                                                    let _e2052 = (_e2048.x - (_e1369 * _e2048.z));
                                                                    let _e2056 = (_e2048.y - (_e1372 * _e2048.z));
                                                                    if (_e2026 < _e2052) {
                                                                        phi_2623_ = true;
                                                                    } else {
                                                                        if (_e2026 == _e2052) {
                                                                            phi_2622_ = (_e2030 < _e2056);
                                                                        } else {
                                                                            phi_2622_ = false;
                                                                        }
                                                                        let _e2061 = phi_2622_;
                                                                        phi_2623_ = _e2061;
                                                                    }
                                                                    let _e2063 = phi_2623_;
                                                                    if _e2063 {
                                                                        phi_2627_ = _e2056;
                                                                        phi_2628_ = _e2052;
                                                                        phi_2629_ = _e2030;
                                                                        phi_2630_ = _e2026;
                                                                    } else {
                                                                        phi_2627_ = _e2030;
                                                                        phi_2628_ = _e2026;
                                                                        phi_2629_ = _e2056;
                                                                        phi_2630_ = _e2052;
                                                                    }
                                                                    let _e2065 = phi_2627_;
                                                                    let _e2067 = phi_2628_;
                                                                    let _e2069 = phi_2629_;
                                                                    let _e2071 = phi_2630_;
                                                                    let _e2074 = ((_e2071 * _e2065) - (_e2069 * _e2067));
                                                                    if _e2063 {
                                                                        phi_2638_ = -(_e2074);
                                                                    } else {
                                                                        phi_2638_ = _e2074;
                                                                    }
                                                                    let _e2077 = phi_2638_;
                                                                    if (_e2052 < _e2000) {
                                                                        phi_2649_ = true;
                                                                    } else {
                                                                        if (_e2052 == _e2000) {
                                                                            phi_2648_ = (_e2056 < _e2004);
                                                                        } else {
                                                                            phi_2648_ = false;
                                                                        }
                                                                        let _e2082 = phi_2648_;
                                                                        phi_2649_ = _e2082;
                                                                    }
                                                                    let _e2084 = phi_2649_;
                                                                    if _e2084 {
                                                                        phi_2653_ = _e2004;
                                                                        phi_2654_ = _e2000;
                                                                        phi_2655_ = _e2056;
                                                                        phi_2656_ = _e2052;
                                                                    } else {
                                                                        phi_2653_ = _e2056;
                                                                        phi_2654_ = _e2052;
                                                                        phi_2655_ = _e2004;
                                                                        phi_2656_ = _e2000;
                                                                    }
                                                                    let _e2086 = phi_2653_;
                                                                    let _e2088 = phi_2654_;
                                                                    let _e2090 = phi_2655_;
                                                                    let _e2092 = phi_2656_;
                                                                    let _e2095 = ((_e2092 * _e2086) - (_e2090 * _e2088));
                                                                    if _e2084 {
                                                                        phi_2664_ = -(_e2095);
                                                                    } else {
                                                                        phi_2664_ = _e2095;
                                                                    }
                                                                    let _e2098 = phi_2664_;
                                                                    if (_e2000 < _e2026) {
                                                                        phi_2675_ = true;
                                                                    } else {
                                                                        if (_e2000 == _e2026) {
                                                                            phi_2674_ = (_e2004 < _e2030);
                                                                        } else {
                                                                            phi_2674_ = false;
                                                                        }
                                                                        let _e2103 = phi_2674_;
                                                                        phi_2675_ = _e2103;
                                                                    }
                                                                    let _e2105 = phi_2675_;
                                                                    if _e2105 {
                                                                        phi_2679_ = _e2030;
                                                                        phi_2680_ = _e2026;
                                                                        phi_2681_ = _e2004;
                                                                        phi_2682_ = _e2000;
                                                                    } else {
                                                                        phi_2679_ = _e2004;
                                                                        phi_2680_ = _e2000;
                                                                        phi_2681_ = _e2030;
                                                                        phi_2682_ = _e2026;
                                                                    }
                                                                    let _e2107 = phi_2679_;
                                                                    let _e2109 = phi_2680_;
                                                                    let _e2111 = phi_2681_;
                                                                    let _e2113 = phi_2682_;
                                                                    let _e2116 = ((_e2113 * _e2107) - (_e2111 * _e2109));
                                                                    if _e2105 {
                                                                        phi_2690_ = -(_e2116);
                                                                    } else {
                                                                        phi_2690_ = _e2116;
                                                                    }
                                                                    let _e2119 = phi_2690_;
                                                                    if (_e2077 >= 0f) {
                                                                        if (_e2098 >= 0f) {
                                                                            if (_e2119 >= 0f) {
                                                                                phi_2705_ = ((_e2077 + _e2098) + _e2119);
                                                                                phi_2706_ = false;
                                                                            } else {
                                                                                phi_2705_ = f32();
                                                                                phi_2706_ = true;
                                                                            }
                                                                            let _e2126 = phi_2705_;
                                                                            let _e2128 = phi_2706_;
                                                                            phi_2707_ = _e2126;
                                                                            phi_2708_ = _e2128;
                                                                        } else {
                                                                            phi_2707_ = f32();
                                                                            phi_2708_ = true;
                                                                        }
                                                                        let _e2130 = phi_2707_;
                                                                        let _e2132 = phi_2708_;
                                                                        phi_2709_ = _e2130;
                                                                        phi_2710_ = _e2132;
                                                                    } else {
                                                                        phi_2709_ = f32();
                                                                        phi_2710_ = true;
                                                                    }
                                                                    let _e2134 = phi_2709_;
                                                                    let _e2136 = phi_2710_;
                                                                    if _e2136 {
                                                                        if (_e2077 <= 0f) {
                                                                            if (_e2098 <= 0f) {
                                                                                let _e2139 = (_e2119 <= 0f);
                                                                                if _e2139 {
                                                                                }
                                                                                phi_2728_ = ((_e2077 + _e2098) + _e2119);
                                                                                phi_2729_ = false;
                                                                                phi_2730_ = _e2139;
                                                                            } else {
                                                                                phi_2728_ = f32();
                                                                                phi_2729_ = true;
                                                                                phi_2730_ = false;
                                                                            }
                                                                            let _e2143 = phi_2728_;
                                                                            let _e2145 = phi_2729_;
                                                                            let _e2147 = phi_2730_;
                                                                            phi_2731_ = _e2143;
                                                                            phi_2732_ = _e2145;
                                                                            phi_2733_ = _e2147;
                                                                        } else {
                                                                            phi_2731_ = f32();
                                                                            phi_2732_ = true;
                                                                            phi_2733_ = false;
                                                                        }
                                                                        let _e2149 = phi_2731_;
                                                                        let _e2151 = phi_2732_;
                                                                        let _e2153 = phi_2733_;
                                                                        if _e2151 {
                                                                            phi_2737_ = false;
                                                                        } else {
                                                                            phi_2737_ = _e2153;
                                                                        }
                                                                        let _e2155 = phi_2737_;
                                                                        phi_2738_ = _e2149;
                                                                        phi_2739_ = _e2155;
                                                                    } else {
                                                                        phi_2738_ = _e2134;
                                                                        phi_2739_ = true;
                                                                    }
                                                                    let _e2157 = phi_2738_;
                                                                    let _e2159 = phi_2739_;
                                                                    if _e2159 {
                                                                        let _e2160 = (_e2157 == 0f);
                                                                        if _e2160 {
                                                                            phi_3055_ = lt_bvh_triangle_Intersection();
                                                                            phi_3056_ = false;
                                                                        } else {
                                                                            let _e2162 = triangles.member[(0u + _e1973)].v0_;
                                                                            let _e2164 = (_e2162.x - _e1076);
                                                                            let _e2166 = (_e2162.y - _e1089);
                                                                            let _e2168 = (_e2162.z - _e1102);
                                                                            if (_e1358 == 0u) {
                                                                                phi_2768_ = vec3<f32>(_e2166, _e2168, _e2164);
                                                                            } else {
                                                                                if (_e1358 == 1u) {
                                                                                    phi_2767_ = vec3<f32>(_e2168, _e2164, _e2166);
                                                                                } else {
                                                                                    phi_2767_ = (_e2162 - vec3<f32>(_e1076, _e1089, _e1102));
                                                                                }
                                                                                let _e2176 = phi_2767_;
                                                                                phi_2768_ = _e2176;
                                                                            }
                                                                            let _e2178 = phi_2768_;
                                                                            let _e2180 = triangles.member[(0u + _e1973)].v1_;
                                                                            let _e2182 = triangles.member[(0u + _e1973)].v0_;
                                                                            let _e2185 = (_e2180.x - _e2182.x);
                                                                            let _e2188 = (_e2180.y - _e2182.y);
                                                                            let _e2191 = (_e2180.z - _e2182.z);
                                                                            if (_e1358 == 0u) {
                                                                                phi_2794_ = vec3<f32>(_e2188, _e2191, _e2185);
                                                                            } else {
                                                                                if (_e1358 == 1u) {
                                                                                    phi_2793_ = vec3<f32>(_e2191, _e2185, _e2188);
                                                                                } else {
                                                                                    phi_2793_ = (_e2180 - _e2182);
                                                                                }
                                                                                let _e2198 = phi_2793_;
                                                                                phi_2794_ = _e2198;
                                                                            }
                                                                            let _e2200 = phi_2794_;
                                                                            let _e2202 = triangles.member[(0u + _e1973)].v2_;
                                                                            let _e2204 = triangles.member[(0u + _e1973)].v0_;
                                                                            let _e2207 = (_e2202.x - _e2204.x);
                                                                            let _e2210 = (_e2202.y - _e2204.y);
                                                                            let _e2213 = (_e2202.z - _e2204.z);
                                                                            if (_e1358 == 0u) {
                                                                                phi_2820_ = vec3<f32>(_e2210, _e2213, _e2207);
                                                                            } else {
                                                                                if (_e1358 == 1u) {
                                                                                    phi_2819_ = vec3<f32>(_e2213, _e2207, _e2210);
                                                                                } else {
                                                                                    phi_2819_ = (_e2202 - _e2204);
                                                                                }
                                                                                let _e2220 = phi_2819_;
                                                                                phi_2820_ = _e2220;
                                                                            }
                                                                            let _e2222 = phi_2820_;
                                                                            let _e2229 = ((_e2200.y * _e2222.z) - (_e2200.z * _e2222.y));
                                                                            let _e2236 = ((_e2200.z * _e2222.x) - (_e2200.x * _e2222.z));
                                                                            let _e2243 = ((_e2200.x * _e2222.y) - (_e2200.y * _e2222.x));
                                                                            let _e2257 = (((1f / _e1366.z) * (((_e2229 * _e2178.x) + (_e2236 * _e2178.y)) + (_e2243 * _e2178.z))) / (((_e2229 * _e1369) + (_e2236 * _e1372)) + _e2243));
                                                                            if (_e2257 > _e175.tmin) {
                                                                                if (_e2257 < _e175.tmax) {
                                                                                    let _e2261 = triangles.member[(0u + _e1973)].v0_;
                                                                                    let _e2263 = triangles.member[(0u + _e1973)].v1_;
                                                                                    if (_e2261.x < _e2263.x) {
                                                                                        phi_2876_ = _e2261.x;
                                                                                    } else {
                                                                                        phi_2876_ = _e2263.x;
                                                                                    }
                                                                                    let _e2270 = phi_2876_;
                                                                                    if (_e2261.y < _e2263.y) {
                                                                                        phi_2885_ = _e2261.y;
                                                                                    } else {
                                                                                        phi_2885_ = _e2263.y;
                                                                                    }
                                                                                    let _e2277 = phi_2885_;
                                                                                    if (_e2261.z < _e2263.z) {
                                                                                        phi_2894_ = _e2261.z;
                                                                                    } else {
                                                                                        phi_2894_ = _e2263.z;
                                                                                    }
                                                                                    let _e2284 = phi_2894_;
                                                                                    let _e2286 = triangles.member[(0u + _e1973)].v2_;
                                                                                    if (_e2270 < _e2286.x) {
                                                                                        phi_2903_ = _e2270;
                                                                                    } else {
                                                                                        phi_2903_ = _e2286.x;
                                                                                    }
                                                                                    let _e2291 = phi_2903_;
                                                                                    if (_e2277 < _e2286.y) {
                                                                                        phi_2910_ = _e2277;
                                                                                    } else {
                                                                                        phi_2910_ = _e2286.y;
                                                                                    }
                                                                                    let _e2296 = phi_2910_;
                                                                                    if (_e2284 < _e2286.z) {
                                                                                        phi_2917_ = _e2284;
                                                                                    } else {
                                                                                        phi_2917_ = _e2286.z;
                                                                                    }
                                                                                    let _e2301 = phi_2917_;
                                                                                    let _e2303 = triangles.member[(0u + _e1973)].v0_;
                                                                                    let _e2305 = triangles.member[(0u + _e1973)].v1_;
                                                                                    if (_e2303.x > _e2305.x) {
                                                                                        phi_2930_ = _e2303.x;
                                                                                    } else {
                                                                                        phi_2930_ = _e2305.x;
                                                                                    }
                                                                                    let _e2312 = phi_2930_;
                                                                                    if (_e2303.y > _e2305.y) {
                                                                                        phi_2939_ = _e2303.y;
                                                                                    } else {
                                                                                        phi_2939_ = _e2305.y;
                                                                                    }
                                                                                    let _e2319 = phi_2939_;
                                                                                    if (_e2303.z > _e2305.z) {
                                                                                        phi_2948_ = _e2303.z;
                                                                                    } else {
                                                                                        phi_2948_ = _e2305.z;
                                                                                    }
                                                                                    let _e2326 = phi_2948_;
                                                                                    let _e2328 = triangles.member[(0u + _e1973)].v2_;
                                                                                    if (_e2312 > _e2328.x) {
                                                                                        phi_2957_ = _e2312;
                                                                                    } else {
                                                                                        phi_2957_ = _e2328.x;
                                                                                    }
                                                                                    let _e2333 = phi_2957_;
                                                                                    if (_e2319 > _e2328.y) {
                                                                                        phi_2964_ = _e2319;
                                                                                    } else {
                                                                                        phi_2964_ = _e2328.y;
                                                                                    }
                                                                                    let _e2338 = phi_2964_;
                                                                                    if (_e2326 > _e2328.z) {
                                                                                        phi_2971_ = _e2326;
                                                                                    } else {
                                                                                        phi_2971_ = _e2328.z;
                                                                                    }
                                                                                    let _e2343 = phi_2971_;
                                                                                    let _e2347 = ((_e2291 - _e1076) * _e1283);
                                                                                    let _e2348 = ((_e2296 - _e1089) * _e1293);
                                                                                    let _e2349 = ((_e2301 - _e1102) * _e1303);
                                                                                    let _e2353 = ((_e2333 - _e1076) * _e1283);
                                                                                    let _e2354 = ((_e2338 - _e1089) * _e1293);
                                                                                    let _e2355 = ((_e2343 - _e1102) * _e1303);
                                                                                    if (_e2347 < _e2353) {
                                                                                        phi_2988_ = _e2347;
                                                                                    } else {
                                                                                        phi_2988_ = _e2353;
                                                                                    }
                                                                                    let _e2358 = phi_2988_;
                                                                                    if (_e2348 < _e2354) {
                                                                                        phi_2993_ = _e2348;
                                                                                    } else {
                                                                                        phi_2993_ = _e2354;
                                                                                    }
                                                                                    let _e2361 = phi_2993_;
                                                                                    if (_e2349 < _e2355) {
                                                                                        phi_2998_ = _e2349;
                                                                                    } else {
                                                                                        phi_2998_ = _e2355;
                                                                                    }
                                                                                    let _e2364 = phi_2998_;
                                                                                    if (_e2347 > _e2353) {
                                                                                        phi_3006_ = _e2347;
                                                                                    } else {
                                                                                        phi_3006_ = _e2353;
                                                                                    }
                                                                                    let _e2370 = phi_3006_;
                                                                                    if (_e2348 > _e2354) {
                                                                                        phi_3011_ = _e2348;
                                                                                    } else {
                                                                                        phi_3011_ = _e2354;
                                                                                    }
                                                                                    let _e2373 = phi_3011_;
                                                                                    if (_e2349 > _e2355) {
                                                                                        phi_3016_ = _e2349;
                                                                                    } else {
                                                                                        phi_3016_ = _e2355;
                                                                                    }
                                                                                    let _e2376 = phi_3016_;
                                                                                    let _e2380 = core_intrinsics_maximum_number_nsz_f32_((_e2358 - _e1342), (_e2361 - _e1343));
                                                                                    let _e2381 = core_intrinsics_maximum_number_nsz_f32_(_e2380, (_e2364 - _e1344));
                                                                                    let _e2382 = core_intrinsics_minimum_number_nsz_f32_((_e2370 + _e1342), (_e2373 + _e1343));
                                                                                    let _e2383 = core_intrinsics_minimum_number_nsz_f32_(_e2382, (_e2376 + _e1344));
                                                                                    if (_e2381 > _e1051) {
                                                                                        phi_3028_ = _e2381;
                                                                                    } else {
                                                                                        phi_3028_ = _e1051;
                                                                                    }
                                                                                    let _e2386 = phi_3028_;
                                                                                    if (_e2383 < _e1053) {
                                                                                        phi_3033_ = _e2383;
                                                                                    } else {
                                                                                        phi_3033_ = _e1053;
                                                                                    }
                                                                                    let _e2389 = phi_3033_;
                                                                                    if (_e2257 < _e2386) {
                                                                                        phi_3038_ = _e2386;
                                                                                    } else {
                                                                                        phi_3038_ = _e2257;
                                                                                    }
                                                                                    let _e2392 = phi_3038_;
                                                                                    if (_e2392 > _e2389) {
                                                                                        phi_3043_ = _e2389;
                                                                                    } else {
                                                                                        phi_3043_ = _e2392;
                                                                                    }
                                                                                    let _e2395 = phi_3043_;
                                                                                    phi_3048_ = lt_bvh_triangle_Intersection(_e2395, (_e2098 / _e2157), (_e2119 / _e2157), (_e2386 <= _e2389));
                                                                                    phi_3049_ = false;
                                                                                } else {
                                                                                    phi_3048_ = lt_bvh_triangle_Intersection();
                                                                                    phi_3049_ = true;
                                                                                }
                                                                                let _e2401 = phi_3048_;
                                                                                let _e2403 = phi_3049_;
                                                                                phi_3050_ = _e2401;
                                                                                phi_3051_ = _e2403;
                                                                            } else {
                                                                                phi_3050_ = lt_bvh_triangle_Intersection();
                                                                                phi_3051_ = true;
                                                                            }
                                                                            let _e2405 = phi_3050_;
                                                                            let _e2407 = phi_3051_;
                                                                            if _e2407 {
                                                                            }
                                                                            phi_3055_ = _e2405;
                                                                            phi_3056_ = _e2407;
                                                                        }
                                                                        let _e2409 = phi_3055_;
                                                                        let _e2411 = phi_3056_;
                                                                        phi_3057_ = _e2409;
                                                                        phi_3058_ = _e2160;
                                                                        phi_3059_ = _e2411;
                                                                    } else {
                                                                        phi_3057_ = lt_bvh_triangle_Intersection();
                                                                        phi_3058_ = true;
                                                                        phi_3059_ = false;
                                                                    }
                                                                    let _e2413 = phi_3057_;
                                                                    let _e2415 = phi_3058_;
                                                                    let _e2417 = phi_3059_;
                                                                    if _e2415 {
                                                                        phi_3063_ = true;
                                                                    } else {
                                                                        phi_3063_ = _e2417;
                                                                    }
                                                                    let _e2419 = phi_3063_;
                                                                    if _e2419 {
                                                                        phi_3067_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_3067_ = _e2413;
                                                                    }
                                                                    let _e2421 = phi_3067_;
                                                                    if _e2421.is_hit {
                                                                        if (_e2421.t > _e175.tmin) {
                                                                            if (_e2421.t < _e1962.t) {
                                                                                phi_3115_ = true;
                                                                            } else {
                                                                                if (_e2421.t == _e1962.t) {
                                                                                    if (_e1962.triangle != 4294967295u) {
                                                                                        if (_e1973 < _e1962.triangle) {
                                                                                            phi_3106_ = true;
                                                                                        } else {
                                                                                            if (_e1973 == _e1962.triangle) {
                                                                                                phi_3105_ = (_e992 < _e1962.instance);
                                                                                            } else {
                                                                                                phi_3105_ = false;
                                                                                            }
                                                                                            let _e2439 = phi_3105_;
                                                                                            phi_3106_ = _e2439;
                                                                                        }
                                                                                        let _e2441 = phi_3106_;
                                                                                        phi_3107_ = _e2441;
                                                                                        phi_3108_ = false;
                                                                                    } else {
                                                                                        phi_3107_ = bool();
                                                                                        phi_3108_ = true;
                                                                                    }
                                                                                    let _e2443 = phi_3107_;
                                                                                    let _e2445 = phi_3108_;
                                                                                    phi_3109_ = _e2443;
                                                                                    phi_3110_ = _e2445;
                                                                                } else {
                                                                                    phi_3109_ = bool();
                                                                                    phi_3110_ = true;
                                                                                }
                                                                                let _e2447 = phi_3109_;
                                                                                let _e2449 = phi_3110_;
                                                                                if _e2449 {
                                                                                    phi_3114_ = false;
                                                                                } else {
                                                                                    phi_3114_ = _e2447;
                                                                                }
                                                                                let _e2451 = phi_3114_;
                                                                                phi_3115_ = _e2451;
                                                                            }
                                                                            let _e2453 = phi_3115_;
                                                                            if _e2453 {
                                                                                let _e2455 = triangles.member[(0u + _e1973)].i0_;
                                                                                if ((_e2455 & 2147483648u) == 0u) {
                                                                                    phi_3326_ = true;
                                                                                } else {
                                                                                    if (_e1973 < _e80) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2464 = triangles.member[(0u + _e1973)].i0_;
                                                                                    let _e2465 = (_e2464 & 2147483647u);
                                                                                    let _e2467 = triangles.member[(0u + _e1973)].i1_;
                                                                                    let _e2469 = triangles.member[(0u + _e1973)].i2_;
                                                                                    if (_e2465 < _e83) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2473 = vertices.member[(0u + _e2465)];
                                                                                    if (_e2467 < _e83) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2477 = vertices.member[(0u + _e2467)];
                                                                                    if (_e2469 < _e83) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2481 = vertices.member[(0u + _e2469)];
                                                                                    let _e2482 = array<abi_Vertex, 3>(_e2473, _e2477, _e2481);
                                                                                    if (_e2482[0].material < _e86) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2488 = materials.member[(0u + _e2482[0].material)];
                                                                                    if ((_e2488.flags & 0u) == 0u) {
                                                                                        let _e2493 = ((1f - _e2421.u) - _e2421.v);
                                                                                        if (_e2488.cutoff <= 0f) {
                                                                                            phi_3321_ = true;
                                                                                        } else {
                                                                                            let _e2520 = (_e2488.base_color.w * ((((f32((_e2482[0].color >> bitcast<u32>(24i))) * _e2493) + (f32((_e2482[1].color >> bitcast<u32>(24i))) * _e2421.u)) + (f32((_e2482[2].color >> bitcast<u32>(24i))) * _e2421.v)) * (1f / 255f)));
                                                                                            if (_e2488.alpha_size == 0u) {
                                                                                                phi_3318_ = _e2520;
                                                                                            } else {
                                                                                                local.offset = _e2488.alpha_offset;
                                                                                                local.size = _e2488.alpha_size;
                                                                                                local.flags = _e2488.flags;
                                                                                                let _e2551 = _lt_shaders_texture_TextureView_quad((&local), (((_e2482[0].u * _e2493) + (_e2482[1].u * _e2421.u)) + (_e2482[2].u * _e2421.v)), (((_e2482[0].v * _e2493) + (_e2482[1].v * _e2421.u)) + (_e2482[2].v * _e2421.v)));
                                                                                                let _e2555 = (_e2551.indices[0] >> bitcast<u32>(2i));
                                                                                                if (_e2555 < _e95) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2559 = alpha_texels.member[(0u + _e2555)];
                                                                                                let _e2575 = (_e2551.indices[1] >> bitcast<u32>(2i));
                                                                                                if (_e2575 < _e95) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2579 = alpha_texels.member[(0u + _e2575)];
                                                                                                let _e2596 = (_e2551.indices[2] >> bitcast<u32>(2i));
                                                                                                if (_e2596 < _e95) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2600 = alpha_texels.member[(0u + _e2596)];
                                                                                                let _e2617 = (_e2551.indices[3] >> bitcast<u32>(2i));
                                                                                                if (_e2617 < _e95) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2621 = alpha_texels.member[(0u + _e2617)];
                                                                                                phi_3318_ = (_e2520 * (((((f32(((_e2559 >> bitcast<u32>((((_e2551.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2551.weights.x) + ((f32(((_e2579 >> bitcast<u32>((((_e2551.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2551.weights.y)) + ((f32(((_e2600 >> bitcast<u32>((((_e2551.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2551.weights.z)) + ((f32(((_e2621 >> bitcast<u32>((((_e2551.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2551.weights.w)));
                                                                                            }
                                                                                            let _e2637 = phi_3318_;
                                                                                            phi_3321_ = (_e2637 >= _e2488.cutoff);
                                                                                        }
                                                                                        let _e2641 = phi_3321_;
                                                                                        phi_3322_ = _e2641;
                                                                                    } else {
                                                                                        phi_3322_ = false;
                                                                                    }
                                                                                    let _e2643 = phi_3322_;
                                                                                    if _e2643 {
                                                                                    }
                                                                                    phi_3326_ = _e2643;
                                                                                }
                                                                                let _e2645 = phi_3326_;
                                                                                if _e2645 {
                                                                                    phi_3334_ = lt_bvh_Hit(_e2421.t, _e2421.u, _e2421.v, _e1973, _e992);
                                                                                } else {
                                                                                    phi_3334_ = _e1962;
                                                                                }
                                                                                let _e2651 = phi_3334_;
                                                                                phi_3335_ = _e2651;
                                                                            } else {
                                                                                phi_3335_ = _e1962;
                                                                            }
                                                                            let _e2653 = phi_3335_;
                                                                            phi_3336_ = _e2653;
                                                                        } else {
                                                                            phi_3336_ = _e1962;
                                                                        }
                                                                        let _e2655 = phi_3336_;
                                                                        phi_3337_ = _e2655;
                                                                    } else {
                                                                        phi_3337_ = _e1962;
                                                                    }
                                                                    let _e2657 = phi_3337_;
                                                                    phi_2497_ = _e2657;
                                                                    phi_2500_ = (_e1964 & (_e1964 - 1u));
                                                                    phi_3338_ = true;
                                                                }
                                                                let _e2659 = phi_2497_;
                                                                let _e2661 = phi_2500_;
                                                                let _e2663 = phi_3338_;
                                                                continue;
                                                                continuing {
                                                                    phi_2496_ = _e2659;
                                                                    phi_2499_ = _e2661;
                                                                    break if !(_e2663);
                                                                }
                                                            }
                                                            let _e2666 = local_1.group_mask;
                                                            if ((_e2666 & 4278190080u) == 0u) {
                                                                let _e2670 = local_1.len;
                                                                if (_e2670 == 0u) {
                                                                    phi_3377_ = false;
                                                                } else {
                                                                    let _e2674 = local_1.len;
                                                                    local_1.len = (_e2674 - 1u);
                                                                    let _e2677 = local_1.len;
                                                                    if (_e2677 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2682 = local_1.first[(0u + _e2677)];
                                                                    local_1.group = _e2682;
                                                                    let _e2685 = local_1.len;
                                                                    if (_e2685 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2690 = local_1.mask[(0u + _e2685)];
                                                                    local_1.group_mask = _e2690;
                                                                    phi_3377_ = true;
                                                                }
                                                                let _e2693 = phi_3377_;
                                                                phi_3378_ = _e2693;
                                                            } else {
                                                                phi_3378_ = true;
                                                            }
                                                            let _e2695 = phi_3378_;
                                                            if _e2695 {
                                                                let _e2697 = local_1.group_mask;
                                                                let _e2703 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2697)), 32u, (_e2697 == 0u)));
                                                                let _e2707 = local_1.group_mask;
                                                                let _e2721 = local_1.group_mask;
                                                                local_1.group_mask = (_e2721 & ~((1u << bitcast<u32>((_e2703 & 31u)))));
                                                                let _e2724 = local_1.group;
                                                                phi_3409_ = (_e2724 + countOneBits(((_e2707 & ~((4294967295u << bitcast<u32>((((_e2703 - 24u) ^ _e1385) & 31u))))) & 255u)));
                                                            } else {
                                                                phi_3409_ = 4294967295u;
                                                            }
                                                            let _e2727 = phi_3409_;
                                                            let _e3712 = local_9;
                                                            phi_2164_ = _e3712;
                                                            phi_2167_ = _e2727;
                                                        } else {
                                                            phi_2164_ = lt_bvh_Hit();
                                                            phi_2167_ = u32();
                                                        }
                                                        let _e2729 = phi_2164_;
                                                        let _e2731 = phi_2167_;
                                                        continue;
                                                        continuing {
                                                            phi_2163_ = _e2729;
                                                            phi_2166_ = _e2731;
                                                            break if !(_e1526);
                                                        }
                                                    }
                                                    let _e3716 = local_10;
                                                    phi_3410_ = _e3716;
                                                }
                                                let _e2734 = phi_3410_;
                                                phi_3411_ = _e2734;
                                                phi_3412_ = _e1207;
                                            } else {
                                                phi_3411_ = lt_bvh_Hit();
                                                phi_3412_ = true;
                                            }
                                            let _e2736 = phi_3411_;
                                            let _e2738 = phi_3412_;
                                            if _e2738 {
                                                phi_3416_ = _e984;
                                            } else {
                                                phi_3416_ = _e2736;
                                            }
                                            let _e2740 = phi_3416_;
                                            phi_3417_ = _e2740;
                                        } else {
                                            phi_3417_ = _e984;
                                        }
                                        let _e2742 = phi_3417_;
                                        phi_3418_ = _e2742;
                                    } else {
                                        phi_3418_ = _e984;
                                    }
                                    let _e2744 = phi_3418_;
                                    phi_3419_ = _e2744;
                                } else {
                                    phi_3419_ = _e984;
                                }
                                let _e2746 = phi_3419_;
                                phi_1531_ = (_e982 & (_e982 - 1u));
                                phi_1534_ = _e2746;
                                phi_3420_ = true;
                            }
                            let _e2748 = phi_1531_;
                            let _e2750 = phi_1534_;
                            let _e2752 = phi_3420_;
                            continue;
                            continuing {
                                phi_1530_ = _e2748;
                                phi_1533_ = _e2750;
                                break if !(_e2752);
                            }
                        }
                        let _e2755 = local_2.group_mask;
                        if ((_e2755 & 4278190080u) == 0u) {
                            let _e2759 = local_2.len;
                            if (_e2759 == 0u) {
                                phi_3459_ = false;
                            } else {
                                let _e2763 = local_2.len;
                                local_2.len = (_e2763 - 1u);
                                let _e2766 = local_2.len;
                                if (_e2766 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2771 = local_2.first[(0u + _e2766)];
                                local_2.group = _e2771;
                                let _e2774 = local_2.len;
                                if (_e2774 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2779 = local_2.mask[(0u + _e2774)];
                                local_2.group_mask = _e2779;
                                phi_3459_ = true;
                            }
                            let _e2782 = phi_3459_;
                            phi_3460_ = _e2782;
                        } else {
                            phi_3460_ = true;
                        }
                        let _e2784 = phi_3460_;
                        if _e2784 {
                            let _e2786 = local_2.group_mask;
                            let _e2792 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2786)), 32u, (_e2786 == 0u)));
                            let _e2796 = local_2.group_mask;
                            let _e2810 = local_2.group_mask;
                            local_2.group_mask = (_e2810 & ~((1u << bitcast<u32>((_e2792 & 31u)))));
                            let _e2813 = local_2.group;
                            phi_3491_ = (_e2813 + countOneBits(((_e2796 & ~((4294967295u << bitcast<u32>((((_e2792 - 24u) ^ _e401) & 31u))))) & 255u)));
                        } else {
                            phi_3491_ = 4294967295u;
                        }
                        let _e2816 = phi_3491_;
                        phi_1194_ = _e2816;
                        let _e3732 = local_11;
                        phi_1197_ = _e3732;
                    } else {
                        phi_1194_ = u32();
                        phi_1197_ = lt_bvh_Hit();
                    }
                    let _e2818 = phi_1194_;
                    let _e2820 = phi_1197_;
                    continue;
                    continuing {
                        phi_1193_ = _e2818;
                        phi_1196_ = _e2820;
                        break if !(_e542);
                    }
                }
                let _e3735 = local_12;
                phi_3492_ = _e3735;
            }
            let _e2823 = phi_3492_;
            phi_3493_ = _e2823;
            phi_3494_ = _e239;
        } else {
            phi_3493_ = lt_bvh_Hit();
            phi_3494_ = true;
        }
        let _e2825 = phi_3493_;
        let _e2827 = phi_3494_;
        if _e2827 {
            phi_3498_ = _e177;
        } else {
            phi_3498_ = _e2825;
        }
        let _e2829 = phi_3498_;
        if (_e2829.triangle != 4294967295u) {
            let _e2835 = ((1f - _e2829.u) - _e2829.v);
            if (_e2829.triangle < _e80) {
            } else {
                return;
            }
            let _e2841 = triangles.member[(0u + _e2829.triangle)];
            if (_e2829.instance < _e92) {
            } else {
                return;
            }
            let _e2852 = instances.member[(0u + _e2829.instance)].object_to_world[0u];
            let _e2863 = ((((_e2852.x * _e2841.v0_.x) + (_e2852.y * _e2841.v0_.y)) + (_e2852.z * _e2841.v0_.z)) + (_e2852.w * 1f));
            let _e2865 = instances.member[(0u + _e2829.instance)].object_to_world[1u];
            let _e2876 = ((((_e2865.x * _e2841.v0_.x) + (_e2865.y * _e2841.v0_.y)) + (_e2865.z * _e2841.v0_.z)) + (_e2865.w * 1f));
            let _e2878 = instances.member[(0u + _e2829.instance)].object_to_world[2u];
            let _e2889 = ((((_e2878.x * _e2841.v0_.x) + (_e2878.y * _e2841.v0_.y)) + (_e2878.z * _e2841.v0_.z)) + (_e2878.w * 1f));
            let _e2896 = instances.member[(0u + _e2829.instance)].object_to_world[0u];
            let _e2907 = ((((_e2896.x * _e2841.v1_.x) + (_e2896.y * _e2841.v1_.y)) + (_e2896.z * _e2841.v1_.z)) + (_e2896.w * 1f));
            let _e2909 = instances.member[(0u + _e2829.instance)].object_to_world[1u];
            let _e2920 = ((((_e2909.x * _e2841.v1_.x) + (_e2909.y * _e2841.v1_.y)) + (_e2909.z * _e2841.v1_.z)) + (_e2909.w * 1f));
            let _e2922 = instances.member[(0u + _e2829.instance)].object_to_world[2u];
            let _e2933 = ((((_e2922.x * _e2841.v1_.x) + (_e2922.y * _e2841.v1_.y)) + (_e2922.z * _e2841.v1_.z)) + (_e2922.w * 1f));
            let _e2940 = instances.member[(0u + _e2829.instance)].object_to_world[0u];
            let _e2951 = ((((_e2940.x * _e2841.v2_.x) + (_e2940.y * _e2841.v2_.y)) + (_e2940.z * _e2841.v2_.z)) + (_e2940.w * 1f));
            let _e2953 = instances.member[(0u + _e2829.instance)].object_to_world[1u];
            let _e2964 = ((((_e2953.x * _e2841.v2_.x) + (_e2953.y * _e2841.v2_.y)) + (_e2953.z * _e2841.v2_.z)) + (_e2953.w * 1f));
            let _e2966 = instances.member[(0u + _e2829.instance)].object_to_world[2u];
            let _e2977 = ((((_e2966.x * _e2841.v2_.x) + (_e2966.y * _e2841.v2_.y)) + (_e2966.z * _e2841.v2_.z)) + (_e2966.w * 1f));
            let _e2990 = (((_e2863 * _e2835) + (_e2907 * _e2829.u)) + (_e2951 * _e2829.v));
            let _e2991 = (((_e2876 * _e2835) + (_e2920 * _e2829.u)) + (_e2964 * _e2829.v));
            let _e2992 = (((_e2889 * _e2835) + (_e2933 * _e2829.u)) + (_e2977 * _e2829.v));
            let _e2994 = abs(_e2863);
            let _e2995 = abs(_e2876);
            let _e2996 = abs(_e2889);
            let _e2997 = abs(_e2907);
            let _e2998 = abs(_e2920);
            let _e2999 = abs(_e2933);
            if (_e2994 > _e2997) {
                phi_3686_ = _e2994;
            } else {
                phi_3686_ = _e2997;
            }
            let _e3002 = phi_3686_;
            if (_e2995 > _e2998) {
                phi_3691_ = _e2995;
            } else {
                phi_3691_ = _e2998;
            }
            let _e3005 = phi_3691_;
            if (_e2996 > _e2999) {
                phi_3696_ = _e2996;
            } else {
                phi_3696_ = _e2999;
            }
            let _e3008 = phi_3696_;
            let _e3009 = abs(_e2951);
            let _e3010 = abs(_e2964);
            let _e3011 = abs(_e2977);
            if (_e3002 > _e3009) {
                phi_3704_ = _e3002;
            } else {
                phi_3704_ = _e3009;
            }
            let _e3014 = phi_3704_;
            if (_e3005 > _e3010) {
                phi_3709_ = _e3005;
            } else {
                phi_3709_ = _e3010;
            }
            let _e3017 = phi_3709_;
            if (_e3008 > _e3011) {
                phi_3714_ = _e3008;
            } else {
                phi_3714_ = _e3011;
            }
            let _e3020 = phi_3714_;
            let _e3021 = (_e2907 - _e2863);
            let _e3022 = (_e2920 - _e2876);
            let _e3023 = (_e2933 - _e2889);
            let _e3024 = (_e2951 - _e2863);
            let _e3025 = (_e2964 - _e2876);
            let _e3026 = (_e2977 - _e2889);
            let _e3030 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3022), abs(_e3023));
            let _e3031 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3021), _e3030);
            let _e3032 = (_e3021 / _e3031);
            let _e3033 = (_e3022 / _e3031);
            let _e3034 = (_e3023 / _e3031);
            let _e3038 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3025), abs(_e3026));
            let _e3039 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3024), _e3038);
            let _e3040 = (_e3024 / _e3039);
            let _e3041 = (_e3025 / _e3039);
            let _e3042 = (_e3026 / _e3039);
            let _e3045 = ((_e3033 * _e3042) - (_e3041 * _e3034));
            let _e3048 = ((_e3034 * _e3040) - (_e3042 * _e3032));
            let _e3051 = ((_e3032 * _e3041) - (_e3040 * _e3033));
            let _e3053 = p.member.eye;
            let _e3066 = (1f / sqrt((((_e3045 * _e3045) + (_e3048 * _e3048)) + (_e3051 * _e3051))));
            let _e3067 = (_e3045 * _e3066);
            let _e3068 = (_e3048 * _e3066);
            let _e3069 = (_e3051 * _e3066);
            if ((((_e3067 * (_e3053.x - _e2990)) + (_e3068 * (_e3053.y - _e2991))) + (_e3069 * (_e3053.z - _e2992))) < 0f) {
                phi_3778_ = vec3<f32>(-(_e3067), -(_e3068), -(_e3069));
            } else {
                phi_3778_ = vec3<f32>(_e3067, _e3068, _e3069);
            }
            let _e3082 = phi_3778_;
            if (_e2829.triangle < _e80) {
            } else {
                return;
            }
            let _e3087 = triangles.member[(0u + _e2829.triangle)];
            let _e3089 = (_e3087.i0_ & 2147483647u);
            if (_e3089 < _e83) {
            } else {
                return;
            }
            let _e3095 = vertices.member[(0u + _e3089)];
            if (_e3087.i1_ < _e83) {
            } else {
                return;
            }
            let _e3099 = vertices.member[(0u + _e3087.i1_)];
            if (_e3087.i2_ < _e83) {
            } else {
                return;
            }
            let _e3103 = vertices.member[(0u + _e3087.i2_)];
            let _e3104 = array<abi_Vertex, 3>(_e3095, _e3099, _e3103);
            if (_e3104[0].material < _e86) {
            } else {
                return;
            }
            let _e3110 = materials.member[(0u + _e3104[0].material)];
            let _e3127 = (1f / 255f);
            let _e3146 = (1f / 255f);
            let _e3168 = (1f / 255f);
            let _e3181 = _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(vec3<f32>(_e2835, _e2829.u, _e2829.v));
            let _e3183 = ((_e3110.base_color.x * ((((f32((_e3104[0].color & 255u)) * _e3127) * _e2835) + ((f32((_e3104[1].color & 255u)) * _e3146) * _e2829.u)) + ((f32((_e3104[2].color & 255u)) * _e3168) * _e2829.v))) * _e3181.x);
            let _e3185 = ((_e3110.base_color.y * ((((f32(((_e3104[0].color >> bitcast<u32>(8i)) & 255u)) * _e3127) * _e2835) + ((f32(((_e3104[1].color >> bitcast<u32>(8i)) & 255u)) * _e3146) * _e2829.u)) + ((f32(((_e3104[2].color >> bitcast<u32>(8i)) & 255u)) * _e3168) * _e2829.v))) * _e3181.y);
            let _e3187 = ((_e3110.base_color.z * ((((f32(((_e3104[0].color >> bitcast<u32>(16i)) & 255u)) * _e3127) * _e2835) + ((f32(((_e3104[1].color >> bitcast<u32>(16i)) & 255u)) * _e3146) * _e2829.u)) + ((f32(((_e3104[2].color >> bitcast<u32>(16i)) & 255u)) * _e3168) * _e2829.v))) * _e3181.z);
            let _e3188 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e3017, _e3020);
            let _e3189 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e3014, _e3188);
            if ((_e3110.flags & 2u) == 0u) {
                phi_3899_ = 0u;
            } else {
                phi_3899_ = 1u;
            }
            let _e3194 = phi_3899_;
            if (_e3104[0].normal == 2147516416u) {
                phi_4129_ = _e3082;
            } else {
                let _e3207 = (f32((bitcast<i32>((_e3104[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3213 = (f32((bitcast<i32>(_e3104[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3217 = ((1f - abs(_e3207)) - abs(_e3213));
                if (_e3217 < 0f) {
                    phi_3926_ = -(_e3217);
                } else {
                    phi_3926_ = 0f;
                }
                let _e3221 = phi_3926_;
                if (_e3207 < 0f) {
                    phi_3933_ = (_e3207 + _e3221);
                } else {
                    phi_3933_ = (_e3207 - _e3221);
                }
                let _e3226 = phi_3933_;
                if (_e3213 < 0f) {
                    phi_3940_ = (_e3213 + _e3221);
                } else {
                    phi_3940_ = (_e3213 - _e3221);
                }
                let _e3231 = phi_3940_;
                let _e3238 = (1f / sqrt((((_e3226 * _e3226) + (_e3231 * _e3231)) + (_e3217 * _e3217))));
                let _e3254 = (f32((bitcast<i32>((_e3104[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3260 = (f32((bitcast<i32>(_e3104[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3264 = ((1f - abs(_e3254)) - abs(_e3260));
                if (_e3264 < 0f) {
                    phi_3975_ = -(_e3264);
                } else {
                    phi_3975_ = 0f;
                }
                let _e3268 = phi_3975_;
                if (_e3254 < 0f) {
                    phi_3982_ = (_e3254 + _e3268);
                } else {
                    phi_3982_ = (_e3254 - _e3268);
                }
                let _e3273 = phi_3982_;
                if (_e3260 < 0f) {
                    phi_3989_ = (_e3260 + _e3268);
                } else {
                    phi_3989_ = (_e3260 - _e3268);
                }
                let _e3278 = phi_3989_;
                let _e3285 = (1f / sqrt((((_e3273 * _e3273) + (_e3278 * _e3278)) + (_e3264 * _e3264))));
                let _e3304 = (f32((bitcast<i32>((_e3104[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3310 = (f32((bitcast<i32>(_e3104[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3314 = ((1f - abs(_e3304)) - abs(_e3310));
                if (_e3314 < 0f) {
                    phi_4027_ = -(_e3314);
                } else {
                    phi_4027_ = 0f;
                }
                let _e3318 = phi_4027_;
                if (_e3304 < 0f) {
                    phi_4034_ = (_e3304 + _e3318);
                } else {
                    phi_4034_ = (_e3304 - _e3318);
                }
                let _e3323 = phi_4034_;
                if (_e3310 < 0f) {
                    phi_4041_ = (_e3310 + _e3318);
                } else {
                    phi_4041_ = (_e3310 - _e3318);
                }
                let _e3328 = phi_4041_;
                let _e3335 = (1f / sqrt((((_e3323 * _e3323) + (_e3328 * _e3328)) + (_e3314 * _e3314))));
                let _e3342 = ((((_e3226 * _e3238) * _e2835) + ((_e3273 * _e3285) * _e2829.u)) + ((_e3323 * _e3335) * _e2829.v));
                let _e3343 = ((((_e3231 * _e3238) * _e2835) + ((_e3278 * _e3285) * _e2829.u)) + ((_e3328 * _e3335) * _e2829.v));
                let _e3344 = ((((_e3217 * _e3238) * _e2835) + ((_e3264 * _e3285) * _e2829.u)) + ((_e3314 * _e3335) * _e2829.v));
                if (_e2829.instance < _e92) {
                } else {
                    return;
                }
                let _e3351 = instances.member[(0u + _e2829.instance)].world_to_object[0u];
                let _e3360 = instances.member[(0u + _e2829.instance)].world_to_object[1u];
                let _e3372 = instances.member[(0u + _e2829.instance)].world_to_object[2u];
                let _e3379 = (((_e3351.x * _e3342) + (_e3360.x * _e3343)) + (_e3372.x * _e3344));
                let _e3380 = (((_e3351.y * _e3342) + (_e3360.y * _e3343)) + (_e3372.y * _e3344));
                let _e3381 = (((_e3351.z * _e3342) + (_e3360.z * _e3343)) + (_e3372.z * _e3344));
                let _e3387 = sqrt((((_e3379 * _e3379) + (_e3380 * _e3380)) + (_e3381 * _e3381)));
                if (_e3387 > 0f) {
                    let _e3389 = (_e3379 / _e3387);
                    let _e3390 = (_e3380 / _e3387);
                    let _e3391 = (_e3381 / _e3387);
                    if ((((_e3389 * _e3082.x) + (_e3390 * _e3082.y)) + (_e3391 * _e3082.z)) < 0f) {
                        phi_4127_ = vec3<f32>(-(_e3389), -(_e3390), -(_e3391));
                    } else {
                        phi_4127_ = vec3<f32>(_e3389, _e3390, _e3391);
                    }
                    let _e3407 = phi_4127_;
                    phi_4128_ = _e3407;
                } else {
                    phi_4128_ = _e3082;
                }
                let _e3409 = phi_4128_;
                phi_4129_ = _e3409;
            }
            let _e3411 = phi_4129_;
            if (_e3183 > 0f) {
                if (_e3183 < 1f) {
                    phi_4138_ = _e3183;
                } else {
                    phi_4138_ = 1f;
                }
                let _e3415 = phi_4138_;
                phi_4139_ = _e3415;
            } else {
                phi_4139_ = 0f;
            }
            let _e3417 = phi_4139_;
            if (_e3185 > 0f) {
                if (_e3185 < 1f) {
                    phi_4149_ = _e3185;
                } else {
                    phi_4149_ = 1f;
                }
                let _e3422 = phi_4149_;
                phi_4150_ = _e3422;
            } else {
                phi_4150_ = 0f;
            }
            let _e3424 = phi_4150_;
            if (_e3187 > 0f) {
                if (_e3187 < 1f) {
                    phi_4160_ = _e3187;
                } else {
                    phi_4160_ = 1f;
                }
                let _e3429 = phi_4160_;
                phi_4161_ = _e3429;
            } else {
                phi_4161_ = 0f;
            }
            let _e3431 = phi_4161_;
            let _e3434 = ((sqrt(_e3417) * 255f) + 0.5f);
            let _e3443 = ((sqrt(_e3424) * 255f) + 0.5f);
            let _e3455 = ((sqrt(_e3431) * 255f) + 0.5f);
            phi_4196_ = abi_Sample(vec3<f32>(_e2990, _e2991, _e2992), _e3189, _e3082, _e3194, _e3411, ((select(select(u32(_e3434), 0u, (_e3434 < bitcast<f32>(0u))), 4294967295u, (_e3434 > bitcast<f32>(1333788671u))) | (select(select(u32(_e3443), 0u, (_e3443 < bitcast<f32>(0u))), 4294967295u, (_e3443 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e3455), 0u, (_e3455 < bitcast<f32>(0u))), 4294967295u, (_e3455 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_4196_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e3469 = phi_4196_;
        if (_e101.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e101.first_primitive)] = _e3469;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_instanced_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
