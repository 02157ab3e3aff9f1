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

struct type_24 {
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

struct type_35 {
    member: abi_ShadowParams,
}

struct lt_bvh_Node {
    frame: vec4<u32>,
    links: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    z: vec4<u32>,
}

struct type_39 {
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

struct type_43 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_47 {
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

struct type_51 {
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

struct type_62 {
    member: array<lt_bvh_Instance>,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_20;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_24;
@group(0) @binding(0) 
var<uniform> p: type_35;
@group(0) @binding(2) 
var<storage> nodes: type_39;
@group(0) @binding(3) 
var<storage> triangles: type_43;
@group(0) @binding(6) 
var<storage> instances: type_62;
@group(0) @binding(5) 
var<storage> list: type_9;
@group(0) @binding(7) 
var<storage> vertices: type_47;
@group(0) @binding(8) 
var<storage> materials: type_51;
@group(0) @binding(9) 
var<storage> alpha_texels: type_9;

fn core_intrinsics_maximum_number_nsz_f32_(param: f32, param_1: f32) -> f32 {
    var phi_208_: bool;
    var phi_212_: f32;

    if (param != param) {
        phi_208_ = true;
    } else {
        let _e69 = (param_1 >= param);
        if _e69 {
        }
        phi_208_ = _e69;
    }
    let _e71 = phi_208_;
    if _e71 {
        phi_212_ = param_1;
    } else {
        phi_212_ = param;
    }
    let _e73 = phi_212_;
    return _e73;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_2: f32, param_3: f32) -> f32 {
    var phi_224_: bool;
    var phi_228_: f32;

    if (param_2 != param_2) {
        phi_224_ = true;
    } else {
        let _e69 = (param_3 <= param_2);
        if _e69 {
        }
        phi_224_ = _e69;
    }
    let _e71 = phi_224_;
    if _e71 {
        phi_228_ = param_3;
    } else {
        phi_228_ = param_2;
    }
    let _e73 = phi_228_;
    return _e73;
}

fn _lt_shaders_texture_TextureView_quad(param_4: ptr<function, texture_TextureView>, param_5: f32, param_6: f32) -> texture_TexelQuad {
    var phi_270_: f32;
    var phi_275_: f32;
    var phi_276_: bool;
    var phi_277_: f32;
    var phi_278_: bool;
    var phi_282_: f32;
    var phi_308_: f32;
    var phi_313_: f32;
    var phi_314_: bool;
    var phi_315_: f32;
    var phi_316_: bool;
    var phi_320_: f32;
    var phi_328_: f32;
    var phi_329_: f32;
    var phi_330_: f32;
    var phi_339_: f32;
    var phi_340_: f32;
    var phi_358_: u32;
    var phi_372_: u32;
    var phi_379_: u32;
    var phi_384_: u32;
    var phi_390_: u32;
    var phi_395_: u32;
    var phi_397_: texture_Axis;
    var phi_425_: f32;
    var phi_430_: f32;
    var phi_431_: bool;
    var phi_432_: f32;
    var phi_433_: bool;
    var phi_437_: f32;
    var phi_463_: f32;
    var phi_468_: f32;
    var phi_469_: bool;
    var phi_470_: f32;
    var phi_471_: bool;
    var phi_475_: f32;
    var phi_483_: f32;
    var phi_484_: f32;
    var phi_485_: f32;
    var phi_494_: f32;
    var phi_495_: f32;
    var phi_513_: u32;
    var phi_527_: u32;
    var phi_534_: u32;
    var phi_539_: u32;
    var phi_545_: u32;
    var phi_550_: u32;
    var phi_552_: texture_Axis;

    let _e70 = (*param_4).size;
    let _e71 = (_e70 & 65535u);
    let _e73 = (*param_4).size;
    let _e75 = (_e73 >> bitcast<u32>(16i));
    let _e77 = (*param_4).flags;
    let _e79 = ((_e77 & 4u) != 0u);
    let _e81 = (*param_4).flags;
    let _e84 = ((_e81 >> bitcast<u32>(4u)) & 3u);
    if (_e84 == 0u) {
        if (param_5 > -8388608f) {
            let _e97 = f32(select(0i, select(select(i32(param_5), i32(-2147483648), (param_5 < bitcast<f32>(3472883712u))), 2147483647i, (param_5 > bitcast<f32>(1325400063u))), (param_5 == param_5)));
            if (_e97 > param_5) {
                phi_270_ = 1f;
            } else {
                phi_270_ = 0f;
            }
            let _e100 = phi_270_;
            if (param_5 < 8388608f) {
                phi_275_ = (_e97 - _e100);
                phi_276_ = false;
            } else {
                phi_275_ = f32();
                phi_276_ = true;
            }
            let _e103 = phi_275_;
            let _e105 = phi_276_;
            phi_277_ = _e103;
            phi_278_ = _e105;
        } else {
            phi_277_ = f32();
            phi_278_ = true;
        }
        let _e107 = phi_277_;
        let _e109 = phi_278_;
        if _e109 {
            phi_282_ = param_5;
        } else {
            phi_282_ = _e107;
        }
        let _e111 = phi_282_;
        phi_330_ = (param_5 - _e111);
    } else {
        if (_e84 == 1u) {
            let _e114 = (param_5 * 0.5f);
            if (_e114 > -8388608f) {
                let _e126 = f32(select(0i, select(select(i32(_e114), i32(-2147483648), (_e114 < bitcast<f32>(3472883712u))), 2147483647i, (_e114 > bitcast<f32>(1325400063u))), (_e114 == _e114)));
                if (_e126 > _e114) {
                    phi_308_ = 1f;
                } else {
                    phi_308_ = 0f;
                }
                let _e129 = phi_308_;
                if (_e114 < 8388608f) {
                    phi_313_ = (_e126 - _e129);
                    phi_314_ = false;
                } else {
                    phi_313_ = f32();
                    phi_314_ = true;
                }
                let _e132 = phi_313_;
                let _e134 = phi_314_;
                phi_315_ = _e132;
                phi_316_ = _e134;
            } else {
                phi_315_ = f32();
                phi_316_ = true;
            }
            let _e136 = phi_315_;
            let _e138 = phi_316_;
            if _e138 {
                phi_320_ = _e114;
            } else {
                phi_320_ = _e136;
            }
            let _e140 = phi_320_;
            let _e142 = (param_5 - (2f * _e140));
            if (_e142 > 1f) {
                phi_328_ = (2f - _e142);
            } else {
                phi_328_ = _e142;
            }
            let _e146 = phi_328_;
            phi_329_ = _e146;
        } else {
            phi_329_ = param_5;
        }
        let _e148 = phi_329_;
        phi_330_ = _e148;
    }
    let _e150 = phi_330_;
    if (_e150 > 0f) {
        if (_e150 < 1f) {
            phi_339_ = _e150;
        } else {
            phi_339_ = 1f;
        }
        let _e154 = phi_339_;
        phi_340_ = _e154;
    } else {
        phi_340_ = 0f;
    }
    let _e156 = phi_340_;
    let _e157 = (_e71 - 1u);
    let _e159 = (_e156 * f32(_e71));
    if _e79 {
        let _e166 = select(select(u32(_e159), 0u, (_e159 < bitcast<f32>(0u))), 4294967295u, (_e159 > bitcast<f32>(1333788671u)));
        if (_e157 < _e166) {
            phi_358_ = _e157;
        } else {
            phi_358_ = _e166;
        }
        let _e169 = phi_358_;
        phi_397_ = texture_Axis(_e169, _e169, 0f);
    } else {
        let _e171 = (_e159 + 0.5f);
        let _e178 = select(select(u32(_e171), 0u, (_e171 < bitcast<f32>(0u))), 4294967295u, (_e171 > bitcast<f32>(1333788671u)));
        if (_e71 < _e178) {
            phi_372_ = _e71;
        } else {
            phi_372_ = _e178;
        }
        let _e181 = phi_372_;
        if (_e84 == 0u) {
            phi_379_ = _e157;
        } else {
            phi_379_ = 0u;
        }
        let _e186 = phi_379_;
        if (_e84 == 0u) {
            phi_384_ = 0u;
        } else {
            phi_384_ = _e157;
        }
        let _e189 = phi_384_;
        if (_e181 == 0u) {
            phi_390_ = _e186;
        } else {
            phi_390_ = (_e181 - 1u);
        }
        let _e193 = phi_390_;
        if (_e181 > _e157) {
            phi_395_ = _e189;
        } else {
            phi_395_ = _e181;
        }
        let _e196 = phi_395_;
        phi_397_ = texture_Axis(_e193, _e196, (_e171 - f32(_e181)));
    }
    let _e199 = phi_397_;
    let _e201 = (*param_4).flags;
    let _e204 = ((_e201 >> bitcast<u32>(6u)) & 3u);
    if (_e204 == 0u) {
        if (param_6 > -8388608f) {
            let _e217 = f32(select(0i, select(select(i32(param_6), i32(-2147483648), (param_6 < bitcast<f32>(3472883712u))), 2147483647i, (param_6 > bitcast<f32>(1325400063u))), (param_6 == param_6)));
            if (_e217 > param_6) {
                phi_425_ = 1f;
            } else {
                phi_425_ = 0f;
            }
            let _e220 = phi_425_;
            if (param_6 < 8388608f) {
                phi_430_ = (_e217 - _e220);
                phi_431_ = false;
            } else {
                phi_430_ = f32();
                phi_431_ = true;
            }
            let _e223 = phi_430_;
            let _e225 = phi_431_;
            phi_432_ = _e223;
            phi_433_ = _e225;
        } else {
            phi_432_ = f32();
            phi_433_ = true;
        }
        let _e227 = phi_432_;
        let _e229 = phi_433_;
        if _e229 {
            phi_437_ = param_6;
        } else {
            phi_437_ = _e227;
        }
        let _e231 = phi_437_;
        phi_485_ = (param_6 - _e231);
    } else {
        if (_e204 == 1u) {
            let _e234 = (param_6 * 0.5f);
            if (_e234 > -8388608f) {
                let _e246 = f32(select(0i, select(select(i32(_e234), i32(-2147483648), (_e234 < bitcast<f32>(3472883712u))), 2147483647i, (_e234 > bitcast<f32>(1325400063u))), (_e234 == _e234)));
                if (_e246 > _e234) {
                    phi_463_ = 1f;
                } else {
                    phi_463_ = 0f;
                }
                let _e249 = phi_463_;
                if (_e234 < 8388608f) {
                    phi_468_ = (_e246 - _e249);
                    phi_469_ = false;
                } else {
                    phi_468_ = f32();
                    phi_469_ = true;
                }
                let _e252 = phi_468_;
                let _e254 = phi_469_;
                phi_470_ = _e252;
                phi_471_ = _e254;
            } else {
                phi_470_ = f32();
                phi_471_ = true;
            }
            let _e256 = phi_470_;
            let _e258 = phi_471_;
            if _e258 {
                phi_475_ = _e234;
            } else {
                phi_475_ = _e256;
            }
            let _e260 = phi_475_;
            let _e262 = (param_6 - (2f * _e260));
            if (_e262 > 1f) {
                phi_483_ = (2f - _e262);
            } else {
                phi_483_ = _e262;
            }
            let _e266 = phi_483_;
            phi_484_ = _e266;
        } else {
            phi_484_ = param_6;
        }
        let _e268 = phi_484_;
        phi_485_ = _e268;
    }
    let _e270 = phi_485_;
    if (_e270 > 0f) {
        if (_e270 < 1f) {
            phi_494_ = _e270;
        } else {
            phi_494_ = 1f;
        }
        let _e274 = phi_494_;
        phi_495_ = _e274;
    } else {
        phi_495_ = 0f;
    }
    let _e276 = phi_495_;
    let _e277 = (_e75 - 1u);
    let _e279 = (_e276 * f32(_e75));
    if _e79 {
        let _e286 = select(select(u32(_e279), 0u, (_e279 < bitcast<f32>(0u))), 4294967295u, (_e279 > bitcast<f32>(1333788671u)));
        if (_e277 < _e286) {
            phi_513_ = _e277;
        } else {
            phi_513_ = _e286;
        }
        let _e289 = phi_513_;
        phi_552_ = texture_Axis(_e289, _e289, 0f);
    } else {
        let _e291 = (_e279 + 0.5f);
        let _e298 = select(select(u32(_e291), 0u, (_e291 < bitcast<f32>(0u))), 4294967295u, (_e291 > bitcast<f32>(1333788671u)));
        if (_e75 < _e298) {
            phi_527_ = _e75;
        } else {
            phi_527_ = _e298;
        }
        let _e301 = phi_527_;
        if (_e204 == 0u) {
            phi_534_ = _e277;
        } else {
            phi_534_ = 0u;
        }
        let _e306 = phi_534_;
        if (_e204 == 0u) {
            phi_539_ = 0u;
        } else {
            phi_539_ = _e277;
        }
        let _e309 = phi_539_;
        if (_e301 == 0u) {
            phi_545_ = _e306;
        } else {
            phi_545_ = (_e301 - 1u);
        }
        let _e313 = phi_545_;
        if (_e301 > _e277) {
            phi_550_ = _e309;
        } else {
            phi_550_ = _e301;
        }
        let _e316 = phi_550_;
        phi_552_ = texture_Axis(_e313, _e316, (_e291 - f32(_e301)));
    }
    let _e319 = phi_552_;
    let _e323 = (*param_4).offset;
    let _e330 = (*param_4).offset;
    let _e337 = (*param_4).offset;
    let _e344 = (*param_4).offset;
    return texture_TexelQuad(array<u32, 4>(((_e323 + (_e319.low * _e71)) + _e199.low), ((_e330 + (_e319.low * _e71)) + _e199.high), ((_e337 + (_e319.high * _e71)) + _e199.low), ((_e344 + (_e319.high * _e71)) + _e199.high)), vec4<f32>(((1f - _e199.fraction) * (1f - _e319.fraction)), (_e199.fraction * (1f - _e319.fraction)), ((1f - _e199.fraction) * _e319.fraction), (_e199.fraction * _e319.fraction)));
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var local_2: lt_bvh_traverse_Stack;
    var phi_699_: f32;
    var phi_731_: bool;
    var phi_732_: bool;
    var phi_733_: bool;
    var phi_734_: bool;
    var phi_738_: bool;
    var phi_751_: bool;
    var phi_752_: bool;
    var phi_753_: bool;
    var phi_754_: bool;
    var phi_758_: bool;
    var phi_771_: bool;
    var phi_772_: bool;
    var phi_773_: bool;
    var phi_777_: bool;
    var phi_778_: bool;
    var phi_779_: bool;
    var phi_780_: bool;
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
    var phi_922_: f32;
    var phi_927_: f32;
    var phi_946_: u32;
    var phi_951_: u32;
    var phi_956_: u32;
    var phi_1070_: bool;
    var phi_1071_: bool;
    var phi_1102_: u32;
    var phi_1104_: u32;
    var phi_1107_: bool;
    var phi_1187_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1214_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1241_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1247_: u32;
    var phi_1250_: u32;
    var phi_1264_: u32;
    var phi_1274_: u32;
    var phi_1284_: u32;
    var phi_1302_: u32;
    var phi_1312_: u32;
    var phi_1322_: u32;
    var phi_1358_: u32;
    var phi_1371_: u32;
    var phi_1376_: u32;
    var phi_1377_: u32;
    var phi_1378_: u32;
    var phi_1248_: u32;
    var phi_1251_: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_1436_: u32;
    var phi_1439_: bool;
    var phi_1488_: f32;
    var phi_1493_: f32;
    var phi_1498_: f32;
    var phi_1506_: f32;
    var phi_1511_: f32;
    var phi_1516_: f32;
    var phi_1636_: bool;
    var phi_1637_: bool;
    var phi_1638_: bool;
    var phi_1639_: bool;
    var phi_1643_: bool;
    var phi_1656_: bool;
    var phi_1657_: bool;
    var phi_1658_: bool;
    var phi_1659_: bool;
    var phi_1663_: bool;
    var phi_1676_: bool;
    var phi_1677_: bool;
    var phi_1678_: bool;
    var phi_1682_: bool;
    var phi_1683_: bool;
    var phi_1684_: bool;
    var phi_1685_: bool;
    var phi_1686_: bool;
    var phi_1690_: bool;
    var phi_1760_: f32;
    var phi_1767_: f32;
    var phi_1774_: f32;
    var phi_1781_: f32;
    var phi_1788_: f32;
    var phi_1795_: f32;
    var phi_1812_: f32;
    var phi_1817_: f32;
    var phi_1822_: f32;
    var phi_1827_: f32;
    var phi_1832_: f32;
    var phi_1858_: bool;
    var phi_1859_: bool;
    var phi_1867_: u32;
    var phi_1868_: u32;
    var phi_1879_: vec3<f32>;
    var phi_1880_: vec3<f32>;
    var phi_1893_: u32;
    var phi_1898_: u32;
    var phi_1903_: u32;
    var phi_2017_: bool;
    var phi_2018_: bool;
    var phi_2049_: u32;
    var phi_2051_: u32;
    var phi_2054_: bool;
    var phi_2134_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2161_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2188_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2194_: u32;
    var phi_2197_: u32;
    var phi_2211_: u32;
    var phi_2221_: u32;
    var phi_2231_: u32;
    var phi_2249_: u32;
    var phi_2259_: u32;
    var phi_2269_: u32;
    var phi_2305_: u32;
    var phi_2318_: u32;
    var phi_2323_: u32;
    var phi_2324_: u32;
    var phi_2325_: u32;
    var phi_2195_: u32;
    var phi_2198_: u32;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_2383_: u32;
    var phi_2386_: bool;
    var phi_2430_: vec3<f32>;
    var phi_2431_: vec3<f32>;
    var phi_2460_: vec3<f32>;
    var phi_2461_: vec3<f32>;
    var phi_2490_: vec3<f32>;
    var phi_2491_: vec3<f32>;
    var phi_2509_: bool;
    var phi_2510_: bool;
    var phi_2514_: f32;
    var phi_2515_: f32;
    var phi_2516_: f32;
    var phi_2517_: f32;
    var phi_2525_: f32;
    var phi_2535_: bool;
    var phi_2536_: bool;
    var phi_2540_: f32;
    var phi_2541_: f32;
    var phi_2542_: f32;
    var phi_2543_: f32;
    var phi_2551_: f32;
    var phi_2561_: bool;
    var phi_2562_: bool;
    var phi_2566_: f32;
    var phi_2567_: f32;
    var phi_2568_: f32;
    var phi_2569_: f32;
    var phi_2577_: f32;
    var phi_2592_: f32;
    var phi_2593_: bool;
    var phi_2594_: f32;
    var phi_2595_: bool;
    var phi_2596_: f32;
    var phi_2597_: bool;
    var phi_2615_: f32;
    var phi_2616_: bool;
    var phi_2617_: bool;
    var phi_2618_: f32;
    var phi_2619_: bool;
    var phi_2620_: bool;
    var phi_2624_: bool;
    var phi_2625_: f32;
    var phi_2626_: bool;
    var phi_2654_: vec3<f32>;
    var phi_2655_: vec3<f32>;
    var phi_2680_: vec3<f32>;
    var phi_2681_: vec3<f32>;
    var phi_2706_: vec3<f32>;
    var phi_2707_: vec3<f32>;
    var phi_2763_: f32;
    var phi_2772_: f32;
    var phi_2781_: f32;
    var phi_2790_: f32;
    var phi_2797_: f32;
    var phi_2804_: f32;
    var phi_2817_: f32;
    var phi_2826_: f32;
    var phi_2835_: f32;
    var phi_2844_: f32;
    var phi_2851_: f32;
    var phi_2858_: f32;
    var phi_2875_: f32;
    var phi_2880_: f32;
    var phi_2885_: f32;
    var phi_2893_: f32;
    var phi_2898_: f32;
    var phi_2903_: f32;
    var phi_2915_: f32;
    var phi_2920_: f32;
    var phi_2925_: f32;
    var phi_2930_: f32;
    var phi_2935_: lt_bvh_triangle_Intersection;
    var phi_2936_: bool;
    var phi_2937_: lt_bvh_triangle_Intersection;
    var phi_2938_: bool;
    var phi_2942_: lt_bvh_triangle_Intersection;
    var phi_2943_: bool;
    var phi_2944_: lt_bvh_triangle_Intersection;
    var phi_2945_: bool;
    var phi_2946_: bool;
    var phi_2950_: bool;
    var phi_2954_: lt_bvh_triangle_Intersection;
    var phi_3168_: f32;
    var phi_3171_: bool;
    var phi_3172_: bool;
    var phi_3173_: bool;
    var phi_3177_: bool;
    var phi_3178_: bool;
    var phi_3179_: bool;
    var phi_3180_: bool;
    var phi_3181_: bool;
    var phi_3182_: bool;
    var phi_3183_: bool;
    var phi_3184_: bool;
    var phi_3185_: bool;
    var phi_3186_: bool;
    var phi_2384_: u32;
    var phi_2387_: bool;
    var phi_3190_: bool;
    var phi_3191_: bool;
    var local_9: bool;
    var phi_3233_: bool;
    var phi_3234_: bool;
    var phi_3265_: u32;
    var phi_3266_: u32;
    var phi_2052_: u32;
    var phi_2055_: bool;
    var phi_3267_: bool;
    var phi_3268_: bool;
    var phi_3269_: bool;
    var local_10: bool;
    var phi_3273_: bool;
    var phi_3277_: bool;
    var phi_3278_: bool;
    var phi_3279_: bool;
    var phi_3280_: bool;
    var phi_3284_: bool;
    var phi_3288_: bool;
    var phi_3289_: bool;
    var phi_3290_: bool;
    var phi_3291_: bool;
    var phi_3292_: bool;
    var phi_3293_: bool;
    var phi_3294_: bool;
    var phi_1437_: u32;
    var phi_1440_: bool;
    var phi_3298_: bool;
    var local_11: bool;
    var phi_3340_: bool;
    var phi_3341_: bool;
    var phi_3372_: u32;
    var phi_3373_: u32;
    var phi_1105_: u32;
    var phi_1108_: bool;
    var phi_3374_: bool;
    var phi_3375_: bool;
    var local_12: bool;
    var phi_3379_: bool;
    var phi_3383_: bool;
    var phi_3384_: bool;
    var phi_3385_: bool;
    var phi_3389_: bool;
    var phi_3390_: bool;
    var phi_3394_: bool;
    var phi_3398_: f32;
    var local_13: bool;
    var local_14: bool;
    var local_15: bool;
    var local_16: bool;
    var local_17: bool;
    var local_18: bool;
    var local_19: bool;

    let _e69 = id_1;
    let _e76 = arrayLength((&nodes.member));
    let _e79 = arrayLength((&triangles.member));
    let _e85 = arrayLength((&list.member));
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
        let _e111 = (_e110 & 2147483647u);
        let _e113 = p.member.root;
        if (_e111 < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e119 = samples.member[(0u + _e111)].position;
        let _e121 = samples.member[(0u + _e111)].normal;
        let _e123 = samples.member[(0u + _e111)].magnitude;
        let _e125 = ((8f / 8388608f) * _e123);
        let _e133 = (_e119.x + (_e121.x * _e125));
        let _e135 = (_e119.y + (_e121.y * _e125));
        let _e137 = (_e119.z + (_e121.z * _e125));
        let _e139 = p.member.light.place;
        if (_e139.w == 0f) {
            phi_699_ = 300000000000000000000000000000000000000f;
        } else {
            phi_699_ = 1f;
        }
        let _e143 = phi_699_;
        let _e151 = (_e139.x - (_e133 * _e139.w));
        let _e152 = (_e139.y - (_e135 * _e139.w));
        let _e153 = (_e139.z - (_e137 * _e139.w));
        let _e154 = abs(_e151);
        let _e155 = abs(_e152);
        let _e156 = abs(_e153);
        if (abs(_e133) < 1000000000000000f) {
            if (abs(_e135) < 1000000000000000f) {
                phi_731_ = (abs(_e137) < 1000000000000000f);
                phi_732_ = false;
            } else {
                phi_731_ = bool();
                phi_732_ = true;
            }
            let _e164 = phi_731_;
            let _e166 = phi_732_;
            phi_733_ = _e164;
            phi_734_ = _e166;
        } else {
            phi_733_ = bool();
            phi_734_ = true;
        }
        let _e168 = phi_733_;
        let _e170 = phi_734_;
        if _e170 {
            phi_738_ = false;
        } else {
            phi_738_ = _e168;
        }
        let _e172 = phi_738_;
        if _e172 {
            if (_e154 < 1000000000000000f) {
                if (_e155 < 1000000000000000f) {
                    phi_751_ = (_e156 < 1000000000000000f);
                    phi_752_ = false;
                } else {
                    phi_751_ = bool();
                    phi_752_ = true;
                }
                let _e177 = phi_751_;
                let _e179 = phi_752_;
                phi_753_ = _e177;
                phi_754_ = _e179;
            } else {
                phi_753_ = bool();
                phi_754_ = true;
            }
            let _e181 = phi_753_;
            let _e183 = phi_754_;
            if _e183 {
                phi_758_ = false;
            } else {
                phi_758_ = _e181;
            }
            let _e185 = phi_758_;
            if _e185 {
                if (_e154 > 0f) {
                    phi_772_ = bool();
                    phi_773_ = true;
                } else {
                    let _e187 = (_e155 > 0f);
                    if _e187 {
                        phi_771_ = bool();
                    } else {
                        phi_771_ = (_e156 > 0f);
                    }
                    let _e190 = phi_771_;
                    phi_772_ = _e190;
                    phi_773_ = _e187;
                }
                let _e192 = phi_772_;
                let _e194 = phi_773_;
                if _e194 {
                    phi_777_ = true;
                } else {
                    phi_777_ = _e192;
                }
                let _e196 = phi_777_;
                phi_778_ = _e196;
                phi_779_ = false;
            } else {
                phi_778_ = bool();
                phi_779_ = true;
            }
            let _e198 = phi_778_;
            let _e200 = phi_779_;
            phi_780_ = _e198;
            phi_781_ = _e200;
        } else {
            phi_780_ = bool();
            phi_781_ = true;
        }
        let _e202 = phi_780_;
        let _e204 = phi_781_;
        if _e204 {
            phi_785_ = false;
        } else {
            phi_785_ = _e202;
        }
        let _e206 = phi_785_;
        if _e206 {
            let _e207 = (_e113 >= _e76);
            if _e207 {
                phi_3383_ = false;
            } else {
                if (_e113 < _e76) {
                } else {
                    return;
                }
                let _e213 = nodes.member[(0u + _e113)].frame[0u];
                let _e217 = nodes.member[(0u + _e113)].frame[1u];
                let _e221 = nodes.member[(0u + _e113)].frame[2u];
                let _e225 = nodes.member[(0u + _e113)].frame[0u];
                let _e229 = nodes.member[(0u + _e113)].frame[1u];
                let _e233 = nodes.member[(0u + _e113)].frame[2u];
                let _e237 = nodes.member[(0u + _e113)].frame[3u];
                let _e271 = core_intrinsics_maximum_number_nsz_f32_(abs(_e151), abs(_e152));
                let _e272 = core_intrinsics_maximum_number_nsz_f32_(_e271, abs(_e153));
                let _e273 = (_e272 * 0.0000000000009094947f);
                if (abs(_e151) < _e273) {
                    phi_855_ = _e273;
                } else {
                    phi_855_ = abs(_e151);
                }
                let _e278 = phi_855_;
                if (_e151 < 0f) {
                    phi_862_ = (-1f / _e278);
                } else {
                    phi_862_ = (1f / _e278);
                }
                let _e283 = phi_862_;
                if (abs(_e152) < _e273) {
                    phi_869_ = _e273;
                } else {
                    phi_869_ = abs(_e152);
                }
                let _e288 = phi_869_;
                if (_e152 < 0f) {
                    phi_876_ = (-1f / _e288);
                } else {
                    phi_876_ = (1f / _e288);
                }
                let _e293 = phi_876_;
                if (abs(_e153) < _e273) {
                    phi_883_ = _e273;
                } else {
                    phi_883_ = abs(_e153);
                }
                let _e298 = phi_883_;
                if (_e153 < 0f) {
                    phi_890_ = (-1f / _e298);
                } else {
                    phi_890_ = (1f / _e298);
                }
                let _e303 = phi_890_;
                let _e307 = abs((bitcast<f32>(_e213) - _e133));
                let _e308 = abs((bitcast<f32>(_e217) - _e135));
                let _e309 = abs((bitcast<f32>(_e221) - _e137));
                let _e313 = abs(((bitcast<f32>(_e225) + (bitcast<f32>((((_e237 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e133));
                let _e314 = abs(((bitcast<f32>(_e229) + (bitcast<f32>((((_e237 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e135));
                let _e315 = abs(((bitcast<f32>(_e233) + (bitcast<f32>((((_e237 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e137));
                if (_e307 > _e313) {
                    phi_907_ = _e307;
                } else {
                    phi_907_ = _e313;
                }
                let _e318 = phi_907_;
                if (_e308 > _e314) {
                    phi_912_ = _e308;
                } else {
                    phi_912_ = _e314;
                }
                let _e321 = phi_912_;
                if (_e309 > _e315) {
                    phi_917_ = _e309;
                } else {
                    phi_917_ = _e315;
                }
                let _e324 = phi_917_;
                if (_e318 > _e321) {
                    phi_922_ = _e318;
                } else {
                    phi_922_ = _e321;
                }
                let _e327 = phi_922_;
                if (_e327 > _e324) {
                    phi_927_ = _e327;
                } else {
                    phi_927_ = _e324;
                }
                let _e330 = phi_927_;
                let _e334 = (_e330 * 0.0000019073486f);
                let _e335 = (abs(_e283) * _e334);
                let _e336 = (abs(_e293) * _e334);
                let _e337 = (abs(_e303) * _e334);
                let _e341 = (_e330 * 0.0000009536743f);
                let _e342 = (abs(_e283) * _e341);
                let _e343 = (abs(_e293) * _e341);
                let _e344 = (abs(_e303) * _e341);
                if (_e283 < 0f) {
                    phi_946_ = 0u;
                } else {
                    phi_946_ = 1u;
                }
                let _e347 = phi_946_;
                if (_e293 < 0f) {
                    phi_951_ = 0u;
                } else {
                    phi_951_ = 2u;
                }
                let _e350 = phi_951_;
                if (_e303 < 0f) {
                    phi_956_ = 0u;
                } else {
                    phi_956_ = 4u;
                }
                let _e353 = phi_956_;
                let _e355 = ((_e347 | _e350) | _e353);
                let _e356 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e113, 2147483648u);
                local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e356.first[0], _e356.first[1], _e356.first[2], _e356.first[3], _e356.first[4], _e356.first[5], _e356.first[6], _e356.first[7], _e356.first[8], _e356.first[9], _e356.first[10], _e356.first[11], _e356.first[12], _e356.first[13], _e356.first[14], _e356.first[15], _e356.first[16], _e356.first[17], _e356.first[18], _e356.first[19], _e356.first[20], _e356.first[21], _e356.first[22], _e356.first[23], _e356.first[24], _e356.first[25], _e356.first[26], _e356.first[27], _e356.first[28], _e356.first[29], _e356.first[30], _e356.first[31]), array<u32, 32>(_e356.mask[0], _e356.mask[1], _e356.mask[2], _e356.mask[3], _e356.mask[4], _e356.mask[5], _e356.mask[6], _e356.mask[7], _e356.mask[8], _e356.mask[9], _e356.mask[10], _e356.mask[11], _e356.mask[12], _e356.mask[13], _e356.mask[14], _e356.mask[15], _e356.mask[16], _e356.mask[17], _e356.mask[18], _e356.mask[19], _e356.mask[20], _e356.mask[21], _e356.mask[22], _e356.mask[23], _e356.mask[24], _e356.mask[25], _e356.mask[26], _e356.mask[27], _e356.mask[28], _e356.mask[29], _e356.mask[30], _e356.mask[31]), _e356.len, _e356.group, _e356.group_mask);
                let _e430 = local_2.group_mask;
                if ((_e430 & 4278190080u) == 0u) {
                    let _e434 = local_2.len;
                    if (_e434 == 0u) {
                        phi_1070_ = false;
                    } else {
                        let _e438 = local_2.len;
                        local_2.len = (_e438 - 1u);
                        let _e441 = local_2.len;
                        if (_e441 < 32u) {
                        } else {
                            return;
                        }
                        let _e446 = local_2.first[(0u + _e441)];
                        local_2.group = _e446;
                        let _e449 = local_2.len;
                        if (_e449 < 32u) {
                        } else {
                            return;
                        }
                        let _e454 = local_2.mask[(0u + _e449)];
                        local_2.group_mask = _e454;
                        phi_1070_ = true;
                    }
                    let _e457 = phi_1070_;
                    phi_1071_ = _e457;
                } else {
                    phi_1071_ = true;
                }
                let _e459 = phi_1071_;
                if _e459 {
                    let _e461 = local_2.group_mask;
                    let _e467 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e461)), 32u, (_e461 == 0u)));
                    let _e471 = local_2.group_mask;
                    let _e485 = local_2.group_mask;
                    local_2.group_mask = (_e485 & ~((1u << bitcast<u32>((_e467 & 31u)))));
                    let _e488 = local_2.group;
                    phi_1102_ = (_e488 + countOneBits(((_e471 & ~((4294967295u << bitcast<u32>((((_e467 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1102_ = 4294967295u;
                }
                let _e491 = phi_1102_;
                phi_1104_ = _e491;
                phi_1107_ = false;
                loop {
                    let _e493 = phi_1104_;
                    let _e495 = phi_1107_;
                    if (_e493 != 4294967295u) {
                        if (_e493 < _e76) {
                        } else {
                            return;
                        }
                        let _e502 = nodes.member[(0u + _e493)].frame[3u];
                        let _e527 = (bitcast<f32>((((_e502 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e283);
                        let _e528 = (bitcast<f32>((((_e502 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e293);
                        let _e529 = (bitcast<f32>((((_e502 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e303);
                        let _e532 = nodes.member[(0u + _e493)].frame[0u];
                        let _e536 = nodes.member[(0u + _e493)].frame[1u];
                        let _e540 = nodes.member[(0u + _e493)].frame[2u];
                        let _e545 = ((bitcast<f32>(_e532) - _e133) * _e283);
                        let _e546 = ((bitcast<f32>(_e536) - _e135) * _e293);
                        let _e547 = ((bitcast<f32>(_e540) - _e137) * _e303);
                        let _e555 = nodes.member[(0u + _e493)].x;
                        if (_e283 < 0f) {
                            let _e566 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e555.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e572 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e566.unnamed.root, _e555.w), _e566.unnamed_1);
                            let _e578 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e572.unnamed, lt_bvh_traverse_Tree(_e555.x, _e572.unnamed_1.first_primitive));
                            phi_1187_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e578.unnamed, lt_bvh_traverse_Tree(_e578.unnamed_1.root, _e555.y));
                        } else {
                            let _e594 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e555.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e600 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e594.unnamed.root, _e555.y), _e594.unnamed_1);
                            let _e606 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e600.unnamed, lt_bvh_traverse_Tree(_e555.z, _e600.unnamed_1.first_primitive));
                            phi_1187_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e606.unnamed, lt_bvh_traverse_Tree(_e606.unnamed_1.root, _e555.w));
                        }
                        let _e614 = phi_1187_;
                        let _e624 = nodes.member[(0u + _e493)].y;
                        if (_e293 < 0f) {
                            let _e635 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e624.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e641 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e635.unnamed.root, _e624.w), _e635.unnamed_1);
                            let _e647 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e641.unnamed, lt_bvh_traverse_Tree(_e624.x, _e641.unnamed_1.first_primitive));
                            phi_1214_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e647.unnamed, lt_bvh_traverse_Tree(_e647.unnamed_1.root, _e624.y));
                        } else {
                            let _e663 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e624.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e669 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e663.unnamed.root, _e624.y), _e663.unnamed_1);
                            let _e675 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e669.unnamed, lt_bvh_traverse_Tree(_e624.z, _e669.unnamed_1.first_primitive));
                            phi_1214_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e675.unnamed, lt_bvh_traverse_Tree(_e675.unnamed_1.root, _e624.w));
                        }
                        let _e683 = phi_1214_;
                        let _e693 = nodes.member[(0u + _e493)].z;
                        if (_e303 < 0f) {
                            let _e704 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e693.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e710 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e704.unnamed.root, _e693.w), _e704.unnamed_1);
                            let _e716 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e710.unnamed, lt_bvh_traverse_Tree(_e693.x, _e710.unnamed_1.first_primitive));
                            phi_1241_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e716.unnamed, lt_bvh_traverse_Tree(_e716.unnamed_1.root, _e693.y));
                        } else {
                            let _e732 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e693.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e738 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e732.unnamed.root, _e693.y), _e732.unnamed_1);
                            let _e744 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e738.unnamed, lt_bvh_traverse_Tree(_e693.z, _e738.unnamed_1.first_primitive));
                            phi_1241_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e744.unnamed, lt_bvh_traverse_Tree(_e744.unnamed_1.root, _e693.w));
                        }
                        let _e752 = phi_1241_;
                        phi_1247_ = 0u;
                        phi_1250_ = 0u;
                        loop {
                            let _e762 = phi_1247_;
                            let _e764 = phi_1250_;
                            local_3 = _e764;
                            local_4 = _e764;
                            local_5 = _e764;
                            let _e765 = (_e762 < 8u);
                            if _e765 {
                                let _e767 = (_e762 >> bitcast<u32>(2i));
                                let _e768 = (_e762 & 3u);
                                if (_e767 == 0u) {
                                    phi_1264_ = _e614.unnamed.root;
                                } else {
                                    phi_1264_ = _e614.unnamed.first_primitive;
                                }
                                let _e771 = phi_1264_;
                                if (_e767 == 0u) {
                                    phi_1274_ = _e683.unnamed.root;
                                } else {
                                    phi_1274_ = _e683.unnamed.first_primitive;
                                }
                                let _e780 = phi_1274_;
                                if (_e767 == 0u) {
                                    phi_1284_ = _e752.unnamed.root;
                                } else {
                                    phi_1284_ = _e752.unnamed.first_primitive;
                                }
                                let _e789 = phi_1284_;
                                let _e802 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e771 >> bitcast<u32>(((_e768 * 8u) & 31u))) & 255u)) * _e527) + (_e545 - _e335)), ((f32(((_e780 >> bitcast<u32>(((_e768 * 8u) & 31u))) & 255u)) * _e528) + (_e546 - _e336)));
                                let _e803 = core_intrinsics_maximum_number_nsz_f32_(_e802, ((f32(((_e789 >> bitcast<u32>(((_e768 * 8u) & 31u))) & 255u)) * _e529) + (_e547 - _e337)));
                                if (_e767 == 0u) {
                                    phi_1302_ = _e614.unnamed_1.root;
                                } else {
                                    phi_1302_ = _e614.unnamed_1.first_primitive;
                                }
                                let _e806 = phi_1302_;
                                if (_e767 == 0u) {
                                    phi_1312_ = _e683.unnamed_1.root;
                                } else {
                                    phi_1312_ = _e683.unnamed_1.first_primitive;
                                }
                                let _e815 = phi_1312_;
                                if (_e767 == 0u) {
                                    phi_1322_ = _e752.unnamed_1.root;
                                } else {
                                    phi_1322_ = _e752.unnamed_1.first_primitive;
                                }
                                let _e824 = phi_1322_;
                                let _e837 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e806 >> bitcast<u32>(((_e768 * 8u) & 31u))) & 255u)) * _e527) + (_e545 + _e335)), ((f32(((_e815 >> bitcast<u32>(((_e768 * 8u) & 31u))) & 255u)) * _e528) + (_e546 + _e336)));
                                let _e838 = core_intrinsics_minimum_number_nsz_f32_(_e837, ((f32(((_e824 >> bitcast<u32>(((_e768 * 8u) & 31u))) & 255u)) * _e529) + (_e547 + _e337)));
                                if (_e803 <= _e838) {
                                    if (_e803 <= _e143) {
                                        if (_e838 >= 0f) {
                                            if (_e767 == 0u) {
                                                let _e845 = nodes.member[(0u + _e493)].links[2u];
                                                phi_1358_ = _e845;
                                            } else {
                                                let _e848 = nodes.member[(0u + _e493)].links[3u];
                                                phi_1358_ = _e848;
                                            }
                                            let _e850 = phi_1358_;
                                            let _e855 = ((_e850 >> bitcast<u32>(((_e768 * 8u) & 31u))) & 255u);
                                            let _e856 = (_e855 & 31u);
                                            if (_e856 >= 24u) {
                                                phi_1371_ = (24u + ((_e856 - 24u) ^ _e355));
                                            } else {
                                                phi_1371_ = _e856;
                                            }
                                            let _e862 = phi_1371_;
                                            phi_1376_ = (_e764 | ((_e855 >> bitcast<u32>(5i)) << bitcast<u32>((_e862 & 31u))));
                                        } else {
                                            phi_1376_ = _e764;
                                        }
                                        let _e870 = phi_1376_;
                                        phi_1377_ = _e870;
                                    } else {
                                        phi_1377_ = _e764;
                                    }
                                    let _e872 = phi_1377_;
                                    phi_1378_ = _e872;
                                } else {
                                    phi_1378_ = _e764;
                                }
                                let _e874 = phi_1378_;
                                phi_1248_ = (_e762 + 1u);
                                phi_1251_ = _e874;
                            } else {
                                phi_1248_ = u32();
                                phi_1251_ = u32();
                            }
                            let _e877 = phi_1248_;
                            let _e879 = phi_1251_;
                            continue;
                            continuing {
                                phi_1247_ = _e877;
                                phi_1250_ = _e879;
                                break if !(_e765);
                            }
                        }
                        let _e883 = nodes.member[(0u + _e493)].links[0u];
                        let _e887 = nodes.member[(0u + _e493)].frame[3u];
                        let _e891 = local_3;
                        if ((_e891 & 4278190080u) == 0u) {
                        } else {
                            let _e895 = local_2.group_mask;
                            if ((_e895 & 4278190080u) == 0u) {
                            } else {
                                let _e899 = local_2.len;
                                if (_e899 < 32u) {
                                    let _e902 = local_2.group;
                                    let _e904 = local_2.len;
                                    if (_e904 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.first[(0u + _e904)] = _e902;
                                    let _e910 = local_2.group_mask;
                                    let _e912 = local_2.len;
                                    if (_e912 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.mask[(0u + _e912)] = _e910;
                                    let _e919 = local_2.len;
                                    local_2.len = (_e919 + 1u);
                                }
                            }
                            local_2.group = (_e113 + _e883);
                            let _e923 = local_4;
                            local_2.group_mask = ((_e923 & 4278190080u) | (_e887 >> bitcast<u32>(24i)));
                        }
                        let _e928 = local_5;
                        phi_1436_ = (_e928 & 16777215u);
                        phi_1439_ = _e495;
                        loop {
                            let _e931 = phi_1436_;
                            let _e933 = phi_1439_;
                            local_18 = _e933;
                            let _e934 = (_e931 == 0u);
                            local_11 = _e934;
                            local_19 = _e934;
                            if _e934 {
                                phi_1437_ = u32();
                                phi_1440_ = bool();
                                phi_3298_ = false;
                            } else {
                                let _e937 = nodes.member[(0u + _e493)].links[1u];
                                let _e941 = (_e937 + select(firstTrailingBit(_e931), 32u, (_e931 == 0u)));
                                if (_e941 < arrayLength((&instances.member))) {
                                } else {
                                    return;
                                }
                                let _e948 = instances.member[(0u + _e941)].low_world;
                                let _e950 = instances.member[(0u + _e941)].high_world;
                                let _e957 = ((_e948.x - _e133) * _e283);
                                let _e958 = ((_e948.y - _e135) * _e293);
                                let _e959 = ((_e948.z - _e137) * _e303);
                                let _e966 = ((_e950.x - _e133) * _e283);
                                let _e967 = ((_e950.y - _e135) * _e293);
                                let _e968 = ((_e950.z - _e137) * _e303);
                                if (_e957 < _e966) {
                                    phi_1488_ = _e957;
                                } else {
                                    phi_1488_ = _e966;
                                }
                                let _e971 = phi_1488_;
                                if (_e958 < _e967) {
                                    phi_1493_ = _e958;
                                } else {
                                    phi_1493_ = _e967;
                                }
                                let _e974 = phi_1493_;
                                if (_e959 < _e968) {
                                    phi_1498_ = _e959;
                                } else {
                                    phi_1498_ = _e968;
                                }
                                let _e977 = phi_1498_;
                                if (_e957 > _e966) {
                                    phi_1506_ = _e957;
                                } else {
                                    phi_1506_ = _e966;
                                }
                                let _e983 = phi_1506_;
                                if (_e958 > _e967) {
                                    phi_1511_ = _e958;
                                } else {
                                    phi_1511_ = _e967;
                                }
                                let _e986 = phi_1511_;
                                if (_e959 > _e968) {
                                    phi_1516_ = _e959;
                                } else {
                                    phi_1516_ = _e968;
                                }
                                let _e989 = phi_1516_;
                                let _e993 = core_intrinsics_maximum_number_nsz_f32_((_e971 - _e342), (_e974 - _e343));
                                let _e994 = core_intrinsics_maximum_number_nsz_f32_(_e993, (_e977 - _e344));
                                let _e995 = core_intrinsics_minimum_number_nsz_f32_((_e983 + _e342), (_e986 + _e343));
                                let _e996 = core_intrinsics_minimum_number_nsz_f32_(_e995, (_e989 + _e344));
                                if (_e994 <= _e996) {
                                    if (_e994 <= _e143) {
                                        if (_e996 >= 0f) {
                                            let _e1002 = instances.member[(0u + _e941)].world_to_object[0u];
                                            let _e1013 = ((((_e1002.x * _e133) + (_e1002.y * _e135)) + (_e1002.z * _e137)) + (_e1002.w * 1f));
                                            let _e1015 = instances.member[(0u + _e941)].world_to_object[1u];
                                            let _e1026 = ((((_e1015.x * _e133) + (_e1015.y * _e135)) + (_e1015.z * _e137)) + (_e1015.w * 1f));
                                            let _e1028 = instances.member[(0u + _e941)].world_to_object[2u];
                                            let _e1039 = ((((_e1028.x * _e133) + (_e1028.y * _e135)) + (_e1028.z * _e137)) + (_e1028.w * 1f));
                                            let _e1042 = instances.member[(0u + _e941)].world_to_object[0u];
                                            let _e1053 = ((((_e1042.x * _e151) + (_e1042.y * _e152)) + (_e1042.z * _e153)) + (_e1042.w * 0f));
                                            let _e1055 = instances.member[(0u + _e941)].world_to_object[1u];
                                            let _e1066 = ((((_e1055.x * _e151) + (_e1055.y * _e152)) + (_e1055.z * _e153)) + (_e1055.w * 0f));
                                            let _e1068 = instances.member[(0u + _e941)].world_to_object[2u];
                                            let _e1079 = ((((_e1068.x * _e151) + (_e1068.y * _e152)) + (_e1068.z * _e153)) + (_e1068.w * 0f));
                                            let _e1082 = instances.member[(0u + _e941)].root;
                                            let _e1084 = instances.member[(0u + _e941)].first_triangle;
                                            let _e1085 = abs(_e1053);
                                            let _e1086 = abs(_e1066);
                                            let _e1087 = abs(_e1079);
                                            if (abs(_e1013) < 1000000000000000f) {
                                                if (abs(_e1026) < 1000000000000000f) {
                                                    phi_1636_ = (abs(_e1039) < 1000000000000000f);
                                                    phi_1637_ = false;
                                                } else {
                                                    phi_1636_ = bool();
                                                    phi_1637_ = true;
                                                }
                                                let _e1095 = phi_1636_;
                                                let _e1097 = phi_1637_;
                                                phi_1638_ = _e1095;
                                                phi_1639_ = _e1097;
                                            } else {
                                                phi_1638_ = bool();
                                                phi_1639_ = true;
                                            }
                                            let _e1099 = phi_1638_;
                                            let _e1101 = phi_1639_;
                                            if _e1101 {
                                                phi_1643_ = false;
                                            } else {
                                                phi_1643_ = _e1099;
                                            }
                                            let _e1103 = phi_1643_;
                                            if _e1103 {
                                                if (_e1085 < 1000000000000000f) {
                                                    if (_e1086 < 1000000000000000f) {
                                                        phi_1656_ = (_e1087 < 1000000000000000f);
                                                        phi_1657_ = false;
                                                    } else {
                                                        phi_1656_ = bool();
                                                        phi_1657_ = true;
                                                    }
                                                    let _e1108 = phi_1656_;
                                                    let _e1110 = phi_1657_;
                                                    phi_1658_ = _e1108;
                                                    phi_1659_ = _e1110;
                                                } else {
                                                    phi_1658_ = bool();
                                                    phi_1659_ = true;
                                                }
                                                let _e1112 = phi_1658_;
                                                let _e1114 = phi_1659_;
                                                if _e1114 {
                                                    phi_1663_ = false;
                                                } else {
                                                    phi_1663_ = _e1112;
                                                }
                                                let _e1116 = phi_1663_;
                                                if _e1116 {
                                                    if (_e1085 > 0f) {
                                                        phi_1677_ = bool();
                                                        phi_1678_ = true;
                                                    } else {
                                                        let _e1118 = (_e1086 > 0f);
                                                        if _e1118 {
                                                            phi_1676_ = bool();
                                                        } else {
                                                            phi_1676_ = (_e1087 > 0f);
                                                        }
                                                        let _e1121 = phi_1676_;
                                                        phi_1677_ = _e1121;
                                                        phi_1678_ = _e1118;
                                                    }
                                                    let _e1123 = phi_1677_;
                                                    let _e1125 = phi_1678_;
                                                    if _e1125 {
                                                        phi_1682_ = true;
                                                    } else {
                                                        phi_1682_ = _e1123;
                                                    }
                                                    let _e1127 = phi_1682_;
                                                    phi_1683_ = _e1127;
                                                    phi_1684_ = false;
                                                } else {
                                                    phi_1683_ = bool();
                                                    phi_1684_ = true;
                                                }
                                                let _e1129 = phi_1683_;
                                                let _e1131 = phi_1684_;
                                                phi_1685_ = _e1129;
                                                phi_1686_ = _e1131;
                                            } else {
                                                phi_1685_ = bool();
                                                phi_1686_ = true;
                                            }
                                            let _e1133 = phi_1685_;
                                            let _e1135 = phi_1686_;
                                            if _e1135 {
                                                phi_1690_ = false;
                                            } else {
                                                phi_1690_ = _e1133;
                                            }
                                            let _e1137 = phi_1690_;
                                            if _e1137 {
                                                let _e1138 = (_e1082 >= _e76);
                                                if _e1138 {
                                                    phi_3278_ = bool();
                                                } else {
                                                    if (_e1082 < _e76) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1144 = nodes.member[(0u + _e1082)].frame[0u];
                                                    let _e1148 = nodes.member[(0u + _e1082)].frame[1u];
                                                    let _e1152 = nodes.member[(0u + _e1082)].frame[2u];
                                                    let _e1156 = nodes.member[(0u + _e1082)].frame[0u];
                                                    let _e1160 = nodes.member[(0u + _e1082)].frame[1u];
                                                    let _e1164 = nodes.member[(0u + _e1082)].frame[2u];
                                                    let _e1168 = nodes.member[(0u + _e1082)].frame[3u];
                                                    let _e1202 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1053), abs(_e1066));
                                                    let _e1203 = core_intrinsics_maximum_number_nsz_f32_(_e1202, abs(_e1079));
                                                    let _e1204 = (_e1203 * 0.0000000000009094947f);
                                                    if (abs(_e1053) < _e1204) {
                                                        phi_1760_ = _e1204;
                                                    } else {
                                                        phi_1760_ = abs(_e1053);
                                                    }
                                                    let _e1209 = phi_1760_;
                                                    if (_e1053 < 0f) {
                                                        phi_1767_ = (-1f / _e1209);
                                                    } else {
                                                        phi_1767_ = (1f / _e1209);
                                                    }
                                                    let _e1214 = phi_1767_;
                                                    if (abs(_e1066) < _e1204) {
                                                        phi_1774_ = _e1204;
                                                    } else {
                                                        phi_1774_ = abs(_e1066);
                                                    }
                                                    let _e1219 = phi_1774_;
                                                    if (_e1066 < 0f) {
                                                        phi_1781_ = (-1f / _e1219);
                                                    } else {
                                                        phi_1781_ = (1f / _e1219);
                                                    }
                                                    let _e1224 = phi_1781_;
                                                    if (abs(_e1079) < _e1204) {
                                                        phi_1788_ = _e1204;
                                                    } else {
                                                        phi_1788_ = abs(_e1079);
                                                    }
                                                    let _e1229 = phi_1788_;
                                                    if (_e1079 < 0f) {
                                                        phi_1795_ = (-1f / _e1229);
                                                    } else {
                                                        phi_1795_ = (1f / _e1229);
                                                    }
                                                    let _e1234 = phi_1795_;
                                                    let _e1238 = abs((bitcast<f32>(_e1144) - _e1013));
                                                    let _e1239 = abs((bitcast<f32>(_e1148) - _e1026));
                                                    let _e1240 = abs((bitcast<f32>(_e1152) - _e1039));
                                                    let _e1244 = abs(((bitcast<f32>(_e1156) + (bitcast<f32>((((_e1168 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1013));
                                                    let _e1245 = abs(((bitcast<f32>(_e1160) + (bitcast<f32>((((_e1168 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1026));
                                                    let _e1246 = abs(((bitcast<f32>(_e1164) + (bitcast<f32>((((_e1168 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1039));
                                                    if (_e1238 > _e1244) {
                                                        phi_1812_ = _e1238;
                                                    } else {
                                                        phi_1812_ = _e1244;
                                                    }
                                                    let _e1249 = phi_1812_;
                                                    if (_e1239 > _e1245) {
                                                        phi_1817_ = _e1239;
                                                    } else {
                                                        phi_1817_ = _e1245;
                                                    }
                                                    let _e1252 = phi_1817_;
                                                    if (_e1240 > _e1246) {
                                                        phi_1822_ = _e1240;
                                                    } else {
                                                        phi_1822_ = _e1246;
                                                    }
                                                    let _e1255 = phi_1822_;
                                                    if (_e1249 > _e1252) {
                                                        phi_1827_ = _e1249;
                                                    } else {
                                                        phi_1827_ = _e1252;
                                                    }
                                                    let _e1258 = phi_1827_;
                                                    if (_e1258 > _e1255) {
                                                        phi_1832_ = _e1258;
                                                    } else {
                                                        phi_1832_ = _e1255;
                                                    }
                                                    let _e1261 = phi_1832_;
                                                    let _e1265 = (_e1261 * 0.0000019073486f);
                                                    let _e1266 = (abs(_e1214) * _e1265);
                                                    let _e1267 = (abs(_e1224) * _e1265);
                                                    let _e1268 = (abs(_e1234) * _e1265);
                                                    let _e1272 = (_e1261 * 0.0000009536743f);
                                                    let _e1273 = (abs(_e1214) * _e1272);
                                                    let _e1274 = (abs(_e1224) * _e1272);
                                                    let _e1275 = (abs(_e1234) * _e1272);
                                                    let _e1276 = abs(_e1053);
                                                    let _e1277 = abs(_e1066);
                                                    let _e1278 = abs(_e1079);
                                                    if (_e1276 >= _e1277) {
                                                        if (_e1276 >= _e1278) {
                                                            phi_1858_ = false;
                                                        } else {
                                                            phi_1858_ = true;
                                                        }
                                                        let _e1282 = phi_1858_;
                                                        phi_1859_ = _e1282;
                                                    } else {
                                                        phi_1859_ = true;
                                                    }
                                                    let _e1284 = phi_1859_;
                                                    if _e1284 {
                                                        if (_e1277 >= _e1278) {
                                                            phi_1867_ = 1u;
                                                        } else {
                                                            phi_1867_ = 2u;
                                                        }
                                                        let _e1287 = phi_1867_;
                                                        phi_1868_ = _e1287;
                                                    } else {
                                                        phi_1868_ = 0u;
                                                    }
                                                    let _e1289 = phi_1868_;
                                                    if (_e1289 == 0u) {
                                                        phi_1880_ = vec3<f32>(_e1066, _e1079, _e1053);
                                                    } else {
                                                        if (_e1289 == 1u) {
                                                            phi_1879_ = vec3<f32>(_e1079, _e1053, _e1066);
                                                        } else {
                                                            phi_1879_ = vec3<f32>(_e1053, _e1066, _e1079);
                                                        }
                                                        let _e1295 = phi_1879_;
                                                        phi_1880_ = _e1295;
                                                    }
                                                    let _e1297 = phi_1880_;
                                                    let _e1300 = (_e1297.x / _e1297.z);
                                                    let _e1303 = (_e1297.y / _e1297.z);
                                                    if (_e1214 < 0f) {
                                                        phi_1893_ = 0u;
                                                    } else {
                                                        phi_1893_ = 1u;
                                                    }
                                                    let _e1308 = phi_1893_;
                                                    if (_e1224 < 0f) {
                                                        phi_1898_ = 0u;
                                                    } else {
                                                        phi_1898_ = 2u;
                                                    }
                                                    let _e1311 = phi_1898_;
                                                    if (_e1234 < 0f) {
                                                        phi_1903_ = 0u;
                                                    } else {
                                                        phi_1903_ = 4u;
                                                    }
                                                    let _e1314 = phi_1903_;
                                                    let _e1316 = ((_e1308 | _e1311) | _e1314);
                                                    let _e1317 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1082, 2147483648u);
                                                    local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e1317.first[0], _e1317.first[1], _e1317.first[2], _e1317.first[3], _e1317.first[4], _e1317.first[5], _e1317.first[6], _e1317.first[7], _e1317.first[8], _e1317.first[9], _e1317.first[10], _e1317.first[11], _e1317.first[12], _e1317.first[13], _e1317.first[14], _e1317.first[15], _e1317.first[16], _e1317.first[17], _e1317.first[18], _e1317.first[19], _e1317.first[20], _e1317.first[21], _e1317.first[22], _e1317.first[23], _e1317.first[24], _e1317.first[25], _e1317.first[26], _e1317.first[27], _e1317.first[28], _e1317.first[29], _e1317.first[30], _e1317.first[31]), array<u32, 32>(_e1317.mask[0], _e1317.mask[1], _e1317.mask[2], _e1317.mask[3], _e1317.mask[4], _e1317.mask[5], _e1317.mask[6], _e1317.mask[7], _e1317.mask[8], _e1317.mask[9], _e1317.mask[10], _e1317.mask[11], _e1317.mask[12], _e1317.mask[13], _e1317.mask[14], _e1317.mask[15], _e1317.mask[16], _e1317.mask[17], _e1317.mask[18], _e1317.mask[19], _e1317.mask[20], _e1317.mask[21], _e1317.mask[22], _e1317.mask[23], _e1317.mask[24], _e1317.mask[25], _e1317.mask[26], _e1317.mask[27], _e1317.mask[28], _e1317.mask[29], _e1317.mask[30], _e1317.mask[31]), _e1317.len, _e1317.group, _e1317.group_mask);
                                                    let _e1391 = local_1.group_mask;
                                                    if ((_e1391 & 4278190080u) == 0u) {
                                                        let _e1395 = local_1.len;
                                                        if (_e1395 == 0u) {
                                                            phi_2017_ = false;
                                                        } else {
                                                            let _e1399 = local_1.len;
                                                            local_1.len = (_e1399 - 1u);
                                                            let _e1402 = local_1.len;
                                                            if (_e1402 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1407 = local_1.first[(0u + _e1402)];
                                                            local_1.group = _e1407;
                                                            let _e1410 = local_1.len;
                                                            if (_e1410 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1415 = local_1.mask[(0u + _e1410)];
                                                            local_1.group_mask = _e1415;
                                                            phi_2017_ = true;
                                                        }
                                                        let _e1418 = phi_2017_;
                                                        phi_2018_ = _e1418;
                                                    } else {
                                                        phi_2018_ = true;
                                                    }
                                                    let _e1420 = phi_2018_;
                                                    if _e1420 {
                                                        let _e1422 = local_1.group_mask;
                                                        let _e1428 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1422)), 32u, (_e1422 == 0u)));
                                                        let _e1432 = local_1.group_mask;
                                                        let _e1446 = local_1.group_mask;
                                                        local_1.group_mask = (_e1446 & ~((1u << bitcast<u32>((_e1428 & 31u)))));
                                                        let _e1449 = local_1.group;
                                                        phi_2049_ = (_e1449 + countOneBits(((_e1432 & ~((4294967295u << bitcast<u32>((((_e1428 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_2049_ = 4294967295u;
                                                    }
                                                    let _e1452 = phi_2049_;
                                                    phi_2051_ = _e1452;
                                                    phi_2054_ = _e933;
                                                    loop {
                                                        let _e1454 = phi_2051_;
                                                        let _e1456 = phi_2054_;
                                                        local_17 = _e1456;
                                                        if (_e1454 != 4294967295u) {
                                                            if (_e1454 < _e76) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1463 = nodes.member[(0u + _e1454)].frame[3u];
                                                            let _e1488 = (bitcast<f32>((((_e1463 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1214);
                                                            let _e1489 = (bitcast<f32>((((_e1463 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1224);
                                                            let _e1490 = (bitcast<f32>((((_e1463 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1234);
                                                            let _e1493 = nodes.member[(0u + _e1454)].frame[0u];
                                                            let _e1497 = nodes.member[(0u + _e1454)].frame[1u];
                                                            let _e1501 = nodes.member[(0u + _e1454)].frame[2u];
                                                            let _e1506 = ((bitcast<f32>(_e1493) - _e1013) * _e1214);
                                                            let _e1507 = ((bitcast<f32>(_e1497) - _e1026) * _e1224);
                                                            let _e1508 = ((bitcast<f32>(_e1501) - _e1039) * _e1234);
                                                            let _e1516 = nodes.member[(0u + _e1454)].x;
                                                            if (_e1214 < 0f) {
                                                                let _e1527 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1516.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1533 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1527.unnamed.root, _e1516.w), _e1527.unnamed_1);
                                                                let _e1539 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1533.unnamed, lt_bvh_traverse_Tree(_e1516.x, _e1533.unnamed_1.first_primitive));
                                                                phi_2134_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1539.unnamed, lt_bvh_traverse_Tree(_e1539.unnamed_1.root, _e1516.y));
                                                            } else {
                                                                let _e1555 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1516.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1561 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1555.unnamed.root, _e1516.y), _e1555.unnamed_1);
                                                                let _e1567 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1561.unnamed, lt_bvh_traverse_Tree(_e1516.z, _e1561.unnamed_1.first_primitive));
                                                                phi_2134_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1567.unnamed, lt_bvh_traverse_Tree(_e1567.unnamed_1.root, _e1516.w));
                                                            }
                                                            let _e1575 = phi_2134_;
                                                            let _e1585 = nodes.member[(0u + _e1454)].y;
                                                            if (_e1224 < 0f) {
                                                                let _e1596 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1585.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1602 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1596.unnamed.root, _e1585.w), _e1596.unnamed_1);
                                                                let _e1608 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1602.unnamed, lt_bvh_traverse_Tree(_e1585.x, _e1602.unnamed_1.first_primitive));
                                                                phi_2161_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1608.unnamed, lt_bvh_traverse_Tree(_e1608.unnamed_1.root, _e1585.y));
                                                            } else {
                                                                let _e1624 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1585.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1630 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1624.unnamed.root, _e1585.y), _e1624.unnamed_1);
                                                                let _e1636 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1630.unnamed, lt_bvh_traverse_Tree(_e1585.z, _e1630.unnamed_1.first_primitive));
                                                                phi_2161_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1636.unnamed, lt_bvh_traverse_Tree(_e1636.unnamed_1.root, _e1585.w));
                                                            }
                                                            let _e1644 = phi_2161_;
                                                            let _e1654 = nodes.member[(0u + _e1454)].z;
                                                            if (_e1234 < 0f) {
                                                                let _e1665 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1654.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1671 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1665.unnamed.root, _e1654.w), _e1665.unnamed_1);
                                                                let _e1677 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1671.unnamed, lt_bvh_traverse_Tree(_e1654.x, _e1671.unnamed_1.first_primitive));
                                                                phi_2188_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1677.unnamed, lt_bvh_traverse_Tree(_e1677.unnamed_1.root, _e1654.y));
                                                            } else {
                                                                let _e1693 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1654.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1699 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1693.unnamed.root, _e1654.y), _e1693.unnamed_1);
                                                                let _e1705 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1699.unnamed, lt_bvh_traverse_Tree(_e1654.z, _e1699.unnamed_1.first_primitive));
                                                                phi_2188_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1705.unnamed, lt_bvh_traverse_Tree(_e1705.unnamed_1.root, _e1654.w));
                                                            }
                                                            let _e1713 = phi_2188_;
                                                            phi_2194_ = 0u;
                                                            phi_2197_ = 0u;
                                                            loop {
                                                                let _e1723 = phi_2194_;
                                                                let _e1725 = phi_2197_;
                                                                local_6 = _e1725;
                                                                local_7 = _e1725;
                                                                local_8 = _e1725;
                                                                let _e1726 = (_e1723 < 8u);
                                                                if _e1726 {
                                                                    let _e1728 = (_e1723 >> bitcast<u32>(2i));
                                                                    let _e1729 = (_e1723 & 3u);
                                                                    if (_e1728 == 0u) {
                                                                        phi_2211_ = _e1575.unnamed.root;
                                                                    } else {
                                                                        phi_2211_ = _e1575.unnamed.first_primitive;
                                                                    }
                                                                    let _e1732 = phi_2211_;
                                                                    if (_e1728 == 0u) {
                                                                        phi_2221_ = _e1644.unnamed.root;
                                                                    } else {
                                                                        phi_2221_ = _e1644.unnamed.first_primitive;
                                                                    }
                                                                    let _e1741 = phi_2221_;
                                                                    if (_e1728 == 0u) {
                                                                        phi_2231_ = _e1713.unnamed.root;
                                                                    } else {
                                                                        phi_2231_ = _e1713.unnamed.first_primitive;
                                                                    }
                                                                    let _e1750 = phi_2231_;
                                                                    let _e1763 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1732 >> bitcast<u32>(((_e1729 * 8u) & 31u))) & 255u)) * _e1488) + (_e1506 - _e1266)), ((f32(((_e1741 >> bitcast<u32>(((_e1729 * 8u) & 31u))) & 255u)) * _e1489) + (_e1507 - _e1267)));
                                                                    let _e1764 = core_intrinsics_maximum_number_nsz_f32_(_e1763, ((f32(((_e1750 >> bitcast<u32>(((_e1729 * 8u) & 31u))) & 255u)) * _e1490) + (_e1508 - _e1268)));
                                                                    if (_e1728 == 0u) {
                                                                        phi_2249_ = _e1575.unnamed_1.root;
                                                                    } else {
                                                                        phi_2249_ = _e1575.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1767 = phi_2249_;
                                                                    if (_e1728 == 0u) {
                                                                        phi_2259_ = _e1644.unnamed_1.root;
                                                                    } else {
                                                                        phi_2259_ = _e1644.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1776 = phi_2259_;
                                                                    if (_e1728 == 0u) {
                                                                        phi_2269_ = _e1713.unnamed_1.root;
                                                                    } else {
                                                                        phi_2269_ = _e1713.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1785 = phi_2269_;
                                                                    let _e1798 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1767 >> bitcast<u32>(((_e1729 * 8u) & 31u))) & 255u)) * _e1488) + (_e1506 + _e1266)), ((f32(((_e1776 >> bitcast<u32>(((_e1729 * 8u) & 31u))) & 255u)) * _e1489) + (_e1507 + _e1267)));
                                                                    let _e1799 = core_intrinsics_minimum_number_nsz_f32_(_e1798, ((f32(((_e1785 >> bitcast<u32>(((_e1729 * 8u) & 31u))) & 255u)) * _e1490) + (_e1508 + _e1268)));
                                                                    if (_e1764 <= _e1799) {
                                                                        if (_e1764 <= _e143) {
                                                                            if (_e1799 >= 0f) {
                                                                                if (_e1728 == 0u) {
                                                                                    let _e1806 = nodes.member[(0u + _e1454)].links[2u];
                                                                                    phi_2305_ = _e1806;
                                                                                } else {
                                                                                    let _e1809 = nodes.member[(0u + _e1454)].links[3u];
                                                                                    phi_2305_ = _e1809;
                                                                                }
                                                                                let _e1811 = phi_2305_;
                                                                                let _e1816 = ((_e1811 >> bitcast<u32>(((_e1729 * 8u) & 31u))) & 255u);
                                                                                let _e1817 = (_e1816 & 31u);
                                                                                if (_e1817 >= 24u) {
                                                                                    phi_2318_ = (24u + ((_e1817 - 24u) ^ _e1316));
                                                                                } else {
                                                                                    phi_2318_ = _e1817;
                                                                                }
                                                                                let _e1823 = phi_2318_;
                                                                                phi_2323_ = (_e1725 | ((_e1816 >> bitcast<u32>(5i)) << bitcast<u32>((_e1823 & 31u))));
                                                                            } else {
                                                                                phi_2323_ = _e1725;
                                                                            }
                                                                            let _e1831 = phi_2323_;
                                                                            phi_2324_ = _e1831;
                                                                        } else {
                                                                            phi_2324_ = _e1725;
                                                                        }
                                                                        let _e1833 = phi_2324_;
                                                                        phi_2325_ = _e1833;
                                                                    } else {
                                                                        phi_2325_ = _e1725;
                                                                    }
                                                                    let _e1835 = phi_2325_;
                                                                    phi_2195_ = (_e1723 + 1u);
                                                                    phi_2198_ = _e1835;
                                                                } else {
                                                                    phi_2195_ = u32();
                                                                    phi_2198_ = u32();
                                                                }
                                                                let _e1838 = phi_2195_;
                                                                let _e1840 = phi_2198_;
                                                                continue;
                                                                continuing {
                                                                    phi_2194_ = _e1838;
                                                                    phi_2197_ = _e1840;
                                                                    break if !(_e1726);
                                                                }
                                                            }
                                                            let _e1844 = nodes.member[(0u + _e1454)].links[0u];
                                                            let _e1848 = nodes.member[(0u + _e1454)].frame[3u];
                                                            let _e1852 = local_6;
                                                            if ((_e1852 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1856 = local_1.group_mask;
                                                                if ((_e1856 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1860 = local_1.len;
                                                                    if (_e1860 < 32u) {
                                                                        let _e1863 = local_1.group;
                                                                        let _e1865 = local_1.len;
                                                                        if (_e1865 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.first[(0u + _e1865)] = _e1863;
                                                                        let _e1871 = local_1.group_mask;
                                                                        let _e1873 = local_1.len;
                                                                        if (_e1873 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.mask[(0u + _e1873)] = _e1871;
                                                                        let _e1880 = local_1.len;
                                                                        local_1.len = (_e1880 + 1u);
                                                                    }
                                                                }
                                                                local_1.group = (_e1082 + _e1844);
                                                                let _e1884 = local_7;
                                                                local_1.group_mask = ((_e1884 & 4278190080u) | (_e1848 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1889 = local_8;
                                                            phi_2383_ = (_e1889 & 16777215u);
                                                            phi_2386_ = _e1456;
                                                            loop {
                                                                let _e1892 = phi_2383_;
                                                                let _e1894 = phi_2386_;
                                                                local_13 = _e1894;
                                                                let _e1895 = (_e1892 == 0u);
                                                                local_9 = _e1895;
                                                                local_15 = _e1895;
                                                                if _e1895 {
                                                                    phi_2384_ = u32();
                                                                    phi_2387_ = bool();
                                                                    phi_3190_ = bool();
                                                                    phi_3191_ = false;
                                                                } else {
                                                                    let _e1898 = nodes.member[(0u + _e1454)].links[1u];
                                                                    let _e1903 = ((_e1084 + _e1898) + select(firstTrailingBit(_e1892), 32u, (_e1892 == 0u)));
                                                                    if (_e1903 < _e79) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1910 = triangles.member[(0u + _e1903)].v0_;
                                                                    let _e1912 = (_e1910.x - _e1013);
                                                                    let _e1914 = (_e1910.y - _e1026);
                                                                    let _e1916 = (_e1910.z - _e1039);
                                                                    if (_e1289 == 0u) {
                                                                        phi_2431_ = vec3<f32>(_e1914, _e1916, _e1912);
                                                                    } else {
                                                                        if (_e1289 == 1u) {
                                                                            phi_2430_ = vec3<f32>(_e1916, _e1912, _e1914);
                                                                        } else {
                                                                            phi_2430_ = (_e1910 - vec3<f32>(_e1013, _e1026, _e1039));
                                                                        }
                                                                        let _e1924 = phi_2430_;
                                                                        phi_2431_ = _e1924;
                                                                    }
                                                                    let _e1926 = phi_2431_;
                                                                    let _e1930 = (_e1926.x - (_e1300 * _e1926.z));
                                                                    let _e1934 = (_e1926.y - (_e1303 * _e1926.z));
                                                                    let _e1936 = triangles.member[(0u + _e1903)].v1_;
                                                                    let _e1938 = (_e1936.x - _e1013);
                                                                    let _e1940 = (_e1936.y - _e1026);
                                                                    let _e1942 = (_e1936.z - _e1039);
                                                                    if (_e1289 == 0u) {
                                                                        phi_2461_ = vec3<f32>(_e1940, _e1942, _e1938);
                                                                    } else {
                                                                        if (_e1289 == 1u) {
                                                                            phi_2460_ = vec3<f32>(_e1942, _e1938, _e1940);
                                                                        } else {
                                                                            phi_2460_ = (_e1936 - vec3<f32>(_e1013, _e1026, _e1039));
                                                                        }
                                                                        let _e1950 = phi_2460_;
                                                                        phi_2461_ = _e1950;
                                                                    }
                                                                    let _e1952 = phi_2461_;
                                                                    let _e1956 = (_e1952.x - (_e1300 * _e1952.z));
                                                                    let _e1960 = (_e1952.y - (_e1303 * _e1952.z));
                                                                    let _e1962 = triangles.member[(0u + _e1903)].v2_;
                                                                    let _e1964 = (_e1962.x - _e1013);
                                                                    let _e1966 = (_e1962.y - _e1026);
                                                                    let _e1968 = (_e1962.z - _e1039);
                                                                    if (_e1289 == 0u) {
                                                                        phi_2491_ = vec3<f32>(_e1966, _e1968, _e1964);
                                                                    } else {
                                                                        if (_e1289 == 1u) {
                                                                            phi_2490_ = vec3<f32>(_e1968, _e1964, _e1966);
                                                                        } else {
                                                                            phi_2490_ = (_e1962 - vec3<f32>(_e1013, _e1026, _e1039));
                                                                        }
                                                                        let _e1976 = phi_2490_;
                                                                        phi_2491_ = _e1976;
                                                                    }
                                                                    let _e1978 = phi_2491_;
                                                                    let _e1982 = (_e1978.x - (_e1300 * _e1978.z));
                                                                    let _e1986 = (_e1978.y - (_e1303 * _e1978.z));
                                                                    if (_e1956 < _e1982) {
                                                                        phi_2510_ = true;
                                                                    } else {
                                                                        if (_e1956 == _e1982) {
                                                                            phi_2509_ = (_e1960 < _e1986);
                                                                        } else {
                                                                            phi_2509_ = false;
                                                                        }
                                                                        let _e1991 = phi_2509_;
                                                                        phi_2510_ = _e1991;
                                                                    }
                                                                    let _e1993 = phi_2510_;
                                                                    if _e1993 {
                                                                        phi_2514_ = _e1986;
                                                                        phi_2515_ = _e1982;
                                                                        phi_2516_ = _e1960;
                                                                        phi_2517_ = _e1956;
                                                                    } else {
                                                                        phi_2514_ = _e1960;
                                                                        phi_2515_ = _e1956;
                                                                        phi_2516_ = _e1986;
                                                                        phi_2517_ = _e1982;
                                                                    }
                                                                    let _e1995 = phi_2514_;
                                                                    let _e1997 = phi_2515_;
                                                                    let _e1999 = phi_2516_;
                                                                    let _e2001 = phi_2517_;
                                                                    let _e2004 = ((_e2001 * _e1995) - (_e1999 * _e1997));
                                                                    if _e1993 {
                                                                        phi_2525_ = -(_e2004);
                                                                    } else {
                                                                        phi_2525_ = _e2004;
                                                                    }
                                                                    let _e2007 = phi_2525_;
                                                                    if (_e1982 < _e1930) {
                                                                        phi_2536_ = true;
                                                                    } else {
                                                                        if (_e1982 == _e1930) {
                                                                            phi_2535_ = (_e1986 < _e1934);
                                                                        } else {
                                                                            phi_2535_ = false;
                                                                        }
                                                                        let _e2012 = phi_2535_;
                                                                        phi_2536_ = _e2012;
                                                                    }
                                                                    let _e2014 = phi_2536_;
                                                                    if _e2014 {
                                                                        phi_2540_ = _e1934;
                                                                        phi_2541_ = _e1930;
                                                                        phi_2542_ = _e1986;
                                                                        phi_2543_ = _e1982;
                                                                    } else {
                                                                        phi_2540_ = _e1986;
                                                                        phi_2541_ = _e1982;
                                                                        phi_2542_ = _e1934;
                                                                        phi_2543_ = _e1930;
                                                                    }
                                                                    let _e2016 = phi_2540_;
                                                                    let _e2018 = phi_2541_;
                                                                    let _e2020 = phi_2542_;
                                                                    let _e2022 = phi_2543_;
                                                                    let _e2025 = ((_e2022 * _e2016) - (_e2020 * _e2018));
                                                                    if _e2014 {
                                                                        phi_2551_ = -(_e2025);
                                                                    } else {
                                                                        phi_2551_ = _e2025;
                                                                    }
                                                                    let _e2028 = phi_2551_;
                                                                    if (_e1930 < _e1956) {
                                                                        phi_2562_ = true;
                                                                    } else {
                                                                        if (_e1930 == _e1956) {
                                                                            phi_2561_ = (_e1934 < _e1960);
                                                                        } else {
                                                                            phi_2561_ = false;
                                                                        }
                                                                        let _e2033 = phi_2561_;
                                                                        phi_2562_ = _e2033;
                                                                    }
                                                                    let _e2035 = phi_2562_;
                                                                    if _e2035 {
                                                                        phi_2566_ = _e1960;
                                                                        phi_2567_ = _e1956;
                                                                        phi_2568_ = _e1934;
                                                                        phi_2569_ = _e1930;
                                                                    } else {
                                                                        phi_2566_ = _e1934;
                                                                        phi_2567_ = _e1930;
                                                                        phi_2568_ = _e1960;
                                                                        phi_2569_ = _e1956;
                                                                    }
                                                                    let _e2037 = phi_2566_;
                                                                    let _e2039 = phi_2567_;
                                                                    let _e2041 = phi_2568_;
                                                                    let _e2043 = phi_2569_;
                                                                    let _e2046 = ((_e2043 * _e2037) - (_e2041 * _e2039));
                                                                    if _e2035 {
                                                                        phi_2577_ = -(_e2046);
                                                                    } else {
                                                                        phi_2577_ = _e2046;
                                                                    }
                                                                    let _e2049 = phi_2577_;
                                                                    if (_e2007 >= 0f) {
                                                                        if (_e2028 >= 0f) {
                                                                            if (_e2049 >= 0f) {
                                                                                phi_2592_ = ((_e2007 + _e2028) + _e2049);
                                                                                phi_2593_ = false;
                                                                            } else {
                                                                                phi_2592_ = f32();
                                                                                phi_2593_ = true;
                                                                            }
                                                                            let _e2056 = phi_2592_;
                                                                            let _e2058 = phi_2593_;
                                                                            phi_2594_ = _e2056;
                                                                            phi_2595_ = _e2058;
                                                                        } else {
                                                                            phi_2594_ = f32();
                                                                            phi_2595_ = true;
                                                                        }
                                                                        let _e2060 = phi_2594_;
                                                                        let _e2062 = phi_2595_;
                                                                        phi_2596_ = _e2060;
                                                                        phi_2597_ = _e2062;
                                                                    } else {
                                                                        phi_2596_ = f32();
                                                                        phi_2597_ = true;
                                                                    }
                                                                    let _e2064 = phi_2596_;
                                                                    let _e2066 = phi_2597_;
                                                                    if _e2066 {
                                                                        if (_e2007 <= 0f) {
                                                                            if (_e2028 <= 0f) {
                                                                                let _e2069 = (_e2049 <= 0f);
                                                                                if _e2069 {
                                                                                }
                                                                                phi_2615_ = ((_e2007 + _e2028) + _e2049);
                                                                                phi_2616_ = false;
                                                                                phi_2617_ = _e2069;
                                                                            } else {
                                                                                phi_2615_ = f32();
                                                                                phi_2616_ = true;
                                                                                phi_2617_ = false;
                                                                            }
                                                                            let _e2073 = phi_2615_;
                                                                            let _e2075 = phi_2616_;
                                                                            let _e2077 = phi_2617_;
                                                                            phi_2618_ = _e2073;
                                                                            phi_2619_ = _e2075;
                                                                            phi_2620_ = _e2077;
                                                                        } else {
                                                                            phi_2618_ = f32();
                                                                            phi_2619_ = true;
                                                                            phi_2620_ = false;
                                                                        }
                                                                        let _e2079 = phi_2618_;
                                                                        let _e2081 = phi_2619_;
                                                                        let _e2083 = phi_2620_;
                                                                        if _e2081 {
                                                                            phi_2624_ = false;
                                                                        } else {
                                                                            phi_2624_ = _e2083;
                                                                        }
                                                                        let _e2085 = phi_2624_;
                                                                        phi_2625_ = _e2079;
                                                                        phi_2626_ = _e2085;
                                                                    } else {
                                                                        phi_2625_ = _e2064;
                                                                        phi_2626_ = true;
                                                                    }
                                                                    let _e2087 = phi_2625_;
                                                                    let _e2089 = phi_2626_;
                                                                    if _e2089 {
                                                                        let _e2090 = (_e2087 == 0f);
                                                                        if _e2090 {
                                                                            phi_2942_ = lt_bvh_triangle_Intersection();
                                                                            phi_2943_ = false;
                                                                        } else {
                                                                            let _e2092 = triangles.member[(0u + _e1903)].v0_;
                                                                            let _e2094 = (_e2092.x - _e1013);
                                                                            let _e2096 = (_e2092.y - _e1026);
                                                                            let _e2098 = (_e2092.z - _e1039);
                                                                            if (_e1289 == 0u) {
                                                                                phi_2655_ = vec3<f32>(_e2096, _e2098, _e2094);
                                                                            } else {
                                                                                if (_e1289 == 1u) {
                                                                                    phi_2654_ = vec3<f32>(_e2098, _e2094, _e2096);
                                                                                } else {
                                                                                    phi_2654_ = (_e2092 - vec3<f32>(_e1013, _e1026, _e1039));
                                                                                }
                                                                                let _e2106 = phi_2654_;
                                                                                phi_2655_ = _e2106;
                                                                            }
                                                                            let _e2108 = phi_2655_;
                                                                            let _e2110 = triangles.member[(0u + _e1903)].v1_;
                                                                            let _e2112 = triangles.member[(0u + _e1903)].v0_;
                                                                            let _e2115 = (_e2110.x - _e2112.x);
                                                                            let _e2118 = (_e2110.y - _e2112.y);
                                                                            let _e2121 = (_e2110.z - _e2112.z);
                                                                            if (_e1289 == 0u) {
                                                                                phi_2681_ = vec3<f32>(_e2118, _e2121, _e2115);
                                                                            } else {
                                                                                if (_e1289 == 1u) {
                                                                                    phi_2680_ = vec3<f32>(_e2121, _e2115, _e2118);
                                                                                } else {
                                                                                    phi_2680_ = (_e2110 - _e2112);
                                                                                }
                                                                                let _e2128 = phi_2680_;
                                                                                phi_2681_ = _e2128;
                                                                            }
                                                                            let _e2130 = phi_2681_;
                                                                            let _e2132 = triangles.member[(0u + _e1903)].v2_;
                                                                            let _e2134 = triangles.member[(0u + _e1903)].v0_;
                                                                            let _e2137 = (_e2132.x - _e2134.x);
                                                                            let _e2140 = (_e2132.y - _e2134.y);
                                                                            let _e2143 = (_e2132.z - _e2134.z);
                                                                            if (_e1289 == 0u) {
                                                                                phi_2707_ = vec3<f32>(_e2140, _e2143, _e2137);
                                                                            } else {
                                                                                if (_e1289 == 1u) {
                                                                                    phi_2706_ = vec3<f32>(_e2143, _e2137, _e2140);
                                                                                } else {
                                                                                    phi_2706_ = (_e2132 - _e2134);
                                                                                }
                                                                                let _e2150 = phi_2706_;
                                                                                phi_2707_ = _e2150;
                                                                            }
                                                                            let _e2152 = phi_2707_;
                                                                            let _e2159 = ((_e2130.y * _e2152.z) - (_e2130.z * _e2152.y));
                                                                            let _e2166 = ((_e2130.z * _e2152.x) - (_e2130.x * _e2152.z));
                                                                            let _e2173 = ((_e2130.x * _e2152.y) - (_e2130.y * _e2152.x));
                                                                            let _e2187 = (((1f / _e1297.z) * (((_e2159 * _e2108.x) + (_e2166 * _e2108.y)) + (_e2173 * _e2108.z))) / (((_e2159 * _e1300) + (_e2166 * _e1303)) + _e2173));
                                                                            if (_e2187 > 0f) {
                                                                                if (_e2187 < _e143) {
                                                                                    let _e2191 = triangles.member[(0u + _e1903)].v0_;
                                                                                    let _e2193 = triangles.member[(0u + _e1903)].v1_;
                                                                                    if (_e2191.x < _e2193.x) {
                                                                                        phi_2763_ = _e2191.x;
                                                                                    } else {
                                                                                        phi_2763_ = _e2193.x;
                                                                                    }
                                                                                    let _e2200 = phi_2763_;
                                                                                    if (_e2191.y < _e2193.y) {
                                                                                        phi_2772_ = _e2191.y;
                                                                                    } else {
                                                                                        phi_2772_ = _e2193.y;
                                                                                    }
                                                                                    let _e2207 = phi_2772_;
                                                                                    if (_e2191.z < _e2193.z) {
                                                                                        phi_2781_ = _e2191.z;
                                                                                    } else {
                                                                                        phi_2781_ = _e2193.z;
                                                                                    }
                                                                                    let _e2214 = phi_2781_;
                                                                                    let _e2216 = triangles.member[(0u + _e1903)].v2_;
                                                                                    if (_e2200 < _e2216.x) {
                                                                                        phi_2790_ = _e2200;
                                                                                    } else {
                                                                                        phi_2790_ = _e2216.x;
                                                                                    }
                                                                                    let _e2221 = phi_2790_;
                                                                                    if (_e2207 < _e2216.y) {
                                                                                        phi_2797_ = _e2207;
                                                                                    } else {
                                                                                        phi_2797_ = _e2216.y;
                                                                                    }
                                                                                    let _e2226 = phi_2797_;
                                                                                    if (_e2214 < _e2216.z) {
                                                                                        phi_2804_ = _e2214;
                                                                                    } else {
                                                                                        phi_2804_ = _e2216.z;
                                                                                    }
                                                                                    let _e2231 = phi_2804_;
                                                                                    let _e2233 = triangles.member[(0u + _e1903)].v0_;
                                                                                    let _e2235 = triangles.member[(0u + _e1903)].v1_;
                                                                                    if (_e2233.x > _e2235.x) {
                                                                                        phi_2817_ = _e2233.x;
                                                                                    } else {
                                                                                        phi_2817_ = _e2235.x;
                                                                                    }
                                                                                    let _e2242 = phi_2817_;
                                                                                    if (_e2233.y > _e2235.y) {
                                                                                        phi_2826_ = _e2233.y;
                                                                                    } else {
                                                                                        phi_2826_ = _e2235.y;
                                                                                    }
                                                                                    let _e2249 = phi_2826_;
                                                                                    if (_e2233.z > _e2235.z) {
                                                                                        phi_2835_ = _e2233.z;
                                                                                    } else {
                                                                                        phi_2835_ = _e2235.z;
                                                                                    }
                                                                                    let _e2256 = phi_2835_;
                                                                                    let _e2258 = triangles.member[(0u + _e1903)].v2_;
                                                                                    if (_e2242 > _e2258.x) {
                                                                                        phi_2844_ = _e2242;
                                                                                    } else {
                                                                                        phi_2844_ = _e2258.x;
                                                                                    }
                                                                                    let _e2263 = phi_2844_;
                                                                                    if (_e2249 > _e2258.y) {
                                                                                        phi_2851_ = _e2249;
                                                                                    } else {
                                                                                        phi_2851_ = _e2258.y;
                                                                                    }
                                                                                    let _e2268 = phi_2851_;
                                                                                    if (_e2256 > _e2258.z) {
                                                                                        phi_2858_ = _e2256;
                                                                                    } else {
                                                                                        phi_2858_ = _e2258.z;
                                                                                    }
                                                                                    let _e2273 = phi_2858_;
                                                                                    let _e2277 = ((_e2221 - _e1013) * _e1214);
                                                                                    let _e2278 = ((_e2226 - _e1026) * _e1224);
                                                                                    let _e2279 = ((_e2231 - _e1039) * _e1234);
                                                                                    let _e2283 = ((_e2263 - _e1013) * _e1214);
                                                                                    let _e2284 = ((_e2268 - _e1026) * _e1224);
                                                                                    let _e2285 = ((_e2273 - _e1039) * _e1234);
                                                                                    if (_e2277 < _e2283) {
                                                                                        phi_2875_ = _e2277;
                                                                                    } else {
                                                                                        phi_2875_ = _e2283;
                                                                                    }
                                                                                    let _e2288 = phi_2875_;
                                                                                    if (_e2278 < _e2284) {
                                                                                        phi_2880_ = _e2278;
                                                                                    } else {
                                                                                        phi_2880_ = _e2284;
                                                                                    }
                                                                                    let _e2291 = phi_2880_;
                                                                                    if (_e2279 < _e2285) {
                                                                                        phi_2885_ = _e2279;
                                                                                    } else {
                                                                                        phi_2885_ = _e2285;
                                                                                    }
                                                                                    let _e2294 = phi_2885_;
                                                                                    if (_e2277 > _e2283) {
                                                                                        phi_2893_ = _e2277;
                                                                                    } else {
                                                                                        phi_2893_ = _e2283;
                                                                                    }
                                                                                    let _e2300 = phi_2893_;
                                                                                    if (_e2278 > _e2284) {
                                                                                        phi_2898_ = _e2278;
                                                                                    } else {
                                                                                        phi_2898_ = _e2284;
                                                                                    }
                                                                                    let _e2303 = phi_2898_;
                                                                                    if (_e2279 > _e2285) {
                                                                                        phi_2903_ = _e2279;
                                                                                    } else {
                                                                                        phi_2903_ = _e2285;
                                                                                    }
                                                                                    let _e2306 = phi_2903_;
                                                                                    let _e2310 = core_intrinsics_maximum_number_nsz_f32_((_e2288 - _e1273), (_e2291 - _e1274));
                                                                                    let _e2311 = core_intrinsics_maximum_number_nsz_f32_(_e2310, (_e2294 - _e1275));
                                                                                    let _e2312 = core_intrinsics_minimum_number_nsz_f32_((_e2300 + _e1273), (_e2303 + _e1274));
                                                                                    let _e2313 = core_intrinsics_minimum_number_nsz_f32_(_e2312, (_e2306 + _e1275));
                                                                                    if (_e2311 > _e994) {
                                                                                        phi_2915_ = _e2311;
                                                                                    } else {
                                                                                        phi_2915_ = _e994;
                                                                                    }
                                                                                    let _e2316 = phi_2915_;
                                                                                    if (_e2313 < _e996) {
                                                                                        phi_2920_ = _e2313;
                                                                                    } else {
                                                                                        phi_2920_ = _e996;
                                                                                    }
                                                                                    let _e2319 = phi_2920_;
                                                                                    if (_e2187 < _e2316) {
                                                                                        phi_2925_ = _e2316;
                                                                                    } else {
                                                                                        phi_2925_ = _e2187;
                                                                                    }
                                                                                    let _e2322 = phi_2925_;
                                                                                    if (_e2322 > _e2319) {
                                                                                        phi_2930_ = _e2319;
                                                                                    } else {
                                                                                        phi_2930_ = _e2322;
                                                                                    }
                                                                                    let _e2325 = phi_2930_;
                                                                                    phi_2935_ = lt_bvh_triangle_Intersection(_e2325, (_e2028 / _e2087), (_e2049 / _e2087), (_e2316 <= _e2319));
                                                                                    phi_2936_ = false;
                                                                                } else {
                                                                                    phi_2935_ = lt_bvh_triangle_Intersection();
                                                                                    phi_2936_ = true;
                                                                                }
                                                                                let _e2331 = phi_2935_;
                                                                                let _e2333 = phi_2936_;
                                                                                phi_2937_ = _e2331;
                                                                                phi_2938_ = _e2333;
                                                                            } else {
                                                                                phi_2937_ = lt_bvh_triangle_Intersection();
                                                                                phi_2938_ = true;
                                                                            }
                                                                            let _e2335 = phi_2937_;
                                                                            let _e2337 = phi_2938_;
                                                                            if _e2337 {
                                                                            }
                                                                            phi_2942_ = _e2335;
                                                                            phi_2943_ = _e2337;
                                                                        }
                                                                        let _e2339 = phi_2942_;
                                                                        let _e2341 = phi_2943_;
                                                                        phi_2944_ = _e2339;
                                                                        phi_2945_ = _e2090;
                                                                        phi_2946_ = _e2341;
                                                                    } else {
                                                                        phi_2944_ = lt_bvh_triangle_Intersection();
                                                                        phi_2945_ = true;
                                                                        phi_2946_ = false;
                                                                    }
                                                                    let _e2343 = phi_2944_;
                                                                    let _e2345 = phi_2945_;
                                                                    let _e2347 = phi_2946_;
                                                                    if _e2345 {
                                                                        phi_2950_ = true;
                                                                    } else {
                                                                        phi_2950_ = _e2347;
                                                                    }
                                                                    let _e2349 = phi_2950_;
                                                                    if _e2349 {
                                                                        phi_2954_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_2954_ = _e2343;
                                                                    }
                                                                    let _e2351 = phi_2954_;
                                                                    if _e2351.is_hit {
                                                                        if (_e2351.t > 0f) {
                                                                            if (_e2351.t < _e143) {
                                                                                let _e2358 = triangles.member[(0u + _e1903)].i0_;
                                                                                if ((_e2358 & 2147483648u) == 0u) {
                                                                                    phi_3173_ = true;
                                                                                } else {
                                                                                    if (_e1903 < _e79) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2367 = triangles.member[(0u + _e1903)].i0_;
                                                                                    let _e2368 = (_e2367 & 2147483647u);
                                                                                    let _e2370 = triangles.member[(0u + _e1903)].i1_;
                                                                                    let _e2372 = triangles.member[(0u + _e1903)].i2_;
                                                                                    if (_e2368 < _e91) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2376 = vertices.member[(0u + _e2368)];
                                                                                    if (_e2370 < _e91) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2380 = vertices.member[(0u + _e2370)];
                                                                                    if (_e2372 < _e91) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2384 = vertices.member[(0u + _e2372)];
                                                                                    let _e2385 = array<abi_Vertex, 3>(_e2376, _e2380, _e2384);
                                                                                    if (_e2385[0].material < arrayLength((&materials.member))) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2391 = materials.member[(0u + _e2385[0].material)];
                                                                                    if ((_e2391.flags & 1u) == 1u) {
                                                                                        let _e2396 = ((1f - _e2351.u) - _e2351.v);
                                                                                        if (_e2391.cutoff <= 0f) {
                                                                                            phi_3171_ = true;
                                                                                        } else {
                                                                                            let _e2423 = (_e2391.base_color.w * ((((f32((_e2385[0].color >> bitcast<u32>(24i))) * _e2396) + (f32((_e2385[1].color >> bitcast<u32>(24i))) * _e2351.u)) + (f32((_e2385[2].color >> bitcast<u32>(24i))) * _e2351.v)) * (1f / 255f)));
                                                                                            if (_e2391.alpha_size == 0u) {
                                                                                                phi_3168_ = _e2423;
                                                                                            } else {
                                                                                                local.offset = _e2391.alpha_offset;
                                                                                                local.size = _e2391.alpha_size;
                                                                                                local.flags = _e2391.flags;
                                                                                                let _e2454 = _lt_shaders_texture_TextureView_quad((&local), (((_e2385[0].u * _e2396) + (_e2385[1].u * _e2351.u)) + (_e2385[2].u * _e2351.v)), (((_e2385[0].v * _e2396) + (_e2385[1].v * _e2351.u)) + (_e2385[2].v * _e2351.v)));
                                                                                                let _e2458 = (_e2454.indices[0] >> bitcast<u32>(2i));
                                                                                                if (_e2458 < _e97) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2462 = alpha_texels.member[(0u + _e2458)];
                                                                                                let _e2478 = (_e2454.indices[1] >> bitcast<u32>(2i));
                                                                                                if (_e2478 < _e97) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2482 = alpha_texels.member[(0u + _e2478)];
                                                                                                let _e2499 = (_e2454.indices[2] >> bitcast<u32>(2i));
                                                                                                if (_e2499 < _e97) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2503 = alpha_texels.member[(0u + _e2499)];
                                                                                                let _e2520 = (_e2454.indices[3] >> bitcast<u32>(2i));
                                                                                                if (_e2520 < _e97) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2524 = alpha_texels.member[(0u + _e2520)];
                                                                                                phi_3168_ = (_e2423 * (((((f32(((_e2462 >> bitcast<u32>((((_e2454.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2454.weights.x) + ((f32(((_e2482 >> bitcast<u32>((((_e2454.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2454.weights.y)) + ((f32(((_e2503 >> bitcast<u32>((((_e2454.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2454.weights.z)) + ((f32(((_e2524 >> bitcast<u32>((((_e2454.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2454.weights.w)));
                                                                                            }
                                                                                            let _e2540 = phi_3168_;
                                                                                            phi_3171_ = (_e2540 >= _e2391.cutoff);
                                                                                        }
                                                                                        let _e2544 = phi_3171_;
                                                                                        phi_3172_ = _e2544;
                                                                                    } else {
                                                                                        phi_3172_ = false;
                                                                                    }
                                                                                    let _e2546 = phi_3172_;
                                                                                    phi_3173_ = _e2546;
                                                                                }
                                                                                let _e2548 = phi_3173_;
                                                                                if _e2548 {
                                                                                    phi_3177_ = false;
                                                                                } else {
                                                                                    phi_3177_ = true;
                                                                                }
                                                                                let _e2550 = phi_3177_;
                                                                                phi_3178_ = _e2548;
                                                                                phi_3179_ = _e2548;
                                                                                phi_3180_ = _e2550;
                                                                            } else {
                                                                                phi_3178_ = bool();
                                                                                phi_3179_ = _e1894;
                                                                                phi_3180_ = true;
                                                                            }
                                                                            let _e2552 = phi_3178_;
                                                                            let _e2554 = phi_3179_;
                                                                            let _e2556 = phi_3180_;
                                                                            phi_3181_ = _e2552;
                                                                            phi_3182_ = _e2554;
                                                                            phi_3183_ = _e2556;
                                                                        } else {
                                                                            phi_3181_ = bool();
                                                                            phi_3182_ = _e1894;
                                                                            phi_3183_ = true;
                                                                        }
                                                                        let _e2558 = phi_3181_;
                                                                        let _e2560 = phi_3182_;
                                                                        let _e2562 = phi_3183_;
                                                                        phi_3184_ = _e2558;
                                                                        phi_3185_ = _e2560;
                                                                        phi_3186_ = _e2562;
                                                                    } else {
                                                                        phi_3184_ = bool();
                                                                        phi_3185_ = _e1894;
                                                                        phi_3186_ = true;
                                                                    }
                                                                    let _e2564 = phi_3184_;
                                                                    let _e2566 = phi_3185_;
                                                                    let _e2568 = phi_3186_;
                                                                    if _e2568 {
                                                                    }
                                                                    phi_2384_ = (_e1892 & (_e1892 - 1u));
                                                                    phi_2387_ = _e2566;
                                                                    phi_3190_ = _e2564;
                                                                    phi_3191_ = _e2568;
                                                                }
                                                                let _e2570 = phi_2384_;
                                                                let _e2572 = phi_2387_;
                                                                let _e2574 = phi_3190_;
                                                                let _e2576 = phi_3191_;
                                                                local_14 = _e2574;
                                                                continue;
                                                                continuing {
                                                                    phi_2383_ = _e2570;
                                                                    phi_2386_ = _e2572;
                                                                    break if !(_e2576);
                                                                }
                                                            }
                                                            let _e2579 = local_9;
                                                            if _e2579 {
                                                                let _e2581 = local_1.group_mask;
                                                                if ((_e2581 & 4278190080u) == 0u) {
                                                                    let _e2585 = local_1.len;
                                                                    if (_e2585 == 0u) {
                                                                        phi_3233_ = false;
                                                                    } else {
                                                                        let _e2589 = local_1.len;
                                                                        local_1.len = (_e2589 - 1u);
                                                                        let _e2592 = local_1.len;
                                                                        if (_e2592 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2597 = local_1.first[(0u + _e2592)];
                                                                        local_1.group = _e2597;
                                                                        let _e2600 = local_1.len;
                                                                        if (_e2600 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2605 = local_1.mask[(0u + _e2600)];
                                                                        local_1.group_mask = _e2605;
                                                                        phi_3233_ = true;
                                                                    }
                                                                    let _e2608 = phi_3233_;
                                                                    phi_3234_ = _e2608;
                                                                } else {
                                                                    phi_3234_ = true;
                                                                }
                                                                let _e2610 = phi_3234_;
                                                                if _e2610 {
                                                                    let _e2612 = local_1.group_mask;
                                                                    let _e2618 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2612)), 32u, (_e2612 == 0u)));
                                                                    let _e2622 = local_1.group_mask;
                                                                    let _e2636 = local_1.group_mask;
                                                                    local_1.group_mask = (_e2636 & ~((1u << bitcast<u32>((_e2618 & 31u)))));
                                                                    let _e2639 = local_1.group;
                                                                    phi_3265_ = (_e2639 + countOneBits(((_e2622 & ~((4294967295u << bitcast<u32>((((_e2618 - 24u) ^ _e1316) & 31u))))) & 255u)));
                                                                } else {
                                                                    phi_3265_ = 4294967295u;
                                                                }
                                                                let _e2642 = phi_3265_;
                                                                phi_3266_ = _e2642;
                                                            } else {
                                                                phi_3266_ = u32();
                                                            }
                                                            let _e2644 = phi_3266_;
                                                            phi_2052_ = _e2644;
                                                            let _e3030 = local_13;
                                                            phi_2055_ = _e3030;
                                                            let _e3033 = local_14;
                                                            phi_3267_ = _e3033;
                                                            let _e3036 = local_15;
                                                            phi_3268_ = _e3036;
                                                            phi_3269_ = false;
                                                        } else {
                                                            phi_2052_ = u32();
                                                            phi_2055_ = bool();
                                                            phi_3267_ = bool();
                                                            phi_3268_ = false;
                                                            phi_3269_ = true;
                                                        }
                                                        let _e2646 = phi_2052_;
                                                        let _e2648 = phi_2055_;
                                                        let _e2650 = phi_3267_;
                                                        let _e2652 = phi_3268_;
                                                        let _e2654 = phi_3269_;
                                                        local_10 = _e2654;
                                                        local_16 = _e2650;
                                                        continue;
                                                        continuing {
                                                            phi_2051_ = _e2646;
                                                            phi_2054_ = _e2648;
                                                            break if !(_e2652);
                                                        }
                                                    }
                                                    let _e2657 = local_10;
                                                    if _e2657 {
                                                        phi_3273_ = false;
                                                    } else {
                                                        phi_3273_ = true;
                                                    }
                                                    let _e2659 = phi_3273_;
                                                    if _e2659 {
                                                        let _e3042 = local_16;
                                                        phi_3277_ = _e3042;
                                                    } else {
                                                        let _e3044 = local_17;
                                                        phi_3277_ = _e3044;
                                                    }
                                                    let _e2661 = phi_3277_;
                                                    phi_3278_ = _e2661;
                                                }
                                                let _e2663 = phi_3278_;
                                                phi_3279_ = _e2663;
                                                phi_3280_ = _e1138;
                                            } else {
                                                phi_3279_ = bool();
                                                phi_3280_ = true;
                                            }
                                            let _e2665 = phi_3279_;
                                            let _e2667 = phi_3280_;
                                            if _e2667 {
                                                phi_3284_ = _e933;
                                            } else {
                                                phi_3284_ = _e2665;
                                            }
                                            let _e2669 = phi_3284_;
                                            if _e2669 {
                                                phi_3288_ = false;
                                            } else {
                                                phi_3288_ = true;
                                            }
                                            let _e2671 = phi_3288_;
                                            phi_3289_ = _e2669;
                                            phi_3290_ = _e2671;
                                        } else {
                                            phi_3289_ = _e933;
                                            phi_3290_ = true;
                                        }
                                        let _e2673 = phi_3289_;
                                        let _e2675 = phi_3290_;
                                        phi_3291_ = _e2673;
                                        phi_3292_ = _e2675;
                                    } else {
                                        phi_3291_ = _e933;
                                        phi_3292_ = true;
                                    }
                                    let _e2677 = phi_3291_;
                                    let _e2679 = phi_3292_;
                                    phi_3293_ = _e2677;
                                    phi_3294_ = _e2679;
                                } else {
                                    phi_3293_ = _e933;
                                    phi_3294_ = true;
                                }
                                let _e2681 = phi_3293_;
                                let _e2683 = phi_3294_;
                                if _e2683 {
                                }
                                phi_1437_ = (_e931 & (_e931 - 1u));
                                phi_1440_ = _e2681;
                                phi_3298_ = _e2683;
                            }
                            let _e2685 = phi_1437_;
                            let _e2687 = phi_1440_;
                            let _e2689 = phi_3298_;
                            continue;
                            continuing {
                                phi_1436_ = _e2685;
                                phi_1439_ = _e2687;
                                break if !(_e2689);
                            }
                        }
                        let _e2692 = local_11;
                        if _e2692 {
                            let _e2694 = local_2.group_mask;
                            if ((_e2694 & 4278190080u) == 0u) {
                                let _e2698 = local_2.len;
                                if (_e2698 == 0u) {
                                    phi_3340_ = false;
                                } else {
                                    let _e2702 = local_2.len;
                                    local_2.len = (_e2702 - 1u);
                                    let _e2705 = local_2.len;
                                    if (_e2705 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2710 = local_2.first[(0u + _e2705)];
                                    local_2.group = _e2710;
                                    let _e2713 = local_2.len;
                                    if (_e2713 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2718 = local_2.mask[(0u + _e2713)];
                                    local_2.group_mask = _e2718;
                                    phi_3340_ = true;
                                }
                                let _e2721 = phi_3340_;
                                phi_3341_ = _e2721;
                            } else {
                                phi_3341_ = true;
                            }
                            let _e2723 = phi_3341_;
                            if _e2723 {
                                let _e2725 = local_2.group_mask;
                                let _e2731 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2725)), 32u, (_e2725 == 0u)));
                                let _e2735 = local_2.group_mask;
                                let _e2749 = local_2.group_mask;
                                local_2.group_mask = (_e2749 & ~((1u << bitcast<u32>((_e2731 & 31u)))));
                                let _e2752 = local_2.group;
                                phi_3372_ = (_e2752 + countOneBits(((_e2735 & ~((4294967295u << bitcast<u32>((((_e2731 - 24u) ^ _e355) & 31u))))) & 255u)));
                            } else {
                                phi_3372_ = 4294967295u;
                            }
                            let _e2755 = phi_3372_;
                            phi_3373_ = _e2755;
                        } else {
                            phi_3373_ = u32();
                        }
                        let _e2757 = phi_3373_;
                        phi_1105_ = _e2757;
                        let _e3067 = local_18;
                        phi_1108_ = _e3067;
                        let _e3070 = local_19;
                        phi_3374_ = _e3070;
                        phi_3375_ = false;
                    } else {
                        phi_1105_ = u32();
                        phi_1108_ = bool();
                        phi_3374_ = false;
                        phi_3375_ = true;
                    }
                    let _e2759 = phi_1105_;
                    let _e2761 = phi_1108_;
                    let _e2763 = phi_3374_;
                    let _e2765 = phi_3375_;
                    local_12 = _e2765;
                    continue;
                    continuing {
                        phi_1104_ = _e2759;
                        phi_1107_ = _e2761;
                        break if !(_e2763);
                    }
                }
                let _e2768 = local_12;
                if _e2768 {
                    phi_3379_ = false;
                } else {
                    phi_3379_ = true;
                }
                let _e2770 = phi_3379_;
                if _e2770 {
                }
                phi_3383_ = _e2770;
            }
            let _e2772 = phi_3383_;
            phi_3384_ = _e207;
            phi_3385_ = _e2772;
        } else {
            phi_3384_ = true;
            phi_3385_ = false;
        }
        let _e2774 = phi_3384_;
        let _e2776 = phi_3385_;
        if _e2774 {
            phi_3389_ = false;
            phi_3390_ = true;
        } else {
            phi_3389_ = true;
            phi_3390_ = _e2776;
        }
        let _e2778 = phi_3389_;
        let _e2780 = phi_3390_;
        if _e2780 {
            phi_3394_ = _e2778;
        } else {
            phi_3394_ = false;
        }
        let _e2782 = phi_3394_;
        if _e2782 {
            phi_3398_ = 0f;
        } else {
            phi_3398_ = 1f;
        }
        let _e2784 = phi_3398_;
        if (_e111 < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e111)] = _e2784;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_list_instanced_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
