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

struct type_28 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_32 {
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

struct type_36 {
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

struct type_47 {
    member: array<lt_bvh_Instance>,
}

struct lt_bvh_traverse_Stack {
    first: array<u32, 32>,
    mask: array<u32, 32>,
    len: u32,
    group: u32,
    group_mask: u32,
}

struct type_53 {
    member: abi_CameraParams,
}

struct lt_bvh_Node {
    frame: vec4<u32>,
    links: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    z: vec4<u32>,
}

struct type_58 {
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
var<storage> vertices: type_32;
@group(0) @binding(4) 
var<storage> materials: type_36;
@group(0) @binding(0) 
var<uniform> p: type_53;
@group(0) @binding(1) 
var<storage> nodes: type_58;
@group(0) @binding(2) 
var<storage> triangles: type_28;
@group(0) @binding(5) 
var<storage, read_write> samples: type_9;
@group(0) @binding(6) 
var<storage> instances: type_47;
@group(0) @binding(7) 
var<storage> alpha_texels: type_13;
@group(0) @binding(8) 
var<storage> color_texels: type_13;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_222_: lt_bvh_traverse_Tree;
    var phi_223_: bool;
    var phi_224_: lt_bvh_traverse_Tree;
    var phi_225_: bool;
    var phi_230_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_222_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_223_ = false;
        } else {
            phi_222_ = lt_bvh_traverse_Tree();
            phi_223_ = true;
        }
        let _e83 = phi_222_;
        let _e85 = phi_223_;
        phi_224_ = _e83;
        phi_225_ = _e85;
    } else {
        phi_224_ = lt_bvh_traverse_Tree();
        phi_225_ = true;
    }
    let _e87 = phi_224_;
    let _e89 = phi_225_;
    if _e89 {
        phi_230_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_230_ = _e87;
    }
    let _e94 = phi_230_;
    return lt_bvh_traverse_Tree(_e94.root, _e94.first_primitive);
}

fn _lt_shaders_texture_TextureView_quad(param_3: ptr<function, texture_TextureView>, param_4: f32, param_5: f32) -> texture_TexelQuad {
    var phi_275_: f32;
    var phi_280_: f32;
    var phi_281_: bool;
    var phi_282_: f32;
    var phi_283_: bool;
    var phi_287_: f32;
    var phi_313_: f32;
    var phi_318_: f32;
    var phi_319_: bool;
    var phi_320_: f32;
    var phi_321_: bool;
    var phi_325_: f32;
    var phi_333_: f32;
    var phi_334_: f32;
    var phi_335_: f32;
    var phi_344_: f32;
    var phi_345_: f32;
    var phi_363_: u32;
    var phi_377_: u32;
    var phi_384_: u32;
    var phi_389_: u32;
    var phi_395_: u32;
    var phi_400_: u32;
    var phi_402_: texture_Axis;
    var phi_430_: f32;
    var phi_435_: f32;
    var phi_436_: bool;
    var phi_437_: f32;
    var phi_438_: bool;
    var phi_442_: f32;
    var phi_468_: f32;
    var phi_473_: f32;
    var phi_474_: bool;
    var phi_475_: f32;
    var phi_476_: bool;
    var phi_480_: f32;
    var phi_488_: f32;
    var phi_489_: f32;
    var phi_490_: f32;
    var phi_499_: f32;
    var phi_500_: f32;
    var phi_518_: u32;
    var phi_532_: u32;
    var phi_539_: u32;
    var phi_544_: u32;
    var phi_550_: u32;
    var phi_555_: u32;
    var phi_557_: texture_Axis;

    let _e74 = (*param_3).size;
    let _e75 = (_e74 & 65535u);
    let _e77 = (*param_3).size;
    let _e79 = (_e77 >> bitcast<u32>(16i));
    let _e81 = (*param_3).flags;
    let _e83 = ((_e81 & 4u) != 0u);
    let _e85 = (*param_3).flags;
    let _e88 = ((_e85 >> bitcast<u32>(4u)) & 3u);
    if (_e88 == 0u) {
        if (param_4 > -8388608f) {
            let _e101 = f32(select(0i, select(select(i32(param_4), i32(-2147483648), (param_4 < bitcast<f32>(3472883712u))), 2147483647i, (param_4 > bitcast<f32>(1325400063u))), (param_4 == param_4)));
            if (_e101 > param_4) {
                phi_275_ = 1f;
            } else {
                phi_275_ = 0f;
            }
            let _e104 = phi_275_;
            if (param_4 < 8388608f) {
                phi_280_ = (_e101 - _e104);
                phi_281_ = false;
            } else {
                phi_280_ = f32();
                phi_281_ = true;
            }
            let _e107 = phi_280_;
            let _e109 = phi_281_;
            phi_282_ = _e107;
            phi_283_ = _e109;
        } else {
            phi_282_ = f32();
            phi_283_ = true;
        }
        let _e111 = phi_282_;
        let _e113 = phi_283_;
        if _e113 {
            phi_287_ = param_4;
        } else {
            phi_287_ = _e111;
        }
        let _e115 = phi_287_;
        phi_335_ = (param_4 - _e115);
    } else {
        if (_e88 == 1u) {
            let _e118 = (param_4 * 0.5f);
            if (_e118 > -8388608f) {
                let _e130 = f32(select(0i, select(select(i32(_e118), i32(-2147483648), (_e118 < bitcast<f32>(3472883712u))), 2147483647i, (_e118 > bitcast<f32>(1325400063u))), (_e118 == _e118)));
                if (_e130 > _e118) {
                    phi_313_ = 1f;
                } else {
                    phi_313_ = 0f;
                }
                let _e133 = phi_313_;
                if (_e118 < 8388608f) {
                    phi_318_ = (_e130 - _e133);
                    phi_319_ = false;
                } else {
                    phi_318_ = f32();
                    phi_319_ = true;
                }
                let _e136 = phi_318_;
                let _e138 = phi_319_;
                phi_320_ = _e136;
                phi_321_ = _e138;
            } else {
                phi_320_ = f32();
                phi_321_ = true;
            }
            let _e140 = phi_320_;
            let _e142 = phi_321_;
            if _e142 {
                phi_325_ = _e118;
            } else {
                phi_325_ = _e140;
            }
            let _e144 = phi_325_;
            let _e146 = (param_4 - (2f * _e144));
            if (_e146 > 1f) {
                phi_333_ = (2f - _e146);
            } else {
                phi_333_ = _e146;
            }
            let _e150 = phi_333_;
            phi_334_ = _e150;
        } else {
            phi_334_ = param_4;
        }
        let _e152 = phi_334_;
        phi_335_ = _e152;
    }
    let _e154 = phi_335_;
    if (_e154 > 0f) {
        if (_e154 < 1f) {
            phi_344_ = _e154;
        } else {
            phi_344_ = 1f;
        }
        let _e158 = phi_344_;
        phi_345_ = _e158;
    } else {
        phi_345_ = 0f;
    }
    let _e160 = phi_345_;
    let _e161 = (_e75 - 1u);
    let _e163 = (_e160 * f32(_e75));
    if _e83 {
        let _e170 = select(select(u32(_e163), 0u, (_e163 < bitcast<f32>(0u))), 4294967295u, (_e163 > bitcast<f32>(1333788671u)));
        if (_e161 < _e170) {
            phi_363_ = _e161;
        } else {
            phi_363_ = _e170;
        }
        let _e173 = phi_363_;
        phi_402_ = texture_Axis(_e173, _e173, 0f);
    } else {
        let _e175 = (_e163 + 0.5f);
        let _e182 = select(select(u32(_e175), 0u, (_e175 < bitcast<f32>(0u))), 4294967295u, (_e175 > bitcast<f32>(1333788671u)));
        if (_e75 < _e182) {
            phi_377_ = _e75;
        } else {
            phi_377_ = _e182;
        }
        let _e185 = phi_377_;
        if (_e88 == 0u) {
            phi_384_ = _e161;
        } else {
            phi_384_ = 0u;
        }
        let _e190 = phi_384_;
        if (_e88 == 0u) {
            phi_389_ = 0u;
        } else {
            phi_389_ = _e161;
        }
        let _e193 = phi_389_;
        if (_e185 == 0u) {
            phi_395_ = _e190;
        } else {
            phi_395_ = (_e185 - 1u);
        }
        let _e197 = phi_395_;
        if (_e185 > _e161) {
            phi_400_ = _e193;
        } else {
            phi_400_ = _e185;
        }
        let _e200 = phi_400_;
        phi_402_ = texture_Axis(_e197, _e200, (_e175 - f32(_e185)));
    }
    let _e203 = phi_402_;
    let _e205 = (*param_3).flags;
    let _e208 = ((_e205 >> bitcast<u32>(6u)) & 3u);
    if (_e208 == 0u) {
        if (param_5 > -8388608f) {
            let _e221 = f32(select(0i, select(select(i32(param_5), i32(-2147483648), (param_5 < bitcast<f32>(3472883712u))), 2147483647i, (param_5 > bitcast<f32>(1325400063u))), (param_5 == param_5)));
            if (_e221 > param_5) {
                phi_430_ = 1f;
            } else {
                phi_430_ = 0f;
            }
            let _e224 = phi_430_;
            if (param_5 < 8388608f) {
                phi_435_ = (_e221 - _e224);
                phi_436_ = false;
            } else {
                phi_435_ = f32();
                phi_436_ = true;
            }
            let _e227 = phi_435_;
            let _e229 = phi_436_;
            phi_437_ = _e227;
            phi_438_ = _e229;
        } else {
            phi_437_ = f32();
            phi_438_ = true;
        }
        let _e231 = phi_437_;
        let _e233 = phi_438_;
        if _e233 {
            phi_442_ = param_5;
        } else {
            phi_442_ = _e231;
        }
        let _e235 = phi_442_;
        phi_490_ = (param_5 - _e235);
    } else {
        if (_e208 == 1u) {
            let _e238 = (param_5 * 0.5f);
            if (_e238 > -8388608f) {
                let _e250 = f32(select(0i, select(select(i32(_e238), i32(-2147483648), (_e238 < bitcast<f32>(3472883712u))), 2147483647i, (_e238 > bitcast<f32>(1325400063u))), (_e238 == _e238)));
                if (_e250 > _e238) {
                    phi_468_ = 1f;
                } else {
                    phi_468_ = 0f;
                }
                let _e253 = phi_468_;
                if (_e238 < 8388608f) {
                    phi_473_ = (_e250 - _e253);
                    phi_474_ = false;
                } else {
                    phi_473_ = f32();
                    phi_474_ = true;
                }
                let _e256 = phi_473_;
                let _e258 = phi_474_;
                phi_475_ = _e256;
                phi_476_ = _e258;
            } else {
                phi_475_ = f32();
                phi_476_ = true;
            }
            let _e260 = phi_475_;
            let _e262 = phi_476_;
            if _e262 {
                phi_480_ = _e238;
            } else {
                phi_480_ = _e260;
            }
            let _e264 = phi_480_;
            let _e266 = (param_5 - (2f * _e264));
            if (_e266 > 1f) {
                phi_488_ = (2f - _e266);
            } else {
                phi_488_ = _e266;
            }
            let _e270 = phi_488_;
            phi_489_ = _e270;
        } else {
            phi_489_ = param_5;
        }
        let _e272 = phi_489_;
        phi_490_ = _e272;
    }
    let _e274 = phi_490_;
    if (_e274 > 0f) {
        if (_e274 < 1f) {
            phi_499_ = _e274;
        } else {
            phi_499_ = 1f;
        }
        let _e278 = phi_499_;
        phi_500_ = _e278;
    } else {
        phi_500_ = 0f;
    }
    let _e280 = phi_500_;
    let _e281 = (_e79 - 1u);
    let _e283 = (_e280 * f32(_e79));
    if _e83 {
        let _e290 = select(select(u32(_e283), 0u, (_e283 < bitcast<f32>(0u))), 4294967295u, (_e283 > bitcast<f32>(1333788671u)));
        if (_e281 < _e290) {
            phi_518_ = _e281;
        } else {
            phi_518_ = _e290;
        }
        let _e293 = phi_518_;
        phi_557_ = texture_Axis(_e293, _e293, 0f);
    } else {
        let _e295 = (_e283 + 0.5f);
        let _e302 = select(select(u32(_e295), 0u, (_e295 < bitcast<f32>(0u))), 4294967295u, (_e295 > bitcast<f32>(1333788671u)));
        if (_e79 < _e302) {
            phi_532_ = _e79;
        } else {
            phi_532_ = _e302;
        }
        let _e305 = phi_532_;
        if (_e208 == 0u) {
            phi_539_ = _e281;
        } else {
            phi_539_ = 0u;
        }
        let _e310 = phi_539_;
        if (_e208 == 0u) {
            phi_544_ = 0u;
        } else {
            phi_544_ = _e281;
        }
        let _e313 = phi_544_;
        if (_e305 == 0u) {
            phi_550_ = _e310;
        } else {
            phi_550_ = (_e305 - 1u);
        }
        let _e317 = phi_550_;
        if (_e305 > _e281) {
            phi_555_ = _e313;
        } else {
            phi_555_ = _e305;
        }
        let _e320 = phi_555_;
        phi_557_ = texture_Axis(_e317, _e320, (_e295 - f32(_e305)));
    }
    let _e323 = phi_557_;
    let _e327 = (*param_3).offset;
    let _e334 = (*param_3).offset;
    let _e341 = (*param_3).offset;
    let _e348 = (*param_3).offset;
    return texture_TexelQuad(array<u32, 4>(((_e327 + (_e323.low * _e75)) + _e203.low), ((_e334 + (_e323.low * _e75)) + _e203.high), ((_e341 + (_e323.high * _e75)) + _e203.low), ((_e348 + (_e323.high * _e75)) + _e203.high)), vec4<f32>(((1f - _e203.fraction) * (1f - _e323.fraction)), (_e203.fraction * (1f - _e323.fraction)), ((1f - _e203.fraction) * _e323.fraction), (_e203.fraction * _e323.fraction)));
}

fn _lt_bvh_ray_Ray_new(param_6: vec3<f32>, param_7: vec3<f32>) -> lt_bvh_Ray {
    return lt_bvh_Ray(param_6, 0f, param_7, 300000000000000000000000000000000000000f);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_8: f32, param_9: f32) -> f32 {
    var phi_620_: bool;
    var phi_624_: f32;

    if (param_8 != param_8) {
        phi_620_ = true;
    } else {
        let _e73 = (param_9 >= param_8);
        if _e73 {
        }
        phi_620_ = _e73;
    }
    let _e75 = phi_620_;
    if _e75 {
        phi_624_ = param_9;
    } else {
        phi_624_ = param_8;
    }
    let _e77 = phi_624_;
    return _e77;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_10: f32, param_11: f32) -> f32 {
    var phi_636_: bool;
    var phi_640_: f32;

    if (param_10 != param_10) {
        phi_636_ = true;
    } else {
        let _e73 = (param_11 <= param_10);
        if _e73 {
        }
        phi_636_ = _e73;
    }
    let _e75 = phi_636_;
    if _e75 {
        phi_640_ = param_11;
    } else {
        phi_640_ = param_10;
    }
    let _e77 = phi_640_;
    return _e77;
}

fn _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(param_12: f32, param_13: f32) -> f32 {
    var phi_648_: f32;

    if (param_12 > param_13) {
        phi_648_ = param_12;
    } else {
        phi_648_ = param_13;
    }
    let _e74 = phi_648_;
    return _e74;
}

fn function_() {
    var local: texture_TextureView;
    var local_1: texture_TextureView;
    var local_2: lt_bvh_traverse_Stack;
    var local_3: lt_bvh_traverse_Stack;
    var phi_809_: bool;
    var phi_810_: bool;
    var phi_811_: bool;
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
    var phi_828_: bool;
    var phi_829_: bool;
    var phi_830_: bool;
    var phi_831_: bool;
    var phi_832_: bool;
    var phi_836_: bool;
    var phi_840_: bool;
    var phi_915_: f32;
    var phi_922_: f32;
    var phi_930_: f32;
    var phi_937_: f32;
    var phi_945_: f32;
    var phi_952_: f32;
    var phi_977_: f32;
    var phi_982_: f32;
    var phi_987_: f32;
    var phi_1009_: u32;
    var phi_1014_: u32;
    var phi_1019_: u32;
    var phi_1133_: bool;
    var phi_1134_: bool;
    var phi_1165_: u32;
    var phi_1167_: u32;
    var phi_1170_: lt_bvh_Hit;
    var phi_1255_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1282_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1309_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1315_: u32;
    var phi_1318_: u32;
    var phi_1332_: u32;
    var phi_1342_: u32;
    var phi_1352_: u32;
    var phi_1370_: u32;
    var phi_1380_: u32;
    var phi_1390_: u32;
    var phi_1426_: u32;
    var phi_1439_: u32;
    var phi_1444_: u32;
    var phi_1445_: u32;
    var phi_1446_: u32;
    var phi_1316_: u32;
    var phi_1319_: u32;
    var local_4: u32;
    var local_5: u32;
    var local_6: u32;
    var phi_1504_: u32;
    var phi_1507_: lt_bvh_Hit;
    var phi_1562_: f32;
    var phi_1567_: f32;
    var phi_1572_: f32;
    var phi_1580_: f32;
    var phi_1585_: f32;
    var phi_1590_: f32;
    var phi_1746_: bool;
    var phi_1747_: bool;
    var phi_1748_: bool;
    var phi_1752_: bool;
    var phi_1753_: bool;
    var phi_1754_: bool;
    var phi_1755_: bool;
    var phi_1756_: bool;
    var phi_1757_: bool;
    var phi_1758_: bool;
    var phi_1759_: bool;
    var phi_1760_: bool;
    var phi_1761_: bool;
    var phi_1762_: bool;
    var phi_1763_: bool;
    var phi_1764_: bool;
    var phi_1765_: bool;
    var phi_1766_: bool;
    var phi_1767_: bool;
    var phi_1768_: bool;
    var phi_1769_: bool;
    var phi_1773_: bool;
    var phi_1777_: bool;
    var phi_1847_: f32;
    var phi_1854_: f32;
    var phi_1861_: f32;
    var phi_1868_: f32;
    var phi_1875_: f32;
    var phi_1882_: f32;
    var phi_1899_: f32;
    var phi_1904_: f32;
    var phi_1909_: f32;
    var phi_1937_: bool;
    var phi_1938_: bool;
    var phi_1946_: u32;
    var phi_1947_: u32;
    var phi_1958_: vec3<f32>;
    var phi_1959_: vec3<f32>;
    var phi_1972_: u32;
    var phi_1977_: u32;
    var phi_1982_: u32;
    var phi_2096_: bool;
    var phi_2097_: bool;
    var phi_2128_: u32;
    var phi_2130_: lt_bvh_Hit;
    var phi_2133_: u32;
    var phi_2214_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2241_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2268_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2274_: u32;
    var phi_2277_: u32;
    var phi_2291_: u32;
    var phi_2301_: u32;
    var phi_2311_: u32;
    var phi_2329_: u32;
    var phi_2339_: u32;
    var phi_2349_: u32;
    var phi_2385_: u32;
    var phi_2398_: u32;
    var phi_2403_: u32;
    var phi_2404_: u32;
    var phi_2405_: u32;
    var phi_2275_: u32;
    var phi_2278_: u32;
    var local_7: u32;
    var local_8: u32;
    var local_9: u32;
    var phi_2463_: lt_bvh_Hit;
    var phi_2466_: u32;
    var phi_2510_: vec3<f32>;
    var phi_2511_: vec3<f32>;
    var phi_2542_: vec3<f32>;
    var phi_2543_: vec3<f32>;
    var phi_2574_: vec3<f32>;
    var phi_2575_: vec3<f32>;
    var phi_2595_: bool;
    var phi_2596_: bool;
    var phi_2600_: f32;
    var phi_2601_: f32;
    var phi_2602_: f32;
    var phi_2603_: f32;
    var phi_2611_: f32;
    var phi_2621_: bool;
    var phi_2622_: bool;
    var phi_2626_: f32;
    var phi_2627_: f32;
    var phi_2628_: f32;
    var phi_2629_: f32;
    var phi_2637_: f32;
    var phi_2647_: bool;
    var phi_2648_: bool;
    var phi_2652_: f32;
    var phi_2653_: f32;
    var phi_2654_: f32;
    var phi_2655_: f32;
    var phi_2663_: f32;
    var phi_2678_: f32;
    var phi_2679_: bool;
    var phi_2680_: f32;
    var phi_2681_: bool;
    var phi_2682_: f32;
    var phi_2683_: bool;
    var phi_2701_: f32;
    var phi_2702_: bool;
    var phi_2703_: bool;
    var phi_2704_: f32;
    var phi_2705_: bool;
    var phi_2706_: bool;
    var phi_2710_: bool;
    var phi_2711_: f32;
    var phi_2712_: bool;
    var phi_2746_: f32;
    var phi_2755_: f32;
    var phi_2764_: f32;
    var phi_2773_: f32;
    var phi_2780_: f32;
    var phi_2787_: f32;
    var phi_2800_: f32;
    var phi_2809_: f32;
    var phi_2818_: f32;
    var phi_2827_: f32;
    var phi_2834_: f32;
    var phi_2841_: f32;
    var phi_2858_: f32;
    var phi_2863_: f32;
    var phi_2868_: f32;
    var phi_2876_: f32;
    var phi_2881_: f32;
    var phi_2886_: f32;
    var phi_2898_: f32;
    var phi_2903_: f32;
    var phi_2908_: f32;
    var phi_2913_: f32;
    var phi_2918_: lt_bvh_triangle_Intersection;
    var phi_2919_: bool;
    var phi_2920_: lt_bvh_triangle_Intersection;
    var phi_2921_: bool;
    var phi_2925_: lt_bvh_triangle_Intersection;
    var phi_2926_: bool;
    var phi_2927_: lt_bvh_triangle_Intersection;
    var phi_2928_: bool;
    var phi_2929_: bool;
    var phi_2933_: bool;
    var phi_2937_: lt_bvh_triangle_Intersection;
    var phi_2975_: bool;
    var phi_2976_: bool;
    var phi_2977_: bool;
    var phi_2978_: bool;
    var phi_2979_: bool;
    var phi_2980_: bool;
    var phi_2984_: bool;
    var phi_2985_: bool;
    var phi_3188_: f32;
    var phi_3191_: bool;
    var phi_3192_: bool;
    var phi_3196_: bool;
    var phi_3204_: lt_bvh_Hit;
    var phi_3205_: lt_bvh_Hit;
    var phi_3206_: lt_bvh_Hit;
    var phi_3207_: lt_bvh_Hit;
    var phi_2464_: lt_bvh_Hit;
    var phi_2467_: u32;
    var phi_3208_: bool;
    var phi_3247_: bool;
    var phi_3248_: bool;
    var phi_3279_: u32;
    var phi_2131_: lt_bvh_Hit;
    var phi_2134_: u32;
    var phi_3280_: lt_bvh_Hit;
    var phi_3281_: lt_bvh_Hit;
    var phi_3282_: bool;
    var phi_3286_: lt_bvh_Hit;
    var phi_3287_: lt_bvh_Hit;
    var phi_3288_: lt_bvh_Hit;
    var phi_3289_: lt_bvh_Hit;
    var phi_1505_: u32;
    var phi_1508_: lt_bvh_Hit;
    var phi_3290_: bool;
    var phi_3329_: bool;
    var phi_3330_: bool;
    var phi_3361_: u32;
    var phi_1168_: u32;
    var phi_1171_: lt_bvh_Hit;
    var phi_3362_: lt_bvh_Hit;
    var phi_3363_: lt_bvh_Hit;
    var phi_3364_: bool;
    var phi_3368_: lt_bvh_Hit;
    var phi_3555_: f32;
    var phi_3560_: f32;
    var phi_3565_: f32;
    var phi_3573_: f32;
    var phi_3578_: f32;
    var phi_3583_: f32;
    var phi_3647_: vec3<f32>;
    var phi_3890_: vec3<f32>;
    var phi_3905_: u32;
    var phi_3932_: f32;
    var phi_3939_: f32;
    var phi_3946_: f32;
    var phi_3981_: f32;
    var phi_3988_: f32;
    var phi_3995_: f32;
    var phi_4033_: f32;
    var phi_4040_: f32;
    var phi_4047_: f32;
    var phi_4133_: vec3<f32>;
    var phi_4134_: vec3<f32>;
    var phi_4135_: vec3<f32>;
    var phi_4144_: f32;
    var phi_4145_: f32;
    var phi_4155_: f32;
    var phi_4156_: f32;
    var phi_4166_: f32;
    var phi_4167_: f32;
    var phi_4202_: abi_Sample;
    var local_10: lt_bvh_Hit;
    var local_11: lt_bvh_Hit;
    var local_12: lt_bvh_Hit;
    var local_13: lt_bvh_Hit;

    let _e74 = id_1;
    let _e78 = arrayLength((&nodes.member));
    let _e81 = arrayLength((&triangles.member));
    let _e84 = arrayLength((&vertices.member));
    let _e87 = arrayLength((&materials.member));
    let _e93 = arrayLength((&instances.member));
    let _e96 = arrayLength((&alpha_texels.member));
    let _e99 = arrayLength((&color_texels.member));
    let _e102 = p.member.size[0u];
    let _e104 = p.member.size[1u];
    let _e105 = lt_shaders_entry_pixel_index(_e74, _e102, _e104);
    if (bitcast<i32>(_e105.root) != 0i) {
        let _e111 = p.member.root;
        let _e115 = p.member.eye;
        let _e120 = p.member.size[0u];
        let _e124 = ((((f32(_e74.x) + 0.5f) / f32(_e120)) * 2f) - 1f);
        let _e129 = p.member.size[1u];
        let _e133 = (1f - (((f32(_e74.y) + 0.5f) / f32(_e129)) * 2f));
        let _e135 = p.member.forward;
        let _e137 = p.member.right;
        let _e151 = p.member.up;
        let _e162 = _lt_bvh_ray_Ray_new(_e115, vec3<f32>(((_e135.x + (_e137.x * _e124)) + (_e151.x * _e133)), ((_e135.y + (_e137.y * _e124)) + (_e151.y * _e133)), ((_e135.z + (_e137.z * _e124)) + (_e151.z * _e133))));
        let _e164 = lt_bvh_Hit(_e162.tmax, 0f, 0f, 4294967295u, 4294967295u);
        let _e174 = abs(_e162.direction.x);
        let _e176 = abs(_e162.direction.y);
        let _e178 = abs(_e162.direction.z);
        if (abs(_e162.origin.x) < 1000000000000000f) {
            if (abs(_e162.origin.y) < 1000000000000000f) {
                if (abs(_e162.origin.z) < 1000000000000000f) {
                    if (_e174 < 1000000000000000f) {
                        if (_e176 < 1000000000000000f) {
                            if (_e178 < 1000000000000000f) {
                                if (_e174 > 0f) {
                                    phi_810_ = bool();
                                    phi_811_ = true;
                                } else {
                                    let _e186 = (_e176 > 0f);
                                    if _e186 {
                                        phi_809_ = bool();
                                    } else {
                                        phi_809_ = (_e178 > 0f);
                                    }
                                    let _e189 = phi_809_;
                                    phi_810_ = _e189;
                                    phi_811_ = _e186;
                                }
                                let _e191 = phi_810_;
                                let _e193 = phi_811_;
                                if _e193 {
                                    phi_815_ = true;
                                } else {
                                    phi_815_ = _e191;
                                }
                                let _e195 = phi_815_;
                                phi_816_ = _e195;
                                phi_817_ = false;
                            } else {
                                phi_816_ = bool();
                                phi_817_ = true;
                            }
                            let _e197 = phi_816_;
                            let _e199 = phi_817_;
                            phi_818_ = _e197;
                            phi_819_ = false;
                            phi_820_ = _e199;
                        } else {
                            phi_818_ = bool();
                            phi_819_ = true;
                            phi_820_ = false;
                        }
                        let _e201 = phi_818_;
                        let _e203 = phi_819_;
                        let _e205 = phi_820_;
                        phi_821_ = _e201;
                        phi_822_ = _e203;
                        phi_823_ = _e205;
                    } else {
                        phi_821_ = bool();
                        phi_822_ = true;
                        phi_823_ = false;
                    }
                    let _e207 = phi_821_;
                    let _e209 = phi_822_;
                    let _e211 = phi_823_;
                    phi_824_ = _e207;
                    phi_825_ = _e209;
                    phi_826_ = _e211;
                } else {
                    phi_824_ = bool();
                    phi_825_ = true;
                    phi_826_ = false;
                }
                let _e213 = phi_824_;
                let _e215 = phi_825_;
                let _e217 = phi_826_;
                phi_827_ = _e213;
                phi_828_ = _e215;
                phi_829_ = _e217;
            } else {
                phi_827_ = bool();
                phi_828_ = true;
                phi_829_ = false;
            }
            let _e219 = phi_827_;
            let _e221 = phi_828_;
            let _e223 = phi_829_;
            phi_830_ = _e219;
            phi_831_ = _e221;
            phi_832_ = _e223;
        } else {
            phi_830_ = bool();
            phi_831_ = true;
            phi_832_ = false;
        }
        let _e225 = phi_830_;
        let _e227 = phi_831_;
        let _e229 = phi_832_;
        if _e227 {
            phi_836_ = true;
        } else {
            phi_836_ = _e229;
        }
        let _e231 = phi_836_;
        if _e231 {
            phi_840_ = false;
        } else {
            phi_840_ = _e225;
        }
        let _e233 = phi_840_;
        if _e233 {
            let _e234 = (_e111 >= _e78);
            if _e234 {
                phi_3362_ = lt_bvh_Hit();
            } else {
                if (_e111 < _e78) {
                } else {
                    return;
                }
                let _e240 = nodes.member[(0u + _e111)].frame[0u];
                let _e244 = nodes.member[(0u + _e111)].frame[1u];
                let _e248 = nodes.member[(0u + _e111)].frame[2u];
                let _e252 = nodes.member[(0u + _e111)].frame[0u];
                let _e256 = nodes.member[(0u + _e111)].frame[1u];
                let _e260 = nodes.member[(0u + _e111)].frame[2u];
                let _e264 = nodes.member[(0u + _e111)].frame[3u];
                let _e302 = core_intrinsics_maximum_number_nsz_f32_(abs(_e162.direction.x), abs(_e162.direction.y));
                let _e303 = core_intrinsics_maximum_number_nsz_f32_(_e302, abs(_e162.direction.z));
                let _e304 = (_e303 * 0.0000000000009094947f);
                if (abs(_e162.direction.x) < _e304) {
                    phi_915_ = _e304;
                } else {
                    phi_915_ = abs(_e162.direction.x);
                }
                let _e311 = phi_915_;
                if (_e162.direction.x < 0f) {
                    phi_922_ = (-1f / _e311);
                } else {
                    phi_922_ = (1f / _e311);
                }
                let _e316 = phi_922_;
                if (abs(_e162.direction.y) < _e304) {
                    phi_930_ = _e304;
                } else {
                    phi_930_ = abs(_e162.direction.y);
                }
                let _e323 = phi_930_;
                if (_e162.direction.y < 0f) {
                    phi_937_ = (-1f / _e323);
                } else {
                    phi_937_ = (1f / _e323);
                }
                let _e328 = phi_937_;
                if (abs(_e162.direction.z) < _e304) {
                    phi_945_ = _e304;
                } else {
                    phi_945_ = abs(_e162.direction.z);
                }
                let _e335 = phi_945_;
                if (_e162.direction.z < 0f) {
                    phi_952_ = (-1f / _e335);
                } else {
                    phi_952_ = (1f / _e335);
                }
                let _e340 = phi_952_;
                let _e348 = abs((bitcast<f32>(_e240) - _e162.origin.x));
                let _e349 = abs((bitcast<f32>(_e244) - _e162.origin.y));
                let _e350 = abs((bitcast<f32>(_e248) - _e162.origin.z));
                let _e358 = abs(((bitcast<f32>(_e252) + (bitcast<f32>((((_e264 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e162.origin.x));
                let _e359 = abs(((bitcast<f32>(_e256) + (bitcast<f32>((((_e264 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e162.origin.y));
                let _e360 = abs(((bitcast<f32>(_e260) + (bitcast<f32>((((_e264 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e162.origin.z));
                if (_e348 > _e358) {
                    phi_977_ = _e348;
                } else {
                    phi_977_ = _e358;
                }
                let _e363 = phi_977_;
                if (_e349 > _e359) {
                    phi_982_ = _e349;
                } else {
                    phi_982_ = _e359;
                }
                let _e366 = phi_982_;
                if (_e350 > _e360) {
                    phi_987_ = _e350;
                } else {
                    phi_987_ = _e360;
                }
                let _e369 = phi_987_;
                let _e370 = core_intrinsics_maximum_number_nsz_f32_(_e363, _e366);
                let _e371 = core_intrinsics_maximum_number_nsz_f32_(_e370, _e369);
                let _e376 = (_e371 * 0.0000019073486f);
                let _e377 = (abs(_e316) * _e376);
                let _e378 = (abs(_e328) * _e376);
                let _e379 = (abs(_e340) * _e376);
                let _e383 = (_e371 * 0.0000009536743f);
                let _e384 = (abs(_e316) * _e383);
                let _e385 = (abs(_e328) * _e383);
                let _e386 = (abs(_e340) * _e383);
                if (_e316 < 0f) {
                    phi_1009_ = 0u;
                } else {
                    phi_1009_ = 1u;
                }
                let _e389 = phi_1009_;
                if (_e328 < 0f) {
                    phi_1014_ = 0u;
                } else {
                    phi_1014_ = 2u;
                }
                let _e392 = phi_1014_;
                if (_e340 < 0f) {
                    phi_1019_ = 0u;
                } else {
                    phi_1019_ = 4u;
                }
                let _e395 = phi_1019_;
                let _e397 = ((_e389 | _e392) | _e395);
                let _e398 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e111, 2147483648u);
                local_3 = lt_bvh_traverse_Stack(array<u32, 32>(_e398.first[0], _e398.first[1], _e398.first[2], _e398.first[3], _e398.first[4], _e398.first[5], _e398.first[6], _e398.first[7], _e398.first[8], _e398.first[9], _e398.first[10], _e398.first[11], _e398.first[12], _e398.first[13], _e398.first[14], _e398.first[15], _e398.first[16], _e398.first[17], _e398.first[18], _e398.first[19], _e398.first[20], _e398.first[21], _e398.first[22], _e398.first[23], _e398.first[24], _e398.first[25], _e398.first[26], _e398.first[27], _e398.first[28], _e398.first[29], _e398.first[30], _e398.first[31]), array<u32, 32>(_e398.mask[0], _e398.mask[1], _e398.mask[2], _e398.mask[3], _e398.mask[4], _e398.mask[5], _e398.mask[6], _e398.mask[7], _e398.mask[8], _e398.mask[9], _e398.mask[10], _e398.mask[11], _e398.mask[12], _e398.mask[13], _e398.mask[14], _e398.mask[15], _e398.mask[16], _e398.mask[17], _e398.mask[18], _e398.mask[19], _e398.mask[20], _e398.mask[21], _e398.mask[22], _e398.mask[23], _e398.mask[24], _e398.mask[25], _e398.mask[26], _e398.mask[27], _e398.mask[28], _e398.mask[29], _e398.mask[30], _e398.mask[31]), _e398.len, _e398.group, _e398.group_mask);
                let _e472 = local_3.group_mask;
                if ((_e472 & 4278190080u) == 0u) {
                    let _e476 = local_3.len;
                    if (_e476 == 0u) {
                        phi_1133_ = false;
                    } else {
                        let _e480 = local_3.len;
                        local_3.len = (_e480 - 1u);
                        let _e483 = local_3.len;
                        if (_e483 < 32u) {
                        } else {
                            return;
                        }
                        let _e488 = local_3.first[(0u + _e483)];
                        local_3.group = _e488;
                        let _e491 = local_3.len;
                        if (_e491 < 32u) {
                        } else {
                            return;
                        }
                        let _e496 = local_3.mask[(0u + _e491)];
                        local_3.group_mask = _e496;
                        phi_1133_ = true;
                    }
                    let _e499 = phi_1133_;
                    phi_1134_ = _e499;
                } else {
                    phi_1134_ = true;
                }
                let _e501 = phi_1134_;
                if _e501 {
                    let _e503 = local_3.group_mask;
                    let _e509 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e503)), 32u, (_e503 == 0u)));
                    let _e513 = local_3.group_mask;
                    let _e527 = local_3.group_mask;
                    local_3.group_mask = (_e527 & ~((1u << bitcast<u32>((_e509 & 31u)))));
                    let _e530 = local_3.group;
                    phi_1165_ = (_e530 + countOneBits(((_e513 & ~((4294967295u << bitcast<u32>((((_e509 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1165_ = 4294967295u;
                }
                let _e533 = phi_1165_;
                phi_1167_ = _e533;
                phi_1170_ = _e164;
                loop {
                    let _e535 = phi_1167_;
                    let _e537 = phi_1170_;
                    local_13 = _e537;
                    let _e538 = (_e535 != 4294967295u);
                    if _e538 {
                        if (_e535 < _e78) {
                        } else {
                            return;
                        }
                        let _e546 = nodes.member[(0u + _e535)].frame[3u];
                        let _e571 = (bitcast<f32>((((_e546 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e316);
                        let _e572 = (bitcast<f32>((((_e546 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e328);
                        let _e573 = (bitcast<f32>((((_e546 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e340);
                        let _e576 = nodes.member[(0u + _e535)].frame[0u];
                        let _e580 = nodes.member[(0u + _e535)].frame[1u];
                        let _e584 = nodes.member[(0u + _e535)].frame[2u];
                        let _e592 = ((bitcast<f32>(_e576) - _e162.origin.x) * _e316);
                        let _e593 = ((bitcast<f32>(_e580) - _e162.origin.y) * _e328);
                        let _e594 = ((bitcast<f32>(_e584) - _e162.origin.z) * _e340);
                        let _e602 = nodes.member[(0u + _e535)].x;
                        if (_e316 < 0f) {
                            let _e613 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e602.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e619 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e613.unnamed.root, _e602.w), _e613.unnamed_1);
                            let _e625 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e619.unnamed, lt_bvh_traverse_Tree(_e602.x, _e619.unnamed_1.first_primitive));
                            phi_1255_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e625.unnamed, lt_bvh_traverse_Tree(_e625.unnamed_1.root, _e602.y));
                        } else {
                            let _e641 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e602.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e647 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e641.unnamed.root, _e602.y), _e641.unnamed_1);
                            let _e653 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e647.unnamed, lt_bvh_traverse_Tree(_e602.z, _e647.unnamed_1.first_primitive));
                            phi_1255_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e653.unnamed, lt_bvh_traverse_Tree(_e653.unnamed_1.root, _e602.w));
                        }
                        let _e661 = phi_1255_;
                        let _e671 = nodes.member[(0u + _e535)].y;
                        if (_e328 < 0f) {
                            let _e682 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e671.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e688 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e682.unnamed.root, _e671.w), _e682.unnamed_1);
                            let _e694 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e688.unnamed, lt_bvh_traverse_Tree(_e671.x, _e688.unnamed_1.first_primitive));
                            phi_1282_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e694.unnamed, lt_bvh_traverse_Tree(_e694.unnamed_1.root, _e671.y));
                        } else {
                            let _e710 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e671.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e716 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e710.unnamed.root, _e671.y), _e710.unnamed_1);
                            let _e722 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e716.unnamed, lt_bvh_traverse_Tree(_e671.z, _e716.unnamed_1.first_primitive));
                            phi_1282_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e722.unnamed, lt_bvh_traverse_Tree(_e722.unnamed_1.root, _e671.w));
                        }
                        let _e730 = phi_1282_;
                        let _e740 = nodes.member[(0u + _e535)].z;
                        if (_e340 < 0f) {
                            let _e751 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e740.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e757 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e751.unnamed.root, _e740.w), _e751.unnamed_1);
                            let _e763 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e757.unnamed, lt_bvh_traverse_Tree(_e740.x, _e757.unnamed_1.first_primitive));
                            phi_1309_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e763.unnamed, lt_bvh_traverse_Tree(_e763.unnamed_1.root, _e740.y));
                        } else {
                            let _e779 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e740.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e785 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e779.unnamed.root, _e740.y), _e779.unnamed_1);
                            let _e791 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e785.unnamed, lt_bvh_traverse_Tree(_e740.z, _e785.unnamed_1.first_primitive));
                            phi_1309_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e791.unnamed, lt_bvh_traverse_Tree(_e791.unnamed_1.root, _e740.w));
                        }
                        let _e799 = phi_1309_;
                        phi_1315_ = 0u;
                        phi_1318_ = 0u;
                        loop {
                            let _e809 = phi_1315_;
                            let _e811 = phi_1318_;
                            local_4 = _e811;
                            local_5 = _e811;
                            local_6 = _e811;
                            let _e812 = (_e809 < 8u);
                            if _e812 {
                                let _e814 = (_e809 >> bitcast<u32>(2i));
                                let _e815 = (_e809 & 3u);
                                if (_e814 == 0u) {
                                    phi_1332_ = _e661.unnamed.root;
                                } else {
                                    phi_1332_ = _e661.unnamed.first_primitive;
                                }
                                let _e818 = phi_1332_;
                                if (_e814 == 0u) {
                                    phi_1342_ = _e730.unnamed.root;
                                } else {
                                    phi_1342_ = _e730.unnamed.first_primitive;
                                }
                                let _e827 = phi_1342_;
                                if (_e814 == 0u) {
                                    phi_1352_ = _e799.unnamed.root;
                                } else {
                                    phi_1352_ = _e799.unnamed.first_primitive;
                                }
                                let _e836 = phi_1352_;
                                let _e849 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e818 >> bitcast<u32>(((_e815 * 8u) & 31u))) & 255u)) * _e571) + (_e592 - _e377)), ((f32(((_e827 >> bitcast<u32>(((_e815 * 8u) & 31u))) & 255u)) * _e572) + (_e593 - _e378)));
                                let _e850 = core_intrinsics_maximum_number_nsz_f32_(_e849, ((f32(((_e836 >> bitcast<u32>(((_e815 * 8u) & 31u))) & 255u)) * _e573) + (_e594 - _e379)));
                                if (_e814 == 0u) {
                                    phi_1370_ = _e661.unnamed_1.root;
                                } else {
                                    phi_1370_ = _e661.unnamed_1.first_primitive;
                                }
                                let _e853 = phi_1370_;
                                if (_e814 == 0u) {
                                    phi_1380_ = _e730.unnamed_1.root;
                                } else {
                                    phi_1380_ = _e730.unnamed_1.first_primitive;
                                }
                                let _e862 = phi_1380_;
                                if (_e814 == 0u) {
                                    phi_1390_ = _e799.unnamed_1.root;
                                } else {
                                    phi_1390_ = _e799.unnamed_1.first_primitive;
                                }
                                let _e871 = phi_1390_;
                                let _e884 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e853 >> bitcast<u32>(((_e815 * 8u) & 31u))) & 255u)) * _e571) + (_e592 + _e377)), ((f32(((_e862 >> bitcast<u32>(((_e815 * 8u) & 31u))) & 255u)) * _e572) + (_e593 + _e378)));
                                let _e885 = core_intrinsics_minimum_number_nsz_f32_(_e884, ((f32(((_e871 >> bitcast<u32>(((_e815 * 8u) & 31u))) & 255u)) * _e573) + (_e594 + _e379)));
                                if (_e850 <= _e885) {
                                    if (_e850 <= _e537.t) {
                                        if (_e885 >= _e162.tmin) {
                                            if (_e814 == 0u) {
                                                let _e892 = nodes.member[(0u + _e535)].links[2u];
                                                phi_1426_ = _e892;
                                            } else {
                                                let _e895 = nodes.member[(0u + _e535)].links[3u];
                                                phi_1426_ = _e895;
                                            }
                                            let _e897 = phi_1426_;
                                            let _e902 = ((_e897 >> bitcast<u32>(((_e815 * 8u) & 31u))) & 255u);
                                            let _e903 = (_e902 & 31u);
                                            if (_e903 >= 24u) {
                                                phi_1439_ = (24u + ((_e903 - 24u) ^ _e397));
                                            } else {
                                                phi_1439_ = _e903;
                                            }
                                            let _e909 = phi_1439_;
                                            phi_1444_ = (_e811 | ((_e902 >> bitcast<u32>(5i)) << bitcast<u32>((_e909 & 31u))));
                                        } else {
                                            phi_1444_ = _e811;
                                        }
                                        let _e917 = phi_1444_;
                                        phi_1445_ = _e917;
                                    } else {
                                        phi_1445_ = _e811;
                                    }
                                    let _e919 = phi_1445_;
                                    phi_1446_ = _e919;
                                } else {
                                    phi_1446_ = _e811;
                                }
                                let _e921 = phi_1446_;
                                phi_1316_ = (_e809 + 1u);
                                phi_1319_ = _e921;
                            } else {
                                phi_1316_ = u32();
                                phi_1319_ = u32();
                            }
                            let _e924 = phi_1316_;
                            let _e926 = phi_1319_;
                            continue;
                            continuing {
                                phi_1315_ = _e924;
                                phi_1318_ = _e926;
                                break if !(_e812);
                            }
                        }
                        let _e930 = nodes.member[(0u + _e535)].links[0u];
                        let _e934 = nodes.member[(0u + _e535)].frame[3u];
                        let _e938 = local_4;
                        if ((_e938 & 4278190080u) == 0u) {
                        } else {
                            let _e942 = local_3.group_mask;
                            if ((_e942 & 4278190080u) == 0u) {
                            } else {
                                let _e946 = local_3.len;
                                if (_e946 < 32u) {
                                    let _e949 = local_3.group;
                                    let _e951 = local_3.len;
                                    if (_e951 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_3.first[(0u + _e951)] = _e949;
                                    let _e957 = local_3.group_mask;
                                    let _e959 = local_3.len;
                                    if (_e959 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_3.mask[(0u + _e959)] = _e957;
                                    let _e966 = local_3.len;
                                    local_3.len = (_e966 + 1u);
                                }
                            }
                            local_3.group = (_e111 + _e930);
                            let _e970 = local_5;
                            local_3.group_mask = ((_e970 & 4278190080u) | (_e934 >> bitcast<u32>(24i)));
                        }
                        let _e975 = local_6;
                        phi_1504_ = (_e975 & 16777215u);
                        phi_1507_ = _e537;
                        loop {
                            let _e978 = phi_1504_;
                            let _e980 = phi_1507_;
                            local_12 = _e980;
                            if (_e978 == 0u) {
                                phi_1505_ = u32();
                                phi_1508_ = lt_bvh_Hit();
                                phi_3290_ = false;
                            } else {
                                let _e984 = nodes.member[(0u + _e535)].links[1u];
                                let _e988 = (_e984 + select(firstTrailingBit(_e978), 32u, (_e978 == 0u)));
                                if (_e988 < _e93) {
                                } else {
                                    return;
                                }
                                let _e995 = instances.member[(0u + _e988)].low_world;
                                let _e997 = instances.member[(0u + _e988)].high_world;
                                let _e1007 = ((_e995.x - _e162.origin.x) * _e316);
                                let _e1008 = ((_e995.y - _e162.origin.y) * _e328);
                                let _e1009 = ((_e995.z - _e162.origin.z) * _e340);
                                let _e1019 = ((_e997.x - _e162.origin.x) * _e316);
                                let _e1020 = ((_e997.y - _e162.origin.y) * _e328);
                                let _e1021 = ((_e997.z - _e162.origin.z) * _e340);
                                if (_e1007 < _e1019) {
                                    phi_1562_ = _e1007;
                                } else {
                                    phi_1562_ = _e1019;
                                }
                                let _e1024 = phi_1562_;
                                if (_e1008 < _e1020) {
                                    phi_1567_ = _e1008;
                                } else {
                                    phi_1567_ = _e1020;
                                }
                                let _e1027 = phi_1567_;
                                if (_e1009 < _e1021) {
                                    phi_1572_ = _e1009;
                                } else {
                                    phi_1572_ = _e1021;
                                }
                                let _e1030 = phi_1572_;
                                if (_e1007 > _e1019) {
                                    phi_1580_ = _e1007;
                                } else {
                                    phi_1580_ = _e1019;
                                }
                                let _e1036 = phi_1580_;
                                if (_e1008 > _e1020) {
                                    phi_1585_ = _e1008;
                                } else {
                                    phi_1585_ = _e1020;
                                }
                                let _e1039 = phi_1585_;
                                if (_e1009 > _e1021) {
                                    phi_1590_ = _e1009;
                                } else {
                                    phi_1590_ = _e1021;
                                }
                                let _e1042 = phi_1590_;
                                let _e1046 = core_intrinsics_maximum_number_nsz_f32_((_e1024 - _e384), (_e1027 - _e385));
                                let _e1047 = core_intrinsics_maximum_number_nsz_f32_(_e1046, (_e1030 - _e386));
                                let _e1048 = core_intrinsics_minimum_number_nsz_f32_((_e1036 + _e384), (_e1039 + _e385));
                                let _e1049 = core_intrinsics_minimum_number_nsz_f32_(_e1048, (_e1042 + _e386));
                                if (_e1047 <= _e1049) {
                                    if (_e1047 <= _e980.t) {
                                        if (_e1049 >= _e162.tmin) {
                                            let _e1061 = instances.member[(0u + _e988)].world_to_object[0u];
                                            let _e1072 = ((((_e1061.x * _e162.origin.x) + (_e1061.y * _e162.origin.y)) + (_e1061.z * _e162.origin.z)) + (_e1061.w * 1f));
                                            let _e1074 = instances.member[(0u + _e988)].world_to_object[1u];
                                            let _e1085 = ((((_e1074.x * _e162.origin.x) + (_e1074.y * _e162.origin.y)) + (_e1074.z * _e162.origin.z)) + (_e1074.w * 1f));
                                            let _e1087 = instances.member[(0u + _e988)].world_to_object[2u];
                                            let _e1098 = ((((_e1087.x * _e162.origin.x) + (_e1087.y * _e162.origin.y)) + (_e1087.z * _e162.origin.z)) + (_e1087.w * 1f));
                                            let _e1105 = instances.member[(0u + _e988)].world_to_object[0u];
                                            let _e1116 = ((((_e1105.x * _e162.direction.x) + (_e1105.y * _e162.direction.y)) + (_e1105.z * _e162.direction.z)) + (_e1105.w * 0f));
                                            let _e1118 = instances.member[(0u + _e988)].world_to_object[1u];
                                            let _e1129 = ((((_e1118.x * _e162.direction.x) + (_e1118.y * _e162.direction.y)) + (_e1118.z * _e162.direction.z)) + (_e1118.w * 0f));
                                            let _e1131 = instances.member[(0u + _e988)].world_to_object[2u];
                                            let _e1142 = ((((_e1131.x * _e162.direction.x) + (_e1131.y * _e162.direction.y)) + (_e1131.z * _e162.direction.z)) + (_e1131.w * 0f));
                                            let _e1147 = instances.member[(0u + _e988)].root;
                                            let _e1149 = instances.member[(0u + _e988)].first_triangle;
                                            let _e1153 = abs(_e1116);
                                            let _e1154 = abs(_e1129);
                                            let _e1155 = abs(_e1142);
                                            if (abs(_e1072) < 1000000000000000f) {
                                                if (abs(_e1085) < 1000000000000000f) {
                                                    if (abs(_e1098) < 1000000000000000f) {
                                                        if (_e1153 < 1000000000000000f) {
                                                            if (_e1154 < 1000000000000000f) {
                                                                if (_e1155 < 1000000000000000f) {
                                                                    if (_e1153 > 0f) {
                                                                        phi_1747_ = bool();
                                                                        phi_1748_ = true;
                                                                    } else {
                                                                        let _e1163 = (_e1154 > 0f);
                                                                        if _e1163 {
                                                                            phi_1746_ = bool();
                                                                        } else {
                                                                            phi_1746_ = (_e1155 > 0f);
                                                                        }
                                                                        let _e1166 = phi_1746_;
                                                                        phi_1747_ = _e1166;
                                                                        phi_1748_ = _e1163;
                                                                    }
                                                                    let _e1168 = phi_1747_;
                                                                    let _e1170 = phi_1748_;
                                                                    if _e1170 {
                                                                        phi_1752_ = true;
                                                                    } else {
                                                                        phi_1752_ = _e1168;
                                                                    }
                                                                    let _e1172 = phi_1752_;
                                                                    phi_1753_ = _e1172;
                                                                    phi_1754_ = false;
                                                                } else {
                                                                    phi_1753_ = bool();
                                                                    phi_1754_ = true;
                                                                }
                                                                let _e1174 = phi_1753_;
                                                                let _e1176 = phi_1754_;
                                                                phi_1755_ = _e1174;
                                                                phi_1756_ = false;
                                                                phi_1757_ = _e1176;
                                                            } else {
                                                                phi_1755_ = bool();
                                                                phi_1756_ = true;
                                                                phi_1757_ = false;
                                                            }
                                                            let _e1178 = phi_1755_;
                                                            let _e1180 = phi_1756_;
                                                            let _e1182 = phi_1757_;
                                                            phi_1758_ = _e1178;
                                                            phi_1759_ = _e1180;
                                                            phi_1760_ = _e1182;
                                                        } else {
                                                            phi_1758_ = bool();
                                                            phi_1759_ = true;
                                                            phi_1760_ = false;
                                                        }
                                                        let _e1184 = phi_1758_;
                                                        let _e1186 = phi_1759_;
                                                        let _e1188 = phi_1760_;
                                                        phi_1761_ = _e1184;
                                                        phi_1762_ = _e1186;
                                                        phi_1763_ = _e1188;
                                                    } else {
                                                        phi_1761_ = bool();
                                                        phi_1762_ = true;
                                                        phi_1763_ = false;
                                                    }
                                                    let _e1190 = phi_1761_;
                                                    let _e1192 = phi_1762_;
                                                    let _e1194 = phi_1763_;
                                                    phi_1764_ = _e1190;
                                                    phi_1765_ = _e1192;
                                                    phi_1766_ = _e1194;
                                                } else {
                                                    phi_1764_ = bool();
                                                    phi_1765_ = true;
                                                    phi_1766_ = false;
                                                }
                                                let _e1196 = phi_1764_;
                                                let _e1198 = phi_1765_;
                                                let _e1200 = phi_1766_;
                                                phi_1767_ = _e1196;
                                                phi_1768_ = _e1198;
                                                phi_1769_ = _e1200;
                                            } else {
                                                phi_1767_ = bool();
                                                phi_1768_ = true;
                                                phi_1769_ = false;
                                            }
                                            let _e1202 = phi_1767_;
                                            let _e1204 = phi_1768_;
                                            let _e1206 = phi_1769_;
                                            if _e1204 {
                                                phi_1773_ = true;
                                            } else {
                                                phi_1773_ = _e1206;
                                            }
                                            let _e1208 = phi_1773_;
                                            if _e1208 {
                                                phi_1777_ = false;
                                            } else {
                                                phi_1777_ = _e1202;
                                            }
                                            let _e1210 = phi_1777_;
                                            if _e1210 {
                                                let _e1211 = (_e1147 >= _e78);
                                                if _e1211 {
                                                    phi_3280_ = lt_bvh_Hit();
                                                } else {
                                                    if (_e1147 < _e78) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1217 = nodes.member[(0u + _e1147)].frame[0u];
                                                    let _e1221 = nodes.member[(0u + _e1147)].frame[1u];
                                                    let _e1225 = nodes.member[(0u + _e1147)].frame[2u];
                                                    let _e1229 = nodes.member[(0u + _e1147)].frame[0u];
                                                    let _e1233 = nodes.member[(0u + _e1147)].frame[1u];
                                                    let _e1237 = nodes.member[(0u + _e1147)].frame[2u];
                                                    let _e1241 = nodes.member[(0u + _e1147)].frame[3u];
                                                    let _e1275 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1116), abs(_e1129));
                                                    let _e1276 = core_intrinsics_maximum_number_nsz_f32_(_e1275, abs(_e1142));
                                                    let _e1277 = (_e1276 * 0.0000000000009094947f);
                                                    if (abs(_e1116) < _e1277) {
                                                        phi_1847_ = _e1277;
                                                    } else {
                                                        phi_1847_ = abs(_e1116);
                                                    }
                                                    let _e1282 = phi_1847_;
                                                    if (_e1116 < 0f) {
                                                        phi_1854_ = (-1f / _e1282);
                                                    } else {
                                                        phi_1854_ = (1f / _e1282);
                                                    }
                                                    let _e1287 = phi_1854_;
                                                    if (abs(_e1129) < _e1277) {
                                                        phi_1861_ = _e1277;
                                                    } else {
                                                        phi_1861_ = abs(_e1129);
                                                    }
                                                    let _e1292 = phi_1861_;
                                                    if (_e1129 < 0f) {
                                                        phi_1868_ = (-1f / _e1292);
                                                    } else {
                                                        phi_1868_ = (1f / _e1292);
                                                    }
                                                    let _e1297 = phi_1868_;
                                                    if (abs(_e1142) < _e1277) {
                                                        phi_1875_ = _e1277;
                                                    } else {
                                                        phi_1875_ = abs(_e1142);
                                                    }
                                                    let _e1302 = phi_1875_;
                                                    if (_e1142 < 0f) {
                                                        phi_1882_ = (-1f / _e1302);
                                                    } else {
                                                        phi_1882_ = (1f / _e1302);
                                                    }
                                                    let _e1307 = phi_1882_;
                                                    let _e1311 = abs((bitcast<f32>(_e1217) - _e1072));
                                                    let _e1312 = abs((bitcast<f32>(_e1221) - _e1085));
                                                    let _e1313 = abs((bitcast<f32>(_e1225) - _e1098));
                                                    let _e1317 = abs(((bitcast<f32>(_e1229) + (bitcast<f32>((((_e1241 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1072));
                                                    let _e1318 = abs(((bitcast<f32>(_e1233) + (bitcast<f32>((((_e1241 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1085));
                                                    let _e1319 = abs(((bitcast<f32>(_e1237) + (bitcast<f32>((((_e1241 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1098));
                                                    if (_e1311 > _e1317) {
                                                        phi_1899_ = _e1311;
                                                    } else {
                                                        phi_1899_ = _e1317;
                                                    }
                                                    let _e1322 = phi_1899_;
                                                    if (_e1312 > _e1318) {
                                                        phi_1904_ = _e1312;
                                                    } else {
                                                        phi_1904_ = _e1318;
                                                    }
                                                    let _e1325 = phi_1904_;
                                                    if (_e1313 > _e1319) {
                                                        phi_1909_ = _e1313;
                                                    } else {
                                                        phi_1909_ = _e1319;
                                                    }
                                                    let _e1328 = phi_1909_;
                                                    let _e1329 = core_intrinsics_maximum_number_nsz_f32_(_e1322, _e1325);
                                                    let _e1330 = core_intrinsics_maximum_number_nsz_f32_(_e1329, _e1328);
                                                    let _e1334 = (_e1330 * 0.0000019073486f);
                                                    let _e1335 = (abs(_e1287) * _e1334);
                                                    let _e1336 = (abs(_e1297) * _e1334);
                                                    let _e1337 = (abs(_e1307) * _e1334);
                                                    let _e1341 = (_e1330 * 0.0000009536743f);
                                                    let _e1342 = (abs(_e1287) * _e1341);
                                                    let _e1343 = (abs(_e1297) * _e1341);
                                                    let _e1344 = (abs(_e1307) * _e1341);
                                                    let _e1345 = abs(_e1116);
                                                    let _e1346 = abs(_e1129);
                                                    let _e1347 = abs(_e1142);
                                                    if (_e1345 >= _e1346) {
                                                        if (_e1345 >= _e1347) {
                                                            phi_1937_ = false;
                                                        } else {
                                                            phi_1937_ = true;
                                                        }
                                                        let _e1351 = phi_1937_;
                                                        phi_1938_ = _e1351;
                                                    } else {
                                                        phi_1938_ = true;
                                                    }
                                                    let _e1353 = phi_1938_;
                                                    if _e1353 {
                                                        if (_e1346 >= _e1347) {
                                                            phi_1946_ = 1u;
                                                        } else {
                                                            phi_1946_ = 2u;
                                                        }
                                                        let _e1356 = phi_1946_;
                                                        phi_1947_ = _e1356;
                                                    } else {
                                                        phi_1947_ = 0u;
                                                    }
                                                    let _e1358 = phi_1947_;
                                                    if (_e1358 == 0u) {
                                                        phi_1959_ = vec3<f32>(_e1129, _e1142, _e1116);
                                                    } else {
                                                        if (_e1358 == 1u) {
                                                            phi_1958_ = vec3<f32>(_e1142, _e1116, _e1129);
                                                        } else {
                                                            phi_1958_ = vec3<f32>(_e1116, _e1129, _e1142);
                                                        }
                                                        let _e1364 = phi_1958_;
                                                        phi_1959_ = _e1364;
                                                    }
                                                    let _e1366 = phi_1959_;
                                                    let _e1369 = (_e1366.x / _e1366.z);
                                                    let _e1372 = (_e1366.y / _e1366.z);
                                                    let _e1374 = (1f / _e1366.z);
                                                    if (_e1287 < 0f) {
                                                        phi_1972_ = 0u;
                                                    } else {
                                                        phi_1972_ = 1u;
                                                    }
                                                    let _e1377 = phi_1972_;
                                                    if (_e1297 < 0f) {
                                                        phi_1977_ = 0u;
                                                    } else {
                                                        phi_1977_ = 2u;
                                                    }
                                                    let _e1380 = phi_1977_;
                                                    if (_e1307 < 0f) {
                                                        phi_1982_ = 0u;
                                                    } else {
                                                        phi_1982_ = 4u;
                                                    }
                                                    let _e1383 = phi_1982_;
                                                    let _e1385 = ((_e1377 | _e1380) | _e1383);
                                                    let _e1386 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1147, 2147483648u);
                                                    local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e1386.first[0], _e1386.first[1], _e1386.first[2], _e1386.first[3], _e1386.first[4], _e1386.first[5], _e1386.first[6], _e1386.first[7], _e1386.first[8], _e1386.first[9], _e1386.first[10], _e1386.first[11], _e1386.first[12], _e1386.first[13], _e1386.first[14], _e1386.first[15], _e1386.first[16], _e1386.first[17], _e1386.first[18], _e1386.first[19], _e1386.first[20], _e1386.first[21], _e1386.first[22], _e1386.first[23], _e1386.first[24], _e1386.first[25], _e1386.first[26], _e1386.first[27], _e1386.first[28], _e1386.first[29], _e1386.first[30], _e1386.first[31]), array<u32, 32>(_e1386.mask[0], _e1386.mask[1], _e1386.mask[2], _e1386.mask[3], _e1386.mask[4], _e1386.mask[5], _e1386.mask[6], _e1386.mask[7], _e1386.mask[8], _e1386.mask[9], _e1386.mask[10], _e1386.mask[11], _e1386.mask[12], _e1386.mask[13], _e1386.mask[14], _e1386.mask[15], _e1386.mask[16], _e1386.mask[17], _e1386.mask[18], _e1386.mask[19], _e1386.mask[20], _e1386.mask[21], _e1386.mask[22], _e1386.mask[23], _e1386.mask[24], _e1386.mask[25], _e1386.mask[26], _e1386.mask[27], _e1386.mask[28], _e1386.mask[29], _e1386.mask[30], _e1386.mask[31]), _e1386.len, _e1386.group, _e1386.group_mask);
                                                    let _e1460 = local_2.group_mask;
                                                    if ((_e1460 & 4278190080u) == 0u) {
                                                        let _e1464 = local_2.len;
                                                        if (_e1464 == 0u) {
                                                            phi_2096_ = false;
                                                        } else {
                                                            let _e1468 = local_2.len;
                                                            local_2.len = (_e1468 - 1u);
                                                            let _e1471 = local_2.len;
                                                            if (_e1471 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1476 = local_2.first[(0u + _e1471)];
                                                            local_2.group = _e1476;
                                                            let _e1479 = local_2.len;
                                                            if (_e1479 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1484 = local_2.mask[(0u + _e1479)];
                                                            local_2.group_mask = _e1484;
                                                            phi_2096_ = true;
                                                        }
                                                        let _e1487 = phi_2096_;
                                                        phi_2097_ = _e1487;
                                                    } else {
                                                        phi_2097_ = true;
                                                    }
                                                    let _e1489 = phi_2097_;
                                                    if _e1489 {
                                                        let _e1491 = local_2.group_mask;
                                                        let _e1497 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1491)), 32u, (_e1491 == 0u)));
                                                        let _e1501 = local_2.group_mask;
                                                        let _e1515 = local_2.group_mask;
                                                        local_2.group_mask = (_e1515 & ~((1u << bitcast<u32>((_e1497 & 31u)))));
                                                        let _e1518 = local_2.group;
                                                        phi_2128_ = (_e1518 + countOneBits(((_e1501 & ~((4294967295u << bitcast<u32>((((_e1497 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_2128_ = 4294967295u;
                                                    }
                                                    let _e1521 = phi_2128_;
                                                    phi_2130_ = _e980;
                                                    phi_2133_ = _e1521;
                                                    loop {
                                                        let _e1523 = phi_2130_;
                                                        let _e1525 = phi_2133_;
                                                        local_11 = _e1523;
                                                        let _e1526 = (_e1525 != 4294967295u);
                                                        if _e1526 {
                                                            if (_e1525 < _e78) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1533 = nodes.member[(0u + _e1525)].frame[3u];
                                                            let _e1558 = (bitcast<f32>((((_e1533 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1287);
                                                            let _e1559 = (bitcast<f32>((((_e1533 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1297);
                                                            let _e1560 = (bitcast<f32>((((_e1533 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1307);
                                                            let _e1563 = nodes.member[(0u + _e1525)].frame[0u];
                                                            let _e1567 = nodes.member[(0u + _e1525)].frame[1u];
                                                            let _e1571 = nodes.member[(0u + _e1525)].frame[2u];
                                                            let _e1576 = ((bitcast<f32>(_e1563) - _e1072) * _e1287);
                                                            let _e1577 = ((bitcast<f32>(_e1567) - _e1085) * _e1297);
                                                            let _e1578 = ((bitcast<f32>(_e1571) - _e1098) * _e1307);
                                                            let _e1586 = nodes.member[(0u + _e1525)].x;
                                                            if (_e1287 < 0f) {
                                                                let _e1597 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1586.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1603 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1597.unnamed.root, _e1586.w), _e1597.unnamed_1);
                                                                let _e1609 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1603.unnamed, lt_bvh_traverse_Tree(_e1586.x, _e1603.unnamed_1.first_primitive));
                                                                phi_2214_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1609.unnamed, lt_bvh_traverse_Tree(_e1609.unnamed_1.root, _e1586.y));
                                                            } else {
                                                                let _e1625 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1586.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1631 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1625.unnamed.root, _e1586.y), _e1625.unnamed_1);
                                                                let _e1637 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1631.unnamed, lt_bvh_traverse_Tree(_e1586.z, _e1631.unnamed_1.first_primitive));
                                                                phi_2214_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1637.unnamed, lt_bvh_traverse_Tree(_e1637.unnamed_1.root, _e1586.w));
                                                            }
                                                            let _e1645 = phi_2214_;
                                                            let _e1655 = nodes.member[(0u + _e1525)].y;
                                                            if (_e1297 < 0f) {
                                                                let _e1666 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1655.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1672 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1666.unnamed.root, _e1655.w), _e1666.unnamed_1);
                                                                let _e1678 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1672.unnamed, lt_bvh_traverse_Tree(_e1655.x, _e1672.unnamed_1.first_primitive));
                                                                phi_2241_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1678.unnamed, lt_bvh_traverse_Tree(_e1678.unnamed_1.root, _e1655.y));
                                                            } else {
                                                                let _e1694 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1655.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1700 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1694.unnamed.root, _e1655.y), _e1694.unnamed_1);
                                                                let _e1706 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1700.unnamed, lt_bvh_traverse_Tree(_e1655.z, _e1700.unnamed_1.first_primitive));
                                                                phi_2241_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1706.unnamed, lt_bvh_traverse_Tree(_e1706.unnamed_1.root, _e1655.w));
                                                            }
                                                            let _e1714 = phi_2241_;
                                                            let _e1724 = nodes.member[(0u + _e1525)].z;
                                                            if (_e1307 < 0f) {
                                                                let _e1735 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1724.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1741 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1735.unnamed.root, _e1724.w), _e1735.unnamed_1);
                                                                let _e1747 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1741.unnamed, lt_bvh_traverse_Tree(_e1724.x, _e1741.unnamed_1.first_primitive));
                                                                phi_2268_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1747.unnamed, lt_bvh_traverse_Tree(_e1747.unnamed_1.root, _e1724.y));
                                                            } else {
                                                                let _e1763 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1724.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1769 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1763.unnamed.root, _e1724.y), _e1763.unnamed_1);
                                                                let _e1775 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1769.unnamed, lt_bvh_traverse_Tree(_e1724.z, _e1769.unnamed_1.first_primitive));
                                                                phi_2268_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1775.unnamed, lt_bvh_traverse_Tree(_e1775.unnamed_1.root, _e1724.w));
                                                            }
                                                            let _e1783 = phi_2268_;
                                                            phi_2274_ = 0u;
                                                            phi_2277_ = 0u;
                                                            loop {
                                                                let _e1793 = phi_2274_;
                                                                let _e1795 = phi_2277_;
                                                                local_7 = _e1795;
                                                                local_8 = _e1795;
                                                                local_9 = _e1795;
                                                                let _e1796 = (_e1793 < 8u);
                                                                if _e1796 {
                                                                    let _e1798 = (_e1793 >> bitcast<u32>(2i));
                                                                    let _e1799 = (_e1793 & 3u);
                                                                    if (_e1798 == 0u) {
                                                                        phi_2291_ = _e1645.unnamed.root;
                                                                    } else {
                                                                        phi_2291_ = _e1645.unnamed.first_primitive;
                                                                    }
                                                                    let _e1802 = phi_2291_;
                                                                    if (_e1798 == 0u) {
                                                                        phi_2301_ = _e1714.unnamed.root;
                                                                    } else {
                                                                        phi_2301_ = _e1714.unnamed.first_primitive;
                                                                    }
                                                                    let _e1811 = phi_2301_;
                                                                    if (_e1798 == 0u) {
                                                                        phi_2311_ = _e1783.unnamed.root;
                                                                    } else {
                                                                        phi_2311_ = _e1783.unnamed.first_primitive;
                                                                    }
                                                                    let _e1820 = phi_2311_;
                                                                    let _e1833 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1802 >> bitcast<u32>(((_e1799 * 8u) & 31u))) & 255u)) * _e1558) + (_e1576 - _e1335)), ((f32(((_e1811 >> bitcast<u32>(((_e1799 * 8u) & 31u))) & 255u)) * _e1559) + (_e1577 - _e1336)));
                                                                    let _e1834 = core_intrinsics_maximum_number_nsz_f32_(_e1833, ((f32(((_e1820 >> bitcast<u32>(((_e1799 * 8u) & 31u))) & 255u)) * _e1560) + (_e1578 - _e1337)));
                                                                    if (_e1798 == 0u) {
                                                                        phi_2329_ = _e1645.unnamed_1.root;
                                                                    } else {
                                                                        phi_2329_ = _e1645.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1837 = phi_2329_;
                                                                    if (_e1798 == 0u) {
                                                                        phi_2339_ = _e1714.unnamed_1.root;
                                                                    } else {
                                                                        phi_2339_ = _e1714.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1846 = phi_2339_;
                                                                    if (_e1798 == 0u) {
                                                                        phi_2349_ = _e1783.unnamed_1.root;
                                                                    } else {
                                                                        phi_2349_ = _e1783.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1855 = phi_2349_;
                                                                    let _e1868 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1837 >> bitcast<u32>(((_e1799 * 8u) & 31u))) & 255u)) * _e1558) + (_e1576 + _e1335)), ((f32(((_e1846 >> bitcast<u32>(((_e1799 * 8u) & 31u))) & 255u)) * _e1559) + (_e1577 + _e1336)));
                                                                    let _e1869 = core_intrinsics_minimum_number_nsz_f32_(_e1868, ((f32(((_e1855 >> bitcast<u32>(((_e1799 * 8u) & 31u))) & 255u)) * _e1560) + (_e1578 + _e1337)));
                                                                    if (_e1834 <= _e1869) {
                                                                        if (_e1834 <= _e1523.t) {
                                                                            if (_e1869 >= _e162.tmin) {
                                                                                if (_e1798 == 0u) {
                                                                                    let _e1876 = nodes.member[(0u + _e1525)].links[2u];
                                                                                    phi_2385_ = _e1876;
                                                                                } else {
                                                                                    let _e1879 = nodes.member[(0u + _e1525)].links[3u];
                                                                                    phi_2385_ = _e1879;
                                                                                }
                                                                                let _e1881 = phi_2385_;
                                                                                let _e1886 = ((_e1881 >> bitcast<u32>(((_e1799 * 8u) & 31u))) & 255u);
                                                                                let _e1887 = (_e1886 & 31u);
                                                                                if (_e1887 >= 24u) {
                                                                                    phi_2398_ = (24u + ((_e1887 - 24u) ^ _e1385));
                                                                                } else {
                                                                                    phi_2398_ = _e1887;
                                                                                }
                                                                                let _e1893 = phi_2398_;
                                                                                phi_2403_ = (_e1795 | ((_e1886 >> bitcast<u32>(5i)) << bitcast<u32>((_e1893 & 31u))));
                                                                            } else {
                                                                                phi_2403_ = _e1795;
                                                                            }
                                                                            let _e1901 = phi_2403_;
                                                                            phi_2404_ = _e1901;
                                                                        } else {
                                                                            phi_2404_ = _e1795;
                                                                        }
                                                                        let _e1903 = phi_2404_;
                                                                        phi_2405_ = _e1903;
                                                                    } else {
                                                                        phi_2405_ = _e1795;
                                                                    }
                                                                    let _e1905 = phi_2405_;
                                                                    phi_2275_ = (_e1793 + 1u);
                                                                    phi_2278_ = _e1905;
                                                                } else {
                                                                    phi_2275_ = u32();
                                                                    phi_2278_ = u32();
                                                                }
                                                                let _e1908 = phi_2275_;
                                                                let _e1910 = phi_2278_;
                                                                continue;
                                                                continuing {
                                                                    phi_2274_ = _e1908;
                                                                    phi_2277_ = _e1910;
                                                                    break if !(_e1796);
                                                                }
                                                            }
                                                            let _e1914 = nodes.member[(0u + _e1525)].links[0u];
                                                            let _e1918 = nodes.member[(0u + _e1525)].frame[3u];
                                                            let _e1922 = local_7;
                                                            if ((_e1922 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1926 = local_2.group_mask;
                                                                if ((_e1926 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1930 = local_2.len;
                                                                    if (_e1930 < 32u) {
                                                                        let _e1933 = local_2.group;
                                                                        let _e1935 = local_2.len;
                                                                        if (_e1935 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_2.first[(0u + _e1935)] = _e1933;
                                                                        let _e1941 = local_2.group_mask;
                                                                        let _e1943 = local_2.len;
                                                                        if (_e1943 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_2.mask[(0u + _e1943)] = _e1941;
                                                                        let _e1950 = local_2.len;
                                                                        local_2.len = (_e1950 + 1u);
                                                                    }
                                                                }
                                                                local_2.group = (_e1147 + _e1914);
                                                                let _e1954 = local_8;
                                                                local_2.group_mask = ((_e1954 & 4278190080u) | (_e1918 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1959 = local_9;
                                                            phi_2463_ = _e1523;
                                                            phi_2466_ = (_e1959 & 16777215u);
                                                            loop {
                                                                let _e1962 = phi_2463_;
                                                                let _e1964 = phi_2466_;
                                                                local_10 = _e1962;
                                                                if (_e1964 == 0u) {
                                                                    phi_2464_ = lt_bvh_Hit();
                                                                    phi_2467_ = u32();
                                                                    phi_3208_ = false;
                                                                } else {
                                                                    let _e1968 = nodes.member[(0u + _e1525)].links[1u];
                                                                    let _e1973 = ((_e1149 + _e1968) + select(firstTrailingBit(_e1964), 32u, (_e1964 == 0u)));
                                                                    if (_e1973 < _e81) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1980 = triangles.member[(0u + _e1973)].v0_;
                                                                    let _e1982 = (_e1980.x - _e1072);
                                                                    let _e1984 = (_e1980.y - _e1085);
                                                                    let _e1986 = (_e1980.z - _e1098);
                                                                    if (_e1358 == 0u) {
                                                                        phi_2511_ = vec3<f32>(_e1984, _e1986, _e1982);
                                                                    } else {
                                                                        if (_e1358 == 1u) {
                                                                            phi_2510_ = vec3<f32>(_e1986, _e1982, _e1984);
                                                                        } else {
                                                                            phi_2510_ = (_e1980 - vec3<f32>(_e1072, _e1085, _e1098));
                                                                        }
                                                                        let _e1994 = phi_2510_;
                                                                        phi_2511_ = _e1994;
                                                                    }
                                                                    let _e1996 = phi_2511_;
                                                                    let _e2000 = (_e1996.x - (_e1369 * _e1996.z));
                                                                    let _e2004 = (_e1996.y - (_e1372 * _e1996.z));
                                                                    let _e2008 = triangles.member[(0u + _e1973)].v1_;
                                                                    let _e2010 = (_e2008.x - _e1072);
                                                                    let _e2012 = (_e2008.y - _e1085);
                                                                    let _e2014 = (_e2008.z - _e1098);
                                                                    if (_e1358 == 0u) {
                                                                        phi_2543_ = vec3<f32>(_e2012, _e2014, _e2010);
                                                                    } else {
                                                                        if (_e1358 == 1u) {
                                                                            phi_2542_ = vec3<f32>(_e2014, _e2010, _e2012);
                                                                        } else {
                                                                            phi_2542_ = (_e2008 - vec3<f32>(_e1072, _e1085, _e1098));
                                                                        }
                                                                        let _e2022 = phi_2542_;
                                                                        phi_2543_ = _e2022;
                                                                    }
                                                                    let _e2024 = phi_2543_;
                                                                    let _e2028 = (_e2024.x - (_e1369 * _e2024.z));
                                                                    let _e2032 = (_e2024.y - (_e1372 * _e2024.z));
                                                                    let _e2036 = triangles.member[(0u + _e1973)].v2_;
                                                                    let _e2038 = (_e2036.x - _e1072);
                                                                    let _e2040 = (_e2036.y - _e1085);
                                                                    let _e2042 = (_e2036.z - _e1098);
                                                                    if (_e1358 == 0u) {
                                                                        phi_2575_ = vec3<f32>(_e2040, _e2042, _e2038);
                                                                    } else {
                                                                        if (_e1358 == 1u) {
                                                                            phi_2574_ = vec3<f32>(_e2042, _e2038, _e2040);
                                                                        } else {
                                                                            phi_2574_ = (_e2036 - vec3<f32>(_e1072, _e1085, _e1098));
                                                                        }
                                                                        let _e2050 = phi_2574_;
                                                                        phi_2575_ = _e2050;
                                                                    }
                                                                    let _e2052 = phi_2575_;
                                                                    let _e2056 = (_e2052.x - (_e1369 * _e2052.z));
                                                                    let _e2060 = (_e2052.y - (_e1372 * _e2052.z));
                                                                    if (_e2028 < _e2056) {
                                                                        phi_2596_ = true;
                                                                    } else {
                                                                        if (_e2028 == _e2056) {
                                                                            phi_2595_ = (_e2032 < _e2060);
                                                                        } else {
                                                                            phi_2595_ = false;
                                                                        }
                                                                        let _e2067 = phi_2595_;
                                                                        phi_2596_ = _e2067;
                                                                    }
                                                                    let _e2069 = phi_2596_;
                                                                    if _e2069 {
                                                                        phi_2600_ = _e2060;
                                                                        phi_2601_ = _e2056;
                                                                        phi_2602_ = _e2032;
                                                                        phi_2603_ = _e2028;
                                                                    } else {
                                                                        phi_2600_ = _e2032;
                                                                        phi_2601_ = _e2028;
                                                                        phi_2602_ = _e2060;
                                                                        phi_2603_ = _e2056;
                                                                    }
                                                                    let _e2071 = phi_2600_;
                                                                    let _e2073 = phi_2601_;
                                                                    let _e2075 = phi_2602_;
                                                                    let _e2077 = phi_2603_;
                                                                    let _e2080 = ((_e2077 * _e2071) - (_e2075 * _e2073));
                                                                    if _e2069 {
                                                                        phi_2611_ = -(_e2080);
                                                                    } else {
                                                                        phi_2611_ = _e2080;
                                                                    }
                                                                    let _e2083 = phi_2611_;
                                                                    if (_e2056 < _e2000) {
                                                                        phi_2622_ = true;
                                                                    } else {
                                                                        if (_e2056 == _e2000) {
                                                                            phi_2621_ = (_e2060 < _e2004);
                                                                        } else {
                                                                            phi_2621_ = false;
                                                                        }
                                                                        let _e2088 = phi_2621_;
                                                                        phi_2622_ = _e2088;
                                                                    }
                                                                    let _e2090 = phi_2622_;
                                                                    if _e2090 {
                                                                        phi_2626_ = _e2004;
                                                                        phi_2627_ = _e2000;
                                                                        phi_2628_ = _e2060;
                                                                        phi_2629_ = _e2056;
                                                                    } else {
                                                                        phi_2626_ = _e2060;
                                                                        phi_2627_ = _e2056;
                                                                        phi_2628_ = _e2004;
                                                                        phi_2629_ = _e2000;
                                                                    }
                                                                    let _e2092 = phi_2626_;
                                                                    let _e2094 = phi_2627_;
                                                                    let _e2096 = phi_2628_;
                                                                    let _e2098 = phi_2629_;
                                                                    let _e2101 = ((_e2098 * _e2092) - (_e2096 * _e2094));
                                                                    if _e2090 {
                                                                        phi_2637_ = -(_e2101);
                                                                    } else {
                                                                        phi_2637_ = _e2101;
                                                                    }
                                                                    let _e2104 = phi_2637_;
                                                                    if (_e2000 < _e2028) {
                                                                        phi_2648_ = true;
                                                                    } else {
                                                                        if (_e2000 == _e2028) {
                                                                            phi_2647_ = (_e2004 < _e2032);
                                                                        } else {
                                                                            phi_2647_ = false;
                                                                        }
                                                                        let _e2109 = phi_2647_;
                                                                        phi_2648_ = _e2109;
                                                                    }
                                                                    let _e2111 = phi_2648_;
                                                                    if _e2111 {
                                                                        phi_2652_ = _e2032;
                                                                        phi_2653_ = _e2028;
                                                                        phi_2654_ = _e2004;
                                                                        phi_2655_ = _e2000;
                                                                    } else {
                                                                        phi_2652_ = _e2004;
                                                                        phi_2653_ = _e2000;
                                                                        phi_2654_ = _e2032;
                                                                        phi_2655_ = _e2028;
                                                                    }
                                                                    let _e2113 = phi_2652_;
                                                                    let _e2115 = phi_2653_;
                                                                    let _e2117 = phi_2654_;
                                                                    let _e2119 = phi_2655_;
                                                                    let _e2122 = ((_e2119 * _e2113) - (_e2117 * _e2115));
                                                                    if _e2111 {
                                                                        phi_2663_ = -(_e2122);
                                                                    } else {
                                                                        phi_2663_ = _e2122;
                                                                    }
                                                                    let _e2125 = phi_2663_;
                                                                    if (_e2083 >= 0f) {
                                                                        if (_e2104 >= 0f) {
                                                                            if (_e2125 >= 0f) {
                                                                                phi_2678_ = ((_e2083 + _e2104) + _e2125);
                                                                                phi_2679_ = false;
                                                                            } else {
                                                                                phi_2678_ = f32();
                                                                                phi_2679_ = true;
                                                                            }
                                                                            let _e2132 = phi_2678_;
                                                                            let _e2134 = phi_2679_;
                                                                            phi_2680_ = _e2132;
                                                                            phi_2681_ = _e2134;
                                                                        } else {
                                                                            phi_2680_ = f32();
                                                                            phi_2681_ = true;
                                                                        }
                                                                        let _e2136 = phi_2680_;
                                                                        let _e2138 = phi_2681_;
                                                                        phi_2682_ = _e2136;
                                                                        phi_2683_ = _e2138;
                                                                    } else {
                                                                        phi_2682_ = f32();
                                                                        phi_2683_ = true;
                                                                    }
                                                                    let _e2140 = phi_2682_;
                                                                    let _e2142 = phi_2683_;
                                                                    if _e2142 {
                                                                        if (_e2083 <= 0f) {
                                                                            if (_e2104 <= 0f) {
                                                                                let _e2145 = (_e2125 <= 0f);
                                                                                if _e2145 {
                                                                                }
                                                                                phi_2701_ = ((_e2083 + _e2104) + _e2125);
                                                                                phi_2702_ = false;
                                                                                phi_2703_ = _e2145;
                                                                            } else {
                                                                                phi_2701_ = f32();
                                                                                phi_2702_ = true;
                                                                                phi_2703_ = false;
                                                                            }
                                                                            let _e2149 = phi_2701_;
                                                                            let _e2151 = phi_2702_;
                                                                            let _e2153 = phi_2703_;
                                                                            phi_2704_ = _e2149;
                                                                            phi_2705_ = _e2151;
                                                                            phi_2706_ = _e2153;
                                                                        } else {
                                                                            phi_2704_ = f32();
                                                                            phi_2705_ = true;
                                                                            phi_2706_ = false;
                                                                        }
                                                                        let _e2155 = phi_2704_;
                                                                        let _e2157 = phi_2705_;
                                                                        let _e2159 = phi_2706_;
                                                                        if _e2157 {
                                                                            phi_2710_ = false;
                                                                        } else {
                                                                            phi_2710_ = _e2159;
                                                                        }
                                                                        let _e2161 = phi_2710_;
                                                                        phi_2711_ = _e2155;
                                                                        phi_2712_ = _e2161;
                                                                    } else {
                                                                        phi_2711_ = _e2140;
                                                                        phi_2712_ = true;
                                                                    }
                                                                    let _e2163 = phi_2711_;
                                                                    let _e2165 = phi_2712_;
                                                                    if _e2165 {
                                                                        let _e2166 = (_e2163 == 0f);
                                                                        if _e2166 {
                                                                            phi_2925_ = lt_bvh_triangle_Intersection();
                                                                            phi_2926_ = false;
                                                                        } else {
                                                                            let _e2172 = ((((_e2083 * (_e1374 * _e1996.z)) + (_e2104 * (_e1374 * _e2024.z))) + (_e2125 * (_e1374 * _e2052.z))) / _e2163);
                                                                            if (_e2172 > _e162.tmin) {
                                                                                if (_e2172 < _e162.tmax) {
                                                                                    let _e2176 = triangles.member[(0u + _e1973)].v0_;
                                                                                    let _e2178 = triangles.member[(0u + _e1973)].v1_;
                                                                                    if (_e2176.x < _e2178.x) {
                                                                                        phi_2746_ = _e2176.x;
                                                                                    } else {
                                                                                        phi_2746_ = _e2178.x;
                                                                                    }
                                                                                    let _e2185 = phi_2746_;
                                                                                    if (_e2176.y < _e2178.y) {
                                                                                        phi_2755_ = _e2176.y;
                                                                                    } else {
                                                                                        phi_2755_ = _e2178.y;
                                                                                    }
                                                                                    let _e2192 = phi_2755_;
                                                                                    if (_e2176.z < _e2178.z) {
                                                                                        phi_2764_ = _e2176.z;
                                                                                    } else {
                                                                                        phi_2764_ = _e2178.z;
                                                                                    }
                                                                                    let _e2199 = phi_2764_;
                                                                                    let _e2201 = triangles.member[(0u + _e1973)].v2_;
                                                                                    if (_e2185 < _e2201.x) {
                                                                                        phi_2773_ = _e2185;
                                                                                    } else {
                                                                                        phi_2773_ = _e2201.x;
                                                                                    }
                                                                                    let _e2206 = phi_2773_;
                                                                                    if (_e2192 < _e2201.y) {
                                                                                        phi_2780_ = _e2192;
                                                                                    } else {
                                                                                        phi_2780_ = _e2201.y;
                                                                                    }
                                                                                    let _e2211 = phi_2780_;
                                                                                    if (_e2199 < _e2201.z) {
                                                                                        phi_2787_ = _e2199;
                                                                                    } else {
                                                                                        phi_2787_ = _e2201.z;
                                                                                    }
                                                                                    let _e2216 = phi_2787_;
                                                                                    let _e2218 = triangles.member[(0u + _e1973)].v0_;
                                                                                    let _e2220 = triangles.member[(0u + _e1973)].v1_;
                                                                                    if (_e2218.x > _e2220.x) {
                                                                                        phi_2800_ = _e2218.x;
                                                                                    } else {
                                                                                        phi_2800_ = _e2220.x;
                                                                                    }
                                                                                    let _e2227 = phi_2800_;
                                                                                    if (_e2218.y > _e2220.y) {
                                                                                        phi_2809_ = _e2218.y;
                                                                                    } else {
                                                                                        phi_2809_ = _e2220.y;
                                                                                    }
                                                                                    let _e2234 = phi_2809_;
                                                                                    if (_e2218.z > _e2220.z) {
                                                                                        phi_2818_ = _e2218.z;
                                                                                    } else {
                                                                                        phi_2818_ = _e2220.z;
                                                                                    }
                                                                                    let _e2241 = phi_2818_;
                                                                                    let _e2243 = triangles.member[(0u + _e1973)].v2_;
                                                                                    if (_e2227 > _e2243.x) {
                                                                                        phi_2827_ = _e2227;
                                                                                    } else {
                                                                                        phi_2827_ = _e2243.x;
                                                                                    }
                                                                                    let _e2248 = phi_2827_;
                                                                                    if (_e2234 > _e2243.y) {
                                                                                        phi_2834_ = _e2234;
                                                                                    } else {
                                                                                        phi_2834_ = _e2243.y;
                                                                                    }
                                                                                    let _e2253 = phi_2834_;
                                                                                    if (_e2241 > _e2243.z) {
                                                                                        phi_2841_ = _e2241;
                                                                                    } else {
                                                                                        phi_2841_ = _e2243.z;
                                                                                    }
                                                                                    let _e2258 = phi_2841_;
                                                                                    let _e2262 = ((_e2206 - _e1072) * _e1287);
                                                                                    let _e2263 = ((_e2211 - _e1085) * _e1297);
                                                                                    let _e2264 = ((_e2216 - _e1098) * _e1307);
                                                                                    let _e2268 = ((_e2248 - _e1072) * _e1287);
                                                                                    let _e2269 = ((_e2253 - _e1085) * _e1297);
                                                                                    let _e2270 = ((_e2258 - _e1098) * _e1307);
                                                                                    if (_e2262 < _e2268) {
                                                                                        phi_2858_ = _e2262;
                                                                                    } else {
                                                                                        phi_2858_ = _e2268;
                                                                                    }
                                                                                    let _e2273 = phi_2858_;
                                                                                    if (_e2263 < _e2269) {
                                                                                        phi_2863_ = _e2263;
                                                                                    } else {
                                                                                        phi_2863_ = _e2269;
                                                                                    }
                                                                                    let _e2276 = phi_2863_;
                                                                                    if (_e2264 < _e2270) {
                                                                                        phi_2868_ = _e2264;
                                                                                    } else {
                                                                                        phi_2868_ = _e2270;
                                                                                    }
                                                                                    let _e2279 = phi_2868_;
                                                                                    if (_e2262 > _e2268) {
                                                                                        phi_2876_ = _e2262;
                                                                                    } else {
                                                                                        phi_2876_ = _e2268;
                                                                                    }
                                                                                    let _e2285 = phi_2876_;
                                                                                    if (_e2263 > _e2269) {
                                                                                        phi_2881_ = _e2263;
                                                                                    } else {
                                                                                        phi_2881_ = _e2269;
                                                                                    }
                                                                                    let _e2288 = phi_2881_;
                                                                                    if (_e2264 > _e2270) {
                                                                                        phi_2886_ = _e2264;
                                                                                    } else {
                                                                                        phi_2886_ = _e2270;
                                                                                    }
                                                                                    let _e2291 = phi_2886_;
                                                                                    let _e2295 = core_intrinsics_maximum_number_nsz_f32_((_e2273 - _e1342), (_e2276 - _e1343));
                                                                                    let _e2296 = core_intrinsics_maximum_number_nsz_f32_(_e2295, (_e2279 - _e1344));
                                                                                    let _e2297 = core_intrinsics_minimum_number_nsz_f32_((_e2285 + _e1342), (_e2288 + _e1343));
                                                                                    let _e2298 = core_intrinsics_minimum_number_nsz_f32_(_e2297, (_e2291 + _e1344));
                                                                                    if (_e2296 > _e1047) {
                                                                                        phi_2898_ = _e2296;
                                                                                    } else {
                                                                                        phi_2898_ = _e1047;
                                                                                    }
                                                                                    let _e2301 = phi_2898_;
                                                                                    if (_e2298 < _e1049) {
                                                                                        phi_2903_ = _e2298;
                                                                                    } else {
                                                                                        phi_2903_ = _e1049;
                                                                                    }
                                                                                    let _e2304 = phi_2903_;
                                                                                    if (_e2172 < _e2301) {
                                                                                        phi_2908_ = _e2301;
                                                                                    } else {
                                                                                        phi_2908_ = _e2172;
                                                                                    }
                                                                                    let _e2307 = phi_2908_;
                                                                                    if (_e2307 > _e2304) {
                                                                                        phi_2913_ = _e2304;
                                                                                    } else {
                                                                                        phi_2913_ = _e2307;
                                                                                    }
                                                                                    let _e2310 = phi_2913_;
                                                                                    phi_2918_ = lt_bvh_triangle_Intersection(_e2310, (_e2104 / _e2163), (_e2125 / _e2163), (_e2301 <= _e2304));
                                                                                    phi_2919_ = false;
                                                                                } else {
                                                                                    phi_2918_ = lt_bvh_triangle_Intersection();
                                                                                    phi_2919_ = true;
                                                                                }
                                                                                let _e2316 = phi_2918_;
                                                                                let _e2318 = phi_2919_;
                                                                                phi_2920_ = _e2316;
                                                                                phi_2921_ = _e2318;
                                                                            } else {
                                                                                phi_2920_ = lt_bvh_triangle_Intersection();
                                                                                phi_2921_ = true;
                                                                            }
                                                                            let _e2320 = phi_2920_;
                                                                            let _e2322 = phi_2921_;
                                                                            if _e2322 {
                                                                            }
                                                                            phi_2925_ = _e2320;
                                                                            phi_2926_ = _e2322;
                                                                        }
                                                                        let _e2324 = phi_2925_;
                                                                        let _e2326 = phi_2926_;
                                                                        phi_2927_ = _e2324;
                                                                        phi_2928_ = _e2166;
                                                                        phi_2929_ = _e2326;
                                                                    } else {
                                                                        phi_2927_ = lt_bvh_triangle_Intersection();
                                                                        phi_2928_ = true;
                                                                        phi_2929_ = false;
                                                                    }
                                                                    let _e2328 = phi_2927_;
                                                                    let _e2330 = phi_2928_;
                                                                    let _e2332 = phi_2929_;
                                                                    if _e2330 {
                                                                        phi_2933_ = true;
                                                                    } else {
                                                                        phi_2933_ = _e2332;
                                                                    }
                                                                    let _e2334 = phi_2933_;
                                                                    if _e2334 {
                                                                        phi_2937_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_2937_ = _e2328;
                                                                    }
                                                                    let _e2336 = phi_2937_;
                                                                    if _e2336.is_hit {
                                                                        if (_e2336.t > _e162.tmin) {
                                                                            if (_e2336.t < _e1962.t) {
                                                                                phi_2985_ = true;
                                                                            } else {
                                                                                if (_e2336.t == _e1962.t) {
                                                                                    if (_e1962.triangle != 4294967295u) {
                                                                                        if (_e1973 < _e1962.triangle) {
                                                                                            phi_2976_ = true;
                                                                                        } else {
                                                                                            if (_e1973 == _e1962.triangle) {
                                                                                                phi_2975_ = (_e988 < _e1962.instance);
                                                                                            } else {
                                                                                                phi_2975_ = false;
                                                                                            }
                                                                                            let _e2354 = phi_2975_;
                                                                                            phi_2976_ = _e2354;
                                                                                        }
                                                                                        let _e2356 = phi_2976_;
                                                                                        phi_2977_ = _e2356;
                                                                                        phi_2978_ = false;
                                                                                    } else {
                                                                                        phi_2977_ = bool();
                                                                                        phi_2978_ = true;
                                                                                    }
                                                                                    let _e2358 = phi_2977_;
                                                                                    let _e2360 = phi_2978_;
                                                                                    phi_2979_ = _e2358;
                                                                                    phi_2980_ = _e2360;
                                                                                } else {
                                                                                    phi_2979_ = bool();
                                                                                    phi_2980_ = true;
                                                                                }
                                                                                let _e2362 = phi_2979_;
                                                                                let _e2364 = phi_2980_;
                                                                                if _e2364 {
                                                                                    phi_2984_ = false;
                                                                                } else {
                                                                                    phi_2984_ = _e2362;
                                                                                }
                                                                                let _e2366 = phi_2984_;
                                                                                phi_2985_ = _e2366;
                                                                            }
                                                                            let _e2368 = phi_2985_;
                                                                            if _e2368 {
                                                                                let _e2370 = triangles.member[(0u + _e1973)].i0_;
                                                                                if ((_e2370 & 2147483648u) == 0u) {
                                                                                    phi_3196_ = true;
                                                                                } else {
                                                                                    if (_e1973 < _e81) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2379 = triangles.member[(0u + _e1973)].i0_;
                                                                                    let _e2380 = (_e2379 & 2147483647u);
                                                                                    let _e2382 = triangles.member[(0u + _e1973)].i1_;
                                                                                    let _e2384 = triangles.member[(0u + _e1973)].i2_;
                                                                                    if (_e2380 < _e84) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2388 = vertices.member[(0u + _e2380)];
                                                                                    if (_e2382 < _e84) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2392 = vertices.member[(0u + _e2382)];
                                                                                    if (_e2384 < _e84) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2396 = vertices.member[(0u + _e2384)];
                                                                                    let _e2397 = array<abi_Vertex, 3>(_e2388, _e2392, _e2396);
                                                                                    if (_e2397[0].material < _e87) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2403 = materials.member[(0u + _e2397[0].material)];
                                                                                    if ((_e2403.flags & 0u) == 0u) {
                                                                                        let _e2408 = ((1f - _e2336.u) - _e2336.v);
                                                                                        if (_e2403.cutoff <= 0f) {
                                                                                            phi_3191_ = true;
                                                                                        } else {
                                                                                            let _e2435 = (_e2403.base_color.w * ((((f32((_e2397[0].color >> bitcast<u32>(24i))) * _e2408) + (f32((_e2397[1].color >> bitcast<u32>(24i))) * _e2336.u)) + (f32((_e2397[2].color >> bitcast<u32>(24i))) * _e2336.v)) * (1f / 255f)));
                                                                                            if (_e2403.alpha_size == 0u) {
                                                                                                phi_3188_ = _e2435;
                                                                                            } else {
                                                                                                local_1.offset = _e2403.alpha_offset;
                                                                                                local_1.size = _e2403.alpha_size;
                                                                                                local_1.flags = _e2403.flags;
                                                                                                let _e2466 = _lt_shaders_texture_TextureView_quad((&local_1), (((_e2397[0].u * _e2408) + (_e2397[1].u * _e2336.u)) + (_e2397[2].u * _e2336.v)), (((_e2397[0].v * _e2408) + (_e2397[1].v * _e2336.u)) + (_e2397[2].v * _e2336.v)));
                                                                                                let _e2470 = (_e2466.indices[0] >> bitcast<u32>(2i));
                                                                                                if (_e2470 < _e96) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2474 = alpha_texels.member[(0u + _e2470)];
                                                                                                let _e2490 = (_e2466.indices[1] >> bitcast<u32>(2i));
                                                                                                if (_e2490 < _e96) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2494 = alpha_texels.member[(0u + _e2490)];
                                                                                                let _e2511 = (_e2466.indices[2] >> bitcast<u32>(2i));
                                                                                                if (_e2511 < _e96) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2515 = alpha_texels.member[(0u + _e2511)];
                                                                                                let _e2532 = (_e2466.indices[3] >> bitcast<u32>(2i));
                                                                                                if (_e2532 < _e96) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2536 = alpha_texels.member[(0u + _e2532)];
                                                                                                phi_3188_ = (_e2435 * (((((f32(((_e2474 >> bitcast<u32>((((_e2466.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2466.weights.x) + ((f32(((_e2494 >> bitcast<u32>((((_e2466.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2466.weights.y)) + ((f32(((_e2515 >> bitcast<u32>((((_e2466.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2466.weights.z)) + ((f32(((_e2536 >> bitcast<u32>((((_e2466.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2466.weights.w)));
                                                                                            }
                                                                                            let _e2552 = phi_3188_;
                                                                                            phi_3191_ = (_e2552 >= _e2403.cutoff);
                                                                                        }
                                                                                        let _e2556 = phi_3191_;
                                                                                        phi_3192_ = _e2556;
                                                                                    } else {
                                                                                        phi_3192_ = false;
                                                                                    }
                                                                                    let _e2558 = phi_3192_;
                                                                                    if _e2558 {
                                                                                    }
                                                                                    phi_3196_ = _e2558;
                                                                                }
                                                                                let _e2560 = phi_3196_;
                                                                                if _e2560 {
                                                                                    phi_3204_ = lt_bvh_Hit(_e2336.t, _e2336.u, _e2336.v, _e1973, _e988);
                                                                                } else {
                                                                                    phi_3204_ = _e1962;
                                                                                }
                                                                                let _e2566 = phi_3204_;
                                                                                phi_3205_ = _e2566;
                                                                            } else {
                                                                                phi_3205_ = _e1962;
                                                                            }
                                                                            let _e2568 = phi_3205_;
                                                                            phi_3206_ = _e2568;
                                                                        } else {
                                                                            phi_3206_ = _e1962;
                                                                        }
                                                                        let _e2570 = phi_3206_;
                                                                        phi_3207_ = _e2570;
                                                                    } else {
                                                                        phi_3207_ = _e1962;
                                                                    }
                                                                    let _e2572 = phi_3207_;
                                                                    phi_2464_ = _e2572;
                                                                    phi_2467_ = (_e1964 & (_e1964 - 1u));
                                                                    phi_3208_ = true;
                                                                }
                                                                let _e2574 = phi_2464_;
                                                                let _e2576 = phi_2467_;
                                                                let _e2578 = phi_3208_;
                                                                continue;
                                                                continuing {
                                                                    phi_2463_ = _e2574;
                                                                    phi_2466_ = _e2576;
                                                                    break if !(_e2578);
                                                                }
                                                            }
                                                            let _e2581 = local_2.group_mask;
                                                            if ((_e2581 & 4278190080u) == 0u) {
                                                                let _e2585 = local_2.len;
                                                                if (_e2585 == 0u) {
                                                                    phi_3247_ = false;
                                                                } else {
                                                                    let _e2589 = local_2.len;
                                                                    local_2.len = (_e2589 - 1u);
                                                                    let _e2592 = local_2.len;
                                                                    if (_e2592 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2597 = local_2.first[(0u + _e2592)];
                                                                    local_2.group = _e2597;
                                                                    let _e2600 = local_2.len;
                                                                    if (_e2600 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2605 = local_2.mask[(0u + _e2600)];
                                                                    local_2.group_mask = _e2605;
                                                                    phi_3247_ = true;
                                                                }
                                                                let _e2608 = phi_3247_;
                                                                phi_3248_ = _e2608;
                                                            } else {
                                                                phi_3248_ = true;
                                                            }
                                                            let _e2610 = phi_3248_;
                                                            if _e2610 {
                                                                let _e2612 = local_2.group_mask;
                                                                let _e2618 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2612)), 32u, (_e2612 == 0u)));
                                                                let _e2622 = local_2.group_mask;
                                                                let _e2636 = local_2.group_mask;
                                                                local_2.group_mask = (_e2636 & ~((1u << bitcast<u32>((_e2618 & 31u)))));
                                                                let _e2639 = local_2.group;
                                                                phi_3279_ = (_e2639 + countOneBits(((_e2622 & ~((4294967295u << bitcast<u32>((((_e2618 - 24u) ^ _e1385) & 31u))))) & 255u)));
                                                            } else {
                                                                phi_3279_ = 4294967295u;
                                                            }
                                                            let _e2642 = phi_3279_;
                                                            let _e3769 = local_10;
                                                            phi_2131_ = _e3769;
                                                            phi_2134_ = _e2642;
                                                        } else {
                                                            phi_2131_ = lt_bvh_Hit();
                                                            phi_2134_ = u32();
                                                        }
                                                        let _e2644 = phi_2131_;
                                                        let _e2646 = phi_2134_;
                                                        continue;
                                                        continuing {
                                                            phi_2130_ = _e2644;
                                                            phi_2133_ = _e2646;
                                                            break if !(_e1526);
                                                        }
                                                    }
                                                    let _e3773 = local_11;
                                                    phi_3280_ = _e3773;
                                                }
                                                let _e2649 = phi_3280_;
                                                phi_3281_ = _e2649;
                                                phi_3282_ = _e1211;
                                            } else {
                                                phi_3281_ = lt_bvh_Hit();
                                                phi_3282_ = true;
                                            }
                                            let _e2651 = phi_3281_;
                                            let _e2653 = phi_3282_;
                                            if _e2653 {
                                                phi_3286_ = _e980;
                                            } else {
                                                phi_3286_ = _e2651;
                                            }
                                            let _e2655 = phi_3286_;
                                            phi_3287_ = _e2655;
                                        } else {
                                            phi_3287_ = _e980;
                                        }
                                        let _e2657 = phi_3287_;
                                        phi_3288_ = _e2657;
                                    } else {
                                        phi_3288_ = _e980;
                                    }
                                    let _e2659 = phi_3288_;
                                    phi_3289_ = _e2659;
                                } else {
                                    phi_3289_ = _e980;
                                }
                                let _e2661 = phi_3289_;
                                phi_1505_ = (_e978 & (_e978 - 1u));
                                phi_1508_ = _e2661;
                                phi_3290_ = true;
                            }
                            let _e2663 = phi_1505_;
                            let _e2665 = phi_1508_;
                            let _e2667 = phi_3290_;
                            continue;
                            continuing {
                                phi_1504_ = _e2663;
                                phi_1507_ = _e2665;
                                break if !(_e2667);
                            }
                        }
                        let _e2670 = local_3.group_mask;
                        if ((_e2670 & 4278190080u) == 0u) {
                            let _e2674 = local_3.len;
                            if (_e2674 == 0u) {
                                phi_3329_ = false;
                            } else {
                                let _e2678 = local_3.len;
                                local_3.len = (_e2678 - 1u);
                                let _e2681 = local_3.len;
                                if (_e2681 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2686 = local_3.first[(0u + _e2681)];
                                local_3.group = _e2686;
                                let _e2689 = local_3.len;
                                if (_e2689 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2694 = local_3.mask[(0u + _e2689)];
                                local_3.group_mask = _e2694;
                                phi_3329_ = true;
                            }
                            let _e2697 = phi_3329_;
                            phi_3330_ = _e2697;
                        } else {
                            phi_3330_ = true;
                        }
                        let _e2699 = phi_3330_;
                        if _e2699 {
                            let _e2701 = local_3.group_mask;
                            let _e2707 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2701)), 32u, (_e2701 == 0u)));
                            let _e2711 = local_3.group_mask;
                            let _e2725 = local_3.group_mask;
                            local_3.group_mask = (_e2725 & ~((1u << bitcast<u32>((_e2707 & 31u)))));
                            let _e2728 = local_3.group;
                            phi_3361_ = (_e2728 + countOneBits(((_e2711 & ~((4294967295u << bitcast<u32>((((_e2707 - 24u) ^ _e397) & 31u))))) & 255u)));
                        } else {
                            phi_3361_ = 4294967295u;
                        }
                        let _e2731 = phi_3361_;
                        phi_1168_ = _e2731;
                        let _e3789 = local_12;
                        phi_1171_ = _e3789;
                    } else {
                        phi_1168_ = u32();
                        phi_1171_ = lt_bvh_Hit();
                    }
                    let _e2733 = phi_1168_;
                    let _e2735 = phi_1171_;
                    continue;
                    continuing {
                        phi_1167_ = _e2733;
                        phi_1170_ = _e2735;
                        break if !(_e538);
                    }
                }
                let _e3792 = local_13;
                phi_3362_ = _e3792;
            }
            let _e2738 = phi_3362_;
            phi_3363_ = _e2738;
            phi_3364_ = _e234;
        } else {
            phi_3363_ = lt_bvh_Hit();
            phi_3364_ = true;
        }
        let _e2740 = phi_3363_;
        let _e2742 = phi_3364_;
        if _e2742 {
            phi_3368_ = _e164;
        } else {
            phi_3368_ = _e2740;
        }
        let _e2744 = phi_3368_;
        if (_e2744.triangle != 4294967295u) {
            let _e2750 = ((1f - _e2744.u) - _e2744.v);
            if (_e2744.triangle < _e81) {
            } else {
                return;
            }
            let _e2755 = triangles.member[(0u + _e2744.triangle)];
            if (_e2744.instance < _e93) {
            } else {
                return;
            }
            let _e2766 = instances.member[(0u + _e2744.instance)].object_to_world[0u];
            let _e2777 = ((((_e2766.x * _e2755.v0_.x) + (_e2766.y * _e2755.v0_.y)) + (_e2766.z * _e2755.v0_.z)) + (_e2766.w * 1f));
            let _e2779 = instances.member[(0u + _e2744.instance)].object_to_world[1u];
            let _e2790 = ((((_e2779.x * _e2755.v0_.x) + (_e2779.y * _e2755.v0_.y)) + (_e2779.z * _e2755.v0_.z)) + (_e2779.w * 1f));
            let _e2792 = instances.member[(0u + _e2744.instance)].object_to_world[2u];
            let _e2803 = ((((_e2792.x * _e2755.v0_.x) + (_e2792.y * _e2755.v0_.y)) + (_e2792.z * _e2755.v0_.z)) + (_e2792.w * 1f));
            let _e2810 = instances.member[(0u + _e2744.instance)].object_to_world[0u];
            let _e2821 = ((((_e2810.x * _e2755.v1_.x) + (_e2810.y * _e2755.v1_.y)) + (_e2810.z * _e2755.v1_.z)) + (_e2810.w * 1f));
            let _e2823 = instances.member[(0u + _e2744.instance)].object_to_world[1u];
            let _e2834 = ((((_e2823.x * _e2755.v1_.x) + (_e2823.y * _e2755.v1_.y)) + (_e2823.z * _e2755.v1_.z)) + (_e2823.w * 1f));
            let _e2836 = instances.member[(0u + _e2744.instance)].object_to_world[2u];
            let _e2847 = ((((_e2836.x * _e2755.v1_.x) + (_e2836.y * _e2755.v1_.y)) + (_e2836.z * _e2755.v1_.z)) + (_e2836.w * 1f));
            let _e2854 = instances.member[(0u + _e2744.instance)].object_to_world[0u];
            let _e2865 = ((((_e2854.x * _e2755.v2_.x) + (_e2854.y * _e2755.v2_.y)) + (_e2854.z * _e2755.v2_.z)) + (_e2854.w * 1f));
            let _e2867 = instances.member[(0u + _e2744.instance)].object_to_world[1u];
            let _e2878 = ((((_e2867.x * _e2755.v2_.x) + (_e2867.y * _e2755.v2_.y)) + (_e2867.z * _e2755.v2_.z)) + (_e2867.w * 1f));
            let _e2880 = instances.member[(0u + _e2744.instance)].object_to_world[2u];
            let _e2891 = ((((_e2880.x * _e2755.v2_.x) + (_e2880.y * _e2755.v2_.y)) + (_e2880.z * _e2755.v2_.z)) + (_e2880.w * 1f));
            let _e2904 = (((_e2777 * _e2750) + (_e2821 * _e2744.u)) + (_e2865 * _e2744.v));
            let _e2905 = (((_e2790 * _e2750) + (_e2834 * _e2744.u)) + (_e2878 * _e2744.v));
            let _e2906 = (((_e2803 * _e2750) + (_e2847 * _e2744.u)) + (_e2891 * _e2744.v));
            let _e2908 = abs(_e2777);
            let _e2909 = abs(_e2790);
            let _e2910 = abs(_e2803);
            let _e2911 = abs(_e2821);
            let _e2912 = abs(_e2834);
            let _e2913 = abs(_e2847);
            if (_e2908 > _e2911) {
                phi_3555_ = _e2908;
            } else {
                phi_3555_ = _e2911;
            }
            let _e2916 = phi_3555_;
            if (_e2909 > _e2912) {
                phi_3560_ = _e2909;
            } else {
                phi_3560_ = _e2912;
            }
            let _e2919 = phi_3560_;
            if (_e2910 > _e2913) {
                phi_3565_ = _e2910;
            } else {
                phi_3565_ = _e2913;
            }
            let _e2922 = phi_3565_;
            let _e2923 = abs(_e2865);
            let _e2924 = abs(_e2878);
            let _e2925 = abs(_e2891);
            if (_e2916 > _e2923) {
                phi_3573_ = _e2916;
            } else {
                phi_3573_ = _e2923;
            }
            let _e2928 = phi_3573_;
            if (_e2919 > _e2924) {
                phi_3578_ = _e2919;
            } else {
                phi_3578_ = _e2924;
            }
            let _e2931 = phi_3578_;
            if (_e2922 > _e2925) {
                phi_3583_ = _e2922;
            } else {
                phi_3583_ = _e2925;
            }
            let _e2934 = phi_3583_;
            let _e2935 = (_e2821 - _e2777);
            let _e2936 = (_e2834 - _e2790);
            let _e2937 = (_e2847 - _e2803);
            let _e2938 = (_e2865 - _e2777);
            let _e2939 = (_e2878 - _e2790);
            let _e2940 = (_e2891 - _e2803);
            let _e2944 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2936), abs(_e2937));
            let _e2945 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2935), _e2944);
            let _e2946 = (_e2935 / _e2945);
            let _e2947 = (_e2936 / _e2945);
            let _e2948 = (_e2937 / _e2945);
            let _e2952 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2939), abs(_e2940));
            let _e2953 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2938), _e2952);
            let _e2954 = (_e2938 / _e2953);
            let _e2955 = (_e2939 / _e2953);
            let _e2956 = (_e2940 / _e2953);
            let _e2959 = ((_e2947 * _e2956) - (_e2955 * _e2948));
            let _e2962 = ((_e2948 * _e2954) - (_e2956 * _e2946));
            let _e2965 = ((_e2946 * _e2955) - (_e2954 * _e2947));
            let _e2967 = p.member.eye;
            let _e2980 = (1f / sqrt((((_e2959 * _e2959) + (_e2962 * _e2962)) + (_e2965 * _e2965))));
            let _e2981 = (_e2959 * _e2980);
            let _e2982 = (_e2962 * _e2980);
            let _e2983 = (_e2965 * _e2980);
            if ((((_e2981 * (_e2967.x - _e2904)) + (_e2982 * (_e2967.y - _e2905))) + (_e2983 * (_e2967.z - _e2906))) < 0f) {
                phi_3647_ = vec3<f32>(-(_e2981), -(_e2982), -(_e2983));
            } else {
                phi_3647_ = vec3<f32>(_e2981, _e2982, _e2983);
            }
            let _e2996 = phi_3647_;
            if (_e2744.triangle < _e81) {
            } else {
                return;
            }
            let _e3001 = triangles.member[(0u + _e2744.triangle)];
            let _e3003 = (_e3001.i0_ & 2147483647u);
            if (_e3003 < _e84) {
            } else {
                return;
            }
            let _e3009 = vertices.member[(0u + _e3003)];
            if (_e3001.i1_ < _e84) {
            } else {
                return;
            }
            let _e3013 = vertices.member[(0u + _e3001.i1_)];
            if (_e3001.i2_ < _e84) {
            } else {
                return;
            }
            let _e3017 = vertices.member[(0u + _e3001.i2_)];
            let _e3018 = array<abi_Vertex, 3>(_e3009, _e3013, _e3017);
            if (_e3018[0].material < _e87) {
            } else {
                return;
            }
            let _e3024 = materials.member[(0u + _e3018[0].material)];
            let _e3041 = (1f / 255f);
            let _e3060 = (1f / 255f);
            let _e3082 = (1f / 255f);
            if (_e3024.color_size == 0u) {
                phi_3890_ = vec3<f32>(1f, 1f, 1f);
            } else {
                local.offset = _e3024.color_offset;
                local.size = _e3024.color_size;
                local.flags = _e3024.flags;
                let _e3125 = _lt_shaders_texture_TextureView_quad((&local), (((_e3018[0].u * _e2750) + (_e3018[1].u * _e2744.u)) + (_e3018[2].u * _e2744.v)), (((_e3018[0].v * _e2750) + (_e3018[1].v * _e2744.u)) + (_e3018[2].v * _e2744.v)));
                if (_e3125.indices[0] < _e99) {
                } else {
                    return;
                }
                let _e3131 = color_texels.member[(0u + _e3125.indices[0])];
                let _e3142 = (1f / 255f);
                if (_e3125.indices[1] < _e99) {
                } else {
                    return;
                }
                let _e3156 = color_texels.member[(0u + _e3125.indices[1])];
                let _e3167 = (1f / 255f);
                if (_e3125.indices[2] < _e99) {
                } else {
                    return;
                }
                let _e3184 = color_texels.member[(0u + _e3125.indices[2])];
                let _e3195 = (1f / 255f);
                if (_e3125.indices[3] < _e99) {
                } else {
                    return;
                }
                let _e3212 = color_texels.member[(0u + _e3125.indices[3])];
                let _e3223 = (1f / 255f);
                let _e3232 = (((((f32((_e3131 & 255u)) * _e3142) * _e3125.weights.x) + ((f32((_e3156 & 255u)) * _e3167) * _e3125.weights.y)) + ((f32((_e3184 & 255u)) * _e3195) * _e3125.weights.z)) + ((f32((_e3212 & 255u)) * _e3223) * _e3125.weights.w));
                let _e3233 = (((((f32(((_e3131 >> bitcast<u32>(8i)) & 255u)) * _e3142) * _e3125.weights.x) + ((f32(((_e3156 >> bitcast<u32>(8i)) & 255u)) * _e3167) * _e3125.weights.y)) + ((f32(((_e3184 >> bitcast<u32>(8i)) & 255u)) * _e3195) * _e3125.weights.z)) + ((f32(((_e3212 >> bitcast<u32>(8i)) & 255u)) * _e3223) * _e3125.weights.w));
                let _e3234 = (((((f32(((_e3131 >> bitcast<u32>(16i)) & 255u)) * _e3142) * _e3125.weights.x) + ((f32(((_e3156 >> bitcast<u32>(16i)) & 255u)) * _e3167) * _e3125.weights.y)) + ((f32(((_e3184 >> bitcast<u32>(16i)) & 255u)) * _e3195) * _e3125.weights.z)) + ((f32(((_e3212 >> bitcast<u32>(16i)) & 255u)) * _e3223) * _e3125.weights.w));
                phi_3890_ = vec3<f32>((_e3232 * _e3232), (_e3233 * _e3233), (_e3234 * _e3234));
            }
            let _e3240 = phi_3890_;
            let _e3242 = ((_e3024.base_color.x * ((((f32((_e3018[0].color & 255u)) * _e3041) * _e2750) + ((f32((_e3018[1].color & 255u)) * _e3060) * _e2744.u)) + ((f32((_e3018[2].color & 255u)) * _e3082) * _e2744.v))) * _e3240.x);
            let _e3244 = ((_e3024.base_color.y * ((((f32(((_e3018[0].color >> bitcast<u32>(8i)) & 255u)) * _e3041) * _e2750) + ((f32(((_e3018[1].color >> bitcast<u32>(8i)) & 255u)) * _e3060) * _e2744.u)) + ((f32(((_e3018[2].color >> bitcast<u32>(8i)) & 255u)) * _e3082) * _e2744.v))) * _e3240.y);
            let _e3246 = ((_e3024.base_color.z * ((((f32(((_e3018[0].color >> bitcast<u32>(16i)) & 255u)) * _e3041) * _e2750) + ((f32(((_e3018[1].color >> bitcast<u32>(16i)) & 255u)) * _e3060) * _e2744.u)) + ((f32(((_e3018[2].color >> bitcast<u32>(16i)) & 255u)) * _e3082) * _e2744.v))) * _e3240.z);
            let _e3247 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e2931, _e2934);
            let _e3248 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e2928, _e3247);
            if ((_e3024.flags & 2u) == 0u) {
                phi_3905_ = 0u;
            } else {
                phi_3905_ = 1u;
            }
            let _e3253 = phi_3905_;
            if (_e3018[0].normal == 2147516416u) {
                phi_4135_ = _e2996;
            } else {
                let _e3266 = (f32((bitcast<i32>((_e3018[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3272 = (f32((bitcast<i32>(_e3018[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3276 = ((1f - abs(_e3266)) - abs(_e3272));
                if (_e3276 < 0f) {
                    phi_3932_ = -(_e3276);
                } else {
                    phi_3932_ = 0f;
                }
                let _e3280 = phi_3932_;
                if (_e3266 < 0f) {
                    phi_3939_ = (_e3266 + _e3280);
                } else {
                    phi_3939_ = (_e3266 - _e3280);
                }
                let _e3285 = phi_3939_;
                if (_e3272 < 0f) {
                    phi_3946_ = (_e3272 + _e3280);
                } else {
                    phi_3946_ = (_e3272 - _e3280);
                }
                let _e3290 = phi_3946_;
                let _e3297 = (1f / sqrt((((_e3285 * _e3285) + (_e3290 * _e3290)) + (_e3276 * _e3276))));
                let _e3313 = (f32((bitcast<i32>((_e3018[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3319 = (f32((bitcast<i32>(_e3018[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3323 = ((1f - abs(_e3313)) - abs(_e3319));
                if (_e3323 < 0f) {
                    phi_3981_ = -(_e3323);
                } else {
                    phi_3981_ = 0f;
                }
                let _e3327 = phi_3981_;
                if (_e3313 < 0f) {
                    phi_3988_ = (_e3313 + _e3327);
                } else {
                    phi_3988_ = (_e3313 - _e3327);
                }
                let _e3332 = phi_3988_;
                if (_e3319 < 0f) {
                    phi_3995_ = (_e3319 + _e3327);
                } else {
                    phi_3995_ = (_e3319 - _e3327);
                }
                let _e3337 = phi_3995_;
                let _e3344 = (1f / sqrt((((_e3332 * _e3332) + (_e3337 * _e3337)) + (_e3323 * _e3323))));
                let _e3363 = (f32((bitcast<i32>((_e3018[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3369 = (f32((bitcast<i32>(_e3018[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3373 = ((1f - abs(_e3363)) - abs(_e3369));
                if (_e3373 < 0f) {
                    phi_4033_ = -(_e3373);
                } else {
                    phi_4033_ = 0f;
                }
                let _e3377 = phi_4033_;
                if (_e3363 < 0f) {
                    phi_4040_ = (_e3363 + _e3377);
                } else {
                    phi_4040_ = (_e3363 - _e3377);
                }
                let _e3382 = phi_4040_;
                if (_e3369 < 0f) {
                    phi_4047_ = (_e3369 + _e3377);
                } else {
                    phi_4047_ = (_e3369 - _e3377);
                }
                let _e3387 = phi_4047_;
                let _e3394 = (1f / sqrt((((_e3382 * _e3382) + (_e3387 * _e3387)) + (_e3373 * _e3373))));
                let _e3401 = ((((_e3285 * _e3297) * _e2750) + ((_e3332 * _e3344) * _e2744.u)) + ((_e3382 * _e3394) * _e2744.v));
                let _e3402 = ((((_e3290 * _e3297) * _e2750) + ((_e3337 * _e3344) * _e2744.u)) + ((_e3387 * _e3394) * _e2744.v));
                let _e3403 = ((((_e3276 * _e3297) * _e2750) + ((_e3323 * _e3344) * _e2744.u)) + ((_e3373 * _e3394) * _e2744.v));
                if (_e2744.instance < _e93) {
                } else {
                    return;
                }
                let _e3410 = instances.member[(0u + _e2744.instance)].world_to_object[0u];
                let _e3419 = instances.member[(0u + _e2744.instance)].world_to_object[1u];
                let _e3431 = instances.member[(0u + _e2744.instance)].world_to_object[2u];
                let _e3438 = (((_e3410.x * _e3401) + (_e3419.x * _e3402)) + (_e3431.x * _e3403));
                let _e3439 = (((_e3410.y * _e3401) + (_e3419.y * _e3402)) + (_e3431.y * _e3403));
                let _e3440 = (((_e3410.z * _e3401) + (_e3419.z * _e3402)) + (_e3431.z * _e3403));
                let _e3446 = sqrt((((_e3438 * _e3438) + (_e3439 * _e3439)) + (_e3440 * _e3440)));
                if (_e3446 > 0f) {
                    let _e3448 = (_e3438 / _e3446);
                    let _e3449 = (_e3439 / _e3446);
                    let _e3450 = (_e3440 / _e3446);
                    if ((((_e3448 * _e2996.x) + (_e3449 * _e2996.y)) + (_e3450 * _e2996.z)) < 0f) {
                        phi_4133_ = vec3<f32>(-(_e3448), -(_e3449), -(_e3450));
                    } else {
                        phi_4133_ = vec3<f32>(_e3448, _e3449, _e3450);
                    }
                    let _e3466 = phi_4133_;
                    phi_4134_ = _e3466;
                } else {
                    phi_4134_ = _e2996;
                }
                let _e3468 = phi_4134_;
                phi_4135_ = _e3468;
            }
            let _e3470 = phi_4135_;
            if (_e3242 > 0f) {
                if (_e3242 < 1f) {
                    phi_4144_ = _e3242;
                } else {
                    phi_4144_ = 1f;
                }
                let _e3474 = phi_4144_;
                phi_4145_ = _e3474;
            } else {
                phi_4145_ = 0f;
            }
            let _e3476 = phi_4145_;
            if (_e3244 > 0f) {
                if (_e3244 < 1f) {
                    phi_4155_ = _e3244;
                } else {
                    phi_4155_ = 1f;
                }
                let _e3481 = phi_4155_;
                phi_4156_ = _e3481;
            } else {
                phi_4156_ = 0f;
            }
            let _e3483 = phi_4156_;
            if (_e3246 > 0f) {
                if (_e3246 < 1f) {
                    phi_4166_ = _e3246;
                } else {
                    phi_4166_ = 1f;
                }
                let _e3488 = phi_4166_;
                phi_4167_ = _e3488;
            } else {
                phi_4167_ = 0f;
            }
            let _e3490 = phi_4167_;
            let _e3493 = ((sqrt(_e3476) * 255f) + 0.5f);
            let _e3502 = ((sqrt(_e3483) * 255f) + 0.5f);
            let _e3514 = ((sqrt(_e3490) * 255f) + 0.5f);
            phi_4202_ = abi_Sample(vec3<f32>(_e2904, _e2905, _e2906), _e3248, _e2996, _e3253, _e3470, ((select(select(u32(_e3493), 0u, (_e3493 < bitcast<f32>(0u))), 4294967295u, (_e3493 > bitcast<f32>(1333788671u))) | (select(select(u32(_e3502), 0u, (_e3502 < bitcast<f32>(0u))), 4294967295u, (_e3502 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e3514), 0u, (_e3514 < bitcast<f32>(0u))), 4294967295u, (_e3514 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_4202_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e3528 = phi_4202_;
        if (_e105.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e105.first_primitive)] = _e3528;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_instanced_alpha_color_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
