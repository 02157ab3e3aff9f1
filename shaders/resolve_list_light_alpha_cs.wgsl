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

struct type_31 {
    member: abi_ShadowParams,
}

struct lt_bvh_Node {
    frame: vec4<u32>,
    links: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    z: vec4<u32>,
}

struct type_36 {
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

struct type_40 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_44 {
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

struct type_48 {
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

struct lt_math_Evsm {
    positive_exponent: f32,
    negative_exponent: f32,
    min_variance: f32,
}

struct type_61 {
    member: array<vec4<u32>>,
}

struct lt_bvh_LightSpace {
    shear: vec3<f32>,
    axis: u32,
    middle: vec3<f32>,
    sign: f32,
    low: vec3<f32>,
    is_parallel: u32,
    high: vec3<f32>,
    pad: u32,
    roots: vec4<u32>,
    roots_z: vec4<u32>,
}

struct type_64 {
    member: lt_bvh_LightSpace,
}

struct u0028_lt_bvh_LightPoint_u0020_u32_u0029_ {
    unnamed: lt_math_Evsm,
    unnamed_1: u32,
}

struct lt_bvh_LightNode {
    frame: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    rest: vec4<u32>,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_17;
@group(0) @binding(0) 
var<uniform> p: type_31;
@group(0) @binding(2) 
var<storage> nodes: type_36;
@group(0) @binding(3) 
var<storage> triangles: type_40;
@group(0) @binding(5) 
var<storage> list: type_13;
@group(0) @binding(6) 
var<storage> rows: type_61;
@group(0) @binding(7) 
var<uniform> space: type_64;
@group(0) @binding(8) 
var<storage> vertices: type_44;
@group(0) @binding(9) 
var<storage> materials: type_48;
@group(0) @binding(10) 
var<storage> alpha_texels: type_13;

fn core_intrinsics_maximum_number_nsz_f32_(param: f32, param_1: f32) -> f32 {
    var phi_222_: bool;
    var phi_226_: f32;

    if (param != param) {
        phi_222_ = true;
    } else {
        let _e81 = (param_1 >= param);
        if _e81 {
        }
        phi_222_ = _e81;
    }
    let _e83 = phi_222_;
    if _e83 {
        phi_226_ = param_1;
    } else {
        phi_226_ = param;
    }
    let _e85 = phi_226_;
    return _e85;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_2: f32, param_3: f32) -> f32 {
    var phi_238_: bool;
    var phi_242_: f32;

    if (param_2 != param_2) {
        phi_238_ = true;
    } else {
        let _e81 = (param_3 <= param_2);
        if _e81 {
        }
        phi_238_ = _e81;
    }
    let _e83 = phi_238_;
    if _e83 {
        phi_242_ = param_3;
    } else {
        phi_242_ = param_2;
    }
    let _e85 = phi_242_;
    return _e85;
}

fn _lt_shaders_texture_TextureView_quad(param_4: ptr<function, texture_TextureView>, param_5: f32, param_6: f32) -> texture_TexelQuad {
    var phi_284_: f32;
    var phi_289_: f32;
    var phi_290_: bool;
    var phi_291_: f32;
    var phi_292_: bool;
    var phi_296_: f32;
    var phi_322_: f32;
    var phi_327_: f32;
    var phi_328_: bool;
    var phi_329_: f32;
    var phi_330_: bool;
    var phi_334_: f32;
    var phi_342_: f32;
    var phi_343_: f32;
    var phi_344_: f32;
    var phi_353_: f32;
    var phi_354_: f32;
    var phi_372_: u32;
    var phi_386_: u32;
    var phi_393_: u32;
    var phi_398_: u32;
    var phi_404_: u32;
    var phi_409_: u32;
    var phi_411_: texture_Axis;
    var phi_439_: f32;
    var phi_444_: f32;
    var phi_445_: bool;
    var phi_446_: f32;
    var phi_447_: bool;
    var phi_451_: f32;
    var phi_477_: f32;
    var phi_482_: f32;
    var phi_483_: bool;
    var phi_484_: f32;
    var phi_485_: bool;
    var phi_489_: f32;
    var phi_497_: f32;
    var phi_498_: f32;
    var phi_499_: f32;
    var phi_508_: f32;
    var phi_509_: f32;
    var phi_527_: u32;
    var phi_541_: u32;
    var phi_548_: u32;
    var phi_553_: u32;
    var phi_559_: u32;
    var phi_564_: u32;
    var phi_566_: texture_Axis;

    let _e82 = (*param_4).size;
    let _e83 = (_e82 & 65535u);
    let _e85 = (*param_4).size;
    let _e87 = (_e85 >> bitcast<u32>(16i));
    let _e89 = (*param_4).flags;
    let _e91 = ((_e89 & 4u) != 0u);
    let _e93 = (*param_4).flags;
    let _e96 = ((_e93 >> bitcast<u32>(4u)) & 3u);
    if (_e96 == 0u) {
        if (param_5 > -8388608f) {
            let _e109 = f32(select(0i, select(select(i32(param_5), i32(-2147483648), (param_5 < bitcast<f32>(3472883712u))), 2147483647i, (param_5 > bitcast<f32>(1325400063u))), (param_5 == param_5)));
            if (_e109 > param_5) {
                phi_284_ = 1f;
            } else {
                phi_284_ = 0f;
            }
            let _e112 = phi_284_;
            if (param_5 < 8388608f) {
                phi_289_ = (_e109 - _e112);
                phi_290_ = false;
            } else {
                phi_289_ = f32();
                phi_290_ = true;
            }
            let _e115 = phi_289_;
            let _e117 = phi_290_;
            phi_291_ = _e115;
            phi_292_ = _e117;
        } else {
            phi_291_ = f32();
            phi_292_ = true;
        }
        let _e119 = phi_291_;
        let _e121 = phi_292_;
        if _e121 {
            phi_296_ = param_5;
        } else {
            phi_296_ = _e119;
        }
        let _e123 = phi_296_;
        phi_344_ = (param_5 - _e123);
    } else {
        if (_e96 == 1u) {
            let _e126 = (param_5 * 0.5f);
            if (_e126 > -8388608f) {
                let _e138 = f32(select(0i, select(select(i32(_e126), i32(-2147483648), (_e126 < bitcast<f32>(3472883712u))), 2147483647i, (_e126 > bitcast<f32>(1325400063u))), (_e126 == _e126)));
                if (_e138 > _e126) {
                    phi_322_ = 1f;
                } else {
                    phi_322_ = 0f;
                }
                let _e141 = phi_322_;
                if (_e126 < 8388608f) {
                    phi_327_ = (_e138 - _e141);
                    phi_328_ = false;
                } else {
                    phi_327_ = f32();
                    phi_328_ = true;
                }
                let _e144 = phi_327_;
                let _e146 = phi_328_;
                phi_329_ = _e144;
                phi_330_ = _e146;
            } else {
                phi_329_ = f32();
                phi_330_ = true;
            }
            let _e148 = phi_329_;
            let _e150 = phi_330_;
            if _e150 {
                phi_334_ = _e126;
            } else {
                phi_334_ = _e148;
            }
            let _e152 = phi_334_;
            let _e154 = (param_5 - (2f * _e152));
            if (_e154 > 1f) {
                phi_342_ = (2f - _e154);
            } else {
                phi_342_ = _e154;
            }
            let _e158 = phi_342_;
            phi_343_ = _e158;
        } else {
            phi_343_ = param_5;
        }
        let _e160 = phi_343_;
        phi_344_ = _e160;
    }
    let _e162 = phi_344_;
    if (_e162 > 0f) {
        if (_e162 < 1f) {
            phi_353_ = _e162;
        } else {
            phi_353_ = 1f;
        }
        let _e166 = phi_353_;
        phi_354_ = _e166;
    } else {
        phi_354_ = 0f;
    }
    let _e168 = phi_354_;
    let _e169 = (_e83 - 1u);
    let _e171 = (_e168 * f32(_e83));
    if _e91 {
        let _e178 = select(select(u32(_e171), 0u, (_e171 < bitcast<f32>(0u))), 4294967295u, (_e171 > bitcast<f32>(1333788671u)));
        if (_e169 < _e178) {
            phi_372_ = _e169;
        } else {
            phi_372_ = _e178;
        }
        let _e181 = phi_372_;
        phi_411_ = texture_Axis(_e181, _e181, 0f);
    } else {
        let _e183 = (_e171 + 0.5f);
        let _e190 = select(select(u32(_e183), 0u, (_e183 < bitcast<f32>(0u))), 4294967295u, (_e183 > bitcast<f32>(1333788671u)));
        if (_e83 < _e190) {
            phi_386_ = _e83;
        } else {
            phi_386_ = _e190;
        }
        let _e193 = phi_386_;
        if (_e96 == 0u) {
            phi_393_ = _e169;
        } else {
            phi_393_ = 0u;
        }
        let _e198 = phi_393_;
        if (_e96 == 0u) {
            phi_398_ = 0u;
        } else {
            phi_398_ = _e169;
        }
        let _e201 = phi_398_;
        if (_e193 == 0u) {
            phi_404_ = _e198;
        } else {
            phi_404_ = (_e193 - 1u);
        }
        let _e205 = phi_404_;
        if (_e193 > _e169) {
            phi_409_ = _e201;
        } else {
            phi_409_ = _e193;
        }
        let _e208 = phi_409_;
        phi_411_ = texture_Axis(_e205, _e208, (_e183 - f32(_e193)));
    }
    let _e211 = phi_411_;
    let _e213 = (*param_4).flags;
    let _e216 = ((_e213 >> bitcast<u32>(6u)) & 3u);
    if (_e216 == 0u) {
        if (param_6 > -8388608f) {
            let _e229 = f32(select(0i, select(select(i32(param_6), i32(-2147483648), (param_6 < bitcast<f32>(3472883712u))), 2147483647i, (param_6 > bitcast<f32>(1325400063u))), (param_6 == param_6)));
            if (_e229 > param_6) {
                phi_439_ = 1f;
            } else {
                phi_439_ = 0f;
            }
            let _e232 = phi_439_;
            if (param_6 < 8388608f) {
                phi_444_ = (_e229 - _e232);
                phi_445_ = false;
            } else {
                phi_444_ = f32();
                phi_445_ = true;
            }
            let _e235 = phi_444_;
            let _e237 = phi_445_;
            phi_446_ = _e235;
            phi_447_ = _e237;
        } else {
            phi_446_ = f32();
            phi_447_ = true;
        }
        let _e239 = phi_446_;
        let _e241 = phi_447_;
        if _e241 {
            phi_451_ = param_6;
        } else {
            phi_451_ = _e239;
        }
        let _e243 = phi_451_;
        phi_499_ = (param_6 - _e243);
    } else {
        if (_e216 == 1u) {
            let _e246 = (param_6 * 0.5f);
            if (_e246 > -8388608f) {
                let _e258 = f32(select(0i, select(select(i32(_e246), i32(-2147483648), (_e246 < bitcast<f32>(3472883712u))), 2147483647i, (_e246 > bitcast<f32>(1325400063u))), (_e246 == _e246)));
                if (_e258 > _e246) {
                    phi_477_ = 1f;
                } else {
                    phi_477_ = 0f;
                }
                let _e261 = phi_477_;
                if (_e246 < 8388608f) {
                    phi_482_ = (_e258 - _e261);
                    phi_483_ = false;
                } else {
                    phi_482_ = f32();
                    phi_483_ = true;
                }
                let _e264 = phi_482_;
                let _e266 = phi_483_;
                phi_484_ = _e264;
                phi_485_ = _e266;
            } else {
                phi_484_ = f32();
                phi_485_ = true;
            }
            let _e268 = phi_484_;
            let _e270 = phi_485_;
            if _e270 {
                phi_489_ = _e246;
            } else {
                phi_489_ = _e268;
            }
            let _e272 = phi_489_;
            let _e274 = (param_6 - (2f * _e272));
            if (_e274 > 1f) {
                phi_497_ = (2f - _e274);
            } else {
                phi_497_ = _e274;
            }
            let _e278 = phi_497_;
            phi_498_ = _e278;
        } else {
            phi_498_ = param_6;
        }
        let _e280 = phi_498_;
        phi_499_ = _e280;
    }
    let _e282 = phi_499_;
    if (_e282 > 0f) {
        if (_e282 < 1f) {
            phi_508_ = _e282;
        } else {
            phi_508_ = 1f;
        }
        let _e286 = phi_508_;
        phi_509_ = _e286;
    } else {
        phi_509_ = 0f;
    }
    let _e288 = phi_509_;
    let _e289 = (_e87 - 1u);
    let _e291 = (_e288 * f32(_e87));
    if _e91 {
        let _e298 = select(select(u32(_e291), 0u, (_e291 < bitcast<f32>(0u))), 4294967295u, (_e291 > bitcast<f32>(1333788671u)));
        if (_e289 < _e298) {
            phi_527_ = _e289;
        } else {
            phi_527_ = _e298;
        }
        let _e301 = phi_527_;
        phi_566_ = texture_Axis(_e301, _e301, 0f);
    } else {
        let _e303 = (_e291 + 0.5f);
        let _e310 = select(select(u32(_e303), 0u, (_e303 < bitcast<f32>(0u))), 4294967295u, (_e303 > bitcast<f32>(1333788671u)));
        if (_e87 < _e310) {
            phi_541_ = _e87;
        } else {
            phi_541_ = _e310;
        }
        let _e313 = phi_541_;
        if (_e216 == 0u) {
            phi_548_ = _e289;
        } else {
            phi_548_ = 0u;
        }
        let _e318 = phi_548_;
        if (_e216 == 0u) {
            phi_553_ = 0u;
        } else {
            phi_553_ = _e289;
        }
        let _e321 = phi_553_;
        if (_e313 == 0u) {
            phi_559_ = _e318;
        } else {
            phi_559_ = (_e313 - 1u);
        }
        let _e325 = phi_559_;
        if (_e313 > _e289) {
            phi_564_ = _e321;
        } else {
            phi_564_ = _e313;
        }
        let _e328 = phi_564_;
        phi_566_ = texture_Axis(_e325, _e328, (_e303 - f32(_e313)));
    }
    let _e331 = phi_566_;
    let _e335 = (*param_4).offset;
    let _e342 = (*param_4).offset;
    let _e349 = (*param_4).offset;
    let _e356 = (*param_4).offset;
    return texture_TexelQuad(array<u32, 4>(((_e335 + (_e331.low * _e83)) + _e211.low), ((_e342 + (_e331.low * _e83)) + _e211.high), ((_e349 + (_e331.high * _e83)) + _e211.low), ((_e356 + (_e331.high * _e83)) + _e211.high)), vec4<f32>(((1f - _e211.fraction) * (1f - _e331.fraction)), (_e211.fraction * (1f - _e331.fraction)), ((1f - _e211.fraction) * _e331.fraction), (_e211.fraction * _e331.fraction)));
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
    var phi_1004_: u0028_lt_bvh_LightPoint_u0020_u32_u0029_;
    var phi_1072_: f32;
    var phi_1079_: f32;
    var phi_1086_: f32;
    var phi_1093_: f32;
    var phi_1100_: f32;
    var phi_1107_: f32;
    var phi_1124_: f32;
    var phi_1129_: f32;
    var phi_1134_: f32;
    var phi_1139_: f32;
    var phi_1144_: f32;
    var phi_1166_: bool;
    var phi_1167_: bool;
    var phi_1175_: u32;
    var phi_1176_: u32;
    var phi_1187_: vec3<f32>;
    var phi_1188_: vec3<f32>;
    var phi_1200_: u32;
    var phi_1203_: u32;
    var phi_1212_: u32;
    var phi_1215_: u32;
    var phi_1217_: u32;
    var phi_1219_: u32;
    var phi_1292_: f32;
    var phi_1293_: f32;
    var phi_1307_: u32;
    var phi_1330_: f32;
    var phi_1331_: f32;
    var phi_1345_: u32;
    var phi_1368_: f32;
    var phi_1369_: f32;
    var phi_1383_: u32;
    var phi_1530_: u32;
    var phi_1531_: u32;
    var phi_1535_: u32;
    var phi_1536_: u32;
    var phi_1537_: u32;
    var phi_1538_: u32;
    var phi_1539_: u32;
    var phi_1540_: u32;
    var phi_1558_: u32;
    var phi_1559_: u32;
    var phi_1560_: u32;
    var phi_1561_: u32;
    var phi_1562_: u32;
    var phi_1563_: u32;
    var phi_1564_: u32;
    var phi_1565_: u32;
    var phi_1213_: u32;
    var phi_1216_: u32;
    var phi_1218_: u32;
    var phi_1220_: u32;
    var phi_1566_: bool;
    var local_4: bool;
    var phi_1571_: u32;
    var local_5: u32;
    var phi_1610_: u32;
    var phi_1611_: u32;
    var phi_1617_: u32;
    var phi_1646_: vec3<f32>;
    var phi_1647_: vec3<f32>;
    var phi_1676_: vec3<f32>;
    var phi_1677_: vec3<f32>;
    var phi_1706_: vec3<f32>;
    var phi_1707_: vec3<f32>;
    var phi_1725_: bool;
    var phi_1726_: bool;
    var phi_1730_: f32;
    var phi_1731_: f32;
    var phi_1732_: f32;
    var phi_1733_: f32;
    var phi_1741_: f32;
    var phi_1751_: bool;
    var phi_1752_: bool;
    var phi_1756_: f32;
    var phi_1757_: f32;
    var phi_1758_: f32;
    var phi_1759_: f32;
    var phi_1767_: f32;
    var phi_1777_: bool;
    var phi_1778_: bool;
    var phi_1782_: f32;
    var phi_1783_: f32;
    var phi_1784_: f32;
    var phi_1785_: f32;
    var phi_1793_: f32;
    var phi_1808_: f32;
    var phi_1809_: bool;
    var phi_1810_: f32;
    var phi_1811_: bool;
    var phi_1812_: f32;
    var phi_1813_: bool;
    var phi_1831_: f32;
    var phi_1832_: bool;
    var phi_1833_: bool;
    var phi_1834_: f32;
    var phi_1835_: bool;
    var phi_1836_: bool;
    var phi_1840_: bool;
    var phi_1841_: f32;
    var phi_1842_: bool;
    var phi_1870_: vec3<f32>;
    var phi_1871_: vec3<f32>;
    var phi_1896_: vec3<f32>;
    var phi_1897_: vec3<f32>;
    var phi_1922_: vec3<f32>;
    var phi_1923_: vec3<f32>;
    var phi_1979_: f32;
    var phi_1988_: f32;
    var phi_1997_: f32;
    var phi_2006_: f32;
    var phi_2013_: f32;
    var phi_2020_: f32;
    var phi_2033_: f32;
    var phi_2042_: f32;
    var phi_2051_: f32;
    var phi_2060_: f32;
    var phi_2067_: f32;
    var phi_2074_: f32;
    var phi_2091_: f32;
    var phi_2096_: f32;
    var phi_2101_: f32;
    var phi_2109_: f32;
    var phi_2114_: f32;
    var phi_2119_: f32;
    var phi_2131_: f32;
    var phi_2136_: f32;
    var phi_2141_: f32;
    var phi_2146_: f32;
    var phi_2151_: lt_bvh_triangle_Intersection;
    var phi_2152_: bool;
    var phi_2153_: lt_bvh_triangle_Intersection;
    var phi_2154_: bool;
    var phi_2158_: lt_bvh_triangle_Intersection;
    var phi_2159_: bool;
    var phi_2160_: lt_bvh_triangle_Intersection;
    var phi_2161_: bool;
    var phi_2162_: bool;
    var phi_2166_: bool;
    var phi_2170_: lt_bvh_triangle_Intersection;
    var phi_2384_: f32;
    var phi_2387_: bool;
    var phi_2388_: bool;
    var phi_2392_: bool;
    var phi_2393_: bool;
    var phi_2394_: bool;
    var phi_2395_: bool;
    var phi_2396_: bool;
    var phi_2397_: bool;
    var phi_2398_: bool;
    var phi_2399_: bool;
    var phi_2400_: bool;
    var phi_2401_: bool;
    var phi_2402_: bool;
    var phi_2403_: bool;
    var phi_2404_: bool;
    var phi_2405_: bool;
    var phi_2409_: bool;
    var phi_2410_: bool;
    var phi_2411_: bool;
    var phi_2415_: bool;
    var phi_2416_: bool;
    var phi_1572_: u32;
    var phi_2417_: bool;
    var phi_2418_: bool;
    var phi_2419_: bool;
    var local_6: bool;
    var phi_2423_: bool;
    var phi_2424_: bool;
    var phi_1201_: u32;
    var phi_1204_: u32;
    var phi_2425_: bool;
    var phi_2426_: bool;
    var phi_2427_: bool;
    var local_7: bool;
    var phi_2431_: bool;
    var phi_2432_: bool;
    var phi_2436_: bool;
    var phi_2440_: bool;
    var phi_2444_: bool;
    var phi_2445_: bool;
    var phi_2449_: bool;
    var phi_2465_: bool;
    var phi_2466_: bool;
    var phi_2467_: bool;
    var phi_2468_: bool;
    var phi_2472_: bool;
    var phi_2485_: bool;
    var phi_2486_: bool;
    var phi_2487_: bool;
    var phi_2488_: bool;
    var phi_2492_: bool;
    var phi_2505_: bool;
    var phi_2506_: bool;
    var phi_2507_: bool;
    var phi_2511_: bool;
    var phi_2512_: bool;
    var phi_2513_: bool;
    var phi_2514_: bool;
    var phi_2515_: bool;
    var phi_2519_: bool;
    var phi_2589_: f32;
    var phi_2596_: f32;
    var phi_2603_: f32;
    var phi_2610_: f32;
    var phi_2617_: f32;
    var phi_2624_: f32;
    var phi_2641_: f32;
    var phi_2646_: f32;
    var phi_2651_: f32;
    var phi_2656_: f32;
    var phi_2661_: f32;
    var phi_2687_: bool;
    var phi_2688_: bool;
    var phi_2696_: u32;
    var phi_2697_: u32;
    var phi_2708_: vec3<f32>;
    var phi_2709_: vec3<f32>;
    var phi_2722_: u32;
    var phi_2727_: u32;
    var phi_2732_: u32;
    var phi_2846_: bool;
    var phi_2847_: bool;
    var phi_2878_: u32;
    var phi_2880_: u32;
    var phi_2883_: bool;
    var phi_2963_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2990_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_3017_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_3023_: u32;
    var phi_3026_: u32;
    var phi_3040_: u32;
    var phi_3050_: u32;
    var phi_3060_: u32;
    var phi_3078_: u32;
    var phi_3088_: u32;
    var phi_3098_: u32;
    var phi_3134_: u32;
    var phi_3147_: u32;
    var phi_3152_: u32;
    var phi_3153_: u32;
    var phi_3154_: u32;
    var phi_3024_: u32;
    var phi_3027_: u32;
    var local_8: u32;
    var local_9: u32;
    var local_10: u32;
    var phi_3212_: u32;
    var phi_3215_: bool;
    var phi_3259_: vec3<f32>;
    var phi_3260_: vec3<f32>;
    var phi_3289_: vec3<f32>;
    var phi_3290_: vec3<f32>;
    var phi_3319_: vec3<f32>;
    var phi_3320_: vec3<f32>;
    var phi_3338_: bool;
    var phi_3339_: bool;
    var phi_3343_: f32;
    var phi_3344_: f32;
    var phi_3345_: f32;
    var phi_3346_: f32;
    var phi_3354_: f32;
    var phi_3364_: bool;
    var phi_3365_: bool;
    var phi_3369_: f32;
    var phi_3370_: f32;
    var phi_3371_: f32;
    var phi_3372_: f32;
    var phi_3380_: f32;
    var phi_3390_: bool;
    var phi_3391_: bool;
    var phi_3395_: f32;
    var phi_3396_: f32;
    var phi_3397_: f32;
    var phi_3398_: f32;
    var phi_3406_: f32;
    var phi_3421_: f32;
    var phi_3422_: bool;
    var phi_3423_: f32;
    var phi_3424_: bool;
    var phi_3425_: f32;
    var phi_3426_: bool;
    var phi_3444_: f32;
    var phi_3445_: bool;
    var phi_3446_: bool;
    var phi_3447_: f32;
    var phi_3448_: bool;
    var phi_3449_: bool;
    var phi_3453_: bool;
    var phi_3454_: f32;
    var phi_3455_: bool;
    var phi_3483_: vec3<f32>;
    var phi_3484_: vec3<f32>;
    var phi_3509_: vec3<f32>;
    var phi_3510_: vec3<f32>;
    var phi_3535_: vec3<f32>;
    var phi_3536_: vec3<f32>;
    var phi_3592_: f32;
    var phi_3601_: f32;
    var phi_3610_: f32;
    var phi_3619_: f32;
    var phi_3626_: f32;
    var phi_3633_: f32;
    var phi_3646_: f32;
    var phi_3655_: f32;
    var phi_3664_: f32;
    var phi_3673_: f32;
    var phi_3680_: f32;
    var phi_3687_: f32;
    var phi_3704_: f32;
    var phi_3709_: f32;
    var phi_3714_: f32;
    var phi_3722_: f32;
    var phi_3727_: f32;
    var phi_3732_: f32;
    var phi_3744_: f32;
    var phi_3749_: f32;
    var phi_3754_: f32;
    var phi_3759_: f32;
    var phi_3764_: lt_bvh_triangle_Intersection;
    var phi_3765_: bool;
    var phi_3766_: lt_bvh_triangle_Intersection;
    var phi_3767_: bool;
    var phi_3771_: lt_bvh_triangle_Intersection;
    var phi_3772_: bool;
    var phi_3773_: lt_bvh_triangle_Intersection;
    var phi_3774_: bool;
    var phi_3775_: bool;
    var phi_3779_: bool;
    var phi_3783_: lt_bvh_triangle_Intersection;
    var phi_3997_: f32;
    var phi_4000_: bool;
    var phi_4001_: bool;
    var phi_4002_: bool;
    var phi_4006_: bool;
    var phi_4007_: bool;
    var phi_4008_: bool;
    var phi_4009_: bool;
    var phi_4010_: bool;
    var phi_4011_: bool;
    var phi_4012_: bool;
    var phi_4013_: bool;
    var phi_4014_: bool;
    var phi_4015_: bool;
    var phi_3213_: u32;
    var phi_3216_: bool;
    var phi_4019_: bool;
    var phi_4020_: bool;
    var local_11: bool;
    var phi_4062_: bool;
    var phi_4063_: bool;
    var phi_4094_: u32;
    var phi_4095_: u32;
    var phi_2881_: u32;
    var phi_2884_: bool;
    var phi_4096_: bool;
    var phi_4097_: bool;
    var phi_4098_: bool;
    var local_12: bool;
    var phi_4102_: bool;
    var phi_4106_: bool;
    var phi_4107_: bool;
    var phi_4108_: bool;
    var phi_4109_: bool;
    var phi_4113_: bool;
    var phi_4114_: bool;
    var phi_4115_: bool;
    var phi_4119_: f32;
    var local_13: u32;
    var local_14: bool;
    var local_15: bool;
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

    let _e82 = id_1;
    let _e89 = arrayLength((&nodes.member));
    let _e92 = arrayLength((&triangles.member));
    let _e98 = arrayLength((&list.member));
    let _e101 = arrayLength((&rows.member));
    let _e105 = arrayLength((&vertices.member));
    let _e108 = arrayLength((&materials.member));
    let _e111 = arrayLength((&alpha_texels.member));
    let _e115 = ((_e82.y * 2097152u) + _e82.x);
    if (3u < _e98) {
    } else {
        return;
    }
    let _e118 = list.member[3u];
    if (_e115 < _e118) {
        let _e120 = (_e115 + 4u);
        if (_e120 < _e98) {
        } else {
            return;
        }
        let _e124 = list.member[(0u + _e120)];
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
                    phi_1004_ = u0028_lt_bvh_LightPoint_u0020_u32_u0029_(lt_math_Evsm((_e341.x / _e341.z), (_e341.y / _e341.z), (_e308 / _e341.z)), _e333);
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
                    let _e372 = (_e360.z - _e125.middle.z);
                    phi_1004_ = u0028_lt_bvh_LightPoint_u0020_u32_u0029_(lt_math_Evsm(((_e360.x - _e125.middle.x) - (_e125.shear.x * _e372)), ((_e360.y - _e125.middle.y) - (_e125.shear.y * _e372)), (_e125.sign * _e372)), _e125.roots.x);
                }
                let _e385 = phi_1004_;
                if (_e385.unnamed_1 == 4294967295u) {
                    phi_2444_ = false;
                    phi_2445_ = true;
                } else {
                    if (0u < _e89) {
                    } else {
                        return;
                    }
                    let _e393 = nodes.member[0u].frame[0u];
                    let _e397 = nodes.member[0u].frame[1u];
                    let _e401 = nodes.member[0u].frame[2u];
                    let _e405 = nodes.member[0u].frame[0u];
                    let _e409 = nodes.member[0u].frame[1u];
                    let _e413 = nodes.member[0u].frame[2u];
                    let _e417 = nodes.member[0u].frame[3u];
                    let _e451 = core_intrinsics_maximum_number_nsz_f32_(abs(_e165), abs(_e166));
                    let _e452 = core_intrinsics_maximum_number_nsz_f32_(_e451, abs(_e167));
                    let _e453 = (_e452 * 0.0000000000009094947f);
                    if (abs(_e165) < _e453) {
                        phi_1072_ = _e453;
                    } else {
                        phi_1072_ = abs(_e165);
                    }
                    let _e458 = phi_1072_;
                    if (_e165 < 0f) {
                        phi_1079_ = (-1f / _e458);
                    } else {
                        phi_1079_ = (1f / _e458);
                    }
                    let _e463 = phi_1079_;
                    if (abs(_e166) < _e453) {
                        phi_1086_ = _e453;
                    } else {
                        phi_1086_ = abs(_e166);
                    }
                    let _e468 = phi_1086_;
                    if (_e166 < 0f) {
                        phi_1093_ = (-1f / _e468);
                    } else {
                        phi_1093_ = (1f / _e468);
                    }
                    let _e473 = phi_1093_;
                    if (abs(_e167) < _e453) {
                        phi_1100_ = _e453;
                    } else {
                        phi_1100_ = abs(_e167);
                    }
                    let _e478 = phi_1100_;
                    if (_e167 < 0f) {
                        phi_1107_ = (-1f / _e478);
                    } else {
                        phi_1107_ = (1f / _e478);
                    }
                    let _e483 = phi_1107_;
                    let _e487 = abs((bitcast<f32>(_e393) - _e145));
                    let _e488 = abs((bitcast<f32>(_e397) - _e147));
                    let _e489 = abs((bitcast<f32>(_e401) - _e149));
                    let _e493 = abs(((bitcast<f32>(_e405) + (bitcast<f32>((((_e417 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e145));
                    let _e494 = abs(((bitcast<f32>(_e409) + (bitcast<f32>((((_e417 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e147));
                    let _e495 = abs(((bitcast<f32>(_e413) + (bitcast<f32>((((_e417 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e149));
                    if (_e487 > _e493) {
                        phi_1124_ = _e487;
                    } else {
                        phi_1124_ = _e493;
                    }
                    let _e498 = phi_1124_;
                    if (_e488 > _e494) {
                        phi_1129_ = _e488;
                    } else {
                        phi_1129_ = _e494;
                    }
                    let _e501 = phi_1129_;
                    if (_e489 > _e495) {
                        phi_1134_ = _e489;
                    } else {
                        phi_1134_ = _e495;
                    }
                    let _e504 = phi_1134_;
                    if (_e498 > _e501) {
                        phi_1139_ = _e498;
                    } else {
                        phi_1139_ = _e501;
                    }
                    let _e507 = phi_1139_;
                    if (_e507 > _e504) {
                        phi_1144_ = _e507;
                    } else {
                        phi_1144_ = _e504;
                    }
                    let _e510 = phi_1144_;
                    let _e517 = (_e510 * 0.0000009536743f);
                    let _e518 = (abs(_e463) * _e517);
                    let _e519 = (abs(_e473) * _e517);
                    let _e520 = (abs(_e483) * _e517);
                    let _e521 = abs(_e165);
                    let _e522 = abs(_e166);
                    let _e523 = abs(_e167);
                    if (_e521 >= _e522) {
                        if (_e521 >= _e523) {
                            phi_1166_ = false;
                        } else {
                            phi_1166_ = true;
                        }
                        let _e527 = phi_1166_;
                        phi_1167_ = _e527;
                    } else {
                        phi_1167_ = true;
                    }
                    let _e529 = phi_1167_;
                    if _e529 {
                        if (_e522 >= _e523) {
                            phi_1175_ = 1u;
                        } else {
                            phi_1175_ = 2u;
                        }
                        let _e532 = phi_1175_;
                        phi_1176_ = _e532;
                    } else {
                        phi_1176_ = 0u;
                    }
                    let _e534 = phi_1176_;
                    if (_e534 == 0u) {
                        phi_1188_ = vec3<f32>(_e166, _e167, _e165);
                    } else {
                        if (_e534 == 1u) {
                            phi_1187_ = vec3<f32>(_e167, _e165, _e166);
                        } else {
                            phi_1187_ = _e168;
                        }
                        let _e540 = phi_1187_;
                        phi_1188_ = _e540;
                    }
                    let _e542 = phi_1188_;
                    let _e545 = (_e542.x / _e542.z);
                    let _e548 = (_e542.y / _e542.z);
                    local_3 = array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    phi_1200_ = ((_e385.unnamed_1 << bitcast<u32>(8i)) | 1u);
                    phi_1203_ = 0u;
                    loop {
                        let _e555 = phi_1200_;
                        let _e557 = phi_1203_;
                        let _e558 = (_e555 == 0u);
                        local_7 = _e558;
                        if _e558 {
                            phi_1201_ = u32();
                            phi_1204_ = u32();
                            phi_2425_ = false;
                            phi_2426_ = false;
                            phi_2427_ = false;
                        } else {
                            phi_1212_ = _e555;
                            phi_1215_ = 0u;
                            phi_1217_ = 0u;
                            phi_1219_ = _e557;
                            loop {
                                let _e560 = phi_1212_;
                                let _e562 = phi_1215_;
                                let _e564 = phi_1217_;
                                let _e566 = phi_1219_;
                                local_13 = _e564;
                                local_5 = _e562;
                                local_16 = _e560;
                                local_17 = _e566;
                                let _e567 = (_e560 == 0u);
                                local_4 = _e567;
                                if _e567 {
                                    phi_1213_ = u32();
                                    phi_1216_ = u32();
                                    phi_1218_ = u32();
                                    phi_1220_ = u32();
                                    phi_1566_ = false;
                                } else {
                                    let _e568 = (_e564 == 0u);
                                    if _e568 {
                                        let _e575 = (((_e560 >> bitcast<u32>(8i)) + select(firstTrailingBit(_e560), 32u, (_e560 == 0u))) * 4u);
                                        if (_e575 < _e101) {
                                        } else {
                                            return;
                                        }
                                        let _e579 = rows.member[(0u + _e575)];
                                        let _e580 = (_e575 + 1u);
                                        if (_e580 < _e101) {
                                        } else {
                                            return;
                                        }
                                        let _e584 = rows.member[(0u + _e580)];
                                        let _e585 = (_e575 + 2u);
                                        if (_e585 < _e101) {
                                        } else {
                                            return;
                                        }
                                        let _e589 = rows.member[(0u + _e585)];
                                        let _e590 = (_e575 + 3u);
                                        if (_e590 < _e101) {
                                        } else {
                                            return;
                                        }
                                        let _e594 = rows.member[(0u + _e590)];
                                        let _e595 = lt_bvh_LightNode(_e579, _e584, _e589, _e594);
                                        let _e597 = (_e560 & (_e560 - 1u));
                                        let _e609 = (_e385.unnamed.positive_exponent - bitcast<f32>(_e595.frame.x));
                                        let _e612 = bitcast<f32>((((_e595.frame.w >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                                        if (_e609 > 0f) {
                                            if (_e609 < (255f * _e612)) {
                                                phi_1292_ = (_e609 / _e612);
                                            } else {
                                                phi_1292_ = 255f;
                                            }
                                            let _e618 = phi_1292_;
                                            phi_1293_ = _e618;
                                        } else {
                                            phi_1293_ = 0f;
                                        }
                                        let _e620 = phi_1293_;
                                        let _e627 = select(select(u32(_e620), 0u, (_e620 < bitcast<f32>(0u))), 4294967295u, (_e620 > bitcast<f32>(1333788671u)));
                                        if (f32(_e627) < _e620) {
                                            phi_1307_ = (_e627 + 1u);
                                        } else {
                                            phi_1307_ = _e627;
                                        }
                                        let _e632 = phi_1307_;
                                        let _e633 = (_e627 * 16843009u);
                                        let _e634 = (_e632 * 16843009u);
                                        let _e644 = (_e385.unnamed.negative_exponent - bitcast<f32>(_e595.frame.y));
                                        let _e647 = bitcast<f32>((((_e595.frame.w >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                                        if (_e644 > 0f) {
                                            if (_e644 < (255f * _e647)) {
                                                phi_1330_ = (_e644 / _e647);
                                            } else {
                                                phi_1330_ = 255f;
                                            }
                                            let _e653 = phi_1330_;
                                            phi_1331_ = _e653;
                                        } else {
                                            phi_1331_ = 0f;
                                        }
                                        let _e655 = phi_1331_;
                                        let _e662 = select(select(u32(_e655), 0u, (_e655 < bitcast<f32>(0u))), 4294967295u, (_e655 > bitcast<f32>(1333788671u)));
                                        if (f32(_e662) < _e655) {
                                            phi_1345_ = (_e662 + 1u);
                                        } else {
                                            phi_1345_ = _e662;
                                        }
                                        let _e667 = phi_1345_;
                                        let _e668 = (_e662 * 16843009u);
                                        let _e669 = (_e667 * 16843009u);
                                        let _e679 = (_e385.unnamed.min_variance - bitcast<f32>(_e595.frame.z));
                                        let _e682 = bitcast<f32>((((_e595.frame.w >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                                        if (_e679 > 0f) {
                                            if (_e679 < (255f * _e682)) {
                                                phi_1368_ = (_e679 / _e682);
                                            } else {
                                                phi_1368_ = 255f;
                                            }
                                            let _e688 = phi_1368_;
                                            phi_1369_ = _e688;
                                        } else {
                                            phi_1369_ = 0f;
                                        }
                                        let _e690 = phi_1369_;
                                        let _e697 = select(select(u32(_e690), 0u, (_e690 < bitcast<f32>(0u))), 4294967295u, (_e690 > bitcast<f32>(1333788671u)));
                                        if (f32(_e697) < _e690) {
                                            phi_1383_ = (_e697 + 1u);
                                        } else {
                                            phi_1383_ = _e697;
                                        }
                                        let _e702 = phi_1383_;
                                        let _e703 = (_e702 * 16843009u);
                                        let _e836 = (((((((((((_e633 & ~(_e595.x.x)) | (~((_e595.x.x ^ _e633)) & ((_e633 | 2155905152u) - (_e595.x.x & 2139062143u)))) & ((_e595.x.z & ~(_e634)) | (~((_e634 ^ _e595.x.z)) & ((_e595.x.z | 2155905152u) - (_e634 & 2139062143u))))) & ((_e668 & ~(_e595.y.x)) | (~((_e595.y.x ^ _e668)) & ((_e668 | 2155905152u) - (_e595.y.x & 2139062143u))))) & ((_e595.y.z & ~(_e669)) | (~((_e669 ^ _e595.y.z)) & ((_e595.y.z | 2155905152u) - (_e669 & 2139062143u))))) & ((_e595.rest.x & ~(_e703)) | (~((_e703 ^ _e595.rest.x)) & ((_e595.rest.x | 2155905152u) - (_e703 & 2139062143u))))) & 2155905152u) >> bitcast<u32>(7i)) * 16909320u) >> bitcast<u32>(24i)) | (((((((((((_e633 & ~(_e595.x.y)) | (~((_e595.x.y ^ _e633)) & ((_e633 | 2155905152u) - (_e595.x.y & 2139062143u)))) & ((_e595.x.w & ~(_e634)) | (~((_e634 ^ _e595.x.w)) & ((_e595.x.w | 2155905152u) - (_e634 & 2139062143u))))) & ((_e668 & ~(_e595.y.y)) | (~((_e595.y.y ^ _e668)) & ((_e668 | 2155905152u) - (_e595.y.y & 2139062143u))))) & ((_e595.y.w & ~(_e669)) | (~((_e669 ^ _e595.y.w)) & ((_e595.y.w | 2155905152u) - (_e669 & 2139062143u))))) & ((_e595.rest.y & ~(_e703)) | (~((_e703 ^ _e595.rest.y)) & ((_e595.rest.y | 2155905152u) - (_e703 & 2139062143u))))) & 2155905152u) >> bitcast<u32>(7i)) * 16909320u) >> bitcast<u32>(24i)) << bitcast<u32>(4i)));
                                        if ((_e595.frame.w & 16777216u) != 0u) {
                                            phi_1537_ = _e597;
                                            phi_1538_ = _e595.rest.z;
                                            phi_1539_ = _e836;
                                            phi_1540_ = _e566;
                                        } else {
                                            if (_e836 == 0u) {
                                                phi_1535_ = _e597;
                                                phi_1536_ = _e566;
                                            } else {
                                                if ((_e597 & 255u) == 0u) {
                                                    phi_1531_ = _e566;
                                                } else {
                                                    if (_e566 < 32u) {
                                                        if (_e566 < 32u) {
                                                        } else {
                                                            return;
                                                        }
                                                        local_3[(0u + _e566)] = _e597;
                                                        phi_1530_ = (_e566 + 1u);
                                                    } else {
                                                        phi_1530_ = _e566;
                                                    }
                                                    let _e852 = phi_1530_;
                                                    phi_1531_ = _e852;
                                                }
                                                let _e854 = phi_1531_;
                                                phi_1535_ = ((_e595.rest.z << bitcast<u32>(8i)) | _e836);
                                                phi_1536_ = _e854;
                                            }
                                            let _e861 = phi_1535_;
                                            let _e863 = phi_1536_;
                                            phi_1537_ = _e861;
                                            phi_1538_ = _e562;
                                            phi_1539_ = _e564;
                                            phi_1540_ = _e863;
                                        }
                                        let _e865 = phi_1537_;
                                        let _e867 = phi_1538_;
                                        let _e869 = phi_1539_;
                                        let _e871 = phi_1540_;
                                        if ((_e865 & 255u) == 0u) {
                                            if (_e871 > 0u) {
                                                let _e875 = (_e871 - 1u);
                                                if (_e875 < 32u) {
                                                } else {
                                                    return;
                                                }
                                                let _e879 = local_3[(0u + _e875)];
                                                phi_1558_ = _e879;
                                                phi_1559_ = _e875;
                                            } else {
                                                phi_1558_ = 0u;
                                                phi_1559_ = _e871;
                                            }
                                            let _e881 = phi_1558_;
                                            let _e883 = phi_1559_;
                                            phi_1560_ = _e881;
                                            phi_1561_ = _e883;
                                        } else {
                                            phi_1560_ = _e865;
                                            phi_1561_ = _e871;
                                        }
                                        let _e885 = phi_1560_;
                                        let _e887 = phi_1561_;
                                        phi_1562_ = _e885;
                                        phi_1563_ = _e867;
                                        phi_1564_ = _e869;
                                        phi_1565_ = _e887;
                                    } else {
                                        phi_1562_ = u32();
                                        phi_1563_ = u32();
                                        phi_1564_ = u32();
                                        phi_1565_ = u32();
                                    }
                                    let _e889 = phi_1562_;
                                    let _e891 = phi_1563_;
                                    let _e893 = phi_1564_;
                                    let _e895 = phi_1565_;
                                    phi_1213_ = _e889;
                                    phi_1216_ = _e891;
                                    phi_1218_ = _e893;
                                    phi_1220_ = _e895;
                                    phi_1566_ = _e568;
                                }
                                let _e897 = phi_1213_;
                                let _e899 = phi_1216_;
                                let _e901 = phi_1218_;
                                let _e903 = phi_1220_;
                                let _e905 = phi_1566_;
                                continue;
                                continuing {
                                    phi_1212_ = _e897;
                                    phi_1215_ = _e899;
                                    phi_1217_ = _e901;
                                    phi_1219_ = _e903;
                                    break if !(_e905);
                                }
                            }
                            let _e908 = local_4;
                            if _e908 {
                            }
                            let _e3376 = local_13;
                            phi_1571_ = _e3376;
                            loop {
                                let _e910 = phi_1571_;
                                let _e911 = (_e910 == 0u);
                                local_6 = _e911;
                                local_18 = _e911;
                                if _e911 {
                                    phi_1572_ = u32();
                                    phi_2417_ = false;
                                    phi_2418_ = false;
                                    phi_2419_ = false;
                                } else {
                                    let _e914 = select(firstTrailingBit(_e910), 32u, (_e910 == 0u));
                                    let _e918 = local_5;
                                    let _e919 = (_e918 + (_e914 >> bitcast<u32>(2i)));
                                    if (_e919 < _e101) {
                                    } else {
                                        return;
                                    }
                                    let _e924 = rows.member[(0u + _e919)][0u];
                                    let _e928 = rows.member[(0u + _e919)][1u];
                                    let _e932 = rows.member[(0u + _e919)][2u];
                                    let _e936 = rows.member[(0u + _e919)][3u];
                                    if ((_e914 & 2u) == 0u) {
                                        phi_1610_ = _e928;
                                        phi_1611_ = _e924;
                                    } else {
                                        phi_1610_ = _e936;
                                        phi_1611_ = _e932;
                                    }
                                    let _e940 = phi_1610_;
                                    let _e942 = phi_1611_;
                                    if ((_e914 & 1u) == 0u) {
                                        phi_1617_ = _e942;
                                    } else {
                                        phi_1617_ = _e940;
                                    }
                                    let _e946 = phi_1617_;
                                    if (_e946 < _e92) {
                                    } else {
                                        return;
                                    }
                                    let _e953 = triangles.member[(0u + _e946)].v0_;
                                    let _e955 = (_e953.x - _e145);
                                    let _e957 = (_e953.y - _e147);
                                    let _e959 = (_e953.z - _e149);
                                    if (_e534 == 0u) {
                                        phi_1647_ = vec3<f32>(_e957, _e959, _e955);
                                    } else {
                                        if (_e534 == 1u) {
                                            phi_1646_ = vec3<f32>(_e959, _e955, _e957);
                                        } else {
                                            phi_1646_ = (_e953 - vec3<f32>(_e145, _e147, _e149));
                                        }
                                        let _e967 = phi_1646_;
                                        phi_1647_ = _e967;
                                    }
                                    let _e969 = phi_1647_;
                                    let _e973 = (_e969.x - (_e545 * _e969.z));
                                    let _e977 = (_e969.y - (_e548 * _e969.z));
                                    let _e979 = triangles.member[(0u + _e946)].v1_;
                                    let _e981 = (_e979.x - _e145);
                                    let _e983 = (_e979.y - _e147);
                                    let _e985 = (_e979.z - _e149);
                                    if (_e534 == 0u) {
                                        phi_1677_ = vec3<f32>(_e983, _e985, _e981);
                                    } else {
                                        if (_e534 == 1u) {
                                            phi_1676_ = vec3<f32>(_e985, _e981, _e983);
                                        } else {
                                            phi_1676_ = (_e979 - vec3<f32>(_e145, _e147, _e149));
                                        }
                                        let _e993 = phi_1676_;
                                        phi_1677_ = _e993;
                                    }
                                    let _e995 = phi_1677_;
                                    let _e999 = (_e995.x - (_e545 * _e995.z));
                                    let _e1003 = (_e995.y - (_e548 * _e995.z));
                                    let _e1005 = triangles.member[(0u + _e946)].v2_;
                                    let _e1007 = (_e1005.x - _e145);
                                    let _e1009 = (_e1005.y - _e147);
                                    let _e1011 = (_e1005.z - _e149);
                                    if (_e534 == 0u) {
                                        phi_1707_ = vec3<f32>(_e1009, _e1011, _e1007);
                                    } else {
                                        if (_e534 == 1u) {
                                            phi_1706_ = vec3<f32>(_e1011, _e1007, _e1009);
                                        } else {
                                            phi_1706_ = (_e1005 - vec3<f32>(_e145, _e147, _e149));
                                        }
                                        let _e1019 = phi_1706_;
                                        phi_1707_ = _e1019;
                                    }
                                    let _e1021 = phi_1707_;
                                    let _e1025 = (_e1021.x - (_e545 * _e1021.z));
                                    let _e1029 = (_e1021.y - (_e548 * _e1021.z));
                                    if (_e999 < _e1025) {
                                        phi_1726_ = true;
                                    } else {
                                        if (_e999 == _e1025) {
                                            phi_1725_ = (_e1003 < _e1029);
                                        } else {
                                            phi_1725_ = false;
                                        }
                                        let _e1034 = phi_1725_;
                                        phi_1726_ = _e1034;
                                    }
                                    let _e1036 = phi_1726_;
                                    if _e1036 {
                                        phi_1730_ = _e1029;
                                        phi_1731_ = _e1025;
                                        phi_1732_ = _e1003;
                                        phi_1733_ = _e999;
                                    } else {
                                        phi_1730_ = _e1003;
                                        phi_1731_ = _e999;
                                        phi_1732_ = _e1029;
                                        phi_1733_ = _e1025;
                                    }
                                    let _e1038 = phi_1730_;
                                    let _e1040 = phi_1731_;
                                    let _e1042 = phi_1732_;
                                    let _e1044 = phi_1733_;
                                    let _e1047 = ((_e1044 * _e1038) - (_e1042 * _e1040));
                                    if _e1036 {
                                        phi_1741_ = -(_e1047);
                                    } else {
                                        phi_1741_ = _e1047;
                                    }
                                    let _e1050 = phi_1741_;
                                    if (_e1025 < _e973) {
                                        phi_1752_ = true;
                                    } else {
                                        if (_e1025 == _e973) {
                                            phi_1751_ = (_e1029 < _e977);
                                        } else {
                                            phi_1751_ = false;
                                        }
                                        let _e1055 = phi_1751_;
                                        phi_1752_ = _e1055;
                                    }
                                    let _e1057 = phi_1752_;
                                    if _e1057 {
                                        phi_1756_ = _e977;
                                        phi_1757_ = _e973;
                                        phi_1758_ = _e1029;
                                        phi_1759_ = _e1025;
                                    } else {
                                        phi_1756_ = _e1029;
                                        phi_1757_ = _e1025;
                                        phi_1758_ = _e977;
                                        phi_1759_ = _e973;
                                    }
                                    let _e1059 = phi_1756_;
                                    let _e1061 = phi_1757_;
                                    let _e1063 = phi_1758_;
                                    let _e1065 = phi_1759_;
                                    let _e1068 = ((_e1065 * _e1059) - (_e1063 * _e1061));
                                    if _e1057 {
                                        phi_1767_ = -(_e1068);
                                    } else {
                                        phi_1767_ = _e1068;
                                    }
                                    let _e1071 = phi_1767_;
                                    if (_e973 < _e999) {
                                        phi_1778_ = true;
                                    } else {
                                        if (_e973 == _e999) {
                                            phi_1777_ = (_e977 < _e1003);
                                        } else {
                                            phi_1777_ = false;
                                        }
                                        let _e1076 = phi_1777_;
                                        phi_1778_ = _e1076;
                                    }
                                    let _e1078 = phi_1778_;
                                    if _e1078 {
                                        phi_1782_ = _e1003;
                                        phi_1783_ = _e999;
                                        phi_1784_ = _e977;
                                        phi_1785_ = _e973;
                                    } else {
                                        phi_1782_ = _e977;
                                        phi_1783_ = _e973;
                                        phi_1784_ = _e1003;
                                        phi_1785_ = _e999;
                                    }
                                    let _e1080 = phi_1782_;
                                    let _e1082 = phi_1783_;
                                    let _e1084 = phi_1784_;
                                    let _e1086 = phi_1785_;
                                    let _e1089 = ((_e1086 * _e1080) - (_e1084 * _e1082));
                                    if _e1078 {
                                        phi_1793_ = -(_e1089);
                                    } else {
                                        phi_1793_ = _e1089;
                                    }
                                    let _e1092 = phi_1793_;
                                    if (_e1050 >= 0f) {
                                        if (_e1071 >= 0f) {
                                            if (_e1092 >= 0f) {
                                                phi_1808_ = ((_e1050 + _e1071) + _e1092);
                                                phi_1809_ = false;
                                            } else {
                                                phi_1808_ = f32();
                                                phi_1809_ = true;
                                            }
                                            let _e1099 = phi_1808_;
                                            let _e1101 = phi_1809_;
                                            phi_1810_ = _e1099;
                                            phi_1811_ = _e1101;
                                        } else {
                                            phi_1810_ = f32();
                                            phi_1811_ = true;
                                        }
                                        let _e1103 = phi_1810_;
                                        let _e1105 = phi_1811_;
                                        phi_1812_ = _e1103;
                                        phi_1813_ = _e1105;
                                    } else {
                                        phi_1812_ = f32();
                                        phi_1813_ = true;
                                    }
                                    let _e1107 = phi_1812_;
                                    let _e1109 = phi_1813_;
                                    if _e1109 {
                                        if (_e1050 <= 0f) {
                                            if (_e1071 <= 0f) {
                                                let _e1112 = (_e1092 <= 0f);
                                                if _e1112 {
                                                }
                                                phi_1831_ = ((_e1050 + _e1071) + _e1092);
                                                phi_1832_ = false;
                                                phi_1833_ = _e1112;
                                            } else {
                                                phi_1831_ = f32();
                                                phi_1832_ = true;
                                                phi_1833_ = false;
                                            }
                                            let _e1116 = phi_1831_;
                                            let _e1118 = phi_1832_;
                                            let _e1120 = phi_1833_;
                                            phi_1834_ = _e1116;
                                            phi_1835_ = _e1118;
                                            phi_1836_ = _e1120;
                                        } else {
                                            phi_1834_ = f32();
                                            phi_1835_ = true;
                                            phi_1836_ = false;
                                        }
                                        let _e1122 = phi_1834_;
                                        let _e1124 = phi_1835_;
                                        let _e1126 = phi_1836_;
                                        if _e1124 {
                                            phi_1840_ = false;
                                        } else {
                                            phi_1840_ = _e1126;
                                        }
                                        let _e1128 = phi_1840_;
                                        phi_1841_ = _e1122;
                                        phi_1842_ = _e1128;
                                    } else {
                                        phi_1841_ = _e1107;
                                        phi_1842_ = true;
                                    }
                                    let _e1130 = phi_1841_;
                                    let _e1132 = phi_1842_;
                                    if _e1132 {
                                        let _e1133 = (_e1130 == 0f);
                                        if _e1133 {
                                            phi_2158_ = lt_bvh_triangle_Intersection();
                                            phi_2159_ = false;
                                        } else {
                                            let _e1135 = triangles.member[(0u + _e946)].v0_;
                                            let _e1137 = (_e1135.x - _e145);
                                            let _e1139 = (_e1135.y - _e147);
                                            let _e1141 = (_e1135.z - _e149);
                                            if (_e534 == 0u) {
                                                phi_1871_ = vec3<f32>(_e1139, _e1141, _e1137);
                                            } else {
                                                if (_e534 == 1u) {
                                                    phi_1870_ = vec3<f32>(_e1141, _e1137, _e1139);
                                                } else {
                                                    phi_1870_ = (_e1135 - vec3<f32>(_e145, _e147, _e149));
                                                }
                                                let _e1149 = phi_1870_;
                                                phi_1871_ = _e1149;
                                            }
                                            let _e1151 = phi_1871_;
                                            let _e1153 = triangles.member[(0u + _e946)].v1_;
                                            let _e1155 = triangles.member[(0u + _e946)].v0_;
                                            let _e1158 = (_e1153.x - _e1155.x);
                                            let _e1161 = (_e1153.y - _e1155.y);
                                            let _e1164 = (_e1153.z - _e1155.z);
                                            if (_e534 == 0u) {
                                                phi_1897_ = vec3<f32>(_e1161, _e1164, _e1158);
                                            } else {
                                                if (_e534 == 1u) {
                                                    phi_1896_ = vec3<f32>(_e1164, _e1158, _e1161);
                                                } else {
                                                    phi_1896_ = (_e1153 - _e1155);
                                                }
                                                let _e1171 = phi_1896_;
                                                phi_1897_ = _e1171;
                                            }
                                            let _e1173 = phi_1897_;
                                            let _e1175 = triangles.member[(0u + _e946)].v2_;
                                            let _e1177 = triangles.member[(0u + _e946)].v0_;
                                            let _e1180 = (_e1175.x - _e1177.x);
                                            let _e1183 = (_e1175.y - _e1177.y);
                                            let _e1186 = (_e1175.z - _e1177.z);
                                            if (_e534 == 0u) {
                                                phi_1923_ = vec3<f32>(_e1183, _e1186, _e1180);
                                            } else {
                                                if (_e534 == 1u) {
                                                    phi_1922_ = vec3<f32>(_e1186, _e1180, _e1183);
                                                } else {
                                                    phi_1922_ = (_e1175 - _e1177);
                                                }
                                                let _e1193 = phi_1922_;
                                                phi_1923_ = _e1193;
                                            }
                                            let _e1195 = phi_1923_;
                                            let _e1202 = ((_e1173.y * _e1195.z) - (_e1173.z * _e1195.y));
                                            let _e1209 = ((_e1173.z * _e1195.x) - (_e1173.x * _e1195.z));
                                            let _e1216 = ((_e1173.x * _e1195.y) - (_e1173.y * _e1195.x));
                                            let _e1230 = (((1f / _e542.z) * (((_e1202 * _e1151.x) + (_e1209 * _e1151.y)) + (_e1216 * _e1151.z))) / (((_e1202 * _e545) + (_e1209 * _e548)) + _e1216));
                                            if (_e1230 > 0f) {
                                                if (_e1230 < _e157) {
                                                    let _e1234 = triangles.member[(0u + _e946)].v0_;
                                                    let _e1236 = triangles.member[(0u + _e946)].v1_;
                                                    if (_e1234.x < _e1236.x) {
                                                        phi_1979_ = _e1234.x;
                                                    } else {
                                                        phi_1979_ = _e1236.x;
                                                    }
                                                    let _e1243 = phi_1979_;
                                                    if (_e1234.y < _e1236.y) {
                                                        phi_1988_ = _e1234.y;
                                                    } else {
                                                        phi_1988_ = _e1236.y;
                                                    }
                                                    let _e1250 = phi_1988_;
                                                    if (_e1234.z < _e1236.z) {
                                                        phi_1997_ = _e1234.z;
                                                    } else {
                                                        phi_1997_ = _e1236.z;
                                                    }
                                                    let _e1257 = phi_1997_;
                                                    let _e1259 = triangles.member[(0u + _e946)].v2_;
                                                    if (_e1243 < _e1259.x) {
                                                        phi_2006_ = _e1243;
                                                    } else {
                                                        phi_2006_ = _e1259.x;
                                                    }
                                                    let _e1264 = phi_2006_;
                                                    if (_e1250 < _e1259.y) {
                                                        phi_2013_ = _e1250;
                                                    } else {
                                                        phi_2013_ = _e1259.y;
                                                    }
                                                    let _e1269 = phi_2013_;
                                                    if (_e1257 < _e1259.z) {
                                                        phi_2020_ = _e1257;
                                                    } else {
                                                        phi_2020_ = _e1259.z;
                                                    }
                                                    let _e1274 = phi_2020_;
                                                    let _e1276 = triangles.member[(0u + _e946)].v0_;
                                                    let _e1278 = triangles.member[(0u + _e946)].v1_;
                                                    if (_e1276.x > _e1278.x) {
                                                        phi_2033_ = _e1276.x;
                                                    } else {
                                                        phi_2033_ = _e1278.x;
                                                    }
                                                    let _e1285 = phi_2033_;
                                                    if (_e1276.y > _e1278.y) {
                                                        phi_2042_ = _e1276.y;
                                                    } else {
                                                        phi_2042_ = _e1278.y;
                                                    }
                                                    let _e1292 = phi_2042_;
                                                    if (_e1276.z > _e1278.z) {
                                                        phi_2051_ = _e1276.z;
                                                    } else {
                                                        phi_2051_ = _e1278.z;
                                                    }
                                                    let _e1299 = phi_2051_;
                                                    let _e1301 = triangles.member[(0u + _e946)].v2_;
                                                    if (_e1285 > _e1301.x) {
                                                        phi_2060_ = _e1285;
                                                    } else {
                                                        phi_2060_ = _e1301.x;
                                                    }
                                                    let _e1306 = phi_2060_;
                                                    if (_e1292 > _e1301.y) {
                                                        phi_2067_ = _e1292;
                                                    } else {
                                                        phi_2067_ = _e1301.y;
                                                    }
                                                    let _e1311 = phi_2067_;
                                                    if (_e1299 > _e1301.z) {
                                                        phi_2074_ = _e1299;
                                                    } else {
                                                        phi_2074_ = _e1301.z;
                                                    }
                                                    let _e1316 = phi_2074_;
                                                    let _e1320 = ((_e1264 - _e145) * _e463);
                                                    let _e1321 = ((_e1269 - _e147) * _e473);
                                                    let _e1322 = ((_e1274 - _e149) * _e483);
                                                    let _e1326 = ((_e1306 - _e145) * _e463);
                                                    let _e1327 = ((_e1311 - _e147) * _e473);
                                                    let _e1328 = ((_e1316 - _e149) * _e483);
                                                    if (_e1320 < _e1326) {
                                                        phi_2091_ = _e1320;
                                                    } else {
                                                        phi_2091_ = _e1326;
                                                    }
                                                    let _e1331 = phi_2091_;
                                                    if (_e1321 < _e1327) {
                                                        phi_2096_ = _e1321;
                                                    } else {
                                                        phi_2096_ = _e1327;
                                                    }
                                                    let _e1334 = phi_2096_;
                                                    if (_e1322 < _e1328) {
                                                        phi_2101_ = _e1322;
                                                    } else {
                                                        phi_2101_ = _e1328;
                                                    }
                                                    let _e1337 = phi_2101_;
                                                    if (_e1320 > _e1326) {
                                                        phi_2109_ = _e1320;
                                                    } else {
                                                        phi_2109_ = _e1326;
                                                    }
                                                    let _e1343 = phi_2109_;
                                                    if (_e1321 > _e1327) {
                                                        phi_2114_ = _e1321;
                                                    } else {
                                                        phi_2114_ = _e1327;
                                                    }
                                                    let _e1346 = phi_2114_;
                                                    if (_e1322 > _e1328) {
                                                        phi_2119_ = _e1322;
                                                    } else {
                                                        phi_2119_ = _e1328;
                                                    }
                                                    let _e1349 = phi_2119_;
                                                    let _e1353 = core_intrinsics_maximum_number_nsz_f32_((_e1331 - _e518), (_e1334 - _e519));
                                                    let _e1354 = core_intrinsics_maximum_number_nsz_f32_(_e1353, (_e1337 - _e520));
                                                    let _e1355 = core_intrinsics_minimum_number_nsz_f32_((_e1343 + _e518), (_e1346 + _e519));
                                                    let _e1356 = core_intrinsics_minimum_number_nsz_f32_(_e1355, (_e1349 + _e520));
                                                    if (_e1354 > -300000000000000000000000000000000000000f) {
                                                        phi_2131_ = _e1354;
                                                    } else {
                                                        phi_2131_ = -300000000000000000000000000000000000000f;
                                                    }
                                                    let _e1359 = phi_2131_;
                                                    if (_e1356 < 300000000000000000000000000000000000000f) {
                                                        phi_2136_ = _e1356;
                                                    } else {
                                                        phi_2136_ = 300000000000000000000000000000000000000f;
                                                    }
                                                    let _e1362 = phi_2136_;
                                                    if (_e1230 < _e1359) {
                                                        phi_2141_ = _e1359;
                                                    } else {
                                                        phi_2141_ = _e1230;
                                                    }
                                                    let _e1365 = phi_2141_;
                                                    if (_e1365 > _e1362) {
                                                        phi_2146_ = _e1362;
                                                    } else {
                                                        phi_2146_ = _e1365;
                                                    }
                                                    let _e1368 = phi_2146_;
                                                    phi_2151_ = lt_bvh_triangle_Intersection(_e1368, (_e1071 / _e1130), (_e1092 / _e1130), (_e1359 <= _e1362));
                                                    phi_2152_ = false;
                                                } else {
                                                    phi_2151_ = lt_bvh_triangle_Intersection();
                                                    phi_2152_ = true;
                                                }
                                                let _e1374 = phi_2151_;
                                                let _e1376 = phi_2152_;
                                                phi_2153_ = _e1374;
                                                phi_2154_ = _e1376;
                                            } else {
                                                phi_2153_ = lt_bvh_triangle_Intersection();
                                                phi_2154_ = true;
                                            }
                                            let _e1378 = phi_2153_;
                                            let _e1380 = phi_2154_;
                                            if _e1380 {
                                            }
                                            phi_2158_ = _e1378;
                                            phi_2159_ = _e1380;
                                        }
                                        let _e1382 = phi_2158_;
                                        let _e1384 = phi_2159_;
                                        phi_2160_ = _e1382;
                                        phi_2161_ = _e1133;
                                        phi_2162_ = _e1384;
                                    } else {
                                        phi_2160_ = lt_bvh_triangle_Intersection();
                                        phi_2161_ = true;
                                        phi_2162_ = false;
                                    }
                                    let _e1386 = phi_2160_;
                                    let _e1388 = phi_2161_;
                                    let _e1390 = phi_2162_;
                                    if _e1388 {
                                        phi_2166_ = true;
                                    } else {
                                        phi_2166_ = _e1390;
                                    }
                                    let _e1392 = phi_2166_;
                                    if _e1392 {
                                        phi_2170_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                    } else {
                                        phi_2170_ = _e1386;
                                    }
                                    let _e1394 = phi_2170_;
                                    if _e1394.is_hit {
                                        if (_e1394.t > 0f) {
                                            if (_e1394.t < _e157) {
                                                let _e1401 = triangles.member[(0u + _e946)].i0_;
                                                let _e1403 = ((_e1401 & 2147483648u) == 0u);
                                                if _e1403 {
                                                    phi_2393_ = false;
                                                    phi_2394_ = false;
                                                } else {
                                                    if (_e946 < _e92) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1410 = triangles.member[(0u + _e946)].i0_;
                                                    let _e1411 = (_e1410 & 2147483647u);
                                                    let _e1413 = triangles.member[(0u + _e946)].i1_;
                                                    let _e1415 = triangles.member[(0u + _e946)].i2_;
                                                    if (_e1411 < _e105) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1419 = vertices.member[(0u + _e1411)];
                                                    if (_e1413 < _e105) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1423 = vertices.member[(0u + _e1413)];
                                                    if (_e1415 < _e105) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1427 = vertices.member[(0u + _e1415)];
                                                    let _e1428 = array<abi_Vertex, 3>(_e1419, _e1423, _e1427);
                                                    if (_e1428[0].material < _e108) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1434 = materials.member[(0u + _e1428[0].material)];
                                                    if ((_e1434.flags & 1u) == 1u) {
                                                        let _e1439 = ((1f - _e1394.u) - _e1394.v);
                                                        if (_e1434.cutoff <= 0f) {
                                                            phi_2387_ = true;
                                                        } else {
                                                            let _e1466 = (_e1434.base_color.w * ((((f32((_e1428[0].color >> bitcast<u32>(24i))) * _e1439) + (f32((_e1428[1].color >> bitcast<u32>(24i))) * _e1394.u)) + (f32((_e1428[2].color >> bitcast<u32>(24i))) * _e1394.v)) * (1f / 255f)));
                                                            if (_e1434.alpha_size == 0u) {
                                                                phi_2384_ = _e1466;
                                                            } else {
                                                                local_2.offset = _e1434.alpha_offset;
                                                                local_2.size = _e1434.alpha_size;
                                                                local_2.flags = _e1434.flags;
                                                                let _e1497 = _lt_shaders_texture_TextureView_quad((&local_2), (((_e1428[0].u * _e1439) + (_e1428[1].u * _e1394.u)) + (_e1428[2].u * _e1394.v)), (((_e1428[0].v * _e1439) + (_e1428[1].v * _e1394.u)) + (_e1428[2].v * _e1394.v)));
                                                                let _e1501 = (_e1497.indices[0] >> bitcast<u32>(2i));
                                                                if (_e1501 < _e111) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1505 = alpha_texels.member[(0u + _e1501)];
                                                                let _e1521 = (_e1497.indices[1] >> bitcast<u32>(2i));
                                                                if (_e1521 < _e111) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1525 = alpha_texels.member[(0u + _e1521)];
                                                                let _e1542 = (_e1497.indices[2] >> bitcast<u32>(2i));
                                                                if (_e1542 < _e111) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1546 = alpha_texels.member[(0u + _e1542)];
                                                                let _e1563 = (_e1497.indices[3] >> bitcast<u32>(2i));
                                                                if (_e1563 < _e111) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1567 = alpha_texels.member[(0u + _e1563)];
                                                                phi_2384_ = (_e1466 * (((((f32(((_e1505 >> bitcast<u32>((((_e1497.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1497.weights.x) + ((f32(((_e1525 >> bitcast<u32>((((_e1497.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1497.weights.y)) + ((f32(((_e1546 >> bitcast<u32>((((_e1497.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1497.weights.z)) + ((f32(((_e1567 >> bitcast<u32>((((_e1497.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1497.weights.w)));
                                                            }
                                                            let _e1583 = phi_2384_;
                                                            phi_2387_ = (_e1583 >= _e1434.cutoff);
                                                        }
                                                        let _e1587 = phi_2387_;
                                                        phi_2388_ = _e1587;
                                                    } else {
                                                        phi_2388_ = false;
                                                    }
                                                    let _e1589 = phi_2388_;
                                                    if _e1589 {
                                                        phi_2392_ = false;
                                                    } else {
                                                        phi_2392_ = true;
                                                    }
                                                    let _e1591 = phi_2392_;
                                                    phi_2393_ = _e1591;
                                                    phi_2394_ = _e1589;
                                                }
                                                let _e1593 = phi_2393_;
                                                let _e1595 = phi_2394_;
                                                phi_2395_ = _e1593;
                                                phi_2396_ = _e1403;
                                                phi_2397_ = _e1595;
                                            } else {
                                                phi_2395_ = true;
                                                phi_2396_ = false;
                                                phi_2397_ = false;
                                            }
                                            let _e1597 = phi_2395_;
                                            let _e1599 = phi_2396_;
                                            let _e1601 = phi_2397_;
                                            phi_2398_ = false;
                                            phi_2399_ = _e1597;
                                            phi_2400_ = _e1599;
                                            phi_2401_ = _e1601;
                                        } else {
                                            phi_2398_ = true;
                                            phi_2399_ = false;
                                            phi_2400_ = false;
                                            phi_2401_ = false;
                                        }
                                        let _e1603 = phi_2398_;
                                        let _e1605 = phi_2399_;
                                        let _e1607 = phi_2400_;
                                        let _e1609 = phi_2401_;
                                        phi_2402_ = _e1603;
                                        phi_2403_ = _e1605;
                                        phi_2404_ = _e1607;
                                        phi_2405_ = _e1609;
                                    } else {
                                        phi_2402_ = true;
                                        phi_2403_ = false;
                                        phi_2404_ = false;
                                        phi_2405_ = false;
                                    }
                                    let _e1611 = phi_2402_;
                                    let _e1613 = phi_2403_;
                                    let _e1615 = phi_2404_;
                                    let _e1617 = phi_2405_;
                                    if _e1611 {
                                        phi_2409_ = true;
                                        phi_2410_ = false;
                                        phi_2411_ = false;
                                    } else {
                                        phi_2409_ = _e1613;
                                        phi_2410_ = _e1615;
                                        phi_2411_ = _e1617;
                                    }
                                    let _e1619 = phi_2409_;
                                    let _e1621 = phi_2410_;
                                    let _e1623 = phi_2411_;
                                    if _e1619 {
                                        phi_2415_ = false;
                                        phi_2416_ = false;
                                    } else {
                                        phi_2415_ = _e1621;
                                        phi_2416_ = _e1623;
                                    }
                                    let _e1625 = phi_2415_;
                                    let _e1627 = phi_2416_;
                                    phi_1572_ = (_e910 & (_e910 - 1u));
                                    phi_2417_ = _e1619;
                                    phi_2418_ = _e1625;
                                    phi_2419_ = _e1627;
                                }
                                let _e1629 = phi_1572_;
                                let _e1631 = phi_2417_;
                                let _e1633 = phi_2418_;
                                let _e1635 = phi_2419_;
                                local_14 = _e1633;
                                local_15 = _e1635;
                                continue;
                                continuing {
                                    phi_1571_ = _e1629;
                                    break if !(_e1631);
                                }
                            }
                            let _e1638 = local_6;
                            if _e1638 {
                                phi_2423_ = false;
                                phi_2424_ = false;
                            } else {
                                let _e3491 = local_14;
                                phi_2423_ = _e3491;
                                let _e3494 = local_15;
                                phi_2424_ = _e3494;
                            }
                            let _e1640 = phi_2423_;
                            let _e1642 = phi_2424_;
                            let _e3497 = local_16;
                            phi_1201_ = _e3497;
                            let _e3500 = local_17;
                            phi_1204_ = _e3500;
                            let _e3503 = local_18;
                            phi_2425_ = _e3503;
                            phi_2426_ = _e1640;
                            phi_2427_ = _e1642;
                        }
                        let _e1644 = phi_1201_;
                        let _e1646 = phi_1204_;
                        let _e1648 = phi_2425_;
                        let _e1650 = phi_2426_;
                        let _e1652 = phi_2427_;
                        local_19 = _e1650;
                        local_20 = _e1652;
                        continue;
                        continuing {
                            phi_1200_ = _e1644;
                            phi_1203_ = _e1646;
                            break if !(_e1648);
                        }
                    }
                    let _e1655 = local_7;
                    if _e1655 {
                        phi_2431_ = false;
                        phi_2432_ = false;
                    } else {
                        let _e3509 = local_19;
                        phi_2431_ = _e3509;
                        let _e3512 = local_20;
                        phi_2432_ = _e3512;
                    }
                    let _e1657 = phi_2431_;
                    let _e1659 = phi_2432_;
                    if _e1657 {
                        phi_2436_ = false;
                    } else {
                        phi_2436_ = _e1659;
                    }
                    let _e1661 = phi_2436_;
                    if _e1661 {
                        phi_2440_ = true;
                    } else {
                        phi_2440_ = _e1657;
                    }
                    let _e1663 = phi_2440_;
                    if _e1663 {
                    }
                    phi_2444_ = true;
                    phi_2445_ = _e1663;
                }
                let _e1665 = phi_2444_;
                let _e1667 = phi_2445_;
                if _e1667 {
                    phi_2449_ = _e1665;
                } else {
                    phi_2449_ = false;
                }
                let _e1669 = phi_2449_;
                phi_4114_ = _e1669;
            } else {
                let _e1670 = abs(_e165);
                let _e1671 = abs(_e166);
                let _e1672 = abs(_e167);
                if (abs(_e145) < 1000000000000000f) {
                    if (abs(_e147) < 1000000000000000f) {
                        phi_2465_ = (abs(_e149) < 1000000000000000f);
                        phi_2466_ = false;
                    } else {
                        phi_2465_ = bool();
                        phi_2466_ = true;
                    }
                    let _e1680 = phi_2465_;
                    let _e1682 = phi_2466_;
                    phi_2467_ = _e1680;
                    phi_2468_ = _e1682;
                } else {
                    phi_2467_ = bool();
                    phi_2468_ = true;
                }
                let _e1684 = phi_2467_;
                let _e1686 = phi_2468_;
                if _e1686 {
                    phi_2472_ = false;
                } else {
                    phi_2472_ = _e1684;
                }
                let _e1688 = phi_2472_;
                if _e1688 {
                    if (_e1670 < 1000000000000000f) {
                        if (_e1671 < 1000000000000000f) {
                            phi_2485_ = (_e1672 < 1000000000000000f);
                            phi_2486_ = false;
                        } else {
                            phi_2485_ = bool();
                            phi_2486_ = true;
                        }
                        let _e1693 = phi_2485_;
                        let _e1695 = phi_2486_;
                        phi_2487_ = _e1693;
                        phi_2488_ = _e1695;
                    } else {
                        phi_2487_ = bool();
                        phi_2488_ = true;
                    }
                    let _e1697 = phi_2487_;
                    let _e1699 = phi_2488_;
                    if _e1699 {
                        phi_2492_ = false;
                    } else {
                        phi_2492_ = _e1697;
                    }
                    let _e1701 = phi_2492_;
                    if _e1701 {
                        if (_e1670 > 0f) {
                            phi_2506_ = bool();
                            phi_2507_ = true;
                        } else {
                            let _e1703 = (_e1671 > 0f);
                            if _e1703 {
                                phi_2505_ = bool();
                            } else {
                                phi_2505_ = (_e1672 > 0f);
                            }
                            let _e1706 = phi_2505_;
                            phi_2506_ = _e1706;
                            phi_2507_ = _e1703;
                        }
                        let _e1708 = phi_2506_;
                        let _e1710 = phi_2507_;
                        if _e1710 {
                            phi_2511_ = true;
                        } else {
                            phi_2511_ = _e1708;
                        }
                        let _e1712 = phi_2511_;
                        phi_2512_ = _e1712;
                        phi_2513_ = false;
                    } else {
                        phi_2512_ = bool();
                        phi_2513_ = true;
                    }
                    let _e1714 = phi_2512_;
                    let _e1716 = phi_2513_;
                    phi_2514_ = _e1714;
                    phi_2515_ = _e1716;
                } else {
                    phi_2514_ = bool();
                    phi_2515_ = true;
                }
                let _e1718 = phi_2514_;
                let _e1720 = phi_2515_;
                if _e1720 {
                    phi_2519_ = false;
                } else {
                    phi_2519_ = _e1718;
                }
                let _e1722 = phi_2519_;
                if _e1722 {
                    let _e1723 = (0u >= _e89);
                    if _e1723 {
                        phi_4107_ = bool();
                    } else {
                        if (0u < _e89) {
                        } else {
                            return;
                        }
                        let _e1729 = nodes.member[(0u + 0u)].frame[0u];
                        let _e1733 = nodes.member[(0u + 0u)].frame[1u];
                        let _e1737 = nodes.member[(0u + 0u)].frame[2u];
                        let _e1741 = nodes.member[(0u + 0u)].frame[0u];
                        let _e1745 = nodes.member[(0u + 0u)].frame[1u];
                        let _e1749 = nodes.member[(0u + 0u)].frame[2u];
                        let _e1753 = nodes.member[(0u + 0u)].frame[3u];
                        let _e1787 = core_intrinsics_maximum_number_nsz_f32_(abs(_e165), abs(_e166));
                        let _e1788 = core_intrinsics_maximum_number_nsz_f32_(_e1787, abs(_e167));
                        let _e1789 = (_e1788 * 0.0000000000009094947f);
                        if (abs(_e165) < _e1789) {
                            phi_2589_ = _e1789;
                        } else {
                            phi_2589_ = abs(_e165);
                        }
                        let _e1794 = phi_2589_;
                        if (_e165 < 0f) {
                            phi_2596_ = (-1f / _e1794);
                        } else {
                            phi_2596_ = (1f / _e1794);
                        }
                        let _e1799 = phi_2596_;
                        if (abs(_e166) < _e1789) {
                            phi_2603_ = _e1789;
                        } else {
                            phi_2603_ = abs(_e166);
                        }
                        let _e1804 = phi_2603_;
                        if (_e166 < 0f) {
                            phi_2610_ = (-1f / _e1804);
                        } else {
                            phi_2610_ = (1f / _e1804);
                        }
                        let _e1809 = phi_2610_;
                        if (abs(_e167) < _e1789) {
                            phi_2617_ = _e1789;
                        } else {
                            phi_2617_ = abs(_e167);
                        }
                        let _e1814 = phi_2617_;
                        if (_e167 < 0f) {
                            phi_2624_ = (-1f / _e1814);
                        } else {
                            phi_2624_ = (1f / _e1814);
                        }
                        let _e1819 = phi_2624_;
                        let _e1823 = abs((bitcast<f32>(_e1729) - _e145));
                        let _e1824 = abs((bitcast<f32>(_e1733) - _e147));
                        let _e1825 = abs((bitcast<f32>(_e1737) - _e149));
                        let _e1829 = abs(((bitcast<f32>(_e1741) + (bitcast<f32>((((_e1753 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e145));
                        let _e1830 = abs(((bitcast<f32>(_e1745) + (bitcast<f32>((((_e1753 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e147));
                        let _e1831 = abs(((bitcast<f32>(_e1749) + (bitcast<f32>((((_e1753 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e149));
                        if (_e1823 > _e1829) {
                            phi_2641_ = _e1823;
                        } else {
                            phi_2641_ = _e1829;
                        }
                        let _e1834 = phi_2641_;
                        if (_e1824 > _e1830) {
                            phi_2646_ = _e1824;
                        } else {
                            phi_2646_ = _e1830;
                        }
                        let _e1837 = phi_2646_;
                        if (_e1825 > _e1831) {
                            phi_2651_ = _e1825;
                        } else {
                            phi_2651_ = _e1831;
                        }
                        let _e1840 = phi_2651_;
                        if (_e1834 > _e1837) {
                            phi_2656_ = _e1834;
                        } else {
                            phi_2656_ = _e1837;
                        }
                        let _e1843 = phi_2656_;
                        if (_e1843 > _e1840) {
                            phi_2661_ = _e1843;
                        } else {
                            phi_2661_ = _e1840;
                        }
                        let _e1846 = phi_2661_;
                        let _e1850 = (_e1846 * 0.0000019073486f);
                        let _e1851 = (abs(_e1799) * _e1850);
                        let _e1852 = (abs(_e1809) * _e1850);
                        let _e1853 = (abs(_e1819) * _e1850);
                        let _e1857 = (_e1846 * 0.0000009536743f);
                        let _e1858 = (abs(_e1799) * _e1857);
                        let _e1859 = (abs(_e1809) * _e1857);
                        let _e1860 = (abs(_e1819) * _e1857);
                        let _e1861 = abs(_e165);
                        let _e1862 = abs(_e166);
                        let _e1863 = abs(_e167);
                        if (_e1861 >= _e1862) {
                            if (_e1861 >= _e1863) {
                                phi_2687_ = false;
                            } else {
                                phi_2687_ = true;
                            }
                            let _e1867 = phi_2687_;
                            phi_2688_ = _e1867;
                        } else {
                            phi_2688_ = true;
                        }
                        let _e1869 = phi_2688_;
                        if _e1869 {
                            if (_e1862 >= _e1863) {
                                phi_2696_ = 1u;
                            } else {
                                phi_2696_ = 2u;
                            }
                            let _e1872 = phi_2696_;
                            phi_2697_ = _e1872;
                        } else {
                            phi_2697_ = 0u;
                        }
                        let _e1874 = phi_2697_;
                        if (_e1874 == 0u) {
                            phi_2709_ = vec3<f32>(_e166, _e167, _e165);
                        } else {
                            if (_e1874 == 1u) {
                                phi_2708_ = vec3<f32>(_e167, _e165, _e166);
                            } else {
                                phi_2708_ = _e168;
                            }
                            let _e1880 = phi_2708_;
                            phi_2709_ = _e1880;
                        }
                        let _e1882 = phi_2709_;
                        let _e1885 = (_e1882.x / _e1882.z);
                        let _e1888 = (_e1882.y / _e1882.z);
                        if (_e1799 < 0f) {
                            phi_2722_ = 0u;
                        } else {
                            phi_2722_ = 1u;
                        }
                        let _e1893 = phi_2722_;
                        if (_e1809 < 0f) {
                            phi_2727_ = 0u;
                        } else {
                            phi_2727_ = 2u;
                        }
                        let _e1896 = phi_2727_;
                        if (_e1819 < 0f) {
                            phi_2732_ = 0u;
                        } else {
                            phi_2732_ = 4u;
                        }
                        let _e1899 = phi_2732_;
                        let _e1901 = ((_e1893 | _e1896) | _e1899);
                        let _e1902 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                        local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e1902.first[0], _e1902.first[1], _e1902.first[2], _e1902.first[3], _e1902.first[4], _e1902.first[5], _e1902.first[6], _e1902.first[7], _e1902.first[8], _e1902.first[9], _e1902.first[10], _e1902.first[11], _e1902.first[12], _e1902.first[13], _e1902.first[14], _e1902.first[15], _e1902.first[16], _e1902.first[17], _e1902.first[18], _e1902.first[19], _e1902.first[20], _e1902.first[21], _e1902.first[22], _e1902.first[23], _e1902.first[24], _e1902.first[25], _e1902.first[26], _e1902.first[27], _e1902.first[28], _e1902.first[29], _e1902.first[30], _e1902.first[31]), array<u32, 32>(_e1902.mask[0], _e1902.mask[1], _e1902.mask[2], _e1902.mask[3], _e1902.mask[4], _e1902.mask[5], _e1902.mask[6], _e1902.mask[7], _e1902.mask[8], _e1902.mask[9], _e1902.mask[10], _e1902.mask[11], _e1902.mask[12], _e1902.mask[13], _e1902.mask[14], _e1902.mask[15], _e1902.mask[16], _e1902.mask[17], _e1902.mask[18], _e1902.mask[19], _e1902.mask[20], _e1902.mask[21], _e1902.mask[22], _e1902.mask[23], _e1902.mask[24], _e1902.mask[25], _e1902.mask[26], _e1902.mask[27], _e1902.mask[28], _e1902.mask[29], _e1902.mask[30], _e1902.mask[31]), _e1902.len, _e1902.group, _e1902.group_mask);
                        let _e1976 = local_1.group_mask;
                        if ((_e1976 & 4278190080u) == 0u) {
                            let _e1980 = local_1.len;
                            if (_e1980 == 0u) {
                                phi_2846_ = false;
                            } else {
                                let _e1984 = local_1.len;
                                local_1.len = (_e1984 - 1u);
                                let _e1987 = local_1.len;
                                if (_e1987 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1992 = local_1.first[(0u + _e1987)];
                                local_1.group = _e1992;
                                let _e1995 = local_1.len;
                                if (_e1995 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2000 = local_1.mask[(0u + _e1995)];
                                local_1.group_mask = _e2000;
                                phi_2846_ = true;
                            }
                            let _e2003 = phi_2846_;
                            phi_2847_ = _e2003;
                        } else {
                            phi_2847_ = true;
                        }
                        let _e2005 = phi_2847_;
                        if _e2005 {
                            let _e2007 = local_1.group_mask;
                            let _e2013 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2007)), 32u, (_e2007 == 0u)));
                            let _e2017 = local_1.group_mask;
                            let _e2031 = local_1.group_mask;
                            local_1.group_mask = (_e2031 & ~((1u << bitcast<u32>((_e2013 & 31u)))));
                            let _e2034 = local_1.group;
                            phi_2878_ = (_e2034 + countOneBits(((_e2017 & ~((4294967295u << bitcast<u32>((((_e2013 - 24u) ^ 7u) & 31u))))) & 255u)));
                        } else {
                            phi_2878_ = 4294967295u;
                        }
                        let _e2037 = phi_2878_;
                        phi_2880_ = _e2037;
                        phi_2883_ = false;
                        loop {
                            let _e2039 = phi_2880_;
                            let _e2041 = phi_2883_;
                            local_25 = _e2041;
                            if (_e2039 != 4294967295u) {
                                if (_e2039 < _e89) {
                                } else {
                                    return;
                                }
                                let _e2048 = nodes.member[(0u + _e2039)].frame[3u];
                                let _e2073 = (bitcast<f32>((((_e2048 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1799);
                                let _e2074 = (bitcast<f32>((((_e2048 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1809);
                                let _e2075 = (bitcast<f32>((((_e2048 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1819);
                                let _e2078 = nodes.member[(0u + _e2039)].frame[0u];
                                let _e2082 = nodes.member[(0u + _e2039)].frame[1u];
                                let _e2086 = nodes.member[(0u + _e2039)].frame[2u];
                                let _e2091 = ((bitcast<f32>(_e2078) - _e145) * _e1799);
                                let _e2092 = ((bitcast<f32>(_e2082) - _e147) * _e1809);
                                let _e2093 = ((bitcast<f32>(_e2086) - _e149) * _e1819);
                                let _e2101 = nodes.member[(0u + _e2039)].x;
                                if (_e1799 < 0f) {
                                    let _e2112 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2101.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2118 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2112.unnamed.word, _e2101.w), _e2112.unnamed_1);
                                    let _e2124 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2118.unnamed, lt_mask_LightPlace(_e2101.x, _e2118.unnamed_1.shift));
                                    phi_2963_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2124.unnamed, lt_mask_LightPlace(_e2124.unnamed_1.word, _e2101.y));
                                } else {
                                    let _e2140 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2101.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2146 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2140.unnamed.word, _e2101.y), _e2140.unnamed_1);
                                    let _e2152 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2146.unnamed, lt_mask_LightPlace(_e2101.z, _e2146.unnamed_1.shift));
                                    phi_2963_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2152.unnamed, lt_mask_LightPlace(_e2152.unnamed_1.word, _e2101.w));
                                }
                                let _e2160 = phi_2963_;
                                let _e2170 = nodes.member[(0u + _e2039)].y;
                                if (_e1809 < 0f) {
                                    let _e2181 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2170.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2187 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2181.unnamed.word, _e2170.w), _e2181.unnamed_1);
                                    let _e2193 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2187.unnamed, lt_mask_LightPlace(_e2170.x, _e2187.unnamed_1.shift));
                                    phi_2990_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2193.unnamed, lt_mask_LightPlace(_e2193.unnamed_1.word, _e2170.y));
                                } else {
                                    let _e2209 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2170.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2215 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2209.unnamed.word, _e2170.y), _e2209.unnamed_1);
                                    let _e2221 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2215.unnamed, lt_mask_LightPlace(_e2170.z, _e2215.unnamed_1.shift));
                                    phi_2990_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2221.unnamed, lt_mask_LightPlace(_e2221.unnamed_1.word, _e2170.w));
                                }
                                let _e2229 = phi_2990_;
                                let _e2239 = nodes.member[(0u + _e2039)].z;
                                if (_e1819 < 0f) {
                                    let _e2250 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2239.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2256 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2250.unnamed.word, _e2239.w), _e2250.unnamed_1);
                                    let _e2262 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2256.unnamed, lt_mask_LightPlace(_e2239.x, _e2256.unnamed_1.shift));
                                    phi_3017_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2262.unnamed, lt_mask_LightPlace(_e2262.unnamed_1.word, _e2239.y));
                                } else {
                                    let _e2278 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2239.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2284 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2278.unnamed.word, _e2239.y), _e2278.unnamed_1);
                                    let _e2290 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2284.unnamed, lt_mask_LightPlace(_e2239.z, _e2284.unnamed_1.shift));
                                    phi_3017_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2290.unnamed, lt_mask_LightPlace(_e2290.unnamed_1.word, _e2239.w));
                                }
                                let _e2298 = phi_3017_;
                                phi_3023_ = 0u;
                                phi_3026_ = 0u;
                                loop {
                                    let _e2308 = phi_3023_;
                                    let _e2310 = phi_3026_;
                                    local_8 = _e2310;
                                    local_9 = _e2310;
                                    local_10 = _e2310;
                                    let _e2311 = (_e2308 < 8u);
                                    if _e2311 {
                                        let _e2313 = (_e2308 >> bitcast<u32>(2i));
                                        let _e2314 = (_e2308 & 3u);
                                        if (_e2313 == 0u) {
                                            phi_3040_ = _e2160.unnamed.word;
                                        } else {
                                            phi_3040_ = _e2160.unnamed.shift;
                                        }
                                        let _e2317 = phi_3040_;
                                        if (_e2313 == 0u) {
                                            phi_3050_ = _e2229.unnamed.word;
                                        } else {
                                            phi_3050_ = _e2229.unnamed.shift;
                                        }
                                        let _e2326 = phi_3050_;
                                        if (_e2313 == 0u) {
                                            phi_3060_ = _e2298.unnamed.word;
                                        } else {
                                            phi_3060_ = _e2298.unnamed.shift;
                                        }
                                        let _e2335 = phi_3060_;
                                        let _e2348 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e2317 >> bitcast<u32>(((_e2314 * 8u) & 31u))) & 255u)) * _e2073) + (_e2091 - _e1851)), ((f32(((_e2326 >> bitcast<u32>(((_e2314 * 8u) & 31u))) & 255u)) * _e2074) + (_e2092 - _e1852)));
                                        let _e2349 = core_intrinsics_maximum_number_nsz_f32_(_e2348, ((f32(((_e2335 >> bitcast<u32>(((_e2314 * 8u) & 31u))) & 255u)) * _e2075) + (_e2093 - _e1853)));
                                        if (_e2313 == 0u) {
                                            phi_3078_ = _e2160.unnamed_1.word;
                                        } else {
                                            phi_3078_ = _e2160.unnamed_1.shift;
                                        }
                                        let _e2352 = phi_3078_;
                                        if (_e2313 == 0u) {
                                            phi_3088_ = _e2229.unnamed_1.word;
                                        } else {
                                            phi_3088_ = _e2229.unnamed_1.shift;
                                        }
                                        let _e2361 = phi_3088_;
                                        if (_e2313 == 0u) {
                                            phi_3098_ = _e2298.unnamed_1.word;
                                        } else {
                                            phi_3098_ = _e2298.unnamed_1.shift;
                                        }
                                        let _e2370 = phi_3098_;
                                        let _e2383 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e2352 >> bitcast<u32>(((_e2314 * 8u) & 31u))) & 255u)) * _e2073) + (_e2091 + _e1851)), ((f32(((_e2361 >> bitcast<u32>(((_e2314 * 8u) & 31u))) & 255u)) * _e2074) + (_e2092 + _e1852)));
                                        let _e2384 = core_intrinsics_minimum_number_nsz_f32_(_e2383, ((f32(((_e2370 >> bitcast<u32>(((_e2314 * 8u) & 31u))) & 255u)) * _e2075) + (_e2093 + _e1853)));
                                        if (_e2349 <= _e2384) {
                                            if (_e2349 <= _e157) {
                                                if (_e2384 >= 0f) {
                                                    if (_e2313 == 0u) {
                                                        let _e2391 = nodes.member[(0u + _e2039)].links[2u];
                                                        phi_3134_ = _e2391;
                                                    } else {
                                                        let _e2394 = nodes.member[(0u + _e2039)].links[3u];
                                                        phi_3134_ = _e2394;
                                                    }
                                                    let _e2396 = phi_3134_;
                                                    let _e2401 = ((_e2396 >> bitcast<u32>(((_e2314 * 8u) & 31u))) & 255u);
                                                    let _e2402 = (_e2401 & 31u);
                                                    if (_e2402 >= 24u) {
                                                        phi_3147_ = (24u + ((_e2402 - 24u) ^ _e1901));
                                                    } else {
                                                        phi_3147_ = _e2402;
                                                    }
                                                    let _e2408 = phi_3147_;
                                                    phi_3152_ = (_e2310 | ((_e2401 >> bitcast<u32>(5i)) << bitcast<u32>((_e2408 & 31u))));
                                                } else {
                                                    phi_3152_ = _e2310;
                                                }
                                                let _e2416 = phi_3152_;
                                                phi_3153_ = _e2416;
                                            } else {
                                                phi_3153_ = _e2310;
                                            }
                                            let _e2418 = phi_3153_;
                                            phi_3154_ = _e2418;
                                        } else {
                                            phi_3154_ = _e2310;
                                        }
                                        let _e2420 = phi_3154_;
                                        phi_3024_ = (_e2308 + 1u);
                                        phi_3027_ = _e2420;
                                    } else {
                                        phi_3024_ = u32();
                                        phi_3027_ = u32();
                                    }
                                    let _e2423 = phi_3024_;
                                    let _e2425 = phi_3027_;
                                    continue;
                                    continuing {
                                        phi_3023_ = _e2423;
                                        phi_3026_ = _e2425;
                                        break if !(_e2311);
                                    }
                                }
                                let _e2429 = nodes.member[(0u + _e2039)].links[0u];
                                let _e2433 = nodes.member[(0u + _e2039)].frame[3u];
                                let _e2437 = local_8;
                                if ((_e2437 & 4278190080u) == 0u) {
                                } else {
                                    let _e2441 = local_1.group_mask;
                                    if ((_e2441 & 4278190080u) == 0u) {
                                    } else {
                                        let _e2445 = local_1.len;
                                        if (_e2445 < 32u) {
                                            let _e2448 = local_1.group;
                                            let _e2450 = local_1.len;
                                            if (_e2450 < 32u) {
                                            } else {
                                                return;
                                            }
                                            local_1.first[(0u + _e2450)] = _e2448;
                                            let _e2456 = local_1.group_mask;
                                            let _e2458 = local_1.len;
                                            if (_e2458 < 32u) {
                                            } else {
                                                return;
                                            }
                                            local_1.mask[(0u + _e2458)] = _e2456;
                                            let _e2465 = local_1.len;
                                            local_1.len = (_e2465 + 1u);
                                        }
                                    }
                                    local_1.group = (0u + _e2429);
                                    let _e2469 = local_9;
                                    local_1.group_mask = ((_e2469 & 4278190080u) | (_e2433 >> bitcast<u32>(24i)));
                                }
                                let _e2474 = local_10;
                                phi_3212_ = (_e2474 & 16777215u);
                                phi_3215_ = _e2041;
                                loop {
                                    let _e2477 = phi_3212_;
                                    let _e2479 = phi_3215_;
                                    local_21 = _e2479;
                                    let _e2480 = (_e2477 == 0u);
                                    local_11 = _e2480;
                                    local_23 = _e2480;
                                    if _e2480 {
                                        phi_3213_ = u32();
                                        phi_3216_ = bool();
                                        phi_4019_ = bool();
                                        phi_4020_ = false;
                                    } else {
                                        let _e2483 = nodes.member[(0u + _e2039)].links[1u];
                                        let _e2488 = ((0u + _e2483) + select(firstTrailingBit(_e2477), 32u, (_e2477 == 0u)));
                                        if (_e2488 < _e92) {
                                        } else {
                                            return;
                                        }
                                        let _e2495 = triangles.member[(0u + _e2488)].v0_;
                                        let _e2497 = (_e2495.x - _e145);
                                        let _e2499 = (_e2495.y - _e147);
                                        let _e2501 = (_e2495.z - _e149);
                                        if (_e1874 == 0u) {
                                            phi_3260_ = vec3<f32>(_e2499, _e2501, _e2497);
                                        } else {
                                            if (_e1874 == 1u) {
                                                phi_3259_ = vec3<f32>(_e2501, _e2497, _e2499);
                                            } else {
                                                phi_3259_ = (_e2495 - vec3<f32>(_e145, _e147, _e149));
                                            }
                                            let _e2509 = phi_3259_;
                                            phi_3260_ = _e2509;
                                        }
                                        let _e2511 = phi_3260_;
                                        let _e2515 = (_e2511.x - (_e1885 * _e2511.z));
                                        let _e2519 = (_e2511.y - (_e1888 * _e2511.z));
                                        let _e2521 = triangles.member[(0u + _e2488)].v1_;
                                        let _e2523 = (_e2521.x - _e145);
                                        let _e2525 = (_e2521.y - _e147);
                                        let _e2527 = (_e2521.z - _e149);
                                        if (_e1874 == 0u) {
                                            phi_3290_ = vec3<f32>(_e2525, _e2527, _e2523);
                                        } else {
                                            if (_e1874 == 1u) {
                                                phi_3289_ = vec3<f32>(_e2527, _e2523, _e2525);
                                            } else {
                                                phi_3289_ = (_e2521 - vec3<f32>(_e145, _e147, _e149));
                                            }
                                            let _e2535 = phi_3289_;
                                            phi_3290_ = _e2535;
                                        }
                                        let _e2537 = phi_3290_;
                                        let _e2541 = (_e2537.x - (_e1885 * _e2537.z));
                                        let _e2545 = (_e2537.y - (_e1888 * _e2537.z));
                                        let _e2547 = triangles.member[(0u + _e2488)].v2_;
                                        let _e2549 = (_e2547.x - _e145);
                                        let _e2551 = (_e2547.y - _e147);
                                        let _e2553 = (_e2547.z - _e149);
                                        if (_e1874 == 0u) {
                                            phi_3320_ = vec3<f32>(_e2551, _e2553, _e2549);
                                        } else {
                                            if (_e1874 == 1u) {
                                                phi_3319_ = vec3<f32>(_e2553, _e2549, _e2551);
                                            } else {
                                                phi_3319_ = (_e2547 - vec3<f32>(_e145, _e147, _e149));
                                            }
                                            let _e2561 = phi_3319_;
                                            phi_3320_ = _e2561;
                                        }
                                        let _e2563 = phi_3320_;
                                        let _e2567 = (_e2563.x - (_e1885 * _e2563.z));
                                        let _e2571 = (_e2563.y - (_e1888 * _e2563.z));
                                        if (_e2541 < _e2567) {
                                            phi_3339_ = true;
                                        } else {
                                            if (_e2541 == _e2567) {
                                                phi_3338_ = (_e2545 < _e2571);
                                            } else {
                                                phi_3338_ = false;
                                            }
                                            let _e2576 = phi_3338_;
                                            phi_3339_ = _e2576;
                                        }
                                        let _e2578 = phi_3339_;
                                        if _e2578 {
                                            phi_3343_ = _e2571;
                                            phi_3344_ = _e2567;
                                            phi_3345_ = _e2545;
                                            phi_3346_ = _e2541;
                                        } else {
                                            phi_3343_ = _e2545;
                                            phi_3344_ = _e2541;
                                            phi_3345_ = _e2571;
                                            phi_3346_ = _e2567;
                                        }
                                        let _e2580 = phi_3343_;
                                        let _e2582 = phi_3344_;
                                        let _e2584 = phi_3345_;
                                        let _e2586 = phi_3346_;
                                        let _e2589 = ((_e2586 * _e2580) - (_e2584 * _e2582));
                                        if _e2578 {
                                            phi_3354_ = -(_e2589);
                                        } else {
                                            phi_3354_ = _e2589;
                                        }
                                        let _e2592 = phi_3354_;
                                        if (_e2567 < _e2515) {
                                            phi_3365_ = true;
                                        } else {
                                            if (_e2567 == _e2515) {
                                                phi_3364_ = (_e2571 < _e2519);
                                            } else {
                                                phi_3364_ = false;
                                            }
                                            let _e2597 = phi_3364_;
                                            phi_3365_ = _e2597;
                                        }
                                        let _e2599 = phi_3365_;
                                        if _e2599 {
                                            phi_3369_ = _e2519;
                                            phi_3370_ = _e2515;
                                            phi_3371_ = _e2571;
                                            phi_3372_ = _e2567;
                                        } else {
                                            phi_3369_ = _e2571;
                                            phi_3370_ = _e2567;
                                            phi_3371_ = _e2519;
                                            phi_3372_ = _e2515;
                                        }
                                        let _e2601 = phi_3369_;
                                        let _e2603 = phi_3370_;
                                        let _e2605 = phi_3371_;
                                        let _e2607 = phi_3372_;
                                        let _e2610 = ((_e2607 * _e2601) - (_e2605 * _e2603));
                                        if _e2599 {
                                            phi_3380_ = -(_e2610);
                                        } else {
                                            phi_3380_ = _e2610;
                                        }
                                        let _e2613 = phi_3380_;
                                        if (_e2515 < _e2541) {
                                            phi_3391_ = true;
                                        } else {
                                            if (_e2515 == _e2541) {
                                                phi_3390_ = (_e2519 < _e2545);
                                            } else {
                                                phi_3390_ = false;
                                            }
                                            let _e2618 = phi_3390_;
                                            phi_3391_ = _e2618;
                                        }
                                        let _e2620 = phi_3391_;
                                        if _e2620 {
                                            phi_3395_ = _e2545;
                                            phi_3396_ = _e2541;
                                            phi_3397_ = _e2519;
                                            phi_3398_ = _e2515;
                                        } else {
                                            phi_3395_ = _e2519;
                                            phi_3396_ = _e2515;
                                            phi_3397_ = _e2545;
                                            phi_3398_ = _e2541;
                                        }
                                        let _e2622 = phi_3395_;
                                        let _e2624 = phi_3396_;
                                        let _e2626 = phi_3397_;
                                        let _e2628 = phi_3398_;
                                        let _e2631 = ((_e2628 * _e2622) - (_e2626 * _e2624));
                                        if _e2620 {
                                            phi_3406_ = -(_e2631);
                                        } else {
                                            phi_3406_ = _e2631;
                                        }
                                        let _e2634 = phi_3406_;
                                        if (_e2592 >= 0f) {
                                            if (_e2613 >= 0f) {
                                                if (_e2634 >= 0f) {
                                                    phi_3421_ = ((_e2592 + _e2613) + _e2634);
                                                    phi_3422_ = false;
                                                } else {
                                                    phi_3421_ = f32();
                                                    phi_3422_ = true;
                                                }
                                                let _e2641 = phi_3421_;
                                                let _e2643 = phi_3422_;
                                                phi_3423_ = _e2641;
                                                phi_3424_ = _e2643;
                                            } else {
                                                phi_3423_ = f32();
                                                phi_3424_ = true;
                                            }
                                            let _e2645 = phi_3423_;
                                            let _e2647 = phi_3424_;
                                            phi_3425_ = _e2645;
                                            phi_3426_ = _e2647;
                                        } else {
                                            phi_3425_ = f32();
                                            phi_3426_ = true;
                                        }
                                        let _e2649 = phi_3425_;
                                        let _e2651 = phi_3426_;
                                        if _e2651 {
                                            if (_e2592 <= 0f) {
                                                if (_e2613 <= 0f) {
                                                    let _e2654 = (_e2634 <= 0f);
                                                    if _e2654 {
                                                    }
                                                    phi_3444_ = ((_e2592 + _e2613) + _e2634);
                                                    phi_3445_ = false;
                                                    phi_3446_ = _e2654;
                                                } else {
                                                    phi_3444_ = f32();
                                                    phi_3445_ = true;
                                                    phi_3446_ = false;
                                                }
                                                let _e2658 = phi_3444_;
                                                let _e2660 = phi_3445_;
                                                let _e2662 = phi_3446_;
                                                phi_3447_ = _e2658;
                                                phi_3448_ = _e2660;
                                                phi_3449_ = _e2662;
                                            } else {
                                                phi_3447_ = f32();
                                                phi_3448_ = true;
                                                phi_3449_ = false;
                                            }
                                            let _e2664 = phi_3447_;
                                            let _e2666 = phi_3448_;
                                            let _e2668 = phi_3449_;
                                            if _e2666 {
                                                phi_3453_ = false;
                                            } else {
                                                phi_3453_ = _e2668;
                                            }
                                            let _e2670 = phi_3453_;
                                            phi_3454_ = _e2664;
                                            phi_3455_ = _e2670;
                                        } else {
                                            phi_3454_ = _e2649;
                                            phi_3455_ = true;
                                        }
                                        let _e2672 = phi_3454_;
                                        let _e2674 = phi_3455_;
                                        if _e2674 {
                                            let _e2675 = (_e2672 == 0f);
                                            if _e2675 {
                                                phi_3771_ = lt_bvh_triangle_Intersection();
                                                phi_3772_ = false;
                                            } else {
                                                let _e2677 = triangles.member[(0u + _e2488)].v0_;
                                                let _e2679 = (_e2677.x - _e145);
                                                let _e2681 = (_e2677.y - _e147);
                                                let _e2683 = (_e2677.z - _e149);
                                                if (_e1874 == 0u) {
                                                    phi_3484_ = vec3<f32>(_e2681, _e2683, _e2679);
                                                } else {
                                                    if (_e1874 == 1u) {
                                                        phi_3483_ = vec3<f32>(_e2683, _e2679, _e2681);
                                                    } else {
                                                        phi_3483_ = (_e2677 - vec3<f32>(_e145, _e147, _e149));
                                                    }
                                                    let _e2691 = phi_3483_;
                                                    phi_3484_ = _e2691;
                                                }
                                                let _e2693 = phi_3484_;
                                                let _e2695 = triangles.member[(0u + _e2488)].v1_;
                                                let _e2697 = triangles.member[(0u + _e2488)].v0_;
                                                let _e2700 = (_e2695.x - _e2697.x);
                                                let _e2703 = (_e2695.y - _e2697.y);
                                                let _e2706 = (_e2695.z - _e2697.z);
                                                if (_e1874 == 0u) {
                                                    phi_3510_ = vec3<f32>(_e2703, _e2706, _e2700);
                                                } else {
                                                    if (_e1874 == 1u) {
                                                        phi_3509_ = vec3<f32>(_e2706, _e2700, _e2703);
                                                    } else {
                                                        phi_3509_ = (_e2695 - _e2697);
                                                    }
                                                    let _e2713 = phi_3509_;
                                                    phi_3510_ = _e2713;
                                                }
                                                let _e2715 = phi_3510_;
                                                let _e2717 = triangles.member[(0u + _e2488)].v2_;
                                                let _e2719 = triangles.member[(0u + _e2488)].v0_;
                                                let _e2722 = (_e2717.x - _e2719.x);
                                                let _e2725 = (_e2717.y - _e2719.y);
                                                let _e2728 = (_e2717.z - _e2719.z);
                                                if (_e1874 == 0u) {
                                                    phi_3536_ = vec3<f32>(_e2725, _e2728, _e2722);
                                                } else {
                                                    if (_e1874 == 1u) {
                                                        phi_3535_ = vec3<f32>(_e2728, _e2722, _e2725);
                                                    } else {
                                                        phi_3535_ = (_e2717 - _e2719);
                                                    }
                                                    let _e2735 = phi_3535_;
                                                    phi_3536_ = _e2735;
                                                }
                                                let _e2737 = phi_3536_;
                                                let _e2744 = ((_e2715.y * _e2737.z) - (_e2715.z * _e2737.y));
                                                let _e2751 = ((_e2715.z * _e2737.x) - (_e2715.x * _e2737.z));
                                                let _e2758 = ((_e2715.x * _e2737.y) - (_e2715.y * _e2737.x));
                                                let _e2772 = (((1f / _e1882.z) * (((_e2744 * _e2693.x) + (_e2751 * _e2693.y)) + (_e2758 * _e2693.z))) / (((_e2744 * _e1885) + (_e2751 * _e1888)) + _e2758));
                                                if (_e2772 > 0f) {
                                                    if (_e2772 < _e157) {
                                                        let _e2776 = triangles.member[(0u + _e2488)].v0_;
                                                        let _e2778 = triangles.member[(0u + _e2488)].v1_;
                                                        if (_e2776.x < _e2778.x) {
                                                            phi_3592_ = _e2776.x;
                                                        } else {
                                                            phi_3592_ = _e2778.x;
                                                        }
                                                        let _e2785 = phi_3592_;
                                                        if (_e2776.y < _e2778.y) {
                                                            phi_3601_ = _e2776.y;
                                                        } else {
                                                            phi_3601_ = _e2778.y;
                                                        }
                                                        let _e2792 = phi_3601_;
                                                        if (_e2776.z < _e2778.z) {
                                                            phi_3610_ = _e2776.z;
                                                        } else {
                                                            phi_3610_ = _e2778.z;
                                                        }
                                                        let _e2799 = phi_3610_;
                                                        let _e2801 = triangles.member[(0u + _e2488)].v2_;
                                                        if (_e2785 < _e2801.x) {
                                                            phi_3619_ = _e2785;
                                                        } else {
                                                            phi_3619_ = _e2801.x;
                                                        }
                                                        let _e2806 = phi_3619_;
                                                        if (_e2792 < _e2801.y) {
                                                            phi_3626_ = _e2792;
                                                        } else {
                                                            phi_3626_ = _e2801.y;
                                                        }
                                                        let _e2811 = phi_3626_;
                                                        if (_e2799 < _e2801.z) {
                                                            phi_3633_ = _e2799;
                                                        } else {
                                                            phi_3633_ = _e2801.z;
                                                        }
                                                        let _e2816 = phi_3633_;
                                                        let _e2818 = triangles.member[(0u + _e2488)].v0_;
                                                        let _e2820 = triangles.member[(0u + _e2488)].v1_;
                                                        if (_e2818.x > _e2820.x) {
                                                            phi_3646_ = _e2818.x;
                                                        } else {
                                                            phi_3646_ = _e2820.x;
                                                        }
                                                        let _e2827 = phi_3646_;
                                                        if (_e2818.y > _e2820.y) {
                                                            phi_3655_ = _e2818.y;
                                                        } else {
                                                            phi_3655_ = _e2820.y;
                                                        }
                                                        let _e2834 = phi_3655_;
                                                        if (_e2818.z > _e2820.z) {
                                                            phi_3664_ = _e2818.z;
                                                        } else {
                                                            phi_3664_ = _e2820.z;
                                                        }
                                                        let _e2841 = phi_3664_;
                                                        let _e2843 = triangles.member[(0u + _e2488)].v2_;
                                                        if (_e2827 > _e2843.x) {
                                                            phi_3673_ = _e2827;
                                                        } else {
                                                            phi_3673_ = _e2843.x;
                                                        }
                                                        let _e2848 = phi_3673_;
                                                        if (_e2834 > _e2843.y) {
                                                            phi_3680_ = _e2834;
                                                        } else {
                                                            phi_3680_ = _e2843.y;
                                                        }
                                                        let _e2853 = phi_3680_;
                                                        if (_e2841 > _e2843.z) {
                                                            phi_3687_ = _e2841;
                                                        } else {
                                                            phi_3687_ = _e2843.z;
                                                        }
                                                        let _e2858 = phi_3687_;
                                                        let _e2862 = ((_e2806 - _e145) * _e1799);
                                                        let _e2863 = ((_e2811 - _e147) * _e1809);
                                                        let _e2864 = ((_e2816 - _e149) * _e1819);
                                                        let _e2868 = ((_e2848 - _e145) * _e1799);
                                                        let _e2869 = ((_e2853 - _e147) * _e1809);
                                                        let _e2870 = ((_e2858 - _e149) * _e1819);
                                                        if (_e2862 < _e2868) {
                                                            phi_3704_ = _e2862;
                                                        } else {
                                                            phi_3704_ = _e2868;
                                                        }
                                                        let _e2873 = phi_3704_;
                                                        if (_e2863 < _e2869) {
                                                            phi_3709_ = _e2863;
                                                        } else {
                                                            phi_3709_ = _e2869;
                                                        }
                                                        let _e2876 = phi_3709_;
                                                        if (_e2864 < _e2870) {
                                                            phi_3714_ = _e2864;
                                                        } else {
                                                            phi_3714_ = _e2870;
                                                        }
                                                        let _e2879 = phi_3714_;
                                                        if (_e2862 > _e2868) {
                                                            phi_3722_ = _e2862;
                                                        } else {
                                                            phi_3722_ = _e2868;
                                                        }
                                                        let _e2885 = phi_3722_;
                                                        if (_e2863 > _e2869) {
                                                            phi_3727_ = _e2863;
                                                        } else {
                                                            phi_3727_ = _e2869;
                                                        }
                                                        let _e2888 = phi_3727_;
                                                        if (_e2864 > _e2870) {
                                                            phi_3732_ = _e2864;
                                                        } else {
                                                            phi_3732_ = _e2870;
                                                        }
                                                        let _e2891 = phi_3732_;
                                                        let _e2895 = core_intrinsics_maximum_number_nsz_f32_((_e2873 - _e1858), (_e2876 - _e1859));
                                                        let _e2896 = core_intrinsics_maximum_number_nsz_f32_(_e2895, (_e2879 - _e1860));
                                                        let _e2897 = core_intrinsics_minimum_number_nsz_f32_((_e2885 + _e1858), (_e2888 + _e1859));
                                                        let _e2898 = core_intrinsics_minimum_number_nsz_f32_(_e2897, (_e2891 + _e1860));
                                                        if (_e2896 > -300000000000000000000000000000000000000f) {
                                                            phi_3744_ = _e2896;
                                                        } else {
                                                            phi_3744_ = -300000000000000000000000000000000000000f;
                                                        }
                                                        let _e2901 = phi_3744_;
                                                        if (_e2898 < 300000000000000000000000000000000000000f) {
                                                            phi_3749_ = _e2898;
                                                        } else {
                                                            phi_3749_ = 300000000000000000000000000000000000000f;
                                                        }
                                                        let _e2904 = phi_3749_;
                                                        if (_e2772 < _e2901) {
                                                            phi_3754_ = _e2901;
                                                        } else {
                                                            phi_3754_ = _e2772;
                                                        }
                                                        let _e2907 = phi_3754_;
                                                        if (_e2907 > _e2904) {
                                                            phi_3759_ = _e2904;
                                                        } else {
                                                            phi_3759_ = _e2907;
                                                        }
                                                        let _e2910 = phi_3759_;
                                                        phi_3764_ = lt_bvh_triangle_Intersection(_e2910, (_e2613 / _e2672), (_e2634 / _e2672), (_e2901 <= _e2904));
                                                        phi_3765_ = false;
                                                    } else {
                                                        phi_3764_ = lt_bvh_triangle_Intersection();
                                                        phi_3765_ = true;
                                                    }
                                                    let _e2916 = phi_3764_;
                                                    let _e2918 = phi_3765_;
                                                    phi_3766_ = _e2916;
                                                    phi_3767_ = _e2918;
                                                } else {
                                                    phi_3766_ = lt_bvh_triangle_Intersection();
                                                    phi_3767_ = true;
                                                }
                                                let _e2920 = phi_3766_;
                                                let _e2922 = phi_3767_;
                                                if _e2922 {
                                                }
                                                phi_3771_ = _e2920;
                                                phi_3772_ = _e2922;
                                            }
                                            let _e2924 = phi_3771_;
                                            let _e2926 = phi_3772_;
                                            phi_3773_ = _e2924;
                                            phi_3774_ = _e2675;
                                            phi_3775_ = _e2926;
                                        } else {
                                            phi_3773_ = lt_bvh_triangle_Intersection();
                                            phi_3774_ = true;
                                            phi_3775_ = false;
                                        }
                                        let _e2928 = phi_3773_;
                                        let _e2930 = phi_3774_;
                                        let _e2932 = phi_3775_;
                                        if _e2930 {
                                            phi_3779_ = true;
                                        } else {
                                            phi_3779_ = _e2932;
                                        }
                                        let _e2934 = phi_3779_;
                                        if _e2934 {
                                            phi_3783_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                        } else {
                                            phi_3783_ = _e2928;
                                        }
                                        let _e2936 = phi_3783_;
                                        if _e2936.is_hit {
                                            if (_e2936.t > 0f) {
                                                if (_e2936.t < _e157) {
                                                    let _e2943 = triangles.member[(0u + _e2488)].i0_;
                                                    if ((_e2943 & 2147483648u) == 0u) {
                                                        phi_4002_ = true;
                                                    } else {
                                                        if (_e2488 < _e92) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e2952 = triangles.member[(0u + _e2488)].i0_;
                                                        let _e2953 = (_e2952 & 2147483647u);
                                                        let _e2955 = triangles.member[(0u + _e2488)].i1_;
                                                        let _e2957 = triangles.member[(0u + _e2488)].i2_;
                                                        if (_e2953 < _e105) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e2961 = vertices.member[(0u + _e2953)];
                                                        if (_e2955 < _e105) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e2965 = vertices.member[(0u + _e2955)];
                                                        if (_e2957 < _e105) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e2969 = vertices.member[(0u + _e2957)];
                                                        let _e2970 = array<abi_Vertex, 3>(_e2961, _e2965, _e2969);
                                                        if (_e2970[0].material < _e108) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e2976 = materials.member[(0u + _e2970[0].material)];
                                                        if ((_e2976.flags & 1u) == 1u) {
                                                            let _e2981 = ((1f - _e2936.u) - _e2936.v);
                                                            if (_e2976.cutoff <= 0f) {
                                                                phi_4000_ = true;
                                                            } else {
                                                                let _e3008 = (_e2976.base_color.w * ((((f32((_e2970[0].color >> bitcast<u32>(24i))) * _e2981) + (f32((_e2970[1].color >> bitcast<u32>(24i))) * _e2936.u)) + (f32((_e2970[2].color >> bitcast<u32>(24i))) * _e2936.v)) * (1f / 255f)));
                                                                if (_e2976.alpha_size == 0u) {
                                                                    phi_3997_ = _e3008;
                                                                } else {
                                                                    local.offset = _e2976.alpha_offset;
                                                                    local.size = _e2976.alpha_size;
                                                                    local.flags = _e2976.flags;
                                                                    let _e3039 = _lt_shaders_texture_TextureView_quad((&local), (((_e2970[0].u * _e2981) + (_e2970[1].u * _e2936.u)) + (_e2970[2].u * _e2936.v)), (((_e2970[0].v * _e2981) + (_e2970[1].v * _e2936.u)) + (_e2970[2].v * _e2936.v)));
                                                                    let _e3043 = (_e3039.indices[0] >> bitcast<u32>(2i));
                                                                    if (_e3043 < _e111) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e3047 = alpha_texels.member[(0u + _e3043)];
                                                                    let _e3063 = (_e3039.indices[1] >> bitcast<u32>(2i));
                                                                    if (_e3063 < _e111) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e3067 = alpha_texels.member[(0u + _e3063)];
                                                                    let _e3084 = (_e3039.indices[2] >> bitcast<u32>(2i));
                                                                    if (_e3084 < _e111) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e3088 = alpha_texels.member[(0u + _e3084)];
                                                                    let _e3105 = (_e3039.indices[3] >> bitcast<u32>(2i));
                                                                    if (_e3105 < _e111) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e3109 = alpha_texels.member[(0u + _e3105)];
                                                                    phi_3997_ = (_e3008 * (((((f32(((_e3047 >> bitcast<u32>((((_e3039.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e3039.weights.x) + ((f32(((_e3067 >> bitcast<u32>((((_e3039.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e3039.weights.y)) + ((f32(((_e3088 >> bitcast<u32>((((_e3039.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e3039.weights.z)) + ((f32(((_e3109 >> bitcast<u32>((((_e3039.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e3039.weights.w)));
                                                                }
                                                                let _e3125 = phi_3997_;
                                                                phi_4000_ = (_e3125 >= _e2976.cutoff);
                                                            }
                                                            let _e3129 = phi_4000_;
                                                            phi_4001_ = _e3129;
                                                        } else {
                                                            phi_4001_ = false;
                                                        }
                                                        let _e3131 = phi_4001_;
                                                        phi_4002_ = _e3131;
                                                    }
                                                    let _e3133 = phi_4002_;
                                                    if _e3133 {
                                                        phi_4006_ = false;
                                                    } else {
                                                        phi_4006_ = true;
                                                    }
                                                    let _e3135 = phi_4006_;
                                                    phi_4007_ = _e3133;
                                                    phi_4008_ = _e3133;
                                                    phi_4009_ = _e3135;
                                                } else {
                                                    phi_4007_ = bool();
                                                    phi_4008_ = _e2479;
                                                    phi_4009_ = true;
                                                }
                                                let _e3137 = phi_4007_;
                                                let _e3139 = phi_4008_;
                                                let _e3141 = phi_4009_;
                                                phi_4010_ = _e3137;
                                                phi_4011_ = _e3139;
                                                phi_4012_ = _e3141;
                                            } else {
                                                phi_4010_ = bool();
                                                phi_4011_ = _e2479;
                                                phi_4012_ = true;
                                            }
                                            let _e3143 = phi_4010_;
                                            let _e3145 = phi_4011_;
                                            let _e3147 = phi_4012_;
                                            phi_4013_ = _e3143;
                                            phi_4014_ = _e3145;
                                            phi_4015_ = _e3147;
                                        } else {
                                            phi_4013_ = bool();
                                            phi_4014_ = _e2479;
                                            phi_4015_ = true;
                                        }
                                        let _e3149 = phi_4013_;
                                        let _e3151 = phi_4014_;
                                        let _e3153 = phi_4015_;
                                        if _e3153 {
                                        }
                                        phi_3213_ = (_e2477 & (_e2477 - 1u));
                                        phi_3216_ = _e3151;
                                        phi_4019_ = _e3149;
                                        phi_4020_ = _e3153;
                                    }
                                    let _e3155 = phi_3213_;
                                    let _e3157 = phi_3216_;
                                    let _e3159 = phi_4019_;
                                    let _e3161 = phi_4020_;
                                    local_22 = _e3159;
                                    continue;
                                    continuing {
                                        phi_3212_ = _e3155;
                                        phi_3215_ = _e3157;
                                        break if !(_e3161);
                                    }
                                }
                                let _e3164 = local_11;
                                if _e3164 {
                                    let _e3166 = local_1.group_mask;
                                    if ((_e3166 & 4278190080u) == 0u) {
                                        let _e3170 = local_1.len;
                                        if (_e3170 == 0u) {
                                            phi_4062_ = false;
                                        } else {
                                            let _e3174 = local_1.len;
                                            local_1.len = (_e3174 - 1u);
                                            let _e3177 = local_1.len;
                                            if (_e3177 < 32u) {
                                            } else {
                                                return;
                                            }
                                            let _e3182 = local_1.first[(0u + _e3177)];
                                            local_1.group = _e3182;
                                            let _e3185 = local_1.len;
                                            if (_e3185 < 32u) {
                                            } else {
                                                return;
                                            }
                                            let _e3190 = local_1.mask[(0u + _e3185)];
                                            local_1.group_mask = _e3190;
                                            phi_4062_ = true;
                                        }
                                        let _e3193 = phi_4062_;
                                        phi_4063_ = _e3193;
                                    } else {
                                        phi_4063_ = true;
                                    }
                                    let _e3195 = phi_4063_;
                                    if _e3195 {
                                        let _e3197 = local_1.group_mask;
                                        let _e3203 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e3197)), 32u, (_e3197 == 0u)));
                                        let _e3207 = local_1.group_mask;
                                        let _e3221 = local_1.group_mask;
                                        local_1.group_mask = (_e3221 & ~((1u << bitcast<u32>((_e3203 & 31u)))));
                                        let _e3224 = local_1.group;
                                        phi_4094_ = (_e3224 + countOneBits(((_e3207 & ~((4294967295u << bitcast<u32>((((_e3203 - 24u) ^ _e1901) & 31u))))) & 255u)));
                                    } else {
                                        phi_4094_ = 4294967295u;
                                    }
                                    let _e3227 = phi_4094_;
                                    phi_4095_ = _e3227;
                                } else {
                                    phi_4095_ = u32();
                                }
                                let _e3229 = phi_4095_;
                                phi_2881_ = _e3229;
                                let _e3692 = local_21;
                                phi_2884_ = _e3692;
                                let _e3695 = local_22;
                                phi_4096_ = _e3695;
                                let _e3698 = local_23;
                                phi_4097_ = _e3698;
                                phi_4098_ = false;
                            } else {
                                phi_2881_ = u32();
                                phi_2884_ = bool();
                                phi_4096_ = bool();
                                phi_4097_ = false;
                                phi_4098_ = true;
                            }
                            let _e3231 = phi_2881_;
                            let _e3233 = phi_2884_;
                            let _e3235 = phi_4096_;
                            let _e3237 = phi_4097_;
                            let _e3239 = phi_4098_;
                            local_12 = _e3239;
                            local_24 = _e3235;
                            continue;
                            continuing {
                                phi_2880_ = _e3231;
                                phi_2883_ = _e3233;
                                break if !(_e3237);
                            }
                        }
                        let _e3242 = local_12;
                        if _e3242 {
                            phi_4102_ = false;
                        } else {
                            phi_4102_ = true;
                        }
                        let _e3244 = phi_4102_;
                        if _e3244 {
                            let _e3704 = local_24;
                            phi_4106_ = _e3704;
                        } else {
                            let _e3706 = local_25;
                            phi_4106_ = _e3706;
                        }
                        let _e3246 = phi_4106_;
                        phi_4107_ = _e3246;
                    }
                    let _e3248 = phi_4107_;
                    phi_4108_ = _e3248;
                    phi_4109_ = _e1723;
                } else {
                    phi_4108_ = bool();
                    phi_4109_ = true;
                }
                let _e3250 = phi_4108_;
                let _e3252 = phi_4109_;
                if _e3252 {
                    phi_4113_ = false;
                } else {
                    phi_4113_ = _e3250;
                }
                let _e3254 = phi_4113_;
                phi_4114_ = _e3254;
            }
            let _e3256 = phi_4114_;
            phi_4115_ = _e3256;
        } else {
            phi_4115_ = false;
        }
        let _e3258 = phi_4115_;
        if _e3258 {
            phi_4119_ = 0f;
        } else {
            phi_4119_ = 1f;
        }
        let _e3260 = phi_4119_;
        if (_e124 < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e124)] = _e3260;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_list_light_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
