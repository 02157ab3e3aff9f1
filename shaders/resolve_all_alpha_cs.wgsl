struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    pad: vec2<u32>,
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

struct lt_math_LightProjection {
    row_x: vec4<f32>,
    row_y: vec4<f32>,
    row_z: vec4<f32>,
    row_w: vec4<f32>,
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
    pad: vec2<u32>,
}

struct type_44 {
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

struct type_57 {
    member: array<lt_bvh_Node>,
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

struct abi_ShadowParams {
    projection: lt_math_LightProjection,
    light: abi_LightParams,
    test: vec4<f32>,
    size: vec2<u32>,
    map_size: u32,
    epsilon: f32,
    root: u32,
    level_count: u32,
    fade_uv: f32,
    pad0_: u32,
}

struct type_65 {
    member: abi_ShadowParams,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_17;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(7) 
var<storage> alpha_texels: type_13;
@group(0) @binding(0) 
var<uniform> p: type_65;
@group(0) @binding(2) 
var<storage> nodes: type_57;
@group(0) @binding(3) 
var<storage> triangles: type_36;
@group(0) @binding(5) 
var<storage> vertices: type_40;
@group(0) @binding(6) 
var<storage> materials: type_44;

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
        let _e81 = phi_222_;
        let _e83 = phi_223_;
        phi_224_ = _e81;
        phi_225_ = _e83;
    } else {
        phi_224_ = lt_bvh_traverse_Tree();
        phi_225_ = true;
    }
    let _e85 = phi_224_;
    let _e87 = phi_225_;
    if _e87 {
        phi_230_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_230_ = _e85;
    }
    let _e92 = phi_230_;
    return lt_bvh_traverse_Tree(_e92.root, _e92.first_primitive);
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

    let _e72 = (*param_3).size;
    let _e73 = (_e72 & 65535u);
    let _e75 = (*param_3).size;
    let _e77 = (_e75 >> bitcast<u32>(16i));
    let _e79 = (*param_3).flags;
    let _e81 = ((_e79 & 4u) != 0u);
    let _e83 = (*param_3).flags;
    let _e86 = ((_e83 >> bitcast<u32>(4u)) & 3u);
    if (_e86 == 0u) {
        if (param_4 > -8388608f) {
            let _e99 = f32(select(0i, select(select(i32(param_4), i32(-2147483648), (param_4 < bitcast<f32>(3472883712u))), 2147483647i, (param_4 > bitcast<f32>(1325400063u))), (param_4 == param_4)));
            if (_e99 > param_4) {
                phi_275_ = 1f;
            } else {
                phi_275_ = 0f;
            }
            let _e102 = phi_275_;
            if (param_4 < 8388608f) {
                phi_280_ = (_e99 - _e102);
                phi_281_ = false;
            } else {
                phi_280_ = f32();
                phi_281_ = true;
            }
            let _e105 = phi_280_;
            let _e107 = phi_281_;
            phi_282_ = _e105;
            phi_283_ = _e107;
        } else {
            phi_282_ = f32();
            phi_283_ = true;
        }
        let _e109 = phi_282_;
        let _e111 = phi_283_;
        if _e111 {
            phi_287_ = param_4;
        } else {
            phi_287_ = _e109;
        }
        let _e113 = phi_287_;
        phi_335_ = (param_4 - _e113);
    } else {
        if (_e86 == 1u) {
            let _e116 = (param_4 * 0.5f);
            if (_e116 > -8388608f) {
                let _e128 = f32(select(0i, select(select(i32(_e116), i32(-2147483648), (_e116 < bitcast<f32>(3472883712u))), 2147483647i, (_e116 > bitcast<f32>(1325400063u))), (_e116 == _e116)));
                if (_e128 > _e116) {
                    phi_313_ = 1f;
                } else {
                    phi_313_ = 0f;
                }
                let _e131 = phi_313_;
                if (_e116 < 8388608f) {
                    phi_318_ = (_e128 - _e131);
                    phi_319_ = false;
                } else {
                    phi_318_ = f32();
                    phi_319_ = true;
                }
                let _e134 = phi_318_;
                let _e136 = phi_319_;
                phi_320_ = _e134;
                phi_321_ = _e136;
            } else {
                phi_320_ = f32();
                phi_321_ = true;
            }
            let _e138 = phi_320_;
            let _e140 = phi_321_;
            if _e140 {
                phi_325_ = _e116;
            } else {
                phi_325_ = _e138;
            }
            let _e142 = phi_325_;
            let _e144 = (param_4 - (2f * _e142));
            if (_e144 > 1f) {
                phi_333_ = (2f - _e144);
            } else {
                phi_333_ = _e144;
            }
            let _e148 = phi_333_;
            phi_334_ = _e148;
        } else {
            phi_334_ = param_4;
        }
        let _e150 = phi_334_;
        phi_335_ = _e150;
    }
    let _e152 = phi_335_;
    if (_e152 > 0f) {
        if (_e152 < 1f) {
            phi_344_ = _e152;
        } else {
            phi_344_ = 1f;
        }
        let _e156 = phi_344_;
        phi_345_ = _e156;
    } else {
        phi_345_ = 0f;
    }
    let _e158 = phi_345_;
    let _e159 = (_e73 - 1u);
    let _e161 = (_e158 * f32(_e73));
    if _e81 {
        let _e168 = select(select(u32(_e161), 0u, (_e161 < bitcast<f32>(0u))), 4294967295u, (_e161 > bitcast<f32>(1333788671u)));
        if (_e159 < _e168) {
            phi_363_ = _e159;
        } else {
            phi_363_ = _e168;
        }
        let _e171 = phi_363_;
        phi_402_ = texture_Axis(_e171, _e171, 0f);
    } else {
        let _e173 = (_e161 + 0.5f);
        let _e180 = select(select(u32(_e173), 0u, (_e173 < bitcast<f32>(0u))), 4294967295u, (_e173 > bitcast<f32>(1333788671u)));
        if (_e73 < _e180) {
            phi_377_ = _e73;
        } else {
            phi_377_ = _e180;
        }
        let _e183 = phi_377_;
        if (_e86 == 0u) {
            phi_384_ = _e159;
        } else {
            phi_384_ = 0u;
        }
        let _e188 = phi_384_;
        if (_e86 == 0u) {
            phi_389_ = 0u;
        } else {
            phi_389_ = _e159;
        }
        let _e191 = phi_389_;
        if (_e183 == 0u) {
            phi_395_ = _e188;
        } else {
            phi_395_ = (_e183 - 1u);
        }
        let _e195 = phi_395_;
        if (_e183 > _e159) {
            phi_400_ = _e191;
        } else {
            phi_400_ = _e183;
        }
        let _e198 = phi_400_;
        phi_402_ = texture_Axis(_e195, _e198, (_e173 - f32(_e183)));
    }
    let _e201 = phi_402_;
    let _e203 = (*param_3).flags;
    let _e206 = ((_e203 >> bitcast<u32>(6u)) & 3u);
    if (_e206 == 0u) {
        if (param_5 > -8388608f) {
            let _e219 = f32(select(0i, select(select(i32(param_5), i32(-2147483648), (param_5 < bitcast<f32>(3472883712u))), 2147483647i, (param_5 > bitcast<f32>(1325400063u))), (param_5 == param_5)));
            if (_e219 > param_5) {
                phi_430_ = 1f;
            } else {
                phi_430_ = 0f;
            }
            let _e222 = phi_430_;
            if (param_5 < 8388608f) {
                phi_435_ = (_e219 - _e222);
                phi_436_ = false;
            } else {
                phi_435_ = f32();
                phi_436_ = true;
            }
            let _e225 = phi_435_;
            let _e227 = phi_436_;
            phi_437_ = _e225;
            phi_438_ = _e227;
        } else {
            phi_437_ = f32();
            phi_438_ = true;
        }
        let _e229 = phi_437_;
        let _e231 = phi_438_;
        if _e231 {
            phi_442_ = param_5;
        } else {
            phi_442_ = _e229;
        }
        let _e233 = phi_442_;
        phi_490_ = (param_5 - _e233);
    } else {
        if (_e206 == 1u) {
            let _e236 = (param_5 * 0.5f);
            if (_e236 > -8388608f) {
                let _e248 = f32(select(0i, select(select(i32(_e236), i32(-2147483648), (_e236 < bitcast<f32>(3472883712u))), 2147483647i, (_e236 > bitcast<f32>(1325400063u))), (_e236 == _e236)));
                if (_e248 > _e236) {
                    phi_468_ = 1f;
                } else {
                    phi_468_ = 0f;
                }
                let _e251 = phi_468_;
                if (_e236 < 8388608f) {
                    phi_473_ = (_e248 - _e251);
                    phi_474_ = false;
                } else {
                    phi_473_ = f32();
                    phi_474_ = true;
                }
                let _e254 = phi_473_;
                let _e256 = phi_474_;
                phi_475_ = _e254;
                phi_476_ = _e256;
            } else {
                phi_475_ = f32();
                phi_476_ = true;
            }
            let _e258 = phi_475_;
            let _e260 = phi_476_;
            if _e260 {
                phi_480_ = _e236;
            } else {
                phi_480_ = _e258;
            }
            let _e262 = phi_480_;
            let _e264 = (param_5 - (2f * _e262));
            if (_e264 > 1f) {
                phi_488_ = (2f - _e264);
            } else {
                phi_488_ = _e264;
            }
            let _e268 = phi_488_;
            phi_489_ = _e268;
        } else {
            phi_489_ = param_5;
        }
        let _e270 = phi_489_;
        phi_490_ = _e270;
    }
    let _e272 = phi_490_;
    if (_e272 > 0f) {
        if (_e272 < 1f) {
            phi_499_ = _e272;
        } else {
            phi_499_ = 1f;
        }
        let _e276 = phi_499_;
        phi_500_ = _e276;
    } else {
        phi_500_ = 0f;
    }
    let _e278 = phi_500_;
    let _e279 = (_e77 - 1u);
    let _e281 = (_e278 * f32(_e77));
    if _e81 {
        let _e288 = select(select(u32(_e281), 0u, (_e281 < bitcast<f32>(0u))), 4294967295u, (_e281 > bitcast<f32>(1333788671u)));
        if (_e279 < _e288) {
            phi_518_ = _e279;
        } else {
            phi_518_ = _e288;
        }
        let _e291 = phi_518_;
        phi_557_ = texture_Axis(_e291, _e291, 0f);
    } else {
        let _e293 = (_e281 + 0.5f);
        let _e300 = select(select(u32(_e293), 0u, (_e293 < bitcast<f32>(0u))), 4294967295u, (_e293 > bitcast<f32>(1333788671u)));
        if (_e77 < _e300) {
            phi_532_ = _e77;
        } else {
            phi_532_ = _e300;
        }
        let _e303 = phi_532_;
        if (_e206 == 0u) {
            phi_539_ = _e279;
        } else {
            phi_539_ = 0u;
        }
        let _e308 = phi_539_;
        if (_e206 == 0u) {
            phi_544_ = 0u;
        } else {
            phi_544_ = _e279;
        }
        let _e311 = phi_544_;
        if (_e303 == 0u) {
            phi_550_ = _e308;
        } else {
            phi_550_ = (_e303 - 1u);
        }
        let _e315 = phi_550_;
        if (_e303 > _e279) {
            phi_555_ = _e311;
        } else {
            phi_555_ = _e303;
        }
        let _e318 = phi_555_;
        phi_557_ = texture_Axis(_e315, _e318, (_e293 - f32(_e303)));
    }
    let _e321 = phi_557_;
    let _e325 = (*param_3).offset;
    let _e332 = (*param_3).offset;
    let _e339 = (*param_3).offset;
    let _e346 = (*param_3).offset;
    return texture_TexelQuad(array<u32, 4>(((_e325 + (_e321.low * _e73)) + _e201.low), ((_e332 + (_e321.low * _e73)) + _e201.high), ((_e339 + (_e321.high * _e73)) + _e201.low), ((_e346 + (_e321.high * _e73)) + _e201.high)), vec4<f32>(((1f - _e201.fraction) * (1f - _e321.fraction)), (_e201.fraction * (1f - _e321.fraction)), ((1f - _e201.fraction) * _e321.fraction), (_e201.fraction * _e321.fraction)));
}

fn core_intrinsics_maximum_number_nsz_f32_(param_6: f32, param_7: f32) -> f32 {
    var phi_616_: bool;
    var phi_620_: f32;

    if (param_6 != param_6) {
        phi_616_ = true;
    } else {
        let _e71 = (param_7 >= param_6);
        if _e71 {
        }
        phi_616_ = _e71;
    }
    let _e73 = phi_616_;
    if _e73 {
        phi_620_ = param_7;
    } else {
        phi_620_ = param_6;
    }
    let _e75 = phi_620_;
    return _e75;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_8: f32, param_9: f32) -> f32 {
    var phi_632_: bool;
    var phi_636_: f32;

    if (param_8 != param_8) {
        phi_632_ = true;
    } else {
        let _e71 = (param_9 <= param_8);
        if _e71 {
        }
        phi_632_ = _e71;
    }
    let _e73 = phi_632_;
    if _e73 {
        phi_636_ = param_9;
    } else {
        phi_636_ = param_8;
    }
    let _e75 = phi_636_;
    return _e75;
}

fn _lt_shaders_abi_Sample_is_valid(param_10: ptr<function, abi_Sample>) -> bool {
    var phi_661_: bool;
    var phi_662_: bool;
    var phi_663_: bool;
    var phi_664_: bool;
    var phi_668_: bool;

    let _e71 = (*param_10).normal[0u];
    let _e73 = global[0u];
    if (_e71 == _e73) {
        let _e76 = (*param_10).normal[1u];
        let _e78 = global[1u];
        if (_e76 == _e78) {
            let _e81 = (*param_10).normal[2u];
            let _e83 = global[2u];
            phi_661_ = (_e81 == _e83);
            phi_662_ = false;
        } else {
            phi_661_ = bool();
            phi_662_ = true;
        }
        let _e86 = phi_661_;
        let _e88 = phi_662_;
        phi_663_ = _e86;
        phi_664_ = _e88;
    } else {
        phi_663_ = bool();
        phi_664_ = true;
    }
    let _e90 = phi_663_;
    let _e92 = phi_664_;
    if _e92 {
        phi_668_ = false;
    } else {
        phi_668_ = _e90;
    }
    let _e94 = phi_668_;
    return !(_e94);
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var local_2: abi_Sample;
    var phi_787_: bool;
    var phi_788_: bool;
    var phi_799_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_800_: bool;
    var phi_801_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_802_: bool;
    var phi_809_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_813_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_860_: f32;
    var phi_915_: bool;
    var phi_916_: bool;
    var phi_917_: bool;
    var phi_921_: bool;
    var phi_922_: bool;
    var phi_923_: bool;
    var phi_924_: bool;
    var phi_925_: bool;
    var phi_926_: bool;
    var phi_927_: bool;
    var phi_928_: bool;
    var phi_929_: bool;
    var phi_930_: bool;
    var phi_931_: bool;
    var phi_932_: bool;
    var phi_933_: bool;
    var phi_934_: bool;
    var phi_935_: bool;
    var phi_936_: bool;
    var phi_937_: bool;
    var phi_938_: bool;
    var phi_942_: bool;
    var phi_946_: bool;
    var phi_1016_: f32;
    var phi_1023_: f32;
    var phi_1030_: f32;
    var phi_1037_: f32;
    var phi_1044_: f32;
    var phi_1051_: f32;
    var phi_1068_: f32;
    var phi_1073_: f32;
    var phi_1078_: f32;
    var phi_1106_: bool;
    var phi_1107_: bool;
    var phi_1115_: u32;
    var phi_1116_: u32;
    var phi_1127_: vec3<f32>;
    var phi_1128_: vec3<f32>;
    var phi_1141_: u32;
    var phi_1146_: u32;
    var phi_1151_: u32;
    var phi_1265_: bool;
    var phi_1266_: bool;
    var phi_1297_: u32;
    var phi_1299_: u32;
    var phi_1380_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1407_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1434_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1440_: u32;
    var phi_1443_: u32;
    var phi_1457_: u32;
    var phi_1467_: u32;
    var phi_1477_: u32;
    var phi_1495_: u32;
    var phi_1505_: u32;
    var phi_1515_: u32;
    var phi_1551_: u32;
    var phi_1564_: u32;
    var phi_1569_: u32;
    var phi_1570_: u32;
    var phi_1571_: u32;
    var phi_1441_: u32;
    var phi_1444_: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_1629_: u32;
    var phi_1674_: vec3<f32>;
    var phi_1675_: vec3<f32>;
    var phi_1704_: vec3<f32>;
    var phi_1705_: vec3<f32>;
    var phi_1734_: vec3<f32>;
    var phi_1735_: vec3<f32>;
    var phi_1753_: bool;
    var phi_1754_: bool;
    var phi_1758_: f32;
    var phi_1759_: f32;
    var phi_1760_: f32;
    var phi_1761_: f32;
    var phi_1769_: f32;
    var phi_1779_: bool;
    var phi_1780_: bool;
    var phi_1784_: f32;
    var phi_1785_: f32;
    var phi_1786_: f32;
    var phi_1787_: f32;
    var phi_1795_: f32;
    var phi_1805_: bool;
    var phi_1806_: bool;
    var phi_1810_: f32;
    var phi_1811_: f32;
    var phi_1812_: f32;
    var phi_1813_: f32;
    var phi_1821_: f32;
    var phi_1836_: f32;
    var phi_1837_: bool;
    var phi_1838_: f32;
    var phi_1839_: bool;
    var phi_1840_: f32;
    var phi_1841_: bool;
    var phi_1859_: f32;
    var phi_1860_: bool;
    var phi_1861_: bool;
    var phi_1862_: f32;
    var phi_1863_: bool;
    var phi_1864_: bool;
    var phi_1868_: bool;
    var phi_1869_: f32;
    var phi_1870_: bool;
    var phi_1898_: vec3<f32>;
    var phi_1899_: vec3<f32>;
    var phi_1924_: vec3<f32>;
    var phi_1925_: vec3<f32>;
    var phi_1950_: vec3<f32>;
    var phi_1951_: vec3<f32>;
    var phi_2007_: f32;
    var phi_2016_: f32;
    var phi_2025_: f32;
    var phi_2034_: f32;
    var phi_2041_: f32;
    var phi_2048_: f32;
    var phi_2061_: f32;
    var phi_2070_: f32;
    var phi_2079_: f32;
    var phi_2088_: f32;
    var phi_2095_: f32;
    var phi_2102_: f32;
    var phi_2119_: f32;
    var phi_2124_: f32;
    var phi_2129_: f32;
    var phi_2137_: f32;
    var phi_2142_: f32;
    var phi_2147_: f32;
    var phi_2159_: f32;
    var phi_2164_: f32;
    var phi_2169_: f32;
    var phi_2174_: f32;
    var phi_2179_: lt_bvh_triangle_Intersection;
    var phi_2180_: bool;
    var phi_2181_: lt_bvh_triangle_Intersection;
    var phi_2182_: bool;
    var phi_2186_: lt_bvh_triangle_Intersection;
    var phi_2187_: bool;
    var phi_2188_: lt_bvh_triangle_Intersection;
    var phi_2189_: bool;
    var phi_2190_: bool;
    var phi_2194_: bool;
    var phi_2198_: lt_bvh_triangle_Intersection;
    var phi_2412_: f32;
    var phi_2415_: bool;
    var phi_2416_: bool;
    var phi_2420_: bool;
    var phi_2421_: bool;
    var phi_2422_: bool;
    var phi_2423_: bool;
    var phi_2424_: bool;
    var phi_2425_: bool;
    var phi_2426_: bool;
    var phi_2427_: bool;
    var phi_2428_: bool;
    var phi_2429_: bool;
    var phi_2430_: bool;
    var phi_2431_: bool;
    var phi_2435_: bool;
    var phi_2436_: bool;
    var phi_1630_: u32;
    var phi_2437_: bool;
    var phi_2438_: bool;
    var phi_2439_: bool;
    var local_6: bool;
    var phi_2481_: bool;
    var phi_2482_: bool;
    var phi_2513_: u32;
    var phi_2514_: u32;
    var phi_2515_: bool;
    var phi_2516_: bool;
    var phi_1300_: u32;
    var phi_2517_: bool;
    var phi_2518_: bool;
    var phi_2519_: bool;
    var phi_2520_: bool;
    var local_7: bool;
    var phi_2524_: bool;
    var phi_2525_: bool;
    var phi_2529_: bool;
    var phi_2533_: bool;
    var phi_2534_: bool;
    var phi_2535_: bool;
    var phi_2536_: bool;
    var phi_2540_: bool;
    var phi_2544_: f32;
    var phi_2545_: f32;
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
        let _e116 = _lt_shaders_abi_Sample_is_valid((&local_2));
        if _e116 {
            let _e118 = local_2.position;
            let _e120 = p.member.light.place;
            let _e126 = p.member.light.place[3u];
            let _e133 = (_e120.x - (_e118.x * _e126));
            let _e134 = (_e120.y - (_e118.y * _e126));
            let _e135 = (_e120.z - (_e118.z * _e126));
            let _e137 = local_2.normal;
            if ((((_e137.x * _e133) + (_e137.y * _e134)) + (_e137.z * _e135)) > 0f) {
                let _e151 = (((_e133 * _e133) + (_e134 * _e134)) + (_e135 * _e135));
                let _e153 = p.member.light.axis;
                let _e165 = p.member.light.place[3u];
                if (_e165 == 0f) {
                    phi_788_ = true;
                } else {
                    let _e168 = p.member.light.range_squared;
                    if (_e151 <= _e168) {
                        let _e171 = p.member.light.cos_outer;
                        phi_787_ = (-((((_e133 * _e153.x) + (_e134 * _e153.y)) + (_e135 * _e153.z))) >= (_e171 * sqrt(_e151)));
                    } else {
                        phi_787_ = false;
                    }
                    let _e176 = phi_787_;
                    phi_788_ = _e176;
                }
                let _e178 = phi_788_;
                if _e178 {
                    let _e180 = local_2.flags;
                    let _e188 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e194 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e188.unnamed.visibility, false), _e188.unnamed_1);
                    phi_799_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e194.unnamed, ((_e180 & 1u) == 0u));
                    phi_800_ = false;
                } else {
                    phi_799_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_800_ = true;
                }
                let _e199 = phi_799_;
                let _e201 = phi_800_;
                phi_801_ = _e199;
                phi_802_ = _e201;
            } else {
                phi_801_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_802_ = true;
            }
            let _e203 = phi_801_;
            let _e205 = phi_802_;
            if _e205 {
                let _e211 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e217 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e211.unnamed.visibility, false), _e211.unnamed_1);
                phi_809_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e217.unnamed, true);
            } else {
                phi_809_ = _e203;
            }
            let _e222 = phi_809_;
            phi_813_ = _e222;
        } else {
            let _e228 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e234 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e228.unnamed.visibility, false), _e228.unnamed_1);
            phi_813_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e234.unnamed, true);
        }
        let _e239 = phi_813_;
        if _e239.unnamed_1 {
            phi_2545_ = _e239.unnamed.visibility;
        } else {
            let _e245 = local_2.position;
            let _e247 = local_2.normal;
            let _e249 = local_2.magnitude;
            let _e251 = ((8f / 8388608f) * _e249);
            let _e259 = (_e245.x + (_e247.x * _e251));
            let _e261 = (_e245.y + (_e247.y * _e251));
            let _e263 = (_e245.z + (_e247.z * _e251));
            let _e265 = p.member.light.place;
            if (_e265.w == 0f) {
                phi_860_ = 300000000000000000000000000000000000000f;
            } else {
                phi_860_ = 1f;
            }
            let _e269 = phi_860_;
            let _e277 = (_e265.x - (_e259 * _e265.w));
            let _e278 = (_e265.y - (_e261 * _e265.w));
            let _e279 = (_e265.z - (_e263 * _e265.w));
            let _e284 = abs(_e277);
            let _e285 = abs(_e278);
            let _e286 = abs(_e279);
            if (abs(_e259) < 1000000000000000f) {
                if (abs(_e261) < 1000000000000000f) {
                    if (abs(_e263) < 1000000000000000f) {
                        if (_e284 < 1000000000000000f) {
                            if (_e285 < 1000000000000000f) {
                                if (_e286 < 1000000000000000f) {
                                    if (_e284 > 0f) {
                                        phi_916_ = bool();
                                        phi_917_ = true;
                                    } else {
                                        let _e294 = (_e285 > 0f);
                                        if _e294 {
                                            phi_915_ = bool();
                                        } else {
                                            phi_915_ = (_e286 > 0f);
                                        }
                                        let _e297 = phi_915_;
                                        phi_916_ = _e297;
                                        phi_917_ = _e294;
                                    }
                                    let _e299 = phi_916_;
                                    let _e301 = phi_917_;
                                    if _e301 {
                                        phi_921_ = true;
                                    } else {
                                        phi_921_ = _e299;
                                    }
                                    let _e303 = phi_921_;
                                    phi_922_ = _e303;
                                    phi_923_ = false;
                                } else {
                                    phi_922_ = bool();
                                    phi_923_ = true;
                                }
                                let _e305 = phi_922_;
                                let _e307 = phi_923_;
                                phi_924_ = _e305;
                                phi_925_ = false;
                                phi_926_ = _e307;
                            } else {
                                phi_924_ = bool();
                                phi_925_ = true;
                                phi_926_ = false;
                            }
                            let _e309 = phi_924_;
                            let _e311 = phi_925_;
                            let _e313 = phi_926_;
                            phi_927_ = _e309;
                            phi_928_ = _e311;
                            phi_929_ = _e313;
                        } else {
                            phi_927_ = bool();
                            phi_928_ = true;
                            phi_929_ = false;
                        }
                        let _e315 = phi_927_;
                        let _e317 = phi_928_;
                        let _e319 = phi_929_;
                        phi_930_ = _e315;
                        phi_931_ = _e317;
                        phi_932_ = _e319;
                    } else {
                        phi_930_ = bool();
                        phi_931_ = true;
                        phi_932_ = false;
                    }
                    let _e321 = phi_930_;
                    let _e323 = phi_931_;
                    let _e325 = phi_932_;
                    phi_933_ = _e321;
                    phi_934_ = _e323;
                    phi_935_ = _e325;
                } else {
                    phi_933_ = bool();
                    phi_934_ = true;
                    phi_935_ = false;
                }
                let _e327 = phi_933_;
                let _e329 = phi_934_;
                let _e331 = phi_935_;
                phi_936_ = _e327;
                phi_937_ = _e329;
                phi_938_ = _e331;
            } else {
                phi_936_ = bool();
                phi_937_ = true;
                phi_938_ = false;
            }
            let _e333 = phi_936_;
            let _e335 = phi_937_;
            let _e337 = phi_938_;
            if _e335 {
                phi_942_ = true;
            } else {
                phi_942_ = _e337;
            }
            let _e339 = phi_942_;
            if _e339 {
                phi_946_ = false;
            } else {
                phi_946_ = _e333;
            }
            let _e341 = phi_946_;
            if _e341 {
                let _e342 = (0u >= _e78);
                if _e342 {
                    phi_2534_ = bool();
                } else {
                    if (0u < _e78) {
                    } else {
                        return;
                    }
                    let _e348 = nodes.member[(0u + 0u)].frame[0u];
                    let _e352 = nodes.member[(0u + 0u)].frame[1u];
                    let _e356 = nodes.member[(0u + 0u)].frame[2u];
                    let _e360 = nodes.member[(0u + 0u)].frame[0u];
                    let _e364 = nodes.member[(0u + 0u)].frame[1u];
                    let _e368 = nodes.member[(0u + 0u)].frame[2u];
                    let _e372 = nodes.member[(0u + 0u)].frame[3u];
                    let _e406 = core_intrinsics_maximum_number_nsz_f32_(abs(_e277), abs(_e278));
                    let _e407 = core_intrinsics_maximum_number_nsz_f32_(_e406, abs(_e279));
                    let _e408 = (_e407 * 0.0000000000009094947f);
                    if (abs(_e277) < _e408) {
                        phi_1016_ = _e408;
                    } else {
                        phi_1016_ = abs(_e277);
                    }
                    let _e413 = phi_1016_;
                    if (_e277 < 0f) {
                        phi_1023_ = (-1f / _e413);
                    } else {
                        phi_1023_ = (1f / _e413);
                    }
                    let _e418 = phi_1023_;
                    if (abs(_e278) < _e408) {
                        phi_1030_ = _e408;
                    } else {
                        phi_1030_ = abs(_e278);
                    }
                    let _e423 = phi_1030_;
                    if (_e278 < 0f) {
                        phi_1037_ = (-1f / _e423);
                    } else {
                        phi_1037_ = (1f / _e423);
                    }
                    let _e428 = phi_1037_;
                    if (abs(_e279) < _e408) {
                        phi_1044_ = _e408;
                    } else {
                        phi_1044_ = abs(_e279);
                    }
                    let _e433 = phi_1044_;
                    if (_e279 < 0f) {
                        phi_1051_ = (-1f / _e433);
                    } else {
                        phi_1051_ = (1f / _e433);
                    }
                    let _e438 = phi_1051_;
                    let _e442 = abs((bitcast<f32>(_e348) - _e259));
                    let _e443 = abs((bitcast<f32>(_e352) - _e261));
                    let _e444 = abs((bitcast<f32>(_e356) - _e263));
                    let _e448 = abs(((bitcast<f32>(_e360) + (bitcast<f32>((((_e372 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e259));
                    let _e449 = abs(((bitcast<f32>(_e364) + (bitcast<f32>((((_e372 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e261));
                    let _e450 = abs(((bitcast<f32>(_e368) + (bitcast<f32>((((_e372 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e263));
                    if (_e442 > _e448) {
                        phi_1068_ = _e442;
                    } else {
                        phi_1068_ = _e448;
                    }
                    let _e453 = phi_1068_;
                    if (_e443 > _e449) {
                        phi_1073_ = _e443;
                    } else {
                        phi_1073_ = _e449;
                    }
                    let _e456 = phi_1073_;
                    if (_e444 > _e450) {
                        phi_1078_ = _e444;
                    } else {
                        phi_1078_ = _e450;
                    }
                    let _e459 = phi_1078_;
                    let _e460 = core_intrinsics_maximum_number_nsz_f32_(_e453, _e456);
                    let _e461 = core_intrinsics_maximum_number_nsz_f32_(_e460, _e459);
                    let _e465 = (_e461 * 0.0000019073486f);
                    let _e466 = (abs(_e418) * _e465);
                    let _e467 = (abs(_e428) * _e465);
                    let _e468 = (abs(_e438) * _e465);
                    let _e472 = (_e461 * 0.0000009536743f);
                    let _e473 = (abs(_e418) * _e472);
                    let _e474 = (abs(_e428) * _e472);
                    let _e475 = (abs(_e438) * _e472);
                    let _e476 = abs(_e277);
                    let _e477 = abs(_e278);
                    let _e478 = abs(_e279);
                    if (_e476 >= _e477) {
                        if (_e476 >= _e478) {
                            phi_1106_ = false;
                        } else {
                            phi_1106_ = true;
                        }
                        let _e482 = phi_1106_;
                        phi_1107_ = _e482;
                    } else {
                        phi_1107_ = true;
                    }
                    let _e484 = phi_1107_;
                    if _e484 {
                        if (_e477 >= _e478) {
                            phi_1115_ = 1u;
                        } else {
                            phi_1115_ = 2u;
                        }
                        let _e487 = phi_1115_;
                        phi_1116_ = _e487;
                    } else {
                        phi_1116_ = 0u;
                    }
                    let _e489 = phi_1116_;
                    if (_e489 == 0u) {
                        phi_1128_ = vec3<f32>(_e278, _e279, _e277);
                    } else {
                        if (_e489 == 1u) {
                            phi_1127_ = vec3<f32>(_e279, _e277, _e278);
                        } else {
                            phi_1127_ = vec3<f32>(_e277, _e278, _e279);
                        }
                        let _e495 = phi_1127_;
                        phi_1128_ = _e495;
                    }
                    let _e497 = phi_1128_;
                    let _e500 = (_e497.x / _e497.z);
                    let _e503 = (_e497.y / _e497.z);
                    if (_e418 < 0f) {
                        phi_1141_ = 0u;
                    } else {
                        phi_1141_ = 1u;
                    }
                    let _e508 = phi_1141_;
                    if (_e428 < 0f) {
                        phi_1146_ = 0u;
                    } else {
                        phi_1146_ = 2u;
                    }
                    let _e511 = phi_1146_;
                    if (_e438 < 0f) {
                        phi_1151_ = 0u;
                    } else {
                        phi_1151_ = 4u;
                    }
                    let _e514 = phi_1151_;
                    let _e516 = ((_e508 | _e511) | _e514);
                    let _e517 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                    local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e517.first[0], _e517.first[1], _e517.first[2], _e517.first[3], _e517.first[4], _e517.first[5], _e517.first[6], _e517.first[7], _e517.first[8], _e517.first[9], _e517.first[10], _e517.first[11], _e517.first[12], _e517.first[13], _e517.first[14], _e517.first[15], _e517.first[16], _e517.first[17], _e517.first[18], _e517.first[19], _e517.first[20], _e517.first[21], _e517.first[22], _e517.first[23], _e517.first[24], _e517.first[25], _e517.first[26], _e517.first[27], _e517.first[28], _e517.first[29], _e517.first[30], _e517.first[31]), array<u32, 32>(_e517.mask[0], _e517.mask[1], _e517.mask[2], _e517.mask[3], _e517.mask[4], _e517.mask[5], _e517.mask[6], _e517.mask[7], _e517.mask[8], _e517.mask[9], _e517.mask[10], _e517.mask[11], _e517.mask[12], _e517.mask[13], _e517.mask[14], _e517.mask[15], _e517.mask[16], _e517.mask[17], _e517.mask[18], _e517.mask[19], _e517.mask[20], _e517.mask[21], _e517.mask[22], _e517.mask[23], _e517.mask[24], _e517.mask[25], _e517.mask[26], _e517.mask[27], _e517.mask[28], _e517.mask[29], _e517.mask[30], _e517.mask[31]), _e517.len, _e517.group, _e517.group_mask);
                    let _e591 = local_1.group_mask;
                    if ((_e591 & 4278190080u) == 0u) {
                        let _e595 = local_1.len;
                        if (_e595 == 0u) {
                            phi_1265_ = false;
                        } else {
                            let _e599 = local_1.len;
                            local_1.len = (_e599 - 1u);
                            let _e602 = local_1.len;
                            if (_e602 < 32u) {
                            } else {
                                return;
                            }
                            let _e607 = local_1.first[(0u + _e602)];
                            local_1.group = _e607;
                            let _e610 = local_1.len;
                            if (_e610 < 32u) {
                            } else {
                                return;
                            }
                            let _e615 = local_1.mask[(0u + _e610)];
                            local_1.group_mask = _e615;
                            phi_1265_ = true;
                        }
                        let _e618 = phi_1265_;
                        phi_1266_ = _e618;
                    } else {
                        phi_1266_ = true;
                    }
                    let _e620 = phi_1266_;
                    if _e620 {
                        let _e622 = local_1.group_mask;
                        let _e628 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e622)), 32u, (_e622 == 0u)));
                        let _e632 = local_1.group_mask;
                        let _e646 = local_1.group_mask;
                        local_1.group_mask = (_e646 & ~((1u << bitcast<u32>((_e628 & 31u)))));
                        let _e649 = local_1.group;
                        phi_1297_ = (_e649 + countOneBits(((_e632 & ~((4294967295u << bitcast<u32>((((_e628 - 24u) ^ 7u) & 31u))))) & 255u)));
                    } else {
                        phi_1297_ = 4294967295u;
                    }
                    let _e652 = phi_1297_;
                    phi_1299_ = _e652;
                    loop {
                        let _e654 = phi_1299_;
                        if (_e654 != 4294967295u) {
                            if (_e654 < _e78) {
                            } else {
                                return;
                            }
                            let _e661 = nodes.member[(0u + _e654)].frame[3u];
                            let _e686 = (bitcast<f32>((((_e661 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e418);
                            let _e687 = (bitcast<f32>((((_e661 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e428);
                            let _e688 = (bitcast<f32>((((_e661 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e438);
                            let _e691 = nodes.member[(0u + _e654)].frame[0u];
                            let _e695 = nodes.member[(0u + _e654)].frame[1u];
                            let _e699 = nodes.member[(0u + _e654)].frame[2u];
                            let _e704 = ((bitcast<f32>(_e691) - _e259) * _e418);
                            let _e705 = ((bitcast<f32>(_e695) - _e261) * _e428);
                            let _e706 = ((bitcast<f32>(_e699) - _e263) * _e438);
                            let _e714 = nodes.member[(0u + _e654)].x;
                            if (_e418 < 0f) {
                                let _e725 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e714.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e731 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e725.unnamed.root, _e714.w), _e725.unnamed_1);
                                let _e737 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e731.unnamed, lt_bvh_traverse_Tree(_e714.x, _e731.unnamed_1.first_primitive));
                                phi_1380_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e737.unnamed, lt_bvh_traverse_Tree(_e737.unnamed_1.root, _e714.y));
                            } else {
                                let _e753 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e714.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e759 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e753.unnamed.root, _e714.y), _e753.unnamed_1);
                                let _e765 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e759.unnamed, lt_bvh_traverse_Tree(_e714.z, _e759.unnamed_1.first_primitive));
                                phi_1380_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e765.unnamed, lt_bvh_traverse_Tree(_e765.unnamed_1.root, _e714.w));
                            }
                            let _e773 = phi_1380_;
                            let _e783 = nodes.member[(0u + _e654)].y;
                            if (_e428 < 0f) {
                                let _e794 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e783.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e800 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e794.unnamed.root, _e783.w), _e794.unnamed_1);
                                let _e806 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e800.unnamed, lt_bvh_traverse_Tree(_e783.x, _e800.unnamed_1.first_primitive));
                                phi_1407_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e806.unnamed, lt_bvh_traverse_Tree(_e806.unnamed_1.root, _e783.y));
                            } else {
                                let _e822 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e783.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e828 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e822.unnamed.root, _e783.y), _e822.unnamed_1);
                                let _e834 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e828.unnamed, lt_bvh_traverse_Tree(_e783.z, _e828.unnamed_1.first_primitive));
                                phi_1407_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e834.unnamed, lt_bvh_traverse_Tree(_e834.unnamed_1.root, _e783.w));
                            }
                            let _e842 = phi_1407_;
                            let _e852 = nodes.member[(0u + _e654)].z;
                            if (_e438 < 0f) {
                                let _e863 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e852.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e869 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e863.unnamed.root, _e852.w), _e863.unnamed_1);
                                let _e875 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e869.unnamed, lt_bvh_traverse_Tree(_e852.x, _e869.unnamed_1.first_primitive));
                                phi_1434_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e875.unnamed, lt_bvh_traverse_Tree(_e875.unnamed_1.root, _e852.y));
                            } else {
                                let _e891 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e852.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e897 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e891.unnamed.root, _e852.y), _e891.unnamed_1);
                                let _e903 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e897.unnamed, lt_bvh_traverse_Tree(_e852.z, _e897.unnamed_1.first_primitive));
                                phi_1434_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e903.unnamed, lt_bvh_traverse_Tree(_e903.unnamed_1.root, _e852.w));
                            }
                            let _e911 = phi_1434_;
                            phi_1440_ = 0u;
                            phi_1443_ = 0u;
                            loop {
                                let _e921 = phi_1440_;
                                let _e923 = phi_1443_;
                                local_3 = _e923;
                                local_4 = _e923;
                                local_5 = _e923;
                                let _e924 = (_e921 < 8u);
                                if _e924 {
                                    let _e926 = (_e921 >> bitcast<u32>(2i));
                                    let _e927 = (_e921 & 3u);
                                    if (_e926 == 0u) {
                                        phi_1457_ = _e773.unnamed.root;
                                    } else {
                                        phi_1457_ = _e773.unnamed.first_primitive;
                                    }
                                    let _e930 = phi_1457_;
                                    if (_e926 == 0u) {
                                        phi_1467_ = _e842.unnamed.root;
                                    } else {
                                        phi_1467_ = _e842.unnamed.first_primitive;
                                    }
                                    let _e939 = phi_1467_;
                                    if (_e926 == 0u) {
                                        phi_1477_ = _e911.unnamed.root;
                                    } else {
                                        phi_1477_ = _e911.unnamed.first_primitive;
                                    }
                                    let _e948 = phi_1477_;
                                    let _e961 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e930 >> bitcast<u32>(((_e927 * 8u) & 31u))) & 255u)) * _e686) + (_e704 - _e466)), ((f32(((_e939 >> bitcast<u32>(((_e927 * 8u) & 31u))) & 255u)) * _e687) + (_e705 - _e467)));
                                    let _e962 = core_intrinsics_maximum_number_nsz_f32_(_e961, ((f32(((_e948 >> bitcast<u32>(((_e927 * 8u) & 31u))) & 255u)) * _e688) + (_e706 - _e468)));
                                    if (_e926 == 0u) {
                                        phi_1495_ = _e773.unnamed_1.root;
                                    } else {
                                        phi_1495_ = _e773.unnamed_1.first_primitive;
                                    }
                                    let _e965 = phi_1495_;
                                    if (_e926 == 0u) {
                                        phi_1505_ = _e842.unnamed_1.root;
                                    } else {
                                        phi_1505_ = _e842.unnamed_1.first_primitive;
                                    }
                                    let _e974 = phi_1505_;
                                    if (_e926 == 0u) {
                                        phi_1515_ = _e911.unnamed_1.root;
                                    } else {
                                        phi_1515_ = _e911.unnamed_1.first_primitive;
                                    }
                                    let _e983 = phi_1515_;
                                    let _e996 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e965 >> bitcast<u32>(((_e927 * 8u) & 31u))) & 255u)) * _e686) + (_e704 + _e466)), ((f32(((_e974 >> bitcast<u32>(((_e927 * 8u) & 31u))) & 255u)) * _e687) + (_e705 + _e467)));
                                    let _e997 = core_intrinsics_minimum_number_nsz_f32_(_e996, ((f32(((_e983 >> bitcast<u32>(((_e927 * 8u) & 31u))) & 255u)) * _e688) + (_e706 + _e468)));
                                    if (_e962 <= _e997) {
                                        if (_e962 <= _e269) {
                                            if (_e997 >= 0f) {
                                                if (_e926 == 0u) {
                                                    let _e1004 = nodes.member[(0u + _e654)].links[2u];
                                                    phi_1551_ = _e1004;
                                                } else {
                                                    let _e1007 = nodes.member[(0u + _e654)].links[3u];
                                                    phi_1551_ = _e1007;
                                                }
                                                let _e1009 = phi_1551_;
                                                let _e1014 = ((_e1009 >> bitcast<u32>(((_e927 * 8u) & 31u))) & 255u);
                                                let _e1015 = (_e1014 & 31u);
                                                if (_e1015 >= 24u) {
                                                    phi_1564_ = (24u + ((_e1015 - 24u) ^ _e516));
                                                } else {
                                                    phi_1564_ = _e1015;
                                                }
                                                let _e1021 = phi_1564_;
                                                phi_1569_ = (_e923 | ((_e1014 >> bitcast<u32>(5i)) << bitcast<u32>((_e1021 & 31u))));
                                            } else {
                                                phi_1569_ = _e923;
                                            }
                                            let _e1029 = phi_1569_;
                                            phi_1570_ = _e1029;
                                        } else {
                                            phi_1570_ = _e923;
                                        }
                                        let _e1031 = phi_1570_;
                                        phi_1571_ = _e1031;
                                    } else {
                                        phi_1571_ = _e923;
                                    }
                                    let _e1033 = phi_1571_;
                                    phi_1441_ = (_e921 + 1u);
                                    phi_1444_ = _e1033;
                                } else {
                                    phi_1441_ = u32();
                                    phi_1444_ = u32();
                                }
                                let _e1036 = phi_1441_;
                                let _e1038 = phi_1444_;
                                continue;
                                continuing {
                                    phi_1440_ = _e1036;
                                    phi_1443_ = _e1038;
                                    break if !(_e924);
                                }
                            }
                            let _e1042 = nodes.member[(0u + _e654)].links[0u];
                            let _e1046 = nodes.member[(0u + _e654)].frame[3u];
                            let _e1050 = local_3;
                            if ((_e1050 & 4278190080u) == 0u) {
                            } else {
                                let _e1054 = local_1.group_mask;
                                if ((_e1054 & 4278190080u) == 0u) {
                                } else {
                                    let _e1058 = local_1.len;
                                    if (_e1058 < 32u) {
                                        let _e1061 = local_1.group;
                                        let _e1063 = local_1.len;
                                        if (_e1063 < 32u) {
                                        } else {
                                            return;
                                        }
                                        local_1.first[(0u + _e1063)] = _e1061;
                                        let _e1069 = local_1.group_mask;
                                        let _e1071 = local_1.len;
                                        if (_e1071 < 32u) {
                                        } else {
                                            return;
                                        }
                                        local_1.mask[(0u + _e1071)] = _e1069;
                                        let _e1078 = local_1.len;
                                        local_1.len = (_e1078 + 1u);
                                    }
                                }
                                local_1.group = (0u + _e1042);
                                let _e1082 = local_4;
                                local_1.group_mask = ((_e1082 & 4278190080u) | (_e1046 >> bitcast<u32>(24i)));
                            }
                            let _e1087 = local_5;
                            phi_1629_ = (_e1087 & 16777215u);
                            loop {
                                let _e1090 = phi_1629_;
                                let _e1091 = (_e1090 == 0u);
                                local_6 = _e1091;
                                local_10 = _e1091;
                                if _e1091 {
                                    phi_1630_ = u32();
                                    phi_2437_ = false;
                                    phi_2438_ = false;
                                    phi_2439_ = false;
                                } else {
                                    let _e1094 = nodes.member[(0u + _e654)].links[1u];
                                    let _e1099 = ((0u + _e1094) + select(firstTrailingBit(_e1090), 32u, (_e1090 == 0u)));
                                    if (_e1099 < _e81) {
                                    } else {
                                        return;
                                    }
                                    let _e1106 = triangles.member[(0u + _e1099)].v0_;
                                    let _e1108 = (_e1106.x - _e259);
                                    let _e1110 = (_e1106.y - _e261);
                                    let _e1112 = (_e1106.z - _e263);
                                    if (_e489 == 0u) {
                                        phi_1675_ = vec3<f32>(_e1110, _e1112, _e1108);
                                    } else {
                                        if (_e489 == 1u) {
                                            phi_1674_ = vec3<f32>(_e1112, _e1108, _e1110);
                                        } else {
                                            phi_1674_ = (_e1106 - vec3<f32>(_e259, _e261, _e263));
                                        }
                                        let _e1120 = phi_1674_;
                                        phi_1675_ = _e1120;
                                    }
                                    let _e1122 = phi_1675_;
                                    let _e1126 = (_e1122.x - (_e500 * _e1122.z));
                                    let _e1130 = (_e1122.y - (_e503 * _e1122.z));
                                    let _e1132 = triangles.member[(0u + _e1099)].v1_;
                                    let _e1134 = (_e1132.x - _e259);
                                    let _e1136 = (_e1132.y - _e261);
                                    let _e1138 = (_e1132.z - _e263);
                                    if (_e489 == 0u) {
                                        phi_1705_ = vec3<f32>(_e1136, _e1138, _e1134);
                                    } else {
                                        if (_e489 == 1u) {
                                            phi_1704_ = vec3<f32>(_e1138, _e1134, _e1136);
                                        } else {
                                            phi_1704_ = (_e1132 - vec3<f32>(_e259, _e261, _e263));
                                        }
                                        let _e1146 = phi_1704_;
                                        phi_1705_ = _e1146;
                                    }
                                    let _e1148 = phi_1705_;
                                    let _e1152 = (_e1148.x - (_e500 * _e1148.z));
                                    let _e1156 = (_e1148.y - (_e503 * _e1148.z));
                                    let _e1158 = triangles.member[(0u + _e1099)].v2_;
                                    let _e1160 = (_e1158.x - _e259);
                                    let _e1162 = (_e1158.y - _e261);
                                    let _e1164 = (_e1158.z - _e263);
                                    if (_e489 == 0u) {
                                        phi_1735_ = vec3<f32>(_e1162, _e1164, _e1160);
                                    } else {
                                        if (_e489 == 1u) {
                                            phi_1734_ = vec3<f32>(_e1164, _e1160, _e1162);
                                        } else {
                                            phi_1734_ = (_e1158 - vec3<f32>(_e259, _e261, _e263));
                                        }
                                        let _e1172 = phi_1734_;
                                        phi_1735_ = _e1172;
                                    }
                                    let _e1174 = phi_1735_;
                                    let _e1178 = (_e1174.x - (_e500 * _e1174.z));
                                    let _e1182 = (_e1174.y - (_e503 * _e1174.z));
                                    if (_e1152 < _e1178) {
                                        phi_1754_ = true;
                                    } else {
                                        if (_e1152 == _e1178) {
                                            phi_1753_ = (_e1156 < _e1182);
                                        } else {
                                            phi_1753_ = false;
                                        }
                                        let _e1187 = phi_1753_;
                                        phi_1754_ = _e1187;
                                    }
                                    let _e1189 = phi_1754_;
                                    if _e1189 {
                                        phi_1758_ = _e1182;
                                        phi_1759_ = _e1178;
                                        phi_1760_ = _e1156;
                                        phi_1761_ = _e1152;
                                    } else {
                                        phi_1758_ = _e1156;
                                        phi_1759_ = _e1152;
                                        phi_1760_ = _e1182;
                                        phi_1761_ = _e1178;
                                    }
                                    let _e1191 = phi_1758_;
                                    let _e1193 = phi_1759_;
                                    let _e1195 = phi_1760_;
                                    let _e1197 = phi_1761_;
                                    let _e1200 = ((_e1197 * _e1191) - (_e1195 * _e1193));
                                    if _e1189 {
                                        phi_1769_ = -(_e1200);
                                    } else {
                                        phi_1769_ = _e1200;
                                    }
                                    let _e1203 = phi_1769_;
                                    if (_e1178 < _e1126) {
                                        phi_1780_ = true;
                                    } else {
                                        if (_e1178 == _e1126) {
                                            phi_1779_ = (_e1182 < _e1130);
                                        } else {
                                            phi_1779_ = false;
                                        }
                                        let _e1208 = phi_1779_;
                                        phi_1780_ = _e1208;
                                    }
                                    let _e1210 = phi_1780_;
                                    if _e1210 {
                                        phi_1784_ = _e1130;
                                        phi_1785_ = _e1126;
                                        phi_1786_ = _e1182;
                                        phi_1787_ = _e1178;
                                    } else {
                                        phi_1784_ = _e1182;
                                        phi_1785_ = _e1178;
                                        phi_1786_ = _e1130;
                                        phi_1787_ = _e1126;
                                    }
                                    let _e1212 = phi_1784_;
                                    let _e1214 = phi_1785_;
                                    let _e1216 = phi_1786_;
                                    let _e1218 = phi_1787_;
                                    let _e1221 = ((_e1218 * _e1212) - (_e1216 * _e1214));
                                    if _e1210 {
                                        phi_1795_ = -(_e1221);
                                    } else {
                                        phi_1795_ = _e1221;
                                    }
                                    let _e1224 = phi_1795_;
                                    if (_e1126 < _e1152) {
                                        phi_1806_ = true;
                                    } else {
                                        if (_e1126 == _e1152) {
                                            phi_1805_ = (_e1130 < _e1156);
                                        } else {
                                            phi_1805_ = false;
                                        }
                                        let _e1229 = phi_1805_;
                                        phi_1806_ = _e1229;
                                    }
                                    let _e1231 = phi_1806_;
                                    if _e1231 {
                                        phi_1810_ = _e1156;
                                        phi_1811_ = _e1152;
                                        phi_1812_ = _e1130;
                                        phi_1813_ = _e1126;
                                    } else {
                                        phi_1810_ = _e1130;
                                        phi_1811_ = _e1126;
                                        phi_1812_ = _e1156;
                                        phi_1813_ = _e1152;
                                    }
                                    let _e1233 = phi_1810_;
                                    let _e1235 = phi_1811_;
                                    let _e1237 = phi_1812_;
                                    let _e1239 = phi_1813_;
                                    let _e1242 = ((_e1239 * _e1233) - (_e1237 * _e1235));
                                    if _e1231 {
                                        phi_1821_ = -(_e1242);
                                    } else {
                                        phi_1821_ = _e1242;
                                    }
                                    let _e1245 = phi_1821_;
                                    if (_e1203 >= 0f) {
                                        if (_e1224 >= 0f) {
                                            if (_e1245 >= 0f) {
                                                phi_1836_ = ((_e1203 + _e1224) + _e1245);
                                                phi_1837_ = false;
                                            } else {
                                                phi_1836_ = f32();
                                                phi_1837_ = true;
                                            }
                                            let _e1252 = phi_1836_;
                                            let _e1254 = phi_1837_;
                                            phi_1838_ = _e1252;
                                            phi_1839_ = _e1254;
                                        } else {
                                            phi_1838_ = f32();
                                            phi_1839_ = true;
                                        }
                                        let _e1256 = phi_1838_;
                                        let _e1258 = phi_1839_;
                                        phi_1840_ = _e1256;
                                        phi_1841_ = _e1258;
                                    } else {
                                        phi_1840_ = f32();
                                        phi_1841_ = true;
                                    }
                                    let _e1260 = phi_1840_;
                                    let _e1262 = phi_1841_;
                                    if _e1262 {
                                        if (_e1203 <= 0f) {
                                            if (_e1224 <= 0f) {
                                                let _e1265 = (_e1245 <= 0f);
                                                if _e1265 {
                                                }
                                                phi_1859_ = ((_e1203 + _e1224) + _e1245);
                                                phi_1860_ = false;
                                                phi_1861_ = _e1265;
                                            } else {
                                                phi_1859_ = f32();
                                                phi_1860_ = true;
                                                phi_1861_ = false;
                                            }
                                            let _e1269 = phi_1859_;
                                            let _e1271 = phi_1860_;
                                            let _e1273 = phi_1861_;
                                            phi_1862_ = _e1269;
                                            phi_1863_ = _e1271;
                                            phi_1864_ = _e1273;
                                        } else {
                                            phi_1862_ = f32();
                                            phi_1863_ = true;
                                            phi_1864_ = false;
                                        }
                                        let _e1275 = phi_1862_;
                                        let _e1277 = phi_1863_;
                                        let _e1279 = phi_1864_;
                                        if _e1277 {
                                            phi_1868_ = false;
                                        } else {
                                            phi_1868_ = _e1279;
                                        }
                                        let _e1281 = phi_1868_;
                                        phi_1869_ = _e1275;
                                        phi_1870_ = _e1281;
                                    } else {
                                        phi_1869_ = _e1260;
                                        phi_1870_ = true;
                                    }
                                    let _e1283 = phi_1869_;
                                    let _e1285 = phi_1870_;
                                    if _e1285 {
                                        let _e1286 = (_e1283 == 0f);
                                        if _e1286 {
                                            phi_2186_ = lt_bvh_triangle_Intersection();
                                            phi_2187_ = false;
                                        } else {
                                            let _e1288 = triangles.member[(0u + _e1099)].v0_;
                                            let _e1290 = (_e1288.x - _e259);
                                            let _e1292 = (_e1288.y - _e261);
                                            let _e1294 = (_e1288.z - _e263);
                                            if (_e489 == 0u) {
                                                phi_1899_ = vec3<f32>(_e1292, _e1294, _e1290);
                                            } else {
                                                if (_e489 == 1u) {
                                                    phi_1898_ = vec3<f32>(_e1294, _e1290, _e1292);
                                                } else {
                                                    phi_1898_ = (_e1288 - vec3<f32>(_e259, _e261, _e263));
                                                }
                                                let _e1302 = phi_1898_;
                                                phi_1899_ = _e1302;
                                            }
                                            let _e1304 = phi_1899_;
                                            let _e1306 = triangles.member[(0u + _e1099)].v1_;
                                            let _e1308 = triangles.member[(0u + _e1099)].v0_;
                                            let _e1311 = (_e1306.x - _e1308.x);
                                            let _e1314 = (_e1306.y - _e1308.y);
                                            let _e1317 = (_e1306.z - _e1308.z);
                                            if (_e489 == 0u) {
                                                phi_1925_ = vec3<f32>(_e1314, _e1317, _e1311);
                                            } else {
                                                if (_e489 == 1u) {
                                                    phi_1924_ = vec3<f32>(_e1317, _e1311, _e1314);
                                                } else {
                                                    phi_1924_ = (_e1306 - _e1308);
                                                }
                                                let _e1324 = phi_1924_;
                                                phi_1925_ = _e1324;
                                            }
                                            let _e1326 = phi_1925_;
                                            let _e1328 = triangles.member[(0u + _e1099)].v2_;
                                            let _e1330 = triangles.member[(0u + _e1099)].v0_;
                                            let _e1333 = (_e1328.x - _e1330.x);
                                            let _e1336 = (_e1328.y - _e1330.y);
                                            let _e1339 = (_e1328.z - _e1330.z);
                                            if (_e489 == 0u) {
                                                phi_1951_ = vec3<f32>(_e1336, _e1339, _e1333);
                                            } else {
                                                if (_e489 == 1u) {
                                                    phi_1950_ = vec3<f32>(_e1339, _e1333, _e1336);
                                                } else {
                                                    phi_1950_ = (_e1328 - _e1330);
                                                }
                                                let _e1346 = phi_1950_;
                                                phi_1951_ = _e1346;
                                            }
                                            let _e1348 = phi_1951_;
                                            let _e1355 = ((_e1326.y * _e1348.z) - (_e1326.z * _e1348.y));
                                            let _e1362 = ((_e1326.z * _e1348.x) - (_e1326.x * _e1348.z));
                                            let _e1369 = ((_e1326.x * _e1348.y) - (_e1326.y * _e1348.x));
                                            let _e1383 = (((1f / _e497.z) * (((_e1355 * _e1304.x) + (_e1362 * _e1304.y)) + (_e1369 * _e1304.z))) / (((_e1355 * _e500) + (_e1362 * _e503)) + _e1369));
                                            if (_e1383 > 0f) {
                                                if (_e1383 < _e269) {
                                                    let _e1387 = triangles.member[(0u + _e1099)].v0_;
                                                    let _e1389 = triangles.member[(0u + _e1099)].v1_;
                                                    if (_e1387.x < _e1389.x) {
                                                        phi_2007_ = _e1387.x;
                                                    } else {
                                                        phi_2007_ = _e1389.x;
                                                    }
                                                    let _e1396 = phi_2007_;
                                                    if (_e1387.y < _e1389.y) {
                                                        phi_2016_ = _e1387.y;
                                                    } else {
                                                        phi_2016_ = _e1389.y;
                                                    }
                                                    let _e1403 = phi_2016_;
                                                    if (_e1387.z < _e1389.z) {
                                                        phi_2025_ = _e1387.z;
                                                    } else {
                                                        phi_2025_ = _e1389.z;
                                                    }
                                                    let _e1410 = phi_2025_;
                                                    let _e1412 = triangles.member[(0u + _e1099)].v2_;
                                                    if (_e1396 < _e1412.x) {
                                                        phi_2034_ = _e1396;
                                                    } else {
                                                        phi_2034_ = _e1412.x;
                                                    }
                                                    let _e1417 = phi_2034_;
                                                    if (_e1403 < _e1412.y) {
                                                        phi_2041_ = _e1403;
                                                    } else {
                                                        phi_2041_ = _e1412.y;
                                                    }
                                                    let _e1422 = phi_2041_;
                                                    if (_e1410 < _e1412.z) {
                                                        phi_2048_ = _e1410;
                                                    } else {
                                                        phi_2048_ = _e1412.z;
                                                    }
                                                    let _e1427 = phi_2048_;
                                                    let _e1429 = triangles.member[(0u + _e1099)].v0_;
                                                    let _e1431 = triangles.member[(0u + _e1099)].v1_;
                                                    if (_e1429.x > _e1431.x) {
                                                        phi_2061_ = _e1429.x;
                                                    } else {
                                                        phi_2061_ = _e1431.x;
                                                    }
                                                    let _e1438 = phi_2061_;
                                                    if (_e1429.y > _e1431.y) {
                                                        phi_2070_ = _e1429.y;
                                                    } else {
                                                        phi_2070_ = _e1431.y;
                                                    }
                                                    let _e1445 = phi_2070_;
                                                    if (_e1429.z > _e1431.z) {
                                                        phi_2079_ = _e1429.z;
                                                    } else {
                                                        phi_2079_ = _e1431.z;
                                                    }
                                                    let _e1452 = phi_2079_;
                                                    let _e1454 = triangles.member[(0u + _e1099)].v2_;
                                                    if (_e1438 > _e1454.x) {
                                                        phi_2088_ = _e1438;
                                                    } else {
                                                        phi_2088_ = _e1454.x;
                                                    }
                                                    let _e1459 = phi_2088_;
                                                    if (_e1445 > _e1454.y) {
                                                        phi_2095_ = _e1445;
                                                    } else {
                                                        phi_2095_ = _e1454.y;
                                                    }
                                                    let _e1464 = phi_2095_;
                                                    if (_e1452 > _e1454.z) {
                                                        phi_2102_ = _e1452;
                                                    } else {
                                                        phi_2102_ = _e1454.z;
                                                    }
                                                    let _e1469 = phi_2102_;
                                                    let _e1473 = ((_e1417 - _e259) * _e418);
                                                    let _e1474 = ((_e1422 - _e261) * _e428);
                                                    let _e1475 = ((_e1427 - _e263) * _e438);
                                                    let _e1479 = ((_e1459 - _e259) * _e418);
                                                    let _e1480 = ((_e1464 - _e261) * _e428);
                                                    let _e1481 = ((_e1469 - _e263) * _e438);
                                                    if (_e1473 < _e1479) {
                                                        phi_2119_ = _e1473;
                                                    } else {
                                                        phi_2119_ = _e1479;
                                                    }
                                                    let _e1484 = phi_2119_;
                                                    if (_e1474 < _e1480) {
                                                        phi_2124_ = _e1474;
                                                    } else {
                                                        phi_2124_ = _e1480;
                                                    }
                                                    let _e1487 = phi_2124_;
                                                    if (_e1475 < _e1481) {
                                                        phi_2129_ = _e1475;
                                                    } else {
                                                        phi_2129_ = _e1481;
                                                    }
                                                    let _e1490 = phi_2129_;
                                                    if (_e1473 > _e1479) {
                                                        phi_2137_ = _e1473;
                                                    } else {
                                                        phi_2137_ = _e1479;
                                                    }
                                                    let _e1496 = phi_2137_;
                                                    if (_e1474 > _e1480) {
                                                        phi_2142_ = _e1474;
                                                    } else {
                                                        phi_2142_ = _e1480;
                                                    }
                                                    let _e1499 = phi_2142_;
                                                    if (_e1475 > _e1481) {
                                                        phi_2147_ = _e1475;
                                                    } else {
                                                        phi_2147_ = _e1481;
                                                    }
                                                    let _e1502 = phi_2147_;
                                                    let _e1506 = core_intrinsics_maximum_number_nsz_f32_((_e1484 - _e473), (_e1487 - _e474));
                                                    let _e1507 = core_intrinsics_maximum_number_nsz_f32_(_e1506, (_e1490 - _e475));
                                                    let _e1508 = core_intrinsics_minimum_number_nsz_f32_((_e1496 + _e473), (_e1499 + _e474));
                                                    let _e1509 = core_intrinsics_minimum_number_nsz_f32_(_e1508, (_e1502 + _e475));
                                                    if (_e1507 > -300000000000000000000000000000000000000f) {
                                                        phi_2159_ = _e1507;
                                                    } else {
                                                        phi_2159_ = -300000000000000000000000000000000000000f;
                                                    }
                                                    let _e1512 = phi_2159_;
                                                    if (_e1509 < 300000000000000000000000000000000000000f) {
                                                        phi_2164_ = _e1509;
                                                    } else {
                                                        phi_2164_ = 300000000000000000000000000000000000000f;
                                                    }
                                                    let _e1515 = phi_2164_;
                                                    if (_e1383 < _e1512) {
                                                        phi_2169_ = _e1512;
                                                    } else {
                                                        phi_2169_ = _e1383;
                                                    }
                                                    let _e1518 = phi_2169_;
                                                    if (_e1518 > _e1515) {
                                                        phi_2174_ = _e1515;
                                                    } else {
                                                        phi_2174_ = _e1518;
                                                    }
                                                    let _e1521 = phi_2174_;
                                                    phi_2179_ = lt_bvh_triangle_Intersection(_e1521, (_e1224 / _e1283), (_e1245 / _e1283), (_e1512 <= _e1515));
                                                    phi_2180_ = false;
                                                } else {
                                                    phi_2179_ = lt_bvh_triangle_Intersection();
                                                    phi_2180_ = true;
                                                }
                                                let _e1527 = phi_2179_;
                                                let _e1529 = phi_2180_;
                                                phi_2181_ = _e1527;
                                                phi_2182_ = _e1529;
                                            } else {
                                                phi_2181_ = lt_bvh_triangle_Intersection();
                                                phi_2182_ = true;
                                            }
                                            let _e1531 = phi_2181_;
                                            let _e1533 = phi_2182_;
                                            if _e1533 {
                                            }
                                            phi_2186_ = _e1531;
                                            phi_2187_ = _e1533;
                                        }
                                        let _e1535 = phi_2186_;
                                        let _e1537 = phi_2187_;
                                        phi_2188_ = _e1535;
                                        phi_2189_ = _e1286;
                                        phi_2190_ = _e1537;
                                    } else {
                                        phi_2188_ = lt_bvh_triangle_Intersection();
                                        phi_2189_ = true;
                                        phi_2190_ = false;
                                    }
                                    let _e1539 = phi_2188_;
                                    let _e1541 = phi_2189_;
                                    let _e1543 = phi_2190_;
                                    if _e1541 {
                                        phi_2194_ = true;
                                    } else {
                                        phi_2194_ = _e1543;
                                    }
                                    let _e1545 = phi_2194_;
                                    if _e1545 {
                                        phi_2198_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                    } else {
                                        phi_2198_ = _e1539;
                                    }
                                    let _e1547 = phi_2198_;
                                    if _e1547.is_hit {
                                        if (_e1547.t > 0f) {
                                            if (_e1547.t < _e269) {
                                                let _e1554 = triangles.member[(0u + _e1099)].i0_;
                                                let _e1556 = ((_e1554 & 2147483648u) == 0u);
                                                if _e1556 {
                                                    phi_2421_ = false;
                                                    phi_2422_ = false;
                                                } else {
                                                    if (_e1099 < _e81) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1563 = triangles.member[(0u + _e1099)].i0_;
                                                    let _e1564 = (_e1563 & 2147483647u);
                                                    let _e1566 = triangles.member[(0u + _e1099)].i1_;
                                                    let _e1568 = triangles.member[(0u + _e1099)].i2_;
                                                    if (_e1564 < _e87) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1572 = vertices.member[(0u + _e1564)];
                                                    if (_e1566 < _e87) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1576 = vertices.member[(0u + _e1566)];
                                                    if (_e1568 < _e87) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1580 = vertices.member[(0u + _e1568)];
                                                    let _e1581 = array<abi_Vertex, 3>(_e1572, _e1576, _e1580);
                                                    if (_e1581[0].material < arrayLength((&materials.member))) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1587 = materials.member[(0u + _e1581[0].material)];
                                                    if ((_e1587.flags & 1u) == 1u) {
                                                        let _e1592 = ((1f - _e1547.u) - _e1547.v);
                                                        if (_e1587.cutoff <= 0f) {
                                                            phi_2415_ = true;
                                                        } else {
                                                            let _e1619 = (_e1587.base_color.w * ((((f32((_e1581[0].color >> bitcast<u32>(24i))) * _e1592) + (f32((_e1581[1].color >> bitcast<u32>(24i))) * _e1547.u)) + (f32((_e1581[2].color >> bitcast<u32>(24i))) * _e1547.v)) * (1f / 255f)));
                                                            if (_e1587.alpha_size == 0u) {
                                                                phi_2412_ = _e1619;
                                                            } else {
                                                                local.offset = _e1587.alpha_offset;
                                                                local.size = _e1587.alpha_size;
                                                                local.flags = _e1587.flags;
                                                                let _e1650 = _lt_shaders_texture_TextureView_quad((&local), (((_e1581[0].u * _e1592) + (_e1581[1].u * _e1547.u)) + (_e1581[2].u * _e1547.v)), (((_e1581[0].v * _e1592) + (_e1581[1].v * _e1547.u)) + (_e1581[2].v * _e1547.v)));
                                                                let _e1654 = (_e1650.indices[0] >> bitcast<u32>(2i));
                                                                if (_e1654 < _e93) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1658 = alpha_texels.member[(0u + _e1654)];
                                                                let _e1674 = (_e1650.indices[1] >> bitcast<u32>(2i));
                                                                if (_e1674 < _e93) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1678 = alpha_texels.member[(0u + _e1674)];
                                                                let _e1695 = (_e1650.indices[2] >> bitcast<u32>(2i));
                                                                if (_e1695 < _e93) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1699 = alpha_texels.member[(0u + _e1695)];
                                                                let _e1716 = (_e1650.indices[3] >> bitcast<u32>(2i));
                                                                if (_e1716 < _e93) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1720 = alpha_texels.member[(0u + _e1716)];
                                                                phi_2412_ = (_e1619 * (((((f32(((_e1658 >> bitcast<u32>((((_e1650.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1650.weights.x) + ((f32(((_e1678 >> bitcast<u32>((((_e1650.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1650.weights.y)) + ((f32(((_e1699 >> bitcast<u32>((((_e1650.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1650.weights.z)) + ((f32(((_e1720 >> bitcast<u32>((((_e1650.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1650.weights.w)));
                                                            }
                                                            let _e1736 = phi_2412_;
                                                            phi_2415_ = (_e1736 >= _e1587.cutoff);
                                                        }
                                                        let _e1740 = phi_2415_;
                                                        phi_2416_ = _e1740;
                                                    } else {
                                                        phi_2416_ = false;
                                                    }
                                                    let _e1742 = phi_2416_;
                                                    if _e1742 {
                                                        phi_2420_ = false;
                                                    } else {
                                                        phi_2420_ = true;
                                                    }
                                                    let _e1744 = phi_2420_;
                                                    phi_2421_ = _e1744;
                                                    phi_2422_ = _e1742;
                                                }
                                                let _e1746 = phi_2421_;
                                                let _e1748 = phi_2422_;
                                                phi_2423_ = _e1746;
                                                phi_2424_ = _e1556;
                                                phi_2425_ = _e1748;
                                            } else {
                                                phi_2423_ = true;
                                                phi_2424_ = false;
                                                phi_2425_ = false;
                                            }
                                            let _e1750 = phi_2423_;
                                            let _e1752 = phi_2424_;
                                            let _e1754 = phi_2425_;
                                            phi_2426_ = _e1750;
                                            phi_2427_ = _e1752;
                                            phi_2428_ = _e1754;
                                        } else {
                                            phi_2426_ = true;
                                            phi_2427_ = false;
                                            phi_2428_ = false;
                                        }
                                        let _e1756 = phi_2426_;
                                        let _e1758 = phi_2427_;
                                        let _e1760 = phi_2428_;
                                        phi_2429_ = _e1756;
                                        phi_2430_ = _e1758;
                                        phi_2431_ = _e1760;
                                    } else {
                                        phi_2429_ = true;
                                        phi_2430_ = false;
                                        phi_2431_ = false;
                                    }
                                    let _e1762 = phi_2429_;
                                    let _e1764 = phi_2430_;
                                    let _e1766 = phi_2431_;
                                    if _e1762 {
                                        phi_2435_ = false;
                                        phi_2436_ = false;
                                    } else {
                                        phi_2435_ = _e1764;
                                        phi_2436_ = _e1766;
                                    }
                                    let _e1768 = phi_2435_;
                                    let _e1770 = phi_2436_;
                                    phi_1630_ = (_e1090 & (_e1090 - 1u));
                                    phi_2437_ = _e1762;
                                    phi_2438_ = _e1768;
                                    phi_2439_ = _e1770;
                                }
                                let _e1772 = phi_1630_;
                                let _e1774 = phi_2437_;
                                let _e1776 = phi_2438_;
                                let _e1778 = phi_2439_;
                                local_8 = _e1776;
                                local_9 = _e1778;
                                continue;
                                continuing {
                                    phi_1629_ = _e1772;
                                    break if !(_e1774);
                                }
                            }
                            let _e1781 = local_6;
                            if _e1781 {
                                let _e1783 = local_1.group_mask;
                                if ((_e1783 & 4278190080u) == 0u) {
                                    let _e1787 = local_1.len;
                                    if (_e1787 == 0u) {
                                        phi_2481_ = false;
                                    } else {
                                        let _e1791 = local_1.len;
                                        local_1.len = (_e1791 - 1u);
                                        let _e1794 = local_1.len;
                                        if (_e1794 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e1799 = local_1.first[(0u + _e1794)];
                                        local_1.group = _e1799;
                                        let _e1802 = local_1.len;
                                        if (_e1802 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e1807 = local_1.mask[(0u + _e1802)];
                                        local_1.group_mask = _e1807;
                                        phi_2481_ = true;
                                    }
                                    let _e1810 = phi_2481_;
                                    phi_2482_ = _e1810;
                                } else {
                                    phi_2482_ = true;
                                }
                                let _e1812 = phi_2482_;
                                if _e1812 {
                                    let _e1814 = local_1.group_mask;
                                    let _e1820 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1814)), 32u, (_e1814 == 0u)));
                                    let _e1824 = local_1.group_mask;
                                    let _e1838 = local_1.group_mask;
                                    local_1.group_mask = (_e1838 & ~((1u << bitcast<u32>((_e1820 & 31u)))));
                                    let _e1841 = local_1.group;
                                    phi_2513_ = (_e1841 + countOneBits(((_e1824 & ~((4294967295u << bitcast<u32>((((_e1820 - 24u) ^ _e516) & 31u))))) & 255u)));
                                } else {
                                    phi_2513_ = 4294967295u;
                                }
                                let _e1844 = phi_2513_;
                                phi_2514_ = _e1844;
                                phi_2515_ = false;
                                phi_2516_ = false;
                            } else {
                                phi_2514_ = u32();
                                let _e2072 = local_8;
                                phi_2515_ = _e2072;
                                let _e2075 = local_9;
                                phi_2516_ = _e2075;
                            }
                            let _e1846 = phi_2514_;
                            let _e1848 = phi_2515_;
                            let _e1850 = phi_2516_;
                            phi_1300_ = _e1846;
                            let _e2079 = local_10;
                            phi_2517_ = _e2079;
                            phi_2518_ = false;
                            phi_2519_ = _e1848;
                            phi_2520_ = _e1850;
                        } else {
                            phi_1300_ = u32();
                            phi_2517_ = false;
                            phi_2518_ = true;
                            phi_2519_ = false;
                            phi_2520_ = false;
                        }
                        let _e1852 = phi_1300_;
                        let _e1854 = phi_2517_;
                        let _e1856 = phi_2518_;
                        let _e1858 = phi_2519_;
                        let _e1860 = phi_2520_;
                        local_7 = _e1856;
                        local_11 = _e1858;
                        local_12 = _e1860;
                        continue;
                        continuing {
                            phi_1299_ = _e1852;
                            break if !(_e1854);
                        }
                    }
                    let _e1863 = local_7;
                    if _e1863 {
                        phi_2524_ = false;
                        phi_2525_ = false;
                    } else {
                        let _e2086 = local_11;
                        phi_2524_ = _e2086;
                        let _e2089 = local_12;
                        phi_2525_ = _e2089;
                    }
                    let _e1865 = phi_2524_;
                    let _e1867 = phi_2525_;
                    if _e1865 {
                        phi_2529_ = true;
                    } else {
                        phi_2529_ = _e1867;
                    }
                    let _e1869 = phi_2529_;
                    if _e1869 {
                        phi_2533_ = true;
                    } else {
                        phi_2533_ = false;
                    }
                    let _e1871 = phi_2533_;
                    phi_2534_ = _e1871;
                }
                let _e1873 = phi_2534_;
                phi_2535_ = _e1873;
                phi_2536_ = _e342;
            } else {
                phi_2535_ = bool();
                phi_2536_ = true;
            }
            let _e1875 = phi_2535_;
            let _e1877 = phi_2536_;
            if _e1877 {
                phi_2540_ = false;
            } else {
                phi_2540_ = _e1875;
            }
            let _e1879 = phi_2540_;
            if _e1879 {
                phi_2544_ = 0f;
            } else {
                phi_2544_ = 1f;
            }
            let _e1881 = phi_2544_;
            phi_2545_ = _e1881;
        }
        let _e1883 = phi_2545_;
        if (_e99.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e99.first_primitive)] = _e1883;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_resolve_resolve_all_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
