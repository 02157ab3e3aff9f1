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

struct type_34 {
    member: abi_ShadowParams,
}

struct lt_bvh_Node {
    frame: vec4<u32>,
    links: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    z: vec4<u32>,
}

struct type_39 {
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

struct type_43 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_47 {
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

struct type_51 {
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

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_17;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_34;
@group(0) @binding(2) 
var<storage> nodes: type_39;
@group(0) @binding(3) 
var<storage> triangles: type_43;
@group(0) @binding(7) 
var<storage> alpha_texels: type_13;
@group(0) @binding(5) 
var<storage> vertices: type_47;
@group(0) @binding(6) 
var<storage> materials: type_51;

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
        let _e81 = phi_217_;
        let _e83 = phi_218_;
        phi_219_ = _e81;
        phi_220_ = _e83;
    } else {
        phi_219_ = lt_bvh_traverse_Tree();
        phi_220_ = true;
    }
    let _e85 = phi_219_;
    let _e87 = phi_220_;
    if _e87 {
        phi_225_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_225_ = _e85;
    }
    let _e92 = phi_225_;
    return lt_bvh_traverse_Tree(_e92.root, _e92.first_primitive);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_240_: bool;
    var phi_244_: f32;

    if (param_3 != param_3) {
        phi_240_ = true;
    } else {
        let _e71 = (param_4 >= param_3);
        if _e71 {
        }
        phi_240_ = _e71;
    }
    let _e73 = phi_240_;
    if _e73 {
        phi_244_ = param_4;
    } else {
        phi_244_ = param_3;
    }
    let _e75 = phi_244_;
    return _e75;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_256_: bool;
    var phi_260_: f32;

    if (param_5 != param_5) {
        phi_256_ = true;
    } else {
        let _e71 = (param_6 <= param_5);
        if _e71 {
        }
        phi_256_ = _e71;
    }
    let _e73 = phi_256_;
    if _e73 {
        phi_260_ = param_6;
    } else {
        phi_260_ = param_5;
    }
    let _e75 = phi_260_;
    return _e75;
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
                phi_302_ = 1f;
            } else {
                phi_302_ = 0f;
            }
            let _e102 = phi_302_;
            if (param_8 < 8388608f) {
                phi_307_ = (_e99 - _e102);
                phi_308_ = false;
            } else {
                phi_307_ = f32();
                phi_308_ = true;
            }
            let _e105 = phi_307_;
            let _e107 = phi_308_;
            phi_309_ = _e105;
            phi_310_ = _e107;
        } else {
            phi_309_ = f32();
            phi_310_ = true;
        }
        let _e109 = phi_309_;
        let _e111 = phi_310_;
        if _e111 {
            phi_314_ = param_8;
        } else {
            phi_314_ = _e109;
        }
        let _e113 = phi_314_;
        phi_362_ = (param_8 - _e113);
    } else {
        if (_e86 == 1u) {
            let _e116 = (param_8 * 0.5f);
            if (_e116 > -8388608f) {
                let _e128 = f32(select(0i, select(select(i32(_e116), i32(-2147483648), (_e116 < bitcast<f32>(3472883712u))), 2147483647i, (_e116 > bitcast<f32>(1325400063u))), (_e116 == _e116)));
                if (_e128 > _e116) {
                    phi_340_ = 1f;
                } else {
                    phi_340_ = 0f;
                }
                let _e131 = phi_340_;
                if (_e116 < 8388608f) {
                    phi_345_ = (_e128 - _e131);
                    phi_346_ = false;
                } else {
                    phi_345_ = f32();
                    phi_346_ = true;
                }
                let _e134 = phi_345_;
                let _e136 = phi_346_;
                phi_347_ = _e134;
                phi_348_ = _e136;
            } else {
                phi_347_ = f32();
                phi_348_ = true;
            }
            let _e138 = phi_347_;
            let _e140 = phi_348_;
            if _e140 {
                phi_352_ = _e116;
            } else {
                phi_352_ = _e138;
            }
            let _e142 = phi_352_;
            let _e144 = (param_8 - (2f * _e142));
            if (_e144 > 1f) {
                phi_360_ = (2f - _e144);
            } else {
                phi_360_ = _e144;
            }
            let _e148 = phi_360_;
            phi_361_ = _e148;
        } else {
            phi_361_ = param_8;
        }
        let _e150 = phi_361_;
        phi_362_ = _e150;
    }
    let _e152 = phi_362_;
    if (_e152 > 0f) {
        if (_e152 < 1f) {
            phi_371_ = _e152;
        } else {
            phi_371_ = 1f;
        }
        let _e156 = phi_371_;
        phi_372_ = _e156;
    } else {
        phi_372_ = 0f;
    }
    let _e158 = phi_372_;
    let _e159 = (_e73 - 1u);
    let _e161 = (_e158 * f32(_e73));
    if _e81 {
        let _e168 = select(select(u32(_e161), 0u, (_e161 < bitcast<f32>(0u))), 4294967295u, (_e161 > bitcast<f32>(1333788671u)));
        if (_e159 < _e168) {
            phi_390_ = _e159;
        } else {
            phi_390_ = _e168;
        }
        let _e171 = phi_390_;
        phi_429_ = texture_Axis(_e171, _e171, 0f);
    } else {
        let _e173 = (_e161 + 0.5f);
        let _e180 = select(select(u32(_e173), 0u, (_e173 < bitcast<f32>(0u))), 4294967295u, (_e173 > bitcast<f32>(1333788671u)));
        if (_e73 < _e180) {
            phi_404_ = _e73;
        } else {
            phi_404_ = _e180;
        }
        let _e183 = phi_404_;
        if (_e86 == 0u) {
            phi_411_ = _e159;
        } else {
            phi_411_ = 0u;
        }
        let _e188 = phi_411_;
        if (_e86 == 0u) {
            phi_416_ = 0u;
        } else {
            phi_416_ = _e159;
        }
        let _e191 = phi_416_;
        if (_e183 == 0u) {
            phi_422_ = _e188;
        } else {
            phi_422_ = (_e183 - 1u);
        }
        let _e195 = phi_422_;
        if (_e183 > _e159) {
            phi_427_ = _e191;
        } else {
            phi_427_ = _e183;
        }
        let _e198 = phi_427_;
        phi_429_ = texture_Axis(_e195, _e198, (_e173 - f32(_e183)));
    }
    let _e201 = phi_429_;
    let _e203 = (*param_7).flags;
    let _e206 = ((_e203 >> bitcast<u32>(6u)) & 3u);
    if (_e206 == 0u) {
        if (param_9 > -8388608f) {
            let _e219 = f32(select(0i, select(select(i32(param_9), i32(-2147483648), (param_9 < bitcast<f32>(3472883712u))), 2147483647i, (param_9 > bitcast<f32>(1325400063u))), (param_9 == param_9)));
            if (_e219 > param_9) {
                phi_457_ = 1f;
            } else {
                phi_457_ = 0f;
            }
            let _e222 = phi_457_;
            if (param_9 < 8388608f) {
                phi_462_ = (_e219 - _e222);
                phi_463_ = false;
            } else {
                phi_462_ = f32();
                phi_463_ = true;
            }
            let _e225 = phi_462_;
            let _e227 = phi_463_;
            phi_464_ = _e225;
            phi_465_ = _e227;
        } else {
            phi_464_ = f32();
            phi_465_ = true;
        }
        let _e229 = phi_464_;
        let _e231 = phi_465_;
        if _e231 {
            phi_469_ = param_9;
        } else {
            phi_469_ = _e229;
        }
        let _e233 = phi_469_;
        phi_517_ = (param_9 - _e233);
    } else {
        if (_e206 == 1u) {
            let _e236 = (param_9 * 0.5f);
            if (_e236 > -8388608f) {
                let _e248 = f32(select(0i, select(select(i32(_e236), i32(-2147483648), (_e236 < bitcast<f32>(3472883712u))), 2147483647i, (_e236 > bitcast<f32>(1325400063u))), (_e236 == _e236)));
                if (_e248 > _e236) {
                    phi_495_ = 1f;
                } else {
                    phi_495_ = 0f;
                }
                let _e251 = phi_495_;
                if (_e236 < 8388608f) {
                    phi_500_ = (_e248 - _e251);
                    phi_501_ = false;
                } else {
                    phi_500_ = f32();
                    phi_501_ = true;
                }
                let _e254 = phi_500_;
                let _e256 = phi_501_;
                phi_502_ = _e254;
                phi_503_ = _e256;
            } else {
                phi_502_ = f32();
                phi_503_ = true;
            }
            let _e258 = phi_502_;
            let _e260 = phi_503_;
            if _e260 {
                phi_507_ = _e236;
            } else {
                phi_507_ = _e258;
            }
            let _e262 = phi_507_;
            let _e264 = (param_9 - (2f * _e262));
            if (_e264 > 1f) {
                phi_515_ = (2f - _e264);
            } else {
                phi_515_ = _e264;
            }
            let _e268 = phi_515_;
            phi_516_ = _e268;
        } else {
            phi_516_ = param_9;
        }
        let _e270 = phi_516_;
        phi_517_ = _e270;
    }
    let _e272 = phi_517_;
    if (_e272 > 0f) {
        if (_e272 < 1f) {
            phi_526_ = _e272;
        } else {
            phi_526_ = 1f;
        }
        let _e276 = phi_526_;
        phi_527_ = _e276;
    } else {
        phi_527_ = 0f;
    }
    let _e278 = phi_527_;
    let _e279 = (_e77 - 1u);
    let _e281 = (_e278 * f32(_e77));
    if _e81 {
        let _e288 = select(select(u32(_e281), 0u, (_e281 < bitcast<f32>(0u))), 4294967295u, (_e281 > bitcast<f32>(1333788671u)));
        if (_e279 < _e288) {
            phi_545_ = _e279;
        } else {
            phi_545_ = _e288;
        }
        let _e291 = phi_545_;
        phi_584_ = texture_Axis(_e291, _e291, 0f);
    } else {
        let _e293 = (_e281 + 0.5f);
        let _e300 = select(select(u32(_e293), 0u, (_e293 < bitcast<f32>(0u))), 4294967295u, (_e293 > bitcast<f32>(1333788671u)));
        if (_e77 < _e300) {
            phi_559_ = _e77;
        } else {
            phi_559_ = _e300;
        }
        let _e303 = phi_559_;
        if (_e206 == 0u) {
            phi_566_ = _e279;
        } else {
            phi_566_ = 0u;
        }
        let _e308 = phi_566_;
        if (_e206 == 0u) {
            phi_571_ = 0u;
        } else {
            phi_571_ = _e279;
        }
        let _e311 = phi_571_;
        if (_e303 == 0u) {
            phi_577_ = _e308;
        } else {
            phi_577_ = (_e303 - 1u);
        }
        let _e315 = phi_577_;
        if (_e303 > _e279) {
            phi_582_ = _e311;
        } else {
            phi_582_ = _e303;
        }
        let _e318 = phi_582_;
        phi_584_ = texture_Axis(_e315, _e318, (_e293 - f32(_e303)));
    }
    let _e321 = phi_584_;
    let _e325 = (*param_7).offset;
    let _e332 = (*param_7).offset;
    let _e339 = (*param_7).offset;
    let _e346 = (*param_7).offset;
    return texture_TexelQuad(array<u32, 4>(((_e325 + (_e321.low * _e73)) + _e201.low), ((_e332 + (_e321.low * _e73)) + _e201.high), ((_e339 + (_e321.high * _e73)) + _e201.low), ((_e346 + (_e321.high * _e73)) + _e201.high)), vec4<f32>(((1f - _e201.fraction) * (1f - _e321.fraction)), (_e201.fraction * (1f - _e321.fraction)), ((1f - _e201.fraction) * _e321.fraction), (_e201.fraction * _e321.fraction)));
}

fn _lt_shaders_abi_Sample_is_valid(param_10: ptr<function, abi_Sample>) -> bool {
    var phi_656_: bool;
    var phi_657_: bool;
    var phi_658_: bool;
    var phi_659_: bool;
    var phi_663_: bool;

    let _e71 = (*param_10).normal[0u];
    let _e73 = global[0u];
    if (_e71 == _e73) {
        let _e76 = (*param_10).normal[1u];
        let _e78 = global[1u];
        if (_e76 == _e78) {
            let _e81 = (*param_10).normal[2u];
            let _e83 = global[2u];
            phi_656_ = (_e81 == _e83);
            phi_657_ = false;
        } else {
            phi_656_ = bool();
            phi_657_ = true;
        }
        let _e86 = phi_656_;
        let _e88 = phi_657_;
        phi_658_ = _e86;
        phi_659_ = _e88;
    } else {
        phi_658_ = bool();
        phi_659_ = true;
    }
    let _e90 = phi_658_;
    let _e92 = phi_659_;
    if _e92 {
        phi_663_ = false;
    } else {
        phi_663_ = _e90;
    }
    let _e94 = phi_663_;
    return !(_e94);
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var local_2: abi_Sample;
    var phi_757_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_761_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_807_: f32;
    var phi_862_: bool;
    var phi_863_: bool;
    var phi_864_: bool;
    var phi_868_: bool;
    var phi_869_: bool;
    var phi_870_: bool;
    var phi_871_: bool;
    var phi_872_: bool;
    var phi_873_: bool;
    var phi_874_: bool;
    var phi_875_: bool;
    var phi_876_: bool;
    var phi_877_: bool;
    var phi_878_: bool;
    var phi_879_: bool;
    var phi_880_: bool;
    var phi_881_: bool;
    var phi_882_: bool;
    var phi_883_: bool;
    var phi_884_: bool;
    var phi_885_: bool;
    var phi_889_: bool;
    var phi_893_: bool;
    var phi_963_: f32;
    var phi_970_: f32;
    var phi_977_: f32;
    var phi_984_: f32;
    var phi_991_: f32;
    var phi_998_: f32;
    var phi_1015_: f32;
    var phi_1020_: f32;
    var phi_1025_: f32;
    var phi_1053_: bool;
    var phi_1054_: bool;
    var phi_1062_: u32;
    var phi_1063_: u32;
    var phi_1074_: vec3<f32>;
    var phi_1075_: vec3<f32>;
    var phi_1088_: u32;
    var phi_1093_: u32;
    var phi_1098_: u32;
    var phi_1212_: bool;
    var phi_1213_: bool;
    var phi_1244_: u32;
    var phi_1246_: u32;
    var phi_1249_: bool;
    var phi_1329_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1356_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1383_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1389_: u32;
    var phi_1392_: u32;
    var phi_1406_: u32;
    var phi_1416_: u32;
    var phi_1426_: u32;
    var phi_1444_: u32;
    var phi_1454_: u32;
    var phi_1464_: u32;
    var phi_1500_: u32;
    var phi_1513_: u32;
    var phi_1518_: u32;
    var phi_1519_: u32;
    var phi_1520_: u32;
    var phi_1390_: u32;
    var phi_1393_: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_1578_: u32;
    var phi_1581_: bool;
    var phi_1625_: vec3<f32>;
    var phi_1626_: vec3<f32>;
    var phi_1655_: vec3<f32>;
    var phi_1656_: vec3<f32>;
    var phi_1685_: vec3<f32>;
    var phi_1686_: vec3<f32>;
    var phi_1704_: bool;
    var phi_1705_: bool;
    var phi_1709_: f32;
    var phi_1710_: f32;
    var phi_1711_: f32;
    var phi_1712_: f32;
    var phi_1720_: f32;
    var phi_1730_: bool;
    var phi_1731_: bool;
    var phi_1735_: f32;
    var phi_1736_: f32;
    var phi_1737_: f32;
    var phi_1738_: f32;
    var phi_1746_: f32;
    var phi_1756_: bool;
    var phi_1757_: bool;
    var phi_1761_: f32;
    var phi_1762_: f32;
    var phi_1763_: f32;
    var phi_1764_: f32;
    var phi_1772_: f32;
    var phi_1787_: f32;
    var phi_1788_: bool;
    var phi_1789_: f32;
    var phi_1790_: bool;
    var phi_1791_: f32;
    var phi_1792_: bool;
    var phi_1810_: f32;
    var phi_1811_: bool;
    var phi_1812_: bool;
    var phi_1813_: f32;
    var phi_1814_: bool;
    var phi_1815_: bool;
    var phi_1819_: bool;
    var phi_1820_: f32;
    var phi_1821_: bool;
    var phi_1849_: vec3<f32>;
    var phi_1850_: vec3<f32>;
    var phi_1875_: vec3<f32>;
    var phi_1876_: vec3<f32>;
    var phi_1901_: vec3<f32>;
    var phi_1902_: vec3<f32>;
    var phi_1958_: f32;
    var phi_1967_: f32;
    var phi_1976_: f32;
    var phi_1985_: f32;
    var phi_1992_: f32;
    var phi_1999_: f32;
    var phi_2012_: f32;
    var phi_2021_: f32;
    var phi_2030_: f32;
    var phi_2039_: f32;
    var phi_2046_: f32;
    var phi_2053_: f32;
    var phi_2070_: f32;
    var phi_2075_: f32;
    var phi_2080_: f32;
    var phi_2088_: f32;
    var phi_2093_: f32;
    var phi_2098_: f32;
    var phi_2110_: f32;
    var phi_2115_: f32;
    var phi_2120_: f32;
    var phi_2125_: f32;
    var phi_2130_: lt_bvh_triangle_Intersection;
    var phi_2131_: bool;
    var phi_2132_: lt_bvh_triangle_Intersection;
    var phi_2133_: bool;
    var phi_2137_: lt_bvh_triangle_Intersection;
    var phi_2138_: bool;
    var phi_2139_: lt_bvh_triangle_Intersection;
    var phi_2140_: bool;
    var phi_2141_: bool;
    var phi_2145_: bool;
    var phi_2149_: lt_bvh_triangle_Intersection;
    var phi_2363_: f32;
    var phi_2366_: bool;
    var phi_2367_: bool;
    var phi_2368_: bool;
    var phi_2372_: bool;
    var phi_2373_: bool;
    var phi_2374_: bool;
    var phi_2375_: bool;
    var phi_2376_: bool;
    var phi_2377_: bool;
    var phi_2378_: bool;
    var phi_2379_: bool;
    var phi_2380_: bool;
    var phi_2381_: bool;
    var phi_1579_: u32;
    var phi_1582_: bool;
    var phi_2385_: bool;
    var phi_2386_: bool;
    var local_6: bool;
    var phi_2428_: bool;
    var phi_2429_: bool;
    var phi_2460_: u32;
    var phi_2461_: u32;
    var phi_1247_: u32;
    var phi_1250_: bool;
    var phi_2462_: bool;
    var phi_2463_: bool;
    var phi_2464_: bool;
    var local_7: bool;
    var phi_2468_: bool;
    var phi_2472_: bool;
    var phi_2473_: bool;
    var phi_2474_: bool;
    var phi_2475_: bool;
    var phi_2479_: bool;
    var phi_2483_: f32;
    var phi_2484_: f32;
    var local_8: bool;
    var local_9: bool;
    var local_10: bool;
    var local_11: bool;
    var local_12: bool;

    let _e71 = id_1;
    let _e78 = arrayLength((&nodes.member));
    let _e81 = arrayLength((&triangles.member));
    let _e87 = arrayLength((&vertices.member));
    let _e93 = arrayLength((&alpha_texels.member));
    let _e96 = p.member.size[0u];
    let _e98 = p.member.size[1u];
    let _e99 = lt_shaders_entry_pixel_index(_e71, _e96, _e98);
    if (bitcast<i32>(_e99.root) != 0i) {
        if (_e99.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e107 = samples.member[(0u + _e99.first_primitive)];
        local_2 = abi_Sample(_e107.position, _e107.magnitude, _e107.normal, _e107.flags, _e107.shading_normal, _e107.albedo);
        let _e116 = p.member.light;
        let _e117 = _lt_shaders_abi_Sample_is_valid((&local_2));
        if _e117 {
            let _e119 = local_2.normal;
            let _e121 = local_2.position;
            if ((((_e119.x * (_e116.x - (_e121.x * _e116.w))) + (_e119.y * (_e116.y - (_e121.y * _e116.w)))) + (_e119.z * (_e116.z - (_e121.z * _e116.w)))) > 0f) {
                let _e145 = local_2.flags;
                let _e153 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e159 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e153.unnamed.visibility, false), _e153.unnamed_1);
                phi_757_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e159.unnamed, ((_e145 & 1u) == 0u));
            } else {
                let _e168 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e174 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e168.unnamed.visibility, false), _e168.unnamed_1);
                phi_757_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e174.unnamed, true);
            }
            let _e179 = phi_757_;
            phi_761_ = _e179;
        } else {
            let _e185 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e191 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e185.unnamed.visibility, false), _e185.unnamed_1);
            phi_761_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e191.unnamed, true);
        }
        let _e196 = phi_761_;
        if _e196.unnamed_1 {
            phi_2484_ = _e196.unnamed.visibility;
        } else {
            let _e201 = p.member.light;
            let _e203 = local_2.position;
            let _e205 = local_2.normal;
            let _e207 = local_2.magnitude;
            let _e209 = ((8f / 8388608f) * _e207);
            let _e217 = (_e203.x + (_e205.x * _e209));
            let _e219 = (_e203.y + (_e205.y * _e209));
            let _e221 = (_e203.z + (_e205.z * _e209));
            if (_e201.w == 0f) {
                phi_807_ = 300000000000000000000000000000000000000f;
            } else {
                phi_807_ = 1f;
            }
            let _e225 = phi_807_;
            let _e233 = (_e201.x - (_e217 * _e201.w));
            let _e234 = (_e201.y - (_e219 * _e201.w));
            let _e235 = (_e201.z - (_e221 * _e201.w));
            let _e240 = abs(_e233);
            let _e241 = abs(_e234);
            let _e242 = abs(_e235);
            if (abs(_e217) < 1000000000000000f) {
                if (abs(_e219) < 1000000000000000f) {
                    if (abs(_e221) < 1000000000000000f) {
                        if (_e240 < 1000000000000000f) {
                            if (_e241 < 1000000000000000f) {
                                if (_e242 < 1000000000000000f) {
                                    if (_e240 > 0f) {
                                        phi_863_ = bool();
                                        phi_864_ = true;
                                    } else {
                                        let _e250 = (_e241 > 0f);
                                        if _e250 {
                                            phi_862_ = bool();
                                        } else {
                                            phi_862_ = (_e242 > 0f);
                                        }
                                        let _e253 = phi_862_;
                                        phi_863_ = _e253;
                                        phi_864_ = _e250;
                                    }
                                    let _e255 = phi_863_;
                                    let _e257 = phi_864_;
                                    if _e257 {
                                        phi_868_ = true;
                                    } else {
                                        phi_868_ = _e255;
                                    }
                                    let _e259 = phi_868_;
                                    phi_869_ = _e259;
                                    phi_870_ = false;
                                } else {
                                    phi_869_ = bool();
                                    phi_870_ = true;
                                }
                                let _e261 = phi_869_;
                                let _e263 = phi_870_;
                                phi_871_ = _e261;
                                phi_872_ = false;
                                phi_873_ = _e263;
                            } else {
                                phi_871_ = bool();
                                phi_872_ = true;
                                phi_873_ = false;
                            }
                            let _e265 = phi_871_;
                            let _e267 = phi_872_;
                            let _e269 = phi_873_;
                            phi_874_ = _e265;
                            phi_875_ = _e267;
                            phi_876_ = _e269;
                        } else {
                            phi_874_ = bool();
                            phi_875_ = true;
                            phi_876_ = false;
                        }
                        let _e271 = phi_874_;
                        let _e273 = phi_875_;
                        let _e275 = phi_876_;
                        phi_877_ = _e271;
                        phi_878_ = _e273;
                        phi_879_ = _e275;
                    } else {
                        phi_877_ = bool();
                        phi_878_ = true;
                        phi_879_ = false;
                    }
                    let _e277 = phi_877_;
                    let _e279 = phi_878_;
                    let _e281 = phi_879_;
                    phi_880_ = _e277;
                    phi_881_ = _e279;
                    phi_882_ = _e281;
                } else {
                    phi_880_ = bool();
                    phi_881_ = true;
                    phi_882_ = false;
                }
                let _e283 = phi_880_;
                let _e285 = phi_881_;
                let _e287 = phi_882_;
                phi_883_ = _e283;
                phi_884_ = _e285;
                phi_885_ = _e287;
            } else {
                phi_883_ = bool();
                phi_884_ = true;
                phi_885_ = false;
            }
            let _e289 = phi_883_;
            let _e291 = phi_884_;
            let _e293 = phi_885_;
            if _e291 {
                phi_889_ = true;
            } else {
                phi_889_ = _e293;
            }
            let _e295 = phi_889_;
            if _e295 {
                phi_893_ = false;
            } else {
                phi_893_ = _e289;
            }
            let _e297 = phi_893_;
            if _e297 {
                let _e298 = (0u >= _e78);
                if _e298 {
                    phi_2473_ = bool();
                } else {
                    if (0u < _e78) {
                    } else {
                        return;
                    }
                    let _e304 = nodes.member[(0u + 0u)].frame[0u];
                    let _e308 = nodes.member[(0u + 0u)].frame[1u];
                    let _e312 = nodes.member[(0u + 0u)].frame[2u];
                    let _e316 = nodes.member[(0u + 0u)].frame[0u];
                    let _e320 = nodes.member[(0u + 0u)].frame[1u];
                    let _e324 = nodes.member[(0u + 0u)].frame[2u];
                    let _e328 = nodes.member[(0u + 0u)].frame[3u];
                    let _e362 = core_intrinsics_maximum_number_nsz_f32_(abs(_e233), abs(_e234));
                    let _e363 = core_intrinsics_maximum_number_nsz_f32_(_e362, abs(_e235));
                    let _e364 = (_e363 * 0.0000000000009094947f);
                    if (abs(_e233) < _e364) {
                        phi_963_ = _e364;
                    } else {
                        phi_963_ = abs(_e233);
                    }
                    let _e369 = phi_963_;
                    if (_e233 < 0f) {
                        phi_970_ = (-1f / _e369);
                    } else {
                        phi_970_ = (1f / _e369);
                    }
                    let _e374 = phi_970_;
                    if (abs(_e234) < _e364) {
                        phi_977_ = _e364;
                    } else {
                        phi_977_ = abs(_e234);
                    }
                    let _e379 = phi_977_;
                    if (_e234 < 0f) {
                        phi_984_ = (-1f / _e379);
                    } else {
                        phi_984_ = (1f / _e379);
                    }
                    let _e384 = phi_984_;
                    if (abs(_e235) < _e364) {
                        phi_991_ = _e364;
                    } else {
                        phi_991_ = abs(_e235);
                    }
                    let _e389 = phi_991_;
                    if (_e235 < 0f) {
                        phi_998_ = (-1f / _e389);
                    } else {
                        phi_998_ = (1f / _e389);
                    }
                    let _e394 = phi_998_;
                    let _e398 = abs((bitcast<f32>(_e304) - _e217));
                    let _e399 = abs((bitcast<f32>(_e308) - _e219));
                    let _e400 = abs((bitcast<f32>(_e312) - _e221));
                    let _e404 = abs(((bitcast<f32>(_e316) + (bitcast<f32>((((_e328 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e217));
                    let _e405 = abs(((bitcast<f32>(_e320) + (bitcast<f32>((((_e328 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e219));
                    let _e406 = abs(((bitcast<f32>(_e324) + (bitcast<f32>((((_e328 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e221));
                    if (_e398 > _e404) {
                        phi_1015_ = _e398;
                    } else {
                        phi_1015_ = _e404;
                    }
                    let _e409 = phi_1015_;
                    if (_e399 > _e405) {
                        phi_1020_ = _e399;
                    } else {
                        phi_1020_ = _e405;
                    }
                    let _e412 = phi_1020_;
                    if (_e400 > _e406) {
                        phi_1025_ = _e400;
                    } else {
                        phi_1025_ = _e406;
                    }
                    let _e415 = phi_1025_;
                    let _e416 = core_intrinsics_maximum_number_nsz_f32_(_e409, _e412);
                    let _e417 = core_intrinsics_maximum_number_nsz_f32_(_e416, _e415);
                    let _e421 = (_e417 * 0.0000019073486f);
                    let _e422 = (abs(_e374) * _e421);
                    let _e423 = (abs(_e384) * _e421);
                    let _e424 = (abs(_e394) * _e421);
                    let _e428 = (_e417 * 0.0000009536743f);
                    let _e429 = (abs(_e374) * _e428);
                    let _e430 = (abs(_e384) * _e428);
                    let _e431 = (abs(_e394) * _e428);
                    let _e432 = abs(_e233);
                    let _e433 = abs(_e234);
                    let _e434 = abs(_e235);
                    if (_e432 >= _e433) {
                        if (_e432 >= _e434) {
                            phi_1053_ = false;
                        } else {
                            phi_1053_ = true;
                        }
                        let _e438 = phi_1053_;
                        phi_1054_ = _e438;
                    } else {
                        phi_1054_ = true;
                    }
                    let _e440 = phi_1054_;
                    if _e440 {
                        if (_e433 >= _e434) {
                            phi_1062_ = 1u;
                        } else {
                            phi_1062_ = 2u;
                        }
                        let _e443 = phi_1062_;
                        phi_1063_ = _e443;
                    } else {
                        phi_1063_ = 0u;
                    }
                    let _e445 = phi_1063_;
                    if (_e445 == 0u) {
                        phi_1075_ = vec3<f32>(_e234, _e235, _e233);
                    } else {
                        if (_e445 == 1u) {
                            phi_1074_ = vec3<f32>(_e235, _e233, _e234);
                        } else {
                            phi_1074_ = vec3<f32>(_e233, _e234, _e235);
                        }
                        let _e451 = phi_1074_;
                        phi_1075_ = _e451;
                    }
                    let _e453 = phi_1075_;
                    let _e456 = (_e453.x / _e453.z);
                    let _e459 = (_e453.y / _e453.z);
                    if (_e374 < 0f) {
                        phi_1088_ = 0u;
                    } else {
                        phi_1088_ = 1u;
                    }
                    let _e464 = phi_1088_;
                    if (_e384 < 0f) {
                        phi_1093_ = 0u;
                    } else {
                        phi_1093_ = 2u;
                    }
                    let _e467 = phi_1093_;
                    if (_e394 < 0f) {
                        phi_1098_ = 0u;
                    } else {
                        phi_1098_ = 4u;
                    }
                    let _e470 = phi_1098_;
                    let _e472 = ((_e464 | _e467) | _e470);
                    let _e473 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                    local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e473.first[0], _e473.first[1], _e473.first[2], _e473.first[3], _e473.first[4], _e473.first[5], _e473.first[6], _e473.first[7], _e473.first[8], _e473.first[9], _e473.first[10], _e473.first[11], _e473.first[12], _e473.first[13], _e473.first[14], _e473.first[15], _e473.first[16], _e473.first[17], _e473.first[18], _e473.first[19], _e473.first[20], _e473.first[21], _e473.first[22], _e473.first[23], _e473.first[24], _e473.first[25], _e473.first[26], _e473.first[27], _e473.first[28], _e473.first[29], _e473.first[30], _e473.first[31]), array<u32, 32>(_e473.mask[0], _e473.mask[1], _e473.mask[2], _e473.mask[3], _e473.mask[4], _e473.mask[5], _e473.mask[6], _e473.mask[7], _e473.mask[8], _e473.mask[9], _e473.mask[10], _e473.mask[11], _e473.mask[12], _e473.mask[13], _e473.mask[14], _e473.mask[15], _e473.mask[16], _e473.mask[17], _e473.mask[18], _e473.mask[19], _e473.mask[20], _e473.mask[21], _e473.mask[22], _e473.mask[23], _e473.mask[24], _e473.mask[25], _e473.mask[26], _e473.mask[27], _e473.mask[28], _e473.mask[29], _e473.mask[30], _e473.mask[31]), _e473.len, _e473.group, _e473.group_mask);
                    let _e547 = local_1.group_mask;
                    if ((_e547 & 4278190080u) == 0u) {
                        let _e551 = local_1.len;
                        if (_e551 == 0u) {
                            phi_1212_ = false;
                        } else {
                            let _e555 = local_1.len;
                            local_1.len = (_e555 - 1u);
                            let _e558 = local_1.len;
                            if (_e558 < 32u) {
                            } else {
                                return;
                            }
                            let _e563 = local_1.first[(0u + _e558)];
                            local_1.group = _e563;
                            let _e566 = local_1.len;
                            if (_e566 < 32u) {
                            } else {
                                return;
                            }
                            let _e571 = local_1.mask[(0u + _e566)];
                            local_1.group_mask = _e571;
                            phi_1212_ = true;
                        }
                        let _e574 = phi_1212_;
                        phi_1213_ = _e574;
                    } else {
                        phi_1213_ = true;
                    }
                    let _e576 = phi_1213_;
                    if _e576 {
                        let _e578 = local_1.group_mask;
                        let _e584 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e578)), 32u, (_e578 == 0u)));
                        let _e588 = local_1.group_mask;
                        let _e602 = local_1.group_mask;
                        local_1.group_mask = (_e602 & ~((1u << bitcast<u32>((_e584 & 31u)))));
                        let _e605 = local_1.group;
                        phi_1244_ = (_e605 + countOneBits(((_e588 & ~((4294967295u << bitcast<u32>((((_e584 - 24u) ^ 7u) & 31u))))) & 255u)));
                    } else {
                        phi_1244_ = 4294967295u;
                    }
                    let _e608 = phi_1244_;
                    phi_1246_ = _e608;
                    phi_1249_ = false;
                    loop {
                        let _e610 = phi_1246_;
                        let _e612 = phi_1249_;
                        local_12 = _e612;
                        if (_e610 != 4294967295u) {
                            if (_e610 < _e78) {
                            } else {
                                return;
                            }
                            let _e619 = nodes.member[(0u + _e610)].frame[3u];
                            let _e644 = (bitcast<f32>((((_e619 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e374);
                            let _e645 = (bitcast<f32>((((_e619 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e384);
                            let _e646 = (bitcast<f32>((((_e619 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e394);
                            let _e649 = nodes.member[(0u + _e610)].frame[0u];
                            let _e653 = nodes.member[(0u + _e610)].frame[1u];
                            let _e657 = nodes.member[(0u + _e610)].frame[2u];
                            let _e662 = ((bitcast<f32>(_e649) - _e217) * _e374);
                            let _e663 = ((bitcast<f32>(_e653) - _e219) * _e384);
                            let _e664 = ((bitcast<f32>(_e657) - _e221) * _e394);
                            let _e672 = nodes.member[(0u + _e610)].x;
                            if (_e374 < 0f) {
                                let _e683 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e672.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e689 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e683.unnamed.root, _e672.w), _e683.unnamed_1);
                                let _e695 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e689.unnamed, lt_bvh_traverse_Tree(_e672.x, _e689.unnamed_1.first_primitive));
                                phi_1329_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e695.unnamed, lt_bvh_traverse_Tree(_e695.unnamed_1.root, _e672.y));
                            } else {
                                let _e711 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e672.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e717 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e711.unnamed.root, _e672.y), _e711.unnamed_1);
                                let _e723 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e717.unnamed, lt_bvh_traverse_Tree(_e672.z, _e717.unnamed_1.first_primitive));
                                phi_1329_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e723.unnamed, lt_bvh_traverse_Tree(_e723.unnamed_1.root, _e672.w));
                            }
                            let _e731 = phi_1329_;
                            let _e741 = nodes.member[(0u + _e610)].y;
                            if (_e384 < 0f) {
                                let _e752 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e741.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e758 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e752.unnamed.root, _e741.w), _e752.unnamed_1);
                                let _e764 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e758.unnamed, lt_bvh_traverse_Tree(_e741.x, _e758.unnamed_1.first_primitive));
                                phi_1356_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e764.unnamed, lt_bvh_traverse_Tree(_e764.unnamed_1.root, _e741.y));
                            } else {
                                let _e780 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e741.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e786 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e780.unnamed.root, _e741.y), _e780.unnamed_1);
                                let _e792 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e786.unnamed, lt_bvh_traverse_Tree(_e741.z, _e786.unnamed_1.first_primitive));
                                phi_1356_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e792.unnamed, lt_bvh_traverse_Tree(_e792.unnamed_1.root, _e741.w));
                            }
                            let _e800 = phi_1356_;
                            let _e810 = nodes.member[(0u + _e610)].z;
                            if (_e394 < 0f) {
                                let _e821 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e810.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e827 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e821.unnamed.root, _e810.w), _e821.unnamed_1);
                                let _e833 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e827.unnamed, lt_bvh_traverse_Tree(_e810.x, _e827.unnamed_1.first_primitive));
                                phi_1383_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e833.unnamed, lt_bvh_traverse_Tree(_e833.unnamed_1.root, _e810.y));
                            } else {
                                let _e849 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e810.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e855 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e849.unnamed.root, _e810.y), _e849.unnamed_1);
                                let _e861 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e855.unnamed, lt_bvh_traverse_Tree(_e810.z, _e855.unnamed_1.first_primitive));
                                phi_1383_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e861.unnamed, lt_bvh_traverse_Tree(_e861.unnamed_1.root, _e810.w));
                            }
                            let _e869 = phi_1383_;
                            phi_1389_ = 0u;
                            phi_1392_ = 0u;
                            loop {
                                let _e879 = phi_1389_;
                                let _e881 = phi_1392_;
                                local_3 = _e881;
                                local_4 = _e881;
                                local_5 = _e881;
                                let _e882 = (_e879 < 8u);
                                if _e882 {
                                    let _e884 = (_e879 >> bitcast<u32>(2i));
                                    let _e885 = (_e879 & 3u);
                                    if (_e884 == 0u) {
                                        phi_1406_ = _e731.unnamed.root;
                                    } else {
                                        phi_1406_ = _e731.unnamed.first_primitive;
                                    }
                                    let _e888 = phi_1406_;
                                    if (_e884 == 0u) {
                                        phi_1416_ = _e800.unnamed.root;
                                    } else {
                                        phi_1416_ = _e800.unnamed.first_primitive;
                                    }
                                    let _e897 = phi_1416_;
                                    if (_e884 == 0u) {
                                        phi_1426_ = _e869.unnamed.root;
                                    } else {
                                        phi_1426_ = _e869.unnamed.first_primitive;
                                    }
                                    let _e906 = phi_1426_;
                                    let _e919 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e888 >> bitcast<u32>(((_e885 * 8u) & 31u))) & 255u)) * _e644) + (_e662 - _e422)), ((f32(((_e897 >> bitcast<u32>(((_e885 * 8u) & 31u))) & 255u)) * _e645) + (_e663 - _e423)));
                                    let _e920 = core_intrinsics_maximum_number_nsz_f32_(_e919, ((f32(((_e906 >> bitcast<u32>(((_e885 * 8u) & 31u))) & 255u)) * _e646) + (_e664 - _e424)));
                                    if (_e884 == 0u) {
                                        phi_1444_ = _e731.unnamed_1.root;
                                    } else {
                                        phi_1444_ = _e731.unnamed_1.first_primitive;
                                    }
                                    let _e923 = phi_1444_;
                                    if (_e884 == 0u) {
                                        phi_1454_ = _e800.unnamed_1.root;
                                    } else {
                                        phi_1454_ = _e800.unnamed_1.first_primitive;
                                    }
                                    let _e932 = phi_1454_;
                                    if (_e884 == 0u) {
                                        phi_1464_ = _e869.unnamed_1.root;
                                    } else {
                                        phi_1464_ = _e869.unnamed_1.first_primitive;
                                    }
                                    let _e941 = phi_1464_;
                                    let _e954 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e923 >> bitcast<u32>(((_e885 * 8u) & 31u))) & 255u)) * _e644) + (_e662 + _e422)), ((f32(((_e932 >> bitcast<u32>(((_e885 * 8u) & 31u))) & 255u)) * _e645) + (_e663 + _e423)));
                                    let _e955 = core_intrinsics_minimum_number_nsz_f32_(_e954, ((f32(((_e941 >> bitcast<u32>(((_e885 * 8u) & 31u))) & 255u)) * _e646) + (_e664 + _e424)));
                                    if (_e920 <= _e955) {
                                        if (_e920 <= _e225) {
                                            if (_e955 >= 0f) {
                                                if (_e884 == 0u) {
                                                    let _e962 = nodes.member[(0u + _e610)].links[2u];
                                                    phi_1500_ = _e962;
                                                } else {
                                                    let _e965 = nodes.member[(0u + _e610)].links[3u];
                                                    phi_1500_ = _e965;
                                                }
                                                let _e967 = phi_1500_;
                                                let _e972 = ((_e967 >> bitcast<u32>(((_e885 * 8u) & 31u))) & 255u);
                                                let _e973 = (_e972 & 31u);
                                                if (_e973 >= 24u) {
                                                    phi_1513_ = (24u + ((_e973 - 24u) ^ _e472));
                                                } else {
                                                    phi_1513_ = _e973;
                                                }
                                                let _e979 = phi_1513_;
                                                phi_1518_ = (_e881 | ((_e972 >> bitcast<u32>(5i)) << bitcast<u32>((_e979 & 31u))));
                                            } else {
                                                phi_1518_ = _e881;
                                            }
                                            let _e987 = phi_1518_;
                                            phi_1519_ = _e987;
                                        } else {
                                            phi_1519_ = _e881;
                                        }
                                        let _e989 = phi_1519_;
                                        phi_1520_ = _e989;
                                    } else {
                                        phi_1520_ = _e881;
                                    }
                                    let _e991 = phi_1520_;
                                    phi_1390_ = (_e879 + 1u);
                                    phi_1393_ = _e991;
                                } else {
                                    phi_1390_ = u32();
                                    phi_1393_ = u32();
                                }
                                let _e994 = phi_1390_;
                                let _e996 = phi_1393_;
                                continue;
                                continuing {
                                    phi_1389_ = _e994;
                                    phi_1392_ = _e996;
                                    break if !(_e882);
                                }
                            }
                            let _e1000 = nodes.member[(0u + _e610)].links[0u];
                            let _e1004 = nodes.member[(0u + _e610)].frame[3u];
                            let _e1008 = local_3;
                            if ((_e1008 & 4278190080u) == 0u) {
                            } else {
                                let _e1012 = local_1.group_mask;
                                if ((_e1012 & 4278190080u) == 0u) {
                                } else {
                                    let _e1016 = local_1.len;
                                    if (_e1016 < 32u) {
                                        let _e1019 = local_1.group;
                                        let _e1021 = local_1.len;
                                        if (_e1021 < 32u) {
                                        } else {
                                            return;
                                        }
                                        local_1.first[(0u + _e1021)] = _e1019;
                                        let _e1027 = local_1.group_mask;
                                        let _e1029 = local_1.len;
                                        if (_e1029 < 32u) {
                                        } else {
                                            return;
                                        }
                                        local_1.mask[(0u + _e1029)] = _e1027;
                                        let _e1036 = local_1.len;
                                        local_1.len = (_e1036 + 1u);
                                    }
                                }
                                local_1.group = (0u + _e1000);
                                let _e1040 = local_4;
                                local_1.group_mask = ((_e1040 & 4278190080u) | (_e1004 >> bitcast<u32>(24i)));
                            }
                            let _e1045 = local_5;
                            phi_1578_ = (_e1045 & 16777215u);
                            phi_1581_ = _e612;
                            loop {
                                let _e1048 = phi_1578_;
                                let _e1050 = phi_1581_;
                                local_8 = _e1050;
                                let _e1051 = (_e1048 == 0u);
                                local_6 = _e1051;
                                local_10 = _e1051;
                                if _e1051 {
                                    phi_1579_ = u32();
                                    phi_1582_ = bool();
                                    phi_2385_ = bool();
                                    phi_2386_ = false;
                                } else {
                                    let _e1054 = nodes.member[(0u + _e610)].links[1u];
                                    let _e1059 = ((0u + _e1054) + select(firstTrailingBit(_e1048), 32u, (_e1048 == 0u)));
                                    if (_e1059 < _e81) {
                                    } else {
                                        return;
                                    }
                                    let _e1066 = triangles.member[(0u + _e1059)].v0_;
                                    let _e1068 = (_e1066.x - _e217);
                                    let _e1070 = (_e1066.y - _e219);
                                    let _e1072 = (_e1066.z - _e221);
                                    if (_e445 == 0u) {
                                        phi_1626_ = vec3<f32>(_e1070, _e1072, _e1068);
                                    } else {
                                        if (_e445 == 1u) {
                                            phi_1625_ = vec3<f32>(_e1072, _e1068, _e1070);
                                        } else {
                                            phi_1625_ = (_e1066 - vec3<f32>(_e217, _e219, _e221));
                                        }
                                        let _e1080 = phi_1625_;
                                        phi_1626_ = _e1080;
                                    }
                                    let _e1082 = phi_1626_;
                                    let _e1086 = (_e1082.x - (_e456 * _e1082.z));
                                    let _e1090 = (_e1082.y - (_e459 * _e1082.z));
                                    let _e1092 = triangles.member[(0u + _e1059)].v1_;
                                    let _e1094 = (_e1092.x - _e217);
                                    let _e1096 = (_e1092.y - _e219);
                                    let _e1098 = (_e1092.z - _e221);
                                    if (_e445 == 0u) {
                                        phi_1656_ = vec3<f32>(_e1096, _e1098, _e1094);
                                    } else {
                                        if (_e445 == 1u) {
                                            phi_1655_ = vec3<f32>(_e1098, _e1094, _e1096);
                                        } else {
                                            phi_1655_ = (_e1092 - vec3<f32>(_e217, _e219, _e221));
                                        }
                                        let _e1106 = phi_1655_;
                                        phi_1656_ = _e1106;
                                    }
                                    let _e1108 = phi_1656_;
                                    let _e1112 = (_e1108.x - (_e456 * _e1108.z));
                                    let _e1116 = (_e1108.y - (_e459 * _e1108.z));
                                    let _e1118 = triangles.member[(0u + _e1059)].v2_;
                                    let _e1120 = (_e1118.x - _e217);
                                    let _e1122 = (_e1118.y - _e219);
                                    let _e1124 = (_e1118.z - _e221);
                                    if (_e445 == 0u) {
                                        phi_1686_ = vec3<f32>(_e1122, _e1124, _e1120);
                                    } else {
                                        if (_e445 == 1u) {
                                            phi_1685_ = vec3<f32>(_e1124, _e1120, _e1122);
                                        } else {
                                            phi_1685_ = (_e1118 - vec3<f32>(_e217, _e219, _e221));
                                        }
                                        let _e1132 = phi_1685_;
                                        phi_1686_ = _e1132;
                                    }
                                    let _e1134 = phi_1686_;
                                    let _e1138 = (_e1134.x - (_e456 * _e1134.z));
                                    let _e1142 = (_e1134.y - (_e459 * _e1134.z));
                                    if (_e1112 < _e1138) {
                                        phi_1705_ = true;
                                    } else {
                                        if (_e1112 == _e1138) {
                                            phi_1704_ = (_e1116 < _e1142);
                                        } else {
                                            phi_1704_ = false;
                                        }
                                        let _e1147 = phi_1704_;
                                        phi_1705_ = _e1147;
                                    }
                                    let _e1149 = phi_1705_;
                                    if _e1149 {
                                        phi_1709_ = _e1142;
                                        phi_1710_ = _e1138;
                                        phi_1711_ = _e1116;
                                        phi_1712_ = _e1112;
                                    } else {
                                        phi_1709_ = _e1116;
                                        phi_1710_ = _e1112;
                                        phi_1711_ = _e1142;
                                        phi_1712_ = _e1138;
                                    }
                                    let _e1151 = phi_1709_;
                                    let _e1153 = phi_1710_;
                                    let _e1155 = phi_1711_;
                                    let _e1157 = phi_1712_;
                                    let _e1160 = ((_e1157 * _e1151) - (_e1155 * _e1153));
                                    if _e1149 {
                                        phi_1720_ = -(_e1160);
                                    } else {
                                        phi_1720_ = _e1160;
                                    }
                                    let _e1163 = phi_1720_;
                                    if (_e1138 < _e1086) {
                                        phi_1731_ = true;
                                    } else {
                                        if (_e1138 == _e1086) {
                                            phi_1730_ = (_e1142 < _e1090);
                                        } else {
                                            phi_1730_ = false;
                                        }
                                        let _e1168 = phi_1730_;
                                        phi_1731_ = _e1168;
                                    }
                                    let _e1170 = phi_1731_;
                                    if _e1170 {
                                        phi_1735_ = _e1090;
                                        phi_1736_ = _e1086;
                                        phi_1737_ = _e1142;
                                        phi_1738_ = _e1138;
                                    } else {
                                        phi_1735_ = _e1142;
                                        phi_1736_ = _e1138;
                                        phi_1737_ = _e1090;
                                        phi_1738_ = _e1086;
                                    }
                                    let _e1172 = phi_1735_;
                                    let _e1174 = phi_1736_;
                                    let _e1176 = phi_1737_;
                                    let _e1178 = phi_1738_;
                                    let _e1181 = ((_e1178 * _e1172) - (_e1176 * _e1174));
                                    if _e1170 {
                                        phi_1746_ = -(_e1181);
                                    } else {
                                        phi_1746_ = _e1181;
                                    }
                                    let _e1184 = phi_1746_;
                                    if (_e1086 < _e1112) {
                                        phi_1757_ = true;
                                    } else {
                                        if (_e1086 == _e1112) {
                                            phi_1756_ = (_e1090 < _e1116);
                                        } else {
                                            phi_1756_ = false;
                                        }
                                        let _e1189 = phi_1756_;
                                        phi_1757_ = _e1189;
                                    }
                                    let _e1191 = phi_1757_;
                                    if _e1191 {
                                        phi_1761_ = _e1116;
                                        phi_1762_ = _e1112;
                                        phi_1763_ = _e1090;
                                        phi_1764_ = _e1086;
                                    } else {
                                        phi_1761_ = _e1090;
                                        phi_1762_ = _e1086;
                                        phi_1763_ = _e1116;
                                        phi_1764_ = _e1112;
                                    }
                                    let _e1193 = phi_1761_;
                                    let _e1195 = phi_1762_;
                                    let _e1197 = phi_1763_;
                                    let _e1199 = phi_1764_;
                                    let _e1202 = ((_e1199 * _e1193) - (_e1197 * _e1195));
                                    if _e1191 {
                                        phi_1772_ = -(_e1202);
                                    } else {
                                        phi_1772_ = _e1202;
                                    }
                                    let _e1205 = phi_1772_;
                                    if (_e1163 >= 0f) {
                                        if (_e1184 >= 0f) {
                                            if (_e1205 >= 0f) {
                                                phi_1787_ = ((_e1163 + _e1184) + _e1205);
                                                phi_1788_ = false;
                                            } else {
                                                phi_1787_ = f32();
                                                phi_1788_ = true;
                                            }
                                            let _e1212 = phi_1787_;
                                            let _e1214 = phi_1788_;
                                            phi_1789_ = _e1212;
                                            phi_1790_ = _e1214;
                                        } else {
                                            phi_1789_ = f32();
                                            phi_1790_ = true;
                                        }
                                        let _e1216 = phi_1789_;
                                        let _e1218 = phi_1790_;
                                        phi_1791_ = _e1216;
                                        phi_1792_ = _e1218;
                                    } else {
                                        phi_1791_ = f32();
                                        phi_1792_ = true;
                                    }
                                    let _e1220 = phi_1791_;
                                    let _e1222 = phi_1792_;
                                    if _e1222 {
                                        if (_e1163 <= 0f) {
                                            if (_e1184 <= 0f) {
                                                let _e1225 = (_e1205 <= 0f);
                                                if _e1225 {
                                                }
                                                phi_1810_ = ((_e1163 + _e1184) + _e1205);
                                                phi_1811_ = false;
                                                phi_1812_ = _e1225;
                                            } else {
                                                phi_1810_ = f32();
                                                phi_1811_ = true;
                                                phi_1812_ = false;
                                            }
                                            let _e1229 = phi_1810_;
                                            let _e1231 = phi_1811_;
                                            let _e1233 = phi_1812_;
                                            phi_1813_ = _e1229;
                                            phi_1814_ = _e1231;
                                            phi_1815_ = _e1233;
                                        } else {
                                            phi_1813_ = f32();
                                            phi_1814_ = true;
                                            phi_1815_ = false;
                                        }
                                        let _e1235 = phi_1813_;
                                        let _e1237 = phi_1814_;
                                        let _e1239 = phi_1815_;
                                        if _e1237 {
                                            phi_1819_ = false;
                                        } else {
                                            phi_1819_ = _e1239;
                                        }
                                        let _e1241 = phi_1819_;
                                        phi_1820_ = _e1235;
                                        phi_1821_ = _e1241;
                                    } else {
                                        phi_1820_ = _e1220;
                                        phi_1821_ = true;
                                    }
                                    let _e1243 = phi_1820_;
                                    let _e1245 = phi_1821_;
                                    if _e1245 {
                                        let _e1246 = (_e1243 == 0f);
                                        if _e1246 {
                                            phi_2137_ = lt_bvh_triangle_Intersection();
                                            phi_2138_ = false;
                                        } else {
                                            let _e1248 = triangles.member[(0u + _e1059)].v0_;
                                            let _e1250 = (_e1248.x - _e217);
                                            let _e1252 = (_e1248.y - _e219);
                                            let _e1254 = (_e1248.z - _e221);
                                            if (_e445 == 0u) {
                                                phi_1850_ = vec3<f32>(_e1252, _e1254, _e1250);
                                            } else {
                                                if (_e445 == 1u) {
                                                    phi_1849_ = vec3<f32>(_e1254, _e1250, _e1252);
                                                } else {
                                                    phi_1849_ = (_e1248 - vec3<f32>(_e217, _e219, _e221));
                                                }
                                                let _e1262 = phi_1849_;
                                                phi_1850_ = _e1262;
                                            }
                                            let _e1264 = phi_1850_;
                                            let _e1266 = triangles.member[(0u + _e1059)].v1_;
                                            let _e1268 = triangles.member[(0u + _e1059)].v0_;
                                            let _e1271 = (_e1266.x - _e1268.x);
                                            let _e1274 = (_e1266.y - _e1268.y);
                                            let _e1277 = (_e1266.z - _e1268.z);
                                            if (_e445 == 0u) {
                                                phi_1876_ = vec3<f32>(_e1274, _e1277, _e1271);
                                            } else {
                                                if (_e445 == 1u) {
                                                    phi_1875_ = vec3<f32>(_e1277, _e1271, _e1274);
                                                } else {
                                                    phi_1875_ = (_e1266 - _e1268);
                                                }
                                                let _e1284 = phi_1875_;
                                                phi_1876_ = _e1284;
                                            }
                                            let _e1286 = phi_1876_;
                                            let _e1288 = triangles.member[(0u + _e1059)].v2_;
                                            let _e1290 = triangles.member[(0u + _e1059)].v0_;
                                            let _e1293 = (_e1288.x - _e1290.x);
                                            let _e1296 = (_e1288.y - _e1290.y);
                                            let _e1299 = (_e1288.z - _e1290.z);
                                            if (_e445 == 0u) {
                                                phi_1902_ = vec3<f32>(_e1296, _e1299, _e1293);
                                            } else {
                                                if (_e445 == 1u) {
                                                    phi_1901_ = vec3<f32>(_e1299, _e1293, _e1296);
                                                } else {
                                                    phi_1901_ = (_e1288 - _e1290);
                                                }
                                                let _e1306 = phi_1901_;
                                                phi_1902_ = _e1306;
                                            }
                                            let _e1308 = phi_1902_;
                                            let _e1315 = ((_e1286.y * _e1308.z) - (_e1286.z * _e1308.y));
                                            let _e1322 = ((_e1286.z * _e1308.x) - (_e1286.x * _e1308.z));
                                            let _e1329 = ((_e1286.x * _e1308.y) - (_e1286.y * _e1308.x));
                                            let _e1343 = (((1f / _e453.z) * (((_e1315 * _e1264.x) + (_e1322 * _e1264.y)) + (_e1329 * _e1264.z))) / (((_e1315 * _e456) + (_e1322 * _e459)) + _e1329));
                                            if (_e1343 > 0f) {
                                                if (_e1343 < _e225) {
                                                    let _e1347 = triangles.member[(0u + _e1059)].v0_;
                                                    let _e1349 = triangles.member[(0u + _e1059)].v1_;
                                                    if (_e1347.x < _e1349.x) {
                                                        phi_1958_ = _e1347.x;
                                                    } else {
                                                        phi_1958_ = _e1349.x;
                                                    }
                                                    let _e1356 = phi_1958_;
                                                    if (_e1347.y < _e1349.y) {
                                                        phi_1967_ = _e1347.y;
                                                    } else {
                                                        phi_1967_ = _e1349.y;
                                                    }
                                                    let _e1363 = phi_1967_;
                                                    if (_e1347.z < _e1349.z) {
                                                        phi_1976_ = _e1347.z;
                                                    } else {
                                                        phi_1976_ = _e1349.z;
                                                    }
                                                    let _e1370 = phi_1976_;
                                                    let _e1372 = triangles.member[(0u + _e1059)].v2_;
                                                    if (_e1356 < _e1372.x) {
                                                        phi_1985_ = _e1356;
                                                    } else {
                                                        phi_1985_ = _e1372.x;
                                                    }
                                                    let _e1377 = phi_1985_;
                                                    if (_e1363 < _e1372.y) {
                                                        phi_1992_ = _e1363;
                                                    } else {
                                                        phi_1992_ = _e1372.y;
                                                    }
                                                    let _e1382 = phi_1992_;
                                                    if (_e1370 < _e1372.z) {
                                                        phi_1999_ = _e1370;
                                                    } else {
                                                        phi_1999_ = _e1372.z;
                                                    }
                                                    let _e1387 = phi_1999_;
                                                    let _e1389 = triangles.member[(0u + _e1059)].v0_;
                                                    let _e1391 = triangles.member[(0u + _e1059)].v1_;
                                                    if (_e1389.x > _e1391.x) {
                                                        phi_2012_ = _e1389.x;
                                                    } else {
                                                        phi_2012_ = _e1391.x;
                                                    }
                                                    let _e1398 = phi_2012_;
                                                    if (_e1389.y > _e1391.y) {
                                                        phi_2021_ = _e1389.y;
                                                    } else {
                                                        phi_2021_ = _e1391.y;
                                                    }
                                                    let _e1405 = phi_2021_;
                                                    if (_e1389.z > _e1391.z) {
                                                        phi_2030_ = _e1389.z;
                                                    } else {
                                                        phi_2030_ = _e1391.z;
                                                    }
                                                    let _e1412 = phi_2030_;
                                                    let _e1414 = triangles.member[(0u + _e1059)].v2_;
                                                    if (_e1398 > _e1414.x) {
                                                        phi_2039_ = _e1398;
                                                    } else {
                                                        phi_2039_ = _e1414.x;
                                                    }
                                                    let _e1419 = phi_2039_;
                                                    if (_e1405 > _e1414.y) {
                                                        phi_2046_ = _e1405;
                                                    } else {
                                                        phi_2046_ = _e1414.y;
                                                    }
                                                    let _e1424 = phi_2046_;
                                                    if (_e1412 > _e1414.z) {
                                                        phi_2053_ = _e1412;
                                                    } else {
                                                        phi_2053_ = _e1414.z;
                                                    }
                                                    let _e1429 = phi_2053_;
                                                    let _e1433 = ((_e1377 - _e217) * _e374);
                                                    let _e1434 = ((_e1382 - _e219) * _e384);
                                                    let _e1435 = ((_e1387 - _e221) * _e394);
                                                    let _e1439 = ((_e1419 - _e217) * _e374);
                                                    let _e1440 = ((_e1424 - _e219) * _e384);
                                                    let _e1441 = ((_e1429 - _e221) * _e394);
                                                    if (_e1433 < _e1439) {
                                                        phi_2070_ = _e1433;
                                                    } else {
                                                        phi_2070_ = _e1439;
                                                    }
                                                    let _e1444 = phi_2070_;
                                                    if (_e1434 < _e1440) {
                                                        phi_2075_ = _e1434;
                                                    } else {
                                                        phi_2075_ = _e1440;
                                                    }
                                                    let _e1447 = phi_2075_;
                                                    if (_e1435 < _e1441) {
                                                        phi_2080_ = _e1435;
                                                    } else {
                                                        phi_2080_ = _e1441;
                                                    }
                                                    let _e1450 = phi_2080_;
                                                    if (_e1433 > _e1439) {
                                                        phi_2088_ = _e1433;
                                                    } else {
                                                        phi_2088_ = _e1439;
                                                    }
                                                    let _e1456 = phi_2088_;
                                                    if (_e1434 > _e1440) {
                                                        phi_2093_ = _e1434;
                                                    } else {
                                                        phi_2093_ = _e1440;
                                                    }
                                                    let _e1459 = phi_2093_;
                                                    if (_e1435 > _e1441) {
                                                        phi_2098_ = _e1435;
                                                    } else {
                                                        phi_2098_ = _e1441;
                                                    }
                                                    let _e1462 = phi_2098_;
                                                    let _e1466 = core_intrinsics_maximum_number_nsz_f32_((_e1444 - _e429), (_e1447 - _e430));
                                                    let _e1467 = core_intrinsics_maximum_number_nsz_f32_(_e1466, (_e1450 - _e431));
                                                    let _e1468 = core_intrinsics_minimum_number_nsz_f32_((_e1456 + _e429), (_e1459 + _e430));
                                                    let _e1469 = core_intrinsics_minimum_number_nsz_f32_(_e1468, (_e1462 + _e431));
                                                    if (_e1467 > -300000000000000000000000000000000000000f) {
                                                        phi_2110_ = _e1467;
                                                    } else {
                                                        phi_2110_ = -300000000000000000000000000000000000000f;
                                                    }
                                                    let _e1472 = phi_2110_;
                                                    if (_e1469 < 300000000000000000000000000000000000000f) {
                                                        phi_2115_ = _e1469;
                                                    } else {
                                                        phi_2115_ = 300000000000000000000000000000000000000f;
                                                    }
                                                    let _e1475 = phi_2115_;
                                                    if (_e1343 < _e1472) {
                                                        phi_2120_ = _e1472;
                                                    } else {
                                                        phi_2120_ = _e1343;
                                                    }
                                                    let _e1478 = phi_2120_;
                                                    if (_e1478 > _e1475) {
                                                        phi_2125_ = _e1475;
                                                    } else {
                                                        phi_2125_ = _e1478;
                                                    }
                                                    let _e1481 = phi_2125_;
                                                    phi_2130_ = lt_bvh_triangle_Intersection(_e1481, (_e1184 / _e1243), (_e1205 / _e1243), (_e1472 <= _e1475));
                                                    phi_2131_ = false;
                                                } else {
                                                    phi_2130_ = lt_bvh_triangle_Intersection();
                                                    phi_2131_ = true;
                                                }
                                                let _e1487 = phi_2130_;
                                                let _e1489 = phi_2131_;
                                                phi_2132_ = _e1487;
                                                phi_2133_ = _e1489;
                                            } else {
                                                phi_2132_ = lt_bvh_triangle_Intersection();
                                                phi_2133_ = true;
                                            }
                                            let _e1491 = phi_2132_;
                                            let _e1493 = phi_2133_;
                                            if _e1493 {
                                            }
                                            phi_2137_ = _e1491;
                                            phi_2138_ = _e1493;
                                        }
                                        let _e1495 = phi_2137_;
                                        let _e1497 = phi_2138_;
                                        phi_2139_ = _e1495;
                                        phi_2140_ = _e1246;
                                        phi_2141_ = _e1497;
                                    } else {
                                        phi_2139_ = lt_bvh_triangle_Intersection();
                                        phi_2140_ = true;
                                        phi_2141_ = false;
                                    }
                                    let _e1499 = phi_2139_;
                                    let _e1501 = phi_2140_;
                                    let _e1503 = phi_2141_;
                                    if _e1501 {
                                        phi_2145_ = true;
                                    } else {
                                        phi_2145_ = _e1503;
                                    }
                                    let _e1505 = phi_2145_;
                                    if _e1505 {
                                        phi_2149_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                    } else {
                                        phi_2149_ = _e1499;
                                    }
                                    let _e1507 = phi_2149_;
                                    if _e1507.is_hit {
                                        if (_e1507.t > 0f) {
                                            if (_e1507.t < _e225) {
                                                let _e1514 = triangles.member[(0u + _e1059)].i0_;
                                                if ((_e1514 & 2147483648u) == 0u) {
                                                    phi_2368_ = true;
                                                } else {
                                                    if (_e1059 < _e81) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1523 = triangles.member[(0u + _e1059)].i0_;
                                                    let _e1524 = (_e1523 & 2147483647u);
                                                    let _e1526 = triangles.member[(0u + _e1059)].i1_;
                                                    let _e1528 = triangles.member[(0u + _e1059)].i2_;
                                                    if (_e1524 < _e87) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1532 = vertices.member[(0u + _e1524)];
                                                    if (_e1526 < _e87) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1536 = vertices.member[(0u + _e1526)];
                                                    if (_e1528 < _e87) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1540 = vertices.member[(0u + _e1528)];
                                                    let _e1541 = array<abi_Vertex, 3>(_e1532, _e1536, _e1540);
                                                    if (_e1541[0].material < arrayLength((&materials.member))) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1547 = materials.member[(0u + _e1541[0].material)];
                                                    if ((_e1547.flags & 1u) == 1u) {
                                                        let _e1552 = ((1f - _e1507.u) - _e1507.v);
                                                        if (_e1547.cutoff <= 0f) {
                                                            phi_2366_ = true;
                                                        } else {
                                                            let _e1579 = (_e1547.base_color.w * ((((f32((_e1541[0].color >> bitcast<u32>(24i))) * _e1552) + (f32((_e1541[1].color >> bitcast<u32>(24i))) * _e1507.u)) + (f32((_e1541[2].color >> bitcast<u32>(24i))) * _e1507.v)) * (1f / 255f)));
                                                            if (_e1547.alpha_size == 0u) {
                                                                phi_2363_ = _e1579;
                                                            } else {
                                                                local.offset = _e1547.alpha_offset;
                                                                local.size = _e1547.alpha_size;
                                                                local.flags = _e1547.flags;
                                                                let _e1610 = _lt_shaders_texture_TextureView_quad((&local), (((_e1541[0].u * _e1552) + (_e1541[1].u * _e1507.u)) + (_e1541[2].u * _e1507.v)), (((_e1541[0].v * _e1552) + (_e1541[1].v * _e1507.u)) + (_e1541[2].v * _e1507.v)));
                                                                let _e1614 = (_e1610.indices[0] >> bitcast<u32>(2i));
                                                                if (_e1614 < _e93) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1618 = alpha_texels.member[(0u + _e1614)];
                                                                let _e1634 = (_e1610.indices[1] >> bitcast<u32>(2i));
                                                                if (_e1634 < _e93) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1638 = alpha_texels.member[(0u + _e1634)];
                                                                let _e1655 = (_e1610.indices[2] >> bitcast<u32>(2i));
                                                                if (_e1655 < _e93) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1659 = alpha_texels.member[(0u + _e1655)];
                                                                let _e1676 = (_e1610.indices[3] >> bitcast<u32>(2i));
                                                                if (_e1676 < _e93) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1680 = alpha_texels.member[(0u + _e1676)];
                                                                phi_2363_ = (_e1579 * (((((f32(((_e1618 >> bitcast<u32>((((_e1610.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1610.weights.x) + ((f32(((_e1638 >> bitcast<u32>((((_e1610.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1610.weights.y)) + ((f32(((_e1659 >> bitcast<u32>((((_e1610.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1610.weights.z)) + ((f32(((_e1680 >> bitcast<u32>((((_e1610.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1610.weights.w)));
                                                            }
                                                            let _e1696 = phi_2363_;
                                                            phi_2366_ = (_e1696 >= _e1547.cutoff);
                                                        }
                                                        let _e1700 = phi_2366_;
                                                        phi_2367_ = _e1700;
                                                    } else {
                                                        phi_2367_ = false;
                                                    }
                                                    let _e1702 = phi_2367_;
                                                    phi_2368_ = _e1702;
                                                }
                                                let _e1704 = phi_2368_;
                                                if _e1704 {
                                                    phi_2372_ = false;
                                                } else {
                                                    phi_2372_ = true;
                                                }
                                                let _e1706 = phi_2372_;
                                                phi_2373_ = _e1704;
                                                phi_2374_ = _e1704;
                                                phi_2375_ = _e1706;
                                            } else {
                                                phi_2373_ = bool();
                                                phi_2374_ = _e1050;
                                                phi_2375_ = true;
                                            }
                                            let _e1708 = phi_2373_;
                                            let _e1710 = phi_2374_;
                                            let _e1712 = phi_2375_;
                                            phi_2376_ = _e1708;
                                            phi_2377_ = _e1710;
                                            phi_2378_ = _e1712;
                                        } else {
                                            phi_2376_ = bool();
                                            phi_2377_ = _e1050;
                                            phi_2378_ = true;
                                        }
                                        let _e1714 = phi_2376_;
                                        let _e1716 = phi_2377_;
                                        let _e1718 = phi_2378_;
                                        phi_2379_ = _e1714;
                                        phi_2380_ = _e1716;
                                        phi_2381_ = _e1718;
                                    } else {
                                        phi_2379_ = bool();
                                        phi_2380_ = _e1050;
                                        phi_2381_ = true;
                                    }
                                    let _e1720 = phi_2379_;
                                    let _e1722 = phi_2380_;
                                    let _e1724 = phi_2381_;
                                    if _e1724 {
                                    }
                                    phi_1579_ = (_e1048 & (_e1048 - 1u));
                                    phi_1582_ = _e1722;
                                    phi_2385_ = _e1720;
                                    phi_2386_ = _e1724;
                                }
                                let _e1726 = phi_1579_;
                                let _e1728 = phi_1582_;
                                let _e1730 = phi_2385_;
                                let _e1732 = phi_2386_;
                                local_9 = _e1730;
                                continue;
                                continuing {
                                    phi_1578_ = _e1726;
                                    phi_1581_ = _e1728;
                                    break if !(_e1732);
                                }
                            }
                            let _e1735 = local_6;
                            if _e1735 {
                                let _e1737 = local_1.group_mask;
                                if ((_e1737 & 4278190080u) == 0u) {
                                    let _e1741 = local_1.len;
                                    if (_e1741 == 0u) {
                                        phi_2428_ = false;
                                    } else {
                                        let _e1745 = local_1.len;
                                        local_1.len = (_e1745 - 1u);
                                        let _e1748 = local_1.len;
                                        if (_e1748 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e1753 = local_1.first[(0u + _e1748)];
                                        local_1.group = _e1753;
                                        let _e1756 = local_1.len;
                                        if (_e1756 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e1761 = local_1.mask[(0u + _e1756)];
                                        local_1.group_mask = _e1761;
                                        phi_2428_ = true;
                                    }
                                    let _e1764 = phi_2428_;
                                    phi_2429_ = _e1764;
                                } else {
                                    phi_2429_ = true;
                                }
                                let _e1766 = phi_2429_;
                                if _e1766 {
                                    let _e1768 = local_1.group_mask;
                                    let _e1774 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1768)), 32u, (_e1768 == 0u)));
                                    let _e1778 = local_1.group_mask;
                                    let _e1792 = local_1.group_mask;
                                    local_1.group_mask = (_e1792 & ~((1u << bitcast<u32>((_e1774 & 31u)))));
                                    let _e1795 = local_1.group;
                                    phi_2460_ = (_e1795 + countOneBits(((_e1778 & ~((4294967295u << bitcast<u32>((((_e1774 - 24u) ^ _e472) & 31u))))) & 255u)));
                                } else {
                                    phi_2460_ = 4294967295u;
                                }
                                let _e1798 = phi_2460_;
                                phi_2461_ = _e1798;
                            } else {
                                phi_2461_ = u32();
                            }
                            let _e1800 = phi_2461_;
                            phi_1247_ = _e1800;
                            let _e2012 = local_8;
                            phi_1250_ = _e2012;
                            let _e2015 = local_9;
                            phi_2462_ = _e2015;
                            let _e2018 = local_10;
                            phi_2463_ = _e2018;
                            phi_2464_ = false;
                        } else {
                            phi_1247_ = u32();
                            phi_1250_ = bool();
                            phi_2462_ = bool();
                            phi_2463_ = false;
                            phi_2464_ = true;
                        }
                        let _e1802 = phi_1247_;
                        let _e1804 = phi_1250_;
                        let _e1806 = phi_2462_;
                        let _e1808 = phi_2463_;
                        let _e1810 = phi_2464_;
                        local_7 = _e1810;
                        local_11 = _e1806;
                        continue;
                        continuing {
                            phi_1246_ = _e1802;
                            phi_1249_ = _e1804;
                            break if !(_e1808);
                        }
                    }
                    let _e1813 = local_7;
                    if _e1813 {
                        phi_2468_ = false;
                    } else {
                        phi_2468_ = true;
                    }
                    let _e1815 = phi_2468_;
                    if _e1815 {
                        let _e2024 = local_11;
                        phi_2472_ = _e2024;
                    } else {
                        let _e2026 = local_12;
                        phi_2472_ = _e2026;
                    }
                    let _e1817 = phi_2472_;
                    phi_2473_ = _e1817;
                }
                let _e1819 = phi_2473_;
                phi_2474_ = _e1819;
                phi_2475_ = _e298;
            } else {
                phi_2474_ = bool();
                phi_2475_ = true;
            }
            let _e1821 = phi_2474_;
            let _e1823 = phi_2475_;
            if _e1823 {
                phi_2479_ = false;
            } else {
                phi_2479_ = _e1821;
            }
            let _e1825 = phi_2479_;
            if _e1825 {
                phi_2483_ = 0f;
            } else {
                phi_2483_ = 1f;
            }
            let _e1827 = phi_2483_;
            phi_2484_ = _e1827;
        }
        let _e1829 = phi_2484_;
        if (_e99.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e99.first_primitive)] = _e1829;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_resolve_resolve_all_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
