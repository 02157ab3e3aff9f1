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
    var phi_714_: f32;
    var phi_747_: bool;
    var phi_748_: bool;
    var phi_749_: bool;
    var phi_750_: bool;
    var phi_754_: bool;
    var phi_767_: bool;
    var phi_768_: bool;
    var phi_769_: bool;
    var phi_770_: bool;
    var phi_774_: bool;
    var phi_787_: bool;
    var phi_788_: bool;
    var phi_789_: bool;
    var phi_793_: bool;
    var phi_794_: bool;
    var phi_795_: bool;
    var phi_796_: bool;
    var phi_797_: bool;
    var phi_801_: bool;
    var phi_824_: bool;
    var phi_825_: bool;
    var phi_826_: bool;
    var phi_827_: bool;
    var phi_828_: bool;
    var phi_829_: bool;
    var phi_833_: bool;
    var phi_846_: bool;
    var phi_847_: bool;
    var phi_848_: bool;
    var phi_852_: bool;
    var phi_869_: bool;
    var phi_870_: bool;
    var phi_871_: bool;
    var phi_872_: bool;
    var phi_873_: bool;
    var phi_874_: bool;
    var phi_875_: bool;
    var phi_879_: bool;
    var phi_899_: bool;
    var phi_900_: bool;
    var phi_908_: u32;
    var phi_909_: f32;
    var phi_910_: u32;
    var phi_911_: f32;
    var phi_916_: f32;
    var phi_927_: u32;
    var phi_937_: u32;
    var phi_943_: u32;
    var phi_944_: u32;
    var phi_945_: u32;
    var phi_956_: vec3<f32>;
    var phi_957_: vec3<f32>;
    var phi_979_: vec3<f32>;
    var phi_980_: vec3<f32>;
    var phi_1002_: u0028_lt_bvh_LightPoint_u0020_u32_u0029_;
    var phi_1077_: f32;
    var phi_1084_: f32;
    var phi_1091_: f32;
    var phi_1098_: f32;
    var phi_1105_: f32;
    var phi_1112_: f32;
    var phi_1129_: f32;
    var phi_1134_: f32;
    var phi_1139_: f32;
    var phi_1144_: f32;
    var phi_1149_: f32;
    var phi_1171_: bool;
    var phi_1172_: bool;
    var phi_1180_: u32;
    var phi_1181_: u32;
    var phi_1192_: vec3<f32>;
    var phi_1193_: vec3<f32>;
    var phi_1205_: u32;
    var phi_1208_: u32;
    var phi_1213_: u32;
    var phi_1215_: u32;
    var phi_1217_: u32;
    var phi_1219_: u32;
    var phi_1291_: f32;
    var phi_1292_: f32;
    var phi_1306_: u32;
    var phi_1329_: f32;
    var phi_1330_: f32;
    var phi_1344_: u32;
    var phi_1366_: f32;
    var phi_1367_: f32;
    var phi_1381_: u32;
    var phi_1404_: f32;
    var phi_1405_: f32;
    var phi_1419_: u32;
    var phi_1611_: u32;
    var phi_1612_: u32;
    var phi_1617_: u32;
    var phi_1618_: u32;
    var phi_1619_: u32;
    var phi_1216_: u32;
    var phi_1218_: u32;
    var phi_1620_: u32;
    var phi_1638_: u32;
    var phi_1639_: u32;
    var phi_1206_: u32;
    var phi_1209_: u32;
    var phi_1648_: bool;
    var phi_1649_: bool;
    var phi_1650_: bool;
    var local_4: bool;
    var local_5: u32;
    var phi_1659_: u32;
    var local_6: u32;
    var phi_1694_: u32;
    var phi_1695_: u32;
    var phi_1701_: u32;
    var phi_1729_: vec3<f32>;
    var phi_1730_: vec3<f32>;
    var phi_1759_: vec3<f32>;
    var phi_1760_: vec3<f32>;
    var phi_1789_: vec3<f32>;
    var phi_1790_: vec3<f32>;
    var phi_1808_: bool;
    var phi_1809_: bool;
    var phi_1813_: f32;
    var phi_1814_: f32;
    var phi_1815_: f32;
    var phi_1816_: f32;
    var phi_1824_: f32;
    var phi_1834_: bool;
    var phi_1835_: bool;
    var phi_1839_: f32;
    var phi_1840_: f32;
    var phi_1841_: f32;
    var phi_1842_: f32;
    var phi_1850_: f32;
    var phi_1860_: bool;
    var phi_1861_: bool;
    var phi_1865_: f32;
    var phi_1866_: f32;
    var phi_1867_: f32;
    var phi_1868_: f32;
    var phi_1876_: f32;
    var phi_1891_: f32;
    var phi_1892_: bool;
    var phi_1893_: f32;
    var phi_1894_: bool;
    var phi_1895_: f32;
    var phi_1896_: bool;
    var phi_1914_: f32;
    var phi_1915_: bool;
    var phi_1916_: bool;
    var phi_1917_: f32;
    var phi_1918_: bool;
    var phi_1919_: bool;
    var phi_1923_: bool;
    var phi_1924_: f32;
    var phi_1925_: bool;
    var phi_1953_: vec3<f32>;
    var phi_1954_: vec3<f32>;
    var phi_1979_: vec3<f32>;
    var phi_1980_: vec3<f32>;
    var phi_2005_: vec3<f32>;
    var phi_2006_: vec3<f32>;
    var phi_2062_: f32;
    var phi_2071_: f32;
    var phi_2080_: f32;
    var phi_2089_: f32;
    var phi_2096_: f32;
    var phi_2103_: f32;
    var phi_2116_: f32;
    var phi_2125_: f32;
    var phi_2134_: f32;
    var phi_2143_: f32;
    var phi_2150_: f32;
    var phi_2157_: f32;
    var phi_2174_: f32;
    var phi_2179_: f32;
    var phi_2184_: f32;
    var phi_2192_: f32;
    var phi_2197_: f32;
    var phi_2202_: f32;
    var phi_2214_: f32;
    var phi_2219_: f32;
    var phi_2224_: f32;
    var phi_2229_: f32;
    var phi_2234_: lt_bvh_triangle_Intersection;
    var phi_2235_: bool;
    var phi_2236_: lt_bvh_triangle_Intersection;
    var phi_2237_: bool;
    var phi_2241_: lt_bvh_triangle_Intersection;
    var phi_2242_: bool;
    var phi_2243_: lt_bvh_triangle_Intersection;
    var phi_2244_: bool;
    var phi_2245_: bool;
    var phi_2249_: bool;
    var phi_2253_: lt_bvh_triangle_Intersection;
    var phi_2467_: f32;
    var phi_2470_: bool;
    var phi_2471_: bool;
    var phi_2475_: bool;
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
    var phi_2492_: bool;
    var phi_2493_: bool;
    var phi_2494_: bool;
    var phi_2502_: bool;
    var phi_2503_: bool;
    var phi_2504_: bool;
    var phi_2505_: bool;
    var phi_2506_: bool;
    var local_7: bool;
    var phi_2510_: bool;
    var phi_2511_: bool;
    var phi_2512_: bool;
    var phi_2513_: bool;
    var phi_2514_: bool;
    var local_8: u32;
    var phi_2522_: bool;
    var phi_2523_: bool;
    var phi_2524_: bool;
    var phi_2525_: bool;
    var local_9: bool;
    var phi_2529_: bool;
    var phi_2533_: bool;
    var phi_2537_: bool;
    var phi_2538_: bool;
    var phi_2554_: bool;
    var phi_2555_: bool;
    var phi_2556_: bool;
    var phi_2557_: bool;
    var phi_2561_: bool;
    var phi_2574_: bool;
    var phi_2575_: bool;
    var phi_2576_: bool;
    var phi_2577_: bool;
    var phi_2581_: bool;
    var phi_2594_: bool;
    var phi_2595_: bool;
    var phi_2596_: bool;
    var phi_2600_: bool;
    var phi_2601_: bool;
    var phi_2602_: bool;
    var phi_2603_: bool;
    var phi_2604_: bool;
    var phi_2608_: bool;
    var phi_2678_: f32;
    var phi_2685_: f32;
    var phi_2692_: f32;
    var phi_2699_: f32;
    var phi_2706_: f32;
    var phi_2713_: f32;
    var phi_2730_: f32;
    var phi_2735_: f32;
    var phi_2740_: f32;
    var phi_2745_: f32;
    var phi_2750_: f32;
    var phi_2776_: bool;
    var phi_2777_: bool;
    var phi_2785_: u32;
    var phi_2786_: u32;
    var phi_2797_: vec3<f32>;
    var phi_2798_: vec3<f32>;
    var phi_2811_: u32;
    var phi_2816_: u32;
    var phi_2821_: u32;
    var phi_2935_: bool;
    var phi_2936_: bool;
    var phi_2967_: u32;
    var phi_2969_: u32;
    var phi_2972_: bool;
    var phi_3052_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_3079_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_3106_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_3112_: u32;
    var phi_3115_: u32;
    var phi_3129_: u32;
    var phi_3139_: u32;
    var phi_3149_: u32;
    var phi_3167_: u32;
    var phi_3177_: u32;
    var phi_3187_: u32;
    var phi_3223_: u32;
    var phi_3236_: u32;
    var phi_3241_: u32;
    var phi_3242_: u32;
    var phi_3243_: u32;
    var phi_3113_: u32;
    var phi_3116_: u32;
    var local_10: u32;
    var local_11: u32;
    var local_12: u32;
    var phi_3301_: u32;
    var phi_3304_: bool;
    var phi_3348_: vec3<f32>;
    var phi_3349_: vec3<f32>;
    var phi_3378_: vec3<f32>;
    var phi_3379_: vec3<f32>;
    var phi_3408_: vec3<f32>;
    var phi_3409_: vec3<f32>;
    var phi_3427_: bool;
    var phi_3428_: bool;
    var phi_3432_: f32;
    var phi_3433_: f32;
    var phi_3434_: f32;
    var phi_3435_: f32;
    var phi_3443_: f32;
    var phi_3453_: bool;
    var phi_3454_: bool;
    var phi_3458_: f32;
    var phi_3459_: f32;
    var phi_3460_: f32;
    var phi_3461_: f32;
    var phi_3469_: f32;
    var phi_3479_: bool;
    var phi_3480_: bool;
    var phi_3484_: f32;
    var phi_3485_: f32;
    var phi_3486_: f32;
    var phi_3487_: f32;
    var phi_3495_: f32;
    var phi_3510_: f32;
    var phi_3511_: bool;
    var phi_3512_: f32;
    var phi_3513_: bool;
    var phi_3514_: f32;
    var phi_3515_: bool;
    var phi_3533_: f32;
    var phi_3534_: bool;
    var phi_3535_: bool;
    var phi_3536_: f32;
    var phi_3537_: bool;
    var phi_3538_: bool;
    var phi_3542_: bool;
    var phi_3543_: f32;
    var phi_3544_: bool;
    var phi_3572_: vec3<f32>;
    var phi_3573_: vec3<f32>;
    var phi_3598_: vec3<f32>;
    var phi_3599_: vec3<f32>;
    var phi_3624_: vec3<f32>;
    var phi_3625_: vec3<f32>;
    var phi_3681_: f32;
    var phi_3690_: f32;
    var phi_3699_: f32;
    var phi_3708_: f32;
    var phi_3715_: f32;
    var phi_3722_: f32;
    var phi_3735_: f32;
    var phi_3744_: f32;
    var phi_3753_: f32;
    var phi_3762_: f32;
    var phi_3769_: f32;
    var phi_3776_: f32;
    var phi_3793_: f32;
    var phi_3798_: f32;
    var phi_3803_: f32;
    var phi_3811_: f32;
    var phi_3816_: f32;
    var phi_3821_: f32;
    var phi_3833_: f32;
    var phi_3838_: f32;
    var phi_3843_: f32;
    var phi_3848_: f32;
    var phi_3853_: lt_bvh_triangle_Intersection;
    var phi_3854_: bool;
    var phi_3855_: lt_bvh_triangle_Intersection;
    var phi_3856_: bool;
    var phi_3860_: lt_bvh_triangle_Intersection;
    var phi_3861_: bool;
    var phi_3862_: lt_bvh_triangle_Intersection;
    var phi_3863_: bool;
    var phi_3864_: bool;
    var phi_3868_: bool;
    var phi_3872_: lt_bvh_triangle_Intersection;
    var phi_4086_: f32;
    var phi_4089_: bool;
    var phi_4090_: bool;
    var phi_4091_: bool;
    var phi_4095_: bool;
    var phi_4096_: bool;
    var phi_4097_: bool;
    var phi_4098_: bool;
    var phi_4099_: bool;
    var phi_4100_: bool;
    var phi_4101_: bool;
    var phi_4102_: bool;
    var phi_4103_: bool;
    var phi_4104_: bool;
    var phi_3302_: u32;
    var phi_3305_: bool;
    var phi_4108_: bool;
    var phi_4109_: bool;
    var local_13: bool;
    var phi_4151_: bool;
    var phi_4152_: bool;
    var phi_4183_: u32;
    var phi_4184_: u32;
    var phi_2970_: u32;
    var phi_2973_: bool;
    var phi_4185_: bool;
    var phi_4186_: bool;
    var phi_4187_: bool;
    var local_14: bool;
    var phi_4191_: bool;
    var phi_4195_: bool;
    var phi_4196_: bool;
    var phi_4197_: bool;
    var phi_4198_: bool;
    var phi_4202_: bool;
    var phi_4203_: bool;
    var phi_4204_: bool;
    var phi_4208_: f32;
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
        let _e124 = space.member;
        if (_e123 < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e130 = samples.member[(0u + _e123)].position;
        let _e132 = samples.member[(0u + _e123)].normal;
        let _e134 = samples.member[(0u + _e123)].magnitude;
        let _e136 = ((8f / 8388608f) * _e134);
        let _e138 = (_e132.x * _e136);
        let _e140 = (_e132.y * _e136);
        let _e142 = (_e132.z * _e136);
        let _e144 = (_e130.x + _e138);
        let _e146 = (_e130.y + _e140);
        let _e148 = (_e130.z + _e142);
        let _e152 = p.member.light.place;
        if (_e152.w == 0f) {
            phi_714_ = 300000000000000000000000000000000000000f;
        } else {
            phi_714_ = 1f;
        }
        let _e156 = phi_714_;
        let _e164 = (_e152.x - (_e144 * _e152.w));
        let _e165 = (_e152.y - (_e146 * _e152.w));
        let _e166 = (_e152.z - (_e148 * _e152.w));
        let _e167 = vec3<f32>(_e164, _e165, _e166);
        let _e168 = abs(_e164);
        let _e169 = abs(_e165);
        let _e170 = abs(_e166);
        if (abs(_e144) < 1000000000000000f) {
            if (abs(_e146) < 1000000000000000f) {
                phi_747_ = (abs(_e148) < 1000000000000000f);
                phi_748_ = false;
            } else {
                phi_747_ = bool();
                phi_748_ = true;
            }
            let _e178 = phi_747_;
            let _e180 = phi_748_;
            phi_749_ = _e178;
            phi_750_ = _e180;
        } else {
            phi_749_ = bool();
            phi_750_ = true;
        }
        let _e182 = phi_749_;
        let _e184 = phi_750_;
        if _e184 {
            phi_754_ = false;
        } else {
            phi_754_ = _e182;
        }
        let _e186 = phi_754_;
        if _e186 {
            if (_e168 < 1000000000000000f) {
                if (_e169 < 1000000000000000f) {
                    phi_767_ = (_e170 < 1000000000000000f);
                    phi_768_ = false;
                } else {
                    phi_767_ = bool();
                    phi_768_ = true;
                }
                let _e191 = phi_767_;
                let _e193 = phi_768_;
                phi_769_ = _e191;
                phi_770_ = _e193;
            } else {
                phi_769_ = bool();
                phi_770_ = true;
            }
            let _e195 = phi_769_;
            let _e197 = phi_770_;
            if _e197 {
                phi_774_ = false;
            } else {
                phi_774_ = _e195;
            }
            let _e199 = phi_774_;
            if _e199 {
                if (_e168 > 0f) {
                    phi_788_ = bool();
                    phi_789_ = true;
                } else {
                    let _e201 = (_e169 > 0f);
                    if _e201 {
                        phi_787_ = bool();
                    } else {
                        phi_787_ = (_e170 > 0f);
                    }
                    let _e204 = phi_787_;
                    phi_788_ = _e204;
                    phi_789_ = _e201;
                }
                let _e206 = phi_788_;
                let _e208 = phi_789_;
                if _e208 {
                    phi_793_ = true;
                } else {
                    phi_793_ = _e206;
                }
                let _e210 = phi_793_;
                phi_794_ = _e210;
                phi_795_ = false;
            } else {
                phi_794_ = bool();
                phi_795_ = true;
            }
            let _e212 = phi_794_;
            let _e214 = phi_795_;
            phi_796_ = _e212;
            phi_797_ = _e214;
        } else {
            phi_796_ = bool();
            phi_797_ = true;
        }
        let _e216 = phi_796_;
        let _e218 = phi_797_;
        if _e218 {
            phi_801_ = false;
        } else {
            phi_801_ = _e216;
        }
        let _e220 = phi_801_;
        if _e220 {
            if (_e124.low.x <= _e144) {
                if (_e144 <= _e124.high.x) {
                    if (_e124.low.y <= _e146) {
                        phi_824_ = (_e146 <= _e124.high.y);
                        phi_825_ = false;
                    } else {
                        phi_824_ = bool();
                        phi_825_ = true;
                    }
                    let _e238 = phi_824_;
                    let _e240 = phi_825_;
                    phi_826_ = _e238;
                    phi_827_ = _e240;
                } else {
                    phi_826_ = bool();
                    phi_827_ = true;
                }
                let _e242 = phi_826_;
                let _e244 = phi_827_;
                phi_828_ = _e242;
                phi_829_ = _e244;
            } else {
                phi_828_ = bool();
                phi_829_ = true;
            }
            let _e246 = phi_828_;
            let _e248 = phi_829_;
            if _e248 {
                phi_833_ = false;
            } else {
                phi_833_ = _e246;
            }
            let _e250 = phi_833_;
            if (abs(_e164) > 0.000000000000000000000000000001f) {
                phi_847_ = bool();
                phi_848_ = true;
            } else {
                let _e255 = (abs(_e165) > 0.000000000000000000000000000001f);
                if _e255 {
                    phi_846_ = bool();
                } else {
                    phi_846_ = (abs(_e166) > 0.000000000000000000000000000001f);
                }
                let _e258 = phi_846_;
                phi_847_ = _e258;
                phi_848_ = _e255;
            }
            let _e260 = phi_847_;
            let _e262 = phi_848_;
            if _e262 {
                phi_852_ = true;
            } else {
                phi_852_ = _e260;
            }
            let _e264 = phi_852_;
            if _e250 {
                if (_e124.low.z <= _e148) {
                    if (_e148 <= _e124.high.z) {
                        if (_e124.is_parallel == 0u) {
                            phi_869_ = _e264;
                        } else {
                            phi_869_ = true;
                        }
                        let _e270 = phi_869_;
                        phi_870_ = _e270;
                        phi_871_ = false;
                    } else {
                        phi_870_ = bool();
                        phi_871_ = true;
                    }
                    let _e272 = phi_870_;
                    let _e274 = phi_871_;
                    phi_872_ = _e272;
                    phi_873_ = _e274;
                } else {
                    phi_872_ = bool();
                    phi_873_ = true;
                }
                let _e276 = phi_872_;
                let _e278 = phi_873_;
                phi_874_ = _e276;
                phi_875_ = _e278;
            } else {
                phi_874_ = bool();
                phi_875_ = true;
            }
            let _e280 = phi_874_;
            let _e282 = phi_875_;
            if _e282 {
                phi_879_ = false;
            } else {
                phi_879_ = _e280;
            }
            let _e284 = phi_879_;
            if _e284 {
                if (_e124.is_parallel == 0u) {
                    let _e287 = abs(_e164);
                    let _e288 = abs(_e165);
                    let _e289 = abs(_e166);
                    if (_e287 >= _e288) {
                        if (_e287 >= _e289) {
                            phi_899_ = false;
                        } else {
                            phi_899_ = true;
                        }
                        let _e293 = phi_899_;
                        phi_900_ = _e293;
                    } else {
                        phi_900_ = true;
                    }
                    let _e295 = phi_900_;
                    if _e295 {
                        if (_e288 >= _e289) {
                            phi_908_ = 1u;
                            phi_909_ = _e165;
                        } else {
                            phi_908_ = 2u;
                            phi_909_ = _e166;
                        }
                        let _e298 = phi_908_;
                        let _e300 = phi_909_;
                        phi_910_ = _e298;
                        phi_911_ = _e300;
                    } else {
                        phi_910_ = 0u;
                        phi_911_ = _e164;
                    }
                    let _e302 = phi_910_;
                    let _e304 = phi_911_;
                    if (_e304 < 0f) {
                        phi_916_ = -1f;
                    } else {
                        phi_916_ = 1f;
                    }
                    let _e307 = phi_916_;
                    let _e308 = (_e307 < 0f);
                    if (_e302 == 0u) {
                        if _e308 {
                            phi_927_ = _e124.roots.y;
                        } else {
                            phi_927_ = _e124.roots.x;
                        }
                        let _e315 = phi_927_;
                        phi_945_ = _e315;
                    } else {
                        if (_e302 == 1u) {
                            if _e308 {
                                phi_937_ = _e124.roots.w;
                            } else {
                                phi_937_ = _e124.roots.z;
                            }
                            let _e322 = phi_937_;
                            phi_944_ = _e322;
                        } else {
                            if _e308 {
                                phi_943_ = _e124.roots_z.y;
                            } else {
                                phi_943_ = _e124.roots_z.x;
                            }
                            let _e328 = phi_943_;
                            phi_944_ = _e328;
                        }
                        let _e330 = phi_944_;
                        phi_945_ = _e330;
                    }
                    let _e332 = phi_945_;
                    if (_e302 == 0u) {
                        phi_957_ = vec3<f32>(_e165, _e166, _e164);
                    } else {
                        if (_e302 == 1u) {
                            phi_956_ = vec3<f32>(_e166, _e164, _e165);
                        } else {
                            phi_956_ = _e167;
                        }
                        let _e338 = phi_956_;
                        phi_957_ = _e338;
                    }
                    let _e340 = phi_957_;
                    phi_1002_ = u0028_lt_bvh_LightPoint_u0020_u32_u0029_(lt_math_Evsm((_e340.x / _e340.z), (_e340.y / _e340.z), (_e307 / _e340.z)), _e332);
                } else {
                    if (_e124.axis == 0u) {
                        phi_980_ = vec3<f32>(_e146, _e148, _e144);
                    } else {
                        if (_e124.axis == 1u) {
                            phi_979_ = vec3<f32>(_e148, _e144, _e146);
                        } else {
                            phi_979_ = (_e130 + vec3<f32>(_e138, _e140, _e142));
                        }
                        let _e357 = phi_979_;
                        phi_980_ = _e357;
                    }
                    let _e359 = phi_980_;
                    let _e374 = (_e359.z - _e124.middle.z);
                    phi_1002_ = u0028_lt_bvh_LightPoint_u0020_u32_u0029_(lt_math_Evsm(((_e359.x - _e124.middle.x) - (_e124.shear.x * _e374)), ((_e359.y - _e124.middle.y) - (_e124.shear.y * _e374)), (_e124.sign * _e374)), _e124.roots.x);
                }
                let _e385 = phi_1002_;
                if (_e385.unnamed_1 == 4294967295u) {
                    phi_2538_ = false;
                } else {
                    if (0u < _e88) {
                    } else {
                        return;
                    }
                    let _e402 = nodes.member[0u].frame[0u];
                    let _e406 = nodes.member[0u].frame[1u];
                    let _e410 = nodes.member[0u].frame[2u];
                    let _e414 = nodes.member[0u].frame[0u];
                    let _e418 = nodes.member[0u].frame[1u];
                    let _e422 = nodes.member[0u].frame[2u];
                    let _e426 = nodes.member[0u].frame[3u];
                    let _e460 = core_intrinsics_maximum_number_nsz_f32_(abs(_e164), abs(_e165));
                    let _e461 = core_intrinsics_maximum_number_nsz_f32_(_e460, abs(_e166));
                    let _e462 = (_e461 * 0.0000000000009094947f);
                    if (abs(_e164) < _e462) {
                        phi_1077_ = _e462;
                    } else {
                        phi_1077_ = abs(_e164);
                    }
                    let _e467 = phi_1077_;
                    if (_e164 < 0f) {
                        phi_1084_ = (-1f / _e467);
                    } else {
                        phi_1084_ = (1f / _e467);
                    }
                    let _e472 = phi_1084_;
                    if (abs(_e165) < _e462) {
                        phi_1091_ = _e462;
                    } else {
                        phi_1091_ = abs(_e165);
                    }
                    let _e477 = phi_1091_;
                    if (_e165 < 0f) {
                        phi_1098_ = (-1f / _e477);
                    } else {
                        phi_1098_ = (1f / _e477);
                    }
                    let _e482 = phi_1098_;
                    if (abs(_e166) < _e462) {
                        phi_1105_ = _e462;
                    } else {
                        phi_1105_ = abs(_e166);
                    }
                    let _e487 = phi_1105_;
                    if (_e166 < 0f) {
                        phi_1112_ = (-1f / _e487);
                    } else {
                        phi_1112_ = (1f / _e487);
                    }
                    let _e492 = phi_1112_;
                    let _e496 = abs((bitcast<f32>(_e402) - _e144));
                    let _e497 = abs((bitcast<f32>(_e406) - _e146));
                    let _e498 = abs((bitcast<f32>(_e410) - _e148));
                    let _e502 = abs(((bitcast<f32>(_e414) + (bitcast<f32>((((_e426 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e144));
                    let _e503 = abs(((bitcast<f32>(_e418) + (bitcast<f32>((((_e426 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e146));
                    let _e504 = abs(((bitcast<f32>(_e422) + (bitcast<f32>((((_e426 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e148));
                    if (_e496 > _e502) {
                        phi_1129_ = _e496;
                    } else {
                        phi_1129_ = _e502;
                    }
                    let _e507 = phi_1129_;
                    if (_e497 > _e503) {
                        phi_1134_ = _e497;
                    } else {
                        phi_1134_ = _e503;
                    }
                    let _e510 = phi_1134_;
                    if (_e498 > _e504) {
                        phi_1139_ = _e498;
                    } else {
                        phi_1139_ = _e504;
                    }
                    let _e513 = phi_1139_;
                    if (_e507 > _e510) {
                        phi_1144_ = _e507;
                    } else {
                        phi_1144_ = _e510;
                    }
                    let _e516 = phi_1144_;
                    if (_e516 > _e513) {
                        phi_1149_ = _e516;
                    } else {
                        phi_1149_ = _e513;
                    }
                    let _e519 = phi_1149_;
                    let _e526 = (_e519 * 0.0000009536743f);
                    let _e527 = (abs(_e472) * _e526);
                    let _e528 = (abs(_e482) * _e526);
                    let _e529 = (abs(_e492) * _e526);
                    let _e530 = abs(_e164);
                    let _e531 = abs(_e165);
                    let _e532 = abs(_e166);
                    if (_e530 >= _e531) {
                        if (_e530 >= _e532) {
                            phi_1171_ = false;
                        } else {
                            phi_1171_ = true;
                        }
                        let _e536 = phi_1171_;
                        phi_1172_ = _e536;
                    } else {
                        phi_1172_ = true;
                    }
                    let _e538 = phi_1172_;
                    if _e538 {
                        if (_e531 >= _e532) {
                            phi_1180_ = 1u;
                        } else {
                            phi_1180_ = 2u;
                        }
                        let _e541 = phi_1180_;
                        phi_1181_ = _e541;
                    } else {
                        phi_1181_ = 0u;
                    }
                    let _e543 = phi_1181_;
                    if (_e543 == 0u) {
                        phi_1193_ = vec3<f32>(_e165, _e166, _e164);
                    } else {
                        if (_e543 == 1u) {
                            phi_1192_ = vec3<f32>(_e166, _e164, _e165);
                        } else {
                            phi_1192_ = _e167;
                        }
                        let _e549 = phi_1192_;
                        phi_1193_ = _e549;
                    }
                    let _e551 = phi_1193_;
                    let _e554 = (_e551.x / _e551.z);
                    let _e557 = (_e551.y / _e551.z);
                    local_3 = array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    phi_1205_ = ((_e385.unnamed_1 << bitcast<u32>(8i)) | 1u);
                    phi_1208_ = 0u;
                    loop {
                        let _e564 = phi_1205_;
                        let _e566 = phi_1208_;
                        phi_1213_ = _e564;
                        phi_1215_ = 0u;
                        phi_1217_ = 0u;
                        phi_1219_ = _e566;
                        loop {
                            let _e568 = phi_1213_;
                            let _e570 = phi_1215_;
                            let _e572 = phi_1217_;
                            let _e574 = phi_1219_;
                            let _e581 = (((_e568 >> bitcast<u32>(8i)) + select(firstTrailingBit(_e568), 32u, (_e568 == 0u))) * 5u);
                            if (_e581 < _e100) {
                            } else {
                                return;
                            }
                            let _e585 = rows.member[(0u + _e581)];
                            let _e586 = (_e581 + 1u);
                            if (_e586 < _e100) {
                            } else {
                                return;
                            }
                            let _e590 = rows.member[(0u + _e586)];
                            let _e591 = (_e581 + 2u);
                            if (_e591 < _e100) {
                            } else {
                                return;
                            }
                            let _e595 = rows.member[(0u + _e591)];
                            let _e596 = (_e581 + 3u);
                            if (_e596 < _e100) {
                            } else {
                                return;
                            }
                            let _e600 = rows.member[(0u + _e596)];
                            let _e601 = (_e581 + 4u);
                            if (_e601 < _e100) {
                            } else {
                                return;
                            }
                            let _e605 = rows.member[(0u + _e601)];
                            let _e606 = lt_bvh_Node(_e585, _e590, _e595, _e600, _e605);
                            let _e608 = (_e568 & (_e568 - 1u));
                            let _e620 = (_e385.unnamed.positive_exponent - bitcast<f32>(_e606.frame.x));
                            let _e623 = bitcast<f32>((((_e606.z.z >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                            if (_e620 > 0f) {
                                if (_e620 < (255f * _e623)) {
                                    phi_1291_ = (_e620 / _e623);
                                } else {
                                    phi_1291_ = 255f;
                                }
                                let _e629 = phi_1291_;
                                phi_1292_ = _e629;
                            } else {
                                phi_1292_ = 0f;
                            }
                            let _e631 = phi_1292_;
                            let _e638 = select(select(u32(_e631), 0u, (_e631 < bitcast<f32>(0u))), 4294967295u, (_e631 > bitcast<f32>(1333788671u)));
                            if (f32(_e638) < _e631) {
                                phi_1306_ = (_e638 + 1u);
                            } else {
                                phi_1306_ = _e638;
                            }
                            let _e643 = phi_1306_;
                            let _e644 = (_e638 * 16843009u);
                            let _e645 = (_e643 * 16843009u);
                            let _e655 = (_e385.unnamed.negative_exponent - bitcast<f32>(_e606.frame.y));
                            let _e658 = bitcast<f32>((((_e606.z.z >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                            if (_e655 > 0f) {
                                if (_e655 < (255f * _e658)) {
                                    phi_1329_ = (_e655 / _e658);
                                } else {
                                    phi_1329_ = 255f;
                                }
                                let _e664 = phi_1329_;
                                phi_1330_ = _e664;
                            } else {
                                phi_1330_ = 0f;
                            }
                            let _e666 = phi_1330_;
                            let _e673 = select(select(u32(_e666), 0u, (_e666 < bitcast<f32>(0u))), 4294967295u, (_e666 > bitcast<f32>(1333788671u)));
                            if (f32(_e673) < _e666) {
                                phi_1344_ = (_e673 + 1u);
                            } else {
                                phi_1344_ = _e673;
                            }
                            let _e678 = phi_1344_;
                            let _e679 = (_e673 * 16843009u);
                            let _e680 = (_e678 * 16843009u);
                            let _e689 = (((_e124.diagonal.x * _e385.unnamed.positive_exponent) + (_e124.diagonal.y * _e385.unnamed.negative_exponent)) - bitcast<f32>(_e606.frame.z));
                            let _e692 = bitcast<f32>((((_e606.z.z >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                            if (_e689 > 0f) {
                                if (_e689 < (255f * _e692)) {
                                    phi_1366_ = (_e689 / _e692);
                                } else {
                                    phi_1366_ = 255f;
                                }
                                let _e698 = phi_1366_;
                                phi_1367_ = _e698;
                            } else {
                                phi_1367_ = 0f;
                            }
                            let _e700 = phi_1367_;
                            let _e707 = select(select(u32(_e700), 0u, (_e700 < bitcast<f32>(0u))), 4294967295u, (_e700 > bitcast<f32>(1333788671u)));
                            if (f32(_e707) < _e700) {
                                phi_1381_ = (_e707 + 1u);
                            } else {
                                phi_1381_ = _e707;
                            }
                            let _e712 = phi_1381_;
                            let _e713 = (_e707 * 16843009u);
                            let _e714 = (_e712 * 16843009u);
                            let _e724 = (_e385.unnamed.min_variance - bitcast<f32>(_e606.frame.w));
                            let _e727 = bitcast<f32>((((_e606.z.z >> bitcast<u32>(((3u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                            if (_e724 > 0f) {
                                if (_e724 < (255f * _e727)) {
                                    phi_1404_ = (_e724 / _e727);
                                } else {
                                    phi_1404_ = 255f;
                                }
                                let _e733 = phi_1404_;
                                phi_1405_ = _e733;
                            } else {
                                phi_1405_ = 0f;
                            }
                            let _e735 = phi_1405_;
                            let _e742 = select(select(u32(_e735), 0u, (_e735 < bitcast<f32>(0u))), 4294967295u, (_e735 > bitcast<f32>(1333788671u)));
                            if (f32(_e742) < _e735) {
                                phi_1419_ = (_e742 + 1u);
                            } else {
                                phi_1419_ = _e742;
                            }
                            let _e747 = phi_1419_;
                            let _e748 = (_e747 * 16843009u);
                            let _e929 = (((((((((((_e644 & ~(_e606.links.x)) | (~((_e606.links.x ^ _e644)) & ((_e644 | 2155905152u) - (_e606.links.x & 2139062143u)))) & ((_e606.links.z & ~(_e645)) | (~((_e645 ^ _e606.links.z)) & ((_e606.links.z | 2155905152u) - (_e645 & 2139062143u))))) & (((_e679 & ~(_e606.x.x)) | (~((_e606.x.x ^ _e679)) & ((_e679 | 2155905152u) - (_e606.x.x & 2139062143u)))) & ((_e606.x.z & ~(_e680)) | (~((_e680 ^ _e606.x.z)) & ((_e606.x.z | 2155905152u) - (_e680 & 2139062143u)))))) & (((_e713 & ~(_e606.y.x)) | (~((_e606.y.x ^ _e713)) & ((_e713 | 2155905152u) - (_e606.y.x & 2139062143u)))) & ((_e606.y.z & ~(_e714)) | (~((_e714 ^ _e606.y.z)) & ((_e606.y.z | 2155905152u) - (_e714 & 2139062143u)))))) & ((_e606.z.x & ~(_e748)) | (~((_e748 ^ _e606.z.x)) & ((_e606.z.x | 2155905152u) - (_e748 & 2139062143u))))) & 2155905152u) >> bitcast<u32>(7i)) * 16909320u) >> bitcast<u32>(24i)) | (((((((((((_e644 & ~(_e606.links.y)) | (~((_e606.links.y ^ _e644)) & ((_e644 | 2155905152u) - (_e606.links.y & 2139062143u)))) & ((_e606.links.w & ~(_e645)) | (~((_e645 ^ _e606.links.w)) & ((_e606.links.w | 2155905152u) - (_e645 & 2139062143u))))) & (((_e679 & ~(_e606.x.y)) | (~((_e606.x.y ^ _e679)) & ((_e679 | 2155905152u) - (_e606.x.y & 2139062143u)))) & ((_e606.x.w & ~(_e680)) | (~((_e680 ^ _e606.x.w)) & ((_e606.x.w | 2155905152u) - (_e680 & 2139062143u)))))) & (((_e713 & ~(_e606.y.y)) | (~((_e606.y.y ^ _e713)) & ((_e713 | 2155905152u) - (_e606.y.y & 2139062143u)))) & ((_e606.y.w & ~(_e714)) | (~((_e714 ^ _e606.y.w)) & ((_e606.y.w | 2155905152u) - (_e714 & 2139062143u)))))) & ((_e606.z.y & ~(_e748)) | (~((_e748 ^ _e606.z.y)) & ((_e606.z.y | 2155905152u) - (_e748 & 2139062143u))))) & 2155905152u) >> bitcast<u32>(7i)) * 16909320u) >> bitcast<u32>(24i)) << bitcast<u32>(4i)));
                            if ((_e606.z.w & 2147483648u) != 0u) {
                                phi_1619_ = _e608;
                                phi_1216_ = (_e606.z.w & 2147483647u);
                                phi_1218_ = _e929;
                                phi_1620_ = _e574;
                            } else {
                                if (_e929 == 0u) {
                                    phi_1617_ = _e608;
                                    phi_1618_ = _e574;
                                } else {
                                    if ((_e608 & 255u) == 0u) {
                                        phi_1612_ = _e574;
                                    } else {
                                        if (_e574 < 32u) {
                                            if (_e574 < 32u) {
                                            } else {
                                                return;
                                            }
                                            local_3[(0u + _e574)] = _e608;
                                            phi_1611_ = (_e574 + 1u);
                                        } else {
                                            phi_1611_ = _e574;
                                        }
                                        let _e946 = phi_1611_;
                                        phi_1612_ = _e946;
                                    }
                                    let _e948 = phi_1612_;
                                    phi_1617_ = (((_e606.z.w & 2147483647u) << bitcast<u32>(8i)) | _e929);
                                    phi_1618_ = _e948;
                                }
                                let _e956 = phi_1617_;
                                let _e958 = phi_1618_;
                                phi_1619_ = _e956;
                                phi_1216_ = _e570;
                                phi_1218_ = _e572;
                                phi_1620_ = _e958;
                            }
                            let _e960 = phi_1619_;
                            let _e962 = phi_1216_;
                            let _e964 = phi_1218_;
                            let _e966 = phi_1620_;
                            local_5 = _e964;
                            local_17 = _e964;
                            local_6 = _e962;
                            if ((_e960 & 255u) == 0u) {
                                if (_e966 > 0u) {
                                    let _e970 = (_e966 - 1u);
                                    if (_e970 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e974 = local_3[(0u + _e970)];
                                    phi_1638_ = _e974;
                                    phi_1639_ = _e970;
                                } else {
                                    phi_1638_ = 0u;
                                    phi_1639_ = _e966;
                                }
                                let _e976 = phi_1638_;
                                let _e978 = phi_1639_;
                                phi_1206_ = _e976;
                                phi_1209_ = _e978;
                            } else {
                                phi_1206_ = _e960;
                                phi_1209_ = _e966;
                            }
                            let _e980 = phi_1206_;
                            let _e982 = phi_1209_;
                            local_15 = _e980;
                            local_16 = _e982;
                            local_8 = _e980;
                            if (_e964 == 0u) {
                                let _e984 = (_e980 == 0u);
                                if _e984 {
                                    phi_1648_ = false;
                                } else {
                                    phi_1648_ = true;
                                }
                                let _e986 = phi_1648_;
                                phi_1649_ = _e986;
                                phi_1650_ = _e984;
                            } else {
                                phi_1649_ = false;
                                phi_1650_ = false;
                            }
                            let _e988 = phi_1649_;
                            let _e990 = phi_1650_;
                            local_4 = _e990;
                            continue;
                            continuing {
                                phi_1213_ = _e980;
                                phi_1215_ = _e962;
                                phi_1217_ = _e964;
                                phi_1219_ = _e982;
                                break if !(_e988);
                            }
                        }
                        let _e993 = local_4;
                        if _e993 {
                        }
                        let _e995 = local_5;
                        if (_e995 == 0u) {
                            phi_2512_ = true;
                            phi_2513_ = false;
                            phi_2514_ = false;
                        } else {
                            let _e3465 = local_17;
                            phi_1659_ = _e3465;
                            loop {
                                let _e998 = phi_1659_;
                                let _e1001 = select(firstTrailingBit(_e998), 32u, (_e998 == 0u));
                                let _e1005 = local_6;
                                let _e1006 = (_e1005 + (_e1001 >> bitcast<u32>(2i)));
                                if (_e1006 < _e100) {
                                } else {
                                    return;
                                }
                                let _e1011 = rows.member[(0u + _e1006)][0u];
                                let _e1015 = rows.member[(0u + _e1006)][1u];
                                let _e1019 = rows.member[(0u + _e1006)][2u];
                                let _e1023 = rows.member[(0u + _e1006)][3u];
                                if ((_e1001 & 2u) == 0u) {
                                    phi_1694_ = _e1015;
                                    phi_1695_ = _e1011;
                                } else {
                                    phi_1694_ = _e1023;
                                    phi_1695_ = _e1019;
                                }
                                let _e1027 = phi_1694_;
                                let _e1029 = phi_1695_;
                                if ((_e1001 & 1u) == 0u) {
                                    phi_1701_ = _e1029;
                                } else {
                                    phi_1701_ = _e1027;
                                }
                                let _e1033 = phi_1701_;
                                let _e1035 = (_e998 & (_e998 - 1u));
                                if (_e1033 < _e91) {
                                } else {
                                    return;
                                }
                                let _e1040 = triangles.member[(0u + _e1033)].v0_;
                                let _e1042 = (_e1040.x - _e144);
                                let _e1044 = (_e1040.y - _e146);
                                let _e1046 = (_e1040.z - _e148);
                                if (_e543 == 0u) {
                                    phi_1730_ = vec3<f32>(_e1044, _e1046, _e1042);
                                } else {
                                    if (_e543 == 1u) {
                                        phi_1729_ = vec3<f32>(_e1046, _e1042, _e1044);
                                    } else {
                                        phi_1729_ = (_e1040 - vec3<f32>(_e144, _e146, _e148));
                                    }
                                    let _e1054 = phi_1729_;
                                    phi_1730_ = _e1054;
                                }
                                let _e1056 = phi_1730_;
                                let _e1060 = (_e1056.x - (_e554 * _e1056.z));
                                let _e1064 = (_e1056.y - (_e557 * _e1056.z));
                                let _e1066 = triangles.member[(0u + _e1033)].v1_;
                                let _e1068 = (_e1066.x - _e144);
                                let _e1070 = (_e1066.y - _e146);
                                let _e1072 = (_e1066.z - _e148);
                                if (_e543 == 0u) {
                                    phi_1760_ = vec3<f32>(_e1070, _e1072, _e1068);
                                } else {
                                    if (_e543 == 1u) {
                                        phi_1759_ = vec3<f32>(_e1072, _e1068, _e1070);
                                    } else {
                                        phi_1759_ = (_e1066 - vec3<f32>(_e144, _e146, _e148));
                                    }
                                    let _e1080 = phi_1759_;
                                    phi_1760_ = _e1080;
                                }
                                let _e1082 = phi_1760_;
                                let _e1086 = (_e1082.x - (_e554 * _e1082.z));
                                let _e1090 = (_e1082.y - (_e557 * _e1082.z));
                                let _e1092 = triangles.member[(0u + _e1033)].v2_;
                                let _e1094 = (_e1092.x - _e144);
                                let _e1096 = (_e1092.y - _e146);
                                let _e1098 = (_e1092.z - _e148);
                                if (_e543 == 0u) {
                                    phi_1790_ = vec3<f32>(_e1096, _e1098, _e1094);
                                } else {
                                    if (_e543 == 1u) {
                                        phi_1789_ = vec3<f32>(_e1098, _e1094, _e1096);
                                    } else {
                                        phi_1789_ = (_e1092 - vec3<f32>(_e144, _e146, _e148));
                                    }
                                    let _e1106 = phi_1789_;
                                    phi_1790_ = _e1106;
                                }
                                let _e1108 = phi_1790_;
                                let _e1112 = (_e1108.x - (_e554 * _e1108.z));
                                let _e1116 = (_e1108.y - (_e557 * _e1108.z));
                                if (_e1086 < _e1112) {
                                    phi_1809_ = true;
                                } else {
                                    if (_e1086 == _e1112) {
                                        phi_1808_ = (_e1090 < _e1116);
                                    } else {
                                        phi_1808_ = false;
                                    }
                                    let _e1121 = phi_1808_;
                                    phi_1809_ = _e1121;
                                }
                                let _e1123 = phi_1809_;
                                if _e1123 {
                                    phi_1813_ = _e1116;
                                    phi_1814_ = _e1112;
                                    phi_1815_ = _e1090;
                                    phi_1816_ = _e1086;
                                } else {
                                    phi_1813_ = _e1090;
                                    phi_1814_ = _e1086;
                                    phi_1815_ = _e1116;
                                    phi_1816_ = _e1112;
                                }
                                let _e1125 = phi_1813_;
                                let _e1127 = phi_1814_;
                                let _e1129 = phi_1815_;
                                let _e1131 = phi_1816_;
                                let _e1134 = ((_e1131 * _e1125) - (_e1129 * _e1127));
                                if _e1123 {
                                    phi_1824_ = -(_e1134);
                                } else {
                                    phi_1824_ = _e1134;
                                }
                                let _e1137 = phi_1824_;
                                if (_e1112 < _e1060) {
                                    phi_1835_ = true;
                                } else {
                                    if (_e1112 == _e1060) {
                                        phi_1834_ = (_e1116 < _e1064);
                                    } else {
                                        phi_1834_ = false;
                                    }
                                    let _e1142 = phi_1834_;
                                    phi_1835_ = _e1142;
                                }
                                let _e1144 = phi_1835_;
                                if _e1144 {
                                    phi_1839_ = _e1064;
                                    phi_1840_ = _e1060;
                                    phi_1841_ = _e1116;
                                    phi_1842_ = _e1112;
                                } else {
                                    phi_1839_ = _e1116;
                                    phi_1840_ = _e1112;
                                    phi_1841_ = _e1064;
                                    phi_1842_ = _e1060;
                                }
                                let _e1146 = phi_1839_;
                                let _e1148 = phi_1840_;
                                let _e1150 = phi_1841_;
                                let _e1152 = phi_1842_;
                                let _e1155 = ((_e1152 * _e1146) - (_e1150 * _e1148));
                                if _e1144 {
                                    phi_1850_ = -(_e1155);
                                } else {
                                    phi_1850_ = _e1155;
                                }
                                let _e1158 = phi_1850_;
                                if (_e1060 < _e1086) {
                                    phi_1861_ = true;
                                } else {
                                    if (_e1060 == _e1086) {
                                        phi_1860_ = (_e1064 < _e1090);
                                    } else {
                                        phi_1860_ = false;
                                    }
                                    let _e1163 = phi_1860_;
                                    phi_1861_ = _e1163;
                                }
                                let _e1165 = phi_1861_;
                                if _e1165 {
                                    phi_1865_ = _e1090;
                                    phi_1866_ = _e1086;
                                    phi_1867_ = _e1064;
                                    phi_1868_ = _e1060;
                                } else {
                                    phi_1865_ = _e1064;
                                    phi_1866_ = _e1060;
                                    phi_1867_ = _e1090;
                                    phi_1868_ = _e1086;
                                }
                                let _e1167 = phi_1865_;
                                let _e1169 = phi_1866_;
                                let _e1171 = phi_1867_;
                                let _e1173 = phi_1868_;
                                let _e1176 = ((_e1173 * _e1167) - (_e1171 * _e1169));
                                if _e1165 {
                                    phi_1876_ = -(_e1176);
                                } else {
                                    phi_1876_ = _e1176;
                                }
                                let _e1179 = phi_1876_;
                                if (_e1137 >= 0f) {
                                    if (_e1158 >= 0f) {
                                        if (_e1179 >= 0f) {
                                            phi_1891_ = ((_e1137 + _e1158) + _e1179);
                                            phi_1892_ = false;
                                        } else {
                                            phi_1891_ = f32();
                                            phi_1892_ = true;
                                        }
                                        let _e1186 = phi_1891_;
                                        let _e1188 = phi_1892_;
                                        phi_1893_ = _e1186;
                                        phi_1894_ = _e1188;
                                    } else {
                                        phi_1893_ = f32();
                                        phi_1894_ = true;
                                    }
                                    let _e1190 = phi_1893_;
                                    let _e1192 = phi_1894_;
                                    phi_1895_ = _e1190;
                                    phi_1896_ = _e1192;
                                } else {
                                    phi_1895_ = f32();
                                    phi_1896_ = true;
                                }
                                let _e1194 = phi_1895_;
                                let _e1196 = phi_1896_;
                                if _e1196 {
                                    if (_e1137 <= 0f) {
                                        if (_e1158 <= 0f) {
                                            let _e1199 = (_e1179 <= 0f);
                                            if _e1199 {
                                            }
                                            phi_1914_ = ((_e1137 + _e1158) + _e1179);
                                            phi_1915_ = false;
                                            phi_1916_ = _e1199;
                                        } else {
                                            phi_1914_ = f32();
                                            phi_1915_ = true;
                                            phi_1916_ = false;
                                        }
                                        let _e1203 = phi_1914_;
                                        let _e1205 = phi_1915_;
                                        let _e1207 = phi_1916_;
                                        phi_1917_ = _e1203;
                                        phi_1918_ = _e1205;
                                        phi_1919_ = _e1207;
                                    } else {
                                        phi_1917_ = f32();
                                        phi_1918_ = true;
                                        phi_1919_ = false;
                                    }
                                    let _e1209 = phi_1917_;
                                    let _e1211 = phi_1918_;
                                    let _e1213 = phi_1919_;
                                    if _e1211 {
                                        phi_1923_ = false;
                                    } else {
                                        phi_1923_ = _e1213;
                                    }
                                    let _e1215 = phi_1923_;
                                    phi_1924_ = _e1209;
                                    phi_1925_ = _e1215;
                                } else {
                                    phi_1924_ = _e1194;
                                    phi_1925_ = true;
                                }
                                let _e1217 = phi_1924_;
                                let _e1219 = phi_1925_;
                                if _e1219 {
                                    let _e1220 = (_e1217 == 0f);
                                    if _e1220 {
                                        phi_2241_ = lt_bvh_triangle_Intersection();
                                        phi_2242_ = false;
                                    } else {
                                        let _e1222 = triangles.member[(0u + _e1033)].v0_;
                                        let _e1224 = (_e1222.x - _e144);
                                        let _e1226 = (_e1222.y - _e146);
                                        let _e1228 = (_e1222.z - _e148);
                                        if (_e543 == 0u) {
                                            phi_1954_ = vec3<f32>(_e1226, _e1228, _e1224);
                                        } else {
                                            if (_e543 == 1u) {
                                                phi_1953_ = vec3<f32>(_e1228, _e1224, _e1226);
                                            } else {
                                                phi_1953_ = (_e1222 - vec3<f32>(_e144, _e146, _e148));
                                            }
                                            let _e1236 = phi_1953_;
                                            phi_1954_ = _e1236;
                                        }
                                        let _e1238 = phi_1954_;
                                        let _e1240 = triangles.member[(0u + _e1033)].v1_;
                                        let _e1242 = triangles.member[(0u + _e1033)].v0_;
                                        let _e1245 = (_e1240.x - _e1242.x);
                                        let _e1248 = (_e1240.y - _e1242.y);
                                        let _e1251 = (_e1240.z - _e1242.z);
                                        if (_e543 == 0u) {
                                            phi_1980_ = vec3<f32>(_e1248, _e1251, _e1245);
                                        } else {
                                            if (_e543 == 1u) {
                                                phi_1979_ = vec3<f32>(_e1251, _e1245, _e1248);
                                            } else {
                                                phi_1979_ = (_e1240 - _e1242);
                                            }
                                            let _e1258 = phi_1979_;
                                            phi_1980_ = _e1258;
                                        }
                                        let _e1260 = phi_1980_;
                                        let _e1262 = triangles.member[(0u + _e1033)].v2_;
                                        let _e1264 = triangles.member[(0u + _e1033)].v0_;
                                        let _e1267 = (_e1262.x - _e1264.x);
                                        let _e1270 = (_e1262.y - _e1264.y);
                                        let _e1273 = (_e1262.z - _e1264.z);
                                        if (_e543 == 0u) {
                                            phi_2006_ = vec3<f32>(_e1270, _e1273, _e1267);
                                        } else {
                                            if (_e543 == 1u) {
                                                phi_2005_ = vec3<f32>(_e1273, _e1267, _e1270);
                                            } else {
                                                phi_2005_ = (_e1262 - _e1264);
                                            }
                                            let _e1280 = phi_2005_;
                                            phi_2006_ = _e1280;
                                        }
                                        let _e1282 = phi_2006_;
                                        let _e1289 = ((_e1260.y * _e1282.z) - (_e1260.z * _e1282.y));
                                        let _e1296 = ((_e1260.z * _e1282.x) - (_e1260.x * _e1282.z));
                                        let _e1303 = ((_e1260.x * _e1282.y) - (_e1260.y * _e1282.x));
                                        let _e1317 = (((1f / _e551.z) * (((_e1289 * _e1238.x) + (_e1296 * _e1238.y)) + (_e1303 * _e1238.z))) / (((_e1289 * _e554) + (_e1296 * _e557)) + _e1303));
                                        if (_e1317 > 0f) {
                                            if (_e1317 < _e156) {
                                                let _e1321 = triangles.member[(0u + _e1033)].v0_;
                                                let _e1323 = triangles.member[(0u + _e1033)].v1_;
                                                if (_e1321.x < _e1323.x) {
                                                    phi_2062_ = _e1321.x;
                                                } else {
                                                    phi_2062_ = _e1323.x;
                                                }
                                                let _e1330 = phi_2062_;
                                                if (_e1321.y < _e1323.y) {
                                                    phi_2071_ = _e1321.y;
                                                } else {
                                                    phi_2071_ = _e1323.y;
                                                }
                                                let _e1337 = phi_2071_;
                                                if (_e1321.z < _e1323.z) {
                                                    phi_2080_ = _e1321.z;
                                                } else {
                                                    phi_2080_ = _e1323.z;
                                                }
                                                let _e1344 = phi_2080_;
                                                let _e1346 = triangles.member[(0u + _e1033)].v2_;
                                                if (_e1330 < _e1346.x) {
                                                    phi_2089_ = _e1330;
                                                } else {
                                                    phi_2089_ = _e1346.x;
                                                }
                                                let _e1351 = phi_2089_;
                                                if (_e1337 < _e1346.y) {
                                                    phi_2096_ = _e1337;
                                                } else {
                                                    phi_2096_ = _e1346.y;
                                                }
                                                let _e1356 = phi_2096_;
                                                if (_e1344 < _e1346.z) {
                                                    phi_2103_ = _e1344;
                                                } else {
                                                    phi_2103_ = _e1346.z;
                                                }
                                                let _e1361 = phi_2103_;
                                                let _e1363 = triangles.member[(0u + _e1033)].v0_;
                                                let _e1365 = triangles.member[(0u + _e1033)].v1_;
                                                if (_e1363.x > _e1365.x) {
                                                    phi_2116_ = _e1363.x;
                                                } else {
                                                    phi_2116_ = _e1365.x;
                                                }
                                                let _e1372 = phi_2116_;
                                                if (_e1363.y > _e1365.y) {
                                                    phi_2125_ = _e1363.y;
                                                } else {
                                                    phi_2125_ = _e1365.y;
                                                }
                                                let _e1379 = phi_2125_;
                                                if (_e1363.z > _e1365.z) {
                                                    phi_2134_ = _e1363.z;
                                                } else {
                                                    phi_2134_ = _e1365.z;
                                                }
                                                let _e1386 = phi_2134_;
                                                let _e1388 = triangles.member[(0u + _e1033)].v2_;
                                                if (_e1372 > _e1388.x) {
                                                    phi_2143_ = _e1372;
                                                } else {
                                                    phi_2143_ = _e1388.x;
                                                }
                                                let _e1393 = phi_2143_;
                                                if (_e1379 > _e1388.y) {
                                                    phi_2150_ = _e1379;
                                                } else {
                                                    phi_2150_ = _e1388.y;
                                                }
                                                let _e1398 = phi_2150_;
                                                if (_e1386 > _e1388.z) {
                                                    phi_2157_ = _e1386;
                                                } else {
                                                    phi_2157_ = _e1388.z;
                                                }
                                                let _e1403 = phi_2157_;
                                                let _e1407 = ((_e1351 - _e144) * _e472);
                                                let _e1408 = ((_e1356 - _e146) * _e482);
                                                let _e1409 = ((_e1361 - _e148) * _e492);
                                                let _e1413 = ((_e1393 - _e144) * _e472);
                                                let _e1414 = ((_e1398 - _e146) * _e482);
                                                let _e1415 = ((_e1403 - _e148) * _e492);
                                                if (_e1407 < _e1413) {
                                                    phi_2174_ = _e1407;
                                                } else {
                                                    phi_2174_ = _e1413;
                                                }
                                                let _e1418 = phi_2174_;
                                                if (_e1408 < _e1414) {
                                                    phi_2179_ = _e1408;
                                                } else {
                                                    phi_2179_ = _e1414;
                                                }
                                                let _e1421 = phi_2179_;
                                                if (_e1409 < _e1415) {
                                                    phi_2184_ = _e1409;
                                                } else {
                                                    phi_2184_ = _e1415;
                                                }
                                                let _e1424 = phi_2184_;
                                                if (_e1407 > _e1413) {
                                                    phi_2192_ = _e1407;
                                                } else {
                                                    phi_2192_ = _e1413;
                                                }
                                                let _e1430 = phi_2192_;
                                                if (_e1408 > _e1414) {
                                                    phi_2197_ = _e1408;
                                                } else {
                                                    phi_2197_ = _e1414;
                                                }
                                                let _e1433 = phi_2197_;
                                                if (_e1409 > _e1415) {
                                                    phi_2202_ = _e1409;
                                                } else {
                                                    phi_2202_ = _e1415;
                                                }
                                                let _e1436 = phi_2202_;
                                                let _e1440 = core_intrinsics_maximum_number_nsz_f32_((_e1418 - _e527), (_e1421 - _e528));
                                                let _e1441 = core_intrinsics_maximum_number_nsz_f32_(_e1440, (_e1424 - _e529));
                                                let _e1442 = core_intrinsics_minimum_number_nsz_f32_((_e1430 + _e527), (_e1433 + _e528));
                                                let _e1443 = core_intrinsics_minimum_number_nsz_f32_(_e1442, (_e1436 + _e529));
                                                if (_e1441 > -300000000000000000000000000000000000000f) {
                                                    phi_2214_ = _e1441;
                                                } else {
                                                    phi_2214_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1446 = phi_2214_;
                                                if (_e1443 < 300000000000000000000000000000000000000f) {
                                                    phi_2219_ = _e1443;
                                                } else {
                                                    phi_2219_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1449 = phi_2219_;
                                                if (_e1317 < _e1446) {
                                                    phi_2224_ = _e1446;
                                                } else {
                                                    phi_2224_ = _e1317;
                                                }
                                                let _e1452 = phi_2224_;
                                                if (_e1452 > _e1449) {
                                                    phi_2229_ = _e1449;
                                                } else {
                                                    phi_2229_ = _e1452;
                                                }
                                                let _e1455 = phi_2229_;
                                                phi_2234_ = lt_bvh_triangle_Intersection(_e1455, (_e1158 / _e1217), (_e1179 / _e1217), (_e1446 <= _e1449));
                                                phi_2235_ = false;
                                            } else {
                                                phi_2234_ = lt_bvh_triangle_Intersection();
                                                phi_2235_ = true;
                                            }
                                            let _e1461 = phi_2234_;
                                            let _e1463 = phi_2235_;
                                            phi_2236_ = _e1461;
                                            phi_2237_ = _e1463;
                                        } else {
                                            phi_2236_ = lt_bvh_triangle_Intersection();
                                            phi_2237_ = true;
                                        }
                                        let _e1465 = phi_2236_;
                                        let _e1467 = phi_2237_;
                                        if _e1467 {
                                        }
                                        phi_2241_ = _e1465;
                                        phi_2242_ = _e1467;
                                    }
                                    let _e1469 = phi_2241_;
                                    let _e1471 = phi_2242_;
                                    phi_2243_ = _e1469;
                                    phi_2244_ = _e1220;
                                    phi_2245_ = _e1471;
                                } else {
                                    phi_2243_ = lt_bvh_triangle_Intersection();
                                    phi_2244_ = true;
                                    phi_2245_ = false;
                                }
                                let _e1473 = phi_2243_;
                                let _e1475 = phi_2244_;
                                let _e1477 = phi_2245_;
                                if _e1475 {
                                    phi_2249_ = true;
                                } else {
                                    phi_2249_ = _e1477;
                                }
                                let _e1479 = phi_2249_;
                                if _e1479 {
                                    phi_2253_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_2253_ = _e1473;
                                }
                                let _e1481 = phi_2253_;
                                if _e1481.is_hit {
                                    if (_e1481.t > 0f) {
                                        if (_e1481.t < _e156) {
                                            let _e1488 = triangles.member[(0u + _e1033)].i0_;
                                            let _e1490 = ((_e1488 & 2147483648u) == 0u);
                                            if _e1490 {
                                                phi_2476_ = false;
                                                phi_2477_ = false;
                                            } else {
                                                if (_e1033 < _e91) {
                                                } else {
                                                    return;
                                                }
                                                let _e1497 = triangles.member[(0u + _e1033)].i0_;
                                                let _e1498 = (_e1497 & 2147483647u);
                                                let _e1500 = triangles.member[(0u + _e1033)].i1_;
                                                let _e1502 = triangles.member[(0u + _e1033)].i2_;
                                                if (_e1498 < _e104) {
                                                } else {
                                                    return;
                                                }
                                                let _e1506 = vertices.member[(0u + _e1498)];
                                                if (_e1500 < _e104) {
                                                } else {
                                                    return;
                                                }
                                                let _e1510 = vertices.member[(0u + _e1500)];
                                                if (_e1502 < _e104) {
                                                } else {
                                                    return;
                                                }
                                                let _e1514 = vertices.member[(0u + _e1502)];
                                                let _e1515 = array<abi_Vertex, 3>(_e1506, _e1510, _e1514);
                                                if (_e1515[0].material < _e107) {
                                                } else {
                                                    return;
                                                }
                                                let _e1521 = materials.member[(0u + _e1515[0].material)];
                                                if ((_e1521.flags & 1u) == 1u) {
                                                    let _e1526 = ((1f - _e1481.u) - _e1481.v);
                                                    if (_e1521.cutoff <= 0f) {
                                                        phi_2470_ = true;
                                                    } else {
                                                        let _e1553 = (_e1521.base_color.w * ((((f32((_e1515[0].color >> bitcast<u32>(24i))) * _e1526) + (f32((_e1515[1].color >> bitcast<u32>(24i))) * _e1481.u)) + (f32((_e1515[2].color >> bitcast<u32>(24i))) * _e1481.v)) * (1f / 255f)));
                                                        if (_e1521.alpha_size == 0u) {
                                                            phi_2467_ = _e1553;
                                                        } else {
                                                            local_2.offset = _e1521.alpha_offset;
                                                            local_2.size = _e1521.alpha_size;
                                                            local_2.flags = _e1521.flags;
                                                            let _e1584 = _lt_shaders_texture_TextureView_quad((&local_2), (((_e1515[0].u * _e1526) + (_e1515[1].u * _e1481.u)) + (_e1515[2].u * _e1481.v)), (((_e1515[0].v * _e1526) + (_e1515[1].v * _e1481.u)) + (_e1515[2].v * _e1481.v)));
                                                            let _e1588 = (_e1584.indices[0] >> bitcast<u32>(2i));
                                                            if (_e1588 < _e110) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1592 = alpha_texels.member[(0u + _e1588)];
                                                            let _e1608 = (_e1584.indices[1] >> bitcast<u32>(2i));
                                                            if (_e1608 < _e110) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1612 = alpha_texels.member[(0u + _e1608)];
                                                            let _e1629 = (_e1584.indices[2] >> bitcast<u32>(2i));
                                                            if (_e1629 < _e110) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1633 = alpha_texels.member[(0u + _e1629)];
                                                            let _e1650 = (_e1584.indices[3] >> bitcast<u32>(2i));
                                                            if (_e1650 < _e110) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1654 = alpha_texels.member[(0u + _e1650)];
                                                            phi_2467_ = (_e1553 * (((((f32(((_e1592 >> bitcast<u32>((((_e1584.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1584.weights.x) + ((f32(((_e1612 >> bitcast<u32>((((_e1584.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1584.weights.y)) + ((f32(((_e1633 >> bitcast<u32>((((_e1584.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1584.weights.z)) + ((f32(((_e1654 >> bitcast<u32>((((_e1584.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1584.weights.w)));
                                                        }
                                                        let _e1670 = phi_2467_;
                                                        phi_2470_ = (_e1670 >= _e1521.cutoff);
                                                    }
                                                    let _e1674 = phi_2470_;
                                                    phi_2471_ = _e1674;
                                                } else {
                                                    phi_2471_ = false;
                                                }
                                                let _e1676 = phi_2471_;
                                                if _e1676 {
                                                    phi_2475_ = false;
                                                } else {
                                                    phi_2475_ = true;
                                                }
                                                let _e1678 = phi_2475_;
                                                phi_2476_ = _e1678;
                                                phi_2477_ = _e1676;
                                            }
                                            let _e1680 = phi_2476_;
                                            let _e1682 = phi_2477_;
                                            phi_2478_ = _e1680;
                                            phi_2479_ = _e1490;
                                            phi_2480_ = _e1682;
                                        } else {
                                            phi_2478_ = true;
                                            phi_2479_ = false;
                                            phi_2480_ = false;
                                        }
                                        let _e1684 = phi_2478_;
                                        let _e1686 = phi_2479_;
                                        let _e1688 = phi_2480_;
                                        phi_2481_ = false;
                                        phi_2482_ = _e1684;
                                        phi_2483_ = _e1686;
                                        phi_2484_ = _e1688;
                                    } else {
                                        phi_2481_ = true;
                                        phi_2482_ = false;
                                        phi_2483_ = false;
                                        phi_2484_ = false;
                                    }
                                    let _e1690 = phi_2481_;
                                    let _e1692 = phi_2482_;
                                    let _e1694 = phi_2483_;
                                    let _e1696 = phi_2484_;
                                    phi_2485_ = _e1690;
                                    phi_2486_ = _e1692;
                                    phi_2487_ = _e1694;
                                    phi_2488_ = _e1696;
                                } else {
                                    phi_2485_ = true;
                                    phi_2486_ = false;
                                    phi_2487_ = false;
                                    phi_2488_ = false;
                                }
                                let _e1698 = phi_2485_;
                                let _e1700 = phi_2486_;
                                let _e1702 = phi_2487_;
                                let _e1704 = phi_2488_;
                                if _e1698 {
                                    phi_2492_ = true;
                                    phi_2493_ = false;
                                    phi_2494_ = false;
                                } else {
                                    phi_2492_ = _e1700;
                                    phi_2493_ = _e1702;
                                    phi_2494_ = _e1704;
                                }
                                let _e1706 = phi_2492_;
                                let _e1708 = phi_2493_;
                                let _e1710 = phi_2494_;
                                if _e1706 {
                                    let _e1711 = (_e1035 == 0u);
                                    if _e1711 {
                                        phi_2502_ = false;
                                    } else {
                                        phi_2502_ = true;
                                    }
                                    let _e1713 = phi_2502_;
                                    phi_2503_ = _e1713;
                                    phi_2504_ = _e1711;
                                    phi_2505_ = false;
                                    phi_2506_ = false;
                                } else {
                                    phi_2503_ = false;
                                    phi_2504_ = false;
                                    phi_2505_ = _e1708;
                                    phi_2506_ = _e1710;
                                }
                                let _e1715 = phi_2503_;
                                let _e1717 = phi_2504_;
                                let _e1719 = phi_2505_;
                                let _e1721 = phi_2506_;
                                local_7 = _e1717;
                                local_18 = _e1719;
                                local_19 = _e1721;
                                local_20 = _e1717;
                                continue;
                                continuing {
                                    phi_1659_ = _e1035;
                                    break if !(_e1715);
                                }
                            }
                            let _e1724 = local_7;
                            if _e1724 {
                                phi_2510_ = false;
                                phi_2511_ = false;
                            } else {
                                let _e3579 = local_18;
                                phi_2510_ = _e3579;
                                let _e3582 = local_19;
                                phi_2511_ = _e3582;
                            }
                            let _e1726 = phi_2510_;
                            let _e1728 = phi_2511_;
                            let _e3585 = local_20;
                            phi_2512_ = _e3585;
                            phi_2513_ = _e1726;
                            phi_2514_ = _e1728;
                        }
                        let _e1730 = phi_2512_;
                        let _e1732 = phi_2513_;
                        let _e1734 = phi_2514_;
                        if _e1730 {
                            let _e1736 = local_8;
                            if (_e1736 == 0u) {
                                phi_2522_ = false;
                            } else {
                                phi_2522_ = true;
                            }
                            let _e1739 = phi_2522_;
                            phi_2523_ = _e1739;
                            phi_2524_ = false;
                            phi_2525_ = false;
                        } else {
                            phi_2523_ = false;
                            phi_2524_ = _e1732;
                            phi_2525_ = _e1734;
                        }
                        let _e1741 = phi_2523_;
                        let _e1743 = phi_2524_;
                        let _e1745 = phi_2525_;
                        local_9 = _e1743;
                        local_21 = _e1745;
                        local_22 = _e1743;
                        continue;
                        continuing {
                            let _e3426 = local_15;
                            phi_1205_ = _e3426;
                            let _e3429 = local_16;
                            phi_1208_ = _e3429;
                            break if !(_e1741);
                        }
                    }
                    let _e1748 = local_9;
                    if _e1748 {
                        phi_2529_ = false;
                    } else {
                        let _e3596 = local_21;
                        phi_2529_ = _e3596;
                    }
                    let _e1750 = phi_2529_;
                    if _e1750 {
                        phi_2533_ = true;
                    } else {
                        let _e3599 = local_22;
                        phi_2533_ = _e3599;
                    }
                    let _e1752 = phi_2533_;
                    if _e1752 {
                        phi_2537_ = true;
                    } else {
                        phi_2537_ = false;
                    }
                    let _e1754 = phi_2537_;
                    phi_2538_ = _e1754;
                }
                let _e1756 = phi_2538_;
                phi_4203_ = _e1756;
            } else {
                let _e1757 = abs(_e164);
                let _e1758 = abs(_e165);
                let _e1759 = abs(_e166);
                if (abs(_e144) < 1000000000000000f) {
                    if (abs(_e146) < 1000000000000000f) {
                        phi_2554_ = (abs(_e148) < 1000000000000000f);
                        phi_2555_ = false;
                    } else {
                        phi_2554_ = bool();
                        phi_2555_ = true;
                    }
                    let _e1767 = phi_2554_;
                    let _e1769 = phi_2555_;
                    phi_2556_ = _e1767;
                    phi_2557_ = _e1769;
                } else {
                    phi_2556_ = bool();
                    phi_2557_ = true;
                }
                let _e1771 = phi_2556_;
                let _e1773 = phi_2557_;
                if _e1773 {
                    phi_2561_ = false;
                } else {
                    phi_2561_ = _e1771;
                }
                let _e1775 = phi_2561_;
                if _e1775 {
                    if (_e1757 < 1000000000000000f) {
                        if (_e1758 < 1000000000000000f) {
                            phi_2574_ = (_e1759 < 1000000000000000f);
                            phi_2575_ = false;
                        } else {
                            phi_2574_ = bool();
                            phi_2575_ = true;
                        }
                        let _e1780 = phi_2574_;
                        let _e1782 = phi_2575_;
                        phi_2576_ = _e1780;
                        phi_2577_ = _e1782;
                    } else {
                        phi_2576_ = bool();
                        phi_2577_ = true;
                    }
                    let _e1784 = phi_2576_;
                    let _e1786 = phi_2577_;
                    if _e1786 {
                        phi_2581_ = false;
                    } else {
                        phi_2581_ = _e1784;
                    }
                    let _e1788 = phi_2581_;
                    if _e1788 {
                        if (_e1757 > 0f) {
                            phi_2595_ = bool();
                            phi_2596_ = true;
                        } else {
                            let _e1790 = (_e1758 > 0f);
                            if _e1790 {
                                phi_2594_ = bool();
                            } else {
                                phi_2594_ = (_e1759 > 0f);
                            }
                            let _e1793 = phi_2594_;
                            phi_2595_ = _e1793;
                            phi_2596_ = _e1790;
                        }
                        let _e1795 = phi_2595_;
                        let _e1797 = phi_2596_;
                        if _e1797 {
                            phi_2600_ = true;
                        } else {
                            phi_2600_ = _e1795;
                        }
                        let _e1799 = phi_2600_;
                        phi_2601_ = _e1799;
                        phi_2602_ = false;
                    } else {
                        phi_2601_ = bool();
                        phi_2602_ = true;
                    }
                    let _e1801 = phi_2601_;
                    let _e1803 = phi_2602_;
                    phi_2603_ = _e1801;
                    phi_2604_ = _e1803;
                } else {
                    phi_2603_ = bool();
                    phi_2604_ = true;
                }
                let _e1805 = phi_2603_;
                let _e1807 = phi_2604_;
                if _e1807 {
                    phi_2608_ = false;
                } else {
                    phi_2608_ = _e1805;
                }
                let _e1809 = phi_2608_;
                if _e1809 {
                    let _e1810 = (0u >= _e88);
                    if _e1810 {
                        phi_4196_ = bool();
                    } else {
                        if (0u < _e88) {
                        } else {
                            return;
                        }
                        let _e1816 = nodes.member[(0u + 0u)].frame[0u];
                        let _e1820 = nodes.member[(0u + 0u)].frame[1u];
                        let _e1824 = nodes.member[(0u + 0u)].frame[2u];
                        let _e1828 = nodes.member[(0u + 0u)].frame[0u];
                        let _e1832 = nodes.member[(0u + 0u)].frame[1u];
                        let _e1836 = nodes.member[(0u + 0u)].frame[2u];
                        let _e1840 = nodes.member[(0u + 0u)].frame[3u];
                        let _e1874 = core_intrinsics_maximum_number_nsz_f32_(abs(_e164), abs(_e165));
                        let _e1875 = core_intrinsics_maximum_number_nsz_f32_(_e1874, abs(_e166));
                        let _e1876 = (_e1875 * 0.0000000000009094947f);
                        if (abs(_e164) < _e1876) {
                            phi_2678_ = _e1876;
                        } else {
                            phi_2678_ = abs(_e164);
                        }
                        let _e1881 = phi_2678_;
                        if (_e164 < 0f) {
                            phi_2685_ = (-1f / _e1881);
                        } else {
                            phi_2685_ = (1f / _e1881);
                        }
                        let _e1886 = phi_2685_;
                        if (abs(_e165) < _e1876) {
                            phi_2692_ = _e1876;
                        } else {
                            phi_2692_ = abs(_e165);
                        }
                        let _e1891 = phi_2692_;
                        if (_e165 < 0f) {
                            phi_2699_ = (-1f / _e1891);
                        } else {
                            phi_2699_ = (1f / _e1891);
                        }
                        let _e1896 = phi_2699_;
                        if (abs(_e166) < _e1876) {
                            phi_2706_ = _e1876;
                        } else {
                            phi_2706_ = abs(_e166);
                        }
                        let _e1901 = phi_2706_;
                        if (_e166 < 0f) {
                            phi_2713_ = (-1f / _e1901);
                        } else {
                            phi_2713_ = (1f / _e1901);
                        }
                        let _e1906 = phi_2713_;
                        let _e1910 = abs((bitcast<f32>(_e1816) - _e144));
                        let _e1911 = abs((bitcast<f32>(_e1820) - _e146));
                        let _e1912 = abs((bitcast<f32>(_e1824) - _e148));
                        let _e1916 = abs(((bitcast<f32>(_e1828) + (bitcast<f32>((((_e1840 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e144));
                        let _e1917 = abs(((bitcast<f32>(_e1832) + (bitcast<f32>((((_e1840 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e146));
                        let _e1918 = abs(((bitcast<f32>(_e1836) + (bitcast<f32>((((_e1840 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e148));
                        if (_e1910 > _e1916) {
                            phi_2730_ = _e1910;
                        } else {
                            phi_2730_ = _e1916;
                        }
                        let _e1921 = phi_2730_;
                        if (_e1911 > _e1917) {
                            phi_2735_ = _e1911;
                        } else {
                            phi_2735_ = _e1917;
                        }
                        let _e1924 = phi_2735_;
                        if (_e1912 > _e1918) {
                            phi_2740_ = _e1912;
                        } else {
                            phi_2740_ = _e1918;
                        }
                        let _e1927 = phi_2740_;
                        if (_e1921 > _e1924) {
                            phi_2745_ = _e1921;
                        } else {
                            phi_2745_ = _e1924;
                        }
                        let _e1930 = phi_2745_;
                        if (_e1930 > _e1927) {
                            phi_2750_ = _e1930;
                        } else {
                            phi_2750_ = _e1927;
                        }
                        let _e1933 = phi_2750_;
                        let _e1937 = (_e1933 * 0.0000019073486f);
                        let _e1938 = (abs(_e1886) * _e1937);
                        let _e1939 = (abs(_e1896) * _e1937);
                        let _e1940 = (abs(_e1906) * _e1937);
                        let _e1944 = (_e1933 * 0.0000009536743f);
                        let _e1945 = (abs(_e1886) * _e1944);
                        let _e1946 = (abs(_e1896) * _e1944);
                        let _e1947 = (abs(_e1906) * _e1944);
                        let _e1948 = abs(_e164);
                        let _e1949 = abs(_e165);
                        let _e1950 = abs(_e166);
                        if (_e1948 >= _e1949) {
                            if (_e1948 >= _e1950) {
                                phi_2776_ = false;
                            } else {
                                phi_2776_ = true;
                            }
                            let _e1954 = phi_2776_;
                            phi_2777_ = _e1954;
                        } else {
                            phi_2777_ = true;
                        }
                        let _e1956 = phi_2777_;
                        if _e1956 {
                            if (_e1949 >= _e1950) {
                                phi_2785_ = 1u;
                            } else {
                                phi_2785_ = 2u;
                            }
                            let _e1959 = phi_2785_;
                            phi_2786_ = _e1959;
                        } else {
                            phi_2786_ = 0u;
                        }
                        let _e1961 = phi_2786_;
                        if (_e1961 == 0u) {
                            phi_2798_ = vec3<f32>(_e165, _e166, _e164);
                        } else {
                            if (_e1961 == 1u) {
                                phi_2797_ = vec3<f32>(_e166, _e164, _e165);
                            } else {
                                phi_2797_ = _e167;
                            }
                            let _e1967 = phi_2797_;
                            phi_2798_ = _e1967;
                        }
                        let _e1969 = phi_2798_;
                        let _e1972 = (_e1969.x / _e1969.z);
                        let _e1975 = (_e1969.y / _e1969.z);
                        if (_e1886 < 0f) {
                            phi_2811_ = 0u;
                        } else {
                            phi_2811_ = 1u;
                        }
                        let _e1980 = phi_2811_;
                        if (_e1896 < 0f) {
                            phi_2816_ = 0u;
                        } else {
                            phi_2816_ = 2u;
                        }
                        let _e1983 = phi_2816_;
                        if (_e1906 < 0f) {
                            phi_2821_ = 0u;
                        } else {
                            phi_2821_ = 4u;
                        }
                        let _e1986 = phi_2821_;
                        let _e1988 = ((_e1980 | _e1983) | _e1986);
                        let _e1989 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                        local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e1989.first[0], _e1989.first[1], _e1989.first[2], _e1989.first[3], _e1989.first[4], _e1989.first[5], _e1989.first[6], _e1989.first[7], _e1989.first[8], _e1989.first[9], _e1989.first[10], _e1989.first[11], _e1989.first[12], _e1989.first[13], _e1989.first[14], _e1989.first[15], _e1989.first[16], _e1989.first[17], _e1989.first[18], _e1989.first[19], _e1989.first[20], _e1989.first[21], _e1989.first[22], _e1989.first[23], _e1989.first[24], _e1989.first[25], _e1989.first[26], _e1989.first[27], _e1989.first[28], _e1989.first[29], _e1989.first[30], _e1989.first[31]), array<u32, 32>(_e1989.mask[0], _e1989.mask[1], _e1989.mask[2], _e1989.mask[3], _e1989.mask[4], _e1989.mask[5], _e1989.mask[6], _e1989.mask[7], _e1989.mask[8], _e1989.mask[9], _e1989.mask[10], _e1989.mask[11], _e1989.mask[12], _e1989.mask[13], _e1989.mask[14], _e1989.mask[15], _e1989.mask[16], _e1989.mask[17], _e1989.mask[18], _e1989.mask[19], _e1989.mask[20], _e1989.mask[21], _e1989.mask[22], _e1989.mask[23], _e1989.mask[24], _e1989.mask[25], _e1989.mask[26], _e1989.mask[27], _e1989.mask[28], _e1989.mask[29], _e1989.mask[30], _e1989.mask[31]), _e1989.len, _e1989.group, _e1989.group_mask);
                        let _e2063 = local_1.group_mask;
                        if ((_e2063 & 4278190080u) == 0u) {
                            let _e2067 = local_1.len;
                            if (_e2067 == 0u) {
                                phi_2935_ = false;
                            } else {
                                let _e2071 = local_1.len;
                                local_1.len = (_e2071 - 1u);
                                let _e2074 = local_1.len;
                                if (_e2074 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2079 = local_1.first[(0u + _e2074)];
                                local_1.group = _e2079;
                                let _e2082 = local_1.len;
                                if (_e2082 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2087 = local_1.mask[(0u + _e2082)];
                                local_1.group_mask = _e2087;
                                phi_2935_ = true;
                            }
                            let _e2090 = phi_2935_;
                            phi_2936_ = _e2090;
                        } else {
                            phi_2936_ = true;
                        }
                        let _e2092 = phi_2936_;
                        if _e2092 {
                            let _e2094 = local_1.group_mask;
                            let _e2100 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2094)), 32u, (_e2094 == 0u)));
                            let _e2104 = local_1.group_mask;
                            let _e2118 = local_1.group_mask;
                            local_1.group_mask = (_e2118 & ~((1u << bitcast<u32>((_e2100 & 31u)))));
                            let _e2121 = local_1.group;
                            phi_2967_ = (_e2121 + countOneBits(((_e2104 & ~((4294967295u << bitcast<u32>((((_e2100 - 24u) ^ 7u) & 31u))))) & 255u)));
                        } else {
                            phi_2967_ = 4294967295u;
                        }
                        let _e2124 = phi_2967_;
                        phi_2969_ = _e2124;
                        phi_2972_ = false;
                        loop {
                            let _e2126 = phi_2969_;
                            let _e2128 = phi_2972_;
                            local_27 = _e2128;
                            if (_e2126 != 4294967295u) {
                                if (_e2126 < _e88) {
                                } else {
                                    return;
                                }
                                let _e2135 = nodes.member[(0u + _e2126)].frame[3u];
                                let _e2160 = (bitcast<f32>((((_e2135 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1886);
                                let _e2161 = (bitcast<f32>((((_e2135 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1896);
                                let _e2162 = (bitcast<f32>((((_e2135 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1906);
                                let _e2165 = nodes.member[(0u + _e2126)].frame[0u];
                                let _e2169 = nodes.member[(0u + _e2126)].frame[1u];
                                let _e2173 = nodes.member[(0u + _e2126)].frame[2u];
                                let _e2178 = ((bitcast<f32>(_e2165) - _e144) * _e1886);
                                let _e2179 = ((bitcast<f32>(_e2169) - _e146) * _e1896);
                                let _e2180 = ((bitcast<f32>(_e2173) - _e148) * _e1906);
                                let _e2188 = nodes.member[(0u + _e2126)].x;
                                if (_e1886 < 0f) {
                                    let _e2199 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2188.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2205 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2199.unnamed.root, _e2188.w), _e2199.unnamed_1);
                                    let _e2211 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2205.unnamed, lt_bvh_traverse_Tree(_e2188.x, _e2205.unnamed_1.first_primitive));
                                    phi_3052_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2211.unnamed, lt_bvh_traverse_Tree(_e2211.unnamed_1.root, _e2188.y));
                                } else {
                                    let _e2227 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2188.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2233 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2227.unnamed.root, _e2188.y), _e2227.unnamed_1);
                                    let _e2239 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2233.unnamed, lt_bvh_traverse_Tree(_e2188.z, _e2233.unnamed_1.first_primitive));
                                    phi_3052_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2239.unnamed, lt_bvh_traverse_Tree(_e2239.unnamed_1.root, _e2188.w));
                                }
                                let _e2247 = phi_3052_;
                                let _e2257 = nodes.member[(0u + _e2126)].y;
                                if (_e1896 < 0f) {
                                    let _e2268 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2257.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2274 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2268.unnamed.root, _e2257.w), _e2268.unnamed_1);
                                    let _e2280 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2274.unnamed, lt_bvh_traverse_Tree(_e2257.x, _e2274.unnamed_1.first_primitive));
                                    phi_3079_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2280.unnamed, lt_bvh_traverse_Tree(_e2280.unnamed_1.root, _e2257.y));
                                } else {
                                    let _e2296 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2257.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2302 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2296.unnamed.root, _e2257.y), _e2296.unnamed_1);
                                    let _e2308 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2302.unnamed, lt_bvh_traverse_Tree(_e2257.z, _e2302.unnamed_1.first_primitive));
                                    phi_3079_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2308.unnamed, lt_bvh_traverse_Tree(_e2308.unnamed_1.root, _e2257.w));
                                }
                                let _e2316 = phi_3079_;
                                let _e2326 = nodes.member[(0u + _e2126)].z;
                                if (_e1906 < 0f) {
                                    let _e2337 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2326.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2343 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2337.unnamed.root, _e2326.w), _e2337.unnamed_1);
                                    let _e2349 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2343.unnamed, lt_bvh_traverse_Tree(_e2326.x, _e2343.unnamed_1.first_primitive));
                                    phi_3106_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2349.unnamed, lt_bvh_traverse_Tree(_e2349.unnamed_1.root, _e2326.y));
                                } else {
                                    let _e2365 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2326.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2371 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2365.unnamed.root, _e2326.y), _e2365.unnamed_1);
                                    let _e2377 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2371.unnamed, lt_bvh_traverse_Tree(_e2326.z, _e2371.unnamed_1.first_primitive));
                                    phi_3106_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2377.unnamed, lt_bvh_traverse_Tree(_e2377.unnamed_1.root, _e2326.w));
                                }
                                let _e2385 = phi_3106_;
                                phi_3112_ = 0u;
                                phi_3115_ = 0u;
                                loop {
                                    let _e2395 = phi_3112_;
                                    let _e2397 = phi_3115_;
                                    local_10 = _e2397;
                                    local_11 = _e2397;
                                    local_12 = _e2397;
                                    let _e2398 = (_e2395 < 8u);
                                    if _e2398 {
                                        let _e2400 = (_e2395 >> bitcast<u32>(2i));
                                        let _e2401 = (_e2395 & 3u);
                                        if (_e2400 == 0u) {
                                            phi_3129_ = _e2247.unnamed.root;
                                        } else {
                                            phi_3129_ = _e2247.unnamed.first_primitive;
                                        }
                                        let _e2404 = phi_3129_;
                                        if (_e2400 == 0u) {
                                            phi_3139_ = _e2316.unnamed.root;
                                        } else {
                                            phi_3139_ = _e2316.unnamed.first_primitive;
                                        }
                                        let _e2413 = phi_3139_;
                                        if (_e2400 == 0u) {
                                            phi_3149_ = _e2385.unnamed.root;
                                        } else {
                                            phi_3149_ = _e2385.unnamed.first_primitive;
                                        }
                                        let _e2422 = phi_3149_;
                                        let _e2435 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e2404 >> bitcast<u32>(((_e2401 * 8u) & 31u))) & 255u)) * _e2160) + (_e2178 - _e1938)), ((f32(((_e2413 >> bitcast<u32>(((_e2401 * 8u) & 31u))) & 255u)) * _e2161) + (_e2179 - _e1939)));
                                        let _e2436 = core_intrinsics_maximum_number_nsz_f32_(_e2435, ((f32(((_e2422 >> bitcast<u32>(((_e2401 * 8u) & 31u))) & 255u)) * _e2162) + (_e2180 - _e1940)));
                                        if (_e2400 == 0u) {
                                            phi_3167_ = _e2247.unnamed_1.root;
                                        } else {
                                            phi_3167_ = _e2247.unnamed_1.first_primitive;
                                        }
                                        let _e2439 = phi_3167_;
                                        if (_e2400 == 0u) {
                                            phi_3177_ = _e2316.unnamed_1.root;
                                        } else {
                                            phi_3177_ = _e2316.unnamed_1.first_primitive;
                                        }
                                        let _e2448 = phi_3177_;
                                        if (_e2400 == 0u) {
                                            phi_3187_ = _e2385.unnamed_1.root;
                                        } else {
                                            phi_3187_ = _e2385.unnamed_1.first_primitive;
                                        }
                                        let _e2457 = phi_3187_;
                                        let _e2470 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e2439 >> bitcast<u32>(((_e2401 * 8u) & 31u))) & 255u)) * _e2160) + (_e2178 + _e1938)), ((f32(((_e2448 >> bitcast<u32>(((_e2401 * 8u) & 31u))) & 255u)) * _e2161) + (_e2179 + _e1939)));
                                        let _e2471 = core_intrinsics_minimum_number_nsz_f32_(_e2470, ((f32(((_e2457 >> bitcast<u32>(((_e2401 * 8u) & 31u))) & 255u)) * _e2162) + (_e2180 + _e1940)));
                                        if (_e2436 <= _e2471) {
                                            if (_e2436 <= _e156) {
                                                if (_e2471 >= 0f) {
                                                    if (_e2400 == 0u) {
                                                        let _e2478 = nodes.member[(0u + _e2126)].links[2u];
                                                        phi_3223_ = _e2478;
                                                    } else {
                                                        let _e2481 = nodes.member[(0u + _e2126)].links[3u];
                                                        phi_3223_ = _e2481;
                                                    }
                                                    let _e2483 = phi_3223_;
                                                    let _e2488 = ((_e2483 >> bitcast<u32>(((_e2401 * 8u) & 31u))) & 255u);
                                                    let _e2489 = (_e2488 & 31u);
                                                    if (_e2489 >= 24u) {
                                                        phi_3236_ = (24u + ((_e2489 - 24u) ^ _e1988));
                                                    } else {
                                                        phi_3236_ = _e2489;
                                                    }
                                                    let _e2495 = phi_3236_;
                                                    phi_3241_ = (_e2397 | ((_e2488 >> bitcast<u32>(5i)) << bitcast<u32>((_e2495 & 31u))));
                                                } else {
                                                    phi_3241_ = _e2397;
                                                }
                                                let _e2503 = phi_3241_;
                                                phi_3242_ = _e2503;
                                            } else {
                                                phi_3242_ = _e2397;
                                            }
                                            let _e2505 = phi_3242_;
                                            phi_3243_ = _e2505;
                                        } else {
                                            phi_3243_ = _e2397;
                                        }
                                        let _e2507 = phi_3243_;
                                        phi_3113_ = (_e2395 + 1u);
                                        phi_3116_ = _e2507;
                                    } else {
                                        phi_3113_ = u32();
                                        phi_3116_ = u32();
                                    }
                                    let _e2510 = phi_3113_;
                                    let _e2512 = phi_3116_;
                                    continue;
                                    continuing {
                                        phi_3112_ = _e2510;
                                        phi_3115_ = _e2512;
                                        break if !(_e2398);
                                    }
                                }
                                let _e2516 = nodes.member[(0u + _e2126)].links[0u];
                                let _e2520 = nodes.member[(0u + _e2126)].frame[3u];
                                let _e2524 = local_10;
                                if ((_e2524 & 4278190080u) == 0u) {
                                } else {
                                    let _e2528 = local_1.group_mask;
                                    if ((_e2528 & 4278190080u) == 0u) {
                                    } else {
                                        let _e2532 = local_1.len;
                                        if (_e2532 < 32u) {
                                            let _e2535 = local_1.group;
                                            let _e2537 = local_1.len;
                                            if (_e2537 < 32u) {
                                            } else {
                                                return;
                                            }
                                            local_1.first[(0u + _e2537)] = _e2535;
                                            let _e2543 = local_1.group_mask;
                                            let _e2545 = local_1.len;
                                            if (_e2545 < 32u) {
                                            } else {
                                                return;
                                            }
                                            local_1.mask[(0u + _e2545)] = _e2543;
                                            let _e2552 = local_1.len;
                                            local_1.len = (_e2552 + 1u);
                                        }
                                    }
                                    local_1.group = (0u + _e2516);
                                    let _e2556 = local_11;
                                    local_1.group_mask = ((_e2556 & 4278190080u) | (_e2520 >> bitcast<u32>(24i)));
                                }
                                let _e2561 = local_12;
                                phi_3301_ = (_e2561 & 16777215u);
                                phi_3304_ = _e2128;
                                loop {
                                    let _e2564 = phi_3301_;
                                    let _e2566 = phi_3304_;
                                    local_23 = _e2566;
                                    let _e2567 = (_e2564 == 0u);
                                    local_13 = _e2567;
                                    local_25 = _e2567;
                                    if _e2567 {
                                        phi_3302_ = u32();
                                        phi_3305_ = bool();
                                        phi_4108_ = bool();
                                        phi_4109_ = false;
                                    } else {
                                        let _e2570 = nodes.member[(0u + _e2126)].links[1u];
                                        let _e2575 = ((0u + _e2570) + select(firstTrailingBit(_e2564), 32u, (_e2564 == 0u)));
                                        if (_e2575 < _e91) {
                                        } else {
                                            return;
                                        }
                                        let _e2582 = triangles.member[(0u + _e2575)].v0_;
                                        let _e2584 = (_e2582.x - _e144);
                                        let _e2586 = (_e2582.y - _e146);
                                        let _e2588 = (_e2582.z - _e148);
                                        if (_e1961 == 0u) {
                                            phi_3349_ = vec3<f32>(_e2586, _e2588, _e2584);
                                        } else {
                                            if (_e1961 == 1u) {
                                                phi_3348_ = vec3<f32>(_e2588, _e2584, _e2586);
                                            } else {
                                                phi_3348_ = (_e2582 - vec3<f32>(_e144, _e146, _e148));
                                            }
                                            let _e2596 = phi_3348_;
                                            phi_3349_ = _e2596;
                                        }
                                        let _e2598 = phi_3349_;
                                        let _e2602 = (_e2598.x - (_e1972 * _e2598.z));
                                        let _e2606 = (_e2598.y - (_e1975 * _e2598.z));
                                        let _e2608 = triangles.member[(0u + _e2575)].v1_;
                                        let _e2610 = (_e2608.x - _e144);
                                        let _e2612 = (_e2608.y - _e146);
                                        let _e2614 = (_e2608.z - _e148);
                                        if (_e1961 == 0u) {
                                            phi_3379_ = vec3<f32>(_e2612, _e2614, _e2610);
                                        } else {
                                            if (_e1961 == 1u) {
                                                phi_3378_ = vec3<f32>(_e2614, _e2610, _e2612);
                                            } else {
                                                phi_3378_ = (_e2608 - vec3<f32>(_e144, _e146, _e148));
                                            }
                                            let _e2622 = phi_3378_;
                                            phi_3379_ = _e2622;
                                        }
                                        let _e2624 = phi_3379_;
                                        let _e2628 = (_e2624.x - (_e1972 * _e2624.z));
                                        let _e2632 = (_e2624.y - (_e1975 * _e2624.z));
                                        let _e2634 = triangles.member[(0u + _e2575)].v2_;
                                        let _e2636 = (_e2634.x - _e144);
                                        let _e2638 = (_e2634.y - _e146);
                                        let _e2640 = (_e2634.z - _e148);
                                        if (_e1961 == 0u) {
                                            phi_3409_ = vec3<f32>(_e2638, _e2640, _e2636);
                                        } else {
                                            if (_e1961 == 1u) {
                                                phi_3408_ = vec3<f32>(_e2640, _e2636, _e2638);
                                            } else {
                                                phi_3408_ = (_e2634 - vec3<f32>(_e144, _e146, _e148));
                                            }
                                            let _e2648 = phi_3408_;
                                            phi_3409_ = _e2648;
                                        }
                                        let _e2650 = phi_3409_;
                                        let _e2654 = (_e2650.x - (_e1972 * _e2650.z));
                                        let _e2658 = (_e2650.y - (_e1975 * _e2650.z));
                                        if (_e2628 < _e2654) {
                                            phi_3428_ = true;
                                        } else {
                                            if (_e2628 == _e2654) {
                                                phi_3427_ = (_e2632 < _e2658);
                                            } else {
                                                phi_3427_ = false;
                                            }
                                            let _e2663 = phi_3427_;
                                            phi_3428_ = _e2663;
                                        }
                                        let _e2665 = phi_3428_;
                                        if _e2665 {
                                            phi_3432_ = _e2658;
                                            phi_3433_ = _e2654;
                                            phi_3434_ = _e2632;
                                            phi_3435_ = _e2628;
                                        } else {
                                            phi_3432_ = _e2632;
                                            phi_3433_ = _e2628;
                                            phi_3434_ = _e2658;
                                            phi_3435_ = _e2654;
                                        }
                                        let _e2667 = phi_3432_;
                                        let _e2669 = phi_3433_;
                                        let _e2671 = phi_3434_;
                                        let _e2673 = phi_3435_;
                                        let _e2676 = ((_e2673 * _e2667) - (_e2671 * _e2669));
                                        if _e2665 {
                                            phi_3443_ = -(_e2676);
                                        } else {
                                            phi_3443_ = _e2676;
                                        }
                                        let _e2679 = phi_3443_;
                                        if (_e2654 < _e2602) {
                                            phi_3454_ = true;
                                        } else {
                                            if (_e2654 == _e2602) {
                                                phi_3453_ = (_e2658 < _e2606);
                                            } else {
                                                phi_3453_ = false;
                                            }
                                            let _e2684 = phi_3453_;
                                            phi_3454_ = _e2684;
                                        }
                                        let _e2686 = phi_3454_;
                                        if _e2686 {
                                            phi_3458_ = _e2606;
                                            phi_3459_ = _e2602;
                                            phi_3460_ = _e2658;
                                            phi_3461_ = _e2654;
                                        } else {
                                            phi_3458_ = _e2658;
                                            phi_3459_ = _e2654;
                                            phi_3460_ = _e2606;
                                            phi_3461_ = _e2602;
                                        }
                                        let _e2688 = phi_3458_;
                                        let _e2690 = phi_3459_;
                                        let _e2692 = phi_3460_;
                                        let _e2694 = phi_3461_;
                                        let _e2697 = ((_e2694 * _e2688) - (_e2692 * _e2690));
                                        if _e2686 {
                                            phi_3469_ = -(_e2697);
                                        } else {
                                            phi_3469_ = _e2697;
                                        }
                                        let _e2700 = phi_3469_;
                                        if (_e2602 < _e2628) {
                                            phi_3480_ = true;
                                        } else {
                                            if (_e2602 == _e2628) {
                                                phi_3479_ = (_e2606 < _e2632);
                                            } else {
                                                phi_3479_ = false;
                                            }
                                            let _e2705 = phi_3479_;
                                            phi_3480_ = _e2705;
                                        }
                                        let _e2707 = phi_3480_;
                                        if _e2707 {
                                            phi_3484_ = _e2632;
                                            phi_3485_ = _e2628;
                                            phi_3486_ = _e2606;
                                            phi_3487_ = _e2602;
                                        } else {
                                            phi_3484_ = _e2606;
                                            phi_3485_ = _e2602;
                                            phi_3486_ = _e2632;
                                            phi_3487_ = _e2628;
                                        }
                                        let _e2709 = phi_3484_;
                                        let _e2711 = phi_3485_;
                                        let _e2713 = phi_3486_;
                                        let _e2715 = phi_3487_;
                                        let _e2718 = ((_e2715 * _e2709) - (_e2713 * _e2711));
                                        if _e2707 {
                                            phi_3495_ = -(_e2718);
                                        } else {
                                            phi_3495_ = _e2718;
                                        }
                                        let _e2721 = phi_3495_;
                                        if (_e2679 >= 0f) {
                                            if (_e2700 >= 0f) {
                                                if (_e2721 >= 0f) {
                                                    phi_3510_ = ((_e2679 + _e2700) + _e2721);
                                                    phi_3511_ = false;
                                                } else {
                                                    phi_3510_ = f32();
                                                    phi_3511_ = true;
                                                }
                                                let _e2728 = phi_3510_;
                                                let _e2730 = phi_3511_;
                                                phi_3512_ = _e2728;
                                                phi_3513_ = _e2730;
                                            } else {
                                                phi_3512_ = f32();
                                                phi_3513_ = true;
                                            }
                                            let _e2732 = phi_3512_;
                                            let _e2734 = phi_3513_;
                                            phi_3514_ = _e2732;
                                            phi_3515_ = _e2734;
                                        } else {
                                            phi_3514_ = f32();
                                            phi_3515_ = true;
                                        }
                                        let _e2736 = phi_3514_;
                                        let _e2738 = phi_3515_;
                                        if _e2738 {
                                            if (_e2679 <= 0f) {
                                                if (_e2700 <= 0f) {
                                                    let _e2741 = (_e2721 <= 0f);
                                                    if _e2741 {
                                                    }
                                                    phi_3533_ = ((_e2679 + _e2700) + _e2721);
                                                    phi_3534_ = false;
                                                    phi_3535_ = _e2741;
                                                } else {
                                                    phi_3533_ = f32();
                                                    phi_3534_ = true;
                                                    phi_3535_ = false;
                                                }
                                                let _e2745 = phi_3533_;
                                                let _e2747 = phi_3534_;
                                                let _e2749 = phi_3535_;
                                                phi_3536_ = _e2745;
                                                phi_3537_ = _e2747;
                                                phi_3538_ = _e2749;
                                            } else {
                                                phi_3536_ = f32();
                                                phi_3537_ = true;
                                                phi_3538_ = false;
                                            }
                                            let _e2751 = phi_3536_;
                                            let _e2753 = phi_3537_;
                                            let _e2755 = phi_3538_;
                                            if _e2753 {
                                                phi_3542_ = false;
                                            } else {
                                                phi_3542_ = _e2755;
                                            }
                                            let _e2757 = phi_3542_;
                                            phi_3543_ = _e2751;
                                            phi_3544_ = _e2757;
                                        } else {
                                            phi_3543_ = _e2736;
                                            phi_3544_ = true;
                                        }
                                        let _e2759 = phi_3543_;
                                        let _e2761 = phi_3544_;
                                        if _e2761 {
                                            let _e2762 = (_e2759 == 0f);
                                            if _e2762 {
                                                phi_3860_ = lt_bvh_triangle_Intersection();
                                                phi_3861_ = false;
                                            } else {
                                                let _e2764 = triangles.member[(0u + _e2575)].v0_;
                                                let _e2766 = (_e2764.x - _e144);
                                                let _e2768 = (_e2764.y - _e146);
                                                let _e2770 = (_e2764.z - _e148);
                                                if (_e1961 == 0u) {
                                                    phi_3573_ = vec3<f32>(_e2768, _e2770, _e2766);
                                                } else {
                                                    if (_e1961 == 1u) {
                                                        phi_3572_ = vec3<f32>(_e2770, _e2766, _e2768);
                                                    } else {
                                                        phi_3572_ = (_e2764 - vec3<f32>(_e144, _e146, _e148));
                                                    }
                                                    let _e2778 = phi_3572_;
                                                    phi_3573_ = _e2778;
                                                }
                                                let _e2780 = phi_3573_;
                                                let _e2782 = triangles.member[(0u + _e2575)].v1_;
                                                let _e2784 = triangles.member[(0u + _e2575)].v0_;
                                                let _e2787 = (_e2782.x - _e2784.x);
                                                let _e2790 = (_e2782.y - _e2784.y);
                                                let _e2793 = (_e2782.z - _e2784.z);
                                                if (_e1961 == 0u) {
                                                    phi_3599_ = vec3<f32>(_e2790, _e2793, _e2787);
                                                } else {
                                                    if (_e1961 == 1u) {
                                                        phi_3598_ = vec3<f32>(_e2793, _e2787, _e2790);
                                                    } else {
                                                        phi_3598_ = (_e2782 - _e2784);
                                                    }
                                                    let _e2800 = phi_3598_;
                                                    phi_3599_ = _e2800;
                                                }
                                                let _e2802 = phi_3599_;
                                                let _e2804 = triangles.member[(0u + _e2575)].v2_;
                                                let _e2806 = triangles.member[(0u + _e2575)].v0_;
                                                let _e2809 = (_e2804.x - _e2806.x);
                                                let _e2812 = (_e2804.y - _e2806.y);
                                                let _e2815 = (_e2804.z - _e2806.z);
                                                if (_e1961 == 0u) {
                                                    phi_3625_ = vec3<f32>(_e2812, _e2815, _e2809);
                                                } else {
                                                    if (_e1961 == 1u) {
                                                        phi_3624_ = vec3<f32>(_e2815, _e2809, _e2812);
                                                    } else {
                                                        phi_3624_ = (_e2804 - _e2806);
                                                    }
                                                    let _e2822 = phi_3624_;
                                                    phi_3625_ = _e2822;
                                                }
                                                let _e2824 = phi_3625_;
                                                let _e2831 = ((_e2802.y * _e2824.z) - (_e2802.z * _e2824.y));
                                                let _e2838 = ((_e2802.z * _e2824.x) - (_e2802.x * _e2824.z));
                                                let _e2845 = ((_e2802.x * _e2824.y) - (_e2802.y * _e2824.x));
                                                let _e2859 = (((1f / _e1969.z) * (((_e2831 * _e2780.x) + (_e2838 * _e2780.y)) + (_e2845 * _e2780.z))) / (((_e2831 * _e1972) + (_e2838 * _e1975)) + _e2845));
                                                if (_e2859 > 0f) {
                                                    if (_e2859 < _e156) {
                                                        let _e2863 = triangles.member[(0u + _e2575)].v0_;
                                                        let _e2865 = triangles.member[(0u + _e2575)].v1_;
                                                        if (_e2863.x < _e2865.x) {
                                                            phi_3681_ = _e2863.x;
                                                        } else {
                                                            phi_3681_ = _e2865.x;
                                                        }
                                                        let _e2872 = phi_3681_;
                                                        if (_e2863.y < _e2865.y) {
                                                            phi_3690_ = _e2863.y;
                                                        } else {
                                                            phi_3690_ = _e2865.y;
                                                        }
                                                        let _e2879 = phi_3690_;
                                                        if (_e2863.z < _e2865.z) {
                                                            phi_3699_ = _e2863.z;
                                                        } else {
                                                            phi_3699_ = _e2865.z;
                                                        }
                                                        let _e2886 = phi_3699_;
                                                        let _e2888 = triangles.member[(0u + _e2575)].v2_;
                                                        if (_e2872 < _e2888.x) {
                                                            phi_3708_ = _e2872;
                                                        } else {
                                                            phi_3708_ = _e2888.x;
                                                        }
                                                        let _e2893 = phi_3708_;
                                                        if (_e2879 < _e2888.y) {
                                                            phi_3715_ = _e2879;
                                                        } else {
                                                            phi_3715_ = _e2888.y;
                                                        }
                                                        let _e2898 = phi_3715_;
                                                        if (_e2886 < _e2888.z) {
                                                            phi_3722_ = _e2886;
                                                        } else {
                                                            phi_3722_ = _e2888.z;
                                                        }
                                                        let _e2903 = phi_3722_;
                                                        let _e2905 = triangles.member[(0u + _e2575)].v0_;
                                                        let _e2907 = triangles.member[(0u + _e2575)].v1_;
                                                        if (_e2905.x > _e2907.x) {
                                                            phi_3735_ = _e2905.x;
                                                        } else {
                                                            phi_3735_ = _e2907.x;
                                                        }
                                                        let _e2914 = phi_3735_;
                                                        if (_e2905.y > _e2907.y) {
                                                            phi_3744_ = _e2905.y;
                                                        } else {
                                                            phi_3744_ = _e2907.y;
                                                        }
                                                        let _e2921 = phi_3744_;
                                                        if (_e2905.z > _e2907.z) {
                                                            phi_3753_ = _e2905.z;
                                                        } else {
                                                            phi_3753_ = _e2907.z;
                                                        }
                                                        let _e2928 = phi_3753_;
                                                        let _e2930 = triangles.member[(0u + _e2575)].v2_;
                                                        if (_e2914 > _e2930.x) {
                                                            phi_3762_ = _e2914;
                                                        } else {
                                                            phi_3762_ = _e2930.x;
                                                        }
                                                        let _e2935 = phi_3762_;
                                                        if (_e2921 > _e2930.y) {
                                                            phi_3769_ = _e2921;
                                                        } else {
                                                            phi_3769_ = _e2930.y;
                                                        }
                                                        let _e2940 = phi_3769_;
                                                        if (_e2928 > _e2930.z) {
                                                            phi_3776_ = _e2928;
                                                        } else {
                                                            phi_3776_ = _e2930.z;
                                                        }
                                                        let _e2945 = phi_3776_;
                                                        let _e2949 = ((_e2893 - _e144) * _e1886);
                                                        let _e2950 = ((_e2898 - _e146) * _e1896);
                                                        let _e2951 = ((_e2903 - _e148) * _e1906);
                                                        let _e2955 = ((_e2935 - _e144) * _e1886);
                                                        let _e2956 = ((_e2940 - _e146) * _e1896);
                                                        let _e2957 = ((_e2945 - _e148) * _e1906);
                                                        if (_e2949 < _e2955) {
                                                            phi_3793_ = _e2949;
                                                        } else {
                                                            phi_3793_ = _e2955;
                                                        }
                                                        let _e2960 = phi_3793_;
                                                        if (_e2950 < _e2956) {
                                                            phi_3798_ = _e2950;
                                                        } else {
                                                            phi_3798_ = _e2956;
                                                        }
                                                        let _e2963 = phi_3798_;
                                                        if (_e2951 < _e2957) {
                                                            phi_3803_ = _e2951;
                                                        } else {
                                                            phi_3803_ = _e2957;
                                                        }
                                                        let _e2966 = phi_3803_;
                                                        if (_e2949 > _e2955) {
                                                            phi_3811_ = _e2949;
                                                        } else {
                                                            phi_3811_ = _e2955;
                                                        }
                                                        let _e2972 = phi_3811_;
                                                        if (_e2950 > _e2956) {
                                                            phi_3816_ = _e2950;
                                                        } else {
                                                            phi_3816_ = _e2956;
                                                        }
                                                        let _e2975 = phi_3816_;
                                                        if (_e2951 > _e2957) {
                                                            phi_3821_ = _e2951;
                                                        } else {
                                                            phi_3821_ = _e2957;
                                                        }
                                                        let _e2978 = phi_3821_;
                                                        let _e2982 = core_intrinsics_maximum_number_nsz_f32_((_e2960 - _e1945), (_e2963 - _e1946));
                                                        let _e2983 = core_intrinsics_maximum_number_nsz_f32_(_e2982, (_e2966 - _e1947));
                                                        let _e2984 = core_intrinsics_minimum_number_nsz_f32_((_e2972 + _e1945), (_e2975 + _e1946));
                                                        let _e2985 = core_intrinsics_minimum_number_nsz_f32_(_e2984, (_e2978 + _e1947));
                                                        if (_e2983 > -300000000000000000000000000000000000000f) {
                                                            phi_3833_ = _e2983;
                                                        } else {
                                                            phi_3833_ = -300000000000000000000000000000000000000f;
                                                        }
                                                        let _e2988 = phi_3833_;
                                                        if (_e2985 < 300000000000000000000000000000000000000f) {
                                                            phi_3838_ = _e2985;
                                                        } else {
                                                            phi_3838_ = 300000000000000000000000000000000000000f;
                                                        }
                                                        let _e2991 = phi_3838_;
                                                        if (_e2859 < _e2988) {
                                                            phi_3843_ = _e2988;
                                                        } else {
                                                            phi_3843_ = _e2859;
                                                        }
                                                        let _e2994 = phi_3843_;
                                                        if (_e2994 > _e2991) {
                                                            phi_3848_ = _e2991;
                                                        } else {
                                                            phi_3848_ = _e2994;
                                                        }
                                                        let _e2997 = phi_3848_;
                                                        phi_3853_ = lt_bvh_triangle_Intersection(_e2997, (_e2700 / _e2759), (_e2721 / _e2759), (_e2988 <= _e2991));
                                                        phi_3854_ = false;
                                                    } else {
                                                        phi_3853_ = lt_bvh_triangle_Intersection();
                                                        phi_3854_ = true;
                                                    }
                                                    let _e3003 = phi_3853_;
                                                    let _e3005 = phi_3854_;
                                                    phi_3855_ = _e3003;
                                                    phi_3856_ = _e3005;
                                                } else {
                                                    phi_3855_ = lt_bvh_triangle_Intersection();
                                                    phi_3856_ = true;
                                                }
                                                let _e3007 = phi_3855_;
                                                let _e3009 = phi_3856_;
                                                if _e3009 {
                                                }
                                                phi_3860_ = _e3007;
                                                phi_3861_ = _e3009;
                                            }
                                            let _e3011 = phi_3860_;
                                            let _e3013 = phi_3861_;
                                            phi_3862_ = _e3011;
                                            phi_3863_ = _e2762;
                                            phi_3864_ = _e3013;
                                        } else {
                                            phi_3862_ = lt_bvh_triangle_Intersection();
                                            phi_3863_ = true;
                                            phi_3864_ = false;
                                        }
                                        let _e3015 = phi_3862_;
                                        let _e3017 = phi_3863_;
                                        let _e3019 = phi_3864_;
                                        if _e3017 {
                                            phi_3868_ = true;
                                        } else {
                                            phi_3868_ = _e3019;
                                        }
                                        let _e3021 = phi_3868_;
                                        if _e3021 {
                                            phi_3872_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                        } else {
                                            phi_3872_ = _e3015;
                                        }
                                        let _e3023 = phi_3872_;
                                        if _e3023.is_hit {
                                            if (_e3023.t > 0f) {
                                                if (_e3023.t < _e156) {
                                                    let _e3030 = triangles.member[(0u + _e2575)].i0_;
                                                    if ((_e3030 & 2147483648u) == 0u) {
                                                        phi_4091_ = true;
                                                    } else {
                                                        if (_e2575 < _e91) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e3039 = triangles.member[(0u + _e2575)].i0_;
                                                        let _e3040 = (_e3039 & 2147483647u);
                                                        let _e3042 = triangles.member[(0u + _e2575)].i1_;
                                                        let _e3044 = triangles.member[(0u + _e2575)].i2_;
                                                        if (_e3040 < _e104) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e3048 = vertices.member[(0u + _e3040)];
                                                        if (_e3042 < _e104) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e3052 = vertices.member[(0u + _e3042)];
                                                        if (_e3044 < _e104) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e3056 = vertices.member[(0u + _e3044)];
                                                        let _e3057 = array<abi_Vertex, 3>(_e3048, _e3052, _e3056);
                                                        if (_e3057[0].material < _e107) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e3063 = materials.member[(0u + _e3057[0].material)];
                                                        if ((_e3063.flags & 1u) == 1u) {
                                                            let _e3068 = ((1f - _e3023.u) - _e3023.v);
                                                            if (_e3063.cutoff <= 0f) {
                                                                phi_4089_ = true;
                                                            } else {
                                                                let _e3095 = (_e3063.base_color.w * ((((f32((_e3057[0].color >> bitcast<u32>(24i))) * _e3068) + (f32((_e3057[1].color >> bitcast<u32>(24i))) * _e3023.u)) + (f32((_e3057[2].color >> bitcast<u32>(24i))) * _e3023.v)) * (1f / 255f)));
                                                                if (_e3063.alpha_size == 0u) {
                                                                    phi_4086_ = _e3095;
                                                                } else {
                                                                    local.offset = _e3063.alpha_offset;
                                                                    local.size = _e3063.alpha_size;
                                                                    local.flags = _e3063.flags;
                                                                    let _e3126 = _lt_shaders_texture_TextureView_quad((&local), (((_e3057[0].u * _e3068) + (_e3057[1].u * _e3023.u)) + (_e3057[2].u * _e3023.v)), (((_e3057[0].v * _e3068) + (_e3057[1].v * _e3023.u)) + (_e3057[2].v * _e3023.v)));
                                                                    let _e3130 = (_e3126.indices[0] >> bitcast<u32>(2i));
                                                                    if (_e3130 < _e110) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e3134 = alpha_texels.member[(0u + _e3130)];
                                                                    let _e3150 = (_e3126.indices[1] >> bitcast<u32>(2i));
                                                                    if (_e3150 < _e110) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e3154 = alpha_texels.member[(0u + _e3150)];
                                                                    let _e3171 = (_e3126.indices[2] >> bitcast<u32>(2i));
                                                                    if (_e3171 < _e110) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e3175 = alpha_texels.member[(0u + _e3171)];
                                                                    let _e3192 = (_e3126.indices[3] >> bitcast<u32>(2i));
                                                                    if (_e3192 < _e110) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e3196 = alpha_texels.member[(0u + _e3192)];
                                                                    phi_4086_ = (_e3095 * (((((f32(((_e3134 >> bitcast<u32>((((_e3126.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e3126.weights.x) + ((f32(((_e3154 >> bitcast<u32>((((_e3126.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e3126.weights.y)) + ((f32(((_e3175 >> bitcast<u32>((((_e3126.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e3126.weights.z)) + ((f32(((_e3196 >> bitcast<u32>((((_e3126.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e3126.weights.w)));
                                                                }
                                                                let _e3212 = phi_4086_;
                                                                phi_4089_ = (_e3212 >= _e3063.cutoff);
                                                            }
                                                            let _e3216 = phi_4089_;
                                                            phi_4090_ = _e3216;
                                                        } else {
                                                            phi_4090_ = false;
                                                        }
                                                        let _e3218 = phi_4090_;
                                                        phi_4091_ = _e3218;
                                                    }
                                                    let _e3220 = phi_4091_;
                                                    if _e3220 {
                                                        phi_4095_ = false;
                                                    } else {
                                                        phi_4095_ = true;
                                                    }
                                                    let _e3222 = phi_4095_;
                                                    phi_4096_ = _e3220;
                                                    phi_4097_ = _e3220;
                                                    phi_4098_ = _e3222;
                                                } else {
                                                    phi_4096_ = bool();
                                                    phi_4097_ = _e2566;
                                                    phi_4098_ = true;
                                                }
                                                let _e3224 = phi_4096_;
                                                let _e3226 = phi_4097_;
                                                let _e3228 = phi_4098_;
                                                phi_4099_ = _e3224;
                                                phi_4100_ = _e3226;
                                                phi_4101_ = _e3228;
                                            } else {
                                                phi_4099_ = bool();
                                                phi_4100_ = _e2566;
                                                phi_4101_ = true;
                                            }
                                            let _e3230 = phi_4099_;
                                            let _e3232 = phi_4100_;
                                            let _e3234 = phi_4101_;
                                            phi_4102_ = _e3230;
                                            phi_4103_ = _e3232;
                                            phi_4104_ = _e3234;
                                        } else {
                                            phi_4102_ = bool();
                                            phi_4103_ = _e2566;
                                            phi_4104_ = true;
                                        }
                                        let _e3236 = phi_4102_;
                                        let _e3238 = phi_4103_;
                                        let _e3240 = phi_4104_;
                                        if _e3240 {
                                        }
                                        phi_3302_ = (_e2564 & (_e2564 - 1u));
                                        phi_3305_ = _e3238;
                                        phi_4108_ = _e3236;
                                        phi_4109_ = _e3240;
                                    }
                                    let _e3242 = phi_3302_;
                                    let _e3244 = phi_3305_;
                                    let _e3246 = phi_4108_;
                                    let _e3248 = phi_4109_;
                                    local_24 = _e3246;
                                    continue;
                                    continuing {
                                        phi_3301_ = _e3242;
                                        phi_3304_ = _e3244;
                                        break if !(_e3248);
                                    }
                                }
                                let _e3251 = local_13;
                                if _e3251 {
                                    let _e3253 = local_1.group_mask;
                                    if ((_e3253 & 4278190080u) == 0u) {
                                        let _e3257 = local_1.len;
                                        if (_e3257 == 0u) {
                                            phi_4151_ = false;
                                        } else {
                                            let _e3261 = local_1.len;
                                            local_1.len = (_e3261 - 1u);
                                            let _e3264 = local_1.len;
                                            if (_e3264 < 32u) {
                                            } else {
                                                return;
                                            }
                                            let _e3269 = local_1.first[(0u + _e3264)];
                                            local_1.group = _e3269;
                                            let _e3272 = local_1.len;
                                            if (_e3272 < 32u) {
                                            } else {
                                                return;
                                            }
                                            let _e3277 = local_1.mask[(0u + _e3272)];
                                            local_1.group_mask = _e3277;
                                            phi_4151_ = true;
                                        }
                                        let _e3280 = phi_4151_;
                                        phi_4152_ = _e3280;
                                    } else {
                                        phi_4152_ = true;
                                    }
                                    let _e3282 = phi_4152_;
                                    if _e3282 {
                                        let _e3284 = local_1.group_mask;
                                        let _e3290 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e3284)), 32u, (_e3284 == 0u)));
                                        let _e3294 = local_1.group_mask;
                                        let _e3308 = local_1.group_mask;
                                        local_1.group_mask = (_e3308 & ~((1u << bitcast<u32>((_e3290 & 31u)))));
                                        let _e3311 = local_1.group;
                                        phi_4183_ = (_e3311 + countOneBits(((_e3294 & ~((4294967295u << bitcast<u32>((((_e3290 - 24u) ^ _e1988) & 31u))))) & 255u)));
                                    } else {
                                        phi_4183_ = 4294967295u;
                                    }
                                    let _e3314 = phi_4183_;
                                    phi_4184_ = _e3314;
                                } else {
                                    phi_4184_ = u32();
                                }
                                let _e3316 = phi_4184_;
                                phi_2970_ = _e3316;
                                let _e3776 = local_23;
                                phi_2973_ = _e3776;
                                let _e3779 = local_24;
                                phi_4185_ = _e3779;
                                let _e3782 = local_25;
                                phi_4186_ = _e3782;
                                phi_4187_ = false;
                            } else {
                                phi_2970_ = u32();
                                phi_2973_ = bool();
                                phi_4185_ = bool();
                                phi_4186_ = false;
                                phi_4187_ = true;
                            }
                            let _e3318 = phi_2970_;
                            let _e3320 = phi_2973_;
                            let _e3322 = phi_4185_;
                            let _e3324 = phi_4186_;
                            let _e3326 = phi_4187_;
                            local_14 = _e3326;
                            local_26 = _e3322;
                            continue;
                            continuing {
                                phi_2969_ = _e3318;
                                phi_2972_ = _e3320;
                                break if !(_e3324);
                            }
                        }
                        let _e3329 = local_14;
                        if _e3329 {
                            phi_4191_ = false;
                        } else {
                            phi_4191_ = true;
                        }
                        let _e3331 = phi_4191_;
                        if _e3331 {
                            let _e3788 = local_26;
                            phi_4195_ = _e3788;
                        } else {
                            let _e3790 = local_27;
                            phi_4195_ = _e3790;
                        }
                        let _e3333 = phi_4195_;
                        phi_4196_ = _e3333;
                    }
                    let _e3335 = phi_4196_;
                    phi_4197_ = _e3335;
                    phi_4198_ = _e1810;
                } else {
                    phi_4197_ = bool();
                    phi_4198_ = true;
                }
                let _e3337 = phi_4197_;
                let _e3339 = phi_4198_;
                if _e3339 {
                    phi_4202_ = false;
                } else {
                    phi_4202_ = _e3337;
                }
                let _e3341 = phi_4202_;
                phi_4203_ = _e3341;
            }
            let _e3343 = phi_4203_;
            phi_4204_ = _e3343;
        } else {
            phi_4204_ = false;
        }
        let _e3345 = phi_4204_;
        if _e3345 {
            phi_4208_ = 0f;
        } else {
            phi_4208_ = 1f;
        }
        let _e3347 = phi_4208_;
        if (_e123 < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e123)] = _e3347;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_list_light_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
