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
    var phi_717_: bool;
    var phi_718_: bool;
    var phi_719_: bool;
    var phi_720_: bool;
    var phi_724_: bool;
    var phi_737_: bool;
    var phi_738_: bool;
    var phi_739_: bool;
    var phi_740_: bool;
    var phi_744_: bool;
    var phi_757_: bool;
    var phi_758_: bool;
    var phi_759_: bool;
    var phi_763_: bool;
    var phi_764_: bool;
    var phi_765_: bool;
    var phi_766_: bool;
    var phi_767_: bool;
    var phi_771_: bool;
    var phi_841_: f32;
    var phi_848_: f32;
    var phi_855_: f32;
    var phi_862_: f32;
    var phi_869_: f32;
    var phi_876_: f32;
    var phi_893_: f32;
    var phi_898_: f32;
    var phi_903_: f32;
    var phi_908_: f32;
    var phi_913_: f32;
    var phi_939_: bool;
    var phi_940_: bool;
    var phi_948_: u32;
    var phi_949_: u32;
    var phi_960_: vec3<f32>;
    var phi_961_: vec3<f32>;
    var phi_974_: u32;
    var phi_979_: u32;
    var phi_984_: u32;
    var phi_1098_: bool;
    var phi_1099_: bool;
    var phi_1130_: u32;
    var phi_1132_: u32;
    var phi_1135_: bool;
    var phi_1215_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1242_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1269_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1275_: u32;
    var phi_1278_: u32;
    var phi_1292_: u32;
    var phi_1302_: u32;
    var phi_1312_: u32;
    var phi_1330_: u32;
    var phi_1340_: u32;
    var phi_1350_: u32;
    var phi_1386_: u32;
    var phi_1399_: u32;
    var phi_1404_: u32;
    var phi_1405_: u32;
    var phi_1406_: u32;
    var phi_1276_: u32;
    var phi_1279_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_1464_: u32;
    var phi_1467_: bool;
    var phi_1511_: vec3<f32>;
    var phi_1512_: vec3<f32>;
    var phi_1541_: vec3<f32>;
    var phi_1542_: vec3<f32>;
    var phi_1571_: vec3<f32>;
    var phi_1572_: vec3<f32>;
    var phi_1590_: bool;
    var phi_1591_: bool;
    var phi_1595_: f32;
    var phi_1596_: f32;
    var phi_1597_: f32;
    var phi_1598_: f32;
    var phi_1606_: f32;
    var phi_1616_: bool;
    var phi_1617_: bool;
    var phi_1621_: f32;
    var phi_1622_: f32;
    var phi_1623_: f32;
    var phi_1624_: f32;
    var phi_1632_: f32;
    var phi_1642_: bool;
    var phi_1643_: bool;
    var phi_1647_: f32;
    var phi_1648_: f32;
    var phi_1649_: f32;
    var phi_1650_: f32;
    var phi_1658_: f32;
    var phi_1673_: f32;
    var phi_1674_: bool;
    var phi_1675_: f32;
    var phi_1676_: bool;
    var phi_1677_: f32;
    var phi_1678_: bool;
    var phi_1696_: f32;
    var phi_1697_: bool;
    var phi_1698_: bool;
    var phi_1699_: f32;
    var phi_1700_: bool;
    var phi_1701_: bool;
    var phi_1705_: bool;
    var phi_1706_: f32;
    var phi_1707_: bool;
    var phi_1735_: vec3<f32>;
    var phi_1736_: vec3<f32>;
    var phi_1761_: vec3<f32>;
    var phi_1762_: vec3<f32>;
    var phi_1787_: vec3<f32>;
    var phi_1788_: vec3<f32>;
    var phi_1844_: f32;
    var phi_1853_: f32;
    var phi_1862_: f32;
    var phi_1871_: f32;
    var phi_1878_: f32;
    var phi_1885_: f32;
    var phi_1898_: f32;
    var phi_1907_: f32;
    var phi_1916_: f32;
    var phi_1925_: f32;
    var phi_1932_: f32;
    var phi_1939_: f32;
    var phi_1956_: f32;
    var phi_1961_: f32;
    var phi_1966_: f32;
    var phi_1974_: f32;
    var phi_1979_: f32;
    var phi_1984_: f32;
    var phi_1996_: f32;
    var phi_2001_: f32;
    var phi_2006_: f32;
    var phi_2011_: f32;
    var phi_2016_: lt_bvh_triangle_Intersection;
    var phi_2017_: bool;
    var phi_2018_: lt_bvh_triangle_Intersection;
    var phi_2019_: bool;
    var phi_2023_: lt_bvh_triangle_Intersection;
    var phi_2024_: bool;
    var phi_2025_: lt_bvh_triangle_Intersection;
    var phi_2026_: bool;
    var phi_2027_: bool;
    var phi_2031_: bool;
    var phi_2035_: lt_bvh_triangle_Intersection;
    var phi_2249_: f32;
    var phi_2252_: bool;
    var phi_2253_: bool;
    var phi_2254_: bool;
    var phi_2258_: bool;
    var phi_2259_: bool;
    var phi_2260_: bool;
    var phi_2261_: bool;
    var phi_2262_: bool;
    var phi_2263_: bool;
    var phi_2264_: bool;
    var phi_2265_: bool;
    var phi_2266_: bool;
    var phi_2267_: bool;
    var phi_1465_: u32;
    var phi_1468_: bool;
    var phi_2271_: bool;
    var phi_2272_: bool;
    var local_5: bool;
    var phi_2314_: bool;
    var phi_2315_: bool;
    var phi_2346_: u32;
    var phi_2347_: u32;
    var phi_1133_: u32;
    var phi_1136_: bool;
    var phi_2348_: bool;
    var phi_2349_: bool;
    var phi_2350_: bool;
    var local_6: bool;
    var phi_2354_: bool;
    var phi_2358_: bool;
    var phi_2359_: bool;
    var phi_2360_: bool;
    var phi_2361_: bool;
    var phi_2365_: bool;
    var phi_2369_: f32;
    var phi_2410_: u32;
    var phi_2429_: u32;
    var phi_2437_: u32;
    var phi_2445_: u32;
    var phi_2450_: u32;
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
        let _e153 = abs(_e149);
        let _e154 = abs(_e150);
        let _e155 = abs(_e151);
        if (abs(_e131) < 1000000000000000f) {
            if (abs(_e133) < 1000000000000000f) {
                phi_717_ = (abs(_e135) < 1000000000000000f);
                phi_718_ = false;
            } else {
                phi_717_ = bool();
                phi_718_ = true;
            }
            let _e163 = phi_717_;
            let _e165 = phi_718_;
            phi_719_ = _e163;
            phi_720_ = _e165;
        } else {
            phi_719_ = bool();
            phi_720_ = true;
        }
        let _e167 = phi_719_;
        let _e169 = phi_720_;
        if _e169 {
            phi_724_ = false;
        } else {
            phi_724_ = _e167;
        }
        let _e171 = phi_724_;
        if _e171 {
            if (_e153 < 1000000000000000f) {
                if (_e154 < 1000000000000000f) {
                    phi_737_ = (_e155 < 1000000000000000f);
                    phi_738_ = false;
                } else {
                    phi_737_ = bool();
                    phi_738_ = true;
                }
                let _e176 = phi_737_;
                let _e178 = phi_738_;
                phi_739_ = _e176;
                phi_740_ = _e178;
            } else {
                phi_739_ = bool();
                phi_740_ = true;
            }
            let _e180 = phi_739_;
            let _e182 = phi_740_;
            if _e182 {
                phi_744_ = false;
            } else {
                phi_744_ = _e180;
            }
            let _e184 = phi_744_;
            if _e184 {
                if (_e153 > 0f) {
                    phi_758_ = bool();
                    phi_759_ = true;
                } else {
                    let _e186 = (_e154 > 0f);
                    if _e186 {
                        phi_757_ = bool();
                    } else {
                        phi_757_ = (_e155 > 0f);
                    }
                    let _e189 = phi_757_;
                    phi_758_ = _e189;
                    phi_759_ = _e186;
                }
                let _e191 = phi_758_;
                let _e193 = phi_759_;
                if _e193 {
                    phi_763_ = true;
                } else {
                    phi_763_ = _e191;
                }
                let _e195 = phi_763_;
                phi_764_ = _e195;
                phi_765_ = false;
            } else {
                phi_764_ = bool();
                phi_765_ = true;
            }
            let _e197 = phi_764_;
            let _e199 = phi_765_;
            phi_766_ = _e197;
            phi_767_ = _e199;
        } else {
            phi_766_ = bool();
            phi_767_ = true;
        }
        let _e201 = phi_766_;
        let _e203 = phi_767_;
        if _e203 {
            phi_771_ = false;
        } else {
            phi_771_ = _e201;
        }
        let _e205 = phi_771_;
        if _e205 {
            let _e206 = (0u >= _e77);
            if _e206 {
                phi_2359_ = bool();
            } else {
                if (0u < _e77) {
                } else {
                    return;
                }
                let _e212 = nodes.member[(0u + 0u)].frame[0u];
                let _e216 = nodes.member[(0u + 0u)].frame[1u];
                let _e220 = nodes.member[(0u + 0u)].frame[2u];
                let _e224 = nodes.member[(0u + 0u)].frame[0u];
                let _e228 = nodes.member[(0u + 0u)].frame[1u];
                let _e232 = nodes.member[(0u + 0u)].frame[2u];
                let _e236 = nodes.member[(0u + 0u)].frame[3u];
                let _e270 = core_intrinsics_maximum_number_nsz_f32_(abs(_e149), abs(_e150));
                let _e271 = core_intrinsics_maximum_number_nsz_f32_(_e270, abs(_e151));
                let _e272 = (_e271 * 0.0000000000009094947f);
                if (abs(_e149) < _e272) {
                    phi_841_ = _e272;
                } else {
                    phi_841_ = abs(_e149);
                }
                let _e277 = phi_841_;
                if (_e149 < 0f) {
                    phi_848_ = (-1f / _e277);
                } else {
                    phi_848_ = (1f / _e277);
                }
                let _e282 = phi_848_;
                if (abs(_e150) < _e272) {
                    phi_855_ = _e272;
                } else {
                    phi_855_ = abs(_e150);
                }
                let _e287 = phi_855_;
                if (_e150 < 0f) {
                    phi_862_ = (-1f / _e287);
                } else {
                    phi_862_ = (1f / _e287);
                }
                let _e292 = phi_862_;
                if (abs(_e151) < _e272) {
                    phi_869_ = _e272;
                } else {
                    phi_869_ = abs(_e151);
                }
                let _e297 = phi_869_;
                if (_e151 < 0f) {
                    phi_876_ = (-1f / _e297);
                } else {
                    phi_876_ = (1f / _e297);
                }
                let _e302 = phi_876_;
                let _e306 = abs((bitcast<f32>(_e212) - _e131));
                let _e307 = abs((bitcast<f32>(_e216) - _e133));
                let _e308 = abs((bitcast<f32>(_e220) - _e135));
                let _e312 = abs(((bitcast<f32>(_e224) + (bitcast<f32>((((_e236 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e131));
                let _e313 = abs(((bitcast<f32>(_e228) + (bitcast<f32>((((_e236 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e133));
                let _e314 = abs(((bitcast<f32>(_e232) + (bitcast<f32>((((_e236 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e135));
                if (_e306 > _e312) {
                    phi_893_ = _e306;
                } else {
                    phi_893_ = _e312;
                }
                let _e317 = phi_893_;
                if (_e307 > _e313) {
                    phi_898_ = _e307;
                } else {
                    phi_898_ = _e313;
                }
                let _e320 = phi_898_;
                if (_e308 > _e314) {
                    phi_903_ = _e308;
                } else {
                    phi_903_ = _e314;
                }
                let _e323 = phi_903_;
                if (_e317 > _e320) {
                    phi_908_ = _e317;
                } else {
                    phi_908_ = _e320;
                }
                let _e326 = phi_908_;
                if (_e326 > _e323) {
                    phi_913_ = _e326;
                } else {
                    phi_913_ = _e323;
                }
                let _e329 = phi_913_;
                let _e333 = (_e329 * 0.0000019073486f);
                let _e334 = (abs(_e282) * _e333);
                let _e335 = (abs(_e292) * _e333);
                let _e336 = (abs(_e302) * _e333);
                let _e340 = (_e329 * 0.0000009536743f);
                let _e341 = (abs(_e282) * _e340);
                let _e342 = (abs(_e292) * _e340);
                let _e343 = (abs(_e302) * _e340);
                let _e344 = abs(_e149);
                let _e345 = abs(_e150);
                let _e346 = abs(_e151);
                if (_e344 >= _e345) {
                    if (_e344 >= _e346) {
                        phi_939_ = false;
                    } else {
                        phi_939_ = true;
                    }
                    let _e350 = phi_939_;
                    phi_940_ = _e350;
                } else {
                    phi_940_ = true;
                }
                let _e352 = phi_940_;
                if _e352 {
                    if (_e345 >= _e346) {
                        phi_948_ = 1u;
                    } else {
                        phi_948_ = 2u;
                    }
                    let _e355 = phi_948_;
                    phi_949_ = _e355;
                } else {
                    phi_949_ = 0u;
                }
                let _e357 = phi_949_;
                if (_e357 == 0u) {
                    phi_961_ = vec3<f32>(_e150, _e151, _e149);
                } else {
                    if (_e357 == 1u) {
                        phi_960_ = vec3<f32>(_e151, _e149, _e150);
                    } else {
                        phi_960_ = vec3<f32>(_e149, _e150, _e151);
                    }
                    let _e363 = phi_960_;
                    phi_961_ = _e363;
                }
                let _e365 = phi_961_;
                let _e368 = (_e365.x / _e365.z);
                let _e371 = (_e365.y / _e365.z);
                if (_e282 < 0f) {
                    phi_974_ = 0u;
                } else {
                    phi_974_ = 1u;
                }
                let _e376 = phi_974_;
                if (_e292 < 0f) {
                    phi_979_ = 0u;
                } else {
                    phi_979_ = 2u;
                }
                let _e379 = phi_979_;
                if (_e302 < 0f) {
                    phi_984_ = 0u;
                } else {
                    phi_984_ = 4u;
                }
                let _e382 = phi_984_;
                let _e384 = ((_e376 | _e379) | _e382);
                let _e385 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e385.first[0], _e385.first[1], _e385.first[2], _e385.first[3], _e385.first[4], _e385.first[5], _e385.first[6], _e385.first[7], _e385.first[8], _e385.first[9], _e385.first[10], _e385.first[11], _e385.first[12], _e385.first[13], _e385.first[14], _e385.first[15], _e385.first[16], _e385.first[17], _e385.first[18], _e385.first[19], _e385.first[20], _e385.first[21], _e385.first[22], _e385.first[23], _e385.first[24], _e385.first[25], _e385.first[26], _e385.first[27], _e385.first[28], _e385.first[29], _e385.first[30], _e385.first[31]), array<u32, 32>(_e385.mask[0], _e385.mask[1], _e385.mask[2], _e385.mask[3], _e385.mask[4], _e385.mask[5], _e385.mask[6], _e385.mask[7], _e385.mask[8], _e385.mask[9], _e385.mask[10], _e385.mask[11], _e385.mask[12], _e385.mask[13], _e385.mask[14], _e385.mask[15], _e385.mask[16], _e385.mask[17], _e385.mask[18], _e385.mask[19], _e385.mask[20], _e385.mask[21], _e385.mask[22], _e385.mask[23], _e385.mask[24], _e385.mask[25], _e385.mask[26], _e385.mask[27], _e385.mask[28], _e385.mask[29], _e385.mask[30], _e385.mask[31]), _e385.len, _e385.group, _e385.group_mask);
                let _e459 = local_1.group_mask;
                if ((_e459 & 4278190080u) == 0u) {
                    let _e463 = local_1.len;
                    if (_e463 == 0u) {
                        phi_1098_ = false;
                    } else {
                        let _e467 = local_1.len;
                        local_1.len = (_e467 - 1u);
                        let _e470 = local_1.len;
                        if (_e470 < 32u) {
                        } else {
                            return;
                        }
                        let _e475 = local_1.first[(0u + _e470)];
                        local_1.group = _e475;
                        let _e478 = local_1.len;
                        if (_e478 < 32u) {
                        } else {
                            return;
                        }
                        let _e483 = local_1.mask[(0u + _e478)];
                        local_1.group_mask = _e483;
                        phi_1098_ = true;
                    }
                    let _e486 = phi_1098_;
                    phi_1099_ = _e486;
                } else {
                    phi_1099_ = true;
                }
                let _e488 = phi_1099_;
                if _e488 {
                    let _e490 = local_1.group_mask;
                    let _e496 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e490)), 32u, (_e490 == 0u)));
                    let _e500 = local_1.group_mask;
                    let _e514 = local_1.group_mask;
                    local_1.group_mask = (_e514 & ~((1u << bitcast<u32>((_e496 & 31u)))));
                    let _e517 = local_1.group;
                    phi_1130_ = (_e517 + countOneBits(((_e500 & ~((4294967295u << bitcast<u32>((((_e496 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1130_ = 4294967295u;
                }
                let _e520 = phi_1130_;
                phi_1132_ = _e520;
                phi_1135_ = false;
                loop {
                    let _e522 = phi_1132_;
                    let _e524 = phi_1135_;
                    local_11 = _e524;
                    if (_e522 != 4294967295u) {
                        if (_e522 < _e77) {
                        } else {
                            return;
                        }
                        let _e531 = nodes.member[(0u + _e522)].frame[3u];
                        let _e556 = (bitcast<f32>((((_e531 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e282);
                        let _e557 = (bitcast<f32>((((_e531 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e292);
                        let _e558 = (bitcast<f32>((((_e531 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e302);
                        let _e561 = nodes.member[(0u + _e522)].frame[0u];
                        let _e565 = nodes.member[(0u + _e522)].frame[1u];
                        let _e569 = nodes.member[(0u + _e522)].frame[2u];
                        let _e574 = ((bitcast<f32>(_e561) - _e131) * _e282);
                        let _e575 = ((bitcast<f32>(_e565) - _e133) * _e292);
                        let _e576 = ((bitcast<f32>(_e569) - _e135) * _e302);
                        let _e584 = nodes.member[(0u + _e522)].x;
                        if (_e282 < 0f) {
                            let _e595 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e584.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e601 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e595.unnamed.word, _e584.w), _e595.unnamed_1);
                            let _e607 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e601.unnamed, lt_mask_LightPlace(_e584.x, _e601.unnamed_1.shift));
                            phi_1215_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e607.unnamed, lt_mask_LightPlace(_e607.unnamed_1.word, _e584.y));
                        } else {
                            let _e623 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e584.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e629 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e623.unnamed.word, _e584.y), _e623.unnamed_1);
                            let _e635 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e629.unnamed, lt_mask_LightPlace(_e584.z, _e629.unnamed_1.shift));
                            phi_1215_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e635.unnamed, lt_mask_LightPlace(_e635.unnamed_1.word, _e584.w));
                        }
                        let _e643 = phi_1215_;
                        let _e653 = nodes.member[(0u + _e522)].y;
                        if (_e292 < 0f) {
                            let _e664 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e653.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e670 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e664.unnamed.word, _e653.w), _e664.unnamed_1);
                            let _e676 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e670.unnamed, lt_mask_LightPlace(_e653.x, _e670.unnamed_1.shift));
                            phi_1242_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e676.unnamed, lt_mask_LightPlace(_e676.unnamed_1.word, _e653.y));
                        } else {
                            let _e692 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e653.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e698 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e692.unnamed.word, _e653.y), _e692.unnamed_1);
                            let _e704 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e698.unnamed, lt_mask_LightPlace(_e653.z, _e698.unnamed_1.shift));
                            phi_1242_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e704.unnamed, lt_mask_LightPlace(_e704.unnamed_1.word, _e653.w));
                        }
                        let _e712 = phi_1242_;
                        let _e722 = nodes.member[(0u + _e522)].z;
                        if (_e302 < 0f) {
                            let _e733 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e722.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e739 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e733.unnamed.word, _e722.w), _e733.unnamed_1);
                            let _e745 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e739.unnamed, lt_mask_LightPlace(_e722.x, _e739.unnamed_1.shift));
                            phi_1269_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e745.unnamed, lt_mask_LightPlace(_e745.unnamed_1.word, _e722.y));
                        } else {
                            let _e761 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e722.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e767 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e761.unnamed.word, _e722.y), _e761.unnamed_1);
                            let _e773 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e767.unnamed, lt_mask_LightPlace(_e722.z, _e767.unnamed_1.shift));
                            phi_1269_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e773.unnamed, lt_mask_LightPlace(_e773.unnamed_1.word, _e722.w));
                        }
                        let _e781 = phi_1269_;
                        phi_1275_ = 0u;
                        phi_1278_ = 0u;
                        loop {
                            let _e791 = phi_1275_;
                            let _e793 = phi_1278_;
                            local_2 = _e793;
                            local_3 = _e793;
                            local_4 = _e793;
                            let _e794 = (_e791 < 8u);
                            if _e794 {
                                let _e796 = (_e791 >> bitcast<u32>(2i));
                                let _e797 = (_e791 & 3u);
                                if (_e796 == 0u) {
                                    phi_1292_ = _e643.unnamed.word;
                                } else {
                                    phi_1292_ = _e643.unnamed.shift;
                                }
                                let _e800 = phi_1292_;
                                if (_e796 == 0u) {
                                    phi_1302_ = _e712.unnamed.word;
                                } else {
                                    phi_1302_ = _e712.unnamed.shift;
                                }
                                let _e809 = phi_1302_;
                                if (_e796 == 0u) {
                                    phi_1312_ = _e781.unnamed.word;
                                } else {
                                    phi_1312_ = _e781.unnamed.shift;
                                }
                                let _e818 = phi_1312_;
                                let _e831 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e800 >> bitcast<u32>(((_e797 * 8u) & 31u))) & 255u)) * _e556) + (_e574 - _e334)), ((f32(((_e809 >> bitcast<u32>(((_e797 * 8u) & 31u))) & 255u)) * _e557) + (_e575 - _e335)));
                                let _e832 = core_intrinsics_maximum_number_nsz_f32_(_e831, ((f32(((_e818 >> bitcast<u32>(((_e797 * 8u) & 31u))) & 255u)) * _e558) + (_e576 - _e336)));
                                if (_e796 == 0u) {
                                    phi_1330_ = _e643.unnamed_1.word;
                                } else {
                                    phi_1330_ = _e643.unnamed_1.shift;
                                }
                                let _e835 = phi_1330_;
                                if (_e796 == 0u) {
                                    phi_1340_ = _e712.unnamed_1.word;
                                } else {
                                    phi_1340_ = _e712.unnamed_1.shift;
                                }
                                let _e844 = phi_1340_;
                                if (_e796 == 0u) {
                                    phi_1350_ = _e781.unnamed_1.word;
                                } else {
                                    phi_1350_ = _e781.unnamed_1.shift;
                                }
                                let _e853 = phi_1350_;
                                let _e866 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e835 >> bitcast<u32>(((_e797 * 8u) & 31u))) & 255u)) * _e556) + (_e574 + _e334)), ((f32(((_e844 >> bitcast<u32>(((_e797 * 8u) & 31u))) & 255u)) * _e557) + (_e575 + _e335)));
                                let _e867 = core_intrinsics_minimum_number_nsz_f32_(_e866, ((f32(((_e853 >> bitcast<u32>(((_e797 * 8u) & 31u))) & 255u)) * _e558) + (_e576 + _e336)));
                                if (_e832 <= _e867) {
                                    if (_e832 <= _e141) {
                                        if (_e867 >= 0f) {
                                            if (_e796 == 0u) {
                                                let _e874 = nodes.member[(0u + _e522)].links[2u];
                                                phi_1386_ = _e874;
                                            } else {
                                                let _e877 = nodes.member[(0u + _e522)].links[3u];
                                                phi_1386_ = _e877;
                                            }
                                            let _e879 = phi_1386_;
                                            let _e884 = ((_e879 >> bitcast<u32>(((_e797 * 8u) & 31u))) & 255u);
                                            let _e885 = (_e884 & 31u);
                                            if (_e885 >= 24u) {
                                                phi_1399_ = (24u + ((_e885 - 24u) ^ _e384));
                                            } else {
                                                phi_1399_ = _e885;
                                            }
                                            let _e891 = phi_1399_;
                                            phi_1404_ = (_e793 | ((_e884 >> bitcast<u32>(5i)) << bitcast<u32>((_e891 & 31u))));
                                        } else {
                                            phi_1404_ = _e793;
                                        }
                                        let _e899 = phi_1404_;
                                        phi_1405_ = _e899;
                                    } else {
                                        phi_1405_ = _e793;
                                    }
                                    let _e901 = phi_1405_;
                                    phi_1406_ = _e901;
                                } else {
                                    phi_1406_ = _e793;
                                }
                                let _e903 = phi_1406_;
                                phi_1276_ = (_e791 + 1u);
                                phi_1279_ = _e903;
                            } else {
                                phi_1276_ = u32();
                                phi_1279_ = u32();
                            }
                            let _e906 = phi_1276_;
                            let _e908 = phi_1279_;
                            continue;
                            continuing {
                                phi_1275_ = _e906;
                                phi_1278_ = _e908;
                                break if !(_e794);
                            }
                        }
                        let _e912 = nodes.member[(0u + _e522)].links[0u];
                        let _e916 = nodes.member[(0u + _e522)].frame[3u];
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
                        phi_1464_ = (_e957 & 16777215u);
                        phi_1467_ = _e524;
                        loop {
                            let _e960 = phi_1464_;
                            let _e962 = phi_1467_;
                            local_7 = _e962;
                            let _e963 = (_e960 == 0u);
                            local_5 = _e963;
                            local_9 = _e963;
                            if _e963 {
                                phi_1465_ = u32();
                                phi_1468_ = bool();
                                phi_2271_ = bool();
                                phi_2272_ = false;
                            } else {
                                let _e966 = nodes.member[(0u + _e522)].links[1u];
                                let _e971 = ((0u + _e966) + select(firstTrailingBit(_e960), 32u, (_e960 == 0u)));
                                if (_e971 < _e80) {
                                } else {
                                    return;
                                }
                                let _e978 = triangles.member[(0u + _e971)].v0_;
                                let _e980 = (_e978.x - _e131);
                                let _e982 = (_e978.y - _e133);
                                let _e984 = (_e978.z - _e135);
                                if (_e357 == 0u) {
                                    phi_1512_ = vec3<f32>(_e982, _e984, _e980);
                                } else {
                                    if (_e357 == 1u) {
                                        phi_1511_ = vec3<f32>(_e984, _e980, _e982);
                                    } else {
                                        phi_1511_ = (_e978 - vec3<f32>(_e131, _e133, _e135));
                                    }
                                    let _e992 = phi_1511_;
                                    phi_1512_ = _e992;
                                }
                                let _e994 = phi_1512_;
                                let _e998 = (_e994.x - (_e368 * _e994.z));
                                let _e1002 = (_e994.y - (_e371 * _e994.z));
                                let _e1004 = triangles.member[(0u + _e971)].v1_;
                                let _e1006 = (_e1004.x - _e131);
                                let _e1008 = (_e1004.y - _e133);
                                let _e1010 = (_e1004.z - _e135);
                                if (_e357 == 0u) {
                                    phi_1542_ = vec3<f32>(_e1008, _e1010, _e1006);
                                } else {
                                    if (_e357 == 1u) {
                                        phi_1541_ = vec3<f32>(_e1010, _e1006, _e1008);
                                    } else {
                                        phi_1541_ = (_e1004 - vec3<f32>(_e131, _e133, _e135));
                                    }
                                    let _e1018 = phi_1541_;
                                    phi_1542_ = _e1018;
                                }
                                let _e1020 = phi_1542_;
                                let _e1024 = (_e1020.x - (_e368 * _e1020.z));
                                let _e1028 = (_e1020.y - (_e371 * _e1020.z));
                                let _e1030 = triangles.member[(0u + _e971)].v2_;
                                let _e1032 = (_e1030.x - _e131);
                                let _e1034 = (_e1030.y - _e133);
                                let _e1036 = (_e1030.z - _e135);
                                if (_e357 == 0u) {
                                    phi_1572_ = vec3<f32>(_e1034, _e1036, _e1032);
                                } else {
                                    if (_e357 == 1u) {
                                        phi_1571_ = vec3<f32>(_e1036, _e1032, _e1034);
                                    } else {
                                        phi_1571_ = (_e1030 - vec3<f32>(_e131, _e133, _e135));
                                    }
                                    let _e1044 = phi_1571_;
                                    phi_1572_ = _e1044;
                                }
                                let _e1046 = phi_1572_;
                                let _e1050 = (_e1046.x - (_e368 * _e1046.z));
                                let _e1054 = (_e1046.y - (_e371 * _e1046.z));
                                if (_e1024 < _e1050) {
                                    phi_1591_ = true;
                                } else {
                                    if (_e1024 == _e1050) {
                                        phi_1590_ = (_e1028 < _e1054);
                                    } else {
                                        phi_1590_ = false;
                                    }
                                    let _e1059 = phi_1590_;
                                    phi_1591_ = _e1059;
                                }
                                let _e1061 = phi_1591_;
                                if _e1061 {
                                    phi_1595_ = _e1054;
                                    phi_1596_ = _e1050;
                                    phi_1597_ = _e1028;
                                    phi_1598_ = _e1024;
                                } else {
                                    phi_1595_ = _e1028;
                                    phi_1596_ = _e1024;
                                    phi_1597_ = _e1054;
                                    phi_1598_ = _e1050;
                                }
                                let _e1063 = phi_1595_;
                                let _e1065 = phi_1596_;
                                let _e1067 = phi_1597_;
                                let _e1069 = phi_1598_;
                                let _e1072 = ((_e1069 * _e1063) - (_e1067 * _e1065));
                                if _e1061 {
                                    phi_1606_ = -(_e1072);
                                } else {
                                    phi_1606_ = _e1072;
                                }
                                let _e1075 = phi_1606_;
                                if (_e1050 < _e998) {
                                    phi_1617_ = true;
                                } else {
                                    if (_e1050 == _e998) {
                                        phi_1616_ = (_e1054 < _e1002);
                                    } else {
                                        phi_1616_ = false;
                                    }
                                    let _e1080 = phi_1616_;
                                    phi_1617_ = _e1080;
                                }
                                let _e1082 = phi_1617_;
                                if _e1082 {
                                    phi_1621_ = _e1002;
                                    phi_1622_ = _e998;
                                    phi_1623_ = _e1054;
                                    phi_1624_ = _e1050;
                                } else {
                                    phi_1621_ = _e1054;
                                    phi_1622_ = _e1050;
                                    phi_1623_ = _e1002;
                                    phi_1624_ = _e998;
                                }
                                let _e1084 = phi_1621_;
                                let _e1086 = phi_1622_;
                                let _e1088 = phi_1623_;
                                let _e1090 = phi_1624_;
                                let _e1093 = ((_e1090 * _e1084) - (_e1088 * _e1086));
                                if _e1082 {
                                    phi_1632_ = -(_e1093);
                                } else {
                                    phi_1632_ = _e1093;
                                }
                                let _e1096 = phi_1632_;
                                if (_e998 < _e1024) {
                                    phi_1643_ = true;
                                } else {
                                    if (_e998 == _e1024) {
                                        phi_1642_ = (_e1002 < _e1028);
                                    } else {
                                        phi_1642_ = false;
                                    }
                                    let _e1101 = phi_1642_;
                                    phi_1643_ = _e1101;
                                }
                                let _e1103 = phi_1643_;
                                if _e1103 {
                                    phi_1647_ = _e1028;
                                    phi_1648_ = _e1024;
                                    phi_1649_ = _e1002;
                                    phi_1650_ = _e998;
                                } else {
                                    phi_1647_ = _e1002;
                                    phi_1648_ = _e998;
                                    phi_1649_ = _e1028;
                                    phi_1650_ = _e1024;
                                }
                                let _e1105 = phi_1647_;
                                let _e1107 = phi_1648_;
                                let _e1109 = phi_1649_;
                                let _e1111 = phi_1650_;
                                let _e1114 = ((_e1111 * _e1105) - (_e1109 * _e1107));
                                if _e1103 {
                                    phi_1658_ = -(_e1114);
                                } else {
                                    phi_1658_ = _e1114;
                                }
                                let _e1117 = phi_1658_;
                                if (_e1075 >= 0f) {
                                    if (_e1096 >= 0f) {
                                        if (_e1117 >= 0f) {
                                            phi_1673_ = ((_e1075 + _e1096) + _e1117);
                                            phi_1674_ = false;
                                        } else {
                                            phi_1673_ = f32();
                                            phi_1674_ = true;
                                        }
                                        let _e1124 = phi_1673_;
                                        let _e1126 = phi_1674_;
                                        phi_1675_ = _e1124;
                                        phi_1676_ = _e1126;
                                    } else {
                                        phi_1675_ = f32();
                                        phi_1676_ = true;
                                    }
                                    let _e1128 = phi_1675_;
                                    let _e1130 = phi_1676_;
                                    phi_1677_ = _e1128;
                                    phi_1678_ = _e1130;
                                } else {
                                    phi_1677_ = f32();
                                    phi_1678_ = true;
                                }
                                let _e1132 = phi_1677_;
                                let _e1134 = phi_1678_;
                                if _e1134 {
                                    if (_e1075 <= 0f) {
                                        if (_e1096 <= 0f) {
                                            let _e1137 = (_e1117 <= 0f);
                                            if _e1137 {
                                            }
                                            phi_1696_ = ((_e1075 + _e1096) + _e1117);
                                            phi_1697_ = false;
                                            phi_1698_ = _e1137;
                                        } else {
                                            phi_1696_ = f32();
                                            phi_1697_ = true;
                                            phi_1698_ = false;
                                        }
                                        let _e1141 = phi_1696_;
                                        let _e1143 = phi_1697_;
                                        let _e1145 = phi_1698_;
                                        phi_1699_ = _e1141;
                                        phi_1700_ = _e1143;
                                        phi_1701_ = _e1145;
                                    } else {
                                        phi_1699_ = f32();
                                        phi_1700_ = true;
                                        phi_1701_ = false;
                                    }
                                    let _e1147 = phi_1699_;
                                    let _e1149 = phi_1700_;
                                    let _e1151 = phi_1701_;
                                    if _e1149 {
                                        phi_1705_ = false;
                                    } else {
                                        phi_1705_ = _e1151;
                                    }
                                    let _e1153 = phi_1705_;
                                    phi_1706_ = _e1147;
                                    phi_1707_ = _e1153;
                                } else {
                                    phi_1706_ = _e1132;
                                    phi_1707_ = true;
                                }
                                let _e1155 = phi_1706_;
                                let _e1157 = phi_1707_;
                                if _e1157 {
                                    let _e1158 = (_e1155 == 0f);
                                    if _e1158 {
                                        phi_2023_ = lt_bvh_triangle_Intersection();
                                        phi_2024_ = false;
                                    } else {
                                        let _e1160 = triangles.member[(0u + _e971)].v0_;
                                        let _e1162 = (_e1160.x - _e131);
                                        let _e1164 = (_e1160.y - _e133);
                                        let _e1166 = (_e1160.z - _e135);
                                        if (_e357 == 0u) {
                                            phi_1736_ = vec3<f32>(_e1164, _e1166, _e1162);
                                        } else {
                                            if (_e357 == 1u) {
                                                phi_1735_ = vec3<f32>(_e1166, _e1162, _e1164);
                                            } else {
                                                phi_1735_ = (_e1160 - vec3<f32>(_e131, _e133, _e135));
                                            }
                                            let _e1174 = phi_1735_;
                                            phi_1736_ = _e1174;
                                        }
                                        let _e1176 = phi_1736_;
                                        let _e1178 = triangles.member[(0u + _e971)].v1_;
                                        let _e1180 = triangles.member[(0u + _e971)].v0_;
                                        let _e1183 = (_e1178.x - _e1180.x);
                                        let _e1186 = (_e1178.y - _e1180.y);
                                        let _e1189 = (_e1178.z - _e1180.z);
                                        if (_e357 == 0u) {
                                            phi_1762_ = vec3<f32>(_e1186, _e1189, _e1183);
                                        } else {
                                            if (_e357 == 1u) {
                                                phi_1761_ = vec3<f32>(_e1189, _e1183, _e1186);
                                            } else {
                                                phi_1761_ = (_e1178 - _e1180);
                                            }
                                            let _e1196 = phi_1761_;
                                            phi_1762_ = _e1196;
                                        }
                                        let _e1198 = phi_1762_;
                                        let _e1200 = triangles.member[(0u + _e971)].v2_;
                                        let _e1202 = triangles.member[(0u + _e971)].v0_;
                                        let _e1205 = (_e1200.x - _e1202.x);
                                        let _e1208 = (_e1200.y - _e1202.y);
                                        let _e1211 = (_e1200.z - _e1202.z);
                                        if (_e357 == 0u) {
                                            phi_1788_ = vec3<f32>(_e1208, _e1211, _e1205);
                                        } else {
                                            if (_e357 == 1u) {
                                                phi_1787_ = vec3<f32>(_e1211, _e1205, _e1208);
                                            } else {
                                                phi_1787_ = (_e1200 - _e1202);
                                            }
                                            let _e1218 = phi_1787_;
                                            phi_1788_ = _e1218;
                                        }
                                        let _e1220 = phi_1788_;
                                        let _e1227 = ((_e1198.y * _e1220.z) - (_e1198.z * _e1220.y));
                                        let _e1234 = ((_e1198.z * _e1220.x) - (_e1198.x * _e1220.z));
                                        let _e1241 = ((_e1198.x * _e1220.y) - (_e1198.y * _e1220.x));
                                        let _e1255 = (((1f / _e365.z) * (((_e1227 * _e1176.x) + (_e1234 * _e1176.y)) + (_e1241 * _e1176.z))) / (((_e1227 * _e368) + (_e1234 * _e371)) + _e1241));
                                        if (_e1255 > 0f) {
                                            if (_e1255 < _e141) {
                                                let _e1259 = triangles.member[(0u + _e971)].v0_;
                                                let _e1261 = triangles.member[(0u + _e971)].v1_;
                                                if (_e1259.x < _e1261.x) {
                                                    phi_1844_ = _e1259.x;
                                                } else {
                                                    phi_1844_ = _e1261.x;
                                                }
                                                let _e1268 = phi_1844_;
                                                if (_e1259.y < _e1261.y) {
                                                    phi_1853_ = _e1259.y;
                                                } else {
                                                    phi_1853_ = _e1261.y;
                                                }
                                                let _e1275 = phi_1853_;
                                                if (_e1259.z < _e1261.z) {
                                                    phi_1862_ = _e1259.z;
                                                } else {
                                                    phi_1862_ = _e1261.z;
                                                }
                                                let _e1282 = phi_1862_;
                                                let _e1284 = triangles.member[(0u + _e971)].v2_;
                                                if (_e1268 < _e1284.x) {
                                                    phi_1871_ = _e1268;
                                                } else {
                                                    phi_1871_ = _e1284.x;
                                                }
                                                let _e1289 = phi_1871_;
                                                if (_e1275 < _e1284.y) {
                                                    phi_1878_ = _e1275;
                                                } else {
                                                    phi_1878_ = _e1284.y;
                                                }
                                                let _e1294 = phi_1878_;
                                                if (_e1282 < _e1284.z) {
                                                    phi_1885_ = _e1282;
                                                } else {
                                                    phi_1885_ = _e1284.z;
                                                }
                                                let _e1299 = phi_1885_;
                                                let _e1301 = triangles.member[(0u + _e971)].v0_;
                                                let _e1303 = triangles.member[(0u + _e971)].v1_;
                                                if (_e1301.x > _e1303.x) {
                                                    phi_1898_ = _e1301.x;
                                                } else {
                                                    phi_1898_ = _e1303.x;
                                                }
                                                let _e1310 = phi_1898_;
                                                if (_e1301.y > _e1303.y) {
                                                    phi_1907_ = _e1301.y;
                                                } else {
                                                    phi_1907_ = _e1303.y;
                                                }
                                                let _e1317 = phi_1907_;
                                                if (_e1301.z > _e1303.z) {
                                                    phi_1916_ = _e1301.z;
                                                } else {
                                                    phi_1916_ = _e1303.z;
                                                }
                                                let _e1324 = phi_1916_;
                                                let _e1326 = triangles.member[(0u + _e971)].v2_;
                                                if (_e1310 > _e1326.x) {
                                                    phi_1925_ = _e1310;
                                                } else {
                                                    phi_1925_ = _e1326.x;
                                                }
                                                let _e1331 = phi_1925_;
                                                if (_e1317 > _e1326.y) {
                                                    phi_1932_ = _e1317;
                                                } else {
                                                    phi_1932_ = _e1326.y;
                                                }
                                                let _e1336 = phi_1932_;
                                                if (_e1324 > _e1326.z) {
                                                    phi_1939_ = _e1324;
                                                } else {
                                                    phi_1939_ = _e1326.z;
                                                }
                                                let _e1341 = phi_1939_;
                                                let _e1345 = ((_e1289 - _e131) * _e282);
                                                let _e1346 = ((_e1294 - _e133) * _e292);
                                                let _e1347 = ((_e1299 - _e135) * _e302);
                                                let _e1351 = ((_e1331 - _e131) * _e282);
                                                let _e1352 = ((_e1336 - _e133) * _e292);
                                                let _e1353 = ((_e1341 - _e135) * _e302);
                                                if (_e1345 < _e1351) {
                                                    phi_1956_ = _e1345;
                                                } else {
                                                    phi_1956_ = _e1351;
                                                }
                                                let _e1356 = phi_1956_;
                                                if (_e1346 < _e1352) {
                                                    phi_1961_ = _e1346;
                                                } else {
                                                    phi_1961_ = _e1352;
                                                }
                                                let _e1359 = phi_1961_;
                                                if (_e1347 < _e1353) {
                                                    phi_1966_ = _e1347;
                                                } else {
                                                    phi_1966_ = _e1353;
                                                }
                                                let _e1362 = phi_1966_;
                                                if (_e1345 > _e1351) {
                                                    phi_1974_ = _e1345;
                                                } else {
                                                    phi_1974_ = _e1351;
                                                }
                                                let _e1368 = phi_1974_;
                                                if (_e1346 > _e1352) {
                                                    phi_1979_ = _e1346;
                                                } else {
                                                    phi_1979_ = _e1352;
                                                }
                                                let _e1371 = phi_1979_;
                                                if (_e1347 > _e1353) {
                                                    phi_1984_ = _e1347;
                                                } else {
                                                    phi_1984_ = _e1353;
                                                }
                                                let _e1374 = phi_1984_;
                                                let _e1378 = core_intrinsics_maximum_number_nsz_f32_((_e1356 - _e341), (_e1359 - _e342));
                                                let _e1379 = core_intrinsics_maximum_number_nsz_f32_(_e1378, (_e1362 - _e343));
                                                let _e1380 = core_intrinsics_minimum_number_nsz_f32_((_e1368 + _e341), (_e1371 + _e342));
                                                let _e1381 = core_intrinsics_minimum_number_nsz_f32_(_e1380, (_e1374 + _e343));
                                                if (_e1379 > -300000000000000000000000000000000000000f) {
                                                    phi_1996_ = _e1379;
                                                } else {
                                                    phi_1996_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1384 = phi_1996_;
                                                if (_e1381 < 300000000000000000000000000000000000000f) {
                                                    phi_2001_ = _e1381;
                                                } else {
                                                    phi_2001_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1387 = phi_2001_;
                                                if (_e1255 < _e1384) {
                                                    phi_2006_ = _e1384;
                                                } else {
                                                    phi_2006_ = _e1255;
                                                }
                                                let _e1390 = phi_2006_;
                                                if (_e1390 > _e1387) {
                                                    phi_2011_ = _e1387;
                                                } else {
                                                    phi_2011_ = _e1390;
                                                }
                                                let _e1393 = phi_2011_;
                                                phi_2016_ = lt_bvh_triangle_Intersection(_e1393, (_e1096 / _e1155), (_e1117 / _e1155), (_e1384 <= _e1387));
                                                phi_2017_ = false;
                                            } else {
                                                phi_2016_ = lt_bvh_triangle_Intersection();
                                                phi_2017_ = true;
                                            }
                                            let _e1399 = phi_2016_;
                                            let _e1401 = phi_2017_;
                                            phi_2018_ = _e1399;
                                            phi_2019_ = _e1401;
                                        } else {
                                            phi_2018_ = lt_bvh_triangle_Intersection();
                                            phi_2019_ = true;
                                        }
                                        let _e1403 = phi_2018_;
                                        let _e1405 = phi_2019_;
                                        if _e1405 {
                                        }
                                        phi_2023_ = _e1403;
                                        phi_2024_ = _e1405;
                                    }
                                    let _e1407 = phi_2023_;
                                    let _e1409 = phi_2024_;
                                    phi_2025_ = _e1407;
                                    phi_2026_ = _e1158;
                                    phi_2027_ = _e1409;
                                } else {
                                    phi_2025_ = lt_bvh_triangle_Intersection();
                                    phi_2026_ = true;
                                    phi_2027_ = false;
                                }
                                let _e1411 = phi_2025_;
                                let _e1413 = phi_2026_;
                                let _e1415 = phi_2027_;
                                if _e1413 {
                                    phi_2031_ = true;
                                } else {
                                    phi_2031_ = _e1415;
                                }
                                let _e1417 = phi_2031_;
                                if _e1417 {
                                    phi_2035_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_2035_ = _e1411;
                                }
                                let _e1419 = phi_2035_;
                                if _e1419.is_hit {
                                    if (_e1419.t > 0f) {
                                        if (_e1419.t < _e141) {
                                            let _e1426 = triangles.member[(0u + _e971)].i0_;
                                            if ((_e1426 & 2147483648u) == 0u) {
                                                phi_2254_ = true;
                                            } else {
                                                if (_e971 < _e80) {
                                                } else {
                                                    return;
                                                }
                                                let _e1435 = triangles.member[(0u + _e971)].i0_;
                                                let _e1436 = (_e1435 & 2147483647u);
                                                let _e1438 = triangles.member[(0u + _e971)].i1_;
                                                let _e1440 = triangles.member[(0u + _e971)].i2_;
                                                if (_e1436 < _e92) {
                                                } else {
                                                    return;
                                                }
                                                let _e1444 = vertices.member[(0u + _e1436)];
                                                if (_e1438 < _e92) {
                                                } else {
                                                    return;
                                                }
                                                let _e1448 = vertices.member[(0u + _e1438)];
                                                if (_e1440 < _e92) {
                                                } else {
                                                    return;
                                                }
                                                let _e1452 = vertices.member[(0u + _e1440)];
                                                let _e1453 = array<abi_Vertex, 3>(_e1444, _e1448, _e1452);
                                                if (_e1453[0].material < arrayLength((&materials.member))) {
                                                } else {
                                                    return;
                                                }
                                                let _e1459 = materials.member[(0u + _e1453[0].material)];
                                                if ((_e1459.flags & 1u) == 1u) {
                                                    let _e1464 = ((1f - _e1419.u) - _e1419.v);
                                                    if (_e1459.cutoff <= 0f) {
                                                        phi_2252_ = true;
                                                    } else {
                                                        let _e1491 = (_e1459.base_color.w * ((((f32((_e1453[0].color >> bitcast<u32>(24i))) * _e1464) + (f32((_e1453[1].color >> bitcast<u32>(24i))) * _e1419.u)) + (f32((_e1453[2].color >> bitcast<u32>(24i))) * _e1419.v)) * (1f / 255f)));
                                                        if (_e1459.alpha_size == 0u) {
                                                            phi_2249_ = _e1491;
                                                        } else {
                                                            local.offset = _e1459.alpha_offset;
                                                            local.size = _e1459.alpha_size;
                                                            local.flags = _e1459.flags;
                                                            let _e1522 = _lt_shaders_texture_TextureView_quad((&local), (((_e1453[0].u * _e1464) + (_e1453[1].u * _e1419.u)) + (_e1453[2].u * _e1419.v)), (((_e1453[0].v * _e1464) + (_e1453[1].v * _e1419.u)) + (_e1453[2].v * _e1419.v)));
                                                            let _e1526 = (_e1522.indices[0] >> bitcast<u32>(2i));
                                                            if (_e1526 < _e98) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1530 = alpha_texels.member[(0u + _e1526)];
                                                            let _e1546 = (_e1522.indices[1] >> bitcast<u32>(2i));
                                                            if (_e1546 < _e98) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1550 = alpha_texels.member[(0u + _e1546)];
                                                            let _e1567 = (_e1522.indices[2] >> bitcast<u32>(2i));
                                                            if (_e1567 < _e98) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1571 = alpha_texels.member[(0u + _e1567)];
                                                            let _e1588 = (_e1522.indices[3] >> bitcast<u32>(2i));
                                                            if (_e1588 < _e98) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1592 = alpha_texels.member[(0u + _e1588)];
                                                            phi_2249_ = (_e1491 * (((((f32(((_e1530 >> bitcast<u32>((((_e1522.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1522.weights.x) + ((f32(((_e1550 >> bitcast<u32>((((_e1522.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1522.weights.y)) + ((f32(((_e1571 >> bitcast<u32>((((_e1522.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1522.weights.z)) + ((f32(((_e1592 >> bitcast<u32>((((_e1522.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1522.weights.w)));
                                                        }
                                                        let _e1608 = phi_2249_;
                                                        phi_2252_ = (_e1608 >= _e1459.cutoff);
                                                    }
                                                    let _e1612 = phi_2252_;
                                                    phi_2253_ = _e1612;
                                                } else {
                                                    phi_2253_ = false;
                                                }
                                                let _e1614 = phi_2253_;
                                                phi_2254_ = _e1614;
                                            }
                                            let _e1616 = phi_2254_;
                                            if _e1616 {
                                                phi_2258_ = false;
                                            } else {
                                                phi_2258_ = true;
                                            }
                                            let _e1618 = phi_2258_;
                                            phi_2259_ = _e1616;
                                            phi_2260_ = _e1616;
                                            phi_2261_ = _e1618;
                                        } else {
                                            phi_2259_ = bool();
                                            phi_2260_ = _e962;
                                            phi_2261_ = true;
                                        }
                                        let _e1620 = phi_2259_;
                                        let _e1622 = phi_2260_;
                                        let _e1624 = phi_2261_;
                                        phi_2262_ = _e1620;
                                        phi_2263_ = _e1622;
                                        phi_2264_ = _e1624;
                                    } else {
                                        phi_2262_ = bool();
                                        phi_2263_ = _e962;
                                        phi_2264_ = true;
                                    }
                                    let _e1626 = phi_2262_;
                                    let _e1628 = phi_2263_;
                                    let _e1630 = phi_2264_;
                                    phi_2265_ = _e1626;
                                    phi_2266_ = _e1628;
                                    phi_2267_ = _e1630;
                                } else {
                                    phi_2265_ = bool();
                                    phi_2266_ = _e962;
                                    phi_2267_ = true;
                                }
                                let _e1632 = phi_2265_;
                                let _e1634 = phi_2266_;
                                let _e1636 = phi_2267_;
                                if _e1636 {
                                }
                                phi_1465_ = (_e960 & (_e960 - 1u));
                                phi_1468_ = _e1634;
                                phi_2271_ = _e1632;
                                phi_2272_ = _e1636;
                            }
                            let _e1638 = phi_1465_;
                            let _e1640 = phi_1468_;
                            let _e1642 = phi_2271_;
                            let _e1644 = phi_2272_;
                            local_8 = _e1642;
                            continue;
                            continuing {
                                phi_1464_ = _e1638;
                                phi_1467_ = _e1640;
                                break if !(_e1644);
                            }
                        }
                        let _e1647 = local_5;
                        if _e1647 {
                            let _e1649 = local_1.group_mask;
                            if ((_e1649 & 4278190080u) == 0u) {
                                let _e1653 = local_1.len;
                                if (_e1653 == 0u) {
                                    phi_2314_ = false;
                                } else {
                                    let _e1657 = local_1.len;
                                    local_1.len = (_e1657 - 1u);
                                    let _e1660 = local_1.len;
                                    if (_e1660 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1665 = local_1.first[(0u + _e1660)];
                                    local_1.group = _e1665;
                                    let _e1668 = local_1.len;
                                    if (_e1668 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1673 = local_1.mask[(0u + _e1668)];
                                    local_1.group_mask = _e1673;
                                    phi_2314_ = true;
                                }
                                let _e1676 = phi_2314_;
                                phi_2315_ = _e1676;
                            } else {
                                phi_2315_ = true;
                            }
                            let _e1678 = phi_2315_;
                            if _e1678 {
                                let _e1680 = local_1.group_mask;
                                let _e1686 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1680)), 32u, (_e1680 == 0u)));
                                let _e1690 = local_1.group_mask;
                                let _e1704 = local_1.group_mask;
                                local_1.group_mask = (_e1704 & ~((1u << bitcast<u32>((_e1686 & 31u)))));
                                let _e1707 = local_1.group;
                                phi_2346_ = (_e1707 + countOneBits(((_e1690 & ~((4294967295u << bitcast<u32>((((_e1686 - 24u) ^ _e384) & 31u))))) & 255u)));
                            } else {
                                phi_2346_ = 4294967295u;
                            }
                            let _e1710 = phi_2346_;
                            phi_2347_ = _e1710;
                        } else {
                            phi_2347_ = u32();
                        }
                        let _e1712 = phi_2347_;
                        phi_1133_ = _e1712;
                        let _e2008 = local_7;
                        phi_1136_ = _e2008;
                        let _e2011 = local_8;
                        phi_2348_ = _e2011;
                        let _e2014 = local_9;
                        phi_2349_ = _e2014;
                        phi_2350_ = false;
                    } else {
                        phi_1133_ = u32();
                        phi_1136_ = bool();
                        phi_2348_ = bool();
                        phi_2349_ = false;
                        phi_2350_ = true;
                    }
                    let _e1714 = phi_1133_;
                    let _e1716 = phi_1136_;
                    let _e1718 = phi_2348_;
                    let _e1720 = phi_2349_;
                    let _e1722 = phi_2350_;
                    local_6 = _e1722;
                    local_10 = _e1718;
                    continue;
                    continuing {
                        phi_1132_ = _e1714;
                        phi_1135_ = _e1716;
                        break if !(_e1720);
                    }
                }
                let _e1725 = local_6;
                if _e1725 {
                    phi_2354_ = false;
                } else {
                    phi_2354_ = true;
                }
                let _e1727 = phi_2354_;
                if _e1727 {
                    let _e2020 = local_10;
                    phi_2358_ = _e2020;
                } else {
                    let _e2022 = local_11;
                    phi_2358_ = _e2022;
                }
                let _e1729 = phi_2358_;
                phi_2359_ = _e1729;
            }
            let _e1731 = phi_2359_;
            phi_2360_ = _e1731;
            phi_2361_ = _e206;
        } else {
            phi_2360_ = bool();
            phi_2361_ = true;
        }
        let _e1733 = phi_2360_;
        let _e1735 = phi_2361_;
        if _e1735 {
            phi_2365_ = false;
        } else {
            phi_2365_ = _e1733;
        }
        let _e1737 = phi_2365_;
        if _e1737 {
            phi_2369_ = 0f;
        } else {
            phi_2369_ = 1f;
        }
        let _e1739 = phi_2369_;
        if (_e111 < _e83) {
        } else {
            return;
        }
        visibility.member[(0u + _e111)] = _e1739;
        let _e1745 = p.member.light.number;
        let _e1746 = (_e1745 * 3u);
        let _e1747 = (_e1746 / 32u);
        let _e1748 = (_e1746 % 32u);
        let _e1750 = p.member.light.mask_words;
        if (_e111 < _e83) {
        } else {
            return;
        }
        let _e1754 = visibility.member[(0u + _e111)];
        let _e1756 = ((_e111 * _e1750) + _e1747);
        if (_e1748 > 29u) {
            let _e1758 = (_e1756 + 1u);
            if (_e1758 < _e89) {
            } else {
                return;
            }
            let _e1762 = bits.member[(0u + _e1758)];
            phi_2410_ = _e1762;
        } else {
            phi_2410_ = 0u;
        }
        let _e1764 = phi_2410_;
        if (_e1756 < _e89) {
        } else {
            return;
        }
        let _e1768 = bits.member[(0u + _e1756)];
        let _e1771 = (_e1768 >> bitcast<u32>((_e1748 & 31u)));
        if (_e1748 > 29u) {
            phi_2429_ = (_e1771 | (_e1764 << bitcast<u32>(((32u - _e1748) & 31u))));
        } else {
            phi_2429_ = _e1771;
        }
        let _e1779 = phi_2429_;
        if ((_e1779 & 2u) == 0u) {
            phi_2437_ = (_e1779 & 1u);
        } else {
            phi_2437_ = (_e1779 & 7u);
        }
        let _e1785 = phi_2437_;
        if ((_e1785 & 1u) != 0u) {
            phi_2445_ = (2u | 1u);
        } else {
            phi_2445_ = 2u;
        }
        let _e1791 = phi_2445_;
        if (_e1754 < 0.5f) {
            phi_2450_ = (_e1791 | 4u);
        } else {
            phi_2450_ = _e1791;
        }
        let _e1794 = phi_2450_;
        let _e1796 = ((_e111 * _e1750) + _e1747);
        if (_e1796 < _e89) {
        } else {
            return;
        }
        let _e1800 = bits.member[(0u + _e1796)];
        if (_e1796 < _e89) {
        } else {
            return;
        }
        bits.member[(0u + _e1796)] = ((_e1800 & ~((7u << bitcast<u32>((_e1748 & 31u))))) | (_e1794 << bitcast<u32>((_e1748 & 31u))));
        if (_e1748 > 29u) {
            let _e1814 = (_e1796 + 1u);
            if (_e1814 < _e89) {
            } else {
                return;
            }
            let _e1818 = bits.member[(0u + _e1814)];
            let _e1819 = (32u - _e1748);
            let _e1829 = (_e1796 + 1u);
            if (_e1829 < _e89) {
            } else {
                return;
            }
            bits.member[(0u + _e1829)] = ((_e1818 & ~((7u >> bitcast<u32>((_e1819 & 31u))))) | (_e1794 >> bitcast<u32>((_e1819 & 31u))));
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_learn_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
