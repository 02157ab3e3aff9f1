struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    number: u32,
    mask_words: u32,
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

struct type_17 {
    member: array<f32>,
}

struct lt_mask_LightPlace {
    word: u32,
    shift: u32,
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

struct type_33 {
    member: abi_ShadowParams,
}

struct lt_bvh_Node {
    frame: vec4<u32>,
    links: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    z: vec4<u32>,
}

struct type_38 {
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

struct type_42 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_46 {
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

struct type_50 {
    member: array<abi_Material>,
}

struct u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_ {
    unnamed: lt_mask_LightPlace,
    unnamed_1: lt_mask_LightPlace,
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

struct type_64 {
    member: array<lt_bvh_Instance>,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_17;
@group(0) @binding(0) 
var<uniform> p: type_33;
@group(0) @binding(2) 
var<storage> nodes: type_38;
@group(0) @binding(3) 
var<storage> triangles: type_42;
@group(0) @binding(5) 
var<storage> list: type_13;
@group(0) @binding(6) 
var<storage, read_write> bits: type_13;
@group(0) @binding(7) 
var<storage> instances: type_64;
@group(0) @binding(8) 
var<storage> vertices: type_46;
@group(0) @binding(9) 
var<storage> materials: type_50;
@group(0) @binding(10) 
var<storage> alpha_texels: type_13;

fn core_intrinsics_maximum_number_nsz_f32_(param: f32, param_1: f32) -> f32 {
    var phi_214_: bool;
    var phi_218_: f32;

    if (param != param) {
        phi_214_ = true;
    } else {
        let _e71 = (param_1 >= param);
        if _e71 {
        }
        phi_214_ = _e71;
    }
    let _e73 = phi_214_;
    if _e73 {
        phi_218_ = param_1;
    } else {
        phi_218_ = param;
    }
    let _e75 = phi_218_;
    return _e75;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_2: f32, param_3: f32) -> f32 {
    var phi_230_: bool;
    var phi_234_: f32;

    if (param_2 != param_2) {
        phi_230_ = true;
    } else {
        let _e71 = (param_3 <= param_2);
        if _e71 {
        }
        phi_230_ = _e71;
    }
    let _e73 = phi_230_;
    if _e73 {
        phi_234_ = param_3;
    } else {
        phi_234_ = param_2;
    }
    let _e75 = phi_234_;
    return _e75;
}

fn _lt_shaders_texture_TextureView_quad(param_4: ptr<function, texture_TextureView>, param_5: f32, param_6: f32) -> texture_TexelQuad {
    var phi_276_: f32;
    var phi_281_: f32;
    var phi_282_: bool;
    var phi_283_: f32;
    var phi_284_: bool;
    var phi_288_: f32;
    var phi_314_: f32;
    var phi_319_: f32;
    var phi_320_: bool;
    var phi_321_: f32;
    var phi_322_: bool;
    var phi_326_: f32;
    var phi_334_: f32;
    var phi_335_: f32;
    var phi_336_: f32;
    var phi_345_: f32;
    var phi_346_: f32;
    var phi_364_: u32;
    var phi_378_: u32;
    var phi_385_: u32;
    var phi_390_: u32;
    var phi_396_: u32;
    var phi_401_: u32;
    var phi_403_: texture_Axis;
    var phi_431_: f32;
    var phi_436_: f32;
    var phi_437_: bool;
    var phi_438_: f32;
    var phi_439_: bool;
    var phi_443_: f32;
    var phi_469_: f32;
    var phi_474_: f32;
    var phi_475_: bool;
    var phi_476_: f32;
    var phi_477_: bool;
    var phi_481_: f32;
    var phi_489_: f32;
    var phi_490_: f32;
    var phi_491_: f32;
    var phi_500_: f32;
    var phi_501_: f32;
    var phi_519_: u32;
    var phi_533_: u32;
    var phi_540_: u32;
    var phi_545_: u32;
    var phi_551_: u32;
    var phi_556_: u32;
    var phi_558_: texture_Axis;

    let _e72 = (*param_4).size;
    let _e73 = (_e72 & 65535u);
    let _e75 = (*param_4).size;
    let _e77 = (_e75 >> bitcast<u32>(16i));
    let _e79 = (*param_4).flags;
    let _e81 = ((_e79 & 4u) != 0u);
    let _e83 = (*param_4).flags;
    let _e86 = ((_e83 >> bitcast<u32>(4u)) & 3u);
    if (_e86 == 0u) {
        if (param_5 > -8388608f) {
            let _e99 = f32(select(0i, select(select(i32(param_5), i32(-2147483648), (param_5 < bitcast<f32>(3472883712u))), 2147483647i, (param_5 > bitcast<f32>(1325400063u))), (param_5 == param_5)));
            if (_e99 > param_5) {
                phi_276_ = 1f;
            } else {
                phi_276_ = 0f;
            }
            let _e102 = phi_276_;
            if (param_5 < 8388608f) {
                phi_281_ = (_e99 - _e102);
                phi_282_ = false;
            } else {
                phi_281_ = f32();
                phi_282_ = true;
            }
            let _e105 = phi_281_;
            let _e107 = phi_282_;
            phi_283_ = _e105;
            phi_284_ = _e107;
        } else {
            phi_283_ = f32();
            phi_284_ = true;
        }
        let _e109 = phi_283_;
        let _e111 = phi_284_;
        if _e111 {
            phi_288_ = param_5;
        } else {
            phi_288_ = _e109;
        }
        let _e113 = phi_288_;
        phi_336_ = (param_5 - _e113);
    } else {
        if (_e86 == 1u) {
            let _e116 = (param_5 * 0.5f);
            if (_e116 > -8388608f) {
                let _e128 = f32(select(0i, select(select(i32(_e116), i32(-2147483648), (_e116 < bitcast<f32>(3472883712u))), 2147483647i, (_e116 > bitcast<f32>(1325400063u))), (_e116 == _e116)));
                if (_e128 > _e116) {
                    phi_314_ = 1f;
                } else {
                    phi_314_ = 0f;
                }
                let _e131 = phi_314_;
                if (_e116 < 8388608f) {
                    phi_319_ = (_e128 - _e131);
                    phi_320_ = false;
                } else {
                    phi_319_ = f32();
                    phi_320_ = true;
                }
                let _e134 = phi_319_;
                let _e136 = phi_320_;
                phi_321_ = _e134;
                phi_322_ = _e136;
            } else {
                phi_321_ = f32();
                phi_322_ = true;
            }
            let _e138 = phi_321_;
            let _e140 = phi_322_;
            if _e140 {
                phi_326_ = _e116;
            } else {
                phi_326_ = _e138;
            }
            let _e142 = phi_326_;
            let _e144 = (param_5 - (2f * _e142));
            if (_e144 > 1f) {
                phi_334_ = (2f - _e144);
            } else {
                phi_334_ = _e144;
            }
            let _e148 = phi_334_;
            phi_335_ = _e148;
        } else {
            phi_335_ = param_5;
        }
        let _e150 = phi_335_;
        phi_336_ = _e150;
    }
    let _e152 = phi_336_;
    if (_e152 > 0f) {
        if (_e152 < 1f) {
            phi_345_ = _e152;
        } else {
            phi_345_ = 1f;
        }
        let _e156 = phi_345_;
        phi_346_ = _e156;
    } else {
        phi_346_ = 0f;
    }
    let _e158 = phi_346_;
    let _e159 = (_e73 - 1u);
    let _e161 = (_e158 * f32(_e73));
    if _e81 {
        let _e168 = select(select(u32(_e161), 0u, (_e161 < bitcast<f32>(0u))), 4294967295u, (_e161 > bitcast<f32>(1333788671u)));
        if (_e159 < _e168) {
            phi_364_ = _e159;
        } else {
            phi_364_ = _e168;
        }
        let _e171 = phi_364_;
        phi_403_ = texture_Axis(_e171, _e171, 0f);
    } else {
        let _e173 = (_e161 + 0.5f);
        let _e180 = select(select(u32(_e173), 0u, (_e173 < bitcast<f32>(0u))), 4294967295u, (_e173 > bitcast<f32>(1333788671u)));
        if (_e73 < _e180) {
            phi_378_ = _e73;
        } else {
            phi_378_ = _e180;
        }
        let _e183 = phi_378_;
        if (_e86 == 0u) {
            phi_385_ = _e159;
        } else {
            phi_385_ = 0u;
        }
        let _e188 = phi_385_;
        if (_e86 == 0u) {
            phi_390_ = 0u;
        } else {
            phi_390_ = _e159;
        }
        let _e191 = phi_390_;
        if (_e183 == 0u) {
            phi_396_ = _e188;
        } else {
            phi_396_ = (_e183 - 1u);
        }
        let _e195 = phi_396_;
        if (_e183 > _e159) {
            phi_401_ = _e191;
        } else {
            phi_401_ = _e183;
        }
        let _e198 = phi_401_;
        phi_403_ = texture_Axis(_e195, _e198, (_e173 - f32(_e183)));
    }
    let _e201 = phi_403_;
    let _e203 = (*param_4).flags;
    let _e206 = ((_e203 >> bitcast<u32>(6u)) & 3u);
    if (_e206 == 0u) {
        if (param_6 > -8388608f) {
            let _e219 = f32(select(0i, select(select(i32(param_6), i32(-2147483648), (param_6 < bitcast<f32>(3472883712u))), 2147483647i, (param_6 > bitcast<f32>(1325400063u))), (param_6 == param_6)));
            if (_e219 > param_6) {
                phi_431_ = 1f;
            } else {
                phi_431_ = 0f;
            }
            let _e222 = phi_431_;
            if (param_6 < 8388608f) {
                phi_436_ = (_e219 - _e222);
                phi_437_ = false;
            } else {
                phi_436_ = f32();
                phi_437_ = true;
            }
            let _e225 = phi_436_;
            let _e227 = phi_437_;
            phi_438_ = _e225;
            phi_439_ = _e227;
        } else {
            phi_438_ = f32();
            phi_439_ = true;
        }
        let _e229 = phi_438_;
        let _e231 = phi_439_;
        if _e231 {
            phi_443_ = param_6;
        } else {
            phi_443_ = _e229;
        }
        let _e233 = phi_443_;
        phi_491_ = (param_6 - _e233);
    } else {
        if (_e206 == 1u) {
            let _e236 = (param_6 * 0.5f);
            if (_e236 > -8388608f) {
                let _e248 = f32(select(0i, select(select(i32(_e236), i32(-2147483648), (_e236 < bitcast<f32>(3472883712u))), 2147483647i, (_e236 > bitcast<f32>(1325400063u))), (_e236 == _e236)));
                if (_e248 > _e236) {
                    phi_469_ = 1f;
                } else {
                    phi_469_ = 0f;
                }
                let _e251 = phi_469_;
                if (_e236 < 8388608f) {
                    phi_474_ = (_e248 - _e251);
                    phi_475_ = false;
                } else {
                    phi_474_ = f32();
                    phi_475_ = true;
                }
                let _e254 = phi_474_;
                let _e256 = phi_475_;
                phi_476_ = _e254;
                phi_477_ = _e256;
            } else {
                phi_476_ = f32();
                phi_477_ = true;
            }
            let _e258 = phi_476_;
            let _e260 = phi_477_;
            if _e260 {
                phi_481_ = _e236;
            } else {
                phi_481_ = _e258;
            }
            let _e262 = phi_481_;
            let _e264 = (param_6 - (2f * _e262));
            if (_e264 > 1f) {
                phi_489_ = (2f - _e264);
            } else {
                phi_489_ = _e264;
            }
            let _e268 = phi_489_;
            phi_490_ = _e268;
        } else {
            phi_490_ = param_6;
        }
        let _e270 = phi_490_;
        phi_491_ = _e270;
    }
    let _e272 = phi_491_;
    if (_e272 > 0f) {
        if (_e272 < 1f) {
            phi_500_ = _e272;
        } else {
            phi_500_ = 1f;
        }
        let _e276 = phi_500_;
        phi_501_ = _e276;
    } else {
        phi_501_ = 0f;
    }
    let _e278 = phi_501_;
    let _e279 = (_e77 - 1u);
    let _e281 = (_e278 * f32(_e77));
    if _e81 {
        let _e288 = select(select(u32(_e281), 0u, (_e281 < bitcast<f32>(0u))), 4294967295u, (_e281 > bitcast<f32>(1333788671u)));
        if (_e279 < _e288) {
            phi_519_ = _e279;
        } else {
            phi_519_ = _e288;
        }
        let _e291 = phi_519_;
        phi_558_ = texture_Axis(_e291, _e291, 0f);
    } else {
        let _e293 = (_e281 + 0.5f);
        let _e300 = select(select(u32(_e293), 0u, (_e293 < bitcast<f32>(0u))), 4294967295u, (_e293 > bitcast<f32>(1333788671u)));
        if (_e77 < _e300) {
            phi_533_ = _e77;
        } else {
            phi_533_ = _e300;
        }
        let _e303 = phi_533_;
        if (_e206 == 0u) {
            phi_540_ = _e279;
        } else {
            phi_540_ = 0u;
        }
        let _e308 = phi_540_;
        if (_e206 == 0u) {
            phi_545_ = 0u;
        } else {
            phi_545_ = _e279;
        }
        let _e311 = phi_545_;
        if (_e303 == 0u) {
            phi_551_ = _e308;
        } else {
            phi_551_ = (_e303 - 1u);
        }
        let _e315 = phi_551_;
        if (_e303 > _e279) {
            phi_556_ = _e311;
        } else {
            phi_556_ = _e303;
        }
        let _e318 = phi_556_;
        phi_558_ = texture_Axis(_e315, _e318, (_e293 - f32(_e303)));
    }
    let _e321 = phi_558_;
    let _e325 = (*param_4).offset;
    let _e332 = (*param_4).offset;
    let _e339 = (*param_4).offset;
    let _e346 = (*param_4).offset;
    return texture_TexelQuad(array<u32, 4>(((_e325 + (_e321.low * _e73)) + _e201.low), ((_e332 + (_e321.low * _e73)) + _e201.high), ((_e339 + (_e321.high * _e73)) + _e201.low), ((_e346 + (_e321.high * _e73)) + _e201.high)), vec4<f32>(((1f - _e201.fraction) * (1f - _e321.fraction)), (_e201.fraction * (1f - _e321.fraction)), ((1f - _e201.fraction) * _e321.fraction), (_e201.fraction * _e321.fraction)));
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var local_2: lt_bvh_traverse_Stack;
    var phi_706_: f32;
    var phi_762_: bool;
    var phi_763_: bool;
    var phi_764_: bool;
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
    var phi_778_: bool;
    var phi_779_: bool;
    var phi_780_: bool;
    var phi_781_: bool;
    var phi_782_: bool;
    var phi_783_: bool;
    var phi_784_: bool;
    var phi_785_: bool;
    var phi_789_: bool;
    var phi_793_: bool;
    var phi_863_: f32;
    var phi_870_: f32;
    var phi_877_: f32;
    var phi_884_: f32;
    var phi_891_: f32;
    var phi_898_: f32;
    var phi_915_: f32;
    var phi_920_: f32;
    var phi_925_: f32;
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
    var phi_1660_: bool;
    var phi_1661_: bool;
    var phi_1662_: bool;
    var phi_1666_: bool;
    var phi_1667_: bool;
    var phi_1668_: bool;
    var phi_1669_: bool;
    var phi_1670_: bool;
    var phi_1671_: bool;
    var phi_1672_: bool;
    var phi_1673_: bool;
    var phi_1674_: bool;
    var phi_1675_: bool;
    var phi_1676_: bool;
    var phi_1677_: bool;
    var phi_1678_: bool;
    var phi_1679_: bool;
    var phi_1680_: bool;
    var phi_1681_: bool;
    var phi_1682_: bool;
    var phi_1683_: bool;
    var phi_1687_: bool;
    var phi_1691_: bool;
    var phi_1761_: f32;
    var phi_1768_: f32;
    var phi_1775_: f32;
    var phi_1782_: f32;
    var phi_1789_: f32;
    var phi_1796_: f32;
    var phi_1813_: f32;
    var phi_1818_: f32;
    var phi_1823_: f32;
    var phi_1851_: bool;
    var phi_1852_: bool;
    var phi_1860_: u32;
    var phi_1861_: u32;
    var phi_1872_: vec3<f32>;
    var phi_1873_: vec3<f32>;
    var phi_1886_: u32;
    var phi_1891_: u32;
    var phi_1896_: u32;
    var phi_2010_: bool;
    var phi_2011_: bool;
    var phi_2042_: u32;
    var phi_2044_: u32;
    var phi_2047_: bool;
    var phi_2127_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2154_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2181_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2187_: u32;
    var phi_2190_: u32;
    var phi_2204_: u32;
    var phi_2214_: u32;
    var phi_2224_: u32;
    var phi_2242_: u32;
    var phi_2252_: u32;
    var phi_2262_: u32;
    var phi_2298_: u32;
    var phi_2311_: u32;
    var phi_2316_: u32;
    var phi_2317_: u32;
    var phi_2318_: u32;
    var phi_2188_: u32;
    var phi_2191_: u32;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_2376_: u32;
    var phi_2379_: bool;
    var phi_2423_: vec3<f32>;
    var phi_2424_: vec3<f32>;
    var phi_2453_: vec3<f32>;
    var phi_2454_: vec3<f32>;
    var phi_2483_: vec3<f32>;
    var phi_2484_: vec3<f32>;
    var phi_2502_: bool;
    var phi_2503_: bool;
    var phi_2507_: f32;
    var phi_2508_: f32;
    var phi_2509_: f32;
    var phi_2510_: f32;
    var phi_2518_: f32;
    var phi_2528_: bool;
    var phi_2529_: bool;
    var phi_2533_: f32;
    var phi_2534_: f32;
    var phi_2535_: f32;
    var phi_2536_: f32;
    var phi_2544_: f32;
    var phi_2554_: bool;
    var phi_2555_: bool;
    var phi_2559_: f32;
    var phi_2560_: f32;
    var phi_2561_: f32;
    var phi_2562_: f32;
    var phi_2570_: f32;
    var phi_2585_: f32;
    var phi_2586_: bool;
    var phi_2587_: f32;
    var phi_2588_: bool;
    var phi_2589_: f32;
    var phi_2590_: bool;
    var phi_2608_: f32;
    var phi_2609_: bool;
    var phi_2610_: bool;
    var phi_2611_: f32;
    var phi_2612_: bool;
    var phi_2613_: bool;
    var phi_2617_: bool;
    var phi_2618_: f32;
    var phi_2619_: bool;
    var phi_2647_: vec3<f32>;
    var phi_2648_: vec3<f32>;
    var phi_2673_: vec3<f32>;
    var phi_2674_: vec3<f32>;
    var phi_2699_: vec3<f32>;
    var phi_2700_: vec3<f32>;
    var phi_2756_: f32;
    var phi_2765_: f32;
    var phi_2774_: f32;
    var phi_2783_: f32;
    var phi_2790_: f32;
    var phi_2797_: f32;
    var phi_2810_: f32;
    var phi_2819_: f32;
    var phi_2828_: f32;
    var phi_2837_: f32;
    var phi_2844_: f32;
    var phi_2851_: f32;
    var phi_2868_: f32;
    var phi_2873_: f32;
    var phi_2878_: f32;
    var phi_2886_: f32;
    var phi_2891_: f32;
    var phi_2896_: f32;
    var phi_2908_: f32;
    var phi_2913_: f32;
    var phi_2918_: f32;
    var phi_2923_: f32;
    var phi_2928_: lt_bvh_triangle_Intersection;
    var phi_2929_: bool;
    var phi_2930_: lt_bvh_triangle_Intersection;
    var phi_2931_: bool;
    var phi_2935_: lt_bvh_triangle_Intersection;
    var phi_2936_: bool;
    var phi_2937_: lt_bvh_triangle_Intersection;
    var phi_2938_: bool;
    var phi_2939_: bool;
    var phi_2943_: bool;
    var phi_2947_: lt_bvh_triangle_Intersection;
    var phi_3161_: f32;
    var phi_3164_: bool;
    var phi_3165_: bool;
    var phi_3166_: bool;
    var phi_3170_: bool;
    var phi_3171_: bool;
    var phi_3172_: bool;
    var phi_3173_: bool;
    var phi_3174_: bool;
    var phi_3175_: bool;
    var phi_3176_: bool;
    var phi_3177_: bool;
    var phi_3178_: bool;
    var phi_3179_: bool;
    var phi_2377_: u32;
    var phi_2380_: bool;
    var phi_3183_: bool;
    var phi_3184_: bool;
    var local_9: bool;
    var phi_3226_: bool;
    var phi_3227_: bool;
    var phi_3258_: u32;
    var phi_3259_: u32;
    var phi_2045_: u32;
    var phi_2048_: bool;
    var phi_3260_: bool;
    var phi_3261_: bool;
    var phi_3262_: bool;
    var local_10: bool;
    var phi_3266_: bool;
    var phi_3270_: bool;
    var phi_3271_: bool;
    var phi_3272_: bool;
    var phi_3273_: bool;
    var phi_3277_: bool;
    var phi_3281_: bool;
    var phi_3282_: bool;
    var phi_3283_: bool;
    var phi_3284_: bool;
    var phi_3285_: bool;
    var phi_3286_: bool;
    var phi_3287_: bool;
    var phi_1437_: u32;
    var phi_1440_: bool;
    var phi_3291_: bool;
    var local_11: bool;
    var phi_3333_: bool;
    var phi_3334_: bool;
    var phi_3365_: u32;
    var phi_3366_: u32;
    var phi_1105_: u32;
    var phi_1108_: bool;
    var phi_3367_: bool;
    var phi_3368_: bool;
    var local_12: bool;
    var phi_3372_: bool;
    var phi_3376_: bool;
    var phi_3377_: bool;
    var phi_3378_: bool;
    var phi_3382_: bool;
    var phi_3383_: bool;
    var phi_3387_: bool;
    var phi_3391_: f32;
    var phi_3432_: u32;
    var phi_3451_: u32;
    var phi_3459_: u32;
    var phi_3467_: u32;
    var phi_3472_: u32;
    var local_13: bool;
    var local_14: bool;
    var local_15: bool;
    var local_16: bool;
    var local_17: bool;
    var local_18: bool;
    var local_19: bool;

    let _e71 = id_1;
    let _e78 = arrayLength((&nodes.member));
    let _e81 = arrayLength((&triangles.member));
    let _e84 = arrayLength((&visibility.member));
    let _e87 = arrayLength((&list.member));
    let _e90 = arrayLength((&bits.member));
    let _e96 = arrayLength((&vertices.member));
    let _e102 = arrayLength((&alpha_texels.member));
    let _e106 = ((_e71.y * 2097152u) + _e71.x);
    if (3u < _e87) {
    } else {
        return;
    }
    let _e109 = list.member[3u];
    if (_e106 < _e109) {
        let _e111 = (_e106 + 4u);
        if (_e111 < _e87) {
        } else {
            return;
        }
        let _e115 = list.member[(0u + _e111)];
        let _e117 = p.member.root;
        if (_e115 < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e123 = samples.member[(0u + _e115)].position;
        let _e125 = samples.member[(0u + _e115)].normal;
        let _e127 = samples.member[(0u + _e115)].magnitude;
        let _e129 = ((8f / 8388608f) * _e127);
        let _e137 = (_e123.x + (_e125.x * _e129));
        let _e139 = (_e123.y + (_e125.y * _e129));
        let _e141 = (_e123.z + (_e125.z * _e129));
        let _e143 = p.member.light.place;
        if (_e143.w == 0f) {
            phi_706_ = 300000000000000000000000000000000000000f;
        } else {
            phi_706_ = 1f;
        }
        let _e147 = phi_706_;
        let _e155 = (_e143.x - (_e137 * _e143.w));
        let _e156 = (_e143.y - (_e139 * _e143.w));
        let _e157 = (_e143.z - (_e141 * _e143.w));
        let _e161 = abs(_e155);
        let _e162 = abs(_e156);
        let _e163 = abs(_e157);
        if (abs(_e137) < 1000000000000000f) {
            if (abs(_e139) < 1000000000000000f) {
                if (abs(_e141) < 1000000000000000f) {
                    if (_e161 < 1000000000000000f) {
                        if (_e162 < 1000000000000000f) {
                            if (_e163 < 1000000000000000f) {
                                if (_e161 > 0f) {
                                    phi_763_ = bool();
                                    phi_764_ = true;
                                } else {
                                    let _e171 = (_e162 > 0f);
                                    if _e171 {
                                        phi_762_ = bool();
                                    } else {
                                        phi_762_ = (_e163 > 0f);
                                    }
                                    let _e174 = phi_762_;
                                    phi_763_ = _e174;
                                    phi_764_ = _e171;
                                }
                                let _e176 = phi_763_;
                                let _e178 = phi_764_;
                                if _e178 {
                                    phi_768_ = true;
                                } else {
                                    phi_768_ = _e176;
                                }
                                let _e180 = phi_768_;
                                phi_769_ = _e180;
                                phi_770_ = false;
                            } else {
                                phi_769_ = bool();
                                phi_770_ = true;
                            }
                            let _e182 = phi_769_;
                            let _e184 = phi_770_;
                            phi_771_ = _e182;
                            phi_772_ = false;
                            phi_773_ = _e184;
                        } else {
                            phi_771_ = bool();
                            phi_772_ = true;
                            phi_773_ = false;
                        }
                        let _e186 = phi_771_;
                        let _e188 = phi_772_;
                        let _e190 = phi_773_;
                        phi_774_ = _e186;
                        phi_775_ = _e188;
                        phi_776_ = _e190;
                    } else {
                        phi_774_ = bool();
                        phi_775_ = true;
                        phi_776_ = false;
                    }
                    let _e192 = phi_774_;
                    let _e194 = phi_775_;
                    let _e196 = phi_776_;
                    phi_777_ = _e192;
                    phi_778_ = _e194;
                    phi_779_ = _e196;
                } else {
                    phi_777_ = bool();
                    phi_778_ = true;
                    phi_779_ = false;
                }
                let _e198 = phi_777_;
                let _e200 = phi_778_;
                let _e202 = phi_779_;
                phi_780_ = _e198;
                phi_781_ = _e200;
                phi_782_ = _e202;
            } else {
                phi_780_ = bool();
                phi_781_ = true;
                phi_782_ = false;
            }
            let _e204 = phi_780_;
            let _e206 = phi_781_;
            let _e208 = phi_782_;
            phi_783_ = _e204;
            phi_784_ = _e206;
            phi_785_ = _e208;
        } else {
            phi_783_ = bool();
            phi_784_ = true;
            phi_785_ = false;
        }
        let _e210 = phi_783_;
        let _e212 = phi_784_;
        let _e214 = phi_785_;
        if _e212 {
            phi_789_ = true;
        } else {
            phi_789_ = _e214;
        }
        let _e216 = phi_789_;
        if _e216 {
            phi_793_ = false;
        } else {
            phi_793_ = _e210;
        }
        let _e218 = phi_793_;
        if _e218 {
            let _e219 = (_e117 >= _e78);
            if _e219 {
                phi_3376_ = false;
            } else {
                if (_e117 < _e78) {
                } else {
                    return;
                }
                let _e225 = nodes.member[(0u + _e117)].frame[0u];
                let _e229 = nodes.member[(0u + _e117)].frame[1u];
                let _e233 = nodes.member[(0u + _e117)].frame[2u];
                let _e237 = nodes.member[(0u + _e117)].frame[0u];
                let _e241 = nodes.member[(0u + _e117)].frame[1u];
                let _e245 = nodes.member[(0u + _e117)].frame[2u];
                let _e249 = nodes.member[(0u + _e117)].frame[3u];
                let _e283 = core_intrinsics_maximum_number_nsz_f32_(abs(_e155), abs(_e156));
                let _e284 = core_intrinsics_maximum_number_nsz_f32_(_e283, abs(_e157));
                let _e285 = (_e284 * 0.0000000000009094947f);
                if (abs(_e155) < _e285) {
                    phi_863_ = _e285;
                } else {
                    phi_863_ = abs(_e155);
                }
                let _e290 = phi_863_;
                if (_e155 < 0f) {
                    phi_870_ = (-1f / _e290);
                } else {
                    phi_870_ = (1f / _e290);
                }
                let _e295 = phi_870_;
                if (abs(_e156) < _e285) {
                    phi_877_ = _e285;
                } else {
                    phi_877_ = abs(_e156);
                }
                let _e300 = phi_877_;
                if (_e156 < 0f) {
                    phi_884_ = (-1f / _e300);
                } else {
                    phi_884_ = (1f / _e300);
                }
                let _e305 = phi_884_;
                if (abs(_e157) < _e285) {
                    phi_891_ = _e285;
                } else {
                    phi_891_ = abs(_e157);
                }
                let _e310 = phi_891_;
                if (_e157 < 0f) {
                    phi_898_ = (-1f / _e310);
                } else {
                    phi_898_ = (1f / _e310);
                }
                let _e315 = phi_898_;
                let _e319 = abs((bitcast<f32>(_e225) - _e137));
                let _e320 = abs((bitcast<f32>(_e229) - _e139));
                let _e321 = abs((bitcast<f32>(_e233) - _e141));
                let _e325 = abs(((bitcast<f32>(_e237) + (bitcast<f32>((((_e249 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e137));
                let _e326 = abs(((bitcast<f32>(_e241) + (bitcast<f32>((((_e249 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e139));
                let _e327 = abs(((bitcast<f32>(_e245) + (bitcast<f32>((((_e249 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e141));
                if (_e319 > _e325) {
                    phi_915_ = _e319;
                } else {
                    phi_915_ = _e325;
                }
                let _e330 = phi_915_;
                if (_e320 > _e326) {
                    phi_920_ = _e320;
                } else {
                    phi_920_ = _e326;
                }
                let _e333 = phi_920_;
                if (_e321 > _e327) {
                    phi_925_ = _e321;
                } else {
                    phi_925_ = _e327;
                }
                let _e336 = phi_925_;
                let _e337 = core_intrinsics_maximum_number_nsz_f32_(_e330, _e333);
                let _e338 = core_intrinsics_maximum_number_nsz_f32_(_e337, _e336);
                let _e342 = (_e338 * 0.0000019073486f);
                let _e343 = (abs(_e295) * _e342);
                let _e344 = (abs(_e305) * _e342);
                let _e345 = (abs(_e315) * _e342);
                let _e349 = (_e338 * 0.0000009536743f);
                let _e350 = (abs(_e295) * _e349);
                let _e351 = (abs(_e305) * _e349);
                let _e352 = (abs(_e315) * _e349);
                if (_e295 < 0f) {
                    phi_946_ = 0u;
                } else {
                    phi_946_ = 1u;
                }
                let _e355 = phi_946_;
                if (_e305 < 0f) {
                    phi_951_ = 0u;
                } else {
                    phi_951_ = 2u;
                }
                let _e358 = phi_951_;
                if (_e315 < 0f) {
                    phi_956_ = 0u;
                } else {
                    phi_956_ = 4u;
                }
                let _e361 = phi_956_;
                let _e363 = ((_e355 | _e358) | _e361);
                let _e364 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e117, 2147483648u);
                local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e364.first[0], _e364.first[1], _e364.first[2], _e364.first[3], _e364.first[4], _e364.first[5], _e364.first[6], _e364.first[7], _e364.first[8], _e364.first[9], _e364.first[10], _e364.first[11], _e364.first[12], _e364.first[13], _e364.first[14], _e364.first[15], _e364.first[16], _e364.first[17], _e364.first[18], _e364.first[19], _e364.first[20], _e364.first[21], _e364.first[22], _e364.first[23], _e364.first[24], _e364.first[25], _e364.first[26], _e364.first[27], _e364.first[28], _e364.first[29], _e364.first[30], _e364.first[31]), array<u32, 32>(_e364.mask[0], _e364.mask[1], _e364.mask[2], _e364.mask[3], _e364.mask[4], _e364.mask[5], _e364.mask[6], _e364.mask[7], _e364.mask[8], _e364.mask[9], _e364.mask[10], _e364.mask[11], _e364.mask[12], _e364.mask[13], _e364.mask[14], _e364.mask[15], _e364.mask[16], _e364.mask[17], _e364.mask[18], _e364.mask[19], _e364.mask[20], _e364.mask[21], _e364.mask[22], _e364.mask[23], _e364.mask[24], _e364.mask[25], _e364.mask[26], _e364.mask[27], _e364.mask[28], _e364.mask[29], _e364.mask[30], _e364.mask[31]), _e364.len, _e364.group, _e364.group_mask);
                let _e438 = local_2.group_mask;
                if ((_e438 & 4278190080u) == 0u) {
                    let _e442 = local_2.len;
                    if (_e442 == 0u) {
                        phi_1070_ = false;
                    } else {
                        let _e446 = local_2.len;
                        local_2.len = (_e446 - 1u);
                        let _e449 = local_2.len;
                        if (_e449 < 32u) {
                        } else {
                            return;
                        }
                        let _e454 = local_2.first[(0u + _e449)];
                        local_2.group = _e454;
                        let _e457 = local_2.len;
                        if (_e457 < 32u) {
                        } else {
                            return;
                        }
                        let _e462 = local_2.mask[(0u + _e457)];
                        local_2.group_mask = _e462;
                        phi_1070_ = true;
                    }
                    let _e465 = phi_1070_;
                    phi_1071_ = _e465;
                } else {
                    phi_1071_ = true;
                }
                let _e467 = phi_1071_;
                if _e467 {
                    let _e469 = local_2.group_mask;
                    let _e475 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e469)), 32u, (_e469 == 0u)));
                    let _e479 = local_2.group_mask;
                    let _e493 = local_2.group_mask;
                    local_2.group_mask = (_e493 & ~((1u << bitcast<u32>((_e475 & 31u)))));
                    let _e496 = local_2.group;
                    phi_1102_ = (_e496 + countOneBits(((_e479 & ~((4294967295u << bitcast<u32>((((_e475 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1102_ = 4294967295u;
                }
                let _e499 = phi_1102_;
                phi_1104_ = _e499;
                phi_1107_ = false;
                loop {
                    let _e501 = phi_1104_;
                    let _e503 = phi_1107_;
                    if (_e501 != 4294967295u) {
                        if (_e501 < _e78) {
                        } else {
                            return;
                        }
                        let _e510 = nodes.member[(0u + _e501)].frame[3u];
                        let _e535 = (bitcast<f32>((((_e510 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e295);
                        let _e536 = (bitcast<f32>((((_e510 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e305);
                        let _e537 = (bitcast<f32>((((_e510 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e315);
                        let _e540 = nodes.member[(0u + _e501)].frame[0u];
                        let _e544 = nodes.member[(0u + _e501)].frame[1u];
                        let _e548 = nodes.member[(0u + _e501)].frame[2u];
                        let _e553 = ((bitcast<f32>(_e540) - _e137) * _e295);
                        let _e554 = ((bitcast<f32>(_e544) - _e139) * _e305);
                        let _e555 = ((bitcast<f32>(_e548) - _e141) * _e315);
                        let _e563 = nodes.member[(0u + _e501)].x;
                        if (_e295 < 0f) {
                            let _e574 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e563.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e580 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e574.unnamed.word, _e563.w), _e574.unnamed_1);
                            let _e586 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e580.unnamed, lt_mask_LightPlace(_e563.x, _e580.unnamed_1.shift));
                            phi_1187_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e586.unnamed, lt_mask_LightPlace(_e586.unnamed_1.word, _e563.y));
                        } else {
                            let _e602 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e563.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e608 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e602.unnamed.word, _e563.y), _e602.unnamed_1);
                            let _e614 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e608.unnamed, lt_mask_LightPlace(_e563.z, _e608.unnamed_1.shift));
                            phi_1187_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e614.unnamed, lt_mask_LightPlace(_e614.unnamed_1.word, _e563.w));
                        }
                        let _e622 = phi_1187_;
                        let _e632 = nodes.member[(0u + _e501)].y;
                        if (_e305 < 0f) {
                            let _e643 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e632.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e649 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e643.unnamed.word, _e632.w), _e643.unnamed_1);
                            let _e655 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e649.unnamed, lt_mask_LightPlace(_e632.x, _e649.unnamed_1.shift));
                            phi_1214_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e655.unnamed, lt_mask_LightPlace(_e655.unnamed_1.word, _e632.y));
                        } else {
                            let _e671 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e632.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e677 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e671.unnamed.word, _e632.y), _e671.unnamed_1);
                            let _e683 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e677.unnamed, lt_mask_LightPlace(_e632.z, _e677.unnamed_1.shift));
                            phi_1214_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e683.unnamed, lt_mask_LightPlace(_e683.unnamed_1.word, _e632.w));
                        }
                        let _e691 = phi_1214_;
                        let _e701 = nodes.member[(0u + _e501)].z;
                        if (_e315 < 0f) {
                            let _e712 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e701.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e718 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e712.unnamed.word, _e701.w), _e712.unnamed_1);
                            let _e724 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e718.unnamed, lt_mask_LightPlace(_e701.x, _e718.unnamed_1.shift));
                            phi_1241_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e724.unnamed, lt_mask_LightPlace(_e724.unnamed_1.word, _e701.y));
                        } else {
                            let _e740 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e701.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e746 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e740.unnamed.word, _e701.y), _e740.unnamed_1);
                            let _e752 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e746.unnamed, lt_mask_LightPlace(_e701.z, _e746.unnamed_1.shift));
                            phi_1241_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e752.unnamed, lt_mask_LightPlace(_e752.unnamed_1.word, _e701.w));
                        }
                        let _e760 = phi_1241_;
                        phi_1247_ = 0u;
                        phi_1250_ = 0u;
                        loop {
                            let _e770 = phi_1247_;
                            let _e772 = phi_1250_;
                            local_3 = _e772;
                            local_4 = _e772;
                            local_5 = _e772;
                            let _e773 = (_e770 < 8u);
                            if _e773 {
                                let _e775 = (_e770 >> bitcast<u32>(2i));
                                let _e776 = (_e770 & 3u);
                                if (_e775 == 0u) {
                                    phi_1264_ = _e622.unnamed.word;
                                } else {
                                    phi_1264_ = _e622.unnamed.shift;
                                }
                                let _e779 = phi_1264_;
                                if (_e775 == 0u) {
                                    phi_1274_ = _e691.unnamed.word;
                                } else {
                                    phi_1274_ = _e691.unnamed.shift;
                                }
                                let _e788 = phi_1274_;
                                if (_e775 == 0u) {
                                    phi_1284_ = _e760.unnamed.word;
                                } else {
                                    phi_1284_ = _e760.unnamed.shift;
                                }
                                let _e797 = phi_1284_;
                                let _e810 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e779 >> bitcast<u32>(((_e776 * 8u) & 31u))) & 255u)) * _e535) + (_e553 - _e343)), ((f32(((_e788 >> bitcast<u32>(((_e776 * 8u) & 31u))) & 255u)) * _e536) + (_e554 - _e344)));
                                let _e811 = core_intrinsics_maximum_number_nsz_f32_(_e810, ((f32(((_e797 >> bitcast<u32>(((_e776 * 8u) & 31u))) & 255u)) * _e537) + (_e555 - _e345)));
                                if (_e775 == 0u) {
                                    phi_1302_ = _e622.unnamed_1.word;
                                } else {
                                    phi_1302_ = _e622.unnamed_1.shift;
                                }
                                let _e814 = phi_1302_;
                                if (_e775 == 0u) {
                                    phi_1312_ = _e691.unnamed_1.word;
                                } else {
                                    phi_1312_ = _e691.unnamed_1.shift;
                                }
                                let _e823 = phi_1312_;
                                if (_e775 == 0u) {
                                    phi_1322_ = _e760.unnamed_1.word;
                                } else {
                                    phi_1322_ = _e760.unnamed_1.shift;
                                }
                                let _e832 = phi_1322_;
                                let _e845 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e814 >> bitcast<u32>(((_e776 * 8u) & 31u))) & 255u)) * _e535) + (_e553 + _e343)), ((f32(((_e823 >> bitcast<u32>(((_e776 * 8u) & 31u))) & 255u)) * _e536) + (_e554 + _e344)));
                                let _e846 = core_intrinsics_minimum_number_nsz_f32_(_e845, ((f32(((_e832 >> bitcast<u32>(((_e776 * 8u) & 31u))) & 255u)) * _e537) + (_e555 + _e345)));
                                if (_e811 <= _e846) {
                                    if (_e811 <= _e147) {
                                        if (_e846 >= 0f) {
                                            if (_e775 == 0u) {
                                                let _e853 = nodes.member[(0u + _e501)].links[2u];
                                                phi_1358_ = _e853;
                                            } else {
                                                let _e856 = nodes.member[(0u + _e501)].links[3u];
                                                phi_1358_ = _e856;
                                            }
                                            let _e858 = phi_1358_;
                                            let _e863 = ((_e858 >> bitcast<u32>(((_e776 * 8u) & 31u))) & 255u);
                                            let _e864 = (_e863 & 31u);
                                            if (_e864 >= 24u) {
                                                phi_1371_ = (24u + ((_e864 - 24u) ^ _e363));
                                            } else {
                                                phi_1371_ = _e864;
                                            }
                                            let _e870 = phi_1371_;
                                            phi_1376_ = (_e772 | ((_e863 >> bitcast<u32>(5i)) << bitcast<u32>((_e870 & 31u))));
                                        } else {
                                            phi_1376_ = _e772;
                                        }
                                        let _e878 = phi_1376_;
                                        phi_1377_ = _e878;
                                    } else {
                                        phi_1377_ = _e772;
                                    }
                                    let _e880 = phi_1377_;
                                    phi_1378_ = _e880;
                                } else {
                                    phi_1378_ = _e772;
                                }
                                let _e882 = phi_1378_;
                                phi_1248_ = (_e770 + 1u);
                                phi_1251_ = _e882;
                            } else {
                                phi_1248_ = u32();
                                phi_1251_ = u32();
                            }
                            let _e885 = phi_1248_;
                            let _e887 = phi_1251_;
                            continue;
                            continuing {
                                phi_1247_ = _e885;
                                phi_1250_ = _e887;
                                break if !(_e773);
                            }
                        }
                        let _e891 = nodes.member[(0u + _e501)].links[0u];
                        let _e895 = nodes.member[(0u + _e501)].frame[3u];
                        let _e899 = local_3;
                        if ((_e899 & 4278190080u) == 0u) {
                        } else {
                            let _e903 = local_2.group_mask;
                            if ((_e903 & 4278190080u) == 0u) {
                            } else {
                                let _e907 = local_2.len;
                                if (_e907 < 32u) {
                                    let _e910 = local_2.group;
                                    let _e912 = local_2.len;
                                    if (_e912 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.first[(0u + _e912)] = _e910;
                                    let _e918 = local_2.group_mask;
                                    let _e920 = local_2.len;
                                    if (_e920 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.mask[(0u + _e920)] = _e918;
                                    let _e927 = local_2.len;
                                    local_2.len = (_e927 + 1u);
                                }
                            }
                            local_2.group = (_e117 + _e891);
                            let _e931 = local_4;
                            local_2.group_mask = ((_e931 & 4278190080u) | (_e895 >> bitcast<u32>(24i)));
                        }
                        let _e936 = local_5;
                        phi_1436_ = (_e936 & 16777215u);
                        phi_1439_ = _e503;
                        loop {
                            let _e939 = phi_1436_;
                            let _e941 = phi_1439_;
                            local_18 = _e941;
                            let _e942 = (_e939 == 0u);
                            local_11 = _e942;
                            local_19 = _e942;
                            if _e942 {
                                phi_1437_ = u32();
                                phi_1440_ = bool();
                                phi_3291_ = false;
                            } else {
                                let _e945 = nodes.member[(0u + _e501)].links[1u];
                                let _e949 = (_e945 + select(firstTrailingBit(_e939), 32u, (_e939 == 0u)));
                                if (_e949 < arrayLength((&instances.member))) {
                                } else {
                                    return;
                                }
                                let _e956 = instances.member[(0u + _e949)].low_world;
                                let _e958 = instances.member[(0u + _e949)].high_world;
                                let _e965 = ((_e956.x - _e137) * _e295);
                                let _e966 = ((_e956.y - _e139) * _e305);
                                let _e967 = ((_e956.z - _e141) * _e315);
                                let _e974 = ((_e958.x - _e137) * _e295);
                                let _e975 = ((_e958.y - _e139) * _e305);
                                let _e976 = ((_e958.z - _e141) * _e315);
                                if (_e965 < _e974) {
                                    phi_1488_ = _e965;
                                } else {
                                    phi_1488_ = _e974;
                                }
                                let _e979 = phi_1488_;
                                if (_e966 < _e975) {
                                    phi_1493_ = _e966;
                                } else {
                                    phi_1493_ = _e975;
                                }
                                let _e982 = phi_1493_;
                                if (_e967 < _e976) {
                                    phi_1498_ = _e967;
                                } else {
                                    phi_1498_ = _e976;
                                }
                                let _e985 = phi_1498_;
                                if (_e965 > _e974) {
                                    phi_1506_ = _e965;
                                } else {
                                    phi_1506_ = _e974;
                                }
                                let _e991 = phi_1506_;
                                if (_e966 > _e975) {
                                    phi_1511_ = _e966;
                                } else {
                                    phi_1511_ = _e975;
                                }
                                let _e994 = phi_1511_;
                                if (_e967 > _e976) {
                                    phi_1516_ = _e967;
                                } else {
                                    phi_1516_ = _e976;
                                }
                                let _e997 = phi_1516_;
                                let _e1001 = core_intrinsics_maximum_number_nsz_f32_((_e979 - _e350), (_e982 - _e351));
                                let _e1002 = core_intrinsics_maximum_number_nsz_f32_(_e1001, (_e985 - _e352));
                                let _e1003 = core_intrinsics_minimum_number_nsz_f32_((_e991 + _e350), (_e994 + _e351));
                                let _e1004 = core_intrinsics_minimum_number_nsz_f32_(_e1003, (_e997 + _e352));
                                if (_e1002 <= _e1004) {
                                    if (_e1002 <= _e147) {
                                        if (_e1004 >= 0f) {
                                            let _e1010 = instances.member[(0u + _e949)].world_to_object[0u];
                                            let _e1021 = ((((_e1010.x * _e137) + (_e1010.y * _e139)) + (_e1010.z * _e141)) + (_e1010.w * 1f));
                                            let _e1023 = instances.member[(0u + _e949)].world_to_object[1u];
                                            let _e1034 = ((((_e1023.x * _e137) + (_e1023.y * _e139)) + (_e1023.z * _e141)) + (_e1023.w * 1f));
                                            let _e1036 = instances.member[(0u + _e949)].world_to_object[2u];
                                            let _e1047 = ((((_e1036.x * _e137) + (_e1036.y * _e139)) + (_e1036.z * _e141)) + (_e1036.w * 1f));
                                            let _e1050 = instances.member[(0u + _e949)].world_to_object[0u];
                                            let _e1061 = ((((_e1050.x * _e155) + (_e1050.y * _e156)) + (_e1050.z * _e157)) + (_e1050.w * 0f));
                                            let _e1063 = instances.member[(0u + _e949)].world_to_object[1u];
                                            let _e1074 = ((((_e1063.x * _e155) + (_e1063.y * _e156)) + (_e1063.z * _e157)) + (_e1063.w * 0f));
                                            let _e1076 = instances.member[(0u + _e949)].world_to_object[2u];
                                            let _e1087 = ((((_e1076.x * _e155) + (_e1076.y * _e156)) + (_e1076.z * _e157)) + (_e1076.w * 0f));
                                            let _e1090 = instances.member[(0u + _e949)].root;
                                            let _e1092 = instances.member[(0u + _e949)].first_triangle;
                                            let _e1096 = abs(_e1061);
                                            let _e1097 = abs(_e1074);
                                            let _e1098 = abs(_e1087);
                                            if (abs(_e1021) < 1000000000000000f) {
                                                if (abs(_e1034) < 1000000000000000f) {
                                                    if (abs(_e1047) < 1000000000000000f) {
                                                        if (_e1096 < 1000000000000000f) {
                                                            if (_e1097 < 1000000000000000f) {
                                                                if (_e1098 < 1000000000000000f) {
                                                                    if (_e1096 > 0f) {
                                                                        phi_1661_ = bool();
                                                                        phi_1662_ = true;
                                                                    } else {
                                                                        let _e1106 = (_e1097 > 0f);
                                                                        if _e1106 {
                                                                            phi_1660_ = bool();
                                                                        } else {
                                                                            phi_1660_ = (_e1098 > 0f);
                                                                        }
                                                                        let _e1109 = phi_1660_;
                                                                        phi_1661_ = _e1109;
                                                                        phi_1662_ = _e1106;
                                                                    }
                                                                    let _e1111 = phi_1661_;
                                                                    let _e1113 = phi_1662_;
                                                                    if _e1113 {
                                                                        phi_1666_ = true;
                                                                    } else {
                                                                        phi_1666_ = _e1111;
                                                                    }
                                                                    let _e1115 = phi_1666_;
                                                                    phi_1667_ = _e1115;
                                                                    phi_1668_ = false;
                                                                } else {
                                                                    phi_1667_ = bool();
                                                                    phi_1668_ = true;
                                                                }
                                                                let _e1117 = phi_1667_;
                                                                let _e1119 = phi_1668_;
                                                                phi_1669_ = _e1117;
                                                                phi_1670_ = false;
                                                                phi_1671_ = _e1119;
                                                            } else {
                                                                phi_1669_ = bool();
                                                                phi_1670_ = true;
                                                                phi_1671_ = false;
                                                            }
                                                            let _e1121 = phi_1669_;
                                                            let _e1123 = phi_1670_;
                                                            let _e1125 = phi_1671_;
                                                            phi_1672_ = _e1121;
                                                            phi_1673_ = _e1123;
                                                            phi_1674_ = _e1125;
                                                        } else {
                                                            phi_1672_ = bool();
                                                            phi_1673_ = true;
                                                            phi_1674_ = false;
                                                        }
                                                        let _e1127 = phi_1672_;
                                                        let _e1129 = phi_1673_;
                                                        let _e1131 = phi_1674_;
                                                        phi_1675_ = _e1127;
                                                        phi_1676_ = _e1129;
                                                        phi_1677_ = _e1131;
                                                    } else {
                                                        phi_1675_ = bool();
                                                        phi_1676_ = true;
                                                        phi_1677_ = false;
                                                    }
                                                    let _e1133 = phi_1675_;
                                                    let _e1135 = phi_1676_;
                                                    let _e1137 = phi_1677_;
                                                    phi_1678_ = _e1133;
                                                    phi_1679_ = _e1135;
                                                    phi_1680_ = _e1137;
                                                } else {
                                                    phi_1678_ = bool();
                                                    phi_1679_ = true;
                                                    phi_1680_ = false;
                                                }
                                                let _e1139 = phi_1678_;
                                                let _e1141 = phi_1679_;
                                                let _e1143 = phi_1680_;
                                                phi_1681_ = _e1139;
                                                phi_1682_ = _e1141;
                                                phi_1683_ = _e1143;
                                            } else {
                                                phi_1681_ = bool();
                                                phi_1682_ = true;
                                                phi_1683_ = false;
                                            }
                                            let _e1145 = phi_1681_;
                                            let _e1147 = phi_1682_;
                                            let _e1149 = phi_1683_;
                                            if _e1147 {
                                                phi_1687_ = true;
                                            } else {
                                                phi_1687_ = _e1149;
                                            }
                                            let _e1151 = phi_1687_;
                                            if _e1151 {
                                                phi_1691_ = false;
                                            } else {
                                                phi_1691_ = _e1145;
                                            }
                                            let _e1153 = phi_1691_;
                                            if _e1153 {
                                                let _e1154 = (_e1090 >= _e78);
                                                if _e1154 {
                                                    phi_3271_ = bool();
                                                } else {
                                                    if (_e1090 < _e78) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1160 = nodes.member[(0u + _e1090)].frame[0u];
                                                    let _e1164 = nodes.member[(0u + _e1090)].frame[1u];
                                                    let _e1168 = nodes.member[(0u + _e1090)].frame[2u];
                                                    let _e1172 = nodes.member[(0u + _e1090)].frame[0u];
                                                    let _e1176 = nodes.member[(0u + _e1090)].frame[1u];
                                                    let _e1180 = nodes.member[(0u + _e1090)].frame[2u];
                                                    let _e1184 = nodes.member[(0u + _e1090)].frame[3u];
                                                    let _e1218 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1061), abs(_e1074));
                                                    let _e1219 = core_intrinsics_maximum_number_nsz_f32_(_e1218, abs(_e1087));
                                                    let _e1220 = (_e1219 * 0.0000000000009094947f);
                                                    if (abs(_e1061) < _e1220) {
                                                        phi_1761_ = _e1220;
                                                    } else {
                                                        phi_1761_ = abs(_e1061);
                                                    }
                                                    let _e1225 = phi_1761_;
                                                    if (_e1061 < 0f) {
                                                        phi_1768_ = (-1f / _e1225);
                                                    } else {
                                                        phi_1768_ = (1f / _e1225);
                                                    }
                                                    let _e1230 = phi_1768_;
                                                    if (abs(_e1074) < _e1220) {
                                                        phi_1775_ = _e1220;
                                                    } else {
                                                        phi_1775_ = abs(_e1074);
                                                    }
                                                    let _e1235 = phi_1775_;
                                                    if (_e1074 < 0f) {
                                                        phi_1782_ = (-1f / _e1235);
                                                    } else {
                                                        phi_1782_ = (1f / _e1235);
                                                    }
                                                    let _e1240 = phi_1782_;
                                                    if (abs(_e1087) < _e1220) {
                                                        phi_1789_ = _e1220;
                                                    } else {
                                                        phi_1789_ = abs(_e1087);
                                                    }
                                                    let _e1245 = phi_1789_;
                                                    if (_e1087 < 0f) {
                                                        phi_1796_ = (-1f / _e1245);
                                                    } else {
                                                        phi_1796_ = (1f / _e1245);
                                                    }
                                                    let _e1250 = phi_1796_;
                                                    let _e1254 = abs((bitcast<f32>(_e1160) - _e1021));
                                                    let _e1255 = abs((bitcast<f32>(_e1164) - _e1034));
                                                    let _e1256 = abs((bitcast<f32>(_e1168) - _e1047));
                                                    let _e1260 = abs(((bitcast<f32>(_e1172) + (bitcast<f32>((((_e1184 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1021));
                                                    let _e1261 = abs(((bitcast<f32>(_e1176) + (bitcast<f32>((((_e1184 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1034));
                                                    let _e1262 = abs(((bitcast<f32>(_e1180) + (bitcast<f32>((((_e1184 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1047));
                                                    if (_e1254 > _e1260) {
                                                        phi_1813_ = _e1254;
                                                    } else {
                                                        phi_1813_ = _e1260;
                                                    }
                                                    let _e1265 = phi_1813_;
                                                    if (_e1255 > _e1261) {
                                                        phi_1818_ = _e1255;
                                                    } else {
                                                        phi_1818_ = _e1261;
                                                    }
                                                    let _e1268 = phi_1818_;
                                                    if (_e1256 > _e1262) {
                                                        phi_1823_ = _e1256;
                                                    } else {
                                                        phi_1823_ = _e1262;
                                                    }
                                                    let _e1271 = phi_1823_;
                                                    let _e1272 = core_intrinsics_maximum_number_nsz_f32_(_e1265, _e1268);
                                                    let _e1273 = core_intrinsics_maximum_number_nsz_f32_(_e1272, _e1271);
                                                    let _e1277 = (_e1273 * 0.0000019073486f);
                                                    let _e1278 = (abs(_e1230) * _e1277);
                                                    let _e1279 = (abs(_e1240) * _e1277);
                                                    let _e1280 = (abs(_e1250) * _e1277);
                                                    let _e1284 = (_e1273 * 0.0000009536743f);
                                                    let _e1285 = (abs(_e1230) * _e1284);
                                                    let _e1286 = (abs(_e1240) * _e1284);
                                                    let _e1287 = (abs(_e1250) * _e1284);
                                                    let _e1288 = abs(_e1061);
                                                    let _e1289 = abs(_e1074);
                                                    let _e1290 = abs(_e1087);
                                                    if (_e1288 >= _e1289) {
                                                        if (_e1288 >= _e1290) {
                                                            phi_1851_ = false;
                                                        } else {
                                                            phi_1851_ = true;
                                                        }
                                                        let _e1294 = phi_1851_;
                                                        phi_1852_ = _e1294;
                                                    } else {
                                                        phi_1852_ = true;
                                                    }
                                                    let _e1296 = phi_1852_;
                                                    if _e1296 {
                                                        if (_e1289 >= _e1290) {
                                                            phi_1860_ = 1u;
                                                        } else {
                                                            phi_1860_ = 2u;
                                                        }
                                                        let _e1299 = phi_1860_;
                                                        phi_1861_ = _e1299;
                                                    } else {
                                                        phi_1861_ = 0u;
                                                    }
                                                    let _e1301 = phi_1861_;
                                                    if (_e1301 == 0u) {
                                                        phi_1873_ = vec3<f32>(_e1074, _e1087, _e1061);
                                                    } else {
                                                        if (_e1301 == 1u) {
                                                            phi_1872_ = vec3<f32>(_e1087, _e1061, _e1074);
                                                        } else {
                                                            phi_1872_ = vec3<f32>(_e1061, _e1074, _e1087);
                                                        }
                                                        let _e1307 = phi_1872_;
                                                        phi_1873_ = _e1307;
                                                    }
                                                    let _e1309 = phi_1873_;
                                                    let _e1312 = (_e1309.x / _e1309.z);
                                                    let _e1315 = (_e1309.y / _e1309.z);
                                                    if (_e1230 < 0f) {
                                                        phi_1886_ = 0u;
                                                    } else {
                                                        phi_1886_ = 1u;
                                                    }
                                                    let _e1320 = phi_1886_;
                                                    if (_e1240 < 0f) {
                                                        phi_1891_ = 0u;
                                                    } else {
                                                        phi_1891_ = 2u;
                                                    }
                                                    let _e1323 = phi_1891_;
                                                    if (_e1250 < 0f) {
                                                        phi_1896_ = 0u;
                                                    } else {
                                                        phi_1896_ = 4u;
                                                    }
                                                    let _e1326 = phi_1896_;
                                                    let _e1328 = ((_e1320 | _e1323) | _e1326);
                                                    let _e1329 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1090, 2147483648u);
                                                    local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e1329.first[0], _e1329.first[1], _e1329.first[2], _e1329.first[3], _e1329.first[4], _e1329.first[5], _e1329.first[6], _e1329.first[7], _e1329.first[8], _e1329.first[9], _e1329.first[10], _e1329.first[11], _e1329.first[12], _e1329.first[13], _e1329.first[14], _e1329.first[15], _e1329.first[16], _e1329.first[17], _e1329.first[18], _e1329.first[19], _e1329.first[20], _e1329.first[21], _e1329.first[22], _e1329.first[23], _e1329.first[24], _e1329.first[25], _e1329.first[26], _e1329.first[27], _e1329.first[28], _e1329.first[29], _e1329.first[30], _e1329.first[31]), array<u32, 32>(_e1329.mask[0], _e1329.mask[1], _e1329.mask[2], _e1329.mask[3], _e1329.mask[4], _e1329.mask[5], _e1329.mask[6], _e1329.mask[7], _e1329.mask[8], _e1329.mask[9], _e1329.mask[10], _e1329.mask[11], _e1329.mask[12], _e1329.mask[13], _e1329.mask[14], _e1329.mask[15], _e1329.mask[16], _e1329.mask[17], _e1329.mask[18], _e1329.mask[19], _e1329.mask[20], _e1329.mask[21], _e1329.mask[22], _e1329.mask[23], _e1329.mask[24], _e1329.mask[25], _e1329.mask[26], _e1329.mask[27], _e1329.mask[28], _e1329.mask[29], _e1329.mask[30], _e1329.mask[31]), _e1329.len, _e1329.group, _e1329.group_mask);
                                                    let _e1403 = local_1.group_mask;
                                                    if ((_e1403 & 4278190080u) == 0u) {
                                                        let _e1407 = local_1.len;
                                                        if (_e1407 == 0u) {
                                                            phi_2010_ = false;
                                                        } else {
                                                            let _e1411 = local_1.len;
                                                            local_1.len = (_e1411 - 1u);
                                                            let _e1414 = local_1.len;
                                                            if (_e1414 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1419 = local_1.first[(0u + _e1414)];
                                                            local_1.group = _e1419;
                                                            let _e1422 = local_1.len;
                                                            if (_e1422 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1427 = local_1.mask[(0u + _e1422)];
                                                            local_1.group_mask = _e1427;
                                                            phi_2010_ = true;
                                                        }
                                                        let _e1430 = phi_2010_;
                                                        phi_2011_ = _e1430;
                                                    } else {
                                                        phi_2011_ = true;
                                                    }
                                                    let _e1432 = phi_2011_;
                                                    if _e1432 {
                                                        let _e1434 = local_1.group_mask;
                                                        let _e1440 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1434)), 32u, (_e1434 == 0u)));
                                                        let _e1444 = local_1.group_mask;
                                                        let _e1458 = local_1.group_mask;
                                                        local_1.group_mask = (_e1458 & ~((1u << bitcast<u32>((_e1440 & 31u)))));
                                                        let _e1461 = local_1.group;
                                                        phi_2042_ = (_e1461 + countOneBits(((_e1444 & ~((4294967295u << bitcast<u32>((((_e1440 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_2042_ = 4294967295u;
                                                    }
                                                    let _e1464 = phi_2042_;
                                                    phi_2044_ = _e1464;
                                                    phi_2047_ = _e941;
                                                    loop {
                                                        let _e1466 = phi_2044_;
                                                        let _e1468 = phi_2047_;
                                                        local_17 = _e1468;
                                                        if (_e1466 != 4294967295u) {
                                                            if (_e1466 < _e78) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1475 = nodes.member[(0u + _e1466)].frame[3u];
                                                            let _e1500 = (bitcast<f32>((((_e1475 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1230);
                                                            let _e1501 = (bitcast<f32>((((_e1475 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1240);
                                                            let _e1502 = (bitcast<f32>((((_e1475 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1250);
                                                            let _e1505 = nodes.member[(0u + _e1466)].frame[0u];
                                                            let _e1509 = nodes.member[(0u + _e1466)].frame[1u];
                                                            let _e1513 = nodes.member[(0u + _e1466)].frame[2u];
                                                            let _e1518 = ((bitcast<f32>(_e1505) - _e1021) * _e1230);
                                                            let _e1519 = ((bitcast<f32>(_e1509) - _e1034) * _e1240);
                                                            let _e1520 = ((bitcast<f32>(_e1513) - _e1047) * _e1250);
                                                            let _e1528 = nodes.member[(0u + _e1466)].x;
                                                            if (_e1230 < 0f) {
                                                                let _e1539 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1528.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1545 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1539.unnamed.word, _e1528.w), _e1539.unnamed_1);
                                                                let _e1551 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1545.unnamed, lt_mask_LightPlace(_e1528.x, _e1545.unnamed_1.shift));
                                                                phi_2127_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1551.unnamed, lt_mask_LightPlace(_e1551.unnamed_1.word, _e1528.y));
                                                            } else {
                                                                let _e1567 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1528.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1573 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1567.unnamed.word, _e1528.y), _e1567.unnamed_1);
                                                                let _e1579 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1573.unnamed, lt_mask_LightPlace(_e1528.z, _e1573.unnamed_1.shift));
                                                                phi_2127_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1579.unnamed, lt_mask_LightPlace(_e1579.unnamed_1.word, _e1528.w));
                                                            }
                                                            let _e1587 = phi_2127_;
                                                            let _e1597 = nodes.member[(0u + _e1466)].y;
                                                            if (_e1240 < 0f) {
                                                                let _e1608 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1597.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1614 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1608.unnamed.word, _e1597.w), _e1608.unnamed_1);
                                                                let _e1620 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1614.unnamed, lt_mask_LightPlace(_e1597.x, _e1614.unnamed_1.shift));
                                                                phi_2154_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1620.unnamed, lt_mask_LightPlace(_e1620.unnamed_1.word, _e1597.y));
                                                            } else {
                                                                let _e1636 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1597.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1642 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1636.unnamed.word, _e1597.y), _e1636.unnamed_1);
                                                                let _e1648 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1642.unnamed, lt_mask_LightPlace(_e1597.z, _e1642.unnamed_1.shift));
                                                                phi_2154_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1648.unnamed, lt_mask_LightPlace(_e1648.unnamed_1.word, _e1597.w));
                                                            }
                                                            let _e1656 = phi_2154_;
                                                            let _e1666 = nodes.member[(0u + _e1466)].z;
                                                            if (_e1250 < 0f) {
                                                                let _e1677 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1666.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1683 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1677.unnamed.word, _e1666.w), _e1677.unnamed_1);
                                                                let _e1689 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1683.unnamed, lt_mask_LightPlace(_e1666.x, _e1683.unnamed_1.shift));
                                                                phi_2181_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1689.unnamed, lt_mask_LightPlace(_e1689.unnamed_1.word, _e1666.y));
                                                            } else {
                                                                let _e1705 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1666.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1711 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1705.unnamed.word, _e1666.y), _e1705.unnamed_1);
                                                                let _e1717 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1711.unnamed, lt_mask_LightPlace(_e1666.z, _e1711.unnamed_1.shift));
                                                                phi_2181_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1717.unnamed, lt_mask_LightPlace(_e1717.unnamed_1.word, _e1666.w));
                                                            }
                                                            let _e1725 = phi_2181_;
                                                            phi_2187_ = 0u;
                                                            phi_2190_ = 0u;
                                                            loop {
                                                                let _e1735 = phi_2187_;
                                                                let _e1737 = phi_2190_;
                                                                local_6 = _e1737;
                                                                local_7 = _e1737;
                                                                local_8 = _e1737;
                                                                let _e1738 = (_e1735 < 8u);
                                                                if _e1738 {
                                                                    let _e1740 = (_e1735 >> bitcast<u32>(2i));
                                                                    let _e1741 = (_e1735 & 3u);
                                                                    if (_e1740 == 0u) {
                                                                        phi_2204_ = _e1587.unnamed.word;
                                                                    } else {
                                                                        phi_2204_ = _e1587.unnamed.shift;
                                                                    }
                                                                    let _e1744 = phi_2204_;
                                                                    if (_e1740 == 0u) {
                                                                        phi_2214_ = _e1656.unnamed.word;
                                                                    } else {
                                                                        phi_2214_ = _e1656.unnamed.shift;
                                                                    }
                                                                    let _e1753 = phi_2214_;
                                                                    if (_e1740 == 0u) {
                                                                        phi_2224_ = _e1725.unnamed.word;
                                                                    } else {
                                                                        phi_2224_ = _e1725.unnamed.shift;
                                                                    }
                                                                    let _e1762 = phi_2224_;
                                                                    let _e1775 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1744 >> bitcast<u32>(((_e1741 * 8u) & 31u))) & 255u)) * _e1500) + (_e1518 - _e1278)), ((f32(((_e1753 >> bitcast<u32>(((_e1741 * 8u) & 31u))) & 255u)) * _e1501) + (_e1519 - _e1279)));
                                                                    let _e1776 = core_intrinsics_maximum_number_nsz_f32_(_e1775, ((f32(((_e1762 >> bitcast<u32>(((_e1741 * 8u) & 31u))) & 255u)) * _e1502) + (_e1520 - _e1280)));
                                                                    if (_e1740 == 0u) {
                                                                        phi_2242_ = _e1587.unnamed_1.word;
                                                                    } else {
                                                                        phi_2242_ = _e1587.unnamed_1.shift;
                                                                    }
                                                                    let _e1779 = phi_2242_;
                                                                    if (_e1740 == 0u) {
                                                                        phi_2252_ = _e1656.unnamed_1.word;
                                                                    } else {
                                                                        phi_2252_ = _e1656.unnamed_1.shift;
                                                                    }
                                                                    let _e1788 = phi_2252_;
                                                                    if (_e1740 == 0u) {
                                                                        phi_2262_ = _e1725.unnamed_1.word;
                                                                    } else {
                                                                        phi_2262_ = _e1725.unnamed_1.shift;
                                                                    }
                                                                    let _e1797 = phi_2262_;
                                                                    let _e1810 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1779 >> bitcast<u32>(((_e1741 * 8u) & 31u))) & 255u)) * _e1500) + (_e1518 + _e1278)), ((f32(((_e1788 >> bitcast<u32>(((_e1741 * 8u) & 31u))) & 255u)) * _e1501) + (_e1519 + _e1279)));
                                                                    let _e1811 = core_intrinsics_minimum_number_nsz_f32_(_e1810, ((f32(((_e1797 >> bitcast<u32>(((_e1741 * 8u) & 31u))) & 255u)) * _e1502) + (_e1520 + _e1280)));
                                                                    if (_e1776 <= _e1811) {
                                                                        if (_e1776 <= _e147) {
                                                                            if (_e1811 >= 0f) {
                                                                                if (_e1740 == 0u) {
                                                                                    let _e1818 = nodes.member[(0u + _e1466)].links[2u];
                                                                                    phi_2298_ = _e1818;
                                                                                } else {
                                                                                    let _e1821 = nodes.member[(0u + _e1466)].links[3u];
                                                                                    phi_2298_ = _e1821;
                                                                                }
                                                                                let _e1823 = phi_2298_;
                                                                                let _e1828 = ((_e1823 >> bitcast<u32>(((_e1741 * 8u) & 31u))) & 255u);
                                                                                let _e1829 = (_e1828 & 31u);
                                                                                if (_e1829 >= 24u) {
                                                                                    phi_2311_ = (24u + ((_e1829 - 24u) ^ _e1328));
                                                                                } else {
                                                                                    phi_2311_ = _e1829;
                                                                                }
                                                                                let _e1835 = phi_2311_;
                                                                                phi_2316_ = (_e1737 | ((_e1828 >> bitcast<u32>(5i)) << bitcast<u32>((_e1835 & 31u))));
                                                                            } else {
                                                                                phi_2316_ = _e1737;
                                                                            }
                                                                            let _e1843 = phi_2316_;
                                                                            phi_2317_ = _e1843;
                                                                        } else {
                                                                            phi_2317_ = _e1737;
                                                                        }
                                                                        let _e1845 = phi_2317_;
                                                                        phi_2318_ = _e1845;
                                                                    } else {
                                                                        phi_2318_ = _e1737;
                                                                    }
                                                                    let _e1847 = phi_2318_;
                                                                    phi_2188_ = (_e1735 + 1u);
                                                                    phi_2191_ = _e1847;
                                                                } else {
                                                                    phi_2188_ = u32();
                                                                    phi_2191_ = u32();
                                                                }
                                                                let _e1850 = phi_2188_;
                                                                let _e1852 = phi_2191_;
                                                                continue;
                                                                continuing {
                                                                    phi_2187_ = _e1850;
                                                                    phi_2190_ = _e1852;
                                                                    break if !(_e1738);
                                                                }
                                                            }
                                                            let _e1856 = nodes.member[(0u + _e1466)].links[0u];
                                                            let _e1860 = nodes.member[(0u + _e1466)].frame[3u];
                                                            let _e1864 = local_6;
                                                            if ((_e1864 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1868 = local_1.group_mask;
                                                                if ((_e1868 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1872 = local_1.len;
                                                                    if (_e1872 < 32u) {
                                                                        let _e1875 = local_1.group;
                                                                        let _e1877 = local_1.len;
                                                                        if (_e1877 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.first[(0u + _e1877)] = _e1875;
                                                                        let _e1883 = local_1.group_mask;
                                                                        let _e1885 = local_1.len;
                                                                        if (_e1885 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.mask[(0u + _e1885)] = _e1883;
                                                                        let _e1892 = local_1.len;
                                                                        local_1.len = (_e1892 + 1u);
                                                                    }
                                                                }
                                                                local_1.group = (_e1090 + _e1856);
                                                                let _e1896 = local_7;
                                                                local_1.group_mask = ((_e1896 & 4278190080u) | (_e1860 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1901 = local_8;
                                                            phi_2376_ = (_e1901 & 16777215u);
                                                            phi_2379_ = _e1468;
                                                            loop {
                                                                let _e1904 = phi_2376_;
                                                                let _e1906 = phi_2379_;
                                                                local_13 = _e1906;
                                                                let _e1907 = (_e1904 == 0u);
                                                                local_9 = _e1907;
                                                                local_15 = _e1907;
                                                                if _e1907 {
                                                                    phi_2377_ = u32();
                                                                    phi_2380_ = bool();
                                                                    phi_3183_ = bool();
                                                                    phi_3184_ = false;
                                                                } else {
                                                                    let _e1910 = nodes.member[(0u + _e1466)].links[1u];
                                                                    let _e1915 = ((_e1092 + _e1910) + select(firstTrailingBit(_e1904), 32u, (_e1904 == 0u)));
                                                                    if (_e1915 < _e81) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1922 = triangles.member[(0u + _e1915)].v0_;
                                                                    let _e1924 = (_e1922.x - _e1021);
                                                                    let _e1926 = (_e1922.y - _e1034);
                                                                    let _e1928 = (_e1922.z - _e1047);
                                                                    if (_e1301 == 0u) {
                                                                        phi_2424_ = vec3<f32>(_e1926, _e1928, _e1924);
                                                                    } else {
                                                                        if (_e1301 == 1u) {
                                                                            phi_2423_ = vec3<f32>(_e1928, _e1924, _e1926);
                                                                        } else {
                                                                            phi_2423_ = (_e1922 - vec3<f32>(_e1021, _e1034, _e1047));
                                                                        }
                                                                        let _e1936 = phi_2423_;
                                                                        phi_2424_ = _e1936;
                                                                    }
                                                                    let _e1938 = phi_2424_;
                                                                    let _e1942 = (_e1938.x - (_e1312 * _e1938.z));
                                                                    let _e1946 = (_e1938.y - (_e1315 * _e1938.z));
                                                                    let _e1948 = triangles.member[(0u + _e1915)].v1_;
                                                                    let _e1950 = (_e1948.x - _e1021);
                                                                    let _e1952 = (_e1948.y - _e1034);
                                                                    let _e1954 = (_e1948.z - _e1047);
                                                                    if (_e1301 == 0u) {
                                                                        phi_2454_ = vec3<f32>(_e1952, _e1954, _e1950);
                                                                    } else {
                                                                        if (_e1301 == 1u) {
                                                                            phi_2453_ = vec3<f32>(_e1954, _e1950, _e1952);
                                                                        } else {
                                                                            phi_2453_ = (_e1948 - vec3<f32>(_e1021, _e1034, _e1047));
                                                                        }
                                                                        let _e1962 = phi_2453_;
                                                                        phi_2454_ = _e1962;
                                                                    }
                                                                    let _e1964 = phi_2454_;
                                                                    let _e1968 = (_e1964.x - (_e1312 * _e1964.z));
                                                                    let _e1972 = (_e1964.y - (_e1315 * _e1964.z));
                                                                    let _e1974 = triangles.member[(0u + _e1915)].v2_;
                                                                    let _e1976 = (_e1974.x - _e1021);
                                                                    let _e1978 = (_e1974.y - _e1034);
                                                                    let _e1980 = (_e1974.z - _e1047);
                                                                    if (_e1301 == 0u) {
                                                                        phi_2484_ = vec3<f32>(_e1978, _e1980, _e1976);
                                                                    } else {
                                                                        if (_e1301 == 1u) {
                                                                            phi_2483_ = vec3<f32>(_e1980, _e1976, _e1978);
                                                                        } else {
                                                                            phi_2483_ = (_e1974 - vec3<f32>(_e1021, _e1034, _e1047));
                                                                        }
                                                                        let _e1988 = phi_2483_;
                                                                        phi_2484_ = _e1988;
                                                                    }
                                                                    let _e1990 = phi_2484_;
                                                                    let _e1994 = (_e1990.x - (_e1312 * _e1990.z));
                                                                    let _e1998 = (_e1990.y - (_e1315 * _e1990.z));
                                                                    if (_e1968 < _e1994) {
                                                                        phi_2503_ = true;
                                                                    } else {
                                                                        if (_e1968 == _e1994) {
                                                                            phi_2502_ = (_e1972 < _e1998);
                                                                        } else {
                                                                            phi_2502_ = false;
                                                                        }
                                                                        let _e2003 = phi_2502_;
                                                                        phi_2503_ = _e2003;
                                                                    }
                                                                    let _e2005 = phi_2503_;
                                                                    if _e2005 {
                                                                        phi_2507_ = _e1998;
                                                                        phi_2508_ = _e1994;
                                                                        phi_2509_ = _e1972;
                                                                        phi_2510_ = _e1968;
                                                                    } else {
                                                                        phi_2507_ = _e1972;
                                                                        phi_2508_ = _e1968;
                                                                        phi_2509_ = _e1998;
                                                                        phi_2510_ = _e1994;
                                                                    }
                                                                    let _e2007 = phi_2507_;
                                                                    let _e2009 = phi_2508_;
                                                                    let _e2011 = phi_2509_;
                                                                    let _e2013 = phi_2510_;
                                                                    let _e2016 = ((_e2013 * _e2007) - (_e2011 * _e2009));
                                                                    if _e2005 {
                                                                        phi_2518_ = -(_e2016);
                                                                    } else {
                                                                        phi_2518_ = _e2016;
                                                                    }
                                                                    let _e2019 = phi_2518_;
                                                                    if (_e1994 < _e1942) {
                                                                        phi_2529_ = true;
                                                                    } else {
                                                                        if (_e1994 == _e1942) {
                                                                            phi_2528_ = (_e1998 < _e1946);
                                                                        } else {
                                                                            phi_2528_ = false;
                                                                        }
                                                                        let _e2024 = phi_2528_;
                                                                        phi_2529_ = _e2024;
                                                                    }
                                                                    let _e2026 = phi_2529_;
                                                                    if _e2026 {
                                                                        phi_2533_ = _e1946;
                                                                        phi_2534_ = _e1942;
                                                                        phi_2535_ = _e1998;
                                                                        phi_2536_ = _e1994;
                                                                    } else {
                                                                        phi_2533_ = _e1998;
                                                                        phi_2534_ = _e1994;
                                                                        phi_2535_ = _e1946;
                                                                        phi_2536_ = _e1942;
                                                                    }
                                                                    let _e2028 = phi_2533_;
                                                                    let _e2030 = phi_2534_;
                                                                    let _e2032 = phi_2535_;
                                                                    let _e2034 = phi_2536_;
                                                                    let _e2037 = ((_e2034 * _e2028) - (_e2032 * _e2030));
                                                                    if _e2026 {
                                                                        phi_2544_ = -(_e2037);
                                                                    } else {
                                                                        phi_2544_ = _e2037;
                                                                    }
                                                                    let _e2040 = phi_2544_;
                                                                    if (_e1942 < _e1968) {
                                                                        phi_2555_ = true;
                                                                    } else {
                                                                        if (_e1942 == _e1968) {
                                                                            phi_2554_ = (_e1946 < _e1972);
                                                                        } else {
                                                                            phi_2554_ = false;
                                                                        }
                                                                        let _e2045 = phi_2554_;
                                                                        phi_2555_ = _e2045;
                                                                    }
                                                                    let _e2047 = phi_2555_;
                                                                    if _e2047 {
                                                                        phi_2559_ = _e1972;
                                                                        phi_2560_ = _e1968;
                                                                        phi_2561_ = _e1946;
                                                                        phi_2562_ = _e1942;
                                                                    } else {
                                                                        phi_2559_ = _e1946;
                                                                        phi_2560_ = _e1942;
                                                                        phi_2561_ = _e1972;
                                                                        phi_2562_ = _e1968;
                                                                    }
                                                                    let _e2049 = phi_2559_;
                                                                    let _e2051 = phi_2560_;
                                                                    let _e2053 = phi_2561_;
                                                                    let _e2055 = phi_2562_;
                                                                    let _e2058 = ((_e2055 * _e2049) - (_e2053 * _e2051));
                                                                    if _e2047 {
                                                                        phi_2570_ = -(_e2058);
                                                                    } else {
                                                                        phi_2570_ = _e2058;
                                                                    }
                                                                    let _e2061 = phi_2570_;
                                                                    if (_e2019 >= 0f) {
                                                                        if (_e2040 >= 0f) {
                                                                            if (_e2061 >= 0f) {
                                                                                phi_2585_ = ((_e2019 + _e2040) + _e2061);
                                                                                phi_2586_ = false;
                                                                            } else {
                                                                                phi_2585_ = f32();
                                                                                phi_2586_ = true;
                                                                            }
                                                                            let _e2068 = phi_2585_;
                                                                            let _e2070 = phi_2586_;
                                                                            phi_2587_ = _e2068;
                                                                            phi_2588_ = _e2070;
                                                                        } else {
                                                                            phi_2587_ = f32();
                                                                            phi_2588_ = true;
                                                                        }
                                                                        let _e2072 = phi_2587_;
                                                                        let _e2074 = phi_2588_;
                                                                        phi_2589_ = _e2072;
                                                                        phi_2590_ = _e2074;
                                                                    } else {
                                                                        phi_2589_ = f32();
                                                                        phi_2590_ = true;
                                                                    }
                                                                    let _e2076 = phi_2589_;
                                                                    let _e2078 = phi_2590_;
                                                                    if _e2078 {
                                                                        if (_e2019 <= 0f) {
                                                                            if (_e2040 <= 0f) {
                                                                                let _e2081 = (_e2061 <= 0f);
                                                                                if _e2081 {
                                                                                }
                                                                                phi_2608_ = ((_e2019 + _e2040) + _e2061);
                                                                                phi_2609_ = false;
                                                                                phi_2610_ = _e2081;
                                                                            } else {
                                                                                phi_2608_ = f32();
                                                                                phi_2609_ = true;
                                                                                phi_2610_ = false;
                                                                            }
                                                                            let _e2085 = phi_2608_;
                                                                            let _e2087 = phi_2609_;
                                                                            let _e2089 = phi_2610_;
                                                                            phi_2611_ = _e2085;
                                                                            phi_2612_ = _e2087;
                                                                            phi_2613_ = _e2089;
                                                                        } else {
                                                                            phi_2611_ = f32();
                                                                            phi_2612_ = true;
                                                                            phi_2613_ = false;
                                                                        }
                                                                        let _e2091 = phi_2611_;
                                                                        let _e2093 = phi_2612_;
                                                                        let _e2095 = phi_2613_;
                                                                        if _e2093 {
                                                                            phi_2617_ = false;
                                                                        } else {
                                                                            phi_2617_ = _e2095;
                                                                        }
                                                                        let _e2097 = phi_2617_;
                                                                        phi_2618_ = _e2091;
                                                                        phi_2619_ = _e2097;
                                                                    } else {
                                                                        phi_2618_ = _e2076;
                                                                        phi_2619_ = true;
                                                                    }
                                                                    let _e2099 = phi_2618_;
                                                                    let _e2101 = phi_2619_;
                                                                    if _e2101 {
                                                                        let _e2102 = (_e2099 == 0f);
                                                                        if _e2102 {
                                                                            phi_2935_ = lt_bvh_triangle_Intersection();
                                                                            phi_2936_ = false;
                                                                        } else {
                                                                            let _e2104 = triangles.member[(0u + _e1915)].v0_;
                                                                            let _e2106 = (_e2104.x - _e1021);
                                                                            let _e2108 = (_e2104.y - _e1034);
                                                                            let _e2110 = (_e2104.z - _e1047);
                                                                            if (_e1301 == 0u) {
                                                                                phi_2648_ = vec3<f32>(_e2108, _e2110, _e2106);
                                                                            } else {
                                                                                if (_e1301 == 1u) {
                                                                                    phi_2647_ = vec3<f32>(_e2110, _e2106, _e2108);
                                                                                } else {
                                                                                    phi_2647_ = (_e2104 - vec3<f32>(_e1021, _e1034, _e1047));
                                                                                }
                                                                                let _e2118 = phi_2647_;
                                                                                phi_2648_ = _e2118;
                                                                            }
                                                                            let _e2120 = phi_2648_;
                                                                            let _e2122 = triangles.member[(0u + _e1915)].v1_;
                                                                            let _e2124 = triangles.member[(0u + _e1915)].v0_;
                                                                            let _e2127 = (_e2122.x - _e2124.x);
                                                                            let _e2130 = (_e2122.y - _e2124.y);
                                                                            let _e2133 = (_e2122.z - _e2124.z);
                                                                            if (_e1301 == 0u) {
                                                                                phi_2674_ = vec3<f32>(_e2130, _e2133, _e2127);
                                                                            } else {
                                                                                if (_e1301 == 1u) {
                                                                                    phi_2673_ = vec3<f32>(_e2133, _e2127, _e2130);
                                                                                } else {
                                                                                    phi_2673_ = (_e2122 - _e2124);
                                                                                }
                                                                                let _e2140 = phi_2673_;
                                                                                phi_2674_ = _e2140;
                                                                            }
                                                                            let _e2142 = phi_2674_;
                                                                            let _e2144 = triangles.member[(0u + _e1915)].v2_;
                                                                            let _e2146 = triangles.member[(0u + _e1915)].v0_;
                                                                            let _e2149 = (_e2144.x - _e2146.x);
                                                                            let _e2152 = (_e2144.y - _e2146.y);
                                                                            let _e2155 = (_e2144.z - _e2146.z);
                                                                            if (_e1301 == 0u) {
                                                                                phi_2700_ = vec3<f32>(_e2152, _e2155, _e2149);
                                                                            } else {
                                                                                if (_e1301 == 1u) {
                                                                                    phi_2699_ = vec3<f32>(_e2155, _e2149, _e2152);
                                                                                } else {
                                                                                    phi_2699_ = (_e2144 - _e2146);
                                                                                }
                                                                                let _e2162 = phi_2699_;
                                                                                phi_2700_ = _e2162;
                                                                            }
                                                                            let _e2164 = phi_2700_;
                                                                            let _e2171 = ((_e2142.y * _e2164.z) - (_e2142.z * _e2164.y));
                                                                            let _e2178 = ((_e2142.z * _e2164.x) - (_e2142.x * _e2164.z));
                                                                            let _e2185 = ((_e2142.x * _e2164.y) - (_e2142.y * _e2164.x));
                                                                            let _e2199 = (((1f / _e1309.z) * (((_e2171 * _e2120.x) + (_e2178 * _e2120.y)) + (_e2185 * _e2120.z))) / (((_e2171 * _e1312) + (_e2178 * _e1315)) + _e2185));
                                                                            if (_e2199 > 0f) {
                                                                                if (_e2199 < _e147) {
                                                                                    let _e2203 = triangles.member[(0u + _e1915)].v0_;
                                                                                    let _e2205 = triangles.member[(0u + _e1915)].v1_;
                                                                                    if (_e2203.x < _e2205.x) {
                                                                                        phi_2756_ = _e2203.x;
                                                                                    } else {
                                                                                        phi_2756_ = _e2205.x;
                                                                                    }
                                                                                    let _e2212 = phi_2756_;
                                                                                    if (_e2203.y < _e2205.y) {
                                                                                        phi_2765_ = _e2203.y;
                                                                                    } else {
                                                                                        phi_2765_ = _e2205.y;
                                                                                    }
                                                                                    let _e2219 = phi_2765_;
                                                                                    if (_e2203.z < _e2205.z) {
                                                                                        phi_2774_ = _e2203.z;
                                                                                    } else {
                                                                                        phi_2774_ = _e2205.z;
                                                                                    }
                                                                                    let _e2226 = phi_2774_;
                                                                                    let _e2228 = triangles.member[(0u + _e1915)].v2_;
                                                                                    if (_e2212 < _e2228.x) {
                                                                                        phi_2783_ = _e2212;
                                                                                    } else {
                                                                                        phi_2783_ = _e2228.x;
                                                                                    }
                                                                                    let _e2233 = phi_2783_;
                                                                                    if (_e2219 < _e2228.y) {
                                                                                        phi_2790_ = _e2219;
                                                                                    } else {
                                                                                        phi_2790_ = _e2228.y;
                                                                                    }
                                                                                    let _e2238 = phi_2790_;
                                                                                    if (_e2226 < _e2228.z) {
                                                                                        phi_2797_ = _e2226;
                                                                                    } else {
                                                                                        phi_2797_ = _e2228.z;
                                                                                    }
                                                                                    let _e2243 = phi_2797_;
                                                                                    let _e2245 = triangles.member[(0u + _e1915)].v0_;
                                                                                    let _e2247 = triangles.member[(0u + _e1915)].v1_;
                                                                                    if (_e2245.x > _e2247.x) {
                                                                                        phi_2810_ = _e2245.x;
                                                                                    } else {
                                                                                        phi_2810_ = _e2247.x;
                                                                                    }
                                                                                    let _e2254 = phi_2810_;
                                                                                    if (_e2245.y > _e2247.y) {
                                                                                        phi_2819_ = _e2245.y;
                                                                                    } else {
                                                                                        phi_2819_ = _e2247.y;
                                                                                    }
                                                                                    let _e2261 = phi_2819_;
                                                                                    if (_e2245.z > _e2247.z) {
                                                                                        phi_2828_ = _e2245.z;
                                                                                    } else {
                                                                                        phi_2828_ = _e2247.z;
                                                                                    }
                                                                                    let _e2268 = phi_2828_;
                                                                                    let _e2270 = triangles.member[(0u + _e1915)].v2_;
                                                                                    if (_e2254 > _e2270.x) {
                                                                                        phi_2837_ = _e2254;
                                                                                    } else {
                                                                                        phi_2837_ = _e2270.x;
                                                                                    }
                                                                                    let _e2275 = phi_2837_;
                                                                                    if (_e2261 > _e2270.y) {
                                                                                        phi_2844_ = _e2261;
                                                                                    } else {
                                                                                        phi_2844_ = _e2270.y;
                                                                                    }
                                                                                    let _e2280 = phi_2844_;
                                                                                    if (_e2268 > _e2270.z) {
                                                                                        phi_2851_ = _e2268;
                                                                                    } else {
                                                                                        phi_2851_ = _e2270.z;
                                                                                    }
                                                                                    let _e2285 = phi_2851_;
                                                                                    let _e2289 = ((_e2233 - _e1021) * _e1230);
                                                                                    let _e2290 = ((_e2238 - _e1034) * _e1240);
                                                                                    let _e2291 = ((_e2243 - _e1047) * _e1250);
                                                                                    let _e2295 = ((_e2275 - _e1021) * _e1230);
                                                                                    let _e2296 = ((_e2280 - _e1034) * _e1240);
                                                                                    let _e2297 = ((_e2285 - _e1047) * _e1250);
                                                                                    if (_e2289 < _e2295) {
                                                                                        phi_2868_ = _e2289;
                                                                                    } else {
                                                                                        phi_2868_ = _e2295;
                                                                                    }
                                                                                    let _e2300 = phi_2868_;
                                                                                    if (_e2290 < _e2296) {
                                                                                        phi_2873_ = _e2290;
                                                                                    } else {
                                                                                        phi_2873_ = _e2296;
                                                                                    }
                                                                                    let _e2303 = phi_2873_;
                                                                                    if (_e2291 < _e2297) {
                                                                                        phi_2878_ = _e2291;
                                                                                    } else {
                                                                                        phi_2878_ = _e2297;
                                                                                    }
                                                                                    let _e2306 = phi_2878_;
                                                                                    if (_e2289 > _e2295) {
                                                                                        phi_2886_ = _e2289;
                                                                                    } else {
                                                                                        phi_2886_ = _e2295;
                                                                                    }
                                                                                    let _e2312 = phi_2886_;
                                                                                    if (_e2290 > _e2296) {
                                                                                        phi_2891_ = _e2290;
                                                                                    } else {
                                                                                        phi_2891_ = _e2296;
                                                                                    }
                                                                                    let _e2315 = phi_2891_;
                                                                                    if (_e2291 > _e2297) {
                                                                                        phi_2896_ = _e2291;
                                                                                    } else {
                                                                                        phi_2896_ = _e2297;
                                                                                    }
                                                                                    let _e2318 = phi_2896_;
                                                                                    let _e2322 = core_intrinsics_maximum_number_nsz_f32_((_e2300 - _e1285), (_e2303 - _e1286));
                                                                                    let _e2323 = core_intrinsics_maximum_number_nsz_f32_(_e2322, (_e2306 - _e1287));
                                                                                    let _e2324 = core_intrinsics_minimum_number_nsz_f32_((_e2312 + _e1285), (_e2315 + _e1286));
                                                                                    let _e2325 = core_intrinsics_minimum_number_nsz_f32_(_e2324, (_e2318 + _e1287));
                                                                                    if (_e2323 > _e1002) {
                                                                                        phi_2908_ = _e2323;
                                                                                    } else {
                                                                                        phi_2908_ = _e1002;
                                                                                    }
                                                                                    let _e2328 = phi_2908_;
                                                                                    if (_e2325 < _e1004) {
                                                                                        phi_2913_ = _e2325;
                                                                                    } else {
                                                                                        phi_2913_ = _e1004;
                                                                                    }
                                                                                    let _e2331 = phi_2913_;
                                                                                    if (_e2199 < _e2328) {
                                                                                        phi_2918_ = _e2328;
                                                                                    } else {
                                                                                        phi_2918_ = _e2199;
                                                                                    }
                                                                                    let _e2334 = phi_2918_;
                                                                                    if (_e2334 > _e2331) {
                                                                                        phi_2923_ = _e2331;
                                                                                    } else {
                                                                                        phi_2923_ = _e2334;
                                                                                    }
                                                                                    let _e2337 = phi_2923_;
                                                                                    phi_2928_ = lt_bvh_triangle_Intersection(_e2337, (_e2040 / _e2099), (_e2061 / _e2099), (_e2328 <= _e2331));
                                                                                    phi_2929_ = false;
                                                                                } else {
                                                                                    phi_2928_ = lt_bvh_triangle_Intersection();
                                                                                    phi_2929_ = true;
                                                                                }
                                                                                let _e2343 = phi_2928_;
                                                                                let _e2345 = phi_2929_;
                                                                                phi_2930_ = _e2343;
                                                                                phi_2931_ = _e2345;
                                                                            } else {
                                                                                phi_2930_ = lt_bvh_triangle_Intersection();
                                                                                phi_2931_ = true;
                                                                            }
                                                                            let _e2347 = phi_2930_;
                                                                            let _e2349 = phi_2931_;
                                                                            if _e2349 {
                                                                            }
                                                                            phi_2935_ = _e2347;
                                                                            phi_2936_ = _e2349;
                                                                        }
                                                                        let _e2351 = phi_2935_;
                                                                        let _e2353 = phi_2936_;
                                                                        phi_2937_ = _e2351;
                                                                        phi_2938_ = _e2102;
                                                                        phi_2939_ = _e2353;
                                                                    } else {
                                                                        phi_2937_ = lt_bvh_triangle_Intersection();
                                                                        phi_2938_ = true;
                                                                        phi_2939_ = false;
                                                                    }
                                                                    let _e2355 = phi_2937_;
                                                                    let _e2357 = phi_2938_;
                                                                    let _e2359 = phi_2939_;
                                                                    if _e2357 {
                                                                        phi_2943_ = true;
                                                                    } else {
                                                                        phi_2943_ = _e2359;
                                                                    }
                                                                    let _e2361 = phi_2943_;
                                                                    if _e2361 {
                                                                        phi_2947_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_2947_ = _e2355;
                                                                    }
                                                                    let _e2363 = phi_2947_;
                                                                    if _e2363.is_hit {
                                                                        if (_e2363.t > 0f) {
                                                                            if (_e2363.t < _e147) {
                                                                                let _e2370 = triangles.member[(0u + _e1915)].i0_;
                                                                                if ((_e2370 & 2147483648u) == 0u) {
                                                                                    phi_3166_ = true;
                                                                                } else {
                                                                                    if (_e1915 < _e81) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2379 = triangles.member[(0u + _e1915)].i0_;
                                                                                    let _e2380 = (_e2379 & 2147483647u);
                                                                                    let _e2382 = triangles.member[(0u + _e1915)].i1_;
                                                                                    let _e2384 = triangles.member[(0u + _e1915)].i2_;
                                                                                    if (_e2380 < _e96) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2388 = vertices.member[(0u + _e2380)];
                                                                                    if (_e2382 < _e96) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2392 = vertices.member[(0u + _e2382)];
                                                                                    if (_e2384 < _e96) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2396 = vertices.member[(0u + _e2384)];
                                                                                    let _e2397 = array<abi_Vertex, 3>(_e2388, _e2392, _e2396);
                                                                                    if (_e2397[0].material < arrayLength((&materials.member))) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2403 = materials.member[(0u + _e2397[0].material)];
                                                                                    if ((_e2403.flags & 1u) == 1u) {
                                                                                        let _e2408 = ((1f - _e2363.u) - _e2363.v);
                                                                                        if (_e2403.cutoff <= 0f) {
                                                                                            phi_3164_ = true;
                                                                                        } else {
                                                                                            let _e2435 = (_e2403.base_color.w * ((((f32((_e2397[0].color >> bitcast<u32>(24i))) * _e2408) + (f32((_e2397[1].color >> bitcast<u32>(24i))) * _e2363.u)) + (f32((_e2397[2].color >> bitcast<u32>(24i))) * _e2363.v)) * (1f / 255f)));
                                                                                            if (_e2403.alpha_size == 0u) {
                                                                                                phi_3161_ = _e2435;
                                                                                            } else {
                                                                                                local.offset = _e2403.alpha_offset;
                                                                                                local.size = _e2403.alpha_size;
                                                                                                local.flags = _e2403.flags;
                                                                                                let _e2466 = _lt_shaders_texture_TextureView_quad((&local), (((_e2397[0].u * _e2408) + (_e2397[1].u * _e2363.u)) + (_e2397[2].u * _e2363.v)), (((_e2397[0].v * _e2408) + (_e2397[1].v * _e2363.u)) + (_e2397[2].v * _e2363.v)));
                                                                                                let _e2470 = (_e2466.indices[0] >> bitcast<u32>(2i));
                                                                                                if (_e2470 < _e102) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2474 = alpha_texels.member[(0u + _e2470)];
                                                                                                let _e2490 = (_e2466.indices[1] >> bitcast<u32>(2i));
                                                                                                if (_e2490 < _e102) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2494 = alpha_texels.member[(0u + _e2490)];
                                                                                                let _e2511 = (_e2466.indices[2] >> bitcast<u32>(2i));
                                                                                                if (_e2511 < _e102) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2515 = alpha_texels.member[(0u + _e2511)];
                                                                                                let _e2532 = (_e2466.indices[3] >> bitcast<u32>(2i));
                                                                                                if (_e2532 < _e102) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2536 = alpha_texels.member[(0u + _e2532)];
                                                                                                phi_3161_ = (_e2435 * (((((f32(((_e2474 >> bitcast<u32>((((_e2466.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2466.weights.x) + ((f32(((_e2494 >> bitcast<u32>((((_e2466.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2466.weights.y)) + ((f32(((_e2515 >> bitcast<u32>((((_e2466.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2466.weights.z)) + ((f32(((_e2536 >> bitcast<u32>((((_e2466.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2466.weights.w)));
                                                                                            }
                                                                                            let _e2552 = phi_3161_;
                                                                                            phi_3164_ = (_e2552 >= _e2403.cutoff);
                                                                                        }
                                                                                        let _e2556 = phi_3164_;
                                                                                        phi_3165_ = _e2556;
                                                                                    } else {
                                                                                        phi_3165_ = false;
                                                                                    }
                                                                                    let _e2558 = phi_3165_;
                                                                                    phi_3166_ = _e2558;
                                                                                }
                                                                                let _e2560 = phi_3166_;
                                                                                if _e2560 {
                                                                                    phi_3170_ = false;
                                                                                } else {
                                                                                    phi_3170_ = true;
                                                                                }
                                                                                let _e2562 = phi_3170_;
                                                                                phi_3171_ = _e2560;
                                                                                phi_3172_ = _e2560;
                                                                                phi_3173_ = _e2562;
                                                                            } else {
                                                                                phi_3171_ = bool();
                                                                                phi_3172_ = _e1906;
                                                                                phi_3173_ = true;
                                                                            }
                                                                            let _e2564 = phi_3171_;
                                                                            let _e2566 = phi_3172_;
                                                                            let _e2568 = phi_3173_;
                                                                            phi_3174_ = _e2564;
                                                                            phi_3175_ = _e2566;
                                                                            phi_3176_ = _e2568;
                                                                        } else {
                                                                            phi_3174_ = bool();
                                                                            phi_3175_ = _e1906;
                                                                            phi_3176_ = true;
                                                                        }
                                                                        let _e2570 = phi_3174_;
                                                                        let _e2572 = phi_3175_;
                                                                        let _e2574 = phi_3176_;
                                                                        phi_3177_ = _e2570;
                                                                        phi_3178_ = _e2572;
                                                                        phi_3179_ = _e2574;
                                                                    } else {
                                                                        phi_3177_ = bool();
                                                                        phi_3178_ = _e1906;
                                                                        phi_3179_ = true;
                                                                    }
                                                                    let _e2576 = phi_3177_;
                                                                    let _e2578 = phi_3178_;
                                                                    let _e2580 = phi_3179_;
                                                                    if _e2580 {
                                                                    }
                                                                    phi_2377_ = (_e1904 & (_e1904 - 1u));
                                                                    phi_2380_ = _e2578;
                                                                    phi_3183_ = _e2576;
                                                                    phi_3184_ = _e2580;
                                                                }
                                                                let _e2582 = phi_2377_;
                                                                let _e2584 = phi_2380_;
                                                                let _e2586 = phi_3183_;
                                                                let _e2588 = phi_3184_;
                                                                local_14 = _e2586;
                                                                continue;
                                                                continuing {
                                                                    phi_2376_ = _e2582;
                                                                    phi_2379_ = _e2584;
                                                                    break if !(_e2588);
                                                                }
                                                            }
                                                            let _e2591 = local_9;
                                                            if _e2591 {
                                                                let _e2593 = local_1.group_mask;
                                                                if ((_e2593 & 4278190080u) == 0u) {
                                                                    let _e2597 = local_1.len;
                                                                    if (_e2597 == 0u) {
                                                                        phi_3226_ = false;
                                                                    } else {
                                                                        let _e2601 = local_1.len;
                                                                        local_1.len = (_e2601 - 1u);
                                                                        let _e2604 = local_1.len;
                                                                        if (_e2604 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2609 = local_1.first[(0u + _e2604)];
                                                                        local_1.group = _e2609;
                                                                        let _e2612 = local_1.len;
                                                                        if (_e2612 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2617 = local_1.mask[(0u + _e2612)];
                                                                        local_1.group_mask = _e2617;
                                                                        phi_3226_ = true;
                                                                    }
                                                                    let _e2620 = phi_3226_;
                                                                    phi_3227_ = _e2620;
                                                                } else {
                                                                    phi_3227_ = true;
                                                                }
                                                                let _e2622 = phi_3227_;
                                                                if _e2622 {
                                                                    let _e2624 = local_1.group_mask;
                                                                    let _e2630 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2624)), 32u, (_e2624 == 0u)));
                                                                    let _e2634 = local_1.group_mask;
                                                                    let _e2648 = local_1.group_mask;
                                                                    local_1.group_mask = (_e2648 & ~((1u << bitcast<u32>((_e2630 & 31u)))));
                                                                    let _e2651 = local_1.group;
                                                                    phi_3258_ = (_e2651 + countOneBits(((_e2634 & ~((4294967295u << bitcast<u32>((((_e2630 - 24u) ^ _e1328) & 31u))))) & 255u)));
                                                                } else {
                                                                    phi_3258_ = 4294967295u;
                                                                }
                                                                let _e2654 = phi_3258_;
                                                                phi_3259_ = _e2654;
                                                            } else {
                                                                phi_3259_ = u32();
                                                            }
                                                            let _e2656 = phi_3259_;
                                                            phi_2045_ = _e2656;
                                                            let _e3136 = local_13;
                                                            phi_2048_ = _e3136;
                                                            let _e3139 = local_14;
                                                            phi_3260_ = _e3139;
                                                            let _e3142 = local_15;
                                                            phi_3261_ = _e3142;
                                                            phi_3262_ = false;
                                                        } else {
                                                            phi_2045_ = u32();
                                                            phi_2048_ = bool();
                                                            phi_3260_ = bool();
                                                            phi_3261_ = false;
                                                            phi_3262_ = true;
                                                        }
                                                        let _e2658 = phi_2045_;
                                                        let _e2660 = phi_2048_;
                                                        let _e2662 = phi_3260_;
                                                        let _e2664 = phi_3261_;
                                                        let _e2666 = phi_3262_;
                                                        local_10 = _e2666;
                                                        local_16 = _e2662;
                                                        continue;
                                                        continuing {
                                                            phi_2044_ = _e2658;
                                                            phi_2047_ = _e2660;
                                                            break if !(_e2664);
                                                        }
                                                    }
                                                    let _e2669 = local_10;
                                                    if _e2669 {
                                                        phi_3266_ = false;
                                                    } else {
                                                        phi_3266_ = true;
                                                    }
                                                    let _e2671 = phi_3266_;
                                                    if _e2671 {
                                                        let _e3148 = local_16;
                                                        phi_3270_ = _e3148;
                                                    } else {
                                                        let _e3150 = local_17;
                                                        phi_3270_ = _e3150;
                                                    }
                                                    let _e2673 = phi_3270_;
                                                    phi_3271_ = _e2673;
                                                }
                                                let _e2675 = phi_3271_;
                                                phi_3272_ = _e2675;
                                                phi_3273_ = _e1154;
                                            } else {
                                                phi_3272_ = bool();
                                                phi_3273_ = true;
                                            }
                                            let _e2677 = phi_3272_;
                                            let _e2679 = phi_3273_;
                                            if _e2679 {
                                                phi_3277_ = _e941;
                                            } else {
                                                phi_3277_ = _e2677;
                                            }
                                            let _e2681 = phi_3277_;
                                            if _e2681 {
                                                phi_3281_ = false;
                                            } else {
                                                phi_3281_ = true;
                                            }
                                            let _e2683 = phi_3281_;
                                            phi_3282_ = _e2681;
                                            phi_3283_ = _e2683;
                                        } else {
                                            phi_3282_ = _e941;
                                            phi_3283_ = true;
                                        }
                                        let _e2685 = phi_3282_;
                                        let _e2687 = phi_3283_;
                                        phi_3284_ = _e2685;
                                        phi_3285_ = _e2687;
                                    } else {
                                        phi_3284_ = _e941;
                                        phi_3285_ = true;
                                    }
                                    let _e2689 = phi_3284_;
                                    let _e2691 = phi_3285_;
                                    phi_3286_ = _e2689;
                                    phi_3287_ = _e2691;
                                } else {
                                    phi_3286_ = _e941;
                                    phi_3287_ = true;
                                }
                                let _e2693 = phi_3286_;
                                let _e2695 = phi_3287_;
                                if _e2695 {
                                }
                                phi_1437_ = (_e939 & (_e939 - 1u));
                                phi_1440_ = _e2693;
                                phi_3291_ = _e2695;
                            }
                            let _e2697 = phi_1437_;
                            let _e2699 = phi_1440_;
                            let _e2701 = phi_3291_;
                            continue;
                            continuing {
                                phi_1436_ = _e2697;
                                phi_1439_ = _e2699;
                                break if !(_e2701);
                            }
                        }
                        let _e2704 = local_11;
                        if _e2704 {
                            let _e2706 = local_2.group_mask;
                            if ((_e2706 & 4278190080u) == 0u) {
                                let _e2710 = local_2.len;
                                if (_e2710 == 0u) {
                                    phi_3333_ = false;
                                } else {
                                    let _e2714 = local_2.len;
                                    local_2.len = (_e2714 - 1u);
                                    let _e2717 = local_2.len;
                                    if (_e2717 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2722 = local_2.first[(0u + _e2717)];
                                    local_2.group = _e2722;
                                    let _e2725 = local_2.len;
                                    if (_e2725 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2730 = local_2.mask[(0u + _e2725)];
                                    local_2.group_mask = _e2730;
                                    phi_3333_ = true;
                                }
                                let _e2733 = phi_3333_;
                                phi_3334_ = _e2733;
                            } else {
                                phi_3334_ = true;
                            }
                            let _e2735 = phi_3334_;
                            if _e2735 {
                                let _e2737 = local_2.group_mask;
                                let _e2743 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2737)), 32u, (_e2737 == 0u)));
                                let _e2747 = local_2.group_mask;
                                let _e2761 = local_2.group_mask;
                                local_2.group_mask = (_e2761 & ~((1u << bitcast<u32>((_e2743 & 31u)))));
                                let _e2764 = local_2.group;
                                phi_3365_ = (_e2764 + countOneBits(((_e2747 & ~((4294967295u << bitcast<u32>((((_e2743 - 24u) ^ _e363) & 31u))))) & 255u)));
                            } else {
                                phi_3365_ = 4294967295u;
                            }
                            let _e2767 = phi_3365_;
                            phi_3366_ = _e2767;
                        } else {
                            phi_3366_ = u32();
                        }
                        let _e2769 = phi_3366_;
                        phi_1105_ = _e2769;
                        let _e3173 = local_18;
                        phi_1108_ = _e3173;
                        let _e3176 = local_19;
                        phi_3367_ = _e3176;
                        phi_3368_ = false;
                    } else {
                        phi_1105_ = u32();
                        phi_1108_ = bool();
                        phi_3367_ = false;
                        phi_3368_ = true;
                    }
                    let _e2771 = phi_1105_;
                    let _e2773 = phi_1108_;
                    let _e2775 = phi_3367_;
                    let _e2777 = phi_3368_;
                    local_12 = _e2777;
                    continue;
                    continuing {
                        phi_1104_ = _e2771;
                        phi_1107_ = _e2773;
                        break if !(_e2775);
                    }
                }
                let _e2780 = local_12;
                if _e2780 {
                    phi_3372_ = false;
                } else {
                    phi_3372_ = true;
                }
                let _e2782 = phi_3372_;
                if _e2782 {
                }
                phi_3376_ = _e2782;
            }
            let _e2784 = phi_3376_;
            phi_3377_ = _e219;
            phi_3378_ = _e2784;
        } else {
            phi_3377_ = true;
            phi_3378_ = false;
        }
        let _e2786 = phi_3377_;
        let _e2788 = phi_3378_;
        if _e2786 {
            phi_3382_ = false;
            phi_3383_ = true;
        } else {
            phi_3382_ = true;
            phi_3383_ = _e2788;
        }
        let _e2790 = phi_3382_;
        let _e2792 = phi_3383_;
        if _e2792 {
            phi_3387_ = _e2790;
        } else {
            phi_3387_ = false;
        }
        let _e2794 = phi_3387_;
        if _e2794 {
            phi_3391_ = 0f;
        } else {
            phi_3391_ = 1f;
        }
        let _e2796 = phi_3391_;
        if (_e115 < _e84) {
        } else {
            return;
        }
        visibility.member[(0u + _e115)] = _e2796;
        let _e2802 = p.member.light.number;
        let _e2803 = (_e2802 * 3u);
        let _e2804 = (_e2803 / 32u);
        let _e2805 = (_e2803 % 32u);
        let _e2807 = p.member.light.mask_words;
        if (_e115 < _e84) {
        } else {
            return;
        }
        let _e2811 = visibility.member[(0u + _e115)];
        let _e2813 = ((_e115 * _e2807) + _e2804);
        if (_e2805 > 29u) {
            let _e2815 = (_e2813 + 1u);
            if (_e2815 < _e90) {
            } else {
                return;
            }
            let _e2819 = bits.member[(0u + _e2815)];
            phi_3432_ = _e2819;
        } else {
            phi_3432_ = 0u;
        }
        let _e2821 = phi_3432_;
        if (_e2813 < _e90) {
        } else {
            return;
        }
        let _e2825 = bits.member[(0u + _e2813)];
        let _e2828 = (_e2825 >> bitcast<u32>((_e2805 & 31u)));
        if (_e2805 > 29u) {
            phi_3451_ = (_e2828 | (_e2821 << bitcast<u32>(((32u - _e2805) & 31u))));
        } else {
            phi_3451_ = _e2828;
        }
        let _e2836 = phi_3451_;
        if ((_e2836 & 2u) == 0u) {
            phi_3459_ = (_e2836 & 1u);
        } else {
            phi_3459_ = (_e2836 & 7u);
        }
        let _e2842 = phi_3459_;
        if ((_e2842 & 1u) != 0u) {
            phi_3467_ = (2u | 1u);
        } else {
            phi_3467_ = 2u;
        }
        let _e2848 = phi_3467_;
        if (_e2811 < 0.5f) {
            phi_3472_ = (_e2848 | 4u);
        } else {
            phi_3472_ = _e2848;
        }
        let _e2851 = phi_3472_;
        let _e2853 = ((_e115 * _e2807) + _e2804);
        if (_e2853 < _e90) {
        } else {
            return;
        }
        let _e2857 = bits.member[(0u + _e2853)];
        if (_e2853 < _e90) {
        } else {
            return;
        }
        bits.member[(0u + _e2853)] = ((_e2857 & ~((7u << bitcast<u32>((_e2805 & 31u))))) | (_e2851 << bitcast<u32>((_e2805 & 31u))));
        if (_e2805 > 29u) {
            let _e2871 = (_e2853 + 1u);
            if (_e2871 < _e90) {
            } else {
                return;
            }
            let _e2875 = bits.member[(0u + _e2871)];
            let _e2876 = (32u - _e2805);
            let _e2886 = (_e2853 + 1u);
            if (_e2886 < _e90) {
            } else {
                return;
            }
            bits.member[(0u + _e2886)] = ((_e2875 & ~((7u >> bitcast<u32>((_e2876 & 31u))))) | (_e2851 >> bitcast<u32>((_e2876 & 31u))));
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_learn_instanced_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
