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

struct type_29 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_33 {
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

struct type_37 {
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

struct type_50 {
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

struct type_56 {
    member: abi_ShadowParams,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_17;
@group(0) @binding(0) 
var<uniform> p: type_56;
@group(0) @binding(2) 
var<storage> nodes: type_50;
@group(0) @binding(3) 
var<storage> triangles: type_29;
@group(0) @binding(5) 
var<storage> list: type_13;
@group(0) @binding(6) 
var<storage, read_write> bits: type_13;
@group(0) @binding(7) 
var<storage> vertices: type_33;
@group(0) @binding(8) 
var<storage> materials: type_37;
@group(0) @binding(9) 
var<storage> alpha_texels: type_13;

fn _lt_shaders_texture_TextureView_quad(param: ptr<function, texture_TextureView>, param_1: f32, param_2: f32) -> texture_TexelQuad {
    var phi_225_: f32;
    var phi_230_: f32;
    var phi_231_: bool;
    var phi_232_: f32;
    var phi_233_: bool;
    var phi_237_: f32;
    var phi_263_: f32;
    var phi_268_: f32;
    var phi_269_: bool;
    var phi_270_: f32;
    var phi_271_: bool;
    var phi_275_: f32;
    var phi_283_: f32;
    var phi_284_: f32;
    var phi_285_: f32;
    var phi_294_: f32;
    var phi_295_: f32;
    var phi_313_: u32;
    var phi_327_: u32;
    var phi_334_: u32;
    var phi_339_: u32;
    var phi_345_: u32;
    var phi_350_: u32;
    var phi_352_: texture_Axis;
    var phi_380_: f32;
    var phi_385_: f32;
    var phi_386_: bool;
    var phi_387_: f32;
    var phi_388_: bool;
    var phi_392_: f32;
    var phi_418_: f32;
    var phi_423_: f32;
    var phi_424_: bool;
    var phi_425_: f32;
    var phi_426_: bool;
    var phi_430_: f32;
    var phi_438_: f32;
    var phi_439_: f32;
    var phi_440_: f32;
    var phi_449_: f32;
    var phi_450_: f32;
    var phi_468_: u32;
    var phi_482_: u32;
    var phi_489_: u32;
    var phi_494_: u32;
    var phi_500_: u32;
    var phi_505_: u32;
    var phi_507_: texture_Axis;

    let _e71 = (*param).size;
    let _e72 = (_e71 & 65535u);
    let _e74 = (*param).size;
    let _e76 = (_e74 >> bitcast<u32>(16i));
    let _e78 = (*param).flags;
    let _e80 = ((_e78 & 4u) != 0u);
    let _e82 = (*param).flags;
    let _e85 = ((_e82 >> bitcast<u32>(4u)) & 3u);
    if (_e85 == 0u) {
        if (param_1 > -8388608f) {
            let _e98 = f32(select(0i, select(select(i32(param_1), i32(-2147483648), (param_1 < bitcast<f32>(3472883712u))), 2147483647i, (param_1 > bitcast<f32>(1325400063u))), (param_1 == param_1)));
            if (_e98 > param_1) {
                phi_225_ = 1f;
            } else {
                phi_225_ = 0f;
            }
            let _e101 = phi_225_;
            if (param_1 < 8388608f) {
                phi_230_ = (_e98 - _e101);
                phi_231_ = false;
            } else {
                phi_230_ = f32();
                phi_231_ = true;
            }
            let _e104 = phi_230_;
            let _e106 = phi_231_;
            phi_232_ = _e104;
            phi_233_ = _e106;
        } else {
            phi_232_ = f32();
            phi_233_ = true;
        }
        let _e108 = phi_232_;
        let _e110 = phi_233_;
        if _e110 {
            phi_237_ = param_1;
        } else {
            phi_237_ = _e108;
        }
        let _e112 = phi_237_;
        phi_285_ = (param_1 - _e112);
    } else {
        if (_e85 == 1u) {
            let _e115 = (param_1 * 0.5f);
            if (_e115 > -8388608f) {
                let _e127 = f32(select(0i, select(select(i32(_e115), i32(-2147483648), (_e115 < bitcast<f32>(3472883712u))), 2147483647i, (_e115 > bitcast<f32>(1325400063u))), (_e115 == _e115)));
                if (_e127 > _e115) {
                    phi_263_ = 1f;
                } else {
                    phi_263_ = 0f;
                }
                let _e130 = phi_263_;
                if (_e115 < 8388608f) {
                    phi_268_ = (_e127 - _e130);
                    phi_269_ = false;
                } else {
                    phi_268_ = f32();
                    phi_269_ = true;
                }
                let _e133 = phi_268_;
                let _e135 = phi_269_;
                phi_270_ = _e133;
                phi_271_ = _e135;
            } else {
                phi_270_ = f32();
                phi_271_ = true;
            }
            let _e137 = phi_270_;
            let _e139 = phi_271_;
            if _e139 {
                phi_275_ = _e115;
            } else {
                phi_275_ = _e137;
            }
            let _e141 = phi_275_;
            let _e143 = (param_1 - (2f * _e141));
            if (_e143 > 1f) {
                phi_283_ = (2f - _e143);
            } else {
                phi_283_ = _e143;
            }
            let _e147 = phi_283_;
            phi_284_ = _e147;
        } else {
            phi_284_ = param_1;
        }
        let _e149 = phi_284_;
        phi_285_ = _e149;
    }
    let _e151 = phi_285_;
    if (_e151 > 0f) {
        if (_e151 < 1f) {
            phi_294_ = _e151;
        } else {
            phi_294_ = 1f;
        }
        let _e155 = phi_294_;
        phi_295_ = _e155;
    } else {
        phi_295_ = 0f;
    }
    let _e157 = phi_295_;
    let _e158 = (_e72 - 1u);
    let _e160 = (_e157 * f32(_e72));
    if _e80 {
        let _e167 = select(select(u32(_e160), 0u, (_e160 < bitcast<f32>(0u))), 4294967295u, (_e160 > bitcast<f32>(1333788671u)));
        if (_e158 < _e167) {
            phi_313_ = _e158;
        } else {
            phi_313_ = _e167;
        }
        let _e170 = phi_313_;
        phi_352_ = texture_Axis(_e170, _e170, 0f);
    } else {
        let _e172 = (_e160 + 0.5f);
        let _e179 = select(select(u32(_e172), 0u, (_e172 < bitcast<f32>(0u))), 4294967295u, (_e172 > bitcast<f32>(1333788671u)));
        if (_e72 < _e179) {
            phi_327_ = _e72;
        } else {
            phi_327_ = _e179;
        }
        let _e182 = phi_327_;
        if (_e85 == 0u) {
            phi_334_ = _e158;
        } else {
            phi_334_ = 0u;
        }
        let _e187 = phi_334_;
        if (_e85 == 0u) {
            phi_339_ = 0u;
        } else {
            phi_339_ = _e158;
        }
        let _e190 = phi_339_;
        if (_e182 == 0u) {
            phi_345_ = _e187;
        } else {
            phi_345_ = (_e182 - 1u);
        }
        let _e194 = phi_345_;
        if (_e182 > _e158) {
            phi_350_ = _e190;
        } else {
            phi_350_ = _e182;
        }
        let _e197 = phi_350_;
        phi_352_ = texture_Axis(_e194, _e197, (_e172 - f32(_e182)));
    }
    let _e200 = phi_352_;
    let _e202 = (*param).flags;
    let _e205 = ((_e202 >> bitcast<u32>(6u)) & 3u);
    if (_e205 == 0u) {
        if (param_2 > -8388608f) {
            let _e218 = f32(select(0i, select(select(i32(param_2), i32(-2147483648), (param_2 < bitcast<f32>(3472883712u))), 2147483647i, (param_2 > bitcast<f32>(1325400063u))), (param_2 == param_2)));
            if (_e218 > param_2) {
                phi_380_ = 1f;
            } else {
                phi_380_ = 0f;
            }
            let _e221 = phi_380_;
            if (param_2 < 8388608f) {
                phi_385_ = (_e218 - _e221);
                phi_386_ = false;
            } else {
                phi_385_ = f32();
                phi_386_ = true;
            }
            let _e224 = phi_385_;
            let _e226 = phi_386_;
            phi_387_ = _e224;
            phi_388_ = _e226;
        } else {
            phi_387_ = f32();
            phi_388_ = true;
        }
        let _e228 = phi_387_;
        let _e230 = phi_388_;
        if _e230 {
            phi_392_ = param_2;
        } else {
            phi_392_ = _e228;
        }
        let _e232 = phi_392_;
        phi_440_ = (param_2 - _e232);
    } else {
        if (_e205 == 1u) {
            let _e235 = (param_2 * 0.5f);
            if (_e235 > -8388608f) {
                let _e247 = f32(select(0i, select(select(i32(_e235), i32(-2147483648), (_e235 < bitcast<f32>(3472883712u))), 2147483647i, (_e235 > bitcast<f32>(1325400063u))), (_e235 == _e235)));
                if (_e247 > _e235) {
                    phi_418_ = 1f;
                } else {
                    phi_418_ = 0f;
                }
                let _e250 = phi_418_;
                if (_e235 < 8388608f) {
                    phi_423_ = (_e247 - _e250);
                    phi_424_ = false;
                } else {
                    phi_423_ = f32();
                    phi_424_ = true;
                }
                let _e253 = phi_423_;
                let _e255 = phi_424_;
                phi_425_ = _e253;
                phi_426_ = _e255;
            } else {
                phi_425_ = f32();
                phi_426_ = true;
            }
            let _e257 = phi_425_;
            let _e259 = phi_426_;
            if _e259 {
                phi_430_ = _e235;
            } else {
                phi_430_ = _e257;
            }
            let _e261 = phi_430_;
            let _e263 = (param_2 - (2f * _e261));
            if (_e263 > 1f) {
                phi_438_ = (2f - _e263);
            } else {
                phi_438_ = _e263;
            }
            let _e267 = phi_438_;
            phi_439_ = _e267;
        } else {
            phi_439_ = param_2;
        }
        let _e269 = phi_439_;
        phi_440_ = _e269;
    }
    let _e271 = phi_440_;
    if (_e271 > 0f) {
        if (_e271 < 1f) {
            phi_449_ = _e271;
        } else {
            phi_449_ = 1f;
        }
        let _e275 = phi_449_;
        phi_450_ = _e275;
    } else {
        phi_450_ = 0f;
    }
    let _e277 = phi_450_;
    let _e278 = (_e76 - 1u);
    let _e280 = (_e277 * f32(_e76));
    if _e80 {
        let _e287 = select(select(u32(_e280), 0u, (_e280 < bitcast<f32>(0u))), 4294967295u, (_e280 > bitcast<f32>(1333788671u)));
        if (_e278 < _e287) {
            phi_468_ = _e278;
        } else {
            phi_468_ = _e287;
        }
        let _e290 = phi_468_;
        phi_507_ = texture_Axis(_e290, _e290, 0f);
    } else {
        let _e292 = (_e280 + 0.5f);
        let _e299 = select(select(u32(_e292), 0u, (_e292 < bitcast<f32>(0u))), 4294967295u, (_e292 > bitcast<f32>(1333788671u)));
        if (_e76 < _e299) {
            phi_482_ = _e76;
        } else {
            phi_482_ = _e299;
        }
        let _e302 = phi_482_;
        if (_e205 == 0u) {
            phi_489_ = _e278;
        } else {
            phi_489_ = 0u;
        }
        let _e307 = phi_489_;
        if (_e205 == 0u) {
            phi_494_ = 0u;
        } else {
            phi_494_ = _e278;
        }
        let _e310 = phi_494_;
        if (_e302 == 0u) {
            phi_500_ = _e307;
        } else {
            phi_500_ = (_e302 - 1u);
        }
        let _e314 = phi_500_;
        if (_e302 > _e278) {
            phi_505_ = _e310;
        } else {
            phi_505_ = _e302;
        }
        let _e317 = phi_505_;
        phi_507_ = texture_Axis(_e314, _e317, (_e292 - f32(_e302)));
    }
    let _e320 = phi_507_;
    let _e324 = (*param).offset;
    let _e331 = (*param).offset;
    let _e338 = (*param).offset;
    let _e345 = (*param).offset;
    return texture_TexelQuad(array<u32, 4>(((_e324 + (_e320.low * _e72)) + _e200.low), ((_e331 + (_e320.low * _e72)) + _e200.high), ((_e338 + (_e320.high * _e72)) + _e200.low), ((_e345 + (_e320.high * _e72)) + _e200.high)), vec4<f32>(((1f - _e200.fraction) * (1f - _e320.fraction)), (_e200.fraction * (1f - _e320.fraction)), ((1f - _e200.fraction) * _e320.fraction), (_e200.fraction * _e320.fraction)));
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_566_: bool;
    var phi_570_: f32;

    if (param_3 != param_3) {
        phi_566_ = true;
    } else {
        let _e70 = (param_4 >= param_3);
        if _e70 {
        }
        phi_566_ = _e70;
    }
    let _e72 = phi_566_;
    if _e72 {
        phi_570_ = param_4;
    } else {
        phi_570_ = param_3;
    }
    let _e74 = phi_570_;
    return _e74;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_582_: bool;
    var phi_586_: f32;

    if (param_5 != param_5) {
        phi_582_ = true;
    } else {
        let _e70 = (param_6 <= param_5);
        if _e70 {
        }
        phi_582_ = _e70;
    }
    let _e72 = phi_582_;
    if _e72 {
        phi_586_ = param_6;
    } else {
        phi_586_ = param_5;
    }
    let _e74 = phi_586_;
    return _e74;
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var phi_678_: f32;
    var phi_733_: bool;
    var phi_734_: bool;
    var phi_735_: bool;
    var phi_739_: bool;
    var phi_740_: bool;
    var phi_741_: bool;
    var phi_742_: bool;
    var phi_743_: bool;
    var phi_744_: bool;
    var phi_745_: bool;
    var phi_746_: bool;
    var phi_747_: bool;
    var phi_748_: bool;
    var phi_749_: bool;
    var phi_750_: bool;
    var phi_751_: bool;
    var phi_752_: bool;
    var phi_753_: bool;
    var phi_754_: bool;
    var phi_755_: bool;
    var phi_756_: bool;
    var phi_760_: bool;
    var phi_764_: bool;
    var phi_834_: f32;
    var phi_841_: f32;
    var phi_848_: f32;
    var phi_855_: f32;
    var phi_862_: f32;
    var phi_869_: f32;
    var phi_886_: f32;
    var phi_891_: f32;
    var phi_896_: f32;
    var phi_924_: bool;
    var phi_925_: bool;
    var phi_933_: u32;
    var phi_934_: u32;
    var phi_945_: vec3<f32>;
    var phi_946_: vec3<f32>;
    var phi_959_: u32;
    var phi_964_: u32;
    var phi_969_: u32;
    var phi_1083_: bool;
    var phi_1084_: bool;
    var phi_1115_: u32;
    var phi_1117_: u32;
    var phi_1198_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1225_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1252_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1258_: u32;
    var phi_1261_: u32;
    var phi_1275_: u32;
    var phi_1285_: u32;
    var phi_1295_: u32;
    var phi_1313_: u32;
    var phi_1323_: u32;
    var phi_1333_: u32;
    var phi_1369_: u32;
    var phi_1382_: u32;
    var phi_1387_: u32;
    var phi_1388_: u32;
    var phi_1389_: u32;
    var phi_1259_: u32;
    var phi_1262_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_1447_: u32;
    var phi_1492_: vec3<f32>;
    var phi_1493_: vec3<f32>;
    var phi_1522_: vec3<f32>;
    var phi_1523_: vec3<f32>;
    var phi_1552_: vec3<f32>;
    var phi_1553_: vec3<f32>;
    var phi_1571_: bool;
    var phi_1572_: bool;
    var phi_1576_: f32;
    var phi_1577_: f32;
    var phi_1578_: f32;
    var phi_1579_: f32;
    var phi_1587_: f32;
    var phi_1597_: bool;
    var phi_1598_: bool;
    var phi_1602_: f32;
    var phi_1603_: f32;
    var phi_1604_: f32;
    var phi_1605_: f32;
    var phi_1613_: f32;
    var phi_1623_: bool;
    var phi_1624_: bool;
    var phi_1628_: f32;
    var phi_1629_: f32;
    var phi_1630_: f32;
    var phi_1631_: f32;
    var phi_1639_: f32;
    var phi_1654_: f32;
    var phi_1655_: bool;
    var phi_1656_: f32;
    var phi_1657_: bool;
    var phi_1658_: f32;
    var phi_1659_: bool;
    var phi_1677_: f32;
    var phi_1678_: bool;
    var phi_1679_: bool;
    var phi_1680_: f32;
    var phi_1681_: bool;
    var phi_1682_: bool;
    var phi_1686_: bool;
    var phi_1687_: f32;
    var phi_1688_: bool;
    var phi_1716_: vec3<f32>;
    var phi_1717_: vec3<f32>;
    var phi_1742_: vec3<f32>;
    var phi_1743_: vec3<f32>;
    var phi_1768_: vec3<f32>;
    var phi_1769_: vec3<f32>;
    var phi_1825_: f32;
    var phi_1834_: f32;
    var phi_1843_: f32;
    var phi_1852_: f32;
    var phi_1859_: f32;
    var phi_1866_: f32;
    var phi_1879_: f32;
    var phi_1888_: f32;
    var phi_1897_: f32;
    var phi_1906_: f32;
    var phi_1913_: f32;
    var phi_1920_: f32;
    var phi_1937_: f32;
    var phi_1942_: f32;
    var phi_1947_: f32;
    var phi_1955_: f32;
    var phi_1960_: f32;
    var phi_1965_: f32;
    var phi_1977_: f32;
    var phi_1982_: f32;
    var phi_1987_: f32;
    var phi_1992_: f32;
    var phi_1997_: lt_bvh_triangle_Intersection;
    var phi_1998_: bool;
    var phi_1999_: lt_bvh_triangle_Intersection;
    var phi_2000_: bool;
    var phi_2004_: lt_bvh_triangle_Intersection;
    var phi_2005_: bool;
    var phi_2006_: lt_bvh_triangle_Intersection;
    var phi_2007_: bool;
    var phi_2008_: bool;
    var phi_2012_: bool;
    var phi_2016_: lt_bvh_triangle_Intersection;
    var phi_2230_: f32;
    var phi_2233_: bool;
    var phi_2234_: bool;
    var phi_2238_: bool;
    var phi_2239_: bool;
    var phi_2240_: bool;
    var phi_2241_: bool;
    var phi_2242_: bool;
    var phi_2243_: bool;
    var phi_2244_: bool;
    var phi_2245_: bool;
    var phi_2246_: bool;
    var phi_2247_: bool;
    var phi_2248_: bool;
    var phi_2249_: bool;
    var phi_2253_: bool;
    var phi_2254_: bool;
    var phi_1448_: u32;
    var phi_2255_: bool;
    var phi_2256_: bool;
    var phi_2257_: bool;
    var local_5: bool;
    var phi_2299_: bool;
    var phi_2300_: bool;
    var phi_2331_: u32;
    var phi_2332_: u32;
    var phi_2333_: bool;
    var phi_2334_: bool;
    var phi_1118_: u32;
    var phi_2335_: bool;
    var phi_2336_: bool;
    var phi_2337_: bool;
    var phi_2338_: bool;
    var local_6: bool;
    var phi_2342_: bool;
    var phi_2343_: bool;
    var phi_2347_: bool;
    var phi_2351_: bool;
    var phi_2352_: bool;
    var phi_2353_: bool;
    var phi_2354_: bool;
    var phi_2358_: bool;
    var phi_2362_: f32;
    var phi_2383_: u32;
    var phi_2398_: u32;
    var phi_2403_: u32;
    var local_7: bool;
    var local_8: bool;
    var local_9: bool;
    var local_10: bool;
    var local_11: bool;

    let _e69 = id_1;
    let _e76 = arrayLength((&nodes.member));
    let _e79 = arrayLength((&triangles.member));
    let _e82 = arrayLength((&visibility.member));
    let _e85 = arrayLength((&list.member));
    let _e88 = arrayLength((&bits.member));
    let _e91 = arrayLength((&vertices.member));
    let _e97 = arrayLength((&alpha_texels.member));
    let _e101 = ((_e69.y * 2097152u) + _e69.x);
    if (3u < _e85) {
    } else {
        return;
    }
    let _e104 = list.member[3u];
    if (_e101 < _e104) {
        let _e106 = (_e101 + 4u);
        if (_e106 < _e85) {
        } else {
            return;
        }
        let _e110 = list.member[(0u + _e106)];
        if (_e110 < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e115 = p.member.light;
        let _e117 = samples.member[(0u + _e110)].position;
        let _e119 = samples.member[(0u + _e110)].normal;
        let _e121 = samples.member[(0u + _e110)].magnitude;
        let _e123 = ((8f / 8388608f) * _e121);
        let _e131 = (_e117.x + (_e119.x * _e123));
        let _e133 = (_e117.y + (_e119.y * _e123));
        let _e135 = (_e117.z + (_e119.z * _e123));
        if (_e115.w == 0f) {
            phi_678_ = 300000000000000000000000000000000000000f;
        } else {
            phi_678_ = 1f;
        }
        let _e139 = phi_678_;
        let _e147 = (_e115.x - (_e131 * _e115.w));
        let _e148 = (_e115.y - (_e133 * _e115.w));
        let _e149 = (_e115.z - (_e135 * _e115.w));
        let _e154 = abs(_e147);
        let _e155 = abs(_e148);
        let _e156 = abs(_e149);
        if (abs(_e131) < 1000000000000000f) {
            if (abs(_e133) < 1000000000000000f) {
                if (abs(_e135) < 1000000000000000f) {
                    if (_e154 < 1000000000000000f) {
                        if (_e155 < 1000000000000000f) {
                            if (_e156 < 1000000000000000f) {
                                if (_e154 > 0f) {
                                    phi_734_ = bool();
                                    phi_735_ = true;
                                } else {
                                    let _e164 = (_e155 > 0f);
                                    if _e164 {
                                        phi_733_ = bool();
                                    } else {
                                        phi_733_ = (_e156 > 0f);
                                    }
                                    let _e167 = phi_733_;
                                    phi_734_ = _e167;
                                    phi_735_ = _e164;
                                }
                                let _e169 = phi_734_;
                                let _e171 = phi_735_;
                                if _e171 {
                                    phi_739_ = true;
                                } else {
                                    phi_739_ = _e169;
                                }
                                let _e173 = phi_739_;
                                phi_740_ = _e173;
                                phi_741_ = false;
                            } else {
                                phi_740_ = bool();
                                phi_741_ = true;
                            }
                            let _e175 = phi_740_;
                            let _e177 = phi_741_;
                            phi_742_ = _e175;
                            phi_743_ = false;
                            phi_744_ = _e177;
                        } else {
                            phi_742_ = bool();
                            phi_743_ = true;
                            phi_744_ = false;
                        }
                        let _e179 = phi_742_;
                        let _e181 = phi_743_;
                        let _e183 = phi_744_;
                        phi_745_ = _e179;
                        phi_746_ = _e181;
                        phi_747_ = _e183;
                    } else {
                        phi_745_ = bool();
                        phi_746_ = true;
                        phi_747_ = false;
                    }
                    let _e185 = phi_745_;
                    let _e187 = phi_746_;
                    let _e189 = phi_747_;
                    phi_748_ = _e185;
                    phi_749_ = _e187;
                    phi_750_ = _e189;
                } else {
                    phi_748_ = bool();
                    phi_749_ = true;
                    phi_750_ = false;
                }
                let _e191 = phi_748_;
                let _e193 = phi_749_;
                let _e195 = phi_750_;
                phi_751_ = _e191;
                phi_752_ = _e193;
                phi_753_ = _e195;
            } else {
                phi_751_ = bool();
                phi_752_ = true;
                phi_753_ = false;
            }
            let _e197 = phi_751_;
            let _e199 = phi_752_;
            let _e201 = phi_753_;
            phi_754_ = _e197;
            phi_755_ = _e199;
            phi_756_ = _e201;
        } else {
            phi_754_ = bool();
            phi_755_ = true;
            phi_756_ = false;
        }
        let _e203 = phi_754_;
        let _e205 = phi_755_;
        let _e207 = phi_756_;
        if _e205 {
            phi_760_ = true;
        } else {
            phi_760_ = _e207;
        }
        let _e209 = phi_760_;
        if _e209 {
            phi_764_ = false;
        } else {
            phi_764_ = _e203;
        }
        let _e211 = phi_764_;
        if _e211 {
            let _e212 = (0u >= _e76);
            if _e212 {
                phi_2352_ = bool();
            } else {
                if (0u < _e76) {
                } else {
                    return;
                }
                let _e218 = nodes.member[(0u + 0u)].frame[0u];
                let _e222 = nodes.member[(0u + 0u)].frame[1u];
                let _e226 = nodes.member[(0u + 0u)].frame[2u];
                let _e230 = nodes.member[(0u + 0u)].frame[0u];
                let _e234 = nodes.member[(0u + 0u)].frame[1u];
                let _e238 = nodes.member[(0u + 0u)].frame[2u];
                let _e242 = nodes.member[(0u + 0u)].frame[3u];
                let _e276 = core_intrinsics_maximum_number_nsz_f32_(abs(_e147), abs(_e148));
                let _e277 = core_intrinsics_maximum_number_nsz_f32_(_e276, abs(_e149));
                let _e278 = (_e277 * 0.0000000000009094947f);
                if (abs(_e147) < _e278) {
                    phi_834_ = _e278;
                } else {
                    phi_834_ = abs(_e147);
                }
                let _e283 = phi_834_;
                if (_e147 < 0f) {
                    phi_841_ = (-1f / _e283);
                } else {
                    phi_841_ = (1f / _e283);
                }
                let _e288 = phi_841_;
                if (abs(_e148) < _e278) {
                    phi_848_ = _e278;
                } else {
                    phi_848_ = abs(_e148);
                }
                let _e293 = phi_848_;
                if (_e148 < 0f) {
                    phi_855_ = (-1f / _e293);
                } else {
                    phi_855_ = (1f / _e293);
                }
                let _e298 = phi_855_;
                if (abs(_e149) < _e278) {
                    phi_862_ = _e278;
                } else {
                    phi_862_ = abs(_e149);
                }
                let _e303 = phi_862_;
                if (_e149 < 0f) {
                    phi_869_ = (-1f / _e303);
                } else {
                    phi_869_ = (1f / _e303);
                }
                let _e308 = phi_869_;
                let _e312 = abs((bitcast<f32>(_e218) - _e131));
                let _e313 = abs((bitcast<f32>(_e222) - _e133));
                let _e314 = abs((bitcast<f32>(_e226) - _e135));
                let _e318 = abs(((bitcast<f32>(_e230) + (bitcast<f32>((((_e242 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e131));
                let _e319 = abs(((bitcast<f32>(_e234) + (bitcast<f32>((((_e242 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e133));
                let _e320 = abs(((bitcast<f32>(_e238) + (bitcast<f32>((((_e242 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e135));
                if (_e312 > _e318) {
                    phi_886_ = _e312;
                } else {
                    phi_886_ = _e318;
                }
                let _e323 = phi_886_;
                if (_e313 > _e319) {
                    phi_891_ = _e313;
                } else {
                    phi_891_ = _e319;
                }
                let _e326 = phi_891_;
                if (_e314 > _e320) {
                    phi_896_ = _e314;
                } else {
                    phi_896_ = _e320;
                }
                let _e329 = phi_896_;
                let _e330 = core_intrinsics_maximum_number_nsz_f32_(_e323, _e326);
                let _e331 = core_intrinsics_maximum_number_nsz_f32_(_e330, _e329);
                let _e335 = (_e331 * 0.0000019073486f);
                let _e336 = (abs(_e288) * _e335);
                let _e337 = (abs(_e298) * _e335);
                let _e338 = (abs(_e308) * _e335);
                let _e342 = (_e331 * 0.0000009536743f);
                let _e343 = (abs(_e288) * _e342);
                let _e344 = (abs(_e298) * _e342);
                let _e345 = (abs(_e308) * _e342);
                let _e346 = abs(_e147);
                let _e347 = abs(_e148);
                let _e348 = abs(_e149);
                if (_e346 >= _e347) {
                    if (_e346 >= _e348) {
                        phi_924_ = false;
                    } else {
                        phi_924_ = true;
                    }
                    let _e352 = phi_924_;
                    phi_925_ = _e352;
                } else {
                    phi_925_ = true;
                }
                let _e354 = phi_925_;
                if _e354 {
                    if (_e347 >= _e348) {
                        phi_933_ = 1u;
                    } else {
                        phi_933_ = 2u;
                    }
                    let _e357 = phi_933_;
                    phi_934_ = _e357;
                } else {
                    phi_934_ = 0u;
                }
                let _e359 = phi_934_;
                if (_e359 == 0u) {
                    phi_946_ = vec3<f32>(_e148, _e149, _e147);
                } else {
                    if (_e359 == 1u) {
                        phi_945_ = vec3<f32>(_e149, _e147, _e148);
                    } else {
                        phi_945_ = vec3<f32>(_e147, _e148, _e149);
                    }
                    let _e365 = phi_945_;
                    phi_946_ = _e365;
                }
                let _e367 = phi_946_;
                let _e370 = (_e367.x / _e367.z);
                let _e373 = (_e367.y / _e367.z);
                if (_e288 < 0f) {
                    phi_959_ = 0u;
                } else {
                    phi_959_ = 1u;
                }
                let _e378 = phi_959_;
                if (_e298 < 0f) {
                    phi_964_ = 0u;
                } else {
                    phi_964_ = 2u;
                }
                let _e381 = phi_964_;
                if (_e308 < 0f) {
                    phi_969_ = 0u;
                } else {
                    phi_969_ = 4u;
                }
                let _e384 = phi_969_;
                let _e386 = ((_e378 | _e381) | _e384);
                let _e387 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e387.first[0], _e387.first[1], _e387.first[2], _e387.first[3], _e387.first[4], _e387.first[5], _e387.first[6], _e387.first[7], _e387.first[8], _e387.first[9], _e387.first[10], _e387.first[11], _e387.first[12], _e387.first[13], _e387.first[14], _e387.first[15], _e387.first[16], _e387.first[17], _e387.first[18], _e387.first[19], _e387.first[20], _e387.first[21], _e387.first[22], _e387.first[23], _e387.first[24], _e387.first[25], _e387.first[26], _e387.first[27], _e387.first[28], _e387.first[29], _e387.first[30], _e387.first[31]), array<u32, 32>(_e387.mask[0], _e387.mask[1], _e387.mask[2], _e387.mask[3], _e387.mask[4], _e387.mask[5], _e387.mask[6], _e387.mask[7], _e387.mask[8], _e387.mask[9], _e387.mask[10], _e387.mask[11], _e387.mask[12], _e387.mask[13], _e387.mask[14], _e387.mask[15], _e387.mask[16], _e387.mask[17], _e387.mask[18], _e387.mask[19], _e387.mask[20], _e387.mask[21], _e387.mask[22], _e387.mask[23], _e387.mask[24], _e387.mask[25], _e387.mask[26], _e387.mask[27], _e387.mask[28], _e387.mask[29], _e387.mask[30], _e387.mask[31]), _e387.len, _e387.group, _e387.group_mask);
                let _e461 = local_1.group_mask;
                if ((_e461 & 4278190080u) == 0u) {
                    let _e465 = local_1.len;
                    if (_e465 == 0u) {
                        phi_1083_ = false;
                    } else {
                        let _e469 = local_1.len;
                        local_1.len = (_e469 - 1u);
                        let _e472 = local_1.len;
                        if (_e472 < 32u) {
                        } else {
                            return;
                        }
                        let _e477 = local_1.first[(0u + _e472)];
                        local_1.group = _e477;
                        let _e480 = local_1.len;
                        if (_e480 < 32u) {
                        } else {
                            return;
                        }
                        let _e485 = local_1.mask[(0u + _e480)];
                        local_1.group_mask = _e485;
                        phi_1083_ = true;
                    }
                    let _e488 = phi_1083_;
                    phi_1084_ = _e488;
                } else {
                    phi_1084_ = true;
                }
                let _e490 = phi_1084_;
                if _e490 {
                    let _e492 = local_1.group_mask;
                    let _e498 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e492)), 32u, (_e492 == 0u)));
                    let _e502 = local_1.group_mask;
                    let _e516 = local_1.group_mask;
                    local_1.group_mask = (_e516 & ~((1u << bitcast<u32>((_e498 & 31u)))));
                    let _e519 = local_1.group;
                    phi_1115_ = (_e519 + countOneBits(((_e502 & ~((4294967295u << bitcast<u32>((((_e498 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1115_ = 4294967295u;
                }
                let _e522 = phi_1115_;
                phi_1117_ = _e522;
                loop {
                    let _e524 = phi_1117_;
                    if (_e524 != 4294967295u) {
                        if (_e524 < _e76) {
                        } else {
                            return;
                        }
                        let _e531 = nodes.member[(0u + _e524)].frame[3u];
                        let _e556 = (bitcast<f32>((((_e531 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e288);
                        let _e557 = (bitcast<f32>((((_e531 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e298);
                        let _e558 = (bitcast<f32>((((_e531 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e308);
                        let _e561 = nodes.member[(0u + _e524)].frame[0u];
                        let _e565 = nodes.member[(0u + _e524)].frame[1u];
                        let _e569 = nodes.member[(0u + _e524)].frame[2u];
                        let _e574 = ((bitcast<f32>(_e561) - _e131) * _e288);
                        let _e575 = ((bitcast<f32>(_e565) - _e133) * _e298);
                        let _e576 = ((bitcast<f32>(_e569) - _e135) * _e308);
                        let _e584 = nodes.member[(0u + _e524)].x;
                        if (_e288 < 0f) {
                            let _e595 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e584.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e601 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e595.unnamed.root, _e584.w), _e595.unnamed_1);
                            let _e607 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e601.unnamed, lt_bvh_traverse_Tree(_e584.x, _e601.unnamed_1.first_primitive));
                            phi_1198_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e607.unnamed, lt_bvh_traverse_Tree(_e607.unnamed_1.root, _e584.y));
                        } else {
                            let _e623 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e584.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e629 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e623.unnamed.root, _e584.y), _e623.unnamed_1);
                            let _e635 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e629.unnamed, lt_bvh_traverse_Tree(_e584.z, _e629.unnamed_1.first_primitive));
                            phi_1198_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e635.unnamed, lt_bvh_traverse_Tree(_e635.unnamed_1.root, _e584.w));
                        }
                        let _e643 = phi_1198_;
                        let _e653 = nodes.member[(0u + _e524)].y;
                        if (_e298 < 0f) {
                            let _e664 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e653.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e670 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e664.unnamed.root, _e653.w), _e664.unnamed_1);
                            let _e676 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e670.unnamed, lt_bvh_traverse_Tree(_e653.x, _e670.unnamed_1.first_primitive));
                            phi_1225_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e676.unnamed, lt_bvh_traverse_Tree(_e676.unnamed_1.root, _e653.y));
                        } else {
                            let _e692 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e653.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e698 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e692.unnamed.root, _e653.y), _e692.unnamed_1);
                            let _e704 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e698.unnamed, lt_bvh_traverse_Tree(_e653.z, _e698.unnamed_1.first_primitive));
                            phi_1225_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e704.unnamed, lt_bvh_traverse_Tree(_e704.unnamed_1.root, _e653.w));
                        }
                        let _e712 = phi_1225_;
                        let _e722 = nodes.member[(0u + _e524)].z;
                        if (_e308 < 0f) {
                            let _e733 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e722.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e739 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e733.unnamed.root, _e722.w), _e733.unnamed_1);
                            let _e745 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e739.unnamed, lt_bvh_traverse_Tree(_e722.x, _e739.unnamed_1.first_primitive));
                            phi_1252_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e745.unnamed, lt_bvh_traverse_Tree(_e745.unnamed_1.root, _e722.y));
                        } else {
                            let _e761 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e722.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e767 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e761.unnamed.root, _e722.y), _e761.unnamed_1);
                            let _e773 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e767.unnamed, lt_bvh_traverse_Tree(_e722.z, _e767.unnamed_1.first_primitive));
                            phi_1252_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e773.unnamed, lt_bvh_traverse_Tree(_e773.unnamed_1.root, _e722.w));
                        }
                        let _e781 = phi_1252_;
                        phi_1258_ = 0u;
                        phi_1261_ = 0u;
                        loop {
                            let _e791 = phi_1258_;
                            let _e793 = phi_1261_;
                            local_2 = _e793;
                            local_3 = _e793;
                            local_4 = _e793;
                            let _e794 = (_e791 < 8u);
                            if _e794 {
                                let _e796 = (_e791 >> bitcast<u32>(2i));
                                let _e797 = (_e791 & 3u);
                                if (_e796 == 0u) {
                                    phi_1275_ = _e643.unnamed.root;
                                } else {
                                    phi_1275_ = _e643.unnamed.first_primitive;
                                }
                                let _e800 = phi_1275_;
                                if (_e796 == 0u) {
                                    phi_1285_ = _e712.unnamed.root;
                                } else {
                                    phi_1285_ = _e712.unnamed.first_primitive;
                                }
                                let _e809 = phi_1285_;
                                if (_e796 == 0u) {
                                    phi_1295_ = _e781.unnamed.root;
                                } else {
                                    phi_1295_ = _e781.unnamed.first_primitive;
                                }
                                let _e818 = phi_1295_;
                                let _e831 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e800 >> bitcast<u32>(((_e797 * 8u) & 31u))) & 255u)) * _e556) + (_e574 - _e336)), ((f32(((_e809 >> bitcast<u32>(((_e797 * 8u) & 31u))) & 255u)) * _e557) + (_e575 - _e337)));
                                let _e832 = core_intrinsics_maximum_number_nsz_f32_(_e831, ((f32(((_e818 >> bitcast<u32>(((_e797 * 8u) & 31u))) & 255u)) * _e558) + (_e576 - _e338)));
                                if (_e796 == 0u) {
                                    phi_1313_ = _e643.unnamed_1.root;
                                } else {
                                    phi_1313_ = _e643.unnamed_1.first_primitive;
                                }
                                let _e835 = phi_1313_;
                                if (_e796 == 0u) {
                                    phi_1323_ = _e712.unnamed_1.root;
                                } else {
                                    phi_1323_ = _e712.unnamed_1.first_primitive;
                                }
                                let _e844 = phi_1323_;
                                if (_e796 == 0u) {
                                    phi_1333_ = _e781.unnamed_1.root;
                                } else {
                                    phi_1333_ = _e781.unnamed_1.first_primitive;
                                }
                                let _e853 = phi_1333_;
                                let _e866 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e835 >> bitcast<u32>(((_e797 * 8u) & 31u))) & 255u)) * _e556) + (_e574 + _e336)), ((f32(((_e844 >> bitcast<u32>(((_e797 * 8u) & 31u))) & 255u)) * _e557) + (_e575 + _e337)));
                                let _e867 = core_intrinsics_minimum_number_nsz_f32_(_e866, ((f32(((_e853 >> bitcast<u32>(((_e797 * 8u) & 31u))) & 255u)) * _e558) + (_e576 + _e338)));
                                if (_e832 <= _e867) {
                                    if (_e832 <= _e139) {
                                        if (_e867 >= 0f) {
                                            if (_e796 == 0u) {
                                                let _e874 = nodes.member[(0u + _e524)].links[2u];
                                                phi_1369_ = _e874;
                                            } else {
                                                let _e877 = nodes.member[(0u + _e524)].links[3u];
                                                phi_1369_ = _e877;
                                            }
                                            let _e879 = phi_1369_;
                                            let _e884 = ((_e879 >> bitcast<u32>(((_e797 * 8u) & 31u))) & 255u);
                                            let _e885 = (_e884 & 31u);
                                            if (_e885 >= 24u) {
                                                phi_1382_ = (24u + ((_e885 - 24u) ^ _e386));
                                            } else {
                                                phi_1382_ = _e885;
                                            }
                                            let _e891 = phi_1382_;
                                            phi_1387_ = (_e793 | ((_e884 >> bitcast<u32>(5i)) << bitcast<u32>((_e891 & 31u))));
                                        } else {
                                            phi_1387_ = _e793;
                                        }
                                        let _e899 = phi_1387_;
                                        phi_1388_ = _e899;
                                    } else {
                                        phi_1388_ = _e793;
                                    }
                                    let _e901 = phi_1388_;
                                    phi_1389_ = _e901;
                                } else {
                                    phi_1389_ = _e793;
                                }
                                let _e903 = phi_1389_;
                                phi_1259_ = (_e791 + 1u);
                                phi_1262_ = _e903;
                            } else {
                                phi_1259_ = u32();
                                phi_1262_ = u32();
                            }
                            let _e906 = phi_1259_;
                            let _e908 = phi_1262_;
                            continue;
                            continuing {
                                phi_1258_ = _e906;
                                phi_1261_ = _e908;
                                break if !(_e794);
                            }
                        }
                        let _e912 = nodes.member[(0u + _e524)].links[0u];
                        let _e916 = nodes.member[(0u + _e524)].frame[3u];
                        let _e920 = local_2;
                        if ((_e920 & 4278190080u) == 0u) {
                        } else {
                            let _e924 = local_1.group_mask;
                            if ((_e924 & 4278190080u) == 0u) {
                            } else {
                                let _e928 = local_1.len;
                                if (_e928 < 32u) {
                                    let _e931 = local_1.group;
                                    let _e933 = local_1.len;
                                    if (_e933 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.first[(0u + _e933)] = _e931;
                                    let _e939 = local_1.group_mask;
                                    let _e941 = local_1.len;
                                    if (_e941 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.mask[(0u + _e941)] = _e939;
                                    let _e948 = local_1.len;
                                    local_1.len = (_e948 + 1u);
                                }
                            }
                            local_1.group = (0u + _e912);
                            let _e952 = local_3;
                            local_1.group_mask = ((_e952 & 4278190080u) | (_e916 >> bitcast<u32>(24i)));
                        }
                        let _e957 = local_4;
                        phi_1447_ = (_e957 & 16777215u);
                        loop {
                            let _e960 = phi_1447_;
                            let _e961 = (_e960 == 0u);
                            local_5 = _e961;
                            local_9 = _e961;
                            if _e961 {
                                phi_1448_ = u32();
                                phi_2255_ = false;
                                phi_2256_ = false;
                                phi_2257_ = false;
                            } else {
                                let _e964 = nodes.member[(0u + _e524)].links[1u];
                                let _e969 = ((0u + _e964) + select(firstTrailingBit(_e960), 32u, (_e960 == 0u)));
                                if (_e969 < _e79) {
                                } else {
                                    return;
                                }
                                let _e976 = triangles.member[(0u + _e969)].v0_;
                                let _e978 = (_e976.x - _e131);
                                let _e980 = (_e976.y - _e133);
                                let _e982 = (_e976.z - _e135);
                                if (_e359 == 0u) {
                                    phi_1493_ = vec3<f32>(_e980, _e982, _e978);
                                } else {
                                    if (_e359 == 1u) {
                                        phi_1492_ = vec3<f32>(_e982, _e978, _e980);
                                    } else {
                                        phi_1492_ = (_e976 - vec3<f32>(_e131, _e133, _e135));
                                    }
                                    let _e990 = phi_1492_;
                                    phi_1493_ = _e990;
                                }
                                let _e992 = phi_1493_;
                                let _e996 = (_e992.x - (_e370 * _e992.z));
                                let _e1000 = (_e992.y - (_e373 * _e992.z));
                                let _e1002 = triangles.member[(0u + _e969)].v1_;
                                let _e1004 = (_e1002.x - _e131);
                                let _e1006 = (_e1002.y - _e133);
                                let _e1008 = (_e1002.z - _e135);
                                if (_e359 == 0u) {
                                    phi_1523_ = vec3<f32>(_e1006, _e1008, _e1004);
                                } else {
                                    if (_e359 == 1u) {
                                        phi_1522_ = vec3<f32>(_e1008, _e1004, _e1006);
                                    } else {
                                        phi_1522_ = (_e1002 - vec3<f32>(_e131, _e133, _e135));
                                    }
                                    let _e1016 = phi_1522_;
                                    phi_1523_ = _e1016;
                                }
                                let _e1018 = phi_1523_;
                                let _e1022 = (_e1018.x - (_e370 * _e1018.z));
                                let _e1026 = (_e1018.y - (_e373 * _e1018.z));
                                let _e1028 = triangles.member[(0u + _e969)].v2_;
                                let _e1030 = (_e1028.x - _e131);
                                let _e1032 = (_e1028.y - _e133);
                                let _e1034 = (_e1028.z - _e135);
                                if (_e359 == 0u) {
                                    phi_1553_ = vec3<f32>(_e1032, _e1034, _e1030);
                                } else {
                                    if (_e359 == 1u) {
                                        phi_1552_ = vec3<f32>(_e1034, _e1030, _e1032);
                                    } else {
                                        phi_1552_ = (_e1028 - vec3<f32>(_e131, _e133, _e135));
                                    }
                                    let _e1042 = phi_1552_;
                                    phi_1553_ = _e1042;
                                }
                                let _e1044 = phi_1553_;
                                let _e1048 = (_e1044.x - (_e370 * _e1044.z));
                                let _e1052 = (_e1044.y - (_e373 * _e1044.z));
                                if (_e1022 < _e1048) {
                                    phi_1572_ = true;
                                } else {
                                    if (_e1022 == _e1048) {
                                        phi_1571_ = (_e1026 < _e1052);
                                    } else {
                                        phi_1571_ = false;
                                    }
                                    let _e1057 = phi_1571_;
                                    phi_1572_ = _e1057;
                                }
                                let _e1059 = phi_1572_;
                                if _e1059 {
                                    phi_1576_ = _e1052;
                                    phi_1577_ = _e1048;
                                    phi_1578_ = _e1026;
                                    phi_1579_ = _e1022;
                                } else {
                                    phi_1576_ = _e1026;
                                    phi_1577_ = _e1022;
                                    phi_1578_ = _e1052;
                                    phi_1579_ = _e1048;
                                }
                                let _e1061 = phi_1576_;
                                let _e1063 = phi_1577_;
                                let _e1065 = phi_1578_;
                                let _e1067 = phi_1579_;
                                let _e1070 = ((_e1067 * _e1061) - (_e1065 * _e1063));
                                if _e1059 {
                                    phi_1587_ = -(_e1070);
                                } else {
                                    phi_1587_ = _e1070;
                                }
                                let _e1073 = phi_1587_;
                                if (_e1048 < _e996) {
                                    phi_1598_ = true;
                                } else {
                                    if (_e1048 == _e996) {
                                        phi_1597_ = (_e1052 < _e1000);
                                    } else {
                                        phi_1597_ = false;
                                    }
                                    let _e1078 = phi_1597_;
                                    phi_1598_ = _e1078;
                                }
                                let _e1080 = phi_1598_;
                                if _e1080 {
                                    phi_1602_ = _e1000;
                                    phi_1603_ = _e996;
                                    phi_1604_ = _e1052;
                                    phi_1605_ = _e1048;
                                } else {
                                    phi_1602_ = _e1052;
                                    phi_1603_ = _e1048;
                                    phi_1604_ = _e1000;
                                    phi_1605_ = _e996;
                                }
                                let _e1082 = phi_1602_;
                                let _e1084 = phi_1603_;
                                let _e1086 = phi_1604_;
                                let _e1088 = phi_1605_;
                                let _e1091 = ((_e1088 * _e1082) - (_e1086 * _e1084));
                                if _e1080 {
                                    phi_1613_ = -(_e1091);
                                } else {
                                    phi_1613_ = _e1091;
                                }
                                let _e1094 = phi_1613_;
                                if (_e996 < _e1022) {
                                    phi_1624_ = true;
                                } else {
                                    if (_e996 == _e1022) {
                                        phi_1623_ = (_e1000 < _e1026);
                                    } else {
                                        phi_1623_ = false;
                                    }
                                    let _e1099 = phi_1623_;
                                    phi_1624_ = _e1099;
                                }
                                let _e1101 = phi_1624_;
                                if _e1101 {
                                    phi_1628_ = _e1026;
                                    phi_1629_ = _e1022;
                                    phi_1630_ = _e1000;
                                    phi_1631_ = _e996;
                                } else {
                                    phi_1628_ = _e1000;
                                    phi_1629_ = _e996;
                                    phi_1630_ = _e1026;
                                    phi_1631_ = _e1022;
                                }
                                let _e1103 = phi_1628_;
                                let _e1105 = phi_1629_;
                                let _e1107 = phi_1630_;
                                let _e1109 = phi_1631_;
                                let _e1112 = ((_e1109 * _e1103) - (_e1107 * _e1105));
                                if _e1101 {
                                    phi_1639_ = -(_e1112);
                                } else {
                                    phi_1639_ = _e1112;
                                }
                                let _e1115 = phi_1639_;
                                if (_e1073 >= 0f) {
                                    if (_e1094 >= 0f) {
                                        if (_e1115 >= 0f) {
                                            phi_1654_ = ((_e1073 + _e1094) + _e1115);
                                            phi_1655_ = false;
                                        } else {
                                            phi_1654_ = f32();
                                            phi_1655_ = true;
                                        }
                                        let _e1122 = phi_1654_;
                                        let _e1124 = phi_1655_;
                                        phi_1656_ = _e1122;
                                        phi_1657_ = _e1124;
                                    } else {
                                        phi_1656_ = f32();
                                        phi_1657_ = true;
                                    }
                                    let _e1126 = phi_1656_;
                                    let _e1128 = phi_1657_;
                                    phi_1658_ = _e1126;
                                    phi_1659_ = _e1128;
                                } else {
                                    phi_1658_ = f32();
                                    phi_1659_ = true;
                                }
                                let _e1130 = phi_1658_;
                                let _e1132 = phi_1659_;
                                if _e1132 {
                                    if (_e1073 <= 0f) {
                                        if (_e1094 <= 0f) {
                                            let _e1135 = (_e1115 <= 0f);
                                            if _e1135 {
                                            }
                                            phi_1677_ = ((_e1073 + _e1094) + _e1115);
                                            phi_1678_ = false;
                                            phi_1679_ = _e1135;
                                        } else {
                                            phi_1677_ = f32();
                                            phi_1678_ = true;
                                            phi_1679_ = false;
                                        }
                                        let _e1139 = phi_1677_;
                                        let _e1141 = phi_1678_;
                                        let _e1143 = phi_1679_;
                                        phi_1680_ = _e1139;
                                        phi_1681_ = _e1141;
                                        phi_1682_ = _e1143;
                                    } else {
                                        phi_1680_ = f32();
                                        phi_1681_ = true;
                                        phi_1682_ = false;
                                    }
                                    let _e1145 = phi_1680_;
                                    let _e1147 = phi_1681_;
                                    let _e1149 = phi_1682_;
                                    if _e1147 {
                                        phi_1686_ = false;
                                    } else {
                                        phi_1686_ = _e1149;
                                    }
                                    let _e1151 = phi_1686_;
                                    phi_1687_ = _e1145;
                                    phi_1688_ = _e1151;
                                } else {
                                    phi_1687_ = _e1130;
                                    phi_1688_ = true;
                                }
                                let _e1153 = phi_1687_;
                                let _e1155 = phi_1688_;
                                if _e1155 {
                                    let _e1156 = (_e1153 == 0f);
                                    if _e1156 {
                                        phi_2004_ = lt_bvh_triangle_Intersection();
                                        phi_2005_ = false;
                                    } else {
                                        let _e1158 = triangles.member[(0u + _e969)].v0_;
                                        let _e1160 = (_e1158.x - _e131);
                                        let _e1162 = (_e1158.y - _e133);
                                        let _e1164 = (_e1158.z - _e135);
                                        if (_e359 == 0u) {
                                            phi_1717_ = vec3<f32>(_e1162, _e1164, _e1160);
                                        } else {
                                            if (_e359 == 1u) {
                                                phi_1716_ = vec3<f32>(_e1164, _e1160, _e1162);
                                            } else {
                                                phi_1716_ = (_e1158 - vec3<f32>(_e131, _e133, _e135));
                                            }
                                            let _e1172 = phi_1716_;
                                            phi_1717_ = _e1172;
                                        }
                                        let _e1174 = phi_1717_;
                                        let _e1176 = triangles.member[(0u + _e969)].v1_;
                                        let _e1178 = triangles.member[(0u + _e969)].v0_;
                                        let _e1181 = (_e1176.x - _e1178.x);
                                        let _e1184 = (_e1176.y - _e1178.y);
                                        let _e1187 = (_e1176.z - _e1178.z);
                                        if (_e359 == 0u) {
                                            phi_1743_ = vec3<f32>(_e1184, _e1187, _e1181);
                                        } else {
                                            if (_e359 == 1u) {
                                                phi_1742_ = vec3<f32>(_e1187, _e1181, _e1184);
                                            } else {
                                                phi_1742_ = (_e1176 - _e1178);
                                            }
                                            let _e1194 = phi_1742_;
                                            phi_1743_ = _e1194;
                                        }
                                        let _e1196 = phi_1743_;
                                        let _e1198 = triangles.member[(0u + _e969)].v2_;
                                        let _e1200 = triangles.member[(0u + _e969)].v0_;
                                        let _e1203 = (_e1198.x - _e1200.x);
                                        let _e1206 = (_e1198.y - _e1200.y);
                                        let _e1209 = (_e1198.z - _e1200.z);
                                        if (_e359 == 0u) {
                                            phi_1769_ = vec3<f32>(_e1206, _e1209, _e1203);
                                        } else {
                                            if (_e359 == 1u) {
                                                phi_1768_ = vec3<f32>(_e1209, _e1203, _e1206);
                                            } else {
                                                phi_1768_ = (_e1198 - _e1200);
                                            }
                                            let _e1216 = phi_1768_;
                                            phi_1769_ = _e1216;
                                        }
                                        let _e1218 = phi_1769_;
                                        let _e1225 = ((_e1196.y * _e1218.z) - (_e1196.z * _e1218.y));
                                        let _e1232 = ((_e1196.z * _e1218.x) - (_e1196.x * _e1218.z));
                                        let _e1239 = ((_e1196.x * _e1218.y) - (_e1196.y * _e1218.x));
                                        let _e1253 = (((1f / _e367.z) * (((_e1225 * _e1174.x) + (_e1232 * _e1174.y)) + (_e1239 * _e1174.z))) / (((_e1225 * _e370) + (_e1232 * _e373)) + _e1239));
                                        if (_e1253 > 0f) {
                                            if (_e1253 < _e139) {
                                                let _e1257 = triangles.member[(0u + _e969)].v0_;
                                                let _e1259 = triangles.member[(0u + _e969)].v1_;
                                                if (_e1257.x < _e1259.x) {
                                                    phi_1825_ = _e1257.x;
                                                } else {
                                                    phi_1825_ = _e1259.x;
                                                }
                                                let _e1266 = phi_1825_;
                                                if (_e1257.y < _e1259.y) {
                                                    phi_1834_ = _e1257.y;
                                                } else {
                                                    phi_1834_ = _e1259.y;
                                                }
                                                let _e1273 = phi_1834_;
                                                if (_e1257.z < _e1259.z) {
                                                    phi_1843_ = _e1257.z;
                                                } else {
                                                    phi_1843_ = _e1259.z;
                                                }
                                                let _e1280 = phi_1843_;
                                                let _e1282 = triangles.member[(0u + _e969)].v2_;
                                                if (_e1266 < _e1282.x) {
                                                    phi_1852_ = _e1266;
                                                } else {
                                                    phi_1852_ = _e1282.x;
                                                }
                                                let _e1287 = phi_1852_;
                                                if (_e1273 < _e1282.y) {
                                                    phi_1859_ = _e1273;
                                                } else {
                                                    phi_1859_ = _e1282.y;
                                                }
                                                let _e1292 = phi_1859_;
                                                if (_e1280 < _e1282.z) {
                                                    phi_1866_ = _e1280;
                                                } else {
                                                    phi_1866_ = _e1282.z;
                                                }
                                                let _e1297 = phi_1866_;
                                                let _e1299 = triangles.member[(0u + _e969)].v0_;
                                                let _e1301 = triangles.member[(0u + _e969)].v1_;
                                                if (_e1299.x > _e1301.x) {
                                                    phi_1879_ = _e1299.x;
                                                } else {
                                                    phi_1879_ = _e1301.x;
                                                }
                                                let _e1308 = phi_1879_;
                                                if (_e1299.y > _e1301.y) {
                                                    phi_1888_ = _e1299.y;
                                                } else {
                                                    phi_1888_ = _e1301.y;
                                                }
                                                let _e1315 = phi_1888_;
                                                if (_e1299.z > _e1301.z) {
                                                    phi_1897_ = _e1299.z;
                                                } else {
                                                    phi_1897_ = _e1301.z;
                                                }
                                                let _e1322 = phi_1897_;
                                                let _e1324 = triangles.member[(0u + _e969)].v2_;
                                                if (_e1308 > _e1324.x) {
                                                    phi_1906_ = _e1308;
                                                } else {
                                                    phi_1906_ = _e1324.x;
                                                }
                                                let _e1329 = phi_1906_;
                                                if (_e1315 > _e1324.y) {
                                                    phi_1913_ = _e1315;
                                                } else {
                                                    phi_1913_ = _e1324.y;
                                                }
                                                let _e1334 = phi_1913_;
                                                if (_e1322 > _e1324.z) {
                                                    phi_1920_ = _e1322;
                                                } else {
                                                    phi_1920_ = _e1324.z;
                                                }
                                                let _e1339 = phi_1920_;
                                                let _e1343 = ((_e1287 - _e131) * _e288);
                                                let _e1344 = ((_e1292 - _e133) * _e298);
                                                let _e1345 = ((_e1297 - _e135) * _e308);
                                                let _e1349 = ((_e1329 - _e131) * _e288);
                                                let _e1350 = ((_e1334 - _e133) * _e298);
                                                let _e1351 = ((_e1339 - _e135) * _e308);
                                                if (_e1343 < _e1349) {
                                                    phi_1937_ = _e1343;
                                                } else {
                                                    phi_1937_ = _e1349;
                                                }
                                                let _e1354 = phi_1937_;
                                                if (_e1344 < _e1350) {
                                                    phi_1942_ = _e1344;
                                                } else {
                                                    phi_1942_ = _e1350;
                                                }
                                                let _e1357 = phi_1942_;
                                                if (_e1345 < _e1351) {
                                                    phi_1947_ = _e1345;
                                                } else {
                                                    phi_1947_ = _e1351;
                                                }
                                                let _e1360 = phi_1947_;
                                                if (_e1343 > _e1349) {
                                                    phi_1955_ = _e1343;
                                                } else {
                                                    phi_1955_ = _e1349;
                                                }
                                                let _e1366 = phi_1955_;
                                                if (_e1344 > _e1350) {
                                                    phi_1960_ = _e1344;
                                                } else {
                                                    phi_1960_ = _e1350;
                                                }
                                                let _e1369 = phi_1960_;
                                                if (_e1345 > _e1351) {
                                                    phi_1965_ = _e1345;
                                                } else {
                                                    phi_1965_ = _e1351;
                                                }
                                                let _e1372 = phi_1965_;
                                                let _e1376 = core_intrinsics_maximum_number_nsz_f32_((_e1354 - _e343), (_e1357 - _e344));
                                                let _e1377 = core_intrinsics_maximum_number_nsz_f32_(_e1376, (_e1360 - _e345));
                                                let _e1378 = core_intrinsics_minimum_number_nsz_f32_((_e1366 + _e343), (_e1369 + _e344));
                                                let _e1379 = core_intrinsics_minimum_number_nsz_f32_(_e1378, (_e1372 + _e345));
                                                if (_e1377 > -300000000000000000000000000000000000000f) {
                                                    phi_1977_ = _e1377;
                                                } else {
                                                    phi_1977_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1382 = phi_1977_;
                                                if (_e1379 < 300000000000000000000000000000000000000f) {
                                                    phi_1982_ = _e1379;
                                                } else {
                                                    phi_1982_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1385 = phi_1982_;
                                                if (_e1253 < _e1382) {
                                                    phi_1987_ = _e1382;
                                                } else {
                                                    phi_1987_ = _e1253;
                                                }
                                                let _e1388 = phi_1987_;
                                                if (_e1388 > _e1385) {
                                                    phi_1992_ = _e1385;
                                                } else {
                                                    phi_1992_ = _e1388;
                                                }
                                                let _e1391 = phi_1992_;
                                                phi_1997_ = lt_bvh_triangle_Intersection(_e1391, (_e1094 / _e1153), (_e1115 / _e1153), (_e1382 <= _e1385));
                                                phi_1998_ = false;
                                            } else {
                                                phi_1997_ = lt_bvh_triangle_Intersection();
                                                phi_1998_ = true;
                                            }
                                            let _e1397 = phi_1997_;
                                            let _e1399 = phi_1998_;
                                            phi_1999_ = _e1397;
                                            phi_2000_ = _e1399;
                                        } else {
                                            phi_1999_ = lt_bvh_triangle_Intersection();
                                            phi_2000_ = true;
                                        }
                                        let _e1401 = phi_1999_;
                                        let _e1403 = phi_2000_;
                                        if _e1403 {
                                        }
                                        phi_2004_ = _e1401;
                                        phi_2005_ = _e1403;
                                    }
                                    let _e1405 = phi_2004_;
                                    let _e1407 = phi_2005_;
                                    phi_2006_ = _e1405;
                                    phi_2007_ = _e1156;
                                    phi_2008_ = _e1407;
                                } else {
                                    phi_2006_ = lt_bvh_triangle_Intersection();
                                    phi_2007_ = true;
                                    phi_2008_ = false;
                                }
                                let _e1409 = phi_2006_;
                                let _e1411 = phi_2007_;
                                let _e1413 = phi_2008_;
                                if _e1411 {
                                    phi_2012_ = true;
                                } else {
                                    phi_2012_ = _e1413;
                                }
                                let _e1415 = phi_2012_;
                                if _e1415 {
                                    phi_2016_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_2016_ = _e1409;
                                }
                                let _e1417 = phi_2016_;
                                if _e1417.is_hit {
                                    if (_e1417.t > 0f) {
                                        if (_e1417.t < _e139) {
                                            let _e1424 = triangles.member[(0u + _e969)].i0_;
                                            let _e1426 = ((_e1424 & 2147483648u) == 0u);
                                            if _e1426 {
                                                phi_2239_ = false;
                                                phi_2240_ = false;
                                            } else {
                                                if (_e969 < _e79) {
                                                } else {
                                                    return;
                                                }
                                                let _e1433 = triangles.member[(0u + _e969)].i0_;
                                                let _e1434 = (_e1433 & 2147483647u);
                                                let _e1436 = triangles.member[(0u + _e969)].i1_;
                                                let _e1438 = triangles.member[(0u + _e969)].i2_;
                                                if (_e1434 < _e91) {
                                                } else {
                                                    return;
                                                }
                                                let _e1442 = vertices.member[(0u + _e1434)];
                                                if (_e1436 < _e91) {
                                                } else {
                                                    return;
                                                }
                                                let _e1446 = vertices.member[(0u + _e1436)];
                                                if (_e1438 < _e91) {
                                                } else {
                                                    return;
                                                }
                                                let _e1450 = vertices.member[(0u + _e1438)];
                                                let _e1451 = array<abi_Vertex, 3>(_e1442, _e1446, _e1450);
                                                if (_e1451[0].material < arrayLength((&materials.member))) {
                                                } else {
                                                    return;
                                                }
                                                let _e1457 = materials.member[(0u + _e1451[0].material)];
                                                if ((_e1457.flags & 1u) == 1u) {
                                                    let _e1462 = ((1f - _e1417.u) - _e1417.v);
                                                    if (_e1457.cutoff <= 0f) {
                                                        phi_2233_ = true;
                                                    } else {
                                                        let _e1489 = (_e1457.base_color.w * ((((f32((_e1451[0].color >> bitcast<u32>(24i))) * _e1462) + (f32((_e1451[1].color >> bitcast<u32>(24i))) * _e1417.u)) + (f32((_e1451[2].color >> bitcast<u32>(24i))) * _e1417.v)) * (1f / 255f)));
                                                        if (_e1457.alpha_size == 0u) {
                                                            phi_2230_ = _e1489;
                                                        } else {
                                                            local.offset = _e1457.alpha_offset;
                                                            local.size = _e1457.alpha_size;
                                                            local.flags = _e1457.flags;
                                                            let _e1520 = _lt_shaders_texture_TextureView_quad((&local), (((_e1451[0].u * _e1462) + (_e1451[1].u * _e1417.u)) + (_e1451[2].u * _e1417.v)), (((_e1451[0].v * _e1462) + (_e1451[1].v * _e1417.u)) + (_e1451[2].v * _e1417.v)));
                                                            let _e1524 = (_e1520.indices[0] >> bitcast<u32>(2i));
                                                            if (_e1524 < _e97) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1528 = alpha_texels.member[(0u + _e1524)];
                                                            let _e1544 = (_e1520.indices[1] >> bitcast<u32>(2i));
                                                            if (_e1544 < _e97) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1548 = alpha_texels.member[(0u + _e1544)];
                                                            let _e1565 = (_e1520.indices[2] >> bitcast<u32>(2i));
                                                            if (_e1565 < _e97) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1569 = alpha_texels.member[(0u + _e1565)];
                                                            let _e1586 = (_e1520.indices[3] >> bitcast<u32>(2i));
                                                            if (_e1586 < _e97) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1590 = alpha_texels.member[(0u + _e1586)];
                                                            phi_2230_ = (_e1489 * (((((f32(((_e1528 >> bitcast<u32>((((_e1520.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1520.weights.x) + ((f32(((_e1548 >> bitcast<u32>((((_e1520.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1520.weights.y)) + ((f32(((_e1569 >> bitcast<u32>((((_e1520.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1520.weights.z)) + ((f32(((_e1590 >> bitcast<u32>((((_e1520.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1520.weights.w)));
                                                        }
                                                        let _e1606 = phi_2230_;
                                                        phi_2233_ = (_e1606 >= _e1457.cutoff);
                                                    }
                                                    let _e1610 = phi_2233_;
                                                    phi_2234_ = _e1610;
                                                } else {
                                                    phi_2234_ = false;
                                                }
                                                let _e1612 = phi_2234_;
                                                if _e1612 {
                                                    phi_2238_ = false;
                                                } else {
                                                    phi_2238_ = true;
                                                }
                                                let _e1614 = phi_2238_;
                                                phi_2239_ = _e1614;
                                                phi_2240_ = _e1612;
                                            }
                                            let _e1616 = phi_2239_;
                                            let _e1618 = phi_2240_;
                                            phi_2241_ = _e1616;
                                            phi_2242_ = _e1426;
                                            phi_2243_ = _e1618;
                                        } else {
                                            phi_2241_ = true;
                                            phi_2242_ = false;
                                            phi_2243_ = false;
                                        }
                                        let _e1620 = phi_2241_;
                                        let _e1622 = phi_2242_;
                                        let _e1624 = phi_2243_;
                                        phi_2244_ = _e1620;
                                        phi_2245_ = _e1622;
                                        phi_2246_ = _e1624;
                                    } else {
                                        phi_2244_ = true;
                                        phi_2245_ = false;
                                        phi_2246_ = false;
                                    }
                                    let _e1626 = phi_2244_;
                                    let _e1628 = phi_2245_;
                                    let _e1630 = phi_2246_;
                                    phi_2247_ = _e1626;
                                    phi_2248_ = _e1628;
                                    phi_2249_ = _e1630;
                                } else {
                                    phi_2247_ = true;
                                    phi_2248_ = false;
                                    phi_2249_ = false;
                                }
                                let _e1632 = phi_2247_;
                                let _e1634 = phi_2248_;
                                let _e1636 = phi_2249_;
                                if _e1632 {
                                    phi_2253_ = false;
                                    phi_2254_ = false;
                                } else {
                                    phi_2253_ = _e1634;
                                    phi_2254_ = _e1636;
                                }
                                let _e1638 = phi_2253_;
                                let _e1640 = phi_2254_;
                                phi_1448_ = (_e960 & (_e960 - 1u));
                                phi_2255_ = _e1632;
                                phi_2256_ = _e1638;
                                phi_2257_ = _e1640;
                            }
                            let _e1642 = phi_1448_;
                            let _e1644 = phi_2255_;
                            let _e1646 = phi_2256_;
                            let _e1648 = phi_2257_;
                            local_7 = _e1646;
                            local_8 = _e1648;
                            continue;
                            continuing {
                                phi_1447_ = _e1642;
                                break if !(_e1644);
                            }
                        }
                        let _e1651 = local_5;
                        if _e1651 {
                            let _e1653 = local_1.group_mask;
                            if ((_e1653 & 4278190080u) == 0u) {
                                let _e1657 = local_1.len;
                                if (_e1657 == 0u) {
                                    phi_2299_ = false;
                                } else {
                                    let _e1661 = local_1.len;
                                    local_1.len = (_e1661 - 1u);
                                    let _e1664 = local_1.len;
                                    if (_e1664 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1669 = local_1.first[(0u + _e1664)];
                                    local_1.group = _e1669;
                                    let _e1672 = local_1.len;
                                    if (_e1672 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1677 = local_1.mask[(0u + _e1672)];
                                    local_1.group_mask = _e1677;
                                    phi_2299_ = true;
                                }
                                let _e1680 = phi_2299_;
                                phi_2300_ = _e1680;
                            } else {
                                phi_2300_ = true;
                            }
                            let _e1682 = phi_2300_;
                            if _e1682 {
                                let _e1684 = local_1.group_mask;
                                let _e1690 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1684)), 32u, (_e1684 == 0u)));
                                let _e1694 = local_1.group_mask;
                                let _e1708 = local_1.group_mask;
                                local_1.group_mask = (_e1708 & ~((1u << bitcast<u32>((_e1690 & 31u)))));
                                let _e1711 = local_1.group;
                                phi_2331_ = (_e1711 + countOneBits(((_e1694 & ~((4294967295u << bitcast<u32>((((_e1690 - 24u) ^ _e386) & 31u))))) & 255u)));
                            } else {
                                phi_2331_ = 4294967295u;
                            }
                            let _e1714 = phi_2331_;
                            phi_2332_ = _e1714;
                            phi_2333_ = false;
                            phi_2334_ = false;
                        } else {
                            phi_2332_ = u32();
                            let _e1958 = local_7;
                            phi_2333_ = _e1958;
                            let _e1961 = local_8;
                            phi_2334_ = _e1961;
                        }
                        let _e1716 = phi_2332_;
                        let _e1718 = phi_2333_;
                        let _e1720 = phi_2334_;
                        phi_1118_ = _e1716;
                        let _e1965 = local_9;
                        phi_2335_ = _e1965;
                        phi_2336_ = false;
                        phi_2337_ = _e1718;
                        phi_2338_ = _e1720;
                    } else {
                        phi_1118_ = u32();
                        phi_2335_ = false;
                        phi_2336_ = true;
                        phi_2337_ = false;
                        phi_2338_ = false;
                    }
                    let _e1722 = phi_1118_;
                    let _e1724 = phi_2335_;
                    let _e1726 = phi_2336_;
                    let _e1728 = phi_2337_;
                    let _e1730 = phi_2338_;
                    local_6 = _e1726;
                    local_10 = _e1728;
                    local_11 = _e1730;
                    continue;
                    continuing {
                        phi_1117_ = _e1722;
                        break if !(_e1724);
                    }
                }
                let _e1733 = local_6;
                if _e1733 {
                    phi_2342_ = false;
                    phi_2343_ = false;
                } else {
                    let _e1972 = local_10;
                    phi_2342_ = _e1972;
                    let _e1975 = local_11;
                    phi_2343_ = _e1975;
                }
                let _e1735 = phi_2342_;
                let _e1737 = phi_2343_;
                if _e1735 {
                    phi_2347_ = true;
                } else {
                    phi_2347_ = _e1737;
                }
                let _e1739 = phi_2347_;
                if _e1739 {
                    phi_2351_ = true;
                } else {
                    phi_2351_ = false;
                }
                let _e1741 = phi_2351_;
                phi_2352_ = _e1741;
            }
            let _e1743 = phi_2352_;
            phi_2353_ = _e1743;
            phi_2354_ = _e212;
        } else {
            phi_2353_ = bool();
            phi_2354_ = true;
        }
        let _e1745 = phi_2353_;
        let _e1747 = phi_2354_;
        if _e1747 {
            phi_2358_ = false;
        } else {
            phi_2358_ = _e1745;
        }
        let _e1749 = phi_2358_;
        if _e1749 {
            phi_2362_ = 0f;
        } else {
            phi_2362_ = 1f;
        }
        let _e1751 = phi_2362_;
        if (_e110 < _e82) {
        } else {
            return;
        }
        visibility.member[(0u + _e110)] = _e1751;
        if (_e110 < _e88) {
        } else {
            return;
        }
        let _e1758 = bits.member[(0u + _e110)];
        if ((_e1758 & 2u) == 0u) {
            phi_2383_ = (_e1758 & 1u);
        } else {
            phi_2383_ = (_e1758 & 7u);
        }
        let _e1764 = phi_2383_;
        if (_e110 < _e82) {
        } else {
            return;
        }
        let _e1768 = visibility.member[(0u + _e110)];
        if ((_e1764 & 1u) != 0u) {
            phi_2398_ = (2u | 1u);
        } else {
            phi_2398_ = 2u;
        }
        let _e1774 = phi_2398_;
        if (_e1768 < 0.5f) {
            phi_2403_ = (_e1774 | 4u);
        } else {
            phi_2403_ = _e1774;
        }
        let _e1777 = phi_2403_;
        if (_e110 < _e88) {
        } else {
            return;
        }
        bits.member[(0u + _e110)] = _e1777;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_learn_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
