struct abi_CameraParams {
    eye: vec3<f32>,
    root: u32,
    right: vec3<f32>,
    pad0_: u32,
    up: vec3<f32>,
    pad1_: u32,
    forward: vec3<f32>,
    pad2_: u32,
    size: vec2<u32>,
    pad3_: vec2<u32>,
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

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct texture_TextureView {
    offset: u32,
    size: u32,
    flags: u32,
}

struct lt_bvh_Triangle {
    v0_: vec3<f32>,
    i0_: u32,
    v1_: vec3<f32>,
    i1_: u32,
    v2_: vec3<f32>,
    i2_: u32,
}

struct type_27 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_31 {
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

struct type_35 {
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

struct type_45 {
    member: abi_CameraParams,
}

struct lt_bvh_Node {
    frame: vec4<u32>,
    links: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    z: vec4<u32>,
}

struct type_50 {
    member: array<lt_bvh_Node>,
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

var<private> id_1: vec3<u32>;
@group(0) @binding(3) 
var<storage> vertices: type_31;
@group(0) @binding(4) 
var<storage> materials: type_35;
@group(0) @binding(0) 
var<uniform> p: type_45;
@group(0) @binding(1) 
var<storage> nodes: type_50;
@group(0) @binding(2) 
var<storage> triangles: type_27;
@group(0) @binding(5) 
var<storage, read_write> samples: type_9;
@group(0) @binding(6) 
var<storage> alpha_texels: type_13;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_212_: lt_bvh_traverse_Tree;
    var phi_213_: bool;
    var phi_214_: lt_bvh_traverse_Tree;
    var phi_215_: bool;
    var phi_220_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_212_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_213_ = false;
        } else {
            phi_212_ = lt_bvh_traverse_Tree();
            phi_213_ = true;
        }
        let _e82 = phi_212_;
        let _e84 = phi_213_;
        phi_214_ = _e82;
        phi_215_ = _e84;
    } else {
        phi_214_ = lt_bvh_traverse_Tree();
        phi_215_ = true;
    }
    let _e86 = phi_214_;
    let _e88 = phi_215_;
    if _e88 {
        phi_220_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_220_ = _e86;
    }
    let _e93 = phi_220_;
    return lt_bvh_traverse_Tree(_e93.root, _e93.first_primitive);
}

fn _lt_shaders_texture_TextureView_quad(param_3: ptr<function, texture_TextureView>, param_4: f32, param_5: f32) -> texture_TexelQuad {
    var phi_265_: f32;
    var phi_270_: f32;
    var phi_271_: bool;
    var phi_272_: f32;
    var phi_273_: bool;
    var phi_277_: f32;
    var phi_303_: f32;
    var phi_308_: f32;
    var phi_309_: bool;
    var phi_310_: f32;
    var phi_311_: bool;
    var phi_315_: f32;
    var phi_323_: f32;
    var phi_324_: f32;
    var phi_325_: f32;
    var phi_334_: f32;
    var phi_335_: f32;
    var phi_353_: u32;
    var phi_367_: u32;
    var phi_374_: u32;
    var phi_379_: u32;
    var phi_385_: u32;
    var phi_390_: u32;
    var phi_392_: texture_Axis;
    var phi_420_: f32;
    var phi_425_: f32;
    var phi_426_: bool;
    var phi_427_: f32;
    var phi_428_: bool;
    var phi_432_: f32;
    var phi_458_: f32;
    var phi_463_: f32;
    var phi_464_: bool;
    var phi_465_: f32;
    var phi_466_: bool;
    var phi_470_: f32;
    var phi_478_: f32;
    var phi_479_: f32;
    var phi_480_: f32;
    var phi_489_: f32;
    var phi_490_: f32;
    var phi_508_: u32;
    var phi_522_: u32;
    var phi_529_: u32;
    var phi_534_: u32;
    var phi_540_: u32;
    var phi_545_: u32;
    var phi_547_: texture_Axis;

    let _e73 = (*param_3).size;
    let _e74 = (_e73 & 65535u);
    let _e76 = (*param_3).size;
    let _e78 = (_e76 >> bitcast<u32>(16i));
    let _e80 = (*param_3).flags;
    let _e82 = ((_e80 & 4u) != 0u);
    let _e84 = (*param_3).flags;
    let _e87 = ((_e84 >> bitcast<u32>(4u)) & 3u);
    if (_e87 == 0u) {
        if (param_4 > -8388608f) {
            let _e100 = f32(select(0i, select(select(i32(param_4), i32(-2147483648), (param_4 < bitcast<f32>(3472883712u))), 2147483647i, (param_4 > bitcast<f32>(1325400063u))), (param_4 == param_4)));
            if (_e100 > param_4) {
                phi_265_ = 1f;
            } else {
                phi_265_ = 0f;
            }
            let _e103 = phi_265_;
            if (param_4 < 8388608f) {
                phi_270_ = (_e100 - _e103);
                phi_271_ = false;
            } else {
                phi_270_ = f32();
                phi_271_ = true;
            }
            let _e106 = phi_270_;
            let _e108 = phi_271_;
            phi_272_ = _e106;
            phi_273_ = _e108;
        } else {
            phi_272_ = f32();
            phi_273_ = true;
        }
        let _e110 = phi_272_;
        let _e112 = phi_273_;
        if _e112 {
            phi_277_ = param_4;
        } else {
            phi_277_ = _e110;
        }
        let _e114 = phi_277_;
        phi_325_ = (param_4 - _e114);
    } else {
        if (_e87 == 1u) {
            let _e117 = (param_4 * 0.5f);
            if (_e117 > -8388608f) {
                let _e129 = f32(select(0i, select(select(i32(_e117), i32(-2147483648), (_e117 < bitcast<f32>(3472883712u))), 2147483647i, (_e117 > bitcast<f32>(1325400063u))), (_e117 == _e117)));
                if (_e129 > _e117) {
                    phi_303_ = 1f;
                } else {
                    phi_303_ = 0f;
                }
                let _e132 = phi_303_;
                if (_e117 < 8388608f) {
                    phi_308_ = (_e129 - _e132);
                    phi_309_ = false;
                } else {
                    phi_308_ = f32();
                    phi_309_ = true;
                }
                let _e135 = phi_308_;
                let _e137 = phi_309_;
                phi_310_ = _e135;
                phi_311_ = _e137;
            } else {
                phi_310_ = f32();
                phi_311_ = true;
            }
            let _e139 = phi_310_;
            let _e141 = phi_311_;
            if _e141 {
                phi_315_ = _e117;
            } else {
                phi_315_ = _e139;
            }
            let _e143 = phi_315_;
            let _e145 = (param_4 - (2f * _e143));
            if (_e145 > 1f) {
                phi_323_ = (2f - _e145);
            } else {
                phi_323_ = _e145;
            }
            let _e149 = phi_323_;
            phi_324_ = _e149;
        } else {
            phi_324_ = param_4;
        }
        let _e151 = phi_324_;
        phi_325_ = _e151;
    }
    let _e153 = phi_325_;
    if (_e153 > 0f) {
        if (_e153 < 1f) {
            phi_334_ = _e153;
        } else {
            phi_334_ = 1f;
        }
        let _e157 = phi_334_;
        phi_335_ = _e157;
    } else {
        phi_335_ = 0f;
    }
    let _e159 = phi_335_;
    let _e160 = (_e74 - 1u);
    let _e162 = (_e159 * f32(_e74));
    if _e82 {
        let _e169 = select(select(u32(_e162), 0u, (_e162 < bitcast<f32>(0u))), 4294967295u, (_e162 > bitcast<f32>(1333788671u)));
        if (_e160 < _e169) {
            phi_353_ = _e160;
        } else {
            phi_353_ = _e169;
        }
        let _e172 = phi_353_;
        phi_392_ = texture_Axis(_e172, _e172, 0f);
    } else {
        let _e174 = (_e162 + 0.5f);
        let _e181 = select(select(u32(_e174), 0u, (_e174 < bitcast<f32>(0u))), 4294967295u, (_e174 > bitcast<f32>(1333788671u)));
        if (_e74 < _e181) {
            phi_367_ = _e74;
        } else {
            phi_367_ = _e181;
        }
        let _e184 = phi_367_;
        if (_e87 == 0u) {
            phi_374_ = _e160;
        } else {
            phi_374_ = 0u;
        }
        let _e189 = phi_374_;
        if (_e87 == 0u) {
            phi_379_ = 0u;
        } else {
            phi_379_ = _e160;
        }
        let _e192 = phi_379_;
        if (_e184 == 0u) {
            phi_385_ = _e189;
        } else {
            phi_385_ = (_e184 - 1u);
        }
        let _e196 = phi_385_;
        if (_e184 > _e160) {
            phi_390_ = _e192;
        } else {
            phi_390_ = _e184;
        }
        let _e199 = phi_390_;
        phi_392_ = texture_Axis(_e196, _e199, (_e174 - f32(_e184)));
    }
    let _e202 = phi_392_;
    let _e204 = (*param_3).flags;
    let _e207 = ((_e204 >> bitcast<u32>(6u)) & 3u);
    if (_e207 == 0u) {
        if (param_5 > -8388608f) {
            let _e220 = f32(select(0i, select(select(i32(param_5), i32(-2147483648), (param_5 < bitcast<f32>(3472883712u))), 2147483647i, (param_5 > bitcast<f32>(1325400063u))), (param_5 == param_5)));
            if (_e220 > param_5) {
                phi_420_ = 1f;
            } else {
                phi_420_ = 0f;
            }
            let _e223 = phi_420_;
            if (param_5 < 8388608f) {
                phi_425_ = (_e220 - _e223);
                phi_426_ = false;
            } else {
                phi_425_ = f32();
                phi_426_ = true;
            }
            let _e226 = phi_425_;
            let _e228 = phi_426_;
            phi_427_ = _e226;
            phi_428_ = _e228;
        } else {
            phi_427_ = f32();
            phi_428_ = true;
        }
        let _e230 = phi_427_;
        let _e232 = phi_428_;
        if _e232 {
            phi_432_ = param_5;
        } else {
            phi_432_ = _e230;
        }
        let _e234 = phi_432_;
        phi_480_ = (param_5 - _e234);
    } else {
        if (_e207 == 1u) {
            let _e237 = (param_5 * 0.5f);
            if (_e237 > -8388608f) {
                let _e249 = f32(select(0i, select(select(i32(_e237), i32(-2147483648), (_e237 < bitcast<f32>(3472883712u))), 2147483647i, (_e237 > bitcast<f32>(1325400063u))), (_e237 == _e237)));
                if (_e249 > _e237) {
                    phi_458_ = 1f;
                } else {
                    phi_458_ = 0f;
                }
                let _e252 = phi_458_;
                if (_e237 < 8388608f) {
                    phi_463_ = (_e249 - _e252);
                    phi_464_ = false;
                } else {
                    phi_463_ = f32();
                    phi_464_ = true;
                }
                let _e255 = phi_463_;
                let _e257 = phi_464_;
                phi_465_ = _e255;
                phi_466_ = _e257;
            } else {
                phi_465_ = f32();
                phi_466_ = true;
            }
            let _e259 = phi_465_;
            let _e261 = phi_466_;
            if _e261 {
                phi_470_ = _e237;
            } else {
                phi_470_ = _e259;
            }
            let _e263 = phi_470_;
            let _e265 = (param_5 - (2f * _e263));
            if (_e265 > 1f) {
                phi_478_ = (2f - _e265);
            } else {
                phi_478_ = _e265;
            }
            let _e269 = phi_478_;
            phi_479_ = _e269;
        } else {
            phi_479_ = param_5;
        }
        let _e271 = phi_479_;
        phi_480_ = _e271;
    }
    let _e273 = phi_480_;
    if (_e273 > 0f) {
        if (_e273 < 1f) {
            phi_489_ = _e273;
        } else {
            phi_489_ = 1f;
        }
        let _e277 = phi_489_;
        phi_490_ = _e277;
    } else {
        phi_490_ = 0f;
    }
    let _e279 = phi_490_;
    let _e280 = (_e78 - 1u);
    let _e282 = (_e279 * f32(_e78));
    if _e82 {
        let _e289 = select(select(u32(_e282), 0u, (_e282 < bitcast<f32>(0u))), 4294967295u, (_e282 > bitcast<f32>(1333788671u)));
        if (_e280 < _e289) {
            phi_508_ = _e280;
        } else {
            phi_508_ = _e289;
        }
        let _e292 = phi_508_;
        phi_547_ = texture_Axis(_e292, _e292, 0f);
    } else {
        let _e294 = (_e282 + 0.5f);
        let _e301 = select(select(u32(_e294), 0u, (_e294 < bitcast<f32>(0u))), 4294967295u, (_e294 > bitcast<f32>(1333788671u)));
        if (_e78 < _e301) {
            phi_522_ = _e78;
        } else {
            phi_522_ = _e301;
        }
        let _e304 = phi_522_;
        if (_e207 == 0u) {
            phi_529_ = _e280;
        } else {
            phi_529_ = 0u;
        }
        let _e309 = phi_529_;
        if (_e207 == 0u) {
            phi_534_ = 0u;
        } else {
            phi_534_ = _e280;
        }
        let _e312 = phi_534_;
        if (_e304 == 0u) {
            phi_540_ = _e309;
        } else {
            phi_540_ = (_e304 - 1u);
        }
        let _e316 = phi_540_;
        if (_e304 > _e280) {
            phi_545_ = _e312;
        } else {
            phi_545_ = _e304;
        }
        let _e319 = phi_545_;
        phi_547_ = texture_Axis(_e316, _e319, (_e294 - f32(_e304)));
    }
    let _e322 = phi_547_;
    let _e326 = (*param_3).offset;
    let _e333 = (*param_3).offset;
    let _e340 = (*param_3).offset;
    let _e347 = (*param_3).offset;
    return texture_TexelQuad(array<u32, 4>(((_e326 + (_e322.low * _e74)) + _e202.low), ((_e333 + (_e322.low * _e74)) + _e202.high), ((_e340 + (_e322.high * _e74)) + _e202.low), ((_e347 + (_e322.high * _e74)) + _e202.high)), vec4<f32>(((1f - _e202.fraction) * (1f - _e322.fraction)), (_e202.fraction * (1f - _e322.fraction)), ((1f - _e202.fraction) * _e322.fraction), (_e202.fraction * _e322.fraction)));
}

fn _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(param_6: vec3<f32>) -> vec3<f32> {
    return param_6;
}

fn _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(param_7: vec3<f32>) -> vec3<f32> {
    return vec3<f32>(1f, 1f, 1f);
}

fn _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(param_8: f32, param_9: f32) -> f32 {
    var phi_2942_: f32;

    if (param_8 > param_9) {
        phi_2942_ = param_8;
    } else {
        phi_2942_ = param_9;
    }
    let _e73 = phi_2942_;
    return _e73;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_10: f32, param_11: f32) -> f32 {
    var phi_2930_: bool;
    var phi_2934_: f32;

    if (param_10 != param_10) {
        phi_2930_ = true;
    } else {
        let _e72 = (param_11 <= param_10);
        if _e72 {
        }
        phi_2930_ = _e72;
    }
    let _e74 = phi_2930_;
    if _e74 {
        phi_2934_ = param_11;
    } else {
        phi_2934_ = param_10;
    }
    let _e76 = phi_2934_;
    return _e76;
}

fn core_intrinsics_maximum_number_nsz_f32_(param_12: f32, param_13: f32) -> f32 {
    var phi_2914_: bool;
    var phi_2918_: f32;

    if (param_12 != param_12) {
        phi_2914_ = true;
    } else {
        let _e72 = (param_13 >= param_12);
        if _e72 {
        }
        phi_2914_ = _e72;
    }
    let _e74 = phi_2914_;
    if _e74 {
        phi_2918_ = param_13;
    } else {
        phi_2918_ = param_12;
    }
    let _e76 = phi_2918_;
    return _e76;
}

fn _lt_bvh_ray_Ray_new(param_14: vec3<f32>, param_15: vec3<f32>) -> lt_bvh_Ray {
    return lt_bvh_Ray(param_14, 0f, param_15, 300000000000000000000000000000000000000f);
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var phi_742_: bool;
    var phi_743_: bool;
    var phi_744_: bool;
    var phi_748_: bool;
    var phi_749_: bool;
    var phi_750_: bool;
    var phi_751_: bool;
    var phi_752_: bool;
    var phi_753_: bool;
    var phi_754_: bool;
    var phi_755_: bool;
    var phi_756_: bool;
    var phi_757_: bool;
    var phi_758_: bool;
    var phi_759_: bool;
    var phi_760_: bool;
    var phi_761_: bool;
    var phi_762_: bool;
    var phi_763_: bool;
    var phi_764_: bool;
    var phi_765_: bool;
    var phi_769_: bool;
    var phi_773_: bool;
    var phi_848_: f32;
    var phi_855_: f32;
    var phi_863_: f32;
    var phi_870_: f32;
    var phi_878_: f32;
    var phi_885_: f32;
    var phi_910_: f32;
    var phi_915_: f32;
    var phi_920_: f32;
    var phi_953_: bool;
    var phi_954_: bool;
    var phi_962_: u32;
    var phi_963_: u32;
    var phi_981_: vec3<f32>;
    var phi_982_: vec3<f32>;
    var phi_996_: u32;
    var phi_1001_: u32;
    var phi_1006_: u32;
    var phi_1120_: bool;
    var phi_1121_: bool;
    var phi_1152_: u32;
    var phi_1154_: lt_bvh_Hit;
    var phi_1157_: u32;
    var phi_1242_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1269_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1296_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1302_: u32;
    var phi_1305_: u32;
    var phi_1319_: u32;
    var phi_1329_: u32;
    var phi_1339_: u32;
    var phi_1357_: u32;
    var phi_1367_: u32;
    var phi_1377_: u32;
    var phi_1413_: u32;
    var phi_1426_: u32;
    var phi_1431_: u32;
    var phi_1432_: u32;
    var phi_1433_: u32;
    var phi_1303_: u32;
    var phi_1306_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_1491_: lt_bvh_Hit;
    var phi_1494_: u32;
    var phi_1540_: vec3<f32>;
    var phi_1541_: vec3<f32>;
    var phi_1574_: vec3<f32>;
    var phi_1575_: vec3<f32>;
    var phi_1608_: vec3<f32>;
    var phi_1609_: vec3<f32>;
    var phi_1629_: bool;
    var phi_1630_: bool;
    var phi_1634_: f32;
    var phi_1635_: f32;
    var phi_1636_: f32;
    var phi_1637_: f32;
    var phi_1645_: f32;
    var phi_1655_: bool;
    var phi_1656_: bool;
    var phi_1660_: f32;
    var phi_1661_: f32;
    var phi_1662_: f32;
    var phi_1663_: f32;
    var phi_1671_: f32;
    var phi_1681_: bool;
    var phi_1682_: bool;
    var phi_1686_: f32;
    var phi_1687_: f32;
    var phi_1688_: f32;
    var phi_1689_: f32;
    var phi_1697_: f32;
    var phi_1712_: f32;
    var phi_1713_: bool;
    var phi_1714_: f32;
    var phi_1715_: bool;
    var phi_1716_: f32;
    var phi_1717_: bool;
    var phi_1735_: f32;
    var phi_1736_: bool;
    var phi_1737_: bool;
    var phi_1738_: f32;
    var phi_1739_: bool;
    var phi_1740_: bool;
    var phi_1744_: bool;
    var phi_1745_: f32;
    var phi_1746_: bool;
    var phi_1782_: f32;
    var phi_1791_: f32;
    var phi_1800_: f32;
    var phi_1809_: f32;
    var phi_1816_: f32;
    var phi_1823_: f32;
    var phi_1836_: f32;
    var phi_1845_: f32;
    var phi_1854_: f32;
    var phi_1863_: f32;
    var phi_1870_: f32;
    var phi_1877_: f32;
    var phi_1900_: f32;
    var phi_1905_: f32;
    var phi_1910_: f32;
    var phi_1918_: f32;
    var phi_1923_: f32;
    var phi_1928_: f32;
    var phi_1940_: f32;
    var phi_1945_: f32;
    var phi_1950_: f32;
    var phi_1955_: f32;
    var phi_1960_: lt_bvh_triangle_Intersection;
    var phi_1961_: bool;
    var phi_1962_: lt_bvh_triangle_Intersection;
    var phi_1963_: bool;
    var phi_1967_: lt_bvh_triangle_Intersection;
    var phi_1968_: bool;
    var phi_1969_: lt_bvh_triangle_Intersection;
    var phi_1970_: bool;
    var phi_1971_: bool;
    var phi_1975_: bool;
    var phi_1979_: lt_bvh_triangle_Intersection;
    var phi_2018_: bool;
    var phi_2019_: bool;
    var phi_2020_: bool;
    var phi_2021_: bool;
    var phi_2022_: bool;
    var phi_2023_: bool;
    var phi_2027_: bool;
    var phi_2028_: bool;
    var phi_2231_: f32;
    var phi_2234_: bool;
    var phi_2235_: bool;
    var phi_2239_: bool;
    var phi_2247_: lt_bvh_Hit;
    var phi_2248_: lt_bvh_Hit;
    var phi_2249_: lt_bvh_Hit;
    var phi_2250_: lt_bvh_Hit;
    var phi_1492_: lt_bvh_Hit;
    var phi_1495_: u32;
    var phi_2251_: bool;
    var phi_2290_: bool;
    var phi_2291_: bool;
    var phi_2322_: u32;
    var phi_1155_: lt_bvh_Hit;
    var phi_1158_: u32;
    var phi_2323_: lt_bvh_Hit;
    var phi_2324_: lt_bvh_Hit;
    var phi_2325_: bool;
    var phi_2329_: lt_bvh_Hit;
    var phi_2394_: f32;
    var phi_2399_: f32;
    var phi_2404_: f32;
    var phi_2415_: f32;
    var phi_2420_: f32;
    var phi_2425_: f32;
    var phi_2501_: vec3<f32>;
    var phi_2622_: u32;
    var phi_2649_: f32;
    var phi_2656_: f32;
    var phi_2663_: f32;
    var phi_2698_: f32;
    var phi_2705_: f32;
    var phi_2712_: f32;
    var phi_2750_: f32;
    var phi_2757_: f32;
    var phi_2764_: f32;
    var phi_2823_: vec3<f32>;
    var phi_2824_: vec3<f32>;
    var phi_2825_: vec3<f32>;
    var phi_2834_: f32;
    var phi_2835_: f32;
    var phi_2845_: f32;
    var phi_2846_: f32;
    var phi_2856_: f32;
    var phi_2857_: f32;
    var phi_2892_: abi_Sample;
    var local_5: lt_bvh_Hit;
    var local_6: lt_bvh_Hit;

    let _e71 = id_1;
    let _e75 = arrayLength((&nodes.member));
    let _e78 = arrayLength((&triangles.member));
    let _e81 = arrayLength((&vertices.member));
    let _e84 = arrayLength((&materials.member));
    let _e90 = arrayLength((&alpha_texels.member));
    let _e93 = p.member.size[0u];
    let _e95 = p.member.size[1u];
    let _e96 = lt_shaders_entry_pixel_index(_e71, _e93, _e95);
    if (bitcast<i32>(_e96.root) != 0i) {
        let _e104 = p.member.eye;
        let _e109 = p.member.size[0u];
        let _e113 = ((((f32(_e71.x) + 0.5f) / f32(_e109)) * 2f) - 1f);
        let _e118 = p.member.size[1u];
        let _e122 = (1f - (((f32(_e71.y) + 0.5f) / f32(_e118)) * 2f));
        let _e124 = p.member.forward;
        let _e126 = p.member.right;
        let _e140 = p.member.up;
        let _e151 = _lt_bvh_ray_Ray_new(_e104, vec3<f32>(((_e124.x + (_e126.x * _e113)) + (_e140.x * _e122)), ((_e124.y + (_e126.y * _e113)) + (_e140.y * _e122)), ((_e124.z + (_e126.z * _e113)) + (_e140.z * _e122))));
        let _e153 = lt_bvh_Hit(_e151.tmax, 0f, 0f, 4294967295u, 4294967295u);
        let _e163 = abs(_e151.direction.x);
        let _e165 = abs(_e151.direction.y);
        let _e167 = abs(_e151.direction.z);
        if (abs(_e151.origin.x) < 1000000000000000f) {
            if (abs(_e151.origin.y) < 1000000000000000f) {
                if (abs(_e151.origin.z) < 1000000000000000f) {
                    if (_e163 < 1000000000000000f) {
                        if (_e165 < 1000000000000000f) {
                            if (_e167 < 1000000000000000f) {
                                if (_e163 > 0f) {
                                    phi_743_ = bool();
                                    phi_744_ = true;
                                } else {
                                    let _e175 = (_e165 > 0f);
                                    if _e175 {
                                        phi_742_ = bool();
                                    } else {
                                        phi_742_ = (_e167 > 0f);
                                    }
                                    let _e178 = phi_742_;
                                    phi_743_ = _e178;
                                    phi_744_ = _e175;
                                }
                                let _e180 = phi_743_;
                                let _e182 = phi_744_;
                                if _e182 {
                                    phi_748_ = true;
                                } else {
                                    phi_748_ = _e180;
                                }
                                let _e184 = phi_748_;
                                phi_749_ = _e184;
                                phi_750_ = false;
                            } else {
                                phi_749_ = bool();
                                phi_750_ = true;
                            }
                            let _e186 = phi_749_;
                            let _e188 = phi_750_;
                            phi_751_ = _e186;
                            phi_752_ = false;
                            phi_753_ = _e188;
                        } else {
                            phi_751_ = bool();
                            phi_752_ = true;
                            phi_753_ = false;
                        }
                        let _e190 = phi_751_;
                        let _e192 = phi_752_;
                        let _e194 = phi_753_;
                        phi_754_ = _e190;
                        phi_755_ = _e192;
                        phi_756_ = _e194;
                    } else {
                        phi_754_ = bool();
                        phi_755_ = true;
                        phi_756_ = false;
                    }
                    let _e196 = phi_754_;
                    let _e198 = phi_755_;
                    let _e200 = phi_756_;
                    phi_757_ = _e196;
                    phi_758_ = _e198;
                    phi_759_ = _e200;
                } else {
                    phi_757_ = bool();
                    phi_758_ = true;
                    phi_759_ = false;
                }
                let _e202 = phi_757_;
                let _e204 = phi_758_;
                let _e206 = phi_759_;
                phi_760_ = _e202;
                phi_761_ = _e204;
                phi_762_ = _e206;
            } else {
                phi_760_ = bool();
                phi_761_ = true;
                phi_762_ = false;
            }
            let _e208 = phi_760_;
            let _e210 = phi_761_;
            let _e212 = phi_762_;
            phi_763_ = _e208;
            phi_764_ = _e210;
            phi_765_ = _e212;
        } else {
            phi_763_ = bool();
            phi_764_ = true;
            phi_765_ = false;
        }
        let _e214 = phi_763_;
        let _e216 = phi_764_;
        let _e218 = phi_765_;
        if _e216 {
            phi_769_ = true;
        } else {
            phi_769_ = _e218;
        }
        let _e220 = phi_769_;
        if _e220 {
            phi_773_ = false;
        } else {
            phi_773_ = _e214;
        }
        let _e222 = phi_773_;
        if _e222 {
            let _e223 = (0u >= _e75);
            if _e223 {
                phi_2323_ = lt_bvh_Hit();
            } else {
                if (0u < _e75) {
                } else {
                    return;
                }
                let _e229 = nodes.member[(0u + 0u)].frame[0u];
                let _e233 = nodes.member[(0u + 0u)].frame[1u];
                let _e237 = nodes.member[(0u + 0u)].frame[2u];
                let _e241 = nodes.member[(0u + 0u)].frame[0u];
                let _e245 = nodes.member[(0u + 0u)].frame[1u];
                let _e249 = nodes.member[(0u + 0u)].frame[2u];
                let _e253 = nodes.member[(0u + 0u)].frame[3u];
                let _e291 = core_intrinsics_maximum_number_nsz_f32_(abs(_e151.direction.x), abs(_e151.direction.y));
                let _e292 = core_intrinsics_maximum_number_nsz_f32_(_e291, abs(_e151.direction.z));
                let _e293 = (_e292 * 0.0000000000009094947f);
                if (abs(_e151.direction.x) < _e293) {
                    phi_848_ = _e293;
                } else {
                    phi_848_ = abs(_e151.direction.x);
                }
                let _e300 = phi_848_;
                if (_e151.direction.x < 0f) {
                    phi_855_ = (-1f / _e300);
                } else {
                    phi_855_ = (1f / _e300);
                }
                let _e305 = phi_855_;
                if (abs(_e151.direction.y) < _e293) {
                    phi_863_ = _e293;
                } else {
                    phi_863_ = abs(_e151.direction.y);
                }
                let _e312 = phi_863_;
                if (_e151.direction.y < 0f) {
                    phi_870_ = (-1f / _e312);
                } else {
                    phi_870_ = (1f / _e312);
                }
                let _e317 = phi_870_;
                if (abs(_e151.direction.z) < _e293) {
                    phi_878_ = _e293;
                } else {
                    phi_878_ = abs(_e151.direction.z);
                }
                let _e324 = phi_878_;
                if (_e151.direction.z < 0f) {
                    phi_885_ = (-1f / _e324);
                } else {
                    phi_885_ = (1f / _e324);
                }
                let _e329 = phi_885_;
                let _e337 = abs((bitcast<f32>(_e229) - _e151.origin.x));
                let _e338 = abs((bitcast<f32>(_e233) - _e151.origin.y));
                let _e339 = abs((bitcast<f32>(_e237) - _e151.origin.z));
                let _e347 = abs(((bitcast<f32>(_e241) + (bitcast<f32>((((_e253 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e151.origin.x));
                let _e348 = abs(((bitcast<f32>(_e245) + (bitcast<f32>((((_e253 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e151.origin.y));
                let _e349 = abs(((bitcast<f32>(_e249) + (bitcast<f32>((((_e253 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e151.origin.z));
                if (_e337 > _e347) {
                    phi_910_ = _e337;
                } else {
                    phi_910_ = _e347;
                }
                let _e352 = phi_910_;
                if (_e338 > _e348) {
                    phi_915_ = _e338;
                } else {
                    phi_915_ = _e348;
                }
                let _e355 = phi_915_;
                if (_e339 > _e349) {
                    phi_920_ = _e339;
                } else {
                    phi_920_ = _e349;
                }
                let _e358 = phi_920_;
                let _e359 = core_intrinsics_maximum_number_nsz_f32_(_e352, _e355);
                let _e360 = core_intrinsics_maximum_number_nsz_f32_(_e359, _e358);
                let _e365 = (_e360 * 0.0000019073486f);
                let _e366 = (abs(_e305) * _e365);
                let _e367 = (abs(_e317) * _e365);
                let _e368 = (abs(_e329) * _e365);
                let _e372 = (_e360 * 0.0000009536743f);
                let _e373 = (abs(_e305) * _e372);
                let _e374 = (abs(_e317) * _e372);
                let _e375 = (abs(_e329) * _e372);
                let _e378 = abs(_e151.direction.x);
                let _e380 = abs(_e151.direction.y);
                let _e382 = abs(_e151.direction.z);
                if (_e378 >= _e380) {
                    if (_e378 >= _e382) {
                        phi_953_ = false;
                    } else {
                        phi_953_ = true;
                    }
                    let _e386 = phi_953_;
                    phi_954_ = _e386;
                } else {
                    phi_954_ = true;
                }
                let _e388 = phi_954_;
                if _e388 {
                    if (_e380 >= _e382) {
                        phi_962_ = 1u;
                    } else {
                        phi_962_ = 2u;
                    }
                    let _e391 = phi_962_;
                    phi_963_ = _e391;
                } else {
                    phi_963_ = 0u;
                }
                let _e393 = phi_963_;
                if (_e393 == 0u) {
                    phi_982_ = vec3<f32>(_e151.direction.y, _e151.direction.z, _e151.direction.x);
                } else {
                    if (_e393 == 1u) {
                        phi_981_ = vec3<f32>(_e151.direction.z, _e151.direction.x, _e151.direction.y);
                    } else {
                        phi_981_ = _e151.direction;
                    }
                    let _e406 = phi_981_;
                    phi_982_ = _e406;
                }
                let _e408 = phi_982_;
                let _e412 = (_e408.x / _e408.z);
                let _e415 = (_e408.y / _e408.z);
                let _e417 = (1f / _e408.z);
                if (_e305 < 0f) {
                    phi_996_ = 0u;
                } else {
                    phi_996_ = 1u;
                }
                let _e420 = phi_996_;
                if (_e317 < 0f) {
                    phi_1001_ = 0u;
                } else {
                    phi_1001_ = 2u;
                }
                let _e423 = phi_1001_;
                if (_e329 < 0f) {
                    phi_1006_ = 0u;
                } else {
                    phi_1006_ = 4u;
                }
                let _e426 = phi_1006_;
                let _e428 = ((_e420 | _e423) | _e426);
                let _e429 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e429.first[0], _e429.first[1], _e429.first[2], _e429.first[3], _e429.first[4], _e429.first[5], _e429.first[6], _e429.first[7], _e429.first[8], _e429.first[9], _e429.first[10], _e429.first[11], _e429.first[12], _e429.first[13], _e429.first[14], _e429.first[15], _e429.first[16], _e429.first[17], _e429.first[18], _e429.first[19], _e429.first[20], _e429.first[21], _e429.first[22], _e429.first[23], _e429.first[24], _e429.first[25], _e429.first[26], _e429.first[27], _e429.first[28], _e429.first[29], _e429.first[30], _e429.first[31]), array<u32, 32>(_e429.mask[0], _e429.mask[1], _e429.mask[2], _e429.mask[3], _e429.mask[4], _e429.mask[5], _e429.mask[6], _e429.mask[7], _e429.mask[8], _e429.mask[9], _e429.mask[10], _e429.mask[11], _e429.mask[12], _e429.mask[13], _e429.mask[14], _e429.mask[15], _e429.mask[16], _e429.mask[17], _e429.mask[18], _e429.mask[19], _e429.mask[20], _e429.mask[21], _e429.mask[22], _e429.mask[23], _e429.mask[24], _e429.mask[25], _e429.mask[26], _e429.mask[27], _e429.mask[28], _e429.mask[29], _e429.mask[30], _e429.mask[31]), _e429.len, _e429.group, _e429.group_mask);
                let _e503 = local_1.group_mask;
                if ((_e503 & 4278190080u) == 0u) {
                    let _e507 = local_1.len;
                    if (_e507 == 0u) {
                        phi_1120_ = false;
                    } else {
                        let _e511 = local_1.len;
                        local_1.len = (_e511 - 1u);
                        let _e514 = local_1.len;
                        if (_e514 < 32u) {
                        } else {
                            return;
                        }
                        let _e519 = local_1.first[(0u + _e514)];
                        local_1.group = _e519;
                        let _e522 = local_1.len;
                        if (_e522 < 32u) {
                        } else {
                            return;
                        }
                        let _e527 = local_1.mask[(0u + _e522)];
                        local_1.group_mask = _e527;
                        phi_1120_ = true;
                    }
                    let _e530 = phi_1120_;
                    phi_1121_ = _e530;
                } else {
                    phi_1121_ = true;
                }
                let _e532 = phi_1121_;
                if _e532 {
                    let _e534 = local_1.group_mask;
                    let _e540 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e534)), 32u, (_e534 == 0u)));
                    let _e544 = local_1.group_mask;
                    let _e558 = local_1.group_mask;
                    local_1.group_mask = (_e558 & ~((1u << bitcast<u32>((_e540 & 31u)))));
                    let _e561 = local_1.group;
                    phi_1152_ = (_e561 + countOneBits(((_e544 & ~((4294967295u << bitcast<u32>((((_e540 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1152_ = 4294967295u;
                }
                let _e564 = phi_1152_;
                phi_1154_ = _e153;
                phi_1157_ = _e564;
                loop {
                    let _e566 = phi_1154_;
                    let _e568 = phi_1157_;
                    local_6 = _e566;
                    let _e569 = (_e568 != 4294967295u);
                    if _e569 {
                        if (_e568 < _e75) {
                        } else {
                            return;
                        }
                        let _e577 = nodes.member[(0u + _e568)].frame[3u];
                        let _e602 = (bitcast<f32>((((_e577 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e305);
                        let _e603 = (bitcast<f32>((((_e577 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e317);
                        let _e604 = (bitcast<f32>((((_e577 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e329);
                        let _e607 = nodes.member[(0u + _e568)].frame[0u];
                        let _e611 = nodes.member[(0u + _e568)].frame[1u];
                        let _e615 = nodes.member[(0u + _e568)].frame[2u];
                        let _e623 = ((bitcast<f32>(_e607) - _e151.origin.x) * _e305);
                        let _e624 = ((bitcast<f32>(_e611) - _e151.origin.y) * _e317);
                        let _e625 = ((bitcast<f32>(_e615) - _e151.origin.z) * _e329);
                        let _e633 = nodes.member[(0u + _e568)].x;
                        if (_e305 < 0f) {
                            let _e644 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e633.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e650 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e644.unnamed.root, _e633.w), _e644.unnamed_1);
                            let _e656 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e650.unnamed, lt_bvh_traverse_Tree(_e633.x, _e650.unnamed_1.first_primitive));
                            phi_1242_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e656.unnamed, lt_bvh_traverse_Tree(_e656.unnamed_1.root, _e633.y));
                        } else {
                            let _e672 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e633.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e678 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e672.unnamed.root, _e633.y), _e672.unnamed_1);
                            let _e684 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e678.unnamed, lt_bvh_traverse_Tree(_e633.z, _e678.unnamed_1.first_primitive));
                            phi_1242_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e684.unnamed, lt_bvh_traverse_Tree(_e684.unnamed_1.root, _e633.w));
                        }
                        let _e692 = phi_1242_;
                        let _e702 = nodes.member[(0u + _e568)].y;
                        if (_e317 < 0f) {
                            let _e713 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e702.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e719 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e713.unnamed.root, _e702.w), _e713.unnamed_1);
                            let _e725 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e719.unnamed, lt_bvh_traverse_Tree(_e702.x, _e719.unnamed_1.first_primitive));
                            phi_1269_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e725.unnamed, lt_bvh_traverse_Tree(_e725.unnamed_1.root, _e702.y));
                        } else {
                            let _e741 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e702.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e747 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e741.unnamed.root, _e702.y), _e741.unnamed_1);
                            let _e753 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e747.unnamed, lt_bvh_traverse_Tree(_e702.z, _e747.unnamed_1.first_primitive));
                            phi_1269_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e753.unnamed, lt_bvh_traverse_Tree(_e753.unnamed_1.root, _e702.w));
                        }
                        let _e761 = phi_1269_;
                        let _e771 = nodes.member[(0u + _e568)].z;
                        if (_e329 < 0f) {
                            let _e782 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e771.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e788 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e782.unnamed.root, _e771.w), _e782.unnamed_1);
                            let _e794 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e788.unnamed, lt_bvh_traverse_Tree(_e771.x, _e788.unnamed_1.first_primitive));
                            phi_1296_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e794.unnamed, lt_bvh_traverse_Tree(_e794.unnamed_1.root, _e771.y));
                        } else {
                            let _e810 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e771.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e816 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e810.unnamed.root, _e771.y), _e810.unnamed_1);
                            let _e822 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e816.unnamed, lt_bvh_traverse_Tree(_e771.z, _e816.unnamed_1.first_primitive));
                            phi_1296_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e822.unnamed, lt_bvh_traverse_Tree(_e822.unnamed_1.root, _e771.w));
                        }
                        let _e830 = phi_1296_;
                        phi_1302_ = 0u;
                        phi_1305_ = 0u;
                        loop {
                            let _e840 = phi_1302_;
                            let _e842 = phi_1305_;
                            local_2 = _e842;
                            local_3 = _e842;
                            local_4 = _e842;
                            let _e843 = (_e840 < 8u);
                            if _e843 {
                                let _e845 = (_e840 >> bitcast<u32>(2i));
                                let _e846 = (_e840 & 3u);
                                if (_e845 == 0u) {
                                    phi_1319_ = _e692.unnamed.root;
                                } else {
                                    phi_1319_ = _e692.unnamed.first_primitive;
                                }
                                let _e849 = phi_1319_;
                                if (_e845 == 0u) {
                                    phi_1329_ = _e761.unnamed.root;
                                } else {
                                    phi_1329_ = _e761.unnamed.first_primitive;
                                }
                                let _e858 = phi_1329_;
                                if (_e845 == 0u) {
                                    phi_1339_ = _e830.unnamed.root;
                                } else {
                                    phi_1339_ = _e830.unnamed.first_primitive;
                                }
                                let _e867 = phi_1339_;
                                let _e880 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e849 >> bitcast<u32>(((_e846 * 8u) & 31u))) & 255u)) * _e602) + (_e623 - _e366)), ((f32(((_e858 >> bitcast<u32>(((_e846 * 8u) & 31u))) & 255u)) * _e603) + (_e624 - _e367)));
                                let _e881 = core_intrinsics_maximum_number_nsz_f32_(_e880, ((f32(((_e867 >> bitcast<u32>(((_e846 * 8u) & 31u))) & 255u)) * _e604) + (_e625 - _e368)));
                                if (_e845 == 0u) {
                                    phi_1357_ = _e692.unnamed_1.root;
                                } else {
                                    phi_1357_ = _e692.unnamed_1.first_primitive;
                                }
                                let _e884 = phi_1357_;
                                if (_e845 == 0u) {
                                    phi_1367_ = _e761.unnamed_1.root;
                                } else {
                                    phi_1367_ = _e761.unnamed_1.first_primitive;
                                }
                                let _e893 = phi_1367_;
                                if (_e845 == 0u) {
                                    phi_1377_ = _e830.unnamed_1.root;
                                } else {
                                    phi_1377_ = _e830.unnamed_1.first_primitive;
                                }
                                let _e902 = phi_1377_;
                                let _e915 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e884 >> bitcast<u32>(((_e846 * 8u) & 31u))) & 255u)) * _e602) + (_e623 + _e366)), ((f32(((_e893 >> bitcast<u32>(((_e846 * 8u) & 31u))) & 255u)) * _e603) + (_e624 + _e367)));
                                let _e916 = core_intrinsics_minimum_number_nsz_f32_(_e915, ((f32(((_e902 >> bitcast<u32>(((_e846 * 8u) & 31u))) & 255u)) * _e604) + (_e625 + _e368)));
                                if (_e881 <= _e916) {
                                    if (_e881 <= _e566.t) {
                                        if (_e916 >= _e151.tmin) {
                                            if (_e845 == 0u) {
                                                let _e923 = nodes.member[(0u + _e568)].links[2u];
                                                phi_1413_ = _e923;
                                            } else {
                                                let _e926 = nodes.member[(0u + _e568)].links[3u];
                                                phi_1413_ = _e926;
                                            }
                                            let _e928 = phi_1413_;
                                            let _e933 = ((_e928 >> bitcast<u32>(((_e846 * 8u) & 31u))) & 255u);
                                            let _e934 = (_e933 & 31u);
                                            if (_e934 >= 24u) {
                                                phi_1426_ = (24u + ((_e934 - 24u) ^ _e428));
                                            } else {
                                                phi_1426_ = _e934;
                                            }
                                            let _e940 = phi_1426_;
                                            phi_1431_ = (_e842 | ((_e933 >> bitcast<u32>(5i)) << bitcast<u32>((_e940 & 31u))));
                                        } else {
                                            phi_1431_ = _e842;
                                        }
                                        let _e948 = phi_1431_;
                                        phi_1432_ = _e948;
                                    } else {
                                        phi_1432_ = _e842;
                                    }
                                    let _e950 = phi_1432_;
                                    phi_1433_ = _e950;
                                } else {
                                    phi_1433_ = _e842;
                                }
                                let _e952 = phi_1433_;
                                phi_1303_ = (_e840 + 1u);
                                phi_1306_ = _e952;
                            } else {
                                phi_1303_ = u32();
                                phi_1306_ = u32();
                            }
                            let _e955 = phi_1303_;
                            let _e957 = phi_1306_;
                            continue;
                            continuing {
                                phi_1302_ = _e955;
                                phi_1305_ = _e957;
                                break if !(_e843);
                            }
                        }
                        let _e961 = nodes.member[(0u + _e568)].links[0u];
                        let _e965 = nodes.member[(0u + _e568)].frame[3u];
                        let _e969 = local_2;
                        if ((_e969 & 4278190080u) == 0u) {
                        } else {
                            let _e973 = local_1.group_mask;
                            if ((_e973 & 4278190080u) == 0u) {
                            } else {
                                let _e977 = local_1.len;
                                if (_e977 < 32u) {
                                    let _e980 = local_1.group;
                                    let _e982 = local_1.len;
                                    if (_e982 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.first[(0u + _e982)] = _e980;
                                    let _e988 = local_1.group_mask;
                                    let _e990 = local_1.len;
                                    if (_e990 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.mask[(0u + _e990)] = _e988;
                                    let _e997 = local_1.len;
                                    local_1.len = (_e997 + 1u);
                                }
                            }
                            local_1.group = (0u + _e961);
                            let _e1001 = local_3;
                            local_1.group_mask = ((_e1001 & 4278190080u) | (_e965 >> bitcast<u32>(24i)));
                        }
                        let _e1006 = local_4;
                        phi_1491_ = _e566;
                        phi_1494_ = (_e1006 & 16777215u);
                        loop {
                            let _e1009 = phi_1491_;
                            let _e1011 = phi_1494_;
                            local_5 = _e1009;
                            if (_e1011 == 0u) {
                                phi_1492_ = lt_bvh_Hit();
                                phi_1495_ = u32();
                                phi_2251_ = false;
                            } else {
                                let _e1015 = nodes.member[(0u + _e568)].links[1u];
                                let _e1020 = ((0u + _e1015) + select(firstTrailingBit(_e1011), 32u, (_e1011 == 0u)));
                                if (_e1020 < _e78) {
                                } else {
                                    return;
                                }
                                let _e1027 = triangles.member[(0u + _e1020)].v0_;
                                let _e1030 = (_e1027.x - _e151.origin.x);
                                let _e1033 = (_e1027.y - _e151.origin.y);
                                let _e1036 = (_e1027.z - _e151.origin.z);
                                if (_e393 == 0u) {
                                    phi_1541_ = vec3<f32>(_e1033, _e1036, _e1030);
                                } else {
                                    if (_e393 == 1u) {
                                        phi_1540_ = vec3<f32>(_e1036, _e1030, _e1033);
                                    } else {
                                        phi_1540_ = (_e1027 - _e151.origin);
                                    }
                                    let _e1043 = phi_1540_;
                                    phi_1541_ = _e1043;
                                }
                                let _e1045 = phi_1541_;
                                let _e1049 = (_e1045.x - (_e412 * _e1045.z));
                                let _e1053 = (_e1045.y - (_e415 * _e1045.z));
                                let _e1057 = triangles.member[(0u + _e1020)].v1_;
                                let _e1060 = (_e1057.x - _e151.origin.x);
                                let _e1063 = (_e1057.y - _e151.origin.y);
                                let _e1066 = (_e1057.z - _e151.origin.z);
                                if (_e393 == 0u) {
                                    phi_1575_ = vec3<f32>(_e1063, _e1066, _e1060);
                                } else {
                                    if (_e393 == 1u) {
                                        phi_1574_ = vec3<f32>(_e1066, _e1060, _e1063);
                                    } else {
                                        phi_1574_ = (_e1057 - _e151.origin);
                                    }
                                    let _e1073 = phi_1574_;
                                    phi_1575_ = _e1073;
                                }
                                let _e1075 = phi_1575_;
                                let _e1079 = (_e1075.x - (_e412 * _e1075.z));
                                let _e1083 = (_e1075.y - (_e415 * _e1075.z));
                                let _e1087 = triangles.member[(0u + _e1020)].v2_;
                                let _e1090 = (_e1087.x - _e151.origin.x);
                                let _e1093 = (_e1087.y - _e151.origin.y);
                                let _e1096 = (_e1087.z - _e151.origin.z);
                                if (_e393 == 0u) {
                                    phi_1609_ = vec3<f32>(_e1093, _e1096, _e1090);
                                } else {
                                    if (_e393 == 1u) {
                                        phi_1608_ = vec3<f32>(_e1096, _e1090, _e1093);
                                    } else {
                                        phi_1608_ = (_e1087 - _e151.origin);
                                    }
                                    let _e1103 = phi_1608_;
                                    phi_1609_ = _e1103;
                                }
                                let _e1105 = phi_1609_;
                                let _e1109 = (_e1105.x - (_e412 * _e1105.z));
                                let _e1113 = (_e1105.y - (_e415 * _e1105.z));
                                if (_e1079 < _e1109) {
                                    phi_1630_ = true;
                                } else {
                                    if (_e1079 == _e1109) {
                                        phi_1629_ = (_e1083 < _e1113);
                                    } else {
                                        phi_1629_ = false;
                                    }
                                    let _e1120 = phi_1629_;
                                    phi_1630_ = _e1120;
                                }
                                let _e1122 = phi_1630_;
                                if _e1122 {
                                    phi_1634_ = _e1113;
                                    phi_1635_ = _e1109;
                                    phi_1636_ = _e1083;
                                    phi_1637_ = _e1079;
                                } else {
                                    phi_1634_ = _e1083;
                                    phi_1635_ = _e1079;
                                    phi_1636_ = _e1113;
                                    phi_1637_ = _e1109;
                                }
                                let _e1124 = phi_1634_;
                                let _e1126 = phi_1635_;
                                let _e1128 = phi_1636_;
                                let _e1130 = phi_1637_;
                                let _e1133 = ((_e1130 * _e1124) - (_e1128 * _e1126));
                                if _e1122 {
                                    phi_1645_ = -(_e1133);
                                } else {
                                    phi_1645_ = _e1133;
                                }
                                let _e1136 = phi_1645_;
                                if (_e1109 < _e1049) {
                                    phi_1656_ = true;
                                } else {
                                    if (_e1109 == _e1049) {
                                        phi_1655_ = (_e1113 < _e1053);
                                    } else {
                                        phi_1655_ = false;
                                    }
                                    let _e1141 = phi_1655_;
                                    phi_1656_ = _e1141;
                                }
                                let _e1143 = phi_1656_;
                                if _e1143 {
                                    phi_1660_ = _e1053;
                                    phi_1661_ = _e1049;
                                    phi_1662_ = _e1113;
                                    phi_1663_ = _e1109;
                                } else {
                                    phi_1660_ = _e1113;
                                    phi_1661_ = _e1109;
                                    phi_1662_ = _e1053;
                                    phi_1663_ = _e1049;
                                }
                                let _e1145 = phi_1660_;
                                let _e1147 = phi_1661_;
                                let _e1149 = phi_1662_;
                                let _e1151 = phi_1663_;
                                let _e1154 = ((_e1151 * _e1145) - (_e1149 * _e1147));
                                if _e1143 {
                                    phi_1671_ = -(_e1154);
                                } else {
                                    phi_1671_ = _e1154;
                                }
                                let _e1157 = phi_1671_;
                                if (_e1049 < _e1079) {
                                    phi_1682_ = true;
                                } else {
                                    if (_e1049 == _e1079) {
                                        phi_1681_ = (_e1053 < _e1083);
                                    } else {
                                        phi_1681_ = false;
                                    }
                                    let _e1162 = phi_1681_;
                                    phi_1682_ = _e1162;
                                }
                                let _e1164 = phi_1682_;
                                if _e1164 {
                                    phi_1686_ = _e1083;
                                    phi_1687_ = _e1079;
                                    phi_1688_ = _e1053;
                                    phi_1689_ = _e1049;
                                } else {
                                    phi_1686_ = _e1053;
                                    phi_1687_ = _e1049;
                                    phi_1688_ = _e1083;
                                    phi_1689_ = _e1079;
                                }
                                let _e1166 = phi_1686_;
                                let _e1168 = phi_1687_;
                                let _e1170 = phi_1688_;
                                let _e1172 = phi_1689_;
                                let _e1175 = ((_e1172 * _e1166) - (_e1170 * _e1168));
                                if _e1164 {
                                    phi_1697_ = -(_e1175);
                                } else {
                                    phi_1697_ = _e1175;
                                }
                                let _e1178 = phi_1697_;
                                if (_e1136 >= 0f) {
                                    if (_e1157 >= 0f) {
                                        if (_e1178 >= 0f) {
                                            phi_1712_ = ((_e1136 + _e1157) + _e1178);
                                            phi_1713_ = false;
                                        } else {
                                            phi_1712_ = f32();
                                            phi_1713_ = true;
                                        }
                                        let _e1185 = phi_1712_;
                                        let _e1187 = phi_1713_;
                                        phi_1714_ = _e1185;
                                        phi_1715_ = _e1187;
                                    } else {
                                        phi_1714_ = f32();
                                        phi_1715_ = true;
                                    }
                                    let _e1189 = phi_1714_;
                                    let _e1191 = phi_1715_;
                                    phi_1716_ = _e1189;
                                    phi_1717_ = _e1191;
                                } else {
                                    phi_1716_ = f32();
                                    phi_1717_ = true;
                                }
                                let _e1193 = phi_1716_;
                                let _e1195 = phi_1717_;
                                if _e1195 {
                                    if (_e1136 <= 0f) {
                                        if (_e1157 <= 0f) {
                                            let _e1198 = (_e1178 <= 0f);
                                            if _e1198 {
                                            }
                                            phi_1735_ = ((_e1136 + _e1157) + _e1178);
                                            phi_1736_ = false;
                                            phi_1737_ = _e1198;
                                        } else {
                                            phi_1735_ = f32();
                                            phi_1736_ = true;
                                            phi_1737_ = false;
                                        }
                                        let _e1202 = phi_1735_;
                                        let _e1204 = phi_1736_;
                                        let _e1206 = phi_1737_;
                                        phi_1738_ = _e1202;
                                        phi_1739_ = _e1204;
                                        phi_1740_ = _e1206;
                                    } else {
                                        phi_1738_ = f32();
                                        phi_1739_ = true;
                                        phi_1740_ = false;
                                    }
                                    let _e1208 = phi_1738_;
                                    let _e1210 = phi_1739_;
                                    let _e1212 = phi_1740_;
                                    if _e1210 {
                                        phi_1744_ = false;
                                    } else {
                                        phi_1744_ = _e1212;
                                    }
                                    let _e1214 = phi_1744_;
                                    phi_1745_ = _e1208;
                                    phi_1746_ = _e1214;
                                } else {
                                    phi_1745_ = _e1193;
                                    phi_1746_ = true;
                                }
                                let _e1216 = phi_1745_;
                                let _e1218 = phi_1746_;
                                if _e1218 {
                                    let _e1219 = (_e1216 == 0f);
                                    if _e1219 {
                                        phi_1967_ = lt_bvh_triangle_Intersection();
                                        phi_1968_ = false;
                                    } else {
                                        let _e1225 = ((((_e1136 * (_e417 * _e1045.z)) + (_e1157 * (_e417 * _e1075.z))) + (_e1178 * (_e417 * _e1105.z))) / _e1216);
                                        if (_e1225 > _e151.tmin) {
                                            if (_e1225 < _e151.tmax) {
                                                let _e1231 = triangles.member[(0u + _e1020)].v0_;
                                                let _e1233 = triangles.member[(0u + _e1020)].v1_;
                                                if (_e1231.x < _e1233.x) {
                                                    phi_1782_ = _e1231.x;
                                                } else {
                                                    phi_1782_ = _e1233.x;
                                                }
                                                let _e1240 = phi_1782_;
                                                if (_e1231.y < _e1233.y) {
                                                    phi_1791_ = _e1231.y;
                                                } else {
                                                    phi_1791_ = _e1233.y;
                                                }
                                                let _e1247 = phi_1791_;
                                                if (_e1231.z < _e1233.z) {
                                                    phi_1800_ = _e1231.z;
                                                } else {
                                                    phi_1800_ = _e1233.z;
                                                }
                                                let _e1254 = phi_1800_;
                                                let _e1256 = triangles.member[(0u + _e1020)].v2_;
                                                if (_e1240 < _e1256.x) {
                                                    phi_1809_ = _e1240;
                                                } else {
                                                    phi_1809_ = _e1256.x;
                                                }
                                                let _e1261 = phi_1809_;
                                                if (_e1247 < _e1256.y) {
                                                    phi_1816_ = _e1247;
                                                } else {
                                                    phi_1816_ = _e1256.y;
                                                }
                                                let _e1266 = phi_1816_;
                                                if (_e1254 < _e1256.z) {
                                                    phi_1823_ = _e1254;
                                                } else {
                                                    phi_1823_ = _e1256.z;
                                                }
                                                let _e1271 = phi_1823_;
                                                let _e1273 = triangles.member[(0u + _e1020)].v0_;
                                                let _e1275 = triangles.member[(0u + _e1020)].v1_;
                                                if (_e1273.x > _e1275.x) {
                                                    phi_1836_ = _e1273.x;
                                                } else {
                                                    phi_1836_ = _e1275.x;
                                                }
                                                let _e1282 = phi_1836_;
                                                if (_e1273.y > _e1275.y) {
                                                    phi_1845_ = _e1273.y;
                                                } else {
                                                    phi_1845_ = _e1275.y;
                                                }
                                                let _e1289 = phi_1845_;
                                                if (_e1273.z > _e1275.z) {
                                                    phi_1854_ = _e1273.z;
                                                } else {
                                                    phi_1854_ = _e1275.z;
                                                }
                                                let _e1296 = phi_1854_;
                                                let _e1298 = triangles.member[(0u + _e1020)].v2_;
                                                if (_e1282 > _e1298.x) {
                                                    phi_1863_ = _e1282;
                                                } else {
                                                    phi_1863_ = _e1298.x;
                                                }
                                                let _e1303 = phi_1863_;
                                                if (_e1289 > _e1298.y) {
                                                    phi_1870_ = _e1289;
                                                } else {
                                                    phi_1870_ = _e1298.y;
                                                }
                                                let _e1308 = phi_1870_;
                                                if (_e1296 > _e1298.z) {
                                                    phi_1877_ = _e1296;
                                                } else {
                                                    phi_1877_ = _e1298.z;
                                                }
                                                let _e1313 = phi_1877_;
                                                let _e1320 = ((_e1261 - _e151.origin.x) * _e305);
                                                let _e1321 = ((_e1266 - _e151.origin.y) * _e317);
                                                let _e1322 = ((_e1271 - _e151.origin.z) * _e329);
                                                let _e1329 = ((_e1303 - _e151.origin.x) * _e305);
                                                let _e1330 = ((_e1308 - _e151.origin.y) * _e317);
                                                let _e1331 = ((_e1313 - _e151.origin.z) * _e329);
                                                if (_e1320 < _e1329) {
                                                    phi_1900_ = _e1320;
                                                } else {
                                                    phi_1900_ = _e1329;
                                                }
                                                let _e1334 = phi_1900_;
                                                if (_e1321 < _e1330) {
                                                    phi_1905_ = _e1321;
                                                } else {
                                                    phi_1905_ = _e1330;
                                                }
                                                let _e1337 = phi_1905_;
                                                if (_e1322 < _e1331) {
                                                    phi_1910_ = _e1322;
                                                } else {
                                                    phi_1910_ = _e1331;
                                                }
                                                let _e1340 = phi_1910_;
                                                if (_e1320 > _e1329) {
                                                    phi_1918_ = _e1320;
                                                } else {
                                                    phi_1918_ = _e1329;
                                                }
                                                let _e1346 = phi_1918_;
                                                if (_e1321 > _e1330) {
                                                    phi_1923_ = _e1321;
                                                } else {
                                                    phi_1923_ = _e1330;
                                                }
                                                let _e1349 = phi_1923_;
                                                if (_e1322 > _e1331) {
                                                    phi_1928_ = _e1322;
                                                } else {
                                                    phi_1928_ = _e1331;
                                                }
                                                let _e1352 = phi_1928_;
                                                let _e1356 = core_intrinsics_maximum_number_nsz_f32_((_e1334 - _e373), (_e1337 - _e374));
                                                let _e1357 = core_intrinsics_maximum_number_nsz_f32_(_e1356, (_e1340 - _e375));
                                                let _e1358 = core_intrinsics_minimum_number_nsz_f32_((_e1346 + _e373), (_e1349 + _e374));
                                                let _e1359 = core_intrinsics_minimum_number_nsz_f32_(_e1358, (_e1352 + _e375));
                                                if (_e1357 > -300000000000000000000000000000000000000f) {
                                                    phi_1940_ = _e1357;
                                                } else {
                                                    phi_1940_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1362 = phi_1940_;
                                                if (_e1359 < 300000000000000000000000000000000000000f) {
                                                    phi_1945_ = _e1359;
                                                } else {
                                                    phi_1945_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1365 = phi_1945_;
                                                if (_e1225 < _e1362) {
                                                    phi_1950_ = _e1362;
                                                } else {
                                                    phi_1950_ = _e1225;
                                                }
                                                let _e1368 = phi_1950_;
                                                if (_e1368 > _e1365) {
                                                    phi_1955_ = _e1365;
                                                } else {
                                                    phi_1955_ = _e1368;
                                                }
                                                let _e1371 = phi_1955_;
                                                phi_1960_ = lt_bvh_triangle_Intersection(_e1371, (_e1157 / _e1216), (_e1178 / _e1216), (_e1362 <= _e1365));
                                                phi_1961_ = false;
                                            } else {
                                                phi_1960_ = lt_bvh_triangle_Intersection();
                                                phi_1961_ = true;
                                            }
                                            let _e1377 = phi_1960_;
                                            let _e1379 = phi_1961_;
                                            phi_1962_ = _e1377;
                                            phi_1963_ = _e1379;
                                        } else {
                                            phi_1962_ = lt_bvh_triangle_Intersection();
                                            phi_1963_ = true;
                                        }
                                        let _e1381 = phi_1962_;
                                        let _e1383 = phi_1963_;
                                        if _e1383 {
                                        }
                                        phi_1967_ = _e1381;
                                        phi_1968_ = _e1383;
                                    }
                                    let _e1385 = phi_1967_;
                                    let _e1387 = phi_1968_;
                                    phi_1969_ = _e1385;
                                    phi_1970_ = _e1219;
                                    phi_1971_ = _e1387;
                                } else {
                                    phi_1969_ = lt_bvh_triangle_Intersection();
                                    phi_1970_ = true;
                                    phi_1971_ = false;
                                }
                                let _e1389 = phi_1969_;
                                let _e1391 = phi_1970_;
                                let _e1393 = phi_1971_;
                                if _e1391 {
                                    phi_1975_ = true;
                                } else {
                                    phi_1975_ = _e1393;
                                }
                                let _e1395 = phi_1975_;
                                if _e1395 {
                                    phi_1979_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_1979_ = _e1389;
                                }
                                let _e1397 = phi_1979_;
                                if _e1397.is_hit {
                                    if (_e1397.t > _e151.tmin) {
                                        if (_e1397.t < _e1009.t) {
                                            phi_2028_ = true;
                                        } else {
                                            if (_e1397.t == _e1009.t) {
                                                if (_e1009.triangle != 4294967295u) {
                                                    if (_e1020 < _e1009.triangle) {
                                                        phi_2019_ = true;
                                                    } else {
                                                        if (_e1020 == _e1009.triangle) {
                                                            phi_2018_ = (4294967295u < _e1009.instance);
                                                        } else {
                                                            phi_2018_ = false;
                                                        }
                                                        let _e1416 = phi_2018_;
                                                        phi_2019_ = _e1416;
                                                    }
                                                    let _e1418 = phi_2019_;
                                                    phi_2020_ = _e1418;
                                                    phi_2021_ = false;
                                                } else {
                                                    phi_2020_ = bool();
                                                    phi_2021_ = true;
                                                }
                                                let _e1420 = phi_2020_;
                                                let _e1422 = phi_2021_;
                                                phi_2022_ = _e1420;
                                                phi_2023_ = _e1422;
                                            } else {
                                                phi_2022_ = bool();
                                                phi_2023_ = true;
                                            }
                                            let _e1424 = phi_2022_;
                                            let _e1426 = phi_2023_;
                                            if _e1426 {
                                                phi_2027_ = false;
                                            } else {
                                                phi_2027_ = _e1424;
                                            }
                                            let _e1428 = phi_2027_;
                                            phi_2028_ = _e1428;
                                        }
                                        let _e1430 = phi_2028_;
                                        if _e1430 {
                                            let _e1432 = triangles.member[(0u + _e1020)].i0_;
                                            if ((_e1432 & 2147483648u) == 0u) {
                                                phi_2239_ = true;
                                            } else {
                                                if (_e1020 < _e78) {
                                                } else {
                                                    return;
                                                }
                                                let _e1441 = triangles.member[(0u + _e1020)].i0_;
                                                let _e1442 = (_e1441 & 2147483647u);
                                                let _e1444 = triangles.member[(0u + _e1020)].i1_;
                                                let _e1446 = triangles.member[(0u + _e1020)].i2_;
                                                if (_e1442 < _e81) {
                                                } else {
                                                    return;
                                                }
                                                let _e1450 = vertices.member[(0u + _e1442)];
                                                if (_e1444 < _e81) {
                                                } else {
                                                    return;
                                                }
                                                let _e1454 = vertices.member[(0u + _e1444)];
                                                if (_e1446 < _e81) {
                                                } else {
                                                    return;
                                                }
                                                let _e1458 = vertices.member[(0u + _e1446)];
                                                let _e1459 = array<abi_Vertex, 3>(_e1450, _e1454, _e1458);
                                                if (_e1459[0].material < _e84) {
                                                } else {
                                                    return;
                                                }
                                                let _e1465 = materials.member[(0u + _e1459[0].material)];
                                                if ((_e1465.flags & 0u) == 0u) {
                                                    let _e1470 = ((1f - _e1397.u) - _e1397.v);
                                                    if (_e1465.cutoff <= 0f) {
                                                        phi_2234_ = true;
                                                    } else {
                                                        let _e1497 = (_e1465.base_color.w * ((((f32((_e1459[0].color >> bitcast<u32>(24i))) * _e1470) + (f32((_e1459[1].color >> bitcast<u32>(24i))) * _e1397.u)) + (f32((_e1459[2].color >> bitcast<u32>(24i))) * _e1397.v)) * (1f / 255f)));
                                                        if (_e1465.alpha_size == 0u) {
                                                            phi_2231_ = _e1497;
                                                        } else {
                                                            local.offset = _e1465.alpha_offset;
                                                            local.size = _e1465.alpha_size;
                                                            local.flags = _e1465.flags;
                                                            let _e1528 = _lt_shaders_texture_TextureView_quad((&local), (((_e1459[0].u * _e1470) + (_e1459[1].u * _e1397.u)) + (_e1459[2].u * _e1397.v)), (((_e1459[0].v * _e1470) + (_e1459[1].v * _e1397.u)) + (_e1459[2].v * _e1397.v)));
                                                            let _e1532 = (_e1528.indices[0] >> bitcast<u32>(2i));
                                                            if (_e1532 < _e90) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1536 = alpha_texels.member[(0u + _e1532)];
                                                            let _e1552 = (_e1528.indices[1] >> bitcast<u32>(2i));
                                                            if (_e1552 < _e90) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1556 = alpha_texels.member[(0u + _e1552)];
                                                            let _e1573 = (_e1528.indices[2] >> bitcast<u32>(2i));
                                                            if (_e1573 < _e90) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1577 = alpha_texels.member[(0u + _e1573)];
                                                            let _e1594 = (_e1528.indices[3] >> bitcast<u32>(2i));
                                                            if (_e1594 < _e90) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1598 = alpha_texels.member[(0u + _e1594)];
                                                            phi_2231_ = (_e1497 * (((((f32(((_e1536 >> bitcast<u32>((((_e1528.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1528.weights.x) + ((f32(((_e1556 >> bitcast<u32>((((_e1528.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1528.weights.y)) + ((f32(((_e1577 >> bitcast<u32>((((_e1528.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1528.weights.z)) + ((f32(((_e1598 >> bitcast<u32>((((_e1528.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1528.weights.w)));
                                                        }
                                                        let _e1614 = phi_2231_;
                                                        phi_2234_ = (_e1614 >= _e1465.cutoff);
                                                    }
                                                    let _e1618 = phi_2234_;
                                                    phi_2235_ = _e1618;
                                                } else {
                                                    phi_2235_ = false;
                                                }
                                                let _e1620 = phi_2235_;
                                                if _e1620 {
                                                }
                                                phi_2239_ = _e1620;
                                            }
                                            let _e1622 = phi_2239_;
                                            if _e1622 {
                                                phi_2247_ = lt_bvh_Hit(_e1397.t, _e1397.u, _e1397.v, _e1020, 4294967295u);
                                            } else {
                                                phi_2247_ = _e1009;
                                            }
                                            let _e1628 = phi_2247_;
                                            phi_2248_ = _e1628;
                                        } else {
                                            phi_2248_ = _e1009;
                                        }
                                        let _e1630 = phi_2248_;
                                        phi_2249_ = _e1630;
                                    } else {
                                        phi_2249_ = _e1009;
                                    }
                                    let _e1632 = phi_2249_;
                                    phi_2250_ = _e1632;
                                } else {
                                    phi_2250_ = _e1009;
                                }
                                let _e1634 = phi_2250_;
                                phi_1492_ = _e1634;
                                phi_1495_ = (_e1011 & (_e1011 - 1u));
                                phi_2251_ = true;
                            }
                            let _e1636 = phi_1492_;
                            let _e1638 = phi_1495_;
                            let _e1640 = phi_2251_;
                            continue;
                            continuing {
                                phi_1491_ = _e1636;
                                phi_1494_ = _e1638;
                                break if !(_e1640);
                            }
                        }
                        let _e1643 = local_1.group_mask;
                        if ((_e1643 & 4278190080u) == 0u) {
                            let _e1647 = local_1.len;
                            if (_e1647 == 0u) {
                                phi_2290_ = false;
                            } else {
                                let _e1651 = local_1.len;
                                local_1.len = (_e1651 - 1u);
                                let _e1654 = local_1.len;
                                if (_e1654 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1659 = local_1.first[(0u + _e1654)];
                                local_1.group = _e1659;
                                let _e1662 = local_1.len;
                                if (_e1662 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1667 = local_1.mask[(0u + _e1662)];
                                local_1.group_mask = _e1667;
                                phi_2290_ = true;
                            }
                            let _e1670 = phi_2290_;
                            phi_2291_ = _e1670;
                        } else {
                            phi_2291_ = true;
                        }
                        let _e1672 = phi_2291_;
                        if _e1672 {
                            let _e1674 = local_1.group_mask;
                            let _e1680 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1674)), 32u, (_e1674 == 0u)));
                            let _e1684 = local_1.group_mask;
                            let _e1698 = local_1.group_mask;
                            local_1.group_mask = (_e1698 & ~((1u << bitcast<u32>((_e1680 & 31u)))));
                            let _e1701 = local_1.group;
                            phi_2322_ = (_e1701 + countOneBits(((_e1684 & ~((4294967295u << bitcast<u32>((((_e1680 - 24u) ^ _e428) & 31u))))) & 255u)));
                        } else {
                            phi_2322_ = 4294967295u;
                        }
                        let _e1704 = phi_2322_;
                        let _e2401 = local_5;
                        phi_1155_ = _e2401;
                        phi_1158_ = _e1704;
                    } else {
                        phi_1155_ = lt_bvh_Hit();
                        phi_1158_ = u32();
                    }
                    let _e1706 = phi_1155_;
                    let _e1708 = phi_1158_;
                    continue;
                    continuing {
                        phi_1154_ = _e1706;
                        phi_1157_ = _e1708;
                        break if !(_e569);
                    }
                }
                let _e2405 = local_6;
                phi_2323_ = _e2405;
            }
            let _e1711 = phi_2323_;
            phi_2324_ = _e1711;
            phi_2325_ = _e223;
        } else {
            phi_2324_ = lt_bvh_Hit();
            phi_2325_ = true;
        }
        let _e1713 = phi_2324_;
        let _e1715 = phi_2325_;
        if _e1715 {
            phi_2329_ = _e153;
        } else {
            phi_2329_ = _e1713;
        }
        let _e1717 = phi_2329_;
        if (_e1717.triangle != 4294967295u) {
            let _e1723 = ((1f - _e1717.u) - _e1717.v);
            if (_e1717.triangle < _e78) {
            } else {
                return;
            }
            let _e1729 = triangles.member[(0u + _e1717.triangle)];
            let _e1754 = (((_e1729.v0_.x * _e1723) + (_e1729.v1_.x * _e1717.u)) + (_e1729.v2_.x * _e1717.v));
            let _e1755 = (((_e1729.v0_.y * _e1723) + (_e1729.v1_.y * _e1717.u)) + (_e1729.v2_.y * _e1717.v));
            let _e1756 = (((_e1729.v0_.z * _e1723) + (_e1729.v1_.z * _e1717.u)) + (_e1729.v2_.z * _e1717.v));
            let _e1759 = abs(_e1729.v0_.x);
            let _e1761 = abs(_e1729.v0_.y);
            let _e1763 = abs(_e1729.v0_.z);
            let _e1765 = abs(_e1729.v1_.x);
            let _e1767 = abs(_e1729.v1_.y);
            let _e1769 = abs(_e1729.v1_.z);
            if (_e1759 > _e1765) {
                phi_2394_ = _e1759;
            } else {
                phi_2394_ = _e1765;
            }
            let _e1772 = phi_2394_;
            if (_e1761 > _e1767) {
                phi_2399_ = _e1761;
            } else {
                phi_2399_ = _e1767;
            }
            let _e1775 = phi_2399_;
            if (_e1763 > _e1769) {
                phi_2404_ = _e1763;
            } else {
                phi_2404_ = _e1769;
            }
            let _e1778 = phi_2404_;
            let _e1780 = abs(_e1729.v2_.x);
            let _e1782 = abs(_e1729.v2_.y);
            let _e1784 = abs(_e1729.v2_.z);
            if (_e1772 > _e1780) {
                phi_2415_ = _e1772;
            } else {
                phi_2415_ = _e1780;
            }
            let _e1787 = phi_2415_;
            if (_e1775 > _e1782) {
                phi_2420_ = _e1775;
            } else {
                phi_2420_ = _e1782;
            }
            let _e1790 = phi_2420_;
            if (_e1778 > _e1784) {
                phi_2425_ = _e1778;
            } else {
                phi_2425_ = _e1784;
            }
            let _e1793 = phi_2425_;
            let _e1796 = (_e1729.v1_.x - _e1729.v0_.x);
            let _e1799 = (_e1729.v1_.y - _e1729.v0_.y);
            let _e1802 = (_e1729.v1_.z - _e1729.v0_.z);
            let _e1805 = (_e1729.v2_.x - _e1729.v0_.x);
            let _e1808 = (_e1729.v2_.y - _e1729.v0_.y);
            let _e1811 = (_e1729.v2_.z - _e1729.v0_.z);
            let _e1815 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1799), abs(_e1802));
            let _e1816 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1796), _e1815);
            let _e1817 = (_e1796 / _e1816);
            let _e1818 = (_e1799 / _e1816);
            let _e1819 = (_e1802 / _e1816);
            let _e1823 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1808), abs(_e1811));
            let _e1824 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1805), _e1823);
            let _e1825 = (_e1805 / _e1824);
            let _e1826 = (_e1808 / _e1824);
            let _e1827 = (_e1811 / _e1824);
            let _e1830 = ((_e1818 * _e1827) - (_e1826 * _e1819));
            let _e1833 = ((_e1819 * _e1825) - (_e1827 * _e1817));
            let _e1836 = ((_e1817 * _e1826) - (_e1825 * _e1818));
            let _e1838 = p.member.eye;
            let _e1851 = (1f / sqrt((((_e1830 * _e1830) + (_e1833 * _e1833)) + (_e1836 * _e1836))));
            let _e1852 = (_e1830 * _e1851);
            let _e1853 = (_e1833 * _e1851);
            let _e1854 = (_e1836 * _e1851);
            if ((((_e1852 * (_e1838.x - _e1754)) + (_e1853 * (_e1838.y - _e1755))) + (_e1854 * (_e1838.z - _e1756))) < 0f) {
                phi_2501_ = vec3<f32>(-(_e1852), -(_e1853), -(_e1854));
            } else {
                phi_2501_ = vec3<f32>(_e1852, _e1853, _e1854);
            }
            let _e1867 = phi_2501_;
            if (_e1717.triangle < _e78) {
            } else {
                return;
            }
            let _e1872 = triangles.member[(0u + _e1717.triangle)];
            let _e1874 = (_e1872.i0_ & 2147483647u);
            if (_e1874 < _e81) {
            } else {
                return;
            }
            let _e1880 = vertices.member[(0u + _e1874)];
            if (_e1872.i1_ < _e81) {
            } else {
                return;
            }
            let _e1884 = vertices.member[(0u + _e1872.i1_)];
            if (_e1872.i2_ < _e81) {
            } else {
                return;
            }
            let _e1888 = vertices.member[(0u + _e1872.i2_)];
            let _e1889 = array<abi_Vertex, 3>(_e1880, _e1884, _e1888);
            if (_e1889[0].material < _e84) {
            } else {
                return;
            }
            let _e1895 = materials.member[(0u + _e1889[0].material)];
            let _e1912 = (1f / 255f);
            let _e1931 = (1f / 255f);
            let _e1953 = (1f / 255f);
            let _e1966 = _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(vec3<f32>(_e1723, _e1717.u, _e1717.v));
            let _e1968 = ((_e1895.base_color.x * ((((f32((_e1889[0].color & 255u)) * _e1912) * _e1723) + ((f32((_e1889[1].color & 255u)) * _e1931) * _e1717.u)) + ((f32((_e1889[2].color & 255u)) * _e1953) * _e1717.v))) * _e1966.x);
            let _e1970 = ((_e1895.base_color.y * ((((f32(((_e1889[0].color >> bitcast<u32>(8i)) & 255u)) * _e1912) * _e1723) + ((f32(((_e1889[1].color >> bitcast<u32>(8i)) & 255u)) * _e1931) * _e1717.u)) + ((f32(((_e1889[2].color >> bitcast<u32>(8i)) & 255u)) * _e1953) * _e1717.v))) * _e1966.y);
            let _e1972 = ((_e1895.base_color.z * ((((f32(((_e1889[0].color >> bitcast<u32>(16i)) & 255u)) * _e1912) * _e1723) + ((f32(((_e1889[1].color >> bitcast<u32>(16i)) & 255u)) * _e1931) * _e1717.u)) + ((f32(((_e1889[2].color >> bitcast<u32>(16i)) & 255u)) * _e1953) * _e1717.v))) * _e1966.z);
            let _e1973 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1790, _e1793);
            let _e1974 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1787, _e1973);
            if ((_e1895.flags & 2u) == 0u) {
                phi_2622_ = 0u;
            } else {
                phi_2622_ = 1u;
            }
            let _e1979 = phi_2622_;
            if (_e1889[0].normal == 2147516416u) {
                phi_2825_ = _e1867;
            } else {
                let _e1992 = (f32((bitcast<i32>((_e1889[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1998 = (f32((bitcast<i32>(_e1889[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2002 = ((1f - abs(_e1992)) - abs(_e1998));
                if (_e2002 < 0f) {
                    phi_2649_ = -(_e2002);
                } else {
                    phi_2649_ = 0f;
                }
                let _e2006 = phi_2649_;
                if (_e1992 < 0f) {
                    phi_2656_ = (_e1992 + _e2006);
                } else {
                    phi_2656_ = (_e1992 - _e2006);
                }
                let _e2011 = phi_2656_;
                if (_e1998 < 0f) {
                    phi_2663_ = (_e1998 + _e2006);
                } else {
                    phi_2663_ = (_e1998 - _e2006);
                }
                let _e2016 = phi_2663_;
                let _e2023 = (1f / sqrt((((_e2011 * _e2011) + (_e2016 * _e2016)) + (_e2002 * _e2002))));
                let _e2039 = (f32((bitcast<i32>((_e1889[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2045 = (f32((bitcast<i32>(_e1889[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2049 = ((1f - abs(_e2039)) - abs(_e2045));
                if (_e2049 < 0f) {
                    phi_2698_ = -(_e2049);
                } else {
                    phi_2698_ = 0f;
                }
                let _e2053 = phi_2698_;
                if (_e2039 < 0f) {
                    phi_2705_ = (_e2039 + _e2053);
                } else {
                    phi_2705_ = (_e2039 - _e2053);
                }
                let _e2058 = phi_2705_;
                if (_e2045 < 0f) {
                    phi_2712_ = (_e2045 + _e2053);
                } else {
                    phi_2712_ = (_e2045 - _e2053);
                }
                let _e2063 = phi_2712_;
                let _e2070 = (1f / sqrt((((_e2058 * _e2058) + (_e2063 * _e2063)) + (_e2049 * _e2049))));
                let _e2089 = (f32((bitcast<i32>((_e1889[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2095 = (f32((bitcast<i32>(_e1889[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2099 = ((1f - abs(_e2089)) - abs(_e2095));
                if (_e2099 < 0f) {
                    phi_2750_ = -(_e2099);
                } else {
                    phi_2750_ = 0f;
                }
                let _e2103 = phi_2750_;
                if (_e2089 < 0f) {
                    phi_2757_ = (_e2089 + _e2103);
                } else {
                    phi_2757_ = (_e2089 - _e2103);
                }
                let _e2108 = phi_2757_;
                if (_e2095 < 0f) {
                    phi_2764_ = (_e2095 + _e2103);
                } else {
                    phi_2764_ = (_e2095 - _e2103);
                }
                let _e2113 = phi_2764_;
                let _e2120 = (1f / sqrt((((_e2108 * _e2108) + (_e2113 * _e2113)) + (_e2099 * _e2099))));
                let _e2131 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(vec3<f32>(((((_e2011 * _e2023) * _e1723) + ((_e2058 * _e2070) * _e1717.u)) + ((_e2108 * _e2120) * _e1717.v)), ((((_e2016 * _e2023) * _e1723) + ((_e2063 * _e2070) * _e1717.u)) + ((_e2113 * _e2120) * _e1717.v)), ((((_e2002 * _e2023) * _e1723) + ((_e2049 * _e2070) * _e1717.u)) + ((_e2099 * _e2120) * _e1717.v))));
                let _e2143 = sqrt((((_e2131.x * _e2131.x) + (_e2131.y * _e2131.y)) + (_e2131.z * _e2131.z)));
                if (_e2143 > 0f) {
                    let _e2146 = (_e2131.x / _e2143);
                    let _e2148 = (_e2131.y / _e2143);
                    let _e2150 = (_e2131.z / _e2143);
                    if ((((_e2146 * _e1867.x) + (_e2148 * _e1867.y)) + (_e2150 * _e1867.z)) < 0f) {
                        phi_2823_ = vec3<f32>(-(_e2146), -(_e2148), -(_e2150));
                    } else {
                        phi_2823_ = (_e2131 / vec3(_e2143));
                    }
                    let _e2167 = phi_2823_;
                    phi_2824_ = _e2167;
                } else {
                    phi_2824_ = _e1867;
                }
                let _e2169 = phi_2824_;
                phi_2825_ = _e2169;
            }
            let _e2171 = phi_2825_;
            if (_e1968 > 0f) {
                if (_e1968 < 1f) {
                    phi_2834_ = _e1968;
                } else {
                    phi_2834_ = 1f;
                }
                let _e2175 = phi_2834_;
                phi_2835_ = _e2175;
            } else {
                phi_2835_ = 0f;
            }
            let _e2177 = phi_2835_;
            if (_e1970 > 0f) {
                if (_e1970 < 1f) {
                    phi_2845_ = _e1970;
                } else {
                    phi_2845_ = 1f;
                }
                let _e2182 = phi_2845_;
                phi_2846_ = _e2182;
            } else {
                phi_2846_ = 0f;
            }
            let _e2184 = phi_2846_;
            if (_e1972 > 0f) {
                if (_e1972 < 1f) {
                    phi_2856_ = _e1972;
                } else {
                    phi_2856_ = 1f;
                }
                let _e2189 = phi_2856_;
                phi_2857_ = _e2189;
            } else {
                phi_2857_ = 0f;
            }
            let _e2191 = phi_2857_;
            let _e2194 = ((sqrt(_e2177) * 255f) + 0.5f);
            let _e2203 = ((sqrt(_e2184) * 255f) + 0.5f);
            let _e2215 = ((sqrt(_e2191) * 255f) + 0.5f);
            phi_2892_ = abi_Sample(vec3<f32>(_e1754, _e1755, _e1756), _e1974, _e1867, _e1979, _e2171, ((select(select(u32(_e2194), 0u, (_e2194 < bitcast<f32>(0u))), 4294967295u, (_e2194 > bitcast<f32>(1333788671u))) | (select(select(u32(_e2203), 0u, (_e2203 < bitcast<f32>(0u))), 4294967295u, (_e2203 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e2215), 0u, (_e2215 < bitcast<f32>(0u))), 4294967295u, (_e2215 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_2892_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e2229 = phi_2892_;
        if (_e96.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e96.first_primitive)] = _e2229;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
