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

struct type_31 {
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

struct type_35 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_39 {
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

struct type_43 {
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

struct type_51 {
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
var<storage> vertices: type_39;
@group(0) @binding(4) 
var<storage> materials: type_43;
@group(0) @binding(0) 
var<uniform> p: type_51;
@group(0) @binding(1) 
var<storage> nodes: type_31;
@group(0) @binding(2) 
var<storage> triangles: type_35;
@group(0) @binding(5) 
var<storage, read_write> samples: type_20;
@group(0) @binding(6) 
var<storage> color_texels: type_9;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_209_: lt_bvh_traverse_Tree;
    var phi_210_: bool;
    var phi_211_: lt_bvh_traverse_Tree;
    var phi_212_: bool;
    var phi_217_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_209_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_210_ = false;
        } else {
            phi_209_ = lt_bvh_traverse_Tree();
            phi_210_ = true;
        }
        let _e82 = phi_209_;
        let _e84 = phi_210_;
        phi_211_ = _e82;
        phi_212_ = _e84;
    } else {
        phi_211_ = lt_bvh_traverse_Tree();
        phi_212_ = true;
    }
    let _e86 = phi_211_;
    let _e88 = phi_212_;
    if _e88 {
        phi_217_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_217_ = _e86;
    }
    let _e93 = phi_217_;
    return lt_bvh_traverse_Tree(_e93.root, _e93.first_primitive);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_232_: bool;
    var phi_236_: f32;

    if (param_3 != param_3) {
        phi_232_ = true;
    } else {
        let _e72 = (param_4 >= param_3);
        if _e72 {
        }
        phi_232_ = _e72;
    }
    let _e74 = phi_232_;
    if _e74 {
        phi_236_ = param_4;
    } else {
        phi_236_ = param_3;
    }
    let _e76 = phi_236_;
    return _e76;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_248_: bool;
    var phi_252_: f32;

    if (param_5 != param_5) {
        phi_248_ = true;
    } else {
        let _e72 = (param_6 <= param_5);
        if _e72 {
        }
        phi_248_ = _e72;
    }
    let _e74 = phi_248_;
    if _e74 {
        phi_252_ = param_6;
    } else {
        phi_252_ = param_5;
    }
    let _e76 = phi_252_;
    return _e76;
}

fn _lt_shaders_texture_TextureView_quad(param_7: ptr<function, texture_TextureView>, param_8: f32, param_9: f32) -> texture_TexelQuad {
    var phi_294_: f32;
    var phi_299_: f32;
    var phi_300_: bool;
    var phi_301_: f32;
    var phi_302_: bool;
    var phi_306_: f32;
    var phi_332_: f32;
    var phi_337_: f32;
    var phi_338_: bool;
    var phi_339_: f32;
    var phi_340_: bool;
    var phi_344_: f32;
    var phi_352_: f32;
    var phi_353_: f32;
    var phi_354_: f32;
    var phi_363_: f32;
    var phi_364_: f32;
    var phi_382_: u32;
    var phi_396_: u32;
    var phi_403_: u32;
    var phi_408_: u32;
    var phi_414_: u32;
    var phi_419_: u32;
    var phi_421_: texture_Axis;
    var phi_449_: f32;
    var phi_454_: f32;
    var phi_455_: bool;
    var phi_456_: f32;
    var phi_457_: bool;
    var phi_461_: f32;
    var phi_487_: f32;
    var phi_492_: f32;
    var phi_493_: bool;
    var phi_494_: f32;
    var phi_495_: bool;
    var phi_499_: f32;
    var phi_507_: f32;
    var phi_508_: f32;
    var phi_509_: f32;
    var phi_518_: f32;
    var phi_519_: f32;
    var phi_537_: u32;
    var phi_551_: u32;
    var phi_558_: u32;
    var phi_563_: u32;
    var phi_569_: u32;
    var phi_574_: u32;
    var phi_576_: texture_Axis;

    let _e73 = (*param_7).size;
    let _e74 = (_e73 & 65535u);
    let _e76 = (*param_7).size;
    let _e78 = (_e76 >> bitcast<u32>(16i));
    let _e80 = (*param_7).flags;
    let _e82 = ((_e80 & 4u) != 0u);
    let _e84 = (*param_7).flags;
    let _e87 = ((_e84 >> bitcast<u32>(4u)) & 3u);
    if (_e87 == 0u) {
        if (param_8 > -8388608f) {
            let _e100 = f32(select(0i, select(select(i32(param_8), i32(-2147483648), (param_8 < bitcast<f32>(3472883712u))), 2147483647i, (param_8 > bitcast<f32>(1325400063u))), (param_8 == param_8)));
            if (_e100 > param_8) {
                phi_294_ = 1f;
            } else {
                phi_294_ = 0f;
            }
            let _e103 = phi_294_;
            if (param_8 < 8388608f) {
                phi_299_ = (_e100 - _e103);
                phi_300_ = false;
            } else {
                phi_299_ = f32();
                phi_300_ = true;
            }
            let _e106 = phi_299_;
            let _e108 = phi_300_;
            phi_301_ = _e106;
            phi_302_ = _e108;
        } else {
            phi_301_ = f32();
            phi_302_ = true;
        }
        let _e110 = phi_301_;
        let _e112 = phi_302_;
        if _e112 {
            phi_306_ = param_8;
        } else {
            phi_306_ = _e110;
        }
        let _e114 = phi_306_;
        phi_354_ = (param_8 - _e114);
    } else {
        if (_e87 == 1u) {
            let _e117 = (param_8 * 0.5f);
            if (_e117 > -8388608f) {
                let _e129 = f32(select(0i, select(select(i32(_e117), i32(-2147483648), (_e117 < bitcast<f32>(3472883712u))), 2147483647i, (_e117 > bitcast<f32>(1325400063u))), (_e117 == _e117)));
                if (_e129 > _e117) {
                    phi_332_ = 1f;
                } else {
                    phi_332_ = 0f;
                }
                let _e132 = phi_332_;
                if (_e117 < 8388608f) {
                    phi_337_ = (_e129 - _e132);
                    phi_338_ = false;
                } else {
                    phi_337_ = f32();
                    phi_338_ = true;
                }
                let _e135 = phi_337_;
                let _e137 = phi_338_;
                phi_339_ = _e135;
                phi_340_ = _e137;
            } else {
                phi_339_ = f32();
                phi_340_ = true;
            }
            let _e139 = phi_339_;
            let _e141 = phi_340_;
            if _e141 {
                phi_344_ = _e117;
            } else {
                phi_344_ = _e139;
            }
            let _e143 = phi_344_;
            let _e145 = (param_8 - (2f * _e143));
            if (_e145 > 1f) {
                phi_352_ = (2f - _e145);
            } else {
                phi_352_ = _e145;
            }
            let _e149 = phi_352_;
            phi_353_ = _e149;
        } else {
            phi_353_ = param_8;
        }
        let _e151 = phi_353_;
        phi_354_ = _e151;
    }
    let _e153 = phi_354_;
    if (_e153 > 0f) {
        if (_e153 < 1f) {
            phi_363_ = _e153;
        } else {
            phi_363_ = 1f;
        }
        let _e157 = phi_363_;
        phi_364_ = _e157;
    } else {
        phi_364_ = 0f;
    }
    let _e159 = phi_364_;
    let _e160 = (_e74 - 1u);
    let _e162 = (_e159 * f32(_e74));
    if _e82 {
        let _e169 = select(select(u32(_e162), 0u, (_e162 < bitcast<f32>(0u))), 4294967295u, (_e162 > bitcast<f32>(1333788671u)));
        if (_e160 < _e169) {
            phi_382_ = _e160;
        } else {
            phi_382_ = _e169;
        }
        let _e172 = phi_382_;
        phi_421_ = texture_Axis(_e172, _e172, 0f);
    } else {
        let _e174 = (_e162 + 0.5f);
        let _e181 = select(select(u32(_e174), 0u, (_e174 < bitcast<f32>(0u))), 4294967295u, (_e174 > bitcast<f32>(1333788671u)));
        if (_e74 < _e181) {
            phi_396_ = _e74;
        } else {
            phi_396_ = _e181;
        }
        let _e184 = phi_396_;
        if (_e87 == 0u) {
            phi_403_ = _e160;
        } else {
            phi_403_ = 0u;
        }
        let _e189 = phi_403_;
        if (_e87 == 0u) {
            phi_408_ = 0u;
        } else {
            phi_408_ = _e160;
        }
        let _e192 = phi_408_;
        if (_e184 == 0u) {
            phi_414_ = _e189;
        } else {
            phi_414_ = (_e184 - 1u);
        }
        let _e196 = phi_414_;
        if (_e184 > _e160) {
            phi_419_ = _e192;
        } else {
            phi_419_ = _e184;
        }
        let _e199 = phi_419_;
        phi_421_ = texture_Axis(_e196, _e199, (_e174 - f32(_e184)));
    }
    let _e202 = phi_421_;
    let _e204 = (*param_7).flags;
    let _e207 = ((_e204 >> bitcast<u32>(6u)) & 3u);
    if (_e207 == 0u) {
        if (param_9 > -8388608f) {
            let _e220 = f32(select(0i, select(select(i32(param_9), i32(-2147483648), (param_9 < bitcast<f32>(3472883712u))), 2147483647i, (param_9 > bitcast<f32>(1325400063u))), (param_9 == param_9)));
            if (_e220 > param_9) {
                phi_449_ = 1f;
            } else {
                phi_449_ = 0f;
            }
            let _e223 = phi_449_;
            if (param_9 < 8388608f) {
                phi_454_ = (_e220 - _e223);
                phi_455_ = false;
            } else {
                phi_454_ = f32();
                phi_455_ = true;
            }
            let _e226 = phi_454_;
            let _e228 = phi_455_;
            phi_456_ = _e226;
            phi_457_ = _e228;
        } else {
            phi_456_ = f32();
            phi_457_ = true;
        }
        let _e230 = phi_456_;
        let _e232 = phi_457_;
        if _e232 {
            phi_461_ = param_9;
        } else {
            phi_461_ = _e230;
        }
        let _e234 = phi_461_;
        phi_509_ = (param_9 - _e234);
    } else {
        if (_e207 == 1u) {
            let _e237 = (param_9 * 0.5f);
            if (_e237 > -8388608f) {
                let _e249 = f32(select(0i, select(select(i32(_e237), i32(-2147483648), (_e237 < bitcast<f32>(3472883712u))), 2147483647i, (_e237 > bitcast<f32>(1325400063u))), (_e237 == _e237)));
                if (_e249 > _e237) {
                    phi_487_ = 1f;
                } else {
                    phi_487_ = 0f;
                }
                let _e252 = phi_487_;
                if (_e237 < 8388608f) {
                    phi_492_ = (_e249 - _e252);
                    phi_493_ = false;
                } else {
                    phi_492_ = f32();
                    phi_493_ = true;
                }
                let _e255 = phi_492_;
                let _e257 = phi_493_;
                phi_494_ = _e255;
                phi_495_ = _e257;
            } else {
                phi_494_ = f32();
                phi_495_ = true;
            }
            let _e259 = phi_494_;
            let _e261 = phi_495_;
            if _e261 {
                phi_499_ = _e237;
            } else {
                phi_499_ = _e259;
            }
            let _e263 = phi_499_;
            let _e265 = (param_9 - (2f * _e263));
            if (_e265 > 1f) {
                phi_507_ = (2f - _e265);
            } else {
                phi_507_ = _e265;
            }
            let _e269 = phi_507_;
            phi_508_ = _e269;
        } else {
            phi_508_ = param_9;
        }
        let _e271 = phi_508_;
        phi_509_ = _e271;
    }
    let _e273 = phi_509_;
    if (_e273 > 0f) {
        if (_e273 < 1f) {
            phi_518_ = _e273;
        } else {
            phi_518_ = 1f;
        }
        let _e277 = phi_518_;
        phi_519_ = _e277;
    } else {
        phi_519_ = 0f;
    }
    let _e279 = phi_519_;
    let _e280 = (_e78 - 1u);
    let _e282 = (_e279 * f32(_e78));
    if _e82 {
        let _e289 = select(select(u32(_e282), 0u, (_e282 < bitcast<f32>(0u))), 4294967295u, (_e282 > bitcast<f32>(1333788671u)));
        if (_e280 < _e289) {
            phi_537_ = _e280;
        } else {
            phi_537_ = _e289;
        }
        let _e292 = phi_537_;
        phi_576_ = texture_Axis(_e292, _e292, 0f);
    } else {
        let _e294 = (_e282 + 0.5f);
        let _e301 = select(select(u32(_e294), 0u, (_e294 < bitcast<f32>(0u))), 4294967295u, (_e294 > bitcast<f32>(1333788671u)));
        if (_e78 < _e301) {
            phi_551_ = _e78;
        } else {
            phi_551_ = _e301;
        }
        let _e304 = phi_551_;
        if (_e207 == 0u) {
            phi_558_ = _e280;
        } else {
            phi_558_ = 0u;
        }
        let _e309 = phi_558_;
        if (_e207 == 0u) {
            phi_563_ = 0u;
        } else {
            phi_563_ = _e280;
        }
        let _e312 = phi_563_;
        if (_e304 == 0u) {
            phi_569_ = _e309;
        } else {
            phi_569_ = (_e304 - 1u);
        }
        let _e316 = phi_569_;
        if (_e304 > _e280) {
            phi_574_ = _e312;
        } else {
            phi_574_ = _e304;
        }
        let _e319 = phi_574_;
        phi_576_ = texture_Axis(_e316, _e319, (_e294 - f32(_e304)));
    }
    let _e322 = phi_576_;
    let _e326 = (*param_7).offset;
    let _e333 = (*param_7).offset;
    let _e340 = (*param_7).offset;
    let _e347 = (*param_7).offset;
    return texture_TexelQuad(array<u32, 4>(((_e326 + (_e322.low * _e74)) + _e202.low), ((_e333 + (_e322.low * _e74)) + _e202.high), ((_e340 + (_e322.high * _e74)) + _e202.low), ((_e347 + (_e322.high * _e74)) + _e202.high)), vec4<f32>(((1f - _e202.fraction) * (1f - _e322.fraction)), (_e202.fraction * (1f - _e322.fraction)), ((1f - _e202.fraction) * _e322.fraction), (_e202.fraction * _e322.fraction)));
}

fn _lt_bvh_ray_Ray_new(param_10: vec3<f32>, param_11: vec3<f32>) -> lt_bvh_Ray {
    return lt_bvh_Ray(param_10, 0f, param_11, 300000000000000000000000000000000000000f);
}

fn _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(param_12: f32, param_13: f32) -> f32 {
    var phi_635_: f32;

    if (param_12 > param_13) {
        phi_635_ = param_12;
    } else {
        phi_635_ = param_13;
    }
    let _e73 = phi_635_;
    return _e73;
}

fn _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(param_14: vec3<f32>) -> vec3<f32> {
    return param_14;
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var phi_769_: bool;
    var phi_770_: bool;
    var phi_771_: bool;
    var phi_772_: bool;
    var phi_776_: bool;
    var phi_789_: bool;
    var phi_790_: bool;
    var phi_791_: bool;
    var phi_792_: bool;
    var phi_796_: bool;
    var phi_809_: bool;
    var phi_810_: bool;
    var phi_811_: bool;
    var phi_815_: bool;
    var phi_816_: bool;
    var phi_817_: bool;
    var phi_818_: bool;
    var phi_819_: bool;
    var phi_823_: bool;
    var phi_899_: f32;
    var phi_906_: f32;
    var phi_914_: f32;
    var phi_921_: f32;
    var phi_929_: f32;
    var phi_936_: f32;
    var phi_959_: f32;
    var phi_964_: f32;
    var phi_969_: f32;
    var phi_974_: f32;
    var phi_979_: f32;
    var phi_1010_: bool;
    var phi_1011_: bool;
    var phi_1019_: u32;
    var phi_1020_: u32;
    var phi_1037_: vec3<f32>;
    var phi_1038_: vec3<f32>;
    var phi_1051_: u32;
    var phi_1056_: u32;
    var phi_1061_: u32;
    var phi_1175_: bool;
    var phi_1176_: bool;
    var phi_1207_: u32;
    var phi_1209_: lt_bvh_Hit;
    var phi_1212_: u32;
    var phi_1297_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1324_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1351_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1357_: u32;
    var phi_1360_: u32;
    var phi_1374_: u32;
    var phi_1384_: u32;
    var phi_1394_: u32;
    var phi_1412_: u32;
    var phi_1422_: u32;
    var phi_1432_: u32;
    var phi_1468_: u32;
    var phi_1481_: u32;
    var phi_1486_: u32;
    var phi_1487_: u32;
    var phi_1488_: u32;
    var phi_1358_: u32;
    var phi_1361_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_1546_: lt_bvh_Hit;
    var phi_1549_: u32;
    var phi_1595_: vec3<f32>;
    var phi_1596_: vec3<f32>;
    var phi_1627_: vec3<f32>;
    var phi_1628_: vec3<f32>;
    var phi_1659_: vec3<f32>;
    var phi_1660_: vec3<f32>;
    var phi_1678_: bool;
    var phi_1679_: bool;
    var phi_1683_: f32;
    var phi_1684_: f32;
    var phi_1685_: f32;
    var phi_1686_: f32;
    var phi_1694_: f32;
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
    var phi_1761_: f32;
    var phi_1762_: bool;
    var phi_1763_: f32;
    var phi_1764_: bool;
    var phi_1765_: f32;
    var phi_1766_: bool;
    var phi_1784_: f32;
    var phi_1785_: bool;
    var phi_1786_: bool;
    var phi_1787_: f32;
    var phi_1788_: bool;
    var phi_1789_: bool;
    var phi_1793_: bool;
    var phi_1794_: f32;
    var phi_1795_: bool;
    var phi_1825_: vec3<f32>;
    var phi_1826_: vec3<f32>;
    var phi_1851_: vec3<f32>;
    var phi_1852_: vec3<f32>;
    var phi_1877_: vec3<f32>;
    var phi_1878_: vec3<f32>;
    var phi_1936_: f32;
    var phi_1945_: f32;
    var phi_1954_: f32;
    var phi_1963_: f32;
    var phi_1970_: f32;
    var phi_1977_: f32;
    var phi_1990_: f32;
    var phi_1999_: f32;
    var phi_2008_: f32;
    var phi_2017_: f32;
    var phi_2024_: f32;
    var phi_2031_: f32;
    var phi_2054_: f32;
    var phi_2059_: f32;
    var phi_2064_: f32;
    var phi_2072_: f32;
    var phi_2077_: f32;
    var phi_2082_: f32;
    var phi_2094_: f32;
    var phi_2099_: f32;
    var phi_2104_: f32;
    var phi_2109_: f32;
    var phi_2114_: lt_bvh_triangle_Intersection;
    var phi_2115_: bool;
    var phi_2116_: lt_bvh_triangle_Intersection;
    var phi_2117_: bool;
    var phi_2121_: lt_bvh_triangle_Intersection;
    var phi_2122_: bool;
    var phi_2123_: lt_bvh_triangle_Intersection;
    var phi_2124_: bool;
    var phi_2125_: bool;
    var phi_2129_: bool;
    var phi_2133_: lt_bvh_triangle_Intersection;
    var phi_2172_: bool;
    var phi_2173_: bool;
    var phi_2174_: bool;
    var phi_2175_: bool;
    var phi_2176_: bool;
    var phi_2177_: bool;
    var phi_2181_: bool;
    var phi_2182_: bool;
    var phi_2196_: bool;
    var phi_2204_: lt_bvh_Hit;
    var phi_2205_: lt_bvh_Hit;
    var phi_2206_: lt_bvh_Hit;
    var phi_2207_: lt_bvh_Hit;
    var phi_1547_: lt_bvh_Hit;
    var phi_1550_: u32;
    var phi_2208_: bool;
    var phi_2247_: bool;
    var phi_2248_: bool;
    var phi_2279_: u32;
    var phi_1210_: lt_bvh_Hit;
    var phi_1213_: u32;
    var phi_2280_: lt_bvh_Hit;
    var phi_2281_: lt_bvh_Hit;
    var phi_2282_: bool;
    var phi_2286_: lt_bvh_Hit;
    var phi_2350_: f32;
    var phi_2355_: f32;
    var phi_2360_: f32;
    var phi_2371_: f32;
    var phi_2376_: f32;
    var phi_2381_: f32;
    var phi_2457_: vec3<f32>;
    var phi_2700_: vec3<f32>;
    var phi_2715_: u32;
    var phi_2742_: f32;
    var phi_2749_: f32;
    var phi_2756_: f32;
    var phi_2791_: f32;
    var phi_2798_: f32;
    var phi_2805_: f32;
    var phi_2843_: f32;
    var phi_2850_: f32;
    var phi_2857_: f32;
    var phi_2916_: vec3<f32>;
    var phi_2917_: vec3<f32>;
    var phi_2918_: vec3<f32>;
    var phi_2927_: f32;
    var phi_2928_: f32;
    var phi_2938_: f32;
    var phi_2939_: f32;
    var phi_2949_: f32;
    var phi_2950_: f32;
    var phi_2985_: abi_Sample;
    var local_5: lt_bvh_Hit;
    var local_6: lt_bvh_Hit;

    let _e71 = id_1;
    let _e75 = arrayLength((&nodes.member));
    let _e78 = arrayLength((&triangles.member));
    let _e81 = arrayLength((&vertices.member));
    let _e90 = arrayLength((&color_texels.member));
    let _e93 = p.member.size[0u];
    let _e95 = p.member.size[1u];
    let _e96 = lt_shaders_entry_pixel_index(_e71, _e93, _e95);
    if (bitcast<i32>(_e96.root) != 0i) {
        let _e104 = p.member.eye;
        let _e107 = p.member.grid[0u];
        let _e109 = p.member.grid[1u];
        let _e128 = p.member.size[0u];
        let _e132 = ((((f32(_e71.x) + ((f32((_e71.y & (_e109 - 1u))) + 0.5f) / f32(_e109))) / f32(_e128)) * 2f) - 1f);
        let _e135 = p.member.size[1u];
        let _e139 = (1f - (((f32(_e71.y) + ((f32((_e71.x & (_e107 - 1u))) + 0.5f) / f32(_e107))) / f32(_e135)) * 2f));
        let _e141 = p.member.forward;
        let _e143 = p.member.right;
        let _e157 = p.member.up;
        let _e168 = _lt_bvh_ray_Ray_new(_e104, vec3<f32>(((_e141.x + (_e143.x * _e132)) + (_e157.x * _e139)), ((_e141.y + (_e143.y * _e132)) + (_e157.y * _e139)), ((_e141.z + (_e143.z * _e132)) + (_e157.z * _e139))));
        let _e170 = lt_bvh_Hit(_e168.tmax, 0f, 0f, 4294967295u, 4294967295u);
        let _e173 = abs(_e168.direction.x);
        let _e175 = abs(_e168.direction.y);
        let _e177 = abs(_e168.direction.z);
        if (abs(_e168.origin.x) < 1000000000000000f) {
            if (abs(_e168.origin.y) < 1000000000000000f) {
                phi_769_ = (abs(_e168.origin.z) < 1000000000000000f);
                phi_770_ = false;
            } else {
                phi_769_ = bool();
                phi_770_ = true;
            }
            let _e189 = phi_769_;
            let _e191 = phi_770_;
            phi_771_ = _e189;
            phi_772_ = _e191;
        } else {
            phi_771_ = bool();
            phi_772_ = true;
        }
        let _e193 = phi_771_;
        let _e195 = phi_772_;
        if _e195 {
            phi_776_ = false;
        } else {
            phi_776_ = _e193;
        }
        let _e197 = phi_776_;
        if _e197 {
            if (_e173 < 1000000000000000f) {
                if (_e175 < 1000000000000000f) {
                    phi_789_ = (_e177 < 1000000000000000f);
                    phi_790_ = false;
                } else {
                    phi_789_ = bool();
                    phi_790_ = true;
                }
                let _e202 = phi_789_;
                let _e204 = phi_790_;
                phi_791_ = _e202;
                phi_792_ = _e204;
            } else {
                phi_791_ = bool();
                phi_792_ = true;
            }
            let _e206 = phi_791_;
            let _e208 = phi_792_;
            if _e208 {
                phi_796_ = false;
            } else {
                phi_796_ = _e206;
            }
            let _e210 = phi_796_;
            if _e210 {
                if (_e173 > 0f) {
                    phi_810_ = bool();
                    phi_811_ = true;
                } else {
                    let _e212 = (_e175 > 0f);
                    if _e212 {
                        phi_809_ = bool();
                    } else {
                        phi_809_ = (_e177 > 0f);
                    }
                    let _e215 = phi_809_;
                    phi_810_ = _e215;
                    phi_811_ = _e212;
                }
                let _e217 = phi_810_;
                let _e219 = phi_811_;
                if _e219 {
                    phi_815_ = true;
                } else {
                    phi_815_ = _e217;
                }
                let _e221 = phi_815_;
                phi_816_ = _e221;
                phi_817_ = false;
            } else {
                phi_816_ = bool();
                phi_817_ = true;
            }
            let _e223 = phi_816_;
            let _e225 = phi_817_;
            phi_818_ = _e223;
            phi_819_ = _e225;
        } else {
            phi_818_ = bool();
            phi_819_ = true;
        }
        let _e227 = phi_818_;
        let _e229 = phi_819_;
        if _e229 {
            phi_823_ = false;
        } else {
            phi_823_ = _e227;
        }
        let _e231 = phi_823_;
        if _e231 {
            let _e232 = (0u >= _e75);
            if _e232 {
                phi_2280_ = lt_bvh_Hit();
            } else {
                if (0u < _e75) {
                } else {
                    return;
                }
                let _e238 = nodes.member[(0u + 0u)].frame[0u];
                let _e242 = nodes.member[(0u + 0u)].frame[1u];
                let _e246 = nodes.member[(0u + 0u)].frame[2u];
                let _e250 = nodes.member[(0u + 0u)].frame[0u];
                let _e254 = nodes.member[(0u + 0u)].frame[1u];
                let _e258 = nodes.member[(0u + 0u)].frame[2u];
                let _e262 = nodes.member[(0u + 0u)].frame[3u];
                let _e301 = core_intrinsics_maximum_number_nsz_f32_(abs(_e168.direction.x), abs(_e168.direction.y));
                let _e302 = core_intrinsics_maximum_number_nsz_f32_(_e301, abs(_e168.direction.z));
                let _e303 = (_e302 * 0.0000000000009094947f);
                if (abs(_e168.direction.x) < _e303) {
                    phi_899_ = _e303;
                } else {
                    phi_899_ = abs(_e168.direction.x);
                }
                let _e309 = phi_899_;
                if (_e168.direction.x < 0f) {
                    phi_906_ = (-1f / _e309);
                } else {
                    phi_906_ = (1f / _e309);
                }
                let _e314 = phi_906_;
                if (abs(_e168.direction.y) < _e303) {
                    phi_914_ = _e303;
                } else {
                    phi_914_ = abs(_e168.direction.y);
                }
                let _e320 = phi_914_;
                if (_e168.direction.y < 0f) {
                    phi_921_ = (-1f / _e320);
                } else {
                    phi_921_ = (1f / _e320);
                }
                let _e325 = phi_921_;
                if (abs(_e168.direction.z) < _e303) {
                    phi_929_ = _e303;
                } else {
                    phi_929_ = abs(_e168.direction.z);
                }
                let _e331 = phi_929_;
                if (_e168.direction.z < 0f) {
                    phi_936_ = (-1f / _e331);
                } else {
                    phi_936_ = (1f / _e331);
                }
                let _e336 = phi_936_;
                let _e343 = abs((bitcast<f32>(_e238) - _e168.origin.x));
                let _e344 = abs((bitcast<f32>(_e242) - _e168.origin.y));
                let _e345 = abs((bitcast<f32>(_e246) - _e168.origin.z));
                let _e352 = abs(((bitcast<f32>(_e250) + (bitcast<f32>((((_e262 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e168.origin.x));
                let _e353 = abs(((bitcast<f32>(_e254) + (bitcast<f32>((((_e262 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e168.origin.y));
                let _e354 = abs(((bitcast<f32>(_e258) + (bitcast<f32>((((_e262 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e168.origin.z));
                if (_e343 > _e352) {
                    phi_959_ = _e343;
                } else {
                    phi_959_ = _e352;
                }
                let _e357 = phi_959_;
                if (_e344 > _e353) {
                    phi_964_ = _e344;
                } else {
                    phi_964_ = _e353;
                }
                let _e360 = phi_964_;
                if (_e345 > _e354) {
                    phi_969_ = _e345;
                } else {
                    phi_969_ = _e354;
                }
                let _e363 = phi_969_;
                if (_e357 > _e360) {
                    phi_974_ = _e357;
                } else {
                    phi_974_ = _e360;
                }
                let _e366 = phi_974_;
                if (_e366 > _e363) {
                    phi_979_ = _e366;
                } else {
                    phi_979_ = _e363;
                }
                let _e369 = phi_979_;
                let _e373 = (_e369 * 0.0000019073486f);
                let _e374 = (abs(_e314) * _e373);
                let _e375 = (abs(_e325) * _e373);
                let _e376 = (abs(_e336) * _e373);
                let _e380 = (_e369 * 0.0000009536743f);
                let _e381 = (abs(_e314) * _e380);
                let _e382 = (abs(_e325) * _e380);
                let _e383 = (abs(_e336) * _e380);
                let _e387 = abs(_e168.direction.x);
                let _e389 = abs(_e168.direction.y);
                let _e391 = abs(_e168.direction.z);
                if (_e387 >= _e389) {
                    if (_e387 >= _e391) {
                        phi_1010_ = false;
                    } else {
                        phi_1010_ = true;
                    }
                    let _e395 = phi_1010_;
                    phi_1011_ = _e395;
                } else {
                    phi_1011_ = true;
                }
                let _e397 = phi_1011_;
                if _e397 {
                    if (_e389 >= _e391) {
                        phi_1019_ = 1u;
                    } else {
                        phi_1019_ = 2u;
                    }
                    let _e400 = phi_1019_;
                    phi_1020_ = _e400;
                } else {
                    phi_1020_ = 0u;
                }
                let _e402 = phi_1020_;
                if (_e402 == 0u) {
                    phi_1038_ = vec3<f32>(_e168.direction.y, _e168.direction.z, _e168.direction.x);
                } else {
                    if (_e402 == 1u) {
                        phi_1037_ = vec3<f32>(_e168.direction.z, _e168.direction.x, _e168.direction.y);
                    } else {
                        phi_1037_ = _e168.direction;
                    }
                    let _e414 = phi_1037_;
                    phi_1038_ = _e414;
                }
                let _e416 = phi_1038_;
                let _e419 = (_e416.x / _e416.z);
                let _e422 = (_e416.y / _e416.z);
                if (_e314 < 0f) {
                    phi_1051_ = 0u;
                } else {
                    phi_1051_ = 1u;
                }
                let _e427 = phi_1051_;
                if (_e325 < 0f) {
                    phi_1056_ = 0u;
                } else {
                    phi_1056_ = 2u;
                }
                let _e430 = phi_1056_;
                if (_e336 < 0f) {
                    phi_1061_ = 0u;
                } else {
                    phi_1061_ = 4u;
                }
                let _e433 = phi_1061_;
                let _e435 = ((_e427 | _e430) | _e433);
                let _e436 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e436.first[0], _e436.first[1], _e436.first[2], _e436.first[3], _e436.first[4], _e436.first[5], _e436.first[6], _e436.first[7], _e436.first[8], _e436.first[9], _e436.first[10], _e436.first[11], _e436.first[12], _e436.first[13], _e436.first[14], _e436.first[15], _e436.first[16], _e436.first[17], _e436.first[18], _e436.first[19], _e436.first[20], _e436.first[21], _e436.first[22], _e436.first[23], _e436.first[24], _e436.first[25], _e436.first[26], _e436.first[27], _e436.first[28], _e436.first[29], _e436.first[30], _e436.first[31]), array<u32, 32>(_e436.mask[0], _e436.mask[1], _e436.mask[2], _e436.mask[3], _e436.mask[4], _e436.mask[5], _e436.mask[6], _e436.mask[7], _e436.mask[8], _e436.mask[9], _e436.mask[10], _e436.mask[11], _e436.mask[12], _e436.mask[13], _e436.mask[14], _e436.mask[15], _e436.mask[16], _e436.mask[17], _e436.mask[18], _e436.mask[19], _e436.mask[20], _e436.mask[21], _e436.mask[22], _e436.mask[23], _e436.mask[24], _e436.mask[25], _e436.mask[26], _e436.mask[27], _e436.mask[28], _e436.mask[29], _e436.mask[30], _e436.mask[31]), _e436.len, _e436.group, _e436.group_mask);
                let _e510 = local_1.group_mask;
                if ((_e510 & 4278190080u) == 0u) {
                    let _e514 = local_1.len;
                    if (_e514 == 0u) {
                        phi_1175_ = false;
                    } else {
                        let _e518 = local_1.len;
                        local_1.len = (_e518 - 1u);
                        let _e521 = local_1.len;
                        if (_e521 < 32u) {
                        } else {
                            return;
                        }
                        let _e526 = local_1.first[(0u + _e521)];
                        local_1.group = _e526;
                        let _e529 = local_1.len;
                        if (_e529 < 32u) {
                        } else {
                            return;
                        }
                        let _e534 = local_1.mask[(0u + _e529)];
                        local_1.group_mask = _e534;
                        phi_1175_ = true;
                    }
                    let _e537 = phi_1175_;
                    phi_1176_ = _e537;
                } else {
                    phi_1176_ = true;
                }
                let _e539 = phi_1176_;
                if _e539 {
                    let _e541 = local_1.group_mask;
                    let _e547 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e541)), 32u, (_e541 == 0u)));
                    let _e551 = local_1.group_mask;
                    let _e565 = local_1.group_mask;
                    local_1.group_mask = (_e565 & ~((1u << bitcast<u32>((_e547 & 31u)))));
                    let _e568 = local_1.group;
                    phi_1207_ = (_e568 + countOneBits(((_e551 & ~((4294967295u << bitcast<u32>((((_e547 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1207_ = 4294967295u;
                }
                let _e571 = phi_1207_;
                phi_1209_ = _e170;
                phi_1212_ = _e571;
                loop {
                    let _e573 = phi_1209_;
                    let _e575 = phi_1212_;
                    local_6 = _e573;
                    let _e576 = (_e575 != 4294967295u);
                    if _e576 {
                        if (_e575 < _e75) {
                        } else {
                            return;
                        }
                        let _e584 = nodes.member[(0u + _e575)].frame[3u];
                        let _e609 = (bitcast<f32>((((_e584 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e314);
                        let _e610 = (bitcast<f32>((((_e584 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e325);
                        let _e611 = (bitcast<f32>((((_e584 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e336);
                        let _e614 = nodes.member[(0u + _e575)].frame[0u];
                        let _e618 = nodes.member[(0u + _e575)].frame[1u];
                        let _e622 = nodes.member[(0u + _e575)].frame[2u];
                        let _e630 = ((bitcast<f32>(_e614) - _e168.origin.x) * _e314);
                        let _e631 = ((bitcast<f32>(_e618) - _e168.origin.y) * _e325);
                        let _e632 = ((bitcast<f32>(_e622) - _e168.origin.z) * _e336);
                        let _e640 = nodes.member[(0u + _e575)].x;
                        if (_e314 < 0f) {
                            let _e651 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e640.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e657 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e651.unnamed.root, _e640.w), _e651.unnamed_1);
                            let _e663 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e657.unnamed, lt_bvh_traverse_Tree(_e640.x, _e657.unnamed_1.first_primitive));
                            phi_1297_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e663.unnamed, lt_bvh_traverse_Tree(_e663.unnamed_1.root, _e640.y));
                        } else {
                            let _e679 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e640.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e685 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e679.unnamed.root, _e640.y), _e679.unnamed_1);
                            let _e691 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e685.unnamed, lt_bvh_traverse_Tree(_e640.z, _e685.unnamed_1.first_primitive));
                            phi_1297_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e691.unnamed, lt_bvh_traverse_Tree(_e691.unnamed_1.root, _e640.w));
                        }
                        let _e699 = phi_1297_;
                        let _e709 = nodes.member[(0u + _e575)].y;
                        if (_e325 < 0f) {
                            let _e720 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e709.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e726 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e720.unnamed.root, _e709.w), _e720.unnamed_1);
                            let _e732 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e726.unnamed, lt_bvh_traverse_Tree(_e709.x, _e726.unnamed_1.first_primitive));
                            phi_1324_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e732.unnamed, lt_bvh_traverse_Tree(_e732.unnamed_1.root, _e709.y));
                        } else {
                            let _e748 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e709.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e754 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e748.unnamed.root, _e709.y), _e748.unnamed_1);
                            let _e760 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e754.unnamed, lt_bvh_traverse_Tree(_e709.z, _e754.unnamed_1.first_primitive));
                            phi_1324_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e760.unnamed, lt_bvh_traverse_Tree(_e760.unnamed_1.root, _e709.w));
                        }
                        let _e768 = phi_1324_;
                        let _e778 = nodes.member[(0u + _e575)].z;
                        if (_e336 < 0f) {
                            let _e789 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e778.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e795 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e789.unnamed.root, _e778.w), _e789.unnamed_1);
                            let _e801 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e795.unnamed, lt_bvh_traverse_Tree(_e778.x, _e795.unnamed_1.first_primitive));
                            phi_1351_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e801.unnamed, lt_bvh_traverse_Tree(_e801.unnamed_1.root, _e778.y));
                        } else {
                            let _e817 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e778.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e823 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e817.unnamed.root, _e778.y), _e817.unnamed_1);
                            let _e829 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e823.unnamed, lt_bvh_traverse_Tree(_e778.z, _e823.unnamed_1.first_primitive));
                            phi_1351_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e829.unnamed, lt_bvh_traverse_Tree(_e829.unnamed_1.root, _e778.w));
                        }
                        let _e837 = phi_1351_;
                        phi_1357_ = 0u;
                        phi_1360_ = 0u;
                        loop {
                            let _e847 = phi_1357_;
                            let _e849 = phi_1360_;
                            local_2 = _e849;
                            local_3 = _e849;
                            local_4 = _e849;
                            let _e850 = (_e847 < 8u);
                            if _e850 {
                                let _e852 = (_e847 >> bitcast<u32>(2i));
                                let _e853 = (_e847 & 3u);
                                if (_e852 == 0u) {
                                    phi_1374_ = _e699.unnamed.root;
                                } else {
                                    phi_1374_ = _e699.unnamed.first_primitive;
                                }
                                let _e856 = phi_1374_;
                                if (_e852 == 0u) {
                                    phi_1384_ = _e768.unnamed.root;
                                } else {
                                    phi_1384_ = _e768.unnamed.first_primitive;
                                }
                                let _e865 = phi_1384_;
                                if (_e852 == 0u) {
                                    phi_1394_ = _e837.unnamed.root;
                                } else {
                                    phi_1394_ = _e837.unnamed.first_primitive;
                                }
                                let _e874 = phi_1394_;
                                let _e887 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e856 >> bitcast<u32>(((_e853 * 8u) & 31u))) & 255u)) * _e609) + (_e630 - _e374)), ((f32(((_e865 >> bitcast<u32>(((_e853 * 8u) & 31u))) & 255u)) * _e610) + (_e631 - _e375)));
                                let _e888 = core_intrinsics_maximum_number_nsz_f32_(_e887, ((f32(((_e874 >> bitcast<u32>(((_e853 * 8u) & 31u))) & 255u)) * _e611) + (_e632 - _e376)));
                                if (_e852 == 0u) {
                                    phi_1412_ = _e699.unnamed_1.root;
                                } else {
                                    phi_1412_ = _e699.unnamed_1.first_primitive;
                                }
                                let _e891 = phi_1412_;
                                if (_e852 == 0u) {
                                    phi_1422_ = _e768.unnamed_1.root;
                                } else {
                                    phi_1422_ = _e768.unnamed_1.first_primitive;
                                }
                                let _e900 = phi_1422_;
                                if (_e852 == 0u) {
                                    phi_1432_ = _e837.unnamed_1.root;
                                } else {
                                    phi_1432_ = _e837.unnamed_1.first_primitive;
                                }
                                let _e909 = phi_1432_;
                                let _e922 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e891 >> bitcast<u32>(((_e853 * 8u) & 31u))) & 255u)) * _e609) + (_e630 + _e374)), ((f32(((_e900 >> bitcast<u32>(((_e853 * 8u) & 31u))) & 255u)) * _e610) + (_e631 + _e375)));
                                let _e923 = core_intrinsics_minimum_number_nsz_f32_(_e922, ((f32(((_e909 >> bitcast<u32>(((_e853 * 8u) & 31u))) & 255u)) * _e611) + (_e632 + _e376)));
                                if (_e888 <= _e923) {
                                    if (_e888 <= _e573.t) {
                                        if (_e923 >= _e168.tmin) {
                                            if (_e852 == 0u) {
                                                let _e930 = nodes.member[(0u + _e575)].links[2u];
                                                phi_1468_ = _e930;
                                            } else {
                                                let _e933 = nodes.member[(0u + _e575)].links[3u];
                                                phi_1468_ = _e933;
                                            }
                                            let _e935 = phi_1468_;
                                            let _e940 = ((_e935 >> bitcast<u32>(((_e853 * 8u) & 31u))) & 255u);
                                            let _e941 = (_e940 & 31u);
                                            if (_e941 >= 24u) {
                                                phi_1481_ = (24u + ((_e941 - 24u) ^ _e435));
                                            } else {
                                                phi_1481_ = _e941;
                                            }
                                            let _e947 = phi_1481_;
                                            phi_1486_ = (_e849 | ((_e940 >> bitcast<u32>(5i)) << bitcast<u32>((_e947 & 31u))));
                                        } else {
                                            phi_1486_ = _e849;
                                        }
                                        let _e955 = phi_1486_;
                                        phi_1487_ = _e955;
                                    } else {
                                        phi_1487_ = _e849;
                                    }
                                    let _e957 = phi_1487_;
                                    phi_1488_ = _e957;
                                } else {
                                    phi_1488_ = _e849;
                                }
                                let _e959 = phi_1488_;
                                phi_1358_ = (_e847 + 1u);
                                phi_1361_ = _e959;
                            } else {
                                phi_1358_ = u32();
                                phi_1361_ = u32();
                            }
                            let _e962 = phi_1358_;
                            let _e964 = phi_1361_;
                            continue;
                            continuing {
                                phi_1357_ = _e962;
                                phi_1360_ = _e964;
                                break if !(_e850);
                            }
                        }
                        let _e968 = nodes.member[(0u + _e575)].links[0u];
                        let _e972 = nodes.member[(0u + _e575)].frame[3u];
                        let _e976 = local_2;
                        if ((_e976 & 4278190080u) == 0u) {
                        } else {
                            let _e980 = local_1.group_mask;
                            if ((_e980 & 4278190080u) == 0u) {
                            } else {
                                let _e984 = local_1.len;
                                if (_e984 < 32u) {
                                    let _e987 = local_1.group;
                                    let _e989 = local_1.len;
                                    if (_e989 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.first[(0u + _e989)] = _e987;
                                    let _e995 = local_1.group_mask;
                                    let _e997 = local_1.len;
                                    if (_e997 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.mask[(0u + _e997)] = _e995;
                                    let _e1004 = local_1.len;
                                    local_1.len = (_e1004 + 1u);
                                }
                            }
                            local_1.group = (0u + _e968);
                            let _e1008 = local_3;
                            local_1.group_mask = ((_e1008 & 4278190080u) | (_e972 >> bitcast<u32>(24i)));
                        }
                        let _e1013 = local_4;
                        phi_1546_ = _e573;
                        phi_1549_ = (_e1013 & 16777215u);
                        loop {
                            let _e1016 = phi_1546_;
                            let _e1018 = phi_1549_;
                            local_5 = _e1016;
                            if (_e1018 == 0u) {
                                phi_1547_ = lt_bvh_Hit();
                                phi_1550_ = u32();
                                phi_2208_ = false;
                            } else {
                                let _e1022 = nodes.member[(0u + _e575)].links[1u];
                                let _e1027 = ((0u + _e1022) + select(firstTrailingBit(_e1018), 32u, (_e1018 == 0u)));
                                if (_e1027 < _e78) {
                                } else {
                                    return;
                                }
                                let _e1034 = triangles.member[(0u + _e1027)].v0_;
                                let _e1037 = (_e1034.x - _e168.origin.x);
                                let _e1040 = (_e1034.y - _e168.origin.y);
                                let _e1043 = (_e1034.z - _e168.origin.z);
                                if (_e402 == 0u) {
                                    phi_1596_ = vec3<f32>(_e1040, _e1043, _e1037);
                                } else {
                                    if (_e402 == 1u) {
                                        phi_1595_ = vec3<f32>(_e1043, _e1037, _e1040);
                                    } else {
                                        phi_1595_ = (_e1034 - _e168.origin);
                                    }
                                    let _e1050 = phi_1595_;
                                    phi_1596_ = _e1050;
                                }
                                let _e1052 = phi_1596_;
                                let _e1056 = (_e1052.x - (_e419 * _e1052.z));
                                let _e1060 = (_e1052.y - (_e422 * _e1052.z));
                                let _e1062 = triangles.member[(0u + _e1027)].v1_;
                                let _e1065 = (_e1062.x - _e168.origin.x);
                                let _e1068 = (_e1062.y - _e168.origin.y);
                                let _e1071 = (_e1062.z - _e168.origin.z);
                                if (_e402 == 0u) {
                                    phi_1628_ = vec3<f32>(_e1068, _e1071, _e1065);
                                } else {
                                    if (_e402 == 1u) {
                                        phi_1627_ = vec3<f32>(_e1071, _e1065, _e1068);
                                    } else {
                                        phi_1627_ = (_e1062 - _e168.origin);
                                    }
                                    let _e1078 = phi_1627_;
                                    phi_1628_ = _e1078;
                                }
                                let _e1080 = phi_1628_;
                                let _e1084 = (_e1080.x - (_e419 * _e1080.z));
                                let _e1088 = (_e1080.y - (_e422 * _e1080.z));
                                let _e1090 = triangles.member[(0u + _e1027)].v2_;
                                let _e1093 = (_e1090.x - _e168.origin.x);
                                let _e1096 = (_e1090.y - _e168.origin.y);
                                let _e1099 = (_e1090.z - _e168.origin.z);
                                if (_e402 == 0u) {
                                    phi_1660_ = vec3<f32>(_e1096, _e1099, _e1093);
                                } else {
                                    if (_e402 == 1u) {
                                        phi_1659_ = vec3<f32>(_e1099, _e1093, _e1096);
                                    } else {
                                        phi_1659_ = (_e1090 - _e168.origin);
                                    }
                                    let _e1106 = phi_1659_;
                                    phi_1660_ = _e1106;
                                }
                                let _e1108 = phi_1660_;
                                let _e1112 = (_e1108.x - (_e419 * _e1108.z));
                                let _e1116 = (_e1108.y - (_e422 * _e1108.z));
                                if (_e1084 < _e1112) {
                                    phi_1679_ = true;
                                } else {
                                    if (_e1084 == _e1112) {
                                        phi_1678_ = (_e1088 < _e1116);
                                    } else {
                                        phi_1678_ = false;
                                    }
                                    let _e1121 = phi_1678_;
                                    phi_1679_ = _e1121;
                                }
                                let _e1123 = phi_1679_;
                                if _e1123 {
                                    phi_1683_ = _e1116;
                                    phi_1684_ = _e1112;
                                    phi_1685_ = _e1088;
                                    phi_1686_ = _e1084;
                                } else {
                                    phi_1683_ = _e1088;
                                    phi_1684_ = _e1084;
                                    phi_1685_ = _e1116;
                                    phi_1686_ = _e1112;
                                }
                                let _e1125 = phi_1683_;
                                let _e1127 = phi_1684_;
                                let _e1129 = phi_1685_;
                                let _e1131 = phi_1686_;
                                let _e1134 = ((_e1131 * _e1125) - (_e1129 * _e1127));
                                if _e1123 {
                                    phi_1694_ = -(_e1134);
                                } else {
                                    phi_1694_ = _e1134;
                                }
                                let _e1137 = phi_1694_;
                                if (_e1112 < _e1056) {
                                    phi_1705_ = true;
                                } else {
                                    if (_e1112 == _e1056) {
                                        phi_1704_ = (_e1116 < _e1060);
                                    } else {
                                        phi_1704_ = false;
                                    }
                                    let _e1142 = phi_1704_;
                                    phi_1705_ = _e1142;
                                }
                                let _e1144 = phi_1705_;
                                if _e1144 {
                                    phi_1709_ = _e1060;
                                    phi_1710_ = _e1056;
                                    phi_1711_ = _e1116;
                                    phi_1712_ = _e1112;
                                } else {
                                    phi_1709_ = _e1116;
                                    phi_1710_ = _e1112;
                                    phi_1711_ = _e1060;
                                    phi_1712_ = _e1056;
                                }
                                let _e1146 = phi_1709_;
                                let _e1148 = phi_1710_;
                                let _e1150 = phi_1711_;
                                let _e1152 = phi_1712_;
                                let _e1155 = ((_e1152 * _e1146) - (_e1150 * _e1148));
                                if _e1144 {
                                    phi_1720_ = -(_e1155);
                                } else {
                                    phi_1720_ = _e1155;
                                }
                                let _e1158 = phi_1720_;
                                if (_e1056 < _e1084) {
                                    phi_1731_ = true;
                                } else {
                                    if (_e1056 == _e1084) {
                                        phi_1730_ = (_e1060 < _e1088);
                                    } else {
                                        phi_1730_ = false;
                                    }
                                    let _e1163 = phi_1730_;
                                    phi_1731_ = _e1163;
                                }
                                let _e1165 = phi_1731_;
                                if _e1165 {
                                    phi_1735_ = _e1088;
                                    phi_1736_ = _e1084;
                                    phi_1737_ = _e1060;
                                    phi_1738_ = _e1056;
                                } else {
                                    phi_1735_ = _e1060;
                                    phi_1736_ = _e1056;
                                    phi_1737_ = _e1088;
                                    phi_1738_ = _e1084;
                                }
                                let _e1167 = phi_1735_;
                                let _e1169 = phi_1736_;
                                let _e1171 = phi_1737_;
                                let _e1173 = phi_1738_;
                                let _e1176 = ((_e1173 * _e1167) - (_e1171 * _e1169));
                                if _e1165 {
                                    phi_1746_ = -(_e1176);
                                } else {
                                    phi_1746_ = _e1176;
                                }
                                let _e1179 = phi_1746_;
                                if (_e1137 >= 0f) {
                                    if (_e1158 >= 0f) {
                                        if (_e1179 >= 0f) {
                                            phi_1761_ = ((_e1137 + _e1158) + _e1179);
                                            phi_1762_ = false;
                                        } else {
                                            phi_1761_ = f32();
                                            phi_1762_ = true;
                                        }
                                        let _e1186 = phi_1761_;
                                        let _e1188 = phi_1762_;
                                        phi_1763_ = _e1186;
                                        phi_1764_ = _e1188;
                                    } else {
                                        phi_1763_ = f32();
                                        phi_1764_ = true;
                                    }
                                    let _e1190 = phi_1763_;
                                    let _e1192 = phi_1764_;
                                    phi_1765_ = _e1190;
                                    phi_1766_ = _e1192;
                                } else {
                                    phi_1765_ = f32();
                                    phi_1766_ = true;
                                }
                                let _e1194 = phi_1765_;
                                let _e1196 = phi_1766_;
                                if _e1196 {
                                    if (_e1137 <= 0f) {
                                        if (_e1158 <= 0f) {
                                            let _e1199 = (_e1179 <= 0f);
                                            if _e1199 {
                                            }
                                            phi_1784_ = ((_e1137 + _e1158) + _e1179);
                                            phi_1785_ = false;
                                            phi_1786_ = _e1199;
                                        } else {
                                            phi_1784_ = f32();
                                            phi_1785_ = true;
                                            phi_1786_ = false;
                                        }
                                        let _e1203 = phi_1784_;
                                        let _e1205 = phi_1785_;
                                        let _e1207 = phi_1786_;
                                        phi_1787_ = _e1203;
                                        phi_1788_ = _e1205;
                                        phi_1789_ = _e1207;
                                    } else {
                                        phi_1787_ = f32();
                                        phi_1788_ = true;
                                        phi_1789_ = false;
                                    }
                                    let _e1209 = phi_1787_;
                                    let _e1211 = phi_1788_;
                                    let _e1213 = phi_1789_;
                                    if _e1211 {
                                        phi_1793_ = false;
                                    } else {
                                        phi_1793_ = _e1213;
                                    }
                                    let _e1215 = phi_1793_;
                                    phi_1794_ = _e1209;
                                    phi_1795_ = _e1215;
                                } else {
                                    phi_1794_ = _e1194;
                                    phi_1795_ = true;
                                }
                                let _e1217 = phi_1794_;
                                let _e1219 = phi_1795_;
                                if _e1219 {
                                    let _e1220 = (_e1217 == 0f);
                                    if _e1220 {
                                        phi_2121_ = lt_bvh_triangle_Intersection();
                                        phi_2122_ = false;
                                    } else {
                                        let _e1222 = triangles.member[(0u + _e1027)].v0_;
                                        let _e1225 = (_e1222.x - _e168.origin.x);
                                        let _e1228 = (_e1222.y - _e168.origin.y);
                                        let _e1231 = (_e1222.z - _e168.origin.z);
                                        if (_e402 == 0u) {
                                            phi_1826_ = vec3<f32>(_e1228, _e1231, _e1225);
                                        } else {
                                            if (_e402 == 1u) {
                                                phi_1825_ = vec3<f32>(_e1231, _e1225, _e1228);
                                            } else {
                                                phi_1825_ = (_e1222 - _e168.origin);
                                            }
                                            let _e1238 = phi_1825_;
                                            phi_1826_ = _e1238;
                                        }
                                        let _e1240 = phi_1826_;
                                        let _e1242 = triangles.member[(0u + _e1027)].v1_;
                                        let _e1244 = triangles.member[(0u + _e1027)].v0_;
                                        let _e1247 = (_e1242.x - _e1244.x);
                                        let _e1250 = (_e1242.y - _e1244.y);
                                        let _e1253 = (_e1242.z - _e1244.z);
                                        if (_e402 == 0u) {
                                            phi_1852_ = vec3<f32>(_e1250, _e1253, _e1247);
                                        } else {
                                            if (_e402 == 1u) {
                                                phi_1851_ = vec3<f32>(_e1253, _e1247, _e1250);
                                            } else {
                                                phi_1851_ = (_e1242 - _e1244);
                                            }
                                            let _e1260 = phi_1851_;
                                            phi_1852_ = _e1260;
                                        }
                                        let _e1262 = phi_1852_;
                                        let _e1264 = triangles.member[(0u + _e1027)].v2_;
                                        let _e1266 = triangles.member[(0u + _e1027)].v0_;
                                        let _e1269 = (_e1264.x - _e1266.x);
                                        let _e1272 = (_e1264.y - _e1266.y);
                                        let _e1275 = (_e1264.z - _e1266.z);
                                        if (_e402 == 0u) {
                                            phi_1878_ = vec3<f32>(_e1272, _e1275, _e1269);
                                        } else {
                                            if (_e402 == 1u) {
                                                phi_1877_ = vec3<f32>(_e1275, _e1269, _e1272);
                                            } else {
                                                phi_1877_ = (_e1264 - _e1266);
                                            }
                                            let _e1282 = phi_1877_;
                                            phi_1878_ = _e1282;
                                        }
                                        let _e1284 = phi_1878_;
                                        let _e1291 = ((_e1262.y * _e1284.z) - (_e1262.z * _e1284.y));
                                        let _e1298 = ((_e1262.z * _e1284.x) - (_e1262.x * _e1284.z));
                                        let _e1305 = ((_e1262.x * _e1284.y) - (_e1262.y * _e1284.x));
                                        let _e1319 = (((1f / _e416.z) * (((_e1291 * _e1240.x) + (_e1298 * _e1240.y)) + (_e1305 * _e1240.z))) / (((_e1291 * _e419) + (_e1298 * _e422)) + _e1305));
                                        if (_e1319 > _e168.tmin) {
                                            if (_e1319 < _e168.tmax) {
                                                let _e1325 = triangles.member[(0u + _e1027)].v0_;
                                                let _e1327 = triangles.member[(0u + _e1027)].v1_;
                                                if (_e1325.x < _e1327.x) {
                                                    phi_1936_ = _e1325.x;
                                                } else {
                                                    phi_1936_ = _e1327.x;
                                                }
                                                let _e1334 = phi_1936_;
                                                if (_e1325.y < _e1327.y) {
                                                    phi_1945_ = _e1325.y;
                                                } else {
                                                    phi_1945_ = _e1327.y;
                                                }
                                                let _e1341 = phi_1945_;
                                                if (_e1325.z < _e1327.z) {
                                                    phi_1954_ = _e1325.z;
                                                } else {
                                                    phi_1954_ = _e1327.z;
                                                }
                                                let _e1348 = phi_1954_;
                                                let _e1350 = triangles.member[(0u + _e1027)].v2_;
                                                if (_e1334 < _e1350.x) {
                                                    phi_1963_ = _e1334;
                                                } else {
                                                    phi_1963_ = _e1350.x;
                                                }
                                                let _e1355 = phi_1963_;
                                                if (_e1341 < _e1350.y) {
                                                    phi_1970_ = _e1341;
                                                } else {
                                                    phi_1970_ = _e1350.y;
                                                }
                                                let _e1360 = phi_1970_;
                                                if (_e1348 < _e1350.z) {
                                                    phi_1977_ = _e1348;
                                                } else {
                                                    phi_1977_ = _e1350.z;
                                                }
                                                let _e1365 = phi_1977_;
                                                let _e1367 = triangles.member[(0u + _e1027)].v0_;
                                                let _e1369 = triangles.member[(0u + _e1027)].v1_;
                                                if (_e1367.x > _e1369.x) {
                                                    phi_1990_ = _e1367.x;
                                                } else {
                                                    phi_1990_ = _e1369.x;
                                                }
                                                let _e1376 = phi_1990_;
                                                if (_e1367.y > _e1369.y) {
                                                    phi_1999_ = _e1367.y;
                                                } else {
                                                    phi_1999_ = _e1369.y;
                                                }
                                                let _e1383 = phi_1999_;
                                                if (_e1367.z > _e1369.z) {
                                                    phi_2008_ = _e1367.z;
                                                } else {
                                                    phi_2008_ = _e1369.z;
                                                }
                                                let _e1390 = phi_2008_;
                                                let _e1392 = triangles.member[(0u + _e1027)].v2_;
                                                if (_e1376 > _e1392.x) {
                                                    phi_2017_ = _e1376;
                                                } else {
                                                    phi_2017_ = _e1392.x;
                                                }
                                                let _e1397 = phi_2017_;
                                                if (_e1383 > _e1392.y) {
                                                    phi_2024_ = _e1383;
                                                } else {
                                                    phi_2024_ = _e1392.y;
                                                }
                                                let _e1402 = phi_2024_;
                                                if (_e1390 > _e1392.z) {
                                                    phi_2031_ = _e1390;
                                                } else {
                                                    phi_2031_ = _e1392.z;
                                                }
                                                let _e1407 = phi_2031_;
                                                let _e1414 = ((_e1355 - _e168.origin.x) * _e314);
                                                let _e1415 = ((_e1360 - _e168.origin.y) * _e325);
                                                let _e1416 = ((_e1365 - _e168.origin.z) * _e336);
                                                let _e1423 = ((_e1397 - _e168.origin.x) * _e314);
                                                let _e1424 = ((_e1402 - _e168.origin.y) * _e325);
                                                let _e1425 = ((_e1407 - _e168.origin.z) * _e336);
                                                if (_e1414 < _e1423) {
                                                    phi_2054_ = _e1414;
                                                } else {
                                                    phi_2054_ = _e1423;
                                                }
                                                let _e1428 = phi_2054_;
                                                if (_e1415 < _e1424) {
                                                    phi_2059_ = _e1415;
                                                } else {
                                                    phi_2059_ = _e1424;
                                                }
                                                let _e1431 = phi_2059_;
                                                if (_e1416 < _e1425) {
                                                    phi_2064_ = _e1416;
                                                } else {
                                                    phi_2064_ = _e1425;
                                                }
                                                let _e1434 = phi_2064_;
                                                if (_e1414 > _e1423) {
                                                    phi_2072_ = _e1414;
                                                } else {
                                                    phi_2072_ = _e1423;
                                                }
                                                let _e1440 = phi_2072_;
                                                if (_e1415 > _e1424) {
                                                    phi_2077_ = _e1415;
                                                } else {
                                                    phi_2077_ = _e1424;
                                                }
                                                let _e1443 = phi_2077_;
                                                if (_e1416 > _e1425) {
                                                    phi_2082_ = _e1416;
                                                } else {
                                                    phi_2082_ = _e1425;
                                                }
                                                let _e1446 = phi_2082_;
                                                let _e1450 = core_intrinsics_maximum_number_nsz_f32_((_e1428 - _e381), (_e1431 - _e382));
                                                let _e1451 = core_intrinsics_maximum_number_nsz_f32_(_e1450, (_e1434 - _e383));
                                                let _e1452 = core_intrinsics_minimum_number_nsz_f32_((_e1440 + _e381), (_e1443 + _e382));
                                                let _e1453 = core_intrinsics_minimum_number_nsz_f32_(_e1452, (_e1446 + _e383));
                                                if (_e1451 > -300000000000000000000000000000000000000f) {
                                                    phi_2094_ = _e1451;
                                                } else {
                                                    phi_2094_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1456 = phi_2094_;
                                                if (_e1453 < 300000000000000000000000000000000000000f) {
                                                    phi_2099_ = _e1453;
                                                } else {
                                                    phi_2099_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1459 = phi_2099_;
                                                if (_e1319 < _e1456) {
                                                    phi_2104_ = _e1456;
                                                } else {
                                                    phi_2104_ = _e1319;
                                                }
                                                let _e1462 = phi_2104_;
                                                if (_e1462 > _e1459) {
                                                    phi_2109_ = _e1459;
                                                } else {
                                                    phi_2109_ = _e1462;
                                                }
                                                let _e1465 = phi_2109_;
                                                phi_2114_ = lt_bvh_triangle_Intersection(_e1465, (_e1158 / _e1217), (_e1179 / _e1217), (_e1456 <= _e1459));
                                                phi_2115_ = false;
                                            } else {
                                                phi_2114_ = lt_bvh_triangle_Intersection();
                                                phi_2115_ = true;
                                            }
                                            let _e1471 = phi_2114_;
                                            let _e1473 = phi_2115_;
                                            phi_2116_ = _e1471;
                                            phi_2117_ = _e1473;
                                        } else {
                                            phi_2116_ = lt_bvh_triangle_Intersection();
                                            phi_2117_ = true;
                                        }
                                        let _e1475 = phi_2116_;
                                        let _e1477 = phi_2117_;
                                        if _e1477 {
                                        }
                                        phi_2121_ = _e1475;
                                        phi_2122_ = _e1477;
                                    }
                                    let _e1479 = phi_2121_;
                                    let _e1481 = phi_2122_;
                                    phi_2123_ = _e1479;
                                    phi_2124_ = _e1220;
                                    phi_2125_ = _e1481;
                                } else {
                                    phi_2123_ = lt_bvh_triangle_Intersection();
                                    phi_2124_ = true;
                                    phi_2125_ = false;
                                }
                                let _e1483 = phi_2123_;
                                let _e1485 = phi_2124_;
                                let _e1487 = phi_2125_;
                                if _e1485 {
                                    phi_2129_ = true;
                                } else {
                                    phi_2129_ = _e1487;
                                }
                                let _e1489 = phi_2129_;
                                if _e1489 {
                                    phi_2133_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_2133_ = _e1483;
                                }
                                let _e1491 = phi_2133_;
                                if _e1491.is_hit {
                                    if (_e1491.t > _e168.tmin) {
                                        if (_e1491.t < _e1016.t) {
                                            phi_2182_ = true;
                                        } else {
                                            if (_e1491.t == _e1016.t) {
                                                if (_e1016.triangle != 4294967295u) {
                                                    if (_e1027 < _e1016.triangle) {
                                                        phi_2173_ = true;
                                                    } else {
                                                        if (_e1027 == _e1016.triangle) {
                                                            phi_2172_ = (4294967295u < _e1016.instance);
                                                        } else {
                                                            phi_2172_ = false;
                                                        }
                                                        let _e1510 = phi_2172_;
                                                        phi_2173_ = _e1510;
                                                    }
                                                    let _e1512 = phi_2173_;
                                                    phi_2174_ = _e1512;
                                                    phi_2175_ = false;
                                                } else {
                                                    phi_2174_ = bool();
                                                    phi_2175_ = true;
                                                }
                                                let _e1514 = phi_2174_;
                                                let _e1516 = phi_2175_;
                                                phi_2176_ = _e1514;
                                                phi_2177_ = _e1516;
                                            } else {
                                                phi_2176_ = bool();
                                                phi_2177_ = true;
                                            }
                                            let _e1518 = phi_2176_;
                                            let _e1520 = phi_2177_;
                                            if _e1520 {
                                                phi_2181_ = false;
                                            } else {
                                                phi_2181_ = _e1518;
                                            }
                                            let _e1522 = phi_2181_;
                                            phi_2182_ = _e1522;
                                        }
                                        let _e1524 = phi_2182_;
                                        if _e1524 {
                                            let _e1526 = triangles.member[(0u + _e1027)].i0_;
                                            if ((_e1526 & 2147483648u) == 0u) {
                                                phi_2196_ = true;
                                            } else {
                                                if true {
                                                }
                                                phi_2196_ = true;
                                            }
                                            let _e1530 = phi_2196_;
                                            if _e1530 {
                                                phi_2204_ = lt_bvh_Hit(_e1491.t, _e1491.u, _e1491.v, _e1027, 4294967295u);
                                            } else {
                                                phi_2204_ = _e1016;
                                            }
                                            let _e1536 = phi_2204_;
                                            phi_2205_ = _e1536;
                                        } else {
                                            phi_2205_ = _e1016;
                                        }
                                        let _e1538 = phi_2205_;
                                        phi_2206_ = _e1538;
                                    } else {
                                        phi_2206_ = _e1016;
                                    }
                                    let _e1540 = phi_2206_;
                                    phi_2207_ = _e1540;
                                } else {
                                    phi_2207_ = _e1016;
                                }
                                let _e1542 = phi_2207_;
                                phi_1547_ = _e1542;
                                phi_1550_ = (_e1018 & (_e1018 - 1u));
                                phi_2208_ = true;
                            }
                            let _e1544 = phi_1547_;
                            let _e1546 = phi_1550_;
                            let _e1548 = phi_2208_;
                            continue;
                            continuing {
                                phi_1546_ = _e1544;
                                phi_1549_ = _e1546;
                                break if !(_e1548);
                            }
                        }
                        let _e1551 = local_1.group_mask;
                        if ((_e1551 & 4278190080u) == 0u) {
                            let _e1555 = local_1.len;
                            if (_e1555 == 0u) {
                                phi_2247_ = false;
                            } else {
                                let _e1559 = local_1.len;
                                local_1.len = (_e1559 - 1u);
                                let _e1562 = local_1.len;
                                if (_e1562 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1567 = local_1.first[(0u + _e1562)];
                                local_1.group = _e1567;
                                let _e1570 = local_1.len;
                                if (_e1570 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1575 = local_1.mask[(0u + _e1570)];
                                local_1.group_mask = _e1575;
                                phi_2247_ = true;
                            }
                            let _e1578 = phi_2247_;
                            phi_2248_ = _e1578;
                        } else {
                            phi_2248_ = true;
                        }
                        let _e1580 = phi_2248_;
                        if _e1580 {
                            let _e1582 = local_1.group_mask;
                            let _e1588 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1582)), 32u, (_e1582 == 0u)));
                            let _e1592 = local_1.group_mask;
                            let _e1606 = local_1.group_mask;
                            local_1.group_mask = (_e1606 & ~((1u << bitcast<u32>((_e1588 & 31u)))));
                            let _e1609 = local_1.group;
                            phi_2279_ = (_e1609 + countOneBits(((_e1592 & ~((4294967295u << bitcast<u32>((((_e1588 - 24u) ^ _e435) & 31u))))) & 255u)));
                        } else {
                            phi_2279_ = 4294967295u;
                        }
                        let _e1612 = phi_2279_;
                        let _e2454 = local_5;
                        phi_1210_ = _e2454;
                        phi_1213_ = _e1612;
                    } else {
                        phi_1210_ = lt_bvh_Hit();
                        phi_1213_ = u32();
                    }
                    let _e1614 = phi_1210_;
                    let _e1616 = phi_1213_;
                    continue;
                    continuing {
                        phi_1209_ = _e1614;
                        phi_1212_ = _e1616;
                        break if !(_e576);
                    }
                }
                let _e2458 = local_6;
                phi_2280_ = _e2458;
            }
            let _e1619 = phi_2280_;
            phi_2281_ = _e1619;
            phi_2282_ = _e232;
        } else {
            phi_2281_ = lt_bvh_Hit();
            phi_2282_ = true;
        }
        let _e1621 = phi_2281_;
        let _e1623 = phi_2282_;
        if _e1623 {
            phi_2286_ = _e170;
        } else {
            phi_2286_ = _e1621;
        }
        let _e1625 = phi_2286_;
        if (_e1625.triangle != 4294967295u) {
            let _e1631 = ((1f - _e1625.u) - _e1625.v);
            if (_e1625.triangle < _e78) {
            } else {
                return;
            }
            let _e1636 = triangles.member[(0u + _e1625.triangle)];
            let _e1661 = (((_e1636.v0_.x * _e1631) + (_e1636.v1_.x * _e1625.u)) + (_e1636.v2_.x * _e1625.v));
            let _e1662 = (((_e1636.v0_.y * _e1631) + (_e1636.v1_.y * _e1625.u)) + (_e1636.v2_.y * _e1625.v));
            let _e1663 = (((_e1636.v0_.z * _e1631) + (_e1636.v1_.z * _e1625.u)) + (_e1636.v2_.z * _e1625.v));
            let _e1666 = abs(_e1636.v0_.x);
            let _e1668 = abs(_e1636.v0_.y);
            let _e1670 = abs(_e1636.v0_.z);
            let _e1672 = abs(_e1636.v1_.x);
            let _e1674 = abs(_e1636.v1_.y);
            let _e1676 = abs(_e1636.v1_.z);
            if (_e1666 > _e1672) {
                phi_2350_ = _e1666;
            } else {
                phi_2350_ = _e1672;
            }
            let _e1679 = phi_2350_;
            if (_e1668 > _e1674) {
                phi_2355_ = _e1668;
            } else {
                phi_2355_ = _e1674;
            }
            let _e1682 = phi_2355_;
            if (_e1670 > _e1676) {
                phi_2360_ = _e1670;
            } else {
                phi_2360_ = _e1676;
            }
            let _e1685 = phi_2360_;
            let _e1687 = abs(_e1636.v2_.x);
            let _e1689 = abs(_e1636.v2_.y);
            let _e1691 = abs(_e1636.v2_.z);
            if (_e1679 > _e1687) {
                phi_2371_ = _e1679;
            } else {
                phi_2371_ = _e1687;
            }
            let _e1694 = phi_2371_;
            if (_e1682 > _e1689) {
                phi_2376_ = _e1682;
            } else {
                phi_2376_ = _e1689;
            }
            let _e1697 = phi_2376_;
            if (_e1685 > _e1691) {
                phi_2381_ = _e1685;
            } else {
                phi_2381_ = _e1691;
            }
            let _e1700 = phi_2381_;
            let _e1703 = (_e1636.v1_.x - _e1636.v0_.x);
            let _e1706 = (_e1636.v1_.y - _e1636.v0_.y);
            let _e1709 = (_e1636.v1_.z - _e1636.v0_.z);
            let _e1712 = (_e1636.v2_.x - _e1636.v0_.x);
            let _e1715 = (_e1636.v2_.y - _e1636.v0_.y);
            let _e1718 = (_e1636.v2_.z - _e1636.v0_.z);
            let _e1722 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1706), abs(_e1709));
            let _e1723 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1703), _e1722);
            let _e1724 = (_e1703 / _e1723);
            let _e1725 = (_e1706 / _e1723);
            let _e1726 = (_e1709 / _e1723);
            let _e1730 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1715), abs(_e1718));
            let _e1731 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1712), _e1730);
            let _e1732 = (_e1712 / _e1731);
            let _e1733 = (_e1715 / _e1731);
            let _e1734 = (_e1718 / _e1731);
            let _e1737 = ((_e1725 * _e1734) - (_e1733 * _e1726));
            let _e1740 = ((_e1726 * _e1732) - (_e1734 * _e1724));
            let _e1743 = ((_e1724 * _e1733) - (_e1732 * _e1725));
            let _e1745 = p.member.eye;
            let _e1758 = (1f / sqrt((((_e1737 * _e1737) + (_e1740 * _e1740)) + (_e1743 * _e1743))));
            let _e1759 = (_e1737 * _e1758);
            let _e1760 = (_e1740 * _e1758);
            let _e1761 = (_e1743 * _e1758);
            if ((((_e1759 * (_e1745.x - _e1661)) + (_e1760 * (_e1745.y - _e1662))) + (_e1761 * (_e1745.z - _e1663))) < 0f) {
                phi_2457_ = vec3<f32>(-(_e1759), -(_e1760), -(_e1761));
            } else {
                phi_2457_ = vec3<f32>(_e1759, _e1760, _e1761);
            }
            let _e1774 = phi_2457_;
            if (_e1625.triangle < _e78) {
            } else {
                return;
            }
            let _e1779 = triangles.member[(0u + _e1625.triangle)];
            let _e1781 = (_e1779.i0_ & 2147483647u);
            if (_e1781 < _e81) {
            } else {
                return;
            }
            let _e1787 = vertices.member[(0u + _e1781)];
            if (_e1779.i1_ < _e81) {
            } else {
                return;
            }
            let _e1791 = vertices.member[(0u + _e1779.i1_)];
            if (_e1779.i2_ < _e81) {
            } else {
                return;
            }
            let _e1795 = vertices.member[(0u + _e1779.i2_)];
            let _e1796 = array<abi_Vertex, 3>(_e1787, _e1791, _e1795);
            if (_e1796[0].material < arrayLength((&materials.member))) {
            } else {
                return;
            }
            let _e1802 = materials.member[(0u + _e1796[0].material)];
            let _e1819 = (1f / 255f);
            let _e1838 = (1f / 255f);
            let _e1860 = (1f / 255f);
            if (_e1802.color_size == 0u) {
                phi_2700_ = vec3<f32>(1f, 1f, 1f);
            } else {
                local.offset = _e1802.color_offset;
                local.size = _e1802.color_size;
                local.flags = _e1802.flags;
                let _e1903 = _lt_shaders_texture_TextureView_quad((&local), (((_e1796[0].u * _e1631) + (_e1796[1].u * _e1625.u)) + (_e1796[2].u * _e1625.v)), (((_e1796[0].v * _e1631) + (_e1796[1].v * _e1625.u)) + (_e1796[2].v * _e1625.v)));
                if (_e1903.indices[0] < _e90) {
                } else {
                    return;
                }
                let _e1909 = color_texels.member[(0u + _e1903.indices[0])];
                let _e1920 = (1f / 255f);
                if (_e1903.indices[1] < _e90) {
                } else {
                    return;
                }
                let _e1934 = color_texels.member[(0u + _e1903.indices[1])];
                let _e1945 = (1f / 255f);
                if (_e1903.indices[2] < _e90) {
                } else {
                    return;
                }
                let _e1962 = color_texels.member[(0u + _e1903.indices[2])];
                let _e1973 = (1f / 255f);
                if (_e1903.indices[3] < _e90) {
                } else {
                    return;
                }
                let _e1990 = color_texels.member[(0u + _e1903.indices[3])];
                let _e2001 = (1f / 255f);
                let _e2010 = (((((f32((_e1909 & 255u)) * _e1920) * _e1903.weights.x) + ((f32((_e1934 & 255u)) * _e1945) * _e1903.weights.y)) + ((f32((_e1962 & 255u)) * _e1973) * _e1903.weights.z)) + ((f32((_e1990 & 255u)) * _e2001) * _e1903.weights.w));
                let _e2011 = (((((f32(((_e1909 >> bitcast<u32>(8i)) & 255u)) * _e1920) * _e1903.weights.x) + ((f32(((_e1934 >> bitcast<u32>(8i)) & 255u)) * _e1945) * _e1903.weights.y)) + ((f32(((_e1962 >> bitcast<u32>(8i)) & 255u)) * _e1973) * _e1903.weights.z)) + ((f32(((_e1990 >> bitcast<u32>(8i)) & 255u)) * _e2001) * _e1903.weights.w));
                let _e2012 = (((((f32(((_e1909 >> bitcast<u32>(16i)) & 255u)) * _e1920) * _e1903.weights.x) + ((f32(((_e1934 >> bitcast<u32>(16i)) & 255u)) * _e1945) * _e1903.weights.y)) + ((f32(((_e1962 >> bitcast<u32>(16i)) & 255u)) * _e1973) * _e1903.weights.z)) + ((f32(((_e1990 >> bitcast<u32>(16i)) & 255u)) * _e2001) * _e1903.weights.w));
                phi_2700_ = vec3<f32>((_e2010 * _e2010), (_e2011 * _e2011), (_e2012 * _e2012));
            }
            let _e2018 = phi_2700_;
            let _e2020 = ((_e1802.base_color.x * ((((f32((_e1796[0].color & 255u)) * _e1819) * _e1631) + ((f32((_e1796[1].color & 255u)) * _e1838) * _e1625.u)) + ((f32((_e1796[2].color & 255u)) * _e1860) * _e1625.v))) * _e2018.x);
            let _e2022 = ((_e1802.base_color.y * ((((f32(((_e1796[0].color >> bitcast<u32>(8i)) & 255u)) * _e1819) * _e1631) + ((f32(((_e1796[1].color >> bitcast<u32>(8i)) & 255u)) * _e1838) * _e1625.u)) + ((f32(((_e1796[2].color >> bitcast<u32>(8i)) & 255u)) * _e1860) * _e1625.v))) * _e2018.y);
            let _e2024 = ((_e1802.base_color.z * ((((f32(((_e1796[0].color >> bitcast<u32>(16i)) & 255u)) * _e1819) * _e1631) + ((f32(((_e1796[1].color >> bitcast<u32>(16i)) & 255u)) * _e1838) * _e1625.u)) + ((f32(((_e1796[2].color >> bitcast<u32>(16i)) & 255u)) * _e1860) * _e1625.v))) * _e2018.z);
            let _e2025 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1697, _e1700);
            let _e2026 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1694, _e2025);
            if ((_e1802.flags & 2u) == 0u) {
                phi_2715_ = 0u;
            } else {
                phi_2715_ = 1u;
            }
            let _e2031 = phi_2715_;
            if (_e1796[0].normal == 2147516416u) {
                phi_2918_ = _e1774;
            } else {
                let _e2044 = (f32((bitcast<i32>((_e1796[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2050 = (f32((bitcast<i32>(_e1796[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2054 = ((1f - abs(_e2044)) - abs(_e2050));
                if (_e2054 < 0f) {
                    phi_2742_ = -(_e2054);
                } else {
                    phi_2742_ = 0f;
                }
                let _e2058 = phi_2742_;
                if (_e2044 < 0f) {
                    phi_2749_ = (_e2044 + _e2058);
                } else {
                    phi_2749_ = (_e2044 - _e2058);
                }
                let _e2063 = phi_2749_;
                if (_e2050 < 0f) {
                    phi_2756_ = (_e2050 + _e2058);
                } else {
                    phi_2756_ = (_e2050 - _e2058);
                }
                let _e2068 = phi_2756_;
                let _e2075 = (1f / sqrt((((_e2063 * _e2063) + (_e2068 * _e2068)) + (_e2054 * _e2054))));
                let _e2091 = (f32((bitcast<i32>((_e1796[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2097 = (f32((bitcast<i32>(_e1796[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2101 = ((1f - abs(_e2091)) - abs(_e2097));
                if (_e2101 < 0f) {
                    phi_2791_ = -(_e2101);
                } else {
                    phi_2791_ = 0f;
                }
                let _e2105 = phi_2791_;
                if (_e2091 < 0f) {
                    phi_2798_ = (_e2091 + _e2105);
                } else {
                    phi_2798_ = (_e2091 - _e2105);
                }
                let _e2110 = phi_2798_;
                if (_e2097 < 0f) {
                    phi_2805_ = (_e2097 + _e2105);
                } else {
                    phi_2805_ = (_e2097 - _e2105);
                }
                let _e2115 = phi_2805_;
                let _e2122 = (1f / sqrt((((_e2110 * _e2110) + (_e2115 * _e2115)) + (_e2101 * _e2101))));
                let _e2141 = (f32((bitcast<i32>((_e1796[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2147 = (f32((bitcast<i32>(_e1796[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2151 = ((1f - abs(_e2141)) - abs(_e2147));
                if (_e2151 < 0f) {
                    phi_2843_ = -(_e2151);
                } else {
                    phi_2843_ = 0f;
                }
                let _e2155 = phi_2843_;
                if (_e2141 < 0f) {
                    phi_2850_ = (_e2141 + _e2155);
                } else {
                    phi_2850_ = (_e2141 - _e2155);
                }
                let _e2160 = phi_2850_;
                if (_e2147 < 0f) {
                    phi_2857_ = (_e2147 + _e2155);
                } else {
                    phi_2857_ = (_e2147 - _e2155);
                }
                let _e2165 = phi_2857_;
                let _e2172 = (1f / sqrt((((_e2160 * _e2160) + (_e2165 * _e2165)) + (_e2151 * _e2151))));
                let _e2183 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(vec3<f32>(((((_e2063 * _e2075) * _e1631) + ((_e2110 * _e2122) * _e1625.u)) + ((_e2160 * _e2172) * _e1625.v)), ((((_e2068 * _e2075) * _e1631) + ((_e2115 * _e2122) * _e1625.u)) + ((_e2165 * _e2172) * _e1625.v)), ((((_e2054 * _e2075) * _e1631) + ((_e2101 * _e2122) * _e1625.u)) + ((_e2151 * _e2172) * _e1625.v))));
                let _e2195 = sqrt((((_e2183.x * _e2183.x) + (_e2183.y * _e2183.y)) + (_e2183.z * _e2183.z)));
                if (_e2195 > 0f) {
                    let _e2198 = (_e2183.x / _e2195);
                    let _e2200 = (_e2183.y / _e2195);
                    let _e2202 = (_e2183.z / _e2195);
                    if ((((_e2198 * _e1774.x) + (_e2200 * _e1774.y)) + (_e2202 * _e1774.z)) < 0f) {
                        phi_2916_ = vec3<f32>(-(_e2198), -(_e2200), -(_e2202));
                    } else {
                        phi_2916_ = (_e2183 / vec3(_e2195));
                    }
                    let _e2219 = phi_2916_;
                    phi_2917_ = _e2219;
                } else {
                    phi_2917_ = _e1774;
                }
                let _e2221 = phi_2917_;
                phi_2918_ = _e2221;
            }
            let _e2223 = phi_2918_;
            if (_e2020 > 0f) {
                if (_e2020 < 1f) {
                    phi_2927_ = _e2020;
                } else {
                    phi_2927_ = 1f;
                }
                let _e2227 = phi_2927_;
                phi_2928_ = _e2227;
            } else {
                phi_2928_ = 0f;
            }
            let _e2229 = phi_2928_;
            if (_e2022 > 0f) {
                if (_e2022 < 1f) {
                    phi_2938_ = _e2022;
                } else {
                    phi_2938_ = 1f;
                }
                let _e2234 = phi_2938_;
                phi_2939_ = _e2234;
            } else {
                phi_2939_ = 0f;
            }
            let _e2236 = phi_2939_;
            if (_e2024 > 0f) {
                if (_e2024 < 1f) {
                    phi_2949_ = _e2024;
                } else {
                    phi_2949_ = 1f;
                }
                let _e2241 = phi_2949_;
                phi_2950_ = _e2241;
            } else {
                phi_2950_ = 0f;
            }
            let _e2243 = phi_2950_;
            let _e2246 = ((sqrt(_e2229) * 255f) + 0.5f);
            let _e2255 = ((sqrt(_e2236) * 255f) + 0.5f);
            let _e2267 = ((sqrt(_e2243) * 255f) + 0.5f);
            phi_2985_ = abi_Sample(vec3<f32>(_e1661, _e1662, _e1663), _e2026, _e1774, _e2031, _e2223, ((select(select(u32(_e2246), 0u, (_e2246 < bitcast<f32>(0u))), 4294967295u, (_e2246 > bitcast<f32>(1333788671u))) | (select(select(u32(_e2255), 0u, (_e2255 < bitcast<f32>(0u))), 4294967295u, (_e2255 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e2267), 0u, (_e2267 < bitcast<f32>(0u))), 4294967295u, (_e2267 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_2985_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e2281 = phi_2985_;
        if (_e96.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e96.first_primitive)] = _e2281;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_color_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
