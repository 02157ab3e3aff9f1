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

struct type_34 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_38 {
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

struct type_42 {
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

struct type_53 {
    member: array<lt_bvh_Instance>,
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

struct type_62 {
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

struct type_70 {
    member: abi_ShadowParams,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_17;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_70;
@group(0) @binding(2) 
var<storage> nodes: type_62;
@group(0) @binding(3) 
var<storage> triangles: type_34;
@group(0) @binding(6) 
var<storage> vertices: type_38;
@group(0) @binding(7) 
var<storage> materials: type_42;
@group(0) @binding(8) 
var<storage> alpha_texels: type_13;
@group(0) @binding(5) 
var<storage> instances: type_53;

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

fn _lt_shaders_texture_TextureView_quad(param_3: ptr<function, texture_TextureView>, param_4: f32, param_5: f32) -> texture_TexelQuad {
    var phi_282_: f32;
    var phi_287_: f32;
    var phi_288_: bool;
    var phi_289_: f32;
    var phi_290_: bool;
    var phi_294_: f32;
    var phi_320_: f32;
    var phi_325_: f32;
    var phi_326_: bool;
    var phi_327_: f32;
    var phi_328_: bool;
    var phi_332_: f32;
    var phi_340_: f32;
    var phi_341_: f32;
    var phi_342_: f32;
    var phi_351_: f32;
    var phi_352_: f32;
    var phi_370_: u32;
    var phi_384_: u32;
    var phi_391_: u32;
    var phi_396_: u32;
    var phi_402_: u32;
    var phi_407_: u32;
    var phi_409_: texture_Axis;
    var phi_437_: f32;
    var phi_442_: f32;
    var phi_443_: bool;
    var phi_444_: f32;
    var phi_445_: bool;
    var phi_449_: f32;
    var phi_475_: f32;
    var phi_480_: f32;
    var phi_481_: bool;
    var phi_482_: f32;
    var phi_483_: bool;
    var phi_487_: f32;
    var phi_495_: f32;
    var phi_496_: f32;
    var phi_497_: f32;
    var phi_506_: f32;
    var phi_507_: f32;
    var phi_525_: u32;
    var phi_539_: u32;
    var phi_546_: u32;
    var phi_551_: u32;
    var phi_557_: u32;
    var phi_562_: u32;
    var phi_564_: texture_Axis;

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
                phi_282_ = 1f;
            } else {
                phi_282_ = 0f;
            }
            let _e102 = phi_282_;
            if (param_4 < 8388608f) {
                phi_287_ = (_e99 - _e102);
                phi_288_ = false;
            } else {
                phi_287_ = f32();
                phi_288_ = true;
            }
            let _e105 = phi_287_;
            let _e107 = phi_288_;
            phi_289_ = _e105;
            phi_290_ = _e107;
        } else {
            phi_289_ = f32();
            phi_290_ = true;
        }
        let _e109 = phi_289_;
        let _e111 = phi_290_;
        if _e111 {
            phi_294_ = param_4;
        } else {
            phi_294_ = _e109;
        }
        let _e113 = phi_294_;
        phi_342_ = (param_4 - _e113);
    } else {
        if (_e86 == 1u) {
            let _e116 = (param_4 * 0.5f);
            if (_e116 > -8388608f) {
                let _e128 = f32(select(0i, select(select(i32(_e116), i32(-2147483648), (_e116 < bitcast<f32>(3472883712u))), 2147483647i, (_e116 > bitcast<f32>(1325400063u))), (_e116 == _e116)));
                if (_e128 > _e116) {
                    phi_320_ = 1f;
                } else {
                    phi_320_ = 0f;
                }
                let _e131 = phi_320_;
                if (_e116 < 8388608f) {
                    phi_325_ = (_e128 - _e131);
                    phi_326_ = false;
                } else {
                    phi_325_ = f32();
                    phi_326_ = true;
                }
                let _e134 = phi_325_;
                let _e136 = phi_326_;
                phi_327_ = _e134;
                phi_328_ = _e136;
            } else {
                phi_327_ = f32();
                phi_328_ = true;
            }
            let _e138 = phi_327_;
            let _e140 = phi_328_;
            if _e140 {
                phi_332_ = _e116;
            } else {
                phi_332_ = _e138;
            }
            let _e142 = phi_332_;
            let _e144 = (param_4 - (2f * _e142));
            if (_e144 > 1f) {
                phi_340_ = (2f - _e144);
            } else {
                phi_340_ = _e144;
            }
            let _e148 = phi_340_;
            phi_341_ = _e148;
        } else {
            phi_341_ = param_4;
        }
        let _e150 = phi_341_;
        phi_342_ = _e150;
    }
    let _e152 = phi_342_;
    if (_e152 > 0f) {
        if (_e152 < 1f) {
            phi_351_ = _e152;
        } else {
            phi_351_ = 1f;
        }
        let _e156 = phi_351_;
        phi_352_ = _e156;
    } else {
        phi_352_ = 0f;
    }
    let _e158 = phi_352_;
    let _e159 = (_e73 - 1u);
    let _e161 = (_e158 * f32(_e73));
    if _e81 {
        let _e168 = select(select(u32(_e161), 0u, (_e161 < bitcast<f32>(0u))), 4294967295u, (_e161 > bitcast<f32>(1333788671u)));
        if (_e159 < _e168) {
            phi_370_ = _e159;
        } else {
            phi_370_ = _e168;
        }
        let _e171 = phi_370_;
        phi_409_ = texture_Axis(_e171, _e171, 0f);
    } else {
        let _e173 = (_e161 + 0.5f);
        let _e180 = select(select(u32(_e173), 0u, (_e173 < bitcast<f32>(0u))), 4294967295u, (_e173 > bitcast<f32>(1333788671u)));
        if (_e73 < _e180) {
            phi_384_ = _e73;
        } else {
            phi_384_ = _e180;
        }
        let _e183 = phi_384_;
        if (_e86 == 0u) {
            phi_391_ = _e159;
        } else {
            phi_391_ = 0u;
        }
        let _e188 = phi_391_;
        if (_e86 == 0u) {
            phi_396_ = 0u;
        } else {
            phi_396_ = _e159;
        }
        let _e191 = phi_396_;
        if (_e183 == 0u) {
            phi_402_ = _e188;
        } else {
            phi_402_ = (_e183 - 1u);
        }
        let _e195 = phi_402_;
        if (_e183 > _e159) {
            phi_407_ = _e191;
        } else {
            phi_407_ = _e183;
        }
        let _e198 = phi_407_;
        phi_409_ = texture_Axis(_e195, _e198, (_e173 - f32(_e183)));
    }
    let _e201 = phi_409_;
    let _e203 = (*param_3).flags;
    let _e206 = ((_e203 >> bitcast<u32>(6u)) & 3u);
    if (_e206 == 0u) {
        if (param_5 > -8388608f) {
            let _e219 = f32(select(0i, select(select(i32(param_5), i32(-2147483648), (param_5 < bitcast<f32>(3472883712u))), 2147483647i, (param_5 > bitcast<f32>(1325400063u))), (param_5 == param_5)));
            if (_e219 > param_5) {
                phi_437_ = 1f;
            } else {
                phi_437_ = 0f;
            }
            let _e222 = phi_437_;
            if (param_5 < 8388608f) {
                phi_442_ = (_e219 - _e222);
                phi_443_ = false;
            } else {
                phi_442_ = f32();
                phi_443_ = true;
            }
            let _e225 = phi_442_;
            let _e227 = phi_443_;
            phi_444_ = _e225;
            phi_445_ = _e227;
        } else {
            phi_444_ = f32();
            phi_445_ = true;
        }
        let _e229 = phi_444_;
        let _e231 = phi_445_;
        if _e231 {
            phi_449_ = param_5;
        } else {
            phi_449_ = _e229;
        }
        let _e233 = phi_449_;
        phi_497_ = (param_5 - _e233);
    } else {
        if (_e206 == 1u) {
            let _e236 = (param_5 * 0.5f);
            if (_e236 > -8388608f) {
                let _e248 = f32(select(0i, select(select(i32(_e236), i32(-2147483648), (_e236 < bitcast<f32>(3472883712u))), 2147483647i, (_e236 > bitcast<f32>(1325400063u))), (_e236 == _e236)));
                if (_e248 > _e236) {
                    phi_475_ = 1f;
                } else {
                    phi_475_ = 0f;
                }
                let _e251 = phi_475_;
                if (_e236 < 8388608f) {
                    phi_480_ = (_e248 - _e251);
                    phi_481_ = false;
                } else {
                    phi_480_ = f32();
                    phi_481_ = true;
                }
                let _e254 = phi_480_;
                let _e256 = phi_481_;
                phi_482_ = _e254;
                phi_483_ = _e256;
            } else {
                phi_482_ = f32();
                phi_483_ = true;
            }
            let _e258 = phi_482_;
            let _e260 = phi_483_;
            if _e260 {
                phi_487_ = _e236;
            } else {
                phi_487_ = _e258;
            }
            let _e262 = phi_487_;
            let _e264 = (param_5 - (2f * _e262));
            if (_e264 > 1f) {
                phi_495_ = (2f - _e264);
            } else {
                phi_495_ = _e264;
            }
            let _e268 = phi_495_;
            phi_496_ = _e268;
        } else {
            phi_496_ = param_5;
        }
        let _e270 = phi_496_;
        phi_497_ = _e270;
    }
    let _e272 = phi_497_;
    if (_e272 > 0f) {
        if (_e272 < 1f) {
            phi_506_ = _e272;
        } else {
            phi_506_ = 1f;
        }
        let _e276 = phi_506_;
        phi_507_ = _e276;
    } else {
        phi_507_ = 0f;
    }
    let _e278 = phi_507_;
    let _e279 = (_e77 - 1u);
    let _e281 = (_e278 * f32(_e77));
    if _e81 {
        let _e288 = select(select(u32(_e281), 0u, (_e281 < bitcast<f32>(0u))), 4294967295u, (_e281 > bitcast<f32>(1333788671u)));
        if (_e279 < _e288) {
            phi_525_ = _e279;
        } else {
            phi_525_ = _e288;
        }
        let _e291 = phi_525_;
        phi_564_ = texture_Axis(_e291, _e291, 0f);
    } else {
        let _e293 = (_e281 + 0.5f);
        let _e300 = select(select(u32(_e293), 0u, (_e293 < bitcast<f32>(0u))), 4294967295u, (_e293 > bitcast<f32>(1333788671u)));
        if (_e77 < _e300) {
            phi_539_ = _e77;
        } else {
            phi_539_ = _e300;
        }
        let _e303 = phi_539_;
        if (_e206 == 0u) {
            phi_546_ = _e279;
        } else {
            phi_546_ = 0u;
        }
        let _e308 = phi_546_;
        if (_e206 == 0u) {
            phi_551_ = 0u;
        } else {
            phi_551_ = _e279;
        }
        let _e311 = phi_551_;
        if (_e303 == 0u) {
            phi_557_ = _e308;
        } else {
            phi_557_ = (_e303 - 1u);
        }
        let _e315 = phi_557_;
        if (_e303 > _e279) {
            phi_562_ = _e311;
        } else {
            phi_562_ = _e303;
        }
        let _e318 = phi_562_;
        phi_564_ = texture_Axis(_e315, _e318, (_e293 - f32(_e303)));
    }
    let _e321 = phi_564_;
    let _e325 = (*param_3).offset;
    let _e332 = (*param_3).offset;
    let _e339 = (*param_3).offset;
    let _e346 = (*param_3).offset;
    return texture_TexelQuad(array<u32, 4>(((_e325 + (_e321.low * _e73)) + _e201.low), ((_e332 + (_e321.low * _e73)) + _e201.high), ((_e339 + (_e321.high * _e73)) + _e201.low), ((_e346 + (_e321.high * _e73)) + _e201.high)), vec4<f32>(((1f - _e201.fraction) * (1f - _e321.fraction)), (_e201.fraction * (1f - _e321.fraction)), ((1f - _e201.fraction) * _e321.fraction), (_e201.fraction * _e321.fraction)));
}

fn core_intrinsics_maximum_number_nsz_f32_(param_6: f32, param_7: f32) -> f32 {
    var phi_623_: bool;
    var phi_627_: f32;

    if (param_6 != param_6) {
        phi_623_ = true;
    } else {
        let _e71 = (param_7 >= param_6);
        if _e71 {
        }
        phi_623_ = _e71;
    }
    let _e73 = phi_623_;
    if _e73 {
        phi_627_ = param_7;
    } else {
        phi_627_ = param_6;
    }
    let _e75 = phi_627_;
    return _e75;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_8: f32, param_9: f32) -> f32 {
    var phi_639_: bool;
    var phi_643_: f32;

    if (param_8 != param_8) {
        phi_639_ = true;
    } else {
        let _e71 = (param_9 <= param_8);
        if _e71 {
        }
        phi_639_ = _e71;
    }
    let _e73 = phi_639_;
    if _e73 {
        phi_643_ = param_9;
    } else {
        phi_643_ = param_8;
    }
    let _e75 = phi_643_;
    return _e75;
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
    var phi_1306_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1333_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1360_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1366_: u32;
    var phi_1369_: u32;
    var phi_1383_: u32;
    var phi_1393_: u32;
    var phi_1403_: u32;
    var phi_1421_: u32;
    var phi_1431_: u32;
    var phi_1441_: u32;
    var phi_1477_: u32;
    var phi_1490_: u32;
    var phi_1495_: u32;
    var phi_1496_: u32;
    var phi_1497_: u32;
    var phi_1367_: u32;
    var phi_1370_: u32;
    var local_4: u32;
    var local_5: u32;
    var local_6: u32;
    var phi_1555_: u32;
    var phi_1605_: f32;
    var phi_1610_: f32;
    var phi_1615_: f32;
    var phi_1623_: f32;
    var phi_1628_: f32;
    var phi_1633_: f32;
    var phi_1777_: bool;
    var phi_1778_: bool;
    var phi_1779_: bool;
    var phi_1783_: bool;
    var phi_1784_: bool;
    var phi_1785_: bool;
    var phi_1786_: bool;
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
    var phi_1804_: bool;
    var phi_1808_: bool;
    var phi_1878_: f32;
    var phi_1885_: f32;
    var phi_1892_: f32;
    var phi_1899_: f32;
    var phi_1906_: f32;
    var phi_1913_: f32;
    var phi_1930_: f32;
    var phi_1935_: f32;
    var phi_1940_: f32;
    var phi_1968_: bool;
    var phi_1969_: bool;
    var phi_1977_: u32;
    var phi_1978_: u32;
    var phi_1989_: vec3<f32>;
    var phi_1990_: vec3<f32>;
    var phi_2003_: u32;
    var phi_2008_: u32;
    var phi_2013_: u32;
    var phi_2127_: bool;
    var phi_2128_: bool;
    var phi_2159_: u32;
    var phi_2161_: u32;
    var phi_2242_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2269_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2296_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2302_: u32;
    var phi_2305_: u32;
    var phi_2319_: u32;
    var phi_2329_: u32;
    var phi_2339_: u32;
    var phi_2357_: u32;
    var phi_2367_: u32;
    var phi_2377_: u32;
    var phi_2413_: u32;
    var phi_2426_: u32;
    var phi_2431_: u32;
    var phi_2432_: u32;
    var phi_2433_: u32;
    var phi_2303_: u32;
    var phi_2306_: u32;
    var local_7: u32;
    var local_8: u32;
    var local_9: u32;
    var phi_2491_: u32;
    var phi_2536_: vec3<f32>;
    var phi_2537_: vec3<f32>;
    var phi_2566_: vec3<f32>;
    var phi_2567_: vec3<f32>;
    var phi_2596_: vec3<f32>;
    var phi_2597_: vec3<f32>;
    var phi_2615_: bool;
    var phi_2616_: bool;
    var phi_2620_: f32;
    var phi_2621_: f32;
    var phi_2622_: f32;
    var phi_2623_: f32;
    var phi_2631_: f32;
    var phi_2641_: bool;
    var phi_2642_: bool;
    var phi_2646_: f32;
    var phi_2647_: f32;
    var phi_2648_: f32;
    var phi_2649_: f32;
    var phi_2657_: f32;
    var phi_2667_: bool;
    var phi_2668_: bool;
    var phi_2672_: f32;
    var phi_2673_: f32;
    var phi_2674_: f32;
    var phi_2675_: f32;
    var phi_2683_: f32;
    var phi_2698_: f32;
    var phi_2699_: bool;
    var phi_2700_: f32;
    var phi_2701_: bool;
    var phi_2702_: f32;
    var phi_2703_: bool;
    var phi_2721_: f32;
    var phi_2722_: bool;
    var phi_2723_: bool;
    var phi_2724_: f32;
    var phi_2725_: bool;
    var phi_2726_: bool;
    var phi_2730_: bool;
    var phi_2731_: f32;
    var phi_2732_: bool;
    var phi_2760_: vec3<f32>;
    var phi_2761_: vec3<f32>;
    var phi_2786_: vec3<f32>;
    var phi_2787_: vec3<f32>;
    var phi_2812_: vec3<f32>;
    var phi_2813_: vec3<f32>;
    var phi_2869_: f32;
    var phi_2878_: f32;
    var phi_2887_: f32;
    var phi_2896_: f32;
    var phi_2903_: f32;
    var phi_2910_: f32;
    var phi_2923_: f32;
    var phi_2932_: f32;
    var phi_2941_: f32;
    var phi_2950_: f32;
    var phi_2957_: f32;
    var phi_2964_: f32;
    var phi_2981_: f32;
    var phi_2986_: f32;
    var phi_2991_: f32;
    var phi_2999_: f32;
    var phi_3004_: f32;
    var phi_3009_: f32;
    var phi_3021_: f32;
    var phi_3026_: f32;
    var phi_3031_: f32;
    var phi_3036_: f32;
    var phi_3041_: lt_bvh_triangle_Intersection;
    var phi_3042_: bool;
    var phi_3043_: lt_bvh_triangle_Intersection;
    var phi_3044_: bool;
    var phi_3048_: lt_bvh_triangle_Intersection;
    var phi_3049_: bool;
    var phi_3050_: lt_bvh_triangle_Intersection;
    var phi_3051_: bool;
    var phi_3052_: bool;
    var phi_3056_: bool;
    var phi_3060_: lt_bvh_triangle_Intersection;
    var phi_3274_: f32;
    var phi_3277_: bool;
    var phi_3278_: bool;
    var phi_3282_: bool;
    var phi_3283_: bool;
    var phi_3284_: bool;
    var phi_3285_: bool;
    var phi_3286_: bool;
    var phi_3287_: bool;
    var phi_3288_: bool;
    var phi_3289_: bool;
    var phi_3290_: bool;
    var phi_3291_: bool;
    var phi_3292_: bool;
    var phi_3293_: bool;
    var phi_3297_: bool;
    var phi_3298_: bool;
    var phi_2492_: u32;
    var phi_3299_: bool;
    var phi_3300_: bool;
    var phi_3301_: bool;
    var local_10: bool;
    var phi_3343_: bool;
    var phi_3344_: bool;
    var phi_3375_: u32;
    var phi_3376_: u32;
    var phi_3377_: bool;
    var phi_3378_: bool;
    var phi_2162_: u32;
    var phi_3379_: bool;
    var phi_3380_: bool;
    var phi_3381_: bool;
    var phi_3382_: bool;
    var local_11: bool;
    var phi_3386_: bool;
    var phi_3387_: bool;
    var phi_3391_: bool;
    var phi_3395_: bool;
    var phi_3396_: bool;
    var phi_3397_: bool;
    var phi_3398_: bool;
    var phi_3402_: bool;
    var phi_3406_: bool;
    var phi_3407_: bool;
    var phi_3408_: bool;
    var phi_3409_: bool;
    var phi_1556_: u32;
    var phi_3413_: bool;
    var local_12: bool;
    var phi_3455_: bool;
    var phi_3456_: bool;
    var phi_3487_: u32;
    var phi_3488_: u32;
    var phi_1226_: u32;
    var phi_3489_: bool;
    var phi_3490_: bool;
    var local_13: bool;
    var phi_3494_: bool;
    var phi_3498_: bool;
    var phi_3499_: bool;
    var phi_3500_: bool;
    var phi_3501_: bool;
    var phi_3505_: bool;
    var phi_3509_: f32;
    var phi_3510_: f32;
    var local_14: bool;
    var local_15: bool;
    var local_16: bool;
    var local_17: bool;
    var local_18: bool;
    var local_19: bool;

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
            phi_3510_ = _e200.unnamed.visibility;
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
                    phi_3499_ = bool();
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
                    loop {
                        let _e585 = phi_1225_;
                        if (_e585 != 4294967295u) {
                            if (_e585 < _e79) {
                            } else {
                                return;
                            }
                            let _e592 = nodes.member[(0u + _e585)].frame[3u];
                            let _e617 = (bitcast<f32>((((_e592 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e379);
                            let _e618 = (bitcast<f32>((((_e592 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e389);
                            let _e619 = (bitcast<f32>((((_e592 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e399);
                            let _e622 = nodes.member[(0u + _e585)].frame[0u];
                            let _e626 = nodes.member[(0u + _e585)].frame[1u];
                            let _e630 = nodes.member[(0u + _e585)].frame[2u];
                            let _e635 = ((bitcast<f32>(_e622) - _e223) * _e379);
                            let _e636 = ((bitcast<f32>(_e626) - _e225) * _e389);
                            let _e637 = ((bitcast<f32>(_e630) - _e227) * _e399);
                            let _e645 = nodes.member[(0u + _e585)].x;
                            if (_e379 < 0f) {
                                let _e656 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e645.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e662 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e656.unnamed.root, _e645.w), _e656.unnamed_1);
                                let _e668 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e662.unnamed, lt_bvh_traverse_Tree(_e645.x, _e662.unnamed_1.first_primitive));
                                phi_1306_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e668.unnamed, lt_bvh_traverse_Tree(_e668.unnamed_1.root, _e645.y));
                            } else {
                                let _e684 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e645.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e690 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e684.unnamed.root, _e645.y), _e684.unnamed_1);
                                let _e696 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e690.unnamed, lt_bvh_traverse_Tree(_e645.z, _e690.unnamed_1.first_primitive));
                                phi_1306_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e696.unnamed, lt_bvh_traverse_Tree(_e696.unnamed_1.root, _e645.w));
                            }
                            let _e704 = phi_1306_;
                            let _e714 = nodes.member[(0u + _e585)].y;
                            if (_e389 < 0f) {
                                let _e725 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e714.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e731 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e725.unnamed.root, _e714.w), _e725.unnamed_1);
                                let _e737 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e731.unnamed, lt_bvh_traverse_Tree(_e714.x, _e731.unnamed_1.first_primitive));
                                phi_1333_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e737.unnamed, lt_bvh_traverse_Tree(_e737.unnamed_1.root, _e714.y));
                            } else {
                                let _e753 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e714.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e759 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e753.unnamed.root, _e714.y), _e753.unnamed_1);
                                let _e765 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e759.unnamed, lt_bvh_traverse_Tree(_e714.z, _e759.unnamed_1.first_primitive));
                                phi_1333_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e765.unnamed, lt_bvh_traverse_Tree(_e765.unnamed_1.root, _e714.w));
                            }
                            let _e773 = phi_1333_;
                            let _e783 = nodes.member[(0u + _e585)].z;
                            if (_e399 < 0f) {
                                let _e794 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e783.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e800 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e794.unnamed.root, _e783.w), _e794.unnamed_1);
                                let _e806 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e800.unnamed, lt_bvh_traverse_Tree(_e783.x, _e800.unnamed_1.first_primitive));
                                phi_1360_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e806.unnamed, lt_bvh_traverse_Tree(_e806.unnamed_1.root, _e783.y));
                            } else {
                                let _e822 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e783.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e828 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e822.unnamed.root, _e783.y), _e822.unnamed_1);
                                let _e834 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e828.unnamed, lt_bvh_traverse_Tree(_e783.z, _e828.unnamed_1.first_primitive));
                                phi_1360_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e834.unnamed, lt_bvh_traverse_Tree(_e834.unnamed_1.root, _e783.w));
                            }
                            let _e842 = phi_1360_;
                            phi_1366_ = 0u;
                            phi_1369_ = 0u;
                            loop {
                                let _e852 = phi_1366_;
                                let _e854 = phi_1369_;
                                local_4 = _e854;
                                local_5 = _e854;
                                local_6 = _e854;
                                let _e855 = (_e852 < 8u);
                                if _e855 {
                                    let _e857 = (_e852 >> bitcast<u32>(2i));
                                    let _e858 = (_e852 & 3u);
                                    if (_e857 == 0u) {
                                        phi_1383_ = _e704.unnamed.root;
                                    } else {
                                        phi_1383_ = _e704.unnamed.first_primitive;
                                    }
                                    let _e861 = phi_1383_;
                                    if (_e857 == 0u) {
                                        phi_1393_ = _e773.unnamed.root;
                                    } else {
                                        phi_1393_ = _e773.unnamed.first_primitive;
                                    }
                                    let _e870 = phi_1393_;
                                    if (_e857 == 0u) {
                                        phi_1403_ = _e842.unnamed.root;
                                    } else {
                                        phi_1403_ = _e842.unnamed.first_primitive;
                                    }
                                    let _e879 = phi_1403_;
                                    let _e892 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e861 >> bitcast<u32>(((_e858 * 8u) & 31u))) & 255u)) * _e617) + (_e635 - _e427)), ((f32(((_e870 >> bitcast<u32>(((_e858 * 8u) & 31u))) & 255u)) * _e618) + (_e636 - _e428)));
                                    let _e893 = core_intrinsics_maximum_number_nsz_f32_(_e892, ((f32(((_e879 >> bitcast<u32>(((_e858 * 8u) & 31u))) & 255u)) * _e619) + (_e637 - _e429)));
                                    if (_e857 == 0u) {
                                        phi_1421_ = _e704.unnamed_1.root;
                                    } else {
                                        phi_1421_ = _e704.unnamed_1.first_primitive;
                                    }
                                    let _e896 = phi_1421_;
                                    if (_e857 == 0u) {
                                        phi_1431_ = _e773.unnamed_1.root;
                                    } else {
                                        phi_1431_ = _e773.unnamed_1.first_primitive;
                                    }
                                    let _e905 = phi_1431_;
                                    if (_e857 == 0u) {
                                        phi_1441_ = _e842.unnamed_1.root;
                                    } else {
                                        phi_1441_ = _e842.unnamed_1.first_primitive;
                                    }
                                    let _e914 = phi_1441_;
                                    let _e927 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e896 >> bitcast<u32>(((_e858 * 8u) & 31u))) & 255u)) * _e617) + (_e635 + _e427)), ((f32(((_e905 >> bitcast<u32>(((_e858 * 8u) & 31u))) & 255u)) * _e618) + (_e636 + _e428)));
                                    let _e928 = core_intrinsics_minimum_number_nsz_f32_(_e927, ((f32(((_e914 >> bitcast<u32>(((_e858 * 8u) & 31u))) & 255u)) * _e619) + (_e637 + _e429)));
                                    if (_e893 <= _e928) {
                                        if (_e893 <= _e231) {
                                            if (_e928 >= 0f) {
                                                if (_e857 == 0u) {
                                                    let _e935 = nodes.member[(0u + _e585)].links[2u];
                                                    phi_1477_ = _e935;
                                                } else {
                                                    let _e938 = nodes.member[(0u + _e585)].links[3u];
                                                    phi_1477_ = _e938;
                                                }
                                                let _e940 = phi_1477_;
                                                let _e945 = ((_e940 >> bitcast<u32>(((_e858 * 8u) & 31u))) & 255u);
                                                let _e946 = (_e945 & 31u);
                                                if (_e946 >= 24u) {
                                                    phi_1490_ = (24u + ((_e946 - 24u) ^ _e447));
                                                } else {
                                                    phi_1490_ = _e946;
                                                }
                                                let _e952 = phi_1490_;
                                                phi_1495_ = (_e854 | ((_e945 >> bitcast<u32>(5i)) << bitcast<u32>((_e952 & 31u))));
                                            } else {
                                                phi_1495_ = _e854;
                                            }
                                            let _e960 = phi_1495_;
                                            phi_1496_ = _e960;
                                        } else {
                                            phi_1496_ = _e854;
                                        }
                                        let _e962 = phi_1496_;
                                        phi_1497_ = _e962;
                                    } else {
                                        phi_1497_ = _e854;
                                    }
                                    let _e964 = phi_1497_;
                                    phi_1367_ = (_e852 + 1u);
                                    phi_1370_ = _e964;
                                } else {
                                    phi_1367_ = u32();
                                    phi_1370_ = u32();
                                }
                                let _e967 = phi_1367_;
                                let _e969 = phi_1370_;
                                continue;
                                continuing {
                                    phi_1366_ = _e967;
                                    phi_1369_ = _e969;
                                    break if !(_e855);
                                }
                            }
                            let _e973 = nodes.member[(0u + _e585)].links[0u];
                            let _e977 = nodes.member[(0u + _e585)].frame[3u];
                            let _e981 = local_4;
                            if ((_e981 & 4278190080u) == 0u) {
                            } else {
                                let _e985 = local_2.group_mask;
                                if ((_e985 & 4278190080u) == 0u) {
                                } else {
                                    let _e989 = local_2.len;
                                    if (_e989 < 32u) {
                                        let _e992 = local_2.group;
                                        let _e994 = local_2.len;
                                        if (_e994 < 32u) {
                                        } else {
                                            return;
                                        }
                                        local_2.first[(0u + _e994)] = _e992;
                                        let _e1000 = local_2.group_mask;
                                        let _e1002 = local_2.len;
                                        if (_e1002 < 32u) {
                                        } else {
                                            return;
                                        }
                                        local_2.mask[(0u + _e1002)] = _e1000;
                                        let _e1009 = local_2.len;
                                        local_2.len = (_e1009 + 1u);
                                    }
                                }
                                local_2.group = (_e205 + _e973);
                                let _e1013 = local_5;
                                local_2.group_mask = ((_e1013 & 4278190080u) | (_e977 >> bitcast<u32>(24i)));
                            }
                            let _e1018 = local_6;
                            phi_1555_ = (_e1018 & 16777215u);
                            loop {
                                let _e1021 = phi_1555_;
                                let _e1022 = (_e1021 == 0u);
                                local_12 = _e1022;
                                local_19 = _e1022;
                                if _e1022 {
                                    phi_1556_ = u32();
                                    phi_3413_ = false;
                                } else {
                                    let _e1025 = nodes.member[(0u + _e585)].links[1u];
                                    let _e1029 = (_e1025 + select(firstTrailingBit(_e1021), 32u, (_e1021 == 0u)));
                                    if (_e1029 < arrayLength((&instances.member))) {
                                    } else {
                                        return;
                                    }
                                    let _e1036 = instances.member[(0u + _e1029)].low_world;
                                    let _e1038 = instances.member[(0u + _e1029)].high_world;
                                    let _e1045 = ((_e1036.x - _e223) * _e379);
                                    let _e1046 = ((_e1036.y - _e225) * _e389);
                                    let _e1047 = ((_e1036.z - _e227) * _e399);
                                    let _e1054 = ((_e1038.x - _e223) * _e379);
                                    let _e1055 = ((_e1038.y - _e225) * _e389);
                                    let _e1056 = ((_e1038.z - _e227) * _e399);
                                    if (_e1045 < _e1054) {
                                        phi_1605_ = _e1045;
                                    } else {
                                        phi_1605_ = _e1054;
                                    }
                                    let _e1059 = phi_1605_;
                                    if (_e1046 < _e1055) {
                                        phi_1610_ = _e1046;
                                    } else {
                                        phi_1610_ = _e1055;
                                    }
                                    let _e1062 = phi_1610_;
                                    if (_e1047 < _e1056) {
                                        phi_1615_ = _e1047;
                                    } else {
                                        phi_1615_ = _e1056;
                                    }
                                    let _e1065 = phi_1615_;
                                    if (_e1045 > _e1054) {
                                        phi_1623_ = _e1045;
                                    } else {
                                        phi_1623_ = _e1054;
                                    }
                                    let _e1071 = phi_1623_;
                                    if (_e1046 > _e1055) {
                                        phi_1628_ = _e1046;
                                    } else {
                                        phi_1628_ = _e1055;
                                    }
                                    let _e1074 = phi_1628_;
                                    if (_e1047 > _e1056) {
                                        phi_1633_ = _e1047;
                                    } else {
                                        phi_1633_ = _e1056;
                                    }
                                    let _e1077 = phi_1633_;
                                    let _e1081 = core_intrinsics_maximum_number_nsz_f32_((_e1059 - _e434), (_e1062 - _e435));
                                    let _e1082 = core_intrinsics_maximum_number_nsz_f32_(_e1081, (_e1065 - _e436));
                                    let _e1083 = core_intrinsics_minimum_number_nsz_f32_((_e1071 + _e434), (_e1074 + _e435));
                                    let _e1084 = core_intrinsics_minimum_number_nsz_f32_(_e1083, (_e1077 + _e436));
                                    if (_e1082 <= _e1084) {
                                        if (_e1082 <= _e231) {
                                            if (_e1084 >= 0f) {
                                                let _e1090 = instances.member[(0u + _e1029)].world_to_object[0u];
                                                let _e1101 = ((((_e1090.x * _e223) + (_e1090.y * _e225)) + (_e1090.z * _e227)) + (_e1090.w * 1f));
                                                let _e1103 = instances.member[(0u + _e1029)].world_to_object[1u];
                                                let _e1114 = ((((_e1103.x * _e223) + (_e1103.y * _e225)) + (_e1103.z * _e227)) + (_e1103.w * 1f));
                                                let _e1116 = instances.member[(0u + _e1029)].world_to_object[2u];
                                                let _e1127 = ((((_e1116.x * _e223) + (_e1116.y * _e225)) + (_e1116.z * _e227)) + (_e1116.w * 1f));
                                                let _e1130 = instances.member[(0u + _e1029)].world_to_object[0u];
                                                let _e1141 = ((((_e1130.x * _e239) + (_e1130.y * _e240)) + (_e1130.z * _e241)) + (_e1130.w * 0f));
                                                let _e1143 = instances.member[(0u + _e1029)].world_to_object[1u];
                                                let _e1154 = ((((_e1143.x * _e239) + (_e1143.y * _e240)) + (_e1143.z * _e241)) + (_e1143.w * 0f));
                                                let _e1156 = instances.member[(0u + _e1029)].world_to_object[2u];
                                                let _e1167 = ((((_e1156.x * _e239) + (_e1156.y * _e240)) + (_e1156.z * _e241)) + (_e1156.w * 0f));
                                                let _e1170 = instances.member[(0u + _e1029)].root;
                                                let _e1172 = instances.member[(0u + _e1029)].first_triangle;
                                                let _e1176 = abs(_e1141);
                                                let _e1177 = abs(_e1154);
                                                let _e1178 = abs(_e1167);
                                                if (abs(_e1101) < 1000000000000000f) {
                                                    if (abs(_e1114) < 1000000000000000f) {
                                                        if (abs(_e1127) < 1000000000000000f) {
                                                            if (_e1176 < 1000000000000000f) {
                                                                if (_e1177 < 1000000000000000f) {
                                                                    if (_e1178 < 1000000000000000f) {
                                                                        if (_e1176 > 0f) {
                                                                            phi_1778_ = bool();
                                                                            phi_1779_ = true;
                                                                        } else {
                                                                            let _e1186 = (_e1177 > 0f);
                                                                            if _e1186 {
                                                                                phi_1777_ = bool();
                                                                            } else {
                                                                                phi_1777_ = (_e1178 > 0f);
                                                                            }
                                                                            let _e1189 = phi_1777_;
                                                                            phi_1778_ = _e1189;
                                                                            phi_1779_ = _e1186;
                                                                        }
                                                                        let _e1191 = phi_1778_;
                                                                        let _e1193 = phi_1779_;
                                                                        if _e1193 {
                                                                            phi_1783_ = true;
                                                                        } else {
                                                                            phi_1783_ = _e1191;
                                                                        }
                                                                        let _e1195 = phi_1783_;
                                                                        phi_1784_ = _e1195;
                                                                        phi_1785_ = false;
                                                                    } else {
                                                                        phi_1784_ = bool();
                                                                        phi_1785_ = true;
                                                                    }
                                                                    let _e1197 = phi_1784_;
                                                                    let _e1199 = phi_1785_;
                                                                    phi_1786_ = _e1197;
                                                                    phi_1787_ = false;
                                                                    phi_1788_ = _e1199;
                                                                } else {
                                                                    phi_1786_ = bool();
                                                                    phi_1787_ = true;
                                                                    phi_1788_ = false;
                                                                }
                                                                let _e1201 = phi_1786_;
                                                                let _e1203 = phi_1787_;
                                                                let _e1205 = phi_1788_;
                                                                phi_1789_ = _e1201;
                                                                phi_1790_ = _e1203;
                                                                phi_1791_ = _e1205;
                                                            } else {
                                                                phi_1789_ = bool();
                                                                phi_1790_ = true;
                                                                phi_1791_ = false;
                                                            }
                                                            let _e1207 = phi_1789_;
                                                            let _e1209 = phi_1790_;
                                                            let _e1211 = phi_1791_;
                                                            phi_1792_ = _e1207;
                                                            phi_1793_ = _e1209;
                                                            phi_1794_ = _e1211;
                                                        } else {
                                                            phi_1792_ = bool();
                                                            phi_1793_ = true;
                                                            phi_1794_ = false;
                                                        }
                                                        let _e1213 = phi_1792_;
                                                        let _e1215 = phi_1793_;
                                                        let _e1217 = phi_1794_;
                                                        phi_1795_ = _e1213;
                                                        phi_1796_ = _e1215;
                                                        phi_1797_ = _e1217;
                                                    } else {
                                                        phi_1795_ = bool();
                                                        phi_1796_ = true;
                                                        phi_1797_ = false;
                                                    }
                                                    let _e1219 = phi_1795_;
                                                    let _e1221 = phi_1796_;
                                                    let _e1223 = phi_1797_;
                                                    phi_1798_ = _e1219;
                                                    phi_1799_ = _e1221;
                                                    phi_1800_ = _e1223;
                                                } else {
                                                    phi_1798_ = bool();
                                                    phi_1799_ = true;
                                                    phi_1800_ = false;
                                                }
                                                let _e1225 = phi_1798_;
                                                let _e1227 = phi_1799_;
                                                let _e1229 = phi_1800_;
                                                if _e1227 {
                                                    phi_1804_ = true;
                                                } else {
                                                    phi_1804_ = _e1229;
                                                }
                                                let _e1231 = phi_1804_;
                                                if _e1231 {
                                                    phi_1808_ = false;
                                                } else {
                                                    phi_1808_ = _e1225;
                                                }
                                                let _e1233 = phi_1808_;
                                                if _e1233 {
                                                    let _e1234 = (_e1170 >= _e79);
                                                    if _e1234 {
                                                        phi_3396_ = bool();
                                                    } else {
                                                        if (_e1170 < _e79) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1240 = nodes.member[(0u + _e1170)].frame[0u];
                                                        let _e1244 = nodes.member[(0u + _e1170)].frame[1u];
                                                        let _e1248 = nodes.member[(0u + _e1170)].frame[2u];
                                                        let _e1252 = nodes.member[(0u + _e1170)].frame[0u];
                                                        let _e1256 = nodes.member[(0u + _e1170)].frame[1u];
                                                        let _e1260 = nodes.member[(0u + _e1170)].frame[2u];
                                                        let _e1264 = nodes.member[(0u + _e1170)].frame[3u];
                                                        let _e1298 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1141), abs(_e1154));
                                                        let _e1299 = core_intrinsics_maximum_number_nsz_f32_(_e1298, abs(_e1167));
                                                        let _e1300 = (_e1299 * 0.0000000000009094947f);
                                                        if (abs(_e1141) < _e1300) {
                                                            phi_1878_ = _e1300;
                                                        } else {
                                                            phi_1878_ = abs(_e1141);
                                                        }
                                                        let _e1305 = phi_1878_;
                                                        if (_e1141 < 0f) {
                                                            phi_1885_ = (-1f / _e1305);
                                                        } else {
                                                            phi_1885_ = (1f / _e1305);
                                                        }
                                                        let _e1310 = phi_1885_;
                                                        if (abs(_e1154) < _e1300) {
                                                            phi_1892_ = _e1300;
                                                        } else {
                                                            phi_1892_ = abs(_e1154);
                                                        }
                                                        let _e1315 = phi_1892_;
                                                        if (_e1154 < 0f) {
                                                            phi_1899_ = (-1f / _e1315);
                                                        } else {
                                                            phi_1899_ = (1f / _e1315);
                                                        }
                                                        let _e1320 = phi_1899_;
                                                        if (abs(_e1167) < _e1300) {
                                                            phi_1906_ = _e1300;
                                                        } else {
                                                            phi_1906_ = abs(_e1167);
                                                        }
                                                        let _e1325 = phi_1906_;
                                                        if (_e1167 < 0f) {
                                                            phi_1913_ = (-1f / _e1325);
                                                        } else {
                                                            phi_1913_ = (1f / _e1325);
                                                        }
                                                        let _e1330 = phi_1913_;
                                                        let _e1334 = abs((bitcast<f32>(_e1240) - _e1101));
                                                        let _e1335 = abs((bitcast<f32>(_e1244) - _e1114));
                                                        let _e1336 = abs((bitcast<f32>(_e1248) - _e1127));
                                                        let _e1340 = abs(((bitcast<f32>(_e1252) + (bitcast<f32>((((_e1264 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1101));
                                                        let _e1341 = abs(((bitcast<f32>(_e1256) + (bitcast<f32>((((_e1264 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1114));
                                                        let _e1342 = abs(((bitcast<f32>(_e1260) + (bitcast<f32>((((_e1264 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1127));
                                                        if (_e1334 > _e1340) {
                                                            phi_1930_ = _e1334;
                                                        } else {
                                                            phi_1930_ = _e1340;
                                                        }
                                                        let _e1345 = phi_1930_;
                                                        if (_e1335 > _e1341) {
                                                            phi_1935_ = _e1335;
                                                        } else {
                                                            phi_1935_ = _e1341;
                                                        }
                                                        let _e1348 = phi_1935_;
                                                        if (_e1336 > _e1342) {
                                                            phi_1940_ = _e1336;
                                                        } else {
                                                            phi_1940_ = _e1342;
                                                        }
                                                        let _e1351 = phi_1940_;
                                                        let _e1352 = core_intrinsics_maximum_number_nsz_f32_(_e1345, _e1348);
                                                        let _e1353 = core_intrinsics_maximum_number_nsz_f32_(_e1352, _e1351);
                                                        let _e1357 = (_e1353 * 0.0000019073486f);
                                                        let _e1358 = (abs(_e1310) * _e1357);
                                                        let _e1359 = (abs(_e1320) * _e1357);
                                                        let _e1360 = (abs(_e1330) * _e1357);
                                                        let _e1364 = (_e1353 * 0.0000009536743f);
                                                        let _e1365 = (abs(_e1310) * _e1364);
                                                        let _e1366 = (abs(_e1320) * _e1364);
                                                        let _e1367 = (abs(_e1330) * _e1364);
                                                        let _e1368 = abs(_e1141);
                                                        let _e1369 = abs(_e1154);
                                                        let _e1370 = abs(_e1167);
                                                        if (_e1368 >= _e1369) {
                                                            if (_e1368 >= _e1370) {
                                                                phi_1968_ = false;
                                                            } else {
                                                                phi_1968_ = true;
                                                            }
                                                            let _e1374 = phi_1968_;
                                                            phi_1969_ = _e1374;
                                                        } else {
                                                            phi_1969_ = true;
                                                        }
                                                        let _e1376 = phi_1969_;
                                                        if _e1376 {
                                                            if (_e1369 >= _e1370) {
                                                                phi_1977_ = 1u;
                                                            } else {
                                                                phi_1977_ = 2u;
                                                            }
                                                            let _e1379 = phi_1977_;
                                                            phi_1978_ = _e1379;
                                                        } else {
                                                            phi_1978_ = 0u;
                                                        }
                                                        let _e1381 = phi_1978_;
                                                        if (_e1381 == 0u) {
                                                            phi_1990_ = vec3<f32>(_e1154, _e1167, _e1141);
                                                        } else {
                                                            if (_e1381 == 1u) {
                                                                phi_1989_ = vec3<f32>(_e1167, _e1141, _e1154);
                                                            } else {
                                                                phi_1989_ = vec3<f32>(_e1141, _e1154, _e1167);
                                                            }
                                                            let _e1387 = phi_1989_;
                                                            phi_1990_ = _e1387;
                                                        }
                                                        let _e1389 = phi_1990_;
                                                        let _e1392 = (_e1389.x / _e1389.z);
                                                        let _e1395 = (_e1389.y / _e1389.z);
                                                        if (_e1310 < 0f) {
                                                            phi_2003_ = 0u;
                                                        } else {
                                                            phi_2003_ = 1u;
                                                        }
                                                        let _e1400 = phi_2003_;
                                                        if (_e1320 < 0f) {
                                                            phi_2008_ = 0u;
                                                        } else {
                                                            phi_2008_ = 2u;
                                                        }
                                                        let _e1403 = phi_2008_;
                                                        if (_e1330 < 0f) {
                                                            phi_2013_ = 0u;
                                                        } else {
                                                            phi_2013_ = 4u;
                                                        }
                                                        let _e1406 = phi_2013_;
                                                        let _e1408 = ((_e1400 | _e1403) | _e1406);
                                                        let _e1409 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1170, 2147483648u);
                                                        local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e1409.first[0], _e1409.first[1], _e1409.first[2], _e1409.first[3], _e1409.first[4], _e1409.first[5], _e1409.first[6], _e1409.first[7], _e1409.first[8], _e1409.first[9], _e1409.first[10], _e1409.first[11], _e1409.first[12], _e1409.first[13], _e1409.first[14], _e1409.first[15], _e1409.first[16], _e1409.first[17], _e1409.first[18], _e1409.first[19], _e1409.first[20], _e1409.first[21], _e1409.first[22], _e1409.first[23], _e1409.first[24], _e1409.first[25], _e1409.first[26], _e1409.first[27], _e1409.first[28], _e1409.first[29], _e1409.first[30], _e1409.first[31]), array<u32, 32>(_e1409.mask[0], _e1409.mask[1], _e1409.mask[2], _e1409.mask[3], _e1409.mask[4], _e1409.mask[5], _e1409.mask[6], _e1409.mask[7], _e1409.mask[8], _e1409.mask[9], _e1409.mask[10], _e1409.mask[11], _e1409.mask[12], _e1409.mask[13], _e1409.mask[14], _e1409.mask[15], _e1409.mask[16], _e1409.mask[17], _e1409.mask[18], _e1409.mask[19], _e1409.mask[20], _e1409.mask[21], _e1409.mask[22], _e1409.mask[23], _e1409.mask[24], _e1409.mask[25], _e1409.mask[26], _e1409.mask[27], _e1409.mask[28], _e1409.mask[29], _e1409.mask[30], _e1409.mask[31]), _e1409.len, _e1409.group, _e1409.group_mask);
                                                        let _e1483 = local_1.group_mask;
                                                        if ((_e1483 & 4278190080u) == 0u) {
                                                            let _e1487 = local_1.len;
                                                            if (_e1487 == 0u) {
                                                                phi_2127_ = false;
                                                            } else {
                                                                let _e1491 = local_1.len;
                                                                local_1.len = (_e1491 - 1u);
                                                                let _e1494 = local_1.len;
                                                                if (_e1494 < 32u) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1499 = local_1.first[(0u + _e1494)];
                                                                local_1.group = _e1499;
                                                                let _e1502 = local_1.len;
                                                                if (_e1502 < 32u) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1507 = local_1.mask[(0u + _e1502)];
                                                                local_1.group_mask = _e1507;
                                                                phi_2127_ = true;
                                                            }
                                                            let _e1510 = phi_2127_;
                                                            phi_2128_ = _e1510;
                                                        } else {
                                                            phi_2128_ = true;
                                                        }
                                                        let _e1512 = phi_2128_;
                                                        if _e1512 {
                                                            let _e1514 = local_1.group_mask;
                                                            let _e1520 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1514)), 32u, (_e1514 == 0u)));
                                                            let _e1524 = local_1.group_mask;
                                                            let _e1538 = local_1.group_mask;
                                                            local_1.group_mask = (_e1538 & ~((1u << bitcast<u32>((_e1520 & 31u)))));
                                                            let _e1541 = local_1.group;
                                                            phi_2159_ = (_e1541 + countOneBits(((_e1524 & ~((4294967295u << bitcast<u32>((((_e1520 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                        } else {
                                                            phi_2159_ = 4294967295u;
                                                        }
                                                        let _e1544 = phi_2159_;
                                                        phi_2161_ = _e1544;
                                                        loop {
                                                            let _e1546 = phi_2161_;
                                                            if (_e1546 != 4294967295u) {
                                                                if (_e1546 < _e79) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1553 = nodes.member[(0u + _e1546)].frame[3u];
                                                                let _e1578 = (bitcast<f32>((((_e1553 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1310);
                                                                let _e1579 = (bitcast<f32>((((_e1553 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1320);
                                                                let _e1580 = (bitcast<f32>((((_e1553 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1330);
                                                                let _e1583 = nodes.member[(0u + _e1546)].frame[0u];
                                                                let _e1587 = nodes.member[(0u + _e1546)].frame[1u];
                                                                let _e1591 = nodes.member[(0u + _e1546)].frame[2u];
                                                                let _e1596 = ((bitcast<f32>(_e1583) - _e1101) * _e1310);
                                                                let _e1597 = ((bitcast<f32>(_e1587) - _e1114) * _e1320);
                                                                let _e1598 = ((bitcast<f32>(_e1591) - _e1127) * _e1330);
                                                                let _e1606 = nodes.member[(0u + _e1546)].x;
                                                                if (_e1310 < 0f) {
                                                                    let _e1617 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1606.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1623 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1617.unnamed.root, _e1606.w), _e1617.unnamed_1);
                                                                    let _e1629 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1623.unnamed, lt_bvh_traverse_Tree(_e1606.x, _e1623.unnamed_1.first_primitive));
                                                                    phi_2242_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1629.unnamed, lt_bvh_traverse_Tree(_e1629.unnamed_1.root, _e1606.y));
                                                                } else {
                                                                    let _e1645 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1606.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1651 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1645.unnamed.root, _e1606.y), _e1645.unnamed_1);
                                                                    let _e1657 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1651.unnamed, lt_bvh_traverse_Tree(_e1606.z, _e1651.unnamed_1.first_primitive));
                                                                    phi_2242_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1657.unnamed, lt_bvh_traverse_Tree(_e1657.unnamed_1.root, _e1606.w));
                                                                }
                                                                let _e1665 = phi_2242_;
                                                                let _e1675 = nodes.member[(0u + _e1546)].y;
                                                                if (_e1320 < 0f) {
                                                                    let _e1686 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1675.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1692 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1686.unnamed.root, _e1675.w), _e1686.unnamed_1);
                                                                    let _e1698 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1692.unnamed, lt_bvh_traverse_Tree(_e1675.x, _e1692.unnamed_1.first_primitive));
                                                                    phi_2269_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1698.unnamed, lt_bvh_traverse_Tree(_e1698.unnamed_1.root, _e1675.y));
                                                                } else {
                                                                    let _e1714 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1675.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1720 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1714.unnamed.root, _e1675.y), _e1714.unnamed_1);
                                                                    let _e1726 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1720.unnamed, lt_bvh_traverse_Tree(_e1675.z, _e1720.unnamed_1.first_primitive));
                                                                    phi_2269_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1726.unnamed, lt_bvh_traverse_Tree(_e1726.unnamed_1.root, _e1675.w));
                                                                }
                                                                let _e1734 = phi_2269_;
                                                                let _e1744 = nodes.member[(0u + _e1546)].z;
                                                                if (_e1330 < 0f) {
                                                                    let _e1755 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1744.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1761 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1755.unnamed.root, _e1744.w), _e1755.unnamed_1);
                                                                    let _e1767 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1761.unnamed, lt_bvh_traverse_Tree(_e1744.x, _e1761.unnamed_1.first_primitive));
                                                                    phi_2296_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1767.unnamed, lt_bvh_traverse_Tree(_e1767.unnamed_1.root, _e1744.y));
                                                                } else {
                                                                    let _e1783 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1744.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1789 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1783.unnamed.root, _e1744.y), _e1783.unnamed_1);
                                                                    let _e1795 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1789.unnamed, lt_bvh_traverse_Tree(_e1744.z, _e1789.unnamed_1.first_primitive));
                                                                    phi_2296_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1795.unnamed, lt_bvh_traverse_Tree(_e1795.unnamed_1.root, _e1744.w));
                                                                }
                                                                let _e1803 = phi_2296_;
                                                                phi_2302_ = 0u;
                                                                phi_2305_ = 0u;
                                                                loop {
                                                                    let _e1813 = phi_2302_;
                                                                    let _e1815 = phi_2305_;
                                                                    local_7 = _e1815;
                                                                    local_8 = _e1815;
                                                                    local_9 = _e1815;
                                                                    let _e1816 = (_e1813 < 8u);
                                                                    if _e1816 {
                                                                        let _e1818 = (_e1813 >> bitcast<u32>(2i));
                                                                        let _e1819 = (_e1813 & 3u);
                                                                        if (_e1818 == 0u) {
                                                                            phi_2319_ = _e1665.unnamed.root;
                                                                        } else {
                                                                            phi_2319_ = _e1665.unnamed.first_primitive;
                                                                        }
                                                                        let _e1822 = phi_2319_;
                                                                        if (_e1818 == 0u) {
                                                                            phi_2329_ = _e1734.unnamed.root;
                                                                        } else {
                                                                            phi_2329_ = _e1734.unnamed.first_primitive;
                                                                        }
                                                                        let _e1831 = phi_2329_;
                                                                        if (_e1818 == 0u) {
                                                                            phi_2339_ = _e1803.unnamed.root;
                                                                        } else {
                                                                            phi_2339_ = _e1803.unnamed.first_primitive;
                                                                        }
                                                                        let _e1840 = phi_2339_;
                                                                        let _e1853 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1822 >> bitcast<u32>(((_e1819 * 8u) & 31u))) & 255u)) * _e1578) + (_e1596 - _e1358)), ((f32(((_e1831 >> bitcast<u32>(((_e1819 * 8u) & 31u))) & 255u)) * _e1579) + (_e1597 - _e1359)));
                                                                        let _e1854 = core_intrinsics_maximum_number_nsz_f32_(_e1853, ((f32(((_e1840 >> bitcast<u32>(((_e1819 * 8u) & 31u))) & 255u)) * _e1580) + (_e1598 - _e1360)));
                                                                        if (_e1818 == 0u) {
                                                                            phi_2357_ = _e1665.unnamed_1.root;
                                                                        } else {
                                                                            phi_2357_ = _e1665.unnamed_1.first_primitive;
                                                                        }
                                                                        let _e1857 = phi_2357_;
                                                                        if (_e1818 == 0u) {
                                                                            phi_2367_ = _e1734.unnamed_1.root;
                                                                        } else {
                                                                            phi_2367_ = _e1734.unnamed_1.first_primitive;
                                                                        }
                                                                        let _e1866 = phi_2367_;
                                                                        if (_e1818 == 0u) {
                                                                            phi_2377_ = _e1803.unnamed_1.root;
                                                                        } else {
                                                                            phi_2377_ = _e1803.unnamed_1.first_primitive;
                                                                        }
                                                                        let _e1875 = phi_2377_;
                                                                        let _e1888 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1857 >> bitcast<u32>(((_e1819 * 8u) & 31u))) & 255u)) * _e1578) + (_e1596 + _e1358)), ((f32(((_e1866 >> bitcast<u32>(((_e1819 * 8u) & 31u))) & 255u)) * _e1579) + (_e1597 + _e1359)));
                                                                        let _e1889 = core_intrinsics_minimum_number_nsz_f32_(_e1888, ((f32(((_e1875 >> bitcast<u32>(((_e1819 * 8u) & 31u))) & 255u)) * _e1580) + (_e1598 + _e1360)));
                                                                        if (_e1854 <= _e1889) {
                                                                            if (_e1854 <= _e231) {
                                                                                if (_e1889 >= 0f) {
                                                                                    if (_e1818 == 0u) {
                                                                                        let _e1896 = nodes.member[(0u + _e1546)].links[2u];
                                                                                        phi_2413_ = _e1896;
                                                                                    } else {
                                                                                        let _e1899 = nodes.member[(0u + _e1546)].links[3u];
                                                                                        phi_2413_ = _e1899;
                                                                                    }
                                                                                    let _e1901 = phi_2413_;
                                                                                    let _e1906 = ((_e1901 >> bitcast<u32>(((_e1819 * 8u) & 31u))) & 255u);
                                                                                    let _e1907 = (_e1906 & 31u);
                                                                                    if (_e1907 >= 24u) {
                                                                                        phi_2426_ = (24u + ((_e1907 - 24u) ^ _e1408));
                                                                                    } else {
                                                                                        phi_2426_ = _e1907;
                                                                                    }
                                                                                    let _e1913 = phi_2426_;
                                                                                    phi_2431_ = (_e1815 | ((_e1906 >> bitcast<u32>(5i)) << bitcast<u32>((_e1913 & 31u))));
                                                                                } else {
                                                                                    phi_2431_ = _e1815;
                                                                                }
                                                                                let _e1921 = phi_2431_;
                                                                                phi_2432_ = _e1921;
                                                                            } else {
                                                                                phi_2432_ = _e1815;
                                                                            }
                                                                            let _e1923 = phi_2432_;
                                                                            phi_2433_ = _e1923;
                                                                        } else {
                                                                            phi_2433_ = _e1815;
                                                                        }
                                                                        let _e1925 = phi_2433_;
                                                                        phi_2303_ = (_e1813 + 1u);
                                                                        phi_2306_ = _e1925;
                                                                    } else {
                                                                        phi_2303_ = u32();
                                                                        phi_2306_ = u32();
                                                                    }
                                                                    let _e1928 = phi_2303_;
                                                                    let _e1930 = phi_2306_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_2302_ = _e1928;
                                                                        phi_2305_ = _e1930;
                                                                        break if !(_e1816);
                                                                    }
                                                                }
                                                                let _e1934 = nodes.member[(0u + _e1546)].links[0u];
                                                                let _e1938 = nodes.member[(0u + _e1546)].frame[3u];
                                                                let _e1942 = local_7;
                                                                if ((_e1942 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1946 = local_1.group_mask;
                                                                    if ((_e1946 & 4278190080u) == 0u) {
                                                                    } else {
                                                                        let _e1950 = local_1.len;
                                                                        if (_e1950 < 32u) {
                                                                            let _e1953 = local_1.group;
                                                                            let _e1955 = local_1.len;
                                                                            if (_e1955 < 32u) {
                                                                            } else {
                                                                                return;
                                                                            }
                                                                            local_1.first[(0u + _e1955)] = _e1953;
                                                                            let _e1961 = local_1.group_mask;
                                                                            let _e1963 = local_1.len;
                                                                            if (_e1963 < 32u) {
                                                                            } else {
                                                                                return;
                                                                            }
                                                                            local_1.mask[(0u + _e1963)] = _e1961;
                                                                            let _e1970 = local_1.len;
                                                                            local_1.len = (_e1970 + 1u);
                                                                        }
                                                                    }
                                                                    local_1.group = (_e1170 + _e1934);
                                                                    let _e1974 = local_8;
                                                                    local_1.group_mask = ((_e1974 & 4278190080u) | (_e1938 >> bitcast<u32>(24i)));
                                                                }
                                                                let _e1979 = local_9;
                                                                phi_2491_ = (_e1979 & 16777215u);
                                                                loop {
                                                                    let _e1982 = phi_2491_;
                                                                    let _e1983 = (_e1982 == 0u);
                                                                    local_10 = _e1983;
                                                                    local_16 = _e1983;
                                                                    if _e1983 {
                                                                        phi_2492_ = u32();
                                                                        phi_3299_ = false;
                                                                        phi_3300_ = false;
                                                                        phi_3301_ = false;
                                                                    } else {
                                                                        let _e1986 = nodes.member[(0u + _e1546)].links[1u];
                                                                        let _e1991 = ((_e1172 + _e1986) + select(firstTrailingBit(_e1982), 32u, (_e1982 == 0u)));
                                                                        if (_e1991 < _e82) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e1998 = triangles.member[(0u + _e1991)].v0_;
                                                                        let _e2000 = (_e1998.x - _e1101);
                                                                        let _e2002 = (_e1998.y - _e1114);
                                                                        let _e2004 = (_e1998.z - _e1127);
                                                                        if (_e1381 == 0u) {
                                                                            phi_2537_ = vec3<f32>(_e2002, _e2004, _e2000);
                                                                        } else {
                                                                            if (_e1381 == 1u) {
                                                                                phi_2536_ = vec3<f32>(_e2004, _e2000, _e2002);
                                                                            } else {
                                                                                phi_2536_ = (_e1998 - vec3<f32>(_e1101, _e1114, _e1127));
                                                                            }
                                                                            let _e2012 = phi_2536_;
                                                                            phi_2537_ = _e2012;
                                                                        }
                                                                        let _e2014 = phi_2537_;
                                                                        let _e2018 = (_e2014.x - (_e1392 * _e2014.z));
                                                                        let _e2022 = (_e2014.y - (_e1395 * _e2014.z));
                                                                        let _e2024 = triangles.member[(0u + _e1991)].v1_;
                                                                        let _e2026 = (_e2024.x - _e1101);
                                                                        let _e2028 = (_e2024.y - _e1114);
                                                                        let _e2030 = (_e2024.z - _e1127);
                                                                        if (_e1381 == 0u) {
                                                                            phi_2567_ = vec3<f32>(_e2028, _e2030, _e2026);
                                                                        } else {
                                                                            if (_e1381 == 1u) {
                                                                                phi_2566_ = vec3<f32>(_e2030, _e2026, _e2028);
                                                                            } else {
                                                                                phi_2566_ = (_e2024 - vec3<f32>(_e1101, _e1114, _e1127));
                                                                            }
                                                                            let _e2038 = phi_2566_;
                                                                            phi_2567_ = _e2038;
                                                                        }
                                                                        let _e2040 = phi_2567_;
                                                                        let _e2044 = (_e2040.x - (_e1392 * _e2040.z));
                                                                        let _e2048 = (_e2040.y - (_e1395 * _e2040.z));
                                                                        let _e2050 = triangles.member[(0u + _e1991)].v2_;
                                                                        let _e2052 = (_e2050.x - _e1101);
                                                                        let _e2054 = (_e2050.y - _e1114);
                                                                        let _e2056 = (_e2050.z - _e1127);
                                                                        if (_e1381 == 0u) {
                                                                            phi_2597_ = vec3<f32>(_e2054, _e2056, _e2052);
                                                                        } else {
                                                                            if (_e1381 == 1u) {
                                                                                phi_2596_ = vec3<f32>(_e2056, _e2052, _e2054);
                                                                            } else {
                                                                                phi_2596_ = (_e2050 - vec3<f32>(_e1101, _e1114, _e1127));
                                                                            }
                                                                            let _e2064 = phi_2596_;
                                                                            phi_2597_ = _e2064;
                                                                        }
                                                                        let _e2066 = phi_2597_;
                                                                        let _e2070 = (_e2066.x - (_e1392 * _e2066.z));
                                                                        let _e2074 = (_e2066.y - (_e1395 * _e2066.z));
                                                                        if (_e2044 < _e2070) {
                                                                            phi_2616_ = true;
                                                                        } else {
                                                                            if (_e2044 == _e2070) {
                                                                                phi_2615_ = (_e2048 < _e2074);
                                                                            } else {
                                                                                phi_2615_ = false;
                                                                            }
                                                                            let _e2079 = phi_2615_;
                                                                            phi_2616_ = _e2079;
                                                                        }
                                                                        let _e2081 = phi_2616_;
                                                                        if _e2081 {
                                                                            phi_2620_ = _e2074;
                                                                            phi_2621_ = _e2070;
                                                                            phi_2622_ = _e2048;
                                                                            phi_2623_ = _e2044;
                                                                        } else {
                                                                            phi_2620_ = _e2048;
                                                                            phi_2621_ = _e2044;
                                                                            phi_2622_ = _e2074;
                                                                            phi_2623_ = _e2070;
                                                                        }
                                                                        let _e2083 = phi_2620_;
                                                                        let _e2085 = phi_2621_;
                                                                        let _e2087 = phi_2622_;
                                                                        let _e2089 = phi_2623_;
                                                                        let _e2092 = ((_e2089 * _e2083) - (_e2087 * _e2085));
                                                                        if _e2081 {
                                                                            phi_2631_ = -(_e2092);
                                                                        } else {
                                                                            phi_2631_ = _e2092;
                                                                        }
                                                                        let _e2095 = phi_2631_;
                                                                        if (_e2070 < _e2018) {
                                                                            phi_2642_ = true;
                                                                        } else {
                                                                            if (_e2070 == _e2018) {
                                                                                phi_2641_ = (_e2074 < _e2022);
                                                                            } else {
                                                                                phi_2641_ = false;
                                                                            }
                                                                            let _e2100 = phi_2641_;
                                                                            phi_2642_ = _e2100;
                                                                        }
                                                                        let _e2102 = phi_2642_;
                                                                        if _e2102 {
                                                                            phi_2646_ = _e2022;
                                                                            phi_2647_ = _e2018;
                                                                            phi_2648_ = _e2074;
                                                                            phi_2649_ = _e2070;
                                                                        } else {
                                                                            phi_2646_ = _e2074;
                                                                            phi_2647_ = _e2070;
                                                                            phi_2648_ = _e2022;
                                                                            phi_2649_ = _e2018;
                                                                        }
                                                                        let _e2104 = phi_2646_;
                                                                        let _e2106 = phi_2647_;
                                                                        let _e2108 = phi_2648_;
                                                                        let _e2110 = phi_2649_;
                                                                        let _e2113 = ((_e2110 * _e2104) - (_e2108 * _e2106));
                                                                        if _e2102 {
                                                                            phi_2657_ = -(_e2113);
                                                                        } else {
                                                                            phi_2657_ = _e2113;
                                                                        }
                                                                        let _e2116 = phi_2657_;
                                                                        if (_e2018 < _e2044) {
                                                                            phi_2668_ = true;
                                                                        } else {
                                                                            if (_e2018 == _e2044) {
                                                                                phi_2667_ = (_e2022 < _e2048);
                                                                            } else {
                                                                                phi_2667_ = false;
                                                                            }
                                                                            let _e2121 = phi_2667_;
                                                                            phi_2668_ = _e2121;
                                                                        }
                                                                        let _e2123 = phi_2668_;
                                                                        if _e2123 {
                                                                            phi_2672_ = _e2048;
                                                                            phi_2673_ = _e2044;
                                                                            phi_2674_ = _e2022;
                                                                            phi_2675_ = _e2018;
                                                                        } else {
                                                                            phi_2672_ = _e2022;
                                                                            phi_2673_ = _e2018;
                                                                            phi_2674_ = _e2048;
                                                                            phi_2675_ = _e2044;
                                                                        }
                                                                        let _e2125 = phi_2672_;
                                                                        let _e2127 = phi_2673_;
                                                                        let _e2129 = phi_2674_;
                                                                        let _e2131 = phi_2675_;
                                                                        let _e2134 = ((_e2131 * _e2125) - (_e2129 * _e2127));
                                                                        if _e2123 {
                                                                            phi_2683_ = -(_e2134);
                                                                        } else {
                                                                            phi_2683_ = _e2134;
                                                                        }
                                                                        let _e2137 = phi_2683_;
                                                                        if (_e2095 >= 0f) {
                                                                            if (_e2116 >= 0f) {
                                                                                if (_e2137 >= 0f) {
                                                                                    phi_2698_ = ((_e2095 + _e2116) + _e2137);
                                                                                    phi_2699_ = false;
                                                                                } else {
                                                                                    phi_2698_ = f32();
                                                                                    phi_2699_ = true;
                                                                                }
                                                                                let _e2144 = phi_2698_;
                                                                                let _e2146 = phi_2699_;
                                                                                phi_2700_ = _e2144;
                                                                                phi_2701_ = _e2146;
                                                                            } else {
                                                                                phi_2700_ = f32();
                                                                                phi_2701_ = true;
                                                                            }
                                                                            let _e2148 = phi_2700_;
                                                                            let _e2150 = phi_2701_;
                                                                            phi_2702_ = _e2148;
                                                                            phi_2703_ = _e2150;
                                                                        } else {
                                                                            phi_2702_ = f32();
                                                                            phi_2703_ = true;
                                                                        }
                                                                        let _e2152 = phi_2702_;
                                                                        let _e2154 = phi_2703_;
                                                                        if _e2154 {
                                                                            if (_e2095 <= 0f) {
                                                                                if (_e2116 <= 0f) {
                                                                                    let _e2157 = (_e2137 <= 0f);
                                                                                    if _e2157 {
                                                                                    }
                                                                                    phi_2721_ = ((_e2095 + _e2116) + _e2137);
                                                                                    phi_2722_ = false;
                                                                                    phi_2723_ = _e2157;
                                                                                } else {
                                                                                    phi_2721_ = f32();
                                                                                    phi_2722_ = true;
                                                                                    phi_2723_ = false;
                                                                                }
                                                                                let _e2161 = phi_2721_;
                                                                                let _e2163 = phi_2722_;
                                                                                let _e2165 = phi_2723_;
                                                                                phi_2724_ = _e2161;
                                                                                phi_2725_ = _e2163;
                                                                                phi_2726_ = _e2165;
                                                                            } else {
                                                                                phi_2724_ = f32();
                                                                                phi_2725_ = true;
                                                                                phi_2726_ = false;
                                                                            }
                                                                            let _e2167 = phi_2724_;
                                                                            let _e2169 = phi_2725_;
                                                                            let _e2171 = phi_2726_;
                                                                            if _e2169 {
                                                                                phi_2730_ = false;
                                                                            } else {
                                                                                phi_2730_ = _e2171;
                                                                            }
                                                                            let _e2173 = phi_2730_;
                                                                            phi_2731_ = _e2167;
                                                                            phi_2732_ = _e2173;
                                                                        } else {
                                                                            phi_2731_ = _e2152;
                                                                            phi_2732_ = true;
                                                                        }
                                                                        let _e2175 = phi_2731_;
                                                                        let _e2177 = phi_2732_;
                                                                        if _e2177 {
                                                                            let _e2178 = (_e2175 == 0f);
                                                                            if _e2178 {
                                                                                phi_3048_ = lt_bvh_triangle_Intersection();
                                                                                phi_3049_ = false;
                                                                            } else {
                                                                                let _e2180 = triangles.member[(0u + _e1991)].v0_;
                                                                                let _e2182 = (_e2180.x - _e1101);
                                                                                let _e2184 = (_e2180.y - _e1114);
                                                                                let _e2186 = (_e2180.z - _e1127);
                                                                                if (_e1381 == 0u) {
                                                                                    phi_2761_ = vec3<f32>(_e2184, _e2186, _e2182);
                                                                                } else {
                                                                                    if (_e1381 == 1u) {
                                                                                        phi_2760_ = vec3<f32>(_e2186, _e2182, _e2184);
                                                                                    } else {
                                                                                        phi_2760_ = (_e2180 - vec3<f32>(_e1101, _e1114, _e1127));
                                                                                    }
                                                                                    let _e2194 = phi_2760_;
                                                                                    phi_2761_ = _e2194;
                                                                                }
                                                                                let _e2196 = phi_2761_;
                                                                                let _e2198 = triangles.member[(0u + _e1991)].v1_;
                                                                                let _e2200 = triangles.member[(0u + _e1991)].v0_;
                                                                                let _e2203 = (_e2198.x - _e2200.x);
                                                                                let _e2206 = (_e2198.y - _e2200.y);
                                                                                let _e2209 = (_e2198.z - _e2200.z);
                                                                                if (_e1381 == 0u) {
                                                                                    phi_2787_ = vec3<f32>(_e2206, _e2209, _e2203);
                                                                                } else {
                                                                                    if (_e1381 == 1u) {
                                                                                        phi_2786_ = vec3<f32>(_e2209, _e2203, _e2206);
                                                                                    } else {
                                                                                        phi_2786_ = (_e2198 - _e2200);
                                                                                    }
                                                                                    let _e2216 = phi_2786_;
                                                                                    phi_2787_ = _e2216;
                                                                                }
                                                                                let _e2218 = phi_2787_;
                                                                                let _e2220 = triangles.member[(0u + _e1991)].v2_;
                                                                                let _e2222 = triangles.member[(0u + _e1991)].v0_;
                                                                                let _e2225 = (_e2220.x - _e2222.x);
                                                                                let _e2228 = (_e2220.y - _e2222.y);
                                                                                let _e2231 = (_e2220.z - _e2222.z);
                                                                                if (_e1381 == 0u) {
                                                                                    phi_2813_ = vec3<f32>(_e2228, _e2231, _e2225);
                                                                                } else {
                                                                                    if (_e1381 == 1u) {
                                                                                        phi_2812_ = vec3<f32>(_e2231, _e2225, _e2228);
                                                                                    } else {
                                                                                        phi_2812_ = (_e2220 - _e2222);
                                                                                    }
                                                                                    let _e2238 = phi_2812_;
                                                                                    phi_2813_ = _e2238;
                                                                                }
                                                                                let _e2240 = phi_2813_;
                                                                                let _e2247 = ((_e2218.y * _e2240.z) - (_e2218.z * _e2240.y));
                                                                                let _e2254 = ((_e2218.z * _e2240.x) - (_e2218.x * _e2240.z));
                                                                                let _e2261 = ((_e2218.x * _e2240.y) - (_e2218.y * _e2240.x));
                                                                                let _e2275 = (((1f / _e1389.z) * (((_e2247 * _e2196.x) + (_e2254 * _e2196.y)) + (_e2261 * _e2196.z))) / (((_e2247 * _e1392) + (_e2254 * _e1395)) + _e2261));
                                                                                if (_e2275 > 0f) {
                                                                                    if (_e2275 < _e231) {
                                                                                        let _e2279 = triangles.member[(0u + _e1991)].v0_;
                                                                                        let _e2281 = triangles.member[(0u + _e1991)].v1_;
                                                                                        if (_e2279.x < _e2281.x) {
                                                                                            phi_2869_ = _e2279.x;
                                                                                        } else {
                                                                                            phi_2869_ = _e2281.x;
                                                                                        }
                                                                                        let _e2288 = phi_2869_;
                                                                                        if (_e2279.y < _e2281.y) {
                                                                                            phi_2878_ = _e2279.y;
                                                                                        } else {
                                                                                            phi_2878_ = _e2281.y;
                                                                                        }
                                                                                        let _e2295 = phi_2878_;
                                                                                        if (_e2279.z < _e2281.z) {
                                                                                            phi_2887_ = _e2279.z;
                                                                                        } else {
                                                                                            phi_2887_ = _e2281.z;
                                                                                        }
                                                                                        let _e2302 = phi_2887_;
                                                                                        let _e2304 = triangles.member[(0u + _e1991)].v2_;
                                                                                        if (_e2288 < _e2304.x) {
                                                                                            phi_2896_ = _e2288;
                                                                                        } else {
                                                                                            phi_2896_ = _e2304.x;
                                                                                        }
                                                                                        let _e2309 = phi_2896_;
                                                                                        if (_e2295 < _e2304.y) {
                                                                                            phi_2903_ = _e2295;
                                                                                        } else {
                                                                                            phi_2903_ = _e2304.y;
                                                                                        }
                                                                                        let _e2314 = phi_2903_;
                                                                                        if (_e2302 < _e2304.z) {
                                                                                            phi_2910_ = _e2302;
                                                                                        } else {
                                                                                            phi_2910_ = _e2304.z;
                                                                                        }
                                                                                        let _e2319 = phi_2910_;
                                                                                        let _e2321 = triangles.member[(0u + _e1991)].v0_;
                                                                                        let _e2323 = triangles.member[(0u + _e1991)].v1_;
                                                                                        if (_e2321.x > _e2323.x) {
                                                                                            phi_2923_ = _e2321.x;
                                                                                        } else {
                                                                                            phi_2923_ = _e2323.x;
                                                                                        }
                                                                                        let _e2330 = phi_2923_;
                                                                                        if (_e2321.y > _e2323.y) {
                                                                                            phi_2932_ = _e2321.y;
                                                                                        } else {
                                                                                            phi_2932_ = _e2323.y;
                                                                                        }
                                                                                        let _e2337 = phi_2932_;
                                                                                        if (_e2321.z > _e2323.z) {
                                                                                            phi_2941_ = _e2321.z;
                                                                                        } else {
                                                                                            phi_2941_ = _e2323.z;
                                                                                        }
                                                                                        let _e2344 = phi_2941_;
                                                                                        let _e2346 = triangles.member[(0u + _e1991)].v2_;
                                                                                        if (_e2330 > _e2346.x) {
                                                                                            phi_2950_ = _e2330;
                                                                                        } else {
                                                                                            phi_2950_ = _e2346.x;
                                                                                        }
                                                                                        let _e2351 = phi_2950_;
                                                                                        if (_e2337 > _e2346.y) {
                                                                                            phi_2957_ = _e2337;
                                                                                        } else {
                                                                                            phi_2957_ = _e2346.y;
                                                                                        }
                                                                                        let _e2356 = phi_2957_;
                                                                                        if (_e2344 > _e2346.z) {
                                                                                            phi_2964_ = _e2344;
                                                                                        } else {
                                                                                            phi_2964_ = _e2346.z;
                                                                                        }
                                                                                        let _e2361 = phi_2964_;
                                                                                        let _e2365 = ((_e2309 - _e1101) * _e1310);
                                                                                        let _e2366 = ((_e2314 - _e1114) * _e1320);
                                                                                        let _e2367 = ((_e2319 - _e1127) * _e1330);
                                                                                        let _e2371 = ((_e2351 - _e1101) * _e1310);
                                                                                        let _e2372 = ((_e2356 - _e1114) * _e1320);
                                                                                        let _e2373 = ((_e2361 - _e1127) * _e1330);
                                                                                        if (_e2365 < _e2371) {
                                                                                            phi_2981_ = _e2365;
                                                                                        } else {
                                                                                            phi_2981_ = _e2371;
                                                                                        }
                                                                                        let _e2376 = phi_2981_;
                                                                                        if (_e2366 < _e2372) {
                                                                                            phi_2986_ = _e2366;
                                                                                        } else {
                                                                                            phi_2986_ = _e2372;
                                                                                        }
                                                                                        let _e2379 = phi_2986_;
                                                                                        if (_e2367 < _e2373) {
                                                                                            phi_2991_ = _e2367;
                                                                                        } else {
                                                                                            phi_2991_ = _e2373;
                                                                                        }
                                                                                        let _e2382 = phi_2991_;
                                                                                        if (_e2365 > _e2371) {
                                                                                            phi_2999_ = _e2365;
                                                                                        } else {
                                                                                            phi_2999_ = _e2371;
                                                                                        }
                                                                                        let _e2388 = phi_2999_;
                                                                                        if (_e2366 > _e2372) {
                                                                                            phi_3004_ = _e2366;
                                                                                        } else {
                                                                                            phi_3004_ = _e2372;
                                                                                        }
                                                                                        let _e2391 = phi_3004_;
                                                                                        if (_e2367 > _e2373) {
                                                                                            phi_3009_ = _e2367;
                                                                                        } else {
                                                                                            phi_3009_ = _e2373;
                                                                                        }
                                                                                        let _e2394 = phi_3009_;
                                                                                        let _e2398 = core_intrinsics_maximum_number_nsz_f32_((_e2376 - _e1365), (_e2379 - _e1366));
                                                                                        let _e2399 = core_intrinsics_maximum_number_nsz_f32_(_e2398, (_e2382 - _e1367));
                                                                                        let _e2400 = core_intrinsics_minimum_number_nsz_f32_((_e2388 + _e1365), (_e2391 + _e1366));
                                                                                        let _e2401 = core_intrinsics_minimum_number_nsz_f32_(_e2400, (_e2394 + _e1367));
                                                                                        if (_e2399 > _e1082) {
                                                                                            phi_3021_ = _e2399;
                                                                                        } else {
                                                                                            phi_3021_ = _e1082;
                                                                                        }
                                                                                        let _e2404 = phi_3021_;
                                                                                        if (_e2401 < _e1084) {
                                                                                            phi_3026_ = _e2401;
                                                                                        } else {
                                                                                            phi_3026_ = _e1084;
                                                                                        }
                                                                                        let _e2407 = phi_3026_;
                                                                                        if (_e2275 < _e2404) {
                                                                                            phi_3031_ = _e2404;
                                                                                        } else {
                                                                                            phi_3031_ = _e2275;
                                                                                        }
                                                                                        let _e2410 = phi_3031_;
                                                                                        if (_e2410 > _e2407) {
                                                                                            phi_3036_ = _e2407;
                                                                                        } else {
                                                                                            phi_3036_ = _e2410;
                                                                                        }
                                                                                        let _e2413 = phi_3036_;
                                                                                        phi_3041_ = lt_bvh_triangle_Intersection(_e2413, (_e2116 / _e2175), (_e2137 / _e2175), (_e2404 <= _e2407));
                                                                                        phi_3042_ = false;
                                                                                    } else {
                                                                                        phi_3041_ = lt_bvh_triangle_Intersection();
                                                                                        phi_3042_ = true;
                                                                                    }
                                                                                    let _e2419 = phi_3041_;
                                                                                    let _e2421 = phi_3042_;
                                                                                    phi_3043_ = _e2419;
                                                                                    phi_3044_ = _e2421;
                                                                                } else {
                                                                                    phi_3043_ = lt_bvh_triangle_Intersection();
                                                                                    phi_3044_ = true;
                                                                                }
                                                                                let _e2423 = phi_3043_;
                                                                                let _e2425 = phi_3044_;
                                                                                if _e2425 {
                                                                                }
                                                                                phi_3048_ = _e2423;
                                                                                phi_3049_ = _e2425;
                                                                            }
                                                                            let _e2427 = phi_3048_;
                                                                            let _e2429 = phi_3049_;
                                                                            phi_3050_ = _e2427;
                                                                            phi_3051_ = _e2178;
                                                                            phi_3052_ = _e2429;
                                                                        } else {
                                                                            phi_3050_ = lt_bvh_triangle_Intersection();
                                                                            phi_3051_ = true;
                                                                            phi_3052_ = false;
                                                                        }
                                                                        let _e2431 = phi_3050_;
                                                                        let _e2433 = phi_3051_;
                                                                        let _e2435 = phi_3052_;
                                                                        if _e2433 {
                                                                            phi_3056_ = true;
                                                                        } else {
                                                                            phi_3056_ = _e2435;
                                                                        }
                                                                        let _e2437 = phi_3056_;
                                                                        if _e2437 {
                                                                            phi_3060_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                        } else {
                                                                            phi_3060_ = _e2431;
                                                                        }
                                                                        let _e2439 = phi_3060_;
                                                                        if _e2439.is_hit {
                                                                            if (_e2439.t > 0f) {
                                                                                if (_e2439.t < _e231) {
                                                                                    let _e2446 = triangles.member[(0u + _e1991)].i0_;
                                                                                    let _e2448 = ((_e2446 & 2147483648u) == 0u);
                                                                                    if _e2448 {
                                                                                        phi_3283_ = false;
                                                                                        phi_3284_ = false;
                                                                                    } else {
                                                                                        if (_e1991 < _e82) {
                                                                                        } else {
                                                                                            return;
                                                                                        }
                                                                                        let _e2455 = triangles.member[(0u + _e1991)].i0_;
                                                                                        let _e2456 = (_e2455 & 2147483647u);
                                                                                        let _e2458 = triangles.member[(0u + _e1991)].i1_;
                                                                                        let _e2460 = triangles.member[(0u + _e1991)].i2_;
                                                                                        if (_e2456 < _e91) {
                                                                                        } else {
                                                                                            return;
                                                                                        }
                                                                                        let _e2464 = vertices.member[(0u + _e2456)];
                                                                                        if (_e2458 < _e91) {
                                                                                        } else {
                                                                                            return;
                                                                                        }
                                                                                        let _e2468 = vertices.member[(0u + _e2458)];
                                                                                        if (_e2460 < _e91) {
                                                                                        } else {
                                                                                            return;
                                                                                        }
                                                                                        let _e2472 = vertices.member[(0u + _e2460)];
                                                                                        let _e2473 = array<abi_Vertex, 3>(_e2464, _e2468, _e2472);
                                                                                        if (_e2473[0].material < arrayLength((&materials.member))) {
                                                                                        } else {
                                                                                            return;
                                                                                        }
                                                                                        let _e2479 = materials.member[(0u + _e2473[0].material)];
                                                                                        if ((_e2479.flags & 1u) == 1u) {
                                                                                            let _e2484 = ((1f - _e2439.u) - _e2439.v);
                                                                                            if (_e2479.cutoff <= 0f) {
                                                                                                phi_3277_ = true;
                                                                                            } else {
                                                                                                let _e2511 = (_e2479.base_color.w * ((((f32((_e2473[0].color >> bitcast<u32>(24i))) * _e2484) + (f32((_e2473[1].color >> bitcast<u32>(24i))) * _e2439.u)) + (f32((_e2473[2].color >> bitcast<u32>(24i))) * _e2439.v)) * (1f / 255f)));
                                                                                                if (_e2479.alpha_size == 0u) {
                                                                                                    phi_3274_ = _e2511;
                                                                                                } else {
                                                                                                    local.offset = _e2479.alpha_offset;
                                                                                                    local.size = _e2479.alpha_size;
                                                                                                    local.flags = _e2479.flags;
                                                                                                    let _e2542 = _lt_shaders_texture_TextureView_quad((&local), (((_e2473[0].u * _e2484) + (_e2473[1].u * _e2439.u)) + (_e2473[2].u * _e2439.v)), (((_e2473[0].v * _e2484) + (_e2473[1].v * _e2439.u)) + (_e2473[2].v * _e2439.v)));
                                                                                                    let _e2546 = (_e2542.indices[0] >> bitcast<u32>(2i));
                                                                                                    if (_e2546 < _e97) {
                                                                                                    } else {
                                                                                                        return;
                                                                                                    }
                                                                                                    let _e2550 = alpha_texels.member[(0u + _e2546)];
                                                                                                    let _e2566 = (_e2542.indices[1] >> bitcast<u32>(2i));
                                                                                                    if (_e2566 < _e97) {
                                                                                                    } else {
                                                                                                        return;
                                                                                                    }
                                                                                                    let _e2570 = alpha_texels.member[(0u + _e2566)];
                                                                                                    let _e2587 = (_e2542.indices[2] >> bitcast<u32>(2i));
                                                                                                    if (_e2587 < _e97) {
                                                                                                    } else {
                                                                                                        return;
                                                                                                    }
                                                                                                    let _e2591 = alpha_texels.member[(0u + _e2587)];
                                                                                                    let _e2608 = (_e2542.indices[3] >> bitcast<u32>(2i));
                                                                                                    if (_e2608 < _e97) {
                                                                                                    } else {
                                                                                                        return;
                                                                                                    }
                                                                                                    let _e2612 = alpha_texels.member[(0u + _e2608)];
                                                                                                    phi_3274_ = (_e2511 * (((((f32(((_e2550 >> bitcast<u32>((((_e2542.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2542.weights.x) + ((f32(((_e2570 >> bitcast<u32>((((_e2542.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2542.weights.y)) + ((f32(((_e2591 >> bitcast<u32>((((_e2542.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2542.weights.z)) + ((f32(((_e2612 >> bitcast<u32>((((_e2542.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2542.weights.w)));
                                                                                                }
                                                                                                let _e2628 = phi_3274_;
                                                                                                phi_3277_ = (_e2628 >= _e2479.cutoff);
                                                                                            }
                                                                                            let _e2632 = phi_3277_;
                                                                                            phi_3278_ = _e2632;
                                                                                        } else {
                                                                                            phi_3278_ = false;
                                                                                        }
                                                                                        let _e2634 = phi_3278_;
                                                                                        if _e2634 {
                                                                                            phi_3282_ = false;
                                                                                        } else {
                                                                                            phi_3282_ = true;
                                                                                        }
                                                                                        let _e2636 = phi_3282_;
                                                                                        phi_3283_ = _e2636;
                                                                                        phi_3284_ = _e2634;
                                                                                    }
                                                                                    let _e2638 = phi_3283_;
                                                                                    let _e2640 = phi_3284_;
                                                                                    phi_3285_ = _e2638;
                                                                                    phi_3286_ = _e2448;
                                                                                    phi_3287_ = _e2640;
                                                                                } else {
                                                                                    phi_3285_ = true;
                                                                                    phi_3286_ = false;
                                                                                    phi_3287_ = false;
                                                                                }
                                                                                let _e2642 = phi_3285_;
                                                                                let _e2644 = phi_3286_;
                                                                                let _e2646 = phi_3287_;
                                                                                phi_3288_ = _e2642;
                                                                                phi_3289_ = _e2644;
                                                                                phi_3290_ = _e2646;
                                                                            } else {
                                                                                phi_3288_ = true;
                                                                                phi_3289_ = false;
                                                                                phi_3290_ = false;
                                                                            }
                                                                            let _e2648 = phi_3288_;
                                                                            let _e2650 = phi_3289_;
                                                                            let _e2652 = phi_3290_;
                                                                            phi_3291_ = _e2648;
                                                                            phi_3292_ = _e2650;
                                                                            phi_3293_ = _e2652;
                                                                        } else {
                                                                            phi_3291_ = true;
                                                                            phi_3292_ = false;
                                                                            phi_3293_ = false;
                                                                        }
                                                                        let _e2654 = phi_3291_;
                                                                        let _e2656 = phi_3292_;
                                                                        let _e2658 = phi_3293_;
                                                                        if _e2654 {
                                                                            phi_3297_ = false;
                                                                            phi_3298_ = false;
                                                                        } else {
                                                                            phi_3297_ = _e2656;
                                                                            phi_3298_ = _e2658;
                                                                        }
                                                                        let _e2660 = phi_3297_;
                                                                        let _e2662 = phi_3298_;
                                                                        phi_2492_ = (_e1982 & (_e1982 - 1u));
                                                                        phi_3299_ = _e2654;
                                                                        phi_3300_ = _e2660;
                                                                        phi_3301_ = _e2662;
                                                                    }
                                                                    let _e2664 = phi_2492_;
                                                                    let _e2666 = phi_3299_;
                                                                    let _e2668 = phi_3300_;
                                                                    let _e2670 = phi_3301_;
                                                                    local_14 = _e2668;
                                                                    local_15 = _e2670;
                                                                    continue;
                                                                    continuing {
                                                                        phi_2491_ = _e2664;
                                                                        break if !(_e2666);
                                                                    }
                                                                }
                                                                let _e2673 = local_10;
                                                                if _e2673 {
                                                                    let _e2675 = local_1.group_mask;
                                                                    if ((_e2675 & 4278190080u) == 0u) {
                                                                        let _e2679 = local_1.len;
                                                                        if (_e2679 == 0u) {
                                                                            phi_3343_ = false;
                                                                        } else {
                                                                            let _e2683 = local_1.len;
                                                                            local_1.len = (_e2683 - 1u);
                                                                            let _e2686 = local_1.len;
                                                                            if (_e2686 < 32u) {
                                                                            } else {
                                                                                return;
                                                                            }
                                                                            let _e2691 = local_1.first[(0u + _e2686)];
                                                                            local_1.group = _e2691;
                                                                            let _e2694 = local_1.len;
                                                                            if (_e2694 < 32u) {
                                                                            } else {
                                                                                return;
                                                                            }
                                                                            let _e2699 = local_1.mask[(0u + _e2694)];
                                                                            local_1.group_mask = _e2699;
                                                                            phi_3343_ = true;
                                                                        }
                                                                        let _e2702 = phi_3343_;
                                                                        phi_3344_ = _e2702;
                                                                    } else {
                                                                        phi_3344_ = true;
                                                                    }
                                                                    let _e2704 = phi_3344_;
                                                                    if _e2704 {
                                                                        let _e2706 = local_1.group_mask;
                                                                        let _e2712 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2706)), 32u, (_e2706 == 0u)));
                                                                        let _e2716 = local_1.group_mask;
                                                                        let _e2730 = local_1.group_mask;
                                                                        local_1.group_mask = (_e2730 & ~((1u << bitcast<u32>((_e2712 & 31u)))));
                                                                        let _e2733 = local_1.group;
                                                                        phi_3375_ = (_e2733 + countOneBits(((_e2716 & ~((4294967295u << bitcast<u32>((((_e2712 - 24u) ^ _e1408) & 31u))))) & 255u)));
                                                                    } else {
                                                                        phi_3375_ = 4294967295u;
                                                                    }
                                                                    let _e2736 = phi_3375_;
                                                                    phi_3376_ = _e2736;
                                                                    phi_3377_ = false;
                                                                    phi_3378_ = false;
                                                                } else {
                                                                    phi_3376_ = u32();
                                                                    let _e3126 = local_14;
                                                                    phi_3377_ = _e3126;
                                                                    let _e3129 = local_15;
                                                                    phi_3378_ = _e3129;
                                                                }
                                                                let _e2738 = phi_3376_;
                                                                let _e2740 = phi_3377_;
                                                                let _e2742 = phi_3378_;
                                                                phi_2162_ = _e2738;
                                                                let _e3133 = local_16;
                                                                phi_3379_ = _e3133;
                                                                phi_3380_ = false;
                                                                phi_3381_ = _e2740;
                                                                phi_3382_ = _e2742;
                                                            } else {
                                                                phi_2162_ = u32();
                                                                phi_3379_ = false;
                                                                phi_3380_ = true;
                                                                phi_3381_ = false;
                                                                phi_3382_ = false;
                                                            }
                                                            let _e2744 = phi_2162_;
                                                            let _e2746 = phi_3379_;
                                                            let _e2748 = phi_3380_;
                                                            let _e2750 = phi_3381_;
                                                            let _e2752 = phi_3382_;
                                                            local_11 = _e2748;
                                                            local_17 = _e2750;
                                                            local_18 = _e2752;
                                                            continue;
                                                            continuing {
                                                                phi_2161_ = _e2744;
                                                                break if !(_e2746);
                                                            }
                                                        }
                                                        let _e2755 = local_11;
                                                        if _e2755 {
                                                            phi_3386_ = false;
                                                            phi_3387_ = false;
                                                        } else {
                                                            let _e3140 = local_17;
                                                            phi_3386_ = _e3140;
                                                            let _e3143 = local_18;
                                                            phi_3387_ = _e3143;
                                                        }
                                                        let _e2757 = phi_3386_;
                                                        let _e2759 = phi_3387_;
                                                        if _e2757 {
                                                            phi_3391_ = true;
                                                        } else {
                                                            phi_3391_ = _e2759;
                                                        }
                                                        let _e2761 = phi_3391_;
                                                        if _e2761 {
                                                            phi_3395_ = true;
                                                        } else {
                                                            phi_3395_ = false;
                                                        }
                                                        let _e2763 = phi_3395_;
                                                        phi_3396_ = _e2763;
                                                    }
                                                    let _e2765 = phi_3396_;
                                                    phi_3397_ = _e2765;
                                                    phi_3398_ = _e1234;
                                                } else {
                                                    phi_3397_ = bool();
                                                    phi_3398_ = true;
                                                }
                                                let _e2767 = phi_3397_;
                                                let _e2769 = phi_3398_;
                                                if _e2769 {
                                                    phi_3402_ = false;
                                                } else {
                                                    phi_3402_ = _e2767;
                                                }
                                                let _e2771 = phi_3402_;
                                                if _e2771 {
                                                    phi_3406_ = false;
                                                } else {
                                                    phi_3406_ = true;
                                                }
                                                let _e2773 = phi_3406_;
                                                phi_3407_ = _e2773;
                                            } else {
                                                phi_3407_ = true;
                                            }
                                            let _e2775 = phi_3407_;
                                            phi_3408_ = _e2775;
                                        } else {
                                            phi_3408_ = true;
                                        }
                                        let _e2777 = phi_3408_;
                                        phi_3409_ = _e2777;
                                    } else {
                                        phi_3409_ = true;
                                    }
                                    let _e2779 = phi_3409_;
                                    if _e2779 {
                                    }
                                    phi_1556_ = (_e1021 & (_e1021 - 1u));
                                    phi_3413_ = _e2779;
                                }
                                let _e2781 = phi_1556_;
                                let _e2783 = phi_3413_;
                                continue;
                                continuing {
                                    phi_1555_ = _e2781;
                                    break if !(_e2783);
                                }
                            }
                            let _e2786 = local_12;
                            if _e2786 {
                                let _e2788 = local_2.group_mask;
                                if ((_e2788 & 4278190080u) == 0u) {
                                    let _e2792 = local_2.len;
                                    if (_e2792 == 0u) {
                                        phi_3455_ = false;
                                    } else {
                                        let _e2796 = local_2.len;
                                        local_2.len = (_e2796 - 1u);
                                        let _e2799 = local_2.len;
                                        if (_e2799 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e2804 = local_2.first[(0u + _e2799)];
                                        local_2.group = _e2804;
                                        let _e2807 = local_2.len;
                                        if (_e2807 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e2812 = local_2.mask[(0u + _e2807)];
                                        local_2.group_mask = _e2812;
                                        phi_3455_ = true;
                                    }
                                    let _e2815 = phi_3455_;
                                    phi_3456_ = _e2815;
                                } else {
                                    phi_3456_ = true;
                                }
                                let _e2817 = phi_3456_;
                                if _e2817 {
                                    let _e2819 = local_2.group_mask;
                                    let _e2825 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2819)), 32u, (_e2819 == 0u)));
                                    let _e2829 = local_2.group_mask;
                                    let _e2843 = local_2.group_mask;
                                    local_2.group_mask = (_e2843 & ~((1u << bitcast<u32>((_e2825 & 31u)))));
                                    let _e2846 = local_2.group;
                                    phi_3487_ = (_e2846 + countOneBits(((_e2829 & ~((4294967295u << bitcast<u32>((((_e2825 - 24u) ^ _e447) & 31u))))) & 255u)));
                                } else {
                                    phi_3487_ = 4294967295u;
                                }
                                let _e2849 = phi_3487_;
                                phi_3488_ = _e2849;
                            } else {
                                phi_3488_ = u32();
                            }
                            let _e2851 = phi_3488_;
                            phi_1226_ = _e2851;
                            let _e3164 = local_19;
                            phi_3489_ = _e3164;
                            phi_3490_ = false;
                        } else {
                            phi_1226_ = u32();
                            phi_3489_ = false;
                            phi_3490_ = true;
                        }
                        let _e2853 = phi_1226_;
                        let _e2855 = phi_3489_;
                        let _e2857 = phi_3490_;
                        local_13 = _e2857;
                        continue;
                        continuing {
                            phi_1225_ = _e2853;
                            break if !(_e2855);
                        }
                    }
                    let _e2860 = local_13;
                    if _e2860 {
                        phi_3494_ = false;
                    } else {
                        phi_3494_ = true;
                    }
                    let _e2862 = phi_3494_;
                    if _e2862 {
                        phi_3498_ = true;
                    } else {
                        phi_3498_ = false;
                    }
                    let _e2864 = phi_3498_;
                    phi_3499_ = _e2864;
                }
                let _e2866 = phi_3499_;
                phi_3500_ = _e2866;
                phi_3501_ = _e303;
            } else {
                phi_3500_ = bool();
                phi_3501_ = true;
            }
            let _e2868 = phi_3500_;
            let _e2870 = phi_3501_;
            if _e2870 {
                phi_3505_ = false;
            } else {
                phi_3505_ = _e2868;
            }
            let _e2872 = phi_3505_;
            if _e2872 {
                phi_3509_ = 0f;
            } else {
                phi_3509_ = 1f;
            }
            let _e2874 = phi_3509_;
            phi_3510_ = _e2874;
        }
        let _e2876 = phi_3510_;
        if (_e103.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e103.first_primitive)] = _e2876;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_resolve_resolve_all_instanced_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
