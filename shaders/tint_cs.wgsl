struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    number: u32,
    mask_words: u32,
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

struct type_17 {
    member: array<f32>,
}

struct lt_mask_LightPlace {
    word: u32,
    shift: u32,
}

struct evaluate_Verdict {
    visibility: f32,
    is_doubted: bool,
}

struct u0028_evaluate_Verdict_u0020_bool_u0029_ {
    unnamed: evaluate_Verdict,
    unnamed_1: bool,
}

struct type_35 {
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

struct type_42 {
    member: abi_ShadowParams,
}

struct lt_bvh_Node {
    frame: vec4<u32>,
    links: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    z: vec4<u32>,
}

struct type_47 {
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

struct type_51 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_55 {
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

struct type_59 {
    member: array<abi_Material>,
}

struct u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_ {
    unnamed: lt_mask_LightPlace,
    unnamed_1: lt_mask_LightPlace,
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
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_42;
@group(0) @binding(2) 
var<storage> nodes: type_47;
@group(0) @binding(3) 
var<storage> triangles: type_51;
@group(0) @binding(4) 
var<storage> visibility: type_17;
@group(0) @binding(5) 
var<storage, read_write> tints: type_35;
@group(0) @binding(6) 
var<storage> vertices: type_55;
@group(0) @binding(7) 
var<storage> materials: type_59;
@group(0) @binding(8) 
var<storage> alpha_texels: type_13;
@group(0) @binding(9) 
var<storage> color_texels: type_13;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_mask_LightPlace {
    var phi_223_: lt_mask_LightPlace;
    var phi_224_: bool;
    var phi_225_: lt_mask_LightPlace;
    var phi_226_: bool;
    var phi_231_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_223_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_224_ = false;
        } else {
            phi_223_ = lt_mask_LightPlace();
            phi_224_ = true;
        }
        let _e86 = phi_223_;
        let _e88 = phi_224_;
        phi_225_ = _e86;
        phi_226_ = _e88;
    } else {
        phi_225_ = lt_mask_LightPlace();
        phi_226_ = true;
    }
    let _e90 = phi_225_;
    let _e92 = phi_226_;
    if _e92 {
        phi_231_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_231_ = _e90;
    }
    let _e97 = phi_231_;
    return lt_mask_LightPlace(_e97.word, _e97.shift);
}

fn _lt_shaders_texture_TextureView_quad(param_3: ptr<function, texture_TextureView>, param_4: f32, param_5: f32) -> texture_TexelQuad {
    var phi_2499_: f32;
    var phi_2504_: f32;
    var phi_2505_: bool;
    var phi_2506_: f32;
    var phi_2507_: bool;
    var phi_2511_: f32;
    var phi_2537_: f32;
    var phi_2542_: f32;
    var phi_2543_: bool;
    var phi_2544_: f32;
    var phi_2545_: bool;
    var phi_2549_: f32;
    var phi_2557_: f32;
    var phi_2558_: f32;
    var phi_2559_: f32;
    var phi_2568_: f32;
    var phi_2569_: f32;
    var phi_2587_: u32;
    var phi_2601_: u32;
    var phi_2608_: u32;
    var phi_2613_: u32;
    var phi_2619_: u32;
    var phi_2624_: u32;
    var phi_2626_: texture_Axis;
    var phi_2654_: f32;
    var phi_2659_: f32;
    var phi_2660_: bool;
    var phi_2661_: f32;
    var phi_2662_: bool;
    var phi_2666_: f32;
    var phi_2692_: f32;
    var phi_2697_: f32;
    var phi_2698_: bool;
    var phi_2699_: f32;
    var phi_2700_: bool;
    var phi_2704_: f32;
    var phi_2712_: f32;
    var phi_2713_: f32;
    var phi_2714_: f32;
    var phi_2723_: f32;
    var phi_2724_: f32;
    var phi_2742_: u32;
    var phi_2756_: u32;
    var phi_2763_: u32;
    var phi_2768_: u32;
    var phi_2774_: u32;
    var phi_2779_: u32;
    var phi_2781_: texture_Axis;

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
                phi_2499_ = 1f;
            } else {
                phi_2499_ = 0f;
            }
            let _e107 = phi_2499_;
            if (param_4 < 8388608f) {
                phi_2504_ = (_e104 - _e107);
                phi_2505_ = false;
            } else {
                phi_2504_ = f32();
                phi_2505_ = true;
            }
            let _e110 = phi_2504_;
            let _e112 = phi_2505_;
            phi_2506_ = _e110;
            phi_2507_ = _e112;
        } else {
            phi_2506_ = f32();
            phi_2507_ = true;
        }
        let _e114 = phi_2506_;
        let _e116 = phi_2507_;
        if _e116 {
            phi_2511_ = param_4;
        } else {
            phi_2511_ = _e114;
        }
        let _e118 = phi_2511_;
        phi_2559_ = (param_4 - _e118);
    } else {
        if (_e91 == 1u) {
            let _e121 = (param_4 * 0.5f);
            if (_e121 > -8388608f) {
                let _e133 = f32(select(0i, select(select(i32(_e121), i32(-2147483648), (_e121 < bitcast<f32>(3472883712u))), 2147483647i, (_e121 > bitcast<f32>(1325400063u))), (_e121 == _e121)));
                if (_e133 > _e121) {
                    phi_2537_ = 1f;
                } else {
                    phi_2537_ = 0f;
                }
                let _e136 = phi_2537_;
                if (_e121 < 8388608f) {
                    phi_2542_ = (_e133 - _e136);
                    phi_2543_ = false;
                } else {
                    phi_2542_ = f32();
                    phi_2543_ = true;
                }
                let _e139 = phi_2542_;
                let _e141 = phi_2543_;
                phi_2544_ = _e139;
                phi_2545_ = _e141;
            } else {
                phi_2544_ = f32();
                phi_2545_ = true;
            }
            let _e143 = phi_2544_;
            let _e145 = phi_2545_;
            if _e145 {
                phi_2549_ = _e121;
            } else {
                phi_2549_ = _e143;
            }
            let _e147 = phi_2549_;
            let _e149 = (param_4 - (2f * _e147));
            if (_e149 > 1f) {
                phi_2557_ = (2f - _e149);
            } else {
                phi_2557_ = _e149;
            }
            let _e153 = phi_2557_;
            phi_2558_ = _e153;
        } else {
            phi_2558_ = param_4;
        }
        let _e155 = phi_2558_;
        phi_2559_ = _e155;
    }
    let _e157 = phi_2559_;
    if (_e157 > 0f) {
        if (_e157 < 1f) {
            phi_2568_ = _e157;
        } else {
            phi_2568_ = 1f;
        }
        let _e161 = phi_2568_;
        phi_2569_ = _e161;
    } else {
        phi_2569_ = 0f;
    }
    let _e163 = phi_2569_;
    let _e164 = (_e78 - 1u);
    let _e166 = (_e163 * f32(_e78));
    if _e86 {
        let _e173 = select(select(u32(_e166), 0u, (_e166 < bitcast<f32>(0u))), 4294967295u, (_e166 > bitcast<f32>(1333788671u)));
        if (_e164 < _e173) {
            phi_2587_ = _e164;
        } else {
            phi_2587_ = _e173;
        }
        let _e176 = phi_2587_;
        phi_2626_ = texture_Axis(_e176, _e176, 0f);
    } else {
        let _e178 = (_e166 + 0.5f);
        let _e185 = select(select(u32(_e178), 0u, (_e178 < bitcast<f32>(0u))), 4294967295u, (_e178 > bitcast<f32>(1333788671u)));
        if (_e78 < _e185) {
            phi_2601_ = _e78;
        } else {
            phi_2601_ = _e185;
        }
        let _e188 = phi_2601_;
        if (_e91 == 0u) {
            phi_2608_ = _e164;
        } else {
            phi_2608_ = 0u;
        }
        let _e193 = phi_2608_;
        if (_e91 == 0u) {
            phi_2613_ = 0u;
        } else {
            phi_2613_ = _e164;
        }
        let _e196 = phi_2613_;
        if (_e188 == 0u) {
            phi_2619_ = _e193;
        } else {
            phi_2619_ = (_e188 - 1u);
        }
        let _e200 = phi_2619_;
        if (_e188 > _e164) {
            phi_2624_ = _e196;
        } else {
            phi_2624_ = _e188;
        }
        let _e203 = phi_2624_;
        phi_2626_ = texture_Axis(_e200, _e203, (_e178 - f32(_e188)));
    }
    let _e206 = phi_2626_;
    let _e208 = (*param_3).flags;
    let _e211 = ((_e208 >> bitcast<u32>(6u)) & 3u);
    if (_e211 == 0u) {
        if (param_5 > -8388608f) {
            let _e224 = f32(select(0i, select(select(i32(param_5), i32(-2147483648), (param_5 < bitcast<f32>(3472883712u))), 2147483647i, (param_5 > bitcast<f32>(1325400063u))), (param_5 == param_5)));
            if (_e224 > param_5) {
                phi_2654_ = 1f;
            } else {
                phi_2654_ = 0f;
            }
            let _e227 = phi_2654_;
            if (param_5 < 8388608f) {
                phi_2659_ = (_e224 - _e227);
                phi_2660_ = false;
            } else {
                phi_2659_ = f32();
                phi_2660_ = true;
            }
            let _e230 = phi_2659_;
            let _e232 = phi_2660_;
            phi_2661_ = _e230;
            phi_2662_ = _e232;
        } else {
            phi_2661_ = f32();
            phi_2662_ = true;
        }
        let _e234 = phi_2661_;
        let _e236 = phi_2662_;
        if _e236 {
            phi_2666_ = param_5;
        } else {
            phi_2666_ = _e234;
        }
        let _e238 = phi_2666_;
        phi_2714_ = (param_5 - _e238);
    } else {
        if (_e211 == 1u) {
            let _e241 = (param_5 * 0.5f);
            if (_e241 > -8388608f) {
                let _e253 = f32(select(0i, select(select(i32(_e241), i32(-2147483648), (_e241 < bitcast<f32>(3472883712u))), 2147483647i, (_e241 > bitcast<f32>(1325400063u))), (_e241 == _e241)));
                if (_e253 > _e241) {
                    phi_2692_ = 1f;
                } else {
                    phi_2692_ = 0f;
                }
                let _e256 = phi_2692_;
                if (_e241 < 8388608f) {
                    phi_2697_ = (_e253 - _e256);
                    phi_2698_ = false;
                } else {
                    phi_2697_ = f32();
                    phi_2698_ = true;
                }
                let _e259 = phi_2697_;
                let _e261 = phi_2698_;
                phi_2699_ = _e259;
                phi_2700_ = _e261;
            } else {
                phi_2699_ = f32();
                phi_2700_ = true;
            }
            let _e263 = phi_2699_;
            let _e265 = phi_2700_;
            if _e265 {
                phi_2704_ = _e241;
            } else {
                phi_2704_ = _e263;
            }
            let _e267 = phi_2704_;
            let _e269 = (param_5 - (2f * _e267));
            if (_e269 > 1f) {
                phi_2712_ = (2f - _e269);
            } else {
                phi_2712_ = _e269;
            }
            let _e273 = phi_2712_;
            phi_2713_ = _e273;
        } else {
            phi_2713_ = param_5;
        }
        let _e275 = phi_2713_;
        phi_2714_ = _e275;
    }
    let _e277 = phi_2714_;
    if (_e277 > 0f) {
        if (_e277 < 1f) {
            phi_2723_ = _e277;
        } else {
            phi_2723_ = 1f;
        }
        let _e281 = phi_2723_;
        phi_2724_ = _e281;
    } else {
        phi_2724_ = 0f;
    }
    let _e283 = phi_2724_;
    let _e284 = (_e82 - 1u);
    let _e286 = (_e283 * f32(_e82));
    if _e86 {
        let _e293 = select(select(u32(_e286), 0u, (_e286 < bitcast<f32>(0u))), 4294967295u, (_e286 > bitcast<f32>(1333788671u)));
        if (_e284 < _e293) {
            phi_2742_ = _e284;
        } else {
            phi_2742_ = _e293;
        }
        let _e296 = phi_2742_;
        phi_2781_ = texture_Axis(_e296, _e296, 0f);
    } else {
        let _e298 = (_e286 + 0.5f);
        let _e305 = select(select(u32(_e298), 0u, (_e298 < bitcast<f32>(0u))), 4294967295u, (_e298 > bitcast<f32>(1333788671u)));
        if (_e82 < _e305) {
            phi_2756_ = _e82;
        } else {
            phi_2756_ = _e305;
        }
        let _e308 = phi_2756_;
        if (_e211 == 0u) {
            phi_2763_ = _e284;
        } else {
            phi_2763_ = 0u;
        }
        let _e313 = phi_2763_;
        if (_e211 == 0u) {
            phi_2768_ = 0u;
        } else {
            phi_2768_ = _e284;
        }
        let _e316 = phi_2768_;
        if (_e308 == 0u) {
            phi_2774_ = _e313;
        } else {
            phi_2774_ = (_e308 - 1u);
        }
        let _e320 = phi_2774_;
        if (_e308 > _e284) {
            phi_2779_ = _e316;
        } else {
            phi_2779_ = _e308;
        }
        let _e323 = phi_2779_;
        phi_2781_ = texture_Axis(_e320, _e323, (_e298 - f32(_e308)));
    }
    let _e326 = phi_2781_;
    let _e330 = (*param_3).offset;
    let _e337 = (*param_3).offset;
    let _e344 = (*param_3).offset;
    let _e351 = (*param_3).offset;
    return texture_TexelQuad(array<u32, 4>(((_e330 + (_e326.low * _e78)) + _e206.low), ((_e337 + (_e326.low * _e78)) + _e206.high), ((_e344 + (_e326.high * _e78)) + _e206.low), ((_e351 + (_e326.high * _e78)) + _e206.high)), vec4<f32>(((1f - _e206.fraction) * (1f - _e326.fraction)), (_e206.fraction * (1f - _e326.fraction)), ((1f - _e206.fraction) * _e326.fraction), (_e206.fraction * _e326.fraction)));
}

fn core_intrinsics_minimum_number_nsz_f32_(param_6: f32, param_7: f32) -> f32 {
    var phi_2453_: bool;
    var phi_2457_: f32;

    if (param_6 != param_6) {
        phi_2453_ = true;
    } else {
        let _e76 = (param_7 <= param_6);
        if _e76 {
        }
        phi_2453_ = _e76;
    }
    let _e78 = phi_2453_;
    if _e78 {
        phi_2457_ = param_7;
    } else {
        phi_2457_ = param_6;
    }
    let _e80 = phi_2457_;
    return _e80;
}

fn core_intrinsics_maximum_number_nsz_f32_(param_8: f32, param_9: f32) -> f32 {
    var phi_2437_: bool;
    var phi_2441_: f32;

    if (param_8 != param_8) {
        phi_2437_ = true;
    } else {
        let _e76 = (param_9 >= param_8);
        if _e76 {
        }
        phi_2437_ = _e76;
    }
    let _e78 = phi_2437_;
    if _e78 {
        phi_2441_ = param_9;
    } else {
        phi_2441_ = param_8;
    }
    let _e80 = phi_2441_;
    return _e80;
}

fn function_() {
    var local: texture_TextureView;
    var local_1: texture_TextureView;
    var local_2: lt_bvh_traverse_Stack;
    var phi_322_: bool;
    var phi_323_: bool;
    var phi_324_: bool;
    var phi_325_: bool;
    var phi_329_: bool;
    var phi_399_: bool;
    var phi_400_: bool;
    var phi_411_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_412_: bool;
    var phi_413_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_414_: bool;
    var phi_421_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_425_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_428_: bool;
    var phi_461_: f32;
    var phi_512_: bool;
    var phi_513_: bool;
    var phi_514_: bool;
    var phi_518_: bool;
    var phi_519_: bool;
    var phi_520_: bool;
    var phi_521_: bool;
    var phi_522_: bool;
    var phi_523_: bool;
    var phi_524_: bool;
    var phi_525_: bool;
    var phi_526_: bool;
    var phi_527_: bool;
    var phi_528_: bool;
    var phi_529_: bool;
    var phi_530_: bool;
    var phi_531_: bool;
    var phi_532_: bool;
    var phi_533_: bool;
    var phi_534_: bool;
    var phi_535_: bool;
    var phi_539_: bool;
    var phi_543_: bool;
    var phi_613_: f32;
    var phi_620_: f32;
    var phi_627_: f32;
    var phi_634_: f32;
    var phi_641_: f32;
    var phi_648_: f32;
    var phi_665_: f32;
    var phi_670_: f32;
    var phi_675_: f32;
    var phi_703_: bool;
    var phi_704_: bool;
    var phi_712_: u32;
    var phi_713_: u32;
    var phi_724_: vec3<f32>;
    var phi_725_: vec3<f32>;
    var phi_738_: u32;
    var phi_743_: u32;
    var phi_748_: u32;
    var phi_862_: bool;
    var phi_863_: bool;
    var phi_894_: u32;
    var phi_896_: u32;
    var phi_899_: vec3<f32>;
    var phi_979_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1006_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1033_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1039_: u32;
    var phi_1042_: u32;
    var phi_1056_: u32;
    var phi_1066_: u32;
    var phi_1076_: u32;
    var phi_1094_: u32;
    var phi_1104_: u32;
    var phi_1114_: u32;
    var phi_1150_: u32;
    var phi_1163_: u32;
    var phi_1168_: u32;
    var phi_1169_: u32;
    var phi_1170_: u32;
    var phi_1040_: u32;
    var phi_1043_: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_1228_: u32;
    var phi_1231_: vec3<f32>;
    var phi_1275_: vec3<f32>;
    var phi_1276_: vec3<f32>;
    var phi_1305_: vec3<f32>;
    var phi_1306_: vec3<f32>;
    var phi_1335_: vec3<f32>;
    var phi_1336_: vec3<f32>;
    var phi_1354_: bool;
    var phi_1355_: bool;
    var phi_1359_: f32;
    var phi_1360_: f32;
    var phi_1361_: f32;
    var phi_1362_: f32;
    var phi_1370_: f32;
    var phi_1380_: bool;
    var phi_1381_: bool;
    var phi_1385_: f32;
    var phi_1386_: f32;
    var phi_1387_: f32;
    var phi_1388_: f32;
    var phi_1396_: f32;
    var phi_1406_: bool;
    var phi_1407_: bool;
    var phi_1411_: f32;
    var phi_1412_: f32;
    var phi_1413_: f32;
    var phi_1414_: f32;
    var phi_1422_: f32;
    var phi_1437_: f32;
    var phi_1438_: bool;
    var phi_1439_: f32;
    var phi_1440_: bool;
    var phi_1441_: f32;
    var phi_1442_: bool;
    var phi_1460_: f32;
    var phi_1461_: bool;
    var phi_1462_: bool;
    var phi_1463_: f32;
    var phi_1464_: bool;
    var phi_1465_: bool;
    var phi_1469_: bool;
    var phi_1470_: f32;
    var phi_1471_: bool;
    var phi_1499_: vec3<f32>;
    var phi_1500_: vec3<f32>;
    var phi_1525_: vec3<f32>;
    var phi_1526_: vec3<f32>;
    var phi_1551_: vec3<f32>;
    var phi_1552_: vec3<f32>;
    var phi_1608_: f32;
    var phi_1617_: f32;
    var phi_1626_: f32;
    var phi_1635_: f32;
    var phi_1642_: f32;
    var phi_1649_: f32;
    var phi_1662_: f32;
    var phi_1671_: f32;
    var phi_1680_: f32;
    var phi_1689_: f32;
    var phi_1696_: f32;
    var phi_1703_: f32;
    var phi_1720_: f32;
    var phi_1725_: f32;
    var phi_1730_: f32;
    var phi_1738_: f32;
    var phi_1743_: f32;
    var phi_1748_: f32;
    var phi_1760_: f32;
    var phi_1765_: f32;
    var phi_1770_: f32;
    var phi_1775_: f32;
    var phi_1780_: lt_bvh_triangle_Intersection;
    var phi_1781_: bool;
    var phi_1782_: lt_bvh_triangle_Intersection;
    var phi_1783_: bool;
    var phi_1787_: lt_bvh_triangle_Intersection;
    var phi_1788_: bool;
    var phi_1789_: lt_bvh_triangle_Intersection;
    var phi_1790_: bool;
    var phi_1791_: bool;
    var phi_1795_: bool;
    var phi_1799_: lt_bvh_triangle_Intersection;
    var phi_2004_: f32;
    var phi_2016_: f32;
    var phi_2025_: f32;
    var phi_2026_: f32;
    var phi_2027_: f32;
    var phi_2028_: f32;
    var phi_2227_: vec3<f32>;
    var phi_2251_: f32;
    var phi_2252_: f32;
    var phi_2261_: f32;
    var phi_2262_: f32;
    var phi_2271_: f32;
    var phi_2272_: f32;
    var phi_2296_: bool;
    var phi_2297_: bool;
    var phi_2298_: bool;
    var phi_2299_: bool;
    var phi_2303_: bool;
    var phi_2307_: bool;
    var phi_2308_: vec3<f32>;
    var phi_2309_: vec3<f32>;
    var phi_2310_: bool;
    var phi_2311_: vec3<f32>;
    var phi_2312_: vec3<f32>;
    var phi_2313_: bool;
    var phi_2314_: vec3<f32>;
    var phi_2315_: vec3<f32>;
    var phi_2316_: bool;
    var phi_1229_: u32;
    var phi_1232_: vec3<f32>;
    var phi_2320_: vec3<f32>;
    var phi_2321_: bool;
    var local_6: bool;
    var phi_2363_: bool;
    var phi_2364_: bool;
    var phi_2395_: u32;
    var phi_2396_: u32;
    var phi_897_: u32;
    var phi_900_: vec3<f32>;
    var phi_2397_: vec3<f32>;
    var phi_2398_: bool;
    var phi_2399_: bool;
    var local_7: bool;
    var phi_2403_: bool;
    var phi_2407_: vec3<f32>;
    var phi_2408_: vec3<f32>;
    var phi_2409_: vec3<f32>;
    var phi_2410_: bool;
    var phi_2414_: vec3<f32>;
    var phi_2415_: vec3<f32>;
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
    if (bitcast<i32>(_e110.word) != 0i) {
        if (_e110.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        if (_e110.shift < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        let _e122 = visibility.member[(0u + _e110.shift)];
        if (_e122 > 0f) {
            let _e126 = samples.member[(0u + _e110.shift)].normal[0u];
            let _e128 = global[0u];
            if (_e126 == _e128) {
                let _e131 = samples.member[(0u + _e110.shift)].normal[1u];
                let _e133 = global[1u];
                if (_e131 == _e133) {
                    let _e136 = samples.member[(0u + _e110.shift)].normal[2u];
                    let _e138 = global[2u];
                    phi_322_ = (_e136 == _e138);
                    phi_323_ = false;
                } else {
                    phi_322_ = bool();
                    phi_323_ = true;
                }
                let _e141 = phi_322_;
                let _e143 = phi_323_;
                phi_324_ = _e141;
                phi_325_ = _e143;
            } else {
                phi_324_ = bool();
                phi_325_ = true;
            }
            let _e145 = phi_324_;
            let _e147 = phi_325_;
            if _e147 {
                phi_329_ = false;
            } else {
                phi_329_ = _e145;
            }
            let _e149 = phi_329_;
            if !(_e149) {
                let _e152 = samples.member[(0u + _e110.shift)].position;
                let _e154 = p.member.light.place;
                let _e160 = p.member.light.place[3u];
                let _e167 = (_e154.x - (_e152.x * _e160));
                let _e168 = (_e154.y - (_e152.y * _e160));
                let _e169 = (_e154.z - (_e152.z * _e160));
                let _e171 = samples.member[(0u + _e110.shift)].normal;
                if ((((_e171.x * _e167) + (_e171.y * _e168)) + (_e171.z * _e169)) > 0f) {
                    let _e185 = (((_e167 * _e167) + (_e168 * _e168)) + (_e169 * _e169));
                    let _e187 = p.member.light.axis;
                    let _e199 = p.member.light.place[3u];
                    if (_e199 == 0f) {
                        phi_400_ = true;
                    } else {
                        let _e202 = p.member.light.range_squared;
                        if (_e185 <= _e202) {
                            let _e205 = p.member.light.cos_outer;
                            phi_399_ = (-((((_e167 * _e187.x) + (_e168 * _e187.y)) + (_e169 * _e187.z))) >= (_e205 * sqrt(_e185)));
                        } else {
                            phi_399_ = false;
                        }
                        let _e210 = phi_399_;
                        phi_400_ = _e210;
                    }
                    let _e212 = phi_400_;
                    if _e212 {
                        let _e214 = samples.member[(0u + _e110.shift)].flags;
                        let _e222 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                        let _e228 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e222.unnamed.visibility, false), _e222.unnamed_1);
                        phi_411_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e228.unnamed, ((_e214 & 1u) == 0u));
                        phi_412_ = false;
                    } else {
                        phi_411_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                        phi_412_ = true;
                    }
                    let _e233 = phi_411_;
                    let _e235 = phi_412_;
                    phi_413_ = _e233;
                    phi_414_ = _e235;
                } else {
                    phi_413_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_414_ = true;
                }
                let _e237 = phi_413_;
                let _e239 = phi_414_;
                if _e239 {
                    let _e245 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e251 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e245.unnamed.visibility, false), _e245.unnamed_1);
                    phi_421_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e251.unnamed, true);
                } else {
                    phi_421_ = _e237;
                }
                let _e256 = phi_421_;
                phi_425_ = _e256;
            } else {
                let _e262 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e268 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e262.unnamed.visibility, false), _e262.unnamed_1);
                phi_425_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e268.unnamed, true);
            }
            let _e273 = phi_425_;
            phi_428_ = !(_e273.unnamed_1);
        } else {
            phi_428_ = false;
        }
        let _e277 = phi_428_;
        if _e277 {
            let _e279 = samples.member[(0u + _e110.shift)].position;
            let _e281 = samples.member[(0u + _e110.shift)].normal;
            let _e283 = samples.member[(0u + _e110.shift)].magnitude;
            let _e285 = ((8f / 8388608f) * _e283);
            let _e293 = (_e279.x + (_e281.x * _e285));
            let _e295 = (_e279.y + (_e281.y * _e285));
            let _e297 = (_e279.z + (_e281.z * _e285));
            let _e299 = p.member.light.place;
            if (_e299.w == 0f) {
                phi_461_ = 300000000000000000000000000000000000000f;
            } else {
                phi_461_ = 1f;
            }
            let _e303 = phi_461_;
            let _e311 = (_e299.x - (_e293 * _e299.w));
            let _e312 = (_e299.y - (_e295 * _e299.w));
            let _e313 = (_e299.z - (_e297 * _e299.w));
            let _e318 = abs(_e311);
            let _e319 = abs(_e312);
            let _e320 = abs(_e313);
            if (abs(_e293) < 1000000000000000f) {
                if (abs(_e295) < 1000000000000000f) {
                    if (abs(_e297) < 1000000000000000f) {
                        if (_e318 < 1000000000000000f) {
                            if (_e319 < 1000000000000000f) {
                                if (_e320 < 1000000000000000f) {
                                    if (_e318 > 0f) {
                                        phi_513_ = bool();
                                        phi_514_ = true;
                                    } else {
                                        let _e328 = (_e319 > 0f);
                                        if _e328 {
                                            phi_512_ = bool();
                                        } else {
                                            phi_512_ = (_e320 > 0f);
                                        }
                                        let _e331 = phi_512_;
                                        phi_513_ = _e331;
                                        phi_514_ = _e328;
                                    }
                                    let _e333 = phi_513_;
                                    let _e335 = phi_514_;
                                    if _e335 {
                                        phi_518_ = true;
                                    } else {
                                        phi_518_ = _e333;
                                    }
                                    let _e337 = phi_518_;
                                    phi_519_ = _e337;
                                    phi_520_ = false;
                                } else {
                                    phi_519_ = bool();
                                    phi_520_ = true;
                                }
                                let _e339 = phi_519_;
                                let _e341 = phi_520_;
                                phi_521_ = _e339;
                                phi_522_ = false;
                                phi_523_ = _e341;
                            } else {
                                phi_521_ = bool();
                                phi_522_ = true;
                                phi_523_ = false;
                            }
                            let _e343 = phi_521_;
                            let _e345 = phi_522_;
                            let _e347 = phi_523_;
                            phi_524_ = _e343;
                            phi_525_ = _e345;
                            phi_526_ = _e347;
                        } else {
                            phi_524_ = bool();
                            phi_525_ = true;
                            phi_526_ = false;
                        }
                        let _e349 = phi_524_;
                        let _e351 = phi_525_;
                        let _e353 = phi_526_;
                        phi_527_ = _e349;
                        phi_528_ = _e351;
                        phi_529_ = _e353;
                    } else {
                        phi_527_ = bool();
                        phi_528_ = true;
                        phi_529_ = false;
                    }
                    let _e355 = phi_527_;
                    let _e357 = phi_528_;
                    let _e359 = phi_529_;
                    phi_530_ = _e355;
                    phi_531_ = _e357;
                    phi_532_ = _e359;
                } else {
                    phi_530_ = bool();
                    phi_531_ = true;
                    phi_532_ = false;
                }
                let _e361 = phi_530_;
                let _e363 = phi_531_;
                let _e365 = phi_532_;
                phi_533_ = _e361;
                phi_534_ = _e363;
                phi_535_ = _e365;
            } else {
                phi_533_ = bool();
                phi_534_ = true;
                phi_535_ = false;
            }
            let _e367 = phi_533_;
            let _e369 = phi_534_;
            let _e371 = phi_535_;
            if _e369 {
                phi_539_ = true;
            } else {
                phi_539_ = _e371;
            }
            let _e373 = phi_539_;
            if _e373 {
                phi_543_ = false;
            } else {
                phi_543_ = _e367;
            }
            let _e375 = phi_543_;
            if _e375 {
                let _e376 = (0u >= _e83);
                if _e376 {
                    phi_2408_ = vec3<f32>();
                } else {
                    if (0u < _e83) {
                    } else {
                        return;
                    }
                    let _e382 = nodes.member[(0u + 0u)].frame[0u];
                    let _e386 = nodes.member[(0u + 0u)].frame[1u];
                    let _e390 = nodes.member[(0u + 0u)].frame[2u];
                    let _e394 = nodes.member[(0u + 0u)].frame[0u];
                    let _e398 = nodes.member[(0u + 0u)].frame[1u];
                    let _e402 = nodes.member[(0u + 0u)].frame[2u];
                    let _e406 = nodes.member[(0u + 0u)].frame[3u];
                    let _e440 = core_intrinsics_maximum_number_nsz_f32_(abs(_e311), abs(_e312));
                    let _e441 = core_intrinsics_maximum_number_nsz_f32_(_e440, abs(_e313));
                    let _e442 = (_e441 * 0.0000000000009094947f);
                    if (abs(_e311) < _e442) {
                        phi_613_ = _e442;
                    } else {
                        phi_613_ = abs(_e311);
                    }
                    let _e447 = phi_613_;
                    if (_e311 < 0f) {
                        phi_620_ = (-1f / _e447);
                    } else {
                        phi_620_ = (1f / _e447);
                    }
                    let _e452 = phi_620_;
                    if (abs(_e312) < _e442) {
                        phi_627_ = _e442;
                    } else {
                        phi_627_ = abs(_e312);
                    }
                    let _e457 = phi_627_;
                    if (_e312 < 0f) {
                        phi_634_ = (-1f / _e457);
                    } else {
                        phi_634_ = (1f / _e457);
                    }
                    let _e462 = phi_634_;
                    if (abs(_e313) < _e442) {
                        phi_641_ = _e442;
                    } else {
                        phi_641_ = abs(_e313);
                    }
                    let _e467 = phi_641_;
                    if (_e313 < 0f) {
                        phi_648_ = (-1f / _e467);
                    } else {
                        phi_648_ = (1f / _e467);
                    }
                    let _e472 = phi_648_;
                    let _e476 = abs((bitcast<f32>(_e382) - _e293));
                    let _e477 = abs((bitcast<f32>(_e386) - _e295));
                    let _e478 = abs((bitcast<f32>(_e390) - _e297));
                    let _e482 = abs(((bitcast<f32>(_e394) + (bitcast<f32>((((_e406 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e293));
                    let _e483 = abs(((bitcast<f32>(_e398) + (bitcast<f32>((((_e406 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e295));
                    let _e484 = abs(((bitcast<f32>(_e402) + (bitcast<f32>((((_e406 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e297));
                    if (_e476 > _e482) {
                        phi_665_ = _e476;
                    } else {
                        phi_665_ = _e482;
                    }
                    let _e487 = phi_665_;
                    if (_e477 > _e483) {
                        phi_670_ = _e477;
                    } else {
                        phi_670_ = _e483;
                    }
                    let _e490 = phi_670_;
                    if (_e478 > _e484) {
                        phi_675_ = _e478;
                    } else {
                        phi_675_ = _e484;
                    }
                    let _e493 = phi_675_;
                    let _e494 = core_intrinsics_maximum_number_nsz_f32_(_e487, _e490);
                    let _e495 = core_intrinsics_maximum_number_nsz_f32_(_e494, _e493);
                    let _e499 = (_e495 * 0.0000019073486f);
                    let _e500 = (abs(_e452) * _e499);
                    let _e501 = (abs(_e462) * _e499);
                    let _e502 = (abs(_e472) * _e499);
                    let _e506 = (_e495 * 0.0000009536743f);
                    let _e507 = (abs(_e452) * _e506);
                    let _e508 = (abs(_e462) * _e506);
                    let _e509 = (abs(_e472) * _e506);
                    let _e510 = abs(_e311);
                    let _e511 = abs(_e312);
                    let _e512 = abs(_e313);
                    if (_e510 >= _e511) {
                        if (_e510 >= _e512) {
                            phi_703_ = false;
                        } else {
                            phi_703_ = true;
                        }
                        let _e516 = phi_703_;
                        phi_704_ = _e516;
                    } else {
                        phi_704_ = true;
                    }
                    let _e518 = phi_704_;
                    if _e518 {
                        if (_e511 >= _e512) {
                            phi_712_ = 1u;
                        } else {
                            phi_712_ = 2u;
                        }
                        let _e521 = phi_712_;
                        phi_713_ = _e521;
                    } else {
                        phi_713_ = 0u;
                    }
                    let _e523 = phi_713_;
                    if (_e523 == 0u) {
                        phi_725_ = vec3<f32>(_e312, _e313, _e311);
                    } else {
                        if (_e523 == 1u) {
                            phi_724_ = vec3<f32>(_e313, _e311, _e312);
                        } else {
                            phi_724_ = vec3<f32>(_e311, _e312, _e313);
                        }
                        let _e529 = phi_724_;
                        phi_725_ = _e529;
                    }
                    let _e531 = phi_725_;
                    let _e534 = (_e531.x / _e531.z);
                    let _e537 = (_e531.y / _e531.z);
                    if (_e452 < 0f) {
                        phi_738_ = 0u;
                    } else {
                        phi_738_ = 1u;
                    }
                    let _e542 = phi_738_;
                    if (_e462 < 0f) {
                        phi_743_ = 0u;
                    } else {
                        phi_743_ = 2u;
                    }
                    let _e545 = phi_743_;
                    if (_e472 < 0f) {
                        phi_748_ = 0u;
                    } else {
                        phi_748_ = 4u;
                    }
                    let _e548 = phi_748_;
                    let _e550 = ((_e542 | _e545) | _e548);
                    let _e551 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                    local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e551.first[0], _e551.first[1], _e551.first[2], _e551.first[3], _e551.first[4], _e551.first[5], _e551.first[6], _e551.first[7], _e551.first[8], _e551.first[9], _e551.first[10], _e551.first[11], _e551.first[12], _e551.first[13], _e551.first[14], _e551.first[15], _e551.first[16], _e551.first[17], _e551.first[18], _e551.first[19], _e551.first[20], _e551.first[21], _e551.first[22], _e551.first[23], _e551.first[24], _e551.first[25], _e551.first[26], _e551.first[27], _e551.first[28], _e551.first[29], _e551.first[30], _e551.first[31]), array<u32, 32>(_e551.mask[0], _e551.mask[1], _e551.mask[2], _e551.mask[3], _e551.mask[4], _e551.mask[5], _e551.mask[6], _e551.mask[7], _e551.mask[8], _e551.mask[9], _e551.mask[10], _e551.mask[11], _e551.mask[12], _e551.mask[13], _e551.mask[14], _e551.mask[15], _e551.mask[16], _e551.mask[17], _e551.mask[18], _e551.mask[19], _e551.mask[20], _e551.mask[21], _e551.mask[22], _e551.mask[23], _e551.mask[24], _e551.mask[25], _e551.mask[26], _e551.mask[27], _e551.mask[28], _e551.mask[29], _e551.mask[30], _e551.mask[31]), _e551.len, _e551.group, _e551.group_mask);
                    let _e625 = local_2.group_mask;
                    if ((_e625 & 4278190080u) == 0u) {
                        let _e629 = local_2.len;
                        if (_e629 == 0u) {
                            phi_862_ = false;
                        } else {
                            let _e633 = local_2.len;
                            local_2.len = (_e633 - 1u);
                            let _e636 = local_2.len;
                            if (_e636 < 32u) {
                            } else {
                                return;
                            }
                            let _e641 = local_2.first[(0u + _e636)];
                            local_2.group = _e641;
                            let _e644 = local_2.len;
                            if (_e644 < 32u) {
                            } else {
                                return;
                            }
                            let _e649 = local_2.mask[(0u + _e644)];
                            local_2.group_mask = _e649;
                            phi_862_ = true;
                        }
                        let _e652 = phi_862_;
                        phi_863_ = _e652;
                    } else {
                        phi_863_ = true;
                    }
                    let _e654 = phi_863_;
                    if _e654 {
                        let _e656 = local_2.group_mask;
                        let _e662 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e656)), 32u, (_e656 == 0u)));
                        let _e666 = local_2.group_mask;
                        let _e680 = local_2.group_mask;
                        local_2.group_mask = (_e680 & ~((1u << bitcast<u32>((_e662 & 31u)))));
                        let _e683 = local_2.group;
                        phi_894_ = (_e683 + countOneBits(((_e666 & ~((4294967295u << bitcast<u32>((((_e662 - 24u) ^ 7u) & 31u))))) & 255u)));
                    } else {
                        phi_894_ = 4294967295u;
                    }
                    let _e686 = phi_894_;
                    phi_896_ = _e686;
                    phi_899_ = vec3<f32>(1f, 1f, 1f);
                    loop {
                        let _e688 = phi_896_;
                        let _e690 = phi_899_;
                        local_12 = _e690;
                        if (_e688 != 4294967295u) {
                            if (_e688 < _e83) {
                            } else {
                                return;
                            }
                            let _e697 = nodes.member[(0u + _e688)].frame[3u];
                            let _e722 = (bitcast<f32>((((_e697 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e452);
                            let _e723 = (bitcast<f32>((((_e697 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e462);
                            let _e724 = (bitcast<f32>((((_e697 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e472);
                            let _e727 = nodes.member[(0u + _e688)].frame[0u];
                            let _e731 = nodes.member[(0u + _e688)].frame[1u];
                            let _e735 = nodes.member[(0u + _e688)].frame[2u];
                            let _e740 = ((bitcast<f32>(_e727) - _e293) * _e452);
                            let _e741 = ((bitcast<f32>(_e731) - _e295) * _e462);
                            let _e742 = ((bitcast<f32>(_e735) - _e297) * _e472);
                            let _e750 = nodes.member[(0u + _e688)].x;
                            if (_e452 < 0f) {
                                let _e761 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e750.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e767 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e761.unnamed.word, _e750.w), _e761.unnamed_1);
                                let _e773 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e767.unnamed, lt_mask_LightPlace(_e750.x, _e767.unnamed_1.shift));
                                phi_979_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e773.unnamed, lt_mask_LightPlace(_e773.unnamed_1.word, _e750.y));
                            } else {
                                let _e789 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e750.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e795 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e789.unnamed.word, _e750.y), _e789.unnamed_1);
                                let _e801 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e795.unnamed, lt_mask_LightPlace(_e750.z, _e795.unnamed_1.shift));
                                phi_979_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e801.unnamed, lt_mask_LightPlace(_e801.unnamed_1.word, _e750.w));
                            }
                            let _e809 = phi_979_;
                            let _e819 = nodes.member[(0u + _e688)].y;
                            if (_e462 < 0f) {
                                let _e830 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e819.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e836 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e830.unnamed.word, _e819.w), _e830.unnamed_1);
                                let _e842 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e836.unnamed, lt_mask_LightPlace(_e819.x, _e836.unnamed_1.shift));
                                phi_1006_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e842.unnamed, lt_mask_LightPlace(_e842.unnamed_1.word, _e819.y));
                            } else {
                                let _e858 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e819.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e864 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e858.unnamed.word, _e819.y), _e858.unnamed_1);
                                let _e870 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e864.unnamed, lt_mask_LightPlace(_e819.z, _e864.unnamed_1.shift));
                                phi_1006_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e870.unnamed, lt_mask_LightPlace(_e870.unnamed_1.word, _e819.w));
                            }
                            let _e878 = phi_1006_;
                            let _e888 = nodes.member[(0u + _e688)].z;
                            if (_e472 < 0f) {
                                let _e899 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e888.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e905 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e899.unnamed.word, _e888.w), _e899.unnamed_1);
                                let _e911 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e905.unnamed, lt_mask_LightPlace(_e888.x, _e905.unnamed_1.shift));
                                phi_1033_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e911.unnamed, lt_mask_LightPlace(_e911.unnamed_1.word, _e888.y));
                            } else {
                                let _e927 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e888.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e933 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e927.unnamed.word, _e888.y), _e927.unnamed_1);
                                let _e939 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e933.unnamed, lt_mask_LightPlace(_e888.z, _e933.unnamed_1.shift));
                                phi_1033_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e939.unnamed, lt_mask_LightPlace(_e939.unnamed_1.word, _e888.w));
                            }
                            let _e947 = phi_1033_;
                            phi_1039_ = 0u;
                            phi_1042_ = 0u;
                            loop {
                                let _e957 = phi_1039_;
                                let _e959 = phi_1042_;
                                local_3 = _e959;
                                local_4 = _e959;
                                local_5 = _e959;
                                let _e960 = (_e957 < 8u);
                                if _e960 {
                                    let _e962 = (_e957 >> bitcast<u32>(2i));
                                    let _e963 = (_e957 & 3u);
                                    if (_e962 == 0u) {
                                        phi_1056_ = _e809.unnamed.word;
                                    } else {
                                        phi_1056_ = _e809.unnamed.shift;
                                    }
                                    let _e966 = phi_1056_;
                                    if (_e962 == 0u) {
                                        phi_1066_ = _e878.unnamed.word;
                                    } else {
                                        phi_1066_ = _e878.unnamed.shift;
                                    }
                                    let _e975 = phi_1066_;
                                    if (_e962 == 0u) {
                                        phi_1076_ = _e947.unnamed.word;
                                    } else {
                                        phi_1076_ = _e947.unnamed.shift;
                                    }
                                    let _e984 = phi_1076_;
                                    let _e997 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e966 >> bitcast<u32>(((_e963 * 8u) & 31u))) & 255u)) * _e722) + (_e740 - _e500)), ((f32(((_e975 >> bitcast<u32>(((_e963 * 8u) & 31u))) & 255u)) * _e723) + (_e741 - _e501)));
                                    let _e998 = core_intrinsics_maximum_number_nsz_f32_(_e997, ((f32(((_e984 >> bitcast<u32>(((_e963 * 8u) & 31u))) & 255u)) * _e724) + (_e742 - _e502)));
                                    if (_e962 == 0u) {
                                        phi_1094_ = _e809.unnamed_1.word;
                                    } else {
                                        phi_1094_ = _e809.unnamed_1.shift;
                                    }
                                    let _e1001 = phi_1094_;
                                    if (_e962 == 0u) {
                                        phi_1104_ = _e878.unnamed_1.word;
                                    } else {
                                        phi_1104_ = _e878.unnamed_1.shift;
                                    }
                                    let _e1010 = phi_1104_;
                                    if (_e962 == 0u) {
                                        phi_1114_ = _e947.unnamed_1.word;
                                    } else {
                                        phi_1114_ = _e947.unnamed_1.shift;
                                    }
                                    let _e1019 = phi_1114_;
                                    let _e1032 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1001 >> bitcast<u32>(((_e963 * 8u) & 31u))) & 255u)) * _e722) + (_e740 + _e500)), ((f32(((_e1010 >> bitcast<u32>(((_e963 * 8u) & 31u))) & 255u)) * _e723) + (_e741 + _e501)));
                                    let _e1033 = core_intrinsics_minimum_number_nsz_f32_(_e1032, ((f32(((_e1019 >> bitcast<u32>(((_e963 * 8u) & 31u))) & 255u)) * _e724) + (_e742 + _e502)));
                                    if (_e998 <= _e1033) {
                                        if (_e998 <= _e303) {
                                            if (_e1033 >= 0f) {
                                                if (_e962 == 0u) {
                                                    let _e1040 = nodes.member[(0u + _e688)].links[2u];
                                                    phi_1150_ = _e1040;
                                                } else {
                                                    let _e1043 = nodes.member[(0u + _e688)].links[3u];
                                                    phi_1150_ = _e1043;
                                                }
                                                let _e1045 = phi_1150_;
                                                let _e1050 = ((_e1045 >> bitcast<u32>(((_e963 * 8u) & 31u))) & 255u);
                                                let _e1051 = (_e1050 & 31u);
                                                if (_e1051 >= 24u) {
                                                    phi_1163_ = (24u + ((_e1051 - 24u) ^ _e550));
                                                } else {
                                                    phi_1163_ = _e1051;
                                                }
                                                let _e1057 = phi_1163_;
                                                phi_1168_ = (_e959 | ((_e1050 >> bitcast<u32>(5i)) << bitcast<u32>((_e1057 & 31u))));
                                            } else {
                                                phi_1168_ = _e959;
                                            }
                                            let _e1065 = phi_1168_;
                                            phi_1169_ = _e1065;
                                        } else {
                                            phi_1169_ = _e959;
                                        }
                                        let _e1067 = phi_1169_;
                                        phi_1170_ = _e1067;
                                    } else {
                                        phi_1170_ = _e959;
                                    }
                                    let _e1069 = phi_1170_;
                                    phi_1040_ = (_e957 + 1u);
                                    phi_1043_ = _e1069;
                                } else {
                                    phi_1040_ = u32();
                                    phi_1043_ = u32();
                                }
                                let _e1072 = phi_1040_;
                                let _e1074 = phi_1043_;
                                continue;
                                continuing {
                                    phi_1039_ = _e1072;
                                    phi_1042_ = _e1074;
                                    break if !(_e960);
                                }
                            }
                            let _e1078 = nodes.member[(0u + _e688)].links[0u];
                            let _e1082 = nodes.member[(0u + _e688)].frame[3u];
                            let _e1086 = local_3;
                            if ((_e1086 & 4278190080u) == 0u) {
                            } else {
                                let _e1090 = local_2.group_mask;
                                if ((_e1090 & 4278190080u) == 0u) {
                                } else {
                                    let _e1094 = local_2.len;
                                    if (_e1094 < 32u) {
                                        let _e1097 = local_2.group;
                                        let _e1099 = local_2.len;
                                        if (_e1099 < 32u) {
                                        } else {
                                            return;
                                        }
                                        local_2.first[(0u + _e1099)] = _e1097;
                                        let _e1105 = local_2.group_mask;
                                        let _e1107 = local_2.len;
                                        if (_e1107 < 32u) {
                                        } else {
                                            return;
                                        }
                                        local_2.mask[(0u + _e1107)] = _e1105;
                                        let _e1114 = local_2.len;
                                        local_2.len = (_e1114 + 1u);
                                    }
                                }
                                local_2.group = (0u + _e1078);
                                let _e1118 = local_4;
                                local_2.group_mask = ((_e1118 & 4278190080u) | (_e1082 >> bitcast<u32>(24i)));
                            }
                            let _e1123 = local_5;
                            phi_1228_ = (_e1123 & 16777215u);
                            phi_1231_ = _e690;
                            loop {
                                let _e1126 = phi_1228_;
                                let _e1128 = phi_1231_;
                                local_8 = _e1128;
                                let _e1129 = (_e1126 == 0u);
                                local_6 = _e1129;
                                local_10 = _e1129;
                                if _e1129 {
                                    phi_1229_ = u32();
                                    phi_1232_ = vec3<f32>();
                                    phi_2320_ = vec3<f32>();
                                    phi_2321_ = false;
                                } else {
                                    let _e1132 = nodes.member[(0u + _e688)].links[1u];
                                    let _e1137 = ((0u + _e1132) + select(firstTrailingBit(_e1126), 32u, (_e1126 == 0u)));
                                    if (_e1137 < _e86) {
                                    } else {
                                        return;
                                    }
                                    let _e1144 = triangles.member[(0u + _e1137)].v0_;
                                    let _e1146 = (_e1144.x - _e293);
                                    let _e1148 = (_e1144.y - _e295);
                                    let _e1150 = (_e1144.z - _e297);
                                    if (_e523 == 0u) {
                                        phi_1276_ = vec3<f32>(_e1148, _e1150, _e1146);
                                    } else {
                                        if (_e523 == 1u) {
                                            phi_1275_ = vec3<f32>(_e1150, _e1146, _e1148);
                                        } else {
                                            phi_1275_ = (_e1144 - vec3<f32>(_e293, _e295, _e297));
                                        }
                                        let _e1158 = phi_1275_;
                                        phi_1276_ = _e1158;
                                    }
                                    let _e1160 = phi_1276_;
                                    let _e1164 = (_e1160.x - (_e534 * _e1160.z));
                                    let _e1168 = (_e1160.y - (_e537 * _e1160.z));
                                    let _e1170 = triangles.member[(0u + _e1137)].v1_;
                                    let _e1172 = (_e1170.x - _e293);
                                    let _e1174 = (_e1170.y - _e295);
                                    let _e1176 = (_e1170.z - _e297);
                                    if (_e523 == 0u) {
                                        phi_1306_ = vec3<f32>(_e1174, _e1176, _e1172);
                                    } else {
                                        if (_e523 == 1u) {
                                            phi_1305_ = vec3<f32>(_e1176, _e1172, _e1174);
                                        } else {
                                            phi_1305_ = (_e1170 - vec3<f32>(_e293, _e295, _e297));
                                        }
                                        let _e1184 = phi_1305_;
                                        phi_1306_ = _e1184;
                                    }
                                    let _e1186 = phi_1306_;
                                    let _e1190 = (_e1186.x - (_e534 * _e1186.z));
                                    let _e1194 = (_e1186.y - (_e537 * _e1186.z));
                                    let _e1196 = triangles.member[(0u + _e1137)].v2_;
                                    let _e1198 = (_e1196.x - _e293);
                                    let _e1200 = (_e1196.y - _e295);
                                    let _e1202 = (_e1196.z - _e297);
                                    if (_e523 == 0u) {
                                        phi_1336_ = vec3<f32>(_e1200, _e1202, _e1198);
                                    } else {
                                        if (_e523 == 1u) {
                                            phi_1335_ = vec3<f32>(_e1202, _e1198, _e1200);
                                        } else {
                                            phi_1335_ = (_e1196 - vec3<f32>(_e293, _e295, _e297));
                                        }
                                        let _e1210 = phi_1335_;
                                        phi_1336_ = _e1210;
                                    }
                                    let _e1212 = phi_1336_;
                                    let _e1216 = (_e1212.x - (_e534 * _e1212.z));
                                    let _e1220 = (_e1212.y - (_e537 * _e1212.z));
                                    if (_e1190 < _e1216) {
                                        phi_1355_ = true;
                                    } else {
                                        if (_e1190 == _e1216) {
                                            phi_1354_ = (_e1194 < _e1220);
                                        } else {
                                            phi_1354_ = false;
                                        }
                                        let _e1225 = phi_1354_;
                                        phi_1355_ = _e1225;
                                    }
                                    let _e1227 = phi_1355_;
                                    if _e1227 {
                                        phi_1359_ = _e1220;
                                        phi_1360_ = _e1216;
                                        phi_1361_ = _e1194;
                                        phi_1362_ = _e1190;
                                    } else {
                                        phi_1359_ = _e1194;
                                        phi_1360_ = _e1190;
                                        phi_1361_ = _e1220;
                                        phi_1362_ = _e1216;
                                    }
                                    let _e1229 = phi_1359_;
                                    let _e1231 = phi_1360_;
                                    let _e1233 = phi_1361_;
                                    let _e1235 = phi_1362_;
                                    let _e1238 = ((_e1235 * _e1229) - (_e1233 * _e1231));
                                    if _e1227 {
                                        phi_1370_ = -(_e1238);
                                    } else {
                                        phi_1370_ = _e1238;
                                    }
                                    let _e1241 = phi_1370_;
                                    if (_e1216 < _e1164) {
                                        phi_1381_ = true;
                                    } else {
                                        if (_e1216 == _e1164) {
                                            phi_1380_ = (_e1220 < _e1168);
                                        } else {
                                            phi_1380_ = false;
                                        }
                                        let _e1246 = phi_1380_;
                                        phi_1381_ = _e1246;
                                    }
                                    let _e1248 = phi_1381_;
                                    if _e1248 {
                                        phi_1385_ = _e1168;
                                        phi_1386_ = _e1164;
                                        phi_1387_ = _e1220;
                                        phi_1388_ = _e1216;
                                    } else {
                                        phi_1385_ = _e1220;
                                        phi_1386_ = _e1216;
                                        phi_1387_ = _e1168;
                                        phi_1388_ = _e1164;
                                    }
                                    let _e1250 = phi_1385_;
                                    let _e1252 = phi_1386_;
                                    let _e1254 = phi_1387_;
                                    let _e1256 = phi_1388_;
                                    let _e1259 = ((_e1256 * _e1250) - (_e1254 * _e1252));
                                    if _e1248 {
                                        phi_1396_ = -(_e1259);
                                    } else {
                                        phi_1396_ = _e1259;
                                    }
                                    let _e1262 = phi_1396_;
                                    if (_e1164 < _e1190) {
                                        phi_1407_ = true;
                                    } else {
                                        if (_e1164 == _e1190) {
                                            phi_1406_ = (_e1168 < _e1194);
                                        } else {
                                            phi_1406_ = false;
                                        }
                                        let _e1267 = phi_1406_;
                                        phi_1407_ = _e1267;
                                    }
                                    let _e1269 = phi_1407_;
                                    if _e1269 {
                                        phi_1411_ = _e1194;
                                        phi_1412_ = _e1190;
                                        phi_1413_ = _e1168;
                                        phi_1414_ = _e1164;
                                    } else {
                                        phi_1411_ = _e1168;
                                        phi_1412_ = _e1164;
                                        phi_1413_ = _e1194;
                                        phi_1414_ = _e1190;
                                    }
                                    let _e1271 = phi_1411_;
                                    let _e1273 = phi_1412_;
                                    let _e1275 = phi_1413_;
                                    let _e1277 = phi_1414_;
                                    let _e1280 = ((_e1277 * _e1271) - (_e1275 * _e1273));
                                    if _e1269 {
                                        phi_1422_ = -(_e1280);
                                    } else {
                                        phi_1422_ = _e1280;
                                    }
                                    let _e1283 = phi_1422_;
                                    if (_e1241 >= 0f) {
                                        if (_e1262 >= 0f) {
                                            if (_e1283 >= 0f) {
                                                phi_1437_ = ((_e1241 + _e1262) + _e1283);
                                                phi_1438_ = false;
                                            } else {
                                                phi_1437_ = f32();
                                                phi_1438_ = true;
                                            }
                                            let _e1290 = phi_1437_;
                                            let _e1292 = phi_1438_;
                                            phi_1439_ = _e1290;
                                            phi_1440_ = _e1292;
                                        } else {
                                            phi_1439_ = f32();
                                            phi_1440_ = true;
                                        }
                                        let _e1294 = phi_1439_;
                                        let _e1296 = phi_1440_;
                                        phi_1441_ = _e1294;
                                        phi_1442_ = _e1296;
                                    } else {
                                        phi_1441_ = f32();
                                        phi_1442_ = true;
                                    }
                                    let _e1298 = phi_1441_;
                                    let _e1300 = phi_1442_;
                                    if _e1300 {
                                        if (_e1241 <= 0f) {
                                            if (_e1262 <= 0f) {
                                                let _e1303 = (_e1283 <= 0f);
                                                if _e1303 {
                                                }
                                                phi_1460_ = ((_e1241 + _e1262) + _e1283);
                                                phi_1461_ = false;
                                                phi_1462_ = _e1303;
                                            } else {
                                                phi_1460_ = f32();
                                                phi_1461_ = true;
                                                phi_1462_ = false;
                                            }
                                            let _e1307 = phi_1460_;
                                            let _e1309 = phi_1461_;
                                            let _e1311 = phi_1462_;
                                            phi_1463_ = _e1307;
                                            phi_1464_ = _e1309;
                                            phi_1465_ = _e1311;
                                        } else {
                                            phi_1463_ = f32();
                                            phi_1464_ = true;
                                            phi_1465_ = false;
                                        }
                                        let _e1313 = phi_1463_;
                                        let _e1315 = phi_1464_;
                                        let _e1317 = phi_1465_;
                                        if _e1315 {
                                            phi_1469_ = false;
                                        } else {
                                            phi_1469_ = _e1317;
                                        }
                                        let _e1319 = phi_1469_;
                                        phi_1470_ = _e1313;
                                        phi_1471_ = _e1319;
                                    } else {
                                        phi_1470_ = _e1298;
                                        phi_1471_ = true;
                                    }
                                    let _e1321 = phi_1470_;
                                    let _e1323 = phi_1471_;
                                    if _e1323 {
                                        let _e1324 = (_e1321 == 0f);
                                        if _e1324 {
                                            phi_1787_ = lt_bvh_triangle_Intersection();
                                            phi_1788_ = false;
                                        } else {
                                            let _e1326 = triangles.member[(0u + _e1137)].v0_;
                                            let _e1328 = (_e1326.x - _e293);
                                            let _e1330 = (_e1326.y - _e295);
                                            let _e1332 = (_e1326.z - _e297);
                                            if (_e523 == 0u) {
                                                phi_1500_ = vec3<f32>(_e1330, _e1332, _e1328);
                                            } else {
                                                if (_e523 == 1u) {
                                                    phi_1499_ = vec3<f32>(_e1332, _e1328, _e1330);
                                                } else {
                                                    phi_1499_ = (_e1326 - vec3<f32>(_e293, _e295, _e297));
                                                }
                                                let _e1340 = phi_1499_;
                                                phi_1500_ = _e1340;
                                            }
                                            let _e1342 = phi_1500_;
                                            let _e1344 = triangles.member[(0u + _e1137)].v1_;
                                            let _e1346 = triangles.member[(0u + _e1137)].v0_;
                                            let _e1349 = (_e1344.x - _e1346.x);
                                            let _e1352 = (_e1344.y - _e1346.y);
                                            let _e1355 = (_e1344.z - _e1346.z);
                                            if (_e523 == 0u) {
                                                phi_1526_ = vec3<f32>(_e1352, _e1355, _e1349);
                                            } else {
                                                if (_e523 == 1u) {
                                                    phi_1525_ = vec3<f32>(_e1355, _e1349, _e1352);
                                                } else {
                                                    phi_1525_ = (_e1344 - _e1346);
                                                }
                                                let _e1362 = phi_1525_;
                                                phi_1526_ = _e1362;
                                            }
                                            let _e1364 = phi_1526_;
                                            let _e1366 = triangles.member[(0u + _e1137)].v2_;
                                            let _e1368 = triangles.member[(0u + _e1137)].v0_;
                                            let _e1371 = (_e1366.x - _e1368.x);
                                            let _e1374 = (_e1366.y - _e1368.y);
                                            let _e1377 = (_e1366.z - _e1368.z);
                                            if (_e523 == 0u) {
                                                phi_1552_ = vec3<f32>(_e1374, _e1377, _e1371);
                                            } else {
                                                if (_e523 == 1u) {
                                                    phi_1551_ = vec3<f32>(_e1377, _e1371, _e1374);
                                                } else {
                                                    phi_1551_ = (_e1366 - _e1368);
                                                }
                                                let _e1384 = phi_1551_;
                                                phi_1552_ = _e1384;
                                            }
                                            let _e1386 = phi_1552_;
                                            let _e1393 = ((_e1364.y * _e1386.z) - (_e1364.z * _e1386.y));
                                            let _e1400 = ((_e1364.z * _e1386.x) - (_e1364.x * _e1386.z));
                                            let _e1407 = ((_e1364.x * _e1386.y) - (_e1364.y * _e1386.x));
                                            let _e1421 = (((1f / _e531.z) * (((_e1393 * _e1342.x) + (_e1400 * _e1342.y)) + (_e1407 * _e1342.z))) / (((_e1393 * _e534) + (_e1400 * _e537)) + _e1407));
                                            if (_e1421 > 0f) {
                                                if (_e1421 < _e303) {
                                                    let _e1425 = triangles.member[(0u + _e1137)].v0_;
                                                    let _e1427 = triangles.member[(0u + _e1137)].v1_;
                                                    if (_e1425.x < _e1427.x) {
                                                        phi_1608_ = _e1425.x;
                                                    } else {
                                                        phi_1608_ = _e1427.x;
                                                    }
                                                    let _e1434 = phi_1608_;
                                                    if (_e1425.y < _e1427.y) {
                                                        phi_1617_ = _e1425.y;
                                                    } else {
                                                        phi_1617_ = _e1427.y;
                                                    }
                                                    let _e1441 = phi_1617_;
                                                    if (_e1425.z < _e1427.z) {
                                                        phi_1626_ = _e1425.z;
                                                    } else {
                                                        phi_1626_ = _e1427.z;
                                                    }
                                                    let _e1448 = phi_1626_;
                                                    let _e1450 = triangles.member[(0u + _e1137)].v2_;
                                                    if (_e1434 < _e1450.x) {
                                                        phi_1635_ = _e1434;
                                                    } else {
                                                        phi_1635_ = _e1450.x;
                                                    }
                                                    let _e1455 = phi_1635_;
                                                    if (_e1441 < _e1450.y) {
                                                        phi_1642_ = _e1441;
                                                    } else {
                                                        phi_1642_ = _e1450.y;
                                                    }
                                                    let _e1460 = phi_1642_;
                                                    if (_e1448 < _e1450.z) {
                                                        phi_1649_ = _e1448;
                                                    } else {
                                                        phi_1649_ = _e1450.z;
                                                    }
                                                    let _e1465 = phi_1649_;
                                                    let _e1467 = triangles.member[(0u + _e1137)].v0_;
                                                    let _e1469 = triangles.member[(0u + _e1137)].v1_;
                                                    if (_e1467.x > _e1469.x) {
                                                        phi_1662_ = _e1467.x;
                                                    } else {
                                                        phi_1662_ = _e1469.x;
                                                    }
                                                    let _e1476 = phi_1662_;
                                                    if (_e1467.y > _e1469.y) {
                                                        phi_1671_ = _e1467.y;
                                                    } else {
                                                        phi_1671_ = _e1469.y;
                                                    }
                                                    let _e1483 = phi_1671_;
                                                    if (_e1467.z > _e1469.z) {
                                                        phi_1680_ = _e1467.z;
                                                    } else {
                                                        phi_1680_ = _e1469.z;
                                                    }
                                                    let _e1490 = phi_1680_;
                                                    let _e1492 = triangles.member[(0u + _e1137)].v2_;
                                                    if (_e1476 > _e1492.x) {
                                                        phi_1689_ = _e1476;
                                                    } else {
                                                        phi_1689_ = _e1492.x;
                                                    }
                                                    let _e1497 = phi_1689_;
                                                    if (_e1483 > _e1492.y) {
                                                        phi_1696_ = _e1483;
                                                    } else {
                                                        phi_1696_ = _e1492.y;
                                                    }
                                                    let _e1502 = phi_1696_;
                                                    if (_e1490 > _e1492.z) {
                                                        phi_1703_ = _e1490;
                                                    } else {
                                                        phi_1703_ = _e1492.z;
                                                    }
                                                    let _e1507 = phi_1703_;
                                                    let _e1511 = ((_e1455 - _e293) * _e452);
                                                    let _e1512 = ((_e1460 - _e295) * _e462);
                                                    let _e1513 = ((_e1465 - _e297) * _e472);
                                                    let _e1517 = ((_e1497 - _e293) * _e452);
                                                    let _e1518 = ((_e1502 - _e295) * _e462);
                                                    let _e1519 = ((_e1507 - _e297) * _e472);
                                                    if (_e1511 < _e1517) {
                                                        phi_1720_ = _e1511;
                                                    } else {
                                                        phi_1720_ = _e1517;
                                                    }
                                                    let _e1522 = phi_1720_;
                                                    if (_e1512 < _e1518) {
                                                        phi_1725_ = _e1512;
                                                    } else {
                                                        phi_1725_ = _e1518;
                                                    }
                                                    let _e1525 = phi_1725_;
                                                    if (_e1513 < _e1519) {
                                                        phi_1730_ = _e1513;
                                                    } else {
                                                        phi_1730_ = _e1519;
                                                    }
                                                    let _e1528 = phi_1730_;
                                                    if (_e1511 > _e1517) {
                                                        phi_1738_ = _e1511;
                                                    } else {
                                                        phi_1738_ = _e1517;
                                                    }
                                                    let _e1534 = phi_1738_;
                                                    if (_e1512 > _e1518) {
                                                        phi_1743_ = _e1512;
                                                    } else {
                                                        phi_1743_ = _e1518;
                                                    }
                                                    let _e1537 = phi_1743_;
                                                    if (_e1513 > _e1519) {
                                                        phi_1748_ = _e1513;
                                                    } else {
                                                        phi_1748_ = _e1519;
                                                    }
                                                    let _e1540 = phi_1748_;
                                                    let _e1544 = core_intrinsics_maximum_number_nsz_f32_((_e1522 - _e507), (_e1525 - _e508));
                                                    let _e1545 = core_intrinsics_maximum_number_nsz_f32_(_e1544, (_e1528 - _e509));
                                                    let _e1546 = core_intrinsics_minimum_number_nsz_f32_((_e1534 + _e507), (_e1537 + _e508));
                                                    let _e1547 = core_intrinsics_minimum_number_nsz_f32_(_e1546, (_e1540 + _e509));
                                                    if (_e1545 > -300000000000000000000000000000000000000f) {
                                                        phi_1760_ = _e1545;
                                                    } else {
                                                        phi_1760_ = -300000000000000000000000000000000000000f;
                                                    }
                                                    let _e1550 = phi_1760_;
                                                    if (_e1547 < 300000000000000000000000000000000000000f) {
                                                        phi_1765_ = _e1547;
                                                    } else {
                                                        phi_1765_ = 300000000000000000000000000000000000000f;
                                                    }
                                                    let _e1553 = phi_1765_;
                                                    if (_e1421 < _e1550) {
                                                        phi_1770_ = _e1550;
                                                    } else {
                                                        phi_1770_ = _e1421;
                                                    }
                                                    let _e1556 = phi_1770_;
                                                    if (_e1556 > _e1553) {
                                                        phi_1775_ = _e1553;
                                                    } else {
                                                        phi_1775_ = _e1556;
                                                    }
                                                    let _e1559 = phi_1775_;
                                                    phi_1780_ = lt_bvh_triangle_Intersection(_e1559, (_e1262 / _e1321), (_e1283 / _e1321), (_e1550 <= _e1553));
                                                    phi_1781_ = false;
                                                } else {
                                                    phi_1780_ = lt_bvh_triangle_Intersection();
                                                    phi_1781_ = true;
                                                }
                                                let _e1565 = phi_1780_;
                                                let _e1567 = phi_1781_;
                                                phi_1782_ = _e1565;
                                                phi_1783_ = _e1567;
                                            } else {
                                                phi_1782_ = lt_bvh_triangle_Intersection();
                                                phi_1783_ = true;
                                            }
                                            let _e1569 = phi_1782_;
                                            let _e1571 = phi_1783_;
                                            if _e1571 {
                                            }
                                            phi_1787_ = _e1569;
                                            phi_1788_ = _e1571;
                                        }
                                        let _e1573 = phi_1787_;
                                        let _e1575 = phi_1788_;
                                        phi_1789_ = _e1573;
                                        phi_1790_ = _e1324;
                                        phi_1791_ = _e1575;
                                    } else {
                                        phi_1789_ = lt_bvh_triangle_Intersection();
                                        phi_1790_ = true;
                                        phi_1791_ = false;
                                    }
                                    let _e1577 = phi_1789_;
                                    let _e1579 = phi_1790_;
                                    let _e1581 = phi_1791_;
                                    if _e1579 {
                                        phi_1795_ = true;
                                    } else {
                                        phi_1795_ = _e1581;
                                    }
                                    let _e1583 = phi_1795_;
                                    if _e1583 {
                                        phi_1799_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                    } else {
                                        phi_1799_ = _e1577;
                                    }
                                    let _e1585 = phi_1799_;
                                    if _e1585.is_hit {
                                        if (_e1585.t > 0f) {
                                            if (_e1585.t < _e303) {
                                                if (_e1137 < _e86) {
                                                } else {
                                                    return;
                                                }
                                                let _e1599 = triangles.member[(0u + _e1137)].i0_;
                                                let _e1600 = (_e1599 & 2147483647u);
                                                let _e1602 = triangles.member[(0u + _e1137)].i1_;
                                                let _e1604 = triangles.member[(0u + _e1137)].i2_;
                                                if (_e1600 < _e95) {
                                                } else {
                                                    return;
                                                }
                                                let _e1608 = vertices.member[(0u + _e1600)];
                                                if (_e1602 < _e95) {
                                                } else {
                                                    return;
                                                }
                                                let _e1612 = vertices.member[(0u + _e1602)];
                                                if (_e1604 < _e95) {
                                                } else {
                                                    return;
                                                }
                                                let _e1616 = vertices.member[(0u + _e1604)];
                                                let _e1617 = array<abi_Vertex, 3>(_e1608, _e1612, _e1616);
                                                if (_e1617[0].material < arrayLength((&materials.member))) {
                                                } else {
                                                    return;
                                                }
                                                let _e1623 = materials.member[(0u + _e1617[0].material)];
                                                let _e1625 = ((1f - _e1585.u) - _e1585.v);
                                                if (_e1623.cutoff <= 0f) {
                                                    phi_2028_ = 1f;
                                                } else {
                                                    let _e1652 = (_e1623.base_color.w * ((((f32((_e1617[0].color >> bitcast<u32>(24i))) * _e1625) + (f32((_e1617[1].color >> bitcast<u32>(24i))) * _e1585.u)) + (f32((_e1617[2].color >> bitcast<u32>(24i))) * _e1585.v)) * (1f / 255f)));
                                                    if (_e1623.alpha_size == 0u) {
                                                        phi_2004_ = _e1652;
                                                    } else {
                                                        local_1.offset = _e1623.alpha_offset;
                                                        local_1.size = _e1623.alpha_size;
                                                        local_1.flags = _e1623.flags;
                                                        let _e1683 = _lt_shaders_texture_TextureView_quad((&local_1), (((_e1617[0].u * _e1625) + (_e1617[1].u * _e1585.u)) + (_e1617[2].u * _e1585.v)), (((_e1617[0].v * _e1625) + (_e1617[1].v * _e1585.u)) + (_e1617[2].v * _e1585.v)));
                                                        let _e1687 = (_e1683.indices[0] >> bitcast<u32>(2i));
                                                        if (_e1687 < _e101) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1691 = alpha_texels.member[(0u + _e1687)];
                                                        let _e1707 = (_e1683.indices[1] >> bitcast<u32>(2i));
                                                        if (_e1707 < _e101) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1711 = alpha_texels.member[(0u + _e1707)];
                                                        let _e1728 = (_e1683.indices[2] >> bitcast<u32>(2i));
                                                        if (_e1728 < _e101) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1732 = alpha_texels.member[(0u + _e1728)];
                                                        let _e1749 = (_e1683.indices[3] >> bitcast<u32>(2i));
                                                        if (_e1749 < _e101) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1753 = alpha_texels.member[(0u + _e1749)];
                                                        phi_2004_ = (_e1652 * (((((f32(((_e1691 >> bitcast<u32>((((_e1683.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1683.weights.x) + ((f32(((_e1711 >> bitcast<u32>((((_e1683.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1683.weights.y)) + ((f32(((_e1732 >> bitcast<u32>((((_e1683.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1683.weights.z)) + ((f32(((_e1753 >> bitcast<u32>((((_e1683.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1683.weights.w)));
                                                    }
                                                    let _e1769 = phi_2004_;
                                                    if ((_e1623.flags & 8u) == 0u) {
                                                        if (_e1769 >= _e1623.cutoff) {
                                                            phi_2016_ = 1f;
                                                        } else {
                                                            phi_2016_ = 0f;
                                                        }
                                                        let _e1776 = phi_2016_;
                                                        phi_2027_ = _e1776;
                                                    } else {
                                                        if (_e1769 > 0f) {
                                                            if (_e1769 < 1f) {
                                                                phi_2025_ = _e1769;
                                                            } else {
                                                                phi_2025_ = 1f;
                                                            }
                                                            let _e1780 = phi_2025_;
                                                            phi_2026_ = _e1780;
                                                        } else {
                                                            phi_2026_ = 0f;
                                                        }
                                                        let _e1782 = phi_2026_;
                                                        phi_2027_ = _e1782;
                                                    }
                                                    let _e1784 = phi_2027_;
                                                    phi_2028_ = _e1784;
                                                }
                                                let _e1786 = phi_2028_;
                                                let _e1803 = (1f / 255f);
                                                let _e1822 = (1f / 255f);
                                                let _e1844 = (1f / 255f);
                                                if (_e1623.color_size == 0u) {
                                                    phi_2227_ = vec3<f32>(1f, 1f, 1f);
                                                } else {
                                                    local.offset = _e1623.color_offset;
                                                    local.size = _e1623.color_size;
                                                    local.flags = _e1623.flags;
                                                    let _e1887 = _lt_shaders_texture_TextureView_quad((&local), (((_e1617[0].u * _e1625) + (_e1617[1].u * _e1585.u)) + (_e1617[2].u * _e1585.v)), (((_e1617[0].v * _e1625) + (_e1617[1].v * _e1585.u)) + (_e1617[2].v * _e1585.v)));
                                                    if (_e1887.indices[0] < _e104) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1893 = color_texels.member[(0u + _e1887.indices[0])];
                                                    let _e1904 = (1f / 255f);
                                                    if (_e1887.indices[1] < _e104) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1918 = color_texels.member[(0u + _e1887.indices[1])];
                                                    let _e1929 = (1f / 255f);
                                                    if (_e1887.indices[2] < _e104) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1946 = color_texels.member[(0u + _e1887.indices[2])];
                                                    let _e1957 = (1f / 255f);
                                                    if (_e1887.indices[3] < _e104) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1974 = color_texels.member[(0u + _e1887.indices[3])];
                                                    let _e1985 = (1f / 255f);
                                                    let _e1994 = (((((f32((_e1893 & 255u)) * _e1904) * _e1887.weights.x) + ((f32((_e1918 & 255u)) * _e1929) * _e1887.weights.y)) + ((f32((_e1946 & 255u)) * _e1957) * _e1887.weights.z)) + ((f32((_e1974 & 255u)) * _e1985) * _e1887.weights.w));
                                                    let _e1995 = (((((f32(((_e1893 >> bitcast<u32>(8i)) & 255u)) * _e1904) * _e1887.weights.x) + ((f32(((_e1918 >> bitcast<u32>(8i)) & 255u)) * _e1929) * _e1887.weights.y)) + ((f32(((_e1946 >> bitcast<u32>(8i)) & 255u)) * _e1957) * _e1887.weights.z)) + ((f32(((_e1974 >> bitcast<u32>(8i)) & 255u)) * _e1985) * _e1887.weights.w));
                                                    let _e1996 = (((((f32(((_e1893 >> bitcast<u32>(16i)) & 255u)) * _e1904) * _e1887.weights.x) + ((f32(((_e1918 >> bitcast<u32>(16i)) & 255u)) * _e1929) * _e1887.weights.y)) + ((f32(((_e1946 >> bitcast<u32>(16i)) & 255u)) * _e1957) * _e1887.weights.z)) + ((f32(((_e1974 >> bitcast<u32>(16i)) & 255u)) * _e1985) * _e1887.weights.w));
                                                    phi_2227_ = vec3<f32>((_e1994 * _e1994), (_e1995 * _e1995), (_e1996 * _e1996));
                                                }
                                                let _e2002 = phi_2227_;
                                                let _e2010 = (_e1786 * _e1623.transmission);
                                                let _e2014 = (1f - _e1786);
                                                let _e2015 = ((((_e1623.base_color.x * ((((f32((_e1617[0].color & 255u)) * _e1803) * _e1625) + ((f32((_e1617[1].color & 255u)) * _e1822) * _e1585.u)) + ((f32((_e1617[2].color & 255u)) * _e1844) * _e1585.v))) * _e2002.x) * _e2010) + _e2014);
                                                let _e2016 = ((((_e1623.base_color.y * ((((f32(((_e1617[0].color >> bitcast<u32>(8i)) & 255u)) * _e1803) * _e1625) + ((f32(((_e1617[1].color >> bitcast<u32>(8i)) & 255u)) * _e1822) * _e1585.u)) + ((f32(((_e1617[2].color >> bitcast<u32>(8i)) & 255u)) * _e1844) * _e1585.v))) * _e2002.y) * _e2010) + _e2014);
                                                let _e2017 = ((((_e1623.base_color.z * ((((f32(((_e1617[0].color >> bitcast<u32>(16i)) & 255u)) * _e1803) * _e1625) + ((f32(((_e1617[1].color >> bitcast<u32>(16i)) & 255u)) * _e1822) * _e1585.u)) + ((f32(((_e1617[2].color >> bitcast<u32>(16i)) & 255u)) * _e1844) * _e1585.v))) * _e2002.z) * _e2010) + _e2014);
                                                if (_e2015 > 0f) {
                                                    if (_e2015 < 1f) {
                                                        phi_2251_ = _e2015;
                                                    } else {
                                                        phi_2251_ = 1f;
                                                    }
                                                    let _e2021 = phi_2251_;
                                                    phi_2252_ = _e2021;
                                                } else {
                                                    phi_2252_ = 0f;
                                                }
                                                let _e2023 = phi_2252_;
                                                if (_e2016 > 0f) {
                                                    if (_e2016 < 1f) {
                                                        phi_2261_ = _e2016;
                                                    } else {
                                                        phi_2261_ = 1f;
                                                    }
                                                    let _e2027 = phi_2261_;
                                                    phi_2262_ = _e2027;
                                                } else {
                                                    phi_2262_ = 0f;
                                                }
                                                let _e2029 = phi_2262_;
                                                if (_e2017 > 0f) {
                                                    if (_e2017 < 1f) {
                                                        phi_2271_ = _e2017;
                                                    } else {
                                                        phi_2271_ = 1f;
                                                    }
                                                    let _e2033 = phi_2271_;
                                                    phi_2272_ = _e2033;
                                                } else {
                                                    phi_2272_ = 0f;
                                                }
                                                let _e2035 = phi_2272_;
                                                let _e2043 = (_e1128 * vec3<f32>(_e2023, _e2029, _e2035));
                                                let _e2045 = global[0u];
                                                if ((_e1128.x * _e2023) == _e2045) {
                                                    let _e2048 = global[1u];
                                                    if ((_e1128.y * _e2029) == _e2048) {
                                                        let _e2051 = global[2u];
                                                        phi_2296_ = ((_e1128.z * _e2035) == _e2051);
                                                        phi_2297_ = false;
                                                    } else {
                                                        phi_2296_ = bool();
                                                        phi_2297_ = true;
                                                    }
                                                    let _e2054 = phi_2296_;
                                                    let _e2056 = phi_2297_;
                                                    phi_2298_ = _e2054;
                                                    phi_2299_ = _e2056;
                                                } else {
                                                    phi_2298_ = bool();
                                                    phi_2299_ = true;
                                                }
                                                let _e2058 = phi_2298_;
                                                let _e2060 = phi_2299_;
                                                if _e2060 {
                                                    phi_2303_ = false;
                                                } else {
                                                    phi_2303_ = _e2058;
                                                }
                                                let _e2062 = phi_2303_;
                                                if _e2062 {
                                                    phi_2307_ = false;
                                                } else {
                                                    phi_2307_ = true;
                                                }
                                                let _e2064 = phi_2307_;
                                                phi_2308_ = _e2043;
                                                phi_2309_ = _e2043;
                                                phi_2310_ = _e2064;
                                            } else {
                                                phi_2308_ = vec3<f32>();
                                                phi_2309_ = _e1128;
                                                phi_2310_ = true;
                                            }
                                            let _e2066 = phi_2308_;
                                            let _e2068 = phi_2309_;
                                            let _e2070 = phi_2310_;
                                            phi_2311_ = _e2066;
                                            phi_2312_ = _e2068;
                                            phi_2313_ = _e2070;
                                        } else {
                                            phi_2311_ = vec3<f32>();
                                            phi_2312_ = _e1128;
                                            phi_2313_ = true;
                                        }
                                        let _e2072 = phi_2311_;
                                        let _e2074 = phi_2312_;
                                        let _e2076 = phi_2313_;
                                        phi_2314_ = _e2072;
                                        phi_2315_ = _e2074;
                                        phi_2316_ = _e2076;
                                    } else {
                                        phi_2314_ = vec3<f32>();
                                        phi_2315_ = _e1128;
                                        phi_2316_ = true;
                                    }
                                    let _e2078 = phi_2314_;
                                    let _e2080 = phi_2315_;
                                    let _e2082 = phi_2316_;
                                    if _e2082 {
                                    }
                                    phi_1229_ = (_e1126 & (_e1126 - 1u));
                                    phi_1232_ = _e2080;
                                    phi_2320_ = _e2078;
                                    phi_2321_ = _e2082;
                                }
                                let _e2084 = phi_1229_;
                                let _e2086 = phi_1232_;
                                let _e2088 = phi_2320_;
                                let _e2090 = phi_2321_;
                                local_9 = _e2088;
                                continue;
                                continuing {
                                    phi_1228_ = _e2084;
                                    phi_1231_ = _e2086;
                                    break if !(_e2090);
                                }
                            }
                            let _e2093 = local_6;
                            if _e2093 {
                                let _e2095 = local_2.group_mask;
                                if ((_e2095 & 4278190080u) == 0u) {
                                    let _e2099 = local_2.len;
                                    if (_e2099 == 0u) {
                                        phi_2363_ = false;
                                    } else {
                                        let _e2103 = local_2.len;
                                        local_2.len = (_e2103 - 1u);
                                        let _e2106 = local_2.len;
                                        if (_e2106 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e2111 = local_2.first[(0u + _e2106)];
                                        local_2.group = _e2111;
                                        let _e2114 = local_2.len;
                                        if (_e2114 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e2119 = local_2.mask[(0u + _e2114)];
                                        local_2.group_mask = _e2119;
                                        phi_2363_ = true;
                                    }
                                    let _e2122 = phi_2363_;
                                    phi_2364_ = _e2122;
                                } else {
                                    phi_2364_ = true;
                                }
                                let _e2124 = phi_2364_;
                                if _e2124 {
                                    let _e2126 = local_2.group_mask;
                                    let _e2132 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2126)), 32u, (_e2126 == 0u)));
                                    let _e2136 = local_2.group_mask;
                                    let _e2150 = local_2.group_mask;
                                    local_2.group_mask = (_e2150 & ~((1u << bitcast<u32>((_e2132 & 31u)))));
                                    let _e2153 = local_2.group;
                                    phi_2395_ = (_e2153 + countOneBits(((_e2136 & ~((4294967295u << bitcast<u32>((((_e2132 - 24u) ^ _e550) & 31u))))) & 255u)));
                                } else {
                                    phi_2395_ = 4294967295u;
                                }
                                let _e2156 = phi_2395_;
                                phi_2396_ = _e2156;
                            } else {
                                phi_2396_ = u32();
                            }
                            let _e2158 = phi_2396_;
                            phi_897_ = _e2158;
                            let _e2398 = local_8;
                            phi_900_ = _e2398;
                            let _e2401 = local_9;
                            phi_2397_ = _e2401;
                            let _e2404 = local_10;
                            phi_2398_ = _e2404;
                            phi_2399_ = false;
                        } else {
                            phi_897_ = u32();
                            phi_900_ = vec3<f32>();
                            phi_2397_ = vec3<f32>();
                            phi_2398_ = false;
                            phi_2399_ = true;
                        }
                        let _e2160 = phi_897_;
                        let _e2162 = phi_900_;
                        let _e2164 = phi_2397_;
                        let _e2166 = phi_2398_;
                        let _e2168 = phi_2399_;
                        local_7 = _e2168;
                        local_11 = _e2164;
                        continue;
                        continuing {
                            phi_896_ = _e2160;
                            phi_899_ = _e2162;
                            break if !(_e2166);
                        }
                    }
                    let _e2171 = local_7;
                    if _e2171 {
                        phi_2403_ = false;
                    } else {
                        phi_2403_ = true;
                    }
                    let _e2173 = phi_2403_;
                    if _e2173 {
                        let _e2410 = local_11;
                        phi_2407_ = _e2410;
                    } else {
                        let _e2412 = local_12;
                        phi_2407_ = _e2412;
                    }
                    let _e2175 = phi_2407_;
                    phi_2408_ = _e2175;
                }
                let _e2177 = phi_2408_;
                phi_2409_ = _e2177;
                phi_2410_ = _e376;
            } else {
                phi_2409_ = vec3<f32>();
                phi_2410_ = true;
            }
            let _e2179 = phi_2409_;
            let _e2181 = phi_2410_;
            if _e2181 {
                phi_2414_ = vec3<f32>(1f, 1f, 1f);
            } else {
                phi_2414_ = _e2179;
            }
            let _e2183 = phi_2414_;
            phi_2415_ = _e2183;
        } else {
            phi_2415_ = vec3<f32>(1f, 1f, 1f);
        }
        let _e2185 = phi_2415_;
        if (_e110.shift < arrayLength((&tints.member))) {
        } else {
            return;
        }
        tints.member[(0u + _e110.shift)] = vec4<f32>(_e2185.x, _e2185.y, _e2185.z, 1f);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_tint_tint_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
