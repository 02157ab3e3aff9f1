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

struct type_32 {
    member: abi_ShadowParams,
}

struct lt_bvh_Node {
    frame: vec4<u32>,
    links: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    z: vec4<u32>,
}

struct type_37 {
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

struct type_41 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_45 {
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

struct type_49 {
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

struct type_63 {
    member: array<lt_bvh_Instance>,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_17;
@group(0) @binding(0) 
var<uniform> p: type_32;
@group(0) @binding(2) 
var<storage> nodes: type_37;
@group(0) @binding(3) 
var<storage> triangles: type_41;
@group(0) @binding(6) 
var<storage> instances: type_63;
@group(0) @binding(5) 
var<storage> list: type_13;
@group(0) @binding(7) 
var<storage> vertices: type_45;
@group(0) @binding(8) 
var<storage> materials: type_49;
@group(0) @binding(9) 
var<storage> alpha_texels: type_13;

fn core_intrinsics_maximum_number_nsz_f32_(param: f32, param_1: f32) -> f32 {
    var phi_204_: bool;
    var phi_208_: f32;

    if (param != param) {
        phi_204_ = true;
    } else {
        let _e69 = (param_1 >= param);
        if _e69 {
        }
        phi_204_ = _e69;
    }
    let _e71 = phi_204_;
    if _e71 {
        phi_208_ = param_1;
    } else {
        phi_208_ = param;
    }
    let _e73 = phi_208_;
    return _e73;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_2: f32, param_3: f32) -> f32 {
    var phi_220_: bool;
    var phi_224_: f32;

    if (param_2 != param_2) {
        phi_220_ = true;
    } else {
        let _e69 = (param_3 <= param_2);
        if _e69 {
        }
        phi_220_ = _e69;
    }
    let _e71 = phi_220_;
    if _e71 {
        phi_224_ = param_3;
    } else {
        phi_224_ = param_2;
    }
    let _e73 = phi_224_;
    return _e73;
}

fn _lt_shaders_texture_TextureView_quad(param_4: ptr<function, texture_TextureView>, param_5: f32, param_6: f32) -> texture_TexelQuad {
    var phi_266_: f32;
    var phi_271_: f32;
    var phi_272_: bool;
    var phi_273_: f32;
    var phi_274_: bool;
    var phi_278_: f32;
    var phi_304_: f32;
    var phi_309_: f32;
    var phi_310_: bool;
    var phi_311_: f32;
    var phi_312_: bool;
    var phi_316_: f32;
    var phi_324_: f32;
    var phi_325_: f32;
    var phi_326_: f32;
    var phi_335_: f32;
    var phi_336_: f32;
    var phi_354_: u32;
    var phi_368_: u32;
    var phi_375_: u32;
    var phi_380_: u32;
    var phi_386_: u32;
    var phi_391_: u32;
    var phi_393_: texture_Axis;
    var phi_421_: f32;
    var phi_426_: f32;
    var phi_427_: bool;
    var phi_428_: f32;
    var phi_429_: bool;
    var phi_433_: f32;
    var phi_459_: f32;
    var phi_464_: f32;
    var phi_465_: bool;
    var phi_466_: f32;
    var phi_467_: bool;
    var phi_471_: f32;
    var phi_479_: f32;
    var phi_480_: f32;
    var phi_481_: f32;
    var phi_490_: f32;
    var phi_491_: f32;
    var phi_509_: u32;
    var phi_523_: u32;
    var phi_530_: u32;
    var phi_535_: u32;
    var phi_541_: u32;
    var phi_546_: u32;
    var phi_548_: texture_Axis;

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
                phi_266_ = 1f;
            } else {
                phi_266_ = 0f;
            }
            let _e100 = phi_266_;
            if (param_5 < 8388608f) {
                phi_271_ = (_e97 - _e100);
                phi_272_ = false;
            } else {
                phi_271_ = f32();
                phi_272_ = true;
            }
            let _e103 = phi_271_;
            let _e105 = phi_272_;
            phi_273_ = _e103;
            phi_274_ = _e105;
        } else {
            phi_273_ = f32();
            phi_274_ = true;
        }
        let _e107 = phi_273_;
        let _e109 = phi_274_;
        if _e109 {
            phi_278_ = param_5;
        } else {
            phi_278_ = _e107;
        }
        let _e111 = phi_278_;
        phi_326_ = (param_5 - _e111);
    } else {
        if (_e84 == 1u) {
            let _e114 = (param_5 * 0.5f);
            if (_e114 > -8388608f) {
                let _e126 = f32(select(0i, select(select(i32(_e114), i32(-2147483648), (_e114 < bitcast<f32>(3472883712u))), 2147483647i, (_e114 > bitcast<f32>(1325400063u))), (_e114 == _e114)));
                if (_e126 > _e114) {
                    phi_304_ = 1f;
                } else {
                    phi_304_ = 0f;
                }
                let _e129 = phi_304_;
                if (_e114 < 8388608f) {
                    phi_309_ = (_e126 - _e129);
                    phi_310_ = false;
                } else {
                    phi_309_ = f32();
                    phi_310_ = true;
                }
                let _e132 = phi_309_;
                let _e134 = phi_310_;
                phi_311_ = _e132;
                phi_312_ = _e134;
            } else {
                phi_311_ = f32();
                phi_312_ = true;
            }
            let _e136 = phi_311_;
            let _e138 = phi_312_;
            if _e138 {
                phi_316_ = _e114;
            } else {
                phi_316_ = _e136;
            }
            let _e140 = phi_316_;
            let _e142 = (param_5 - (2f * _e140));
            if (_e142 > 1f) {
                phi_324_ = (2f - _e142);
            } else {
                phi_324_ = _e142;
            }
            let _e146 = phi_324_;
            phi_325_ = _e146;
        } else {
            phi_325_ = param_5;
        }
        let _e148 = phi_325_;
        phi_326_ = _e148;
    }
    let _e150 = phi_326_;
    if (_e150 > 0f) {
        if (_e150 < 1f) {
            phi_335_ = _e150;
        } else {
            phi_335_ = 1f;
        }
        let _e154 = phi_335_;
        phi_336_ = _e154;
    } else {
        phi_336_ = 0f;
    }
    let _e156 = phi_336_;
    let _e157 = (_e71 - 1u);
    let _e159 = (_e156 * f32(_e71));
    if _e79 {
        let _e166 = select(select(u32(_e159), 0u, (_e159 < bitcast<f32>(0u))), 4294967295u, (_e159 > bitcast<f32>(1333788671u)));
        if (_e157 < _e166) {
            phi_354_ = _e157;
        } else {
            phi_354_ = _e166;
        }
        let _e169 = phi_354_;
        phi_393_ = texture_Axis(_e169, _e169, 0f);
    } else {
        let _e171 = (_e159 + 0.5f);
        let _e178 = select(select(u32(_e171), 0u, (_e171 < bitcast<f32>(0u))), 4294967295u, (_e171 > bitcast<f32>(1333788671u)));
        if (_e71 < _e178) {
            phi_368_ = _e71;
        } else {
            phi_368_ = _e178;
        }
        let _e181 = phi_368_;
        if (_e84 == 0u) {
            phi_375_ = _e157;
        } else {
            phi_375_ = 0u;
        }
        let _e186 = phi_375_;
        if (_e84 == 0u) {
            phi_380_ = 0u;
        } else {
            phi_380_ = _e157;
        }
        let _e189 = phi_380_;
        if (_e181 == 0u) {
            phi_386_ = _e186;
        } else {
            phi_386_ = (_e181 - 1u);
        }
        let _e193 = phi_386_;
        if (_e181 > _e157) {
            phi_391_ = _e189;
        } else {
            phi_391_ = _e181;
        }
        let _e196 = phi_391_;
        phi_393_ = texture_Axis(_e193, _e196, (_e171 - f32(_e181)));
    }
    let _e199 = phi_393_;
    let _e201 = (*param_4).flags;
    let _e204 = ((_e201 >> bitcast<u32>(6u)) & 3u);
    if (_e204 == 0u) {
        if (param_6 > -8388608f) {
            let _e217 = f32(select(0i, select(select(i32(param_6), i32(-2147483648), (param_6 < bitcast<f32>(3472883712u))), 2147483647i, (param_6 > bitcast<f32>(1325400063u))), (param_6 == param_6)));
            if (_e217 > param_6) {
                phi_421_ = 1f;
            } else {
                phi_421_ = 0f;
            }
            let _e220 = phi_421_;
            if (param_6 < 8388608f) {
                phi_426_ = (_e217 - _e220);
                phi_427_ = false;
            } else {
                phi_426_ = f32();
                phi_427_ = true;
            }
            let _e223 = phi_426_;
            let _e225 = phi_427_;
            phi_428_ = _e223;
            phi_429_ = _e225;
        } else {
            phi_428_ = f32();
            phi_429_ = true;
        }
        let _e227 = phi_428_;
        let _e229 = phi_429_;
        if _e229 {
            phi_433_ = param_6;
        } else {
            phi_433_ = _e227;
        }
        let _e231 = phi_433_;
        phi_481_ = (param_6 - _e231);
    } else {
        if (_e204 == 1u) {
            let _e234 = (param_6 * 0.5f);
            if (_e234 > -8388608f) {
                let _e246 = f32(select(0i, select(select(i32(_e234), i32(-2147483648), (_e234 < bitcast<f32>(3472883712u))), 2147483647i, (_e234 > bitcast<f32>(1325400063u))), (_e234 == _e234)));
                if (_e246 > _e234) {
                    phi_459_ = 1f;
                } else {
                    phi_459_ = 0f;
                }
                let _e249 = phi_459_;
                if (_e234 < 8388608f) {
                    phi_464_ = (_e246 - _e249);
                    phi_465_ = false;
                } else {
                    phi_464_ = f32();
                    phi_465_ = true;
                }
                let _e252 = phi_464_;
                let _e254 = phi_465_;
                phi_466_ = _e252;
                phi_467_ = _e254;
            } else {
                phi_466_ = f32();
                phi_467_ = true;
            }
            let _e256 = phi_466_;
            let _e258 = phi_467_;
            if _e258 {
                phi_471_ = _e234;
            } else {
                phi_471_ = _e256;
            }
            let _e260 = phi_471_;
            let _e262 = (param_6 - (2f * _e260));
            if (_e262 > 1f) {
                phi_479_ = (2f - _e262);
            } else {
                phi_479_ = _e262;
            }
            let _e266 = phi_479_;
            phi_480_ = _e266;
        } else {
            phi_480_ = param_6;
        }
        let _e268 = phi_480_;
        phi_481_ = _e268;
    }
    let _e270 = phi_481_;
    if (_e270 > 0f) {
        if (_e270 < 1f) {
            phi_490_ = _e270;
        } else {
            phi_490_ = 1f;
        }
        let _e274 = phi_490_;
        phi_491_ = _e274;
    } else {
        phi_491_ = 0f;
    }
    let _e276 = phi_491_;
    let _e277 = (_e75 - 1u);
    let _e279 = (_e276 * f32(_e75));
    if _e79 {
        let _e286 = select(select(u32(_e279), 0u, (_e279 < bitcast<f32>(0u))), 4294967295u, (_e279 > bitcast<f32>(1333788671u)));
        if (_e277 < _e286) {
            phi_509_ = _e277;
        } else {
            phi_509_ = _e286;
        }
        let _e289 = phi_509_;
        phi_548_ = texture_Axis(_e289, _e289, 0f);
    } else {
        let _e291 = (_e279 + 0.5f);
        let _e298 = select(select(u32(_e291), 0u, (_e291 < bitcast<f32>(0u))), 4294967295u, (_e291 > bitcast<f32>(1333788671u)));
        if (_e75 < _e298) {
            phi_523_ = _e75;
        } else {
            phi_523_ = _e298;
        }
        let _e301 = phi_523_;
        if (_e204 == 0u) {
            phi_530_ = _e277;
        } else {
            phi_530_ = 0u;
        }
        let _e306 = phi_530_;
        if (_e204 == 0u) {
            phi_535_ = 0u;
        } else {
            phi_535_ = _e277;
        }
        let _e309 = phi_535_;
        if (_e301 == 0u) {
            phi_541_ = _e306;
        } else {
            phi_541_ = (_e301 - 1u);
        }
        let _e313 = phi_541_;
        if (_e301 > _e277) {
            phi_546_ = _e309;
        } else {
            phi_546_ = _e301;
        }
        let _e316 = phi_546_;
        phi_548_ = texture_Axis(_e313, _e316, (_e291 - f32(_e301)));
    }
    let _e319 = phi_548_;
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
    var phi_693_: f32;
    var phi_749_: bool;
    var phi_750_: bool;
    var phi_751_: bool;
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
    var phi_766_: bool;
    var phi_767_: bool;
    var phi_768_: bool;
    var phi_769_: bool;
    var phi_770_: bool;
    var phi_771_: bool;
    var phi_772_: bool;
    var phi_776_: bool;
    var phi_780_: bool;
    var phi_850_: f32;
    var phi_857_: f32;
    var phi_864_: f32;
    var phi_871_: f32;
    var phi_878_: f32;
    var phi_885_: f32;
    var phi_902_: f32;
    var phi_907_: f32;
    var phi_912_: f32;
    var phi_933_: u32;
    var phi_938_: u32;
    var phi_943_: u32;
    var phi_1057_: bool;
    var phi_1058_: bool;
    var phi_1089_: u32;
    var phi_1091_: u32;
    var phi_1094_: bool;
    var phi_1174_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1201_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1228_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1234_: u32;
    var phi_1237_: u32;
    var phi_1251_: u32;
    var phi_1261_: u32;
    var phi_1271_: u32;
    var phi_1289_: u32;
    var phi_1299_: u32;
    var phi_1309_: u32;
    var phi_1345_: u32;
    var phi_1358_: u32;
    var phi_1363_: u32;
    var phi_1364_: u32;
    var phi_1365_: u32;
    var phi_1235_: u32;
    var phi_1238_: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_1423_: u32;
    var phi_1426_: bool;
    var phi_1475_: f32;
    var phi_1480_: f32;
    var phi_1485_: f32;
    var phi_1493_: f32;
    var phi_1498_: f32;
    var phi_1503_: f32;
    var phi_1647_: bool;
    var phi_1648_: bool;
    var phi_1649_: bool;
    var phi_1653_: bool;
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
    var phi_1674_: bool;
    var phi_1678_: bool;
    var phi_1748_: f32;
    var phi_1755_: f32;
    var phi_1762_: f32;
    var phi_1769_: f32;
    var phi_1776_: f32;
    var phi_1783_: f32;
    var phi_1800_: f32;
    var phi_1805_: f32;
    var phi_1810_: f32;
    var phi_1838_: bool;
    var phi_1839_: bool;
    var phi_1847_: u32;
    var phi_1848_: u32;
    var phi_1859_: vec3<f32>;
    var phi_1860_: vec3<f32>;
    var phi_1873_: u32;
    var phi_1878_: u32;
    var phi_1883_: u32;
    var phi_1997_: bool;
    var phi_1998_: bool;
    var phi_2029_: u32;
    var phi_2031_: u32;
    var phi_2034_: bool;
    var phi_2114_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2141_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2168_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2174_: u32;
    var phi_2177_: u32;
    var phi_2191_: u32;
    var phi_2201_: u32;
    var phi_2211_: u32;
    var phi_2229_: u32;
    var phi_2239_: u32;
    var phi_2249_: u32;
    var phi_2285_: u32;
    var phi_2298_: u32;
    var phi_2303_: u32;
    var phi_2304_: u32;
    var phi_2305_: u32;
    var phi_2175_: u32;
    var phi_2178_: u32;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_2363_: u32;
    var phi_2366_: bool;
    var phi_2410_: vec3<f32>;
    var phi_2411_: vec3<f32>;
    var phi_2440_: vec3<f32>;
    var phi_2441_: vec3<f32>;
    var phi_2470_: vec3<f32>;
    var phi_2471_: vec3<f32>;
    var phi_2489_: bool;
    var phi_2490_: bool;
    var phi_2494_: f32;
    var phi_2495_: f32;
    var phi_2496_: f32;
    var phi_2497_: f32;
    var phi_2505_: f32;
    var phi_2515_: bool;
    var phi_2516_: bool;
    var phi_2520_: f32;
    var phi_2521_: f32;
    var phi_2522_: f32;
    var phi_2523_: f32;
    var phi_2531_: f32;
    var phi_2541_: bool;
    var phi_2542_: bool;
    var phi_2546_: f32;
    var phi_2547_: f32;
    var phi_2548_: f32;
    var phi_2549_: f32;
    var phi_2557_: f32;
    var phi_2572_: f32;
    var phi_2573_: bool;
    var phi_2574_: f32;
    var phi_2575_: bool;
    var phi_2576_: f32;
    var phi_2577_: bool;
    var phi_2595_: f32;
    var phi_2596_: bool;
    var phi_2597_: bool;
    var phi_2598_: f32;
    var phi_2599_: bool;
    var phi_2600_: bool;
    var phi_2604_: bool;
    var phi_2605_: f32;
    var phi_2606_: bool;
    var phi_2634_: vec3<f32>;
    var phi_2635_: vec3<f32>;
    var phi_2660_: vec3<f32>;
    var phi_2661_: vec3<f32>;
    var phi_2686_: vec3<f32>;
    var phi_2687_: vec3<f32>;
    var phi_2743_: f32;
    var phi_2752_: f32;
    var phi_2761_: f32;
    var phi_2770_: f32;
    var phi_2777_: f32;
    var phi_2784_: f32;
    var phi_2797_: f32;
    var phi_2806_: f32;
    var phi_2815_: f32;
    var phi_2824_: f32;
    var phi_2831_: f32;
    var phi_2838_: f32;
    var phi_2855_: f32;
    var phi_2860_: f32;
    var phi_2865_: f32;
    var phi_2873_: f32;
    var phi_2878_: f32;
    var phi_2883_: f32;
    var phi_2895_: f32;
    var phi_2900_: f32;
    var phi_2905_: f32;
    var phi_2910_: f32;
    var phi_2915_: lt_bvh_triangle_Intersection;
    var phi_2916_: bool;
    var phi_2917_: lt_bvh_triangle_Intersection;
    var phi_2918_: bool;
    var phi_2922_: lt_bvh_triangle_Intersection;
    var phi_2923_: bool;
    var phi_2924_: lt_bvh_triangle_Intersection;
    var phi_2925_: bool;
    var phi_2926_: bool;
    var phi_2930_: bool;
    var phi_2934_: lt_bvh_triangle_Intersection;
    var phi_3148_: f32;
    var phi_3151_: bool;
    var phi_3152_: bool;
    var phi_3153_: bool;
    var phi_3157_: bool;
    var phi_3158_: bool;
    var phi_3159_: bool;
    var phi_3160_: bool;
    var phi_3161_: bool;
    var phi_3162_: bool;
    var phi_3163_: bool;
    var phi_3164_: bool;
    var phi_3165_: bool;
    var phi_3166_: bool;
    var phi_2364_: u32;
    var phi_2367_: bool;
    var phi_3170_: bool;
    var phi_3171_: bool;
    var local_9: bool;
    var phi_3213_: bool;
    var phi_3214_: bool;
    var phi_3245_: u32;
    var phi_3246_: u32;
    var phi_2032_: u32;
    var phi_2035_: bool;
    var phi_3247_: bool;
    var phi_3248_: bool;
    var phi_3249_: bool;
    var local_10: bool;
    var phi_3253_: bool;
    var phi_3257_: bool;
    var phi_3258_: bool;
    var phi_3259_: bool;
    var phi_3260_: bool;
    var phi_3264_: bool;
    var phi_3268_: bool;
    var phi_3269_: bool;
    var phi_3270_: bool;
    var phi_3271_: bool;
    var phi_3272_: bool;
    var phi_3273_: bool;
    var phi_3274_: bool;
    var phi_1424_: u32;
    var phi_1427_: bool;
    var phi_3278_: bool;
    var local_11: bool;
    var phi_3320_: bool;
    var phi_3321_: bool;
    var phi_3352_: u32;
    var phi_3353_: u32;
    var phi_1092_: u32;
    var phi_1095_: bool;
    var phi_3354_: bool;
    var phi_3355_: bool;
    var local_12: bool;
    var phi_3359_: bool;
    var phi_3363_: bool;
    var phi_3364_: bool;
    var phi_3365_: bool;
    var phi_3369_: bool;
    var phi_3370_: bool;
    var phi_3374_: bool;
    var phi_3378_: f32;
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
        let _e117 = p.member.light;
        let _e119 = samples.member[(0u + _e110)].position;
        let _e121 = samples.member[(0u + _e110)].normal;
        let _e123 = samples.member[(0u + _e110)].magnitude;
        let _e125 = ((8f / 8388608f) * _e123);
        let _e133 = (_e119.x + (_e121.x * _e125));
        let _e135 = (_e119.y + (_e121.y * _e125));
        let _e137 = (_e119.z + (_e121.z * _e125));
        if (_e117.w == 0f) {
            phi_693_ = 300000000000000000000000000000000000000f;
        } else {
            phi_693_ = 1f;
        }
        let _e141 = phi_693_;
        let _e149 = (_e117.x - (_e133 * _e117.w));
        let _e150 = (_e117.y - (_e135 * _e117.w));
        let _e151 = (_e117.z - (_e137 * _e117.w));
        let _e155 = abs(_e149);
        let _e156 = abs(_e150);
        let _e157 = abs(_e151);
        if (abs(_e133) < 1000000000000000f) {
            if (abs(_e135) < 1000000000000000f) {
                if (abs(_e137) < 1000000000000000f) {
                    if (_e155 < 1000000000000000f) {
                        if (_e156 < 1000000000000000f) {
                            if (_e157 < 1000000000000000f) {
                                if (_e155 > 0f) {
                                    phi_750_ = bool();
                                    phi_751_ = true;
                                } else {
                                    let _e165 = (_e156 > 0f);
                                    if _e165 {
                                        phi_749_ = bool();
                                    } else {
                                        phi_749_ = (_e157 > 0f);
                                    }
                                    let _e168 = phi_749_;
                                    phi_750_ = _e168;
                                    phi_751_ = _e165;
                                }
                                let _e170 = phi_750_;
                                let _e172 = phi_751_;
                                if _e172 {
                                    phi_755_ = true;
                                } else {
                                    phi_755_ = _e170;
                                }
                                let _e174 = phi_755_;
                                phi_756_ = _e174;
                                phi_757_ = false;
                            } else {
                                phi_756_ = bool();
                                phi_757_ = true;
                            }
                            let _e176 = phi_756_;
                            let _e178 = phi_757_;
                            phi_758_ = _e176;
                            phi_759_ = false;
                            phi_760_ = _e178;
                        } else {
                            phi_758_ = bool();
                            phi_759_ = true;
                            phi_760_ = false;
                        }
                        let _e180 = phi_758_;
                        let _e182 = phi_759_;
                        let _e184 = phi_760_;
                        phi_761_ = _e180;
                        phi_762_ = _e182;
                        phi_763_ = _e184;
                    } else {
                        phi_761_ = bool();
                        phi_762_ = true;
                        phi_763_ = false;
                    }
                    let _e186 = phi_761_;
                    let _e188 = phi_762_;
                    let _e190 = phi_763_;
                    phi_764_ = _e186;
                    phi_765_ = _e188;
                    phi_766_ = _e190;
                } else {
                    phi_764_ = bool();
                    phi_765_ = true;
                    phi_766_ = false;
                }
                let _e192 = phi_764_;
                let _e194 = phi_765_;
                let _e196 = phi_766_;
                phi_767_ = _e192;
                phi_768_ = _e194;
                phi_769_ = _e196;
            } else {
                phi_767_ = bool();
                phi_768_ = true;
                phi_769_ = false;
            }
            let _e198 = phi_767_;
            let _e200 = phi_768_;
            let _e202 = phi_769_;
            phi_770_ = _e198;
            phi_771_ = _e200;
            phi_772_ = _e202;
        } else {
            phi_770_ = bool();
            phi_771_ = true;
            phi_772_ = false;
        }
        let _e204 = phi_770_;
        let _e206 = phi_771_;
        let _e208 = phi_772_;
        if _e206 {
            phi_776_ = true;
        } else {
            phi_776_ = _e208;
        }
        let _e210 = phi_776_;
        if _e210 {
            phi_780_ = false;
        } else {
            phi_780_ = _e204;
        }
        let _e212 = phi_780_;
        if _e212 {
            let _e213 = (_e112 >= _e76);
            if _e213 {
                phi_3363_ = false;
            } else {
                if (_e112 < _e76) {
                } else {
                    return;
                }
                let _e219 = nodes.member[(0u + _e112)].frame[0u];
                let _e223 = nodes.member[(0u + _e112)].frame[1u];
                let _e227 = nodes.member[(0u + _e112)].frame[2u];
                let _e231 = nodes.member[(0u + _e112)].frame[0u];
                let _e235 = nodes.member[(0u + _e112)].frame[1u];
                let _e239 = nodes.member[(0u + _e112)].frame[2u];
                let _e243 = nodes.member[(0u + _e112)].frame[3u];
                let _e277 = core_intrinsics_maximum_number_nsz_f32_(abs(_e149), abs(_e150));
                let _e278 = core_intrinsics_maximum_number_nsz_f32_(_e277, abs(_e151));
                let _e279 = (_e278 * 0.0000000000009094947f);
                if (abs(_e149) < _e279) {
                    phi_850_ = _e279;
                } else {
                    phi_850_ = abs(_e149);
                }
                let _e284 = phi_850_;
                if (_e149 < 0f) {
                    phi_857_ = (-1f / _e284);
                } else {
                    phi_857_ = (1f / _e284);
                }
                let _e289 = phi_857_;
                if (abs(_e150) < _e279) {
                    phi_864_ = _e279;
                } else {
                    phi_864_ = abs(_e150);
                }
                let _e294 = phi_864_;
                if (_e150 < 0f) {
                    phi_871_ = (-1f / _e294);
                } else {
                    phi_871_ = (1f / _e294);
                }
                let _e299 = phi_871_;
                if (abs(_e151) < _e279) {
                    phi_878_ = _e279;
                } else {
                    phi_878_ = abs(_e151);
                }
                let _e304 = phi_878_;
                if (_e151 < 0f) {
                    phi_885_ = (-1f / _e304);
                } else {
                    phi_885_ = (1f / _e304);
                }
                let _e309 = phi_885_;
                let _e313 = abs((bitcast<f32>(_e219) - _e133));
                let _e314 = abs((bitcast<f32>(_e223) - _e135));
                let _e315 = abs((bitcast<f32>(_e227) - _e137));
                let _e319 = abs(((bitcast<f32>(_e231) + (bitcast<f32>((((_e243 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e133));
                let _e320 = abs(((bitcast<f32>(_e235) + (bitcast<f32>((((_e243 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e135));
                let _e321 = abs(((bitcast<f32>(_e239) + (bitcast<f32>((((_e243 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e137));
                if (_e313 > _e319) {
                    phi_902_ = _e313;
                } else {
                    phi_902_ = _e319;
                }
                let _e324 = phi_902_;
                if (_e314 > _e320) {
                    phi_907_ = _e314;
                } else {
                    phi_907_ = _e320;
                }
                let _e327 = phi_907_;
                if (_e315 > _e321) {
                    phi_912_ = _e315;
                } else {
                    phi_912_ = _e321;
                }
                let _e330 = phi_912_;
                let _e331 = core_intrinsics_maximum_number_nsz_f32_(_e324, _e327);
                let _e332 = core_intrinsics_maximum_number_nsz_f32_(_e331, _e330);
                let _e336 = (_e332 * 0.0000019073486f);
                let _e337 = (abs(_e289) * _e336);
                let _e338 = (abs(_e299) * _e336);
                let _e339 = (abs(_e309) * _e336);
                let _e343 = (_e332 * 0.0000009536743f);
                let _e344 = (abs(_e289) * _e343);
                let _e345 = (abs(_e299) * _e343);
                let _e346 = (abs(_e309) * _e343);
                if (_e289 < 0f) {
                    phi_933_ = 0u;
                } else {
                    phi_933_ = 1u;
                }
                let _e349 = phi_933_;
                if (_e299 < 0f) {
                    phi_938_ = 0u;
                } else {
                    phi_938_ = 2u;
                }
                let _e352 = phi_938_;
                if (_e309 < 0f) {
                    phi_943_ = 0u;
                } else {
                    phi_943_ = 4u;
                }
                let _e355 = phi_943_;
                let _e357 = ((_e349 | _e352) | _e355);
                let _e358 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e112, 2147483648u);
                local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e358.first[0], _e358.first[1], _e358.first[2], _e358.first[3], _e358.first[4], _e358.first[5], _e358.first[6], _e358.first[7], _e358.first[8], _e358.first[9], _e358.first[10], _e358.first[11], _e358.first[12], _e358.first[13], _e358.first[14], _e358.first[15], _e358.first[16], _e358.first[17], _e358.first[18], _e358.first[19], _e358.first[20], _e358.first[21], _e358.first[22], _e358.first[23], _e358.first[24], _e358.first[25], _e358.first[26], _e358.first[27], _e358.first[28], _e358.first[29], _e358.first[30], _e358.first[31]), array<u32, 32>(_e358.mask[0], _e358.mask[1], _e358.mask[2], _e358.mask[3], _e358.mask[4], _e358.mask[5], _e358.mask[6], _e358.mask[7], _e358.mask[8], _e358.mask[9], _e358.mask[10], _e358.mask[11], _e358.mask[12], _e358.mask[13], _e358.mask[14], _e358.mask[15], _e358.mask[16], _e358.mask[17], _e358.mask[18], _e358.mask[19], _e358.mask[20], _e358.mask[21], _e358.mask[22], _e358.mask[23], _e358.mask[24], _e358.mask[25], _e358.mask[26], _e358.mask[27], _e358.mask[28], _e358.mask[29], _e358.mask[30], _e358.mask[31]), _e358.len, _e358.group, _e358.group_mask);
                let _e432 = local_2.group_mask;
                if ((_e432 & 4278190080u) == 0u) {
                    let _e436 = local_2.len;
                    if (_e436 == 0u) {
                        phi_1057_ = false;
                    } else {
                        let _e440 = local_2.len;
                        local_2.len = (_e440 - 1u);
                        let _e443 = local_2.len;
                        if (_e443 < 32u) {
                        } else {
                            return;
                        }
                        let _e448 = local_2.first[(0u + _e443)];
                        local_2.group = _e448;
                        let _e451 = local_2.len;
                        if (_e451 < 32u) {
                        } else {
                            return;
                        }
                        let _e456 = local_2.mask[(0u + _e451)];
                        local_2.group_mask = _e456;
                        phi_1057_ = true;
                    }
                    let _e459 = phi_1057_;
                    phi_1058_ = _e459;
                } else {
                    phi_1058_ = true;
                }
                let _e461 = phi_1058_;
                if _e461 {
                    let _e463 = local_2.group_mask;
                    let _e469 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e463)), 32u, (_e463 == 0u)));
                    let _e473 = local_2.group_mask;
                    let _e487 = local_2.group_mask;
                    local_2.group_mask = (_e487 & ~((1u << bitcast<u32>((_e469 & 31u)))));
                    let _e490 = local_2.group;
                    phi_1089_ = (_e490 + countOneBits(((_e473 & ~((4294967295u << bitcast<u32>((((_e469 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1089_ = 4294967295u;
                }
                let _e493 = phi_1089_;
                phi_1091_ = _e493;
                phi_1094_ = false;
                loop {
                    let _e495 = phi_1091_;
                    let _e497 = phi_1094_;
                    if (_e495 != 4294967295u) {
                        if (_e495 < _e76) {
                        } else {
                            return;
                        }
                        let _e504 = nodes.member[(0u + _e495)].frame[3u];
                        let _e529 = (bitcast<f32>((((_e504 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e289);
                        let _e530 = (bitcast<f32>((((_e504 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e299);
                        let _e531 = (bitcast<f32>((((_e504 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e309);
                        let _e534 = nodes.member[(0u + _e495)].frame[0u];
                        let _e538 = nodes.member[(0u + _e495)].frame[1u];
                        let _e542 = nodes.member[(0u + _e495)].frame[2u];
                        let _e547 = ((bitcast<f32>(_e534) - _e133) * _e289);
                        let _e548 = ((bitcast<f32>(_e538) - _e135) * _e299);
                        let _e549 = ((bitcast<f32>(_e542) - _e137) * _e309);
                        let _e557 = nodes.member[(0u + _e495)].x;
                        if (_e289 < 0f) {
                            let _e568 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e557.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e574 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e568.unnamed.root, _e557.w), _e568.unnamed_1);
                            let _e580 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e574.unnamed, lt_bvh_traverse_Tree(_e557.x, _e574.unnamed_1.first_primitive));
                            phi_1174_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e580.unnamed, lt_bvh_traverse_Tree(_e580.unnamed_1.root, _e557.y));
                        } else {
                            let _e596 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e557.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e602 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e596.unnamed.root, _e557.y), _e596.unnamed_1);
                            let _e608 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e602.unnamed, lt_bvh_traverse_Tree(_e557.z, _e602.unnamed_1.first_primitive));
                            phi_1174_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e608.unnamed, lt_bvh_traverse_Tree(_e608.unnamed_1.root, _e557.w));
                        }
                        let _e616 = phi_1174_;
                        let _e626 = nodes.member[(0u + _e495)].y;
                        if (_e299 < 0f) {
                            let _e637 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e626.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e643 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e637.unnamed.root, _e626.w), _e637.unnamed_1);
                            let _e649 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e643.unnamed, lt_bvh_traverse_Tree(_e626.x, _e643.unnamed_1.first_primitive));
                            phi_1201_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e649.unnamed, lt_bvh_traverse_Tree(_e649.unnamed_1.root, _e626.y));
                        } else {
                            let _e665 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e626.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e671 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e665.unnamed.root, _e626.y), _e665.unnamed_1);
                            let _e677 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e671.unnamed, lt_bvh_traverse_Tree(_e626.z, _e671.unnamed_1.first_primitive));
                            phi_1201_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e677.unnamed, lt_bvh_traverse_Tree(_e677.unnamed_1.root, _e626.w));
                        }
                        let _e685 = phi_1201_;
                        let _e695 = nodes.member[(0u + _e495)].z;
                        if (_e309 < 0f) {
                            let _e706 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e695.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e712 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e706.unnamed.root, _e695.w), _e706.unnamed_1);
                            let _e718 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e712.unnamed, lt_bvh_traverse_Tree(_e695.x, _e712.unnamed_1.first_primitive));
                            phi_1228_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e718.unnamed, lt_bvh_traverse_Tree(_e718.unnamed_1.root, _e695.y));
                        } else {
                            let _e734 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e695.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e740 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e734.unnamed.root, _e695.y), _e734.unnamed_1);
                            let _e746 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e740.unnamed, lt_bvh_traverse_Tree(_e695.z, _e740.unnamed_1.first_primitive));
                            phi_1228_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e746.unnamed, lt_bvh_traverse_Tree(_e746.unnamed_1.root, _e695.w));
                        }
                        let _e754 = phi_1228_;
                        phi_1234_ = 0u;
                        phi_1237_ = 0u;
                        loop {
                            let _e764 = phi_1234_;
                            let _e766 = phi_1237_;
                            local_3 = _e766;
                            local_4 = _e766;
                            local_5 = _e766;
                            let _e767 = (_e764 < 8u);
                            if _e767 {
                                let _e769 = (_e764 >> bitcast<u32>(2i));
                                let _e770 = (_e764 & 3u);
                                if (_e769 == 0u) {
                                    phi_1251_ = _e616.unnamed.root;
                                } else {
                                    phi_1251_ = _e616.unnamed.first_primitive;
                                }
                                let _e773 = phi_1251_;
                                if (_e769 == 0u) {
                                    phi_1261_ = _e685.unnamed.root;
                                } else {
                                    phi_1261_ = _e685.unnamed.first_primitive;
                                }
                                let _e782 = phi_1261_;
                                if (_e769 == 0u) {
                                    phi_1271_ = _e754.unnamed.root;
                                } else {
                                    phi_1271_ = _e754.unnamed.first_primitive;
                                }
                                let _e791 = phi_1271_;
                                let _e804 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e773 >> bitcast<u32>(((_e770 * 8u) & 31u))) & 255u)) * _e529) + (_e547 - _e337)), ((f32(((_e782 >> bitcast<u32>(((_e770 * 8u) & 31u))) & 255u)) * _e530) + (_e548 - _e338)));
                                let _e805 = core_intrinsics_maximum_number_nsz_f32_(_e804, ((f32(((_e791 >> bitcast<u32>(((_e770 * 8u) & 31u))) & 255u)) * _e531) + (_e549 - _e339)));
                                if (_e769 == 0u) {
                                    phi_1289_ = _e616.unnamed_1.root;
                                } else {
                                    phi_1289_ = _e616.unnamed_1.first_primitive;
                                }
                                let _e808 = phi_1289_;
                                if (_e769 == 0u) {
                                    phi_1299_ = _e685.unnamed_1.root;
                                } else {
                                    phi_1299_ = _e685.unnamed_1.first_primitive;
                                }
                                let _e817 = phi_1299_;
                                if (_e769 == 0u) {
                                    phi_1309_ = _e754.unnamed_1.root;
                                } else {
                                    phi_1309_ = _e754.unnamed_1.first_primitive;
                                }
                                let _e826 = phi_1309_;
                                let _e839 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e808 >> bitcast<u32>(((_e770 * 8u) & 31u))) & 255u)) * _e529) + (_e547 + _e337)), ((f32(((_e817 >> bitcast<u32>(((_e770 * 8u) & 31u))) & 255u)) * _e530) + (_e548 + _e338)));
                                let _e840 = core_intrinsics_minimum_number_nsz_f32_(_e839, ((f32(((_e826 >> bitcast<u32>(((_e770 * 8u) & 31u))) & 255u)) * _e531) + (_e549 + _e339)));
                                if (_e805 <= _e840) {
                                    if (_e805 <= _e141) {
                                        if (_e840 >= 0f) {
                                            if (_e769 == 0u) {
                                                let _e847 = nodes.member[(0u + _e495)].links[2u];
                                                phi_1345_ = _e847;
                                            } else {
                                                let _e850 = nodes.member[(0u + _e495)].links[3u];
                                                phi_1345_ = _e850;
                                            }
                                            let _e852 = phi_1345_;
                                            let _e857 = ((_e852 >> bitcast<u32>(((_e770 * 8u) & 31u))) & 255u);
                                            let _e858 = (_e857 & 31u);
                                            if (_e858 >= 24u) {
                                                phi_1358_ = (24u + ((_e858 - 24u) ^ _e357));
                                            } else {
                                                phi_1358_ = _e858;
                                            }
                                            let _e864 = phi_1358_;
                                            phi_1363_ = (_e766 | ((_e857 >> bitcast<u32>(5i)) << bitcast<u32>((_e864 & 31u))));
                                        } else {
                                            phi_1363_ = _e766;
                                        }
                                        let _e872 = phi_1363_;
                                        phi_1364_ = _e872;
                                    } else {
                                        phi_1364_ = _e766;
                                    }
                                    let _e874 = phi_1364_;
                                    phi_1365_ = _e874;
                                } else {
                                    phi_1365_ = _e766;
                                }
                                let _e876 = phi_1365_;
                                phi_1235_ = (_e764 + 1u);
                                phi_1238_ = _e876;
                            } else {
                                phi_1235_ = u32();
                                phi_1238_ = u32();
                            }
                            let _e879 = phi_1235_;
                            let _e881 = phi_1238_;
                            continue;
                            continuing {
                                phi_1234_ = _e879;
                                phi_1237_ = _e881;
                                break if !(_e767);
                            }
                        }
                        let _e885 = nodes.member[(0u + _e495)].links[0u];
                        let _e889 = nodes.member[(0u + _e495)].frame[3u];
                        let _e893 = local_3;
                        if ((_e893 & 4278190080u) == 0u) {
                        } else {
                            let _e897 = local_2.group_mask;
                            if ((_e897 & 4278190080u) == 0u) {
                            } else {
                                let _e901 = local_2.len;
                                if (_e901 < 32u) {
                                    let _e904 = local_2.group;
                                    let _e906 = local_2.len;
                                    if (_e906 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.first[(0u + _e906)] = _e904;
                                    let _e912 = local_2.group_mask;
                                    let _e914 = local_2.len;
                                    if (_e914 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.mask[(0u + _e914)] = _e912;
                                    let _e921 = local_2.len;
                                    local_2.len = (_e921 + 1u);
                                }
                            }
                            local_2.group = (_e112 + _e885);
                            let _e925 = local_4;
                            local_2.group_mask = ((_e925 & 4278190080u) | (_e889 >> bitcast<u32>(24i)));
                        }
                        let _e930 = local_5;
                        phi_1423_ = (_e930 & 16777215u);
                        phi_1426_ = _e497;
                        loop {
                            let _e933 = phi_1423_;
                            let _e935 = phi_1426_;
                            local_18 = _e935;
                            let _e936 = (_e933 == 0u);
                            local_11 = _e936;
                            local_19 = _e936;
                            if _e936 {
                                phi_1424_ = u32();
                                phi_1427_ = bool();
                                phi_3278_ = false;
                            } else {
                                let _e939 = nodes.member[(0u + _e495)].links[1u];
                                let _e943 = (_e939 + select(firstTrailingBit(_e933), 32u, (_e933 == 0u)));
                                if (_e943 < arrayLength((&instances.member))) {
                                } else {
                                    return;
                                }
                                let _e950 = instances.member[(0u + _e943)].low_world;
                                let _e952 = instances.member[(0u + _e943)].high_world;
                                let _e959 = ((_e950.x - _e133) * _e289);
                                let _e960 = ((_e950.y - _e135) * _e299);
                                let _e961 = ((_e950.z - _e137) * _e309);
                                let _e968 = ((_e952.x - _e133) * _e289);
                                let _e969 = ((_e952.y - _e135) * _e299);
                                let _e970 = ((_e952.z - _e137) * _e309);
                                if (_e959 < _e968) {
                                    phi_1475_ = _e959;
                                } else {
                                    phi_1475_ = _e968;
                                }
                                let _e973 = phi_1475_;
                                if (_e960 < _e969) {
                                    phi_1480_ = _e960;
                                } else {
                                    phi_1480_ = _e969;
                                }
                                let _e976 = phi_1480_;
                                if (_e961 < _e970) {
                                    phi_1485_ = _e961;
                                } else {
                                    phi_1485_ = _e970;
                                }
                                let _e979 = phi_1485_;
                                if (_e959 > _e968) {
                                    phi_1493_ = _e959;
                                } else {
                                    phi_1493_ = _e968;
                                }
                                let _e985 = phi_1493_;
                                if (_e960 > _e969) {
                                    phi_1498_ = _e960;
                                } else {
                                    phi_1498_ = _e969;
                                }
                                let _e988 = phi_1498_;
                                if (_e961 > _e970) {
                                    phi_1503_ = _e961;
                                } else {
                                    phi_1503_ = _e970;
                                }
                                let _e991 = phi_1503_;
                                let _e995 = core_intrinsics_maximum_number_nsz_f32_((_e973 - _e344), (_e976 - _e345));
                                let _e996 = core_intrinsics_maximum_number_nsz_f32_(_e995, (_e979 - _e346));
                                let _e997 = core_intrinsics_minimum_number_nsz_f32_((_e985 + _e344), (_e988 + _e345));
                                let _e998 = core_intrinsics_minimum_number_nsz_f32_(_e997, (_e991 + _e346));
                                if (_e996 <= _e998) {
                                    if (_e996 <= _e141) {
                                        if (_e998 >= 0f) {
                                            let _e1004 = instances.member[(0u + _e943)].world_to_object[0u];
                                            let _e1015 = ((((_e1004.x * _e133) + (_e1004.y * _e135)) + (_e1004.z * _e137)) + (_e1004.w * 1f));
                                            let _e1017 = instances.member[(0u + _e943)].world_to_object[1u];
                                            let _e1028 = ((((_e1017.x * _e133) + (_e1017.y * _e135)) + (_e1017.z * _e137)) + (_e1017.w * 1f));
                                            let _e1030 = instances.member[(0u + _e943)].world_to_object[2u];
                                            let _e1041 = ((((_e1030.x * _e133) + (_e1030.y * _e135)) + (_e1030.z * _e137)) + (_e1030.w * 1f));
                                            let _e1044 = instances.member[(0u + _e943)].world_to_object[0u];
                                            let _e1055 = ((((_e1044.x * _e149) + (_e1044.y * _e150)) + (_e1044.z * _e151)) + (_e1044.w * 0f));
                                            let _e1057 = instances.member[(0u + _e943)].world_to_object[1u];
                                            let _e1068 = ((((_e1057.x * _e149) + (_e1057.y * _e150)) + (_e1057.z * _e151)) + (_e1057.w * 0f));
                                            let _e1070 = instances.member[(0u + _e943)].world_to_object[2u];
                                            let _e1081 = ((((_e1070.x * _e149) + (_e1070.y * _e150)) + (_e1070.z * _e151)) + (_e1070.w * 0f));
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
                                                                        phi_1648_ = bool();
                                                                        phi_1649_ = true;
                                                                    } else {
                                                                        let _e1100 = (_e1091 > 0f);
                                                                        if _e1100 {
                                                                            phi_1647_ = bool();
                                                                        } else {
                                                                            phi_1647_ = (_e1092 > 0f);
                                                                        }
                                                                        let _e1103 = phi_1647_;
                                                                        phi_1648_ = _e1103;
                                                                        phi_1649_ = _e1100;
                                                                    }
                                                                    let _e1105 = phi_1648_;
                                                                    let _e1107 = phi_1649_;
                                                                    if _e1107 {
                                                                        phi_1653_ = true;
                                                                    } else {
                                                                        phi_1653_ = _e1105;
                                                                    }
                                                                    let _e1109 = phi_1653_;
                                                                    phi_1654_ = _e1109;
                                                                    phi_1655_ = false;
                                                                } else {
                                                                    phi_1654_ = bool();
                                                                    phi_1655_ = true;
                                                                }
                                                                let _e1111 = phi_1654_;
                                                                let _e1113 = phi_1655_;
                                                                phi_1656_ = _e1111;
                                                                phi_1657_ = false;
                                                                phi_1658_ = _e1113;
                                                            } else {
                                                                phi_1656_ = bool();
                                                                phi_1657_ = true;
                                                                phi_1658_ = false;
                                                            }
                                                            let _e1115 = phi_1656_;
                                                            let _e1117 = phi_1657_;
                                                            let _e1119 = phi_1658_;
                                                            phi_1659_ = _e1115;
                                                            phi_1660_ = _e1117;
                                                            phi_1661_ = _e1119;
                                                        } else {
                                                            phi_1659_ = bool();
                                                            phi_1660_ = true;
                                                            phi_1661_ = false;
                                                        }
                                                        let _e1121 = phi_1659_;
                                                        let _e1123 = phi_1660_;
                                                        let _e1125 = phi_1661_;
                                                        phi_1662_ = _e1121;
                                                        phi_1663_ = _e1123;
                                                        phi_1664_ = _e1125;
                                                    } else {
                                                        phi_1662_ = bool();
                                                        phi_1663_ = true;
                                                        phi_1664_ = false;
                                                    }
                                                    let _e1127 = phi_1662_;
                                                    let _e1129 = phi_1663_;
                                                    let _e1131 = phi_1664_;
                                                    phi_1665_ = _e1127;
                                                    phi_1666_ = _e1129;
                                                    phi_1667_ = _e1131;
                                                } else {
                                                    phi_1665_ = bool();
                                                    phi_1666_ = true;
                                                    phi_1667_ = false;
                                                }
                                                let _e1133 = phi_1665_;
                                                let _e1135 = phi_1666_;
                                                let _e1137 = phi_1667_;
                                                phi_1668_ = _e1133;
                                                phi_1669_ = _e1135;
                                                phi_1670_ = _e1137;
                                            } else {
                                                phi_1668_ = bool();
                                                phi_1669_ = true;
                                                phi_1670_ = false;
                                            }
                                            let _e1139 = phi_1668_;
                                            let _e1141 = phi_1669_;
                                            let _e1143 = phi_1670_;
                                            if _e1141 {
                                                phi_1674_ = true;
                                            } else {
                                                phi_1674_ = _e1143;
                                            }
                                            let _e1145 = phi_1674_;
                                            if _e1145 {
                                                phi_1678_ = false;
                                            } else {
                                                phi_1678_ = _e1139;
                                            }
                                            let _e1147 = phi_1678_;
                                            if _e1147 {
                                                let _e1148 = (_e1084 >= _e76);
                                                if _e1148 {
                                                    phi_3258_ = bool();
                                                } else {
                                                    if (_e1084 < _e76) {
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
                                                        phi_1748_ = _e1214;
                                                    } else {
                                                        phi_1748_ = abs(_e1055);
                                                    }
                                                    let _e1219 = phi_1748_;
                                                    if (_e1055 < 0f) {
                                                        phi_1755_ = (-1f / _e1219);
                                                    } else {
                                                        phi_1755_ = (1f / _e1219);
                                                    }
                                                    let _e1224 = phi_1755_;
                                                    if (abs(_e1068) < _e1214) {
                                                        phi_1762_ = _e1214;
                                                    } else {
                                                        phi_1762_ = abs(_e1068);
                                                    }
                                                    let _e1229 = phi_1762_;
                                                    if (_e1068 < 0f) {
                                                        phi_1769_ = (-1f / _e1229);
                                                    } else {
                                                        phi_1769_ = (1f / _e1229);
                                                    }
                                                    let _e1234 = phi_1769_;
                                                    if (abs(_e1081) < _e1214) {
                                                        phi_1776_ = _e1214;
                                                    } else {
                                                        phi_1776_ = abs(_e1081);
                                                    }
                                                    let _e1239 = phi_1776_;
                                                    if (_e1081 < 0f) {
                                                        phi_1783_ = (-1f / _e1239);
                                                    } else {
                                                        phi_1783_ = (1f / _e1239);
                                                    }
                                                    let _e1244 = phi_1783_;
                                                    let _e1248 = abs((bitcast<f32>(_e1154) - _e1015));
                                                    let _e1249 = abs((bitcast<f32>(_e1158) - _e1028));
                                                    let _e1250 = abs((bitcast<f32>(_e1162) - _e1041));
                                                    let _e1254 = abs(((bitcast<f32>(_e1166) + (bitcast<f32>((((_e1178 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1015));
                                                    let _e1255 = abs(((bitcast<f32>(_e1170) + (bitcast<f32>((((_e1178 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1028));
                                                    let _e1256 = abs(((bitcast<f32>(_e1174) + (bitcast<f32>((((_e1178 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1041));
                                                    if (_e1248 > _e1254) {
                                                        phi_1800_ = _e1248;
                                                    } else {
                                                        phi_1800_ = _e1254;
                                                    }
                                                    let _e1259 = phi_1800_;
                                                    if (_e1249 > _e1255) {
                                                        phi_1805_ = _e1249;
                                                    } else {
                                                        phi_1805_ = _e1255;
                                                    }
                                                    let _e1262 = phi_1805_;
                                                    if (_e1250 > _e1256) {
                                                        phi_1810_ = _e1250;
                                                    } else {
                                                        phi_1810_ = _e1256;
                                                    }
                                                    let _e1265 = phi_1810_;
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
                                                            phi_1838_ = false;
                                                        } else {
                                                            phi_1838_ = true;
                                                        }
                                                        let _e1288 = phi_1838_;
                                                        phi_1839_ = _e1288;
                                                    } else {
                                                        phi_1839_ = true;
                                                    }
                                                    let _e1290 = phi_1839_;
                                                    if _e1290 {
                                                        if (_e1283 >= _e1284) {
                                                            phi_1847_ = 1u;
                                                        } else {
                                                            phi_1847_ = 2u;
                                                        }
                                                        let _e1293 = phi_1847_;
                                                        phi_1848_ = _e1293;
                                                    } else {
                                                        phi_1848_ = 0u;
                                                    }
                                                    let _e1295 = phi_1848_;
                                                    if (_e1295 == 0u) {
                                                        phi_1860_ = vec3<f32>(_e1068, _e1081, _e1055);
                                                    } else {
                                                        if (_e1295 == 1u) {
                                                            phi_1859_ = vec3<f32>(_e1081, _e1055, _e1068);
                                                        } else {
                                                            phi_1859_ = vec3<f32>(_e1055, _e1068, _e1081);
                                                        }
                                                        let _e1301 = phi_1859_;
                                                        phi_1860_ = _e1301;
                                                    }
                                                    let _e1303 = phi_1860_;
                                                    let _e1306 = (_e1303.x / _e1303.z);
                                                    let _e1309 = (_e1303.y / _e1303.z);
                                                    if (_e1224 < 0f) {
                                                        phi_1873_ = 0u;
                                                    } else {
                                                        phi_1873_ = 1u;
                                                    }
                                                    let _e1314 = phi_1873_;
                                                    if (_e1234 < 0f) {
                                                        phi_1878_ = 0u;
                                                    } else {
                                                        phi_1878_ = 2u;
                                                    }
                                                    let _e1317 = phi_1878_;
                                                    if (_e1244 < 0f) {
                                                        phi_1883_ = 0u;
                                                    } else {
                                                        phi_1883_ = 4u;
                                                    }
                                                    let _e1320 = phi_1883_;
                                                    let _e1322 = ((_e1314 | _e1317) | _e1320);
                                                    let _e1323 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1084, 2147483648u);
                                                    local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e1323.first[0], _e1323.first[1], _e1323.first[2], _e1323.first[3], _e1323.first[4], _e1323.first[5], _e1323.first[6], _e1323.first[7], _e1323.first[8], _e1323.first[9], _e1323.first[10], _e1323.first[11], _e1323.first[12], _e1323.first[13], _e1323.first[14], _e1323.first[15], _e1323.first[16], _e1323.first[17], _e1323.first[18], _e1323.first[19], _e1323.first[20], _e1323.first[21], _e1323.first[22], _e1323.first[23], _e1323.first[24], _e1323.first[25], _e1323.first[26], _e1323.first[27], _e1323.first[28], _e1323.first[29], _e1323.first[30], _e1323.first[31]), array<u32, 32>(_e1323.mask[0], _e1323.mask[1], _e1323.mask[2], _e1323.mask[3], _e1323.mask[4], _e1323.mask[5], _e1323.mask[6], _e1323.mask[7], _e1323.mask[8], _e1323.mask[9], _e1323.mask[10], _e1323.mask[11], _e1323.mask[12], _e1323.mask[13], _e1323.mask[14], _e1323.mask[15], _e1323.mask[16], _e1323.mask[17], _e1323.mask[18], _e1323.mask[19], _e1323.mask[20], _e1323.mask[21], _e1323.mask[22], _e1323.mask[23], _e1323.mask[24], _e1323.mask[25], _e1323.mask[26], _e1323.mask[27], _e1323.mask[28], _e1323.mask[29], _e1323.mask[30], _e1323.mask[31]), _e1323.len, _e1323.group, _e1323.group_mask);
                                                    let _e1397 = local_1.group_mask;
                                                    if ((_e1397 & 4278190080u) == 0u) {
                                                        let _e1401 = local_1.len;
                                                        if (_e1401 == 0u) {
                                                            phi_1997_ = false;
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
                                                            phi_1997_ = true;
                                                        }
                                                        let _e1424 = phi_1997_;
                                                        phi_1998_ = _e1424;
                                                    } else {
                                                        phi_1998_ = true;
                                                    }
                                                    let _e1426 = phi_1998_;
                                                    if _e1426 {
                                                        let _e1428 = local_1.group_mask;
                                                        let _e1434 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1428)), 32u, (_e1428 == 0u)));
                                                        let _e1438 = local_1.group_mask;
                                                        let _e1452 = local_1.group_mask;
                                                        local_1.group_mask = (_e1452 & ~((1u << bitcast<u32>((_e1434 & 31u)))));
                                                        let _e1455 = local_1.group;
                                                        phi_2029_ = (_e1455 + countOneBits(((_e1438 & ~((4294967295u << bitcast<u32>((((_e1434 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_2029_ = 4294967295u;
                                                    }
                                                    let _e1458 = phi_2029_;
                                                    phi_2031_ = _e1458;
                                                    phi_2034_ = _e935;
                                                    loop {
                                                        let _e1460 = phi_2031_;
                                                        let _e1462 = phi_2034_;
                                                        local_17 = _e1462;
                                                        if (_e1460 != 4294967295u) {
                                                            if (_e1460 < _e76) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1469 = nodes.member[(0u + _e1460)].frame[3u];
                                                            let _e1494 = (bitcast<f32>((((_e1469 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1224);
                                                            let _e1495 = (bitcast<f32>((((_e1469 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1234);
                                                            let _e1496 = (bitcast<f32>((((_e1469 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1244);
                                                            let _e1499 = nodes.member[(0u + _e1460)].frame[0u];
                                                            let _e1503 = nodes.member[(0u + _e1460)].frame[1u];
                                                            let _e1507 = nodes.member[(0u + _e1460)].frame[2u];
                                                            let _e1512 = ((bitcast<f32>(_e1499) - _e1015) * _e1224);
                                                            let _e1513 = ((bitcast<f32>(_e1503) - _e1028) * _e1234);
                                                            let _e1514 = ((bitcast<f32>(_e1507) - _e1041) * _e1244);
                                                            let _e1522 = nodes.member[(0u + _e1460)].x;
                                                            if (_e1224 < 0f) {
                                                                let _e1533 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1522.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1539 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1533.unnamed.root, _e1522.w), _e1533.unnamed_1);
                                                                let _e1545 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1539.unnamed, lt_bvh_traverse_Tree(_e1522.x, _e1539.unnamed_1.first_primitive));
                                                                phi_2114_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1545.unnamed, lt_bvh_traverse_Tree(_e1545.unnamed_1.root, _e1522.y));
                                                            } else {
                                                                let _e1561 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1522.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1567 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1561.unnamed.root, _e1522.y), _e1561.unnamed_1);
                                                                let _e1573 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1567.unnamed, lt_bvh_traverse_Tree(_e1522.z, _e1567.unnamed_1.first_primitive));
                                                                phi_2114_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1573.unnamed, lt_bvh_traverse_Tree(_e1573.unnamed_1.root, _e1522.w));
                                                            }
                                                            let _e1581 = phi_2114_;
                                                            let _e1591 = nodes.member[(0u + _e1460)].y;
                                                            if (_e1234 < 0f) {
                                                                let _e1602 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1591.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1608 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1602.unnamed.root, _e1591.w), _e1602.unnamed_1);
                                                                let _e1614 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1608.unnamed, lt_bvh_traverse_Tree(_e1591.x, _e1608.unnamed_1.first_primitive));
                                                                phi_2141_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1614.unnamed, lt_bvh_traverse_Tree(_e1614.unnamed_1.root, _e1591.y));
                                                            } else {
                                                                let _e1630 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1591.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1636 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1630.unnamed.root, _e1591.y), _e1630.unnamed_1);
                                                                let _e1642 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1636.unnamed, lt_bvh_traverse_Tree(_e1591.z, _e1636.unnamed_1.first_primitive));
                                                                phi_2141_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1642.unnamed, lt_bvh_traverse_Tree(_e1642.unnamed_1.root, _e1591.w));
                                                            }
                                                            let _e1650 = phi_2141_;
                                                            let _e1660 = nodes.member[(0u + _e1460)].z;
                                                            if (_e1244 < 0f) {
                                                                let _e1671 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1660.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1677 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1671.unnamed.root, _e1660.w), _e1671.unnamed_1);
                                                                let _e1683 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1677.unnamed, lt_bvh_traverse_Tree(_e1660.x, _e1677.unnamed_1.first_primitive));
                                                                phi_2168_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1683.unnamed, lt_bvh_traverse_Tree(_e1683.unnamed_1.root, _e1660.y));
                                                            } else {
                                                                let _e1699 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1660.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1705 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1699.unnamed.root, _e1660.y), _e1699.unnamed_1);
                                                                let _e1711 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1705.unnamed, lt_bvh_traverse_Tree(_e1660.z, _e1705.unnamed_1.first_primitive));
                                                                phi_2168_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1711.unnamed, lt_bvh_traverse_Tree(_e1711.unnamed_1.root, _e1660.w));
                                                            }
                                                            let _e1719 = phi_2168_;
                                                            phi_2174_ = 0u;
                                                            phi_2177_ = 0u;
                                                            loop {
                                                                let _e1729 = phi_2174_;
                                                                let _e1731 = phi_2177_;
                                                                local_6 = _e1731;
                                                                local_7 = _e1731;
                                                                local_8 = _e1731;
                                                                let _e1732 = (_e1729 < 8u);
                                                                if _e1732 {
                                                                    let _e1734 = (_e1729 >> bitcast<u32>(2i));
                                                                    let _e1735 = (_e1729 & 3u);
                                                                    if (_e1734 == 0u) {
                                                                        phi_2191_ = _e1581.unnamed.root;
                                                                    } else {
                                                                        phi_2191_ = _e1581.unnamed.first_primitive;
                                                                    }
                                                                    let _e1738 = phi_2191_;
                                                                    if (_e1734 == 0u) {
                                                                        phi_2201_ = _e1650.unnamed.root;
                                                                    } else {
                                                                        phi_2201_ = _e1650.unnamed.first_primitive;
                                                                    }
                                                                    let _e1747 = phi_2201_;
                                                                    if (_e1734 == 0u) {
                                                                        phi_2211_ = _e1719.unnamed.root;
                                                                    } else {
                                                                        phi_2211_ = _e1719.unnamed.first_primitive;
                                                                    }
                                                                    let _e1756 = phi_2211_;
                                                                    let _e1769 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1738 >> bitcast<u32>(((_e1735 * 8u) & 31u))) & 255u)) * _e1494) + (_e1512 - _e1272)), ((f32(((_e1747 >> bitcast<u32>(((_e1735 * 8u) & 31u))) & 255u)) * _e1495) + (_e1513 - _e1273)));
                                                                    let _e1770 = core_intrinsics_maximum_number_nsz_f32_(_e1769, ((f32(((_e1756 >> bitcast<u32>(((_e1735 * 8u) & 31u))) & 255u)) * _e1496) + (_e1514 - _e1274)));
                                                                    if (_e1734 == 0u) {
                                                                        phi_2229_ = _e1581.unnamed_1.root;
                                                                    } else {
                                                                        phi_2229_ = _e1581.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1773 = phi_2229_;
                                                                    if (_e1734 == 0u) {
                                                                        phi_2239_ = _e1650.unnamed_1.root;
                                                                    } else {
                                                                        phi_2239_ = _e1650.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1782 = phi_2239_;
                                                                    if (_e1734 == 0u) {
                                                                        phi_2249_ = _e1719.unnamed_1.root;
                                                                    } else {
                                                                        phi_2249_ = _e1719.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1791 = phi_2249_;
                                                                    let _e1804 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1773 >> bitcast<u32>(((_e1735 * 8u) & 31u))) & 255u)) * _e1494) + (_e1512 + _e1272)), ((f32(((_e1782 >> bitcast<u32>(((_e1735 * 8u) & 31u))) & 255u)) * _e1495) + (_e1513 + _e1273)));
                                                                    let _e1805 = core_intrinsics_minimum_number_nsz_f32_(_e1804, ((f32(((_e1791 >> bitcast<u32>(((_e1735 * 8u) & 31u))) & 255u)) * _e1496) + (_e1514 + _e1274)));
                                                                    if (_e1770 <= _e1805) {
                                                                        if (_e1770 <= _e141) {
                                                                            if (_e1805 >= 0f) {
                                                                                if (_e1734 == 0u) {
                                                                                    let _e1812 = nodes.member[(0u + _e1460)].links[2u];
                                                                                    phi_2285_ = _e1812;
                                                                                } else {
                                                                                    let _e1815 = nodes.member[(0u + _e1460)].links[3u];
                                                                                    phi_2285_ = _e1815;
                                                                                }
                                                                                let _e1817 = phi_2285_;
                                                                                let _e1822 = ((_e1817 >> bitcast<u32>(((_e1735 * 8u) & 31u))) & 255u);
                                                                                let _e1823 = (_e1822 & 31u);
                                                                                if (_e1823 >= 24u) {
                                                                                    phi_2298_ = (24u + ((_e1823 - 24u) ^ _e1322));
                                                                                } else {
                                                                                    phi_2298_ = _e1823;
                                                                                }
                                                                                let _e1829 = phi_2298_;
                                                                                phi_2303_ = (_e1731 | ((_e1822 >> bitcast<u32>(5i)) << bitcast<u32>((_e1829 & 31u))));
                                                                            } else {
                                                                                phi_2303_ = _e1731;
                                                                            }
                                                                            let _e1837 = phi_2303_;
                                                                            phi_2304_ = _e1837;
                                                                        } else {
                                                                            phi_2304_ = _e1731;
                                                                        }
                                                                        let _e1839 = phi_2304_;
                                                                        phi_2305_ = _e1839;
                                                                    } else {
                                                                        phi_2305_ = _e1731;
                                                                    }
                                                                    let _e1841 = phi_2305_;
                                                                    phi_2175_ = (_e1729 + 1u);
                                                                    phi_2178_ = _e1841;
                                                                } else {
                                                                    phi_2175_ = u32();
                                                                    phi_2178_ = u32();
                                                                }
                                                                let _e1844 = phi_2175_;
                                                                let _e1846 = phi_2178_;
                                                                continue;
                                                                continuing {
                                                                    phi_2174_ = _e1844;
                                                                    phi_2177_ = _e1846;
                                                                    break if !(_e1732);
                                                                }
                                                            }
                                                            let _e1850 = nodes.member[(0u + _e1460)].links[0u];
                                                            let _e1854 = nodes.member[(0u + _e1460)].frame[3u];
                                                            let _e1858 = local_6;
                                                            if ((_e1858 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1862 = local_1.group_mask;
                                                                if ((_e1862 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1866 = local_1.len;
                                                                    if (_e1866 < 32u) {
                                                                        let _e1869 = local_1.group;
                                                                        let _e1871 = local_1.len;
                                                                        if (_e1871 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.first[(0u + _e1871)] = _e1869;
                                                                        let _e1877 = local_1.group_mask;
                                                                        let _e1879 = local_1.len;
                                                                        if (_e1879 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.mask[(0u + _e1879)] = _e1877;
                                                                        let _e1886 = local_1.len;
                                                                        local_1.len = (_e1886 + 1u);
                                                                    }
                                                                }
                                                                local_1.group = (_e1084 + _e1850);
                                                                let _e1890 = local_7;
                                                                local_1.group_mask = ((_e1890 & 4278190080u) | (_e1854 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1895 = local_8;
                                                            phi_2363_ = (_e1895 & 16777215u);
                                                            phi_2366_ = _e1462;
                                                            loop {
                                                                let _e1898 = phi_2363_;
                                                                let _e1900 = phi_2366_;
                                                                local_13 = _e1900;
                                                                let _e1901 = (_e1898 == 0u);
                                                                local_9 = _e1901;
                                                                local_15 = _e1901;
                                                                if _e1901 {
                                                                    phi_2364_ = u32();
                                                                    phi_2367_ = bool();
                                                                    phi_3170_ = bool();
                                                                    phi_3171_ = false;
                                                                } else {
                                                                    let _e1904 = nodes.member[(0u + _e1460)].links[1u];
                                                                    let _e1909 = ((_e1086 + _e1904) + select(firstTrailingBit(_e1898), 32u, (_e1898 == 0u)));
                                                                    if (_e1909 < _e79) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1916 = triangles.member[(0u + _e1909)].v0_;
                                                                    let _e1918 = (_e1916.x - _e1015);
                                                                    let _e1920 = (_e1916.y - _e1028);
                                                                    let _e1922 = (_e1916.z - _e1041);
                                                                    if (_e1295 == 0u) {
                                                                        phi_2411_ = vec3<f32>(_e1920, _e1922, _e1918);
                                                                    } else {
                                                                        if (_e1295 == 1u) {
                                                                            phi_2410_ = vec3<f32>(_e1922, _e1918, _e1920);
                                                                        } else {
                                                                            phi_2410_ = (_e1916 - vec3<f32>(_e1015, _e1028, _e1041));
                                                                        }
                                                                        let _e1930 = phi_2410_;
                                                                        phi_2411_ = _e1930;
                                                                    }
                                                                    let _e1932 = phi_2411_;
                                                                    let _e1936 = (_e1932.x - (_e1306 * _e1932.z));
                                                                    let _e1940 = (_e1932.y - (_e1309 * _e1932.z));
                                                                    let _e1942 = triangles.member[(0u + _e1909)].v1_;
                                                                    let _e1944 = (_e1942.x - _e1015);
                                                                    let _e1946 = (_e1942.y - _e1028);
                                                                    let _e1948 = (_e1942.z - _e1041);
                                                                    if (_e1295 == 0u) {
                                                                        phi_2441_ = vec3<f32>(_e1946, _e1948, _e1944);
                                                                    } else {
                                                                        if (_e1295 == 1u) {
                                                                            phi_2440_ = vec3<f32>(_e1948, _e1944, _e1946);
                                                                        } else {
                                                                            phi_2440_ = (_e1942 - vec3<f32>(_e1015, _e1028, _e1041));
                                                                        }
                                                                        let _e1956 = phi_2440_;
                                                                        phi_2441_ = _e1956;
                                                                    }
                                                                    let _e1958 = phi_2441_;
                                                                    let _e1962 = (_e1958.x - (_e1306 * _e1958.z));
                                                                    let _e1966 = (_e1958.y - (_e1309 * _e1958.z));
                                                                    let _e1968 = triangles.member[(0u + _e1909)].v2_;
                                                                    let _e1970 = (_e1968.x - _e1015);
                                                                    let _e1972 = (_e1968.y - _e1028);
                                                                    let _e1974 = (_e1968.z - _e1041);
                                                                    if (_e1295 == 0u) {
                                                                        phi_2471_ = vec3<f32>(_e1972, _e1974, _e1970);
                                                                    } else {
                                                                        if (_e1295 == 1u) {
                                                                            phi_2470_ = vec3<f32>(_e1974, _e1970, _e1972);
                                                                        } else {
                                                                            phi_2470_ = (_e1968 - vec3<f32>(_e1015, _e1028, _e1041));
                                                                        }
                                                                        let _e1982 = phi_2470_;
                                                                        phi_2471_ = _e1982;
                                                                    }
                                                                    let _e1984 = phi_2471_;
                                                                    let _e1988 = (_e1984.x - (_e1306 * _e1984.z));
                                                                    let _e1992 = (_e1984.y - (_e1309 * _e1984.z));
                                                                    if (_e1962 < _e1988) {
                                                                        phi_2490_ = true;
                                                                    } else {
                                                                        if (_e1962 == _e1988) {
                                                                            phi_2489_ = (_e1966 < _e1992);
                                                                        } else {
                                                                            phi_2489_ = false;
                                                                        }
                                                                        let _e1997 = phi_2489_;
                                                                        phi_2490_ = _e1997;
                                                                    }
                                                                    let _e1999 = phi_2490_;
                                                                    if _e1999 {
                                                                        phi_2494_ = _e1992;
                                                                        phi_2495_ = _e1988;
                                                                        phi_2496_ = _e1966;
                                                                        phi_2497_ = _e1962;
                                                                    } else {
                                                                        phi_2494_ = _e1966;
                                                                        phi_2495_ = _e1962;
                                                                        phi_2496_ = _e1992;
                                                                        phi_2497_ = _e1988;
                                                                    }
                                                                    let _e2001 = phi_2494_;
                                                                    let _e2003 = phi_2495_;
                                                                    let _e2005 = phi_2496_;
                                                                    let _e2007 = phi_2497_;
                                                                    let _e2010 = ((_e2007 * _e2001) - (_e2005 * _e2003));
                                                                    if _e1999 {
                                                                        phi_2505_ = -(_e2010);
                                                                    } else {
                                                                        phi_2505_ = _e2010;
                                                                    }
                                                                    let _e2013 = phi_2505_;
                                                                    if (_e1988 < _e1936) {
                                                                        phi_2516_ = true;
                                                                    } else {
                                                                        if (_e1988 == _e1936) {
                                                                            phi_2515_ = (_e1992 < _e1940);
                                                                        } else {
                                                                            phi_2515_ = false;
                                                                        }
                                                                        let _e2018 = phi_2515_;
                                                                        phi_2516_ = _e2018;
                                                                    }
                                                                    let _e2020 = phi_2516_;
                                                                    if _e2020 {
                                                                        phi_2520_ = _e1940;
                                                                        phi_2521_ = _e1936;
                                                                        phi_2522_ = _e1992;
                                                                        phi_2523_ = _e1988;
                                                                    } else {
                                                                        phi_2520_ = _e1992;
                                                                        phi_2521_ = _e1988;
                                                                        phi_2522_ = _e1940;
                                                                        phi_2523_ = _e1936;
                                                                    }
                                                                    let _e2022 = phi_2520_;
                                                                    let _e2024 = phi_2521_;
                                                                    let _e2026 = phi_2522_;
                                                                    let _e2028 = phi_2523_;
                                                                    let _e2031 = ((_e2028 * _e2022) - (_e2026 * _e2024));
                                                                    if _e2020 {
                                                                        phi_2531_ = -(_e2031);
                                                                    } else {
                                                                        phi_2531_ = _e2031;
                                                                    }
                                                                    let _e2034 = phi_2531_;
                                                                    if (_e1936 < _e1962) {
                                                                        phi_2542_ = true;
                                                                    } else {
                                                                        if (_e1936 == _e1962) {
                                                                            phi_2541_ = (_e1940 < _e1966);
                                                                        } else {
                                                                            phi_2541_ = false;
                                                                        }
                                                                        let _e2039 = phi_2541_;
                                                                        phi_2542_ = _e2039;
                                                                    }
                                                                    let _e2041 = phi_2542_;
                                                                    if _e2041 {
                                                                        phi_2546_ = _e1966;
                                                                        phi_2547_ = _e1962;
                                                                        phi_2548_ = _e1940;
                                                                        phi_2549_ = _e1936;
                                                                    } else {
                                                                        phi_2546_ = _e1940;
                                                                        phi_2547_ = _e1936;
                                                                        phi_2548_ = _e1966;
                                                                        phi_2549_ = _e1962;
                                                                    }
                                                                    let _e2043 = phi_2546_;
                                                                    let _e2045 = phi_2547_;
                                                                    let _e2047 = phi_2548_;
                                                                    let _e2049 = phi_2549_;
                                                                    let _e2052 = ((_e2049 * _e2043) - (_e2047 * _e2045));
                                                                    if _e2041 {
                                                                        phi_2557_ = -(_e2052);
                                                                    } else {
                                                                        phi_2557_ = _e2052;
                                                                    }
                                                                    let _e2055 = phi_2557_;
                                                                    if (_e2013 >= 0f) {
                                                                        if (_e2034 >= 0f) {
                                                                            if (_e2055 >= 0f) {
                                                                                phi_2572_ = ((_e2013 + _e2034) + _e2055);
                                                                                phi_2573_ = false;
                                                                            } else {
                                                                                phi_2572_ = f32();
                                                                                phi_2573_ = true;
                                                                            }
                                                                            let _e2062 = phi_2572_;
                                                                            let _e2064 = phi_2573_;
                                                                            phi_2574_ = _e2062;
                                                                            phi_2575_ = _e2064;
                                                                        } else {
                                                                            phi_2574_ = f32();
                                                                            phi_2575_ = true;
                                                                        }
                                                                        let _e2066 = phi_2574_;
                                                                        let _e2068 = phi_2575_;
                                                                        phi_2576_ = _e2066;
                                                                        phi_2577_ = _e2068;
                                                                    } else {
                                                                        phi_2576_ = f32();
                                                                        phi_2577_ = true;
                                                                    }
                                                                    let _e2070 = phi_2576_;
                                                                    let _e2072 = phi_2577_;
                                                                    if _e2072 {
                                                                        if (_e2013 <= 0f) {
                                                                            if (_e2034 <= 0f) {
                                                                                let _e2075 = (_e2055 <= 0f);
                                                                                if _e2075 {
                                                                                }
                                                                                phi_2595_ = ((_e2013 + _e2034) + _e2055);
                                                                                phi_2596_ = false;
                                                                                phi_2597_ = _e2075;
                                                                            } else {
                                                                                phi_2595_ = f32();
                                                                                phi_2596_ = true;
                                                                                phi_2597_ = false;
                                                                            }
                                                                            let _e2079 = phi_2595_;
                                                                            let _e2081 = phi_2596_;
                                                                            let _e2083 = phi_2597_;
                                                                            phi_2598_ = _e2079;
                                                                            phi_2599_ = _e2081;
                                                                            phi_2600_ = _e2083;
                                                                        } else {
                                                                            phi_2598_ = f32();
                                                                            phi_2599_ = true;
                                                                            phi_2600_ = false;
                                                                        }
                                                                        let _e2085 = phi_2598_;
                                                                        let _e2087 = phi_2599_;
                                                                        let _e2089 = phi_2600_;
                                                                        if _e2087 {
                                                                            phi_2604_ = false;
                                                                        } else {
                                                                            phi_2604_ = _e2089;
                                                                        }
                                                                        let _e2091 = phi_2604_;
                                                                        phi_2605_ = _e2085;
                                                                        phi_2606_ = _e2091;
                                                                    } else {
                                                                        phi_2605_ = _e2070;
                                                                        phi_2606_ = true;
                                                                    }
                                                                    let _e2093 = phi_2605_;
                                                                    let _e2095 = phi_2606_;
                                                                    if _e2095 {
                                                                        let _e2096 = (_e2093 == 0f);
                                                                        if _e2096 {
                                                                            phi_2922_ = lt_bvh_triangle_Intersection();
                                                                            phi_2923_ = false;
                                                                        } else {
                                                                            let _e2098 = triangles.member[(0u + _e1909)].v0_;
                                                                            let _e2100 = (_e2098.x - _e1015);
                                                                            let _e2102 = (_e2098.y - _e1028);
                                                                            let _e2104 = (_e2098.z - _e1041);
                                                                            if (_e1295 == 0u) {
                                                                                phi_2635_ = vec3<f32>(_e2102, _e2104, _e2100);
                                                                            } else {
                                                                                if (_e1295 == 1u) {
                                                                                    phi_2634_ = vec3<f32>(_e2104, _e2100, _e2102);
                                                                                } else {
                                                                                    phi_2634_ = (_e2098 - vec3<f32>(_e1015, _e1028, _e1041));
                                                                                }
                                                                                let _e2112 = phi_2634_;
                                                                                phi_2635_ = _e2112;
                                                                            }
                                                                            let _e2114 = phi_2635_;
                                                                            let _e2116 = triangles.member[(0u + _e1909)].v1_;
                                                                            let _e2118 = triangles.member[(0u + _e1909)].v0_;
                                                                            let _e2121 = (_e2116.x - _e2118.x);
                                                                            let _e2124 = (_e2116.y - _e2118.y);
                                                                            let _e2127 = (_e2116.z - _e2118.z);
                                                                            if (_e1295 == 0u) {
                                                                                phi_2661_ = vec3<f32>(_e2124, _e2127, _e2121);
                                                                            } else {
                                                                                if (_e1295 == 1u) {
                                                                                    phi_2660_ = vec3<f32>(_e2127, _e2121, _e2124);
                                                                                } else {
                                                                                    phi_2660_ = (_e2116 - _e2118);
                                                                                }
                                                                                let _e2134 = phi_2660_;
                                                                                phi_2661_ = _e2134;
                                                                            }
                                                                            let _e2136 = phi_2661_;
                                                                            let _e2138 = triangles.member[(0u + _e1909)].v2_;
                                                                            let _e2140 = triangles.member[(0u + _e1909)].v0_;
                                                                            let _e2143 = (_e2138.x - _e2140.x);
                                                                            let _e2146 = (_e2138.y - _e2140.y);
                                                                            let _e2149 = (_e2138.z - _e2140.z);
                                                                            if (_e1295 == 0u) {
                                                                                phi_2687_ = vec3<f32>(_e2146, _e2149, _e2143);
                                                                            } else {
                                                                                if (_e1295 == 1u) {
                                                                                    phi_2686_ = vec3<f32>(_e2149, _e2143, _e2146);
                                                                                } else {
                                                                                    phi_2686_ = (_e2138 - _e2140);
                                                                                }
                                                                                let _e2156 = phi_2686_;
                                                                                phi_2687_ = _e2156;
                                                                            }
                                                                            let _e2158 = phi_2687_;
                                                                            let _e2165 = ((_e2136.y * _e2158.z) - (_e2136.z * _e2158.y));
                                                                            let _e2172 = ((_e2136.z * _e2158.x) - (_e2136.x * _e2158.z));
                                                                            let _e2179 = ((_e2136.x * _e2158.y) - (_e2136.y * _e2158.x));
                                                                            let _e2193 = (((1f / _e1303.z) * (((_e2165 * _e2114.x) + (_e2172 * _e2114.y)) + (_e2179 * _e2114.z))) / (((_e2165 * _e1306) + (_e2172 * _e1309)) + _e2179));
                                                                            if (_e2193 > 0f) {
                                                                                if (_e2193 < _e141) {
                                                                                    let _e2197 = triangles.member[(0u + _e1909)].v0_;
                                                                                    let _e2199 = triangles.member[(0u + _e1909)].v1_;
                                                                                    if (_e2197.x < _e2199.x) {
                                                                                        phi_2743_ = _e2197.x;
                                                                                    } else {
                                                                                        phi_2743_ = _e2199.x;
                                                                                    }
                                                                                    let _e2206 = phi_2743_;
                                                                                    if (_e2197.y < _e2199.y) {
                                                                                        phi_2752_ = _e2197.y;
                                                                                    } else {
                                                                                        phi_2752_ = _e2199.y;
                                                                                    }
                                                                                    let _e2213 = phi_2752_;
                                                                                    if (_e2197.z < _e2199.z) {
                                                                                        phi_2761_ = _e2197.z;
                                                                                    } else {
                                                                                        phi_2761_ = _e2199.z;
                                                                                    }
                                                                                    let _e2220 = phi_2761_;
                                                                                    let _e2222 = triangles.member[(0u + _e1909)].v2_;
                                                                                    if (_e2206 < _e2222.x) {
                                                                                        phi_2770_ = _e2206;
                                                                                    } else {
                                                                                        phi_2770_ = _e2222.x;
                                                                                    }
                                                                                    let _e2227 = phi_2770_;
                                                                                    if (_e2213 < _e2222.y) {
                                                                                        phi_2777_ = _e2213;
                                                                                    } else {
                                                                                        phi_2777_ = _e2222.y;
                                                                                    }
                                                                                    let _e2232 = phi_2777_;
                                                                                    if (_e2220 < _e2222.z) {
                                                                                        phi_2784_ = _e2220;
                                                                                    } else {
                                                                                        phi_2784_ = _e2222.z;
                                                                                    }
                                                                                    let _e2237 = phi_2784_;
                                                                                    let _e2239 = triangles.member[(0u + _e1909)].v0_;
                                                                                    let _e2241 = triangles.member[(0u + _e1909)].v1_;
                                                                                    if (_e2239.x > _e2241.x) {
                                                                                        phi_2797_ = _e2239.x;
                                                                                    } else {
                                                                                        phi_2797_ = _e2241.x;
                                                                                    }
                                                                                    let _e2248 = phi_2797_;
                                                                                    if (_e2239.y > _e2241.y) {
                                                                                        phi_2806_ = _e2239.y;
                                                                                    } else {
                                                                                        phi_2806_ = _e2241.y;
                                                                                    }
                                                                                    let _e2255 = phi_2806_;
                                                                                    if (_e2239.z > _e2241.z) {
                                                                                        phi_2815_ = _e2239.z;
                                                                                    } else {
                                                                                        phi_2815_ = _e2241.z;
                                                                                    }
                                                                                    let _e2262 = phi_2815_;
                                                                                    let _e2264 = triangles.member[(0u + _e1909)].v2_;
                                                                                    if (_e2248 > _e2264.x) {
                                                                                        phi_2824_ = _e2248;
                                                                                    } else {
                                                                                        phi_2824_ = _e2264.x;
                                                                                    }
                                                                                    let _e2269 = phi_2824_;
                                                                                    if (_e2255 > _e2264.y) {
                                                                                        phi_2831_ = _e2255;
                                                                                    } else {
                                                                                        phi_2831_ = _e2264.y;
                                                                                    }
                                                                                    let _e2274 = phi_2831_;
                                                                                    if (_e2262 > _e2264.z) {
                                                                                        phi_2838_ = _e2262;
                                                                                    } else {
                                                                                        phi_2838_ = _e2264.z;
                                                                                    }
                                                                                    let _e2279 = phi_2838_;
                                                                                    let _e2283 = ((_e2227 - _e1015) * _e1224);
                                                                                    let _e2284 = ((_e2232 - _e1028) * _e1234);
                                                                                    let _e2285 = ((_e2237 - _e1041) * _e1244);
                                                                                    let _e2289 = ((_e2269 - _e1015) * _e1224);
                                                                                    let _e2290 = ((_e2274 - _e1028) * _e1234);
                                                                                    let _e2291 = ((_e2279 - _e1041) * _e1244);
                                                                                    if (_e2283 < _e2289) {
                                                                                        phi_2855_ = _e2283;
                                                                                    } else {
                                                                                        phi_2855_ = _e2289;
                                                                                    }
                                                                                    let _e2294 = phi_2855_;
                                                                                    if (_e2284 < _e2290) {
                                                                                        phi_2860_ = _e2284;
                                                                                    } else {
                                                                                        phi_2860_ = _e2290;
                                                                                    }
                                                                                    let _e2297 = phi_2860_;
                                                                                    if (_e2285 < _e2291) {
                                                                                        phi_2865_ = _e2285;
                                                                                    } else {
                                                                                        phi_2865_ = _e2291;
                                                                                    }
                                                                                    let _e2300 = phi_2865_;
                                                                                    if (_e2283 > _e2289) {
                                                                                        phi_2873_ = _e2283;
                                                                                    } else {
                                                                                        phi_2873_ = _e2289;
                                                                                    }
                                                                                    let _e2306 = phi_2873_;
                                                                                    if (_e2284 > _e2290) {
                                                                                        phi_2878_ = _e2284;
                                                                                    } else {
                                                                                        phi_2878_ = _e2290;
                                                                                    }
                                                                                    let _e2309 = phi_2878_;
                                                                                    if (_e2285 > _e2291) {
                                                                                        phi_2883_ = _e2285;
                                                                                    } else {
                                                                                        phi_2883_ = _e2291;
                                                                                    }
                                                                                    let _e2312 = phi_2883_;
                                                                                    let _e2316 = core_intrinsics_maximum_number_nsz_f32_((_e2294 - _e1279), (_e2297 - _e1280));
                                                                                    let _e2317 = core_intrinsics_maximum_number_nsz_f32_(_e2316, (_e2300 - _e1281));
                                                                                    let _e2318 = core_intrinsics_minimum_number_nsz_f32_((_e2306 + _e1279), (_e2309 + _e1280));
                                                                                    let _e2319 = core_intrinsics_minimum_number_nsz_f32_(_e2318, (_e2312 + _e1281));
                                                                                    if (_e2317 > _e996) {
                                                                                        phi_2895_ = _e2317;
                                                                                    } else {
                                                                                        phi_2895_ = _e996;
                                                                                    }
                                                                                    let _e2322 = phi_2895_;
                                                                                    if (_e2319 < _e998) {
                                                                                        phi_2900_ = _e2319;
                                                                                    } else {
                                                                                        phi_2900_ = _e998;
                                                                                    }
                                                                                    let _e2325 = phi_2900_;
                                                                                    if (_e2193 < _e2322) {
                                                                                        phi_2905_ = _e2322;
                                                                                    } else {
                                                                                        phi_2905_ = _e2193;
                                                                                    }
                                                                                    let _e2328 = phi_2905_;
                                                                                    if (_e2328 > _e2325) {
                                                                                        phi_2910_ = _e2325;
                                                                                    } else {
                                                                                        phi_2910_ = _e2328;
                                                                                    }
                                                                                    let _e2331 = phi_2910_;
                                                                                    phi_2915_ = lt_bvh_triangle_Intersection(_e2331, (_e2034 / _e2093), (_e2055 / _e2093), (_e2322 <= _e2325));
                                                                                    phi_2916_ = false;
                                                                                } else {
                                                                                    phi_2915_ = lt_bvh_triangle_Intersection();
                                                                                    phi_2916_ = true;
                                                                                }
                                                                                let _e2337 = phi_2915_;
                                                                                let _e2339 = phi_2916_;
                                                                                phi_2917_ = _e2337;
                                                                                phi_2918_ = _e2339;
                                                                            } else {
                                                                                phi_2917_ = lt_bvh_triangle_Intersection();
                                                                                phi_2918_ = true;
                                                                            }
                                                                            let _e2341 = phi_2917_;
                                                                            let _e2343 = phi_2918_;
                                                                            if _e2343 {
                                                                            }
                                                                            phi_2922_ = _e2341;
                                                                            phi_2923_ = _e2343;
                                                                        }
                                                                        let _e2345 = phi_2922_;
                                                                        let _e2347 = phi_2923_;
                                                                        phi_2924_ = _e2345;
                                                                        phi_2925_ = _e2096;
                                                                        phi_2926_ = _e2347;
                                                                    } else {
                                                                        phi_2924_ = lt_bvh_triangle_Intersection();
                                                                        phi_2925_ = true;
                                                                        phi_2926_ = false;
                                                                    }
                                                                    let _e2349 = phi_2924_;
                                                                    let _e2351 = phi_2925_;
                                                                    let _e2353 = phi_2926_;
                                                                    if _e2351 {
                                                                        phi_2930_ = true;
                                                                    } else {
                                                                        phi_2930_ = _e2353;
                                                                    }
                                                                    let _e2355 = phi_2930_;
                                                                    if _e2355 {
                                                                        phi_2934_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_2934_ = _e2349;
                                                                    }
                                                                    let _e2357 = phi_2934_;
                                                                    if _e2357.is_hit {
                                                                        if (_e2357.t > 0f) {
                                                                            if (_e2357.t < _e141) {
                                                                                let _e2364 = triangles.member[(0u + _e1909)].i0_;
                                                                                if ((_e2364 & 2147483648u) == 0u) {
                                                                                    phi_3153_ = true;
                                                                                } else {
                                                                                    if (_e1909 < _e79) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2373 = triangles.member[(0u + _e1909)].i0_;
                                                                                    let _e2374 = (_e2373 & 2147483647u);
                                                                                    let _e2376 = triangles.member[(0u + _e1909)].i1_;
                                                                                    let _e2378 = triangles.member[(0u + _e1909)].i2_;
                                                                                    if (_e2374 < _e91) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2382 = vertices.member[(0u + _e2374)];
                                                                                    if (_e2376 < _e91) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2386 = vertices.member[(0u + _e2376)];
                                                                                    if (_e2378 < _e91) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2390 = vertices.member[(0u + _e2378)];
                                                                                    let _e2391 = array<abi_Vertex, 3>(_e2382, _e2386, _e2390);
                                                                                    if (_e2391[0].material < arrayLength((&materials.member))) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2397 = materials.member[(0u + _e2391[0].material)];
                                                                                    if ((_e2397.flags & 1u) == 1u) {
                                                                                        let _e2402 = ((1f - _e2357.u) - _e2357.v);
                                                                                        if (_e2397.cutoff <= 0f) {
                                                                                            phi_3151_ = true;
                                                                                        } else {
                                                                                            let _e2429 = (_e2397.base_color.w * ((((f32((_e2391[0].color >> bitcast<u32>(24i))) * _e2402) + (f32((_e2391[1].color >> bitcast<u32>(24i))) * _e2357.u)) + (f32((_e2391[2].color >> bitcast<u32>(24i))) * _e2357.v)) * (1f / 255f)));
                                                                                            if (_e2397.alpha_size == 0u) {
                                                                                                phi_3148_ = _e2429;
                                                                                            } else {
                                                                                                local.offset = _e2397.alpha_offset;
                                                                                                local.size = _e2397.alpha_size;
                                                                                                local.flags = _e2397.flags;
                                                                                                let _e2460 = _lt_shaders_texture_TextureView_quad((&local), (((_e2391[0].u * _e2402) + (_e2391[1].u * _e2357.u)) + (_e2391[2].u * _e2357.v)), (((_e2391[0].v * _e2402) + (_e2391[1].v * _e2357.u)) + (_e2391[2].v * _e2357.v)));
                                                                                                let _e2464 = (_e2460.indices[0] >> bitcast<u32>(2i));
                                                                                                if (_e2464 < _e97) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2468 = alpha_texels.member[(0u + _e2464)];
                                                                                                let _e2484 = (_e2460.indices[1] >> bitcast<u32>(2i));
                                                                                                if (_e2484 < _e97) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2488 = alpha_texels.member[(0u + _e2484)];
                                                                                                let _e2505 = (_e2460.indices[2] >> bitcast<u32>(2i));
                                                                                                if (_e2505 < _e97) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2509 = alpha_texels.member[(0u + _e2505)];
                                                                                                let _e2526 = (_e2460.indices[3] >> bitcast<u32>(2i));
                                                                                                if (_e2526 < _e97) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2530 = alpha_texels.member[(0u + _e2526)];
                                                                                                phi_3148_ = (_e2429 * (((((f32(((_e2468 >> bitcast<u32>((((_e2460.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2460.weights.x) + ((f32(((_e2488 >> bitcast<u32>((((_e2460.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2460.weights.y)) + ((f32(((_e2509 >> bitcast<u32>((((_e2460.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2460.weights.z)) + ((f32(((_e2530 >> bitcast<u32>((((_e2460.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2460.weights.w)));
                                                                                            }
                                                                                            let _e2546 = phi_3148_;
                                                                                            phi_3151_ = (_e2546 >= _e2397.cutoff);
                                                                                        }
                                                                                        let _e2550 = phi_3151_;
                                                                                        phi_3152_ = _e2550;
                                                                                    } else {
                                                                                        phi_3152_ = false;
                                                                                    }
                                                                                    let _e2552 = phi_3152_;
                                                                                    phi_3153_ = _e2552;
                                                                                }
                                                                                let _e2554 = phi_3153_;
                                                                                if _e2554 {
                                                                                    phi_3157_ = false;
                                                                                } else {
                                                                                    phi_3157_ = true;
                                                                                }
                                                                                let _e2556 = phi_3157_;
                                                                                phi_3158_ = _e2554;
                                                                                phi_3159_ = _e2554;
                                                                                phi_3160_ = _e2556;
                                                                            } else {
                                                                                phi_3158_ = bool();
                                                                                phi_3159_ = _e1900;
                                                                                phi_3160_ = true;
                                                                            }
                                                                            let _e2558 = phi_3158_;
                                                                            let _e2560 = phi_3159_;
                                                                            let _e2562 = phi_3160_;
                                                                            phi_3161_ = _e2558;
                                                                            phi_3162_ = _e2560;
                                                                            phi_3163_ = _e2562;
                                                                        } else {
                                                                            phi_3161_ = bool();
                                                                            phi_3162_ = _e1900;
                                                                            phi_3163_ = true;
                                                                        }
                                                                        let _e2564 = phi_3161_;
                                                                        let _e2566 = phi_3162_;
                                                                        let _e2568 = phi_3163_;
                                                                        phi_3164_ = _e2564;
                                                                        phi_3165_ = _e2566;
                                                                        phi_3166_ = _e2568;
                                                                    } else {
                                                                        phi_3164_ = bool();
                                                                        phi_3165_ = _e1900;
                                                                        phi_3166_ = true;
                                                                    }
                                                                    let _e2570 = phi_3164_;
                                                                    let _e2572 = phi_3165_;
                                                                    let _e2574 = phi_3166_;
                                                                    if _e2574 {
                                                                    }
                                                                    phi_2364_ = (_e1898 & (_e1898 - 1u));
                                                                    phi_2367_ = _e2572;
                                                                    phi_3170_ = _e2570;
                                                                    phi_3171_ = _e2574;
                                                                }
                                                                let _e2576 = phi_2364_;
                                                                let _e2578 = phi_2367_;
                                                                let _e2580 = phi_3170_;
                                                                let _e2582 = phi_3171_;
                                                                local_14 = _e2580;
                                                                continue;
                                                                continuing {
                                                                    phi_2363_ = _e2576;
                                                                    phi_2366_ = _e2578;
                                                                    break if !(_e2582);
                                                                }
                                                            }
                                                            let _e2585 = local_9;
                                                            if _e2585 {
                                                                let _e2587 = local_1.group_mask;
                                                                if ((_e2587 & 4278190080u) == 0u) {
                                                                    let _e2591 = local_1.len;
                                                                    if (_e2591 == 0u) {
                                                                        phi_3213_ = false;
                                                                    } else {
                                                                        let _e2595 = local_1.len;
                                                                        local_1.len = (_e2595 - 1u);
                                                                        let _e2598 = local_1.len;
                                                                        if (_e2598 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2603 = local_1.first[(0u + _e2598)];
                                                                        local_1.group = _e2603;
                                                                        let _e2606 = local_1.len;
                                                                        if (_e2606 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2611 = local_1.mask[(0u + _e2606)];
                                                                        local_1.group_mask = _e2611;
                                                                        phi_3213_ = true;
                                                                    }
                                                                    let _e2614 = phi_3213_;
                                                                    phi_3214_ = _e2614;
                                                                } else {
                                                                    phi_3214_ = true;
                                                                }
                                                                let _e2616 = phi_3214_;
                                                                if _e2616 {
                                                                    let _e2618 = local_1.group_mask;
                                                                    let _e2624 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2618)), 32u, (_e2618 == 0u)));
                                                                    let _e2628 = local_1.group_mask;
                                                                    let _e2642 = local_1.group_mask;
                                                                    local_1.group_mask = (_e2642 & ~((1u << bitcast<u32>((_e2624 & 31u)))));
                                                                    let _e2645 = local_1.group;
                                                                    phi_3245_ = (_e2645 + countOneBits(((_e2628 & ~((4294967295u << bitcast<u32>((((_e2624 - 24u) ^ _e1322) & 31u))))) & 255u)));
                                                                } else {
                                                                    phi_3245_ = 4294967295u;
                                                                }
                                                                let _e2648 = phi_3245_;
                                                                phi_3246_ = _e2648;
                                                            } else {
                                                                phi_3246_ = u32();
                                                            }
                                                            let _e2650 = phi_3246_;
                                                            phi_2032_ = _e2650;
                                                            let _e3040 = local_13;
                                                            phi_2035_ = _e3040;
                                                            let _e3043 = local_14;
                                                            phi_3247_ = _e3043;
                                                            let _e3046 = local_15;
                                                            phi_3248_ = _e3046;
                                                            phi_3249_ = false;
                                                        } else {
                                                            phi_2032_ = u32();
                                                            phi_2035_ = bool();
                                                            phi_3247_ = bool();
                                                            phi_3248_ = false;
                                                            phi_3249_ = true;
                                                        }
                                                        let _e2652 = phi_2032_;
                                                        let _e2654 = phi_2035_;
                                                        let _e2656 = phi_3247_;
                                                        let _e2658 = phi_3248_;
                                                        let _e2660 = phi_3249_;
                                                        local_10 = _e2660;
                                                        local_16 = _e2656;
                                                        continue;
                                                        continuing {
                                                            phi_2031_ = _e2652;
                                                            phi_2034_ = _e2654;
                                                            break if !(_e2658);
                                                        }
                                                    }
                                                    let _e2663 = local_10;
                                                    if _e2663 {
                                                        phi_3253_ = false;
                                                    } else {
                                                        phi_3253_ = true;
                                                    }
                                                    let _e2665 = phi_3253_;
                                                    if _e2665 {
                                                        let _e3052 = local_16;
                                                        phi_3257_ = _e3052;
                                                    } else {
                                                        let _e3054 = local_17;
                                                        phi_3257_ = _e3054;
                                                    }
                                                    let _e2667 = phi_3257_;
                                                    phi_3258_ = _e2667;
                                                }
                                                let _e2669 = phi_3258_;
                                                phi_3259_ = _e2669;
                                                phi_3260_ = _e1148;
                                            } else {
                                                phi_3259_ = bool();
                                                phi_3260_ = true;
                                            }
                                            let _e2671 = phi_3259_;
                                            let _e2673 = phi_3260_;
                                            if _e2673 {
                                                phi_3264_ = _e935;
                                            } else {
                                                phi_3264_ = _e2671;
                                            }
                                            let _e2675 = phi_3264_;
                                            if _e2675 {
                                                phi_3268_ = false;
                                            } else {
                                                phi_3268_ = true;
                                            }
                                            let _e2677 = phi_3268_;
                                            phi_3269_ = _e2675;
                                            phi_3270_ = _e2677;
                                        } else {
                                            phi_3269_ = _e935;
                                            phi_3270_ = true;
                                        }
                                        let _e2679 = phi_3269_;
                                        let _e2681 = phi_3270_;
                                        phi_3271_ = _e2679;
                                        phi_3272_ = _e2681;
                                    } else {
                                        phi_3271_ = _e935;
                                        phi_3272_ = true;
                                    }
                                    let _e2683 = phi_3271_;
                                    let _e2685 = phi_3272_;
                                    phi_3273_ = _e2683;
                                    phi_3274_ = _e2685;
                                } else {
                                    phi_3273_ = _e935;
                                    phi_3274_ = true;
                                }
                                let _e2687 = phi_3273_;
                                let _e2689 = phi_3274_;
                                if _e2689 {
                                }
                                phi_1424_ = (_e933 & (_e933 - 1u));
                                phi_1427_ = _e2687;
                                phi_3278_ = _e2689;
                            }
                            let _e2691 = phi_1424_;
                            let _e2693 = phi_1427_;
                            let _e2695 = phi_3278_;
                            continue;
                            continuing {
                                phi_1423_ = _e2691;
                                phi_1426_ = _e2693;
                                break if !(_e2695);
                            }
                        }
                        let _e2698 = local_11;
                        if _e2698 {
                            let _e2700 = local_2.group_mask;
                            if ((_e2700 & 4278190080u) == 0u) {
                                let _e2704 = local_2.len;
                                if (_e2704 == 0u) {
                                    phi_3320_ = false;
                                } else {
                                    let _e2708 = local_2.len;
                                    local_2.len = (_e2708 - 1u);
                                    let _e2711 = local_2.len;
                                    if (_e2711 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2716 = local_2.first[(0u + _e2711)];
                                    local_2.group = _e2716;
                                    let _e2719 = local_2.len;
                                    if (_e2719 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2724 = local_2.mask[(0u + _e2719)];
                                    local_2.group_mask = _e2724;
                                    phi_3320_ = true;
                                }
                                let _e2727 = phi_3320_;
                                phi_3321_ = _e2727;
                            } else {
                                phi_3321_ = true;
                            }
                            let _e2729 = phi_3321_;
                            if _e2729 {
                                let _e2731 = local_2.group_mask;
                                let _e2737 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2731)), 32u, (_e2731 == 0u)));
                                let _e2741 = local_2.group_mask;
                                let _e2755 = local_2.group_mask;
                                local_2.group_mask = (_e2755 & ~((1u << bitcast<u32>((_e2737 & 31u)))));
                                let _e2758 = local_2.group;
                                phi_3352_ = (_e2758 + countOneBits(((_e2741 & ~((4294967295u << bitcast<u32>((((_e2737 - 24u) ^ _e357) & 31u))))) & 255u)));
                            } else {
                                phi_3352_ = 4294967295u;
                            }
                            let _e2761 = phi_3352_;
                            phi_3353_ = _e2761;
                        } else {
                            phi_3353_ = u32();
                        }
                        let _e2763 = phi_3353_;
                        phi_1092_ = _e2763;
                        let _e3077 = local_18;
                        phi_1095_ = _e3077;
                        let _e3080 = local_19;
                        phi_3354_ = _e3080;
                        phi_3355_ = false;
                    } else {
                        phi_1092_ = u32();
                        phi_1095_ = bool();
                        phi_3354_ = false;
                        phi_3355_ = true;
                    }
                    let _e2765 = phi_1092_;
                    let _e2767 = phi_1095_;
                    let _e2769 = phi_3354_;
                    let _e2771 = phi_3355_;
                    local_12 = _e2771;
                    continue;
                    continuing {
                        phi_1091_ = _e2765;
                        phi_1094_ = _e2767;
                        break if !(_e2769);
                    }
                }
                let _e2774 = local_12;
                if _e2774 {
                    phi_3359_ = false;
                } else {
                    phi_3359_ = true;
                }
                let _e2776 = phi_3359_;
                if _e2776 {
                }
                phi_3363_ = _e2776;
            }
            let _e2778 = phi_3363_;
            phi_3364_ = _e213;
            phi_3365_ = _e2778;
        } else {
            phi_3364_ = true;
            phi_3365_ = false;
        }
        let _e2780 = phi_3364_;
        let _e2782 = phi_3365_;
        if _e2780 {
            phi_3369_ = false;
            phi_3370_ = true;
        } else {
            phi_3369_ = true;
            phi_3370_ = _e2782;
        }
        let _e2784 = phi_3369_;
        let _e2786 = phi_3370_;
        if _e2786 {
            phi_3374_ = _e2784;
        } else {
            phi_3374_ = false;
        }
        let _e2788 = phi_3374_;
        if _e2788 {
            phi_3378_ = 0f;
        } else {
            phi_3378_ = 1f;
        }
        let _e2790 = phi_3378_;
        if (_e110 < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e110)] = _e2790;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_list_instanced_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
