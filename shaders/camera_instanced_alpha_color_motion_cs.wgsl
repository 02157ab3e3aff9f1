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

struct type_59 {
    member: array<lt_bvh_Instance>,
}

struct type_63 {
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

var<private> id_1: vec3<u32>;
@group(0) @binding(3) 
var<storage> vertices: type_44;
@group(0) @binding(4) 
var<storage> materials: type_48;
@group(0) @binding(0) 
var<uniform> p: type_63;
@group(0) @binding(1) 
var<storage> nodes: type_36;
@group(0) @binding(2) 
var<storage> triangles: type_40;
@group(0) @binding(5) 
var<storage, read_write> samples: type_20;
@group(0) @binding(6) 
var<storage> instances: type_59;
@group(0) @binding(7) 
var<storage> alpha_texels: type_9;
@group(0) @binding(8) 
var<storage> color_texels: type_9;
@group(0) @binding(9) 
var<storage> before: type_28;
@group(0) @binding(10) 
var<storage, read_write> past: type_28;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_232_: lt_bvh_traverse_Tree;
    var phi_233_: bool;
    var phi_234_: lt_bvh_traverse_Tree;
    var phi_235_: bool;
    var phi_240_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_232_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_233_ = false;
        } else {
            phi_232_ = lt_bvh_traverse_Tree();
            phi_233_ = true;
        }
        let _e86 = phi_232_;
        let _e88 = phi_233_;
        phi_234_ = _e86;
        phi_235_ = _e88;
    } else {
        phi_234_ = lt_bvh_traverse_Tree();
        phi_235_ = true;
    }
    let _e90 = phi_234_;
    let _e92 = phi_235_;
    if _e92 {
        phi_240_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_240_ = _e90;
    }
    let _e97 = phi_240_;
    return lt_bvh_traverse_Tree(_e97.root, _e97.first_primitive);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_255_: bool;
    var phi_259_: f32;

    if (param_3 != param_3) {
        phi_255_ = true;
    } else {
        let _e76 = (param_4 >= param_3);
        if _e76 {
        }
        phi_255_ = _e76;
    }
    let _e78 = phi_255_;
    if _e78 {
        phi_259_ = param_4;
    } else {
        phi_259_ = param_3;
    }
    let _e80 = phi_259_;
    return _e80;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_271_: bool;
    var phi_275_: f32;

    if (param_5 != param_5) {
        phi_271_ = true;
    } else {
        let _e76 = (param_6 <= param_5);
        if _e76 {
        }
        phi_271_ = _e76;
    }
    let _e78 = phi_271_;
    if _e78 {
        phi_275_ = param_6;
    } else {
        phi_275_ = param_5;
    }
    let _e80 = phi_275_;
    return _e80;
}

fn _lt_shaders_texture_TextureView_quad(param_7: ptr<function, texture_TextureView>, param_8: f32, param_9: f32) -> texture_TexelQuad {
    var phi_317_: f32;
    var phi_322_: f32;
    var phi_323_: bool;
    var phi_324_: f32;
    var phi_325_: bool;
    var phi_329_: f32;
    var phi_355_: f32;
    var phi_360_: f32;
    var phi_361_: bool;
    var phi_362_: f32;
    var phi_363_: bool;
    var phi_367_: f32;
    var phi_375_: f32;
    var phi_376_: f32;
    var phi_377_: f32;
    var phi_386_: f32;
    var phi_387_: f32;
    var phi_405_: u32;
    var phi_419_: u32;
    var phi_426_: u32;
    var phi_431_: u32;
    var phi_437_: u32;
    var phi_442_: u32;
    var phi_444_: texture_Axis;
    var phi_472_: f32;
    var phi_477_: f32;
    var phi_478_: bool;
    var phi_479_: f32;
    var phi_480_: bool;
    var phi_484_: f32;
    var phi_510_: f32;
    var phi_515_: f32;
    var phi_516_: bool;
    var phi_517_: f32;
    var phi_518_: bool;
    var phi_522_: f32;
    var phi_530_: f32;
    var phi_531_: f32;
    var phi_532_: f32;
    var phi_541_: f32;
    var phi_542_: f32;
    var phi_560_: u32;
    var phi_574_: u32;
    var phi_581_: u32;
    var phi_586_: u32;
    var phi_592_: u32;
    var phi_597_: u32;
    var phi_599_: texture_Axis;

    let _e77 = (*param_7).size;
    let _e78 = (_e77 & 65535u);
    let _e80 = (*param_7).size;
    let _e82 = (_e80 >> bitcast<u32>(16i));
    let _e84 = (*param_7).flags;
    let _e86 = ((_e84 & 4u) != 0u);
    let _e88 = (*param_7).flags;
    let _e91 = ((_e88 >> bitcast<u32>(4u)) & 3u);
    if (_e91 == 0u) {
        if (param_8 > -8388608f) {
            let _e104 = f32(select(0i, select(select(i32(param_8), i32(-2147483648), (param_8 < bitcast<f32>(3472883712u))), 2147483647i, (param_8 > bitcast<f32>(1325400063u))), (param_8 == param_8)));
            if (_e104 > param_8) {
                phi_317_ = 1f;
            } else {
                phi_317_ = 0f;
            }
            let _e107 = phi_317_;
            if (param_8 < 8388608f) {
                phi_322_ = (_e104 - _e107);
                phi_323_ = false;
            } else {
                phi_322_ = f32();
                phi_323_ = true;
            }
            let _e110 = phi_322_;
            let _e112 = phi_323_;
            phi_324_ = _e110;
            phi_325_ = _e112;
        } else {
            phi_324_ = f32();
            phi_325_ = true;
        }
        let _e114 = phi_324_;
        let _e116 = phi_325_;
        if _e116 {
            phi_329_ = param_8;
        } else {
            phi_329_ = _e114;
        }
        let _e118 = phi_329_;
        phi_377_ = (param_8 - _e118);
    } else {
        if (_e91 == 1u) {
            let _e121 = (param_8 * 0.5f);
            if (_e121 > -8388608f) {
                let _e133 = f32(select(0i, select(select(i32(_e121), i32(-2147483648), (_e121 < bitcast<f32>(3472883712u))), 2147483647i, (_e121 > bitcast<f32>(1325400063u))), (_e121 == _e121)));
                if (_e133 > _e121) {
                    phi_355_ = 1f;
                } else {
                    phi_355_ = 0f;
                }
                let _e136 = phi_355_;
                if (_e121 < 8388608f) {
                    phi_360_ = (_e133 - _e136);
                    phi_361_ = false;
                } else {
                    phi_360_ = f32();
                    phi_361_ = true;
                }
                let _e139 = phi_360_;
                let _e141 = phi_361_;
                phi_362_ = _e139;
                phi_363_ = _e141;
            } else {
                phi_362_ = f32();
                phi_363_ = true;
            }
            let _e143 = phi_362_;
            let _e145 = phi_363_;
            if _e145 {
                phi_367_ = _e121;
            } else {
                phi_367_ = _e143;
            }
            let _e147 = phi_367_;
            let _e149 = (param_8 - (2f * _e147));
            if (_e149 > 1f) {
                phi_375_ = (2f - _e149);
            } else {
                phi_375_ = _e149;
            }
            let _e153 = phi_375_;
            phi_376_ = _e153;
        } else {
            phi_376_ = param_8;
        }
        let _e155 = phi_376_;
        phi_377_ = _e155;
    }
    let _e157 = phi_377_;
    if (_e157 > 0f) {
        if (_e157 < 1f) {
            phi_386_ = _e157;
        } else {
            phi_386_ = 1f;
        }
        let _e161 = phi_386_;
        phi_387_ = _e161;
    } else {
        phi_387_ = 0f;
    }
    let _e163 = phi_387_;
    let _e164 = (_e78 - 1u);
    let _e166 = (_e163 * f32(_e78));
    if _e86 {
        let _e173 = select(select(u32(_e166), 0u, (_e166 < bitcast<f32>(0u))), 4294967295u, (_e166 > bitcast<f32>(1333788671u)));
        if (_e164 < _e173) {
            phi_405_ = _e164;
        } else {
            phi_405_ = _e173;
        }
        let _e176 = phi_405_;
        phi_444_ = texture_Axis(_e176, _e176, 0f);
    } else {
        let _e178 = (_e166 + 0.5f);
        let _e185 = select(select(u32(_e178), 0u, (_e178 < bitcast<f32>(0u))), 4294967295u, (_e178 > bitcast<f32>(1333788671u)));
        if (_e78 < _e185) {
            phi_419_ = _e78;
        } else {
            phi_419_ = _e185;
        }
        let _e188 = phi_419_;
        if (_e91 == 0u) {
            phi_426_ = _e164;
        } else {
            phi_426_ = 0u;
        }
        let _e193 = phi_426_;
        if (_e91 == 0u) {
            phi_431_ = 0u;
        } else {
            phi_431_ = _e164;
        }
        let _e196 = phi_431_;
        if (_e188 == 0u) {
            phi_437_ = _e193;
        } else {
            phi_437_ = (_e188 - 1u);
        }
        let _e200 = phi_437_;
        if (_e188 > _e164) {
            phi_442_ = _e196;
        } else {
            phi_442_ = _e188;
        }
        let _e203 = phi_442_;
        phi_444_ = texture_Axis(_e200, _e203, (_e178 - f32(_e188)));
    }
    let _e206 = phi_444_;
    let _e208 = (*param_7).flags;
    let _e211 = ((_e208 >> bitcast<u32>(6u)) & 3u);
    if (_e211 == 0u) {
        if (param_9 > -8388608f) {
            let _e224 = f32(select(0i, select(select(i32(param_9), i32(-2147483648), (param_9 < bitcast<f32>(3472883712u))), 2147483647i, (param_9 > bitcast<f32>(1325400063u))), (param_9 == param_9)));
            if (_e224 > param_9) {
                phi_472_ = 1f;
            } else {
                phi_472_ = 0f;
            }
            let _e227 = phi_472_;
            if (param_9 < 8388608f) {
                phi_477_ = (_e224 - _e227);
                phi_478_ = false;
            } else {
                phi_477_ = f32();
                phi_478_ = true;
            }
            let _e230 = phi_477_;
            let _e232 = phi_478_;
            phi_479_ = _e230;
            phi_480_ = _e232;
        } else {
            phi_479_ = f32();
            phi_480_ = true;
        }
        let _e234 = phi_479_;
        let _e236 = phi_480_;
        if _e236 {
            phi_484_ = param_9;
        } else {
            phi_484_ = _e234;
        }
        let _e238 = phi_484_;
        phi_532_ = (param_9 - _e238);
    } else {
        if (_e211 == 1u) {
            let _e241 = (param_9 * 0.5f);
            if (_e241 > -8388608f) {
                let _e253 = f32(select(0i, select(select(i32(_e241), i32(-2147483648), (_e241 < bitcast<f32>(3472883712u))), 2147483647i, (_e241 > bitcast<f32>(1325400063u))), (_e241 == _e241)));
                if (_e253 > _e241) {
                    phi_510_ = 1f;
                } else {
                    phi_510_ = 0f;
                }
                let _e256 = phi_510_;
                if (_e241 < 8388608f) {
                    phi_515_ = (_e253 - _e256);
                    phi_516_ = false;
                } else {
                    phi_515_ = f32();
                    phi_516_ = true;
                }
                let _e259 = phi_515_;
                let _e261 = phi_516_;
                phi_517_ = _e259;
                phi_518_ = _e261;
            } else {
                phi_517_ = f32();
                phi_518_ = true;
            }
            let _e263 = phi_517_;
            let _e265 = phi_518_;
            if _e265 {
                phi_522_ = _e241;
            } else {
                phi_522_ = _e263;
            }
            let _e267 = phi_522_;
            let _e269 = (param_9 - (2f * _e267));
            if (_e269 > 1f) {
                phi_530_ = (2f - _e269);
            } else {
                phi_530_ = _e269;
            }
            let _e273 = phi_530_;
            phi_531_ = _e273;
        } else {
            phi_531_ = param_9;
        }
        let _e275 = phi_531_;
        phi_532_ = _e275;
    }
    let _e277 = phi_532_;
    if (_e277 > 0f) {
        if (_e277 < 1f) {
            phi_541_ = _e277;
        } else {
            phi_541_ = 1f;
        }
        let _e281 = phi_541_;
        phi_542_ = _e281;
    } else {
        phi_542_ = 0f;
    }
    let _e283 = phi_542_;
    let _e284 = (_e82 - 1u);
    let _e286 = (_e283 * f32(_e82));
    if _e86 {
        let _e293 = select(select(u32(_e286), 0u, (_e286 < bitcast<f32>(0u))), 4294967295u, (_e286 > bitcast<f32>(1333788671u)));
        if (_e284 < _e293) {
            phi_560_ = _e284;
        } else {
            phi_560_ = _e293;
        }
        let _e296 = phi_560_;
        phi_599_ = texture_Axis(_e296, _e296, 0f);
    } else {
        let _e298 = (_e286 + 0.5f);
        let _e305 = select(select(u32(_e298), 0u, (_e298 < bitcast<f32>(0u))), 4294967295u, (_e298 > bitcast<f32>(1333788671u)));
        if (_e82 < _e305) {
            phi_574_ = _e82;
        } else {
            phi_574_ = _e305;
        }
        let _e308 = phi_574_;
        if (_e211 == 0u) {
            phi_581_ = _e284;
        } else {
            phi_581_ = 0u;
        }
        let _e313 = phi_581_;
        if (_e211 == 0u) {
            phi_586_ = 0u;
        } else {
            phi_586_ = _e284;
        }
        let _e316 = phi_586_;
        if (_e308 == 0u) {
            phi_592_ = _e313;
        } else {
            phi_592_ = (_e308 - 1u);
        }
        let _e320 = phi_592_;
        if (_e308 > _e284) {
            phi_597_ = _e316;
        } else {
            phi_597_ = _e308;
        }
        let _e323 = phi_597_;
        phi_599_ = texture_Axis(_e320, _e323, (_e298 - f32(_e308)));
    }
    let _e326 = phi_599_;
    let _e330 = (*param_7).offset;
    let _e337 = (*param_7).offset;
    let _e344 = (*param_7).offset;
    let _e351 = (*param_7).offset;
    return texture_TexelQuad(array<u32, 4>(((_e330 + (_e326.low * _e78)) + _e206.low), ((_e337 + (_e326.low * _e78)) + _e206.high), ((_e344 + (_e326.high * _e78)) + _e206.low), ((_e351 + (_e326.high * _e78)) + _e206.high)), vec4<f32>(((1f - _e206.fraction) * (1f - _e326.fraction)), (_e206.fraction * (1f - _e326.fraction)), ((1f - _e206.fraction) * _e326.fraction), (_e206.fraction * _e326.fraction)));
}

fn _lt_bvh_ray_Ray_new(param_10: vec3<f32>, param_11: vec3<f32>) -> lt_bvh_Ray {
    return lt_bvh_Ray(param_10, 0f, param_11, 300000000000000000000000000000000000000f);
}

fn _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(param_12: f32, param_13: f32) -> f32 {
    var phi_658_: f32;

    if (param_12 > param_13) {
        phi_658_ = param_12;
    } else {
        phi_658_ = param_13;
    }
    let _e77 = phi_658_;
    return _e77;
}

fn function_() {
    var local: texture_TextureView;
    var local_1: texture_TextureView;
    var local_2: lt_bvh_traverse_Stack;
    var local_3: lt_bvh_traverse_Stack;
    var phi_816_: bool;
    var phi_817_: bool;
    var phi_818_: bool;
    var phi_819_: bool;
    var phi_823_: bool;
    var phi_836_: bool;
    var phi_837_: bool;
    var phi_838_: bool;
    var phi_839_: bool;
    var phi_843_: bool;
    var phi_856_: bool;
    var phi_857_: bool;
    var phi_858_: bool;
    var phi_862_: bool;
    var phi_863_: bool;
    var phi_864_: bool;
    var phi_865_: bool;
    var phi_866_: bool;
    var phi_870_: bool;
    var phi_946_: f32;
    var phi_953_: f32;
    var phi_961_: f32;
    var phi_968_: f32;
    var phi_976_: f32;
    var phi_983_: f32;
    var phi_1006_: f32;
    var phi_1011_: f32;
    var phi_1016_: f32;
    var phi_1021_: f32;
    var phi_1026_: f32;
    var phi_1045_: u32;
    var phi_1050_: u32;
    var phi_1055_: u32;
    var phi_1169_: bool;
    var phi_1170_: bool;
    var phi_1201_: u32;
    var phi_1203_: u32;
    var phi_1206_: lt_bvh_Hit;
    var phi_1291_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1318_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1345_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1351_: u32;
    var phi_1354_: u32;
    var phi_1368_: u32;
    var phi_1378_: u32;
    var phi_1388_: u32;
    var phi_1406_: u32;
    var phi_1416_: u32;
    var phi_1426_: u32;
    var phi_1462_: u32;
    var phi_1475_: u32;
    var phi_1480_: u32;
    var phi_1481_: u32;
    var phi_1482_: u32;
    var phi_1352_: u32;
    var phi_1355_: u32;
    var local_4: u32;
    var local_5: u32;
    var local_6: u32;
    var phi_1540_: u32;
    var phi_1543_: lt_bvh_Hit;
    var phi_1598_: f32;
    var phi_1603_: f32;
    var phi_1608_: f32;
    var phi_1616_: f32;
    var phi_1621_: f32;
    var phi_1626_: f32;
    var phi_1758_: bool;
    var phi_1759_: bool;
    var phi_1760_: bool;
    var phi_1761_: bool;
    var phi_1765_: bool;
    var phi_1778_: bool;
    var phi_1779_: bool;
    var phi_1780_: bool;
    var phi_1781_: bool;
    var phi_1785_: bool;
    var phi_1798_: bool;
    var phi_1799_: bool;
    var phi_1800_: bool;
    var phi_1804_: bool;
    var phi_1805_: bool;
    var phi_1806_: bool;
    var phi_1807_: bool;
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
    var phi_1949_: f32;
    var phi_1954_: f32;
    var phi_1980_: bool;
    var phi_1981_: bool;
    var phi_1989_: u32;
    var phi_1990_: u32;
    var phi_2001_: vec3<f32>;
    var phi_2002_: vec3<f32>;
    var phi_2015_: u32;
    var phi_2020_: u32;
    var phi_2025_: u32;
    var phi_2139_: bool;
    var phi_2140_: bool;
    var phi_2171_: u32;
    var phi_2173_: lt_bvh_Hit;
    var phi_2176_: u32;
    var phi_2257_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2284_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2311_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2317_: u32;
    var phi_2320_: u32;
    var phi_2334_: u32;
    var phi_2344_: u32;
    var phi_2354_: u32;
    var phi_2372_: u32;
    var phi_2382_: u32;
    var phi_2392_: u32;
    var phi_2428_: u32;
    var phi_2441_: u32;
    var phi_2446_: u32;
    var phi_2447_: u32;
    var phi_2448_: u32;
    var phi_2318_: u32;
    var phi_2321_: u32;
    var local_7: u32;
    var local_8: u32;
    var local_9: u32;
    var phi_2506_: lt_bvh_Hit;
    var phi_2509_: u32;
    var phi_2553_: vec3<f32>;
    var phi_2554_: vec3<f32>;
    var phi_2583_: vec3<f32>;
    var phi_2584_: vec3<f32>;
    var phi_2613_: vec3<f32>;
    var phi_2614_: vec3<f32>;
    var phi_2632_: bool;
    var phi_2633_: bool;
    var phi_2637_: f32;
    var phi_2638_: f32;
    var phi_2639_: f32;
    var phi_2640_: f32;
    var phi_2648_: f32;
    var phi_2658_: bool;
    var phi_2659_: bool;
    var phi_2663_: f32;
    var phi_2664_: f32;
    var phi_2665_: f32;
    var phi_2666_: f32;
    var phi_2674_: f32;
    var phi_2684_: bool;
    var phi_2685_: bool;
    var phi_2689_: f32;
    var phi_2690_: f32;
    var phi_2691_: f32;
    var phi_2692_: f32;
    var phi_2700_: f32;
    var phi_2715_: f32;
    var phi_2716_: bool;
    var phi_2717_: f32;
    var phi_2718_: bool;
    var phi_2719_: f32;
    var phi_2720_: bool;
    var phi_2738_: f32;
    var phi_2739_: bool;
    var phi_2740_: bool;
    var phi_2741_: f32;
    var phi_2742_: bool;
    var phi_2743_: bool;
    var phi_2747_: bool;
    var phi_2748_: f32;
    var phi_2749_: bool;
    var phi_2777_: vec3<f32>;
    var phi_2778_: vec3<f32>;
    var phi_2803_: vec3<f32>;
    var phi_2804_: vec3<f32>;
    var phi_2829_: vec3<f32>;
    var phi_2830_: vec3<f32>;
    var phi_2886_: f32;
    var phi_2895_: f32;
    var phi_2904_: f32;
    var phi_2913_: f32;
    var phi_2920_: f32;
    var phi_2927_: f32;
    var phi_2940_: f32;
    var phi_2949_: f32;
    var phi_2958_: f32;
    var phi_2967_: f32;
    var phi_2974_: f32;
    var phi_2981_: f32;
    var phi_2998_: f32;
    var phi_3003_: f32;
    var phi_3008_: f32;
    var phi_3016_: f32;
    var phi_3021_: f32;
    var phi_3026_: f32;
    var phi_3038_: f32;
    var phi_3043_: f32;
    var phi_3048_: f32;
    var phi_3053_: f32;
    var phi_3058_: lt_bvh_triangle_Intersection;
    var phi_3059_: bool;
    var phi_3060_: lt_bvh_triangle_Intersection;
    var phi_3061_: bool;
    var phi_3065_: lt_bvh_triangle_Intersection;
    var phi_3066_: bool;
    var phi_3067_: lt_bvh_triangle_Intersection;
    var phi_3068_: bool;
    var phi_3069_: bool;
    var phi_3073_: bool;
    var phi_3077_: lt_bvh_triangle_Intersection;
    var phi_3115_: bool;
    var phi_3116_: bool;
    var phi_3117_: bool;
    var phi_3118_: bool;
    var phi_3119_: bool;
    var phi_3120_: bool;
    var phi_3124_: bool;
    var phi_3125_: bool;
    var phi_3328_: f32;
    var phi_3331_: bool;
    var phi_3332_: bool;
    var phi_3336_: bool;
    var phi_3344_: lt_bvh_Hit;
    var phi_3345_: lt_bvh_Hit;
    var phi_3346_: lt_bvh_Hit;
    var phi_3347_: lt_bvh_Hit;
    var phi_2507_: lt_bvh_Hit;
    var phi_2510_: u32;
    var phi_3348_: bool;
    var phi_3387_: bool;
    var phi_3388_: bool;
    var phi_3419_: u32;
    var phi_2174_: lt_bvh_Hit;
    var phi_2177_: u32;
    var phi_3420_: lt_bvh_Hit;
    var phi_3421_: lt_bvh_Hit;
    var phi_3422_: bool;
    var phi_3426_: lt_bvh_Hit;
    var phi_3427_: lt_bvh_Hit;
    var phi_3428_: lt_bvh_Hit;
    var phi_3429_: lt_bvh_Hit;
    var phi_1541_: u32;
    var phi_1544_: lt_bvh_Hit;
    var phi_3430_: bool;
    var phi_3469_: bool;
    var phi_3470_: bool;
    var phi_3501_: u32;
    var phi_1204_: u32;
    var phi_1207_: lt_bvh_Hit;
    var phi_3502_: lt_bvh_Hit;
    var phi_3503_: lt_bvh_Hit;
    var phi_3504_: bool;
    var phi_3508_: lt_bvh_Hit;
    var phi_3695_: f32;
    var phi_3700_: f32;
    var phi_3705_: f32;
    var phi_3713_: f32;
    var phi_3718_: f32;
    var phi_3723_: f32;
    var phi_3787_: vec3<f32>;
    var phi_4030_: vec3<f32>;
    var phi_4045_: u32;
    var phi_4072_: f32;
    var phi_4079_: f32;
    var phi_4086_: f32;
    var phi_4121_: f32;
    var phi_4128_: f32;
    var phi_4135_: f32;
    var phi_4173_: f32;
    var phi_4180_: f32;
    var phi_4187_: f32;
    var phi_4273_: vec3<f32>;
    var phi_4274_: vec3<f32>;
    var phi_4275_: vec3<f32>;
    var phi_4284_: f32;
    var phi_4285_: f32;
    var phi_4295_: f32;
    var phi_4296_: f32;
    var phi_4306_: f32;
    var phi_4307_: f32;
    var phi_4342_: abi_Sample;
    var phi_4565_: vec3<f32>;
    var local_10: lt_bvh_Hit;
    var local_11: lt_bvh_Hit;
    var local_12: lt_bvh_Hit;
    var local_13: lt_bvh_Hit;

    let _e77 = id_1;
    let _e81 = arrayLength((&nodes.member));
    let _e84 = arrayLength((&triangles.member));
    let _e87 = arrayLength((&vertices.member));
    let _e90 = arrayLength((&materials.member));
    let _e96 = arrayLength((&instances.member));
    let _e99 = arrayLength((&alpha_texels.member));
    let _e102 = arrayLength((&color_texels.member));
    let _e105 = arrayLength((&before.member));
    let _e111 = p.member.size[0u];
    let _e113 = p.member.size[1u];
    let _e114 = lt_shaders_entry_pixel_index(_e77, _e111, _e113);
    if (bitcast<i32>(_e114.root) != 0i) {
        let _e120 = p.member.root;
        let _e124 = p.member.eye;
        let _e127 = p.member.grid[0u];
        let _e129 = p.member.grid[1u];
        let _e148 = p.member.size[0u];
        let _e152 = ((((f32(_e77.x) + ((f32((_e77.y & (_e129 - 1u))) + 0.5f) / f32(_e129))) / f32(_e148)) * 2f) - 1f);
        let _e155 = p.member.size[1u];
        let _e159 = (1f - (((f32(_e77.y) + ((f32((_e77.x & (_e127 - 1u))) + 0.5f) / f32(_e127))) / f32(_e155)) * 2f));
        let _e161 = p.member.forward;
        let _e163 = p.member.right;
        let _e177 = p.member.up;
        let _e188 = _lt_bvh_ray_Ray_new(_e124, vec3<f32>(((_e161.x + (_e163.x * _e152)) + (_e177.x * _e159)), ((_e161.y + (_e163.y * _e152)) + (_e177.y * _e159)), ((_e161.z + (_e163.z * _e152)) + (_e177.z * _e159))));
        let _e190 = lt_bvh_Hit(_e188.tmax, 0f, 0f, 4294967295u, 4294967295u);
        let _e193 = abs(_e188.direction.x);
        let _e195 = abs(_e188.direction.y);
        let _e197 = abs(_e188.direction.z);
        if (abs(_e188.origin.x) < 1000000000000000f) {
            if (abs(_e188.origin.y) < 1000000000000000f) {
                phi_816_ = (abs(_e188.origin.z) < 1000000000000000f);
                phi_817_ = false;
            } else {
                phi_816_ = bool();
                phi_817_ = true;
            }
            let _e209 = phi_816_;
            let _e211 = phi_817_;
            phi_818_ = _e209;
            phi_819_ = _e211;
        } else {
            phi_818_ = bool();
            phi_819_ = true;
        }
        let _e213 = phi_818_;
        let _e215 = phi_819_;
        if _e215 {
            phi_823_ = false;
        } else {
            phi_823_ = _e213;
        }
        let _e217 = phi_823_;
        if _e217 {
            if (_e193 < 1000000000000000f) {
                if (_e195 < 1000000000000000f) {
                    phi_836_ = (_e197 < 1000000000000000f);
                    phi_837_ = false;
                } else {
                    phi_836_ = bool();
                    phi_837_ = true;
                }
                let _e222 = phi_836_;
                let _e224 = phi_837_;
                phi_838_ = _e222;
                phi_839_ = _e224;
            } else {
                phi_838_ = bool();
                phi_839_ = true;
            }
            let _e226 = phi_838_;
            let _e228 = phi_839_;
            if _e228 {
                phi_843_ = false;
            } else {
                phi_843_ = _e226;
            }
            let _e230 = phi_843_;
            if _e230 {
                if (_e193 > 0f) {
                    phi_857_ = bool();
                    phi_858_ = true;
                } else {
                    let _e232 = (_e195 > 0f);
                    if _e232 {
                        phi_856_ = bool();
                    } else {
                        phi_856_ = (_e197 > 0f);
                    }
                    let _e235 = phi_856_;
                    phi_857_ = _e235;
                    phi_858_ = _e232;
                }
                let _e237 = phi_857_;
                let _e239 = phi_858_;
                if _e239 {
                    phi_862_ = true;
                } else {
                    phi_862_ = _e237;
                }
                let _e241 = phi_862_;
                phi_863_ = _e241;
                phi_864_ = false;
            } else {
                phi_863_ = bool();
                phi_864_ = true;
            }
            let _e243 = phi_863_;
            let _e245 = phi_864_;
            phi_865_ = _e243;
            phi_866_ = _e245;
        } else {
            phi_865_ = bool();
            phi_866_ = true;
        }
        let _e247 = phi_865_;
        let _e249 = phi_866_;
        if _e249 {
            phi_870_ = false;
        } else {
            phi_870_ = _e247;
        }
        let _e251 = phi_870_;
        if _e251 {
            let _e252 = (_e120 >= _e81);
            if _e252 {
                phi_3502_ = lt_bvh_Hit();
            } else {
                if (_e120 < _e81) {
                } else {
                    return;
                }
                let _e258 = nodes.member[(0u + _e120)].frame[0u];
                let _e262 = nodes.member[(0u + _e120)].frame[1u];
                let _e266 = nodes.member[(0u + _e120)].frame[2u];
                let _e270 = nodes.member[(0u + _e120)].frame[0u];
                let _e274 = nodes.member[(0u + _e120)].frame[1u];
                let _e278 = nodes.member[(0u + _e120)].frame[2u];
                let _e282 = nodes.member[(0u + _e120)].frame[3u];
                let _e321 = core_intrinsics_maximum_number_nsz_f32_(abs(_e188.direction.x), abs(_e188.direction.y));
                let _e322 = core_intrinsics_maximum_number_nsz_f32_(_e321, abs(_e188.direction.z));
                let _e323 = (_e322 * 0.0000000000009094947f);
                if (abs(_e188.direction.x) < _e323) {
                    phi_946_ = _e323;
                } else {
                    phi_946_ = abs(_e188.direction.x);
                }
                let _e329 = phi_946_;
                if (_e188.direction.x < 0f) {
                    phi_953_ = (-1f / _e329);
                } else {
                    phi_953_ = (1f / _e329);
                }
                let _e334 = phi_953_;
                if (abs(_e188.direction.y) < _e323) {
                    phi_961_ = _e323;
                } else {
                    phi_961_ = abs(_e188.direction.y);
                }
                let _e340 = phi_961_;
                if (_e188.direction.y < 0f) {
                    phi_968_ = (-1f / _e340);
                } else {
                    phi_968_ = (1f / _e340);
                }
                let _e345 = phi_968_;
                if (abs(_e188.direction.z) < _e323) {
                    phi_976_ = _e323;
                } else {
                    phi_976_ = abs(_e188.direction.z);
                }
                let _e351 = phi_976_;
                if (_e188.direction.z < 0f) {
                    phi_983_ = (-1f / _e351);
                } else {
                    phi_983_ = (1f / _e351);
                }
                let _e356 = phi_983_;
                let _e363 = abs((bitcast<f32>(_e258) - _e188.origin.x));
                let _e364 = abs((bitcast<f32>(_e262) - _e188.origin.y));
                let _e365 = abs((bitcast<f32>(_e266) - _e188.origin.z));
                let _e372 = abs(((bitcast<f32>(_e270) + (bitcast<f32>((((_e282 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e188.origin.x));
                let _e373 = abs(((bitcast<f32>(_e274) + (bitcast<f32>((((_e282 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e188.origin.y));
                let _e374 = abs(((bitcast<f32>(_e278) + (bitcast<f32>((((_e282 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e188.origin.z));
                if (_e363 > _e372) {
                    phi_1006_ = _e363;
                } else {
                    phi_1006_ = _e372;
                }
                let _e377 = phi_1006_;
                if (_e364 > _e373) {
                    phi_1011_ = _e364;
                } else {
                    phi_1011_ = _e373;
                }
                let _e380 = phi_1011_;
                if (_e365 > _e374) {
                    phi_1016_ = _e365;
                } else {
                    phi_1016_ = _e374;
                }
                let _e383 = phi_1016_;
                if (_e377 > _e380) {
                    phi_1021_ = _e377;
                } else {
                    phi_1021_ = _e380;
                }
                let _e386 = phi_1021_;
                if (_e386 > _e383) {
                    phi_1026_ = _e386;
                } else {
                    phi_1026_ = _e383;
                }
                let _e389 = phi_1026_;
                let _e393 = (_e389 * 0.0000019073486f);
                let _e394 = (abs(_e334) * _e393);
                let _e395 = (abs(_e345) * _e393);
                let _e396 = (abs(_e356) * _e393);
                let _e400 = (_e389 * 0.0000009536743f);
                let _e401 = (abs(_e334) * _e400);
                let _e402 = (abs(_e345) * _e400);
                let _e403 = (abs(_e356) * _e400);
                if (_e334 < 0f) {
                    phi_1045_ = 0u;
                } else {
                    phi_1045_ = 1u;
                }
                let _e406 = phi_1045_;
                if (_e345 < 0f) {
                    phi_1050_ = 0u;
                } else {
                    phi_1050_ = 2u;
                }
                let _e409 = phi_1050_;
                if (_e356 < 0f) {
                    phi_1055_ = 0u;
                } else {
                    phi_1055_ = 4u;
                }
                let _e412 = phi_1055_;
                let _e414 = ((_e406 | _e409) | _e412);
                let _e415 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e120, 2147483648u);
                local_3 = lt_bvh_traverse_Stack(array<u32, 32>(_e415.first[0], _e415.first[1], _e415.first[2], _e415.first[3], _e415.first[4], _e415.first[5], _e415.first[6], _e415.first[7], _e415.first[8], _e415.first[9], _e415.first[10], _e415.first[11], _e415.first[12], _e415.first[13], _e415.first[14], _e415.first[15], _e415.first[16], _e415.first[17], _e415.first[18], _e415.first[19], _e415.first[20], _e415.first[21], _e415.first[22], _e415.first[23], _e415.first[24], _e415.first[25], _e415.first[26], _e415.first[27], _e415.first[28], _e415.first[29], _e415.first[30], _e415.first[31]), array<u32, 32>(_e415.mask[0], _e415.mask[1], _e415.mask[2], _e415.mask[3], _e415.mask[4], _e415.mask[5], _e415.mask[6], _e415.mask[7], _e415.mask[8], _e415.mask[9], _e415.mask[10], _e415.mask[11], _e415.mask[12], _e415.mask[13], _e415.mask[14], _e415.mask[15], _e415.mask[16], _e415.mask[17], _e415.mask[18], _e415.mask[19], _e415.mask[20], _e415.mask[21], _e415.mask[22], _e415.mask[23], _e415.mask[24], _e415.mask[25], _e415.mask[26], _e415.mask[27], _e415.mask[28], _e415.mask[29], _e415.mask[30], _e415.mask[31]), _e415.len, _e415.group, _e415.group_mask);
                let _e489 = local_3.group_mask;
                if ((_e489 & 4278190080u) == 0u) {
                    let _e493 = local_3.len;
                    if (_e493 == 0u) {
                        phi_1169_ = false;
                    } else {
                        let _e497 = local_3.len;
                        local_3.len = (_e497 - 1u);
                        let _e500 = local_3.len;
                        if (_e500 < 32u) {
                        } else {
                            return;
                        }
                        let _e505 = local_3.first[(0u + _e500)];
                        local_3.group = _e505;
                        let _e508 = local_3.len;
                        if (_e508 < 32u) {
                        } else {
                            return;
                        }
                        let _e513 = local_3.mask[(0u + _e508)];
                        local_3.group_mask = _e513;
                        phi_1169_ = true;
                    }
                    let _e516 = phi_1169_;
                    phi_1170_ = _e516;
                } else {
                    phi_1170_ = true;
                }
                let _e518 = phi_1170_;
                if _e518 {
                    let _e520 = local_3.group_mask;
                    let _e526 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e520)), 32u, (_e520 == 0u)));
                    let _e530 = local_3.group_mask;
                    let _e544 = local_3.group_mask;
                    local_3.group_mask = (_e544 & ~((1u << bitcast<u32>((_e526 & 31u)))));
                    let _e547 = local_3.group;
                    phi_1201_ = (_e547 + countOneBits(((_e530 & ~((4294967295u << bitcast<u32>((((_e526 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1201_ = 4294967295u;
                }
                let _e550 = phi_1201_;
                phi_1203_ = _e550;
                phi_1206_ = _e190;
                loop {
                    let _e552 = phi_1203_;
                    let _e554 = phi_1206_;
                    local_13 = _e554;
                    let _e555 = (_e552 != 4294967295u);
                    if _e555 {
                        if (_e552 < _e81) {
                        } else {
                            return;
                        }
                        let _e563 = nodes.member[(0u + _e552)].frame[3u];
                        let _e588 = (bitcast<f32>((((_e563 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e334);
                        let _e589 = (bitcast<f32>((((_e563 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e345);
                        let _e590 = (bitcast<f32>((((_e563 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e356);
                        let _e593 = nodes.member[(0u + _e552)].frame[0u];
                        let _e597 = nodes.member[(0u + _e552)].frame[1u];
                        let _e601 = nodes.member[(0u + _e552)].frame[2u];
                        let _e609 = ((bitcast<f32>(_e593) - _e188.origin.x) * _e334);
                        let _e610 = ((bitcast<f32>(_e597) - _e188.origin.y) * _e345);
                        let _e611 = ((bitcast<f32>(_e601) - _e188.origin.z) * _e356);
                        let _e619 = nodes.member[(0u + _e552)].x;
                        if (_e334 < 0f) {
                            let _e630 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e619.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e636 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e630.unnamed.root, _e619.w), _e630.unnamed_1);
                            let _e642 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e636.unnamed, lt_bvh_traverse_Tree(_e619.x, _e636.unnamed_1.first_primitive));
                            phi_1291_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e642.unnamed, lt_bvh_traverse_Tree(_e642.unnamed_1.root, _e619.y));
                        } else {
                            let _e658 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e619.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e664 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e658.unnamed.root, _e619.y), _e658.unnamed_1);
                            let _e670 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e664.unnamed, lt_bvh_traverse_Tree(_e619.z, _e664.unnamed_1.first_primitive));
                            phi_1291_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e670.unnamed, lt_bvh_traverse_Tree(_e670.unnamed_1.root, _e619.w));
                        }
                        let _e678 = phi_1291_;
                        let _e688 = nodes.member[(0u + _e552)].y;
                        if (_e345 < 0f) {
                            let _e699 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e688.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e705 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e699.unnamed.root, _e688.w), _e699.unnamed_1);
                            let _e711 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e705.unnamed, lt_bvh_traverse_Tree(_e688.x, _e705.unnamed_1.first_primitive));
                            phi_1318_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e711.unnamed, lt_bvh_traverse_Tree(_e711.unnamed_1.root, _e688.y));
                        } else {
                            let _e727 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e688.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e733 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e727.unnamed.root, _e688.y), _e727.unnamed_1);
                            let _e739 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e733.unnamed, lt_bvh_traverse_Tree(_e688.z, _e733.unnamed_1.first_primitive));
                            phi_1318_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e739.unnamed, lt_bvh_traverse_Tree(_e739.unnamed_1.root, _e688.w));
                        }
                        let _e747 = phi_1318_;
                        let _e757 = nodes.member[(0u + _e552)].z;
                        if (_e356 < 0f) {
                            let _e768 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e757.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e774 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e768.unnamed.root, _e757.w), _e768.unnamed_1);
                            let _e780 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e774.unnamed, lt_bvh_traverse_Tree(_e757.x, _e774.unnamed_1.first_primitive));
                            phi_1345_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e780.unnamed, lt_bvh_traverse_Tree(_e780.unnamed_1.root, _e757.y));
                        } else {
                            let _e796 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e757.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e802 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e796.unnamed.root, _e757.y), _e796.unnamed_1);
                            let _e808 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e802.unnamed, lt_bvh_traverse_Tree(_e757.z, _e802.unnamed_1.first_primitive));
                            phi_1345_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e808.unnamed, lt_bvh_traverse_Tree(_e808.unnamed_1.root, _e757.w));
                        }
                        let _e816 = phi_1345_;
                        phi_1351_ = 0u;
                        phi_1354_ = 0u;
                        loop {
                            let _e826 = phi_1351_;
                            let _e828 = phi_1354_;
                            local_4 = _e828;
                            local_5 = _e828;
                            local_6 = _e828;
                            let _e829 = (_e826 < 8u);
                            if _e829 {
                                let _e831 = (_e826 >> bitcast<u32>(2i));
                                let _e832 = (_e826 & 3u);
                                if (_e831 == 0u) {
                                    phi_1368_ = _e678.unnamed.root;
                                } else {
                                    phi_1368_ = _e678.unnamed.first_primitive;
                                }
                                let _e835 = phi_1368_;
                                if (_e831 == 0u) {
                                    phi_1378_ = _e747.unnamed.root;
                                } else {
                                    phi_1378_ = _e747.unnamed.first_primitive;
                                }
                                let _e844 = phi_1378_;
                                if (_e831 == 0u) {
                                    phi_1388_ = _e816.unnamed.root;
                                } else {
                                    phi_1388_ = _e816.unnamed.first_primitive;
                                }
                                let _e853 = phi_1388_;
                                let _e866 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e835 >> bitcast<u32>(((_e832 * 8u) & 31u))) & 255u)) * _e588) + (_e609 - _e394)), ((f32(((_e844 >> bitcast<u32>(((_e832 * 8u) & 31u))) & 255u)) * _e589) + (_e610 - _e395)));
                                let _e867 = core_intrinsics_maximum_number_nsz_f32_(_e866, ((f32(((_e853 >> bitcast<u32>(((_e832 * 8u) & 31u))) & 255u)) * _e590) + (_e611 - _e396)));
                                if (_e831 == 0u) {
                                    phi_1406_ = _e678.unnamed_1.root;
                                } else {
                                    phi_1406_ = _e678.unnamed_1.first_primitive;
                                }
                                let _e870 = phi_1406_;
                                if (_e831 == 0u) {
                                    phi_1416_ = _e747.unnamed_1.root;
                                } else {
                                    phi_1416_ = _e747.unnamed_1.first_primitive;
                                }
                                let _e879 = phi_1416_;
                                if (_e831 == 0u) {
                                    phi_1426_ = _e816.unnamed_1.root;
                                } else {
                                    phi_1426_ = _e816.unnamed_1.first_primitive;
                                }
                                let _e888 = phi_1426_;
                                let _e901 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e870 >> bitcast<u32>(((_e832 * 8u) & 31u))) & 255u)) * _e588) + (_e609 + _e394)), ((f32(((_e879 >> bitcast<u32>(((_e832 * 8u) & 31u))) & 255u)) * _e589) + (_e610 + _e395)));
                                let _e902 = core_intrinsics_minimum_number_nsz_f32_(_e901, ((f32(((_e888 >> bitcast<u32>(((_e832 * 8u) & 31u))) & 255u)) * _e590) + (_e611 + _e396)));
                                if (_e867 <= _e902) {
                                    if (_e867 <= _e554.t) {
                                        if (_e902 >= _e188.tmin) {
                                            if (_e831 == 0u) {
                                                let _e909 = nodes.member[(0u + _e552)].links[2u];
                                                phi_1462_ = _e909;
                                            } else {
                                                let _e912 = nodes.member[(0u + _e552)].links[3u];
                                                phi_1462_ = _e912;
                                            }
                                            let _e914 = phi_1462_;
                                            let _e919 = ((_e914 >> bitcast<u32>(((_e832 * 8u) & 31u))) & 255u);
                                            let _e920 = (_e919 & 31u);
                                            if (_e920 >= 24u) {
                                                phi_1475_ = (24u + ((_e920 - 24u) ^ _e414));
                                            } else {
                                                phi_1475_ = _e920;
                                            }
                                            let _e926 = phi_1475_;
                                            phi_1480_ = (_e828 | ((_e919 >> bitcast<u32>(5i)) << bitcast<u32>((_e926 & 31u))));
                                        } else {
                                            phi_1480_ = _e828;
                                        }
                                        let _e934 = phi_1480_;
                                        phi_1481_ = _e934;
                                    } else {
                                        phi_1481_ = _e828;
                                    }
                                    let _e936 = phi_1481_;
                                    phi_1482_ = _e936;
                                } else {
                                    phi_1482_ = _e828;
                                }
                                let _e938 = phi_1482_;
                                phi_1352_ = (_e826 + 1u);
                                phi_1355_ = _e938;
                            } else {
                                phi_1352_ = u32();
                                phi_1355_ = u32();
                            }
                            let _e941 = phi_1352_;
                            let _e943 = phi_1355_;
                            continue;
                            continuing {
                                phi_1351_ = _e941;
                                phi_1354_ = _e943;
                                break if !(_e829);
                            }
                        }
                        let _e947 = nodes.member[(0u + _e552)].links[0u];
                        let _e951 = nodes.member[(0u + _e552)].frame[3u];
                        let _e955 = local_4;
                        if ((_e955 & 4278190080u) == 0u) {
                        } else {
                            let _e959 = local_3.group_mask;
                            if ((_e959 & 4278190080u) == 0u) {
                            } else {
                                let _e963 = local_3.len;
                                if (_e963 < 32u) {
                                    let _e966 = local_3.group;
                                    let _e968 = local_3.len;
                                    if (_e968 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_3.first[(0u + _e968)] = _e966;
                                    let _e974 = local_3.group_mask;
                                    let _e976 = local_3.len;
                                    if (_e976 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_3.mask[(0u + _e976)] = _e974;
                                    let _e983 = local_3.len;
                                    local_3.len = (_e983 + 1u);
                                }
                            }
                            local_3.group = (_e120 + _e947);
                            let _e987 = local_5;
                            local_3.group_mask = ((_e987 & 4278190080u) | (_e951 >> bitcast<u32>(24i)));
                        }
                        let _e992 = local_6;
                        phi_1540_ = (_e992 & 16777215u);
                        phi_1543_ = _e554;
                        loop {
                            let _e995 = phi_1540_;
                            let _e997 = phi_1543_;
                            local_12 = _e997;
                            if (_e995 == 0u) {
                                phi_1541_ = u32();
                                phi_1544_ = lt_bvh_Hit();
                                phi_3430_ = false;
                            } else {
                                let _e1001 = nodes.member[(0u + _e552)].links[1u];
                                let _e1005 = (_e1001 + select(firstTrailingBit(_e995), 32u, (_e995 == 0u)));
                                if (_e1005 < _e96) {
                                } else {
                                    return;
                                }
                                let _e1012 = instances.member[(0u + _e1005)].low_world;
                                let _e1014 = instances.member[(0u + _e1005)].high_world;
                                let _e1024 = ((_e1012.x - _e188.origin.x) * _e334);
                                let _e1025 = ((_e1012.y - _e188.origin.y) * _e345);
                                let _e1026 = ((_e1012.z - _e188.origin.z) * _e356);
                                let _e1036 = ((_e1014.x - _e188.origin.x) * _e334);
                                let _e1037 = ((_e1014.y - _e188.origin.y) * _e345);
                                let _e1038 = ((_e1014.z - _e188.origin.z) * _e356);
                                if (_e1024 < _e1036) {
                                    phi_1598_ = _e1024;
                                } else {
                                    phi_1598_ = _e1036;
                                }
                                let _e1041 = phi_1598_;
                                if (_e1025 < _e1037) {
                                    phi_1603_ = _e1025;
                                } else {
                                    phi_1603_ = _e1037;
                                }
                                let _e1044 = phi_1603_;
                                if (_e1026 < _e1038) {
                                    phi_1608_ = _e1026;
                                } else {
                                    phi_1608_ = _e1038;
                                }
                                let _e1047 = phi_1608_;
                                if (_e1024 > _e1036) {
                                    phi_1616_ = _e1024;
                                } else {
                                    phi_1616_ = _e1036;
                                }
                                let _e1053 = phi_1616_;
                                if (_e1025 > _e1037) {
                                    phi_1621_ = _e1025;
                                } else {
                                    phi_1621_ = _e1037;
                                }
                                let _e1056 = phi_1621_;
                                if (_e1026 > _e1038) {
                                    phi_1626_ = _e1026;
                                } else {
                                    phi_1626_ = _e1038;
                                }
                                let _e1059 = phi_1626_;
                                let _e1063 = core_intrinsics_maximum_number_nsz_f32_((_e1041 - _e401), (_e1044 - _e402));
                                let _e1064 = core_intrinsics_maximum_number_nsz_f32_(_e1063, (_e1047 - _e403));
                                let _e1065 = core_intrinsics_minimum_number_nsz_f32_((_e1053 + _e401), (_e1056 + _e402));
                                let _e1066 = core_intrinsics_minimum_number_nsz_f32_(_e1065, (_e1059 + _e403));
                                if (_e1064 <= _e1066) {
                                    if (_e1064 <= _e997.t) {
                                        if (_e1066 >= _e188.tmin) {
                                            let _e1078 = instances.member[(0u + _e1005)].world_to_object[0u];
                                            let _e1089 = ((((_e1078.x * _e188.origin.x) + (_e1078.y * _e188.origin.y)) + (_e1078.z * _e188.origin.z)) + (_e1078.w * 1f));
                                            let _e1091 = instances.member[(0u + _e1005)].world_to_object[1u];
                                            let _e1102 = ((((_e1091.x * _e188.origin.x) + (_e1091.y * _e188.origin.y)) + (_e1091.z * _e188.origin.z)) + (_e1091.w * 1f));
                                            let _e1104 = instances.member[(0u + _e1005)].world_to_object[2u];
                                            let _e1115 = ((((_e1104.x * _e188.origin.x) + (_e1104.y * _e188.origin.y)) + (_e1104.z * _e188.origin.z)) + (_e1104.w * 1f));
                                            let _e1122 = instances.member[(0u + _e1005)].world_to_object[0u];
                                            let _e1133 = ((((_e1122.x * _e188.direction.x) + (_e1122.y * _e188.direction.y)) + (_e1122.z * _e188.direction.z)) + (_e1122.w * 0f));
                                            let _e1135 = instances.member[(0u + _e1005)].world_to_object[1u];
                                            let _e1146 = ((((_e1135.x * _e188.direction.x) + (_e1135.y * _e188.direction.y)) + (_e1135.z * _e188.direction.z)) + (_e1135.w * 0f));
                                            let _e1148 = instances.member[(0u + _e1005)].world_to_object[2u];
                                            let _e1159 = ((((_e1148.x * _e188.direction.x) + (_e1148.y * _e188.direction.y)) + (_e1148.z * _e188.direction.z)) + (_e1148.w * 0f));
                                            let _e1164 = instances.member[(0u + _e1005)].root;
                                            let _e1166 = instances.member[(0u + _e1005)].first_triangle;
                                            let _e1167 = abs(_e1133);
                                            let _e1168 = abs(_e1146);
                                            let _e1169 = abs(_e1159);
                                            if (abs(_e1089) < 1000000000000000f) {
                                                if (abs(_e1102) < 1000000000000000f) {
                                                    phi_1758_ = (abs(_e1115) < 1000000000000000f);
                                                    phi_1759_ = false;
                                                } else {
                                                    phi_1758_ = bool();
                                                    phi_1759_ = true;
                                                }
                                                let _e1177 = phi_1758_;
                                                let _e1179 = phi_1759_;
                                                phi_1760_ = _e1177;
                                                phi_1761_ = _e1179;
                                            } else {
                                                phi_1760_ = bool();
                                                phi_1761_ = true;
                                            }
                                            let _e1181 = phi_1760_;
                                            let _e1183 = phi_1761_;
                                            if _e1183 {
                                                phi_1765_ = false;
                                            } else {
                                                phi_1765_ = _e1181;
                                            }
                                            let _e1185 = phi_1765_;
                                            if _e1185 {
                                                if (_e1167 < 1000000000000000f) {
                                                    if (_e1168 < 1000000000000000f) {
                                                        phi_1778_ = (_e1169 < 1000000000000000f);
                                                        phi_1779_ = false;
                                                    } else {
                                                        phi_1778_ = bool();
                                                        phi_1779_ = true;
                                                    }
                                                    let _e1190 = phi_1778_;
                                                    let _e1192 = phi_1779_;
                                                    phi_1780_ = _e1190;
                                                    phi_1781_ = _e1192;
                                                } else {
                                                    phi_1780_ = bool();
                                                    phi_1781_ = true;
                                                }
                                                let _e1194 = phi_1780_;
                                                let _e1196 = phi_1781_;
                                                if _e1196 {
                                                    phi_1785_ = false;
                                                } else {
                                                    phi_1785_ = _e1194;
                                                }
                                                let _e1198 = phi_1785_;
                                                if _e1198 {
                                                    if (_e1167 > 0f) {
                                                        phi_1799_ = bool();
                                                        phi_1800_ = true;
                                                    } else {
                                                        let _e1200 = (_e1168 > 0f);
                                                        if _e1200 {
                                                            phi_1798_ = bool();
                                                        } else {
                                                            phi_1798_ = (_e1169 > 0f);
                                                        }
                                                        let _e1203 = phi_1798_;
                                                        phi_1799_ = _e1203;
                                                        phi_1800_ = _e1200;
                                                    }
                                                    let _e1205 = phi_1799_;
                                                    let _e1207 = phi_1800_;
                                                    if _e1207 {
                                                        phi_1804_ = true;
                                                    } else {
                                                        phi_1804_ = _e1205;
                                                    }
                                                    let _e1209 = phi_1804_;
                                                    phi_1805_ = _e1209;
                                                    phi_1806_ = false;
                                                } else {
                                                    phi_1805_ = bool();
                                                    phi_1806_ = true;
                                                }
                                                let _e1211 = phi_1805_;
                                                let _e1213 = phi_1806_;
                                                phi_1807_ = _e1211;
                                                phi_1808_ = _e1213;
                                            } else {
                                                phi_1807_ = bool();
                                                phi_1808_ = true;
                                            }
                                            let _e1215 = phi_1807_;
                                            let _e1217 = phi_1808_;
                                            if _e1217 {
                                                phi_1812_ = false;
                                            } else {
                                                phi_1812_ = _e1215;
                                            }
                                            let _e1219 = phi_1812_;
                                            if _e1219 {
                                                let _e1220 = (_e1164 >= _e81);
                                                if _e1220 {
                                                    phi_3420_ = lt_bvh_Hit();
                                                } else {
                                                    if (_e1164 < _e81) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1226 = nodes.member[(0u + _e1164)].frame[0u];
                                                    let _e1230 = nodes.member[(0u + _e1164)].frame[1u];
                                                    let _e1234 = nodes.member[(0u + _e1164)].frame[2u];
                                                    let _e1238 = nodes.member[(0u + _e1164)].frame[0u];
                                                    let _e1242 = nodes.member[(0u + _e1164)].frame[1u];
                                                    let _e1246 = nodes.member[(0u + _e1164)].frame[2u];
                                                    let _e1250 = nodes.member[(0u + _e1164)].frame[3u];
                                                    let _e1284 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1133), abs(_e1146));
                                                    let _e1285 = core_intrinsics_maximum_number_nsz_f32_(_e1284, abs(_e1159));
                                                    let _e1286 = (_e1285 * 0.0000000000009094947f);
                                                    if (abs(_e1133) < _e1286) {
                                                        phi_1882_ = _e1286;
                                                    } else {
                                                        phi_1882_ = abs(_e1133);
                                                    }
                                                    let _e1291 = phi_1882_;
                                                    if (_e1133 < 0f) {
                                                        phi_1889_ = (-1f / _e1291);
                                                    } else {
                                                        phi_1889_ = (1f / _e1291);
                                                    }
                                                    let _e1296 = phi_1889_;
                                                    if (abs(_e1146) < _e1286) {
                                                        phi_1896_ = _e1286;
                                                    } else {
                                                        phi_1896_ = abs(_e1146);
                                                    }
                                                    let _e1301 = phi_1896_;
                                                    if (_e1146 < 0f) {
                                                        phi_1903_ = (-1f / _e1301);
                                                    } else {
                                                        phi_1903_ = (1f / _e1301);
                                                    }
                                                    let _e1306 = phi_1903_;
                                                    if (abs(_e1159) < _e1286) {
                                                        phi_1910_ = _e1286;
                                                    } else {
                                                        phi_1910_ = abs(_e1159);
                                                    }
                                                    let _e1311 = phi_1910_;
                                                    if (_e1159 < 0f) {
                                                        phi_1917_ = (-1f / _e1311);
                                                    } else {
                                                        phi_1917_ = (1f / _e1311);
                                                    }
                                                    let _e1316 = phi_1917_;
                                                    let _e1320 = abs((bitcast<f32>(_e1226) - _e1089));
                                                    let _e1321 = abs((bitcast<f32>(_e1230) - _e1102));
                                                    let _e1322 = abs((bitcast<f32>(_e1234) - _e1115));
                                                    let _e1326 = abs(((bitcast<f32>(_e1238) + (bitcast<f32>((((_e1250 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1089));
                                                    let _e1327 = abs(((bitcast<f32>(_e1242) + (bitcast<f32>((((_e1250 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1102));
                                                    let _e1328 = abs(((bitcast<f32>(_e1246) + (bitcast<f32>((((_e1250 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1115));
                                                    if (_e1320 > _e1326) {
                                                        phi_1934_ = _e1320;
                                                    } else {
                                                        phi_1934_ = _e1326;
                                                    }
                                                    let _e1331 = phi_1934_;
                                                    if (_e1321 > _e1327) {
                                                        phi_1939_ = _e1321;
                                                    } else {
                                                        phi_1939_ = _e1327;
                                                    }
                                                    let _e1334 = phi_1939_;
                                                    if (_e1322 > _e1328) {
                                                        phi_1944_ = _e1322;
                                                    } else {
                                                        phi_1944_ = _e1328;
                                                    }
                                                    let _e1337 = phi_1944_;
                                                    if (_e1331 > _e1334) {
                                                        phi_1949_ = _e1331;
                                                    } else {
                                                        phi_1949_ = _e1334;
                                                    }
                                                    let _e1340 = phi_1949_;
                                                    if (_e1340 > _e1337) {
                                                        phi_1954_ = _e1340;
                                                    } else {
                                                        phi_1954_ = _e1337;
                                                    }
                                                    let _e1343 = phi_1954_;
                                                    let _e1347 = (_e1343 * 0.0000019073486f);
                                                    let _e1348 = (abs(_e1296) * _e1347);
                                                    let _e1349 = (abs(_e1306) * _e1347);
                                                    let _e1350 = (abs(_e1316) * _e1347);
                                                    let _e1354 = (_e1343 * 0.0000009536743f);
                                                    let _e1355 = (abs(_e1296) * _e1354);
                                                    let _e1356 = (abs(_e1306) * _e1354);
                                                    let _e1357 = (abs(_e1316) * _e1354);
                                                    let _e1358 = abs(_e1133);
                                                    let _e1359 = abs(_e1146);
                                                    let _e1360 = abs(_e1159);
                                                    if (_e1358 >= _e1359) {
                                                        if (_e1358 >= _e1360) {
                                                            phi_1980_ = false;
                                                        } else {
                                                            phi_1980_ = true;
                                                        }
                                                        let _e1364 = phi_1980_;
                                                        phi_1981_ = _e1364;
                                                    } else {
                                                        phi_1981_ = true;
                                                    }
                                                    let _e1366 = phi_1981_;
                                                    if _e1366 {
                                                        if (_e1359 >= _e1360) {
                                                            phi_1989_ = 1u;
                                                        } else {
                                                            phi_1989_ = 2u;
                                                        }
                                                        let _e1369 = phi_1989_;
                                                        phi_1990_ = _e1369;
                                                    } else {
                                                        phi_1990_ = 0u;
                                                    }
                                                    let _e1371 = phi_1990_;
                                                    if (_e1371 == 0u) {
                                                        phi_2002_ = vec3<f32>(_e1146, _e1159, _e1133);
                                                    } else {
                                                        if (_e1371 == 1u) {
                                                            phi_2001_ = vec3<f32>(_e1159, _e1133, _e1146);
                                                        } else {
                                                            phi_2001_ = vec3<f32>(_e1133, _e1146, _e1159);
                                                        }
                                                        let _e1377 = phi_2001_;
                                                        phi_2002_ = _e1377;
                                                    }
                                                    let _e1379 = phi_2002_;
                                                    let _e1382 = (_e1379.x / _e1379.z);
                                                    let _e1385 = (_e1379.y / _e1379.z);
                                                    if (_e1296 < 0f) {
                                                        phi_2015_ = 0u;
                                                    } else {
                                                        phi_2015_ = 1u;
                                                    }
                                                    let _e1390 = phi_2015_;
                                                    if (_e1306 < 0f) {
                                                        phi_2020_ = 0u;
                                                    } else {
                                                        phi_2020_ = 2u;
                                                    }
                                                    let _e1393 = phi_2020_;
                                                    if (_e1316 < 0f) {
                                                        phi_2025_ = 0u;
                                                    } else {
                                                        phi_2025_ = 4u;
                                                    }
                                                    let _e1396 = phi_2025_;
                                                    let _e1398 = ((_e1390 | _e1393) | _e1396);
                                                    let _e1399 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1164, 2147483648u);
                                                    local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e1399.first[0], _e1399.first[1], _e1399.first[2], _e1399.first[3], _e1399.first[4], _e1399.first[5], _e1399.first[6], _e1399.first[7], _e1399.first[8], _e1399.first[9], _e1399.first[10], _e1399.first[11], _e1399.first[12], _e1399.first[13], _e1399.first[14], _e1399.first[15], _e1399.first[16], _e1399.first[17], _e1399.first[18], _e1399.first[19], _e1399.first[20], _e1399.first[21], _e1399.first[22], _e1399.first[23], _e1399.first[24], _e1399.first[25], _e1399.first[26], _e1399.first[27], _e1399.first[28], _e1399.first[29], _e1399.first[30], _e1399.first[31]), array<u32, 32>(_e1399.mask[0], _e1399.mask[1], _e1399.mask[2], _e1399.mask[3], _e1399.mask[4], _e1399.mask[5], _e1399.mask[6], _e1399.mask[7], _e1399.mask[8], _e1399.mask[9], _e1399.mask[10], _e1399.mask[11], _e1399.mask[12], _e1399.mask[13], _e1399.mask[14], _e1399.mask[15], _e1399.mask[16], _e1399.mask[17], _e1399.mask[18], _e1399.mask[19], _e1399.mask[20], _e1399.mask[21], _e1399.mask[22], _e1399.mask[23], _e1399.mask[24], _e1399.mask[25], _e1399.mask[26], _e1399.mask[27], _e1399.mask[28], _e1399.mask[29], _e1399.mask[30], _e1399.mask[31]), _e1399.len, _e1399.group, _e1399.group_mask);
                                                    let _e1473 = local_2.group_mask;
                                                    if ((_e1473 & 4278190080u) == 0u) {
                                                        let _e1477 = local_2.len;
                                                        if (_e1477 == 0u) {
                                                            phi_2139_ = false;
                                                        } else {
                                                            let _e1481 = local_2.len;
                                                            local_2.len = (_e1481 - 1u);
                                                            let _e1484 = local_2.len;
                                                            if (_e1484 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1489 = local_2.first[(0u + _e1484)];
                                                            local_2.group = _e1489;
                                                            let _e1492 = local_2.len;
                                                            if (_e1492 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1497 = local_2.mask[(0u + _e1492)];
                                                            local_2.group_mask = _e1497;
                                                            phi_2139_ = true;
                                                        }
                                                        let _e1500 = phi_2139_;
                                                        phi_2140_ = _e1500;
                                                    } else {
                                                        phi_2140_ = true;
                                                    }
                                                    let _e1502 = phi_2140_;
                                                    if _e1502 {
                                                        let _e1504 = local_2.group_mask;
                                                        let _e1510 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1504)), 32u, (_e1504 == 0u)));
                                                        let _e1514 = local_2.group_mask;
                                                        let _e1528 = local_2.group_mask;
                                                        local_2.group_mask = (_e1528 & ~((1u << bitcast<u32>((_e1510 & 31u)))));
                                                        let _e1531 = local_2.group;
                                                        phi_2171_ = (_e1531 + countOneBits(((_e1514 & ~((4294967295u << bitcast<u32>((((_e1510 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_2171_ = 4294967295u;
                                                    }
                                                    let _e1534 = phi_2171_;
                                                    phi_2173_ = _e997;
                                                    phi_2176_ = _e1534;
                                                    loop {
                                                        let _e1536 = phi_2173_;
                                                        let _e1538 = phi_2176_;
                                                        local_11 = _e1536;
                                                        let _e1539 = (_e1538 != 4294967295u);
                                                        if _e1539 {
                                                            if (_e1538 < _e81) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1546 = nodes.member[(0u + _e1538)].frame[3u];
                                                            let _e1571 = (bitcast<f32>((((_e1546 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1296);
                                                            let _e1572 = (bitcast<f32>((((_e1546 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1306);
                                                            let _e1573 = (bitcast<f32>((((_e1546 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1316);
                                                            let _e1576 = nodes.member[(0u + _e1538)].frame[0u];
                                                            let _e1580 = nodes.member[(0u + _e1538)].frame[1u];
                                                            let _e1584 = nodes.member[(0u + _e1538)].frame[2u];
                                                            let _e1589 = ((bitcast<f32>(_e1576) - _e1089) * _e1296);
                                                            let _e1590 = ((bitcast<f32>(_e1580) - _e1102) * _e1306);
                                                            let _e1591 = ((bitcast<f32>(_e1584) - _e1115) * _e1316);
                                                            let _e1599 = nodes.member[(0u + _e1538)].x;
                                                            if (_e1296 < 0f) {
                                                                let _e1610 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1599.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1616 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1610.unnamed.root, _e1599.w), _e1610.unnamed_1);
                                                                let _e1622 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1616.unnamed, lt_bvh_traverse_Tree(_e1599.x, _e1616.unnamed_1.first_primitive));
                                                                phi_2257_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1622.unnamed, lt_bvh_traverse_Tree(_e1622.unnamed_1.root, _e1599.y));
                                                            } else {
                                                                let _e1638 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1599.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1644 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1638.unnamed.root, _e1599.y), _e1638.unnamed_1);
                                                                let _e1650 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1644.unnamed, lt_bvh_traverse_Tree(_e1599.z, _e1644.unnamed_1.first_primitive));
                                                                phi_2257_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1650.unnamed, lt_bvh_traverse_Tree(_e1650.unnamed_1.root, _e1599.w));
                                                            }
                                                            let _e1658 = phi_2257_;
                                                            let _e1668 = nodes.member[(0u + _e1538)].y;
                                                            if (_e1306 < 0f) {
                                                                let _e1679 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1668.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1685 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1679.unnamed.root, _e1668.w), _e1679.unnamed_1);
                                                                let _e1691 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1685.unnamed, lt_bvh_traverse_Tree(_e1668.x, _e1685.unnamed_1.first_primitive));
                                                                phi_2284_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1691.unnamed, lt_bvh_traverse_Tree(_e1691.unnamed_1.root, _e1668.y));
                                                            } else {
                                                                let _e1707 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1668.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1713 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1707.unnamed.root, _e1668.y), _e1707.unnamed_1);
                                                                let _e1719 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1713.unnamed, lt_bvh_traverse_Tree(_e1668.z, _e1713.unnamed_1.first_primitive));
                                                                phi_2284_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1719.unnamed, lt_bvh_traverse_Tree(_e1719.unnamed_1.root, _e1668.w));
                                                            }
                                                            let _e1727 = phi_2284_;
                                                            let _e1737 = nodes.member[(0u + _e1538)].z;
                                                            if (_e1316 < 0f) {
                                                                let _e1748 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1737.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1754 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1748.unnamed.root, _e1737.w), _e1748.unnamed_1);
                                                                let _e1760 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1754.unnamed, lt_bvh_traverse_Tree(_e1737.x, _e1754.unnamed_1.first_primitive));
                                                                phi_2311_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1760.unnamed, lt_bvh_traverse_Tree(_e1760.unnamed_1.root, _e1737.y));
                                                            } else {
                                                                let _e1776 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1737.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1782 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1776.unnamed.root, _e1737.y), _e1776.unnamed_1);
                                                                let _e1788 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1782.unnamed, lt_bvh_traverse_Tree(_e1737.z, _e1782.unnamed_1.first_primitive));
                                                                phi_2311_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1788.unnamed, lt_bvh_traverse_Tree(_e1788.unnamed_1.root, _e1737.w));
                                                            }
                                                            let _e1796 = phi_2311_;
                                                            phi_2317_ = 0u;
                                                            phi_2320_ = 0u;
                                                            loop {
                                                                let _e1806 = phi_2317_;
                                                                let _e1808 = phi_2320_;
                                                                local_7 = _e1808;
                                                                local_8 = _e1808;
                                                                local_9 = _e1808;
                                                                let _e1809 = (_e1806 < 8u);
                                                                if _e1809 {
                                                                    let _e1811 = (_e1806 >> bitcast<u32>(2i));
                                                                    let _e1812 = (_e1806 & 3u);
                                                                    if (_e1811 == 0u) {
                                                                        phi_2334_ = _e1658.unnamed.root;
                                                                    } else {
                                                                        phi_2334_ = _e1658.unnamed.first_primitive;
                                                                    }
                                                                    let _e1815 = phi_2334_;
                                                                    if (_e1811 == 0u) {
                                                                        phi_2344_ = _e1727.unnamed.root;
                                                                    } else {
                                                                        phi_2344_ = _e1727.unnamed.first_primitive;
                                                                    }
                                                                    let _e1824 = phi_2344_;
                                                                    if (_e1811 == 0u) {
                                                                        phi_2354_ = _e1796.unnamed.root;
                                                                    } else {
                                                                        phi_2354_ = _e1796.unnamed.first_primitive;
                                                                    }
                                                                    let _e1833 = phi_2354_;
                                                                    let _e1846 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1815 >> bitcast<u32>(((_e1812 * 8u) & 31u))) & 255u)) * _e1571) + (_e1589 - _e1348)), ((f32(((_e1824 >> bitcast<u32>(((_e1812 * 8u) & 31u))) & 255u)) * _e1572) + (_e1590 - _e1349)));
                                                                    let _e1847 = core_intrinsics_maximum_number_nsz_f32_(_e1846, ((f32(((_e1833 >> bitcast<u32>(((_e1812 * 8u) & 31u))) & 255u)) * _e1573) + (_e1591 - _e1350)));
                                                                    if (_e1811 == 0u) {
                                                                        phi_2372_ = _e1658.unnamed_1.root;
                                                                    } else {
                                                                        phi_2372_ = _e1658.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1850 = phi_2372_;
                                                                    if (_e1811 == 0u) {
                                                                        phi_2382_ = _e1727.unnamed_1.root;
                                                                    } else {
                                                                        phi_2382_ = _e1727.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1859 = phi_2382_;
                                                                    if (_e1811 == 0u) {
                                                                        phi_2392_ = _e1796.unnamed_1.root;
                                                                    } else {
                                                                        phi_2392_ = _e1796.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1868 = phi_2392_;
                                                                    let _e1881 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1850 >> bitcast<u32>(((_e1812 * 8u) & 31u))) & 255u)) * _e1571) + (_e1589 + _e1348)), ((f32(((_e1859 >> bitcast<u32>(((_e1812 * 8u) & 31u))) & 255u)) * _e1572) + (_e1590 + _e1349)));
                                                                    let _e1882 = core_intrinsics_minimum_number_nsz_f32_(_e1881, ((f32(((_e1868 >> bitcast<u32>(((_e1812 * 8u) & 31u))) & 255u)) * _e1573) + (_e1591 + _e1350)));
                                                                    if (_e1847 <= _e1882) {
                                                                        if (_e1847 <= _e1536.t) {
                                                                            if (_e1882 >= _e188.tmin) {
                                                                                if (_e1811 == 0u) {
                                                                                    let _e1889 = nodes.member[(0u + _e1538)].links[2u];
                                                                                    phi_2428_ = _e1889;
                                                                                } else {
                                                                                    let _e1892 = nodes.member[(0u + _e1538)].links[3u];
                                                                                    phi_2428_ = _e1892;
                                                                                }
                                                                                let _e1894 = phi_2428_;
                                                                                let _e1899 = ((_e1894 >> bitcast<u32>(((_e1812 * 8u) & 31u))) & 255u);
                                                                                let _e1900 = (_e1899 & 31u);
                                                                                if (_e1900 >= 24u) {
                                                                                    phi_2441_ = (24u + ((_e1900 - 24u) ^ _e1398));
                                                                                } else {
                                                                                    phi_2441_ = _e1900;
                                                                                }
                                                                                let _e1906 = phi_2441_;
                                                                                phi_2446_ = (_e1808 | ((_e1899 >> bitcast<u32>(5i)) << bitcast<u32>((_e1906 & 31u))));
                                                                            } else {
                                                                                phi_2446_ = _e1808;
                                                                            }
                                                                            let _e1914 = phi_2446_;
                                                                            phi_2447_ = _e1914;
                                                                        } else {
                                                                            phi_2447_ = _e1808;
                                                                        }
                                                                        let _e1916 = phi_2447_;
                                                                        phi_2448_ = _e1916;
                                                                    } else {
                                                                        phi_2448_ = _e1808;
                                                                    }
                                                                    let _e1918 = phi_2448_;
                                                                    phi_2318_ = (_e1806 + 1u);
                                                                    phi_2321_ = _e1918;
                                                                } else {
                                                                    phi_2318_ = u32();
                                                                    phi_2321_ = u32();
                                                                }
                                                                let _e1921 = phi_2318_;
                                                                let _e1923 = phi_2321_;
                                                                continue;
                                                                continuing {
                                                                    phi_2317_ = _e1921;
                                                                    phi_2320_ = _e1923;
                                                                    break if !(_e1809);
                                                                }
                                                            }
                                                            let _e1927 = nodes.member[(0u + _e1538)].links[0u];
                                                            let _e1931 = nodes.member[(0u + _e1538)].frame[3u];
                                                            let _e1935 = local_7;
                                                            if ((_e1935 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1939 = local_2.group_mask;
                                                                if ((_e1939 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1943 = local_2.len;
                                                                    if (_e1943 < 32u) {
                                                                        let _e1946 = local_2.group;
                                                                        let _e1948 = local_2.len;
                                                                        if (_e1948 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_2.first[(0u + _e1948)] = _e1946;
                                                                        let _e1954 = local_2.group_mask;
                                                                        let _e1956 = local_2.len;
                                                                        if (_e1956 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_2.mask[(0u + _e1956)] = _e1954;
                                                                        let _e1963 = local_2.len;
                                                                        local_2.len = (_e1963 + 1u);
                                                                    }
                                                                }
                                                                local_2.group = (_e1164 + _e1927);
                                                                let _e1967 = local_8;
                                                                local_2.group_mask = ((_e1967 & 4278190080u) | (_e1931 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1972 = local_9;
                                                            phi_2506_ = _e1536;
                                                            phi_2509_ = (_e1972 & 16777215u);
                                                            loop {
                                                                let _e1975 = phi_2506_;
                                                                let _e1977 = phi_2509_;
                                                                local_10 = _e1975;
                                                                if (_e1977 == 0u) {
                                                                    phi_2507_ = lt_bvh_Hit();
                                                                    phi_2510_ = u32();
                                                                    phi_3348_ = false;
                                                                } else {
                                                                    let _e1981 = nodes.member[(0u + _e1538)].links[1u];
                                                                    let _e1986 = ((_e1166 + _e1981) + select(firstTrailingBit(_e1977), 32u, (_e1977 == 0u)));
                                                                    if (_e1986 < _e84) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1993 = triangles.member[(0u + _e1986)].v0_;
                                                                    let _e1995 = (_e1993.x - _e1089);
                                                                    let _e1997 = (_e1993.y - _e1102);
                                                                    let _e1999 = (_e1993.z - _e1115);
                                                                    if (_e1371 == 0u) {
                                                                        phi_2554_ = vec3<f32>(_e1997, _e1999, _e1995);
                                                                    } else {
                                                                        if (_e1371 == 1u) {
                                                                            phi_2553_ = vec3<f32>(_e1999, _e1995, _e1997);
                                                                        } else {
                                                                            phi_2553_ = (_e1993 - vec3<f32>(_e1089, _e1102, _e1115));
                                                                        }
                                                                        let _e2007 = phi_2553_;
                                                                        phi_2554_ = _e2007;
                                                                    }
                                                                    let _e2009 = phi_2554_;
                                                                    let _e2013 = (_e2009.x - (_e1382 * _e2009.z));
                                                                    let _e2017 = (_e2009.y - (_e1385 * _e2009.z));
                                                                    let _e2019 = triangles.member[(0u + _e1986)].v1_;
                                                                    let _e2021 = (_e2019.x - _e1089);
                                                                    let _e2023 = (_e2019.y - _e1102);
                                                                    let _e2025 = (_e2019.z - _e1115);
                                                                    if (_e1371 == 0u) {
                                                                        phi_2584_ = vec3<f32>(_e2023, _e2025, _e2021);
                                                                    } else {
                                                                        if (_e1371 == 1u) {
                                                                            phi_2583_ = vec3<f32>(_e2025, _e2021, _e2023);
                                                                        } else {
                                                                            phi_2583_ = (_e2019 - vec3<f32>(_e1089, _e1102, _e1115));
                                                                        }
                                                                        let _e2033 = phi_2583_;
                                                                        phi_2584_ = _e2033;
                                                                    }
                                                                    let _e2035 = phi_2584_;
                                                                    let _e2039 = (_e2035.x - (_e1382 * _e2035.z));
                                                                    let _e2043 = (_e2035.y - (_e1385 * _e2035.z));
                                                                    let _e2045 = triangles.member[(0u + _e1986)].v2_;
                                                                    let _e2047 = (_e2045.x - _e1089);
                                                                    let _e2049 = (_e2045.y - _e1102);
                                                                    let _e2051 = (_e2045.z - _e1115);
                                                                    if (_e1371 == 0u) {
                                                                        phi_2614_ = vec3<f32>(_e2049, _e2051, _e2047);
                                                                    } else {
                                                                        if (_e1371 == 1u) {
                                                                            phi_2613_ = vec3<f32>(_e2051, _e2047, _e2049);
                                                                        } else {
                                                                            phi_2613_ = (_e2045 - vec3<f32>(_e1089, _e1102, _e1115));
                                                                        }
                                                                        let _e2059 = phi_2613_;
                                                                        phi_2614_ = _e2059;
                                                                    }
                                                                    let _e2061 = phi_2614_;
                                                                    let _e2065 = (_e2061.x - (_e1382 * _e2061.z));
                                                                    let _e2069 = (_e2061.y - (_e1385 * _e2061.z));
                                                                    if (_e2039 < _e2065) {
                                                                        phi_2633_ = true;
                                                                    } else {
                                                                        if (_e2039 == _e2065) {
                                                                            phi_2632_ = (_e2043 < _e2069);
                                                                        } else {
                                                                            phi_2632_ = false;
                                                                        }
                                                                        let _e2074 = phi_2632_;
                                                                        phi_2633_ = _e2074;
                                                                    }
                                                                    let _e2076 = phi_2633_;
                                                                    if _e2076 {
                                                                        phi_2637_ = _e2069;
                                                                        phi_2638_ = _e2065;
                                                                        phi_2639_ = _e2043;
                                                                        phi_2640_ = _e2039;
                                                                    } else {
                                                                        phi_2637_ = _e2043;
                                                                        phi_2638_ = _e2039;
                                                                        phi_2639_ = _e2069;
                                                                        phi_2640_ = _e2065;
                                                                    }
                                                                    let _e2078 = phi_2637_;
                                                                    let _e2080 = phi_2638_;
                                                                    let _e2082 = phi_2639_;
                                                                    let _e2084 = phi_2640_;
                                                                    let _e2087 = ((_e2084 * _e2078) - (_e2082 * _e2080));
                                                                    if _e2076 {
                                                                        phi_2648_ = -(_e2087);
                                                                    } else {
                                                                        phi_2648_ = _e2087;
                                                                    }
                                                                    let _e2090 = phi_2648_;
                                                                    if (_e2065 < _e2013) {
                                                                        phi_2659_ = true;
                                                                    } else {
                                                                        if (_e2065 == _e2013) {
                                                                            phi_2658_ = (_e2069 < _e2017);
                                                                        } else {
                                                                            phi_2658_ = false;
                                                                        }
                                                                        let _e2095 = phi_2658_;
                                                                        phi_2659_ = _e2095;
                                                                    }
                                                                    let _e2097 = phi_2659_;
                                                                    if _e2097 {
                                                                        phi_2663_ = _e2017;
                                                                        phi_2664_ = _e2013;
                                                                        phi_2665_ = _e2069;
                                                                        phi_2666_ = _e2065;
                                                                    } else {
                                                                        phi_2663_ = _e2069;
                                                                        phi_2664_ = _e2065;
                                                                        phi_2665_ = _e2017;
                                                                        phi_2666_ = _e2013;
                                                                    }
                                                                    let _e2099 = phi_2663_;
                                                                    let _e2101 = phi_2664_;
                                                                    let _e2103 = phi_2665_;
                                                                    let _e2105 = phi_2666_;
                                                                    let _e2108 = ((_e2105 * _e2099) - (_e2103 * _e2101));
                                                                    if _e2097 {
                                                                        phi_2674_ = -(_e2108);
                                                                    } else {
                                                                        phi_2674_ = _e2108;
                                                                    }
                                                                    let _e2111 = phi_2674_;
                                                                    if (_e2013 < _e2039) {
                                                                        phi_2685_ = true;
                                                                    } else {
                                                                        if (_e2013 == _e2039) {
                                                                            phi_2684_ = (_e2017 < _e2043);
                                                                        } else {
                                                                            phi_2684_ = false;
                                                                        }
                                                                        let _e2116 = phi_2684_;
                                                                        phi_2685_ = _e2116;
                                                                    }
                                                                    let _e2118 = phi_2685_;
                                                                    if _e2118 {
                                                                        phi_2689_ = _e2043;
                                                                        phi_2690_ = _e2039;
                                                                        phi_2691_ = _e2017;
                                                                        phi_2692_ = _e2013;
                                                                    } else {
                                                                        phi_2689_ = _e2017;
                                                                        phi_2690_ = _e2013;
                                                                        phi_2691_ = _e2043;
                                                                        phi_2692_ = _e2039;
                                                                    }
                                                                    let _e2120 = phi_2689_;
                                                                    let _e2122 = phi_2690_;
                                                                    let _e2124 = phi_2691_;
                                                                    let _e2126 = phi_2692_;
                                                                    let _e2129 = ((_e2126 * _e2120) - (_e2124 * _e2122));
                                                                    if _e2118 {
                                                                        phi_2700_ = -(_e2129);
                                                                    } else {
                                                                        phi_2700_ = _e2129;
                                                                    }
                                                                    let _e2132 = phi_2700_;
                                                                    if (_e2090 >= 0f) {
                                                                        if (_e2111 >= 0f) {
                                                                            if (_e2132 >= 0f) {
                                                                                phi_2715_ = ((_e2090 + _e2111) + _e2132);
                                                                                phi_2716_ = false;
                                                                            } else {
                                                                                phi_2715_ = f32();
                                                                                phi_2716_ = true;
                                                                            }
                                                                            let _e2139 = phi_2715_;
                                                                            let _e2141 = phi_2716_;
                                                                            phi_2717_ = _e2139;
                                                                            phi_2718_ = _e2141;
                                                                        } else {
                                                                            phi_2717_ = f32();
                                                                            phi_2718_ = true;
                                                                        }
                                                                        let _e2143 = phi_2717_;
                                                                        let _e2145 = phi_2718_;
                                                                        phi_2719_ = _e2143;
                                                                        phi_2720_ = _e2145;
                                                                    } else {
                                                                        phi_2719_ = f32();
                                                                        phi_2720_ = true;
                                                                    }
                                                                    let _e2147 = phi_2719_;
                                                                    let _e2149 = phi_2720_;
                                                                    if _e2149 {
                                                                        if (_e2090 <= 0f) {
                                                                            if (_e2111 <= 0f) {
                                                                                let _e2152 = (_e2132 <= 0f);
                                                                                if _e2152 {
                                                                                }
                                                                                phi_2738_ = ((_e2090 + _e2111) + _e2132);
                                                                                phi_2739_ = false;
                                                                                phi_2740_ = _e2152;
                                                                            } else {
                                                                                phi_2738_ = f32();
                                                                                phi_2739_ = true;
                                                                                phi_2740_ = false;
                                                                            }
                                                                            let _e2156 = phi_2738_;
                                                                            let _e2158 = phi_2739_;
                                                                            let _e2160 = phi_2740_;
                                                                            phi_2741_ = _e2156;
                                                                            phi_2742_ = _e2158;
                                                                            phi_2743_ = _e2160;
                                                                        } else {
                                                                            phi_2741_ = f32();
                                                                            phi_2742_ = true;
                                                                            phi_2743_ = false;
                                                                        }
                                                                        let _e2162 = phi_2741_;
                                                                        let _e2164 = phi_2742_;
                                                                        let _e2166 = phi_2743_;
                                                                        if _e2164 {
                                                                            phi_2747_ = false;
                                                                        } else {
                                                                            phi_2747_ = _e2166;
                                                                        }
                                                                        let _e2168 = phi_2747_;
                                                                        phi_2748_ = _e2162;
                                                                        phi_2749_ = _e2168;
                                                                    } else {
                                                                        phi_2748_ = _e2147;
                                                                        phi_2749_ = true;
                                                                    }
                                                                    let _e2170 = phi_2748_;
                                                                    let _e2172 = phi_2749_;
                                                                    if _e2172 {
                                                                        let _e2173 = (_e2170 == 0f);
                                                                        if _e2173 {
                                                                            phi_3065_ = lt_bvh_triangle_Intersection();
                                                                            phi_3066_ = false;
                                                                        } else {
                                                                            let _e2175 = triangles.member[(0u + _e1986)].v0_;
                                                                            let _e2177 = (_e2175.x - _e1089);
                                                                            let _e2179 = (_e2175.y - _e1102);
                                                                            let _e2181 = (_e2175.z - _e1115);
                                                                            if (_e1371 == 0u) {
                                                                                phi_2778_ = vec3<f32>(_e2179, _e2181, _e2177);
                                                                            } else {
                                                                                if (_e1371 == 1u) {
                                                                                    phi_2777_ = vec3<f32>(_e2181, _e2177, _e2179);
                                                                                } else {
                                                                                    phi_2777_ = (_e2175 - vec3<f32>(_e1089, _e1102, _e1115));
                                                                                }
                                                                                let _e2189 = phi_2777_;
                                                                                phi_2778_ = _e2189;
                                                                            }
                                                                            let _e2191 = phi_2778_;
                                                                            let _e2193 = triangles.member[(0u + _e1986)].v1_;
                                                                            let _e2195 = triangles.member[(0u + _e1986)].v0_;
                                                                            let _e2198 = (_e2193.x - _e2195.x);
                                                                            let _e2201 = (_e2193.y - _e2195.y);
                                                                            let _e2204 = (_e2193.z - _e2195.z);
                                                                            if (_e1371 == 0u) {
                                                                                phi_2804_ = vec3<f32>(_e2201, _e2204, _e2198);
                                                                            } else {
                                                                                if (_e1371 == 1u) {
                                                                                    phi_2803_ = vec3<f32>(_e2204, _e2198, _e2201);
                                                                                } else {
                                                                                    phi_2803_ = (_e2193 - _e2195);
                                                                                }
                                                                                let _e2211 = phi_2803_;
                                                                                phi_2804_ = _e2211;
                                                                            }
                                                                            let _e2213 = phi_2804_;
                                                                            let _e2215 = triangles.member[(0u + _e1986)].v2_;
                                                                            let _e2217 = triangles.member[(0u + _e1986)].v0_;
                                                                            let _e2220 = (_e2215.x - _e2217.x);
                                                                            let _e2223 = (_e2215.y - _e2217.y);
                                                                            let _e2226 = (_e2215.z - _e2217.z);
                                                                            if (_e1371 == 0u) {
                                                                                phi_2830_ = vec3<f32>(_e2223, _e2226, _e2220);
                                                                            } else {
                                                                                if (_e1371 == 1u) {
                                                                                    phi_2829_ = vec3<f32>(_e2226, _e2220, _e2223);
                                                                                } else {
                                                                                    phi_2829_ = (_e2215 - _e2217);
                                                                                }
                                                                                let _e2233 = phi_2829_;
                                                                                phi_2830_ = _e2233;
                                                                            }
                                                                            let _e2235 = phi_2830_;
                                                                            let _e2242 = ((_e2213.y * _e2235.z) - (_e2213.z * _e2235.y));
                                                                            let _e2249 = ((_e2213.z * _e2235.x) - (_e2213.x * _e2235.z));
                                                                            let _e2256 = ((_e2213.x * _e2235.y) - (_e2213.y * _e2235.x));
                                                                            let _e2270 = (((1f / _e1379.z) * (((_e2242 * _e2191.x) + (_e2249 * _e2191.y)) + (_e2256 * _e2191.z))) / (((_e2242 * _e1382) + (_e2249 * _e1385)) + _e2256));
                                                                            if (_e2270 > _e188.tmin) {
                                                                                if (_e2270 < _e188.tmax) {
                                                                                    let _e2274 = triangles.member[(0u + _e1986)].v0_;
                                                                                    let _e2276 = triangles.member[(0u + _e1986)].v1_;
                                                                                    if (_e2274.x < _e2276.x) {
                                                                                        phi_2886_ = _e2274.x;
                                                                                    } else {
                                                                                        phi_2886_ = _e2276.x;
                                                                                    }
                                                                                    let _e2283 = phi_2886_;
                                                                                    if (_e2274.y < _e2276.y) {
                                                                                        phi_2895_ = _e2274.y;
                                                                                    } else {
                                                                                        phi_2895_ = _e2276.y;
                                                                                    }
                                                                                    let _e2290 = phi_2895_;
                                                                                    if (_e2274.z < _e2276.z) {
                                                                                        phi_2904_ = _e2274.z;
                                                                                    } else {
                                                                                        phi_2904_ = _e2276.z;
                                                                                    }
                                                                                    let _e2297 = phi_2904_;
                                                                                    let _e2299 = triangles.member[(0u + _e1986)].v2_;
                                                                                    if (_e2283 < _e2299.x) {
                                                                                        phi_2913_ = _e2283;
                                                                                    } else {
                                                                                        phi_2913_ = _e2299.x;
                                                                                    }
                                                                                    let _e2304 = phi_2913_;
                                                                                    if (_e2290 < _e2299.y) {
                                                                                        phi_2920_ = _e2290;
                                                                                    } else {
                                                                                        phi_2920_ = _e2299.y;
                                                                                    }
                                                                                    let _e2309 = phi_2920_;
                                                                                    if (_e2297 < _e2299.z) {
                                                                                        phi_2927_ = _e2297;
                                                                                    } else {
                                                                                        phi_2927_ = _e2299.z;
                                                                                    }
                                                                                    let _e2314 = phi_2927_;
                                                                                    let _e2316 = triangles.member[(0u + _e1986)].v0_;
                                                                                    let _e2318 = triangles.member[(0u + _e1986)].v1_;
                                                                                    if (_e2316.x > _e2318.x) {
                                                                                        phi_2940_ = _e2316.x;
                                                                                    } else {
                                                                                        phi_2940_ = _e2318.x;
                                                                                    }
                                                                                    let _e2325 = phi_2940_;
                                                                                    if (_e2316.y > _e2318.y) {
                                                                                        phi_2949_ = _e2316.y;
                                                                                    } else {
                                                                                        phi_2949_ = _e2318.y;
                                                                                    }
                                                                                    let _e2332 = phi_2949_;
                                                                                    if (_e2316.z > _e2318.z) {
                                                                                        phi_2958_ = _e2316.z;
                                                                                    } else {
                                                                                        phi_2958_ = _e2318.z;
                                                                                    }
                                                                                    let _e2339 = phi_2958_;
                                                                                    let _e2341 = triangles.member[(0u + _e1986)].v2_;
                                                                                    if (_e2325 > _e2341.x) {
                                                                                        phi_2967_ = _e2325;
                                                                                    } else {
                                                                                        phi_2967_ = _e2341.x;
                                                                                    }
                                                                                    let _e2346 = phi_2967_;
                                                                                    if (_e2332 > _e2341.y) {
                                                                                        phi_2974_ = _e2332;
                                                                                    } else {
                                                                                        phi_2974_ = _e2341.y;
                                                                                    }
                                                                                    let _e2351 = phi_2974_;
                                                                                    if (_e2339 > _e2341.z) {
                                                                                        phi_2981_ = _e2339;
                                                                                    } else {
                                                                                        phi_2981_ = _e2341.z;
                                                                                    }
                                                                                    let _e2356 = phi_2981_;
                                                                                    let _e2360 = ((_e2304 - _e1089) * _e1296);
                                                                                    let _e2361 = ((_e2309 - _e1102) * _e1306);
                                                                                    let _e2362 = ((_e2314 - _e1115) * _e1316);
                                                                                    let _e2366 = ((_e2346 - _e1089) * _e1296);
                                                                                    let _e2367 = ((_e2351 - _e1102) * _e1306);
                                                                                    let _e2368 = ((_e2356 - _e1115) * _e1316);
                                                                                    if (_e2360 < _e2366) {
                                                                                        phi_2998_ = _e2360;
                                                                                    } else {
                                                                                        phi_2998_ = _e2366;
                                                                                    }
                                                                                    let _e2371 = phi_2998_;
                                                                                    if (_e2361 < _e2367) {
                                                                                        phi_3003_ = _e2361;
                                                                                    } else {
                                                                                        phi_3003_ = _e2367;
                                                                                    }
                                                                                    let _e2374 = phi_3003_;
                                                                                    if (_e2362 < _e2368) {
                                                                                        phi_3008_ = _e2362;
                                                                                    } else {
                                                                                        phi_3008_ = _e2368;
                                                                                    }
                                                                                    let _e2377 = phi_3008_;
                                                                                    if (_e2360 > _e2366) {
                                                                                        phi_3016_ = _e2360;
                                                                                    } else {
                                                                                        phi_3016_ = _e2366;
                                                                                    }
                                                                                    let _e2383 = phi_3016_;
                                                                                    if (_e2361 > _e2367) {
                                                                                        phi_3021_ = _e2361;
                                                                                    } else {
                                                                                        phi_3021_ = _e2367;
                                                                                    }
                                                                                    let _e2386 = phi_3021_;
                                                                                    if (_e2362 > _e2368) {
                                                                                        phi_3026_ = _e2362;
                                                                                    } else {
                                                                                        phi_3026_ = _e2368;
                                                                                    }
                                                                                    let _e2389 = phi_3026_;
                                                                                    let _e2393 = core_intrinsics_maximum_number_nsz_f32_((_e2371 - _e1355), (_e2374 - _e1356));
                                                                                    let _e2394 = core_intrinsics_maximum_number_nsz_f32_(_e2393, (_e2377 - _e1357));
                                                                                    let _e2395 = core_intrinsics_minimum_number_nsz_f32_((_e2383 + _e1355), (_e2386 + _e1356));
                                                                                    let _e2396 = core_intrinsics_minimum_number_nsz_f32_(_e2395, (_e2389 + _e1357));
                                                                                    if (_e2394 > _e1064) {
                                                                                        phi_3038_ = _e2394;
                                                                                    } else {
                                                                                        phi_3038_ = _e1064;
                                                                                    }
                                                                                    let _e2399 = phi_3038_;
                                                                                    if (_e2396 < _e1066) {
                                                                                        phi_3043_ = _e2396;
                                                                                    } else {
                                                                                        phi_3043_ = _e1066;
                                                                                    }
                                                                                    let _e2402 = phi_3043_;
                                                                                    if (_e2270 < _e2399) {
                                                                                        phi_3048_ = _e2399;
                                                                                    } else {
                                                                                        phi_3048_ = _e2270;
                                                                                    }
                                                                                    let _e2405 = phi_3048_;
                                                                                    if (_e2405 > _e2402) {
                                                                                        phi_3053_ = _e2402;
                                                                                    } else {
                                                                                        phi_3053_ = _e2405;
                                                                                    }
                                                                                    let _e2408 = phi_3053_;
                                                                                    phi_3058_ = lt_bvh_triangle_Intersection(_e2408, (_e2111 / _e2170), (_e2132 / _e2170), (_e2399 <= _e2402));
                                                                                    phi_3059_ = false;
                                                                                } else {
                                                                                    phi_3058_ = lt_bvh_triangle_Intersection();
                                                                                    phi_3059_ = true;
                                                                                }
                                                                                let _e2414 = phi_3058_;
                                                                                let _e2416 = phi_3059_;
                                                                                phi_3060_ = _e2414;
                                                                                phi_3061_ = _e2416;
                                                                            } else {
                                                                                phi_3060_ = lt_bvh_triangle_Intersection();
                                                                                phi_3061_ = true;
                                                                            }
                                                                            let _e2418 = phi_3060_;
                                                                            let _e2420 = phi_3061_;
                                                                            if _e2420 {
                                                                            }
                                                                            phi_3065_ = _e2418;
                                                                            phi_3066_ = _e2420;
                                                                        }
                                                                        let _e2422 = phi_3065_;
                                                                        let _e2424 = phi_3066_;
                                                                        phi_3067_ = _e2422;
                                                                        phi_3068_ = _e2173;
                                                                        phi_3069_ = _e2424;
                                                                    } else {
                                                                        phi_3067_ = lt_bvh_triangle_Intersection();
                                                                        phi_3068_ = true;
                                                                        phi_3069_ = false;
                                                                    }
                                                                    let _e2426 = phi_3067_;
                                                                    let _e2428 = phi_3068_;
                                                                    let _e2430 = phi_3069_;
                                                                    if _e2428 {
                                                                        phi_3073_ = true;
                                                                    } else {
                                                                        phi_3073_ = _e2430;
                                                                    }
                                                                    let _e2432 = phi_3073_;
                                                                    if _e2432 {
                                                                        phi_3077_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_3077_ = _e2426;
                                                                    }
                                                                    let _e2434 = phi_3077_;
                                                                    if _e2434.is_hit {
                                                                        if (_e2434.t > _e188.tmin) {
                                                                            if (_e2434.t < _e1975.t) {
                                                                                phi_3125_ = true;
                                                                            } else {
                                                                                if (_e2434.t == _e1975.t) {
                                                                                    if (_e1975.triangle != 4294967295u) {
                                                                                        if (_e1986 < _e1975.triangle) {
                                                                                            phi_3116_ = true;
                                                                                        } else {
                                                                                            if (_e1986 == _e1975.triangle) {
                                                                                                phi_3115_ = (_e1005 < _e1975.instance);
                                                                                            } else {
                                                                                                phi_3115_ = false;
                                                                                            }
                                                                                            let _e2452 = phi_3115_;
                                                                                            phi_3116_ = _e2452;
                                                                                        }
                                                                                        let _e2454 = phi_3116_;
                                                                                        phi_3117_ = _e2454;
                                                                                        phi_3118_ = false;
                                                                                    } else {
                                                                                        phi_3117_ = bool();
                                                                                        phi_3118_ = true;
                                                                                    }
                                                                                    let _e2456 = phi_3117_;
                                                                                    let _e2458 = phi_3118_;
                                                                                    phi_3119_ = _e2456;
                                                                                    phi_3120_ = _e2458;
                                                                                } else {
                                                                                    phi_3119_ = bool();
                                                                                    phi_3120_ = true;
                                                                                }
                                                                                let _e2460 = phi_3119_;
                                                                                let _e2462 = phi_3120_;
                                                                                if _e2462 {
                                                                                    phi_3124_ = false;
                                                                                } else {
                                                                                    phi_3124_ = _e2460;
                                                                                }
                                                                                let _e2464 = phi_3124_;
                                                                                phi_3125_ = _e2464;
                                                                            }
                                                                            let _e2466 = phi_3125_;
                                                                            if _e2466 {
                                                                                let _e2468 = triangles.member[(0u + _e1986)].i0_;
                                                                                if ((_e2468 & 2147483648u) == 0u) {
                                                                                    phi_3336_ = true;
                                                                                } else {
                                                                                    if (_e1986 < _e84) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2477 = triangles.member[(0u + _e1986)].i0_;
                                                                                    let _e2478 = (_e2477 & 2147483647u);
                                                                                    let _e2480 = triangles.member[(0u + _e1986)].i1_;
                                                                                    let _e2482 = triangles.member[(0u + _e1986)].i2_;
                                                                                    if (_e2478 < _e87) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2486 = vertices.member[(0u + _e2478)];
                                                                                    if (_e2480 < _e87) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2490 = vertices.member[(0u + _e2480)];
                                                                                    if (_e2482 < _e87) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2494 = vertices.member[(0u + _e2482)];
                                                                                    let _e2495 = array<abi_Vertex, 3>(_e2486, _e2490, _e2494);
                                                                                    if (_e2495[0].material < _e90) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2501 = materials.member[(0u + _e2495[0].material)];
                                                                                    if ((_e2501.flags & 0u) == 0u) {
                                                                                        let _e2506 = ((1f - _e2434.u) - _e2434.v);
                                                                                        if (_e2501.cutoff <= 0f) {
                                                                                            phi_3331_ = true;
                                                                                        } else {
                                                                                            let _e2533 = (_e2501.base_color.w * ((((f32((_e2495[0].color >> bitcast<u32>(24i))) * _e2506) + (f32((_e2495[1].color >> bitcast<u32>(24i))) * _e2434.u)) + (f32((_e2495[2].color >> bitcast<u32>(24i))) * _e2434.v)) * (1f / 255f)));
                                                                                            if (_e2501.alpha_size == 0u) {
                                                                                                phi_3328_ = _e2533;
                                                                                            } else {
                                                                                                local_1.offset = _e2501.alpha_offset;
                                                                                                local_1.size = _e2501.alpha_size;
                                                                                                local_1.flags = _e2501.flags;
                                                                                                let _e2564 = _lt_shaders_texture_TextureView_quad((&local_1), (((_e2495[0].u * _e2506) + (_e2495[1].u * _e2434.u)) + (_e2495[2].u * _e2434.v)), (((_e2495[0].v * _e2506) + (_e2495[1].v * _e2434.u)) + (_e2495[2].v * _e2434.v)));
                                                                                                let _e2568 = (_e2564.indices[0] >> bitcast<u32>(2i));
                                                                                                if (_e2568 < _e99) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2572 = alpha_texels.member[(0u + _e2568)];
                                                                                                let _e2588 = (_e2564.indices[1] >> bitcast<u32>(2i));
                                                                                                if (_e2588 < _e99) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2592 = alpha_texels.member[(0u + _e2588)];
                                                                                                let _e2609 = (_e2564.indices[2] >> bitcast<u32>(2i));
                                                                                                if (_e2609 < _e99) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2613 = alpha_texels.member[(0u + _e2609)];
                                                                                                let _e2630 = (_e2564.indices[3] >> bitcast<u32>(2i));
                                                                                                if (_e2630 < _e99) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2634 = alpha_texels.member[(0u + _e2630)];
                                                                                                phi_3328_ = (_e2533 * (((((f32(((_e2572 >> bitcast<u32>((((_e2564.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2564.weights.x) + ((f32(((_e2592 >> bitcast<u32>((((_e2564.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2564.weights.y)) + ((f32(((_e2613 >> bitcast<u32>((((_e2564.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2564.weights.z)) + ((f32(((_e2634 >> bitcast<u32>((((_e2564.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2564.weights.w)));
                                                                                            }
                                                                                            let _e2650 = phi_3328_;
                                                                                            phi_3331_ = (_e2650 >= _e2501.cutoff);
                                                                                        }
                                                                                        let _e2654 = phi_3331_;
                                                                                        phi_3332_ = _e2654;
                                                                                    } else {
                                                                                        phi_3332_ = false;
                                                                                    }
                                                                                    let _e2656 = phi_3332_;
                                                                                    if _e2656 {
                                                                                    }
                                                                                    phi_3336_ = _e2656;
                                                                                }
                                                                                let _e2658 = phi_3336_;
                                                                                if _e2658 {
                                                                                    phi_3344_ = lt_bvh_Hit(_e2434.t, _e2434.u, _e2434.v, _e1986, _e1005);
                                                                                } else {
                                                                                    phi_3344_ = _e1975;
                                                                                }
                                                                                let _e2664 = phi_3344_;
                                                                                phi_3345_ = _e2664;
                                                                            } else {
                                                                                phi_3345_ = _e1975;
                                                                            }
                                                                            let _e2666 = phi_3345_;
                                                                            phi_3346_ = _e2666;
                                                                        } else {
                                                                            phi_3346_ = _e1975;
                                                                        }
                                                                        let _e2668 = phi_3346_;
                                                                        phi_3347_ = _e2668;
                                                                    } else {
                                                                        phi_3347_ = _e1975;
                                                                    }
                                                                    let _e2670 = phi_3347_;
                                                                    phi_2507_ = _e2670;
                                                                    phi_2510_ = (_e1977 & (_e1977 - 1u));
                                                                    phi_3348_ = true;
                                                                }
                                                                let _e2672 = phi_2507_;
                                                                let _e2674 = phi_2510_;
                                                                let _e2676 = phi_3348_;
                                                                continue;
                                                                continuing {
                                                                    phi_2506_ = _e2672;
                                                                    phi_2509_ = _e2674;
                                                                    break if !(_e2676);
                                                                }
                                                            }
                                                            let _e2679 = local_2.group_mask;
                                                            if ((_e2679 & 4278190080u) == 0u) {
                                                                let _e2683 = local_2.len;
                                                                if (_e2683 == 0u) {
                                                                    phi_3387_ = false;
                                                                } else {
                                                                    let _e2687 = local_2.len;
                                                                    local_2.len = (_e2687 - 1u);
                                                                    let _e2690 = local_2.len;
                                                                    if (_e2690 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2695 = local_2.first[(0u + _e2690)];
                                                                    local_2.group = _e2695;
                                                                    let _e2698 = local_2.len;
                                                                    if (_e2698 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2703 = local_2.mask[(0u + _e2698)];
                                                                    local_2.group_mask = _e2703;
                                                                    phi_3387_ = true;
                                                                }
                                                                let _e2706 = phi_3387_;
                                                                phi_3388_ = _e2706;
                                                            } else {
                                                                phi_3388_ = true;
                                                            }
                                                            let _e2708 = phi_3388_;
                                                            if _e2708 {
                                                                let _e2710 = local_2.group_mask;
                                                                let _e2716 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2710)), 32u, (_e2710 == 0u)));
                                                                let _e2720 = local_2.group_mask;
                                                                let _e2734 = local_2.group_mask;
                                                                local_2.group_mask = (_e2734 & ~((1u << bitcast<u32>((_e2716 & 31u)))));
                                                                let _e2737 = local_2.group;
                                                                phi_3419_ = (_e2737 + countOneBits(((_e2720 & ~((4294967295u << bitcast<u32>((((_e2716 - 24u) ^ _e1398) & 31u))))) & 255u)));
                                                            } else {
                                                                phi_3419_ = 4294967295u;
                                                            }
                                                            let _e2740 = phi_3419_;
                                                            let _e4062 = local_10;
                                                            phi_2174_ = _e4062;
                                                            phi_2177_ = _e2740;
                                                        } else {
                                                            phi_2174_ = lt_bvh_Hit();
                                                            phi_2177_ = u32();
                                                        }
                                                        let _e2742 = phi_2174_;
                                                        let _e2744 = phi_2177_;
                                                        continue;
                                                        continuing {
                                                            phi_2173_ = _e2742;
                                                            phi_2176_ = _e2744;
                                                            break if !(_e1539);
                                                        }
                                                    }
                                                    let _e4066 = local_11;
                                                    phi_3420_ = _e4066;
                                                }
                                                let _e2747 = phi_3420_;
                                                phi_3421_ = _e2747;
                                                phi_3422_ = _e1220;
                                            } else {
                                                phi_3421_ = lt_bvh_Hit();
                                                phi_3422_ = true;
                                            }
                                            let _e2749 = phi_3421_;
                                            let _e2751 = phi_3422_;
                                            if _e2751 {
                                                phi_3426_ = _e997;
                                            } else {
                                                phi_3426_ = _e2749;
                                            }
                                            let _e2753 = phi_3426_;
                                            phi_3427_ = _e2753;
                                        } else {
                                            phi_3427_ = _e997;
                                        }
                                        let _e2755 = phi_3427_;
                                        phi_3428_ = _e2755;
                                    } else {
                                        phi_3428_ = _e997;
                                    }
                                    let _e2757 = phi_3428_;
                                    phi_3429_ = _e2757;
                                } else {
                                    phi_3429_ = _e997;
                                }
                                let _e2759 = phi_3429_;
                                phi_1541_ = (_e995 & (_e995 - 1u));
                                phi_1544_ = _e2759;
                                phi_3430_ = true;
                            }
                            let _e2761 = phi_1541_;
                            let _e2763 = phi_1544_;
                            let _e2765 = phi_3430_;
                            continue;
                            continuing {
                                phi_1540_ = _e2761;
                                phi_1543_ = _e2763;
                                break if !(_e2765);
                            }
                        }
                        let _e2768 = local_3.group_mask;
                        if ((_e2768 & 4278190080u) == 0u) {
                            let _e2772 = local_3.len;
                            if (_e2772 == 0u) {
                                phi_3469_ = false;
                            } else {
                                let _e2776 = local_3.len;
                                local_3.len = (_e2776 - 1u);
                                let _e2779 = local_3.len;
                                if (_e2779 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2784 = local_3.first[(0u + _e2779)];
                                local_3.group = _e2784;
                                let _e2787 = local_3.len;
                                if (_e2787 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2792 = local_3.mask[(0u + _e2787)];
                                local_3.group_mask = _e2792;
                                phi_3469_ = true;
                            }
                            let _e2795 = phi_3469_;
                            phi_3470_ = _e2795;
                        } else {
                            phi_3470_ = true;
                        }
                        let _e2797 = phi_3470_;
                        if _e2797 {
                            let _e2799 = local_3.group_mask;
                            let _e2805 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2799)), 32u, (_e2799 == 0u)));
                            let _e2809 = local_3.group_mask;
                            let _e2823 = local_3.group_mask;
                            local_3.group_mask = (_e2823 & ~((1u << bitcast<u32>((_e2805 & 31u)))));
                            let _e2826 = local_3.group;
                            phi_3501_ = (_e2826 + countOneBits(((_e2809 & ~((4294967295u << bitcast<u32>((((_e2805 - 24u) ^ _e414) & 31u))))) & 255u)));
                        } else {
                            phi_3501_ = 4294967295u;
                        }
                        let _e2829 = phi_3501_;
                        phi_1204_ = _e2829;
                        let _e4082 = local_12;
                        phi_1207_ = _e4082;
                    } else {
                        phi_1204_ = u32();
                        phi_1207_ = lt_bvh_Hit();
                    }
                    let _e2831 = phi_1204_;
                    let _e2833 = phi_1207_;
                    continue;
                    continuing {
                        phi_1203_ = _e2831;
                        phi_1206_ = _e2833;
                        break if !(_e555);
                    }
                }
                let _e4085 = local_13;
                phi_3502_ = _e4085;
            }
            let _e2836 = phi_3502_;
            phi_3503_ = _e2836;
            phi_3504_ = _e252;
        } else {
            phi_3503_ = lt_bvh_Hit();
            phi_3504_ = true;
        }
        let _e2838 = phi_3503_;
        let _e2840 = phi_3504_;
        if _e2840 {
            phi_3508_ = _e190;
        } else {
            phi_3508_ = _e2838;
        }
        let _e2842 = phi_3508_;
        if (_e2842.triangle != 4294967295u) {
            let _e2848 = ((1f - _e2842.u) - _e2842.v);
            if (_e2842.triangle < _e84) {
            } else {
                return;
            }
            let _e2853 = triangles.member[(0u + _e2842.triangle)];
            if (_e2842.instance < _e96) {
            } else {
                return;
            }
            let _e2864 = instances.member[(0u + _e2842.instance)].object_to_world[0u];
            let _e2875 = ((((_e2864.x * _e2853.v0_.x) + (_e2864.y * _e2853.v0_.y)) + (_e2864.z * _e2853.v0_.z)) + (_e2864.w * 1f));
            let _e2877 = instances.member[(0u + _e2842.instance)].object_to_world[1u];
            let _e2888 = ((((_e2877.x * _e2853.v0_.x) + (_e2877.y * _e2853.v0_.y)) + (_e2877.z * _e2853.v0_.z)) + (_e2877.w * 1f));
            let _e2890 = instances.member[(0u + _e2842.instance)].object_to_world[2u];
            let _e2901 = ((((_e2890.x * _e2853.v0_.x) + (_e2890.y * _e2853.v0_.y)) + (_e2890.z * _e2853.v0_.z)) + (_e2890.w * 1f));
            let _e2908 = instances.member[(0u + _e2842.instance)].object_to_world[0u];
            let _e2919 = ((((_e2908.x * _e2853.v1_.x) + (_e2908.y * _e2853.v1_.y)) + (_e2908.z * _e2853.v1_.z)) + (_e2908.w * 1f));
            let _e2921 = instances.member[(0u + _e2842.instance)].object_to_world[1u];
            let _e2932 = ((((_e2921.x * _e2853.v1_.x) + (_e2921.y * _e2853.v1_.y)) + (_e2921.z * _e2853.v1_.z)) + (_e2921.w * 1f));
            let _e2934 = instances.member[(0u + _e2842.instance)].object_to_world[2u];
            let _e2945 = ((((_e2934.x * _e2853.v1_.x) + (_e2934.y * _e2853.v1_.y)) + (_e2934.z * _e2853.v1_.z)) + (_e2934.w * 1f));
            let _e2952 = instances.member[(0u + _e2842.instance)].object_to_world[0u];
            let _e2963 = ((((_e2952.x * _e2853.v2_.x) + (_e2952.y * _e2853.v2_.y)) + (_e2952.z * _e2853.v2_.z)) + (_e2952.w * 1f));
            let _e2965 = instances.member[(0u + _e2842.instance)].object_to_world[1u];
            let _e2976 = ((((_e2965.x * _e2853.v2_.x) + (_e2965.y * _e2853.v2_.y)) + (_e2965.z * _e2853.v2_.z)) + (_e2965.w * 1f));
            let _e2978 = instances.member[(0u + _e2842.instance)].object_to_world[2u];
            let _e2989 = ((((_e2978.x * _e2853.v2_.x) + (_e2978.y * _e2853.v2_.y)) + (_e2978.z * _e2853.v2_.z)) + (_e2978.w * 1f));
            let _e3002 = (((_e2875 * _e2848) + (_e2919 * _e2842.u)) + (_e2963 * _e2842.v));
            let _e3003 = (((_e2888 * _e2848) + (_e2932 * _e2842.u)) + (_e2976 * _e2842.v));
            let _e3004 = (((_e2901 * _e2848) + (_e2945 * _e2842.u)) + (_e2989 * _e2842.v));
            let _e3006 = abs(_e2875);
            let _e3007 = abs(_e2888);
            let _e3008 = abs(_e2901);
            let _e3009 = abs(_e2919);
            let _e3010 = abs(_e2932);
            let _e3011 = abs(_e2945);
            if (_e3006 > _e3009) {
                phi_3695_ = _e3006;
            } else {
                phi_3695_ = _e3009;
            }
            let _e3014 = phi_3695_;
            if (_e3007 > _e3010) {
                phi_3700_ = _e3007;
            } else {
                phi_3700_ = _e3010;
            }
            let _e3017 = phi_3700_;
            if (_e3008 > _e3011) {
                phi_3705_ = _e3008;
            } else {
                phi_3705_ = _e3011;
            }
            let _e3020 = phi_3705_;
            let _e3021 = abs(_e2963);
            let _e3022 = abs(_e2976);
            let _e3023 = abs(_e2989);
            if (_e3014 > _e3021) {
                phi_3713_ = _e3014;
            } else {
                phi_3713_ = _e3021;
            }
            let _e3026 = phi_3713_;
            if (_e3017 > _e3022) {
                phi_3718_ = _e3017;
            } else {
                phi_3718_ = _e3022;
            }
            let _e3029 = phi_3718_;
            if (_e3020 > _e3023) {
                phi_3723_ = _e3020;
            } else {
                phi_3723_ = _e3023;
            }
            let _e3032 = phi_3723_;
            let _e3033 = (_e2919 - _e2875);
            let _e3034 = (_e2932 - _e2888);
            let _e3035 = (_e2945 - _e2901);
            let _e3036 = (_e2963 - _e2875);
            let _e3037 = (_e2976 - _e2888);
            let _e3038 = (_e2989 - _e2901);
            let _e3042 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3034), abs(_e3035));
            let _e3043 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3033), _e3042);
            let _e3044 = (_e3033 / _e3043);
            let _e3045 = (_e3034 / _e3043);
            let _e3046 = (_e3035 / _e3043);
            let _e3050 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3037), abs(_e3038));
            let _e3051 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3036), _e3050);
            let _e3052 = (_e3036 / _e3051);
            let _e3053 = (_e3037 / _e3051);
            let _e3054 = (_e3038 / _e3051);
            let _e3057 = ((_e3045 * _e3054) - (_e3053 * _e3046));
            let _e3060 = ((_e3046 * _e3052) - (_e3054 * _e3044));
            let _e3063 = ((_e3044 * _e3053) - (_e3052 * _e3045));
            let _e3065 = p.member.eye;
            let _e3078 = (1f / sqrt((((_e3057 * _e3057) + (_e3060 * _e3060)) + (_e3063 * _e3063))));
            let _e3079 = (_e3057 * _e3078);
            let _e3080 = (_e3060 * _e3078);
            let _e3081 = (_e3063 * _e3078);
            if ((((_e3079 * (_e3065.x - _e3002)) + (_e3080 * (_e3065.y - _e3003))) + (_e3081 * (_e3065.z - _e3004))) < 0f) {
                phi_3787_ = vec3<f32>(-(_e3079), -(_e3080), -(_e3081));
            } else {
                phi_3787_ = vec3<f32>(_e3079, _e3080, _e3081);
            }
            let _e3094 = phi_3787_;
            if (_e2842.triangle < _e84) {
            } else {
                return;
            }
            let _e3099 = triangles.member[(0u + _e2842.triangle)];
            let _e3101 = (_e3099.i0_ & 2147483647u);
            if (_e3101 < _e87) {
            } else {
                return;
            }
            let _e3107 = vertices.member[(0u + _e3101)];
            if (_e3099.i1_ < _e87) {
            } else {
                return;
            }
            let _e3111 = vertices.member[(0u + _e3099.i1_)];
            if (_e3099.i2_ < _e87) {
            } else {
                return;
            }
            let _e3115 = vertices.member[(0u + _e3099.i2_)];
            let _e3116 = array<abi_Vertex, 3>(_e3107, _e3111, _e3115);
            if (_e3116[0].material < _e90) {
            } else {
                return;
            }
            let _e3122 = materials.member[(0u + _e3116[0].material)];
            let _e3139 = (1f / 255f);
            let _e3158 = (1f / 255f);
            let _e3180 = (1f / 255f);
            if (_e3122.color_size == 0u) {
                phi_4030_ = vec3<f32>(1f, 1f, 1f);
            } else {
                local.offset = _e3122.color_offset;
                local.size = _e3122.color_size;
                local.flags = _e3122.flags;
                let _e3223 = _lt_shaders_texture_TextureView_quad((&local), (((_e3116[0].u * _e2848) + (_e3116[1].u * _e2842.u)) + (_e3116[2].u * _e2842.v)), (((_e3116[0].v * _e2848) + (_e3116[1].v * _e2842.u)) + (_e3116[2].v * _e2842.v)));
                if (_e3223.indices[0] < _e102) {
                } else {
                    return;
                }
                let _e3229 = color_texels.member[(0u + _e3223.indices[0])];
                let _e3240 = (1f / 255f);
                if (_e3223.indices[1] < _e102) {
                } else {
                    return;
                }
                let _e3254 = color_texels.member[(0u + _e3223.indices[1])];
                let _e3265 = (1f / 255f);
                if (_e3223.indices[2] < _e102) {
                } else {
                    return;
                }
                let _e3282 = color_texels.member[(0u + _e3223.indices[2])];
                let _e3293 = (1f / 255f);
                if (_e3223.indices[3] < _e102) {
                } else {
                    return;
                }
                let _e3310 = color_texels.member[(0u + _e3223.indices[3])];
                let _e3321 = (1f / 255f);
                let _e3330 = (((((f32((_e3229 & 255u)) * _e3240) * _e3223.weights.x) + ((f32((_e3254 & 255u)) * _e3265) * _e3223.weights.y)) + ((f32((_e3282 & 255u)) * _e3293) * _e3223.weights.z)) + ((f32((_e3310 & 255u)) * _e3321) * _e3223.weights.w));
                let _e3331 = (((((f32(((_e3229 >> bitcast<u32>(8i)) & 255u)) * _e3240) * _e3223.weights.x) + ((f32(((_e3254 >> bitcast<u32>(8i)) & 255u)) * _e3265) * _e3223.weights.y)) + ((f32(((_e3282 >> bitcast<u32>(8i)) & 255u)) * _e3293) * _e3223.weights.z)) + ((f32(((_e3310 >> bitcast<u32>(8i)) & 255u)) * _e3321) * _e3223.weights.w));
                let _e3332 = (((((f32(((_e3229 >> bitcast<u32>(16i)) & 255u)) * _e3240) * _e3223.weights.x) + ((f32(((_e3254 >> bitcast<u32>(16i)) & 255u)) * _e3265) * _e3223.weights.y)) + ((f32(((_e3282 >> bitcast<u32>(16i)) & 255u)) * _e3293) * _e3223.weights.z)) + ((f32(((_e3310 >> bitcast<u32>(16i)) & 255u)) * _e3321) * _e3223.weights.w));
                phi_4030_ = vec3<f32>((_e3330 * _e3330), (_e3331 * _e3331), (_e3332 * _e3332));
            }
            let _e3338 = phi_4030_;
            let _e3340 = ((_e3122.base_color.x * ((((f32((_e3116[0].color & 255u)) * _e3139) * _e2848) + ((f32((_e3116[1].color & 255u)) * _e3158) * _e2842.u)) + ((f32((_e3116[2].color & 255u)) * _e3180) * _e2842.v))) * _e3338.x);
            let _e3342 = ((_e3122.base_color.y * ((((f32(((_e3116[0].color >> bitcast<u32>(8i)) & 255u)) * _e3139) * _e2848) + ((f32(((_e3116[1].color >> bitcast<u32>(8i)) & 255u)) * _e3158) * _e2842.u)) + ((f32(((_e3116[2].color >> bitcast<u32>(8i)) & 255u)) * _e3180) * _e2842.v))) * _e3338.y);
            let _e3344 = ((_e3122.base_color.z * ((((f32(((_e3116[0].color >> bitcast<u32>(16i)) & 255u)) * _e3139) * _e2848) + ((f32(((_e3116[1].color >> bitcast<u32>(16i)) & 255u)) * _e3158) * _e2842.u)) + ((f32(((_e3116[2].color >> bitcast<u32>(16i)) & 255u)) * _e3180) * _e2842.v))) * _e3338.z);
            let _e3345 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e3029, _e3032);
            let _e3346 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e3026, _e3345);
            if ((_e3122.flags & 2u) == 0u) {
                phi_4045_ = 0u;
            } else {
                phi_4045_ = 1u;
            }
            let _e3351 = phi_4045_;
            if (_e3116[0].normal == 2147516416u) {
                phi_4275_ = _e3094;
            } else {
                let _e3364 = (f32((bitcast<i32>((_e3116[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3370 = (f32((bitcast<i32>(_e3116[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3374 = ((1f - abs(_e3364)) - abs(_e3370));
                if (_e3374 < 0f) {
                    phi_4072_ = -(_e3374);
                } else {
                    phi_4072_ = 0f;
                }
                let _e3378 = phi_4072_;
                if (_e3364 < 0f) {
                    phi_4079_ = (_e3364 + _e3378);
                } else {
                    phi_4079_ = (_e3364 - _e3378);
                }
                let _e3383 = phi_4079_;
                if (_e3370 < 0f) {
                    phi_4086_ = (_e3370 + _e3378);
                } else {
                    phi_4086_ = (_e3370 - _e3378);
                }
                let _e3388 = phi_4086_;
                let _e3395 = (1f / sqrt((((_e3383 * _e3383) + (_e3388 * _e3388)) + (_e3374 * _e3374))));
                let _e3411 = (f32((bitcast<i32>((_e3116[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3417 = (f32((bitcast<i32>(_e3116[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3421 = ((1f - abs(_e3411)) - abs(_e3417));
                if (_e3421 < 0f) {
                    phi_4121_ = -(_e3421);
                } else {
                    phi_4121_ = 0f;
                }
                let _e3425 = phi_4121_;
                if (_e3411 < 0f) {
                    phi_4128_ = (_e3411 + _e3425);
                } else {
                    phi_4128_ = (_e3411 - _e3425);
                }
                let _e3430 = phi_4128_;
                if (_e3417 < 0f) {
                    phi_4135_ = (_e3417 + _e3425);
                } else {
                    phi_4135_ = (_e3417 - _e3425);
                }
                let _e3435 = phi_4135_;
                let _e3442 = (1f / sqrt((((_e3430 * _e3430) + (_e3435 * _e3435)) + (_e3421 * _e3421))));
                let _e3461 = (f32((bitcast<i32>((_e3116[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3467 = (f32((bitcast<i32>(_e3116[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3471 = ((1f - abs(_e3461)) - abs(_e3467));
                if (_e3471 < 0f) {
                    phi_4173_ = -(_e3471);
                } else {
                    phi_4173_ = 0f;
                }
                let _e3475 = phi_4173_;
                if (_e3461 < 0f) {
                    phi_4180_ = (_e3461 + _e3475);
                } else {
                    phi_4180_ = (_e3461 - _e3475);
                }
                let _e3480 = phi_4180_;
                if (_e3467 < 0f) {
                    phi_4187_ = (_e3467 + _e3475);
                } else {
                    phi_4187_ = (_e3467 - _e3475);
                }
                let _e3485 = phi_4187_;
                let _e3492 = (1f / sqrt((((_e3480 * _e3480) + (_e3485 * _e3485)) + (_e3471 * _e3471))));
                let _e3499 = ((((_e3383 * _e3395) * _e2848) + ((_e3430 * _e3442) * _e2842.u)) + ((_e3480 * _e3492) * _e2842.v));
                let _e3500 = ((((_e3388 * _e3395) * _e2848) + ((_e3435 * _e3442) * _e2842.u)) + ((_e3485 * _e3492) * _e2842.v));
                let _e3501 = ((((_e3374 * _e3395) * _e2848) + ((_e3421 * _e3442) * _e2842.u)) + ((_e3471 * _e3492) * _e2842.v));
                if (_e2842.instance < _e96) {
                } else {
                    return;
                }
                let _e3508 = instances.member[(0u + _e2842.instance)].world_to_object[0u];
                let _e3517 = instances.member[(0u + _e2842.instance)].world_to_object[1u];
                let _e3529 = instances.member[(0u + _e2842.instance)].world_to_object[2u];
                let _e3536 = (((_e3508.x * _e3499) + (_e3517.x * _e3500)) + (_e3529.x * _e3501));
                let _e3537 = (((_e3508.y * _e3499) + (_e3517.y * _e3500)) + (_e3529.y * _e3501));
                let _e3538 = (((_e3508.z * _e3499) + (_e3517.z * _e3500)) + (_e3529.z * _e3501));
                let _e3544 = sqrt((((_e3536 * _e3536) + (_e3537 * _e3537)) + (_e3538 * _e3538)));
                if (_e3544 > 0f) {
                    let _e3546 = (_e3536 / _e3544);
                    let _e3547 = (_e3537 / _e3544);
                    let _e3548 = (_e3538 / _e3544);
                    if ((((_e3546 * _e3094.x) + (_e3547 * _e3094.y)) + (_e3548 * _e3094.z)) < 0f) {
                        phi_4273_ = vec3<f32>(-(_e3546), -(_e3547), -(_e3548));
                    } else {
                        phi_4273_ = vec3<f32>(_e3546, _e3547, _e3548);
                    }
                    let _e3564 = phi_4273_;
                    phi_4274_ = _e3564;
                } else {
                    phi_4274_ = _e3094;
                }
                let _e3566 = phi_4274_;
                phi_4275_ = _e3566;
            }
            let _e3568 = phi_4275_;
            if (_e3340 > 0f) {
                if (_e3340 < 1f) {
                    phi_4284_ = _e3340;
                } else {
                    phi_4284_ = 1f;
                }
                let _e3572 = phi_4284_;
                phi_4285_ = _e3572;
            } else {
                phi_4285_ = 0f;
            }
            let _e3574 = phi_4285_;
            if (_e3342 > 0f) {
                if (_e3342 < 1f) {
                    phi_4295_ = _e3342;
                } else {
                    phi_4295_ = 1f;
                }
                let _e3579 = phi_4295_;
                phi_4296_ = _e3579;
            } else {
                phi_4296_ = 0f;
            }
            let _e3581 = phi_4296_;
            if (_e3344 > 0f) {
                if (_e3344 < 1f) {
                    phi_4306_ = _e3344;
                } else {
                    phi_4306_ = 1f;
                }
                let _e3586 = phi_4306_;
                phi_4307_ = _e3586;
            } else {
                phi_4307_ = 0f;
            }
            let _e3588 = phi_4307_;
            let _e3591 = ((sqrt(_e3574) * 255f) + 0.5f);
            let _e3600 = ((sqrt(_e3581) * 255f) + 0.5f);
            let _e3612 = ((sqrt(_e3588) * 255f) + 0.5f);
            phi_4342_ = abi_Sample(vec3<f32>(_e3002, _e3003, _e3004), _e3346, _e3094, _e3351, _e3568, ((select(select(u32(_e3591), 0u, (_e3591 < bitcast<f32>(0u))), 4294967295u, (_e3591 > bitcast<f32>(1333788671u))) | (select(select(u32(_e3600), 0u, (_e3600 < bitcast<f32>(0u))), 4294967295u, (_e3600 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e3612), 0u, (_e3612 < bitcast<f32>(0u))), 4294967295u, (_e3612 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_4342_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e3626 = phi_4342_;
        if (_e114.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e114.first_primitive)] = _e3626;
        if (_e2842.triangle != 4294967295u) {
            let _e3635 = ((1f - _e2842.u) - _e2842.v);
            if (_e2842.triangle < _e84) {
            } else {
                return;
            }
            let _e3640 = triangles.member[(0u + _e2842.triangle)];
            let _e3642 = (_e3640.i0_ & 2147483647u);
            if (_e3642 < _e105) {
            } else {
                return;
            }
            let _e3648 = before.member[(0u + _e3642)];
            if (_e3640.i1_ < _e105) {
            } else {
                return;
            }
            let _e3652 = before.member[(0u + _e3640.i1_)];
            if (_e3640.i2_ < _e105) {
            } else {
                return;
            }
            let _e3656 = before.member[(0u + _e3640.i2_)];
            if (_e2842.instance < _e96) {
            } else {
                return;
            }
            let _e3666 = instances.member[(0u + _e2842.instance)].object_to_world[0u];
            let _e3679 = instances.member[(0u + _e2842.instance)].object_to_world[1u];
            let _e3692 = instances.member[(0u + _e2842.instance)].object_to_world[2u];
            if (_e2842.instance < _e96) {
            } else {
                return;
            }
            let _e3716 = instances.member[(0u + _e2842.instance)].object_to_world[0u];
            let _e3729 = instances.member[(0u + _e2842.instance)].object_to_world[1u];
            let _e3742 = instances.member[(0u + _e2842.instance)].object_to_world[2u];
            if (_e2842.instance < _e96) {
            } else {
                return;
            }
            let _e3769 = instances.member[(0u + _e2842.instance)].object_to_world[0u];
            let _e3782 = instances.member[(0u + _e2842.instance)].object_to_world[1u];
            let _e3795 = instances.member[(0u + _e2842.instance)].object_to_world[2u];
            phi_4565_ = vec3<f32>((((((((_e3666.x * _e3648.x) + (_e3666.y * _e3648.y)) + (_e3666.z * _e3648.z)) + (_e3666.w * 1f)) * _e3635) + (((((_e3716.x * _e3652.x) + (_e3716.y * _e3652.y)) + (_e3716.z * _e3652.z)) + (_e3716.w * 1f)) * _e2842.u)) + (((((_e3769.x * _e3656.x) + (_e3769.y * _e3656.y)) + (_e3769.z * _e3656.z)) + (_e3769.w * 1f)) * _e2842.v)), (((((((_e3679.x * _e3648.x) + (_e3679.y * _e3648.y)) + (_e3679.z * _e3648.z)) + (_e3679.w * 1f)) * _e3635) + (((((_e3729.x * _e3652.x) + (_e3729.y * _e3652.y)) + (_e3729.z * _e3652.z)) + (_e3729.w * 1f)) * _e2842.u)) + (((((_e3782.x * _e3656.x) + (_e3782.y * _e3656.y)) + (_e3782.z * _e3656.z)) + (_e3782.w * 1f)) * _e2842.v)), (((((((_e3692.x * _e3648.x) + (_e3692.y * _e3648.y)) + (_e3692.z * _e3648.z)) + (_e3692.w * 1f)) * _e3635) + (((((_e3742.x * _e3652.x) + (_e3742.y * _e3652.y)) + (_e3742.z * _e3652.z)) + (_e3742.w * 1f)) * _e2842.u)) + (((((_e3795.x * _e3656.x) + (_e3795.y * _e3656.y)) + (_e3795.z * _e3656.z)) + (_e3795.w * 1f)) * _e2842.v)));
        } else {
            phi_4565_ = vec3<f32>(0f, 0f, 0f);
        }
        let _e3815 = phi_4565_;
        if (_e114.first_primitive < arrayLength((&past.member))) {
        } else {
            return;
        }
        past.member[(0u + _e114.first_primitive)] = vec4<f32>(_e3815.x, _e3815.y, _e3815.z, 1f);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_instanced_alpha_color_motion_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
