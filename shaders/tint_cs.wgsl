struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    number: u32,
    mask_words: u32,
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

struct type_21 {
    member: array<abi_Sample>,
}

struct type_25 {
    member: array<f32>,
}

struct evaluate_Verdict {
    visibility: f32,
    is_doubted: bool,
}

struct u0028_evaluate_Verdict_u0020_bool_u0029_ {
    unnamed: evaluate_Verdict,
    unnamed_1: bool,
}

struct type_37 {
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

struct lt_math_LightProjection {
    row_x: vec4<f32>,
    row_y: vec4<f32>,
    row_z: vec4<f32>,
    row_w: vec4<f32>,
}

struct abi_ShadowParams {
    projection: lt_math_LightProjection,
    light: abi_LightParams,
    test: vec4<f32>,
    size: vec2<u32>,
    map_size: u32,
    epsilon: f32,
    root: u32,
    level_count: u32,
    pad0_: u32,
    pad1_: u32,
}

struct type_44 {
    member: abi_ShadowParams,
}

struct lt_bvh_Node {
    frame: vec4<u32>,
    links: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    z: vec4<u32>,
}

struct type_48 {
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

struct type_52 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_56 {
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

struct type_60 {
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
var<storage> samples: type_21;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_44;
@group(0) @binding(2) 
var<storage> nodes: type_48;
@group(0) @binding(3) 
var<storage> triangles: type_52;
@group(0) @binding(4) 
var<storage> visibility: type_25;
@group(0) @binding(5) 
var<storage, read_write> tints: type_37;
@group(0) @binding(6) 
var<storage> vertices: type_56;
@group(0) @binding(7) 
var<storage> materials: type_60;
@group(0) @binding(8) 
var<storage> alpha_texels: type_9;
@group(0) @binding(9) 
var<storage> color_texels: type_9;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_225_: lt_bvh_traverse_Tree;
    var phi_226_: bool;
    var phi_227_: lt_bvh_traverse_Tree;
    var phi_228_: bool;
    var phi_233_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_225_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_226_ = false;
        } else {
            phi_225_ = lt_bvh_traverse_Tree();
            phi_226_ = true;
        }
        let _e86 = phi_225_;
        let _e88 = phi_226_;
        phi_227_ = _e86;
        phi_228_ = _e88;
    } else {
        phi_227_ = lt_bvh_traverse_Tree();
        phi_228_ = true;
    }
    let _e90 = phi_227_;
    let _e92 = phi_228_;
    if _e92 {
        phi_233_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_233_ = _e90;
    }
    let _e97 = phi_233_;
    return lt_bvh_traverse_Tree(_e97.root, _e97.first_primitive);
}

fn _lt_shaders_texture_TextureView_quad(param_3: ptr<function, texture_TextureView>, param_4: f32, param_5: f32) -> texture_TexelQuad {
    var phi_2508_: f32;
    var phi_2513_: f32;
    var phi_2514_: bool;
    var phi_2515_: f32;
    var phi_2516_: bool;
    var phi_2520_: f32;
    var phi_2546_: f32;
    var phi_2551_: f32;
    var phi_2552_: bool;
    var phi_2553_: f32;
    var phi_2554_: bool;
    var phi_2558_: f32;
    var phi_2566_: f32;
    var phi_2567_: f32;
    var phi_2568_: f32;
    var phi_2577_: f32;
    var phi_2578_: f32;
    var phi_2596_: u32;
    var phi_2610_: u32;
    var phi_2617_: u32;
    var phi_2622_: u32;
    var phi_2628_: u32;
    var phi_2633_: u32;
    var phi_2635_: texture_Axis;
    var phi_2663_: f32;
    var phi_2668_: f32;
    var phi_2669_: bool;
    var phi_2670_: f32;
    var phi_2671_: bool;
    var phi_2675_: f32;
    var phi_2701_: f32;
    var phi_2706_: f32;
    var phi_2707_: bool;
    var phi_2708_: f32;
    var phi_2709_: bool;
    var phi_2713_: f32;
    var phi_2721_: f32;
    var phi_2722_: f32;
    var phi_2723_: f32;
    var phi_2732_: f32;
    var phi_2733_: f32;
    var phi_2751_: u32;
    var phi_2765_: u32;
    var phi_2772_: u32;
    var phi_2777_: u32;
    var phi_2783_: u32;
    var phi_2788_: u32;
    var phi_2790_: texture_Axis;

    let _e77 = (*param_3).size;
    let _e78 = (_e77 & 65535u);
    let _e80 = (*param_3).size;
    let _e82 = (_e80 >> bitcast<u32>(16i));
    let _e84 = (*param_3).flags;
    let _e86 = ((_e84 & 4u) != 0u);
    let _e88 = (*param_3).flags;
    let _e91 = ((_e88 >> bitcast<u32>(4u)) & 3u);
    if (_e91 == 0u) {
        if (param_4 > -8388608f) {
            let _e104 = f32(select(0i, select(select(i32(param_4), i32(-2147483648), (param_4 < bitcast<f32>(3472883712u))), 2147483647i, (param_4 > bitcast<f32>(1325400063u))), (param_4 == param_4)));
            if (_e104 > param_4) {
                phi_2508_ = 1f;
            } else {
                phi_2508_ = 0f;
            }
            let _e107 = phi_2508_;
            if (param_4 < 8388608f) {
                phi_2513_ = (_e104 - _e107);
                phi_2514_ = false;
            } else {
                phi_2513_ = f32();
                phi_2514_ = true;
            }
            let _e110 = phi_2513_;
            let _e112 = phi_2514_;
            phi_2515_ = _e110;
            phi_2516_ = _e112;
        } else {
            phi_2515_ = f32();
            phi_2516_ = true;
        }
        let _e114 = phi_2515_;
        let _e116 = phi_2516_;
        if _e116 {
            phi_2520_ = param_4;
        } else {
            phi_2520_ = _e114;
        }
        let _e118 = phi_2520_;
        phi_2568_ = (param_4 - _e118);
    } else {
        if (_e91 == 1u) {
            let _e121 = (param_4 * 0.5f);
            if (_e121 > -8388608f) {
                let _e133 = f32(select(0i, select(select(i32(_e121), i32(-2147483648), (_e121 < bitcast<f32>(3472883712u))), 2147483647i, (_e121 > bitcast<f32>(1325400063u))), (_e121 == _e121)));
                if (_e133 > _e121) {
                    phi_2546_ = 1f;
                } else {
                    phi_2546_ = 0f;
                }
                let _e136 = phi_2546_;
                if (_e121 < 8388608f) {
                    phi_2551_ = (_e133 - _e136);
                    phi_2552_ = false;
                } else {
                    phi_2551_ = f32();
                    phi_2552_ = true;
                }
                let _e139 = phi_2551_;
                let _e141 = phi_2552_;
                phi_2553_ = _e139;
                phi_2554_ = _e141;
            } else {
                phi_2553_ = f32();
                phi_2554_ = true;
            }
            let _e143 = phi_2553_;
            let _e145 = phi_2554_;
            if _e145 {
                phi_2558_ = _e121;
            } else {
                phi_2558_ = _e143;
            }
            let _e147 = phi_2558_;
            let _e149 = (param_4 - (2f * _e147));
            if (_e149 > 1f) {
                phi_2566_ = (2f - _e149);
            } else {
                phi_2566_ = _e149;
            }
            let _e153 = phi_2566_;
            phi_2567_ = _e153;
        } else {
            phi_2567_ = param_4;
        }
        let _e155 = phi_2567_;
        phi_2568_ = _e155;
    }
    let _e157 = phi_2568_;
    if (_e157 > 0f) {
        if (_e157 < 1f) {
            phi_2577_ = _e157;
        } else {
            phi_2577_ = 1f;
        }
        let _e161 = phi_2577_;
        phi_2578_ = _e161;
    } else {
        phi_2578_ = 0f;
    }
    let _e163 = phi_2578_;
    let _e164 = (_e78 - 1u);
    let _e166 = (_e163 * f32(_e78));
    if _e86 {
        let _e173 = select(select(u32(_e166), 0u, (_e166 < bitcast<f32>(0u))), 4294967295u, (_e166 > bitcast<f32>(1333788671u)));
        if (_e164 < _e173) {
            phi_2596_ = _e164;
        } else {
            phi_2596_ = _e173;
        }
        let _e176 = phi_2596_;
        phi_2635_ = texture_Axis(_e176, _e176, 0f);
    } else {
        let _e178 = (_e166 + 0.5f);
        let _e185 = select(select(u32(_e178), 0u, (_e178 < bitcast<f32>(0u))), 4294967295u, (_e178 > bitcast<f32>(1333788671u)));
        if (_e78 < _e185) {
            phi_2610_ = _e78;
        } else {
            phi_2610_ = _e185;
        }
        let _e188 = phi_2610_;
        if (_e91 == 0u) {
            phi_2617_ = _e164;
        } else {
            phi_2617_ = 0u;
        }
        let _e193 = phi_2617_;
        if (_e91 == 0u) {
            phi_2622_ = 0u;
        } else {
            phi_2622_ = _e164;
        }
        let _e196 = phi_2622_;
        if (_e188 == 0u) {
            phi_2628_ = _e193;
        } else {
            phi_2628_ = (_e188 - 1u);
        }
        let _e200 = phi_2628_;
        if (_e188 > _e164) {
            phi_2633_ = _e196;
        } else {
            phi_2633_ = _e188;
        }
        let _e203 = phi_2633_;
        phi_2635_ = texture_Axis(_e200, _e203, (_e178 - f32(_e188)));
    }
    let _e206 = phi_2635_;
    let _e208 = (*param_3).flags;
    let _e211 = ((_e208 >> bitcast<u32>(6u)) & 3u);
    if (_e211 == 0u) {
        if (param_5 > -8388608f) {
            let _e224 = f32(select(0i, select(select(i32(param_5), i32(-2147483648), (param_5 < bitcast<f32>(3472883712u))), 2147483647i, (param_5 > bitcast<f32>(1325400063u))), (param_5 == param_5)));
            if (_e224 > param_5) {
                phi_2663_ = 1f;
            } else {
                phi_2663_ = 0f;
            }
            let _e227 = phi_2663_;
            if (param_5 < 8388608f) {
                phi_2668_ = (_e224 - _e227);
                phi_2669_ = false;
            } else {
                phi_2668_ = f32();
                phi_2669_ = true;
            }
            let _e230 = phi_2668_;
            let _e232 = phi_2669_;
            phi_2670_ = _e230;
            phi_2671_ = _e232;
        } else {
            phi_2670_ = f32();
            phi_2671_ = true;
        }
        let _e234 = phi_2670_;
        let _e236 = phi_2671_;
        if _e236 {
            phi_2675_ = param_5;
        } else {
            phi_2675_ = _e234;
        }
        let _e238 = phi_2675_;
        phi_2723_ = (param_5 - _e238);
    } else {
        if (_e211 == 1u) {
            let _e241 = (param_5 * 0.5f);
            if (_e241 > -8388608f) {
                let _e253 = f32(select(0i, select(select(i32(_e241), i32(-2147483648), (_e241 < bitcast<f32>(3472883712u))), 2147483647i, (_e241 > bitcast<f32>(1325400063u))), (_e241 == _e241)));
                if (_e253 > _e241) {
                    phi_2701_ = 1f;
                } else {
                    phi_2701_ = 0f;
                }
                let _e256 = phi_2701_;
                if (_e241 < 8388608f) {
                    phi_2706_ = (_e253 - _e256);
                    phi_2707_ = false;
                } else {
                    phi_2706_ = f32();
                    phi_2707_ = true;
                }
                let _e259 = phi_2706_;
                let _e261 = phi_2707_;
                phi_2708_ = _e259;
                phi_2709_ = _e261;
            } else {
                phi_2708_ = f32();
                phi_2709_ = true;
            }
            let _e263 = phi_2708_;
            let _e265 = phi_2709_;
            if _e265 {
                phi_2713_ = _e241;
            } else {
                phi_2713_ = _e263;
            }
            let _e267 = phi_2713_;
            let _e269 = (param_5 - (2f * _e267));
            if (_e269 > 1f) {
                phi_2721_ = (2f - _e269);
            } else {
                phi_2721_ = _e269;
            }
            let _e273 = phi_2721_;
            phi_2722_ = _e273;
        } else {
            phi_2722_ = param_5;
        }
        let _e275 = phi_2722_;
        phi_2723_ = _e275;
    }
    let _e277 = phi_2723_;
    if (_e277 > 0f) {
        if (_e277 < 1f) {
            phi_2732_ = _e277;
        } else {
            phi_2732_ = 1f;
        }
        let _e281 = phi_2732_;
        phi_2733_ = _e281;
    } else {
        phi_2733_ = 0f;
    }
    let _e283 = phi_2733_;
    let _e284 = (_e82 - 1u);
    let _e286 = (_e283 * f32(_e82));
    if _e86 {
        let _e293 = select(select(u32(_e286), 0u, (_e286 < bitcast<f32>(0u))), 4294967295u, (_e286 > bitcast<f32>(1333788671u)));
        if (_e284 < _e293) {
            phi_2751_ = _e284;
        } else {
            phi_2751_ = _e293;
        }
        let _e296 = phi_2751_;
        phi_2790_ = texture_Axis(_e296, _e296, 0f);
    } else {
        let _e298 = (_e286 + 0.5f);
        let _e305 = select(select(u32(_e298), 0u, (_e298 < bitcast<f32>(0u))), 4294967295u, (_e298 > bitcast<f32>(1333788671u)));
        if (_e82 < _e305) {
            phi_2765_ = _e82;
        } else {
            phi_2765_ = _e305;
        }
        let _e308 = phi_2765_;
        if (_e211 == 0u) {
            phi_2772_ = _e284;
        } else {
            phi_2772_ = 0u;
        }
        let _e313 = phi_2772_;
        if (_e211 == 0u) {
            phi_2777_ = 0u;
        } else {
            phi_2777_ = _e284;
        }
        let _e316 = phi_2777_;
        if (_e308 == 0u) {
            phi_2783_ = _e313;
        } else {
            phi_2783_ = (_e308 - 1u);
        }
        let _e320 = phi_2783_;
        if (_e308 > _e284) {
            phi_2788_ = _e316;
        } else {
            phi_2788_ = _e308;
        }
        let _e323 = phi_2788_;
        phi_2790_ = texture_Axis(_e320, _e323, (_e298 - f32(_e308)));
    }
    let _e326 = phi_2790_;
    let _e330 = (*param_3).offset;
    let _e337 = (*param_3).offset;
    let _e344 = (*param_3).offset;
    let _e351 = (*param_3).offset;
    return texture_TexelQuad(array<u32, 4>(((_e330 + (_e326.low * _e78)) + _e206.low), ((_e337 + (_e326.low * _e78)) + _e206.high), ((_e344 + (_e326.high * _e78)) + _e206.low), ((_e351 + (_e326.high * _e78)) + _e206.high)), vec4<f32>(((1f - _e206.fraction) * (1f - _e326.fraction)), (_e206.fraction * (1f - _e326.fraction)), ((1f - _e206.fraction) * _e326.fraction), (_e206.fraction * _e326.fraction)));
}

fn core_intrinsics_minimum_number_nsz_f32_(param_6: f32, param_7: f32) -> f32 {
    var phi_2462_: bool;
    var phi_2466_: f32;

    if (param_6 != param_6) {
        phi_2462_ = true;
    } else {
        let _e76 = (param_7 <= param_6);
        if _e76 {
        }
        phi_2462_ = _e76;
    }
    let _e78 = phi_2462_;
    if _e78 {
        phi_2466_ = param_7;
    } else {
        phi_2466_ = param_6;
    }
    let _e80 = phi_2466_;
    return _e80;
}

fn core_intrinsics_maximum_number_nsz_f32_(param_8: f32, param_9: f32) -> f32 {
    var phi_2446_: bool;
    var phi_2450_: f32;

    if (param_8 != param_8) {
        phi_2446_ = true;
    } else {
        let _e76 = (param_9 >= param_8);
        if _e76 {
        }
        phi_2446_ = _e76;
    }
    let _e78 = phi_2446_;
    if _e78 {
        phi_2450_ = param_9;
    } else {
        phi_2450_ = param_8;
    }
    let _e80 = phi_2450_;
    return _e80;
}

fn function_() {
    var local: texture_TextureView;
    var local_1: texture_TextureView;
    var local_2: lt_bvh_traverse_Stack;
    var phi_324_: bool;
    var phi_325_: bool;
    var phi_326_: bool;
    var phi_327_: bool;
    var phi_331_: bool;
    var phi_401_: bool;
    var phi_402_: bool;
    var phi_413_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_414_: bool;
    var phi_415_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_416_: bool;
    var phi_423_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_427_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_430_: bool;
    var phi_463_: f32;
    var phi_490_: bool;
    var phi_491_: bool;
    var phi_492_: bool;
    var phi_493_: bool;
    var phi_497_: bool;
    var phi_510_: bool;
    var phi_511_: bool;
    var phi_512_: bool;
    var phi_513_: bool;
    var phi_517_: bool;
    var phi_530_: bool;
    var phi_531_: bool;
    var phi_532_: bool;
    var phi_536_: bool;
    var phi_537_: bool;
    var phi_538_: bool;
    var phi_539_: bool;
    var phi_540_: bool;
    var phi_544_: bool;
    var phi_614_: f32;
    var phi_621_: f32;
    var phi_628_: f32;
    var phi_635_: f32;
    var phi_642_: f32;
    var phi_649_: f32;
    var phi_666_: f32;
    var phi_671_: f32;
    var phi_676_: f32;
    var phi_681_: f32;
    var phi_686_: f32;
    var phi_712_: bool;
    var phi_713_: bool;
    var phi_721_: u32;
    var phi_722_: u32;
    var phi_733_: vec3<f32>;
    var phi_734_: vec3<f32>;
    var phi_747_: u32;
    var phi_752_: u32;
    var phi_757_: u32;
    var phi_871_: bool;
    var phi_872_: bool;
    var phi_903_: u32;
    var phi_905_: u32;
    var phi_908_: vec3<f32>;
    var phi_988_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1015_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1042_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1048_: u32;
    var phi_1051_: u32;
    var phi_1065_: u32;
    var phi_1075_: u32;
    var phi_1085_: u32;
    var phi_1103_: u32;
    var phi_1113_: u32;
    var phi_1123_: u32;
    var phi_1159_: u32;
    var phi_1172_: u32;
    var phi_1177_: u32;
    var phi_1178_: u32;
    var phi_1179_: u32;
    var phi_1049_: u32;
    var phi_1052_: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_1237_: u32;
    var phi_1240_: vec3<f32>;
    var phi_1284_: vec3<f32>;
    var phi_1285_: vec3<f32>;
    var phi_1314_: vec3<f32>;
    var phi_1315_: vec3<f32>;
    var phi_1344_: vec3<f32>;
    var phi_1345_: vec3<f32>;
    var phi_1363_: bool;
    var phi_1364_: bool;
    var phi_1368_: f32;
    var phi_1369_: f32;
    var phi_1370_: f32;
    var phi_1371_: f32;
    var phi_1379_: f32;
    var phi_1389_: bool;
    var phi_1390_: bool;
    var phi_1394_: f32;
    var phi_1395_: f32;
    var phi_1396_: f32;
    var phi_1397_: f32;
    var phi_1405_: f32;
    var phi_1415_: bool;
    var phi_1416_: bool;
    var phi_1420_: f32;
    var phi_1421_: f32;
    var phi_1422_: f32;
    var phi_1423_: f32;
    var phi_1431_: f32;
    var phi_1446_: f32;
    var phi_1447_: bool;
    var phi_1448_: f32;
    var phi_1449_: bool;
    var phi_1450_: f32;
    var phi_1451_: bool;
    var phi_1469_: f32;
    var phi_1470_: bool;
    var phi_1471_: bool;
    var phi_1472_: f32;
    var phi_1473_: bool;
    var phi_1474_: bool;
    var phi_1478_: bool;
    var phi_1479_: f32;
    var phi_1480_: bool;
    var phi_1508_: vec3<f32>;
    var phi_1509_: vec3<f32>;
    var phi_1534_: vec3<f32>;
    var phi_1535_: vec3<f32>;
    var phi_1560_: vec3<f32>;
    var phi_1561_: vec3<f32>;
    var phi_1617_: f32;
    var phi_1626_: f32;
    var phi_1635_: f32;
    var phi_1644_: f32;
    var phi_1651_: f32;
    var phi_1658_: f32;
    var phi_1671_: f32;
    var phi_1680_: f32;
    var phi_1689_: f32;
    var phi_1698_: f32;
    var phi_1705_: f32;
    var phi_1712_: f32;
    var phi_1729_: f32;
    var phi_1734_: f32;
    var phi_1739_: f32;
    var phi_1747_: f32;
    var phi_1752_: f32;
    var phi_1757_: f32;
    var phi_1769_: f32;
    var phi_1774_: f32;
    var phi_1779_: f32;
    var phi_1784_: f32;
    var phi_1789_: lt_bvh_triangle_Intersection;
    var phi_1790_: bool;
    var phi_1791_: lt_bvh_triangle_Intersection;
    var phi_1792_: bool;
    var phi_1796_: lt_bvh_triangle_Intersection;
    var phi_1797_: bool;
    var phi_1798_: lt_bvh_triangle_Intersection;
    var phi_1799_: bool;
    var phi_1800_: bool;
    var phi_1804_: bool;
    var phi_1808_: lt_bvh_triangle_Intersection;
    var phi_2013_: f32;
    var phi_2025_: f32;
    var phi_2034_: f32;
    var phi_2035_: f32;
    var phi_2036_: f32;
    var phi_2037_: f32;
    var phi_2236_: vec3<f32>;
    var phi_2260_: f32;
    var phi_2261_: f32;
    var phi_2270_: f32;
    var phi_2271_: f32;
    var phi_2280_: f32;
    var phi_2281_: f32;
    var phi_2305_: bool;
    var phi_2306_: bool;
    var phi_2307_: bool;
    var phi_2308_: bool;
    var phi_2312_: bool;
    var phi_2316_: bool;
    var phi_2317_: vec3<f32>;
    var phi_2318_: vec3<f32>;
    var phi_2319_: bool;
    var phi_2320_: vec3<f32>;
    var phi_2321_: vec3<f32>;
    var phi_2322_: bool;
    var phi_2323_: vec3<f32>;
    var phi_2324_: vec3<f32>;
    var phi_2325_: bool;
    var phi_1238_: u32;
    var phi_1241_: vec3<f32>;
    var phi_2329_: vec3<f32>;
    var phi_2330_: bool;
    var local_6: bool;
    var phi_2372_: bool;
    var phi_2373_: bool;
    var phi_2404_: u32;
    var phi_2405_: u32;
    var phi_906_: u32;
    var phi_909_: vec3<f32>;
    var phi_2406_: vec3<f32>;
    var phi_2407_: bool;
    var phi_2408_: bool;
    var local_7: bool;
    var phi_2412_: bool;
    var phi_2416_: vec3<f32>;
    var phi_2417_: vec3<f32>;
    var phi_2418_: vec3<f32>;
    var phi_2419_: bool;
    var phi_2423_: vec3<f32>;
    var phi_2424_: vec3<f32>;
    var local_8: vec3<f32>;
    var local_9: vec3<f32>;
    var local_10: bool;
    var local_11: vec3<f32>;
    var local_12: vec3<f32>;

    let _e76 = id_1;
    let _e83 = arrayLength((&nodes.member));
    let _e86 = arrayLength((&triangles.member));
    let _e95 = arrayLength((&vertices.member));
    let _e101 = arrayLength((&alpha_texels.member));
    let _e104 = arrayLength((&color_texels.member));
    let _e107 = p.member.size[0u];
    let _e109 = p.member.size[1u];
    let _e110 = lt_shaders_entry_pixel_index(_e76, _e107, _e109);
    if (bitcast<i32>(_e110.root) != 0i) {
        if (_e110.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        if (_e110.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        let _e122 = visibility.member[(0u + _e110.first_primitive)];
        if (_e122 > 0f) {
            let _e126 = samples.member[(0u + _e110.first_primitive)].normal[0u];
            let _e128 = global[0u];
            if (_e126 == _e128) {
                let _e131 = samples.member[(0u + _e110.first_primitive)].normal[1u];
                let _e133 = global[1u];
                if (_e131 == _e133) {
                    let _e136 = samples.member[(0u + _e110.first_primitive)].normal[2u];
                    let _e138 = global[2u];
                    phi_324_ = (_e136 == _e138);
                    phi_325_ = false;
                } else {
                    phi_324_ = bool();
                    phi_325_ = true;
                }
                let _e141 = phi_324_;
                let _e143 = phi_325_;
                phi_326_ = _e141;
                phi_327_ = _e143;
            } else {
                phi_326_ = bool();
                phi_327_ = true;
            }
            let _e145 = phi_326_;
            let _e147 = phi_327_;
            if _e147 {
                phi_331_ = false;
            } else {
                phi_331_ = _e145;
            }
            let _e149 = phi_331_;
            if !(_e149) {
                let _e152 = samples.member[(0u + _e110.first_primitive)].position;
                let _e154 = p.member.light.place;
                let _e160 = p.member.light.place[3u];
                let _e167 = (_e154.x - (_e152.x * _e160));
                let _e168 = (_e154.y - (_e152.y * _e160));
                let _e169 = (_e154.z - (_e152.z * _e160));
                let _e171 = samples.member[(0u + _e110.first_primitive)].normal;
                if ((((_e171.x * _e167) + (_e171.y * _e168)) + (_e171.z * _e169)) > 0f) {
                    let _e185 = (((_e167 * _e167) + (_e168 * _e168)) + (_e169 * _e169));
                    let _e187 = p.member.light.axis;
                    let _e199 = p.member.light.place[3u];
                    if (_e199 == 0f) {
                        phi_402_ = true;
                    } else {
                        let _e202 = p.member.light.range_squared;
                        if (_e185 <= _e202) {
                            let _e205 = p.member.light.cos_outer;
                            phi_401_ = (-((((_e167 * _e187.x) + (_e168 * _e187.y)) + (_e169 * _e187.z))) >= (_e205 * sqrt(_e185)));
                        } else {
                            phi_401_ = false;
                        }
                        let _e210 = phi_401_;
                        phi_402_ = _e210;
                    }
                    let _e212 = phi_402_;
                    if _e212 {
                        let _e214 = samples.member[(0u + _e110.first_primitive)].flags;
                        let _e222 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                        let _e228 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e222.unnamed.visibility, false), _e222.unnamed_1);
                        phi_413_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e228.unnamed, ((_e214 & 1u) == 0u));
                        phi_414_ = false;
                    } else {
                        phi_413_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                        phi_414_ = true;
                    }
                    let _e233 = phi_413_;
                    let _e235 = phi_414_;
                    phi_415_ = _e233;
                    phi_416_ = _e235;
                } else {
                    phi_415_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_416_ = true;
                }
                let _e237 = phi_415_;
                let _e239 = phi_416_;
                if _e239 {
                    let _e245 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e251 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e245.unnamed.visibility, false), _e245.unnamed_1);
                    phi_423_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e251.unnamed, true);
                } else {
                    phi_423_ = _e237;
                }
                let _e256 = phi_423_;
                phi_427_ = _e256;
            } else {
                let _e262 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e268 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e262.unnamed.visibility, false), _e262.unnamed_1);
                phi_427_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e268.unnamed, true);
            }
            let _e273 = phi_427_;
            phi_430_ = !(_e273.unnamed_1);
        } else {
            phi_430_ = false;
        }
        let _e277 = phi_430_;
        if _e277 {
            let _e279 = samples.member[(0u + _e110.first_primitive)].position;
            let _e281 = samples.member[(0u + _e110.first_primitive)].normal;
            let _e283 = samples.member[(0u + _e110.first_primitive)].magnitude;
            let _e285 = ((8f / 8388608f) * _e283);
            let _e293 = (_e279.x + (_e281.x * _e285));
            let _e295 = (_e279.y + (_e281.y * _e285));
            let _e297 = (_e279.z + (_e281.z * _e285));
            let _e299 = p.member.light.place;
            if (_e299.w == 0f) {
                phi_463_ = 300000000000000000000000000000000000000f;
            } else {
                phi_463_ = 1f;
            }
            let _e303 = phi_463_;
            let _e311 = (_e299.x - (_e293 * _e299.w));
            let _e312 = (_e299.y - (_e295 * _e299.w));
            let _e313 = (_e299.z - (_e297 * _e299.w));
            let _e315 = abs(_e311);
            let _e316 = abs(_e312);
            let _e317 = abs(_e313);
            if (abs(_e293) < 1000000000000000f) {
                if (abs(_e295) < 1000000000000000f) {
                    phi_490_ = (abs(_e297) < 1000000000000000f);
                    phi_491_ = false;
                } else {
                    phi_490_ = bool();
                    phi_491_ = true;
                }
                let _e325 = phi_490_;
                let _e327 = phi_491_;
                phi_492_ = _e325;
                phi_493_ = _e327;
            } else {
                phi_492_ = bool();
                phi_493_ = true;
            }
            let _e329 = phi_492_;
            let _e331 = phi_493_;
            if _e331 {
                phi_497_ = false;
            } else {
                phi_497_ = _e329;
            }
            let _e333 = phi_497_;
            if _e333 {
                if (_e315 < 1000000000000000f) {
                    if (_e316 < 1000000000000000f) {
                        phi_510_ = (_e317 < 1000000000000000f);
                        phi_511_ = false;
                    } else {
                        phi_510_ = bool();
                        phi_511_ = true;
                    }
                    let _e338 = phi_510_;
                    let _e340 = phi_511_;
                    phi_512_ = _e338;
                    phi_513_ = _e340;
                } else {
                    phi_512_ = bool();
                    phi_513_ = true;
                }
                let _e342 = phi_512_;
                let _e344 = phi_513_;
                if _e344 {
                    phi_517_ = false;
                } else {
                    phi_517_ = _e342;
                }
                let _e346 = phi_517_;
                if _e346 {
                    if (_e315 > 0f) {
                        phi_531_ = bool();
                        phi_532_ = true;
                    } else {
                        let _e348 = (_e316 > 0f);
                        if _e348 {
                            phi_530_ = bool();
                        } else {
                            phi_530_ = (_e317 > 0f);
                        }
                        let _e351 = phi_530_;
                        phi_531_ = _e351;
                        phi_532_ = _e348;
                    }
                    let _e353 = phi_531_;
                    let _e355 = phi_532_;
                    if _e355 {
                        phi_536_ = true;
                    } else {
                        phi_536_ = _e353;
                    }
                    let _e357 = phi_536_;
                    phi_537_ = _e357;
                    phi_538_ = false;
                } else {
                    phi_537_ = bool();
                    phi_538_ = true;
                }
                let _e359 = phi_537_;
                let _e361 = phi_538_;
                phi_539_ = _e359;
                phi_540_ = _e361;
            } else {
                phi_539_ = bool();
                phi_540_ = true;
            }
            let _e363 = phi_539_;
            let _e365 = phi_540_;
            if _e365 {
                phi_544_ = false;
            } else {
                phi_544_ = _e363;
            }
            let _e367 = phi_544_;
            if _e367 {
                let _e368 = (0u >= _e83);
                if _e368 {
                    phi_2417_ = vec3<f32>();
                } else {
                    if (0u < _e83) {
                    } else {
                        return;
                    }
                    let _e374 = nodes.member[(0u + 0u)].frame[0u];
                    let _e378 = nodes.member[(0u + 0u)].frame[1u];
                    let _e382 = nodes.member[(0u + 0u)].frame[2u];
                    let _e386 = nodes.member[(0u + 0u)].frame[0u];
                    let _e390 = nodes.member[(0u + 0u)].frame[1u];
                    let _e394 = nodes.member[(0u + 0u)].frame[2u];
                    let _e398 = nodes.member[(0u + 0u)].frame[3u];
                    let _e432 = core_intrinsics_maximum_number_nsz_f32_(abs(_e311), abs(_e312));
                    let _e433 = core_intrinsics_maximum_number_nsz_f32_(_e432, abs(_e313));
                    let _e434 = (_e433 * 0.0000000000009094947f);
                    if (abs(_e311) < _e434) {
                        phi_614_ = _e434;
                    } else {
                        phi_614_ = abs(_e311);
                    }
                    let _e439 = phi_614_;
                    if (_e311 < 0f) {
                        phi_621_ = (-1f / _e439);
                    } else {
                        phi_621_ = (1f / _e439);
                    }
                    let _e444 = phi_621_;
                    if (abs(_e312) < _e434) {
                        phi_628_ = _e434;
                    } else {
                        phi_628_ = abs(_e312);
                    }
                    let _e449 = phi_628_;
                    if (_e312 < 0f) {
                        phi_635_ = (-1f / _e449);
                    } else {
                        phi_635_ = (1f / _e449);
                    }
                    let _e454 = phi_635_;
                    if (abs(_e313) < _e434) {
                        phi_642_ = _e434;
                    } else {
                        phi_642_ = abs(_e313);
                    }
                    let _e459 = phi_642_;
                    if (_e313 < 0f) {
                        phi_649_ = (-1f / _e459);
                    } else {
                        phi_649_ = (1f / _e459);
                    }
                    let _e464 = phi_649_;
                    let _e468 = abs((bitcast<f32>(_e374) - _e293));
                    let _e469 = abs((bitcast<f32>(_e378) - _e295));
                    let _e470 = abs((bitcast<f32>(_e382) - _e297));
                    let _e474 = abs(((bitcast<f32>(_e386) + (bitcast<f32>((((_e398 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e293));
                    let _e475 = abs(((bitcast<f32>(_e390) + (bitcast<f32>((((_e398 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e295));
                    let _e476 = abs(((bitcast<f32>(_e394) + (bitcast<f32>((((_e398 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e297));
                    if (_e468 > _e474) {
                        phi_666_ = _e468;
                    } else {
                        phi_666_ = _e474;
                    }
                    let _e479 = phi_666_;
                    if (_e469 > _e475) {
                        phi_671_ = _e469;
                    } else {
                        phi_671_ = _e475;
                    }
                    let _e482 = phi_671_;
                    if (_e470 > _e476) {
                        phi_676_ = _e470;
                    } else {
                        phi_676_ = _e476;
                    }
                    let _e485 = phi_676_;
                    if (_e479 > _e482) {
                        phi_681_ = _e479;
                    } else {
                        phi_681_ = _e482;
                    }
                    let _e488 = phi_681_;
                    if (_e488 > _e485) {
                        phi_686_ = _e488;
                    } else {
                        phi_686_ = _e485;
                    }
                    let _e491 = phi_686_;
                    let _e495 = (_e491 * 0.0000019073486f);
                    let _e496 = (abs(_e444) * _e495);
                    let _e497 = (abs(_e454) * _e495);
                    let _e498 = (abs(_e464) * _e495);
                    let _e502 = (_e491 * 0.0000009536743f);
                    let _e503 = (abs(_e444) * _e502);
                    let _e504 = (abs(_e454) * _e502);
                    let _e505 = (abs(_e464) * _e502);
                    let _e506 = abs(_e311);
                    let _e507 = abs(_e312);
                    let _e508 = abs(_e313);
                    if (_e506 >= _e507) {
                        if (_e506 >= _e508) {
                            phi_712_ = false;
                        } else {
                            phi_712_ = true;
                        }
                        let _e512 = phi_712_;
                        phi_713_ = _e512;
                    } else {
                        phi_713_ = true;
                    }
                    let _e514 = phi_713_;
                    if _e514 {
                        if (_e507 >= _e508) {
                            phi_721_ = 1u;
                        } else {
                            phi_721_ = 2u;
                        }
                        let _e517 = phi_721_;
                        phi_722_ = _e517;
                    } else {
                        phi_722_ = 0u;
                    }
                    let _e519 = phi_722_;
                    if (_e519 == 0u) {
                        phi_734_ = vec3<f32>(_e312, _e313, _e311);
                    } else {
                        if (_e519 == 1u) {
                            phi_733_ = vec3<f32>(_e313, _e311, _e312);
                        } else {
                            phi_733_ = vec3<f32>(_e311, _e312, _e313);
                        }
                        let _e525 = phi_733_;
                        phi_734_ = _e525;
                    }
                    let _e527 = phi_734_;
                    let _e530 = (_e527.x / _e527.z);
                    let _e533 = (_e527.y / _e527.z);
                    if (_e444 < 0f) {
                        phi_747_ = 0u;
                    } else {
                        phi_747_ = 1u;
                    }
                    let _e538 = phi_747_;
                    if (_e454 < 0f) {
                        phi_752_ = 0u;
                    } else {
                        phi_752_ = 2u;
                    }
                    let _e541 = phi_752_;
                    if (_e464 < 0f) {
                        phi_757_ = 0u;
                    } else {
                        phi_757_ = 4u;
                    }
                    let _e544 = phi_757_;
                    let _e546 = ((_e538 | _e541) | _e544);
                    let _e547 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                    local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e547.first[0], _e547.first[1], _e547.first[2], _e547.first[3], _e547.first[4], _e547.first[5], _e547.first[6], _e547.first[7], _e547.first[8], _e547.first[9], _e547.first[10], _e547.first[11], _e547.first[12], _e547.first[13], _e547.first[14], _e547.first[15], _e547.first[16], _e547.first[17], _e547.first[18], _e547.first[19], _e547.first[20], _e547.first[21], _e547.first[22], _e547.first[23], _e547.first[24], _e547.first[25], _e547.first[26], _e547.first[27], _e547.first[28], _e547.first[29], _e547.first[30], _e547.first[31]), array<u32, 32>(_e547.mask[0], _e547.mask[1], _e547.mask[2], _e547.mask[3], _e547.mask[4], _e547.mask[5], _e547.mask[6], _e547.mask[7], _e547.mask[8], _e547.mask[9], _e547.mask[10], _e547.mask[11], _e547.mask[12], _e547.mask[13], _e547.mask[14], _e547.mask[15], _e547.mask[16], _e547.mask[17], _e547.mask[18], _e547.mask[19], _e547.mask[20], _e547.mask[21], _e547.mask[22], _e547.mask[23], _e547.mask[24], _e547.mask[25], _e547.mask[26], _e547.mask[27], _e547.mask[28], _e547.mask[29], _e547.mask[30], _e547.mask[31]), _e547.len, _e547.group, _e547.group_mask);
                    let _e621 = local_2.group_mask;
                    if ((_e621 & 4278190080u) == 0u) {
                        let _e625 = local_2.len;
                        if (_e625 == 0u) {
                            phi_871_ = false;
                        } else {
                            let _e629 = local_2.len;
                            local_2.len = (_e629 - 1u);
                            let _e632 = local_2.len;
                            if (_e632 < 32u) {
                            } else {
                                return;
                            }
                            let _e637 = local_2.first[(0u + _e632)];
                            local_2.group = _e637;
                            let _e640 = local_2.len;
                            if (_e640 < 32u) {
                            } else {
                                return;
                            }
                            let _e645 = local_2.mask[(0u + _e640)];
                            local_2.group_mask = _e645;
                            phi_871_ = true;
                        }
                        let _e648 = phi_871_;
                        phi_872_ = _e648;
                    } else {
                        phi_872_ = true;
                    }
                    let _e650 = phi_872_;
                    if _e650 {
                        let _e652 = local_2.group_mask;
                        let _e658 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e652)), 32u, (_e652 == 0u)));
                        let _e662 = local_2.group_mask;
                        let _e676 = local_2.group_mask;
                        local_2.group_mask = (_e676 & ~((1u << bitcast<u32>((_e658 & 31u)))));
                        let _e679 = local_2.group;
                        phi_903_ = (_e679 + countOneBits(((_e662 & ~((4294967295u << bitcast<u32>((((_e658 - 24u) ^ 7u) & 31u))))) & 255u)));
                    } else {
                        phi_903_ = 4294967295u;
                    }
                    let _e682 = phi_903_;
                    phi_905_ = _e682;
                    phi_908_ = vec3<f32>(1f, 1f, 1f);
                    loop {
                        let _e684 = phi_905_;
                        let _e686 = phi_908_;
                        local_12 = _e686;
                        if (_e684 != 4294967295u) {
                            if (_e684 < _e83) {
                            } else {
                                return;
                            }
                            let _e693 = nodes.member[(0u + _e684)].frame[3u];
                            let _e718 = (bitcast<f32>((((_e693 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e444);
                            let _e719 = (bitcast<f32>((((_e693 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e454);
                            let _e720 = (bitcast<f32>((((_e693 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e464);
                            let _e723 = nodes.member[(0u + _e684)].frame[0u];
                            let _e727 = nodes.member[(0u + _e684)].frame[1u];
                            let _e731 = nodes.member[(0u + _e684)].frame[2u];
                            let _e736 = ((bitcast<f32>(_e723) - _e293) * _e444);
                            let _e737 = ((bitcast<f32>(_e727) - _e295) * _e454);
                            let _e738 = ((bitcast<f32>(_e731) - _e297) * _e464);
                            let _e746 = nodes.member[(0u + _e684)].x;
                            if (_e444 < 0f) {
                                let _e757 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e746.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e763 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e757.unnamed.root, _e746.w), _e757.unnamed_1);
                                let _e769 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e763.unnamed, lt_bvh_traverse_Tree(_e746.x, _e763.unnamed_1.first_primitive));
                                phi_988_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e769.unnamed, lt_bvh_traverse_Tree(_e769.unnamed_1.root, _e746.y));
                            } else {
                                let _e785 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e746.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e791 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e785.unnamed.root, _e746.y), _e785.unnamed_1);
                                let _e797 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e791.unnamed, lt_bvh_traverse_Tree(_e746.z, _e791.unnamed_1.first_primitive));
                                phi_988_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e797.unnamed, lt_bvh_traverse_Tree(_e797.unnamed_1.root, _e746.w));
                            }
                            let _e805 = phi_988_;
                            let _e815 = nodes.member[(0u + _e684)].y;
                            if (_e454 < 0f) {
                                let _e826 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e815.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e832 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e826.unnamed.root, _e815.w), _e826.unnamed_1);
                                let _e838 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e832.unnamed, lt_bvh_traverse_Tree(_e815.x, _e832.unnamed_1.first_primitive));
                                phi_1015_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e838.unnamed, lt_bvh_traverse_Tree(_e838.unnamed_1.root, _e815.y));
                            } else {
                                let _e854 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e815.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e860 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e854.unnamed.root, _e815.y), _e854.unnamed_1);
                                let _e866 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e860.unnamed, lt_bvh_traverse_Tree(_e815.z, _e860.unnamed_1.first_primitive));
                                phi_1015_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e866.unnamed, lt_bvh_traverse_Tree(_e866.unnamed_1.root, _e815.w));
                            }
                            let _e874 = phi_1015_;
                            let _e884 = nodes.member[(0u + _e684)].z;
                            if (_e464 < 0f) {
                                let _e895 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e884.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e901 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e895.unnamed.root, _e884.w), _e895.unnamed_1);
                                let _e907 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e901.unnamed, lt_bvh_traverse_Tree(_e884.x, _e901.unnamed_1.first_primitive));
                                phi_1042_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e907.unnamed, lt_bvh_traverse_Tree(_e907.unnamed_1.root, _e884.y));
                            } else {
                                let _e923 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e884.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e929 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e923.unnamed.root, _e884.y), _e923.unnamed_1);
                                let _e935 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e929.unnamed, lt_bvh_traverse_Tree(_e884.z, _e929.unnamed_1.first_primitive));
                                phi_1042_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e935.unnamed, lt_bvh_traverse_Tree(_e935.unnamed_1.root, _e884.w));
                            }
                            let _e943 = phi_1042_;
                            phi_1048_ = 0u;
                            phi_1051_ = 0u;
                            loop {
                                let _e953 = phi_1048_;
                                let _e955 = phi_1051_;
                                local_3 = _e955;
                                local_4 = _e955;
                                local_5 = _e955;
                                let _e956 = (_e953 < 8u);
                                if _e956 {
                                    let _e958 = (_e953 >> bitcast<u32>(2i));
                                    let _e959 = (_e953 & 3u);
                                    if (_e958 == 0u) {
                                        phi_1065_ = _e805.unnamed.root;
                                    } else {
                                        phi_1065_ = _e805.unnamed.first_primitive;
                                    }
                                    let _e962 = phi_1065_;
                                    if (_e958 == 0u) {
                                        phi_1075_ = _e874.unnamed.root;
                                    } else {
                                        phi_1075_ = _e874.unnamed.first_primitive;
                                    }
                                    let _e971 = phi_1075_;
                                    if (_e958 == 0u) {
                                        phi_1085_ = _e943.unnamed.root;
                                    } else {
                                        phi_1085_ = _e943.unnamed.first_primitive;
                                    }
                                    let _e980 = phi_1085_;
                                    let _e993 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e962 >> bitcast<u32>(((_e959 * 8u) & 31u))) & 255u)) * _e718) + (_e736 - _e496)), ((f32(((_e971 >> bitcast<u32>(((_e959 * 8u) & 31u))) & 255u)) * _e719) + (_e737 - _e497)));
                                    let _e994 = core_intrinsics_maximum_number_nsz_f32_(_e993, ((f32(((_e980 >> bitcast<u32>(((_e959 * 8u) & 31u))) & 255u)) * _e720) + (_e738 - _e498)));
                                    if (_e958 == 0u) {
                                        phi_1103_ = _e805.unnamed_1.root;
                                    } else {
                                        phi_1103_ = _e805.unnamed_1.first_primitive;
                                    }
                                    let _e997 = phi_1103_;
                                    if (_e958 == 0u) {
                                        phi_1113_ = _e874.unnamed_1.root;
                                    } else {
                                        phi_1113_ = _e874.unnamed_1.first_primitive;
                                    }
                                    let _e1006 = phi_1113_;
                                    if (_e958 == 0u) {
                                        phi_1123_ = _e943.unnamed_1.root;
                                    } else {
                                        phi_1123_ = _e943.unnamed_1.first_primitive;
                                    }
                                    let _e1015 = phi_1123_;
                                    let _e1028 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e997 >> bitcast<u32>(((_e959 * 8u) & 31u))) & 255u)) * _e718) + (_e736 + _e496)), ((f32(((_e1006 >> bitcast<u32>(((_e959 * 8u) & 31u))) & 255u)) * _e719) + (_e737 + _e497)));
                                    let _e1029 = core_intrinsics_minimum_number_nsz_f32_(_e1028, ((f32(((_e1015 >> bitcast<u32>(((_e959 * 8u) & 31u))) & 255u)) * _e720) + (_e738 + _e498)));
                                    if (_e994 <= _e1029) {
                                        if (_e994 <= _e303) {
                                            if (_e1029 >= 0f) {
                                                if (_e958 == 0u) {
                                                    let _e1036 = nodes.member[(0u + _e684)].links[2u];
                                                    phi_1159_ = _e1036;
                                                } else {
                                                    let _e1039 = nodes.member[(0u + _e684)].links[3u];
                                                    phi_1159_ = _e1039;
                                                }
                                                let _e1041 = phi_1159_;
                                                let _e1046 = ((_e1041 >> bitcast<u32>(((_e959 * 8u) & 31u))) & 255u);
                                                let _e1047 = (_e1046 & 31u);
                                                if (_e1047 >= 24u) {
                                                    phi_1172_ = (24u + ((_e1047 - 24u) ^ _e546));
                                                } else {
                                                    phi_1172_ = _e1047;
                                                }
                                                let _e1053 = phi_1172_;
                                                phi_1177_ = (_e955 | ((_e1046 >> bitcast<u32>(5i)) << bitcast<u32>((_e1053 & 31u))));
                                            } else {
                                                phi_1177_ = _e955;
                                            }
                                            let _e1061 = phi_1177_;
                                            phi_1178_ = _e1061;
                                        } else {
                                            phi_1178_ = _e955;
                                        }
                                        let _e1063 = phi_1178_;
                                        phi_1179_ = _e1063;
                                    } else {
                                        phi_1179_ = _e955;
                                    }
                                    let _e1065 = phi_1179_;
                                    phi_1049_ = (_e953 + 1u);
                                    phi_1052_ = _e1065;
                                } else {
                                    phi_1049_ = u32();
                                    phi_1052_ = u32();
                                }
                                let _e1068 = phi_1049_;
                                let _e1070 = phi_1052_;
                                continue;
                                continuing {
                                    phi_1048_ = _e1068;
                                    phi_1051_ = _e1070;
                                    break if !(_e956);
                                }
                            }
                            let _e1074 = nodes.member[(0u + _e684)].links[0u];
                            let _e1078 = nodes.member[(0u + _e684)].frame[3u];
                            let _e1082 = local_3;
                            if ((_e1082 & 4278190080u) == 0u) {
                            } else {
                                let _e1086 = local_2.group_mask;
                                if ((_e1086 & 4278190080u) == 0u) {
                                } else {
                                    let _e1090 = local_2.len;
                                    if (_e1090 < 32u) {
                                        let _e1093 = local_2.group;
                                        let _e1095 = local_2.len;
                                        if (_e1095 < 32u) {
                                        } else {
                                            return;
                                        }
                                        local_2.first[(0u + _e1095)] = _e1093;
                                        let _e1101 = local_2.group_mask;
                                        let _e1103 = local_2.len;
                                        if (_e1103 < 32u) {
                                        } else {
                                            return;
                                        }
                                        local_2.mask[(0u + _e1103)] = _e1101;
                                        let _e1110 = local_2.len;
                                        local_2.len = (_e1110 + 1u);
                                    }
                                }
                                local_2.group = (0u + _e1074);
                                let _e1114 = local_4;
                                local_2.group_mask = ((_e1114 & 4278190080u) | (_e1078 >> bitcast<u32>(24i)));
                            }
                            let _e1119 = local_5;
                            phi_1237_ = (_e1119 & 16777215u);
                            phi_1240_ = _e686;
                            loop {
                                let _e1122 = phi_1237_;
                                let _e1124 = phi_1240_;
                                local_8 = _e1124;
                                let _e1125 = (_e1122 == 0u);
                                local_6 = _e1125;
                                local_10 = _e1125;
                                if _e1125 {
                                    phi_1238_ = u32();
                                    phi_1241_ = vec3<f32>();
                                    phi_2329_ = vec3<f32>();
                                    phi_2330_ = false;
                                } else {
                                    let _e1128 = nodes.member[(0u + _e684)].links[1u];
                                    let _e1133 = ((0u + _e1128) + select(firstTrailingBit(_e1122), 32u, (_e1122 == 0u)));
                                    if (_e1133 < _e86) {
                                    } else {
                                        return;
                                    }
                                    let _e1140 = triangles.member[(0u + _e1133)].v0_;
                                    let _e1142 = (_e1140.x - _e293);
                                    let _e1144 = (_e1140.y - _e295);
                                    let _e1146 = (_e1140.z - _e297);
                                    if (_e519 == 0u) {
                                        phi_1285_ = vec3<f32>(_e1144, _e1146, _e1142);
                                    } else {
                                        if (_e519 == 1u) {
                                            phi_1284_ = vec3<f32>(_e1146, _e1142, _e1144);
                                        } else {
                                            phi_1284_ = (_e1140 - vec3<f32>(_e293, _e295, _e297));
                                        }
                                        let _e1154 = phi_1284_;
                                        phi_1285_ = _e1154;
                                    }
                                    let _e1156 = phi_1285_;
                                    let _e1160 = (_e1156.x - (_e530 * _e1156.z));
                                    let _e1164 = (_e1156.y - (_e533 * _e1156.z));
                                    let _e1166 = triangles.member[(0u + _e1133)].v1_;
                                    let _e1168 = (_e1166.x - _e293);
                                    let _e1170 = (_e1166.y - _e295);
                                    let _e1172 = (_e1166.z - _e297);
                                    if (_e519 == 0u) {
                                        phi_1315_ = vec3<f32>(_e1170, _e1172, _e1168);
                                    } else {
                                        if (_e519 == 1u) {
                                            phi_1314_ = vec3<f32>(_e1172, _e1168, _e1170);
                                        } else {
                                            phi_1314_ = (_e1166 - vec3<f32>(_e293, _e295, _e297));
                                        }
                                        let _e1180 = phi_1314_;
                                        phi_1315_ = _e1180;
                                    }
                                    let _e1182 = phi_1315_;
                                    let _e1186 = (_e1182.x - (_e530 * _e1182.z));
                                    let _e1190 = (_e1182.y - (_e533 * _e1182.z));
                                    let _e1192 = triangles.member[(0u + _e1133)].v2_;
                                    let _e1194 = (_e1192.x - _e293);
                                    let _e1196 = (_e1192.y - _e295);
                                    let _e1198 = (_e1192.z - _e297);
                                    if (_e519 == 0u) {
                                        phi_1345_ = vec3<f32>(_e1196, _e1198, _e1194);
                                    } else {
                                        if (_e519 == 1u) {
                                            phi_1344_ = vec3<f32>(_e1198, _e1194, _e1196);
                                        } else {
                                            phi_1344_ = (_e1192 - vec3<f32>(_e293, _e295, _e297));
                                        }
                                        let _e1206 = phi_1344_;
                                        phi_1345_ = _e1206;
                                    }
                                    let _e1208 = phi_1345_;
                                    let _e1212 = (_e1208.x - (_e530 * _e1208.z));
                                    let _e1216 = (_e1208.y - (_e533 * _e1208.z));
                                    if (_e1186 < _e1212) {
                                        phi_1364_ = true;
                                    } else {
                                        if (_e1186 == _e1212) {
                                            phi_1363_ = (_e1190 < _e1216);
                                        } else {
                                            phi_1363_ = false;
                                        }
                                        let _e1221 = phi_1363_;
                                        phi_1364_ = _e1221;
                                    }
                                    let _e1223 = phi_1364_;
                                    if _e1223 {
                                        phi_1368_ = _e1216;
                                        phi_1369_ = _e1212;
                                        phi_1370_ = _e1190;
                                        phi_1371_ = _e1186;
                                    } else {
                                        phi_1368_ = _e1190;
                                        phi_1369_ = _e1186;
                                        phi_1370_ = _e1216;
                                        phi_1371_ = _e1212;
                                    }
                                    let _e1225 = phi_1368_;
                                    let _e1227 = phi_1369_;
                                    let _e1229 = phi_1370_;
                                    let _e1231 = phi_1371_;
                                    let _e1234 = ((_e1231 * _e1225) - (_e1229 * _e1227));
                                    if _e1223 {
                                        phi_1379_ = -(_e1234);
                                    } else {
                                        phi_1379_ = _e1234;
                                    }
                                    let _e1237 = phi_1379_;
                                    if (_e1212 < _e1160) {
                                        phi_1390_ = true;
                                    } else {
                                        if (_e1212 == _e1160) {
                                            phi_1389_ = (_e1216 < _e1164);
                                        } else {
                                            phi_1389_ = false;
                                        }
                                        let _e1242 = phi_1389_;
                                        phi_1390_ = _e1242;
                                    }
                                    let _e1244 = phi_1390_;
                                    if _e1244 {
                                        phi_1394_ = _e1164;
                                        phi_1395_ = _e1160;
                                        phi_1396_ = _e1216;
                                        phi_1397_ = _e1212;
                                    } else {
                                        phi_1394_ = _e1216;
                                        phi_1395_ = _e1212;
                                        phi_1396_ = _e1164;
                                        phi_1397_ = _e1160;
                                    }
                                    let _e1246 = phi_1394_;
                                    let _e1248 = phi_1395_;
                                    let _e1250 = phi_1396_;
                                    let _e1252 = phi_1397_;
                                    let _e1255 = ((_e1252 * _e1246) - (_e1250 * _e1248));
                                    if _e1244 {
                                        phi_1405_ = -(_e1255);
                                    } else {
                                        phi_1405_ = _e1255;
                                    }
                                    let _e1258 = phi_1405_;
                                    if (_e1160 < _e1186) {
                                        phi_1416_ = true;
                                    } else {
                                        if (_e1160 == _e1186) {
                                            phi_1415_ = (_e1164 < _e1190);
                                        } else {
                                            phi_1415_ = false;
                                        }
                                        let _e1263 = phi_1415_;
                                        phi_1416_ = _e1263;
                                    }
                                    let _e1265 = phi_1416_;
                                    if _e1265 {
                                        phi_1420_ = _e1190;
                                        phi_1421_ = _e1186;
                                        phi_1422_ = _e1164;
                                        phi_1423_ = _e1160;
                                    } else {
                                        phi_1420_ = _e1164;
                                        phi_1421_ = _e1160;
                                        phi_1422_ = _e1190;
                                        phi_1423_ = _e1186;
                                    }
                                    let _e1267 = phi_1420_;
                                    let _e1269 = phi_1421_;
                                    let _e1271 = phi_1422_;
                                    let _e1273 = phi_1423_;
                                    let _e1276 = ((_e1273 * _e1267) - (_e1271 * _e1269));
                                    if _e1265 {
                                        phi_1431_ = -(_e1276);
                                    } else {
                                        phi_1431_ = _e1276;
                                    }
                                    let _e1279 = phi_1431_;
                                    if (_e1237 >= 0f) {
                                        if (_e1258 >= 0f) {
                                            if (_e1279 >= 0f) {
                                                phi_1446_ = ((_e1237 + _e1258) + _e1279);
                                                phi_1447_ = false;
                                            } else {
                                                phi_1446_ = f32();
                                                phi_1447_ = true;
                                            }
                                            let _e1286 = phi_1446_;
                                            let _e1288 = phi_1447_;
                                            phi_1448_ = _e1286;
                                            phi_1449_ = _e1288;
                                        } else {
                                            phi_1448_ = f32();
                                            phi_1449_ = true;
                                        }
                                        let _e1290 = phi_1448_;
                                        let _e1292 = phi_1449_;
                                        phi_1450_ = _e1290;
                                        phi_1451_ = _e1292;
                                    } else {
                                        phi_1450_ = f32();
                                        phi_1451_ = true;
                                    }
                                    let _e1294 = phi_1450_;
                                    let _e1296 = phi_1451_;
                                    if _e1296 {
                                        if (_e1237 <= 0f) {
                                            if (_e1258 <= 0f) {
                                                let _e1299 = (_e1279 <= 0f);
                                                if _e1299 {
                                                }
                                                phi_1469_ = ((_e1237 + _e1258) + _e1279);
                                                phi_1470_ = false;
                                                phi_1471_ = _e1299;
                                            } else {
                                                phi_1469_ = f32();
                                                phi_1470_ = true;
                                                phi_1471_ = false;
                                            }
                                            let _e1303 = phi_1469_;
                                            let _e1305 = phi_1470_;
                                            let _e1307 = phi_1471_;
                                            phi_1472_ = _e1303;
                                            phi_1473_ = _e1305;
                                            phi_1474_ = _e1307;
                                        } else {
                                            phi_1472_ = f32();
                                            phi_1473_ = true;
                                            phi_1474_ = false;
                                        }
                                        let _e1309 = phi_1472_;
                                        let _e1311 = phi_1473_;
                                        let _e1313 = phi_1474_;
                                        if _e1311 {
                                            phi_1478_ = false;
                                        } else {
                                            phi_1478_ = _e1313;
                                        }
                                        let _e1315 = phi_1478_;
                                        phi_1479_ = _e1309;
                                        phi_1480_ = _e1315;
                                    } else {
                                        phi_1479_ = _e1294;
                                        phi_1480_ = true;
                                    }
                                    let _e1317 = phi_1479_;
                                    let _e1319 = phi_1480_;
                                    if _e1319 {
                                        let _e1320 = (_e1317 == 0f);
                                        if _e1320 {
                                            phi_1796_ = lt_bvh_triangle_Intersection();
                                            phi_1797_ = false;
                                        } else {
                                            let _e1322 = triangles.member[(0u + _e1133)].v0_;
                                            let _e1324 = (_e1322.x - _e293);
                                            let _e1326 = (_e1322.y - _e295);
                                            let _e1328 = (_e1322.z - _e297);
                                            if (_e519 == 0u) {
                                                phi_1509_ = vec3<f32>(_e1326, _e1328, _e1324);
                                            } else {
                                                if (_e519 == 1u) {
                                                    phi_1508_ = vec3<f32>(_e1328, _e1324, _e1326);
                                                } else {
                                                    phi_1508_ = (_e1322 - vec3<f32>(_e293, _e295, _e297));
                                                }
                                                let _e1336 = phi_1508_;
                                                phi_1509_ = _e1336;
                                            }
                                            let _e1338 = phi_1509_;
                                            let _e1340 = triangles.member[(0u + _e1133)].v1_;
                                            let _e1342 = triangles.member[(0u + _e1133)].v0_;
                                            let _e1345 = (_e1340.x - _e1342.x);
                                            let _e1348 = (_e1340.y - _e1342.y);
                                            let _e1351 = (_e1340.z - _e1342.z);
                                            if (_e519 == 0u) {
                                                phi_1535_ = vec3<f32>(_e1348, _e1351, _e1345);
                                            } else {
                                                if (_e519 == 1u) {
                                                    phi_1534_ = vec3<f32>(_e1351, _e1345, _e1348);
                                                } else {
                                                    phi_1534_ = (_e1340 - _e1342);
                                                }
                                                let _e1358 = phi_1534_;
                                                phi_1535_ = _e1358;
                                            }
                                            let _e1360 = phi_1535_;
                                            let _e1362 = triangles.member[(0u + _e1133)].v2_;
                                            let _e1364 = triangles.member[(0u + _e1133)].v0_;
                                            let _e1367 = (_e1362.x - _e1364.x);
                                            let _e1370 = (_e1362.y - _e1364.y);
                                            let _e1373 = (_e1362.z - _e1364.z);
                                            if (_e519 == 0u) {
                                                phi_1561_ = vec3<f32>(_e1370, _e1373, _e1367);
                                            } else {
                                                if (_e519 == 1u) {
                                                    phi_1560_ = vec3<f32>(_e1373, _e1367, _e1370);
                                                } else {
                                                    phi_1560_ = (_e1362 - _e1364);
                                                }
                                                let _e1380 = phi_1560_;
                                                phi_1561_ = _e1380;
                                            }
                                            let _e1382 = phi_1561_;
                                            let _e1389 = ((_e1360.y * _e1382.z) - (_e1360.z * _e1382.y));
                                            let _e1396 = ((_e1360.z * _e1382.x) - (_e1360.x * _e1382.z));
                                            let _e1403 = ((_e1360.x * _e1382.y) - (_e1360.y * _e1382.x));
                                            let _e1417 = (((1f / _e527.z) * (((_e1389 * _e1338.x) + (_e1396 * _e1338.y)) + (_e1403 * _e1338.z))) / (((_e1389 * _e530) + (_e1396 * _e533)) + _e1403));
                                            if (_e1417 > 0f) {
                                                if (_e1417 < _e303) {
                                                    let _e1421 = triangles.member[(0u + _e1133)].v0_;
                                                    let _e1423 = triangles.member[(0u + _e1133)].v1_;
                                                    if (_e1421.x < _e1423.x) {
                                                        phi_1617_ = _e1421.x;
                                                    } else {
                                                        phi_1617_ = _e1423.x;
                                                    }
                                                    let _e1430 = phi_1617_;
                                                    if (_e1421.y < _e1423.y) {
                                                        phi_1626_ = _e1421.y;
                                                    } else {
                                                        phi_1626_ = _e1423.y;
                                                    }
                                                    let _e1437 = phi_1626_;
                                                    if (_e1421.z < _e1423.z) {
                                                        phi_1635_ = _e1421.z;
                                                    } else {
                                                        phi_1635_ = _e1423.z;
                                                    }
                                                    let _e1444 = phi_1635_;
                                                    let _e1446 = triangles.member[(0u + _e1133)].v2_;
                                                    if (_e1430 < _e1446.x) {
                                                        phi_1644_ = _e1430;
                                                    } else {
                                                        phi_1644_ = _e1446.x;
                                                    }
                                                    let _e1451 = phi_1644_;
                                                    if (_e1437 < _e1446.y) {
                                                        phi_1651_ = _e1437;
                                                    } else {
                                                        phi_1651_ = _e1446.y;
                                                    }
                                                    let _e1456 = phi_1651_;
                                                    if (_e1444 < _e1446.z) {
                                                        phi_1658_ = _e1444;
                                                    } else {
                                                        phi_1658_ = _e1446.z;
                                                    }
                                                    let _e1461 = phi_1658_;
                                                    let _e1463 = triangles.member[(0u + _e1133)].v0_;
                                                    let _e1465 = triangles.member[(0u + _e1133)].v1_;
                                                    if (_e1463.x > _e1465.x) {
                                                        phi_1671_ = _e1463.x;
                                                    } else {
                                                        phi_1671_ = _e1465.x;
                                                    }
                                                    let _e1472 = phi_1671_;
                                                    if (_e1463.y > _e1465.y) {
                                                        phi_1680_ = _e1463.y;
                                                    } else {
                                                        phi_1680_ = _e1465.y;
                                                    }
                                                    let _e1479 = phi_1680_;
                                                    if (_e1463.z > _e1465.z) {
                                                        phi_1689_ = _e1463.z;
                                                    } else {
                                                        phi_1689_ = _e1465.z;
                                                    }
                                                    let _e1486 = phi_1689_;
                                                    let _e1488 = triangles.member[(0u + _e1133)].v2_;
                                                    if (_e1472 > _e1488.x) {
                                                        phi_1698_ = _e1472;
                                                    } else {
                                                        phi_1698_ = _e1488.x;
                                                    }
                                                    let _e1493 = phi_1698_;
                                                    if (_e1479 > _e1488.y) {
                                                        phi_1705_ = _e1479;
                                                    } else {
                                                        phi_1705_ = _e1488.y;
                                                    }
                                                    let _e1498 = phi_1705_;
                                                    if (_e1486 > _e1488.z) {
                                                        phi_1712_ = _e1486;
                                                    } else {
                                                        phi_1712_ = _e1488.z;
                                                    }
                                                    let _e1503 = phi_1712_;
                                                    let _e1507 = ((_e1451 - _e293) * _e444);
                                                    let _e1508 = ((_e1456 - _e295) * _e454);
                                                    let _e1509 = ((_e1461 - _e297) * _e464);
                                                    let _e1513 = ((_e1493 - _e293) * _e444);
                                                    let _e1514 = ((_e1498 - _e295) * _e454);
                                                    let _e1515 = ((_e1503 - _e297) * _e464);
                                                    if (_e1507 < _e1513) {
                                                        phi_1729_ = _e1507;
                                                    } else {
                                                        phi_1729_ = _e1513;
                                                    }
                                                    let _e1518 = phi_1729_;
                                                    if (_e1508 < _e1514) {
                                                        phi_1734_ = _e1508;
                                                    } else {
                                                        phi_1734_ = _e1514;
                                                    }
                                                    let _e1521 = phi_1734_;
                                                    if (_e1509 < _e1515) {
                                                        phi_1739_ = _e1509;
                                                    } else {
                                                        phi_1739_ = _e1515;
                                                    }
                                                    let _e1524 = phi_1739_;
                                                    if (_e1507 > _e1513) {
                                                        phi_1747_ = _e1507;
                                                    } else {
                                                        phi_1747_ = _e1513;
                                                    }
                                                    let _e1530 = phi_1747_;
                                                    if (_e1508 > _e1514) {
                                                        phi_1752_ = _e1508;
                                                    } else {
                                                        phi_1752_ = _e1514;
                                                    }
                                                    let _e1533 = phi_1752_;
                                                    if (_e1509 > _e1515) {
                                                        phi_1757_ = _e1509;
                                                    } else {
                                                        phi_1757_ = _e1515;
                                                    }
                                                    let _e1536 = phi_1757_;
                                                    let _e1540 = core_intrinsics_maximum_number_nsz_f32_((_e1518 - _e503), (_e1521 - _e504));
                                                    let _e1541 = core_intrinsics_maximum_number_nsz_f32_(_e1540, (_e1524 - _e505));
                                                    let _e1542 = core_intrinsics_minimum_number_nsz_f32_((_e1530 + _e503), (_e1533 + _e504));
                                                    let _e1543 = core_intrinsics_minimum_number_nsz_f32_(_e1542, (_e1536 + _e505));
                                                    if (_e1541 > -300000000000000000000000000000000000000f) {
                                                        phi_1769_ = _e1541;
                                                    } else {
                                                        phi_1769_ = -300000000000000000000000000000000000000f;
                                                    }
                                                    let _e1546 = phi_1769_;
                                                    if (_e1543 < 300000000000000000000000000000000000000f) {
                                                        phi_1774_ = _e1543;
                                                    } else {
                                                        phi_1774_ = 300000000000000000000000000000000000000f;
                                                    }
                                                    let _e1549 = phi_1774_;
                                                    if (_e1417 < _e1546) {
                                                        phi_1779_ = _e1546;
                                                    } else {
                                                        phi_1779_ = _e1417;
                                                    }
                                                    let _e1552 = phi_1779_;
                                                    if (_e1552 > _e1549) {
                                                        phi_1784_ = _e1549;
                                                    } else {
                                                        phi_1784_ = _e1552;
                                                    }
                                                    let _e1555 = phi_1784_;
                                                    phi_1789_ = lt_bvh_triangle_Intersection(_e1555, (_e1258 / _e1317), (_e1279 / _e1317), (_e1546 <= _e1549));
                                                    phi_1790_ = false;
                                                } else {
                                                    phi_1789_ = lt_bvh_triangle_Intersection();
                                                    phi_1790_ = true;
                                                }
                                                let _e1561 = phi_1789_;
                                                let _e1563 = phi_1790_;
                                                phi_1791_ = _e1561;
                                                phi_1792_ = _e1563;
                                            } else {
                                                phi_1791_ = lt_bvh_triangle_Intersection();
                                                phi_1792_ = true;
                                            }
                                            let _e1565 = phi_1791_;
                                            let _e1567 = phi_1792_;
                                            if _e1567 {
                                            }
                                            phi_1796_ = _e1565;
                                            phi_1797_ = _e1567;
                                        }
                                        let _e1569 = phi_1796_;
                                        let _e1571 = phi_1797_;
                                        phi_1798_ = _e1569;
                                        phi_1799_ = _e1320;
                                        phi_1800_ = _e1571;
                                    } else {
                                        phi_1798_ = lt_bvh_triangle_Intersection();
                                        phi_1799_ = true;
                                        phi_1800_ = false;
                                    }
                                    let _e1573 = phi_1798_;
                                    let _e1575 = phi_1799_;
                                    let _e1577 = phi_1800_;
                                    if _e1575 {
                                        phi_1804_ = true;
                                    } else {
                                        phi_1804_ = _e1577;
                                    }
                                    let _e1579 = phi_1804_;
                                    if _e1579 {
                                        phi_1808_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                    } else {
                                        phi_1808_ = _e1573;
                                    }
                                    let _e1581 = phi_1808_;
                                    if _e1581.is_hit {
                                        if (_e1581.t > 0f) {
                                            if (_e1581.t < _e303) {
                                                if (_e1133 < _e86) {
                                                } else {
                                                    return;
                                                }
                                                let _e1595 = triangles.member[(0u + _e1133)].i0_;
                                                let _e1596 = (_e1595 & 2147483647u);
                                                let _e1598 = triangles.member[(0u + _e1133)].i1_;
                                                let _e1600 = triangles.member[(0u + _e1133)].i2_;
                                                if (_e1596 < _e95) {
                                                } else {
                                                    return;
                                                }
                                                let _e1604 = vertices.member[(0u + _e1596)];
                                                if (_e1598 < _e95) {
                                                } else {
                                                    return;
                                                }
                                                let _e1608 = vertices.member[(0u + _e1598)];
                                                if (_e1600 < _e95) {
                                                } else {
                                                    return;
                                                }
                                                let _e1612 = vertices.member[(0u + _e1600)];
                                                let _e1613 = array<abi_Vertex, 3>(_e1604, _e1608, _e1612);
                                                if (_e1613[0].material < arrayLength((&materials.member))) {
                                                } else {
                                                    return;
                                                }
                                                let _e1619 = materials.member[(0u + _e1613[0].material)];
                                                let _e1621 = ((1f - _e1581.u) - _e1581.v);
                                                if (_e1619.cutoff <= 0f) {
                                                    phi_2037_ = 1f;
                                                } else {
                                                    let _e1648 = (_e1619.base_color.w * ((((f32((_e1613[0].color >> bitcast<u32>(24i))) * _e1621) + (f32((_e1613[1].color >> bitcast<u32>(24i))) * _e1581.u)) + (f32((_e1613[2].color >> bitcast<u32>(24i))) * _e1581.v)) * (1f / 255f)));
                                                    if (_e1619.alpha_size == 0u) {
                                                        phi_2013_ = _e1648;
                                                    } else {
                                                        local_1.offset = _e1619.alpha_offset;
                                                        local_1.size = _e1619.alpha_size;
                                                        local_1.flags = _e1619.flags;
                                                        let _e1679 = _lt_shaders_texture_TextureView_quad((&local_1), (((_e1613[0].u * _e1621) + (_e1613[1].u * _e1581.u)) + (_e1613[2].u * _e1581.v)), (((_e1613[0].v * _e1621) + (_e1613[1].v * _e1581.u)) + (_e1613[2].v * _e1581.v)));
                                                        let _e1683 = (_e1679.indices[0] >> bitcast<u32>(2i));
                                                        if (_e1683 < _e101) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1687 = alpha_texels.member[(0u + _e1683)];
                                                        let _e1703 = (_e1679.indices[1] >> bitcast<u32>(2i));
                                                        if (_e1703 < _e101) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1707 = alpha_texels.member[(0u + _e1703)];
                                                        let _e1724 = (_e1679.indices[2] >> bitcast<u32>(2i));
                                                        if (_e1724 < _e101) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1728 = alpha_texels.member[(0u + _e1724)];
                                                        let _e1745 = (_e1679.indices[3] >> bitcast<u32>(2i));
                                                        if (_e1745 < _e101) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1749 = alpha_texels.member[(0u + _e1745)];
                                                        phi_2013_ = (_e1648 * (((((f32(((_e1687 >> bitcast<u32>((((_e1679.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1679.weights.x) + ((f32(((_e1707 >> bitcast<u32>((((_e1679.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1679.weights.y)) + ((f32(((_e1728 >> bitcast<u32>((((_e1679.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1679.weights.z)) + ((f32(((_e1749 >> bitcast<u32>((((_e1679.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1679.weights.w)));
                                                    }
                                                    let _e1765 = phi_2013_;
                                                    if ((_e1619.flags & 8u) == 0u) {
                                                        if (_e1765 >= _e1619.cutoff) {
                                                            phi_2025_ = 1f;
                                                        } else {
                                                            phi_2025_ = 0f;
                                                        }
                                                        let _e1772 = phi_2025_;
                                                        phi_2036_ = _e1772;
                                                    } else {
                                                        if (_e1765 > 0f) {
                                                            if (_e1765 < 1f) {
                                                                phi_2034_ = _e1765;
                                                            } else {
                                                                phi_2034_ = 1f;
                                                            }
                                                            let _e1776 = phi_2034_;
                                                            phi_2035_ = _e1776;
                                                        } else {
                                                            phi_2035_ = 0f;
                                                        }
                                                        let _e1778 = phi_2035_;
                                                        phi_2036_ = _e1778;
                                                    }
                                                    let _e1780 = phi_2036_;
                                                    phi_2037_ = _e1780;
                                                }
                                                let _e1782 = phi_2037_;
                                                let _e1799 = (1f / 255f);
                                                let _e1818 = (1f / 255f);
                                                let _e1840 = (1f / 255f);
                                                if (_e1619.color_size == 0u) {
                                                    phi_2236_ = vec3<f32>(1f, 1f, 1f);
                                                } else {
                                                    local.offset = _e1619.color_offset;
                                                    local.size = _e1619.color_size;
                                                    local.flags = _e1619.flags;
                                                    let _e1883 = _lt_shaders_texture_TextureView_quad((&local), (((_e1613[0].u * _e1621) + (_e1613[1].u * _e1581.u)) + (_e1613[2].u * _e1581.v)), (((_e1613[0].v * _e1621) + (_e1613[1].v * _e1581.u)) + (_e1613[2].v * _e1581.v)));
                                                    if (_e1883.indices[0] < _e104) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1889 = color_texels.member[(0u + _e1883.indices[0])];
                                                    let _e1900 = (1f / 255f);
                                                    if (_e1883.indices[1] < _e104) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1914 = color_texels.member[(0u + _e1883.indices[1])];
                                                    let _e1925 = (1f / 255f);
                                                    if (_e1883.indices[2] < _e104) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1942 = color_texels.member[(0u + _e1883.indices[2])];
                                                    let _e1953 = (1f / 255f);
                                                    if (_e1883.indices[3] < _e104) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1970 = color_texels.member[(0u + _e1883.indices[3])];
                                                    let _e1981 = (1f / 255f);
                                                    let _e1990 = (((((f32((_e1889 & 255u)) * _e1900) * _e1883.weights.x) + ((f32((_e1914 & 255u)) * _e1925) * _e1883.weights.y)) + ((f32((_e1942 & 255u)) * _e1953) * _e1883.weights.z)) + ((f32((_e1970 & 255u)) * _e1981) * _e1883.weights.w));
                                                    let _e1991 = (((((f32(((_e1889 >> bitcast<u32>(8i)) & 255u)) * _e1900) * _e1883.weights.x) + ((f32(((_e1914 >> bitcast<u32>(8i)) & 255u)) * _e1925) * _e1883.weights.y)) + ((f32(((_e1942 >> bitcast<u32>(8i)) & 255u)) * _e1953) * _e1883.weights.z)) + ((f32(((_e1970 >> bitcast<u32>(8i)) & 255u)) * _e1981) * _e1883.weights.w));
                                                    let _e1992 = (((((f32(((_e1889 >> bitcast<u32>(16i)) & 255u)) * _e1900) * _e1883.weights.x) + ((f32(((_e1914 >> bitcast<u32>(16i)) & 255u)) * _e1925) * _e1883.weights.y)) + ((f32(((_e1942 >> bitcast<u32>(16i)) & 255u)) * _e1953) * _e1883.weights.z)) + ((f32(((_e1970 >> bitcast<u32>(16i)) & 255u)) * _e1981) * _e1883.weights.w));
                                                    phi_2236_ = vec3<f32>((_e1990 * _e1990), (_e1991 * _e1991), (_e1992 * _e1992));
                                                }
                                                let _e1998 = phi_2236_;
                                                let _e2006 = (_e1782 * _e1619.transmission);
                                                let _e2010 = (1f - _e1782);
                                                let _e2011 = ((((_e1619.base_color.x * ((((f32((_e1613[0].color & 255u)) * _e1799) * _e1621) + ((f32((_e1613[1].color & 255u)) * _e1818) * _e1581.u)) + ((f32((_e1613[2].color & 255u)) * _e1840) * _e1581.v))) * _e1998.x) * _e2006) + _e2010);
                                                let _e2012 = ((((_e1619.base_color.y * ((((f32(((_e1613[0].color >> bitcast<u32>(8i)) & 255u)) * _e1799) * _e1621) + ((f32(((_e1613[1].color >> bitcast<u32>(8i)) & 255u)) * _e1818) * _e1581.u)) + ((f32(((_e1613[2].color >> bitcast<u32>(8i)) & 255u)) * _e1840) * _e1581.v))) * _e1998.y) * _e2006) + _e2010);
                                                let _e2013 = ((((_e1619.base_color.z * ((((f32(((_e1613[0].color >> bitcast<u32>(16i)) & 255u)) * _e1799) * _e1621) + ((f32(((_e1613[1].color >> bitcast<u32>(16i)) & 255u)) * _e1818) * _e1581.u)) + ((f32(((_e1613[2].color >> bitcast<u32>(16i)) & 255u)) * _e1840) * _e1581.v))) * _e1998.z) * _e2006) + _e2010);
                                                if (_e2011 > 0f) {
                                                    if (_e2011 < 1f) {
                                                        phi_2260_ = _e2011;
                                                    } else {
                                                        phi_2260_ = 1f;
                                                    }
                                                    let _e2017 = phi_2260_;
                                                    phi_2261_ = _e2017;
                                                } else {
                                                    phi_2261_ = 0f;
                                                }
                                                let _e2019 = phi_2261_;
                                                if (_e2012 > 0f) {
                                                    if (_e2012 < 1f) {
                                                        phi_2270_ = _e2012;
                                                    } else {
                                                        phi_2270_ = 1f;
                                                    }
                                                    let _e2023 = phi_2270_;
                                                    phi_2271_ = _e2023;
                                                } else {
                                                    phi_2271_ = 0f;
                                                }
                                                let _e2025 = phi_2271_;
                                                if (_e2013 > 0f) {
                                                    if (_e2013 < 1f) {
                                                        phi_2280_ = _e2013;
                                                    } else {
                                                        phi_2280_ = 1f;
                                                    }
                                                    let _e2029 = phi_2280_;
                                                    phi_2281_ = _e2029;
                                                } else {
                                                    phi_2281_ = 0f;
                                                }
                                                let _e2031 = phi_2281_;
                                                let _e2039 = (_e1124 * vec3<f32>(_e2019, _e2025, _e2031));
                                                let _e2041 = global[0u];
                                                if ((_e1124.x * _e2019) == _e2041) {
                                                    let _e2044 = global[1u];
                                                    if ((_e1124.y * _e2025) == _e2044) {
                                                        let _e2047 = global[2u];
                                                        phi_2305_ = ((_e1124.z * _e2031) == _e2047);
                                                        phi_2306_ = false;
                                                    } else {
                                                        phi_2305_ = bool();
                                                        phi_2306_ = true;
                                                    }
                                                    let _e2050 = phi_2305_;
                                                    let _e2052 = phi_2306_;
                                                    phi_2307_ = _e2050;
                                                    phi_2308_ = _e2052;
                                                } else {
                                                    phi_2307_ = bool();
                                                    phi_2308_ = true;
                                                }
                                                let _e2054 = phi_2307_;
                                                let _e2056 = phi_2308_;
                                                if _e2056 {
                                                    phi_2312_ = false;
                                                } else {
                                                    phi_2312_ = _e2054;
                                                }
                                                let _e2058 = phi_2312_;
                                                if _e2058 {
                                                    phi_2316_ = false;
                                                } else {
                                                    phi_2316_ = true;
                                                }
                                                let _e2060 = phi_2316_;
                                                phi_2317_ = _e2039;
                                                phi_2318_ = _e2039;
                                                phi_2319_ = _e2060;
                                            } else {
                                                phi_2317_ = vec3<f32>();
                                                phi_2318_ = _e1124;
                                                phi_2319_ = true;
                                            }
                                            let _e2062 = phi_2317_;
                                            let _e2064 = phi_2318_;
                                            let _e2066 = phi_2319_;
                                            phi_2320_ = _e2062;
                                            phi_2321_ = _e2064;
                                            phi_2322_ = _e2066;
                                        } else {
                                            phi_2320_ = vec3<f32>();
                                            phi_2321_ = _e1124;
                                            phi_2322_ = true;
                                        }
                                        let _e2068 = phi_2320_;
                                        let _e2070 = phi_2321_;
                                        let _e2072 = phi_2322_;
                                        phi_2323_ = _e2068;
                                        phi_2324_ = _e2070;
                                        phi_2325_ = _e2072;
                                    } else {
                                        phi_2323_ = vec3<f32>();
                                        phi_2324_ = _e1124;
                                        phi_2325_ = true;
                                    }
                                    let _e2074 = phi_2323_;
                                    let _e2076 = phi_2324_;
                                    let _e2078 = phi_2325_;
                                    if _e2078 {
                                    }
                                    phi_1238_ = (_e1122 & (_e1122 - 1u));
                                    phi_1241_ = _e2076;
                                    phi_2329_ = _e2074;
                                    phi_2330_ = _e2078;
                                }
                                let _e2080 = phi_1238_;
                                let _e2082 = phi_1241_;
                                let _e2084 = phi_2329_;
                                let _e2086 = phi_2330_;
                                local_9 = _e2084;
                                continue;
                                continuing {
                                    phi_1237_ = _e2080;
                                    phi_1240_ = _e2082;
                                    break if !(_e2086);
                                }
                            }
                            let _e2089 = local_6;
                            if _e2089 {
                                let _e2091 = local_2.group_mask;
                                if ((_e2091 & 4278190080u) == 0u) {
                                    let _e2095 = local_2.len;
                                    if (_e2095 == 0u) {
                                        phi_2372_ = false;
                                    } else {
                                        let _e2099 = local_2.len;
                                        local_2.len = (_e2099 - 1u);
                                        let _e2102 = local_2.len;
                                        if (_e2102 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e2107 = local_2.first[(0u + _e2102)];
                                        local_2.group = _e2107;
                                        let _e2110 = local_2.len;
                                        if (_e2110 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e2115 = local_2.mask[(0u + _e2110)];
                                        local_2.group_mask = _e2115;
                                        phi_2372_ = true;
                                    }
                                    let _e2118 = phi_2372_;
                                    phi_2373_ = _e2118;
                                } else {
                                    phi_2373_ = true;
                                }
                                let _e2120 = phi_2373_;
                                if _e2120 {
                                    let _e2122 = local_2.group_mask;
                                    let _e2128 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2122)), 32u, (_e2122 == 0u)));
                                    let _e2132 = local_2.group_mask;
                                    let _e2146 = local_2.group_mask;
                                    local_2.group_mask = (_e2146 & ~((1u << bitcast<u32>((_e2128 & 31u)))));
                                    let _e2149 = local_2.group;
                                    phi_2404_ = (_e2149 + countOneBits(((_e2132 & ~((4294967295u << bitcast<u32>((((_e2128 - 24u) ^ _e546) & 31u))))) & 255u)));
                                } else {
                                    phi_2404_ = 4294967295u;
                                }
                                let _e2152 = phi_2404_;
                                phi_2405_ = _e2152;
                            } else {
                                phi_2405_ = u32();
                            }
                            let _e2154 = phi_2405_;
                            phi_906_ = _e2154;
                            let _e2392 = local_8;
                            phi_909_ = _e2392;
                            let _e2395 = local_9;
                            phi_2406_ = _e2395;
                            let _e2398 = local_10;
                            phi_2407_ = _e2398;
                            phi_2408_ = false;
                        } else {
                            phi_906_ = u32();
                            phi_909_ = vec3<f32>();
                            phi_2406_ = vec3<f32>();
                            phi_2407_ = false;
                            phi_2408_ = true;
                        }
                        let _e2156 = phi_906_;
                        let _e2158 = phi_909_;
                        let _e2160 = phi_2406_;
                        let _e2162 = phi_2407_;
                        let _e2164 = phi_2408_;
                        local_7 = _e2164;
                        local_11 = _e2160;
                        continue;
                        continuing {
                            phi_905_ = _e2156;
                            phi_908_ = _e2158;
                            break if !(_e2162);
                        }
                    }
                    let _e2167 = local_7;
                    if _e2167 {
                        phi_2412_ = false;
                    } else {
                        phi_2412_ = true;
                    }
                    let _e2169 = phi_2412_;
                    if _e2169 {
                        let _e2404 = local_11;
                        phi_2416_ = _e2404;
                    } else {
                        let _e2406 = local_12;
                        phi_2416_ = _e2406;
                    }
                    let _e2171 = phi_2416_;
                    phi_2417_ = _e2171;
                }
                let _e2173 = phi_2417_;
                phi_2418_ = _e2173;
                phi_2419_ = _e368;
            } else {
                phi_2418_ = vec3<f32>();
                phi_2419_ = true;
            }
            let _e2175 = phi_2418_;
            let _e2177 = phi_2419_;
            if _e2177 {
                phi_2423_ = vec3<f32>(1f, 1f, 1f);
            } else {
                phi_2423_ = _e2175;
            }
            let _e2179 = phi_2423_;
            phi_2424_ = _e2179;
        } else {
            phi_2424_ = vec3<f32>(1f, 1f, 1f);
        }
        let _e2181 = phi_2424_;
        if (_e110.first_primitive < arrayLength((&tints.member))) {
        } else {
            return;
        }
        tints.member[(0u + _e110.first_primitive)] = vec4<f32>(_e2181.x, _e2181.y, _e2181.z, 1f);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_tint_tint_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
