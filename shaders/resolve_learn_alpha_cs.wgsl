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
@group(0) @binding(5) 
var<storage> list: type_13;
@group(0) @binding(6) 
var<storage, read_write> bits: type_13;
@group(0) @binding(7) 
var<storage> vertices: type_45;
@group(0) @binding(8) 
var<storage> materials: type_49;
@group(0) @binding(9) 
var<storage> alpha_texels: type_13;

fn core_intrinsics_maximum_number_nsz_f32_(param: f32, param_1: f32) -> f32 {
    var phi_202_: bool;
    var phi_206_: f32;

    if (param != param) {
        phi_202_ = true;
    } else {
        let _e71 = (param_1 >= param);
        if _e71 {
        }
        phi_202_ = _e71;
    }
    let _e73 = phi_202_;
    if _e73 {
        phi_206_ = param_1;
    } else {
        phi_206_ = param;
    }
    let _e75 = phi_206_;
    return _e75;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_2: f32, param_3: f32) -> f32 {
    var phi_218_: bool;
    var phi_222_: f32;

    if (param_2 != param_2) {
        phi_218_ = true;
    } else {
        let _e71 = (param_3 <= param_2);
        if _e71 {
        }
        phi_218_ = _e71;
    }
    let _e73 = phi_218_;
    if _e73 {
        phi_222_ = param_3;
    } else {
        phi_222_ = param_2;
    }
    let _e75 = phi_222_;
    return _e75;
}

fn _lt_shaders_texture_TextureView_quad(param_4: ptr<function, texture_TextureView>, param_5: f32, param_6: f32) -> texture_TexelQuad {
    var phi_264_: f32;
    var phi_269_: f32;
    var phi_270_: bool;
    var phi_271_: f32;
    var phi_272_: bool;
    var phi_276_: f32;
    var phi_302_: f32;
    var phi_307_: f32;
    var phi_308_: bool;
    var phi_309_: f32;
    var phi_310_: bool;
    var phi_314_: f32;
    var phi_322_: f32;
    var phi_323_: f32;
    var phi_324_: f32;
    var phi_333_: f32;
    var phi_334_: f32;
    var phi_352_: u32;
    var phi_366_: u32;
    var phi_373_: u32;
    var phi_378_: u32;
    var phi_384_: u32;
    var phi_389_: u32;
    var phi_391_: texture_Axis;
    var phi_419_: f32;
    var phi_424_: f32;
    var phi_425_: bool;
    var phi_426_: f32;
    var phi_427_: bool;
    var phi_431_: f32;
    var phi_457_: f32;
    var phi_462_: f32;
    var phi_463_: bool;
    var phi_464_: f32;
    var phi_465_: bool;
    var phi_469_: f32;
    var phi_477_: f32;
    var phi_478_: f32;
    var phi_479_: f32;
    var phi_488_: f32;
    var phi_489_: f32;
    var phi_507_: u32;
    var phi_521_: u32;
    var phi_528_: u32;
    var phi_533_: u32;
    var phi_539_: u32;
    var phi_544_: u32;
    var phi_546_: texture_Axis;

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
                phi_264_ = 1f;
            } else {
                phi_264_ = 0f;
            }
            let _e102 = phi_264_;
            if (param_5 < 8388608f) {
                phi_269_ = (_e99 - _e102);
                phi_270_ = false;
            } else {
                phi_269_ = f32();
                phi_270_ = true;
            }
            let _e105 = phi_269_;
            let _e107 = phi_270_;
            phi_271_ = _e105;
            phi_272_ = _e107;
        } else {
            phi_271_ = f32();
            phi_272_ = true;
        }
        let _e109 = phi_271_;
        let _e111 = phi_272_;
        if _e111 {
            phi_276_ = param_5;
        } else {
            phi_276_ = _e109;
        }
        let _e113 = phi_276_;
        phi_324_ = (param_5 - _e113);
    } else {
        if (_e86 == 1u) {
            let _e116 = (param_5 * 0.5f);
            if (_e116 > -8388608f) {
                let _e128 = f32(select(0i, select(select(i32(_e116), i32(-2147483648), (_e116 < bitcast<f32>(3472883712u))), 2147483647i, (_e116 > bitcast<f32>(1325400063u))), (_e116 == _e116)));
                if (_e128 > _e116) {
                    phi_302_ = 1f;
                } else {
                    phi_302_ = 0f;
                }
                let _e131 = phi_302_;
                if (_e116 < 8388608f) {
                    phi_307_ = (_e128 - _e131);
                    phi_308_ = false;
                } else {
                    phi_307_ = f32();
                    phi_308_ = true;
                }
                let _e134 = phi_307_;
                let _e136 = phi_308_;
                phi_309_ = _e134;
                phi_310_ = _e136;
            } else {
                phi_309_ = f32();
                phi_310_ = true;
            }
            let _e138 = phi_309_;
            let _e140 = phi_310_;
            if _e140 {
                phi_314_ = _e116;
            } else {
                phi_314_ = _e138;
            }
            let _e142 = phi_314_;
            let _e144 = (param_5 - (2f * _e142));
            if (_e144 > 1f) {
                phi_322_ = (2f - _e144);
            } else {
                phi_322_ = _e144;
            }
            let _e148 = phi_322_;
            phi_323_ = _e148;
        } else {
            phi_323_ = param_5;
        }
        let _e150 = phi_323_;
        phi_324_ = _e150;
    }
    let _e152 = phi_324_;
    if (_e152 > 0f) {
        if (_e152 < 1f) {
            phi_333_ = _e152;
        } else {
            phi_333_ = 1f;
        }
        let _e156 = phi_333_;
        phi_334_ = _e156;
    } else {
        phi_334_ = 0f;
    }
    let _e158 = phi_334_;
    let _e159 = (_e73 - 1u);
    let _e161 = (_e158 * f32(_e73));
    if _e81 {
        let _e168 = select(select(u32(_e161), 0u, (_e161 < bitcast<f32>(0u))), 4294967295u, (_e161 > bitcast<f32>(1333788671u)));
        if (_e159 < _e168) {
            phi_352_ = _e159;
        } else {
            phi_352_ = _e168;
        }
        let _e171 = phi_352_;
        phi_391_ = texture_Axis(_e171, _e171, 0f);
    } else {
        let _e173 = (_e161 + 0.5f);
        let _e180 = select(select(u32(_e173), 0u, (_e173 < bitcast<f32>(0u))), 4294967295u, (_e173 > bitcast<f32>(1333788671u)));
        if (_e73 < _e180) {
            phi_366_ = _e73;
        } else {
            phi_366_ = _e180;
        }
        let _e183 = phi_366_;
        if (_e86 == 0u) {
            phi_373_ = _e159;
        } else {
            phi_373_ = 0u;
        }
        let _e188 = phi_373_;
        if (_e86 == 0u) {
            phi_378_ = 0u;
        } else {
            phi_378_ = _e159;
        }
        let _e191 = phi_378_;
        if (_e183 == 0u) {
            phi_384_ = _e188;
        } else {
            phi_384_ = (_e183 - 1u);
        }
        let _e195 = phi_384_;
        if (_e183 > _e159) {
            phi_389_ = _e191;
        } else {
            phi_389_ = _e183;
        }
        let _e198 = phi_389_;
        phi_391_ = texture_Axis(_e195, _e198, (_e173 - f32(_e183)));
    }
    let _e201 = phi_391_;
    let _e203 = (*param_4).flags;
    let _e206 = ((_e203 >> bitcast<u32>(6u)) & 3u);
    if (_e206 == 0u) {
        if (param_6 > -8388608f) {
            let _e219 = f32(select(0i, select(select(i32(param_6), i32(-2147483648), (param_6 < bitcast<f32>(3472883712u))), 2147483647i, (param_6 > bitcast<f32>(1325400063u))), (param_6 == param_6)));
            if (_e219 > param_6) {
                phi_419_ = 1f;
            } else {
                phi_419_ = 0f;
            }
            let _e222 = phi_419_;
            if (param_6 < 8388608f) {
                phi_424_ = (_e219 - _e222);
                phi_425_ = false;
            } else {
                phi_424_ = f32();
                phi_425_ = true;
            }
            let _e225 = phi_424_;
            let _e227 = phi_425_;
            phi_426_ = _e225;
            phi_427_ = _e227;
        } else {
            phi_426_ = f32();
            phi_427_ = true;
        }
        let _e229 = phi_426_;
        let _e231 = phi_427_;
        if _e231 {
            phi_431_ = param_6;
        } else {
            phi_431_ = _e229;
        }
        let _e233 = phi_431_;
        phi_479_ = (param_6 - _e233);
    } else {
        if (_e206 == 1u) {
            let _e236 = (param_6 * 0.5f);
            if (_e236 > -8388608f) {
                let _e248 = f32(select(0i, select(select(i32(_e236), i32(-2147483648), (_e236 < bitcast<f32>(3472883712u))), 2147483647i, (_e236 > bitcast<f32>(1325400063u))), (_e236 == _e236)));
                if (_e248 > _e236) {
                    phi_457_ = 1f;
                } else {
                    phi_457_ = 0f;
                }
                let _e251 = phi_457_;
                if (_e236 < 8388608f) {
                    phi_462_ = (_e248 - _e251);
                    phi_463_ = false;
                } else {
                    phi_462_ = f32();
                    phi_463_ = true;
                }
                let _e254 = phi_462_;
                let _e256 = phi_463_;
                phi_464_ = _e254;
                phi_465_ = _e256;
            } else {
                phi_464_ = f32();
                phi_465_ = true;
            }
            let _e258 = phi_464_;
            let _e260 = phi_465_;
            if _e260 {
                phi_469_ = _e236;
            } else {
                phi_469_ = _e258;
            }
            let _e262 = phi_469_;
            let _e264 = (param_6 - (2f * _e262));
            if (_e264 > 1f) {
                phi_477_ = (2f - _e264);
            } else {
                phi_477_ = _e264;
            }
            let _e268 = phi_477_;
            phi_478_ = _e268;
        } else {
            phi_478_ = param_6;
        }
        let _e270 = phi_478_;
        phi_479_ = _e270;
    }
    let _e272 = phi_479_;
    if (_e272 > 0f) {
        if (_e272 < 1f) {
            phi_488_ = _e272;
        } else {
            phi_488_ = 1f;
        }
        let _e276 = phi_488_;
        phi_489_ = _e276;
    } else {
        phi_489_ = 0f;
    }
    let _e278 = phi_489_;
    let _e279 = (_e77 - 1u);
    let _e281 = (_e278 * f32(_e77));
    if _e81 {
        let _e288 = select(select(u32(_e281), 0u, (_e281 < bitcast<f32>(0u))), 4294967295u, (_e281 > bitcast<f32>(1333788671u)));
        if (_e279 < _e288) {
            phi_507_ = _e279;
        } else {
            phi_507_ = _e288;
        }
        let _e291 = phi_507_;
        phi_546_ = texture_Axis(_e291, _e291, 0f);
    } else {
        let _e293 = (_e281 + 0.5f);
        let _e300 = select(select(u32(_e293), 0u, (_e293 < bitcast<f32>(0u))), 4294967295u, (_e293 > bitcast<f32>(1333788671u)));
        if (_e77 < _e300) {
            phi_521_ = _e77;
        } else {
            phi_521_ = _e300;
        }
        let _e303 = phi_521_;
        if (_e206 == 0u) {
            phi_528_ = _e279;
        } else {
            phi_528_ = 0u;
        }
        let _e308 = phi_528_;
        if (_e206 == 0u) {
            phi_533_ = 0u;
        } else {
            phi_533_ = _e279;
        }
        let _e311 = phi_533_;
        if (_e303 == 0u) {
            phi_539_ = _e308;
        } else {
            phi_539_ = (_e303 - 1u);
        }
        let _e315 = phi_539_;
        if (_e303 > _e279) {
            phi_544_ = _e311;
        } else {
            phi_544_ = _e303;
        }
        let _e318 = phi_544_;
        phi_546_ = texture_Axis(_e315, _e318, (_e293 - f32(_e303)));
    }
    let _e321 = phi_546_;
    let _e325 = (*param_4).offset;
    let _e332 = (*param_4).offset;
    let _e339 = (*param_4).offset;
    let _e346 = (*param_4).offset;
    return texture_TexelQuad(array<u32, 4>(((_e325 + (_e321.low * _e73)) + _e201.low), ((_e332 + (_e321.low * _e73)) + _e201.high), ((_e339 + (_e321.high * _e73)) + _e201.low), ((_e346 + (_e321.high * _e73)) + _e201.high)), vec4<f32>(((1f - _e201.fraction) * (1f - _e321.fraction)), (_e201.fraction * (1f - _e321.fraction)), ((1f - _e201.fraction) * _e321.fraction), (_e201.fraction * _e321.fraction)));
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var phi_686_: f32;
    var phi_741_: bool;
    var phi_742_: bool;
    var phi_743_: bool;
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
    var phi_757_: bool;
    var phi_758_: bool;
    var phi_759_: bool;
    var phi_760_: bool;
    var phi_761_: bool;
    var phi_762_: bool;
    var phi_763_: bool;
    var phi_764_: bool;
    var phi_768_: bool;
    var phi_772_: bool;
    var phi_842_: f32;
    var phi_849_: f32;
    var phi_856_: f32;
    var phi_863_: f32;
    var phi_870_: f32;
    var phi_877_: f32;
    var phi_894_: f32;
    var phi_899_: f32;
    var phi_904_: f32;
    var phi_932_: bool;
    var phi_933_: bool;
    var phi_941_: u32;
    var phi_942_: u32;
    var phi_953_: vec3<f32>;
    var phi_954_: vec3<f32>;
    var phi_967_: u32;
    var phi_972_: u32;
    var phi_977_: u32;
    var phi_1091_: bool;
    var phi_1092_: bool;
    var phi_1123_: u32;
    var phi_1125_: u32;
    var phi_1128_: bool;
    var phi_1208_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1235_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1262_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1268_: u32;
    var phi_1271_: u32;
    var phi_1285_: u32;
    var phi_1295_: u32;
    var phi_1305_: u32;
    var phi_1323_: u32;
    var phi_1333_: u32;
    var phi_1343_: u32;
    var phi_1379_: u32;
    var phi_1392_: u32;
    var phi_1397_: u32;
    var phi_1398_: u32;
    var phi_1399_: u32;
    var phi_1269_: u32;
    var phi_1272_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_1457_: u32;
    var phi_1460_: bool;
    var phi_1504_: vec3<f32>;
    var phi_1505_: vec3<f32>;
    var phi_1534_: vec3<f32>;
    var phi_1535_: vec3<f32>;
    var phi_1564_: vec3<f32>;
    var phi_1565_: vec3<f32>;
    var phi_1583_: bool;
    var phi_1584_: bool;
    var phi_1588_: f32;
    var phi_1589_: f32;
    var phi_1590_: f32;
    var phi_1591_: f32;
    var phi_1599_: f32;
    var phi_1609_: bool;
    var phi_1610_: bool;
    var phi_1614_: f32;
    var phi_1615_: f32;
    var phi_1616_: f32;
    var phi_1617_: f32;
    var phi_1625_: f32;
    var phi_1635_: bool;
    var phi_1636_: bool;
    var phi_1640_: f32;
    var phi_1641_: f32;
    var phi_1642_: f32;
    var phi_1643_: f32;
    var phi_1651_: f32;
    var phi_1666_: f32;
    var phi_1667_: bool;
    var phi_1668_: f32;
    var phi_1669_: bool;
    var phi_1670_: f32;
    var phi_1671_: bool;
    var phi_1689_: f32;
    var phi_1690_: bool;
    var phi_1691_: bool;
    var phi_1692_: f32;
    var phi_1693_: bool;
    var phi_1694_: bool;
    var phi_1698_: bool;
    var phi_1699_: f32;
    var phi_1700_: bool;
    var phi_1728_: vec3<f32>;
    var phi_1729_: vec3<f32>;
    var phi_1754_: vec3<f32>;
    var phi_1755_: vec3<f32>;
    var phi_1780_: vec3<f32>;
    var phi_1781_: vec3<f32>;
    var phi_1837_: f32;
    var phi_1846_: f32;
    var phi_1855_: f32;
    var phi_1864_: f32;
    var phi_1871_: f32;
    var phi_1878_: f32;
    var phi_1891_: f32;
    var phi_1900_: f32;
    var phi_1909_: f32;
    var phi_1918_: f32;
    var phi_1925_: f32;
    var phi_1932_: f32;
    var phi_1949_: f32;
    var phi_1954_: f32;
    var phi_1959_: f32;
    var phi_1967_: f32;
    var phi_1972_: f32;
    var phi_1977_: f32;
    var phi_1989_: f32;
    var phi_1994_: f32;
    var phi_1999_: f32;
    var phi_2004_: f32;
    var phi_2009_: lt_bvh_triangle_Intersection;
    var phi_2010_: bool;
    var phi_2011_: lt_bvh_triangle_Intersection;
    var phi_2012_: bool;
    var phi_2016_: lt_bvh_triangle_Intersection;
    var phi_2017_: bool;
    var phi_2018_: lt_bvh_triangle_Intersection;
    var phi_2019_: bool;
    var phi_2020_: bool;
    var phi_2024_: bool;
    var phi_2028_: lt_bvh_triangle_Intersection;
    var phi_2242_: f32;
    var phi_2245_: bool;
    var phi_2246_: bool;
    var phi_2247_: bool;
    var phi_2251_: bool;
    var phi_2252_: bool;
    var phi_2253_: bool;
    var phi_2254_: bool;
    var phi_2255_: bool;
    var phi_2256_: bool;
    var phi_2257_: bool;
    var phi_2258_: bool;
    var phi_2259_: bool;
    var phi_2260_: bool;
    var phi_1458_: u32;
    var phi_1461_: bool;
    var phi_2264_: bool;
    var phi_2265_: bool;
    var local_5: bool;
    var phi_2307_: bool;
    var phi_2308_: bool;
    var phi_2339_: u32;
    var phi_2340_: u32;
    var phi_1126_: u32;
    var phi_1129_: bool;
    var phi_2341_: bool;
    var phi_2342_: bool;
    var phi_2343_: bool;
    var local_6: bool;
    var phi_2347_: bool;
    var phi_2351_: bool;
    var phi_2352_: bool;
    var phi_2353_: bool;
    var phi_2354_: bool;
    var phi_2358_: bool;
    var phi_2362_: f32;
    var phi_2403_: u32;
    var phi_2422_: u32;
    var phi_2430_: u32;
    var phi_2438_: u32;
    var phi_2443_: u32;
    var local_7: bool;
    var local_8: bool;
    var local_9: bool;
    var local_10: bool;
    var local_11: bool;

    let _e70 = id_1;
    let _e77 = arrayLength((&nodes.member));
    let _e80 = arrayLength((&triangles.member));
    let _e83 = arrayLength((&visibility.member));
    let _e86 = arrayLength((&list.member));
    let _e89 = arrayLength((&bits.member));
    let _e92 = arrayLength((&vertices.member));
    let _e98 = arrayLength((&alpha_texels.member));
    let _e102 = ((_e70.y * 2097152u) + _e70.x);
    if (3u < _e86) {
    } else {
        return;
    }
    let _e105 = list.member[3u];
    if (_e102 < _e105) {
        let _e107 = (_e102 + 4u);
        if (_e107 < _e86) {
        } else {
            return;
        }
        let _e111 = list.member[(0u + _e107)];
        if (_e111 < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e117 = samples.member[(0u + _e111)].position;
        let _e119 = samples.member[(0u + _e111)].normal;
        let _e121 = samples.member[(0u + _e111)].magnitude;
        let _e123 = ((8f / 8388608f) * _e121);
        let _e131 = (_e117.x + (_e119.x * _e123));
        let _e133 = (_e117.y + (_e119.y * _e123));
        let _e135 = (_e117.z + (_e119.z * _e123));
        let _e137 = p.member.light.place;
        if (_e137.w == 0f) {
            phi_686_ = 300000000000000000000000000000000000000f;
        } else {
            phi_686_ = 1f;
        }
        let _e141 = phi_686_;
        let _e149 = (_e137.x - (_e131 * _e137.w));
        let _e150 = (_e137.y - (_e133 * _e137.w));
        let _e151 = (_e137.z - (_e135 * _e137.w));
        let _e156 = abs(_e149);
        let _e157 = abs(_e150);
        let _e158 = abs(_e151);
        if (abs(_e131) < 1000000000000000f) {
            if (abs(_e133) < 1000000000000000f) {
                if (abs(_e135) < 1000000000000000f) {
                    if (_e156 < 1000000000000000f) {
                        if (_e157 < 1000000000000000f) {
                            if (_e158 < 1000000000000000f) {
                                if (_e156 > 0f) {
                                    phi_742_ = bool();
                                    phi_743_ = true;
                                } else {
                                    let _e166 = (_e157 > 0f);
                                    if _e166 {
                                        phi_741_ = bool();
                                    } else {
                                        phi_741_ = (_e158 > 0f);
                                    }
                                    let _e169 = phi_741_;
                                    phi_742_ = _e169;
                                    phi_743_ = _e166;
                                }
                                let _e171 = phi_742_;
                                let _e173 = phi_743_;
                                if _e173 {
                                    phi_747_ = true;
                                } else {
                                    phi_747_ = _e171;
                                }
                                let _e175 = phi_747_;
                                phi_748_ = _e175;
                                phi_749_ = false;
                            } else {
                                phi_748_ = bool();
                                phi_749_ = true;
                            }
                            let _e177 = phi_748_;
                            let _e179 = phi_749_;
                            phi_750_ = _e177;
                            phi_751_ = false;
                            phi_752_ = _e179;
                        } else {
                            phi_750_ = bool();
                            phi_751_ = true;
                            phi_752_ = false;
                        }
                        let _e181 = phi_750_;
                        let _e183 = phi_751_;
                        let _e185 = phi_752_;
                        phi_753_ = _e181;
                        phi_754_ = _e183;
                        phi_755_ = _e185;
                    } else {
                        phi_753_ = bool();
                        phi_754_ = true;
                        phi_755_ = false;
                    }
                    let _e187 = phi_753_;
                    let _e189 = phi_754_;
                    let _e191 = phi_755_;
                    phi_756_ = _e187;
                    phi_757_ = _e189;
                    phi_758_ = _e191;
                } else {
                    phi_756_ = bool();
                    phi_757_ = true;
                    phi_758_ = false;
                }
                let _e193 = phi_756_;
                let _e195 = phi_757_;
                let _e197 = phi_758_;
                phi_759_ = _e193;
                phi_760_ = _e195;
                phi_761_ = _e197;
            } else {
                phi_759_ = bool();
                phi_760_ = true;
                phi_761_ = false;
            }
            let _e199 = phi_759_;
            let _e201 = phi_760_;
            let _e203 = phi_761_;
            phi_762_ = _e199;
            phi_763_ = _e201;
            phi_764_ = _e203;
        } else {
            phi_762_ = bool();
            phi_763_ = true;
            phi_764_ = false;
        }
        let _e205 = phi_762_;
        let _e207 = phi_763_;
        let _e209 = phi_764_;
        if _e207 {
            phi_768_ = true;
        } else {
            phi_768_ = _e209;
        }
        let _e211 = phi_768_;
        if _e211 {
            phi_772_ = false;
        } else {
            phi_772_ = _e205;
        }
        let _e213 = phi_772_;
        if _e213 {
            let _e214 = (0u >= _e77);
            if _e214 {
                phi_2352_ = bool();
            } else {
                if (0u < _e77) {
                } else {
                    return;
                }
                let _e220 = nodes.member[(0u + 0u)].frame[0u];
                let _e224 = nodes.member[(0u + 0u)].frame[1u];
                let _e228 = nodes.member[(0u + 0u)].frame[2u];
                let _e232 = nodes.member[(0u + 0u)].frame[0u];
                let _e236 = nodes.member[(0u + 0u)].frame[1u];
                let _e240 = nodes.member[(0u + 0u)].frame[2u];
                let _e244 = nodes.member[(0u + 0u)].frame[3u];
                let _e278 = core_intrinsics_maximum_number_nsz_f32_(abs(_e149), abs(_e150));
                let _e279 = core_intrinsics_maximum_number_nsz_f32_(_e278, abs(_e151));
                let _e280 = (_e279 * 0.0000000000009094947f);
                if (abs(_e149) < _e280) {
                    phi_842_ = _e280;
                } else {
                    phi_842_ = abs(_e149);
                }
                let _e285 = phi_842_;
                if (_e149 < 0f) {
                    phi_849_ = (-1f / _e285);
                } else {
                    phi_849_ = (1f / _e285);
                }
                let _e290 = phi_849_;
                if (abs(_e150) < _e280) {
                    phi_856_ = _e280;
                } else {
                    phi_856_ = abs(_e150);
                }
                let _e295 = phi_856_;
                if (_e150 < 0f) {
                    phi_863_ = (-1f / _e295);
                } else {
                    phi_863_ = (1f / _e295);
                }
                let _e300 = phi_863_;
                if (abs(_e151) < _e280) {
                    phi_870_ = _e280;
                } else {
                    phi_870_ = abs(_e151);
                }
                let _e305 = phi_870_;
                if (_e151 < 0f) {
                    phi_877_ = (-1f / _e305);
                } else {
                    phi_877_ = (1f / _e305);
                }
                let _e310 = phi_877_;
                let _e314 = abs((bitcast<f32>(_e220) - _e131));
                let _e315 = abs((bitcast<f32>(_e224) - _e133));
                let _e316 = abs((bitcast<f32>(_e228) - _e135));
                let _e320 = abs(((bitcast<f32>(_e232) + (bitcast<f32>((((_e244 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e131));
                let _e321 = abs(((bitcast<f32>(_e236) + (bitcast<f32>((((_e244 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e133));
                let _e322 = abs(((bitcast<f32>(_e240) + (bitcast<f32>((((_e244 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e135));
                if (_e314 > _e320) {
                    phi_894_ = _e314;
                } else {
                    phi_894_ = _e320;
                }
                let _e325 = phi_894_;
                if (_e315 > _e321) {
                    phi_899_ = _e315;
                } else {
                    phi_899_ = _e321;
                }
                let _e328 = phi_899_;
                if (_e316 > _e322) {
                    phi_904_ = _e316;
                } else {
                    phi_904_ = _e322;
                }
                let _e331 = phi_904_;
                let _e332 = core_intrinsics_maximum_number_nsz_f32_(_e325, _e328);
                let _e333 = core_intrinsics_maximum_number_nsz_f32_(_e332, _e331);
                let _e337 = (_e333 * 0.0000019073486f);
                let _e338 = (abs(_e290) * _e337);
                let _e339 = (abs(_e300) * _e337);
                let _e340 = (abs(_e310) * _e337);
                let _e344 = (_e333 * 0.0000009536743f);
                let _e345 = (abs(_e290) * _e344);
                let _e346 = (abs(_e300) * _e344);
                let _e347 = (abs(_e310) * _e344);
                let _e348 = abs(_e149);
                let _e349 = abs(_e150);
                let _e350 = abs(_e151);
                if (_e348 >= _e349) {
                    if (_e348 >= _e350) {
                        phi_932_ = false;
                    } else {
                        phi_932_ = true;
                    }
                    let _e354 = phi_932_;
                    phi_933_ = _e354;
                } else {
                    phi_933_ = true;
                }
                let _e356 = phi_933_;
                if _e356 {
                    if (_e349 >= _e350) {
                        phi_941_ = 1u;
                    } else {
                        phi_941_ = 2u;
                    }
                    let _e359 = phi_941_;
                    phi_942_ = _e359;
                } else {
                    phi_942_ = 0u;
                }
                let _e361 = phi_942_;
                if (_e361 == 0u) {
                    phi_954_ = vec3<f32>(_e150, _e151, _e149);
                } else {
                    if (_e361 == 1u) {
                        phi_953_ = vec3<f32>(_e151, _e149, _e150);
                    } else {
                        phi_953_ = vec3<f32>(_e149, _e150, _e151);
                    }
                    let _e367 = phi_953_;
                    phi_954_ = _e367;
                }
                let _e369 = phi_954_;
                let _e372 = (_e369.x / _e369.z);
                let _e375 = (_e369.y / _e369.z);
                if (_e290 < 0f) {
                    phi_967_ = 0u;
                } else {
                    phi_967_ = 1u;
                }
                let _e380 = phi_967_;
                if (_e300 < 0f) {
                    phi_972_ = 0u;
                } else {
                    phi_972_ = 2u;
                }
                let _e383 = phi_972_;
                if (_e310 < 0f) {
                    phi_977_ = 0u;
                } else {
                    phi_977_ = 4u;
                }
                let _e386 = phi_977_;
                let _e388 = ((_e380 | _e383) | _e386);
                let _e389 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e389.first[0], _e389.first[1], _e389.first[2], _e389.first[3], _e389.first[4], _e389.first[5], _e389.first[6], _e389.first[7], _e389.first[8], _e389.first[9], _e389.first[10], _e389.first[11], _e389.first[12], _e389.first[13], _e389.first[14], _e389.first[15], _e389.first[16], _e389.first[17], _e389.first[18], _e389.first[19], _e389.first[20], _e389.first[21], _e389.first[22], _e389.first[23], _e389.first[24], _e389.first[25], _e389.first[26], _e389.first[27], _e389.first[28], _e389.first[29], _e389.first[30], _e389.first[31]), array<u32, 32>(_e389.mask[0], _e389.mask[1], _e389.mask[2], _e389.mask[3], _e389.mask[4], _e389.mask[5], _e389.mask[6], _e389.mask[7], _e389.mask[8], _e389.mask[9], _e389.mask[10], _e389.mask[11], _e389.mask[12], _e389.mask[13], _e389.mask[14], _e389.mask[15], _e389.mask[16], _e389.mask[17], _e389.mask[18], _e389.mask[19], _e389.mask[20], _e389.mask[21], _e389.mask[22], _e389.mask[23], _e389.mask[24], _e389.mask[25], _e389.mask[26], _e389.mask[27], _e389.mask[28], _e389.mask[29], _e389.mask[30], _e389.mask[31]), _e389.len, _e389.group, _e389.group_mask);
                let _e463 = local_1.group_mask;
                if ((_e463 & 4278190080u) == 0u) {
                    let _e467 = local_1.len;
                    if (_e467 == 0u) {
                        phi_1091_ = false;
                    } else {
                        let _e471 = local_1.len;
                        local_1.len = (_e471 - 1u);
                        let _e474 = local_1.len;
                        if (_e474 < 32u) {
                        } else {
                            return;
                        }
                        let _e479 = local_1.first[(0u + _e474)];
                        local_1.group = _e479;
                        let _e482 = local_1.len;
                        if (_e482 < 32u) {
                        } else {
                            return;
                        }
                        let _e487 = local_1.mask[(0u + _e482)];
                        local_1.group_mask = _e487;
                        phi_1091_ = true;
                    }
                    let _e490 = phi_1091_;
                    phi_1092_ = _e490;
                } else {
                    phi_1092_ = true;
                }
                let _e492 = phi_1092_;
                if _e492 {
                    let _e494 = local_1.group_mask;
                    let _e500 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e494)), 32u, (_e494 == 0u)));
                    let _e504 = local_1.group_mask;
                    let _e518 = local_1.group_mask;
                    local_1.group_mask = (_e518 & ~((1u << bitcast<u32>((_e500 & 31u)))));
                    let _e521 = local_1.group;
                    phi_1123_ = (_e521 + countOneBits(((_e504 & ~((4294967295u << bitcast<u32>((((_e500 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1123_ = 4294967295u;
                }
                let _e524 = phi_1123_;
                phi_1125_ = _e524;
                phi_1128_ = false;
                loop {
                    let _e526 = phi_1125_;
                    let _e528 = phi_1128_;
                    local_11 = _e528;
                    if (_e526 != 4294967295u) {
                        if (_e526 < _e77) {
                        } else {
                            return;
                        }
                        let _e535 = nodes.member[(0u + _e526)].frame[3u];
                        let _e560 = (bitcast<f32>((((_e535 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e290);
                        let _e561 = (bitcast<f32>((((_e535 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e300);
                        let _e562 = (bitcast<f32>((((_e535 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e310);
                        let _e565 = nodes.member[(0u + _e526)].frame[0u];
                        let _e569 = nodes.member[(0u + _e526)].frame[1u];
                        let _e573 = nodes.member[(0u + _e526)].frame[2u];
                        let _e578 = ((bitcast<f32>(_e565) - _e131) * _e290);
                        let _e579 = ((bitcast<f32>(_e569) - _e133) * _e300);
                        let _e580 = ((bitcast<f32>(_e573) - _e135) * _e310);
                        let _e588 = nodes.member[(0u + _e526)].x;
                        if (_e290 < 0f) {
                            let _e599 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e588.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e605 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e599.unnamed.word, _e588.w), _e599.unnamed_1);
                            let _e611 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e605.unnamed, lt_mask_LightPlace(_e588.x, _e605.unnamed_1.shift));
                            phi_1208_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e611.unnamed, lt_mask_LightPlace(_e611.unnamed_1.word, _e588.y));
                        } else {
                            let _e627 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e588.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e633 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e627.unnamed.word, _e588.y), _e627.unnamed_1);
                            let _e639 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e633.unnamed, lt_mask_LightPlace(_e588.z, _e633.unnamed_1.shift));
                            phi_1208_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e639.unnamed, lt_mask_LightPlace(_e639.unnamed_1.word, _e588.w));
                        }
                        let _e647 = phi_1208_;
                        let _e657 = nodes.member[(0u + _e526)].y;
                        if (_e300 < 0f) {
                            let _e668 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e657.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e674 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e668.unnamed.word, _e657.w), _e668.unnamed_1);
                            let _e680 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e674.unnamed, lt_mask_LightPlace(_e657.x, _e674.unnamed_1.shift));
                            phi_1235_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e680.unnamed, lt_mask_LightPlace(_e680.unnamed_1.word, _e657.y));
                        } else {
                            let _e696 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e657.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e702 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e696.unnamed.word, _e657.y), _e696.unnamed_1);
                            let _e708 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e702.unnamed, lt_mask_LightPlace(_e657.z, _e702.unnamed_1.shift));
                            phi_1235_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e708.unnamed, lt_mask_LightPlace(_e708.unnamed_1.word, _e657.w));
                        }
                        let _e716 = phi_1235_;
                        let _e726 = nodes.member[(0u + _e526)].z;
                        if (_e310 < 0f) {
                            let _e737 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e726.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e743 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e737.unnamed.word, _e726.w), _e737.unnamed_1);
                            let _e749 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e743.unnamed, lt_mask_LightPlace(_e726.x, _e743.unnamed_1.shift));
                            phi_1262_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e749.unnamed, lt_mask_LightPlace(_e749.unnamed_1.word, _e726.y));
                        } else {
                            let _e765 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e726.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e771 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e765.unnamed.word, _e726.y), _e765.unnamed_1);
                            let _e777 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e771.unnamed, lt_mask_LightPlace(_e726.z, _e771.unnamed_1.shift));
                            phi_1262_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e777.unnamed, lt_mask_LightPlace(_e777.unnamed_1.word, _e726.w));
                        }
                        let _e785 = phi_1262_;
                        phi_1268_ = 0u;
                        phi_1271_ = 0u;
                        loop {
                            let _e795 = phi_1268_;
                            let _e797 = phi_1271_;
                            local_2 = _e797;
                            local_3 = _e797;
                            local_4 = _e797;
                            let _e798 = (_e795 < 8u);
                            if _e798 {
                                let _e800 = (_e795 >> bitcast<u32>(2i));
                                let _e801 = (_e795 & 3u);
                                if (_e800 == 0u) {
                                    phi_1285_ = _e647.unnamed.word;
                                } else {
                                    phi_1285_ = _e647.unnamed.shift;
                                }
                                let _e804 = phi_1285_;
                                if (_e800 == 0u) {
                                    phi_1295_ = _e716.unnamed.word;
                                } else {
                                    phi_1295_ = _e716.unnamed.shift;
                                }
                                let _e813 = phi_1295_;
                                if (_e800 == 0u) {
                                    phi_1305_ = _e785.unnamed.word;
                                } else {
                                    phi_1305_ = _e785.unnamed.shift;
                                }
                                let _e822 = phi_1305_;
                                let _e835 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e804 >> bitcast<u32>(((_e801 * 8u) & 31u))) & 255u)) * _e560) + (_e578 - _e338)), ((f32(((_e813 >> bitcast<u32>(((_e801 * 8u) & 31u))) & 255u)) * _e561) + (_e579 - _e339)));
                                let _e836 = core_intrinsics_maximum_number_nsz_f32_(_e835, ((f32(((_e822 >> bitcast<u32>(((_e801 * 8u) & 31u))) & 255u)) * _e562) + (_e580 - _e340)));
                                if (_e800 == 0u) {
                                    phi_1323_ = _e647.unnamed_1.word;
                                } else {
                                    phi_1323_ = _e647.unnamed_1.shift;
                                }
                                let _e839 = phi_1323_;
                                if (_e800 == 0u) {
                                    phi_1333_ = _e716.unnamed_1.word;
                                } else {
                                    phi_1333_ = _e716.unnamed_1.shift;
                                }
                                let _e848 = phi_1333_;
                                if (_e800 == 0u) {
                                    phi_1343_ = _e785.unnamed_1.word;
                                } else {
                                    phi_1343_ = _e785.unnamed_1.shift;
                                }
                                let _e857 = phi_1343_;
                                let _e870 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e839 >> bitcast<u32>(((_e801 * 8u) & 31u))) & 255u)) * _e560) + (_e578 + _e338)), ((f32(((_e848 >> bitcast<u32>(((_e801 * 8u) & 31u))) & 255u)) * _e561) + (_e579 + _e339)));
                                let _e871 = core_intrinsics_minimum_number_nsz_f32_(_e870, ((f32(((_e857 >> bitcast<u32>(((_e801 * 8u) & 31u))) & 255u)) * _e562) + (_e580 + _e340)));
                                if (_e836 <= _e871) {
                                    if (_e836 <= _e141) {
                                        if (_e871 >= 0f) {
                                            if (_e800 == 0u) {
                                                let _e878 = nodes.member[(0u + _e526)].links[2u];
                                                phi_1379_ = _e878;
                                            } else {
                                                let _e881 = nodes.member[(0u + _e526)].links[3u];
                                                phi_1379_ = _e881;
                                            }
                                            let _e883 = phi_1379_;
                                            let _e888 = ((_e883 >> bitcast<u32>(((_e801 * 8u) & 31u))) & 255u);
                                            let _e889 = (_e888 & 31u);
                                            if (_e889 >= 24u) {
                                                phi_1392_ = (24u + ((_e889 - 24u) ^ _e388));
                                            } else {
                                                phi_1392_ = _e889;
                                            }
                                            let _e895 = phi_1392_;
                                            phi_1397_ = (_e797 | ((_e888 >> bitcast<u32>(5i)) << bitcast<u32>((_e895 & 31u))));
                                        } else {
                                            phi_1397_ = _e797;
                                        }
                                        let _e903 = phi_1397_;
                                        phi_1398_ = _e903;
                                    } else {
                                        phi_1398_ = _e797;
                                    }
                                    let _e905 = phi_1398_;
                                    phi_1399_ = _e905;
                                } else {
                                    phi_1399_ = _e797;
                                }
                                let _e907 = phi_1399_;
                                phi_1269_ = (_e795 + 1u);
                                phi_1272_ = _e907;
                            } else {
                                phi_1269_ = u32();
                                phi_1272_ = u32();
                            }
                            let _e910 = phi_1269_;
                            let _e912 = phi_1272_;
                            continue;
                            continuing {
                                phi_1268_ = _e910;
                                phi_1271_ = _e912;
                                break if !(_e798);
                            }
                        }
                        let _e916 = nodes.member[(0u + _e526)].links[0u];
                        let _e920 = nodes.member[(0u + _e526)].frame[3u];
                        let _e924 = local_2;
                        if ((_e924 & 4278190080u) == 0u) {
                        } else {
                            let _e928 = local_1.group_mask;
                            if ((_e928 & 4278190080u) == 0u) {
                            } else {
                                let _e932 = local_1.len;
                                if (_e932 < 32u) {
                                    let _e935 = local_1.group;
                                    let _e937 = local_1.len;
                                    if (_e937 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.first[(0u + _e937)] = _e935;
                                    let _e943 = local_1.group_mask;
                                    let _e945 = local_1.len;
                                    if (_e945 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.mask[(0u + _e945)] = _e943;
                                    let _e952 = local_1.len;
                                    local_1.len = (_e952 + 1u);
                                }
                            }
                            local_1.group = (0u + _e916);
                            let _e956 = local_3;
                            local_1.group_mask = ((_e956 & 4278190080u) | (_e920 >> bitcast<u32>(24i)));
                        }
                        let _e961 = local_4;
                        phi_1457_ = (_e961 & 16777215u);
                        phi_1460_ = _e528;
                        loop {
                            let _e964 = phi_1457_;
                            let _e966 = phi_1460_;
                            local_7 = _e966;
                            let _e967 = (_e964 == 0u);
                            local_5 = _e967;
                            local_9 = _e967;
                            if _e967 {
                                phi_1458_ = u32();
                                phi_1461_ = bool();
                                phi_2264_ = bool();
                                phi_2265_ = false;
                            } else {
                                let _e970 = nodes.member[(0u + _e526)].links[1u];
                                let _e975 = ((0u + _e970) + select(firstTrailingBit(_e964), 32u, (_e964 == 0u)));
                                if (_e975 < _e80) {
                                } else {
                                    return;
                                }
                                let _e982 = triangles.member[(0u + _e975)].v0_;
                                let _e984 = (_e982.x - _e131);
                                let _e986 = (_e982.y - _e133);
                                let _e988 = (_e982.z - _e135);
                                if (_e361 == 0u) {
                                    phi_1505_ = vec3<f32>(_e986, _e988, _e984);
                                } else {
                                    if (_e361 == 1u) {
                                        phi_1504_ = vec3<f32>(_e988, _e984, _e986);
                                    } else {
                                        phi_1504_ = (_e982 - vec3<f32>(_e131, _e133, _e135));
                                    }
                                    let _e996 = phi_1504_;
                                    phi_1505_ = _e996;
                                }
                                let _e998 = phi_1505_;
                                let _e1002 = (_e998.x - (_e372 * _e998.z));
                                let _e1006 = (_e998.y - (_e375 * _e998.z));
                                let _e1008 = triangles.member[(0u + _e975)].v1_;
                                let _e1010 = (_e1008.x - _e131);
                                let _e1012 = (_e1008.y - _e133);
                                let _e1014 = (_e1008.z - _e135);
                                if (_e361 == 0u) {
                                    phi_1535_ = vec3<f32>(_e1012, _e1014, _e1010);
                                } else {
                                    if (_e361 == 1u) {
                                        phi_1534_ = vec3<f32>(_e1014, _e1010, _e1012);
                                    } else {
                                        phi_1534_ = (_e1008 - vec3<f32>(_e131, _e133, _e135));
                                    }
                                    let _e1022 = phi_1534_;
                                    phi_1535_ = _e1022;
                                }
                                let _e1024 = phi_1535_;
                                let _e1028 = (_e1024.x - (_e372 * _e1024.z));
                                let _e1032 = (_e1024.y - (_e375 * _e1024.z));
                                let _e1034 = triangles.member[(0u + _e975)].v2_;
                                let _e1036 = (_e1034.x - _e131);
                                let _e1038 = (_e1034.y - _e133);
                                let _e1040 = (_e1034.z - _e135);
                                if (_e361 == 0u) {
                                    phi_1565_ = vec3<f32>(_e1038, _e1040, _e1036);
                                } else {
                                    if (_e361 == 1u) {
                                        phi_1564_ = vec3<f32>(_e1040, _e1036, _e1038);
                                    } else {
                                        phi_1564_ = (_e1034 - vec3<f32>(_e131, _e133, _e135));
                                    }
                                    let _e1048 = phi_1564_;
                                    phi_1565_ = _e1048;
                                }
                                let _e1050 = phi_1565_;
                                let _e1054 = (_e1050.x - (_e372 * _e1050.z));
                                let _e1058 = (_e1050.y - (_e375 * _e1050.z));
                                if (_e1028 < _e1054) {
                                    phi_1584_ = true;
                                } else {
                                    if (_e1028 == _e1054) {
                                        phi_1583_ = (_e1032 < _e1058);
                                    } else {
                                        phi_1583_ = false;
                                    }
                                    let _e1063 = phi_1583_;
                                    phi_1584_ = _e1063;
                                }
                                let _e1065 = phi_1584_;
                                if _e1065 {
                                    phi_1588_ = _e1058;
                                    phi_1589_ = _e1054;
                                    phi_1590_ = _e1032;
                                    phi_1591_ = _e1028;
                                } else {
                                    phi_1588_ = _e1032;
                                    phi_1589_ = _e1028;
                                    phi_1590_ = _e1058;
                                    phi_1591_ = _e1054;
                                }
                                let _e1067 = phi_1588_;
                                let _e1069 = phi_1589_;
                                let _e1071 = phi_1590_;
                                let _e1073 = phi_1591_;
                                let _e1076 = ((_e1073 * _e1067) - (_e1071 * _e1069));
                                if _e1065 {
                                    phi_1599_ = -(_e1076);
                                } else {
                                    phi_1599_ = _e1076;
                                }
                                let _e1079 = phi_1599_;
                                if (_e1054 < _e1002) {
                                    phi_1610_ = true;
                                } else {
                                    if (_e1054 == _e1002) {
                                        phi_1609_ = (_e1058 < _e1006);
                                    } else {
                                        phi_1609_ = false;
                                    }
                                    let _e1084 = phi_1609_;
                                    phi_1610_ = _e1084;
                                }
                                let _e1086 = phi_1610_;
                                if _e1086 {
                                    phi_1614_ = _e1006;
                                    phi_1615_ = _e1002;
                                    phi_1616_ = _e1058;
                                    phi_1617_ = _e1054;
                                } else {
                                    phi_1614_ = _e1058;
                                    phi_1615_ = _e1054;
                                    phi_1616_ = _e1006;
                                    phi_1617_ = _e1002;
                                }
                                let _e1088 = phi_1614_;
                                let _e1090 = phi_1615_;
                                let _e1092 = phi_1616_;
                                let _e1094 = phi_1617_;
                                let _e1097 = ((_e1094 * _e1088) - (_e1092 * _e1090));
                                if _e1086 {
                                    phi_1625_ = -(_e1097);
                                } else {
                                    phi_1625_ = _e1097;
                                }
                                let _e1100 = phi_1625_;
                                if (_e1002 < _e1028) {
                                    phi_1636_ = true;
                                } else {
                                    if (_e1002 == _e1028) {
                                        phi_1635_ = (_e1006 < _e1032);
                                    } else {
                                        phi_1635_ = false;
                                    }
                                    let _e1105 = phi_1635_;
                                    phi_1636_ = _e1105;
                                }
                                let _e1107 = phi_1636_;
                                if _e1107 {
                                    phi_1640_ = _e1032;
                                    phi_1641_ = _e1028;
                                    phi_1642_ = _e1006;
                                    phi_1643_ = _e1002;
                                } else {
                                    phi_1640_ = _e1006;
                                    phi_1641_ = _e1002;
                                    phi_1642_ = _e1032;
                                    phi_1643_ = _e1028;
                                }
                                let _e1109 = phi_1640_;
                                let _e1111 = phi_1641_;
                                let _e1113 = phi_1642_;
                                let _e1115 = phi_1643_;
                                let _e1118 = ((_e1115 * _e1109) - (_e1113 * _e1111));
                                if _e1107 {
                                    phi_1651_ = -(_e1118);
                                } else {
                                    phi_1651_ = _e1118;
                                }
                                let _e1121 = phi_1651_;
                                if (_e1079 >= 0f) {
                                    if (_e1100 >= 0f) {
                                        if (_e1121 >= 0f) {
                                            phi_1666_ = ((_e1079 + _e1100) + _e1121);
                                            phi_1667_ = false;
                                        } else {
                                            phi_1666_ = f32();
                                            phi_1667_ = true;
                                        }
                                        let _e1128 = phi_1666_;
                                        let _e1130 = phi_1667_;
                                        phi_1668_ = _e1128;
                                        phi_1669_ = _e1130;
                                    } else {
                                        phi_1668_ = f32();
                                        phi_1669_ = true;
                                    }
                                    let _e1132 = phi_1668_;
                                    let _e1134 = phi_1669_;
                                    phi_1670_ = _e1132;
                                    phi_1671_ = _e1134;
                                } else {
                                    phi_1670_ = f32();
                                    phi_1671_ = true;
                                }
                                let _e1136 = phi_1670_;
                                let _e1138 = phi_1671_;
                                if _e1138 {
                                    if (_e1079 <= 0f) {
                                        if (_e1100 <= 0f) {
                                            let _e1141 = (_e1121 <= 0f);
                                            if _e1141 {
                                            }
                                            phi_1689_ = ((_e1079 + _e1100) + _e1121);
                                            phi_1690_ = false;
                                            phi_1691_ = _e1141;
                                        } else {
                                            phi_1689_ = f32();
                                            phi_1690_ = true;
                                            phi_1691_ = false;
                                        }
                                        let _e1145 = phi_1689_;
                                        let _e1147 = phi_1690_;
                                        let _e1149 = phi_1691_;
                                        phi_1692_ = _e1145;
                                        phi_1693_ = _e1147;
                                        phi_1694_ = _e1149;
                                    } else {
                                        phi_1692_ = f32();
                                        phi_1693_ = true;
                                        phi_1694_ = false;
                                    }
                                    let _e1151 = phi_1692_;
                                    let _e1153 = phi_1693_;
                                    let _e1155 = phi_1694_;
                                    if _e1153 {
                                        phi_1698_ = false;
                                    } else {
                                        phi_1698_ = _e1155;
                                    }
                                    let _e1157 = phi_1698_;
                                    phi_1699_ = _e1151;
                                    phi_1700_ = _e1157;
                                } else {
                                    phi_1699_ = _e1136;
                                    phi_1700_ = true;
                                }
                                let _e1159 = phi_1699_;
                                let _e1161 = phi_1700_;
                                if _e1161 {
                                    let _e1162 = (_e1159 == 0f);
                                    if _e1162 {
                                        phi_2016_ = lt_bvh_triangle_Intersection();
                                        phi_2017_ = false;
                                    } else {
                                        let _e1164 = triangles.member[(0u + _e975)].v0_;
                                        let _e1166 = (_e1164.x - _e131);
                                        let _e1168 = (_e1164.y - _e133);
                                        let _e1170 = (_e1164.z - _e135);
                                        if (_e361 == 0u) {
                                            phi_1729_ = vec3<f32>(_e1168, _e1170, _e1166);
                                        } else {
                                            if (_e361 == 1u) {
                                                phi_1728_ = vec3<f32>(_e1170, _e1166, _e1168);
                                            } else {
                                                phi_1728_ = (_e1164 - vec3<f32>(_e131, _e133, _e135));
                                            }
                                            let _e1178 = phi_1728_;
                                            phi_1729_ = _e1178;
                                        }
                                        let _e1180 = phi_1729_;
                                        let _e1182 = triangles.member[(0u + _e975)].v1_;
                                        let _e1184 = triangles.member[(0u + _e975)].v0_;
                                        let _e1187 = (_e1182.x - _e1184.x);
                                        let _e1190 = (_e1182.y - _e1184.y);
                                        let _e1193 = (_e1182.z - _e1184.z);
                                        if (_e361 == 0u) {
                                            phi_1755_ = vec3<f32>(_e1190, _e1193, _e1187);
                                        } else {
                                            if (_e361 == 1u) {
                                                phi_1754_ = vec3<f32>(_e1193, _e1187, _e1190);
                                            } else {
                                                phi_1754_ = (_e1182 - _e1184);
                                            }
                                            let _e1200 = phi_1754_;
                                            phi_1755_ = _e1200;
                                        }
                                        let _e1202 = phi_1755_;
                                        let _e1204 = triangles.member[(0u + _e975)].v2_;
                                        let _e1206 = triangles.member[(0u + _e975)].v0_;
                                        let _e1209 = (_e1204.x - _e1206.x);
                                        let _e1212 = (_e1204.y - _e1206.y);
                                        let _e1215 = (_e1204.z - _e1206.z);
                                        if (_e361 == 0u) {
                                            phi_1781_ = vec3<f32>(_e1212, _e1215, _e1209);
                                        } else {
                                            if (_e361 == 1u) {
                                                phi_1780_ = vec3<f32>(_e1215, _e1209, _e1212);
                                            } else {
                                                phi_1780_ = (_e1204 - _e1206);
                                            }
                                            let _e1222 = phi_1780_;
                                            phi_1781_ = _e1222;
                                        }
                                        let _e1224 = phi_1781_;
                                        let _e1231 = ((_e1202.y * _e1224.z) - (_e1202.z * _e1224.y));
                                        let _e1238 = ((_e1202.z * _e1224.x) - (_e1202.x * _e1224.z));
                                        let _e1245 = ((_e1202.x * _e1224.y) - (_e1202.y * _e1224.x));
                                        let _e1259 = (((1f / _e369.z) * (((_e1231 * _e1180.x) + (_e1238 * _e1180.y)) + (_e1245 * _e1180.z))) / (((_e1231 * _e372) + (_e1238 * _e375)) + _e1245));
                                        if (_e1259 > 0f) {
                                            if (_e1259 < _e141) {
                                                let _e1263 = triangles.member[(0u + _e975)].v0_;
                                                let _e1265 = triangles.member[(0u + _e975)].v1_;
                                                if (_e1263.x < _e1265.x) {
                                                    phi_1837_ = _e1263.x;
                                                } else {
                                                    phi_1837_ = _e1265.x;
                                                }
                                                let _e1272 = phi_1837_;
                                                if (_e1263.y < _e1265.y) {
                                                    phi_1846_ = _e1263.y;
                                                } else {
                                                    phi_1846_ = _e1265.y;
                                                }
                                                let _e1279 = phi_1846_;
                                                if (_e1263.z < _e1265.z) {
                                                    phi_1855_ = _e1263.z;
                                                } else {
                                                    phi_1855_ = _e1265.z;
                                                }
                                                let _e1286 = phi_1855_;
                                                let _e1288 = triangles.member[(0u + _e975)].v2_;
                                                if (_e1272 < _e1288.x) {
                                                    phi_1864_ = _e1272;
                                                } else {
                                                    phi_1864_ = _e1288.x;
                                                }
                                                let _e1293 = phi_1864_;
                                                if (_e1279 < _e1288.y) {
                                                    phi_1871_ = _e1279;
                                                } else {
                                                    phi_1871_ = _e1288.y;
                                                }
                                                let _e1298 = phi_1871_;
                                                if (_e1286 < _e1288.z) {
                                                    phi_1878_ = _e1286;
                                                } else {
                                                    phi_1878_ = _e1288.z;
                                                }
                                                let _e1303 = phi_1878_;
                                                let _e1305 = triangles.member[(0u + _e975)].v0_;
                                                let _e1307 = triangles.member[(0u + _e975)].v1_;
                                                if (_e1305.x > _e1307.x) {
                                                    phi_1891_ = _e1305.x;
                                                } else {
                                                    phi_1891_ = _e1307.x;
                                                }
                                                let _e1314 = phi_1891_;
                                                if (_e1305.y > _e1307.y) {
                                                    phi_1900_ = _e1305.y;
                                                } else {
                                                    phi_1900_ = _e1307.y;
                                                }
                                                let _e1321 = phi_1900_;
                                                if (_e1305.z > _e1307.z) {
                                                    phi_1909_ = _e1305.z;
                                                } else {
                                                    phi_1909_ = _e1307.z;
                                                }
                                                let _e1328 = phi_1909_;
                                                let _e1330 = triangles.member[(0u + _e975)].v2_;
                                                if (_e1314 > _e1330.x) {
                                                    phi_1918_ = _e1314;
                                                } else {
                                                    phi_1918_ = _e1330.x;
                                                }
                                                let _e1335 = phi_1918_;
                                                if (_e1321 > _e1330.y) {
                                                    phi_1925_ = _e1321;
                                                } else {
                                                    phi_1925_ = _e1330.y;
                                                }
                                                let _e1340 = phi_1925_;
                                                if (_e1328 > _e1330.z) {
                                                    phi_1932_ = _e1328;
                                                } else {
                                                    phi_1932_ = _e1330.z;
                                                }
                                                let _e1345 = phi_1932_;
                                                let _e1349 = ((_e1293 - _e131) * _e290);
                                                let _e1350 = ((_e1298 - _e133) * _e300);
                                                let _e1351 = ((_e1303 - _e135) * _e310);
                                                let _e1355 = ((_e1335 - _e131) * _e290);
                                                let _e1356 = ((_e1340 - _e133) * _e300);
                                                let _e1357 = ((_e1345 - _e135) * _e310);
                                                if (_e1349 < _e1355) {
                                                    phi_1949_ = _e1349;
                                                } else {
                                                    phi_1949_ = _e1355;
                                                }
                                                let _e1360 = phi_1949_;
                                                if (_e1350 < _e1356) {
                                                    phi_1954_ = _e1350;
                                                } else {
                                                    phi_1954_ = _e1356;
                                                }
                                                let _e1363 = phi_1954_;
                                                if (_e1351 < _e1357) {
                                                    phi_1959_ = _e1351;
                                                } else {
                                                    phi_1959_ = _e1357;
                                                }
                                                let _e1366 = phi_1959_;
                                                if (_e1349 > _e1355) {
                                                    phi_1967_ = _e1349;
                                                } else {
                                                    phi_1967_ = _e1355;
                                                }
                                                let _e1372 = phi_1967_;
                                                if (_e1350 > _e1356) {
                                                    phi_1972_ = _e1350;
                                                } else {
                                                    phi_1972_ = _e1356;
                                                }
                                                let _e1375 = phi_1972_;
                                                if (_e1351 > _e1357) {
                                                    phi_1977_ = _e1351;
                                                } else {
                                                    phi_1977_ = _e1357;
                                                }
                                                let _e1378 = phi_1977_;
                                                let _e1382 = core_intrinsics_maximum_number_nsz_f32_((_e1360 - _e345), (_e1363 - _e346));
                                                let _e1383 = core_intrinsics_maximum_number_nsz_f32_(_e1382, (_e1366 - _e347));
                                                let _e1384 = core_intrinsics_minimum_number_nsz_f32_((_e1372 + _e345), (_e1375 + _e346));
                                                let _e1385 = core_intrinsics_minimum_number_nsz_f32_(_e1384, (_e1378 + _e347));
                                                if (_e1383 > -300000000000000000000000000000000000000f) {
                                                    phi_1989_ = _e1383;
                                                } else {
                                                    phi_1989_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1388 = phi_1989_;
                                                if (_e1385 < 300000000000000000000000000000000000000f) {
                                                    phi_1994_ = _e1385;
                                                } else {
                                                    phi_1994_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1391 = phi_1994_;
                                                if (_e1259 < _e1388) {
                                                    phi_1999_ = _e1388;
                                                } else {
                                                    phi_1999_ = _e1259;
                                                }
                                                let _e1394 = phi_1999_;
                                                if (_e1394 > _e1391) {
                                                    phi_2004_ = _e1391;
                                                } else {
                                                    phi_2004_ = _e1394;
                                                }
                                                let _e1397 = phi_2004_;
                                                phi_2009_ = lt_bvh_triangle_Intersection(_e1397, (_e1100 / _e1159), (_e1121 / _e1159), (_e1388 <= _e1391));
                                                phi_2010_ = false;
                                            } else {
                                                phi_2009_ = lt_bvh_triangle_Intersection();
                                                phi_2010_ = true;
                                            }
                                            let _e1403 = phi_2009_;
                                            let _e1405 = phi_2010_;
                                            phi_2011_ = _e1403;
                                            phi_2012_ = _e1405;
                                        } else {
                                            phi_2011_ = lt_bvh_triangle_Intersection();
                                            phi_2012_ = true;
                                        }
                                        let _e1407 = phi_2011_;
                                        let _e1409 = phi_2012_;
                                        if _e1409 {
                                        }
                                        phi_2016_ = _e1407;
                                        phi_2017_ = _e1409;
                                    }
                                    let _e1411 = phi_2016_;
                                    let _e1413 = phi_2017_;
                                    phi_2018_ = _e1411;
                                    phi_2019_ = _e1162;
                                    phi_2020_ = _e1413;
                                } else {
                                    phi_2018_ = lt_bvh_triangle_Intersection();
                                    phi_2019_ = true;
                                    phi_2020_ = false;
                                }
                                let _e1415 = phi_2018_;
                                let _e1417 = phi_2019_;
                                let _e1419 = phi_2020_;
                                if _e1417 {
                                    phi_2024_ = true;
                                } else {
                                    phi_2024_ = _e1419;
                                }
                                let _e1421 = phi_2024_;
                                if _e1421 {
                                    phi_2028_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_2028_ = _e1415;
                                }
                                let _e1423 = phi_2028_;
                                if _e1423.is_hit {
                                    if (_e1423.t > 0f) {
                                        if (_e1423.t < _e141) {
                                            let _e1430 = triangles.member[(0u + _e975)].i0_;
                                            if ((_e1430 & 2147483648u) == 0u) {
                                                phi_2247_ = true;
                                            } else {
                                                if (_e975 < _e80) {
                                                } else {
                                                    return;
                                                }
                                                let _e1439 = triangles.member[(0u + _e975)].i0_;
                                                let _e1440 = (_e1439 & 2147483647u);
                                                let _e1442 = triangles.member[(0u + _e975)].i1_;
                                                let _e1444 = triangles.member[(0u + _e975)].i2_;
                                                if (_e1440 < _e92) {
                                                } else {
                                                    return;
                                                }
                                                let _e1448 = vertices.member[(0u + _e1440)];
                                                if (_e1442 < _e92) {
                                                } else {
                                                    return;
                                                }
                                                let _e1452 = vertices.member[(0u + _e1442)];
                                                if (_e1444 < _e92) {
                                                } else {
                                                    return;
                                                }
                                                let _e1456 = vertices.member[(0u + _e1444)];
                                                let _e1457 = array<abi_Vertex, 3>(_e1448, _e1452, _e1456);
                                                if (_e1457[0].material < arrayLength((&materials.member))) {
                                                } else {
                                                    return;
                                                }
                                                let _e1463 = materials.member[(0u + _e1457[0].material)];
                                                if ((_e1463.flags & 1u) == 1u) {
                                                    let _e1468 = ((1f - _e1423.u) - _e1423.v);
                                                    if (_e1463.cutoff <= 0f) {
                                                        phi_2245_ = true;
                                                    } else {
                                                        let _e1495 = (_e1463.base_color.w * ((((f32((_e1457[0].color >> bitcast<u32>(24i))) * _e1468) + (f32((_e1457[1].color >> bitcast<u32>(24i))) * _e1423.u)) + (f32((_e1457[2].color >> bitcast<u32>(24i))) * _e1423.v)) * (1f / 255f)));
                                                        if (_e1463.alpha_size == 0u) {
                                                            phi_2242_ = _e1495;
                                                        } else {
                                                            local.offset = _e1463.alpha_offset;
                                                            local.size = _e1463.alpha_size;
                                                            local.flags = _e1463.flags;
                                                            let _e1526 = _lt_shaders_texture_TextureView_quad((&local), (((_e1457[0].u * _e1468) + (_e1457[1].u * _e1423.u)) + (_e1457[2].u * _e1423.v)), (((_e1457[0].v * _e1468) + (_e1457[1].v * _e1423.u)) + (_e1457[2].v * _e1423.v)));
                                                            let _e1530 = (_e1526.indices[0] >> bitcast<u32>(2i));
                                                            if (_e1530 < _e98) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1534 = alpha_texels.member[(0u + _e1530)];
                                                            let _e1550 = (_e1526.indices[1] >> bitcast<u32>(2i));
                                                            if (_e1550 < _e98) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1554 = alpha_texels.member[(0u + _e1550)];
                                                            let _e1571 = (_e1526.indices[2] >> bitcast<u32>(2i));
                                                            if (_e1571 < _e98) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1575 = alpha_texels.member[(0u + _e1571)];
                                                            let _e1592 = (_e1526.indices[3] >> bitcast<u32>(2i));
                                                            if (_e1592 < _e98) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1596 = alpha_texels.member[(0u + _e1592)];
                                                            phi_2242_ = (_e1495 * (((((f32(((_e1534 >> bitcast<u32>((((_e1526.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1526.weights.x) + ((f32(((_e1554 >> bitcast<u32>((((_e1526.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1526.weights.y)) + ((f32(((_e1575 >> bitcast<u32>((((_e1526.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1526.weights.z)) + ((f32(((_e1596 >> bitcast<u32>((((_e1526.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1526.weights.w)));
                                                        }
                                                        let _e1612 = phi_2242_;
                                                        phi_2245_ = (_e1612 >= _e1463.cutoff);
                                                    }
                                                    let _e1616 = phi_2245_;
                                                    phi_2246_ = _e1616;
                                                } else {
                                                    phi_2246_ = false;
                                                }
                                                let _e1618 = phi_2246_;
                                                phi_2247_ = _e1618;
                                            }
                                            let _e1620 = phi_2247_;
                                            if _e1620 {
                                                phi_2251_ = false;
                                            } else {
                                                phi_2251_ = true;
                                            }
                                            let _e1622 = phi_2251_;
                                            phi_2252_ = _e1620;
                                            phi_2253_ = _e1620;
                                            phi_2254_ = _e1622;
                                        } else {
                                            phi_2252_ = bool();
                                            phi_2253_ = _e966;
                                            phi_2254_ = true;
                                        }
                                        let _e1624 = phi_2252_;
                                        let _e1626 = phi_2253_;
                                        let _e1628 = phi_2254_;
                                        phi_2255_ = _e1624;
                                        phi_2256_ = _e1626;
                                        phi_2257_ = _e1628;
                                    } else {
                                        phi_2255_ = bool();
                                        phi_2256_ = _e966;
                                        phi_2257_ = true;
                                    }
                                    let _e1630 = phi_2255_;
                                    let _e1632 = phi_2256_;
                                    let _e1634 = phi_2257_;
                                    phi_2258_ = _e1630;
                                    phi_2259_ = _e1632;
                                    phi_2260_ = _e1634;
                                } else {
                                    phi_2258_ = bool();
                                    phi_2259_ = _e966;
                                    phi_2260_ = true;
                                }
                                let _e1636 = phi_2258_;
                                let _e1638 = phi_2259_;
                                let _e1640 = phi_2260_;
                                if _e1640 {
                                }
                                phi_1458_ = (_e964 & (_e964 - 1u));
                                phi_1461_ = _e1638;
                                phi_2264_ = _e1636;
                                phi_2265_ = _e1640;
                            }
                            let _e1642 = phi_1458_;
                            let _e1644 = phi_1461_;
                            let _e1646 = phi_2264_;
                            let _e1648 = phi_2265_;
                            local_8 = _e1646;
                            continue;
                            continuing {
                                phi_1457_ = _e1642;
                                phi_1460_ = _e1644;
                                break if !(_e1648);
                            }
                        }
                        let _e1651 = local_5;
                        if _e1651 {
                            let _e1653 = local_1.group_mask;
                            if ((_e1653 & 4278190080u) == 0u) {
                                let _e1657 = local_1.len;
                                if (_e1657 == 0u) {
                                    phi_2307_ = false;
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
                                    phi_2307_ = true;
                                }
                                let _e1680 = phi_2307_;
                                phi_2308_ = _e1680;
                            } else {
                                phi_2308_ = true;
                            }
                            let _e1682 = phi_2308_;
                            if _e1682 {
                                let _e1684 = local_1.group_mask;
                                let _e1690 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1684)), 32u, (_e1684 == 0u)));
                                let _e1694 = local_1.group_mask;
                                let _e1708 = local_1.group_mask;
                                local_1.group_mask = (_e1708 & ~((1u << bitcast<u32>((_e1690 & 31u)))));
                                let _e1711 = local_1.group;
                                phi_2339_ = (_e1711 + countOneBits(((_e1694 & ~((4294967295u << bitcast<u32>((((_e1690 - 24u) ^ _e388) & 31u))))) & 255u)));
                            } else {
                                phi_2339_ = 4294967295u;
                            }
                            let _e1714 = phi_2339_;
                            phi_2340_ = _e1714;
                        } else {
                            phi_2340_ = u32();
                        }
                        let _e1716 = phi_2340_;
                        phi_1126_ = _e1716;
                        let _e2014 = local_7;
                        phi_1129_ = _e2014;
                        let _e2017 = local_8;
                        phi_2341_ = _e2017;
                        let _e2020 = local_9;
                        phi_2342_ = _e2020;
                        phi_2343_ = false;
                    } else {
                        phi_1126_ = u32();
                        phi_1129_ = bool();
                        phi_2341_ = bool();
                        phi_2342_ = false;
                        phi_2343_ = true;
                    }
                    let _e1718 = phi_1126_;
                    let _e1720 = phi_1129_;
                    let _e1722 = phi_2341_;
                    let _e1724 = phi_2342_;
                    let _e1726 = phi_2343_;
                    local_6 = _e1726;
                    local_10 = _e1722;
                    continue;
                    continuing {
                        phi_1125_ = _e1718;
                        phi_1128_ = _e1720;
                        break if !(_e1724);
                    }
                }
                let _e1729 = local_6;
                if _e1729 {
                    phi_2347_ = false;
                } else {
                    phi_2347_ = true;
                }
                let _e1731 = phi_2347_;
                if _e1731 {
                    let _e2026 = local_10;
                    phi_2351_ = _e2026;
                } else {
                    let _e2028 = local_11;
                    phi_2351_ = _e2028;
                }
                let _e1733 = phi_2351_;
                phi_2352_ = _e1733;
            }
            let _e1735 = phi_2352_;
            phi_2353_ = _e1735;
            phi_2354_ = _e214;
        } else {
            phi_2353_ = bool();
            phi_2354_ = true;
        }
        let _e1737 = phi_2353_;
        let _e1739 = phi_2354_;
        if _e1739 {
            phi_2358_ = false;
        } else {
            phi_2358_ = _e1737;
        }
        let _e1741 = phi_2358_;
        if _e1741 {
            phi_2362_ = 0f;
        } else {
            phi_2362_ = 1f;
        }
        let _e1743 = phi_2362_;
        if (_e111 < _e83) {
        } else {
            return;
        }
        visibility.member[(0u + _e111)] = _e1743;
        let _e1749 = p.member.light.number;
        let _e1750 = (_e1749 * 3u);
        let _e1751 = (_e1750 / 32u);
        let _e1752 = (_e1750 % 32u);
        let _e1754 = p.member.light.mask_words;
        if (_e111 < _e83) {
        } else {
            return;
        }
        let _e1758 = visibility.member[(0u + _e111)];
        let _e1760 = ((_e111 * _e1754) + _e1751);
        if (_e1752 > 29u) {
            let _e1762 = (_e1760 + 1u);
            if (_e1762 < _e89) {
            } else {
                return;
            }
            let _e1766 = bits.member[(0u + _e1762)];
            phi_2403_ = _e1766;
        } else {
            phi_2403_ = 0u;
        }
        let _e1768 = phi_2403_;
        if (_e1760 < _e89) {
        } else {
            return;
        }
        let _e1772 = bits.member[(0u + _e1760)];
        let _e1775 = (_e1772 >> bitcast<u32>((_e1752 & 31u)));
        if (_e1752 > 29u) {
            phi_2422_ = (_e1775 | (_e1768 << bitcast<u32>(((32u - _e1752) & 31u))));
        } else {
            phi_2422_ = _e1775;
        }
        let _e1783 = phi_2422_;
        if ((_e1783 & 2u) == 0u) {
            phi_2430_ = (_e1783 & 1u);
        } else {
            phi_2430_ = (_e1783 & 7u);
        }
        let _e1789 = phi_2430_;
        if ((_e1789 & 1u) != 0u) {
            phi_2438_ = (2u | 1u);
        } else {
            phi_2438_ = 2u;
        }
        let _e1795 = phi_2438_;
        if (_e1758 < 0.5f) {
            phi_2443_ = (_e1795 | 4u);
        } else {
            phi_2443_ = _e1795;
        }
        let _e1798 = phi_2443_;
        let _e1800 = ((_e111 * _e1754) + _e1751);
        if (_e1800 < _e89) {
        } else {
            return;
        }
        let _e1804 = bits.member[(0u + _e1800)];
        if (_e1800 < _e89) {
        } else {
            return;
        }
        bits.member[(0u + _e1800)] = ((_e1804 & ~((7u << bitcast<u32>((_e1752 & 31u))))) | (_e1798 << bitcast<u32>((_e1752 & 31u))));
        if (_e1752 > 29u) {
            let _e1818 = (_e1800 + 1u);
            if (_e1818 < _e89) {
            } else {
                return;
            }
            let _e1822 = bits.member[(0u + _e1818)];
            let _e1823 = (32u - _e1752);
            let _e1833 = (_e1800 + 1u);
            if (_e1833 < _e89) {
            } else {
                return;
            }
            bits.member[(0u + _e1833)] = ((_e1822 & ~((7u >> bitcast<u32>((_e1823 & 31u))))) | (_e1798 >> bitcast<u32>((_e1823 & 31u))));
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_learn_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
