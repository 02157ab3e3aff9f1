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
    pad0_: u32,
    pad1_: u32,
    pad2_: u32,
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
    var phi_2568_: vec3<f32>;
    var phi_2569_: vec3<f32>;
    var phi_2600_: vec3<f32>;
    var phi_2601_: vec3<f32>;
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
    var phi_2673_: bool;
    var phi_2674_: bool;
    var phi_2678_: f32;
    var phi_2679_: f32;
    var phi_2680_: f32;
    var phi_2681_: f32;
    var phi_2689_: f32;
    var phi_2704_: f32;
    var phi_2705_: bool;
    var phi_2706_: f32;
    var phi_2707_: bool;
    var phi_2708_: f32;
    var phi_2709_: bool;
    var phi_2727_: f32;
    var phi_2728_: bool;
    var phi_2729_: bool;
    var phi_2730_: f32;
    var phi_2731_: bool;
    var phi_2732_: bool;
    var phi_2736_: bool;
    var phi_2737_: f32;
    var phi_2738_: bool;
    var phi_2772_: f32;
    var phi_2781_: f32;
    var phi_2790_: f32;
    var phi_2799_: f32;
    var phi_2806_: f32;
    var phi_2813_: f32;
    var phi_2826_: f32;
    var phi_2835_: f32;
    var phi_2844_: f32;
    var phi_2853_: f32;
    var phi_2860_: f32;
    var phi_2867_: f32;
    var phi_2884_: f32;
    var phi_2889_: f32;
    var phi_2894_: f32;
    var phi_2902_: f32;
    var phi_2907_: f32;
    var phi_2912_: f32;
    var phi_2924_: f32;
    var phi_2929_: f32;
    var phi_2934_: f32;
    var phi_2939_: f32;
    var phi_2944_: lt_bvh_triangle_Intersection;
    var phi_2945_: bool;
    var phi_2946_: lt_bvh_triangle_Intersection;
    var phi_2947_: bool;
    var phi_2951_: lt_bvh_triangle_Intersection;
    var phi_2952_: bool;
    var phi_2953_: lt_bvh_triangle_Intersection;
    var phi_2954_: bool;
    var phi_2955_: bool;
    var phi_2959_: bool;
    var phi_2963_: lt_bvh_triangle_Intersection;
    var phi_3177_: f32;
    var phi_3180_: bool;
    var phi_3181_: bool;
    var phi_3185_: bool;
    var phi_3186_: bool;
    var phi_3187_: bool;
    var phi_3188_: bool;
    var phi_3189_: bool;
    var phi_3190_: bool;
    var phi_3191_: bool;
    var phi_3192_: bool;
    var phi_3193_: bool;
    var phi_3194_: bool;
    var phi_3195_: bool;
    var phi_3196_: bool;
    var phi_3200_: bool;
    var phi_3201_: bool;
    var phi_2492_: u32;
    var phi_3202_: bool;
    var phi_3203_: bool;
    var phi_3204_: bool;
    var local_10: bool;
    var phi_3246_: bool;
    var phi_3247_: bool;
    var phi_3278_: u32;
    var phi_3279_: u32;
    var phi_3280_: bool;
    var phi_3281_: bool;
    var phi_2162_: u32;
    var phi_3282_: bool;
    var phi_3283_: bool;
    var phi_3284_: bool;
    var phi_3285_: bool;
    var local_11: bool;
    var phi_3289_: bool;
    var phi_3290_: bool;
    var phi_3294_: bool;
    var phi_3298_: bool;
    var phi_3299_: bool;
    var phi_3300_: bool;
    var phi_3301_: bool;
    var phi_3305_: bool;
    var phi_3309_: bool;
    var phi_3310_: bool;
    var phi_3311_: bool;
    var phi_3312_: bool;
    var phi_1556_: u32;
    var phi_3316_: bool;
    var local_12: bool;
    var phi_3358_: bool;
    var phi_3359_: bool;
    var phi_3390_: u32;
    var phi_3391_: u32;
    var phi_1226_: u32;
    var phi_3392_: bool;
    var phi_3393_: bool;
    var local_13: bool;
    var phi_3397_: bool;
    var phi_3401_: bool;
    var phi_3402_: bool;
    var phi_3403_: bool;
    var phi_3404_: bool;
    var phi_3408_: bool;
    var phi_3412_: f32;
    var phi_3413_: f32;
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
            phi_3413_ = _e200.unnamed.visibility;
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
                    phi_3402_ = bool();
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
                                    phi_3316_ = false;
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
                                                        phi_3299_ = bool();
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
                                                        let _e1397 = (1f / _e1389.z);
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
                                                                        phi_3202_ = false;
                                                                        phi_3203_ = false;
                                                                        phi_3204_ = false;
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
                                                                        let _e2026 = triangles.member[(0u + _e1991)].v1_;
                                                                        let _e2028 = (_e2026.x - _e1101);
                                                                        let _e2030 = (_e2026.y - _e1114);
                                                                        let _e2032 = (_e2026.z - _e1127);
                                                                        if (_e1381 == 0u) {
                                                                            phi_2569_ = vec3<f32>(_e2030, _e2032, _e2028);
                                                                        } else {
                                                                            if (_e1381 == 1u) {
                                                                                phi_2568_ = vec3<f32>(_e2032, _e2028, _e2030);
                                                                            } else {
                                                                                phi_2568_ = (_e2026 - vec3<f32>(_e1101, _e1114, _e1127));
                                                                            }
                                                                            let _e2040 = phi_2568_;
                                                                            phi_2569_ = _e2040;
                                                                        }
                                                                        let _e2042 = phi_2569_;
                                                                        let _e2046 = (_e2042.x - (_e1392 * _e2042.z));
                                                                        let _e2050 = (_e2042.y - (_e1395 * _e2042.z));
                                                                        let _e2054 = triangles.member[(0u + _e1991)].v2_;
                                                                        let _e2056 = (_e2054.x - _e1101);
                                                                        let _e2058 = (_e2054.y - _e1114);
                                                                        let _e2060 = (_e2054.z - _e1127);
                                                                        if (_e1381 == 0u) {
                                                                            phi_2601_ = vec3<f32>(_e2058, _e2060, _e2056);
                                                                        } else {
                                                                            if (_e1381 == 1u) {
                                                                                phi_2600_ = vec3<f32>(_e2060, _e2056, _e2058);
                                                                            } else {
                                                                                phi_2600_ = (_e2054 - vec3<f32>(_e1101, _e1114, _e1127));
                                                                            }
                                                                            let _e2068 = phi_2600_;
                                                                            phi_2601_ = _e2068;
                                                                        }
                                                                        let _e2070 = phi_2601_;
                                                                        let _e2074 = (_e2070.x - (_e1392 * _e2070.z));
                                                                        let _e2078 = (_e2070.y - (_e1395 * _e2070.z));
                                                                        if (_e2046 < _e2074) {
                                                                            phi_2622_ = true;
                                                                        } else {
                                                                            if (_e2046 == _e2074) {
                                                                                phi_2621_ = (_e2050 < _e2078);
                                                                            } else {
                                                                                phi_2621_ = false;
                                                                            }
                                                                            let _e2085 = phi_2621_;
                                                                            phi_2622_ = _e2085;
                                                                        }
                                                                        let _e2087 = phi_2622_;
                                                                        if _e2087 {
                                                                            phi_2626_ = _e2078;
                                                                            phi_2627_ = _e2074;
                                                                            phi_2628_ = _e2050;
                                                                            phi_2629_ = _e2046;
                                                                        } else {
                                                                            phi_2626_ = _e2050;
                                                                            phi_2627_ = _e2046;
                                                                            phi_2628_ = _e2078;
                                                                            phi_2629_ = _e2074;
                                                                        }
                                                                        let _e2089 = phi_2626_;
                                                                        let _e2091 = phi_2627_;
                                                                        let _e2093 = phi_2628_;
                                                                        let _e2095 = phi_2629_;
                                                                        let _e2098 = ((_e2095 * _e2089) - (_e2093 * _e2091));
                                                                        if _e2087 {
                                                                            phi_2637_ = -(_e2098);
                                                                        } else {
                                                                            phi_2637_ = _e2098;
                                                                        }
                                                                        let _e2101 = phi_2637_;
                                                                        if (_e2074 < _e2018) {
                                                                            phi_2648_ = true;
                                                                        } else {
                                                                            if (_e2074 == _e2018) {
                                                                                phi_2647_ = (_e2078 < _e2022);
                                                                            } else {
                                                                                phi_2647_ = false;
                                                                            }
                                                                            let _e2106 = phi_2647_;
                                                                            phi_2648_ = _e2106;
                                                                        }
                                                                        let _e2108 = phi_2648_;
                                                                        if _e2108 {
                                                                            phi_2652_ = _e2022;
                                                                            phi_2653_ = _e2018;
                                                                            phi_2654_ = _e2078;
                                                                            phi_2655_ = _e2074;
                                                                        } else {
                                                                            phi_2652_ = _e2078;
                                                                            phi_2653_ = _e2074;
                                                                            phi_2654_ = _e2022;
                                                                            phi_2655_ = _e2018;
                                                                        }
                                                                        let _e2110 = phi_2652_;
                                                                        let _e2112 = phi_2653_;
                                                                        let _e2114 = phi_2654_;
                                                                        let _e2116 = phi_2655_;
                                                                        let _e2119 = ((_e2116 * _e2110) - (_e2114 * _e2112));
                                                                        if _e2108 {
                                                                            phi_2663_ = -(_e2119);
                                                                        } else {
                                                                            phi_2663_ = _e2119;
                                                                        }
                                                                        let _e2122 = phi_2663_;
                                                                        if (_e2018 < _e2046) {
                                                                            phi_2674_ = true;
                                                                        } else {
                                                                            if (_e2018 == _e2046) {
                                                                                phi_2673_ = (_e2022 < _e2050);
                                                                            } else {
                                                                                phi_2673_ = false;
                                                                            }
                                                                            let _e2127 = phi_2673_;
                                                                            phi_2674_ = _e2127;
                                                                        }
                                                                        let _e2129 = phi_2674_;
                                                                        if _e2129 {
                                                                            phi_2678_ = _e2050;
                                                                            phi_2679_ = _e2046;
                                                                            phi_2680_ = _e2022;
                                                                            phi_2681_ = _e2018;
                                                                        } else {
                                                                            phi_2678_ = _e2022;
                                                                            phi_2679_ = _e2018;
                                                                            phi_2680_ = _e2050;
                                                                            phi_2681_ = _e2046;
                                                                        }
                                                                        let _e2131 = phi_2678_;
                                                                        let _e2133 = phi_2679_;
                                                                        let _e2135 = phi_2680_;
                                                                        let _e2137 = phi_2681_;
                                                                        let _e2140 = ((_e2137 * _e2131) - (_e2135 * _e2133));
                                                                        if _e2129 {
                                                                            phi_2689_ = -(_e2140);
                                                                        } else {
                                                                            phi_2689_ = _e2140;
                                                                        }
                                                                        let _e2143 = phi_2689_;
                                                                        if (_e2101 >= 0f) {
                                                                            if (_e2122 >= 0f) {
                                                                                if (_e2143 >= 0f) {
                                                                                    phi_2704_ = ((_e2101 + _e2122) + _e2143);
                                                                                    phi_2705_ = false;
                                                                                } else {
                                                                                    phi_2704_ = f32();
                                                                                    phi_2705_ = true;
                                                                                }
                                                                                let _e2150 = phi_2704_;
                                                                                let _e2152 = phi_2705_;
                                                                                phi_2706_ = _e2150;
                                                                                phi_2707_ = _e2152;
                                                                            } else {
                                                                                phi_2706_ = f32();
                                                                                phi_2707_ = true;
                                                                            }
                                                                            let _e2154 = phi_2706_;
                                                                            let _e2156 = phi_2707_;
                                                                            phi_2708_ = _e2154;
                                                                            phi_2709_ = _e2156;
                                                                        } else {
                                                                            phi_2708_ = f32();
                                                                            phi_2709_ = true;
                                                                        }
                                                                        let _e2158 = phi_2708_;
                                                                        let _e2160 = phi_2709_;
                                                                        if _e2160 {
                                                                            if (_e2101 <= 0f) {
                                                                                if (_e2122 <= 0f) {
                                                                                    let _e2163 = (_e2143 <= 0f);
                                                                                    if _e2163 {
                                                                                    }
                                                                                    phi_2727_ = ((_e2101 + _e2122) + _e2143);
                                                                                    phi_2728_ = false;
                                                                                    phi_2729_ = _e2163;
                                                                                } else {
                                                                                    phi_2727_ = f32();
                                                                                    phi_2728_ = true;
                                                                                    phi_2729_ = false;
                                                                                }
                                                                                let _e2167 = phi_2727_;
                                                                                let _e2169 = phi_2728_;
                                                                                let _e2171 = phi_2729_;
                                                                                phi_2730_ = _e2167;
                                                                                phi_2731_ = _e2169;
                                                                                phi_2732_ = _e2171;
                                                                            } else {
                                                                                phi_2730_ = f32();
                                                                                phi_2731_ = true;
                                                                                phi_2732_ = false;
                                                                            }
                                                                            let _e2173 = phi_2730_;
                                                                            let _e2175 = phi_2731_;
                                                                            let _e2177 = phi_2732_;
                                                                            if _e2175 {
                                                                                phi_2736_ = false;
                                                                            } else {
                                                                                phi_2736_ = _e2177;
                                                                            }
                                                                            let _e2179 = phi_2736_;
                                                                            phi_2737_ = _e2173;
                                                                            phi_2738_ = _e2179;
                                                                        } else {
                                                                            phi_2737_ = _e2158;
                                                                            phi_2738_ = true;
                                                                        }
                                                                        let _e2181 = phi_2737_;
                                                                        let _e2183 = phi_2738_;
                                                                        if _e2183 {
                                                                            let _e2184 = (_e2181 == 0f);
                                                                            if _e2184 {
                                                                                phi_2951_ = lt_bvh_triangle_Intersection();
                                                                                phi_2952_ = false;
                                                                            } else {
                                                                                let _e2190 = ((((_e2101 * (_e1397 * _e2014.z)) + (_e2122 * (_e1397 * _e2042.z))) + (_e2143 * (_e1397 * _e2070.z))) / _e2181);
                                                                                if (_e2190 > 0f) {
                                                                                    if (_e2190 < _e231) {
                                                                                        let _e2194 = triangles.member[(0u + _e1991)].v0_;
                                                                                        let _e2196 = triangles.member[(0u + _e1991)].v1_;
                                                                                        if (_e2194.x < _e2196.x) {
                                                                                            phi_2772_ = _e2194.x;
                                                                                        } else {
                                                                                            phi_2772_ = _e2196.x;
                                                                                        }
                                                                                        let _e2203 = phi_2772_;
                                                                                        if (_e2194.y < _e2196.y) {
                                                                                            phi_2781_ = _e2194.y;
                                                                                        } else {
                                                                                            phi_2781_ = _e2196.y;
                                                                                        }
                                                                                        let _e2210 = phi_2781_;
                                                                                        if (_e2194.z < _e2196.z) {
                                                                                            phi_2790_ = _e2194.z;
                                                                                        } else {
                                                                                            phi_2790_ = _e2196.z;
                                                                                        }
                                                                                        let _e2217 = phi_2790_;
                                                                                        let _e2219 = triangles.member[(0u + _e1991)].v2_;
                                                                                        if (_e2203 < _e2219.x) {
                                                                                            phi_2799_ = _e2203;
                                                                                        } else {
                                                                                            phi_2799_ = _e2219.x;
                                                                                        }
                                                                                        let _e2224 = phi_2799_;
                                                                                        if (_e2210 < _e2219.y) {
                                                                                            phi_2806_ = _e2210;
                                                                                        } else {
                                                                                            phi_2806_ = _e2219.y;
                                                                                        }
                                                                                        let _e2229 = phi_2806_;
                                                                                        if (_e2217 < _e2219.z) {
                                                                                            phi_2813_ = _e2217;
                                                                                        } else {
                                                                                            phi_2813_ = _e2219.z;
                                                                                        }
                                                                                        let _e2234 = phi_2813_;
                                                                                        let _e2236 = triangles.member[(0u + _e1991)].v0_;
                                                                                        let _e2238 = triangles.member[(0u + _e1991)].v1_;
                                                                                        if (_e2236.x > _e2238.x) {
                                                                                            phi_2826_ = _e2236.x;
                                                                                        } else {
                                                                                            phi_2826_ = _e2238.x;
                                                                                        }
                                                                                        let _e2245 = phi_2826_;
                                                                                        if (_e2236.y > _e2238.y) {
                                                                                            phi_2835_ = _e2236.y;
                                                                                        } else {
                                                                                            phi_2835_ = _e2238.y;
                                                                                        }
                                                                                        let _e2252 = phi_2835_;
                                                                                        if (_e2236.z > _e2238.z) {
                                                                                            phi_2844_ = _e2236.z;
                                                                                        } else {
                                                                                            phi_2844_ = _e2238.z;
                                                                                        }
                                                                                        let _e2259 = phi_2844_;
                                                                                        let _e2261 = triangles.member[(0u + _e1991)].v2_;
                                                                                        if (_e2245 > _e2261.x) {
                                                                                            phi_2853_ = _e2245;
                                                                                        } else {
                                                                                            phi_2853_ = _e2261.x;
                                                                                        }
                                                                                        let _e2266 = phi_2853_;
                                                                                        if (_e2252 > _e2261.y) {
                                                                                            phi_2860_ = _e2252;
                                                                                        } else {
                                                                                            phi_2860_ = _e2261.y;
                                                                                        }
                                                                                        let _e2271 = phi_2860_;
                                                                                        if (_e2259 > _e2261.z) {
                                                                                            phi_2867_ = _e2259;
                                                                                        } else {
                                                                                            phi_2867_ = _e2261.z;
                                                                                        }
                                                                                        let _e2276 = phi_2867_;
                                                                                        let _e2280 = ((_e2224 - _e1101) * _e1310);
                                                                                        let _e2281 = ((_e2229 - _e1114) * _e1320);
                                                                                        let _e2282 = ((_e2234 - _e1127) * _e1330);
                                                                                        let _e2286 = ((_e2266 - _e1101) * _e1310);
                                                                                        let _e2287 = ((_e2271 - _e1114) * _e1320);
                                                                                        let _e2288 = ((_e2276 - _e1127) * _e1330);
                                                                                        if (_e2280 < _e2286) {
                                                                                            phi_2884_ = _e2280;
                                                                                        } else {
                                                                                            phi_2884_ = _e2286;
                                                                                        }
                                                                                        let _e2291 = phi_2884_;
                                                                                        if (_e2281 < _e2287) {
                                                                                            phi_2889_ = _e2281;
                                                                                        } else {
                                                                                            phi_2889_ = _e2287;
                                                                                        }
                                                                                        let _e2294 = phi_2889_;
                                                                                        if (_e2282 < _e2288) {
                                                                                            phi_2894_ = _e2282;
                                                                                        } else {
                                                                                            phi_2894_ = _e2288;
                                                                                        }
                                                                                        let _e2297 = phi_2894_;
                                                                                        if (_e2280 > _e2286) {
                                                                                            phi_2902_ = _e2280;
                                                                                        } else {
                                                                                            phi_2902_ = _e2286;
                                                                                        }
                                                                                        let _e2303 = phi_2902_;
                                                                                        if (_e2281 > _e2287) {
                                                                                            phi_2907_ = _e2281;
                                                                                        } else {
                                                                                            phi_2907_ = _e2287;
                                                                                        }
                                                                                        let _e2306 = phi_2907_;
                                                                                        if (_e2282 > _e2288) {
                                                                                            phi_2912_ = _e2282;
                                                                                        } else {
                                                                                            phi_2912_ = _e2288;
                                                                                        }
                                                                                        let _e2309 = phi_2912_;
                                                                                        let _e2313 = core_intrinsics_maximum_number_nsz_f32_((_e2291 - _e1365), (_e2294 - _e1366));
                                                                                        let _e2314 = core_intrinsics_maximum_number_nsz_f32_(_e2313, (_e2297 - _e1367));
                                                                                        let _e2315 = core_intrinsics_minimum_number_nsz_f32_((_e2303 + _e1365), (_e2306 + _e1366));
                                                                                        let _e2316 = core_intrinsics_minimum_number_nsz_f32_(_e2315, (_e2309 + _e1367));
                                                                                        if (_e2314 > _e1082) {
                                                                                            phi_2924_ = _e2314;
                                                                                        } else {
                                                                                            phi_2924_ = _e1082;
                                                                                        }
                                                                                        let _e2319 = phi_2924_;
                                                                                        if (_e2316 < _e1084) {
                                                                                            phi_2929_ = _e2316;
                                                                                        } else {
                                                                                            phi_2929_ = _e1084;
                                                                                        }
                                                                                        let _e2322 = phi_2929_;
                                                                                        if (_e2190 < _e2319) {
                                                                                            phi_2934_ = _e2319;
                                                                                        } else {
                                                                                            phi_2934_ = _e2190;
                                                                                        }
                                                                                        let _e2325 = phi_2934_;
                                                                                        if (_e2325 > _e2322) {
                                                                                            phi_2939_ = _e2322;
                                                                                        } else {
                                                                                            phi_2939_ = _e2325;
                                                                                        }
                                                                                        let _e2328 = phi_2939_;
                                                                                        phi_2944_ = lt_bvh_triangle_Intersection(_e2328, (_e2122 / _e2181), (_e2143 / _e2181), (_e2319 <= _e2322));
                                                                                        phi_2945_ = false;
                                                                                    } else {
                                                                                        phi_2944_ = lt_bvh_triangle_Intersection();
                                                                                        phi_2945_ = true;
                                                                                    }
                                                                                    let _e2334 = phi_2944_;
                                                                                    let _e2336 = phi_2945_;
                                                                                    phi_2946_ = _e2334;
                                                                                    phi_2947_ = _e2336;
                                                                                } else {
                                                                                    phi_2946_ = lt_bvh_triangle_Intersection();
                                                                                    phi_2947_ = true;
                                                                                }
                                                                                let _e2338 = phi_2946_;
                                                                                let _e2340 = phi_2947_;
                                                                                if _e2340 {
                                                                                }
                                                                                phi_2951_ = _e2338;
                                                                                phi_2952_ = _e2340;
                                                                            }
                                                                            let _e2342 = phi_2951_;
                                                                            let _e2344 = phi_2952_;
                                                                            phi_2953_ = _e2342;
                                                                            phi_2954_ = _e2184;
                                                                            phi_2955_ = _e2344;
                                                                        } else {
                                                                            phi_2953_ = lt_bvh_triangle_Intersection();
                                                                            phi_2954_ = true;
                                                                            phi_2955_ = false;
                                                                        }
                                                                        let _e2346 = phi_2953_;
                                                                        let _e2348 = phi_2954_;
                                                                        let _e2350 = phi_2955_;
                                                                        if _e2348 {
                                                                            phi_2959_ = true;
                                                                        } else {
                                                                            phi_2959_ = _e2350;
                                                                        }
                                                                        let _e2352 = phi_2959_;
                                                                        if _e2352 {
                                                                            phi_2963_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                        } else {
                                                                            phi_2963_ = _e2346;
                                                                        }
                                                                        let _e2354 = phi_2963_;
                                                                        if _e2354.is_hit {
                                                                            if (_e2354.t > 0f) {
                                                                                if (_e2354.t < _e231) {
                                                                                    let _e2361 = triangles.member[(0u + _e1991)].i0_;
                                                                                    let _e2363 = ((_e2361 & 2147483648u) == 0u);
                                                                                    if _e2363 {
                                                                                        phi_3186_ = false;
                                                                                        phi_3187_ = false;
                                                                                    } else {
                                                                                        if (_e1991 < _e82) {
                                                                                        } else {
                                                                                            return;
                                                                                        }
                                                                                        let _e2370 = triangles.member[(0u + _e1991)].i0_;
                                                                                        let _e2371 = (_e2370 & 2147483647u);
                                                                                        let _e2373 = triangles.member[(0u + _e1991)].i1_;
                                                                                        let _e2375 = triangles.member[(0u + _e1991)].i2_;
                                                                                        if (_e2371 < _e91) {
                                                                                        } else {
                                                                                            return;
                                                                                        }
                                                                                        let _e2379 = vertices.member[(0u + _e2371)];
                                                                                        if (_e2373 < _e91) {
                                                                                        } else {
                                                                                            return;
                                                                                        }
                                                                                        let _e2383 = vertices.member[(0u + _e2373)];
                                                                                        if (_e2375 < _e91) {
                                                                                        } else {
                                                                                            return;
                                                                                        }
                                                                                        let _e2387 = vertices.member[(0u + _e2375)];
                                                                                        let _e2388 = array<abi_Vertex, 3>(_e2379, _e2383, _e2387);
                                                                                        if (_e2388[0].material < arrayLength((&materials.member))) {
                                                                                        } else {
                                                                                            return;
                                                                                        }
                                                                                        let _e2394 = materials.member[(0u + _e2388[0].material)];
                                                                                        if ((_e2394.flags & 1u) == 1u) {
                                                                                            let _e2399 = ((1f - _e2354.u) - _e2354.v);
                                                                                            if (_e2394.cutoff <= 0f) {
                                                                                                phi_3180_ = true;
                                                                                            } else {
                                                                                                let _e2426 = (_e2394.base_color.w * ((((f32((_e2388[0].color >> bitcast<u32>(24i))) * _e2399) + (f32((_e2388[1].color >> bitcast<u32>(24i))) * _e2354.u)) + (f32((_e2388[2].color >> bitcast<u32>(24i))) * _e2354.v)) * (1f / 255f)));
                                                                                                if (_e2394.alpha_size == 0u) {
                                                                                                    phi_3177_ = _e2426;
                                                                                                } else {
                                                                                                    local.offset = _e2394.alpha_offset;
                                                                                                    local.size = _e2394.alpha_size;
                                                                                                    local.flags = _e2394.flags;
                                                                                                    let _e2457 = _lt_shaders_texture_TextureView_quad((&local), (((_e2388[0].u * _e2399) + (_e2388[1].u * _e2354.u)) + (_e2388[2].u * _e2354.v)), (((_e2388[0].v * _e2399) + (_e2388[1].v * _e2354.u)) + (_e2388[2].v * _e2354.v)));
                                                                                                    let _e2461 = (_e2457.indices[0] >> bitcast<u32>(2i));
                                                                                                    if (_e2461 < _e97) {
                                                                                                    } else {
                                                                                                        return;
                                                                                                    }
                                                                                                    let _e2465 = alpha_texels.member[(0u + _e2461)];
                                                                                                    let _e2481 = (_e2457.indices[1] >> bitcast<u32>(2i));
                                                                                                    if (_e2481 < _e97) {
                                                                                                    } else {
                                                                                                        return;
                                                                                                    }
                                                                                                    let _e2485 = alpha_texels.member[(0u + _e2481)];
                                                                                                    let _e2502 = (_e2457.indices[2] >> bitcast<u32>(2i));
                                                                                                    if (_e2502 < _e97) {
                                                                                                    } else {
                                                                                                        return;
                                                                                                    }
                                                                                                    let _e2506 = alpha_texels.member[(0u + _e2502)];
                                                                                                    let _e2523 = (_e2457.indices[3] >> bitcast<u32>(2i));
                                                                                                    if (_e2523 < _e97) {
                                                                                                    } else {
                                                                                                        return;
                                                                                                    }
                                                                                                    let _e2527 = alpha_texels.member[(0u + _e2523)];
                                                                                                    phi_3177_ = (_e2426 * (((((f32(((_e2465 >> bitcast<u32>((((_e2457.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2457.weights.x) + ((f32(((_e2485 >> bitcast<u32>((((_e2457.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2457.weights.y)) + ((f32(((_e2506 >> bitcast<u32>((((_e2457.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2457.weights.z)) + ((f32(((_e2527 >> bitcast<u32>((((_e2457.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2457.weights.w)));
                                                                                                }
                                                                                                let _e2543 = phi_3177_;
                                                                                                phi_3180_ = (_e2543 >= _e2394.cutoff);
                                                                                            }
                                                                                            let _e2547 = phi_3180_;
                                                                                            phi_3181_ = _e2547;
                                                                                        } else {
                                                                                            phi_3181_ = false;
                                                                                        }
                                                                                        let _e2549 = phi_3181_;
                                                                                        if _e2549 {
                                                                                            phi_3185_ = false;
                                                                                        } else {
                                                                                            phi_3185_ = true;
                                                                                        }
                                                                                        let _e2551 = phi_3185_;
                                                                                        phi_3186_ = _e2551;
                                                                                        phi_3187_ = _e2549;
                                                                                    }
                                                                                    let _e2553 = phi_3186_;
                                                                                    let _e2555 = phi_3187_;
                                                                                    phi_3188_ = _e2553;
                                                                                    phi_3189_ = _e2363;
                                                                                    phi_3190_ = _e2555;
                                                                                } else {
                                                                                    phi_3188_ = true;
                                                                                    phi_3189_ = false;
                                                                                    phi_3190_ = false;
                                                                                }
                                                                                let _e2557 = phi_3188_;
                                                                                let _e2559 = phi_3189_;
                                                                                let _e2561 = phi_3190_;
                                                                                phi_3191_ = _e2557;
                                                                                phi_3192_ = _e2559;
                                                                                phi_3193_ = _e2561;
                                                                            } else {
                                                                                phi_3191_ = true;
                                                                                phi_3192_ = false;
                                                                                phi_3193_ = false;
                                                                            }
                                                                            let _e2563 = phi_3191_;
                                                                            let _e2565 = phi_3192_;
                                                                            let _e2567 = phi_3193_;
                                                                            phi_3194_ = _e2563;
                                                                            phi_3195_ = _e2565;
                                                                            phi_3196_ = _e2567;
                                                                        } else {
                                                                            phi_3194_ = true;
                                                                            phi_3195_ = false;
                                                                            phi_3196_ = false;
                                                                        }
                                                                        let _e2569 = phi_3194_;
                                                                        let _e2571 = phi_3195_;
                                                                        let _e2573 = phi_3196_;
                                                                        if _e2569 {
                                                                            phi_3200_ = false;
                                                                            phi_3201_ = false;
                                                                        } else {
                                                                            phi_3200_ = _e2571;
                                                                            phi_3201_ = _e2573;
                                                                        }
                                                                        let _e2575 = phi_3200_;
                                                                        let _e2577 = phi_3201_;
                                                                        phi_2492_ = (_e1982 & (_e1982 - 1u));
                                                                        phi_3202_ = _e2569;
                                                                        phi_3203_ = _e2575;
                                                                        phi_3204_ = _e2577;
                                                                    }
                                                                    let _e2579 = phi_2492_;
                                                                    let _e2581 = phi_3202_;
                                                                    let _e2583 = phi_3203_;
                                                                    let _e2585 = phi_3204_;
                                                                    local_14 = _e2583;
                                                                    local_15 = _e2585;
                                                                    continue;
                                                                    continuing {
                                                                        phi_2491_ = _e2579;
                                                                        break if !(_e2581);
                                                                    }
                                                                }
                                                                let _e2588 = local_10;
                                                                if _e2588 {
                                                                    let _e2590 = local_1.group_mask;
                                                                    if ((_e2590 & 4278190080u) == 0u) {
                                                                        let _e2594 = local_1.len;
                                                                        if (_e2594 == 0u) {
                                                                            phi_3246_ = false;
                                                                        } else {
                                                                            let _e2598 = local_1.len;
                                                                            local_1.len = (_e2598 - 1u);
                                                                            let _e2601 = local_1.len;
                                                                            if (_e2601 < 32u) {
                                                                            } else {
                                                                                return;
                                                                            }
                                                                            let _e2606 = local_1.first[(0u + _e2601)];
                                                                            local_1.group = _e2606;
                                                                            let _e2609 = local_1.len;
                                                                            if (_e2609 < 32u) {
                                                                            } else {
                                                                                return;
                                                                            }
                                                                            let _e2614 = local_1.mask[(0u + _e2609)];
                                                                            local_1.group_mask = _e2614;
                                                                            phi_3246_ = true;
                                                                        }
                                                                        let _e2617 = phi_3246_;
                                                                        phi_3247_ = _e2617;
                                                                    } else {
                                                                        phi_3247_ = true;
                                                                    }
                                                                    let _e2619 = phi_3247_;
                                                                    if _e2619 {
                                                                        let _e2621 = local_1.group_mask;
                                                                        let _e2627 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2621)), 32u, (_e2621 == 0u)));
                                                                        let _e2631 = local_1.group_mask;
                                                                        let _e2645 = local_1.group_mask;
                                                                        local_1.group_mask = (_e2645 & ~((1u << bitcast<u32>((_e2627 & 31u)))));
                                                                        let _e2648 = local_1.group;
                                                                        phi_3278_ = (_e2648 + countOneBits(((_e2631 & ~((4294967295u << bitcast<u32>((((_e2627 - 24u) ^ _e1408) & 31u))))) & 255u)));
                                                                    } else {
                                                                        phi_3278_ = 4294967295u;
                                                                    }
                                                                    let _e2651 = phi_3278_;
                                                                    phi_3279_ = _e2651;
                                                                    phi_3280_ = false;
                                                                    phi_3281_ = false;
                                                                } else {
                                                                    phi_3279_ = u32();
                                                                    let _e3035 = local_14;
                                                                    phi_3280_ = _e3035;
                                                                    let _e3038 = local_15;
                                                                    phi_3281_ = _e3038;
                                                                }
                                                                let _e2653 = phi_3279_;
                                                                let _e2655 = phi_3280_;
                                                                let _e2657 = phi_3281_;
                                                                phi_2162_ = _e2653;
                                                                let _e3042 = local_16;
                                                                phi_3282_ = _e3042;
                                                                phi_3283_ = false;
                                                                phi_3284_ = _e2655;
                                                                phi_3285_ = _e2657;
                                                            } else {
                                                                phi_2162_ = u32();
                                                                phi_3282_ = false;
                                                                phi_3283_ = true;
                                                                phi_3284_ = false;
                                                                phi_3285_ = false;
                                                            }
                                                            let _e2659 = phi_2162_;
                                                            let _e2661 = phi_3282_;
                                                            let _e2663 = phi_3283_;
                                                            let _e2665 = phi_3284_;
                                                            let _e2667 = phi_3285_;
                                                            local_11 = _e2663;
                                                            local_17 = _e2665;
                                                            local_18 = _e2667;
                                                            continue;
                                                            continuing {
                                                                phi_2161_ = _e2659;
                                                                break if !(_e2661);
                                                            }
                                                        }
                                                        let _e2670 = local_11;
                                                        if _e2670 {
                                                            phi_3289_ = false;
                                                            phi_3290_ = false;
                                                        } else {
                                                            let _e3049 = local_17;
                                                            phi_3289_ = _e3049;
                                                            let _e3052 = local_18;
                                                            phi_3290_ = _e3052;
                                                        }
                                                        let _e2672 = phi_3289_;
                                                        let _e2674 = phi_3290_;
                                                        if _e2672 {
                                                            phi_3294_ = true;
                                                        } else {
                                                            phi_3294_ = _e2674;
                                                        }
                                                        let _e2676 = phi_3294_;
                                                        if _e2676 {
                                                            phi_3298_ = true;
                                                        } else {
                                                            phi_3298_ = false;
                                                        }
                                                        let _e2678 = phi_3298_;
                                                        phi_3299_ = _e2678;
                                                    }
                                                    let _e2680 = phi_3299_;
                                                    phi_3300_ = _e2680;
                                                    phi_3301_ = _e1234;
                                                } else {
                                                    phi_3300_ = bool();
                                                    phi_3301_ = true;
                                                }
                                                let _e2682 = phi_3300_;
                                                let _e2684 = phi_3301_;
                                                if _e2684 {
                                                    phi_3305_ = false;
                                                } else {
                                                    phi_3305_ = _e2682;
                                                }
                                                let _e2686 = phi_3305_;
                                                if _e2686 {
                                                    phi_3309_ = false;
                                                } else {
                                                    phi_3309_ = true;
                                                }
                                                let _e2688 = phi_3309_;
                                                phi_3310_ = _e2688;
                                            } else {
                                                phi_3310_ = true;
                                            }
                                            let _e2690 = phi_3310_;
                                            phi_3311_ = _e2690;
                                        } else {
                                            phi_3311_ = true;
                                        }
                                        let _e2692 = phi_3311_;
                                        phi_3312_ = _e2692;
                                    } else {
                                        phi_3312_ = true;
                                    }
                                    let _e2694 = phi_3312_;
                                    if _e2694 {
                                    }
                                    phi_1556_ = (_e1021 & (_e1021 - 1u));
                                    phi_3316_ = _e2694;
                                }
                                let _e2696 = phi_1556_;
                                let _e2698 = phi_3316_;
                                continue;
                                continuing {
                                    phi_1555_ = _e2696;
                                    break if !(_e2698);
                                }
                            }
                            let _e2701 = local_12;
                            if _e2701 {
                                let _e2703 = local_2.group_mask;
                                if ((_e2703 & 4278190080u) == 0u) {
                                    let _e2707 = local_2.len;
                                    if (_e2707 == 0u) {
                                        phi_3358_ = false;
                                    } else {
                                        let _e2711 = local_2.len;
                                        local_2.len = (_e2711 - 1u);
                                        let _e2714 = local_2.len;
                                        if (_e2714 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e2719 = local_2.first[(0u + _e2714)];
                                        local_2.group = _e2719;
                                        let _e2722 = local_2.len;
                                        if (_e2722 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e2727 = local_2.mask[(0u + _e2722)];
                                        local_2.group_mask = _e2727;
                                        phi_3358_ = true;
                                    }
                                    let _e2730 = phi_3358_;
                                    phi_3359_ = _e2730;
                                } else {
                                    phi_3359_ = true;
                                }
                                let _e2732 = phi_3359_;
                                if _e2732 {
                                    let _e2734 = local_2.group_mask;
                                    let _e2740 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2734)), 32u, (_e2734 == 0u)));
                                    let _e2744 = local_2.group_mask;
                                    let _e2758 = local_2.group_mask;
                                    local_2.group_mask = (_e2758 & ~((1u << bitcast<u32>((_e2740 & 31u)))));
                                    let _e2761 = local_2.group;
                                    phi_3390_ = (_e2761 + countOneBits(((_e2744 & ~((4294967295u << bitcast<u32>((((_e2740 - 24u) ^ _e447) & 31u))))) & 255u)));
                                } else {
                                    phi_3390_ = 4294967295u;
                                }
                                let _e2764 = phi_3390_;
                                phi_3391_ = _e2764;
                            } else {
                                phi_3391_ = u32();
                            }
                            let _e2766 = phi_3391_;
                            phi_1226_ = _e2766;
                            let _e3073 = local_19;
                            phi_3392_ = _e3073;
                            phi_3393_ = false;
                        } else {
                            phi_1226_ = u32();
                            phi_3392_ = false;
                            phi_3393_ = true;
                        }
                        let _e2768 = phi_1226_;
                        let _e2770 = phi_3392_;
                        let _e2772 = phi_3393_;
                        local_13 = _e2772;
                        continue;
                        continuing {
                            phi_1225_ = _e2768;
                            break if !(_e2770);
                        }
                    }
                    let _e2775 = local_13;
                    if _e2775 {
                        phi_3397_ = false;
                    } else {
                        phi_3397_ = true;
                    }
                    let _e2777 = phi_3397_;
                    if _e2777 {
                        phi_3401_ = true;
                    } else {
                        phi_3401_ = false;
                    }
                    let _e2779 = phi_3401_;
                    phi_3402_ = _e2779;
                }
                let _e2781 = phi_3402_;
                phi_3403_ = _e2781;
                phi_3404_ = _e303;
            } else {
                phi_3403_ = bool();
                phi_3404_ = true;
            }
            let _e2783 = phi_3403_;
            let _e2785 = phi_3404_;
            if _e2785 {
                phi_3408_ = false;
            } else {
                phi_3408_ = _e2783;
            }
            let _e2787 = phi_3408_;
            if _e2787 {
                phi_3412_ = 0f;
            } else {
                phi_3412_ = 1f;
            }
            let _e2789 = phi_3412_;
            phi_3413_ = _e2789;
        }
        let _e2791 = phi_3413_;
        if (_e103.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e103.first_primitive)] = _e2791;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_resolve_resolve_all_instanced_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
