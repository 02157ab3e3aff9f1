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
    var phi_698_: f32;
    var phi_730_: bool;
    var phi_731_: bool;
    var phi_732_: bool;
    var phi_733_: bool;
    var phi_737_: bool;
    var phi_750_: bool;
    var phi_751_: bool;
    var phi_752_: bool;
    var phi_753_: bool;
    var phi_757_: bool;
    var phi_770_: bool;
    var phi_771_: bool;
    var phi_772_: bool;
    var phi_776_: bool;
    var phi_777_: bool;
    var phi_778_: bool;
    var phi_779_: bool;
    var phi_780_: bool;
    var phi_784_: bool;
    var phi_854_: f32;
    var phi_861_: f32;
    var phi_868_: f32;
    var phi_875_: f32;
    var phi_882_: f32;
    var phi_889_: f32;
    var phi_906_: f32;
    var phi_911_: f32;
    var phi_916_: f32;
    var phi_921_: f32;
    var phi_926_: f32;
    var phi_945_: u32;
    var phi_950_: u32;
    var phi_955_: u32;
    var phi_1069_: bool;
    var phi_1070_: bool;
    var phi_1101_: u32;
    var phi_1103_: u32;
    var phi_1106_: bool;
    var phi_1186_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1213_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1240_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1246_: u32;
    var phi_1249_: u32;
    var phi_1263_: u32;
    var phi_1273_: u32;
    var phi_1283_: u32;
    var phi_1301_: u32;
    var phi_1311_: u32;
    var phi_1321_: u32;
    var phi_1357_: u32;
    var phi_1370_: u32;
    var phi_1375_: u32;
    var phi_1376_: u32;
    var phi_1377_: u32;
    var phi_1247_: u32;
    var phi_1250_: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_1435_: u32;
    var phi_1438_: bool;
    var phi_1487_: f32;
    var phi_1492_: f32;
    var phi_1497_: f32;
    var phi_1505_: f32;
    var phi_1510_: f32;
    var phi_1515_: f32;
    var phi_1635_: bool;
    var phi_1636_: bool;
    var phi_1637_: bool;
    var phi_1638_: bool;
    var phi_1642_: bool;
    var phi_1655_: bool;
    var phi_1656_: bool;
    var phi_1657_: bool;
    var phi_1658_: bool;
    var phi_1662_: bool;
    var phi_1675_: bool;
    var phi_1676_: bool;
    var phi_1677_: bool;
    var phi_1681_: bool;
    var phi_1682_: bool;
    var phi_1683_: bool;
    var phi_1684_: bool;
    var phi_1685_: bool;
    var phi_1689_: bool;
    var phi_1759_: f32;
    var phi_1766_: f32;
    var phi_1773_: f32;
    var phi_1780_: f32;
    var phi_1787_: f32;
    var phi_1794_: f32;
    var phi_1811_: f32;
    var phi_1816_: f32;
    var phi_1821_: f32;
    var phi_1826_: f32;
    var phi_1831_: f32;
    var phi_1857_: bool;
    var phi_1858_: bool;
    var phi_1866_: u32;
    var phi_1867_: u32;
    var phi_1878_: vec3<f32>;
    var phi_1879_: vec3<f32>;
    var phi_1892_: u32;
    var phi_1897_: u32;
    var phi_1902_: u32;
    var phi_2016_: bool;
    var phi_2017_: bool;
    var phi_2048_: u32;
    var phi_2050_: u32;
    var phi_2053_: bool;
    var phi_2133_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2160_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2187_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2193_: u32;
    var phi_2196_: u32;
    var phi_2210_: u32;
    var phi_2220_: u32;
    var phi_2230_: u32;
    var phi_2248_: u32;
    var phi_2258_: u32;
    var phi_2268_: u32;
    var phi_2304_: u32;
    var phi_2317_: u32;
    var phi_2322_: u32;
    var phi_2323_: u32;
    var phi_2324_: u32;
    var phi_2194_: u32;
    var phi_2197_: u32;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_2382_: u32;
    var phi_2385_: bool;
    var phi_2429_: vec3<f32>;
    var phi_2430_: vec3<f32>;
    var phi_2459_: vec3<f32>;
    var phi_2460_: vec3<f32>;
    var phi_2489_: vec3<f32>;
    var phi_2490_: vec3<f32>;
    var phi_2508_: bool;
    var phi_2509_: bool;
    var phi_2513_: f32;
    var phi_2514_: f32;
    var phi_2515_: f32;
    var phi_2516_: f32;
    var phi_2524_: f32;
    var phi_2534_: bool;
    var phi_2535_: bool;
    var phi_2539_: f32;
    var phi_2540_: f32;
    var phi_2541_: f32;
    var phi_2542_: f32;
    var phi_2550_: f32;
    var phi_2560_: bool;
    var phi_2561_: bool;
    var phi_2565_: f32;
    var phi_2566_: f32;
    var phi_2567_: f32;
    var phi_2568_: f32;
    var phi_2576_: f32;
    var phi_2591_: f32;
    var phi_2592_: bool;
    var phi_2593_: f32;
    var phi_2594_: bool;
    var phi_2595_: f32;
    var phi_2596_: bool;
    var phi_2614_: f32;
    var phi_2615_: bool;
    var phi_2616_: bool;
    var phi_2617_: f32;
    var phi_2618_: bool;
    var phi_2619_: bool;
    var phi_2623_: bool;
    var phi_2624_: f32;
    var phi_2625_: bool;
    var phi_2653_: vec3<f32>;
    var phi_2654_: vec3<f32>;
    var phi_2679_: vec3<f32>;
    var phi_2680_: vec3<f32>;
    var phi_2705_: vec3<f32>;
    var phi_2706_: vec3<f32>;
    var phi_2762_: f32;
    var phi_2771_: f32;
    var phi_2780_: f32;
    var phi_2789_: f32;
    var phi_2796_: f32;
    var phi_2803_: f32;
    var phi_2816_: f32;
    var phi_2825_: f32;
    var phi_2834_: f32;
    var phi_2843_: f32;
    var phi_2850_: f32;
    var phi_2857_: f32;
    var phi_2874_: f32;
    var phi_2879_: f32;
    var phi_2884_: f32;
    var phi_2892_: f32;
    var phi_2897_: f32;
    var phi_2902_: f32;
    var phi_2914_: f32;
    var phi_2919_: f32;
    var phi_2924_: f32;
    var phi_2929_: f32;
    var phi_2934_: lt_bvh_triangle_Intersection;
    var phi_2935_: bool;
    var phi_2936_: lt_bvh_triangle_Intersection;
    var phi_2937_: bool;
    var phi_2941_: lt_bvh_triangle_Intersection;
    var phi_2942_: bool;
    var phi_2943_: lt_bvh_triangle_Intersection;
    var phi_2944_: bool;
    var phi_2945_: bool;
    var phi_2949_: bool;
    var phi_2953_: lt_bvh_triangle_Intersection;
    var phi_3167_: f32;
    var phi_3170_: bool;
    var phi_3171_: bool;
    var phi_3172_: bool;
    var phi_3176_: bool;
    var phi_3177_: bool;
    var phi_3178_: bool;
    var phi_3179_: bool;
    var phi_3180_: bool;
    var phi_3181_: bool;
    var phi_3182_: bool;
    var phi_3183_: bool;
    var phi_3184_: bool;
    var phi_3185_: bool;
    var phi_2383_: u32;
    var phi_2386_: bool;
    var phi_3189_: bool;
    var phi_3190_: bool;
    var local_9: bool;
    var phi_3232_: bool;
    var phi_3233_: bool;
    var phi_3264_: u32;
    var phi_3265_: u32;
    var phi_2051_: u32;
    var phi_2054_: bool;
    var phi_3266_: bool;
    var phi_3267_: bool;
    var phi_3268_: bool;
    var local_10: bool;
    var phi_3272_: bool;
    var phi_3276_: bool;
    var phi_3277_: bool;
    var phi_3278_: bool;
    var phi_3279_: bool;
    var phi_3283_: bool;
    var phi_3287_: bool;
    var phi_3288_: bool;
    var phi_3289_: bool;
    var phi_3290_: bool;
    var phi_3291_: bool;
    var phi_3292_: bool;
    var phi_3293_: bool;
    var phi_1436_: u32;
    var phi_1439_: bool;
    var phi_3297_: bool;
    var local_11: bool;
    var phi_3339_: bool;
    var phi_3340_: bool;
    var phi_3371_: u32;
    var phi_3372_: u32;
    var phi_1104_: u32;
    var phi_1107_: bool;
    var phi_3373_: bool;
    var phi_3374_: bool;
    var local_12: bool;
    var phi_3378_: bool;
    var phi_3382_: bool;
    var phi_3383_: bool;
    var phi_3384_: bool;
    var phi_3388_: bool;
    var phi_3389_: bool;
    var phi_3393_: bool;
    var phi_3397_: f32;
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
        let _e112 = p.member.root;
        if (_e110 < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e118 = samples.member[(0u + _e110)].position;
        let _e120 = samples.member[(0u + _e110)].normal;
        let _e122 = samples.member[(0u + _e110)].magnitude;
        let _e124 = ((8f / 8388608f) * _e122);
        let _e132 = (_e118.x + (_e120.x * _e124));
        let _e134 = (_e118.y + (_e120.y * _e124));
        let _e136 = (_e118.z + (_e120.z * _e124));
        let _e138 = p.member.light.place;
        if (_e138.w == 0f) {
            phi_698_ = 300000000000000000000000000000000000000f;
        } else {
            phi_698_ = 1f;
        }
        let _e142 = phi_698_;
        let _e150 = (_e138.x - (_e132 * _e138.w));
        let _e151 = (_e138.y - (_e134 * _e138.w));
        let _e152 = (_e138.z - (_e136 * _e138.w));
        let _e153 = abs(_e150);
        let _e154 = abs(_e151);
        let _e155 = abs(_e152);
        if (abs(_e132) < 1000000000000000f) {
            if (abs(_e134) < 1000000000000000f) {
                phi_730_ = (abs(_e136) < 1000000000000000f);
                phi_731_ = false;
            } else {
                phi_730_ = bool();
                phi_731_ = true;
            }
            let _e163 = phi_730_;
            let _e165 = phi_731_;
            phi_732_ = _e163;
            phi_733_ = _e165;
        } else {
            phi_732_ = bool();
            phi_733_ = true;
        }
        let _e167 = phi_732_;
        let _e169 = phi_733_;
        if _e169 {
            phi_737_ = false;
        } else {
            phi_737_ = _e167;
        }
        let _e171 = phi_737_;
        if _e171 {
            if (_e153 < 1000000000000000f) {
                if (_e154 < 1000000000000000f) {
                    phi_750_ = (_e155 < 1000000000000000f);
                    phi_751_ = false;
                } else {
                    phi_750_ = bool();
                    phi_751_ = true;
                }
                let _e176 = phi_750_;
                let _e178 = phi_751_;
                phi_752_ = _e176;
                phi_753_ = _e178;
            } else {
                phi_752_ = bool();
                phi_753_ = true;
            }
            let _e180 = phi_752_;
            let _e182 = phi_753_;
            if _e182 {
                phi_757_ = false;
            } else {
                phi_757_ = _e180;
            }
            let _e184 = phi_757_;
            if _e184 {
                if (_e153 > 0f) {
                    phi_771_ = bool();
                    phi_772_ = true;
                } else {
                    let _e186 = (_e154 > 0f);
                    if _e186 {
                        phi_770_ = bool();
                    } else {
                        phi_770_ = (_e155 > 0f);
                    }
                    let _e189 = phi_770_;
                    phi_771_ = _e189;
                    phi_772_ = _e186;
                }
                let _e191 = phi_771_;
                let _e193 = phi_772_;
                if _e193 {
                    phi_776_ = true;
                } else {
                    phi_776_ = _e191;
                }
                let _e195 = phi_776_;
                phi_777_ = _e195;
                phi_778_ = false;
            } else {
                phi_777_ = bool();
                phi_778_ = true;
            }
            let _e197 = phi_777_;
            let _e199 = phi_778_;
            phi_779_ = _e197;
            phi_780_ = _e199;
        } else {
            phi_779_ = bool();
            phi_780_ = true;
        }
        let _e201 = phi_779_;
        let _e203 = phi_780_;
        if _e203 {
            phi_784_ = false;
        } else {
            phi_784_ = _e201;
        }
        let _e205 = phi_784_;
        if _e205 {
            let _e206 = (_e112 >= _e76);
            if _e206 {
                phi_3382_ = false;
            } else {
                if (_e112 < _e76) {
                } else {
                    return;
                }
                let _e212 = nodes.member[(0u + _e112)].frame[0u];
                let _e216 = nodes.member[(0u + _e112)].frame[1u];
                let _e220 = nodes.member[(0u + _e112)].frame[2u];
                let _e224 = nodes.member[(0u + _e112)].frame[0u];
                let _e228 = nodes.member[(0u + _e112)].frame[1u];
                let _e232 = nodes.member[(0u + _e112)].frame[2u];
                let _e236 = nodes.member[(0u + _e112)].frame[3u];
                let _e270 = core_intrinsics_maximum_number_nsz_f32_(abs(_e150), abs(_e151));
                let _e271 = core_intrinsics_maximum_number_nsz_f32_(_e270, abs(_e152));
                let _e272 = (_e271 * 0.0000000000009094947f);
                if (abs(_e150) < _e272) {
                    phi_854_ = _e272;
                } else {
                    phi_854_ = abs(_e150);
                }
                let _e277 = phi_854_;
                if (_e150 < 0f) {
                    phi_861_ = (-1f / _e277);
                } else {
                    phi_861_ = (1f / _e277);
                }
                let _e282 = phi_861_;
                if (abs(_e151) < _e272) {
                    phi_868_ = _e272;
                } else {
                    phi_868_ = abs(_e151);
                }
                let _e287 = phi_868_;
                if (_e151 < 0f) {
                    phi_875_ = (-1f / _e287);
                } else {
                    phi_875_ = (1f / _e287);
                }
                let _e292 = phi_875_;
                if (abs(_e152) < _e272) {
                    phi_882_ = _e272;
                } else {
                    phi_882_ = abs(_e152);
                }
                let _e297 = phi_882_;
                if (_e152 < 0f) {
                    phi_889_ = (-1f / _e297);
                } else {
                    phi_889_ = (1f / _e297);
                }
                let _e302 = phi_889_;
                let _e306 = abs((bitcast<f32>(_e212) - _e132));
                let _e307 = abs((bitcast<f32>(_e216) - _e134));
                let _e308 = abs((bitcast<f32>(_e220) - _e136));
                let _e312 = abs(((bitcast<f32>(_e224) + (bitcast<f32>((((_e236 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e132));
                let _e313 = abs(((bitcast<f32>(_e228) + (bitcast<f32>((((_e236 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e134));
                let _e314 = abs(((bitcast<f32>(_e232) + (bitcast<f32>((((_e236 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e136));
                if (_e306 > _e312) {
                    phi_906_ = _e306;
                } else {
                    phi_906_ = _e312;
                }
                let _e317 = phi_906_;
                if (_e307 > _e313) {
                    phi_911_ = _e307;
                } else {
                    phi_911_ = _e313;
                }
                let _e320 = phi_911_;
                if (_e308 > _e314) {
                    phi_916_ = _e308;
                } else {
                    phi_916_ = _e314;
                }
                let _e323 = phi_916_;
                if (_e317 > _e320) {
                    phi_921_ = _e317;
                } else {
                    phi_921_ = _e320;
                }
                let _e326 = phi_921_;
                if (_e326 > _e323) {
                    phi_926_ = _e326;
                } else {
                    phi_926_ = _e323;
                }
                let _e329 = phi_926_;
                let _e333 = (_e329 * 0.0000019073486f);
                let _e334 = (abs(_e282) * _e333);
                let _e335 = (abs(_e292) * _e333);
                let _e336 = (abs(_e302) * _e333);
                let _e340 = (_e329 * 0.0000009536743f);
                let _e341 = (abs(_e282) * _e340);
                let _e342 = (abs(_e292) * _e340);
                let _e343 = (abs(_e302) * _e340);
                if (_e282 < 0f) {
                    phi_945_ = 0u;
                } else {
                    phi_945_ = 1u;
                }
                let _e346 = phi_945_;
                if (_e292 < 0f) {
                    phi_950_ = 0u;
                } else {
                    phi_950_ = 2u;
                }
                let _e349 = phi_950_;
                if (_e302 < 0f) {
                    phi_955_ = 0u;
                } else {
                    phi_955_ = 4u;
                }
                let _e352 = phi_955_;
                let _e354 = ((_e346 | _e349) | _e352);
                let _e355 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e112, 2147483648u);
                local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e355.first[0], _e355.first[1], _e355.first[2], _e355.first[3], _e355.first[4], _e355.first[5], _e355.first[6], _e355.first[7], _e355.first[8], _e355.first[9], _e355.first[10], _e355.first[11], _e355.first[12], _e355.first[13], _e355.first[14], _e355.first[15], _e355.first[16], _e355.first[17], _e355.first[18], _e355.first[19], _e355.first[20], _e355.first[21], _e355.first[22], _e355.first[23], _e355.first[24], _e355.first[25], _e355.first[26], _e355.first[27], _e355.first[28], _e355.first[29], _e355.first[30], _e355.first[31]), array<u32, 32>(_e355.mask[0], _e355.mask[1], _e355.mask[2], _e355.mask[3], _e355.mask[4], _e355.mask[5], _e355.mask[6], _e355.mask[7], _e355.mask[8], _e355.mask[9], _e355.mask[10], _e355.mask[11], _e355.mask[12], _e355.mask[13], _e355.mask[14], _e355.mask[15], _e355.mask[16], _e355.mask[17], _e355.mask[18], _e355.mask[19], _e355.mask[20], _e355.mask[21], _e355.mask[22], _e355.mask[23], _e355.mask[24], _e355.mask[25], _e355.mask[26], _e355.mask[27], _e355.mask[28], _e355.mask[29], _e355.mask[30], _e355.mask[31]), _e355.len, _e355.group, _e355.group_mask);
                let _e429 = local_2.group_mask;
                if ((_e429 & 4278190080u) == 0u) {
                    let _e433 = local_2.len;
                    if (_e433 == 0u) {
                        phi_1069_ = false;
                    } else {
                        let _e437 = local_2.len;
                        local_2.len = (_e437 - 1u);
                        let _e440 = local_2.len;
                        if (_e440 < 32u) {
                        } else {
                            return;
                        }
                        let _e445 = local_2.first[(0u + _e440)];
                        local_2.group = _e445;
                        let _e448 = local_2.len;
                        if (_e448 < 32u) {
                        } else {
                            return;
                        }
                        let _e453 = local_2.mask[(0u + _e448)];
                        local_2.group_mask = _e453;
                        phi_1069_ = true;
                    }
                    let _e456 = phi_1069_;
                    phi_1070_ = _e456;
                } else {
                    phi_1070_ = true;
                }
                let _e458 = phi_1070_;
                if _e458 {
                    let _e460 = local_2.group_mask;
                    let _e466 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e460)), 32u, (_e460 == 0u)));
                    let _e470 = local_2.group_mask;
                    let _e484 = local_2.group_mask;
                    local_2.group_mask = (_e484 & ~((1u << bitcast<u32>((_e466 & 31u)))));
                    let _e487 = local_2.group;
                    phi_1101_ = (_e487 + countOneBits(((_e470 & ~((4294967295u << bitcast<u32>((((_e466 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1101_ = 4294967295u;
                }
                let _e490 = phi_1101_;
                phi_1103_ = _e490;
                phi_1106_ = false;
                loop {
                    let _e492 = phi_1103_;
                    let _e494 = phi_1106_;
                    if (_e492 != 4294967295u) {
                        if (_e492 < _e76) {
                        } else {
                            return;
                        }
                        let _e501 = nodes.member[(0u + _e492)].frame[3u];
                        let _e526 = (bitcast<f32>((((_e501 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e282);
                        let _e527 = (bitcast<f32>((((_e501 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e292);
                        let _e528 = (bitcast<f32>((((_e501 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e302);
                        let _e531 = nodes.member[(0u + _e492)].frame[0u];
                        let _e535 = nodes.member[(0u + _e492)].frame[1u];
                        let _e539 = nodes.member[(0u + _e492)].frame[2u];
                        let _e544 = ((bitcast<f32>(_e531) - _e132) * _e282);
                        let _e545 = ((bitcast<f32>(_e535) - _e134) * _e292);
                        let _e546 = ((bitcast<f32>(_e539) - _e136) * _e302);
                        let _e554 = nodes.member[(0u + _e492)].x;
                        if (_e282 < 0f) {
                            let _e565 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e554.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e571 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e565.unnamed.root, _e554.w), _e565.unnamed_1);
                            let _e577 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e571.unnamed, lt_bvh_traverse_Tree(_e554.x, _e571.unnamed_1.first_primitive));
                            phi_1186_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e577.unnamed, lt_bvh_traverse_Tree(_e577.unnamed_1.root, _e554.y));
                        } else {
                            let _e593 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e554.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e599 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e593.unnamed.root, _e554.y), _e593.unnamed_1);
                            let _e605 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e599.unnamed, lt_bvh_traverse_Tree(_e554.z, _e599.unnamed_1.first_primitive));
                            phi_1186_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e605.unnamed, lt_bvh_traverse_Tree(_e605.unnamed_1.root, _e554.w));
                        }
                        let _e613 = phi_1186_;
                        let _e623 = nodes.member[(0u + _e492)].y;
                        if (_e292 < 0f) {
                            let _e634 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e623.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e640 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e634.unnamed.root, _e623.w), _e634.unnamed_1);
                            let _e646 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e640.unnamed, lt_bvh_traverse_Tree(_e623.x, _e640.unnamed_1.first_primitive));
                            phi_1213_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e646.unnamed, lt_bvh_traverse_Tree(_e646.unnamed_1.root, _e623.y));
                        } else {
                            let _e662 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e623.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e668 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e662.unnamed.root, _e623.y), _e662.unnamed_1);
                            let _e674 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e668.unnamed, lt_bvh_traverse_Tree(_e623.z, _e668.unnamed_1.first_primitive));
                            phi_1213_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e674.unnamed, lt_bvh_traverse_Tree(_e674.unnamed_1.root, _e623.w));
                        }
                        let _e682 = phi_1213_;
                        let _e692 = nodes.member[(0u + _e492)].z;
                        if (_e302 < 0f) {
                            let _e703 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e692.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e709 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e703.unnamed.root, _e692.w), _e703.unnamed_1);
                            let _e715 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e709.unnamed, lt_bvh_traverse_Tree(_e692.x, _e709.unnamed_1.first_primitive));
                            phi_1240_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e715.unnamed, lt_bvh_traverse_Tree(_e715.unnamed_1.root, _e692.y));
                        } else {
                            let _e731 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e692.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e737 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e731.unnamed.root, _e692.y), _e731.unnamed_1);
                            let _e743 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e737.unnamed, lt_bvh_traverse_Tree(_e692.z, _e737.unnamed_1.first_primitive));
                            phi_1240_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e743.unnamed, lt_bvh_traverse_Tree(_e743.unnamed_1.root, _e692.w));
                        }
                        let _e751 = phi_1240_;
                        phi_1246_ = 0u;
                        phi_1249_ = 0u;
                        loop {
                            let _e761 = phi_1246_;
                            let _e763 = phi_1249_;
                            local_3 = _e763;
                            local_4 = _e763;
                            local_5 = _e763;
                            let _e764 = (_e761 < 8u);
                            if _e764 {
                                let _e766 = (_e761 >> bitcast<u32>(2i));
                                let _e767 = (_e761 & 3u);
                                if (_e766 == 0u) {
                                    phi_1263_ = _e613.unnamed.root;
                                } else {
                                    phi_1263_ = _e613.unnamed.first_primitive;
                                }
                                let _e770 = phi_1263_;
                                if (_e766 == 0u) {
                                    phi_1273_ = _e682.unnamed.root;
                                } else {
                                    phi_1273_ = _e682.unnamed.first_primitive;
                                }
                                let _e779 = phi_1273_;
                                if (_e766 == 0u) {
                                    phi_1283_ = _e751.unnamed.root;
                                } else {
                                    phi_1283_ = _e751.unnamed.first_primitive;
                                }
                                let _e788 = phi_1283_;
                                let _e801 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e770 >> bitcast<u32>(((_e767 * 8u) & 31u))) & 255u)) * _e526) + (_e544 - _e334)), ((f32(((_e779 >> bitcast<u32>(((_e767 * 8u) & 31u))) & 255u)) * _e527) + (_e545 - _e335)));
                                let _e802 = core_intrinsics_maximum_number_nsz_f32_(_e801, ((f32(((_e788 >> bitcast<u32>(((_e767 * 8u) & 31u))) & 255u)) * _e528) + (_e546 - _e336)));
                                if (_e766 == 0u) {
                                    phi_1301_ = _e613.unnamed_1.root;
                                } else {
                                    phi_1301_ = _e613.unnamed_1.first_primitive;
                                }
                                let _e805 = phi_1301_;
                                if (_e766 == 0u) {
                                    phi_1311_ = _e682.unnamed_1.root;
                                } else {
                                    phi_1311_ = _e682.unnamed_1.first_primitive;
                                }
                                let _e814 = phi_1311_;
                                if (_e766 == 0u) {
                                    phi_1321_ = _e751.unnamed_1.root;
                                } else {
                                    phi_1321_ = _e751.unnamed_1.first_primitive;
                                }
                                let _e823 = phi_1321_;
                                let _e836 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e805 >> bitcast<u32>(((_e767 * 8u) & 31u))) & 255u)) * _e526) + (_e544 + _e334)), ((f32(((_e814 >> bitcast<u32>(((_e767 * 8u) & 31u))) & 255u)) * _e527) + (_e545 + _e335)));
                                let _e837 = core_intrinsics_minimum_number_nsz_f32_(_e836, ((f32(((_e823 >> bitcast<u32>(((_e767 * 8u) & 31u))) & 255u)) * _e528) + (_e546 + _e336)));
                                if (_e802 <= _e837) {
                                    if (_e802 <= _e142) {
                                        if (_e837 >= 0f) {
                                            if (_e766 == 0u) {
                                                let _e844 = nodes.member[(0u + _e492)].links[2u];
                                                phi_1357_ = _e844;
                                            } else {
                                                let _e847 = nodes.member[(0u + _e492)].links[3u];
                                                phi_1357_ = _e847;
                                            }
                                            let _e849 = phi_1357_;
                                            let _e854 = ((_e849 >> bitcast<u32>(((_e767 * 8u) & 31u))) & 255u);
                                            let _e855 = (_e854 & 31u);
                                            if (_e855 >= 24u) {
                                                phi_1370_ = (24u + ((_e855 - 24u) ^ _e354));
                                            } else {
                                                phi_1370_ = _e855;
                                            }
                                            let _e861 = phi_1370_;
                                            phi_1375_ = (_e763 | ((_e854 >> bitcast<u32>(5i)) << bitcast<u32>((_e861 & 31u))));
                                        } else {
                                            phi_1375_ = _e763;
                                        }
                                        let _e869 = phi_1375_;
                                        phi_1376_ = _e869;
                                    } else {
                                        phi_1376_ = _e763;
                                    }
                                    let _e871 = phi_1376_;
                                    phi_1377_ = _e871;
                                } else {
                                    phi_1377_ = _e763;
                                }
                                let _e873 = phi_1377_;
                                phi_1247_ = (_e761 + 1u);
                                phi_1250_ = _e873;
                            } else {
                                phi_1247_ = u32();
                                phi_1250_ = u32();
                            }
                            let _e876 = phi_1247_;
                            let _e878 = phi_1250_;
                            continue;
                            continuing {
                                phi_1246_ = _e876;
                                phi_1249_ = _e878;
                                break if !(_e764);
                            }
                        }
                        let _e882 = nodes.member[(0u + _e492)].links[0u];
                        let _e886 = nodes.member[(0u + _e492)].frame[3u];
                        let _e890 = local_3;
                        if ((_e890 & 4278190080u) == 0u) {
                        } else {
                            let _e894 = local_2.group_mask;
                            if ((_e894 & 4278190080u) == 0u) {
                            } else {
                                let _e898 = local_2.len;
                                if (_e898 < 32u) {
                                    let _e901 = local_2.group;
                                    let _e903 = local_2.len;
                                    if (_e903 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.first[(0u + _e903)] = _e901;
                                    let _e909 = local_2.group_mask;
                                    let _e911 = local_2.len;
                                    if (_e911 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.mask[(0u + _e911)] = _e909;
                                    let _e918 = local_2.len;
                                    local_2.len = (_e918 + 1u);
                                }
                            }
                            local_2.group = (_e112 + _e882);
                            let _e922 = local_4;
                            local_2.group_mask = ((_e922 & 4278190080u) | (_e886 >> bitcast<u32>(24i)));
                        }
                        let _e927 = local_5;
                        phi_1435_ = (_e927 & 16777215u);
                        phi_1438_ = _e494;
                        loop {
                            let _e930 = phi_1435_;
                            let _e932 = phi_1438_;
                            local_18 = _e932;
                            let _e933 = (_e930 == 0u);
                            local_11 = _e933;
                            local_19 = _e933;
                            if _e933 {
                                phi_1436_ = u32();
                                phi_1439_ = bool();
                                phi_3297_ = false;
                            } else {
                                let _e936 = nodes.member[(0u + _e492)].links[1u];
                                let _e940 = (_e936 + select(firstTrailingBit(_e930), 32u, (_e930 == 0u)));
                                if (_e940 < arrayLength((&instances.member))) {
                                } else {
                                    return;
                                }
                                let _e947 = instances.member[(0u + _e940)].low_world;
                                let _e949 = instances.member[(0u + _e940)].high_world;
                                let _e956 = ((_e947.x - _e132) * _e282);
                                let _e957 = ((_e947.y - _e134) * _e292);
                                let _e958 = ((_e947.z - _e136) * _e302);
                                let _e965 = ((_e949.x - _e132) * _e282);
                                let _e966 = ((_e949.y - _e134) * _e292);
                                let _e967 = ((_e949.z - _e136) * _e302);
                                if (_e956 < _e965) {
                                    phi_1487_ = _e956;
                                } else {
                                    phi_1487_ = _e965;
                                }
                                let _e970 = phi_1487_;
                                if (_e957 < _e966) {
                                    phi_1492_ = _e957;
                                } else {
                                    phi_1492_ = _e966;
                                }
                                let _e973 = phi_1492_;
                                if (_e958 < _e967) {
                                    phi_1497_ = _e958;
                                } else {
                                    phi_1497_ = _e967;
                                }
                                let _e976 = phi_1497_;
                                if (_e956 > _e965) {
                                    phi_1505_ = _e956;
                                } else {
                                    phi_1505_ = _e965;
                                }
                                let _e982 = phi_1505_;
                                if (_e957 > _e966) {
                                    phi_1510_ = _e957;
                                } else {
                                    phi_1510_ = _e966;
                                }
                                let _e985 = phi_1510_;
                                if (_e958 > _e967) {
                                    phi_1515_ = _e958;
                                } else {
                                    phi_1515_ = _e967;
                                }
                                let _e988 = phi_1515_;
                                let _e992 = core_intrinsics_maximum_number_nsz_f32_((_e970 - _e341), (_e973 - _e342));
                                let _e993 = core_intrinsics_maximum_number_nsz_f32_(_e992, (_e976 - _e343));
                                let _e994 = core_intrinsics_minimum_number_nsz_f32_((_e982 + _e341), (_e985 + _e342));
                                let _e995 = core_intrinsics_minimum_number_nsz_f32_(_e994, (_e988 + _e343));
                                if (_e993 <= _e995) {
                                    if (_e993 <= _e142) {
                                        if (_e995 >= 0f) {
                                            let _e1001 = instances.member[(0u + _e940)].world_to_object[0u];
                                            let _e1012 = ((((_e1001.x * _e132) + (_e1001.y * _e134)) + (_e1001.z * _e136)) + (_e1001.w * 1f));
                                            let _e1014 = instances.member[(0u + _e940)].world_to_object[1u];
                                            let _e1025 = ((((_e1014.x * _e132) + (_e1014.y * _e134)) + (_e1014.z * _e136)) + (_e1014.w * 1f));
                                            let _e1027 = instances.member[(0u + _e940)].world_to_object[2u];
                                            let _e1038 = ((((_e1027.x * _e132) + (_e1027.y * _e134)) + (_e1027.z * _e136)) + (_e1027.w * 1f));
                                            let _e1041 = instances.member[(0u + _e940)].world_to_object[0u];
                                            let _e1052 = ((((_e1041.x * _e150) + (_e1041.y * _e151)) + (_e1041.z * _e152)) + (_e1041.w * 0f));
                                            let _e1054 = instances.member[(0u + _e940)].world_to_object[1u];
                                            let _e1065 = ((((_e1054.x * _e150) + (_e1054.y * _e151)) + (_e1054.z * _e152)) + (_e1054.w * 0f));
                                            let _e1067 = instances.member[(0u + _e940)].world_to_object[2u];
                                            let _e1078 = ((((_e1067.x * _e150) + (_e1067.y * _e151)) + (_e1067.z * _e152)) + (_e1067.w * 0f));
                                            let _e1081 = instances.member[(0u + _e940)].root;
                                            let _e1083 = instances.member[(0u + _e940)].first_triangle;
                                            let _e1084 = abs(_e1052);
                                            let _e1085 = abs(_e1065);
                                            let _e1086 = abs(_e1078);
                                            if (abs(_e1012) < 1000000000000000f) {
                                                if (abs(_e1025) < 1000000000000000f) {
                                                    phi_1635_ = (abs(_e1038) < 1000000000000000f);
                                                    phi_1636_ = false;
                                                } else {
                                                    phi_1635_ = bool();
                                                    phi_1636_ = true;
                                                }
                                                let _e1094 = phi_1635_;
                                                let _e1096 = phi_1636_;
                                                phi_1637_ = _e1094;
                                                phi_1638_ = _e1096;
                                            } else {
                                                phi_1637_ = bool();
                                                phi_1638_ = true;
                                            }
                                            let _e1098 = phi_1637_;
                                            let _e1100 = phi_1638_;
                                            if _e1100 {
                                                phi_1642_ = false;
                                            } else {
                                                phi_1642_ = _e1098;
                                            }
                                            let _e1102 = phi_1642_;
                                            if _e1102 {
                                                if (_e1084 < 1000000000000000f) {
                                                    if (_e1085 < 1000000000000000f) {
                                                        phi_1655_ = (_e1086 < 1000000000000000f);
                                                        phi_1656_ = false;
                                                    } else {
                                                        phi_1655_ = bool();
                                                        phi_1656_ = true;
                                                    }
                                                    let _e1107 = phi_1655_;
                                                    let _e1109 = phi_1656_;
                                                    phi_1657_ = _e1107;
                                                    phi_1658_ = _e1109;
                                                } else {
                                                    phi_1657_ = bool();
                                                    phi_1658_ = true;
                                                }
                                                let _e1111 = phi_1657_;
                                                let _e1113 = phi_1658_;
                                                if _e1113 {
                                                    phi_1662_ = false;
                                                } else {
                                                    phi_1662_ = _e1111;
                                                }
                                                let _e1115 = phi_1662_;
                                                if _e1115 {
                                                    if (_e1084 > 0f) {
                                                        phi_1676_ = bool();
                                                        phi_1677_ = true;
                                                    } else {
                                                        let _e1117 = (_e1085 > 0f);
                                                        if _e1117 {
                                                            phi_1675_ = bool();
                                                        } else {
                                                            phi_1675_ = (_e1086 > 0f);
                                                        }
                                                        let _e1120 = phi_1675_;
                                                        phi_1676_ = _e1120;
                                                        phi_1677_ = _e1117;
                                                    }
                                                    let _e1122 = phi_1676_;
                                                    let _e1124 = phi_1677_;
                                                    if _e1124 {
                                                        phi_1681_ = true;
                                                    } else {
                                                        phi_1681_ = _e1122;
                                                    }
                                                    let _e1126 = phi_1681_;
                                                    phi_1682_ = _e1126;
                                                    phi_1683_ = false;
                                                } else {
                                                    phi_1682_ = bool();
                                                    phi_1683_ = true;
                                                }
                                                let _e1128 = phi_1682_;
                                                let _e1130 = phi_1683_;
                                                phi_1684_ = _e1128;
                                                phi_1685_ = _e1130;
                                            } else {
                                                phi_1684_ = bool();
                                                phi_1685_ = true;
                                            }
                                            let _e1132 = phi_1684_;
                                            let _e1134 = phi_1685_;
                                            if _e1134 {
                                                phi_1689_ = false;
                                            } else {
                                                phi_1689_ = _e1132;
                                            }
                                            let _e1136 = phi_1689_;
                                            if _e1136 {
                                                let _e1137 = (_e1081 >= _e76);
                                                if _e1137 {
                                                    phi_3277_ = bool();
                                                } else {
                                                    if (_e1081 < _e76) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1143 = nodes.member[(0u + _e1081)].frame[0u];
                                                    let _e1147 = nodes.member[(0u + _e1081)].frame[1u];
                                                    let _e1151 = nodes.member[(0u + _e1081)].frame[2u];
                                                    let _e1155 = nodes.member[(0u + _e1081)].frame[0u];
                                                    let _e1159 = nodes.member[(0u + _e1081)].frame[1u];
                                                    let _e1163 = nodes.member[(0u + _e1081)].frame[2u];
                                                    let _e1167 = nodes.member[(0u + _e1081)].frame[3u];
                                                    let _e1201 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1052), abs(_e1065));
                                                    let _e1202 = core_intrinsics_maximum_number_nsz_f32_(_e1201, abs(_e1078));
                                                    let _e1203 = (_e1202 * 0.0000000000009094947f);
                                                    if (abs(_e1052) < _e1203) {
                                                        phi_1759_ = _e1203;
                                                    } else {
                                                        phi_1759_ = abs(_e1052);
                                                    }
                                                    let _e1208 = phi_1759_;
                                                    if (_e1052 < 0f) {
                                                        phi_1766_ = (-1f / _e1208);
                                                    } else {
                                                        phi_1766_ = (1f / _e1208);
                                                    }
                                                    let _e1213 = phi_1766_;
                                                    if (abs(_e1065) < _e1203) {
                                                        phi_1773_ = _e1203;
                                                    } else {
                                                        phi_1773_ = abs(_e1065);
                                                    }
                                                    let _e1218 = phi_1773_;
                                                    if (_e1065 < 0f) {
                                                        phi_1780_ = (-1f / _e1218);
                                                    } else {
                                                        phi_1780_ = (1f / _e1218);
                                                    }
                                                    let _e1223 = phi_1780_;
                                                    if (abs(_e1078) < _e1203) {
                                                        phi_1787_ = _e1203;
                                                    } else {
                                                        phi_1787_ = abs(_e1078);
                                                    }
                                                    let _e1228 = phi_1787_;
                                                    if (_e1078 < 0f) {
                                                        phi_1794_ = (-1f / _e1228);
                                                    } else {
                                                        phi_1794_ = (1f / _e1228);
                                                    }
                                                    let _e1233 = phi_1794_;
                                                    let _e1237 = abs((bitcast<f32>(_e1143) - _e1012));
                                                    let _e1238 = abs((bitcast<f32>(_e1147) - _e1025));
                                                    let _e1239 = abs((bitcast<f32>(_e1151) - _e1038));
                                                    let _e1243 = abs(((bitcast<f32>(_e1155) + (bitcast<f32>((((_e1167 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1012));
                                                    let _e1244 = abs(((bitcast<f32>(_e1159) + (bitcast<f32>((((_e1167 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1025));
                                                    let _e1245 = abs(((bitcast<f32>(_e1163) + (bitcast<f32>((((_e1167 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1038));
                                                    if (_e1237 > _e1243) {
                                                        phi_1811_ = _e1237;
                                                    } else {
                                                        phi_1811_ = _e1243;
                                                    }
                                                    let _e1248 = phi_1811_;
                                                    if (_e1238 > _e1244) {
                                                        phi_1816_ = _e1238;
                                                    } else {
                                                        phi_1816_ = _e1244;
                                                    }
                                                    let _e1251 = phi_1816_;
                                                    if (_e1239 > _e1245) {
                                                        phi_1821_ = _e1239;
                                                    } else {
                                                        phi_1821_ = _e1245;
                                                    }
                                                    let _e1254 = phi_1821_;
                                                    if (_e1248 > _e1251) {
                                                        phi_1826_ = _e1248;
                                                    } else {
                                                        phi_1826_ = _e1251;
                                                    }
                                                    let _e1257 = phi_1826_;
                                                    if (_e1257 > _e1254) {
                                                        phi_1831_ = _e1257;
                                                    } else {
                                                        phi_1831_ = _e1254;
                                                    }
                                                    let _e1260 = phi_1831_;
                                                    let _e1264 = (_e1260 * 0.0000019073486f);
                                                    let _e1265 = (abs(_e1213) * _e1264);
                                                    let _e1266 = (abs(_e1223) * _e1264);
                                                    let _e1267 = (abs(_e1233) * _e1264);
                                                    let _e1271 = (_e1260 * 0.0000009536743f);
                                                    let _e1272 = (abs(_e1213) * _e1271);
                                                    let _e1273 = (abs(_e1223) * _e1271);
                                                    let _e1274 = (abs(_e1233) * _e1271);
                                                    let _e1275 = abs(_e1052);
                                                    let _e1276 = abs(_e1065);
                                                    let _e1277 = abs(_e1078);
                                                    if (_e1275 >= _e1276) {
                                                        if (_e1275 >= _e1277) {
                                                            phi_1857_ = false;
                                                        } else {
                                                            phi_1857_ = true;
                                                        }
                                                        let _e1281 = phi_1857_;
                                                        phi_1858_ = _e1281;
                                                    } else {
                                                        phi_1858_ = true;
                                                    }
                                                    let _e1283 = phi_1858_;
                                                    if _e1283 {
                                                        if (_e1276 >= _e1277) {
                                                            phi_1866_ = 1u;
                                                        } else {
                                                            phi_1866_ = 2u;
                                                        }
                                                        let _e1286 = phi_1866_;
                                                        phi_1867_ = _e1286;
                                                    } else {
                                                        phi_1867_ = 0u;
                                                    }
                                                    let _e1288 = phi_1867_;
                                                    if (_e1288 == 0u) {
                                                        phi_1879_ = vec3<f32>(_e1065, _e1078, _e1052);
                                                    } else {
                                                        if (_e1288 == 1u) {
                                                            phi_1878_ = vec3<f32>(_e1078, _e1052, _e1065);
                                                        } else {
                                                            phi_1878_ = vec3<f32>(_e1052, _e1065, _e1078);
                                                        }
                                                        let _e1294 = phi_1878_;
                                                        phi_1879_ = _e1294;
                                                    }
                                                    let _e1296 = phi_1879_;
                                                    let _e1299 = (_e1296.x / _e1296.z);
                                                    let _e1302 = (_e1296.y / _e1296.z);
                                                    if (_e1213 < 0f) {
                                                        phi_1892_ = 0u;
                                                    } else {
                                                        phi_1892_ = 1u;
                                                    }
                                                    let _e1307 = phi_1892_;
                                                    if (_e1223 < 0f) {
                                                        phi_1897_ = 0u;
                                                    } else {
                                                        phi_1897_ = 2u;
                                                    }
                                                    let _e1310 = phi_1897_;
                                                    if (_e1233 < 0f) {
                                                        phi_1902_ = 0u;
                                                    } else {
                                                        phi_1902_ = 4u;
                                                    }
                                                    let _e1313 = phi_1902_;
                                                    let _e1315 = ((_e1307 | _e1310) | _e1313);
                                                    let _e1316 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1081, 2147483648u);
                                                    local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e1316.first[0], _e1316.first[1], _e1316.first[2], _e1316.first[3], _e1316.first[4], _e1316.first[5], _e1316.first[6], _e1316.first[7], _e1316.first[8], _e1316.first[9], _e1316.first[10], _e1316.first[11], _e1316.first[12], _e1316.first[13], _e1316.first[14], _e1316.first[15], _e1316.first[16], _e1316.first[17], _e1316.first[18], _e1316.first[19], _e1316.first[20], _e1316.first[21], _e1316.first[22], _e1316.first[23], _e1316.first[24], _e1316.first[25], _e1316.first[26], _e1316.first[27], _e1316.first[28], _e1316.first[29], _e1316.first[30], _e1316.first[31]), array<u32, 32>(_e1316.mask[0], _e1316.mask[1], _e1316.mask[2], _e1316.mask[3], _e1316.mask[4], _e1316.mask[5], _e1316.mask[6], _e1316.mask[7], _e1316.mask[8], _e1316.mask[9], _e1316.mask[10], _e1316.mask[11], _e1316.mask[12], _e1316.mask[13], _e1316.mask[14], _e1316.mask[15], _e1316.mask[16], _e1316.mask[17], _e1316.mask[18], _e1316.mask[19], _e1316.mask[20], _e1316.mask[21], _e1316.mask[22], _e1316.mask[23], _e1316.mask[24], _e1316.mask[25], _e1316.mask[26], _e1316.mask[27], _e1316.mask[28], _e1316.mask[29], _e1316.mask[30], _e1316.mask[31]), _e1316.len, _e1316.group, _e1316.group_mask);
                                                    let _e1390 = local_1.group_mask;
                                                    if ((_e1390 & 4278190080u) == 0u) {
                                                        let _e1394 = local_1.len;
                                                        if (_e1394 == 0u) {
                                                            phi_2016_ = false;
                                                        } else {
                                                            let _e1398 = local_1.len;
                                                            local_1.len = (_e1398 - 1u);
                                                            let _e1401 = local_1.len;
                                                            if (_e1401 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1406 = local_1.first[(0u + _e1401)];
                                                            local_1.group = _e1406;
                                                            let _e1409 = local_1.len;
                                                            if (_e1409 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1414 = local_1.mask[(0u + _e1409)];
                                                            local_1.group_mask = _e1414;
                                                            phi_2016_ = true;
                                                        }
                                                        let _e1417 = phi_2016_;
                                                        phi_2017_ = _e1417;
                                                    } else {
                                                        phi_2017_ = true;
                                                    }
                                                    let _e1419 = phi_2017_;
                                                    if _e1419 {
                                                        let _e1421 = local_1.group_mask;
                                                        let _e1427 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1421)), 32u, (_e1421 == 0u)));
                                                        let _e1431 = local_1.group_mask;
                                                        let _e1445 = local_1.group_mask;
                                                        local_1.group_mask = (_e1445 & ~((1u << bitcast<u32>((_e1427 & 31u)))));
                                                        let _e1448 = local_1.group;
                                                        phi_2048_ = (_e1448 + countOneBits(((_e1431 & ~((4294967295u << bitcast<u32>((((_e1427 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_2048_ = 4294967295u;
                                                    }
                                                    let _e1451 = phi_2048_;
                                                    phi_2050_ = _e1451;
                                                    phi_2053_ = _e932;
                                                    loop {
                                                        let _e1453 = phi_2050_;
                                                        let _e1455 = phi_2053_;
                                                        local_17 = _e1455;
                                                        if (_e1453 != 4294967295u) {
                                                            if (_e1453 < _e76) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1462 = nodes.member[(0u + _e1453)].frame[3u];
                                                            let _e1487 = (bitcast<f32>((((_e1462 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1213);
                                                            let _e1488 = (bitcast<f32>((((_e1462 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1223);
                                                            let _e1489 = (bitcast<f32>((((_e1462 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1233);
                                                            let _e1492 = nodes.member[(0u + _e1453)].frame[0u];
                                                            let _e1496 = nodes.member[(0u + _e1453)].frame[1u];
                                                            let _e1500 = nodes.member[(0u + _e1453)].frame[2u];
                                                            let _e1505 = ((bitcast<f32>(_e1492) - _e1012) * _e1213);
                                                            let _e1506 = ((bitcast<f32>(_e1496) - _e1025) * _e1223);
                                                            let _e1507 = ((bitcast<f32>(_e1500) - _e1038) * _e1233);
                                                            let _e1515 = nodes.member[(0u + _e1453)].x;
                                                            if (_e1213 < 0f) {
                                                                let _e1526 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1515.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1532 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1526.unnamed.root, _e1515.w), _e1526.unnamed_1);
                                                                let _e1538 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1532.unnamed, lt_bvh_traverse_Tree(_e1515.x, _e1532.unnamed_1.first_primitive));
                                                                phi_2133_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1538.unnamed, lt_bvh_traverse_Tree(_e1538.unnamed_1.root, _e1515.y));
                                                            } else {
                                                                let _e1554 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1515.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1560 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1554.unnamed.root, _e1515.y), _e1554.unnamed_1);
                                                                let _e1566 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1560.unnamed, lt_bvh_traverse_Tree(_e1515.z, _e1560.unnamed_1.first_primitive));
                                                                phi_2133_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1566.unnamed, lt_bvh_traverse_Tree(_e1566.unnamed_1.root, _e1515.w));
                                                            }
                                                            let _e1574 = phi_2133_;
                                                            let _e1584 = nodes.member[(0u + _e1453)].y;
                                                            if (_e1223 < 0f) {
                                                                let _e1595 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1584.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1601 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1595.unnamed.root, _e1584.w), _e1595.unnamed_1);
                                                                let _e1607 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1601.unnamed, lt_bvh_traverse_Tree(_e1584.x, _e1601.unnamed_1.first_primitive));
                                                                phi_2160_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1607.unnamed, lt_bvh_traverse_Tree(_e1607.unnamed_1.root, _e1584.y));
                                                            } else {
                                                                let _e1623 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1584.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1629 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1623.unnamed.root, _e1584.y), _e1623.unnamed_1);
                                                                let _e1635 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1629.unnamed, lt_bvh_traverse_Tree(_e1584.z, _e1629.unnamed_1.first_primitive));
                                                                phi_2160_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1635.unnamed, lt_bvh_traverse_Tree(_e1635.unnamed_1.root, _e1584.w));
                                                            }
                                                            let _e1643 = phi_2160_;
                                                            let _e1653 = nodes.member[(0u + _e1453)].z;
                                                            if (_e1233 < 0f) {
                                                                let _e1664 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1653.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1670 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1664.unnamed.root, _e1653.w), _e1664.unnamed_1);
                                                                let _e1676 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1670.unnamed, lt_bvh_traverse_Tree(_e1653.x, _e1670.unnamed_1.first_primitive));
                                                                phi_2187_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1676.unnamed, lt_bvh_traverse_Tree(_e1676.unnamed_1.root, _e1653.y));
                                                            } else {
                                                                let _e1692 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1653.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1698 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1692.unnamed.root, _e1653.y), _e1692.unnamed_1);
                                                                let _e1704 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1698.unnamed, lt_bvh_traverse_Tree(_e1653.z, _e1698.unnamed_1.first_primitive));
                                                                phi_2187_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1704.unnamed, lt_bvh_traverse_Tree(_e1704.unnamed_1.root, _e1653.w));
                                                            }
                                                            let _e1712 = phi_2187_;
                                                            phi_2193_ = 0u;
                                                            phi_2196_ = 0u;
                                                            loop {
                                                                let _e1722 = phi_2193_;
                                                                let _e1724 = phi_2196_;
                                                                local_6 = _e1724;
                                                                local_7 = _e1724;
                                                                local_8 = _e1724;
                                                                let _e1725 = (_e1722 < 8u);
                                                                if _e1725 {
                                                                    let _e1727 = (_e1722 >> bitcast<u32>(2i));
                                                                    let _e1728 = (_e1722 & 3u);
                                                                    if (_e1727 == 0u) {
                                                                        phi_2210_ = _e1574.unnamed.root;
                                                                    } else {
                                                                        phi_2210_ = _e1574.unnamed.first_primitive;
                                                                    }
                                                                    let _e1731 = phi_2210_;
                                                                    if (_e1727 == 0u) {
                                                                        phi_2220_ = _e1643.unnamed.root;
                                                                    } else {
                                                                        phi_2220_ = _e1643.unnamed.first_primitive;
                                                                    }
                                                                    let _e1740 = phi_2220_;
                                                                    if (_e1727 == 0u) {
                                                                        phi_2230_ = _e1712.unnamed.root;
                                                                    } else {
                                                                        phi_2230_ = _e1712.unnamed.first_primitive;
                                                                    }
                                                                    let _e1749 = phi_2230_;
                                                                    let _e1762 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1731 >> bitcast<u32>(((_e1728 * 8u) & 31u))) & 255u)) * _e1487) + (_e1505 - _e1265)), ((f32(((_e1740 >> bitcast<u32>(((_e1728 * 8u) & 31u))) & 255u)) * _e1488) + (_e1506 - _e1266)));
                                                                    let _e1763 = core_intrinsics_maximum_number_nsz_f32_(_e1762, ((f32(((_e1749 >> bitcast<u32>(((_e1728 * 8u) & 31u))) & 255u)) * _e1489) + (_e1507 - _e1267)));
                                                                    if (_e1727 == 0u) {
                                                                        phi_2248_ = _e1574.unnamed_1.root;
                                                                    } else {
                                                                        phi_2248_ = _e1574.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1766 = phi_2248_;
                                                                    if (_e1727 == 0u) {
                                                                        phi_2258_ = _e1643.unnamed_1.root;
                                                                    } else {
                                                                        phi_2258_ = _e1643.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1775 = phi_2258_;
                                                                    if (_e1727 == 0u) {
                                                                        phi_2268_ = _e1712.unnamed_1.root;
                                                                    } else {
                                                                        phi_2268_ = _e1712.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1784 = phi_2268_;
                                                                    let _e1797 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1766 >> bitcast<u32>(((_e1728 * 8u) & 31u))) & 255u)) * _e1487) + (_e1505 + _e1265)), ((f32(((_e1775 >> bitcast<u32>(((_e1728 * 8u) & 31u))) & 255u)) * _e1488) + (_e1506 + _e1266)));
                                                                    let _e1798 = core_intrinsics_minimum_number_nsz_f32_(_e1797, ((f32(((_e1784 >> bitcast<u32>(((_e1728 * 8u) & 31u))) & 255u)) * _e1489) + (_e1507 + _e1267)));
                                                                    if (_e1763 <= _e1798) {
                                                                        if (_e1763 <= _e142) {
                                                                            if (_e1798 >= 0f) {
                                                                                if (_e1727 == 0u) {
                                                                                    let _e1805 = nodes.member[(0u + _e1453)].links[2u];
                                                                                    phi_2304_ = _e1805;
                                                                                } else {
                                                                                    let _e1808 = nodes.member[(0u + _e1453)].links[3u];
                                                                                    phi_2304_ = _e1808;
                                                                                }
                                                                                let _e1810 = phi_2304_;
                                                                                let _e1815 = ((_e1810 >> bitcast<u32>(((_e1728 * 8u) & 31u))) & 255u);
                                                                                let _e1816 = (_e1815 & 31u);
                                                                                if (_e1816 >= 24u) {
                                                                                    phi_2317_ = (24u + ((_e1816 - 24u) ^ _e1315));
                                                                                } else {
                                                                                    phi_2317_ = _e1816;
                                                                                }
                                                                                let _e1822 = phi_2317_;
                                                                                phi_2322_ = (_e1724 | ((_e1815 >> bitcast<u32>(5i)) << bitcast<u32>((_e1822 & 31u))));
                                                                            } else {
                                                                                phi_2322_ = _e1724;
                                                                            }
                                                                            let _e1830 = phi_2322_;
                                                                            phi_2323_ = _e1830;
                                                                        } else {
                                                                            phi_2323_ = _e1724;
                                                                        }
                                                                        let _e1832 = phi_2323_;
                                                                        phi_2324_ = _e1832;
                                                                    } else {
                                                                        phi_2324_ = _e1724;
                                                                    }
                                                                    let _e1834 = phi_2324_;
                                                                    phi_2194_ = (_e1722 + 1u);
                                                                    phi_2197_ = _e1834;
                                                                } else {
                                                                    phi_2194_ = u32();
                                                                    phi_2197_ = u32();
                                                                }
                                                                let _e1837 = phi_2194_;
                                                                let _e1839 = phi_2197_;
                                                                continue;
                                                                continuing {
                                                                    phi_2193_ = _e1837;
                                                                    phi_2196_ = _e1839;
                                                                    break if !(_e1725);
                                                                }
                                                            }
                                                            let _e1843 = nodes.member[(0u + _e1453)].links[0u];
                                                            let _e1847 = nodes.member[(0u + _e1453)].frame[3u];
                                                            let _e1851 = local_6;
                                                            if ((_e1851 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1855 = local_1.group_mask;
                                                                if ((_e1855 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1859 = local_1.len;
                                                                    if (_e1859 < 32u) {
                                                                        let _e1862 = local_1.group;
                                                                        let _e1864 = local_1.len;
                                                                        if (_e1864 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.first[(0u + _e1864)] = _e1862;
                                                                        let _e1870 = local_1.group_mask;
                                                                        let _e1872 = local_1.len;
                                                                        if (_e1872 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.mask[(0u + _e1872)] = _e1870;
                                                                        let _e1879 = local_1.len;
                                                                        local_1.len = (_e1879 + 1u);
                                                                    }
                                                                }
                                                                local_1.group = (_e1081 + _e1843);
                                                                let _e1883 = local_7;
                                                                local_1.group_mask = ((_e1883 & 4278190080u) | (_e1847 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1888 = local_8;
                                                            phi_2382_ = (_e1888 & 16777215u);
                                                            phi_2385_ = _e1455;
                                                            loop {
                                                                let _e1891 = phi_2382_;
                                                                let _e1893 = phi_2385_;
                                                                local_13 = _e1893;
                                                                let _e1894 = (_e1891 == 0u);
                                                                local_9 = _e1894;
                                                                local_15 = _e1894;
                                                                if _e1894 {
                                                                    phi_2383_ = u32();
                                                                    phi_2386_ = bool();
                                                                    phi_3189_ = bool();
                                                                    phi_3190_ = false;
                                                                } else {
                                                                    let _e1897 = nodes.member[(0u + _e1453)].links[1u];
                                                                    let _e1902 = ((_e1083 + _e1897) + select(firstTrailingBit(_e1891), 32u, (_e1891 == 0u)));
                                                                    if (_e1902 < _e79) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1909 = triangles.member[(0u + _e1902)].v0_;
                                                                    let _e1911 = (_e1909.x - _e1012);
                                                                    let _e1913 = (_e1909.y - _e1025);
                                                                    let _e1915 = (_e1909.z - _e1038);
                                                                    if (_e1288 == 0u) {
                                                                        phi_2430_ = vec3<f32>(_e1913, _e1915, _e1911);
                                                                    } else {
                                                                        if (_e1288 == 1u) {
                                                                            phi_2429_ = vec3<f32>(_e1915, _e1911, _e1913);
                                                                        } else {
                                                                            phi_2429_ = (_e1909 - vec3<f32>(_e1012, _e1025, _e1038));
                                                                        }
                                                                        let _e1923 = phi_2429_;
                                                                        phi_2430_ = _e1923;
                                                                    }
                                                                    let _e1925 = phi_2430_;
                                                                    let _e1929 = (_e1925.x - (_e1299 * _e1925.z));
                                                                    let _e1933 = (_e1925.y - (_e1302 * _e1925.z));
                                                                    let _e1935 = triangles.member[(0u + _e1902)].v1_;
                                                                    let _e1937 = (_e1935.x - _e1012);
                                                                    let _e1939 = (_e1935.y - _e1025);
                                                                    let _e1941 = (_e1935.z - _e1038);
                                                                    if (_e1288 == 0u) {
                                                                        phi_2460_ = vec3<f32>(_e1939, _e1941, _e1937);
                                                                    } else {
                                                                        if (_e1288 == 1u) {
                                                                            phi_2459_ = vec3<f32>(_e1941, _e1937, _e1939);
                                                                        } else {
                                                                            phi_2459_ = (_e1935 - vec3<f32>(_e1012, _e1025, _e1038));
                                                                        }
                                                                        let _e1949 = phi_2459_;
                                                                        phi_2460_ = _e1949;
                                                                    }
                                                                    let _e1951 = phi_2460_;
                                                                    let _e1955 = (_e1951.x - (_e1299 * _e1951.z));
                                                                    let _e1959 = (_e1951.y - (_e1302 * _e1951.z));
                                                                    let _e1961 = triangles.member[(0u + _e1902)].v2_;
                                                                    let _e1963 = (_e1961.x - _e1012);
                                                                    let _e1965 = (_e1961.y - _e1025);
                                                                    let _e1967 = (_e1961.z - _e1038);
                                                                    if (_e1288 == 0u) {
                                                                        phi_2490_ = vec3<f32>(_e1965, _e1967, _e1963);
                                                                    } else {
                                                                        if (_e1288 == 1u) {
                                                                            phi_2489_ = vec3<f32>(_e1967, _e1963, _e1965);
                                                                        } else {
                                                                            phi_2489_ = (_e1961 - vec3<f32>(_e1012, _e1025, _e1038));
                                                                        }
                                                                        let _e1975 = phi_2489_;
                                                                        phi_2490_ = _e1975;
                                                                    }
                                                                    let _e1977 = phi_2490_;
                                                                    let _e1981 = (_e1977.x - (_e1299 * _e1977.z));
                                                                    let _e1985 = (_e1977.y - (_e1302 * _e1977.z));
                                                                    if (_e1955 < _e1981) {
                                                                        phi_2509_ = true;
                                                                    } else {
                                                                        if (_e1955 == _e1981) {
                                                                            phi_2508_ = (_e1959 < _e1985);
                                                                        } else {
                                                                            phi_2508_ = false;
                                                                        }
                                                                        let _e1990 = phi_2508_;
                                                                        phi_2509_ = _e1990;
                                                                    }
                                                                    let _e1992 = phi_2509_;
                                                                    if _e1992 {
                                                                        phi_2513_ = _e1985;
                                                                        phi_2514_ = _e1981;
                                                                        phi_2515_ = _e1959;
                                                                        phi_2516_ = _e1955;
                                                                    } else {
                                                                        phi_2513_ = _e1959;
                                                                        phi_2514_ = _e1955;
                                                                        phi_2515_ = _e1985;
                                                                        phi_2516_ = _e1981;
                                                                    }
                                                                    let _e1994 = phi_2513_;
                                                                    let _e1996 = phi_2514_;
                                                                    let _e1998 = phi_2515_;
                                                                    let _e2000 = phi_2516_;
                                                                    let _e2003 = ((_e2000 * _e1994) - (_e1998 * _e1996));
                                                                    if _e1992 {
                                                                        phi_2524_ = -(_e2003);
                                                                    } else {
                                                                        phi_2524_ = _e2003;
                                                                    }
                                                                    let _e2006 = phi_2524_;
                                                                    if (_e1981 < _e1929) {
                                                                        phi_2535_ = true;
                                                                    } else {
                                                                        if (_e1981 == _e1929) {
                                                                            phi_2534_ = (_e1985 < _e1933);
                                                                        } else {
                                                                            phi_2534_ = false;
                                                                        }
                                                                        let _e2011 = phi_2534_;
                                                                        phi_2535_ = _e2011;
                                                                    }
                                                                    let _e2013 = phi_2535_;
                                                                    if _e2013 {
                                                                        phi_2539_ = _e1933;
                                                                        phi_2540_ = _e1929;
                                                                        phi_2541_ = _e1985;
                                                                        phi_2542_ = _e1981;
                                                                    } else {
                                                                        phi_2539_ = _e1985;
                                                                        phi_2540_ = _e1981;
                                                                        phi_2541_ = _e1933;
                                                                        phi_2542_ = _e1929;
                                                                    }
                                                                    let _e2015 = phi_2539_;
                                                                    let _e2017 = phi_2540_;
                                                                    let _e2019 = phi_2541_;
                                                                    let _e2021 = phi_2542_;
                                                                    let _e2024 = ((_e2021 * _e2015) - (_e2019 * _e2017));
                                                                    if _e2013 {
                                                                        phi_2550_ = -(_e2024);
                                                                    } else {
                                                                        phi_2550_ = _e2024;
                                                                    }
                                                                    let _e2027 = phi_2550_;
                                                                    if (_e1929 < _e1955) {
                                                                        phi_2561_ = true;
                                                                    } else {
                                                                        if (_e1929 == _e1955) {
                                                                            phi_2560_ = (_e1933 < _e1959);
                                                                        } else {
                                                                            phi_2560_ = false;
                                                                        }
                                                                        let _e2032 = phi_2560_;
                                                                        phi_2561_ = _e2032;
                                                                    }
                                                                    let _e2034 = phi_2561_;
                                                                    if _e2034 {
                                                                        phi_2565_ = _e1959;
                                                                        phi_2566_ = _e1955;
                                                                        phi_2567_ = _e1933;
                                                                        phi_2568_ = _e1929;
                                                                    } else {
                                                                        phi_2565_ = _e1933;
                                                                        phi_2566_ = _e1929;
                                                                        phi_2567_ = _e1959;
                                                                        phi_2568_ = _e1955;
                                                                    }
                                                                    let _e2036 = phi_2565_;
                                                                    let _e2038 = phi_2566_;
                                                                    let _e2040 = phi_2567_;
                                                                    let _e2042 = phi_2568_;
                                                                    let _e2045 = ((_e2042 * _e2036) - (_e2040 * _e2038));
                                                                    if _e2034 {
                                                                        phi_2576_ = -(_e2045);
                                                                    } else {
                                                                        phi_2576_ = _e2045;
                                                                    }
                                                                    let _e2048 = phi_2576_;
                                                                    if (_e2006 >= 0f) {
                                                                        if (_e2027 >= 0f) {
                                                                            if (_e2048 >= 0f) {
                                                                                phi_2591_ = ((_e2006 + _e2027) + _e2048);
                                                                                phi_2592_ = false;
                                                                            } else {
                                                                                phi_2591_ = f32();
                                                                                phi_2592_ = true;
                                                                            }
                                                                            let _e2055 = phi_2591_;
                                                                            let _e2057 = phi_2592_;
                                                                            phi_2593_ = _e2055;
                                                                            phi_2594_ = _e2057;
                                                                        } else {
                                                                            phi_2593_ = f32();
                                                                            phi_2594_ = true;
                                                                        }
                                                                        let _e2059 = phi_2593_;
                                                                        let _e2061 = phi_2594_;
                                                                        phi_2595_ = _e2059;
                                                                        phi_2596_ = _e2061;
                                                                    } else {
                                                                        phi_2595_ = f32();
                                                                        phi_2596_ = true;
                                                                    }
                                                                    let _e2063 = phi_2595_;
                                                                    let _e2065 = phi_2596_;
                                                                    if _e2065 {
                                                                        if (_e2006 <= 0f) {
                                                                            if (_e2027 <= 0f) {
                                                                                let _e2068 = (_e2048 <= 0f);
                                                                                if _e2068 {
                                                                                }
                                                                                phi_2614_ = ((_e2006 + _e2027) + _e2048);
                                                                                phi_2615_ = false;
                                                                                phi_2616_ = _e2068;
                                                                            } else {
                                                                                phi_2614_ = f32();
                                                                                phi_2615_ = true;
                                                                                phi_2616_ = false;
                                                                            }
                                                                            let _e2072 = phi_2614_;
                                                                            let _e2074 = phi_2615_;
                                                                            let _e2076 = phi_2616_;
                                                                            phi_2617_ = _e2072;
                                                                            phi_2618_ = _e2074;
                                                                            phi_2619_ = _e2076;
                                                                        } else {
                                                                            phi_2617_ = f32();
                                                                            phi_2618_ = true;
                                                                            phi_2619_ = false;
                                                                        }
                                                                        let _e2078 = phi_2617_;
                                                                        let _e2080 = phi_2618_;
                                                                        let _e2082 = phi_2619_;
                                                                        if _e2080 {
                                                                            phi_2623_ = false;
                                                                        } else {
                                                                            phi_2623_ = _e2082;
                                                                        }
                                                                        let _e2084 = phi_2623_;
                                                                        phi_2624_ = _e2078;
                                                                        phi_2625_ = _e2084;
                                                                    } else {
                                                                        phi_2624_ = _e2063;
                                                                        phi_2625_ = true;
                                                                    }
                                                                    let _e2086 = phi_2624_;
                                                                    let _e2088 = phi_2625_;
                                                                    if _e2088 {
                                                                        let _e2089 = (_e2086 == 0f);
                                                                        if _e2089 {
                                                                            phi_2941_ = lt_bvh_triangle_Intersection();
                                                                            phi_2942_ = false;
                                                                        } else {
                                                                            let _e2091 = triangles.member[(0u + _e1902)].v0_;
                                                                            let _e2093 = (_e2091.x - _e1012);
                                                                            let _e2095 = (_e2091.y - _e1025);
                                                                            let _e2097 = (_e2091.z - _e1038);
                                                                            if (_e1288 == 0u) {
                                                                                phi_2654_ = vec3<f32>(_e2095, _e2097, _e2093);
                                                                            } else {
                                                                                if (_e1288 == 1u) {
                                                                                    phi_2653_ = vec3<f32>(_e2097, _e2093, _e2095);
                                                                                } else {
                                                                                    phi_2653_ = (_e2091 - vec3<f32>(_e1012, _e1025, _e1038));
                                                                                }
                                                                                let _e2105 = phi_2653_;
                                                                                phi_2654_ = _e2105;
                                                                            }
                                                                            let _e2107 = phi_2654_;
                                                                            let _e2109 = triangles.member[(0u + _e1902)].v1_;
                                                                            let _e2111 = triangles.member[(0u + _e1902)].v0_;
                                                                            let _e2114 = (_e2109.x - _e2111.x);
                                                                            let _e2117 = (_e2109.y - _e2111.y);
                                                                            let _e2120 = (_e2109.z - _e2111.z);
                                                                            if (_e1288 == 0u) {
                                                                                phi_2680_ = vec3<f32>(_e2117, _e2120, _e2114);
                                                                            } else {
                                                                                if (_e1288 == 1u) {
                                                                                    phi_2679_ = vec3<f32>(_e2120, _e2114, _e2117);
                                                                                } else {
                                                                                    phi_2679_ = (_e2109 - _e2111);
                                                                                }
                                                                                let _e2127 = phi_2679_;
                                                                                phi_2680_ = _e2127;
                                                                            }
                                                                            let _e2129 = phi_2680_;
                                                                            let _e2131 = triangles.member[(0u + _e1902)].v2_;
                                                                            let _e2133 = triangles.member[(0u + _e1902)].v0_;
                                                                            let _e2136 = (_e2131.x - _e2133.x);
                                                                            let _e2139 = (_e2131.y - _e2133.y);
                                                                            let _e2142 = (_e2131.z - _e2133.z);
                                                                            if (_e1288 == 0u) {
                                                                                phi_2706_ = vec3<f32>(_e2139, _e2142, _e2136);
                                                                            } else {
                                                                                if (_e1288 == 1u) {
                                                                                    phi_2705_ = vec3<f32>(_e2142, _e2136, _e2139);
                                                                                } else {
                                                                                    phi_2705_ = (_e2131 - _e2133);
                                                                                }
                                                                                let _e2149 = phi_2705_;
                                                                                phi_2706_ = _e2149;
                                                                            }
                                                                            let _e2151 = phi_2706_;
                                                                            let _e2158 = ((_e2129.y * _e2151.z) - (_e2129.z * _e2151.y));
                                                                            let _e2165 = ((_e2129.z * _e2151.x) - (_e2129.x * _e2151.z));
                                                                            let _e2172 = ((_e2129.x * _e2151.y) - (_e2129.y * _e2151.x));
                                                                            let _e2186 = (((1f / _e1296.z) * (((_e2158 * _e2107.x) + (_e2165 * _e2107.y)) + (_e2172 * _e2107.z))) / (((_e2158 * _e1299) + (_e2165 * _e1302)) + _e2172));
                                                                            if (_e2186 > 0f) {
                                                                                if (_e2186 < _e142) {
                                                                                    let _e2190 = triangles.member[(0u + _e1902)].v0_;
                                                                                    let _e2192 = triangles.member[(0u + _e1902)].v1_;
                                                                                    if (_e2190.x < _e2192.x) {
                                                                                        phi_2762_ = _e2190.x;
                                                                                    } else {
                                                                                        phi_2762_ = _e2192.x;
                                                                                    }
                                                                                    let _e2199 = phi_2762_;
                                                                                    if (_e2190.y < _e2192.y) {
                                                                                        phi_2771_ = _e2190.y;
                                                                                    } else {
                                                                                        phi_2771_ = _e2192.y;
                                                                                    }
                                                                                    let _e2206 = phi_2771_;
                                                                                    if (_e2190.z < _e2192.z) {
                                                                                        phi_2780_ = _e2190.z;
                                                                                    } else {
                                                                                        phi_2780_ = _e2192.z;
                                                                                    }
                                                                                    let _e2213 = phi_2780_;
                                                                                    let _e2215 = triangles.member[(0u + _e1902)].v2_;
                                                                                    if (_e2199 < _e2215.x) {
                                                                                        phi_2789_ = _e2199;
                                                                                    } else {
                                                                                        phi_2789_ = _e2215.x;
                                                                                    }
                                                                                    let _e2220 = phi_2789_;
                                                                                    if (_e2206 < _e2215.y) {
                                                                                        phi_2796_ = _e2206;
                                                                                    } else {
                                                                                        phi_2796_ = _e2215.y;
                                                                                    }
                                                                                    let _e2225 = phi_2796_;
                                                                                    if (_e2213 < _e2215.z) {
                                                                                        phi_2803_ = _e2213;
                                                                                    } else {
                                                                                        phi_2803_ = _e2215.z;
                                                                                    }
                                                                                    let _e2230 = phi_2803_;
                                                                                    let _e2232 = triangles.member[(0u + _e1902)].v0_;
                                                                                    let _e2234 = triangles.member[(0u + _e1902)].v1_;
                                                                                    if (_e2232.x > _e2234.x) {
                                                                                        phi_2816_ = _e2232.x;
                                                                                    } else {
                                                                                        phi_2816_ = _e2234.x;
                                                                                    }
                                                                                    let _e2241 = phi_2816_;
                                                                                    if (_e2232.y > _e2234.y) {
                                                                                        phi_2825_ = _e2232.y;
                                                                                    } else {
                                                                                        phi_2825_ = _e2234.y;
                                                                                    }
                                                                                    let _e2248 = phi_2825_;
                                                                                    if (_e2232.z > _e2234.z) {
                                                                                        phi_2834_ = _e2232.z;
                                                                                    } else {
                                                                                        phi_2834_ = _e2234.z;
                                                                                    }
                                                                                    let _e2255 = phi_2834_;
                                                                                    let _e2257 = triangles.member[(0u + _e1902)].v2_;
                                                                                    if (_e2241 > _e2257.x) {
                                                                                        phi_2843_ = _e2241;
                                                                                    } else {
                                                                                        phi_2843_ = _e2257.x;
                                                                                    }
                                                                                    let _e2262 = phi_2843_;
                                                                                    if (_e2248 > _e2257.y) {
                                                                                        phi_2850_ = _e2248;
                                                                                    } else {
                                                                                        phi_2850_ = _e2257.y;
                                                                                    }
                                                                                    let _e2267 = phi_2850_;
                                                                                    if (_e2255 > _e2257.z) {
                                                                                        phi_2857_ = _e2255;
                                                                                    } else {
                                                                                        phi_2857_ = _e2257.z;
                                                                                    }
                                                                                    let _e2272 = phi_2857_;
                                                                                    let _e2276 = ((_e2220 - _e1012) * _e1213);
                                                                                    let _e2277 = ((_e2225 - _e1025) * _e1223);
                                                                                    let _e2278 = ((_e2230 - _e1038) * _e1233);
                                                                                    let _e2282 = ((_e2262 - _e1012) * _e1213);
                                                                                    let _e2283 = ((_e2267 - _e1025) * _e1223);
                                                                                    let _e2284 = ((_e2272 - _e1038) * _e1233);
                                                                                    if (_e2276 < _e2282) {
                                                                                        phi_2874_ = _e2276;
                                                                                    } else {
                                                                                        phi_2874_ = _e2282;
                                                                                    }
                                                                                    let _e2287 = phi_2874_;
                                                                                    if (_e2277 < _e2283) {
                                                                                        phi_2879_ = _e2277;
                                                                                    } else {
                                                                                        phi_2879_ = _e2283;
                                                                                    }
                                                                                    let _e2290 = phi_2879_;
                                                                                    if (_e2278 < _e2284) {
                                                                                        phi_2884_ = _e2278;
                                                                                    } else {
                                                                                        phi_2884_ = _e2284;
                                                                                    }
                                                                                    let _e2293 = phi_2884_;
                                                                                    if (_e2276 > _e2282) {
                                                                                        phi_2892_ = _e2276;
                                                                                    } else {
                                                                                        phi_2892_ = _e2282;
                                                                                    }
                                                                                    let _e2299 = phi_2892_;
                                                                                    if (_e2277 > _e2283) {
                                                                                        phi_2897_ = _e2277;
                                                                                    } else {
                                                                                        phi_2897_ = _e2283;
                                                                                    }
                                                                                    let _e2302 = phi_2897_;
                                                                                    if (_e2278 > _e2284) {
                                                                                        phi_2902_ = _e2278;
                                                                                    } else {
                                                                                        phi_2902_ = _e2284;
                                                                                    }
                                                                                    let _e2305 = phi_2902_;
                                                                                    let _e2309 = core_intrinsics_maximum_number_nsz_f32_((_e2287 - _e1272), (_e2290 - _e1273));
                                                                                    let _e2310 = core_intrinsics_maximum_number_nsz_f32_(_e2309, (_e2293 - _e1274));
                                                                                    let _e2311 = core_intrinsics_minimum_number_nsz_f32_((_e2299 + _e1272), (_e2302 + _e1273));
                                                                                    let _e2312 = core_intrinsics_minimum_number_nsz_f32_(_e2311, (_e2305 + _e1274));
                                                                                    if (_e2310 > _e993) {
                                                                                        phi_2914_ = _e2310;
                                                                                    } else {
                                                                                        phi_2914_ = _e993;
                                                                                    }
                                                                                    let _e2315 = phi_2914_;
                                                                                    if (_e2312 < _e995) {
                                                                                        phi_2919_ = _e2312;
                                                                                    } else {
                                                                                        phi_2919_ = _e995;
                                                                                    }
                                                                                    let _e2318 = phi_2919_;
                                                                                    if (_e2186 < _e2315) {
                                                                                        phi_2924_ = _e2315;
                                                                                    } else {
                                                                                        phi_2924_ = _e2186;
                                                                                    }
                                                                                    let _e2321 = phi_2924_;
                                                                                    if (_e2321 > _e2318) {
                                                                                        phi_2929_ = _e2318;
                                                                                    } else {
                                                                                        phi_2929_ = _e2321;
                                                                                    }
                                                                                    let _e2324 = phi_2929_;
                                                                                    phi_2934_ = lt_bvh_triangle_Intersection(_e2324, (_e2027 / _e2086), (_e2048 / _e2086), (_e2315 <= _e2318));
                                                                                    phi_2935_ = false;
                                                                                } else {
                                                                                    phi_2934_ = lt_bvh_triangle_Intersection();
                                                                                    phi_2935_ = true;
                                                                                }
                                                                                let _e2330 = phi_2934_;
                                                                                let _e2332 = phi_2935_;
                                                                                phi_2936_ = _e2330;
                                                                                phi_2937_ = _e2332;
                                                                            } else {
                                                                                phi_2936_ = lt_bvh_triangle_Intersection();
                                                                                phi_2937_ = true;
                                                                            }
                                                                            let _e2334 = phi_2936_;
                                                                            let _e2336 = phi_2937_;
                                                                            if _e2336 {
                                                                            }
                                                                            phi_2941_ = _e2334;
                                                                            phi_2942_ = _e2336;
                                                                        }
                                                                        let _e2338 = phi_2941_;
                                                                        let _e2340 = phi_2942_;
                                                                        phi_2943_ = _e2338;
                                                                        phi_2944_ = _e2089;
                                                                        phi_2945_ = _e2340;
                                                                    } else {
                                                                        phi_2943_ = lt_bvh_triangle_Intersection();
                                                                        phi_2944_ = true;
                                                                        phi_2945_ = false;
                                                                    }
                                                                    let _e2342 = phi_2943_;
                                                                    let _e2344 = phi_2944_;
                                                                    let _e2346 = phi_2945_;
                                                                    if _e2344 {
                                                                        phi_2949_ = true;
                                                                    } else {
                                                                        phi_2949_ = _e2346;
                                                                    }
                                                                    let _e2348 = phi_2949_;
                                                                    if _e2348 {
                                                                        phi_2953_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_2953_ = _e2342;
                                                                    }
                                                                    let _e2350 = phi_2953_;
                                                                    if _e2350.is_hit {
                                                                        if (_e2350.t > 0f) {
                                                                            if (_e2350.t < _e142) {
                                                                                let _e2357 = triangles.member[(0u + _e1902)].i0_;
                                                                                if ((_e2357 & 2147483648u) == 0u) {
                                                                                    phi_3172_ = true;
                                                                                } else {
                                                                                    if (_e1902 < _e79) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2366 = triangles.member[(0u + _e1902)].i0_;
                                                                                    let _e2367 = (_e2366 & 2147483647u);
                                                                                    let _e2369 = triangles.member[(0u + _e1902)].i1_;
                                                                                    let _e2371 = triangles.member[(0u + _e1902)].i2_;
                                                                                    if (_e2367 < _e91) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2375 = vertices.member[(0u + _e2367)];
                                                                                    if (_e2369 < _e91) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2379 = vertices.member[(0u + _e2369)];
                                                                                    if (_e2371 < _e91) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2383 = vertices.member[(0u + _e2371)];
                                                                                    let _e2384 = array<abi_Vertex, 3>(_e2375, _e2379, _e2383);
                                                                                    if (_e2384[0].material < arrayLength((&materials.member))) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2390 = materials.member[(0u + _e2384[0].material)];
                                                                                    if ((_e2390.flags & 1u) == 1u) {
                                                                                        let _e2395 = ((1f - _e2350.u) - _e2350.v);
                                                                                        if (_e2390.cutoff <= 0f) {
                                                                                            phi_3170_ = true;
                                                                                        } else {
                                                                                            let _e2422 = (_e2390.base_color.w * ((((f32((_e2384[0].color >> bitcast<u32>(24i))) * _e2395) + (f32((_e2384[1].color >> bitcast<u32>(24i))) * _e2350.u)) + (f32((_e2384[2].color >> bitcast<u32>(24i))) * _e2350.v)) * (1f / 255f)));
                                                                                            if (_e2390.alpha_size == 0u) {
                                                                                                phi_3167_ = _e2422;
                                                                                            } else {
                                                                                                local.offset = _e2390.alpha_offset;
                                                                                                local.size = _e2390.alpha_size;
                                                                                                local.flags = _e2390.flags;
                                                                                                let _e2453 = _lt_shaders_texture_TextureView_quad((&local), (((_e2384[0].u * _e2395) + (_e2384[1].u * _e2350.u)) + (_e2384[2].u * _e2350.v)), (((_e2384[0].v * _e2395) + (_e2384[1].v * _e2350.u)) + (_e2384[2].v * _e2350.v)));
                                                                                                let _e2457 = (_e2453.indices[0] >> bitcast<u32>(2i));
                                                                                                if (_e2457 < _e97) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2461 = alpha_texels.member[(0u + _e2457)];
                                                                                                let _e2477 = (_e2453.indices[1] >> bitcast<u32>(2i));
                                                                                                if (_e2477 < _e97) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2481 = alpha_texels.member[(0u + _e2477)];
                                                                                                let _e2498 = (_e2453.indices[2] >> bitcast<u32>(2i));
                                                                                                if (_e2498 < _e97) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2502 = alpha_texels.member[(0u + _e2498)];
                                                                                                let _e2519 = (_e2453.indices[3] >> bitcast<u32>(2i));
                                                                                                if (_e2519 < _e97) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2523 = alpha_texels.member[(0u + _e2519)];
                                                                                                phi_3167_ = (_e2422 * (((((f32(((_e2461 >> bitcast<u32>((((_e2453.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2453.weights.x) + ((f32(((_e2481 >> bitcast<u32>((((_e2453.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2453.weights.y)) + ((f32(((_e2502 >> bitcast<u32>((((_e2453.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2453.weights.z)) + ((f32(((_e2523 >> bitcast<u32>((((_e2453.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2453.weights.w)));
                                                                                            }
                                                                                            let _e2539 = phi_3167_;
                                                                                            phi_3170_ = (_e2539 >= _e2390.cutoff);
                                                                                        }
                                                                                        let _e2543 = phi_3170_;
                                                                                        phi_3171_ = _e2543;
                                                                                    } else {
                                                                                        phi_3171_ = false;
                                                                                    }
                                                                                    let _e2545 = phi_3171_;
                                                                                    phi_3172_ = _e2545;
                                                                                }
                                                                                let _e2547 = phi_3172_;
                                                                                if _e2547 {
                                                                                    phi_3176_ = false;
                                                                                } else {
                                                                                    phi_3176_ = true;
                                                                                }
                                                                                let _e2549 = phi_3176_;
                                                                                phi_3177_ = _e2547;
                                                                                phi_3178_ = _e2547;
                                                                                phi_3179_ = _e2549;
                                                                            } else {
                                                                                phi_3177_ = bool();
                                                                                phi_3178_ = _e1893;
                                                                                phi_3179_ = true;
                                                                            }
                                                                            let _e2551 = phi_3177_;
                                                                            let _e2553 = phi_3178_;
                                                                            let _e2555 = phi_3179_;
                                                                            phi_3180_ = _e2551;
                                                                            phi_3181_ = _e2553;
                                                                            phi_3182_ = _e2555;
                                                                        } else {
                                                                            phi_3180_ = bool();
                                                                            phi_3181_ = _e1893;
                                                                            phi_3182_ = true;
                                                                        }
                                                                        let _e2557 = phi_3180_;
                                                                        let _e2559 = phi_3181_;
                                                                        let _e2561 = phi_3182_;
                                                                        phi_3183_ = _e2557;
                                                                        phi_3184_ = _e2559;
                                                                        phi_3185_ = _e2561;
                                                                    } else {
                                                                        phi_3183_ = bool();
                                                                        phi_3184_ = _e1893;
                                                                        phi_3185_ = true;
                                                                    }
                                                                    let _e2563 = phi_3183_;
                                                                    let _e2565 = phi_3184_;
                                                                    let _e2567 = phi_3185_;
                                                                    if _e2567 {
                                                                    }
                                                                    phi_2383_ = (_e1891 & (_e1891 - 1u));
                                                                    phi_2386_ = _e2565;
                                                                    phi_3189_ = _e2563;
                                                                    phi_3190_ = _e2567;
                                                                }
                                                                let _e2569 = phi_2383_;
                                                                let _e2571 = phi_2386_;
                                                                let _e2573 = phi_3189_;
                                                                let _e2575 = phi_3190_;
                                                                local_14 = _e2573;
                                                                continue;
                                                                continuing {
                                                                    phi_2382_ = _e2569;
                                                                    phi_2385_ = _e2571;
                                                                    break if !(_e2575);
                                                                }
                                                            }
                                                            let _e2578 = local_9;
                                                            if _e2578 {
                                                                let _e2580 = local_1.group_mask;
                                                                if ((_e2580 & 4278190080u) == 0u) {
                                                                    let _e2584 = local_1.len;
                                                                    if (_e2584 == 0u) {
                                                                        phi_3232_ = false;
                                                                    } else {
                                                                        let _e2588 = local_1.len;
                                                                        local_1.len = (_e2588 - 1u);
                                                                        let _e2591 = local_1.len;
                                                                        if (_e2591 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2596 = local_1.first[(0u + _e2591)];
                                                                        local_1.group = _e2596;
                                                                        let _e2599 = local_1.len;
                                                                        if (_e2599 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2604 = local_1.mask[(0u + _e2599)];
                                                                        local_1.group_mask = _e2604;
                                                                        phi_3232_ = true;
                                                                    }
                                                                    let _e2607 = phi_3232_;
                                                                    phi_3233_ = _e2607;
                                                                } else {
                                                                    phi_3233_ = true;
                                                                }
                                                                let _e2609 = phi_3233_;
                                                                if _e2609 {
                                                                    let _e2611 = local_1.group_mask;
                                                                    let _e2617 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2611)), 32u, (_e2611 == 0u)));
                                                                    let _e2621 = local_1.group_mask;
                                                                    let _e2635 = local_1.group_mask;
                                                                    local_1.group_mask = (_e2635 & ~((1u << bitcast<u32>((_e2617 & 31u)))));
                                                                    let _e2638 = local_1.group;
                                                                    phi_3264_ = (_e2638 + countOneBits(((_e2621 & ~((4294967295u << bitcast<u32>((((_e2617 - 24u) ^ _e1315) & 31u))))) & 255u)));
                                                                } else {
                                                                    phi_3264_ = 4294967295u;
                                                                }
                                                                let _e2641 = phi_3264_;
                                                                phi_3265_ = _e2641;
                                                            } else {
                                                                phi_3265_ = u32();
                                                            }
                                                            let _e2643 = phi_3265_;
                                                            phi_2051_ = _e2643;
                                                            let _e3029 = local_13;
                                                            phi_2054_ = _e3029;
                                                            let _e3032 = local_14;
                                                            phi_3266_ = _e3032;
                                                            let _e3035 = local_15;
                                                            phi_3267_ = _e3035;
                                                            phi_3268_ = false;
                                                        } else {
                                                            phi_2051_ = u32();
                                                            phi_2054_ = bool();
                                                            phi_3266_ = bool();
                                                            phi_3267_ = false;
                                                            phi_3268_ = true;
                                                        }
                                                        let _e2645 = phi_2051_;
                                                        let _e2647 = phi_2054_;
                                                        let _e2649 = phi_3266_;
                                                        let _e2651 = phi_3267_;
                                                        let _e2653 = phi_3268_;
                                                        local_10 = _e2653;
                                                        local_16 = _e2649;
                                                        continue;
                                                        continuing {
                                                            phi_2050_ = _e2645;
                                                            phi_2053_ = _e2647;
                                                            break if !(_e2651);
                                                        }
                                                    }
                                                    let _e2656 = local_10;
                                                    if _e2656 {
                                                        phi_3272_ = false;
                                                    } else {
                                                        phi_3272_ = true;
                                                    }
                                                    let _e2658 = phi_3272_;
                                                    if _e2658 {
                                                        let _e3041 = local_16;
                                                        phi_3276_ = _e3041;
                                                    } else {
                                                        let _e3043 = local_17;
                                                        phi_3276_ = _e3043;
                                                    }
                                                    let _e2660 = phi_3276_;
                                                    phi_3277_ = _e2660;
                                                }
                                                let _e2662 = phi_3277_;
                                                phi_3278_ = _e2662;
                                                phi_3279_ = _e1137;
                                            } else {
                                                phi_3278_ = bool();
                                                phi_3279_ = true;
                                            }
                                            let _e2664 = phi_3278_;
                                            let _e2666 = phi_3279_;
                                            if _e2666 {
                                                phi_3283_ = _e932;
                                            } else {
                                                phi_3283_ = _e2664;
                                            }
                                            let _e2668 = phi_3283_;
                                            if _e2668 {
                                                phi_3287_ = false;
                                            } else {
                                                phi_3287_ = true;
                                            }
                                            let _e2670 = phi_3287_;
                                            phi_3288_ = _e2668;
                                            phi_3289_ = _e2670;
                                        } else {
                                            phi_3288_ = _e932;
                                            phi_3289_ = true;
                                        }
                                        let _e2672 = phi_3288_;
                                        let _e2674 = phi_3289_;
                                        phi_3290_ = _e2672;
                                        phi_3291_ = _e2674;
                                    } else {
                                        phi_3290_ = _e932;
                                        phi_3291_ = true;
                                    }
                                    let _e2676 = phi_3290_;
                                    let _e2678 = phi_3291_;
                                    phi_3292_ = _e2676;
                                    phi_3293_ = _e2678;
                                } else {
                                    phi_3292_ = _e932;
                                    phi_3293_ = true;
                                }
                                let _e2680 = phi_3292_;
                                let _e2682 = phi_3293_;
                                if _e2682 {
                                }
                                phi_1436_ = (_e930 & (_e930 - 1u));
                                phi_1439_ = _e2680;
                                phi_3297_ = _e2682;
                            }
                            let _e2684 = phi_1436_;
                            let _e2686 = phi_1439_;
                            let _e2688 = phi_3297_;
                            continue;
                            continuing {
                                phi_1435_ = _e2684;
                                phi_1438_ = _e2686;
                                break if !(_e2688);
                            }
                        }
                        let _e2691 = local_11;
                        if _e2691 {
                            let _e2693 = local_2.group_mask;
                            if ((_e2693 & 4278190080u) == 0u) {
                                let _e2697 = local_2.len;
                                if (_e2697 == 0u) {
                                    phi_3339_ = false;
                                } else {
                                    let _e2701 = local_2.len;
                                    local_2.len = (_e2701 - 1u);
                                    let _e2704 = local_2.len;
                                    if (_e2704 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2709 = local_2.first[(0u + _e2704)];
                                    local_2.group = _e2709;
                                    let _e2712 = local_2.len;
                                    if (_e2712 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2717 = local_2.mask[(0u + _e2712)];
                                    local_2.group_mask = _e2717;
                                    phi_3339_ = true;
                                }
                                let _e2720 = phi_3339_;
                                phi_3340_ = _e2720;
                            } else {
                                phi_3340_ = true;
                            }
                            let _e2722 = phi_3340_;
                            if _e2722 {
                                let _e2724 = local_2.group_mask;
                                let _e2730 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2724)), 32u, (_e2724 == 0u)));
                                let _e2734 = local_2.group_mask;
                                let _e2748 = local_2.group_mask;
                                local_2.group_mask = (_e2748 & ~((1u << bitcast<u32>((_e2730 & 31u)))));
                                let _e2751 = local_2.group;
                                phi_3371_ = (_e2751 + countOneBits(((_e2734 & ~((4294967295u << bitcast<u32>((((_e2730 - 24u) ^ _e354) & 31u))))) & 255u)));
                            } else {
                                phi_3371_ = 4294967295u;
                            }
                            let _e2754 = phi_3371_;
                            phi_3372_ = _e2754;
                        } else {
                            phi_3372_ = u32();
                        }
                        let _e2756 = phi_3372_;
                        phi_1104_ = _e2756;
                        let _e3066 = local_18;
                        phi_1107_ = _e3066;
                        let _e3069 = local_19;
                        phi_3373_ = _e3069;
                        phi_3374_ = false;
                    } else {
                        phi_1104_ = u32();
                        phi_1107_ = bool();
                        phi_3373_ = false;
                        phi_3374_ = true;
                    }
                    let _e2758 = phi_1104_;
                    let _e2760 = phi_1107_;
                    let _e2762 = phi_3373_;
                    let _e2764 = phi_3374_;
                    local_12 = _e2764;
                    continue;
                    continuing {
                        phi_1103_ = _e2758;
                        phi_1106_ = _e2760;
                        break if !(_e2762);
                    }
                }
                let _e2767 = local_12;
                if _e2767 {
                    phi_3378_ = false;
                } else {
                    phi_3378_ = true;
                }
                let _e2769 = phi_3378_;
                if _e2769 {
                }
                phi_3382_ = _e2769;
            }
            let _e2771 = phi_3382_;
            phi_3383_ = _e206;
            phi_3384_ = _e2771;
        } else {
            phi_3383_ = true;
            phi_3384_ = false;
        }
        let _e2773 = phi_3383_;
        let _e2775 = phi_3384_;
        if _e2773 {
            phi_3388_ = false;
            phi_3389_ = true;
        } else {
            phi_3388_ = true;
            phi_3389_ = _e2775;
        }
        let _e2777 = phi_3388_;
        let _e2779 = phi_3389_;
        if _e2779 {
            phi_3393_ = _e2777;
        } else {
            phi_3393_ = false;
        }
        let _e2781 = phi_3393_;
        if _e2781 {
            phi_3397_ = 0f;
        } else {
            phi_3397_ = 1f;
        }
        let _e2783 = phi_3397_;
        if (_e110 < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e110)] = _e2783;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_list_instanced_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
