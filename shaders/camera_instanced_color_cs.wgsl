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

struct type_28 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_32 {
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

struct type_36 {
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

struct type_47 {
    member: array<lt_bvh_Instance>,
}

struct lt_bvh_traverse_Stack {
    first: array<u32, 32>,
    mask: array<u32, 32>,
    len: u32,
    group: u32,
    group_mask: u32,
}

struct type_53 {
    member: abi_CameraParams,
}

struct lt_bvh_Node {
    frame: vec4<u32>,
    links: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    z: vec4<u32>,
}

struct type_58 {
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
var<storage> vertices: type_32;
@group(0) @binding(4) 
var<storage> materials: type_36;
@group(0) @binding(0) 
var<uniform> p: type_53;
@group(0) @binding(1) 
var<storage> nodes: type_58;
@group(0) @binding(2) 
var<storage> triangles: type_28;
@group(0) @binding(5) 
var<storage, read_write> samples: type_9;
@group(0) @binding(6) 
var<storage> instances: type_47;
@group(0) @binding(7) 
var<storage> color_texels: type_13;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_216_: lt_bvh_traverse_Tree;
    var phi_217_: bool;
    var phi_218_: lt_bvh_traverse_Tree;
    var phi_219_: bool;
    var phi_224_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_216_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_217_ = false;
        } else {
            phi_216_ = lt_bvh_traverse_Tree();
            phi_217_ = true;
        }
        let _e82 = phi_216_;
        let _e84 = phi_217_;
        phi_218_ = _e82;
        phi_219_ = _e84;
    } else {
        phi_218_ = lt_bvh_traverse_Tree();
        phi_219_ = true;
    }
    let _e86 = phi_218_;
    let _e88 = phi_219_;
    if _e88 {
        phi_224_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_224_ = _e86;
    }
    let _e93 = phi_224_;
    return lt_bvh_traverse_Tree(_e93.root, _e93.first_primitive);
}

fn _lt_shaders_texture_TextureView_quad(param_3: ptr<function, texture_TextureView>, param_4: f32, param_5: f32) -> texture_TexelQuad {
    var phi_269_: f32;
    var phi_274_: f32;
    var phi_275_: bool;
    var phi_276_: f32;
    var phi_277_: bool;
    var phi_281_: f32;
    var phi_307_: f32;
    var phi_312_: f32;
    var phi_313_: bool;
    var phi_314_: f32;
    var phi_315_: bool;
    var phi_319_: f32;
    var phi_327_: f32;
    var phi_328_: f32;
    var phi_329_: f32;
    var phi_338_: f32;
    var phi_339_: f32;
    var phi_357_: u32;
    var phi_371_: u32;
    var phi_378_: u32;
    var phi_383_: u32;
    var phi_389_: u32;
    var phi_394_: u32;
    var phi_396_: texture_Axis;
    var phi_424_: f32;
    var phi_429_: f32;
    var phi_430_: bool;
    var phi_431_: f32;
    var phi_432_: bool;
    var phi_436_: f32;
    var phi_462_: f32;
    var phi_467_: f32;
    var phi_468_: bool;
    var phi_469_: f32;
    var phi_470_: bool;
    var phi_474_: f32;
    var phi_482_: f32;
    var phi_483_: f32;
    var phi_484_: f32;
    var phi_493_: f32;
    var phi_494_: f32;
    var phi_512_: u32;
    var phi_526_: u32;
    var phi_533_: u32;
    var phi_538_: u32;
    var phi_544_: u32;
    var phi_549_: u32;
    var phi_551_: texture_Axis;

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
                phi_269_ = 1f;
            } else {
                phi_269_ = 0f;
            }
            let _e103 = phi_269_;
            if (param_4 < 8388608f) {
                phi_274_ = (_e100 - _e103);
                phi_275_ = false;
            } else {
                phi_274_ = f32();
                phi_275_ = true;
            }
            let _e106 = phi_274_;
            let _e108 = phi_275_;
            phi_276_ = _e106;
            phi_277_ = _e108;
        } else {
            phi_276_ = f32();
            phi_277_ = true;
        }
        let _e110 = phi_276_;
        let _e112 = phi_277_;
        if _e112 {
            phi_281_ = param_4;
        } else {
            phi_281_ = _e110;
        }
        let _e114 = phi_281_;
        phi_329_ = (param_4 - _e114);
    } else {
        if (_e87 == 1u) {
            let _e117 = (param_4 * 0.5f);
            if (_e117 > -8388608f) {
                let _e129 = f32(select(0i, select(select(i32(_e117), i32(-2147483648), (_e117 < bitcast<f32>(3472883712u))), 2147483647i, (_e117 > bitcast<f32>(1325400063u))), (_e117 == _e117)));
                if (_e129 > _e117) {
                    phi_307_ = 1f;
                } else {
                    phi_307_ = 0f;
                }
                let _e132 = phi_307_;
                if (_e117 < 8388608f) {
                    phi_312_ = (_e129 - _e132);
                    phi_313_ = false;
                } else {
                    phi_312_ = f32();
                    phi_313_ = true;
                }
                let _e135 = phi_312_;
                let _e137 = phi_313_;
                phi_314_ = _e135;
                phi_315_ = _e137;
            } else {
                phi_314_ = f32();
                phi_315_ = true;
            }
            let _e139 = phi_314_;
            let _e141 = phi_315_;
            if _e141 {
                phi_319_ = _e117;
            } else {
                phi_319_ = _e139;
            }
            let _e143 = phi_319_;
            let _e145 = (param_4 - (2f * _e143));
            if (_e145 > 1f) {
                phi_327_ = (2f - _e145);
            } else {
                phi_327_ = _e145;
            }
            let _e149 = phi_327_;
            phi_328_ = _e149;
        } else {
            phi_328_ = param_4;
        }
        let _e151 = phi_328_;
        phi_329_ = _e151;
    }
    let _e153 = phi_329_;
    if (_e153 > 0f) {
        if (_e153 < 1f) {
            phi_338_ = _e153;
        } else {
            phi_338_ = 1f;
        }
        let _e157 = phi_338_;
        phi_339_ = _e157;
    } else {
        phi_339_ = 0f;
    }
    let _e159 = phi_339_;
    let _e160 = (_e74 - 1u);
    let _e162 = (_e159 * f32(_e74));
    if _e82 {
        let _e169 = select(select(u32(_e162), 0u, (_e162 < bitcast<f32>(0u))), 4294967295u, (_e162 > bitcast<f32>(1333788671u)));
        if (_e160 < _e169) {
            phi_357_ = _e160;
        } else {
            phi_357_ = _e169;
        }
        let _e172 = phi_357_;
        phi_396_ = texture_Axis(_e172, _e172, 0f);
    } else {
        let _e174 = (_e162 + 0.5f);
        let _e181 = select(select(u32(_e174), 0u, (_e174 < bitcast<f32>(0u))), 4294967295u, (_e174 > bitcast<f32>(1333788671u)));
        if (_e74 < _e181) {
            phi_371_ = _e74;
        } else {
            phi_371_ = _e181;
        }
        let _e184 = phi_371_;
        if (_e87 == 0u) {
            phi_378_ = _e160;
        } else {
            phi_378_ = 0u;
        }
        let _e189 = phi_378_;
        if (_e87 == 0u) {
            phi_383_ = 0u;
        } else {
            phi_383_ = _e160;
        }
        let _e192 = phi_383_;
        if (_e184 == 0u) {
            phi_389_ = _e189;
        } else {
            phi_389_ = (_e184 - 1u);
        }
        let _e196 = phi_389_;
        if (_e184 > _e160) {
            phi_394_ = _e192;
        } else {
            phi_394_ = _e184;
        }
        let _e199 = phi_394_;
        phi_396_ = texture_Axis(_e196, _e199, (_e174 - f32(_e184)));
    }
    let _e202 = phi_396_;
    let _e204 = (*param_3).flags;
    let _e207 = ((_e204 >> bitcast<u32>(6u)) & 3u);
    if (_e207 == 0u) {
        if (param_5 > -8388608f) {
            let _e220 = f32(select(0i, select(select(i32(param_5), i32(-2147483648), (param_5 < bitcast<f32>(3472883712u))), 2147483647i, (param_5 > bitcast<f32>(1325400063u))), (param_5 == param_5)));
            if (_e220 > param_5) {
                phi_424_ = 1f;
            } else {
                phi_424_ = 0f;
            }
            let _e223 = phi_424_;
            if (param_5 < 8388608f) {
                phi_429_ = (_e220 - _e223);
                phi_430_ = false;
            } else {
                phi_429_ = f32();
                phi_430_ = true;
            }
            let _e226 = phi_429_;
            let _e228 = phi_430_;
            phi_431_ = _e226;
            phi_432_ = _e228;
        } else {
            phi_431_ = f32();
            phi_432_ = true;
        }
        let _e230 = phi_431_;
        let _e232 = phi_432_;
        if _e232 {
            phi_436_ = param_5;
        } else {
            phi_436_ = _e230;
        }
        let _e234 = phi_436_;
        phi_484_ = (param_5 - _e234);
    } else {
        if (_e207 == 1u) {
            let _e237 = (param_5 * 0.5f);
            if (_e237 > -8388608f) {
                let _e249 = f32(select(0i, select(select(i32(_e237), i32(-2147483648), (_e237 < bitcast<f32>(3472883712u))), 2147483647i, (_e237 > bitcast<f32>(1325400063u))), (_e237 == _e237)));
                if (_e249 > _e237) {
                    phi_462_ = 1f;
                } else {
                    phi_462_ = 0f;
                }
                let _e252 = phi_462_;
                if (_e237 < 8388608f) {
                    phi_467_ = (_e249 - _e252);
                    phi_468_ = false;
                } else {
                    phi_467_ = f32();
                    phi_468_ = true;
                }
                let _e255 = phi_467_;
                let _e257 = phi_468_;
                phi_469_ = _e255;
                phi_470_ = _e257;
            } else {
                phi_469_ = f32();
                phi_470_ = true;
            }
            let _e259 = phi_469_;
            let _e261 = phi_470_;
            if _e261 {
                phi_474_ = _e237;
            } else {
                phi_474_ = _e259;
            }
            let _e263 = phi_474_;
            let _e265 = (param_5 - (2f * _e263));
            if (_e265 > 1f) {
                phi_482_ = (2f - _e265);
            } else {
                phi_482_ = _e265;
            }
            let _e269 = phi_482_;
            phi_483_ = _e269;
        } else {
            phi_483_ = param_5;
        }
        let _e271 = phi_483_;
        phi_484_ = _e271;
    }
    let _e273 = phi_484_;
    if (_e273 > 0f) {
        if (_e273 < 1f) {
            phi_493_ = _e273;
        } else {
            phi_493_ = 1f;
        }
        let _e277 = phi_493_;
        phi_494_ = _e277;
    } else {
        phi_494_ = 0f;
    }
    let _e279 = phi_494_;
    let _e280 = (_e78 - 1u);
    let _e282 = (_e279 * f32(_e78));
    if _e82 {
        let _e289 = select(select(u32(_e282), 0u, (_e282 < bitcast<f32>(0u))), 4294967295u, (_e282 > bitcast<f32>(1333788671u)));
        if (_e280 < _e289) {
            phi_512_ = _e280;
        } else {
            phi_512_ = _e289;
        }
        let _e292 = phi_512_;
        phi_551_ = texture_Axis(_e292, _e292, 0f);
    } else {
        let _e294 = (_e282 + 0.5f);
        let _e301 = select(select(u32(_e294), 0u, (_e294 < bitcast<f32>(0u))), 4294967295u, (_e294 > bitcast<f32>(1333788671u)));
        if (_e78 < _e301) {
            phi_526_ = _e78;
        } else {
            phi_526_ = _e301;
        }
        let _e304 = phi_526_;
        if (_e207 == 0u) {
            phi_533_ = _e280;
        } else {
            phi_533_ = 0u;
        }
        let _e309 = phi_533_;
        if (_e207 == 0u) {
            phi_538_ = 0u;
        } else {
            phi_538_ = _e280;
        }
        let _e312 = phi_538_;
        if (_e304 == 0u) {
            phi_544_ = _e309;
        } else {
            phi_544_ = (_e304 - 1u);
        }
        let _e316 = phi_544_;
        if (_e304 > _e280) {
            phi_549_ = _e312;
        } else {
            phi_549_ = _e304;
        }
        let _e319 = phi_549_;
        phi_551_ = texture_Axis(_e316, _e319, (_e294 - f32(_e304)));
    }
    let _e322 = phi_551_;
    let _e326 = (*param_3).offset;
    let _e333 = (*param_3).offset;
    let _e340 = (*param_3).offset;
    let _e347 = (*param_3).offset;
    return texture_TexelQuad(array<u32, 4>(((_e326 + (_e322.low * _e74)) + _e202.low), ((_e333 + (_e322.low * _e74)) + _e202.high), ((_e340 + (_e322.high * _e74)) + _e202.low), ((_e347 + (_e322.high * _e74)) + _e202.high)), vec4<f32>(((1f - _e202.fraction) * (1f - _e322.fraction)), (_e202.fraction * (1f - _e322.fraction)), ((1f - _e202.fraction) * _e322.fraction), (_e202.fraction * _e322.fraction)));
}

fn _lt_bvh_ray_Ray_new(param_6: vec3<f32>, param_7: vec3<f32>) -> lt_bvh_Ray {
    return lt_bvh_Ray(param_6, 0f, param_7, 300000000000000000000000000000000000000f);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_8: f32, param_9: f32) -> f32 {
    var phi_614_: bool;
    var phi_618_: f32;

    if (param_8 != param_8) {
        phi_614_ = true;
    } else {
        let _e72 = (param_9 >= param_8);
        if _e72 {
        }
        phi_614_ = _e72;
    }
    let _e74 = phi_614_;
    if _e74 {
        phi_618_ = param_9;
    } else {
        phi_618_ = param_8;
    }
    let _e76 = phi_618_;
    return _e76;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_10: f32, param_11: f32) -> f32 {
    var phi_630_: bool;
    var phi_634_: f32;

    if (param_10 != param_10) {
        phi_630_ = true;
    } else {
        let _e72 = (param_11 <= param_10);
        if _e72 {
        }
        phi_630_ = _e72;
    }
    let _e74 = phi_630_;
    if _e74 {
        phi_634_ = param_11;
    } else {
        phi_634_ = param_10;
    }
    let _e76 = phi_634_;
    return _e76;
}

fn _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(param_12: f32, param_13: f32) -> f32 {
    var phi_642_: f32;

    if (param_12 > param_13) {
        phi_642_ = param_12;
    } else {
        phi_642_ = param_13;
    }
    let _e73 = phi_642_;
    return _e73;
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var local_2: lt_bvh_traverse_Stack;
    var phi_791_: bool;
    var phi_792_: bool;
    var phi_793_: bool;
    var phi_797_: bool;
    var phi_798_: bool;
    var phi_799_: bool;
    var phi_800_: bool;
    var phi_801_: bool;
    var phi_802_: bool;
    var phi_803_: bool;
    var phi_804_: bool;
    var phi_805_: bool;
    var phi_806_: bool;
    var phi_807_: bool;
    var phi_808_: bool;
    var phi_809_: bool;
    var phi_810_: bool;
    var phi_811_: bool;
    var phi_812_: bool;
    var phi_813_: bool;
    var phi_814_: bool;
    var phi_818_: bool;
    var phi_822_: bool;
    var phi_897_: f32;
    var phi_904_: f32;
    var phi_912_: f32;
    var phi_919_: f32;
    var phi_927_: f32;
    var phi_934_: f32;
    var phi_959_: f32;
    var phi_964_: f32;
    var phi_969_: f32;
    var phi_991_: u32;
    var phi_996_: u32;
    var phi_1001_: u32;
    var phi_1115_: bool;
    var phi_1116_: bool;
    var phi_1147_: u32;
    var phi_1149_: u32;
    var phi_1152_: lt_bvh_Hit;
    var phi_1237_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1264_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1291_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1297_: u32;
    var phi_1300_: u32;
    var phi_1314_: u32;
    var phi_1324_: u32;
    var phi_1334_: u32;
    var phi_1352_: u32;
    var phi_1362_: u32;
    var phi_1372_: u32;
    var phi_1408_: u32;
    var phi_1421_: u32;
    var phi_1426_: u32;
    var phi_1427_: u32;
    var phi_1428_: u32;
    var phi_1298_: u32;
    var phi_1301_: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_1486_: u32;
    var phi_1489_: lt_bvh_Hit;
    var phi_1544_: f32;
    var phi_1549_: f32;
    var phi_1554_: f32;
    var phi_1562_: f32;
    var phi_1567_: f32;
    var phi_1572_: f32;
    var phi_1728_: bool;
    var phi_1729_: bool;
    var phi_1730_: bool;
    var phi_1734_: bool;
    var phi_1735_: bool;
    var phi_1736_: bool;
    var phi_1737_: bool;
    var phi_1738_: bool;
    var phi_1739_: bool;
    var phi_1740_: bool;
    var phi_1741_: bool;
    var phi_1742_: bool;
    var phi_1743_: bool;
    var phi_1744_: bool;
    var phi_1745_: bool;
    var phi_1746_: bool;
    var phi_1747_: bool;
    var phi_1748_: bool;
    var phi_1749_: bool;
    var phi_1750_: bool;
    var phi_1751_: bool;
    var phi_1755_: bool;
    var phi_1759_: bool;
    var phi_1829_: f32;
    var phi_1836_: f32;
    var phi_1843_: f32;
    var phi_1850_: f32;
    var phi_1857_: f32;
    var phi_1864_: f32;
    var phi_1881_: f32;
    var phi_1886_: f32;
    var phi_1891_: f32;
    var phi_1919_: bool;
    var phi_1920_: bool;
    var phi_1928_: u32;
    var phi_1929_: u32;
    var phi_1940_: vec3<f32>;
    var phi_1941_: vec3<f32>;
    var phi_1954_: u32;
    var phi_1959_: u32;
    var phi_1964_: u32;
    var phi_2078_: bool;
    var phi_2079_: bool;
    var phi_2110_: u32;
    var phi_2112_: lt_bvh_Hit;
    var phi_2115_: u32;
    var phi_2196_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2223_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2250_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2256_: u32;
    var phi_2259_: u32;
    var phi_2273_: u32;
    var phi_2283_: u32;
    var phi_2293_: u32;
    var phi_2311_: u32;
    var phi_2321_: u32;
    var phi_2331_: u32;
    var phi_2367_: u32;
    var phi_2380_: u32;
    var phi_2385_: u32;
    var phi_2386_: u32;
    var phi_2387_: u32;
    var phi_2257_: u32;
    var phi_2260_: u32;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_2445_: lt_bvh_Hit;
    var phi_2448_: u32;
    var phi_2492_: vec3<f32>;
    var phi_2493_: vec3<f32>;
    var phi_2524_: vec3<f32>;
    var phi_2525_: vec3<f32>;
    var phi_2556_: vec3<f32>;
    var phi_2557_: vec3<f32>;
    var phi_2577_: bool;
    var phi_2578_: bool;
    var phi_2582_: f32;
    var phi_2583_: f32;
    var phi_2584_: f32;
    var phi_2585_: f32;
    var phi_2593_: f32;
    var phi_2603_: bool;
    var phi_2604_: bool;
    var phi_2608_: f32;
    var phi_2609_: f32;
    var phi_2610_: f32;
    var phi_2611_: f32;
    var phi_2619_: f32;
    var phi_2629_: bool;
    var phi_2630_: bool;
    var phi_2634_: f32;
    var phi_2635_: f32;
    var phi_2636_: f32;
    var phi_2637_: f32;
    var phi_2645_: f32;
    var phi_2660_: f32;
    var phi_2661_: bool;
    var phi_2662_: f32;
    var phi_2663_: bool;
    var phi_2664_: f32;
    var phi_2665_: bool;
    var phi_2683_: f32;
    var phi_2684_: bool;
    var phi_2685_: bool;
    var phi_2686_: f32;
    var phi_2687_: bool;
    var phi_2688_: bool;
    var phi_2692_: bool;
    var phi_2693_: f32;
    var phi_2694_: bool;
    var phi_2728_: f32;
    var phi_2737_: f32;
    var phi_2746_: f32;
    var phi_2755_: f32;
    var phi_2762_: f32;
    var phi_2769_: f32;
    var phi_2782_: f32;
    var phi_2791_: f32;
    var phi_2800_: f32;
    var phi_2809_: f32;
    var phi_2816_: f32;
    var phi_2823_: f32;
    var phi_2840_: f32;
    var phi_2845_: f32;
    var phi_2850_: f32;
    var phi_2858_: f32;
    var phi_2863_: f32;
    var phi_2868_: f32;
    var phi_2880_: f32;
    var phi_2885_: f32;
    var phi_2890_: f32;
    var phi_2895_: f32;
    var phi_2900_: lt_bvh_triangle_Intersection;
    var phi_2901_: bool;
    var phi_2902_: lt_bvh_triangle_Intersection;
    var phi_2903_: bool;
    var phi_2907_: lt_bvh_triangle_Intersection;
    var phi_2908_: bool;
    var phi_2909_: lt_bvh_triangle_Intersection;
    var phi_2910_: bool;
    var phi_2911_: bool;
    var phi_2915_: bool;
    var phi_2919_: lt_bvh_triangle_Intersection;
    var phi_2957_: bool;
    var phi_2958_: bool;
    var phi_2959_: bool;
    var phi_2960_: bool;
    var phi_2961_: bool;
    var phi_2962_: bool;
    var phi_2966_: bool;
    var phi_2967_: bool;
    var phi_2981_: bool;
    var phi_2989_: lt_bvh_Hit;
    var phi_2990_: lt_bvh_Hit;
    var phi_2991_: lt_bvh_Hit;
    var phi_2992_: lt_bvh_Hit;
    var phi_2446_: lt_bvh_Hit;
    var phi_2449_: u32;
    var phi_2993_: bool;
    var phi_3032_: bool;
    var phi_3033_: bool;
    var phi_3064_: u32;
    var phi_2113_: lt_bvh_Hit;
    var phi_2116_: u32;
    var phi_3065_: lt_bvh_Hit;
    var phi_3066_: lt_bvh_Hit;
    var phi_3067_: bool;
    var phi_3071_: lt_bvh_Hit;
    var phi_3072_: lt_bvh_Hit;
    var phi_3073_: lt_bvh_Hit;
    var phi_3074_: lt_bvh_Hit;
    var phi_1487_: u32;
    var phi_1490_: lt_bvh_Hit;
    var phi_3075_: bool;
    var phi_3114_: bool;
    var phi_3115_: bool;
    var phi_3146_: u32;
    var phi_1150_: u32;
    var phi_1153_: lt_bvh_Hit;
    var phi_3147_: lt_bvh_Hit;
    var phi_3148_: lt_bvh_Hit;
    var phi_3149_: bool;
    var phi_3153_: lt_bvh_Hit;
    var phi_3340_: f32;
    var phi_3345_: f32;
    var phi_3350_: f32;
    var phi_3358_: f32;
    var phi_3363_: f32;
    var phi_3368_: f32;
    var phi_3432_: vec3<f32>;
    var phi_3675_: vec3<f32>;
    var phi_3690_: u32;
    var phi_3717_: f32;
    var phi_3724_: f32;
    var phi_3731_: f32;
    var phi_3766_: f32;
    var phi_3773_: f32;
    var phi_3780_: f32;
    var phi_3818_: f32;
    var phi_3825_: f32;
    var phi_3832_: f32;
    var phi_3918_: vec3<f32>;
    var phi_3919_: vec3<f32>;
    var phi_3920_: vec3<f32>;
    var phi_3929_: f32;
    var phi_3930_: f32;
    var phi_3940_: f32;
    var phi_3941_: f32;
    var phi_3951_: f32;
    var phi_3952_: f32;
    var phi_3987_: abi_Sample;
    var local_9: lt_bvh_Hit;
    var local_10: lt_bvh_Hit;
    var local_11: lt_bvh_Hit;
    var local_12: lt_bvh_Hit;

    let _e72 = id_1;
    let _e76 = arrayLength((&nodes.member));
    let _e79 = arrayLength((&triangles.member));
    let _e82 = arrayLength((&vertices.member));
    let _e91 = arrayLength((&instances.member));
    let _e94 = arrayLength((&color_texels.member));
    let _e97 = p.member.size[0u];
    let _e99 = p.member.size[1u];
    let _e100 = lt_shaders_entry_pixel_index(_e72, _e97, _e99);
    if (bitcast<i32>(_e100.root) != 0i) {
        let _e106 = p.member.root;
        let _e110 = p.member.eye;
        let _e115 = p.member.size[0u];
        let _e119 = ((((f32(_e72.x) + 0.5f) / f32(_e115)) * 2f) - 1f);
        let _e124 = p.member.size[1u];
        let _e128 = (1f - (((f32(_e72.y) + 0.5f) / f32(_e124)) * 2f));
        let _e130 = p.member.forward;
        let _e132 = p.member.right;
        let _e146 = p.member.up;
        let _e157 = _lt_bvh_ray_Ray_new(_e110, vec3<f32>(((_e130.x + (_e132.x * _e119)) + (_e146.x * _e128)), ((_e130.y + (_e132.y * _e119)) + (_e146.y * _e128)), ((_e130.z + (_e132.z * _e119)) + (_e146.z * _e128))));
        let _e159 = lt_bvh_Hit(_e157.tmax, 0f, 0f, 4294967295u, 4294967295u);
        let _e169 = abs(_e157.direction.x);
        let _e171 = abs(_e157.direction.y);
        let _e173 = abs(_e157.direction.z);
        if (abs(_e157.origin.x) < 1000000000000000f) {
            if (abs(_e157.origin.y) < 1000000000000000f) {
                if (abs(_e157.origin.z) < 1000000000000000f) {
                    if (_e169 < 1000000000000000f) {
                        if (_e171 < 1000000000000000f) {
                            if (_e173 < 1000000000000000f) {
                                if (_e169 > 0f) {
                                    phi_792_ = bool();
                                    phi_793_ = true;
                                } else {
                                    let _e181 = (_e171 > 0f);
                                    if _e181 {
                                        phi_791_ = bool();
                                    } else {
                                        phi_791_ = (_e173 > 0f);
                                    }
                                    let _e184 = phi_791_;
                                    phi_792_ = _e184;
                                    phi_793_ = _e181;
                                }
                                let _e186 = phi_792_;
                                let _e188 = phi_793_;
                                if _e188 {
                                    phi_797_ = true;
                                } else {
                                    phi_797_ = _e186;
                                }
                                let _e190 = phi_797_;
                                phi_798_ = _e190;
                                phi_799_ = false;
                            } else {
                                phi_798_ = bool();
                                phi_799_ = true;
                            }
                            let _e192 = phi_798_;
                            let _e194 = phi_799_;
                            phi_800_ = _e192;
                            phi_801_ = false;
                            phi_802_ = _e194;
                        } else {
                            phi_800_ = bool();
                            phi_801_ = true;
                            phi_802_ = false;
                        }
                        let _e196 = phi_800_;
                        let _e198 = phi_801_;
                        let _e200 = phi_802_;
                        phi_803_ = _e196;
                        phi_804_ = _e198;
                        phi_805_ = _e200;
                    } else {
                        phi_803_ = bool();
                        phi_804_ = true;
                        phi_805_ = false;
                    }
                    let _e202 = phi_803_;
                    let _e204 = phi_804_;
                    let _e206 = phi_805_;
                    phi_806_ = _e202;
                    phi_807_ = _e204;
                    phi_808_ = _e206;
                } else {
                    phi_806_ = bool();
                    phi_807_ = true;
                    phi_808_ = false;
                }
                let _e208 = phi_806_;
                let _e210 = phi_807_;
                let _e212 = phi_808_;
                phi_809_ = _e208;
                phi_810_ = _e210;
                phi_811_ = _e212;
            } else {
                phi_809_ = bool();
                phi_810_ = true;
                phi_811_ = false;
            }
            let _e214 = phi_809_;
            let _e216 = phi_810_;
            let _e218 = phi_811_;
            phi_812_ = _e214;
            phi_813_ = _e216;
            phi_814_ = _e218;
        } else {
            phi_812_ = bool();
            phi_813_ = true;
            phi_814_ = false;
        }
        let _e220 = phi_812_;
        let _e222 = phi_813_;
        let _e224 = phi_814_;
        if _e222 {
            phi_818_ = true;
        } else {
            phi_818_ = _e224;
        }
        let _e226 = phi_818_;
        if _e226 {
            phi_822_ = false;
        } else {
            phi_822_ = _e220;
        }
        let _e228 = phi_822_;
        if _e228 {
            let _e229 = (_e106 >= _e76);
            if _e229 {
                phi_3147_ = lt_bvh_Hit();
            } else {
                if (_e106 < _e76) {
                } else {
                    return;
                }
                let _e235 = nodes.member[(0u + _e106)].frame[0u];
                let _e239 = nodes.member[(0u + _e106)].frame[1u];
                let _e243 = nodes.member[(0u + _e106)].frame[2u];
                let _e247 = nodes.member[(0u + _e106)].frame[0u];
                let _e251 = nodes.member[(0u + _e106)].frame[1u];
                let _e255 = nodes.member[(0u + _e106)].frame[2u];
                let _e259 = nodes.member[(0u + _e106)].frame[3u];
                let _e297 = core_intrinsics_maximum_number_nsz_f32_(abs(_e157.direction.x), abs(_e157.direction.y));
                let _e298 = core_intrinsics_maximum_number_nsz_f32_(_e297, abs(_e157.direction.z));
                let _e299 = (_e298 * 0.0000000000009094947f);
                if (abs(_e157.direction.x) < _e299) {
                    phi_897_ = _e299;
                } else {
                    phi_897_ = abs(_e157.direction.x);
                }
                let _e306 = phi_897_;
                if (_e157.direction.x < 0f) {
                    phi_904_ = (-1f / _e306);
                } else {
                    phi_904_ = (1f / _e306);
                }
                let _e311 = phi_904_;
                if (abs(_e157.direction.y) < _e299) {
                    phi_912_ = _e299;
                } else {
                    phi_912_ = abs(_e157.direction.y);
                }
                let _e318 = phi_912_;
                if (_e157.direction.y < 0f) {
                    phi_919_ = (-1f / _e318);
                } else {
                    phi_919_ = (1f / _e318);
                }
                let _e323 = phi_919_;
                if (abs(_e157.direction.z) < _e299) {
                    phi_927_ = _e299;
                } else {
                    phi_927_ = abs(_e157.direction.z);
                }
                let _e330 = phi_927_;
                if (_e157.direction.z < 0f) {
                    phi_934_ = (-1f / _e330);
                } else {
                    phi_934_ = (1f / _e330);
                }
                let _e335 = phi_934_;
                let _e343 = abs((bitcast<f32>(_e235) - _e157.origin.x));
                let _e344 = abs((bitcast<f32>(_e239) - _e157.origin.y));
                let _e345 = abs((bitcast<f32>(_e243) - _e157.origin.z));
                let _e353 = abs(((bitcast<f32>(_e247) + (bitcast<f32>((((_e259 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e157.origin.x));
                let _e354 = abs(((bitcast<f32>(_e251) + (bitcast<f32>((((_e259 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e157.origin.y));
                let _e355 = abs(((bitcast<f32>(_e255) + (bitcast<f32>((((_e259 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e157.origin.z));
                if (_e343 > _e353) {
                    phi_959_ = _e343;
                } else {
                    phi_959_ = _e353;
                }
                let _e358 = phi_959_;
                if (_e344 > _e354) {
                    phi_964_ = _e344;
                } else {
                    phi_964_ = _e354;
                }
                let _e361 = phi_964_;
                if (_e345 > _e355) {
                    phi_969_ = _e345;
                } else {
                    phi_969_ = _e355;
                }
                let _e364 = phi_969_;
                let _e365 = core_intrinsics_maximum_number_nsz_f32_(_e358, _e361);
                let _e366 = core_intrinsics_maximum_number_nsz_f32_(_e365, _e364);
                let _e371 = (_e366 * 0.0000019073486f);
                let _e372 = (abs(_e311) * _e371);
                let _e373 = (abs(_e323) * _e371);
                let _e374 = (abs(_e335) * _e371);
                let _e378 = (_e366 * 0.0000009536743f);
                let _e379 = (abs(_e311) * _e378);
                let _e380 = (abs(_e323) * _e378);
                let _e381 = (abs(_e335) * _e378);
                if (_e311 < 0f) {
                    phi_991_ = 0u;
                } else {
                    phi_991_ = 1u;
                }
                let _e384 = phi_991_;
                if (_e323 < 0f) {
                    phi_996_ = 0u;
                } else {
                    phi_996_ = 2u;
                }
                let _e387 = phi_996_;
                if (_e335 < 0f) {
                    phi_1001_ = 0u;
                } else {
                    phi_1001_ = 4u;
                }
                let _e390 = phi_1001_;
                let _e392 = ((_e384 | _e387) | _e390);
                let _e393 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e106, 2147483648u);
                local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e393.first[0], _e393.first[1], _e393.first[2], _e393.first[3], _e393.first[4], _e393.first[5], _e393.first[6], _e393.first[7], _e393.first[8], _e393.first[9], _e393.first[10], _e393.first[11], _e393.first[12], _e393.first[13], _e393.first[14], _e393.first[15], _e393.first[16], _e393.first[17], _e393.first[18], _e393.first[19], _e393.first[20], _e393.first[21], _e393.first[22], _e393.first[23], _e393.first[24], _e393.first[25], _e393.first[26], _e393.first[27], _e393.first[28], _e393.first[29], _e393.first[30], _e393.first[31]), array<u32, 32>(_e393.mask[0], _e393.mask[1], _e393.mask[2], _e393.mask[3], _e393.mask[4], _e393.mask[5], _e393.mask[6], _e393.mask[7], _e393.mask[8], _e393.mask[9], _e393.mask[10], _e393.mask[11], _e393.mask[12], _e393.mask[13], _e393.mask[14], _e393.mask[15], _e393.mask[16], _e393.mask[17], _e393.mask[18], _e393.mask[19], _e393.mask[20], _e393.mask[21], _e393.mask[22], _e393.mask[23], _e393.mask[24], _e393.mask[25], _e393.mask[26], _e393.mask[27], _e393.mask[28], _e393.mask[29], _e393.mask[30], _e393.mask[31]), _e393.len, _e393.group, _e393.group_mask);
                let _e467 = local_2.group_mask;
                if ((_e467 & 4278190080u) == 0u) {
                    let _e471 = local_2.len;
                    if (_e471 == 0u) {
                        phi_1115_ = false;
                    } else {
                        let _e475 = local_2.len;
                        local_2.len = (_e475 - 1u);
                        let _e478 = local_2.len;
                        if (_e478 < 32u) {
                        } else {
                            return;
                        }
                        let _e483 = local_2.first[(0u + _e478)];
                        local_2.group = _e483;
                        let _e486 = local_2.len;
                        if (_e486 < 32u) {
                        } else {
                            return;
                        }
                        let _e491 = local_2.mask[(0u + _e486)];
                        local_2.group_mask = _e491;
                        phi_1115_ = true;
                    }
                    let _e494 = phi_1115_;
                    phi_1116_ = _e494;
                } else {
                    phi_1116_ = true;
                }
                let _e496 = phi_1116_;
                if _e496 {
                    let _e498 = local_2.group_mask;
                    let _e504 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e498)), 32u, (_e498 == 0u)));
                    let _e508 = local_2.group_mask;
                    let _e522 = local_2.group_mask;
                    local_2.group_mask = (_e522 & ~((1u << bitcast<u32>((_e504 & 31u)))));
                    let _e525 = local_2.group;
                    phi_1147_ = (_e525 + countOneBits(((_e508 & ~((4294967295u << bitcast<u32>((((_e504 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1147_ = 4294967295u;
                }
                let _e528 = phi_1147_;
                phi_1149_ = _e528;
                phi_1152_ = _e159;
                loop {
                    let _e530 = phi_1149_;
                    let _e532 = phi_1152_;
                    local_12 = _e532;
                    let _e533 = (_e530 != 4294967295u);
                    if _e533 {
                        if (_e530 < _e76) {
                        } else {
                            return;
                        }
                        let _e541 = nodes.member[(0u + _e530)].frame[3u];
                        let _e566 = (bitcast<f32>((((_e541 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e311);
                        let _e567 = (bitcast<f32>((((_e541 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e323);
                        let _e568 = (bitcast<f32>((((_e541 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e335);
                        let _e571 = nodes.member[(0u + _e530)].frame[0u];
                        let _e575 = nodes.member[(0u + _e530)].frame[1u];
                        let _e579 = nodes.member[(0u + _e530)].frame[2u];
                        let _e587 = ((bitcast<f32>(_e571) - _e157.origin.x) * _e311);
                        let _e588 = ((bitcast<f32>(_e575) - _e157.origin.y) * _e323);
                        let _e589 = ((bitcast<f32>(_e579) - _e157.origin.z) * _e335);
                        let _e597 = nodes.member[(0u + _e530)].x;
                        if (_e311 < 0f) {
                            let _e608 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e597.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e614 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e608.unnamed.root, _e597.w), _e608.unnamed_1);
                            let _e620 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e614.unnamed, lt_bvh_traverse_Tree(_e597.x, _e614.unnamed_1.first_primitive));
                            phi_1237_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e620.unnamed, lt_bvh_traverse_Tree(_e620.unnamed_1.root, _e597.y));
                        } else {
                            let _e636 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e597.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e642 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e636.unnamed.root, _e597.y), _e636.unnamed_1);
                            let _e648 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e642.unnamed, lt_bvh_traverse_Tree(_e597.z, _e642.unnamed_1.first_primitive));
                            phi_1237_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e648.unnamed, lt_bvh_traverse_Tree(_e648.unnamed_1.root, _e597.w));
                        }
                        let _e656 = phi_1237_;
                        let _e666 = nodes.member[(0u + _e530)].y;
                        if (_e323 < 0f) {
                            let _e677 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e666.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e683 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e677.unnamed.root, _e666.w), _e677.unnamed_1);
                            let _e689 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e683.unnamed, lt_bvh_traverse_Tree(_e666.x, _e683.unnamed_1.first_primitive));
                            phi_1264_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e689.unnamed, lt_bvh_traverse_Tree(_e689.unnamed_1.root, _e666.y));
                        } else {
                            let _e705 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e666.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e711 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e705.unnamed.root, _e666.y), _e705.unnamed_1);
                            let _e717 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e711.unnamed, lt_bvh_traverse_Tree(_e666.z, _e711.unnamed_1.first_primitive));
                            phi_1264_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e717.unnamed, lt_bvh_traverse_Tree(_e717.unnamed_1.root, _e666.w));
                        }
                        let _e725 = phi_1264_;
                        let _e735 = nodes.member[(0u + _e530)].z;
                        if (_e335 < 0f) {
                            let _e746 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e735.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e752 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e746.unnamed.root, _e735.w), _e746.unnamed_1);
                            let _e758 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e752.unnamed, lt_bvh_traverse_Tree(_e735.x, _e752.unnamed_1.first_primitive));
                            phi_1291_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e758.unnamed, lt_bvh_traverse_Tree(_e758.unnamed_1.root, _e735.y));
                        } else {
                            let _e774 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e735.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e780 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e774.unnamed.root, _e735.y), _e774.unnamed_1);
                            let _e786 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e780.unnamed, lt_bvh_traverse_Tree(_e735.z, _e780.unnamed_1.first_primitive));
                            phi_1291_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e786.unnamed, lt_bvh_traverse_Tree(_e786.unnamed_1.root, _e735.w));
                        }
                        let _e794 = phi_1291_;
                        phi_1297_ = 0u;
                        phi_1300_ = 0u;
                        loop {
                            let _e804 = phi_1297_;
                            let _e806 = phi_1300_;
                            local_3 = _e806;
                            local_4 = _e806;
                            local_5 = _e806;
                            let _e807 = (_e804 < 8u);
                            if _e807 {
                                let _e809 = (_e804 >> bitcast<u32>(2i));
                                let _e810 = (_e804 & 3u);
                                if (_e809 == 0u) {
                                    phi_1314_ = _e656.unnamed.root;
                                } else {
                                    phi_1314_ = _e656.unnamed.first_primitive;
                                }
                                let _e813 = phi_1314_;
                                if (_e809 == 0u) {
                                    phi_1324_ = _e725.unnamed.root;
                                } else {
                                    phi_1324_ = _e725.unnamed.first_primitive;
                                }
                                let _e822 = phi_1324_;
                                if (_e809 == 0u) {
                                    phi_1334_ = _e794.unnamed.root;
                                } else {
                                    phi_1334_ = _e794.unnamed.first_primitive;
                                }
                                let _e831 = phi_1334_;
                                let _e844 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e813 >> bitcast<u32>(((_e810 * 8u) & 31u))) & 255u)) * _e566) + (_e587 - _e372)), ((f32(((_e822 >> bitcast<u32>(((_e810 * 8u) & 31u))) & 255u)) * _e567) + (_e588 - _e373)));
                                let _e845 = core_intrinsics_maximum_number_nsz_f32_(_e844, ((f32(((_e831 >> bitcast<u32>(((_e810 * 8u) & 31u))) & 255u)) * _e568) + (_e589 - _e374)));
                                if (_e809 == 0u) {
                                    phi_1352_ = _e656.unnamed_1.root;
                                } else {
                                    phi_1352_ = _e656.unnamed_1.first_primitive;
                                }
                                let _e848 = phi_1352_;
                                if (_e809 == 0u) {
                                    phi_1362_ = _e725.unnamed_1.root;
                                } else {
                                    phi_1362_ = _e725.unnamed_1.first_primitive;
                                }
                                let _e857 = phi_1362_;
                                if (_e809 == 0u) {
                                    phi_1372_ = _e794.unnamed_1.root;
                                } else {
                                    phi_1372_ = _e794.unnamed_1.first_primitive;
                                }
                                let _e866 = phi_1372_;
                                let _e879 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e848 >> bitcast<u32>(((_e810 * 8u) & 31u))) & 255u)) * _e566) + (_e587 + _e372)), ((f32(((_e857 >> bitcast<u32>(((_e810 * 8u) & 31u))) & 255u)) * _e567) + (_e588 + _e373)));
                                let _e880 = core_intrinsics_minimum_number_nsz_f32_(_e879, ((f32(((_e866 >> bitcast<u32>(((_e810 * 8u) & 31u))) & 255u)) * _e568) + (_e589 + _e374)));
                                if (_e845 <= _e880) {
                                    if (_e845 <= _e532.t) {
                                        if (_e880 >= _e157.tmin) {
                                            if (_e809 == 0u) {
                                                let _e887 = nodes.member[(0u + _e530)].links[2u];
                                                phi_1408_ = _e887;
                                            } else {
                                                let _e890 = nodes.member[(0u + _e530)].links[3u];
                                                phi_1408_ = _e890;
                                            }
                                            let _e892 = phi_1408_;
                                            let _e897 = ((_e892 >> bitcast<u32>(((_e810 * 8u) & 31u))) & 255u);
                                            let _e898 = (_e897 & 31u);
                                            if (_e898 >= 24u) {
                                                phi_1421_ = (24u + ((_e898 - 24u) ^ _e392));
                                            } else {
                                                phi_1421_ = _e898;
                                            }
                                            let _e904 = phi_1421_;
                                            phi_1426_ = (_e806 | ((_e897 >> bitcast<u32>(5i)) << bitcast<u32>((_e904 & 31u))));
                                        } else {
                                            phi_1426_ = _e806;
                                        }
                                        let _e912 = phi_1426_;
                                        phi_1427_ = _e912;
                                    } else {
                                        phi_1427_ = _e806;
                                    }
                                    let _e914 = phi_1427_;
                                    phi_1428_ = _e914;
                                } else {
                                    phi_1428_ = _e806;
                                }
                                let _e916 = phi_1428_;
                                phi_1298_ = (_e804 + 1u);
                                phi_1301_ = _e916;
                            } else {
                                phi_1298_ = u32();
                                phi_1301_ = u32();
                            }
                            let _e919 = phi_1298_;
                            let _e921 = phi_1301_;
                            continue;
                            continuing {
                                phi_1297_ = _e919;
                                phi_1300_ = _e921;
                                break if !(_e807);
                            }
                        }
                        let _e925 = nodes.member[(0u + _e530)].links[0u];
                        let _e929 = nodes.member[(0u + _e530)].frame[3u];
                        let _e933 = local_3;
                        if ((_e933 & 4278190080u) == 0u) {
                        } else {
                            let _e937 = local_2.group_mask;
                            if ((_e937 & 4278190080u) == 0u) {
                            } else {
                                let _e941 = local_2.len;
                                if (_e941 < 32u) {
                                    let _e944 = local_2.group;
                                    let _e946 = local_2.len;
                                    if (_e946 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.first[(0u + _e946)] = _e944;
                                    let _e952 = local_2.group_mask;
                                    let _e954 = local_2.len;
                                    if (_e954 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.mask[(0u + _e954)] = _e952;
                                    let _e961 = local_2.len;
                                    local_2.len = (_e961 + 1u);
                                }
                            }
                            local_2.group = (_e106 + _e925);
                            let _e965 = local_4;
                            local_2.group_mask = ((_e965 & 4278190080u) | (_e929 >> bitcast<u32>(24i)));
                        }
                        let _e970 = local_5;
                        phi_1486_ = (_e970 & 16777215u);
                        phi_1489_ = _e532;
                        loop {
                            let _e973 = phi_1486_;
                            let _e975 = phi_1489_;
                            local_11 = _e975;
                            if (_e973 == 0u) {
                                phi_1487_ = u32();
                                phi_1490_ = lt_bvh_Hit();
                                phi_3075_ = false;
                            } else {
                                let _e979 = nodes.member[(0u + _e530)].links[1u];
                                let _e983 = (_e979 + select(firstTrailingBit(_e973), 32u, (_e973 == 0u)));
                                if (_e983 < _e91) {
                                } else {
                                    return;
                                }
                                let _e990 = instances.member[(0u + _e983)].low_world;
                                let _e992 = instances.member[(0u + _e983)].high_world;
                                let _e1002 = ((_e990.x - _e157.origin.x) * _e311);
                                let _e1003 = ((_e990.y - _e157.origin.y) * _e323);
                                let _e1004 = ((_e990.z - _e157.origin.z) * _e335);
                                let _e1014 = ((_e992.x - _e157.origin.x) * _e311);
                                let _e1015 = ((_e992.y - _e157.origin.y) * _e323);
                                let _e1016 = ((_e992.z - _e157.origin.z) * _e335);
                                if (_e1002 < _e1014) {
                                    phi_1544_ = _e1002;
                                } else {
                                    phi_1544_ = _e1014;
                                }
                                let _e1019 = phi_1544_;
                                if (_e1003 < _e1015) {
                                    phi_1549_ = _e1003;
                                } else {
                                    phi_1549_ = _e1015;
                                }
                                let _e1022 = phi_1549_;
                                if (_e1004 < _e1016) {
                                    phi_1554_ = _e1004;
                                } else {
                                    phi_1554_ = _e1016;
                                }
                                let _e1025 = phi_1554_;
                                if (_e1002 > _e1014) {
                                    phi_1562_ = _e1002;
                                } else {
                                    phi_1562_ = _e1014;
                                }
                                let _e1031 = phi_1562_;
                                if (_e1003 > _e1015) {
                                    phi_1567_ = _e1003;
                                } else {
                                    phi_1567_ = _e1015;
                                }
                                let _e1034 = phi_1567_;
                                if (_e1004 > _e1016) {
                                    phi_1572_ = _e1004;
                                } else {
                                    phi_1572_ = _e1016;
                                }
                                let _e1037 = phi_1572_;
                                let _e1041 = core_intrinsics_maximum_number_nsz_f32_((_e1019 - _e379), (_e1022 - _e380));
                                let _e1042 = core_intrinsics_maximum_number_nsz_f32_(_e1041, (_e1025 - _e381));
                                let _e1043 = core_intrinsics_minimum_number_nsz_f32_((_e1031 + _e379), (_e1034 + _e380));
                                let _e1044 = core_intrinsics_minimum_number_nsz_f32_(_e1043, (_e1037 + _e381));
                                if (_e1042 <= _e1044) {
                                    if (_e1042 <= _e975.t) {
                                        if (_e1044 >= _e157.tmin) {
                                            let _e1056 = instances.member[(0u + _e983)].world_to_object[0u];
                                            let _e1067 = ((((_e1056.x * _e157.origin.x) + (_e1056.y * _e157.origin.y)) + (_e1056.z * _e157.origin.z)) + (_e1056.w * 1f));
                                            let _e1069 = instances.member[(0u + _e983)].world_to_object[1u];
                                            let _e1080 = ((((_e1069.x * _e157.origin.x) + (_e1069.y * _e157.origin.y)) + (_e1069.z * _e157.origin.z)) + (_e1069.w * 1f));
                                            let _e1082 = instances.member[(0u + _e983)].world_to_object[2u];
                                            let _e1093 = ((((_e1082.x * _e157.origin.x) + (_e1082.y * _e157.origin.y)) + (_e1082.z * _e157.origin.z)) + (_e1082.w * 1f));
                                            let _e1100 = instances.member[(0u + _e983)].world_to_object[0u];
                                            let _e1111 = ((((_e1100.x * _e157.direction.x) + (_e1100.y * _e157.direction.y)) + (_e1100.z * _e157.direction.z)) + (_e1100.w * 0f));
                                            let _e1113 = instances.member[(0u + _e983)].world_to_object[1u];
                                            let _e1124 = ((((_e1113.x * _e157.direction.x) + (_e1113.y * _e157.direction.y)) + (_e1113.z * _e157.direction.z)) + (_e1113.w * 0f));
                                            let _e1126 = instances.member[(0u + _e983)].world_to_object[2u];
                                            let _e1137 = ((((_e1126.x * _e157.direction.x) + (_e1126.y * _e157.direction.y)) + (_e1126.z * _e157.direction.z)) + (_e1126.w * 0f));
                                            let _e1142 = instances.member[(0u + _e983)].root;
                                            let _e1144 = instances.member[(0u + _e983)].first_triangle;
                                            let _e1148 = abs(_e1111);
                                            let _e1149 = abs(_e1124);
                                            let _e1150 = abs(_e1137);
                                            if (abs(_e1067) < 1000000000000000f) {
                                                if (abs(_e1080) < 1000000000000000f) {
                                                    if (abs(_e1093) < 1000000000000000f) {
                                                        if (_e1148 < 1000000000000000f) {
                                                            if (_e1149 < 1000000000000000f) {
                                                                if (_e1150 < 1000000000000000f) {
                                                                    if (_e1148 > 0f) {
                                                                        phi_1729_ = bool();
                                                                        phi_1730_ = true;
                                                                    } else {
                                                                        let _e1158 = (_e1149 > 0f);
                                                                        if _e1158 {
                                                                            phi_1728_ = bool();
                                                                        } else {
                                                                            phi_1728_ = (_e1150 > 0f);
                                                                        }
                                                                        let _e1161 = phi_1728_;
                                                                        phi_1729_ = _e1161;
                                                                        phi_1730_ = _e1158;
                                                                    }
                                                                    let _e1163 = phi_1729_;
                                                                    let _e1165 = phi_1730_;
                                                                    if _e1165 {
                                                                        phi_1734_ = true;
                                                                    } else {
                                                                        phi_1734_ = _e1163;
                                                                    }
                                                                    let _e1167 = phi_1734_;
                                                                    phi_1735_ = _e1167;
                                                                    phi_1736_ = false;
                                                                } else {
                                                                    phi_1735_ = bool();
                                                                    phi_1736_ = true;
                                                                }
                                                                let _e1169 = phi_1735_;
                                                                let _e1171 = phi_1736_;
                                                                phi_1737_ = _e1169;
                                                                phi_1738_ = false;
                                                                phi_1739_ = _e1171;
                                                            } else {
                                                                phi_1737_ = bool();
                                                                phi_1738_ = true;
                                                                phi_1739_ = false;
                                                            }
                                                            let _e1173 = phi_1737_;
                                                            let _e1175 = phi_1738_;
                                                            let _e1177 = phi_1739_;
                                                            phi_1740_ = _e1173;
                                                            phi_1741_ = _e1175;
                                                            phi_1742_ = _e1177;
                                                        } else {
                                                            phi_1740_ = bool();
                                                            phi_1741_ = true;
                                                            phi_1742_ = false;
                                                        }
                                                        let _e1179 = phi_1740_;
                                                        let _e1181 = phi_1741_;
                                                        let _e1183 = phi_1742_;
                                                        phi_1743_ = _e1179;
                                                        phi_1744_ = _e1181;
                                                        phi_1745_ = _e1183;
                                                    } else {
                                                        phi_1743_ = bool();
                                                        phi_1744_ = true;
                                                        phi_1745_ = false;
                                                    }
                                                    let _e1185 = phi_1743_;
                                                    let _e1187 = phi_1744_;
                                                    let _e1189 = phi_1745_;
                                                    phi_1746_ = _e1185;
                                                    phi_1747_ = _e1187;
                                                    phi_1748_ = _e1189;
                                                } else {
                                                    phi_1746_ = bool();
                                                    phi_1747_ = true;
                                                    phi_1748_ = false;
                                                }
                                                let _e1191 = phi_1746_;
                                                let _e1193 = phi_1747_;
                                                let _e1195 = phi_1748_;
                                                phi_1749_ = _e1191;
                                                phi_1750_ = _e1193;
                                                phi_1751_ = _e1195;
                                            } else {
                                                phi_1749_ = bool();
                                                phi_1750_ = true;
                                                phi_1751_ = false;
                                            }
                                            let _e1197 = phi_1749_;
                                            let _e1199 = phi_1750_;
                                            let _e1201 = phi_1751_;
                                            if _e1199 {
                                                phi_1755_ = true;
                                            } else {
                                                phi_1755_ = _e1201;
                                            }
                                            let _e1203 = phi_1755_;
                                            if _e1203 {
                                                phi_1759_ = false;
                                            } else {
                                                phi_1759_ = _e1197;
                                            }
                                            let _e1205 = phi_1759_;
                                            if _e1205 {
                                                let _e1206 = (_e1142 >= _e76);
                                                if _e1206 {
                                                    phi_3065_ = lt_bvh_Hit();
                                                } else {
                                                    if (_e1142 < _e76) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1212 = nodes.member[(0u + _e1142)].frame[0u];
                                                    let _e1216 = nodes.member[(0u + _e1142)].frame[1u];
                                                    let _e1220 = nodes.member[(0u + _e1142)].frame[2u];
                                                    let _e1224 = nodes.member[(0u + _e1142)].frame[0u];
                                                    let _e1228 = nodes.member[(0u + _e1142)].frame[1u];
                                                    let _e1232 = nodes.member[(0u + _e1142)].frame[2u];
                                                    let _e1236 = nodes.member[(0u + _e1142)].frame[3u];
                                                    let _e1270 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1111), abs(_e1124));
                                                    let _e1271 = core_intrinsics_maximum_number_nsz_f32_(_e1270, abs(_e1137));
                                                    let _e1272 = (_e1271 * 0.0000000000009094947f);
                                                    if (abs(_e1111) < _e1272) {
                                                        phi_1829_ = _e1272;
                                                    } else {
                                                        phi_1829_ = abs(_e1111);
                                                    }
                                                    let _e1277 = phi_1829_;
                                                    if (_e1111 < 0f) {
                                                        phi_1836_ = (-1f / _e1277);
                                                    } else {
                                                        phi_1836_ = (1f / _e1277);
                                                    }
                                                    let _e1282 = phi_1836_;
                                                    if (abs(_e1124) < _e1272) {
                                                        phi_1843_ = _e1272;
                                                    } else {
                                                        phi_1843_ = abs(_e1124);
                                                    }
                                                    let _e1287 = phi_1843_;
                                                    if (_e1124 < 0f) {
                                                        phi_1850_ = (-1f / _e1287);
                                                    } else {
                                                        phi_1850_ = (1f / _e1287);
                                                    }
                                                    let _e1292 = phi_1850_;
                                                    if (abs(_e1137) < _e1272) {
                                                        phi_1857_ = _e1272;
                                                    } else {
                                                        phi_1857_ = abs(_e1137);
                                                    }
                                                    let _e1297 = phi_1857_;
                                                    if (_e1137 < 0f) {
                                                        phi_1864_ = (-1f / _e1297);
                                                    } else {
                                                        phi_1864_ = (1f / _e1297);
                                                    }
                                                    let _e1302 = phi_1864_;
                                                    let _e1306 = abs((bitcast<f32>(_e1212) - _e1067));
                                                    let _e1307 = abs((bitcast<f32>(_e1216) - _e1080));
                                                    let _e1308 = abs((bitcast<f32>(_e1220) - _e1093));
                                                    let _e1312 = abs(((bitcast<f32>(_e1224) + (bitcast<f32>((((_e1236 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1067));
                                                    let _e1313 = abs(((bitcast<f32>(_e1228) + (bitcast<f32>((((_e1236 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1080));
                                                    let _e1314 = abs(((bitcast<f32>(_e1232) + (bitcast<f32>((((_e1236 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1093));
                                                    if (_e1306 > _e1312) {
                                                        phi_1881_ = _e1306;
                                                    } else {
                                                        phi_1881_ = _e1312;
                                                    }
                                                    let _e1317 = phi_1881_;
                                                    if (_e1307 > _e1313) {
                                                        phi_1886_ = _e1307;
                                                    } else {
                                                        phi_1886_ = _e1313;
                                                    }
                                                    let _e1320 = phi_1886_;
                                                    if (_e1308 > _e1314) {
                                                        phi_1891_ = _e1308;
                                                    } else {
                                                        phi_1891_ = _e1314;
                                                    }
                                                    let _e1323 = phi_1891_;
                                                    let _e1324 = core_intrinsics_maximum_number_nsz_f32_(_e1317, _e1320);
                                                    let _e1325 = core_intrinsics_maximum_number_nsz_f32_(_e1324, _e1323);
                                                    let _e1329 = (_e1325 * 0.0000019073486f);
                                                    let _e1330 = (abs(_e1282) * _e1329);
                                                    let _e1331 = (abs(_e1292) * _e1329);
                                                    let _e1332 = (abs(_e1302) * _e1329);
                                                    let _e1336 = (_e1325 * 0.0000009536743f);
                                                    let _e1337 = (abs(_e1282) * _e1336);
                                                    let _e1338 = (abs(_e1292) * _e1336);
                                                    let _e1339 = (abs(_e1302) * _e1336);
                                                    let _e1340 = abs(_e1111);
                                                    let _e1341 = abs(_e1124);
                                                    let _e1342 = abs(_e1137);
                                                    if (_e1340 >= _e1341) {
                                                        if (_e1340 >= _e1342) {
                                                            phi_1919_ = false;
                                                        } else {
                                                            phi_1919_ = true;
                                                        }
                                                        let _e1346 = phi_1919_;
                                                        phi_1920_ = _e1346;
                                                    } else {
                                                        phi_1920_ = true;
                                                    }
                                                    let _e1348 = phi_1920_;
                                                    if _e1348 {
                                                        if (_e1341 >= _e1342) {
                                                            phi_1928_ = 1u;
                                                        } else {
                                                            phi_1928_ = 2u;
                                                        }
                                                        let _e1351 = phi_1928_;
                                                        phi_1929_ = _e1351;
                                                    } else {
                                                        phi_1929_ = 0u;
                                                    }
                                                    let _e1353 = phi_1929_;
                                                    if (_e1353 == 0u) {
                                                        phi_1941_ = vec3<f32>(_e1124, _e1137, _e1111);
                                                    } else {
                                                        if (_e1353 == 1u) {
                                                            phi_1940_ = vec3<f32>(_e1137, _e1111, _e1124);
                                                        } else {
                                                            phi_1940_ = vec3<f32>(_e1111, _e1124, _e1137);
                                                        }
                                                        let _e1359 = phi_1940_;
                                                        phi_1941_ = _e1359;
                                                    }
                                                    let _e1361 = phi_1941_;
                                                    let _e1364 = (_e1361.x / _e1361.z);
                                                    let _e1367 = (_e1361.y / _e1361.z);
                                                    let _e1369 = (1f / _e1361.z);
                                                    if (_e1282 < 0f) {
                                                        phi_1954_ = 0u;
                                                    } else {
                                                        phi_1954_ = 1u;
                                                    }
                                                    let _e1372 = phi_1954_;
                                                    if (_e1292 < 0f) {
                                                        phi_1959_ = 0u;
                                                    } else {
                                                        phi_1959_ = 2u;
                                                    }
                                                    let _e1375 = phi_1959_;
                                                    if (_e1302 < 0f) {
                                                        phi_1964_ = 0u;
                                                    } else {
                                                        phi_1964_ = 4u;
                                                    }
                                                    let _e1378 = phi_1964_;
                                                    let _e1380 = ((_e1372 | _e1375) | _e1378);
                                                    let _e1381 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1142, 2147483648u);
                                                    local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e1381.first[0], _e1381.first[1], _e1381.first[2], _e1381.first[3], _e1381.first[4], _e1381.first[5], _e1381.first[6], _e1381.first[7], _e1381.first[8], _e1381.first[9], _e1381.first[10], _e1381.first[11], _e1381.first[12], _e1381.first[13], _e1381.first[14], _e1381.first[15], _e1381.first[16], _e1381.first[17], _e1381.first[18], _e1381.first[19], _e1381.first[20], _e1381.first[21], _e1381.first[22], _e1381.first[23], _e1381.first[24], _e1381.first[25], _e1381.first[26], _e1381.first[27], _e1381.first[28], _e1381.first[29], _e1381.first[30], _e1381.first[31]), array<u32, 32>(_e1381.mask[0], _e1381.mask[1], _e1381.mask[2], _e1381.mask[3], _e1381.mask[4], _e1381.mask[5], _e1381.mask[6], _e1381.mask[7], _e1381.mask[8], _e1381.mask[9], _e1381.mask[10], _e1381.mask[11], _e1381.mask[12], _e1381.mask[13], _e1381.mask[14], _e1381.mask[15], _e1381.mask[16], _e1381.mask[17], _e1381.mask[18], _e1381.mask[19], _e1381.mask[20], _e1381.mask[21], _e1381.mask[22], _e1381.mask[23], _e1381.mask[24], _e1381.mask[25], _e1381.mask[26], _e1381.mask[27], _e1381.mask[28], _e1381.mask[29], _e1381.mask[30], _e1381.mask[31]), _e1381.len, _e1381.group, _e1381.group_mask);
                                                    let _e1455 = local_1.group_mask;
                                                    if ((_e1455 & 4278190080u) == 0u) {
                                                        let _e1459 = local_1.len;
                                                        if (_e1459 == 0u) {
                                                            phi_2078_ = false;
                                                        } else {
                                                            let _e1463 = local_1.len;
                                                            local_1.len = (_e1463 - 1u);
                                                            let _e1466 = local_1.len;
                                                            if (_e1466 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1471 = local_1.first[(0u + _e1466)];
                                                            local_1.group = _e1471;
                                                            let _e1474 = local_1.len;
                                                            if (_e1474 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1479 = local_1.mask[(0u + _e1474)];
                                                            local_1.group_mask = _e1479;
                                                            phi_2078_ = true;
                                                        }
                                                        let _e1482 = phi_2078_;
                                                        phi_2079_ = _e1482;
                                                    } else {
                                                        phi_2079_ = true;
                                                    }
                                                    let _e1484 = phi_2079_;
                                                    if _e1484 {
                                                        let _e1486 = local_1.group_mask;
                                                        let _e1492 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1486)), 32u, (_e1486 == 0u)));
                                                        let _e1496 = local_1.group_mask;
                                                        let _e1510 = local_1.group_mask;
                                                        local_1.group_mask = (_e1510 & ~((1u << bitcast<u32>((_e1492 & 31u)))));
                                                        let _e1513 = local_1.group;
                                                        phi_2110_ = (_e1513 + countOneBits(((_e1496 & ~((4294967295u << bitcast<u32>((((_e1492 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_2110_ = 4294967295u;
                                                    }
                                                    let _e1516 = phi_2110_;
                                                    phi_2112_ = _e975;
                                                    phi_2115_ = _e1516;
                                                    loop {
                                                        let _e1518 = phi_2112_;
                                                        let _e1520 = phi_2115_;
                                                        local_10 = _e1518;
                                                        let _e1521 = (_e1520 != 4294967295u);
                                                        if _e1521 {
                                                            if (_e1520 < _e76) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1528 = nodes.member[(0u + _e1520)].frame[3u];
                                                            let _e1553 = (bitcast<f32>((((_e1528 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1282);
                                                            let _e1554 = (bitcast<f32>((((_e1528 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1292);
                                                            let _e1555 = (bitcast<f32>((((_e1528 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1302);
                                                            let _e1558 = nodes.member[(0u + _e1520)].frame[0u];
                                                            let _e1562 = nodes.member[(0u + _e1520)].frame[1u];
                                                            let _e1566 = nodes.member[(0u + _e1520)].frame[2u];
                                                            let _e1571 = ((bitcast<f32>(_e1558) - _e1067) * _e1282);
                                                            let _e1572 = ((bitcast<f32>(_e1562) - _e1080) * _e1292);
                                                            let _e1573 = ((bitcast<f32>(_e1566) - _e1093) * _e1302);
                                                            let _e1581 = nodes.member[(0u + _e1520)].x;
                                                            if (_e1282 < 0f) {
                                                                let _e1592 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1581.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1598 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1592.unnamed.root, _e1581.w), _e1592.unnamed_1);
                                                                let _e1604 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1598.unnamed, lt_bvh_traverse_Tree(_e1581.x, _e1598.unnamed_1.first_primitive));
                                                                phi_2196_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1604.unnamed, lt_bvh_traverse_Tree(_e1604.unnamed_1.root, _e1581.y));
                                                            } else {
                                                                let _e1620 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1581.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1626 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1620.unnamed.root, _e1581.y), _e1620.unnamed_1);
                                                                let _e1632 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1626.unnamed, lt_bvh_traverse_Tree(_e1581.z, _e1626.unnamed_1.first_primitive));
                                                                phi_2196_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1632.unnamed, lt_bvh_traverse_Tree(_e1632.unnamed_1.root, _e1581.w));
                                                            }
                                                            let _e1640 = phi_2196_;
                                                            let _e1650 = nodes.member[(0u + _e1520)].y;
                                                            if (_e1292 < 0f) {
                                                                let _e1661 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1650.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1667 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1661.unnamed.root, _e1650.w), _e1661.unnamed_1);
                                                                let _e1673 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1667.unnamed, lt_bvh_traverse_Tree(_e1650.x, _e1667.unnamed_1.first_primitive));
                                                                phi_2223_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1673.unnamed, lt_bvh_traverse_Tree(_e1673.unnamed_1.root, _e1650.y));
                                                            } else {
                                                                let _e1689 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1650.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1695 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1689.unnamed.root, _e1650.y), _e1689.unnamed_1);
                                                                let _e1701 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1695.unnamed, lt_bvh_traverse_Tree(_e1650.z, _e1695.unnamed_1.first_primitive));
                                                                phi_2223_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1701.unnamed, lt_bvh_traverse_Tree(_e1701.unnamed_1.root, _e1650.w));
                                                            }
                                                            let _e1709 = phi_2223_;
                                                            let _e1719 = nodes.member[(0u + _e1520)].z;
                                                            if (_e1302 < 0f) {
                                                                let _e1730 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1719.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1736 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1730.unnamed.root, _e1719.w), _e1730.unnamed_1);
                                                                let _e1742 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1736.unnamed, lt_bvh_traverse_Tree(_e1719.x, _e1736.unnamed_1.first_primitive));
                                                                phi_2250_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1742.unnamed, lt_bvh_traverse_Tree(_e1742.unnamed_1.root, _e1719.y));
                                                            } else {
                                                                let _e1758 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1719.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1764 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1758.unnamed.root, _e1719.y), _e1758.unnamed_1);
                                                                let _e1770 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1764.unnamed, lt_bvh_traverse_Tree(_e1719.z, _e1764.unnamed_1.first_primitive));
                                                                phi_2250_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1770.unnamed, lt_bvh_traverse_Tree(_e1770.unnamed_1.root, _e1719.w));
                                                            }
                                                            let _e1778 = phi_2250_;
                                                            phi_2256_ = 0u;
                                                            phi_2259_ = 0u;
                                                            loop {
                                                                let _e1788 = phi_2256_;
                                                                let _e1790 = phi_2259_;
                                                                local_6 = _e1790;
                                                                local_7 = _e1790;
                                                                local_8 = _e1790;
                                                                let _e1791 = (_e1788 < 8u);
                                                                if _e1791 {
                                                                    let _e1793 = (_e1788 >> bitcast<u32>(2i));
                                                                    let _e1794 = (_e1788 & 3u);
                                                                    if (_e1793 == 0u) {
                                                                        phi_2273_ = _e1640.unnamed.root;
                                                                    } else {
                                                                        phi_2273_ = _e1640.unnamed.first_primitive;
                                                                    }
                                                                    let _e1797 = phi_2273_;
                                                                    if (_e1793 == 0u) {
                                                                        phi_2283_ = _e1709.unnamed.root;
                                                                    } else {
                                                                        phi_2283_ = _e1709.unnamed.first_primitive;
                                                                    }
                                                                    let _e1806 = phi_2283_;
                                                                    if (_e1793 == 0u) {
                                                                        phi_2293_ = _e1778.unnamed.root;
                                                                    } else {
                                                                        phi_2293_ = _e1778.unnamed.first_primitive;
                                                                    }
                                                                    let _e1815 = phi_2293_;
                                                                    let _e1828 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1797 >> bitcast<u32>(((_e1794 * 8u) & 31u))) & 255u)) * _e1553) + (_e1571 - _e1330)), ((f32(((_e1806 >> bitcast<u32>(((_e1794 * 8u) & 31u))) & 255u)) * _e1554) + (_e1572 - _e1331)));
                                                                    let _e1829 = core_intrinsics_maximum_number_nsz_f32_(_e1828, ((f32(((_e1815 >> bitcast<u32>(((_e1794 * 8u) & 31u))) & 255u)) * _e1555) + (_e1573 - _e1332)));
                                                                    if (_e1793 == 0u) {
                                                                        phi_2311_ = _e1640.unnamed_1.root;
                                                                    } else {
                                                                        phi_2311_ = _e1640.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1832 = phi_2311_;
                                                                    if (_e1793 == 0u) {
                                                                        phi_2321_ = _e1709.unnamed_1.root;
                                                                    } else {
                                                                        phi_2321_ = _e1709.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1841 = phi_2321_;
                                                                    if (_e1793 == 0u) {
                                                                        phi_2331_ = _e1778.unnamed_1.root;
                                                                    } else {
                                                                        phi_2331_ = _e1778.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1850 = phi_2331_;
                                                                    let _e1863 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1832 >> bitcast<u32>(((_e1794 * 8u) & 31u))) & 255u)) * _e1553) + (_e1571 + _e1330)), ((f32(((_e1841 >> bitcast<u32>(((_e1794 * 8u) & 31u))) & 255u)) * _e1554) + (_e1572 + _e1331)));
                                                                    let _e1864 = core_intrinsics_minimum_number_nsz_f32_(_e1863, ((f32(((_e1850 >> bitcast<u32>(((_e1794 * 8u) & 31u))) & 255u)) * _e1555) + (_e1573 + _e1332)));
                                                                    if (_e1829 <= _e1864) {
                                                                        if (_e1829 <= _e1518.t) {
                                                                            if (_e1864 >= _e157.tmin) {
                                                                                if (_e1793 == 0u) {
                                                                                    let _e1871 = nodes.member[(0u + _e1520)].links[2u];
                                                                                    phi_2367_ = _e1871;
                                                                                } else {
                                                                                    let _e1874 = nodes.member[(0u + _e1520)].links[3u];
                                                                                    phi_2367_ = _e1874;
                                                                                }
                                                                                let _e1876 = phi_2367_;
                                                                                let _e1881 = ((_e1876 >> bitcast<u32>(((_e1794 * 8u) & 31u))) & 255u);
                                                                                let _e1882 = (_e1881 & 31u);
                                                                                if (_e1882 >= 24u) {
                                                                                    phi_2380_ = (24u + ((_e1882 - 24u) ^ _e1380));
                                                                                } else {
                                                                                    phi_2380_ = _e1882;
                                                                                }
                                                                                let _e1888 = phi_2380_;
                                                                                phi_2385_ = (_e1790 | ((_e1881 >> bitcast<u32>(5i)) << bitcast<u32>((_e1888 & 31u))));
                                                                            } else {
                                                                                phi_2385_ = _e1790;
                                                                            }
                                                                            let _e1896 = phi_2385_;
                                                                            phi_2386_ = _e1896;
                                                                        } else {
                                                                            phi_2386_ = _e1790;
                                                                        }
                                                                        let _e1898 = phi_2386_;
                                                                        phi_2387_ = _e1898;
                                                                    } else {
                                                                        phi_2387_ = _e1790;
                                                                    }
                                                                    let _e1900 = phi_2387_;
                                                                    phi_2257_ = (_e1788 + 1u);
                                                                    phi_2260_ = _e1900;
                                                                } else {
                                                                    phi_2257_ = u32();
                                                                    phi_2260_ = u32();
                                                                }
                                                                let _e1903 = phi_2257_;
                                                                let _e1905 = phi_2260_;
                                                                continue;
                                                                continuing {
                                                                    phi_2256_ = _e1903;
                                                                    phi_2259_ = _e1905;
                                                                    break if !(_e1791);
                                                                }
                                                            }
                                                            let _e1909 = nodes.member[(0u + _e1520)].links[0u];
                                                            let _e1913 = nodes.member[(0u + _e1520)].frame[3u];
                                                            let _e1917 = local_6;
                                                            if ((_e1917 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1921 = local_1.group_mask;
                                                                if ((_e1921 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1925 = local_1.len;
                                                                    if (_e1925 < 32u) {
                                                                        let _e1928 = local_1.group;
                                                                        let _e1930 = local_1.len;
                                                                        if (_e1930 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.first[(0u + _e1930)] = _e1928;
                                                                        let _e1936 = local_1.group_mask;
                                                                        let _e1938 = local_1.len;
                                                                        if (_e1938 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.mask[(0u + _e1938)] = _e1936;
                                                                        let _e1945 = local_1.len;
                                                                        local_1.len = (_e1945 + 1u);
                                                                    }
                                                                }
                                                                local_1.group = (_e1142 + _e1909);
                                                                let _e1949 = local_7;
                                                                local_1.group_mask = ((_e1949 & 4278190080u) | (_e1913 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1954 = local_8;
                                                            phi_2445_ = _e1518;
                                                            phi_2448_ = (_e1954 & 16777215u);
                                                            loop {
                                                                let _e1957 = phi_2445_;
                                                                let _e1959 = phi_2448_;
                                                                local_9 = _e1957;
                                                                if (_e1959 == 0u) {
                                                                    phi_2446_ = lt_bvh_Hit();
                                                                    phi_2449_ = u32();
                                                                    phi_2993_ = false;
                                                                } else {
                                                                    let _e1963 = nodes.member[(0u + _e1520)].links[1u];
                                                                    let _e1968 = ((_e1144 + _e1963) + select(firstTrailingBit(_e1959), 32u, (_e1959 == 0u)));
                                                                    if (_e1968 < _e79) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1975 = triangles.member[(0u + _e1968)].v0_;
                                                                    let _e1977 = (_e1975.x - _e1067);
                                                                    let _e1979 = (_e1975.y - _e1080);
                                                                    let _e1981 = (_e1975.z - _e1093);
                                                                    if (_e1353 == 0u) {
                                                                        phi_2493_ = vec3<f32>(_e1979, _e1981, _e1977);
                                                                    } else {
                                                                        if (_e1353 == 1u) {
                                                                            phi_2492_ = vec3<f32>(_e1981, _e1977, _e1979);
                                                                        } else {
                                                                            phi_2492_ = (_e1975 - vec3<f32>(_e1067, _e1080, _e1093));
                                                                        }
                                                                        let _e1989 = phi_2492_;
                                                                        phi_2493_ = _e1989;
                                                                    }
                                                                    let _e1991 = phi_2493_;
                                                                    let _e1995 = (_e1991.x - (_e1364 * _e1991.z));
                                                                    let _e1999 = (_e1991.y - (_e1367 * _e1991.z));
                                                                    let _e2003 = triangles.member[(0u + _e1968)].v1_;
                                                                    let _e2005 = (_e2003.x - _e1067);
                                                                    let _e2007 = (_e2003.y - _e1080);
                                                                    let _e2009 = (_e2003.z - _e1093);
                                                                    if (_e1353 == 0u) {
                                                                        phi_2525_ = vec3<f32>(_e2007, _e2009, _e2005);
                                                                    } else {
                                                                        if (_e1353 == 1u) {
                                                                            phi_2524_ = vec3<f32>(_e2009, _e2005, _e2007);
                                                                        } else {
                                                                            phi_2524_ = (_e2003 - vec3<f32>(_e1067, _e1080, _e1093));
                                                                        }
                                                                        let _e2017 = phi_2524_;
                                                                        phi_2525_ = _e2017;
                                                                    }
                                                                    let _e2019 = phi_2525_;
                                                                    let _e2023 = (_e2019.x - (_e1364 * _e2019.z));
                                                                    let _e2027 = (_e2019.y - (_e1367 * _e2019.z));
                                                                    let _e2031 = triangles.member[(0u + _e1968)].v2_;
                                                                    let _e2033 = (_e2031.x - _e1067);
                                                                    let _e2035 = (_e2031.y - _e1080);
                                                                    let _e2037 = (_e2031.z - _e1093);
                                                                    if (_e1353 == 0u) {
                                                                        phi_2557_ = vec3<f32>(_e2035, _e2037, _e2033);
                                                                    } else {
                                                                        if (_e1353 == 1u) {
                                                                            phi_2556_ = vec3<f32>(_e2037, _e2033, _e2035);
                                                                        } else {
                                                                            phi_2556_ = (_e2031 - vec3<f32>(_e1067, _e1080, _e1093));
                                                                        }
                                                                        let _e2045 = phi_2556_;
                                                                        phi_2557_ = _e2045;
                                                                    }
                                                                    let _e2047 = phi_2557_;
                                                                    let _e2051 = (_e2047.x - (_e1364 * _e2047.z));
                                                                    let _e2055 = (_e2047.y - (_e1367 * _e2047.z));
                                                                    if (_e2023 < _e2051) {
                                                                        phi_2578_ = true;
                                                                    } else {
                                                                        if (_e2023 == _e2051) {
                                                                            phi_2577_ = (_e2027 < _e2055);
                                                                        } else {
                                                                            phi_2577_ = false;
                                                                        }
                                                                        let _e2062 = phi_2577_;
                                                                        phi_2578_ = _e2062;
                                                                    }
                                                                    let _e2064 = phi_2578_;
                                                                    if _e2064 {
                                                                        phi_2582_ = _e2055;
                                                                        phi_2583_ = _e2051;
                                                                        phi_2584_ = _e2027;
                                                                        phi_2585_ = _e2023;
                                                                    } else {
                                                                        phi_2582_ = _e2027;
                                                                        phi_2583_ = _e2023;
                                                                        phi_2584_ = _e2055;
                                                                        phi_2585_ = _e2051;
                                                                    }
                                                                    let _e2066 = phi_2582_;
                                                                    let _e2068 = phi_2583_;
                                                                    let _e2070 = phi_2584_;
                                                                    let _e2072 = phi_2585_;
                                                                    let _e2075 = ((_e2072 * _e2066) - (_e2070 * _e2068));
                                                                    if _e2064 {
                                                                        phi_2593_ = -(_e2075);
                                                                    } else {
                                                                        phi_2593_ = _e2075;
                                                                    }
                                                                    let _e2078 = phi_2593_;
                                                                    if (_e2051 < _e1995) {
                                                                        phi_2604_ = true;
                                                                    } else {
                                                                        if (_e2051 == _e1995) {
                                                                            phi_2603_ = (_e2055 < _e1999);
                                                                        } else {
                                                                            phi_2603_ = false;
                                                                        }
                                                                        let _e2083 = phi_2603_;
                                                                        phi_2604_ = _e2083;
                                                                    }
                                                                    let _e2085 = phi_2604_;
                                                                    if _e2085 {
                                                                        phi_2608_ = _e1999;
                                                                        phi_2609_ = _e1995;
                                                                        phi_2610_ = _e2055;
                                                                        phi_2611_ = _e2051;
                                                                    } else {
                                                                        phi_2608_ = _e2055;
                                                                        phi_2609_ = _e2051;
                                                                        phi_2610_ = _e1999;
                                                                        phi_2611_ = _e1995;
                                                                    }
                                                                    let _e2087 = phi_2608_;
                                                                    let _e2089 = phi_2609_;
                                                                    let _e2091 = phi_2610_;
                                                                    let _e2093 = phi_2611_;
                                                                    let _e2096 = ((_e2093 * _e2087) - (_e2091 * _e2089));
                                                                    if _e2085 {
                                                                        phi_2619_ = -(_e2096);
                                                                    } else {
                                                                        phi_2619_ = _e2096;
                                                                    }
                                                                    let _e2099 = phi_2619_;
                                                                    if (_e1995 < _e2023) {
                                                                        phi_2630_ = true;
                                                                    } else {
                                                                        if (_e1995 == _e2023) {
                                                                            phi_2629_ = (_e1999 < _e2027);
                                                                        } else {
                                                                            phi_2629_ = false;
                                                                        }
                                                                        let _e2104 = phi_2629_;
                                                                        phi_2630_ = _e2104;
                                                                    }
                                                                    let _e2106 = phi_2630_;
                                                                    if _e2106 {
                                                                        phi_2634_ = _e2027;
                                                                        phi_2635_ = _e2023;
                                                                        phi_2636_ = _e1999;
                                                                        phi_2637_ = _e1995;
                                                                    } else {
                                                                        phi_2634_ = _e1999;
                                                                        phi_2635_ = _e1995;
                                                                        phi_2636_ = _e2027;
                                                                        phi_2637_ = _e2023;
                                                                    }
                                                                    let _e2108 = phi_2634_;
                                                                    let _e2110 = phi_2635_;
                                                                    let _e2112 = phi_2636_;
                                                                    let _e2114 = phi_2637_;
                                                                    let _e2117 = ((_e2114 * _e2108) - (_e2112 * _e2110));
                                                                    if _e2106 {
                                                                        phi_2645_ = -(_e2117);
                                                                    } else {
                                                                        phi_2645_ = _e2117;
                                                                    }
                                                                    let _e2120 = phi_2645_;
                                                                    if (_e2078 >= 0f) {
                                                                        if (_e2099 >= 0f) {
                                                                            if (_e2120 >= 0f) {
                                                                                phi_2660_ = ((_e2078 + _e2099) + _e2120);
                                                                                phi_2661_ = false;
                                                                            } else {
                                                                                phi_2660_ = f32();
                                                                                phi_2661_ = true;
                                                                            }
                                                                            let _e2127 = phi_2660_;
                                                                            let _e2129 = phi_2661_;
                                                                            phi_2662_ = _e2127;
                                                                            phi_2663_ = _e2129;
                                                                        } else {
                                                                            phi_2662_ = f32();
                                                                            phi_2663_ = true;
                                                                        }
                                                                        let _e2131 = phi_2662_;
                                                                        let _e2133 = phi_2663_;
                                                                        phi_2664_ = _e2131;
                                                                        phi_2665_ = _e2133;
                                                                    } else {
                                                                        phi_2664_ = f32();
                                                                        phi_2665_ = true;
                                                                    }
                                                                    let _e2135 = phi_2664_;
                                                                    let _e2137 = phi_2665_;
                                                                    if _e2137 {
                                                                        if (_e2078 <= 0f) {
                                                                            if (_e2099 <= 0f) {
                                                                                let _e2140 = (_e2120 <= 0f);
                                                                                if _e2140 {
                                                                                }
                                                                                phi_2683_ = ((_e2078 + _e2099) + _e2120);
                                                                                phi_2684_ = false;
                                                                                phi_2685_ = _e2140;
                                                                            } else {
                                                                                phi_2683_ = f32();
                                                                                phi_2684_ = true;
                                                                                phi_2685_ = false;
                                                                            }
                                                                            let _e2144 = phi_2683_;
                                                                            let _e2146 = phi_2684_;
                                                                            let _e2148 = phi_2685_;
                                                                            phi_2686_ = _e2144;
                                                                            phi_2687_ = _e2146;
                                                                            phi_2688_ = _e2148;
                                                                        } else {
                                                                            phi_2686_ = f32();
                                                                            phi_2687_ = true;
                                                                            phi_2688_ = false;
                                                                        }
                                                                        let _e2150 = phi_2686_;
                                                                        let _e2152 = phi_2687_;
                                                                        let _e2154 = phi_2688_;
                                                                        if _e2152 {
                                                                            phi_2692_ = false;
                                                                        } else {
                                                                            phi_2692_ = _e2154;
                                                                        }
                                                                        let _e2156 = phi_2692_;
                                                                        phi_2693_ = _e2150;
                                                                        phi_2694_ = _e2156;
                                                                    } else {
                                                                        phi_2693_ = _e2135;
                                                                        phi_2694_ = true;
                                                                    }
                                                                    let _e2158 = phi_2693_;
                                                                    let _e2160 = phi_2694_;
                                                                    if _e2160 {
                                                                        let _e2161 = (_e2158 == 0f);
                                                                        if _e2161 {
                                                                            phi_2907_ = lt_bvh_triangle_Intersection();
                                                                            phi_2908_ = false;
                                                                        } else {
                                                                            let _e2167 = ((((_e2078 * (_e1369 * _e1991.z)) + (_e2099 * (_e1369 * _e2019.z))) + (_e2120 * (_e1369 * _e2047.z))) / _e2158);
                                                                            if (_e2167 > _e157.tmin) {
                                                                                if (_e2167 < _e157.tmax) {
                                                                                    let _e2171 = triangles.member[(0u + _e1968)].v0_;
                                                                                    let _e2173 = triangles.member[(0u + _e1968)].v1_;
                                                                                    if (_e2171.x < _e2173.x) {
                                                                                        phi_2728_ = _e2171.x;
                                                                                    } else {
                                                                                        phi_2728_ = _e2173.x;
                                                                                    }
                                                                                    let _e2180 = phi_2728_;
                                                                                    if (_e2171.y < _e2173.y) {
                                                                                        phi_2737_ = _e2171.y;
                                                                                    } else {
                                                                                        phi_2737_ = _e2173.y;
                                                                                    }
                                                                                    let _e2187 = phi_2737_;
                                                                                    if (_e2171.z < _e2173.z) {
                                                                                        phi_2746_ = _e2171.z;
                                                                                    } else {
                                                                                        phi_2746_ = _e2173.z;
                                                                                    }
                                                                                    let _e2194 = phi_2746_;
                                                                                    let _e2196 = triangles.member[(0u + _e1968)].v2_;
                                                                                    if (_e2180 < _e2196.x) {
                                                                                        phi_2755_ = _e2180;
                                                                                    } else {
                                                                                        phi_2755_ = _e2196.x;
                                                                                    }
                                                                                    let _e2201 = phi_2755_;
                                                                                    if (_e2187 < _e2196.y) {
                                                                                        phi_2762_ = _e2187;
                                                                                    } else {
                                                                                        phi_2762_ = _e2196.y;
                                                                                    }
                                                                                    let _e2206 = phi_2762_;
                                                                                    if (_e2194 < _e2196.z) {
                                                                                        phi_2769_ = _e2194;
                                                                                    } else {
                                                                                        phi_2769_ = _e2196.z;
                                                                                    }
                                                                                    let _e2211 = phi_2769_;
                                                                                    let _e2213 = triangles.member[(0u + _e1968)].v0_;
                                                                                    let _e2215 = triangles.member[(0u + _e1968)].v1_;
                                                                                    if (_e2213.x > _e2215.x) {
                                                                                        phi_2782_ = _e2213.x;
                                                                                    } else {
                                                                                        phi_2782_ = _e2215.x;
                                                                                    }
                                                                                    let _e2222 = phi_2782_;
                                                                                    if (_e2213.y > _e2215.y) {
                                                                                        phi_2791_ = _e2213.y;
                                                                                    } else {
                                                                                        phi_2791_ = _e2215.y;
                                                                                    }
                                                                                    let _e2229 = phi_2791_;
                                                                                    if (_e2213.z > _e2215.z) {
                                                                                        phi_2800_ = _e2213.z;
                                                                                    } else {
                                                                                        phi_2800_ = _e2215.z;
                                                                                    }
                                                                                    let _e2236 = phi_2800_;
                                                                                    let _e2238 = triangles.member[(0u + _e1968)].v2_;
                                                                                    if (_e2222 > _e2238.x) {
                                                                                        phi_2809_ = _e2222;
                                                                                    } else {
                                                                                        phi_2809_ = _e2238.x;
                                                                                    }
                                                                                    let _e2243 = phi_2809_;
                                                                                    if (_e2229 > _e2238.y) {
                                                                                        phi_2816_ = _e2229;
                                                                                    } else {
                                                                                        phi_2816_ = _e2238.y;
                                                                                    }
                                                                                    let _e2248 = phi_2816_;
                                                                                    if (_e2236 > _e2238.z) {
                                                                                        phi_2823_ = _e2236;
                                                                                    } else {
                                                                                        phi_2823_ = _e2238.z;
                                                                                    }
                                                                                    let _e2253 = phi_2823_;
                                                                                    let _e2257 = ((_e2201 - _e1067) * _e1282);
                                                                                    let _e2258 = ((_e2206 - _e1080) * _e1292);
                                                                                    let _e2259 = ((_e2211 - _e1093) * _e1302);
                                                                                    let _e2263 = ((_e2243 - _e1067) * _e1282);
                                                                                    let _e2264 = ((_e2248 - _e1080) * _e1292);
                                                                                    let _e2265 = ((_e2253 - _e1093) * _e1302);
                                                                                    if (_e2257 < _e2263) {
                                                                                        phi_2840_ = _e2257;
                                                                                    } else {
                                                                                        phi_2840_ = _e2263;
                                                                                    }
                                                                                    let _e2268 = phi_2840_;
                                                                                    if (_e2258 < _e2264) {
                                                                                        phi_2845_ = _e2258;
                                                                                    } else {
                                                                                        phi_2845_ = _e2264;
                                                                                    }
                                                                                    let _e2271 = phi_2845_;
                                                                                    if (_e2259 < _e2265) {
                                                                                        phi_2850_ = _e2259;
                                                                                    } else {
                                                                                        phi_2850_ = _e2265;
                                                                                    }
                                                                                    let _e2274 = phi_2850_;
                                                                                    if (_e2257 > _e2263) {
                                                                                        phi_2858_ = _e2257;
                                                                                    } else {
                                                                                        phi_2858_ = _e2263;
                                                                                    }
                                                                                    let _e2280 = phi_2858_;
                                                                                    if (_e2258 > _e2264) {
                                                                                        phi_2863_ = _e2258;
                                                                                    } else {
                                                                                        phi_2863_ = _e2264;
                                                                                    }
                                                                                    let _e2283 = phi_2863_;
                                                                                    if (_e2259 > _e2265) {
                                                                                        phi_2868_ = _e2259;
                                                                                    } else {
                                                                                        phi_2868_ = _e2265;
                                                                                    }
                                                                                    let _e2286 = phi_2868_;
                                                                                    let _e2290 = core_intrinsics_maximum_number_nsz_f32_((_e2268 - _e1337), (_e2271 - _e1338));
                                                                                    let _e2291 = core_intrinsics_maximum_number_nsz_f32_(_e2290, (_e2274 - _e1339));
                                                                                    let _e2292 = core_intrinsics_minimum_number_nsz_f32_((_e2280 + _e1337), (_e2283 + _e1338));
                                                                                    let _e2293 = core_intrinsics_minimum_number_nsz_f32_(_e2292, (_e2286 + _e1339));
                                                                                    if (_e2291 > _e1042) {
                                                                                        phi_2880_ = _e2291;
                                                                                    } else {
                                                                                        phi_2880_ = _e1042;
                                                                                    }
                                                                                    let _e2296 = phi_2880_;
                                                                                    if (_e2293 < _e1044) {
                                                                                        phi_2885_ = _e2293;
                                                                                    } else {
                                                                                        phi_2885_ = _e1044;
                                                                                    }
                                                                                    let _e2299 = phi_2885_;
                                                                                    if (_e2167 < _e2296) {
                                                                                        phi_2890_ = _e2296;
                                                                                    } else {
                                                                                        phi_2890_ = _e2167;
                                                                                    }
                                                                                    let _e2302 = phi_2890_;
                                                                                    if (_e2302 > _e2299) {
                                                                                        phi_2895_ = _e2299;
                                                                                    } else {
                                                                                        phi_2895_ = _e2302;
                                                                                    }
                                                                                    let _e2305 = phi_2895_;
                                                                                    phi_2900_ = lt_bvh_triangle_Intersection(_e2305, (_e2099 / _e2158), (_e2120 / _e2158), (_e2296 <= _e2299));
                                                                                    phi_2901_ = false;
                                                                                } else {
                                                                                    phi_2900_ = lt_bvh_triangle_Intersection();
                                                                                    phi_2901_ = true;
                                                                                }
                                                                                let _e2311 = phi_2900_;
                                                                                let _e2313 = phi_2901_;
                                                                                phi_2902_ = _e2311;
                                                                                phi_2903_ = _e2313;
                                                                            } else {
                                                                                phi_2902_ = lt_bvh_triangle_Intersection();
                                                                                phi_2903_ = true;
                                                                            }
                                                                            let _e2315 = phi_2902_;
                                                                            let _e2317 = phi_2903_;
                                                                            if _e2317 {
                                                                            }
                                                                            phi_2907_ = _e2315;
                                                                            phi_2908_ = _e2317;
                                                                        }
                                                                        let _e2319 = phi_2907_;
                                                                        let _e2321 = phi_2908_;
                                                                        phi_2909_ = _e2319;
                                                                        phi_2910_ = _e2161;
                                                                        phi_2911_ = _e2321;
                                                                    } else {
                                                                        phi_2909_ = lt_bvh_triangle_Intersection();
                                                                        phi_2910_ = true;
                                                                        phi_2911_ = false;
                                                                    }
                                                                    let _e2323 = phi_2909_;
                                                                    let _e2325 = phi_2910_;
                                                                    let _e2327 = phi_2911_;
                                                                    if _e2325 {
                                                                        phi_2915_ = true;
                                                                    } else {
                                                                        phi_2915_ = _e2327;
                                                                    }
                                                                    let _e2329 = phi_2915_;
                                                                    if _e2329 {
                                                                        phi_2919_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_2919_ = _e2323;
                                                                    }
                                                                    let _e2331 = phi_2919_;
                                                                    if _e2331.is_hit {
                                                                        if (_e2331.t > _e157.tmin) {
                                                                            if (_e2331.t < _e1957.t) {
                                                                                phi_2967_ = true;
                                                                            } else {
                                                                                if (_e2331.t == _e1957.t) {
                                                                                    if (_e1957.triangle != 4294967295u) {
                                                                                        if (_e1968 < _e1957.triangle) {
                                                                                            phi_2958_ = true;
                                                                                        } else {
                                                                                            if (_e1968 == _e1957.triangle) {
                                                                                                phi_2957_ = (_e983 < _e1957.instance);
                                                                                            } else {
                                                                                                phi_2957_ = false;
                                                                                            }
                                                                                            let _e2349 = phi_2957_;
                                                                                            phi_2958_ = _e2349;
                                                                                        }
                                                                                        let _e2351 = phi_2958_;
                                                                                        phi_2959_ = _e2351;
                                                                                        phi_2960_ = false;
                                                                                    } else {
                                                                                        phi_2959_ = bool();
                                                                                        phi_2960_ = true;
                                                                                    }
                                                                                    let _e2353 = phi_2959_;
                                                                                    let _e2355 = phi_2960_;
                                                                                    phi_2961_ = _e2353;
                                                                                    phi_2962_ = _e2355;
                                                                                } else {
                                                                                    phi_2961_ = bool();
                                                                                    phi_2962_ = true;
                                                                                }
                                                                                let _e2357 = phi_2961_;
                                                                                let _e2359 = phi_2962_;
                                                                                if _e2359 {
                                                                                    phi_2966_ = false;
                                                                                } else {
                                                                                    phi_2966_ = _e2357;
                                                                                }
                                                                                let _e2361 = phi_2966_;
                                                                                phi_2967_ = _e2361;
                                                                            }
                                                                            let _e2363 = phi_2967_;
                                                                            if _e2363 {
                                                                                let _e2365 = triangles.member[(0u + _e1968)].i0_;
                                                                                if ((_e2365 & 2147483648u) == 0u) {
                                                                                    phi_2981_ = true;
                                                                                } else {
                                                                                    if true {
                                                                                    }
                                                                                    phi_2981_ = true;
                                                                                }
                                                                                let _e2369 = phi_2981_;
                                                                                if _e2369 {
                                                                                    phi_2989_ = lt_bvh_Hit(_e2331.t, _e2331.u, _e2331.v, _e1968, _e983);
                                                                                } else {
                                                                                    phi_2989_ = _e1957;
                                                                                }
                                                                                let _e2375 = phi_2989_;
                                                                                phi_2990_ = _e2375;
                                                                            } else {
                                                                                phi_2990_ = _e1957;
                                                                            }
                                                                            let _e2377 = phi_2990_;
                                                                            phi_2991_ = _e2377;
                                                                        } else {
                                                                            phi_2991_ = _e1957;
                                                                        }
                                                                        let _e2379 = phi_2991_;
                                                                        phi_2992_ = _e2379;
                                                                    } else {
                                                                        phi_2992_ = _e1957;
                                                                    }
                                                                    let _e2381 = phi_2992_;
                                                                    phi_2446_ = _e2381;
                                                                    phi_2449_ = (_e1959 & (_e1959 - 1u));
                                                                    phi_2993_ = true;
                                                                }
                                                                let _e2383 = phi_2446_;
                                                                let _e2385 = phi_2449_;
                                                                let _e2387 = phi_2993_;
                                                                continue;
                                                                continuing {
                                                                    phi_2445_ = _e2383;
                                                                    phi_2448_ = _e2385;
                                                                    break if !(_e2387);
                                                                }
                                                            }
                                                            let _e2390 = local_1.group_mask;
                                                            if ((_e2390 & 4278190080u) == 0u) {
                                                                let _e2394 = local_1.len;
                                                                if (_e2394 == 0u) {
                                                                    phi_3032_ = false;
                                                                } else {
                                                                    let _e2398 = local_1.len;
                                                                    local_1.len = (_e2398 - 1u);
                                                                    let _e2401 = local_1.len;
                                                                    if (_e2401 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2406 = local_1.first[(0u + _e2401)];
                                                                    local_1.group = _e2406;
                                                                    let _e2409 = local_1.len;
                                                                    if (_e2409 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2414 = local_1.mask[(0u + _e2409)];
                                                                    local_1.group_mask = _e2414;
                                                                    phi_3032_ = true;
                                                                }
                                                                let _e2417 = phi_3032_;
                                                                phi_3033_ = _e2417;
                                                            } else {
                                                                phi_3033_ = true;
                                                            }
                                                            let _e2419 = phi_3033_;
                                                            if _e2419 {
                                                                let _e2421 = local_1.group_mask;
                                                                let _e2427 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2421)), 32u, (_e2421 == 0u)));
                                                                let _e2431 = local_1.group_mask;
                                                                let _e2445 = local_1.group_mask;
                                                                local_1.group_mask = (_e2445 & ~((1u << bitcast<u32>((_e2427 & 31u)))));
                                                                let _e2448 = local_1.group;
                                                                phi_3064_ = (_e2448 + countOneBits(((_e2431 & ~((4294967295u << bitcast<u32>((((_e2427 - 24u) ^ _e1380) & 31u))))) & 255u)));
                                                            } else {
                                                                phi_3064_ = 4294967295u;
                                                            }
                                                            let _e2451 = phi_3064_;
                                                            let _e3575 = local_9;
                                                            phi_2113_ = _e3575;
                                                            phi_2116_ = _e2451;
                                                        } else {
                                                            phi_2113_ = lt_bvh_Hit();
                                                            phi_2116_ = u32();
                                                        }
                                                        let _e2453 = phi_2113_;
                                                        let _e2455 = phi_2116_;
                                                        continue;
                                                        continuing {
                                                            phi_2112_ = _e2453;
                                                            phi_2115_ = _e2455;
                                                            break if !(_e1521);
                                                        }
                                                    }
                                                    let _e3579 = local_10;
                                                    phi_3065_ = _e3579;
                                                }
                                                let _e2458 = phi_3065_;
                                                phi_3066_ = _e2458;
                                                phi_3067_ = _e1206;
                                            } else {
                                                phi_3066_ = lt_bvh_Hit();
                                                phi_3067_ = true;
                                            }
                                            let _e2460 = phi_3066_;
                                            let _e2462 = phi_3067_;
                                            if _e2462 {
                                                phi_3071_ = _e975;
                                            } else {
                                                phi_3071_ = _e2460;
                                            }
                                            let _e2464 = phi_3071_;
                                            phi_3072_ = _e2464;
                                        } else {
                                            phi_3072_ = _e975;
                                        }
                                        let _e2466 = phi_3072_;
                                        phi_3073_ = _e2466;
                                    } else {
                                        phi_3073_ = _e975;
                                    }
                                    let _e2468 = phi_3073_;
                                    phi_3074_ = _e2468;
                                } else {
                                    phi_3074_ = _e975;
                                }
                                let _e2470 = phi_3074_;
                                phi_1487_ = (_e973 & (_e973 - 1u));
                                phi_1490_ = _e2470;
                                phi_3075_ = true;
                            }
                            let _e2472 = phi_1487_;
                            let _e2474 = phi_1490_;
                            let _e2476 = phi_3075_;
                            continue;
                            continuing {
                                phi_1486_ = _e2472;
                                phi_1489_ = _e2474;
                                break if !(_e2476);
                            }
                        }
                        let _e2479 = local_2.group_mask;
                        if ((_e2479 & 4278190080u) == 0u) {
                            let _e2483 = local_2.len;
                            if (_e2483 == 0u) {
                                phi_3114_ = false;
                            } else {
                                let _e2487 = local_2.len;
                                local_2.len = (_e2487 - 1u);
                                let _e2490 = local_2.len;
                                if (_e2490 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2495 = local_2.first[(0u + _e2490)];
                                local_2.group = _e2495;
                                let _e2498 = local_2.len;
                                if (_e2498 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2503 = local_2.mask[(0u + _e2498)];
                                local_2.group_mask = _e2503;
                                phi_3114_ = true;
                            }
                            let _e2506 = phi_3114_;
                            phi_3115_ = _e2506;
                        } else {
                            phi_3115_ = true;
                        }
                        let _e2508 = phi_3115_;
                        if _e2508 {
                            let _e2510 = local_2.group_mask;
                            let _e2516 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2510)), 32u, (_e2510 == 0u)));
                            let _e2520 = local_2.group_mask;
                            let _e2534 = local_2.group_mask;
                            local_2.group_mask = (_e2534 & ~((1u << bitcast<u32>((_e2516 & 31u)))));
                            let _e2537 = local_2.group;
                            phi_3146_ = (_e2537 + countOneBits(((_e2520 & ~((4294967295u << bitcast<u32>((((_e2516 - 24u) ^ _e392) & 31u))))) & 255u)));
                        } else {
                            phi_3146_ = 4294967295u;
                        }
                        let _e2540 = phi_3146_;
                        phi_1150_ = _e2540;
                        let _e3595 = local_11;
                        phi_1153_ = _e3595;
                    } else {
                        phi_1150_ = u32();
                        phi_1153_ = lt_bvh_Hit();
                    }
                    let _e2542 = phi_1150_;
                    let _e2544 = phi_1153_;
                    continue;
                    continuing {
                        phi_1149_ = _e2542;
                        phi_1152_ = _e2544;
                        break if !(_e533);
                    }
                }
                let _e3598 = local_12;
                phi_3147_ = _e3598;
            }
            let _e2547 = phi_3147_;
            phi_3148_ = _e2547;
            phi_3149_ = _e229;
        } else {
            phi_3148_ = lt_bvh_Hit();
            phi_3149_ = true;
        }
        let _e2549 = phi_3148_;
        let _e2551 = phi_3149_;
        if _e2551 {
            phi_3153_ = _e159;
        } else {
            phi_3153_ = _e2549;
        }
        let _e2553 = phi_3153_;
        if (_e2553.triangle != 4294967295u) {
            let _e2559 = ((1f - _e2553.u) - _e2553.v);
            if (_e2553.triangle < _e79) {
            } else {
                return;
            }
            let _e2564 = triangles.member[(0u + _e2553.triangle)];
            if (_e2553.instance < _e91) {
            } else {
                return;
            }
            let _e2575 = instances.member[(0u + _e2553.instance)].object_to_world[0u];
            let _e2586 = ((((_e2575.x * _e2564.v0_.x) + (_e2575.y * _e2564.v0_.y)) + (_e2575.z * _e2564.v0_.z)) + (_e2575.w * 1f));
            let _e2588 = instances.member[(0u + _e2553.instance)].object_to_world[1u];
            let _e2599 = ((((_e2588.x * _e2564.v0_.x) + (_e2588.y * _e2564.v0_.y)) + (_e2588.z * _e2564.v0_.z)) + (_e2588.w * 1f));
            let _e2601 = instances.member[(0u + _e2553.instance)].object_to_world[2u];
            let _e2612 = ((((_e2601.x * _e2564.v0_.x) + (_e2601.y * _e2564.v0_.y)) + (_e2601.z * _e2564.v0_.z)) + (_e2601.w * 1f));
            let _e2619 = instances.member[(0u + _e2553.instance)].object_to_world[0u];
            let _e2630 = ((((_e2619.x * _e2564.v1_.x) + (_e2619.y * _e2564.v1_.y)) + (_e2619.z * _e2564.v1_.z)) + (_e2619.w * 1f));
            let _e2632 = instances.member[(0u + _e2553.instance)].object_to_world[1u];
            let _e2643 = ((((_e2632.x * _e2564.v1_.x) + (_e2632.y * _e2564.v1_.y)) + (_e2632.z * _e2564.v1_.z)) + (_e2632.w * 1f));
            let _e2645 = instances.member[(0u + _e2553.instance)].object_to_world[2u];
            let _e2656 = ((((_e2645.x * _e2564.v1_.x) + (_e2645.y * _e2564.v1_.y)) + (_e2645.z * _e2564.v1_.z)) + (_e2645.w * 1f));
            let _e2663 = instances.member[(0u + _e2553.instance)].object_to_world[0u];
            let _e2674 = ((((_e2663.x * _e2564.v2_.x) + (_e2663.y * _e2564.v2_.y)) + (_e2663.z * _e2564.v2_.z)) + (_e2663.w * 1f));
            let _e2676 = instances.member[(0u + _e2553.instance)].object_to_world[1u];
            let _e2687 = ((((_e2676.x * _e2564.v2_.x) + (_e2676.y * _e2564.v2_.y)) + (_e2676.z * _e2564.v2_.z)) + (_e2676.w * 1f));
            let _e2689 = instances.member[(0u + _e2553.instance)].object_to_world[2u];
            let _e2700 = ((((_e2689.x * _e2564.v2_.x) + (_e2689.y * _e2564.v2_.y)) + (_e2689.z * _e2564.v2_.z)) + (_e2689.w * 1f));
            let _e2713 = (((_e2586 * _e2559) + (_e2630 * _e2553.u)) + (_e2674 * _e2553.v));
            let _e2714 = (((_e2599 * _e2559) + (_e2643 * _e2553.u)) + (_e2687 * _e2553.v));
            let _e2715 = (((_e2612 * _e2559) + (_e2656 * _e2553.u)) + (_e2700 * _e2553.v));
            let _e2717 = abs(_e2586);
            let _e2718 = abs(_e2599);
            let _e2719 = abs(_e2612);
            let _e2720 = abs(_e2630);
            let _e2721 = abs(_e2643);
            let _e2722 = abs(_e2656);
            if (_e2717 > _e2720) {
                phi_3340_ = _e2717;
            } else {
                phi_3340_ = _e2720;
            }
            let _e2725 = phi_3340_;
            if (_e2718 > _e2721) {
                phi_3345_ = _e2718;
            } else {
                phi_3345_ = _e2721;
            }
            let _e2728 = phi_3345_;
            if (_e2719 > _e2722) {
                phi_3350_ = _e2719;
            } else {
                phi_3350_ = _e2722;
            }
            let _e2731 = phi_3350_;
            let _e2732 = abs(_e2674);
            let _e2733 = abs(_e2687);
            let _e2734 = abs(_e2700);
            if (_e2725 > _e2732) {
                phi_3358_ = _e2725;
            } else {
                phi_3358_ = _e2732;
            }
            let _e2737 = phi_3358_;
            if (_e2728 > _e2733) {
                phi_3363_ = _e2728;
            } else {
                phi_3363_ = _e2733;
            }
            let _e2740 = phi_3363_;
            if (_e2731 > _e2734) {
                phi_3368_ = _e2731;
            } else {
                phi_3368_ = _e2734;
            }
            let _e2743 = phi_3368_;
            let _e2744 = (_e2630 - _e2586);
            let _e2745 = (_e2643 - _e2599);
            let _e2746 = (_e2656 - _e2612);
            let _e2747 = (_e2674 - _e2586);
            let _e2748 = (_e2687 - _e2599);
            let _e2749 = (_e2700 - _e2612);
            let _e2753 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2745), abs(_e2746));
            let _e2754 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2744), _e2753);
            let _e2755 = (_e2744 / _e2754);
            let _e2756 = (_e2745 / _e2754);
            let _e2757 = (_e2746 / _e2754);
            let _e2761 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2748), abs(_e2749));
            let _e2762 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2747), _e2761);
            let _e2763 = (_e2747 / _e2762);
            let _e2764 = (_e2748 / _e2762);
            let _e2765 = (_e2749 / _e2762);
            let _e2768 = ((_e2756 * _e2765) - (_e2764 * _e2757));
            let _e2771 = ((_e2757 * _e2763) - (_e2765 * _e2755));
            let _e2774 = ((_e2755 * _e2764) - (_e2763 * _e2756));
            let _e2776 = p.member.eye;
            let _e2789 = (1f / sqrt((((_e2768 * _e2768) + (_e2771 * _e2771)) + (_e2774 * _e2774))));
            let _e2790 = (_e2768 * _e2789);
            let _e2791 = (_e2771 * _e2789);
            let _e2792 = (_e2774 * _e2789);
            if ((((_e2790 * (_e2776.x - _e2713)) + (_e2791 * (_e2776.y - _e2714))) + (_e2792 * (_e2776.z - _e2715))) < 0f) {
                phi_3432_ = vec3<f32>(-(_e2790), -(_e2791), -(_e2792));
            } else {
                phi_3432_ = vec3<f32>(_e2790, _e2791, _e2792);
            }
            let _e2805 = phi_3432_;
            if (_e2553.triangle < _e79) {
            } else {
                return;
            }
            let _e2810 = triangles.member[(0u + _e2553.triangle)];
            let _e2812 = (_e2810.i0_ & 2147483647u);
            if (_e2812 < _e82) {
            } else {
                return;
            }
            let _e2818 = vertices.member[(0u + _e2812)];
            if (_e2810.i1_ < _e82) {
            } else {
                return;
            }
            let _e2822 = vertices.member[(0u + _e2810.i1_)];
            if (_e2810.i2_ < _e82) {
            } else {
                return;
            }
            let _e2826 = vertices.member[(0u + _e2810.i2_)];
            let _e2827 = array<abi_Vertex, 3>(_e2818, _e2822, _e2826);
            if (_e2827[0].material < arrayLength((&materials.member))) {
            } else {
                return;
            }
            let _e2833 = materials.member[(0u + _e2827[0].material)];
            let _e2850 = (1f / 255f);
            let _e2869 = (1f / 255f);
            let _e2891 = (1f / 255f);
            if (_e2833.color_size == 0u) {
                phi_3675_ = vec3<f32>(1f, 1f, 1f);
            } else {
                local.offset = _e2833.color_offset;
                local.size = _e2833.color_size;
                local.flags = _e2833.flags;
                let _e2934 = _lt_shaders_texture_TextureView_quad((&local), (((_e2827[0].u * _e2559) + (_e2827[1].u * _e2553.u)) + (_e2827[2].u * _e2553.v)), (((_e2827[0].v * _e2559) + (_e2827[1].v * _e2553.u)) + (_e2827[2].v * _e2553.v)));
                if (_e2934.indices[0] < _e94) {
                } else {
                    return;
                }
                let _e2940 = color_texels.member[(0u + _e2934.indices[0])];
                let _e2951 = (1f / 255f);
                if (_e2934.indices[1] < _e94) {
                } else {
                    return;
                }
                let _e2965 = color_texels.member[(0u + _e2934.indices[1])];
                let _e2976 = (1f / 255f);
                if (_e2934.indices[2] < _e94) {
                } else {
                    return;
                }
                let _e2993 = color_texels.member[(0u + _e2934.indices[2])];
                let _e3004 = (1f / 255f);
                if (_e2934.indices[3] < _e94) {
                } else {
                    return;
                }
                let _e3021 = color_texels.member[(0u + _e2934.indices[3])];
                let _e3032 = (1f / 255f);
                let _e3041 = (((((f32((_e2940 & 255u)) * _e2951) * _e2934.weights.x) + ((f32((_e2965 & 255u)) * _e2976) * _e2934.weights.y)) + ((f32((_e2993 & 255u)) * _e3004) * _e2934.weights.z)) + ((f32((_e3021 & 255u)) * _e3032) * _e2934.weights.w));
                let _e3042 = (((((f32(((_e2940 >> bitcast<u32>(8i)) & 255u)) * _e2951) * _e2934.weights.x) + ((f32(((_e2965 >> bitcast<u32>(8i)) & 255u)) * _e2976) * _e2934.weights.y)) + ((f32(((_e2993 >> bitcast<u32>(8i)) & 255u)) * _e3004) * _e2934.weights.z)) + ((f32(((_e3021 >> bitcast<u32>(8i)) & 255u)) * _e3032) * _e2934.weights.w));
                let _e3043 = (((((f32(((_e2940 >> bitcast<u32>(16i)) & 255u)) * _e2951) * _e2934.weights.x) + ((f32(((_e2965 >> bitcast<u32>(16i)) & 255u)) * _e2976) * _e2934.weights.y)) + ((f32(((_e2993 >> bitcast<u32>(16i)) & 255u)) * _e3004) * _e2934.weights.z)) + ((f32(((_e3021 >> bitcast<u32>(16i)) & 255u)) * _e3032) * _e2934.weights.w));
                phi_3675_ = vec3<f32>((_e3041 * _e3041), (_e3042 * _e3042), (_e3043 * _e3043));
            }
            let _e3049 = phi_3675_;
            let _e3051 = ((_e2833.base_color.x * ((((f32((_e2827[0].color & 255u)) * _e2850) * _e2559) + ((f32((_e2827[1].color & 255u)) * _e2869) * _e2553.u)) + ((f32((_e2827[2].color & 255u)) * _e2891) * _e2553.v))) * _e3049.x);
            let _e3053 = ((_e2833.base_color.y * ((((f32(((_e2827[0].color >> bitcast<u32>(8i)) & 255u)) * _e2850) * _e2559) + ((f32(((_e2827[1].color >> bitcast<u32>(8i)) & 255u)) * _e2869) * _e2553.u)) + ((f32(((_e2827[2].color >> bitcast<u32>(8i)) & 255u)) * _e2891) * _e2553.v))) * _e3049.y);
            let _e3055 = ((_e2833.base_color.z * ((((f32(((_e2827[0].color >> bitcast<u32>(16i)) & 255u)) * _e2850) * _e2559) + ((f32(((_e2827[1].color >> bitcast<u32>(16i)) & 255u)) * _e2869) * _e2553.u)) + ((f32(((_e2827[2].color >> bitcast<u32>(16i)) & 255u)) * _e2891) * _e2553.v))) * _e3049.z);
            let _e3056 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e2740, _e2743);
            let _e3057 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e2737, _e3056);
            if ((_e2833.flags & 2u) == 0u) {
                phi_3690_ = 0u;
            } else {
                phi_3690_ = 1u;
            }
            let _e3062 = phi_3690_;
            if (_e2827[0].normal == 2147516416u) {
                phi_3920_ = _e2805;
            } else {
                let _e3075 = (f32((bitcast<i32>((_e2827[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3081 = (f32((bitcast<i32>(_e2827[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3085 = ((1f - abs(_e3075)) - abs(_e3081));
                if (_e3085 < 0f) {
                    phi_3717_ = -(_e3085);
                } else {
                    phi_3717_ = 0f;
                }
                let _e3089 = phi_3717_;
                if (_e3075 < 0f) {
                    phi_3724_ = (_e3075 + _e3089);
                } else {
                    phi_3724_ = (_e3075 - _e3089);
                }
                let _e3094 = phi_3724_;
                if (_e3081 < 0f) {
                    phi_3731_ = (_e3081 + _e3089);
                } else {
                    phi_3731_ = (_e3081 - _e3089);
                }
                let _e3099 = phi_3731_;
                let _e3106 = (1f / sqrt((((_e3094 * _e3094) + (_e3099 * _e3099)) + (_e3085 * _e3085))));
                let _e3122 = (f32((bitcast<i32>((_e2827[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3128 = (f32((bitcast<i32>(_e2827[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3132 = ((1f - abs(_e3122)) - abs(_e3128));
                if (_e3132 < 0f) {
                    phi_3766_ = -(_e3132);
                } else {
                    phi_3766_ = 0f;
                }
                let _e3136 = phi_3766_;
                if (_e3122 < 0f) {
                    phi_3773_ = (_e3122 + _e3136);
                } else {
                    phi_3773_ = (_e3122 - _e3136);
                }
                let _e3141 = phi_3773_;
                if (_e3128 < 0f) {
                    phi_3780_ = (_e3128 + _e3136);
                } else {
                    phi_3780_ = (_e3128 - _e3136);
                }
                let _e3146 = phi_3780_;
                let _e3153 = (1f / sqrt((((_e3141 * _e3141) + (_e3146 * _e3146)) + (_e3132 * _e3132))));
                let _e3172 = (f32((bitcast<i32>((_e2827[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3178 = (f32((bitcast<i32>(_e2827[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3182 = ((1f - abs(_e3172)) - abs(_e3178));
                if (_e3182 < 0f) {
                    phi_3818_ = -(_e3182);
                } else {
                    phi_3818_ = 0f;
                }
                let _e3186 = phi_3818_;
                if (_e3172 < 0f) {
                    phi_3825_ = (_e3172 + _e3186);
                } else {
                    phi_3825_ = (_e3172 - _e3186);
                }
                let _e3191 = phi_3825_;
                if (_e3178 < 0f) {
                    phi_3832_ = (_e3178 + _e3186);
                } else {
                    phi_3832_ = (_e3178 - _e3186);
                }
                let _e3196 = phi_3832_;
                let _e3203 = (1f / sqrt((((_e3191 * _e3191) + (_e3196 * _e3196)) + (_e3182 * _e3182))));
                let _e3210 = ((((_e3094 * _e3106) * _e2559) + ((_e3141 * _e3153) * _e2553.u)) + ((_e3191 * _e3203) * _e2553.v));
                let _e3211 = ((((_e3099 * _e3106) * _e2559) + ((_e3146 * _e3153) * _e2553.u)) + ((_e3196 * _e3203) * _e2553.v));
                let _e3212 = ((((_e3085 * _e3106) * _e2559) + ((_e3132 * _e3153) * _e2553.u)) + ((_e3182 * _e3203) * _e2553.v));
                if (_e2553.instance < _e91) {
                } else {
                    return;
                }
                let _e3219 = instances.member[(0u + _e2553.instance)].world_to_object[0u];
                let _e3228 = instances.member[(0u + _e2553.instance)].world_to_object[1u];
                let _e3240 = instances.member[(0u + _e2553.instance)].world_to_object[2u];
                let _e3247 = (((_e3219.x * _e3210) + (_e3228.x * _e3211)) + (_e3240.x * _e3212));
                let _e3248 = (((_e3219.y * _e3210) + (_e3228.y * _e3211)) + (_e3240.y * _e3212));
                let _e3249 = (((_e3219.z * _e3210) + (_e3228.z * _e3211)) + (_e3240.z * _e3212));
                let _e3255 = sqrt((((_e3247 * _e3247) + (_e3248 * _e3248)) + (_e3249 * _e3249)));
                if (_e3255 > 0f) {
                    let _e3257 = (_e3247 / _e3255);
                    let _e3258 = (_e3248 / _e3255);
                    let _e3259 = (_e3249 / _e3255);
                    if ((((_e3257 * _e2805.x) + (_e3258 * _e2805.y)) + (_e3259 * _e2805.z)) < 0f) {
                        phi_3918_ = vec3<f32>(-(_e3257), -(_e3258), -(_e3259));
                    } else {
                        phi_3918_ = vec3<f32>(_e3257, _e3258, _e3259);
                    }
                    let _e3275 = phi_3918_;
                    phi_3919_ = _e3275;
                } else {
                    phi_3919_ = _e2805;
                }
                let _e3277 = phi_3919_;
                phi_3920_ = _e3277;
            }
            let _e3279 = phi_3920_;
            if (_e3051 > 0f) {
                if (_e3051 < 1f) {
                    phi_3929_ = _e3051;
                } else {
                    phi_3929_ = 1f;
                }
                let _e3283 = phi_3929_;
                phi_3930_ = _e3283;
            } else {
                phi_3930_ = 0f;
            }
            let _e3285 = phi_3930_;
            if (_e3053 > 0f) {
                if (_e3053 < 1f) {
                    phi_3940_ = _e3053;
                } else {
                    phi_3940_ = 1f;
                }
                let _e3290 = phi_3940_;
                phi_3941_ = _e3290;
            } else {
                phi_3941_ = 0f;
            }
            let _e3292 = phi_3941_;
            if (_e3055 > 0f) {
                if (_e3055 < 1f) {
                    phi_3951_ = _e3055;
                } else {
                    phi_3951_ = 1f;
                }
                let _e3297 = phi_3951_;
                phi_3952_ = _e3297;
            } else {
                phi_3952_ = 0f;
            }
            let _e3299 = phi_3952_;
            let _e3302 = ((sqrt(_e3285) * 255f) + 0.5f);
            let _e3311 = ((sqrt(_e3292) * 255f) + 0.5f);
            let _e3323 = ((sqrt(_e3299) * 255f) + 0.5f);
            phi_3987_ = abi_Sample(vec3<f32>(_e2713, _e2714, _e2715), _e3057, _e2805, _e3062, _e3279, ((select(select(u32(_e3302), 0u, (_e3302 < bitcast<f32>(0u))), 4294967295u, (_e3302 > bitcast<f32>(1333788671u))) | (select(select(u32(_e3311), 0u, (_e3311 < bitcast<f32>(0u))), 4294967295u, (_e3311 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e3323), 0u, (_e3323 < bitcast<f32>(0u))), 4294967295u, (_e3323 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_3987_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e3337 = phi_3987_;
        if (_e100.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e100.first_primitive)] = _e3337;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_instanced_color_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
