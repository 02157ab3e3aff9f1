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

struct type_31 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_35 {
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

struct type_39 {
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

struct type_50 {
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

struct type_59 {
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

struct type_65 {
    member: abi_ShadowParams,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_17;
@group(0) @binding(0) 
var<uniform> p: type_65;
@group(0) @binding(2) 
var<storage> nodes: type_59;
@group(0) @binding(3) 
var<storage> triangles: type_31;
@group(0) @binding(5) 
var<storage> list: type_13;
@group(0) @binding(6) 
var<storage, read_write> bits: type_13;
@group(0) @binding(7) 
var<storage> instances: type_50;
@group(0) @binding(8) 
var<storage> vertices: type_35;
@group(0) @binding(9) 
var<storage> materials: type_39;
@group(0) @binding(10) 
var<storage> alpha_texels: type_13;

fn _lt_shaders_texture_TextureView_quad(param: ptr<function, texture_TextureView>, param_1: f32, param_2: f32) -> texture_TexelQuad {
    var phi_237_: f32;
    var phi_242_: f32;
    var phi_243_: bool;
    var phi_244_: f32;
    var phi_245_: bool;
    var phi_249_: f32;
    var phi_275_: f32;
    var phi_280_: f32;
    var phi_281_: bool;
    var phi_282_: f32;
    var phi_283_: bool;
    var phi_287_: f32;
    var phi_295_: f32;
    var phi_296_: f32;
    var phi_297_: f32;
    var phi_306_: f32;
    var phi_307_: f32;
    var phi_325_: u32;
    var phi_339_: u32;
    var phi_346_: u32;
    var phi_351_: u32;
    var phi_357_: u32;
    var phi_362_: u32;
    var phi_364_: texture_Axis;
    var phi_392_: f32;
    var phi_397_: f32;
    var phi_398_: bool;
    var phi_399_: f32;
    var phi_400_: bool;
    var phi_404_: f32;
    var phi_430_: f32;
    var phi_435_: f32;
    var phi_436_: bool;
    var phi_437_: f32;
    var phi_438_: bool;
    var phi_442_: f32;
    var phi_450_: f32;
    var phi_451_: f32;
    var phi_452_: f32;
    var phi_461_: f32;
    var phi_462_: f32;
    var phi_480_: u32;
    var phi_494_: u32;
    var phi_501_: u32;
    var phi_506_: u32;
    var phi_512_: u32;
    var phi_517_: u32;
    var phi_519_: texture_Axis;

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
                phi_237_ = 1f;
            } else {
                phi_237_ = 0f;
            }
            let _e101 = phi_237_;
            if (param_1 < 8388608f) {
                phi_242_ = (_e98 - _e101);
                phi_243_ = false;
            } else {
                phi_242_ = f32();
                phi_243_ = true;
            }
            let _e104 = phi_242_;
            let _e106 = phi_243_;
            phi_244_ = _e104;
            phi_245_ = _e106;
        } else {
            phi_244_ = f32();
            phi_245_ = true;
        }
        let _e108 = phi_244_;
        let _e110 = phi_245_;
        if _e110 {
            phi_249_ = param_1;
        } else {
            phi_249_ = _e108;
        }
        let _e112 = phi_249_;
        phi_297_ = (param_1 - _e112);
    } else {
        if (_e85 == 1u) {
            let _e115 = (param_1 * 0.5f);
            if (_e115 > -8388608f) {
                let _e127 = f32(select(0i, select(select(i32(_e115), i32(-2147483648), (_e115 < bitcast<f32>(3472883712u))), 2147483647i, (_e115 > bitcast<f32>(1325400063u))), (_e115 == _e115)));
                if (_e127 > _e115) {
                    phi_275_ = 1f;
                } else {
                    phi_275_ = 0f;
                }
                let _e130 = phi_275_;
                if (_e115 < 8388608f) {
                    phi_280_ = (_e127 - _e130);
                    phi_281_ = false;
                } else {
                    phi_280_ = f32();
                    phi_281_ = true;
                }
                let _e133 = phi_280_;
                let _e135 = phi_281_;
                phi_282_ = _e133;
                phi_283_ = _e135;
            } else {
                phi_282_ = f32();
                phi_283_ = true;
            }
            let _e137 = phi_282_;
            let _e139 = phi_283_;
            if _e139 {
                phi_287_ = _e115;
            } else {
                phi_287_ = _e137;
            }
            let _e141 = phi_287_;
            let _e143 = (param_1 - (2f * _e141));
            if (_e143 > 1f) {
                phi_295_ = (2f - _e143);
            } else {
                phi_295_ = _e143;
            }
            let _e147 = phi_295_;
            phi_296_ = _e147;
        } else {
            phi_296_ = param_1;
        }
        let _e149 = phi_296_;
        phi_297_ = _e149;
    }
    let _e151 = phi_297_;
    if (_e151 > 0f) {
        if (_e151 < 1f) {
            phi_306_ = _e151;
        } else {
            phi_306_ = 1f;
        }
        let _e155 = phi_306_;
        phi_307_ = _e155;
    } else {
        phi_307_ = 0f;
    }
    let _e157 = phi_307_;
    let _e158 = (_e72 - 1u);
    let _e160 = (_e157 * f32(_e72));
    if _e80 {
        let _e167 = select(select(u32(_e160), 0u, (_e160 < bitcast<f32>(0u))), 4294967295u, (_e160 > bitcast<f32>(1333788671u)));
        if (_e158 < _e167) {
            phi_325_ = _e158;
        } else {
            phi_325_ = _e167;
        }
        let _e170 = phi_325_;
        phi_364_ = texture_Axis(_e170, _e170, 0f);
    } else {
        let _e172 = (_e160 + 0.5f);
        let _e179 = select(select(u32(_e172), 0u, (_e172 < bitcast<f32>(0u))), 4294967295u, (_e172 > bitcast<f32>(1333788671u)));
        if (_e72 < _e179) {
            phi_339_ = _e72;
        } else {
            phi_339_ = _e179;
        }
        let _e182 = phi_339_;
        if (_e85 == 0u) {
            phi_346_ = _e158;
        } else {
            phi_346_ = 0u;
        }
        let _e187 = phi_346_;
        if (_e85 == 0u) {
            phi_351_ = 0u;
        } else {
            phi_351_ = _e158;
        }
        let _e190 = phi_351_;
        if (_e182 == 0u) {
            phi_357_ = _e187;
        } else {
            phi_357_ = (_e182 - 1u);
        }
        let _e194 = phi_357_;
        if (_e182 > _e158) {
            phi_362_ = _e190;
        } else {
            phi_362_ = _e182;
        }
        let _e197 = phi_362_;
        phi_364_ = texture_Axis(_e194, _e197, (_e172 - f32(_e182)));
    }
    let _e200 = phi_364_;
    let _e202 = (*param).flags;
    let _e205 = ((_e202 >> bitcast<u32>(6u)) & 3u);
    if (_e205 == 0u) {
        if (param_2 > -8388608f) {
            let _e218 = f32(select(0i, select(select(i32(param_2), i32(-2147483648), (param_2 < bitcast<f32>(3472883712u))), 2147483647i, (param_2 > bitcast<f32>(1325400063u))), (param_2 == param_2)));
            if (_e218 > param_2) {
                phi_392_ = 1f;
            } else {
                phi_392_ = 0f;
            }
            let _e221 = phi_392_;
            if (param_2 < 8388608f) {
                phi_397_ = (_e218 - _e221);
                phi_398_ = false;
            } else {
                phi_397_ = f32();
                phi_398_ = true;
            }
            let _e224 = phi_397_;
            let _e226 = phi_398_;
            phi_399_ = _e224;
            phi_400_ = _e226;
        } else {
            phi_399_ = f32();
            phi_400_ = true;
        }
        let _e228 = phi_399_;
        let _e230 = phi_400_;
        if _e230 {
            phi_404_ = param_2;
        } else {
            phi_404_ = _e228;
        }
        let _e232 = phi_404_;
        phi_452_ = (param_2 - _e232);
    } else {
        if (_e205 == 1u) {
            let _e235 = (param_2 * 0.5f);
            if (_e235 > -8388608f) {
                let _e247 = f32(select(0i, select(select(i32(_e235), i32(-2147483648), (_e235 < bitcast<f32>(3472883712u))), 2147483647i, (_e235 > bitcast<f32>(1325400063u))), (_e235 == _e235)));
                if (_e247 > _e235) {
                    phi_430_ = 1f;
                } else {
                    phi_430_ = 0f;
                }
                let _e250 = phi_430_;
                if (_e235 < 8388608f) {
                    phi_435_ = (_e247 - _e250);
                    phi_436_ = false;
                } else {
                    phi_435_ = f32();
                    phi_436_ = true;
                }
                let _e253 = phi_435_;
                let _e255 = phi_436_;
                phi_437_ = _e253;
                phi_438_ = _e255;
            } else {
                phi_437_ = f32();
                phi_438_ = true;
            }
            let _e257 = phi_437_;
            let _e259 = phi_438_;
            if _e259 {
                phi_442_ = _e235;
            } else {
                phi_442_ = _e257;
            }
            let _e261 = phi_442_;
            let _e263 = (param_2 - (2f * _e261));
            if (_e263 > 1f) {
                phi_450_ = (2f - _e263);
            } else {
                phi_450_ = _e263;
            }
            let _e267 = phi_450_;
            phi_451_ = _e267;
        } else {
            phi_451_ = param_2;
        }
        let _e269 = phi_451_;
        phi_452_ = _e269;
    }
    let _e271 = phi_452_;
    if (_e271 > 0f) {
        if (_e271 < 1f) {
            phi_461_ = _e271;
        } else {
            phi_461_ = 1f;
        }
        let _e275 = phi_461_;
        phi_462_ = _e275;
    } else {
        phi_462_ = 0f;
    }
    let _e277 = phi_462_;
    let _e278 = (_e76 - 1u);
    let _e280 = (_e277 * f32(_e76));
    if _e80 {
        let _e287 = select(select(u32(_e280), 0u, (_e280 < bitcast<f32>(0u))), 4294967295u, (_e280 > bitcast<f32>(1333788671u)));
        if (_e278 < _e287) {
            phi_480_ = _e278;
        } else {
            phi_480_ = _e287;
        }
        let _e290 = phi_480_;
        phi_519_ = texture_Axis(_e290, _e290, 0f);
    } else {
        let _e292 = (_e280 + 0.5f);
        let _e299 = select(select(u32(_e292), 0u, (_e292 < bitcast<f32>(0u))), 4294967295u, (_e292 > bitcast<f32>(1333788671u)));
        if (_e76 < _e299) {
            phi_494_ = _e76;
        } else {
            phi_494_ = _e299;
        }
        let _e302 = phi_494_;
        if (_e205 == 0u) {
            phi_501_ = _e278;
        } else {
            phi_501_ = 0u;
        }
        let _e307 = phi_501_;
        if (_e205 == 0u) {
            phi_506_ = 0u;
        } else {
            phi_506_ = _e278;
        }
        let _e310 = phi_506_;
        if (_e302 == 0u) {
            phi_512_ = _e307;
        } else {
            phi_512_ = (_e302 - 1u);
        }
        let _e314 = phi_512_;
        if (_e302 > _e278) {
            phi_517_ = _e310;
        } else {
            phi_517_ = _e302;
        }
        let _e317 = phi_517_;
        phi_519_ = texture_Axis(_e314, _e317, (_e292 - f32(_e302)));
    }
    let _e320 = phi_519_;
    let _e324 = (*param).offset;
    let _e331 = (*param).offset;
    let _e338 = (*param).offset;
    let _e345 = (*param).offset;
    return texture_TexelQuad(array<u32, 4>(((_e324 + (_e320.low * _e72)) + _e200.low), ((_e331 + (_e320.low * _e72)) + _e200.high), ((_e338 + (_e320.high * _e72)) + _e200.low), ((_e345 + (_e320.high * _e72)) + _e200.high)), vec4<f32>(((1f - _e200.fraction) * (1f - _e320.fraction)), (_e200.fraction * (1f - _e320.fraction)), ((1f - _e200.fraction) * _e320.fraction), (_e200.fraction * _e320.fraction)));
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_578_: bool;
    var phi_582_: f32;

    if (param_3 != param_3) {
        phi_578_ = true;
    } else {
        let _e70 = (param_4 >= param_3);
        if _e70 {
        }
        phi_578_ = _e70;
    }
    let _e72 = phi_578_;
    if _e72 {
        phi_582_ = param_4;
    } else {
        phi_582_ = param_3;
    }
    let _e74 = phi_582_;
    return _e74;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_594_: bool;
    var phi_598_: f32;

    if (param_5 != param_5) {
        phi_594_ = true;
    } else {
        let _e70 = (param_6 <= param_5);
        if _e70 {
        }
        phi_594_ = _e70;
    }
    let _e72 = phi_594_;
    if _e72 {
        phi_598_ = param_6;
    } else {
        phi_598_ = param_5;
    }
    let _e74 = phi_598_;
    return _e74;
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var local_2: lt_bvh_traverse_Stack;
    var phi_698_: f32;
    var phi_754_: bool;
    var phi_755_: bool;
    var phi_756_: bool;
    var phi_760_: bool;
    var phi_761_: bool;
    var phi_762_: bool;
    var phi_763_: bool;
    var phi_764_: bool;
    var phi_765_: bool;
    var phi_766_: bool;
    var phi_767_: bool;
    var phi_768_: bool;
    var phi_769_: bool;
    var phi_770_: bool;
    var phi_771_: bool;
    var phi_772_: bool;
    var phi_773_: bool;
    var phi_774_: bool;
    var phi_775_: bool;
    var phi_776_: bool;
    var phi_777_: bool;
    var phi_781_: bool;
    var phi_785_: bool;
    var phi_855_: f32;
    var phi_862_: f32;
    var phi_869_: f32;
    var phi_876_: f32;
    var phi_883_: f32;
    var phi_890_: f32;
    var phi_907_: f32;
    var phi_912_: f32;
    var phi_917_: f32;
    var phi_938_: u32;
    var phi_943_: u32;
    var phi_948_: u32;
    var phi_1062_: bool;
    var phi_1063_: bool;
    var phi_1094_: u32;
    var phi_1096_: u32;
    var phi_1177_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1204_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1231_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1237_: u32;
    var phi_1240_: u32;
    var phi_1254_: u32;
    var phi_1264_: u32;
    var phi_1274_: u32;
    var phi_1292_: u32;
    var phi_1302_: u32;
    var phi_1312_: u32;
    var phi_1348_: u32;
    var phi_1361_: u32;
    var phi_1366_: u32;
    var phi_1367_: u32;
    var phi_1368_: u32;
    var phi_1238_: u32;
    var phi_1241_: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_1426_: u32;
    var phi_1476_: f32;
    var phi_1481_: f32;
    var phi_1486_: f32;
    var phi_1494_: f32;
    var phi_1499_: f32;
    var phi_1504_: f32;
    var phi_1648_: bool;
    var phi_1649_: bool;
    var phi_1650_: bool;
    var phi_1654_: bool;
    var phi_1655_: bool;
    var phi_1656_: bool;
    var phi_1657_: bool;
    var phi_1658_: bool;
    var phi_1659_: bool;
    var phi_1660_: bool;
    var phi_1661_: bool;
    var phi_1662_: bool;
    var phi_1663_: bool;
    var phi_1664_: bool;
    var phi_1665_: bool;
    var phi_1666_: bool;
    var phi_1667_: bool;
    var phi_1668_: bool;
    var phi_1669_: bool;
    var phi_1670_: bool;
    var phi_1671_: bool;
    var phi_1675_: bool;
    var phi_1679_: bool;
    var phi_1749_: f32;
    var phi_1756_: f32;
    var phi_1763_: f32;
    var phi_1770_: f32;
    var phi_1777_: f32;
    var phi_1784_: f32;
    var phi_1801_: f32;
    var phi_1806_: f32;
    var phi_1811_: f32;
    var phi_1839_: bool;
    var phi_1840_: bool;
    var phi_1848_: u32;
    var phi_1849_: u32;
    var phi_1860_: vec3<f32>;
    var phi_1861_: vec3<f32>;
    var phi_1874_: u32;
    var phi_1879_: u32;
    var phi_1884_: u32;
    var phi_1998_: bool;
    var phi_1999_: bool;
    var phi_2030_: u32;
    var phi_2032_: u32;
    var phi_2113_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2140_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2167_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2173_: u32;
    var phi_2176_: u32;
    var phi_2190_: u32;
    var phi_2200_: u32;
    var phi_2210_: u32;
    var phi_2228_: u32;
    var phi_2238_: u32;
    var phi_2248_: u32;
    var phi_2284_: u32;
    var phi_2297_: u32;
    var phi_2302_: u32;
    var phi_2303_: u32;
    var phi_2304_: u32;
    var phi_2174_: u32;
    var phi_2177_: u32;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_2362_: u32;
    var phi_2407_: vec3<f32>;
    var phi_2408_: vec3<f32>;
    var phi_2437_: vec3<f32>;
    var phi_2438_: vec3<f32>;
    var phi_2467_: vec3<f32>;
    var phi_2468_: vec3<f32>;
    var phi_2486_: bool;
    var phi_2487_: bool;
    var phi_2491_: f32;
    var phi_2492_: f32;
    var phi_2493_: f32;
    var phi_2494_: f32;
    var phi_2502_: f32;
    var phi_2512_: bool;
    var phi_2513_: bool;
    var phi_2517_: f32;
    var phi_2518_: f32;
    var phi_2519_: f32;
    var phi_2520_: f32;
    var phi_2528_: f32;
    var phi_2538_: bool;
    var phi_2539_: bool;
    var phi_2543_: f32;
    var phi_2544_: f32;
    var phi_2545_: f32;
    var phi_2546_: f32;
    var phi_2554_: f32;
    var phi_2569_: f32;
    var phi_2570_: bool;
    var phi_2571_: f32;
    var phi_2572_: bool;
    var phi_2573_: f32;
    var phi_2574_: bool;
    var phi_2592_: f32;
    var phi_2593_: bool;
    var phi_2594_: bool;
    var phi_2595_: f32;
    var phi_2596_: bool;
    var phi_2597_: bool;
    var phi_2601_: bool;
    var phi_2602_: f32;
    var phi_2603_: bool;
    var phi_2631_: vec3<f32>;
    var phi_2632_: vec3<f32>;
    var phi_2657_: vec3<f32>;
    var phi_2658_: vec3<f32>;
    var phi_2683_: vec3<f32>;
    var phi_2684_: vec3<f32>;
    var phi_2740_: f32;
    var phi_2749_: f32;
    var phi_2758_: f32;
    var phi_2767_: f32;
    var phi_2774_: f32;
    var phi_2781_: f32;
    var phi_2794_: f32;
    var phi_2803_: f32;
    var phi_2812_: f32;
    var phi_2821_: f32;
    var phi_2828_: f32;
    var phi_2835_: f32;
    var phi_2852_: f32;
    var phi_2857_: f32;
    var phi_2862_: f32;
    var phi_2870_: f32;
    var phi_2875_: f32;
    var phi_2880_: f32;
    var phi_2892_: f32;
    var phi_2897_: f32;
    var phi_2902_: f32;
    var phi_2907_: f32;
    var phi_2912_: lt_bvh_triangle_Intersection;
    var phi_2913_: bool;
    var phi_2914_: lt_bvh_triangle_Intersection;
    var phi_2915_: bool;
    var phi_2919_: lt_bvh_triangle_Intersection;
    var phi_2920_: bool;
    var phi_2921_: lt_bvh_triangle_Intersection;
    var phi_2922_: bool;
    var phi_2923_: bool;
    var phi_2927_: bool;
    var phi_2931_: lt_bvh_triangle_Intersection;
    var phi_3145_: f32;
    var phi_3148_: bool;
    var phi_3149_: bool;
    var phi_3153_: bool;
    var phi_3154_: bool;
    var phi_3155_: bool;
    var phi_3156_: bool;
    var phi_3157_: bool;
    var phi_3158_: bool;
    var phi_3159_: bool;
    var phi_3160_: bool;
    var phi_3161_: bool;
    var phi_3162_: bool;
    var phi_3163_: bool;
    var phi_3164_: bool;
    var phi_3168_: bool;
    var phi_3169_: bool;
    var phi_2363_: u32;
    var phi_3170_: bool;
    var phi_3171_: bool;
    var phi_3172_: bool;
    var local_9: bool;
    var phi_3214_: bool;
    var phi_3215_: bool;
    var phi_3246_: u32;
    var phi_3247_: u32;
    var phi_3248_: bool;
    var phi_3249_: bool;
    var phi_2033_: u32;
    var phi_3250_: bool;
    var phi_3251_: bool;
    var phi_3252_: bool;
    var phi_3253_: bool;
    var local_10: bool;
    var phi_3257_: bool;
    var phi_3258_: bool;
    var phi_3262_: bool;
    var phi_3266_: bool;
    var phi_3267_: bool;
    var phi_3268_: bool;
    var phi_3269_: bool;
    var phi_3273_: bool;
    var phi_3277_: bool;
    var phi_3278_: bool;
    var phi_3279_: bool;
    var phi_3280_: bool;
    var phi_1427_: u32;
    var phi_3284_: bool;
    var local_11: bool;
    var phi_3326_: bool;
    var phi_3327_: bool;
    var phi_3358_: u32;
    var phi_3359_: u32;
    var phi_1097_: u32;
    var phi_3360_: bool;
    var phi_3361_: bool;
    var local_12: bool;
    var phi_3365_: bool;
    var phi_3369_: bool;
    var phi_3370_: bool;
    var phi_3371_: bool;
    var phi_3372_: bool;
    var phi_3376_: bool;
    var phi_3380_: f32;
    var phi_3401_: u32;
    var phi_3416_: u32;
    var phi_3421_: u32;
    var local_13: bool;
    var local_14: bool;
    var local_15: bool;
    var local_16: bool;
    var local_17: bool;
    var local_18: bool;

    let _e70 = id_1;
    let _e77 = arrayLength((&nodes.member));
    let _e80 = arrayLength((&triangles.member));
    let _e83 = arrayLength((&visibility.member));
    let _e86 = arrayLength((&list.member));
    let _e89 = arrayLength((&bits.member));
    let _e95 = arrayLength((&vertices.member));
    let _e101 = arrayLength((&alpha_texels.member));
    let _e105 = ((_e70.y * 2097152u) + _e70.x);
    if (3u < _e86) {
    } else {
        return;
    }
    let _e108 = list.member[3u];
    if (_e105 < _e108) {
        let _e110 = (_e105 + 4u);
        if (_e110 < _e86) {
        } else {
            return;
        }
        let _e114 = list.member[(0u + _e110)];
        let _e116 = p.member.root;
        if (_e114 < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e121 = p.member.light;
        let _e123 = samples.member[(0u + _e114)].position;
        let _e125 = samples.member[(0u + _e114)].normal;
        let _e127 = samples.member[(0u + _e114)].magnitude;
        let _e129 = ((8f / 8388608f) * _e127);
        let _e137 = (_e123.x + (_e125.x * _e129));
        let _e139 = (_e123.y + (_e125.y * _e129));
        let _e141 = (_e123.z + (_e125.z * _e129));
        if (_e121.w == 0f) {
            phi_698_ = 300000000000000000000000000000000000000f;
        } else {
            phi_698_ = 1f;
        }
        let _e145 = phi_698_;
        let _e153 = (_e121.x - (_e137 * _e121.w));
        let _e154 = (_e121.y - (_e139 * _e121.w));
        let _e155 = (_e121.z - (_e141 * _e121.w));
        let _e159 = abs(_e153);
        let _e160 = abs(_e154);
        let _e161 = abs(_e155);
        if (abs(_e137) < 1000000000000000f) {
            if (abs(_e139) < 1000000000000000f) {
                if (abs(_e141) < 1000000000000000f) {
                    if (_e159 < 1000000000000000f) {
                        if (_e160 < 1000000000000000f) {
                            if (_e161 < 1000000000000000f) {
                                if (_e159 > 0f) {
                                    phi_755_ = bool();
                                    phi_756_ = true;
                                } else {
                                    let _e169 = (_e160 > 0f);
                                    if _e169 {
                                        phi_754_ = bool();
                                    } else {
                                        phi_754_ = (_e161 > 0f);
                                    }
                                    let _e172 = phi_754_;
                                    phi_755_ = _e172;
                                    phi_756_ = _e169;
                                }
                                let _e174 = phi_755_;
                                let _e176 = phi_756_;
                                if _e176 {
                                    phi_760_ = true;
                                } else {
                                    phi_760_ = _e174;
                                }
                                let _e178 = phi_760_;
                                phi_761_ = _e178;
                                phi_762_ = false;
                            } else {
                                phi_761_ = bool();
                                phi_762_ = true;
                            }
                            let _e180 = phi_761_;
                            let _e182 = phi_762_;
                            phi_763_ = _e180;
                            phi_764_ = false;
                            phi_765_ = _e182;
                        } else {
                            phi_763_ = bool();
                            phi_764_ = true;
                            phi_765_ = false;
                        }
                        let _e184 = phi_763_;
                        let _e186 = phi_764_;
                        let _e188 = phi_765_;
                        phi_766_ = _e184;
                        phi_767_ = _e186;
                        phi_768_ = _e188;
                    } else {
                        phi_766_ = bool();
                        phi_767_ = true;
                        phi_768_ = false;
                    }
                    let _e190 = phi_766_;
                    let _e192 = phi_767_;
                    let _e194 = phi_768_;
                    phi_769_ = _e190;
                    phi_770_ = _e192;
                    phi_771_ = _e194;
                } else {
                    phi_769_ = bool();
                    phi_770_ = true;
                    phi_771_ = false;
                }
                let _e196 = phi_769_;
                let _e198 = phi_770_;
                let _e200 = phi_771_;
                phi_772_ = _e196;
                phi_773_ = _e198;
                phi_774_ = _e200;
            } else {
                phi_772_ = bool();
                phi_773_ = true;
                phi_774_ = false;
            }
            let _e202 = phi_772_;
            let _e204 = phi_773_;
            let _e206 = phi_774_;
            phi_775_ = _e202;
            phi_776_ = _e204;
            phi_777_ = _e206;
        } else {
            phi_775_ = bool();
            phi_776_ = true;
            phi_777_ = false;
        }
        let _e208 = phi_775_;
        let _e210 = phi_776_;
        let _e212 = phi_777_;
        if _e210 {
            phi_781_ = true;
        } else {
            phi_781_ = _e212;
        }
        let _e214 = phi_781_;
        if _e214 {
            phi_785_ = false;
        } else {
            phi_785_ = _e208;
        }
        let _e216 = phi_785_;
        if _e216 {
            let _e217 = (_e116 >= _e77);
            if _e217 {
                phi_3370_ = bool();
            } else {
                if (_e116 < _e77) {
                } else {
                    return;
                }
                let _e223 = nodes.member[(0u + _e116)].frame[0u];
                let _e227 = nodes.member[(0u + _e116)].frame[1u];
                let _e231 = nodes.member[(0u + _e116)].frame[2u];
                let _e235 = nodes.member[(0u + _e116)].frame[0u];
                let _e239 = nodes.member[(0u + _e116)].frame[1u];
                let _e243 = nodes.member[(0u + _e116)].frame[2u];
                let _e247 = nodes.member[(0u + _e116)].frame[3u];
                let _e281 = core_intrinsics_maximum_number_nsz_f32_(abs(_e153), abs(_e154));
                let _e282 = core_intrinsics_maximum_number_nsz_f32_(_e281, abs(_e155));
                let _e283 = (_e282 * 0.0000000000009094947f);
                if (abs(_e153) < _e283) {
                    phi_855_ = _e283;
                } else {
                    phi_855_ = abs(_e153);
                }
                let _e288 = phi_855_;
                if (_e153 < 0f) {
                    phi_862_ = (-1f / _e288);
                } else {
                    phi_862_ = (1f / _e288);
                }
                let _e293 = phi_862_;
                if (abs(_e154) < _e283) {
                    phi_869_ = _e283;
                } else {
                    phi_869_ = abs(_e154);
                }
                let _e298 = phi_869_;
                if (_e154 < 0f) {
                    phi_876_ = (-1f / _e298);
                } else {
                    phi_876_ = (1f / _e298);
                }
                let _e303 = phi_876_;
                if (abs(_e155) < _e283) {
                    phi_883_ = _e283;
                } else {
                    phi_883_ = abs(_e155);
                }
                let _e308 = phi_883_;
                if (_e155 < 0f) {
                    phi_890_ = (-1f / _e308);
                } else {
                    phi_890_ = (1f / _e308);
                }
                let _e313 = phi_890_;
                let _e317 = abs((bitcast<f32>(_e223) - _e137));
                let _e318 = abs((bitcast<f32>(_e227) - _e139));
                let _e319 = abs((bitcast<f32>(_e231) - _e141));
                let _e323 = abs(((bitcast<f32>(_e235) + (bitcast<f32>((((_e247 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e137));
                let _e324 = abs(((bitcast<f32>(_e239) + (bitcast<f32>((((_e247 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e139));
                let _e325 = abs(((bitcast<f32>(_e243) + (bitcast<f32>((((_e247 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e141));
                if (_e317 > _e323) {
                    phi_907_ = _e317;
                } else {
                    phi_907_ = _e323;
                }
                let _e328 = phi_907_;
                if (_e318 > _e324) {
                    phi_912_ = _e318;
                } else {
                    phi_912_ = _e324;
                }
                let _e331 = phi_912_;
                if (_e319 > _e325) {
                    phi_917_ = _e319;
                } else {
                    phi_917_ = _e325;
                }
                let _e334 = phi_917_;
                let _e335 = core_intrinsics_maximum_number_nsz_f32_(_e328, _e331);
                let _e336 = core_intrinsics_maximum_number_nsz_f32_(_e335, _e334);
                let _e340 = (_e336 * 0.0000019073486f);
                let _e341 = (abs(_e293) * _e340);
                let _e342 = (abs(_e303) * _e340);
                let _e343 = (abs(_e313) * _e340);
                let _e347 = (_e336 * 0.0000009536743f);
                let _e348 = (abs(_e293) * _e347);
                let _e349 = (abs(_e303) * _e347);
                let _e350 = (abs(_e313) * _e347);
                if (_e293 < 0f) {
                    phi_938_ = 0u;
                } else {
                    phi_938_ = 1u;
                }
                let _e353 = phi_938_;
                if (_e303 < 0f) {
                    phi_943_ = 0u;
                } else {
                    phi_943_ = 2u;
                }
                let _e356 = phi_943_;
                if (_e313 < 0f) {
                    phi_948_ = 0u;
                } else {
                    phi_948_ = 4u;
                }
                let _e359 = phi_948_;
                let _e361 = ((_e353 | _e356) | _e359);
                let _e362 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e116, 2147483648u);
                local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e362.first[0], _e362.first[1], _e362.first[2], _e362.first[3], _e362.first[4], _e362.first[5], _e362.first[6], _e362.first[7], _e362.first[8], _e362.first[9], _e362.first[10], _e362.first[11], _e362.first[12], _e362.first[13], _e362.first[14], _e362.first[15], _e362.first[16], _e362.first[17], _e362.first[18], _e362.first[19], _e362.first[20], _e362.first[21], _e362.first[22], _e362.first[23], _e362.first[24], _e362.first[25], _e362.first[26], _e362.first[27], _e362.first[28], _e362.first[29], _e362.first[30], _e362.first[31]), array<u32, 32>(_e362.mask[0], _e362.mask[1], _e362.mask[2], _e362.mask[3], _e362.mask[4], _e362.mask[5], _e362.mask[6], _e362.mask[7], _e362.mask[8], _e362.mask[9], _e362.mask[10], _e362.mask[11], _e362.mask[12], _e362.mask[13], _e362.mask[14], _e362.mask[15], _e362.mask[16], _e362.mask[17], _e362.mask[18], _e362.mask[19], _e362.mask[20], _e362.mask[21], _e362.mask[22], _e362.mask[23], _e362.mask[24], _e362.mask[25], _e362.mask[26], _e362.mask[27], _e362.mask[28], _e362.mask[29], _e362.mask[30], _e362.mask[31]), _e362.len, _e362.group, _e362.group_mask);
                let _e436 = local_2.group_mask;
                if ((_e436 & 4278190080u) == 0u) {
                    let _e440 = local_2.len;
                    if (_e440 == 0u) {
                        phi_1062_ = false;
                    } else {
                        let _e444 = local_2.len;
                        local_2.len = (_e444 - 1u);
                        let _e447 = local_2.len;
                        if (_e447 < 32u) {
                        } else {
                            return;
                        }
                        let _e452 = local_2.first[(0u + _e447)];
                        local_2.group = _e452;
                        let _e455 = local_2.len;
                        if (_e455 < 32u) {
                        } else {
                            return;
                        }
                        let _e460 = local_2.mask[(0u + _e455)];
                        local_2.group_mask = _e460;
                        phi_1062_ = true;
                    }
                    let _e463 = phi_1062_;
                    phi_1063_ = _e463;
                } else {
                    phi_1063_ = true;
                }
                let _e465 = phi_1063_;
                if _e465 {
                    let _e467 = local_2.group_mask;
                    let _e473 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e467)), 32u, (_e467 == 0u)));
                    let _e477 = local_2.group_mask;
                    let _e491 = local_2.group_mask;
                    local_2.group_mask = (_e491 & ~((1u << bitcast<u32>((_e473 & 31u)))));
                    let _e494 = local_2.group;
                    phi_1094_ = (_e494 + countOneBits(((_e477 & ~((4294967295u << bitcast<u32>((((_e473 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1094_ = 4294967295u;
                }
                let _e497 = phi_1094_;
                phi_1096_ = _e497;
                loop {
                    let _e499 = phi_1096_;
                    if (_e499 != 4294967295u) {
                        if (_e499 < _e77) {
                        } else {
                            return;
                        }
                        let _e506 = nodes.member[(0u + _e499)].frame[3u];
                        let _e531 = (bitcast<f32>((((_e506 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e293);
                        let _e532 = (bitcast<f32>((((_e506 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e303);
                        let _e533 = (bitcast<f32>((((_e506 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e313);
                        let _e536 = nodes.member[(0u + _e499)].frame[0u];
                        let _e540 = nodes.member[(0u + _e499)].frame[1u];
                        let _e544 = nodes.member[(0u + _e499)].frame[2u];
                        let _e549 = ((bitcast<f32>(_e536) - _e137) * _e293);
                        let _e550 = ((bitcast<f32>(_e540) - _e139) * _e303);
                        let _e551 = ((bitcast<f32>(_e544) - _e141) * _e313);
                        let _e559 = nodes.member[(0u + _e499)].x;
                        if (_e293 < 0f) {
                            let _e570 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e559.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e576 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e570.unnamed.root, _e559.w), _e570.unnamed_1);
                            let _e582 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e576.unnamed, lt_bvh_traverse_Tree(_e559.x, _e576.unnamed_1.first_primitive));
                            phi_1177_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e582.unnamed, lt_bvh_traverse_Tree(_e582.unnamed_1.root, _e559.y));
                        } else {
                            let _e598 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e559.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e604 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e598.unnamed.root, _e559.y), _e598.unnamed_1);
                            let _e610 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e604.unnamed, lt_bvh_traverse_Tree(_e559.z, _e604.unnamed_1.first_primitive));
                            phi_1177_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e610.unnamed, lt_bvh_traverse_Tree(_e610.unnamed_1.root, _e559.w));
                        }
                        let _e618 = phi_1177_;
                        let _e628 = nodes.member[(0u + _e499)].y;
                        if (_e303 < 0f) {
                            let _e639 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e628.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e645 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e639.unnamed.root, _e628.w), _e639.unnamed_1);
                            let _e651 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e645.unnamed, lt_bvh_traverse_Tree(_e628.x, _e645.unnamed_1.first_primitive));
                            phi_1204_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e651.unnamed, lt_bvh_traverse_Tree(_e651.unnamed_1.root, _e628.y));
                        } else {
                            let _e667 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e628.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e673 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e667.unnamed.root, _e628.y), _e667.unnamed_1);
                            let _e679 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e673.unnamed, lt_bvh_traverse_Tree(_e628.z, _e673.unnamed_1.first_primitive));
                            phi_1204_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e679.unnamed, lt_bvh_traverse_Tree(_e679.unnamed_1.root, _e628.w));
                        }
                        let _e687 = phi_1204_;
                        let _e697 = nodes.member[(0u + _e499)].z;
                        if (_e313 < 0f) {
                            let _e708 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e697.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e714 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e708.unnamed.root, _e697.w), _e708.unnamed_1);
                            let _e720 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e714.unnamed, lt_bvh_traverse_Tree(_e697.x, _e714.unnamed_1.first_primitive));
                            phi_1231_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e720.unnamed, lt_bvh_traverse_Tree(_e720.unnamed_1.root, _e697.y));
                        } else {
                            let _e736 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e697.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e742 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e736.unnamed.root, _e697.y), _e736.unnamed_1);
                            let _e748 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e742.unnamed, lt_bvh_traverse_Tree(_e697.z, _e742.unnamed_1.first_primitive));
                            phi_1231_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e748.unnamed, lt_bvh_traverse_Tree(_e748.unnamed_1.root, _e697.w));
                        }
                        let _e756 = phi_1231_;
                        phi_1237_ = 0u;
                        phi_1240_ = 0u;
                        loop {
                            let _e766 = phi_1237_;
                            let _e768 = phi_1240_;
                            local_3 = _e768;
                            local_4 = _e768;
                            local_5 = _e768;
                            let _e769 = (_e766 < 8u);
                            if _e769 {
                                let _e771 = (_e766 >> bitcast<u32>(2i));
                                let _e772 = (_e766 & 3u);
                                if (_e771 == 0u) {
                                    phi_1254_ = _e618.unnamed.root;
                                } else {
                                    phi_1254_ = _e618.unnamed.first_primitive;
                                }
                                let _e775 = phi_1254_;
                                if (_e771 == 0u) {
                                    phi_1264_ = _e687.unnamed.root;
                                } else {
                                    phi_1264_ = _e687.unnamed.first_primitive;
                                }
                                let _e784 = phi_1264_;
                                if (_e771 == 0u) {
                                    phi_1274_ = _e756.unnamed.root;
                                } else {
                                    phi_1274_ = _e756.unnamed.first_primitive;
                                }
                                let _e793 = phi_1274_;
                                let _e806 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e775 >> bitcast<u32>(((_e772 * 8u) & 31u))) & 255u)) * _e531) + (_e549 - _e341)), ((f32(((_e784 >> bitcast<u32>(((_e772 * 8u) & 31u))) & 255u)) * _e532) + (_e550 - _e342)));
                                let _e807 = core_intrinsics_maximum_number_nsz_f32_(_e806, ((f32(((_e793 >> bitcast<u32>(((_e772 * 8u) & 31u))) & 255u)) * _e533) + (_e551 - _e343)));
                                if (_e771 == 0u) {
                                    phi_1292_ = _e618.unnamed_1.root;
                                } else {
                                    phi_1292_ = _e618.unnamed_1.first_primitive;
                                }
                                let _e810 = phi_1292_;
                                if (_e771 == 0u) {
                                    phi_1302_ = _e687.unnamed_1.root;
                                } else {
                                    phi_1302_ = _e687.unnamed_1.first_primitive;
                                }
                                let _e819 = phi_1302_;
                                if (_e771 == 0u) {
                                    phi_1312_ = _e756.unnamed_1.root;
                                } else {
                                    phi_1312_ = _e756.unnamed_1.first_primitive;
                                }
                                let _e828 = phi_1312_;
                                let _e841 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e810 >> bitcast<u32>(((_e772 * 8u) & 31u))) & 255u)) * _e531) + (_e549 + _e341)), ((f32(((_e819 >> bitcast<u32>(((_e772 * 8u) & 31u))) & 255u)) * _e532) + (_e550 + _e342)));
                                let _e842 = core_intrinsics_minimum_number_nsz_f32_(_e841, ((f32(((_e828 >> bitcast<u32>(((_e772 * 8u) & 31u))) & 255u)) * _e533) + (_e551 + _e343)));
                                if (_e807 <= _e842) {
                                    if (_e807 <= _e145) {
                                        if (_e842 >= 0f) {
                                            if (_e771 == 0u) {
                                                let _e849 = nodes.member[(0u + _e499)].links[2u];
                                                phi_1348_ = _e849;
                                            } else {
                                                let _e852 = nodes.member[(0u + _e499)].links[3u];
                                                phi_1348_ = _e852;
                                            }
                                            let _e854 = phi_1348_;
                                            let _e859 = ((_e854 >> bitcast<u32>(((_e772 * 8u) & 31u))) & 255u);
                                            let _e860 = (_e859 & 31u);
                                            if (_e860 >= 24u) {
                                                phi_1361_ = (24u + ((_e860 - 24u) ^ _e361));
                                            } else {
                                                phi_1361_ = _e860;
                                            }
                                            let _e866 = phi_1361_;
                                            phi_1366_ = (_e768 | ((_e859 >> bitcast<u32>(5i)) << bitcast<u32>((_e866 & 31u))));
                                        } else {
                                            phi_1366_ = _e768;
                                        }
                                        let _e874 = phi_1366_;
                                        phi_1367_ = _e874;
                                    } else {
                                        phi_1367_ = _e768;
                                    }
                                    let _e876 = phi_1367_;
                                    phi_1368_ = _e876;
                                } else {
                                    phi_1368_ = _e768;
                                }
                                let _e878 = phi_1368_;
                                phi_1238_ = (_e766 + 1u);
                                phi_1241_ = _e878;
                            } else {
                                phi_1238_ = u32();
                                phi_1241_ = u32();
                            }
                            let _e881 = phi_1238_;
                            let _e883 = phi_1241_;
                            continue;
                            continuing {
                                phi_1237_ = _e881;
                                phi_1240_ = _e883;
                                break if !(_e769);
                            }
                        }
                        let _e887 = nodes.member[(0u + _e499)].links[0u];
                        let _e891 = nodes.member[(0u + _e499)].frame[3u];
                        let _e895 = local_3;
                        if ((_e895 & 4278190080u) == 0u) {
                        } else {
                            let _e899 = local_2.group_mask;
                            if ((_e899 & 4278190080u) == 0u) {
                            } else {
                                let _e903 = local_2.len;
                                if (_e903 < 32u) {
                                    let _e906 = local_2.group;
                                    let _e908 = local_2.len;
                                    if (_e908 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.first[(0u + _e908)] = _e906;
                                    let _e914 = local_2.group_mask;
                                    let _e916 = local_2.len;
                                    if (_e916 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.mask[(0u + _e916)] = _e914;
                                    let _e923 = local_2.len;
                                    local_2.len = (_e923 + 1u);
                                }
                            }
                            local_2.group = (_e116 + _e887);
                            let _e927 = local_4;
                            local_2.group_mask = ((_e927 & 4278190080u) | (_e891 >> bitcast<u32>(24i)));
                        }
                        let _e932 = local_5;
                        phi_1426_ = (_e932 & 16777215u);
                        loop {
                            let _e935 = phi_1426_;
                            let _e936 = (_e935 == 0u);
                            local_11 = _e936;
                            local_18 = _e936;
                            if _e936 {
                                phi_1427_ = u32();
                                phi_3284_ = false;
                            } else {
                                let _e939 = nodes.member[(0u + _e499)].links[1u];
                                let _e943 = (_e939 + select(firstTrailingBit(_e935), 32u, (_e935 == 0u)));
                                if (_e943 < arrayLength((&instances.member))) {
                                } else {
                                    return;
                                }
                                let _e950 = instances.member[(0u + _e943)].low_world;
                                let _e952 = instances.member[(0u + _e943)].high_world;
                                let _e959 = ((_e950.x - _e137) * _e293);
                                let _e960 = ((_e950.y - _e139) * _e303);
                                let _e961 = ((_e950.z - _e141) * _e313);
                                let _e968 = ((_e952.x - _e137) * _e293);
                                let _e969 = ((_e952.y - _e139) * _e303);
                                let _e970 = ((_e952.z - _e141) * _e313);
                                if (_e959 < _e968) {
                                    phi_1476_ = _e959;
                                } else {
                                    phi_1476_ = _e968;
                                }
                                let _e973 = phi_1476_;
                                if (_e960 < _e969) {
                                    phi_1481_ = _e960;
                                } else {
                                    phi_1481_ = _e969;
                                }
                                let _e976 = phi_1481_;
                                if (_e961 < _e970) {
                                    phi_1486_ = _e961;
                                } else {
                                    phi_1486_ = _e970;
                                }
                                let _e979 = phi_1486_;
                                if (_e959 > _e968) {
                                    phi_1494_ = _e959;
                                } else {
                                    phi_1494_ = _e968;
                                }
                                let _e985 = phi_1494_;
                                if (_e960 > _e969) {
                                    phi_1499_ = _e960;
                                } else {
                                    phi_1499_ = _e969;
                                }
                                let _e988 = phi_1499_;
                                if (_e961 > _e970) {
                                    phi_1504_ = _e961;
                                } else {
                                    phi_1504_ = _e970;
                                }
                                let _e991 = phi_1504_;
                                let _e995 = core_intrinsics_maximum_number_nsz_f32_((_e973 - _e348), (_e976 - _e349));
                                let _e996 = core_intrinsics_maximum_number_nsz_f32_(_e995, (_e979 - _e350));
                                let _e997 = core_intrinsics_minimum_number_nsz_f32_((_e985 + _e348), (_e988 + _e349));
                                let _e998 = core_intrinsics_minimum_number_nsz_f32_(_e997, (_e991 + _e350));
                                if (_e996 <= _e998) {
                                    if (_e996 <= _e145) {
                                        if (_e998 >= 0f) {
                                            let _e1004 = instances.member[(0u + _e943)].world_to_object[0u];
                                            let _e1015 = ((((_e1004.x * _e137) + (_e1004.y * _e139)) + (_e1004.z * _e141)) + (_e1004.w * 1f));
                                            let _e1017 = instances.member[(0u + _e943)].world_to_object[1u];
                                            let _e1028 = ((((_e1017.x * _e137) + (_e1017.y * _e139)) + (_e1017.z * _e141)) + (_e1017.w * 1f));
                                            let _e1030 = instances.member[(0u + _e943)].world_to_object[2u];
                                            let _e1041 = ((((_e1030.x * _e137) + (_e1030.y * _e139)) + (_e1030.z * _e141)) + (_e1030.w * 1f));
                                            let _e1044 = instances.member[(0u + _e943)].world_to_object[0u];
                                            let _e1055 = ((((_e1044.x * _e153) + (_e1044.y * _e154)) + (_e1044.z * _e155)) + (_e1044.w * 0f));
                                            let _e1057 = instances.member[(0u + _e943)].world_to_object[1u];
                                            let _e1068 = ((((_e1057.x * _e153) + (_e1057.y * _e154)) + (_e1057.z * _e155)) + (_e1057.w * 0f));
                                            let _e1070 = instances.member[(0u + _e943)].world_to_object[2u];
                                            let _e1081 = ((((_e1070.x * _e153) + (_e1070.y * _e154)) + (_e1070.z * _e155)) + (_e1070.w * 0f));
                                            let _e1084 = instances.member[(0u + _e943)].root;
                                            let _e1086 = instances.member[(0u + _e943)].first_triangle;
                                            let _e1090 = abs(_e1055);
                                            let _e1091 = abs(_e1068);
                                            let _e1092 = abs(_e1081);
                                            if (abs(_e1015) < 1000000000000000f) {
                                                if (abs(_e1028) < 1000000000000000f) {
                                                    if (abs(_e1041) < 1000000000000000f) {
                                                        if (_e1090 < 1000000000000000f) {
                                                            if (_e1091 < 1000000000000000f) {
                                                                if (_e1092 < 1000000000000000f) {
                                                                    if (_e1090 > 0f) {
                                                                        phi_1649_ = bool();
                                                                        phi_1650_ = true;
                                                                    } else {
                                                                        let _e1100 = (_e1091 > 0f);
                                                                        if _e1100 {
                                                                            phi_1648_ = bool();
                                                                        } else {
                                                                            phi_1648_ = (_e1092 > 0f);
                                                                        }
                                                                        let _e1103 = phi_1648_;
                                                                        phi_1649_ = _e1103;
                                                                        phi_1650_ = _e1100;
                                                                    }
                                                                    let _e1105 = phi_1649_;
                                                                    let _e1107 = phi_1650_;
                                                                    if _e1107 {
                                                                        phi_1654_ = true;
                                                                    } else {
                                                                        phi_1654_ = _e1105;
                                                                    }
                                                                    let _e1109 = phi_1654_;
                                                                    phi_1655_ = _e1109;
                                                                    phi_1656_ = false;
                                                                } else {
                                                                    phi_1655_ = bool();
                                                                    phi_1656_ = true;
                                                                }
                                                                let _e1111 = phi_1655_;
                                                                let _e1113 = phi_1656_;
                                                                phi_1657_ = _e1111;
                                                                phi_1658_ = false;
                                                                phi_1659_ = _e1113;
                                                            } else {
                                                                phi_1657_ = bool();
                                                                phi_1658_ = true;
                                                                phi_1659_ = false;
                                                            }
                                                            let _e1115 = phi_1657_;
                                                            let _e1117 = phi_1658_;
                                                            let _e1119 = phi_1659_;
                                                            phi_1660_ = _e1115;
                                                            phi_1661_ = _e1117;
                                                            phi_1662_ = _e1119;
                                                        } else {
                                                            phi_1660_ = bool();
                                                            phi_1661_ = true;
                                                            phi_1662_ = false;
                                                        }
                                                        let _e1121 = phi_1660_;
                                                        let _e1123 = phi_1661_;
                                                        let _e1125 = phi_1662_;
                                                        phi_1663_ = _e1121;
                                                        phi_1664_ = _e1123;
                                                        phi_1665_ = _e1125;
                                                    } else {
                                                        phi_1663_ = bool();
                                                        phi_1664_ = true;
                                                        phi_1665_ = false;
                                                    }
                                                    let _e1127 = phi_1663_;
                                                    let _e1129 = phi_1664_;
                                                    let _e1131 = phi_1665_;
                                                    phi_1666_ = _e1127;
                                                    phi_1667_ = _e1129;
                                                    phi_1668_ = _e1131;
                                                } else {
                                                    phi_1666_ = bool();
                                                    phi_1667_ = true;
                                                    phi_1668_ = false;
                                                }
                                                let _e1133 = phi_1666_;
                                                let _e1135 = phi_1667_;
                                                let _e1137 = phi_1668_;
                                                phi_1669_ = _e1133;
                                                phi_1670_ = _e1135;
                                                phi_1671_ = _e1137;
                                            } else {
                                                phi_1669_ = bool();
                                                phi_1670_ = true;
                                                phi_1671_ = false;
                                            }
                                            let _e1139 = phi_1669_;
                                            let _e1141 = phi_1670_;
                                            let _e1143 = phi_1671_;
                                            if _e1141 {
                                                phi_1675_ = true;
                                            } else {
                                                phi_1675_ = _e1143;
                                            }
                                            let _e1145 = phi_1675_;
                                            if _e1145 {
                                                phi_1679_ = false;
                                            } else {
                                                phi_1679_ = _e1139;
                                            }
                                            let _e1147 = phi_1679_;
                                            if _e1147 {
                                                let _e1148 = (_e1084 >= _e77);
                                                if _e1148 {
                                                    phi_3267_ = bool();
                                                } else {
                                                    if (_e1084 < _e77) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1154 = nodes.member[(0u + _e1084)].frame[0u];
                                                    let _e1158 = nodes.member[(0u + _e1084)].frame[1u];
                                                    let _e1162 = nodes.member[(0u + _e1084)].frame[2u];
                                                    let _e1166 = nodes.member[(0u + _e1084)].frame[0u];
                                                    let _e1170 = nodes.member[(0u + _e1084)].frame[1u];
                                                    let _e1174 = nodes.member[(0u + _e1084)].frame[2u];
                                                    let _e1178 = nodes.member[(0u + _e1084)].frame[3u];
                                                    let _e1212 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1055), abs(_e1068));
                                                    let _e1213 = core_intrinsics_maximum_number_nsz_f32_(_e1212, abs(_e1081));
                                                    let _e1214 = (_e1213 * 0.0000000000009094947f);
                                                    if (abs(_e1055) < _e1214) {
                                                        phi_1749_ = _e1214;
                                                    } else {
                                                        phi_1749_ = abs(_e1055);
                                                    }
                                                    let _e1219 = phi_1749_;
                                                    if (_e1055 < 0f) {
                                                        phi_1756_ = (-1f / _e1219);
                                                    } else {
                                                        phi_1756_ = (1f / _e1219);
                                                    }
                                                    let _e1224 = phi_1756_;
                                                    if (abs(_e1068) < _e1214) {
                                                        phi_1763_ = _e1214;
                                                    } else {
                                                        phi_1763_ = abs(_e1068);
                                                    }
                                                    let _e1229 = phi_1763_;
                                                    if (_e1068 < 0f) {
                                                        phi_1770_ = (-1f / _e1229);
                                                    } else {
                                                        phi_1770_ = (1f / _e1229);
                                                    }
                                                    let _e1234 = phi_1770_;
                                                    if (abs(_e1081) < _e1214) {
                                                        phi_1777_ = _e1214;
                                                    } else {
                                                        phi_1777_ = abs(_e1081);
                                                    }
                                                    let _e1239 = phi_1777_;
                                                    if (_e1081 < 0f) {
                                                        phi_1784_ = (-1f / _e1239);
                                                    } else {
                                                        phi_1784_ = (1f / _e1239);
                                                    }
                                                    let _e1244 = phi_1784_;
                                                    let _e1248 = abs((bitcast<f32>(_e1154) - _e1015));
                                                    let _e1249 = abs((bitcast<f32>(_e1158) - _e1028));
                                                    let _e1250 = abs((bitcast<f32>(_e1162) - _e1041));
                                                    let _e1254 = abs(((bitcast<f32>(_e1166) + (bitcast<f32>((((_e1178 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1015));
                                                    let _e1255 = abs(((bitcast<f32>(_e1170) + (bitcast<f32>((((_e1178 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1028));
                                                    let _e1256 = abs(((bitcast<f32>(_e1174) + (bitcast<f32>((((_e1178 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1041));
                                                    if (_e1248 > _e1254) {
                                                        phi_1801_ = _e1248;
                                                    } else {
                                                        phi_1801_ = _e1254;
                                                    }
                                                    let _e1259 = phi_1801_;
                                                    if (_e1249 > _e1255) {
                                                        phi_1806_ = _e1249;
                                                    } else {
                                                        phi_1806_ = _e1255;
                                                    }
                                                    let _e1262 = phi_1806_;
                                                    if (_e1250 > _e1256) {
                                                        phi_1811_ = _e1250;
                                                    } else {
                                                        phi_1811_ = _e1256;
                                                    }
                                                    let _e1265 = phi_1811_;
                                                    let _e1266 = core_intrinsics_maximum_number_nsz_f32_(_e1259, _e1262);
                                                    let _e1267 = core_intrinsics_maximum_number_nsz_f32_(_e1266, _e1265);
                                                    let _e1271 = (_e1267 * 0.0000019073486f);
                                                    let _e1272 = (abs(_e1224) * _e1271);
                                                    let _e1273 = (abs(_e1234) * _e1271);
                                                    let _e1274 = (abs(_e1244) * _e1271);
                                                    let _e1278 = (_e1267 * 0.0000009536743f);
                                                    let _e1279 = (abs(_e1224) * _e1278);
                                                    let _e1280 = (abs(_e1234) * _e1278);
                                                    let _e1281 = (abs(_e1244) * _e1278);
                                                    let _e1282 = abs(_e1055);
                                                    let _e1283 = abs(_e1068);
                                                    let _e1284 = abs(_e1081);
                                                    if (_e1282 >= _e1283) {
                                                        if (_e1282 >= _e1284) {
                                                            phi_1839_ = false;
                                                        } else {
                                                            phi_1839_ = true;
                                                        }
                                                        let _e1288 = phi_1839_;
                                                        phi_1840_ = _e1288;
                                                    } else {
                                                        phi_1840_ = true;
                                                    }
                                                    let _e1290 = phi_1840_;
                                                    if _e1290 {
                                                        if (_e1283 >= _e1284) {
                                                            phi_1848_ = 1u;
                                                        } else {
                                                            phi_1848_ = 2u;
                                                        }
                                                        let _e1293 = phi_1848_;
                                                        phi_1849_ = _e1293;
                                                    } else {
                                                        phi_1849_ = 0u;
                                                    }
                                                    let _e1295 = phi_1849_;
                                                    if (_e1295 == 0u) {
                                                        phi_1861_ = vec3<f32>(_e1068, _e1081, _e1055);
                                                    } else {
                                                        if (_e1295 == 1u) {
                                                            phi_1860_ = vec3<f32>(_e1081, _e1055, _e1068);
                                                        } else {
                                                            phi_1860_ = vec3<f32>(_e1055, _e1068, _e1081);
                                                        }
                                                        let _e1301 = phi_1860_;
                                                        phi_1861_ = _e1301;
                                                    }
                                                    let _e1303 = phi_1861_;
                                                    let _e1306 = (_e1303.x / _e1303.z);
                                                    let _e1309 = (_e1303.y / _e1303.z);
                                                    if (_e1224 < 0f) {
                                                        phi_1874_ = 0u;
                                                    } else {
                                                        phi_1874_ = 1u;
                                                    }
                                                    let _e1314 = phi_1874_;
                                                    if (_e1234 < 0f) {
                                                        phi_1879_ = 0u;
                                                    } else {
                                                        phi_1879_ = 2u;
                                                    }
                                                    let _e1317 = phi_1879_;
                                                    if (_e1244 < 0f) {
                                                        phi_1884_ = 0u;
                                                    } else {
                                                        phi_1884_ = 4u;
                                                    }
                                                    let _e1320 = phi_1884_;
                                                    let _e1322 = ((_e1314 | _e1317) | _e1320);
                                                    let _e1323 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1084, 2147483648u);
                                                    local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e1323.first[0], _e1323.first[1], _e1323.first[2], _e1323.first[3], _e1323.first[4], _e1323.first[5], _e1323.first[6], _e1323.first[7], _e1323.first[8], _e1323.first[9], _e1323.first[10], _e1323.first[11], _e1323.first[12], _e1323.first[13], _e1323.first[14], _e1323.first[15], _e1323.first[16], _e1323.first[17], _e1323.first[18], _e1323.first[19], _e1323.first[20], _e1323.first[21], _e1323.first[22], _e1323.first[23], _e1323.first[24], _e1323.first[25], _e1323.first[26], _e1323.first[27], _e1323.first[28], _e1323.first[29], _e1323.first[30], _e1323.first[31]), array<u32, 32>(_e1323.mask[0], _e1323.mask[1], _e1323.mask[2], _e1323.mask[3], _e1323.mask[4], _e1323.mask[5], _e1323.mask[6], _e1323.mask[7], _e1323.mask[8], _e1323.mask[9], _e1323.mask[10], _e1323.mask[11], _e1323.mask[12], _e1323.mask[13], _e1323.mask[14], _e1323.mask[15], _e1323.mask[16], _e1323.mask[17], _e1323.mask[18], _e1323.mask[19], _e1323.mask[20], _e1323.mask[21], _e1323.mask[22], _e1323.mask[23], _e1323.mask[24], _e1323.mask[25], _e1323.mask[26], _e1323.mask[27], _e1323.mask[28], _e1323.mask[29], _e1323.mask[30], _e1323.mask[31]), _e1323.len, _e1323.group, _e1323.group_mask);
                                                    let _e1397 = local_1.group_mask;
                                                    if ((_e1397 & 4278190080u) == 0u) {
                                                        let _e1401 = local_1.len;
                                                        if (_e1401 == 0u) {
                                                            phi_1998_ = false;
                                                        } else {
                                                            let _e1405 = local_1.len;
                                                            local_1.len = (_e1405 - 1u);
                                                            let _e1408 = local_1.len;
                                                            if (_e1408 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1413 = local_1.first[(0u + _e1408)];
                                                            local_1.group = _e1413;
                                                            let _e1416 = local_1.len;
                                                            if (_e1416 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1421 = local_1.mask[(0u + _e1416)];
                                                            local_1.group_mask = _e1421;
                                                            phi_1998_ = true;
                                                        }
                                                        let _e1424 = phi_1998_;
                                                        phi_1999_ = _e1424;
                                                    } else {
                                                        phi_1999_ = true;
                                                    }
                                                    let _e1426 = phi_1999_;
                                                    if _e1426 {
                                                        let _e1428 = local_1.group_mask;
                                                        let _e1434 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1428)), 32u, (_e1428 == 0u)));
                                                        let _e1438 = local_1.group_mask;
                                                        let _e1452 = local_1.group_mask;
                                                        local_1.group_mask = (_e1452 & ~((1u << bitcast<u32>((_e1434 & 31u)))));
                                                        let _e1455 = local_1.group;
                                                        phi_2030_ = (_e1455 + countOneBits(((_e1438 & ~((4294967295u << bitcast<u32>((((_e1434 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_2030_ = 4294967295u;
                                                    }
                                                    let _e1458 = phi_2030_;
                                                    phi_2032_ = _e1458;
                                                    loop {
                                                        let _e1460 = phi_2032_;
                                                        if (_e1460 != 4294967295u) {
                                                            if (_e1460 < _e77) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1467 = nodes.member[(0u + _e1460)].frame[3u];
                                                            let _e1492 = (bitcast<f32>((((_e1467 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1224);
                                                            let _e1493 = (bitcast<f32>((((_e1467 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1234);
                                                            let _e1494 = (bitcast<f32>((((_e1467 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1244);
                                                            let _e1497 = nodes.member[(0u + _e1460)].frame[0u];
                                                            let _e1501 = nodes.member[(0u + _e1460)].frame[1u];
                                                            let _e1505 = nodes.member[(0u + _e1460)].frame[2u];
                                                            let _e1510 = ((bitcast<f32>(_e1497) - _e1015) * _e1224);
                                                            let _e1511 = ((bitcast<f32>(_e1501) - _e1028) * _e1234);
                                                            let _e1512 = ((bitcast<f32>(_e1505) - _e1041) * _e1244);
                                                            let _e1520 = nodes.member[(0u + _e1460)].x;
                                                            if (_e1224 < 0f) {
                                                                let _e1531 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1520.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1537 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1531.unnamed.root, _e1520.w), _e1531.unnamed_1);
                                                                let _e1543 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1537.unnamed, lt_bvh_traverse_Tree(_e1520.x, _e1537.unnamed_1.first_primitive));
                                                                phi_2113_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1543.unnamed, lt_bvh_traverse_Tree(_e1543.unnamed_1.root, _e1520.y));
                                                            } else {
                                                                let _e1559 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1520.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1565 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1559.unnamed.root, _e1520.y), _e1559.unnamed_1);
                                                                let _e1571 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1565.unnamed, lt_bvh_traverse_Tree(_e1520.z, _e1565.unnamed_1.first_primitive));
                                                                phi_2113_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1571.unnamed, lt_bvh_traverse_Tree(_e1571.unnamed_1.root, _e1520.w));
                                                            }
                                                            let _e1579 = phi_2113_;
                                                            let _e1589 = nodes.member[(0u + _e1460)].y;
                                                            if (_e1234 < 0f) {
                                                                let _e1600 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1589.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1606 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1600.unnamed.root, _e1589.w), _e1600.unnamed_1);
                                                                let _e1612 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1606.unnamed, lt_bvh_traverse_Tree(_e1589.x, _e1606.unnamed_1.first_primitive));
                                                                phi_2140_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1612.unnamed, lt_bvh_traverse_Tree(_e1612.unnamed_1.root, _e1589.y));
                                                            } else {
                                                                let _e1628 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1589.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1634 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1628.unnamed.root, _e1589.y), _e1628.unnamed_1);
                                                                let _e1640 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1634.unnamed, lt_bvh_traverse_Tree(_e1589.z, _e1634.unnamed_1.first_primitive));
                                                                phi_2140_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1640.unnamed, lt_bvh_traverse_Tree(_e1640.unnamed_1.root, _e1589.w));
                                                            }
                                                            let _e1648 = phi_2140_;
                                                            let _e1658 = nodes.member[(0u + _e1460)].z;
                                                            if (_e1244 < 0f) {
                                                                let _e1669 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1658.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1675 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1669.unnamed.root, _e1658.w), _e1669.unnamed_1);
                                                                let _e1681 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1675.unnamed, lt_bvh_traverse_Tree(_e1658.x, _e1675.unnamed_1.first_primitive));
                                                                phi_2167_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1681.unnamed, lt_bvh_traverse_Tree(_e1681.unnamed_1.root, _e1658.y));
                                                            } else {
                                                                let _e1697 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1658.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1703 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1697.unnamed.root, _e1658.y), _e1697.unnamed_1);
                                                                let _e1709 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1703.unnamed, lt_bvh_traverse_Tree(_e1658.z, _e1703.unnamed_1.first_primitive));
                                                                phi_2167_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1709.unnamed, lt_bvh_traverse_Tree(_e1709.unnamed_1.root, _e1658.w));
                                                            }
                                                            let _e1717 = phi_2167_;
                                                            phi_2173_ = 0u;
                                                            phi_2176_ = 0u;
                                                            loop {
                                                                let _e1727 = phi_2173_;
                                                                let _e1729 = phi_2176_;
                                                                local_6 = _e1729;
                                                                local_7 = _e1729;
                                                                local_8 = _e1729;
                                                                let _e1730 = (_e1727 < 8u);
                                                                if _e1730 {
                                                                    let _e1732 = (_e1727 >> bitcast<u32>(2i));
                                                                    let _e1733 = (_e1727 & 3u);
                                                                    if (_e1732 == 0u) {
                                                                        phi_2190_ = _e1579.unnamed.root;
                                                                    } else {
                                                                        phi_2190_ = _e1579.unnamed.first_primitive;
                                                                    }
                                                                    let _e1736 = phi_2190_;
                                                                    if (_e1732 == 0u) {
                                                                        phi_2200_ = _e1648.unnamed.root;
                                                                    } else {
                                                                        phi_2200_ = _e1648.unnamed.first_primitive;
                                                                    }
                                                                    let _e1745 = phi_2200_;
                                                                    if (_e1732 == 0u) {
                                                                        phi_2210_ = _e1717.unnamed.root;
                                                                    } else {
                                                                        phi_2210_ = _e1717.unnamed.first_primitive;
                                                                    }
                                                                    let _e1754 = phi_2210_;
                                                                    let _e1767 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1736 >> bitcast<u32>(((_e1733 * 8u) & 31u))) & 255u)) * _e1492) + (_e1510 - _e1272)), ((f32(((_e1745 >> bitcast<u32>(((_e1733 * 8u) & 31u))) & 255u)) * _e1493) + (_e1511 - _e1273)));
                                                                    let _e1768 = core_intrinsics_maximum_number_nsz_f32_(_e1767, ((f32(((_e1754 >> bitcast<u32>(((_e1733 * 8u) & 31u))) & 255u)) * _e1494) + (_e1512 - _e1274)));
                                                                    if (_e1732 == 0u) {
                                                                        phi_2228_ = _e1579.unnamed_1.root;
                                                                    } else {
                                                                        phi_2228_ = _e1579.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1771 = phi_2228_;
                                                                    if (_e1732 == 0u) {
                                                                        phi_2238_ = _e1648.unnamed_1.root;
                                                                    } else {
                                                                        phi_2238_ = _e1648.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1780 = phi_2238_;
                                                                    if (_e1732 == 0u) {
                                                                        phi_2248_ = _e1717.unnamed_1.root;
                                                                    } else {
                                                                        phi_2248_ = _e1717.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1789 = phi_2248_;
                                                                    let _e1802 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1771 >> bitcast<u32>(((_e1733 * 8u) & 31u))) & 255u)) * _e1492) + (_e1510 + _e1272)), ((f32(((_e1780 >> bitcast<u32>(((_e1733 * 8u) & 31u))) & 255u)) * _e1493) + (_e1511 + _e1273)));
                                                                    let _e1803 = core_intrinsics_minimum_number_nsz_f32_(_e1802, ((f32(((_e1789 >> bitcast<u32>(((_e1733 * 8u) & 31u))) & 255u)) * _e1494) + (_e1512 + _e1274)));
                                                                    if (_e1768 <= _e1803) {
                                                                        if (_e1768 <= _e145) {
                                                                            if (_e1803 >= 0f) {
                                                                                if (_e1732 == 0u) {
                                                                                    let _e1810 = nodes.member[(0u + _e1460)].links[2u];
                                                                                    phi_2284_ = _e1810;
                                                                                } else {
                                                                                    let _e1813 = nodes.member[(0u + _e1460)].links[3u];
                                                                                    phi_2284_ = _e1813;
                                                                                }
                                                                                let _e1815 = phi_2284_;
                                                                                let _e1820 = ((_e1815 >> bitcast<u32>(((_e1733 * 8u) & 31u))) & 255u);
                                                                                let _e1821 = (_e1820 & 31u);
                                                                                if (_e1821 >= 24u) {
                                                                                    phi_2297_ = (24u + ((_e1821 - 24u) ^ _e1322));
                                                                                } else {
                                                                                    phi_2297_ = _e1821;
                                                                                }
                                                                                let _e1827 = phi_2297_;
                                                                                phi_2302_ = (_e1729 | ((_e1820 >> bitcast<u32>(5i)) << bitcast<u32>((_e1827 & 31u))));
                                                                            } else {
                                                                                phi_2302_ = _e1729;
                                                                            }
                                                                            let _e1835 = phi_2302_;
                                                                            phi_2303_ = _e1835;
                                                                        } else {
                                                                            phi_2303_ = _e1729;
                                                                        }
                                                                        let _e1837 = phi_2303_;
                                                                        phi_2304_ = _e1837;
                                                                    } else {
                                                                        phi_2304_ = _e1729;
                                                                    }
                                                                    let _e1839 = phi_2304_;
                                                                    phi_2174_ = (_e1727 + 1u);
                                                                    phi_2177_ = _e1839;
                                                                } else {
                                                                    phi_2174_ = u32();
                                                                    phi_2177_ = u32();
                                                                }
                                                                let _e1842 = phi_2174_;
                                                                let _e1844 = phi_2177_;
                                                                continue;
                                                                continuing {
                                                                    phi_2173_ = _e1842;
                                                                    phi_2176_ = _e1844;
                                                                    break if !(_e1730);
                                                                }
                                                            }
                                                            let _e1848 = nodes.member[(0u + _e1460)].links[0u];
                                                            let _e1852 = nodes.member[(0u + _e1460)].frame[3u];
                                                            let _e1856 = local_6;
                                                            if ((_e1856 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1860 = local_1.group_mask;
                                                                if ((_e1860 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1864 = local_1.len;
                                                                    if (_e1864 < 32u) {
                                                                        let _e1867 = local_1.group;
                                                                        let _e1869 = local_1.len;
                                                                        if (_e1869 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.first[(0u + _e1869)] = _e1867;
                                                                        let _e1875 = local_1.group_mask;
                                                                        let _e1877 = local_1.len;
                                                                        if (_e1877 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.mask[(0u + _e1877)] = _e1875;
                                                                        let _e1884 = local_1.len;
                                                                        local_1.len = (_e1884 + 1u);
                                                                    }
                                                                }
                                                                local_1.group = (_e1084 + _e1848);
                                                                let _e1888 = local_7;
                                                                local_1.group_mask = ((_e1888 & 4278190080u) | (_e1852 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1893 = local_8;
                                                            phi_2362_ = (_e1893 & 16777215u);
                                                            loop {
                                                                let _e1896 = phi_2362_;
                                                                let _e1897 = (_e1896 == 0u);
                                                                local_9 = _e1897;
                                                                local_15 = _e1897;
                                                                if _e1897 {
                                                                    phi_2363_ = u32();
                                                                    phi_3170_ = false;
                                                                    phi_3171_ = false;
                                                                    phi_3172_ = false;
                                                                } else {
                                                                    let _e1900 = nodes.member[(0u + _e1460)].links[1u];
                                                                    let _e1905 = ((_e1086 + _e1900) + select(firstTrailingBit(_e1896), 32u, (_e1896 == 0u)));
                                                                    if (_e1905 < _e80) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1912 = triangles.member[(0u + _e1905)].v0_;
                                                                    let _e1914 = (_e1912.x - _e1015);
                                                                    let _e1916 = (_e1912.y - _e1028);
                                                                    let _e1918 = (_e1912.z - _e1041);
                                                                    if (_e1295 == 0u) {
                                                                        phi_2408_ = vec3<f32>(_e1916, _e1918, _e1914);
                                                                    } else {
                                                                        if (_e1295 == 1u) {
                                                                            phi_2407_ = vec3<f32>(_e1918, _e1914, _e1916);
                                                                        } else {
                                                                            phi_2407_ = (_e1912 - vec3<f32>(_e1015, _e1028, _e1041));
                                                                        }
                                                                        let _e1926 = phi_2407_;
                                                                        phi_2408_ = _e1926;
                                                                    }
                                                                    let _e1928 = phi_2408_;
                                                                    let _e1932 = (_e1928.x - (_e1306 * _e1928.z));
                                                                    let _e1936 = (_e1928.y - (_e1309 * _e1928.z));
                                                                    let _e1938 = triangles.member[(0u + _e1905)].v1_;
                                                                    let _e1940 = (_e1938.x - _e1015);
                                                                    let _e1942 = (_e1938.y - _e1028);
                                                                    let _e1944 = (_e1938.z - _e1041);
                                                                    if (_e1295 == 0u) {
                                                                        phi_2438_ = vec3<f32>(_e1942, _e1944, _e1940);
                                                                    } else {
                                                                        if (_e1295 == 1u) {
                                                                            phi_2437_ = vec3<f32>(_e1944, _e1940, _e1942);
                                                                        } else {
                                                                            phi_2437_ = (_e1938 - vec3<f32>(_e1015, _e1028, _e1041));
                                                                        }
                                                                        let _e1952 = phi_2437_;
                                                                        phi_2438_ = _e1952;
                                                                    }
                                                                    let _e1954 = phi_2438_;
                                                                    let _e1958 = (_e1954.x - (_e1306 * _e1954.z));
                                                                    let _e1962 = (_e1954.y - (_e1309 * _e1954.z));
                                                                    let _e1964 = triangles.member[(0u + _e1905)].v2_;
                                                                    let _e1966 = (_e1964.x - _e1015);
                                                                    let _e1968 = (_e1964.y - _e1028);
                                                                    let _e1970 = (_e1964.z - _e1041);
                                                                    if (_e1295 == 0u) {
                                                                        phi_2468_ = vec3<f32>(_e1968, _e1970, _e1966);
                                                                    } else {
                                                                        if (_e1295 == 1u) {
                                                                            phi_2467_ = vec3<f32>(_e1970, _e1966, _e1968);
                                                                        } else {
                                                                            phi_2467_ = (_e1964 - vec3<f32>(_e1015, _e1028, _e1041));
                                                                        }
                                                                        let _e1978 = phi_2467_;
                                                                        phi_2468_ = _e1978;
                                                                    }
                                                                    let _e1980 = phi_2468_;
                                                                    let _e1984 = (_e1980.x - (_e1306 * _e1980.z));
                                                                    let _e1988 = (_e1980.y - (_e1309 * _e1980.z));
                                                                    if (_e1958 < _e1984) {
                                                                        phi_2487_ = true;
                                                                    } else {
                                                                        if (_e1958 == _e1984) {
                                                                            phi_2486_ = (_e1962 < _e1988);
                                                                        } else {
                                                                            phi_2486_ = false;
                                                                        }
                                                                        let _e1993 = phi_2486_;
                                                                        phi_2487_ = _e1993;
                                                                    }
                                                                    let _e1995 = phi_2487_;
                                                                    if _e1995 {
                                                                        phi_2491_ = _e1988;
                                                                        phi_2492_ = _e1984;
                                                                        phi_2493_ = _e1962;
                                                                        phi_2494_ = _e1958;
                                                                    } else {
                                                                        phi_2491_ = _e1962;
                                                                        phi_2492_ = _e1958;
                                                                        phi_2493_ = _e1988;
                                                                        phi_2494_ = _e1984;
                                                                    }
                                                                    let _e1997 = phi_2491_;
                                                                    let _e1999 = phi_2492_;
                                                                    let _e2001 = phi_2493_;
                                                                    let _e2003 = phi_2494_;
                                                                    let _e2006 = ((_e2003 * _e1997) - (_e2001 * _e1999));
                                                                    if _e1995 {
                                                                        phi_2502_ = -(_e2006);
                                                                    } else {
                                                                        phi_2502_ = _e2006;
                                                                    }
                                                                    let _e2009 = phi_2502_;
                                                                    if (_e1984 < _e1932) {
                                                                        phi_2513_ = true;
                                                                    } else {
                                                                        if (_e1984 == _e1932) {
                                                                            phi_2512_ = (_e1988 < _e1936);
                                                                        } else {
                                                                            phi_2512_ = false;
                                                                        }
                                                                        let _e2014 = phi_2512_;
                                                                        phi_2513_ = _e2014;
                                                                    }
                                                                    let _e2016 = phi_2513_;
                                                                    if _e2016 {
                                                                        phi_2517_ = _e1936;
                                                                        phi_2518_ = _e1932;
                                                                        phi_2519_ = _e1988;
                                                                        phi_2520_ = _e1984;
                                                                    } else {
                                                                        phi_2517_ = _e1988;
                                                                        phi_2518_ = _e1984;
                                                                        phi_2519_ = _e1936;
                                                                        phi_2520_ = _e1932;
                                                                    }
                                                                    let _e2018 = phi_2517_;
                                                                    let _e2020 = phi_2518_;
                                                                    let _e2022 = phi_2519_;
                                                                    let _e2024 = phi_2520_;
                                                                    let _e2027 = ((_e2024 * _e2018) - (_e2022 * _e2020));
                                                                    if _e2016 {
                                                                        phi_2528_ = -(_e2027);
                                                                    } else {
                                                                        phi_2528_ = _e2027;
                                                                    }
                                                                    let _e2030 = phi_2528_;
                                                                    if (_e1932 < _e1958) {
                                                                        phi_2539_ = true;
                                                                    } else {
                                                                        if (_e1932 == _e1958) {
                                                                            phi_2538_ = (_e1936 < _e1962);
                                                                        } else {
                                                                            phi_2538_ = false;
                                                                        }
                                                                        let _e2035 = phi_2538_;
                                                                        phi_2539_ = _e2035;
                                                                    }
                                                                    let _e2037 = phi_2539_;
                                                                    if _e2037 {
                                                                        phi_2543_ = _e1962;
                                                                        phi_2544_ = _e1958;
                                                                        phi_2545_ = _e1936;
                                                                        phi_2546_ = _e1932;
                                                                    } else {
                                                                        phi_2543_ = _e1936;
                                                                        phi_2544_ = _e1932;
                                                                        phi_2545_ = _e1962;
                                                                        phi_2546_ = _e1958;
                                                                    }
                                                                    let _e2039 = phi_2543_;
                                                                    let _e2041 = phi_2544_;
                                                                    let _e2043 = phi_2545_;
                                                                    let _e2045 = phi_2546_;
                                                                    let _e2048 = ((_e2045 * _e2039) - (_e2043 * _e2041));
                                                                    if _e2037 {
                                                                        phi_2554_ = -(_e2048);
                                                                    } else {
                                                                        phi_2554_ = _e2048;
                                                                    }
                                                                    let _e2051 = phi_2554_;
                                                                    if (_e2009 >= 0f) {
                                                                        if (_e2030 >= 0f) {
                                                                            if (_e2051 >= 0f) {
                                                                                phi_2569_ = ((_e2009 + _e2030) + _e2051);
                                                                                phi_2570_ = false;
                                                                            } else {
                                                                                phi_2569_ = f32();
                                                                                phi_2570_ = true;
                                                                            }
                                                                            let _e2058 = phi_2569_;
                                                                            let _e2060 = phi_2570_;
                                                                            phi_2571_ = _e2058;
                                                                            phi_2572_ = _e2060;
                                                                        } else {
                                                                            phi_2571_ = f32();
                                                                            phi_2572_ = true;
                                                                        }
                                                                        let _e2062 = phi_2571_;
                                                                        let _e2064 = phi_2572_;
                                                                        phi_2573_ = _e2062;
                                                                        phi_2574_ = _e2064;
                                                                    } else {
                                                                        phi_2573_ = f32();
                                                                        phi_2574_ = true;
                                                                    }
                                                                    let _e2066 = phi_2573_;
                                                                    let _e2068 = phi_2574_;
                                                                    if _e2068 {
                                                                        if (_e2009 <= 0f) {
                                                                            if (_e2030 <= 0f) {
                                                                                let _e2071 = (_e2051 <= 0f);
                                                                                if _e2071 {
                                                                                }
                                                                                phi_2592_ = ((_e2009 + _e2030) + _e2051);
                                                                                phi_2593_ = false;
                                                                                phi_2594_ = _e2071;
                                                                            } else {
                                                                                phi_2592_ = f32();
                                                                                phi_2593_ = true;
                                                                                phi_2594_ = false;
                                                                            }
                                                                            let _e2075 = phi_2592_;
                                                                            let _e2077 = phi_2593_;
                                                                            let _e2079 = phi_2594_;
                                                                            phi_2595_ = _e2075;
                                                                            phi_2596_ = _e2077;
                                                                            phi_2597_ = _e2079;
                                                                        } else {
                                                                            phi_2595_ = f32();
                                                                            phi_2596_ = true;
                                                                            phi_2597_ = false;
                                                                        }
                                                                        let _e2081 = phi_2595_;
                                                                        let _e2083 = phi_2596_;
                                                                        let _e2085 = phi_2597_;
                                                                        if _e2083 {
                                                                            phi_2601_ = false;
                                                                        } else {
                                                                            phi_2601_ = _e2085;
                                                                        }
                                                                        let _e2087 = phi_2601_;
                                                                        phi_2602_ = _e2081;
                                                                        phi_2603_ = _e2087;
                                                                    } else {
                                                                        phi_2602_ = _e2066;
                                                                        phi_2603_ = true;
                                                                    }
                                                                    let _e2089 = phi_2602_;
                                                                    let _e2091 = phi_2603_;
                                                                    if _e2091 {
                                                                        let _e2092 = (_e2089 == 0f);
                                                                        if _e2092 {
                                                                            phi_2919_ = lt_bvh_triangle_Intersection();
                                                                            phi_2920_ = false;
                                                                        } else {
                                                                            let _e2094 = triangles.member[(0u + _e1905)].v0_;
                                                                            let _e2096 = (_e2094.x - _e1015);
                                                                            let _e2098 = (_e2094.y - _e1028);
                                                                            let _e2100 = (_e2094.z - _e1041);
                                                                            if (_e1295 == 0u) {
                                                                                phi_2632_ = vec3<f32>(_e2098, _e2100, _e2096);
                                                                            } else {
                                                                                if (_e1295 == 1u) {
                                                                                    phi_2631_ = vec3<f32>(_e2100, _e2096, _e2098);
                                                                                } else {
                                                                                    phi_2631_ = (_e2094 - vec3<f32>(_e1015, _e1028, _e1041));
                                                                                }
                                                                                let _e2108 = phi_2631_;
                                                                                phi_2632_ = _e2108;
                                                                            }
                                                                            let _e2110 = phi_2632_;
                                                                            let _e2112 = triangles.member[(0u + _e1905)].v1_;
                                                                            let _e2114 = triangles.member[(0u + _e1905)].v0_;
                                                                            let _e2117 = (_e2112.x - _e2114.x);
                                                                            let _e2120 = (_e2112.y - _e2114.y);
                                                                            let _e2123 = (_e2112.z - _e2114.z);
                                                                            if (_e1295 == 0u) {
                                                                                phi_2658_ = vec3<f32>(_e2120, _e2123, _e2117);
                                                                            } else {
                                                                                if (_e1295 == 1u) {
                                                                                    phi_2657_ = vec3<f32>(_e2123, _e2117, _e2120);
                                                                                } else {
                                                                                    phi_2657_ = (_e2112 - _e2114);
                                                                                }
                                                                                let _e2130 = phi_2657_;
                                                                                phi_2658_ = _e2130;
                                                                            }
                                                                            let _e2132 = phi_2658_;
                                                                            let _e2134 = triangles.member[(0u + _e1905)].v2_;
                                                                            let _e2136 = triangles.member[(0u + _e1905)].v0_;
                                                                            let _e2139 = (_e2134.x - _e2136.x);
                                                                            let _e2142 = (_e2134.y - _e2136.y);
                                                                            let _e2145 = (_e2134.z - _e2136.z);
                                                                            if (_e1295 == 0u) {
                                                                                phi_2684_ = vec3<f32>(_e2142, _e2145, _e2139);
                                                                            } else {
                                                                                if (_e1295 == 1u) {
                                                                                    phi_2683_ = vec3<f32>(_e2145, _e2139, _e2142);
                                                                                } else {
                                                                                    phi_2683_ = (_e2134 - _e2136);
                                                                                }
                                                                                let _e2152 = phi_2683_;
                                                                                phi_2684_ = _e2152;
                                                                            }
                                                                            let _e2154 = phi_2684_;
                                                                            let _e2161 = ((_e2132.y * _e2154.z) - (_e2132.z * _e2154.y));
                                                                            let _e2168 = ((_e2132.z * _e2154.x) - (_e2132.x * _e2154.z));
                                                                            let _e2175 = ((_e2132.x * _e2154.y) - (_e2132.y * _e2154.x));
                                                                            let _e2189 = (((1f / _e1303.z) * (((_e2161 * _e2110.x) + (_e2168 * _e2110.y)) + (_e2175 * _e2110.z))) / (((_e2161 * _e1306) + (_e2168 * _e1309)) + _e2175));
                                                                            if (_e2189 > 0f) {
                                                                                if (_e2189 < _e145) {
                                                                                    let _e2193 = triangles.member[(0u + _e1905)].v0_;
                                                                                    let _e2195 = triangles.member[(0u + _e1905)].v1_;
                                                                                    if (_e2193.x < _e2195.x) {
                                                                                        phi_2740_ = _e2193.x;
                                                                                    } else {
                                                                                        phi_2740_ = _e2195.x;
                                                                                    }
                                                                                    let _e2202 = phi_2740_;
                                                                                    if (_e2193.y < _e2195.y) {
                                                                                        phi_2749_ = _e2193.y;
                                                                                    } else {
                                                                                        phi_2749_ = _e2195.y;
                                                                                    }
                                                                                    let _e2209 = phi_2749_;
                                                                                    if (_e2193.z < _e2195.z) {
                                                                                        phi_2758_ = _e2193.z;
                                                                                    } else {
                                                                                        phi_2758_ = _e2195.z;
                                                                                    }
                                                                                    let _e2216 = phi_2758_;
                                                                                    let _e2218 = triangles.member[(0u + _e1905)].v2_;
                                                                                    if (_e2202 < _e2218.x) {
                                                                                        phi_2767_ = _e2202;
                                                                                    } else {
                                                                                        phi_2767_ = _e2218.x;
                                                                                    }
                                                                                    let _e2223 = phi_2767_;
                                                                                    if (_e2209 < _e2218.y) {
                                                                                        phi_2774_ = _e2209;
                                                                                    } else {
                                                                                        phi_2774_ = _e2218.y;
                                                                                    }
                                                                                    let _e2228 = phi_2774_;
                                                                                    if (_e2216 < _e2218.z) {
                                                                                        phi_2781_ = _e2216;
                                                                                    } else {
                                                                                        phi_2781_ = _e2218.z;
                                                                                    }
                                                                                    let _e2233 = phi_2781_;
                                                                                    let _e2235 = triangles.member[(0u + _e1905)].v0_;
                                                                                    let _e2237 = triangles.member[(0u + _e1905)].v1_;
                                                                                    if (_e2235.x > _e2237.x) {
                                                                                        phi_2794_ = _e2235.x;
                                                                                    } else {
                                                                                        phi_2794_ = _e2237.x;
                                                                                    }
                                                                                    let _e2244 = phi_2794_;
                                                                                    if (_e2235.y > _e2237.y) {
                                                                                        phi_2803_ = _e2235.y;
                                                                                    } else {
                                                                                        phi_2803_ = _e2237.y;
                                                                                    }
                                                                                    let _e2251 = phi_2803_;
                                                                                    if (_e2235.z > _e2237.z) {
                                                                                        phi_2812_ = _e2235.z;
                                                                                    } else {
                                                                                        phi_2812_ = _e2237.z;
                                                                                    }
                                                                                    let _e2258 = phi_2812_;
                                                                                    let _e2260 = triangles.member[(0u + _e1905)].v2_;
                                                                                    if (_e2244 > _e2260.x) {
                                                                                        phi_2821_ = _e2244;
                                                                                    } else {
                                                                                        phi_2821_ = _e2260.x;
                                                                                    }
                                                                                    let _e2265 = phi_2821_;
                                                                                    if (_e2251 > _e2260.y) {
                                                                                        phi_2828_ = _e2251;
                                                                                    } else {
                                                                                        phi_2828_ = _e2260.y;
                                                                                    }
                                                                                    let _e2270 = phi_2828_;
                                                                                    if (_e2258 > _e2260.z) {
                                                                                        phi_2835_ = _e2258;
                                                                                    } else {
                                                                                        phi_2835_ = _e2260.z;
                                                                                    }
                                                                                    let _e2275 = phi_2835_;
                                                                                    let _e2279 = ((_e2223 - _e1015) * _e1224);
                                                                                    let _e2280 = ((_e2228 - _e1028) * _e1234);
                                                                                    let _e2281 = ((_e2233 - _e1041) * _e1244);
                                                                                    let _e2285 = ((_e2265 - _e1015) * _e1224);
                                                                                    let _e2286 = ((_e2270 - _e1028) * _e1234);
                                                                                    let _e2287 = ((_e2275 - _e1041) * _e1244);
                                                                                    if (_e2279 < _e2285) {
                                                                                        phi_2852_ = _e2279;
                                                                                    } else {
                                                                                        phi_2852_ = _e2285;
                                                                                    }
                                                                                    let _e2290 = phi_2852_;
                                                                                    if (_e2280 < _e2286) {
                                                                                        phi_2857_ = _e2280;
                                                                                    } else {
                                                                                        phi_2857_ = _e2286;
                                                                                    }
                                                                                    let _e2293 = phi_2857_;
                                                                                    if (_e2281 < _e2287) {
                                                                                        phi_2862_ = _e2281;
                                                                                    } else {
                                                                                        phi_2862_ = _e2287;
                                                                                    }
                                                                                    let _e2296 = phi_2862_;
                                                                                    if (_e2279 > _e2285) {
                                                                                        phi_2870_ = _e2279;
                                                                                    } else {
                                                                                        phi_2870_ = _e2285;
                                                                                    }
                                                                                    let _e2302 = phi_2870_;
                                                                                    if (_e2280 > _e2286) {
                                                                                        phi_2875_ = _e2280;
                                                                                    } else {
                                                                                        phi_2875_ = _e2286;
                                                                                    }
                                                                                    let _e2305 = phi_2875_;
                                                                                    if (_e2281 > _e2287) {
                                                                                        phi_2880_ = _e2281;
                                                                                    } else {
                                                                                        phi_2880_ = _e2287;
                                                                                    }
                                                                                    let _e2308 = phi_2880_;
                                                                                    let _e2312 = core_intrinsics_maximum_number_nsz_f32_((_e2290 - _e1279), (_e2293 - _e1280));
                                                                                    let _e2313 = core_intrinsics_maximum_number_nsz_f32_(_e2312, (_e2296 - _e1281));
                                                                                    let _e2314 = core_intrinsics_minimum_number_nsz_f32_((_e2302 + _e1279), (_e2305 + _e1280));
                                                                                    let _e2315 = core_intrinsics_minimum_number_nsz_f32_(_e2314, (_e2308 + _e1281));
                                                                                    if (_e2313 > _e996) {
                                                                                        phi_2892_ = _e2313;
                                                                                    } else {
                                                                                        phi_2892_ = _e996;
                                                                                    }
                                                                                    let _e2318 = phi_2892_;
                                                                                    if (_e2315 < _e998) {
                                                                                        phi_2897_ = _e2315;
                                                                                    } else {
                                                                                        phi_2897_ = _e998;
                                                                                    }
                                                                                    let _e2321 = phi_2897_;
                                                                                    if (_e2189 < _e2318) {
                                                                                        phi_2902_ = _e2318;
                                                                                    } else {
                                                                                        phi_2902_ = _e2189;
                                                                                    }
                                                                                    let _e2324 = phi_2902_;
                                                                                    if (_e2324 > _e2321) {
                                                                                        phi_2907_ = _e2321;
                                                                                    } else {
                                                                                        phi_2907_ = _e2324;
                                                                                    }
                                                                                    let _e2327 = phi_2907_;
                                                                                    phi_2912_ = lt_bvh_triangle_Intersection(_e2327, (_e2030 / _e2089), (_e2051 / _e2089), (_e2318 <= _e2321));
                                                                                    phi_2913_ = false;
                                                                                } else {
                                                                                    phi_2912_ = lt_bvh_triangle_Intersection();
                                                                                    phi_2913_ = true;
                                                                                }
                                                                                let _e2333 = phi_2912_;
                                                                                let _e2335 = phi_2913_;
                                                                                phi_2914_ = _e2333;
                                                                                phi_2915_ = _e2335;
                                                                            } else {
                                                                                phi_2914_ = lt_bvh_triangle_Intersection();
                                                                                phi_2915_ = true;
                                                                            }
                                                                            let _e2337 = phi_2914_;
                                                                            let _e2339 = phi_2915_;
                                                                            if _e2339 {
                                                                            }
                                                                            phi_2919_ = _e2337;
                                                                            phi_2920_ = _e2339;
                                                                        }
                                                                        let _e2341 = phi_2919_;
                                                                        let _e2343 = phi_2920_;
                                                                        phi_2921_ = _e2341;
                                                                        phi_2922_ = _e2092;
                                                                        phi_2923_ = _e2343;
                                                                    } else {
                                                                        phi_2921_ = lt_bvh_triangle_Intersection();
                                                                        phi_2922_ = true;
                                                                        phi_2923_ = false;
                                                                    }
                                                                    let _e2345 = phi_2921_;
                                                                    let _e2347 = phi_2922_;
                                                                    let _e2349 = phi_2923_;
                                                                    if _e2347 {
                                                                        phi_2927_ = true;
                                                                    } else {
                                                                        phi_2927_ = _e2349;
                                                                    }
                                                                    let _e2351 = phi_2927_;
                                                                    if _e2351 {
                                                                        phi_2931_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_2931_ = _e2345;
                                                                    }
                                                                    let _e2353 = phi_2931_;
                                                                    if _e2353.is_hit {
                                                                        if (_e2353.t > 0f) {
                                                                            if (_e2353.t < _e145) {
                                                                                let _e2360 = triangles.member[(0u + _e1905)].i0_;
                                                                                let _e2362 = ((_e2360 & 2147483648u) == 0u);
                                                                                if _e2362 {
                                                                                    phi_3154_ = false;
                                                                                    phi_3155_ = false;
                                                                                } else {
                                                                                    if (_e1905 < _e80) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2369 = triangles.member[(0u + _e1905)].i0_;
                                                                                    let _e2370 = (_e2369 & 2147483647u);
                                                                                    let _e2372 = triangles.member[(0u + _e1905)].i1_;
                                                                                    let _e2374 = triangles.member[(0u + _e1905)].i2_;
                                                                                    if (_e2370 < _e95) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2378 = vertices.member[(0u + _e2370)];
                                                                                    if (_e2372 < _e95) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2382 = vertices.member[(0u + _e2372)];
                                                                                    if (_e2374 < _e95) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2386 = vertices.member[(0u + _e2374)];
                                                                                    let _e2387 = array<abi_Vertex, 3>(_e2378, _e2382, _e2386);
                                                                                    if (_e2387[0].material < arrayLength((&materials.member))) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2393 = materials.member[(0u + _e2387[0].material)];
                                                                                    if ((_e2393.flags & 1u) == 1u) {
                                                                                        let _e2398 = ((1f - _e2353.u) - _e2353.v);
                                                                                        if (_e2393.cutoff <= 0f) {
                                                                                            phi_3148_ = true;
                                                                                        } else {
                                                                                            let _e2425 = (_e2393.base_color.w * ((((f32((_e2387[0].color >> bitcast<u32>(24i))) * _e2398) + (f32((_e2387[1].color >> bitcast<u32>(24i))) * _e2353.u)) + (f32((_e2387[2].color >> bitcast<u32>(24i))) * _e2353.v)) * (1f / 255f)));
                                                                                            if (_e2393.alpha_size == 0u) {
                                                                                                phi_3145_ = _e2425;
                                                                                            } else {
                                                                                                local.offset = _e2393.alpha_offset;
                                                                                                local.size = _e2393.alpha_size;
                                                                                                local.flags = _e2393.flags;
                                                                                                let _e2456 = _lt_shaders_texture_TextureView_quad((&local), (((_e2387[0].u * _e2398) + (_e2387[1].u * _e2353.u)) + (_e2387[2].u * _e2353.v)), (((_e2387[0].v * _e2398) + (_e2387[1].v * _e2353.u)) + (_e2387[2].v * _e2353.v)));
                                                                                                let _e2460 = (_e2456.indices[0] >> bitcast<u32>(2i));
                                                                                                if (_e2460 < _e101) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2464 = alpha_texels.member[(0u + _e2460)];
                                                                                                let _e2480 = (_e2456.indices[1] >> bitcast<u32>(2i));
                                                                                                if (_e2480 < _e101) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2484 = alpha_texels.member[(0u + _e2480)];
                                                                                                let _e2501 = (_e2456.indices[2] >> bitcast<u32>(2i));
                                                                                                if (_e2501 < _e101) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2505 = alpha_texels.member[(0u + _e2501)];
                                                                                                let _e2522 = (_e2456.indices[3] >> bitcast<u32>(2i));
                                                                                                if (_e2522 < _e101) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2526 = alpha_texels.member[(0u + _e2522)];
                                                                                                phi_3145_ = (_e2425 * (((((f32(((_e2464 >> bitcast<u32>((((_e2456.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2456.weights.x) + ((f32(((_e2484 >> bitcast<u32>((((_e2456.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2456.weights.y)) + ((f32(((_e2505 >> bitcast<u32>((((_e2456.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2456.weights.z)) + ((f32(((_e2526 >> bitcast<u32>((((_e2456.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2456.weights.w)));
                                                                                            }
                                                                                            let _e2542 = phi_3145_;
                                                                                            phi_3148_ = (_e2542 >= _e2393.cutoff);
                                                                                        }
                                                                                        let _e2546 = phi_3148_;
                                                                                        phi_3149_ = _e2546;
                                                                                    } else {
                                                                                        phi_3149_ = false;
                                                                                    }
                                                                                    let _e2548 = phi_3149_;
                                                                                    if _e2548 {
                                                                                        phi_3153_ = false;
                                                                                    } else {
                                                                                        phi_3153_ = true;
                                                                                    }
                                                                                    let _e2550 = phi_3153_;
                                                                                    phi_3154_ = _e2550;
                                                                                    phi_3155_ = _e2548;
                                                                                }
                                                                                let _e2552 = phi_3154_;
                                                                                let _e2554 = phi_3155_;
                                                                                phi_3156_ = _e2552;
                                                                                phi_3157_ = _e2362;
                                                                                phi_3158_ = _e2554;
                                                                            } else {
                                                                                phi_3156_ = true;
                                                                                phi_3157_ = false;
                                                                                phi_3158_ = false;
                                                                            }
                                                                            let _e2556 = phi_3156_;
                                                                            let _e2558 = phi_3157_;
                                                                            let _e2560 = phi_3158_;
                                                                            phi_3159_ = _e2556;
                                                                            phi_3160_ = _e2558;
                                                                            phi_3161_ = _e2560;
                                                                        } else {
                                                                            phi_3159_ = true;
                                                                            phi_3160_ = false;
                                                                            phi_3161_ = false;
                                                                        }
                                                                        let _e2562 = phi_3159_;
                                                                        let _e2564 = phi_3160_;
                                                                        let _e2566 = phi_3161_;
                                                                        phi_3162_ = _e2562;
                                                                        phi_3163_ = _e2564;
                                                                        phi_3164_ = _e2566;
                                                                    } else {
                                                                        phi_3162_ = true;
                                                                        phi_3163_ = false;
                                                                        phi_3164_ = false;
                                                                    }
                                                                    let _e2568 = phi_3162_;
                                                                    let _e2570 = phi_3163_;
                                                                    let _e2572 = phi_3164_;
                                                                    if _e2568 {
                                                                        phi_3168_ = false;
                                                                        phi_3169_ = false;
                                                                    } else {
                                                                        phi_3168_ = _e2570;
                                                                        phi_3169_ = _e2572;
                                                                    }
                                                                    let _e2574 = phi_3168_;
                                                                    let _e2576 = phi_3169_;
                                                                    phi_2363_ = (_e1896 & (_e1896 - 1u));
                                                                    phi_3170_ = _e2568;
                                                                    phi_3171_ = _e2574;
                                                                    phi_3172_ = _e2576;
                                                                }
                                                                let _e2578 = phi_2363_;
                                                                let _e2580 = phi_3170_;
                                                                let _e2582 = phi_3171_;
                                                                let _e2584 = phi_3172_;
                                                                local_13 = _e2582;
                                                                local_14 = _e2584;
                                                                continue;
                                                                continuing {
                                                                    phi_2362_ = _e2578;
                                                                    break if !(_e2580);
                                                                }
                                                            }
                                                            let _e2587 = local_9;
                                                            if _e2587 {
                                                                let _e2589 = local_1.group_mask;
                                                                if ((_e2589 & 4278190080u) == 0u) {
                                                                    let _e2593 = local_1.len;
                                                                    if (_e2593 == 0u) {
                                                                        phi_3214_ = false;
                                                                    } else {
                                                                        let _e2597 = local_1.len;
                                                                        local_1.len = (_e2597 - 1u);
                                                                        let _e2600 = local_1.len;
                                                                        if (_e2600 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2605 = local_1.first[(0u + _e2600)];
                                                                        local_1.group = _e2605;
                                                                        let _e2608 = local_1.len;
                                                                        if (_e2608 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2613 = local_1.mask[(0u + _e2608)];
                                                                        local_1.group_mask = _e2613;
                                                                        phi_3214_ = true;
                                                                    }
                                                                    let _e2616 = phi_3214_;
                                                                    phi_3215_ = _e2616;
                                                                } else {
                                                                    phi_3215_ = true;
                                                                }
                                                                let _e2618 = phi_3215_;
                                                                if _e2618 {
                                                                    let _e2620 = local_1.group_mask;
                                                                    let _e2626 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2620)), 32u, (_e2620 == 0u)));
                                                                    let _e2630 = local_1.group_mask;
                                                                    let _e2644 = local_1.group_mask;
                                                                    local_1.group_mask = (_e2644 & ~((1u << bitcast<u32>((_e2626 & 31u)))));
                                                                    let _e2647 = local_1.group;
                                                                    phi_3246_ = (_e2647 + countOneBits(((_e2630 & ~((4294967295u << bitcast<u32>((((_e2626 - 24u) ^ _e1322) & 31u))))) & 255u)));
                                                                } else {
                                                                    phi_3246_ = 4294967295u;
                                                                }
                                                                let _e2650 = phi_3246_;
                                                                phi_3247_ = _e2650;
                                                                phi_3248_ = false;
                                                                phi_3249_ = false;
                                                            } else {
                                                                phi_3247_ = u32();
                                                                let _e3062 = local_13;
                                                                phi_3248_ = _e3062;
                                                                let _e3065 = local_14;
                                                                phi_3249_ = _e3065;
                                                            }
                                                            let _e2652 = phi_3247_;
                                                            let _e2654 = phi_3248_;
                                                            let _e2656 = phi_3249_;
                                                            phi_2033_ = _e2652;
                                                            let _e3069 = local_15;
                                                            phi_3250_ = _e3069;
                                                            phi_3251_ = false;
                                                            phi_3252_ = _e2654;
                                                            phi_3253_ = _e2656;
                                                        } else {
                                                            phi_2033_ = u32();
                                                            phi_3250_ = false;
                                                            phi_3251_ = true;
                                                            phi_3252_ = false;
                                                            phi_3253_ = false;
                                                        }
                                                        let _e2658 = phi_2033_;
                                                        let _e2660 = phi_3250_;
                                                        let _e2662 = phi_3251_;
                                                        let _e2664 = phi_3252_;
                                                        let _e2666 = phi_3253_;
                                                        local_10 = _e2662;
                                                        local_16 = _e2664;
                                                        local_17 = _e2666;
                                                        continue;
                                                        continuing {
                                                            phi_2032_ = _e2658;
                                                            break if !(_e2660);
                                                        }
                                                    }
                                                    let _e2669 = local_10;
                                                    if _e2669 {
                                                        phi_3257_ = false;
                                                        phi_3258_ = false;
                                                    } else {
                                                        let _e3076 = local_16;
                                                        phi_3257_ = _e3076;
                                                        let _e3079 = local_17;
                                                        phi_3258_ = _e3079;
                                                    }
                                                    let _e2671 = phi_3257_;
                                                    let _e2673 = phi_3258_;
                                                    if _e2671 {
                                                        phi_3262_ = true;
                                                    } else {
                                                        phi_3262_ = _e2673;
                                                    }
                                                    let _e2675 = phi_3262_;
                                                    if _e2675 {
                                                        phi_3266_ = true;
                                                    } else {
                                                        phi_3266_ = false;
                                                    }
                                                    let _e2677 = phi_3266_;
                                                    phi_3267_ = _e2677;
                                                }
                                                let _e2679 = phi_3267_;
                                                phi_3268_ = _e2679;
                                                phi_3269_ = _e1148;
                                            } else {
                                                phi_3268_ = bool();
                                                phi_3269_ = true;
                                            }
                                            let _e2681 = phi_3268_;
                                            let _e2683 = phi_3269_;
                                            if _e2683 {
                                                phi_3273_ = false;
                                            } else {
                                                phi_3273_ = _e2681;
                                            }
                                            let _e2685 = phi_3273_;
                                            if _e2685 {
                                                phi_3277_ = false;
                                            } else {
                                                phi_3277_ = true;
                                            }
                                            let _e2687 = phi_3277_;
                                            phi_3278_ = _e2687;
                                        } else {
                                            phi_3278_ = true;
                                        }
                                        let _e2689 = phi_3278_;
                                        phi_3279_ = _e2689;
                                    } else {
                                        phi_3279_ = true;
                                    }
                                    let _e2691 = phi_3279_;
                                    phi_3280_ = _e2691;
                                } else {
                                    phi_3280_ = true;
                                }
                                let _e2693 = phi_3280_;
                                if _e2693 {
                                }
                                phi_1427_ = (_e935 & (_e935 - 1u));
                                phi_3284_ = _e2693;
                            }
                            let _e2695 = phi_1427_;
                            let _e2697 = phi_3284_;
                            continue;
                            continuing {
                                phi_1426_ = _e2695;
                                break if !(_e2697);
                            }
                        }
                        let _e2700 = local_11;
                        if _e2700 {
                            let _e2702 = local_2.group_mask;
                            if ((_e2702 & 4278190080u) == 0u) {
                                let _e2706 = local_2.len;
                                if (_e2706 == 0u) {
                                    phi_3326_ = false;
                                } else {
                                    let _e2710 = local_2.len;
                                    local_2.len = (_e2710 - 1u);
                                    let _e2713 = local_2.len;
                                    if (_e2713 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2718 = local_2.first[(0u + _e2713)];
                                    local_2.group = _e2718;
                                    let _e2721 = local_2.len;
                                    if (_e2721 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2726 = local_2.mask[(0u + _e2721)];
                                    local_2.group_mask = _e2726;
                                    phi_3326_ = true;
                                }
                                let _e2729 = phi_3326_;
                                phi_3327_ = _e2729;
                            } else {
                                phi_3327_ = true;
                            }
                            let _e2731 = phi_3327_;
                            if _e2731 {
                                let _e2733 = local_2.group_mask;
                                let _e2739 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2733)), 32u, (_e2733 == 0u)));
                                let _e2743 = local_2.group_mask;
                                let _e2757 = local_2.group_mask;
                                local_2.group_mask = (_e2757 & ~((1u << bitcast<u32>((_e2739 & 31u)))));
                                let _e2760 = local_2.group;
                                phi_3358_ = (_e2760 + countOneBits(((_e2743 & ~((4294967295u << bitcast<u32>((((_e2739 - 24u) ^ _e361) & 31u))))) & 255u)));
                            } else {
                                phi_3358_ = 4294967295u;
                            }
                            let _e2763 = phi_3358_;
                            phi_3359_ = _e2763;
                        } else {
                            phi_3359_ = u32();
                        }
                        let _e2765 = phi_3359_;
                        phi_1097_ = _e2765;
                        let _e3100 = local_18;
                        phi_3360_ = _e3100;
                        phi_3361_ = false;
                    } else {
                        phi_1097_ = u32();
                        phi_3360_ = false;
                        phi_3361_ = true;
                    }
                    let _e2767 = phi_1097_;
                    let _e2769 = phi_3360_;
                    let _e2771 = phi_3361_;
                    local_12 = _e2771;
                    continue;
                    continuing {
                        phi_1096_ = _e2767;
                        break if !(_e2769);
                    }
                }
                let _e2774 = local_12;
                if _e2774 {
                    phi_3365_ = false;
                } else {
                    phi_3365_ = true;
                }
                let _e2776 = phi_3365_;
                if _e2776 {
                    phi_3369_ = true;
                } else {
                    phi_3369_ = false;
                }
                let _e2778 = phi_3369_;
                phi_3370_ = _e2778;
            }
            let _e2780 = phi_3370_;
            phi_3371_ = _e2780;
            phi_3372_ = _e217;
        } else {
            phi_3371_ = bool();
            phi_3372_ = true;
        }
        let _e2782 = phi_3371_;
        let _e2784 = phi_3372_;
        if _e2784 {
            phi_3376_ = false;
        } else {
            phi_3376_ = _e2782;
        }
        let _e2786 = phi_3376_;
        if _e2786 {
            phi_3380_ = 0f;
        } else {
            phi_3380_ = 1f;
        }
        let _e2788 = phi_3380_;
        if (_e114 < _e83) {
        } else {
            return;
        }
        visibility.member[(0u + _e114)] = _e2788;
        if (_e114 < _e89) {
        } else {
            return;
        }
        let _e2795 = bits.member[(0u + _e114)];
        if ((_e2795 & 2u) == 0u) {
            phi_3401_ = (_e2795 & 1u);
        } else {
            phi_3401_ = (_e2795 & 7u);
        }
        let _e2801 = phi_3401_;
        if (_e114 < _e83) {
        } else {
            return;
        }
        let _e2805 = visibility.member[(0u + _e114)];
        if ((_e2801 & 1u) != 0u) {
            phi_3416_ = (2u | 1u);
        } else {
            phi_3416_ = 2u;
        }
        let _e2811 = phi_3416_;
        if (_e2805 < 0.5f) {
            phi_3421_ = (_e2811 | 4u);
        } else {
            phi_3421_ = _e2811;
        }
        let _e2814 = phi_3421_;
        if (_e114 < _e89) {
        } else {
            return;
        }
        bits.member[(0u + _e114)] = _e2814;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_learn_instanced_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
