struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    number: u32,
    mask_words: u32,
}

struct type_9 {
    member: array<u32>,
}

struct type_13 {
    member: array<vec4<u32>>,
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

struct type_23 {
    member: array<abi_Sample>,
}

struct type_27 {
    member: array<f32>,
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
    light: abi_LightParams,
    test: vec4<f32>,
    size: vec2<u32>,
    map_size: u32,
    epsilon: f32,
    root: u32,
    level_count: u32,
    pad0_: u32,
    pad1_: u32,
}

struct type_37 {
    member: abi_ShadowParams,
}

struct lt_bvh_Node {
    frame: vec4<u32>,
    links: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    z: vec4<u32>,
}

struct type_41 {
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

struct type_45 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_49 {
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

struct type_53 {
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

struct lt_math_Evsm {
    positive_exponent: f32,
    negative_exponent: f32,
    min_variance: f32,
}

struct lt_bvh_LightSpace {
    shear: vec2<f32>,
    diagonal: vec2<f32>,
    middle: vec3<f32>,
    sign: f32,
    low: vec3<f32>,
    is_parallel: u32,
    high: vec3<f32>,
    axis: u32,
    roots: vec4<u32>,
    roots_z: vec4<u32>,
}

struct type_63 {
    member: lt_bvh_LightSpace,
}

struct u0028_lt_bvh_LightPoint_u0020_u32_u0029_ {
    unnamed: lt_math_Evsm,
    unnamed_1: u32,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_23;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_27;
@group(0) @binding(0) 
var<uniform> p: type_37;
@group(0) @binding(2) 
var<storage> nodes: type_41;
@group(0) @binding(3) 
var<storage> triangles: type_45;
@group(0) @binding(5) 
var<storage> list: type_9;
@group(0) @binding(6) 
var<storage> rows: type_13;
@group(0) @binding(7) 
var<uniform> space: type_63;
@group(0) @binding(8) 
var<storage> vertices: type_49;
@group(0) @binding(9) 
var<storage> materials: type_53;
@group(0) @binding(10) 
var<storage> alpha_texels: type_9;

fn core_intrinsics_maximum_number_nsz_f32_(param: f32, param_1: f32) -> f32 {
    var phi_221_: bool;
    var phi_225_: f32;

    if (param != param) {
        phi_221_ = true;
    } else {
        let _e80 = (param_1 >= param);
        if _e80 {
        }
        phi_221_ = _e80;
    }
    let _e82 = phi_221_;
    if _e82 {
        phi_225_ = param_1;
    } else {
        phi_225_ = param;
    }
    let _e84 = phi_225_;
    return _e84;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_2: f32, param_3: f32) -> f32 {
    var phi_237_: bool;
    var phi_241_: f32;

    if (param_2 != param_2) {
        phi_237_ = true;
    } else {
        let _e80 = (param_3 <= param_2);
        if _e80 {
        }
        phi_237_ = _e80;
    }
    let _e82 = phi_237_;
    if _e82 {
        phi_241_ = param_3;
    } else {
        phi_241_ = param_2;
    }
    let _e84 = phi_241_;
    return _e84;
}

fn _lt_shaders_texture_TextureView_quad(param_4: ptr<function, texture_TextureView>, param_5: f32, param_6: f32) -> texture_TexelQuad {
    var phi_283_: f32;
    var phi_288_: f32;
    var phi_289_: bool;
    var phi_290_: f32;
    var phi_291_: bool;
    var phi_295_: f32;
    var phi_321_: f32;
    var phi_326_: f32;
    var phi_327_: bool;
    var phi_328_: f32;
    var phi_329_: bool;
    var phi_333_: f32;
    var phi_341_: f32;
    var phi_342_: f32;
    var phi_343_: f32;
    var phi_352_: f32;
    var phi_353_: f32;
    var phi_371_: u32;
    var phi_385_: u32;
    var phi_392_: u32;
    var phi_397_: u32;
    var phi_403_: u32;
    var phi_408_: u32;
    var phi_410_: texture_Axis;
    var phi_438_: f32;
    var phi_443_: f32;
    var phi_444_: bool;
    var phi_445_: f32;
    var phi_446_: bool;
    var phi_450_: f32;
    var phi_476_: f32;
    var phi_481_: f32;
    var phi_482_: bool;
    var phi_483_: f32;
    var phi_484_: bool;
    var phi_488_: f32;
    var phi_496_: f32;
    var phi_497_: f32;
    var phi_498_: f32;
    var phi_507_: f32;
    var phi_508_: f32;
    var phi_526_: u32;
    var phi_540_: u32;
    var phi_547_: u32;
    var phi_552_: u32;
    var phi_558_: u32;
    var phi_563_: u32;
    var phi_565_: texture_Axis;

    let _e81 = (*param_4).size;
    let _e82 = (_e81 & 65535u);
    let _e84 = (*param_4).size;
    let _e86 = (_e84 >> bitcast<u32>(16i));
    let _e88 = (*param_4).flags;
    let _e90 = ((_e88 & 4u) != 0u);
    let _e92 = (*param_4).flags;
    let _e95 = ((_e92 >> bitcast<u32>(4u)) & 3u);
    if (_e95 == 0u) {
        if (param_5 > -8388608f) {
            let _e108 = f32(select(0i, select(select(i32(param_5), i32(-2147483648), (param_5 < bitcast<f32>(3472883712u))), 2147483647i, (param_5 > bitcast<f32>(1325400063u))), (param_5 == param_5)));
            if (_e108 > param_5) {
                phi_283_ = 1f;
            } else {
                phi_283_ = 0f;
            }
            let _e111 = phi_283_;
            if (param_5 < 8388608f) {
                phi_288_ = (_e108 - _e111);
                phi_289_ = false;
            } else {
                phi_288_ = f32();
                phi_289_ = true;
            }
            let _e114 = phi_288_;
            let _e116 = phi_289_;
            phi_290_ = _e114;
            phi_291_ = _e116;
        } else {
            phi_290_ = f32();
            phi_291_ = true;
        }
        let _e118 = phi_290_;
        let _e120 = phi_291_;
        if _e120 {
            phi_295_ = param_5;
        } else {
            phi_295_ = _e118;
        }
        let _e122 = phi_295_;
        phi_343_ = (param_5 - _e122);
    } else {
        if (_e95 == 1u) {
            let _e125 = (param_5 * 0.5f);
            if (_e125 > -8388608f) {
                let _e137 = f32(select(0i, select(select(i32(_e125), i32(-2147483648), (_e125 < bitcast<f32>(3472883712u))), 2147483647i, (_e125 > bitcast<f32>(1325400063u))), (_e125 == _e125)));
                if (_e137 > _e125) {
                    phi_321_ = 1f;
                } else {
                    phi_321_ = 0f;
                }
                let _e140 = phi_321_;
                if (_e125 < 8388608f) {
                    phi_326_ = (_e137 - _e140);
                    phi_327_ = false;
                } else {
                    phi_326_ = f32();
                    phi_327_ = true;
                }
                let _e143 = phi_326_;
                let _e145 = phi_327_;
                phi_328_ = _e143;
                phi_329_ = _e145;
            } else {
                phi_328_ = f32();
                phi_329_ = true;
            }
            let _e147 = phi_328_;
            let _e149 = phi_329_;
            if _e149 {
                phi_333_ = _e125;
            } else {
                phi_333_ = _e147;
            }
            let _e151 = phi_333_;
            let _e153 = (param_5 - (2f * _e151));
            if (_e153 > 1f) {
                phi_341_ = (2f - _e153);
            } else {
                phi_341_ = _e153;
            }
            let _e157 = phi_341_;
            phi_342_ = _e157;
        } else {
            phi_342_ = param_5;
        }
        let _e159 = phi_342_;
        phi_343_ = _e159;
    }
    let _e161 = phi_343_;
    if (_e161 > 0f) {
        if (_e161 < 1f) {
            phi_352_ = _e161;
        } else {
            phi_352_ = 1f;
        }
        let _e165 = phi_352_;
        phi_353_ = _e165;
    } else {
        phi_353_ = 0f;
    }
    let _e167 = phi_353_;
    let _e168 = (_e82 - 1u);
    let _e170 = (_e167 * f32(_e82));
    if _e90 {
        let _e177 = select(select(u32(_e170), 0u, (_e170 < bitcast<f32>(0u))), 4294967295u, (_e170 > bitcast<f32>(1333788671u)));
        if (_e168 < _e177) {
            phi_371_ = _e168;
        } else {
            phi_371_ = _e177;
        }
        let _e180 = phi_371_;
        phi_410_ = texture_Axis(_e180, _e180, 0f);
    } else {
        let _e182 = (_e170 + 0.5f);
        let _e189 = select(select(u32(_e182), 0u, (_e182 < bitcast<f32>(0u))), 4294967295u, (_e182 > bitcast<f32>(1333788671u)));
        if (_e82 < _e189) {
            phi_385_ = _e82;
        } else {
            phi_385_ = _e189;
        }
        let _e192 = phi_385_;
        if (_e95 == 0u) {
            phi_392_ = _e168;
        } else {
            phi_392_ = 0u;
        }
        let _e197 = phi_392_;
        if (_e95 == 0u) {
            phi_397_ = 0u;
        } else {
            phi_397_ = _e168;
        }
        let _e200 = phi_397_;
        if (_e192 == 0u) {
            phi_403_ = _e197;
        } else {
            phi_403_ = (_e192 - 1u);
        }
        let _e204 = phi_403_;
        if (_e192 > _e168) {
            phi_408_ = _e200;
        } else {
            phi_408_ = _e192;
        }
        let _e207 = phi_408_;
        phi_410_ = texture_Axis(_e204, _e207, (_e182 - f32(_e192)));
    }
    let _e210 = phi_410_;
    let _e212 = (*param_4).flags;
    let _e215 = ((_e212 >> bitcast<u32>(6u)) & 3u);
    if (_e215 == 0u) {
        if (param_6 > -8388608f) {
            let _e228 = f32(select(0i, select(select(i32(param_6), i32(-2147483648), (param_6 < bitcast<f32>(3472883712u))), 2147483647i, (param_6 > bitcast<f32>(1325400063u))), (param_6 == param_6)));
            if (_e228 > param_6) {
                phi_438_ = 1f;
            } else {
                phi_438_ = 0f;
            }
            let _e231 = phi_438_;
            if (param_6 < 8388608f) {
                phi_443_ = (_e228 - _e231);
                phi_444_ = false;
            } else {
                phi_443_ = f32();
                phi_444_ = true;
            }
            let _e234 = phi_443_;
            let _e236 = phi_444_;
            phi_445_ = _e234;
            phi_446_ = _e236;
        } else {
            phi_445_ = f32();
            phi_446_ = true;
        }
        let _e238 = phi_445_;
        let _e240 = phi_446_;
        if _e240 {
            phi_450_ = param_6;
        } else {
            phi_450_ = _e238;
        }
        let _e242 = phi_450_;
        phi_498_ = (param_6 - _e242);
    } else {
        if (_e215 == 1u) {
            let _e245 = (param_6 * 0.5f);
            if (_e245 > -8388608f) {
                let _e257 = f32(select(0i, select(select(i32(_e245), i32(-2147483648), (_e245 < bitcast<f32>(3472883712u))), 2147483647i, (_e245 > bitcast<f32>(1325400063u))), (_e245 == _e245)));
                if (_e257 > _e245) {
                    phi_476_ = 1f;
                } else {
                    phi_476_ = 0f;
                }
                let _e260 = phi_476_;
                if (_e245 < 8388608f) {
                    phi_481_ = (_e257 - _e260);
                    phi_482_ = false;
                } else {
                    phi_481_ = f32();
                    phi_482_ = true;
                }
                let _e263 = phi_481_;
                let _e265 = phi_482_;
                phi_483_ = _e263;
                phi_484_ = _e265;
            } else {
                phi_483_ = f32();
                phi_484_ = true;
            }
            let _e267 = phi_483_;
            let _e269 = phi_484_;
            if _e269 {
                phi_488_ = _e245;
            } else {
                phi_488_ = _e267;
            }
            let _e271 = phi_488_;
            let _e273 = (param_6 - (2f * _e271));
            if (_e273 > 1f) {
                phi_496_ = (2f - _e273);
            } else {
                phi_496_ = _e273;
            }
            let _e277 = phi_496_;
            phi_497_ = _e277;
        } else {
            phi_497_ = param_6;
        }
        let _e279 = phi_497_;
        phi_498_ = _e279;
    }
    let _e281 = phi_498_;
    if (_e281 > 0f) {
        if (_e281 < 1f) {
            phi_507_ = _e281;
        } else {
            phi_507_ = 1f;
        }
        let _e285 = phi_507_;
        phi_508_ = _e285;
    } else {
        phi_508_ = 0f;
    }
    let _e287 = phi_508_;
    let _e288 = (_e86 - 1u);
    let _e290 = (_e287 * f32(_e86));
    if _e90 {
        let _e297 = select(select(u32(_e290), 0u, (_e290 < bitcast<f32>(0u))), 4294967295u, (_e290 > bitcast<f32>(1333788671u)));
        if (_e288 < _e297) {
            phi_526_ = _e288;
        } else {
            phi_526_ = _e297;
        }
        let _e300 = phi_526_;
        phi_565_ = texture_Axis(_e300, _e300, 0f);
    } else {
        let _e302 = (_e290 + 0.5f);
        let _e309 = select(select(u32(_e302), 0u, (_e302 < bitcast<f32>(0u))), 4294967295u, (_e302 > bitcast<f32>(1333788671u)));
        if (_e86 < _e309) {
            phi_540_ = _e86;
        } else {
            phi_540_ = _e309;
        }
        let _e312 = phi_540_;
        if (_e215 == 0u) {
            phi_547_ = _e288;
        } else {
            phi_547_ = 0u;
        }
        let _e317 = phi_547_;
        if (_e215 == 0u) {
            phi_552_ = 0u;
        } else {
            phi_552_ = _e288;
        }
        let _e320 = phi_552_;
        if (_e312 == 0u) {
            phi_558_ = _e317;
        } else {
            phi_558_ = (_e312 - 1u);
        }
        let _e324 = phi_558_;
        if (_e312 > _e288) {
            phi_563_ = _e320;
        } else {
            phi_563_ = _e312;
        }
        let _e327 = phi_563_;
        phi_565_ = texture_Axis(_e324, _e327, (_e302 - f32(_e312)));
    }
    let _e330 = phi_565_;
    let _e334 = (*param_4).offset;
    let _e341 = (*param_4).offset;
    let _e348 = (*param_4).offset;
    let _e355 = (*param_4).offset;
    return texture_TexelQuad(array<u32, 4>(((_e334 + (_e330.low * _e82)) + _e210.low), ((_e341 + (_e330.low * _e82)) + _e210.high), ((_e348 + (_e330.high * _e82)) + _e210.low), ((_e355 + (_e330.high * _e82)) + _e210.high)), vec4<f32>(((1f - _e210.fraction) * (1f - _e330.fraction)), (_e210.fraction * (1f - _e330.fraction)), ((1f - _e210.fraction) * _e330.fraction), (_e210.fraction * _e330.fraction)));
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var local_2: texture_TextureView;
    var local_3: array<u32, 32>;
    var phi_715_: f32;
    var phi_748_: bool;
    var phi_749_: bool;
    var phi_750_: bool;
    var phi_751_: bool;
    var phi_755_: bool;
    var phi_768_: bool;
    var phi_769_: bool;
    var phi_770_: bool;
    var phi_771_: bool;
    var phi_775_: bool;
    var phi_788_: bool;
    var phi_789_: bool;
    var phi_790_: bool;
    var phi_794_: bool;
    var phi_795_: bool;
    var phi_796_: bool;
    var phi_797_: bool;
    var phi_798_: bool;
    var phi_802_: bool;
    var phi_825_: bool;
    var phi_826_: bool;
    var phi_827_: bool;
    var phi_828_: bool;
    var phi_829_: bool;
    var phi_830_: bool;
    var phi_834_: bool;
    var phi_847_: bool;
    var phi_848_: bool;
    var phi_849_: bool;
    var phi_853_: bool;
    var phi_870_: bool;
    var phi_871_: bool;
    var phi_872_: bool;
    var phi_873_: bool;
    var phi_874_: bool;
    var phi_875_: bool;
    var phi_876_: bool;
    var phi_880_: bool;
    var phi_900_: bool;
    var phi_901_: bool;
    var phi_909_: u32;
    var phi_910_: f32;
    var phi_911_: u32;
    var phi_912_: f32;
    var phi_917_: f32;
    var phi_928_: u32;
    var phi_938_: u32;
    var phi_944_: u32;
    var phi_945_: u32;
    var phi_946_: u32;
    var phi_957_: vec3<f32>;
    var phi_958_: vec3<f32>;
    var phi_980_: vec3<f32>;
    var phi_981_: vec3<f32>;
    var phi_1003_: u0028_lt_bvh_LightPoint_u0020_u32_u0029_;
    var phi_1078_: f32;
    var phi_1085_: f32;
    var phi_1092_: f32;
    var phi_1099_: f32;
    var phi_1106_: f32;
    var phi_1113_: f32;
    var phi_1130_: f32;
    var phi_1135_: f32;
    var phi_1140_: f32;
    var phi_1145_: f32;
    var phi_1150_: f32;
    var phi_1172_: bool;
    var phi_1173_: bool;
    var phi_1181_: u32;
    var phi_1182_: u32;
    var phi_1193_: vec3<f32>;
    var phi_1194_: vec3<f32>;
    var phi_1206_: u32;
    var phi_1209_: u32;
    var phi_1214_: u32;
    var phi_1216_: u32;
    var phi_1218_: u32;
    var phi_1220_: u32;
    var phi_1292_: f32;
    var phi_1293_: f32;
    var phi_1307_: u32;
    var phi_1330_: f32;
    var phi_1331_: f32;
    var phi_1345_: u32;
    var phi_1367_: f32;
    var phi_1368_: f32;
    var phi_1382_: u32;
    var phi_1405_: f32;
    var phi_1406_: f32;
    var phi_1420_: u32;
    var phi_1612_: u32;
    var phi_1613_: u32;
    var phi_1618_: u32;
    var phi_1619_: u32;
    var phi_1620_: u32;
    var phi_1217_: u32;
    var phi_1219_: u32;
    var phi_1621_: u32;
    var phi_1639_: u32;
    var phi_1640_: u32;
    var phi_1207_: u32;
    var phi_1210_: u32;
    var phi_1649_: bool;
    var phi_1650_: bool;
    var phi_1651_: bool;
    var local_4: bool;
    var local_5: u32;
    var phi_1660_: u32;
    var local_6: u32;
    var phi_1695_: u32;
    var phi_1696_: u32;
    var phi_1702_: u32;
    var phi_1730_: vec3<f32>;
    var phi_1731_: vec3<f32>;
    var phi_1760_: vec3<f32>;
    var phi_1761_: vec3<f32>;
    var phi_1790_: vec3<f32>;
    var phi_1791_: vec3<f32>;
    var phi_1809_: bool;
    var phi_1810_: bool;
    var phi_1814_: f32;
    var phi_1815_: f32;
    var phi_1816_: f32;
    var phi_1817_: f32;
    var phi_1825_: f32;
    var phi_1835_: bool;
    var phi_1836_: bool;
    var phi_1840_: f32;
    var phi_1841_: f32;
    var phi_1842_: f32;
    var phi_1843_: f32;
    var phi_1851_: f32;
    var phi_1861_: bool;
    var phi_1862_: bool;
    var phi_1866_: f32;
    var phi_1867_: f32;
    var phi_1868_: f32;
    var phi_1869_: f32;
    var phi_1877_: f32;
    var phi_1892_: f32;
    var phi_1893_: bool;
    var phi_1894_: f32;
    var phi_1895_: bool;
    var phi_1896_: f32;
    var phi_1897_: bool;
    var phi_1915_: f32;
    var phi_1916_: bool;
    var phi_1917_: bool;
    var phi_1918_: f32;
    var phi_1919_: bool;
    var phi_1920_: bool;
    var phi_1924_: bool;
    var phi_1925_: f32;
    var phi_1926_: bool;
    var phi_1954_: vec3<f32>;
    var phi_1955_: vec3<f32>;
    var phi_1980_: vec3<f32>;
    var phi_1981_: vec3<f32>;
    var phi_2006_: vec3<f32>;
    var phi_2007_: vec3<f32>;
    var phi_2063_: f32;
    var phi_2072_: f32;
    var phi_2081_: f32;
    var phi_2090_: f32;
    var phi_2097_: f32;
    var phi_2104_: f32;
    var phi_2117_: f32;
    var phi_2126_: f32;
    var phi_2135_: f32;
    var phi_2144_: f32;
    var phi_2151_: f32;
    var phi_2158_: f32;
    var phi_2175_: f32;
    var phi_2180_: f32;
    var phi_2185_: f32;
    var phi_2193_: f32;
    var phi_2198_: f32;
    var phi_2203_: f32;
    var phi_2215_: f32;
    var phi_2220_: f32;
    var phi_2225_: f32;
    var phi_2230_: f32;
    var phi_2235_: lt_bvh_triangle_Intersection;
    var phi_2236_: bool;
    var phi_2237_: lt_bvh_triangle_Intersection;
    var phi_2238_: bool;
    var phi_2242_: lt_bvh_triangle_Intersection;
    var phi_2243_: bool;
    var phi_2244_: lt_bvh_triangle_Intersection;
    var phi_2245_: bool;
    var phi_2246_: bool;
    var phi_2250_: bool;
    var phi_2254_: lt_bvh_triangle_Intersection;
    var phi_2468_: f32;
    var phi_2471_: bool;
    var phi_2472_: bool;
    var phi_2476_: bool;
    var phi_2477_: bool;
    var phi_2478_: bool;
    var phi_2479_: bool;
    var phi_2480_: bool;
    var phi_2481_: bool;
    var phi_2482_: bool;
    var phi_2483_: bool;
    var phi_2484_: bool;
    var phi_2485_: bool;
    var phi_2486_: bool;
    var phi_2487_: bool;
    var phi_2488_: bool;
    var phi_2489_: bool;
    var phi_2493_: bool;
    var phi_2494_: bool;
    var phi_2495_: bool;
    var phi_2503_: bool;
    var phi_2504_: bool;
    var phi_2505_: bool;
    var phi_2506_: bool;
    var phi_2507_: bool;
    var local_7: bool;
    var phi_2511_: bool;
    var phi_2512_: bool;
    var phi_2513_: bool;
    var phi_2514_: bool;
    var phi_2515_: bool;
    var local_8: u32;
    var phi_2523_: bool;
    var phi_2524_: bool;
    var phi_2525_: bool;
    var phi_2526_: bool;
    var local_9: bool;
    var phi_2530_: bool;
    var phi_2534_: bool;
    var phi_2538_: bool;
    var phi_2539_: bool;
    var phi_2555_: bool;
    var phi_2556_: bool;
    var phi_2557_: bool;
    var phi_2558_: bool;
    var phi_2562_: bool;
    var phi_2575_: bool;
    var phi_2576_: bool;
    var phi_2577_: bool;
    var phi_2578_: bool;
    var phi_2582_: bool;
    var phi_2595_: bool;
    var phi_2596_: bool;
    var phi_2597_: bool;
    var phi_2601_: bool;
    var phi_2602_: bool;
    var phi_2603_: bool;
    var phi_2604_: bool;
    var phi_2605_: bool;
    var phi_2609_: bool;
    var phi_2679_: f32;
    var phi_2686_: f32;
    var phi_2693_: f32;
    var phi_2700_: f32;
    var phi_2707_: f32;
    var phi_2714_: f32;
    var phi_2731_: f32;
    var phi_2736_: f32;
    var phi_2741_: f32;
    var phi_2746_: f32;
    var phi_2751_: f32;
    var phi_2777_: bool;
    var phi_2778_: bool;
    var phi_2786_: u32;
    var phi_2787_: u32;
    var phi_2798_: vec3<f32>;
    var phi_2799_: vec3<f32>;
    var phi_2812_: u32;
    var phi_2817_: u32;
    var phi_2822_: u32;
    var phi_2936_: bool;
    var phi_2937_: bool;
    var phi_2968_: u32;
    var phi_2970_: u32;
    var phi_2973_: bool;
    var phi_3053_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_3080_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_3107_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_3113_: u32;
    var phi_3116_: u32;
    var phi_3130_: u32;
    var phi_3140_: u32;
    var phi_3150_: u32;
    var phi_3168_: u32;
    var phi_3178_: u32;
    var phi_3188_: u32;
    var phi_3224_: u32;
    var phi_3237_: u32;
    var phi_3242_: u32;
    var phi_3243_: u32;
    var phi_3244_: u32;
    var phi_3114_: u32;
    var phi_3117_: u32;
    var local_10: u32;
    var local_11: u32;
    var local_12: u32;
    var phi_3302_: u32;
    var phi_3305_: bool;
    var phi_3349_: vec3<f32>;
    var phi_3350_: vec3<f32>;
    var phi_3379_: vec3<f32>;
    var phi_3380_: vec3<f32>;
    var phi_3409_: vec3<f32>;
    var phi_3410_: vec3<f32>;
    var phi_3428_: bool;
    var phi_3429_: bool;
    var phi_3433_: f32;
    var phi_3434_: f32;
    var phi_3435_: f32;
    var phi_3436_: f32;
    var phi_3444_: f32;
    var phi_3454_: bool;
    var phi_3455_: bool;
    var phi_3459_: f32;
    var phi_3460_: f32;
    var phi_3461_: f32;
    var phi_3462_: f32;
    var phi_3470_: f32;
    var phi_3480_: bool;
    var phi_3481_: bool;
    var phi_3485_: f32;
    var phi_3486_: f32;
    var phi_3487_: f32;
    var phi_3488_: f32;
    var phi_3496_: f32;
    var phi_3511_: f32;
    var phi_3512_: bool;
    var phi_3513_: f32;
    var phi_3514_: bool;
    var phi_3515_: f32;
    var phi_3516_: bool;
    var phi_3534_: f32;
    var phi_3535_: bool;
    var phi_3536_: bool;
    var phi_3537_: f32;
    var phi_3538_: bool;
    var phi_3539_: bool;
    var phi_3543_: bool;
    var phi_3544_: f32;
    var phi_3545_: bool;
    var phi_3573_: vec3<f32>;
    var phi_3574_: vec3<f32>;
    var phi_3599_: vec3<f32>;
    var phi_3600_: vec3<f32>;
    var phi_3625_: vec3<f32>;
    var phi_3626_: vec3<f32>;
    var phi_3682_: f32;
    var phi_3691_: f32;
    var phi_3700_: f32;
    var phi_3709_: f32;
    var phi_3716_: f32;
    var phi_3723_: f32;
    var phi_3736_: f32;
    var phi_3745_: f32;
    var phi_3754_: f32;
    var phi_3763_: f32;
    var phi_3770_: f32;
    var phi_3777_: f32;
    var phi_3794_: f32;
    var phi_3799_: f32;
    var phi_3804_: f32;
    var phi_3812_: f32;
    var phi_3817_: f32;
    var phi_3822_: f32;
    var phi_3834_: f32;
    var phi_3839_: f32;
    var phi_3844_: f32;
    var phi_3849_: f32;
    var phi_3854_: lt_bvh_triangle_Intersection;
    var phi_3855_: bool;
    var phi_3856_: lt_bvh_triangle_Intersection;
    var phi_3857_: bool;
    var phi_3861_: lt_bvh_triangle_Intersection;
    var phi_3862_: bool;
    var phi_3863_: lt_bvh_triangle_Intersection;
    var phi_3864_: bool;
    var phi_3865_: bool;
    var phi_3869_: bool;
    var phi_3873_: lt_bvh_triangle_Intersection;
    var phi_4087_: f32;
    var phi_4090_: bool;
    var phi_4091_: bool;
    var phi_4092_: bool;
    var phi_4096_: bool;
    var phi_4097_: bool;
    var phi_4098_: bool;
    var phi_4099_: bool;
    var phi_4100_: bool;
    var phi_4101_: bool;
    var phi_4102_: bool;
    var phi_4103_: bool;
    var phi_4104_: bool;
    var phi_4105_: bool;
    var phi_3303_: u32;
    var phi_3306_: bool;
    var phi_4109_: bool;
    var phi_4110_: bool;
    var local_13: bool;
    var phi_4152_: bool;
    var phi_4153_: bool;
    var phi_4184_: u32;
    var phi_4185_: u32;
    var phi_2971_: u32;
    var phi_2974_: bool;
    var phi_4186_: bool;
    var phi_4187_: bool;
    var phi_4188_: bool;
    var local_14: bool;
    var phi_4192_: bool;
    var phi_4196_: bool;
    var phi_4197_: bool;
    var phi_4198_: bool;
    var phi_4199_: bool;
    var phi_4203_: bool;
    var phi_4204_: bool;
    var phi_4205_: bool;
    var phi_4209_: f32;
    var local_15: u32;
    var local_16: u32;
    var local_17: u32;
    var local_18: bool;
    var local_19: bool;
    var local_20: bool;
    var local_21: bool;
    var local_22: bool;
    var local_23: bool;
    var local_24: bool;
    var local_25: bool;
    var local_26: bool;
    var local_27: bool;

    let _e81 = id_1;
    let _e88 = arrayLength((&nodes.member));
    let _e91 = arrayLength((&triangles.member));
    let _e97 = arrayLength((&list.member));
    let _e100 = arrayLength((&rows.member));
    let _e104 = arrayLength((&vertices.member));
    let _e107 = arrayLength((&materials.member));
    let _e110 = arrayLength((&alpha_texels.member));
    let _e114 = ((_e81.y * 2097152u) + _e81.x);
    if (3u < _e97) {
    } else {
        return;
    }
    let _e117 = list.member[3u];
    if (_e114 < _e117) {
        let _e119 = (_e114 + 4u);
        if (_e119 < _e97) {
        } else {
            return;
        }
        let _e123 = list.member[(0u + _e119)];
        let _e124 = (_e123 & 2147483647u);
        let _e125 = space.member;
        if (_e124 < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e131 = samples.member[(0u + _e124)].position;
        let _e133 = samples.member[(0u + _e124)].normal;
        let _e135 = samples.member[(0u + _e124)].magnitude;
        let _e137 = ((8f / 8388608f) * _e135);
        let _e139 = (_e133.x * _e137);
        let _e141 = (_e133.y * _e137);
        let _e143 = (_e133.z * _e137);
        let _e145 = (_e131.x + _e139);
        let _e147 = (_e131.y + _e141);
        let _e149 = (_e131.z + _e143);
        let _e153 = p.member.light.place;
        if (_e153.w == 0f) {
            phi_715_ = 300000000000000000000000000000000000000f;
        } else {
            phi_715_ = 1f;
        }
        let _e157 = phi_715_;
        let _e165 = (_e153.x - (_e145 * _e153.w));
        let _e166 = (_e153.y - (_e147 * _e153.w));
        let _e167 = (_e153.z - (_e149 * _e153.w));
        let _e168 = vec3<f32>(_e165, _e166, _e167);
        let _e169 = abs(_e165);
        let _e170 = abs(_e166);
        let _e171 = abs(_e167);
        if (abs(_e145) < 1000000000000000f) {
            if (abs(_e147) < 1000000000000000f) {
                phi_748_ = (abs(_e149) < 1000000000000000f);
                phi_749_ = false;
            } else {
                phi_748_ = bool();
                phi_749_ = true;
            }
            let _e179 = phi_748_;
            let _e181 = phi_749_;
            phi_750_ = _e179;
            phi_751_ = _e181;
        } else {
            phi_750_ = bool();
            phi_751_ = true;
        }
        let _e183 = phi_750_;
        let _e185 = phi_751_;
        if _e185 {
            phi_755_ = false;
        } else {
            phi_755_ = _e183;
        }
        let _e187 = phi_755_;
        if _e187 {
            if (_e169 < 1000000000000000f) {
                if (_e170 < 1000000000000000f) {
                    phi_768_ = (_e171 < 1000000000000000f);
                    phi_769_ = false;
                } else {
                    phi_768_ = bool();
                    phi_769_ = true;
                }
                let _e192 = phi_768_;
                let _e194 = phi_769_;
                phi_770_ = _e192;
                phi_771_ = _e194;
            } else {
                phi_770_ = bool();
                phi_771_ = true;
            }
            let _e196 = phi_770_;
            let _e198 = phi_771_;
            if _e198 {
                phi_775_ = false;
            } else {
                phi_775_ = _e196;
            }
            let _e200 = phi_775_;
            if _e200 {
                if (_e169 > 0f) {
                    phi_789_ = bool();
                    phi_790_ = true;
                } else {
                    let _e202 = (_e170 > 0f);
                    if _e202 {
                        phi_788_ = bool();
                    } else {
                        phi_788_ = (_e171 > 0f);
                    }
                    let _e205 = phi_788_;
                    phi_789_ = _e205;
                    phi_790_ = _e202;
                }
                let _e207 = phi_789_;
                let _e209 = phi_790_;
                if _e209 {
                    phi_794_ = true;
                } else {
                    phi_794_ = _e207;
                }
                let _e211 = phi_794_;
                phi_795_ = _e211;
                phi_796_ = false;
            } else {
                phi_795_ = bool();
                phi_796_ = true;
            }
            let _e213 = phi_795_;
            let _e215 = phi_796_;
            phi_797_ = _e213;
            phi_798_ = _e215;
        } else {
            phi_797_ = bool();
            phi_798_ = true;
        }
        let _e217 = phi_797_;
        let _e219 = phi_798_;
        if _e219 {
            phi_802_ = false;
        } else {
            phi_802_ = _e217;
        }
        let _e221 = phi_802_;
        if _e221 {
            if (_e125.low.x <= _e145) {
                if (_e145 <= _e125.high.x) {
                    if (_e125.low.y <= _e147) {
                        phi_825_ = (_e147 <= _e125.high.y);
                        phi_826_ = false;
                    } else {
                        phi_825_ = bool();
                        phi_826_ = true;
                    }
                    let _e239 = phi_825_;
                    let _e241 = phi_826_;
                    phi_827_ = _e239;
                    phi_828_ = _e241;
                } else {
                    phi_827_ = bool();
                    phi_828_ = true;
                }
                let _e243 = phi_827_;
                let _e245 = phi_828_;
                phi_829_ = _e243;
                phi_830_ = _e245;
            } else {
                phi_829_ = bool();
                phi_830_ = true;
            }
            let _e247 = phi_829_;
            let _e249 = phi_830_;
            if _e249 {
                phi_834_ = false;
            } else {
                phi_834_ = _e247;
            }
            let _e251 = phi_834_;
            if (abs(_e165) > 0.000000000000000000000000000001f) {
                phi_848_ = bool();
                phi_849_ = true;
            } else {
                let _e256 = (abs(_e166) > 0.000000000000000000000000000001f);
                if _e256 {
                    phi_847_ = bool();
                } else {
                    phi_847_ = (abs(_e167) > 0.000000000000000000000000000001f);
                }
                let _e259 = phi_847_;
                phi_848_ = _e259;
                phi_849_ = _e256;
            }
            let _e261 = phi_848_;
            let _e263 = phi_849_;
            if _e263 {
                phi_853_ = true;
            } else {
                phi_853_ = _e261;
            }
            let _e265 = phi_853_;
            if _e251 {
                if (_e125.low.z <= _e149) {
                    if (_e149 <= _e125.high.z) {
                        if (_e125.is_parallel == 0u) {
                            phi_870_ = _e265;
                        } else {
                            phi_870_ = true;
                        }
                        let _e271 = phi_870_;
                        phi_871_ = _e271;
                        phi_872_ = false;
                    } else {
                        phi_871_ = bool();
                        phi_872_ = true;
                    }
                    let _e273 = phi_871_;
                    let _e275 = phi_872_;
                    phi_873_ = _e273;
                    phi_874_ = _e275;
                } else {
                    phi_873_ = bool();
                    phi_874_ = true;
                }
                let _e277 = phi_873_;
                let _e279 = phi_874_;
                phi_875_ = _e277;
                phi_876_ = _e279;
            } else {
                phi_875_ = bool();
                phi_876_ = true;
            }
            let _e281 = phi_875_;
            let _e283 = phi_876_;
            if _e283 {
                phi_880_ = false;
            } else {
                phi_880_ = _e281;
            }
            let _e285 = phi_880_;
            if _e285 {
                if (_e125.is_parallel == 0u) {
                    let _e288 = abs(_e165);
                    let _e289 = abs(_e166);
                    let _e290 = abs(_e167);
                    if (_e288 >= _e289) {
                        if (_e288 >= _e290) {
                            phi_900_ = false;
                        } else {
                            phi_900_ = true;
                        }
                        let _e294 = phi_900_;
                        phi_901_ = _e294;
                    } else {
                        phi_901_ = true;
                    }
                    let _e296 = phi_901_;
                    if _e296 {
                        if (_e289 >= _e290) {
                            phi_909_ = 1u;
                            phi_910_ = _e166;
                        } else {
                            phi_909_ = 2u;
                            phi_910_ = _e167;
                        }
                        let _e299 = phi_909_;
                        let _e301 = phi_910_;
                        phi_911_ = _e299;
                        phi_912_ = _e301;
                    } else {
                        phi_911_ = 0u;
                        phi_912_ = _e165;
                    }
                    let _e303 = phi_911_;
                    let _e305 = phi_912_;
                    if (_e305 < 0f) {
                        phi_917_ = -1f;
                    } else {
                        phi_917_ = 1f;
                    }
                    let _e308 = phi_917_;
                    let _e309 = (_e308 < 0f);
                    if (_e303 == 0u) {
                        if _e309 {
                            phi_928_ = _e125.roots.y;
                        } else {
                            phi_928_ = _e125.roots.x;
                        }
                        let _e316 = phi_928_;
                        phi_946_ = _e316;
                    } else {
                        if (_e303 == 1u) {
                            if _e309 {
                                phi_938_ = _e125.roots.w;
                            } else {
                                phi_938_ = _e125.roots.z;
                            }
                            let _e323 = phi_938_;
                            phi_945_ = _e323;
                        } else {
                            if _e309 {
                                phi_944_ = _e125.roots_z.y;
                            } else {
                                phi_944_ = _e125.roots_z.x;
                            }
                            let _e329 = phi_944_;
                            phi_945_ = _e329;
                        }
                        let _e331 = phi_945_;
                        phi_946_ = _e331;
                    }
                    let _e333 = phi_946_;
                    if (_e303 == 0u) {
                        phi_958_ = vec3<f32>(_e166, _e167, _e165);
                    } else {
                        if (_e303 == 1u) {
                            phi_957_ = vec3<f32>(_e167, _e165, _e166);
                        } else {
                            phi_957_ = _e168;
                        }
                        let _e339 = phi_957_;
                        phi_958_ = _e339;
                    }
                    let _e341 = phi_958_;
                    phi_1003_ = u0028_lt_bvh_LightPoint_u0020_u32_u0029_(lt_math_Evsm((_e341.x / _e341.z), (_e341.y / _e341.z), (_e308 / _e341.z)), _e333);
                } else {
                    if (_e125.axis == 0u) {
                        phi_981_ = vec3<f32>(_e147, _e149, _e145);
                    } else {
                        if (_e125.axis == 1u) {
                            phi_980_ = vec3<f32>(_e149, _e145, _e147);
                        } else {
                            phi_980_ = (_e131 + vec3<f32>(_e139, _e141, _e143));
                        }
                        let _e358 = phi_980_;
                        phi_981_ = _e358;
                    }
                    let _e360 = phi_981_;
                    let _e375 = (_e360.z - _e125.middle.z);
                    phi_1003_ = u0028_lt_bvh_LightPoint_u0020_u32_u0029_(lt_math_Evsm(((_e360.x - _e125.middle.x) - (_e125.shear.x * _e375)), ((_e360.y - _e125.middle.y) - (_e125.shear.y * _e375)), (_e125.sign * _e375)), _e125.roots.x);
                }
                let _e386 = phi_1003_;
                if (_e386.unnamed_1 == 4294967295u) {
                    phi_2539_ = false;
                } else {
                    if (0u < _e88) {
                    } else {
                        return;
                    }
                    let _e403 = nodes.member[0u].frame[0u];
                    let _e407 = nodes.member[0u].frame[1u];
                    let _e411 = nodes.member[0u].frame[2u];
                    let _e415 = nodes.member[0u].frame[0u];
                    let _e419 = nodes.member[0u].frame[1u];
                    let _e423 = nodes.member[0u].frame[2u];
                    let _e427 = nodes.member[0u].frame[3u];
                    let _e461 = core_intrinsics_maximum_number_nsz_f32_(abs(_e165), abs(_e166));
                    let _e462 = core_intrinsics_maximum_number_nsz_f32_(_e461, abs(_e167));
                    let _e463 = (_e462 * 0.0000000000009094947f);
                    if (abs(_e165) < _e463) {
                        phi_1078_ = _e463;
                    } else {
                        phi_1078_ = abs(_e165);
                    }
                    let _e468 = phi_1078_;
                    if (_e165 < 0f) {
                        phi_1085_ = (-1f / _e468);
                    } else {
                        phi_1085_ = (1f / _e468);
                    }
                    let _e473 = phi_1085_;
                    if (abs(_e166) < _e463) {
                        phi_1092_ = _e463;
                    } else {
                        phi_1092_ = abs(_e166);
                    }
                    let _e478 = phi_1092_;
                    if (_e166 < 0f) {
                        phi_1099_ = (-1f / _e478);
                    } else {
                        phi_1099_ = (1f / _e478);
                    }
                    let _e483 = phi_1099_;
                    if (abs(_e167) < _e463) {
                        phi_1106_ = _e463;
                    } else {
                        phi_1106_ = abs(_e167);
                    }
                    let _e488 = phi_1106_;
                    if (_e167 < 0f) {
                        phi_1113_ = (-1f / _e488);
                    } else {
                        phi_1113_ = (1f / _e488);
                    }
                    let _e493 = phi_1113_;
                    let _e497 = abs((bitcast<f32>(_e403) - _e145));
                    let _e498 = abs((bitcast<f32>(_e407) - _e147));
                    let _e499 = abs((bitcast<f32>(_e411) - _e149));
                    let _e503 = abs(((bitcast<f32>(_e415) + (bitcast<f32>((((_e427 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e145));
                    let _e504 = abs(((bitcast<f32>(_e419) + (bitcast<f32>((((_e427 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e147));
                    let _e505 = abs(((bitcast<f32>(_e423) + (bitcast<f32>((((_e427 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e149));
                    if (_e497 > _e503) {
                        phi_1130_ = _e497;
                    } else {
                        phi_1130_ = _e503;
                    }
                    let _e508 = phi_1130_;
                    if (_e498 > _e504) {
                        phi_1135_ = _e498;
                    } else {
                        phi_1135_ = _e504;
                    }
                    let _e511 = phi_1135_;
                    if (_e499 > _e505) {
                        phi_1140_ = _e499;
                    } else {
                        phi_1140_ = _e505;
                    }
                    let _e514 = phi_1140_;
                    if (_e508 > _e511) {
                        phi_1145_ = _e508;
                    } else {
                        phi_1145_ = _e511;
                    }
                    let _e517 = phi_1145_;
                    if (_e517 > _e514) {
                        phi_1150_ = _e517;
                    } else {
                        phi_1150_ = _e514;
                    }
                    let _e520 = phi_1150_;
                    let _e527 = (_e520 * 0.0000009536743f);
                    let _e528 = (abs(_e473) * _e527);
                    let _e529 = (abs(_e483) * _e527);
                    let _e530 = (abs(_e493) * _e527);
                    let _e531 = abs(_e165);
                    let _e532 = abs(_e166);
                    let _e533 = abs(_e167);
                    if (_e531 >= _e532) {
                        if (_e531 >= _e533) {
                            phi_1172_ = false;
                        } else {
                            phi_1172_ = true;
                        }
                        let _e537 = phi_1172_;
                        phi_1173_ = _e537;
                    } else {
                        phi_1173_ = true;
                    }
                    let _e539 = phi_1173_;
                    if _e539 {
                        if (_e532 >= _e533) {
                            phi_1181_ = 1u;
                        } else {
                            phi_1181_ = 2u;
                        }
                        let _e542 = phi_1181_;
                        phi_1182_ = _e542;
                    } else {
                        phi_1182_ = 0u;
                    }
                    let _e544 = phi_1182_;
                    if (_e544 == 0u) {
                        phi_1194_ = vec3<f32>(_e166, _e167, _e165);
                    } else {
                        if (_e544 == 1u) {
                            phi_1193_ = vec3<f32>(_e167, _e165, _e166);
                        } else {
                            phi_1193_ = _e168;
                        }
                        let _e550 = phi_1193_;
                        phi_1194_ = _e550;
                    }
                    let _e552 = phi_1194_;
                    let _e555 = (_e552.x / _e552.z);
                    let _e558 = (_e552.y / _e552.z);
                    local_3 = array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    phi_1206_ = ((_e386.unnamed_1 << bitcast<u32>(8i)) | 1u);
                    phi_1209_ = 0u;
                    loop {
                        let _e565 = phi_1206_;
                        let _e567 = phi_1209_;
                        phi_1214_ = _e565;
                        phi_1216_ = 0u;
                        phi_1218_ = 0u;
                        phi_1220_ = _e567;
                        loop {
                            let _e569 = phi_1214_;
                            let _e571 = phi_1216_;
                            let _e573 = phi_1218_;
                            let _e575 = phi_1220_;
                            let _e582 = (((_e569 >> bitcast<u32>(8i)) + select(firstTrailingBit(_e569), 32u, (_e569 == 0u))) * 5u);
                            if (_e582 < _e100) {
                            } else {
                                return;
                            }
                            let _e586 = rows.member[(0u + _e582)];
                            let _e587 = (_e582 + 1u);
                            if (_e587 < _e100) {
                            } else {
                                return;
                            }
                            let _e591 = rows.member[(0u + _e587)];
                            let _e592 = (_e582 + 2u);
                            if (_e592 < _e100) {
                            } else {
                                return;
                            }
                            let _e596 = rows.member[(0u + _e592)];
                            let _e597 = (_e582 + 3u);
                            if (_e597 < _e100) {
                            } else {
                                return;
                            }
                            let _e601 = rows.member[(0u + _e597)];
                            let _e602 = (_e582 + 4u);
                            if (_e602 < _e100) {
                            } else {
                                return;
                            }
                            let _e606 = rows.member[(0u + _e602)];
                            let _e607 = lt_bvh_Node(_e586, _e591, _e596, _e601, _e606);
                            let _e609 = (_e569 & (_e569 - 1u));
                            let _e621 = (_e386.unnamed.positive_exponent - bitcast<f32>(_e607.frame.x));
                            let _e624 = bitcast<f32>((((_e607.z.z >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                            if (_e621 > 0f) {
                                if (_e621 < (255f * _e624)) {
                                    phi_1292_ = (_e621 / _e624);
                                } else {
                                    phi_1292_ = 255f;
                                }
                                let _e630 = phi_1292_;
                                phi_1293_ = _e630;
                            } else {
                                phi_1293_ = 0f;
                            }
                            let _e632 = phi_1293_;
                            let _e639 = select(select(u32(_e632), 0u, (_e632 < bitcast<f32>(0u))), 4294967295u, (_e632 > bitcast<f32>(1333788671u)));
                            if (f32(_e639) < _e632) {
                                phi_1307_ = (_e639 + 1u);
                            } else {
                                phi_1307_ = _e639;
                            }
                            let _e644 = phi_1307_;
                            let _e645 = (_e639 * 16843009u);
                            let _e646 = (_e644 * 16843009u);
                            let _e656 = (_e386.unnamed.negative_exponent - bitcast<f32>(_e607.frame.y));
                            let _e659 = bitcast<f32>((((_e607.z.z >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                            if (_e656 > 0f) {
                                if (_e656 < (255f * _e659)) {
                                    phi_1330_ = (_e656 / _e659);
                                } else {
                                    phi_1330_ = 255f;
                                }
                                let _e665 = phi_1330_;
                                phi_1331_ = _e665;
                            } else {
                                phi_1331_ = 0f;
                            }
                            let _e667 = phi_1331_;
                            let _e674 = select(select(u32(_e667), 0u, (_e667 < bitcast<f32>(0u))), 4294967295u, (_e667 > bitcast<f32>(1333788671u)));
                            if (f32(_e674) < _e667) {
                                phi_1345_ = (_e674 + 1u);
                            } else {
                                phi_1345_ = _e674;
                            }
                            let _e679 = phi_1345_;
                            let _e680 = (_e674 * 16843009u);
                            let _e681 = (_e679 * 16843009u);
                            let _e690 = (((_e125.diagonal.x * _e386.unnamed.positive_exponent) + (_e125.diagonal.y * _e386.unnamed.negative_exponent)) - bitcast<f32>(_e607.frame.z));
                            let _e693 = bitcast<f32>((((_e607.z.z >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                            if (_e690 > 0f) {
                                if (_e690 < (255f * _e693)) {
                                    phi_1367_ = (_e690 / _e693);
                                } else {
                                    phi_1367_ = 255f;
                                }
                                let _e699 = phi_1367_;
                                phi_1368_ = _e699;
                            } else {
                                phi_1368_ = 0f;
                            }
                            let _e701 = phi_1368_;
                            let _e708 = select(select(u32(_e701), 0u, (_e701 < bitcast<f32>(0u))), 4294967295u, (_e701 > bitcast<f32>(1333788671u)));
                            if (f32(_e708) < _e701) {
                                phi_1382_ = (_e708 + 1u);
                            } else {
                                phi_1382_ = _e708;
                            }
                            let _e713 = phi_1382_;
                            let _e714 = (_e708 * 16843009u);
                            let _e715 = (_e713 * 16843009u);
                            let _e725 = (_e386.unnamed.min_variance - bitcast<f32>(_e607.frame.w));
                            let _e728 = bitcast<f32>((((_e607.z.z >> bitcast<u32>(((3u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                            if (_e725 > 0f) {
                                if (_e725 < (255f * _e728)) {
                                    phi_1405_ = (_e725 / _e728);
                                } else {
                                    phi_1405_ = 255f;
                                }
                                let _e734 = phi_1405_;
                                phi_1406_ = _e734;
                            } else {
                                phi_1406_ = 0f;
                            }
                            let _e736 = phi_1406_;
                            let _e743 = select(select(u32(_e736), 0u, (_e736 < bitcast<f32>(0u))), 4294967295u, (_e736 > bitcast<f32>(1333788671u)));
                            if (f32(_e743) < _e736) {
                                phi_1420_ = (_e743 + 1u);
                            } else {
                                phi_1420_ = _e743;
                            }
                            let _e748 = phi_1420_;
                            let _e749 = (_e748 * 16843009u);
                            let _e930 = (((((((((((_e645 & ~(_e607.links.x)) | (~((_e607.links.x ^ _e645)) & ((_e645 | 2155905152u) - (_e607.links.x & 2139062143u)))) & ((_e607.links.z & ~(_e646)) | (~((_e646 ^ _e607.links.z)) & ((_e607.links.z | 2155905152u) - (_e646 & 2139062143u))))) & (((_e680 & ~(_e607.x.x)) | (~((_e607.x.x ^ _e680)) & ((_e680 | 2155905152u) - (_e607.x.x & 2139062143u)))) & ((_e607.x.z & ~(_e681)) | (~((_e681 ^ _e607.x.z)) & ((_e607.x.z | 2155905152u) - (_e681 & 2139062143u)))))) & (((_e714 & ~(_e607.y.x)) | (~((_e607.y.x ^ _e714)) & ((_e714 | 2155905152u) - (_e607.y.x & 2139062143u)))) & ((_e607.y.z & ~(_e715)) | (~((_e715 ^ _e607.y.z)) & ((_e607.y.z | 2155905152u) - (_e715 & 2139062143u)))))) & ((_e607.z.x & ~(_e749)) | (~((_e749 ^ _e607.z.x)) & ((_e607.z.x | 2155905152u) - (_e749 & 2139062143u))))) & 2155905152u) >> bitcast<u32>(7i)) * 16909320u) >> bitcast<u32>(24i)) | (((((((((((_e645 & ~(_e607.links.y)) | (~((_e607.links.y ^ _e645)) & ((_e645 | 2155905152u) - (_e607.links.y & 2139062143u)))) & ((_e607.links.w & ~(_e646)) | (~((_e646 ^ _e607.links.w)) & ((_e607.links.w | 2155905152u) - (_e646 & 2139062143u))))) & (((_e680 & ~(_e607.x.y)) | (~((_e607.x.y ^ _e680)) & ((_e680 | 2155905152u) - (_e607.x.y & 2139062143u)))) & ((_e607.x.w & ~(_e681)) | (~((_e681 ^ _e607.x.w)) & ((_e607.x.w | 2155905152u) - (_e681 & 2139062143u)))))) & (((_e714 & ~(_e607.y.y)) | (~((_e607.y.y ^ _e714)) & ((_e714 | 2155905152u) - (_e607.y.y & 2139062143u)))) & ((_e607.y.w & ~(_e715)) | (~((_e715 ^ _e607.y.w)) & ((_e607.y.w | 2155905152u) - (_e715 & 2139062143u)))))) & ((_e607.z.y & ~(_e749)) | (~((_e749 ^ _e607.z.y)) & ((_e607.z.y | 2155905152u) - (_e749 & 2139062143u))))) & 2155905152u) >> bitcast<u32>(7i)) * 16909320u) >> bitcast<u32>(24i)) << bitcast<u32>(4i)));
                            if ((_e607.z.w & 2147483648u) != 0u) {
                                phi_1620_ = _e609;
                                phi_1217_ = (_e607.z.w & 2147483647u);
                                phi_1219_ = _e930;
                                phi_1621_ = _e575;
                            } else {
                                if (_e930 == 0u) {
                                    phi_1618_ = _e609;
                                    phi_1619_ = _e575;
                                } else {
                                    if ((_e609 & 255u) == 0u) {
                                        phi_1613_ = _e575;
                                    } else {
                                        if (_e575 < 32u) {
                                            if (_e575 < 32u) {
                                            } else {
                                                return;
                                            }
                                            local_3[(0u + _e575)] = _e609;
                                            phi_1612_ = (_e575 + 1u);
                                        } else {
                                            phi_1612_ = _e575;
                                        }
                                        let _e947 = phi_1612_;
                                        phi_1613_ = _e947;
                                    }
                                    let _e949 = phi_1613_;
                                    phi_1618_ = (((_e607.z.w & 2147483647u) << bitcast<u32>(8i)) | _e930);
                                    phi_1619_ = _e949;
                                }
                                let _e957 = phi_1618_;
                                let _e959 = phi_1619_;
                                phi_1620_ = _e957;
                                phi_1217_ = _e571;
                                phi_1219_ = _e573;
                                phi_1621_ = _e959;
                            }
                            let _e961 = phi_1620_;
                            let _e963 = phi_1217_;
                            let _e965 = phi_1219_;
                            let _e967 = phi_1621_;
                            local_5 = _e965;
                            local_17 = _e965;
                            local_6 = _e963;
                            if ((_e961 & 255u) == 0u) {
                                if (_e967 > 0u) {
                                    let _e971 = (_e967 - 1u);
                                    if (_e971 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e975 = local_3[(0u + _e971)];
                                    phi_1639_ = _e975;
                                    phi_1640_ = _e971;
                                } else {
                                    phi_1639_ = 0u;
                                    phi_1640_ = _e967;
                                }
                                let _e977 = phi_1639_;
                                let _e979 = phi_1640_;
                                phi_1207_ = _e977;
                                phi_1210_ = _e979;
                            } else {
                                phi_1207_ = _e961;
                                phi_1210_ = _e967;
                            }
                            let _e981 = phi_1207_;
                            let _e983 = phi_1210_;
                            local_15 = _e981;
                            local_16 = _e983;
                            local_8 = _e981;
                            if (_e965 == 0u) {
                                let _e985 = (_e981 == 0u);
                                if _e985 {
                                    phi_1649_ = false;
                                } else {
                                    phi_1649_ = true;
                                }
                                let _e987 = phi_1649_;
                                phi_1650_ = _e987;
                                phi_1651_ = _e985;
                            } else {
                                phi_1650_ = false;
                                phi_1651_ = false;
                            }
                            let _e989 = phi_1650_;
                            let _e991 = phi_1651_;
                            local_4 = _e991;
                            continue;
                            continuing {
                                phi_1214_ = _e981;
                                phi_1216_ = _e963;
                                phi_1218_ = _e965;
                                phi_1220_ = _e983;
                                break if !(_e989);
                            }
                        }
                        let _e994 = local_4;
                        if _e994 {
                        }
                        let _e996 = local_5;
                        if (_e996 == 0u) {
                            phi_2513_ = true;
                            phi_2514_ = false;
                            phi_2515_ = false;
                        } else {
                            let _e3466 = local_17;
                            phi_1660_ = _e3466;
                            loop {
                                let _e999 = phi_1660_;
                                let _e1002 = select(firstTrailingBit(_e999), 32u, (_e999 == 0u));
                                let _e1006 = local_6;
                                let _e1007 = (_e1006 + (_e1002 >> bitcast<u32>(2i)));
                                if (_e1007 < _e100) {
                                } else {
                                    return;
                                }
                                let _e1012 = rows.member[(0u + _e1007)][0u];
                                let _e1016 = rows.member[(0u + _e1007)][1u];
                                let _e1020 = rows.member[(0u + _e1007)][2u];
                                let _e1024 = rows.member[(0u + _e1007)][3u];
                                if ((_e1002 & 2u) == 0u) {
                                    phi_1695_ = _e1016;
                                    phi_1696_ = _e1012;
                                } else {
                                    phi_1695_ = _e1024;
                                    phi_1696_ = _e1020;
                                }
                                let _e1028 = phi_1695_;
                                let _e1030 = phi_1696_;
                                if ((_e1002 & 1u) == 0u) {
                                    phi_1702_ = _e1030;
                                } else {
                                    phi_1702_ = _e1028;
                                }
                                let _e1034 = phi_1702_;
                                let _e1036 = (_e999 & (_e999 - 1u));
                                if (_e1034 < _e91) {
                                } else {
                                    return;
                                }
                                let _e1041 = triangles.member[(0u + _e1034)].v0_;
                                let _e1043 = (_e1041.x - _e145);
                                let _e1045 = (_e1041.y - _e147);
                                let _e1047 = (_e1041.z - _e149);
                                if (_e544 == 0u) {
                                    phi_1731_ = vec3<f32>(_e1045, _e1047, _e1043);
                                } else {
                                    if (_e544 == 1u) {
                                        phi_1730_ = vec3<f32>(_e1047, _e1043, _e1045);
                                    } else {
                                        phi_1730_ = (_e1041 - vec3<f32>(_e145, _e147, _e149));
                                    }
                                    let _e1055 = phi_1730_;
                                    phi_1731_ = _e1055;
                                }
                                let _e1057 = phi_1731_;
                                let _e1061 = (_e1057.x - (_e555 * _e1057.z));
                                let _e1065 = (_e1057.y - (_e558 * _e1057.z));
                                let _e1067 = triangles.member[(0u + _e1034)].v1_;
                                let _e1069 = (_e1067.x - _e145);
                                let _e1071 = (_e1067.y - _e147);
                                let _e1073 = (_e1067.z - _e149);
                                if (_e544 == 0u) {
                                    phi_1761_ = vec3<f32>(_e1071, _e1073, _e1069);
                                } else {
                                    if (_e544 == 1u) {
                                        phi_1760_ = vec3<f32>(_e1073, _e1069, _e1071);
                                    } else {
                                        phi_1760_ = (_e1067 - vec3<f32>(_e145, _e147, _e149));
                                    }
                                    let _e1081 = phi_1760_;
                                    phi_1761_ = _e1081;
                                }
                                let _e1083 = phi_1761_;
                                let _e1087 = (_e1083.x - (_e555 * _e1083.z));
                                let _e1091 = (_e1083.y - (_e558 * _e1083.z));
                                let _e1093 = triangles.member[(0u + _e1034)].v2_;
                                let _e1095 = (_e1093.x - _e145);
                                let _e1097 = (_e1093.y - _e147);
                                let _e1099 = (_e1093.z - _e149);
                                if (_e544 == 0u) {
                                    phi_1791_ = vec3<f32>(_e1097, _e1099, _e1095);
                                } else {
                                    if (_e544 == 1u) {
                                        phi_1790_ = vec3<f32>(_e1099, _e1095, _e1097);
                                    } else {
                                        phi_1790_ = (_e1093 - vec3<f32>(_e145, _e147, _e149));
                                    }
                                    let _e1107 = phi_1790_;
                                    phi_1791_ = _e1107;
                                }
                                let _e1109 = phi_1791_;
                                let _e1113 = (_e1109.x - (_e555 * _e1109.z));
                                let _e1117 = (_e1109.y - (_e558 * _e1109.z));
                                if (_e1087 < _e1113) {
                                    phi_1810_ = true;
                                } else {
                                    if (_e1087 == _e1113) {
                                        phi_1809_ = (_e1091 < _e1117);
                                    } else {
                                        phi_1809_ = false;
                                    }
                                    let _e1122 = phi_1809_;
                                    phi_1810_ = _e1122;
                                }
                                let _e1124 = phi_1810_;
                                if _e1124 {
                                    phi_1814_ = _e1117;
                                    phi_1815_ = _e1113;
                                    phi_1816_ = _e1091;
                                    phi_1817_ = _e1087;
                                } else {
                                    phi_1814_ = _e1091;
                                    phi_1815_ = _e1087;
                                    phi_1816_ = _e1117;
                                    phi_1817_ = _e1113;
                                }
                                let _e1126 = phi_1814_;
                                let _e1128 = phi_1815_;
                                let _e1130 = phi_1816_;
                                let _e1132 = phi_1817_;
                                let _e1135 = ((_e1132 * _e1126) - (_e1130 * _e1128));
                                if _e1124 {
                                    phi_1825_ = -(_e1135);
                                } else {
                                    phi_1825_ = _e1135;
                                }
                                let _e1138 = phi_1825_;
                                if (_e1113 < _e1061) {
                                    phi_1836_ = true;
                                } else {
                                    if (_e1113 == _e1061) {
                                        phi_1835_ = (_e1117 < _e1065);
                                    } else {
                                        phi_1835_ = false;
                                    }
                                    let _e1143 = phi_1835_;
                                    phi_1836_ = _e1143;
                                }
                                let _e1145 = phi_1836_;
                                if _e1145 {
                                    phi_1840_ = _e1065;
                                    phi_1841_ = _e1061;
                                    phi_1842_ = _e1117;
                                    phi_1843_ = _e1113;
                                } else {
                                    phi_1840_ = _e1117;
                                    phi_1841_ = _e1113;
                                    phi_1842_ = _e1065;
                                    phi_1843_ = _e1061;
                                }
                                let _e1147 = phi_1840_;
                                let _e1149 = phi_1841_;
                                let _e1151 = phi_1842_;
                                let _e1153 = phi_1843_;
                                let _e1156 = ((_e1153 * _e1147) - (_e1151 * _e1149));
                                if _e1145 {
                                    phi_1851_ = -(_e1156);
                                } else {
                                    phi_1851_ = _e1156;
                                }
                                let _e1159 = phi_1851_;
                                if (_e1061 < _e1087) {
                                    phi_1862_ = true;
                                } else {
                                    if (_e1061 == _e1087) {
                                        phi_1861_ = (_e1065 < _e1091);
                                    } else {
                                        phi_1861_ = false;
                                    }
                                    let _e1164 = phi_1861_;
                                    phi_1862_ = _e1164;
                                }
                                let _e1166 = phi_1862_;
                                if _e1166 {
                                    phi_1866_ = _e1091;
                                    phi_1867_ = _e1087;
                                    phi_1868_ = _e1065;
                                    phi_1869_ = _e1061;
                                } else {
                                    phi_1866_ = _e1065;
                                    phi_1867_ = _e1061;
                                    phi_1868_ = _e1091;
                                    phi_1869_ = _e1087;
                                }
                                let _e1168 = phi_1866_;
                                let _e1170 = phi_1867_;
                                let _e1172 = phi_1868_;
                                let _e1174 = phi_1869_;
                                let _e1177 = ((_e1174 * _e1168) - (_e1172 * _e1170));
                                if _e1166 {
                                    phi_1877_ = -(_e1177);
                                } else {
                                    phi_1877_ = _e1177;
                                }
                                let _e1180 = phi_1877_;
                                if (_e1138 >= 0f) {
                                    if (_e1159 >= 0f) {
                                        if (_e1180 >= 0f) {
                                            phi_1892_ = ((_e1138 + _e1159) + _e1180);
                                            phi_1893_ = false;
                                        } else {
                                            phi_1892_ = f32();
                                            phi_1893_ = true;
                                        }
                                        let _e1187 = phi_1892_;
                                        let _e1189 = phi_1893_;
                                        phi_1894_ = _e1187;
                                        phi_1895_ = _e1189;
                                    } else {
                                        phi_1894_ = f32();
                                        phi_1895_ = true;
                                    }
                                    let _e1191 = phi_1894_;
                                    let _e1193 = phi_1895_;
                                    phi_1896_ = _e1191;
                                    phi_1897_ = _e1193;
                                } else {
                                    phi_1896_ = f32();
                                    phi_1897_ = true;
                                }
                                let _e1195 = phi_1896_;
                                let _e1197 = phi_1897_;
                                if _e1197 {
                                    if (_e1138 <= 0f) {
                                        if (_e1159 <= 0f) {
                                            let _e1200 = (_e1180 <= 0f);
                                            if _e1200 {
                                            }
                                            phi_1915_ = ((_e1138 + _e1159) + _e1180);
                                            phi_1916_ = false;
                                            phi_1917_ = _e1200;
                                        } else {
                                            phi_1915_ = f32();
                                            phi_1916_ = true;
                                            phi_1917_ = false;
                                        }
                                        let _e1204 = phi_1915_;
                                        let _e1206 = phi_1916_;
                                        let _e1208 = phi_1917_;
                                        phi_1918_ = _e1204;
                                        phi_1919_ = _e1206;
                                        phi_1920_ = _e1208;
                                    } else {
                                        phi_1918_ = f32();
                                        phi_1919_ = true;
                                        phi_1920_ = false;
                                    }
                                    let _e1210 = phi_1918_;
                                    let _e1212 = phi_1919_;
                                    let _e1214 = phi_1920_;
                                    if _e1212 {
                                        phi_1924_ = false;
                                    } else {
                                        phi_1924_ = _e1214;
                                    }
                                    let _e1216 = phi_1924_;
                                    phi_1925_ = _e1210;
                                    phi_1926_ = _e1216;
                                } else {
                                    phi_1925_ = _e1195;
                                    phi_1926_ = true;
                                }
                                let _e1218 = phi_1925_;
                                let _e1220 = phi_1926_;
                                if _e1220 {
                                    let _e1221 = (_e1218 == 0f);
                                    if _e1221 {
                                        phi_2242_ = lt_bvh_triangle_Intersection();
                                        phi_2243_ = false;
                                    } else {
                                        let _e1223 = triangles.member[(0u + _e1034)].v0_;
                                        let _e1225 = (_e1223.x - _e145);
                                        let _e1227 = (_e1223.y - _e147);
                                        let _e1229 = (_e1223.z - _e149);
                                        if (_e544 == 0u) {
                                            phi_1955_ = vec3<f32>(_e1227, _e1229, _e1225);
                                        } else {
                                            if (_e544 == 1u) {
                                                phi_1954_ = vec3<f32>(_e1229, _e1225, _e1227);
                                            } else {
                                                phi_1954_ = (_e1223 - vec3<f32>(_e145, _e147, _e149));
                                            }
                                            let _e1237 = phi_1954_;
                                            phi_1955_ = _e1237;
                                        }
                                        let _e1239 = phi_1955_;
                                        let _e1241 = triangles.member[(0u + _e1034)].v1_;
                                        let _e1243 = triangles.member[(0u + _e1034)].v0_;
                                        let _e1246 = (_e1241.x - _e1243.x);
                                        let _e1249 = (_e1241.y - _e1243.y);
                                        let _e1252 = (_e1241.z - _e1243.z);
                                        if (_e544 == 0u) {
                                            phi_1981_ = vec3<f32>(_e1249, _e1252, _e1246);
                                        } else {
                                            if (_e544 == 1u) {
                                                phi_1980_ = vec3<f32>(_e1252, _e1246, _e1249);
                                            } else {
                                                phi_1980_ = (_e1241 - _e1243);
                                            }
                                            let _e1259 = phi_1980_;
                                            phi_1981_ = _e1259;
                                        }
                                        let _e1261 = phi_1981_;
                                        let _e1263 = triangles.member[(0u + _e1034)].v2_;
                                        let _e1265 = triangles.member[(0u + _e1034)].v0_;
                                        let _e1268 = (_e1263.x - _e1265.x);
                                        let _e1271 = (_e1263.y - _e1265.y);
                                        let _e1274 = (_e1263.z - _e1265.z);
                                        if (_e544 == 0u) {
                                            phi_2007_ = vec3<f32>(_e1271, _e1274, _e1268);
                                        } else {
                                            if (_e544 == 1u) {
                                                phi_2006_ = vec3<f32>(_e1274, _e1268, _e1271);
                                            } else {
                                                phi_2006_ = (_e1263 - _e1265);
                                            }
                                            let _e1281 = phi_2006_;
                                            phi_2007_ = _e1281;
                                        }
                                        let _e1283 = phi_2007_;
                                        let _e1290 = ((_e1261.y * _e1283.z) - (_e1261.z * _e1283.y));
                                        let _e1297 = ((_e1261.z * _e1283.x) - (_e1261.x * _e1283.z));
                                        let _e1304 = ((_e1261.x * _e1283.y) - (_e1261.y * _e1283.x));
                                        let _e1318 = (((1f / _e552.z) * (((_e1290 * _e1239.x) + (_e1297 * _e1239.y)) + (_e1304 * _e1239.z))) / (((_e1290 * _e555) + (_e1297 * _e558)) + _e1304));
                                        if (_e1318 > 0f) {
                                            if (_e1318 < _e157) {
                                                let _e1322 = triangles.member[(0u + _e1034)].v0_;
                                                let _e1324 = triangles.member[(0u + _e1034)].v1_;
                                                if (_e1322.x < _e1324.x) {
                                                    phi_2063_ = _e1322.x;
                                                } else {
                                                    phi_2063_ = _e1324.x;
                                                }
                                                let _e1331 = phi_2063_;
                                                if (_e1322.y < _e1324.y) {
                                                    phi_2072_ = _e1322.y;
                                                } else {
                                                    phi_2072_ = _e1324.y;
                                                }
                                                let _e1338 = phi_2072_;
                                                if (_e1322.z < _e1324.z) {
                                                    phi_2081_ = _e1322.z;
                                                } else {
                                                    phi_2081_ = _e1324.z;
                                                }
                                                let _e1345 = phi_2081_;
                                                let _e1347 = triangles.member[(0u + _e1034)].v2_;
                                                if (_e1331 < _e1347.x) {
                                                    phi_2090_ = _e1331;
                                                } else {
                                                    phi_2090_ = _e1347.x;
                                                }
                                                let _e1352 = phi_2090_;
                                                if (_e1338 < _e1347.y) {
                                                    phi_2097_ = _e1338;
                                                } else {
                                                    phi_2097_ = _e1347.y;
                                                }
                                                let _e1357 = phi_2097_;
                                                if (_e1345 < _e1347.z) {
                                                    phi_2104_ = _e1345;
                                                } else {
                                                    phi_2104_ = _e1347.z;
                                                }
                                                let _e1362 = phi_2104_;
                                                let _e1364 = triangles.member[(0u + _e1034)].v0_;
                                                let _e1366 = triangles.member[(0u + _e1034)].v1_;
                                                if (_e1364.x > _e1366.x) {
                                                    phi_2117_ = _e1364.x;
                                                } else {
                                                    phi_2117_ = _e1366.x;
                                                }
                                                let _e1373 = phi_2117_;
                                                if (_e1364.y > _e1366.y) {
                                                    phi_2126_ = _e1364.y;
                                                } else {
                                                    phi_2126_ = _e1366.y;
                                                }
                                                let _e1380 = phi_2126_;
                                                if (_e1364.z > _e1366.z) {
                                                    phi_2135_ = _e1364.z;
                                                } else {
                                                    phi_2135_ = _e1366.z;
                                                }
                                                let _e1387 = phi_2135_;
                                                let _e1389 = triangles.member[(0u + _e1034)].v2_;
                                                if (_e1373 > _e1389.x) {
                                                    phi_2144_ = _e1373;
                                                } else {
                                                    phi_2144_ = _e1389.x;
                                                }
                                                let _e1394 = phi_2144_;
                                                if (_e1380 > _e1389.y) {
                                                    phi_2151_ = _e1380;
                                                } else {
                                                    phi_2151_ = _e1389.y;
                                                }
                                                let _e1399 = phi_2151_;
                                                if (_e1387 > _e1389.z) {
                                                    phi_2158_ = _e1387;
                                                } else {
                                                    phi_2158_ = _e1389.z;
                                                }
                                                let _e1404 = phi_2158_;
                                                let _e1408 = ((_e1352 - _e145) * _e473);
                                                let _e1409 = ((_e1357 - _e147) * _e483);
                                                let _e1410 = ((_e1362 - _e149) * _e493);
                                                let _e1414 = ((_e1394 - _e145) * _e473);
                                                let _e1415 = ((_e1399 - _e147) * _e483);
                                                let _e1416 = ((_e1404 - _e149) * _e493);
                                                if (_e1408 < _e1414) {
                                                    phi_2175_ = _e1408;
                                                } else {
                                                    phi_2175_ = _e1414;
                                                }
                                                let _e1419 = phi_2175_;
                                                if (_e1409 < _e1415) {
                                                    phi_2180_ = _e1409;
                                                } else {
                                                    phi_2180_ = _e1415;
                                                }
                                                let _e1422 = phi_2180_;
                                                if (_e1410 < _e1416) {
                                                    phi_2185_ = _e1410;
                                                } else {
                                                    phi_2185_ = _e1416;
                                                }
                                                let _e1425 = phi_2185_;
                                                if (_e1408 > _e1414) {
                                                    phi_2193_ = _e1408;
                                                } else {
                                                    phi_2193_ = _e1414;
                                                }
                                                let _e1431 = phi_2193_;
                                                if (_e1409 > _e1415) {
                                                    phi_2198_ = _e1409;
                                                } else {
                                                    phi_2198_ = _e1415;
                                                }
                                                let _e1434 = phi_2198_;
                                                if (_e1410 > _e1416) {
                                                    phi_2203_ = _e1410;
                                                } else {
                                                    phi_2203_ = _e1416;
                                                }
                                                let _e1437 = phi_2203_;
                                                let _e1441 = core_intrinsics_maximum_number_nsz_f32_((_e1419 - _e528), (_e1422 - _e529));
                                                let _e1442 = core_intrinsics_maximum_number_nsz_f32_(_e1441, (_e1425 - _e530));
                                                let _e1443 = core_intrinsics_minimum_number_nsz_f32_((_e1431 + _e528), (_e1434 + _e529));
                                                let _e1444 = core_intrinsics_minimum_number_nsz_f32_(_e1443, (_e1437 + _e530));
                                                if (_e1442 > -300000000000000000000000000000000000000f) {
                                                    phi_2215_ = _e1442;
                                                } else {
                                                    phi_2215_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1447 = phi_2215_;
                                                if (_e1444 < 300000000000000000000000000000000000000f) {
                                                    phi_2220_ = _e1444;
                                                } else {
                                                    phi_2220_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1450 = phi_2220_;
                                                if (_e1318 < _e1447) {
                                                    phi_2225_ = _e1447;
                                                } else {
                                                    phi_2225_ = _e1318;
                                                }
                                                let _e1453 = phi_2225_;
                                                if (_e1453 > _e1450) {
                                                    phi_2230_ = _e1450;
                                                } else {
                                                    phi_2230_ = _e1453;
                                                }
                                                let _e1456 = phi_2230_;
                                                phi_2235_ = lt_bvh_triangle_Intersection(_e1456, (_e1159 / _e1218), (_e1180 / _e1218), (_e1447 <= _e1450));
                                                phi_2236_ = false;
                                            } else {
                                                phi_2235_ = lt_bvh_triangle_Intersection();
                                                phi_2236_ = true;
                                            }
                                            let _e1462 = phi_2235_;
                                            let _e1464 = phi_2236_;
                                            phi_2237_ = _e1462;
                                            phi_2238_ = _e1464;
                                        } else {
                                            phi_2237_ = lt_bvh_triangle_Intersection();
                                            phi_2238_ = true;
                                        }
                                        let _e1466 = phi_2237_;
                                        let _e1468 = phi_2238_;
                                        if _e1468 {
                                        }
                                        phi_2242_ = _e1466;
                                        phi_2243_ = _e1468;
                                    }
                                    let _e1470 = phi_2242_;
                                    let _e1472 = phi_2243_;
                                    phi_2244_ = _e1470;
                                    phi_2245_ = _e1221;
                                    phi_2246_ = _e1472;
                                } else {
                                    phi_2244_ = lt_bvh_triangle_Intersection();
                                    phi_2245_ = true;
                                    phi_2246_ = false;
                                }
                                let _e1474 = phi_2244_;
                                let _e1476 = phi_2245_;
                                let _e1478 = phi_2246_;
                                if _e1476 {
                                    phi_2250_ = true;
                                } else {
                                    phi_2250_ = _e1478;
                                }
                                let _e1480 = phi_2250_;
                                if _e1480 {
                                    phi_2254_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_2254_ = _e1474;
                                }
                                let _e1482 = phi_2254_;
                                if _e1482.is_hit {
                                    if (_e1482.t > 0f) {
                                        if (_e1482.t < _e157) {
                                            let _e1489 = triangles.member[(0u + _e1034)].i0_;
                                            let _e1491 = ((_e1489 & 2147483648u) == 0u);
                                            if _e1491 {
                                                phi_2477_ = false;
                                                phi_2478_ = false;
                                            } else {
                                                if (_e1034 < _e91) {
                                                } else {
                                                    return;
                                                }
                                                let _e1498 = triangles.member[(0u + _e1034)].i0_;
                                                let _e1499 = (_e1498 & 2147483647u);
                                                let _e1501 = triangles.member[(0u + _e1034)].i1_;
                                                let _e1503 = triangles.member[(0u + _e1034)].i2_;
                                                if (_e1499 < _e104) {
                                                } else {
                                                    return;
                                                }
                                                let _e1507 = vertices.member[(0u + _e1499)];
                                                if (_e1501 < _e104) {
                                                } else {
                                                    return;
                                                }
                                                let _e1511 = vertices.member[(0u + _e1501)];
                                                if (_e1503 < _e104) {
                                                } else {
                                                    return;
                                                }
                                                let _e1515 = vertices.member[(0u + _e1503)];
                                                let _e1516 = array<abi_Vertex, 3>(_e1507, _e1511, _e1515);
                                                if (_e1516[0].material < _e107) {
                                                } else {
                                                    return;
                                                }
                                                let _e1522 = materials.member[(0u + _e1516[0].material)];
                                                if ((_e1522.flags & 1u) == 1u) {
                                                    let _e1527 = ((1f - _e1482.u) - _e1482.v);
                                                    if (_e1522.cutoff <= 0f) {
                                                        phi_2471_ = true;
                                                    } else {
                                                        let _e1554 = (_e1522.base_color.w * ((((f32((_e1516[0].color >> bitcast<u32>(24i))) * _e1527) + (f32((_e1516[1].color >> bitcast<u32>(24i))) * _e1482.u)) + (f32((_e1516[2].color >> bitcast<u32>(24i))) * _e1482.v)) * (1f / 255f)));
                                                        if (_e1522.alpha_size == 0u) {
                                                            phi_2468_ = _e1554;
                                                        } else {
                                                            local_2.offset = _e1522.alpha_offset;
                                                            local_2.size = _e1522.alpha_size;
                                                            local_2.flags = _e1522.flags;
                                                            let _e1585 = _lt_shaders_texture_TextureView_quad((&local_2), (((_e1516[0].u * _e1527) + (_e1516[1].u * _e1482.u)) + (_e1516[2].u * _e1482.v)), (((_e1516[0].v * _e1527) + (_e1516[1].v * _e1482.u)) + (_e1516[2].v * _e1482.v)));
                                                            let _e1589 = (_e1585.indices[0] >> bitcast<u32>(2i));
                                                            if (_e1589 < _e110) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1593 = alpha_texels.member[(0u + _e1589)];
                                                            let _e1609 = (_e1585.indices[1] >> bitcast<u32>(2i));
                                                            if (_e1609 < _e110) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1613 = alpha_texels.member[(0u + _e1609)];
                                                            let _e1630 = (_e1585.indices[2] >> bitcast<u32>(2i));
                                                            if (_e1630 < _e110) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1634 = alpha_texels.member[(0u + _e1630)];
                                                            let _e1651 = (_e1585.indices[3] >> bitcast<u32>(2i));
                                                            if (_e1651 < _e110) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1655 = alpha_texels.member[(0u + _e1651)];
                                                            phi_2468_ = (_e1554 * (((((f32(((_e1593 >> bitcast<u32>((((_e1585.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1585.weights.x) + ((f32(((_e1613 >> bitcast<u32>((((_e1585.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1585.weights.y)) + ((f32(((_e1634 >> bitcast<u32>((((_e1585.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1585.weights.z)) + ((f32(((_e1655 >> bitcast<u32>((((_e1585.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1585.weights.w)));
                                                        }
                                                        let _e1671 = phi_2468_;
                                                        phi_2471_ = (_e1671 >= _e1522.cutoff);
                                                    }
                                                    let _e1675 = phi_2471_;
                                                    phi_2472_ = _e1675;
                                                } else {
                                                    phi_2472_ = false;
                                                }
                                                let _e1677 = phi_2472_;
                                                if _e1677 {
                                                    phi_2476_ = false;
                                                } else {
                                                    phi_2476_ = true;
                                                }
                                                let _e1679 = phi_2476_;
                                                phi_2477_ = _e1679;
                                                phi_2478_ = _e1677;
                                            }
                                            let _e1681 = phi_2477_;
                                            let _e1683 = phi_2478_;
                                            phi_2479_ = _e1681;
                                            phi_2480_ = _e1491;
                                            phi_2481_ = _e1683;
                                        } else {
                                            phi_2479_ = true;
                                            phi_2480_ = false;
                                            phi_2481_ = false;
                                        }
                                        let _e1685 = phi_2479_;
                                        let _e1687 = phi_2480_;
                                        let _e1689 = phi_2481_;
                                        phi_2482_ = false;
                                        phi_2483_ = _e1685;
                                        phi_2484_ = _e1687;
                                        phi_2485_ = _e1689;
                                    } else {
                                        phi_2482_ = true;
                                        phi_2483_ = false;
                                        phi_2484_ = false;
                                        phi_2485_ = false;
                                    }
                                    let _e1691 = phi_2482_;
                                    let _e1693 = phi_2483_;
                                    let _e1695 = phi_2484_;
                                    let _e1697 = phi_2485_;
                                    phi_2486_ = _e1691;
                                    phi_2487_ = _e1693;
                                    phi_2488_ = _e1695;
                                    phi_2489_ = _e1697;
                                } else {
                                    phi_2486_ = true;
                                    phi_2487_ = false;
                                    phi_2488_ = false;
                                    phi_2489_ = false;
                                }
                                let _e1699 = phi_2486_;
                                let _e1701 = phi_2487_;
                                let _e1703 = phi_2488_;
                                let _e1705 = phi_2489_;
                                if _e1699 {
                                    phi_2493_ = true;
                                    phi_2494_ = false;
                                    phi_2495_ = false;
                                } else {
                                    phi_2493_ = _e1701;
                                    phi_2494_ = _e1703;
                                    phi_2495_ = _e1705;
                                }
                                let _e1707 = phi_2493_;
                                let _e1709 = phi_2494_;
                                let _e1711 = phi_2495_;
                                if _e1707 {
                                    let _e1712 = (_e1036 == 0u);
                                    if _e1712 {
                                        phi_2503_ = false;
                                    } else {
                                        phi_2503_ = true;
                                    }
                                    let _e1714 = phi_2503_;
                                    phi_2504_ = _e1714;
                                    phi_2505_ = _e1712;
                                    phi_2506_ = false;
                                    phi_2507_ = false;
                                } else {
                                    phi_2504_ = false;
                                    phi_2505_ = false;
                                    phi_2506_ = _e1709;
                                    phi_2507_ = _e1711;
                                }
                                let _e1716 = phi_2504_;
                                let _e1718 = phi_2505_;
                                let _e1720 = phi_2506_;
                                let _e1722 = phi_2507_;
                                local_7 = _e1718;
                                local_18 = _e1720;
                                local_19 = _e1722;
                                local_20 = _e1718;
                                continue;
                                continuing {
                                    phi_1660_ = _e1036;
                                    break if !(_e1716);
                                }
                            }
                            let _e1725 = local_7;
                            if _e1725 {
                                phi_2511_ = false;
                                phi_2512_ = false;
                            } else {
                                let _e3580 = local_18;
                                phi_2511_ = _e3580;
                                let _e3583 = local_19;
                                phi_2512_ = _e3583;
                            }
                            let _e1727 = phi_2511_;
                            let _e1729 = phi_2512_;
                            let _e3586 = local_20;
                            phi_2513_ = _e3586;
                            phi_2514_ = _e1727;
                            phi_2515_ = _e1729;
                        }
                        let _e1731 = phi_2513_;
                        let _e1733 = phi_2514_;
                        let _e1735 = phi_2515_;
                        if _e1731 {
                            let _e1737 = local_8;
                            if (_e1737 == 0u) {
                                phi_2523_ = false;
                            } else {
                                phi_2523_ = true;
                            }
                            let _e1740 = phi_2523_;
                            phi_2524_ = _e1740;
                            phi_2525_ = false;
                            phi_2526_ = false;
                        } else {
                            phi_2524_ = false;
                            phi_2525_ = _e1733;
                            phi_2526_ = _e1735;
                        }
                        let _e1742 = phi_2524_;
                        let _e1744 = phi_2525_;
                        let _e1746 = phi_2526_;
                        local_9 = _e1744;
                        local_21 = _e1746;
                        local_22 = _e1744;
                        continue;
                        continuing {
                            let _e3427 = local_15;
                            phi_1206_ = _e3427;
                            let _e3430 = local_16;
                            phi_1209_ = _e3430;
                            break if !(_e1742);
                        }
                    }
                    let _e1749 = local_9;
                    if _e1749 {
                        phi_2530_ = false;
                    } else {
                        let _e3597 = local_21;
                        phi_2530_ = _e3597;
                    }
                    let _e1751 = phi_2530_;
                    if _e1751 {
                        phi_2534_ = true;
                    } else {
                        let _e3600 = local_22;
                        phi_2534_ = _e3600;
                    }
                    let _e1753 = phi_2534_;
                    if _e1753 {
                        phi_2538_ = true;
                    } else {
                        phi_2538_ = false;
                    }
                    let _e1755 = phi_2538_;
                    phi_2539_ = _e1755;
                }
                let _e1757 = phi_2539_;
                phi_4204_ = _e1757;
            } else {
                let _e1758 = abs(_e165);
                let _e1759 = abs(_e166);
                let _e1760 = abs(_e167);
                if (abs(_e145) < 1000000000000000f) {
                    if (abs(_e147) < 1000000000000000f) {
                        phi_2555_ = (abs(_e149) < 1000000000000000f);
                        phi_2556_ = false;
                    } else {
                        phi_2555_ = bool();
                        phi_2556_ = true;
                    }
                    let _e1768 = phi_2555_;
                    let _e1770 = phi_2556_;
                    phi_2557_ = _e1768;
                    phi_2558_ = _e1770;
                } else {
                    phi_2557_ = bool();
                    phi_2558_ = true;
                }
                let _e1772 = phi_2557_;
                let _e1774 = phi_2558_;
                if _e1774 {
                    phi_2562_ = false;
                } else {
                    phi_2562_ = _e1772;
                }
                let _e1776 = phi_2562_;
                if _e1776 {
                    if (_e1758 < 1000000000000000f) {
                        if (_e1759 < 1000000000000000f) {
                            phi_2575_ = (_e1760 < 1000000000000000f);
                            phi_2576_ = false;
                        } else {
                            phi_2575_ = bool();
                            phi_2576_ = true;
                        }
                        let _e1781 = phi_2575_;
                        let _e1783 = phi_2576_;
                        phi_2577_ = _e1781;
                        phi_2578_ = _e1783;
                    } else {
                        phi_2577_ = bool();
                        phi_2578_ = true;
                    }
                    let _e1785 = phi_2577_;
                    let _e1787 = phi_2578_;
                    if _e1787 {
                        phi_2582_ = false;
                    } else {
                        phi_2582_ = _e1785;
                    }
                    let _e1789 = phi_2582_;
                    if _e1789 {
                        if (_e1758 > 0f) {
                            phi_2596_ = bool();
                            phi_2597_ = true;
                        } else {
                            let _e1791 = (_e1759 > 0f);
                            if _e1791 {
                                phi_2595_ = bool();
                            } else {
                                phi_2595_ = (_e1760 > 0f);
                            }
                            let _e1794 = phi_2595_;
                            phi_2596_ = _e1794;
                            phi_2597_ = _e1791;
                        }
                        let _e1796 = phi_2596_;
                        let _e1798 = phi_2597_;
                        if _e1798 {
                            phi_2601_ = true;
                        } else {
                            phi_2601_ = _e1796;
                        }
                        let _e1800 = phi_2601_;
                        phi_2602_ = _e1800;
                        phi_2603_ = false;
                    } else {
                        phi_2602_ = bool();
                        phi_2603_ = true;
                    }
                    let _e1802 = phi_2602_;
                    let _e1804 = phi_2603_;
                    phi_2604_ = _e1802;
                    phi_2605_ = _e1804;
                } else {
                    phi_2604_ = bool();
                    phi_2605_ = true;
                }
                let _e1806 = phi_2604_;
                let _e1808 = phi_2605_;
                if _e1808 {
                    phi_2609_ = false;
                } else {
                    phi_2609_ = _e1806;
                }
                let _e1810 = phi_2609_;
                if _e1810 {
                    let _e1811 = (0u >= _e88);
                    if _e1811 {
                        phi_4197_ = bool();
                    } else {
                        if (0u < _e88) {
                        } else {
                            return;
                        }
                        let _e1817 = nodes.member[(0u + 0u)].frame[0u];
                        let _e1821 = nodes.member[(0u + 0u)].frame[1u];
                        let _e1825 = nodes.member[(0u + 0u)].frame[2u];
                        let _e1829 = nodes.member[(0u + 0u)].frame[0u];
                        let _e1833 = nodes.member[(0u + 0u)].frame[1u];
                        let _e1837 = nodes.member[(0u + 0u)].frame[2u];
                        let _e1841 = nodes.member[(0u + 0u)].frame[3u];
                        let _e1875 = core_intrinsics_maximum_number_nsz_f32_(abs(_e165), abs(_e166));
                        let _e1876 = core_intrinsics_maximum_number_nsz_f32_(_e1875, abs(_e167));
                        let _e1877 = (_e1876 * 0.0000000000009094947f);
                        if (abs(_e165) < _e1877) {
                            phi_2679_ = _e1877;
                        } else {
                            phi_2679_ = abs(_e165);
                        }
                        let _e1882 = phi_2679_;
                        if (_e165 < 0f) {
                            phi_2686_ = (-1f / _e1882);
                        } else {
                            phi_2686_ = (1f / _e1882);
                        }
                        let _e1887 = phi_2686_;
                        if (abs(_e166) < _e1877) {
                            phi_2693_ = _e1877;
                        } else {
                            phi_2693_ = abs(_e166);
                        }
                        let _e1892 = phi_2693_;
                        if (_e166 < 0f) {
                            phi_2700_ = (-1f / _e1892);
                        } else {
                            phi_2700_ = (1f / _e1892);
                        }
                        let _e1897 = phi_2700_;
                        if (abs(_e167) < _e1877) {
                            phi_2707_ = _e1877;
                        } else {
                            phi_2707_ = abs(_e167);
                        }
                        let _e1902 = phi_2707_;
                        if (_e167 < 0f) {
                            phi_2714_ = (-1f / _e1902);
                        } else {
                            phi_2714_ = (1f / _e1902);
                        }
                        let _e1907 = phi_2714_;
                        let _e1911 = abs((bitcast<f32>(_e1817) - _e145));
                        let _e1912 = abs((bitcast<f32>(_e1821) - _e147));
                        let _e1913 = abs((bitcast<f32>(_e1825) - _e149));
                        let _e1917 = abs(((bitcast<f32>(_e1829) + (bitcast<f32>((((_e1841 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e145));
                        let _e1918 = abs(((bitcast<f32>(_e1833) + (bitcast<f32>((((_e1841 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e147));
                        let _e1919 = abs(((bitcast<f32>(_e1837) + (bitcast<f32>((((_e1841 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e149));
                        if (_e1911 > _e1917) {
                            phi_2731_ = _e1911;
                        } else {
                            phi_2731_ = _e1917;
                        }
                        let _e1922 = phi_2731_;
                        if (_e1912 > _e1918) {
                            phi_2736_ = _e1912;
                        } else {
                            phi_2736_ = _e1918;
                        }
                        let _e1925 = phi_2736_;
                        if (_e1913 > _e1919) {
                            phi_2741_ = _e1913;
                        } else {
                            phi_2741_ = _e1919;
                        }
                        let _e1928 = phi_2741_;
                        if (_e1922 > _e1925) {
                            phi_2746_ = _e1922;
                        } else {
                            phi_2746_ = _e1925;
                        }
                        let _e1931 = phi_2746_;
                        if (_e1931 > _e1928) {
                            phi_2751_ = _e1931;
                        } else {
                            phi_2751_ = _e1928;
                        }
                        let _e1934 = phi_2751_;
                        let _e1938 = (_e1934 * 0.0000019073486f);
                        let _e1939 = (abs(_e1887) * _e1938);
                        let _e1940 = (abs(_e1897) * _e1938);
                        let _e1941 = (abs(_e1907) * _e1938);
                        let _e1945 = (_e1934 * 0.0000009536743f);
                        let _e1946 = (abs(_e1887) * _e1945);
                        let _e1947 = (abs(_e1897) * _e1945);
                        let _e1948 = (abs(_e1907) * _e1945);
                        let _e1949 = abs(_e165);
                        let _e1950 = abs(_e166);
                        let _e1951 = abs(_e167);
                        if (_e1949 >= _e1950) {
                            if (_e1949 >= _e1951) {
                                phi_2777_ = false;
                            } else {
                                phi_2777_ = true;
                            }
                            let _e1955 = phi_2777_;
                            phi_2778_ = _e1955;
                        } else {
                            phi_2778_ = true;
                        }
                        let _e1957 = phi_2778_;
                        if _e1957 {
                            if (_e1950 >= _e1951) {
                                phi_2786_ = 1u;
                            } else {
                                phi_2786_ = 2u;
                            }
                            let _e1960 = phi_2786_;
                            phi_2787_ = _e1960;
                        } else {
                            phi_2787_ = 0u;
                        }
                        let _e1962 = phi_2787_;
                        if (_e1962 == 0u) {
                            phi_2799_ = vec3<f32>(_e166, _e167, _e165);
                        } else {
                            if (_e1962 == 1u) {
                                phi_2798_ = vec3<f32>(_e167, _e165, _e166);
                            } else {
                                phi_2798_ = _e168;
                            }
                            let _e1968 = phi_2798_;
                            phi_2799_ = _e1968;
                        }
                        let _e1970 = phi_2799_;
                        let _e1973 = (_e1970.x / _e1970.z);
                        let _e1976 = (_e1970.y / _e1970.z);
                        if (_e1887 < 0f) {
                            phi_2812_ = 0u;
                        } else {
                            phi_2812_ = 1u;
                        }
                        let _e1981 = phi_2812_;
                        if (_e1897 < 0f) {
                            phi_2817_ = 0u;
                        } else {
                            phi_2817_ = 2u;
                        }
                        let _e1984 = phi_2817_;
                        if (_e1907 < 0f) {
                            phi_2822_ = 0u;
                        } else {
                            phi_2822_ = 4u;
                        }
                        let _e1987 = phi_2822_;
                        let _e1989 = ((_e1981 | _e1984) | _e1987);
                        let _e1990 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                        local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e1990.first[0], _e1990.first[1], _e1990.first[2], _e1990.first[3], _e1990.first[4], _e1990.first[5], _e1990.first[6], _e1990.first[7], _e1990.first[8], _e1990.first[9], _e1990.first[10], _e1990.first[11], _e1990.first[12], _e1990.first[13], _e1990.first[14], _e1990.first[15], _e1990.first[16], _e1990.first[17], _e1990.first[18], _e1990.first[19], _e1990.first[20], _e1990.first[21], _e1990.first[22], _e1990.first[23], _e1990.first[24], _e1990.first[25], _e1990.first[26], _e1990.first[27], _e1990.first[28], _e1990.first[29], _e1990.first[30], _e1990.first[31]), array<u32, 32>(_e1990.mask[0], _e1990.mask[1], _e1990.mask[2], _e1990.mask[3], _e1990.mask[4], _e1990.mask[5], _e1990.mask[6], _e1990.mask[7], _e1990.mask[8], _e1990.mask[9], _e1990.mask[10], _e1990.mask[11], _e1990.mask[12], _e1990.mask[13], _e1990.mask[14], _e1990.mask[15], _e1990.mask[16], _e1990.mask[17], _e1990.mask[18], _e1990.mask[19], _e1990.mask[20], _e1990.mask[21], _e1990.mask[22], _e1990.mask[23], _e1990.mask[24], _e1990.mask[25], _e1990.mask[26], _e1990.mask[27], _e1990.mask[28], _e1990.mask[29], _e1990.mask[30], _e1990.mask[31]), _e1990.len, _e1990.group, _e1990.group_mask);
                        let _e2064 = local_1.group_mask;
                        if ((_e2064 & 4278190080u) == 0u) {
                            let _e2068 = local_1.len;
                            if (_e2068 == 0u) {
                                phi_2936_ = false;
                            } else {
                                let _e2072 = local_1.len;
                                local_1.len = (_e2072 - 1u);
                                let _e2075 = local_1.len;
                                if (_e2075 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2080 = local_1.first[(0u + _e2075)];
                                local_1.group = _e2080;
                                let _e2083 = local_1.len;
                                if (_e2083 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2088 = local_1.mask[(0u + _e2083)];
                                local_1.group_mask = _e2088;
                                phi_2936_ = true;
                            }
                            let _e2091 = phi_2936_;
                            phi_2937_ = _e2091;
                        } else {
                            phi_2937_ = true;
                        }
                        let _e2093 = phi_2937_;
                        if _e2093 {
                            let _e2095 = local_1.group_mask;
                            let _e2101 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2095)), 32u, (_e2095 == 0u)));
                            let _e2105 = local_1.group_mask;
                            let _e2119 = local_1.group_mask;
                            local_1.group_mask = (_e2119 & ~((1u << bitcast<u32>((_e2101 & 31u)))));
                            let _e2122 = local_1.group;
                            phi_2968_ = (_e2122 + countOneBits(((_e2105 & ~((4294967295u << bitcast<u32>((((_e2101 - 24u) ^ 7u) & 31u))))) & 255u)));
                        } else {
                            phi_2968_ = 4294967295u;
                        }
                        let _e2125 = phi_2968_;
                        phi_2970_ = _e2125;
                        phi_2973_ = false;
                        loop {
                            let _e2127 = phi_2970_;
                            let _e2129 = phi_2973_;
                            local_27 = _e2129;
                            if (_e2127 != 4294967295u) {
                                if (_e2127 < _e88) {
                                } else {
                                    return;
                                }
                                let _e2136 = nodes.member[(0u + _e2127)].frame[3u];
                                let _e2161 = (bitcast<f32>((((_e2136 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1887);
                                let _e2162 = (bitcast<f32>((((_e2136 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1897);
                                let _e2163 = (bitcast<f32>((((_e2136 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1907);
                                let _e2166 = nodes.member[(0u + _e2127)].frame[0u];
                                let _e2170 = nodes.member[(0u + _e2127)].frame[1u];
                                let _e2174 = nodes.member[(0u + _e2127)].frame[2u];
                                let _e2179 = ((bitcast<f32>(_e2166) - _e145) * _e1887);
                                let _e2180 = ((bitcast<f32>(_e2170) - _e147) * _e1897);
                                let _e2181 = ((bitcast<f32>(_e2174) - _e149) * _e1907);
                                let _e2189 = nodes.member[(0u + _e2127)].x;
                                if (_e1887 < 0f) {
                                    let _e2200 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2189.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2206 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2200.unnamed.root, _e2189.w), _e2200.unnamed_1);
                                    let _e2212 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2206.unnamed, lt_bvh_traverse_Tree(_e2189.x, _e2206.unnamed_1.first_primitive));
                                    phi_3053_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2212.unnamed, lt_bvh_traverse_Tree(_e2212.unnamed_1.root, _e2189.y));
                                } else {
                                    let _e2228 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2189.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2234 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2228.unnamed.root, _e2189.y), _e2228.unnamed_1);
                                    let _e2240 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2234.unnamed, lt_bvh_traverse_Tree(_e2189.z, _e2234.unnamed_1.first_primitive));
                                    phi_3053_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2240.unnamed, lt_bvh_traverse_Tree(_e2240.unnamed_1.root, _e2189.w));
                                }
                                let _e2248 = phi_3053_;
                                let _e2258 = nodes.member[(0u + _e2127)].y;
                                if (_e1897 < 0f) {
                                    let _e2269 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2258.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2275 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2269.unnamed.root, _e2258.w), _e2269.unnamed_1);
                                    let _e2281 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2275.unnamed, lt_bvh_traverse_Tree(_e2258.x, _e2275.unnamed_1.first_primitive));
                                    phi_3080_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2281.unnamed, lt_bvh_traverse_Tree(_e2281.unnamed_1.root, _e2258.y));
                                } else {
                                    let _e2297 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2258.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2303 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2297.unnamed.root, _e2258.y), _e2297.unnamed_1);
                                    let _e2309 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2303.unnamed, lt_bvh_traverse_Tree(_e2258.z, _e2303.unnamed_1.first_primitive));
                                    phi_3080_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2309.unnamed, lt_bvh_traverse_Tree(_e2309.unnamed_1.root, _e2258.w));
                                }
                                let _e2317 = phi_3080_;
                                let _e2327 = nodes.member[(0u + _e2127)].z;
                                if (_e1907 < 0f) {
                                    let _e2338 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2327.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2344 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2338.unnamed.root, _e2327.w), _e2338.unnamed_1);
                                    let _e2350 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2344.unnamed, lt_bvh_traverse_Tree(_e2327.x, _e2344.unnamed_1.first_primitive));
                                    phi_3107_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2350.unnamed, lt_bvh_traverse_Tree(_e2350.unnamed_1.root, _e2327.y));
                                } else {
                                    let _e2366 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2327.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2372 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2366.unnamed.root, _e2327.y), _e2366.unnamed_1);
                                    let _e2378 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2372.unnamed, lt_bvh_traverse_Tree(_e2327.z, _e2372.unnamed_1.first_primitive));
                                    phi_3107_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2378.unnamed, lt_bvh_traverse_Tree(_e2378.unnamed_1.root, _e2327.w));
                                }
                                let _e2386 = phi_3107_;
                                phi_3113_ = 0u;
                                phi_3116_ = 0u;
                                loop {
                                    let _e2396 = phi_3113_;
                                    let _e2398 = phi_3116_;
                                    local_10 = _e2398;
                                    local_11 = _e2398;
                                    local_12 = _e2398;
                                    let _e2399 = (_e2396 < 8u);
                                    if _e2399 {
                                        let _e2401 = (_e2396 >> bitcast<u32>(2i));
                                        let _e2402 = (_e2396 & 3u);
                                        if (_e2401 == 0u) {
                                            phi_3130_ = _e2248.unnamed.root;
                                        } else {
                                            phi_3130_ = _e2248.unnamed.first_primitive;
                                        }
                                        let _e2405 = phi_3130_;
                                        if (_e2401 == 0u) {
                                            phi_3140_ = _e2317.unnamed.root;
                                        } else {
                                            phi_3140_ = _e2317.unnamed.first_primitive;
                                        }
                                        let _e2414 = phi_3140_;
                                        if (_e2401 == 0u) {
                                            phi_3150_ = _e2386.unnamed.root;
                                        } else {
                                            phi_3150_ = _e2386.unnamed.first_primitive;
                                        }
                                        let _e2423 = phi_3150_;
                                        let _e2436 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e2405 >> bitcast<u32>(((_e2402 * 8u) & 31u))) & 255u)) * _e2161) + (_e2179 - _e1939)), ((f32(((_e2414 >> bitcast<u32>(((_e2402 * 8u) & 31u))) & 255u)) * _e2162) + (_e2180 - _e1940)));
                                        let _e2437 = core_intrinsics_maximum_number_nsz_f32_(_e2436, ((f32(((_e2423 >> bitcast<u32>(((_e2402 * 8u) & 31u))) & 255u)) * _e2163) + (_e2181 - _e1941)));
                                        if (_e2401 == 0u) {
                                            phi_3168_ = _e2248.unnamed_1.root;
                                        } else {
                                            phi_3168_ = _e2248.unnamed_1.first_primitive;
                                        }
                                        let _e2440 = phi_3168_;
                                        if (_e2401 == 0u) {
                                            phi_3178_ = _e2317.unnamed_1.root;
                                        } else {
                                            phi_3178_ = _e2317.unnamed_1.first_primitive;
                                        }
                                        let _e2449 = phi_3178_;
                                        if (_e2401 == 0u) {
                                            phi_3188_ = _e2386.unnamed_1.root;
                                        } else {
                                            phi_3188_ = _e2386.unnamed_1.first_primitive;
                                        }
                                        let _e2458 = phi_3188_;
                                        let _e2471 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e2440 >> bitcast<u32>(((_e2402 * 8u) & 31u))) & 255u)) * _e2161) + (_e2179 + _e1939)), ((f32(((_e2449 >> bitcast<u32>(((_e2402 * 8u) & 31u))) & 255u)) * _e2162) + (_e2180 + _e1940)));
                                        let _e2472 = core_intrinsics_minimum_number_nsz_f32_(_e2471, ((f32(((_e2458 >> bitcast<u32>(((_e2402 * 8u) & 31u))) & 255u)) * _e2163) + (_e2181 + _e1941)));
                                        if (_e2437 <= _e2472) {
                                            if (_e2437 <= _e157) {
                                                if (_e2472 >= 0f) {
                                                    if (_e2401 == 0u) {
                                                        let _e2479 = nodes.member[(0u + _e2127)].links[2u];
                                                        phi_3224_ = _e2479;
                                                    } else {
                                                        let _e2482 = nodes.member[(0u + _e2127)].links[3u];
                                                        phi_3224_ = _e2482;
                                                    }
                                                    let _e2484 = phi_3224_;
                                                    let _e2489 = ((_e2484 >> bitcast<u32>(((_e2402 * 8u) & 31u))) & 255u);
                                                    let _e2490 = (_e2489 & 31u);
                                                    if (_e2490 >= 24u) {
                                                        phi_3237_ = (24u + ((_e2490 - 24u) ^ _e1989));
                                                    } else {
                                                        phi_3237_ = _e2490;
                                                    }
                                                    let _e2496 = phi_3237_;
                                                    phi_3242_ = (_e2398 | ((_e2489 >> bitcast<u32>(5i)) << bitcast<u32>((_e2496 & 31u))));
                                                } else {
                                                    phi_3242_ = _e2398;
                                                }
                                                let _e2504 = phi_3242_;
                                                phi_3243_ = _e2504;
                                            } else {
                                                phi_3243_ = _e2398;
                                            }
                                            let _e2506 = phi_3243_;
                                            phi_3244_ = _e2506;
                                        } else {
                                            phi_3244_ = _e2398;
                                        }
                                        let _e2508 = phi_3244_;
                                        phi_3114_ = (_e2396 + 1u);
                                        phi_3117_ = _e2508;
                                    } else {
                                        phi_3114_ = u32();
                                        phi_3117_ = u32();
                                    }
                                    let _e2511 = phi_3114_;
                                    let _e2513 = phi_3117_;
                                    continue;
                                    continuing {
                                        phi_3113_ = _e2511;
                                        phi_3116_ = _e2513;
                                        break if !(_e2399);
                                    }
                                }
                                let _e2517 = nodes.member[(0u + _e2127)].links[0u];
                                let _e2521 = nodes.member[(0u + _e2127)].frame[3u];
                                let _e2525 = local_10;
                                if ((_e2525 & 4278190080u) == 0u) {
                                } else {
                                    let _e2529 = local_1.group_mask;
                                    if ((_e2529 & 4278190080u) == 0u) {
                                    } else {
                                        let _e2533 = local_1.len;
                                        if (_e2533 < 32u) {
                                            let _e2536 = local_1.group;
                                            let _e2538 = local_1.len;
                                            if (_e2538 < 32u) {
                                            } else {
                                                return;
                                            }
                                            local_1.first[(0u + _e2538)] = _e2536;
                                            let _e2544 = local_1.group_mask;
                                            let _e2546 = local_1.len;
                                            if (_e2546 < 32u) {
                                            } else {
                                                return;
                                            }
                                            local_1.mask[(0u + _e2546)] = _e2544;
                                            let _e2553 = local_1.len;
                                            local_1.len = (_e2553 + 1u);
                                        }
                                    }
                                    local_1.group = (0u + _e2517);
                                    let _e2557 = local_11;
                                    local_1.group_mask = ((_e2557 & 4278190080u) | (_e2521 >> bitcast<u32>(24i)));
                                }
                                let _e2562 = local_12;
                                phi_3302_ = (_e2562 & 16777215u);
                                phi_3305_ = _e2129;
                                loop {
                                    let _e2565 = phi_3302_;
                                    let _e2567 = phi_3305_;
                                    local_23 = _e2567;
                                    let _e2568 = (_e2565 == 0u);
                                    local_13 = _e2568;
                                    local_25 = _e2568;
                                    if _e2568 {
                                        phi_3303_ = u32();
                                        phi_3306_ = bool();
                                        phi_4109_ = bool();
                                        phi_4110_ = false;
                                    } else {
                                        let _e2571 = nodes.member[(0u + _e2127)].links[1u];
                                        let _e2576 = ((0u + _e2571) + select(firstTrailingBit(_e2565), 32u, (_e2565 == 0u)));
                                        if (_e2576 < _e91) {
                                        } else {
                                            return;
                                        }
                                        let _e2583 = triangles.member[(0u + _e2576)].v0_;
                                        let _e2585 = (_e2583.x - _e145);
                                        let _e2587 = (_e2583.y - _e147);
                                        let _e2589 = (_e2583.z - _e149);
                                        if (_e1962 == 0u) {
                                            phi_3350_ = vec3<f32>(_e2587, _e2589, _e2585);
                                        } else {
                                            if (_e1962 == 1u) {
                                                phi_3349_ = vec3<f32>(_e2589, _e2585, _e2587);
                                            } else {
                                                phi_3349_ = (_e2583 - vec3<f32>(_e145, _e147, _e149));
                                            }
                                            let _e2597 = phi_3349_;
                                            phi_3350_ = _e2597;
                                        }
                                        let _e2599 = phi_3350_;
                                        let _e2603 = (_e2599.x - (_e1973 * _e2599.z));
                                        let _e2607 = (_e2599.y - (_e1976 * _e2599.z));
                                        let _e2609 = triangles.member[(0u + _e2576)].v1_;
                                        let _e2611 = (_e2609.x - _e145);
                                        let _e2613 = (_e2609.y - _e147);
                                        let _e2615 = (_e2609.z - _e149);
                                        if (_e1962 == 0u) {
                                            phi_3380_ = vec3<f32>(_e2613, _e2615, _e2611);
                                        } else {
                                            if (_e1962 == 1u) {
                                                phi_3379_ = vec3<f32>(_e2615, _e2611, _e2613);
                                            } else {
                                                phi_3379_ = (_e2609 - vec3<f32>(_e145, _e147, _e149));
                                            }
                                            let _e2623 = phi_3379_;
                                            phi_3380_ = _e2623;
                                        }
                                        let _e2625 = phi_3380_;
                                        let _e2629 = (_e2625.x - (_e1973 * _e2625.z));
                                        let _e2633 = (_e2625.y - (_e1976 * _e2625.z));
                                        let _e2635 = triangles.member[(0u + _e2576)].v2_;
                                        let _e2637 = (_e2635.x - _e145);
                                        let _e2639 = (_e2635.y - _e147);
                                        let _e2641 = (_e2635.z - _e149);
                                        if (_e1962 == 0u) {
                                            phi_3410_ = vec3<f32>(_e2639, _e2641, _e2637);
                                        } else {
                                            if (_e1962 == 1u) {
                                                phi_3409_ = vec3<f32>(_e2641, _e2637, _e2639);
                                            } else {
                                                phi_3409_ = (_e2635 - vec3<f32>(_e145, _e147, _e149));
                                            }
                                            let _e2649 = phi_3409_;
                                            phi_3410_ = _e2649;
                                        }
                                        let _e2651 = phi_3410_;
                                        let _e2655 = (_e2651.x - (_e1973 * _e2651.z));
                                        let _e2659 = (_e2651.y - (_e1976 * _e2651.z));
                                        if (_e2629 < _e2655) {
                                            phi_3429_ = true;
                                        } else {
                                            if (_e2629 == _e2655) {
                                                phi_3428_ = (_e2633 < _e2659);
                                            } else {
                                                phi_3428_ = false;
                                            }
                                            let _e2664 = phi_3428_;
                                            phi_3429_ = _e2664;
                                        }
                                        let _e2666 = phi_3429_;
                                        if _e2666 {
                                            phi_3433_ = _e2659;
                                            phi_3434_ = _e2655;
                                            phi_3435_ = _e2633;
                                            phi_3436_ = _e2629;
                                        } else {
                                            phi_3433_ = _e2633;
                                            phi_3434_ = _e2629;
                                            phi_3435_ = _e2659;
                                            phi_3436_ = _e2655;
                                        }
                                        let _e2668 = phi_3433_;
                                        let _e2670 = phi_3434_;
                                        let _e2672 = phi_3435_;
                                        let _e2674 = phi_3436_;
                                        let _e2677 = ((_e2674 * _e2668) - (_e2672 * _e2670));
                                        if _e2666 {
                                            phi_3444_ = -(_e2677);
                                        } else {
                                            phi_3444_ = _e2677;
                                        }
                                        let _e2680 = phi_3444_;
                                        if (_e2655 < _e2603) {
                                            phi_3455_ = true;
                                        } else {
                                            if (_e2655 == _e2603) {
                                                phi_3454_ = (_e2659 < _e2607);
                                            } else {
                                                phi_3454_ = false;
                                            }
                                            let _e2685 = phi_3454_;
                                            phi_3455_ = _e2685;
                                        }
                                        let _e2687 = phi_3455_;
                                        if _e2687 {
                                            phi_3459_ = _e2607;
                                            phi_3460_ = _e2603;
                                            phi_3461_ = _e2659;
                                            phi_3462_ = _e2655;
                                        } else {
                                            phi_3459_ = _e2659;
                                            phi_3460_ = _e2655;
                                            phi_3461_ = _e2607;
                                            phi_3462_ = _e2603;
                                        }
                                        let _e2689 = phi_3459_;
                                        let _e2691 = phi_3460_;
                                        let _e2693 = phi_3461_;
                                        let _e2695 = phi_3462_;
                                        let _e2698 = ((_e2695 * _e2689) - (_e2693 * _e2691));
                                        if _e2687 {
                                            phi_3470_ = -(_e2698);
                                        } else {
                                            phi_3470_ = _e2698;
                                        }
                                        let _e2701 = phi_3470_;
                                        if (_e2603 < _e2629) {
                                            phi_3481_ = true;
                                        } else {
                                            if (_e2603 == _e2629) {
                                                phi_3480_ = (_e2607 < _e2633);
                                            } else {
                                                phi_3480_ = false;
                                            }
                                            let _e2706 = phi_3480_;
                                            phi_3481_ = _e2706;
                                        }
                                        let _e2708 = phi_3481_;
                                        if _e2708 {
                                            phi_3485_ = _e2633;
                                            phi_3486_ = _e2629;
                                            phi_3487_ = _e2607;
                                            phi_3488_ = _e2603;
                                        } else {
                                            phi_3485_ = _e2607;
                                            phi_3486_ = _e2603;
                                            phi_3487_ = _e2633;
                                            phi_3488_ = _e2629;
                                        }
                                        let _e2710 = phi_3485_;
                                        let _e2712 = phi_3486_;
                                        let _e2714 = phi_3487_;
                                        let _e2716 = phi_3488_;
                                        let _e2719 = ((_e2716 * _e2710) - (_e2714 * _e2712));
                                        if _e2708 {
                                            phi_3496_ = -(_e2719);
                                        } else {
                                            phi_3496_ = _e2719;
                                        }
                                        let _e2722 = phi_3496_;
                                        if (_e2680 >= 0f) {
                                            if (_e2701 >= 0f) {
                                                if (_e2722 >= 0f) {
                                                    phi_3511_ = ((_e2680 + _e2701) + _e2722);
                                                    phi_3512_ = false;
                                                } else {
                                                    phi_3511_ = f32();
                                                    phi_3512_ = true;
                                                }
                                                let _e2729 = phi_3511_;
                                                let _e2731 = phi_3512_;
                                                phi_3513_ = _e2729;
                                                phi_3514_ = _e2731;
                                            } else {
                                                phi_3513_ = f32();
                                                phi_3514_ = true;
                                            }
                                            let _e2733 = phi_3513_;
                                            let _e2735 = phi_3514_;
                                            phi_3515_ = _e2733;
                                            phi_3516_ = _e2735;
                                        } else {
                                            phi_3515_ = f32();
                                            phi_3516_ = true;
                                        }
                                        let _e2737 = phi_3515_;
                                        let _e2739 = phi_3516_;
                                        if _e2739 {
                                            if (_e2680 <= 0f) {
                                                if (_e2701 <= 0f) {
                                                    let _e2742 = (_e2722 <= 0f);
                                                    if _e2742 {
                                                    }
                                                    phi_3534_ = ((_e2680 + _e2701) + _e2722);
                                                    phi_3535_ = false;
                                                    phi_3536_ = _e2742;
                                                } else {
                                                    phi_3534_ = f32();
                                                    phi_3535_ = true;
                                                    phi_3536_ = false;
                                                }
                                                let _e2746 = phi_3534_;
                                                let _e2748 = phi_3535_;
                                                let _e2750 = phi_3536_;
                                                phi_3537_ = _e2746;
                                                phi_3538_ = _e2748;
                                                phi_3539_ = _e2750;
                                            } else {
                                                phi_3537_ = f32();
                                                phi_3538_ = true;
                                                phi_3539_ = false;
                                            }
                                            let _e2752 = phi_3537_;
                                            let _e2754 = phi_3538_;
                                            let _e2756 = phi_3539_;
                                            if _e2754 {
                                                phi_3543_ = false;
                                            } else {
                                                phi_3543_ = _e2756;
                                            }
                                            let _e2758 = phi_3543_;
                                            phi_3544_ = _e2752;
                                            phi_3545_ = _e2758;
                                        } else {
                                            phi_3544_ = _e2737;
                                            phi_3545_ = true;
                                        }
                                        let _e2760 = phi_3544_;
                                        let _e2762 = phi_3545_;
                                        if _e2762 {
                                            let _e2763 = (_e2760 == 0f);
                                            if _e2763 {
                                                phi_3861_ = lt_bvh_triangle_Intersection();
                                                phi_3862_ = false;
                                            } else {
                                                let _e2765 = triangles.member[(0u + _e2576)].v0_;
                                                let _e2767 = (_e2765.x - _e145);
                                                let _e2769 = (_e2765.y - _e147);
                                                let _e2771 = (_e2765.z - _e149);
                                                if (_e1962 == 0u) {
                                                    phi_3574_ = vec3<f32>(_e2769, _e2771, _e2767);
                                                } else {
                                                    if (_e1962 == 1u) {
                                                        phi_3573_ = vec3<f32>(_e2771, _e2767, _e2769);
                                                    } else {
                                                        phi_3573_ = (_e2765 - vec3<f32>(_e145, _e147, _e149));
                                                    }
                                                    let _e2779 = phi_3573_;
                                                    phi_3574_ = _e2779;
                                                }
                                                let _e2781 = phi_3574_;
                                                let _e2783 = triangles.member[(0u + _e2576)].v1_;
                                                let _e2785 = triangles.member[(0u + _e2576)].v0_;
                                                let _e2788 = (_e2783.x - _e2785.x);
                                                let _e2791 = (_e2783.y - _e2785.y);
                                                let _e2794 = (_e2783.z - _e2785.z);
                                                if (_e1962 == 0u) {
                                                    phi_3600_ = vec3<f32>(_e2791, _e2794, _e2788);
                                                } else {
                                                    if (_e1962 == 1u) {
                                                        phi_3599_ = vec3<f32>(_e2794, _e2788, _e2791);
                                                    } else {
                                                        phi_3599_ = (_e2783 - _e2785);
                                                    }
                                                    let _e2801 = phi_3599_;
                                                    phi_3600_ = _e2801;
                                                }
                                                let _e2803 = phi_3600_;
                                                let _e2805 = triangles.member[(0u + _e2576)].v2_;
                                                let _e2807 = triangles.member[(0u + _e2576)].v0_;
                                                let _e2810 = (_e2805.x - _e2807.x);
                                                let _e2813 = (_e2805.y - _e2807.y);
                                                let _e2816 = (_e2805.z - _e2807.z);
                                                if (_e1962 == 0u) {
                                                    phi_3626_ = vec3<f32>(_e2813, _e2816, _e2810);
                                                } else {
                                                    if (_e1962 == 1u) {
                                                        phi_3625_ = vec3<f32>(_e2816, _e2810, _e2813);
                                                    } else {
                                                        phi_3625_ = (_e2805 - _e2807);
                                                    }
                                                    let _e2823 = phi_3625_;
                                                    phi_3626_ = _e2823;
                                                }
                                                let _e2825 = phi_3626_;
                                                let _e2832 = ((_e2803.y * _e2825.z) - (_e2803.z * _e2825.y));
                                                let _e2839 = ((_e2803.z * _e2825.x) - (_e2803.x * _e2825.z));
                                                let _e2846 = ((_e2803.x * _e2825.y) - (_e2803.y * _e2825.x));
                                                let _e2860 = (((1f / _e1970.z) * (((_e2832 * _e2781.x) + (_e2839 * _e2781.y)) + (_e2846 * _e2781.z))) / (((_e2832 * _e1973) + (_e2839 * _e1976)) + _e2846));
                                                if (_e2860 > 0f) {
                                                    if (_e2860 < _e157) {
                                                        let _e2864 = triangles.member[(0u + _e2576)].v0_;
                                                        let _e2866 = triangles.member[(0u + _e2576)].v1_;
                                                        if (_e2864.x < _e2866.x) {
                                                            phi_3682_ = _e2864.x;
                                                        } else {
                                                            phi_3682_ = _e2866.x;
                                                        }
                                                        let _e2873 = phi_3682_;
                                                        if (_e2864.y < _e2866.y) {
                                                            phi_3691_ = _e2864.y;
                                                        } else {
                                                            phi_3691_ = _e2866.y;
                                                        }
                                                        let _e2880 = phi_3691_;
                                                        if (_e2864.z < _e2866.z) {
                                                            phi_3700_ = _e2864.z;
                                                        } else {
                                                            phi_3700_ = _e2866.z;
                                                        }
                                                        let _e2887 = phi_3700_;
                                                        let _e2889 = triangles.member[(0u + _e2576)].v2_;
                                                        if (_e2873 < _e2889.x) {
                                                            phi_3709_ = _e2873;
                                                        } else {
                                                            phi_3709_ = _e2889.x;
                                                        }
                                                        let _e2894 = phi_3709_;
                                                        if (_e2880 < _e2889.y) {
                                                            phi_3716_ = _e2880;
                                                        } else {
                                                            phi_3716_ = _e2889.y;
                                                        }
                                                        let _e2899 = phi_3716_;
                                                        if (_e2887 < _e2889.z) {
                                                            phi_3723_ = _e2887;
                                                        } else {
                                                            phi_3723_ = _e2889.z;
                                                        }
                                                        let _e2904 = phi_3723_;
                                                        let _e2906 = triangles.member[(0u + _e2576)].v0_;
                                                        let _e2908 = triangles.member[(0u + _e2576)].v1_;
                                                        if (_e2906.x > _e2908.x) {
                                                            phi_3736_ = _e2906.x;
                                                        } else {
                                                            phi_3736_ = _e2908.x;
                                                        }
                                                        let _e2915 = phi_3736_;
                                                        if (_e2906.y > _e2908.y) {
                                                            phi_3745_ = _e2906.y;
                                                        } else {
                                                            phi_3745_ = _e2908.y;
                                                        }
                                                        let _e2922 = phi_3745_;
                                                        if (_e2906.z > _e2908.z) {
                                                            phi_3754_ = _e2906.z;
                                                        } else {
                                                            phi_3754_ = _e2908.z;
                                                        }
                                                        let _e2929 = phi_3754_;
                                                        let _e2931 = triangles.member[(0u + _e2576)].v2_;
                                                        if (_e2915 > _e2931.x) {
                                                            phi_3763_ = _e2915;
                                                        } else {
                                                            phi_3763_ = _e2931.x;
                                                        }
                                                        let _e2936 = phi_3763_;
                                                        if (_e2922 > _e2931.y) {
                                                            phi_3770_ = _e2922;
                                                        } else {
                                                            phi_3770_ = _e2931.y;
                                                        }
                                                        let _e2941 = phi_3770_;
                                                        if (_e2929 > _e2931.z) {
                                                            phi_3777_ = _e2929;
                                                        } else {
                                                            phi_3777_ = _e2931.z;
                                                        }
                                                        let _e2946 = phi_3777_;
                                                        let _e2950 = ((_e2894 - _e145) * _e1887);
                                                        let _e2951 = ((_e2899 - _e147) * _e1897);
                                                        let _e2952 = ((_e2904 - _e149) * _e1907);
                                                        let _e2956 = ((_e2936 - _e145) * _e1887);
                                                        let _e2957 = ((_e2941 - _e147) * _e1897);
                                                        let _e2958 = ((_e2946 - _e149) * _e1907);
                                                        if (_e2950 < _e2956) {
                                                            phi_3794_ = _e2950;
                                                        } else {
                                                            phi_3794_ = _e2956;
                                                        }
                                                        let _e2961 = phi_3794_;
                                                        if (_e2951 < _e2957) {
                                                            phi_3799_ = _e2951;
                                                        } else {
                                                            phi_3799_ = _e2957;
                                                        }
                                                        let _e2964 = phi_3799_;
                                                        if (_e2952 < _e2958) {
                                                            phi_3804_ = _e2952;
                                                        } else {
                                                            phi_3804_ = _e2958;
                                                        }
                                                        let _e2967 = phi_3804_;
                                                        if (_e2950 > _e2956) {
                                                            phi_3812_ = _e2950;
                                                        } else {
                                                            phi_3812_ = _e2956;
                                                        }
                                                        let _e2973 = phi_3812_;
                                                        if (_e2951 > _e2957) {
                                                            phi_3817_ = _e2951;
                                                        } else {
                                                            phi_3817_ = _e2957;
                                                        }
                                                        let _e2976 = phi_3817_;
                                                        if (_e2952 > _e2958) {
                                                            phi_3822_ = _e2952;
                                                        } else {
                                                            phi_3822_ = _e2958;
                                                        }
                                                        let _e2979 = phi_3822_;
                                                        let _e2983 = core_intrinsics_maximum_number_nsz_f32_((_e2961 - _e1946), (_e2964 - _e1947));
                                                        let _e2984 = core_intrinsics_maximum_number_nsz_f32_(_e2983, (_e2967 - _e1948));
                                                        let _e2985 = core_intrinsics_minimum_number_nsz_f32_((_e2973 + _e1946), (_e2976 + _e1947));
                                                        let _e2986 = core_intrinsics_minimum_number_nsz_f32_(_e2985, (_e2979 + _e1948));
                                                        if (_e2984 > -300000000000000000000000000000000000000f) {
                                                            phi_3834_ = _e2984;
                                                        } else {
                                                            phi_3834_ = -300000000000000000000000000000000000000f;
                                                        }
                                                        let _e2989 = phi_3834_;
                                                        if (_e2986 < 300000000000000000000000000000000000000f) {
                                                            phi_3839_ = _e2986;
                                                        } else {
                                                            phi_3839_ = 300000000000000000000000000000000000000f;
                                                        }
                                                        let _e2992 = phi_3839_;
                                                        if (_e2860 < _e2989) {
                                                            phi_3844_ = _e2989;
                                                        } else {
                                                            phi_3844_ = _e2860;
                                                        }
                                                        let _e2995 = phi_3844_;
                                                        if (_e2995 > _e2992) {
                                                            phi_3849_ = _e2992;
                                                        } else {
                                                            phi_3849_ = _e2995;
                                                        }
                                                        let _e2998 = phi_3849_;
                                                        phi_3854_ = lt_bvh_triangle_Intersection(_e2998, (_e2701 / _e2760), (_e2722 / _e2760), (_e2989 <= _e2992));
                                                        phi_3855_ = false;
                                                    } else {
                                                        phi_3854_ = lt_bvh_triangle_Intersection();
                                                        phi_3855_ = true;
                                                    }
                                                    let _e3004 = phi_3854_;
                                                    let _e3006 = phi_3855_;
                                                    phi_3856_ = _e3004;
                                                    phi_3857_ = _e3006;
                                                } else {
                                                    phi_3856_ = lt_bvh_triangle_Intersection();
                                                    phi_3857_ = true;
                                                }
                                                let _e3008 = phi_3856_;
                                                let _e3010 = phi_3857_;
                                                if _e3010 {
                                                }
                                                phi_3861_ = _e3008;
                                                phi_3862_ = _e3010;
                                            }
                                            let _e3012 = phi_3861_;
                                            let _e3014 = phi_3862_;
                                            phi_3863_ = _e3012;
                                            phi_3864_ = _e2763;
                                            phi_3865_ = _e3014;
                                        } else {
                                            phi_3863_ = lt_bvh_triangle_Intersection();
                                            phi_3864_ = true;
                                            phi_3865_ = false;
                                        }
                                        let _e3016 = phi_3863_;
                                        let _e3018 = phi_3864_;
                                        let _e3020 = phi_3865_;
                                        if _e3018 {
                                            phi_3869_ = true;
                                        } else {
                                            phi_3869_ = _e3020;
                                        }
                                        let _e3022 = phi_3869_;
                                        if _e3022 {
                                            phi_3873_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                        } else {
                                            phi_3873_ = _e3016;
                                        }
                                        let _e3024 = phi_3873_;
                                        if _e3024.is_hit {
                                            if (_e3024.t > 0f) {
                                                if (_e3024.t < _e157) {
                                                    let _e3031 = triangles.member[(0u + _e2576)].i0_;
                                                    if ((_e3031 & 2147483648u) == 0u) {
                                                        phi_4092_ = true;
                                                    } else {
                                                        if (_e2576 < _e91) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e3040 = triangles.member[(0u + _e2576)].i0_;
                                                        let _e3041 = (_e3040 & 2147483647u);
                                                        let _e3043 = triangles.member[(0u + _e2576)].i1_;
                                                        let _e3045 = triangles.member[(0u + _e2576)].i2_;
                                                        if (_e3041 < _e104) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e3049 = vertices.member[(0u + _e3041)];
                                                        if (_e3043 < _e104) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e3053 = vertices.member[(0u + _e3043)];
                                                        if (_e3045 < _e104) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e3057 = vertices.member[(0u + _e3045)];
                                                        let _e3058 = array<abi_Vertex, 3>(_e3049, _e3053, _e3057);
                                                        if (_e3058[0].material < _e107) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e3064 = materials.member[(0u + _e3058[0].material)];
                                                        if ((_e3064.flags & 1u) == 1u) {
                                                            let _e3069 = ((1f - _e3024.u) - _e3024.v);
                                                            if (_e3064.cutoff <= 0f) {
                                                                phi_4090_ = true;
                                                            } else {
                                                                let _e3096 = (_e3064.base_color.w * ((((f32((_e3058[0].color >> bitcast<u32>(24i))) * _e3069) + (f32((_e3058[1].color >> bitcast<u32>(24i))) * _e3024.u)) + (f32((_e3058[2].color >> bitcast<u32>(24i))) * _e3024.v)) * (1f / 255f)));
                                                                if (_e3064.alpha_size == 0u) {
                                                                    phi_4087_ = _e3096;
                                                                } else {
                                                                    local.offset = _e3064.alpha_offset;
                                                                    local.size = _e3064.alpha_size;
                                                                    local.flags = _e3064.flags;
                                                                    let _e3127 = _lt_shaders_texture_TextureView_quad((&local), (((_e3058[0].u * _e3069) + (_e3058[1].u * _e3024.u)) + (_e3058[2].u * _e3024.v)), (((_e3058[0].v * _e3069) + (_e3058[1].v * _e3024.u)) + (_e3058[2].v * _e3024.v)));
                                                                    let _e3131 = (_e3127.indices[0] >> bitcast<u32>(2i));
                                                                    if (_e3131 < _e110) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e3135 = alpha_texels.member[(0u + _e3131)];
                                                                    let _e3151 = (_e3127.indices[1] >> bitcast<u32>(2i));
                                                                    if (_e3151 < _e110) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e3155 = alpha_texels.member[(0u + _e3151)];
                                                                    let _e3172 = (_e3127.indices[2] >> bitcast<u32>(2i));
                                                                    if (_e3172 < _e110) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e3176 = alpha_texels.member[(0u + _e3172)];
                                                                    let _e3193 = (_e3127.indices[3] >> bitcast<u32>(2i));
                                                                    if (_e3193 < _e110) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e3197 = alpha_texels.member[(0u + _e3193)];
                                                                    phi_4087_ = (_e3096 * (((((f32(((_e3135 >> bitcast<u32>((((_e3127.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e3127.weights.x) + ((f32(((_e3155 >> bitcast<u32>((((_e3127.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e3127.weights.y)) + ((f32(((_e3176 >> bitcast<u32>((((_e3127.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e3127.weights.z)) + ((f32(((_e3197 >> bitcast<u32>((((_e3127.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e3127.weights.w)));
                                                                }
                                                                let _e3213 = phi_4087_;
                                                                phi_4090_ = (_e3213 >= _e3064.cutoff);
                                                            }
                                                            let _e3217 = phi_4090_;
                                                            phi_4091_ = _e3217;
                                                        } else {
                                                            phi_4091_ = false;
                                                        }
                                                        let _e3219 = phi_4091_;
                                                        phi_4092_ = _e3219;
                                                    }
                                                    let _e3221 = phi_4092_;
                                                    if _e3221 {
                                                        phi_4096_ = false;
                                                    } else {
                                                        phi_4096_ = true;
                                                    }
                                                    let _e3223 = phi_4096_;
                                                    phi_4097_ = _e3221;
                                                    phi_4098_ = _e3221;
                                                    phi_4099_ = _e3223;
                                                } else {
                                                    phi_4097_ = bool();
                                                    phi_4098_ = _e2567;
                                                    phi_4099_ = true;
                                                }
                                                let _e3225 = phi_4097_;
                                                let _e3227 = phi_4098_;
                                                let _e3229 = phi_4099_;
                                                phi_4100_ = _e3225;
                                                phi_4101_ = _e3227;
                                                phi_4102_ = _e3229;
                                            } else {
                                                phi_4100_ = bool();
                                                phi_4101_ = _e2567;
                                                phi_4102_ = true;
                                            }
                                            let _e3231 = phi_4100_;
                                            let _e3233 = phi_4101_;
                                            let _e3235 = phi_4102_;
                                            phi_4103_ = _e3231;
                                            phi_4104_ = _e3233;
                                            phi_4105_ = _e3235;
                                        } else {
                                            phi_4103_ = bool();
                                            phi_4104_ = _e2567;
                                            phi_4105_ = true;
                                        }
                                        let _e3237 = phi_4103_;
                                        let _e3239 = phi_4104_;
                                        let _e3241 = phi_4105_;
                                        if _e3241 {
                                        }
                                        phi_3303_ = (_e2565 & (_e2565 - 1u));
                                        phi_3306_ = _e3239;
                                        phi_4109_ = _e3237;
                                        phi_4110_ = _e3241;
                                    }
                                    let _e3243 = phi_3303_;
                                    let _e3245 = phi_3306_;
                                    let _e3247 = phi_4109_;
                                    let _e3249 = phi_4110_;
                                    local_24 = _e3247;
                                    continue;
                                    continuing {
                                        phi_3302_ = _e3243;
                                        phi_3305_ = _e3245;
                                        break if !(_e3249);
                                    }
                                }
                                let _e3252 = local_13;
                                if _e3252 {
                                    let _e3254 = local_1.group_mask;
                                    if ((_e3254 & 4278190080u) == 0u) {
                                        let _e3258 = local_1.len;
                                        if (_e3258 == 0u) {
                                            phi_4152_ = false;
                                        } else {
                                            let _e3262 = local_1.len;
                                            local_1.len = (_e3262 - 1u);
                                            let _e3265 = local_1.len;
                                            if (_e3265 < 32u) {
                                            } else {
                                                return;
                                            }
                                            let _e3270 = local_1.first[(0u + _e3265)];
                                            local_1.group = _e3270;
                                            let _e3273 = local_1.len;
                                            if (_e3273 < 32u) {
                                            } else {
                                                return;
                                            }
                                            let _e3278 = local_1.mask[(0u + _e3273)];
                                            local_1.group_mask = _e3278;
                                            phi_4152_ = true;
                                        }
                                        let _e3281 = phi_4152_;
                                        phi_4153_ = _e3281;
                                    } else {
                                        phi_4153_ = true;
                                    }
                                    let _e3283 = phi_4153_;
                                    if _e3283 {
                                        let _e3285 = local_1.group_mask;
                                        let _e3291 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e3285)), 32u, (_e3285 == 0u)));
                                        let _e3295 = local_1.group_mask;
                                        let _e3309 = local_1.group_mask;
                                        local_1.group_mask = (_e3309 & ~((1u << bitcast<u32>((_e3291 & 31u)))));
                                        let _e3312 = local_1.group;
                                        phi_4184_ = (_e3312 + countOneBits(((_e3295 & ~((4294967295u << bitcast<u32>((((_e3291 - 24u) ^ _e1989) & 31u))))) & 255u)));
                                    } else {
                                        phi_4184_ = 4294967295u;
                                    }
                                    let _e3315 = phi_4184_;
                                    phi_4185_ = _e3315;
                                } else {
                                    phi_4185_ = u32();
                                }
                                let _e3317 = phi_4185_;
                                phi_2971_ = _e3317;
                                let _e3777 = local_23;
                                phi_2974_ = _e3777;
                                let _e3780 = local_24;
                                phi_4186_ = _e3780;
                                let _e3783 = local_25;
                                phi_4187_ = _e3783;
                                phi_4188_ = false;
                            } else {
                                phi_2971_ = u32();
                                phi_2974_ = bool();
                                phi_4186_ = bool();
                                phi_4187_ = false;
                                phi_4188_ = true;
                            }
                            let _e3319 = phi_2971_;
                            let _e3321 = phi_2974_;
                            let _e3323 = phi_4186_;
                            let _e3325 = phi_4187_;
                            let _e3327 = phi_4188_;
                            local_14 = _e3327;
                            local_26 = _e3323;
                            continue;
                            continuing {
                                phi_2970_ = _e3319;
                                phi_2973_ = _e3321;
                                break if !(_e3325);
                            }
                        }
                        let _e3330 = local_14;
                        if _e3330 {
                            phi_4192_ = false;
                        } else {
                            phi_4192_ = true;
                        }
                        let _e3332 = phi_4192_;
                        if _e3332 {
                            let _e3789 = local_26;
                            phi_4196_ = _e3789;
                        } else {
                            let _e3791 = local_27;
                            phi_4196_ = _e3791;
                        }
                        let _e3334 = phi_4196_;
                        phi_4197_ = _e3334;
                    }
                    let _e3336 = phi_4197_;
                    phi_4198_ = _e3336;
                    phi_4199_ = _e1811;
                } else {
                    phi_4198_ = bool();
                    phi_4199_ = true;
                }
                let _e3338 = phi_4198_;
                let _e3340 = phi_4199_;
                if _e3340 {
                    phi_4203_ = false;
                } else {
                    phi_4203_ = _e3338;
                }
                let _e3342 = phi_4203_;
                phi_4204_ = _e3342;
            }
            let _e3344 = phi_4204_;
            phi_4205_ = _e3344;
        } else {
            phi_4205_ = false;
        }
        let _e3346 = phi_4205_;
        if _e3346 {
            phi_4209_ = 0f;
        } else {
            phi_4209_ = 1f;
        }
        let _e3348 = phi_4209_;
        if (_e124 < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e124)] = _e3348;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_list_light_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
