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

struct abi_Sight {
    kept: vec3<f32>,
    t: f32,
}

struct type_58 {
    member: array<abi_Sight>,
}

struct type_61 {
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

struct u0028_abi_Sample_u0020_abi_Sight_u0029_ {
    unnamed: abi_Sample,
    unnamed_1: abi_Sight,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(3) 
var<storage> vertices: type_44;
@group(0) @binding(4) 
var<storage> materials: type_48;
@group(0) @binding(0) 
var<uniform> p: type_61;
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
@group(0) @binding(9) 
var<storage> before: type_28;
@group(0) @binding(10) 
var<storage, read_write> past: type_28;
@group(0) @binding(8) 
var<storage, read_write> sights: type_58;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_238_: lt_bvh_traverse_Tree;
    var phi_239_: bool;
    var phi_240_: lt_bvh_traverse_Tree;
    var phi_241_: bool;
    var phi_246_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_238_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_239_ = false;
        } else {
            phi_238_ = lt_bvh_traverse_Tree();
            phi_239_ = true;
        }
        let _e90 = phi_238_;
        let _e92 = phi_239_;
        phi_240_ = _e90;
        phi_241_ = _e92;
    } else {
        phi_240_ = lt_bvh_traverse_Tree();
        phi_241_ = true;
    }
    let _e94 = phi_240_;
    let _e96 = phi_241_;
    if _e96 {
        phi_246_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_246_ = _e94;
    }
    let _e101 = phi_246_;
    return lt_bvh_traverse_Tree(_e101.root, _e101.first_primitive);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_261_: bool;
    var phi_265_: f32;

    if (param_3 != param_3) {
        phi_261_ = true;
    } else {
        let _e80 = (param_4 >= param_3);
        if _e80 {
        }
        phi_261_ = _e80;
    }
    let _e82 = phi_261_;
    if _e82 {
        phi_265_ = param_4;
    } else {
        phi_265_ = param_3;
    }
    let _e84 = phi_265_;
    return _e84;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_277_: bool;
    var phi_281_: f32;

    if (param_5 != param_5) {
        phi_277_ = true;
    } else {
        let _e80 = (param_6 <= param_5);
        if _e80 {
        }
        phi_277_ = _e80;
    }
    let _e82 = phi_277_;
    if _e82 {
        phi_281_ = param_6;
    } else {
        phi_281_ = param_5;
    }
    let _e84 = phi_281_;
    return _e84;
}

fn _lt_shaders_texture_TextureView_quad(param_7: ptr<function, texture_TextureView>, param_8: f32, param_9: f32) -> texture_TexelQuad {
    var phi_323_: f32;
    var phi_328_: f32;
    var phi_329_: bool;
    var phi_330_: f32;
    var phi_331_: bool;
    var phi_335_: f32;
    var phi_361_: f32;
    var phi_366_: f32;
    var phi_367_: bool;
    var phi_368_: f32;
    var phi_369_: bool;
    var phi_373_: f32;
    var phi_381_: f32;
    var phi_382_: f32;
    var phi_383_: f32;
    var phi_392_: f32;
    var phi_393_: f32;
    var phi_411_: u32;
    var phi_425_: u32;
    var phi_432_: u32;
    var phi_437_: u32;
    var phi_443_: u32;
    var phi_448_: u32;
    var phi_450_: texture_Axis;
    var phi_478_: f32;
    var phi_483_: f32;
    var phi_484_: bool;
    var phi_485_: f32;
    var phi_486_: bool;
    var phi_490_: f32;
    var phi_516_: f32;
    var phi_521_: f32;
    var phi_522_: bool;
    var phi_523_: f32;
    var phi_524_: bool;
    var phi_528_: f32;
    var phi_536_: f32;
    var phi_537_: f32;
    var phi_538_: f32;
    var phi_547_: f32;
    var phi_548_: f32;
    var phi_566_: u32;
    var phi_580_: u32;
    var phi_587_: u32;
    var phi_592_: u32;
    var phi_598_: u32;
    var phi_603_: u32;
    var phi_605_: texture_Axis;

    let _e81 = (*param_7).size;
    let _e82 = (_e81 & 65535u);
    let _e84 = (*param_7).size;
    let _e86 = (_e84 >> bitcast<u32>(16i));
    let _e88 = (*param_7).flags;
    let _e90 = ((_e88 & 4u) != 0u);
    let _e92 = (*param_7).flags;
    let _e95 = ((_e92 >> bitcast<u32>(4u)) & 3u);
    if (_e95 == 0u) {
        if (param_8 > -8388608f) {
            let _e108 = f32(select(0i, select(select(i32(param_8), i32(-2147483648), (param_8 < bitcast<f32>(3472883712u))), 2147483647i, (param_8 > bitcast<f32>(1325400063u))), (param_8 == param_8)));
            if (_e108 > param_8) {
                phi_323_ = 1f;
            } else {
                phi_323_ = 0f;
            }
            let _e111 = phi_323_;
            if (param_8 < 8388608f) {
                phi_328_ = (_e108 - _e111);
                phi_329_ = false;
            } else {
                phi_328_ = f32();
                phi_329_ = true;
            }
            let _e114 = phi_328_;
            let _e116 = phi_329_;
            phi_330_ = _e114;
            phi_331_ = _e116;
        } else {
            phi_330_ = f32();
            phi_331_ = true;
        }
        let _e118 = phi_330_;
        let _e120 = phi_331_;
        if _e120 {
            phi_335_ = param_8;
        } else {
            phi_335_ = _e118;
        }
        let _e122 = phi_335_;
        phi_383_ = (param_8 - _e122);
    } else {
        if (_e95 == 1u) {
            let _e125 = (param_8 * 0.5f);
            if (_e125 > -8388608f) {
                let _e137 = f32(select(0i, select(select(i32(_e125), i32(-2147483648), (_e125 < bitcast<f32>(3472883712u))), 2147483647i, (_e125 > bitcast<f32>(1325400063u))), (_e125 == _e125)));
                if (_e137 > _e125) {
                    phi_361_ = 1f;
                } else {
                    phi_361_ = 0f;
                }
                let _e140 = phi_361_;
                if (_e125 < 8388608f) {
                    phi_366_ = (_e137 - _e140);
                    phi_367_ = false;
                } else {
                    phi_366_ = f32();
                    phi_367_ = true;
                }
                let _e143 = phi_366_;
                let _e145 = phi_367_;
                phi_368_ = _e143;
                phi_369_ = _e145;
            } else {
                phi_368_ = f32();
                phi_369_ = true;
            }
            let _e147 = phi_368_;
            let _e149 = phi_369_;
            if _e149 {
                phi_373_ = _e125;
            } else {
                phi_373_ = _e147;
            }
            let _e151 = phi_373_;
            let _e153 = (param_8 - (2f * _e151));
            if (_e153 > 1f) {
                phi_381_ = (2f - _e153);
            } else {
                phi_381_ = _e153;
            }
            let _e157 = phi_381_;
            phi_382_ = _e157;
        } else {
            phi_382_ = param_8;
        }
        let _e159 = phi_382_;
        phi_383_ = _e159;
    }
    let _e161 = phi_383_;
    if (_e161 > 0f) {
        if (_e161 < 1f) {
            phi_392_ = _e161;
        } else {
            phi_392_ = 1f;
        }
        let _e165 = phi_392_;
        phi_393_ = _e165;
    } else {
        phi_393_ = 0f;
    }
    let _e167 = phi_393_;
    let _e168 = (_e82 - 1u);
    let _e170 = (_e167 * f32(_e82));
    if _e90 {
        let _e177 = select(select(u32(_e170), 0u, (_e170 < bitcast<f32>(0u))), 4294967295u, (_e170 > bitcast<f32>(1333788671u)));
        if (_e168 < _e177) {
            phi_411_ = _e168;
        } else {
            phi_411_ = _e177;
        }
        let _e180 = phi_411_;
        phi_450_ = texture_Axis(_e180, _e180, 0f);
    } else {
        let _e182 = (_e170 + 0.5f);
        let _e189 = select(select(u32(_e182), 0u, (_e182 < bitcast<f32>(0u))), 4294967295u, (_e182 > bitcast<f32>(1333788671u)));
        if (_e82 < _e189) {
            phi_425_ = _e82;
        } else {
            phi_425_ = _e189;
        }
        let _e192 = phi_425_;
        if (_e95 == 0u) {
            phi_432_ = _e168;
        } else {
            phi_432_ = 0u;
        }
        let _e197 = phi_432_;
        if (_e95 == 0u) {
            phi_437_ = 0u;
        } else {
            phi_437_ = _e168;
        }
        let _e200 = phi_437_;
        if (_e192 == 0u) {
            phi_443_ = _e197;
        } else {
            phi_443_ = (_e192 - 1u);
        }
        let _e204 = phi_443_;
        if (_e192 > _e168) {
            phi_448_ = _e200;
        } else {
            phi_448_ = _e192;
        }
        let _e207 = phi_448_;
        phi_450_ = texture_Axis(_e204, _e207, (_e182 - f32(_e192)));
    }
    let _e210 = phi_450_;
    let _e212 = (*param_7).flags;
    let _e215 = ((_e212 >> bitcast<u32>(6u)) & 3u);
    if (_e215 == 0u) {
        if (param_9 > -8388608f) {
            let _e228 = f32(select(0i, select(select(i32(param_9), i32(-2147483648), (param_9 < bitcast<f32>(3472883712u))), 2147483647i, (param_9 > bitcast<f32>(1325400063u))), (param_9 == param_9)));
            if (_e228 > param_9) {
                phi_478_ = 1f;
            } else {
                phi_478_ = 0f;
            }
            let _e231 = phi_478_;
            if (param_9 < 8388608f) {
                phi_483_ = (_e228 - _e231);
                phi_484_ = false;
            } else {
                phi_483_ = f32();
                phi_484_ = true;
            }
            let _e234 = phi_483_;
            let _e236 = phi_484_;
            phi_485_ = _e234;
            phi_486_ = _e236;
        } else {
            phi_485_ = f32();
            phi_486_ = true;
        }
        let _e238 = phi_485_;
        let _e240 = phi_486_;
        if _e240 {
            phi_490_ = param_9;
        } else {
            phi_490_ = _e238;
        }
        let _e242 = phi_490_;
        phi_538_ = (param_9 - _e242);
    } else {
        if (_e215 == 1u) {
            let _e245 = (param_9 * 0.5f);
            if (_e245 > -8388608f) {
                let _e257 = f32(select(0i, select(select(i32(_e245), i32(-2147483648), (_e245 < bitcast<f32>(3472883712u))), 2147483647i, (_e245 > bitcast<f32>(1325400063u))), (_e245 == _e245)));
                if (_e257 > _e245) {
                    phi_516_ = 1f;
                } else {
                    phi_516_ = 0f;
                }
                let _e260 = phi_516_;
                if (_e245 < 8388608f) {
                    phi_521_ = (_e257 - _e260);
                    phi_522_ = false;
                } else {
                    phi_521_ = f32();
                    phi_522_ = true;
                }
                let _e263 = phi_521_;
                let _e265 = phi_522_;
                phi_523_ = _e263;
                phi_524_ = _e265;
            } else {
                phi_523_ = f32();
                phi_524_ = true;
            }
            let _e267 = phi_523_;
            let _e269 = phi_524_;
            if _e269 {
                phi_528_ = _e245;
            } else {
                phi_528_ = _e267;
            }
            let _e271 = phi_528_;
            let _e273 = (param_9 - (2f * _e271));
            if (_e273 > 1f) {
                phi_536_ = (2f - _e273);
            } else {
                phi_536_ = _e273;
            }
            let _e277 = phi_536_;
            phi_537_ = _e277;
        } else {
            phi_537_ = param_9;
        }
        let _e279 = phi_537_;
        phi_538_ = _e279;
    }
    let _e281 = phi_538_;
    if (_e281 > 0f) {
        if (_e281 < 1f) {
            phi_547_ = _e281;
        } else {
            phi_547_ = 1f;
        }
        let _e285 = phi_547_;
        phi_548_ = _e285;
    } else {
        phi_548_ = 0f;
    }
    let _e287 = phi_548_;
    let _e288 = (_e86 - 1u);
    let _e290 = (_e287 * f32(_e86));
    if _e90 {
        let _e297 = select(select(u32(_e290), 0u, (_e290 < bitcast<f32>(0u))), 4294967295u, (_e290 > bitcast<f32>(1333788671u)));
        if (_e288 < _e297) {
            phi_566_ = _e288;
        } else {
            phi_566_ = _e297;
        }
        let _e300 = phi_566_;
        phi_605_ = texture_Axis(_e300, _e300, 0f);
    } else {
        let _e302 = (_e290 + 0.5f);
        let _e309 = select(select(u32(_e302), 0u, (_e302 < bitcast<f32>(0u))), 4294967295u, (_e302 > bitcast<f32>(1333788671u)));
        if (_e86 < _e309) {
            phi_580_ = _e86;
        } else {
            phi_580_ = _e309;
        }
        let _e312 = phi_580_;
        if (_e215 == 0u) {
            phi_587_ = _e288;
        } else {
            phi_587_ = 0u;
        }
        let _e317 = phi_587_;
        if (_e215 == 0u) {
            phi_592_ = 0u;
        } else {
            phi_592_ = _e288;
        }
        let _e320 = phi_592_;
        if (_e312 == 0u) {
            phi_598_ = _e317;
        } else {
            phi_598_ = (_e312 - 1u);
        }
        let _e324 = phi_598_;
        if (_e312 > _e288) {
            phi_603_ = _e320;
        } else {
            phi_603_ = _e312;
        }
        let _e327 = phi_603_;
        phi_605_ = texture_Axis(_e324, _e327, (_e302 - f32(_e312)));
    }
    let _e330 = phi_605_;
    let _e334 = (*param_7).offset;
    let _e341 = (*param_7).offset;
    let _e348 = (*param_7).offset;
    let _e355 = (*param_7).offset;
    return texture_TexelQuad(array<u32, 4>(((_e334 + (_e330.low * _e82)) + _e210.low), ((_e341 + (_e330.low * _e82)) + _e210.high), ((_e348 + (_e330.high * _e82)) + _e210.low), ((_e355 + (_e330.high * _e82)) + _e210.high)), vec4<f32>(((1f - _e210.fraction) * (1f - _e330.fraction)), (_e210.fraction * (1f - _e330.fraction)), ((1f - _e210.fraction) * _e330.fraction), (_e210.fraction * _e330.fraction)));
}

fn _lt_bvh_ray_Ray_new(param_10: vec3<f32>, param_11: vec3<f32>) -> lt_bvh_Ray {
    return lt_bvh_Ray(param_10, 0f, param_11, 300000000000000000000000000000000000000f);
}

fn _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(param_12: f32, param_13: f32) -> f32 {
    var phi_664_: f32;

    if (param_12 > param_13) {
        phi_664_ = param_12;
    } else {
        phi_664_ = param_13;
    }
    let _e81 = phi_664_;
    return _e81;
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
    var local_2: texture_TextureView;
    var local_3: texture_TextureView;
    var local_4: texture_TextureView;
    var local_5: lt_bvh_traverse_Stack;
    var phi_745_: bool;
    var phi_746_: bool;
    var phi_747_: bool;
    var phi_751_: bool;
    var phi_851_: bool;
    var phi_852_: bool;
    var phi_853_: bool;
    var phi_854_: bool;
    var phi_858_: bool;
    var phi_871_: bool;
    var phi_872_: bool;
    var phi_873_: bool;
    var phi_874_: bool;
    var phi_878_: bool;
    var phi_891_: bool;
    var phi_892_: bool;
    var phi_893_: bool;
    var phi_897_: bool;
    var phi_898_: bool;
    var phi_899_: bool;
    var phi_900_: bool;
    var phi_901_: bool;
    var phi_905_: bool;
    var phi_979_: f32;
    var phi_986_: f32;
    var phi_994_: f32;
    var phi_1001_: f32;
    var phi_1009_: f32;
    var phi_1016_: f32;
    var phi_1039_: f32;
    var phi_1044_: f32;
    var phi_1049_: f32;
    var phi_1054_: f32;
    var phi_1059_: f32;
    var phi_1088_: bool;
    var phi_1089_: bool;
    var phi_1097_: u32;
    var phi_1098_: u32;
    var phi_1115_: vec3<f32>;
    var phi_1116_: vec3<f32>;
    var phi_1129_: u32;
    var phi_1134_: u32;
    var phi_1139_: u32;
    var phi_1253_: bool;
    var phi_1254_: bool;
    var phi_1285_: u32;
    var phi_1287_: lt_bvh_Hit;
    var phi_1290_: u32;
    var phi_1374_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1401_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1428_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1434_: u32;
    var phi_1437_: u32;
    var phi_1451_: u32;
    var phi_1461_: u32;
    var phi_1471_: u32;
    var phi_1489_: u32;
    var phi_1499_: u32;
    var phi_1509_: u32;
    var phi_1545_: u32;
    var phi_1558_: u32;
    var phi_1563_: u32;
    var phi_1564_: u32;
    var phi_1565_: u32;
    var phi_1435_: u32;
    var phi_1438_: u32;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_1623_: lt_bvh_Hit;
    var phi_1626_: u32;
    var phi_1672_: vec3<f32>;
    var phi_1673_: vec3<f32>;
    var phi_1704_: vec3<f32>;
    var phi_1705_: vec3<f32>;
    var phi_1736_: vec3<f32>;
    var phi_1737_: vec3<f32>;
    var phi_1755_: bool;
    var phi_1756_: bool;
    var phi_1760_: f32;
    var phi_1761_: f32;
    var phi_1762_: f32;
    var phi_1763_: f32;
    var phi_1771_: f32;
    var phi_1781_: bool;
    var phi_1782_: bool;
    var phi_1786_: f32;
    var phi_1787_: f32;
    var phi_1788_: f32;
    var phi_1789_: f32;
    var phi_1797_: f32;
    var phi_1807_: bool;
    var phi_1808_: bool;
    var phi_1812_: f32;
    var phi_1813_: f32;
    var phi_1814_: f32;
    var phi_1815_: f32;
    var phi_1823_: f32;
    var phi_1838_: f32;
    var phi_1839_: bool;
    var phi_1840_: f32;
    var phi_1841_: bool;
    var phi_1842_: f32;
    var phi_1843_: bool;
    var phi_1861_: f32;
    var phi_1862_: bool;
    var phi_1863_: bool;
    var phi_1864_: f32;
    var phi_1865_: bool;
    var phi_1866_: bool;
    var phi_1870_: bool;
    var phi_1871_: f32;
    var phi_1872_: bool;
    var phi_1902_: vec3<f32>;
    var phi_1903_: vec3<f32>;
    var phi_1928_: vec3<f32>;
    var phi_1929_: vec3<f32>;
    var phi_1954_: vec3<f32>;
    var phi_1955_: vec3<f32>;
    var phi_2011_: f32;
    var phi_2020_: f32;
    var phi_2029_: f32;
    var phi_2038_: f32;
    var phi_2045_: f32;
    var phi_2052_: f32;
    var phi_2065_: f32;
    var phi_2074_: f32;
    var phi_2083_: f32;
    var phi_2092_: f32;
    var phi_2099_: f32;
    var phi_2106_: f32;
    var phi_2129_: f32;
    var phi_2134_: f32;
    var phi_2139_: f32;
    var phi_2147_: f32;
    var phi_2152_: f32;
    var phi_2157_: f32;
    var phi_2169_: f32;
    var phi_2174_: f32;
    var phi_2179_: f32;
    var phi_2184_: f32;
    var phi_2189_: lt_bvh_triangle_Intersection;
    var phi_2190_: bool;
    var phi_2191_: lt_bvh_triangle_Intersection;
    var phi_2192_: bool;
    var phi_2196_: lt_bvh_triangle_Intersection;
    var phi_2197_: bool;
    var phi_2198_: lt_bvh_triangle_Intersection;
    var phi_2199_: bool;
    var phi_2200_: bool;
    var phi_2204_: bool;
    var phi_2208_: lt_bvh_triangle_Intersection;
    var phi_2246_: bool;
    var phi_2247_: bool;
    var phi_2248_: bool;
    var phi_2249_: bool;
    var phi_2250_: bool;
    var phi_2251_: bool;
    var phi_2255_: bool;
    var phi_2256_: bool;
    var phi_2459_: f32;
    var phi_2462_: bool;
    var phi_2463_: bool;
    var phi_2467_: bool;
    var phi_2475_: lt_bvh_Hit;
    var phi_2476_: lt_bvh_Hit;
    var phi_2477_: lt_bvh_Hit;
    var phi_2478_: lt_bvh_Hit;
    var phi_1624_: lt_bvh_Hit;
    var phi_1627_: u32;
    var phi_2479_: bool;
    var phi_2518_: bool;
    var phi_2519_: bool;
    var phi_2550_: u32;
    var phi_1288_: lt_bvh_Hit;
    var phi_1291_: u32;
    var phi_2551_: lt_bvh_Hit;
    var phi_2552_: lt_bvh_Hit;
    var phi_2553_: bool;
    var phi_2557_: lt_bvh_Hit;
    var phi_2559_: lt_bvh_Hit;
    var phi_2646_: f32;
    var phi_2651_: f32;
    var phi_2656_: f32;
    var phi_2667_: f32;
    var phi_2672_: f32;
    var phi_2677_: f32;
    var phi_2753_: vec3<f32>;
    var phi_2996_: vec3<f32>;
    var phi_3011_: u32;
    var phi_3038_: f32;
    var phi_3045_: f32;
    var phi_3052_: f32;
    var phi_3087_: f32;
    var phi_3094_: f32;
    var phi_3101_: f32;
    var phi_3139_: f32;
    var phi_3146_: f32;
    var phi_3153_: f32;
    var phi_3212_: vec3<f32>;
    var phi_3213_: vec3<f32>;
    var phi_3214_: vec3<f32>;
    var phi_3223_: f32;
    var phi_3224_: f32;
    var phi_3234_: f32;
    var phi_3235_: f32;
    var phi_3245_: f32;
    var phi_3246_: f32;
    var phi_3281_: abi_Sample;
    var phi_3487_: f32;
    var phi_3499_: f32;
    var phi_3508_: f32;
    var phi_3509_: f32;
    var phi_3510_: f32;
    var phi_3511_: f32;
    var phi_3523_: f32;
    var phi_3524_: f32;
    var phi_3656_: f32;
    var phi_3668_: f32;
    var phi_3677_: f32;
    var phi_3678_: f32;
    var phi_3679_: f32;
    var phi_3680_: f32;
    var phi_3879_: vec3<f32>;
    var phi_3903_: f32;
    var phi_3904_: f32;
    var phi_3913_: f32;
    var phi_3914_: f32;
    var phi_3923_: f32;
    var phi_3924_: f32;
    var phi_3962_: u0028_abi_Sample_u0020_abi_Sight_u0029_;
    var phi_3963_: u0028_abi_Sample_u0020_abi_Sight_u0029_;
    var phi_3966_: u0028_abi_Sample_u0020_abi_Sight_u0029_;
    var phi_3967_: u0028_abi_Sample_u0020_abi_Sight_u0029_;
    var phi_3968_: bool;
    var phi_3972_: u0028_abi_Sample_u0020_abi_Sight_u0029_;
    var phi_4071_: vec3<f32>;
    var local_9: lt_bvh_Hit;
    var local_10: lt_bvh_Hit;

    let _e83 = id_1;
    let _e87 = arrayLength((&nodes.member));
    let _e90 = arrayLength((&triangles.member));
    let _e93 = arrayLength((&vertices.member));
    let _e96 = arrayLength((&materials.member));
    let _e102 = arrayLength((&alpha_texels.member));
    let _e105 = arrayLength((&color_texels.member));
    let _e108 = arrayLength((&sights.member));
    let _e111 = arrayLength((&before.member));
    let _e117 = p.member.size[0u];
    let _e119 = p.member.size[1u];
    let _e120 = lt_shaders_entry_pixel_index(_e83, _e117, _e119);
    if (bitcast<i32>(_e120.root) != 0i) {
        if (_e120.first_primitive < _e108) {
        } else {
            return;
        }
        let _e128 = sights.member[(0u + _e120.first_primitive)];
        if (_e128.kept.x < 1f) {
            phi_746_ = bool();
            phi_747_ = true;
        } else {
            let _e136 = (_e128.kept.y < 1f);
            if _e136 {
                phi_745_ = bool();
            } else {
                phi_745_ = (_e128.kept.z < 1f);
            }
            let _e141 = phi_745_;
            phi_746_ = _e141;
            phi_747_ = _e136;
        }
        let _e143 = phi_746_;
        let _e145 = phi_747_;
        if _e145 {
            phi_751_ = true;
        } else {
            phi_751_ = _e143;
        }
        let _e147 = phi_751_;
        if _e147 {
            let _e150 = p.member.eye;
            let _e153 = p.member.grid[0u];
            let _e155 = p.member.grid[1u];
            let _e174 = p.member.size[0u];
            let _e178 = ((((f32(_e83.x) + ((f32((_e83.y & (_e155 - 1u))) + 0.5f) / f32(_e155))) / f32(_e174)) * 2f) - 1f);
            let _e181 = p.member.size[1u];
            let _e185 = (1f - (((f32(_e83.y) + ((f32((_e83.x & (_e153 - 1u))) + 0.5f) / f32(_e153))) / f32(_e181)) * 2f));
            let _e187 = p.member.forward;
            let _e189 = p.member.right;
            let _e203 = p.member.up;
            let _e214 = _lt_bvh_ray_Ray_new(_e150, vec3<f32>(((_e187.x + (_e189.x * _e178)) + (_e203.x * _e185)), ((_e187.y + (_e189.y * _e178)) + (_e203.y * _e185)), ((_e187.z + (_e189.z * _e178)) + (_e203.z * _e185))));
            let _e218 = lt_bvh_Hit(_e214.tmax, 0f, 0f, 4294967295u, 4294967295u);
            let _e220 = abs(_e214.direction.x);
            let _e222 = abs(_e214.direction.y);
            let _e224 = abs(_e214.direction.z);
            if (abs(_e214.origin.x) < 1000000000000000f) {
                if (abs(_e214.origin.y) < 1000000000000000f) {
                    phi_851_ = (abs(_e214.origin.z) < 1000000000000000f);
                    phi_852_ = false;
                } else {
                    phi_851_ = bool();
                    phi_852_ = true;
                }
                let _e235 = phi_851_;
                let _e237 = phi_852_;
                phi_853_ = _e235;
                phi_854_ = _e237;
            } else {
                phi_853_ = bool();
                phi_854_ = true;
            }
            let _e239 = phi_853_;
            let _e241 = phi_854_;
            if _e241 {
                phi_858_ = false;
            } else {
                phi_858_ = _e239;
            }
            let _e243 = phi_858_;
            if _e243 {
                if (_e220 < 1000000000000000f) {
                    if (_e222 < 1000000000000000f) {
                        phi_871_ = (_e224 < 1000000000000000f);
                        phi_872_ = false;
                    } else {
                        phi_871_ = bool();
                        phi_872_ = true;
                    }
                    let _e248 = phi_871_;
                    let _e250 = phi_872_;
                    phi_873_ = _e248;
                    phi_874_ = _e250;
                } else {
                    phi_873_ = bool();
                    phi_874_ = true;
                }
                let _e252 = phi_873_;
                let _e254 = phi_874_;
                if _e254 {
                    phi_878_ = false;
                } else {
                    phi_878_ = _e252;
                }
                let _e256 = phi_878_;
                if _e256 {
                    if (_e220 > 0f) {
                        phi_892_ = bool();
                        phi_893_ = true;
                    } else {
                        let _e258 = (_e222 > 0f);
                        if _e258 {
                            phi_891_ = bool();
                        } else {
                            phi_891_ = (_e224 > 0f);
                        }
                        let _e261 = phi_891_;
                        phi_892_ = _e261;
                        phi_893_ = _e258;
                    }
                    let _e263 = phi_892_;
                    let _e265 = phi_893_;
                    if _e265 {
                        phi_897_ = true;
                    } else {
                        phi_897_ = _e263;
                    }
                    let _e267 = phi_897_;
                    phi_898_ = _e267;
                    phi_899_ = false;
                } else {
                    phi_898_ = bool();
                    phi_899_ = true;
                }
                let _e269 = phi_898_;
                let _e271 = phi_899_;
                phi_900_ = _e269;
                phi_901_ = _e271;
            } else {
                phi_900_ = bool();
                phi_901_ = true;
            }
            let _e273 = phi_900_;
            let _e275 = phi_901_;
            if _e275 {
                phi_905_ = false;
            } else {
                phi_905_ = _e273;
            }
            let _e277 = phi_905_;
            if _e277 {
                let _e278 = (0u >= _e87);
                if _e278 {
                    phi_2551_ = lt_bvh_Hit();
                } else {
                    if (0u < _e87) {
                    } else {
                        return;
                    }
                    let _e284 = nodes.member[(0u + 0u)].frame[0u];
                    let _e288 = nodes.member[(0u + 0u)].frame[1u];
                    let _e292 = nodes.member[(0u + 0u)].frame[2u];
                    let _e296 = nodes.member[(0u + 0u)].frame[0u];
                    let _e300 = nodes.member[(0u + 0u)].frame[1u];
                    let _e304 = nodes.member[(0u + 0u)].frame[2u];
                    let _e308 = nodes.member[(0u + 0u)].frame[3u];
                    let _e345 = core_intrinsics_maximum_number_nsz_f32_(abs(_e214.direction.x), abs(_e214.direction.y));
                    let _e346 = core_intrinsics_maximum_number_nsz_f32_(_e345, abs(_e214.direction.z));
                    let _e347 = (_e346 * 0.0000000000009094947f);
                    if (abs(_e214.direction.x) < _e347) {
                        phi_979_ = _e347;
                    } else {
                        phi_979_ = abs(_e214.direction.x);
                    }
                    let _e353 = phi_979_;
                    if (_e214.direction.x < 0f) {
                        phi_986_ = (-1f / _e353);
                    } else {
                        phi_986_ = (1f / _e353);
                    }
                    let _e358 = phi_986_;
                    if (abs(_e214.direction.y) < _e347) {
                        phi_994_ = _e347;
                    } else {
                        phi_994_ = abs(_e214.direction.y);
                    }
                    let _e364 = phi_994_;
                    if (_e214.direction.y < 0f) {
                        phi_1001_ = (-1f / _e364);
                    } else {
                        phi_1001_ = (1f / _e364);
                    }
                    let _e369 = phi_1001_;
                    if (abs(_e214.direction.z) < _e347) {
                        phi_1009_ = _e347;
                    } else {
                        phi_1009_ = abs(_e214.direction.z);
                    }
                    let _e375 = phi_1009_;
                    if (_e214.direction.z < 0f) {
                        phi_1016_ = (-1f / _e375);
                    } else {
                        phi_1016_ = (1f / _e375);
                    }
                    let _e380 = phi_1016_;
                    let _e387 = abs((bitcast<f32>(_e284) - _e214.origin.x));
                    let _e388 = abs((bitcast<f32>(_e288) - _e214.origin.y));
                    let _e389 = abs((bitcast<f32>(_e292) - _e214.origin.z));
                    let _e396 = abs(((bitcast<f32>(_e296) + (bitcast<f32>((((_e308 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e214.origin.x));
                    let _e397 = abs(((bitcast<f32>(_e300) + (bitcast<f32>((((_e308 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e214.origin.y));
                    let _e398 = abs(((bitcast<f32>(_e304) + (bitcast<f32>((((_e308 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e214.origin.z));
                    if (_e387 > _e396) {
                        phi_1039_ = _e387;
                    } else {
                        phi_1039_ = _e396;
                    }
                    let _e401 = phi_1039_;
                    if (_e388 > _e397) {
                        phi_1044_ = _e388;
                    } else {
                        phi_1044_ = _e397;
                    }
                    let _e404 = phi_1044_;
                    if (_e389 > _e398) {
                        phi_1049_ = _e389;
                    } else {
                        phi_1049_ = _e398;
                    }
                    let _e407 = phi_1049_;
                    if (_e401 > _e404) {
                        phi_1054_ = _e401;
                    } else {
                        phi_1054_ = _e404;
                    }
                    let _e410 = phi_1054_;
                    if (_e410 > _e407) {
                        phi_1059_ = _e410;
                    } else {
                        phi_1059_ = _e407;
                    }
                    let _e413 = phi_1059_;
                    let _e417 = (_e413 * 0.0000019073486f);
                    let _e418 = (abs(_e358) * _e417);
                    let _e419 = (abs(_e369) * _e417);
                    let _e420 = (abs(_e380) * _e417);
                    let _e424 = (_e413 * 0.0000009536743f);
                    let _e425 = (abs(_e358) * _e424);
                    let _e426 = (abs(_e369) * _e424);
                    let _e427 = (abs(_e380) * _e424);
                    let _e429 = abs(_e214.direction.x);
                    let _e431 = abs(_e214.direction.y);
                    let _e433 = abs(_e214.direction.z);
                    if (_e429 >= _e431) {
                        if (_e429 >= _e433) {
                            phi_1088_ = false;
                        } else {
                            phi_1088_ = true;
                        }
                        let _e437 = phi_1088_;
                        phi_1089_ = _e437;
                    } else {
                        phi_1089_ = true;
                    }
                    let _e439 = phi_1089_;
                    if _e439 {
                        if (_e431 >= _e433) {
                            phi_1097_ = 1u;
                        } else {
                            phi_1097_ = 2u;
                        }
                        let _e442 = phi_1097_;
                        phi_1098_ = _e442;
                    } else {
                        phi_1098_ = 0u;
                    }
                    let _e444 = phi_1098_;
                    if (_e444 == 0u) {
                        phi_1116_ = vec3<f32>(_e214.direction.y, _e214.direction.z, _e214.direction.x);
                    } else {
                        if (_e444 == 1u) {
                            phi_1115_ = vec3<f32>(_e214.direction.z, _e214.direction.x, _e214.direction.y);
                        } else {
                            phi_1115_ = _e214.direction;
                        }
                        let _e456 = phi_1115_;
                        phi_1116_ = _e456;
                    }
                    let _e458 = phi_1116_;
                    let _e461 = (_e458.x / _e458.z);
                    let _e464 = (_e458.y / _e458.z);
                    if (_e358 < 0f) {
                        phi_1129_ = 0u;
                    } else {
                        phi_1129_ = 1u;
                    }
                    let _e469 = phi_1129_;
                    if (_e369 < 0f) {
                        phi_1134_ = 0u;
                    } else {
                        phi_1134_ = 2u;
                    }
                    let _e472 = phi_1134_;
                    if (_e380 < 0f) {
                        phi_1139_ = 0u;
                    } else {
                        phi_1139_ = 4u;
                    }
                    let _e475 = phi_1139_;
                    let _e477 = ((_e469 | _e472) | _e475);
                    let _e478 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                    local_5 = lt_bvh_traverse_Stack(array<u32, 32>(_e478.first[0], _e478.first[1], _e478.first[2], _e478.first[3], _e478.first[4], _e478.first[5], _e478.first[6], _e478.first[7], _e478.first[8], _e478.first[9], _e478.first[10], _e478.first[11], _e478.first[12], _e478.first[13], _e478.first[14], _e478.first[15], _e478.first[16], _e478.first[17], _e478.first[18], _e478.first[19], _e478.first[20], _e478.first[21], _e478.first[22], _e478.first[23], _e478.first[24], _e478.first[25], _e478.first[26], _e478.first[27], _e478.first[28], _e478.first[29], _e478.first[30], _e478.first[31]), array<u32, 32>(_e478.mask[0], _e478.mask[1], _e478.mask[2], _e478.mask[3], _e478.mask[4], _e478.mask[5], _e478.mask[6], _e478.mask[7], _e478.mask[8], _e478.mask[9], _e478.mask[10], _e478.mask[11], _e478.mask[12], _e478.mask[13], _e478.mask[14], _e478.mask[15], _e478.mask[16], _e478.mask[17], _e478.mask[18], _e478.mask[19], _e478.mask[20], _e478.mask[21], _e478.mask[22], _e478.mask[23], _e478.mask[24], _e478.mask[25], _e478.mask[26], _e478.mask[27], _e478.mask[28], _e478.mask[29], _e478.mask[30], _e478.mask[31]), _e478.len, _e478.group, _e478.group_mask);
                    let _e552 = local_5.group_mask;
                    if ((_e552 & 4278190080u) == 0u) {
                        let _e556 = local_5.len;
                        if (_e556 == 0u) {
                            phi_1253_ = false;
                        } else {
                            let _e560 = local_5.len;
                            local_5.len = (_e560 - 1u);
                            let _e563 = local_5.len;
                            if (_e563 < 32u) {
                            } else {
                                return;
                            }
                            let _e568 = local_5.first[(0u + _e563)];
                            local_5.group = _e568;
                            let _e571 = local_5.len;
                            if (_e571 < 32u) {
                            } else {
                                return;
                            }
                            let _e576 = local_5.mask[(0u + _e571)];
                            local_5.group_mask = _e576;
                            phi_1253_ = true;
                        }
                        let _e579 = phi_1253_;
                        phi_1254_ = _e579;
                    } else {
                        phi_1254_ = true;
                    }
                    let _e581 = phi_1254_;
                    if _e581 {
                        let _e583 = local_5.group_mask;
                        let _e589 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e583)), 32u, (_e583 == 0u)));
                        let _e593 = local_5.group_mask;
                        let _e607 = local_5.group_mask;
                        local_5.group_mask = (_e607 & ~((1u << bitcast<u32>((_e589 & 31u)))));
                        let _e610 = local_5.group;
                        phi_1285_ = (_e610 + countOneBits(((_e593 & ~((4294967295u << bitcast<u32>((((_e589 - 24u) ^ 7u) & 31u))))) & 255u)));
                    } else {
                        phi_1285_ = 4294967295u;
                    }
                    let _e613 = phi_1285_;
                    phi_1287_ = _e218;
                    phi_1290_ = _e613;
                    loop {
                        let _e615 = phi_1287_;
                        let _e617 = phi_1290_;
                        local_10 = _e615;
                        let _e618 = (_e617 != 4294967295u);
                        if _e618 {
                            if (_e617 < _e87) {
                            } else {
                                return;
                            }
                            let _e625 = nodes.member[(0u + _e617)].frame[3u];
                            let _e650 = (bitcast<f32>((((_e625 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e358);
                            let _e651 = (bitcast<f32>((((_e625 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e369);
                            let _e652 = (bitcast<f32>((((_e625 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e380);
                            let _e655 = nodes.member[(0u + _e617)].frame[0u];
                            let _e659 = nodes.member[(0u + _e617)].frame[1u];
                            let _e663 = nodes.member[(0u + _e617)].frame[2u];
                            let _e671 = ((bitcast<f32>(_e655) - _e214.origin.x) * _e358);
                            let _e672 = ((bitcast<f32>(_e659) - _e214.origin.y) * _e369);
                            let _e673 = ((bitcast<f32>(_e663) - _e214.origin.z) * _e380);
                            let _e681 = nodes.member[(0u + _e617)].x;
                            if (_e358 < 0f) {
                                let _e692 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e681.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e698 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e692.unnamed.root, _e681.w), _e692.unnamed_1);
                                let _e704 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e698.unnamed, lt_bvh_traverse_Tree(_e681.x, _e698.unnamed_1.first_primitive));
                                phi_1374_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e704.unnamed, lt_bvh_traverse_Tree(_e704.unnamed_1.root, _e681.y));
                            } else {
                                let _e720 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e681.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e726 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e720.unnamed.root, _e681.y), _e720.unnamed_1);
                                let _e732 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e726.unnamed, lt_bvh_traverse_Tree(_e681.z, _e726.unnamed_1.first_primitive));
                                phi_1374_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e732.unnamed, lt_bvh_traverse_Tree(_e732.unnamed_1.root, _e681.w));
                            }
                            let _e740 = phi_1374_;
                            let _e750 = nodes.member[(0u + _e617)].y;
                            if (_e369 < 0f) {
                                let _e761 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e750.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e767 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e761.unnamed.root, _e750.w), _e761.unnamed_1);
                                let _e773 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e767.unnamed, lt_bvh_traverse_Tree(_e750.x, _e767.unnamed_1.first_primitive));
                                phi_1401_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e773.unnamed, lt_bvh_traverse_Tree(_e773.unnamed_1.root, _e750.y));
                            } else {
                                let _e789 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e750.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e795 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e789.unnamed.root, _e750.y), _e789.unnamed_1);
                                let _e801 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e795.unnamed, lt_bvh_traverse_Tree(_e750.z, _e795.unnamed_1.first_primitive));
                                phi_1401_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e801.unnamed, lt_bvh_traverse_Tree(_e801.unnamed_1.root, _e750.w));
                            }
                            let _e809 = phi_1401_;
                            let _e819 = nodes.member[(0u + _e617)].z;
                            if (_e380 < 0f) {
                                let _e830 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e819.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e836 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e830.unnamed.root, _e819.w), _e830.unnamed_1);
                                let _e842 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e836.unnamed, lt_bvh_traverse_Tree(_e819.x, _e836.unnamed_1.first_primitive));
                                phi_1428_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e842.unnamed, lt_bvh_traverse_Tree(_e842.unnamed_1.root, _e819.y));
                            } else {
                                let _e858 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e819.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e864 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e858.unnamed.root, _e819.y), _e858.unnamed_1);
                                let _e870 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e864.unnamed, lt_bvh_traverse_Tree(_e819.z, _e864.unnamed_1.first_primitive));
                                phi_1428_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e870.unnamed, lt_bvh_traverse_Tree(_e870.unnamed_1.root, _e819.w));
                            }
                            let _e878 = phi_1428_;
                            phi_1434_ = 0u;
                            phi_1437_ = 0u;
                            loop {
                                let _e888 = phi_1434_;
                                let _e890 = phi_1437_;
                                local_6 = _e890;
                                local_7 = _e890;
                                local_8 = _e890;
                                let _e891 = (_e888 < 8u);
                                if _e891 {
                                    let _e893 = (_e888 >> bitcast<u32>(2i));
                                    let _e894 = (_e888 & 3u);
                                    if (_e893 == 0u) {
                                        phi_1451_ = _e740.unnamed.root;
                                    } else {
                                        phi_1451_ = _e740.unnamed.first_primitive;
                                    }
                                    let _e897 = phi_1451_;
                                    if (_e893 == 0u) {
                                        phi_1461_ = _e809.unnamed.root;
                                    } else {
                                        phi_1461_ = _e809.unnamed.first_primitive;
                                    }
                                    let _e906 = phi_1461_;
                                    if (_e893 == 0u) {
                                        phi_1471_ = _e878.unnamed.root;
                                    } else {
                                        phi_1471_ = _e878.unnamed.first_primitive;
                                    }
                                    let _e915 = phi_1471_;
                                    let _e928 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e897 >> bitcast<u32>(((_e894 * 8u) & 31u))) & 255u)) * _e650) + (_e671 - _e418)), ((f32(((_e906 >> bitcast<u32>(((_e894 * 8u) & 31u))) & 255u)) * _e651) + (_e672 - _e419)));
                                    let _e929 = core_intrinsics_maximum_number_nsz_f32_(_e928, ((f32(((_e915 >> bitcast<u32>(((_e894 * 8u) & 31u))) & 255u)) * _e652) + (_e673 - _e420)));
                                    if (_e893 == 0u) {
                                        phi_1489_ = _e740.unnamed_1.root;
                                    } else {
                                        phi_1489_ = _e740.unnamed_1.first_primitive;
                                    }
                                    let _e932 = phi_1489_;
                                    if (_e893 == 0u) {
                                        phi_1499_ = _e809.unnamed_1.root;
                                    } else {
                                        phi_1499_ = _e809.unnamed_1.first_primitive;
                                    }
                                    let _e941 = phi_1499_;
                                    if (_e893 == 0u) {
                                        phi_1509_ = _e878.unnamed_1.root;
                                    } else {
                                        phi_1509_ = _e878.unnamed_1.first_primitive;
                                    }
                                    let _e950 = phi_1509_;
                                    let _e963 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e932 >> bitcast<u32>(((_e894 * 8u) & 31u))) & 255u)) * _e650) + (_e671 + _e418)), ((f32(((_e941 >> bitcast<u32>(((_e894 * 8u) & 31u))) & 255u)) * _e651) + (_e672 + _e419)));
                                    let _e964 = core_intrinsics_minimum_number_nsz_f32_(_e963, ((f32(((_e950 >> bitcast<u32>(((_e894 * 8u) & 31u))) & 255u)) * _e652) + (_e673 + _e420)));
                                    if (_e929 <= _e964) {
                                        if (_e929 <= _e615.t) {
                                            if (_e964 >= _e128.t) {
                                                if (_e893 == 0u) {
                                                    let _e971 = nodes.member[(0u + _e617)].links[2u];
                                                    phi_1545_ = _e971;
                                                } else {
                                                    let _e974 = nodes.member[(0u + _e617)].links[3u];
                                                    phi_1545_ = _e974;
                                                }
                                                let _e976 = phi_1545_;
                                                let _e981 = ((_e976 >> bitcast<u32>(((_e894 * 8u) & 31u))) & 255u);
                                                let _e982 = (_e981 & 31u);
                                                if (_e982 >= 24u) {
                                                    phi_1558_ = (24u + ((_e982 - 24u) ^ _e477));
                                                } else {
                                                    phi_1558_ = _e982;
                                                }
                                                let _e988 = phi_1558_;
                                                phi_1563_ = (_e890 | ((_e981 >> bitcast<u32>(5i)) << bitcast<u32>((_e988 & 31u))));
                                            } else {
                                                phi_1563_ = _e890;
                                            }
                                            let _e996 = phi_1563_;
                                            phi_1564_ = _e996;
                                        } else {
                                            phi_1564_ = _e890;
                                        }
                                        let _e998 = phi_1564_;
                                        phi_1565_ = _e998;
                                    } else {
                                        phi_1565_ = _e890;
                                    }
                                    let _e1000 = phi_1565_;
                                    phi_1435_ = (_e888 + 1u);
                                    phi_1438_ = _e1000;
                                } else {
                                    phi_1435_ = u32();
                                    phi_1438_ = u32();
                                }
                                let _e1003 = phi_1435_;
                                let _e1005 = phi_1438_;
                                continue;
                                continuing {
                                    phi_1434_ = _e1003;
                                    phi_1437_ = _e1005;
                                    break if !(_e891);
                                }
                            }
                            let _e1009 = nodes.member[(0u + _e617)].links[0u];
                            let _e1013 = nodes.member[(0u + _e617)].frame[3u];
                            let _e1017 = local_6;
                            if ((_e1017 & 4278190080u) == 0u) {
                            } else {
                                let _e1021 = local_5.group_mask;
                                if ((_e1021 & 4278190080u) == 0u) {
                                } else {
                                    let _e1025 = local_5.len;
                                    if (_e1025 < 32u) {
                                        let _e1028 = local_5.group;
                                        let _e1030 = local_5.len;
                                        if (_e1030 < 32u) {
                                        } else {
                                            return;
                                        }
                                        local_5.first[(0u + _e1030)] = _e1028;
                                        let _e1036 = local_5.group_mask;
                                        let _e1038 = local_5.len;
                                        if (_e1038 < 32u) {
                                        } else {
                                            return;
                                        }
                                        local_5.mask[(0u + _e1038)] = _e1036;
                                        let _e1045 = local_5.len;
                                        local_5.len = (_e1045 + 1u);
                                    }
                                }
                                local_5.group = (0u + _e1009);
                                let _e1049 = local_7;
                                local_5.group_mask = ((_e1049 & 4278190080u) | (_e1013 >> bitcast<u32>(24i)));
                            }
                            let _e1054 = local_8;
                            phi_1623_ = _e615;
                            phi_1626_ = (_e1054 & 16777215u);
                            loop {
                                let _e1057 = phi_1623_;
                                let _e1059 = phi_1626_;
                                local_9 = _e1057;
                                if (_e1059 == 0u) {
                                    phi_1624_ = lt_bvh_Hit();
                                    phi_1627_ = u32();
                                    phi_2479_ = false;
                                } else {
                                    let _e1063 = nodes.member[(0u + _e617)].links[1u];
                                    let _e1068 = ((0u + _e1063) + select(firstTrailingBit(_e1059), 32u, (_e1059 == 0u)));
                                    if (_e1068 < _e90) {
                                    } else {
                                        return;
                                    }
                                    let _e1075 = triangles.member[(0u + _e1068)].v0_;
                                    let _e1078 = (_e1075.x - _e214.origin.x);
                                    let _e1081 = (_e1075.y - _e214.origin.y);
                                    let _e1084 = (_e1075.z - _e214.origin.z);
                                    if (_e444 == 0u) {
                                        phi_1673_ = vec3<f32>(_e1081, _e1084, _e1078);
                                    } else {
                                        if (_e444 == 1u) {
                                            phi_1672_ = vec3<f32>(_e1084, _e1078, _e1081);
                                        } else {
                                            phi_1672_ = (_e1075 - _e214.origin);
                                        }
                                        let _e1091 = phi_1672_;
                                        phi_1673_ = _e1091;
                                    }
                                    let _e1093 = phi_1673_;
                                    let _e1097 = (_e1093.x - (_e461 * _e1093.z));
                                    let _e1101 = (_e1093.y - (_e464 * _e1093.z));
                                    let _e1103 = triangles.member[(0u + _e1068)].v1_;
                                    let _e1106 = (_e1103.x - _e214.origin.x);
                                    let _e1109 = (_e1103.y - _e214.origin.y);
                                    let _e1112 = (_e1103.z - _e214.origin.z);
                                    if (_e444 == 0u) {
                                        phi_1705_ = vec3<f32>(_e1109, _e1112, _e1106);
                                    } else {
                                        if (_e444 == 1u) {
                                            phi_1704_ = vec3<f32>(_e1112, _e1106, _e1109);
                                        } else {
                                            phi_1704_ = (_e1103 - _e214.origin);
                                        }
                                        let _e1119 = phi_1704_;
                                        phi_1705_ = _e1119;
                                    }
                                    let _e1121 = phi_1705_;
                                    let _e1125 = (_e1121.x - (_e461 * _e1121.z));
                                    let _e1129 = (_e1121.y - (_e464 * _e1121.z));
                                    let _e1131 = triangles.member[(0u + _e1068)].v2_;
                                    let _e1134 = (_e1131.x - _e214.origin.x);
                                    let _e1137 = (_e1131.y - _e214.origin.y);
                                    let _e1140 = (_e1131.z - _e214.origin.z);
                                    if (_e444 == 0u) {
                                        phi_1737_ = vec3<f32>(_e1137, _e1140, _e1134);
                                    } else {
                                        if (_e444 == 1u) {
                                            phi_1736_ = vec3<f32>(_e1140, _e1134, _e1137);
                                        } else {
                                            phi_1736_ = (_e1131 - _e214.origin);
                                        }
                                        let _e1147 = phi_1736_;
                                        phi_1737_ = _e1147;
                                    }
                                    let _e1149 = phi_1737_;
                                    let _e1153 = (_e1149.x - (_e461 * _e1149.z));
                                    let _e1157 = (_e1149.y - (_e464 * _e1149.z));
                                    if (_e1125 < _e1153) {
                                        phi_1756_ = true;
                                    } else {
                                        if (_e1125 == _e1153) {
                                            phi_1755_ = (_e1129 < _e1157);
                                        } else {
                                            phi_1755_ = false;
                                        }
                                        let _e1162 = phi_1755_;
                                        phi_1756_ = _e1162;
                                    }
                                    let _e1164 = phi_1756_;
                                    if _e1164 {
                                        phi_1760_ = _e1157;
                                        phi_1761_ = _e1153;
                                        phi_1762_ = _e1129;
                                        phi_1763_ = _e1125;
                                    } else {
                                        phi_1760_ = _e1129;
                                        phi_1761_ = _e1125;
                                        phi_1762_ = _e1157;
                                        phi_1763_ = _e1153;
                                    }
                                    let _e1166 = phi_1760_;
                                    let _e1168 = phi_1761_;
                                    let _e1170 = phi_1762_;
                                    let _e1172 = phi_1763_;
                                    let _e1175 = ((_e1172 * _e1166) - (_e1170 * _e1168));
                                    if _e1164 {
                                        phi_1771_ = -(_e1175);
                                    } else {
                                        phi_1771_ = _e1175;
                                    }
                                    let _e1178 = phi_1771_;
                                    if (_e1153 < _e1097) {
                                        phi_1782_ = true;
                                    } else {
                                        if (_e1153 == _e1097) {
                                            phi_1781_ = (_e1157 < _e1101);
                                        } else {
                                            phi_1781_ = false;
                                        }
                                        let _e1183 = phi_1781_;
                                        phi_1782_ = _e1183;
                                    }
                                    let _e1185 = phi_1782_;
                                    if _e1185 {
                                        phi_1786_ = _e1101;
                                        phi_1787_ = _e1097;
                                        phi_1788_ = _e1157;
                                        phi_1789_ = _e1153;
                                    } else {
                                        phi_1786_ = _e1157;
                                        phi_1787_ = _e1153;
                                        phi_1788_ = _e1101;
                                        phi_1789_ = _e1097;
                                    }
                                    let _e1187 = phi_1786_;
                                    let _e1189 = phi_1787_;
                                    let _e1191 = phi_1788_;
                                    let _e1193 = phi_1789_;
                                    let _e1196 = ((_e1193 * _e1187) - (_e1191 * _e1189));
                                    if _e1185 {
                                        phi_1797_ = -(_e1196);
                                    } else {
                                        phi_1797_ = _e1196;
                                    }
                                    let _e1199 = phi_1797_;
                                    if (_e1097 < _e1125) {
                                        phi_1808_ = true;
                                    } else {
                                        if (_e1097 == _e1125) {
                                            phi_1807_ = (_e1101 < _e1129);
                                        } else {
                                            phi_1807_ = false;
                                        }
                                        let _e1204 = phi_1807_;
                                        phi_1808_ = _e1204;
                                    }
                                    let _e1206 = phi_1808_;
                                    if _e1206 {
                                        phi_1812_ = _e1129;
                                        phi_1813_ = _e1125;
                                        phi_1814_ = _e1101;
                                        phi_1815_ = _e1097;
                                    } else {
                                        phi_1812_ = _e1101;
                                        phi_1813_ = _e1097;
                                        phi_1814_ = _e1129;
                                        phi_1815_ = _e1125;
                                    }
                                    let _e1208 = phi_1812_;
                                    let _e1210 = phi_1813_;
                                    let _e1212 = phi_1814_;
                                    let _e1214 = phi_1815_;
                                    let _e1217 = ((_e1214 * _e1208) - (_e1212 * _e1210));
                                    if _e1206 {
                                        phi_1823_ = -(_e1217);
                                    } else {
                                        phi_1823_ = _e1217;
                                    }
                                    let _e1220 = phi_1823_;
                                    if (_e1178 >= 0f) {
                                        if (_e1199 >= 0f) {
                                            if (_e1220 >= 0f) {
                                                phi_1838_ = ((_e1178 + _e1199) + _e1220);
                                                phi_1839_ = false;
                                            } else {
                                                phi_1838_ = f32();
                                                phi_1839_ = true;
                                            }
                                            let _e1227 = phi_1838_;
                                            let _e1229 = phi_1839_;
                                            phi_1840_ = _e1227;
                                            phi_1841_ = _e1229;
                                        } else {
                                            phi_1840_ = f32();
                                            phi_1841_ = true;
                                        }
                                        let _e1231 = phi_1840_;
                                        let _e1233 = phi_1841_;
                                        phi_1842_ = _e1231;
                                        phi_1843_ = _e1233;
                                    } else {
                                        phi_1842_ = f32();
                                        phi_1843_ = true;
                                    }
                                    let _e1235 = phi_1842_;
                                    let _e1237 = phi_1843_;
                                    if _e1237 {
                                        if (_e1178 <= 0f) {
                                            if (_e1199 <= 0f) {
                                                let _e1240 = (_e1220 <= 0f);
                                                if _e1240 {
                                                }
                                                phi_1861_ = ((_e1178 + _e1199) + _e1220);
                                                phi_1862_ = false;
                                                phi_1863_ = _e1240;
                                            } else {
                                                phi_1861_ = f32();
                                                phi_1862_ = true;
                                                phi_1863_ = false;
                                            }
                                            let _e1244 = phi_1861_;
                                            let _e1246 = phi_1862_;
                                            let _e1248 = phi_1863_;
                                            phi_1864_ = _e1244;
                                            phi_1865_ = _e1246;
                                            phi_1866_ = _e1248;
                                        } else {
                                            phi_1864_ = f32();
                                            phi_1865_ = true;
                                            phi_1866_ = false;
                                        }
                                        let _e1250 = phi_1864_;
                                        let _e1252 = phi_1865_;
                                        let _e1254 = phi_1866_;
                                        if _e1252 {
                                            phi_1870_ = false;
                                        } else {
                                            phi_1870_ = _e1254;
                                        }
                                        let _e1256 = phi_1870_;
                                        phi_1871_ = _e1250;
                                        phi_1872_ = _e1256;
                                    } else {
                                        phi_1871_ = _e1235;
                                        phi_1872_ = true;
                                    }
                                    let _e1258 = phi_1871_;
                                    let _e1260 = phi_1872_;
                                    if _e1260 {
                                        let _e1261 = (_e1258 == 0f);
                                        if _e1261 {
                                            phi_2196_ = lt_bvh_triangle_Intersection();
                                            phi_2197_ = false;
                                        } else {
                                            let _e1263 = triangles.member[(0u + _e1068)].v0_;
                                            let _e1266 = (_e1263.x - _e214.origin.x);
                                            let _e1269 = (_e1263.y - _e214.origin.y);
                                            let _e1272 = (_e1263.z - _e214.origin.z);
                                            if (_e444 == 0u) {
                                                phi_1903_ = vec3<f32>(_e1269, _e1272, _e1266);
                                            } else {
                                                if (_e444 == 1u) {
                                                    phi_1902_ = vec3<f32>(_e1272, _e1266, _e1269);
                                                } else {
                                                    phi_1902_ = (_e1263 - _e214.origin);
                                                }
                                                let _e1279 = phi_1902_;
                                                phi_1903_ = _e1279;
                                            }
                                            let _e1281 = phi_1903_;
                                            let _e1283 = triangles.member[(0u + _e1068)].v1_;
                                            let _e1285 = triangles.member[(0u + _e1068)].v0_;
                                            let _e1288 = (_e1283.x - _e1285.x);
                                            let _e1291 = (_e1283.y - _e1285.y);
                                            let _e1294 = (_e1283.z - _e1285.z);
                                            if (_e444 == 0u) {
                                                phi_1929_ = vec3<f32>(_e1291, _e1294, _e1288);
                                            } else {
                                                if (_e444 == 1u) {
                                                    phi_1928_ = vec3<f32>(_e1294, _e1288, _e1291);
                                                } else {
                                                    phi_1928_ = (_e1283 - _e1285);
                                                }
                                                let _e1301 = phi_1928_;
                                                phi_1929_ = _e1301;
                                            }
                                            let _e1303 = phi_1929_;
                                            let _e1305 = triangles.member[(0u + _e1068)].v2_;
                                            let _e1307 = triangles.member[(0u + _e1068)].v0_;
                                            let _e1310 = (_e1305.x - _e1307.x);
                                            let _e1313 = (_e1305.y - _e1307.y);
                                            let _e1316 = (_e1305.z - _e1307.z);
                                            if (_e444 == 0u) {
                                                phi_1955_ = vec3<f32>(_e1313, _e1316, _e1310);
                                            } else {
                                                if (_e444 == 1u) {
                                                    phi_1954_ = vec3<f32>(_e1316, _e1310, _e1313);
                                                } else {
                                                    phi_1954_ = (_e1305 - _e1307);
                                                }
                                                let _e1323 = phi_1954_;
                                                phi_1955_ = _e1323;
                                            }
                                            let _e1325 = phi_1955_;
                                            let _e1332 = ((_e1303.y * _e1325.z) - (_e1303.z * _e1325.y));
                                            let _e1339 = ((_e1303.z * _e1325.x) - (_e1303.x * _e1325.z));
                                            let _e1346 = ((_e1303.x * _e1325.y) - (_e1303.y * _e1325.x));
                                            let _e1360 = (((1f / _e458.z) * (((_e1332 * _e1281.x) + (_e1339 * _e1281.y)) + (_e1346 * _e1281.z))) / (((_e1332 * _e461) + (_e1339 * _e464)) + _e1346));
                                            if (_e1360 > _e128.t) {
                                                if (_e1360 < _e214.tmax) {
                                                    let _e1364 = triangles.member[(0u + _e1068)].v0_;
                                                    let _e1366 = triangles.member[(0u + _e1068)].v1_;
                                                    if (_e1364.x < _e1366.x) {
                                                        phi_2011_ = _e1364.x;
                                                    } else {
                                                        phi_2011_ = _e1366.x;
                                                    }
                                                    let _e1373 = phi_2011_;
                                                    if (_e1364.y < _e1366.y) {
                                                        phi_2020_ = _e1364.y;
                                                    } else {
                                                        phi_2020_ = _e1366.y;
                                                    }
                                                    let _e1380 = phi_2020_;
                                                    if (_e1364.z < _e1366.z) {
                                                        phi_2029_ = _e1364.z;
                                                    } else {
                                                        phi_2029_ = _e1366.z;
                                                    }
                                                    let _e1387 = phi_2029_;
                                                    let _e1389 = triangles.member[(0u + _e1068)].v2_;
                                                    if (_e1373 < _e1389.x) {
                                                        phi_2038_ = _e1373;
                                                    } else {
                                                        phi_2038_ = _e1389.x;
                                                    }
                                                    let _e1394 = phi_2038_;
                                                    if (_e1380 < _e1389.y) {
                                                        phi_2045_ = _e1380;
                                                    } else {
                                                        phi_2045_ = _e1389.y;
                                                    }
                                                    let _e1399 = phi_2045_;
                                                    if (_e1387 < _e1389.z) {
                                                        phi_2052_ = _e1387;
                                                    } else {
                                                        phi_2052_ = _e1389.z;
                                                    }
                                                    let _e1404 = phi_2052_;
                                                    let _e1406 = triangles.member[(0u + _e1068)].v0_;
                                                    let _e1408 = triangles.member[(0u + _e1068)].v1_;
                                                    if (_e1406.x > _e1408.x) {
                                                        phi_2065_ = _e1406.x;
                                                    } else {
                                                        phi_2065_ = _e1408.x;
                                                    }
                                                    let _e1415 = phi_2065_;
                                                    if (_e1406.y > _e1408.y) {
                                                        phi_2074_ = _e1406.y;
                                                    } else {
                                                        phi_2074_ = _e1408.y;
                                                    }
                                                    let _e1422 = phi_2074_;
                                                    if (_e1406.z > _e1408.z) {
                                                        phi_2083_ = _e1406.z;
                                                    } else {
                                                        phi_2083_ = _e1408.z;
                                                    }
                                                    let _e1429 = phi_2083_;
                                                    let _e1431 = triangles.member[(0u + _e1068)].v2_;
                                                    if (_e1415 > _e1431.x) {
                                                        phi_2092_ = _e1415;
                                                    } else {
                                                        phi_2092_ = _e1431.x;
                                                    }
                                                    let _e1436 = phi_2092_;
                                                    if (_e1422 > _e1431.y) {
                                                        phi_2099_ = _e1422;
                                                    } else {
                                                        phi_2099_ = _e1431.y;
                                                    }
                                                    let _e1441 = phi_2099_;
                                                    if (_e1429 > _e1431.z) {
                                                        phi_2106_ = _e1429;
                                                    } else {
                                                        phi_2106_ = _e1431.z;
                                                    }
                                                    let _e1446 = phi_2106_;
                                                    let _e1453 = ((_e1394 - _e214.origin.x) * _e358);
                                                    let _e1454 = ((_e1399 - _e214.origin.y) * _e369);
                                                    let _e1455 = ((_e1404 - _e214.origin.z) * _e380);
                                                    let _e1462 = ((_e1436 - _e214.origin.x) * _e358);
                                                    let _e1463 = ((_e1441 - _e214.origin.y) * _e369);
                                                    let _e1464 = ((_e1446 - _e214.origin.z) * _e380);
                                                    if (_e1453 < _e1462) {
                                                        phi_2129_ = _e1453;
                                                    } else {
                                                        phi_2129_ = _e1462;
                                                    }
                                                    let _e1467 = phi_2129_;
                                                    if (_e1454 < _e1463) {
                                                        phi_2134_ = _e1454;
                                                    } else {
                                                        phi_2134_ = _e1463;
                                                    }
                                                    let _e1470 = phi_2134_;
                                                    if (_e1455 < _e1464) {
                                                        phi_2139_ = _e1455;
                                                    } else {
                                                        phi_2139_ = _e1464;
                                                    }
                                                    let _e1473 = phi_2139_;
                                                    if (_e1453 > _e1462) {
                                                        phi_2147_ = _e1453;
                                                    } else {
                                                        phi_2147_ = _e1462;
                                                    }
                                                    let _e1479 = phi_2147_;
                                                    if (_e1454 > _e1463) {
                                                        phi_2152_ = _e1454;
                                                    } else {
                                                        phi_2152_ = _e1463;
                                                    }
                                                    let _e1482 = phi_2152_;
                                                    if (_e1455 > _e1464) {
                                                        phi_2157_ = _e1455;
                                                    } else {
                                                        phi_2157_ = _e1464;
                                                    }
                                                    let _e1485 = phi_2157_;
                                                    let _e1489 = core_intrinsics_maximum_number_nsz_f32_((_e1467 - _e425), (_e1470 - _e426));
                                                    let _e1490 = core_intrinsics_maximum_number_nsz_f32_(_e1489, (_e1473 - _e427));
                                                    let _e1491 = core_intrinsics_minimum_number_nsz_f32_((_e1479 + _e425), (_e1482 + _e426));
                                                    let _e1492 = core_intrinsics_minimum_number_nsz_f32_(_e1491, (_e1485 + _e427));
                                                    if (_e1490 > -300000000000000000000000000000000000000f) {
                                                        phi_2169_ = _e1490;
                                                    } else {
                                                        phi_2169_ = -300000000000000000000000000000000000000f;
                                                    }
                                                    let _e1495 = phi_2169_;
                                                    if (_e1492 < 300000000000000000000000000000000000000f) {
                                                        phi_2174_ = _e1492;
                                                    } else {
                                                        phi_2174_ = 300000000000000000000000000000000000000f;
                                                    }
                                                    let _e1498 = phi_2174_;
                                                    if (_e1360 < _e1495) {
                                                        phi_2179_ = _e1495;
                                                    } else {
                                                        phi_2179_ = _e1360;
                                                    }
                                                    let _e1501 = phi_2179_;
                                                    if (_e1501 > _e1498) {
                                                        phi_2184_ = _e1498;
                                                    } else {
                                                        phi_2184_ = _e1501;
                                                    }
                                                    let _e1504 = phi_2184_;
                                                    phi_2189_ = lt_bvh_triangle_Intersection(_e1504, (_e1199 / _e1258), (_e1220 / _e1258), (_e1495 <= _e1498));
                                                    phi_2190_ = false;
                                                } else {
                                                    phi_2189_ = lt_bvh_triangle_Intersection();
                                                    phi_2190_ = true;
                                                }
                                                let _e1510 = phi_2189_;
                                                let _e1512 = phi_2190_;
                                                phi_2191_ = _e1510;
                                                phi_2192_ = _e1512;
                                            } else {
                                                phi_2191_ = lt_bvh_triangle_Intersection();
                                                phi_2192_ = true;
                                            }
                                            let _e1514 = phi_2191_;
                                            let _e1516 = phi_2192_;
                                            if _e1516 {
                                            }
                                            phi_2196_ = _e1514;
                                            phi_2197_ = _e1516;
                                        }
                                        let _e1518 = phi_2196_;
                                        let _e1520 = phi_2197_;
                                        phi_2198_ = _e1518;
                                        phi_2199_ = _e1261;
                                        phi_2200_ = _e1520;
                                    } else {
                                        phi_2198_ = lt_bvh_triangle_Intersection();
                                        phi_2199_ = true;
                                        phi_2200_ = false;
                                    }
                                    let _e1522 = phi_2198_;
                                    let _e1524 = phi_2199_;
                                    let _e1526 = phi_2200_;
                                    if _e1524 {
                                        phi_2204_ = true;
                                    } else {
                                        phi_2204_ = _e1526;
                                    }
                                    let _e1528 = phi_2204_;
                                    if _e1528 {
                                        phi_2208_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                    } else {
                                        phi_2208_ = _e1522;
                                    }
                                    let _e1530 = phi_2208_;
                                    if _e1530.is_hit {
                                        if (_e1530.t > _e128.t) {
                                            if (_e1530.t < _e1057.t) {
                                                phi_2256_ = true;
                                            } else {
                                                if (_e1530.t == _e1057.t) {
                                                    if (_e1057.triangle != 4294967295u) {
                                                        if (_e1068 < _e1057.triangle) {
                                                            phi_2247_ = true;
                                                        } else {
                                                            if (_e1068 == _e1057.triangle) {
                                                                phi_2246_ = (4294967295u < _e1057.instance);
                                                            } else {
                                                                phi_2246_ = false;
                                                            }
                                                            let _e1548 = phi_2246_;
                                                            phi_2247_ = _e1548;
                                                        }
                                                        let _e1550 = phi_2247_;
                                                        phi_2248_ = _e1550;
                                                        phi_2249_ = false;
                                                    } else {
                                                        phi_2248_ = bool();
                                                        phi_2249_ = true;
                                                    }
                                                    let _e1552 = phi_2248_;
                                                    let _e1554 = phi_2249_;
                                                    phi_2250_ = _e1552;
                                                    phi_2251_ = _e1554;
                                                } else {
                                                    phi_2250_ = bool();
                                                    phi_2251_ = true;
                                                }
                                                let _e1556 = phi_2250_;
                                                let _e1558 = phi_2251_;
                                                if _e1558 {
                                                    phi_2255_ = false;
                                                } else {
                                                    phi_2255_ = _e1556;
                                                }
                                                let _e1560 = phi_2255_;
                                                phi_2256_ = _e1560;
                                            }
                                            let _e1562 = phi_2256_;
                                            if _e1562 {
                                                let _e1564 = triangles.member[(0u + _e1068)].i0_;
                                                if ((_e1564 & 2147483648u) == 0u) {
                                                    phi_2467_ = true;
                                                } else {
                                                    if (_e1068 < _e90) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1573 = triangles.member[(0u + _e1068)].i0_;
                                                    let _e1574 = (_e1573 & 2147483647u);
                                                    let _e1576 = triangles.member[(0u + _e1068)].i1_;
                                                    let _e1578 = triangles.member[(0u + _e1068)].i2_;
                                                    if (_e1574 < _e93) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1582 = vertices.member[(0u + _e1574)];
                                                    if (_e1576 < _e93) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1586 = vertices.member[(0u + _e1576)];
                                                    if (_e1578 < _e93) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1590 = vertices.member[(0u + _e1578)];
                                                    let _e1591 = array<abi_Vertex, 3>(_e1582, _e1586, _e1590);
                                                    if (_e1591[0].material < _e96) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1597 = materials.member[(0u + _e1591[0].material)];
                                                    if ((_e1597.flags & 0u) == 0u) {
                                                        let _e1602 = ((1f - _e1530.u) - _e1530.v);
                                                        if (_e1597.cutoff <= 0f) {
                                                            phi_2462_ = true;
                                                        } else {
                                                            let _e1629 = (_e1597.base_color.w * ((((f32((_e1591[0].color >> bitcast<u32>(24i))) * _e1602) + (f32((_e1591[1].color >> bitcast<u32>(24i))) * _e1530.u)) + (f32((_e1591[2].color >> bitcast<u32>(24i))) * _e1530.v)) * (1f / 255f)));
                                                            if (_e1597.alpha_size == 0u) {
                                                                phi_2459_ = _e1629;
                                                            } else {
                                                                local_4.offset = _e1597.alpha_offset;
                                                                local_4.size = _e1597.alpha_size;
                                                                local_4.flags = _e1597.flags;
                                                                let _e1660 = _lt_shaders_texture_TextureView_quad((&local_4), (((_e1591[0].u * _e1602) + (_e1591[1].u * _e1530.u)) + (_e1591[2].u * _e1530.v)), (((_e1591[0].v * _e1602) + (_e1591[1].v * _e1530.u)) + (_e1591[2].v * _e1530.v)));
                                                                let _e1664 = (_e1660.indices[0] >> bitcast<u32>(2i));
                                                                if (_e1664 < _e102) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1668 = alpha_texels.member[(0u + _e1664)];
                                                                let _e1684 = (_e1660.indices[1] >> bitcast<u32>(2i));
                                                                if (_e1684 < _e102) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1688 = alpha_texels.member[(0u + _e1684)];
                                                                let _e1705 = (_e1660.indices[2] >> bitcast<u32>(2i));
                                                                if (_e1705 < _e102) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1709 = alpha_texels.member[(0u + _e1705)];
                                                                let _e1726 = (_e1660.indices[3] >> bitcast<u32>(2i));
                                                                if (_e1726 < _e102) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1730 = alpha_texels.member[(0u + _e1726)];
                                                                phi_2459_ = (_e1629 * (((((f32(((_e1668 >> bitcast<u32>((((_e1660.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1660.weights.x) + ((f32(((_e1688 >> bitcast<u32>((((_e1660.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1660.weights.y)) + ((f32(((_e1709 >> bitcast<u32>((((_e1660.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1660.weights.z)) + ((f32(((_e1730 >> bitcast<u32>((((_e1660.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1660.weights.w)));
                                                            }
                                                            let _e1746 = phi_2459_;
                                                            phi_2462_ = (_e1746 >= _e1597.cutoff);
                                                        }
                                                        let _e1750 = phi_2462_;
                                                        phi_2463_ = _e1750;
                                                    } else {
                                                        phi_2463_ = false;
                                                    }
                                                    let _e1752 = phi_2463_;
                                                    if _e1752 {
                                                    }
                                                    phi_2467_ = _e1752;
                                                }
                                                let _e1754 = phi_2467_;
                                                if _e1754 {
                                                    phi_2475_ = lt_bvh_Hit(_e1530.t, _e1530.u, _e1530.v, _e1068, 4294967295u);
                                                } else {
                                                    phi_2475_ = _e1057;
                                                }
                                                let _e1760 = phi_2475_;
                                                phi_2476_ = _e1760;
                                            } else {
                                                phi_2476_ = _e1057;
                                            }
                                            let _e1762 = phi_2476_;
                                            phi_2477_ = _e1762;
                                        } else {
                                            phi_2477_ = _e1057;
                                        }
                                        let _e1764 = phi_2477_;
                                        phi_2478_ = _e1764;
                                    } else {
                                        phi_2478_ = _e1057;
                                    }
                                    let _e1766 = phi_2478_;
                                    phi_1624_ = _e1766;
                                    phi_1627_ = (_e1059 & (_e1059 - 1u));
                                    phi_2479_ = true;
                                }
                                let _e1768 = phi_1624_;
                                let _e1770 = phi_1627_;
                                let _e1772 = phi_2479_;
                                continue;
                                continuing {
                                    phi_1623_ = _e1768;
                                    phi_1626_ = _e1770;
                                    break if !(_e1772);
                                }
                            }
                            let _e1775 = local_5.group_mask;
                            if ((_e1775 & 4278190080u) == 0u) {
                                let _e1779 = local_5.len;
                                if (_e1779 == 0u) {
                                    phi_2518_ = false;
                                } else {
                                    let _e1783 = local_5.len;
                                    local_5.len = (_e1783 - 1u);
                                    let _e1786 = local_5.len;
                                    if (_e1786 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1791 = local_5.first[(0u + _e1786)];
                                    local_5.group = _e1791;
                                    let _e1794 = local_5.len;
                                    if (_e1794 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1799 = local_5.mask[(0u + _e1794)];
                                    local_5.group_mask = _e1799;
                                    phi_2518_ = true;
                                }
                                let _e1802 = phi_2518_;
                                phi_2519_ = _e1802;
                            } else {
                                phi_2519_ = true;
                            }
                            let _e1804 = phi_2519_;
                            if _e1804 {
                                let _e1806 = local_5.group_mask;
                                let _e1812 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1806)), 32u, (_e1806 == 0u)));
                                let _e1816 = local_5.group_mask;
                                let _e1830 = local_5.group_mask;
                                local_5.group_mask = (_e1830 & ~((1u << bitcast<u32>((_e1812 & 31u)))));
                                let _e1833 = local_5.group;
                                phi_2550_ = (_e1833 + countOneBits(((_e1816 & ~((4294967295u << bitcast<u32>((((_e1812 - 24u) ^ _e477) & 31u))))) & 255u)));
                            } else {
                                phi_2550_ = 4294967295u;
                            }
                            let _e1836 = phi_2550_;
                            let _e3461 = local_9;
                            phi_1288_ = _e3461;
                            phi_1291_ = _e1836;
                        } else {
                            phi_1288_ = lt_bvh_Hit();
                            phi_1291_ = u32();
                        }
                        let _e1838 = phi_1288_;
                        let _e1840 = phi_1291_;
                        continue;
                        continuing {
                            phi_1287_ = _e1838;
                            phi_1290_ = _e1840;
                            break if !(_e618);
                        }
                    }
                    let _e3465 = local_10;
                    phi_2551_ = _e3465;
                }
                let _e1843 = phi_2551_;
                phi_2552_ = _e1843;
                phi_2553_ = _e278;
            } else {
                phi_2552_ = lt_bvh_Hit();
                phi_2553_ = true;
            }
            let _e1845 = phi_2552_;
            let _e1847 = phi_2553_;
            if _e1847 {
                phi_2557_ = _e218;
            } else {
                phi_2557_ = _e1845;
            }
            let _e1849 = phi_2557_;
            phi_2559_ = _e1849;
        } else {
            phi_2559_ = lt_bvh_Hit(300000000000000000000000000000000000000f, 0f, 0f, 4294967295u, 4294967295u);
        }
        let _e1852 = phi_2559_;
        let _e1854 = abi_Sight(vec3<f32>(1f, 1f, 1f), _e128.t);
        if (_e1852.triangle != 4294967295u) {
            if (_e1852.triangle != 4294967295u) {
                let _e1862 = ((1f - _e1852.u) - _e1852.v);
                if (_e1852.triangle < _e90) {
                } else {
                    return;
                }
                let _e1867 = triangles.member[(0u + _e1852.triangle)];
                let _e1892 = (((_e1867.v0_.x * _e1862) + (_e1867.v1_.x * _e1852.u)) + (_e1867.v2_.x * _e1852.v));
                let _e1893 = (((_e1867.v0_.y * _e1862) + (_e1867.v1_.y * _e1852.u)) + (_e1867.v2_.y * _e1852.v));
                let _e1894 = (((_e1867.v0_.z * _e1862) + (_e1867.v1_.z * _e1852.u)) + (_e1867.v2_.z * _e1852.v));
                let _e1897 = abs(_e1867.v0_.x);
                let _e1899 = abs(_e1867.v0_.y);
                let _e1901 = abs(_e1867.v0_.z);
                let _e1903 = abs(_e1867.v1_.x);
                let _e1905 = abs(_e1867.v1_.y);
                let _e1907 = abs(_e1867.v1_.z);
                if (_e1897 > _e1903) {
                    phi_2646_ = _e1897;
                } else {
                    phi_2646_ = _e1903;
                }
                let _e1910 = phi_2646_;
                if (_e1899 > _e1905) {
                    phi_2651_ = _e1899;
                } else {
                    phi_2651_ = _e1905;
                }
                let _e1913 = phi_2651_;
                if (_e1901 > _e1907) {
                    phi_2656_ = _e1901;
                } else {
                    phi_2656_ = _e1907;
                }
                let _e1916 = phi_2656_;
                let _e1918 = abs(_e1867.v2_.x);
                let _e1920 = abs(_e1867.v2_.y);
                let _e1922 = abs(_e1867.v2_.z);
                if (_e1910 > _e1918) {
                    phi_2667_ = _e1910;
                } else {
                    phi_2667_ = _e1918;
                }
                let _e1925 = phi_2667_;
                if (_e1913 > _e1920) {
                    phi_2672_ = _e1913;
                } else {
                    phi_2672_ = _e1920;
                }
                let _e1928 = phi_2672_;
                if (_e1916 > _e1922) {
                    phi_2677_ = _e1916;
                } else {
                    phi_2677_ = _e1922;
                }
                let _e1931 = phi_2677_;
                let _e1934 = (_e1867.v1_.x - _e1867.v0_.x);
                let _e1937 = (_e1867.v1_.y - _e1867.v0_.y);
                let _e1940 = (_e1867.v1_.z - _e1867.v0_.z);
                let _e1943 = (_e1867.v2_.x - _e1867.v0_.x);
                let _e1946 = (_e1867.v2_.y - _e1867.v0_.y);
                let _e1949 = (_e1867.v2_.z - _e1867.v0_.z);
                let _e1953 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1937), abs(_e1940));
                let _e1954 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1934), _e1953);
                let _e1955 = (_e1934 / _e1954);
                let _e1956 = (_e1937 / _e1954);
                let _e1957 = (_e1940 / _e1954);
                let _e1961 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1946), abs(_e1949));
                let _e1962 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1943), _e1961);
                let _e1963 = (_e1943 / _e1962);
                let _e1964 = (_e1946 / _e1962);
                let _e1965 = (_e1949 / _e1962);
                let _e1968 = ((_e1956 * _e1965) - (_e1964 * _e1957));
                let _e1971 = ((_e1957 * _e1963) - (_e1965 * _e1955));
                let _e1974 = ((_e1955 * _e1964) - (_e1963 * _e1956));
                let _e1976 = p.member.eye;
                let _e1989 = (1f / sqrt((((_e1968 * _e1968) + (_e1971 * _e1971)) + (_e1974 * _e1974))));
                let _e1990 = (_e1968 * _e1989);
                let _e1991 = (_e1971 * _e1989);
                let _e1992 = (_e1974 * _e1989);
                if ((((_e1990 * (_e1976.x - _e1892)) + (_e1991 * (_e1976.y - _e1893))) + (_e1992 * (_e1976.z - _e1894))) < 0f) {
                    phi_2753_ = vec3<f32>(-(_e1990), -(_e1991), -(_e1992));
                } else {
                    phi_2753_ = vec3<f32>(_e1990, _e1991, _e1992);
                }
                let _e2005 = phi_2753_;
                if (_e1852.triangle < _e90) {
                } else {
                    return;
                }
                let _e2010 = triangles.member[(0u + _e1852.triangle)];
                let _e2012 = (_e2010.i0_ & 2147483647u);
                if (_e2012 < _e93) {
                } else {
                    return;
                }
                let _e2018 = vertices.member[(0u + _e2012)];
                if (_e2010.i1_ < _e93) {
                } else {
                    return;
                }
                let _e2022 = vertices.member[(0u + _e2010.i1_)];
                if (_e2010.i2_ < _e93) {
                } else {
                    return;
                }
                let _e2026 = vertices.member[(0u + _e2010.i2_)];
                let _e2027 = array<abi_Vertex, 3>(_e2018, _e2022, _e2026);
                if (_e2027[0].material < _e96) {
                } else {
                    return;
                }
                let _e2033 = materials.member[(0u + _e2027[0].material)];
                let _e2050 = (1f / 255f);
                let _e2069 = (1f / 255f);
                let _e2091 = (1f / 255f);
                if (_e2033.color_size == 0u) {
                    phi_2996_ = vec3<f32>(1f, 1f, 1f);
                } else {
                    local_3.offset = _e2033.color_offset;
                    local_3.size = _e2033.color_size;
                    local_3.flags = _e2033.flags;
                    let _e2134 = _lt_shaders_texture_TextureView_quad((&local_3), (((_e2027[0].u * _e1862) + (_e2027[1].u * _e1852.u)) + (_e2027[2].u * _e1852.v)), (((_e2027[0].v * _e1862) + (_e2027[1].v * _e1852.u)) + (_e2027[2].v * _e1852.v)));
                    if (_e2134.indices[0] < _e105) {
                    } else {
                        return;
                    }
                    let _e2140 = color_texels.member[(0u + _e2134.indices[0])];
                    let _e2151 = (1f / 255f);
                    if (_e2134.indices[1] < _e105) {
                    } else {
                        return;
                    }
                    let _e2165 = color_texels.member[(0u + _e2134.indices[1])];
                    let _e2176 = (1f / 255f);
                    if (_e2134.indices[2] < _e105) {
                    } else {
                        return;
                    }
                    let _e2193 = color_texels.member[(0u + _e2134.indices[2])];
                    let _e2204 = (1f / 255f);
                    if (_e2134.indices[3] < _e105) {
                    } else {
                        return;
                    }
                    let _e2221 = color_texels.member[(0u + _e2134.indices[3])];
                    let _e2232 = (1f / 255f);
                    let _e2241 = (((((f32((_e2140 & 255u)) * _e2151) * _e2134.weights.x) + ((f32((_e2165 & 255u)) * _e2176) * _e2134.weights.y)) + ((f32((_e2193 & 255u)) * _e2204) * _e2134.weights.z)) + ((f32((_e2221 & 255u)) * _e2232) * _e2134.weights.w));
                    let _e2242 = (((((f32(((_e2140 >> bitcast<u32>(8i)) & 255u)) * _e2151) * _e2134.weights.x) + ((f32(((_e2165 >> bitcast<u32>(8i)) & 255u)) * _e2176) * _e2134.weights.y)) + ((f32(((_e2193 >> bitcast<u32>(8i)) & 255u)) * _e2204) * _e2134.weights.z)) + ((f32(((_e2221 >> bitcast<u32>(8i)) & 255u)) * _e2232) * _e2134.weights.w));
                    let _e2243 = (((((f32(((_e2140 >> bitcast<u32>(16i)) & 255u)) * _e2151) * _e2134.weights.x) + ((f32(((_e2165 >> bitcast<u32>(16i)) & 255u)) * _e2176) * _e2134.weights.y)) + ((f32(((_e2193 >> bitcast<u32>(16i)) & 255u)) * _e2204) * _e2134.weights.z)) + ((f32(((_e2221 >> bitcast<u32>(16i)) & 255u)) * _e2232) * _e2134.weights.w));
                    phi_2996_ = vec3<f32>((_e2241 * _e2241), (_e2242 * _e2242), (_e2243 * _e2243));
                }
                let _e2249 = phi_2996_;
                let _e2251 = ((_e2033.base_color.x * ((((f32((_e2027[0].color & 255u)) * _e2050) * _e1862) + ((f32((_e2027[1].color & 255u)) * _e2069) * _e1852.u)) + ((f32((_e2027[2].color & 255u)) * _e2091) * _e1852.v))) * _e2249.x);
                let _e2253 = ((_e2033.base_color.y * ((((f32(((_e2027[0].color >> bitcast<u32>(8i)) & 255u)) * _e2050) * _e1862) + ((f32(((_e2027[1].color >> bitcast<u32>(8i)) & 255u)) * _e2069) * _e1852.u)) + ((f32(((_e2027[2].color >> bitcast<u32>(8i)) & 255u)) * _e2091) * _e1852.v))) * _e2249.y);
                let _e2255 = ((_e2033.base_color.z * ((((f32(((_e2027[0].color >> bitcast<u32>(16i)) & 255u)) * _e2050) * _e1862) + ((f32(((_e2027[1].color >> bitcast<u32>(16i)) & 255u)) * _e2069) * _e1852.u)) + ((f32(((_e2027[2].color >> bitcast<u32>(16i)) & 255u)) * _e2091) * _e1852.v))) * _e2249.z);
                let _e2256 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1928, _e1931);
                let _e2257 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1925, _e2256);
                if ((_e2033.flags & 2u) == 0u) {
                    phi_3011_ = 0u;
                } else {
                    phi_3011_ = 1u;
                }
                let _e2262 = phi_3011_;
                if (_e2027[0].normal == 2147516416u) {
                    phi_3214_ = _e2005;
                } else {
                    let _e2275 = (f32((bitcast<i32>((_e2027[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                    let _e2281 = (f32((bitcast<i32>(_e2027[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                    let _e2285 = ((1f - abs(_e2275)) - abs(_e2281));
                    if (_e2285 < 0f) {
                        phi_3038_ = -(_e2285);
                    } else {
                        phi_3038_ = 0f;
                    }
                    let _e2289 = phi_3038_;
                    if (_e2275 < 0f) {
                        phi_3045_ = (_e2275 + _e2289);
                    } else {
                        phi_3045_ = (_e2275 - _e2289);
                    }
                    let _e2294 = phi_3045_;
                    if (_e2281 < 0f) {
                        phi_3052_ = (_e2281 + _e2289);
                    } else {
                        phi_3052_ = (_e2281 - _e2289);
                    }
                    let _e2299 = phi_3052_;
                    let _e2306 = (1f / sqrt((((_e2294 * _e2294) + (_e2299 * _e2299)) + (_e2285 * _e2285))));
                    let _e2322 = (f32((bitcast<i32>((_e2027[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                    let _e2328 = (f32((bitcast<i32>(_e2027[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                    let _e2332 = ((1f - abs(_e2322)) - abs(_e2328));
                    if (_e2332 < 0f) {
                        phi_3087_ = -(_e2332);
                    } else {
                        phi_3087_ = 0f;
                    }
                    let _e2336 = phi_3087_;
                    if (_e2322 < 0f) {
                        phi_3094_ = (_e2322 + _e2336);
                    } else {
                        phi_3094_ = (_e2322 - _e2336);
                    }
                    let _e2341 = phi_3094_;
                    if (_e2328 < 0f) {
                        phi_3101_ = (_e2328 + _e2336);
                    } else {
                        phi_3101_ = (_e2328 - _e2336);
                    }
                    let _e2346 = phi_3101_;
                    let _e2353 = (1f / sqrt((((_e2341 * _e2341) + (_e2346 * _e2346)) + (_e2332 * _e2332))));
                    let _e2372 = (f32((bitcast<i32>((_e2027[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                    let _e2378 = (f32((bitcast<i32>(_e2027[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                    let _e2382 = ((1f - abs(_e2372)) - abs(_e2378));
                    if (_e2382 < 0f) {
                        phi_3139_ = -(_e2382);
                    } else {
                        phi_3139_ = 0f;
                    }
                    let _e2386 = phi_3139_;
                    if (_e2372 < 0f) {
                        phi_3146_ = (_e2372 + _e2386);
                    } else {
                        phi_3146_ = (_e2372 - _e2386);
                    }
                    let _e2391 = phi_3146_;
                    if (_e2378 < 0f) {
                        phi_3153_ = (_e2378 + _e2386);
                    } else {
                        phi_3153_ = (_e2378 - _e2386);
                    }
                    let _e2396 = phi_3153_;
                    let _e2403 = (1f / sqrt((((_e2391 * _e2391) + (_e2396 * _e2396)) + (_e2382 * _e2382))));
                    let _e2414 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(vec3<f32>(((((_e2294 * _e2306) * _e1862) + ((_e2341 * _e2353) * _e1852.u)) + ((_e2391 * _e2403) * _e1852.v)), ((((_e2299 * _e2306) * _e1862) + ((_e2346 * _e2353) * _e1852.u)) + ((_e2396 * _e2403) * _e1852.v)), ((((_e2285 * _e2306) * _e1862) + ((_e2332 * _e2353) * _e1852.u)) + ((_e2382 * _e2403) * _e1852.v))));
                    let _e2426 = sqrt((((_e2414.x * _e2414.x) + (_e2414.y * _e2414.y)) + (_e2414.z * _e2414.z)));
                    if (_e2426 > 0f) {
                        let _e2429 = (_e2414.x / _e2426);
                        let _e2431 = (_e2414.y / _e2426);
                        let _e2433 = (_e2414.z / _e2426);
                        if ((((_e2429 * _e2005.x) + (_e2431 * _e2005.y)) + (_e2433 * _e2005.z)) < 0f) {
                            phi_3212_ = vec3<f32>(-(_e2429), -(_e2431), -(_e2433));
                        } else {
                            phi_3212_ = (_e2414 / vec3(_e2426));
                        }
                        let _e2450 = phi_3212_;
                        phi_3213_ = _e2450;
                    } else {
                        phi_3213_ = _e2005;
                    }
                    let _e2452 = phi_3213_;
                    phi_3214_ = _e2452;
                }
                let _e2454 = phi_3214_;
                if (_e2251 > 0f) {
                    if (_e2251 < 1f) {
                        phi_3223_ = _e2251;
                    } else {
                        phi_3223_ = 1f;
                    }
                    let _e2458 = phi_3223_;
                    phi_3224_ = _e2458;
                } else {
                    phi_3224_ = 0f;
                }
                let _e2460 = phi_3224_;
                if (_e2253 > 0f) {
                    if (_e2253 < 1f) {
                        phi_3234_ = _e2253;
                    } else {
                        phi_3234_ = 1f;
                    }
                    let _e2465 = phi_3234_;
                    phi_3235_ = _e2465;
                } else {
                    phi_3235_ = 0f;
                }
                let _e2467 = phi_3235_;
                if (_e2255 > 0f) {
                    if (_e2255 < 1f) {
                        phi_3245_ = _e2255;
                    } else {
                        phi_3245_ = 1f;
                    }
                    let _e2472 = phi_3245_;
                    phi_3246_ = _e2472;
                } else {
                    phi_3246_ = 0f;
                }
                let _e2474 = phi_3246_;
                let _e2477 = ((sqrt(_e2460) * 255f) + 0.5f);
                let _e2486 = ((sqrt(_e2467) * 255f) + 0.5f);
                let _e2498 = ((sqrt(_e2474) * 255f) + 0.5f);
                phi_3281_ = abi_Sample(vec3<f32>(_e1892, _e1893, _e1894), _e2257, _e2005, _e2262, _e2454, ((select(select(u32(_e2477), 0u, (_e2477 < bitcast<f32>(0u))), 4294967295u, (_e2477 > bitcast<f32>(1333788671u))) | (select(select(u32(_e2486), 0u, (_e2486 < bitcast<f32>(0u))), 4294967295u, (_e2486 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e2498), 0u, (_e2498 < bitcast<f32>(0u))), 4294967295u, (_e2498 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
            } else {
                phi_3281_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
            }
            let _e2512 = phi_3281_;
            let _e2514 = p.member.layers_behind;
            let _e2515 = (_e2514 == 0u);
            if _e2515 {
                let _e2517 = ((1f * 65535f) + 0.5f);
                phi_3962_ = u0028_abi_Sample_u0020_abi_Sight_u0029_(abi_Sample(_e2512.position, _e2512.magnitude, _e2512.normal, ((_e2512.flags & 65535u) | (select(select(u32(_e2517), 0u, (_e2517 < bitcast<f32>(0u))), 4294967295u, (_e2517 > bitcast<f32>(1333788671u))) << bitcast<u32>(16u))), _e2512.shading_normal, _e2512.albedo), _e1854);
                phi_3963_ = u0028_abi_Sample_u0020_abi_Sight_u0029_();
            } else {
                let _e2540 = ((1f - _e1852.u) - _e1852.v);
                if (_e1852.triangle < _e90) {
                } else {
                    return;
                }
                let _e2545 = triangles.member[(0u + _e1852.triangle)];
                let _e2547 = (_e2545.i0_ & 2147483647u);
                if (_e2547 < _e93) {
                } else {
                    return;
                }
                let _e2553 = vertices.member[(0u + _e2547)];
                if (_e2545.i1_ < _e93) {
                } else {
                    return;
                }
                let _e2557 = vertices.member[(0u + _e2545.i1_)];
                if (_e2545.i2_ < _e93) {
                } else {
                    return;
                }
                let _e2561 = vertices.member[(0u + _e2545.i2_)];
                let _e2562 = array<abi_Vertex, 3>(_e2553, _e2557, _e2561);
                if (_e2562[0].material < _e96) {
                } else {
                    return;
                }
                let _e2568 = materials.member[(0u + _e2562[0].material)];
                if (_e2568.cutoff <= 0f) {
                    phi_3511_ = 1f;
                } else {
                    let _e2595 = (_e2568.base_color.w * ((((f32((_e2562[0].color >> bitcast<u32>(24i))) * _e2540) + (f32((_e2562[1].color >> bitcast<u32>(24i))) * _e1852.u)) + (f32((_e2562[2].color >> bitcast<u32>(24i))) * _e1852.v)) * (1f / 255f)));
                    if (_e2568.alpha_size == 0u) {
                        phi_3487_ = _e2595;
                    } else {
                        local_2.offset = _e2568.alpha_offset;
                        local_2.size = _e2568.alpha_size;
                        local_2.flags = _e2568.flags;
                        let _e2626 = _lt_shaders_texture_TextureView_quad((&local_2), (((_e2562[0].u * _e2540) + (_e2562[1].u * _e1852.u)) + (_e2562[2].u * _e1852.v)), (((_e2562[0].v * _e2540) + (_e2562[1].v * _e1852.u)) + (_e2562[2].v * _e1852.v)));
                        let _e2630 = (_e2626.indices[0] >> bitcast<u32>(2i));
                        if (_e2630 < _e102) {
                        } else {
                            return;
                        }
                        let _e2634 = alpha_texels.member[(0u + _e2630)];
                        let _e2650 = (_e2626.indices[1] >> bitcast<u32>(2i));
                        if (_e2650 < _e102) {
                        } else {
                            return;
                        }
                        let _e2654 = alpha_texels.member[(0u + _e2650)];
                        let _e2671 = (_e2626.indices[2] >> bitcast<u32>(2i));
                        if (_e2671 < _e102) {
                        } else {
                            return;
                        }
                        let _e2675 = alpha_texels.member[(0u + _e2671)];
                        let _e2692 = (_e2626.indices[3] >> bitcast<u32>(2i));
                        if (_e2692 < _e102) {
                        } else {
                            return;
                        }
                        let _e2696 = alpha_texels.member[(0u + _e2692)];
                        phi_3487_ = (_e2595 * (((((f32(((_e2634 >> bitcast<u32>((((_e2626.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2626.weights.x) + ((f32(((_e2654 >> bitcast<u32>((((_e2626.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2626.weights.y)) + ((f32(((_e2675 >> bitcast<u32>((((_e2626.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2626.weights.z)) + ((f32(((_e2696 >> bitcast<u32>((((_e2626.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2626.weights.w)));
                    }
                    let _e2712 = phi_3487_;
                    if ((_e2568.flags & 8u) == 0u) {
                        if (_e2712 >= _e2568.cutoff) {
                            phi_3499_ = 1f;
                        } else {
                            phi_3499_ = 0f;
                        }
                        let _e2719 = phi_3499_;
                        phi_3510_ = _e2719;
                    } else {
                        if (_e2712 > 0f) {
                            if (_e2712 < 1f) {
                                phi_3508_ = _e2712;
                            } else {
                                phi_3508_ = 1f;
                            }
                            let _e2723 = phi_3508_;
                            phi_3509_ = _e2723;
                        } else {
                            phi_3509_ = 0f;
                        }
                        let _e2725 = phi_3509_;
                        phi_3510_ = _e2725;
                    }
                    let _e2727 = phi_3510_;
                    phi_3511_ = _e2727;
                }
                let _e2729 = phi_3511_;
                let _e2732 = (_e2729 * (1f - _e2568.transmission));
                if (_e2732 > 0f) {
                    if (_e2732 < 1f) {
                        phi_3523_ = _e2732;
                    } else {
                        phi_3523_ = 1f;
                    }
                    let _e2736 = phi_3523_;
                    phi_3524_ = _e2736;
                } else {
                    phi_3524_ = 0f;
                }
                let _e2738 = phi_3524_;
                if (_e2568.cutoff <= 0f) {
                    phi_3680_ = 1f;
                } else {
                    let _e2765 = (_e2568.base_color.w * ((((f32((_e2562[0].color >> bitcast<u32>(24i))) * _e2540) + (f32((_e2562[1].color >> bitcast<u32>(24i))) * _e1852.u)) + (f32((_e2562[2].color >> bitcast<u32>(24i))) * _e1852.v)) * (1f / 255f)));
                    if (_e2568.alpha_size == 0u) {
                        phi_3656_ = _e2765;
                    } else {
                        local_1.offset = _e2568.alpha_offset;
                        local_1.size = _e2568.alpha_size;
                        local_1.flags = _e2568.flags;
                        let _e2796 = _lt_shaders_texture_TextureView_quad((&local_1), (((_e2562[0].u * _e2540) + (_e2562[1].u * _e1852.u)) + (_e2562[2].u * _e1852.v)), (((_e2562[0].v * _e2540) + (_e2562[1].v * _e1852.u)) + (_e2562[2].v * _e1852.v)));
                        let _e2800 = (_e2796.indices[0] >> bitcast<u32>(2i));
                        if (_e2800 < _e102) {
                        } else {
                            return;
                        }
                        let _e2804 = alpha_texels.member[(0u + _e2800)];
                        let _e2820 = (_e2796.indices[1] >> bitcast<u32>(2i));
                        if (_e2820 < _e102) {
                        } else {
                            return;
                        }
                        let _e2824 = alpha_texels.member[(0u + _e2820)];
                        let _e2841 = (_e2796.indices[2] >> bitcast<u32>(2i));
                        if (_e2841 < _e102) {
                        } else {
                            return;
                        }
                        let _e2845 = alpha_texels.member[(0u + _e2841)];
                        let _e2862 = (_e2796.indices[3] >> bitcast<u32>(2i));
                        if (_e2862 < _e102) {
                        } else {
                            return;
                        }
                        let _e2866 = alpha_texels.member[(0u + _e2862)];
                        phi_3656_ = (_e2765 * (((((f32(((_e2804 >> bitcast<u32>((((_e2796.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2796.weights.x) + ((f32(((_e2824 >> bitcast<u32>((((_e2796.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2796.weights.y)) + ((f32(((_e2845 >> bitcast<u32>((((_e2796.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2796.weights.z)) + ((f32(((_e2866 >> bitcast<u32>((((_e2796.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2796.weights.w)));
                    }
                    let _e2882 = phi_3656_;
                    if ((_e2568.flags & 8u) == 0u) {
                        if (_e2882 >= _e2568.cutoff) {
                            phi_3668_ = 1f;
                        } else {
                            phi_3668_ = 0f;
                        }
                        let _e2889 = phi_3668_;
                        phi_3679_ = _e2889;
                    } else {
                        if (_e2882 > 0f) {
                            if (_e2882 < 1f) {
                                phi_3677_ = _e2882;
                            } else {
                                phi_3677_ = 1f;
                            }
                            let _e2893 = phi_3677_;
                            phi_3678_ = _e2893;
                        } else {
                            phi_3678_ = 0f;
                        }
                        let _e2895 = phi_3678_;
                        phi_3679_ = _e2895;
                    }
                    let _e2897 = phi_3679_;
                    phi_3680_ = _e2897;
                }
                let _e2899 = phi_3680_;
                let _e2916 = (1f / 255f);
                let _e2935 = (1f / 255f);
                let _e2957 = (1f / 255f);
                if (_e2568.color_size == 0u) {
                    phi_3879_ = vec3<f32>(1f, 1f, 1f);
                } else {
                    local.offset = _e2568.color_offset;
                    local.size = _e2568.color_size;
                    local.flags = _e2568.flags;
                    let _e3000 = _lt_shaders_texture_TextureView_quad((&local), (((_e2562[0].u * _e2540) + (_e2562[1].u * _e1852.u)) + (_e2562[2].u * _e1852.v)), (((_e2562[0].v * _e2540) + (_e2562[1].v * _e1852.u)) + (_e2562[2].v * _e1852.v)));
                    if (_e3000.indices[0] < _e105) {
                    } else {
                        return;
                    }
                    let _e3006 = color_texels.member[(0u + _e3000.indices[0])];
                    let _e3017 = (1f / 255f);
                    if (_e3000.indices[1] < _e105) {
                    } else {
                        return;
                    }
                    let _e3031 = color_texels.member[(0u + _e3000.indices[1])];
                    let _e3042 = (1f / 255f);
                    if (_e3000.indices[2] < _e105) {
                    } else {
                        return;
                    }
                    let _e3059 = color_texels.member[(0u + _e3000.indices[2])];
                    let _e3070 = (1f / 255f);
                    if (_e3000.indices[3] < _e105) {
                    } else {
                        return;
                    }
                    let _e3087 = color_texels.member[(0u + _e3000.indices[3])];
                    let _e3098 = (1f / 255f);
                    let _e3107 = (((((f32((_e3006 & 255u)) * _e3017) * _e3000.weights.x) + ((f32((_e3031 & 255u)) * _e3042) * _e3000.weights.y)) + ((f32((_e3059 & 255u)) * _e3070) * _e3000.weights.z)) + ((f32((_e3087 & 255u)) * _e3098) * _e3000.weights.w));
                    let _e3108 = (((((f32(((_e3006 >> bitcast<u32>(8i)) & 255u)) * _e3017) * _e3000.weights.x) + ((f32(((_e3031 >> bitcast<u32>(8i)) & 255u)) * _e3042) * _e3000.weights.y)) + ((f32(((_e3059 >> bitcast<u32>(8i)) & 255u)) * _e3070) * _e3000.weights.z)) + ((f32(((_e3087 >> bitcast<u32>(8i)) & 255u)) * _e3098) * _e3000.weights.w));
                    let _e3109 = (((((f32(((_e3006 >> bitcast<u32>(16i)) & 255u)) * _e3017) * _e3000.weights.x) + ((f32(((_e3031 >> bitcast<u32>(16i)) & 255u)) * _e3042) * _e3000.weights.y)) + ((f32(((_e3059 >> bitcast<u32>(16i)) & 255u)) * _e3070) * _e3000.weights.z)) + ((f32(((_e3087 >> bitcast<u32>(16i)) & 255u)) * _e3098) * _e3000.weights.w));
                    phi_3879_ = vec3<f32>((_e3107 * _e3107), (_e3108 * _e3108), (_e3109 * _e3109));
                }
                let _e3115 = phi_3879_;
                let _e3123 = (_e2899 * _e2568.transmission);
                let _e3127 = (1f - _e2899);
                let _e3128 = ((((_e2568.base_color.x * ((((f32((_e2562[0].color & 255u)) * _e2916) * _e2540) + ((f32((_e2562[1].color & 255u)) * _e2935) * _e1852.u)) + ((f32((_e2562[2].color & 255u)) * _e2957) * _e1852.v))) * _e3115.x) * _e3123) + _e3127);
                let _e3129 = ((((_e2568.base_color.y * ((((f32(((_e2562[0].color >> bitcast<u32>(8i)) & 255u)) * _e2916) * _e2540) + ((f32(((_e2562[1].color >> bitcast<u32>(8i)) & 255u)) * _e2935) * _e1852.u)) + ((f32(((_e2562[2].color >> bitcast<u32>(8i)) & 255u)) * _e2957) * _e1852.v))) * _e3115.y) * _e3123) + _e3127);
                let _e3130 = ((((_e2568.base_color.z * ((((f32(((_e2562[0].color >> bitcast<u32>(16i)) & 255u)) * _e2916) * _e2540) + ((f32(((_e2562[1].color >> bitcast<u32>(16i)) & 255u)) * _e2935) * _e1852.u)) + ((f32(((_e2562[2].color >> bitcast<u32>(16i)) & 255u)) * _e2957) * _e1852.v))) * _e3115.z) * _e3123) + _e3127);
                if (_e3128 > 0f) {
                    if (_e3128 < 1f) {
                        phi_3903_ = _e3128;
                    } else {
                        phi_3903_ = 1f;
                    }
                    let _e3134 = phi_3903_;
                    phi_3904_ = _e3134;
                } else {
                    phi_3904_ = 0f;
                }
                let _e3136 = phi_3904_;
                if (_e3129 > 0f) {
                    if (_e3129 < 1f) {
                        phi_3913_ = _e3129;
                    } else {
                        phi_3913_ = 1f;
                    }
                    let _e3140 = phi_3913_;
                    phi_3914_ = _e3140;
                } else {
                    phi_3914_ = 0f;
                }
                let _e3142 = phi_3914_;
                if (_e3130 > 0f) {
                    if (_e3130 < 1f) {
                        phi_3923_ = _e3130;
                    } else {
                        phi_3923_ = 1f;
                    }
                    let _e3146 = phi_3923_;
                    phi_3924_ = _e3146;
                } else {
                    phi_3924_ = 0f;
                }
                let _e3148 = phi_3924_;
                let _e3150 = ((_e2738 * 65535f) + 0.5f);
                phi_3962_ = u0028_abi_Sample_u0020_abi_Sight_u0029_();
                phi_3963_ = u0028_abi_Sample_u0020_abi_Sight_u0029_(abi_Sample(_e2512.position, _e2512.magnitude, _e2512.normal, ((_e2512.flags & 65535u) | (select(select(u32(_e3150), 0u, (_e3150 < bitcast<f32>(0u))), 4294967295u, (_e3150 > bitcast<f32>(1333788671u))) << bitcast<u32>(16u))), _e2512.shading_normal, _e2512.albedo), abi_Sight((vec3<f32>(1f, 1f, 1f) - vec3<f32>(((vec3<f32>(1f, 1f, 1f).x - _e128.kept.x) * _e3136), ((vec3<f32>(1f, 1f, 1f).y - _e128.kept.y) * _e3142), ((vec3<f32>(1f, 1f, 1f).z - _e128.kept.z) * _e3148))), _e1852.t));
            }
            let _e3188 = phi_3962_;
            let _e3190 = phi_3963_;
            phi_3966_ = _e3188;
            phi_3967_ = _e3190;
            phi_3968_ = _e2515;
        } else {
            phi_3966_ = u0028_abi_Sample_u0020_abi_Sight_u0029_(abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u), _e1854);
            phi_3967_ = u0028_abi_Sample_u0020_abi_Sight_u0029_();
            phi_3968_ = true;
        }
        let _e3194 = phi_3966_;
        let _e3196 = phi_3967_;
        let _e3198 = phi_3968_;
        if _e3198 {
            phi_3972_ = _e3194;
        } else {
            phi_3972_ = _e3196;
        }
        let _e3200 = phi_3972_;
        if (_e120.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e120.first_primitive)] = _e3200.unnamed;
        if (_e120.first_primitive < _e108) {
        } else {
            return;
        }
        sights.member[(0u + _e120.first_primitive)] = _e3200.unnamed_1;
        if (_e1852.triangle != 4294967295u) {
            let _e3214 = ((1f - _e1852.u) - _e1852.v);
            if (_e1852.triangle < _e90) {
            } else {
                return;
            }
            let _e3219 = triangles.member[(0u + _e1852.triangle)];
            let _e3221 = (_e3219.i0_ & 2147483647u);
            if (_e3221 < _e111) {
            } else {
                return;
            }
            let _e3227 = before.member[(0u + _e3221)];
            if (_e3219.i1_ < _e111) {
            } else {
                return;
            }
            let _e3231 = before.member[(0u + _e3219.i1_)];
            if (_e3219.i2_ < _e111) {
            } else {
                return;
            }
            let _e3235 = before.member[(0u + _e3219.i2_)];
            let _e3240 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e3227.x, _e3227.y, _e3227.z));
            let _e3251 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e3231.x, _e3231.y, _e3231.z));
            let _e3265 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e3235.x, _e3235.y, _e3235.z));
            phi_4071_ = vec3<f32>((((_e3240.x * _e3214) + (_e3251.x * _e1852.u)) + (_e3265.x * _e1852.v)), (((_e3240.y * _e3214) + (_e3251.y * _e1852.u)) + (_e3265.y * _e1852.v)), (((_e3240.z * _e3214) + (_e3251.z * _e1852.u)) + (_e3265.z * _e1852.v)));
        } else {
            phi_4071_ = vec3<f32>(0f, 0f, 0f);
        }
        let _e3277 = phi_4071_;
        if (_e120.first_primitive < arrayLength((&past.member))) {
        } else {
            return;
        }
        past.member[(0u + _e120.first_primitive)] = vec4<f32>(_e3277.x, _e3277.y, _e3277.z, 1f);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_layers_layer_motion_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
