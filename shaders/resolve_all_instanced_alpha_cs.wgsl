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

struct type_17 {
    member: array<f32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct evaluate_Verdict {
    visibility: f32,
    is_doubted: bool,
}

struct u0028_evaluate_Verdict_u0020_bool_u0029_ {
    unnamed: evaluate_Verdict,
    unnamed_1: bool,
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

struct lt_math_LightProjection {
    row_x: vec4<f32>,
    row_y: vec4<f32>,
    row_z: vec4<f32>,
    row_w: vec4<f32>,
}

struct abi_ShadowParams {
    projection: lt_math_LightProjection,
    light: vec4<f32>,
    test: vec4<f32>,
    size: vec2<u32>,
    map_size: u32,
    epsilon: f32,
    root: u32,
    level_count: u32,
    fade_uv: f32,
    pad0_: u32,
}

struct type_35 {
    member: abi_ShadowParams,
}

struct lt_bvh_Node {
    frame: vec4<u32>,
    links: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    z: vec4<u32>,
}

struct type_40 {
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

struct type_44 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_48 {
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

struct type_52 {
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

struct type_66 {
    member: array<lt_bvh_Instance>,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_17;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_35;
@group(0) @binding(2) 
var<storage> nodes: type_40;
@group(0) @binding(3) 
var<storage> triangles: type_44;
@group(0) @binding(6) 
var<storage> vertices: type_48;
@group(0) @binding(7) 
var<storage> materials: type_52;
@group(0) @binding(8) 
var<storage> alpha_texels: type_13;
@group(0) @binding(5) 
var<storage> instances: type_66;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_229_: lt_bvh_traverse_Tree;
    var phi_230_: bool;
    var phi_231_: lt_bvh_traverse_Tree;
    var phi_232_: bool;
    var phi_237_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_229_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_230_ = false;
        } else {
            phi_229_ = lt_bvh_traverse_Tree();
            phi_230_ = true;
        }
        let _e81 = phi_229_;
        let _e83 = phi_230_;
        phi_231_ = _e81;
        phi_232_ = _e83;
    } else {
        phi_231_ = lt_bvh_traverse_Tree();
        phi_232_ = true;
    }
    let _e85 = phi_231_;
    let _e87 = phi_232_;
    if _e87 {
        phi_237_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_237_ = _e85;
    }
    let _e92 = phi_237_;
    return lt_bvh_traverse_Tree(_e92.root, _e92.first_primitive);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_252_: bool;
    var phi_256_: f32;

    if (param_3 != param_3) {
        phi_252_ = true;
    } else {
        let _e71 = (param_4 >= param_3);
        if _e71 {
        }
        phi_252_ = _e71;
    }
    let _e73 = phi_252_;
    if _e73 {
        phi_256_ = param_4;
    } else {
        phi_256_ = param_3;
    }
    let _e75 = phi_256_;
    return _e75;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_268_: bool;
    var phi_272_: f32;

    if (param_5 != param_5) {
        phi_268_ = true;
    } else {
        let _e71 = (param_6 <= param_5);
        if _e71 {
        }
        phi_268_ = _e71;
    }
    let _e73 = phi_268_;
    if _e73 {
        phi_272_ = param_6;
    } else {
        phi_272_ = param_5;
    }
    let _e75 = phi_272_;
    return _e75;
}

fn _lt_shaders_texture_TextureView_quad(param_7: ptr<function, texture_TextureView>, param_8: f32, param_9: f32) -> texture_TexelQuad {
    var phi_314_: f32;
    var phi_319_: f32;
    var phi_320_: bool;
    var phi_321_: f32;
    var phi_322_: bool;
    var phi_326_: f32;
    var phi_352_: f32;
    var phi_357_: f32;
    var phi_358_: bool;
    var phi_359_: f32;
    var phi_360_: bool;
    var phi_364_: f32;
    var phi_372_: f32;
    var phi_373_: f32;
    var phi_374_: f32;
    var phi_383_: f32;
    var phi_384_: f32;
    var phi_402_: u32;
    var phi_416_: u32;
    var phi_423_: u32;
    var phi_428_: u32;
    var phi_434_: u32;
    var phi_439_: u32;
    var phi_441_: texture_Axis;
    var phi_469_: f32;
    var phi_474_: f32;
    var phi_475_: bool;
    var phi_476_: f32;
    var phi_477_: bool;
    var phi_481_: f32;
    var phi_507_: f32;
    var phi_512_: f32;
    var phi_513_: bool;
    var phi_514_: f32;
    var phi_515_: bool;
    var phi_519_: f32;
    var phi_527_: f32;
    var phi_528_: f32;
    var phi_529_: f32;
    var phi_538_: f32;
    var phi_539_: f32;
    var phi_557_: u32;
    var phi_571_: u32;
    var phi_578_: u32;
    var phi_583_: u32;
    var phi_589_: u32;
    var phi_594_: u32;
    var phi_596_: texture_Axis;

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
                phi_314_ = 1f;
            } else {
                phi_314_ = 0f;
            }
            let _e102 = phi_314_;
            if (param_8 < 8388608f) {
                phi_319_ = (_e99 - _e102);
                phi_320_ = false;
            } else {
                phi_319_ = f32();
                phi_320_ = true;
            }
            let _e105 = phi_319_;
            let _e107 = phi_320_;
            phi_321_ = _e105;
            phi_322_ = _e107;
        } else {
            phi_321_ = f32();
            phi_322_ = true;
        }
        let _e109 = phi_321_;
        let _e111 = phi_322_;
        if _e111 {
            phi_326_ = param_8;
        } else {
            phi_326_ = _e109;
        }
        let _e113 = phi_326_;
        phi_374_ = (param_8 - _e113);
    } else {
        if (_e86 == 1u) {
            let _e116 = (param_8 * 0.5f);
            if (_e116 > -8388608f) {
                let _e128 = f32(select(0i, select(select(i32(_e116), i32(-2147483648), (_e116 < bitcast<f32>(3472883712u))), 2147483647i, (_e116 > bitcast<f32>(1325400063u))), (_e116 == _e116)));
                if (_e128 > _e116) {
                    phi_352_ = 1f;
                } else {
                    phi_352_ = 0f;
                }
                let _e131 = phi_352_;
                if (_e116 < 8388608f) {
                    phi_357_ = (_e128 - _e131);
                    phi_358_ = false;
                } else {
                    phi_357_ = f32();
                    phi_358_ = true;
                }
                let _e134 = phi_357_;
                let _e136 = phi_358_;
                phi_359_ = _e134;
                phi_360_ = _e136;
            } else {
                phi_359_ = f32();
                phi_360_ = true;
            }
            let _e138 = phi_359_;
            let _e140 = phi_360_;
            if _e140 {
                phi_364_ = _e116;
            } else {
                phi_364_ = _e138;
            }
            let _e142 = phi_364_;
            let _e144 = (param_8 - (2f * _e142));
            if (_e144 > 1f) {
                phi_372_ = (2f - _e144);
            } else {
                phi_372_ = _e144;
            }
            let _e148 = phi_372_;
            phi_373_ = _e148;
        } else {
            phi_373_ = param_8;
        }
        let _e150 = phi_373_;
        phi_374_ = _e150;
    }
    let _e152 = phi_374_;
    if (_e152 > 0f) {
        if (_e152 < 1f) {
            phi_383_ = _e152;
        } else {
            phi_383_ = 1f;
        }
        let _e156 = phi_383_;
        phi_384_ = _e156;
    } else {
        phi_384_ = 0f;
    }
    let _e158 = phi_384_;
    let _e159 = (_e73 - 1u);
    let _e161 = (_e158 * f32(_e73));
    if _e81 {
        let _e168 = select(select(u32(_e161), 0u, (_e161 < bitcast<f32>(0u))), 4294967295u, (_e161 > bitcast<f32>(1333788671u)));
        if (_e159 < _e168) {
            phi_402_ = _e159;
        } else {
            phi_402_ = _e168;
        }
        let _e171 = phi_402_;
        phi_441_ = texture_Axis(_e171, _e171, 0f);
    } else {
        let _e173 = (_e161 + 0.5f);
        let _e180 = select(select(u32(_e173), 0u, (_e173 < bitcast<f32>(0u))), 4294967295u, (_e173 > bitcast<f32>(1333788671u)));
        if (_e73 < _e180) {
            phi_416_ = _e73;
        } else {
            phi_416_ = _e180;
        }
        let _e183 = phi_416_;
        if (_e86 == 0u) {
            phi_423_ = _e159;
        } else {
            phi_423_ = 0u;
        }
        let _e188 = phi_423_;
        if (_e86 == 0u) {
            phi_428_ = 0u;
        } else {
            phi_428_ = _e159;
        }
        let _e191 = phi_428_;
        if (_e183 == 0u) {
            phi_434_ = _e188;
        } else {
            phi_434_ = (_e183 - 1u);
        }
        let _e195 = phi_434_;
        if (_e183 > _e159) {
            phi_439_ = _e191;
        } else {
            phi_439_ = _e183;
        }
        let _e198 = phi_439_;
        phi_441_ = texture_Axis(_e195, _e198, (_e173 - f32(_e183)));
    }
    let _e201 = phi_441_;
    let _e203 = (*param_7).flags;
    let _e206 = ((_e203 >> bitcast<u32>(6u)) & 3u);
    if (_e206 == 0u) {
        if (param_9 > -8388608f) {
            let _e219 = f32(select(0i, select(select(i32(param_9), i32(-2147483648), (param_9 < bitcast<f32>(3472883712u))), 2147483647i, (param_9 > bitcast<f32>(1325400063u))), (param_9 == param_9)));
            if (_e219 > param_9) {
                phi_469_ = 1f;
            } else {
                phi_469_ = 0f;
            }
            let _e222 = phi_469_;
            if (param_9 < 8388608f) {
                phi_474_ = (_e219 - _e222);
                phi_475_ = false;
            } else {
                phi_474_ = f32();
                phi_475_ = true;
            }
            let _e225 = phi_474_;
            let _e227 = phi_475_;
            phi_476_ = _e225;
            phi_477_ = _e227;
        } else {
            phi_476_ = f32();
            phi_477_ = true;
        }
        let _e229 = phi_476_;
        let _e231 = phi_477_;
        if _e231 {
            phi_481_ = param_9;
        } else {
            phi_481_ = _e229;
        }
        let _e233 = phi_481_;
        phi_529_ = (param_9 - _e233);
    } else {
        if (_e206 == 1u) {
            let _e236 = (param_9 * 0.5f);
            if (_e236 > -8388608f) {
                let _e248 = f32(select(0i, select(select(i32(_e236), i32(-2147483648), (_e236 < bitcast<f32>(3472883712u))), 2147483647i, (_e236 > bitcast<f32>(1325400063u))), (_e236 == _e236)));
                if (_e248 > _e236) {
                    phi_507_ = 1f;
                } else {
                    phi_507_ = 0f;
                }
                let _e251 = phi_507_;
                if (_e236 < 8388608f) {
                    phi_512_ = (_e248 - _e251);
                    phi_513_ = false;
                } else {
                    phi_512_ = f32();
                    phi_513_ = true;
                }
                let _e254 = phi_512_;
                let _e256 = phi_513_;
                phi_514_ = _e254;
                phi_515_ = _e256;
            } else {
                phi_514_ = f32();
                phi_515_ = true;
            }
            let _e258 = phi_514_;
            let _e260 = phi_515_;
            if _e260 {
                phi_519_ = _e236;
            } else {
                phi_519_ = _e258;
            }
            let _e262 = phi_519_;
            let _e264 = (param_9 - (2f * _e262));
            if (_e264 > 1f) {
                phi_527_ = (2f - _e264);
            } else {
                phi_527_ = _e264;
            }
            let _e268 = phi_527_;
            phi_528_ = _e268;
        } else {
            phi_528_ = param_9;
        }
        let _e270 = phi_528_;
        phi_529_ = _e270;
    }
    let _e272 = phi_529_;
    if (_e272 > 0f) {
        if (_e272 < 1f) {
            phi_538_ = _e272;
        } else {
            phi_538_ = 1f;
        }
        let _e276 = phi_538_;
        phi_539_ = _e276;
    } else {
        phi_539_ = 0f;
    }
    let _e278 = phi_539_;
    let _e279 = (_e77 - 1u);
    let _e281 = (_e278 * f32(_e77));
    if _e81 {
        let _e288 = select(select(u32(_e281), 0u, (_e281 < bitcast<f32>(0u))), 4294967295u, (_e281 > bitcast<f32>(1333788671u)));
        if (_e279 < _e288) {
            phi_557_ = _e279;
        } else {
            phi_557_ = _e288;
        }
        let _e291 = phi_557_;
        phi_596_ = texture_Axis(_e291, _e291, 0f);
    } else {
        let _e293 = (_e281 + 0.5f);
        let _e300 = select(select(u32(_e293), 0u, (_e293 < bitcast<f32>(0u))), 4294967295u, (_e293 > bitcast<f32>(1333788671u)));
        if (_e77 < _e300) {
            phi_571_ = _e77;
        } else {
            phi_571_ = _e300;
        }
        let _e303 = phi_571_;
        if (_e206 == 0u) {
            phi_578_ = _e279;
        } else {
            phi_578_ = 0u;
        }
        let _e308 = phi_578_;
        if (_e206 == 0u) {
            phi_583_ = 0u;
        } else {
            phi_583_ = _e279;
        }
        let _e311 = phi_583_;
        if (_e303 == 0u) {
            phi_589_ = _e308;
        } else {
            phi_589_ = (_e303 - 1u);
        }
        let _e315 = phi_589_;
        if (_e303 > _e279) {
            phi_594_ = _e311;
        } else {
            phi_594_ = _e303;
        }
        let _e318 = phi_594_;
        phi_596_ = texture_Axis(_e315, _e318, (_e293 - f32(_e303)));
    }
    let _e321 = phi_596_;
    let _e325 = (*param_7).offset;
    let _e332 = (*param_7).offset;
    let _e339 = (*param_7).offset;
    let _e346 = (*param_7).offset;
    return texture_TexelQuad(array<u32, 4>(((_e325 + (_e321.low * _e73)) + _e201.low), ((_e332 + (_e321.low * _e73)) + _e201.high), ((_e339 + (_e321.high * _e73)) + _e201.low), ((_e346 + (_e321.high * _e73)) + _e201.high)), vec4<f32>(((1f - _e201.fraction) * (1f - _e321.fraction)), (_e201.fraction * (1f - _e321.fraction)), ((1f - _e201.fraction) * _e321.fraction), (_e201.fraction * _e321.fraction)));
}

fn _lt_shaders_abi_Sample_is_valid(param_10: ptr<function, abi_Sample>) -> bool {
    var phi_668_: bool;
    var phi_669_: bool;
    var phi_670_: bool;
    var phi_671_: bool;
    var phi_675_: bool;

    let _e71 = (*param_10).normal[0u];
    let _e73 = global[0u];
    if (_e71 == _e73) {
        let _e76 = (*param_10).normal[1u];
        let _e78 = global[1u];
        if (_e76 == _e78) {
            let _e81 = (*param_10).normal[2u];
            let _e83 = global[2u];
            phi_668_ = (_e81 == _e83);
            phi_669_ = false;
        } else {
            phi_668_ = bool();
            phi_669_ = true;
        }
        let _e86 = phi_668_;
        let _e88 = phi_669_;
        phi_670_ = _e86;
        phi_671_ = _e88;
    } else {
        phi_670_ = bool();
        phi_671_ = true;
    }
    let _e90 = phi_670_;
    let _e92 = phi_671_;
    if _e92 {
        phi_675_ = false;
    } else {
        phi_675_ = _e90;
    }
    let _e94 = phi_675_;
    return !(_e94);
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var local_2: lt_bvh_traverse_Stack;
    var local_3: abi_Sample;
    var phi_772_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_776_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_827_: f32;
    var phi_883_: bool;
    var phi_884_: bool;
    var phi_885_: bool;
    var phi_889_: bool;
    var phi_890_: bool;
    var phi_891_: bool;
    var phi_892_: bool;
    var phi_893_: bool;
    var phi_894_: bool;
    var phi_895_: bool;
    var phi_896_: bool;
    var phi_897_: bool;
    var phi_898_: bool;
    var phi_899_: bool;
    var phi_900_: bool;
    var phi_901_: bool;
    var phi_902_: bool;
    var phi_903_: bool;
    var phi_904_: bool;
    var phi_905_: bool;
    var phi_906_: bool;
    var phi_910_: bool;
    var phi_914_: bool;
    var phi_984_: f32;
    var phi_991_: f32;
    var phi_998_: f32;
    var phi_1005_: f32;
    var phi_1012_: f32;
    var phi_1019_: f32;
    var phi_1036_: f32;
    var phi_1041_: f32;
    var phi_1046_: f32;
    var phi_1067_: u32;
    var phi_1072_: u32;
    var phi_1077_: u32;
    var phi_1191_: bool;
    var phi_1192_: bool;
    var phi_1223_: u32;
    var phi_1225_: u32;
    var phi_1228_: bool;
    var phi_1308_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1335_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1362_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1368_: u32;
    var phi_1371_: u32;
    var phi_1385_: u32;
    var phi_1395_: u32;
    var phi_1405_: u32;
    var phi_1423_: u32;
    var phi_1433_: u32;
    var phi_1443_: u32;
    var phi_1479_: u32;
    var phi_1492_: u32;
    var phi_1497_: u32;
    var phi_1498_: u32;
    var phi_1499_: u32;
    var phi_1369_: u32;
    var phi_1372_: u32;
    var local_4: u32;
    var local_5: u32;
    var local_6: u32;
    var phi_1557_: u32;
    var phi_1560_: bool;
    var phi_1609_: f32;
    var phi_1614_: f32;
    var phi_1619_: f32;
    var phi_1627_: f32;
    var phi_1632_: f32;
    var phi_1637_: f32;
    var phi_1781_: bool;
    var phi_1782_: bool;
    var phi_1783_: bool;
    var phi_1787_: bool;
    var phi_1788_: bool;
    var phi_1789_: bool;
    var phi_1790_: bool;
    var phi_1791_: bool;
    var phi_1792_: bool;
    var phi_1793_: bool;
    var phi_1794_: bool;
    var phi_1795_: bool;
    var phi_1796_: bool;
    var phi_1797_: bool;
    var phi_1798_: bool;
    var phi_1799_: bool;
    var phi_1800_: bool;
    var phi_1801_: bool;
    var phi_1802_: bool;
    var phi_1803_: bool;
    var phi_1804_: bool;
    var phi_1808_: bool;
    var phi_1812_: bool;
    var phi_1882_: f32;
    var phi_1889_: f32;
    var phi_1896_: f32;
    var phi_1903_: f32;
    var phi_1910_: f32;
    var phi_1917_: f32;
    var phi_1934_: f32;
    var phi_1939_: f32;
    var phi_1944_: f32;
    var phi_1972_: bool;
    var phi_1973_: bool;
    var phi_1981_: u32;
    var phi_1982_: u32;
    var phi_1993_: vec3<f32>;
    var phi_1994_: vec3<f32>;
    var phi_2007_: u32;
    var phi_2012_: u32;
    var phi_2017_: u32;
    var phi_2131_: bool;
    var phi_2132_: bool;
    var phi_2163_: u32;
    var phi_2165_: u32;
    var phi_2168_: bool;
    var phi_2248_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2275_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2302_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2308_: u32;
    var phi_2311_: u32;
    var phi_2325_: u32;
    var phi_2335_: u32;
    var phi_2345_: u32;
    var phi_2363_: u32;
    var phi_2373_: u32;
    var phi_2383_: u32;
    var phi_2419_: u32;
    var phi_2432_: u32;
    var phi_2437_: u32;
    var phi_2438_: u32;
    var phi_2439_: u32;
    var phi_2309_: u32;
    var phi_2312_: u32;
    var local_7: u32;
    var local_8: u32;
    var local_9: u32;
    var phi_2497_: u32;
    var phi_2500_: bool;
    var phi_2544_: vec3<f32>;
    var phi_2545_: vec3<f32>;
    var phi_2574_: vec3<f32>;
    var phi_2575_: vec3<f32>;
    var phi_2604_: vec3<f32>;
    var phi_2605_: vec3<f32>;
    var phi_2623_: bool;
    var phi_2624_: bool;
    var phi_2628_: f32;
    var phi_2629_: f32;
    var phi_2630_: f32;
    var phi_2631_: f32;
    var phi_2639_: f32;
    var phi_2649_: bool;
    var phi_2650_: bool;
    var phi_2654_: f32;
    var phi_2655_: f32;
    var phi_2656_: f32;
    var phi_2657_: f32;
    var phi_2665_: f32;
    var phi_2675_: bool;
    var phi_2676_: bool;
    var phi_2680_: f32;
    var phi_2681_: f32;
    var phi_2682_: f32;
    var phi_2683_: f32;
    var phi_2691_: f32;
    var phi_2706_: f32;
    var phi_2707_: bool;
    var phi_2708_: f32;
    var phi_2709_: bool;
    var phi_2710_: f32;
    var phi_2711_: bool;
    var phi_2729_: f32;
    var phi_2730_: bool;
    var phi_2731_: bool;
    var phi_2732_: f32;
    var phi_2733_: bool;
    var phi_2734_: bool;
    var phi_2738_: bool;
    var phi_2739_: f32;
    var phi_2740_: bool;
    var phi_2768_: vec3<f32>;
    var phi_2769_: vec3<f32>;
    var phi_2794_: vec3<f32>;
    var phi_2795_: vec3<f32>;
    var phi_2820_: vec3<f32>;
    var phi_2821_: vec3<f32>;
    var phi_2877_: f32;
    var phi_2886_: f32;
    var phi_2895_: f32;
    var phi_2904_: f32;
    var phi_2911_: f32;
    var phi_2918_: f32;
    var phi_2931_: f32;
    var phi_2940_: f32;
    var phi_2949_: f32;
    var phi_2958_: f32;
    var phi_2965_: f32;
    var phi_2972_: f32;
    var phi_2989_: f32;
    var phi_2994_: f32;
    var phi_2999_: f32;
    var phi_3007_: f32;
    var phi_3012_: f32;
    var phi_3017_: f32;
    var phi_3029_: f32;
    var phi_3034_: f32;
    var phi_3039_: f32;
    var phi_3044_: f32;
    var phi_3049_: lt_bvh_triangle_Intersection;
    var phi_3050_: bool;
    var phi_3051_: lt_bvh_triangle_Intersection;
    var phi_3052_: bool;
    var phi_3056_: lt_bvh_triangle_Intersection;
    var phi_3057_: bool;
    var phi_3058_: lt_bvh_triangle_Intersection;
    var phi_3059_: bool;
    var phi_3060_: bool;
    var phi_3064_: bool;
    var phi_3068_: lt_bvh_triangle_Intersection;
    var phi_3282_: f32;
    var phi_3285_: bool;
    var phi_3286_: bool;
    var phi_3287_: bool;
    var phi_3291_: bool;
    var phi_3292_: bool;
    var phi_3293_: bool;
    var phi_3294_: bool;
    var phi_3295_: bool;
    var phi_3296_: bool;
    var phi_3297_: bool;
    var phi_3298_: bool;
    var phi_3299_: bool;
    var phi_3300_: bool;
    var phi_2498_: u32;
    var phi_2501_: bool;
    var phi_3304_: bool;
    var phi_3305_: bool;
    var local_10: bool;
    var phi_3347_: bool;
    var phi_3348_: bool;
    var phi_3379_: u32;
    var phi_3380_: u32;
    var phi_2166_: u32;
    var phi_2169_: bool;
    var phi_3381_: bool;
    var phi_3382_: bool;
    var phi_3383_: bool;
    var local_11: bool;
    var phi_3387_: bool;
    var phi_3391_: bool;
    var phi_3392_: bool;
    var phi_3393_: bool;
    var phi_3394_: bool;
    var phi_3398_: bool;
    var phi_3402_: bool;
    var phi_3403_: bool;
    var phi_3404_: bool;
    var phi_3405_: bool;
    var phi_3406_: bool;
    var phi_3407_: bool;
    var phi_3408_: bool;
    var phi_1558_: u32;
    var phi_1561_: bool;
    var phi_3412_: bool;
    var local_12: bool;
    var phi_3454_: bool;
    var phi_3455_: bool;
    var phi_3486_: u32;
    var phi_3487_: u32;
    var phi_1226_: u32;
    var phi_1229_: bool;
    var phi_3488_: bool;
    var phi_3489_: bool;
    var local_13: bool;
    var phi_3493_: bool;
    var phi_3497_: bool;
    var phi_3498_: bool;
    var phi_3499_: bool;
    var phi_3503_: bool;
    var phi_3504_: bool;
    var phi_3508_: bool;
    var phi_3512_: f32;
    var phi_3513_: f32;
    var local_14: bool;
    var local_15: bool;
    var local_16: bool;
    var local_17: bool;
    var local_18: bool;
    var local_19: bool;
    var local_20: bool;

    let _e72 = id_1;
    let _e79 = arrayLength((&nodes.member));
    let _e82 = arrayLength((&triangles.member));
    let _e91 = arrayLength((&vertices.member));
    let _e97 = arrayLength((&alpha_texels.member));
    let _e100 = p.member.size[0u];
    let _e102 = p.member.size[1u];
    let _e103 = lt_shaders_entry_pixel_index(_e72, _e100, _e102);
    if (bitcast<i32>(_e103.root) != 0i) {
        if (_e103.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e111 = samples.member[(0u + _e103.first_primitive)];
        local_3 = abi_Sample(_e111.position, _e111.magnitude, _e111.normal, _e111.flags, _e111.shading_normal, _e111.albedo);
        let _e120 = p.member.light;
        let _e121 = _lt_shaders_abi_Sample_is_valid((&local_3));
        if _e121 {
            let _e123 = local_3.normal;
            let _e125 = local_3.position;
            if ((((_e123.x * (_e120.x - (_e125.x * _e120.w))) + (_e123.y * (_e120.y - (_e125.y * _e120.w)))) + (_e123.z * (_e120.z - (_e125.z * _e120.w)))) > 0f) {
                let _e149 = local_3.flags;
                let _e157 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e163 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e157.unnamed.visibility, false), _e157.unnamed_1);
                phi_772_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e163.unnamed, ((_e149 & 1u) == 0u));
            } else {
                let _e172 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e178 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e172.unnamed.visibility, false), _e172.unnamed_1);
                phi_772_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e178.unnamed, true);
            }
            let _e183 = phi_772_;
            phi_776_ = _e183;
        } else {
            let _e189 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e195 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e189.unnamed.visibility, false), _e189.unnamed_1);
            phi_776_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e195.unnamed, true);
        }
        let _e200 = phi_776_;
        let _e205 = p.member.root;
        if _e200.unnamed_1 {
            phi_3513_ = _e200.unnamed.visibility;
        } else {
            let _e207 = p.member.light;
            let _e209 = local_3.position;
            let _e211 = local_3.normal;
            let _e213 = local_3.magnitude;
            let _e215 = ((8f / 8388608f) * _e213);
            let _e223 = (_e209.x + (_e211.x * _e215));
            let _e225 = (_e209.y + (_e211.y * _e215));
            let _e227 = (_e209.z + (_e211.z * _e215));
            if (_e207.w == 0f) {
                phi_827_ = 300000000000000000000000000000000000000f;
            } else {
                phi_827_ = 1f;
            }
            let _e231 = phi_827_;
            let _e239 = (_e207.x - (_e223 * _e207.w));
            let _e240 = (_e207.y - (_e225 * _e207.w));
            let _e241 = (_e207.z - (_e227 * _e207.w));
            let _e245 = abs(_e239);
            let _e246 = abs(_e240);
            let _e247 = abs(_e241);
            if (abs(_e223) < 1000000000000000f) {
                if (abs(_e225) < 1000000000000000f) {
                    if (abs(_e227) < 1000000000000000f) {
                        if (_e245 < 1000000000000000f) {
                            if (_e246 < 1000000000000000f) {
                                if (_e247 < 1000000000000000f) {
                                    if (_e245 > 0f) {
                                        phi_884_ = bool();
                                        phi_885_ = true;
                                    } else {
                                        let _e255 = (_e246 > 0f);
                                        if _e255 {
                                            phi_883_ = bool();
                                        } else {
                                            phi_883_ = (_e247 > 0f);
                                        }
                                        let _e258 = phi_883_;
                                        phi_884_ = _e258;
                                        phi_885_ = _e255;
                                    }
                                    let _e260 = phi_884_;
                                    let _e262 = phi_885_;
                                    if _e262 {
                                        phi_889_ = true;
                                    } else {
                                        phi_889_ = _e260;
                                    }
                                    let _e264 = phi_889_;
                                    phi_890_ = _e264;
                                    phi_891_ = false;
                                } else {
                                    phi_890_ = bool();
                                    phi_891_ = true;
                                }
                                let _e266 = phi_890_;
                                let _e268 = phi_891_;
                                phi_892_ = _e266;
                                phi_893_ = false;
                                phi_894_ = _e268;
                            } else {
                                phi_892_ = bool();
                                phi_893_ = true;
                                phi_894_ = false;
                            }
                            let _e270 = phi_892_;
                            let _e272 = phi_893_;
                            let _e274 = phi_894_;
                            phi_895_ = _e270;
                            phi_896_ = _e272;
                            phi_897_ = _e274;
                        } else {
                            phi_895_ = bool();
                            phi_896_ = true;
                            phi_897_ = false;
                        }
                        let _e276 = phi_895_;
                        let _e278 = phi_896_;
                        let _e280 = phi_897_;
                        phi_898_ = _e276;
                        phi_899_ = _e278;
                        phi_900_ = _e280;
                    } else {
                        phi_898_ = bool();
                        phi_899_ = true;
                        phi_900_ = false;
                    }
                    let _e282 = phi_898_;
                    let _e284 = phi_899_;
                    let _e286 = phi_900_;
                    phi_901_ = _e282;
                    phi_902_ = _e284;
                    phi_903_ = _e286;
                } else {
                    phi_901_ = bool();
                    phi_902_ = true;
                    phi_903_ = false;
                }
                let _e288 = phi_901_;
                let _e290 = phi_902_;
                let _e292 = phi_903_;
                phi_904_ = _e288;
                phi_905_ = _e290;
                phi_906_ = _e292;
            } else {
                phi_904_ = bool();
                phi_905_ = true;
                phi_906_ = false;
            }
            let _e294 = phi_904_;
            let _e296 = phi_905_;
            let _e298 = phi_906_;
            if _e296 {
                phi_910_ = true;
            } else {
                phi_910_ = _e298;
            }
            let _e300 = phi_910_;
            if _e300 {
                phi_914_ = false;
            } else {
                phi_914_ = _e294;
            }
            let _e302 = phi_914_;
            if _e302 {
                let _e303 = (_e205 >= _e79);
                if _e303 {
                    phi_3497_ = false;
                } else {
                    if (_e205 < _e79) {
                    } else {
                        return;
                    }
                    let _e309 = nodes.member[(0u + _e205)].frame[0u];
                    let _e313 = nodes.member[(0u + _e205)].frame[1u];
                    let _e317 = nodes.member[(0u + _e205)].frame[2u];
                    let _e321 = nodes.member[(0u + _e205)].frame[0u];
                    let _e325 = nodes.member[(0u + _e205)].frame[1u];
                    let _e329 = nodes.member[(0u + _e205)].frame[2u];
                    let _e333 = nodes.member[(0u + _e205)].frame[3u];
                    let _e367 = core_intrinsics_maximum_number_nsz_f32_(abs(_e239), abs(_e240));
                    let _e368 = core_intrinsics_maximum_number_nsz_f32_(_e367, abs(_e241));
                    let _e369 = (_e368 * 0.0000000000009094947f);
                    if (abs(_e239) < _e369) {
                        phi_984_ = _e369;
                    } else {
                        phi_984_ = abs(_e239);
                    }
                    let _e374 = phi_984_;
                    if (_e239 < 0f) {
                        phi_991_ = (-1f / _e374);
                    } else {
                        phi_991_ = (1f / _e374);
                    }
                    let _e379 = phi_991_;
                    if (abs(_e240) < _e369) {
                        phi_998_ = _e369;
                    } else {
                        phi_998_ = abs(_e240);
                    }
                    let _e384 = phi_998_;
                    if (_e240 < 0f) {
                        phi_1005_ = (-1f / _e384);
                    } else {
                        phi_1005_ = (1f / _e384);
                    }
                    let _e389 = phi_1005_;
                    if (abs(_e241) < _e369) {
                        phi_1012_ = _e369;
                    } else {
                        phi_1012_ = abs(_e241);
                    }
                    let _e394 = phi_1012_;
                    if (_e241 < 0f) {
                        phi_1019_ = (-1f / _e394);
                    } else {
                        phi_1019_ = (1f / _e394);
                    }
                    let _e399 = phi_1019_;
                    let _e403 = abs((bitcast<f32>(_e309) - _e223));
                    let _e404 = abs((bitcast<f32>(_e313) - _e225));
                    let _e405 = abs((bitcast<f32>(_e317) - _e227));
                    let _e409 = abs(((bitcast<f32>(_e321) + (bitcast<f32>((((_e333 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e223));
                    let _e410 = abs(((bitcast<f32>(_e325) + (bitcast<f32>((((_e333 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e225));
                    let _e411 = abs(((bitcast<f32>(_e329) + (bitcast<f32>((((_e333 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e227));
                    if (_e403 > _e409) {
                        phi_1036_ = _e403;
                    } else {
                        phi_1036_ = _e409;
                    }
                    let _e414 = phi_1036_;
                    if (_e404 > _e410) {
                        phi_1041_ = _e404;
                    } else {
                        phi_1041_ = _e410;
                    }
                    let _e417 = phi_1041_;
                    if (_e405 > _e411) {
                        phi_1046_ = _e405;
                    } else {
                        phi_1046_ = _e411;
                    }
                    let _e420 = phi_1046_;
                    let _e421 = core_intrinsics_maximum_number_nsz_f32_(_e414, _e417);
                    let _e422 = core_intrinsics_maximum_number_nsz_f32_(_e421, _e420);
                    let _e426 = (_e422 * 0.0000019073486f);
                    let _e427 = (abs(_e379) * _e426);
                    let _e428 = (abs(_e389) * _e426);
                    let _e429 = (abs(_e399) * _e426);
                    let _e433 = (_e422 * 0.0000009536743f);
                    let _e434 = (abs(_e379) * _e433);
                    let _e435 = (abs(_e389) * _e433);
                    let _e436 = (abs(_e399) * _e433);
                    if (_e379 < 0f) {
                        phi_1067_ = 0u;
                    } else {
                        phi_1067_ = 1u;
                    }
                    let _e439 = phi_1067_;
                    if (_e389 < 0f) {
                        phi_1072_ = 0u;
                    } else {
                        phi_1072_ = 2u;
                    }
                    let _e442 = phi_1072_;
                    if (_e399 < 0f) {
                        phi_1077_ = 0u;
                    } else {
                        phi_1077_ = 4u;
                    }
                    let _e445 = phi_1077_;
                    let _e447 = ((_e439 | _e442) | _e445);
                    let _e448 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e205, 2147483648u);
                    local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e448.first[0], _e448.first[1], _e448.first[2], _e448.first[3], _e448.first[4], _e448.first[5], _e448.first[6], _e448.first[7], _e448.first[8], _e448.first[9], _e448.first[10], _e448.first[11], _e448.first[12], _e448.first[13], _e448.first[14], _e448.first[15], _e448.first[16], _e448.first[17], _e448.first[18], _e448.first[19], _e448.first[20], _e448.first[21], _e448.first[22], _e448.first[23], _e448.first[24], _e448.first[25], _e448.first[26], _e448.first[27], _e448.first[28], _e448.first[29], _e448.first[30], _e448.first[31]), array<u32, 32>(_e448.mask[0], _e448.mask[1], _e448.mask[2], _e448.mask[3], _e448.mask[4], _e448.mask[5], _e448.mask[6], _e448.mask[7], _e448.mask[8], _e448.mask[9], _e448.mask[10], _e448.mask[11], _e448.mask[12], _e448.mask[13], _e448.mask[14], _e448.mask[15], _e448.mask[16], _e448.mask[17], _e448.mask[18], _e448.mask[19], _e448.mask[20], _e448.mask[21], _e448.mask[22], _e448.mask[23], _e448.mask[24], _e448.mask[25], _e448.mask[26], _e448.mask[27], _e448.mask[28], _e448.mask[29], _e448.mask[30], _e448.mask[31]), _e448.len, _e448.group, _e448.group_mask);
                    let _e522 = local_2.group_mask;
                    if ((_e522 & 4278190080u) == 0u) {
                        let _e526 = local_2.len;
                        if (_e526 == 0u) {
                            phi_1191_ = false;
                        } else {
                            let _e530 = local_2.len;
                            local_2.len = (_e530 - 1u);
                            let _e533 = local_2.len;
                            if (_e533 < 32u) {
                            } else {
                                return;
                            }
                            let _e538 = local_2.first[(0u + _e533)];
                            local_2.group = _e538;
                            let _e541 = local_2.len;
                            if (_e541 < 32u) {
                            } else {
                                return;
                            }
                            let _e546 = local_2.mask[(0u + _e541)];
                            local_2.group_mask = _e546;
                            phi_1191_ = true;
                        }
                        let _e549 = phi_1191_;
                        phi_1192_ = _e549;
                    } else {
                        phi_1192_ = true;
                    }
                    let _e551 = phi_1192_;
                    if _e551 {
                        let _e553 = local_2.group_mask;
                        let _e559 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e553)), 32u, (_e553 == 0u)));
                        let _e563 = local_2.group_mask;
                        let _e577 = local_2.group_mask;
                        local_2.group_mask = (_e577 & ~((1u << bitcast<u32>((_e559 & 31u)))));
                        let _e580 = local_2.group;
                        phi_1223_ = (_e580 + countOneBits(((_e563 & ~((4294967295u << bitcast<u32>((((_e559 - 24u) ^ 7u) & 31u))))) & 255u)));
                    } else {
                        phi_1223_ = 4294967295u;
                    }
                    let _e583 = phi_1223_;
                    phi_1225_ = _e583;
                    phi_1228_ = false;
                    loop {
                        let _e585 = phi_1225_;
                        let _e587 = phi_1228_;
                        if (_e585 != 4294967295u) {
                            if (_e585 < _e79) {
                            } else {
                                return;
                            }
                            let _e594 = nodes.member[(0u + _e585)].frame[3u];
                            let _e619 = (bitcast<f32>((((_e594 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e379);
                            let _e620 = (bitcast<f32>((((_e594 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e389);
                            let _e621 = (bitcast<f32>((((_e594 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e399);
                            let _e624 = nodes.member[(0u + _e585)].frame[0u];
                            let _e628 = nodes.member[(0u + _e585)].frame[1u];
                            let _e632 = nodes.member[(0u + _e585)].frame[2u];
                            let _e637 = ((bitcast<f32>(_e624) - _e223) * _e379);
                            let _e638 = ((bitcast<f32>(_e628) - _e225) * _e389);
                            let _e639 = ((bitcast<f32>(_e632) - _e227) * _e399);
                            let _e647 = nodes.member[(0u + _e585)].x;
                            if (_e379 < 0f) {
                                let _e658 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e647.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e664 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e658.unnamed.root, _e647.w), _e658.unnamed_1);
                                let _e670 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e664.unnamed, lt_bvh_traverse_Tree(_e647.x, _e664.unnamed_1.first_primitive));
                                phi_1308_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e670.unnamed, lt_bvh_traverse_Tree(_e670.unnamed_1.root, _e647.y));
                            } else {
                                let _e686 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e647.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e692 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e686.unnamed.root, _e647.y), _e686.unnamed_1);
                                let _e698 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e692.unnamed, lt_bvh_traverse_Tree(_e647.z, _e692.unnamed_1.first_primitive));
                                phi_1308_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e698.unnamed, lt_bvh_traverse_Tree(_e698.unnamed_1.root, _e647.w));
                            }
                            let _e706 = phi_1308_;
                            let _e716 = nodes.member[(0u + _e585)].y;
                            if (_e389 < 0f) {
                                let _e727 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e716.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e733 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e727.unnamed.root, _e716.w), _e727.unnamed_1);
                                let _e739 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e733.unnamed, lt_bvh_traverse_Tree(_e716.x, _e733.unnamed_1.first_primitive));
                                phi_1335_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e739.unnamed, lt_bvh_traverse_Tree(_e739.unnamed_1.root, _e716.y));
                            } else {
                                let _e755 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e716.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e761 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e755.unnamed.root, _e716.y), _e755.unnamed_1);
                                let _e767 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e761.unnamed, lt_bvh_traverse_Tree(_e716.z, _e761.unnamed_1.first_primitive));
                                phi_1335_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e767.unnamed, lt_bvh_traverse_Tree(_e767.unnamed_1.root, _e716.w));
                            }
                            let _e775 = phi_1335_;
                            let _e785 = nodes.member[(0u + _e585)].z;
                            if (_e399 < 0f) {
                                let _e796 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e785.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e802 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e796.unnamed.root, _e785.w), _e796.unnamed_1);
                                let _e808 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e802.unnamed, lt_bvh_traverse_Tree(_e785.x, _e802.unnamed_1.first_primitive));
                                phi_1362_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e808.unnamed, lt_bvh_traverse_Tree(_e808.unnamed_1.root, _e785.y));
                            } else {
                                let _e824 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e785.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e830 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e824.unnamed.root, _e785.y), _e824.unnamed_1);
                                let _e836 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e830.unnamed, lt_bvh_traverse_Tree(_e785.z, _e830.unnamed_1.first_primitive));
                                phi_1362_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e836.unnamed, lt_bvh_traverse_Tree(_e836.unnamed_1.root, _e785.w));
                            }
                            let _e844 = phi_1362_;
                            phi_1368_ = 0u;
                            phi_1371_ = 0u;
                            loop {
                                let _e854 = phi_1368_;
                                let _e856 = phi_1371_;
                                local_4 = _e856;
                                local_5 = _e856;
                                local_6 = _e856;
                                let _e857 = (_e854 < 8u);
                                if _e857 {
                                    let _e859 = (_e854 >> bitcast<u32>(2i));
                                    let _e860 = (_e854 & 3u);
                                    if (_e859 == 0u) {
                                        phi_1385_ = _e706.unnamed.root;
                                    } else {
                                        phi_1385_ = _e706.unnamed.first_primitive;
                                    }
                                    let _e863 = phi_1385_;
                                    if (_e859 == 0u) {
                                        phi_1395_ = _e775.unnamed.root;
                                    } else {
                                        phi_1395_ = _e775.unnamed.first_primitive;
                                    }
                                    let _e872 = phi_1395_;
                                    if (_e859 == 0u) {
                                        phi_1405_ = _e844.unnamed.root;
                                    } else {
                                        phi_1405_ = _e844.unnamed.first_primitive;
                                    }
                                    let _e881 = phi_1405_;
                                    let _e894 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e863 >> bitcast<u32>(((_e860 * 8u) & 31u))) & 255u)) * _e619) + (_e637 - _e427)), ((f32(((_e872 >> bitcast<u32>(((_e860 * 8u) & 31u))) & 255u)) * _e620) + (_e638 - _e428)));
                                    let _e895 = core_intrinsics_maximum_number_nsz_f32_(_e894, ((f32(((_e881 >> bitcast<u32>(((_e860 * 8u) & 31u))) & 255u)) * _e621) + (_e639 - _e429)));
                                    if (_e859 == 0u) {
                                        phi_1423_ = _e706.unnamed_1.root;
                                    } else {
                                        phi_1423_ = _e706.unnamed_1.first_primitive;
                                    }
                                    let _e898 = phi_1423_;
                                    if (_e859 == 0u) {
                                        phi_1433_ = _e775.unnamed_1.root;
                                    } else {
                                        phi_1433_ = _e775.unnamed_1.first_primitive;
                                    }
                                    let _e907 = phi_1433_;
                                    if (_e859 == 0u) {
                                        phi_1443_ = _e844.unnamed_1.root;
                                    } else {
                                        phi_1443_ = _e844.unnamed_1.first_primitive;
                                    }
                                    let _e916 = phi_1443_;
                                    let _e929 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e898 >> bitcast<u32>(((_e860 * 8u) & 31u))) & 255u)) * _e619) + (_e637 + _e427)), ((f32(((_e907 >> bitcast<u32>(((_e860 * 8u) & 31u))) & 255u)) * _e620) + (_e638 + _e428)));
                                    let _e930 = core_intrinsics_minimum_number_nsz_f32_(_e929, ((f32(((_e916 >> bitcast<u32>(((_e860 * 8u) & 31u))) & 255u)) * _e621) + (_e639 + _e429)));
                                    if (_e895 <= _e930) {
                                        if (_e895 <= _e231) {
                                            if (_e930 >= 0f) {
                                                if (_e859 == 0u) {
                                                    let _e937 = nodes.member[(0u + _e585)].links[2u];
                                                    phi_1479_ = _e937;
                                                } else {
                                                    let _e940 = nodes.member[(0u + _e585)].links[3u];
                                                    phi_1479_ = _e940;
                                                }
                                                let _e942 = phi_1479_;
                                                let _e947 = ((_e942 >> bitcast<u32>(((_e860 * 8u) & 31u))) & 255u);
                                                let _e948 = (_e947 & 31u);
                                                if (_e948 >= 24u) {
                                                    phi_1492_ = (24u + ((_e948 - 24u) ^ _e447));
                                                } else {
                                                    phi_1492_ = _e948;
                                                }
                                                let _e954 = phi_1492_;
                                                phi_1497_ = (_e856 | ((_e947 >> bitcast<u32>(5i)) << bitcast<u32>((_e954 & 31u))));
                                            } else {
                                                phi_1497_ = _e856;
                                            }
                                            let _e962 = phi_1497_;
                                            phi_1498_ = _e962;
                                        } else {
                                            phi_1498_ = _e856;
                                        }
                                        let _e964 = phi_1498_;
                                        phi_1499_ = _e964;
                                    } else {
                                        phi_1499_ = _e856;
                                    }
                                    let _e966 = phi_1499_;
                                    phi_1369_ = (_e854 + 1u);
                                    phi_1372_ = _e966;
                                } else {
                                    phi_1369_ = u32();
                                    phi_1372_ = u32();
                                }
                                let _e969 = phi_1369_;
                                let _e971 = phi_1372_;
                                continue;
                                continuing {
                                    phi_1368_ = _e969;
                                    phi_1371_ = _e971;
                                    break if !(_e857);
                                }
                            }
                            let _e975 = nodes.member[(0u + _e585)].links[0u];
                            let _e979 = nodes.member[(0u + _e585)].frame[3u];
                            let _e983 = local_4;
                            if ((_e983 & 4278190080u) == 0u) {
                            } else {
                                let _e987 = local_2.group_mask;
                                if ((_e987 & 4278190080u) == 0u) {
                                } else {
                                    let _e991 = local_2.len;
                                    if (_e991 < 32u) {
                                        let _e994 = local_2.group;
                                        let _e996 = local_2.len;
                                        if (_e996 < 32u) {
                                        } else {
                                            return;
                                        }
                                        local_2.first[(0u + _e996)] = _e994;
                                        let _e1002 = local_2.group_mask;
                                        let _e1004 = local_2.len;
                                        if (_e1004 < 32u) {
                                        } else {
                                            return;
                                        }
                                        local_2.mask[(0u + _e1004)] = _e1002;
                                        let _e1011 = local_2.len;
                                        local_2.len = (_e1011 + 1u);
                                    }
                                }
                                local_2.group = (_e205 + _e975);
                                let _e1015 = local_5;
                                local_2.group_mask = ((_e1015 & 4278190080u) | (_e979 >> bitcast<u32>(24i)));
                            }
                            let _e1020 = local_6;
                            phi_1557_ = (_e1020 & 16777215u);
                            phi_1560_ = _e587;
                            loop {
                                let _e1023 = phi_1557_;
                                let _e1025 = phi_1560_;
                                local_19 = _e1025;
                                let _e1026 = (_e1023 == 0u);
                                local_12 = _e1026;
                                local_20 = _e1026;
                                if _e1026 {
                                    phi_1558_ = u32();
                                    phi_1561_ = bool();
                                    phi_3412_ = false;
                                } else {
                                    let _e1029 = nodes.member[(0u + _e585)].links[1u];
                                    let _e1033 = (_e1029 + select(firstTrailingBit(_e1023), 32u, (_e1023 == 0u)));
                                    if (_e1033 < arrayLength((&instances.member))) {
                                    } else {
                                        return;
                                    }
                                    let _e1040 = instances.member[(0u + _e1033)].low_world;
                                    let _e1042 = instances.member[(0u + _e1033)].high_world;
                                    let _e1049 = ((_e1040.x - _e223) * _e379);
                                    let _e1050 = ((_e1040.y - _e225) * _e389);
                                    let _e1051 = ((_e1040.z - _e227) * _e399);
                                    let _e1058 = ((_e1042.x - _e223) * _e379);
                                    let _e1059 = ((_e1042.y - _e225) * _e389);
                                    let _e1060 = ((_e1042.z - _e227) * _e399);
                                    if (_e1049 < _e1058) {
                                        phi_1609_ = _e1049;
                                    } else {
                                        phi_1609_ = _e1058;
                                    }
                                    let _e1063 = phi_1609_;
                                    if (_e1050 < _e1059) {
                                        phi_1614_ = _e1050;
                                    } else {
                                        phi_1614_ = _e1059;
                                    }
                                    let _e1066 = phi_1614_;
                                    if (_e1051 < _e1060) {
                                        phi_1619_ = _e1051;
                                    } else {
                                        phi_1619_ = _e1060;
                                    }
                                    let _e1069 = phi_1619_;
                                    if (_e1049 > _e1058) {
                                        phi_1627_ = _e1049;
                                    } else {
                                        phi_1627_ = _e1058;
                                    }
                                    let _e1075 = phi_1627_;
                                    if (_e1050 > _e1059) {
                                        phi_1632_ = _e1050;
                                    } else {
                                        phi_1632_ = _e1059;
                                    }
                                    let _e1078 = phi_1632_;
                                    if (_e1051 > _e1060) {
                                        phi_1637_ = _e1051;
                                    } else {
                                        phi_1637_ = _e1060;
                                    }
                                    let _e1081 = phi_1637_;
                                    let _e1085 = core_intrinsics_maximum_number_nsz_f32_((_e1063 - _e434), (_e1066 - _e435));
                                    let _e1086 = core_intrinsics_maximum_number_nsz_f32_(_e1085, (_e1069 - _e436));
                                    let _e1087 = core_intrinsics_minimum_number_nsz_f32_((_e1075 + _e434), (_e1078 + _e435));
                                    let _e1088 = core_intrinsics_minimum_number_nsz_f32_(_e1087, (_e1081 + _e436));
                                    if (_e1086 <= _e1088) {
                                        if (_e1086 <= _e231) {
                                            if (_e1088 >= 0f) {
                                                let _e1094 = instances.member[(0u + _e1033)].world_to_object[0u];
                                                let _e1105 = ((((_e1094.x * _e223) + (_e1094.y * _e225)) + (_e1094.z * _e227)) + (_e1094.w * 1f));
                                                let _e1107 = instances.member[(0u + _e1033)].world_to_object[1u];
                                                let _e1118 = ((((_e1107.x * _e223) + (_e1107.y * _e225)) + (_e1107.z * _e227)) + (_e1107.w * 1f));
                                                let _e1120 = instances.member[(0u + _e1033)].world_to_object[2u];
                                                let _e1131 = ((((_e1120.x * _e223) + (_e1120.y * _e225)) + (_e1120.z * _e227)) + (_e1120.w * 1f));
                                                let _e1134 = instances.member[(0u + _e1033)].world_to_object[0u];
                                                let _e1145 = ((((_e1134.x * _e239) + (_e1134.y * _e240)) + (_e1134.z * _e241)) + (_e1134.w * 0f));
                                                let _e1147 = instances.member[(0u + _e1033)].world_to_object[1u];
                                                let _e1158 = ((((_e1147.x * _e239) + (_e1147.y * _e240)) + (_e1147.z * _e241)) + (_e1147.w * 0f));
                                                let _e1160 = instances.member[(0u + _e1033)].world_to_object[2u];
                                                let _e1171 = ((((_e1160.x * _e239) + (_e1160.y * _e240)) + (_e1160.z * _e241)) + (_e1160.w * 0f));
                                                let _e1174 = instances.member[(0u + _e1033)].root;
                                                let _e1176 = instances.member[(0u + _e1033)].first_triangle;
                                                let _e1180 = abs(_e1145);
                                                let _e1181 = abs(_e1158);
                                                let _e1182 = abs(_e1171);
                                                if (abs(_e1105) < 1000000000000000f) {
                                                    if (abs(_e1118) < 1000000000000000f) {
                                                        if (abs(_e1131) < 1000000000000000f) {
                                                            if (_e1180 < 1000000000000000f) {
                                                                if (_e1181 < 1000000000000000f) {
                                                                    if (_e1182 < 1000000000000000f) {
                                                                        if (_e1180 > 0f) {
                                                                            phi_1782_ = bool();
                                                                            phi_1783_ = true;
                                                                        } else {
                                                                            let _e1190 = (_e1181 > 0f);
                                                                            if _e1190 {
                                                                                phi_1781_ = bool();
                                                                            } else {
                                                                                phi_1781_ = (_e1182 > 0f);
                                                                            }
                                                                            let _e1193 = phi_1781_;
                                                                            phi_1782_ = _e1193;
                                                                            phi_1783_ = _e1190;
                                                                        }
                                                                        let _e1195 = phi_1782_;
                                                                        let _e1197 = phi_1783_;
                                                                        if _e1197 {
                                                                            phi_1787_ = true;
                                                                        } else {
                                                                            phi_1787_ = _e1195;
                                                                        }
                                                                        let _e1199 = phi_1787_;
                                                                        phi_1788_ = _e1199;
                                                                        phi_1789_ = false;
                                                                    } else {
                                                                        phi_1788_ = bool();
                                                                        phi_1789_ = true;
                                                                    }
                                                                    let _e1201 = phi_1788_;
                                                                    let _e1203 = phi_1789_;
                                                                    phi_1790_ = _e1201;
                                                                    phi_1791_ = false;
                                                                    phi_1792_ = _e1203;
                                                                } else {
                                                                    phi_1790_ = bool();
                                                                    phi_1791_ = true;
                                                                    phi_1792_ = false;
                                                                }
                                                                let _e1205 = phi_1790_;
                                                                let _e1207 = phi_1791_;
                                                                let _e1209 = phi_1792_;
                                                                phi_1793_ = _e1205;
                                                                phi_1794_ = _e1207;
                                                                phi_1795_ = _e1209;
                                                            } else {
                                                                phi_1793_ = bool();
                                                                phi_1794_ = true;
                                                                phi_1795_ = false;
                                                            }
                                                            let _e1211 = phi_1793_;
                                                            let _e1213 = phi_1794_;
                                                            let _e1215 = phi_1795_;
                                                            phi_1796_ = _e1211;
                                                            phi_1797_ = _e1213;
                                                            phi_1798_ = _e1215;
                                                        } else {
                                                            phi_1796_ = bool();
                                                            phi_1797_ = true;
                                                            phi_1798_ = false;
                                                        }
                                                        let _e1217 = phi_1796_;
                                                        let _e1219 = phi_1797_;
                                                        let _e1221 = phi_1798_;
                                                        phi_1799_ = _e1217;
                                                        phi_1800_ = _e1219;
                                                        phi_1801_ = _e1221;
                                                    } else {
                                                        phi_1799_ = bool();
                                                        phi_1800_ = true;
                                                        phi_1801_ = false;
                                                    }
                                                    let _e1223 = phi_1799_;
                                                    let _e1225 = phi_1800_;
                                                    let _e1227 = phi_1801_;
                                                    phi_1802_ = _e1223;
                                                    phi_1803_ = _e1225;
                                                    phi_1804_ = _e1227;
                                                } else {
                                                    phi_1802_ = bool();
                                                    phi_1803_ = true;
                                                    phi_1804_ = false;
                                                }
                                                let _e1229 = phi_1802_;
                                                let _e1231 = phi_1803_;
                                                let _e1233 = phi_1804_;
                                                if _e1231 {
                                                    phi_1808_ = true;
                                                } else {
                                                    phi_1808_ = _e1233;
                                                }
                                                let _e1235 = phi_1808_;
                                                if _e1235 {
                                                    phi_1812_ = false;
                                                } else {
                                                    phi_1812_ = _e1229;
                                                }
                                                let _e1237 = phi_1812_;
                                                if _e1237 {
                                                    let _e1238 = (_e1174 >= _e79);
                                                    if _e1238 {
                                                        phi_3392_ = bool();
                                                    } else {
                                                        if (_e1174 < _e79) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1244 = nodes.member[(0u + _e1174)].frame[0u];
                                                        let _e1248 = nodes.member[(0u + _e1174)].frame[1u];
                                                        let _e1252 = nodes.member[(0u + _e1174)].frame[2u];
                                                        let _e1256 = nodes.member[(0u + _e1174)].frame[0u];
                                                        let _e1260 = nodes.member[(0u + _e1174)].frame[1u];
                                                        let _e1264 = nodes.member[(0u + _e1174)].frame[2u];
                                                        let _e1268 = nodes.member[(0u + _e1174)].frame[3u];
                                                        let _e1302 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1145), abs(_e1158));
                                                        let _e1303 = core_intrinsics_maximum_number_nsz_f32_(_e1302, abs(_e1171));
                                                        let _e1304 = (_e1303 * 0.0000000000009094947f);
                                                        if (abs(_e1145) < _e1304) {
                                                            phi_1882_ = _e1304;
                                                        } else {
                                                            phi_1882_ = abs(_e1145);
                                                        }
                                                        let _e1309 = phi_1882_;
                                                        if (_e1145 < 0f) {
                                                            phi_1889_ = (-1f / _e1309);
                                                        } else {
                                                            phi_1889_ = (1f / _e1309);
                                                        }
                                                        let _e1314 = phi_1889_;
                                                        if (abs(_e1158) < _e1304) {
                                                            phi_1896_ = _e1304;
                                                        } else {
                                                            phi_1896_ = abs(_e1158);
                                                        }
                                                        let _e1319 = phi_1896_;
                                                        if (_e1158 < 0f) {
                                                            phi_1903_ = (-1f / _e1319);
                                                        } else {
                                                            phi_1903_ = (1f / _e1319);
                                                        }
                                                        let _e1324 = phi_1903_;
                                                        if (abs(_e1171) < _e1304) {
                                                            phi_1910_ = _e1304;
                                                        } else {
                                                            phi_1910_ = abs(_e1171);
                                                        }
                                                        let _e1329 = phi_1910_;
                                                        if (_e1171 < 0f) {
                                                            phi_1917_ = (-1f / _e1329);
                                                        } else {
                                                            phi_1917_ = (1f / _e1329);
                                                        }
                                                        let _e1334 = phi_1917_;
                                                        let _e1338 = abs((bitcast<f32>(_e1244) - _e1105));
                                                        let _e1339 = abs((bitcast<f32>(_e1248) - _e1118));
                                                        let _e1340 = abs((bitcast<f32>(_e1252) - _e1131));
                                                        let _e1344 = abs(((bitcast<f32>(_e1256) + (bitcast<f32>((((_e1268 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1105));
                                                        let _e1345 = abs(((bitcast<f32>(_e1260) + (bitcast<f32>((((_e1268 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1118));
                                                        let _e1346 = abs(((bitcast<f32>(_e1264) + (bitcast<f32>((((_e1268 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1131));
                                                        if (_e1338 > _e1344) {
                                                            phi_1934_ = _e1338;
                                                        } else {
                                                            phi_1934_ = _e1344;
                                                        }
                                                        let _e1349 = phi_1934_;
                                                        if (_e1339 > _e1345) {
                                                            phi_1939_ = _e1339;
                                                        } else {
                                                            phi_1939_ = _e1345;
                                                        }
                                                        let _e1352 = phi_1939_;
                                                        if (_e1340 > _e1346) {
                                                            phi_1944_ = _e1340;
                                                        } else {
                                                            phi_1944_ = _e1346;
                                                        }
                                                        let _e1355 = phi_1944_;
                                                        let _e1356 = core_intrinsics_maximum_number_nsz_f32_(_e1349, _e1352);
                                                        let _e1357 = core_intrinsics_maximum_number_nsz_f32_(_e1356, _e1355);
                                                        let _e1361 = (_e1357 * 0.0000019073486f);
                                                        let _e1362 = (abs(_e1314) * _e1361);
                                                        let _e1363 = (abs(_e1324) * _e1361);
                                                        let _e1364 = (abs(_e1334) * _e1361);
                                                        let _e1368 = (_e1357 * 0.0000009536743f);
                                                        let _e1369 = (abs(_e1314) * _e1368);
                                                        let _e1370 = (abs(_e1324) * _e1368);
                                                        let _e1371 = (abs(_e1334) * _e1368);
                                                        let _e1372 = abs(_e1145);
                                                        let _e1373 = abs(_e1158);
                                                        let _e1374 = abs(_e1171);
                                                        if (_e1372 >= _e1373) {
                                                            if (_e1372 >= _e1374) {
                                                                phi_1972_ = false;
                                                            } else {
                                                                phi_1972_ = true;
                                                            }
                                                            let _e1378 = phi_1972_;
                                                            phi_1973_ = _e1378;
                                                        } else {
                                                            phi_1973_ = true;
                                                        }
                                                        let _e1380 = phi_1973_;
                                                        if _e1380 {
                                                            if (_e1373 >= _e1374) {
                                                                phi_1981_ = 1u;
                                                            } else {
                                                                phi_1981_ = 2u;
                                                            }
                                                            let _e1383 = phi_1981_;
                                                            phi_1982_ = _e1383;
                                                        } else {
                                                            phi_1982_ = 0u;
                                                        }
                                                        let _e1385 = phi_1982_;
                                                        if (_e1385 == 0u) {
                                                            phi_1994_ = vec3<f32>(_e1158, _e1171, _e1145);
                                                        } else {
                                                            if (_e1385 == 1u) {
                                                                phi_1993_ = vec3<f32>(_e1171, _e1145, _e1158);
                                                            } else {
                                                                phi_1993_ = vec3<f32>(_e1145, _e1158, _e1171);
                                                            }
                                                            let _e1391 = phi_1993_;
                                                            phi_1994_ = _e1391;
                                                        }
                                                        let _e1393 = phi_1994_;
                                                        let _e1396 = (_e1393.x / _e1393.z);
                                                        let _e1399 = (_e1393.y / _e1393.z);
                                                        if (_e1314 < 0f) {
                                                            phi_2007_ = 0u;
                                                        } else {
                                                            phi_2007_ = 1u;
                                                        }
                                                        let _e1404 = phi_2007_;
                                                        if (_e1324 < 0f) {
                                                            phi_2012_ = 0u;
                                                        } else {
                                                            phi_2012_ = 2u;
                                                        }
                                                        let _e1407 = phi_2012_;
                                                        if (_e1334 < 0f) {
                                                            phi_2017_ = 0u;
                                                        } else {
                                                            phi_2017_ = 4u;
                                                        }
                                                        let _e1410 = phi_2017_;
                                                        let _e1412 = ((_e1404 | _e1407) | _e1410);
                                                        let _e1413 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1174, 2147483648u);
                                                        local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e1413.first[0], _e1413.first[1], _e1413.first[2], _e1413.first[3], _e1413.first[4], _e1413.first[5], _e1413.first[6], _e1413.first[7], _e1413.first[8], _e1413.first[9], _e1413.first[10], _e1413.first[11], _e1413.first[12], _e1413.first[13], _e1413.first[14], _e1413.first[15], _e1413.first[16], _e1413.first[17], _e1413.first[18], _e1413.first[19], _e1413.first[20], _e1413.first[21], _e1413.first[22], _e1413.first[23], _e1413.first[24], _e1413.first[25], _e1413.first[26], _e1413.first[27], _e1413.first[28], _e1413.first[29], _e1413.first[30], _e1413.first[31]), array<u32, 32>(_e1413.mask[0], _e1413.mask[1], _e1413.mask[2], _e1413.mask[3], _e1413.mask[4], _e1413.mask[5], _e1413.mask[6], _e1413.mask[7], _e1413.mask[8], _e1413.mask[9], _e1413.mask[10], _e1413.mask[11], _e1413.mask[12], _e1413.mask[13], _e1413.mask[14], _e1413.mask[15], _e1413.mask[16], _e1413.mask[17], _e1413.mask[18], _e1413.mask[19], _e1413.mask[20], _e1413.mask[21], _e1413.mask[22], _e1413.mask[23], _e1413.mask[24], _e1413.mask[25], _e1413.mask[26], _e1413.mask[27], _e1413.mask[28], _e1413.mask[29], _e1413.mask[30], _e1413.mask[31]), _e1413.len, _e1413.group, _e1413.group_mask);
                                                        let _e1487 = local_1.group_mask;
                                                        if ((_e1487 & 4278190080u) == 0u) {
                                                            let _e1491 = local_1.len;
                                                            if (_e1491 == 0u) {
                                                                phi_2131_ = false;
                                                            } else {
                                                                let _e1495 = local_1.len;
                                                                local_1.len = (_e1495 - 1u);
                                                                let _e1498 = local_1.len;
                                                                if (_e1498 < 32u) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1503 = local_1.first[(0u + _e1498)];
                                                                local_1.group = _e1503;
                                                                let _e1506 = local_1.len;
                                                                if (_e1506 < 32u) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1511 = local_1.mask[(0u + _e1506)];
                                                                local_1.group_mask = _e1511;
                                                                phi_2131_ = true;
                                                            }
                                                            let _e1514 = phi_2131_;
                                                            phi_2132_ = _e1514;
                                                        } else {
                                                            phi_2132_ = true;
                                                        }
                                                        let _e1516 = phi_2132_;
                                                        if _e1516 {
                                                            let _e1518 = local_1.group_mask;
                                                            let _e1524 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1518)), 32u, (_e1518 == 0u)));
                                                            let _e1528 = local_1.group_mask;
                                                            let _e1542 = local_1.group_mask;
                                                            local_1.group_mask = (_e1542 & ~((1u << bitcast<u32>((_e1524 & 31u)))));
                                                            let _e1545 = local_1.group;
                                                            phi_2163_ = (_e1545 + countOneBits(((_e1528 & ~((4294967295u << bitcast<u32>((((_e1524 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                        } else {
                                                            phi_2163_ = 4294967295u;
                                                        }
                                                        let _e1548 = phi_2163_;
                                                        phi_2165_ = _e1548;
                                                        phi_2168_ = _e1025;
                                                        loop {
                                                            let _e1550 = phi_2165_;
                                                            let _e1552 = phi_2168_;
                                                            local_18 = _e1552;
                                                            if (_e1550 != 4294967295u) {
                                                                if (_e1550 < _e79) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1559 = nodes.member[(0u + _e1550)].frame[3u];
                                                                let _e1584 = (bitcast<f32>((((_e1559 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1314);
                                                                let _e1585 = (bitcast<f32>((((_e1559 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1324);
                                                                let _e1586 = (bitcast<f32>((((_e1559 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1334);
                                                                let _e1589 = nodes.member[(0u + _e1550)].frame[0u];
                                                                let _e1593 = nodes.member[(0u + _e1550)].frame[1u];
                                                                let _e1597 = nodes.member[(0u + _e1550)].frame[2u];
                                                                let _e1602 = ((bitcast<f32>(_e1589) - _e1105) * _e1314);
                                                                let _e1603 = ((bitcast<f32>(_e1593) - _e1118) * _e1324);
                                                                let _e1604 = ((bitcast<f32>(_e1597) - _e1131) * _e1334);
                                                                let _e1612 = nodes.member[(0u + _e1550)].x;
                                                                if (_e1314 < 0f) {
                                                                    let _e1623 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1612.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1629 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1623.unnamed.root, _e1612.w), _e1623.unnamed_1);
                                                                    let _e1635 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1629.unnamed, lt_bvh_traverse_Tree(_e1612.x, _e1629.unnamed_1.first_primitive));
                                                                    phi_2248_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1635.unnamed, lt_bvh_traverse_Tree(_e1635.unnamed_1.root, _e1612.y));
                                                                } else {
                                                                    let _e1651 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1612.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1657 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1651.unnamed.root, _e1612.y), _e1651.unnamed_1);
                                                                    let _e1663 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1657.unnamed, lt_bvh_traverse_Tree(_e1612.z, _e1657.unnamed_1.first_primitive));
                                                                    phi_2248_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1663.unnamed, lt_bvh_traverse_Tree(_e1663.unnamed_1.root, _e1612.w));
                                                                }
                                                                let _e1671 = phi_2248_;
                                                                let _e1681 = nodes.member[(0u + _e1550)].y;
                                                                if (_e1324 < 0f) {
                                                                    let _e1692 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1681.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1698 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1692.unnamed.root, _e1681.w), _e1692.unnamed_1);
                                                                    let _e1704 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1698.unnamed, lt_bvh_traverse_Tree(_e1681.x, _e1698.unnamed_1.first_primitive));
                                                                    phi_2275_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1704.unnamed, lt_bvh_traverse_Tree(_e1704.unnamed_1.root, _e1681.y));
                                                                } else {
                                                                    let _e1720 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1681.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1726 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1720.unnamed.root, _e1681.y), _e1720.unnamed_1);
                                                                    let _e1732 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1726.unnamed, lt_bvh_traverse_Tree(_e1681.z, _e1726.unnamed_1.first_primitive));
                                                                    phi_2275_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1732.unnamed, lt_bvh_traverse_Tree(_e1732.unnamed_1.root, _e1681.w));
                                                                }
                                                                let _e1740 = phi_2275_;
                                                                let _e1750 = nodes.member[(0u + _e1550)].z;
                                                                if (_e1334 < 0f) {
                                                                    let _e1761 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1750.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1767 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1761.unnamed.root, _e1750.w), _e1761.unnamed_1);
                                                                    let _e1773 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1767.unnamed, lt_bvh_traverse_Tree(_e1750.x, _e1767.unnamed_1.first_primitive));
                                                                    phi_2302_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1773.unnamed, lt_bvh_traverse_Tree(_e1773.unnamed_1.root, _e1750.y));
                                                                } else {
                                                                    let _e1789 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1750.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1795 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1789.unnamed.root, _e1750.y), _e1789.unnamed_1);
                                                                    let _e1801 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1795.unnamed, lt_bvh_traverse_Tree(_e1750.z, _e1795.unnamed_1.first_primitive));
                                                                    phi_2302_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1801.unnamed, lt_bvh_traverse_Tree(_e1801.unnamed_1.root, _e1750.w));
                                                                }
                                                                let _e1809 = phi_2302_;
                                                                phi_2308_ = 0u;
                                                                phi_2311_ = 0u;
                                                                loop {
                                                                    let _e1819 = phi_2308_;
                                                                    let _e1821 = phi_2311_;
                                                                    local_7 = _e1821;
                                                                    local_8 = _e1821;
                                                                    local_9 = _e1821;
                                                                    let _e1822 = (_e1819 < 8u);
                                                                    if _e1822 {
                                                                        let _e1824 = (_e1819 >> bitcast<u32>(2i));
                                                                        let _e1825 = (_e1819 & 3u);
                                                                        if (_e1824 == 0u) {
                                                                            phi_2325_ = _e1671.unnamed.root;
                                                                        } else {
                                                                            phi_2325_ = _e1671.unnamed.first_primitive;
                                                                        }
                                                                        let _e1828 = phi_2325_;
                                                                        if (_e1824 == 0u) {
                                                                            phi_2335_ = _e1740.unnamed.root;
                                                                        } else {
                                                                            phi_2335_ = _e1740.unnamed.first_primitive;
                                                                        }
                                                                        let _e1837 = phi_2335_;
                                                                        if (_e1824 == 0u) {
                                                                            phi_2345_ = _e1809.unnamed.root;
                                                                        } else {
                                                                            phi_2345_ = _e1809.unnamed.first_primitive;
                                                                        }
                                                                        let _e1846 = phi_2345_;
                                                                        let _e1859 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1828 >> bitcast<u32>(((_e1825 * 8u) & 31u))) & 255u)) * _e1584) + (_e1602 - _e1362)), ((f32(((_e1837 >> bitcast<u32>(((_e1825 * 8u) & 31u))) & 255u)) * _e1585) + (_e1603 - _e1363)));
                                                                        let _e1860 = core_intrinsics_maximum_number_nsz_f32_(_e1859, ((f32(((_e1846 >> bitcast<u32>(((_e1825 * 8u) & 31u))) & 255u)) * _e1586) + (_e1604 - _e1364)));
                                                                        if (_e1824 == 0u) {
                                                                            phi_2363_ = _e1671.unnamed_1.root;
                                                                        } else {
                                                                            phi_2363_ = _e1671.unnamed_1.first_primitive;
                                                                        }
                                                                        let _e1863 = phi_2363_;
                                                                        if (_e1824 == 0u) {
                                                                            phi_2373_ = _e1740.unnamed_1.root;
                                                                        } else {
                                                                            phi_2373_ = _e1740.unnamed_1.first_primitive;
                                                                        }
                                                                        let _e1872 = phi_2373_;
                                                                        if (_e1824 == 0u) {
                                                                            phi_2383_ = _e1809.unnamed_1.root;
                                                                        } else {
                                                                            phi_2383_ = _e1809.unnamed_1.first_primitive;
                                                                        }
                                                                        let _e1881 = phi_2383_;
                                                                        let _e1894 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1863 >> bitcast<u32>(((_e1825 * 8u) & 31u))) & 255u)) * _e1584) + (_e1602 + _e1362)), ((f32(((_e1872 >> bitcast<u32>(((_e1825 * 8u) & 31u))) & 255u)) * _e1585) + (_e1603 + _e1363)));
                                                                        let _e1895 = core_intrinsics_minimum_number_nsz_f32_(_e1894, ((f32(((_e1881 >> bitcast<u32>(((_e1825 * 8u) & 31u))) & 255u)) * _e1586) + (_e1604 + _e1364)));
                                                                        if (_e1860 <= _e1895) {
                                                                            if (_e1860 <= _e231) {
                                                                                if (_e1895 >= 0f) {
                                                                                    if (_e1824 == 0u) {
                                                                                        let _e1902 = nodes.member[(0u + _e1550)].links[2u];
                                                                                        phi_2419_ = _e1902;
                                                                                    } else {
                                                                                        let _e1905 = nodes.member[(0u + _e1550)].links[3u];
                                                                                        phi_2419_ = _e1905;
                                                                                    }
                                                                                    let _e1907 = phi_2419_;
                                                                                    let _e1912 = ((_e1907 >> bitcast<u32>(((_e1825 * 8u) & 31u))) & 255u);
                                                                                    let _e1913 = (_e1912 & 31u);
                                                                                    if (_e1913 >= 24u) {
                                                                                        phi_2432_ = (24u + ((_e1913 - 24u) ^ _e1412));
                                                                                    } else {
                                                                                        phi_2432_ = _e1913;
                                                                                    }
                                                                                    let _e1919 = phi_2432_;
                                                                                    phi_2437_ = (_e1821 | ((_e1912 >> bitcast<u32>(5i)) << bitcast<u32>((_e1919 & 31u))));
                                                                                } else {
                                                                                    phi_2437_ = _e1821;
                                                                                }
                                                                                let _e1927 = phi_2437_;
                                                                                phi_2438_ = _e1927;
                                                                            } else {
                                                                                phi_2438_ = _e1821;
                                                                            }
                                                                            let _e1929 = phi_2438_;
                                                                            phi_2439_ = _e1929;
                                                                        } else {
                                                                            phi_2439_ = _e1821;
                                                                        }
                                                                        let _e1931 = phi_2439_;
                                                                        phi_2309_ = (_e1819 + 1u);
                                                                        phi_2312_ = _e1931;
                                                                    } else {
                                                                        phi_2309_ = u32();
                                                                        phi_2312_ = u32();
                                                                    }
                                                                    let _e1934 = phi_2309_;
                                                                    let _e1936 = phi_2312_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_2308_ = _e1934;
                                                                        phi_2311_ = _e1936;
                                                                        break if !(_e1822);
                                                                    }
                                                                }
                                                                let _e1940 = nodes.member[(0u + _e1550)].links[0u];
                                                                let _e1944 = nodes.member[(0u + _e1550)].frame[3u];
                                                                let _e1948 = local_7;
                                                                if ((_e1948 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1952 = local_1.group_mask;
                                                                    if ((_e1952 & 4278190080u) == 0u) {
                                                                    } else {
                                                                        let _e1956 = local_1.len;
                                                                        if (_e1956 < 32u) {
                                                                            let _e1959 = local_1.group;
                                                                            let _e1961 = local_1.len;
                                                                            if (_e1961 < 32u) {
                                                                            } else {
                                                                                return;
                                                                            }
                                                                            local_1.first[(0u + _e1961)] = _e1959;
                                                                            let _e1967 = local_1.group_mask;
                                                                            let _e1969 = local_1.len;
                                                                            if (_e1969 < 32u) {
                                                                            } else {
                                                                                return;
                                                                            }
                                                                            local_1.mask[(0u + _e1969)] = _e1967;
                                                                            let _e1976 = local_1.len;
                                                                            local_1.len = (_e1976 + 1u);
                                                                        }
                                                                    }
                                                                    local_1.group = (_e1174 + _e1940);
                                                                    let _e1980 = local_8;
                                                                    local_1.group_mask = ((_e1980 & 4278190080u) | (_e1944 >> bitcast<u32>(24i)));
                                                                }
                                                                let _e1985 = local_9;
                                                                phi_2497_ = (_e1985 & 16777215u);
                                                                phi_2500_ = _e1552;
                                                                loop {
                                                                    let _e1988 = phi_2497_;
                                                                    let _e1990 = phi_2500_;
                                                                    local_14 = _e1990;
                                                                    let _e1991 = (_e1988 == 0u);
                                                                    local_10 = _e1991;
                                                                    local_16 = _e1991;
                                                                    if _e1991 {
                                                                        phi_2498_ = u32();
                                                                        phi_2501_ = bool();
                                                                        phi_3304_ = bool();
                                                                        phi_3305_ = false;
                                                                    } else {
                                                                        let _e1994 = nodes.member[(0u + _e1550)].links[1u];
                                                                        let _e1999 = ((_e1176 + _e1994) + select(firstTrailingBit(_e1988), 32u, (_e1988 == 0u)));
                                                                        if (_e1999 < _e82) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2006 = triangles.member[(0u + _e1999)].v0_;
                                                                        let _e2008 = (_e2006.x - _e1105);
                                                                        let _e2010 = (_e2006.y - _e1118);
                                                                        let _e2012 = (_e2006.z - _e1131);
                                                                        if (_e1385 == 0u) {
                                                                            phi_2545_ = vec3<f32>(_e2010, _e2012, _e2008);
                                                                        } else {
                                                                            if (_e1385 == 1u) {
                                                                                phi_2544_ = vec3<f32>(_e2012, _e2008, _e2010);
                                                                            } else {
                                                                                phi_2544_ = (_e2006 - vec3<f32>(_e1105, _e1118, _e1131));
                                                                            }
                                                                            let _e2020 = phi_2544_;
                                                                            phi_2545_ = _e2020;
                                                                        }
                                                                        let _e2022 = phi_2545_;
                                                                        let _e2026 = (_e2022.x - (_e1396 * _e2022.z));
                                                                        let _e2030 = (_e2022.y - (_e1399 * _e2022.z));
                                                                        let _e2032 = triangles.member[(0u + _e1999)].v1_;
                                                                        let _e2034 = (_e2032.x - _e1105);
                                                                        let _e2036 = (_e2032.y - _e1118);
                                                                        let _e2038 = (_e2032.z - _e1131);
                                                                        if (_e1385 == 0u) {
                                                                            phi_2575_ = vec3<f32>(_e2036, _e2038, _e2034);
                                                                        } else {
                                                                            if (_e1385 == 1u) {
                                                                                phi_2574_ = vec3<f32>(_e2038, _e2034, _e2036);
                                                                            } else {
                                                                                phi_2574_ = (_e2032 - vec3<f32>(_e1105, _e1118, _e1131));
                                                                            }
                                                                            let _e2046 = phi_2574_;
                                                                            phi_2575_ = _e2046;
                                                                        }
                                                                        let _e2048 = phi_2575_;
                                                                        let _e2052 = (_e2048.x - (_e1396 * _e2048.z));
                                                                        let _e2056 = (_e2048.y - (_e1399 * _e2048.z));
                                                                        let _e2058 = triangles.member[(0u + _e1999)].v2_;
                                                                        let _e2060 = (_e2058.x - _e1105);
                                                                        let _e2062 = (_e2058.y - _e1118);
                                                                        let _e2064 = (_e2058.z - _e1131);
                                                                        if (_e1385 == 0u) {
                                                                            phi_2605_ = vec3<f32>(_e2062, _e2064, _e2060);
                                                                        } else {
                                                                            if (_e1385 == 1u) {
                                                                                phi_2604_ = vec3<f32>(_e2064, _e2060, _e2062);
                                                                            } else {
                                                                                phi_2604_ = (_e2058 - vec3<f32>(_e1105, _e1118, _e1131));
                                                                            }
                                                                            let _e2072 = phi_2604_;
                                                                            phi_2605_ = _e2072;
                                                                        }
                                                                        let _e2074 = phi_2605_;
                                                                        let _e2078 = (_e2074.x - (_e1396 * _e2074.z));
                                                                        let _e2082 = (_e2074.y - (_e1399 * _e2074.z));
                                                                        if (_e2052 < _e2078) {
                                                                            phi_2624_ = true;
                                                                        } else {
                                                                            if (_e2052 == _e2078) {
                                                                                phi_2623_ = (_e2056 < _e2082);
                                                                            } else {
                                                                                phi_2623_ = false;
                                                                            }
                                                                            let _e2087 = phi_2623_;
                                                                            phi_2624_ = _e2087;
                                                                        }
                                                                        let _e2089 = phi_2624_;
                                                                        if _e2089 {
                                                                            phi_2628_ = _e2082;
                                                                            phi_2629_ = _e2078;
                                                                            phi_2630_ = _e2056;
                                                                            phi_2631_ = _e2052;
                                                                        } else {
                                                                            phi_2628_ = _e2056;
                                                                            phi_2629_ = _e2052;
                                                                            phi_2630_ = _e2082;
                                                                            phi_2631_ = _e2078;
                                                                        }
                                                                        let _e2091 = phi_2628_;
                                                                        let _e2093 = phi_2629_;
                                                                        let _e2095 = phi_2630_;
                                                                        let _e2097 = phi_2631_;
                                                                        let _e2100 = ((_e2097 * _e2091) - (_e2095 * _e2093));
                                                                        if _e2089 {
                                                                            phi_2639_ = -(_e2100);
                                                                        } else {
                                                                            phi_2639_ = _e2100;
                                                                        }
                                                                        let _e2103 = phi_2639_;
                                                                        if (_e2078 < _e2026) {
                                                                            phi_2650_ = true;
                                                                        } else {
                                                                            if (_e2078 == _e2026) {
                                                                                phi_2649_ = (_e2082 < _e2030);
                                                                            } else {
                                                                                phi_2649_ = false;
                                                                            }
                                                                            let _e2108 = phi_2649_;
                                                                            phi_2650_ = _e2108;
                                                                        }
                                                                        let _e2110 = phi_2650_;
                                                                        if _e2110 {
                                                                            phi_2654_ = _e2030;
                                                                            phi_2655_ = _e2026;
                                                                            phi_2656_ = _e2082;
                                                                            phi_2657_ = _e2078;
                                                                        } else {
                                                                            phi_2654_ = _e2082;
                                                                            phi_2655_ = _e2078;
                                                                            phi_2656_ = _e2030;
                                                                            phi_2657_ = _e2026;
                                                                        }
                                                                        let _e2112 = phi_2654_;
                                                                        let _e2114 = phi_2655_;
                                                                        let _e2116 = phi_2656_;
                                                                        let _e2118 = phi_2657_;
                                                                        let _e2121 = ((_e2118 * _e2112) - (_e2116 * _e2114));
                                                                        if _e2110 {
                                                                            phi_2665_ = -(_e2121);
                                                                        } else {
                                                                            phi_2665_ = _e2121;
                                                                        }
                                                                        let _e2124 = phi_2665_;
                                                                        if (_e2026 < _e2052) {
                                                                            phi_2676_ = true;
                                                                        } else {
                                                                            if (_e2026 == _e2052) {
                                                                                phi_2675_ = (_e2030 < _e2056);
                                                                            } else {
                                                                                phi_2675_ = false;
                                                                            }
                                                                            let _e2129 = phi_2675_;
                                                                            phi_2676_ = _e2129;
                                                                        }
                                                                        let _e2131 = phi_2676_;
                                                                        if _e2131 {
                                                                            phi_2680_ = _e2056;
                                                                            phi_2681_ = _e2052;
                                                                            phi_2682_ = _e2030;
                                                                            phi_2683_ = _e2026;
                                                                        } else {
                                                                            phi_2680_ = _e2030;
                                                                            phi_2681_ = _e2026;
                                                                            phi_2682_ = _e2056;
                                                                            phi_2683_ = _e2052;
                                                                        }
                                                                        let _e2133 = phi_2680_;
                                                                        let _e2135 = phi_2681_;
                                                                        let _e2137 = phi_2682_;
                                                                        let _e2139 = phi_2683_;
                                                                        let _e2142 = ((_e2139 * _e2133) - (_e2137 * _e2135));
                                                                        if _e2131 {
                                                                            phi_2691_ = -(_e2142);
                                                                        } else {
                                                                            phi_2691_ = _e2142;
                                                                        }
                                                                        let _e2145 = phi_2691_;
                                                                        if (_e2103 >= 0f) {
                                                                            if (_e2124 >= 0f) {
                                                                                if (_e2145 >= 0f) {
                                                                                    phi_2706_ = ((_e2103 + _e2124) + _e2145);
                                                                                    phi_2707_ = false;
                                                                                } else {
                                                                                    phi_2706_ = f32();
                                                                                    phi_2707_ = true;
                                                                                }
                                                                                let _e2152 = phi_2706_;
                                                                                let _e2154 = phi_2707_;
                                                                                phi_2708_ = _e2152;
                                                                                phi_2709_ = _e2154;
                                                                            } else {
                                                                                phi_2708_ = f32();
                                                                                phi_2709_ = true;
                                                                            }
                                                                            let _e2156 = phi_2708_;
                                                                            let _e2158 = phi_2709_;
                                                                            phi_2710_ = _e2156;
                                                                            phi_2711_ = _e2158;
                                                                        } else {
                                                                            phi_2710_ = f32();
                                                                            phi_2711_ = true;
                                                                        }
                                                                        let _e2160 = phi_2710_;
                                                                        let _e2162 = phi_2711_;
                                                                        if _e2162 {
                                                                            if (_e2103 <= 0f) {
                                                                                if (_e2124 <= 0f) {
                                                                                    let _e2165 = (_e2145 <= 0f);
                                                                                    if _e2165 {
                                                                                    }
                                                                                    phi_2729_ = ((_e2103 + _e2124) + _e2145);
                                                                                    phi_2730_ = false;
                                                                                    phi_2731_ = _e2165;
                                                                                } else {
                                                                                    phi_2729_ = f32();
                                                                                    phi_2730_ = true;
                                                                                    phi_2731_ = false;
                                                                                }
                                                                                let _e2169 = phi_2729_;
                                                                                let _e2171 = phi_2730_;
                                                                                let _e2173 = phi_2731_;
                                                                                phi_2732_ = _e2169;
                                                                                phi_2733_ = _e2171;
                                                                                phi_2734_ = _e2173;
                                                                            } else {
                                                                                phi_2732_ = f32();
                                                                                phi_2733_ = true;
                                                                                phi_2734_ = false;
                                                                            }
                                                                            let _e2175 = phi_2732_;
                                                                            let _e2177 = phi_2733_;
                                                                            let _e2179 = phi_2734_;
                                                                            if _e2177 {
                                                                                phi_2738_ = false;
                                                                            } else {
                                                                                phi_2738_ = _e2179;
                                                                            }
                                                                            let _e2181 = phi_2738_;
                                                                            phi_2739_ = _e2175;
                                                                            phi_2740_ = _e2181;
                                                                        } else {
                                                                            phi_2739_ = _e2160;
                                                                            phi_2740_ = true;
                                                                        }
                                                                        let _e2183 = phi_2739_;
                                                                        let _e2185 = phi_2740_;
                                                                        if _e2185 {
                                                                            let _e2186 = (_e2183 == 0f);
                                                                            if _e2186 {
                                                                                phi_3056_ = lt_bvh_triangle_Intersection();
                                                                                phi_3057_ = false;
                                                                            } else {
                                                                                let _e2188 = triangles.member[(0u + _e1999)].v0_;
                                                                                let _e2190 = (_e2188.x - _e1105);
                                                                                let _e2192 = (_e2188.y - _e1118);
                                                                                let _e2194 = (_e2188.z - _e1131);
                                                                                if (_e1385 == 0u) {
                                                                                    phi_2769_ = vec3<f32>(_e2192, _e2194, _e2190);
                                                                                } else {
                                                                                    if (_e1385 == 1u) {
                                                                                        phi_2768_ = vec3<f32>(_e2194, _e2190, _e2192);
                                                                                    } else {
                                                                                        phi_2768_ = (_e2188 - vec3<f32>(_e1105, _e1118, _e1131));
                                                                                    }
                                                                                    let _e2202 = phi_2768_;
                                                                                    phi_2769_ = _e2202;
                                                                                }
                                                                                let _e2204 = phi_2769_;
                                                                                let _e2206 = triangles.member[(0u + _e1999)].v1_;
                                                                                let _e2208 = triangles.member[(0u + _e1999)].v0_;
                                                                                let _e2211 = (_e2206.x - _e2208.x);
                                                                                let _e2214 = (_e2206.y - _e2208.y);
                                                                                let _e2217 = (_e2206.z - _e2208.z);
                                                                                if (_e1385 == 0u) {
                                                                                    phi_2795_ = vec3<f32>(_e2214, _e2217, _e2211);
                                                                                } else {
                                                                                    if (_e1385 == 1u) {
                                                                                        phi_2794_ = vec3<f32>(_e2217, _e2211, _e2214);
                                                                                    } else {
                                                                                        phi_2794_ = (_e2206 - _e2208);
                                                                                    }
                                                                                    let _e2224 = phi_2794_;
                                                                                    phi_2795_ = _e2224;
                                                                                }
                                                                                let _e2226 = phi_2795_;
                                                                                let _e2228 = triangles.member[(0u + _e1999)].v2_;
                                                                                let _e2230 = triangles.member[(0u + _e1999)].v0_;
                                                                                let _e2233 = (_e2228.x - _e2230.x);
                                                                                let _e2236 = (_e2228.y - _e2230.y);
                                                                                let _e2239 = (_e2228.z - _e2230.z);
                                                                                if (_e1385 == 0u) {
                                                                                    phi_2821_ = vec3<f32>(_e2236, _e2239, _e2233);
                                                                                } else {
                                                                                    if (_e1385 == 1u) {
                                                                                        phi_2820_ = vec3<f32>(_e2239, _e2233, _e2236);
                                                                                    } else {
                                                                                        phi_2820_ = (_e2228 - _e2230);
                                                                                    }
                                                                                    let _e2246 = phi_2820_;
                                                                                    phi_2821_ = _e2246;
                                                                                }
                                                                                let _e2248 = phi_2821_;
                                                                                let _e2255 = ((_e2226.y * _e2248.z) - (_e2226.z * _e2248.y));
                                                                                let _e2262 = ((_e2226.z * _e2248.x) - (_e2226.x * _e2248.z));
                                                                                let _e2269 = ((_e2226.x * _e2248.y) - (_e2226.y * _e2248.x));
                                                                                let _e2283 = (((1f / _e1393.z) * (((_e2255 * _e2204.x) + (_e2262 * _e2204.y)) + (_e2269 * _e2204.z))) / (((_e2255 * _e1396) + (_e2262 * _e1399)) + _e2269));
                                                                                if (_e2283 > 0f) {
                                                                                    if (_e2283 < _e231) {
                                                                                        let _e2287 = triangles.member[(0u + _e1999)].v0_;
                                                                                        let _e2289 = triangles.member[(0u + _e1999)].v1_;
                                                                                        if (_e2287.x < _e2289.x) {
                                                                                            phi_2877_ = _e2287.x;
                                                                                        } else {
                                                                                            phi_2877_ = _e2289.x;
                                                                                        }
                                                                                        let _e2296 = phi_2877_;
                                                                                        if (_e2287.y < _e2289.y) {
                                                                                            phi_2886_ = _e2287.y;
                                                                                        } else {
                                                                                            phi_2886_ = _e2289.y;
                                                                                        }
                                                                                        let _e2303 = phi_2886_;
                                                                                        if (_e2287.z < _e2289.z) {
                                                                                            phi_2895_ = _e2287.z;
                                                                                        } else {
                                                                                            phi_2895_ = _e2289.z;
                                                                                        }
                                                                                        let _e2310 = phi_2895_;
                                                                                        let _e2312 = triangles.member[(0u + _e1999)].v2_;
                                                                                        if (_e2296 < _e2312.x) {
                                                                                            phi_2904_ = _e2296;
                                                                                        } else {
                                                                                            phi_2904_ = _e2312.x;
                                                                                        }
                                                                                        let _e2317 = phi_2904_;
                                                                                        if (_e2303 < _e2312.y) {
                                                                                            phi_2911_ = _e2303;
                                                                                        } else {
                                                                                            phi_2911_ = _e2312.y;
                                                                                        }
                                                                                        let _e2322 = phi_2911_;
                                                                                        if (_e2310 < _e2312.z) {
                                                                                            phi_2918_ = _e2310;
                                                                                        } else {
                                                                                            phi_2918_ = _e2312.z;
                                                                                        }
                                                                                        let _e2327 = phi_2918_;
                                                                                        let _e2329 = triangles.member[(0u + _e1999)].v0_;
                                                                                        let _e2331 = triangles.member[(0u + _e1999)].v1_;
                                                                                        if (_e2329.x > _e2331.x) {
                                                                                            phi_2931_ = _e2329.x;
                                                                                        } else {
                                                                                            phi_2931_ = _e2331.x;
                                                                                        }
                                                                                        let _e2338 = phi_2931_;
                                                                                        if (_e2329.y > _e2331.y) {
                                                                                            phi_2940_ = _e2329.y;
                                                                                        } else {
                                                                                            phi_2940_ = _e2331.y;
                                                                                        }
                                                                                        let _e2345 = phi_2940_;
                                                                                        if (_e2329.z > _e2331.z) {
                                                                                            phi_2949_ = _e2329.z;
                                                                                        } else {
                                                                                            phi_2949_ = _e2331.z;
                                                                                        }
                                                                                        let _e2352 = phi_2949_;
                                                                                        let _e2354 = triangles.member[(0u + _e1999)].v2_;
                                                                                        if (_e2338 > _e2354.x) {
                                                                                            phi_2958_ = _e2338;
                                                                                        } else {
                                                                                            phi_2958_ = _e2354.x;
                                                                                        }
                                                                                        let _e2359 = phi_2958_;
                                                                                        if (_e2345 > _e2354.y) {
                                                                                            phi_2965_ = _e2345;
                                                                                        } else {
                                                                                            phi_2965_ = _e2354.y;
                                                                                        }
                                                                                        let _e2364 = phi_2965_;
                                                                                        if (_e2352 > _e2354.z) {
                                                                                            phi_2972_ = _e2352;
                                                                                        } else {
                                                                                            phi_2972_ = _e2354.z;
                                                                                        }
                                                                                        let _e2369 = phi_2972_;
                                                                                        let _e2373 = ((_e2317 - _e1105) * _e1314);
                                                                                        let _e2374 = ((_e2322 - _e1118) * _e1324);
                                                                                        let _e2375 = ((_e2327 - _e1131) * _e1334);
                                                                                        let _e2379 = ((_e2359 - _e1105) * _e1314);
                                                                                        let _e2380 = ((_e2364 - _e1118) * _e1324);
                                                                                        let _e2381 = ((_e2369 - _e1131) * _e1334);
                                                                                        if (_e2373 < _e2379) {
                                                                                            phi_2989_ = _e2373;
                                                                                        } else {
                                                                                            phi_2989_ = _e2379;
                                                                                        }
                                                                                        let _e2384 = phi_2989_;
                                                                                        if (_e2374 < _e2380) {
                                                                                            phi_2994_ = _e2374;
                                                                                        } else {
                                                                                            phi_2994_ = _e2380;
                                                                                        }
                                                                                        let _e2387 = phi_2994_;
                                                                                        if (_e2375 < _e2381) {
                                                                                            phi_2999_ = _e2375;
                                                                                        } else {
                                                                                            phi_2999_ = _e2381;
                                                                                        }
                                                                                        let _e2390 = phi_2999_;
                                                                                        if (_e2373 > _e2379) {
                                                                                            phi_3007_ = _e2373;
                                                                                        } else {
                                                                                            phi_3007_ = _e2379;
                                                                                        }
                                                                                        let _e2396 = phi_3007_;
                                                                                        if (_e2374 > _e2380) {
                                                                                            phi_3012_ = _e2374;
                                                                                        } else {
                                                                                            phi_3012_ = _e2380;
                                                                                        }
                                                                                        let _e2399 = phi_3012_;
                                                                                        if (_e2375 > _e2381) {
                                                                                            phi_3017_ = _e2375;
                                                                                        } else {
                                                                                            phi_3017_ = _e2381;
                                                                                        }
                                                                                        let _e2402 = phi_3017_;
                                                                                        let _e2406 = core_intrinsics_maximum_number_nsz_f32_((_e2384 - _e1369), (_e2387 - _e1370));
                                                                                        let _e2407 = core_intrinsics_maximum_number_nsz_f32_(_e2406, (_e2390 - _e1371));
                                                                                        let _e2408 = core_intrinsics_minimum_number_nsz_f32_((_e2396 + _e1369), (_e2399 + _e1370));
                                                                                        let _e2409 = core_intrinsics_minimum_number_nsz_f32_(_e2408, (_e2402 + _e1371));
                                                                                        if (_e2407 > _e1086) {
                                                                                            phi_3029_ = _e2407;
                                                                                        } else {
                                                                                            phi_3029_ = _e1086;
                                                                                        }
                                                                                        let _e2412 = phi_3029_;
                                                                                        if (_e2409 < _e1088) {
                                                                                            phi_3034_ = _e2409;
                                                                                        } else {
                                                                                            phi_3034_ = _e1088;
                                                                                        }
                                                                                        let _e2415 = phi_3034_;
                                                                                        if (_e2283 < _e2412) {
                                                                                            phi_3039_ = _e2412;
                                                                                        } else {
                                                                                            phi_3039_ = _e2283;
                                                                                        }
                                                                                        let _e2418 = phi_3039_;
                                                                                        if (_e2418 > _e2415) {
                                                                                            phi_3044_ = _e2415;
                                                                                        } else {
                                                                                            phi_3044_ = _e2418;
                                                                                        }
                                                                                        let _e2421 = phi_3044_;
                                                                                        phi_3049_ = lt_bvh_triangle_Intersection(_e2421, (_e2124 / _e2183), (_e2145 / _e2183), (_e2412 <= _e2415));
                                                                                        phi_3050_ = false;
                                                                                    } else {
                                                                                        phi_3049_ = lt_bvh_triangle_Intersection();
                                                                                        phi_3050_ = true;
                                                                                    }
                                                                                    let _e2427 = phi_3049_;
                                                                                    let _e2429 = phi_3050_;
                                                                                    phi_3051_ = _e2427;
                                                                                    phi_3052_ = _e2429;
                                                                                } else {
                                                                                    phi_3051_ = lt_bvh_triangle_Intersection();
                                                                                    phi_3052_ = true;
                                                                                }
                                                                                let _e2431 = phi_3051_;
                                                                                let _e2433 = phi_3052_;
                                                                                if _e2433 {
                                                                                }
                                                                                phi_3056_ = _e2431;
                                                                                phi_3057_ = _e2433;
                                                                            }
                                                                            let _e2435 = phi_3056_;
                                                                            let _e2437 = phi_3057_;
                                                                            phi_3058_ = _e2435;
                                                                            phi_3059_ = _e2186;
                                                                            phi_3060_ = _e2437;
                                                                        } else {
                                                                            phi_3058_ = lt_bvh_triangle_Intersection();
                                                                            phi_3059_ = true;
                                                                            phi_3060_ = false;
                                                                        }
                                                                        let _e2439 = phi_3058_;
                                                                        let _e2441 = phi_3059_;
                                                                        let _e2443 = phi_3060_;
                                                                        if _e2441 {
                                                                            phi_3064_ = true;
                                                                        } else {
                                                                            phi_3064_ = _e2443;
                                                                        }
                                                                        let _e2445 = phi_3064_;
                                                                        if _e2445 {
                                                                            phi_3068_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                        } else {
                                                                            phi_3068_ = _e2439;
                                                                        }
                                                                        let _e2447 = phi_3068_;
                                                                        if _e2447.is_hit {
                                                                            if (_e2447.t > 0f) {
                                                                                if (_e2447.t < _e231) {
                                                                                    let _e2454 = triangles.member[(0u + _e1999)].i0_;
                                                                                    if ((_e2454 & 2147483648u) == 0u) {
                                                                                        phi_3287_ = true;
                                                                                    } else {
                                                                                        if (_e1999 < _e82) {
                                                                                        } else {
                                                                                            return;
                                                                                        }
                                                                                        let _e2463 = triangles.member[(0u + _e1999)].i0_;
                                                                                        let _e2464 = (_e2463 & 2147483647u);
                                                                                        let _e2466 = triangles.member[(0u + _e1999)].i1_;
                                                                                        let _e2468 = triangles.member[(0u + _e1999)].i2_;
                                                                                        if (_e2464 < _e91) {
                                                                                        } else {
                                                                                            return;
                                                                                        }
                                                                                        let _e2472 = vertices.member[(0u + _e2464)];
                                                                                        if (_e2466 < _e91) {
                                                                                        } else {
                                                                                            return;
                                                                                        }
                                                                                        let _e2476 = vertices.member[(0u + _e2466)];
                                                                                        if (_e2468 < _e91) {
                                                                                        } else {
                                                                                            return;
                                                                                        }
                                                                                        let _e2480 = vertices.member[(0u + _e2468)];
                                                                                        let _e2481 = array<abi_Vertex, 3>(_e2472, _e2476, _e2480);
                                                                                        if (_e2481[0].material < arrayLength((&materials.member))) {
                                                                                        } else {
                                                                                            return;
                                                                                        }
                                                                                        let _e2487 = materials.member[(0u + _e2481[0].material)];
                                                                                        if ((_e2487.flags & 1u) == 1u) {
                                                                                            let _e2492 = ((1f - _e2447.u) - _e2447.v);
                                                                                            if (_e2487.cutoff <= 0f) {
                                                                                                phi_3285_ = true;
                                                                                            } else {
                                                                                                let _e2519 = (_e2487.base_color.w * ((((f32((_e2481[0].color >> bitcast<u32>(24i))) * _e2492) + (f32((_e2481[1].color >> bitcast<u32>(24i))) * _e2447.u)) + (f32((_e2481[2].color >> bitcast<u32>(24i))) * _e2447.v)) * (1f / 255f)));
                                                                                                if (_e2487.alpha_size == 0u) {
                                                                                                    phi_3282_ = _e2519;
                                                                                                } else {
                                                                                                    local.offset = _e2487.alpha_offset;
                                                                                                    local.size = _e2487.alpha_size;
                                                                                                    local.flags = _e2487.flags;
                                                                                                    let _e2550 = _lt_shaders_texture_TextureView_quad((&local), (((_e2481[0].u * _e2492) + (_e2481[1].u * _e2447.u)) + (_e2481[2].u * _e2447.v)), (((_e2481[0].v * _e2492) + (_e2481[1].v * _e2447.u)) + (_e2481[2].v * _e2447.v)));
                                                                                                    let _e2554 = (_e2550.indices[0] >> bitcast<u32>(2i));
                                                                                                    if (_e2554 < _e97) {
                                                                                                    } else {
                                                                                                        return;
                                                                                                    }
                                                                                                    let _e2558 = alpha_texels.member[(0u + _e2554)];
                                                                                                    let _e2574 = (_e2550.indices[1] >> bitcast<u32>(2i));
                                                                                                    if (_e2574 < _e97) {
                                                                                                    } else {
                                                                                                        return;
                                                                                                    }
                                                                                                    let _e2578 = alpha_texels.member[(0u + _e2574)];
                                                                                                    let _e2595 = (_e2550.indices[2] >> bitcast<u32>(2i));
                                                                                                    if (_e2595 < _e97) {
                                                                                                    } else {
                                                                                                        return;
                                                                                                    }
                                                                                                    let _e2599 = alpha_texels.member[(0u + _e2595)];
                                                                                                    let _e2616 = (_e2550.indices[3] >> bitcast<u32>(2i));
                                                                                                    if (_e2616 < _e97) {
                                                                                                    } else {
                                                                                                        return;
                                                                                                    }
                                                                                                    let _e2620 = alpha_texels.member[(0u + _e2616)];
                                                                                                    phi_3282_ = (_e2519 * (((((f32(((_e2558 >> bitcast<u32>((((_e2550.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2550.weights.x) + ((f32(((_e2578 >> bitcast<u32>((((_e2550.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2550.weights.y)) + ((f32(((_e2599 >> bitcast<u32>((((_e2550.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2550.weights.z)) + ((f32(((_e2620 >> bitcast<u32>((((_e2550.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2550.weights.w)));
                                                                                                }
                                                                                                let _e2636 = phi_3282_;
                                                                                                phi_3285_ = (_e2636 >= _e2487.cutoff);
                                                                                            }
                                                                                            let _e2640 = phi_3285_;
                                                                                            phi_3286_ = _e2640;
                                                                                        } else {
                                                                                            phi_3286_ = false;
                                                                                        }
                                                                                        let _e2642 = phi_3286_;
                                                                                        phi_3287_ = _e2642;
                                                                                    }
                                                                                    let _e2644 = phi_3287_;
                                                                                    if _e2644 {
                                                                                        phi_3291_ = false;
                                                                                    } else {
                                                                                        phi_3291_ = true;
                                                                                    }
                                                                                    let _e2646 = phi_3291_;
                                                                                    phi_3292_ = _e2644;
                                                                                    phi_3293_ = _e2644;
                                                                                    phi_3294_ = _e2646;
                                                                                } else {
                                                                                    phi_3292_ = bool();
                                                                                    phi_3293_ = _e1990;
                                                                                    phi_3294_ = true;
                                                                                }
                                                                                let _e2648 = phi_3292_;
                                                                                let _e2650 = phi_3293_;
                                                                                let _e2652 = phi_3294_;
                                                                                phi_3295_ = _e2648;
                                                                                phi_3296_ = _e2650;
                                                                                phi_3297_ = _e2652;
                                                                            } else {
                                                                                phi_3295_ = bool();
                                                                                phi_3296_ = _e1990;
                                                                                phi_3297_ = true;
                                                                            }
                                                                            let _e2654 = phi_3295_;
                                                                            let _e2656 = phi_3296_;
                                                                            let _e2658 = phi_3297_;
                                                                            phi_3298_ = _e2654;
                                                                            phi_3299_ = _e2656;
                                                                            phi_3300_ = _e2658;
                                                                        } else {
                                                                            phi_3298_ = bool();
                                                                            phi_3299_ = _e1990;
                                                                            phi_3300_ = true;
                                                                        }
                                                                        let _e2660 = phi_3298_;
                                                                        let _e2662 = phi_3299_;
                                                                        let _e2664 = phi_3300_;
                                                                        if _e2664 {
                                                                        }
                                                                        phi_2498_ = (_e1988 & (_e1988 - 1u));
                                                                        phi_2501_ = _e2662;
                                                                        phi_3304_ = _e2660;
                                                                        phi_3305_ = _e2664;
                                                                    }
                                                                    let _e2666 = phi_2498_;
                                                                    let _e2668 = phi_2501_;
                                                                    let _e2670 = phi_3304_;
                                                                    let _e2672 = phi_3305_;
                                                                    local_15 = _e2670;
                                                                    continue;
                                                                    continuing {
                                                                        phi_2497_ = _e2666;
                                                                        phi_2500_ = _e2668;
                                                                        break if !(_e2672);
                                                                    }
                                                                }
                                                                let _e2675 = local_10;
                                                                if _e2675 {
                                                                    let _e2677 = local_1.group_mask;
                                                                    if ((_e2677 & 4278190080u) == 0u) {
                                                                        let _e2681 = local_1.len;
                                                                        if (_e2681 == 0u) {
                                                                            phi_3347_ = false;
                                                                        } else {
                                                                            let _e2685 = local_1.len;
                                                                            local_1.len = (_e2685 - 1u);
                                                                            let _e2688 = local_1.len;
                                                                            if (_e2688 < 32u) {
                                                                            } else {
                                                                                return;
                                                                            }
                                                                            let _e2693 = local_1.first[(0u + _e2688)];
                                                                            local_1.group = _e2693;
                                                                            let _e2696 = local_1.len;
                                                                            if (_e2696 < 32u) {
                                                                            } else {
                                                                                return;
                                                                            }
                                                                            let _e2701 = local_1.mask[(0u + _e2696)];
                                                                            local_1.group_mask = _e2701;
                                                                            phi_3347_ = true;
                                                                        }
                                                                        let _e2704 = phi_3347_;
                                                                        phi_3348_ = _e2704;
                                                                    } else {
                                                                        phi_3348_ = true;
                                                                    }
                                                                    let _e2706 = phi_3348_;
                                                                    if _e2706 {
                                                                        let _e2708 = local_1.group_mask;
                                                                        let _e2714 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2708)), 32u, (_e2708 == 0u)));
                                                                        let _e2718 = local_1.group_mask;
                                                                        let _e2732 = local_1.group_mask;
                                                                        local_1.group_mask = (_e2732 & ~((1u << bitcast<u32>((_e2714 & 31u)))));
                                                                        let _e2735 = local_1.group;
                                                                        phi_3379_ = (_e2735 + countOneBits(((_e2718 & ~((4294967295u << bitcast<u32>((((_e2714 - 24u) ^ _e1412) & 31u))))) & 255u)));
                                                                    } else {
                                                                        phi_3379_ = 4294967295u;
                                                                    }
                                                                    let _e2738 = phi_3379_;
                                                                    phi_3380_ = _e2738;
                                                                } else {
                                                                    phi_3380_ = u32();
                                                                }
                                                                let _e2740 = phi_3380_;
                                                                phi_2166_ = _e2740;
                                                                let _e3134 = local_14;
                                                                phi_2169_ = _e3134;
                                                                let _e3137 = local_15;
                                                                phi_3381_ = _e3137;
                                                                let _e3140 = local_16;
                                                                phi_3382_ = _e3140;
                                                                phi_3383_ = false;
                                                            } else {
                                                                phi_2166_ = u32();
                                                                phi_2169_ = bool();
                                                                phi_3381_ = bool();
                                                                phi_3382_ = false;
                                                                phi_3383_ = true;
                                                            }
                                                            let _e2742 = phi_2166_;
                                                            let _e2744 = phi_2169_;
                                                            let _e2746 = phi_3381_;
                                                            let _e2748 = phi_3382_;
                                                            let _e2750 = phi_3383_;
                                                            local_11 = _e2750;
                                                            local_17 = _e2746;
                                                            continue;
                                                            continuing {
                                                                phi_2165_ = _e2742;
                                                                phi_2168_ = _e2744;
                                                                break if !(_e2748);
                                                            }
                                                        }
                                                        let _e2753 = local_11;
                                                        if _e2753 {
                                                            phi_3387_ = false;
                                                        } else {
                                                            phi_3387_ = true;
                                                        }
                                                        let _e2755 = phi_3387_;
                                                        if _e2755 {
                                                            let _e3146 = local_17;
                                                            phi_3391_ = _e3146;
                                                        } else {
                                                            let _e3148 = local_18;
                                                            phi_3391_ = _e3148;
                                                        }
                                                        let _e2757 = phi_3391_;
                                                        phi_3392_ = _e2757;
                                                    }
                                                    let _e2759 = phi_3392_;
                                                    phi_3393_ = _e2759;
                                                    phi_3394_ = _e1238;
                                                } else {
                                                    phi_3393_ = bool();
                                                    phi_3394_ = true;
                                                }
                                                let _e2761 = phi_3393_;
                                                let _e2763 = phi_3394_;
                                                if _e2763 {
                                                    phi_3398_ = _e1025;
                                                } else {
                                                    phi_3398_ = _e2761;
                                                }
                                                let _e2765 = phi_3398_;
                                                if _e2765 {
                                                    phi_3402_ = false;
                                                } else {
                                                    phi_3402_ = true;
                                                }
                                                let _e2767 = phi_3402_;
                                                phi_3403_ = _e2765;
                                                phi_3404_ = _e2767;
                                            } else {
                                                phi_3403_ = _e1025;
                                                phi_3404_ = true;
                                            }
                                            let _e2769 = phi_3403_;
                                            let _e2771 = phi_3404_;
                                            phi_3405_ = _e2769;
                                            phi_3406_ = _e2771;
                                        } else {
                                            phi_3405_ = _e1025;
                                            phi_3406_ = true;
                                        }
                                        let _e2773 = phi_3405_;
                                        let _e2775 = phi_3406_;
                                        phi_3407_ = _e2773;
                                        phi_3408_ = _e2775;
                                    } else {
                                        phi_3407_ = _e1025;
                                        phi_3408_ = true;
                                    }
                                    let _e2777 = phi_3407_;
                                    let _e2779 = phi_3408_;
                                    if _e2779 {
                                    }
                                    phi_1558_ = (_e1023 & (_e1023 - 1u));
                                    phi_1561_ = _e2777;
                                    phi_3412_ = _e2779;
                                }
                                let _e2781 = phi_1558_;
                                let _e2783 = phi_1561_;
                                let _e2785 = phi_3412_;
                                continue;
                                continuing {
                                    phi_1557_ = _e2781;
                                    phi_1560_ = _e2783;
                                    break if !(_e2785);
                                }
                            }
                            let _e2788 = local_12;
                            if _e2788 {
                                let _e2790 = local_2.group_mask;
                                if ((_e2790 & 4278190080u) == 0u) {
                                    let _e2794 = local_2.len;
                                    if (_e2794 == 0u) {
                                        phi_3454_ = false;
                                    } else {
                                        let _e2798 = local_2.len;
                                        local_2.len = (_e2798 - 1u);
                                        let _e2801 = local_2.len;
                                        if (_e2801 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e2806 = local_2.first[(0u + _e2801)];
                                        local_2.group = _e2806;
                                        let _e2809 = local_2.len;
                                        if (_e2809 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e2814 = local_2.mask[(0u + _e2809)];
                                        local_2.group_mask = _e2814;
                                        phi_3454_ = true;
                                    }
                                    let _e2817 = phi_3454_;
                                    phi_3455_ = _e2817;
                                } else {
                                    phi_3455_ = true;
                                }
                                let _e2819 = phi_3455_;
                                if _e2819 {
                                    let _e2821 = local_2.group_mask;
                                    let _e2827 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2821)), 32u, (_e2821 == 0u)));
                                    let _e2831 = local_2.group_mask;
                                    let _e2845 = local_2.group_mask;
                                    local_2.group_mask = (_e2845 & ~((1u << bitcast<u32>((_e2827 & 31u)))));
                                    let _e2848 = local_2.group;
                                    phi_3486_ = (_e2848 + countOneBits(((_e2831 & ~((4294967295u << bitcast<u32>((((_e2827 - 24u) ^ _e447) & 31u))))) & 255u)));
                                } else {
                                    phi_3486_ = 4294967295u;
                                }
                                let _e2851 = phi_3486_;
                                phi_3487_ = _e2851;
                            } else {
                                phi_3487_ = u32();
                            }
                            let _e2853 = phi_3487_;
                            phi_1226_ = _e2853;
                            let _e3171 = local_19;
                            phi_1229_ = _e3171;
                            let _e3174 = local_20;
                            phi_3488_ = _e3174;
                            phi_3489_ = false;
                        } else {
                            phi_1226_ = u32();
                            phi_1229_ = bool();
                            phi_3488_ = false;
                            phi_3489_ = true;
                        }
                        let _e2855 = phi_1226_;
                        let _e2857 = phi_1229_;
                        let _e2859 = phi_3488_;
                        let _e2861 = phi_3489_;
                        local_13 = _e2861;
                        continue;
                        continuing {
                            phi_1225_ = _e2855;
                            phi_1228_ = _e2857;
                            break if !(_e2859);
                        }
                    }
                    let _e2864 = local_13;
                    if _e2864 {
                        phi_3493_ = false;
                    } else {
                        phi_3493_ = true;
                    }
                    let _e2866 = phi_3493_;
                    if _e2866 {
                    }
                    phi_3497_ = _e2866;
                }
                let _e2868 = phi_3497_;
                phi_3498_ = _e303;
                phi_3499_ = _e2868;
            } else {
                phi_3498_ = true;
                phi_3499_ = false;
            }
            let _e2870 = phi_3498_;
            let _e2872 = phi_3499_;
            if _e2870 {
                phi_3503_ = false;
                phi_3504_ = true;
            } else {
                phi_3503_ = true;
                phi_3504_ = _e2872;
            }
            let _e2874 = phi_3503_;
            let _e2876 = phi_3504_;
            if _e2876 {
                phi_3508_ = _e2874;
            } else {
                phi_3508_ = false;
            }
            let _e2878 = phi_3508_;
            if _e2878 {
                phi_3512_ = 0f;
            } else {
                phi_3512_ = 1f;
            }
            let _e2880 = phi_3512_;
            phi_3513_ = _e2880;
        }
        let _e2882 = phi_3513_;
        if (_e103.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e103.first_primitive)] = _e2882;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_resolve_resolve_all_instanced_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
