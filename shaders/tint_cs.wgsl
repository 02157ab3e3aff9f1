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

struct type_32 {
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

struct type_39 {
    member: abi_ShadowParams,
}

struct lt_bvh_Node {
    frame: vec4<u32>,
    links: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    z: vec4<u32>,
}

struct type_44 {
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

struct type_48 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_52 {
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

struct type_56 {
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
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_39;
@group(0) @binding(2) 
var<storage> nodes: type_44;
@group(0) @binding(3) 
var<storage> triangles: type_48;
@group(0) @binding(4) 
var<storage> visibility: type_17;
@group(0) @binding(5) 
var<storage, read_write> tints: type_32;
@group(0) @binding(6) 
var<storage> vertices: type_52;
@group(0) @binding(7) 
var<storage> materials: type_56;
@group(0) @binding(8) 
var<storage> alpha_texels: type_13;
@group(0) @binding(9) 
var<storage> color_texels: type_13;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_218_: lt_bvh_traverse_Tree;
    var phi_219_: bool;
    var phi_220_: lt_bvh_traverse_Tree;
    var phi_221_: bool;
    var phi_226_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_218_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_219_ = false;
        } else {
            phi_218_ = lt_bvh_traverse_Tree();
            phi_219_ = true;
        }
        let _e86 = phi_218_;
        let _e88 = phi_219_;
        phi_220_ = _e86;
        phi_221_ = _e88;
    } else {
        phi_220_ = lt_bvh_traverse_Tree();
        phi_221_ = true;
    }
    let _e90 = phi_220_;
    let _e92 = phi_221_;
    if _e92 {
        phi_226_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_226_ = _e90;
    }
    let _e97 = phi_226_;
    return lt_bvh_traverse_Tree(_e97.root, _e97.first_primitive);
}

fn _lt_shaders_texture_TextureView_quad(param_3: ptr<function, texture_TextureView>, param_4: f32, param_5: f32) -> texture_TexelQuad {
    var phi_2445_: f32;
    var phi_2450_: f32;
    var phi_2451_: bool;
    var phi_2452_: f32;
    var phi_2453_: bool;
    var phi_2457_: f32;
    var phi_2483_: f32;
    var phi_2488_: f32;
    var phi_2489_: bool;
    var phi_2490_: f32;
    var phi_2491_: bool;
    var phi_2495_: f32;
    var phi_2503_: f32;
    var phi_2504_: f32;
    var phi_2505_: f32;
    var phi_2514_: f32;
    var phi_2515_: f32;
    var phi_2533_: u32;
    var phi_2547_: u32;
    var phi_2554_: u32;
    var phi_2559_: u32;
    var phi_2565_: u32;
    var phi_2570_: u32;
    var phi_2572_: texture_Axis;
    var phi_2600_: f32;
    var phi_2605_: f32;
    var phi_2606_: bool;
    var phi_2607_: f32;
    var phi_2608_: bool;
    var phi_2612_: f32;
    var phi_2638_: f32;
    var phi_2643_: f32;
    var phi_2644_: bool;
    var phi_2645_: f32;
    var phi_2646_: bool;
    var phi_2650_: f32;
    var phi_2658_: f32;
    var phi_2659_: f32;
    var phi_2660_: f32;
    var phi_2669_: f32;
    var phi_2670_: f32;
    var phi_2688_: u32;
    var phi_2702_: u32;
    var phi_2709_: u32;
    var phi_2714_: u32;
    var phi_2720_: u32;
    var phi_2725_: u32;
    var phi_2727_: texture_Axis;

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
                phi_2445_ = 1f;
            } else {
                phi_2445_ = 0f;
            }
            let _e107 = phi_2445_;
            if (param_4 < 8388608f) {
                phi_2450_ = (_e104 - _e107);
                phi_2451_ = false;
            } else {
                phi_2450_ = f32();
                phi_2451_ = true;
            }
            let _e110 = phi_2450_;
            let _e112 = phi_2451_;
            phi_2452_ = _e110;
            phi_2453_ = _e112;
        } else {
            phi_2452_ = f32();
            phi_2453_ = true;
        }
        let _e114 = phi_2452_;
        let _e116 = phi_2453_;
        if _e116 {
            phi_2457_ = param_4;
        } else {
            phi_2457_ = _e114;
        }
        let _e118 = phi_2457_;
        phi_2505_ = (param_4 - _e118);
    } else {
        if (_e91 == 1u) {
            let _e121 = (param_4 * 0.5f);
            if (_e121 > -8388608f) {
                let _e133 = f32(select(0i, select(select(i32(_e121), i32(-2147483648), (_e121 < bitcast<f32>(3472883712u))), 2147483647i, (_e121 > bitcast<f32>(1325400063u))), (_e121 == _e121)));
                if (_e133 > _e121) {
                    phi_2483_ = 1f;
                } else {
                    phi_2483_ = 0f;
                }
                let _e136 = phi_2483_;
                if (_e121 < 8388608f) {
                    phi_2488_ = (_e133 - _e136);
                    phi_2489_ = false;
                } else {
                    phi_2488_ = f32();
                    phi_2489_ = true;
                }
                let _e139 = phi_2488_;
                let _e141 = phi_2489_;
                phi_2490_ = _e139;
                phi_2491_ = _e141;
            } else {
                phi_2490_ = f32();
                phi_2491_ = true;
            }
            let _e143 = phi_2490_;
            let _e145 = phi_2491_;
            if _e145 {
                phi_2495_ = _e121;
            } else {
                phi_2495_ = _e143;
            }
            let _e147 = phi_2495_;
            let _e149 = (param_4 - (2f * _e147));
            if (_e149 > 1f) {
                phi_2503_ = (2f - _e149);
            } else {
                phi_2503_ = _e149;
            }
            let _e153 = phi_2503_;
            phi_2504_ = _e153;
        } else {
            phi_2504_ = param_4;
        }
        let _e155 = phi_2504_;
        phi_2505_ = _e155;
    }
    let _e157 = phi_2505_;
    if (_e157 > 0f) {
        if (_e157 < 1f) {
            phi_2514_ = _e157;
        } else {
            phi_2514_ = 1f;
        }
        let _e161 = phi_2514_;
        phi_2515_ = _e161;
    } else {
        phi_2515_ = 0f;
    }
    let _e163 = phi_2515_;
    let _e164 = (_e78 - 1u);
    let _e166 = (_e163 * f32(_e78));
    if _e86 {
        let _e173 = select(select(u32(_e166), 0u, (_e166 < bitcast<f32>(0u))), 4294967295u, (_e166 > bitcast<f32>(1333788671u)));
        if (_e164 < _e173) {
            phi_2533_ = _e164;
        } else {
            phi_2533_ = _e173;
        }
        let _e176 = phi_2533_;
        phi_2572_ = texture_Axis(_e176, _e176, 0f);
    } else {
        let _e178 = (_e166 + 0.5f);
        let _e185 = select(select(u32(_e178), 0u, (_e178 < bitcast<f32>(0u))), 4294967295u, (_e178 > bitcast<f32>(1333788671u)));
        if (_e78 < _e185) {
            phi_2547_ = _e78;
        } else {
            phi_2547_ = _e185;
        }
        let _e188 = phi_2547_;
        if (_e91 == 0u) {
            phi_2554_ = _e164;
        } else {
            phi_2554_ = 0u;
        }
        let _e193 = phi_2554_;
        if (_e91 == 0u) {
            phi_2559_ = 0u;
        } else {
            phi_2559_ = _e164;
        }
        let _e196 = phi_2559_;
        if (_e188 == 0u) {
            phi_2565_ = _e193;
        } else {
            phi_2565_ = (_e188 - 1u);
        }
        let _e200 = phi_2565_;
        if (_e188 > _e164) {
            phi_2570_ = _e196;
        } else {
            phi_2570_ = _e188;
        }
        let _e203 = phi_2570_;
        phi_2572_ = texture_Axis(_e200, _e203, (_e178 - f32(_e188)));
    }
    let _e206 = phi_2572_;
    let _e208 = (*param_3).flags;
    let _e211 = ((_e208 >> bitcast<u32>(6u)) & 3u);
    if (_e211 == 0u) {
        if (param_5 > -8388608f) {
            let _e224 = f32(select(0i, select(select(i32(param_5), i32(-2147483648), (param_5 < bitcast<f32>(3472883712u))), 2147483647i, (param_5 > bitcast<f32>(1325400063u))), (param_5 == param_5)));
            if (_e224 > param_5) {
                phi_2600_ = 1f;
            } else {
                phi_2600_ = 0f;
            }
            let _e227 = phi_2600_;
            if (param_5 < 8388608f) {
                phi_2605_ = (_e224 - _e227);
                phi_2606_ = false;
            } else {
                phi_2605_ = f32();
                phi_2606_ = true;
            }
            let _e230 = phi_2605_;
            let _e232 = phi_2606_;
            phi_2607_ = _e230;
            phi_2608_ = _e232;
        } else {
            phi_2607_ = f32();
            phi_2608_ = true;
        }
        let _e234 = phi_2607_;
        let _e236 = phi_2608_;
        if _e236 {
            phi_2612_ = param_5;
        } else {
            phi_2612_ = _e234;
        }
        let _e238 = phi_2612_;
        phi_2660_ = (param_5 - _e238);
    } else {
        if (_e211 == 1u) {
            let _e241 = (param_5 * 0.5f);
            if (_e241 > -8388608f) {
                let _e253 = f32(select(0i, select(select(i32(_e241), i32(-2147483648), (_e241 < bitcast<f32>(3472883712u))), 2147483647i, (_e241 > bitcast<f32>(1325400063u))), (_e241 == _e241)));
                if (_e253 > _e241) {
                    phi_2638_ = 1f;
                } else {
                    phi_2638_ = 0f;
                }
                let _e256 = phi_2638_;
                if (_e241 < 8388608f) {
                    phi_2643_ = (_e253 - _e256);
                    phi_2644_ = false;
                } else {
                    phi_2643_ = f32();
                    phi_2644_ = true;
                }
                let _e259 = phi_2643_;
                let _e261 = phi_2644_;
                phi_2645_ = _e259;
                phi_2646_ = _e261;
            } else {
                phi_2645_ = f32();
                phi_2646_ = true;
            }
            let _e263 = phi_2645_;
            let _e265 = phi_2646_;
            if _e265 {
                phi_2650_ = _e241;
            } else {
                phi_2650_ = _e263;
            }
            let _e267 = phi_2650_;
            let _e269 = (param_5 - (2f * _e267));
            if (_e269 > 1f) {
                phi_2658_ = (2f - _e269);
            } else {
                phi_2658_ = _e269;
            }
            let _e273 = phi_2658_;
            phi_2659_ = _e273;
        } else {
            phi_2659_ = param_5;
        }
        let _e275 = phi_2659_;
        phi_2660_ = _e275;
    }
    let _e277 = phi_2660_;
    if (_e277 > 0f) {
        if (_e277 < 1f) {
            phi_2669_ = _e277;
        } else {
            phi_2669_ = 1f;
        }
        let _e281 = phi_2669_;
        phi_2670_ = _e281;
    } else {
        phi_2670_ = 0f;
    }
    let _e283 = phi_2670_;
    let _e284 = (_e82 - 1u);
    let _e286 = (_e283 * f32(_e82));
    if _e86 {
        let _e293 = select(select(u32(_e286), 0u, (_e286 < bitcast<f32>(0u))), 4294967295u, (_e286 > bitcast<f32>(1333788671u)));
        if (_e284 < _e293) {
            phi_2688_ = _e284;
        } else {
            phi_2688_ = _e293;
        }
        let _e296 = phi_2688_;
        phi_2727_ = texture_Axis(_e296, _e296, 0f);
    } else {
        let _e298 = (_e286 + 0.5f);
        let _e305 = select(select(u32(_e298), 0u, (_e298 < bitcast<f32>(0u))), 4294967295u, (_e298 > bitcast<f32>(1333788671u)));
        if (_e82 < _e305) {
            phi_2702_ = _e82;
        } else {
            phi_2702_ = _e305;
        }
        let _e308 = phi_2702_;
        if (_e211 == 0u) {
            phi_2709_ = _e284;
        } else {
            phi_2709_ = 0u;
        }
        let _e313 = phi_2709_;
        if (_e211 == 0u) {
            phi_2714_ = 0u;
        } else {
            phi_2714_ = _e284;
        }
        let _e316 = phi_2714_;
        if (_e308 == 0u) {
            phi_2720_ = _e313;
        } else {
            phi_2720_ = (_e308 - 1u);
        }
        let _e320 = phi_2720_;
        if (_e308 > _e284) {
            phi_2725_ = _e316;
        } else {
            phi_2725_ = _e308;
        }
        let _e323 = phi_2725_;
        phi_2727_ = texture_Axis(_e320, _e323, (_e298 - f32(_e308)));
    }
    let _e326 = phi_2727_;
    let _e330 = (*param_3).offset;
    let _e337 = (*param_3).offset;
    let _e344 = (*param_3).offset;
    let _e351 = (*param_3).offset;
    return texture_TexelQuad(array<u32, 4>(((_e330 + (_e326.low * _e78)) + _e206.low), ((_e337 + (_e326.low * _e78)) + _e206.high), ((_e344 + (_e326.high * _e78)) + _e206.low), ((_e351 + (_e326.high * _e78)) + _e206.high)), vec4<f32>(((1f - _e206.fraction) * (1f - _e326.fraction)), (_e206.fraction * (1f - _e326.fraction)), ((1f - _e206.fraction) * _e326.fraction), (_e206.fraction * _e326.fraction)));
}

fn core_intrinsics_minimum_number_nsz_f32_(param_6: f32, param_7: f32) -> f32 {
    var phi_2399_: bool;
    var phi_2403_: f32;

    if (param_6 != param_6) {
        phi_2399_ = true;
    } else {
        let _e76 = (param_7 <= param_6);
        if _e76 {
        }
        phi_2399_ = _e76;
    }
    let _e78 = phi_2399_;
    if _e78 {
        phi_2403_ = param_7;
    } else {
        phi_2403_ = param_6;
    }
    let _e80 = phi_2403_;
    return _e80;
}

fn core_intrinsics_maximum_number_nsz_f32_(param_8: f32, param_9: f32) -> f32 {
    var phi_2383_: bool;
    var phi_2387_: f32;

    if (param_8 != param_8) {
        phi_2383_ = true;
    } else {
        let _e76 = (param_9 >= param_8);
        if _e76 {
        }
        phi_2383_ = _e76;
    }
    let _e78 = phi_2383_;
    if _e78 {
        phi_2387_ = param_9;
    } else {
        phi_2387_ = param_8;
    }
    let _e80 = phi_2387_;
    return _e80;
}

fn function_() {
    var local: texture_TextureView;
    var local_1: texture_TextureView;
    var local_2: lt_bvh_traverse_Stack;
    var phi_318_: bool;
    var phi_319_: bool;
    var phi_320_: bool;
    var phi_321_: bool;
    var phi_325_: bool;
    var phi_369_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_373_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_376_: bool;
    var phi_407_: f32;
    var phi_458_: bool;
    var phi_459_: bool;
    var phi_460_: bool;
    var phi_464_: bool;
    var phi_465_: bool;
    var phi_466_: bool;
    var phi_467_: bool;
    var phi_468_: bool;
    var phi_469_: bool;
    var phi_470_: bool;
    var phi_471_: bool;
    var phi_472_: bool;
    var phi_473_: bool;
    var phi_474_: bool;
    var phi_475_: bool;
    var phi_476_: bool;
    var phi_477_: bool;
    var phi_478_: bool;
    var phi_479_: bool;
    var phi_480_: bool;
    var phi_481_: bool;
    var phi_485_: bool;
    var phi_489_: bool;
    var phi_559_: f32;
    var phi_566_: f32;
    var phi_573_: f32;
    var phi_580_: f32;
    var phi_587_: f32;
    var phi_594_: f32;
    var phi_611_: f32;
    var phi_616_: f32;
    var phi_621_: f32;
    var phi_649_: bool;
    var phi_650_: bool;
    var phi_658_: u32;
    var phi_659_: u32;
    var phi_670_: vec3<f32>;
    var phi_671_: vec3<f32>;
    var phi_684_: u32;
    var phi_689_: u32;
    var phi_694_: u32;
    var phi_808_: bool;
    var phi_809_: bool;
    var phi_840_: u32;
    var phi_842_: u32;
    var phi_845_: vec3<f32>;
    var phi_925_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_952_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_979_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_985_: u32;
    var phi_988_: u32;
    var phi_1002_: u32;
    var phi_1012_: u32;
    var phi_1022_: u32;
    var phi_1040_: u32;
    var phi_1050_: u32;
    var phi_1060_: u32;
    var phi_1096_: u32;
    var phi_1109_: u32;
    var phi_1114_: u32;
    var phi_1115_: u32;
    var phi_1116_: u32;
    var phi_986_: u32;
    var phi_989_: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_1174_: u32;
    var phi_1177_: vec3<f32>;
    var phi_1221_: vec3<f32>;
    var phi_1222_: vec3<f32>;
    var phi_1251_: vec3<f32>;
    var phi_1252_: vec3<f32>;
    var phi_1281_: vec3<f32>;
    var phi_1282_: vec3<f32>;
    var phi_1300_: bool;
    var phi_1301_: bool;
    var phi_1305_: f32;
    var phi_1306_: f32;
    var phi_1307_: f32;
    var phi_1308_: f32;
    var phi_1316_: f32;
    var phi_1326_: bool;
    var phi_1327_: bool;
    var phi_1331_: f32;
    var phi_1332_: f32;
    var phi_1333_: f32;
    var phi_1334_: f32;
    var phi_1342_: f32;
    var phi_1352_: bool;
    var phi_1353_: bool;
    var phi_1357_: f32;
    var phi_1358_: f32;
    var phi_1359_: f32;
    var phi_1360_: f32;
    var phi_1368_: f32;
    var phi_1383_: f32;
    var phi_1384_: bool;
    var phi_1385_: f32;
    var phi_1386_: bool;
    var phi_1387_: f32;
    var phi_1388_: bool;
    var phi_1406_: f32;
    var phi_1407_: bool;
    var phi_1408_: bool;
    var phi_1409_: f32;
    var phi_1410_: bool;
    var phi_1411_: bool;
    var phi_1415_: bool;
    var phi_1416_: f32;
    var phi_1417_: bool;
    var phi_1445_: vec3<f32>;
    var phi_1446_: vec3<f32>;
    var phi_1471_: vec3<f32>;
    var phi_1472_: vec3<f32>;
    var phi_1497_: vec3<f32>;
    var phi_1498_: vec3<f32>;
    var phi_1554_: f32;
    var phi_1563_: f32;
    var phi_1572_: f32;
    var phi_1581_: f32;
    var phi_1588_: f32;
    var phi_1595_: f32;
    var phi_1608_: f32;
    var phi_1617_: f32;
    var phi_1626_: f32;
    var phi_1635_: f32;
    var phi_1642_: f32;
    var phi_1649_: f32;
    var phi_1666_: f32;
    var phi_1671_: f32;
    var phi_1676_: f32;
    var phi_1684_: f32;
    var phi_1689_: f32;
    var phi_1694_: f32;
    var phi_1706_: f32;
    var phi_1711_: f32;
    var phi_1716_: f32;
    var phi_1721_: f32;
    var phi_1726_: lt_bvh_triangle_Intersection;
    var phi_1727_: bool;
    var phi_1728_: lt_bvh_triangle_Intersection;
    var phi_1729_: bool;
    var phi_1733_: lt_bvh_triangle_Intersection;
    var phi_1734_: bool;
    var phi_1735_: lt_bvh_triangle_Intersection;
    var phi_1736_: bool;
    var phi_1737_: bool;
    var phi_1741_: bool;
    var phi_1745_: lt_bvh_triangle_Intersection;
    var phi_1950_: f32;
    var phi_1962_: f32;
    var phi_1971_: f32;
    var phi_1972_: f32;
    var phi_1973_: f32;
    var phi_1974_: f32;
    var phi_2173_: vec3<f32>;
    var phi_2197_: f32;
    var phi_2198_: f32;
    var phi_2207_: f32;
    var phi_2208_: f32;
    var phi_2217_: f32;
    var phi_2218_: f32;
    var phi_2242_: bool;
    var phi_2243_: bool;
    var phi_2244_: bool;
    var phi_2245_: bool;
    var phi_2249_: bool;
    var phi_2253_: bool;
    var phi_2254_: vec3<f32>;
    var phi_2255_: vec3<f32>;
    var phi_2256_: bool;
    var phi_2257_: vec3<f32>;
    var phi_2258_: vec3<f32>;
    var phi_2259_: bool;
    var phi_2260_: vec3<f32>;
    var phi_2261_: vec3<f32>;
    var phi_2262_: bool;
    var phi_1175_: u32;
    var phi_1178_: vec3<f32>;
    var phi_2266_: vec3<f32>;
    var phi_2267_: bool;
    var local_6: bool;
    var phi_2309_: bool;
    var phi_2310_: bool;
    var phi_2341_: u32;
    var phi_2342_: u32;
    var phi_843_: u32;
    var phi_846_: vec3<f32>;
    var phi_2343_: vec3<f32>;
    var phi_2344_: bool;
    var phi_2345_: bool;
    var local_7: bool;
    var phi_2349_: bool;
    var phi_2353_: vec3<f32>;
    var phi_2354_: vec3<f32>;
    var phi_2355_: vec3<f32>;
    var phi_2356_: bool;
    var phi_2360_: vec3<f32>;
    var phi_2361_: vec3<f32>;
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
        let _e119 = p.member.light;
        if (_e110.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        let _e123 = visibility.member[(0u + _e110.first_primitive)];
        if (_e123 > 0f) {
            let _e127 = samples.member[(0u + _e110.first_primitive)].normal[0u];
            let _e129 = global[0u];
            if (_e127 == _e129) {
                let _e132 = samples.member[(0u + _e110.first_primitive)].normal[1u];
                let _e134 = global[1u];
                if (_e132 == _e134) {
                    let _e137 = samples.member[(0u + _e110.first_primitive)].normal[2u];
                    let _e139 = global[2u];
                    phi_318_ = (_e137 == _e139);
                    phi_319_ = false;
                } else {
                    phi_318_ = bool();
                    phi_319_ = true;
                }
                let _e142 = phi_318_;
                let _e144 = phi_319_;
                phi_320_ = _e142;
                phi_321_ = _e144;
            } else {
                phi_320_ = bool();
                phi_321_ = true;
            }
            let _e146 = phi_320_;
            let _e148 = phi_321_;
            if _e148 {
                phi_325_ = false;
            } else {
                phi_325_ = _e146;
            }
            let _e150 = phi_325_;
            if !(_e150) {
                let _e153 = samples.member[(0u + _e110.first_primitive)].normal;
                let _e155 = samples.member[(0u + _e110.first_primitive)].position;
                if ((((_e153.x * (_e119.x - (_e155.x * _e119.w))) + (_e153.y * (_e119.y - (_e155.y * _e119.w)))) + (_e153.z * (_e119.z - (_e155.z * _e119.w)))) > 0f) {
                    let _e179 = samples.member[(0u + _e110.first_primitive)].flags;
                    let _e187 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e193 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e187.unnamed.visibility, false), _e187.unnamed_1);
                    phi_369_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e193.unnamed, ((_e179 & 1u) == 0u));
                } else {
                    let _e202 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e208 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e202.unnamed.visibility, false), _e202.unnamed_1);
                    phi_369_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e208.unnamed, true);
                }
                let _e213 = phi_369_;
                phi_373_ = _e213;
            } else {
                let _e219 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e225 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e219.unnamed.visibility, false), _e219.unnamed_1);
                phi_373_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e225.unnamed, true);
            }
            let _e230 = phi_373_;
            phi_376_ = !(_e230.unnamed_1);
        } else {
            phi_376_ = false;
        }
        let _e234 = phi_376_;
        if _e234 {
            let _e236 = samples.member[(0u + _e110.first_primitive)].position;
            let _e238 = samples.member[(0u + _e110.first_primitive)].normal;
            let _e240 = samples.member[(0u + _e110.first_primitive)].magnitude;
            let _e242 = ((8f / 8388608f) * _e240);
            let _e250 = (_e236.x + (_e238.x * _e242));
            let _e252 = (_e236.y + (_e238.y * _e242));
            let _e254 = (_e236.z + (_e238.z * _e242));
            if (_e119.w == 0f) {
                phi_407_ = 300000000000000000000000000000000000000f;
            } else {
                phi_407_ = 1f;
            }
            let _e258 = phi_407_;
            let _e266 = (_e119.x - (_e250 * _e119.w));
            let _e267 = (_e119.y - (_e252 * _e119.w));
            let _e268 = (_e119.z - (_e254 * _e119.w));
            let _e273 = abs(_e266);
            let _e274 = abs(_e267);
            let _e275 = abs(_e268);
            if (abs(_e250) < 1000000000000000f) {
                if (abs(_e252) < 1000000000000000f) {
                    if (abs(_e254) < 1000000000000000f) {
                        if (_e273 < 1000000000000000f) {
                            if (_e274 < 1000000000000000f) {
                                if (_e275 < 1000000000000000f) {
                                    if (_e273 > 0f) {
                                        phi_459_ = bool();
                                        phi_460_ = true;
                                    } else {
                                        let _e283 = (_e274 > 0f);
                                        if _e283 {
                                            phi_458_ = bool();
                                        } else {
                                            phi_458_ = (_e275 > 0f);
                                        }
                                        let _e286 = phi_458_;
                                        phi_459_ = _e286;
                                        phi_460_ = _e283;
                                    }
                                    let _e288 = phi_459_;
                                    let _e290 = phi_460_;
                                    if _e290 {
                                        phi_464_ = true;
                                    } else {
                                        phi_464_ = _e288;
                                    }
                                    let _e292 = phi_464_;
                                    phi_465_ = _e292;
                                    phi_466_ = false;
                                } else {
                                    phi_465_ = bool();
                                    phi_466_ = true;
                                }
                                let _e294 = phi_465_;
                                let _e296 = phi_466_;
                                phi_467_ = _e294;
                                phi_468_ = false;
                                phi_469_ = _e296;
                            } else {
                                phi_467_ = bool();
                                phi_468_ = true;
                                phi_469_ = false;
                            }
                            let _e298 = phi_467_;
                            let _e300 = phi_468_;
                            let _e302 = phi_469_;
                            phi_470_ = _e298;
                            phi_471_ = _e300;
                            phi_472_ = _e302;
                        } else {
                            phi_470_ = bool();
                            phi_471_ = true;
                            phi_472_ = false;
                        }
                        let _e304 = phi_470_;
                        let _e306 = phi_471_;
                        let _e308 = phi_472_;
                        phi_473_ = _e304;
                        phi_474_ = _e306;
                        phi_475_ = _e308;
                    } else {
                        phi_473_ = bool();
                        phi_474_ = true;
                        phi_475_ = false;
                    }
                    let _e310 = phi_473_;
                    let _e312 = phi_474_;
                    let _e314 = phi_475_;
                    phi_476_ = _e310;
                    phi_477_ = _e312;
                    phi_478_ = _e314;
                } else {
                    phi_476_ = bool();
                    phi_477_ = true;
                    phi_478_ = false;
                }
                let _e316 = phi_476_;
                let _e318 = phi_477_;
                let _e320 = phi_478_;
                phi_479_ = _e316;
                phi_480_ = _e318;
                phi_481_ = _e320;
            } else {
                phi_479_ = bool();
                phi_480_ = true;
                phi_481_ = false;
            }
            let _e322 = phi_479_;
            let _e324 = phi_480_;
            let _e326 = phi_481_;
            if _e324 {
                phi_485_ = true;
            } else {
                phi_485_ = _e326;
            }
            let _e328 = phi_485_;
            if _e328 {
                phi_489_ = false;
            } else {
                phi_489_ = _e322;
            }
            let _e330 = phi_489_;
            if _e330 {
                let _e331 = (0u >= _e83);
                if _e331 {
                    phi_2354_ = vec3<f32>();
                } else {
                    if (0u < _e83) {
                    } else {
                        return;
                    }
                    let _e337 = nodes.member[(0u + 0u)].frame[0u];
                    let _e341 = nodes.member[(0u + 0u)].frame[1u];
                    let _e345 = nodes.member[(0u + 0u)].frame[2u];
                    let _e349 = nodes.member[(0u + 0u)].frame[0u];
                    let _e353 = nodes.member[(0u + 0u)].frame[1u];
                    let _e357 = nodes.member[(0u + 0u)].frame[2u];
                    let _e361 = nodes.member[(0u + 0u)].frame[3u];
                    let _e395 = core_intrinsics_maximum_number_nsz_f32_(abs(_e266), abs(_e267));
                    let _e396 = core_intrinsics_maximum_number_nsz_f32_(_e395, abs(_e268));
                    let _e397 = (_e396 * 0.0000000000009094947f);
                    if (abs(_e266) < _e397) {
                        phi_559_ = _e397;
                    } else {
                        phi_559_ = abs(_e266);
                    }
                    let _e402 = phi_559_;
                    if (_e266 < 0f) {
                        phi_566_ = (-1f / _e402);
                    } else {
                        phi_566_ = (1f / _e402);
                    }
                    let _e407 = phi_566_;
                    if (abs(_e267) < _e397) {
                        phi_573_ = _e397;
                    } else {
                        phi_573_ = abs(_e267);
                    }
                    let _e412 = phi_573_;
                    if (_e267 < 0f) {
                        phi_580_ = (-1f / _e412);
                    } else {
                        phi_580_ = (1f / _e412);
                    }
                    let _e417 = phi_580_;
                    if (abs(_e268) < _e397) {
                        phi_587_ = _e397;
                    } else {
                        phi_587_ = abs(_e268);
                    }
                    let _e422 = phi_587_;
                    if (_e268 < 0f) {
                        phi_594_ = (-1f / _e422);
                    } else {
                        phi_594_ = (1f / _e422);
                    }
                    let _e427 = phi_594_;
                    let _e431 = abs((bitcast<f32>(_e337) - _e250));
                    let _e432 = abs((bitcast<f32>(_e341) - _e252));
                    let _e433 = abs((bitcast<f32>(_e345) - _e254));
                    let _e437 = abs(((bitcast<f32>(_e349) + (bitcast<f32>((((_e361 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e250));
                    let _e438 = abs(((bitcast<f32>(_e353) + (bitcast<f32>((((_e361 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e252));
                    let _e439 = abs(((bitcast<f32>(_e357) + (bitcast<f32>((((_e361 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e254));
                    if (_e431 > _e437) {
                        phi_611_ = _e431;
                    } else {
                        phi_611_ = _e437;
                    }
                    let _e442 = phi_611_;
                    if (_e432 > _e438) {
                        phi_616_ = _e432;
                    } else {
                        phi_616_ = _e438;
                    }
                    let _e445 = phi_616_;
                    if (_e433 > _e439) {
                        phi_621_ = _e433;
                    } else {
                        phi_621_ = _e439;
                    }
                    let _e448 = phi_621_;
                    let _e449 = core_intrinsics_maximum_number_nsz_f32_(_e442, _e445);
                    let _e450 = core_intrinsics_maximum_number_nsz_f32_(_e449, _e448);
                    let _e454 = (_e450 * 0.0000019073486f);
                    let _e455 = (abs(_e407) * _e454);
                    let _e456 = (abs(_e417) * _e454);
                    let _e457 = (abs(_e427) * _e454);
                    let _e461 = (_e450 * 0.0000009536743f);
                    let _e462 = (abs(_e407) * _e461);
                    let _e463 = (abs(_e417) * _e461);
                    let _e464 = (abs(_e427) * _e461);
                    let _e465 = abs(_e266);
                    let _e466 = abs(_e267);
                    let _e467 = abs(_e268);
                    if (_e465 >= _e466) {
                        if (_e465 >= _e467) {
                            phi_649_ = false;
                        } else {
                            phi_649_ = true;
                        }
                        let _e471 = phi_649_;
                        phi_650_ = _e471;
                    } else {
                        phi_650_ = true;
                    }
                    let _e473 = phi_650_;
                    if _e473 {
                        if (_e466 >= _e467) {
                            phi_658_ = 1u;
                        } else {
                            phi_658_ = 2u;
                        }
                        let _e476 = phi_658_;
                        phi_659_ = _e476;
                    } else {
                        phi_659_ = 0u;
                    }
                    let _e478 = phi_659_;
                    if (_e478 == 0u) {
                        phi_671_ = vec3<f32>(_e267, _e268, _e266);
                    } else {
                        if (_e478 == 1u) {
                            phi_670_ = vec3<f32>(_e268, _e266, _e267);
                        } else {
                            phi_670_ = vec3<f32>(_e266, _e267, _e268);
                        }
                        let _e484 = phi_670_;
                        phi_671_ = _e484;
                    }
                    let _e486 = phi_671_;
                    let _e489 = (_e486.x / _e486.z);
                    let _e492 = (_e486.y / _e486.z);
                    if (_e407 < 0f) {
                        phi_684_ = 0u;
                    } else {
                        phi_684_ = 1u;
                    }
                    let _e497 = phi_684_;
                    if (_e417 < 0f) {
                        phi_689_ = 0u;
                    } else {
                        phi_689_ = 2u;
                    }
                    let _e500 = phi_689_;
                    if (_e427 < 0f) {
                        phi_694_ = 0u;
                    } else {
                        phi_694_ = 4u;
                    }
                    let _e503 = phi_694_;
                    let _e505 = ((_e497 | _e500) | _e503);
                    let _e506 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                    local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e506.first[0], _e506.first[1], _e506.first[2], _e506.first[3], _e506.first[4], _e506.first[5], _e506.first[6], _e506.first[7], _e506.first[8], _e506.first[9], _e506.first[10], _e506.first[11], _e506.first[12], _e506.first[13], _e506.first[14], _e506.first[15], _e506.first[16], _e506.first[17], _e506.first[18], _e506.first[19], _e506.first[20], _e506.first[21], _e506.first[22], _e506.first[23], _e506.first[24], _e506.first[25], _e506.first[26], _e506.first[27], _e506.first[28], _e506.first[29], _e506.first[30], _e506.first[31]), array<u32, 32>(_e506.mask[0], _e506.mask[1], _e506.mask[2], _e506.mask[3], _e506.mask[4], _e506.mask[5], _e506.mask[6], _e506.mask[7], _e506.mask[8], _e506.mask[9], _e506.mask[10], _e506.mask[11], _e506.mask[12], _e506.mask[13], _e506.mask[14], _e506.mask[15], _e506.mask[16], _e506.mask[17], _e506.mask[18], _e506.mask[19], _e506.mask[20], _e506.mask[21], _e506.mask[22], _e506.mask[23], _e506.mask[24], _e506.mask[25], _e506.mask[26], _e506.mask[27], _e506.mask[28], _e506.mask[29], _e506.mask[30], _e506.mask[31]), _e506.len, _e506.group, _e506.group_mask);
                    let _e580 = local_2.group_mask;
                    if ((_e580 & 4278190080u) == 0u) {
                        let _e584 = local_2.len;
                        if (_e584 == 0u) {
                            phi_808_ = false;
                        } else {
                            let _e588 = local_2.len;
                            local_2.len = (_e588 - 1u);
                            let _e591 = local_2.len;
                            if (_e591 < 32u) {
                            } else {
                                return;
                            }
                            let _e596 = local_2.first[(0u + _e591)];
                            local_2.group = _e596;
                            let _e599 = local_2.len;
                            if (_e599 < 32u) {
                            } else {
                                return;
                            }
                            let _e604 = local_2.mask[(0u + _e599)];
                            local_2.group_mask = _e604;
                            phi_808_ = true;
                        }
                        let _e607 = phi_808_;
                        phi_809_ = _e607;
                    } else {
                        phi_809_ = true;
                    }
                    let _e609 = phi_809_;
                    if _e609 {
                        let _e611 = local_2.group_mask;
                        let _e617 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e611)), 32u, (_e611 == 0u)));
                        let _e621 = local_2.group_mask;
                        let _e635 = local_2.group_mask;
                        local_2.group_mask = (_e635 & ~((1u << bitcast<u32>((_e617 & 31u)))));
                        let _e638 = local_2.group;
                        phi_840_ = (_e638 + countOneBits(((_e621 & ~((4294967295u << bitcast<u32>((((_e617 - 24u) ^ 7u) & 31u))))) & 255u)));
                    } else {
                        phi_840_ = 4294967295u;
                    }
                    let _e641 = phi_840_;
                    phi_842_ = _e641;
                    phi_845_ = vec3<f32>(1f, 1f, 1f);
                    loop {
                        let _e643 = phi_842_;
                        let _e645 = phi_845_;
                        local_12 = _e645;
                        if (_e643 != 4294967295u) {
                            if (_e643 < _e83) {
                            } else {
                                return;
                            }
                            let _e652 = nodes.member[(0u + _e643)].frame[3u];
                            let _e677 = (bitcast<f32>((((_e652 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e407);
                            let _e678 = (bitcast<f32>((((_e652 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e417);
                            let _e679 = (bitcast<f32>((((_e652 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e427);
                            let _e682 = nodes.member[(0u + _e643)].frame[0u];
                            let _e686 = nodes.member[(0u + _e643)].frame[1u];
                            let _e690 = nodes.member[(0u + _e643)].frame[2u];
                            let _e695 = ((bitcast<f32>(_e682) - _e250) * _e407);
                            let _e696 = ((bitcast<f32>(_e686) - _e252) * _e417);
                            let _e697 = ((bitcast<f32>(_e690) - _e254) * _e427);
                            let _e705 = nodes.member[(0u + _e643)].x;
                            if (_e407 < 0f) {
                                let _e716 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e705.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e722 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e716.unnamed.root, _e705.w), _e716.unnamed_1);
                                let _e728 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e722.unnamed, lt_bvh_traverse_Tree(_e705.x, _e722.unnamed_1.first_primitive));
                                phi_925_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e728.unnamed, lt_bvh_traverse_Tree(_e728.unnamed_1.root, _e705.y));
                            } else {
                                let _e744 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e705.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e750 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e744.unnamed.root, _e705.y), _e744.unnamed_1);
                                let _e756 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e750.unnamed, lt_bvh_traverse_Tree(_e705.z, _e750.unnamed_1.first_primitive));
                                phi_925_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e756.unnamed, lt_bvh_traverse_Tree(_e756.unnamed_1.root, _e705.w));
                            }
                            let _e764 = phi_925_;
                            let _e774 = nodes.member[(0u + _e643)].y;
                            if (_e417 < 0f) {
                                let _e785 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e774.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e791 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e785.unnamed.root, _e774.w), _e785.unnamed_1);
                                let _e797 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e791.unnamed, lt_bvh_traverse_Tree(_e774.x, _e791.unnamed_1.first_primitive));
                                phi_952_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e797.unnamed, lt_bvh_traverse_Tree(_e797.unnamed_1.root, _e774.y));
                            } else {
                                let _e813 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e774.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e819 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e813.unnamed.root, _e774.y), _e813.unnamed_1);
                                let _e825 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e819.unnamed, lt_bvh_traverse_Tree(_e774.z, _e819.unnamed_1.first_primitive));
                                phi_952_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e825.unnamed, lt_bvh_traverse_Tree(_e825.unnamed_1.root, _e774.w));
                            }
                            let _e833 = phi_952_;
                            let _e843 = nodes.member[(0u + _e643)].z;
                            if (_e427 < 0f) {
                                let _e854 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e843.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e860 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e854.unnamed.root, _e843.w), _e854.unnamed_1);
                                let _e866 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e860.unnamed, lt_bvh_traverse_Tree(_e843.x, _e860.unnamed_1.first_primitive));
                                phi_979_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e866.unnamed, lt_bvh_traverse_Tree(_e866.unnamed_1.root, _e843.y));
                            } else {
                                let _e882 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e843.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e888 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e882.unnamed.root, _e843.y), _e882.unnamed_1);
                                let _e894 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e888.unnamed, lt_bvh_traverse_Tree(_e843.z, _e888.unnamed_1.first_primitive));
                                phi_979_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e894.unnamed, lt_bvh_traverse_Tree(_e894.unnamed_1.root, _e843.w));
                            }
                            let _e902 = phi_979_;
                            phi_985_ = 0u;
                            phi_988_ = 0u;
                            loop {
                                let _e912 = phi_985_;
                                let _e914 = phi_988_;
                                local_3 = _e914;
                                local_4 = _e914;
                                local_5 = _e914;
                                let _e915 = (_e912 < 8u);
                                if _e915 {
                                    let _e917 = (_e912 >> bitcast<u32>(2i));
                                    let _e918 = (_e912 & 3u);
                                    if (_e917 == 0u) {
                                        phi_1002_ = _e764.unnamed.root;
                                    } else {
                                        phi_1002_ = _e764.unnamed.first_primitive;
                                    }
                                    let _e921 = phi_1002_;
                                    if (_e917 == 0u) {
                                        phi_1012_ = _e833.unnamed.root;
                                    } else {
                                        phi_1012_ = _e833.unnamed.first_primitive;
                                    }
                                    let _e930 = phi_1012_;
                                    if (_e917 == 0u) {
                                        phi_1022_ = _e902.unnamed.root;
                                    } else {
                                        phi_1022_ = _e902.unnamed.first_primitive;
                                    }
                                    let _e939 = phi_1022_;
                                    let _e952 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e921 >> bitcast<u32>(((_e918 * 8u) & 31u))) & 255u)) * _e677) + (_e695 - _e455)), ((f32(((_e930 >> bitcast<u32>(((_e918 * 8u) & 31u))) & 255u)) * _e678) + (_e696 - _e456)));
                                    let _e953 = core_intrinsics_maximum_number_nsz_f32_(_e952, ((f32(((_e939 >> bitcast<u32>(((_e918 * 8u) & 31u))) & 255u)) * _e679) + (_e697 - _e457)));
                                    if (_e917 == 0u) {
                                        phi_1040_ = _e764.unnamed_1.root;
                                    } else {
                                        phi_1040_ = _e764.unnamed_1.first_primitive;
                                    }
                                    let _e956 = phi_1040_;
                                    if (_e917 == 0u) {
                                        phi_1050_ = _e833.unnamed_1.root;
                                    } else {
                                        phi_1050_ = _e833.unnamed_1.first_primitive;
                                    }
                                    let _e965 = phi_1050_;
                                    if (_e917 == 0u) {
                                        phi_1060_ = _e902.unnamed_1.root;
                                    } else {
                                        phi_1060_ = _e902.unnamed_1.first_primitive;
                                    }
                                    let _e974 = phi_1060_;
                                    let _e987 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e956 >> bitcast<u32>(((_e918 * 8u) & 31u))) & 255u)) * _e677) + (_e695 + _e455)), ((f32(((_e965 >> bitcast<u32>(((_e918 * 8u) & 31u))) & 255u)) * _e678) + (_e696 + _e456)));
                                    let _e988 = core_intrinsics_minimum_number_nsz_f32_(_e987, ((f32(((_e974 >> bitcast<u32>(((_e918 * 8u) & 31u))) & 255u)) * _e679) + (_e697 + _e457)));
                                    if (_e953 <= _e988) {
                                        if (_e953 <= _e258) {
                                            if (_e988 >= 0f) {
                                                if (_e917 == 0u) {
                                                    let _e995 = nodes.member[(0u + _e643)].links[2u];
                                                    phi_1096_ = _e995;
                                                } else {
                                                    let _e998 = nodes.member[(0u + _e643)].links[3u];
                                                    phi_1096_ = _e998;
                                                }
                                                let _e1000 = phi_1096_;
                                                let _e1005 = ((_e1000 >> bitcast<u32>(((_e918 * 8u) & 31u))) & 255u);
                                                let _e1006 = (_e1005 & 31u);
                                                if (_e1006 >= 24u) {
                                                    phi_1109_ = (24u + ((_e1006 - 24u) ^ _e505));
                                                } else {
                                                    phi_1109_ = _e1006;
                                                }
                                                let _e1012 = phi_1109_;
                                                phi_1114_ = (_e914 | ((_e1005 >> bitcast<u32>(5i)) << bitcast<u32>((_e1012 & 31u))));
                                            } else {
                                                phi_1114_ = _e914;
                                            }
                                            let _e1020 = phi_1114_;
                                            phi_1115_ = _e1020;
                                        } else {
                                            phi_1115_ = _e914;
                                        }
                                        let _e1022 = phi_1115_;
                                        phi_1116_ = _e1022;
                                    } else {
                                        phi_1116_ = _e914;
                                    }
                                    let _e1024 = phi_1116_;
                                    phi_986_ = (_e912 + 1u);
                                    phi_989_ = _e1024;
                                } else {
                                    phi_986_ = u32();
                                    phi_989_ = u32();
                                }
                                let _e1027 = phi_986_;
                                let _e1029 = phi_989_;
                                continue;
                                continuing {
                                    phi_985_ = _e1027;
                                    phi_988_ = _e1029;
                                    break if !(_e915);
                                }
                            }
                            let _e1033 = nodes.member[(0u + _e643)].links[0u];
                            let _e1037 = nodes.member[(0u + _e643)].frame[3u];
                            let _e1041 = local_3;
                            if ((_e1041 & 4278190080u) == 0u) {
                            } else {
                                let _e1045 = local_2.group_mask;
                                if ((_e1045 & 4278190080u) == 0u) {
                                } else {
                                    let _e1049 = local_2.len;
                                    if (_e1049 < 32u) {
                                        let _e1052 = local_2.group;
                                        let _e1054 = local_2.len;
                                        if (_e1054 < 32u) {
                                        } else {
                                            return;
                                        }
                                        local_2.first[(0u + _e1054)] = _e1052;
                                        let _e1060 = local_2.group_mask;
                                        let _e1062 = local_2.len;
                                        if (_e1062 < 32u) {
                                        } else {
                                            return;
                                        }
                                        local_2.mask[(0u + _e1062)] = _e1060;
                                        let _e1069 = local_2.len;
                                        local_2.len = (_e1069 + 1u);
                                    }
                                }
                                local_2.group = (0u + _e1033);
                                let _e1073 = local_4;
                                local_2.group_mask = ((_e1073 & 4278190080u) | (_e1037 >> bitcast<u32>(24i)));
                            }
                            let _e1078 = local_5;
                            phi_1174_ = (_e1078 & 16777215u);
                            phi_1177_ = _e645;
                            loop {
                                let _e1081 = phi_1174_;
                                let _e1083 = phi_1177_;
                                local_8 = _e1083;
                                let _e1084 = (_e1081 == 0u);
                                local_6 = _e1084;
                                local_10 = _e1084;
                                if _e1084 {
                                    phi_1175_ = u32();
                                    phi_1178_ = vec3<f32>();
                                    phi_2266_ = vec3<f32>();
                                    phi_2267_ = false;
                                } else {
                                    let _e1087 = nodes.member[(0u + _e643)].links[1u];
                                    let _e1092 = ((0u + _e1087) + select(firstTrailingBit(_e1081), 32u, (_e1081 == 0u)));
                                    if (_e1092 < _e86) {
                                    } else {
                                        return;
                                    }
                                    let _e1099 = triangles.member[(0u + _e1092)].v0_;
                                    let _e1101 = (_e1099.x - _e250);
                                    let _e1103 = (_e1099.y - _e252);
                                    let _e1105 = (_e1099.z - _e254);
                                    if (_e478 == 0u) {
                                        phi_1222_ = vec3<f32>(_e1103, _e1105, _e1101);
                                    } else {
                                        if (_e478 == 1u) {
                                            phi_1221_ = vec3<f32>(_e1105, _e1101, _e1103);
                                        } else {
                                            phi_1221_ = (_e1099 - vec3<f32>(_e250, _e252, _e254));
                                        }
                                        let _e1113 = phi_1221_;
                                        phi_1222_ = _e1113;
                                    }
                                    let _e1115 = phi_1222_;
                                    let _e1119 = (_e1115.x - (_e489 * _e1115.z));
                                    let _e1123 = (_e1115.y - (_e492 * _e1115.z));
                                    let _e1125 = triangles.member[(0u + _e1092)].v1_;
                                    let _e1127 = (_e1125.x - _e250);
                                    let _e1129 = (_e1125.y - _e252);
                                    let _e1131 = (_e1125.z - _e254);
                                    if (_e478 == 0u) {
                                        phi_1252_ = vec3<f32>(_e1129, _e1131, _e1127);
                                    } else {
                                        if (_e478 == 1u) {
                                            phi_1251_ = vec3<f32>(_e1131, _e1127, _e1129);
                                        } else {
                                            phi_1251_ = (_e1125 - vec3<f32>(_e250, _e252, _e254));
                                        }
                                        let _e1139 = phi_1251_;
                                        phi_1252_ = _e1139;
                                    }
                                    let _e1141 = phi_1252_;
                                    let _e1145 = (_e1141.x - (_e489 * _e1141.z));
                                    let _e1149 = (_e1141.y - (_e492 * _e1141.z));
                                    let _e1151 = triangles.member[(0u + _e1092)].v2_;
                                    let _e1153 = (_e1151.x - _e250);
                                    let _e1155 = (_e1151.y - _e252);
                                    let _e1157 = (_e1151.z - _e254);
                                    if (_e478 == 0u) {
                                        phi_1282_ = vec3<f32>(_e1155, _e1157, _e1153);
                                    } else {
                                        if (_e478 == 1u) {
                                            phi_1281_ = vec3<f32>(_e1157, _e1153, _e1155);
                                        } else {
                                            phi_1281_ = (_e1151 - vec3<f32>(_e250, _e252, _e254));
                                        }
                                        let _e1165 = phi_1281_;
                                        phi_1282_ = _e1165;
                                    }
                                    let _e1167 = phi_1282_;
                                    let _e1171 = (_e1167.x - (_e489 * _e1167.z));
                                    let _e1175 = (_e1167.y - (_e492 * _e1167.z));
                                    if (_e1145 < _e1171) {
                                        phi_1301_ = true;
                                    } else {
                                        if (_e1145 == _e1171) {
                                            phi_1300_ = (_e1149 < _e1175);
                                        } else {
                                            phi_1300_ = false;
                                        }
                                        let _e1180 = phi_1300_;
                                        phi_1301_ = _e1180;
                                    }
                                    let _e1182 = phi_1301_;
                                    if _e1182 {
                                        phi_1305_ = _e1175;
                                        phi_1306_ = _e1171;
                                        phi_1307_ = _e1149;
                                        phi_1308_ = _e1145;
                                    } else {
                                        phi_1305_ = _e1149;
                                        phi_1306_ = _e1145;
                                        phi_1307_ = _e1175;
                                        phi_1308_ = _e1171;
                                    }
                                    let _e1184 = phi_1305_;
                                    let _e1186 = phi_1306_;
                                    let _e1188 = phi_1307_;
                                    let _e1190 = phi_1308_;
                                    let _e1193 = ((_e1190 * _e1184) - (_e1188 * _e1186));
                                    if _e1182 {
                                        phi_1316_ = -(_e1193);
                                    } else {
                                        phi_1316_ = _e1193;
                                    }
                                    let _e1196 = phi_1316_;
                                    if (_e1171 < _e1119) {
                                        phi_1327_ = true;
                                    } else {
                                        if (_e1171 == _e1119) {
                                            phi_1326_ = (_e1175 < _e1123);
                                        } else {
                                            phi_1326_ = false;
                                        }
                                        let _e1201 = phi_1326_;
                                        phi_1327_ = _e1201;
                                    }
                                    let _e1203 = phi_1327_;
                                    if _e1203 {
                                        phi_1331_ = _e1123;
                                        phi_1332_ = _e1119;
                                        phi_1333_ = _e1175;
                                        phi_1334_ = _e1171;
                                    } else {
                                        phi_1331_ = _e1175;
                                        phi_1332_ = _e1171;
                                        phi_1333_ = _e1123;
                                        phi_1334_ = _e1119;
                                    }
                                    let _e1205 = phi_1331_;
                                    let _e1207 = phi_1332_;
                                    let _e1209 = phi_1333_;
                                    let _e1211 = phi_1334_;
                                    let _e1214 = ((_e1211 * _e1205) - (_e1209 * _e1207));
                                    if _e1203 {
                                        phi_1342_ = -(_e1214);
                                    } else {
                                        phi_1342_ = _e1214;
                                    }
                                    let _e1217 = phi_1342_;
                                    if (_e1119 < _e1145) {
                                        phi_1353_ = true;
                                    } else {
                                        if (_e1119 == _e1145) {
                                            phi_1352_ = (_e1123 < _e1149);
                                        } else {
                                            phi_1352_ = false;
                                        }
                                        let _e1222 = phi_1352_;
                                        phi_1353_ = _e1222;
                                    }
                                    let _e1224 = phi_1353_;
                                    if _e1224 {
                                        phi_1357_ = _e1149;
                                        phi_1358_ = _e1145;
                                        phi_1359_ = _e1123;
                                        phi_1360_ = _e1119;
                                    } else {
                                        phi_1357_ = _e1123;
                                        phi_1358_ = _e1119;
                                        phi_1359_ = _e1149;
                                        phi_1360_ = _e1145;
                                    }
                                    let _e1226 = phi_1357_;
                                    let _e1228 = phi_1358_;
                                    let _e1230 = phi_1359_;
                                    let _e1232 = phi_1360_;
                                    let _e1235 = ((_e1232 * _e1226) - (_e1230 * _e1228));
                                    if _e1224 {
                                        phi_1368_ = -(_e1235);
                                    } else {
                                        phi_1368_ = _e1235;
                                    }
                                    let _e1238 = phi_1368_;
                                    if (_e1196 >= 0f) {
                                        if (_e1217 >= 0f) {
                                            if (_e1238 >= 0f) {
                                                phi_1383_ = ((_e1196 + _e1217) + _e1238);
                                                phi_1384_ = false;
                                            } else {
                                                phi_1383_ = f32();
                                                phi_1384_ = true;
                                            }
                                            let _e1245 = phi_1383_;
                                            let _e1247 = phi_1384_;
                                            phi_1385_ = _e1245;
                                            phi_1386_ = _e1247;
                                        } else {
                                            phi_1385_ = f32();
                                            phi_1386_ = true;
                                        }
                                        let _e1249 = phi_1385_;
                                        let _e1251 = phi_1386_;
                                        phi_1387_ = _e1249;
                                        phi_1388_ = _e1251;
                                    } else {
                                        phi_1387_ = f32();
                                        phi_1388_ = true;
                                    }
                                    let _e1253 = phi_1387_;
                                    let _e1255 = phi_1388_;
                                    if _e1255 {
                                        if (_e1196 <= 0f) {
                                            if (_e1217 <= 0f) {
                                                let _e1258 = (_e1238 <= 0f);
                                                if _e1258 {
                                                }
                                                phi_1406_ = ((_e1196 + _e1217) + _e1238);
                                                phi_1407_ = false;
                                                phi_1408_ = _e1258;
                                            } else {
                                                phi_1406_ = f32();
                                                phi_1407_ = true;
                                                phi_1408_ = false;
                                            }
                                            let _e1262 = phi_1406_;
                                            let _e1264 = phi_1407_;
                                            let _e1266 = phi_1408_;
                                            phi_1409_ = _e1262;
                                            phi_1410_ = _e1264;
                                            phi_1411_ = _e1266;
                                        } else {
                                            phi_1409_ = f32();
                                            phi_1410_ = true;
                                            phi_1411_ = false;
                                        }
                                        let _e1268 = phi_1409_;
                                        let _e1270 = phi_1410_;
                                        let _e1272 = phi_1411_;
                                        if _e1270 {
                                            phi_1415_ = false;
                                        } else {
                                            phi_1415_ = _e1272;
                                        }
                                        let _e1274 = phi_1415_;
                                        phi_1416_ = _e1268;
                                        phi_1417_ = _e1274;
                                    } else {
                                        phi_1416_ = _e1253;
                                        phi_1417_ = true;
                                    }
                                    let _e1276 = phi_1416_;
                                    let _e1278 = phi_1417_;
                                    if _e1278 {
                                        let _e1279 = (_e1276 == 0f);
                                        if _e1279 {
                                            phi_1733_ = lt_bvh_triangle_Intersection();
                                            phi_1734_ = false;
                                        } else {
                                            let _e1281 = triangles.member[(0u + _e1092)].v0_;
                                            let _e1283 = (_e1281.x - _e250);
                                            let _e1285 = (_e1281.y - _e252);
                                            let _e1287 = (_e1281.z - _e254);
                                            if (_e478 == 0u) {
                                                phi_1446_ = vec3<f32>(_e1285, _e1287, _e1283);
                                            } else {
                                                if (_e478 == 1u) {
                                                    phi_1445_ = vec3<f32>(_e1287, _e1283, _e1285);
                                                } else {
                                                    phi_1445_ = (_e1281 - vec3<f32>(_e250, _e252, _e254));
                                                }
                                                let _e1295 = phi_1445_;
                                                phi_1446_ = _e1295;
                                            }
                                            let _e1297 = phi_1446_;
                                            let _e1299 = triangles.member[(0u + _e1092)].v1_;
                                            let _e1301 = triangles.member[(0u + _e1092)].v0_;
                                            let _e1304 = (_e1299.x - _e1301.x);
                                            let _e1307 = (_e1299.y - _e1301.y);
                                            let _e1310 = (_e1299.z - _e1301.z);
                                            if (_e478 == 0u) {
                                                phi_1472_ = vec3<f32>(_e1307, _e1310, _e1304);
                                            } else {
                                                if (_e478 == 1u) {
                                                    phi_1471_ = vec3<f32>(_e1310, _e1304, _e1307);
                                                } else {
                                                    phi_1471_ = (_e1299 - _e1301);
                                                }
                                                let _e1317 = phi_1471_;
                                                phi_1472_ = _e1317;
                                            }
                                            let _e1319 = phi_1472_;
                                            let _e1321 = triangles.member[(0u + _e1092)].v2_;
                                            let _e1323 = triangles.member[(0u + _e1092)].v0_;
                                            let _e1326 = (_e1321.x - _e1323.x);
                                            let _e1329 = (_e1321.y - _e1323.y);
                                            let _e1332 = (_e1321.z - _e1323.z);
                                            if (_e478 == 0u) {
                                                phi_1498_ = vec3<f32>(_e1329, _e1332, _e1326);
                                            } else {
                                                if (_e478 == 1u) {
                                                    phi_1497_ = vec3<f32>(_e1332, _e1326, _e1329);
                                                } else {
                                                    phi_1497_ = (_e1321 - _e1323);
                                                }
                                                let _e1339 = phi_1497_;
                                                phi_1498_ = _e1339;
                                            }
                                            let _e1341 = phi_1498_;
                                            let _e1348 = ((_e1319.y * _e1341.z) - (_e1319.z * _e1341.y));
                                            let _e1355 = ((_e1319.z * _e1341.x) - (_e1319.x * _e1341.z));
                                            let _e1362 = ((_e1319.x * _e1341.y) - (_e1319.y * _e1341.x));
                                            let _e1376 = (((1f / _e486.z) * (((_e1348 * _e1297.x) + (_e1355 * _e1297.y)) + (_e1362 * _e1297.z))) / (((_e1348 * _e489) + (_e1355 * _e492)) + _e1362));
                                            if (_e1376 > 0f) {
                                                if (_e1376 < _e258) {
                                                    let _e1380 = triangles.member[(0u + _e1092)].v0_;
                                                    let _e1382 = triangles.member[(0u + _e1092)].v1_;
                                                    if (_e1380.x < _e1382.x) {
                                                        phi_1554_ = _e1380.x;
                                                    } else {
                                                        phi_1554_ = _e1382.x;
                                                    }
                                                    let _e1389 = phi_1554_;
                                                    if (_e1380.y < _e1382.y) {
                                                        phi_1563_ = _e1380.y;
                                                    } else {
                                                        phi_1563_ = _e1382.y;
                                                    }
                                                    let _e1396 = phi_1563_;
                                                    if (_e1380.z < _e1382.z) {
                                                        phi_1572_ = _e1380.z;
                                                    } else {
                                                        phi_1572_ = _e1382.z;
                                                    }
                                                    let _e1403 = phi_1572_;
                                                    let _e1405 = triangles.member[(0u + _e1092)].v2_;
                                                    if (_e1389 < _e1405.x) {
                                                        phi_1581_ = _e1389;
                                                    } else {
                                                        phi_1581_ = _e1405.x;
                                                    }
                                                    let _e1410 = phi_1581_;
                                                    if (_e1396 < _e1405.y) {
                                                        phi_1588_ = _e1396;
                                                    } else {
                                                        phi_1588_ = _e1405.y;
                                                    }
                                                    let _e1415 = phi_1588_;
                                                    if (_e1403 < _e1405.z) {
                                                        phi_1595_ = _e1403;
                                                    } else {
                                                        phi_1595_ = _e1405.z;
                                                    }
                                                    let _e1420 = phi_1595_;
                                                    let _e1422 = triangles.member[(0u + _e1092)].v0_;
                                                    let _e1424 = triangles.member[(0u + _e1092)].v1_;
                                                    if (_e1422.x > _e1424.x) {
                                                        phi_1608_ = _e1422.x;
                                                    } else {
                                                        phi_1608_ = _e1424.x;
                                                    }
                                                    let _e1431 = phi_1608_;
                                                    if (_e1422.y > _e1424.y) {
                                                        phi_1617_ = _e1422.y;
                                                    } else {
                                                        phi_1617_ = _e1424.y;
                                                    }
                                                    let _e1438 = phi_1617_;
                                                    if (_e1422.z > _e1424.z) {
                                                        phi_1626_ = _e1422.z;
                                                    } else {
                                                        phi_1626_ = _e1424.z;
                                                    }
                                                    let _e1445 = phi_1626_;
                                                    let _e1447 = triangles.member[(0u + _e1092)].v2_;
                                                    if (_e1431 > _e1447.x) {
                                                        phi_1635_ = _e1431;
                                                    } else {
                                                        phi_1635_ = _e1447.x;
                                                    }
                                                    let _e1452 = phi_1635_;
                                                    if (_e1438 > _e1447.y) {
                                                        phi_1642_ = _e1438;
                                                    } else {
                                                        phi_1642_ = _e1447.y;
                                                    }
                                                    let _e1457 = phi_1642_;
                                                    if (_e1445 > _e1447.z) {
                                                        phi_1649_ = _e1445;
                                                    } else {
                                                        phi_1649_ = _e1447.z;
                                                    }
                                                    let _e1462 = phi_1649_;
                                                    let _e1466 = ((_e1410 - _e250) * _e407);
                                                    let _e1467 = ((_e1415 - _e252) * _e417);
                                                    let _e1468 = ((_e1420 - _e254) * _e427);
                                                    let _e1472 = ((_e1452 - _e250) * _e407);
                                                    let _e1473 = ((_e1457 - _e252) * _e417);
                                                    let _e1474 = ((_e1462 - _e254) * _e427);
                                                    if (_e1466 < _e1472) {
                                                        phi_1666_ = _e1466;
                                                    } else {
                                                        phi_1666_ = _e1472;
                                                    }
                                                    let _e1477 = phi_1666_;
                                                    if (_e1467 < _e1473) {
                                                        phi_1671_ = _e1467;
                                                    } else {
                                                        phi_1671_ = _e1473;
                                                    }
                                                    let _e1480 = phi_1671_;
                                                    if (_e1468 < _e1474) {
                                                        phi_1676_ = _e1468;
                                                    } else {
                                                        phi_1676_ = _e1474;
                                                    }
                                                    let _e1483 = phi_1676_;
                                                    if (_e1466 > _e1472) {
                                                        phi_1684_ = _e1466;
                                                    } else {
                                                        phi_1684_ = _e1472;
                                                    }
                                                    let _e1489 = phi_1684_;
                                                    if (_e1467 > _e1473) {
                                                        phi_1689_ = _e1467;
                                                    } else {
                                                        phi_1689_ = _e1473;
                                                    }
                                                    let _e1492 = phi_1689_;
                                                    if (_e1468 > _e1474) {
                                                        phi_1694_ = _e1468;
                                                    } else {
                                                        phi_1694_ = _e1474;
                                                    }
                                                    let _e1495 = phi_1694_;
                                                    let _e1499 = core_intrinsics_maximum_number_nsz_f32_((_e1477 - _e462), (_e1480 - _e463));
                                                    let _e1500 = core_intrinsics_maximum_number_nsz_f32_(_e1499, (_e1483 - _e464));
                                                    let _e1501 = core_intrinsics_minimum_number_nsz_f32_((_e1489 + _e462), (_e1492 + _e463));
                                                    let _e1502 = core_intrinsics_minimum_number_nsz_f32_(_e1501, (_e1495 + _e464));
                                                    if (_e1500 > -300000000000000000000000000000000000000f) {
                                                        phi_1706_ = _e1500;
                                                    } else {
                                                        phi_1706_ = -300000000000000000000000000000000000000f;
                                                    }
                                                    let _e1505 = phi_1706_;
                                                    if (_e1502 < 300000000000000000000000000000000000000f) {
                                                        phi_1711_ = _e1502;
                                                    } else {
                                                        phi_1711_ = 300000000000000000000000000000000000000f;
                                                    }
                                                    let _e1508 = phi_1711_;
                                                    if (_e1376 < _e1505) {
                                                        phi_1716_ = _e1505;
                                                    } else {
                                                        phi_1716_ = _e1376;
                                                    }
                                                    let _e1511 = phi_1716_;
                                                    if (_e1511 > _e1508) {
                                                        phi_1721_ = _e1508;
                                                    } else {
                                                        phi_1721_ = _e1511;
                                                    }
                                                    let _e1514 = phi_1721_;
                                                    phi_1726_ = lt_bvh_triangle_Intersection(_e1514, (_e1217 / _e1276), (_e1238 / _e1276), (_e1505 <= _e1508));
                                                    phi_1727_ = false;
                                                } else {
                                                    phi_1726_ = lt_bvh_triangle_Intersection();
                                                    phi_1727_ = true;
                                                }
                                                let _e1520 = phi_1726_;
                                                let _e1522 = phi_1727_;
                                                phi_1728_ = _e1520;
                                                phi_1729_ = _e1522;
                                            } else {
                                                phi_1728_ = lt_bvh_triangle_Intersection();
                                                phi_1729_ = true;
                                            }
                                            let _e1524 = phi_1728_;
                                            let _e1526 = phi_1729_;
                                            if _e1526 {
                                            }
                                            phi_1733_ = _e1524;
                                            phi_1734_ = _e1526;
                                        }
                                        let _e1528 = phi_1733_;
                                        let _e1530 = phi_1734_;
                                        phi_1735_ = _e1528;
                                        phi_1736_ = _e1279;
                                        phi_1737_ = _e1530;
                                    } else {
                                        phi_1735_ = lt_bvh_triangle_Intersection();
                                        phi_1736_ = true;
                                        phi_1737_ = false;
                                    }
                                    let _e1532 = phi_1735_;
                                    let _e1534 = phi_1736_;
                                    let _e1536 = phi_1737_;
                                    if _e1534 {
                                        phi_1741_ = true;
                                    } else {
                                        phi_1741_ = _e1536;
                                    }
                                    let _e1538 = phi_1741_;
                                    if _e1538 {
                                        phi_1745_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                    } else {
                                        phi_1745_ = _e1532;
                                    }
                                    let _e1540 = phi_1745_;
                                    if _e1540.is_hit {
                                        if (_e1540.t > 0f) {
                                            if (_e1540.t < _e258) {
                                                if (_e1092 < _e86) {
                                                } else {
                                                    return;
                                                }
                                                let _e1554 = triangles.member[(0u + _e1092)].i0_;
                                                let _e1555 = (_e1554 & 2147483647u);
                                                let _e1557 = triangles.member[(0u + _e1092)].i1_;
                                                let _e1559 = triangles.member[(0u + _e1092)].i2_;
                                                if (_e1555 < _e95) {
                                                } else {
                                                    return;
                                                }
                                                let _e1563 = vertices.member[(0u + _e1555)];
                                                if (_e1557 < _e95) {
                                                } else {
                                                    return;
                                                }
                                                let _e1567 = vertices.member[(0u + _e1557)];
                                                if (_e1559 < _e95) {
                                                } else {
                                                    return;
                                                }
                                                let _e1571 = vertices.member[(0u + _e1559)];
                                                let _e1572 = array<abi_Vertex, 3>(_e1563, _e1567, _e1571);
                                                if (_e1572[0].material < arrayLength((&materials.member))) {
                                                } else {
                                                    return;
                                                }
                                                let _e1578 = materials.member[(0u + _e1572[0].material)];
                                                let _e1580 = ((1f - _e1540.u) - _e1540.v);
                                                if (_e1578.cutoff <= 0f) {
                                                    phi_1974_ = 1f;
                                                } else {
                                                    let _e1607 = (_e1578.base_color.w * ((((f32((_e1572[0].color >> bitcast<u32>(24i))) * _e1580) + (f32((_e1572[1].color >> bitcast<u32>(24i))) * _e1540.u)) + (f32((_e1572[2].color >> bitcast<u32>(24i))) * _e1540.v)) * (1f / 255f)));
                                                    if (_e1578.alpha_size == 0u) {
                                                        phi_1950_ = _e1607;
                                                    } else {
                                                        local_1.offset = _e1578.alpha_offset;
                                                        local_1.size = _e1578.alpha_size;
                                                        local_1.flags = _e1578.flags;
                                                        let _e1638 = _lt_shaders_texture_TextureView_quad((&local_1), (((_e1572[0].u * _e1580) + (_e1572[1].u * _e1540.u)) + (_e1572[2].u * _e1540.v)), (((_e1572[0].v * _e1580) + (_e1572[1].v * _e1540.u)) + (_e1572[2].v * _e1540.v)));
                                                        let _e1642 = (_e1638.indices[0] >> bitcast<u32>(2i));
                                                        if (_e1642 < _e101) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1646 = alpha_texels.member[(0u + _e1642)];
                                                        let _e1662 = (_e1638.indices[1] >> bitcast<u32>(2i));
                                                        if (_e1662 < _e101) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1666 = alpha_texels.member[(0u + _e1662)];
                                                        let _e1683 = (_e1638.indices[2] >> bitcast<u32>(2i));
                                                        if (_e1683 < _e101) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1687 = alpha_texels.member[(0u + _e1683)];
                                                        let _e1704 = (_e1638.indices[3] >> bitcast<u32>(2i));
                                                        if (_e1704 < _e101) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1708 = alpha_texels.member[(0u + _e1704)];
                                                        phi_1950_ = (_e1607 * (((((f32(((_e1646 >> bitcast<u32>((((_e1638.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1638.weights.x) + ((f32(((_e1666 >> bitcast<u32>((((_e1638.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1638.weights.y)) + ((f32(((_e1687 >> bitcast<u32>((((_e1638.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1638.weights.z)) + ((f32(((_e1708 >> bitcast<u32>((((_e1638.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1638.weights.w)));
                                                    }
                                                    let _e1724 = phi_1950_;
                                                    if ((_e1578.flags & 8u) == 0u) {
                                                        if (_e1724 >= _e1578.cutoff) {
                                                            phi_1962_ = 1f;
                                                        } else {
                                                            phi_1962_ = 0f;
                                                        }
                                                        let _e1731 = phi_1962_;
                                                        phi_1973_ = _e1731;
                                                    } else {
                                                        if (_e1724 > 0f) {
                                                            if (_e1724 < 1f) {
                                                                phi_1971_ = _e1724;
                                                            } else {
                                                                phi_1971_ = 1f;
                                                            }
                                                            let _e1735 = phi_1971_;
                                                            phi_1972_ = _e1735;
                                                        } else {
                                                            phi_1972_ = 0f;
                                                        }
                                                        let _e1737 = phi_1972_;
                                                        phi_1973_ = _e1737;
                                                    }
                                                    let _e1739 = phi_1973_;
                                                    phi_1974_ = _e1739;
                                                }
                                                let _e1741 = phi_1974_;
                                                let _e1758 = (1f / 255f);
                                                let _e1777 = (1f / 255f);
                                                let _e1799 = (1f / 255f);
                                                if (_e1578.color_size == 0u) {
                                                    phi_2173_ = vec3<f32>(1f, 1f, 1f);
                                                } else {
                                                    local.offset = _e1578.color_offset;
                                                    local.size = _e1578.color_size;
                                                    local.flags = _e1578.flags;
                                                    let _e1842 = _lt_shaders_texture_TextureView_quad((&local), (((_e1572[0].u * _e1580) + (_e1572[1].u * _e1540.u)) + (_e1572[2].u * _e1540.v)), (((_e1572[0].v * _e1580) + (_e1572[1].v * _e1540.u)) + (_e1572[2].v * _e1540.v)));
                                                    if (_e1842.indices[0] < _e104) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1848 = color_texels.member[(0u + _e1842.indices[0])];
                                                    let _e1859 = (1f / 255f);
                                                    if (_e1842.indices[1] < _e104) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1873 = color_texels.member[(0u + _e1842.indices[1])];
                                                    let _e1884 = (1f / 255f);
                                                    if (_e1842.indices[2] < _e104) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1901 = color_texels.member[(0u + _e1842.indices[2])];
                                                    let _e1912 = (1f / 255f);
                                                    if (_e1842.indices[3] < _e104) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1929 = color_texels.member[(0u + _e1842.indices[3])];
                                                    let _e1940 = (1f / 255f);
                                                    let _e1949 = (((((f32((_e1848 & 255u)) * _e1859) * _e1842.weights.x) + ((f32((_e1873 & 255u)) * _e1884) * _e1842.weights.y)) + ((f32((_e1901 & 255u)) * _e1912) * _e1842.weights.z)) + ((f32((_e1929 & 255u)) * _e1940) * _e1842.weights.w));
                                                    let _e1950 = (((((f32(((_e1848 >> bitcast<u32>(8i)) & 255u)) * _e1859) * _e1842.weights.x) + ((f32(((_e1873 >> bitcast<u32>(8i)) & 255u)) * _e1884) * _e1842.weights.y)) + ((f32(((_e1901 >> bitcast<u32>(8i)) & 255u)) * _e1912) * _e1842.weights.z)) + ((f32(((_e1929 >> bitcast<u32>(8i)) & 255u)) * _e1940) * _e1842.weights.w));
                                                    let _e1951 = (((((f32(((_e1848 >> bitcast<u32>(16i)) & 255u)) * _e1859) * _e1842.weights.x) + ((f32(((_e1873 >> bitcast<u32>(16i)) & 255u)) * _e1884) * _e1842.weights.y)) + ((f32(((_e1901 >> bitcast<u32>(16i)) & 255u)) * _e1912) * _e1842.weights.z)) + ((f32(((_e1929 >> bitcast<u32>(16i)) & 255u)) * _e1940) * _e1842.weights.w));
                                                    phi_2173_ = vec3<f32>((_e1949 * _e1949), (_e1950 * _e1950), (_e1951 * _e1951));
                                                }
                                                let _e1957 = phi_2173_;
                                                let _e1965 = (_e1741 * _e1578.transmission);
                                                let _e1969 = (1f - _e1741);
                                                let _e1970 = ((((_e1578.base_color.x * ((((f32((_e1572[0].color & 255u)) * _e1758) * _e1580) + ((f32((_e1572[1].color & 255u)) * _e1777) * _e1540.u)) + ((f32((_e1572[2].color & 255u)) * _e1799) * _e1540.v))) * _e1957.x) * _e1965) + _e1969);
                                                let _e1971 = ((((_e1578.base_color.y * ((((f32(((_e1572[0].color >> bitcast<u32>(8i)) & 255u)) * _e1758) * _e1580) + ((f32(((_e1572[1].color >> bitcast<u32>(8i)) & 255u)) * _e1777) * _e1540.u)) + ((f32(((_e1572[2].color >> bitcast<u32>(8i)) & 255u)) * _e1799) * _e1540.v))) * _e1957.y) * _e1965) + _e1969);
                                                let _e1972 = ((((_e1578.base_color.z * ((((f32(((_e1572[0].color >> bitcast<u32>(16i)) & 255u)) * _e1758) * _e1580) + ((f32(((_e1572[1].color >> bitcast<u32>(16i)) & 255u)) * _e1777) * _e1540.u)) + ((f32(((_e1572[2].color >> bitcast<u32>(16i)) & 255u)) * _e1799) * _e1540.v))) * _e1957.z) * _e1965) + _e1969);
                                                if (_e1970 > 0f) {
                                                    if (_e1970 < 1f) {
                                                        phi_2197_ = _e1970;
                                                    } else {
                                                        phi_2197_ = 1f;
                                                    }
                                                    let _e1976 = phi_2197_;
                                                    phi_2198_ = _e1976;
                                                } else {
                                                    phi_2198_ = 0f;
                                                }
                                                let _e1978 = phi_2198_;
                                                if (_e1971 > 0f) {
                                                    if (_e1971 < 1f) {
                                                        phi_2207_ = _e1971;
                                                    } else {
                                                        phi_2207_ = 1f;
                                                    }
                                                    let _e1982 = phi_2207_;
                                                    phi_2208_ = _e1982;
                                                } else {
                                                    phi_2208_ = 0f;
                                                }
                                                let _e1984 = phi_2208_;
                                                if (_e1972 > 0f) {
                                                    if (_e1972 < 1f) {
                                                        phi_2217_ = _e1972;
                                                    } else {
                                                        phi_2217_ = 1f;
                                                    }
                                                    let _e1988 = phi_2217_;
                                                    phi_2218_ = _e1988;
                                                } else {
                                                    phi_2218_ = 0f;
                                                }
                                                let _e1990 = phi_2218_;
                                                let _e1998 = (_e1083 * vec3<f32>(_e1978, _e1984, _e1990));
                                                let _e2000 = global[0u];
                                                if ((_e1083.x * _e1978) == _e2000) {
                                                    let _e2003 = global[1u];
                                                    if ((_e1083.y * _e1984) == _e2003) {
                                                        let _e2006 = global[2u];
                                                        phi_2242_ = ((_e1083.z * _e1990) == _e2006);
                                                        phi_2243_ = false;
                                                    } else {
                                                        phi_2242_ = bool();
                                                        phi_2243_ = true;
                                                    }
                                                    let _e2009 = phi_2242_;
                                                    let _e2011 = phi_2243_;
                                                    phi_2244_ = _e2009;
                                                    phi_2245_ = _e2011;
                                                } else {
                                                    phi_2244_ = bool();
                                                    phi_2245_ = true;
                                                }
                                                let _e2013 = phi_2244_;
                                                let _e2015 = phi_2245_;
                                                if _e2015 {
                                                    phi_2249_ = false;
                                                } else {
                                                    phi_2249_ = _e2013;
                                                }
                                                let _e2017 = phi_2249_;
                                                if _e2017 {
                                                    phi_2253_ = false;
                                                } else {
                                                    phi_2253_ = true;
                                                }
                                                let _e2019 = phi_2253_;
                                                phi_2254_ = _e1998;
                                                phi_2255_ = _e1998;
                                                phi_2256_ = _e2019;
                                            } else {
                                                phi_2254_ = vec3<f32>();
                                                phi_2255_ = _e1083;
                                                phi_2256_ = true;
                                            }
                                            let _e2021 = phi_2254_;
                                            let _e2023 = phi_2255_;
                                            let _e2025 = phi_2256_;
                                            phi_2257_ = _e2021;
                                            phi_2258_ = _e2023;
                                            phi_2259_ = _e2025;
                                        } else {
                                            phi_2257_ = vec3<f32>();
                                            phi_2258_ = _e1083;
                                            phi_2259_ = true;
                                        }
                                        let _e2027 = phi_2257_;
                                        let _e2029 = phi_2258_;
                                        let _e2031 = phi_2259_;
                                        phi_2260_ = _e2027;
                                        phi_2261_ = _e2029;
                                        phi_2262_ = _e2031;
                                    } else {
                                        phi_2260_ = vec3<f32>();
                                        phi_2261_ = _e1083;
                                        phi_2262_ = true;
                                    }
                                    let _e2033 = phi_2260_;
                                    let _e2035 = phi_2261_;
                                    let _e2037 = phi_2262_;
                                    if _e2037 {
                                    }
                                    phi_1175_ = (_e1081 & (_e1081 - 1u));
                                    phi_1178_ = _e2035;
                                    phi_2266_ = _e2033;
                                    phi_2267_ = _e2037;
                                }
                                let _e2039 = phi_1175_;
                                let _e2041 = phi_1178_;
                                let _e2043 = phi_2266_;
                                let _e2045 = phi_2267_;
                                local_9 = _e2043;
                                continue;
                                continuing {
                                    phi_1174_ = _e2039;
                                    phi_1177_ = _e2041;
                                    break if !(_e2045);
                                }
                            }
                            let _e2048 = local_6;
                            if _e2048 {
                                let _e2050 = local_2.group_mask;
                                if ((_e2050 & 4278190080u) == 0u) {
                                    let _e2054 = local_2.len;
                                    if (_e2054 == 0u) {
                                        phi_2309_ = false;
                                    } else {
                                        let _e2058 = local_2.len;
                                        local_2.len = (_e2058 - 1u);
                                        let _e2061 = local_2.len;
                                        if (_e2061 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e2066 = local_2.first[(0u + _e2061)];
                                        local_2.group = _e2066;
                                        let _e2069 = local_2.len;
                                        if (_e2069 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e2074 = local_2.mask[(0u + _e2069)];
                                        local_2.group_mask = _e2074;
                                        phi_2309_ = true;
                                    }
                                    let _e2077 = phi_2309_;
                                    phi_2310_ = _e2077;
                                } else {
                                    phi_2310_ = true;
                                }
                                let _e2079 = phi_2310_;
                                if _e2079 {
                                    let _e2081 = local_2.group_mask;
                                    let _e2087 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2081)), 32u, (_e2081 == 0u)));
                                    let _e2091 = local_2.group_mask;
                                    let _e2105 = local_2.group_mask;
                                    local_2.group_mask = (_e2105 & ~((1u << bitcast<u32>((_e2087 & 31u)))));
                                    let _e2108 = local_2.group;
                                    phi_2341_ = (_e2108 + countOneBits(((_e2091 & ~((4294967295u << bitcast<u32>((((_e2087 - 24u) ^ _e505) & 31u))))) & 255u)));
                                } else {
                                    phi_2341_ = 4294967295u;
                                }
                                let _e2111 = phi_2341_;
                                phi_2342_ = _e2111;
                            } else {
                                phi_2342_ = u32();
                            }
                            let _e2113 = phi_2342_;
                            phi_843_ = _e2113;
                            let _e2347 = local_8;
                            phi_846_ = _e2347;
                            let _e2350 = local_9;
                            phi_2343_ = _e2350;
                            let _e2353 = local_10;
                            phi_2344_ = _e2353;
                            phi_2345_ = false;
                        } else {
                            phi_843_ = u32();
                            phi_846_ = vec3<f32>();
                            phi_2343_ = vec3<f32>();
                            phi_2344_ = false;
                            phi_2345_ = true;
                        }
                        let _e2115 = phi_843_;
                        let _e2117 = phi_846_;
                        let _e2119 = phi_2343_;
                        let _e2121 = phi_2344_;
                        let _e2123 = phi_2345_;
                        local_7 = _e2123;
                        local_11 = _e2119;
                        continue;
                        continuing {
                            phi_842_ = _e2115;
                            phi_845_ = _e2117;
                            break if !(_e2121);
                        }
                    }
                    let _e2126 = local_7;
                    if _e2126 {
                        phi_2349_ = false;
                    } else {
                        phi_2349_ = true;
                    }
                    let _e2128 = phi_2349_;
                    if _e2128 {
                        let _e2359 = local_11;
                        phi_2353_ = _e2359;
                    } else {
                        let _e2361 = local_12;
                        phi_2353_ = _e2361;
                    }
                    let _e2130 = phi_2353_;
                    phi_2354_ = _e2130;
                }
                let _e2132 = phi_2354_;
                phi_2355_ = _e2132;
                phi_2356_ = _e331;
            } else {
                phi_2355_ = vec3<f32>();
                phi_2356_ = true;
            }
            let _e2134 = phi_2355_;
            let _e2136 = phi_2356_;
            if _e2136 {
                phi_2360_ = vec3<f32>(1f, 1f, 1f);
            } else {
                phi_2360_ = _e2134;
            }
            let _e2138 = phi_2360_;
            phi_2361_ = _e2138;
        } else {
            phi_2361_ = vec3<f32>(1f, 1f, 1f);
        }
        let _e2140 = phi_2361_;
        if (_e110.first_primitive < arrayLength((&tints.member))) {
        } else {
            return;
        }
        tints.member[(0u + _e110.first_primitive)] = vec4<f32>(_e2140.x, _e2140.y, _e2140.z, 1f);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_tint_tint_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
